"""Statements as a tree: what lowering makes of kernels and of the event loop, and formatters print.

An expression has no effect. A statement declares, assigns or calls, or has bodies of statements.
`visitors` say what a tree reads and writes. `Call`, `If` and `While` are statements of the target;
the nodes of these names in `hoopgen.derive.ir.event_tree` are of the mathematics, and say
what happens to one shot: code that has both writes `ir.Call` for a node.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

# Expressions


@dataclass(frozen=True)
class Name:
    """The value of a variable."""

    name: str


@dataclass(frozen=True)
class Number:
    """A number of double or single precision."""

    value: float
    single: bool = False


@dataclass(frozen=True)
class Scalar:
    """A number that is no value of a shot, such as an index or an entry of a table."""

    value: float


@dataclass(frozen=True)
class Column:
    """An array with one value for each shot of a list."""

    name: str


@dataclass(frozen=True)
class Operate:
    """One of the operations of a program, which each target spells in its own way."""

    operation: str
    operands: tuple[Expression, ...] = ()
    single: bool = False


@dataclass(frozen=True)
class Apply:
    """A function's value for some arguments."""

    function: str
    arguments: tuple[Expression, ...] = ()


@dataclass(frozen=True)
class Infix:
    """An operator between two operands, on whole numbers, addresses and truths of one shot."""

    operator: str
    left: Expression
    right: Expression


@dataclass(frozen=True)
class Choose:
    """One of two values, by a test."""

    test: Expression
    then: Expression
    other: Expression


@dataclass(frozen=True)
class Member:
    """A part of a structure, by its name."""

    whole: Expression
    name: str


@dataclass(frozen=True)
class Item:
    """An element of an array, by its index."""

    array: Expression
    index: Expression


@dataclass(frozen=True)
class Cast:
    """A value as one of another type."""

    type: str
    value: Expression


@dataclass(frozen=True)
class Tuple:
    """Several values: a tuple, or a row of a table."""

    values: tuple[Expression, ...]


Expression: TypeAlias = (
    Name
    | Number
    | Scalar
    | Column
    | Operate
    | Apply
    | Infix
    | Choose
    | Member
    | Item
    | Cast
    | Tuple
)

# Statements


@dataclass(frozen=True)
class Declare:
    """A new variable, with a value or without one yet.

    Attributes
    ----------
    type
        What the target calls the type; "" where it has none.
    room
        How many elements it has along each dimension, if it is an array; None: as many as given.
    """

    name: str
    type: str = ""
    value: Expression | None = None
    constant: bool = False
    room: tuple[Expression | None, ...] = ()


@dataclass(frozen=True)
class Table:
    """A new constant array of rows."""

    name: str
    type: str
    rows: tuple[tuple[Expression, ...], ...]


@dataclass(frozen=True)
class Assign:
    """A new value for a variable or an element, or one added to it."""

    target: Expression
    value: Expression
    operator: str = "="


@dataclass(frozen=True)
class Call:
    """The evaluation of a kernel: its outputs are new variables, or members of one."""

    function: str
    arguments: tuple[Expression, ...]
    results: tuple[str, ...]


@dataclass(frozen=True)
class Execute:
    """An expression that is evaluated for its effect."""

    expression: Expression


@dataclass(frozen=True)
class Block:
    """Statements whose declarations end with them; `flush` where they are not indented."""

    body: tuple[Statement, ...]
    flush: bool = False


@dataclass(frozen=True)
class If:
    """A body that is done where a test holds, and one that is done elsewhere."""

    test: Expression
    body: tuple[Statement, ...]
    otherwise: tuple[Statement, ...] = ()


@dataclass(frozen=True)
class While:
    """A body that is repeated as long as a test holds; without a test, until it breaks."""

    test: Expression | None
    body: tuple[Statement, ...]


@dataclass(frozen=True)
class For:
    """A body for each whole number below an end; `otherwise` is done if no turn breaks."""

    index: str
    end: Expression
    body: tuple[Statement, ...]
    otherwise: tuple[Statement, ...] = ()
    first: Expression = Scalar(0)


@dataclass(frozen=True)
class ForEach:
    """A body for each row of a table, whose values have names in it."""

    names: tuple[str, ...]
    table: Expression
    body: tuple[Statement, ...]


@dataclass(frozen=True)
class ForLanes:
    """A body for each row of lanes of a list, the first of which is at an index."""

    index: str
    first: Expression
    count: Expression
    body: tuple[Statement, ...]


@dataclass(frozen=True)
class Compact:
    """Statements that append some lanes of values to a list, which gets longer by their number.

    Attributes
    ----------
    count
        The length of the list.
    mask
        The lanes; where there is none, nothing is done.
    """

    count: str
    mask: Name
    body: tuple[Statement, ...]


@dataclass(frozen=True)
class Break:
    """The end of a loop."""


@dataclass(frozen=True)
class Continue:
    """The end of a turn of a loop."""


@dataclass(frozen=True)
class Return:
    """The end of a function, and its value."""

    value: Expression


@dataclass(frozen=True)
class Function:
    """A function: its parameters with their types, by name."""

    name: str
    parameters: tuple[tuple[str, str], ...]
    body: tuple[Statement, ...]
    summary: str = ""


Statement: TypeAlias = (
    Declare
    | Table
    | Assign
    | Call
    | Execute
    | Block
    | If
    | While
    | For
    | ForEach
    | ForLanes
    | Compact
    | Break
    | Continue
    | Return
    | Function
)
