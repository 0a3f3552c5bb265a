"""Lowering the event loop for one shot: a thread takes it from its release to its end.

The path alone and that with bounds on errors are one function. Its switch `BOUNDS` is known when it
is compiled.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.event_tree import Node, given_as

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


def _guarded(statements: Sequence[Statement]) -> list[Statement]:
    """Return statements that run only if errors are bounded."""
    return [If(Name("BOUNDS"), tuple(statements))] if statements else []


def _head(node: ir.If | ir.While | ir.ForEach) -> tuple[object, ...]:
    """Return the condition and the limit that decide how often a body runs."""
    if isinstance(node, ir.ForEach):
        return (ir.ForEach, len(node.rows))
    return (type(node), node.truth, node.limit if isinstance(node, ir.While) else None)


@dataclass
class ShotLoop:
    """The lowering of nodes for one shot, with bounds on errors where `BOUNDS` is true.

    Attributes
    ----------
    parameters
        The variables of the scene's parameters, in order.
    takes_all
        The kernels that are given all parameters, by their numbers.
    plain_values
        The variables that the loop without bounds never assigns, with their values there.
    tables
        The tables over whose rows bodies are repeated, in the order of their numbers.
    used
        The parameters that are read by name.
    """

    parameters: Sequence[str]
    takes_all: Collection[str]
    plain_values: Mapping[str, float]
    tables: list[Table] = field(default_factory=list)
    used: set[str] = field(default_factory=set)
    results: int = 0

    def body(self, nodes: Iterable[Node], plain: Sequence[Node] | None = None) -> list[Statement]:
        """Return the statements of nodes.

        Parameters
        ----------
        nodes
            The nodes with bounds on errors.
        plain
            Those of them that the path alone needs; the others, and what only they read, are done
            where `BOUNDS` is true. None: all nodes stand where it is.
        """
        found: list[Statement] = []
        bounds: list[Statement] = []
        waiting = None if plain is None else list(plain)
        for node in nodes:
            if waiting is None:
                found += self._node(node, node)
            elif waiting and self._covers(node, waiting[0]):
                found += [*_guarded(bounds), *self._node(node, waiting.pop(0), shared=True)]
                bounds = []
            else:
                bounds += self._node(node, node)
        if waiting:
            raise ValueError(f"the loop without bounds has a node of its own: {waiting[0]}")
        return [*found, *_guarded(bounds)]

    def _covers(self, node: Node, plain: Node) -> bool:
        """Return whether a node of the loop without bounds is one with bounds, or a part of it."""
        if isinstance(node, ir.Call):
            return (
                isinstance(plain, ir.Call)
                and node.kernel.name == plain.kernel.name
                and given_as(node, self.plain_values).arguments == plain.arguments
                and plain.assigned.items() <= node.assigned.items()
            )
        if isinstance(plain, ir.Call) or _head(node) != _head(plain):
            return False
        own = iter(node.body)
        return all(any(self._covers(one, wanted) for one in own) for wanted in plain.body)

    def _node(self, node: Node, plain: Node, shared: bool = False) -> list[Statement]:
        """Return the statements of a node; if shared, the loop without bounds has part of it."""
        if isinstance(node, ir.Call):
            return self._call(node, plain.assigned if isinstance(plain, ir.Call) else {})
        assert not isinstance(plain, ir.Call)
        body = self.body(node.body, plain.body if shared else None)
        if isinstance(node, ir.If):
            return [If(Name(node.truth), tuple(body))]
        if isinstance(node, ir.While):
            over = If(Operate("not", (Name(node.truth),)), (Break(),))
            return [For("_turn", Scalar(node.limit), (over, *body))]
        return [self._each(node, body)]

    def _call(self, node: ir.Call, shared: Mapping[str, str]) -> list[Statement]:
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
        values = {o: Assign(Name(v), Member(Name(result), o)) for o, v in node.assigned.items()}
        bounds = [value for output, value in values.items() if output not in shared]
        return [call, *(values[output] for output in values if output in shared), *_guarded(bounds)]

    def _each(self, node: ir.ForEach, body: Sequence[Statement]) -> Statement:
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
        return For("_row", Scalar(len(node.rows)), (*row, *body))

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
