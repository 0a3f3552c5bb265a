"""What a kernel makes of parameters alone: for C it is made once, not for each shot again.

Where all shots share their parameters it is made as a job begins; where each has its own, before a
pass goes over a row of lanes. A kernel takes it ready made, after what it is given otherwise.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from hoopgen.derive.follow.loop import Loop
from hoopgen.derive.ground.tree import Do, Node, walk

from .names import identifier
from .printers import C_SINGLE, C, print_program
from .program import Operation, Operations, Program


@dataclass(frozen=True)
class Split:
    """A kernel that is given what it makes of parameters alone.

    Attributes
    ----------
    whole
        The kernel as it was lowered.
    rest
        What is left of it; its arguments `_c0` and so on are ready made.
    made
        The operations of the whole that they are.
    kept
        The places of the arguments that it takes as they are.
    """

    whole: Program
    rest: Program
    made: tuple[int, ...]
    kept: tuple[int, ...]


def splits(programs: Iterable[Program], loops: Sequence[Loop]) -> dict[str, Split]:
    """Return, by name, the kernels that are given something ready made."""
    found = {}
    shared = _shared(loops)
    for program in programs:
        if program.kernel.name in shared:
            own = split(program, shared[program.kernel.name])
            if own.made:
                found[program.kernel.name] = own
    return found


def _shared(loops: Sequence[Loop]) -> dict[str, set[int]]:
    """Return the places of a kernel's arguments that are parameters wherever it is evaluated."""
    found: dict[str, set[int]] = {}
    elsewhere: set[str] = set()
    for loop in loops:
        for stage, nodes in loop.stages.items():
            if stage == "permit":
                elsewhere |= {n.kernel.name for n in walk(nodes) if isinstance(n, Do)}
        for table in loop.tables:
            if table.groups is not None:
                elsewhere |= {table.groups.box.kernel.name, table.groups.near.kernel.name}
        for do in (n for s in loop.stages.values() for n in walk(s) if isinstance(n, Do)):
            places = {k for k, value in enumerate(do.arguments) if value in loop.parameters}
            found[do.kernel.name] = found.get(do.kernel.name, places) & places
    return {name: places for name, places in found.items() if name not in elsewhere}


def split(program: Program, places: Collection[int]) -> Split:
    """Return a kernel that is given what it makes of the arguments in some places alone."""
    names = [identifier(symbol) for symbol in program.kernel.arguments]
    operations = program.operations
    fixed = _fixed(operations, {names[k] for k in places})
    wanted = dict.fromkeys(
        k for operation in _rest(operations, fixed) for k in operation.operands if k in fixed
    )
    wanted |= dict.fromkeys(k for k in program.outputs if k in fixed)
    made = tuple(k for k in sorted(wanted) if operations[k].name != "constant")
    rest = replace(program, operations=[], outputs=[], _index={}, _lowered={})
    places_in_rest = {
        k: rest.add(Operation("argument", symbol=f"_c{n}")) for n, k in enumerate(made)
    }
    for k, operation in enumerate(operations):
        if k not in fixed or (k in wanted and operation.name == "constant"):
            operands = tuple(places_in_rest[o] for o in operation.operands)
            places_in_rest[k] = rest.add(replace(operation, operands=operands))
    rest.outputs = [places_in_rest[k] for k in program.outputs]
    used = {o.symbol for o in rest.operations}
    kept = tuple(k for k, name in enumerate(names) if name in used)
    return Split(program, rest, made, kept)


def _fixed(operations: Sequence[Operation], names: Collection[str]) -> set[int]:
    """Return the numbers that depend on nothing but those arguments."""
    fixed: set[int] = set()
    for k, operation in enumerate(operations):
        if operation.name == "argument":
            known = operation.symbol in names
        else:
            known = not operation.is_truth and fixed.issuperset(operation.operands)
        if known:
            fixed.add(k)
    return fixed


def _rest(operations: Sequence[Operation], fixed: Collection[int]) -> Iterator[Operation]:
    return (operation for k, operation in enumerate(operations) if k not in fixed)


@dataclass
class _Made:
    """What is made in one precision: each of the outputs has a row of lanes of its own."""

    operations: Operations
    column: str
    store: str
    load: str

    def place(self, index: int) -> int:
        """Return the row of an operation."""
        outputs = self.operations.outputs
        if index not in outputs:
            outputs.append(index)
        return outputs.index(index)


@dataclass
class Fixed:
    """What a loop's kernels are given ready made.

    Attributes
    ----------
    splits
        Those kernels.
    """

    splits: Mapping[str, Split] = field(default_factory=dict)
    _made: dict[bool, _Made] = field(
        default_factory=lambda: {
            False: _Made(Operations(), "fixed", "lanes_store", "lanes_load"),
            True: _Made(Operations(single=True), "fixed_single", "singles_store", "singles_load"),
        }
    )

    def given(self, node: Do, given: Sequence[str]) -> list[str]:
        """Return what a kernel takes, of what it would be given."""
        own = self.splits.get(node.kernel.name)
        if own is None:
            return list(given)
        made = self._made[own.whole.single]
        rows = (f"lists->{made.column}[{made.place(k)}]" for k in self._indices(node, own))
        return [*(given[k] for k in own.kept), *(f"{made.load}({row})" for row in rows)]

    def _indices(self, node: Do, own: Split) -> list[int]:
        """Return, of all that is made, what a kernel is given."""
        arguments = map(identifier, node.kernel.arguments)
        names = dict(zip(arguments, node.arguments, strict=True))
        made = self._made[own.whole.single].operations
        placed: dict[int, int] = {}
        for k in _needed(own.whole, own.made):
            operation = own.whole.operations[k]
            operands = tuple(placed[o] for o in operation.operands)
            symbol = str(names.get(operation.symbol, ""))
            placed[k] = made.add(replace(operation, operands=operands, symbol=symbol))
        return [placed[k] for k in own.made]

    def of(self, nodes: Iterable[Node]) -> tuple[set[int], set[int]]:
        """Return the rows, in double and in single precision, that the kernels of nodes take."""
        found: tuple[set[int], set[int]] = (set(), set())
        for node in walk(nodes):
            own = self.splits.get(node.kernel.name) if isinstance(node, Do) else None
            if isinstance(node, Do) and own is not None:
                made = self._made[own.whole.single]
                found[own.whole.single].update(map(made.place, self._indices(node, own)))
        return found

    @property
    def counts(self) -> dict[str, int]:
        """How many rows there are of each precision, by the name of the array."""
        return {m.column: len(m.operations.outputs) for m in self._made.values()}

    @property
    def all(self) -> tuple[set[int], set[int]]:
        """All rows."""
        double, single = (set(range(len(m.operations.outputs))) for m in self._made.values())
        return double, single

    def reads(self, rows: tuple[set[int], set[int]]) -> list[str]:
        """Return the parameters that rows are made of."""
        found: set[str] = set()
        for made, wanted in zip(self._made.values(), rows, strict=True):
            needed = _needed(made.operations, [made.operations.outputs[row] for row in wanted])
            found |= {made.operations.operations[k].symbol for k in needed}
        return sorted(found - {""})

    def lines(self, rows: tuple[set[int], set[int]]) -> list[str]:
        """Return the lines that make rows of the parameters."""
        lines: list[str] = []
        for made, wanted in zip(self._made.values(), rows, strict=True):
            if wanted:
                lines += ["{", *(f"    {line}" for line in _lines(made, sorted(wanted))), "}"]
        return lines


def _lines(made: _Made, rows: Sequence[int]) -> Iterator[str]:
    whole = made.operations
    wanted = [whole.outputs[row] for row in rows]
    part, placed = Operations(single=whole.single), dict[int, int]()
    for k in _needed(whole, wanted):
        operation = whole.operations[k]
        if whole.single and operation.symbol:
            narrow = f"_{operation.symbol}"
            yield f"const S {narrow} = lanes_narrow({operation.symbol});"
            operation = replace(operation, symbol=narrow)
        operands = tuple(placed[o] for o in operation.operands)
        placed[k] = part.add(replace(operation, operands=operands))
    part.outputs = [placed[k] for k in wanted]
    body = print_program(part, C_SINGLE if whole.single else C)
    yield from body.statements
    for row, output in zip(rows, body.outputs, strict=True):
        yield f"{made.store}(lists->{made.column}[{row}], {output});"


def _needed(operations: Operations, wanted: Iterable[int]) -> list[int]:
    """Return what some operations need, in order, and themselves."""
    found = set(wanted)
    for k in reversed(range(len(operations.operations))):
        if k in found:
            found.update(operations.operations[k].operands)
    return sorted(found)
