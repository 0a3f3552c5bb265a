"""Bounds of tori, boxes, cones and surfaces of revolution, which bound their points of contact."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.events.box import BoxRootFinder
from hoopgen.derive.ir.kernel import kernel
from hoopgen.derive.surfaces import Box as DerivedBox
from hoopgen.derive.surfaces import Cone as DerivedCone
from hoopgen.derive.surfaces import ObliqueTorus, at_contact
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.derive.symbolic.symbols import POSITION
from numpy.typing import NDArray

pytest.importorskip("flint")

import hoopgen
from hoopgen.scene import Box, Cone, End, Parameter, Revolution, Scene, Torus
from hoopgen.simulation.engine import Engine
from tests.helpers.derived import engine_of, evaluation
from tests.helpers.effort import exceptions, occurrences, trials
from tests.helpers.slow_scene import Slow
from tests.scene.test_oblique_bodies import aimed_at, rotated

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("contact_bounds"),
]

Floats = NDArray[np.float64]

BALL, MOST = 0.06, 5
CUT = ["cut_1*x + cut_2*y + cut_3*z - 0.05", "x**2 + y**2 + z**2 - wide**2"]
CLAIMS = ("outcome", "uncertain", "counts", "time", "state", "time_error", "state_error")


def named(what: str, count: int = 3) -> tuple[str, ...]:
    return tuple(f"{what}_{k + 1}" for k in range(count))


def alone(name: str, body: Any) -> Scene:
    """Return a scene of one body about the origin, which every parameter may turn."""
    free = zip((*named("way"), *named("cut")), (0.2, 0.3, 1.0, 0.5, 1.0, -0.5), strict=True)
    turn = zip(named("turn", 4), (0.9, 0.1, 0.3, 0.2), strict=True)
    return Scene(
        name,
        parameters=[
            Parameter("wide", 0.35),
            *(Parameter(n, value, "1", sign="any") for n, value in (*free, *turn)),
        ],
        bodies=[body],
        ball_radius=BALL,
        gravity=9.81,
        restitution=0.75,
        ends={"gone": End(at=-3)},
    )


WAY = named("way")
SCENES = {
    "ring": alone("cut_ring", Torus("ring", radius=0.23, wire=0.02, within=CUT)),
    "hoop": alone("cut_hoop", Torus("hoop", radius=0.2, wire=0.03, axis=WAY, within=CUT)),
    "cup": alone("cut_cup", Cone("cup", slope=0.7, axis=WAY, inside=True, within=CUT)),
    "hat": alone("cut_hat", Cone("hat", slope=0.7, axis=WAY, span=(None, 0.4), within=CUT)),
    "crate": alone("cut_crate", Box("crate", size=(0.5, 0.3, 0.2), within=CUT)),
    "paddle": alone(
        "cut_paddle",
        Box("paddle", size=(0.5, 0.3, 0.1), orientation=named("turn", 4), within=CUT),
    ),
    "funnel": alone(
        "cut_funnel",
        Revolution("funnel", profile=[(0.02, -0.1), (0.1, -0.1), (0.25, 0.15)], within=CUT),
    ),
}


def shots_for(count: int, seed: int) -> tuple[Floats, dict[str, Any]]:
    """Return shots near the origin, and directions and bounds at random."""
    chance = np.random.default_rng(seed)
    names = (*WAY, *named("cut"), *named("turn", 4))
    values: dict[str, Any] = {name: chance.normal(0, 1, count) for name in names}
    return aimed_at([(0, 0, 0)], count, seed), values | {"wide": chance.uniform(0.15, 0.5, count)}


@pytest.fixture(scope="module")
def engine(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Engine]:
    """Return the function from the name of a scene to its engine, printed once."""
    return cache(lambda which: engine_of(SCENES[which], tmp_path_factory.mktemp(which)))


Engines = Callable[[str], Engine]


@pytest.mark.parametrize("which", SCENES)
def test_shots_at_bodies_with_bounds_are_as_proved(which: str, engine: Engines) -> None:
    """10,000 shots in all, each with its own directions and bounds."""
    check_proofs(engine(which), trials(1500, at_least=400))


def check_proofs(engine: Engine, count: int = 400) -> None:
    """Compare shots with the judge: as proved, or flagged, of which there are few."""
    states, values = shots_for(count, 1)
    shots = engine.simulate(states, values, max_contacts=MOST, record=True, fields=CLAIMS)
    proofs = hoopgen.certify(states, values, scene=engine, max_contacts=MOST, processes=1)
    assert proofs.decided.mean() > 0.99
    assert proofs.agrees(shots).all()
    valid = shots.outcome != engine.outcomes["INVALID"]
    assert np.sum(shots.uncertain & valid) < exceptions(0.002, count) + 2
    assert shots.counts[valid].sum() > occurrences(count // 20)
    sure = valid & ~shots.uncertain & proofs.decided
    away = np.abs(shots.state - proofs.state).reshape(-1, 3, 3).max(axis=2)
    assert (away <= shots.state_error + proofs.state_error)[sure].all()


@pytest.mark.parametrize("which", SCENES)
def test_an_independent_integrator_meets_the_same_parts(which: str, engine: Engines) -> None:
    check_integrator(engine(which), SCENES[which])


def check_integrator(engine: Engine, made: Scene) -> None:
    """Compare contacts with those of an integrator that shares no code."""
    states, values = shots_for(120, 2)
    shots = engine.simulate(states, values, max_contacts=3, record=True, time_limit=2.0)
    compared = 0
    for row in np.flatnonzero((shots.outcome != engine.outcomes["INVALID"]) & ~shots.uncertain):
        slow = Slow(made, {name: float(value[row]) for name, value in values.items()})
        flown = slow.fly(states[row], 3, 2.0)
        if flown.close:
            continue
        events = shots.events[(shots.events["shot"] == row) & (shots.events["surface"] == 0)]
        times = [time for _, time in flown.contacts]
        assert len(events) == len(times), row
        assert np.allclose(events["time"], times, rtol=0, atol=1e-8), row
        compared += len(times)
    assert compared > 8


@pytest.mark.parametrize("which", ["hoop", "cup", "paddle"])
def test_a_scene_turned_about_the_vertical_gives_the_turned_shots(
    which: str, engine: Engines
) -> None:
    check_turned(engine(which), trials(1000, at_least=300))


def check_turned(engine: Engine, count: int) -> None:
    """Turn shots, directions and bounds alike."""
    (states, values), angle = shots_for(count, 3), np.random.default_rng(4).uniform(-3, 3, count)
    turn = np.zeros((count, 3, 3))
    turn[:, 0, 0] = turn[:, 1, 1] = np.cos(angle)
    turn[:, 1, 0] = np.sin(angle)
    turn[:, 0, 1] = -turn[:, 1, 0]
    turn[:, 2, 2] = 1.0

    def turned(rows: Floats) -> Floats:
        vectors = np.einsum("nij,nkj->nki", turn, rows.reshape(count, 3, 3))
        return np.asarray(vectors.reshape(count, 9))

    one = engine.simulate(states, values, max_contacts=MOST, fields=CLAIMS)
    after = rotated(values, angle)
    # The quaternion of a turn about z by that angle, times that of the body.
    cosine, sine = np.cos(angle / 2), np.sin(angle / 2)
    w, i, j, k = (values[name] for name in named("turn", 4))
    parts = (cosine * w - sine * k, cosine * i - sine * j, cosine * j + sine * i)
    after |= dict(zip(named("turn", 4), (*parts, cosine * k + sine * w), strict=True))
    other = engine.simulate(turned(states), after, max_contacts=MOST, fields=CLAIMS)
    sure = (one.outcome != engine.outcomes["INVALID"]) & ~one.uncertain & ~other.uncertain
    assert sure.mean() > 0.9
    assert (one.counts == other.counts)[sure].all()
    away = np.abs(turned(one.state) - other.state).reshape(-1, 3, 3).max(axis=2)
    assert (away <= one.state_error + other.state_error)[sure].all()


@pytest.mark.parametrize("which", ["ring", "crate"])
def test_few_shots_through_parts_that_are_not_there_are_uncertain(
    which: str, engine: Engines
) -> None:
    check_few_uncertain(engine(which))


def check_few_uncertain(engine: Engine) -> None:
    """Steps to the way out of a body are long enough: no search gives up."""
    states, values = shots_for(2000, 7)
    shots = engine.simulate(states, values, max_contacts=MOST, fields=("outcome", "uncertain"))
    valid = shots.outcome != engine.outcomes["INVALID"]
    assert np.sum(shots.uncertain & valid) < 3


def test_the_gap_of_a_ball_on_its_way_out_of_a_box_bends_no_more_than_its_bound() -> None:
    """Nor is the bound that of the whole flight."""
    derived, width, count = SCENES["crate"].derive(), sp.Symbol("width", positive=True), 1000
    box = derived.bodies[0].faces[0]
    assert isinstance(box, DerivedBox)
    finder, chance = BoxRootFinder(derived.flight, box), np.random.default_rng(10)
    outputs = {"C": finder.ceiling, "M": finder.turned_curvature(width), "bend": finder.bend}
    symbols = set().union(*(e.free_symbols for e in outputs.values()))
    values = {p.name: np.full(count, p.default) for p in derived.parameters}
    values |= {f"v{axis}": chance.normal(0, 3, count) for axis in "xyz"}
    half = np.array([0.25, 0.15, 0.1]) + BALL
    start = half[:, None] * chance.uniform(-1, 1, (3, count))
    values |= dict(zip("xyz", start, strict=True))
    values |= {"t": np.zeros(count), "width": 10 ** chance.uniform(-3, -1, count)}
    values |= {str(symbol): np.zeros(count) for symbol in symbols if str(symbol) not in values}
    values["horizon"] = np.full(count, 10.0)
    found = {name: one_of({name: formula}) for name, formula in outputs.items()}
    values["ceiling"] = most = found["C"](values)
    bound, met = found["M"](values), 0
    for share in np.linspace(0, 1, 9):
        time = share * values["width"]
        there = start + time * np.array([values[f"v{axis}"] for axis in "xyz"])
        there[2] -= 9.81 / 2 * time**2
        near = (abs(there) <= half[:, None]).all(axis=0)
        met += near.sum()
        assert (found["bend"](values | {"t": time}) <= bound)[near].all()
    assert met > 3 * count
    assert (bound < most / 4).mean() > 0.9


def one_of(output: dict[str, sp.Expr]) -> Callable[[dict[str, Floats]], Floats]:
    """Return the function from values by name to one formula, in doubles."""
    (formula,) = output.values()
    order = sorted(formula.free_symbols, key=str)
    run = evaluation(kernel("sample", output, order, "A sample.", "Eq. 2"), tuple(order))
    return lambda values: np.asarray(run(*(values[str(symbol)] for symbol in order))[0])


@pytest.mark.parametrize("which", ["crate", "paddle"])
def test_a_ball_may_start_where_a_box_is_not_there(which: str, engine: Engines) -> None:
    check_starts(engine(which), SCENES[which])


def check_starts(engine: Engine, made: Scene) -> None:
    """Compare starts with geometry that shares no code."""
    states, values = shots_for(300, 8)
    states[:, :3] = np.random.default_rng(9).uniform(-0.2, 0.2, (300, 3))
    shots = engine.simulate(states, values, max_contacts=1, fields=("outcome",))
    valid = shots.outcome != engine.outcomes["INVALID"]
    overlaps = np.zeros((2, 300))
    for row, state in enumerate(states):
        slow = Slow(made, {name: float(value[row]) for name, value in values.items()})
        overlaps[:, row] = slow.overlap(state[:3])
    away, side = overlaps
    clear = np.minimum(abs(away), abs(side)) > 1e-7
    assert (valid == ((away > 0) | (side > 0)))[clear].all()
    assert (valid & (away < 0)).sum() > 30
    assert (~valid).sum() > 30


@pytest.mark.parametrize("which", ["paddle"])
def test_c_and_numpy_give_the_same_bits(which: str) -> None:
    engine = hoopgen.compile(SCENES[which])
    states, values = shots_for(trials(1000, at_least=300), 5)
    one = engine.simulate(states, values, max_contacts=MOST, fields=CLAIMS)
    other = engine.simulate(states, values, max_contacts=MOST, backend="numpy", fields=CLAIMS)
    for name in CLAIMS:
        both = (np.asarray(getattr(found, name)) for found in (one, other))
        assert len({found.tobytes() for found in both}) == 1, name


def test_a_bound_that_holds_at_the_apex_of_a_cone_is_none_there() -> None:
    """A ball on the apex touches one point, where z <= 0 holds as 0 <= 0."""
    body = Cone("tent", within=["z"], axis="-z", half_angle="45deg", span=(0, 0.4))
    scene = Scene(
        "tent",
        bodies=[body],
        ball_radius=0.1,
        gravity=9.81,
        restitution=0.5,
        ends={"gone": End(at=-3)},
    )
    states = np.zeros((40, 9))
    states[:, :2] = np.random.default_rng(4).normal(0, 0.2, (40, 2))
    states[:20, 0] /= 1000
    states[:20, 1], states[:, 2] = 0, 1
    states[0, 2] = 0.05
    shots = hoopgen.simulate(states, scene=scene, record=True, max_contacts=3)
    proofs = hoopgen.certify(states, scene=scene, max_contacts=3)
    assert np.all(proofs.agrees(shots))
    assert shots.outcome.tolist().count(int(shots.outcome[0])) == 1  # INVALID, inside the tent
    assert np.mean(shots.contacts > 0) > 0.5


def test_a_bound_of_contacts_is_a_length() -> None:
    """A bound changes by at most the way of the centre, and hardly by the roundings of its formula.

    On tori near the axis and in narrow cones points of contact move much faster than the centre.
    """
    radius, ball = sp.Rational(1, 4), sp.Rational(1, 5)
    up = (sp.Integer(0), sp.Integer(0), sp.Integer(1))
    origin = (sp.Integer(0),) * 3
    ring = ObliqueTorus("ring", origin, up, radius, ball)
    cone = DerivedCone("cup", origin, up, sp.Rational(1, 2), inward=True)
    chance = np.random.default_rng(6)
    for surface in (ring, cone):
        (bound,) = at_contact([POSITION[0]], surface, ball)
        for _ in range(100):
            turn, share = chance.uniform(-math.pi, math.pi), chance.uniform(0.01, 1.0)
            across, height = share, 2 * share
            if surface is ring:
                across, height = 0.25 - 0.2 * math.cos(share / 4), 0.2 * math.sin(share / 4)
            place = [across * math.cos(turn), across * math.sin(turn), height]
            assert steepness(bound, place) <= 1.0 / 12 + 1e-6


def steepness(bound: sp.Expr, place: list[float]) -> float:
    """Return the size of a bound's gradient."""
    choice = {"IfLess": lambda left, right, then, other: then if left < right else other}
    value = sp.lambdify(POSITION, release(bound), modules=[choice, "math"])
    found = []
    for k in range(3):
        sides = [[c + way * 1e-6 * (j == k) for j, c in enumerate(place)] for way in (-1, 1)]
        low, high = (float(value(*side)) for side in sides)
        found.append((high - low) / 2e-6)
    return float(np.linalg.norm(found))
