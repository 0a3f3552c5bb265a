"""The event loop in NumPy: one segment of every shot in flight at a time.

The steps, and every operation outside the kernels, are those of templates/c/engine.h.j2 in the same
order: the two give the same bits. Shots that end leave the arrays.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
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

STEP_LIMIT = 200
"""As in the C engine: steps after which a search gives up and the shot is uncertain."""

POSITION = ("x", "y", "z")
MOTION = ("vx", "vy", "vz", "wx", "wy", "wz")
STATE = POSITION + MOTION
ERRORS = ("dx", "dy", "dz", "dvx", "dvy", "dvz", "dwx", "dwy", "dwz")
CARRIED = ERRORS[:6]
MADE, MISSED, CAPPED, SHORT, INVALID = range(5)
IN_FLIGHT = -1


@dataclass
class Arrivals:
    """The earliest arrival found so far, for every shot in flight."""

    when: Floats
    which: NDArray[np.int64]
    late: Floats
    doubt: Floats

    @classmethod
    def none(cls, shots: int) -> Arrivals:
        """Return that nothing has been found."""
        never = np.full(shots, np.inf)
        return cls(never, np.full(shots, -1), np.zeros(shots), never)

    def question(self, where: Mask, time: Floats) -> None:
        """Note decisions at `time` that lie within their rounding error."""
        self.doubt = np.where(where & (time < self.doubt), time, self.doubt)

    def propose(self, arrives: Mask, time: Floats, delay: Floats, index: int) -> None:
        """Take arrivals on surface `index` that are earlier than those found so far."""
        tie = arrives & (np.abs(time - self.when) <= delay + self.late)
        self.question(tie, np.where(time < self.when, time, self.when))
        earlier = arrives & (time < self.when)
        self.when = np.where(earlier, time, self.when)
        self.which = np.where(earlier, index, self.which)
        self.late = np.where(earlier, delay, self.late)


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
    """

    columns: dict[str, Column]
    row: NDArray[np.int64]
    last: NDArray[np.int64]
    clock: Floats = field(init=False)
    contacts: NDArray[np.int32] = field(init=False)

    def __post_init__(self) -> None:
        shots = len(self.row)
        self.clock = np.zeros(shots)
        self.columns |= {name: np.zeros(shots) for name in (*ERRORS, "clock_error")}
        self.contacts = np.zeros(shots, np.int32)

    def keep(self, which: Mask) -> None:
        """Drop all other shots."""
        self.columns = _take(self.columns, which)
        self.row, self.clock = self.row[which], self.clock[which]
        self.last, self.contacts = self.last[which], self.contacts[which]

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
    for start in range(0, len(states), BLOCK):
        if stopped():
            return
        rows = slice(start, start + BLOCK)
        columns: dict[str, Column] = dict(zip(STATE, states[rows].T, strict=True))
        for name, value in zip(kernels.PARAMETERS, parameters, strict=True):
            columns[name] = value if np.ndim(value) == 0 else np.asarray(value)[rows]
        block_out = out.rows(start, start + BLOCK)
        shots = len(states[rows])
        last = np.full(shots, -1) if leaving is None else leaving[rows].astype(np.int64)
        with np.errstate(all="ignore"):
            _run_block(kernels, columns, last, max_contacts, block_out, start)


def _run_block(
    kernels: ModuleType,
    columns: dict[str, Column],
    leaving: NDArray[np.int64],
    max_contacts: int,
    out: Raw,
    offset: int,
) -> None:
    shots = len(np.asarray(columns["x"]))
    finite = np.ones(shots, np.bool_)
    for array, initial in ((out.counts, 0), (out.first, -1)):
        if array is not None:
            array[:] = initial
    if out.event_counts is not None:
        out.event_counts[:] = 0
    for column in columns.values():
        finite = finite & (column - column == 0.0)
    flights = Flights(columns, np.arange(shots), leaving)
    valid, doubtful = _call(kernels.valid, columns, last=flights.last)
    good = finite & (valid > 0.0)
    if out.uncertain is not None:
        out.uncertain[:] = finite & (doubtful > 0.0)
    _finish(kernels, flights, ~good, np.full(shots, INVALID), out)
    flights.keep(good)
    while len(flights.row):
        _advance(kernels, flights, max_contacts, out, offset)


def _advance(
    kernels: ModuleType, flights: Flights, max_contacts: int, out: Raw, offset: int
) -> None:
    """Take every shot to its next event; write and drop those that end there."""
    surfaces = kernels.SURFACES
    end = len(surfaces) - 1
    columns = flights.columns
    bounds = _call(kernels.error_bounds, columns)
    columns["position_error"], columns["velocity_error"] = bounds[:2]
    columns["extent"], columns["speed"] = _call(kernels.scale, columns)
    arrivals = _first_arrivals(kernels, columns, flights.last)

    stays = arrivals.which < 0
    ends = arrivals.which == end
    touches = ~stays & ~ends
    t = np.where(stays, 0.0, arrivals.when)
    slack = _call(kernels.displacement, columns, horizon=t, delay=arrivals.late)[0]
    for name, value in zip(STATE, _call(kernels.flight, columns, t=t), strict=False):
        columns[name] = np.where(stays, columns[name], value)
    flights.clock = flights.clock + t
    before = flights.state() if out.events is not None else None
    miss = _call(kernels.target, columns)[0]
    doubtful = ~(arrivals.doubt > arrivals.when + arrivals.late) & (arrivals.doubt < np.inf)
    doubtful = doubtful | (ends & (np.abs(miss) <= slack))
    flights.contacts = flights.contacts + touches.astype(np.int32)
    outcome = np.where(stays, SHORT, IN_FLIGHT)
    outcome = np.where(ends, np.where(miss <= 0.0, MADE, MISSED), outcome)
    outcome = np.where(touches & (flights.contacts >= max_contacts), CAPPED, outcome)

    _collide(kernels, flights, arrivals.which, stays, touches, t)
    if out.uncertain is not None:
        out.uncertain[flights.row] |= doubtful
    if out.counts is not None:
        out.counts[flights.row[touches], arrivals.which[touches]] += 1
    if out.first is not None:
        opening = touches & (flights.contacts == 1)
        out.first[flights.row[opening]] = arrivals.which[opening]
    flights.last = np.where(touches, arrivals.which, flights.last)
    if before is not None:
        _record(flights, ~stays, arrivals.which, before, out, offset)
    over = outcome != IN_FLIGHT
    if over.any():
        _finish(kernels, flights, over, outcome, out)
        flights.keep(~over)


def _first_arrivals(
    kernels: ModuleType, columns: Mapping[str, Column], last: NDArray[np.int64]
) -> Arrivals:
    """Return the earliest admissible arrival on any surface (Eq. 4)."""
    arrivals = Arrivals.none(len(last))
    bounded = (columns["position_error"] < np.inf) & (columns["velocity_error"] < np.inf)
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
    time, rate, bend = _call(getattr(kernels, f"{name}_arrival"), columns, leaving=leaving)
    meets = (rate < 0.0) | ((rate <= 0.0) & (bend < 0.0) & (time == 0.0))
    arrives = meets & (time >= 0.0) & (time < np.inf)
    margin = _call(getattr(kernels, f"{name}_margin"), columns, horizon=time)[0]
    crossing = {"margin": margin, "rate_margin": 0.0, "rate": rate}
    clearance, delay = _call(kernels.crossing, crossing, ceiling=np.abs(bend))
    arrives = arrives & ~(time - arrivals.when > arrivals.late + delay)
    unsure = arrives & ~(clearance > 0.0)
    if bounded:
        x, y, z, *_ = _call(kernels.flight, columns, t=time)
        bounds = _call(getattr(kernels, f"{name}_bounds"), columns, x=x, y=y, z=z)
        slack = _call(kernels.displacement, columns, horizon=time, delay=delay)[0]
        within = np.logical_and.reduce([g <= 0.0 for g in bounds])
        near = np.logical_and.reduce([g <= slack for g in bounds])
        surely = np.logical_and.reduce([g < -slack for g in bounds])
        unsure = arrives & near & ~(surely & (clearance > 0.0))
        arrives = arrives & within
    arrivals.question(unsure, time)
    arrivals.propose(arrives, time, delay, index)


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
        self.shot, self.columns = self.shot[which], _take(self.columns, which)
        self.lows = [low[which] for low in self.lows]
        self.highs = [high[which] for high in self.highs]
        self.t, self.end = self.t[which], self.end[which]

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
    shots = len(gone)
    prepare, advance = getattr(kernels, f"{name}_prepare"), getattr(kernels, f"{name}_advance")
    horizon, pad = _call(kernels.horizon, columns, t=arrivals.when)
    possible = ~(_call(getattr(kernels, f"{name}_clear"), columns, horizon=horizon)[0] > 0.0)
    outputs = _call(prepare, columns, horizon=horizon)
    prepared = dict(zip(kernels.OUTPUTS[f"{name}_prepare"], outputs, strict=True))
    lows = [np.broadcast_to(prepared.pop(f"low{k}"), shots) for k in range(windows)]
    highs = [np.broadcast_to(prepared.pop(f"high{k}"), shots) for k in range(windows)]
    latest = prepared["latest"]
    margins = getattr(kernels, f"{name}_margins")

    def allow(share: Floats) -> list[Floats]:
        """Return the excess of the errors and the margins when they may be `share` of the flight."""
        level, velocity_level, excess = _call(
            kernels.allowance, columns, share=share, horizon=latest
        )
        levels = {"position_error": level, "velocity_error": velocity_level}
        return [excess, *_call(margins, columns, horizon=latest, **levels)]

    share = np.full(shots, kernels.SHARES[0])
    excess, flat, tilt, rate_margin = allow(share)
    beyond = possible & ((excess > 0.0) | (arrivals.late > pad))
    arrivals.doubt = np.where(beyond, 0.0, arrivals.doubt)
    # Near the surface that a ball left, F/t is known better than F; nowhere for other balls.
    elsewhere = np.where(gone, 1.0, np.inf)
    search = Search(
        np.arange(shots),
        {**columns, **prepared},
        [np.where(low > 0.0, low, 0.0) for low in lows],
        [np.where(high < horizon, high, horizon) for high in highs],
        np.zeros(shots),
        np.zeros(shots),
    )
    search.keep(search.open(possible, 0.0))
    arrival = np.full(shots, np.inf)
    certain = np.zeros(shots, np.bool_)
    question = np.full(shots, np.inf)
    for step in range(STEP_LIMIT + 1):
        if not len(search.shot):
            break
        t, own = search.t, search.columns
        leaving, margin = _nearby((tilt * elsewhere)[search.shot], flat[search.shot], t)
        slack = rate_margin[search.shot]
        gap, rate, bend, stride, clearance = _call(
            advance, own, t=t, end=search.end, margin=margin, rate_margin=slack, leaving=leaving
        )
        falling = (rate < 0.0) | ((rate <= slack) & (bend < 0.0))
        clear = falling & (clearance > 0.0)
        hit = falling & ((gap - margin <= margin) | clear)
        # A root that is not certain is looked at again, with smaller errors allowed.
        vague = hit & ~clear & (share[search.shot] > 0.0)
        if vague.any():
            again = np.zeros(shots, np.bool_)
            again[search.shot[vague]] = True
            ratio = kernels.SHARES[1] / kernels.SHARES[0]
            smaller = np.where(share > kernels.SHARES[-1], share * ratio, 0.0)
            share = np.where(again, smaller, share)
            excess, *fine = allow(share)
            flat, tilt, rate_margin = (
                np.where(again, new, old)
                for new, old in zip(fine, (flat, tilt, rate_margin), strict=True)
            )
            doubtful = vague & (excess > 0.0)[search.shot]
            question[search.shot[doubtful]] = np.fmin(question[search.shot[doubtful]], t[doubtful])
            hit &= ~vague
        arrival[search.shot[hit]] = np.where(clear, t - gap / rate, t)[hit]
        certain[search.shot[hit & clear]] = True
        exhausted = ~hit & ~vague & (stride >= search.end - t)
        passed = search.end
        search.t = np.where(hit | vague, t, t + stride)
        going = ~hit & (~exhausted | search.open(exhausted, passed))
        if step == STEP_LIMIT:
            question[search.shot[going]] = np.fmin(question[search.shot[going]], search.t[going])
        if not going.all():
            search.keep(going)
    leaving, _ = _nearby(tilt * elsewhere, flat, arrival)
    own = {**columns, **prepared, "leaving": leaving}
    refine = getattr(kernels, f"{name}_refine")
    arrives = arrival < np.inf
    for _ in range(2):
        refined, rate = _call(refine, own, t=arrival)
        arrival = np.where(certain, refined, arrival)
    margin, leaving_margin, rate_margin = _call(margins, columns, horizon=latest)
    margin = np.where(leaving > 0.0, leaving_margin * arrival, margin)
    own |= {"margin": margin, "rate_margin": rate_margin}
    clearance, late = _call(kernels.crossing, own, rate=rate)
    certain &= clearance > 0.0
    arrival = np.where(arrival < 0.0, 0.0, arrival)
    arrivals.question(question < np.inf, question)
    arrivals.question(arrives & ~certain, arrival)
    arrivals.propose(arrives, arrival, np.where(certain, late, 0.0), index)


def _nearby(tilt: Floats, flat: Floats, t: Floats) -> tuple[Floats, Floats]:
    """Return 1 where the deflated form serves, else 0, and the margin of the gap."""
    tilted = tilt * t
    nearby = tilted < flat
    return np.where(nearby, 1.0, 0.0), np.where(nearby, tilted, flat)


def _collide(
    kernels: ModuleType,
    flights: Flights,
    which: NDArray[np.int64],
    stays: Mask,
    touches: Mask,
    t: Floats,
) -> None:
    """Put the ball onto the surface it meets and give it its motion after the contact."""
    columns = flights.columns
    counted = {"contacts": flights.contacts.astype(np.float64), "clock": flights.clock}
    normal = {"nx": 0.0, "ny": 0.0, "nz": 0.0}
    turned = {"dnx": 0.0, "dny": 0.0, "dnz": 0.0, "turn": 0.0}
    for index, (name, _, _) in enumerate(kernels.SURFACES):
        own = _call(getattr(kernels, f"{name}_normal"), columns)
        _choose(which == index, own, normal, normal)
    curving = np.full(len(which), np.inf)
    for index, (name, _, _) in enumerate(kernels.SURFACES[:-1]):
        own = _call(getattr(kernels, f"{name}_curvature"), columns)[0]
        curving = np.where((which == index) & (flights.last == which), own, curving)
    *shifted, delay, shift = _call(
        kernels.carry_flight, columns, t=t, curving=curving, **counted, **normal
    )
    _choose(~stays, shifted, CARRIED, columns)
    ends = which == len(kernels.SURFACES) - 1
    for name in CARRIED[:3]:
        _choose(ends & (np.abs(columns[name]) < shift), [shift], [name], columns)
    for index, (name, windows, _) in enumerate(kernels.SURFACES):
        if windows:
            own = _call(getattr(kernels, f"{name}_carry_normal"), columns, shift=shift)
            _choose(which == index, own, turned, turned)
    _choose(~stays, [columns["clock_error"] + delay], ["clock_error"], columns)
    after_errors = _call(kernels.carry_impact, columns, **counted, **normal, **turned)
    after = _call(kernels.impact, columns, **normal)
    for index, (name, windows, _) in enumerate(kernels.SURFACES[:-1]):
        if not windows:
            placed = _call(getattr(kernels, f"{name}_place"), columns)
            _choose(which == index, placed, POSITION, columns)
    _choose(touches, after_errors, ERRORS[3:], columns)
    _choose(touches, after, MOTION, columns)


def _choose(
    where: Mask, values: Sequence[Any], names: Iterable[str], columns: dict[str, Any]
) -> None:
    """Put `values` into the named columns where the mask holds."""
    for name, value in zip(list(names), values, strict=True):
        columns[name] = np.where(where, value, columns[name])


def _record(
    flights: Flights,
    happened: Mask,
    which: NDArray[np.int64],
    before: Floats,
    out: Raw,
    offset: int,
) -> None:
    assert out.events is not None
    assert out.event_counts is not None
    row = flights.row[happened]
    rows = (row, out.event_counts[row])
    out.events["shot"][rows] = row + offset
    out.events["surface"][rows] = which[happened]
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
        *state_error, time_error = _call(kernels.error_bounds, flights.columns)
        if out.time_error is not None:
            out.time_error[row] = np.where(invalid, np.nan, time_error[over])
        if out.state_error is not None:
            bounds = np.stack(state_error, axis=1)[over]
            out.state_error[row] = np.where(invalid[:, None], np.nan, bounds)


def _call(kernel: Callable[..., Outputs], columns: Mapping[str, Any], **renamed: Any) -> Outputs:
    """Evaluate a kernel, its arguments taken by name."""
    code = kernel.__code__  # type: ignore[attr-defined]
    names = code.co_varnames[: code.co_argcount]
    return kernel(*[renamed[n] if n in renamed else columns[n] for n in names])


def _take(columns: Mapping[str, Column], which: Mask) -> dict[str, Column]:
    return {n: c if np.ndim(c) == 0 else np.asarray(c)[which] for n, c in columns.items()}
