"""Synthetic tracks of balls, whose releases are known."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import hoopgen

Floats = NDArray[np.float64]

SPIN = 18.0
"""rad/s, the backspin of all synthetic shots."""


@dataclass(frozen=True)
class Throws:
    """Free throws, and their first contacts."""

    states: Floats  # (n, 9)
    contact: Floats  # (n,), s
    made: NDArray[np.bool_]  # (n,)
    shots: hoopgen.Shots  # with the event log

    def positions(self, times: Floats) -> Floats:
        """Return the positions at times, (m,), as (n, m, 3); NaN after the end of a shot."""
        found = np.full((len(self.states), len(times), 3), np.nan)
        for row in range(len(self.states)):
            path = self.shots.trajectory(row)
            there = times <= path.duration
            found[row, there] = path.at(times[there])[:, :3]
        return found

    def in_flight(self, times: Floats) -> Floats:
        """Return the positions of the parabola at times, (m,), as (n, m, 3)."""
        since = times[None, :, None]
        fall = np.array([0.0, 0.0, -0.5 * hoopgen.NBA["gravity"]])
        start, velocity = self.states[:, None, :3], self.states[:, None, 3:6]
        return np.asarray(start + velocity * since + fall * since**2)


def throws(count: int, seed: int) -> Throws:
    """Return free throws of a player with some scatter."""
    random = np.random.default_rng(seed)
    states = hoopgen.release(
        random.normal(7.17, 0.1, count),
        np.radians(random.normal(52.0, 2.0, count)),
        np.radians(random.normal(0.0, 1.5, count)),
        SPIN,
        height=2.1336,
        distance=4.191,
    )
    shots = hoopgen.simulate(states, hoopgen.NBA, record=True)
    first = hoopgen.simulate(states, hoopgen.NBA, max_contacts=1)
    return Throws(states, first.time, shots.made, shots)


def noisy(positions: Floats, noise: float, seed: int) -> Floats:
    """Return positions with normal errors."""
    return positions + np.random.default_rng(seed).normal(0.0, noise, positions.shape)


def with_hand(
    thrown: Throws, rate: float, until: float, hand: float = 0.15, rest: float = 0.1
) -> tuple[Floats, Floats]:
    """Return times, (m,), and positions that begin in a hand, which accelerates from rest.

    Parameters
    ----------
    rate
        Hz; there is a frame at the release, time 0.
    until
        s, of the last frame.
    hand
        s, for which the hand accelerates evenly.
    rest
        s, for which the ball rests before.
    """
    before = np.arange(-round((hand + rest) * rate), 0) / rate
    since = np.minimum(-before, hand)
    way = (since - since**2 / (2.0 * hand))[None, :, None]
    held = thrown.states[:, None, :3] - thrown.states[:, None, 3:6] * way
    after = np.arange(round(until * rate)) / rate
    positions = np.concatenate([held, thrown.positions(after)], axis=1)
    return np.concatenate([before, after]), positions
