"""The lines of the court around a basket, as the rule books have them; nothing simulates them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.hoop.presets import nearest_preset
from hoopgen.units import FOOT

__all__ = ["COURTS", "Court", "court_of", "lines_of"]


@dataclass(frozen=True)
class Court:
    """Measures of a court, m.

    Attributes
    ----------
    baseline
        Behind the board's front.
    free_throw
        The free-throw line, in front of the board's front.
    lane
        Width of the lane.
    circle
        Radius of the free-throw circle.
    arc
        Radius of the three-point arc, about the ring's centre.
    corner
        From the middle of the court to the three-point line in the corners.
    half_width
        From the middle of the court to a sideline.
    """

    baseline: float
    free_throw: float
    lane: float
    circle: float
    arc: float
    corner: float
    half_width: float


COURTS: Mapping[str, Court] = MappingProxyType(
    {
        # NBA Rule Book, rule 1.
        "NBA": Court(
            baseline=4 * FOOT,
            free_throw=15 * FOOT,
            lane=16 * FOOT,
            circle=6 * FOOT,
            arc=23.75 * FOOT,
            corner=22 * FOOT,
            half_width=25 * FOOT,
        ),
        # FIBA Official Basketball Rules, article 2, and Equipment.
        "FIBA": Court(
            baseline=1.2,
            free_throw=4.6,
            lane=4.9,
            circle=1.8,
            arc=6.75,
            corner=6.6,
            half_width=7.5,
        ),
    }
)
"""Courts of the rule books."""


def court_of(parameters: Mapping[str, Any]) -> str:
    """Return the name of the court that a hoop stands on: FIBA's by its preset, else the NBA's."""
    preset, _ = nearest_preset(parameters)
    return "FIBA" if preset == "fiba" else "NBA"


def lines_of(court: Court, board_distance: float) -> dict[str, NDArray[np.float64]]:
    """Return the lines about a basket by name, x and y from the ring's centre, m, (n, 2) each."""
    front, half = -board_distance, court.lane / 2.0
    baseline, line = front - court.baseline, front + court.free_throw
    turn = np.arccos(min(1.0, court.corner / court.arc))
    arc = court.arc * _circle(turn - np.pi / 2.0, np.pi / 2.0 - turn)
    lines = {
        "baseline": [(baseline, -court.half_width), (baseline, court.half_width)],
        "lane": [(baseline, -half), (line, -half), (line, half), (baseline, half)],
        "circle": court.circle * _circle(0.0, 2.0 * np.pi) + (line, 0.0),
        "three": [(baseline, -court.corner), *arc, (baseline, court.corner)],
    }
    return {name: np.asarray(points, dtype=np.float64) for name, points in lines.items()}


def _circle(start: float, stop: float) -> NDArray[np.float64]:
    """Return points on the unit circle, (n, 2)."""
    turn = np.linspace(start, stop, 61)
    return np.stack([np.cos(turn), np.sin(turn)], axis=1)
