"""Questions about players in air: margins, optimum, bank or direct, coach."""

from __future__ import annotations

import numpy as np
import pytest

import hoopgen
from hoopgen import PAPER_AIR, Scatter
from hoopgen.study.questions.coach import coach
from hoopgen.study.questions.margins import margins

pytest.importorskip("sympy")  # which derives the scene in air

pytestmark = pytest.mark.xdist_group("air")

PLACE = {"height": 2.13, "distance": 4.191, "backspin": 18.0}
SD = {"speed": 0.05, "elevation": 0.01, "azimuth": 0.01}


def made(release: dict[str, float], name: str, value: float) -> bool:
    states = hoopgen.release(**{**release, name: value})
    return bool(hoopgen.AIR.simulate(states, PAPER_AIR).made[0])


@pytest.mark.slow
def test_a_margin_in_air_ends_where_the_shot_no_longer_goes_in() -> None:
    found = hoopgen.aim(
        height=2.13, distance=4.191, elevation=0.9, backspin=18.0, scene=hoopgen.AIR
    )
    release = {name: float(value) for name, value in found.arguments.items()}
    model = Scatter({**PLACE, "elevation": 0.9, "aim": 0.0})
    margin = margins(model, PAPER_AIR, scene=hoopgen.AIR, names=["speed"], shots=1)["speed"]
    np.testing.assert_allclose(margin.value, release["speed"], rtol=1e-12, atol=0.0)
    assert made(release, "speed", margin.low)
    assert made(release, "speed", margin.high)
    assert not made(release, "speed", margin.low - 1e-9)
    assert not made(release, "speed", margin.high + 1e-9)


@pytest.mark.slow
def test_an_optimum_in_air_aims_along_flights_through_air() -> None:
    model = Scatter({**PLACE, "elevation": 0.95}, SD)
    best = hoopgen.optimum(
        model, {"aim": (-0.1, 0.2)}, scene=hoopgen.AIR, by="direct", shots=300, margins=()
    )
    assert best.scene is hoopgen.AIR
    found = hoopgen.aim(
        height=2.13,
        distance=4.191,
        elevation=0.95,
        backspin=18.0,
        depth=best.release["aim"],
        scene=hoopgen.AIR,
    )
    np.testing.assert_allclose(best.arguments["speed"], found.speed, rtol=1e-12, atol=0.0)
    np.testing.assert_allclose(best.depth, best.release["aim"], rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(best.entry_angle, found.entry_angle, rtol=0.0, atol=1e-9)
    assert best.probability > 0.7


@pytest.mark.slow
def test_bank_or_direct_takes_a_scene_in_air() -> None:
    model = Scatter({"height": 2.13, "backspin": 18.0, "elevation": 0.95, "azimuth": 0.0}, SD)
    places = [[3.0, 0.0]]
    over = {"aim": (-0.1, 1.2)}
    found = hoopgen.bank_or_direct(model, places, scene=hoopgen.AIR, over=over, shots=200)
    assert found.attrs["scene"].startswith("air")
    assert found["probability"].sel(way="direct").item() > 0.7
    assert found["probability"].sel(way="bank").item() > 0.2
    for way in ("direct", "bank"):
        depth = found["aim"].sel(way=way).item()
        aimed = hoopgen.aim(
            height=2.13, distance=3.0, elevation=0.95, backspin=18.0, depth=depth, scene=hoopgen.AIR
        )
        speed = found["speed"].sel(way=way).item()
        np.testing.assert_allclose(speed, aimed.speed, rtol=1e-12, atol=0.0)


@pytest.mark.slow
def test_a_coach_in_air_moves_the_point_that_a_measured_player_aims_at() -> None:
    """In air the point is where the flight through air comes down, not the parabola's."""
    found = hoopgen.aim(
        height=2.13, distance=4.191, elevation=0.9, backspin=18.0, depth=0.05, scene=hoopgen.AIR
    )
    release = {name: float(value) for name, value in found.arguments.items()}
    said = coach(Scatter(release, SD), scene=hoopgen.AIR, shots=200)
    aim = said.player.release["aim"]
    np.testing.assert_allclose(aim, 0.05, rtol=0.0, atol=1e-9)
