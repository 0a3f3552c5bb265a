"""Things of one kind: the same but for their names and for the symbols of their sizes.

What is derived of one of them is true of all, with their symbols in the place of its own.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields
from typing import Any

import sympy as sp
from sympy.core.sorting import default_sort_key

from .symbols import ParameterSymbol

Symbols = Mapping[sp.Symbol, sp.Symbol]


@dataclass(frozen=True)
class Like:
    """What a thing is like.

    Attributes
    ----------
    first
        Index of the first thing of its kind.
    symbols
        The thing's own symbol for each of that one's; those that are the same are left out.
    """

    first: int
    symbols: Symbols


def kinds(things: Sequence[Any], shared: Iterable[sp.Symbol]) -> tuple[Like, ...]:
    """Return what each of some things is like.

    Parameters
    ----------
    things
        Dataclasses: surfaces, or laws. Their names do not count.
    shared
        Symbols that mean the same for all, such as that of gravity: what is derived may have them
        from elsewhere.
    """
    fixed = frozenset(shared)
    shapes: dict[Hashable, list[int]] = {}
    found: list[Like] = []
    for index, thing in enumerate(things):
        firsts = shapes.setdefault(_shape(_parts(thing), fixed), [])
        found.append(Like(index, {}))
        for first in firsts:
            symbols = _symbols(_parts(things[first]), _parts(thing), fixed)
            if symbols is not None:
                found[index] = Like(first, symbols)
                break
        else:
            firsts.append(index)
    return tuple(found)


def _parts(thing: Any) -> tuple[Any, ...]:
    """Return what a thing consists of: its class, and everything but its name, laid flat."""
    flat: list[Any] = [type(thing)]
    rest = [getattr(thing, f.name) for f in reversed(fields(thing)) if f.name != "name"]
    while rest:
        part = rest.pop()
        if isinstance(part, tuple):
            flat.append(len(part))
            rest += reversed(part)
        else:
            flat.append(part)
    return tuple(flat)


def _own(part: Any, fixed: frozenset[sp.Symbol]) -> set[sp.Symbol]:
    if not isinstance(part, sp.Basic):
        return set()
    return {s for s in part.atoms(ParameterSymbol) if s not in fixed}


def _blank(symbol: sp.Symbol) -> sp.Symbol:
    """Return what stands for any symbol of which the same is assumed."""
    return sp.Dummy("any", dummy_index=0, **symbol.assumptions0)


def _shape(parts: Sequence[Any], fixed: frozenset[sp.Symbol]) -> tuple[Any, ...]:
    """Return the parts with the same in the place of every symbol of their own."""
    return tuple(
        part.xreplace({s: _blank(s) for s in own}) if (own := _own(part, fixed)) else part
        for part in parts
    )


def _symbols(
    left: Sequence[Any], right: Sequence[Any], fixed: frozenset[sp.Symbol]
) -> dict[sp.Symbol, sp.Symbol] | None:
    """Return the symbols that turn the parts of one thing into those of another; None: none do."""
    found: dict[sp.Symbol, sp.Symbol] = {}
    for one, other in zip(left, right, strict=True):
        if not _own(one, fixed):
            if one != other:
                return None
            continue
        pairs = zip(_in_order(one, fixed), _in_order(other, fixed), strict=False)
        for own, theirs in pairs:
            if found.setdefault(own, theirs) != theirs or own.assumptions0 != theirs.assumptions0:
                return None
        if one.xreplace(found) != other:
            return None
    return {own: theirs for own, theirs in found.items() if own != theirs}


def _in_order(expression: sp.Basic, fixed: frozenset[sp.Symbol]) -> list[sp.Symbol]:
    """Return its own symbols as they are met, in an order that their names have no part in."""
    if isinstance(expression, ParameterSymbol):
        return [] if expression in fixed else [expression]
    blanks = {s: _blank(s) for s in _own(expression, fixed)}
    parts: Iterable[sp.Basic] = expression.args
    if expression.is_Add or expression.is_Mul:
        parts = sorted(parts, key=lambda part: default_sort_key(part.xreplace(blanks)))
    return [symbol for part in parts for symbol in _in_order(part, fixed)]
