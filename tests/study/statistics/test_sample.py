"""Measured releases are a sample: results contain its uncertainty, and say which interval does."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.helpers.commands import run, succeed

for _library in ("matplotlib", "pyarrow", "pydantic", "scipy", "xarray"):
    pytest.importorskip(_library)

from scipy.stats import binom  # noqa: E402

import hoopgen  # noqa: E402
from hoopgen.plots.estimates import plot_estimate  # noqa: E402
from hoopgen.study.jobs.objective import Player  # noqa: E402
from hoopgen.study.models.requirements import scaled  # noqa: E402
from hoopgen.study.models.smoothed import smoothed  # noqa: E402
from hoopgen.study.questions.held_out import HeldOut, folds_of, variance_of_choice, with_choice  # noqa: E402
from hoopgen.study.questions.optimum_result import advice  # noqa: E402
from hoopgen.study.statistics.intervals import (  # noqa: E402
    grouped_difference,
    grouped_wilson,
    newcombe_interval,
    quantile_ranks,
    widened,
    wilson_interval,
)
from hoopgen.study.statistics.sample import SampleInterval  # noqa: E402
from hoopgen.studyfile import run_study  # noqa: E402

pytestmark = pytest.mark.xdist_group("sample")  # the search is made once

DEGREE = np.pi / 180
HERE = {"backspin": 6 * np.pi, "height": 2.1336, "distance": 4.191}
AT = {"speed": 7.17, "elevation": 52 * DEGREE, "azimuth": 0.0}
SD = {"speed": 0.07, "elevation": 1.3 * DEGREE, "azimuth": 1.0 * DEGREE}
DRAWN = hoopgen.Scatter({**HERE, **AT}, SD).draw(0, 200, seed=5)
ROWS = {name: np.asarray(DRAWN.columns[name]) for name in AT}
MEASURED = hoopgen.Resample({**ROWS, **HERE})
GAMES = [f"game {number // 10}" for number in range(200)]
GROUPED = hoopgen.Resample({**ROWS, **HERE}, GAMES)


@pytest.fixture(scope="module")
def best() -> Any:
    return hoopgen.optimum(MEASURED, ["elevation", "aim"], shots=4_000, margins=())


# The best release of a sample


@pytest.mark.slow
def test_the_best_release_of_a_sample_is_not_better_than_the_truth_allows(best: Any) -> None:
    # How often the player makes it whose 200 throws these were, the mean moved as far.
    moved = {n: best.arguments[n] + AT[n] - MEASURED.centre[n] for n in AT}
    truth = Player(hoopgen.Scatter({}, SD)).sampled({**moved, **HERE}, 200_000, 9).share[0]
    assert best.low < truth < best.high
    # 200 rows leave more open than six points to each side.
    assert best.high - best.low > 0.12


@pytest.mark.slow
def test_the_flat_range_of_a_sample_is_about_the_true_one(best: Any) -> None:
    player = hoopgen.Scatter(HERE, SD)
    known = hoopgen.optimum(player, ["elevation", "aim"], shots=20_000, margins=())
    for name in ("elevation", "aim"):
        widths = [one.flat[name][1] - one.flat[name][0] for one in (best, known)]
        assert 0.5 < widths[0] / widths[1] < 2.0


@pytest.mark.slow
def test_each_row_is_judged_by_a_release_found_without_it(best: Any) -> None:
    fold = folds_of(MEASURED, best.seed)
    assert len(best.folds) == 5
    assert np.bincount(fold).tolist() == [40] * 5
    made = 0
    for number, point in enumerate(best.folds):
        others = MEASURED.each(np.flatnonzero(fold != number)).centre
        rows = MEASURED.each(np.flatnonzero(fold == number), others)
        made += int(Player(rows).sampled({**point}, 200).made[0])
    assert (best.made, best.shots, best.probability) == (made, 200, made / 200)
    # The releases of the folds are not the one that is given: the interval is wider than the rows'.
    low, high = map(float, wilson_interval(made, 200, 0.95))
    assert best.low < low
    assert high < best.high


def thrown_alike(one: Any, fold: Any) -> Any:
    """Return the shares of the same shots, with the releases of the folds and that of all rows."""
    rows, shares = smoothed(MEASURED, one.seed), []
    for number, point in enumerate((*one.folds, {name: one.release[name] for name in one.bounds})):
        others = MEASURED.each(np.flatnonzero(fold != number))  # of the last release all
        thrower = Player(replace(rows, about=others.centre), by=one.by)
        shares.append(thrower.sampled(point, 4_000, one.seed + 1).share[0])
    return np.array(shares)


@pytest.mark.slow
def test_the_interval_contains_that_the_releases_of_the_folds_differ(best: Any) -> None:
    shares = thrown_alike(best, folds_of(MEASURED, best.seed))
    # The mean of five draws beside one more.
    variance = shares.var(ddof=1) * 6 / 5
    ends = tuple(map(float, wilson_interval(best.made, 200, 0.95)))
    wanted = widened(best.probability, ends, math.inf, variance, 5, 0.95, 0.0)
    assert (best.low, best.high) == pytest.approx(wanted, abs=1e-12)


@pytest.mark.parametrize("groups", [None, 20])
def test_releases_that_are_equally_good_leave_the_interval_as_it_was(groups: int | None) -> None:
    found = SampleInterval(0.7, 0.6, 0.78, 200, groups)
    assert with_choice(found, np.full(6, 0.7), 0.95) == found


def test_the_factor_is_that_of_one_more_draw_beside_a_mean() -> None:
    # Draws whose own part alone differs: how far the last is from the mean of the others.
    random = np.random.default_rng(4)
    draws = random.normal(0.6, 0.03, (20_000, 1)) + random.normal(0.0, 0.02, (20_000, 6))
    off = draws[:, -1] - draws[:, :-1].mean(axis=1)
    claimed = np.mean([variance_of_choice(one) for one in draws])
    assert np.mean(off**2) == pytest.approx(claimed, rel=0.03)


def test_the_interval_of_a_sum_of_two_errors_contains_it_as_often_as_it_says() -> None:
    # The second error's deviation is as large as the first's, and known from six draws of it.
    random, inside = np.random.default_rng(5), 0
    for _ in range(4_000):
        made, draws = random.binomial(200, 0.7), random.normal(0.0, 0.03, 7)
        ends = tuple(map(float, wilson_interval(made, 200, 0.95)))
        variance = float(draws[1:].var(ddof=1))
        low, high = widened(made / 200, ends, math.inf, variance, 5, 0.95, 0.0)
        inside += bool(low <= 0.7 + draws[0] <= high)
    assert 0.94 < inside / 4_000 < 0.965


def test_a_widened_interval_stays_within_what_there_is() -> None:
    assert widened(0.99, (0.9, 0.999), 19, 0.04, 5, 0.95, 0.0)[1] == 1.0
    assert widened(0.02, (0.0, 0.1), 19, 0.04, 5, 0.95, 0.0)[0] == 0.0
    assert widened(-0.9, (-0.99, -0.7), 19, 0.2, 5, 0.95, -1.0)[0] == -1.0
    assert widened(math.nan, (0.0, 1.0), 19, 0.04, 5, 0.95, 0.0) == (0.0, 1.0)


@pytest.mark.slow
def test_the_same_seed_gives_the_same_optimum_of_a_sample(best: Any) -> None:
    again = hoopgen.optimum(MEASURED, ["elevation", "aim"], shots=4_000, margins=(), threads=1)
    assert again == best
    assert json.dumps(again.as_dict()) == json.dumps(best.as_dict())


def test_groups_are_held_out_whole_and_widen_the_interval() -> None:
    fold = folds_of(GROUPED, 3)
    assert all(len(set(fold[start : start + 10])) == 1 for start in range(0, 200, 10))
    assert sorted(np.bincount(fold).tolist()) == [40] * 5
    # Five games, in each of which all throws are made or all are missed.
    made = np.repeat([True, True, True, False, True], 40)
    low, high = grouped_wilson([40, 40, 40, 0, 40], [40] * 5, 0.95)
    assert high - low > 3 * (
        wilson_interval(made.sum(), 200, 0.95)[1] - wilson_interval(made.sum(), 200, 0.95)[0]
    )


@pytest.mark.slow
def test_the_lead_of_one_way_is_of_held_out_rows() -> None:
    options: dict[str, Any] = {"shots": 1_000, "margins": ()}
    direct, bank = (
        hoopgen.optimum(MEASURED, ["aim"], by=by, **options) for by in ("direct", "bank")
    )
    lead, low, high = direct.lead(bank)
    assert lead == pytest.approx(direct.probability - bank.probability, abs=1e-15)
    assert low < lead < high
    assert high - low > 0.05
    assert "of the sample" in advice(direct, bank)
    fold = folds_of(MEASURED, 0)
    rows = [
        HeldOut(tuple(one.folds), fold).scored(MEASURED, Player(MEASURED, by=one.by), {}).made
        for one in (direct, bank)
    ]
    pairs = [int((a & b).sum()) for a in (rows[0], ~rows[0]) for b in (rows[1], ~rows[1])]
    alone = newcombe_interval(*pairs, 0.95)  # type: ignore[call-arg]
    apart = thrown_alike(direct, fold) - thrown_alike(bank, fold)
    wanted = widened(lead, alone, math.inf, apart.var(ddof=1) * 6 / 5, 5, 0.95, -1.0)
    assert (low, high) == pytest.approx(wanted, abs=1e-12)
    assert low < alone[0]
    assert alone[1] < high


def test_too_few_rows_to_hold_some_out_are_refused() -> None:
    one = hoopgen.Resample({name: column[:1] for name, column in ROWS.items()} | HERE)
    with pytest.raises(ValueError, match="takes two rows at the least; this has one row"):
        hoopgen.optimum(one, ["aim"], shots=100)
    whole = hoopgen.Resample({**ROWS, **HERE}, ["a"] * 200)
    with pytest.raises(ValueError, match="takes two groups at the least; this has one group"):
        hoopgen.bank_or_direct(whole, [(2.0, 1.0)], shots=100)


@pytest.mark.slow
def test_bank_or_direct_of_a_sample_has_its_interval() -> None:
    found = hoopgen.bank_or_direct(MEASURED, [(2.7, 0.0)], over=["aim"], shots=1_000)
    widths = (found["high"] - found["low"]).values
    assert (widths > 0.08).all()
    assert (found["difference_high"] - found["difference_low"]).item() > 0.05
    assert found.attrs["interval"].startswith("contains the uncertainty of the sample")
    # The lead is that of the two optima, from there.
    there = {**HERE, "distance": 2.7}
    moved = hoopgen.Resample({**ROWS, **there})
    one, other = (
        hoopgen.optimum(moved, ["aim"], by=by, shots=1_000, margins=()) for by in ("bank", "direct")
    )
    lead = [found[f"difference{end}"].item() for end in ("", "_low", "_high")]
    assert lead == pytest.approx(one.lead(other), abs=1e-12)
    for best, way in ((one, "bank"), (other, "direct")):
        ends = [found.sel(way=way)[end].item() for end in ("low", "high")]
        assert ends == pytest.approx([best.low, best.high], abs=1e-12)


def test_smoothed_rows_keep_means_and_deviations() -> None:
    columns = smoothed(MEASURED, 3).noise(0, 4_000, seed=3)
    for name, column in ROWS.items():
        # Twenty times each row: means are off by the noise's, a hundredth of the deviation or two.
        assert abs(columns[name].mean() - column.mean()) < 0.05 * column.std()
        assert columns[name].std() == pytest.approx(column.std(), rel=0.05)
    assert columns["height"] == HERE["height"]


# Both intervals, named


def test_an_estimate_of_a_sample_says_both_intervals() -> None:
    found = hoopgen.estimate(MEASURED, shots=20_000)
    rows = hoopgen.simulate(MEASURED.each().draw(0, 200).states)
    made = int(rows.made.sum())
    assert found.sample is not None
    assert found.sample.value == made / 200
    assert (found.sample.low, found.sample.high) == tuple(
        map(float, wilson_interval(made, 200, 0.95))
    )
    assert found.high - found.low < 0.02 < 0.1 < found.sample.high - found.sample.low
    text = str(found).splitlines()
    assert text[0].endswith("(Wilson's 95% interval of the simulation alone)")
    assert text[1].startswith("sample   ")
    assert text[1].endswith("(95% interval of the sample, 200 measured releases)")
    told = found.as_dict()["sample"]
    assert told == {
        "value": made / 200,
        "low": found.sample.low,
        "high": found.sample.high,
        "rows": 200,
        "groups": None,
    }
    assert found.to_pandas()["sample_low"].item() == found.sample.low
    said = " ".join(one.get_text() for one in plot_estimate(found).texts).replace("\n", " ")
    assert "of the simulation alone; the sample's of those made is" in said


def test_more_shots_do_not_narrow_the_interval_of_a_sample() -> None:
    few, many = (hoopgen.estimate(MEASURED, shots=shots).sample for shots in (10, 20_000))
    assert few == many


def test_a_scatter_has_no_sample() -> None:
    found = hoopgen.estimate(hoopgen.Scatter({**HERE, **AT}, SD), shots=1_000)
    assert found.sample is None
    assert "sample" not in found.as_dict()
    assert "sample" not in str(found)


def test_quantiles_and_sectors_of_a_sample_have_its_interval() -> None:
    found = hoopgen.estimate(MEASURED, shots=20_000, measures=["depth", "rebound_angle"])
    spread = found.measured["depth"]
    _, low, high = spread.quantiles[0.5]
    ends = spread.sample[0.5]
    assert ends[0] < low < high < ends[1]
    releases = MEASURED.each().draw(0, 200)
    shots = hoopgen.simulate(releases.states)
    values = np.sort(hoopgen.measure(releases.states, shots, names=["depth"])["depth"])
    first, last = quantile_ranks(0.5, 200, 0.95)
    assert ends == (values[first - 1], values[last - 1])
    turned = found.measured["rebound_angle"]
    for name, (_, low, high) in turned.shares.items():
        assert turned.sample[name][1] - turned.sample[name][0] > high - low
    assert set(spread.as_dict()["sample"]) == {"0.05", "0.25", "0.5", "0.75", "0.95"}
    assert "median, 95% of the sample" in str(found)


def test_a_comparison_pairs_the_rows_of_a_sample() -> None:
    deader = hoopgen.PAPER | {"restitution": 0.6}
    found = hoopgen.compare(MEASURED, (MEASURED, deader), shots=5_000)
    shots = [
        hoopgen.simulate(MEASURED.each().draw(0, 200).states, scene).made
        for scene in (hoopgen.PAPER, deader)
    ]
    pairs = [int((a & b).sum()) for a in (shots[1], ~shots[1]) for b in (shots[0], ~shots[0])]
    assert found.sample is not None
    assert (found.sample.low, found.sample.high) == newcombe_interval(*pairs, 0.95)  # type: ignore[call-arg]
    assert found.sample.high - found.sample.low > 3 * (found.high - found.low)
    assert "of the simulation alone)" in str(found)
    assert found.as_dict()["sample"]["rows"] == 200
    # Of other rows nothing pairs, which leaves more open.
    fewer = hoopgen.Resample({name: column[:199] for name, column in ROWS.items()} | HERE)
    apart = hoopgen.compare(MEASURED, (fewer, deader), shots=1_000).sample
    assert apart is not None
    assert apart.rows == 399
    assert apart.high - apart.low > 2 * (found.sample.high - found.sample.low)


def test_groups_of_one_row_are_rows() -> None:
    made = np.arange(100) % 3 > 0
    low, high = grouped_wilson(made, np.ones(100), 0.95)
    # Student's t of 99 degrees and one trial fewer: wider by less than two hundredths.
    ends = wilson_interval(made.sum(), 100, 0.95)
    assert 1.0 < (high - low) / (ends[1] - ends[0]) < 1.02
    difference = grouped_difference(made, ~made, np.ones(100), 0.95)
    assert difference[0] < made.mean() - (~made).mean() < difference[1]


def test_ranks_of_a_quantile_cover_it_at_least_as_often_as_is_claimed() -> None:
    for trials in (5, 30, 200, 5_000):
        for level in (0.05, 0.25, 0.5, 0.95):
            low, high = quantile_ranks(level, trials, 0.95)
            covered = binom.cdf(high - 1, trials, level) - binom.cdf(low - 1, trials, level)
            assert covered >= 0.95
            # One rank fewer at an end would leave too much outside of it.
            assert binom.cdf(low, trials, level) > 0.025
    assert quantile_ranks(0.05, 30, 0.95)[0] == 0


def test_a_quantile_that_so_few_shots_do_not_bound_is_open() -> None:
    # Of ten shots the smallest may well be above a twentieth of all.
    found = hoopgen.estimate(MEASURED, shots=10, measures=["depth"]).measured["depth"]
    assert found.quantiles[0.05][1] == -math.inf
    assert math.isfinite(found.quantiles[0.5][1])


# Groups


def test_groups_have_labels_that_every_row_has() -> None:
    assert (GROUPED.groups, MEASURED.groups) == (20, None)
    assert GROUPED != MEASURED
    assert hoopgen.Resample({**ROWS, **HERE}, np.arange(200) // 10) == GROUPED
    assert scaled(GROUPED, 2.0).groups == 20  # type: ignore[union-attr]
    with pytest.raises(ValueError, match="group: expected a label for each of 200 rows, got 3"):
        hoopgen.Resample({**ROWS, **HERE}, ["a", "b", "c"])
    for missing in (None, math.nan, ""):
        with pytest.raises(ValueError, match="group: row 8 of 200 has no label"):
            hoopgen.Resample({**ROWS, **HERE}, [*GAMES[:7], missing, *GAMES[8:]])


def test_throws_of_a_game_that_are_alike_widen_the_interval() -> None:
    day = np.repeat(np.random.default_rng(1).normal(0.0, 0.1, 20), 10)
    columns = {**ROWS, "speed": ROWS["speed"] + day, **HERE}
    alone = hoopgen.estimate(hoopgen.Resample(columns), shots=100).sample
    games = hoopgen.estimate(hoopgen.Resample(columns, GAMES), shots=100)
    assert alone is not None
    assert games.sample is not None
    assert games.sample.groups == 20
    assert games.sample.high - games.sample.low > 1.2 * (alone.high - alone.low)
    assert "200 measured releases in 20 groups" in str(games)


def test_rows_that_are_invalid_are_not_counted_as_measured_releases() -> None:
    speed = ROWS["speed"].copy()
    speed[[3, *range(50, 60)]] = np.nan  # one of the first game, and all of the sixth
    games = hoopgen.Resample({**ROWS, "speed": speed, **HERE}, GAMES)
    sample = hoopgen.estimate(games, shots=100).sample
    assert sample is not None
    assert (sample.rows, sample.groups) == (189, 19)
    sample = hoopgen.compare(games, (games, hoopgen.NBA), shots=100).sample
    assert sample is not None
    assert (sample.rows, sample.groups) == (189, 19)
    sample = hoopgen.compare(games, (MEASURED, hoopgen.NBA), shots=100).sample  # of no groups
    assert sample is not None
    assert (sample.rows, sample.groups) == (389, None)


@pytest.fixture
def table(tmp_path: Path) -> Path:
    file = tmp_path / "throws.csv"
    rows = zip(
        ROWS["speed"], ROWS["elevation"] / DEGREE, ROWS["azimuth"] / DEGREE, GAMES, strict=True
    )
    lines = [f"{speed:.17g},{angle:.17g},{aside:.17g},{game}" for speed, angle, aside, game in rows]
    file.write_text("\n".join(["speed,elevation_deg,azimuth_deg,game", *lines]) + "\n")
    return file


PLACE = ["--backspin", "3Hz", "--height", "7ft", "--distance", "13.75ft"]


def test_the_command_line_reads_groups_from_a_column(table: Path) -> None:
    found = succeed(
        "estimate", "--from", str(table), "--group", "game", *PLACE, "--shots", "500", "--json"
    )
    told = json.loads(found.stdout)["sample"]
    assert (told["rows"], told["groups"]) == (200, 20)
    wrong = run("estimate", "--from", str(table), "--group", "day", *PLACE)
    assert wrong.exit_code != 0
    assert "there is no column 'day' of groups" in wrong.output
    alone = run("estimate", "--group", "game", "--speed", "7", "--elevation", "52deg", *PLACE)
    assert alone.exit_code == 2
    assert "--group: it is a column of --from" in alone.output


@pytest.mark.slow
def test_a_study_file_says_both_intervals_and_reads_groups(table: Path, tmp_path: Path) -> None:
    (tmp_path / "study.toml").write_text(
        """
[study]
name = "A sample"
formats = ["svg"]
[release]
height = "7 ft"
distance = "13.75 ft"
backspin = "3 Hz"
[releases]
file = "throws.csv"
group = "game"
[[question]]
kind = "estimate"
name = "made"
shots = 500
[[question]]
kind = "map"
name = "restitution"
shots = 50
over.restitution = [0.6, 0.7]
[[question]]
kind = "optimum"
name = "best"
shots = 500
over = ["aim"]
margins = []
"""
    )
    out = run_study(tmp_path / "study.toml", report=tmp_path / "page.html")
    folder = tmp_path / "study-results"
    assert out is not None
    answer = json.loads((folder / "made" / "answer.json").read_text(encoding="utf-8"))
    assert "of the simulation alone" in (folder / "report.md").read_text(encoding="utf-8")
    assert "of the sample" in (tmp_path / "page.html").read_text(encoding="utf-8")
    assert "20" in json.dumps(answer)
    assert "uncertainty of the sample" in (folder / "report.md").read_text(encoding="utf-8")


def test_a_study_file_names_a_column_of_groups_that_is_not_there(
    table: Path, tmp_path: Path
) -> None:
    (tmp_path / "study.toml").write_text(
        """
[study]
name = "A sample"
[release]
height = "7 ft"
distance = "13.75 ft"
backspin = "3 Hz"
[releases]
file = "throws.csv"
group = "day"
[[question]]
kind = "estimate"
name = "made"
shots = 500
"""
    )
    with pytest.raises(ValueError, match="there is no column 'day' of groups"):
        run_study(tmp_path / "study.toml")


def test_a_map_of_a_sample_says_what_its_intervals_are() -> None:
    found = hoopgen.map(MEASURED, {"restitution": [0.6, 0.7]}, shots=100)
    assert found.attrs["interval"].startswith("of the simulation alone")
    assert found["low"].attrs["long_name"].endswith("of the simulation alone")
    scatter = hoopgen.Scatter({**HERE, **AT}, SD)
    assert "interval" not in hoopgen.map(scatter, {"restitution": [0.6]}, shots=100).attrs


def test_a_solution_of_a_sample_says_what_its_intervals_are() -> None:
    text = str(hoopgen.solve(MEASURED, 0.6, shots=500))
    assert "for 60% made (95% interval of the simulation alone)" in text
    assert "\nsample   " in text


# In few words


def test_a_sample_is_represented_in_a_line() -> None:
    shown = repr(GROUPED)
    assert shown == (
        "Resample(200 rows of speed, elevation, azimuth; backspin 18.8496, height 2.1336, "
        "distance 4.191; 20 groups)"
    )
    grid = hoopgen.Grid({"speed": np.linspace(7, 8, 500)}, {**HERE, "elevation": 0.9})
    assert repr(grid).startswith("Grid(500 speed; backspin 18.8496, height")
    assert len(repr(grid)) < 100


def test_without_scatter_there_is_no_interval() -> None:
    model = hoopgen.Scatter({**HERE, **AT})
    found = hoopgen.estimate(model, shots=100)
    assert str(found).startswith("made     100.0% (no scatter: every throw is the same)\n")
    assert found.low == found.probability == found.high == 1.0
    drawn = " ".join(one.get_text() for one in plot_estimate(found).texts).replace("\n", " ")
    assert "100 shots; no scatter: every throw is the same." in drawn
    both = hoopgen.compare(model, (model, hoopgen.NBA), shots=10)
    assert (both.low, both.high) == (0.0, 0.0)
    assert "+0.0 points (no scatter: every throw is the same)" in str(both)
    zero = hoopgen.Scatter({**HERE, **AT}, {"speed": 0.0})
    cell = hoopgen.map(zero, {"restitution": [0.7]}, shots=10).isel(restitution=0)
    assert cell["low"].item() == cell["probability"].item() == cell["high"].item()


@pytest.mark.parametrize("name", ["elevation", "azimuth"])
def test_a_deviation_in_degrees_is_refused(name: str) -> None:
    with pytest.raises(ValueError, match=rf"sd: {name} is in radians, .*np\.radians\(1\.3\)"):
        hoopgen.Scatter({}, {name: 1.3})
    hoopgen.Scatter({}, {name: 0.49})
    with pytest.raises(ValueError, match=rf"sd: {name} is in radians"):
        hoopgen.Scatter({}, {name: 0.5})
    # The place around the ring may be anywhere.
    hoopgen.Scatter({}, {"angle": 1.3})


# What an optimum says of itself


@pytest.mark.slow
def test_an_optimum_says_in_which_ways_it_goes_in() -> None:
    player = hoopgen.Scatter(HERE | {"distance": 2.7, "angle": 50 * DEGREE}, SD)
    bank = hoopgen.optimum(player, ["elevation", "aim", "azimuth"], shots=1_000, margins=["height"])
    assert bank.is_bank
    assert sum(bank.ways.values()) == pytest.approx(bank.probability, abs=1e-12)
    thrown = hoopgen.estimate(hoopgen.Scatter(bank.release, SD), shots=1_000, seed=1)
    made = thrown.kinds_made
    assert bank.ways == {
        "swish": made["swish"] / 1_000,
        "rim": (made["rim"] + made["rim_board"]) / 1_000,
        "bank": (made["bank"] + made["bank_rim"]) / 1_000,
    }
    lines = str(bank).splitlines()
    assert ", off the board, " in lines[0]
    assert "touches the board" in lines[1]
    assert lines[3].startswith("ways     ")
    # The height was given, not searched: it is not called the best.
    assert "best" not in next(line for line in lines if line.startswith("one of them off"))
    assert bank.as_dict()["ways"]["bank"] > 0.3


@pytest.mark.slow
def test_advice_compares_like_with_like() -> None:
    options: dict[str, Any] = {"shots": 500, "margins": ()}
    here = hoopgen.optimum(hoopgen.Scatter(HERE, SD), ["elevation", "aim"], **options)
    higher = hoopgen.Scatter(HERE | {"height": 2.4}, SD)
    other = hoopgen.optimum(higher, ["elevation", "aim"], **options)
    with pytest.raises(ValueError, match="rival: expected an optimum of the same release"):
        advice(here, other)
    deader = hoopgen.PAPER | {"restitution": 0.6}
    other = hoopgen.optimum(hoopgen.Scatter(HERE, SD), ["elevation", "aim"], deader, **options)
    with pytest.raises(ValueError, match=r"rival: expected one in the same scene.*restitution"):
        advice(here, other)
