"""Releases through a point, through air and from places that move."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen.hoop.aiming import aimed
from hoopgen.hoop.flights import Flights
from hoopgen.hoop.parabolas import parabola_through
from hoopgen.hoop.releases import RING_HEIGHT

pytest.importorskip("sympy")  # which derives the scene in air

AIR = dict(hoopgen.PAPER_AIR)
THIN = AIR | {"air_density": 0.0}
LANDING = 1e-10
"""m: Newton's method ends below it; what it ends at is some 1e-14."""


def rows(count: int) -> tuple[dict[str, NDArray[np.float64]], NDArray[np.float64]]:
    """Return arguments of `aimed`, and elevations at which a parabola comes down."""
    random = np.random.default_rng(4)
    given = {
        "reach": random.uniform(1.5, 13.0, count),
        "rise": random.uniform(0.0, 2.0, count),
        "backspin": random.uniform(-20.0, 40.0, count),
        "sidespin": random.uniform(-15.0, 15.0, count),
    }
    steepest = np.arctan2(given["rise"], given["reach"])
    return given, steepest + random.uniform(0.25, 0.85, count) * (np.pi / 2 - steepest)


def landed(
    given: dict[str, NDArray[np.float64]], found: dict[str, NDArray[np.float64]]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return how far from the point the simulated flights come down, m, and their entry angles.

    They are flown a second time to the height of the point, without the time that was found.
    """
    states = hoopgen.release(
        found["speed"],
        found["elevation"],
        found["azimuth"],
        given["backspin"],
        given["sidespin"],
        height=RING_HEIGHT - given["rise"],
        distance=given["reach"],
    )
    _, ends = hoopgen.AIR.fall(states, 0.0, AIR)
    entry = np.arctan2(-ends[:, 5], np.hypot(ends[:, 3], ends[:, 4]))
    return np.hypot(ends[:, 0], ends[:, 1]), entry


@pytest.mark.slow
def test_flights_through_air_come_down_through_the_point() -> None:
    given, elevation = rows(300)
    found = aimed({"elevation": elevation}, **given, flights=Flights.at_hoop(AIR))
    _, possible = parabola_through(
        {"elevation": elevation}, given["reach"], given["rise"], np.float64(9.81)
    )
    assert possible.mean() > 0.6
    # Backspin lifts and drag steepens: at the flattest angles either alone may come down.
    assert np.isnan(found["speed"][possible]).mean() < 0.02
    there = np.isfinite(found["speed"])
    given = {name: one[there] for name, one in given.items()}
    found = {name: one[there] for name, one in found.items()}
    miss, entry = landed(given, found)
    assert miss.max() < LANDING
    np.testing.assert_allclose(entry, found["entry_angle"], rtol=0.0, atol=1e-10)


@pytest.mark.slow
def test_a_row_depends_on_no_other_row() -> None:
    given, elevation = rows(12)
    together = aimed({"elevation": elevation}, **given, flights=Flights.at_hoop(AIR))
    for row in (0, 5, 11):
        alone = aimed(
            {"elevation": elevation[row]},
            **{name: one[row] for name, one in given.items()},
            flights=Flights.at_hoop(AIR),
        )
        for name, value in alone.items():
            np.testing.assert_array_equal(value, together[name][row])


@pytest.mark.slow
def test_an_entry_angle_is_reached_through_air() -> None:
    given, _ = rows(20)
    wanted = np.linspace(0.7, 1.1, 20)
    found = aimed({"entry": wanted}, **given, flights=Flights.at_hoop(AIR))
    miss, entry = landed(given, found)
    assert miss.max() < LANDING
    np.testing.assert_allclose(entry, wanted, rtol=0.0, atol=1e-10)


@pytest.mark.slow
def test_the_slowest_release_through_air_is_slower_than_its_neighbours() -> None:
    given, _ = rows(6)
    slowest = aimed({}, **given, flights=Flights.at_hoop(AIR))
    assert landed(given, slowest)[0].max() < LANDING
    beside = [
        aimed({"elevation": slowest["elevation"] + off}, **given, flights=Flights.at_hoop(AIR))[
            "speed"
        ]
        for off in (-1e-3, 1e-3)
    ]
    assert np.all(slowest["speed"] < np.minimum(*beside))
    # The speed is even about its minimum but for the third order: 1e-9 of it here.
    np.testing.assert_allclose(beside[0], beside[1], rtol=1e-8, atol=0.0)


@pytest.mark.slow
def test_a_speed_has_a_high_and_a_low_flight_through_air() -> None:
    given, _ = rows(6)
    least = aimed({}, **given, flights=Flights.at_hoop(AIR))
    for more in (1.0001, 1.05):
        speed = {"speed": more * least["speed"]}
        high, low = (
            aimed(speed, **given, flights=Flights.at_hoop(AIR), arc=arc) for arc in ("high", "low")
        )
        assert np.all(high["elevation"] > least["elevation"])
        for one in (high, low):
            there = np.isfinite(one["elevation"])
            assert landed(given, one)[0][there].max() < LANDING
        assert np.all(low["elevation"][np.isfinite(low["elevation"])] < least["elevation"].max())
    slow = aimed({"speed": 0.999 * least["speed"]}, **given, flights=Flights.at_hoop(AIR))
    assert np.isnan(slow["elevation"]).all()


@pytest.mark.slow
def test_thin_air_has_the_parabolas_of_closed_form() -> None:
    given, elevation = rows(40)
    reach, rise, gravity = given["reach"], given["rise"], np.float64(AIR["gravity"])
    for wanted in ({"elevation": elevation}, {"entry": elevation}, {}):
        exact, possible = parabola_through(wanted, reach, rise, gravity)
        found = aimed(wanted, **given, flights=Flights.at_hoop(THIN))
        np.testing.assert_array_equal(np.isfinite(found["speed"]), possible)
        for name in ("speed", "elevation", "entry_angle", "time"):
            # The elevation of the least speed is known by differences, to some 1e-9.
            near = 1e-8 if not wanted else 1e-12
            np.testing.assert_allclose(
                found[name][possible], exact[name][possible], rtol=near, atol=0.0
            )
    assert np.all(found["azimuth"] == 0.0)


@pytest.mark.parametrize("parameters", [dict(hoopgen.PAPER), AIR], ids=["hoop", "air"])
def test_a_release_from_a_place_that_moves_has_the_velocity_of_one_at_rest(
    parameters: dict[str, float],
) -> None:
    """Without spin, the flight over the floor is that of a place at rest with the sum's speed."""
    elevation, moving = np.radians([48.0, 55.0, 62.0]), (np.float64(1.5), np.float64(-2.0))
    reach, rise = np.array([3.0, 5.0, 7.0]), np.array([0.9, 1.2, 0.5])
    flights = Flights.at_hoop(parameters)
    found = aimed({"elevation": elevation}, reach, rise, flights, moving=moving)
    level = found["speed"] * np.cos(found["elevation"])
    ahead = level * np.cos(found["azimuth"]) + moving[0]
    left = level * np.sin(found["azimuth"]) + moving[1]
    up = found["speed"] * np.sin(found["elevation"])
    np.testing.assert_allclose(left, 0.0, rtol=0.0, atol=1e-9)
    still = aimed({"elevation": np.arctan2(up, ahead)}, reach, rise, flights)
    np.testing.assert_allclose(still["speed"], np.hypot(up, ahead), rtol=1e-10, atol=0.0)


@pytest.mark.slow
def test_what_cannot_be_reached_is_nan_and_ends() -> None:
    wanted = {"elevation": np.array([0.1, -1.0, 1.5, np.nan, 0.9, 0.9])}
    reach = np.array([4.0, 4.0, 4.0, 4.0, -1.0, 400.0])
    found = aimed(wanted, reach, np.full(6, 1.0), Flights.at_hoop(AIR))
    np.testing.assert_array_equal(
        np.isfinite(found["speed"]), [False, False, True, False, False, False]
    )
    feather = Flights.at_hoop(AIR | {"ball_mass": 0.001})
    light = aimed({"elevation": np.float64(0.9)}, np.float64(4.0), np.float64(1.0), feather)
    assert np.isnan(light["speed"])
