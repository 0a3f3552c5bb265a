"""Statements that differ by their variables alone, which a macro of lanes.h makes of their names.

`MACROS` has the statement that each stands for, of a variable and of what the macro is given once:
the prefix of a list, a kernel's results, or two of those.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from typing import Any

from hoopgen.derive.ir.kernel import Kind

from ..statements import (
    Apply,
    Assign,
    Column,
    Declare,
    Execute,
    Expression,
    Infix,
    Item,
    Member,
    Name,
    Operate,
    Statement,
)
from .spelling import TYPES, at, choose, expand, load, nothing, pack, store, zeros

_PACKED, _IDLE = Name("packed"), Name("idle")


def _of_kind(kind: Kind) -> dict[str, Callable[[Any, str], Statement]]:
    """Return the macros of variables of a kind, by name."""
    new = TYPES[kind]
    return {
        "START": lambda of, x: Declare(x, new, nothing(kind)),
        "LOAD": lambda of, x: Declare(x, new, load(kind, at(of + x, "i"))),
        "STORE": lambda of, x: store(kind, at(of + x, "i"), Name(x)),
        "PACK": lambda of, x: pack(kind, at(of + x, f"{of}shots"), _PACKED, Name(x)),
        "CLEAR": lambda of, x: zeros(kind, at(of + x, f"{of}shots")),
        "EXPAND": lambda of, x: Assign(Name(x), expand(kind, at(of + x, "taken"), _IDLE, Name(x))),
        "GET": lambda of, x: Declare(x, new, Member(Name(of), x)),
        "SELECT": lambda of, x: Assign(
            Name(x), choose(kind, Name(of[0]), Member(Name(of[1]), x), Name(x))
        ),
    }


def _taken(of: str, x: str) -> Statement:
    place, old = at(f"{of}parameters.{x}", "taken"), load("double", Column(f"turning_{x}"))
    return Declare(x, "V", expand("double", place, _IDLE, old), constant=True)


MACROS: dict[str, Callable[[Any, str], Statement]] = {
    **_of_kind("double"),
    **{f"{name}_MASK": make for name, make in _of_kind("truth").items() if name != "CLEAR"},
    **{f"{name}_SINGLE": make for name, make in _of_kind("single").items()},
    "SET": lambda of, x: Assign(Name(x), Member(Name(of), x)),
    "RETURN": lambda of, x: Assign(
        Item(Column(of[0] + x), Name("row")), Item(Column(of[1] + x), Name("k"))
    ),
    "PARAMETER": lambda of, x: Declare(
        x, "V", load("double", at(f"{of}parameters.{x}", "i")), constant=True
    ),
    "PARAMETER_TAKEN": _taken,
    "TURNING": lambda of, x: store("double", Column(of + x), Name(x)),
}
"""By name, what a macro stands for; those with a suffix are for truths, or in single precision."""


PAIRS = frozenset(("SELECT", "SELECT_MASK", "SELECT_SINGLE", "RETURN"))
"""The macros that are given two names once."""


def _shape(statement: Statement, pair: bool) -> tuple[object, ...]:
    """Return the form of a statement without its names, which all statements of a macro share."""
    match statement:
        case Declare(type=kind, value=value):
            return pair, Declare, kind, _head(value)
        case Assign(target, value):
            return pair, Assign, type(target), _head(value)
        case Execute(value):
            return pair, Execute, _head(value)
    return pair, type(statement)


def _head(value: Expression | None) -> object:
    match value:
        case Apply(function):
            return function
        case Operate(operation):
            return operation
    return type(value)


def _by_shape() -> dict[tuple[object, ...], list[str]]:
    """Return the names of the macros whose statements have a shape, by the shape."""
    names = defaultdict[tuple[object, ...], list[str]](list)
    for macro, make in MACROS.items():
        pair = macro in PAIRS
        names[_shape(make(("of", "of") if pair else "of", "x"), pair)].append(macro)
    return dict(names)


_MACROS_BY_SHAPE = _by_shape()


def alike(statement: Statement) -> tuple[str, str, str] | None:
    """Return the macro, what it is given once and the variable, if one stands for a statement."""
    of, name = _parts(statement)
    if name:
        for macro in _MACROS_BY_SHAPE.get(_shape(statement, isinstance(of, tuple)), ()):
            if MACROS[macro](of, name) == statement:
                return macro, of if isinstance(of, str) else f"({', '.join(of)})", name
    return None


def _parts(statement: Statement) -> tuple[str | tuple[str, str], str]:
    """Return the possible macro arguments of a statement, and its variable; "" without one."""
    match statement:
        case Declare(name, _, Member(Name(result))) | Assign(Name(name), Member(Name(result))):
            return result, name
        case Assign(
            Name(name),
            Operate(
                "select", (Name(mask) | Apply("singles_of", (Name(mask),)), Member(Name(result)), _)
            )
            | Apply("lanes_choose", (Name(mask), Member(Name(result)), _)),
        ):
            return (mask, result), name
        case Declare(name, _, value) | Assign(Name(name), value) if value is not None:
            own = _column(value).removesuffix(name)
            return own.removesuffix("parameters."), name
        case Assign(Item(Column(column), Name("row")), Item(Column(source))):
            shared = next(column[k:] for k in range(len(column) + 1) if source.endswith(column[k:]))
            name = shared.removeprefix("_")
            return (column.removesuffix(name), source.removesuffix(name)), name
        case Execute(Apply(_, (Infix("+", Column(column), Name("i")), value))):
            name = _variable(value)
            return column.removesuffix(name), name
        case Execute(Apply(_, (Infix("+", Column(column), Name(count)), *_))):
            own = count.removesuffix("shots")
            return own, column.removeprefix(own)
        case Execute(Apply(_, (Column(array), value))):
            name = _variable(value)
            return array.removesuffix(name), name
    return "", ""


def _column(value: Expression) -> str:
    """Return the column that a value is loaded from, "" if it is none."""
    match value:
        case Operate("less", (_, inner)):
            return _column(inner)
        case Apply(_, (Infix("+", Column(column)), *_)):
            return column
    return ""


def _variable(value: Expression) -> str:
    """Return the variable that is stored, "" if it is none."""
    match value:
        case Name(name) | Operate("select", (Name(name), *_)):
            return name
    return ""
