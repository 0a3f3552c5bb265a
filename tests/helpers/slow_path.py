"""A slow reference for scenes of any bodies, in plain doubles: it shares nothing with hoopgen.

The path is sampled densely; between samples every low point of a body's gap is looked at, and a
sign change is halved until nothing is left. Normals are differences of the gap.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

GRAVITY = 9.81


def everywhere(places: Floats) -> NDArray[np.bool_]:
    """Return that there are no bounds."""
    return np.ones(len(places), bool)


@dataclass(frozen=True)
class Wall:
    """A body: places (n, 3) to the gap, whether a place is within the bounds, and e."""

    body: int
    gap: Callable[[Floats], Floats]
    restitution: float
    within: Callable[[Floats], NDArray[np.bool_]] = everywhere


@dataclass(frozen=True)
class Slow:
    """Walls, the ball's radius, and the height at which a shot ends."""

    walls: Sequence[Wall]
    radius: float
    ground: float

    def fly(self, state: Floats, most: int) -> tuple[list[int], list[float], Floats]:
        """Return the bodies met in order, the ground being -1, their times, and the last state."""
        place, velocity, spin = state[:3].copy(), state[3:6].copy(), state[6:].copy()
        bodies: list[int] = []
        times: list[float] = []
        last, clock = -1, 0.0
        while len(bodies) < most:
            fall = velocity[2] ** 2 + 2 * GRAVITY * (place[2] - self.ground)
            end = (velocity[2] + np.sqrt(fall)) / GRAVITY
            hits = [self._hit(k, place, velocity, end, k == last) for k in range(len(self.walls))]
            first = min([t for t in hits if t is not None], default=end)
            clock += first
            place = _path(place, velocity, np.array([first]))[0]
            velocity = velocity - [0, 0, GRAVITY * first]
            times.append(clock)
            if first >= end:
                bodies.append(-1)
                break
            last = hits.index(first)
            bodies.append(self.walls[last].body)
            velocity, spin = self._bounce(self.walls[last], place, velocity, spin)
        return bodies, times, np.concatenate([place, velocity, spin])

    def _hit(
        self, k: int, place: Floats, velocity: Floats, end: float, leaving: bool
    ) -> float | None:
        wall = self.walls[k]

        def gap(t: Floats) -> Floats:
            return wall.gap(_path(place, velocity, t))

        early = np.geomspace(1e-7, 1e-2, 100) * min(end, 1.0)
        times = np.unique(np.concatenate([[0.0], early, np.linspace(0, end, 3000)]))
        gaps = gap(times)
        if leaving:
            gaps[0] = 0.0
        low = 1 + np.flatnonzero((gaps[1:-1] <= gaps[:-2]) & (gaps[1:-1] <= gaps[2:]))
        dips = [_lowest(gap, times[k - 1], times[k + 1]) for k in low if 0 < gaps[k] < 0.05]
        times = np.sort(np.concatenate([times, dips]))
        gaps = gap(times)
        for before, after in zip(times[:-1][_falls(gaps)], times[1:][_falls(gaps)], strict=True):
            if leaving and before == 0.0:
                continue
            root = _root(gap, before, after)
            if wall.within(_path(place, velocity, np.array([root])))[0]:
                return root
        return None

    def _bounce(
        self, wall: Wall, place: Floats, velocity: Floats, spin: Floats
    ) -> tuple[Floats, Floats]:
        """Two fifths of the slip are lost, and what the push is turns the ball."""
        steps = np.eye(3) * 1e-6
        normal = wall.gap(place + steps) - wall.gap(place - steps)
        normal /= np.linalg.norm(normal)
        arrival = velocity @ normal
        slip = velocity + np.cross(spin, -self.radius * normal)
        slip = slip - (slip @ normal) * normal
        push = -0.4 * slip
        after = velocity + push - (1 + wall.restitution) * arrival * normal
        return after, spin - 1.5 * np.cross(normal, push) / self.radius


def _path(place: Floats, velocity: Floats, times: Floats) -> Floats:
    there = place + velocity * times[:, None]
    there[:, 2] -= GRAVITY / 2 * times**2
    return there


def _falls(gaps: Floats) -> NDArray[np.bool_]:
    return (gaps[:-1] > 0) & (gaps[1:] <= 0)


def _lowest(gap: Callable[[Floats], Floats], low: float, high: float) -> float:
    for _ in range(8):
        times = np.linspace(low, high, 21)
        k = int(np.argmin(gap(times)))
        low, high = times[max(k - 1, 0)], times[min(k + 1, 20)]
    return float((low + high) / 2)


def _root(gap: Callable[[Floats], Floats], low: float, high: float) -> float:
    for _ in range(60):
        middle = (low + high) / 2
        if gap(np.array([middle]))[0] > 0:
            low = middle
        else:
            high = middle
    return high
