"""Bounds (Eq. 2) as lengths: what a decision about one allows for is an error in metres."""

from __future__ import annotations

import sympy as sp

from ..ground.choice import hold, release
from ..ground.symbols import POSITION


def length(bound: sp.Expr) -> sp.Expr:
    """Return an expression of the bound's sign that, near zero, changes no faster than a length.

    A sum of coordinates with a gradient of at most 1 is one, and so is, by who wrote it, what is
    no polynomial. Any other polynomial g is divided by G, the sizes of all terms of its gradient
    together: near g = 0 that is a distance, or less than one. Its roundings then are a few for
    each term and factor, and are divided by as many as a decision does not allow for anyway.
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
        sp.Abs(polynomial.diff(place).coeff_monomial(powers)) * _size(powers)
        for place in POSITION
        for powers in polynomial.diff(place).monoms()
    )
    roundings = sp.Integer(max(1, -(-(degree + len(terms)) // 4)))
    steepest = hold(roundings * hold(sp.Add(*sizes)))
    # Where the gradient vanishes, on an axis for one, the sign is all that counts.
    return bound / sp.sqrt(hold(steepest**2 + sp.Abs(hold(bound))))


def _size(powers: tuple[int, ...]) -> sp.Expr:
    return sp.Mul(*(sp.Abs(place) ** power for place, power in zip(POSITION, powers, strict=True)))
