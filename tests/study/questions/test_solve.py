"""`solve`: the factor times a scatter with which a wanted share is made, and how sure it is."""

from __future__ import annotations

import json
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.helpers.commands import run

for _library in ("pyarrow", "scipy"):
    pytest.importorskip(_library)

import hoopgen  # noqa: E402
from hoopgen import Resample, Scatter, estimate, solve  # noqa: E402
from hoopgen.study.models.requirements import scaled  # noqa: E402
from hoopgen.study.named_units import in_units  # noqa: E402
from hoopgen.study.questions.solve import FACTORS  # noqa: E402

DEGREE = math.pi / 180
RELEASE = {
    "aim": 0.05,
    "elevation": 52 * DEGREE,
    "backspin": 6 * math.pi,
    "height": 2.1336,
    "distance": 4.191,
}
SD = {"speed": 0.07, "elevation": 1.3 * DEGREE, "azimuth": DEGREE}
PLAYER = Scatter(RELEASE, SD, {("speed", "elevation"): -0.3})
SCENE = hoopgen.NBA | {"restitution": 0.75}


def of_player(share: float = 0.7, **options: Any) -> Any:
    return solve(PLAYER, share, SCENE, **{"shots": 2000, **options})


@pytest.mark.sampled(1)
@pytest.mark.parametrize("factor", [0.4, 1.0, 3.0])
def test_it_finds_the_factor_that_a_share_comes_from(factor: float) -> None:
    truth = estimate(scaled(PLAYER, factor), SCENE, shots=200_000, seed=9)
    found = of_player(truth.probability, shots=20_000, confidence=0.999)
    assert found.low < found.factor < found.high
    assert found.high - found.low < 0.15 * factor
    assert found.low <= factor <= found.high
    assert found.elsewhere == []


@pytest.mark.slow
def test_the_interval_has_the_truth_in_it_as_often_as_it_says() -> None:
    truth = estimate(PLAYER, SCENE, shots=400_000, seed=2**40).probability
    seeds = range(40)
    found = [of_player(truth, shots=400, seed=seed, confidence=0.8) for seed in seeds]
    covered = sum(one.low <= 1.0 <= one.high for one in found)
    # Binomial, 40 tries of 0.8: 32 ± 2.5, within three of these.
    assert abs(covered - 32) <= 3 * math.sqrt(40 * 0.8 * 0.2)


def test_at_the_ends_of_the_interval_the_share_s_own_interval_ends() -> None:
    found = of_player(shots=4000)
    for end, side in ((found.low, -1), (found.high, 1)):
        inside, outside = (
            estimate(scaled(PLAYER, end * (1 - side * off)), SCENE, shots=4000)
            for off in (2e-3, -2e-3)
        )
        assert inside.low <= 0.7 <= inside.high
        assert not outside.low <= 0.7 <= outside.high


def test_the_estimate_is_that_of_fresh_shots_with_the_scaled_scatter() -> None:
    found = of_player()
    model = Scatter(
        RELEASE, {name: found.factor * sd for name, sd in SD.items()}, PLAYER.correlation
    )
    assert found.model == model
    assert found.estimate == estimate(model, SCENE, shots=2000, seed=1)
    same = estimate(model, SCENE, shots=2000, seed=0)
    assert abs(same.probability - 0.7) < 2 / 2000  # a shot or two: that is how it was found


@pytest.mark.sampled(1)
@pytest.mark.parametrize("how", [{"threads": 1}, {"threads": 3}, {"backend": "numpy"}])
def test_whoever_computes_it_is_the_same(how: dict[str, Any]) -> None:
    assert of_player(shots=300, **how) == of_player(shots=300)


def test_a_folder_is_gone_on_from_and_of_one_question(tmp_path: Path) -> None:
    wanted = of_player(shots=300, folder=tmp_path)
    files = {file.name: file.read_bytes() for file in tmp_path.iterdir()}
    for lost in sorted(tmp_path.glob("chunk-*"))[7:]:
        lost.unlink()
    assert of_player(shots=300, folder=tmp_path) == wanted
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == files
    for other in ({"shots": 301}, {"share": 0.71}, {"seed": 1}, {"max_contacts": 39}):
        with pytest.raises(ValueError, match="holds another job"):
            of_player(**{"shots": 300, "folder": tmp_path, **other})


def test_measured_releases_keep_their_means() -> None:
    random = np.random.default_rng(4)
    columns = {
        "speed": random.normal(7.2, 0.1, 50),
        "elevation": random.normal(0.9, 0.02, 50),
        "height": 2.1,
        "distance": 4.191,
    }
    model = Resample(columns)
    twice = scaled(model, 2.0)
    assert isinstance(twice, Resample)
    assert twice.columns["height"] == 2.1
    for name in ("speed", "elevation"):
        mean, column = model.centre[name], np.asarray(columns[name])
        # A sum of doubles of some units: each off by a few eps.
        np.testing.assert_allclose(twice.columns[name], 2 * column - mean, rtol=4e-16, atol=4e-15)
    here = estimate(scaled(model, 0.5), SCENE, shots=20_000, seed=5).probability
    found = solve(model, here, SCENE, shots=5000)
    assert found.low <= 0.5 <= found.high
    assert "how far each measured release is from their means, times that" in str(found)
    assert found.as_dict()["model"]["model"] == "resample"


LONG = Scatter({**RELEASE, "aim": 0.22}, SD)
"""Aimed too far: without scatter missed, with more and more made more often, and then less."""


def test_where_the_share_rises_and_falls_the_nearest_to_1_is_taken_and_others_are_said() -> None:
    without, little, much = (
        estimate(scaled(LONG, factor), SCENE, shots=4000).probability for factor in (0, 1, 4)
    )
    share = 0.2
    assert without == 0.0
    assert little > share > much
    found = solve(LONG, share, SCENE, shots=4000)
    (other,) = found.elsewhere
    assert abs(math.log(found.factor)) < abs(math.log(other))
    assert f"so it is with {other:.3g} times the scatter, too" in str(found)
    assert found.as_dict()["elsewhere"] == [other]
    for factor in (found.factor, other):
        there = estimate(scaled(LONG, factor), SCENE, shots=4000).probability
        assert abs(there - share) < 2 / 4000


def test_where_the_share_jumps_past_the_wanted_one_that_is_said() -> None:
    """The share of four measured releases is a multiple of a quarter, whatever the factor."""
    speed, elevation = [7.1, 7.2, 7.15, 7.3], np.radians([52.0, 51.0, 53.0, 52.0])
    model = Resample({"speed": speed, "elevation": elevation, "height": 2.1336, "distance": 4.191})
    found = solve(model, 0.7, shots=2_000)
    assert found.low == found.factor == found.high
    said = f"{found.factor:.3g} times the scatter, where the share jumps past 70% made"
    assert found.line == said
    assert str(found).startswith(f"factor   {said}\nthrown ")


def test_an_interval_may_reach_no_scatter_and_more_than_is_tried() -> None:
    nearly = of_player(0.9995, shots=500)
    assert nearly.low == 0.0
    widest = estimate(scaled(PLAYER, FACTORS[-1]), SCENE, shots=500).probability
    found = of_player(widest + 0.002, shots=500)
    assert found.high == math.inf
    assert "or more, for" in found.line
    assert found.as_dict()["high"] == "inf"


@pytest.mark.parametrize(
    ("model", "share", "said"),
    [
        (LONG, 0.95, r"95% made is reached by no factor from 0 to 16: at most \d.*; 0.0% without"),
        (PLAYER, 1e-4, r"0.01% made is reached by no factor .* at least .* with 16 times the sc"),
        (Scatter({**RELEASE, "aim": 3.0}, {"speed": 1e-4}), 0.5, "at most 0.0% without scatter$"),
        (Scatter(RELEASE), 0.7, "model: nothing scatters, .* give sd, --scatter$"),
        (Scatter(RELEASE, {"speed": 0.0}), 0.7, "model: nothing scatters"),
        (PLAYER, 0.0, "share: expected a number within 0 and 1, got 0.0"),
        (PLAYER, 70, "share: expected a number within 0 and 1, got 70"),
        (
            Resample({"speed": [math.nan], "elevation": 0.9, "height": 2.0, "distance": 4.0}),
            0.5,
            "model: no shot is valid, with any factor",
        ),
    ],
)
def test_what_cannot_be_is_said(model: Any, share: float, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        solve(model, share, SCENE, shots=2000)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"seed": 2**64 - 1}, r"seed: expected 2\*\*64 - 2 at most"),
        ({"shots": 0}, "shots: expected a whole number from 1"),
        ({"confidence": 1.0}, "confidence: expected a number within 0 and 1"),
        ({"by": "swish"}, "by: expected made"),
        ({"max_contacts": 0}, "max_contacts: expected"),
    ],
)
def test_arguments_are_looked_at_before_a_folder_is_made(
    change: dict[str, Any], said: str, tmp_path: Path
) -> None:
    with pytest.raises(ValueError, match=said):
        of_player(**change, folder=tmp_path / "kept")
    assert not (tmp_path / "kept").exists()


def test_a_model_must_be_one_that_can_be_scaled() -> None:
    grid = hoopgen.Grid({name: [value] for name, value in (RELEASE | {"aim": 0.0}).items()})
    with pytest.raises(TypeError, match="model: expected a Scatter or a Resample"):
        solve(grid, 0.5)  # type: ignore[arg-type]


def test_no_angle_scatters_by_half_a_radian() -> None:
    """An angle so large would be taken for degrees, so greater factors are left out."""
    wide = Scatter(RELEASE, {"azimuth": 0.3})
    found = solve(wide, 0.4, SCENE, shots=300)
    assert found.factor < 1.0
    with pytest.raises(ValueError, match=r"reached by no factor from 0 to 1\.41"):
        solve(wide, 1e-3, SCENE, shots=300)


def test_it_asks_the_court_too() -> None:
    found = solve(PLAYER, 0.7, hoopgen.NBA_COURT, scene=hoopgen.COURT, shots=1000)
    assert found.low < found.factor < found.high
    assert found.estimate.scene is hoopgen.COURT


# In words


def test_a_solution_in_words() -> None:
    found = of_player()
    first, second, empty, *rest = str(found).splitlines()
    assert first == (
        f"factor   {found.factor:.3f} times the scatter, {found.low:.3f} to {found.high:.3f}, "
        "for 70% made (95% interval)"
    )
    assert second.startswith("thrown   2,000 shots with each factor, seed 0;")
    assert (empty, "\n".join(rest)) == ("", str(found.estimate))
    assert f"scatter  speed {found.factor * 0.07:.6g} m/s" in str(found)
    assert json.loads(json.dumps(found.as_dict(), allow_nan=False)) == found.as_dict()
    assert found.to_pandas()["factor"][0] == found.factor


OPTIONS = [
    *["estimate", "--aim", "5cm", "--elevation", "52deg", "--height", "7ft", "--backspin", "3Hz"],
    *["--distance", "13.75ft", "--preset", "nba", "--set", "restitution=0.75"],
    *["--scatter", "speed=0.07", "--scatter", "elevation=1.3deg", "--scatter", "azimuth=1deg"],
    *["--correlation", "speed,elevation=-0.3", "--shots", "500"],
]


@pytest.mark.sampled(1)
@pytest.mark.parametrize("share", ["70%", "0.7", " 70 %"])
def test_the_command_says_and_writes_what_the_library_gives(share: str) -> None:
    wanted = of_player(shots=500)
    text = run(*OPTIONS, "--solve", share)
    assert (text.exit_code, text.stdout) == (0, f"{wanted}\n")
    record = json.loads(run(*OPTIONS, "--solve", share, "--json").stdout)
    assert record == in_units(wanted.as_dict())
    assert record["model"]["sd"]["speed_m_s"] == wanted.factor * 0.07


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (["--solve", "100"], "'100' is no share above 0% and below 100%: expected one such as 70%"),
        (["--solve", "100%"], "'100%' is no share"),
        (["--solve", "7%0"], "'7%0' is no share"),
        (["--solve", "most"], "'most' is not a number"),
        (["--solve", "70%", "--versus", "backspin=0"], "--solve and --versus ask different"),
        (["--solve", "70%", "--precision", "0.01"], "--solve and --precision ask different"),
        (["--solve", "0.1%"], "--solve: 0.1% made is reached by no factor"),
    ],
)
def test_what_is_wrong_on_the_command_line_is_said(more: list[str], said: str) -> None:
    result = run(*OPTIONS, *more)
    assert (result.exit_code, result.stdout) == (2, "")
    assert said in result.stderr
    assert result.stderr.count("\n") == 1


# In a study file


def test_a_study_file_asks_it(tmp_path: Path) -> None:
    pytest.importorskip("pydantic")
    file = tmp_path / "study.toml"
    file.write_text(
        """
        study.name = "Seven of ten"
        scene = { preset = "nba", restitution = 0.75 }
        release.aim = 0.05
        release.elevation = "52 deg"
        release.backspin = "3 Hz"
        release.height = "7 ft"
        release.distance = "13.75 ft"
        scatter = { speed = 0.07, elevation = "1.3 deg", azimuth = "1 deg" }
        correlation.speed.elevation = -0.3

        [[question]]
        kind = "solve"
        name = "player"
        share = 0.7
        shots = 500
        """,
        encoding="utf-8",
    )
    answer = hoopgen.run_study(file)["player"]
    wanted = of_player(shots=500)
    assert answer.line == wanted.line
    assert answer.numbers == in_units(wanted.as_dict())
    report = (tmp_path / "study-results" / "report.md").read_text(encoding="utf-8")
    assert re.search(r"\| \[player\]\(#player\) \| \d\.\d+ times the scatter, ", report)
    file.write_text(file.read_text().replace("0.7\n", "1.7\n"))
    from hoopgen.studyfile.reading import StudyError

    with pytest.raises(StudyError, match=r"above 0 and below 1; got 1\.7"):
        hoopgen.run_study(file)
    text = file.read_text().replace("1.7\n", "0.7\n").replace("scatter = {", 'scatter = "none" #')
    file.write_text(re.sub("correlation.*", "", text))
    with pytest.raises(StudyError, match="model: nothing scatters"):
        hoopgen.run_study(file)
