"""Running error analysis: how far a rounded evaluation of an expression can be from its value.

The bound is first order in the unit roundoff u and holds for any order of the sums and products
(Higham, Accuracy and Stability of Numerical Algorithms, sections 3.1 and 4.2); `SAFETY` covers the
second-order terms.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from .choice import Held
from .symbols import POSITION, UNIT_ROUNDOFF, VELOCITY

position_error, velocity_error = sp.symbols("position_error velocity_error", nonnegative=True)
"""Bounds on the error of each component of a computed position and velocity (`sensitivity.py`)."""

extent, speed = sp.symbols("extent speed", nonnegative=True)
"""Sums of the sizes of the coordinates and of the velocities at the start of a flight."""

SAFETY = 1 + sp.Rational(1, 2**10)
"""Covers terms of order u² and the rounding of the bound's own evaluation."""


@dataclass(frozen=True)
class Rounded:
    """A computed quantity: the largest magnitude of its value, and of its error."""

    magnitude: sp.Expr
    error: sp.Expr = sp.Integer(0)


def exact(expression: sp.Expr) -> Rounded:
    """Return the entry of a quantity that is an exact input."""
    return Rounded(sp.Abs(expression))


def rounding(expression: sp.Expr, known: Mapping[sp.Expr, Rounded]) -> Rounded:
    """Return magnitude and error bound of a rounded evaluation of `expression`.

    Parameters
    ----------
    expression
        Sums, products and integer powers of what `known` holds, parameters and constants.
    known
        Bounds of subexpressions, found before their parts are looked at: inputs, and whatever is
        better bounded by geometry than by its formula. A divisor must be entered as its inverse,
        unless it is a power of another symbol, which is an exact input.

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
    if isinstance(expression, Held):
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


def start_rounding() -> dict[sp.Expr, Rounded]:
    """Return bounds for the state at the start of a flight: its size, and what it may be off by."""
    known = {symbol: Rounded(extent, position_error) for symbol in POSITION}
    return known | {symbol: Rounded(speed, velocity_error) for symbol in VELOCITY}
