"""The table of units: each kind of quantity, its units, their sizes in SI, and their spellings.

`hoopgen.core.units` reads quantities by this table, and chooses from it the units that are shown.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal

Kind = Literal["length", "speed", "angle", "spin", "acceleration", "mass", "density", "number"]

FOOT = 0.3048
"""Metres in a foot, by definition."""

INCH = 0.0254
"""Metres in an inch, by definition."""

_HOUR = 3600.0

MILE_PER_HOUR = 1609.344 / _HOUR
"""Metres per second in a mile per hour, by definition."""

POUND = 0.45359237
"""Kilograms in a pound, by definition."""

OUNCE = POUND / 16.0
"""Kilograms in an ounce, the sixteenth part of a pound."""

POUND_PER_CUBIC_FOOT = POUND / (FOOT * FOOT * FOOT)
"""Kilograms per cubic metre in a pound per cubic foot."""

DEGREE = math.pi / 180.0
"""Radians in a degree."""

TURN = 2.0 * math.pi
"""Radians in a turn."""

UNITS: Mapping[Kind, Mapping[str, float]] = MappingProxyType(
    {
        "length": MappingProxyType({"m": 1.0, "cm": 0.01, "mm": 0.001, "ft": FOOT, "in": INCH}),
        "speed": MappingProxyType(
            {
                "m/s": 1.0,
                "cm/s": 0.01,
                "ft/s": FOOT,
                "km/h": 1000.0 / _HOUR,
                "mph": MILE_PER_HOUR,
            }
        ),
        "angle": MappingProxyType({"rad": 1.0, "deg": DEGREE}),
        "spin": MappingProxyType(
            {"rad/s": 1.0, "deg/s": DEGREE, "Hz": TURN, "rev/s": TURN, "rpm": TURN / 60.0}
        ),
        "acceleration": MappingProxyType({"m/s2": 1.0, "ft/s2": FOOT}),
        "mass": MappingProxyType({"kg": 1.0, "g": 0.001, "oz": OUNCE, "lb": POUND}),
        "density": MappingProxyType({"kg/m3": 1.0, "lb/ft3": POUND_PER_CUBIC_FOOT}),
        "number": MappingProxyType({"": 1.0}),
    }
)
"""Each kind of quantity, its units and their size in SI. The first unit of a kind is the SI one."""

UNIT_REQUIRED: Mapping[Kind, tuple[str, ...]] = MappingProxyType(
    {"angle": ("deg", "rad"), "spin": ("Hz", "rpm", "rad/s", "deg/s")}
)
"""Kinds that must have their unit, and the units that a bare number may have been meant in."""

_SPELLED = {
    "m": "metre metres meter meters",
    "cm": "centimetre centimetres centimeter centimeters",
    "mm": "millimetre millimetres millimeter millimeters",
    "km": "kilometre kilometres kilometer kilometers",
    "ft": "foot feet ' \u2032",
    "in": 'inch inches " \u2033',
    "mi": "mile miles",
    "s": "sec second seconds",
    "min": "minute minutes",
    "h": "hr hour hours",
    "rad": "radian radians",
    "deg": "degree degrees \u00b0",
    "rev": "revolution revolutions turn turns",
    "hz": "hertz",
    "s2": "s^2 s\u00b2",
    "m3": "m^3 m\u00b3",
    "ft3": "ft^3 ft\u00b3",
    "kg": "kilogram kilograms kilogramme kilogrammes",
    "g": "gram grams gramme grammes",
    "oz": "ounce ounces",
    "lb": "pound pounds lbs",
    "mph": "mi/h",
    "km/h": "kph kmh",
    "rpm": "rev/min",
}
"""Other spellings, of units and of their parts."""

SYMBOLS: Mapping[str, str] = MappingProxyType(
    {word: symbol for symbol, words in _SPELLED.items() for word in words.split()}
)
"""The symbol of each unit, and of each part of one, by its other spellings in small letters."""
