"""Units written in words: ``13.75ft``, ``51deg``, ``3 Hz``, ``6ft 8in``.

The library itself speaks SI and radians only. This is the door: a small table and a small grammar,
nothing is ever evaluated.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal

from .brief import brief

__all__ = ["FOOT", "UNITS", "Kind", "parse_quantity"]

Kind = Literal["length", "speed", "angle", "spin", "acceleration", "number"]

FOOT = 0.3048
"""Metres in a foot, by definition."""

_INCH = 0.0254
_MILE = 1609.344
_HOUR = 3600.0
_DEGREE = math.pi / 180.0
_TURN = 2.0 * math.pi

UNITS: Mapping[Kind, Mapping[str, float]] = MappingProxyType(
    {
        "length": MappingProxyType(
            {"m": 1.0, "cm": 0.01, "mm": 0.001, "ft": FOOT, "in": _INCH, "'": FOOT, '"': _INCH}
        ),
        "speed": MappingProxyType(
            {"m/s": 1.0, "ft/s": FOOT, "km/h": 1000.0 / _HOUR, "mph": _MILE / _HOUR}
        ),
        "angle": MappingProxyType({"rad": 1.0, "deg": _DEGREE, "°": _DEGREE}),
        "spin": MappingProxyType(
            {"rad/s": 1.0, "deg/s": _DEGREE, "Hz": _TURN, "rev/s": _TURN, "rpm": _TURN / 60.0}
        ),
        "acceleration": MappingProxyType(
            {"m/s2": 1.0, "m/s^2": 1.0, "ft/s2": FOOT, "ft/s^2": FOOT}
        ),
        "number": MappingProxyType({"": 1.0}),
    }
)
"""Each kind of quantity, its units and their size in SI. The first unit of a kind is the SI one."""

_NUMBER = r"(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_UNIT = (
    r"[^\s\d.+-]+(?:(?<=/s)2|(?<=\^)2)?"  # only a square ends in a digit: 6ft2in is feet, inches
)
_PART = re.compile(rf"\s*({_NUMBER})\s*({_UNIT})?", re.ASCII)
_SIGN = re.compile(r"\s*([+-]?)", re.ASCII)


def parse_quantity(text: str, kind: Kind, *, bare: str | None = None) -> float:
    """Read a number with a unit and give it in SI.

    Parameters
    ----------
    text
        A number and a unit of `kind`, with or without a space between them. Lengths may have
        several parts, ``6ft 8in``; a sign in front holds for all of them.
    kind
        What is measured; see `UNITS`.
    bare
        The unit of a number written without one. By default the SI unit of `kind`.

    Returns
    -------
    float
        m, m/s, rad, rad/s, m/s² or the number itself; always finite.

    Raises
    ------
    ValueError
        The text is no number, the unit is not one of `kind`, or the value is not finite.
    """
    units = UNITS[kind]
    sign, parts = _split(text, kind)
    if len(parts) > 1 and (kind != "length" or any(not unit for _, unit in parts)):
        raise ValueError(_complaint(text, kind))
    default = next(iter(units)) if bare is None else bare
    total = 0.0
    for number, written in parts:
        unit = written or default
        if unit not in units:
            raise ValueError(_wrong_unit(text, unit, kind))
        total += float(number) * units[unit]
    if not math.isfinite(total):
        raise ValueError(f"{brief(text)} is too large")
    return -total if sign == "-" else total


def _split(text: str, kind: Kind) -> tuple[str, list[tuple[str, str]]]:
    """Cut into a sign and (number, unit) parts; the unit is empty where none is written."""
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
    if kind == "number":
        return f"{brief(text)} is not a number"
    return f"{brief(text)} is not a number with a unit of {kind} ({_listed(kind)})"


def _wrong_unit(text: str, unit: str, kind: Kind) -> str:
    if kind == "number":
        return f"{brief(text)} has the unit {brief(unit)}; a plain number is wanted"
    return f"{brief(text)}: {brief(unit)} is not a unit of {kind}; use {_listed(kind)}"


def _listed(kind: Kind) -> str:
    return ", ".join(UNITS[kind])
