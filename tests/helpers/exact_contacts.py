"""Exact balls between contacts of the article's hoop, in balls of 200 bits.

Vectors are arrays (3, n) of such numbers. Errors have the coordinates of
`derive/errors/contact_frames.py`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from hoopgen import PAPER

flint = pytest.importorskip("flint")

Floats = NDArray[np.floating[Any]]
Exact = Any
RING, BOARD, BRIDGE, END = range(4)
BITS = 200
EXACT = np.vectorize(lambda number: flint.arb(float(number)), otypes=[object])
ROOT = np.vectorize(lambda ball: ball.sqrt(), otypes=[object])
MIDDLE = np.vectorize(lambda ball: ball.mid(), otypes=[object])

with flint.ctx.workprec(BITS):
    _SIZE = {name: flint.arb(float(value)) for name, value in PAPER.items()}
    RADIUS, CIRCLE, GRAVITY = _SIZE["ball_radius"], _SIZE["ring_radius"], _SIZE["gravity"]
    RESTITUTION = _SIZE["restitution"]
    REACH = RADIUS + _SIZE["wire_radius"]
    LEVELS = {BOARD: RADIUS - _SIZE["board_distance"], BRIDGE: REACH, END: -_SIZE["end_depth"]}
AXES = {BOARD: 0, BRIDGE: 2, END: 2}


def dot(a: Exact, b: Exact) -> Exact:
    """Return scalar products, (n,)."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Exact, b: Exact) -> Exact:
    """Return the vectors a × b."""
    return np.array([a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)], object)


def size(a: Exact) -> Floats:
    """Return Euclid's norms, rounded to doubles."""
    return np.array(ROOT(dot(a, a)), float)


@dataclass(frozen=True)
class Frame:
    """Frames of contacts: n, s and e, and the curvatures 1/R and 1/ρ."""

    n: Exact
    s: Exact
    e: Exact
    bend_s: Exact
    bend_e: Exact

    @classmethod
    def at(cls, which: NDArray[np.int_], place: Exact) -> Frame:
        """Return the frames at places, on the surfaces of these indices."""
        zero, one = 0 * place[0], 1 + 0 * place[0]
        ring = which == RING
        x, y, z = place
        rho = np.where(ring, ROOT(x * x + y * y), one)
        away = np.where(ring, ROOT((rho - CIRCLE) ** 2 + z * z), one)
        out = (rho - CIRCLE) / (away * rho)
        n = np.array([x * out, y * out, z / away], object)
        e = np.array([-y / rho, x / rho, zero], object)
        flat = [np.where(which == BOARD, one, zero), zero, zero]
        flat[2] = one - flat[0]
        n = np.where(ring, n, np.array(flat, object))
        e = np.where(ring, e, np.array([zero, one, zero], object))
        bends = (np.where(ring, value, zero) for value in (one / REACH, one / rho))
        return cls(n, cross(e, n), e, *bends)

    def of(self, vector: Exact) -> Exact:
        """Return the components of vectors."""
        return np.array([dot(axis, vector) for axis in (self.n, self.s, self.e)], object)

    def turning(self, q_s: Exact, q_e: Exact) -> Exact:
        """Return Ω q."""
        turn = self.e * (q_s * self.bend_s)
        turn[2] = turn[2] + q_e * self.bend_e
        return turn


COORDINATES = ("place_n", "place_s", "place_e", "pace_n", "pace_s", "pace_e", "turn_n")
"""The bounds of the coordinates but the last two, y_z along s and e, which have one bound."""


def errors_of(frame: Frame, q: Exact, v: Exact, w: Exact) -> tuple[Exact, Exact, Exact]:
    """Return the errors of place, velocity and spin that have given coordinates.

    Parameters
    ----------
    frame
        The frames.
    q
        q_n, q_s, q_e, y_n, y_s, y_e, y_w, and y_z along s and e, (9, n).
    v, w
        Velocity and spin after the contact.
    """
    q_n, q_s, q_e, y_n, y_s, y_e, y_w, z_s, z_e = q
    n, s, e = frame.n, frame.s, frame.e
    turn = frame.turning(q_s, q_e)
    along = s * y_s + e * y_e
    return (
        n * q_n + s * q_s + e * q_e,
        cross(turn, v) + n * y_n + along,
        cross(turn, w) + cross(n, along) / RADIUS + n * y_w + s * z_s + e * z_e,
    )


def coordinates_of(frame: Frame, dx: Exact, dv: Exact, dw: Exact, v: Exact, w: Exact) -> Exact:
    """Return the coordinates of errors, (9, n); the arguments are those of `errors_of`."""
    q = frame.of(dx)
    turn = frame.turning(q[1], q[2])
    y = frame.of(dv - cross(turn, v))
    along = frame.s * y[1] + frame.e * y[2]
    rest = frame.of(dw - cross(turn, w) - cross(frame.n, along) / RADIUS)
    return np.array([*q, *y, *rest], object)


def distance(which: NDArray[np.int_], place: Exact) -> Exact:
    """Return the signed distances from the surfaces of these indices."""
    ring = which == RING
    x, y, z = place
    rho = np.where(ring, ROOT(x * x + y * y), CIRCLE + 0 * x)
    far = ROOT(np.where(ring, (rho - CIRCLE) ** 2 + z * z, 1 + 0 * x)) - REACH
    flat = np.select([which == k for k in AXES], [place[AXES[k]] - LEVELS[k] for k in AXES], far)
    return np.where(ring, far, flat)


def flown(x: Exact, v: Exact, t: Exact) -> tuple[Exact, Exact]:
    """Return place and velocity after a flight."""
    there, moving = x + v * t, v + 0 * x
    there[2] = there[2] - GRAVITY * t * t / 2
    moving[2] = moving[2] - GRAVITY * t
    return there, moving


def arrival(which: NDArray[np.int_], x: Exact, v: Exact, t: Exact, level: Any = 0) -> Exact:
    """Return the times of contacts near given times, by Newton's method.

    Parameters
    ----------
    which
        The surfaces.
    x, v
        The starts.
    t
        The first times.
    level
        The distance from the surface at which the contact counts, (n,).
    """
    for turn in range(8):
        there, moving = flown(x, v, t)
        normal = Frame.at(np.where(which == END, BRIDGE, which), there).n
        step = MIDDLE((distance(which, there) - level) / dot(normal, moving))
        t = MIDDLE(t - step)
        if turn > 2 and np.all(np.abs(np.array(step, float)) < 2.0**-150):
            return t
    raise ValueError("a contact is not found")


def after_impact(n: Exact, v: Exact, w: Exact) -> tuple[Exact, Exact]:
    """Return velocity and spin after contacts of a thin shell without slip (Eq. 17)."""
    onto = dot(v, n)
    rolling = (3 * (v - n * onto) + 2 * RADIUS * cross(w, n)) / 5
    return rolling - n * (RESTITUTION * onto), cross(n, rolling) / RADIUS + n * dot(w, n)
