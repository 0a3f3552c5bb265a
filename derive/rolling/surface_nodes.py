"""Nodes of the event loop that evaluate kernels of one surface beside or below the ball."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from types import MappingProxyType

from ..events.search import Parts
from ..ir.event_tree import Call, If, Node, Value, given_as
from ..state.shared_kernels import LoopSurface, by_law, for_each, for_runs, on_surface


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


def on_held(
    common: Parts,
    surfaces: Sequence[LoopSurface],
    *parts: str,
    names: Mapping[str, str] = MappingProxyType({}),
) -> Iterator[Node]:
    """Yield nodes that evaluate kernels of the surface that the ball stays on.

    Parameters
    ----------
    common
        The kernels that all surfaces share, by name.
    surfaces
        The surfaces that a ball may stay on.
    parts
        The kernels, by their names among the parts of a surface.
    names
        The names that a motion has for the state, by the kernels' own.
    """

    def own(surface: LoopSurface) -> Iterator[Node]:
        yield from (part_call(surface, part, names) for part in parts)

    yield from if_held(common, surfaces, own)


def if_held(
    common: Parts,
    surfaces: Sequence[LoopSurface],
    body: Callable[[LoopSurface], Iterator[Node]],
    decision: str = "holding",
) -> Iterator[Node]:
    """Yield nodes for the surface that the ball stays on.

    Parameters
    ----------
    common
        The kernels that all surfaces share, by name.
    surfaces
        The surfaces that a ball may stay on.
    body
        Function of a surface that returns the nodes.
    decision
        The decision about a surface: "taking_over" for that which the ball goes over to.
    """

    def own(surface: LoopSurface, index: Value) -> Iterator[Node]:
        yield Call(common[decision], {"index": index})
        yield If("here", tuple(body(surface)))

    yield from for_runs(surfaces, own)


def held_law(common: Parts, surfaces: Sequence[LoopSurface], part: str) -> Iterator[Node]:
    """Yield nodes that evaluate a kernel of the law of the surface that the ball stays on.

    Parameters
    ----------
    common
        The kernels that all surfaces share, by name.
    surfaces
        The surfaces that a ball may stay on.
    part
        The kernel, by its name among the parts of a law.
    """

    def own(surface: LoopSurface, index: Value) -> Iterator[Node]:
        yield Call(common["holding"], {"index": index})
        yield If("here", (Call(surface.law[part]),))

    for alike in by_law(surfaces):
        yield from for_each(alike, own)


def on_event(common: Parts, surfaces: Sequence[LoopSurface], *parts: str) -> Iterator[Node]:
    """Yield nodes that evaluate kernels of the surface of the event.

    Where it is none of these, what they assign has no meaning.

    Parameters
    ----------
    common
        The kernels that all surfaces share, by name.
    surfaces
        The surfaces that a ball may stay on.
    parts
        The kernels, by their names among the parts of a surface.
    """
    first, *others = surfaces
    yield from (part_call(first, part) for part in parts)

    def own(surface: LoopSurface, index: Value) -> Iterator[Node]:
        yield from on_surface(common, index, *(part_call(surface, part) for part in parts))

    yield from for_runs(others, own)


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

    def each(surface: LoopSurface) -> Iterator[Node]:
        for seam in seams_of(surface):
            yield part_call(surface, seam)
            yield Call(common[decision])

    yield from if_held(common, [surface for surface in holders if seams_of(surface)], each)


def nearest_others(
    common: Parts, contacts: Sequence[LoopSurface], end_planes: Sequence[LoopSurface]
) -> Iterator[Node]:
    """Yield nodes that evaluate how far a ball is from all but the part of the surface it is on.

    That is the surface of the event. On a seam of it, within the errors, the shot is undecided.

    Parameters
    ----------
    common
        The kernels that all surfaces share, by name.
    contacts
        The surfaces of bodies.
    end_planes
        The planes whose crossing ends a shot.
    """

    def distance(surface: LoopSurface, index: Value) -> Iterator[Node]:
        yield Call(common["other_surface"], {"index": index})
        other = (
            part_call(surface, "closing"),
            *outside(common, surface, "outside_by"),
            Call(common["near_bounded_body" if bounds_of(surface) else "near_body"]),
        )
        yield If("beside", other)
        if "rolling_surface" in surface.parts and (own := tuple(_own_borders(common, surface))):
            yield from on_surface(common, index, *own)

    yield Call(common["isolated"])
    yield from for_runs(contacts, distance)
    if "near_apex" in common:
        yield Call(common["near_apex"])
    for end_plane in end_planes:
        beside = Call(end_plane.parts["beside"], wanted=frozenset({"gap"}))
        yield given_as(beside, end_plane.sizes)
        yield Call(common["near_end_plane"])


def _own_borders(common: Parts, surface: LoopSurface) -> Iterator[Node]:
    """Yield nodes that evaluate how far a ball is from the bounds and seams of its surface."""
    for part in bounds_of(surface):
        yield part_call(surface, part)
        yield Call(common["beside_edge"])
    for part in seams_of(surface):
        yield part_call(surface, part)
        if "near_seam" in common:
            yield Call(common["near_seam"])
        yield Call(common["seam_undecided"])
