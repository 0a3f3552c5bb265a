"""The event loop as a tree of four kinds of node, which every target prints in its own way.

A tree says what happens to *one* shot. A `Do` evaluates a kernel and assigns its outputs to
variables; a `Guard` does its body where a truth holds; a `Repeat` does it as long as one holds; an
`Each` does it for every row of a table. A target that works on many shots at once leaves the others
as they are: by selecting, by taking the rows, or by a branch.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from .kernel import Kernel, Kind
from .symbols import variable

Value = str | float
"""What a kernel is given: a variable, or a number."""


@dataclass(frozen=True)
class Do:
    """The evaluation of a kernel.

    Attributes
    ----------
    kernel
        What is evaluated.
    inputs
        Its arguments that are not the variables of their own names.
    outputs
        The variables that its outputs go to, where those have other names.
    wanted
        The outputs that are assigned; the others are not used.
    """

    kernel: Kernel
    inputs: Mapping[str, Value] = field(default_factory=dict)
    outputs: Mapping[str, str] = field(default_factory=dict)
    wanted: frozenset[str] | None = None

    def __post_init__(self) -> None:
        names = set(map(variable, self.kernel.arguments))
        for unknown in set(self.inputs) - names:
            raise ValueError(f"kernel {self.kernel.name} has no argument {unknown}")
        for unknown in set(self.outputs) - set(self.kernel.output_names):
            raise ValueError(f"kernel {self.kernel.name} has no output {unknown}")

    @property
    def arguments(self) -> tuple[Value, ...]:
        """What the kernel is given, in calling order."""
        return tuple(self.inputs.get(a, a) for a in map(variable, self.kernel.arguments))

    @property
    def assigned(self) -> dict[str, str]:
        """The variable of each output that is used."""
        return {
            name: self.outputs.get(name, name)
            for name in self.kernel.output_names
            if self.wanted is None or name in self.wanted
        }


@dataclass(frozen=True)
class Guard:
    """A body for the shots for which the variable `truth` holds.

    Attributes
    ----------
    rare
        Whether most often it holds for none: then even a body that costs little is best skipped.
    """

    truth: str
    body: tuple[Node, ...]
    rare: bool = False


@dataclass(frozen=True)
class Repeat:
    """A body that is repeated as long as the variable `truth` holds, at most `limit` times."""

    truth: str
    limit: int
    body: tuple[Node, ...]


@dataclass(frozen=True)
class Group:
    """Rows of a table that stand together: all from `first` on that come before `past`.

    Attributes
    ----------
    after
        The index of the next group that has none of these rows; the next one of all is within this
        one, if it is another.
    """

    first: int
    past: int
    after: int


@dataclass(frozen=True)
class Groups:
    """Which rows of a table stand together, and which shots none of a group's does anything to.

    Attributes
    ----------
    box
        Evaluated for a row; a group has the largest of each of its outputs.
    near
        Evaluated for a group and a shot, the last of its arguments are those outputs. Where its
        truth does not hold, the rows of the group do nothing to the shot: a target may leave them
        out.
    members
        A group before those within it.
    """

    box: Do
    near: Do
    members: tuple[Group, ...]

    @property
    def asked(self) -> set[str]:
        """The variables of a shot that are asked."""
        return {v for v in self.near.arguments if isinstance(v, str)} - {*self.box.assigned}


@dataclass(frozen=True)
class Each:
    """A body that is done for every row of a table, in order: for bodies of one kind.

    Attributes
    ----------
    names
        What the values of a row are called in the body; nothing else has these names.
    rows
        The table's rows. Under one name all values are variables, or all are numbers.
    groups
        Which of them may be left out, and where.
    """

    names: tuple[str, ...]
    rows: tuple[tuple[Value, ...], ...]
    body: tuple[Node, ...]
    groups: Groups | None = None

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
        """The variables in its table."""
        return {value for row in self.rows for value in row if isinstance(value, str)}


Node = Do | Guard | Repeat | Each


def walk(nodes: Iterable[Node]) -> Iterator[Node]:
    """Return every node, in order, a body after what guards it."""
    for node in nodes:
        yield node
        if not isinstance(node, Do):
            yield from walk(node.body)


def reads(nodes: Iterable[Node]) -> set[str]:
    """Return the variables that the nodes read."""
    found: set[str] = set()
    for node in nodes:
        if isinstance(node, Do):
            found |= {value for value in node.arguments if isinstance(value, str)}
        elif isinstance(node, Each):
            found |= reads(node.body) - set(node.names) | _asked(node)
        else:
            found |= reads(node.body) | {node.truth}
    return found


def writes(nodes: Iterable[Node]) -> dict[str, Kind]:
    """Return the variables that the nodes assign, in order, and what each is."""
    found: dict[str, Kind] = {}
    for node in walk(nodes):
        if isinstance(node, Do):
            kinds = dict(zip(node.kernel.output_names, node.kernel.kinds, strict=True))
            for output, variable in node.assigned.items():
                found.setdefault(variable, kinds[output])
                if found[variable] != kinds[output]:
                    raise ValueError(f"{variable} is both {found[variable]} and {kinds[output]}")
    return found


def live_before(nodes: Sequence[Node], after: Iterable[str]) -> set[str]:
    """Return the variables whose values are needed before the nodes, given those needed after."""
    live = set(after)
    for node in reversed(nodes):
        if isinstance(node, Do):
            live -= set(node.assigned.values())
            live |= reads([node])
        else:
            live |= live_in_body(node, live) | _asked(node)
    return live


def live_in_body(node: Guard | Repeat | Each, after: Iterable[str]) -> set[str]:
    """Return the variables whose values are needed where a guarded body begins, but its own."""
    live = live_before(node.body, after)
    while isinstance(node, Repeat | Each):
        more = live_before(node.body, live | set(after) | _asked(node))
        if more <= live:
            break
        live |= more
    return live - set(node.names) if isinstance(node, Each) else live


def _asked(node: Guard | Repeat | Each) -> set[str]:
    """Return the variables that a node reads itself."""
    if not isinstance(node, Each):
        return {node.truth}
    return node.given | (node.groups.asked if node.groups else set())


def check(nodes: Iterable[Node], known: Iterable[str]) -> set[str]:
    """Return the variables that are known after the nodes, given those before.

    Raises
    ------
    ValueError
        If one is read that is not known. What is first assigned in a guarded body is known in that
        body alone.
    """
    known = set(known)
    for node in nodes:
        if isinstance(node, Do):
            missing = {v for v in node.arguments if isinstance(v, str)} - known
            known |= set(node.assigned.values())
        else:
            missing = _asked(node) - known
            check(node.body, known | set(node.names if isinstance(node, Each) else ()))
        if missing:
            where = node.kernel.name if isinstance(node, Do) else f"a {type(node).__name__}"
            raise ValueError(f"unknown: {', '.join(sorted(missing))}, in {where}")
    return known


def given_as(node: Do, values: Mapping[str, Value]) -> Do:
    """Return the evaluation of the same kernel, some variables read as others or as numbers."""
    names = map(variable, node.kernel.arguments)
    inputs = {
        name: values.get(value, value) if isinstance(value, str) else value
        for name, value in zip(names, node.arguments, strict=True)
    }
    return replace(node, inputs=inputs)


def without(nodes: Iterable[Node], fixed: Mapping[str, float]) -> tuple[Node, ...]:
    """Return the tree with some variables fixed: read as those numbers, never assigned."""
    changed: list[Node] = []
    for node in nodes:
        if isinstance(node, Do):
            kept = {o for o, variable in node.assigned.items() if variable not in fixed}
            changed.append(replace(given_as(node, fixed), wanted=frozenset(kept)))
        else:
            changed.append(replace(node, body=without(node.body, fixed)))
    return tuple(changed)


def needed(nodes: Iterable[Node], wanted: Iterable[str]) -> tuple[Node, ...]:
    """Return the tree without what does not serve the variables that are wanted after it."""
    return _needed(tuple(nodes), set(wanted))[0]


def _needed(nodes: tuple[Node, ...], live: set[str]) -> tuple[tuple[Node, ...], set[str]]:
    """Return what is left of the nodes, and what is live before them, given what is after."""
    kept: list[Node] = []
    live = set(live)
    for node in reversed(nodes):
        if isinstance(node, Do):
            used = {o for o, variable in node.assigned.items() if variable in live}
            if used:
                kept.append(replace(node, wanted=frozenset(used)))
                live -= {node.assigned[output] for output in used}
                live |= {value for value in node.arguments if isinstance(value, str)}
            continue
        body, before = _needed(node.body, live)
        while isinstance(node, Repeat | Each):
            again, more = _needed(node.body, live | before | _asked(node))
            if more <= before and again == body:
                break
            body, before = again, before | more
        if body and isinstance(node, Each):
            node = read_of(replace(node, body=body))
            kept.append(node)
            live |= before - set(node.names) | _asked(node)
        elif body:
            kept.append(replace(node, body=body))
            live |= before | _asked(node)
    return tuple(reversed(kept)), live


def read_of(node: Each) -> Each:
    """Return the node with those columns of its table that its body reads."""
    read = reads(node.body) | (reads([node.groups.box]) if node.groups else set())
    places = [k for k, name in enumerate(node.names) if name in read]
    rows = tuple(tuple(row[k] for k in places) for row in node.rows)
    return replace(node, names=tuple(node.names[k] for k in places), rows=rows)
