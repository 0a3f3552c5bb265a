"""`aim` in scenes without a hoop: at points and at bodies, with and without air."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen import aim
from hoopgen.scene import Cone, End, Parameter, Plane, Scene, Torus
from hoopgen.simulation.engine import Engine
from tests.helpers.commands import failure, output

pytest.importorskip("sympy")  # which derives the scenes

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("field"),
]

LANDING = 1e-9
"""m, promised of every aim."""

PLACE = (-4.0, 0.5, 0.8)

LEAN, UP = 0.3, 1.6
MIDDLES = {"funnel": (0.0, 0.0, UP + 0.9), "ring": (4.0, 1.0, 1.8)}
"""The point of each body at which it is aimed."""


@cache
def field(air: bool = True, down: str = "-z") -> Engine:
    """Return a field with targets, in air or without."""
    return hoopgen.compile(
        Scene(
            "field",
            parameters=[
                Parameter("lean", LEAN, "1", "how far the ring leans", sign="any"),
                Parameter("up", UP, "m", "height of the targets"),
            ],
            ball_radius=0.12,
            gravity=9.81,
            down=down,
            restitution=0.4,
            air=air,
            bodies=[
                Plane("floor"),
                Cone("funnel", apex=[0, 0, "up"], half_angle="40deg", inside=True, span=[0.4, 0.9]),
                Torus("ring", radius=0.3, wire=0.02, centre=[4, 1, 1.8], axis=["-lean", 0, 1]),
            ],
            ends={
                "in_the_funnel": End(at="up + 0.35", within=["x**2 + y**2 - 0.2"]),
                "on_the_floor": End(at=0.13),
            },
        )
    )


@pytest.mark.parametrize("air", [True, False], ids=["air", "parabola"])
@pytest.mark.parametrize("name", list(MIDDLES))
def test_the_ball_comes_down_through_the_middle_of_a_body(name: str, air: bool) -> None:
    found = aim(position=PLACE, target=name, entry=1.0, backspin=9.0, scene=field(air))
    np.testing.assert_allclose(found.target, MIDDLES[name], rtol=0.0, atol=1e-15)
    assert found.landing_error < LANDING
    states, parameters = found.states(), dict(found.parameters)
    np.testing.assert_array_equal(states[:3], PLACE)
    (state,) = field(air).fly(np.array([found.time]), states[None], parameters)
    np.testing.assert_allclose(state[:3], MIDDLES[name], rtol=0.0, atol=LANDING)
    entry = np.arctan2(-state[5], np.hypot(state[3], state[4]))
    np.testing.assert_allclose(entry, 1.0, rtol=0.0, atol=1e-10)
    # The spin is about the horizontal across the flight, and turns the top of the ball back.
    np.testing.assert_allclose(np.cross(states[6:], [0.0, 0.0, 1.0])[:2] @ states[3:5] < 0.0, True)
    np.testing.assert_allclose(states[6:] @ states[3:6], 0.0, rtol=0.0, atol=1e-12)


@pytest.mark.parametrize("air", [True, False], ids=["air", "parabola"])
def test_rows_of_places_targets_and_parameters(air: bool) -> None:
    places = np.array([[-4.0, 0.0, 0.8], [3.0, 2.0, 1.0], [0.0, 0.0, 1.0]])
    found = aim(
        position=places,
        target="funnel",
        elevation=1.1,
        moving=(0.5, -1.0),
        parameters={"up": [1.6, 1.2, 1.6]},
        scene=field(air),
    )
    np.testing.assert_allclose(found.target[:, 2], [2.5, 2.1, 2.5], rtol=0.0, atol=1e-15)
    assert np.all(np.asarray(found.landing_error)[:2] < LANDING)
    # The last place is right below the funnel.
    np.testing.assert_array_equal(np.isfinite(found.speed), [True, True, False])
    relative = found.states()[:2, 3:6] - np.array([0.5, -1.0, 0.0])
    np.testing.assert_allclose(
        np.arctan2(relative[:, 2], np.hypot(*relative[:, :2].T)), 1.1, rtol=0.0, atol=1e-14
    )
    shots = found.simulate()
    assert shots.outcome[2] == field(air).outcomes["INVALID"]
    assert "invalid" in str(found)
    assert list(found.to_pandas().columns[:2]) == ["speed_m_s", "elevation_rad"]


def test_a_row_that_cannot_be_flown_does_not_lose_the_others() -> None:
    scene = Scene(
        "pull",
        parameters=[Parameter("pull", 9.81, "m/s²", "gravity", sign="any")],
        ball_radius=0.12,
        gravity=9.81,
        down=[0, 0, "-pull"],
        restitution=0.4,
        bodies=[Torus("ring", radius=0.3, wire=0.02, centre=[4, 1, 1.8])],
    )
    pulls = [9.81, -9.81, np.nan, 1.62]
    found = aim(position=PLACE, target="ring", entry=0.9, parameters={"pull": pulls}, scene=scene)
    np.testing.assert_array_equal(np.isfinite(found.speed), [True, False, False, True])
    assert np.all(np.asarray(found.landing_error)[[0, 3]] < LANDING)
    with pytest.raises(
        ValueError, match=r"^parameters\['pull'\]: expected a finite number, got nan"
    ):
        aim(position=PLACE, target="ring", parameters={"pull": np.nan}, scene=scene)


def test_an_airless_aim_is_that_at_a_hoop_at_the_same_place() -> None:
    own = aim(position=(4.0, 0.0, -1.0), target=(-0.1, 0.0, 0.0), entry=0.8, scene=field(False))
    hoop = aim(height=3.048 - 1.0, distance=4.0, depth=0.1, entry=0.8)
    for name in ("speed", "elevation", "time", "entry_angle"):
        np.testing.assert_allclose(getattr(own, name), getattr(hoop, name), rtol=1e-14, atol=0.0)
    np.testing.assert_allclose(own.states(), hoop.states(), rtol=0.0, atol=1e-14)


def test_what_the_flight_meets_before_a_target_is_said() -> None:
    clear = aim(position=PLACE, target="ring", entry=1.0, scene=field())
    assert "on_the_floor without a contact" in str(clear)
    flat = str(aim(position=PLACE, target="ring", elevation=0.3, scene=field()))
    assert "it touches the ring after" in flat
    assert "before the point aimed at" in flat
    # The first end is above this point.
    over = str(aim(position=PLACE, target=(0.0, 0.0, 1.8), entry=1.2, scene=field()))
    assert over.endswith("in_the_funnel without a contact, before the point aimed at")


def test_arguments_scatter_about_the_aim() -> None:
    found = aim(position=PLACE, target="funnel", entry=1.0, backspin=9.0, scene=field())
    centre = {name: float(value) for name, value in found.arguments.items()}
    machine = hoopgen.Scatter(centre, {"vx": 1e-9})
    share = hoopgen.estimate(machine, scene=field(), shots=100).shares["in_the_funnel"]
    assert share == 1.0
    np.testing.assert_array_equal(list(centre.values()), found.states())


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"target": "goal"}, r"target: 'goal' is no body .* floor, funnel, ring"),
        ({"target": "floor"}, r"target: the body floor is a plane, which has no point to aim at"),
        ({"target": (0.0, 1.0)}, r"target: expected x, y and z, shape \(\.\.\., 3\), got shape"),
        ({"position": (1.0, 2.0)}, r"position: expected x, y and z, shape"),
        ({"position": (0.0, 0.0, 0.3)}, r"target: .* not right above or below the release"),
        ({"position": (-4.0, np.nan, 0.3)}, r"position y: expected a finite number, got nan"),
        ({"speed": 5.0}, r"speed: the point needs at least 7\.\d+ m/s, got 5\.0"),
        ({"elevation": 0.1}, r"elevation: .* got 5\.73°"),
        ({"height": 2.0}, r"height: .* a release at a hoop, and the scene field has none"),
        ({"depth": 0.1}, r"depth: .* a release at a hoop"),
        ({"parameters": {"up": [1.0, 2.0]}, "speed": [7.0] * 3}, r"the shapes do not broadcast"),
    ],
)
@pytest.mark.parametrize("air", [True, False], ids=["air", "parabola"])
def test_what_cannot_be_aimed_is_said(air: bool, more: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        aim(**({"position": PLACE, "target": "funnel"} | more), scene=field(air))


def test_places_are_given_as_the_scene_needs_them() -> None:
    with pytest.raises(TypeError, match=r"^aim: missing target, which a scene without a hoop"):
        aim(position=PLACE, scene=field())
    with pytest.raises(TypeError, match=r"^aim: missing height and distance"):
        aim(entry=0.8)
    with pytest.raises(ValueError, match=r"^position: .* without a hoop; give height and distance"):
        aim(height=2.0, distance=4.0, position=PLACE)
    with pytest.raises(ValueError, match=r"^target: expected x, y and z, got 'ring'"):
        aim(height=2.0, distance=4.0, target="ring")


def test_gravity_points_down() -> None:
    with pytest.raises(ValueError, match=r"gravity points along -z; in field it is \(0, -9\.81, 0"):
        aim(position=PLACE, target="ring", scene=field(False, "-y"))


def test_the_command_aims_at_a_body(tmp_path: Path) -> None:
    file = tmp_path / "field.toml"
    file.write_text(
        'name = "field"\nball_radius = 0.12\ngravity = 9.81\nrestitution = 0.4\n'
        '[bodies.ring]\nkind = "torus"\nradius = 0.3\nwire = 0.02\ncentre = [4, 1, 1.8]\n'
        'axis = {tilt = "15deg"}\n[ends.below]\nat = 0\n'
    )
    words = ["--scene", str(file), "--position=-4,0,0.8"]
    picture = tmp_path / "shot.svg"
    more = ["--target", "ring", "--entry", "55deg", "--backspin", "2Hz", "--picture", str(picture)]
    said = output("aim", *words, *more)
    scene = hoopgen.load_scene(file)
    given = {"entry": np.radians(55.0), "backspin": 4.0 * np.pi}
    found = aim(position=(-4.0, 0.0, 0.8), target="ring", **given, scene=scene)
    assert f"{found.speed:.3f} m/s at {np.degrees(found.elevation):.1f}°, backspin 2.00 Hz" in said
    vx, vy, vz = found.states()[3:6]
    assert f"velocity ({vx:.3f}, {vy:.3f}, {vz:.3f}) m/s, spin" in said
    assert "comes down through (4.000, 1.000, 1.800) m" in said
    assert "below without a contact" in said
    assert picture.stat().st_size > 10_000
    record = json.loads(output("aim", *words, *more[:-2], "--json"))
    (release,) = record["releases"]
    assert (release["speed_m_s"], release["vx_m_s"]) == (found.speed, vx)
    assert (release["outcome"], release["counts"]) == ("below", {"ring": 0})
    assert record["target_m"] == [4.0, 1.0, 1.8]
    assert "ring" in output("aim", *words, "--target", "4,1,180cm", "--elevation", "25deg")
    for extra, error in {
        (): "missing --target",
        ("--target", "ring", "--height", "2m"): "--height is of a shot at a hoop",
        ("--target", "ring", "--csv", "x.csv"): "--csv is of a shot at a hoop",
        ("--target", "rim"): "'rim' is no body of the scene field, which has ring",
    }.items():
        assert error in failure("aim", *words, *extra)
