"""Derivatives of shots: to 70 digits, in both engines, in chains, and where there are none."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.core.event_log import Event
from hoopgen.core.variables import STATE
from hoopgen.scene import End, Plane, Scene
from hoopgen.simulation.engine import Engine
from tests.helpers import ROOT
from tests.helpers.effort import trials

pytest.importorskip("sympy")
pytest.importorskip("mpmath")
pytest.importorskip("flint")

import mpmath

from tests.helpers.precise_path import PreciseScene
from tests.helpers.scenes.leaning import LEANING

FREE_THROW = {"height": 2.1336, "distance": 4.191}
MAX_CONTACTS = 12
"""Contacts up to which derivatives are compared. Each contact multiplies their errors."""

BOARD = ("ring_radius", "wire_radius", "ball_radius", "board_distance", "gravity", "end_depth")


def throws(n: int, seed: int = 7) -> Any:
    """Return free throws with spin about every axis, most of which touch something."""
    random = np.random.default_rng(seed)
    states = hoopgen.release(
        random.normal(7.2, 0.15, n),
        random.normal(0.9, 0.05, n),
        random.normal(0, 0.03, n),
        backspin=random.normal(15, 5, n),
        sidespin=random.normal(0, 5, n),
        **FREE_THROW,
    )
    states[:, 6] += random.normal(0, 5, n)
    return states


def truth(
    engine: Engine,
    states: Any,
    parameters: Mapping[str, float],
    names: tuple[str, ...],
    rows: Any,
    precise_scene: type[PreciseScene],
) -> Any:
    """Return the derivatives at all events of some shots to many digits, (events, 19, k)."""
    precise = precise_scene(engine.scene)
    values = dict(engine.parameters) | dict(parameters)
    inputs = engine.table.inputs(values)
    changes = {}
    for name in names:
        own = [float(name == one) for one in STATE]
        given = engine.table.changes(values, name) if name not in STATE else [0.0] * len(inputs)
        changes[name] = [*own, *map(float, given)]
    shots = engine.simulate(states[rows], parameters, record=True)
    found = []
    bodies, ends = engine.scene.bodies, engine.scene.end_planes
    for index in range(len(rows)):
        events = []
        for event in shots.events[shots.events["shot"] == index]:
            ended = event["kind"] == Event.END
            body = None if ended else bodies[event["surface"]]
            faces = ends if body is None else body.faces
            place = list(event["before"][:3])
            gaps = [abs(precise.gap(face, place, inputs)) for face in faces]
            law = None if body is None else body.law
            events.append((faces[gaps.index(min(gaps))], law, float(event["time"])))
        found.append(precise.derivatives(states[rows[index]], inputs, events, changes))
    return np.concatenate(found)


def check_against_truth(
    engine: Engine,
    states: Any,
    parameters: Mapping[str, float],
    names: tuple[str, ...],
    most: int,
    precise_scene: type[PreciseScene] = PreciseScene,
    **options: Any,
) -> Any:
    """Compare derivatives at all events with many digits; return the shots' numbers of contacts."""
    shots = engine.simulate(states, parameters, derivatives=names, **options)
    rows = np.flatnonzero(shots.differentiable)
    rows = rows[shots.contacts[rows] <= MAX_CONTACTS][:most]
    expected = truth(engine, states, parameters, names, rows, precise_scene)
    again = engine.simulate(states[rows], parameters, derivatives=names, record=True)
    at_events, ended = again.event_jacobian, again.events["kind"] == Event.END
    matrices = [at_events[name] for name in ("before", "after", "time")]
    found = np.concatenate(matrices, axis=1)
    for name, matrix in (("state", found[ended, 9:18]), ("time", found[ended, 18:])):
        np.testing.assert_array_equal(matrix, shots.jacobian[name][rows])
    size = np.abs(expected).max(axis=(1, 2))
    error = np.abs(found - expected).max(axis=(1, 2)) / size
    # The path in doubles is itself off by some 1e-16, times what a change of the release grows by.
    assert np.all(error < 1e-13 * np.maximum(1.0, size)), error.max()
    assert np.all(error < 1e-8), error.max()
    return shots.contacts[rows]


@pytest.mark.parametrize(
    ("engine", "parameters", "names"),
    [
        pytest.param(hoopgen.HOOP, {}, (*STATE, "restitution", *BOARD), id="hoop"),
        pytest.param(
            hoopgen.COURT,
            {"ring_friction": 0.3, "backboard_friction": 0.2, "restitution_speed": 40.0},
            (
                *STATE,
                *BOARD,
                *("ring_restitution", "backboard_restitution", "ring_friction", "inertia"),
                *("backboard_friction", "tangential_restitution", "restitution_speed"),
            ),
            id="court",
            marks=pytest.mark.slow,
        ),
        pytest.param(hoopgen.COURT, {}, (*STATE, "tangential_restitution"), id="court-usual"),
    ],
)
def test_derivatives_are_those_of_70_digits(
    engine: Engine, parameters: Mapping[str, float], names: tuple[str, ...]
) -> None:
    contacts = check_against_truth(engine, throws(40), parameters, names, trials(12, at_least=3))
    assert contacts.max() >= 3


@pytest.mark.slow
@pytest.mark.parametrize("engine", [hoopgen.HOOP, hoopgen.COURT], ids=["hoop", "court"])
def test_derivatives_of_many_shots_are_those_of_70_digits(engine: Engine) -> None:
    contacts = check_against_truth(engine, throws(430, 11), {}, (*STATE, *BOARD), 400)
    assert len(contacts) == 400
    assert contacts.max() >= 8


@pytest.mark.slow
def test_derivatives_in_a_scene_of_formulas_are_those_of_70_digits() -> None:
    engine = hoopgen.compile(hoopgen.load_scene(ROOT / "examples" / "scenes" / "netball.toml"))
    random = np.random.default_rng(5)
    states = np.zeros((200, 9))
    states[:, 0], states[:, 2] = 2.0, -0.9
    states[:, 3] = random.normal(-2.0, 0.1, 200)
    states[:, 5] = random.normal(5.8, 0.1, 200)
    states[:, 7] = 10.0
    contacts = check_against_truth(engine, states, {}, (*STATE, *engine.parameters), 100)
    assert len(contacts) == 100
    assert contacts.max() >= 1


@pytest.mark.slow
def test_derivatives_through_surfaces_of_revolution_are_those_of_70_digits() -> None:
    """In the funnel and the bottle of the examples, also by the size of their profile."""
    engine = hoopgen.compile(hoopgen.load_scene(ROOT / "examples" / "scenes" / "funnel.toml"))
    random = np.random.default_rng(1)
    states = np.zeros((300, 9))
    states[:, :2] = random.uniform(-0.3, 0.3, (300, 2))
    states[:, 2] = random.uniform(0.3, 0.8, 300)
    states[:, 3:6] = random.normal(0, 0.5, (300, 3))
    states[:, 6:] = random.normal(0, 5, (300, 3))
    met = engine.simulate(states, fields=["contacts"]).contacts
    contacts = check_against_truth(
        engine, states[met > 0], {}, (*STATE, *engine.parameters), trials(60, at_least=20)
    )
    assert contacts.max() >= 5


@pytest.mark.slow
def test_derivatives_among_leaning_bodies_are_those_of_70_digits() -> None:
    engine = hoopgen.compile(LEANING)
    random = np.random.default_rng(3)
    states = np.zeros((200, 9))
    states[:, :2] = random.uniform(-0.8, 0.8, (200, 2))
    states[:, 2] = random.uniform(0.3, 1.5, 200)
    states[:, 3:6] = random.normal(0, 1, (200, 3))
    states[:, 6:] = random.normal(0, 10, (200, 3))
    counts = engine.simulate(states, fields=["counts", "outcome"]).counts
    assert np.all(counts.sum(axis=0) > 20)
    contacts = check_against_truth(engine, states, {}, (*STATE, *engine.parameters), 100)
    assert len(contacts) == 100
    assert contacts.max() >= 8


@pytest.mark.slow
@pytest.mark.parametrize("engine", [hoopgen.HOOP, hoopgen.COURT], ids=["hoop", "court"])
def test_both_engines_give_the_same_bits(engine: Engine) -> None:
    states = throws(300)
    names = ("vx", "wz", "gravity", "ball_radius")
    found = [
        engine.simulate(states, backend=backend, derivatives=names, record=True)
        for backend in ("c", "numpy")
    ]
    for one, other in zip(*(shots.event_jacobian.values() for shots in found), strict=True):
        assert np.array_equal(one, other, equal_nan=True)
    for one, other in zip(*(shots.jacobian.values() for shots in found), strict=True):
        assert np.array_equal(one, other, equal_nan=True)
    assert np.array_equal(*(shots.differentiable for shots in found))


def test_a_shot_that_touches_nothing_has_the_derivatives_of_a_parabola() -> None:
    state = hoopgen.release(7.17, 0.9, height=2.1336, distance=4.191)
    shots = hoopgen.simulate(state, derivatives=("vx", "vz", "gravity"))
    assert shots.contacts[0] == 0
    t, vx, vz = shots.time[0], state[3], shots.state[0, 5]
    # z falls to a height that does not vary: dz + vz dt = 0.
    np.testing.assert_allclose(shots.jacobian["time"][0, 0], [0, -t / vz, t**2 / 2 / vz], 1e-12)
    expected = [t, -vx * t / vz, vx * t**2 / 2 / vz]
    np.testing.assert_allclose(shots.jacobian["state"][0, 0], expected, 1e-12)


def test_derivatives_chain_with_those_of_a_release() -> None:
    values = {"speed": 7.1, "elevation": 0.91, "azimuth": 0.02, "backspin": 12.0, "sidespin": 1.0}
    values |= {"height": 2.1, "distance": 4.2, "angle": 0.1}
    states, by_release = hoopgen.release(**values, jacobian=True)
    shots = hoopgen.simulate(states, derivatives=(*STATE, "restitution"))
    chained = shots.jacobian.chain(by_release)
    assert chained.names == (*values, "restitution")
    assert chained["state"].shape == (1, 9, 9)
    for column, name in enumerate(values):
        step = 1e-6
        ends = [
            hoopgen.simulate(hoopgen.release(**values | {name: values[name] + sign * step})).state
            for sign in (1, -1)
        ]
        expected = (ends[0] - ends[1])[0] / (2 * step)
        np.testing.assert_allclose(chained["state"][0, :, column], expected, rtol=1e-5, atol=1e-5)


def test_a_release_has_its_derivatives_whatever_its_shape() -> None:
    states, jacobian = hoopgen.release(
        np.array([[7.0], [7.2]]), np.array([0.8, 0.9, 1.0]), **FREE_THROW, jacobian=True
    )
    assert states.shape == (2, 3, 9)
    assert jacobian["state"].shape == (2, 3, 9, 8)
    one = hoopgen.release(7.2, 0.9, **FREE_THROW, jacobian=True)[1]["state"]
    np.testing.assert_array_equal(jacobian["state"][1, 1], one)


def test_parameters_by_shot_have_their_own_derivatives() -> None:
    states = np.repeat(throws(1), 3, axis=0)
    restitution = np.array([0.6, 0.7, 0.8])
    together = hoopgen.simulate(states, {"restitution": restitution}, derivatives=("restitution",))
    for index, value in enumerate(restitution):
        alone = hoopgen.simulate(
            states[index], {"restitution": value}, derivatives=("restitution",)
        )
        np.testing.assert_array_equal(together.jacobian["state"][index], alone.jacobian["state"][0])


def test_shots_without_derivatives_say_so() -> None:
    capped = hoopgen.release(7.2, 0.9, height=2.1336, distance=4.191)
    invalid = np.full(9, np.nan)
    touching = throws(1)[0]
    states = np.stack([capped, invalid, touching])
    shots = hoopgen.simulate(states, derivatives=("vx",), max_contacts=1)
    assert np.array_equal(
        shots.differentiable, (shots.outcome <= hoopgen.Outcome.MISSED) & ~shots.uncertain
    )
    assert not shots.differentiable.all()
    assert np.isnan(shots.jacobian["state"][~shots.differentiable]).all()
    assert np.isfinite(shots.jacobian["state"][shots.differentiable]).all()


def test_a_ball_that_rolls_has_no_derivatives() -> None:
    state = np.array([-0.2, 0.0, 0.4, 0.05, 0.0, 0.0, 0.0, 0.0, 0.0])
    random = np.random.default_rng(2)
    states = state + 0.02 * random.normal(size=(200, 9))
    shots = hoopgen.simulate(
        states, {"ring_restitution": 0.0}, scene=hoopgen.COURT, derivatives=("x",), record=True
    )
    stays = np.unique(
        shots.events["shot"][np.isin(shots.events["kind"], (Event.ROLL, Event.LEAVE))]
    )
    assert len(stays)
    assert not shots.differentiable[stays].any()
    kinds, matrix = shots.events["kind"], shots.event_jacobian["after"]
    assert np.isnan(matrix[np.isin(kinds, (Event.ROLL, Event.LEAVE))]).all()
    own = np.isin(shots.events["shot"], stays) & (kinds == Event.IMPACT)
    assert np.isfinite(matrix[own]).any()


def test_a_shot_without_an_end_has_derivatives_at_its_contacts() -> None:
    states, names = throws(100), ("vx", "gravity")
    whole = hoopgen.simulate(states, derivatives=names, record=True)
    capped = hoopgen.simulate(states, derivatives=names, record=True, max_contacts=1)
    second = np.flatnonzero(whole.differentiable & (whole.contacts > 1))
    assert not capped.differentiable[second].any()
    rows = [np.searchsorted(shots.events["shot"], second) for shots in (whole, capped)]
    for name, matrix in capped.event_jacobian.items():
        np.testing.assert_array_equal(matrix[rows[1]], whole.event_jacobian[name][rows[0]])
        assert np.isfinite(matrix[rows[1]]).all()


def test_derivatives_at_events_chain_with_those_of_each_shot_s_release() -> None:
    speeds = np.array([7.1, 7.2, 7.3])
    states, by_release = hoopgen.release(speeds, 0.9, **FREE_THROW, jacobian=True)
    shots = hoopgen.simulate(states, derivatives=STATE, record=True)
    assert len(shots.events) > 3
    chained = shots.event_jacobian.chain(by_release)
    ends = shots.events["kind"] == Event.END
    np.testing.assert_array_equal(chained["after"][ends], shots.jacobian.chain(by_release)["state"])
    two = hoopgen.release(speeds[:2], 0.9, **FREE_THROW, jacobian=True)[1]
    with pytest.raises(ValueError, match="release: expected the Jacobian of all shots"):
        shots.event_jacobian.chain(two)


def test_derivatives_have_names_and_units_in_xarray() -> None:
    pytest.importorskip("xarray")
    names = ("vx", "gravity", "restitution")
    shots = hoopgen.simulate(throws(10), derivatives=names, record=True)
    dataset = shots.to_xarray()
    assert dataset["variable_unit"].values.tolist() == ["m/s", "m/s2", ""]
    one = dataset["state_derivative"].sel(variable="gravity", component="x")
    np.testing.assert_array_equal(one, shots.jacobian["state"][:, 0, 1])
    at_events = dataset["after_derivative"].sel(variable="vx", component="vz")
    np.testing.assert_array_equal(at_events, shots.event_jacobian["after"][:, 5, 0])
    assert at_events["event_surface"].values[0] in (*hoopgen.SURFACES, "end")
    with pytest.raises(AttributeError, match=r"event_jacobian: .* and record=True to have it"):
        _ = hoopgen.simulate(throws(1), derivatives=names).event_jacobian
    assert "after_derivative" not in hoopgen.simulate(throws(1), derivatives=names).to_xarray()


@pytest.mark.slow
def test_the_height_of_a_bouncing_ball_at_a_time_has_the_derivatives_of_its_formula() -> None:
    """Dropped from h, the ball falls for sqrt(2h/g) and then flies for 2 e^k sqrt(2h/g)."""
    floor = Scene(
        "floor",
        bodies=[Plane("floor", at=0)],
        ball_radius=0.1,
        gravity=9.81,
        restitution=0.8,
        ends={"side": End(axis="x", at=10)},
    )
    shots = hoopgen.simulate(
        [0, 0, 1.1, 0, 0, 0, 0, 0, 0],
        scene=floor,
        derivatives=["z"],
        record=True,
        max_contacts=8,
    )
    events, jacobian = shots.events, shots.event_jacobian
    g, e = mpmath.mpf(9.81), mpmath.mpf(0.8)

    def height(bounces: int, time: float, drop: Any) -> Any:
        down = mpmath.sqrt(2 * drop / g)
        since = time - down * (1 + 2 * sum(e**k for k in range(1, bounces)))
        return g * down * e**bounces * since - g * since**2 / 2

    for bounces, time in ((1, 0.6), (2, 1.2), (2, 1.6), (3, 1.9)):
        last = bounces - 1
        assert events["time"][last] < time < events["time"][bounces]
        later = jacobian["time"][last, 0, 0]
        up = jacobian["after"][last, 5, 0] + 9.81 * later
        place = jacobian["after"][last, 2, 0] - events["after"][last, 5] * later
        found = place + up * (time - events["time"][last])
        drop = mpmath.mpf(1.1) - mpmath.mpf(0.1)
        with mpmath.workdps(50):
            expected = mpmath.diff(lambda h, b=bounces, t=time: height(b, t, h), drop)
        assert found == pytest.approx(float(expected), rel=1e-12)


def test_nothing_else_changes_with_derivatives() -> None:
    states = throws(50)
    plain = hoopgen.simulate(states, fields=("time",))
    shots = hoopgen.simulate(states, fields=("time",), derivatives=("vx",))
    np.testing.assert_array_equal(plain.time, shots.time)
    for name in ("events", "outcome", "uncertain"):
        with pytest.raises(AttributeError):
            getattr(shots, name)
    with pytest.raises(AttributeError, match="derivatives="):
        _ = plain.jacobian


@pytest.mark.parametrize(
    ("names", "error", "text"),
    [
        ("vx", TypeError, "derivatives: expected names in a list or a mapping, got 'vx'"),
        ([], ValueError, "derivatives: no name; expected each name once"),
        (["vx", "vx"], ValueError, "derivatives: vx twice"),
        (["speed"], ValueError, "derivatives: .*speed"),
    ],
)
def test_bad_names_of_derivatives(names: Any, error: type[Exception], text: str) -> None:
    with pytest.raises(error, match=text):
        hoopgen.simulate(throws(1), derivatives=names)


def test_a_chain_needs_all_that_the_releases_depend_on() -> None:
    states, by_release = hoopgen.release(7.1, 0.9, **FREE_THROW, jacobian=True)
    shots = hoopgen.simulate(states, derivatives=("vx",))
    with pytest.raises(ValueError, match=r"derivatives: x, y, z, vy, vz, .* missing"):
        shots.jacobian.chain(by_release)


def test_tangents_and_cotangents_agree() -> None:
    states = throws(20)
    random = np.random.default_rng(4)
    tangents = {"vx": random.normal(size=20), "restitution": 0.3, "z": -1.0}
    shots, changes = hoopgen.jvp(states, None, tangents)
    matrix = hoopgen.simulate(states, derivatives=tuple(tangents)).jacobian["state"]
    columns = [np.broadcast_to(value, 20) for value in tangents.values()]
    np.testing.assert_allclose(changes["state"], np.einsum("nik,kn->ni", matrix, columns), 1e-12)
    weights = {"state": random.normal(size=(20, 9)), "time": random.normal(size=20)}
    _, gradients = hoopgen.vjp(states, None, weights)
    assert set(gradients) == {*STATE, *hoopgen.HOOP.parameters}
    forward = (weights["state"] * changes["state"]).sum(1) + weights["time"] * changes["time"]
    backward = sum(gradients[name] * np.asarray(value) for name, value in tangents.items())
    known = shots.differentiable
    np.testing.assert_allclose(forward[known], np.asarray(backward)[known], 1e-9)


@pytest.mark.parametrize("backend", ["auto", "numpy"])
def test_no_shots_have_no_derivatives_and_no_gradients(backend: Any) -> None:
    none = np.zeros((0, 9))
    _, changes = hoopgen.jvp(none, None, {"vx": 1.0}, backend=backend)
    assert {name: change.shape for name, change in changes.items()} == {
        "state": (0, 9),
        "time": (0,),
    }
    for weights in ({"time": 1.0}, {"state": np.ones(9)}, {"state": none, "time": np.zeros(0)}):
        _, gradients = hoopgen.vjp(none, None, weights, backend=backend)
        assert {gradient.shape for gradient in gradients.values()} == {(0,)}


@pytest.mark.parametrize(
    ("tangents", "error", "text"),
    [
        ({"speed": 1.0}, ValueError, "^tangents: .*speed"),
        ({}, ValueError, "^tangents: no name"),
        ([1.0, 2.0], TypeError, r"^tangents: expected changes by name, got \[1.0, 2.0\]"),
        ({"vx": [1.0, 2.0]}, ValueError, r"^tangents\['vx'\]: expected one number or 1"),
    ],
)
def test_bad_tangents(tangents: Any, error: type[Exception], text: str) -> None:
    with pytest.raises(error, match=text):
        hoopgen.jvp(throws(1), None, tangents)


def test_products_do_not_take_the_names_of_derivatives() -> None:
    with pytest.raises(TypeError, match=r"^derivatives: those by tangents are returned; leave it"):
        hoopgen.jvp(throws(1), None, {"vx": 1.0}, derivatives=("vx",))  # type: ignore[call-arg]
    with pytest.raises(TypeError, match=r"^derivatives: those by all variables are returned"):
        hoopgen.vjp(throws(1), None, {"time": 1.0}, derivatives=("vx",))  # type: ignore[call-arg]


def test_cotangents_and_chains_of_the_wrong_type_are_named() -> None:
    with pytest.raises(TypeError, match=r"^cotangents: expected weights by name"):
        hoopgen.vjp(throws(1), None, np.ones(9))  # type: ignore[arg-type]
    shots = hoopgen.simulate(throws(1), derivatives=("vx",))
    with pytest.raises(TypeError, match=r"^release: expected the Jacobian .*, got a ndarray"):
        shots.jacobian.chain(np.eye(9))  # type: ignore[arg-type]
