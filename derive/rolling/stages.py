"""The contact phase as nodes of the event loop, from the last bounce to departure or rest.

The turn after the last bounce puts the ball onto the surface. In the same turn it rolls, step by
step, until it meets something, leaves, rests, or its time is up. A ball that leaves tangentially
flies for a moment in which it certainly meets nothing; then it is in flight like any other.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType

from ..events.search import Parts
from ..ir.event_tree import Call, If, Node, Value, While, given_as
from ..motion import ring_rolling_series, rolling_series
from ..state.shared_kernels import LoopSurface, for_runs, on_law
from ..symbolic.symbols import STATE, normal
from .surface_nodes import (
    accelerated,
    at_seams,
    bounds_of,
    held_law,
    if_held,
    nearest_others,
    on_event,
    on_held,
    outside,
    part_call,
    renamed,
    shifted_bound,
)

MAX_STEPS_PER_TURN = 1 << 4
"""Steps of a ball in contact in one turn of the loop; it goes on in the next turn. Balls that roll
longer than most wait for others that do, so that the lanes stay busy."""

_ABOUT_AXIS = (rolling_series.per_width, *rolling_series.outward)
_NEIGHBOUR = {s.name: f"far_{s.name}" for s in (*STATE, *normal, *_ABOUT_AXIS)}
_NEIGHBOUR |= {"gap": "far_gap"}
"""Variables of the neighbouring motion; it has its own, so that neither waits for the other."""


def in_contact(
    common: Parts, contacts: Sequence[LoopSurface], end_planes: Sequence[LoopSurface]
) -> Iterator[Node]:
    """Yield the nodes that find the next event of balls in contact, and move the balls there.

    Parameters
    ----------
    common
        The kernels that all surfaces share, by part.
    contacts
        The surfaces of bodies, each with its kernels.
    end_planes
        The planes whose crossing ends a shot.
    """
    holders = [surface for surface in contacts if "rolling_surface" in surface.parts]
    rings = [surface for surface in holders if "round_start" in surface.parts]
    others = [surface for surface in holders if surface not in rings]
    yield Call(common["resumed"])
    edged = any(map(bounds_of, holders))
    if edged:
        yield Call(common["no_edge"])
    begin = (
        *on_held(common, holders, "normal"),
        Call(common["roll_turn_rate"]),
        Call(common["gripped"]),
        *on_held(common, holders, "distance"),
        *_last_bounce(common, holders),
        Call(
            common["roll_placed"],
            {f"v{axis}": f"rolled_{axis}" for axis in "xyz"},
        ),
        Call(common["jump_errors"]),
        Call(common["forget_grip_deficit"]),
        Call(common["beginning_contact"]),
    )
    yield If("begins", begin, rare=True)
    for ring in rings:
        yield Call(common["circles"], {"index": ring.index})
    step = tuple(_step(common, others, contacts, end_planes))
    yield While("rolling", MAX_STEPS_PER_TURN, step)
    for ring in rings:
        step = tuple(_ring_step(common, ring, contacts, end_planes))
        yield While("circling", MAX_STEPS_PER_TURN, step)
        yield Call(common["still_in_contact"])
    if edged:
        yield Call(common["at_edge"])
        yield If("over_edge", tuple(_past_edge(common, holders)), rare=True)
    depart = (
        Call(common["error_bounds"]),
        *on_held(common, holders, "rolling_surface", "separation"),
        *_free_time(common, contacts, end_planes),
        *at_seams(common, holders, "seam_free_time"),
        Call(common["separated"]),
        Call(common["detachment"]),
    )
    yield If("leaves", depart, rare=True)


def _last_bounce(common: Parts, holders: Sequence[LoopSurface]) -> Iterator[Node]:
    """Evaluate what presses the ball on, where the errors of the jump depend on it."""
    if not any("rebound" in surface.law for surface in holders):
        if "reaches_apex" in common:
            yield from on_held(common, holders, "rolling_surface")
        return
    yield Call(common["no_bounce"])
    yield from held_law(common, holders, "rebound")
    yield from on_held(common, holders, "rolling_surface", "turning")
    yield Call(common["pressed_on"])


def settled(
    common: Parts, contacts: Sequence[LoopSurface], end_planes: Sequence[LoopSurface]
) -> Iterator[Node]:
    """Yield the nodes that decide whether a ball that hardly leaves a surface stays on it.

    Parameters
    ----------
    common, contacts, end_planes
        As for `in_contact`.
    """
    holders = [surface for surface in contacts if "rolling_surface" in surface.parts]
    if not holders:
        return
    nodes: list[Node] = [Call(common["estimates"])] if "estimates" in common else []
    nodes += [*on_event(common, holders, "normal"), Call(common["off_at_start"])]
    nodes.append(If("put_on", tuple(_put_on(common, holders)), rare=True))
    nodes += [Call(common["nearly"]), Call(common["gripped"]), Call(common["error_bounds"])]
    if "air_rates" in common:  # by the spin after the contact
        nodes.append(Call(common["air_rates"]))

    def decided(surface: LoopSurface, its: Mapping[str, str]) -> tuple[Node, ...]:
        settling = given_as(Call(surface.law["settling"]), its)
        return settling, Call(common["settled"], {"index": "which"})

    nodes += on_event(common, holders, "rolling_surface", "turning", "separation")
    nodes.append(Call(common["pressed_on"]))
    nodes += nearest_others(common, contacts, end_planes)
    nodes += on_law(common, holders, decided)
    yield If("slow", tuple(nodes), rare=True)


def _put_on(common: Parts, holders: Sequence[LoopSurface]) -> Iterator[Node]:
    """Put a ball onto the surface that it starts on."""
    yield from on_event(common, holders, "distance")
    yield Call(common["placed_at_start"])
    yield Call(common["start_errors"])
    yield from on_event(common, holders, "normal")
    yield Call(common["undecided_at_start"])
    yield Call(common["start_velocity_errors"])
    yield Call(common["velocity_at_start"])


def _free_time(
    common: Parts, contacts: Sequence[LoopSurface], end_planes: Sequence[LoopSurface]
) -> Iterator[Node]:
    """Bound the time for which a ball that leaves a surface certainly meets no other one."""
    yield Call(common["no_contact"])

    def flies_beside(surface: LoopSurface, index: Value) -> Iterator[Node]:
        yield Call(common["beside"], {"index": index})
        yield If("beside", tuple(_beside_in_flight(common, surface)))

    yield from for_runs(contacts, flies_beside)
    for end_plane in end_planes:
        yield part_call(end_plane, "beside")
        yield Call(common["end_plane_free_time"])


def _step(
    common: Parts,
    holders: Sequence[LoopSurface],
    contacts: Sequence[LoopSurface],
    end_planes: Sequence[LoopSurface],
) -> Iterator[Node]:
    """Take a step on any surface but a ring."""
    yield Call(common["error_bounds"])
    yield from on_held(common, holders, "normal", "rolling_surface")
    yield Call(common["roll_start"])
    yield from _series(common)
    yield Call(common["roll_step"])
    if "reaches_apex" in common:
        yield Call(common["reaches_apex"])
    yield from _friction_limit(common, tuple(_friction(common, holders)))
    yield Call(common["leaving_force"])
    edged = any(map(bounds_of, holders))
    if edged:
        yield Call(common["no_edge"])
        yield from _at_edges(common, holders)
        yield Call(common["near_edge"])
    tori = [own for own in holders if "width" in own.parts and not bounds_of(own)]

    def beside(surface: LoopSurface, index: Value) -> Iterator[Node]:
        if tori and bounds_of(surface) and "rolling_surface" in surface.parts:
            yield Call(common["beside_edgeless"], {"index": index})
            yield If("comes_over", tuple(_beside_ring(common, surface, index)))
        else:
            yield Call(common["beside"], {"index": index})
        yield If("beside", tuple(_beside(common, surface, index, edged)))

    yield from for_runs(contacts, beside)
    yield from _beside_end_planes(common, end_planes)
    yield from at_seams(common, holders, "beside_seam")
    yield Call(common["beside_time"])
    yield Call(common["neighbour_scale"])
    yield Call(common["neighbour"])
    if "passing" in common:
        yield Call(common["passing_from"])
    yield from _moved(common, holders, {})
    if "passing" in common:
        yield Call(common["passing_in_contact"])
    yield from _moved_neighbour(common, holders)
    yield Call(common["compared"])
    yield Call(common["rolled_on"])


def _friction_limit(common: Parts, friction: Sequence[Node]) -> Iterator[Node]:
    """Check whether rolling takes more friction than there is, and since when."""
    yield from friction
    yield Call(common["exceeds_grip"])
    yield If("loses", (Call(common["grip_lost_time"]),), rare=True)
    yield Call(common["remember_grip_deficit"])


def _friction(common: Parts, holders: Sequence[LoopSurface]) -> Iterator[Node]:
    """Evaluate the friction that rolling takes on a surface, and the law's limit."""
    yield Call(common["ring_friction"])
    yield from held_law(common, holders, "grip_deficit")


def _beside_ring(common: Parts, surface: LoopSurface, index: Value) -> Iterator[Node]:
    """Detect where a ball on a torus meets another surface, or is taken over by it at a bound."""
    if not bounds_of(surface) or "rolling_surface" not in surface.parts:
        yield from _beside(common, surface, index)
        return
    yield part_call(surface, "beside")
    yield Call(common["no_entry"])
    yield from outside(common, surface, "outside_bound", "entering_bound")
    yield Call(common["near_edge"])
    yield part_call(surface, "facing")
    yield Call(common["beside_entered_body"], {"index": index})


def _beside(
    common: Parts, surface: LoopSurface, index: Value, edged: bool = False
) -> Iterator[Node]:
    """Detect where the ball meets another surface; edged is true where it may reach an edge."""
    bounded = bool(bounds_of(surface))
    yield part_call(surface, "beside")
    yield from outside(common, surface, "outside_bound")
    if edged:
        yield If("near_edge", (part_call(surface, "facing"),), rare=True)
        yield from () if bounded else (Call(common["unbounded"]),)
    elif bounded:  # on a ring, which has no edge
        yield Call(common["near_edge"])
    event = "beside_body_at_edge" if edged else "beside_body"
    yield Call(common["beside_bounded_body" if bounded else event], {"index": index})


def _beside_in_flight(common: Parts, surface: LoopSurface) -> Iterator[Node]:
    yield part_call(surface, "beside")
    yield from outside(common, surface, "outside_bound_in_flight")
    bounded = bool(bounds_of(surface))
    yield Call(common["bounded_neighbour_free_time" if bounded else "neighbour_free_time"])


def _at_edges(common: Parts, holders: Sequence[LoopSurface]) -> Iterator[Node]:
    """Detect where the ball is past an edge of the surface that it is on."""

    def each(surface: LoopSurface) -> Iterator[Node]:
        for part in bounds_of(surface):
            yield part_call(surface, part)
            yield shifted_bound(surface, part)
            yield Call(common["reaches_edge"])

    yield from if_held(common, [surface for surface in holders if bounds_of(surface)], each)


def _past_edge(common: Parts, holders: Sequence[LoopSurface]) -> Iterator[Node]:
    """Find the surface that takes the ball over at an edge, and add the errors of that time."""
    yield Call(common["error_bounds"])

    def takes_over(surface: LoopSurface, index: Value) -> Iterator[Node]:
        takes = (
            part_call(surface, "beside"),
            part_call(surface, "facing"),
            *([] if bounds_of(surface) else [Call(common["unbounded"])]),
            *outside(common, surface, "outside_bound_in_flight"),
            Call(common["succeeds"], {"index": index}),
        )
        yield Call(common["beside"], {"index": index})
        yield If("beside", takes)

    yield from for_runs(holders, takes_over)
    yield Call(common["no_bounce"])
    yield from if_held(common, holders, lambda own: accelerated(common, own, "before"))
    after = "taking_over"
    yield from if_held(common, holders, lambda own: accelerated(common, own, "after"), after)
    yield Call(common["edge_errors"])


def _beside_end_planes(common: Parts, end_planes: Sequence[LoopSurface]) -> Iterator[Node]:
    for end_plane in end_planes:
        yield part_call(end_plane, "beside")
        yield Call(common["beside_end_plane"], {"index": end_plane.index})


def _ring_step(
    common: Parts,
    ring: LoopSurface,
    contacts: Sequence[LoopSurface],
    end_planes: Sequence[LoopSurface],
) -> Iterator[Node]:
    """Take a step on a ring, in its own coordinates."""
    others = [surface for surface in contacts if surface is not ring]
    around = [surface for surface in (*others, *end_planes) if "around" in surface.parts]
    bounded = len(around) == len(others) + len(end_planes)

    def series(names: Mapping[str, str]) -> Iterator[Node]:
        yield part_call(ring, "round_start", names)
        for k in range(ring_rolling_series.ORDER):
            yield part_call(ring, f"round_{k}", names)

    def clearance(half_step: str) -> Iterator[Node]:
        for surface in around:
            yield part_call(surface, "around")
            yield Call(common["clearance_at_any_azimuth"], {"half_step": half_step})

    yield Call(common["error_bounds"])
    yield part_call(ring, "rolling_surface")
    yield from series({})
    yield part_call(ring, "round_step")
    friction_excess = given_as(Call(ring.law["grip_deficit"]), ring.law_sizes)
    yield from _friction_limit(common, (part_call(ring, "round_pulled"), friction_excess))
    yield Call(common["leaving_force"])
    if any(map(bounds_of, others)):
        yield part_call(ring, "normal")
    yield from for_runs(others, lambda other, index: _beside_ring(common, other, index))
    yield from _beside_end_planes(common, end_planes)
    yield Call(common["beside_time"])
    yield Call(common["neighbour_scale"])
    yield Call(common["neighbour"])
    if "passing" in common:
        yield Call(common["passing_from"])
    if bounded:
        yield Call(common["isolated"], {}, {"nearest": "azimuth_clearance"})
        yield Call(common["half_steps"])
        yield from clearance("forth")
    yield given_as(part_call(ring, "round_moved"), {"t": "stride"})
    if "passing" in common:
        yield Call(common["passing_in_contact"])
    if bounded:
        yield from clearance("back")
        yield part_call(ring, "swung")
        yield Call(common["rolls_for_ever"])
    yield from series(_NEIGHBOUR)
    yield given_as(part_call(ring, "round_moved", _NEIGHBOUR), {"t": "stride"})
    yield Call(common["compared"])
    yield Call(common["rolled_on"], {}, {"rolling": "circling"})


def _series(common: Parts, names: Mapping[str, str] = MappingProxyType({})) -> Iterator[Node]:
    own = {name: names[name] for name in ("per_width",) if name in names}
    for k in range(rolling_series.ORDER):
        yield renamed(Call(common[f"roll_{k}"]), own)


def _moved(
    common: Parts, holders: Sequence[LoopSurface], names: Mapping[str, str]
) -> Iterator[Node]:
    """Move a ball along its series, and put it back onto the surface."""
    yield renamed(Call(common["roll_moved"], {"t": "stride"}), names)
    yield from _put_back(common, holders, names)


def _moved_neighbour(common: Parts, holders: Sequence[LoopSurface]) -> Iterator[Node]:
    """Move the neighbouring motion, which begins on the surface, too."""
    yield from on_held(common, holders, "normal", names=_NEIGHBOUR)
    yield renamed(Call(common["roll_turn_rate"]), _NEIGHBOUR)
    yield from _put_back(common, holders, _NEIGHBOUR)
    revolved = [surface for surface in holders if "width" in surface.parts]
    yield from on_held(common, revolved, "width", names=_NEIGHBOUR)
    yield renamed(Call(common["roll_start"]), _NEIGHBOUR)
    yield from _series(common, _NEIGHBOUR)
    yield from _moved(common, holders, _NEIGHBOUR)


def _put_back(
    common: Parts, holders: Sequence[LoopSurface], names: Mapping[str, str]
) -> Iterator[Node]:
    yield from on_held(common, holders, "normal", "distance", names=names)
    yield renamed(Call(common["roll_placed"]), names)
