"""Lowering the event loop for one shot: a thread takes it from its release to its end."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.event_tree import Node

from ..statements import (
    Assign,
    Break,
    Call,
    Declare,
    Expression,
    For,
    If,
    Item,
    Member,
    Name,
    Number,
    Operate,
    Scalar,
    Statement,
    Table,
)
from .spelling import parameter_of_shot


def function(kernel: str) -> str:
    """Return the name of a kernel's function; no function of CUDA is called so."""
    return f"kernel_{kernel}"


@dataclass
class ShotLoop:
    """The lowering of nodes for one shot.

    Attributes
    ----------
    parameters
        The variables of the scene's parameters, in order.
    takes_all
        The kernels that are given all parameters, by their numbers.
    tables
        The tables over whose rows bodies are repeated, in the order of their numbers.
    used
        The parameters that are read by name.
    """

    parameters: Sequence[str]
    takes_all: Collection[str]
    tables: list[Table] = field(default_factory=list)
    used: set[str] = field(default_factory=set)
    results: int = 0

    def body(self, nodes: Iterable[Node]) -> list[Statement]:
        """Return the statements of nodes."""
        found: list[Statement] = []
        for node in nodes:
            if isinstance(node, ir.Call):
                found += self._call(node)
            elif isinstance(node, ir.If):
                found.append(If(Name(node.truth), tuple(self.body(node.body))))
            elif isinstance(node, ir.While):
                over = If(Operate("not", (Name(node.truth),)), (Break(),))
                found.append(For("_turn", Scalar(node.limit), (over, *self.body(node.body))))
            else:
                found.append(self._each(node))
        return found

    def _call(self, node: ir.Call) -> list[Statement]:
        kernel, result = node.kernel.name, f"_o{self.results}"
        self.results += 1
        given: list[Expression] = [Name("_given")] if kernel in self.takes_all else []
        for value in node.arguments:
            if not isinstance(value, str):
                given.append(Number(float(value)))
            elif value not in self.parameters or kernel not in self.takes_all:
                given.append(Name(value))
        self.used |= {v.name for v in given if isinstance(v, Name)} & set(self.parameters)
        call = Call(function(kernel), tuple(given), (result,))
        values = ((v, Member(Name(result), o)) for o, v in node.assigned.items())
        return [call, *(Assign(Name(variable), value) for variable, value in values)]

    def _each(self, node: ir.ForEach) -> Statement:
        """Return a loop over the rows of a table of numbers, and of the numbers of parameters.

        Groups of rows that a shot does not come near are not skipped: their rows change nothing.
        """
        columns = dict(zip(node.names, node.columns, strict=True))
        row: list[Statement] = []
        for kind, wanted in (("int", str), ("double", float)):
            own = {name: c for name, c in columns.items() if isinstance(c[0], wanted)}
            if not own:
                continue
            table = Name(self._table(kind, tuple(own.values())))
            for column, name in enumerate(own):
                value: Expression = Item(Item(table, Name("_row")), Scalar(column))
                value = parameter_of_shot(value) if wanted is str else value
                row.append(Declare(name, "double", value, constant=True))
        return For("_row", Scalar(len(node.rows)), (*row, *self.body(node.body)))

    def _table(self, kind: str, columns: Sequence[Sequence[str | float]]) -> str:
        """Return the name of the table of some columns."""
        rows = tuple(tuple(map(self._entry, row)) for row in zip(*columns, strict=True))
        for table in self.tables:
            if (table.type, table.rows) == (kind, rows):
                return table.name
        self.tables.append(Table(f"table_{len(self.tables)}", kind, rows))
        return self.tables[-1].name

    def _entry(self, value: str | float) -> Expression:
        """Return an entry of a table: a number, or that of a parameter."""
        return Scalar(self.parameters.index(value)) if isinstance(value, str) else Number(value)
