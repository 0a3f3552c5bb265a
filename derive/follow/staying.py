"""A ball that stays in contact: the nodes of the event loop from the last bounce to the leaving.

The turn after the last bounce puts the ball onto the surface. Then it rolls, step by step, until it
meets something, leaves, is at rest, or its time is up: all in one turn. One that leaves
tangentially flies for a moment in which it certainly meets nothing, and is in flight like any
other.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType

from ..flight import circling, rolling
from ..ground.symbols import STATE, normal
from ..ground.tree import Do, Guard, Node, Repeat, given_as
from ..search.search import Parts
from .kinds import Contact, on

LIMIT = 1 << 4
"""Steps of a ball in contact in one turn of the loop; it goes on in the next. What rolls longer
than most do waits for others that do, and so keeps lanes busy."""

_FAR = {s.name: f"far_{s.name}" for s in (*STATE, *normal)} | {"gap": "far_gap"}
"""What a neighbouring motion calls its own: what it shared, a motion without one would wait for."""


def in_contact(
    common: Parts, contacts: Sequence[Contact], gates: Sequence[Contact]
) -> Iterator[Node]:
    """Find the next event of balls in contact, and take them there."""
    holders = [surface for surface in contacts if "tube" in surface.parts]
    rings = [surface for surface in holders if "round_start" in surface.parts]
    others = [surface for surface in holders if surface not in rings]
    yield Do(common["resumed"])
    begun = (
        *_each(common, holders, "normal"),
        Do(common["roll_turn_rate"]),
        Do(common["gripped"]),
        *_each(common, holders, "off"),
        Do(
            common["roll_placed"],
            {f"v{axis}": f"rolled_{axis}" for axis in "xyz"},
        ),
        Do(common["begun_errors"]),
        Do(common["untaut"]),
        Do(common["beginning_contact"]),
    )
    yield Guard("begins", begun, rare=True)
    for ring in rings:
        yield Do(common["circles"], {"index": ring.index})
    yield Repeat("rolling", LIMIT, tuple(_step(common, others, contacts, gates)))
    for ring in rings:
        yield Repeat("circling", LIMIT, tuple(_round(common, ring, contacts, gates)))
        yield Do(common["rejoined"])
    parted = (
        Do(common["error_bounds"]),
        *_each(common, holders, "tube", "parting"),
        *_neighbours(common, contacts, gates),
        *_at_seams(common, holders, "spared_seam"),
        Do(common["parted"]),
        Do(common["hopping"]),
    )
    yield Guard("leaves", parted, rare=True)


def _each(common: Parts, surfaces: Sequence[Contact], *parts: str) -> Iterator[Node]:
    """Evaluate kernels of the surface that the ball stays on."""
    for surface in surfaces:
        yield Do(common["holding"], {"index": surface.index})
        yield Guard("here", tuple(_part(surface, part) for part in parts))


def _neighbours(
    common: Parts, contacts: Sequence[Contact], gates: Sequence[Contact]
) -> Iterator[Node]:
    """Return how long a ball that leaves a surface certainly meets no other one."""
    yield Do(common["unmet"])
    for surface in (*contacts, *gates):
        yield Do(common["beside"], {"index": surface.index})
        yield Guard("beside", (_part(surface, "beside"), Do(common["spared"])))


def _step(
    common: Parts,
    holders: Sequence[Contact],
    contacts: Sequence[Contact],
    gates: Sequence[Contact],
) -> Iterator[Node]:
    yield Do(common["error_bounds"])
    yield from _each(common, holders, "normal", "tube")
    yield Do(common["roll_start"])
    yield from _series(common)
    yield Do(common["roll_pace"])
    yield from _watched(common, tuple(_pulled(common, holders)))
    yield Do(common["leaving_force"])
    for surface in contacts:
        yield Do(common["beside"], {"index": surface.index})
        yield Guard("beside", tuple(_beside(common, surface)))
    yield from _beside_gates(common, gates)
    yield from _at_seams(common, holders, "beside_seam")
    yield Do(common["beside_time"])
    yield Do(common["apart"])
    yield Do(common["neighbour"])
    if "passing" in common:
        yield Do(common["passing_from"])
    yield from _moved(common, holders, {})
    if "passing" in common:
        yield Do(common["passing_in_contact"])
    yield from _moved_beside(common, holders)
    yield Do(common["compared"])
    yield Do(common["rolled_on"])


def _at_seams(common: Parts, holders: Sequence[Contact], asked: str) -> Iterator[Node]:
    """Ask something of each seam of the surface that the ball is on."""
    for surface in holders:
        seams = [part for part in surface.parts if part.startswith("seam")]
        if seams:
            each = (n for s in seams for n in (_part(surface, s), Do(common[asked])))
            yield Do(common["holding"], {"index": surface.index})
            yield Guard("here", tuple(each))


def _watched(common: Parts, asked: Sequence[Node]) -> Iterator[Node]:
    """Look whether friction is enough for what is asked of it, and when it first was not."""
    yield from asked
    yield Do(common["losing"])
    yield Guard("loses", (Do(common["lost_grip"]),), rare=True)
    yield Do(common["tightened"])


def _pulled(common: Parts, holders: Sequence[Contact]) -> Iterator[Node]:
    """Take what friction is asked for on a surface, beside what it can do."""
    yield Do(common["pulled"])
    for surface in holders:
        yield Do(common["holding"], {"index": surface.index})
        yield Guard("here", (given_as(Do(surface.law["strained"]), surface.law_sizes),))


def _beside(common: Parts, surface: Contact) -> Iterator[Node]:
    yield _part(surface, "beside")
    yield Do(common["beside_body"], {"index": surface.index})


def _beside_gates(common: Parts, gates: Sequence[Contact]) -> Iterator[Node]:
    for gate in gates:
        yield _part(gate, "beside")
        yield Do(common["beside_gate"], {"index": gate.index})


def _round(
    common: Parts, ring: Contact, contacts: Sequence[Contact], gates: Sequence[Contact]
) -> Iterator[Node]:
    """Take a step on a ring, in its own coordinates."""
    others = [surface for surface in contacts if surface is not ring]
    around = [surface for surface in (*others, *gates) if "around" in surface.parts]
    bounded = len(around) == len(others) + len(gates)

    def series(names: Mapping[str, str]) -> Iterator[Node]:
        yield _part(ring, "round_start", names)
        for k in range(circling.ORDER):
            yield _part(ring, f"round_{k}", names)

    def berth(leap: str) -> Iterator[Node]:
        for surface in around:
            yield _part(surface, "around")
            yield Do(common["cleared"], {"leap": leap})

    yield Do(common["error_bounds"])
    yield _part(ring, "tube")
    yield from series({})
    yield _part(ring, "round_pace")
    strained = given_as(Do(ring.law["strained"]), ring.law_sizes)
    yield from _watched(common, (_part(ring, "round_pulled"), strained))
    yield Do(common["leaving_force"])
    for surface in others:
        yield from _beside(common, surface)
    yield from _beside_gates(common, gates)
    yield Do(common["beside_time"])
    yield Do(common["apart"])
    yield Do(common["neighbour"])
    if "passing" in common:
        yield Do(common["passing_from"])
    if bounded:
        yield Do(common["alone"], {}, {"nearest": "berth"})
        yield Do(common["leaps"])
        yield from berth("forth")
    yield given_as(_part(ring, "round_moved"), {"t": "stride"})
    if "passing" in common:
        yield Do(common["passing_in_contact"])
    if bounded:
        yield from berth("back")
        yield _part(ring, "swung")
        yield Do(common["for_ever"])
    yield from series(_FAR)
    yield given_as(_part(ring, "round_moved", _FAR), {"t": "stride"})
    yield Do(common["compared"])
    yield Do(common["rolled_on"], {}, {"rolling": "circling"})


def _series(common: Parts) -> Iterator[Node]:
    for k in range(rolling.ORDER):
        yield Do(common[f"roll_{k}"])


def _moved(common: Parts, holders: Sequence[Contact], names: Mapping[str, str]) -> Iterator[Node]:
    """Take a ball along its series, and put it back onto the surface."""
    yield _on(Do(common["roll_moved"], {"t": "stride"}), names)
    yield from _put(common, holders, names)


def _moved_beside(common: Parts, holders: Sequence[Contact]) -> Iterator[Node]:
    """Do the same with the neighbouring motion, which begins on the surface, too."""
    for surface in holders:
        yield Do(common["holding"], {"index": surface.index})
        yield Guard("here", (_part(surface, "normal", _FAR),))
    yield _on(Do(common["roll_turn_rate"]), _FAR)
    yield from _put(common, holders, _FAR)
    yield _on(Do(common["roll_start"]), _FAR)
    yield from _series(common)
    yield from _moved(common, holders, _FAR)


def _put(common: Parts, holders: Sequence[Contact], names: Mapping[str, str]) -> Iterator[Node]:
    for surface in holders:
        yield Do(common["holding"], {"index": surface.index})
        parts = (_part(surface, part, names) for part in ("normal", "off"))
        yield Guard("here", tuple(parts))
    yield _on(Do(common["roll_placed"]), names)


def _part(surface: Contact, part: str, names: Mapping[str, str] = MappingProxyType({})) -> Do:
    """Return the evaluation of a kernel of a surface, for a motion whose state has such names."""
    return given_as(_on(Do(surface.parts[part]), names), surface.sizes)


def _gap(surface: Contact) -> Node:
    return given_as(Do(surface.parts["beside"], wanted=frozenset({"gap"})), surface.sizes)


def _on(node: Do, names: Mapping[str, str]) -> Do:
    """Return the evaluation for a motion whose state has other names."""
    arguments = {str(symbol) for symbol in node.kernel.arguments}
    inputs = {name: own for name, own in names.items() if name in arguments}
    outputs = {name: own for name, own in names.items() if name in node.kernel.output_names}
    return Do(node.kernel, {**inputs, **node.inputs}, outputs)


def settled(common: Parts, contacts: Sequence[Contact], gates: Sequence[Contact]) -> Iterator[Node]:
    """Look whether a ball that has bounced, and hardly leaves the surface, stays on it."""
    holders = [surface for surface in contacts if "tube" in surface.parts]
    if not holders:
        return
    looked: list[Node] = [_part(holders[0], "normal")]
    for surface in holders[1:]:
        looked += on(common, surface.index, _part(surface, "normal"))
    looked += [Do(common["nearly"]), Do(common["gripped"])]
    for surface in holders:
        own = (
            _part(surface, "turning"),
            Do(common["pressed_on"]),
            *_apart(common, contacts, gates, surface.index),
            given_as(Do(surface.parts["parting"], wanted=frozenset({"lift"})), surface.sizes),
            given_as(Do(surface.law["settling"]), surface.law_sizes),
            Do(common["settled"], {"index": surface.index}),
        )
        looked += on(common, surface.index, *own)
    yield Guard("slow", tuple(looked), rare=True)


def _apart(
    common: Parts, contacts: Sequence[Contact], gates: Sequence[Contact], index: int
) -> Iterator[Node]:
    yield Do(common["alone"])
    for surface in contacts:
        if surface.index != index:
            yield _part(surface, "closing")
            yield Do(common["neared_body"])
    for gate in gates:
        yield _gap(gate)
        yield Do(common["neared"])
