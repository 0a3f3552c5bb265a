"""Rolls on cones up to bounds of the point of contact, which no span describes.

Each roll is integrated again, with the nearest point of the cone and its rate as all that is known
of it: by DOP853, up to where the normal force vanishes or a bound is passed.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("flint")

import hoopgen
from hoopgen import Event
from hoopgen.scene import Cone, Parameter, Plane, Scene
from hoopgen.simulation.engine import Engine
from tests.helpers.bounded_rolls import bound, check_turned, turned_bounds
from tests.helpers.effort import trials
from tests.scene.test_cone_rolls import (
    CHUTE,
    FUNNEL,
    SPIKE,
    STUMP,
    cone,
    energy,
    on_side,
    turned,
)
from tests.scene.test_oblique_rolls import (
    BALL,
    CLAIMS,
    GRAVITY,
    Body,
    check_proofs,
    compare,
    rolled,
)

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("bounded_cone_rolls"),  # compiled once
]

Floats = NDArray[np.float64]

NAMES = ("funnel", "chute", "spike", "stump")
GIVEN: tuple[Mapping[str, Any], ...] = (FUNNEL, CHUTE, SPIKE, STUMP)
INSIDE = (True, True, False, False)
BOUNDS = (
    ("x - 0.2", "x/10 - y - 0.25"),
    ("x**2 + y**2 + z**2 - 4.9*x + 5.8", "y - 0.35 - z/4"),
    ("x**2 + 2*y**2 - 8*x + 15.91 - z/9", "y - 0.25"),
    ("y**2 + 3*(x - 6)*z - 0.2", "5.8 - x - y"),
)
SPANS: tuple[Any, ...] = ((0.1, 0.5), None, (0.0, 0.5), (0.2, 0.9))


def cones() -> list[Cone]:
    """Return the cones as bodies; the axis of two is a coordinate axis."""
    found = []
    for name, given, inside, bounds, span in zip(NAMES, GIVEN, INSIDE, BOUNDS, SPANS, strict=True):
        x, y, z = given["axis"]
        axis: Any = ("z" if z > 0 else "-z") if (x, y) == (0, 0) else turned(given["axis"])
        sizes: dict[str, Any] = {"slope": given["slope"], "within": turned_bounds(*bounds)}
        sizes |= {"span": span} if span else {}
        found.append(Cone(name, inside=inside, apex=turned(given["apex"]), axis=axis, **sizes))
    return found


CONES = Scene(
    "cones_with_bounds_to_roll_on",
    parameters=[
        Parameter("cos_turn", 1.0, "1", sign="any"),
        Parameter("sin_turn", 0.0, "1", sign="any"),
        Parameter("mirror", 1.0, "1", sign="any"),
        Parameter("kappa", 2 / 3, "1"),
    ],
    bodies=[*cones(), Plane("floor", at=-0.7)],
    ball_radius=BALL,
    gravity=GRAVITY,
    restitution=0.3,
    inertia="kappa",
    rolls=True,
)


def funnel(name: str, **ends: Any) -> Scene:
    """Return a scene of a funnel alone."""
    return Scene(
        name,
        bodies=[Cone("funnel", slope=1.2, inside=True, **ends), Plane("floor", at=-0.7)],
        ball_radius=BALL,
        gravity=GRAVITY,
        restitution=0.3,
        rolls=True,
    )


@pytest.fixture(scope="module")
def engine() -> Engine:
    return hoopgen.compile(CONES)


def dropped(count: int, seed: int) -> Floats:
    """Return balls that fall onto the cones."""
    chance = np.random.default_rng(seed)
    which = np.arange(count) % 4
    states = np.zeros((count, 9))
    states[:, 0] = np.array([0.0, 2.4, 4.0, 5.8])[which]
    states[:, 1] = np.array([0.0, 0.2, 0.0, 0.05])[which]
    wide = np.array([[0.25, 0.15, 0.2, 0.2], [0.25, 0.15, 0.2, 0.05]])[:, which].T
    states[:, :2] += chance.uniform(-1, 1, (count, 2)) * wide
    states[:, 2] = np.array([0.55, 0.1, 0.6, 0.35])[which] + chance.uniform(0, 0.1, count)
    states[:, 3:5] = chance.normal(0, 0.6, (count, 2)) * np.array([1, 1, 1, 0.3])[which, None]
    states[:, 6:] = chance.normal(0, 5, (count, 3))
    return states


def bounded(own: int) -> Body:
    """Return a cone of the scene within its bounds."""
    given = GIVEN[own] | {"span": SPANS[own] or (0.0, np.inf)}
    whole = cone(given)
    return Body(whole.nearest, (*whole.within, *map(bound, BOUNDS[own])))


def rolling(own: int, count: int, seed: int) -> Floats:
    """Return balls a millimetre above a cone where it is, which will roll along it."""
    chance = np.random.default_rng(seed)
    far, azimuth = chance.uniform(0.2, 0.6, 6 * count), chance.uniform(0, 2 * np.pi, 6 * count)
    speed, aside = chance.normal(0, 0.6, (2, 6 * count))
    states = on_side(own, far, azimuth, speed, aside)
    body = bounded(own)
    points = (body.nearest(state[:3])[0] for state in states)
    inner = np.array([max(one(q) for one in body.within) < -0.01 for q in points])
    normal = states[:, :3] - [0, 0, 1e-3] - np.array([body.nearest(s[:3])[0] for s in states])
    pressed = normal[:, 2] > 0.3 * BALL
    return states[inner & pressed][:count]


@pytest.mark.parametrize("own", range(4))
def test_rolls_on_a_cone_end_at_its_bounds_as_in_a_second_formulation(
    engine: Engine, own: int
) -> None:
    check_rolls(engine, own, trials(600, 300))


def check_rolls(engine: Engine, own: int, count: int = 600) -> None:
    """Compare rolls on one cone, of which many end at a bound."""
    body, given = bounded(own), GIVEN[own]
    unit = np.array(given["axis"]) / np.linalg.norm(given["axis"])
    sine = np.sin(np.arctan(given["slope"]))

    def follow(begin: Any, until: float) -> tuple[int, float, Floats] | None:
        if begin["surface"] != own:
            return None
        state = begin["after"]
        before = -(state[:3] - given["apex"]) @ unit - BALL * sine
        if not INSIDE[own] and before > -1e-12:  # on the apex
            return None
        return rolled(body, state, until)

    states = rolling(own, count // 4, 1)
    shots = engine.simulate(states, time_limit=3, record=True)
    ends = compare(shots, follow)
    spans = len(cone(given).within)
    assert len(ends) > len(states) / 3
    assert sum(kind > spans for kind in ends) > len(states) / 20
    assert not np.any(shots.outcome == engine.outcomes["CAPPED"])


def test_few_rolls_on_cones_with_bounds_are_uncertain(engine: Engine) -> None:
    shots = engine.simulate(dropped(trials(1000, 400), 9), time_limit=3)
    assert np.mean(shots.rolls > 0) > 0.7
    assert np.mean(shots.uncertain) < 0.05


def test_a_ball_that_rolls_on_a_cone_with_bounds_keeps_its_energy(engine: Engine) -> None:
    shots = engine.simulate(dropped(trials(200, 80), 5), {"kappa": 0.4}, time_limit=3, record=True)
    events = shots.events
    begins = np.flatnonzero((events["kind"] == Event.ROLL) & (events["surface"] < 4))
    begins = begins[begins + 1 < len(events)]
    change = energy(events["before"][begins + 1], 0.4) - energy(events["after"][begins], 0.4)
    assert np.max(np.abs(change)) < 1e-12


def test_contacts_before_a_roll_on_a_cone_with_bounds_are_proved_or_flagged(
    engine: Engine,
) -> None:
    check_proofs(engine, dropped(trials(1000, 100), 2), None)


def test_a_scene_of_cones_with_bounds_that_is_turned_gives_turned_rolls(engine: Engine) -> None:
    check_turned(engine, dropped(trials(600, 200), 6))


def test_bounds_across_the_axis_of_a_cone_are_those_of_a_span() -> None:
    """The linear map of a span and the point of contact are two ways to the same edges."""
    spans = hoopgen.compile(funnel("funnel_with_a_span", span=(0.1, 0.5)))
    bounds = hoopgen.compile(funnel("funnel_with_bounds", within=["0.1 - z", "z - 0.5"]))
    states = dropped(trials(2000, 800), 3)[::4]
    first, other = (
        one.simulate(states, time_limit=3, fields=CLAIMS, record=True) for one in (spans, bounds)
    )
    sure = ~(first.uncertain | other.uncertain)
    assert np.count_nonzero(sure) > 0.9 * len(states)
    for name in ("outcome", "rolls", "counts"):
        assert np.array_equal(getattr(first, name)[sure], getattr(other, name)[sure])
    off = np.abs(first.state - other.state).reshape(-1, 3, 3).max(axis=2)
    assert np.all((off <= first.state_error + other.state_error)[sure])
    leaves = first.events[first.events["kind"] == Event.LEAVE]
    assert np.count_nonzero(leaves["surface"] == 0) > len(states) / 4
