"""Polynomials in time: composition of coefficient lists, and Bernstein bounds.

A coefficient list holds the constant term first. Coefficients stay factored as they arise, so that
their cost stays near that of the expression they came from.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import reduce

import sympy as sp

from .conditionals import Barrier
from .ordering import ordering

Coefficients = list[sp.Expr]


def add(left: Sequence[sp.Expr], right: Sequence[sp.Expr]) -> Coefficients:
    """Return the coefficients of the sum.

    Parameters
    ----------
    left, right
        The coefficients of both polynomials, the constant first; the degrees may differ.
    """
    length = max(len(left), len(right))
    padded = [list(c) + [sp.Integer(0)] * (length - len(c)) for c in (left, right)]
    return [a + b for a, b in zip(*padded, strict=True)]


def multiply(left: Sequence[sp.Expr], right: Sequence[sp.Expr]) -> Coefficients:
    """Return the coefficients of the product.

    Parameters
    ----------
    left, right
        The coefficients of both polynomials, the constant first; neither is empty.
    """
    product = [sp.Integer(0)] * (len(left) + len(right) - 1)
    for i, a in enumerate(left):
        for j, b in enumerate(right):
            product[i + j] += a * b
    return product


def compose(
    expression: sp.Expr, substitution: Mapping[sp.Symbol, Sequence[sp.Expr]]
) -> Coefficients:
    """Return `expression`, polynomial in the keys of `substitution`, as a polynomial in time.

    Parameters
    ----------
    expression
        Built from symbols and constants by sums, products and natural powers.
    substitution
        Each coordinate's coefficient list, such as the flight's.

    Raises
    ------
    ValueError
        If the expression is not polynomial in the substituted symbols.
    """
    if expression in substitution:
        return list(substitution[expression])
    if not expression.free_symbols & set(substitution):
        return [expression]
    parts = [compose(argument, substitution) for argument in expression.args[:1]]
    if isinstance(expression, Barrier):
        return parts[0]
    if expression.is_Pow and expression.exp.is_Integer and expression.exp > 0:
        return reduce(multiply, parts * int(expression.exp))
    parts += [compose(argument, substitution) for argument in expression.args[1:]]
    if expression.is_Add:
        return reduce(add, parts)
    if expression.is_Mul:
        return reduce(multiply, parts)
    raise ValueError(f"not polynomial in the flight's coordinates: {expression}")


def horner(coefficients: Sequence[sp.Expr], variable: sp.Expr) -> sp.Expr:
    """Return the polynomial in nested form (Horner's rule).

    Parameters
    ----------
    coefficients
        The constant first.
    variable
        The variable of the polynomial.
    """
    return nested(coefficients, [variable] * (len(coefficients) - 1))


def nested(coefficients: Sequence[sp.Expr], factors: Sequence[sp.Expr]) -> sp.Expr:
    """Return c_0 + f_1 (c_1 + f_2 (c_2 + ...)).

    Parameters
    ----------
    coefficients
        c, of which there is one more than factors, or none.
    factors
        f.
    """
    if not coefficients:
        return sp.Integer(0)
    *first, result = coefficients
    for coefficient, factor in zip(reversed(first), reversed(factors), strict=True):
        result = coefficient + factor * result
    return result


def derivative(coefficients: Sequence[sp.Expr]) -> Coefficients:
    """Return the coefficients of the derivative by time."""
    return [k * c for k, c in enumerate(coefficients)][1:] or [sp.Integer(0)]


def bernstein(coefficients: Sequence[sp.Expr], width: sp.Expr) -> Coefficients:
    """Return the Bernstein coefficients on [0, width]; the polynomial lies in their range.

    Parameters
    ----------
    coefficients
        The constant first.
    width
        The length of the interval.
    """
    degree = len(coefficients) - 1
    return [
        sum(
            sp.binomial(i, j) / sp.binomial(degree, j) * coefficients[j] * width**j
            for j in range(i + 1)
        )
        for i in range(degree + 1)
    ]


def mean_rate(
    expression: sp.Expr,
    starts: Mapping[sp.Symbol, sp.Expr],
    rates: Mapping[sp.Symbol, sp.Expr],
) -> sp.Expr:
    """Return the change of a polynomial since a start over the elapsed time, free of a division.

    Parameters
    ----------
    expression
        In symbols that stand for present values; sums, products and natural powers.
    starts
        The value of each symbol at the start.
    rates
        The mean rate of each symbol since then.

    Raises
    ------
    ValueError
        If the expression is not polynomial in these symbols.
    """

    def then(part: sp.Expr) -> sp.Expr:
        return part.xreplace(dict(starts))

    if expression in rates:
        return rates[expression]
    if not expression.free_symbols & set(rates):
        return sp.Integer(0)
    if isinstance(expression, Barrier):
        return mean_rate(expression.args[0], starts, rates)
    if expression.is_Add:
        return sp.Add(*(mean_rate(term, starts, rates) for term in expression.args))
    if expression.is_Pow and expression.exp.is_Integer and expression.exp > 0:
        base, power = expression.base, int(expression.exp)
        between = (base**k * then(base) ** (power - 1 - k) for k in range(power))
        return mean_rate(base, starts, rates) * sp.Add(*between)
    if expression.is_Mul:
        first, *others = sorted(expression.args, key=ordering())
        rest = sp.Mul(*others)
        of_first, of_rest = (mean_rate(part, starts, rates) for part in (first, rest))
        return of_first * rest + then(first) * of_rest
    raise ValueError(f"not polynomial in the flight's coordinates: {expression}")
