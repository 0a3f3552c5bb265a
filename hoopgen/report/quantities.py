"""Display of values in text and on axes, in the units that coaches use.

Arrays hold SI units and radians. Text and pictures show degrees, Hz and centimetres, or feet,
inches and mph within `hoopgen.core.units.use_units`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite, isnan
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.units import DisplayUnit, display_system, display_unit
from hoopgen.hoop.presets import NAMES
from hoopgen.hoop.variables import VARIABLES
from hoopgen.scene.lookup import HOOP_VARIABLES
from hoopgen.text.escape import printable
from hoopgen.text.numbers import MINUS

STILL = "no scatter: every throw is the same"
"""Text in place of an interval if nothing is random."""

_IN_INCHES = ("aim", *NAMES)
"""Lengths that US units show in inches; all others are in feet."""

_DIGITS = 4
"""Significant digits in pictures."""


# -------------------------------------------------------------------------------------------- text


def format_variable(name: str, value: float, *, unit: bool = True) -> str:
    """Format the value of a variable in its display unit.

    Parameters
    ----------
    name
        A variable at a hoop, one of `hoopgen.scene.lookup.HOOP_VARIABLES`.
    value
        Its value, SI.
    unit
        False to leave out the unit.
    """
    one = display_unit("short") if name == "aim" else _display_unit(name)
    text = f"{value / one.size:.{one.decimals}f}"
    if float(text) == 0.0:
        text = text.removeprefix("-")
    return _append_unit(one.symbol, text) if unit else text


def _display_unit(name: str) -> DisplayUnit:
    """Return the unit in which text and axes show a variable."""
    kind = HOOP_VARIABLES[name].kind
    inches = kind == "length" and name in _IN_INCHES and display_system() == "us"
    return display_unit("short" if inches else kind)


def format_range(name: str, low: float, high: float) -> str:
    """Format an interval of a variable, with its unit once.

    Parameters
    ----------
    name
        A variable at a hoop, one of `hoopgen.scene.lookup.HOOP_VARIABLES`.
    low, high
        The ends, SI.
    """
    return f"{format_variable(name, low, unit=False)} to {format_variable(name, high)}"


def format_bounds(name: str, low: float, high: float, *, at_hoop: bool) -> str:
    """Format an interval of a variable in a scene with a hoop, or without one, where it is SI.

    Parameters
    ----------
    name, low, high
        The variable, and the ends, SI.
    at_hoop
        Whether the scene has a hoop.
    """
    return format_range(name, low, high) if at_hoop else f"{low:g} to {high:g}"


def format_launch(release: Mapping[str, float]) -> str:
    """Format the speed and the elevation of a release, such as "7.170 m/s at 52.0°"."""
    speed, elevation = (format_variable(name, release[name]) for name in ("speed", "elevation"))
    return f"{speed} at {elevation}"


# ---------------------------------------------------------------------------------------- pictures


@dataclass(frozen=True)
class Quantity:
    """The display of a variable in pictures: its name and its unit.

    Attributes
    ----------
    name
        The variable's name in words.
    unit
        The symbol of its display unit; empty for a plain number.
    size
        One display unit, in the unit of the values.
    """

    name: str
    unit: str
    size: float = 1.0

    @property
    def label(self) -> str:
        """The label of an axis: name and unit."""
        return f"{self.name} ({self.unit})" if self.unit else self.name

    def convert(self, values: ArrayLike) -> NDArray[np.float64]:
        """Return values in the display unit."""
        return np.asarray(values, dtype=np.float64) / self.size

    def format(self, value: float, digits: int = _DIGITS) -> str:
        """Format a value.

        Parameters
        ----------
        value
            The value, in the display unit.
        digits
            Significant digits.
        """
        return _append_unit(self.unit, f"{value:.{digits}g}".replace("-", MINUS))


def quantity(name: str, attributes: Mapping[str, object] | None = None) -> Quantity:
    """Return the display of a variable in pictures.

    Parameters
    ----------
    name
        One of `hoopgen.hoop.variables.VARIABLES`, in SI units, or any other name. Without
        attributes, also one of `hoopgen.scene.lookup.HOOP_VARIABLES`.
    attributes
        ``long_name`` and ``units`` of another variable, as xarray has them.
    """
    if name in VARIABLES or (attributes is None and name in HOOP_VARIABLES):
        one = _display_unit(name)
        return Quantity(HOOP_VARIABLES[name].label, one.symbol, one.size)
    given = attributes or {}
    long_name, units = str(given.get("long_name", name)), str(given.get("units", ""))
    return Quantity(printable(long_name), printable(units))


def _append_unit(unit: str, number: str) -> str:
    return number + ("" if unit in ("", "°") else " ") + unit


def for_json(value: Any) -> Any:
    """Return a value, with all that it contains, in types that JSON knows.

    JSON has no infinite number: the text "inf" or "-inf" stands for one, and `float` reads it.
    None stands for NaN.
    """
    if isinstance(value, Mapping):
        return {str(name): for_json(one) for name, one in value.items()}
    if isinstance(value, list | tuple):
        return [for_json(one) for one in value]
    if isinstance(value, float) and not isfinite(value):
        return None if isnan(value) else str(float(value))
    return value
