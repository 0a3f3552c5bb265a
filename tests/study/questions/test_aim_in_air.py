"""`aim` through air, at any point, and from a shooter that moves; releases by `aim` and `entry`."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen import PAPER_AIR, Resample, Scatter, aim
from hoopgen.simulation.lookup import BUILT_IN
from hoopgen.study.questions.aim_table import aim_table
from tests.helpers.commands import output

pytest.importorskip("sympy")  # which derives the scene in air

pytestmark = pytest.mark.xdist_group("air")

HERE: dict[str, Any] = {"height": 2.1, "distance": 4.191}
LANDING = 1e-9
"""m, promised of every aim."""


@pytest.mark.sampled(2)
@pytest.mark.parametrize("scene", ["hoop", "air"])
@pytest.mark.parametrize(
    "more",
    [
        {},
        {"elevation": 0.9, "backspin": 18.0, "sidespin": 20.0},
        {"entry": 0.8, "depth": 0.1, "angle": 0.5},
        {"speed": 8.0, "arc": "low"},
        {"elevation": 1.0, "target": (-0.2, 0.4, 0.6), "angle": -0.7},
        {"elevation": 0.9, "moving": (1.0, -2.0), "angle": 0.3},
        {"entry": 0.8, "moving": (-1.0, 1.0), "target": (0.1, 0.2, -0.3), "sidespin": 9.0},
        {"speed": 9.0, "moving": (1.0, 2.0), "angle": 2.0},
    ],
    ids=lambda one: "-".join(one) or "slowest",
)
def test_the_simulated_ball_is_at_the_point_at_the_time(scene: str, more: dict[str, Any]) -> None:
    engine = BUILT_IN[scene]()
    found = aim(**(HERE | more), scene=engine)
    assert found.landing_error < LANDING
    depth, angle = more.get("depth", 0.0), more.get("angle", 0.0)
    point = more.get("target", (-depth * np.cos(angle), -depth * np.sin(angle), 0.0))
    (state,) = engine.fly(np.array([found.time]), found.states()[None], dict(found.parameters))
    np.testing.assert_allclose(state[:3], point, rtol=0.0, atol=LANDING)
    assert state[5] < 0.0
    velocity = found.states()[3:6] - np.array([*more.get("moving", (0.0, 0.0)), 0.0])
    np.testing.assert_allclose(np.linalg.norm(velocity), found.speed, rtol=1e-14, atol=0.0)
    entry = np.arctan2(-state[5], np.hypot(state[3], state[4]))
    np.testing.assert_allclose(entry, more.get("entry", found.entry_angle), rtol=0.0, atol=1e-10)


def test_a_certified_shot_goes_through_the_point_that_was_aimed_at() -> None:
    flint = pytest.importorskip("flint")
    assert flint
    found = aim(**HERE, elevation=0.9, backspin=18.0, depth=0.02, scene=hoopgen.AIR)
    proof = hoopgen.AIR.certify(found.states(), PAPER_AIR)
    assert proof.outcome[0] == hoopgen.Outcome.MADE
    assert not proof.contacts[0]
    # The end plane lies below the ring's: the proved end leads back to the point.
    end = proof.state[0]
    back = found.time - proof.time[0]
    path = end[:3] + back * end[3:6]
    # Less than 5 ms of a fall that bends by 10 m/s² at most: 1.3e-4 m.
    assert np.hypot(path[0] + 0.02, path[1]) < 1.3e-4


def test_sidespin_turns_the_ball_aside_and_the_azimuth_corrects_it() -> None:
    left, right = (aim(**HERE, elevation=0.9, sidespin=s, scene=hoopgen.AIR) for s in (20.0, -20.0))
    assert left.azimuth < -0.01
    np.testing.assert_allclose(left.azimuth, -right.azimuth, rtol=1e-12, atol=0.0)
    assert aim(**HERE, elevation=0.9, sidespin=20.0).azimuth == 0.0  # without air


@pytest.mark.slow
def test_what_a_flight_meets_before_the_point_is_said() -> None:
    assert "touches the ring" in str(aim(**HERE, speed=7.5, arc="low", scene=hoopgen.AIR))
    assert "made without a contact" in str(aim(**HERE, elevation=0.9, scene=hoopgen.AIR))


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"speed": 7.0}, r"speed: the point needs at least 7\.41813 m/s, got 7\.0"),
        ({"elevation": 0.1}, r"elevation: no flight with this angle comes down .* got 5\.73°"),
        ({"height": np.nan}, r"height: expected a finite number, got nan"),
        ({"depth": -5.0}, r"depth: expected a point .* before the ball"),
        ({"target": (0.0, 1.0)}, r"target: expected x, y and z, shape \(\.\.\., 3\), got shape"),
        ({"target": (0.0, 1.0, 0.0), "depth": 0.1}, r"expected depth or target; got both"),
        ({"moving": 1.0}, r"moving: expected x and y, shape \(\.\.\., 2\), got shape \(\)"),
        ({"target": (4.191, 0.0, 0.0)}, r"target: .* not right above or below the release"),
        ({"sidespin": 1e6}, r"aim: sidespin"),
    ],
)
def test_what_cannot_be_aimed_is_said(more: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        aim(**(HERE | more), scene=hoopgen.AIR)


@pytest.mark.slow
def test_rows_without_a_release_are_invalid() -> None:
    found = aim(height=2.1, distance=[4.191, 400.0], elevation=0.9, scene=hoopgen.AIR)
    np.testing.assert_array_equal(np.isfinite(found.speed), [True, False])
    shots = found.simulate()
    assert shots.outcome.tolist() == [hoopgen.Outcome.MADE, hoopgen.Outcome.INVALID]


@pytest.mark.parametrize(
    ("scene", "article"),
    [
        ("court", "hoop"),
        pytest.param(
            "court-air",
            "air",
            marks=[pytest.mark.slow, pytest.mark.xdist_group("court_air")],  # compiled in minutes
        ),
    ],
)
def test_a_release_at_the_hoop_of_a_gym_is_that_at_the_article_s(scene: str, article: str) -> None:
    wanted = {"entry": 0.8, "backspin": 18.0, "sidespin": 6.0}
    gym, plain = BUILT_IN[scene](), BUILT_IN[article]()
    found, same = (aim(**HERE, **wanted, scene=one) for one in (gym, plain))
    assert found.landing_error < LANDING
    # The flight is the same up to the rounding of two programs of it.
    np.testing.assert_allclose(found.states(), same.states(), rtol=0.0, atol=1e-12)
    assert "made without a contact" in str(found)
    centre = {name: float(value) for name, value in found.arguments.items()}
    margin = hoopgen.margins(Scatter(centre), scene=gym, names=["azimuth"])["azimuth"]
    alike = hoopgen.margins(Scatter(centre), scene=plain, names=["azimuth"])["azimuth"]
    # To the sides only the inside of the ring ends the margin, which both hoops have.
    assert margin.low < margin.value < margin.high
    np.testing.assert_allclose(margin.searched, alike.searched, rtol=0.0, atol=0.0)


def test_a_scene_without_a_hoop_is_refused() -> None:
    floor = hoopgen.Scene(
        "floor",
        bodies=[hoopgen.scene.Plane("floor", at=0)],
        ball_radius=0.1,
        gravity=9.81,
        restitution=0.5,
        ends={"side": hoopgen.scene.End(axis="x", at=10)},
        air=True,
    )
    with pytest.raises(ValueError, match=r"^margins: its question is a hoop's, and the scene"):
        hoopgen.margins(Scatter({"x": 1.0}), scene=floor)
    with pytest.raises(ValueError, match=r"^aim_table: its question is a hoop's, and the scene"):
        aim_table([3.0], height=2.1, scene=floor)


@pytest.mark.slow
def test_a_table_in_air_hits_with_its_spin() -> None:
    table = aim_table(
        [3.0, 5.0], height=2.1, entry=0.85, sidespin=8.0, backspin=12.0, scene=hoopgen.AIR
    )
    assert np.all(table["azimuth"] < 0.0)
    assert np.all(table["low_speed"] < table["speed"])
    assert np.all(table["speed"] < table["high_speed"])
    vacuum = aim_table([3.0, 5.0], height=2.1, entry=0.85, sidespin=8.0, backspin=12.0)
    assert np.all(vacuum["speed"] < table["speed"])


@pytest.mark.slow
@pytest.mark.parametrize("by", [{"aim": 0.05, "elevation": 0.9}, {"aim": 0.05, "entry": 0.8}])
def test_releases_by_aim_and_entry_go_through_the_point_in_air(by: dict[str, float]) -> None:
    wanted = {name: value for name, value in by.items() if name != "aim"}
    found = aim(**HERE, depth=0.05, backspin=18.0, **wanted, scene=hoopgen.AIR)
    given = {**HERE, **by, "backspin": 18.0}
    drawn = Scatter(given).draw(0, 1, 0, PAPER_AIR)
    np.testing.assert_allclose(drawn.states[0], found.states(), rtol=1e-12, atol=1e-13)
    columns = {name: np.full(3, value) for name, value in given.items()}
    sampled = Resample(columns).draw(0, 2, 0, PAPER_AIR)
    np.testing.assert_array_equal(sampled.states, np.repeat(drawn.states, 2, axis=0))


@pytest.mark.slow
def test_an_estimate_of_releases_by_entry_in_air_says_what_that_of_its_speed_says() -> None:
    sd = {"speed": 0.05, "elevation": 0.01}
    by_entry = Scatter({**HERE, "entry": 0.8, "backspin": 18.0}, sd)
    found = aim(**HERE, entry=0.8, backspin=18.0, scene=hoopgen.AIR)
    given = {n: float(v) for n, v in found.arguments.items()}
    first, second = (
        hoopgen.estimate(one, PAPER_AIR, scene=hoopgen.AIR, shots=2000)
        for one in (by_entry, Scatter(given, sd))
    )
    assert first.made == second.made
    # A release of the parabola's is short, and goes in less often.
    vacuum = aim(**HERE, entry=0.8)
    short = given | {"speed": float(vacuum.speed), "elevation": float(vacuum.elevation)}
    third = hoopgen.estimate(Scatter(short, sd), PAPER_AIR, scene=hoopgen.AIR, shots=2000)
    assert third.probability < first.probability / 2


@pytest.mark.slow
def test_the_command_aims_through_air() -> None:
    words = [
        "--distance",
        "4.191m",
        "--height",
        "2.1m",
        "--entry",
        "46deg",
        "--backspin",
        "3Hz",
        "--sidespin",
        "2Hz",
    ]
    said = output("aim", *words, "--scene", "air")
    spins = {"backspin": 6.0 * np.pi, "sidespin": 4.0 * np.pi}
    found = aim(**HERE, entry=np.radians(46.0), **spins, scene=hoopgen.AIR)
    assert f"{found.speed:.3f} m/s" in said
    assert f"azimuth {np.degrees(found.azimuth):.1f}°" in said
    assert "scene   air, PAPER" in said
    assert "made without a contact" in said
