"""Shots that go on from recorded events, and starts at the border of leaving a body: by the judge.

Without restitution a ball that has hit a body has no speed off it, and where a contact ends there
is neither a speed nor a force. Both are recorded with roundings, which decide nothing.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("flint")

import hoopgen
from hoopgen import Event
from hoopgen.scene import Box, Cylinder, End, Parameter, Scene, Sphere, Torus
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import trials

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("going_on"),  # the scene is compiled once
]

SHAPES = Scene(
    "shapes_in_a_row",
    parameters=[Parameter("loss", 0.5), Parameter("grip", 0.6, infinite=True)],
    bodies=[
        Sphere("ball", radius=0.5),
        Torus("ring", radius=0.4, wire=0.1, centre=(4, 0, 0)),
        Box("block", size=(0.6, 0.4, 0.3), centre=(8, 0, 0)),
        Cylinder("log", radius=0.3, axis="y", centre=(12, 0, 0)),
    ],
    ball_radius=0.1,
    gravity=9.81,
    restitution="1 - loss",
    friction="grip",
    rolls=True,
    ends={"past": End(at=-3)},
)
"""One body of each curvature; none is near another."""

LIMITS: dict[str, Any] = {"max_contacts": 20, "time_limit": 3}


@pytest.fixture(scope="module")
def shapes() -> Engine:
    return hoopgen.compile(SHAPES)


def drops(shots: int, seed: int) -> NDArray[np.float64]:
    """Return balls that are thrown at the bodies from above."""
    rng = np.random.default_rng(seed)
    states = np.zeros((shots, 9))
    states[:, :3] = rng.uniform((-0.6, -0.6, 0.6), (0.6, 0.6, 1.8), (shots, 3))
    states[:, 0] += 4 * rng.integers(4, size=shots)
    aim = rng.uniform(-0.4, 0.4, (shots, 3))
    aim[:, 0] = 4 * np.round(states[:, 0] / 4) + rng.uniform(-0.4, 0.4, shots)
    time = rng.uniform(0.2, 0.7, (shots, 1))
    states[:, 3:6] = (aim - states[:, :3]) / time + (0, 0, 9.81 / 2) * time
    states[:, 6:] = rng.normal(0, 10, (shots, 3))
    return states


@pytest.mark.parametrize("kind", [Event.IMPACT, Event.LEAVE])
@pytest.mark.parametrize("loss", [1.0, 0.5])
def test_a_shot_that_goes_on_from_a_record_is_as_the_judge_proves_it(
    shapes: Engine, loss: float, kind: Event
) -> None:
    parameters = {"loss": loss}
    shots = shapes.simulate(drops(4_000, 1), parameters, record=True, max_contacts=100)
    events = shots.events
    events = events[(events["kind"] == kind) & (events["surface"] < len(SHAPES.bodies))]
    events = events[np.argsort(events["surface"], kind="stable")]
    events = events[:: max(1, len(events) // trials(800, 160))]
    assert len(events) > 100
    assert len(np.unique(events["surface"])) == len(SHAPES.bodies)
    given = {"leaving": events["surface"], **LIMITS}
    on = shapes.simulate(events["after"], parameters, record=True, **given)
    proofs = shapes.certify(events["after"], parameters, **given)
    known = proofs.decided | proofs.accumulates
    assert np.mean(known) > 0.9
    assert np.all(proofs.agrees(on)[known])
    block = shapes.surfaces.index("block")  # records at its edges are flagged
    assert np.mean(on.uncertain[events["surface"] != block]) < 0.05


def check_the_judge_of_records(kind: Event) -> None:
    """The judge of shots that go on, beside the engine as it is."""
    test_a_shot_that_goes_on_from_a_record_is_as_the_judge_proves_it(
        hoopgen.compile(SHAPES), 1.0, kind
    )


OFF = [-1e-3, -1e-6, -1e-8, -1e-10, -1e-15, 0, 1e-15, 1e-10, 1e-8, 1e-6, 1e-3]
"""Speeds off a body, m/s: the limit of roundings is between 1e-14 and 1e-12."""


@pytest.mark.parametrize("loss", [1.0, 0.5])
@pytest.mark.parametrize("angle", [0.3, 1.2])
@pytest.mark.parametrize(("body", "centre", "reach"), [("ball", 0.0, 0.6), ("ring", 4.4, 0.2)])
def test_a_ball_starts_into_along_or_off_a_body_as_the_judge_proves_it(
    shapes: Engine, body: str, centre: float, reach: float, angle: float, loss: float
) -> None:
    """Along it to roundings it has no impact; with a velocity into it, it has one at time 0."""
    normal = np.array([math.sin(angle), 0, math.cos(angle)])
    along = np.array([math.cos(angle), 0, -math.sin(angle)])
    states = np.zeros((len(OFF), 9))
    states[:, :3] = np.array([centre, 0, 0]) + reach * normal
    states[:, 3:6] = 2 * along + np.array(OFF)[:, None] * normal
    states[:, 7] = 20
    given: dict[str, Any] = {"leaving": body, **LIMITS}
    shots = shapes.simulate(states, {"loss": loss}, record=True, **given)
    proofs = shapes.certify(states, {"loss": loss}, **given)
    assert np.all(proofs.agrees(shots))
    sure = np.abs(OFF) != 1e-10
    assert not shots.uncertain[sure].any()
    if angle < 1:
        return  # a body that presses it on takes the smallest of these for a roll at once
    rows = shots.events["shot"][
        (shots.events["kind"] == Event.IMPACT) & (shots.events["time"] == 0)
    ]
    struck = np.isin(np.arange(len(OFF)), rows)
    assert np.array_equal(struck, np.array(OFF) < -1e-12)


@pytest.mark.parametrize(
    ("body", "place", "normal"),
    [
        ("ball", (0.36, 0, 0.48), (0.6, 0, 0.8)),
        ("ring", (4.52, 0, 0.16), (0.6, 0, 0.8)),
        ("block", (8.36, 0, 0.23), (0.6, 0, 0.8)),
        ("log", (12.24, 0, 0.32), (0.6, 0, 0.8)),
    ],
)
def test_the_time_of_a_tiny_hop_from_a_start_is_within_its_error(
    shapes: Engine, body: str, place: tuple[float, ...], normal: tuple[float, ...]
) -> None:
    """The ball slips, so that it does not roll at once."""
    parameters = {"loss": 1.0, "grip": math.inf}
    states = np.zeros((trials(400, 60), 9))
    rng = np.random.default_rng(3)
    off = 10 ** rng.uniform(-11, -4, len(states))
    states[:, :3] = place
    states[:, 3:6] = rng.uniform(-0.3, 0.3, (len(states), 1)) * (0.8, 0, -0.6)
    states[:, 4] = rng.uniform(-0.3, 0.3, len(states))
    states[:, 3:6] += off[:, None] * np.array(normal)
    given: dict[str, Any] = {"leaving": body, "max_contacts": 1, "time_limit": 3}
    fields = ("outcome", "uncertain", "time", "time_error")
    shots = shapes.simulate(states, parameters, record=True, fields=fields, **given)
    proofs = shapes.certify(states, parameters, record=True, **given)
    errors = proofs.event_errors(shots)["time_error"]
    kinds = shots.events["kind"]
    impacts = (kinds == Event.IMPACT) & (shots.events["surface"] < len(SHAPES.bodies))
    impacts &= ~shots.uncertain[shots.events["shot"]]
    assert impacts.sum() > len(states) / 2
    assert np.isfinite(errors[impacts]).all()
    own = shots.events["shot"][impacts]
    assert np.all(errors[impacts] <= shots.time_error[own])


def test_a_force_that_may_press_the_ball_on_is_undecided(shapes: Engine) -> None:
    """A sphere does not hold a ball with v² = g R n_z, and holds a slower one, which then slips."""
    normal = np.array([0.6, 0, 0.8])
    speed = math.sqrt(9.81 * 0.6 * 0.8)
    parts = 1 + np.array([-1e-6, -1e-12, -1e-15, 0, 1e-15, 1e-12, 1e-6])
    states = np.zeros((len(parts), 9))
    states[:, :3] = 0.6 * normal
    states[:, 4] = speed * parts
    states[:, 6:] = np.cross(normal, states[:, 3:6]) / 0.1
    given: dict[str, Any] = {"leaving": "ball", **LIMITS}
    shots = shapes.simulate(states, {"loss": 1.0}, record=True, **given)
    ends = [shapes.outcomes[name] for name in ("CAPPED", "PAST")]
    assert shots.outcome[[0, -1]].tolist() == ends
    assert not shots.uncertain[[0, -1]].any()
    proofs = shapes.certify(states, {"loss": 1.0}, **given)
    known = proofs.decided | proofs.accumulates
    assert np.all(proofs.agrees(shots)[known])
    assert shots.uncertain[2:-2].any()


def test_a_ball_that_may_stay_on_a_box_is_flagged_on_its_seams_alone(shapes: Engine) -> None:
    """There it is the rounding of a place that decides whether the ball is on face or edge."""
    states = np.zeros((3, 9))
    states[:, 0] = 8.3, 8.3 - 1e-9, 8.2
    states[:, 1], states[:, 2] = 0.05, 0.25
    rolling = states.copy()
    rolling[:, 3], rolling[:, 7] = -1, -10
    shots = shapes.simulate(rolling, leaving="block", time_limit=0.05)
    assert shots.uncertain.tolist() == [True, False, False]
    states[:, 2] = 0.5
    shots = shapes.simulate(states, {"loss": 1.0}, time_limit=1)
    assert shots.uncertain.tolist() == [True, False, False]


def test_the_judge_has_a_ball_leave_a_face_over_its_seam() -> None:
    """On the edge v² > g R: the ball flies off, and does not touch the face again at once."""
    state = [8.3, 0.05, 0.25, 1.2, 0, 0, 0, 12, 0]
    for loss in (1.0, 0.5):
        proof = hoopgen.certify(state, {"loss": loss}, scene=SHAPES, leaving="block", **LIMITS)[0]
        assert proof.surfaces == [len(SHAPES.bodies)]
        assert proof.hops == -1


@pytest.mark.parametrize("grip", [0.6, math.inf])
def test_a_contact_without_restitution_where_nothing_presses_the_ball_on_is_undecided(
    shapes: Engine, grip: float
) -> None:
    """Neighbouring releases roll, or leave at once: those between them are flagged."""
    parameters = {"loss": 1.0, "grip": grip}
    states = np.zeros((3, 9))
    states[:, :3] = 4.19087168913815827, -0.0968840764698139, 1.1961384497392173
    states[:, 3] = 0.1, 0.19568914968140605, 0.3
    low, high = states[0].copy(), states[2].copy()

    def leaves(state: NDArray[np.float64]) -> bool:
        shot = shapes.simulate(state, parameters, **LIMITS)
        return bool(shot.rolls[0] == 0)

    assert leaves(low) != leaves(high)
    first = leaves(low)
    for _ in range(60):
        middle = low + (high - low) / 2
        if leaves(middle) == first:
            low = middle
        else:
            high = middle
    near = np.repeat(low[None], 41, axis=0)
    near[:, 3] += np.spacing(low[3]) * np.arange(-20, 21)
    shots = shapes.simulate(near, parameters, record=True, **LIMITS)
    assert len(np.unique(shots.rolls)) > 1
    assert np.all(shapes.certify(near, parameters, **LIMITS).agrees(shots))
    assert shots.uncertain.all()
