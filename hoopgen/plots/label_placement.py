"""Placement of labels near what they name and over nothing else: geometry, no drawing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

_DIRECTIONS, _STEPS = 32, 6  # places tried around an anchor, and further off
_EXTRA_STEPS = 8  # times as many steps, so many at a time, where a label would cover another one

# What a place costs, in heights of the label away from its anchor.
_OUTSIDE_COST = 1e6
_OVERLAP_COST = 1e3
_OTHER_BALL_COST = 4.0
_COVERED_POINT_COST = 3.0


@dataclass(frozen=True)
class Box:
    """A label to place: its anchor, its distance from it, and its size.

    Attributes
    ----------
    anchor
        The point named.
    clearance
        Distance from the anchor to the nearest place of the label's edge.
    width, height
        Of the label, in the units of the anchor.
    """

    anchor: tuple[float, float]
    clearance: float
    width: float
    height: float


def place_labels(
    boxes: list[Box],
    obstacles: NDArray[np.float64],
    bounds: tuple[float, float, float, float],
) -> list[tuple[float, float]]:
    """Choose the centre of each label, one after the other.

    Of places all around the anchor, near ones first, the one that covers the fewest obstacles
    is taken; further ones are tried where each of these is over another label or out of bounds,
    and a place like that is taken only when nothing else is left.

    Parameters
    ----------
    boxes
        The labels.
    obstacles
        Points better left visible, shape (n, 2).
    bounds
        Left, right, bottom, top of the space there is.

    Returns
    -------
    list of (x, y)
        The centres, in order.
    """
    placed: list[tuple[Box, tuple[float, float]]] = []
    for box in boxes:
        least, best = np.inf, box.anchor
        for turn in range(_EXTRA_STEPS):
            places = _around(box, turn * _STEPS)
            cost = (
                np.hypot(*(places - box.anchor).T) / box.height
                + _OUTSIDE_COST * _outside(places, box, bounds)
                + _COVERED_POINT_COST * _covered(places, box, obstacles)
            )
            for other, centre in placed:
                cost += _OVERLAP_COST * _overlap(places, box, other, centre)
            for other in boxes:
                if other is not box:
                    cost += _OTHER_BALL_COST * _near(places, box, other)
            first = int(np.argmin(cost))
            if cost[first] < least:
                least, best = float(cost[first]), (float(places[first, 0]), float(places[first, 1]))
            if least < _OVERLAP_COST:
                break
        placed.append((box, best))
    return [centre for _, centre in placed]


def _around(box: Box, step: int) -> NDArray[np.float64]:
    """Return the places to try from a step away on, the nearest first, shape (m, 2)."""
    angle = 2.0 * np.pi * np.arange(_DIRECTIONS) / _DIRECTIONS + np.pi / 4.0
    steps = np.arange(step, step + _STEPS)
    away = box.clearance + 0.35 * steps[:, np.newaxis] * box.height
    x = box.anchor[0] + np.cos(angle) * (away + box.width / 2.0)
    y = box.anchor[1] + np.sin(angle) * (away + box.height / 2.0)
    return np.stack([x.ravel(), y.ravel()], axis=1)


def _outside(
    places: NDArray[np.float64], box: Box, bounds: tuple[float, float, float, float]
) -> NDArray[np.bool_]:
    left, right, bottom, top = bounds
    x, y = places.T
    beside = (x < left + box.width / 2.0) | (x > right - box.width / 2.0)
    return np.asarray(beside | (y < bottom + box.height / 2.0) | (y > top - box.height / 2.0))


def _covered(
    places: NDArray[np.float64], box: Box, obstacles: NDArray[np.float64]
) -> NDArray[np.int_]:
    """Count the obstacles under the label, with a margin."""
    away = np.abs(obstacles[np.newaxis] - places[:, np.newaxis])
    reach = 1.15 * np.array([box.width, box.height]) / 2.0
    return np.asarray(np.count_nonzero((away < reach).all(axis=2), axis=1))


def _overlap(
    places: NDArray[np.float64], box: Box, other: Box, centre: tuple[float, float]
) -> NDArray[np.bool_]:
    reach = 1.1 * np.array([box.width + other.width, box.height + other.height]) / 2.0
    return np.asarray((np.abs(places - centre) < reach).all(axis=1))


def _near(places: NDArray[np.float64], box: Box, other: Box) -> NDArray[np.bool_]:
    """Return a mask of the places that hide the ball of another label."""
    away = np.hypot(*(places - other.anchor).T)
    return np.asarray(away < 0.6 * other.clearance + box.height / 2.0)
