"""The certainly first events of many flights: surface and time, as a model.

What is met, and when, is decided in plain balls (`first_roots.py`). The time of the event is then
enclosed more closely.

**Lemma (time of an event).** Let the exact flight's gap g have exactly one zero in [low, high], and
let T = [m - r, m + r] be within that. If g' is negative throughout T and |g(m)| <= r min |g'|, then
the zero is at m - g(m)/g'(ξ) for some ξ in T. For g has both signs at the ends of T, or is zero
there, so that T has a zero, by the mean value theorem at such a place. ∎

g(m) is a model, computed of the state's: the errors of place, velocity and time that have one cause
cancel in the state at the event. No derivative is needed but g', which is a ball here.

**Lemma (first event).** An event at a surface is the first if it is certain, if each other surface
is met after it, if at all, and if it is within the bounds of its own. A plane that is crossed
certainly out of its bounds is not met: the gap of a plane falls through zero once. A tie, a graze,
and a crossing of an edge leave one of these open, as closely as balls of doubles tell. ∎
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from .ball_array import (
    INWARDS,
    OUTWARDS,
    TINY,
    BallArray,
    Bools,
    Floats,
    PolynomialArray,
    Rows,
    where,
)
from .expressions import Function
from .first_roots import first_roots, near_roots, plane_arrivals
from .flights import Flights
from .formulas import SurfaceFormulas
from .model_array import ModelArray, exact_sum


@dataclass(frozen=True)
class _Candidates:
    """The surfaces that flights seem to meet first, and when.

    Attributes
    ----------
    surface
        Its number, or -1, (n,).
    guess
        A time near the event, s.
    low, high
        Times between which the surface is met once, s.
    earliest
        No surface is met before this time, by surface, (k, n); infinite: never before `guess`.
    """

    surface: Rows
    guess: Floats
    low: Floats
    high: Floats
    earliest: Floats


def first_events(flights: Flights) -> tuple[Rows, Rows, ModelArray]:
    """Return the flights whose first event is proved, its surface, and its time (s)."""
    found = _candidates(flights)
    shots = len(flights)
    time = ModelArray.exact(np.full(shots, np.nan))
    sure = np.zeros(shots, np.bool_)
    for k in np.unique(found.surface[found.surface >= 0]).tolist():
        rows = np.flatnonzero(found.surface == k)
        root, sure[rows] = _event_time(
            flights.formulas.surfaces[k],
            flights[rows],
            found.guess[rows],
            (found.low[rows], found.high[rows]),
        )
        time.put(rows, root)
    until = time.balls().upper()
    for k, earliest in enumerate(found.earliest):
        sure &= (found.surface == k) | (earliest > until)
    rows = np.flatnonzero(sure)
    return rows, found.surface[rows], time[rows]


def _candidates(flights: Flights) -> _Candidates:
    surfaces, shots = flights.formulas.surfaces, len(flights)
    path = flights.near(PolynomialArray([0, 1]))[:3]
    found = _Candidates(
        np.full(shots, -1),
        np.full(shots, np.nan),
        np.zeros(shots),
        np.full(shots, np.inf),
        np.full((len(surfaces), shots), np.inf),
    )
    latest = np.full(shots, np.inf)
    planes = [k for k, surface in enumerate(surfaces) if surface.axis >= 0]
    for k in sorted(planes, key=lambda k: surfaces[k].bounded):  # few bounds are asked for then
        coefficients = surfaces[k].condition(path, flights.values)[0].coeffs()
        arrival = plane_arrivals(coefficients, flights.last == k)
        found.earliest[k], certain = arrival.earliest, arrival.certain
        if surfaces[k].bounded:
            rows = np.flatnonzero(certain & (arrival.earliest <= latest))
            own = flights[rows]
            there = own.near(arrival.time[rows])
            inside, outside = holds(surfaces[k].patches, there, own.values, len(rows))
            found.earliest[k, rows[outside]] = np.inf
            certain = np.zeros(shots, np.bool_)
            certain[rows[inside]] = True
        until = arrival.time.upper()
        sooner = np.flatnonzero(certain & (until < latest))
        found.surface[sooner], latest[sooner] = k, until[sooner]
        found.guess[sooner] = arrival.time.middle[sooner]
    for k, surface in enumerate(surfaces):
        if surface.axis >= 0:
            continue
        coefficients = surface.condition(path, flights.values)[0].coeffs()
        returns = flights.last == k
        if returns.any():
            shifted = [*coefficients[1:], BallArray.exact(np.zeros(1))]
            pairs = zip(shifted, coefficients, strict=True)
            coefficients = [where(returns, *pair) for pair in pairs]
        part = first_roots(coefficients, latest)
        found.earliest[k] = np.where(part.none, np.inf, 0.0)
        rows = np.flatnonzero(part.found)
        found.earliest[k, rows] = part.low[rows] * INWARDS
        # Of two curved surfaces the second is tried; it is proved only where it comes first.
        found.surface[rows], found.low[rows], found.high[rows] = k, part.low[rows], part.high[rows]
        own_coefficients = [c[rows] for c in coefficients]
        found.guess[rows] = near_roots(own_coefficients, part.low[rows], part.high[rows])
    return found


def _event_time(
    surface: SurfaceFormulas, flights: Flights, guess: Floats, part: tuple[Floats, Floats]
) -> tuple[ModelArray, Bools]:
    """Return times of events as models, and where they are proved.

    Parameters
    ----------
    surface
        The surface that is met.
    flights
        The flights that meet it.
    guess
        Times near the events, s.
    part
        Times between which the surface is met once, s.
    """
    assert surface.rate is not None
    pace = surface.rate(flights.near(BallArray.exact(guess)), flights.values)[0].middle
    # Newton's step in double-double, of the midpoints: nothing is proved here.
    middles = replace(flights, state=[m.midpoint() for m in flights.state])
    off = surface.distance(middles.at(ModelArray.exact(guess)), flights.exact)[0]
    middle = ModelArray(*exact_sum(guess, -off.high / pace), np.zeros_like(guess), None)
    gap = surface.distance(flights.at(middle), flights.exact)[0]
    reach = (2 * gap.size() / np.abs(pace) + 2.0**-100 * np.abs(guess)) * OUTWARDS + TINY
    around = BallArray(middle.high, (reach + np.abs(middle.low)) * OUTWARDS)
    rate = surface.rate(flights.near(around), flights.values)[0]
    low, high = part
    proved = (
        rate.negative()
        & (gap.size() / rate.least_size() * OUTWARDS <= reach)
        & (around.lower() > low * OUTWARDS)
        & (around.upper() * OUTWARDS < high)
    )
    return middle - gap / ModelArray.of_balls(rate), proved


def holds(
    patches: Sequence[Function], state: Sequence[BallArray], values: list[BallArray], shots: int
) -> tuple[Bools, Bools]:
    """Return masks of the shots within all bounds of a patch, and of those out of every patch.

    Parameters
    ----------
    patches
        (state, parameters) to bounds, which hold if none is positive.
    state
        Positions and velocities.
    values
        The kernels' inputs.
    shots
        n.
    """
    inside, outside = np.zeros(shots, np.bool_), np.ones(shots, np.bool_)
    for patch in patches:
        within, without = np.ones(shots, np.bool_), np.zeros(shots, np.bool_)
        for bound in patch(state, values):
            within &= bound.negative()
            without |= bound.positive()
        inside |= within
        outside &= without
    return inside, outside
