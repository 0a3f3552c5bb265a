"""`estimate` and `compare`: what is counted, how sure it is, and that it can be had again."""

from __future__ import annotations

import json
import math
import pickle
import re
import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.stats import binomtest

import hoopgen
from hoopgen import Outcome, Scatter, compare, estimate
from hoopgen.cli import main
from hoopgen.core.variables import Releases
from hoopgen.hoop.kinds import Kind, hoop_outcomes, kinds
from hoopgen.hoop.variables import change_variables
from hoopgen.study.jobs import monte_carlo
from hoopgen.study.named_units import in_units
from hoopgen.study.questions.compare import Comparison
from hoopgen.study.questions.estimate_result import Estimate
from hoopgen.study.statistics.intervals import newcombe_interval, wilson_interval
from hoopgen.study.statistics.tally import Tally
from tests.helpers import ROOT, contents
from tests.helpers.commands import failure, output, run, succeed

DEGREE = math.pi / 180
MEAN = {"speed": 7.17, "elevation": 52 * DEGREE, "height": 2.1336, "distance": 4.191}
REST = {name: value for name, value in MEAN.items() if name != "speed"}
SD = {"speed": 0.07, "elevation": 1.3 * DEGREE, "azimuth": DEGREE}
PLAYER = Scatter(MEAN | {"backspin": 6 * math.pi}, SD)
SCENE = hoopgen.NBA | {"restitution": 0.75}


@pytest.fixture(autouse=True)
def small_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    """Many chunks of few blocks, so that few shots go through all of it."""
    monkeypatch.setattr(monte_carlo, "CHUNK", 1000)
    monkeypatch.setattr("hoopgen.study.statistics.tally.BLOCK", 300)


# Intervals


@pytest.mark.parametrize("confidence", [0.5, 0.9, 0.95, 0.999])
@pytest.mark.parametrize(
    ("made", "shots"),
    [(0, 1), (1, 1), (0, 10), (10, 10), (3, 10), (660, 1000), (1, 10**9), (10**9 - 1, 10**9)],
)
def test_wilson_is_scipy_s(made: int, shots: int, confidence: float) -> None:
    wanted = binomtest(made, shots).proportion_ci(confidence, method="wilson")
    low, high = wilson_interval(made, shots, confidence)
    # Near 0 and 1 both lose half the digits in a difference.
    np.testing.assert_allclose([low, high], [wanted.low, wanted.high], rtol=1e-12, atol=1e-15)
    assert 0 <= low <= made / shots <= high <= 1


def test_of_no_shots_nothing_is_known() -> None:
    assert [float(end) for end in wilson_interval(0, 0, 0.95)] == [0.0, 1.0]
    assert newcombe_interval(0, 0, 0, 0, 0.95) == (-1.0, 1.0)


@pytest.mark.parametrize(
    ("pairs", "interval"),
    [
        # Fagerland, Lydersen and Laake (2017), Statistical Analysis of Contingency Tables,
        # chapter 8: Cavo et al. (2012), to four digits; Bentur et al. (2009), to three.
        ((59, 6, 16, 80), (-0.1186, -0.0046)),
        ((1, 1, 7, 12), (-0.507, -0.026)),
    ],
)
def test_newcombe_gives_the_published_numbers(
    pairs: tuple[int, int, int, int], interval: tuple[float, float]
) -> None:
    digits = 4 if sum(pairs) > 100 else 3
    assert tuple(round(end, digits) for end in newcombe_interval(*pairs, 0.95)) == interval


def test_newcombe_changes_its_sign_with_the_order() -> None:
    low, high = newcombe_interval(40, 7, 3, 50, 0.9)
    assert newcombe_interval(40, 3, 7, 50, 0.9) == pytest.approx((-high, -low), rel=1e-14)


@pytest.mark.parametrize("pairs", [(5, 0, 0, 0), (0, 0, 0, 5), (0, 5, 0, 0), (3, 0, 0, 4)])
def test_newcombe_stands_where_nothing_varies(pairs: tuple[int, int, int, int]) -> None:
    both, first, second, _ = pairs
    low, high = newcombe_interval(*pairs, 0.95)
    assert -1 <= low <= (first - second) / sum(pairs) <= high <= 1
    assert both or first or low < 0 < high


@pytest.mark.parametrize(
    "chances", [(0.6, 0.05, 0.03, 0.32), (0.9, 0.004, 0.006, 0.09), (0.25, 0.25, 0.25, 0.25)]
)
def test_newcombe_covers_the_difference_as_often_as_it_says(
    chances: tuple[float, float, float, float],
) -> None:
    """Newcombe (1998) found coverage of 95 % intervals from 93 % to 99 %."""
    random = np.random.default_rng(12)
    true = chances[1] - chances[2]
    drawn = random.multinomial(1000, chances, size=2000)
    ends = np.array([newcombe_interval(*pairs, 0.95) for pairs in drawn.tolist()])
    covered = np.mean((ends[:, 0] <= true) & (true <= ends[:, 1]))
    assert 0.93 < covered < 0.99


def test_huge_numbers_of_pairs_do_not_overflow() -> None:
    low, high = newcombe_interval(6 * 10**11, 2 * 10**10, 10**10, 3 * 10**11, 0.95)
    n = 6 * 10**11 + 2 * 10**10 + 10**10 + 3 * 10**11
    difference = 10**10 / n
    # What Wald's interval tends to: z √((b + c)/n - d²) / √n.
    half = 1.959963984540054 * math.sqrt((3 * 10**10 / n - difference**2) / n)
    assert (low, high) == pytest.approx((difference - half, difference + half), rel=1e-6)


# What is counted


def everything(shots: int, parameters: Mapping[str, Any] = SCENE, seed: int = 0) -> hoopgen.Shots:
    releases = PLAYER.draw(0, shots, seed, parameters)
    return hoopgen.simulate(releases.states, releases.parameters)


def test_an_estimate_counts_what_simulate_gives() -> None:
    found, shots = estimate(PLAYER, SCENE, shots=3300, seed=4), everything(3300, seed=4)
    kind = kinds(shots.outcome, shots.counts, shots.first)
    made = shots.outcome == Outcome.MADE
    for outcome in hoop_outcomes(False):
        assert getattr(found, outcome.name.lower()) == np.sum(shots.outcome == outcome)
    assert found.shots == 3300
    assert found.uncertain == np.sum(shots.uncertain)
    assert list(found.kinds.values()) == [np.sum(kind == one) for one in Kind]
    assert list(found.kinds_made.values()) == [np.sum(made & (kind == one)) for one in Kind]
    assert list(found.kinds) == list(found.kinds_made) == [one.name.lower() for one in Kind]
    assert found.probability == found.made / 3300
    interval = binomtest(found.made, 3300).proportion_ci(method="wilson")
    assert (found.low, found.high) == pytest.approx((interval.low, interval.high), rel=1e-12)
    assert sum(found.shares.values()) == pytest.approx(1, rel=1e-15)


def test_capped_shots_are_trials_that_bound_the_probability() -> None:
    capped = estimate(PLAYER, SCENE, shots=2000, max_contacts=1)
    assert capped.capped > 400
    assert capped.probability == capped.made / 2000
    assert capped.with_capped == (capped.made + capped.capped) / 2000
    decided = estimate(PLAYER, SCENE, shots=2000)
    assert capped.probability < decided.probability < decided.with_capped < capped.with_capped


def test_invalid_shots_are_no_trials() -> None:
    """A restitution that scatters above 1 cannot be simulated."""
    wild = Scatter(PLAYER.release, {**SD, "restitution": 0.3})
    found = estimate(wild, SCENE, shots=2000)
    releases = wild.draw(0, 2000, 0, SCENE)
    invalid = ~(
        (releases.parameters["restitution"] >= 0) & (releases.parameters["restitution"] <= 1)
    )
    assert found.invalid == np.sum(invalid) > 300
    assert found.probability == found.made / (2000 - found.invalid)
    assert found.kinds["none"] == found.invalid + found.short


def test_where_all_are_invalid_there_is_no_probability() -> None:
    found = estimate(Scatter({"entry": -0.1, "height": 2.1, "distance": 4.2}), shots=10)
    assert math.isnan(found.probability)
    assert math.isnan(found.with_capped)
    assert (found.low, found.high) == (0.0, 1.0)
    assert found.as_dict()["probability"] is None
    assert "made     unknown" in str(found)


def test_a_readme_s_player_makes_two_of_three() -> None:
    """Against independent random numbers: five standard errors of the difference."""
    random, n = np.random.default_rng(2024), 20_000
    states = hoopgen.release(
        random.normal(7.17, 0.07, n),
        random.normal(52 * DEGREE, 1.3 * DEGREE, n),
        random.normal(0, DEGREE, n),
        6 * math.pi,
        height=2.1336,
        distance=4.191,
    )
    plain = np.mean(hoopgen.simulate(states, SCENE).outcome == Outcome.MADE)
    found = estimate(PLAYER, SCENE, shots=n)
    assert abs(found.probability - plain) < 5 * math.sqrt(2 * 0.66 * 0.34 / n)


def test_a_model_may_be_one_s_own() -> None:
    class Same:
        def draw(self, start: int, stop: int, seed: int = 0, parameters: Any = None) -> Releases:
            state = hoopgen.release(7.17, 0.89, height=2.13, distance=4.19)
            return Releases(np.tile(state, (stop - start, 1)), parameters, {})

        def identity(self) -> dict[str, Any]:
            return {"model": "same"}

    found = estimate(Same(), shots=1234)
    assert (found.made, found.probability) == (1234, 1.0)
    assert found.setting == {"model": "same", "parameters": dict(hoopgen.PAPER)}


# The same result


@pytest.mark.slow
@pytest.mark.parametrize("threads", [1, 2, 3])
@pytest.mark.parametrize("backend", ["auto", "numpy"])
def test_threads_and_backends_change_nothing(threads: int, backend: Any) -> None:
    wanted = estimate(PLAYER, SCENE, shots=2500, seed=1, threads=1)
    assert estimate(PLAYER, SCENE, shots=2500, seed=1, threads=threads, backend=backend) == wanted


def test_a_chunk_may_be_computed_by_another_process() -> None:
    work = monte_carlo.MonteCarloJob(
        (monte_carlo.setting_of(PLAYER, SCENE),) * 2, 2500, 3, 40, "auto"
    )
    there = pickle.loads(pickle.dumps(work))
    assert there.compute(2).equals(work.compute(2))
    assert there.identity() == work.identity() == json.loads(json.dumps(work.identity()))


def test_chunks_and_blocks_change_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    wanted = estimate(PLAYER, SCENE, shots=2500)
    monkeypatch.setattr(monte_carlo, "CHUNK", 777)
    monkeypatch.setattr("hoopgen.study.statistics.tally.BLOCK", 64)
    assert estimate(PLAYER, SCENE, shots=2500) == wanted


def test_seeds_draw_others() -> None:
    assert estimate(PLAYER, shots=2000, seed=1) != estimate(PLAYER, shots=2000, seed=2)


def test_a_folder_keeps_chunks_and_is_gone_on_from(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    wanted = estimate(PLAYER, SCENE, shots=2500)
    assert estimate(PLAYER, SCENE, shots=2500, folder=tmp_path) == wanted
    (lost,) = tmp_path.glob("chunk-*1.arrow")
    lost.unlink()
    asked = []
    compute = monte_carlo.MonteCarloJob.compute
    monkeypatch.setattr(
        monte_carlo.MonteCarloJob,
        "compute",
        lambda work, chunk: (asked.append(chunk), compute(work, chunk))[1],
    )
    assert estimate(PLAYER, SCENE, shots=2500, folder=tmp_path) == wanted
    assert asked == [1]


@pytest.mark.parametrize(
    "change",
    [
        {"seed": 1},
        {"max_contacts": 39},
        {"parameters": hoopgen.NBA},
        {"model": Scatter(PLAYER.release, SD | {"speed": 0.08})},
    ],
)
def test_a_folder_of_another_estimate_is_refused(tmp_path: Path, change: Any) -> None:
    given: dict[str, Any] = {"model": PLAYER, "parameters": SCENE, "shots": 1000}
    estimate(**given, folder=tmp_path)
    with pytest.raises(ValueError, match=r"there and .* here"):
        estimate(**given | change, folder=tmp_path)


@pytest.fixture
def thrown(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Return the numbers of the sampled shots, once for each time that they are sampled."""
    numbers: list[int] = []
    count = monte_carlo.MonteCarloJob.count

    def counted(work: monte_carlo.MonteCarloJob, start: int, stop: int) -> Any:
        numbers.extend(range(start, stop))
        return count(work, start, stop)

    monkeypatch.setattr(monte_carlo.MonteCarloJob, "count", counted)
    return numbers


@pytest.mark.parametrize("first", [1, 400, 1000, 1700, 2000])
def test_a_folder_can_be_asked_for_more_shots_and_only_the_rest_is_thrown(
    first: int, tmp_path: Path, thrown: list[int]
) -> None:
    """The runs end within one file of the folder, at its end, and in the next one."""
    whole = estimate(PLAYER, SCENE, shots=2500, folder=tmp_path / "whole")
    assert estimate(PLAYER, SCENE, shots=2500) == whole
    estimate(PLAYER, SCENE, shots=first, folder=tmp_path / "more")
    thrown.clear()
    assert estimate(PLAYER, SCENE, shots=2500, folder=tmp_path / "more", threads=2) == whole
    tried, *rest = sorted(thrown)  # the first shot is tried before a folder is opened
    assert (tried, rest) == (0, list(range(first, 2500)))
    assert contents(tmp_path / "more") == contents(tmp_path / "whole")


def test_a_comparison_can_be_asked_for_more_shots_too(tmp_path: Path, thrown: list[int]) -> None:
    other = Scatter(PLAYER.release, SD | {"speed": 0.08})
    whole = compare(PLAYER, other, shots=2500, folder=tmp_path / "whole")
    compare(PLAYER, other, shots=1300, folder=tmp_path / "more")
    thrown.clear()
    assert compare(PLAYER, other, shots=2500, folder=tmp_path / "more") == whole
    assert sorted(thrown)[1:] == list(range(1300, 2500))
    assert contents(tmp_path / "more") == contents(tmp_path / "whole")


def test_so_can_one_in_another_scene(tmp_path: Path, thrown: list[int]) -> None:
    model = Scatter({"x": 4.2, "y": 0.0, "z": -0.9, "vx": -4.5, "vz": 5.6, "vy": 0.0}, {"vx": 0.1})
    given: dict[str, Any] = {"model": model, "scene": hoopgen.COURT}
    whole = estimate(**given, shots=700)
    estimate(**given, shots=500, folder=tmp_path)
    thrown.clear()
    assert estimate(**given, shots=700, folder=tmp_path) == whole
    assert sorted(thrown)[1:] == list(range(500, 700))


def test_fewer_shots_than_are_kept_are_those_of_a_study_of_so_many(tmp_path: Path) -> None:
    whole = estimate(PLAYER, SCENE, shots=2500, folder=tmp_path)
    before = contents(tmp_path)
    for shots in (2000, 1400, 200):
        few = estimate(PLAYER, SCENE, shots=shots, folder=tmp_path)
        assert few == estimate(PLAYER, SCENE, shots=shots)
        assert contents(tmp_path) == before
    assert estimate(PLAYER, SCENE, shots=2500, folder=tmp_path) == whole


def test_an_extension_that_is_interrupted_goes_on_to_the_same_bytes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = estimate(PLAYER, SCENE, shots=2500, folder=tmp_path / "whole")
    estimate(PLAYER, SCENE, shots=400, folder=tmp_path / "more")
    with monkeypatch.context() as patch:
        patch.setattr(monte_carlo.MonteCarloJob, "counted", _interrupted)
        with pytest.raises(KeyboardInterrupt) as raised:
            estimate(PLAYER, SCENE, shots=2500, folder=tmp_path / "more", threads=1)
    assert "the same call goes on from there" in raised.value.__notes__[0]
    assert estimate(PLAYER, SCENE, shots=2500, folder=tmp_path / "more") == whole
    assert contents(tmp_path / "more") == contents(tmp_path / "whole")


_counted = monte_carlo.MonteCarloJob.counted


def _interrupted(
    work: monte_carlo.MonteCarloJob, chunk: int, start: int, stop: int, before: Any = None
) -> Any:
    if start >= 2000:
        raise KeyboardInterrupt
    return _counted(work, chunk, start, stop, before)


def test_a_damaged_chunk_of_fewer_shots_is_computed_anew(
    tmp_path: Path, thrown: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    estimate(PLAYER, SCENE, shots=400, folder=tmp_path)
    (chunk,) = tmp_path.glob("chunk-*")
    chunk.write_bytes(chunk.read_bytes()[:-1])
    thrown.clear()
    found = estimate(PLAYER, SCENE, shots=600, folder=tmp_path)
    assert sorted(thrown)[1:] == list(range(600))
    assert "is damaged" in capsys.readouterr().err
    assert found == estimate(PLAYER, SCENE, shots=600)


# Precision


def test_a_precision_goes_on_from_a_number_of_shots(tmp_path: Path, thrown: list[int]) -> None:
    wanted = estimate(PLAYER, SCENE, precision=0.015)
    estimate(PLAYER, SCENE, shots=1400, folder=tmp_path)
    thrown.clear()
    assert estimate(PLAYER, SCENE, precision=0.015, folder=tmp_path) == wanted
    assert not {*range(1, 1400)} & {*thrown}


def test_whole_numbers_may_be_numpy_s(tmp_path: Path) -> None:
    given = {"shots": np.int64(1500), "seed": np.uint8(3), "max_contacts": np.int64(5)}
    plain = {name: int(value) for name, value in given.items()}
    assert estimate(PLAYER, SCENE, **given, folder=tmp_path / "one") == estimate(
        PLAYER, SCENE, **plain, folder=tmp_path / "one"
    )
    pair = (PLAYER, SCENE), (PLAYER, hoopgen.NBA)
    assert compare(*pair, **given, folder=tmp_path / "two") == compare(
        *pair, **plain, folder=tmp_path / "two"
    )


def test_it_stops_at_the_first_chunk_that_is_precise_enough() -> None:
    found = estimate(PLAYER, SCENE, precision=0.013)
    assert found.half_width <= 0.013
    assert found.shots % 1000 == 0
    before = estimate(PLAYER, SCENE, shots=found.shots - 1000)
    assert before.half_width > 0.013
    assert found == estimate(PLAYER, SCENE, shots=found.shots)


@pytest.mark.parametrize("threads", [1, 2, 4])
def test_threads_do_not_change_where_it_stops(threads: int) -> None:
    wanted = estimate(PLAYER, SCENE, precision=0.02, threads=1)
    assert estimate(PLAYER, SCENE, precision=0.02, threads=threads) == wanted


def test_a_precision_never_takes_more_than_the_shots() -> None:
    found = estimate(PLAYER, SCENE, precision=1e-6, shots=2100)
    assert found.shots == 2100
    assert found.half_width > 1e-6


def test_a_tighter_precision_goes_on_from_the_folder(tmp_path: Path) -> None:
    coarse = estimate(PLAYER, SCENE, precision=0.02, folder=tmp_path)
    fine = estimate(PLAYER, SCENE, precision=0.013, folder=tmp_path)
    assert fine.shots > coarse.shots
    assert fine == estimate(PLAYER, SCENE, precision=0.013)


def test_progress_counts_chunks_and_foresees_their_number() -> None:
    said: list[tuple[int, int | None]] = []
    estimate(PLAYER, SCENE, shots=2500, progress=lambda *now: said.append(now))
    assert said == [(0, 3), (1, 3), (2, 3), (3, 3)]
    said.clear()
    found = estimate(PLAYER, SCENE, precision=0.013, progress=lambda *now: said.append(now))
    chunks = found.shots // 1000
    assert said[0] == (0, None)
    assert [done for done, _ in said] == list(range(chunks + 1))
    assert said[-1] == (chunks, chunks)
    assert all(total is not None and abs(total - chunks) <= 1 for _, total in said[1:])


# Comparisons


def test_a_comparison_pairs_the_same_shots() -> None:
    livelier = hoopgen.NBA | {"restitution": 0.6}
    found = compare((PLAYER, SCENE), (PLAYER, livelier), shots=2300, seed=3)
    made = [everything(2300, scene, 3).outcome == Outcome.MADE for scene in (SCENE, livelier)]
    assert found.both == np.sum(made[0] & made[1])
    assert found.only_first == np.sum(made[0] & ~made[1])
    assert found.only_second == np.sum(~made[0] & made[1])
    assert found.pairs == 2300
    assert found.difference == pytest.approx(
        found.second.probability - found.first.probability, abs=1e-15
    )
    assert found.first == estimate(PLAYER, SCENE, shots=2300, seed=3)
    assert found.second == estimate(PLAYER, livelier, shots=2300, seed=3)
    assert found.low < found.difference < found.high
    assert (found.low, found.high) == newcombe_interval(
        found.both, found.only_second, found.only_first, found.neither, 0.95
    )


def test_swapped_settings_swap_the_sign() -> None:
    other = Scatter({**PLAYER.release, "backspin": 0.0}, SD)
    there, back = compare(PLAYER, other, shots=2000), compare(other, PLAYER, shots=2000)
    assert back.difference == -there.difference
    assert (back.low, back.high) == pytest.approx((-there.high, -there.low), rel=1e-12)
    assert (back.first, back.second) == (there.second, there.first)


def test_a_bare_model_is_in_the_article_s_scene() -> None:
    assert compare(PLAYER, (PLAYER, hoopgen.PAPER), shots=1000).difference == 0.0


def test_the_gain_is_the_ratio_of_the_variances() -> None:
    found = compare((PLAYER, SCENE), (PLAYER, hoopgen.NBA | {"restitution": 0.7}), shots=5000)
    differences = np.repeat(
        [0, -1, 1, 0], [found.both, found.only_first, found.only_second, found.neither]
    )
    first, second = found.first.probability, found.second.probability
    alone = first * (1 - first) + second * (1 - second)
    assert found.gain == pytest.approx(alone / np.var(differences), rel=1e-12)
    assert found.gain > 2
    assert compare(PLAYER, PLAYER, shots=1000).gain == math.inf


def test_pairs_with_an_invalid_shot_are_left_out() -> None:
    wild = Scatter(PLAYER.release, {**SD, "restitution": 0.3})
    found = compare((PLAYER, SCENE), (wild, SCENE), shots=2000)
    assert found.pairs == 2000 - found.second.invalid
    assert found.first.invalid == 0


def test_a_comparison_stops_at_its_precision() -> None:
    pair = (PLAYER, SCENE), (PLAYER, hoopgen.NBA | {"restitution": 0.7})
    found = compare(*pair, precision=0.008, threads=2)
    assert found.half_width <= 0.008
    assert compare(*pair, shots=found.pairs - 1000).half_width > 0.008
    assert found == compare(*pair, shots=found.pairs)


# What it says


def test_results_are_json_and_say_what_they_are_of() -> None:
    found = estimate(PLAYER, SCENE, shots=500, seed=2**64 - 1, confidence=0.9)
    record = json.loads(json.dumps(found.as_dict(), allow_nan=False))
    assert record["probability"] == found.probability
    assert record["seed"] == 2**64 - 1
    assert record["confidence"] == 0.9
    assert record["setting"]["sd"] == SD
    assert record["setting"]["parameters"] == dict(SCENE)
    both = compare(PLAYER, PLAYER, shots=500).as_dict()
    assert json.loads(json.dumps(both, allow_nan=False))["gain"] == "inf"
    assert both["second"]["shots"] == 500


def test_an_estimate_in_words() -> None:
    known = Estimate(
        *(0.6789, 0.6785, 0.6793, 0.95, 1_000_000, 678_900, 320_000, 1100, 0, 0, 77, 70),
        kinds={"swish": 250_000, "rim": 750_000, "bank_rim": 0},
        kinds_made={"swish": 250_000, "rim": 428_900, "bank_rim": 0},
        seed=0,
        setting={**PLAYER.identity(), "parameters": dict(hoopgen.NBA) | {"restitution": 0.75}},
    )
    assert str(known) == (
        "made     67.890%, 67.850% to 67.930% (Wilson's 95% interval)\n"
        "shots    1,000,000: 678,900 made, 320,000 missed, 1,100 capped, 0 short, 0 invalid, "
        "77 uncertain (70 of them capped)\n"
        "capped   68.000% if made\n"
        "\n"
        "kind         share  of it made\n"
        "swish        25.0%      100.0%\n"
        "rim          75.0%       57.2%\n"
        "\n"
        "scene    NBA, restitution 0.75\n"
        "release  speed 7.17 m/s, elevation 52°, backspin 3 Hz, height 2.1336 m, distance 4.191 m\n"
        "scatter  speed 0.07 m/s, elevation 1.3°, azimuth 1°\n"
        "seed     0"
    )


def test_a_comparison_in_words() -> None:
    text = str(compare((PLAYER, SCENE), (PLAYER, hoopgen.NBA), shots=2000))
    assert text.startswith("first       6")
    assert "points, " in text
    assert "Newcombe's paired 95% interval" in text
    assert "pairs       2,000: " in text


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        ({"shots": 0}, ValueError, "shots: expected a whole number from 1, got 0"),
        (
            {"shots": 1e6},
            ValueError,
            "shots: expected a whole number from 1, got 1000000.0; give it as",
        ),
        ({"precision": 0}, ValueError, "precision: expected a number within 0 and 1, got 0"),
        ({"precision": "1%"}, ValueError, "precision: expected a number within 0 and 1"),
        ({"confidence": 95}, ValueError, "confidence: expected a number within 0 and 1, got 95"),
        ({"seed": -1}, ValueError, "seed: expected a whole number from 0"),
        ({"max_contacts": 0}, ValueError, "max_contacts: expected a whole number from 1"),
        ({"max_contacts": 2.5}, ValueError, "max_contacts: expected a whole number from 1"),
        ({"backend": "gpu"}, ValueError, "backend: expected 'auto', 'c', 'numpy' or 'cuda'"),
        ({"threads": 0}, ValueError, "threads: expected a whole number from 1"),
        ({"parameters": {"bounce": 1}}, ValueError, "parameters: unknown bounce. The names are"),
        (
            {"parameters": hoopgen.PAPER | {"gravity": [9.8, 9.9]}},
            ValueError,
            "parameters.'gravity'.: expected one number for all shots, got .9.8, 9.9",
        ),
        (
            {"parameters": hoopgen.PAPER | {"gravity": [9.8]}},
            ValueError,
            "parameters.'gravity'.: expected one number for all shots, got .9.8",
        ),
        ({"model": MEAN}, TypeError, "model: expected a Scatter, a Resample, or what else draws"),
        ({"model": Scatter({"speed": 7})}, ValueError, "variables: missing height, distance"),
        (
            {"model": hoopgen.Grid({"speed": [7.0]}, REST)},
            TypeError,
            "expected a Scatter, a Resample",
        ),
    ],
)
def test_what_is_wrong_is_said(
    tmp_path: Path, change: Mapping[str, Any], error: type[Exception], message: str
) -> None:
    folder = tmp_path / "kept"
    with pytest.raises(error, match=message):
        estimate(**{"model": PLAYER, "parameters": SCENE, "shots": 10, "folder": folder, **change})
    assert "threads" in change or not folder.exists()


def test_a_tally_of_many_settings_is_that_of_each() -> None:
    shots = everything(600)
    whole = Tally.from_shots(shots, 3)
    assert whole.shots.tolist() == [200, 200, 200]
    again = Tally.read(whole.row(), whole.scene)
    assert np.array_equal(again.table, whole.table)
    assert np.array_equal(again.uncertain, whole.uncertain)
    one = Tally.from_shots(shots, 1)
    assert np.array_equal(whole.table.sum(axis=0), one.table[0])
    total = whole + whole
    assert total.shots.tolist() == [400, 400, 400]
    assert isinstance(compare(PLAYER, PLAYER, shots=10), Comparison)


# On the command line

OPTIONS = [
    *["estimate", "--speed", "7.17", "--elevation", "52deg", "--height", "7ft"],
    *["--distance", "13.75ft", "--backspin", "3Hz", "--preset", "nba", "--set", "restitution=0.75"],
    *["--scatter", "speed=0.07", "--scatter", "elevation=1.3deg", "--scatter", "azimuth=1deg"],
]


def test_the_command_says_and_writes_what_the_library_gives() -> None:
    given = ["--shots", "2e3", "--seed", "7", "--confidence", "0.9", "--max-contacts", "30"]
    correlated = Scatter(PLAYER.release, PLAYER.sd, {("speed", "elevation"): -0.3})
    wanted = estimate(correlated, SCENE, shots=2000, seed=7, confidence=0.9, max_contacts=30)
    arguments = [*OPTIONS, *given, "--correlation", "speed,elevation=-0.3"]
    assert output(*arguments) == f"{wanted}\n"
    assert json.loads(output(*arguments, "--json")) == in_units(wanted.as_dict())


@pytest.mark.parametrize(
    ("versus", "change", "drop"),
    [
        (["backspin=0"], {"backspin": 0.0}, ()),
        (
            ["elevation=50deg", "backspin=1Hz"],
            {"elevation": 50 * DEGREE, "backspin": 2 * math.pi},
            (),
        ),
        (["aim=5cm"], {"aim": 0.05}, ("speed",)),
        (["entry=45deg", "aim=0"], {"entry": 45 * DEGREE, "aim": 0.0}, ("speed", "elevation")),
    ],
)
def test_versus_compares_with_variables_changed(
    versus: list[str], change: dict[str, float], drop: tuple[str, ...]
) -> None:
    kept = {name: value for name, value in PLAYER.release.items() if name not in drop}
    wanted = compare((PLAYER, SCENE), (Scatter(kept | change, SD), SCENE), shots=1500)
    options = [word for one in versus for word in ("--versus", one)]
    found = json.loads(output(*OPTIONS, "--shots", "1500", *options, "--json"))
    assert found == in_units(wanted.as_dict())


def test_versus_changes_the_scene_and_says_what_it_changed() -> None:
    scene = SCENE | {"restitution": 0.6}
    wanted = compare((PLAYER, SCENE), (PLAYER, scene), shots=1500)
    text = output(*OPTIONS, "--shots", "1500", "--versus", "restitution=0.6")
    assert text == f"versus      restitution 0.600\n{wanted}\n"


@pytest.mark.parametrize(
    ("values", "changes", "wanted"),
    [
        ("aim elevation", "speed", "elevation speed"),
        ("entry aim", "speed elevation", "speed elevation"),
        ("entry aim", "elevation", "aim elevation"),
        ("aim elevation", "entry", "aim entry"),
        ("speed elevation", "height", "speed elevation height"),
        ("x y speed", "x", "x y speed"),
    ],
)
def test_a_change_takes_the_place_of_what_it_stands_for(
    values: str, changes: str, wanted: str
) -> None:
    changed = change_variables(dict.fromkeys(values.split(), 1), dict.fromkeys(changes.split(), 2))
    assert sorted(changed) == sorted(wanted.split())
    assert all(changed[name] == 2 for name in changes.split())


def test_from_draws_measured_releases_and_options_fill_in(tmp_path: Path) -> None:
    file = tmp_path / "releases.csv"
    file.write_text(
        "player,speed_mph,elevation_deg,height\na,16.0,52,9\nb,16.1,51,9\nc,15.9,53,9\n"
    )
    model = hoopgen.Resample(
        {
            "speed": np.array([16.0, 16.1, 15.9]) * (1609.344 / 3600),
            "elevation": np.array([52.0, 51.0, 53.0]) * DEGREE,
            "height": 7 * 0.3048,
            "distance": 13.75 * 0.3048,
        }
    )
    arguments = ["estimate", "--from", str(file), "--height", "7ft", "--distance", "13.75ft"]
    found = json.loads(output(*arguments, "--shots", "900", "--json"))
    wanted = estimate(model, shots=900).as_dict()
    assert {**found, "setting": None} == {**wanted, "setting": None}
    assert "missing distance; give --distance (or --place). The columns are player" in failure(
        *arguments[:-2]
    )
    assert "--scatter is about a release" in failure(*arguments, "--scatter", "speed=1")


def test_a_precision_that_is_not_reached_is_said() -> None:
    result = succeed(*OPTIONS, "--precision", "0.0001", "--shots", "1000")
    assert result.stderr == "hoopgen: the precision was not reached; more --shots\n"
    assert run(*OPTIONS, "--precision", "0.02").stderr == ""


def test_the_folder_is_passed_on(tmp_path: Path) -> None:
    first = output(*OPTIONS, "--shots", "2000", "--folder", str(tmp_path))
    assert len(list(tmp_path.glob("chunk-*.arrow"))) == 2
    assert output(*OPTIONS, "--shots", "2000", "--folder", str(tmp_path)) == first
    assert "there and" in failure(*OPTIONS, "--seed", "1", "--folder", str(tmp_path))
    more = output(*OPTIONS, "--shots", "2600", "--folder", str(tmp_path))
    assert more == output(*OPTIONS, "--shots", "2600")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ["--elevation", "52deg"],
            "missing --speed (or --aim), --height and --distance (or --place, or --x",
        ),
        (["--scatter", "pace=1"], "'pace' is none of speed, elevation"),
        (["--scatter", "speed"], "'speed' is not name=value"),
        (["--scatter", "speed=1deg"], "speed: '1deg': 'deg' is not a unit of speed"),
        ([*OPTIONS[1:], "--scatter", "aim=1cm"], "--scatter: unknown aim"),
        (["--correlation", "speed=0.1"], "'speed=0.1' is not name,name=value"),
        (["--correlation", "speed,height=x"], "'x' is not a number"),
        ([*OPTIONS[1:], "--correlation", "speed,height=0.1"], "is no pair of"),
        (["--shots", "1.5"], "'1.5' is not a whole number from 1"),
        (["--shots", "0"], "'0' is not a whole number from 1"),
        (["--shots", "1e30"], f"'1e30' is not a whole number from 1 to {2**63 - 1}"),
        (["--shots", "many"], "'many' is not a whole number from 1"),
        (["--shots", "inf"], "'inf' is not a whole number from 1"),
        (["--precision", "1"], "'1' is no share above 0% and below 100%"),
        ([*OPTIONS[1:], "--aim", "5cm"], "--aim takes the place of --speed; got both"),
    ],
)
def test_what_is_wrong_on_the_command_line_is_said(arguments: list[str], message: str) -> None:
    said = failure("estimate", *arguments)
    assert message in said
    assert said.startswith("hoopgen: error: ")
    assert said.count("\n") == 1


@pytest.mark.parametrize("command", ["fan", "landings"])
def test_more_shots_than_there_is_memory_for_are_refused_at_once(command: str) -> None:
    said = failure(command, *OPTIONS[1:], "--shots", "1e12")
    assert said.startswith("hoopgen: error: 1e+12 shots drawn at once would take ")


GOLF = ROOT / "examples" / "scenes" / "golf.toml"


def test_the_examples_of_the_help_are_commands() -> None:
    for name in ("estimate", "map"):
        command = main.commands[name]
        text = re.sub(r"\\\s*\n", " ", (command.epilog or "").partition("Examples:")[2])
        examples = [shlex.split(line) for line in text.splitlines() if line.strip()]
        assert len(examples) > 1
        for program, same, *arguments in examples:
            assert (program, same) == ("hoopgen", name)
            there = {"releases.csv": "/dev/null", "golf.toml": str(GOLF)}
            options = [there.get(one, one) for one in arguments]
            with command.make_context(name, options):
                pass


def test_a_precision_that_no_shot_can_bring_nearer_is_refused_at_once() -> None:
    nowhere = hoopgen.Resample(
        {"speed": [np.nan], "elevation": 0.9, "height": 2.0, "distance": 4.0}
    )
    with pytest.raises(ValueError, match=r"model: none of the first .* shots is valid"):
        hoopgen.estimate(nowhere, precision=0.01)


def test_a_scene_in_which_nothing_can_be_simulated_is_refused() -> None:
    model = hoopgen.Resample({"speed": [7.0], "elevation": 0.9, "height": 2.0, "distance": 4.0})
    with pytest.raises(ValueError, match="parameters: no shot can be simulated with these"):
        hoopgen.estimate(model, hoopgen.PAPER | {"gravity": 0.0})


def test_shares_of_kinds_are_of_the_valid_shots() -> None:
    """Invalid shots, which touch nothing either, are none of them."""
    measured = {**REST, "speed": [7.17, np.nan, 7.2, 7.5]}
    found = estimate(hoopgen.Resample(measured), shots=2_000)
    assert 0 < found.invalid < found.shots
    valid = found.shots - found.invalid
    assert sum(found.shares.values()) == pytest.approx(1, abs=1e-15)
    assert found.shares["swish"] == found.kinds["swish"] / valid
    assert found.shares["none"] == (found.kinds["none"] - found.invalid) / valid


def test_a_derivative_by_a_scatter_needs_one(tmp_path: Path) -> None:
    file = tmp_path / "measured.csv"
    file.write_text(
        "speed_mph,elevation_deg,height_ft,distance_ft\n16,52,7,13.75\n16.1,51,7,13.75\n"
    )
    said = failure("estimate", "--from", str(file), "--gradient", "mean.speed", "--shots", "100")
    assert "mean.speed is of a scatter, which measured releases have with --fitted" in said


def test_metadata_that_nest_deeply_are_refused_in_a_line(tmp_path: Path) -> None:
    file = tmp_path / "deep.csv"
    file.write_text("# hoopgen: " + "[" * 100_000 + "\nspeed_mph,elevation_deg\n16,52\n")
    release = ("--height", "7ft", "--distance", "13.75ft")
    said = failure("estimate", "--from", str(file), *release, "--shots", "100")
    assert "cannot be understood" in said
