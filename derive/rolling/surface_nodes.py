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


def shifted_bound(surface: LoopSurface, part: str) -> Call:
    """Return the evaluation of what the carried errors add to the distance within a bound."""
    moved = {f"v{axis}": f"d{axis}" for axis in "xyz"}
    node = Call(surface.parts[part], wanted=frozenset({"bound_rate"}))
    arguments = {str(symbol) for symbol in node.kernel.arguments}
    inputs = {name: own for name, own in moved.items() if name in arguments}
    named = Call(node.kernel, inputs, {"bound_rate": "bound_shift"}, node.wanted)
    return given_as(named, surface.sizes)


def outside(common: Parts, surface: LoopSurface, *decisions: str) -> Iterator[Node]:
    """Evaluate decisions for each bound of a surface beside the ball, if it has any."""
    if bounds := bounds_of(surface):
        yield Call(common["unbounded"])
    for part in bounds:
        yield part_call(surface, part)
        if "entering_bound" in decisions:
            yield shifted_bound(surface, part)
        yield from (Call(common[decision]) for decision in decisions)


def accelerated(common: Parts, surface: LoopSurface, when: str) -> Iterator[Node]:
    """Evaluate the acceleration of a ball that rolls on a surface where it is."""
    rolls = {f"rolled_{axis}": f"v{axis}" for axis in "xyz"}
    yield part_call(surface, "normal")
    yield Call(common["roll_turn_rate"])
    turning = part_call(surface, "turning")
    yield Call(turning.kernel, {**turning.inputs, **_only(turning, rolls)}, turning.outputs)
    named = {f"rolling_acceleration_{axis}": f"{when}_{axis}" for axis in "xyz"}
    pressed = Call(common["pressed_on"])
    yield Call(pressed.kernel, _only(pressed, rolls), named)


def _only(node: Call, names: Mapping[str, str]) -> dict[str, str]:
    """Return those of the names that a kernel has as arguments."""
    arguments = {str(symbol) for symbol in node.kernel.arguments}
    return {name: own for name, own in names.items() if name in arguments}


def at_seams(common: Parts, holders: Sequence[LoopSurface], decision: str) -> Iterator[Node]:
    """Evaluate a decision for each seam of the surface that the ball is on."""
    for surface in holders:
        seams = [part for part in surface.parts if part.startswith("seam")]
        if seams:
            each = (n for s in seams for n in (part_call(surface, s), Call(common[decision])))
            yield Call(common["holding"], {"index": surface.index})
            yield If("here", tuple(each))
