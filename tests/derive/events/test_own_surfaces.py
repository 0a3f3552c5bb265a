"""The searches of scenes of one's own: windows, mean rates, boxes, and who may start where."""

from __future__ import annotations

import random
from itertools import pairwise
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb, ctx
from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.events import root_finder_for
from hoopgen.derive.events.box import BoxRootFinder
from hoopgen.derive.events.box_windows import RELATIVE_INFLATION, lost, windows
from hoopgen.derive.motion.parabola import Parabola
from hoopgen.derive.scenes import validity
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.scene import Scene, parameter
from hoopgen.derive.surfaces import (
    Box,
    Cylinder,
    ObliqueBox,
    ObliqueTorus,
    Plane,
    Sphere,
    Surface,
    Torus,
    body,
)
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.derive.symbolic.polynomials import mean_rate
from hoopgen.derive.symbolic.symbols import POSITION, VELOCITY, t
from mpmath import mpf

from hoopgen.judge.flight import fly
from hoopgen.judge.formulas import formulas
from hoopgen.judge.roots import Undecided
from tests.derive.test_evaluation import digits, exactly, in_doubles
from tests.helpers.effort import EFFORT, occurrences, trials
from tests.helpers.scenes.chamber import CHAMBER
from tests.helpers.scenes.crate import CRATE
from tests.helpers.scenes.posts import POSTS
from tests.helpers.scenes.rings import RINGS

GRAVITY = sp.Symbol("g", positive=True)
DOWN = Parabola((sp.Integer(0), sp.Integer(0), -GRAVITY))
PLACES = [str(s) for s in (*POSITION, *VELOCITY)]
ZERO = sp.Integer(0)
NO_BODY = {"last": -1, "left_middle": -1, "left_reach": 0.5}
"""A start that leaves no body, of which a scene's bodies have one surface or several."""


def numbers(chance: random.Random, names: list[str], size: float = 1.0) -> dict[str, float]:
    """Return a number for each name."""
    return {name: chance.uniform(-size, size) for name in names}


# -- When a ball is within a box


@pytest.mark.parametrize(
    "fall", [(0, 0, -1), (0, 0, 1), (1, 0, 0), (-1, 0, -2)], ids=["down", "up", "aside", "oblique"]
)
@pytest.mark.parametrize("endless", [False, True])
def test_windows_hold_every_time_within_the_box(fall: tuple[int, ...], endless: bool) -> None:
    """And are in order, and apart: a search takes one after the other."""
    chance = np.random.default_rng(1)
    accelerations = [part * GRAVITY for part in fall]
    halves = [sp.Rational(1, 2), None if endless else sp.Rational(1, 5), sp.Rational(1, 3)]
    axes = list(zip(POSITION, VELOCITY, accelerations, strict=True))
    values = {name: chance.uniform(-1, 1, 300) for name in PLACES} | {
        "g": chance.uniform(1, 20, 300)
    }
    for v in VELOCITY:
        values[str(v)][chance.random(300) < 0.25] = 0.0
    spans = [
        np.broadcast_arrays(*in_doubles({"a": a, "b": b}, values).values())
        for a, b in windows(axes, halves)
    ]
    for row in np.transpose(spans, (2, 0, 1)):
        opened = [(low, high) for low, high in row if low < high]
        assert all(a[1] <= b[0] for a, b in pairwise(opened))
    times = np.linspace(0, 1, 200)[:, None]
    inside, covered = np.full((200, 300), True), np.full((200, 300), False)
    for p, v, a, h in zip(POSITION, VELOCITY, fall, halves, strict=True):
        there = values[str(p)] + times * (values[str(v)] + times * a * values["g"] / 2)
        inside &= True if h is None else abs(there) <= float(h)
    for low, high in spans:
        covered |= (low < high) & (low <= times) & (times <= high)
    assert inside.sum() > 300
    assert not (inside & ~covered).any()


def test_a_ball_that_never_comes_near_has_no_window() -> None:
    axes = list(zip(POSITION, VELOCITY, DOWN.acceleration, strict=True))
    found = windows(axes, [sp.Integer(1)] * 3)
    values = dict.fromkeys(PLACES, 0.0) | {"g": 10.0, "x": 5.0, "vz": 3.0}
    for low, high in found:
        span = in_doubles({"a": low, "b": high}, values)
        assert not float(span["a"]) < float(span["b"])


@pytest.mark.parametrize(
    "fall", [(0, 0, -1), (0, 0, 1), (1, 0, 0), (-1, 0, -2)], ids=["down", "up", "aside", "oblique"]
)
@pytest.mark.parametrize("endless", [False, True])
def test_errors_are_small_whenever_the_true_ball_is_in_the_box(
    fall: tuple[int, ...], endless: bool
) -> None:
    """Even where nothing ends the flight, with errors as large as are not lost, all one way."""
    chance = random.Random(3)
    accelerations = [part * GRAVITY for part in fall]
    halves = [sp.Rational(1, 2), None if endless else sp.Rational(1, 5), sp.Rational(1, 3)]
    centre = [sp.Rational(1, 3), sp.Integer(0), sp.Rational(-1, 4)]
    verdict = lost(centre, halves, accelerations)
    nearest = 0.0
    for _ in range(trials(200, at_least=60)):
        size, fastest = 10 ** chance.uniform(-1, 4), chance.choice((0, 1, 30))
        values: dict[str, Any] = numbers(chance, PLACES[:3], size)
        values |= numbers(chance, PLACES[3:], fastest) | {"g": mpf(9.81), "horizon": mpf("inf")}
        for axis, part in zip("xyz", fall, strict=True):
            if part and chance.random() < 0.5:  # all of it against the fall: the longest way
                values |= dict.fromkeys(("x", "y", "z", "vx", "vy", "vz"), 0.0)
                values |= {axis: -part * size, f"v{axis}": -part * float(fastest)}
        values["extent"] = sum(abs(values[str(p)]) for p in POSITION)
        values["speed"] = sum(abs(values[str(v)]) for v in VELOCITY)
        with digits(40):
            least, one = (
                exactly(verdict, values | {"position_error": 0, "velocity_error": e})
                for e in (0, 1)
            )
            if least > 0:
                continue
            share = chance.uniform(0, 1)
            place_error, error = -least * share, -least * (1 - share) / (one - least)
            bound = exactly(RELATIVE_INFLATION / 4 * min(h for h in halves if h is not None), {})
            for axis, a, c, h in zip("xyz", fall, centre, halves, strict=True):
                if not a:
                    continue
                g, way = abs(a) * values["g"], -1 if a > 0 else 1
                up = way * values[f"v{axis}"] + error
                drop = way * (values[axis] - mpf(c.p) / c.q) + mpf(h.p) / h.q + place_error
                if up**2 + 2 * g * drop < 0:
                    continue
                last = (up + mpmath.sqrt(up**2 + 2 * g * drop)) / g
                now = place_error + error * last
                assert now <= bound
                nearest = max(nearest, now / bound)
    assert nearest > 0.9


@pytest.mark.parametrize("power", [1, 2, 3, 4])
def test_the_mean_rate_times_the_time_is_the_change(power: int) -> None:
    x, y, z = POSITION
    starts = sp.symbols("x0 y0 z0", real=True)
    formula = (x * y - 3 * z) ** power + 7 * x**2 * z - 5
    rates = dict(zip(POSITION, VELOCITY, strict=True))
    change = mean_rate(formula, dict(zip(POSITION, starts, strict=True)), rates)
    moved = {p: s + v * t for p, s, v in zip(POSITION, starts, VELOCITY, strict=True)}
    then = formula.xreplace(dict(zip(POSITION, starts, strict=True)))
    assert sp.expand(t * change.xreplace(moved) - formula.xreplace(moved) + then) == 0
    assert t not in change.free_symbols


# -- Any surface of its own search: gap, margins, curvature

R, S = sp.symbols("wide thin", positive=True)
CENTRE = (sp.Rational(1, 3), sp.Integer(-2), sp.Rational(1, 7))
LEAN = (sp.Rational(2, 3), sp.Rational(-1, 3), sp.Rational(2, 3))
TURN = (sp.Integer(1), sp.Rational(1, 2), sp.Rational(-1, 4), sp.Rational(1, 3))
KINDS: dict[str, Surface] = {
    "sphere": Sphere("sphere", CENTRE, R),
    "inside": Sphere("inside", CENTRE, R, inward=True),
    "cylinder": Cylinder("cylinder", CENTRE, (0, 1, 0), R),
    "upright": Cylinder("upright", CENTRE, (0, 0, 1), R, inward=True),
    "oblique": Cylinder("oblique", CENTRE, LEAN, R),
    "torus": Torus("torus", CENTRE, (1, 0, 0), R, S),
    "leaning": Torus("leaning", CENTRE, LEAN, R, S),
    "turned": ObliqueTorus("turned", CENTRE, (sp.Integer(1), sp.Integer(-2), sp.Integer(2)), R, S),
    "box": Box("box", CENTRE, tuple(c + R for c in CENTRE), S),
    "turned box": ObliqueBox("turned", (-R / 2,) * 3, (R / 2, R / 2, R / 2), S, CENTRE, TURN),
}
kinds = pytest.mark.parametrize("surface", KINDS.values(), ids=list(KINDS))
NO_ERRORS = {"position_error": 0.0, "velocity_error": 0.0}


def near(chance: random.Random, surface: Surface) -> tuple[dict[str, Any], float]:
    """Return a flight that is in the surface's neighbourhood at a time, and the time."""
    values: dict[str, Any] = {"wide": 0.5, "thin": 0.1, "g": 9.81} | NO_ERRORS
    time = chance.uniform(0.01, 1.0)
    for p, v, c, a in zip(
        POSITION, VELOCITY, surface.reference_point, DOWN.acceleration, strict=True
    ):
        goal = float(sp.sympify(c).subs({R: 0.5})) + chance.uniform(-0.55, 0.55)
        values[str(v)] = chance.gauss(0, 3)
        fall = 0.0 if a == 0 else -9.81
        values[str(p)] = goal - time * (values[str(v)] + fall * time / 2)
    values["extent"] = sum(abs(values[str(p)]) for p in POSITION)
    values["speed"] = sum(abs(values[str(v)]) for v in VELOCITY)
    return values, time


def opened(search: Any, values: dict[str, Any], time: float) -> bool:
    """Return whether the time is in a window."""
    known = dict(values) | {"horizon": mpmath.inf}
    return any(exactly(a, known) <= time <= exactly(b, known) for a, b in search.windows)


@pytest.mark.sampled(1)
@kinds
def test_gap_and_rate_are_within_their_margins_and_the_bend_within_its_bounds(
    surface: Surface,
) -> None:
    """Doubles are compared with 40 digits, within windows; the gap has the distance's sign."""
    search, chance, seen = root_finder_for(surface, DOWN), random.Random(2), 0
    width = sp.Symbol("width", nonnegative=True)
    curvature = search.curvature(width)
    for _ in range(trials(70)):
        values, time = near(chance, surface)
        with digits(40):
            if not opened(search, values, time):
                continue
            seen += 1
            now = values | {"t": time, "horizon": time * 1.01, "leaving": 0}
            found = in_doubles({"gap": search.gap, "rate": search.rate}, now)
            bounds = {name: exactly(e, now) for name, e in search.margins.items()}
            gap, rate = exactly(search.gap, now), exactly(search.rate, now)
            assert abs(gap - float(found["gap"])) <= bounds["margin"]
            assert abs(rate - float(found["rate"])) <= bounds["rate_margin"]
            there, _ = DOWN.at()
            place = {str(p): exactly(e, now) for p, e in zip(POSITION, there, strict=True)}
            distance = exactly(surface.distance, now | place)
            assert abs(distance) < 1e-15 or (gap > 0) == (distance > 0)
            ceiling = exactly(search.ceiling, now)
            assert abs(exactly(search.bend, now)) <= ceiling
            bent = exactly(curvature, now | {"width": 0.01, "ceiling": ceiling})
            for k in range(5):
                later = now | {"t": mpf(time) + mpf(k) / 400}
                assert -exactly(search.bend, later) <= bent or not opened(
                    search, values, later["t"]
                )
            step = mpf(10) ** -12
            slope = (
                exactly(search.gap, now | {"t": mpf(time) + step})
                - exactly(search.gap, now | {"t": mpf(time) - step})
            ) / (2 * step)
            assert abs(slope - rate) <= 1e-9 * (1 + ceiling)
    assert seen >= occurrences(10)


@pytest.mark.sampled(1)
@kinds
def test_the_gap_since_a_start_on_the_surface_is_within_its_margin(surface: Surface) -> None:
    """F less what it was, over t, for every start within the box; exactly that difference."""
    search, chance, seen = root_finder_for(surface, DOWN), random.Random(3), 0
    for _ in range(trials(60)):
        values, _ = near(chance, surface)
        for p, v, a in zip(POSITION, VELOCITY, DOWN.acceleration, strict=True):
            # Turned round: what was reached is where it starts from.
            values[str(p)] = float(
                release(sp.sympify(surface.reference_point[POSITION.index(p)])).subs(R, 0.5)
            )
            values[str(p)] += chance.uniform(-0.3, 0.3)
            values[str(v)] = chance.gauss(0, 2) + (0 if a == 0 else 2)
        values["extent"] = sum(abs(values[str(p)]) for p in POSITION)
        values["speed"] = sum(abs(values[str(v)]) for v in VELOCITY)
        time = 10 ** chance.uniform(-9, -1)
        with digits(40):
            if not opened(search, values, time):
                continue
            seen += 1
            now = values | {"t": time, "horizon": time * 1.01, "leaving": 1}
            wanted = exactly(search.gap, now) - exactly(search.gap, now | {"t": mpf(0)})
            assert abs(exactly(search.leaving_gap, now) - wanted) < mpf(10) ** -35
            found = float(in_doubles({"gap": search.leaving_gap}, now)["gap"])
            assert abs(found - wanted) <= exactly(search.margins["leaving_margin"], now) * time
    assert seen >= occurrences(10)


def test_a_box_is_searched_as_one() -> None:
    assert isinstance(root_finder_for(KINDS["box"], DOWN), BoxRootFinder)


# -- Where a ball may start


def _far() -> Scene:
    """A huge sphere whose surface is near the origin; its sizes are numbers, not parameters."""
    sizes = (parameter("ball", "m", "", 0.05), parameter("g", "m/s²", "", 9.81))
    ball, gravity = (p.symbol for p in sizes)
    far = Sphere("far", (sp.Rational(1001, 10), ZERO, ZERO), sp.Integer(100) + ball)
    return Scene(
        name="far",
        parameters=sizes,
        bodies=(body(far, NoSlip("impact", sp.Rational(1, 2))),),
        ends=(End("ground", Plane("ground", (0, 0, 1), sp.Integer(-9), ZERO)),),
        ball_radius=ball,
        gravity=gravity,
    )


@pytest.mark.slow
@pytest.mark.parametrize(
    "scene", [CHAMBER, POSTS, RINGS, CRATE, _far()], ids=lambda scene: str(scene.name)
)
def test_a_start_within_rounding_of_a_surface_is_undecided_or_right(scene: Scene) -> None:
    """Starts a few roundings from each surface, either side, against the judge."""
    chance, own = random.Random(4), formulas(scene)
    verdict = validity.valid(scene, frozenset())
    defaults = {p.name: p.default for p in scene.parameters}
    decided = undecided_starts = 0
    for surface in scene.surfaces * trials(24 // len(scene.surfaces)):
        with digits(40):
            place = {name: mpf(chance.uniform(-0.9, 0.9)) for name in "xyz"}
            for _ in range(40):  # along the gradient to where the distance is zero
                here = exactly(surface.distance, defaults | place)
                step = mpf(10) ** -15
                slope = {
                    n: (exactly(surface.distance, defaults | place | {n: c + step}) - here) / step
                    for n, c in place.items()
                }
                steep = sum(s**2 for s in slope.values())
                if not steep > 0:
                    break
                place = {n: c - here * slope[n] / steep for n, c in place.items()}
            nudge = chance.choice((0, 1e-16, 1e-15, 1e-14, -1e-14, -1e-15, 1e-12, -1e-12))
            start = {n: float(c + nudge * slope[n]) for n, c in place.items()}
        found = in_doubles(verdict, defaults | start | NO_BODY)
        state = [*start.values(), *[0.0] * 6]
        try:
            with ctx.workprec(256):
                outcome = fly(own, state, list(defaults.values()), 1).outcome
        except Undecided as question:
            if "starts" in question.args[0]:
                continue
            outcome = scene.outcomes["short"]
        decided += 1
        undecided_starts += bool(found["undecided_time"])
        right = (outcome != scene.outcomes["invalid"]) == bool(found["valid"])
        assert right or found["undecided_time"], (surface.name, start)
    assert decided > occurrences(10)
    if EFFORT >= 1:
        assert 0 < undecided_starts < decided


def test_beyond_a_wall_that_is_all_around_is_body_and_behind_a_thin_one_is_not() -> None:
    """A sphere seen from inside: r > R - b; a shell: only within the ball's radius of it."""
    defaults = {p.name: p.default for p in CHAMBER.parameters}
    verdict = validity.valid(CHAMBER, frozenset())
    places = {
        (0, 0, 0.949): 1,
        (0, 0, 0.951): 0,
        (0, 0, 5.0): 0,
        (0.3, 0, -0.34): 1,
        (0.3, 0, -0.36): 0,
        (0.3, 0, -0.44): 0,
        (0.3, 0, -0.46): 1,
        (0.3, 0, 0.4): 1,
    }
    for (x, y, z), valid in places.items():
        found = in_doubles(verdict, defaults | {"x": x, "y": y, "z": z} | NO_BODY)
        assert (bool(found["valid"]), bool(found["undecided_time"])) == (bool(valid), False), (
            x,
            y,
            z,
        )


def test_the_judge_takes_fractions_exactly() -> None:
    """100.1 is no double: at the origin the distance is 100.1 - 100.0625, to all digits."""
    with ctx.workprec(300):
        (distance,) = formulas(_far()).surfaces[0].distance([arb(0)] * 6, [arb(1) / 16, arb(1)])
        assert abs(distance - arb(375) / 10000) < arb(2) ** -280
