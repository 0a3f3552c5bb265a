"""Lowering a body of the event loop for one shot: numbers in place of rows.

A call of NumPy costs as much for one shot as for some tens. Where a body that repeats is needed by
a few shots, they go through it one by one, in operations of NumPy's numbers, with the same bits.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.event_tree import Node, Value

from ..statements import (
    Apply,
    Break,
    Call,
    Expression,
    For,
    ForEach,
    Function,
    If,
    Name,
    Operate,
    Return,
    Scalar,
    Statement,
    Tuple,
)
from .constants import Constants, number_type
from .formatter import ONE_SHOT_FORMATTER


@dataclass
class ScalarKernel:
    """The functions of a module that take one shot through a body.

    Attributes
    ----------
    constants
        The numbers of the module.
    functions
        What has been lowered.
    called
        The kernels that are called.
    """

    constants: Constants
    functions: list[Function] = field(default_factory=list)
    called: set[str] = field(default_factory=set)

    @property
    def lines(self) -> list[str]:
        """The lines of the functions, two blank ones before each."""
        return [
            line
            for function in self.functions
            for line in ("", "", *ONE_SHOT_FORMATTER.statement(function))
        ]

    def function(
        self, node: ir.If | ir.While, takes: Sequence[str], gives: Sequence[str], short: set[str]
    ) -> str:
        """Lower a body for a shot that needs it; return the name of the function.

        What is in single precision, a name of `short`, stays so.

        Parameters
        ----------
        node
            The guard or the repetition that owns the body.
        takes
            The variables that the body reads.
        gives
            The variables that it assigns and that are read afterwards.
        short
            The names of variables in single precision.
        """
        name = f"_alone{len(self.functions)}"
        given = [(_name(variable), "Any") for variable in takes]
        if isinstance(node, ir.While):
            given.append(("_turns", "Any"))
            body = [self._turns(node, Name("_turns"), short)]
        else:
            body = self._body(node.body, short)
        result = Return(Tuple(tuple(Name(_name(variable)) for variable in gives)))
        summary = f"Do the body of `{node.truth}` for one shot."
        self.functions.append(Function(name, tuple(given), (*body, result), summary))
        return name

    def _body(self, nodes: Sequence[Node], short: set[str]) -> list[Statement]:
        found: list[Statement] = []
        for node in nodes:
            if isinstance(node, ir.Call):
                found.append(self._call(node, short))
            elif isinstance(node, ir.ForEach):
                found.append(self._each(node, short))
            elif isinstance(node, ir.If):
                found.append(If(Name(_name(node.truth)), tuple(self._body(node.body, short))))
            else:
                found.append(self._turns(node, Scalar(node.limit), short))
        return found

    def _turns(self, node: ir.While, turns: Expression, short: set[str]) -> Statement:
        over = If(Operate("not", (Name(_name(node.truth)),)), (Break(),))
        return For("_", turns, (over, *self._body(node.body, short)))

    def _each(self, node: ir.ForEach, short: set[str]) -> Statement:
        rows = (Tuple(tuple(self._number(value) for value in row)) for row in node.rows)
        table = Tuple(tuple(rows))
        return ForEach(tuple(map(_name, node.names)), table, tuple(self._body(node.body, short)))

    def _call(self, node: ir.Call, short: set[str]) -> Statement:
        kernel = node.kernel
        self.called.add(kernel.name)
        given = tuple(self._given(value, short, kernel.single) for value in node.arguments)
        kinds = dict(zip(kernel.output_names, kernel.kinds, strict=True))
        short |= {v for o, v in node.assigned.items() if kinds[o] == "single"}
        results = (
            _name(node.assigned[o]) if o in node.assigned else "_" for o in kernel.output_names
        )
        return Call(f"_{kernel.name}_alone", given, tuple(results))

    def _given(self, value: Value, short: set[str], single: bool) -> Expression:
        if isinstance(value, str) and (value in short) != single:
            return Apply(number_type(single), (Name(_name(value)),))
        return self._number(value, single)

    def _number(self, value: Value, single: bool = False) -> Expression:
        if isinstance(value, str):
            return Name(_name(value))
        return self.constants.name(float(value), number_type(single))


def _name(variable: str) -> str:
    """Return a variable as a name in a function for one shot."""
    return f"_{variable}_"
