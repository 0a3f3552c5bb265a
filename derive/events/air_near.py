"""The test that a piece of a flight through air comes to a surface at all, in single precision.

Up to a time T of at most the piece's length P and 2^-18 of it, a box contains the path of the
series (`enclosure`). The ball stays away from a surface's box if both are apart along an axis, and
from a plane if the box of the path is on one side of it, or outside of one of its bounds, or if the
ball moves away all the time. Its true place is off by at most 2^-25 M, with M = |x|₁ + V P and the
bound V on the speed: a piece with larger errors is uncertain (`over_budget`).

With u' = 2^-24, the unit roundoff of single precision, T and the coefficients are each off by u' of
their size. So with |v| + |V_1| T <= V half a displacement is off by at most 3 u' V T, a coordinate
of the box's centre by 4 u' M, its half size by 6 u' M and 11 u' of its part j T³/6, and a
difference from the surface's own numbers by 2 u' M more and, with at most `OPERATIONS` in these, by
35 u' of the sizes of their terms. `SHARE`, 64 u', of M, of that part and of these sizes is more
than all of it. It is far more than what underflow loses, as V is at least `TUBE` and P at least
2^-10 s. Where anything overflows, or is no number, no comparison holds, and the piece counts as
near.

Other numbers of a surface, as quotients, have no such bound in single precision; the same test is
then computed in double precision.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from ..motion.air import AirFlight
from ..motion.air_series import (
    DOUBLE_SERIES,
    SINGLE_SERIES,
    TUBE,
    Series,
    piece_extent,
    piece_jerk,
    piece_speed,
)
from ..surfaces import Plane, Surface
from ..symbolic.conditionals import Less, Not, absolute, any_of, barrier, minimum, release
from ..symbolic.rounding import Rounded, rounding
from ..symbolic.symbols import POSITION, position
from .event_polynomials import horizon

SHARE = sp.Rational(1, 2**18)
"""Share of sizes that covers roundings and errors of the state."""

OPERATIONS = 16
"""Largest number of operations in a number of a surface, for single precision to serve."""


def slopes(shape: sp.Expr) -> list[sp.Expr] | None:
    """Return the slopes of an expression that is linear in the position, else None.

    Parameters
    ----------
    shape
        An expression in the position.
    """
    along = sp.expand(release(shape))
    if not along.is_polynomial(*POSITION) or sp.Poly(along, *POSITION).total_degree() != 1:
        return None
    return [along.coeff(place) for place in POSITION]


def _linear_bounds(surface: Surface) -> list[sp.Expr]:
    """Return the bounds of a plane that are linear in the place, which holds on the plane."""
    if not isinstance(surface, Plane):
        return []
    onto = dict(zip(POSITION, position - surface.distance * surface.normal, strict=True))
    along = (release(bound).xreplace(onto) for bound in surface.bounds)
    return [bound for bound in along if slopes(bound) is not None]


def _size(number: sp.Expr) -> sp.Expr:
    """Return the sum of the sizes of all terms of a number."""
    return rounding(sp.sympify(number), {}).magnitude


def in_single(surface: Surface) -> bool:
    """Return whether single precision serves: the surface's numbers are short sums of products.

    Parameters
    ----------
    surface
        The surface.
    """
    halves = [half for half in surface.half_sizes if half is not None]
    own = [] if halves else [surface.shape, *_linear_bounds(surface)]
    linear = [slopes(one) for one in own]
    if any(found is None or not all(c.is_Rational for c in found) for found in linear):
        return False
    every = (*surface.reference_point, *halves, *own)
    numbers = [release(sp.sympify(number)) for number in every]
    return all(n.is_polynomial() is True and n.count_ops() <= OPERATIONS for n in numbers)


def _series(surface: Surface) -> Series:
    return SINGLE_SERIES if in_single(surface) else DOUBLE_SERIES


def _box(flight: AirFlight, of: Series) -> list[tuple[sp.Expr, sp.Expr]]:
    """Return for each axis the centre and the half size of a box of the path, with errors."""
    return flight.enclosure(horizon, of, barrier(SHARE * piece_extent))


def near_box(surface: Surface, flight: AirFlight) -> sp.Basic:
    """Return whether a piece may come into the surface's box before the horizon.

    Parameters
    ----------
    surface
        A curved surface, whose box may be infinite along some axes.
    flight
        A piece of a flight.
    """
    of = _series(surface)
    single = of is SINGLE_SERIES
    axes = zip(_box(flight, of), surface.reference_point, surface.half_sizes, strict=True)
    apart = []
    for (middle, reach), centre, half in axes:
        if half is not None:
            sizes = _size(centre) + _size(half) if single else sp.Abs(centre) + sp.Abs(half)
            near = barrier(half + SHARE * sizes)
            apart.append(Less(barrier(near + reach), barrier(absolute(barrier(middle - centre)))))
    return Not(any_of(*apart))


def near_plane(surface: Surface, flight: AirFlight) -> sp.Basic:
    """Return whether a piece may come to a plane from outside, within its bounds.

    Parameters
    ----------
    surface
        A surface whose shape is linear.
    flight
        A piece of a flight.
    """
    of = _series(surface)
    box = _box(flight, of)
    offsets = zip(POSITION, box, surface.reference_point, strict=True)
    away = {place: barrier(middle - own) for place, (middle, _), own in offsets}
    gap = barrier(absolute(barrier(surface.shape.xreplace(away))))
    missed = [Less(_reach(surface.shape, surface.reference_point, box), gap)]
    there = {place: middle for place, (middle, _) in zip(POSITION, box, strict=True)}
    for bound in _linear_bounds(surface):
        missed.append(
            Less(_reach(bound, (sp.Integer(0),) * 3, box), barrier(bound.xreplace(there)))
        )
    return Not(any_of(*missed, Less(0, least_rate(surface, of))))


def _reach(
    shape: sp.Expr, origin: Iterable[sp.Expr], box: Sequence[tuple[sp.Expr, sp.Expr]]
) -> sp.Expr:
    """Return the reach of a linear expression within a box, errors and roundings included."""
    along = slopes(shape)
    assert along is not None
    sizes = map(_size, origin)
    known = all(c.is_Rational for c in along)  # then those of the place are in the box
    place = {
        axis: Rounded(size if known else size + piece_extent)
        for axis, size in zip(POSITION, sizes, strict=True)
    }
    rounded = barrier(SHARE * rounding(release(shape), place).magnitude)
    return barrier(sum(abs(c) * half for c, (_, half) in zip(along, box, strict=True)) + rounded)


def least_rate(surface: Surface, of: Series) -> sp.Expr:
    """Return a bound below F' until the horizon, errors included.

    The velocity differs by at most j T²/2 from v + V_1 t, and by `TUBE` from the true one. The
    roundings of v + V_1 t are fewer than the 2^6 units that `SHARE` has of single precision.

    Parameters
    ----------
    surface
        A surface whose shape F is linear.
    of
        The symbols of the velocity's coefficients.
    """
    along = slopes(surface.shape)
    assert along is not None
    now, change = (
        barrier(sum(c * one for c, one in zip(along, vector, strict=True) if c != 0))
        for vector in of.velocities[:2]
    )
    bent = barrier(piece_jerk * barrier(horizon**2) * ((1 + SHARE) / 2))
    off = barrier(
        sum(map(abs, along)) * barrier(barrier(bent + TUBE) + barrier(SHARE * piece_speed))
    )
    return barrier(barrier(now + barrier(horizon * minimum(0, change))) - off)
