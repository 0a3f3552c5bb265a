"""Shots in air to 35 digits: the equations of motion as they are written in the documentation.

The flight is a Taylor series of degree `DEGREE` in steps that leave out about 1e-32; nothing of
it is taken from the derivation. What happens at a contact is that of `precise_path`.
"""

from __future__ import annotations

from collections.abc import Sequence
from operator import mul
from typing import Any

from flint import arb

from .precise_path import PreciseScene, Vector, middle

DIGITS = 39
"""Digits of the numbers; flights leave out what makes about 35 of them right."""

DEGREE = 28
_LEFT_OUT = 1e-32


class PreciseAir(PreciseScene):
    """The formulas of a scene in air as functions of numbers of many digits."""

    digits = DIGITS
    step = 1e-12

    def fly(self, duration: Any, now: Vector, inputs: Vector) -> list[Any]:
        """Return position and velocity after a flight of some duration."""
        if self._flown is None or self._flown[0] != (now, inputs):
            self._flown = ((now, inputs), self._pieces(now, inputs, 1.01 * float(duration)))
        pieces = self._flown[1]
        begun, places, speeds = next(
            (piece for piece in reversed(pieces) if piece[0] <= duration), pieces[0]
        )
        return [_at(row, duration - begun) for row in (*places, *speeds)]

    _flown: tuple[Any, list[Any]] | None = None

    def _pieces(self, now: Vector, inputs: Vector, until: float) -> list[Any]:
        """Return where the pieces of a flight begin, with polynomials of places and velocities."""
        of = dict(zip(self.names, inputs, strict=True))
        radius, mass, density = of["ball_radius"], of["ball_mass"], of["air_density"]
        half = density * arb.pi() * radius**2 / (2 * mass)
        drag = half * of["drag_coefficient"]
        turn = [half * radius * of["lift_coefficient"] * w for w in now[6:]]
        fall = -of["gravity"] * (1 - density * 4 * arb.pi() * radius**3 / (3 * mass))
        state, begun, pieces = now[:6], arb(0), []
        while float(begun) <= until:
            v = _series(state[3:], drag, turn, fall, of["drag_smoothing_speed"])
            x = [
                [c, *(one / (k + 1) for k, one in enumerate(row))]
                for c, row in zip(state[:3], v, strict=True)
            ]
            size = max(float(abs(row[k])) ** (1 / k) for row in v for k in (DEGREE - 1, DEGREE))
            step = arb(_LEFT_OUT ** (1 / DEGREE) / size)
            pieces.append((begun, *([list(map(middle, row)) for row in rows] for rows in (x, v))))
            state = [middle(_at(row, step)) for row in (*x, *v)]
            begun = middle(begun + step)
        return pieces


def _series(
    start: Sequence[arb], drag: arb, turn: Sequence[arb], fall: arb, smoothing: arb
) -> list[list[arb]]:
    """Return the Taylor coefficients of the velocity: v' = g - k_d σ v + Ω × v."""
    v = [[component] for component in start]
    speeds: list[arb] = []
    for k in range(DEGREE):
        square = sum((_convolved(row, row, 0, k) for row in v), arb(0))
        if k == 0:
            speeds.append((square + smoothing**2).sqrt())
        else:
            speeds.append((square - _convolved(speeds, speeds, 1, k - 1)) / (2 * speeds[0]))
        braked = [_convolved(speeds, row, 0, k) for row in v]
        x, y, z = (row[k] for row in v)
        cross = (turn[1] * z - turn[2] * y, turn[2] * x - turn[0] * z, turn[0] * y - turn[1] * x)
        for axis, row in enumerate(v):
            force = cross[axis] - drag * braked[axis] + (fall if k == 0 and axis == 2 else 0)
            row.append((force / (k + 1)).mid())
    return v


def _convolved(first: Sequence[arb], second: Sequence[arb], low: int, high: int) -> arb:
    """Return the sum of products of the terms from `low` to `high`, of the second backwards."""
    return sum(map(mul, first[low : high + 1], second[low : high + 1][::-1]), arb(0))


def _at(coefficients: Sequence[arb], time: arb) -> arb:
    value = arb(0)
    for one in reversed(coefficients):
        value = value * time + one
    return value
