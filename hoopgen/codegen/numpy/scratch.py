"""Lowering kernels for NumPy so that what they compute on the way lies in rows that are there.

A fresh array for each operation costs its allocation, and half of the time lies so that the
processor writes it at half its speed. A kernel of many operations is therefore given rows to write
into, `_r0` and so on, and each is used again as soon as nothing needs what is in it. Given none, it
is what the others are: arrays and numbers that broadcast.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from ..program import Operation, Program
from ..statements import Apply, Declare, Expression, Name, Operate, Statement
from ..straight_line import Body
from .constants import Constants

INTO = {
    "add": "_add",
    "sub": "_subtract",
    "mul": "_multiply",
    "div": "_divide",
    "neg": "_negative",
    "sqrt": "_sqrt",
    "abs": "_absolute",
}
"""The operations that write into a row, as NumPy calls them."""

SELECTING = ("max", "min", "select")
"""Operations of the module's own functions; the result is an operand, or in no row of theirs."""


def in_rows(program: Program, constants: Constants, least: int) -> Body | None:
    """Return a kernel that writes into rows; None if it has fewer operations to put there.

    Parameters
    ----------
    program
        The operations of the kernel.
    constants
        The constants of the module; new ones join them.
    least
        The smallest number of operations for which rows pay.

    Returns
    -------
    Body or None
        Its statements, and the number of rows that they need.
    """
    of_shot = _of_shot(program)
    into = {*INTO, *SELECTING}
    own = {k for k in of_shot if program.operations[k].name in into}
    if len(own - set(program.outputs)) < least:
        return None
    return _Kernel(program, own, of_shot, program.named(), constants).body()


def _of_shot(program: Program) -> set[int]:
    """Return the operations that have a value for each shot."""
    of_shot: list[bool] = []
    for operation in program.operations:
        if operation.name in ("argument", "truth"):
            # A parameter is mostly one number for all shots.
            of_shot.append(not operation.symbol.startswith("p_"))
        else:
            of_shot.append(any(of_shot[operand] for operand in operation.operands))
    return {k for k, each in enumerate(of_shot) if each}


@dataclass
class _Kernel:
    """One kernel: the operations that go into rows, and those that have a line of their own."""

    program: Program
    own: set[int]
    of_shot: set[int]
    named: set[int]
    constants: Constants
    values: dict[int, Expression] = field(default_factory=dict)
    row: dict[int, int] = field(default_factory=dict)

    def body(self) -> Body:
        rows = self._assign()
        statements: list[Statement] = []
        for index in sorted(self.named):
            name = f"_s{len(statements)}"
            statements.append(Declare(name, "", self._value(index), constant=True))
            self.values[index] = Name(name)
        outputs = tuple(self._value(output) for output in self.program.outputs)
        return Body(tuple(statements), outputs, rows)

    def _value(self, index: int, user: int = -1) -> Expression:
        """Return an operation as it is written where another uses it, or the caller (-1)."""
        if index in self.values:
            return self.values[index]
        operation = self.program.operations[index]
        if operation.name in ("argument", "truth"):
            return Name(operation.symbol)
        if operation.name == "constant":
            return self.constants.number(self.program, operation.value, user in self.of_shot)
        operands = tuple(self._value(operand, index) for operand in operation.operands)
        if index in self.own and operation.name in SELECTING:
            function = "_select" if index in self.row else "_result"
            row = Name(f"_r{self.row.get(index, 0)}")
            return Apply(function, (*_selected(operation.name, operands), row))
        if index in self.row:
            return Apply(INTO[operation.name], (*operands, Name(f"_r{self.row[index]}")))
        return Operate(operation.name, operands, self.program.single)

    def _assign(self) -> int:
        """Give each operation a row that nothing else needs by then; return how many there are."""
        order = self._order()
        done: dict[int, list[int]] = {}
        for index, place in self._last(order).items():
            done.setdefault(place, []).append(index)
        free: list[int] = []
        rows = 0
        for place, index in enumerate(order):
            over = [self.row[k] for k in sorted(done.get(place, ())) if k in self.row]
            apart = self.program.operations[index].name in SELECTING
            # The one that was written last is the nearest in the caches.
            if not apart:
                free.extend(over)
            if index in self.own and index not in self.program.outputs:
                if not free:
                    free.append(rows)
                    rows += 1
                self.row[index] = free.pop()
            if apart:
                free.extend(over)
        return rows

    def _last(self, order: list[int]) -> dict[int, int]:
        """Return the place in the order at which each operation is needed for the last time."""
        last: dict[int, int] = {}
        for place in reversed(range(len(order))):
            index = order[place]
            for k in self._read(index):
                last.setdefault(k, place)
                if self.program.operations[index].name in SELECTING:
                    last[k] = max(last[k], last.get(index, place))
        return last

    def _order(self) -> list[int]:
        """Return the operations in the order in which the printed lines do them."""
        order: dict[int, None] = {}

        def visit(index: int) -> None:
            for operand in self._read(index):
                if operand not in self.named:
                    visit(operand)
            order[index] = None

        for index in (*sorted(self.named), *self.program.outputs):
            visit(index)
        return list(order)

    def _read(self, index: int) -> tuple[int, ...]:
        operation: Operation = self.program.operations[index]
        return operation.operands


def _selected(name: str, operands: tuple[Expression, ...]) -> tuple[Expression, ...]:
    """Return a truth, what is chosen where it holds, and what elsewhere."""
    if name == "select":
        return operands
    one, other = operands
    truth = Operate("less", operands)
    return (truth, other, one) if name == "max" else (truth, one, other)
