"""Arrival at one surface on a piece of a flight, in balls."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, arb_poly, ctx

from .expressions import Function
from .formulas import Formulas, SurfaceFormulas
from .pieces import Piece
from .roots import Arrival, descent, first_arrival, possible_from, root_bound, sign
from .taylor_model import Number, ball, polynomial


def holds(bounds: Function, state: Sequence[Number], values: list[arb]) -> bool | None:
    """Return whether no bound is positive; None if that is not certain.

    Parameters
    ----------
    bounds
        (state, parameters) to the bounds.
    state
        The state, nine balls.
    values
        The kernels' inputs.
    """
    return _none_positive([sign(bound) for bound in bounds(state, values)])


def _none_positive(sides: Sequence[int | None]) -> bool | None:
    """Return whether no sign is positive; None if one is undecided and none is positive."""
    if 1 in sides:
        return False
    return None if None in sides else True


def stays_in(region: Function, path: Sequence[Number], values: list[arb]) -> bool | None:
    """Return whether a ball is in the region of a part of a box right after the start of a path.

    None if that is undecided. On the edge of two parts it is in the one that it moves to. Any other
    surface has no such region, and the ball is in it.

    Parameters
    ----------
    region
        (position, parameters) to polynomials, none of which is positive there.
    path
        The polynomials of the position.
    values
        The kernels' inputs.
    """
    return _none_positive([_side_after(bound) for bound in region(path, values)])


def _side_after(bound: Number) -> int | None:
    """Return the sign of a polynomial at small positive times."""
    return next((side for side in map(sign, bound.coeffs()) if side != 0), 0)


def arrival_at(
    formulas: Formulas,
    index: int,
    piece: Piece,
    values: list[arb],
    zeros: int,
    latest: arb,
) -> Arrival | None:
    """Return the first arrival at a surface, within its bounds.

    Exactly vanishing low coefficients are divided out: `zeros` of them by construction, and those
    that are seen to vanish. If there are any, the ball is on the surface, and the sign of the first
    that remains says whether it moves away, or is about to enter: an arrival now.

    Parameters
    ----------
    formulas
        The formulas of the scene.
    index
        The number of the surface.
    piece
        The piece of the flight.
    values
        The kernels' inputs.
    zeros
        The number of roots at t = 0, which are divided out. With three, the ball leaves the
        surface: the third coefficient vanishes to roundings alone, and the gap opens.
    latest
        The time up to which arrivals matter, s.
    """
    surface = formulas.surfaces[index]
    closed = piece.exact and surface.flat
    if not zeros and piece.is_aside(surface, values):
        return None
    leaves, zeros = zeros > 2, min(zeros, 2)
    coefficients = surface.condition(piece.path, values)[0].coeffs()
    while zeros < len(coefficients) and sign(coefficients[zeros]) == 0:
        zeros += 1
    rest = coefficients[zeros:]
    if not rest:
        return None
    moving = sign(rest[0])
    if moving is None and (zeros or not closed):
        return possible_from(arb(0))
    if moving == -1 and zeros and not leaves:
        entering = None
        if stays_in(surface.region, piece.path, values) is not False:
            entering = _check_bounds(surface, piece, values, Arrival(arb(0)))
        if entering is not None or closed:
            return entering
    if closed:
        arrival = descent(rest, moving)
        return None if arrival is None else _check_bounds(surface, piece, values, arrival)
    if moving == -1 and not (leaves or surface.bounded) and index < formulas.faces:
        raise AssertionError(f"the ball is inside the {surface.name}")
    return _first(surface, piece, values, rest, moving == -1, latest)


def _first(
    surface: SurfaceFormulas,
    piece: Piece,
    values: list[arb],
    coefficients: list[Number],
    inside: bool,
    latest: arb,
) -> Arrival | None:
    """Return the first arrival on a curved surface up to `latest`, or a little later.

    What lies out of bounds is passed, and so is the way out behind it.
    """
    while coefficients and coefficients[-1].is_zero():  # of a ball that moves along it
        coefficients = coefficients[:-1]
    if len(coefficients) < 2:
        return None
    end = latest if latest.is_finite() else root_bound(coefficients)
    if end is None:
        return possible_from(arb(0))
    end = (end * (1 + arb(2) ** -20)).upper()
    start = arb(0)
    while start < end:
        local = polynomial(coefficients)(arb_poly([start, 1])).coeffs()
        root = first_arrival([-c for c in local] if inside else local, end - start)
        if root is None:
            return None
        found = Arrival(start + root.time, root.certain, root.onwards)
        if not root.certain:
            return found
        if not inside:
            arrival = _check_bounds(surface, piece, values, found)
            if arrival is not None:
                return arrival
        behind = _behind(coefficients, ball(found.time), inside)
        if behind is None:
            return possible_from(found.time)
        inside, start = not inside, behind
    return None


def _behind(coefficients: list[Number], root: arb, inside: bool) -> arb | None:
    """Return a time behind a simple root, before the next one; None if none can be shown."""
    condition, wanted = polynomial(coefficients), 1 if inside else -1
    slope = condition.derivative()
    width = root.rad() + abs(root).upper() * arb(2) ** -(ctx.prec // 2)
    for _ in range(ctx.prec // 4):
        time = (root.upper() + width).mid()
        # Monotone up to there: no other root lies between.
        if sign(slope(root.union(time))) == wanted and sign(condition(time)) == wanted:
            return time
        width = width * 2
    return None


def _check_bounds(
    surface: SurfaceFormulas,
    piece: Piece,
    values: list[arb],
    arrival: Arrival,
) -> Arrival | None:
    """Return an arrival, dropped if certainly out of bounds, certain if certainly within them."""
    if arrival.onwards:
        return arrival
    there = piece.at(arrival.time)
    held = [holds(patch, there, values) for patch in surface.patches]
    if all(counts is False for counts in held):
        return None
    return Arrival(arrival.time, arrival.certain and True in held)
