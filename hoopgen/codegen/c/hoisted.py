"""Arguments of C kernels that depend on parameters alone: rows of the worklist.

Where all shots share their parameters it is computed as a job begins; where each has its own,
before a pass goes over a row of lanes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.event_tree import Node, walk

from ..hoisting import PartialEvaluation, needed_by
from ..identifiers import identifier
from ..program import Operations
from ..statements import Apply, Block, Declare, Execute, Expression, Name, Scalar, Statement
from ..straight_line import straight_line
from .spelling import LANES, SINGLES

Rows = tuple[set[int], set[int]]
"""Indices of rows in double, and of rows in single precision."""


@dataclass
class _Results:
    """The loop invariant results of one precision: each output has a row of lanes."""

    operations: Operations
    column: str

    def place(self, index: int) -> int:
        """Return the row of an operation."""
        outputs = self.operations.outputs
        if index not in outputs:
            outputs.append(index)
        return outputs.index(index)

    def load(self, place: int) -> Expression:
        """Return a row of lanes."""
        return Apply(self.column.upper(), (Scalar(place),))

    def store(self, place: int, value: Expression) -> Statement:
        """Store a row of lanes."""
        name = self.column.upper().replace("FIXED", "FIX")
        return Execute(Apply(name, (Scalar(place), value)))


@dataclass
class Hoisted:
    """The loop invariant results of a loop's kernels.

    Attributes
    ----------
    evaluations
        By name, the kernels that have any.
    """

    evaluations: Mapping[str, PartialEvaluation] = field(default_factory=dict)
    _results: dict[bool, _Results] = field(
        default_factory=lambda: {
            False: _Results(Operations(), "fixed"),
            True: _Results(Operations(single=True), "fixed_single"),
        }
    )
    _known: dict[tuple[str, tuple[str | float, ...]], list[int]] = field(default_factory=dict)

    def given(self, node: ir.Call, given: Sequence[Expression]) -> list[Expression]:
        """Return the arguments of the rest of a kernel, given those of the whole kernel.

        Parameters
        ----------
        node
            The call of the kernel.
        given
            The expressions of all of the kernel's arguments, in calling order.

        Returns
        -------
        list of Expression
            Those that the rest still needs, then the loop invariant results.
        """
        own = self.evaluations.get(node.kernel.name)
        if own is None:
            return list(given)
        results = self._results[own.whole.single]
        rows = (results.load(results.place(k)) for k in self._indices(node, own))
        return [*(given[k] for k in own.kept_arguments), *rows]

    def _indices(self, node: ir.Call, own: PartialEvaluation) -> list[int]:
        """Return, of all loop invariant operations, those that a kernel is given.

        The passes ask again and again for the same call, as each goes over the nodes within it.
        """
        call = node.kernel.name, node.arguments
        if call not in self._known:
            self._known[call] = self._found(node, own)
        return self._known[call]

    def _found(self, node: ir.Call, own: PartialEvaluation) -> list[int]:
        arguments = map(identifier, node.kernel.arguments)
        names = dict(zip(arguments, node.arguments, strict=True))
        operations = self._results[own.whole.single].operations
        placed: dict[int, int] = {}
        for k in needed_by(own.whole, own.loop_invariant):
            operation = own.whole.operations[k]
            operands = tuple(placed[o] for o in operation.operands)
            symbol = str(names.get(operation.symbol, ""))
            placed[k] = operations.add(replace(operation, operands=operands, symbol=symbol))
        return [placed[k] for k in own.loop_invariant]

    def rows_of(self, nodes: Iterable[Node]) -> Rows:
        """Return the rows that the kernels of nodes take."""
        found: Rows = (set(), set())
        for node in walk(nodes):
            own = self.evaluations.get(node.kernel.name) if isinstance(node, ir.Call) else None
            if isinstance(node, ir.Call) and own is not None:
                results = self._results[own.whole.single]
                found[own.whole.single].update(map(results.place, self._indices(node, own)))
        return found

    @property
    def counts(self) -> dict[str, int]:
        """Numbers of rows of each precision, by the name of the array."""
        return {r.column: len(r.operations.outputs) for r in self._results.values()}

    @property
    def all(self) -> Rows:
        """All rows."""
        double, single = (set(range(len(r.operations.outputs))) for r in self._results.values())
        return double, single

    def reads(self, rows: Rows) -> list[str]:
        """Return the parameters that rows are computed of."""
        found: set[str] = set()
        for results, wanted in zip(self._results.values(), rows, strict=True):
            operations = results.operations
            needed = needed_by(operations, [operations.outputs[row] for row in wanted])
            found |= {operations.operations[k].symbol for k in needed}
        return sorted(found - {""})

    def statements(self, rows: Rows) -> list[Statement]:
        """Return the statements that compute rows of the parameters."""
        return [
            Block(tuple(_computed(results, sorted(wanted))))
            for results, wanted in zip(self._results.values(), rows, strict=True)
            if wanted
        ]


def _computed(results: _Results, rows: Sequence[int]) -> Iterator[Statement]:
    whole = results.operations
    wanted = [whole.outputs[row] for row in rows]
    part, placed = Operations(single=whole.single), dict[int, int]()
    for k in needed_by(whole, wanted):
        operation = whole.operations[k]
        if whole.single and operation.symbol:
            narrow = f"_{operation.symbol}"
            value = Apply("lanes_narrow", (Name(operation.symbol),))
            yield Declare(narrow, "S", value, constant=True)
            operation = replace(operation, symbol=narrow)
        operands = tuple(placed[o] for o in operation.operands)
        placed[k] = part.add(replace(operation, operands=operands))
    part.outputs = [placed[k] for k in wanted]
    # By the numbers in the whole: so the variants of the loop have the same names.
    numbers = {own: k for k, own in placed.items()}
    spelling = SINGLES if whole.single else LANES
    body = straight_line(part, spelling, numbers=[numbers[k] for k in range(len(numbers))])
    yield from body.statements
    for row, output in zip(rows, body.outputs, strict=True):
        yield results.store(row, output)
