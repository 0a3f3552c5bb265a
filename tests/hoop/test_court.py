"""The whole hoop, `COURT`: what bodies do from every side, and what counts as made."""

from __future__ import annotations

import math
import pickle
import subprocess
import sys
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.scenes import COURT as DERIVED
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.generated.numpy import court as kernels
from numpy.typing import NDArray

import hoopgen
from benchmarks.penetration import deepest
from hoopgen import COURT, FIBA_COURT, NBA_COURT, PAPER_COURT
from hoopgen.scene.geometry import SceneGeometry
from tests.helpers.court_shots import KINDS, all_kinds, thrown
from tests.helpers.effort import exceptions, trials

Floats = NDArray[np.float64]
Outcome = COURT.outcomes

MADE, MISSED, SHORT, INVALID = Outcome.MADE, Outcome.MISSED, Outcome.SHORT, Outcome.INVALID
RING, BOARD, BRIDGE = range(3)
EPS = float(np.finfo(float).eps)
BACKENDS = ("c", "numpy")
PRESETS = {"paper": PAPER_COURT, "nba": NBA_COURT, "fiba": FIBA_COURT}

pytestmark = pytest.mark.xdist_group("court")


def at(place: Any, velocity: Any = (0, 0, 0), spin: Any = (0, 0, 0)) -> Floats:
    return np.array([*place, *velocity, *spin], float)


def flown(states: Any, parameters: Any = None, **options: Any) -> hoopgen.Shots:
    return hoopgen.simulate(states, parameters, scene=COURT, **options)


# -- It comes with hoopgen


def test_its_parameters_bodies_and_outcomes_are_those_that_are_promised() -> None:
    sizes = "ball_radius ring_radius wire_radius board_distance board_half_width board_bottom"
    sizes += " board_top board_thickness bridge_half_width bridge_depth gravity end_depth"
    each = [f"{b}_{what}" for what in ("restitution", "friction") for b in COURT.surfaces]
    expected = [*sizes.split(), *each, "inertia", "tangential_restitution", "restitution_speed"]
    assert list(COURT.parameters) == expected
    assert COURT.surfaces == ("ring", "backboard", "bridge")
    assert [outcome.name for outcome in Outcome] == [o.name for o in hoopgen.Outcome]


@pytest.mark.slow
def test_running_it_needs_no_sympy_and_compiles_nothing() -> None:
    code = """
import sys, hoopgen
shots = hoopgen.simulate([[0, 0, 1, 0, 0, 0, 0, 0, 0]], scene=hoopgen.COURT)
assert shots.made.all() and shots.scene is hoopgen.COURT
print(*sorted({"sympy", "jinja2", "hoopgen.simulation.compile"} & set(sys.modules)))
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == []


def test_its_definition_is_known_and_it_can_be_sent_to_a_process() -> None:
    assert hoopgen.compile(DERIVED) is COURT
    assert hoopgen.compile(COURT) is COURT
    assert pickle.loads(pickle.dumps(COURT)) is COURT
    assert COURT.scene is DERIVED
    assert {"court.c", "court_engine.h"} <= COURT.source("c").keys()


# -- What is allowed


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize(
    "wrong",
    [
        {"ring_friction": -0.1},
        {"bridge_friction": math.nan},
        {"backboard_friction": -math.inf},
        {"restitution_speed": 0.0},
        {"restitution_speed": -1.0},
        {"restitution_speed": math.nan},
        {"inertia": 0.0},
        {"inertia": -2 / 3},
        {"inertia": 1 / 65},
        {"inertia": 2.0},
        {"inertia": math.nan},
        {"inertia": math.inf},
        {"tangential_restitution": math.nan},
        {"board_thickness": 0.0},
        {"board_thickness": math.inf},
        {"bridge_depth": -0.1},
        {"gravity": math.inf},
        {"bridge_half_width": 1.0},  # wider than the board
        {"board_distance": 0.24},  # the board cuts the ring
        {"board_top": -0.2},  # below its lower edge
        {"ball_radius": 0.23},  # does not fit through the ring
    ],
)
def test_what_is_not_allowed_makes_its_own_row_invalid(
    wrong: dict[str, float], backend: Any
) -> None:
    rows = {name: np.array([PAPER_COURT[name], value]) for name, value in wrong.items()}
    states = np.tile(at((0, 0, 1.5)), (2, 1))
    shots = flown(states, rows, backend=backend)
    assert shots.outcome.tolist() == [MADE, INVALID]
    assert np.isnan(shots.state[1]).all()
    one = hoopgen.certify(states, rows, scene=COURT)
    assert one.outcome.tolist() == [MADE, INVALID]


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("ring_restitution", 1.01),
        ("bridge_restitution", -0.1),
        ("backboard_restitution", math.inf),
        ("tangential_restitution", -1.1),
        ("tangential_restitution", 1.1),
        ("inertia", 0.0),
        ("inertia", 2.0),
    ],
)
def test_one_number_for_all_out_of_its_limits_is_an_error_that_names_it(
    name: str, value: float
) -> None:
    with pytest.raises(ValueError, match=rf"parameters\['{name}'\]: expected [-.0-9]+ to 1, got"):
        flown(at((0, 0, 1)), {name: value})
    rows = {name: np.array([PAPER_COURT[name], value])}
    assert flown(np.tile(at((0, 0, 1.5)), (2, 1)), rows).outcome.tolist() == [MADE, INVALID]


@pytest.mark.parametrize("backend", BACKENDS)
def test_friction_and_its_speed_may_be_infinite_or_large(backend: Any) -> None:
    given = {f"{body}_friction": np.array([np.inf, 1e300]) for body in COURT.surfaces}
    given |= {"restitution_speed": np.array([np.inf, 1e300])}
    states = np.tile(at((0.24, 0.02, 0.6), (0.1, 0, 0), (0, 9, 3)), (2, 1))
    shots = flown(states, given, backend=backend, max_contacts=8)
    assert shots.contacts.min() > 0
    # 1 + v/v0 is 1 with both.
    assert shots.state[0].tobytes() == shots.state[1].tobytes()


@pytest.mark.parametrize(
    ("place", "name"),
    [
        ((-0.39, 0.5, 0.3), "in the board's middle"),
        ((-0.5, 0.5, 0.3), "in its back"),
        ((-0.3, 0.3, 0.3), "in its front"),
        ((-0.387, 1.0, 0.3), "over its side"),
        ((-0.387, 0.0, 1.0), "on its top"),
        ((-0.31, 0.0, -0.05), "in the bridge"),
        ((-0.31, 0.0, -0.2), "in its underside"),
        ((-0.31, 0.17, -0.05), "in its side"),
        ((0.3, 0.0, -0.05), "in the ring"),
    ],
)
@pytest.mark.parametrize("backend", BACKENDS)
def test_a_ball_that_starts_in_a_body_is_invalid(place: Any, name: str, backend: Any) -> None:
    assert flown(at(place, (0, 0, 1)), backend=backend).outcome[0] == INVALID, name
    assert hoopgen.certify(at(place, (0, 0, 1)), scene=COURT).outcome[0] == INVALID, name


# -- From every side


@pytest.mark.parametrize("backend", BACKENDS)
def test_against_the_boards_back_the_ball_comes_back(backend: Any) -> None:
    p = PAPER_COURT
    back = -p["board_distance"] - p["board_thickness"]
    state = at((back - p["ball_radius"] - 0.3, 0.4, 0.3), (3, 0, 0.0))
    (hit, _) = flown(state, backend=backend, record=True).events
    assert hit["surface"] == BOARD
    assert hit["time"] == pytest.approx(0.1, rel=8 * EPS, abs=0.0)
    assert hit["after"][3] == pytest.approx(-p["backboard_restitution"] * 3, rel=8 * EPS, abs=0.0)


@pytest.mark.parametrize("backend", BACKENDS)
def test_straight_up_against_the_bridge_the_ball_is_thrown_down(backend: Any) -> None:
    p = PAPER_COURT
    low = p["wire_radius"] - p["bridge_depth"] - p["ball_radius"]
    start, up = -1.0, 5.0
    state = at((-0.25, 0.0, start), (0, 0, up))  # clear of the board's lower edge
    shots = flown(state, backend=backend, record=True)
    (hit,) = shots.events  # and then it falls for ever
    assert (hit["surface"], shots.outcome[0]) == (BRIDGE, SHORT)
    speed = math.sqrt(up**2 - 2 * p["gravity"] * (low - start))
    assert hit["before"][2] == pytest.approx(low, rel=8 * EPS, abs=0.0)
    expected = -p["bridge_restitution"] * speed
    assert hit["after"][5] == pytest.approx(expected, rel=64 * EPS, abs=0.0)
    assert not shots.uncertain[0]


@pytest.mark.parametrize("backend", BACKENDS)
def test_against_the_ring_from_below_the_ball_goes_the_mirror_s_way(backend: Any) -> None:
    """Without gravity to speak of and with e = 1, a drop and a rise are mirror images."""
    light = PAPER_COURT | {"gravity": 1e-9, "ring_restitution": 1.0}
    falls, rises = (at((0.28, 0.05, s * 0.6), (0, 0, -s * 3.0), (s * 4, s * 5, 6)) for s in (1, -1))
    above, below = (
        flown(s, light, backend=backend, record=True, max_contacts=1) for s in (falls, rises)
    )
    flip = np.array([1, 1, -1, 1, 1, -1, -1, -1, 1])
    assert above.events["surface"].tolist() == below.events["surface"].tolist() == [RING]
    wanted = flip * above.events["after"][0]
    # Gravity changes a speed by 2e-10 m/s on the way.
    np.testing.assert_allclose(below.events["after"][0], wanted, rtol=0, atol=1e-8)


@pytest.mark.parametrize("edge", ["side", "top", "corner"])
def test_the_first_touch_turns_smoothly_from_the_board_around_its_edges(edge: str) -> None:
    """Shots side by side touch ever more of an edge: the normal has no jump."""
    p = NBA_COURT | {"board_thickness": 0.03}
    beyond = np.linspace(-0.05, 0.999 * p["ball_radius"], 4001)
    side, top = (beyond * (edge in kinds) for kinds in (("side",), ("top",)))
    if edge == "corner":
        side = top = beyond / math.sqrt(2)
    else:
        side = side - 0.3 * (edge == "top")
        top = top - 0.3 * (edge == "side")
    states = np.zeros((len(beyond), 9))
    states[:, 0], states[:, 1], states[:, 2] = 1, p["board_half_width"] + side, p["board_top"] + top
    states[:, 3] = -50.0
    touched = flown(states, p | {"gravity": 1e-9}, record=True, max_contacts=1).events
    assert (touched["surface"] == BOARD).all()
    place = touched["before"][:, :3]
    low = np.array([-np.inf, -p["board_half_width"], p["board_bottom"]])
    high = np.array([-p["board_distance"], p["board_half_width"], p["board_top"]])
    apart = place - np.clip(place, low, high)
    # It touches, and is not inside.
    assert np.abs(np.linalg.norm(apart, axis=1) - p["ball_radius"]).max() < 16 * EPS
    normal = apart / p["ball_radius"]
    step = (beyond[1] - beyond[0]) / p["ball_radius"]
    turned = np.linalg.norm(np.diff(normal, axis=0), axis=1)
    # A quarter circle's height changes without bound at its end: sqrt(1 - s²).
    assert turned.max() < 2 * math.sqrt(2 * step)
    assert turned[: len(turned) // 2].max() < 2 * step


@pytest.mark.parametrize("preset", PRESETS)
def test_left_and_right_are_mirror_images_to_the_bit(preset: str) -> None:
    states = all_kinds(trials(300), seed=3)
    mirror = np.array([1.0, -1, 1, 1, -1, 1, -1, 1, -1])
    left, right = (
        flown(s, PRESETS[preset], record=True, max_contacts=30) for s in (states, states * mirror)
    )
    assert left.outcome.tobytes() == right.outcome.tobytes()
    assert np.array_equal(left.events["surface"], right.events["surface"])
    # Equal, not the same bytes: zeros have signs.
    assert np.array_equal(left.events["time"], right.events["time"])
    assert np.array_equal(left.events["after"] * mirror, right.events["after"])
    assert np.array_equal(left.uncertain, right.uncertain)


# -- Into no body


@pytest.mark.sampled(2)
@pytest.mark.parametrize("preset", PRESETS)
@pytest.mark.parametrize("kind", KINDS)
def test_no_flight_goes_into_a_body(kind: str, preset: str) -> None:
    """A ball enclosure bounds the deepest point of every flight."""
    p = PRESETS[preset]
    values = [float(p[name]) for name in COURT.parameters]
    states = thrown(kind, trials(12, at_least=12), seed=5)
    shots = flown(states, p, record=True, max_contacts=12)
    flights = 0
    for shot in np.flatnonzero(shots.outcome != INVALID):
        events = shots.events[shots.events["shot"] == shot]
        starts = [states[shot], *events["after"]]
        left = [-1, *events["surface"].tolist()]
        lasts = [*np.diff(events["time"], prepend=0.0), 3.0]
        last = len(events) if shots.outcome[shot] == SHORT else len(events) - 1
        for start, own, lasting in list(zip(starts, left, lasts, strict=True))[: last + 1]:
            if own == len(COURT.surfaces):
                continue  # ended
            if shots.outcome[shot] == Outcome.CAPPED and start is starts[-1]:
                continue
            deep = deepest(start.tolist(), float(lasting), values, own, DERIVED)
            flights += 1
            assert max(deep) < 1e-13, (shot, own)
    assert flights > 8


# -- What is made


def sampled(shots: hoopgen.Shots, shot: int, radius: float, steps: int = 4000) -> bool | None:
    """Return True if a shot fell through the disc, from its path in small steps; None if close."""
    path = shots.trajectory(shot)
    there = path.at(np.linspace(0, path.duration, steps))
    above, inside = there[:, 2] >= 0, np.hypot(there[:, 0], there[:, 1]) < radius
    near = np.abs(there[:, 2])[np.flatnonzero(np.diff(np.sign(np.diff(there[:, 2])))) + 1]
    if (near < 1e-3).any():
        return None  # a turn close to the plane, that steps may miss
    through = 0
    for k in np.flatnonzero(np.diff(above.astype(int))):
        if inside[k] and not above[k]:
            through = 0 if through == 1 else -1
        elif inside[k] and through == 0:
            through = 1
    return through == 1


def test_made_is_what_fell_through_the_ring_as_small_steps_show() -> None:
    kinds = ("from below", "up through the ring", "from above", "under the bridge")
    states = np.concatenate([thrown(kind, 150, seed=9) for kind in kinds])
    shots = flown(states, record=True, max_contacts=20)
    seen = []
    for shot in np.flatnonzero((shots.outcome == MADE) | (shots.outcome == MISSED)):
        fell = sampled(shots, shot, PAPER_COURT["ring_radius"])
        if fell is None:
            continue
        ended = shots.state[shot]
        inside = np.hypot(ended[0], ended[1]) <= PAPER_COURT["ring_radius"]
        assert (shots.outcome[shot] == MADE) == (fell and inside), shot
        seen.append((fell, bool(inside)))
    # Some of each, and one that ended inside without having fallen through.
    assert {(True, True), (False, False), (False, True)} <= set(seen)


ROUND = [
    ("dropped in", at((0, 0, 0.5)), MADE),
    ("dropped from the ring's plane", at((0, 0, 0)), MADE),
    ("dropped beside", at((0.6, 0, 0.5)), MISSED),
    ("up through the ring and down again", at((0, 0, -0.5), (0, 0, 5)), MISSED),
    ("up through the ring and out", at((0, 0, -0.5), (0.9, 0, 6)), MISSED),
    ("up beside it and down through it", at((0.6, 0, -0.5), (-0.62, 0, 6)), MADE),
    ("released below the disc, inside", at((0, 0, -0.02)), MISSED),
    ("up to below the disc, inside", at((0, 0, -0.5), (0, 0, 3.1)), MISSED),
    ("below the end plane, falling", at((0, 0, -0.5)), SHORT),
    ("below the end plane, not rising enough", at((0.6, 0, -0.5), (0, 0, 1)), SHORT),
]


@pytest.mark.parametrize(("what", "state", "outcome"), ROUND, ids=[what for what, *_ in ROUND])
@pytest.mark.parametrize("backend", BACKENDS)
def test_how_shots_around_the_disc_end(
    what: str, state: Floats, outcome: int, backend: Any
) -> None:
    shots = flown(state, backend=backend)
    assert Outcome(shots.outcome[0]) == outcome
    assert not shots.uncertain[0]
    assert hoopgen.certify(state, scene=COURT).outcome[0] == outcome


@pytest.mark.parametrize("backend", BACKENDS)
def test_with_a_deep_end_plane_a_ball_from_beside_is_not_made(backend: Any) -> None:
    """The ball passes below the wire and crosses the end plane inside: the hoop's MADE."""
    deep, state = {"end_depth": 0.7}, at((0.5, 0, 0.28), (-1.3, 0, -3.3))
    assert hoopgen.simulate(state, deep).outcome[0] == MADE
    shots = flown(state, deep, backend=backend)
    assert (shots.outcome[0], shots.contacts[0]) == (MISSED, 0)


@pytest.mark.parametrize("backend", BACKENDS)
def test_a_shot_that_goes_on_from_a_record_ends_as_it_did(backend: Any) -> None:
    """Even from below the disc: inside it is taken to have come from above."""
    states = thrown("from above", 400, seed=2)
    states[:200, :3] = 0.2 * np.abs(states[:200, :3]) * (0, 0, 1)  # at the wire from inside
    states[:200, 3:5] *= 2
    shots = flown(states, backend=backend, record=True, max_contacts=30)
    rows = shots.events[shots.events["surface"] < len(COURT.surfaces)]
    rows = rows[~shots.uncertain[rows["shot"]] & (shots.outcome[rows["shot"]] <= MISSED)]
    low = rows["after"][:, 2] < 0
    assert low.sum() > 5
    again = flown(rows["after"], leaving=rows["surface"], backend=backend, max_contacts=30)
    # Errors begin anew, so that a flag may be gone; the path is the same.
    assert np.array_equal(again.outcome, shots.outcome[rows["shot"]])


@pytest.mark.parametrize("backend", BACKENDS)
def test_a_passing_that_rounding_could_turn_is_undecided(backend: Any) -> None:
    """A ball whose apex is in the disc's plane exactly; the judge does not decide it either."""
    # v²/2g = 1/2 exactly, with g = 16 and v = 4.
    state, light = at((0, 0, -0.5), (0, 0, 4)), {"gravity": 16.0}
    shots = flown(state, light, backend=backend)
    assert shots.uncertain[0]
    proof = hoopgen.certify(state, light, scene=COURT, max_bits=256)
    assert not proof.decided[0] or proof.outcome[0] == shots.outcome[0]
    assert not flown(state * 1.001, light, backend=backend).uncertain[0]


# -- The engines and the judge


@pytest.mark.sampled(15)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("preset", PRESETS)
def test_both_engines_give_the_same_bits(kind: str, preset: str) -> None:
    states = thrown(kind, trials(400), seed=1)
    options: dict[str, Any] = {"record": True, "max_contacts": 30, "fields": every_field()}
    c, numpy = (flown(states, PRESETS[preset], backend=b, **options) for b in BACKENDS)
    for name in every_field():
        assert getattr(c, name).tobytes() == getattr(numpy, name).tobytes(), name
    assert c.events.tobytes() == numpy.events.tobytes()


def every_field() -> tuple[str, ...]:
    return (*COURT.layout.fields, *COURT.layout.bounds)


@pytest.mark.sampled(8)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("preset", ["paper", "nba"])
def test_what_is_not_marked_is_as_the_judge_proves_it(kind: str, preset: str) -> None:
    states = thrown(kind, trials(60), seed=4)
    shots = flown(states, PRESETS[preset], record=True, max_contacts=30)
    proof = hoopgen.certify(states, PRESETS[preset], scene=COURT, max_contacts=30)
    assert proof.agrees(shots).all()
    assert np.sum(~proof.decided) < exceptions(0.02, len(states))
    assert np.sum(shots.uncertain) < exceptions(0.05, len(states))
    known = proof.decided & ~shots.uncertain & (shots.outcome != INVALID)
    np.testing.assert_allclose(
        shots.state[known], proof.state[known], rtol=0, atol=1e-6
    )  # errors grow from contact to contact


def of_each(count: int, seed: int) -> dict[str, Floats]:
    """Return sizes and laws for shots, each its own; with infinities, zeros and thin plates."""
    rng = np.random.Generator(np.random.PCG64(seed))
    own = {name: np.full(count, float(value)) for name, value in PAPER_COURT.items()}
    among: dict[str, list[float]] = {
        **{f"{body}_restitution": [0.3, 0.7, 0.9, 1.0] for body in COURT.surfaces},
        **{f"{body}_friction": [0.0, 1e-9, 0.3, 0.8, 1e6, math.inf] for body in COURT.surfaces},
        "inertia": [1 / 64, 2 / 5, 2 / 3, 1.0],
        "tangential_restitution": [-1.0, -0.3, 0.0, 0.15, 1.0],
        "restitution_speed": [1.0, 40.0, math.inf],
        "ball_radius": [0.05, 0.12128, 0.2],
        "board_thickness": [1e-4, 0.0127, 1.0],
        "board_bottom": [-0.6, -0.14, 0.1],
        "bridge_half_width": [1e-3, 0.0762, 0.9],
        "bridge_depth": [1e-3, 0.12, 0.5],
        "end_depth": [1e-3, 0.024, 0.3],
        "gravity": [1.6, 9.81, 30.0],
    }
    return own | {name: rng.choice(values, count) for name, values in among.items()}


def test_with_sizes_and_laws_of_each_shot_engines_and_judge_agree() -> None:
    states = all_kinds(trials(25), seed=7)
    own = of_each(len(states), seed=8)
    options: dict[str, Any] = {"record": True, "max_contacts": 10, "fields": every_field()}
    c, numpy = (flown(states, own, backend=b, **options) for b in BACKENDS)
    for name in every_field():
        assert getattr(c, name).tobytes() == getattr(numpy, name).tobytes(), name
    assert c.events.tobytes() == numpy.events.tobytes()
    proof = hoopgen.certify(states, own, scene=COURT, max_contacts=10)
    assert proof.agrees(c).all()
    known = proof.decided & ~c.uncertain & (c.outcome != INVALID)
    assert np.sum(~known) < exceptions(0.4, len(states))
    apart = np.abs(c.state - proof.state).reshape(-1, 3, 3).max(axis=2)
    assert (apart <= c.state_error)[known].all()


def test_the_impact_is_that_of_its_check_values() -> None:
    """The check values come from momentum, angular momentum and Coulomb's law, in more digits."""
    given = dict(
        zip(("nx", "ny", "nz", "vx", "vy", "vz"), (1.0, 0, 0, -4.5, 0.3, -4.0), strict=True)
    )
    given |= {"wx": 0.0, "wy": 18.849555921538759, "wz": 0.0, "p_ball_radius": 0.1213}
    given |= {f"p_{body}_restitution": 0.7 for body in COURT.surfaces}
    given |= {f"p_{body}_friction": 0.05 for body in COURT.surfaces}
    given |= {"p_inertia": 2 / 3, "p_tangential_restitution": 0.0, "p_restitution_speed": math.inf}
    expected = (3.15, 0.234037013058917417, -3.62323066160605562)
    expected += (0.0, 23.5086986057177919, 0.815700580475052554)
    # The laws of all bodies are of one kind, and have one kernel.
    named = kernels.ARGUMENTS["ring_impact"]
    found = [float(value) for value in kernels.ring_impact(*(given[name] for name in named))]
    assert found == pytest.approx(expected, rel=16 * EPS, abs=16 * EPS)


# -- Beside the hoop


def test_shots_that_touch_what_both_have_go_the_same_way() -> None:
    """The front of the board and the ring: with the article's law both scenes agree."""
    states = np.concatenate(
        [thrown("from above", 3000, seed=6), thrown("from below", 1000, seed=6)]
    )
    known = {result.name for result in hoopgen.HOOP.kernels.RESULTS}
    both_have = [field for field in every_field() if field in known]
    options: dict[str, Any] = {"max_contacts": 12, "record": True, "fields": both_have}
    hoop = hoopgen.simulate(states, **options)
    whole = flown(states, **options)
    same = ~hoop.uncertain & ~whole.uncertain
    p, events = PAPER_COURT, whole.events
    place = events["before"][:, :3]
    front = (np.abs(place[:, 1]) < p["board_half_width"]) & (place[:, 0] > -p["board_distance"])
    front &= (place[:, 2] > p["board_bottom"]) & (place[:, 2] < p["board_top"])
    top = (place[:, 0] < -p["ring_radius"]) & (place[:, 2] > p["wire_radius"])
    top &= np.abs(place[:, 1]) < p["bridge_half_width"]
    both = np.select(
        [events["surface"] == BOARD, events["surface"] == BRIDGE], [front, top], default=True
    )
    same[events["shot"][~both]] = False
    # The hoop's bridge goes on to the wire's circle beside the middle, the court's does not.
    there = hoop.events["before"][:, 0] > -p["ring_radius"]
    same[hoop.events["shot"][(hoop.events["surface"] == BRIDGE) & there]] = False
    same &= (hoop.outcome != INVALID) & (whole.outcome != INVALID)
    rose = same & (hoop.outcome == MADE) & (whole.outcome == MISSED)
    assert rose.sum() > 0
    assert (states[rose, 2] < 0).all()  # they came up through the ring
    same &= ~rose
    assert same.mean() > 0.7
    assert np.array_equal(hoop.outcome[same], whole.outcome[same])
    assert np.array_equal(hoop.counts[same], whole.counts[same])
    apart = np.abs(hoop.state - whole.state).reshape(-1, 3, 3).max(axis=2)
    assert (apart <= hoop.state_error + whole.state_error)[same].all()


# -- Seen


def test_what_is_drawn_is_as_large_as_what_is_flown_against() -> None:
    seen = SceneGeometry.from_engine(COURT, FIBA_COURT)
    ring, *boxes = seen.bodies(seen.room(np.full(3, -1.0), np.full(3, 1.0)))
    symbols = {p.symbol: FIBA_COURT[p.name] for p in DERIVED.parameters}
    for shown, body in zip(boxes, DERIVED.bodies[BOARD:], strict=True):
        corners = shown.mesh.corners[..., :3].reshape(-1, 3)
        (box,) = body.faces
        for corner, found in ((box.low, corners.min(axis=0)), (box.high, corners.max(axis=0))):
            wanted = [float(release(c).xreplace(symbols)) for c in corner]
            np.testing.assert_allclose(found, wanted, rtol=0, atol=4 * EPS)
    # Its mesh has corners on the wire.
    widest = FIBA_COURT["ring_radius"] + FIBA_COURT["wire_radius"]
    assert np.abs(ring.mesh.corners[..., :2]).max() == pytest.approx(widest, rel=4 * EPS, abs=0.0)


@pytest.mark.slow
def test_shots_have_pictures_and_pages(tmp_path: Any) -> None:
    pytest.importorskip("matplotlib")
    states = hoopgen.release(np.linspace(7.0, 7.4, 5), 0.89, height=2.13, distance=4.19)
    shots = flown(states, NBA_COURT, record=True)
    assert shots.plot().figure.axes
    assert shots.trajectory(0).plot().figure.axes
    page = tmp_path / "court.html"
    hoopgen.view(shots, path=page)
    assert page.stat().st_size > 10_000
