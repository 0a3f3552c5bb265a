"""The best release, what it forgives, and bank shots against direct ones."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from tests.helpers.commands import run, succeed

pytest.importorskip("scipy")
pytest.importorskip("xarray")
pytest.importorskip("pyarrow")

import hoopgen
from hoopgen.hoop.variables import ARGUMENTS
from hoopgen.study.jobs.objective import Player
from hoopgen.study.jobs.task_runner import task_runner
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.named_units import in_units
from hoopgen.study.questions.aim_points import on_board
from hoopgen.study.questions.bank import bank_or_direct, crossing
from hoopgen.study.questions.margins import _SMOOTH, Margin, margins
from hoopgen.study.questions.optimum import optimum
from hoopgen.study.questions.optimum_result import Optimum
from hoopgen.study.questions.search import bounds_of
from hoopgen.study.statistics.intervals import wilson_interval

pytestmark = pytest.mark.xdist_group("optimum")  # each search is made once

DEGREE = np.pi / 180
SD = {"speed": 0.07, "elevation": 1.3 * DEGREE, "azimuth": 1.0 * DEGREE}
PLACE = {"height": 2.1336, "distance": 4.191, "backspin": 6 * np.pi}
BOARD = hoopgen.SURFACES.index("backboard")


@pytest.fixture(scope="module")
def best() -> Optimum:
    return optimum(Scatter(PLACE, SD), ["elevation", "aim"], shots=8_000)


@pytest.fixture(scope="module")
def bank() -> Optimum:
    place = PLACE | {"distance": 2.7, "angle": 50 * DEGREE}
    return optimum(Scatter(place, SD), ["elevation", "aim", "azimuth"], by="bank", shots=8_000)


# Candidates


def test_a_candidate_is_thrown_as_the_release_model_throws_it() -> None:
    sd = SD | {"restitution": 0.02, "ball_radius": 1e-4}
    correlation = {("speed", "elevation"): -0.3, ("azimuth", "restitution"): 0.5}
    aims = np.array([-0.05, 0.0, 0.04])
    values = PLACE | {"elevation": 0.9, "gravity": 9.8}
    thrown = Player(Scatter({}, sd, correlation)).sampled({**values, "aim": aims}, 1500, seed=9)
    for aim, count in zip(aims.tolist(), thrown.made.tolist(), strict=True):
        drawn = Scatter({**values, "aim": aim}, sd, correlation).draw(0, 1500, seed=9)
        outcome = hoopgen.simulate(drawn.states, drawn.parameters).outcome
        assert count == np.count_nonzero(outcome == hoopgen.Outcome.MADE)


def test_so_many_shots_that_they_come_in_blocks_are_the_same_shots(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    values = PLACE | {"elevation": 0.9, "speed": np.linspace(7.0, 7.4, 5)}
    whole = Player(Scatter({}, SD)).sampled(values, 1000, seed=3)
    monkeypatch.setattr("hoopgen.study.jobs.objective.TASK", 96)
    again = Player(Scatter({}, SD)).sampled(values, 1000, seed=3)
    assert (again.made.tolist(), again.valid.tolist()) == (whole.made.tolist(), [1000] * 5)
    one = Player(Scatter({}, SD)).scored({**values, "speed": 7.2}, 1000, seed=3)
    assert (one.made.sum(), one.valid.sum()) == (whole.made[2], 1000)


def test_off_the_board_counts_what_touches_it_first_and_direct_the_rest() -> None:
    values = PLACE | {"elevation": 0.93, "speed": np.array([7.2, 7.4, 7.6])}
    counted = {
        by: Player(Scatter({}, SD), by=by).sampled(values, 3000).made
        for by in ("any", "direct", "bank")
    }
    assert (counted["any"] == counted["direct"] + counted["bank"]).all()
    for speed, count in zip(values["speed"].tolist(), counted["bank"].tolist(), strict=True):
        drawn = Scatter({**values, "speed": speed}, SD).draw(0, 3000)
        shots = hoopgen.simulate(drawn.states)
        made = shots.outcome == hoopgen.Outcome.MADE
        assert count == np.count_nonzero(made & (shots.first == BOARD))
    assert counted["bank"].max() > 1000 < counted["direct"].max()


def test_the_threads_change_nothing() -> None:
    values = PLACE | {"elevation": 0.9, "speed": np.linspace(7.0, 7.4, 5)}
    player = Player(Scatter({}, SD))
    wanted = player.sampled(values, 40_000).made.tolist()
    for threads in (1, 2):
        with task_runner({}, threads=threads) as together:
            thrown = replace(player, runner=together).sampled(values, 40_000)
        assert thrown.made.tolist() == wanted


# The best release


@pytest.mark.slow
def test_no_release_of_a_random_hundred_is_better_on_fresh_shots(best: Optimum) -> None:
    random = np.random.default_rng(1)
    values = {name: random.uniform(*ends, 100) for name, ends in best.bounds.items()}
    made = Player(Scatter({}, SD)).sampled({**PLACE, **values}, best.shots, seed=77).made
    assert made.max() / best.shots < best.high
    assert made.mean() / best.shots < best.probability - 0.1


@pytest.mark.slow
def test_the_probability_is_of_fresh_shots_with_its_interval(best: Optimum) -> None:
    made = Player(Scatter({}, SD)).sampled(best.release, best.shots, best.seed + 1).made[0]
    assert (best.made, best.probability) == (made, made / best.shots)
    assert (best.low, best.high) == wilson_interval(made, best.shots, best.confidence)


UNSTEADY = SD | {"restitution": 0.3}
"""A spread of restitution so wide that some values are above 1, which makes shots invalid."""


@pytest.mark.slow
def test_an_invalid_shot_is_no_trial_of_an_optimum_as_of_an_estimate() -> None:
    found = optimum(Scatter(PLACE, UNSTEADY), ["elevation", "aim"], shots=2_000, seed=6, margins=())
    counted = hoopgen.estimate(Scatter(found.release, UNSTEADY), shots=2_000, seed=7)
    assert 100 < found.invalid == counted.invalid
    assert (found.probability, found.low, found.high) == (
        counted.probability,
        counted.low,
        counted.high,
    )
    assert f"; 2,000 fresh shots, {found.invalid} of them invalid" in str(found)


@pytest.mark.slow
def test_a_pair_with_an_invalid_shot_does_not_count() -> None:
    over, place = ["elevation"], PLACE | {"aim": 0.03}
    unsteady = optimum(Scatter(place, UNSTEADY), over, shots=1_000, margins=())
    steady = optimum(Scatter(place, SD), over, shots=1_000, margins=())
    first, second = (Scatter(one.release, one.model.sd) for one in (steady, unsteady))
    counted = hoopgen.compare(first, second, shots=1_000, seed=1)
    assert unsteady.lead(steady) == (counted.difference, counted.low, counted.high)
    assert counted.both + counted.only_first + counted.only_second + counted.neither < 950


@pytest.mark.slow
def test_the_scene_may_be_given_in_the_release() -> None:
    changed = {"restitution": 0.6, "board_distance": 0.5, "gravity": 9.7}
    within = optimum(Scatter(PLACE | changed, SD), ["elevation", "aim"], shots=500)
    beside = optimum(Scatter(PLACE, SD), ["elevation", "aim"], hoopgen.PAPER | changed, shots=500)
    same = replace(within, release=beside.release, model=beside.model)
    assert same == beside
    assert within.release == beside.release | changed
    assert hoopgen.release(**within.arguments).shape == (9,)


def test_a_parameter_that_was_searched_over_is_that_of_the_scene() -> None:
    found = optimum(
        Scatter(PLACE | {"elevation": 0.93}, SD),
        {"aim": None, "restitution": (0.5, 0.6)},
        shots=500,
        margins=["restitution"],
    )
    assert found.parameters["restitution"] == found.release["restitution"] <= 0.6
    assert found.margins["restitution"].value == found.release["restitution"]


@pytest.mark.slow
def test_straight_in_front_the_best_direction_is_straight_on() -> None:
    release = PLACE | {"elevation": 52 * DEGREE, "aim": 0.04}
    found = optimum(
        Scatter(release, SD), {"azimuth": (-4 * DEGREE, 3 * DEGREE)}, shots=8_000, margins=()
    )
    low, high = found.flat["azimuth"]
    assert low < 0.0 < high
    # As flat to the left as to the right, but for the random numbers: a tenth of the scatter.
    assert abs(low + high) / 2 < 0.1 * SD["azimuth"]
    assert low <= found.release["azimuth"] <= high


@pytest.mark.slow
def test_the_flat_range_is_flat_and_its_ends_are_its_ends() -> None:
    release = PLACE | {"elevation": 52 * DEGREE}
    found = optimum(Scatter(release, SD), ["aim"], shots=40_000, margins=())
    few = found.shots // 4  # no fewer are taken
    player, fresh = Player(Scatter({}, SD)), found.seed + 1  # those of the search would flatter it
    share = lambda aim: player.sampled({**release, "aim": aim}, few, fresh).share[0]  # noqa: E731
    least = share(found.release["aim"]) - found.tolerance
    low, high = found.flat["aim"]
    assert share(low) >= least
    assert share(high) >= least
    # The ends are the outermost of some 200 points, so that an eighth further out none is left.
    assert share(low - (high - low) / 8) < least
    assert share(high + (high - low) / 8) < least


@pytest.mark.slow
def test_a_bound_that_is_in_the_way_is_named() -> None:
    over = {"elevation": (44 * DEGREE, 48 * DEGREE), "aim": None}
    found = optimum(Scatter(PLACE, SD), over, shots=4_000, margins=())
    assert found.at_bounds == ("elevation",)
    assert "release angle" in next(line for line in str(found).splitlines() if "beyond" in line)


@pytest.mark.slow
def test_the_same_question_has_the_same_answer() -> None:
    once, again, other = (
        optimum(Scatter(PLACE, SD), ["elevation", "aim"], shots=500, seed=seed, margins=["speed"])
        for seed in (4, 4, 5)
    )
    assert once == again
    assert once.release != other.release


@pytest.mark.slow
def test_it_knows_where_its_flight_comes_down(best: Optimum) -> None:
    # eps times the distance, and some for the path through speed and back.
    assert best.depth == pytest.approx(best.release["aim"], abs=64 * np.finfo(float).eps * 4.2)
    assert 35 * DEGREE < best.entry_angle < 50 * DEGREE


@pytest.mark.slow
def test_off_the_board_the_best_release_is_off_the_board(bank: Optimum) -> None:
    shots = hoopgen.simulate(hoopgen.release(**bank.arguments))
    assert shots.outcome[0] == hoopgen.Outcome.MADE
    assert shots.first[0] == BOARD
    # From the right of the board, the ball goes to the right of the ring's centre.
    assert bank.release["azimuth"] < -2 * DEGREE


@pytest.mark.slow
def test_the_lead_is_of_the_same_shots(best: Optimum) -> None:
    short = optimum(Scatter(PLACE | {"aim": -0.1}, SD), ["elevation"], shots=8_000, margins=())
    difference, low, high = best.lead(short)
    assert difference == (best.made - short.made) / best.shots
    assert 0.0 < low < difference < high
    assert best.lead(best)[0] == 0.0
    with pytest.raises(ValueError, match="same seed"):
        best.lead(optimum(Scatter(PLACE | {"aim": 0.0}, SD), ["elevation"], shots=100, margins=()))


def test_usual_bounds_need_the_place_however_it_is_given() -> None:
    by_distance = bounds_of(["elevation", "speed"], PLACE, Player(Scatter({}, SD)))
    release = {"height": 2.1336, "x": 4.191 * 0.6, "y": 4.191 * 0.8}
    by_place = bounds_of(["elevation", "speed"], release, Player(Scatter({}, SD)))
    for name, ends in by_distance.items():
        # Three sides of a right triangle: a rounding or two.
        assert by_place[name] == pytest.approx(ends, rel=1e-15, abs=0.0)
    with pytest.raises(ValueError, match="no usual bounds"):
        bounds_of(["elevation"], {"height": 2.0}, Player(Scatter({}, SD)))


@pytest.mark.slow
def test_everything_goes_into_json(best: Optimum) -> None:
    read = json.loads(json.dumps(best.as_dict(), allow_nan=False))
    assert read["release"] == best.release
    assert read["margins"]["speed"]["low"] == best.margins["speed"].low
    assert read["flat"]["aim"] == list(best.flat["aim"])


@pytest.mark.slow
def test_what_is_not_a_number_is_none_in_json(best: Optimum) -> None:
    margin = replace(best.margins["speed"], low=np.nan, high=np.nan, steady=(np.nan, np.nan))
    margins = {**best.margins, "speed": margin}
    nowhere = replace(best, entry_angle=np.nan, depth=np.nan, margins=margins)
    read = json.loads(json.dumps(nowhere.as_dict(), allow_nan=False))
    assert (read["entry_angle"], read["depth"]) == (None, None)
    assert (read["margins"]["speed"]["low"], read["margins"]["speed"]["high"]) == (None, None)
    assert read["margins"]["speed"]["steady"] == [None, None]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"over": ["elevaton"]}, "over: unknown elevaton"),
        ({"over": []}, "over: expected at least one variable"),
        ({"release": PLACE | {"distance": 0}}, "distance: expected above 0 .*elevation.*got 0$"),
        ({"over": {"aim": (0.1, 0.1)}}, r"over\['aim'\]: expected \(low, high\)"),
        ({"over": ["elevation", "height"]}, "already in over"),
        ({"over": ["sidespin", "restitution"]}, r"over\['restitution'\]: .* no usual bounds"),
        ({"over": {"elevation": None, "aim": (30.0, 31.0)}}, "over: no release tried succeeds"),
        ({"release": PLACE | {"hight": 2.0}}, "release: unknown hight"),
        ({"release": PLACE | {"backspin": [1.0, 2.0]}}, r"release\['backspin'\]: expected one"),
        ({"sd": {}}, "sd: expected a deviation above 0"),
        ({"sd": {"speed": -0.1}}, r"sd\['speed'\]: expected"),
        ({"by": "bounce"}, "by: expected any, direct, bank, got 'bounce'"),
        ({"shots": 0}, "shots: expected a whole number from 1"),
        ({"seed": 2**64 - 1}, "seed: expected"),
        ({"confidence": 95}, "confidence: expected a number within 0 and 1"),
        ({"margins": ["wind"]}, "margins: unknown wind"),
        ({"parameters": hoopgen.PAPER | {"mass": 0.6}}, "parameters: unknown mass"),
    ],
)
def test_a_wrong_argument_is_named(change: Mapping[str, Any], message: str) -> None:
    given = {"release": PLACE, "sd": SD, "over": ["elevation", "aim"], "shots": 64} | change
    with pytest.raises(ValueError, match=message):
        optimum(Scatter(given.pop("release"), given.pop("sd")), given.pop("over"), **given)


# Margins


def succeeds(release: Mapping[str, float], by: str = "any") -> bool:
    shots = hoopgen.simulate(hoopgen.release(**release))
    made = shots.outcome[0] == hoopgen.Outcome.MADE
    return bool(made and (by == "any" or (shots.first[0] == BOARD) == (by == "bank")))


def ends(margin: Margin) -> list[tuple[float, float]]:
    """Pairs of what is inside and what is outside an end, a billionth of the range apart."""
    step = 1e-9 * (margin.searched[1] - margin.searched[0])
    runs = [(margin.low, margin.high), *margin.elsewhere]
    pairs = [(low + step, low - step) for low, _ in runs if low > margin.searched[0]]
    return pairs + [(high - step, high + step) for _, high in runs if high < margin.searched[1]]


@pytest.mark.parametrize("which", ["best", "bank"])
@pytest.mark.slow
def test_at_the_ends_of_a_margin_the_outcome_changes(
    which: str, request: pytest.FixtureRequest
) -> None:
    found: Optimum = request.getfixturevalue(which)
    tried = 0
    for margin in found.margins.values():
        assert margin.low <= found.arguments[margin.name] <= margin.high
        for inside, outside in ends(margin):
            assert succeeds(found.arguments | {margin.name: inside}, found.by)
            assert not succeeds(found.arguments | {margin.name: outside}, found.by)
            tried += 1
    assert tried >= 12


@pytest.mark.slow
def test_a_margin_lists_the_other_ways_in(best: Optimum) -> None:
    speed = best.margins["speed"]
    assert speed.elsewhere  # faster, it goes in off the board
    assert f"in {len(speed.elsewhere)} further intervals" in str(speed)
    runs = sorted([(speed.low, speed.high), *speed.elsewhere])
    for (_, left), (right, _) in pairwise(runs):
        assert left < right
        assert not succeeds(best.arguments | {"speed": (left + right) / 2})


@pytest.mark.slow
def test_with_scatter_the_probability_falls_by_the_tolerance_at_the_ends(best: Optimum) -> None:
    few = best.shots  # fewer are not taken
    for name, margin in best.margins.items():
        assert margin.steady is not None

        def share(at: float, name: str = name) -> float:
            values, fresh = {**best.arguments, name: at}, best.seed + 1
            return float(Player(Scatter({}, SD)).sampled(values, few, fresh).share[0])

        least = share(margin.value) - best.tolerance
        for end, furthest in zip(margin.steady, margin.searched, strict=True):
            assert share(end) >= least
            # What is outside was bisected to this distance.
            out = (furthest - margin.value) / _SMOOTH[0] / 2 ** _SMOOTH[1]
            assert share(end + out) < least or end == furthest


def test_the_margin_of_the_aim_changes_the_speed() -> None:
    # No gap narrower than a step lies between the ends, which one of the two might step over.
    release = PLACE | {"elevation": 53 * DEGREE, "aim": 0.05}
    found = margins(Scatter(release), names=["aim", "speed"])
    aim, speed = found["aim"], found["speed"]
    at = [
        Scatter(release | {"aim": end}).draw(0, 1).columns["speed"][0]
        for end in (aim.low, aim.high)
    ]
    # Both are bisected to the fortieth part of a step: the speed is as good as the aim is.
    assert at == pytest.approx([speed.low, speed.high], abs=1e-12)


def test_a_shot_that_misses_has_no_margin() -> None:
    missed = margins(Scatter(PLACE | {"speed": 5.0, "elevation": 0.9}), names=["azimuth"])[
        "azimuth"
    ]
    assert np.isnan(missed.low)
    assert np.isnan(missed.high)
    assert "does not succeed" in str(missed)


@pytest.mark.parametrize("elevation", [89.4, 89.999, 90.0, 91.0, -89.999, -91.0])
def test_a_release_lies_within_what_is_searched_however_steep(elevation: float) -> None:
    value = elevation * DEGREE
    margin = margins(Scatter(PLACE | {"speed": 9.0, "elevation": value}), names=["elevation"])[
        "elevation"
    ]
    assert margin.searched[0] <= margin.value == value <= margin.searched[1]


@pytest.mark.parametrize("name", ["elevation", "entry"])
def test_a_steep_release_that_goes_in_has_its_margin(name: str) -> None:
    given = {"elevation": 89.4 * DEGREE, "aim": 0.0} if name == "elevation" else {"entry": 1.56}
    margin = margins(Scatter(PLACE | given), names=[name])[name]
    assert margin.low < margin.value < margin.high
    assert margin.high <= 90 * DEGREE


def test_a_variable_that_is_not_the_releases_is_refused() -> None:
    with pytest.raises(ValueError, match="names: aim is no variable of this release"):
        margins(Scatter(PLACE | {"speed": 7.2, "elevation": 0.9}), names=["aim"])


# Bank or direct


def test_lines_cross_where_they_were_drawn_through() -> None:
    random = np.random.default_rng(5)
    starts, towards = random.uniform(1.0, 3.0, (2, 7, 2))
    point = np.array([-0.5, 0.1])
    found = crossing(starts, starts + (point - starts) * towards[:, :1])
    # Errors of eps at a few metres, and lines that cross at small angles.
    assert (found.x, found.y) == pytest.approx(tuple(point), abs=1e-13)
    assert found.spread < 1e-14
    with pytest.raises(ValueError, match="parallel"):
        crossing([[0.0, 0.0], [0.0, 1.0]], [[1.0, 1.0], [1.0, 2.0]])


@pytest.mark.slow
def test_the_ball_touches_the_board_a_radius_from_its_centre(bank: Optimum) -> None:
    touch = on_board(bank.arguments, bank.parameters)
    shots = hoopgen.simulate(hoopgen.release(**bank.arguments), record=True)
    centre = shots.events["before"][0][:3]
    normal = np.array([1.0, 0.0, 0.0])
    x, y, z = centre - hoopgen.PAPER["ball_radius"] * normal
    # The contact's time is rounded, at some 4 m/s.
    assert x == pytest.approx(-hoopgen.PAPER["board_distance"], abs=1e-14)
    assert (touch["touch_y"], touch["touch_z"]) == (y, z)


@pytest.mark.slow
def test_a_release_points_along_its_line_of_sight(bank: Optimum) -> None:
    state = hoopgen.release(**bank.arguments)
    sight = on_board(bank.arguments, bank.parameters)["sight_y"]
    towards = np.array([-hoopgen.PAPER["board_distance"], sight]) - state[:2]
    across = towards[0] * state[4] - towards[1] * state[3]
    assert abs(across) < 1e-14 * np.hypot(*towards) * np.hypot(state[3], state[4])


@pytest.mark.slow
def test_a_side_place_banks_better_and_a_far_front_place_does_not() -> None:
    places = [(1.5, 2.6), (4.5, 0.0)]
    release = {"height": 2.1336, "backspin": 6 * np.pi}
    found = bank_or_direct(
        Scatter(release, SD), places, shots=3_000, over=("elevation", "aim", "azimuth")
    )
    side, front = found.difference.values
    assert side > 0.03
    assert front < 0.0
    assert (found.difference_low < found.difference).all()
    assert (found.difference < found.difference_high).all()
    # As `optimum` would find and count them, one place and one way at a time.
    place = {"distance": float(np.hypot(1.5, 2.6)), "angle": float(np.arctan2(2.6, 1.5))}
    alone = optimum(
        Scatter(release | place, SD),
        ["elevation", "aim", "azimuth"],
        by="bank",
        shots=3_000,
        margins=(),
    )
    chosen = found.sel(way="bank").isel(place=0)
    assert float(chosen.probability) == alone.probability
    assert float(chosen.speed) == alone.arguments["speed"]
    assert chosen.speed.attrs["units"] == "m/s"


@pytest.mark.slow
def test_the_range_of_an_aim_point_holds_nine_tenths_of_the_made_bank_shots() -> None:
    release, place = {"height": 2.1336, "backspin": 6 * np.pi}, (1.5, 2.6)
    found = bank_or_direct(Scatter(release, SD), [place], shots=3_000, seed=4).isel(place=0)
    bank = found.sel(way="bank")
    aimed = {name: float(bank[name]) for name in ("aim", "elevation", "azimuth")}
    aimed |= {"distance": float(np.hypot(*place)), "angle": float(np.arctan2(*place[::-1]))}
    # Fresh shots, of the next seed; two thousand are looked at.
    states = Scatter(release | aimed, SD).draw(0, 2_000, 5).states
    shots = hoopgen.simulate(states, record=True)
    touched = [
        shots.trajectory(shot).events["before"][0][1:3]
        for shot in np.flatnonzero(shots.made & (shots.first == BOARD)).tolist()
    ]
    for axis, name in enumerate("yz"):
        column = np.array(touched)[:, axis]
        low, high = (float(found[f"touch_{name}_{end}"]) for end in ("low", "high"))
        assert low < float(found[f"touch_{name}"]) < high
        assert np.mean((column >= low) & (column <= high)) == pytest.approx(
            0.9, abs=2 / len(touched)
        )
        assert np.mean(column < low) == pytest.approx(0.05, abs=1 / len(touched))


@pytest.mark.slow
def test_from_a_place_the_scene_may_be_given_in_the_release_too() -> None:
    release, changed = {"height": 2.1}, {"board_distance": 0.6, "restitution": 0.75}
    places, scene = [(1.0, 1.5)], hoopgen.PAPER | changed
    within = bank_or_direct(Scatter(release | changed, SD), places, shots=500)
    beside = bank_or_direct(Scatter(release, SD), places, scene, shots=500)
    assert np.isfinite(within.touch_y).all()
    assert within.identical(beside)


@pytest.mark.slow
def test_from_a_place_what_was_searched_of_the_scene_is_in_the_results() -> None:
    over = {"aim": (0.0, 1.0), "board_distance": (0.5, 0.7)}
    release = {"height": 2.1, "elevation": 0.93}
    found = bank_or_direct(Scatter(release, SD), [(2.5, 0.0)], over=over, shots=500)
    bank = found.sel(way="bank").isel(place=0)
    scene = hoopgen.PAPER | {"board_distance": float(bank.board_distance)}
    arguments = {name: float(bank[name]) for name in ARGUMENTS}
    assert float(found.touch_z[0]) == on_board(arguments, scene)["touch_z"]


@pytest.mark.slow
def test_invalid_shots_from_a_place_do_not_count() -> None:
    over = ("elevation", "aim")
    found = bank_or_direct(
        Scatter({"height": 2.1}, UNSTEADY), [(2.5, 1.0)], over=over, shots=1_000, seed=6
    )
    place = {"distance": float(np.hypot(2.5, 1.0)), "angle": float(np.arctan2(1, 2.5))}
    alone = optimum(
        Scatter({"height": 2.1} | place, UNSTEADY),
        over,
        by="direct",
        shots=1_000,
        seed=6,
        margins=(),
    )
    direct = found.sel(way="direct").isel(place=0)
    assert int(direct.invalid) == alone.invalid > 50
    ends = (float(direct[name]) for name in ("probability", "low", "high"))
    assert tuple(ends) == (alone.probability, alone.low, alone.high)


def test_a_place_without_a_way_in_is_said_to_have_none() -> None:
    found = bank_or_direct(
        Scatter({"height": 2.0}, SD), [(-1.0, 0.0)], shots=512, over=("elevation", "aim")
    )
    bank = found.sel(way="bank").isel(place=0)
    assert float(bank.probability) == 0.0
    assert np.isnan(float(bank.speed))
    assert np.isnan(float(found.touch_y[0]))
    assert np.isnan(float(found.touch_y_low[0]))


# On the command line

ASKED = [
    *["optimum", "--over", "elevation=48deg:58deg", "--over", "aim=-5cm:12cm", "--height", "7ft"],
    *["--distance", "13.75ft", "--backspin", "3Hz", "--scatter", "speed=0.07"],
    *["--scatter", "elevation=1.3deg", "--scatter", "azimuth=1deg", "--shots", "2000"],
]


@pytest.mark.slow
def test_the_command_says_what_the_library_found() -> None:
    result = succeed(*ASKED, "--json")
    bounds = {"elevation": (48 * DEGREE, 58 * DEGREE), "aim": (-0.05, 0.12)}
    release = {"height": 7 * 0.3048, "distance": 13.75 * 0.3048, "backspin": 3 * (2 * np.pi)}
    found = optimum(Scatter(release, SD), bounds, shots=2000)
    read = json.loads(result.stdout)
    assert read["release"] == in_units(found.release)
    assert read["flat"]["elevation_rad"] == list(found.flat["elevation"])
    assert read["margins"]["speed"]["unit"] == "m/s"
    assert read["entry_angle_rad"] == found.entry_angle
    assert read["probability"] == found.probability


@pytest.mark.slow
def test_the_command_speaks_to_a_coach() -> None:
    result = succeed(*ASKED, "--versus", "bank")
    for word in ("shoot", "straight at the ring", "comes down at", "past the centre", "versus"):
        assert word in result.stdout
    assert max(map(len, result.stdout.splitlines())) <= 120
    assert re.search(r"^\* .*, by another bounce: .*\d", result.stdout, re.MULTILINE)
    assert "elsewhere" not in result.stdout  # an attribute, which says nothing to a coach


@pytest.mark.parametrize(
    ("option", "message"),
    [
        (["--over", "elevaton"], "'elevaton' is none of"),
        (["--over", "elevation=45"], "elevation: '45' is not low:high"),
        (["--over", "elevation=45deg:60deg:3"], "is not low:high"),
        (["--over", "elevation=45deg:60m"], "not a unit of angle"),
        (["--by", "luck"], "luck"),
    ],
)
def test_the_command_refuses_what_it_cannot_read(option: list[str], message: str) -> None:
    result = run("optimum", *option)
    assert result.exit_code == 2
    assert message in result.stderr
