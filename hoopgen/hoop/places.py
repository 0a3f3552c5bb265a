"""Named places on the board and on the ring, as coaches use them to say where to aim.

The square is that painted on the board: NBA Rule Book, rule 1. The upper edge of its base is level
with the ring; 24 in by 18 in outside, lines 2 in wide.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from hoopgen.core.units import INCH, display_unit

_ACROSS, _UP, _LINE = 24.0 * INCH, 18.0 * INCH, 2.0 * INCH


@dataclass(frozen=True)
class Square:
    """Outer edges of the painted square, and the width of its lines, m.

    y is to the right as the shooter sees it, z up, both from the ring's centre.
    """

    left: float
    right: float
    bottom: float
    top: float
    line: float

    @classmethod
    def from_parameters(cls, parameters: Mapping[str, float]) -> Square:
        """Return the square of a scene with these parameters."""
        bottom = parameters["wire_radius"] - _LINE
        return cls(-_ACROSS / 2.0, _ACROSS / 2.0, bottom, bottom + _UP, _LINE)


def on_board(parameters: Mapping[str, float]) -> dict[str, tuple[float, float]]:
    """Return the named places on the board, y and z from the ring's centre, m."""
    square = Square.from_parameters(parameters)
    middle = (square.bottom + square.top) / 2.0
    return {
        "top left corner of the square": (square.left, square.top),
        "top of the square": (0.0, square.top),
        "top right corner of the square": (square.right, square.top),
        "left side of the square": (square.left, middle),
        "centre of the square": (0.0, middle),
        "right side of the square": (square.right, middle),
    }


def on_ring(parameters: Mapping[str, float]) -> dict[str, float]:
    """Return the named places of the ring by how far past its centre they are, m.

    Those of the rim lie on the middle of the wire.
    """
    radius = parameters["ring_radius"]
    return {"front of the rim": -radius, "centre of the ring": 0.0, "back of the rim": radius}


def say_on_board(y: float, z: float, parameters: Mapping[str, float]) -> str:
    """Say a place on the board by the nearest that has a name: "3 cm above the top of the square".

    Parameters
    ----------
    y, z
        From the ring's centre, m; +y is to the shooter's right.
    parameters
        Parameters of the scene.
    """
    places = on_board(parameters)
    name = min(places, key=lambda one: math.dist(places[one], (y, z)))
    across, up = y - places[name][0], z - places[name][1]
    return _place_text(name, [(up, "above", "below"), (across, "right of", "left of")])


def say_on_ring(past: float, parameters: Mapping[str, float]) -> str:
    """Return a distance past the ring's centre, m, in words, by the nearest named place.

    Parameters
    ----------
    past
        The distance, m; negative short of the centre.
    parameters
        Parameters of the hoop, SI units.
    """
    places = on_ring(parameters)
    name = min(places, key=lambda one: abs(places[one] - past))
    return _place_text(name, [(past - places[name], "past", "short of")])


def _place_text(name: str, ways: list[tuple[float, str, str]]) -> str:
    """Say a place by how far it is from a named one, each way."""
    unit = display_unit("short")
    parts = [
        f"{abs(away) / unit.size:.0f} {unit.symbol} {more if away > 0.0 else less}"
        for away, more, less in ways
        if round(abs(away) / unit.size) >= 1
    ]
    return f"{' and '.join(parts)} the {name}" if parts else f"the {name}"
