"""The limits of plausible releases.

A tracking table has rows in which a camera or a person went wrong: an elevation of 500°, a release
height of 72 ft. Such a row can be simulated, but its shot says nothing about a player. Of tables of
releases at a hoop, a row with a number outside of these limits is INVALID, with its reason, unless
it is asked for. Commands and study files refuse such a number; `hoopgen.release` refuses only one
that seems to be in another unit. The limits are generous: no shot on a court comes near them.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import inf, pi
from types import MappingProxyType

from hoopgen.core.units import TURN, display_unit
from hoopgen.hoop.variables import VARIABLES
from hoopgen.text.shorten import brief

_EVERYWHERE = (-inf, inf)

PLAUSIBLE: Mapping[str, tuple[float, float]] = MappingProxyType(
    {
        "speed": (0.0, 40.0),
        "elevation": (-pi / 2, pi / 2),
        "azimuth": (-pi, pi),
        "backspin": (-30.0 * TURN, 30.0 * TURN),
        "sidespin": (-30.0 * TURN, 30.0 * TURN),
        "height": (0.0, 5.0),
        "distance": (0.0, 40.0),
        "angle": (-TURN, TURN),
        "aim": (-10.0, 10.0),
        "entry": (0.0, pi / 2),
        "x": (-40.0, 40.0),
        "y": (-40.0, 40.0),
        "z": (-4.0, 20.0),
        **dict.fromkeys(("vx", "vy", "vz"), (-40.0, 40.0)),
        **dict.fromkeys(("wx", "wy", "wz"), (-30.0 * TURN, 30.0 * TURN)),
    }
)
"""The least and the largest plausible value of variables of a release, and of components of a
state; SI. A court is 28.65 m long; the longest shots leave the hand at some 20 m/s."""


def limits_of(variable: str) -> tuple[float, float]:
    """Return the least and the largest plausible value of a variable; a parameter has no limits."""
    return PLAUSIBLE.get(variable, _EVERYWHERE)


def check_plausible(variable: str, value: float, text: str) -> float:
    """Return the value of a variable of a release at a hoop; refuse an implausible one.

    Parameters
    ----------
    variable
        The name of the variable; one without limits takes every value.
    value
        Its value, SI.
    text
        The value as it was written, for the error.

    Raises
    ------
    ValueError
        If the value is outside of the limits, which the message says in the units shown.
    """
    low, high = limits_of(variable)
    if low <= value <= high or value != value:
        return value
    unit = display_unit(VARIABLES[variable].kind)
    blank = "" if unit.symbol == "\N{DEGREE SIGN}" else " "
    ends = " to ".join(f"{round(end / unit.size, 2):g}" for end in (low, high))
    raise ValueError(f"implausible: expected {ends}{blank}{unit.symbol}, got {brief(text)}")
