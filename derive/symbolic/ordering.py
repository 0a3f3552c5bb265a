"""The order of terms and factors, which decides how sums and products are rounded.

It follows from declarations alone: a scene's parameters come first, in the scene's order, then the
symbols of derive/ in the order of `letters.py`. No name has a part in it, so that a scene or a
formula with other names gives the same bits.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import Any

import sympy as sp

from .conditionals import (
    And,
    AtMost,
    Barrier,
    Choose,
    Equal,
    False_,
    IfAtMost,
    IfLess,
    Less,
    Not,
    Or,
)
from .letters import AXES, SERIES
from .notation import ARGUMENTS
from .symbols import ParameterSymbol, change_of

KINDS = (
    *(sp.Number, sp.Symbol, sp.Mul, sp.Add, sp.Pow, sp.Abs),
    *(Barrier, IfAtMost, IfLess, Choose),
    *(Less, AtMost, Equal, And, Or, Not, False_),
)
"""Kinds of expressions, in the order in which terms of them stand in a sum."""

_VECTORS = ("", "n", "v", "w", "d", "dn", "dv", "dw", "far_", "far_v", "far_w")
_COMPONENTS = (f"{vector}{axis}" for vector in _VECTORS for axis in AXES)
_FRAME = (f"n{row}{column}" for row in (1, 2, 3) for column in (1, 2, 3))
_FAMILIES = ("low", "high", "g")

PLACES = {
    name: place
    for place, name in enumerate(
        dict.fromkeys((*_FRAME, *_COMPONENTS, *ARGUMENTS, *SERIES, *_FAMILIES))
    )
}
"""The place of each symbol of derive/, or of the stem of those that have an index.

Normals are before velocities because products of a rolling ball then begin alike, and are shared.
"""

_INDEXED = re.compile(r"(\w*?[a-z])_?(\d+)", re.ASCII)


def declared_at(symbol: sp.Symbol) -> tuple[int, ...]:
    """Return the place of a symbol: parameters come first, and last what is not declared."""
    if isinstance(symbol, ParameterSymbol):
        return (0,)
    if symbol.name in PLACES:
        return (1, PLACES[symbol.name])
    match = _INDEXED.fullmatch(symbol.name)
    if match and match[1] in PLACES:
        return (1, PLACES[match[1]], int(match[2]))
    return (2,)


def in_order(symbols: Iterable[sp.Symbol]) -> tuple[sp.Symbol, ...]:
    """Return symbols as arguments of a kernel: as they are declared, parameters by name."""
    return tuple(sorted(symbols, key=lambda symbol: (declared_at(symbol), symbol.name)))


def ordering(symbols: Iterable[sp.Symbol] = ()) -> Callable[[sp.Basic], Any]:
    """Return a key by which terms and factors are sorted.

    Parameters
    ----------
    symbols
        The order of those that `derive/` does not declare: the parameters of a scene. Their changes
        have the same order.
    """
    own = [symbol for symbol in symbols if len(declared_at(symbol)) == 1]
    every = (*own, *map(change_of, own))
    ranks = {symbol: (*declared_at(symbol), place) for place, symbol in enumerate(every)}
    known: dict[sp.Basic, Any] = {}

    def key(expression: sp.Basic) -> Any:
        if expression not in known:
            known[expression] = find(expression)
        return known[expression]

    def find(expression: sp.Basic) -> Any:
        coefficient, body = sp.Integer(1), expression
        if isinstance(expression, sp.Expr):
            coefficient, body = expression.as_coeff_Mul()
        base, exponent = body.as_base_exp() if body.is_Pow else (body, sp.Integer(1))
        # What is of no kind is refused where it is lowered.
        kind = next((k for k, own in enumerate(KINDS) if isinstance(base, own)), len(KINDS))
        content: tuple[Any, ...]
        if base.is_Symbol:
            content = ranks.get(base) or declared_at(base)
        elif base.is_Number:
            content = (base,)
        else:
            parts = [key(part) for part in base.args]
            content = (len(parts), *(sorted(parts) if base.is_Add or base.is_Mul else parts))
        return (kind, content, exponent, coefficient)

    return key
