"""`best_shots`: places, mirror images, and shares against direct estimates."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

for _library in ("pyarrow", "scipy", "xarray"):
    pytest.importorskip(_library)

import xarray as xr  # noqa: E402

import hoopgen  # noqa: E402
from hoopgen import NBA, Scatter  # noqa: E402
from hoopgen.core.units import DEGREE  # noqa: E402
from hoopgen.study.questions.best_shots import court_places  # noqa: E402
from hoopgen.study.questions.best_shots_result import describe_best_shots  # noqa: E402
from tests.helpers.commands import failure, output  # noqa: E402
from tests.helpers.effort import EFFORT, trials  # noqa: E402

pytestmark = pytest.mark.xdist_group("best_shots")  # the search is made once

PLAYER = Scatter(
    {"height": 2.13, "backspin": 18.0},
    {"speed": 0.07, "elevation": 1.3 * DEGREE, "azimuth": 1.0 * DEGREE},
)


@pytest.fixture(scope="module", autouse=True)
def some_places() -> Iterator[None]:
    """Leave the searches a line across the court, of places that mirror each other."""
    with pytest.MonkeyPatch.context() as patch:
        if EFFORT < 1:
            patch.setattr("hoopgen.study.questions.best_shots.court_places", places_across)
        yield


def places_across(step: float, parameters: Any) -> Any:
    """Return the places that are 3 m in front of the ring's centre."""
    places = court_places(step, parameters)
    return places[places[:, 0] == 3.0]


@pytest.fixture(scope="module")
def found() -> Any:
    return hoopgen.best_shots(PLAYER, NBA, step=3.0, shots=2_000)


def test_places_are_within_the_lines_and_mirror_each_other() -> None:
    for step in (0.5, 1.5, 3.0):
        x, y = court_places(step, NBA).T
        assert np.abs(y).max() + 0.5 * step <= 25 * 0.3048 + 1e-9
        assert np.hypot(x, y).min() >= 1.2
        assert {(a, -b) for a, b in zip(x, y, strict=True)} == set(zip(x, y, strict=True))


@pytest.mark.slow
def test_each_share_is_that_of_the_release(found: Any) -> None:
    """Shares with other random numbers, of any way in, are within the errors of both."""
    for row in range(0, found.sizes["place"], 4):
        one = {name: float(found[name].values[row]) for name in ("x", "y", "speed", "elevation")}
        one["azimuth"] = float(found["azimuth"].values[row])
        again = hoopgen.estimate(
            Scatter({**PLAYER.release, **one}, PLAYER.sd), NBA, shots=40_000, seed=9
        ).probability
        share = float(found["probability"].values[row])
        # Of one way alone, it is a little less than of both.
        assert -5 * 0.011 < again - share < 5 * 0.011 + 0.02
        assert found["low"].values[row] <= share <= found["high"].values[row]


@pytest.mark.slow
def test_no_other_angle_is_much_better(found: Any) -> None:
    at = (found["x"].values == 3.0) & (found["y"].values == 0.0)
    best = float(found["probability"].values[at][0])
    release = {**PLAYER.release, "distance": 3.0, "aim": 0.05}
    for angle in np.radians([45, 50, 55, 60, 65]):
        other = Scatter({**release, "elevation": angle}, PLAYER.sd)
        assert hoopgen.estimate(other, NBA, shots=20_000, seed=3).probability < best + 0.04


@pytest.mark.slow
def test_left_mirrors_right(found: Any) -> None:
    rows = {
        (x, y): k for k, (x, y) in enumerate(zip(found["x"].values, found["y"].values, strict=True))
    }
    for (x, y), row in rows.items():
        other = rows[x, -y]
        assert found["speed"].values[row] == found["speed"].values[other]
        if y:
            assert found["azimuth"].values[row] == -found["azimuth"].values[other]


@pytest.mark.slow
def test_the_same_seed_gives_the_same_and_the_second_search_says_how_far(found: Any) -> None:
    again = hoopgen.best_shots(PLAYER, NBA, step=3.0, shots=2_000, threads=1)
    assert again.identical(found)
    known = np.isfinite(found["speed_change"].values)
    assert known.any()
    assert np.abs(found["probability_change"].values[known]).max() < 0.08
    assert "A second search changes" in describe_best_shots(found)
    assert f"Seed: {found.attrs['seed']}." in describe_best_shots(found)


@pytest.mark.slow
def test_in_air_the_best_shot_is_faster_and_its_share_that_of_the_release(
    found: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    one = np.array([[3.0, 0.0]])
    monkeypatch.setattr("hoopgen.study.questions.best_shots.court_places", lambda *_: one)
    in_air = hoopgen.best_shots(PLAYER, hoopgen.NBA_AIR, scene=hoopgen.AIR, step=3.0, shots=2_000)
    row = (found["x"].values == 3.0) & (found["y"].values == 0.0)
    speed = in_air["speed"].item()
    assert 1.0 < speed / found["speed"].values[row].item() < 1.06
    assert abs(in_air["aim"].item()) < 0.2
    release = {name: in_air[name].item() for name in ("x", "y", "speed", "elevation", "azimuth")}
    model = Scatter({**PLAYER.release, **release}, PLAYER.sd)
    again = hoopgen.estimate(model, hoopgen.NBA_AIR, scene=hoopgen.AIR, shots=20_000, seed=9)
    # Of one way alone, the share is a little less than of both.
    assert -5 * 0.011 < again.probability - in_air["probability"].item() < 5 * 0.011 + 0.02


@pytest.mark.parametrize(
    ("player", "options", "said"),
    [
        (PLAYER, {"makes": 0.7}, "makes: it is of the default player"),
        (3, {}, "player: expected a Scatter"),
        (Scatter({"backspin": 18.0}, {"speed": 0.1}), {}, "player: it needs a release height"),
        (PLAYER, {"step": 0.1}, "step: expected a distance from 0.5 to 3 m"),
        (PLAYER, {"seed": -1}, "seed"),
    ],
)
def test_what_cannot_be_searched_is_refused(player: Any, options: Any, said: str) -> None:
    with pytest.raises((TypeError, ValueError), match=said):
        hoopgen.best_shots(player, NBA, **options)


@pytest.mark.slow
def test_the_command_prints_and_draws(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("matplotlib")
    places = court_places(3.0, NBA)
    if EFFORT < 1:
        places = places[(places == [3.0, 0.0]).all(axis=1)]
        monkeypatch.setattr("hoopgen.study.questions.best_shots.court_places", lambda *_: places)
    words = ("best", "--makes", "80%", "--preset", "nba", "--step", "3m", "--shots", 200)
    text = output(*words, "--units", "us", "--picture", tmp_path / "best.svg")
    said = "A player who makes 80% of free throws: a release 7.0 ft up with 180 rpm of backspin"
    assert said in text
    assert "Scene: NBA." in text
    assert "speed (mph)" in text
    assert "lead (points)" in text
    assert (tmp_path / "best.svg").stat().st_size > 10_000
    record = json.loads(output(*words, "--json"))
    assert len(record["places"]["speed_m_s"]) == len(places) == len(record["places"]["x_m"])
    assert record["step_m"] == 3.0
    assert record["player"]["release"]["height_m"] == pytest.approx(2.1336)
    metres = output(*words)
    assert "a release 2.134 m up with 3.00 Hz of backspin" in metres
    assert "speed (m/s)" in metres
    assert "give --from" in failure("best", "--where", "player == Ann")


@pytest.mark.slow
def test_the_second_search_chooses_the_way(found: Any) -> None:
    """A way chosen by the shares that are reported would make them too large."""
    rows = np.flatnonzero(found["y"].values >= 0.0)[: trials(3)]
    spots = np.stack([found["x"].values[rows], found["y"].values[rows]], axis=1)
    held = Scatter(PLAYER.release, PLAYER.sd)
    first, other = (
        hoopgen.bank_or_direct(held, spots, NBA, shots=2_000, seed=seed) for seed in (0, 2)
    )
    way = np.argmax(other["probability"].values, axis=0)
    shares = first["probability"].values[way, np.arange(len(rows))]
    assert (found["probability"].values[rows] == shares).all()
    lead = first["difference"].values * np.where(way, 1, -1)
    assert (found["lead"].values[rows] == lead).all()
    ends = np.array([first[f"difference_{end}"].values for end in ("low", "high")])
    low, high = np.where(way, ends, -ends[::-1])
    assert (found["lead_low"].values[rows] == low).all()
    assert (found["lead_high"].values[rows] == high).all()
    assert (found["decided"].values[rows] == (low > 0)).all()


def searched(differences: list[float], half: float) -> Any:
    """Return results of `bank_or_direct` with these differences, bank less direct."""
    lead = np.array(differences)
    shares = np.stack([0.6 - lead / 2, 0.6 + lead / 2])
    names = ("speed", "elevation", "azimuth", "aim", "probability", "low", "high")
    return xr.Dataset(
        dict.fromkeys(names, (("way", "place"), shares))
        | {"difference": ("place", lead)}
        | {"difference_low": ("place", lead - half), "difference_high": ("place", lead + half)}
    )


def test_a_way_that_the_shots_do_not_tell_or_speak_against_is_not_decided(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The second search chooses bank, bank, direct and direct."""
    answers = iter([searched([0.2, 0.01, 0.2, -0.2], 0.05), searched([0.1, 0.1, -0.1, -0.1], 0.3)])
    module = "hoopgen.study.questions.best_shots."
    monkeypatch.setattr(f"{module}bank_or_direct", lambda *_, **__: next(answers))
    monkeypatch.setattr(f"{module}court_places", lambda *_: np.arange(8.0).reshape(4, 2))
    found = hoopgen.best_shots(PLAYER, NBA)
    assert found["bank"].values.tolist() == [True, True, False, False]
    assert found["decided"].values.tolist() == [True, False, False, True]
    np.testing.assert_allclose(found["lead"], [0.2, 0.01, -0.2, 0.2], rtol=0, atol=1e-15)
    np.testing.assert_allclose(found["lead_low"], [0.15, -0.04, -0.25, 0.15], rtol=0, atol=1e-15)
    np.testing.assert_allclose(found["lead_high"], [0.25, 0.06, -0.15, 0.25], rtol=0, atol=1e-15)
    np.testing.assert_allclose(found["lead_change"], [-0.1, 0.09, np.nan, -0.1], rtol=0, atol=1e-15)
    assert (
        "At 2 of 4 places the shots do not tell whether bank or direct is better, and at 1 of them "
        "they speak for the other: the lead of one over the other is known to ±5.0 points."
    ) in describe_best_shots(found)
    assert "do not tell" not in describe_best_shots(found.isel(place=[0, 3]))


@pytest.mark.slow
def test_a_place_on_the_whole_hoop(monkeypatch: pytest.MonkeyPatch) -> None:
    """The share is that of the release in `COURT`, whose friction and edges change the shot."""
    pytest.importorskip("matplotlib")
    place = np.array([[3.0, 0.0]])
    monkeypatch.setattr("hoopgen.study.questions.best_shots.court_places", lambda *_: place)
    whole = {"scene": hoopgen.COURT}
    found = hoopgen.best_shots(PLAYER, hoopgen.NBA_COURT, step=3.0, shots=1_000, **whole)
    one = {name: found[name].item() for name in ("x", "y", "speed", "elevation", "azimuth")}
    model = Scatter({**PLAYER.release, **one}, PLAYER.sd)
    again = hoopgen.estimate(model, hoopgen.NBA_COURT, shots=40_000, seed=9, **whole)
    # Of one way alone, it is a little less than of both.
    assert -5 * 0.016 < again.probability - found["probability"].item() < 5 * 0.016 + 0.02
    assert found["speed"].attrs["units"] == "m/s"
    assert "Scene: court, NBA." in describe_best_shots(found)
    assert json.loads(found.attrs["parameters"])["ring_friction"] == 0.5
    hoopgen.plots.plot_best_shots(found)
