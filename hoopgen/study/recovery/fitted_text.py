"""Fitted releases as cells of a text table."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import floor, log10
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.units import display_unit
from hoopgen.hoop.variables import ARGUMENTS
from hoopgen.simulation.engine import Engine
from hoopgen.study.named_units import unit_in

Floats = NDArray[np.float64]

SHOWN = 10
"""Releases that are listed."""


def first_cells(
    values: Mapping[str, Floats],
    errors: Mapping[str, Floats],
    labels: Sequence[Any] | NDArray[Any],
    reasons: Sequence[str],
    scene: Engine,
) -> tuple[list[str], list[list[str]]]:
    """Return the headings and the rows of the first releases.

    Parameters
    ----------
    values
        The variables that are shown, (n,) each, SI units and radians.
    errors
        Their standard errors, perhaps beside others.
    labels
        Of the tracks, n.
    reasons
        Why a track is not credible, "" for one that is.
    scene
        The scene, which has the units of variables that are no arguments of a release.
    """
    heads, rows = ["track"], [[str(one)] for one in labels[:SHOWN]]
    for name, value in values.items():
        unit = display_unit(ARGUMENTS[name].kind) if name in ARGUMENTS else None
        size = unit.size if unit else 1.0
        heads.append(f"{name} ({unit.symbol if unit else unit_in(name, scene)})")
        own = errors[name] / size
        digits = _decimals(own)
        for row, number, error in zip(rows, value / size, own, strict=False):
            row.append(f"{number:.{digits}f} ± {error:.{digits}f}" if number == number else "-")
    for row, reason in zip(rows, reasons, strict=False):
        row.append(reason or "yes")
    return [*heads, "credible"], rows


def _decimals(errors: Floats) -> int:
    """Return the decimals that show one or two digits of standard errors."""
    known = errors[np.isfinite(errors) & (errors > 0.0)]
    return int(np.clip(1 - floor(log10(np.median(known))), 2, 9)) if len(known) else 2
