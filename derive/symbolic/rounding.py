"""Running error analysis: bounds on how far a rounded evaluation is from the exact value.

The bound is first order in the unit roundoff u and holds for any order of the sums and products
(Higham, Accuracy and Stability of Numerical Algorithms, sections 3.1 and 4.2); `ROUNDING_SLACK`
covers the second-order terms.

**Lemma (bounds are rounded upwards).** Let B be a bound made by N additions, multiplications and
divisions of numbers that are not negative, by their maxima and minima and by comparisons. In
arithmetic with the unit roundoff u, without over- or underflow, `ROUNDING_SLACK` times B, as
computed, is at least B if N u <= 2^-12.

*Proof.* Each operation multiplies its result by a factor between 1 - u and 1 + u. A number that is
not negative grows with such a factor, or falls with that of a divisor; maxima and minima are
monotone. So the computed value of B is at least B (1 - u)^N/(1 + u)^N >= B (1 - 2 N u), and with
the product itself the factor is (1 + 2^-10) (1 - u) (1 - 2^-11) >= 1. ∎

That is 2^12 operations in single precision, and the margins have at most 110. A difference of
positive numbers as a divisor, as R_H - R is in those of the ring, is off by (R_H + R)/(R_H - R)
times as much as a sum: up to 2^5 times that counts for 2^7 operations.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from .conditionals import Barrier, release
from .symbols import UNIT_ROUNDOFF

position_error, velocity_error = sp.symbols("position_error velocity_error", nonnegative=True)
"""Bounds on the error of each component of a computed position and velocity (`errors/`)."""

extent, speed = sp.symbols("extent speed", nonnegative=True)
"""Sums of the absolute values of coordinates and of velocities at the start of a flight."""

ROUNDING_SLACK = 1 + sp.Rational(1, 2**10)
"""Covers terms of order u² and the rounding of the bound's own evaluation."""


@dataclass(frozen=True)
class Rounded:
    """A computed quantity: bounds on its absolute value and on its error."""

    magnitude: sp.Expr
    error: sp.Expr = sp.Integer(0)


def exact(expression: sp.Expr) -> Rounded:
    """Return the entry of a quantity that is an exact input."""
    return Rounded(sp.Abs(expression))


def is_input(expression: sp.Expr) -> bool:
    """Return whether an expression is an input or a number, of either sign: it has no rounding.

    Parameters
    ----------
    expression
        The expression, in which parts may be held.
    """
    plain = release(expression)
    return bool(plain.is_Symbol or (-plain).is_Symbol or plain.is_Number)


def rounding(expression: sp.Expr, known: Mapping[sp.Expr, Rounded]) -> Rounded:
    """Return magnitude and error bound of a rounded evaluation of `expression`.

    Parameters
    ----------
    expression
        Sums, products and integer powers of the keys of `known`, parameters and constants.
    known
        Bounds of subexpressions, which have precedence over those of their parts: inputs, and
        whatever geometry bounds better than its formula does. A divisor must be entered as its
        inverse, unless it is a power of another symbol, which is an exact input.

    Raises
    ------
    ValueError
        If a part is neither known nor a symbol, a sum, a product or a natural power.
    """
    if expression in known:
        return known[expression]
    if expression.is_Rational:
        representable = sp.Rational(float(expression)) == expression
        size = sp.Abs(expression)
        return Rounded(size, sp.Integer(0) if representable else UNIT_ROUNDOFF * size)
    if isinstance(expression, Barrier):
        return rounding(expression.args[0], known)
    if expression.is_Symbol:
        return exact(expression)
    if expression.is_Pow and expression.exp.is_Integer and expression.exp > 0:
        factors = [rounding(expression.base, known)] * int(expression.exp)
        return _product(factors)
    power = expression.is_Pow and expression.exp.is_Integer
    if power and expression.base.is_Symbol and expression.base not in known:
        size = sp.Abs(expression)  # of an exact input: its powers, and one division
        return Rounded(size, -expression.exp * UNIT_ROUNDOFF * size)
    parts = [rounding(argument, known) for argument in expression.args]
    if expression.is_Add:
        magnitude = sum(part.magnitude for part in parts)
        carried = sum(part.error for part in parts)
        return Rounded(magnitude, carried + (len(parts) - 1) * UNIT_ROUNDOFF * magnitude)
    if expression.is_Mul:
        return _product(parts)
    raise ValueError(f"no rounding bound for {expression}")


def _product(factors: list[Rounded]) -> Rounded:
    magnitude = sp.Mul(*(factor.magnitude for factor in factors))
    carried = sum(
        factor.error * sp.Mul(*(other.magnitude for j, other in enumerate(factors) if j != i))
        for i, factor in enumerate(factors)
    )
    return Rounded(magnitude, carried + (len(factors) - 1) * UNIT_ROUNDOFF * magnitude)
