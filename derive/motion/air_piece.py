"""The length of a piece of a flight through air, and a proved bound on what its series leaves out.

The polynomials v_n and σ_n of degree P fulfil both equations up to their degree, except for
roundings. With A_0 = σ_0 >= |V_0|, A_k = |V_k|₁ h^k, B_k = |σ_k| h^k and suffix sums S, on [0, h]

    |q_n - σ_n²| <= D = Σ_k (A_k S^A_{P+1-k} + B_k S^B_{P+1-k}) + ρ,
    |σ(v_n) - σ_n| <= D / s,   s = B_0 - S^B_1,
    |v_n' - f(v_n)| <= d = k_d (Σ_k B_k S^A_{P-k} + (D/s) S^A_0) + |Ω|₁ A_P + ρ'.

Within `TUBE` of v_n the derivative of f is at most L = 2 k_d (S^B_0 + D/s + `TUBE`) + |Ω|₁, so by
Gronwall's lemma an error E of the velocity at the start is at most G (E + ∫ d) with the growth
G = 1 / (1 - L h) >= exp(L h) at the end; that is proved if it does not exceed `TUBE`. What is left
out of the equations, without ρ and ρ', is of order P and more in t. So the integral over the piece
is h/(P+1) times this part of d, and h times the rest, and the position is off by the second
integral, h²/((P+1)(P+2)) and h²/2 times these, besides h G E. ρ and ρ' are what roundings leave of
the two equations: those of a sum of k + 1 products, and at most so many more as `SQUARE_ROUNDINGS`
and the constants after it say. With the unit roundoff u' of single precision, the orders from s =
`FIRST_SINGLE` on leave at most P + `SQUARE_ROUNDINGS` times u' Σ_k (A_k S^A_{s-k} + B_k S^B_{s-k})
of the first equation, with S_j = S_0 for j < 0, and as much of the second.

The bound itself is computed in single precision. Its roundings are less than a part of 2^-16, which
`ROUNDING_SLACK` and `CANCELLATION` contain.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from ..symbolic.conditionals import (
    Choose,
    IfLess,
    Less,
    absolute,
    all_of,
    barrier,
    maximum,
    minimum,
)
from ..symbolic.rounding import ROUNDING_SLACK, extent
from ..symbolic.symbols import UNIT_ROUNDOFF
from .air import AirFlight
from .air_series import (
    FIRST_SINGLE,
    ORDER,
    SINGLE_SERIES,
    SKETCH_TERMS,
    TUBE,
    growth,
    piece_acceleration,
    piece_extent,
    piece_jerk,
    piece_place_error,
    piece_rest,
    piece_speed,
    piece_speed_error,
    tail_lost,
    total,
    unproved,
)
from .air_series import piece as piece_length

TOLERANCE = sp.Rational(5, 2**49)
"""m/s: a piece is so long that about this much of the velocity is left out."""

MAX_RADIUS = sp.Integer(3)
"""Largest radius of convergence that the length of a piece is chosen for, s."""

LONGEST = sp.Rational(1, 3)
"""Length of the longest piece by the radius of convergence."""

SHORTEST = sp.Rational(1, 2**10)
"""Shortest piece, s."""

SINGLE_ROUNDOFF = sp.Rational(1, 2**24)
"""u', the unit roundoff of single precision."""

PIECE_UNIT = sp.Rational(1, 2**20)
"""Lengths of pieces are multiples of this, s, so that sums and differences of them are exact."""

PIECE_GRAIN = sp.Rational(3, 2) * PIECE_UNIT / (2 * SINGLE_ROUNDOFF)
"""A number to which a shorter time is added as a multiple of `PIECE_UNIT`."""

MAX_POWER = 12
"""Largest power of a time that is computed: that of `SHORTEST` is 2^-120."""

OVERLAP = sp.Rational(1, 2**10)
"""Share of a piece for which its bounds hold beyond its end."""

SQUARE_ROUNDINGS = 8
"""At most so many roundings of σ_k² besides those of its sum: at k = 0 three of v·v, one of v_s²,
one of the sum and two of the root; later three of a product of vectors, one of a product, one of
the difference, one of 1/σ_0 and one of the product with it. In single precision three at most are
of numbers that are taken from double precision: the factors of a product, and 1/σ_0."""

DRAG_ROUNDINGS = 12
"""At most so many roundings of k_d σ v besides those of its sum: seven of k_d, one of a product in
the sum, one of the product with k_d, and two of the sum of forces and the quotient. In single
precision there are three of numbers that are taken from double precision in place of those of
k_d."""

MAGNUS_ROUNDINGS = 14
"""At most so many roundings of Ω × v: nine of Ω, two of a product of vectors, and two of the sum of
forces and the quotient."""

WEIGHT_ROUNDINGS = 8
"""At most so many roundings of g_e, relative to g (1 + b) where the air carries the share b < 1:
nine of b, relative to g b, and one each of the difference, the product and the sum of forces."""

CANCELLATION = sp.Rational(1, 2**14)
"""Share of a positive quantity that covers the roundings of what is subtracted from it."""

UNDERFLOW = sp.Rational(1, 2**100)
"""Far more than what is lost of a product of the two equations where one of its parts underflows,
relative to the others or to 1."""


def _norm(vector: Sequence[sp.Expr]) -> sp.Expr:
    """Return the sum of the sizes of the components."""
    return barrier(sum(absolute(c) for c in vector if c != 0))


def _suffix_sums(sizes: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Return the sums of all sizes from each one on."""
    found = [sizes[-1]]
    for size in reversed(sizes[:-1]):
        found.append(barrier(size + found[-1]))
    return found[::-1]


def _late(sizes: Sequence[sp.Expr], sums: Sequence[sp.Expr], others: Sequence[sp.Expr]) -> sp.Expr:
    """Return the sum of all products of two sizes whose orders are together `FIRST_SINGLE` or more.

    Parameters
    ----------
    sizes, sums
        The first factors by order, and their suffix sums.
    others
        The suffix sums of the second factors.
    """
    first = FIRST_SINGLE
    early = (barrier(sizes[k] * others[first - k]) for k in range(first))
    return total([*early, barrier(sums[first] * others[0])])


def half_of_products(sizes: Sequence[sp.Expr], sums: Sequence[sp.Expr], first: int) -> sp.Expr:
    """Return a bound on half the sum of products of two sizes of orders that are `first` together.

    It counts products of orders that are together more, too. One of the two orders is more than
    half of `first`, or both are half of it. The few products of two such orders count twice.

    Parameters
    ----------
    sizes, sums
        The sizes by order, and their suffix sums.
    first
        The least sum of the orders.
    """
    latest = min(first, len(sizes))
    halves = [barrier(sizes[k] * sums[first - k]) for k in range(first // 2 + 1, latest)]
    if first < len(sizes):
        halves.append(barrier(sums[first] * sums[0]))
    if first % 2 == 0:
        halves.append(barrier(sizes[first // 2] ** 2) / 2)
    return total(halves)


def counted(sums: Sequence[sp.Expr]) -> sp.Expr:
    """Return a bound on the sum of k times a size of order k: Σ S_j with S_j <= S_4 from there on.

    Parameters
    ----------
    sums
        The suffix sums of the sizes.
    """
    return total([*sums[1:4], (ORDER - 3) * sums[4]])


def counted_twice(sums: Sequence[sp.Expr]) -> sp.Expr:
    """Return a bound on the sum of k (k - 1) times a size of order k: 2 Σ (j - 1) S_j, as above.

    Parameters
    ----------
    sums
        The suffix sums of the sizes.
    """
    known = 6
    rest = ORDER * (ORDER - 1) - (known - 1) * (known - 2)
    return total([*(2 * (j - 1) * sums[j] for j in range(2, known)), rest * sums[known]])


def late_roundings(
    a: Sequence[sp.Expr], b: Sequence[sp.Expr], drag: sp.Expr, turning: sp.Expr
) -> tuple[sp.Expr, sp.Expr]:
    """Return bounds on the roundings of the orders in single precision at the end of a piece.

    Parameters
    ----------
    a, b
        A_k and B_k, by order.
    drag, turning
        k_d and |Ω|₁.

    Returns
    -------
    tuple of Expr
        Of the equation of the speed, m²/s², and of that of the velocity, m/s².
    """
    sums_a, sums_b = _suffix_sums(a), _suffix_sums(b)
    halves = (half_of_products(*one, FIRST_SINGLE) for one in ((a, sums_a), (b, sums_b)))
    drags = barrier((DRAG_ROUNDINGS + ORDER) * barrier(drag * _late(b, sums_b, sums_a)))
    lifts = barrier(MAGNUS_ROUNDINGS * barrier(turning * sums_a[FIRST_SINGLE]))
    return (
        barrier(2 * SINGLE_ROUNDOFF * (SQUARE_ROUNDINGS + ORDER) * total([*halves])),
        barrier(SINGLE_ROUNDOFF * barrier(drags + lifts)),
    )


def _sizes(norms: Sequence[sp.Expr], time: sp.Expr) -> list[sp.Expr]:
    """Return sizes of coefficients times powers of the time, none of which underflows."""
    powers: list[sp.Expr] = [sp.Integer(1), time]
    for _ in range(2, MAX_POWER + 1):
        powers.append(barrier(powers[-1] * time))
    found = []
    for k, norm in enumerate(norms):
        low = barrier(norm * powers[min(k, MAX_POWER)]) if k else norm
        found.append(barrier(low * powers[k - MAX_POWER]) if k > MAX_POWER else low)
    return found


def _integrals(by_order: Mapping[int, sp.Expr]) -> tuple[sp.Expr, sp.Expr]:
    """Return the integrals over t/h from 0 to 1 of a sum of c (t/h)^k, and twice.

    Parameters
    ----------
    by_order
        By k, the factor c.
    """
    once = (c / (k + 1) for k, c in by_order.items())
    return total([*once]), total([c / ((k + 1) * (k + 2)) for k, c in by_order.items()])


def _length(flight: AirFlight) -> sp.Expr:
    """Return the length of the piece that the series is good for, s, a multiple of `PIECE_UNIT`."""
    weight = _norm(flight.fall)
    fallen = barrier(SINGLE_SERIES.airspeeds[0] / barrier(IfLess(0, weight, weight, 1)))
    # Without drag the velocity's series says nothing of that of σ, whose radius is about this.
    radius = barrier(IfLess(0, weight, minimum(MAX_RADIUS, fallen), MAX_RADIUS))
    before, last = (_norm(SINGLE_SERIES.velocities[k]) for k in (ORDER - 1, ORDER))
    size = barrier(maximum(before, barrier(last * radius)) * barrier(radius ** (ORDER - 1)))
    share = minimum(LONGEST**16, IfLess(0, size, barrier(TOLERANCE / size), sp.oo))
    for _ in range(4):
        share = barrier(sp.sqrt(share))
    length = barrier(radius * share)
    return barrier(maximum(barrier(barrier(length + PIECE_GRAIN) - PIECE_GRAIN), SHORTEST))


def piece(flight: AirFlight) -> dict[str, sp.Expr]:
    """Return the length of the piece, and bounds that hold somewhat beyond it, in single precision.

    The errors are what the piece adds to those at its start, in Euclidean norm.
    """
    of, last = flight.constants, ORDER
    length = _length(flight)
    time = barrier(length + OVERLAP * length)
    # σ_0 is the norm of v, and smaller than the sum of its components' sizes.
    norms = [SINGLE_SERIES.airspeeds[0], *(_norm(v) for v in SINGLE_SERIES.velocities[1:])]
    a = _sizes(norms, time)
    b = _sizes([absolute(s) for s in SINGLE_SERIES.airspeeds], time)
    sums_a, sums_b = _suffix_sums(a), _suffix_sums(b)
    # Σ k A_k and Σ k B_k: a sum of k + 1 products has k roundings more than one product.
    counted_a, counted_b = counted(sums_a), counted(sums_b)
    halves = (half_of_products(*one, last + 1) for one in ((a, sums_a), (b, sums_b)))
    square = barrier(2 * total([*halves]))
    squares = barrier(barrier(sums_a[0] ** 2) + barrier(sums_b[0] ** 2) + flight.smoothing)
    least = barrier(barrier((1 - CANCELLATION) * b[0]) - sums_b[1])
    sums = barrier(sums_a[0] * counted_a + sums_b[0] * counted_b)
    lost = barrier(UNDERFLOW * barrier(barrier(1 + sums_a[0]) * barrier(1 + sums_b[0])))
    rounded = barrier(barrier(UNIT_ROUNDOFF * barrier(SQUARE_ROUNDINGS * squares + sums)) + lost)
    turning = _norm(SINGLE_SERIES.magnus_rate)
    rounded_late, terms_late = late_roundings(a, b, SINGLE_SERIES.drag_rate, turning)
    per_least = barrier(1 / least)
    off_left_out = barrier(square * per_least)
    off_rounded = barrier(barrier(ROUNDING_SLACK * rounded) * per_least)
    off_late = barrier(barrier(ROUNDING_SLACK * rounded_late) * per_least)
    off = total([off_left_out, off_rounded, off_late])
    left_out = total([barrier(b[k] * sums_a[last - k]) for k in range(last + 1)])
    dragged = barrier(
        SINGLE_SERIES.drag_rate * barrier(left_out + barrier(off_left_out * sums_a[0]))
    )
    truncated = barrier(dragged + barrier(turning * a[last]))
    products = barrier(sums_b[0] * counted_a + sums_a[0] * counted_b)
    drags = barrier(
        SINGLE_SERIES.drag_rate
        * barrier(DRAG_ROUNDINGS * barrier(sums_b[0] * sums_a[0]) + products)
    )
    gravity = [sp.Abs(component) for component in flight.acceleration if component != 0]
    weight = barrier(barrier(sum(gravity)) * barrier(1 + of.buoyancy))
    lifts = barrier(MAGNUS_ROUNDINGS * barrier(turning * sums_a[0]))
    terms = barrier(barrier(drags + lifts) + WEIGHT_ROUNDINGS * weight)
    unrounded = total(
        [
            barrier(SINGLE_SERIES.drag_rate * barrier(off_rounded * sums_a[0])),
            ROUNDING_SLACK * barrier(UNIT_ROUNDOFF * terms),
            barrier(lost * barrier(1 + barrier(SINGLE_SERIES.drag_rate + turning))),
        ]
    )
    unrounded_late = barrier(
        barrier(SINGLE_SERIES.drag_rate * barrier(off_late * sums_a[0]))
        + ROUNDING_SLACK * terms_late
    )
    defect = total([truncated, unrounded, unrounded_late])
    widest = barrier(barrier(sums_b[0] + off) + TUBE)
    slope = barrier(barrier(2 * SINGLE_SERIES.drag_rate * widest) + turning)
    room = barrier((1 - CANCELLATION) - barrier(time * slope))
    grown = barrier(ROUNDING_SLACK / room)
    once, twice = _integrals({ORDER: truncated, FIRST_SINGLE: unrounded_late, 0: unrounded})
    exact = barrier(grown * barrier(once * time))
    moved = barrier(barrier(grown * barrier(twice * time)) * time)
    proved = all_of(*(Less(0, least), Less(0, room), Less(exact, TUBE / 2), Less(tail_lost, 1)))
    # V_k t^(k+1)/(k + 1) has 4 k + 1 roundings in nested form, and that of the product with t.
    path = barrier(8 * barrier(time * sums_a[0]) + extent)
    rolled = barrier(ROUNDING_SLACK * barrier(barrier(2 * counted_a) + sums_a[0]))
    place_error = barrier(ROUNDING_SLACK * barrier(moved + UNIT_ROUNDOFF * path))
    speed_error = barrier(exact + UNIT_ROUNDOFF * rolled)
    per_time = barrier(1 / time)
    # The true velocity is within the tube, and its rate differs by the slope and the defect.
    beside = barrier(barrier(slope * TUBE) + defect)
    first = barrier(counted_a * per_time)
    second = barrier(counted_twice(sums_a) * per_time**2)
    swift = barrier(ROUNDING_SLACK * sums_a[0] + TUBE)
    return {
        piece_length.name: length,
        growth.name: Choose(proved, grown, 1),
        piece_place_error.name: Choose(proved, place_error, 0),
        piece_speed_error.name: Choose(proved, speed_error, 0),
        unproved.name: Choose(proved, 0, sp.oo),
        piece_speed.name: swift,
        piece_acceleration.name: barrier(ROUNDING_SLACK * barrier(first + beside)),
        piece_jerk.name: barrier(ROUNDING_SLACK * second),
        piece_rest.name: barrier(ROUNDING_SLACK * sums_a[SKETCH_TERMS]),
        piece_extent.name: barrier(ROUNDING_SLACK * barrier(extent + time * swift)),
    }
