"""The event loop in NumPy: one segment of every shot in flight at a time.

The steps, and every operation outside the kernels, are those of templates/c/engine.h.j2 in the same
order: the two give the same bits. Shots that end leave the arrays, and others take their place.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .raw import Raw

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]
Column = Floats | float
Outputs = tuple[Any, ...]

BLOCK = 1 << 14
"""Shots that are simulated together: their arrays fit the second-level cache."""

POSITION = ("x", "y", "z")
MOTION = ("vx", "vy", "vz", "wx", "wy", "wz")
STATE = POSITION + MOTION
ERRORS = ("dx", "dy", "dz", "dvx", "dvy", "dvz", "dwx", "dwy", "dwz")
CARRIED = ERRORS[:6]
NORMAL = ("nx", "ny", "nz")
TURNED = ("dnx", "dny", "dnz", "turn")
MADE, MISSED, CAPPED, SHORT, INVALID = range(5)
SEARCH = ("prepare", "margins", "refine", "advance")
"""Kernels of a curved surface's search."""


@dataclass
class Arrivals:
    """The earliest arrival found so far, for every shot in flight.

    Where nobody asks what is uncertain, `certified` is False, and what only bounds errors is left
    out: the path does not depend on it.
    """

    certified: bool
    when: Floats
    which: NDArray[np.int64]
    late: Floats
    doubt: Floats

    @classmethod
    def none(cls, shots: int, certified: bool) -> Arrivals:
        """Return that nothing has been found."""
        never = np.full(shots, np.inf)
        return cls(certified, never, np.full(shots, -1), np.zeros(shots), never)

    def question(self, where: Mask, time: Floats) -> None:
        """Note decisions at `time` that lie within their rounding error."""
        self.doubt = np.where(where & (time < self.doubt), time, self.doubt)

    def propose(self, arrives: Mask, time: Floats, delay: Floats | float, index: int) -> None:
        """Take arrivals on surface `index` that are earlier than those found so far."""
        earlier = arrives & (time < self.when)
        if self.certified:
            tie = arrives & (np.abs(time - self.when) <= delay + self.late)
            self.question(tie, np.where(time < self.when, time, self.when))
            self.late = np.where(earlier, delay, self.late)
        self.when = np.where(earlier, time, self.when)
        self.which = np.where(earlier, index, self.which)


@dataclass
class Flights:
    """The shots of a block that are in flight, as columns.

    Attributes
    ----------
    columns
        State, parameters and carried errors by name; a parameter that all shots share is a number.
    row
        Their rows in the block.
    last
        The surfaces that they touched last, -1 for none.
    which, t, late
        The surface of the next event, -1 for none, its time since the last one, and the bound on
        its delay.
    """

    columns: dict[str, Column]
    row: NDArray[np.int64]
    last: NDArray[np.int64]
    certified: bool
    which: NDArray[np.int64] = field(init=False)
    t: Floats = field(init=False)
    late: Floats = field(init=False)
    clock: Floats = field(init=False)
    contacts: NDArray[np.int32] = field(init=False)

    def __post_init__(self) -> None:
        shots = len(self.row)
        self.which, self.t, self.late = self.last, np.zeros(shots), np.zeros(shots)
        self.clock = np.zeros(shots)
        if self.certified:
            self.columns |= {name: np.zeros(shots) for name in (*ERRORS, "clock_error")}
        self.contacts = np.zeros(shots, np.int32)

    def keep(self, which: Mask) -> None:
        """Drop all other shots."""
        kept = np.flatnonzero(which)
        self.columns = _take(self.columns, kept)
        self.row, self.clock = self.row[kept], self.clock[kept]
        self.last, self.contacts = self.last[kept], self.contacts[kept]
        self.which, self.t, self.late = self.which[kept], self.t[kept], self.late[kept]

    def joined(self, other: Flights) -> Flights:
        """Return these shots and the others."""
        both = Flights(
            {
                name: value
                if np.ndim(value) == 0
                else np.concatenate([np.asarray(value), np.asarray(other.columns[name])])
                for name, value in self.columns.items()
                if name in other.columns
            },
            np.concatenate([self.row, other.row]),
            np.concatenate([self.last, other.last]),
            self.certified,
        )
        if self.certified:
            both.columns |= {
                name: np.concatenate(
                    [np.asarray(flights.columns[name]) for flights in (self, other)]
                )
                for name in (*ERRORS, "clock_error")
            }
        both.clock = np.concatenate([self.clock, other.clock])
        both.contacts = np.concatenate([self.contacts, other.contacts])
        return both

    def state(self) -> Floats:
        """Return the states, (shots, 9)."""
        return np.stack([np.asarray(self.columns[name]) for name in STATE], axis=1)


def run(
    kernels: ModuleType,
    states: Floats,
    parameters: Sequence[Column],
    leaving: NDArray[np.int8] | None,
    max_contacts: int,
    out: Raw,
    stopped: Callable[[], bool] = lambda: False,
) -> None:
    """Simulate shots and write what `out` has room for.

    Parameters
    ----------
    kernels
        A generated module of NumPy kernels.
    states
        (n, 9), C order; SI units.
    parameters
        A number or an array (n,) for each parameter, in the order of ``kernels.PARAMETERS``.
    leaving
        Surface that each shot touches at the start and leaves, -1 for none.
    stopped
        Asked between blocks; no further block is begun once it returns True.
    """
    for array, initial in ((out.counts, 0), (out.first, -1), (out.event_counts, 0)):
        if array is not None:
            array[:] = initial
    flights: Flights | None = None
    begun = 0
    with np.errstate(all="ignore"):
        while not stopped():
            flying = 0 if flights is None else len(flights.row)
            if begun < len(states) and flying < BLOCK // 2:
                stop = min(begun + BLOCK - flying, len(states))
                fresh = _begin(kernels, states, parameters, leaving, slice(begun, stop), out)
                flights = fresh if flights is None else flights.joined(fresh)
                begun = stop
            if flights is None or not len(flights.row):
                return
            _advance(kernels, flights, max_contacts, out)


def _begin(
    kernels: ModuleType,
    states: Floats,
    parameters: Sequence[Column],
    leaving: NDArray[np.int8] | None,
    rows: slice,
    out: Raw,
) -> Flights:
    """Return the flights that some of the rows begin; a row that is not valid ends at once."""
    columns: dict[str, Column] = dict(zip(STATE, states[rows].T, strict=True))
    for name, value in zip(kernels.PARAMETERS, parameters, strict=True):
        columns[name] = value if np.ndim(value) == 0 else np.asarray(value)[rows]
    row = np.arange(rows.start, rows.stop)
    finite = np.ones(len(row), np.bool_)
    for column in columns.values():
        finite = finite & (column - column == 0.0)
    last = np.full(len(row), -1) if leaving is None else leaving[rows].astype(np.int64)
    flights = Flights(columns, row, last, out.certified)
    finite = finite & (_call(kernels.allowed, columns)[0] > 0.0)
    valid, doubtful = _call(kernels.valid, columns, last=last)
    good = finite & (valid > 0.0)
    if out.uncertain is not None:
        out.uncertain[rows] = finite & (doubtful > 0.0)
    _finish(kernels, flights, ~good, np.full(len(row), INVALID), out)
    flights.keep(good)
    return flights


def _advance(kernels: ModuleType, flights: Flights, max_contacts: int, out: Raw) -> None:
    """Take every shot to its next event; write and drop those that end there."""
    columns = flights.columns
    bounds = _call(kernels.error_bounds, columns) if flights.certified else (0.0, 0.0)
    columns["position_error"], columns["velocity_error"] = bounds[:2]
    columns["extent"], columns["speed"], columns["excess"] = _call(kernels.scale, columns)
    arrivals = _first_arrivals(kernels, columns, flights.last, flights.certified)
    flights.t, flights.which, flights.late = arrivals.when, arrivals.which, arrivals.late
    stays = arrivals.which < 0
    ends = arrivals.which == len(kernels.SURFACES) - 1
    there = _call(kernels.flight, columns, t=flights.t)
    miss = _call(kernels.target, columns, x=there[0], y=there[1])[0]
    if out.uncertain is not None:
        slack = _call(kernels.displacement, columns, horizon=flights.t, delay=arrivals.late)[0]
        doubtful = ~(arrivals.doubt > arrivals.when + arrivals.late) & (arrivals.doubt < np.inf)
        out.uncertain[flights.row] |= doubtful | (ends & (np.abs(miss) <= slack))
    _choose(~stays, there, STATE[:6], columns)
    flights.clock = np.where(stays, flights.clock, flights.clock + flights.t)

    outcome = np.where(stays, SHORT, np.where(miss <= 0.0, MADE, MISSED))
    over = stays | ends
    if over.any():
        if ends.any() and (out.time_error is not None or out.state_error is not None):
            _carry_to_end(kernels, flights, ends)
        if out.events is not None:
            _record(flights, ends, flights.state(), out)
        _finish(kernels, flights, over, outcome, out)
        flights.keep(~over)
    if not len(flights.row):
        return
    before = flights.state() if out.events is not None else None
    flights.contacts = flights.contacts + 1
    _collide(kernels, flights)
    if out.counts is not None:
        out.counts[flights.row, flights.which] += 1
    if out.first is not None:
        opening = flights.contacts == 1
        out.first[flights.row[opening]] = flights.which[opening]
    flights.last = flights.which
    if before is not None:
        _record(flights, np.ones(len(flights.row), np.bool_), before, out)
    capped = flights.contacts >= max_contacts
    if capped.any():
        _finish(kernels, flights, capped, np.full(len(capped), CAPPED), out)
        flights.keep(~capped)


def _first_arrivals(
    kernels: ModuleType, columns: Mapping[str, Column], last: NDArray[np.int64], certified: bool
) -> Arrivals:
    """Return the earliest admissible arrival on any surface (Eq. 4)."""
    arrivals = Arrivals.none(len(last), certified)
    if certified:
        errors = np.asarray(columns["position_error"]), np.asarray(columns["velocity_error"])
        bounded = np.logical_and.reduce([error < np.inf for error in errors])
        bounded &= np.asarray(columns["excess"]) <= 0.0
        arrivals.question(~bounded, np.zeros(len(last)))
    surfaces = list(enumerate(kernels.SURFACES))
    # The end plane first: what certainly comes after it needs no further look.
    for index, (name, windows, bounded) in surfaces[-1:] + surfaces[:-1]:
        if not windows:
            _plane_arrival(kernels, columns, last == index, index, name, bounded, arrivals)
    for index, (name, windows, _) in surfaces:
        if windows:
            _curved_arrival(kernels, columns, last == index, index, name, windows, arrivals)
    return arrivals


def _plane_arrival(
    kernels: ModuleType,
    columns: Mapping[str, Column],
    gone: Mask,
    index: int,
    name: str,
    bounded: bool,
    arrivals: Arrivals,
) -> None:
    leaving = np.where(gone, 1.0, 0.0)
    time, rate, bend, apex, height = _call(
        getattr(kernels, f"{name}_arrival"), columns, leaving=leaving
    )
    meets = (rate < 0.0) | ((rate <= 0.0) & (bend < 0.0) & (time == 0.0))
    arrives = meets & (time >= 0.0) & (time < np.inf)
    bounds: Outputs = ()
    if bounded:
        x, y, z, *_ = _call(kernels.flight, columns, t=time)
        bounds = _call(getattr(kernels, f"{name}_bounds"), columns, x=x, y=y, z=z)
    within = np.logical_and.reduce([arrives, *(g <= 0.0 for g in bounds)])
    if not arrivals.certified:
        arrivals.propose(within, time, 0.0, index)
        return
    margin = _call(getattr(kernels, f"{name}_margin"), columns, horizon=time)[0]
    crossing = {"margin": margin, "rate_margin": 0.0, "rate": rate}
    clearance, delay = _call(kernels.crossing, crossing, ceiling=np.abs(bend))
    early = ~(time - arrivals.when > arrivals.late + delay)
    slack = _call(getattr(kernels, f"{name}_margin"), columns, horizon=apex)[0]
    arrivals.question((apex >= 0.0) & (np.abs(height) <= slack), apex)
    slack = _call(kernels.displacement, columns, horizon=time, delay=delay)[0]
    near = np.logical_and.reduce([arrives, early, *(g <= slack for g in bounds)])
    surely = np.logical_and.reduce([clearance > 0.0, *(g < -slack for g in bounds)])
    arrivals.question(near & ~surely, time)
    arrivals.propose(within & early, time, delay, index)


@dataclass
class Search:
    """Shots whose next contact with one curved surface is being looked for."""

    shot: NDArray[np.int64]
    columns: dict[str, Column]
    lows: list[Floats]
    highs: list[Floats]
    t: Floats
    end: Floats

    def keep(self, which: Mask) -> None:
        """Drop all other shots."""
        kept = np.flatnonzero(which)
        self.shot, self.columns = self.shot[kept], _take(self.columns, kept)
        self.lows = [low[kept] for low in self.lows]
        self.highs = [high[kept] for high in self.highs]
        self.t, self.end = self.t[kept], self.end[kept]

    def open(self, where: Mask, after: Floats | float) -> Mask:
        """Enter the first window that begins no earlier than `after`; return where there is one."""
        opened = np.zeros(len(self.t), np.bool_)
        for low, high in zip(reversed(self.lows), reversed(self.highs), strict=True):
            opens = where & (low < high) & (low >= after)
            self.t = np.where(opens, low, self.t)
            self.end = np.where(opens, high, self.end)
            opened |= opens
        return opened


def _curved_arrival(
    kernels: ModuleType,
    columns: Mapping[str, Column],
    gone: Mask,
    index: int,
    name: str,
    windows: int,
    arrivals: Arrivals,
) -> None:
    """Propose the first arrivals on a curved surface; shots that certainly miss it sit out."""
    until, pad = _call(kernels.horizon, columns, t=arrivals.when)
    clear = _call(getattr(kernels, f"{name}_clear"), columns, horizon=until)[0]
    possible = ~np.broadcast_to(clear > 0.0, len(gone))
    if not possible.any():
        return
    used = set().union(
        *(_arguments(getattr(kernels, f"{name}_{part}")) for part in SEARCH),
        _arguments(kernels.allowance),
    )
    chosen = np.flatnonzero(possible)
    own = _take({key: column for key, column in columns.items() if key in used}, chosen)
    certified, shots = arrivals.certified, len(gone)
    beyond, question, arrival, delay, certain = _first_root(
        kernels, name, windows, own, gone[chosen], until[chosen], certified
    )
    when = _spread(arrival, chosen, shots, np.inf)
    if certified:
        beyond = beyond | (arrivals.late > pad)[chosen]
        arrivals.question(_spread(beyond, chosen, shots, False), np.zeros(shots))
        arrivals.question(possible, _spread(question, chosen, shots, np.inf))
        arrivals.question((when < np.inf) & ~_spread(certain, chosen, shots, True), when)
    arrivals.propose(when < np.inf, when, _spread(delay, chosen, shots, 0.0), index)


def _spread(values: NDArray[Any], where: NDArray[Any], shots: int, other: Any) -> NDArray[Any]:
    """Return `values` at the indices `where`, and `other` elsewhere."""
    spread = np.full(shots, other, values.dtype)
    spread[where] = values
    return spread


def _first_root(
    kernels: ModuleType,
    name: str,
    windows: int,
    columns: dict[str, Column],
    gone: Mask,
    horizon: Floats,
    certified: bool,
) -> tuple[Mask, Floats, Floats, Floats, Mask]:
    """Search the first arrivals on a curved surface from the left.

    Returns
    -------
    beyond, question, arrival, delay, certain
        Where the errors exceed what the search allows for; the time of the first point that those
        errors leave open, infinite if none; the arrivals, infinite if none; bounds on their delays;
        and whether they are certain.
    """
    shots = len(gone)
    advance, margins = getattr(kernels, f"{name}_advance"), getattr(kernels, f"{name}_margins")
    outputs = _call(getattr(kernels, f"{name}_prepare"), columns, horizon=horizon)
    prepared = dict(zip(kernels.OUTPUTS[f"{name}_prepare"], outputs, strict=True))
    lows = [np.broadcast_to(prepared.pop(f"low{k}"), shots) for k in range(windows)]
    highs = [np.broadcast_to(prepared.pop(f"high{k}"), shots) for k in range(windows)]
    latest = prepared["latest"]

    def allow(share: Floats, rows: NDArray[np.int64]) -> tuple[Mask, Floats, Floats, Floats]:
        """Return where errors exceed `share` of the flight, and the margins that allow for it."""
        flights, until = _take(columns, rows), latest[rows]
        level, velocity_level, excess = _call(
            kernels.allowance, flights, share=share, horizon=until
        )
        levels = {"position_error": level, "velocity_error": velocity_level}
        flat, tilt, rate_margin = _call(margins, flights, horizon=until, **levels)
        return excess > 0.0, flat, tilt, rate_margin

    share = np.full(shots, kernels.SHARES[0])
    beyond, flat, tilt, rate_margin = allow(share, np.arange(shots))
    beyond = beyond | (prepared["lost"] > 0.0)
    stepping = _arguments(advance)
    search = Search(
        np.arange(shots),
        {key: column for key, column in (columns | prepared).items() if key in stepping},
        [np.where(low > 0.0, low, 0.0) for low in lows],
        [np.where(high < horizon, high, horizon) for high in highs],
        np.zeros(shots),
        np.zeros(shots),
    )
    search.keep(search.open(np.ones(shots, np.bool_), 0.0))
    arrival, question = np.full(shots, np.inf), np.full(shots, np.inf)
    certain = np.zeros(shots, np.bool_)
    for step in range(kernels.STEP_LIMIT + 1):
        if not len(search.shot):
            break
        t, shot = search.t, search.shot
        leaving, margin = _nearby(gone[shot], tilt[shot], flat[shot], t)
        slack = rate_margin[shot]
        gap, rate, bend, stride, following, root, clearance = _call(
            advance,
            search.columns,
            t=t,
            end=search.end,
            margin=margin,
            rate_margin=slack,
            leaving=leaving,
        )
        falling = (rate < 0.0) | ((rate <= slack) & (bend < 0.0))
        clear = falling & (clearance > 0.0)
        hit = falling & ((gap - margin <= margin) | clear)
        # A root that is not certain is looked at again, with smaller errors allowed.
        vague = hit & ~clear & (share[shot] > 0.0)
        if vague.any():
            again = shot[vague]
            ratio = kernels.SHARES[1] / kernels.SHARES[0]
            share[again] = np.where(share[again] > kernels.SHARES[-1], share[again] * ratio, 0.0)
            exceeded, flat[again], tilt[again], rate_margin[again] = allow(share[again], again)
            doubtful = np.where(exceeded, t[vague], np.inf)
            question[again] = np.fmin(question[again], doubtful)
            hit &= ~vague
        arrival[shot[hit]] = np.where(clear, root, t)[hit]
        certain[shot[hit & clear]] = True
        exhausted = ~hit & ~vague & (stride >= search.end - t)
        passed = search.end
        search.t = np.where(hit | vague, t, following)
        going = ~hit & (~exhausted | search.open(exhausted, passed))
        if step == kernels.STEP_LIMIT:
            question[shot[going]] = np.fmin(question[shot[going]], search.t[going])
        if not going.all():
            search.keep(going)

    leaving, _ = _nearby(gone, tilt, flat, arrival)
    own = {**columns, **prepared, "leaving": leaving}
    for _ in range(2):
        refined, rate = _call(getattr(kernels, f"{name}_refine"), own, t=arrival)
        arrival = np.where(certain, refined, arrival)
    landed = np.where(arrival < 0.0, 0.0, arrival)
    if not certified:
        return beyond, question, landed, np.zeros(shots), certain
    margin, leaving_margin, rate_margin = _call(margins, columns, horizon=latest)
    margin = np.where(leaving > 0.0, leaving_margin * arrival, margin)
    own |= {"margin": margin, "rate_margin": rate_margin}
    clearance, late = _call(kernels.crossing, own, rate=rate)
    certain &= clearance > 0.0
    return beyond, question, landed, np.where(certain, late, 0.0), certain


def _nearby(gone: Mask, tilt: Floats, flat: Floats, t: Floats) -> tuple[Floats, Floats]:
    """Return 1 where the deflated form serves, else 0, and the margin of the gap.

    Near the surface that a ball left, F/t is known better than F.
    """
    tilted = tilt * t
    nearby = gone & (tilted < flat)
    return np.where(nearby, 1.0, 0.0), np.where(nearby, tilted, flat)


def _carried_flight(
    kernels: ModuleType, flights: Flights, normal: Mapping[str, Any], curving: Floats
) -> Floats:
    """Take the carried errors to the event; return how far off the position can be there."""
    columns = flights.columns
    counted = {"contacts": flights.contacts.astype(np.float64), "clock": flights.clock}
    counted["late"] = flights.late
    *carried, delay, shift = _call(
        kernels.carry_flight, columns, t=flights.t, curving=curving, **counted, **normal
    )
    columns |= dict(zip(CARRIED, carried, strict=True))
    columns["clock_error"] = columns["clock_error"] + delay
    return np.asarray(shift)


def _carry_to_end(kernels: ModuleType, flights: Flights, ends: Mask) -> None:
    """Take the carried errors of the shots that end to the end plane."""
    name = kernels.SURFACES[-1][0]
    normal = dict(zip(NORMAL, _call(getattr(kernels, f"{name}_normal"), {}), strict=True))
    kept = {key: flights.columns[key] for key in (*CARRIED, "clock_error")}
    shift = _carried_flight(kernels, flights, normal, np.full(len(ends), np.inf))
    for key in CARRIED[:3]:
        error = flights.columns[key]
        flights.columns[key] = np.where(np.abs(error) < shift, shift, error)
    for key, value in kept.items():
        flights.columns[key] = np.where(ends, flights.columns[key], value)


def _collide(kernels: ModuleType, flights: Flights) -> None:
    """Put the balls onto the surfaces they meet and give them their motion after the contact."""
    columns, which = flights.columns, flights.which
    zeros = np.zeros(len(which))
    normal = dict.fromkeys(NORMAL, zeros)
    for index, (name, _, _) in enumerate(kernels.SURFACES[:-1]):
        _choose(which == index, _call(getattr(kernels, f"{name}_normal"), columns), NORMAL, normal)
    motion = _call(kernels.impact, columns, **normal)
    if flights.certified:
        _carry_errors(kernels, flights, normal)
    for index, (name, windows, _) in enumerate(kernels.SURFACES[:-1]):
        if not windows:
            placed = _call(getattr(kernels, f"{name}_place"), columns)
            _choose(which == index, placed, POSITION, columns)
    columns |= dict(zip(MOTION, motion, strict=True))


def _carry_errors(kernels: ModuleType, flights: Flights, normal: Mapping[str, Floats]) -> None:
    """Take the carried errors of the state through the flight and the contact."""
    columns, which = flights.columns, flights.which
    curving = np.full(len(which), np.inf)
    for index, (name, _, _) in enumerate(kernels.SURFACES[:-1]):
        own = _call(getattr(kernels, f"{name}_curvature"), columns)[0]
        curving = np.where((which == index) & (flights.last == which), own, curving)
    zeros = np.zeros(len(which))
    shift = _carried_flight(kernels, flights, normal, curving)
    turned = dict.fromkeys(TURNED, zeros)
    for index, (name, windows, _) in enumerate(kernels.SURFACES):
        if windows:
            own = _call(getattr(kernels, f"{name}_carry_normal"), columns, shift=shift)
            _choose(which == index, own, TURNED, turned)
    contacts = flights.contacts.astype(np.float64)
    errors = _call(kernels.carry_impact, columns, contacts=contacts, **normal, **turned)
    columns |= dict(zip(ERRORS[3:], errors, strict=True))


def _choose(
    where: Mask, values: Sequence[Any], names: Iterable[str], columns: dict[str, Any]
) -> None:
    """Put `values` into the named columns where the mask holds."""
    for name, value in zip(list(names), values, strict=True):
        columns[name] = np.where(where, value, columns[name])


def _record(flights: Flights, happened: Mask, before: Floats, out: Raw) -> None:
    assert out.events is not None
    assert out.event_counts is not None
    row = flights.row[happened]
    rows = (row, out.event_counts[row])
    out.events["shot"][rows] = row
    out.events["surface"][rows] = flights.which[happened]
    out.events["time"][rows] = flights.clock[happened]
    out.events["before"][rows] = before[happened]
    out.events["after"][rows] = flights.state()[happened]
    out.event_counts[row] += 1


def _finish(
    kernels: ModuleType, flights: Flights, over: Mask, outcome: NDArray[np.int64], out: Raw
) -> None:
    """Write the results of the shots that are over."""
    row = flights.row[over]
    invalid = outcome[over] == INVALID
    if out.outcome is not None:
        out.outcome[row] = outcome[over]
    if out.contacts is not None:
        out.contacts[row] = flights.contacts[over]
    if out.time is not None:
        out.time[row] = np.where(invalid, np.nan, flights.clock[over])
    if out.state is not None:
        out.state[row] = np.where(invalid[:, None], np.nan, flights.state()[over])
    if out.time_error is not None or out.state_error is not None:
        *state_error, time_error = _call(kernels.claimed_errors, flights.columns)
        if out.time_error is not None:
            out.time_error[row] = np.where(invalid, np.nan, time_error[over])
        if out.state_error is not None:
            bounds = np.stack(state_error, axis=1)[over]
            out.state_error[row] = np.where(invalid[:, None], np.nan, bounds)


def _call(kernel: Callable[..., Outputs], columns: Mapping[str, Any], **renamed: Any) -> Outputs:
    """Evaluate a kernel, its arguments taken by name."""
    return kernel(*[renamed[n] if n in renamed else columns[n] for n in _arguments(kernel)])


@cache
def _arguments(kernel: Callable[..., Outputs]) -> tuple[str, ...]:
    """Return the names of a kernel's arguments."""
    code = kernel.__code__
    return code.co_varnames[: code.co_argcount]


def _take(columns: Mapping[str, Column], rows: NDArray[np.int64]) -> dict[str, Column]:
    """Return the rows of columns; what all shots share stays."""
    return {n: c[rows] if isinstance(c, np.ndarray) and c.ndim else c for n, c in columns.items()}
