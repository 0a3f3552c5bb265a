"""Fitted releases as cells of a text table."""

from __future__ import annotations

from math import floor, log10
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.units import display_unit
from hoopgen.core.variables import STATE
from hoopgen.hoop.arguments import FLIGHT_ARGUMENTS
from hoopgen.hoop.variables import ARGUMENTS
from hoopgen.study.named_units import unit_in

if TYPE_CHECKING:
    from .fitted_releases import FittedReleases

_SHOWN = 10
"""Releases that are listed."""


def first_cells(found: FittedReleases) -> tuple[list[str], list[list[str]]]:
    """Return the headings and the rows of the first releases.

    Parameters
    ----------
    found
        The releases.
    """
    names = (*(FLIGHT_ARGUMENTS if found.scene.has_hoop else STATE[:6]), *found.fitted_spin)
    values = {**dict(zip(STATE, found.states.T, strict=True)), **found.variables}
    if found.backspin is not None:
        values["backspin"] = found.backspin
    heads, rows = ["track"], [[str(one)] for one in found.labels[:_SHOWN]]
    for name in names:
        unit = display_unit(ARGUMENTS[name].kind) if name in ARGUMENTS else None
        size = unit.size if unit else 1.0
        heads.append(f"{name} ({unit.symbol if unit else unit_in(name, found.scene)})")
        errors = found.standard_errors[name] / size
        digits = _decimals(errors)
        for row, value, error in zip(rows, values[name] / size, errors, strict=False):
            text = f"{value:.{digits}f} ± {error:.{digits}f}"
            row.append(text if value == value else "-")
    for row, reason in zip(rows, found.reason, strict=False):
        row.append(reason or "yes")
    return [*heads, "credible"], rows


def _decimals(errors: NDArray[np.float64]) -> int:
    """Return the decimals that show one or two digits of standard errors."""
    known = errors[np.isfinite(errors) & (errors > 0.0)]
    return int(np.clip(1 - floor(log10(np.median(known))), 2, 9)) if len(known) else 2
