"""The event loop (Table 1): the stages of a shot from its release to its end.

There are four stages, and a fifth where bounds on errors are proved. `validate` validates the
parameters and `start` a release, once each. Then `detect` detects the next event and moves the ball
there, and `resolve` resolves the event, again and again until the shot has an outcome. Between the
stages a target does its own work: it fills its lanes, writes the log, and stores results.

The fifth is `review`: it finds the shots that have ended uncertain, and that may be certain with
bounds that cost more. A target simulates these again with `tightening` 1, and takes the results
that need bounds from this second pass. The path is the same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from dataclasses import replace
from itertools import groupby

from ..errors import provisional
from ..events.predicates import KERNELS
from ..events.search import Parts, given, proposed
from ..ir.event_tree import Call, If, Node, Value, given_as
from ..ir.kernel import Kernel
from ..motion.air_series import PIECE_KERNELS
from ..rolling import stages as contact_stages
from ..rolling.symbols import EventCodes
from ..scenes import passage_in_air
from ..state.fields import REPORTED_ERRORS, Field
from ..state.shared_kernels import (
    LoopSurface,
    SurfaceKind,
    by_kind,
    by_law,
    for_each,
    on_law,
    on_surface,
)
from ..symbolic.symbols import variable
from .loop import REVIEW, TIGHTENING, Loop
from .predicates import GOES_ON


def event_loop(
    common: Parts,
    contacts: Sequence[LoopSurface],
    end_planes: Sequence[LoopSurface],
    fields: Sequence[Field],
    parameters: Sequence[str],
    open_ended: bool,
) -> Loop:
    """Return the event loop of a scene.

    Parameters
    ----------
    common
        The kernels of the scene, and the decisions.
    contacts, end_planes
        The surfaces, and the planes that end a shot, in the order of the indices.
    fields
        The fields of a shot.
    parameters
        The variables of the scene's parameters.
    open_ended
        True if the time limit ends every shot, also one that meets nothing any more.
    """
    proved = "carry_end" in common
    return Loop(
        tuple(fields),
        ("most_contacts", "time_limit", "claims", *([TIGHTENING] if proved else [])),
        tuple(parameters),
        {
            "validate": (
                *(Call(common["allowed"]), Call(common["parameters_in_range"])),
                *([Call(common["measure"])] if "measure" in common else []),
            ),
            "start": (
                *([Call(common["begun_with"])] if "begun_with" in common else []),
                Call(common["state_in_range"]),
                *_left_surface(common),
                *_valid(common),
                *(node for kind in by_kind(contacts) for node in _starting(kind)),
                Call(common["admitted"]),
                *([Call(common["started_on_surface"])] if "in_contact" in common else []),
                *([Call(common["passing_start"])] if "passing" in common else []),
            ),
            "detect": tuple(_detect(common, contacts, end_planes, open_ended)),
            "resolve": tuple(
                _resolve(common, contacts, end_planes, {field.name for field in fields})
            ),
            **({REVIEW: (Call(common["loose"]),)} if proved else {}),
        },
    )


def _left_surface(common: Parts) -> Iterator[Node]:
    """Find the surface that the ball leaves, where a body has several."""
    if "left_surface" in common:
        yield Call(common["starts_on_body"])
        yield If("on_body", (Call(common["left_surface"]),), rare=True)


def _valid(common: Parts) -> Iterator[Node]:
    """Test whether the ball starts inside a surface, unless it is clearly away from all of them."""
    if "aside" not in common:
        yield Call(common["valid"])
        return
    yield Call(common["aside"])
    yield If("close", (Call(common["valid"]),))


def _starting(kind: SurfaceKind) -> Iterator[Node]:
    """Test whether the ball starts inside any surface of a kind."""
    if "start" not in kind.first.parts:
        return
    apart = {
        **{f"middle_{axis}": axis for axis in "xyz"},
        **{f"reach_{axis}": "leeway" for axis in "xyz"},
    }
    yield from for_each(
        kind.contacts,
        lambda s, index: iter([Call(s.parts["start"], {"index": index})]),
        apart if kind.first.enclosed else None,
    )


def _search_order(
    end_planes: Sequence[LoopSurface],
) -> Callable[[LoopSurface], tuple[bool, bool]]:
    """Return the key by which surfaces are searched in order.

    Along gravity a ball may hardly move. Whether it comes to such a plane before its next event is
    decided only if an arrival elsewhere is known. So such ends come after the others. If none of
    these always has an arrival, the planes of bodies come before them, too.

    Parameters
    ----------
    end_planes
        The planes that end a shot.
    """
    falls = (plane.search for plane in end_planes if plane.search.closed)
    ends = any(not search.level and not search.surface.bounds for search in falls)
    return lambda s: (not s.search.closed, not ends and s.search.level)


def _detect(
    common: Parts,
    contacts: Sequence[LoopSurface],
    end_planes: Sequence[LoopSurface],
    open_ended: bool,
) -> Iterator[Node]:
    """Detect the earliest arrival (Eq. 4) and move the ball there (Eq. 3)."""
    time = len(contacts) + len(end_planes)
    piece_end = _piece_end(common, contacts, end_planes)
    expiry = If("limited", (Call(common["expiry"]), *proposed(time)), rare=True)
    yield Call(common["error_bounds"])
    yield Call(common["scale"])
    yield from (Call(common[name]) for name in PIECE_KERNELS if name in common)
    yield Call(common["opening"])
    if "piece_end" in common:
        yield Call(common["piece_end"])
        yield from proposed(piece_end)
    yield Call(common["limited"])
    if "in_contact" in common:
        yield Call(common["in_contact"])
    if open_ended:
        yield expiry
    # End planes come first: an arrival that is certainly later needs no search.
    ends = sorted(end_planes, key=lambda end: end.search.level)
    kinds = by_kind(sorted((*ends, *contacts), key=_search_order(end_planes)))
    *_, last_closed = (None, *(kind for kind in kinds if kind.first.search.closed))
    for plates, alike in groupby(kinds, lambda kind: _plate(common, kind)):
        nodes: list[Node] = []
        for kind in alike:
            nodes += _on_any(common, kind)
            if "plane_start" in common and kind is last_closed:
                nodes.append(Call(common["plane_start"]))
        if plates:
            horizon = Call(common["horizon"], {"t": "when"}, {"horizon": "until"})
            asked = (horizon, given(common["reachable"], horizon="until"))
            yield Call(common["released"])
            yield If("released", asked, rare=True)
            yield If("reachable", tuple(nodes))
        else:
            yield from nodes
    if not open_ended:
        yield expiry
    if "in_contact" in common:
        yield If(
            "in_contact", tuple(contact_stages.in_contact(common, contacts, end_planes)), rare=True
        )
    if "piece_end" in common:
        yield Call(common["sinks"], {"index": piece_end})
        if sinks := tuple(_sinks_at_limit(common, time)):
            yield from on_surface(common, time, *sinks, rare=True)
    yield Call(common["departed"], {"index": len(contacts)})
    yield Call(common["body_of"])
    if "piece_end" in common:
        yield Call(common[GOES_ON], {"index": piece_end})
    if "in_contact" in common:
        # In air the series of rolling stands in the variables of the flight's.
        put = [Call(common["stays_put"])] if "piece_end" in common else []
        yield If("in_contact", (Call(common["nothing_happens_yet"]), *put), rare=True)
    flown = (Call(common["flight"], {"t": "when"}), Call(common["event_clock"]))
    yield If("moves", (*_passing(common), *flown))
    yield If("limited", (Call(common["expired"], {"index": time}),), rare=True)
    if "in_contact" in common:
        yield Call(common["no_departure"])
        rests: tuple[Node, ...] = ()
        if any(surface.search.remembered for surface in contacts):
            yield Call(common["no_rest"])
            rests = (Call(common["rest"]),)
        yield If("in_contact", (*rests, Call(common["stay_in_contact"])), rare=True)
    yield Call(
        common["displacement"], {"horizon": "when", "delay": "earliest_delay"}, {"margin": "slack"}
    )
    for end_plane in end_planes:
        kernels = (end_plane.parts.get(part) for part in ("bounds", "reached", "edge"))
        yield from on_surface(
            common, end_plane.index, *(Call(kernel) for kernel in kernels if kernel is not None)
        )
    yield Call(common["contact_undecided" if "in_contact" in common else "flight_undecided"])
    yield Call(common["accounted"])


def _piece_end(
    common: Parts, contacts: Sequence[LoopSurface], end_planes: Sequence[LoopSurface]
) -> int:
    """Return the index of the end of a piece, after those of all other events."""
    surfaces = len(contacts) + len(end_planes)
    return EventCodes(surfaces, 0).piece_end if "in_contact" in common else surfaces + 1


def _sinks_at_limit(common: Parts, time: int) -> Iterator[Node]:
    """Test whether a ball that reaches the time limit can meet anything, at the place where it is.

    At the beginning of its piece that was not known. Where pieces begin is no property of the shot.
    """
    asked = common["piece_end"]
    arguments = set(map(variable, asked.arguments))
    names = (*"xyz", "vx", "vy", "vz", "extent", "speed")
    then = {name: f"then_{name}" for name in names}
    inputs = {n: v for n, v in then.items() if n in arguments}
    if not inputs:
        return
    for kernel, given_at in (
        (common["flight"], {"t": "when"}),
        (common["scale"], {n: then[n] for n in names[:6]}),
    ):
        outputs = {n: then[n] for n in kernel.output_names if n in then}
        known = set(map(variable, kernel.arguments))
        moved = {n: v for n, v in given_at.items() if n in known}
        yield Call(kernel, moved, outputs, frozenset(outputs))
    yield Call(asked, inputs, {"sunk": "sunk_then"}, frozenset({"sunk"}))
    yield Call(common["sinks"], {"index": time, "sunk": "sunk_then"})


def _plate(common: Parts, kind: SurfaceKind) -> bool:
    """Return True if the ends of a flight can show that it does not come to the only surface."""
    return "reachable" in common and bool(kind.first.search.apart) and not kind.several


def _on_any(common: Parts, kind: SurfaceKind) -> Iterator[Node]:
    """Propose the first arrival on any surface of a kind."""
    if "near" in kind.first.parts:
        yield Call(common["horizon"], {"t": "when"}, {"horizon": "until"})
        boxes = common["swept" if kind.several else "half_flight_boxes"]
        if set(boxes.output_names) & set(map(str, kind.first.parts["near"].arguments)):
            yield Call(boxes, {"horizon": "until"})
    yield from for_each(kind.contacts, lambda s, index: _arriving(common, s, index), {})


def _passing(common: Parts) -> Iterator[Node]:
    """Test whether the flight goes through the scene's passage, if it has one."""
    if "passing" not in common:
        return
    nodes = (
        given(common["passing_undecided"], t="when"),
        Call(common["undecided"]),
        given(common["passing"], t="when"),
    )
    if "passing_near" not in common:
        yield from nodes
        return
    yield Call(common["passing_near"], {"t": "when"})
    found = (given(common[name], t="when") for name in passage_in_air.KERNELS)
    yield If("near_disc", (*found, *nodes))


def _arriving(common: Parts, surface: LoopSurface, index: Value) -> Iterator[Node]:
    """Propose the first arrival on a surface, if the flight comes near it."""
    nodes = surface.search.nodes(common, surface.parts, index)
    if "near" not in surface.parts:
        yield from nodes
        return
    yield replace(given(surface.parts["near"], horizon="until"), outputs={"near": "reachable"})
    if "approaches" in surface.parts:
        left = Call(KERNELS["left"], {"index": index})
        test = given(surface.parts["approaches"], horizon="until")
        yield If("reachable", (left, replace(test, outputs={"near": "reachable"})))
    if "in_contact" in common:
        yield Call(common["reachable_in_flight"])
    yield If("reachable", tuple(nodes))


def _resolve(
    common: Parts,
    contacts: Sequence[LoopSurface],
    end_planes: Sequence[LoopSurface],
    fields: Set[str],
) -> Iterator[Node]:
    """Give the ball its motion after the contact (Eqs. 7-17), and propagate its errors."""
    if "piece_end" in common:
        yield If(GOES_ON, (Call(common["carry_piece"], {"t": "when"}), Call(common["aloft"])))
    yield Call(common["meeting"])
    if "in_contact" in common:
        yield Call(common["slow_at_start"])
    yield If("meeting", tuple(_contact(common, contacts, end_planes, fields)))
    if "in_contact" in common:
        yield from contact_stages.settled(common, contacts, end_planes)
    timed = Call(common["ends_by_time_limit"], {"index": len(contacts) + len(end_planes)})
    times = [common[name] for name in ("carry_time", "bound_time") if name in common]
    expired = tuple(Call(kernel, {"t": "when"}) for kernel in times)
    carried = If("ends_by_time_limit", expired, rare=True)
    yield If("limited", (timed, carried), rare=True)
    if "in_contact" in common:
        hop = "carry_piece" if "carry_piece" in common else "carry_hop"
        yield If("hopped", (given(common[hop], t="when"),), rare=True)
    yield Call(common["closing"])
    names = ("position_error", "velocity_error", "spin_error", "time_error")
    claims = dict(zip(names, REPORTED_ERRORS, strict=True))
    yield If("reports", (Call(common["claimed_errors"], {}, claims),), rare=True)


def _contact(
    common: Parts,
    contacts: Sequence[LoopSurface],
    end_planes: Sequence[LoopSurface],
    fields: Set[str],
) -> Iterator[Node]:
    """Evaluate normal, errors and impact at a contact, or at an end."""
    first, *others = (*end_planes, *contacts)
    kinds = by_kind(contacts)
    yield Call(first.parts["normal"])
    for end_plane in others[: max(0, len(end_planes) - 1)]:
        yield from on_surface(common, end_plane.index, Call(end_plane.parts["normal"]))
    for kind in kinds:
        yield from kind.take_parameters(common)
        if kind.several:
            yield from kind.evaluate(common, "normal")
            for surface in kind.contacts:
                if counted := _counted(common, surface, fields):
                    yield from on_surface(common, surface.index, *counted)
        else:
            yield from kind.evaluate(common, "normal", *_counted(common, kind.first, fields))
    if "carry_end" in common:
        yield from _proved_errors(common, contacts, end_planes)
        return
    yield Call(common["elsewhere"])
    if "in_contact" in common:
        yield Call(common["other_start_surface"])
    for kind in kinds:
        yield from kind.normal_change(common)
    yield Call(common["carry_flight"], {"t": "when"}, {"delay": "belated"})
    yield Call(common["clock_error_sum"], {"delay": "belated"})
    if end_planes:
        yield If("ends", (Call(common["error_floor"]),))
    yield Call(common["no_normal_error"])
    if "bound_end" in common:
        yield from _bounds_until_rolling(common, contacts, end_planes)
    for kind in kinds:
        if "carry_root" in kind.first.parts:
            carried = Call(kind.first.parts["carry_root"])
            yield from kind.evaluate(common, "root_delay", carried)
        yield from kind.evaluate(common, "carry_normal")
    yield from _laws(common, contacts)
    if "bound_end" in common:
        yield If("touches", (Call(common["estimated_after_contact"]),), usual=True)
    for kind in kinds:
        yield from kind.evaluate(common, "place")
    slowed = (Call(common["leaves_slowly"]),) if "in_contact" in common else ()
    yield If("touches", (Call(common["touched"]), *slowed))


def _frames(
    common: Parts, contacts: Sequence[LoopSurface], end_planes: Sequence[LoopSurface]
) -> Iterator[Node]:
    """Evaluate the frame of a contact, or of an end."""
    yield Call(common["normal_velocity"])
    yield Call(common["came_back"])
    first, *others = (*end_planes, *contacts)
    yield given(first.parts["tangents"], t="when")
    for end_plane in others[: max(0, len(end_planes) - 1)]:
        frame = given(end_plane.parts["tangents"], t="when")
        yield from on_surface(common, end_plane.index, frame)
    for kind in by_kind(contacts):
        yield from kind.evaluate(common, "tangents")


def _bounds_until_rolling(
    common: Parts, contacts: Sequence[LoopSurface], end_planes: Sequence[LoopSurface]
) -> Iterator[Node]:
    """Carry proved bounds to a contact or an end, unless the shot's bounds are estimated."""
    yield from _frames(common, contacts, end_planes)
    yield Call(common["proves"])
    if end_planes:
        yield If("proves_end", tuple(_bounded(common, common["bound_end"])))


def _bounded(common: Parts, bound: Kernel) -> Iterator[Call]:
    """Carry proved bounds over a flight, and count its delay."""
    frame = provisional.LEFT_NORMAL if "left_nx" in bound.output_names else {}
    yield Call(bound, {"t": "when", **frame}, {"delay": "proved_delay", **frame})
    yield Call(common["clock_bound_sum"], {"delay": "proved_delay"})


def _proved_errors(
    common: Parts, contacts: Sequence[LoopSurface], end_planes: Sequence[LoopSurface]
) -> Iterator[Node]:
    """Apply the law to the motion and its proved bounds, or bound the errors at an end."""
    kinds = by_kind(contacts)
    yield from _frames(common, contacts, end_planes)
    if end_planes:
        yield If("ends", tuple(_timed(common, common["carry_end"])))
    yield Call(common["tightens"])
    yield from _laws(common, contacts)
    for kind in kinds:
        yield from kind.evaluate(common, "place")
    # Bounds at an end are computed only where they are wanted, and so flag nothing.
    flagged = (Call(common["unbounded"]), Call(common["without_bounds"]))
    yield If("touches", (*flagged, Call(common["touched"])))


def _law_bounds(common: Parts, surface: LoopSurface, its: Mapping[str, str]) -> Iterator[Node]:
    """Carry proved bounds over a contact with a surface that has parameters of its own."""
    law = surface.law
    slip = [Call(law["slip"])] if "slip" in law else []

    def carried(part: str) -> tuple[Call, ...]:
        over = _bounded if part == "bound" else _timed
        return tuple(given_as(call, its) for call in (*slip, *over(common, law[part])))

    if "bound" in law:
        yield If("proves_contact", carried("bound"), usual=True)
    if "tighten" in law:
        yield If("carries", carried("carry"), usual=True)
        yield If("tightens", carried("tighten"), rare=True)


def _timed(common: Parts, carry: Kernel) -> Iterator[Call]:
    """Carry bounds on errors over a flight, and count its delay."""
    yield Call(carry, {"t": "when"}, {"delay": "belated"})
    yield Call(common["clock_error_sum"], {"delay": "belated"})


def _counted(common: Parts, surface: LoopSurface, fields: Set[str]) -> list[Call]:
    """Return the node that counts a contact with a body, if a shot has a field for it."""
    count = {"count": f"count_{surface.body}"}
    return [Call(common["counted"], count, count)] if count["count"] in fields else []


def _laws(common: Parts, contacts: Sequence[LoopSurface]) -> Iterator[Node]:
    """Apply the law of the body to the motion and its errors."""
    if _is_one_law(contacts):
        yield from _law_bounds(common, contacts[0], {})
        yield If("touches", tuple(_law(common, contacts[0])), usual=True)
        return

    def nodes(surface: LoopSurface, its: Mapping[str, str]) -> tuple[Node, ...]:
        carried = _law_bounds(common, surface, its)
        return (*carried, *(given_as(node, its) for node in _law(common, surface)))

    yield from on_law(common, contacts, nodes)


def _is_one_law(contacts: Sequence[LoopSurface]) -> bool:
    """Return whether all bodies have the same law with the same parameters."""
    return len(by_law(contacts)) == 1 and not any(surface.law_sizes for surface in contacts)


def _law(common: Parts, surface: LoopSurface) -> Iterator[Call]:
    if "undecided" in surface.law:
        yield Call(surface.law["undecided"])
        yield Call(common["undecided"])
    if "carry_end" not in common:
        yield Call(surface.law["carry"])
    yield Call(surface.law["impact"])
