"""Lines of the court around a basket by the rule books, for pictures; no simulation uses them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.units import FOOT
from hoopgen.text.shorten import brief

from .presets import nearest_preset


@dataclass(frozen=True)
class Court:
    """Measures of a court, m.

    Attributes
    ----------
    baseline
        Distance of the baseline behind the board's front.
    free_throw
        Distance of the free-throw line in front of the board's front.
    lane
        Width of the lane.
    circle
        Radius of the free-throw circle.
    arc
        Radius of the three-point arc, about the ring's centre.
    corner
        Distance of the three-point line in the corners from the middle of the court.
    restricted
        Radius of the arc below the basket within which there is no charge.
    half_width, half_length
        Distances of a sideline from the middle of the court, and of the division line from a
        baseline.
    whole_circle
        Whether the free-throw circle goes on, dashed, inside the lane.
    """

    baseline: float
    free_throw: float
    lane: float
    circle: float
    arc: float
    corner: float
    restricted: float
    half_width: float
    half_length: float
    whole_circle: bool


COURTS: Mapping[str, Court] = MappingProxyType(
    {
        # NBA Rule Book, rule 1, section I and its diagram: 94 ft by 50 ft, the three-point line
        # 3 ft from the sidelines and 23 ft 9 in from the middle of the basket.
        "NBA": Court(
            baseline=4 * FOOT,
            free_throw=15 * FOOT,
            lane=16 * FOOT,
            circle=6 * FOOT,
            arc=23.75 * FOOT,
            corner=22 * FOOT,
            restricted=4 * FOOT,
            half_width=25 * FOOT,
            half_length=47 * FOOT,
            whole_circle=True,
        ),
        # FIBA Official Basketball Rules, articles 2.1 to 2.4, and Equipment: 28 m by 15 m, the
        # free-throw line 5.8 m from the baseline, the three-point line 0.9 m from the sidelines.
        "FIBA": Court(
            baseline=1.2,
            free_throw=4.6,
            lane=4.9,
            circle=1.8,
            arc=6.75,
            corner=6.6,
            restricted=1.25,
            half_width=7.5,
            half_length=14.0,
            whole_circle=False,
        ),
    }
)
"""Courts of the rule books, by name."""


def find_court(name: str | None, parameters: Mapping[str, Any]) -> Court:
    """Return a court by name; without a name, the court of the hoop with these parameters.

    Parameters
    ----------
    name
        "NBA" or "FIBA"; None: the court of the hoop.
    parameters
        Parameters of the hoop, SI units.

    Raises
    ------
    ValueError
        If there is no court of that name.
    """
    if name is None:
        return COURTS[court_of(parameters)]
    if name not in COURTS:
        raise ValueError(f"court: expected {' or '.join(COURTS)}, got {brief(name)}")
    return COURTS[name]


def court_of(parameters: Mapping[str, Any]) -> str:
    """Return the name of a hoop's court: that of its nearest preset, which may be the NBA's."""
    preset, _ = nearest_preset(parameters)
    return preset.upper() if preset.upper() in COURTS else "NBA"


def lines_of(court: Court, board_distance: float) -> dict[str, NDArray[np.float64]]:
    """Return the lines of a half court by name, x and y from the ring's centre, m, (n, 2) each.

    The three-point line and the restricted arc are about the ring's centre, all else is measured
    from the board's front. The arc ends in straight lines up to the plane of the board.

    Parameters
    ----------
    court
        The measures of the court.
    board_distance
        Distance of the board's front from the ring's centre, m.
    """
    front, half, side = -board_distance, court.lane / 2.0, court.half_width
    baseline, line = front - court.baseline, front + court.free_throw
    middle = baseline + court.half_length
    turn = np.arccos(min(1.0, court.corner / court.arc))
    arc = court.arc * _circle(turn - np.pi / 2.0, np.pi / 2.0 - turn)
    below = court.restricted * _circle(-np.pi / 2.0, np.pi / 2.0)
    circle = court.circle * _circle(-np.pi / 2.0, np.pi / 2.0) + (line, 0.0)
    lines = {
        "sides": [(middle, -side), (baseline, -side), (baseline, side), (middle, side)],
        "middle": [(middle, -side), (middle, side)],
        "lane": [(baseline, -half), (line, -half), (line, half), (baseline, half)],
        "circle": circle,
        "three": [(baseline, -court.corner), *arc, (baseline, court.corner)],
        "restricted": [(front, -court.restricted), *below, (front, court.restricted)],
    }
    if court.whole_circle:
        lines["inside"] = (2.0 * line, 0.0) + (-1.0, 1.0) * circle
    return {name: np.asarray(points, dtype=np.float64) for name, points in lines.items()}


def _circle(start: float, stop: float) -> NDArray[np.float64]:
    """Return points on the unit circle, (n, 2)."""
    turn = np.linspace(start, stop, 181)
    return np.stack([np.cos(turn), np.sin(turn)], axis=1)
