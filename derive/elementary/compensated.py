"""Sums whose rounding errors are kept, and polynomials as Horner's rule evaluates them.

Dekker, *A floating-point technique for extending the available precision* (1971); Knuth, *The Art
of Computer Programming*, volume 2, section 4.2.2, theorem B.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..symbolic.conditionals import barrier

DIGITS = 60
"""Decimal digits of the constants before they are rounded: over 190 bits."""

SPLITTER = sp.Integer(2) ** 27 + 1
"""The product with it shows the upper half of the digits of a double."""


def two_sum(first: sp.Expr, second: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return the rounded sum of two numbers and its error, which is exact (Knuth).

    Parameters
    ----------
    first, second
        The numbers, of any sizes.
    """
    total = barrier(first + second)
    of_second = barrier(total - first)
    of_first = barrier(total - of_second)
    return total, barrier(barrier(first - of_first) + barrier(second - of_second))


def square(value: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return the rounded square of a number and its error, which is exact (Dekker).

    It is exact unless a part under- or overflows: from 2^-480 to 2^480.
    """
    turned = barrier(SPLITTER * value)
    high = barrier(turned - barrier(turned - value))
    low = barrier(value - high)
    whole = barrier(value**2)
    error = barrier(barrier(high**2) - whole)
    error = barrier(error + barrier(2 * barrier(high * low)))
    return whole, barrier(error + barrier(low**2))


def horner(coefficients: Sequence[sp.Rational], variable: sp.Expr) -> sp.Expr:
    """Return a polynomial with the lowest coefficient first, by Horner's rule.

    Parameters
    ----------
    coefficients
        Rational numbers, each of which is rounded to a double where it is used.
    variable
        The variable of the polynomial.

    Returns
    -------
    Expr
        The polynomial, in which each product and each sum is rounded on its own.
    """
    *rest, value = coefficients
    for coefficient in reversed(rest):
        value = barrier(coefficient + barrier(variable * value))
    return value


def truncated(value: sp.Expr, bits: int) -> sp.Rational:
    """Return a positive constant, cut to a multiple of 2^-bits.

    Parameters
    ----------
    value
        A constant such as pi/2, of which SymPy knows every digit.
    bits
        The number of binary digits after the point.
    """
    return sp.Rational(int(sp.floor(value.evalf(DIGITS) * 2**bits)), 2**bits)


def rest_of(value: sp.Expr, *parts: sp.Rational) -> sp.Rational:
    """Return the excess of a constant over the sum of its first parts, to `DIGITS` digits."""
    return sp.Rational(str(value.evalf(DIGITS))) - sum(parts)
