"""Bodies of one kind: the loop has them once, and a table of what is each one's own."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import sympy as sp

from ..ground.choice import Equal, Not, Nowhere, Truth, every
from ..ground.kernel import Kernel, decision
from ..ground.symbols import variable
from ..ground.tree import Do, Each, Groups, Guard, Node, Value, given_as, read_of
from ..search.decisions import last, which
from ..search.groups import Box, grouped
from ..search.search import Parts, Search

FROM = {axis: f"from_{axis}" for axis in "xyz"}
LEFT = {f"n{axis}": f"left_n{axis}" for axis in "xyz"}
"""What place and normal are called where the flight to a contact began."""

INDEX = "own_index"
"""What the index of a surface is called in what is done for each of its kind."""

KERNELS = {
    kernel.name: kernel
    for kernel in (
        decision("untaken", {"mine": Nowhere()}, "An event that is on no surface of a kind yet."),
        decision(
            "returned",
            {"again": every(Truth("mine"), Equal(last, which))},
            "Whether the ball meets the surface of a kind that it touched last.",
        ),
    )
}


def taken(sizes: Sequence[sp.Symbol]) -> dict[str, sp.Basic]:
    """Return the outputs of what takes the sizes that surfaces of a kind differ by."""
    return {"mine": Not(Nowhere()), **{f"its_{k}": size for k, size in enumerate(sizes)}}


@dataclass(frozen=True)
class Contact:
    """What the loop needs to know of a surface.

    Attributes
    ----------
    index, body
        Its own index, and that of the body it belongs to.
    parts, search, law
        Its kernels by part, how arrivals on it are found, and the kernels of its contact law: those
        of the first of its kind.
    sizes, law_sizes
        Its own variable for each of the first's that those of the surface, and of the law, take.
    box
        Where it usually is.
    enclosed
        Whether all of the body is within the box that its contacts are in.
    """

    index: int
    body: int
    parts: Parts
    search: Search
    law: Parts
    sizes: Mapping[str, str] = field(default_factory=dict)
    law_sizes: Mapping[str, str] = field(default_factory=dict)
    box: Box = ()
    enclosed: bool = False


@dataclass(frozen=True)
class Kind:
    """The surfaces of one kind, and what is done on them; there may be one alone."""

    contacts: tuple[Contact, ...]

    @property
    def first(self) -> Contact:
        """Of which the kernels are."""
        return self.contacts[0]

    @property
    def several(self) -> bool:
        """Whether there are more."""
        return len(self.contacts) > 1

    @property
    def mine(self) -> str:
        """The truth that the event is on one of them."""
        return f"mine_{self.first.index}"

    @property
    def _its(self) -> dict[str, str]:
        """The variable of each size that is taken, by that of the first's."""
        return taken_as(self.first.parts["taken"], str(self.first.index))

    def taken(self, common: Parts) -> Iterator[Node]:
        """Take the sizes of the surface that the event is on, if there is more than one."""
        if not self.several:
            return
        yield from take(common, self.contacts, self.first.parts["taken"], self.mine, self._its)

    def on(self, common: Parts, part: str, *more: Node) -> Iterator[Node]:
        """Evaluate a part, if the kind has it, where the event is on a surface of the kind."""
        kernel = self.first.parts.get(part)
        if kernel is None:
            return
        if self.several:
            yield Guard(self.mine, (given_as(Do(kernel), self._its), *more))
        else:
            yield from on(common, self.first.index, Do(kernel), *more)

    def bent(self, common: Parts) -> Iterator[Node]:
        """Bound how the normal turns on the way of a ball back to the surface that it left."""
        parts = self.first.parts
        asked = [Do(parts["curvature"], {}, {"curvature": "curving"})]
        if "started" in common:
            arguments = set(map(variable, parts["normal"].arguments))
            place = {axis: name for axis, name in FROM.items() if axis in arguments}
            asked += [Do(common["started"], {"t": "when"}), Do(parts["normal"], place, LEFT)]
        if self.several:
            yield Do(common["returned"], {"mine": self.mine})
            asked = [given_as(node, self._its) for node in asked]
        else:
            yield Do(common["again"], {"index": self.first.index})
        yield Guard("again", tuple(asked))


def taken_as(kernel: Kernel, suffix: str) -> dict[str, str]:
    """Return the variable of each size that a kernel takes, by that of the first's."""
    names = [f"{name}_{suffix}" for name in kernel.output_names[1:]]
    return dict(zip(map(variable, kernel.arguments), names, strict=True))


def take(
    common: Parts, alike: Sequence[Contact], kernel: Kernel, mine: str, its: Mapping[str, str]
) -> Iterator[Node]:
    """Take the sizes of whichever of some surfaces the event is on, and whether it is on any."""
    outputs = {"mine": mine, **dict(zip(kernel.output_names[1:], its.values(), strict=True))}
    yield Do(common["untaken"], {}, {"mine": mine})
    yield Do(kernel, {}, outputs, frozenset(kernel.output_names[1:]))
    yield from each(alike, lambda _, index: on(common, index, Do(kernel, {}, outputs), rare=True))


def of_one_kind(contacts: Iterable[Contact]) -> list[Kind]:
    """Return the surfaces by kind, a kind where its first one was."""
    return [Kind(alike) for alike in _grouped(contacts, lambda surface: id(surface.search))]


def of_laws(contacts: Iterable[Contact]) -> list[tuple[Contact, ...]]:
    """Return the surfaces by the kernels of their law."""
    return _grouped(contacts, lambda surface: surface.law["impact"].name)


def _grouped(
    contacts: Iterable[Contact], key: Callable[[Contact], object]
) -> list[tuple[Contact, ...]]:
    found: dict[object, list[Contact]] = {}
    for surface in contacts:
        found.setdefault(key(surface), []).append(surface)
    return [tuple(alike) for alike in found.values()]


def on(common: Parts, index: Value, *body: Node, rare: bool = False) -> Iterator[Node]:
    """Do something where the event is on the surface of an index."""
    yield Do(common["here"], {"index": index})
    yield Guard("here", body, rare)


def each(
    alike: Sequence[Contact],
    body: Callable[[Contact, Value], Iterator[Node]],
    near: Mapping[str, str] | None = None,
) -> Iterator[Node]:
    """Do something for each of some surfaces that share the kernels which it evaluates.

    Parameters
    ----------
    alike
        The surfaces.
    body
        From one of them, and what its index is called, to what is done.
    near
        What does nothing to a shot that is not near the surface asks with these inputs whether it
        is near a group of them, if they have kernels for that.
    """
    first = alike[0]
    if len(alike) == 1:
        yield from body(first, first.index)
        return
    groups = None
    if near is not None and "box" in first.parts:
        order, members = grouped([surface.box for surface in alike])
        alike = [alike[k] for k in order]
        names = set(map(variable, first.parts["near_any"].arguments))
        asked = {name: value for name, value in near.items() if name in names}
        groups = Groups(Do(first.parts["box"]), Do(first.parts["near_any"], asked), members)
    table: dict[str, list[Value]] = {INDEX: [float(surface.index) for surface in alike]}
    called: dict[str, dict[str, str]] = {}
    for kernels, sizes in (
        (first.parts, [surface.sizes for surface in alike]),
        (first.law, [surface.law_sizes for surface in alike]),
    ):
        own, columns = _table(sizes, len(table))
        called |= {kernel.name: own for kernel in kernels.values()}
        table |= columns
    nodes = _called(body(first, INDEX), called)
    if groups is not None:
        groups = replace(groups, box=given_as(groups.box, called[groups.box.kernel.name]))
    yield read_of(Each(tuple(table), tuple(zip(*table.values(), strict=True)), nodes, groups))


def _table(
    sizes: Sequence[Mapping[str, str]], start: int
) -> tuple[dict[str, str], dict[str, list[Value]]]:
    """Return what the variables that differ are called, and their values for each surface."""
    differing = sorted({name for own in sizes for name in own})
    called = {name: f"own_{start + k}" for k, name in enumerate(differing)}
    return called, {own: [of.get(name, name) for of in sizes] for name, own in called.items()}


def _called(nodes: Iterable[Node], names: Mapping[str, Mapping[str, str]]) -> tuple[Node, ...]:
    """Return the tree with the variables that kernels read under other names, by kernel."""
    return tuple(
        given_as(node, names.get(node.kernel.name, {}))
        if isinstance(node, Do)
        else replace(node, body=_called(node.body, names))
        for node in nodes
    )
