"""Expressions that stay as written: conditions, a choice between two values, a held quantity.

SymPy's Piecewise, Max and Min try to decide and simplify their conditions, which takes minutes on
the expressions here and changes their form. These stay as written until their condition is a
number; both values are then real, or one of them infinite.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, reduce
from typing import Any

import sympy as sp


class Truth(sp.Symbol):  # type: ignore[misc]
    """A symbol that holds or does not."""

    def __new__(cls, name: str) -> Truth:
        """Return the truth of that name."""
        made: Truth = super().__new__(cls, name, real=True)
        return made


class Condition(sp.Function):  # type: ignore[misc]
    """What holds or does not; a comparison with what is not a number does not hold."""


class Less(Condition):
    """Where left < right."""

    nargs = 2


class AtMost(Condition):
    """Where left <= right."""

    nargs = 2


class Equal(Condition):
    """Where left == right."""

    nargs = 2


class Both(Condition):
    """Where both hold."""

    nargs = 2


class Either(Condition):
    """Where one holds, or both."""

    nargs = 2


class Not(Condition):
    """Where it does not hold."""

    nargs = 1


class Nowhere(Condition):
    """What never holds."""

    nargs = 0


class Choose(sp.Function):  # type: ignore[misc]
    """`then` where a condition holds, else `other`."""

    nargs = 3
    is_extended_real = True


def every(first: sp.Basic, *others: sp.Basic) -> sp.Basic:
    """Return where all of the conditions hold."""
    return reduce(Both, others, first)


def some(first: sp.Basic, *others: sp.Basic) -> sp.Basic:
    """Return where any of the conditions holds."""
    return reduce(Either, others, first)


class _Choice(sp.Function):  # type: ignore[misc]
    nargs = 4
    is_extended_real = True

    @staticmethod
    def _holds(left: sp.Expr, right: sp.Expr) -> bool:
        raise NotImplementedError

    @classmethod
    def eval(cls, left: sp.Expr, right: sp.Expr, then: sp.Expr, other: sp.Expr) -> sp.Expr | None:
        """Decide as soon as both sides are numbers; a side that is none fails the condition."""
        if then == other:
            return then
        if left is sp.nan or right is sp.nan:
            return other
        if not (left.is_number and right.is_number):
            return None
        if not (left.is_extended_real and right.is_extended_real):
            return other
        return then if cls._holds(left, right) else other


class IfLess(_Choice):
    """`then` where left < right, else `other`."""

    @staticmethod
    def _holds(left: sp.Expr, right: sp.Expr) -> bool:
        return bool(left < right)


class IfAtMost(_Choice):
    """`then` where left <= right, else `other`."""

    @staticmethod
    def _holds(left: sp.Expr, right: sp.Expr) -> bool:
        return bool(left <= right)


class Held(sp.Function):  # type: ignore[misc]
    """A quantity that is computed once, as written, and then used as a whole.

    SymPy otherwise spreads a sign or a number over a sum, and so writes one sum in two ways.
    """

    nargs = 1
    is_extended_real = True
    name = ""
    """What it is called, in LaTeX; "" if it has no name."""

    @classmethod
    def eval(cls, quantity: sp.Expr) -> sp.Expr | None:
        """Hold whatever SymPy could spread something over or merge with its surroundings."""
        if isinstance(quantity, Held) and cls.name:
            return cls(quantity.args[0])
        return quantity if quantity.is_Atom or isinstance(quantity, Held) else None

    def __reduce_ex__(self, protocol: Any) -> tuple[Any, ...]:
        return hold, (*self.args, self.name)


@cache
def _held(name: str) -> type[Held]:
    """Return what holds quantities of a name: a function of its own that sorts as `Held` does."""
    kind: Any = type(Held)
    named: type[Held] = kind("Held", (Held,), {"name": name, "nargs": 1}) if name else Held
    return named


def hold(quantity: sp.Expr, name: str = "") -> sp.Expr:
    """Return the quantity, held; the name, in LaTeX, is for who reads of it and changes nothing.

    A symbol or a number is what it is, and has its own name.
    """
    return _held(name)(quantity)


def hold_all(vector: sp.Matrix, names: Sequence[str] = ()) -> sp.Matrix:
    """Return the vector, each component held."""
    given = names or [""] * len(vector)
    held = [hold(quantity, name) for quantity, name in zip(vector, given, strict=True)]
    return vector._new(*vector.shape, held)


def size(quantity: sp.Expr) -> sp.Expr:
    """Return the absolute value of the quantity as it is written; SymPy would turn its signs."""
    return sp.Abs(quantity, evaluate=False)


def release(expression: sp.Basic) -> sp.Basic:
    """Return the expression with nothing held, for proofs and derivatives."""
    return expression.replace(Held, lambda quantity: quantity)


def largest(first: sp.Expr | int, *others: sp.Expr) -> sp.Expr:
    """Return the largest of the values, the first if another is not a number."""
    first = sp.sympify(first)
    for other in map(sp.sympify, others):
        first = IfLess(first, other, other, first)
    return first


def smallest(first: sp.Expr | int, *others: sp.Expr) -> sp.Expr:
    """Return the smallest of the values, the first if another is not a number."""
    first = sp.sympify(first)
    for other in map(sp.sympify, others):
        first = IfLess(other, first, other, first)
    return first
