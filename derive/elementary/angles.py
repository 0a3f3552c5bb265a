"""Sine, cosine, tangent, arc tangent and hypotenuse.

An angle x is k π/2 + r with |r| <= π/4, up to roundings. With π/2 in four parts, of which three
have 30 bits, the products of k and a part are exact, and r is a sum of two doubles h + l that is
off by less than 2^-130 k. Taylor's polynomials of sine and cosine end where what is left out is
below 2^-60 of the result.
"""

from __future__ import annotations

import sympy as sp

from ..ir.kernel import Kernel, kernel
from ..symbolic.conditionals import (
    AtMost,
    Choose,
    Equal,
    IfAtMost,
    IfLess,
    Less,
    absolute,
    any_of,
    barrier,
    maximum,
    minimum,
)
from .compensated import horner, rest_of, square, truncated, two_sum

angle = sp.Symbol("angle", real=True)
"""x, rad."""
ordinate, abscissa = sp.symbols("ordinate abscissa", real=True)
"""Coordinates of a point, of which the angle or the distance is wanted."""

MAX_ANGLE = sp.Integer(2) ** 20
"""The largest angle, rad; beyond it sine and cosine are infinite, which no shot allows."""

ROUND_TO_INTEGER = sp.Rational(3, 2) * 2**52
"""A number to which a smaller one can only be added as an integer."""

SINE_TERMS, COSINE_TERMS, ARC_TANGENT_TERMS = 9, 10, 14
"""Terms of the series: what the next one is, of the result, is below 2^-60."""


def _nearest_integer(value: sp.Expr) -> sp.Expr:
    """Return the nearest integer to a number of size 2^51 at most."""
    return barrier(barrier(value + ROUND_TO_INTEGER) - ROUND_TO_INTEGER)


def _reduced() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Return h and l with x = k π/2 + h + l, and k modulo 4."""
    quarter_turn = sp.pi / 2
    first = truncated(quarter_turn, 29)
    second = truncated(quarter_turn - first, 59)
    third = truncated(quarter_turn - first - second, 89)
    fourth = rest_of(quarter_turn, first, second, third)
    turns = _nearest_integer(barrier(angle * rest_of(2 / sp.pi)))
    # The difference is exact: both terms are multiples of a unit of the last place of one of them.
    left = barrier(angle - barrier(turns * first))
    left, below = two_sum(left, -barrier(turns * second))
    left, further = two_sum(left, -barrier(turns * third))
    high, low = two_sum(left, barrier(barrier(below + further) - barrier(turns * fourth)))
    # k/4 - 3/8 is at least 1/8 from the middle of two integers.
    fours = _nearest_integer(barrier(turns / 4 - sp.Rational(3, 8)))
    return high, low, barrier(turns - 4 * fours)


def _sine_cosine() -> tuple[sp.Expr, sp.Expr]:
    high, low, quadrant = _reduced()
    high_square = barrier(high**2)
    cube = barrier(high_square * high)
    odd = [sp.Rational((-1) ** k, sp.factorial(2 * k + 1)) for k in range(1, SINE_TERMS)]
    even = [sp.Rational((-1) ** k, sp.factorial(2 * k)) for k in range(2, COSINE_TERMS)]
    half_square = barrier(high_square / 2)
    # The derivative of the sine, to the order that l needs.
    turned = barrier(low * barrier(1 - half_square))
    sine = barrier(high + barrier(barrier(cube * horner(odd, high_square)) + turned))
    head = barrier(1 - half_square)
    lost = barrier(barrier(1 - head) - half_square)
    fourth = barrier(high_square**2)
    tail = barrier(barrier(fourth * horner(even, high_square)) - barrier(high * low))
    cosine = barrier(head + barrier(lost + tail))
    swapped = any_of(Equal(quadrant, 1), Equal(quadrant, 3))
    upright, level = Choose(swapped, cosine, sine), Choose(swapped, sine, cosine)
    turned_back = any_of(Equal(quadrant, 1), Equal(quadrant, 2))
    signed = {
        "sine": IfLess(quadrant, 2, upright, -upright),
        "cosine": Choose(turned_back, -level, level),
    }
    beyond = Less(MAX_ANGLE, absolute(angle))
    sine, cosine = (barrier(Choose(beyond, sp.oo, value)) for value in signed.values())
    return sine, cosine


def sine_cosine() -> Kernel:
    """Return the kernel of the sine and the cosine, each within one unit in the last place."""
    sine, cosine = _sine_cosine()
    return kernel(
        "sine_cosine",
        {"sine": sine, "cosine": cosine},
        (angle,),
        "Sine and cosine of an angle, each within one unit in the last place.",
        "Taylor's series of the angle modulo a quarter of a turn",
    )


def tangent() -> Kernel:
    """Return the kernel of the tangent, within four units in the last place."""
    sine, cosine = _sine_cosine()
    return kernel(
        "tangent",
        {"tangent": sine / cosine},
        (angle,),
        "Tangent of an angle, within four units in the last place.",
        "sine over cosine",
    )


def arc_tangent() -> Kernel:
    """Return the kernel of a point's angle from the axis of abscissas, from -π to π.

    With s and L the smaller and the larger coordinate's size, s/L is tan(a + b) where tan(a) is 0,
    1/2 or 1, and tan(b) = (s - L tan(a))/(L + s tan(a)) is at most 1/4. Both differences are exact.
    """
    across, along = absolute(ordinate), absolute(abscissa)
    # In this order a coordinate that is no number remains one of the two.
    less, more = barrier(minimum(across, along)), barrier(maximum(along, across))
    low, high = AtMost(4 * less, more), Less(barrier(3 * more / 4), less)

    def by_part(first: sp.Expr, second: sp.Expr, third: sp.Expr) -> sp.Expr:
        return barrier(Choose(low, first, Choose(high, third, second)))

    over = by_part(less, less - more / 2, less - more)
    under = by_part(more, more + less / 2, more + less)
    # At the origin the angle is 0.
    small = barrier(IfAtMost(under, 0, 0, over / under))
    small_square = barrier(small**2)
    series = [sp.Rational((-1) ** k, 2 * k + 1) for k in range(1, ARC_TANGENT_TERMS)]
    added = barrier(barrier(small * small_square) * horner(series, small_square))
    half, one = sp.atan(sp.Rational(1, 2)), sp.pi / 4
    heads = [truncated(value, 50) for value in (half, one)]
    tails = [rest_of(value, head) for value, head in zip((half, one), heads, strict=True)]
    zero = sp.Integer(0)
    head, tail = by_part(zero, *heads), by_part(zero, *tails)
    acute = barrier(head + barrier(small + barrier(added + tail)))
    straight = truncated(sp.pi, 50)
    quarter = straight / 2
    rest = rest_of(sp.pi, straight)
    steep = barrier(quarter - barrier(acute - rest / 2))
    first = barrier(IfLess(along, across, steep, acute))
    second = barrier(IfLess(abscissa, 0, straight - barrier(first - rest), first))
    return kernel(
        "arc_tangent",
        {"angle": IfLess(ordinate, 0, -second, second)},
        (ordinate, abscissa),
        "Angle of a point from the axis of abscissas, within two units in the last place.",
        "atan(a) + atan(b) = atan((a + b)/(1 - ab)); Taylor's series",
    )


def hypotenuse() -> Kernel:
    """Return the kernel of a point's distance from the origin, within one unit in the last place.

    That holds for coordinates from 2^-480 to 2^480; a smaller one may count as 0. Newton's step
    from the rounded root corrects it by what the squares and their sum had lost.
    """
    squares, lost = zip(square(abscissa), square(ordinate), strict=True)
    total, below = two_sum(*squares)
    root = barrier(sp.sqrt(total))
    again, of_root = square(root)
    rest = barrier(barrier(total - again) - of_root)
    rest = barrier(rest + barrier(below + barrier(sum(lost))))
    corrected = barrier(root + barrier(rest / barrier(2 * root)))
    return kernel(
        "hypotenuse",
        {"distance": IfLess(0, root, corrected, root)},
        (ordinate, abscissa),
        "Distance of a point from the origin, within one unit in the last place.",
        "Pythagoras, and a step of Newton's method",
    )
