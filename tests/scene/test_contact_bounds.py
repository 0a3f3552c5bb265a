"""Bounds of tori, boxes, cones and surfaces of revolution, which bound their points of contact."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.surfaces import Cone as DerivedCone
from hoopgen.derive.surfaces import ObliqueTorus, at_contact
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.derive.symbolic.symbols import POSITION
from numpy.typing import NDArray

pytest.importorskip("flint")

import hoopgen
from hoopgen.scene import Box, Cone, End, Parameter, Revolution, Scene, Torus
from hoopgen.simulation.engine import Engine
from tests.helpers.derived import engine_of
from tests.helpers.effort import exceptions, occurrences, trials
from tests.helpers.slow_scene import Slow
from tests.scene.test_oblique_bodies import aimed_at, rotated

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("contact_bounds")]

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


@pytest.mark.parametrize("which", SCENES)
def test_shots_at_bodies_with_bounds_are_as_proved(which: str, tmp_path: Path) -> None:
    """10,000 shots in all, each with its own directions and bounds."""
    check_proofs(engine_of(SCENES[which], tmp_path), trials(1500, at_least=400))


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
def test_an_independent_integrator_meets_the_same_parts(which: str, tmp_path: Path) -> None:
    check_integrator(engine_of(SCENES[which], tmp_path), SCENES[which])


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


def test_a_scene_turned_about_the_vertical_gives_the_turned_shots(tmp_path: Path) -> None:
    engine, count = engine_of(SCENES["hoop"], tmp_path), trials(1000, at_least=300)
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
    other = engine.simulate(turned(states), after, max_contacts=MOST, fields=CLAIMS)
    sure = (one.outcome != engine.outcomes["INVALID"]) & ~one.uncertain & ~other.uncertain
    assert sure.mean() > 0.9
    assert (one.counts == other.counts)[sure].all()
    away = np.abs(turned(one.state) - other.state).reshape(-1, 3, 3).max(axis=2)
    assert (away <= one.state_error + other.state_error)[sure].all()


def test_c_and_numpy_give_the_same_bits() -> None:
    engine = hoopgen.compile(SCENES["paddle"])
    states, values = shots_for(trials(1000, at_least=300), 5)
    one = engine.simulate(states, values, max_contacts=MOST, fields=CLAIMS)
    other = engine.simulate(states, values, max_contacts=MOST, backend="numpy", fields=CLAIMS)
    for name in CLAIMS:
        both = (np.asarray(getattr(found, name)) for found in (one, other))
        assert len({found.tobytes() for found in both}) == 1, name


def test_a_bound_of_contacts_is_a_length() -> None:
    """It changes by at most the way of the centre, and hardly by the roundings of its formula.

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
