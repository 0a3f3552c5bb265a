"""The certainly earliest event on a piece of a flight, or a time until which there is none."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from flint import arb

from .arrivals import arrival_at, holds
from .clear_flight import clear_until, misses_body
from .formulas import Formulas
from .pieces import Piece
from .roots import Arrival, Undecided
from .taylor_model import Number, ball

_NEVER = arb.pos_inf()

_SKIPPED = 0.99
"""Share of a time without events that is skipped."""


def clear_time(
    formulas: Formulas,
    piece: Piece,
    values: list[arb],
    begin: float,
    latest: Number | None,
) -> arb:
    """Return a time after `begin` until which a box of flights meets nothing; 0 if none is found.

    A box of flights that cannot be decided from its start perhaps can be from there.

    Parameters
    ----------
    formulas, piece, values
        As for `clear_until`.
    begin
        Time since the start of the piece until which nothing is met, s.
    latest
        The time left until the time limit, s; None without one.
    """
    end = math.inf if latest is None else _float_below(latest)
    reached = clear_until(formulas, piece, values, begin, end)
    # Right before an event of some of the flights it is hard to tell that no other one had its own.
    return arb(begin + _SKIPPED * (reached - begin)) if reached > begin else arb(0)


def first_on_piece(
    formulas: Formulas,
    piece: Piece,
    values: list[arb],
    last: int,
    vanishing: int,
    remaining: Number | None,
    may_stop: bool,
) -> tuple[int, Number] | None:
    """Return surface and time of the certainly earliest arrival on a piece; None without one.

    The time limit counts where something else is met too: what meets nothing any more can reach no
    end. Where there are no ends, or where a flight has pieces, it always counts. The end of the
    piece counts as a surface beyond that. If `may_stop`, a box of flights that cannot be decided
    ends its piece at a time until which it meets nothing.

    Parameters
    ----------
    formulas, piece, values
        As for `clear_until`.
    last
        The number of the surface that the ball leaves, or -1.
    vanishing
        The number of low coefficients of its event polynomial that vanish.
    remaining
        The time left until the time limit, s; None without one.
    may_stop
        Whether the piece may end early.

    Raises
    ------
    Undecided
        If no arrival is certainly the earliest.
    """
    arrivals: dict[int, Arrival] = {}
    latest = _NEVER
    names = [*(surface.name for surface in formulas.surfaces), "time limit", "end of a piece"]
    limit, end, open_ended = len(names) - 2, len(names) - 1, formulas.open_ended
    if piece.span.is_finite():
        arrivals[end], latest = Arrival(piece.span), piece.span
    if remaining is not None and open_ended:
        arrivals[limit], latest = Arrival(remaining), latest.min(remaining.upper())
    for parts in formulas.order:
        for k in _reached(formulas, parts, piece, values, last, latest):
            zeros = vanishing if k == last else 0
            arrival = _arrival(formulas, k, piece, values, zeros, latest)
            if arrival is not None:
                arrivals[k] = arrival
                if arrival.certain and arrival.time < latest:
                    latest = arrival.time.upper()
    if not arrivals:
        return None
    certain = [k for k, arrival in arrivals.items() if arrival.certain]
    if remaining is not None and certain and not open_ended:
        arrivals[limit] = Arrival(remaining)
        certain.append(limit)
    best = min(certain, key=lambda k: float(arrivals[k].time.mid()), default=-1)
    if best >= 0 and piece.has_models:
        _drop_missed(formulas, piece, values, arrivals, best)
    try:
        _check_earliest(formulas, arrivals, best, names)
    except Undecided:
        begin = min(_float_below(arrival.time) for arrival in arrivals.values())
        if not (may_stop and piece.has_models and begin > 0.0):
            raise
        skipped = clear_time(formulas, piece, values, begin, remaining)
        if not skipped > 0:
            raise
        return end, skipped
    return best, arrivals[best].time


def _arrival(
    formulas: Formulas, k: int, piece: Piece, values: list[arb], zeros: int, latest: arb
) -> Arrival | None:
    """Return the first arrival at a surface, None if balls or models rule it out."""
    arrival = arrival_at(formulas, k, piece.in_balls, values, zeros, latest)
    if arrival is None or not piece.has_models:
        return arrival
    closer = arrival_at(formulas, k, piece, values, zeros, latest)
    return arrival if closer is not None and not closer.certain and arrival.certain else closer


def _reached(
    formulas: Formulas,
    parts: Sequence[int],
    piece: Piece,
    values: list[arb],
    last: int,
    latest: arb,
) -> Iterator[int]:
    """Yield the parts of a body that a flight may come to up to a time: of several, not all."""
    if len(parts) < 2 or piece.has_models or not latest.is_finite():
        yield from parts
        return
    until = -_float_below(-latest)
    if last not in parts and misses_body(formulas, parts[0], piece, values, 0.0, until):
        return
    there = piece.at(arb(0).union(latest))
    for k in parts:
        patches = formulas.surfaces[k].patches
        if k == last or any(holds(patch, there, values) is not False for patch in patches):
            yield k


def _drop_missed(
    formulas: Formulas,
    piece: Piece,
    values: list[arb],
    arrivals: dict[int, Arrival],
    best: int,
) -> None:
    """Drop arrivals that are not certain, at bodies that are certainly missed until `best`."""
    until = -_float_below(-arrivals[best].time)
    bodies: dict[int, list[int]] = {}
    for k, arrival in arrivals.items():
        if k < formulas.faces and not arrival.certain:
            bodies.setdefault(formulas.surfaces[k].face, []).append(k)
    for found in bodies.values():
        begin = max(0.0, min(_float_below(arrivals[k].time) for k in found))
        if misses_body(formulas, found[0], piece, values, begin, until):
            for k in found:
                del arrivals[k]


def _float_below(number: Number) -> float:
    """Return a double below all values of a number."""
    return math.nextafter(float(ball(number).lower()), -math.inf)


def _check_earliest(
    formulas: Formulas, arrivals: dict[int, Arrival], best: int, names: Sequence[str]
) -> None:
    """Raise Undecided unless an arrival, `best`, certainly comes before all others."""
    for k, arrival in arrivals.items():
        if k != best and not (best >= 0 and arrivals[best].time < arrival.time):
            if arrival.certain and _seam(formulas, k, best):
                continue
            if not arrival.certain:
                raise Undecided(f"whether the ball meets the {names[k]}")
            raise Undecided(f"whether the {names[k]} or the {names[best]} comes first")


def _seam(formulas: Formulas, one: int, other: int) -> bool:
    """Return whether both are parts of one surface, which is smooth where they meet."""
    if max(one, other) >= len(formulas.surfaces):  # the time limit, or the end of a piece
        return False
    return formulas.surfaces[one].face == formulas.surfaces[other].face
