"""Exact balls at contacts with a box along the axes, in balls of 200 bits.

Vectors are arrays (3, n) of such numbers. The frames are those of the lemma "growth of errors" in
`derive/errors/contact_frames.py`, from the geometry alone; `exact_contacts` has their coordinates.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from tests.helpers import exact_contacts as exact
from tests.helpers.exact_contacts import EXACT, MIDDLE, ROOT, Exact, Floats, Frame, cross, dot


class ExactBox:
    """A box, as seen from the ball's centre.

    Parameters
    ----------
    low, high
        Its corners with the smallest and the largest coordinates.
    """

    def __init__(self, low: Sequence[float], high: Sequence[float]) -> None:
        self.low, self.high = (EXACT(np.array(c, float)[:, None]) for c in (low, high))

    def excess(self, place: Exact) -> Exact:
        """Return how far each coordinate is beyond a face, negative beyond the lower one."""
        above, below = place - self.high, place - self.low
        up, down = np.array(above, float) > 0, np.array(below, float) < 0
        return np.where(up, above, np.where(down, below, 0 * place))

    def away(self, place: Exact) -> Exact:
        """Return the distances from the box."""
        e = self.excess(place)
        return ROOT(dot(e, e))

    def distance(self, place: Exact) -> Exact:
        """Return the distances from the surface on which the ball's centre is at a contact."""
        return self.away(place) - exact.RADIUS

    def to_seam(self, place: Exact) -> Floats:
        """Return the distances from the nearest plane that a face lies in."""
        both = np.abs(np.array([place - self.high, place - self.low], float))
        return np.asarray(both.min(axis=(0, 1)))

    def on_surface(self, place: Exact) -> Exact:
        """Return the nearest places at contacts."""
        e = self.excess(place)
        return place + e * (exact.RADIUS / ROOT(dot(e, e)) - 1)

    def frame(self, place: Exact) -> Frame:
        """Return the frames of contacts at places."""
        e, zero, one = self.excess(place), 0 * place[0], 1 + 0 * place[0]
        n = e / ROOT(dot(e, e))
        bent = np.array(e, float) != 0
        tilted = bent[0] | bent[1]
        level = ROOT(np.where(tilted, n[0] ** 2 + n[1] ** 2, one))
        along = np.array(
            [np.where(tilted, -n[1] / level, zero), np.where(tilted, n[0] / level, one), zero],
            object,
        )
        per_radius = one / exact.RADIUS
        bend_s = np.where(tilted & bent[2], per_radius, zero)
        bend_e = np.where(bent[0] & bent[1], per_radius / level, zero)
        return Frame(n, cross(along, n), along, bend_s, bend_e)

    def arrival(self, x: Exact, v: Exact, t: Exact, level: Any = 0) -> Exact:
        """Return the times near given ones at which flights are at levels above the surface."""
        for turn in range(9):
            there, moving = exact.flown(x, v, t)
            e = self.excess(there)
            away = ROOT(dot(e, e))
            step = MIDDLE((away - exact.RADIUS - level) * away / dot(e, moving))
            t = MIDDLE(t - step)
            if turn > 2 and np.all(np.abs(np.array(step, float)) < 2.0**-150):
                return t
        raise ValueError("a contact is not found")
