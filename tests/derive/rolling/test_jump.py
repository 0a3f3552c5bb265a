"""Errors where a ball begins to roll, from bounces to 60 digits, and where it comes to an edge.

The ball bounces on a plane or a sphere until nothing is left, and rolls for the same time: the two
states differ by no more than the errors that `jump_errors` adds, and by not much less.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import pytest
from hoopgen.derive.symbolic.symbols import STATE
from mpmath import matrix, mp, mpf

from hoopgen.scene import Plane, Scene
from tests.helpers.derived import DerivedKernels
from tests.scene.test_edges import GREEN

BALL, INERTIA, GRAVITY, RESTITUTION = 0.02, 0.4, 9.81, 0.5

ROOM = Scene(
    "room_with_a_gap",
    bodies=[Plane("floor", within=["x"])],
    ball_radius=BALL,
    gravity=GRAVITY,
    restitution=RESTITUTION,
    inertia=INERTIA,
    rolls=True,
)
"""A scene with an edge, for the kernels that all surfaces share."""

LAST_SPEED = mpf(10) ** -18

Vector = Any


def cross(a: Vector, b: Vector) -> Vector:
    return matrix([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def dot(a: Vector, b: Vector) -> Any:
    return mp.fdot(a, b)


def root(function: Callable[[Any], Any], near: Any) -> Any:
    """Return a root by the secant method, to twice as many digits as a double."""
    before, at = near * (1 + mpf(10) ** -6), near
    last = function(before)
    for _ in range(50):
        value = function(at)
        if value == last or abs(at - before) < mpf(10) ** -18 * abs(at):
            return at
        before, at, last = at, at - value * (at - before) / (value - last), value
    raise ArithmeticError("no root was found")


@dataclass(frozen=True)
class Ground:
    """The plane or the sphere that the ball's centre stays on, with its curvature k.

    Attributes
    ----------
    up
        The normal at the origin, where the ball begins.
    bend
        The curvature, negative on the inside of a sphere; 0 of a plane.
    """

    up: Vector
    bend: Any

    def normal(self, place: Vector) -> Vector:
        off = self.up + place * self.bend
        return off / mp.norm(off)

    def gap(self, place: Vector) -> Any:
        along = dot(place, self.up)
        if not self.bend:
            return along
        # 1/k (|up + k x| - 1), without the difference
        excess = 2 * self.bend * along + self.bend**2 * dot(place, place)
        return excess / self.bend / (mp.sqrt(1 + excess) + 1)

    def contact(self, x: Vector, v: Vector, w: Vector) -> tuple[Vector, Vector]:
        """Return velocity and spin after a contact that grips."""
        n = self.normal(x)
        off = dot(v, n)
        slip = v - off * n - BALL * cross(w, n)
        share = mpf(INERTIA) / (1 + mpf(INERTIA))
        after = v - share * slip - (1 + mpf(RESTITUTION)) * off * n
        return after, w + share / (mpf(INERTIA) * mpf(BALL)) * cross(n, slip)

    def pushed(self, x: Vector, v: Vector, w: Vector) -> tuple[Any, Vector, Vector]:
        """Return the normal force, the friction and the acceleration of a rolling ball."""
        n, fall = self.normal(x), matrix([0, 0, -mpf(GRAVITY)])
        turning = self.bend * (v - dot(v, n) * n)
        force = -dot(fall, n) - dot(v, turning)
        tangential = fall - dot(fall, n) * n
        share = mpf(INERTIA) / (1 + mpf(INERTIA))
        friction = share * (mpf(BALL) * dot(w, n) * cross(n, turning) - tangential)
        return force, friction, fall + force * n + friction

    def bounced(self, x: Vector, v: Vector, w: Vector) -> tuple[Any, Vector, Vector, Vector]:
        """Return the time until the bounces end, and the state then."""
        fall, clock = matrix([0, 0, -mpf(GRAVITY)]), mpf(0)
        while dot(v, self.normal(x)) > LAST_SPEED:
            n = self.normal(x)
            guess = 2 * dot(v, n) / self.pushed(x, v, w)[0]

            def height(t: Any, x: Vector = x, v: Vector = v) -> Any:
                return self.gap(x + t * v + t**2 / 2 * fall) / t

            lasting = root(height, guess)
            x, v = x + lasting * v + lasting**2 / 2 * fall, v + lasting * fall
            v, w = self.contact(x, v, w)
            clock += lasting
        return clock, x, v, w

    def rolled(
        self, lasting: Any, x: Vector, v: Vector, w: Vector
    ) -> tuple[Vector, Vector, Vector]:
        """Return the state after rolling, by 40 steps of Runge and Kutta's fourth order."""

        def rates(at: Sequence[Vector]) -> list[Vector]:
            n = self.normal(at[0])
            _, friction, pushed = self.pushed(*at)
            return [at[1], pushed, cross(friction, n) / (mpf(INERTIA) * mpf(BALL))]

        state, step = [x, v, w], lasting / 40
        for _ in range(40):
            first = rates(state)
            second = rates([s + step / 2 * r for s, r in zip(state, first, strict=True)])
            third = rates([s + step / 2 * r for s, r in zip(state, second, strict=True)])
            fourth = rates([s + step * r for s, r in zip(state, third, strict=True)])
            slopes = zip(state, first, second, third, fourth, strict=True)
            state = [s + step / 6 * (a + 2 * b + 2 * c + d) for s, a, b, c, d in slopes]
        return state[0], state[1], state[2]


def unit(*components: float) -> Vector:
    found = matrix(components)
    return found / mp.norm(found)


with mp.workdps(60):
    GROUNDS = {
        "plane": Ground(unit(0, 0, 1), mpf(0)),
        "slope": Ground(unit(3, 1, 5), mpf(0)),
        "top of a ball": Ground(unit(0, 0, 1), mpf(8)),
        "side of a ball": Ground(unit(2, 1, 4), mpf(8)),
        "bowl": Ground(unit(-2, 1, 3), mpf(-8)),
    }


def added(
    kernels: DerivedKernels, ground: Ground, bounce: Any, slip: Any, state: Sequence[Vector]
) -> list[float]:
    """Return by how much `jump_errors` raises errors of zero."""
    x, v, w = state
    n = ground.normal(x)
    force, friction, _ = ground.pushed(x, v, w)
    given = dict.fromkeys(
        (*(f"d{s}" for s in ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")), "gap"), 0.0
    )
    given |= dict(zip(map(str, STATE), map(float, (*x, *v, *w)), strict=True))
    given |= dict(zip(("nx", "ny", "nz"), map(float, n), strict=True))
    given |= {
        "bounce": float(bounce),
        "slip": float(slip),
        "press": float(force),
        "rolling_friction": float(mp.norm(friction)),
        "rebound": RESTITUTION,
        "per_reach": float(ground.bend),
    }
    sizes = {p.name: float(value) for p, value in zip(ROOM.inputs, ROOM.values(), strict=True)}
    given |= {kernels.VARIABLES[name]: value for name, value in sizes.items()}
    found = kernels.jump_errors(*(given[name] for name in kernels.ARGUMENTS["jump_errors"]))
    return [abs(float(error)) for error in found]


@pytest.mark.slow
def test_what_the_jump_leaves_out_is_within_the_errors_that_it_adds() -> None:
    """The height is gone at the end; all else counts from twice to thirty times, with roundings."""
    kernels = DerivedKernels.from_scene(ROOM.derive())
    with mp.workdps(60):
        for name, ground in GROUNDS.items():
            for exponent in (-3, -5):
                bounce = mpf(10) ** exponent
                for slide in (0, 1):
                    off_by(kernels, ground, bounce, slide * bounce, name)


def off_by(kernels: DerivedKernels, ground: Ground, bounce: Any, slide: Any, name: str) -> None:
    """Compare bounces that begin with a slip with rolling that begins at once."""
    n = ground.up
    east = unit(*cross(n, matrix([mpf(1), mpf(2), mpf(-1)])))
    north = cross(n, east)
    pace = (3 * east + 2 * north) / 10
    about = 3 if n[0] else 0  # on level ground there is no friction then
    still = cross(n, pace) / mpf(BALL) + about * n
    x = matrix([mpf(0)] * 3)
    spun = still + slide / mpf(BALL) * cross(n, north)
    slip = pace - mpf(BALL) * cross(spun, n)
    share = mpf(INERTIA) / (1 + mpf(INERTIA))
    moving = pace - share * slip
    turning = cross(n, moving) / mpf(BALL) + about * n
    clock, *ended = ground.bounced(x, pace + bounce * n, spun)
    rolled = ground.rolled(clock, x, moving, turning)
    errors = added(kernels, ground, bounce, mp.norm(slip), (x, moving, turning))
    last = ground.normal(ended[0])
    lag = ended[0] - rolled[0]
    changes = [lag - dot(lag, last) * last, ended[1] - rolled[1], ended[2] - rolled[2]]
    for k, change in enumerate(changes):
        allowed = errors[3 * k : 3 * k + 3]
        for size, own in zip(change, allowed, strict=True):
            assert abs(size) <= own, (name, k, bounce, slide)
    if slide or ground.up[0]:
        assert mp.norm(lag) > max(errors[:2]) / 40, (name, bounce, slide)


def test_on_a_level_plane_a_jump_without_slip_adds_roundings_alone() -> None:
    kernels = DerivedKernels.from_scene(ROOM.derive())
    with mp.workdps(60):
        ground = GROUNDS["plane"]
        state = matrix([0.1, 0, 0]), matrix([0.3, 0.2, 0]), matrix([-10, 15, 3])
        errors = added(kernels, ground, 2e-6, 0, state)
    assert max(errors[:2]) < 2.0**-50
    assert errors[2] == pytest.approx((2e-6) ** 2 / GRAVITY, rel=1e-2, abs=0)
    assert max(errors[3:6]) < 2.0**-48


def called(scene: Scene, kernel: str, **changed: float) -> dict[str, float]:
    """Return what a kernel of a scene computes; arguments that are not given are zero."""
    kernels = DerivedKernels.from_scene(scene.derive())
    sizes = {p.name: float(value) for p, value in zip(scene.inputs, scene.values(), strict=True)}
    given = dict.fromkeys(kernels.ARGUMENTS[kernel], 0.0)
    given |= {kernels.VARIABLES[name]: value for name, value in sizes.items()} | changed
    found = getattr(kernels, kernel)(*(given[name] for name in kernels.ARGUMENTS[kernel]))
    return dict(zip(kernels.OUTPUTS[kernel], map(float, found), strict=True))


@pytest.mark.slow
def test_at_an_edge_the_velocity_is_off_by_the_change_of_the_force_times_the_delay() -> None:
    """Off a level plane the ball loses N = g, so much earlier or later as its errors say."""
    for shift in (0.0, 1e-11):
        given = {"nz": 1.0, "vx": -0.3, "edge_delay": 1.6e-11, "edge_shift": shift}
        flown = called(ROOM, "edge_errors", successor=-1.0, **given)
        # The delay that the errors may have besides counts with a sixteenth.
        assert flown["dvz"] == pytest.approx(GRAVITY * (shift + 1e-12), rel=1e-12)
        pulled = {"after_z": -3.0, "after_y": 2.0}
        taken = called(ROOM, "edge_errors", successor=1.0, press=6.0, **pulled, **given)
        assert taken["dvz"] == pytest.approx(3 * (shift + 1e-12), rel=1e-12)
        assert abs(taken["dwx"]) == pytest.approx((2 * shift + 3e-12) / (INERTIA * BALL), rel=1e-12)
        let_go = called(ROOM, "edge_errors", successor=1.0, press=-1.0, **pulled, **given)
        assert let_go["dvz"] == flown["dvz"]


@pytest.mark.slow
def test_a_ball_comes_over_a_bound_as_late_as_its_errors_say() -> None:
    given = {"dx": 1e-12, "bound_rate": 0.5, "bound_shift": 1e-12, "bound_distance": -1e-17}
    found = called(GREEN, "entering_bound", x=0.1, fastest=1.0, strongest=10.0, **given)
    assert found["enters"]
    assert not found["lingers"]
    assert found["entry_shift"] == -2e-12
    assert found["entry_delay"] >= 8e-12
    slow = given | {"bound_rate": 1e-6, "position_error": 1e-12}
    assert called(GREEN, "entering_bound", x=0.1, fastest=1.0, strongest=10.0, **slow)["lingers"]
