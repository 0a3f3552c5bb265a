"""Expressions that stay as written: conditions, choices between two values, held quantities.

SymPy's Piecewise, Max and Min try to decide and simplify their conditions, which takes minutes on
the expressions here and changes their form. The classes of this module stay as written until their
condition is a number; both values are then real, or one of them is infinite.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, lru_cache, reduce
from typing import Any

import sympy as sp

_KEPT = 2**16
"""So many of the held quantities that were used last are one object each."""


class Boolean(sp.Symbol):  # type: ignore[misc]
    """A symbol that is true or false."""

    def __new__(cls, name: str) -> Boolean:
        """Return the symbol of that name."""
        symbol: Boolean = super().__new__(cls, name, real=True)
        return symbol


class Condition(sp.Function):  # type: ignore[misc]
    """A proposition; a comparison with a NaN is false."""


class Less(Condition):
    """The proposition left < right."""

    nargs = 2


class AtMost(Condition):
    """The proposition left <= right."""

    nargs = 2


class Equal(Condition):
    """The proposition left == right."""

    nargs = 2


class And(Condition):
    """The conjunction of two propositions."""

    nargs = 2


class Or(Condition):
    """The disjunction of two propositions."""

    nargs = 2


class Not(Condition):
    """The negation of a proposition."""

    nargs = 1


class False_(Condition):
    """The proposition that is always false."""

    nargs = 0


false = False_()
"""The only instance of `False_`."""


class Choose(sp.Function):  # type: ignore[misc]
    """`then` if a condition holds, else `other`."""

    nargs = 3
    is_extended_real = True


def all_of(first: sp.Basic, *others: sp.Basic) -> sp.Basic:
    """Return the conjunction of all conditions."""
    return reduce(And, others, first)


def any_of(first: sp.Basic, *others: sp.Basic) -> sp.Basic:
    """Return the disjunction of all conditions."""
    return reduce(Or, others, first)


class _Choice(sp.Function):  # type: ignore[misc]
    """A choice between two values by a comparison."""

    nargs = 4
    is_extended_real = True

    @staticmethod
    def _holds(left: sp.Expr, right: sp.Expr) -> bool:
        raise NotImplementedError

    @classmethod
    def eval(cls, left: sp.Expr, right: sp.Expr, then: sp.Expr, other: sp.Expr) -> sp.Expr | None:
        """Decide as soon as both sides are numbers; a NaN fails the comparison."""
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
    """`then` if left < right, else `other`."""

    @staticmethod
    def _holds(left: sp.Expr, right: sp.Expr) -> bool:
        return bool(left < right)


class IfAtMost(_Choice):
    """`then` if left <= right, else `other`."""

    @staticmethod
    def _holds(left: sp.Expr, right: sp.Expr) -> bool:
        return bool(left <= right)


class Barrier(sp.Function):  # type: ignore[misc]
    """A quantity that is computed once, as written, and then used as a whole.

    SymPy otherwise distributes a sign or a number over a sum, and so writes one sum in two ways.
    """

    nargs = 1
    is_extended_real = True
    name = ""
    """The LaTeX of the quantity's name; "" if it has none."""

    @classmethod
    def eval(cls, quantity: sp.Expr) -> sp.Expr | None:
        """Hold whatever SymPy could distribute something over or merge with its surroundings."""
        if isinstance(quantity, Barrier) and cls.name:
            return cls(quantity.args[0])
        return quantity if quantity.is_Atom or isinstance(quantity, Barrier) else None

    def __reduce_ex__(self, protocol: Any) -> tuple[Any, ...]:
        return barrier, (*self.args, self.name)


@cache
def _barrier(name: str) -> type[Barrier]:
    """Return the class that holds quantities of a name, which sorts as `Barrier` does."""
    kind: Any = type(Barrier)
    named: type[Barrier] = kind("Held", (Barrier,), {"name": name, "nargs": 1}) if name else Barrier
    return named


def barrier(quantity: sp.Expr, name: str = "") -> sp.Expr:
    """Return the quantity, held.

    Parameters
    ----------
    quantity
        A symbol or a number is returned as it is.
    name
        The quantity's name in LaTeX, for the derivation; it does not change the computation.
    """
    return _held(quantity, name)


@lru_cache(maxsize=_KEPT)
def _held(quantity: sp.Expr, name: str) -> sp.Expr:
    """Return the quantity, held; one object for equal ones.

    SymPy compares expressions that are equal, but not the same object, down to their symbols, and
    what occurs several times in them as often. So the time would grow exponentially with depth.
    """
    return _barrier(name)(quantity)


def barrier_all(vector: sp.Matrix, names: Sequence[str] = ()) -> sp.Matrix:
    """Return the vector with each component held.

    Parameters
    ----------
    vector
        A matrix of any shape.
    names
        The letter of each component on the pages of the derivation; empty for none.
    """
    given = names or [""] * len(vector)
    held = [barrier(quantity, name) for quantity, name in zip(vector, given, strict=True)]
    return vector._new(*vector.shape, held)


def absolute(quantity: sp.Expr) -> sp.Expr:
    """Return the absolute value as written; SymPy would move its signs."""
    return sp.Abs(quantity, evaluate=False)


def release(expression: sp.Basic) -> sp.Basic:
    """Return the expression with nothing held, for proofs and derivatives."""
    return expression.replace(Barrier, lambda quantity: quantity)


def maximum(first: sp.Expr | int, *others: sp.Expr) -> sp.Expr:
    """Return the maximum; where a comparison meets a NaN, the value before it is kept."""
    first = sp.sympify(first)
    for other in map(sp.sympify, others):
        first = IfLess(first, other, other, first)
    return first


def minimum(first: sp.Expr | int, *others: sp.Expr) -> sp.Expr:
    """Return the minimum; where a comparison meets a NaN, the value before it is kept."""
    first = sp.sympify(first)
    for other in map(sp.sympify, others):
        first = IfLess(other, first, other, first)
    return first
