"""Rerolling: a long sum or conjunction over many parameters is a loop over a table of them.

Kernels of the parameters alone do the same for each parameter or body, one after another. In
straight lines their length grows with the number of bodies, and compilers take time that grows
faster. The loop does the same operations in the same order, and gives the same bits.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ir.event_tree import Call, walk
from hoopgen.derive.loop.loop import Loop

from .formatter import Spelling
from .program import Operation, Program
from .statements import (
    Assign,
    Declare,
    Expression,
    For,
    Item,
    Name,
    Number,
    Operate,
    Scalar,
    Statement,
    Table,
)
from .straight_line import Body

MAX_PERIOD = 12
"""Most steps of a turn of a loop."""

MAX_STEP_SIZE = 16
"""Most operations of a step."""

MIN_STEPS = 4
"""Fewest steps that a loop must save."""

Shape = tuple[object, ...]
"""A step without the parameters that it reads."""


@dataclass(frozen=True)
class _Step:
    """One step of a chain: an operation on the value so far, and on something of parameters.

    Attributes
    ----------
    index, before
        The operation, and the one whose value it takes.
    shape
        What it does.
    parameters
        The parameters that it reads, in the order in which the shape has them.
    """

    index: int
    before: int
    shape: Shape
    parameters: tuple[str, ...]


@dataclass(frozen=True)
class _Loop:
    """Steps that repeat, a turn after another."""

    turns: tuple[tuple[_Step, ...], ...]


@dataclass
class _Rerolled:
    """A program in which chains of like steps are loops.

    Attributes
    ----------
    program
        The program.
    numbers
        By name, the numbers of the parameters.
    spelling
        The types of the target.
    parameter
        What reads a parameter, by its number.
    """

    program: Program
    numbers: Mapping[str, int]
    spelling: Spelling
    parameter: Callable[[Expression], Expression]
    statements: list[Statement] = field(default_factory=list)
    values: dict[int, Expression] = field(default_factory=dict)

    def body(self) -> Body:
        """Return the statements and outputs."""
        program = self.program
        loops = {loop.turns[-1][-1].index: loop for loop in self._loops()}
        needed = set(program.outputs)
        for index in reversed(range(len(program.operations))):
            if index in needed:
                own = loops.get(index)
                operands = program.operations[index].operands
                needed.update([own.turns[0][0].before] if own else operands)
        named = program.named()
        for index in sorted(needed):
            if index in loops:
                self.values[index] = self._loop(loops[index])
                continue
            value = self._value(index, self.values)
            if index in named:
                name = f"_s{len(self.statements)}"
                kind = self._type(index)
                self.statements.append(Declare(name, kind, value, constant=True))
                value = Name(name)
            self.values[index] = value
        outputs = tuple(self.values[output] for output in program.outputs)
        return Body(tuple(self.statements), outputs)

    def _type(self, index: int) -> str:
        """Return the target's type of an operation's value."""
        is_truth = self.program.operations[index].is_truth
        return self.spelling.truth if is_truth else self.spelling.number

    def _value(self, index: int, values: Mapping[int, Expression]) -> Expression:
        """Return the value of an operation, given those of its operands."""
        operation = self.program.operations[index]
        if operation.name == "constant":
            return Number(operation.value)
        if operation.name in ("argument", "truth"):
            if operation.symbol not in self.numbers:
                return Name(operation.symbol)
            return self.parameter(Scalar(self.numbers[operation.symbol]))
        return Operate(operation.name, tuple(values[k] for k in operation.operands))

    def _loop(self, loop: _Loop) -> Expression:
        """Append a loop, and return its value."""
        many = len(self.statements)
        value, table, turn = Name(f"_v{many}"), f"_t{many}", f"_k{many}"
        first = loop.turns[0]
        start = Declare(value.name, self._type(first[0].index), self.values[first[0].before])
        rows = tuple(
            tuple(Scalar(self.numbers[name]) for step in own for name in step.parameters)
            for own in loop.turns
        )
        steps: list[Statement] = []
        column = 0
        for step in first:
            places = {}
            for name in step.parameters:
                row = Item(Item(Name(table), Name(turn)), Scalar(column))
                places[name] = self.parameter(row)
                column += 1
            steps.append(Assign(value, self._step(step.index, step.before, value, places)))
        self.statements += [
            start,
            Table(table, "static const int", rows),
            For(turn, Scalar(len(rows)), tuple(steps)),
        ]
        return value

    def _step(
        self, index: int, before: int, value: Expression, places: Mapping[str, Expression]
    ) -> Expression:
        """Return the expression of an operation of a step."""
        if index == before:
            return value
        operation = self.program.operations[index]
        if operation.symbol in places:
            return places[operation.symbol]
        operands = {k: self._step(k, before, value, places) for k in operation.operands}
        return self._value(index, operands)

    def _loops(self) -> list[_Loop]:
        """Return the loops of the chains that end in outputs."""
        return [loop for output in self.program.outputs for loop in _rolled(self._chain(output))]

    def _chain(self, output: int) -> list[_Step]:
        """Return the steps of the chain that ends in an operation, in order."""
        operations = self.program.operations
        uses = [0] * len(operations)
        for operation in operations:
            for operand in operation.operands:
                uses[operand] += 1
        found: list[_Step] = []
        index = output
        while (before := _before(operations[index], operations)) is not None:
            if found and uses[index] > 1:
                break
            parameters: dict[str, None] = {}
            shape = self._shape(index, before, parameters, [MAX_STEP_SIZE])
            if shape is None:
                break
            found.append(_Step(index, before, shape, tuple(parameters)))
            index = before
        return found[::-1]

    def _shape(
        self, index: int, before: int, parameters: dict[str, None], room: list[int]
    ) -> Shape | None:
        """Return the shape of an operation; None if it is too large for a step."""
        operation = self.program.operations[index]
        if index == before:
            return ("before",)
        if operation.symbol in self.numbers:
            parameters.setdefault(operation.symbol)
            return ("parameter", list(parameters).index(operation.symbol))
        room[0] -= not operation.is_free
        if room[0] < 0:
            return None
        parts: list[object] = [operation.name, operation.symbol, repr(operation.value)]
        for operand in operation.operands:
            part = self._shape(operand, before, parameters, room)
            if part is None:
                return None
            parts.append(part)
        return tuple(parts)


def _before(operation: Operation, operations: Sequence[Operation]) -> int | None:
    """Return the operand that a step takes the value so far from, if the operation can be one."""
    if operation.name in ("add", "both"):
        return operation.operands[0]
    if operation.name == "select" and operations[operation.operands[2]].name == "constant":
        return operation.operands[1]
    return None


def _rolled(steps: Sequence[_Step]) -> list[_Loop]:
    """Return the loops over runs of steps that repeat."""
    found: list[_Loop] = []
    shapes = [(step.shape, len(step.parameters)) for step in steps]
    start = 0
    while start < len(steps):
        period, turns = max(
            ((p, _turns(shapes, start, p)) for p in range(1, MAX_PERIOD + 1)),
            key=lambda pair: (pair[0] * (pair[1] - 1), -pair[0]),
        )
        if period * (turns - 1) < MIN_STEPS or not any(
            n for _, n in shapes[start : start + period]
        ):
            start += 1
            continue
        past = start + period * turns
        own = (tuple(steps[k : k + period]) for k in range(start, past, period))
        found.append(_Loop(tuple(own)))
        start = past
    return found


def _turns(shapes: Sequence[tuple[Shape, int]], start: int, period: int) -> int:
    """Return the number of repetitions of the steps of a period."""
    turns, first = 1, shapes[start : start + period]
    while first == shapes[start + turns * period : start + (turns + 1) * period] != []:
        turns += 1
    return turns if len(first) == period else 1


def parameter_kernels(loop: Loop) -> set[str]:
    """Return the names of the kernels that are given all parameters."""
    return {node.kernel.name for node in walk(loop.stages["validate"]) if isinstance(node, Call)}


def rerolled(
    program: Program,
    numbers: Mapping[str, int],
    spelling: Spelling,
    parameter: Callable[[Expression], Expression],
) -> Body:
    """Return the statements and outputs of a program of parameters, long chains as loops.

    Parameters
    ----------
    program
        The program, in double precision.
    numbers
        By name, the number of each parameter.
    spelling
        The types of the target.
    parameter
        Function of a parameter's number that returns what reads it.
    """
    return _Rerolled(program, numbers, spelling, parameter).body()
