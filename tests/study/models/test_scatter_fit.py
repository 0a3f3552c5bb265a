"""`Scatter.fit`: spreads without measuring errors, intervals that hold, and outliers."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

for _library in ("pyarrow", "scipy"):
    pytest.importorskip(_library)

from scipy.integrate import quad  # noqa: E402
from scipy.stats import chi2  # noqa: E402

import hoopgen  # noqa: E402
from hoopgen import NBA, Resample, Scatter  # noqa: E402
from hoopgen.study.models.fitted_scatter import FittedScatter, consistent  # noqa: E402
from hoopgen.study.models.robust_moments import NU, efficiency, moments  # noqa: E402
from tests.helpers.commands import failure, output, succeed  # noqa: E402
from tests.helpers.effort import trials  # noqa: E402

NAMES = ("speed", "elevation", "azimuth")
MEAN = np.array([7.17, 0.9, 0.0])
SD = np.array([0.07, 0.0227, 0.0175])
NOISE = np.array([0.04, 0.008, 0.008])
RHO = -0.4
PLACE = {"height": 2.1336, "distance": 4.191}
ERRORS: Any = dict(zip(NAMES, NOISE**2, strict=True))


def thrown(
    random: np.random.Generator, rows: int, sd: Any = SD, noise: Any = NOISE, mean: Any = MEAN
) -> np.ndarray:
    """Return measured releases, (rows, 3), of which speed and elevation are correlated."""
    z = random.normal(size=(rows, 3))
    z[:, 1] = RHO * z[:, 0] + np.sqrt(1 - RHO**2) * z[:, 1]
    return mean + sd * z + noise * random.normal(size=(rows, 3))


def columns(values: np.ndarray) -> dict[str, Any]:
    return {**PLACE, **dict(zip(NAMES, values.T, strict=True))}


def fit(values: np.ndarray, errors: Any = ERRORS, **options: Any) -> Any:
    return Scatter.fit(columns(values), measurement_covariance=errors, **options)


@pytest.mark.parametrize("p", [1, 2, 5])
def test_the_constants_make_the_covariance_unbiased(p: int) -> None:
    factor = efficiency(p).factor
    weighted = quad(lambda d: factor * (NU + p) / (NU + d) * d * chi2.pdf(d, p), 0, np.inf)[0]
    assert weighted == pytest.approx(p, rel=1e-6)


def test_the_efficiency_is_that_of_the_fit_of_a_track() -> None:
    from hoopgen.study.recovery.estimator import EFFICIENCY

    assert efficiency(3).mean == pytest.approx(EFFICIENCY, rel=1e-6)


@pytest.mark.slow
def test_the_errors_of_the_estimate_are_as_large_as_tyler_says() -> None:
    """The scatter of estimated variances of many samples, against sigma_1 and sigma_2."""
    random, rows = np.random.default_rng(5), 200
    found = [
        moments(random.normal(size=(rows, 2)), np.zeros((rows, 2, 2)))
        for _ in range(trials(300, 150))
    ]
    variances = np.array([np.diag(one.covariance) for one in found])
    free = found[0].degrees[0]
    assert free == pytest.approx(
        2 * (rows - 1) / (2 * efficiency(2).shape + efficiency(2).size), rel=0.02
    )
    # Four standard errors of a variance.
    slack = 4 * np.sqrt(2 / variances.size)
    assert np.var(variances) * free / 2 == pytest.approx(1.0, abs=slack)
    assert np.mean(variances) == pytest.approx(1.0, abs=4 * np.sqrt(2 / free / variances.size))


def coverage(rows: int, count: int, seed: int) -> tuple[dict[str, float], np.ndarray]:
    """Return how often 95% intervals have the truth in them, and the mean ratio of variances."""
    random, inside, ratios = np.random.default_rng(seed), [], []
    for _ in range(count):
        found = fit(thrown(random, rows))
        ends = [found.sd[name].interval() for name in NAMES]
        middle = [found.mean[name].interval() for name in NAMES]
        low, high = found.correlation["speed", "elevation"].interval()
        inside.append(
            [
                np.mean([a <= true <= b for (a, b), true in zip(ends, SD, strict=True)]),
                np.mean([a <= true <= b for (a, b), true in zip(middle, MEAN, strict=True)]),
                low <= RHO <= high,
            ]
        )
        ratios.append(
            [(found.sd[name].value / sd) ** 2 for name, sd in zip(NAMES, SD, strict=True)]
        )
    shares = np.mean(inside, axis=0)
    return dict(zip(("sd", "mean", "correlation"), shares, strict=True)), np.mean(ratios, axis=0)


@pytest.mark.slow
@pytest.mark.parametrize("rows", [15, 60, 300])
def test_intervals_hold_and_the_spread_has_no_bias(rows: int) -> None:
    count = trials(400, 100)
    found, ratio = coverage(rows, count, rows)
    for name, share in found.items():
        # Of `sd` and `mean` three intervals each; four standard errors, and a point for the
        # approximations. Correlations of few noisy rows have intervals that are too wide.
        slack = 0.01 + 4 * np.sqrt(0.05 * 0.95 / count)
        assert share > 0.95 - slack, (name, share)
        assert share < 0.95 + slack or name == "correlation", (name, share)
    np.testing.assert_allclose(ratio, 1.0, rtol=0, atol=0.02 + 4 * np.sqrt(4 / rows / count))


def test_the_measuring_errors_are_not_in_the_spread() -> None:
    values = thrown(np.random.default_rng(2), 2_000)
    found, raw = fit(values), fit(values, None)
    for name, sd, noise in zip(NAMES, SD, NOISE, strict=True):
        low, high = found.sd[name].interval(0.998)
        assert low < sd < high
        assert raw.sd[name].interval(0.998)[0] > sd
        assert found.measured_sd[name] == pytest.approx(np.hypot(sd, noise), rel=0.1)
    low, high = found.correlation["speed", "elevation"].interval(0.998)
    assert low < RHO < high
    # Errors without correlation bring the measured one nearer to 0.
    assert (
        raw.correlation["speed", "elevation"].value > found.correlation["speed", "elevation"].value
    )


def test_outliers_change_little() -> None:
    values = thrown(np.random.default_rng(3), 300)
    clean = fit(values)
    values[:15] += np.array([2.0, 0.5, 0.3])
    found = fit(values)
    assert found.outliers == 15
    for name, width in zip(NAMES, SD, strict=True):
        assert found.sd[name].value == pytest.approx(clean.sd[name].value, rel=0.1)
        assert found.mean[name].value == pytest.approx(clean.mean[name].value, abs=0.1 * width)
    assert np.std(values[:, 0]) > 4 * clean.sd["speed"].value


def test_a_spread_below_the_measuring_error_may_be_0() -> None:
    still = SD * [0.0, 1.0, 1.0]
    found = fit(thrown(np.random.default_rng(4), 40, still))
    low, high = found.sd["speed"].interval()
    assert low == 0.0
    assert 0.0 < high < NOISE[0]
    assert all(found.model.draw(0, 10).states[:, 3])  # it is a scatter to draw from


def players(
    random: np.random.Generator, count: int
) -> tuple[np.ndarray, list[str], dict[str, Any]]:
    """Return the measured releases of players who differ, their labels, and the truths."""
    values, labels, truth = [], [], {}
    for player in range(count):
        rows = int(random.integers(4, 50))
        sd = SD * np.exp(0.3 * random.normal(size=3))
        mean = MEAN + random.normal(size=3) * [0.05, 0.03, 0.005]
        values.append(thrown(random, rows, sd, NOISE, mean))
        labels += [f"player {player}"] * rows
        truth[f"player {player}"] = sd, mean
    return np.concatenate(values), labels, truth


@pytest.mark.slow
def test_intervals_of_players_hold_and_shrunk_spreads_are_nearer() -> None:
    random, inside = np.random.default_rng(6), []
    shrunk, alone = [], []
    for _ in range(trials(40, 20)):
        values, labels, truth = players(random, 10)
        found = fit(values, group=labels)
        for label, (sd, mean) in truth.items():
            rows = np.array(labels) == label
            one = found[label]
            assert one.shrunk
            for name, spread, middle in zip(NAMES, sd, mean, strict=True):
                low, high = one.sd[name].interval()
                inside.append([low <= spread <= high])
                low, high = one.mean[name].interval()
                inside[-1].append(low <= middle <= high)
            if 5 <= rows.sum() < 15:
                own = fit(values[rows])
                for name, spread in zip(NAMES, sd, strict=True):
                    shrunk.append((one.sd[name].value - spread) / spread)
                    alone.append((own.sd[name].value - spread) / spread)
    share = np.mean(inside, axis=0)
    # The intervals of players with few releases are known to hold in 92% to 94%, as the page on a
    # player study says.
    assert np.all(share > 0.95 - 0.02 - 4 * np.sqrt(0.05 * 0.95 / len(inside))), share
    assert np.all(share < 0.98), share
    assert np.mean(np.square(shrunk)) < 0.8 * np.mean(np.square(alone))


@pytest.mark.slow
def test_players_with_many_releases_are_hardly_shrunk() -> None:
    random = np.random.default_rng(7)
    values = np.concatenate([thrown(random, 400, SD * k) for k in (0.5, 0.8, 1.0, 1.6)])
    labels = np.repeat(["a", "b", "c", "d"], 400)
    found = fit(values, group=labels)
    assert list(found) == ["a", "b", "c", "d"]
    for label in found:
        own = fit(values[labels == label])
        assert found[label].sd["speed"].value == pytest.approx(own.sd["speed"].value, rel=0.03)


def test_few_players_are_not_shrunk_and_few_rows_are_said() -> None:
    random = np.random.default_rng(8)
    values = thrown(random, 42)
    found = fit(values, group=["a"] * 20 + ["b"] * 20 + ["c"] * 2)
    assert dict(found.left_out) == {"c": 2}
    assert not found["a"].shrunk
    assert found["a"].sd["speed"].value == pytest.approx(
        fit(values[:20]).sd["speed"].value, rel=0.3
    )
    assert "too few releases: c" in str(found)


def test_fitted_releases_bring_their_errors() -> None:
    random = np.random.default_rng(9)
    count, times = trials(300, 150), np.arange(0.0, 0.5, 1 / 60)
    values = thrown(random, count, noise=np.zeros(3))
    states = hoopgen.release(*values.T, backspin=18.0, **PLACE)
    fall = np.array([0, 0, -0.5 * NBA["gravity"]])
    path = states[:, None, :3] + states[:, None, 3:6] * times[:, None] + fall * times[:, None] ** 2
    noisy = path + random.normal(0, 0.02, path.shape)
    fitted = hoopgen.fit_release(times, noisy, parameters=NBA, noise=0.02, backspin=18.0)
    found = Scatter.fit(fitted)
    assert isinstance(found, FittedScatter)
    assert np.std(fitted.variables["speed"]) > 1.05 * SD[0]  # the errors are seen
    for name, sd in zip(NAMES, SD, strict=True):
        low, high = found.sd[name].interval(0.998)
        assert low < sd < high, name
    # Height and distance of the releases are equal: what spreads them is the noise of the tracks.
    assert found.sd["height"].interval()[0] < 0.003
    assert found.model.release["backspin"] == 18.0


@pytest.mark.slow
def test_an_estimate_of_a_fit_contains_the_uncertainty_of_the_sample() -> None:
    found = fit(thrown(np.random.default_rng(10), 60))
    estimate = hoopgen.estimate(found, NBA, shots=20_000)
    plain = hoopgen.estimate(found.model, NBA, shots=20_000)
    assert (estimate.made, estimate.low, estimate.high) == (plain.made, plain.low, plain.high)
    assert estimate.sample is not None
    assert estimate.sample.low < estimate.low < estimate.high < estimate.sample.high
    assert estimate.sample.rows == 60
    assert plain.sample is None


@pytest.mark.slow
def test_the_interval_of_the_sample_holds() -> None:
    random = np.random.default_rng(11)
    release = {**PLACE, **dict(zip(NAMES, MEAN, strict=True))}
    true = Scatter(release, dict(zip(NAMES, SD, strict=True)), {("speed", "elevation"): RHO})
    truth = hoopgen.estimate(true, NBA, shots=400_000).probability
    count, inside = trials(60, 40), 0
    for _ in range(count):
        sample = hoopgen.estimate(fit(thrown(random, 40)), NBA, shots=20_000).sample
        assert sample is not None
        inside += sample.low <= truth <= sample.high
    assert inside / count > 0.95 - 0.01 - 4 * np.sqrt(0.05 * 0.95 / count)


def test_correlations_that_no_distribution_has_are_made_consistent() -> None:
    given = {("a", "b"): 0.9, ("b", "c"): 0.9, ("a", "c"): -0.9}
    found = consistent(dict.fromkeys("abc", 1.0), given)
    matrix = np.eye(3)
    for (i, j), value in zip(((0, 1), (1, 2), (0, 2)), found.values(), strict=True):
        matrix[i, j] = matrix[j, i] = value
    assert np.linalg.eigvalsh(matrix)[0] > 0.0
    fine = {("a", "b"): 0.3, ("b", "c"): 0.2}
    assert consistent(dict.fromkeys("abc", 1.0), fine) == pytest.approx(fine, abs=1e-12)


def test_models_are_drawn_again_from_their_seed() -> None:
    found = fit(thrown(np.random.default_rng(12), 50))
    first, again, other = found.models(3, 1), found.models(3, 1), found.models(3, 2)
    assert first == again
    assert first != other
    spread = [one.sd["speed"] for one in found.models(500)]
    assert np.quantile(spread, 0.975) == pytest.approx(found.sd["speed"].interval()[1], rel=0.05)


def test_a_resample_and_a_frame_are_tables() -> None:
    values = thrown(np.random.default_rng(13), 50)
    sample = Resample(columns(values))
    assert Scatter.fit(sample).model == fit(values, None).model
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({**columns(values), "name": ["a", "b"] * 25})
    assert set(Scatter.fit(frame, group="name")) == {"a", "b"}


@pytest.mark.parametrize(
    ("table", "options", "said"),
    [
        ({"speed": [7.0]}, {}, "at least 2|not all alike"),
        ({"speed": [7.0, 7.1]}, {}, "table: expected at least 3"),
        ({"speed": [7.0, 7.1, 7.2], "x": 1.0}, {}, "x and y are given together"),
        ({"spede": [7.0, 7.1, 7.2]}, {}, "table: .*spede"),
        ({"elevation": [52.0, 51.0, 50.0, 53.0]}, {}, "more than a turn"),
        ({"speed": [7.0, 7.1, 7.2]}, {"group": ["a", "b"]}, "group: expected a label for each"),
        ({"speed": [7.0, 7.1, 7.2]}, {"group": "player"}, "group: no column 'player'"),
        ({"speed": [7.0, 7.1]}, {"group": ["a", None]}, "group: row 2 of 2 has no label"),
        (
            {"speed": [7.0, 7.1, 7.2]},
            {"measurement_covariance": {"speed": -1.0}},
            "measurement_covariance.*variances from 0",
        ),
        (
            {"speed": [7.0, 7.1, 7.2]},
            {"measurement_covariance": {"height": 1.0}},
            "measurement_covariance: .*height",
        ),
        (3, {}, "table: expected fitted releases"),
    ],
)
def test_what_is_no_table_is_refused(table: Any, options: Any, said: str) -> None:
    with pytest.raises((TypeError, ValueError), match=said):
        Scatter.fit(table, **options)


_RELEASE = ("--speed", "7", "--elevation", "52deg", "--height", "2", "--distance", "4")


def write(path: Path, group: bool = True) -> Path:
    values = thrown(np.random.default_rng(14), 60)
    head = "player," * group + "speed_m_s,elevation_deg,azimuth_deg,sd_speed_m_s\n"
    rows = [
        f"{('Ann', 'Bea')[row % 2]}," * group
        + f"{v:.6f},{np.degrees(e):.6f},{np.degrees(a):.6f},{NOISE[0]}"
        for row, (v, e, a) in enumerate(values)
    ]
    path.write_text(head + "\n".join(rows) + "\n", encoding="utf-8")
    return path


@pytest.mark.slow
def test_the_command_fits_and_says_both_intervals(tmp_path: Path) -> None:
    file = write(tmp_path / "shots.csv", group=False)
    words = ("estimate", "--from", file, "--height", "7ft", "--distance", "13.75ft", "--fitted")
    text = output(*words, "--shots", 2000, "--preset", "nba")
    assert "as measured" in text
    assert "interval of the sample, 60 measured releases" in text
    assert "measuring errors: speed\n" in text
    raw = output(*words, "--shots", 2000, "--preset", "nba", "--instrument", "speed=0")
    assert raw.split("speed ")[1] != text.split("speed ")[1]
    assert "measuring errors: speed (given)" in raw


@pytest.mark.slow
def test_the_command_takes_a_player_a_group(tmp_path: Path) -> None:
    file = write(tmp_path / "shots.csv")
    words = ("estimate", "--from", file, "--height", "7ft", "--distance", "13.75ft", "--fitted")
    text = output(*words, "--shots", 2000, "--preset", "nba", "--group", "player")
    assert "Ann: 30 releases" in text
    assert "Bea: 30 releases" in text
    said = failure(*words, "--group", "player", "--versus", "height=6ft")
    assert "--where 'player == Ann'" in said
    assert "give --from" in failure("estimate", "--fitted", *_RELEASE)


@pytest.mark.slow
def test_other_questions_take_the_fitted_scatter_too(tmp_path: Path) -> None:
    file = write(tmp_path / "shots.csv", group=False)
    words = ("--from", file, "--height", "7ft", "--distance", "13.75ft", "--fitted", "--shots", 500)
    assert "scatter  speed 0.0" in output("optimum", *words, "--over", "aim", "--over", "elevation")
    succeed("map", *words, "--over", "aim=0:10cm:2", "--out", tmp_path / "map.csv")
