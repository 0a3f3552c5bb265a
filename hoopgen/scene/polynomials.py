"""Formulas as polynomials in x, y and z, their coefficients formulas of the parameters."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from .formulas import POSITION, ZERO, Formula, FormulaError, constant
from .limits import current

Polynomial = dict[tuple[int, int, int], Formula]
"""Coefficients, by the powers of x, y and z."""


def polynomial(formula: Formula) -> Polynomial:
    """Return a formula as a polynomial in x, y and z; its coefficients have the other names.

    Raises
    ------
    FormulaError
        If it divides by x, y or z, has a root of them, or too many terms.
    """
    if not formula.names & set(POSITION):
        return {} if formula.number == 0 else {(0, 0, 0): formula}
    if formula.kind == "name":
        powers = [int(formula.value == axis) for axis in POSITION]
        return {(powers[0], powers[1], powers[2]): constant(1)}
    if formula.kind == "sqrt":
        raise FormulaError(
            f"not polynomial: {formula}. Square it: x**2 + y**2 - r**2, not sqrt(x**2 + y**2) - r"
        )
    if formula.kind == "/" and formula.parts[1].names & set(POSITION):
        raise FormulaError(f"not polynomial: {formula} divides by x, y or z")
    first, *rest = (polynomial(part) for part in formula.parts)
    if formula.kind == "+":
        return total([first, *rest])
    if formula.kind == "/":
        return {powers: factor / formula.parts[1] for powers, factor in first.items()}
    if formula.kind == "*":
        return product(first, rest[0])
    result = first
    for _ in range(int(formula.value) - 1):
        result = product(result, first)
    return result


def total(polynomials: Iterable[Polynomial]) -> Polynomial:
    """Return the sum of polynomials."""
    found: Polynomial = {}
    for each in polynomials:
        for powers, factor in each.items():
            found[powers] = found[powers] + factor if powers in found else factor
    return {powers: factor for powers, factor in found.items() if factor != ZERO}


def product(left: Polynomial, right: Polynomial) -> Polynomial:
    """Return the product of two polynomials.

    Parameters
    ----------
    left, right
        The factors.

    Raises
    ------
    FormulaError
        If it may have too many terms.
    """
    if excess := current().excess("polynomial_terms", len(left) * len(right)):
        raise FormulaError(f"as a polynomial: {excess}")
    return total(
        {(p[0] + q[0], p[1] + q[1], p[2] + q[2]): factor * other}
        for p, factor in left.items()
        for q, other in right.items()
    )


# Of numbers

Numbers = list[tuple[tuple[int, int, int], float]]
"""Powers of x, y, z and what they are multiplied by."""


def evaluate(terms: Numbers, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the values of a polynomial at points (..., 3).

    Parameters
    ----------
    terms
        The polynomial.
    points
        Points, (..., 3).
    """
    total = np.zeros(points.shape[:-1])
    for (i, j, k), factor in terms:
        total += factor * points[..., 0] ** i * points[..., 1] ** j * points[..., 2] ** k
    return total


def derivative(terms: Numbers, axis: int) -> Numbers:
    """Return the derivative of a polynomial along an axis.

    Parameters
    ----------
    terms
        The polynomial.
    axis
        The axis, 0 to 2.
    """
    found: Numbers = []
    for powers, factor in terms:
        if powers[axis]:
            lower = [power - (k == axis) for k, power in enumerate(powers)]
            found.append(((lower[0], lower[1], lower[2]), factor * powers[axis]))
    return found
