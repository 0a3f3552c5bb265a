"""The lemmas of planes: which arrivals are decided, how late they are, and what of their place.

A computed flight and a true one differ by as much as decisions allow for. What the kernels decide
of the one is compared with the other at fifty digits.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.events import event_polynomials, plane, plane_start, search_for
from hoopgen.derive.events.predicates import KERNELS
from hoopgen.derive.scenes import HOOP
from mpmath import mp, mpf
from numpy.typing import NDArray

from tests.derive.test_evaluation import PARAMETERS, digits, in_doubles
from tests.helpers.effort import occurrences, trials

Floats = NDArray[np.float64]

PLANES = {1: HOOP.surfaces[1], 2: HOOP.surfaces[2], 3: HOOP.end_planes[0]}
"""Board, bridge and end plane, by index."""
LEVELS = {
    1: PARAMETERS["ball_radius"] - PARAMETERS["board_distance"],
    2: PARAMETERS["ball_radius"] + PARAMETERS["wire_radius"],
    3: -PARAMETERS["end_depth"],
}
AXES = {1: "x", 2: "z", 3: "z"}
SIZES = (2.0**-50, 2.0**-40, 2.0**-30, 2.0**-14)
"""Errors of the place that are tried, m."""


def flights(index: int, count: int, ratios: tuple[float, ...]) -> dict[str, Any]:
    """Return computed flights by or to a plane, and the true place and velocity across it.

    Parameters
    ----------
    index
        The index of the plane.
    count
        How many.
    ratios
        Errors of the velocity over those of the place, 1/s.
    """
    rng = np.random.default_rng(40 + index)
    place = rng.choice(SIZES, count)
    speed = place * rng.choice(ratios, count)
    gap = place * 10 ** rng.uniform(-1, 12, count) * rng.choice([-1, 1], count)
    rate = 10 ** rng.uniform(-12, 1, count) * rng.choice([-1, 1], count)
    same = rng.random(count) < 0.3
    rate = np.where(same, speed * rng.uniform(-4, 4, count), rate)
    if index != 1:
        # The apex is at the plane to within some errors.
        graze = (rng.random(count) < 0.3) & (rate > 0)
        off = place * rng.uniform(-20, 20, count)
        gap = np.where(graze, off - rate**2 / (2 * PARAMETERS["gravity"]), gap)
    gap = np.where(np.abs(gap) < 10, gap, 0.5 * np.sign(gap))
    zeros = np.zeros(count)
    values: dict[str, Any] = PARAMETERS | dict.fromkeys(("x", "y", "z", "vx", "vy", "vz"), zeros)
    axis = AXES[index]
    values |= {axis: LEVELS[index] + gap, f"v{axis}": rate}
    values |= {"position_error": place, "velocity_error": speed, "leaving": zeros, "last": zeros}
    values["extent"], values["speed"] = np.abs(values[axis]), np.abs(rate)
    signs = rng.choice([-1.0, -1.0, 0.0, 1.0, 1.0], (2, count))
    return values | {"true_place": signs[0] * place, "true_rate": signs[1] * speed}


def decided(index: int, values: Mapping[str, Any], until: Any = 1.0) -> dict[str, Any]:
    """Return what the kernels find of the arrival, and from when on it is undecided."""
    own, flight = PLANES[index], HOOP.flight
    search = search_for(own, flight)
    assert isinstance(search, plane.PlaneSearch)
    found = dict(values) | in_doubles(plane.plane_arrival(own, flight), values)  # type: ignore[arg-type]
    found |= {"when": until, "earliest_delay": 0.0, "rate_margin": 0.0}
    root, side = (
        ("level_root", "side_undecided") if index == 1 else ("plane_root", "apex_undecided")
    )
    found |= in_doubles(dict(KERNELS[root].outputs), found)
    found |= {"horizon": found["nearest"]}
    found |= in_doubles({"margin": plane.plane_margin(own, flight)}, found)  # type: ignore[arg-type]
    found |= in_doubles(event_polynomials.crossing(), found)
    count = len(found["time"])
    found |= {"undecided_time": np.full(count, np.inf), "arrives": found["arrives"].astype(bool)}
    start = plane_start.plane_start([own], flight) if index != 1 else None  # type: ignore[list-item]
    for kernel in (KERNELS[side], KERNELS["crossing_undecided"], start):
        if kernel is not None:
            found |= in_doubles(dict(kernel.outputs), found)
    return found


def crossing_of(index: int, values: Mapping[str, Any], row: int) -> mpf | None:
    """Return when the true ball falls through a plane, if it does."""
    axis, own = AXES[index], {n: v for n, v in values.items() if np.ndim(v)}
    level = {
        1: mpf(PARAMETERS["ball_radius"]) - mpf(PARAMETERS["board_distance"]),
        2: mpf(PARAMETERS["ball_radius"]) + mpf(PARAMETERS["wire_radius"]),
        3: -mpf(PARAMETERS["end_depth"]),
    }[index]
    gap = mpf(float(own[axis][row])) + mpf(float(own["true_place"][row])) - level
    rate = mpf(float(own[f"v{axis}"][row])) + mpf(float(own["true_rate"][row]))
    if index == 1:
        return -gap / rate if rate < 0 <= gap else None
    gravity = mpf(PARAMETERS["gravity"])
    squared = rate**2 + 2 * gravity * gap
    if squared < 0:
        return None
    time = (rate + mp.sqrt(squared)) / gravity
    return time if time >= 0 else None


@pytest.mark.parametrize("index", PLANES)
def test_a_decided_arrival_is_one_of_the_true_ball_and_within_a_third_of_its_delay(
    index: int,
) -> None:
    """A true one is later than half the time, and none comes without one that is computed."""
    values = flights(index, trials(4000), (0.0, 1.0, 64.0, 2.0**12))
    found = decided(index, values)
    sure = np.isinf(found["undecided_time"])
    most, least, none = mpf(0), mpf(1), 0
    with digits(50):
        for row in np.flatnonzero(sure):
            time = crossing_of(index, values, row)
            if not found["arrives"][row]:
                none += 1
                # Of the board the flight's end is 1 s.
                assert time is None or (index == 1 and time > 1), row
                continue
            if index == 1 and found["time"][row] > 1:  # It is no event.
                assert time is None or time > min(mpf(1), mpf(float(found["time"][row])) / 2), row
                continue
            assert time is not None, row
            late = abs(time - mpf(float(found["time"][row])))
            most = max(most, 3 * late / mpf(float(found["delay"][row])))
            least = min(least, time / mpf(float(found["time"][row])))
    assert most <= 1
    assert least > 0.5
    assert most > 0.2
    assert np.count_nonzero(sure) - none > occurrences(400)
    assert none > occurrences(200)


@pytest.mark.parametrize("index", PLANES)
def test_a_start_at_a_plane_is_undecided_within_its_errors_and_not_far_beyond(index: int) -> None:
    """The true ball may be on either side up to one error, and the test has two or four."""
    place, axis = 2.0**-30, AXES[index]
    gaps = place * np.array([-0.999, 0.999, -4.01, 4.01])
    ones = np.ones(4)
    values: dict[str, Any] = PARAMETERS | dict.fromkeys(("x", "y", "z", "vx", "vy", "vz"), 0 * ones)
    values |= {"extent": np.abs(LEVELS[index]) + 1e-6, "speed": ones, "leaving": 0 * ones}
    values |= {"position_error": place * ones, "velocity_error": place * ones}

    def undecided(gap: Floats, rate: float, leaving: float = 0) -> list[bool]:
        own = {axis: LEVELS[index] + gap, f"v{axis}": rate * ones, "leaving": leaving * ones}
        return [bool(t == 0) for t in decided(index, values | own, 0.001)["undecided_time"]]

    assert undecided(gaps, -1.0) == [True, True, False, False]
    # It moves off the plane, by a speed that is more than errors.
    assert undecided(gaps, 1e-3) == [False] * 4
    # It has left the plane.
    assert undecided(0 * gaps, -place, 1.0) == [True] * 4
    assert undecided(0 * gaps, 1e-3, 1.0) == [False] * 4
    # From the board it does not come back.
    assert undecided(0 * gaps, 0.5 * place, 1.0) == [index != 1] * 4


def test_a_ball_that_an_error_of_its_velocity_brings_to_the_board_is_undecided() -> None:
    """Its speed off the board is less than the error; in the time until the event it may arrive."""
    place, speed = 2.0**-40, 2.0**-30
    ones = np.ones(2)
    # The first gap is met by a true ball within 0.8 s.
    gap = speed * np.array([0.8, 8])
    values: dict[str, Any] = PARAMETERS | dict.fromkeys(("x", "y", "z", "vx", "vy", "vz"), 0 * ones)
    values |= {"x": LEVELS[1] + gap, "extent": ones, "speed": ones, "leaving": 0 * ones}
    values |= {"position_error": place * ones, "velocity_error": speed * ones}
    for rate in (-speed, -speed / 8, 0.0, speed / 8, speed):
        own = values | {"vx": rate * ones}
        assert decided(1, own)["undecided_time"].tolist() == [0, np.inf], rate
        assert decided(1, own, 0.1)["undecided_time"][0] == np.inf, rate
    assert np.all(decided(1, values | {"vx": 2 * speed * ones})["undecided_time"] == np.inf)
    # Behind the board it never arrives, whether or not there is another event.
    behind = values | {"x": LEVELS[1] - gap, "vx": -ones}
    assert np.all(decided(1, behind, np.inf)["undecided_time"] == np.inf)


# -------------------------------------------------------------------- places at an arrival


def test_a_length_at_an_arrival_is_off_by_no_more_than_its_bound() -> None:
    """Along the board, and the distance from the axis on the end plane, at the true arrival."""
    largest = []
    for index in (1, 3):
        count = trials(3000)
        values = flights(index, count, (0.0, 1.0, 64.0))
        rng = np.random.default_rng(50 + index)
        along = [name for name in "xyz" if name != AXES[index]]
        for name in along:
            values |= {name: rng.normal(0, 0.5, count), f"v{name}": rng.normal(0, 2, count)}
            values["extent"] = values["extent"] + np.abs(values[name])
            values["speed"] = values["speed"] + np.abs(values[f"v{name}"])
        found = decided(index, values)
        sure = np.isinf(found["undecided_time"]) & found["arrives"] & (found["time"] < 10)
        there = found | {"horizon": found["time"]}
        slack = event_polynomials.displacement(HOOP.flight, HOOP.lengths)
        bound = in_doubles({"slack": slack}, there)["slack"]
        signs = rng.choice([-1.0, 1.0], (4, count))
        most = mpf(0)
        with digits(50):
            for row in np.flatnonzero(sure):
                time = crossing_of(index, values, row)
                assert time is not None
                places = [
                    _moved(values, row, name, mpf(float(found["time"][row])), (0.0, 0.0))
                    for name in along
                ]
                true = [
                    _moved(values, row, name, time, tuple(signs[2 * k : 2 * k + 2, row]))
                    for k, name in enumerate(along)
                ]
                lengths = (
                    [abs(true[0] - places[0])]
                    if index == 1
                    else [abs(mp.hypot(*true) - mp.hypot(*places))]
                )
                most = max(most, max(lengths) / mpf(float(bound[row])))
        assert np.count_nonzero(sure) > occurrences(100)
        assert most <= 1
        largest.append(most)
    assert max(largest) > 0.04


def _moved(
    values: Mapping[str, Any], row: int, name: str, time: mpf, signs: tuple[float, ...]
) -> mpf:
    """Return a coordinate after a flight, with errors of these signs."""
    place = mpf(float(values[name][row])) + signs[0] * mpf(float(values["position_error"][row]))
    rate = mpf(float(values[f"v{name}"][row])) + signs[1] * mpf(
        float(values["velocity_error"][row])
    )
    fall = mpf(PARAMETERS["gravity"]) if name == "z" else mpf(0)
    return place + rate * time - fall * time**2 / 2


# --------------------------------------------------- from when on something is undecided


def _undecided_time(name: str, **values: Any) -> float:
    found = in_doubles(dict(KERNELS[name].outputs), {"undecided_time": np.inf, **values})
    return float(found["undecided_time"])


def test_what_may_be_sooner_is_undecided_from_then_on() -> None:
    """A contact near an edge by half its time, an apex at once, others by their delays."""
    near = {"undecided": True, "time": 0.5}
    assert _undecided_time("bounds_undecided", **near) == 0.25
    assert _undecided_time("bounds_undecided", **near | {"undecided": False}) == np.inf
    both = {"arrives": True, "earliest_delay": 0.15, "delay": 0.05}
    assert _undecided_time("tie_undecided", **both, time=0.6, when=0.5) == pytest.approx(0.3)
    assert _undecided_time("tie_undecided", **both, time=0.5, when=0.6) == pytest.approx(0.3)
    assert _undecided_time("tie_undecided", **both, time=0.1, when=0.2) == 0.05
    assert _undecided_time("tie_undecided", **both, time=0.1, when=0.4) == np.inf
    graze = {"apex": 0.5, "height": 1e-9, "margin": 1e-9}
    assert _undecided_time("apex_undecided", **graze) == 0
    assert _undecided_time("apex_undecided", **graze | {"margin": 0.9e-9}) == np.inf
    root = {"arrives": True, "certain": True, "time": 0.5, "delay": 0.1}
    # The search has shown that there is no root before the time at which it stands: that of the
    # root, if it was not refined.
    for name, since in (("arrival_certainty", 0.5), ("return_certainty", 0.25)):
        own = root if since == 0.5 else root | {"t": since}
        assert _undecided_time(name, **own, clearance=-1.0) == 0.4
        assert _undecided_time(name, **own, clearance=1.0) == np.inf
        assert _undecided_time(name, **own | {"certain": False}, clearance=1.0) == since


def test_an_event_that_may_be_after_the_horizon_is_undecided_whatever_misses() -> None:
    assert _undecided_time("overdue", pad=0.49e-6, earliest_delay=1e-6) == 0
    assert _undecided_time("overdue", pad=0.51e-6, earliest_delay=1e-6) == np.inf
