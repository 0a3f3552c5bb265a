"""Visitors of statements: what a tree reads, writes and declares, and what it needs from before."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from .statements import (
    Apply,
    Assign,
    Block,
    Call,
    Cast,
    Choose,
    Compact,
    Declare,
    Execute,
    Expression,
    For,
    ForEach,
    ForLanes,
    Function,
    If,
    Infix,
    Item,
    Member,
    Name,
    Operate,
    Return,
    Statement,
    Table,
    Tuple,
    While,
)


def operands(expression: Expression) -> tuple[Expression, ...]:
    """Return the parts of an expression that are expressions."""
    match expression:
        case Operate(_, parts) | Apply(_, parts) | Tuple(parts):
            return parts
        case Infix(_, left, right) | Item(left, right):
            return (left, right)
        case Choose(test, then, other):
            return (test, then, other)
        case Member(whole):
            return (whole,)
        case Cast(_, value):
            return (value,)
    return ()


def names_in(*expressions: Expression) -> set[str]:
    """Return the variables whose values expressions read."""
    found: set[str] = set()
    rest = list(expressions)
    while rest:
        part = rest.pop()
        if isinstance(part, Name):
            found.add(part.name)
        rest += operands(part)
    return found


def bodies(statement: Statement) -> tuple[tuple[Statement, ...], ...]:
    """Return the bodies of a statement, in order."""
    match statement:
        case If(_, body, otherwise) | For(_, _, body, otherwise):
            return (body, otherwise)
        case (
            Block(body)
            | While(_, body)
            | ForEach(_, _, body)
            | ForLanes(_, _, _, body)
            | Compact(_, _, body)
            | Function(_, _, body)
        ):
            return (body,)
    return ()


def walk(statements: Iterable[Statement]) -> Iterator[Statement]:
    """Yield every statement, one before those of its bodies."""
    for statement in statements:
        yield statement
        for body in bodies(statement):
            yield from walk(body)


def own_reads(statement: Statement) -> set[str]:
    """Return the variables that a statement reads itself, not in its bodies."""
    match statement:
        case Declare(_, _, value) if value is not None:
            return names_in(value)
        case Table(_, _, rows):
            return names_in(*(value for row in rows for value in row))
        case Assign(target, value, operator):
            place = operands(target) if operator == "=" else (target,)
            return names_in(value, *place)
        case Call(_, arguments):
            return names_in(*arguments)
        case Execute(value) | Return(value) | ForEach(_, value):
            return names_in(value)
        case For(_, end):
            return names_in(end, statement.first)
        case If(value):
            return names_in(value)
        case While(test) if test is not None:
            return names_in(test)
        case ForLanes(_, first, count):
            return names_in(first, count)
        case Compact(count, mask):
            return {count, mask.name}
    return set()


def own_declarations(statement: Statement) -> set[str]:
    """Return the names that a statement declares: for what follows, or in its bodies alone."""
    match statement:
        case Declare(name) | Table(name) | For(name) | ForLanes(name):
            return {name}
        case Call(_, _, results):
            return set(results)
        case ForEach(names):
            return set(names)
        case Function(_, parameters):
            return {name for name, _ in parameters}
    return set()


def own_writes(statement: Statement) -> set[str]:
    """Return the variables to which a statement itself gives values."""
    match statement:
        case Assign(target):
            while isinstance(target, Item | Member):
                target = target.array if isinstance(target, Item) else target.whole
            return names_in(target)
        case Compact(count):
            return {count}
    return own_declarations(statement)


def reads(statements: Iterable[Statement]) -> set[str]:
    """Return the variables that statements read."""
    return set().union(*map(own_reads, walk(statements)))


def writes(statements: Iterable[Statement]) -> set[str]:
    """Return the variables to which statements give values."""
    return set().union(*map(own_writes, walk(statements)))


def live_before(statements: Sequence[Statement], after: Iterable[str] = ()) -> set[str]:
    """Return the variables whose values are needed before statements, given those needed after.

    Parameters
    ----------
    statements
        The statements, in order.
    after
        The variables that are read afterwards.
    """
    live = set(after)
    for statement in reversed(statements):
        if not bodies(statement):
            if not isinstance(statement, Assign) or isinstance(statement.target, Name):
                live -= own_writes(statement)
        elif isinstance(statement, Block):
            live = live_before(statement.body, live)
        elif isinstance(statement, If):
            live = set().union(*(live_before(body, live) for body in bodies(statement)))
        else:
            live |= _live_in_turns(statement, live)
        live |= own_reads(statement)
    return live


def _live_in_turns(statement: Statement, after: set[str]) -> set[str]:
    """Return the variables that are live at the begin of a loop or function, for any turns."""
    own, test = own_declarations(statement), own_reads(statement)
    live: set[str] = set()
    while True:
        more = set().union(*(live_before(body, after | live | test) for body in bodies(statement)))
        if more - own <= live:
            return live
        live |= more - own
