"""The errors of time and place at the contacts of real shots are within the proved bounds.

A first contact's start is exact: there the judge bounds the errors of the recorded time and place.
Later contacts are held against the exact flight from the computed state before it.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from hoopgen.generated.numpy import hoop
from numpy.typing import NDArray

import hoopgen
from benchmarks.workloads import WORKLOADS
from tests.derive.errors.test_kernel_roundings import SIZES, SLACK, Floats, U, off_by
from tests.derive.errors.test_plane_roots import LEVELS, Arrival
from tests.derive.errors.test_ring_condition import STATE, TERMS, Meeting
from tests.derive.errors.test_ring_roots import place_terms, root_bound, root_errors
from tests.helpers.effort import trials

RING, PLANES = 0, {1: "backboard", 2: "bridge", 3: "end"}
AXES = {1: 0, 2: 2}
SHOTS = {1: 500, 2: 500, 3: 100}
"""Numbers of free throws, of shots that bounce often, and of those that swirl in the ring."""


CARRIED = ("clock_error", "position_bound")


def flights_of(states: Floats) -> dict[str, Any]:
    """Return all flights of shots: start, `t`, end, `which` surface they meet, and the `last` one.

    `CARRIED` are the errors that the engine carries on from there. Its log has sums of times. The
    times themselves are what the NumPy engine adds.
    """
    turns: list[dict[str, Any]] = []
    times: list[Floats] = []
    detect, resolve, add = hoop.detect_bounded, hoop.resolve_bounded, hoop.event_clock

    def event_clock(when: Floats, clock: Floats) -> Any:
        times.append(when.copy())
        return add(when, clock)

    def detect_bounded(columns: dict[str, Any], shots: int, room: Any) -> None:
        own = {name: columns[name].copy() for name in (*STATE, "last")}
        detect(columns, shots, room)
        ends = {f"end_{name}": columns[name].copy() for name in STATE}
        turns.append(own | ends | {"t": times.pop(), "which": columns["which"].copy()})

    def resolve_bounded(columns: dict[str, Any], shots: int, room: Any) -> None:
        resolve(columns, shots, room)
        turns[-1] |= {name: columns[name].copy() for name in CARRIED}

    with pytest.MonkeyPatch.context() as patch:
        for new in (event_clock, detect_bounded, resolve_bounded):
            patch.setattr(hoop, new.__name__, new)
        hoopgen.simulate(states, backend="numpy", threads=1)
    return {name: np.concatenate([turn[name] for turn in turns]) for name in turns[0]}


@cache
def flights(workload: int) -> dict[str, Any]:
    """Return all flights of the shots of a workload."""
    return flights_of(WORKLOADS[workload].make(trials(SHOTS[workload], at_least=50)))


def met(own: dict[str, Any], which: int) -> tuple[dict[str, Any], NDArray[np.bool_], Floats]:
    """Return start and time of the flights that meet a surface, which return, and their ends."""
    rows = np.flatnonzero(own["which"] == which)
    given = {name: own[name][rows] for name in (*STATE, "t")} | SIZES
    ends = np.array([own[f"end_{name}"][rows] for name in STATE])
    return given, own["last"][rows] == which, ends


def ring_form(at: Meeting, returning: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return where F less its value at the start has the smaller rounding, of returns alone.

    Either form is proved for every flight; a return's error is measured from its start.
    """
    return returning & (sum(TERMS["deflated"](at)) < sum(TERMS["gap"](at)))


def bounds(own: dict[str, Any], which: int) -> tuple[Floats, Floats]:
    """Return the bounds on time, (n,), and place, (3, n), of all contacts with a surface."""
    given, returning, ends = met(own, which)
    if which == RING:
        at = Meeting(given)
        late = root_bound(at, ring_form(at, returning))
    else:
        late = Arrival(PLANES[which], given, returning).bound
    return late, sum(place_terms(given, ends, late))


def errors(own: dict[str, Any], which: int) -> tuple[Floats, Floats]:
    """Return the errors of time and place, from the exact flight of the computed start."""
    given, returning, ends = met(own, which)
    at = Meeting(given)
    assert np.array_equal(at.ends, ends)
    if which == RING:
        return root_errors(at, ring_form(at, returning))
    arrival = Arrival(PLANES[which], given, returning)
    assert np.array_equal(arrival.time, given["t"])
    return arrival.error, off_by(ends[:3], lambda: at.path(np.array(arrival.root()))[0])


@pytest.mark.parametrize("workload", SHOTS)
def test_errors_from_the_exact_flight_are_within_their_proved_bounds(workload: int) -> None:
    own = flights(workload)
    for which in np.unique(own["which"]).astype(int).tolist():
        late, place = bounds(own, which)
        time_errors, place_errors = errors(own, which)
        assert np.all(np.isfinite(late))
        assert np.all(time_errors <= late)
        assert np.all(place_errors <= place)
        assert np.median(place / np.maximum(place_errors, 1e-17)) < 50


@pytest.mark.parametrize("workload", SHOTS)
def test_the_judge_s_errors_of_first_contacts_are_within_the_proved_bounds(workload: int) -> None:
    states = WORKLOADS[workload].make(trials(60, at_least=20))
    shots = hoopgen.simulate(states, record=True)
    found = hoopgen.certify(states, record=True, processes=1).event_errors(shots)
    first = np.searchsorted(shots.events["shot"], np.arange(len(shots)))
    own = {name: states[:, k] for k, name in enumerate(STATE)}
    own |= {f"end_{name}": shots.events["before"][first, k] for k, name in enumerate(STATE)}
    own |= {"t": shots.events["time"][first], "which": shots.events["surface"][first]}
    own["last"] = np.full(len(states), -1)
    for which in np.unique(own["which"]).tolist():
        late, place = bounds(own, which)
        proved = found[first][own["which"] == which]
        assert np.all(np.isfinite(late))
        assert np.all(proved["time_error"] <= late)
        assert np.all(proved["before_error"][:, 0] <= place.max(axis=0))
        assert np.any(proved["before_error"][:, 0] > place.max(axis=0) / 50)
        if which in AXES:  # the ball is put on the plane, whose place has a rounding
            place[AXES[which]] = SLACK * U * abs(LEVELS[PLANES[which]](SIZES))
        assert np.all(proved["after_error"][:, 0] <= place.max(axis=0))


@pytest.mark.parametrize("workload", SHOTS)
def test_first_contacts_carry_the_bounds_of_their_time_and_place(workload: int) -> None:
    """They are simpler than those above: other terms, of the same size."""
    own = flights(workload)
    first = {name: values[own["last"] < 0] for name, values in own.items()}
    for which in np.unique(first["which"][first["which"] < 3]).astype(int).tolist():
        late, place = bounds(first, which)
        clock, carried = (first[name][first["which"] == which] for name in CARRIED)
        time_errors, place_errors = errors(first, which)
        assert np.all(time_errors <= clock)
        assert np.all(place_errors.max(axis=0) <= carried)
        for bound, proved in ((clock, late), (carried, place.max(axis=0))):
            assert 1 / 3 < np.median(bound / proved) < 10
