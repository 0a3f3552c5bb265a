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
    """Return the evaluation of a kernel of a surface.

    Parameters
    ----------
    surface
        The surface.
    part
        The kernel, by its name among the parts of the surface.
    names
        The names that a motion has for the state, by the kernel's own.
    """
    return given_as(renamed(Call(surface.parts[part]), names), surface.sizes)


def renamed(node: Call, names: Mapping[str, str]) -> Call:
    """Return the evaluation for a motion whose state has other names.

    Parameters
    ----------
    node
        The evaluation of a kernel.
    names
        The other names, by the kernel's own.
    """
    arguments = {str(symbol) for symbol in node.kernel.arguments}
    inputs = {name: own for name, own in names.items() if name in arguments}
    outputs = {name: own for name, own in names.items() if name in node.kernel.output_names}
    return Call(node.kernel, {**inputs, **node.inputs}, outputs)


def on_held(common: Parts, surfaces: Sequence[LoopSurface], *parts: str) -> Iterator[Node]:
    """Yield nodes that evaluate kernels of the surface that the ball stays on.

    Parameters
    ----------
    common
        The kernels that all surfaces share, by name.
    surfaces
        The surfaces that a ball may stay on.
    parts
        The kernels, by their names among the parts of a surface.
    """
    for surface in surfaces:
        yield Call(common["holding"], {"index": surface.index})
        yield If("here", tuple(part_call(surface, part) for part in parts))


def bounds_of(surface: LoopSurface) -> list[str]:
    """Return the parts of a surface's kernels that are its bounds.

    Parameters
    ----------
    surface
        The surface.
    """
    return [part for part in surface.parts if part.startswith("rim")]


def seams_of(surface: LoopSurface) -> list[str]:
    """Return the parts of a surface's kernels that are its seams.

    Parameters
    ----------
    surface
        The surface.
    """
    return [part for part in surface.parts if part.startswith("seam")]


def shifted_bound(surface: LoopSurface, part: str) -> Call:
    """Return the evaluation of what the carried errors add to the distance within a bound.

    Parameters
    ----------
    surface
        The surface.
    part
        The kernel of the bound, by its name among the parts of the surface.
    """
    moved = {f"v{axis}": f"d{axis}" for axis in "xyz"}
    node = Call(surface.parts[part], wanted=frozenset({"bound_rate"}))
    arguments = {str(symbol) for symbol in node.kernel.arguments}
    inputs = {name: own for name, own in moved.items() if name in arguments}
    named = Call(node.kernel, inputs, {"bound_rate": "bound_shift"}, node.wanted)
    return given_as(named, surface.sizes)


def outside(common: Parts, surface: LoopSurface, *decisions: str) -> Iterator[Node]:
    """Yield nodes that decide for each bound of a surface beside the ball, if it has any.

    Parameters
    ----------
    common
        The kernels that all surfaces share, by name.
    surface
        The surface beside the ball.
    decisions
        The names of the decisions.
    """
    creased = "crease" in surface.parts
    if bounds := bounds_of(surface):
        yield Call(common["unbounded"])
    if creased:
        yield part_call(surface, "crease")
        decisions = tuple(one.replace("outside_bound", "outside_bound_of_box") for one in decisions)
    for part in bounds:
        yield part_call(surface, part)
        if "entering_bound" in decisions:
            yield shifted_bound(surface, part)
        yield from (Call(common[decision]) for decision in decisions)


def accelerated(common: Parts, surface: LoopSurface, when: str) -> Iterator[Node]:
    """Yield nodes that evaluate the acceleration of a ball that rolls on a surface where it is.

    Parameters
    ----------
    common
        The kernels that all surfaces share, by name.
    surface
        The surface.
    when
        The word with which the names of the result begin: "before" or "after" an edge.
    """
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
    """Yield nodes that decide for each seam of the surface that the ball is on.

    Parameters
    ----------
    common
        The kernels that all surfaces share, by name.
    holders
        The surfaces that a ball may roll on.
    decision
        The name of the decision.
    """
    for surface in holders:
        if seams := seams_of(surface):
            each = (n for s in seams for n in (part_call(surface, s), Call(common[decision])))
            yield Call(common["holding"], {"index": surface.index})
            yield If("here", tuple(each))


def nearest_others(
    common: Parts, contacts: Sequence[LoopSurface], end_planes: Sequence[LoopSurface], index: int
) -> Iterator[Node]:
    """Yield nodes that evaluate how far a ball is from all but the part of the surface it is on.

    On a seam of that surface, within the errors, the shot is undecided.

    Parameters
    ----------
    common
        The kernels that all surfaces share, by name.
    contacts
        The surfaces of bodies.
    end_planes
        The planes whose crossing ends a shot.
    index
        The surface that the ball is on.
    """
    yield Call(common["isolated"])
    for surface in contacts:
        if surface.index != index:
            yield part_call(surface, "closing")
            yield from outside(common, surface, "outside_by")
            yield Call(common["near_bounded_body" if bounds_of(surface) else "near_body"])
            continue
        for part in bounds_of(surface):
            yield part_call(surface, part)
            yield Call(common["beside_edge"])
        for part in seams_of(surface):
            yield part_call(surface, part)
            if "near_seam" in common:
                yield Call(common["near_seam"])
            yield Call(common["seam_undecided"])
        if "near_apex" in common:
            yield Call(common["near_apex"])
    for end_plane in end_planes:
        beside = Call(end_plane.parts["beside"], wanted=frozenset({"gap"}))
        yield given_as(beside, end_plane.sizes)
        yield Call(common["near_end_plane"])
