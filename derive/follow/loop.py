"""Table 1, the event loop: what happens to a shot from its release to its end.

Four stages. `permit` looks at the parameters and `admit` at a release, once each; then `reach`
finds the next event and takes the ball there, and `meet` gives it its motion after that, again and
again until the shot has an outcome. Between the stages a target does what is its own: it fills its
lanes, writes the log, and stores results.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass
from itertools import groupby

from ..ground.kernel import Kind as Type
from ..ground.tree import (
    Do,
    Each,
    Guard,
    Node,
    Value,
    check,
    given_as,
    live_before,
    needed,
    walk,
    without,
    writes,
)
from ..search.search import Parts, given, proposed
from . import staying
from .fields import CLAIMS, Field
from .kinds import Contact, Kind, each, of_laws, of_one_kind, on, take, taken_as

TEMPORARY_BOUNDS = {"late": 0.0, "delay": 0.0, "doubt": float("inf")}
"""What bounds errors within a stage, as it stands where no bounds are wanted."""


@dataclass(frozen=True)
class Loop:
    """The event loop of a scene.

    Attributes
    ----------
    fields
        What a shot has.
    job
        What is the same for all shots of a batch: numbers that the caller gives.
    stages
        The tree of each stage, by name, in order.
    """

    fields: tuple[Field, ...]
    job: tuple[str, ...]
    parameters: tuple[str, ...]
    stages: Mapping[str, tuple[Node, ...]]

    def __post_init__(self) -> None:
        known = {*self.job, *self.parameters, *(field.name for field in self.fields)}
        for nodes in self.stages.values():
            known = check(nodes, known)

    @property
    def tallied(self) -> bool:
        """Whether contacts are counted by body where they happen, and not in fields of a shot."""
        return all(field.name != "count_0" for field in self.fields)

    @property
    def kinds(self) -> dict[str, Type]:
        """What each field is."""
        written = writes(node for stage in self.stages.values() for node in stage)
        return {field.name: written.get(field.name, "double") for field in self.fields}

    @property
    def called(self) -> frozenset[str]:
        """The names of the kernels that it evaluates."""
        nodes = [node for stage in self.stages.values() for node in walk(stage)]
        groups = [each.groups for each in self.tables if each.groups is not None]
        asked = (evaluated for group in groups for evaluated in (group.box, group.near))
        return frozenset(node.kernel.name for node in (*nodes, *asked) if isinstance(node, Do))

    @property
    def tables(self) -> tuple[Each, ...]:
        """What is done for each row of a table."""
        nodes = (node for stage in self.stages.values() for node in walk(stage))
        return tuple(node for node in nodes if isinstance(node, Each))

    def plain(self) -> Loop:
        """Return the loop without all that only bounds errors: the same path."""
        fixed = {f.name: f.start for f in self.fields if f.bounds and f.start is not None}
        fixed |= TEMPORARY_BOUNDS | {"position_error": 0.0, "velocity_error": 0.0, "claims": 0.0}
        kept = tuple(field for field in self.fields if not field.bounds)
        wanted = {field.name for field in kept}
        stages: dict[str, tuple[Node, ...]] = {}
        for name, nodes in reversed(list(self.stages.items())):
            stages[name] = needed(without(nodes, fixed), wanted)
            wanted |= live_before(stages[name], wanted)
        stages = dict(reversed(stages.items()))
        return Loop(kept, tuple(j for j in self.job if j not in fixed), self.parameters, stages)


def event_loop(
    common: Parts,
    contacts: Sequence[Contact],
    gates: Sequence[Contact],
    fields: Sequence[Field],
    parameters: Sequence[str],
) -> Loop:
    """Return the loop of a scene.

    Parameters
    ----------
    common
        The kernels of the scene and the decisions.
    contacts, gates
        What can be touched, and the planes that end a shot, in the order of the indices.
    """
    return Loop(
        tuple(fields),
        ("most_contacts", "time_limit", "claims"),
        tuple(parameters),
        {
            "permit": (
                *(Do(common["allowed"]), Do(common["parameters_in_range"])),
                *([Do(common["measure"])] if "measure" in common else []),
            ),
            "admit": (
                *([Do(common["begun_with"])] if "begun_with" in common else []),
                *(Do(common["state_in_range"]), *_valid(common)),
                *(node for kind in of_one_kind(contacts) for node in _starting(kind)),
                Do(common["admitted"]),
                *([Do(common["passing_start"])] if "passing" in common else []),
            ),
            "reach": tuple(_reach(common, contacts, gates)),
            "meet": tuple(_meet(common, contacts, gates, {field.name for field in fields})),
        },
    )


def _valid(common: Parts) -> Iterator[Node]:
    """Look whether a ball starts inside a surface, if it is not aside of them all."""
    if "aside" not in common:
        yield Do(common["valid"])
        return
    yield Do(common["aside"])
    yield Guard("close", (Do(common["valid"]),))


def _starting(kind: Kind) -> Iterator[Node]:
    """Look whether a ball starts inside any surface of a kind."""
    if "start" not in kind.first.parts:
        return
    apart = {
        **{f"middle_{axis}": axis for axis in "xyz"},
        **{f"reach_{axis}": "leeway" for axis in "xyz"},
    }
    yield from each(
        kind.contacts,
        lambda s, index: iter([Do(s.parts["start"], {"index": index})]),
        apart if kind.first.enclosed else None,
    )


def _reach(common: Parts, contacts: Sequence[Contact], gates: Sequence[Contact]) -> Iterator[Node]:
    """Find the earliest arrival (Eq. 4) and take the ball there (Eq. 3)."""
    time = len(contacts) + len(gates)
    expiry = Guard("limited", (Do(common["expiry"]), *proposed(time)), rare=True)
    yield Do(common["error_bounds"])
    yield Do(common["scale"])
    yield Do(common["opening"])
    yield Do(common["limited"])
    if "kept" in common:
        yield Do(common["kept"])
    if not gates:
        yield expiry
    # End planes first: what certainly comes after them needs no further look.
    kinds = of_one_kind(sorted((*gates, *contacts), key=lambda s: not s.search.closed))
    for plates, alike in groupby(kinds, lambda kind: _plate(common, kind)):
        nodes = [node for kind in alike for node in _on_any(common, kind)]
        if plates:
            horizon = Do(common["horizon"], {"t": "when"}, {"horizon": "until"})
            asked = (horizon, given(common["reachable"], horizon="until"))
            yield Do(common["released"])
            yield Guard("released", asked, rare=True)
            yield Guard("reachable", tuple(nodes))
        else:
            yield from nodes
    if gates:
        yield expiry
    if "kept" in common:
        yield Guard("kept", tuple(staying.in_contact(common, contacts, gates)), rare=True)
    yield Do(common["departed"], {"index": len(contacts)})
    yield Do(common["body_of"])
    flown = (Do(common["flight"], {"t": "when"}), Do(common["ticked"]))
    yield Guard("moves", (*_passing(common), *flown))
    yield Guard("limited", (Do(common["expired"], {"index": time}),), rare=True)
    if "kept" in common:
        yield Do(common["unhopped"])
        yield Guard("kept", (Do(common["kept_on"]),), rare=True)
    yield Do(common["displacement"], {"horizon": "when", "delay": "late"}, {"margin": "slack"})
    for gate in gates:
        kernels = (gate.parts.get(part) for part in ("bounds", "reached", "edge"))
        yield from on(common, gate.index, *(Do(kernel) for kernel in kernels if kernel is not None))
    yield Do(common["doubted_in_contact" if "kept" in common else "doubted"])
    yield Do(common["accounted"])


def _plate(common: Parts, kind: Kind) -> bool:
    """Whether the flight's ends say if a surface is not reached; it is one of its kind."""
    return "reachable" in common and bool(kind.first.search.apart) and not kind.several


def _on_any(common: Parts, kind: Kind) -> Iterator[Node]:
    """Propose the first arrival on any surface of a kind."""
    if "near" in kind.first.parts:
        yield Do(common["horizon"], {"t": "when"}, {"horizon": "until"})
        yield Do(common["swept" if kind.several else "halved"], {"horizon": "until"})
    yield from each(kind.contacts, lambda s, index: _arriving(common, s, index), {})


def _passing(common: Parts) -> Iterator[Node]:
    """Look whether the flight goes through the scene's passage, if it has one."""
    if "passing" in common:
        yield Do(common["passing_doubt"], {"t": "when"})
        yield Do(common["undecided"])
        yield Do(common["passing"], {"t": "when"})


def _arriving(common: Parts, surface: Contact, index: Value) -> Iterator[Node]:
    """Propose the first arrival on a surface, if the flight comes near it."""
    nodes = surface.search.nodes(common, surface.parts, index)
    if "near" not in surface.parts:
        yield from nodes
        return
    yield Do(surface.parts["near"], {}, {"near": "reachable"})
    if "kept" in common:
        yield Do(common["reachable_in_flight"])
    yield Guard("reachable", tuple(nodes))


def _meet(
    common: Parts, contacts: Sequence[Contact], gates: Sequence[Contact], fields: Set[str]
) -> Iterator[Node]:
    """Give the ball its motion after the contact (Eqs. 7-17), and its errors theirs."""
    yield Do(common["meeting"])
    if "kept" in common:
        yield Do(common["unslowed"])
    yield Guard("meeting", tuple(_contact(common, contacts, gates, fields)))
    if "kept" in common:
        yield from staying.settled(common, contacts, gates)
    timed = Do(common["timed"], {"index": len(contacts) + len(gates)})
    carried = Guard("timed", (Do(common["carry_time"], {"t": "when"}),), rare=True)
    yield Guard("limited", (timed, carried), rare=True)
    if "kept" in common:
        yield Guard("hopped", (Do(common["carry_hop"]),), rare=True)
    yield Do(common["closing"])
    names = ("position_error", "velocity_error", "spin_error", "time_error")
    claims = dict(zip(names, CLAIMS, strict=True))
    yield Guard("closed", (Do(common["claimed_errors"], {}, claims),), rare=True)


def _contact(
    common: Parts, contacts: Sequence[Contact], gates: Sequence[Contact], fields: Set[str]
) -> Iterator[Node]:
    first, *others = (*gates, *contacts)
    kinds = of_one_kind(contacts)
    yield Do(first.parts["normal"])
    for gate in others[: max(0, len(gates) - 1)]:
        yield from on(common, gate.index, Do(gate.parts["normal"]))
    for kind in kinds:
        yield from kind.taken(common)
        if kind.several:
            yield from kind.on(common, "normal")
            for surface in kind.contacts:
                if counted := _counted(common, surface, fields):
                    yield from on(common, surface.index, *counted)
        else:
            yield from kind.on(common, "normal", *_counted(common, kind.first, fields))
    yield Do(common["elsewhere"])
    if "kept" in common:
        yield Do(common["anew"])
    for kind in kinds:
        yield from kind.bent(common)
    yield Do(common["carry_flight"], {"t": "when"}, {"delay": "belated"})
    yield Do(common["delayed"], {"delay": "belated"})
    if gates:
        yield Guard("ends", (Do(common["floored"]),))
    yield Do(common["unturned"])
    for kind in kinds:
        yield from kind.on(common, "carry_normal")
    yield from _laws(common, contacts)
    for kind in kinds:
        yield from kind.on(common, "place")
    slowed = (Do(common["slowed"]),) if "kept" in common else ()
    yield Guard("touches", (Do(common["touched"]), *slowed))


def _counted(common: Parts, surface: Contact, fields: Set[str]) -> list[Do]:
    """Count a contact with a body, if a shot has a field for that."""
    count = {"count": f"count_{surface.body}"}
    return [Do(common["counted"], count, count)] if count["count"] in fields else []


def _laws(common: Parts, contacts: Sequence[Contact]) -> Iterator[Node]:
    """Give ball and errors their motion after the contact, by the law of the body."""
    by_law = of_laws(contacts)
    if len(by_law) == 1 and not any(surface.law_sizes for surface in contacts):
        yield Guard("touches", tuple(_law(common, contacts[0])))
        return
    for surfaces in by_law:
        law = surfaces[0].law
        if "taken" not in law:
            yield from each(surfaces, lambda s, index: on(common, index, *_law(common, s)))
            continue
        # What differs is taken first: a contact then costs the same on whichever body it is.
        mine, its = f"struck_{surfaces[0].index}", taken_as(law["taken"], law["impact"].name)
        yield from take(common, surfaces, law["taken"], mine, its)
        yield Guard(mine, tuple(given_as(node, its) for node in _law(common, surfaces[0])))


def _law(common: Parts, surface: Contact) -> Iterator[Do]:
    if "doubt" in surface.law:
        yield Do(surface.law["doubt"])
        yield Do(common["undecided"])
    yield Do(surface.law["carry"])
    yield Do(surface.law["impact"])
