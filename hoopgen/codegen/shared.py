"""What depends on the parameters alone: computed once, where many shots share them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from .loop import weighted
from .printers import Body, C, print_program
from .program import Operation, Program

WORTH = 2
"""Operations that cost less, in additions, are repeated: to fetch their result costs as much."""


@dataclass(frozen=True)
class Shared:
    """The quantities that several kernels share.

    Attributes
    ----------
    names
        Theirs, as variables.
    body
        What computes them from the parameters, in C.
    given
        By kernel, the operations that are given instead, and the names of what gives them.
    """

    names: list[str]
    body: Body
    given: dict[str, dict[int, str]]

    def extra(self, kernel: str) -> list[str]:
        """Return the names of what a kernel is given beside its arguments."""
        return list(dict.fromkeys(self.given[kernel].values()))


def shared(programs: Iterable[Program], parameters: Sequence[str]) -> Shared:
    """Return what the programs compute of the parameters alone."""
    merged: Program | None = None
    names: dict[int, str] = {}
    given: dict[str, dict[int, str]] = {}
    for program in programs:
        if merged is None:
            merged = Program(program.kernel)
        whole = _whole(program, parameters)
        places: dict[int, int] = {}
        own = given[program.kernel.name] = {}
        for index in _largest(program, whole):
            if _cost(program, index) >= WORTH:
                place = _copied(program, index, merged, places)
                own[index] = names.setdefault(place, f"_q{len(names)}")
    assert merged is not None
    merged.outputs = list(names)
    return Shared(list(names.values()), print_program(merged, C), given)


def _whole(program: Program, parameters: Sequence[str]) -> list[bool]:
    """Return which operations depend on nothing but parameters."""
    whole: list[bool] = []
    for operation in program.operations:
        if operation.name in ("argument", "truth"):
            whole.append(operation.symbol in parameters)
        else:
            # What a condition decides stays with its kernel: it is not arithmetic.
            kept = operation.is_truth or operation.name == "select"
            whole.append(not kept and all(whole[operand] for operand in operation.operands))
    return whole


def _largest(program: Program, whole: Sequence[bool]) -> list[int]:
    """Return the operations of that kind which another one, or nobody else, needs."""
    wanted = {k for k in program.outputs if whole[k]}
    for operation, own in zip(program.operations, whole, strict=True):
        if not own:
            wanted |= {operand for operand in operation.operands if whole[operand]}
    return sorted(k for k in wanted if not program.operations[k].is_free)


def _cost(program: Program, index: int) -> int:
    """Return about what an operation costs with all that it needs."""
    seen: set[int] = set()
    stack = [index]
    counts: dict[str, int] = {}
    while stack:
        k = stack.pop()
        if k in seen:
            continue
        seen.add(k)
        operation = program.operations[k]
        if not operation.is_free:
            counts[operation.name] = counts.get(operation.name, 0) + 1
        stack.extend(operation.operands)
    return weighted(counts)


def _copied(program: Program, index: int, into: Program, places: dict[int, int]) -> int:
    """Copy an operation, with all that it needs, to another program; return its place there."""
    if index not in places:
        operation = program.operations[index]
        operands = tuple(_copied(program, k, into, places) for k in operation.operands)
        places[index] = into.append(
            Operation(operation.name, operands, operation.symbol, operation.value)
        )
    return places[index]
