"""Bounds (Eq. 2) as lengths, so that decisions about them can allow for errors in metres."""

from __future__ import annotations

import sympy as sp

from ..symbolic.conditionals import absolute, barrier, release
from ..symbolic.symbols import POSITION


def as_length(bound: sp.Expr) -> sp.Expr:
    """Return an expression of the bound's sign whose gradient near zero is at most 1.

    A linear polynomial with a gradient of at most 1 is returned as it is, and so is an expression
    that is not a polynomial: its author makes it a length. Any other polynomial g is divided by G,
    the sum of the sizes of all terms of its gradient: near g = 0 that is a distance, or less. Its
    roundings are a few for each term and factor. It is also divided by the number of those that
    exceed what a decision allows for.
    """
    bare = release(sp.sympify(bound))
    if not bare.is_polynomial(*POSITION):
        return bound
    polynomial = sp.Poly(bare, *POSITION)
    degree, terms = polynomial.total_degree(), polynomial.terms()
    slopes = [c for powers, c in terms if sum(powers) == 1]
    if degree <= 1 and (sum(c**2 for c in slopes) <= 1) == sp.true:
        return bound
    sizes = (
        _absolute(coefficient) * _size(powers)
        for place in POSITION
        for powers, coefficient in polynomial.diff(place).terms()
    )
    roundings = sp.Integer(max(1, -(-(degree + len(terms)) // 4)))
    steepest = barrier(roundings * barrier(sp.Add(*sizes)))
    # Where the gradient vanishes, for example on an axis, only the sign counts.
    return bound / sp.sqrt(barrier(steepest**2 + sp.Abs(barrier(bound))))


def _absolute(coefficient: sp.Expr) -> sp.Expr:
    # SymPy would turn the signs of a sum by the names in it.
    return absolute(coefficient) if coefficient.has(sp.Add) else sp.Abs(coefficient)


def _size(powers: tuple[int, ...]) -> sp.Expr:
    return sp.Mul(*(sp.Abs(place) ** power for place, power in zip(POSITION, powers, strict=True)))
