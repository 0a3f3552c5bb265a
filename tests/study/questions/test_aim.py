"""Aiming: the closed forms, the release that goes through a point, and what it forgives."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from click.testing import Result
from hoopgen.derive.motion.parabola import Parabola
from hoopgen.derive.studies import aiming
from hoopgen.derive.studies.aiming import entry, reach, release_speed, rise, slope
from hoopgen.derive.symbolic.conditionals import release as unheld
from hoopgen.derive.symbolic.symbols import POSITION, VELOCITY
from hoopgen.generated.numpy import hoop
from mpmath import mp, mpf
from numpy.typing import NDArray

import hoopgen
from hoopgen.core.units import FOOT
from hoopgen.hoop.releases import RING_HEIGHT
from hoopgen.study.measures.measures import measure
from hoopgen.study.named_units import named
from hoopgen.study.questions.aim import aim
from hoopgen.study.questions.aim_table import TABLE, aim_table, write_csv
from hoopgen.study.questions.aimed_release import NUMBERS, Aim
from hoopgen.text.numbers import format_count
from tests.helpers.commands import run
from tests.helpers.derived import decided
from tests.helpers.effort import exceptions, occurrences, trials

Floats = NDArray[np.float64]
EPS = float(np.finfo(np.float64).eps)
DEGREE = np.pi / 180
FREE_THROW = {"height": 7 * FOOT, "distance": 13.75 * FOOT}
GRAVITY = sp.Symbol("gravity", positive=True)
DIGITS = 40


# The closed forms, put into the flight


def _at_the_point(speed: sp.Expr, slope_: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return height above the release, and slope downwards, of Eq. 3 after the distance L."""
    level = speed / sp.sqrt(1 + slope_**2)
    place, velocity = Parabola((sp.Integer(0), sp.Integer(0), -GRAVITY)).at(reach / level)
    start = dict.fromkeys(POSITION, 0) | dict(
        zip(VELOCITY, (level, 0, slope_ * level), strict=True)
    )
    assert sp.simplify(place[0].subs(start) - reach) == 0
    return place[2].subs(start), -velocity[2].subs(start) / level


def test_the_aimed_speed_goes_through_the_point_with_the_entry_slope() -> None:
    speed = unheld(aiming.aimed_speed(GRAVITY)["speed"])
    risen, down = _at_the_point(speed, slope)
    assert sp.simplify(risen - rise) == 0
    assert sp.simplify(down - aiming.entry_slope()["entry"]) == 0


def test_the_slope_of_an_entry_has_that_entry() -> None:
    back = aiming.entry_slope()["entry"].subs(slope, aiming.slope_of_entry()["slope"])
    assert sp.simplify(back - entry) == 0


@pytest.mark.slow
@pytest.mark.parametrize("below", [True, False])
def test_the_least_speed_is_the_least(below: bool) -> None:
    """There the speed's square has no slope and bends upwards; both forms of the root."""
    slowest, least = (decided(e, below) for e in aiming.least_speed(GRAVITY).values())
    square = unheld(aiming.aimed_speed(GRAVITY)["speed"]) ** 2
    assert sp.simplify(sp.diff(square, slope).subs(slope, slowest)) == 0
    assert sp.simplify(square.subs(slope, slowest) - least**2) == 0
    bend = sp.diff(square, slope, 2)
    for height in (-3, 2):
        values = {rise: height, reach: 4, GRAVITY: 10}
        assert bend.subs(slope, slowest).subs(values) > 0


@pytest.mark.slow
@pytest.mark.parametrize("below", [True, False])
def test_both_slopes_of_a_speed_go_through_the_point(below: bool) -> None:
    """The heights h = (b - a)/2 and distances L² = a b make sqrt(h² + L²) = (a + b)/2 rational."""
    a, b = sp.symbols("a b", positive=True)
    point = {rise: (b - a) / 2, reach: sp.sqrt(a * b)}
    distance = {sp.sqrt(rise**2 + reach**2): (a + b) / 2}
    residue = _at_the_point(release_speed, slope)[0] - rise
    values = {release_speed: 9, a: 4, b: 5, GRAVITY: 10}
    both = []
    for expression in aiming.slopes_of_speed(GRAVITY).values():
        found = decided(expression, below).subs(distance).subs(point)
        assert sp.simplify(residue.subs(point).subs(slope, found)) == 0
        both.append(found.subs(values))
    assert both[0] < both[1]


# Numbers


def test_the_slowest_free_throw_from_7_feet() -> None:
    """45° + atan(h/L)/2 = 51.15°, v² = g (h + sqrt(h² + L²)), 7.145 m/s, and down at 38.85°."""
    found = aim(**FREE_THROW)
    assert found.elevation / DEGREE == pytest.approx(51.15, abs=0.005)
    assert found.speed == pytest.approx(7.145, abs=0.0005)
    assert found.entry_angle / DEGREE == pytest.approx(38.85, abs=0.005)
    high, far = RING_HEIGHT - 7 * FOOT, 13.75 * FOOT
    assert found.elevation == pytest.approx(np.pi / 4 + np.arctan(high / far) / 2, rel=4 * EPS)


def _places(count: int, seed: int) -> dict[str, Floats]:
    """Give places of release near and far, below the ring and above it."""
    random = np.random.default_rng(seed)
    return {
        "height": random.uniform(0.2, 4.5, count),
        "distance": random.uniform(0.5, 12.0, count),
        "depth": random.uniform(-0.3, 0.3, count),
    }


def _wanted(places: dict[str, Floats], how: str, seed: int) -> dict[str, Any]:
    """Give what is wanted of the releases from the places, in reach from all of them."""
    random = np.random.default_rng(seed)
    count = len(places["height"])
    line = (RING_HEIGHT - places["height"]) / (places["distance"] + places["depth"])
    if how in ("entry", "elevation"):
        # No flatter than the line to the point, nor than where it is level at one end.
        least = np.maximum(-line, 0.0) if how == "entry" else np.maximum(2 * line, line)
        flattest = np.arctan(least)
        return {how: flattest + (np.pi / 2 - flattest) * random.uniform(0.1, 0.9, count)}
    if how in ("high", "low"):
        return {"speed": random.uniform(1.02, 1.5, count) * aim(**places).speed, "arc": how}
    return {}


HOW = ("least", "entry", "elevation", "high", "low")


@pytest.mark.parametrize("how", HOW)
def test_the_flight_meets_the_point_to_a_few_roundings(how: str) -> None:
    """At 40 digits, with the speed and the elevation as returned.

    Each is right to a few roundings; of the elevation's, the tangent and back are two more. The
    place moves by what they are worth: 2 (L s - h) for the speed, whose own formula has lost what
    L s and h cancel, and L (1 + s²) for the slope, each relative, over the slope it comes down
    with; and L is rounded. A speed that was given leaves all to the slope, whose root has lost
    digits where the speed is near the least. Where the ball comes down almost level these
    derivatives say nothing.
    """
    places = _places(trials(300), seed=21)
    found = aim(**places, **_wanted(places, how, seed=22))
    assert np.isfinite(found.speed).all() or how == "low"
    met = found.entry_angle > 0.01
    assert met.sum() > occurrences(100)
    for row in np.flatnonzero(met):
        with mp.workdps(DIGITS):
            speed, elevation = mpf(found.speed[row].item()), mpf(found.elevation[row].item())
            level, up = speed * mp.cos(elevation), speed * mp.sin(elevation)
            high = mpf(RING_HEIGHT) - mpf(places["height"][row].item())
            g = mpf(hoopgen.PAPER["gravity"])
            fall = mp.sqrt(up**2 - 2 * g * high)
            time = (up + fall) / g
            off = (
                level * time
                - mpf(places["distance"][row].item())
                - mpf(places["depth"][row].item())
            )
            steep, down = float(up / level), float(fall / level)
            far = float(level * time)
            moves = (2 * (far * steep + abs(float(high))) + far * (1 + steep**2)) / down + far
            lost = 1.0
            if how in ("high", "low"):
                least = mpf(aim(**{n: v[row] for n, v in places.items()}).speed)
                lost = float(1 / (1 - (least / speed) ** 2))
            error = 4 * EPS * moves * lost
            assert abs(off) <= error
            assert abs(found.entry_angle[row] - mp.atan2(fall, level)) <= error / far
            assert abs(found.time[row] - time) <= time * error / far


@pytest.mark.parametrize("how", HOW)
def test_what_is_wanted_is_what_comes_back(how: str) -> None:
    places = _places(trials(200), seed=23)
    wanted = _wanted(places, how, seed=24)
    found = aim(**places, **wanted)
    names = {"entry": "entry_angle", "elevation": "elevation", "speed": "speed"}
    there = np.isfinite(found.speed)
    for name in names.keys() & wanted.keys():
        np.testing.assert_array_equal(getattr(found, names[name])[there], wanted[name][there])
    if how == "high":
        slower = aim(**places).elevation
        assert np.all(found.elevation > slower)


def test_the_slowest_is_slower_than_its_neighbours() -> None:
    """From close below the ring a neighbour may be none: the ball would not come from above."""
    places = _places(trials(200), seed=25)
    found = aim(**places)
    for away in (-1e-3, 1e-3):
        speeds = aim(**places, elevation=found.elevation + away).speed
        assert not np.any(speeds <= found.speed)
        assert np.count_nonzero(np.isnan(speeds)) <= exceptions(0.01, len(speeds))


@pytest.mark.parametrize("how", HOW)
def test_a_simulated_shot_comes_down_where_it_is_aimed(how: str) -> None:
    """`measure` finds the point on its first flight, from any place around the ring.

    Some roundings of the coordinates flown, times what a flight at a slant makes of them.
    """
    places = _places(500, seed=26)
    angle = np.random.default_rng(27).uniform(-np.pi, np.pi, 500)
    found = aim(**places, angle=angle, **_wanted(places, how, seed=28))
    states = hoopgen.release(**found.arguments, backspin=10.0)
    shots = hoopgen.simulate(states)
    seen = measure(states, shots, names=["depth", "left_right", "entry_angle"])
    free = (found.entry_angle > 0.01) & (shots.first != hoopgen.SURFACES.index("backboard"))
    free &= shots.outcome != hoopgen.Outcome.INVALID
    assert free.sum() > 50
    far = places["distance"] + places["depth"]
    slant = (1 + np.tan(found.elevation) ** 2) / np.tan(found.entry_angle) ** 2
    lost = np.ones(500)
    if how in ("high", "low"):
        lost = 1 / (1 - (aim(**places).speed / found.speed) ** 2)
    bound = 32 * EPS * (1 + far) * (1 + slant) * lost
    assert np.all(np.abs(seen["depth"] - places["depth"])[free] <= bound[free])
    assert np.all(np.abs(seen["left_right"])[free] <= bound[free])
    assert np.all(np.abs(seen["entry_angle"] - found.entry_angle)[free] <= bound[free])


def test_kernels_know_what_cannot_be_reached() -> None:
    with np.errstate(all="ignore"):
        assert np.isnan(hoop.aimed_speed(0.2, 4.0, 1.0, 9.81)).all(), "above the line of release"
        assert np.isnan(hoop.aimed_speed(0.2, 0.0, np.float64(1.0), 9.81)).all(), (
            "straight overhead"
        )
        assert np.isnan(hoop.slopes_of_speed(5.0, 4.0, 1.0, 9.81)).all(), "too slow"
        assert hoop.aimed_speed(0.25, 4.0, np.float64(1.0), 9.81) == (np.inf,), (
            "on the line of release"
        )
        # Far above the point the sum that cancels is not taken.
        slope_, speed = hoop.least_speed(np.float64(1e-3), -1e6, 9.81)
    assert slope_ == pytest.approx(0.5e-9, rel=4 * EPS)
    assert speed == pytest.approx(float(np.sqrt(9.81 * 0.5e-12)), rel=4 * EPS)


# What is given


def test_numbers_give_numbers_and_arrays_arrays() -> None:
    one = aim(**FREE_THROW)
    assert all(type(getattr(one, name)) is float for name in NUMBERS)
    many = aim(height=[2.0, 2.1], distance=[[4.0], [5.0], [6.0]], entry=0.8)
    assert all(np.shape(getattr(many, name)) == (3, 2) for name in NUMBERS)
    assert many.speed[2, 1] == aim(height=2.1, distance=6.0, entry=0.8).speed


def test_gravity_is_the_scene_s_and_may_be_many() -> None:
    moon = aim(**FREE_THROW, parameters=hoopgen.NBA | {"gravity": 1.62})
    both = aim(**FREE_THROW, parameters={"gravity": np.array([9.81, 1.62])})
    assert both.speed[1] == moon.speed < both.speed[0]
    assert moon.elevation == aim(**FREE_THROW).elevation


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"entry": 0.8, "speed": 8.0}, r"aim: expected .* got entry and speed$"),
        ({"entry": -0.1}, r"entry: .* within 0.00 and 90° .* got -5.73° \(-0.1 rad\)"),
        ({"entry": 0.1, "height": 3.5}, r"entry: .* within 6.16 and 90°"),
        ({"entry": 1.6}, "entry: "),
        ({"elevation": 0.3}, r"elevation: .* within 23.57 and 90° .* got 17.19° \(0.3 rad\)"),
        ({"elevation": 2.0}, "elevation: "),
        ({"elevation": 0.1, "height": 3.5}, ""),
        ({"elevation": -0.3, "height": 3.5}, r"elevation: .* within -6.16 and 90°"),
        (
            {"speed": 7.1},
            r"speed: the point of .* plane needs at least 7.14501 m/s, got 7.1$",
        ),
        ({"speed": -8.0}, "speed: "),
        ({"speed": 15.0, "arc": "low"}, "arc: the low one of this speed does not come down"),
        ({"arc": "middle"}, "arc: expected 'high' or 'low', got 'middle'"),
        ({"depth": -4.191}, "depth: expected a point of the ring's plane before the ball"),
        ({"distance": 0.0}, "distance: expected above 0: .*; got 0$"),
        ({"distance": -0.0, "depth": -0.1}, "distance: expected above 0: .*; got 0$"),
        ({"height": np.nan}, "height: expected a finite number, got nan"),
        ({"distance": np.inf}, "distance: expected a finite number, got inf"),
        ({"distance": 1e200}, r"aim: distance is in m, and these are more than 100: 1e\+200"),
        ({"distance": 1e-200, "height": -1.048}, "aim: the numbers are too large or too small"),
        ({"parameters": {"gravity": 0.0}}, r"parameters\['gravity'\]: expected above 0"),
        ({"parameters": {"bounce": 1}}, "parameters: unknown bounce. The names are ball_radius"),
        ({"height": [1, 2], "distance": [1, 2, 3]}, r"shapes do not broadcast: height \(2,\)"),
    ],
)
def test_what_cannot_be_aimed_is_said(given: dict[str, Any], said: str) -> None:
    if not said:
        assert isinstance(aim(**FREE_THROW | given), Aim)
        return
    with pytest.raises(ValueError, match=said):
        aim(**FREE_THROW | given)


def test_what_is_no_number_is_said() -> None:
    with pytest.raises(TypeError, match="height: expected numbers"):
        aim(height="tall", distance=4.0)


def test_in_a_batch_what_cannot_be_aimed_is_nan_and_does_not_disturb_the_rest() -> None:
    speeds = np.array([7.3, 7.1, np.nan, -8.0, 9.0])
    found = aim(**FREE_THROW, speed=speeds)
    assert np.isfinite(found.speed).tolist() == [True, False, False, False, True]
    for name in ("speed", "elevation", "entry_angle", "time"):
        column = getattr(found, name)
        assert np.isnan(column[1:4]).all()
        assert column[4] == getattr(aim(**FREE_THROW, speed=9.0), name)


# The table


@pytest.fixture(scope="module")
def table() -> dict[str, Floats]:
    return aim_table([3.0, 4.191, 1.0], height=7 * FOOT, entry=45 * DEGREE, backspin=6 * np.pi)


def test_the_table_holds_the_aims(table: dict[str, Floats]) -> None:
    assert tuple(table) == tuple(TABLE)
    found = aim(height=7 * FOOT, distance=table["distance"], entry=45 * DEGREE)
    for name in ("speed", "elevation", "entry_angle", "time"):
        np.testing.assert_array_equal(table[name], getattr(found, name))
    np.testing.assert_array_equal(table["backspin"], 6 * np.pi)


def _made(table: dict[str, Floats], row: int, **off: Any) -> NDArray[np.bool_]:
    names = ("speed", "elevation", "distance", "height", "backspin")
    release = {name: table[name][row] for name in names}
    shots = hoopgen.simulate(np.atleast_2d(hoopgen.release(**{**release, **off})))
    return np.asarray(shots.outcome == hoopgen.Outcome.MADE)


@pytest.mark.parametrize("row", [0, 1])
@pytest.mark.parametrize("name", ["speed", "elevation", "azimuth"])
def test_within_its_limits_a_shot_scores_and_just_beyond_it_does_not(
    table: dict[str, Floats], row: int, name: str
) -> None:
    """They are bisected to a 2^-40 of a step, which is a 2000th of 25° or of 25 %."""
    low, high = table[f"low_{name}"][row], table[f"high_{name}"][row]
    aimed = table[name][row] if name in table else 0.0
    assert low < aimed < high
    assert _made(table, row, **{name: np.linspace(low, high, 500)}).all()
    beyond = 1e-11 * max(1.0, abs(aimed))
    assert not _made(table, row, **{name: np.array([low - beyond, high + beyond])}).any()


def test_where_there_is_no_aim_or_no_goal_there_are_no_limits(table: dict[str, Floats]) -> None:
    """A ball from so near hits the ring from below, and beyond its range there is no aim."""
    limits = [name for name in TABLE if name.startswith(("low_", "high_"))]
    assert np.isfinite(table["speed"][2])
    assert all(np.isnan(table[name][2]) for name in limits)
    far = aim_table([4.0, 40.0], height=2.0, speed=8.0)
    assert np.isnan([far[name][1] for name in ("speed", "elevation", "time", *limits)]).all()
    assert np.isfinite([far[name][0] for name in TABLE]).all()


@pytest.mark.slow
def test_the_scene_and_what_counts_reach_the_limits() -> None:
    plain = aim_table([4.0], height=2.0)
    small = aim_table([4.0], height=2.0, parameters=hoopgen.PAPER | {"ball_radius": 0.09})
    direct = aim_table([4.0], height=2.0, by="direct")
    bank = aim_table([4.0], height=2.0, by="bank")
    assert small["high_azimuth"] > plain["high_azimuth"]
    assert direct["high_speed"] <= plain["high_speed"]
    assert np.isnan(bank["high_speed"]), "aimed at the centre it does not bank"


def test_columns_of_the_wrong_length_are_refused() -> None:
    with pytest.raises(ValueError, match=r"backspin: expected one number or 2; got shape \(3,\)"):
        aim_table([3.0, 4.0], height=2.0, backspin=[1.0, 2.0, 3.0])
    with pytest.raises(ValueError, match=r"distances: expected shape \(n,\), got \(1, 2\)"):
        aim_table([[3.0, 4.0]], height=2.0)


def test_a_file_has_degrees_and_units_in_its_names(
    table: dict[str, Floats], tmp_path: Path
) -> None:
    path = tmp_path / "table.csv"
    write_csv(path, table)
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 3
    assert float(rows[1]["distance_m"]) == 4.191
    assert float(rows[1]["entry_angle_deg"]) == 45.0
    assert float(rows[1]["backspin_hz"]) == 3.0
    assert float(rows[1]["speed_m_s"]) == pytest.approx(table["speed"][1], rel=1e-9)
    assert float(rows[1]["low_elevation_deg"]) * DEGREE == pytest.approx(
        table["low_elevation"][1], rel=1e-9
    )
    assert rows[2]["high_azimuth_deg"] == ""


# The command


def _run(*arguments: str) -> Result:
    return run("aim", "--height", "7ft", *arguments)


def test_the_command_says_one_aim_and_what_it_forgives() -> None:
    result = _run("--distance", "13.75ft", "--entry", "45deg", "--backspin", "3Hz")
    assert result.exit_code == 0, result.output
    assert "7.190 m/s at 55.2°, backspin 3.00 Hz" in result.stdout
    assert "the ring's plane at its centre, after 1.020 s at 45.0°" in result.stdout
    limits = aim_table([13.75 * FOOT], height=7 * FOOT, entry=45 * DEGREE, backspin=6 * np.pi)
    for limit in (limits["low_speed"], limits["high_speed"]):
        assert f"{limit.item():.3f} m/s" in result.stdout


def test_the_command_says_where_past_the_centre() -> None:
    result = _run("--distance", "13.75ft", "--depth", "2in", "--elevation", "52deg")
    assert "5.1 cm past its centre" in result.stdout
    assert "2.0 cm short of its centre" in _run("--distance", "4m", "--depth", "-2cm").stdout


def test_the_command_aims_at_any_point_from_a_place_that_moves() -> None:
    place = {"height": 7 * FOOT, "distance": 4.0, "entry": 50 * DEGREE}
    words = ("--distance", "4m", "--entry", "50deg")
    result = _run(*words, "--target", "30cm,0,-0.2", "--moving=-0.5,5ft/s")
    assert result.exit_code == 0, result.output
    found = aim(**place, target=(0.3, 0.0, -0.2), moving=(-0.5, 5 * FOOT))
    assert f"{found.speed:.3f} m/s at {np.degrees(found.elevation):.1f}°" in result.stdout
    assert f"azimuth {np.degrees(found.azimuth):.1f}°" in result.stdout
    assert "through (0.300, 0.000, -0.200) m from the ring's centre" in result.stdout
    assert "result  does not go in" in result.stdout
    many = _run("--distance", "4m,5m", "--entry", "50deg", "--moving", "0,1.5")
    assert "azim. (°)" in many.stdout


@pytest.mark.parametrize(
    ("more", "message"),
    [
        (["--target", "0,1"], "'0,1' is not X,Y,Z"),
        (["--moving", "1,2,3"], "'1,2,3' is not VX,VY"),
        (["--moving", "1m,2"], "'m' is not a unit of speed"),
        (["--target", "0,0,0", "--depth", "3cm"], "expected --depth or --target; got both"),
        (["--moving", "1,2", "--csv", "aim.csv"], "leave --moving or --csv"),
    ],
)
def test_what_is_no_target_or_velocity_is_an_error(more: list[str], message: str) -> None:
    result = _run("--distance", "4m", *more)
    assert result.exit_code == 2
    assert message in result.stderr


def test_what_a_release_from_a_moving_place_forgives_is_where_it_still_goes_in() -> None:
    velocity = (-0.7, 1.1)
    place = {"height": 2.0, "distance": 4.0, "entry": 0.85, "moving": velocity}
    table = aim_table([4.0], **{n: v for n, v in place.items() if n != "distance"})
    found = aim(**place)
    for name in ("speed", "elevation", "azimuth"):
        low, high = table[f"low_{name}"].item(), table[f"high_{name}"].item()
        value = getattr(found, name)
        assert low < value < high
        edge = 1e-9 * (high - low)
        ends = np.array([low - edge, low + edge, value, high - edge, high + edge])
        states = hoopgen.release(**{**found.arguments, name: ends})
        states[:, 3:5] += velocity
        assert hoopgen.simulate(states).made.tolist() == [False, True, True, True, False], name


@pytest.mark.slow
@pytest.mark.parametrize(
    ("written", "distances"),
    [
        ("3m:4m:0.5m", [3.0, 3.5, 4.0]),
        ("3:4:0.1m", np.linspace(3.0, 4.0, 11)),
        ("3:6:2", [3.0, 5.0]),
        ("3:6:2.0", [3.0, 5.0]),
        ("10ft,4m", [10 * FOOT, 4.0]),
    ],
)
def test_the_command_writes_a_table(written: str, distances: Any, tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    result = _run("--distance", written, "--preset", "nba", "--csv", str(path))
    assert result.exit_code == 0, result.output
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    # A step has been added, and ten digits are written.
    assert [float(row["distance_m"]) for row in rows] == pytest.approx(list(distances), rel=1e-9)
    expected = aim_table(distances, height=7 * FOOT, parameters=hoopgen.NBA)
    written_limits = [float(row["high_speed_m_s"]) for row in rows]
    assert written_limits == pytest.approx(expected["high_speed"].tolist(), rel=1e-9)
    assert len(result.stdout.splitlines()) == len(rows) + 5
    assert result.stdout.endswith("\n\nscene   NBA\n")
    assert {name: float(rows[0][name]) for name in hoopgen.NBA} == dict(hoopgen.NBA)


def test_the_command_says_what_a_steep_shot_forgives() -> None:
    result = _run("--distance", "0.5m", "--elevation", "89.4deg")
    assert result.exit_code == 0, result.output
    assert "nan" not in result.stdout
    assert "89.2°" in result.stdout
    assert "89.6°" in result.stdout


def test_the_command_shows_what_is_out_of_reach() -> None:
    result = _run("--distance", "4m,40m", "--speed", "8")
    assert result.exit_code == 0
    *_, row, _, why, _, _ = result.stdout.splitlines()
    assert row.split() == ["40.000", *["-"] * 9]
    assert why.startswith("no release from 40.000 m: speed: the point of the ring's plane needs")


@pytest.mark.parametrize("more", [(), ("--scene", "air"), ("--moving", "1,0")])
def test_each_distance_without_a_release_has_the_reason_that_it_has_alone(
    more: tuple[str, ...],
) -> None:
    asked = ("--speed", "8", *more)
    many = _run("--distance", "3m:30m:9m", *asked)
    for distance in (12, 21, 30):
        reason = _run("--distance", f"{distance}m", *asked).stderr.partition("--")[2].strip()
        assert f"no release from {distance}.000 m: {reason}\n" in many.stdout
    assert many.stdout.count("no release from") == 3


def test_of_many_distances_without_a_release_the_first_ones_have_reasons() -> None:
    result = _run("--distance", "10m:40m:2m", "--speed", "8")
    assert result.stdout.count("no release from") == 10
    assert "\nand 6 more distances; --json has all\n" in result.stdout


def test_a_shot_that_does_not_go_in_is_told() -> None:
    result = _run("--distance", "1m", "--entry", "45deg", "--backspin", "3Hz")
    assert result.exit_code == 0
    assert "does not go in" in result.stdout


def test_json_has_what_the_library_gives_and_what_the_flights_do() -> None:
    words = ["--distance", "4m,5m,40m", "--speed", "8", "--depth", "2cm", "--json"]
    record = json.loads(_run(*words).stdout)
    table = aim_table([4.0, 5.0, 40.0], height=7 * FOOT, speed=8.0, depth=0.02)
    for row, release in enumerate(record["releases"]):
        for name, column in table.items():
            wanted = None if np.isnan(column[row]) else column[row]
            assert release[named(name)] == wanted, name
    flights = [(release["outcome"], release["touched_before"]) for release in record["releases"]]
    assert flights == [("made", None), ("made", None), ("invalid", None)]
    reasons = [release["why_no_release"] for release in record["releases"]]
    assert reasons[:2] == [None, None]
    assert reasons[2].startswith("speed: the point of the ring's plane needs at least")
    assert record["releases"][0]["counts"].keys() == set(hoopgen.SURFACES)
    assert (record["depth_m"], record["by"], record["moving_m_s"]) == (0.02, "any", None)
    assert record["parameters"]["ring_radius_m"] == hoopgen.PAPER["ring_radius"]
    (one,) = json.loads(_run("--distance", "1m", "--json").stdout)["releases"]
    assert one["touched_before"] == "ring"


@pytest.mark.slow
def test_an_aim_says_what_its_flight_does() -> None:
    """Python and the command line give its end, and the bodies that it meets before the point."""
    near = aim(height=7 * FOOT, distance=1.0)
    shots = near.simulate()
    first = shots.events[0]
    assert shots.contacts[0] > 0
    assert first["time"] < near.time
    before = f"it touches the ring after {first['time']:.3f} s, before the point aimed at"
    assert str(near).endswith(before)
    assert f"after {format_count(int(shots.contacts[0]), 'contact')} (ring" in str(near)
    clear = aim(height=7 * FOOT, distance=13.75 * FOOT, entry=50 * DEGREE)
    assert str(clear).endswith("without spin made without a contact")
    many = aim(height=7 * FOOT, distance=[1.0, 13.75 * FOOT])
    made = int(many.simulate().made.sum())
    assert str(many) == (
        f"2 releases; without spin {made} made, 1 touch something before the point aimed at"
    )
    told = _run("--distance", "1m")
    assert before in told.stdout
    table = _run("--distance", "1m,13.75ft")
    assert table.stderr.startswith("hoopgen: 1 of 2 flights touch something before the point aimed")
    assert "from 1.000 m;" in table.stderr
    assert _run("--distance", "13.75ft,14ft", "--entry", "50deg").stderr == ""


def test_an_aim_is_flown_in_the_scene_that_it_is_aimed_in() -> None:
    both = aim(**FREE_THROW, parameters={"gravity": np.array([9.81, 1.62])})
    assert both.simulate().parameters["gravity"].tolist() == [9.81, 1.62]
    spun = both.simulate(backspin=[0.0, 6 * np.pi])
    assert spun.state.shape == (2, 9)
    none = aim(height=2.0, distance=[4.0, 0.0])
    assert none.simulate().outcome[1] == hoopgen.Outcome.INVALID


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (
            ["--distance", "4m", "--speed", "3"],
            "speed: the point of the ring's plane needs at least",
        ),
        (["--distance", "4m", "--speed", "9", "--entry", "45deg"], "got --entry and --speed"),
        (["--distance", "4m:3m:0.1m"], "FROM below TO; it is 4 m to 3 m in steps of 0.1 m"),
        (["--distance", "3m:4m:0"], "expected FROM:TO:STEP of 2 to 10,000 distances"),
        (["--distance", "3m:4m:5"], "it is 3 m to 4 m in steps of 5 m"),
        (["--distance", "3m:4m"], "is not FROM:TO:STEP"),
        (["--distance", "3m:4m:1mm:2"], "is not FROM:TO:STEP"),
        (["--distance", "1m:500m:1mm"], "2 to 10,000 distances"),
        (["--distance", "4kg"], "'kg' is not a unit of length"),
    ],
)
def test_errors_of_the_command_are_one_line(arguments: list[str], said: str) -> None:
    result = _run(*arguments)
    assert result.exit_code == 2
    assert said in result.stderr
    assert result.stderr.startswith("hoopgen: error: ")
    assert result.stderr.count("\n") == 1


def test_an_aim_off_the_board_that_goes_in_directly_is_said_not_to_go_in_off_the_board() -> None:
    result = run("aim", "--distance", "13.75ft", "--height", "7ft", "--by", "bank")
    assert "does not go in off the board" in result.stdout
