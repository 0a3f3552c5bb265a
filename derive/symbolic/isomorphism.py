"""Isomorphic surfaces and laws: equal but for their names and the symbols of their parameters.

A kernel of one of them is valid for all, with their symbols in the place of its own.
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
class Isomorphism:
    """The first thing that a thing is isomorphic to, and the symbols that map one onto the other.

    Attributes
    ----------
    first
        Index of the first thing of the class.
    symbols
        The thing's own symbol for each symbol of the first thing; equal symbols are left out.
    """

    first: int
    symbols: Symbols


def isomorphisms(things: Sequence[Any], shared: Iterable[sp.Symbol]) -> tuple[Isomorphism, ...]:
    """Return the isomorphism of each thing to the first of its class.

    Parameters
    ----------
    things
        Dataclasses: surfaces, or laws. Their names do not count.
    shared
        Symbols that mean the same in all things, such as gravity.
    """
    fixed = frozenset(shared)
    shapes: dict[Hashable, list[int]] = {}
    found: list[Isomorphism] = []
    for index, thing in enumerate(things):
        firsts = shapes.setdefault(_shape(_parts(thing), fixed), [])
        found.append(Isomorphism(index, {}))
        for first in firsts:
            symbols = _symbols(_parts(things[first]), _parts(thing), fixed)
            if symbols is not None:
                found[index] = Isomorphism(first, symbols)
                break
        else:
            firsts.append(index)
    return tuple(found)


def _parts(thing: Any) -> tuple[Any, ...]:
    """Return the class of a thing and all its parts but the name, as a flat tuple."""
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
    """Return the parameters in a part, without those that all things share."""
    if not isinstance(part, sp.Basic):
        return set()
    return {s for s in part.atoms(ParameterSymbol) if s not in fixed}


def _blank(symbol: sp.Symbol, number: int = 0) -> sp.Symbol:
    """Return the stand-in for any symbol with the same assumptions, or for a known one."""
    return sp.Dummy("any", dummy_index=number, **symbol.assumptions0)


def _shape(parts: Sequence[Any], fixed: frozenset[sp.Symbol]) -> tuple[Any, ...]:
    """Return the parts with one stand-in for every parameter of their own."""
    return tuple(
        part.xreplace({s: _blank(s) for s in own}) if (own := _own(part, fixed)) else part
        for part in parts
    )


def _symbols(
    left: Sequence[Any], right: Sequence[Any], fixed: frozenset[sp.Symbol]
) -> dict[sp.Symbol, sp.Symbol] | None:
    """Return the symbols that map the parts of one thing onto those of another; None if none do.

    Parts that are a symbol come first: in a sum they tell apart terms of one form.
    """
    found: dict[sp.Symbol, sp.Symbol] = {}
    parts = list(zip(left, right, strict=True))
    parts.sort(key=lambda pair: not isinstance(pair[0], sp.Symbol))
    for one, other in parts:
        if not _own(one, fixed):
            if one != other:
                return None
            continue
        numbers = {own: k for k, own in enumerate(found)}
        theirs_too = {theirs: k for k, theirs in enumerate(found.values())}
        ordered = (_in_order(one, fixed, numbers), _in_order(other, fixed, theirs_too))
        for own, theirs in zip(*ordered, strict=False):
            if found.setdefault(own, theirs) != theirs or own.assumptions0 != theirs.assumptions0:
                return None
        if one.xreplace(found) != other:
            return None
    return {own: theirs for own, theirs in found.items() if own != theirs}


def _in_order(
    expression: sp.Basic, fixed: frozenset[sp.Symbol], known: Mapping[sp.Symbol, int]
) -> list[sp.Symbol]:
    """Return the parameters in an order that does not depend on their names, but on known ones."""
    if isinstance(expression, ParameterSymbol):
        return [] if expression in fixed else [expression]
    blanks = {s: _blank(s, known.get(s, -1) + 1) for s in _own(expression, fixed)}
    parts: Iterable[sp.Basic] = expression.args
    if expression.is_Add or expression.is_Mul:
        parts = sorted(parts, key=lambda part: default_sort_key(part.xreplace(blanks)))
    return [symbol for part in parts for symbol in _in_order(part, fixed, known)]
