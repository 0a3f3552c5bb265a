"""Surfaces of one kind: the loop has their kernels once, and a table of what differs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby

import sympy as sp

from ..events.grouping import Box, group_bodies
from ..events.predicates import last, which
from ..events.search import Parts, Search, given
from ..ir.event_tree import BoundingVolumes, Call, ForEach, If, Node, Value, given_as, read_of
from ..ir.kernel import Kernel, decision
from ..symbolic.conditionals import Boolean, Equal, Not, all_of, false
from ..symbolic.symbols import variable

FROM = {axis: f"from_{axis}" for axis in "xyz"}
"""Names of position and normal at the start of the flight to a contact."""
LEFT = {f"n{axis}": f"left_n{axis}" for axis in "xyz"}
"""Names of position and normal at the start of the flight to a contact."""

INDEX = "own_index"
"""Name of a surface's index in the body of a loop over surfaces of one kind."""

KERNELS = {
    kernel.name: kernel
    for kernel in (
        decision("other_kind", {"of_this_kind": false}, "Start value: no surface of this kind."),
        decision(
            "returned",
            {"again": all_of(Boolean("of_this_kind"), Equal(last, which))},
            "Whether the ball meets the same surface of a kind again.",
        ),
    )
}


def parameter_outputs(sizes: Sequence[sp.Symbol]) -> dict[str, sp.Basic]:
    """Return the outputs of the kernel that loads the parameters in which surfaces differ."""
    return {"of_this_kind": Not(false), **{f"its_{k}": size for k, size in enumerate(sizes)}}


@dataclass(frozen=True)
class LoopSurface:
    """A surface as the event loop sees it.

    Attributes
    ----------
    index, body
        Its own index, and that of the body it belongs to.
    parts, search, law
        Its kernels by part, the search for arrivals on it, and the kernels of its contact law:
        those of the first of its kind.
    sizes, law_sizes
        Its own variable for each variable of the first surface, and of the first law.
    box
        Its box at the default parameters.
    enclosed
        True if all of the body lies within the box of its contacts.
    """

    index: int
    body: int
    parts: Parts = field(repr=False)
    search: Search
    law: Parts = field(repr=False)
    sizes: Mapping[str, str] = field(default_factory=dict)
    law_sizes: Mapping[str, str] = field(default_factory=dict)
    box: Box = ()
    enclosed: bool = False


@dataclass(frozen=True)
class SurfaceKind:
    """Surfaces of one kind; there may be only one."""

    contacts: tuple[LoopSurface, ...]

    @property
    def first(self) -> LoopSurface:
        """The surface that the kernels are named after."""
        return self.contacts[0]

    @property
    def several(self) -> bool:
        """True if there is more than one surface of the kind."""
        return len(self.contacts) > 1

    @property
    def mine(self) -> str:
        """The variable that is true if the event is on a surface of the kind."""
        return f"of_this_kind_{self.first.index}"

    @property
    def _its(self) -> dict[str, str]:
        """The variable of each loaded parameter, by that of the first surface."""
        return parameter_variables(self.first.parts["taken"], str(self.first.index))

    def take_parameters(self, common: Parts) -> Iterator[Node]:
        """Load the parameters of the surface of the event, if the kind has more than one."""
        if not self.several:
            return
        yield from take_parameters(
            common, self.contacts, self.first.parts["taken"], self.mine, self._its
        )

    def evaluate(self, common: Parts, part: str, *more: Node) -> Iterator[Node]:
        """Evaluate a part, if the kind has it, if the event is on a surface of the kind.

        Parameters
        ----------
        common
            The kernels that all surfaces share, by part.
        part
            The name of the part, such as "normal".
        *more
            Nodes to execute after it, under the same condition.
        """
        kernel = self.first.parts.get(part)
        if kernel is None:
            return
        node = given(kernel, t="when")
        if self.several:
            yield If(self.mine, (given_as(node, self._its), *more))
        else:
            yield from on_surface(common, self.first.index, node, *more)

    def normal_change(self, common: Parts) -> Iterator[Node]:
        """Bound the rotation of the normal along a flight back to the surface where it began."""
        parts = self.first.parts
        turning = parts["curvature"]
        along = {"t": "when"} if "t" in map(variable, turning.arguments) else {}
        nodes = [Call(turning, along, {"curvature": "curving"})]
        if "started" in common:
            arguments = set(map(variable, parts["normal"].arguments))
            place = {axis: name for axis, name in FROM.items() if axis in arguments}
            nodes += [Call(common["started"], {"t": "when"}), Call(parts["normal"], place, LEFT)]
        if self.several:
            yield Call(common["returned"], {"of_this_kind": self.mine})
            nodes = [given_as(node, self._its) for node in nodes]
        else:
            yield Call(common["again"], {"index": self.first.index})
        yield If("again", tuple(nodes))


def parameter_variables(kernel: Kernel, suffix: str) -> dict[str, str]:
    """Return the variable of each parameter that a kernel loads, by that of the first surface.

    Parameters
    ----------
    kernel
        The kernel that loads the parameters of a surface.
    suffix
        The end of the variables' names, which tells kinds of surfaces apart.
    """
    names = [f"{name}_{suffix}" for name in kernel.output_names[1:]]
    return dict(zip(map(variable, kernel.arguments), names, strict=True))


def take_parameters(
    common: Parts, alike: Sequence[LoopSurface], kernel: Kernel, mine: str, its: Mapping[str, str]
) -> Iterator[Node]:
    """Load the parameters of the surface that the event is on, and whether it is any of these.

    Parameters
    ----------
    common
        The kernels that all surfaces share, by part.
    alike
        The surfaces of a kind.
    kernel
        The kernel that loads the parameters of one of them.
    mine
        The name of the variable that says whether the event is on any of them.
    its
        The variables that get the parameters, by those of the first surface.
    """
    outputs = {
        "of_this_kind": mine,
        **dict(zip(kernel.output_names[1:], its.values(), strict=True)),
    }
    yield Call(common["other_kind"], {}, {"of_this_kind": mine})
    yield Call(kernel, {}, outputs, frozenset(kernel.output_names[1:]))
    yield from for_each(
        alike, lambda _, index: on_surface(common, index, Call(kernel, {}, outputs), rare=True)
    )


def by_kind(contacts: Iterable[LoopSurface]) -> list[SurfaceKind]:
    """Return the surfaces by kind; a kind stands where its first surface does."""
    return [SurfaceKind(alike) for alike in _grouped(contacts, lambda surface: id(surface.search))]


def by_law(contacts: Iterable[LoopSurface]) -> list[tuple[LoopSurface, ...]]:
    """Return the surfaces by the kernels of their law."""
    return _grouped(contacts, lambda surface: surface.law["impact"].name)


def _grouped(
    contacts: Iterable[LoopSurface], key: Callable[[LoopSurface], object]
) -> list[tuple[LoopSurface, ...]]:
    found: dict[object, list[LoopSurface]] = {}
    for surface in contacts:
        found.setdefault(key(surface), []).append(surface)
    return [tuple(alike) for alike in found.values()]


def on_surface(common: Parts, index: Value, *body: Node, rare: bool = False) -> Iterator[Node]:
    """Execute nodes if the event is on the surface of an index.

    Parameters
    ----------
    common
        The kernels that all surfaces share, by part.
    index
        The index of the surface: a number, or the name of a variable.
    *body
        The nodes.
    rare
        True if few shots need them, so that they are worth collecting.
    """
    yield Call(common["here"], {"index": index})
    yield If("here", body, rare)


def for_each(
    alike: Sequence[LoopSurface],
    body: Callable[[LoopSurface, Value], Iterator[Node]],
    near: Mapping[str, str] | None = None,
) -> Iterator[Node]:
    """Execute nodes for each of some surfaces that share the kernels.

    Parameters
    ----------
    alike
        The surfaces.
    body
        Function of a surface, and of the name of its index, that returns the nodes, as for the
        first surface of the kind. The variables of the others are put into them here.
    near
        Inputs of the group test, if the nodes do not affect a shot that is far from the surface and
        the surfaces have kernels for that test.
    """
    if len(alike) == 1 and not (alike[0].sizes or alike[0].law_sizes):
        yield from body(alike[0], alike[0].index)
        return
    first = replace(alike[0], sizes={}, law_sizes={})
    if len(alike) == 1:
        names = {kernel.name: alike[0].sizes for kernel in first.parts.values()}
        names |= {kernel.name: alike[0].law_sizes for kernel in first.law.values()}
        yield from _called(body(first, first.index), names)
        return
    groups = None
    if near is not None and "box" in first.parts:
        order, members = group_bodies([surface.box for surface in alike])
        alike = [alike[k] for k in order]
        arguments = set(map(variable, first.parts["near_any"].arguments))
        inputs = {name: value for name, value in near.items() if name in arguments}
        groups = BoundingVolumes(
            Call(first.parts["box"]), Call(first.parts["near_any"], inputs), members
        )
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
    yield read_of(ForEach(tuple(table), tuple(zip(*table.values(), strict=True)), nodes, groups))


def for_runs(
    surfaces: Iterable[LoopSurface], body: Callable[[LoopSurface, Value], Iterator[Node]]
) -> Iterator[Node]:
    """Execute nodes for each surface, in order; adjacent ones of a kind share the nodes.

    Parameters
    ----------
    surfaces
        The surfaces.
    body
        As for `for_each`.
    """
    for _, alike in groupby(surfaces, lambda surface: id(surface.search)):
        yield from for_each(tuple(alike), body)


def on_law(
    common: Parts,
    surfaces: Iterable[LoopSurface],
    nodes: Callable[[LoopSurface, Mapping[str, str]], Sequence[Node]],
) -> Iterator[Node]:
    """Execute nodes with the kernels of the contact law of the surface that the event is on.

    Parameters
    ----------
    common
        The kernels that all surfaces share, by part.
    surfaces
        The surfaces that the event may be on.
    nodes
        Function of the first surface of a law, and of the variables of the law's parameters by
        those of that surface, that returns the nodes.
    """
    for alike in by_law(surfaces):
        law = alike[0].law
        if "taken" not in law:
            yield from for_each(alike, lambda s, index: on_surface(common, index, *nodes(s, {})))
            continue
        # Parameters that differ are loaded first: a contact then costs the same on every body.
        mine, its = (
            f"struck_{alike[0].index}",
            parameter_variables(law["taken"], law["impact"].name),
        )
        yield from take_parameters(common, alike, law["taken"], mine, its)
        yield If(mine, tuple(nodes(alike[0], its)))


def _table(
    sizes: Sequence[Mapping[str, str]], start: int
) -> tuple[dict[str, str], dict[str, list[Value]]]:
    """Return the names of the variables that differ, and their values for each surface."""
    differing = sorted({name for own in sizes for name in own})
    called = {name: f"own_{start + k}" for k, name in enumerate(differing)}
    return called, {own: [of.get(name, name) for of in sizes] for name, own in called.items()}


def _called(nodes: Iterable[Node], names: Mapping[str, Mapping[str, str]]) -> tuple[Node, ...]:
    """Return the tree with the variables that each kernel reads under other names."""
    return tuple(
        given_as(node, names.get(node.kernel.name, {}))
        if isinstance(node, Call)
        else replace(node, body=_called(node.body, names))
        for node in nodes
    )
