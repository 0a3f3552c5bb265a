"""Proofs of many shots at once, with NumPy, where double-double numbers are enough.

The shots of a scene without air, rolling or slip are flown from their exact doubles, contact after
contact. The arithmetic is that of `ball_array.py` for decisions and that of `model_array.py` for
states; both count all roundings, and the formulas are those of derive/, as in the other proofs.
Nothing comes from an engine.

**Theorem.** A shot that has an outcome here has met, in exact arithmetic from the given doubles,
the surfaces of its events, in their order, and has that outcome; its time and state at each event
and at the end are numbers of the models.

*Proof*, by induction over the events. At the release the models are the doubles themselves, and no
body is overlapped (`surely_valid`). Let e be the errors for which the models of the state after an
event are the exact state (`error_set_array.py` turns these into such of another e). The path and
the coefficients of the event polynomials are in their balls, so that the lemmas of `first_roots.py`
and `first_events.py` hold for the exact flight: the event is its first, and the time of it is of
its model for the same e. Then so are the state before it (Eq. 3), the normal there (Table 2), and
the state after the impact (Eq. 17), by the lemma of `model_array.py`. At an end the bounds of each
outcome are decided in balls. What cannot be decided leaves the shot without an outcome. ∎

So a true tie, an exact touch and an exact edge are never proved here. Neither is a shot that begins
on a body, one that meets no end, or one whose errors have grown beyond `LARGEST_ERROR`.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from .ball_array import BallArray, Bools, Floats, Rows
from .error_set_array import condensed
from .first_events import first_events, holds
from .flights import Flights, joined, shared_columns
from .formulas import Formulas, SurfaceFormulas
from .model_array import ModelArray
from .validity import surely_valid

WIDTH = 4096
"""Shots that are flown at once; their arrays fit into a processor's caches."""

MIN_SHOTS = 8
"""Fewer shots are not worth NumPy's calls."""

LARGEST_ERROR = 2.0**-55
"""Errors of a place, in m, from which on a shot is left to others: its end cannot be known well
enough."""


@dataclass
class Flown:
    """Proved results of a batch of n shots.

    Attributes
    ----------
    outcome
        The outcomes, -1 where none is proved, (n,).
    numbers, errors
        The double nearest to the time at the end and to each component of the state there, and
        bounds on the errors of midpoints: (10, n) each.
    away
        Bounds on the distances of the true numbers from those doubles, (10, n).
    events
        Parts of the events, in order for each shot: shots, bodies, times (s), and bounds on the
        times' errors.
    """

    outcome: Rows
    numbers: Floats
    errors: Floats
    away: Floats
    events: list[tuple[Rows, Rows, Floats, Floats]] = field(default_factory=list)


def is_supported(formulas: Formulas) -> bool:
    """Return whether shots of a scene can be proved here."""
    return (
        formulas.flight is not None
        and formulas.hop is None
        and formulas.passage is None
        and not formulas.open_ended
        and formulas.without_slip
        and all(s.rate is not None and (s.axis >= 0 or not s.bounded) for s in formulas.surfaces)
    )


def fly_batch(
    formulas: Formulas, states: Floats, parameters: Floats, max_contacts: int, time_limit: float
) -> Flown:
    """Return the proved results of shots that do not begin on a body.

    Parameters
    ----------
    formulas
        The formulas of a scene that `is_supported`.
    states
        (n, 9).
    parameters
        The kernels' inputs, (n, p).
    max_contacts
        The number of contacts at which a shot is capped.
    time_limit
        s; shots that may last as long are left to others.
    """
    shots = len(states)
    numbers = np.full((3, 10, shots), np.nan)
    flown = Flown(np.full(shots, -1), *numbers)
    if not shots:
        return flown
    with np.errstate(all="ignore"):
        columns = shared_columns(parameters)
        rows = np.flatnonzero(surely_valid(formulas, states, parameters))
        fresh = [rows[k : k + WIDTH] for k in range(0, len(rows), WIDTH)]
        waiting: list[Flights] = []
        while True:
            queued = sum(map(len, waiting))
            if fresh and queued < WIDTH:
                group = Flights.released(formulas, columns, states, fresh.pop())
            elif queued >= MIN_SHOTS:
                group = joined(waiting)
                waiting = [group[np.arange(WIDTH, queued)]] if queued > WIDTH else []
                group = group[np.arange(min(WIDTH, queued))]
            else:
                return flown
            left = _next_event(group, flown, max_contacts, time_limit)
            if len(left):
                waiting.append(left)


def _next_event(flights: Flights, flown: Flown, max_contacts: int, time_limit: float) -> Flights:
    """Write the next events of flights; return those that go on, after it."""
    formulas = flights.formulas
    rows, surface, time = first_events(flights)
    flights = flights[rows]
    clock = flights.clock + ModelArray(time.high, time.low, time.errors(), None)
    shots, before = len(flights), flights.at(time)
    after = [m.copied(shots) for m in before]
    sure = clock.balls().upper() < time_limit
    outcome = np.full(shots, -1)
    contacts = flights.contacts + 1
    outcome[contacts >= max_contacts] = formulas.outcomes["capped"]
    for k in np.unique(surface).tolist():
        own, rows = formulas.surfaces[k], np.flatnonzero(surface == k)
        group, there = flights[rows], [m[rows] for m in before]
        if k < formulas.faces:
            for into, number in zip(after, _bounced(own, there, group.exact), strict=True):
                into.put(rows, number)
        else:
            outcome[rows], certain = _crossing_outcome(own, [m.balls() for m in there], group)
            sure[rows] &= certain
    bodies = np.array([s.body for s in formulas.surfaces])[surface]
    rows = np.flatnonzero(sure)
    flown.events.append((flights.shots[rows], bodies[rows], clock.high[rows], clock.away()[rows]))
    _finish(flown, flights.shots, np.flatnonzero(sure & (outcome >= 0)), outcome, [clock, *after])
    known = np.max([m.errors() for m in before[:3]], axis=0) < LARGEST_ERROR
    rows = np.flatnonzero(sure & (outcome < 0) & known)
    state = condensed([m[rows] for m in after]) if len(rows) else after
    return Flights(
        formulas,
        flights.columns,
        flights.shots[rows],
        state,
        clock[rows],
        surface[rows],
        contacts[rows],
    )


def _finish(flown: Flown, shots: Rows, rows: Rows, outcome: Rows, models: list[ModelArray]) -> None:
    """Write the results of shots that have come to an end."""
    own = shots[rows]
    flown.outcome[own] = outcome[rows]
    for k, model in enumerate(models):
        flown.numbers[k, own] = model.high[rows]
        flown.errors[k, own] = model.errors()[rows]
        flown.away[k, own] = model.away()[rows]


def _bounced(
    surface: SurfaceFormulas, before: list[ModelArray], values: list[ModelArray]
) -> list[ModelArray]:
    """Return the states after contacts; the coordinate along a plane's axis is the plane's."""
    assert surface.impact is not None
    assert surface.restitution is not None
    after = before[:3] + surface.impact(before, values, surface.normal(before, values))
    if surface.axis >= 0:
        speed = -before[3 + surface.axis]
        after[surface.axis] = surface.offset(values)[0]
        after[3 + surface.axis] = surface.restitution(values, (speed,))[0] * speed
    return after


def _crossing_outcome(
    plane: SurfaceFormulas, state: list[BallArray], flights: Flights
) -> tuple[Rows, Bools]:
    """Return the outcomes of crossings, of the first end whose bounds hold, and which are sure."""
    shots = len(flights)
    outcome, certain = np.full(shots, -1), np.zeros(shots, np.bool_)
    passed_by = np.ones(shots, np.bool_)
    for _, number, bounds, _ in plane.ends:
        inside, outside = holds((bounds,), state, flights.values, shots)
        here = passed_by & inside
        outcome[here], certain[here] = number, True
        passed_by &= outside
    return outcome, certain
