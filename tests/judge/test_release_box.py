"""Proofs of boxes of releases, against simulated releases in them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import trials

pytest.importorskip("flint")
pytest.importorskip("sympy")

from flint import arb

from hoopgen.judge.clear_flight import clear_until, misses_body
from hoopgen.judge.formulas import formulas
from hoopgen.judge.pieces import next_piece
from hoopgen.judge.proof import UNDECIDED

THROW = {
    "speed": 7.17,
    "elevation": float(np.radians(52)),
    "backspin": 18.85,
    "height": 2.1336,
    "distance": 4.191,
}


def inputs(engine: Engine) -> list[arb]:
    """Return the kernels' inputs for a scene's own parameters."""
    return [arb(float(np.ravel(v)[0])) for v in engine.table.inputs(dict(engine.parameters))]


def in_box(
    middle: Mapping[str, float], low: Any, high: Any, names: Any, count: int, seed: int = 3
) -> dict[str, Any]:
    """Return random releases of a box, its corners among them."""
    random = np.random.default_rng(seed)
    share = random.uniform(size=(count, len(names)))
    share[: 2 ** len(names)] = np.round(share[: 2 ** len(names)])
    values = np.asarray(low) + share * (np.asarray(high) - np.asarray(low))
    return dict(middle) | dict(zip(names, values.T, strict=True))


def sequences(engine: Engine, values: Mapping[str, Any]) -> list[tuple[int, ...]]:
    """Return the outcome and the bodies that each shot meets."""
    shots = engine.simulate(hoopgen.release(**values), record=True)
    assert not shots.uncertain.any()
    ends = np.searchsorted(shots.events["shot"], np.arange(1, len(shots)))
    met = np.split(shots.events["surface"], ends)
    return [(int(o), *own.tolist()) for o, own in zip(shots.outcome, met, strict=True)]


@pytest.mark.sampled(6)
@pytest.mark.parametrize(
    ("engine", "changes", "widths"),
    [
        pytest.param(hoopgen.HOOP, {}, {"speed": 1e-3, "elevation": 1e-3}, id="clean"),
        pytest.param(
            hoopgen.HOOP,
            {},
            {"speed": 5e-3, "elevation": 2e-3, "azimuth": 2e-3, "height": 1e-3},
            id="clean-wide",
        ),
        pytest.param(hoopgen.COURT, {}, {"speed": 1e-3, "elevation": 1e-3}, id="court"),
        pytest.param(hoopgen.HOOP, {"speed": 7.3}, {"speed": 1e-7, "elevation": 1e-7}, id="board"),
        pytest.param(hoopgen.HOOP, {"speed": 7.0}, {"speed": 1e-7, "azimuth": 1e-7}, id="ring"),
        pytest.param(
            hoopgen.HOOP, {"speed": 7.0}, {"speed": 5e-3, "elevation": 1e-3}, id="ring-wide"
        ),
        pytest.param(
            hoopgen.COURT, {"speed": 7.0}, {"speed": 1e-3, "elevation": 2e-4}, id="court-ring-wide"
        ),
        pytest.param(
            hoopgen.COURT,
            {"speed": 7.0964, "elevation": 0.8873, "azimuth": -0.0084, "backspin": 0.0},
            {"speed": 2e-3, "elevation": 2e-4, "azimuth": 1e-4},
            id="court-ring-and-board",
        ),
        pytest.param(
            hoopgen.COURT,
            {"speed": 7.25},
            {"speed": 2e-3, "elevation": 2e-4, "azimuth": 2e-4},
            id="court-through-the-ring",
        ),
    ],
)
def test_all_releases_of_a_proved_box_end_alike(
    engine: Engine, changes: dict[str, float], widths: dict[str, float]
) -> None:
    middle = THROW | changes
    proof = hoopgen.certify_box(middle, widths, scene=engine)
    assert proof.proved, proof
    assert proof.share == 1.0
    assert proof.counterexample is None
    low = [dict(middle, azimuth=0.0)[name] - width for name, width in widths.items()]
    high = [dict(middle, azimuth=0.0)[name] + width for name, width in widths.items()]
    found = set(sequences(engine, in_box(middle, low, high, widths, trials(2_000))))
    assert len(found) == 1
    outcome, *met = found.pop()
    assert engine.outcomes(outcome).name.lower() == proof.outcome
    assert tuple(engine.surfaces[k] for k in met[:-1]) == proof.sequence
    assert "Proved: every release" in str(proof)


@pytest.mark.slow
def test_a_box_with_a_release_that_ends_otherwise_is_never_proved() -> None:
    random = np.random.default_rng(9)
    for _ in range(trials(40)):
        low = random.uniform(7.0, 7.3)
        throw = THROW | {"elevation": random.uniform(0.85, 0.95)}
        ends = (low, low + 0.02)
        one, other = (sequences(hoopgen.HOOP, throw | {"speed": v})[0] for v in ends)
        if one == other:
            continue
        while ends[1] - ends[0] > 1e-6:
            middle = sum(ends) / 2
            same = sequences(hoopgen.HOOP, throw | {"speed": middle})[0] == one
            ends = (middle, ends[1]) if same else (ends[0], middle)
        throw["speed"] = ends[0] - 1e-4
        proof = hoopgen.certify_box(throw, {"speed": 2e-4}, max_parts=60)
        assert not proof.proved
        assert proof.share < 1.0
        assert "Not proved" in str(proof)


def test_no_part_is_narrower_than_doubles_at_the_ends_of_its_box() -> None:
    """A ball that is dropped on the axis of the ring stays undecided."""
    proof = hoopgen.certify_box({"x": 0, "z": 1}, {"x": 0.01})
    assert len(proof.outcomes) < 200
    assert (proof.high - proof.low).min() >= np.spacing(0.01) / 2
    assert "a place where the distance from the ring has no slope, such as its axis" in (
        proof.question
    )
    assert 1 - 1e-15 < proof.share < 1


def test_parameters_of_a_box_are_one_number_each() -> None:
    said = r"^parameters\['restitution'\]: expected one number for all shots, got \[0.7, 0.6\]"
    with pytest.raises(ValueError, match=said):
        hoopgen.certify_box(THROW, {}, {"restitution": [0.7, 0.6]})  # type: ignore[dict-item]


def test_a_counterexample_is_in_the_box_and_ends_otherwise() -> None:
    widths = {"speed": 0.1, "elevation": 0.02}
    proof = hoopgen.certify_box(THROW, widths)
    assert not proof.proved
    assert proof.counterexample is not None
    for name, width in widths.items():
        assert abs(proof.counterexample[name] - THROW[name]) <= width
    one, other = (sequences(hoopgen.HOOP, v)[0] for v in (THROW, proof.counterexample))
    assert one != other
    assert "Proved to end otherwise: speed" in str(proof)


@pytest.mark.slow
@pytest.mark.parametrize("size", [0.2, pytest.param(1.0, marks=pytest.mark.slow)])
def test_the_parts_of_a_survey_are_the_box_and_end_as_is_proved(size: float) -> None:
    widths = {"speed": 0.05 * size, "elevation": 0.03 * size}
    proof = hoopgen.certify_box(THROW, widths, max_parts=400, survey=True)
    whole = 4 * np.prod(list(widths.values()))
    np.testing.assert_allclose(np.prod(proof.high - proof.low, axis=1).sum(), whole, rtol=1e-9)
    decided = np.flatnonzero(proof.outcomes != UNDECIDED)
    assert len(decided) > 4
    assert len({int(proof.outcomes[k]) for k in decided}) >= 1
    for k in decided[:: max(1, len(decided) // 40)]:
        values = in_box(THROW, proof.low[k], proof.high[k], proof.variables, 50, int(k))
        found = set(sequences(hoopgen.HOOP, values))
        assert len(found) == 1
        assert found.pop()[0] == proof.outcomes[k]


def test_a_box_of_states_is_proved_too() -> None:
    names = ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")
    state = dict(zip(names, hoopgen.release(**THROW).tolist(), strict=True))
    proof = hoopgen.certify_box(state, {"vx": 1e-3, "vz": 1e-3})
    assert proof.proved
    assert proof.variables == ("vx", "vz")


def test_a_single_release_is_a_box_without_width() -> None:
    proof = hoopgen.certify_box(THROW, {})
    assert proof.proved
    assert len(proof.outcomes) == 1


@pytest.mark.slow
def test_a_ball_that_starts_in_a_body_or_rolls_is_not_proved_to_be_anything_else() -> None:
    inside = hoopgen.certify_box({"x": 0.235, "z": 0.0}, {"vx": 0.1})
    assert inside.proved
    assert inside.outcome == "invalid"
    resting = hoopgen.certify_box(
        {"x": -0.25, "z": 0.4},
        {"vx": 1e-9},
        {f"{name}_restitution": 0.2 for name in hoopgen.SURFACES},
        scene=hoopgen.COURT,
        max_parts=20,
    )
    assert not resting.proved
    assert resting.outcome == ""


@pytest.mark.parametrize("engine", [hoopgen.HOOP, hoopgen.COURT], ids=["hoop", "court"])
def test_a_flight_is_clear_until_shortly_before_its_first_event_alone(engine: Engine) -> None:
    random = np.random.default_rng(4)
    own, values = formulas(engine.scene), inputs(engine)
    for speed in random.uniform(6.5, 7.6, trials(50)):
        state = hoopgen.release(**THROW | {"speed": speed})
        shots = engine.simulate(state, record=True)
        first = float(shots.events["time"][0])
        piece = next_piece(own, [arb(c) for c in state.tolist()], values)
        for begin, end in ((0.0, first), (0.0, math.inf), (first / 2, 2 * first)):
            reached = clear_until(own, piece, values, begin, end)
            assert 0.9 * first < reached <= first
        assert clear_until(own, piece, values, 0.0, first / 3) == first / 3


@pytest.mark.slow
def test_a_flight_after_a_contact_misses_each_body_but_the_next() -> None:
    random = np.random.default_rng(5)
    own, values = formulas(hoopgen.COURT.scene), inputs(hoopgen.COURT)
    missed = passed = met = 0
    for speed in random.uniform(6.9, 7.4, trials(100)):
        state = hoopgen.release(**THROW | {"speed": speed})
        events = hoopgen.COURT.simulate(state, record=True, max_contacts=4).events
        for now, then in pairwise(events):
            piece = next_piece(own, [arb(c) for c in now["after"].tolist()], values)
            flight = float(then["time"] - now["time"])
            for k in range(own.faces):
                body = own.surfaces[k].body
                misses = misses_body(own, k, piece, values, flight / 8, 1.001 * flight)
                if body == then["surface"]:
                    assert not misses
                    met += 1
                elif body != now["surface"]:
                    missed += misses
                    passed += 1
    assert met > 10
    assert missed > passed / 2


@pytest.mark.parametrize(
    ("release", "widths", "error", "text"),
    [
        ({"speed": 7.0}, {}, ValueError, "release: elevation, height, distance missing"),
        (THROW | {"speeed": 1.0}, {}, ValueError, "release: .*speeed"),
        (THROW, {"vx": 0.1}, ValueError, "half_widths: .*vx"),
        (THROW, {"speed": -0.1}, ValueError, r"half_widths\['speed'\]: expected 0 or more"),
        (THROW, {"speed": 8.0}, ValueError, r"half_widths\['speed'\]: the speed would be negative"),
        (THROW, {"speed": np.nan}, ValueError, r"half_widths\['speed'\]: expected a finite number"),
        (THROW | {"speed": "7"}, {}, TypeError, r"release\['speed'\]: expected a number, got '7'"),
        ([7.0], {}, TypeError, "release: expected a mapping"),
        (THROW, 0.1, TypeError, "half_widths: expected a mapping"),
        (THROW | {"elevation": 52.0}, {}, ValueError, "release: elevation is in radians"),
        (THROW, {"elevation": 10.0}, ValueError, "half_widths: elevation is in radians"),
        (THROW, {"elevation": "10"}, TypeError, r"half_widths\['elevation'\]: expected a number"),
        (THROW | {"sped": 7.0}, {}, ValueError, "release: unknown sped; is speed meant?"),
    ],
)
def test_bad_boxes_are_refused(
    release: Any, widths: Any, error: type[Exception], text: str
) -> None:
    with pytest.raises(error, match=text):
        hoopgen.certify_box(release, widths)


def test_a_survey_is_true_or_false() -> None:
    with pytest.raises(TypeError, match=r"^survey: expected True or False, got 'yes'$"):
        hoopgen.certify_box(THROW, {}, survey="yes")  # type: ignore[arg-type]
