"""Hoisting: what a kernel computes of parameters alone need not be computed for each shot again.

A kernel is evaluated partially. What depends on nothing but parameters is loop invariant: a target
can compute it once, and give it to what is left of the kernel after its other arguments.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.event_tree import walk
from hoopgen.derive.loop.loop import Loop

from .identifiers import identifier
from .program import Operation, Operations, Program


@dataclass(frozen=True)
class PartialEvaluation:
    """A kernel in two parts: what depends on parameters alone, and the rest.

    Attributes
    ----------
    whole
        The kernel as it was lowered.
    rest
        What is left of it; its arguments `_c0` and so on are the loop invariant results.
    loop_invariant
        The operations of the whole that they are.
    kept_arguments
        The places of the arguments that the rest takes as they are.
    """

    whole: Program
    rest: Program
    loop_invariant: tuple[int, ...]
    kept_arguments: tuple[int, ...]


def partial_evaluations(
    programs: Iterable[Program], loops: Sequence[Loop]
) -> dict[str, PartialEvaluation]:
    """Return, by name, the kernels of event loops that have something loop invariant.

    Parameters
    ----------
    programs
        The kernels, lowered, by name.
    loops
        The variants of the event loop.
    """
    found = {}
    shared = _shared(loops)
    for program in programs:
        if program.kernel.name in shared:
            own = partial_evaluation(program, shared[program.kernel.name])
            if own.loop_invariant:
                found[program.kernel.name] = own
    return found


def _shared(loops: Sequence[Loop]) -> dict[str, set[int]]:
    """Return the places of a kernel's arguments that are parameters wherever it is evaluated."""
    found: dict[str, set[int]] = {}
    elsewhere: set[str] = set()
    for loop in loops:
        for stage, nodes in loop.stages.items():
            if stage == "validate":
                elsewhere |= {n.kernel.name for n in walk(nodes) if isinstance(n, ir.Call)}
        for table in loop.tables:
            if table.groups is not None:
                elsewhere |= {table.groups.box.kernel.name, table.groups.near.kernel.name}
        calls = (n for s in loop.stages.values() for n in walk(s) if isinstance(n, ir.Call))
        for do in (*calls, *loop.shortcuts):
            places = {k for k, value in enumerate(do.arguments) if value in loop.parameters}
            found[do.kernel.name] = found.get(do.kernel.name, places) & places
    return {name: places for name, places in found.items() if name not in elsewhere}


def partial_evaluation(program: Program, places: Collection[int]) -> PartialEvaluation:
    """Return a kernel without what depends on the arguments in some places alone.

    Parameters
    ----------
    program
        The kernel, lowered.
    places
        The places of the arguments that are the same in every iteration.
    """
    names = [identifier(symbol) for symbol in program.kernel.arguments]
    operations = program.operations
    invariant = _invariant(operations, {names[k] for k in places})
    wanted = dict.fromkeys(
        k
        for operation in _rest(operations, invariant)
        for k in operation.operands
        if k in invariant
    )
    wanted |= dict.fromkeys(k for k in program.outputs if k in invariant)
    loop_invariant = tuple(k for k in sorted(wanted) if operations[k].name != "constant")
    rest = replace(program, operations=[], outputs=[], _index={}, _lowered={})
    places_in_rest = {
        k: rest.add(Operation("argument", symbol=f"_c{n}")) for n, k in enumerate(loop_invariant)
    }
    for k, operation in enumerate(operations):
        if k not in invariant or (k in wanted and operation.name == "constant"):
            operands = tuple(places_in_rest[o] for o in operation.operands)
            places_in_rest[k] = rest.add(replace(operation, operands=operands))
    rest.outputs = [places_in_rest[k] for k in program.outputs]
    used = {o.symbol for o in rest.operations}
    kept_arguments = tuple(k for k, name in enumerate(names) if name in used)
    return PartialEvaluation(program, rest, loop_invariant, kept_arguments)


def _invariant(operations: Sequence[Operation], names: Collection[str]) -> set[int]:
    """Return the numbers that depend on nothing but those arguments."""
    found: set[int] = set()
    for k, operation in enumerate(operations):
        if operation.name == "argument":
            known = operation.symbol in names
        else:
            known = not operation.is_truth and found.issuperset(operation.operands)
        if known:
            found.add(k)
    return found


def _rest(operations: Sequence[Operation], invariant: Collection[int]) -> Iterator[Operation]:
    return (operation for k, operation in enumerate(operations) if k not in invariant)


def needed_by(operations: Operations, wanted: Iterable[int]) -> list[int]:
    """Return operations and all operations that they need, in order.

    Parameters
    ----------
    operations
        A program in order: an operation stands after its operands.
    wanted
        The numbers of the operations, from 0.

    Returns
    -------
    list of int
        Their numbers, in order.
    """
    found = set(wanted)
    for k in reversed(range(len(operations.operations))):
        if k in found:
            found.update(operations.operations[k].operands)
    return sorted(found)
