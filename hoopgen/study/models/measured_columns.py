"""Tables of measured releases as columns, with the covariance of their measuring errors."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Protocol, TypeAlias, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.validation import as_doubles
from hoopgen.core.variables import STATE, check_names, is_state
from hoopgen.hoop.variables import ARGUMENTS, STANDS_FOR, check_angles
from hoopgen.text.shorten import brief, join_names

from .resample import Resample

Floats = NDArray[np.float64]


@runtime_checkable
class WithErrors(Protocol):
    """Releases whose measuring errors are known, such as `FittedReleases`."""

    credible: NDArray[np.bool_]

    @property
    def measured(self) -> tuple[Mapping[str, Floats], Floats]:
        """Return the arguments of the release, (n,) each, and the covariance of the first k.

        The covariance, (n, k, k), is that of the errors.
        """
        ...


Measured: TypeAlias = WithErrors | Resample | Mapping[str, ArrayLike]


def measured_columns(
    table: Measured, group: Iterable[object] | str | None
) -> tuple[dict[str, Floats], Iterable[object] | None]:
    """Return the columns of a table, (n,) each or one number, and the labels of the rows.

    Parameters
    ----------
    table
        Fitted releases, a sample, or columns by name.
    group
        The label of each row, or the name of the column with the labels; None for none.
    """
    if isinstance(table, WithErrors):
        if isinstance(group, str):
            raise ValueError(f"group: fitted releases have no column {brief(group)}; give labels")
        columns = {name: np.array(one) for name, one in table.measured[0].items()}
        for one in columns.values():
            one[~table.credible] = np.nan
        return columns, group
    if isinstance(table, Resample):
        if isinstance(group, str):
            raise ValueError(f"group: a Resample has no column {brief(group)}; give labels")
        given: dict[str, Any] = dict(table.columns)
        group = table.group if group is None else group
    elif hasattr(table, "items"):
        given = dict(table.items())
    else:
        raise TypeError(
            f"table: expected fitted releases, a Resample, or columns by name; got {brief(table)}"
        )
    if isinstance(group, str):
        if group not in given:
            raise ValueError(f"group: no column {brief(group)}; there are {join_names(given)}")
        group = list(given.pop(group))
    return _plain(given), group


def _plain(given: Mapping[str, Any]) -> dict[str, Floats]:
    """Return columns of a state, or of arguments of a release."""
    columns = {name: as_doubles(f"table[{name!r}]", one) for name, one in given.items()}
    lengths = {one.shape for one in columns.values() if one.ndim}
    if len(lengths) != 1 or len(next(iter(lengths))) != 1:
        shapes = ", ".join(f"{name} {one.shape}" for name, one in columns.items())
        raise ValueError(f"table: expected columns of one length, got {shapes or 'none'}")
    if is_state(columns):
        check_names("table", columns, STATE)
        return columns
    check_names("table", columns, (*ARGUMENTS, "x", "y"))
    check_angles("table", columns)
    floor = [name for name in ("x", "y") if name in columns]
    if len(floor) == 1 or (floor and any(other in columns for other in STANDS_FOR["x"])):
        raise ValueError("table: x and y are given together, in place of distance and angle")
    if "x" in columns:
        x, y = columns.pop("x"), columns.pop("y")
        columns |= {"distance": np.hypot(x, y), "angle": np.arctan2(y, x)}
    return columns


def measured_groups(labels: Iterable[object] | None) -> list[str] | None:
    """Return the labels of the rows as text."""
    if labels is None:
        return None
    found = list(labels)
    missing = [row for row, one in enumerate(found) if one is None or one != one or one == ""]
    if missing:
        raise ValueError(f"group: row {missing[0] + 1} of {len(found)} has no label")
    return [str(one) for one in found]


def measuring_noise(
    table: Measured,
    columns: Mapping[str, Floats],
    given: Mapping[str | tuple[str, str], ArrayLike] | None,
) -> dict[tuple[str, str], Floats]:
    """Return the covariances of the measuring errors by pairs of names.

    Parameters
    ----------
    table
        Fitted releases, a sample, or columns by name.
    columns
        The columns of the table, (n,) each or one number.
    given
        Variances by name and covariances by pairs of names, one number or (n,) each; None is what
        the table has.

    Raises
    ------
    ValueError
        If a name is no column, a pair is given twice, or they are no covariance.
    """
    found: dict[tuple[str, str], Floats] = {}
    if given is None:
        if isinstance(table, WithErrors):
            values, covariance = table.measured
            names = tuple(values)[: covariance.shape[1]]
            for i, a in enumerate(names):
                for j, b in enumerate(names[: i + 1]):
                    found[a, b] = covariance[:, i, j]
        return found
    for key, value in given.items():
        a, b = (key, key) if isinstance(key, str) else key
        text = f"measurement_covariance[{key!r}]"
        check_names("measurement_covariance", (a, b), columns)
        if (a, b) in found or (b, a) in found:
            raise ValueError(f"measurement_covariance: {a} and {b} are given twice")
        found[a, b] = as_doubles(text, value)
        if a == b and np.any(found[a, b] < 0.0):
            raise ValueError(f"{text}: expected variances from 0, got {brief(value)}")
    for (a, b), one in found.items():
        most = np.asarray(found.get((a, a), 0.0)) * np.asarray(found.get((b, b), 0.0))
        if np.any(one * one > most * (1.0 + 1e-9)):
            raise ValueError(
                f"measurement_covariance: the covariance of {a} and {b} is larger than their "
                "variances allow"
            )
    return found


def measuring_errors(
    columns: Mapping[str, Any], of_table: Mapping[str, Any], given: Mapping[str, float]
) -> dict[str, Any]:
    """Return the variances of the measuring errors of columns, SI.

    Parameters
    ----------
    columns
        Measured releases by variable; one number is not measured, but the same for all.
    of_table
        Variances that the table says, by variable; those of no column are left out.
    given
        Variances in their place.

    Raises
    ------
    ValueError
        If a variance is given of what is no column; the message begins with `instrument`.
    """
    measured = [name for name, one in columns.items() if np.ndim(one)]
    for name in given:
        if name not in measured:
            raise ValueError(
                f"instrument: {name} is no column of the table; expected one of "
                f"{', '.join(measured)}"
            )
    return {name: one for name, one in {**of_table, **given}.items() if name in measured}
