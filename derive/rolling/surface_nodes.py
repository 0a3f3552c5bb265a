"""Nodes of the event loop that evaluate kernels of one surface beside or below the ball."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType

from ..events.search import Parts
from ..ir.event_tree import Call, If, Node, given_as
from ..state.shared_kernels import LoopSurface


def part_call(
    surface: LoopSurface, part: str, names: Mapping[str, str] = MappingProxyType({})
) -> Call:
    """Return the evaluation of a kernel of a surface, for a motion whose state has such names."""
    return given_as(renamed(Call(surface.parts[part]), names), surface.sizes)


def renamed(node: Call, names: Mapping[str, str]) -> Call:
    """Return the evaluation for a motion whose state has other names."""
    arguments = {str(symbol) for symbol in node.kernel.arguments}
    inputs = {name: own for name, own in names.items() if name in arguments}
    outputs = {name: own for name, own in names.items() if name in node.kernel.output_names}
    return Call(node.kernel, {**inputs, **node.inputs}, outputs)


def on_held(common: Parts, surfaces: Sequence[LoopSurface], *parts: str) -> Iterator[Node]:
    """Evaluate kernels of the surface that the ball stays on."""
    for surface in surfaces:
        yield Call(common["holding"], {"index": surface.index})
        yield If("here", tuple(part_call(surface, part) for part in parts))


def bounds_of(surface: LoopSurface) -> list[str]:
    """Return the parts of a surface's kernels that are its bounds."""
    return [part for part in surface.parts if part.startswith("rim")]


def outside(common: Parts, surface: LoopSurface, *decisions: str) -> Iterator[Node]:
    """Evaluate decisions for each bound of a surface beside the ball, if it has any."""
    if bounds := bounds_of(surface):
        yield Call(common["unbounded"])
    for part in bounds:
        yield part_call(surface, part)
        yield from (Call(common[decision]) for decision in decisions)
