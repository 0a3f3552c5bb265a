"""Printing the event loop for NumPy: a body takes its own rows, and puts back what it assigned."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ground.tree import (
    Do,
    Each,
    Groups,
    Guard,
    Node,
    Repeat,
    Value,
    live_before,
    reads,
    writes,
)

from .alone import Alone
from .loop import CHEAP, CHEAP_IN_TURNS, Printer, Scope, carried, repeats, scope
from .printers import NUMPY, Constants, constant


@dataclass
class NumPyLoop(Printer):
    """Rows: a body takes its own, and puts back what it assigned.

    Attributes
    ----------
    rows
        The kernels that are given rows to write into: as many shots long as their arguments.
    alone
        The functions for one shot.
    far
        Within a body that repeats, what only some of its shots need, never changed by it: its names
        outside. It is taken from there, rather than by all shots in each turn.
    short
        What is in single precision.
    """

    rows: Collection[str] = ()
    alone: Alone = field(default_factory=lambda: Alone(Constants()))
    far: dict[str, str] = field(default_factory=dict)
    short: set[str] = field(default_factory=set)
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
            if isinstance(node, Each):
                near |= reads([node]) | (set(writes([node])) & later)
                continue
            near |= {node.truth, *scope(node, later).gives}
            if isinstance(node, Repeat):
                near |= set(scope(node, later).takes)
            elif self._for_all(node):
                near |= self._near(node.body, later)
        return near

    def _do(
        self, node: Do, names: dict[str, str], indent: str, depth: int, shots_depth: int
    ) -> None:
        given = ", ".join(self._given(v, names, node.kernel.single) for v in node.arguments)
        call = f"{node.kernel.name}({given})"
        if node.kernel.name in self.rows:
            call = f"{node.kernel.name}({given}, {_room(shots_depth)})"
            if not any(isinstance(value, str) for value in node.arguments):
                call = f"_fixed({node.kernel.name}, {given})"
        for variable in node.assigned.values():
            names[variable] = local(variable, depth)
        if node.kernel.single:
            kinds = dict(zip(node.kernel.output_names, node.kernel.kinds, strict=True))
            self.short |= {v for o, v in node.assigned.items() if kinds[o] == "single"}
        targets = [
            names[node.assigned[o]] if o in node.assigned else "_" for o in node.kernel.output_names
        ]
        while targets[-1] == "_" and len(targets) > 1 and targets[-2] == "_":
            targets.pop()
        if targets[-1] == "_":
            targets[-1] = "*_"
        self.lines.append(f"{indent}{', '.join(targets)}{',' * (len(targets) == 1)} = {call}")

    def _given(self, value: Value, names: Mapping[str, str], single: bool) -> str:
        """Return what a kernel is given; one in single precision rounds it itself."""
        if not isinstance(value, str):
            return constant(float(value), NUMPY)
        return f"_double({names[value]})" if value in self.short and not single else names[value]

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
        own = ", ".join(inside[name] for name in node.names)
        begin, end = f"for {own}, in ", ":"
        if node.groups is not None:
            begin, end = "_table = ", ""
        self.lines.append(f"{indent}{begin}(")
        for row in node.rows:
            given = (names[v] if isinstance(v, str) else constant(float(v), NUMPY) for v in row)
            self.lines.append(f"{indent}    ({', '.join(given)},),")
        self.lines.append(f"{indent}){end}")
        if node.groups is not None:
            reached = self._grouped(node, node.groups, names, indent)
            self.lines.append(f"{indent}for {own}, in {reached}:")
        self._body(node.body, inside, count, indent + "    ", after, depth)
        assert all(inside[name] == own for name, own in kept.items()), "a name changed"
        names |= kept

    def _grouped(self, node: Each, groups: Groups, names: Mapping[str, str], indent: str) -> str:
        """Print the groups of a table; return the rows of those that some shots come near."""
        line = self.lines.append
        line(f"{indent}_members = (")
        for group in groups.members:
            line(f"{indent}    ({group.first}, {group.past}, {group.after}),")
        line(f"{indent})")
        sizes = [
            f"[_row[{node.names.index(v)}] for _row in _table]" if v in node.names else names[v]
            for v in groups.box.arguments
            if isinstance(v, str)
        ]
        seen = [names[v] for v in groups.near.arguments if isinstance(v, str) and v in groups.asked]
        box, near = groups.box.kernel, groups.near.kernel
        assert groups.near.arguments[len(seen) :] == box.output_names, near.name
        line(f"{indent}_sizes = ({', '.join(sizes)},)")
        line(f"{indent}_seen = ({', '.join(seen)},)")
        return f"_near(_table, _members, {box.name}, _sizes, {near.name}, _seen)"

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
        # The body may assign its own truth: that goes last.
        for name in sorted(own.gives, key=lambda name: name == node.truth):
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
        plain = all(isinstance(n, Do) for n in node.body) and isinstance(node, Guard)
        taken = "_most" if plain else "_rows"
        line(f"{indent}{rows}, {own_count} = {taken}({names[node.truth]}, {count})")
        far = self._far(node, own, later, rows) if isinstance(node, Repeat) else []
        one = ""
        if repeats(node) and own.gives and not set(own.takes) - set(names):
            takes = {*own.takes, *own.gives} if isinstance(node, Repeat) else {*own.takes}
            near = sorted(takes - set(far))
            one = self.alone.function(node, near + far, own.gives, self.short)
            line(f"{indent}if 0 < {own_count} <= ALONE:")
            for name in own.gives:
                line(f"{deeper}{local(name, depth)} = _copy({names[name]}, {count})")
            into = _tuple(local(name, depth) for name in own.gives)
            of = f"{rows}, {rows}, {_tuple(names[name] for name in near + far)}, (), {into}"
            turns = f", {node.limit}" if isinstance(node, Repeat) else ""
            line(f"{deeper}_one_by_one({one}, {of}{turns})")
        line(f"{indent}{'elif' if one else 'if'} {own_count}:")
        if isinstance(node, Repeat):
            self._turns(node, names, own, (rows, own_count), count, deeper, later, depth, far, one)
        else:
            outside = set(own.takes) - set(names)
            if outside:
                line(f"{deeper}_far = _of({self.turning}, {rows})")
            inside = {name: local(name, depth + 1) for name in own.takes}
            for name in inside:
                of = f"{self.far[name]}, _far" if name in outside else f"{names[name]}, {rows}"
                line(f"{deeper}{inside[name]} = _take({of})")
            self._body(node.body, inside, own_count, deeper, later, depth + 1)
            # The body may assign its own truth: that goes last.
            for name in sorted(own.gives, key=lambda name: name == node.truth):
                given = f"{names[name]}, {rows}, {inside[name]}, {count}"
                given += f", {names[node.truth]}" * plain
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
        far: Sequence[str],
        one: str,
    ) -> None:
        """Print a body that repeats; rows that are done are stored, the others taken anew."""
        (rows, own_count), outer = own_rows, (self.far, self.turning)
        line, turning = self.lines.append, deeper + "    "
        wanted = later | set(own.takes) | {node.truth}
        self.turning = rows
        self.far = {name: names[name] for name in far}
        inside = {name: local(name, depth + 1) for name in own.takes if name not in far}
        for name in inside:
            line(f"{deeper}{inside[name]} = _take({names[name]}, {rows})")
        for name in own.gives:
            line(f"{deeper}{local(name, depth)} = _copy({names[name]}, {count})")
        turn = self.fresh("turn") if one else "_"
        line(f"{deeper}for {turn} in range({node.limit}):")
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
        near = sorted({*own.takes, *own.gives} - set(far))
        if one:
            line(f"{turning}if {own_count} <= ALONE:")
            given = f"{_tuple(inside[name] for name in near)}, {_tuple(names[n] for n in far)}"
            into = _tuple(local(name, depth) for name in own.gives)
            left = f"{node.limit - 1} - {turn}"
            of = f"{rows}, {going}, {given}, {into}, {left}"
            line(f"{turning}    _one_by_one({one}, {of})")
            line(f"{turning}    break")
        for name in near:
            line(f"{turning}{inside[name]} = _take({inside[name]}, {going})")
        if own.gives:
            line(f"{deeper}else:")
        for name in own.gives:
            line(f"{turning}_store({local(name, depth)}, {rows}, {inside[name]}, None)")
        self.far, self.turning = outer

    def _far(self, node: Repeat, own: Scope, later: set[str], rows: str) -> list[str]:
        """Return what only some of the shots of a body that repeats need, and it never changes."""
        outer, self.turning = self.turning, rows
        wanted = later | set(own.takes) | {node.truth}
        near = self._near(node.body, wanted) | set(writes(node.body)) | {node.truth}
        self.turning = outer
        return sorted(set(own.takes) - near)


def _tuple(names: Iterable[str]) -> str:
    """Return names as a tuple."""
    return f"({''.join(f'{name}, ' for name in names).removesuffix(' ')})"


def _room(depth: int) -> str:
    """Return the rows for as many shots as there are so many bodies deep."""
    return f"_room_{depth}"


def local(name: str, depth: int) -> str:
    """Return a variable as a name in a stage in NumPy, so many bodies deep."""
    return f"_{name}_{depth}"
