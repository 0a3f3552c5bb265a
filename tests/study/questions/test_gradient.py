"""The gradient of the probability of a made shot: scores, differences, intervals, refusals."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("pyarrow")
pytest.importorskip("scipy")

import hoopgen
from hoopgen.study.jobs import monte_carlo
from hoopgen.study.jobs.differences import (
    CENTRAL,
    COUNTS,
    ONE_SIDED,
    STEP,
    Differences,
    difference_counts,
    differences_of,
)
from hoopgen.study.models.scores import SUMS, UNIT, score_sums
from hoopgen.study.questions.gradient import Slope, difference_slopes
from tests.helpers.commands import failure, succeed
from tests.helpers.effort import trials

RELEASE = {"speed": 7.17, "elevation": 0.9076, "backspin": 18.85, "height": 2.1336}
RELEASE |= {"distance": 4.191}
SD = {"speed": 0.07, "elevation": 0.0227, "azimuth": 0.0175}
PLAYER = hoopgen.Scatter(RELEASE, SD, {("speed", "elevation"): -0.4})
NAMES = ("mean.speed", "sd.speed", "mean.elevation", "sd.azimuth")


def log_density(mean: Any, sd: Any, correlation: float, x: Any) -> float:
    """Return the logarithm of the density of two correlated normal variables."""
    covariance = np.diag(sd) @ np.array([[1, correlation], [correlation, 1]]) @ np.diag(sd)
    off = x - mean
    return float(
        -0.5 * off @ np.linalg.solve(covariance, off) - 0.5 * np.log(np.linalg.det(covariance))
    )


@pytest.mark.parametrize("correlation", [0.0, 0.6, -0.9])
def test_a_score_is_the_derivative_of_the_logarithm_of_the_density(correlation: float) -> None:
    pairs = {("speed", "elevation"): correlation}
    model = hoopgen.Scatter(RELEASE, {"speed": 0.07, "elevation": 0.02}, pairs)
    names = ("mean.speed", "sd.speed", "mean.elevation", "sd.elevation")
    mean, sd = np.array([7.17, 0.9076]), np.array([0.07, 0.02])
    yes = np.ones(1, np.bool_)
    for shot in range(20):
        noise = model.noise(shot, shot + 1, 3)
        x = mean + [float(noise[name][0]) for name in ("speed", "elevation")]
        sums = score_sums(model, names, (shot, shot + 1), 3, yes, yes).reshape(-1, SUMS)
        for index, name in enumerate(names):
            ends = []
            for sign in (1, -1):
                moved = [mean.copy(), sd.copy()]
                moved["sd" in name][index // 2] += sign * 1e-6 * sd[index // 2]
                ends.append(log_density(*moved, correlation, x))
            score = (ends[0] - ends[1]) / 2e-6  # times the deviation
            assert abs(sums[index, 0] / UNIT - score) < 1e-5 + 1e-6 * abs(score)
            assert sums[index, 0] == sums[index, 1]
            assert abs(sums[index, 2] / UNIT - score**2) < 1e-5 + 1e-4 * score**2


def found(shots: int, seed: int, names: Any = NAMES, **options: Any) -> dict[str, Slope]:
    """Return the gradient of the player."""
    return dict(
        hoopgen.estimate(PLAYER, shots=shots, seed=seed, gradient=names, **options).gradient
    )


@pytest.mark.slow
def test_scores_agree_with_differences_over_the_same_random_numbers() -> None:
    shots = 200_000
    slopes = found(shots, 1)
    for name, slope in slopes.items():
        kind, variable = name.split(".")
        step = 0.1 * SD[variable]
        players = []
        for sign in (-1, 1):
            release, sd = dict(RELEASE), dict(SD)
            if kind == "mean":
                release[variable] += sign * step
            else:
                sd[variable] += sign * step
            players.append(hoopgen.Scatter(release, sd, {("speed", "elevation"): -0.4}))
        change = hoopgen.compare(*players, shots=shots, seed=2)
        expected, half = change.difference / (2 * step), (change.high - change.low) / (4 * step)
        # Both are random; half the widths are two standard errors each, and the step has a bias.
        assert abs(slope.value - expected) < 2 * np.hypot(half, (slope.high - slope.low) / 2)
        assert slope.low < slope.value < slope.high
        assert (slope.method, slope.bias) == ("score", 0.0)


@pytest.mark.slow
def test_intervals_of_the_gradient_contain_the_truth_as_often_as_they_say() -> None:
    """Demand that 90% at the least do, of 95% intervals of many seeds."""
    names = (*NAMES, "restitution")
    truth = found(1 << 21, 10_000, names)
    runs = trials(200)
    hits = dict.fromkeys(names, 0)
    for seed in range(runs):
        for name, slope in found(10_000, seed, names).items():
            hits[name] += slope.low <= truth[name].value <= slope.high
    for name, count in hits.items():
        assert 0.9 * runs <= count, (name, count, runs)


def test_a_parameter_is_differenced_over_the_same_shots() -> None:
    shots, step = 20_000, 0.7 * STEP
    slope = found(shots, 4, ["restitution"])["restitution"]
    shares = [
        hoopgen.estimate(PLAYER, {"restitution": 0.7 + times * step}, shots=shots, seed=4)
        for times in (1, -1, 2, -2)
    ]
    made = [one.probability for one in shares]
    assert slope.method == "difference"
    assert slope.value == pytest.approx((made[0] - made[1]) / (2 * step), rel=1e-12)
    twice = (made[2] - made[3]) / (4 * step)
    assert slope.bias == pytest.approx((twice - slope.value) / 3, rel=1e-9)
    both = hoopgen.compare(
        (PLAYER, {"restitution": 0.7 - step}), (PLAYER, {"restitution": 0.7 + step}),
        shots=shots, seed=4,
    )  # fmt: skip
    assert slope.high - slope.low == pytest.approx((both.high - both.low) / (2 * step), rel=0.02)


def test_gravity_moves_the_release_of_an_aim_too() -> None:
    aim = {name: value for name, value in RELEASE.items() if name != "speed"} | {"aim": 0.05}
    player = hoopgen.Scatter(aim, SD)
    slope = hoopgen.estimate(player, shots=20_000, gradient=["gravity"]).gradient["gravity"]
    step = 9.81 * STEP
    made = [
        hoopgen.estimate(player, {"gravity": 9.81 + sign * step}, shots=20_000).probability
        for sign in (1, -1)
    ]
    assert slope.value == pytest.approx((made[0] - made[1]) / (2 * step), rel=1e-12)


def test_the_gradient_does_not_depend_on_chunks_threads_or_an_interruption(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = ("sd.speed", "restitution", "mean.elevation")
    whole = found(20_000, 0, names, threads=1)
    assert list(whole) == list(names)
    monkeypatch.setattr(monte_carlo, "CHUNK", 1 << 12)
    assert found(20_000, 0, names, threads=2) == whole
    folder = tmp_path / "chunks"
    found(6_000, 0, names, folder=folder)
    assert found(20_000, 0, names, folder=folder) == whole


def test_the_rest_of_an_estimate_is_as_without_a_gradient() -> None:
    options: dict[str, Any] = {"shots": 5_000, "measures": ["depth"]}
    plain = hoopgen.estimate(PLAYER, **options)
    more = hoopgen.estimate(PLAYER, gradient=["mean.speed", "restitution"], **options)
    record = more.as_dict()
    slopes = record.pop("gradient")
    assert record == plain.as_dict()
    assert set(slopes) == {"mean.speed", "restitution"}
    assert json.loads(json.dumps(slopes))["restitution"]["method"] == "difference"
    assert "gradient" not in str(plain)
    assert "mean.speed" in str(more)
    assert "per m/s" in str(more)


@pytest.mark.parametrize(
    ("names", "error", "said"),
    [
        ("mean.speed", TypeError, "gradient: expected names in a list or a mapping, got"),
        (["mean.speed"] * 2, ValueError, "gradient: expected each name once"),
        (["speed"], ValueError, "gradient: 'speed' is nothing that scatters; expected one of mean"),
        (["mean.backspin"], ValueError, "gradient: 'mean.backspin' is nothing that scatters"),
        (["median.speed"], ValueError, "gradient: 'median.speed' is nothing that scatters"),
    ],
)
def test_bad_names(names: Any, error: type[Exception], said: str) -> None:
    with pytest.raises(error) as refusal:
        hoopgen.estimate(PLAYER, shots=100, gradient=names)
    assert said in str(refusal.value)


def test_models_and_parameters_without_a_derivative_are_refused() -> None:
    measured = hoopgen.Resample(
        {"speed": [7.1, 7.2], "elevation": 0.9, "height": 2.1, "distance": 4.2}
    )
    for name in ("mean.speed", "speed", "restitution"):
        with pytest.raises(ValueError, match=rf"gradient: .* in jumps with {name}.*Scatter\.fit"):
            hoopgen.estimate(measured, shots=100, gradient=[name])
    random = hoopgen.Scatter(RELEASE, SD | {"restitution": 0.01})
    with pytest.raises(ValueError, match=r"gradient: restitution .* ask for mean\.restitution"):
        hoopgen.estimate(random, shots=100, gradient=["restitution"])
    assert hoopgen.estimate(random, shots=100, gradient=["mean.restitution"]).gradient
    with pytest.raises(ValueError, match="gradient: ring_friction is inf; expected a finite"):
        hoopgen.estimate(PLAYER, scene=hoopgen.COURT, shots=100, gradient=["ring_friction"])
    close = hoopgen.Scatter(RELEASE, SD, {("speed", "elevation"): 0.9999})
    with pytest.raises(ValueError, match="gradient: the correlations of speed are too close to 1"):
        hoopgen.estimate(close, shots=100, gradient=["mean.speed"])


SHOT = ["--speed", "7.17", "--elevation", "52deg", "--distance", "4.191", "--height", "2.1336"]
SHOT += ["--scatter", "speed=0.07", "--shots", "2000"]


def test_the_command_and_the_study_file(tmp_path: Path) -> None:
    asked = ["--gradient", "mean.speed", "--gradient", "restitution"]
    text = succeed("estimate", *SHOT, *asked).stdout
    assert "mean.speed" in text
    assert "difference, bias" in text
    record = json.loads(succeed("estimate", *SHOT, *asked, "--json").stdout)
    assert set(record["gradient"]) == {"mean.speed", "restitution"}
    assert "--gradient is of one setting, without --versus" in failure(
        "estimate", *SHOT, *asked, "--versus", "backspin=0"
    )
    pytest.importorskip("pydantic")
    file = tmp_path / "study.toml"
    file.write_text(
        '[study]\nname = "A player"\n[release]\nspeed = "7.17 m/s"\nelevation = "52 deg"\n'
        'distance = "4.191 m"\nheight = "2.1336 m"\n[scatter]\nspeed = "0.07 m/s"\n'
        '[[question]]\nname = "player"\nkind = "estimate"\nshots = 2000\n'
        'gradient = ["mean.speed", "restitution"]\n',
        encoding="utf-8",
    )
    out = tmp_path / "out"
    succeed("study", str(file), "--out", str(out))
    answer = json.loads((out / "player" / "answer.json").read_text("utf-8"))
    assert answer["numbers"]["gradient"] == record["gradient"]


def test_of_measured_releases_it_needs_a_fitted_scatter(tmp_path: Path) -> None:
    """A sample of 20 has derivatives almost nowhere; intervals of a fit do not contain it."""
    random = np.random.default_rng(6)
    rows = [
        f"{one},{angle},7,13.75" for one, angle in random.normal((7.17, 52), (0.07, 1), (20, 2))
    ]
    file = tmp_path / "few.csv"
    head = "speed_m_s,elevation_deg,height_ft,distance_ft"
    file.write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
    words = ("estimate", "--from", file, "--gradient", "restitution", "--shots", 1000)
    said = failure(*words)
    assert "--gradient" in said
    assert "--fitted" in said
    assert "--versus" in said
    text = succeed(*words, "--fitted").stdout
    assert "95% interval of the simulation alone  method" in text
    assert (
        "of the simulation alone  method"
        not in succeed("estimate", *SHOT, "--gradient", "restitution").stdout
    )


def share_slope(
    share: Callable[[float], float], differences: Differences, uniform: NDArray[np.float64]
) -> Slope:
    """Return the slope of shots that are made where their uniform number is below the share."""

    def simulated(value: float) -> Any:
        return SimpleNamespace(outcome=np.where(uniform < share(value), 0, 1))

    counts = difference_counts(simulated, differences, 0, 4)
    return difference_slopes({"it": differences}, counts, 0.95)["it"]


SIDES = [
    Differences(0.0, STEP),
    Differences(0.0, STEP, ONE_SIDED),
    Differences(0.0, -STEP, ONE_SIDED),
]


@pytest.mark.parametrize("differences", SIDES)
def test_differences_have_the_derivative_and_the_bias_of_a_cubic(differences: Differences) -> None:
    uniform = (np.arange(1 << 20) + 0.5) / (1 << 20)  # shares are exact to 2^-21
    slope = share_slope(lambda v: 0.3 + v + 5 * v**2 + 500 * v**3, differences, uniform)
    # Of the term in v^3 a central difference is 500 h^2, a one-sided one -1000 h^2.
    bias = 500 * STEP**2 * (1 if differences.places == CENTRAL else -2)
    rounding = 8 * 2.0**-21 / (2 * STEP)  # the coefficients of a difference add up to 8 at the most
    assert abs(slope.value - (1 + bias)) < rounding
    assert abs(slope.bias - bias) < rounding
    assert slope.low < slope.value < slope.high


@pytest.mark.parametrize("differences", SIDES)
def test_intervals_of_differences_contain_a_known_derivative_as_often_as_they_say(
    differences: Differences,
) -> None:
    """Demand 92% to 98% of 95% intervals; of a share in v and v^2 a difference has no bias."""
    runs, hits = 1000, 0  # the standard error is 0.7%
    generator = np.random.default_rng(3)
    for _ in range(runs):
        slope = share_slope(lambda v: 0.3 + 3 * v + 9 * v**2, differences, generator.random(4000))
        hits += slope.low <= 3 <= slope.high
    assert 0.92 * runs <= hits <= 0.98 * runs


@pytest.mark.parametrize("places", [CENTRAL, ONE_SIDED])
def test_an_interval_has_a_width_where_no_shot_changes(places: tuple[int, ...]) -> None:
    counts = np.zeros(COUNTS, np.int64)
    counts[[0, -1]] = 70, 30
    slope = difference_slopes({"restitution": Differences(0.65, 0.01, places)}, counts, 0.95)
    assert slope["restitution"].value == 0.0
    assert slope["restitution"].low < 0.0 < slope["restitution"].high


def test_without_a_valid_shot_the_interval_is_unknown_too() -> None:
    none = np.zeros(COUNTS, np.int64)
    slope = difference_slopes({"restitution": Differences(0.65, 0.01)}, none, 0.95)["restitution"]
    assert np.isnan([slope.value, slope.low, slope.high, slope.bias]).all()


@pytest.mark.parametrize(
    ("value", "limits", "step", "places"),
    [
        (0.7, (0, 1), 0.7 * STEP, CENTRAL),
        (0.995, (0, 1), (1 - 0.995) / 2, CENTRAL),
        (0.999, (0, 1), -0.999 * STEP, ONE_SIDED),
        (1.0, (0, 1), -STEP, ONE_SIDED),
        (0.0, (0, 1), STEP, ONE_SIDED),
        (-0.996, (-1, 1), (1 - 0.996) / 2, CENTRAL),
        (-1.0, (-1, 1), STEP, ONE_SIDED),
        (0.0, (-1, 1), STEP, CENTRAL),
    ],
)
def test_steps_stay_within_the_limits(
    value: float, limits: tuple[float, float], step: float, places: tuple[int, ...]
) -> None:
    found = differences_of(value, limits, lambda _: True)
    assert found is not None
    assert (found.step, found.places) == (pytest.approx(step, rel=1e-12), places)
    assert all(limits[0] <= each <= limits[1] for each in found.values)


@pytest.mark.parametrize(
    ("scene", "name", "value"),
    [
        (hoopgen.HOOP, "restitution", 0.995),
        (hoopgen.HOOP, "restitution", 1.0),
        (hoopgen.HOOP, "restitution", 0.0),
        (hoopgen.COURT, "inertia", 1.0),
        (hoopgen.COURT, "tangential_restitution", 1.0),
        (hoopgen.COURT, "ring_friction", 0.0),
    ],
)
def test_a_gradient_at_a_limit_differences_allowed_values(
    scene: hoopgen.Engine, name: str, value: float
) -> None:
    def made(moved: float) -> float:
        return hoopgen.estimate(PLAYER, {name: moved}, scene=scene, shots=4_000).probability

    found = hoopgen.estimate(PLAYER, {name: value}, scene=scene, shots=4_000, gradient=[name])
    slope = found.gradient[name]
    if value == 0.995:
        step = (1.0 - value) / 2
        expected = (made(value + step) - made(value - step)) / (2 * step)
    else:
        step = -STEP if value else STEP
        expected = (4 * made(value + step) - made(value + 2 * step) - 3 * found.probability) / (
            2 * step
        )
    assert slope.value == pytest.approx(expected, rel=1e-9, abs=1e-12)
    assert slope.low < slope.value < slope.high


def test_a_parameter_with_no_room_around_its_value_is_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("hoopgen.study.jobs.differences.differences_of", lambda *_: None)
    with pytest.raises(ValueError, match=r"gradient: restitution is 0\.7, and the values around"):
        hoopgen.estimate(PLAYER, shots=100, gradient=["restitution"])


@pytest.mark.parametrize("speed", [3.0, 7.17])
def test_a_score_says_nothing_if_no_shot_is_made(speed: float) -> None:
    player = hoopgen.Scatter(
        {"speed": speed, "elevation": 0.9, "height": 2.1336, "distance": 4.191}, {"speed": 0.07}
    )
    found = hoopgen.estimate(player, shots=500, gradient=("mean.speed",))
    slope = found.gradient["mean.speed"]
    assert np.isnan([slope.value, slope.low, slope.high]).all() == (found.made == 0)
