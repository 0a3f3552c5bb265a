"""Contact of balls with the body that they leave at the start, by places all around them."""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

import numpy as np
from numpy.typing import NDArray

Bools = NDArray[np.bool_]
Floats = NDArray[np.float64]

MAX_START_GAP = 2.0**-10
"""Largest distance between a ball and the body that it leaves at the start, by the ball's radius:
positions with four digits are nearer."""

_CORNERS_FIRST = sorted(product((-1, 0, 1), repeat=3), key=lambda way: -sum(map(abs, way)))
_WAYS = [np.array(way) / np.linalg.norm(way) for way in _CORNERS_FIRST if any(way)]
"""The 26 unit vectors to corners, edges and faces of a cube. No direction is more than 28 degrees
from all of them, so that a flat surface nearer than 7/8 of the largest distance is found."""
WAYS = len(_WAYS)


def around(states: Floats, ball_radius: Floats, way: int) -> Floats:
    """Return states at rest, each as far from its own place as a ball may be from a body it leaves.

    Parameters
    ----------
    states
        States at the start, (n, 9).
    ball_radius
        Radius of the ball, m, (n,).
    way
        The direction, one of `WAYS`.
    """
    moved = np.zeros_like(states)
    moved[:, :3] = states[:, :3] + MAX_START_GAP * ball_radius[:, None] * _WAYS[way]
    return moved


def start_contact(
    states: Floats,
    ball_radius: Floats,
    overlap: Callable[[NDArray[np.int64], Floats], tuple[Bools, Bools]],
) -> tuple[Bools, Bools]:
    """Return which balls are away from the body that they leave, and which are inside it.

    A ball touches the body if it overlaps it at one of the places around its own, and does not at
    another one. Near other bodies that may not be known, and then it counts as touching.

    Parameters
    ----------
    states
        States at the start, (n, 9).
    ball_radius
        Radius of the ball, m, (n,).
    overlap
        Function of some of the balls, (k,), and states in their place, (k, 9): whether each may
        overlap the body that it leaves there, and whether it may be clear of it.
    """
    overlaps, clear = np.zeros((2, len(states)), np.bool_)
    rows = np.arange(len(states))
    for way in range(WAYS):
        moved = around(states[rows], ball_radius[rows], way)
        may_overlap, may_be_clear = overlap(rows, moved)
        overlaps[rows] |= may_overlap
        clear[rows] |= may_be_clear
        rows = rows[~(overlaps[rows] & clear[rows])]
        if not len(rows):
            break
    return ~overlaps, ~clear
