"""Printing kernels for NumPy so that what they compute on the way lies in rows that are there.

A fresh array for each operation costs its allocation, and half of the time lies so that the
processor writes it at half its speed. A kernel of many operations is therefore given rows to write
into, `_r0` and so on, and each is used again as soon as nothing needs what is in it. Given none, it
is what the others are: arrays and numbers that broadcast.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from .printers import NUMPY, Body, Constants, bare
from .program import Operation, Program

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

SELECT = {
    "max": "{select}({0} < {1}, {1}, {0}, _r{row})",
    "min": "{select}({0} < {1}, {0}, {1}, _r{row})",
    "select": "{select}({0}, {1}, {2}, _r{row})",
}
"""Those of a function of the module: one of the operands, or in no row of theirs."""

MANY = 6
"""A kernel with fewer of them on the way to its results is printed without rows."""


def print_in_rows(program: Program, constants: Constants) -> Body | None:
    """Return a kernel printed with rows; None if it has not many operations to put there."""
    of_shot = _of_shot(program)
    into = INTO.keys() | SELECT.keys()
    own = {k for k in of_shot if program.operations[k].name in into}
    if len(own - set(program.outputs)) < MANY:
        return None
    return _Printer(program, own, of_shot, program.named(), constants).body()


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
class _Printer:
    """One kernel: the operations that go into rows, and those that have a line of their own."""

    program: Program
    own: set[int]
    of_shot: set[int]
    named: set[int]
    constants: Constants
    text: dict[int, str] = field(default_factory=dict)
    row: dict[int, int] = field(default_factory=dict)

    def body(self) -> Body:
        rows = self._assign()
        statements: list[str] = []
        for index in sorted(self.named):
            name = f"_s{len(statements)}"
            statements.append(f"{name} = {bare(self._value(index))}")
            self.text[index] = name
        outputs = [bare(self._value(output)) for output in self.program.outputs]
        return Body(statements, outputs, rows)

    def _value(self, index: int, user: int = -1) -> str:
        """Return an operation as it is written where another uses it, or the caller (-1)."""
        if index in self.text:
            return self.text[index]
        operation = self.program.operations[index]
        if operation.name in ("argument", "truth"):
            return operation.symbol
        if operation.name == "constant":
            return self.constants.of(self.program, operation.value, user in self.of_shot)
        operands = [self._value(operand, index) for operand in operation.operands]
        if index in self.own and operation.name in SELECT:
            select, row = "_select", self.row.get(index)
            if row is None:
                select, row = "_result", 0
            return SELECT[operation.name].format(*map(bare, operands), select=select, row=row)
        if index in self.row:
            return f"{INTO[operation.name]}({', '.join(map(bare, operands))}, _r{self.row[index]})"
        return NUMPY.operations[operation.name].format(*operands)

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
            apart = self.program.operations[index].name in SELECT
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
                if self.program.operations[index].name in SELECT:
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
