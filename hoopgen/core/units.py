"""Units in text, such as ``13.75ft``, ``51 degrees``, ``3 Hz`` and ``6ft 8in``.

The library itself speaks SI and radians only. This is the door: a small table and a small grammar,
nothing is ever evaluated. One rule holds wherever a person types text, on the command line, in
study files and in the names of columns: what has no unit is SI, but an angle or a spin, which are
thought of in other units than the library's, must have one. 0 is 0 in any.

Outwards, `use_units` chooses the units of text and pictures.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

from hoopgen.text.shorten import brief

from .unit_table import (
    DEGREE,
    FOOT,
    INCH,
    MILE_PER_HOUR,
    OUNCE,
    POUND_PER_CUBIC_FOOT,
    SYMBOLS,
    TURN,
    UNIT_REQUIRED,
    UNITS,
    Kind,
)

__all__ = [
    "DEGREE",
    "FOOT",
    "INCH",
    "UNIT_REQUIRED",
    "DISPLAY_UNITS",
    "TURN",
    "UNITS",
    "Kind",
    "DisplayUnit",
    "System",
    "column_name",
    "file_unit",
    "parse_quantity",
    "readings",
    "use_units",
    "display_unit",
    "display_system",
    "unit_size",
    "unit_symbol",
]

_SIZES: Mapping[Kind, Mapping[str, float]] = {
    kind: {unit.lower(): size for unit, size in units.items()} for kind, units in UNITS.items()
}

_NUMBER = r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_WORD = r"[^\s\d.+/-]+"
_UNIT = (  # only a square or a cube ends in a digit: 6ft2in is feet, inches
    rf"{_WORD}(?:(?:\s*/\s*|\s+[pP][eE][rR]\s+){_WORD}(?:(?<=/s)2|(?<=/m)3|(?<=/ft)3|(?<=\^)[23])?)?"
)
_PART = re.compile(rf"\s*({_NUMBER})\s*({_UNIT})?", re.ASCII)
_INFINITE = re.compile(r"\s*[+-]?inf(?:inity)?\s*", re.ASCII | re.IGNORECASE)
_DECIMAL_COMMA = re.compile(r"\s*[+-]?\d+,\d")

_SIGN = re.compile(r"\s*([+-]?)", re.ASCII)


# ----------------------------------------------------------------------------------------- reading


def unit_size(unit: str, kind: Kind) -> float | None:
    """Return the size in SI of a unit of `kind`, None if it is none.

    Spelled as in `UNITS` or in full, ``feet``, ``revolutions per minute``, in capital letters or
    small ones.

    Parameters
    ----------
    unit
        A unit as it is written.
    kind
        The kind of quantity.
    """
    parts = re.split(r"\s*/\s*|\s+per\s+", unit.strip().lower())
    symbol = "/".join(SYMBOLS.get(part, part) for part in parts)
    return _SIZES[kind].get(SYMBOLS.get(symbol, symbol))


def unit_symbol(size: float, kind: Kind) -> str:
    """Return the first unit of `kind` that has this size in SI; empty if there is none.

    Parameters
    ----------
    size
        The size of a unit, SI.
    kind
        The kind of quantity.
    """
    return next((unit for unit, one in UNITS[kind].items() if one == size), "")


def parse_quantity(text: str, kind: Kind, *, infinite: bool = False) -> float:
    """Return the SI value of a text with a number and a unit.

    Parameters
    ----------
    text
        A number and a unit of `kind`, with or without a space between them; see `unit_size`.
        Lengths may have several parts, ``6ft 8in``; a sign in front holds for all of them. Without
        a unit it is SI; an angle or a spin other than 0 must have one.
    kind
        What is measured; see `UNITS`.
    infinite
        Whether ``inf`` is a value, too; it needs no unit.

    Returns
    -------
    float
        m, m/s, rad, rad/s, m/s² or the number itself; finite, or positive infinity where allowed.

    Raises
    ------
    ValueError
        The text is no number, the unit is not one of `kind` or is needed and not there, or the
        value is not finite.
    """
    if _INFINITE.fullmatch(text):
        if not infinite or "-" in text:
            least = "a finite number, or plus infinity" if infinite else "a finite number"
            raise ValueError(f"{brief(text)} is not {least}")
        return math.inf
    sign, parts = _split(text, kind)
    if len(parts) > 1 and (kind != "length" or any(not unit for _, unit in parts)):
        raise ValueError(_complaint(text, kind))
    total = 0.0
    for number, unit in parts:
        size = unit_size(unit, kind) if unit else 1.0
        if size is None:
            raise ValueError(_wrong_unit(text, unit, kind))
        total += float(number) * size
    if not math.isfinite(total):
        raise ValueError(f"{brief(text)} is too large")
    if kind in UNIT_REQUIRED and not parts[0][1] and total != 0.0:
        raise ValueError(f"{brief(text)} has no unit: write {readings(text.strip(), kind)}")
    return -total if sign == "-" else total


def readings(number: str, kind: Kind, form: str = "{}{}") -> str:
    """Describe what a number without its unit may mean: ``52deg or 52rad``.

    Parameters
    ----------
    number
        A number without unit, as it was written.
    kind
        The kind of quantity.
    form
        A format of one reading, for its number and its unit.
    """
    *others, last = (form.format(number, unit) for unit in UNIT_REQUIRED[kind])
    return f"{', '.join(others)} or {last}"


def _split(text: str, kind: Kind) -> tuple[str, list[tuple[str, str]]]:
    """Split a text into a sign and (number, unit) parts; a missing unit is empty."""
    start = _SIGN.match(text)
    assert start is not None  # the pattern matches the empty string
    position, parts = start.end(), []
    end = len(text.rstrip())
    while position < end:
        part = _PART.match(text, position)
        if part is None:
            break
        parts.append((part[1], part[2] or ""))
        position = part.end()
    if position < end or not parts:
        raise ValueError(_complaint(text, kind))
    return start[1], parts


def _complaint(text: str, kind: Kind) -> str:
    hint = "; decimals stand after a point" if _DECIMAL_COMMA.match(text) else ""
    if kind == "number":
        return f"{brief(text)} is not a number{hint}"
    return f"{brief(text)} is not a number with a unit of {kind} ({_join_units(kind)}){hint}"


def _wrong_unit(text: str, unit: str, kind: Kind) -> str:
    if kind == "number":
        return f"{brief(text)} has the unit {brief(unit)}; a plain number is wanted"
    return f"{brief(text)}: {brief(unit)} is not a unit of {kind}; use {_join_units(kind)}"


def _join_units(kind: Kind) -> str:
    return ", ".join(UNITS[kind])


# ----------------------------------------------------------------------------------------- writing


def column_name(name: str, unit: str) -> str:
    """Return the name of a column of numbers in a unit: ``speed_m_s``; a plain number's has none.

    What is written like this is read again: see `hoopgen.study.tables.columns`.

    Parameters
    ----------
    name
        The name of the quantity.
    unit
        The unit; empty for a plain number.
    """
    plain = unit.lower().replace("\u00b2", "2").replace("\u00b3", "3").replace("/", "_")
    return name if plain in ("", "1") else f"{name}_{plain}"


System = Literal["si", "us"]

_US_FILE_UNITS: Mapping[str, str] = {
    "m": "ft",
    "m/s": "mph",
    "m/s2": "ft/s2",
    "kg": "oz",
    "kg/m3": "lb/ft3",
    "rad": "deg",
    "rad/s": "Hz",
}
"""The unit of a column in US units, by SI unit."""


def file_unit(unit: str, system: System) -> tuple[str, float]:
    """Return the unit of a column of results, and its size in SI.

    Parameters
    ----------
    unit
        In SI.
    system
        "si" for that; "us" for feet, mph, ounces and lb/ft3, and degrees and Hz.

    Raises
    ------
    ValueError
        If there is no such system.
    """
    if system not in DISPLAY_UNITS:
        raise ValueError(f"units: expected {' or '.join(DISPLAY_UNITS)}, got {brief(system)}")
    if system == "si" or unit not in _US_FILE_UNITS:
        return unit, 1.0
    other = _US_FILE_UNITS[unit]
    (kind,) = (kind for kind, units in UNITS.items() if unit in units)
    return other, UNITS[kind][other]


@dataclass(frozen=True)
class DisplayUnit:
    """The unit and the decimals in which text and pictures show a kind of values.

    Attributes
    ----------
    symbol
        Of the unit; empty for a plain number.
    size
        Of the unit, in SI.
    decimals
        In text.
    """

    symbol: str
    size: float
    decimals: int


DISPLAY_UNITS: Mapping[System, Mapping[str, DisplayUnit]] = MappingProxyType(
    {
        "si": {
            "length": DisplayUnit("m", 1.0, 3),
            "speed": DisplayUnit("m/s", 1.0, 3),
            "angle": DisplayUnit("\u00b0", DEGREE, 1),
            "spin": DisplayUnit("Hz", TURN, 2),
            "acceleration": DisplayUnit("m/s\u00b2", 1.0, 3),
            "mass": DisplayUnit("kg", 1.0, 3),
            "density": DisplayUnit("kg/m\u00b3", 1.0, 3),
            "number": DisplayUnit("", 1.0, 3),
            "short": DisplayUnit("cm", 0.01, 1),
        },
        "us": {
            "length": DisplayUnit("ft", FOOT, 2),
            "speed": DisplayUnit("mph", MILE_PER_HOUR, 2),
            "angle": DisplayUnit("\u00b0", DEGREE, 1),
            "spin": DisplayUnit("Hz", TURN, 2),
            "acceleration": DisplayUnit("ft/s\u00b2", FOOT, 2),
            "mass": DisplayUnit("oz", OUNCE, 2),
            "density": DisplayUnit("lb/ft\u00b3", POUND_PER_CUBIC_FOOT, 4),
            "number": DisplayUnit("", 1.0, 3),
            "short": DisplayUnit("in", INCH, 2),
        },
    }
)
"""Units and digits of each kind in either system; ``short`` is a small length."""

_SYSTEM: ContextVar[System] = ContextVar("units shown", default="si")


@contextmanager
def use_units(system: System) -> Iterator[None]:
    """Show text and pictures in other units, as long as the context lasts.

    Parameters
    ----------
    system
        "si", metres, m/s and kg; or "us", feet, inches, mph and ounces. Degrees and Hz in both.
        Numbers that functions take and return, and files, are not touched.

    Raises
    ------
    ValueError
        If there is no such system.
    """
    if system not in DISPLAY_UNITS:
        raise ValueError(f"system: expected {' or '.join(DISPLAY_UNITS)}, got {system!r}")
    token = _SYSTEM.set(system)
    try:
        yield
    finally:
        _SYSTEM.reset(token)


def display_unit(kind: Kind | Literal["short"]) -> DisplayUnit:
    """Return the unit in which a kind, or a short length, is shown."""
    return DISPLAY_UNITS[_SYSTEM.get()][kind]


def display_system() -> System:
    """Return the system of units that is shown."""
    return _SYSTEM.get()
