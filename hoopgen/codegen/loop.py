"""Printing the event loop: the tree of derive/follow/ in the way of each target.

C works on lanes: a body is skipped where no lane needs it, and what it assigns is selected. NumPy
works on rows: a body takes the rows that need it, and puts back what it assigned.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ground.tree import (
    Do,
    Each,
    Guard,
    Node,
    Repeat,
    live_before,
    live_in_body,
    reads,
    writes,
)

from .printers import NUMPY, C, Spelling, constant

CHEAP = 40
"""A body that costs no more is done for every lane or row: to skip it would cost as much."""

CHEAP_IN_TURNS = 10
"""The same in a body that repeats, where what some rows need is not taken by all in each turn."""

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


@dataclass
class _Printer:
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

    def _cost(self, node: Guard) -> int:
        return sum(self.costs[n.kernel.name] for n in node.body if isinstance(n, Do))


@dataclass
class CLoop(_Printer):
    """Lanes: `lanes_any` skips a body, `lanes_select` keeps the other lanes as they are."""

    def stage(
        self,
        nodes: Sequence[Node],
        known: Mapping[str, bool],
        mask: str,
        after: Iterable[str],
    ) -> dict[str, bool]:
        """Print a stage for the lanes of `mask`; return the variables known after it."""
        known = dict(known)
        self._body(nodes, known, set(), mask, "", set(after))
        return known

    def _body(
        self,
        nodes: Sequence[Node],
        known: dict[str, bool],
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
            # What the body has for itself alone it declares, unless it may need the value around it.
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
            self._body(node.body, inside, shared, truth, inner, later)
            self.lines.append(f"{indent}}}")

    def _each(
        self,
        node: Each,
        known: dict[str, bool],
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
        for name, value in self.row(node, indent + "    ").items():
            self.lines.append(f"{indent}        const V {name} = {value};")
            inside[name] = False
        self._body(node.body, inside, outer, mask, indent + "        ", after)
        self.lines.append(f"{indent}    }}")
        self.lines.append(f"{indent}}}")

    def row(self, node: Each, indent: str) -> dict[str, str]:
        """Print a table, and where the loop over its rows begins; return the values of a row."""
        raise NotImplementedError

    def _do(
        self, node: Do, known: dict[str, bool], outer: set[str], mask: str, indent: str
    ) -> None:
        name = f"LANES({self.prefix}_{node.kernel.name})"
        given = ", ".join(self._value(value) for value in node.arguments)
        result = self.fresh("o")
        self.lines.append(f"{indent}const LANES({self.prefix}_{node.kernel.name}_out) {result} =")
        self.lines.append(f"{indent}    {name}({given});")
        kinds = dict(zip(node.kernel.output_names, node.kernel.truths, strict=True))
        for output, variable in node.assigned.items():
            value = f"{result}.{output}"
            if variable not in known:
                kind = "M" if kinds[output] else "V"
                self.lines.append(f"{indent}{kind} {variable} = {value};")
                known[variable] = kinds[output]
            elif variable not in outer:
                self.lines.append(f"{indent}{variable} = {value};")
            elif kinds[output]:
                self.lines.append(
                    f"{indent}{variable} = lanes_choose({mask}, {value}, {variable});"
                )
            else:
                self.lines.append(
                    f"{indent}{variable} = lanes_select({mask}, {value}, {variable});"
                )

    def _value(self, value: str | float) -> str:
        return value if isinstance(value, str) else constant(float(value), C)


@dataclass
class NumPyLoop(_Printer):
    """Rows: a body takes its own, and puts back what it assigned.

    Attributes
    ----------
    rows
        The kernels that are given rows to write into: as many shots long as their arguments.
    far
        Within a body that repeats, what only some of its shots need, never changed by it: its names
        outside. It is taken from there, rather than by all shots in each turn.
    """

    rows: Collection[str] = ()
    far: dict[str, str] = field(default_factory=dict)
    turning: str = ""

    def stage(
        self, nodes: Sequence[Node], names: Mapping[str, str], after: Iterable[str]
    ) -> dict[str, str]:
        """Print a stage, given the names of what it knows; return those known after it."""
        names = dict(names)
        self._body(nodes, names, "shots", "", set(after), 0)
        return names

    def _body(
        self,
        nodes: Sequence[Node],
        names: dict[str, str],
        count: str,
        indent: str,
        after: set[str],
        depth: int,
    ) -> None:
        if self._given_rows(nodes):
            self.lines.append(f"{indent}{_room(depth)} = room({count})")
        for index, node in enumerate(nodes):
            later = live_before(nodes[index + 1 :], after)
            if isinstance(node, Do):
                self._do(node, names, indent, depth, depth)
            elif isinstance(node, Each):
                self._each(node, names, count, indent, later, depth)
            elif isinstance(node, Guard) and self._for_all(node):
                self._chosen(node, names, indent, later, depth)
            else:
                self._rows(node, names, count, indent, later, depth)

    def _given_rows(self, nodes: Sequence[Node]) -> bool:
        """Whether a kernel that all shots of a body call is given rows to write into."""
        return any(
            node.kernel.name in self.rows
            if isinstance(node, Do)
            else isinstance(node, Guard) and self._for_all(node) and self._given_rows(node.body)
            for node in nodes
        )

    def _for_all(self, node: Guard) -> bool:
        """Whether a body is done for all rows; in one that repeats, rows are few and taken anew."""
        most = CHEAP_IN_TURNS if self.turning else CHEAP
        return self.cheap(node) and self._cost(node) <= most

    def _near(self, nodes: Sequence[Node], after: set[str]) -> set[str]:
        """Return what all rows of a body need, not those of a guarded body alone."""
        near: set[str] = set()
        for index, node in enumerate(nodes):
            if isinstance(node, Do):
                near |= reads([node])
                continue
            later = live_before(nodes[index + 1 :], after)
            near |= {node.truth, *scope(node, later).gives}
            if isinstance(node, Repeat):
                near |= set(scope(node, later).takes)
            elif self._for_all(node):
                near |= self._near(node.body, later)
        return near

    def _do(
        self, node: Do, names: dict[str, str], indent: str, depth: int, shots_depth: int
    ) -> None:
        given = ", ".join(
            names[v] if isinstance(v, str) else constant(float(v), NUMPY) for v in node.arguments
        )
        if node.kernel.name in self.rows:
            given += f", {_room(shots_depth)}"
        for variable in node.assigned.values():
            names[variable] = local(variable, depth)
        targets = [
            names[node.assigned[o]] if o in node.assigned else "_" for o in node.kernel.output_names
        ]
        while targets[-1] == "_" and len(targets) > 1 and targets[-2] == "_":
            targets.pop()
        if targets[-1] == "_":
            targets[-1] = "*_"
        self.lines.append(
            f"{indent}{', '.join(targets)}{',' * (len(targets) == 1)} = {node.kernel.name}({given})"
        )

    def _each(
        self,
        node: Each,
        names: dict[str, str],
        count: str,
        indent: str,
        later: set[str],
        depth: int,
    ) -> None:
        """Print a loop over the rows of a table; what goes from row to row keeps its name."""
        after = carried(node, later)
        kept = {v: local(v, depth) for v in sorted(set(writes(node.body)) & after)}
        for name, own in kept.items():
            if names[name] != own:
                self.lines.append(f"{indent}{own} = {names[name]}")
        inside = names | kept | {name: local(name, depth) for name in node.names}
        self.lines.append(f"{indent}for {', '.join(inside[name] for name in node.names)}, in (")
        for row in node.rows:
            given = (names[v] if isinstance(v, str) else constant(float(v), NUMPY) for v in row)
            self.lines.append(f"{indent}    ({', '.join(given)},),")
        self.lines.append(f"{indent}):")
        self._body(node.body, inside, count, indent + "    ", after, depth)
        assert all(inside[name] == own for name, own in kept.items()), "a name changed"
        names |= kept

    def _chosen(
        self, node: Guard, names: dict[str, str], indent: str, later: set[str], depth: int
    ) -> None:
        """Print a cheap body for all rows, and choose."""
        own = scope(node, later)
        inside = dict(names)
        inner = depth + 1
        for body in node.body:
            assert isinstance(body, Do)
            self._do(body, inside, indent, inner, depth)
        for name in own.gives:
            new = local(name, depth)
            self.lines.append(
                f"{indent}{new} = _choose({names[node.truth]}, {inside[name]}, {names[name]})"
            )
            names[name] = new

    def _rows(
        self,
        node: Guard | Repeat,
        names: dict[str, str],
        count: str,
        indent: str,
        later: set[str],
        depth: int,
    ) -> None:
        own = scope(node, later)
        rows, own_count = self.fresh("rows"), self.fresh("count")
        line, deeper = self.lines.append, indent + "    "
        line(f"{indent}{rows}, {own_count} = _rows({names[node.truth]}, {count})")
        line(f"{indent}if {own_count}:")
        if isinstance(node, Repeat):
            self._turns(node, names, own, (rows, own_count), count, deeper, later, depth)
        else:
            far = set(own.takes) - set(names)
            if far:
                line(f"{deeper}_far = _of({self.turning}, {rows})")
            inside = {name: local(name, depth + 1) for name in own.takes}
            for name in inside:
                of = f"{self.far[name]}, _far" if name in far else f"{names[name]}, {rows}"
                line(f"{deeper}{inside[name]} = _take({of})")
            self._body(node.body, inside, own_count, deeper, later, depth + 1)
            for name in own.gives:
                given = f"{names[name]}, {rows}, {inside[name]}, {count}"
                line(f"{deeper}{local(name, depth)} = _put({given})")
        missing = [name for name in own.gives if names[name] != local(name, depth)]
        if missing:
            line(f"{indent}else:")
            for name in missing:
                line(f"{deeper}{local(name, depth)} = {names[name]}")
        for name in own.gives:
            names[name] = local(name, depth)

    def _turns(
        self,
        node: Repeat,
        names: dict[str, str],
        own: Scope,
        own_rows: tuple[str, str],
        count: str,
        deeper: str,
        later: set[str],
        depth: int,
    ) -> None:
        """Print a body that repeats; rows that are done are stored, the others taken anew."""
        (rows, own_count), outer = own_rows, (self.far, self.turning)
        line, turning = self.lines.append, deeper + "    "
        wanted = later | set(own.takes) | {node.truth}
        self.turning = rows
        far = set(own.takes) - set(writes(node.body)) - self._near(node.body, wanted) - {node.truth}
        self.far = {name: names[name] for name in far}
        inside = {name: local(name, depth + 1) for name in own.takes if name not in far}
        for name in inside:
            line(f"{deeper}{inside[name]} = _take({names[name]}, {rows})")
        for name in own.gives:
            line(f"{deeper}{local(name, depth)} = _copy({names[name]}, {count})")
        line(f"{deeper}for _ in range({node.limit}):")
        start = dict(inside)
        self._body(node.body, inside, own_count, turning, wanted, depth + 1)
        assert all(inside[name] == value for name, value in start.items()), "a name changed"
        going = self.fresh("going")
        line(f"{turning}{going} = _where_true({inside[node.truth]})")
        line(f"{turning}if len({going}) == {own_count}:")
        line(f"{turning}    continue")
        line(f"{turning}_done = _where_true(_logical_not({inside[node.truth]}))")
        for name in own.gives:
            into = f"{local(name, depth)}, _of({rows}, _done)"
            line(f"{turning}_store({into}, {inside[name]}, _done)")
        line(f"{turning}{rows}, {own_count} = _of({rows}, {going}), len({going})")
        line(f"{turning}if not {own_count}:")
        line(f"{turning}    break")
        for name in sorted({*own.takes, *own.gives} - far):
            line(f"{turning}{inside[name]} = _take({inside[name]}, {going})")
        if own.gives:
            line(f"{deeper}else:")
        for name in own.gives:
            line(f"{turning}_store({local(name, depth)}, {rows}, {inside[name]}, None)")
        self.far, self.turning = outer


def _room(depth: int) -> str:
    """Return the rows for as many shots as there are so many bodies deep."""
    return f"_room_{depth}"


def local(name: str, depth: int) -> str:
    """Return a variable as a name in a stage in NumPy, so many bodies deep."""
    return f"_{name}_{depth}"


def weighted(cost: Mapping[str, int]) -> int:
    """Return about how long a kernel takes, in additions."""
    return sum(count * COSTS.get(name, 1) for name, count in cost.items())
