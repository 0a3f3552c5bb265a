"""Values of variables in words and on axes, in the units that coaches use.

The arrays hold SI units and radians; degrees, Hz and centimetres are for reading, and feet, inches
and mph where `hoopgen.units.showing` says so.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import isfinite, isnan
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .hoop.presets import NAMES
from .hoop.variables import VARIABLES
from .phrases import MINUS
from .printable import printable
from .scenes import HOOPED
from .units import Shown, shown, shown_system

__all__ = [
    "Quantity",
    "between",
    "for_json",
    "quantity",
    "say",
]

_IN_INCHES = ("aim", *NAMES)
"""Of lengths, those that are shown in inches where others are in feet."""

_DIGITS = 4
"""Significant, in pictures."""


# -------------------------------------------------------------------------------------------- text


def say(name: str, value: float, *, unit: bool = True) -> str:
    """Say the value of a variable."""
    one = shown("short") if name == "aim" else _shown(name)
    text = f"{value / one.size:.{one.decimals}f}"
    if float(text) == 0.0:
        text = text.removeprefix("-")
    return _with(one.symbol, text) if unit else text


def _shown(name: str) -> Shown:
    """Return the unit that a variable is shown in, on axes too."""
    kind = HOOPED[name].kind
    inches = kind == "length" and name in _IN_INCHES and shown_system() == "us"
    return shown("short" if inches else kind)


def between(name: str, low: float, high: float) -> str:
    """Say an interval of a variable, its unit once."""
    return f"{say(name, low, unit=False)} to {say(name, high)}"


# ---------------------------------------------------------------------------------------- pictures


@dataclass(frozen=True)
class Quantity:
    """How a variable is shown in a picture.

    Attributes
    ----------
    name
        In words.
    unit
        Shown; empty for a plain number.
    size
        Of that unit, in the unit of what is given.
    """

    name: str
    unit: str
    size: float = 1.0

    @property
    def label(self) -> str:
        """For an axis: name and unit."""
        return f"{self.name} ({self.unit})" if self.unit else self.name

    def shown(self, values: ArrayLike) -> NDArray[np.float64]:
        """Return values in the unit shown."""
        return np.asarray(values, dtype=np.float64) / self.size

    def say(self, value: float, digits: int = _DIGITS) -> str:
        """Return a value, in the unit shown, in words."""
        return _with(self.unit, f"{value:.{digits}g}".replace("-", MINUS))


def quantity(name: str, attributes: Mapping[str, object] | None = None) -> Quantity:
    """Return how a variable is shown in a picture.

    Parameters
    ----------
    name
        One of `hoopgen.hoop.variables.VARIABLES`, in SI units; or any other. Without attributes,
        also one of `hoopgen.scenes.HOOPED`.
    attributes
        Of another one: ``long_name`` and ``units``, as xarray has them.
    """
    if name in VARIABLES or (attributes is None and name in HOOPED):
        one = _shown(name)
        return Quantity(HOOPED[name].label, one.symbol, one.size)
    given = attributes or {}
    long_name, units = str(given.get("long_name", name)), str(given.get("units", ""))
    return Quantity(printable(long_name), printable(units))


def _with(unit: str, number: str) -> str:
    return number + ("" if unit in ("", "°") else " ") + unit


def for_json(value: Any) -> Any:
    """Return a value, and all in it, in types that JSON knows.

    JSON has no infinite number: it is the text "inf" or "-inf", which `float` reads; and None
    stands for what is not a number.
    """
    if isinstance(value, Mapping):
        return {str(name): for_json(one) for name, one in value.items()}
    if isinstance(value, list | tuple):
        return [for_json(one) for one in value]
    if isinstance(value, float) and not isfinite(value):
        return None if isnan(value) else str(float(value))
    return value
