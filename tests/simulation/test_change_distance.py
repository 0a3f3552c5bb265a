"""First-order distances to the next change of sequence, against bisection, and what is refused."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.core.variables import STATE
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import exceptions, occurrences, trials

SPEED = np.diag([1.0] + 7 * [0.0])
FRICTION = {"ring_friction": 0.3, "backboard_friction": 0.2}


def throws(n: int, seed: int = 5, speed: float = 7.2) -> dict[str, Any]:
    """Return arguments of releases, most of which touch something."""
    random = np.random.default_rng(seed)
    return {
        "speed": random.normal(speed, 0.15, n),
        "elevation": random.normal(0.9, 0.05, n),
        "azimuth": random.normal(0, 0.03, n),
        "backspin": random.normal(15, 5, n),
        "height": 2.1336,
        "distance": 4.191,
    }


def sequences(engine: Engine, parameters: Any, values: dict[str, Any]) -> list[tuple[int, ...]]:
    """Return the outcome and the bodies that each shot meets."""
    shots = engine.simulate(hoopgen.release(**values), parameters, record=True)
    ends = np.searchsorted(shots.events["shot"], np.arange(1, len(shots)))
    met = np.split(shots.events["surface"], ends)
    return [(int(o), *own.tolist()) for o, own in zip(shots.outcome, met, strict=True)]


def distances(engine: Engine, parameters: Any, values: dict[str, Any]) -> tuple[Any, Any]:
    """Return the shots, and the distances of their decisions in m/s of the speed."""
    states, by_release = hoopgen.release(**values, jacobian=True)
    shots = engine.simulate(states, parameters, derivatives=STATE, record=True)
    return shots, shots.change_distance(SPEED, release=by_release)


def beside_changes(
    engine: Engine, parameters: Any, values: dict[str, Any], away: float
) -> list[tuple[dict[str, Any], Any]]:
    """Return, on both sides of a change, speeds so far from it, and which shots they hold for."""
    low, high = values["speed"], values["speed"] + 0.03
    before, after = (sequences(engine, parameters, values | {"speed": v}) for v in (low, high))
    changes = np.array([one != other for one, other in zip(before, after, strict=True)])
    for _ in range(36):
        middle = (low + high) / 2
        now = sequences(engine, parameters, values | {"speed": middle})
        same = np.array([one == other for one, other in zip(now, before, strict=True)])
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    found = []
    for edge, speed in ((low, low - away), (high, high + away)):
        moved = values | {"speed": speed}
        here = sequences(engine, parameters, moved)
        beside = sequences(engine, parameters, values | {"speed": edge})
        same = np.array([one == other for one, other in zip(here, beside, strict=True)])
        found.append((moved, changes & same))
    return found


@pytest.mark.slow
@pytest.mark.parametrize(
    ("engine", "parameters", "speed"),
    [(hoopgen.HOOP, {}, 7.2), (hoopgen.COURT, FRICTION, 7.2), (hoopgen.AIR, {}, 7.5)],
    ids=["hoop", "court", "air"],
)
def test_the_distance_is_that_of_the_change_that_bisection_finds(
    engine: Engine, parameters: Mapping[str, float], speed: float
) -> None:
    away, met = 1e-7, set()
    shots = throws(trials(600), speed=speed)
    for values, known in beside_changes(engine, parameters, shots, away):
        shots, distance = distances(engine, parameters, values)
        known &= shots.differentiable
        assert known.sum() >= occurrences(150)
        share = distance[known].min(axis=1) / away
        # Another change may be nearer than the one that was found; none is overlooked.
        assert np.all(share < 1.3), share.max()
        assert np.sum(np.abs(share - 1.0) >= 0.02) < exceptions(0.03, len(share))
        met |= {shots.decisions[k] for k in distance[known].argmin(axis=1)}
    assert {"ring_touch", "ring_miss", "backboard_miss", "end_miss"} <= met


@pytest.mark.slow
def test_a_few_distances_are_those_of_bisection() -> None:
    for values, known in beside_changes(hoopgen.HOOP, {}, throws(30), 1e-7):
        shots, distance = distances(hoopgen.HOOP, {}, values)
        share = distance[known & shots.differentiable].min(axis=1) / 1e-7
        assert len(share) >= 5
        np.testing.assert_allclose(np.median(share), 1.0, rtol=0.02)


def test_the_rim_of_the_end_is_a_decision() -> None:
    """A shot that touches nothing ends at a place that changes as its release does."""
    state = np.array([2.0, 0.0, 0.5, -1.5, 0.0, 0.0, 0.0, 0.0, 0.0])
    shots = hoopgen.simulate(state, derivatives=("x",), record=True)
    assert shots.contacts[0] == 0
    rim = hoopgen.HOOP.parameters["ring_radius"]
    column = shots.decisions.index("end_edge")
    found = shots.change_distance()[0, column]
    np.testing.assert_allclose(found, shots.state[0, 0] - rim, rtol=1e-12)
    halved = shots.change_distance([[4.0]])[0, column]
    np.testing.assert_allclose(halved, found / 2, rtol=1e-12)


def test_the_distance_of_a_miss_is_that_of_the_ball_however_far_it_is() -> None:
    """A ball that falls straight down passes the ring where it is as high as the ring."""
    state = np.array([1.0, 0.0, 0.5, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0])
    for engine in (hoopgen.HOOP, hoopgen.COURT):
        shots = engine.simulate(state, derivatives=("x",), record=True)
        own = engine.parameters
        expected = 1.0 - own["ring_radius"] - own["wire_radius"] - own["ball_radius"]
        found = shots.change_distance()[0, shots.decisions.index("ring_miss")]
        np.testing.assert_allclose(found, expected, rtol=1e-12)


def test_the_end_is_no_decision_at_a_contact_with_a_plane_parallel_to_it() -> None:
    """On the bridge the ball is always as high above the end's plane."""
    states = np.array([[-0.25, -0.2, 0.4, 0.02, 1.0, -1.0, 0.0, 0.0, 0.0]])
    for engine in (hoopgen.HOOP, hoopgen.COURT):
        shots = engine.simulate(states, derivatives=STATE, record=True)
        assert shots.first[0] == shots.surfaces.index("bridge")
        assert shots.differentiable[0]
        distance = shots.change_distance()[0]
        assert distance[np.isfinite(distance)].max() < 1e3


@pytest.mark.slow
def test_no_distance_is_that_of_a_rounding_error() -> None:
    values = throws(trials(300), speed=7.5)
    for engine in (hoopgen.HOOP, hoopgen.COURT):
        shots, distance = distances(engine, {}, values)
        met = shots.differentiable & (shots.first == shots.surfaces.index("backboard"))
        assert met.sum() >= occurrences(20), met.sum()
        finite = distance[shots.differentiable]
        assert finite[np.isfinite(finite)].max() < 1e9
    # The core of the board, which the ball's centre reaches 12 cm behind its front, has no normal.
    assert np.isinf(distance[met, shots.decisions.index("backboard_touch")]).any()


@pytest.mark.slow
def test_grip_and_slip_are_a_decision_where_there_is_friction() -> None:
    values = throws(trials(200, at_least=40))
    assert not [name for name in distances(hoopgen.HOOP, {}, values)[0].decisions if "slip" in name]
    for friction, finite in ((0.3, True), (np.inf, False), (0.0, False)):
        given = {f"{name}_friction": friction for name in ("ring", "backboard", "bridge")}
        shots, distance = distances(hoopgen.COURT, given, values)
        slips = distance[shots.differentiable, shots.decisions.index("ring_slip")]
        assert np.isfinite(slips).any() == finite


@pytest.mark.slow
def test_the_distance_to_slip_is_where_the_contact_begins_to_slip() -> None:
    values = throws(60)
    shots, distance = distances(hoopgen.COURT, FRICTION, values)
    column = shots.decisions.index("ring_slip")
    first = shots.differentiable & (shots.contacts == 1) & (shots.first == 0)
    assert first.sum() >= 5
    for row in np.flatnonzero(first)[:8]:
        margins = []
        for side in (-1e-4, 0.0, 1e-4):
            one = {k: v[row] if np.ndim(v) else v for k, v in values.items()}
            state = hoopgen.release(**one | {"speed": one["speed"] + side})
            found = hoopgen.simulate(state, FRICTION, scene=hoopgen.COURT, record=True)
            margins.append(grip_margin(found.events[0], found))
        expected = abs(margins[1] / ((margins[2] - margins[0]) / 2e-4))
        np.testing.assert_allclose(distance[row, column], expected, rtol=1e-4)


def grip_margin(event: Any, shots: Any) -> float:
    """Return mu (1 + e) |v_n| - 0.4 |slip| of a contact with the ring, by hand."""
    own = shots.parameters
    place, v, w = event["before"][:3], event["before"][3:6], event["before"][6:]
    level = np.hypot(place[0], place[1])
    normal = place * (1 - own["ring_radius"] / level * np.array([1.0, 1.0, 0.0]))
    normal /= np.linalg.norm(normal)
    approach = v @ normal
    slip = v - approach * normal - own["ball_radius"] * np.cross(w, normal)
    slide = FRICTION["ring_friction"] * (1 + own["ring_restitution"]) * -approach
    return float(slide - 0.4 * np.linalg.norm(slip))


def test_shots_without_derivatives_have_no_distance() -> None:
    states = np.stack(
        [hoopgen.release(7.2, 0.9, height=2.1336, distance=4.191), np.full(9, np.nan)]
    )
    shots = hoopgen.simulate(states, derivatives=("vx",), record=True)
    distance = shots.change_distance()
    assert distance.shape == (2, len(shots.decisions))
    assert not np.isnan(distance[0]).any()
    assert np.isnan(distance[1]).all()
    with pytest.raises(AttributeError, match="record=True"):
        hoopgen.simulate(states, derivatives=("vx",)).change_distance()
    with pytest.raises(AttributeError, match="change_distance: simulate with derivatives="):
        hoopgen.simulate(states, record=True).change_distance()


def test_each_shot_may_have_its_own_covariance() -> None:
    states = hoopgen.release(np.array([7.1, 7.2]), 0.9, height=2.1336, distance=4.191)
    shots = hoopgen.simulate(states, derivatives=("vx", "restitution"), record=True)
    one, other = np.diag([0.01, 1e-4]), np.array([[0.04, 1e-3], [1e-3, 1e-4]])
    both = shots.change_distance(np.stack([one, other]))
    np.testing.assert_allclose(both[0], shots.change_distance(one)[0], rtol=1e-12)
    np.testing.assert_allclose(both[1], shots.change_distance(other)[1], rtol=1e-12)


@pytest.mark.parametrize(
    ("covariance", "text"),
    [
        ([1.0], r"covariance: expected shape \(2, 2\) or \(1, 2, 2\)"),
        ([[1.0, 0.5], [0.0, 1.0]], "covariance: expected a symmetric matrix"),
        ([[1.0, np.nan], [np.nan, 1.0]], "covariance: expected a symmetric matrix"),
        ([[1.0, 2.0], [2.0, 1.0]], "covariance: expected no negative variance"),
        ([[-1.0, 0.0], [0.0, 1.0]], "covariance: expected no negative variance"),
        ([[0.0, 0.1], [0.1, 1.0]], "covariance: expected no negative variance"),
    ],
)
def test_what_is_no_covariance_is_refused(covariance: Any, text: str) -> None:
    state = hoopgen.release(7.2, 0.9, height=2.1336, distance=4.191)
    shots = hoopgen.simulate(state, derivatives=("vx", "vz"), record=True)
    with pytest.raises(ValueError, match=text):
        shots.change_distance(covariance)
