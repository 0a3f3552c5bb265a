"""A ball that rolls on the ring, by a second formulation.

The engine rolls in Cartesian coordinates, in doubles, with series of order 8 that are put back onto
the surface. Here the motion is that of the ring's own coordinates, with 110 bits and order 24:
the angle a around the wire from outwards, by its cosine C and sine S, its rate A, the speed P along
the ring, the azimuth phi, and s, the ball's radius times its spin about the normal. With
Omega = P/rho,

    R A' = -P Omega S - (3/5) g C + (2/5) s Omega C,   P' = A (R Omega S - (2/5) s),
    s' = R_H A Omega,   N = g S - R A² - P Omega C.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from flint import arb, ctx
from numpy.typing import NDArray

Floats = NDArray[np.float64]

BITS = 110
ORDER = 24
SMALL = arb(2) ** -96
"""Size of the last terms of a series."""
LOOKED = np.linspace(0.0, 1.0, 33)
"""Shares of a step at which events are looked for."""
RING, BOARD, BRIDGE, END = range(4)
LEAVES = 4
"""Events of a ball that rolls on the ring; the first four have the log's numbers."""
TIME = -1
"""The time is up."""


def _mid(value: Any) -> arb:
    return arb(value).mid()


def _product(left: list[arb], right: list[arb], order: int) -> arb:
    return sum((left[k] * right[order - k] for k in range(order + 1)), arb(0)).mid()


def _at(row: list[arb], t: arb) -> arb:
    value = arb(0)
    for coefficient in reversed(row):
        value = value * t + coefficient
    return value.mid()


class Roll:
    """A ball that rolls on the ring from a state on, of which the normal speed does not count."""

    def __init__(self, state: Floats, scene: Mapping[str, float], since: float = 0.0) -> None:
        with ctx.workprec(BITS):
            self._start(state, scene, since)

    def _start(self, state: Floats, scene: Mapping[str, float], since: float) -> None:
        self.g, self.r_h = arb(scene["gravity"]), arb(scene["ring_radius"])
        self.r_b = arb(scene["ball_radius"])
        self.r = (self.r_b + arb(scene["wire_radius"])).mid()
        self.boxes = tuple(boxes(scene))
        self.end = float(scene["end_depth"])
        self.ball = float(scene["ball_radius"])
        x, y, z, vx, vy, vz, wx, wy, wz = (arb(float(part)) for part in state)
        rho = (x * x + y * y).sqrt()
        cos, sin = x / rho, y / rho
        away = ((rho - self.r_h) ** 2 + z * z).sqrt()
        c, s = (rho - self.r_h) / away, z / away
        outwards, along = vx * cos + vy * sin, vy * cos - vx * sin
        turn = (c * vz - s * outwards) / self.r
        spun = self.r_b * (c * (wx * cos + wy * sin) + s * wz)
        # cos a, sin a, A, P, s, azimuth
        self.now = [_mid(v) for v in (c, s, turn, along, spun, arb.atan2(y, x))]
        self.clock = arb(since)

    def series(self) -> list[list[arb]]:
        """Return the coefficients of what `now` has, and of N."""
        c, s, a, p, spun, phi = ([value] for value in self.now)
        rho_c: list[arb] = []
        near: list[arb] = []
        omega: list[arb] = []
        p_omega: list[arb] = []
        spun_omega: list[arb] = []
        omega_s: list[arb] = []
        push: list[arb] = []
        force: list[arb] = []
        for k in range(ORDER):
            rho_c.append((self.r * c[k] + (self.r_h if k == 0 else 0)).mid())
            if k:
                rest = sum((rho_c[i] * near[k - i] for i in range(1, k + 1)), arb(0))
                near.append((-near[0] * rest).mid())
            else:
                near.append((1 / rho_c[0]).mid())
            omega.append(_product(p, near, k))
            p_omega.append(_product(p, omega, k))
            spun_omega.append(_product(spun, omega, k))
            omega_s.append(_product(omega, s, k))
            push.append((self.r * omega_s[k] - arb(2) / 5 * spun[k]).mid())
            force.append(
                (self.g * s[k] - self.r * _product(a, a, k) - _product(p_omega, c, k)).mid()
            )
            turned = -_product(p_omega, s, k) - arb(3) / 5 * self.g * c[k]
            turned += arb(2) / 5 * _product(spun_omega, c, k)
            after = k + 1
            a_c, a_s = _product(a, c, k), _product(a, s, k)
            p.append((_product(a, push, k) / after).mid())
            spun.append((self.r_h * _product(a, omega, k) / after).mid())
            phi.append((omega[k] / after).mid())
            a.append((turned / self.r / after).mid())
            c.append((-a_s / after).mid())
            s.append((a_c / after).mid())
        return [c, s, a, p, spun, phi, force]

    def pace(self, rows: list[list[arb]]) -> arb:
        """Return a step after which the last terms are small."""
        steps = [arb(1) / 16]
        for k in (ORDER - 2, ORDER - 1):
            size = sum((abs(row[k]) for row in rows), arb(0))
            steps.append((SMALL / size).root(k) if size > 0 else steps[0])
        return _mid(min(steps, key=float))

    def state(self, rows: list[list[arb]] | None = None, t: arb | None = None) -> list[arb]:
        """Return x y z, vx vy vz, wx wy wz, now or on the series."""
        if rows is None or t is None:
            c, s, a, p, spun, phi = self.now
        else:
            c, s, a, p, spun, phi = (_at(row, t) for row in rows[:6])
        cos, sin = phi.cos(), phi.sin()
        rho = self.r_h + self.r * c
        n = (c * cos, c * sin, s)
        outwards = -self.r * a * s
        v = (outwards * cos - p * sin, outwards * sin + p * cos, self.r * a * c)
        w = [(n[i - 2] * v[i - 1] - n[i - 1] * v[i - 2] + spun * n[i]) / self.r_b for i in range(3)]
        return [_mid(part) for part in (rho * cos, rho * sin, self.r * s, *v, *w)]

    def until(self, limit: float) -> tuple[int, arb]:
        """Roll until something happens; return what, and when. `TIME` if it is the limit."""
        with ctx.workprec(BITS):
            while True:
                rows = self.series()
                step = self.pace(rows)
                left = _mid(arb(limit) - self.clock)
                step = min(step, left, key=float)
                found = self._first(rows, step)
                if found is not None:
                    what, step = found
                    self._move(rows, step)
                    return what, self.clock
                self._move(rows, step)
                if float(_mid(arb(limit) - self.clock)) <= 0:
                    return TIME, self.clock

    def _move(self, rows: list[list[arb]], step: arb) -> None:
        self.now = [_at(row, step) for row in rows[:6]]
        # Cosine and sine stay on the circle.
        size = (self.now[0] ** 2 + self.now[1] ** 2).sqrt()
        self.now[:2] = [_mid(value / size) for value in self.now[:2]]
        self.clock = _mid(self.clock + step)

    def _first(self, rows: list[list[arb]], step: arb) -> tuple[int, arb] | None:
        """Return the first event within a step and its time; None without one."""
        t = LOOKED * float(step)
        c, s, _, _, _, phi, force = (_values(row, t) for row in rows)
        rho = float(self.r_h) + float(self.r) * c
        there = np.stack([rho * np.cos(phi), rho * np.sin(phi), float(self.r) * s])
        signs = {LEAVES: force, END: there[2] + self.end}
        signs |= {
            k: _away(there, box) - self.ball
            for k, box in zip((BOARD, BRIDGE), self.boxes, strict=True)
        }
        happening: list[tuple[arb, int]] = []
        for what, values in signs.items():
            crossed = np.flatnonzero((values[:-1] > 0) & (values[1:] <= 0))
            if len(crossed):
                low, high = t[crossed[0]], t[crossed[0] + 1]
                happening.append((self._root(what, rows, low, high), what))
        if not happening:
            return None
        when, what = min(happening, key=lambda one: float(one[0]))
        return what, when

    def _root(self, what: int, rows: list[list[arb]], low: float, high: float) -> arb:
        """Bisect, then follow the secant."""
        a, b = arb(low), arb(high)
        at_a, at_b = self._sign(what, rows, a), self._sign(what, rows, b)
        for k in range(60):
            middle = _mid((a * at_b - b * at_a) / (at_b - at_a)) if k % 3 else _mid((a + b) / 2)
            value = self._sign(what, rows, middle)
            if abs(float(value)) < 2.0**-95 or float(b - a) < 2.0**-95:
                return middle
            if float(value) > 0:
                a, at_a = middle, value
            else:
                b, at_b = middle, value
        return _mid((a + b) / 2)

    def _sign(self, what: int, rows: list[list[arb]], t: arb) -> arb:
        if what == LEAVES:
            return _at(rows[6], t)
        place = self.state(rows, t)[:3]
        if what == END:
            return _mid(place[2] + arb(self.end))
        squared = arb(0)
        for p, low, high in zip(place, *self.boxes[what - BOARD], strict=True):
            off = max(arb(float(low)) - p, p - arb(float(high)), arb(0), key=float)
            squared += off * off
        return _mid(squared.sqrt() - self.r_b)


def _values(row: list[arb], t: Floats) -> Floats:
    return np.asarray(np.polynomial.polynomial.polyval(t, np.array([float(c) for c in row])))


def boxes(scene: Mapping[str, float]) -> Iterator[tuple[Floats, Floats]]:
    """Return the board and the bridge, by their lowest and highest corners."""
    p, front = scene, -scene["board_distance"]
    width, level = p["board_half_width"], p["wire_radius"]
    yield (
        np.array([front - p["board_thickness"], -width, p["board_bottom"]]),
        np.array([front, width, p["board_top"]]),
    )
    narrow = p["bridge_half_width"]
    yield (
        np.array([front, -narrow, level - p["bridge_depth"]]),
        np.array([-p["ring_radius"], narrow, level]),
    )


def _away(there: Floats, box: tuple[Floats, Floats]) -> Floats:
    low, high = (corner[:, None] for corner in box)
    off = np.maximum(np.maximum(low - there, there - high), 0)
    return np.asarray(np.sqrt(np.sum(off**2, axis=0)))


def fall(state: list[arb], scene: Mapping[str, float]) -> tuple[arb, list[arb]]:
    """Return when a ball in flight comes down to the end plane, and its state then."""
    with ctx.workprec(BITS):
        g, v = arb(scene["gravity"]), state[5]
        above = state[2] + arb(scene["end_depth"])
        t = _mid((v + (v * v + 2 * g * above).sqrt()) / g)
        moved = [p + u * t for p, u in zip(state[:3], state[3:6], strict=True)]
        moved[2] -= g * t * t / 2
        return t, [_mid(part) for part in (*moved, state[3], state[4], v - g * t, *state[6:])]
