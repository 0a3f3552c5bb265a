"""The event loop as a tree of four kinds of node, which every target prints in its own way.

A tree describes *one* shot. A `Call` evaluates a kernel and assigns its outputs to variables;
an `If` executes its body if a condition holds; a `While` as long as one holds; a `ForEach` once
for every row of a table. A target that processes many shots at once leaves the others unchanged: by
selection, by compaction, or by a branch. Codegen lowers these nodes to the `Call`, `If` and
`While` of its own `statements`, which a target prints as they stand.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, field, replace
from functools import cached_property

from ..symbolic.symbols import variable
from .kernel import Kernel, Kind

Value = str | float
"""An input of a kernel: a variable, or a number."""


UNPROVED = "unproved"
"""The variable that is true where the shortcut of an evaluation does not suffice."""


@dataclass(frozen=True)
class Call:
    """The evaluation of a kernel.

    Attributes
    ----------
    kernel
        The kernel.
    inputs
        The arguments that are not the variables of their own names.
    outputs
        The variables that outputs are assigned to, where those have other names.
    wanted
        The outputs that are assigned; None: all. The others are not used.
    shortcut
        Cheaper evaluations that assign the same variables, and `UNPROVED`. A target may put them
        before this one, which is then for the shots for which `UNPROVED` is true.
    """

    kernel: Kernel
    inputs: Mapping[str, Value] = field(default_factory=dict)
    outputs: Mapping[str, str] = field(default_factory=dict)
    wanted: frozenset[str] | None = None
    shortcut: tuple[Call, ...] = ()

    def __post_init__(self) -> None:
        names = set(map(variable, self.kernel.arguments))
        for unknown in set(self.inputs) - names:
            raise ValueError(f"kernel {self.kernel.name} has no argument {unknown}")
        for unknown in set(self.outputs) - set(self.kernel.output_names):
            raise ValueError(f"kernel {self.kernel.name} has no output {unknown}")

    @cached_property
    def arguments(self) -> tuple[Value, ...]:
        """The values of the kernel's arguments, in calling order."""
        return tuple(self.inputs.get(a, a) for a in map(variable, self.kernel.arguments))

    @cached_property
    def read(self) -> frozenset[str]:
        """The variables among the arguments."""
        return frozenset(value for value in self.arguments if isinstance(value, str))

    @cached_property
    def assigned(self) -> dict[str, str]:
        """The variable of each output that is used."""
        return {
            name: self.outputs.get(name, name)
            for name in self.kernel.output_names
            if self.wanted is None or name in self.wanted
        }

    @cached_property
    def kinds(self) -> dict[str, Kind]:
        """The kind of each variable that is assigned."""
        kinds = dict(zip(self.kernel.output_names, self.kernel.kinds, strict=True))
        return {variable: kinds[output] for output, variable in self.assigned.items()}


class _Compound:
    """A node with a body."""

    @cached_property
    def live(self: If | While | ForEach) -> frozenset[str]:  # type: ignore[misc]  # all there are
        """The variables that are live before the node if none is live after it."""
        return frozenset(live_in_body(self, ()) | _own_reads(self))


@dataclass(frozen=True)
class If(_Compound):
    """A body for the shots for which the variable `truth` is true.

    Attributes
    ----------
    rare
        True if most often no shot enters the body; then skipping even a cheap body pays.
    usual
        True if of sixteen shots some nearly always enter the body; then a test for all is a waste,
        and so is a list of those that enter.
    """

    truth: str
    body: tuple[Node, ...] = field(repr=False)
    rare: bool = False
    usual: bool = False


@dataclass(frozen=True)
class While(_Compound):
    """A body that is repeated as long as the variable `truth` is true, at most `limit` times."""

    truth: str
    limit: int
    body: tuple[Node, ...] = field(repr=False)


@dataclass(frozen=True)
class Group:
    """Adjacent rows of a table: all from `first` on, before `past`.

    Attributes
    ----------
    after
        The index of the next group that has none of these rows. The groups between this one and
        that are its parts.
    """

    first: int
    past: int
    after: int


@dataclass(frozen=True)
class BoundingVolumes:
    """A hierarchy of groups of rows, and the test that no row of a group affects a shot.

    Attributes
    ----------
    box
        Evaluated for a row; a group has the maximum of each of its outputs.
    near
        Evaluated for a group and a shot; the last of its arguments are those outputs. If it is
        false, the rows of the group do not affect the shot, and a target may skip them.
    members
        The groups, each before its parts.
    """

    box: Call
    near: Call
    members: tuple[Group, ...]

    @property
    def test_reads(self) -> set[str]:
        """The variables of a shot that the test reads."""
        return set(self.near.read - {*self.box.assigned})


@dataclass(frozen=True)
class ForEach(_Compound):
    """A body that is executed for every row of a table, in order: for isomorphic surfaces.

    Attributes
    ----------
    names
        The names of a row's values in the body; nothing else has these names.
    rows
        The table's rows. Under one name all values are variables, or all are numbers.
    groups
        The rows that a target may skip, and the test for it.
    """

    names: tuple[str, ...]
    rows: tuple[tuple[Value, ...], ...] = field(repr=False)
    body: tuple[Node, ...] = field(repr=False)
    groups: BoundingVolumes | None = field(default=None, repr=False)

    def __post_init__(self) -> None:
        for name, column in zip(self.names, self.columns, strict=True):
            if len({isinstance(value, str) for value in column}) > 1:
                raise ValueError(f"{name} is both a variable and a number")

    @property
    def columns(self) -> tuple[tuple[Value, ...], ...]:
        """The values of each name."""
        return tuple(tuple(row[k] for row in self.rows) for k in range(len(self.names)))

    @property
    def given(self) -> set[str]:
        """The variables in the table."""
        return {value for row in self.rows for value in row if isinstance(value, str)}


Node = Call | If | While | ForEach


def walk(nodes: Iterable[Node]) -> Iterator[Node]:
    """Yield every node, in order, a body after the node that guards it."""
    for node in nodes:
        yield node
        if not isinstance(node, Call):
            yield from walk(node.body)


def reads(nodes: Iterable[Node]) -> set[str]:
    """Return the variables that the nodes read."""
    found: set[str] = set()
    for node in nodes:
        if isinstance(node, Call):
            found |= node.read
        elif isinstance(node, ForEach):
            found |= reads(node.body) - set(node.names) | _own_reads(node)
        else:
            found |= reads(node.body) | {node.truth}
    return found


def writes(nodes: Iterable[Node]) -> dict[str, Kind]:
    """Return the variables that the nodes assign, in order, with their kinds."""
    found: dict[str, Kind] = {}
    for node in walk(nodes):
        if isinstance(node, Call):
            for variable, kind in node.kinds.items():
                if found.setdefault(variable, kind) != kind:
                    raise ValueError(f"{variable} is both {found[variable]} and {kind}")
    return found


def live_before(nodes: Sequence[Node], after: Iterable[str]) -> set[str]:
    """Return the variables that are live before the nodes, given those that are live after them.

    Parameters
    ----------
    nodes
        A sequence of nodes, which is evaluated in order.
    after
        The variables that are read later.
    """
    live = set(after)
    for node in reversed(nodes):
        if isinstance(node, Call):
            live.difference_update(node.assigned.values())
            live |= node.read
        else:  # its body may not be executed: what is live after it is live before it, too
            live |= node.live
    return live


def live_in_body(node: If | While | ForEach, after: Iterable[str]) -> set[str]:
    """Return the variables that are live where a body begins, without the node's own names.

    Parameters
    ----------
    node
        The node with the body.
    after
        The variables that are live after the node.
    """
    if isinstance(node, If):
        return live_before(node.body, after)
    # A further turn needs nothing that is not live where the first one begins, or read by the node.
    live = live_before(node.body, set(after) | _own_reads(node))
    return live - set(node.names) if isinstance(node, ForEach) else live


def _own_reads(node: If | While | ForEach) -> set[str]:
    """Return the variables that a node itself reads."""
    if not isinstance(node, ForEach):
        return {node.truth}
    return node.given | (node.groups.test_reads if node.groups else set())


def check(nodes: Iterable[Node], known: Iterable[str]) -> set[str]:
    """Return the variables that are known after the nodes, given those known before.

    A variable that is first assigned in a body is known in that body alone.

    Parameters
    ----------
    nodes
        The nodes, in order.
    known
        The variables that have a value before them.

    Raises
    ------
    ValueError
        If a node reads a variable that is not known.
    """
    known = set(known)
    for node in nodes:
        if isinstance(node, Call):
            missing: Set[str] = node.read - known
            known |= set(node.assigned.values())
        else:
            missing = _own_reads(node) - known
            check(node.body, known | set(node.names if isinstance(node, ForEach) else ()))
        if missing:
            where = node.kernel.name if isinstance(node, Call) else f"a {type(node).__name__}"
            raise ValueError(f"unknown: {', '.join(sorted(missing))}, in {where}")
    return known


def given_as(node: Call, values: Mapping[str, Value]) -> Call:
    """Return the evaluation of the same kernel with some variables read as others or as numbers.

    Parameters
    ----------
    node
        The evaluation.
    values
        What is read in the place of a variable: the name of another one, or a number.
    """
    names = map(variable, node.kernel.arguments)
    inputs = {
        name: values.get(value, value) if isinstance(value, str) else value
        for name, value in zip(names, node.arguments, strict=True)
    }
    shortcut = tuple(given_as(call, values) for call in node.shortcut)
    return replace(node, inputs=inputs, shortcut=shortcut)


def without(nodes: Iterable[Node], fixed: Mapping[str, float]) -> tuple[Node, ...]:
    """Return the tree with some variables replaced by numbers, and never assigned.

    Parameters
    ----------
    nodes
        The tree.
    fixed
        The numbers, by the names of the variables.
    """
    changed: list[Node] = []
    for node in nodes:
        if isinstance(node, Call):
            kept = {o for o, variable in node.assigned.items() if variable not in fixed}
            changed.append(replace(given_as(node, fixed), wanted=frozenset(kept)))
        else:
            changed.append(replace(node, body=without(node.body, fixed)))
    return tuple(changed)


def needed(nodes: Iterable[Node], wanted: Iterable[str]) -> tuple[Node, ...]:
    """Return the tree without the evaluations that the wanted variables do not depend on.

    Parameters
    ----------
    nodes
        The tree.
    wanted
        The variables that are read after it.
    """
    return _needed(tuple(nodes), set(wanted))[0]


def _needed(nodes: tuple[Node, ...], live: set[str]) -> tuple[tuple[Node, ...], set[str]]:
    """Return the nodes that are left, and the variables that are live before them."""
    kept: list[Node] = []
    live = set(live)
    for node in reversed(nodes):
        if isinstance(node, Call):
            used = {o for o, variable in node.assigned.items() if variable in live}
            if used:
                kept.append(replace(node, wanted=frozenset(used)))
                live -= {node.assigned[output] for output in used}
                live |= {value for value in node.arguments if isinstance(value, str)}
            continue
        body, before = _needed(node.body, live)
        while isinstance(node, While | ForEach):
            again, more = _needed(node.body, live | before | _own_reads(node))
            if more <= before and again == body:
                break
            body, before = again, before | more
        if body and isinstance(node, ForEach):
            node = read_of(replace(node, body=body))
            kept.append(node)
            live |= before - set(node.names) | _own_reads(node)
        elif body:
            kept.append(replace(node, body=body))
            live |= before | _own_reads(node)
    return tuple(reversed(kept)), live


def read_of(node: ForEach) -> ForEach:
    """Return the node with only those columns of its table that its body reads."""
    read = reads(node.body) | (reads([node.groups.box]) if node.groups else set())
    places = [k for k, name in enumerate(node.names) if name in read]
    rows = tuple(tuple(row[k] for k in places) for row in node.rows)
    return replace(node, names=tuple(node.names[k] for k in places), rows=rows)
