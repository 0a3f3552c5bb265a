"""Balls that roll on the ring, by a second formulation: `python -m benchmarks.rolling`.

The engine rolls in Cartesian coordinates, in doubles, with series of order 8 that are put back onto
the surface. Here the motion is that of the ring's own coordinates, with 110 bits and order 24:
the angle a around the wire from outwards, by its cosine C and sine S, its rate A, the speed P along
the ring, the azimuth phi, and s, the ball's radius times its spin about the normal. With
Omega = P/rho,

    R A' = -P Omega S - (3/5) g C + (2/5) s Omega C,   P' = A (R Omega S - (2/5) s),
    s' = R_H A Omega,   N = g S - R A² - P Omega C.

Exit status 1 if a shot that is not flagged ends its contact otherwise, or is further off than the
engine claims.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from flint import arb, ctx
from hoopgen.generated.numpy.court import Event
from numpy.typing import NDArray

import hoopgen
from benchmarks.workloads import free_throw
from hoopgen import COURT, PAPER_COURT

Floats = NDArray[np.float64]

BITS = 110
ORDER = 24
SMALL = arb(2) ** -96
"""What the last terms of a series come to."""
LOOKED = np.linspace(0.0, 1.0, 33)
"""Where in a step is looked whether something has happened."""
RING, BOARD, BRIDGE, END = range(4)
LEAVES = 4
"""What can happen to a ball that rolls on the ring; the first four by their numbers in the log."""
TIME = -1
"""The time is up."""

NBA = PAPER_COURT | {name: value for name, value in hoopgen.NBA.items() if name in PAPER_COURT}


def elastic(restitution: float) -> Mapping[str, float]:
    """Return the sizes of the NBA's hoop, with perfect grip and one restitution."""
    return NBA | {f"{body}_restitution": restitution for body in COURT.surfaces}


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
        self.boxes = tuple(_boxes(scene))
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
        """Return what happens first within a step, and when, if anything does."""
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
    return np.polynomial.polynomial.polyval(t, np.array([float(c) for c in row]))


def _boxes(scene: Mapping[str, float]) -> Iterator[tuple[Floats, Floats]]:
    """The board and the bridge, by their lowest and highest corners."""
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
    return np.sqrt(np.sum(off**2, axis=0))


def fall(state: list[arb], scene: Mapping[str, float]) -> tuple[arb, list[arb]]:
    """Return when a ball in flight comes down to the end plane, and its state then."""
    with ctx.workprec(BITS):
        g, v = arb(scene["gravity"]), state[5]
        above = state[2] + arb(scene["end_depth"])
        t = _mid((v + (v * v + 2 * g * above).sqrt()) / g)
        moved = [p + u * t for p, u in zip(state[:3], state[3:6], strict=True)]
        moved[2] -= g * t * t / 2
        return t, [_mid(part) for part in (*moved, state[3], state[4], v - g * t, *state[6:])]


@dataclass
class Found:
    """What the comparison of shots has found.

    `ends` counts how contacts end; `errors` are the largest differences of time, position, velocity
    and spin (s, m, m/s, rad/s) where a shot is not flagged, and `ratios` their largest shares of
    what the engine claims; `wrong` are the shots that end otherwise, or are further off, with what
    is wrong.
    """

    shots: int = 0
    flagged: int = 0
    flagged_wrong: int = 0
    ends: dict[str, int] = field(default_factory=dict)
    errors: Floats = field(default_factory=lambda: np.zeros(4))
    ratios: Floats = field(default_factory=lambda: np.zeros(4))
    leaving: float = 0.0
    wrong: list[tuple[str, list[str]]] = field(default_factory=list)


NAMES = {LEAVES: "leaves", END: "end plane", BOARD: "board", BRIDGE: "bridge", TIME: "time limit"}


def compare(
    states: Floats, scene: Mapping[str, float], time_limit: float, most: int, found: Found
) -> None:
    """Roll the shots that settle on the ring a second time, until `most` are compared in all."""
    shots = hoopgen.simulate(
        states,
        scene,
        scene=COURT,
        time_limit=time_limit,
        record=True,
        fields=tuple(COURT.layout.results),
    )
    log = shots.events
    for row in np.flatnonzero((log["kind"] == Event.ROLL) & (log["surface"] == RING)):
        shot = int(log["shot"][row])
        first = np.searchsorted(log["shot"], shot)
        if np.any(log["kind"][first:row] == Event.ROLL) or found.shots == most:
            continue
        found.shots += 1
        rest = log[row : np.searchsorted(log["shot"], shot, side="right")]
        what, errors, claimed, late = _again(shots, shot, rest, states[shot], scene, time_limit)
        flagged = bool(shots.uncertain[shot])
        found.flagged += flagged
        bad = [what] if what else []
        if not flagged and not bad:
            ratios = np.divide(errors, claimed, out=np.zeros(4), where=errors > 0)
            found.errors = np.maximum(found.errors, errors)
            found.ratios = np.maximum(found.ratios, ratios)
            found.leaving = max(found.leaving, late)
            bad = ["further off than claimed"] if np.any(ratios > 1) else []
        if flagged:
            found.flagged_wrong += bool(bad)
        elif bad:
            found.wrong.append((bad[0], [float(part).hex() for part in states[shot]]))
        name = NAMES[_ended(rest, shots.outcome[shot])]
        found.ends[name] = found.ends.get(name, 0) + 1


def _ended(rest: NDArray[Any], outcome: int) -> int:
    """Return what the engine's log has the contact end with."""
    after = rest[1]
    if after["kind"] == Event.LEAVE:
        return LEAVES
    if after["kind"] == Event.END and outcome == COURT.outcomes["ENDLESS"]:
        return TIME
    return int(after["surface"])


def _again(
    shots: hoopgen.Shots,
    shot: int,
    rest: NDArray[Any],
    release: Floats,
    scene: Mapping[str, float],
    time_limit: float,
) -> tuple[str, Floats, Floats, float]:
    """Roll one shot; return what differs, its errors, the claimed ones, and that of the leaving."""
    expected = _ended(rest, shots.outcome[shot])
    begun, over = rest[0], float(rest[1]["time"])
    roll = Roll(begun["after"], scene, float(begun["time"]))
    limit = time_limit if expected == TIME else min(over + 1e-3, time_limit)
    what, when = roll.until(limit)
    if what != expected:
        return f"{NAMES[what]}, not {NAMES[expected]}", np.zeros(4), np.zeros(4), 0.0
    late = abs(float(when - arb(over)))
    state = roll.state()
    ended = rest[1]
    if expected == LEAVES and len(rest) == 3:
        flown, state = fall(state, scene)
        when, ended = when + flown, rest[2]
    elif expected in (LEAVES, BOARD, BRIDGE):
        return "", *_before(over, begun, release, scene), late
    inside = float(state[0] ** 2 + state[1] ** 2) < scene["ring_radius"] ** 2
    if expected != TIME and inside != bool(shots.made[shot]):
        return "made or missed", np.zeros(4), np.zeros(4), 0.0
    errors = _errors(state, when, ended["after"], float(ended["time"]))
    claimed = np.array([shots.time_error[shot], *shots.state_error[shot]])
    return "", errors, claimed, late


def _before(
    over: float, begun: Any, release: Floats, scene: Mapping[str, float]
) -> tuple[Floats, Floats]:
    """Compare a moment before the contact ends, where more follows than a flight to the end."""
    limit = over - min(1e-9, (over - float(begun["time"])) / 2)
    stopped = hoopgen.simulate(
        release, scene, scene=COURT, time_limit=limit, fields=tuple(COURT.layout.results)
    )
    roll = Roll(begun["after"], scene, float(begun["time"]))
    _, when = roll.until(limit)
    errors = _errors(roll.state(), when, stopped.state[0], float(stopped.time[0]))
    return errors, np.array([stopped.time_error[0], *stopped.state_error[0]])


def _errors(state: list[arb], when: arb, there: Floats, time: float) -> Floats:
    off = [abs(float(own - arb(float(other)))) for own, other in zip(state, there, strict=True)]
    return np.array([abs(float(when - arb(time))), *(max(off[k : k + 3]) for k in (0, 3, 6))])


@dataclass(frozen=True)
class Bounce:
    """A bounce of a sequence that settles, and rolling from it.

    Its speed V off the ring, m/s; how far the ball that rolls from it is from the limit of the
    sequence, by V², s²/m; and the same by 2 F V²/(N² (1 - e²)), which it tends to.
    """

    speed: float
    by_square: float
    by_limit: float


def bounces(states: Floats, restitution: float) -> Iterator[Bounce]:
    """Roll from every bounce of the sequences that settle on the ring."""
    scene = elastic(restitution)
    shots = hoopgen.simulate(states, scene, scene=COURT, time_limit=3.0, record=True)
    log = shots.events
    for row in np.flatnonzero((log["kind"] == Event.ROLL) & (log["surface"] == RING)):
        limit, time = log["after"][row], float(log["time"][row])
        place = row - 1
        while place > 0 and _same_sequence(log[place], log[row]):
            one = _bounce(log[place], limit, time, scene, restitution)
            place -= 1
            if one is not None:
                yield one


def _same_sequence(impact: Any, roll: Any) -> bool:
    return bool(
        impact["shot"] == roll["shot"]
        and impact["kind"] == Event.IMPACT
        and impact["surface"] == RING
    )


def _bounce(
    impact: Any, limit: Floats, time: float, scene: Mapping[str, float], restitution: float
) -> Bounce | None:
    after = impact["after"]
    rho = np.hypot(after[0], after[1])
    normal = np.array([*(after[:2] * (1 - scene["ring_radius"] / rho)), after[2]])
    normal /= np.linalg.norm(normal)
    speed = float(after[3:6] @ normal)
    if not 1e-4 < speed < 0.1:
        return None
    roll = Roll(after, scene, float(impact["time"]))
    what, _ = roll.until(time)
    if what != TIME:
        return None
    off = np.array([float(own - arb(float(x))) for own, x in zip(roll.state(), limit, strict=True)])
    force, friction = _forces(limit, scene)
    by_square = float(np.linalg.norm(off[:3])) / speed**2
    return Bounce(speed, by_square, by_square * force**2 * (1 - restitution**2) / (2 * friction))


def _forces(state: Floats, scene: Mapping[str, float]) -> tuple[float, float]:
    """Return normal force and friction of a ball that rolls on the ring, per unit mass."""
    place, v, w = state.reshape(3, 3)
    rho = np.hypot(place[0], place[1])
    e = np.array([place[0] / rho, place[1] / rho, 0.0])
    over = np.array([-e[1], e[0], 0.0])
    n = place - scene["ring_radius"] * e
    n /= np.linalg.norm(n)
    reach = scene["ball_radius"] + scene["wire_radius"]
    turning = (v - scene["ring_radius"] * (v @ over / rho) * over) / reach
    up = np.array([0.0, 0.0, scene["gravity"]])
    pushed = up + scene["ball_radius"] * np.cross(w, turning)
    friction = 2 / 5 * (pushed - pushed @ n * n)
    return float(up @ n - v @ turning), float(np.linalg.norm(friction))


KINDS = ((0.7, 1 << 19), (0.5, 1 << 16), (0.3, 1 << 16))
"""Restitutions, and how many free throws there are of each at most."""
CHUNK = 1 << 13


def settled(shots: int) -> Found:
    """Compare so many free throws that settle, a third of each restitution if there are as many."""
    found = Found()
    for k, (restitution, throws) in enumerate(KINDS):
        most = -(-shots * (k + 1) // len(KINDS))
        states = free_throw(throws)
        for low in range(0, throws, CHUNK):
            if found.shots < most:
                compare(states[low : low + CHUNK], elastic(restitution), 6.0, most, found)
    return found


def main() -> None:
    """Compare, and say what was found."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.rolling",
        description="Rolling on the ring, held against a second formulation with 110 bits.",
    )
    parser.add_argument("--shots", type=int, default=2_000, help="that settle, default 2,000")
    found = settled(parser.parse_args().shots)
    for name, value in vars(found).items():
        print(f"{name}: {value}")
    sys.exit(bool(found.wrong))


if __name__ == "__main__":
    main()
