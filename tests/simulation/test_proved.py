"""`Shots.proved`: whose flags and bounds are a theorem, and what that presupposes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.scenes.court import COURT as derived_court
from hoopgen.derive.scenes.hoop import HOOP as DERIVED
from hoopgen.derive.scenes.premises import premises
from hoopgen.derive.scenes.scene import Scene

import hoopgen
from benchmarks.families import FAMILIES
from hoopgen import COURT, NBA, PAPER, Event, Outcome
from hoopgen.core.variables import STATE
from hoopgen.scene.files import load_scene

FREE_THROW = [4.2, 0.0, -0.9, -4.4, 0.0, 5.6, 0.0, 18.0, 0.0]


def proved(states: Any, parameters: Any = None, **options: Any) -> list[bool]:
    found: list[bool] = hoopgen.simulate(states, parameters, **options).proved.tolist()
    return found


def test_shots_of_the_hoop_are_and_those_of_other_scenes_are_not() -> None:
    shares = {family.key: float(np.mean(proved(*family.make(200)))) for family in FAMILIES}
    assert {shares[key] for key in ("W1", "W2", "W3", "W4")} == {1.0}
    assert min(shares.values()) > 0.4  # some are released below the ring and close to it
    assert proved(FREE_THROW, NBA) == [True]
    assert proved(FREE_THROW, fields=("contacts",)) == [True]
    with pytest.raises(AttributeError, match=r"^contacts: not among the fields asked for: outcome"):
        proved(FREE_THROW, fields=("outcome",))
    assert proved(FREE_THROW, scene=COURT) == [True]
    assert proved(FREE_THROW, scene=COURT, time_limit=1.0) == [True]
    assert proved(FREE_THROW, scene=COURT, fields=("contacts", "estimated")) == [True]
    with pytest.raises(AttributeError, match=r"^estimated: not among the fields asked for"):
        proved(FREE_THROW, scene=COURT, fields=("contacts",))
    in_air = hoopgen.NBA_COURT_AIR
    assert proved(FREE_THROW, in_air, scene=hoopgen.COURT_AIR) == [False]
    golf = load_scene(Path(__file__).parents[2] / "examples" / "scenes" / "golf.toml")
    assert proved([0.0, 0.0, 1.0, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0], scene=golf) == [False]


def test_a_ball_that_starts_on_a_body_is_not() -> None:
    log = hoopgen.simulate(FREE_THROW, record=True).events
    impact = log[log["kind"] == Event.IMPACT][0]
    states = [FREE_THROW, impact["after"]]
    assert proved(states, leaving=[-1, int(impact["surface"])]) == [True, False]


def test_what_the_judge_has_settled_is() -> None:
    pytest.importorskip("flint")
    (edges,) = (family for family in FAMILIES if family.key == "edges")
    wide = {**PAPER, "ring_radius": 2.2}  # the theorem says nothing of so wide a ring
    states = np.concatenate([edges.make(40)[0], [FREE_THROW] * 3])
    before = hoopgen.simulate(states, wide)
    after = hoopgen.simulate(states, wide, settle=True)
    settled = before.uncertain & ~after.uncertain
    assert not before.proved.any()
    assert np.array_equal(after.proved, settled)
    # Of COURT, too.
    again = {"scene": COURT, "max_contacts": 40}
    before = hoopgen.simulate(edges.make(60)[0], **again)
    after = hoopgen.simulate(edges.make(60)[0], **again, settle=True)
    settled = before.uncertain & ~after.uncertain
    assert np.array_equal(after.proved, before.proved | settled)
    assert np.count_nonzero(after.proved & ~before.proved) > 0


@pytest.mark.parametrize(
    ("change", "ratio", "holds"),
    [
        ({"ring_radius": 1.501 * 0.13128}, 1.0, True),
        ({"ring_radius": 1.499 * 0.13128}, 1.0, False),
        ({"ring_radius": 15.99 * 0.13128}, 1.0, True),
        ({"ring_radius": 16.01 * 0.13128}, 1.0, False),
        ({"gravity": 1.0}, 1.0, True),
        ({"gravity": 1e-3}, 1.0, False),
        ({"board_distance": 300.0}, 1.0, True),
        ({"board_distance": 400.0}, 1.0, False),
        ({}, 5.0, True),
        ({}, 12.0, False),
    ],
)
def test_sizes_count(change: dict[str, float], ratio: float, holds: bool) -> None:
    state = np.array(FREE_THROW)
    state[3:6] *= ratio
    if "board_distance" in change:
        state[2], state[3:] = 0.5, 0.0
    assert proved(state, {**PAPER, **change}) == [holds]


LAYUP = [0.55, 0.0, -0.9, -0.8, 0.0, 5.6, 0.0, 0.0, 0.0]


@pytest.mark.parametrize(
    ("changes", "holds"),
    [
        ({}, True),
        ({"z": 0.5, "vz": -1.0}, True),  # from above
        ({"z": 0.5, "x": 0.3, "vz": -1.0}, True),
        ({"x": 0.5}, False),  # below the ring when it comes up
        ({"vx": 0.8, "x": 0.2}, False),  # away from below the ring
        ({"vx": 0.8}, False),
        ({"vz": 4.1}, False),  # never comes up
        ({"vz": -1.0}, False),
        ({"x": -0.5, "vx": 0.5}, True),  # behind the board
        ({"x": -0.4, "y": 1.5, "vx": 3.0, "vy": -3.0}, False),  # through the plane of the board
    ],
)
def test_a_ball_from_below_comes_up_and_meets_nothing_before(
    changes: dict[str, float], holds: bool
) -> None:
    state = dict(zip(STATE, LAYUP, strict=True)) | changes
    assert proved(list(state.values())) == [holds]


def test_all_flights_of_proved_shots_come_down_to_the_end() -> None:
    """The first one from below rises to the end's plane, and all contacts are above it."""
    known = 0
    for family in FAMILIES:
        states, parameters = family.make(400)
        shots = hoopgen.simulate(states, parameters, record=True)
        log, holds = shots.events, shots.proved
        depth = np.broadcast_to(shots.parameters["end_depth"], len(shots))
        impacts = log[log["kind"] == Event.IMPACT]
        low = impacts["after"][:, 2] < -depth[impacts["shot"]] - 1e-9
        assert not np.any(low & holds[impacts["shot"]]), family.key
        assert not np.any(holds & (shots.outcome == Outcome.SHORT)), family.key
        known += np.count_nonzero(low) + np.count_nonzero(shots.outcome == Outcome.SHORT)
    assert known > 100


def test_rows_that_are_invalid_are_not() -> None:
    assert proved([FREE_THROW, [np.nan] * 9, [1e300] * 9]) == [True, False, False]


def test_flights_are_as_large_as_the_lemma_says_at_most() -> None:
    """From recorded shots: sizes, with the release's energy, and with all contacts."""
    worst = 0.0
    for family in FAMILIES:
        states, parameters = family.make(150)
        shots = hoopgen.simulate(states, parameters, record=True)
        log = shots.events
        value = {
            name: np.broadcast_to(v, len(shots))[log["shot"]]
            for name, v in shots.parameters.items()
        }
        lengths = sum(abs(value[name]) for name in PAPER if name not in ("gravity", "restitution"))
        around = abs(states[:, :3]).sum(axis=1)[log["shot"]] + lengths + abs(value["end_depth"])
        spun = (states[:, 6:] ** 2).sum(axis=1)[log["shot"]] * value["ball_radius"] ** 2 * 2 / 3
        moved = (states[:, 3:6] ** 2).sum(axis=1)[log["shot"]]
        height = (moved + spun) / value["gravity"] + 2 * around
        bound = around + (2 * shots.contacts[log["shot"]] + 12) * height
        first = np.searchsorted(log["shot"], log["shot"])
        earlier = np.where(
            np.arange(len(log)) == first, 0.0, log["time"][np.maximum(np.arange(len(log)) - 1, 0)]
        )
        t, g = log["time"] - earlier, value["gravity"]
        for speed in (log["before"][:, 3:6], log["before"][:, 3:6] + [0, 0, 1] * (g * t)[:, None]):
            sizes = abs(speed).sum(axis=1)
            assert np.all((speed**2).sum(axis=1) <= (1 + 1e-12) * g * height), family.key
            places = abs(log["before"][:, :3]).sum(axis=1)
            worst = max(worst, float(np.max((places + t * (sizes + g * t)) / bound)))
    assert 0.05 < worst < 1


HOLE = """
name = "hole"
ball_radius = 0.02135
gravity = 9.81
restitution = 0.5

[parameters]
radius = { default = 0.054, summary = "radius of the hole" }

[bodies.green]
kind = "plane"
within = ["radius**2 - x**2 - y**2"]

[bodies.edge]
kind = "torus"
radius = "radius"

[ends.holed]
at = -0.05
"""


def test_a_scene_of_ones_own_may_have_the_premises(tmp_path: Path) -> None:
    file = tmp_path / "hole.toml"
    file.write_text(HOLE, encoding="utf-8")
    engine = hoopgen.compile(load_scene(file))
    state = [-0.3, 0.0, 0.1, 0.7, 0.0, 0.0, 0.0, 0.0, 0.0]
    radii = [0.054, 0.03, 0.4]
    assert [
        engine.simulate(state, {"radius": r}, max_contacts=40).proved.tolist() for r in radii
    ] == [
        [True],
        [False],
        [False],
    ]


def test_a_scene_without_a_floor_has_none() -> None:
    """There is no bound on how far a ball falls."""
    assert premises(DERIVED) is not None
    assert premises(derived_court) is not None
    (made, missed) = DERIVED.ends
    wall = replace(missed.plane, direction=(1, 0, 0), limits=())
    ends = (replace(missed, plane=wall),)
    assert premises(replace(DERIVED, ends=ends)) is None
    assert premises(replace(DERIVED, ends=(replace(missed, plane=made.plane),))) is None
    ends = (replace(missed, plane=wall),)
    assert premises(replace(derived_court, ends=ends)) is None


def with_ends(scene: Scene, *directions: tuple[int, int, int]) -> Scene:
    """Return the scene with other planes as ends."""
    end = scene.ends[-1]
    planes = (
        replace(end.plane, name=f"end_{k}", direction=way) for k, way in enumerate(directions)
    )
    ends = tuple(replace(end, name=plane.name, plane=plane) for plane in planes)
    return replace(scene, ends=ends, passage=None)


def test_scenes_of_which_a_decision_has_no_lemma_prove_nothing() -> None:
    """The lemmas of arrivals say nothing of planes that gravity pulls off."""
    down, wall, ceiling = (0, 0, 1), (1, 0, 0), (0, 0, -1)
    assert with_ends(derived_court, down).proves_bounces
    assert with_ends(derived_court, down, wall).proves_bounces
    assert not with_ends(derived_court, down, ceiling).proves_bounces
    assert with_ends(DERIVED, down, wall).proves_errors
    assert not with_ends(DERIVED, down, ceiling).proves_errors
    assert not derived_court.proves_errors
    assert not DERIVED.proves_bounces


def test_flights_among_boxes_are_no_larger_than_their_lemmas_say() -> None:
    """They are at most 2^40 balls long, however thick the wire is."""
    slow = np.array(FREE_THROW) * np.repeat([1.0, 0.1, 0.0], 3)
    slow[2] = 1.0
    tiny = {"ball_radius": 2.0**-29, "wire_radius": 0.1}
    assert proved(slow, hoopgen.PAPER_COURT, scene=COURT) == [True]
    assert proved(
        slow, hoopgen.PAPER_COURT | tiny, scene=COURT, fields=("contacts", "estimated")
    ) == [True]
    tiny["ball_radius"] = 2.0**-34
    assert proved(slow, hoopgen.PAPER_COURT | tiny, scene=COURT) == [False]
    assert proved(slow, PAPER | tiny) == [True]
