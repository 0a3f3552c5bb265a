"""What tests share: the engines they are replayed on, shots of every kind, a slow true answer."""

from __future__ import annotations

import contextlib
import signal
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal, localcontext
from functools import partial
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen.engine import native
from hoopgen.engines import HOOP

Simulate = Callable[..., hoopgen.Shots]
Vector = list[Decimal]

if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    # A shell's job in the background ignores Ctrl-C, and so would what tests start and stop.
    signal.signal(signal.SIGINT, signal.default_int_handler)

# ---------------------------------------------------------------------------------------- engines

ENGINES = ("numpy", "c", *(f"c, {width} abreast" for width in native.WIDTHS))


@dataclass(frozen=True)
class _OfWidth:
    """The C engine, held to one vector width."""

    library: native.Library
    width: int

    def run(self, *arguments: Any, **options: Any) -> None:
        self.library.run(*arguments, **options, width=self.width)


def _simulate_on(engine: str) -> Simulate:
    if engine == "numpy":
        return partial(hoopgen.simulate, backend="numpy")
    library = HOOP.library
    if library is None:
        pytest.skip("the C engine was not built")
    if engine == "c":
        return partial(hoopgen.simulate, backend="c")
    held = _OfWidth(library, int(engine.split()[1]))

    def simulate(*arguments: Any, **options: Any) -> hoopgen.Shots:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(HOOP, "found", held)
            return hoopgen.simulate(*arguments, backend="c", **options)

    try:
        simulate([0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    except ValueError:
        pytest.skip("this processor does not have the width")
    return simulate


@pytest.fixture(scope="session", params=ENGINES)
def simulate(request: pytest.FixtureRequest) -> Simulate:
    """`hoopgen.simulate` on one engine; every test that asks for it is run on each."""
    return _simulate_on(request.param)


def engines_here() -> dict[str, Simulate]:
    """Give those of the engines that this build and this processor have."""
    there = {}
    for engine in ENGINES:
        with contextlib.suppress(pytest.skip.Exception):
            there[engine] = _simulate_on(engine)
    return there


# ------------------------------------------------------------------------------------------ shots


@dataclass(frozen=True)
class Batch:
    """Releases, and what they are simulated with."""

    states: NDArray[np.float64]
    parameters: Mapping[str, Any]

    def __len__(self) -> int:
        return len(self.states)

    def take(self, rows: Any) -> Batch:
        """Give some of the shots, with their own parameters."""
        own = {n: v[rows] if np.ndim(v) else v for n, v in self.parameters.items()}
        return Batch(self.states[rows], own)


def _rows(count: int, **columns: Any) -> NDArray[np.float64]:
    names = ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")
    return np.stack([np.broadcast_to(columns.get(n, 0.0), count) for n in names], axis=1)


def _families(count: int, seed: int) -> dict[str, NDArray[np.float64]]:
    """Give shots of each kind, by name: what players do, and what they do not."""
    random = np.random.default_rng(seed)
    gauss, between = random.standard_normal, random.uniform
    degree, foot = np.pi / 180, 0.3048
    around, off_axis = between(-np.pi, np.pi, count), between(0.0, 0.5, count)
    return {
        "free throw": hoopgen.release(
            7.166 * (1 + 0.015 * gauss(count)),
            (51.1 + 1.5 * gauss(count)) * degree,
            gauss(count) * degree,
            19 + 4 * gauss(count),
            gauss(count),
            height=8 * foot,
            distance=13.75 * foot,
        ),
        "bank shot": hoopgen.release(
            6.8 + 0.3 * gauss(count),
            (55 + 2 * gauss(count)) * degree,
            (-8 + 3 * gauss(count)) * degree,
            10 * gauss(count),
            height=2.2,
            distance=3.0,
            angle=(45 + 10 * gauss(count)) * degree,
        ),
        "swirl": _rows(
            count,
            x=0.75 * foot,
            y=-3.1 * foot,
            z=-2 * foot,
            vx=-2.75 * foot * (1 + 1e-3 * gauss(count)),
            vy=7.0 * foot * (1 + 1e-3 * gauss(count)),
            vz=12.65 * foot * (1 + 1e-3 * gauss(count)),
            wz=2 * random.random(count),
        ),
        "drop": _rows(
            count,
            x=off_axis * np.cos(around),
            y=off_axis * np.sin(around),
            z=between(0.15, 2.0, count),
            **dict(zip(("vx", "vy", "vz"), 0.3 * gauss((3, count)), strict=True)),
            **dict(zip(("wx", "wy", "wz"), 20 * gauss((3, count)), strict=True)),
        ),
        "bridge": _rows(
            count,
            x=between(-0.2597, -0.235, count),
            y=between(-0.08, 0.08, count),
            z=between(0.1313, 0.6, count),
            **dict(zip(("vx", "vy"), 0.3 * gauss((2, count)), strict=True)),
            vz=gauss(count),
        ),
        "from behind the board": _rows(
            count,
            x=between(-2.0, -0.51, count),
            y=between(-0.5, 0.5, count),
            z=between(-0.8, 1.0, count),
            vx=between(0.5, 4.0, count),
            vy=0.3 * gauss(count),
            vz=4 + 1.5 * gauss(count),
        ),
        "anywhere": _rows(
            count,
            x=between(-1.5, 3.0, count),
            y=between(-1.5, 1.5, count),
            z=between(-1.0, 1.5, count),
            **dict(zip(("vx", "vy"), 3 * gauss((2, count)), strict=True)),
            vz=2 + 4 * gauss(count),
            **dict(zip(("wx", "wy", "wz"), 30 * gauss((3, count)), strict=True)),
        ),
    }


@pytest.fixture(scope="session")
def families() -> Callable[[int, int], dict[str, NDArray[np.float64]]]:
    """Shots by kind: so many of each, from a seed."""
    return _families


@pytest.fixture(scope="session")
def mixed() -> Batch:
    """Over 2e4 shots of all kinds, a tenth with a hoop of their own."""
    # Kind after kind, so that NumPy's blocks of long shots are few.
    states = np.concatenate(list(_families(3000, seed=20130515).values()))
    random = np.random.default_rng(17)
    others = random.random(len(states)) < 0.1
    spread = {
        "ball_radius": (0.10, 0.13),
        "ring_radius": (0.20, 0.30),
        "board_distance": (0.35, 0.45),
        "bridge_half_width": (0.01, 0.30),
        "restitution": (0.0, 1.0),
        "gravity": (1.6, 25.0),
        "end_depth": (0.01, 0.12),
    }
    parameters = dict(hoopgen.PAPER)
    for name, (low, high) in spread.items():
        own = random.uniform(low, high, len(states))
        parameters[name] = np.where(others, own, hoopgen.PAPER[name])
    return Batch(states, parameters)


# ------------------------------------------------------------------------- the slow true answer


@dataclass(frozen=True)
class Flown:
    """A shot to 50 digits: outcome, (surface, time) of every event, and the state at the last."""

    outcome: str
    events: tuple[tuple[str, Decimal], ...]
    time: Decimal
    state: tuple[Decimal, ...]


def _norm(vector: Sequence[Decimal]) -> Decimal:
    return sum((c * c for c in vector), Decimal(0)).sqrt()


def _dot(left: Sequence[Decimal], right: Sequence[Decimal]) -> Decimal:
    return sum((a * b for a, b in zip(left, right, strict=True)), Decimal(0))


def _cross(a: Vector, b: Vector) -> Vector:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


class _March:
    """The article's method, to 50 digits: march until a distance changes its sign, then bisect.

    The distances are those of Table 2 as they stand, with their roots. A stride is the longest
    that can reach no surface: with d the distance, d' its rate and d'' >= -K, that is the root of
    d + d' s - K s²/2. Contacts go through the frame of Eqs. 7-10. The engines do none of this.
    """

    SURFACES = ("ring", "backboard", "bridge", "end")
    SHORTEST = Decimal("1e-20")
    NARROW = Decimal("1e-45")

    def __init__(self, parameters: Mapping[str, float]) -> None:
        self.given = {name: Decimal(float(value)) for name, value in parameters.items()}
        self.reach = self.given["ball_radius"] + self.given["wire_radius"]

    def distance(self, surface: str, at: Vector) -> Decimal:
        given = self.given
        if surface == "ring":
            return _norm([_norm(at[:2]) - given["ring_radius"], at[2]]) - self.reach
        if surface == "backboard":
            return at[0] + given["board_distance"] - given["ball_radius"]
        return at[2] - self.reach if surface == "bridge" else at[2] + given["end_depth"]

    def normal(self, surface: str, at: Vector) -> Vector:
        if surface != "ring":
            return [Decimal(c) for c in ((1, 0, 0) if surface == "backboard" else (0, 0, 1))]
        rho = _norm(at[:2])
        centre = [self.given["ring_radius"] * c / rho for c in at[:2]]
        out = [at[0] - centre[0], at[1] - centre[1], at[2]]
        return [c / _norm(out) for c in out]

    def counts(self, surface: str, at: Vector) -> bool:
        x, y, z = at
        given = self.given
        if surface == "backboard":
            return abs(y) <= given["board_half_width"] and (
                given["board_bottom"] <= z <= given["board_top"]
            )
        if surface == "bridge":
            outside = _norm(at[:2]) >= given["ring_radius"]
            on = -given["board_distance"] <= x <= 0
            return abs(y) <= given["bridge_half_width"] and outside and on
        return True

    def bounce(self, normal: Vector, velocity: Vector, spin: Vector) -> tuple[Vector, Vector]:
        radius = self.given["ball_radius"]
        axis = min(range(3), key=lambda k: abs(normal[k]))
        tangent = [int(k == axis) - normal[axis] * normal[k] for k in range(3)]
        first = [c / _norm(tangent) for c in tangent]
        frame = (first, _cross(normal, first), normal)
        (v1, v2, v3), (w1, w2, w3) = ([_dot(n, u) for n in frame] for u in (velocity, spin))
        v1, v2 = (3 * v1 + 2 * radius * w2) / 5, (3 * v2 - 2 * radius * w1) / 5
        local = ([v1, v2, -self.given["restitution"] * v3], [-v2 / radius, v1 / radius, w3])
        after = [[_dot(row, u) for row in zip(*frame, strict=True)] for u in local]
        return after[0], after[1]

    def next_event(
        self, position: Vector, velocity: Vector, last: str | None
    ) -> tuple[str, Decimal] | None:
        gravity = self.given["gravity"]
        bottom = 1 + max(self.reach, -self.given["board_bottom"], self.given["end_depth"])
        room = velocity[2] ** 2 + 2 * gravity * (position[2] + bottom)
        if room <= 0:
            return None
        latest = (velocity[2] + room.sqrt()) / gravity
        fastest = _norm([*velocity[:2], max(abs(velocity[2]), abs(velocity[2] - gravity * latest))])
        bends = dict.fromkeys(self.SURFACES, gravity) | {"backboard": Decimal(0)}
        # Round the ring's hole the distance bends down by 1/rho at most, rho >= R_H - R.
        bends["ring"] += fastest**2 / (self.given["ring_radius"] - self.reach)

        def there(t: Decimal) -> Vector:
            x, y, z = (p + v * t for p, v in zip(position, velocity, strict=True))
            return [x, y, z - gravity * t * t / 2]

        now, at = Decimal(0), position
        gaps = {surface: self.distance(surface, at) for surface in self.SURFACES}
        if last is not None:
            gaps[last] = Decimal(0)
        while now < latest:
            moving = [velocity[0], velocity[1], velocity[2] - gravity * now]
            stride = latest
            for surface, gap in gaps.items():
                on_axis = surface == "ring" and not _norm(at[:2])
                rate = -_norm(moving) if on_axis else _dot(self.normal(surface, at), moving)
                bend = bends[surface]
                if gap >= 0 and bend:
                    stride = min(stride, (rate + (rate * rate + 2 * bend * gap).sqrt()) / bend)
                elif gap * rate < 0:
                    stride = min(stride, -gap / rate)
            then = now + max(stride if now else stride / 2, self.SHORTEST)
            at = there(then)
            ahead = {surface: self.distance(surface, at) for surface in self.SURFACES}
            found = []
            for surface in self.SURFACES:
                assert not (now == 0 and surface == last and ahead[surface] < 0), "rests"
                if ahead[surface] <= 0 < gaps[surface]:
                    low, high = now, then
                    while high - low > self.NARROW:
                        middle = (low + high) / 2
                        outside = self.distance(surface, there(middle)) > 0
                        low, high = (middle, high) if outside else (low, middle)
                    if self.counts(surface, there(high)):
                        found.append((high, surface))
            if found:
                time, surface = min(found)
                return surface, time
            now, gaps = then, ahead
        return None

    def fly(self, state: Sequence[float], max_contacts: int) -> Flown:
        position, velocity, spin = (
            [Decimal(float(c)) for c in state[k : k + 3]] for k in (0, 3, 6)
        )
        gravity, clock, last = self.given["gravity"], Decimal(0), None
        events: list[tuple[str, Decimal]] = []
        outcome = ""
        while not outcome:
            event = self.next_event(position, velocity, last)
            if event is None:
                outcome = "SHORT"
                break
            last, t = event
            clock += t
            events.append((last, clock))
            position = [p + v * t for p, v in zip(position, velocity, strict=True)]
            position[2] -= gravity * t * t / 2
            velocity = [velocity[0], velocity[1], velocity[2] - gravity * t]
            if last == "end":
                inside = _norm(position[:2]) <= self.given["ring_radius"]
                outcome = "MADE" if inside else "MISSED"
            else:
                velocity, spin = self.bounce(self.normal(last, position), velocity, spin)
                outcome = "CAPPED" if len(events) == max_contacts else ""
        return Flown(outcome, tuple(events), clock, (*position, *velocity, *spin))


@pytest.fixture(scope="session")
def fly() -> Callable[..., Flown]:
    """One shot to 50 digits, by a method that shares nothing with the engines."""

    def fly(
        state: Sequence[float],
        parameters: Mapping[str, float] = hoopgen.PAPER,
        max_contacts: int = 40,
    ) -> Flown:
        with localcontext() as context:
            context.prec = 50
            return _March(parameters).fly(state, max_contacts)

    return fly
