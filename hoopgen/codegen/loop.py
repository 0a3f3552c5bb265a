"""Printing the event loop: the tree of derive/follow/ in the way of each target.

C works on lanes: a body is skipped where no lane needs it, and what it assigns is selected. NumPy
works on rows: a body takes the rows that need it, and puts back what it assigned.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence, Set
from dataclasses import dataclass, field, replace

from hoopgen.derive.ground.kernel import Kind
from hoopgen.derive.ground.tree import (
    Do,
    Each,
    Guard,
    Node,
    Repeat,
    live_before,
    live_in_body,
    reads,
    walk,
    writes,
)

from .fixed import Fixed
from .printers import C_SINGLE, C, Spelling, constant

TYPES: dict[Kind, str] = {"double": "V", "single": "S", "truth": "M"}
"""What variables are in C."""

LOADED: dict[Kind, str] = {
    "double": "lanes_load({})",
    "single": "singles_load({})",
    "truth": "lanes_less(K(0.0), lanes_load({}))",
}
STORED: dict[Kind, str] = {
    "double": "lanes_store({}, {})",
    "single": "singles_store({}, {})",
    "truth": "lanes_store({}, lanes_select({}, K(1.0), K(0.0)))",
}
FILLED: dict[Kind, str] = {
    "double": "lanes_store({}, K(0.0))",
    "single": "singles_store({}, KS(0.0))",
    "truth": "lanes_store({}, K(0.0))",
}
PACKED: dict[Kind, str] = {
    "double": "lanes_pack({}, packed, {})",
    "single": "singles_pack({}, packed, {})",
    "truth": "lanes_pack({}, packed, lanes_select({}, K(1.0), K(0.0)))",
}
EXPANDED: dict[Kind, str] = {
    "double": "lanes_expand({0}, idle, {1})",
    "single": "singles_expand({0}, idle, {1})",
    "truth": "lanes_less(K(0.0), lanes_expand({0}, idle, lanes_select({1}, K(1.0), K(0.0))))",
}
"""How columns of each kind are read and written: a truth is a number that is not zero."""
NONE: dict[Kind, str] = {"double": "K(0.0)", "single": "KS(0.0)", "truth": "lanes_nowhere()"}

CHEAP = 40
"""A body that costs no more is done for every lane or row: to skip it would cost as much."""

CHEAP_IN_TURNS = 10
"""The same in a body that repeats, where what some rows need is not taken by all in each turn."""

LONG = 1000
"""What is rarely done and costs more has a list in C, even if it has no turns."""

COSTS = {"div": 8, "sqrt": 8}
"""Operations that cost more than one."""


@dataclass(frozen=True)
class Scope:
    """How a guarded body stands to what is around it.

    Attributes
    ----------
    takes
        The variables around it whose values it needs, in order of their names.
    gives
        Those that it assigns and that are needed after it.
    keeps
        Those that a repeated body needs again in its next turn.
    """

    takes: tuple[str, ...]
    gives: tuple[str, ...]
    keeps: tuple[str, ...]


def carried(node: Each, after: Iterable[str]) -> set[str]:
    """Return what is needed where a body ends that is done for each row: after it, or by the next.

    What it assigns of that is the same variable from row to row.
    """
    return set(after) | live_in_body(node, after)


def repeats(node: Node) -> bool:
    """Whether a body repeats, or something in it does: that lasts for few shots."""
    return any(isinstance(n, Repeat) for n in walk([node]))


def scope(node: Guard | Repeat, after: Iterable[str]) -> Scope:
    """Return how a guarded body stands to what is around it, given what is needed after it."""
    assigned = set(writes(node.body))
    gives = assigned & set(after)
    takes = live_in_body(node, gives)
    keeps: set[str] = set()
    if isinstance(node, Repeat):
        takes |= {node.truth}
        keeps = assigned & takes
    return Scope(*(tuple(sorted(names)) for names in (takes, gives, keeps)))


@dataclass(frozen=True)
class Note:
    """Lines that come before the node of an index: what they read, and what they give."""

    index: int
    lines: tuple[str, ...]
    reads: frozenset[str]
    gives: dict[str, Kind] = field(default_factory=dict)


def within(note: Note | None, start: int, end: int) -> Note | None:
    """Return the note for a run of the nodes, if it belongs there."""
    if note is None or not start <= note.index <= end:
        return None
    return replace(note, index=note.index - start)


def written_within(
    node: Guard, nodes: Iterable[Node], columns: Set[str], shared: Set[str]
) -> dict[str, bool]:
    """Return the columns that one guarded body alone writes of those nodes, which are stored there.

    And whether nothing else reads them, nor are they `shared`: then they are loaded there, too.
    """
    others = [other for other in nodes if other is not node]
    own = columns & set(writes(node.body)) - set(writes(others))
    elsewhere = reads(others) | shared | {node.truth}
    return {name: name not in elsewhere for name in sorted(own)}


def bare(nodes: Sequence[Node]) -> tuple[Node, ...]:
    """Return the tree with no rows in its tables, whose variables are loaded row by row."""
    made: list[Node] = []
    for node in nodes:
        if not isinstance(node, Do):
            node = replace(node, body=bare(node.body))
        made.append(replace(node, rows=()) if isinstance(node, Each) else node)
    return tuple(made)


@dataclass
class Printer:
    """What printing to any target has in common."""

    prefix: str
    costs: Mapping[str, int]
    spelling: Spelling
    lines: list[str] = field(default_factory=list)
    counter: int = 0

    def fresh(self, letter: str) -> str:
        """Return a name that is not in use."""
        self.counter += 1
        return f"_{letter}{self.counter}"

    def cheap(self, node: Guard) -> bool:
        """Whether a body is better done for all than skipped for some."""
        if node.rare or not all(isinstance(n, Do) for n in node.body):
            return False
        return self._cost(node) <= CHEAP

    def long(self, node: Node) -> bool:
        """Whether a body is rarely done, and then costs much."""
        cost = sum(self.costs[n.kernel.name] for n in walk([node]) if isinstance(n, Do))
        return isinstance(node, Guard) and node.rare and cost > LONG

    def _cost(self, node: Guard) -> int:
        return sum(self.costs[n.kernel.name] for n in node.body if isinstance(n, Do))


@dataclass
class CLoop(Printer):
    """Lanes: `lanes_any` skips a body, `lanes_select` keeps the other lanes as they are.

    Attributes
    ----------
    fixed
        What kernels are given ready made.
    """

    fixed: Fixed = field(default_factory=Fixed)

    def stage(
        self,
        nodes: Sequence[Node],
        known: Mapping[str, Kind],
        mask: str,
        after: Iterable[str],
    ) -> dict[str, Kind]:
        """Print a stage for the lanes of `mask`; return the variables known after it."""
        known = dict(known)
        self._body(nodes, known, set(), mask, "", set(after))
        return known

    def _body(
        self,
        nodes: Sequence[Node],
        known: dict[str, Kind],
        outer: set[str],
        mask: str,
        indent: str,
        after: set[str],
    ) -> None:
        """Print nodes; what they assign of `outer` is selected by `mask`."""
        for index, node in enumerate(nodes):
            later = live_before(nodes[index + 1 :], after)
            if isinstance(node, Do):
                self._do(node, known, outer, mask, indent)
                continue
            if isinstance(node, Each):
                self._each(node, known, outer, mask, indent, later)
                continue
            own = scope(node, later)
            truth = self.fresh("m")
            inner = indent + "    "
            inside = dict(known)
            shared = set(own.gives) | set(own.keeps)
            # What the body has for itself alone it declares, if it needs no value from around it.
            for name in set(writes(node.body)) - shared - set(own.takes):
                inside.pop(name, None)
            if isinstance(node, Repeat):
                self.lines.append(f"{indent}for (int _turn = 0; _turn < {node.limit}; _turn++) {{")
                self.lines.append(f"{inner}const M {truth} = lanes_both({mask}, {node.truth});")
                self.lines.append(f"{inner}if (!lanes_any({truth}))")
                self.lines.append(f"{inner}    break;")
                self._body(
                    node.body, inside, shared, truth, inner, later | set(own.takes) | {node.truth}
                )
                self.lines.append(f"{indent}}}")
                continue
            self.lines.append(f"{indent}const M {truth} = lanes_both({mask}, {node.truth});")
            skip = "" if self.cheap(node) else f"if (lanes_any({truth})) "
            self.lines.append(f"{indent}{skip}{{")
            begin, finish = self.beside_body(node, inside, inner)
            self.lines += begin
            self._body(node.body, inside, shared, truth, inner, later)
            self.lines += finish
            self.lines.append(f"{indent}}}")

    def beside_body(
        self, node: Guard, known: dict[str, Kind], indent: str
    ) -> tuple[list[str], list[str]]:
        """Return what is done where a guarded body begins, and where it ends."""
        return [], []

    def _each(
        self,
        node: Each,
        known: dict[str, Kind],
        outer: set[str],
        mask: str,
        indent: str,
        later: set[str],
    ) -> None:
        after = carried(node, later)
        inside = dict(known)
        for name in set(writes(node.body)) - after:
            inside.pop(name, None)
        self.lines.append(f"{indent}{{")
        for name, value in self.row(node, indent + "    ", mask).items():
            self.lines.append(f"{indent}        const V {name} = {value};")
            inside[name] = "double"
        self._body(node.body, inside, outer, mask, indent + "        ", after)
        self.lines += [f"{indent}    }}"] * (1 if node.groups is None else 2)
        self.lines.append(f"{indent}}}")

    def row(self, node: Each, indent: str, mask: str) -> dict[str, str]:
        """Print a table, and where the loop over its rows begins; return the values of a row.

        Of a table in groups it is a loop in one over the groups.
        """
        raise NotImplementedError

    def _do(
        self, node: Do, known: dict[str, Kind], outer: set[str], mask: str, indent: str
    ) -> None:
        name = f"LANES({self.prefix}_{node.kernel.name})"
        single = node.kernel.single
        values = [self._given(value, known, single) for value in node.arguments]
        given = ", ".join(self.fixed.given(node, values))
        result = self.fresh("o")
        self.lines.append(f"{indent}const LANES({self.prefix}_{node.kernel.name}_out) {result} =")
        self.lines.append(f"{indent}    {name}({given});")
        kinds = dict(zip(node.kernel.output_names, node.kernel.kinds, strict=True))
        for output, variable in node.assigned.items():
            value = f"{result}.{output}"
            if variable not in known:
                self.lines.append(f"{indent}{TYPES[kinds[output]]} {variable} = {value};")
                known[variable] = kinds[output]
                continue
            if variable in outer:
                value = CHOSEN[kinds[output]].format(mask, value, variable)
            self.lines.append(f"{indent}{variable} = {value};")

    def _given(self, value: str | float, known: Mapping[str, Kind], single: bool) -> str:
        """Return what a kernel is given, in the precision that it has."""
        if not isinstance(value, str):
            return constant(float(value), C_SINGLE if single else C)
        kind = known.get(value, "double")
        if kind == "truth" or (kind == "single") == single:
            return value
        return f"lanes_narrow({value})" if single else f"lanes_wide({value})"

    def _value(self, value: str | float) -> str:
        return value if isinstance(value, str) else constant(float(value), C)


CHOSEN: dict[Kind, str] = {
    "double": "lanes_select({}, {}, {})",
    "single": "singles_select(singles_of({}), {}, {})",
    "truth": "lanes_choose({}, {}, {})",
}
"""How a variable takes a value in some lanes."""


def weighted(cost: Mapping[str, int]) -> int:
    """Return about how long a kernel takes, in additions."""
    return sum(count * COSTS.get(name, 1) for name, count in cost.items())
