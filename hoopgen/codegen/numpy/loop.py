"""Lowering the event loop for NumPy: a body takes its own rows, and puts back what it assigned."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.event_tree import Node, Value, live_before, reads, writes

from ..lowering import Lowering, Scope, carried, repeats, scope
from ..statements import (
    Apply,
    Assign,
    Break,
    Call,
    Continue,
    Execute,
    Expression,
    For,
    ForEach,
    If,
    Infix,
    Name,
    Number,
    Operate,
    Scalar,
    Statement,
    Table,
    Tuple,
)
from .constants import Constants
from .scalar import ScalarKernel

Statements = list[Statement]


@dataclass
class NumPyLoop(Lowering):
    """Rows: a body takes its own, and puts back what it assigned.

    Attributes
    ----------
    max_inline_cost_in_turns
        The most that a body costs in one that repeats, to be done for all rows.
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

    max_inline_cost_in_turns: int = 0
    rows: Collection[str] = ()
    alone: ScalarKernel = field(default_factory=lambda: ScalarKernel(Constants()))
    far: dict[str, str] = field(default_factory=dict)
    short: set[str] = field(default_factory=set)
    turning: str = ""

    def body(
        self,
        nodes: Sequence[Node],
        names: dict[str, str],
        after: set[str],
        count: str = "shots",
        depth: int = 0,
    ) -> Statements:
        """Return the statements of nodes, given the names of what is known; these are changed.

        Parameters
        ----------
        nodes, after
            The nodes in order, and the variables that are read after them.
        names
            The name in NumPy of each variable that is known; it is changed.
        count, depth
            The name of the number of shots at hand, and the number of bodies around them.
        """
        found: Statements = []
        if self._given_rows(nodes):
            found.append(_assign(_room(depth), "room", Name(count)))
        for index, node in enumerate(nodes):
            later = live_before(nodes[index + 1 :], after)
            if isinstance(node, ir.Call):
                found.append(self._call(node, names, depth, depth))
            elif isinstance(node, ir.ForEach):
                found += self._each(node, names, count, later, depth)
            elif isinstance(node, ir.If) and self._for_all(node):
                found += self._chosen(node, names, later, depth)
            else:
                found += self._rows(node, names, count, later, depth)
        return found

    def _given_rows(self, nodes: Sequence[Node]) -> bool:
        """Return whether a kernel that all shots of a body call gets rows to write into."""
        return any(
            node.kernel.name in self.rows
            if isinstance(node, ir.Call)
            else isinstance(node, ir.If) and self._for_all(node) and self._given_rows(node.body)
            for node in nodes
        )

    def _for_all(self, node: ir.If) -> bool:
        """Return whether a body is executed for all rows; an iterating body takes few rows anew."""
        most = self.max_inline_cost_in_turns if self.turning else self.max_inline_cost
        return self.cheap(node) and self._cost(node) <= most

    def _near(self, nodes: Sequence[Node], after: set[str]) -> set[str]:
        """Return the variables that all rows of a body need, not only those of a guarded body."""
        near: set[str] = set()
        for index, node in enumerate(nodes):
            if isinstance(node, ir.Call):
                near |= reads([node])
                continue
            later = live_before(nodes[index + 1 :], after)
            if isinstance(node, ir.ForEach):
                near |= reads([node]) | (set(writes([node])) & later)
                continue
            near |= {node.truth, *scope(node, later).gives}
            if isinstance(node, ir.While):
                near |= set(scope(node, later).takes)
            elif self._for_all(node):
                near |= self._near(node.body, later)
        return near

    def _call(
        self, node: ir.Call, names: dict[str, str], depth: int, shots_depth: int
    ) -> Statement:
        kernel = node.kernel
        function = kernel.name
        given = [self._given(value, names, kernel.single) for value in node.arguments]
        if function in self.rows:
            if any(isinstance(value, str) for value in node.arguments):
                given.append(Name(_room(shots_depth)))
            else:
                function, given = "_fixed", [Name(function), *given]
        for variable in node.assigned.values():
            names[variable] = local(variable, depth)
        if kernel.single:
            self.short |= {v for v, kind in node.kinds.items() if kind == "single"}
        targets = [
            names[node.assigned[o]] if o in node.assigned else "_" for o in kernel.output_names
        ]
        while targets[-1] == "_" and len(targets) > 1 and targets[-2] == "_":
            targets.pop()
        if targets[-1] == "_":
            targets[-1] = "*_"
        return Call(function, tuple(given), tuple(targets))

    def _given(self, value: Value, names: Mapping[str, str], single: bool) -> Expression:
        """Return an argument of a kernel; a kernel in single precision rounds it itself."""
        if not isinstance(value, str):
            return Number(float(value))
        own = Name(names[value])
        return Apply("_double", (own,)) if value in self.short and not single else own

    def _each(
        self, node: ir.ForEach, names: dict[str, str], count: str, later: set[str], depth: int
    ) -> Statements:
        """Return a loop over the rows of a table; what goes from row to row keeps its name."""
        after = carried(node, later)
        kept = {v: local(v, depth) for v in sorted(set(writes(node.body)) & after)}
        found: Statements = [
            Assign(Name(own), Name(names[name])) for name, own in kept.items() if names[name] != own
        ]
        inside = names | kept | {name: local(name, depth) for name in node.names}
        rows = [
            tuple(Name(names[v]) if isinstance(v, str) else Number(float(v)) for v in row)
            for row in node.rows
        ]
        table: Expression = Tuple(tuple(map(Tuple, rows)))
        if node.groups is not None:
            found.append(Table("_table", "", tuple(rows)))
            grouped, table = self._grouped(node, node.groups, names)
            found += grouped
        body = self.body(node.body, inside, after, count, depth)
        found.append(ForEach(tuple(inside[name] for name in node.names), table, tuple(body)))
        assert all(inside[name] == own for name, own in kept.items()), "a name changed"
        names |= kept
        return found

    def _grouped(
        self, node: ir.ForEach, groups: ir.BoundingVolumes, names: Mapping[str, str]
    ) -> tuple[Statements, Expression]:
        """Return the groups of a table, and the rows of those that some shots come near."""
        members = [tuple(map(Scalar, (g.first, g.past, g.after))) for g in groups.members]
        table = Name("_table")
        sizes = tuple(
            Apply("_column", (table, Scalar(node.names.index(v))))
            if v in node.names
            else Name(names[v])
            for v in groups.box.arguments
            if isinstance(v, str)
        )
        seen = [v for v in groups.near.arguments if isinstance(v, str) and v in groups.test_reads]
        box, near = groups.box.kernel, groups.near.kernel
        assert groups.near.arguments[len(seen) :] == box.output_names, near.name
        found: Statements = [
            Table("_members", "", tuple(members)),
            Assign(Name("_sizes"), Tuple(sizes)),
            Assign(Name("_seen"), Tuple(tuple(Name(names[v]) for v in seen))),
        ]
        asked = ("_table", "_members", box.name, "_sizes", near.name, "_seen")
        return found, Apply("_near", tuple(map(Name, asked)))

    def _chosen(
        self, node: ir.If, names: dict[str, str], later: set[str], depth: int
    ) -> Statements:
        """Return a cheap body for all rows, and what chooses."""
        own, inside, truth = scope(node, later), dict(names), names[node.truth]
        found: Statements = []
        for body in node.body:
            assert isinstance(body, ir.Call)
            found.append(self._call(body, inside, depth + 1, depth))
        new = _tuple(inside[name] for name in own.gives)
        old = _tuple(names[name] for name in own.gives)
        names |= {name: local(name, depth) for name in own.gives}
        given = (Name(truth), new, old)
        return [*found, Call("_choose", given, tuple(names[name] for name in own.gives))]

    def _rows(
        self,
        node: ir.If | ir.While,
        names: dict[str, str],
        count: str,
        later: set[str],
        depth: int,
    ) -> Statements:
        """Return a body for the rows that need it, those that are few one by one."""
        own = scope(node, later)
        rows, own_count = self.fresh("rows"), self.fresh("count")
        plain = all(isinstance(n, ir.Call) for n in node.body) and isinstance(node, ir.If)
        truth = Name(names[node.truth])
        taking = Call("_most" if plain else "_rows", (truth, Name(count)), (rows, own_count))
        far = self._far(node, own, later, rows) if isinstance(node, ir.While) else []
        one, begin = "", Statements()
        if repeats(node) and own.gives and not set(own.takes) - set(names):
            takes = {*own.takes, *own.gives} if isinstance(node, ir.While) else {*own.takes}
            near = sorted(takes - set(far))
            one = self.alone.function(node, near + far, own.gives, self.short)
            begin.append(self._copies(own, names, count, depth))
            given = (
                *(Name(rows), Name(rows), _tuple(names[name] for name in near + far), Tuple(())),
                _tuple(local(name, depth) for name in own.gives),
                *((Scalar(node.limit),) if isinstance(node, ir.While) else ()),
            )
            begin.append(Execute(Apply("_one_by_one", (Name(one), *given))))
        if isinstance(node, ir.While):
            body = self._turns(node, names, own, (rows, own_count), count, later, depth, far, one)
        else:
            body = self._taken(node, names, own, (rows, own_count), count, later, depth, plain)
        kept = tuple(
            Assign(Name(local(name, depth)), Name(names[name]))
            for name in own.gives
            if names[name] != local(name, depth)
        )
        for name in own.gives:
            names[name] = local(name, depth)
        some: Statement = If(Name(own_count), tuple(body), kept)
        if one:
            few = Infix("<=", Name(own_count), Name("ALONE"))
            any_shot = Infix("<", Scalar(0), Name(own_count))
            some = If(Infix("and", any_shot, few), tuple(begin), (some,))
        return [taking, some]

    def _copies(self, own: Scope, names: Mapping[str, str], count: str, depth: int) -> Statement:
        """Return columns of its own for what a body assigns."""
        columns = (Name(names[name]) for name in own.gives)
        return Call("_copies", (Name(count), *columns), tuple(local(n, depth) for n in own.gives))

    def _taken(
        self,
        node: ir.If,
        names: Mapping[str, str],
        own: Scope,
        own_rows: tuple[str, str],
        count: str,
        later: set[str],
        depth: int,
        plain: bool,
    ) -> Statements:
        """Return a body for some rows, what it needs taken before and put back after it."""
        rows, own_count = own_rows
        outside = set(own.takes) - set(names)
        found: Statements = []
        if outside:
            found.append(_assign("_far", "_of", Name(self.turning), Name(rows)))
        inside = {name: local(name, depth + 1) for name in own.takes}
        found += _taken("_far", {inside[n]: self.far[n] for n in inside if n in outside})
        found += _taken(rows, {inside[n]: names[n] for n in inside if n not in outside})
        found += self.body(node.body, inside, later, own_count, depth + 1)
        given = (
            *(Name(rows), Name(count), _tuple(names[name] for name in own.gives)),
            *(_tuple(inside[name] for name in own.gives), *[Name(names[node.truth])] * plain),
        )
        return [*found, Call("_put", given, tuple(local(name, depth) for name in own.gives))]

    def _turns(
        self,
        node: ir.While,
        names: dict[str, str],
        own: Scope,
        own_rows: tuple[str, str],
        count: str,
        later: set[str],
        depth: int,
        far: Sequence[str],
        one: str,
    ) -> Statements:
        """Return a body that repeats; rows that are done are stored, the others taken anew."""
        (rows, own_count), outer = map(Name, own_rows), (self.far, self.turning)
        self.turning = rows.name
        self.far = {name: names[name] for name in far}
        inside = {name: local(name, depth + 1) for name in own.takes if name not in far}
        found = _taken(rows.name, {inside[name]: names[name] for name in inside})
        found.append(self._copies(own, names, count, depth))
        turn = self.fresh("turn") if one else "_"
        start, wanted = dict(inside), later | set(own.takes) | {node.truth}
        body = self.body(node.body, inside, wanted, own_count.name, depth + 1)
        assert all(inside[name] == value for name, value in start.items()), "a name changed"
        going, truth = Name(self.fresh("going")), Name(inside[node.truth])
        done, many = Name("_done"), Apply("len", (going,))
        body += [
            _assign(going.name, "_where_true", truth),
            If(Infix("==", many, own_count), (Continue(),)),
            _assign("_done", "_where_true", Operate("not", (truth,))),
        ]
        columns = _tuple(local(name, depth) for name in own.gives)
        new = _tuple(inside[name] for name in own.gives)
        body += [
            _execute("_store", columns, Apply("_of", (rows, done)), new, done),
            _assign(rows.name, "_of", rows, going),
            Assign(own_count, many),
            If(Infix("==", own_count, Scalar(0)), (Break(),)),
        ]
        near = sorted({*own.takes, *own.gives} - set(far))
        if one:
            given = (
                *(rows, going, _tuple(inside[name] for name in near)),
                *(_tuple(names[name] for name in far), _tuple(local(n, depth) for n in own.gives)),
                Infix("-", Scalar(node.limit - 1), Name(turn)),
            )
            few = (_execute("_one_by_one", Name(one), *given), Break())
            body.append(If(Infix("<=", own_count, Name("ALONE")), few))
        body += _taken(going.name, {inside[name]: inside[name] for name in near})
        last = _execute("_store", columns, rows, new, Name("None"))
        found.append(For(turn, Scalar(node.limit), tuple(body), (last,)))
        self.far, self.turning = outer
        return found

    def _far(self, node: ir.While, own: Scope, later: set[str], rows: str) -> list[str]:
        """Return the variables that some shots of a repeated body need and it never changes."""
        outer, self.turning = self.turning, rows
        wanted = later | set(own.takes) | {node.truth}
        near = self._near(node.body, wanted) | set(writes(node.body)) | {node.truth}
        self.turning = outer
        return sorted(set(own.takes) - near)


def _taken(rows: str, names: Mapping[str, str]) -> Statements:
    """Return the statement that takes rows of columns, given each column by the new name."""
    columns = tuple(map(Name, names.values()))
    return [Call("_taken", (Name(rows), *columns), tuple(names))] if names else []


def _assign(name: str, function: str, *arguments: Expression) -> Statement:
    """Return the assignment of a function's value to a variable."""
    return Assign(Name(name), Apply(function, arguments))


def _execute(function: str, *arguments: Expression) -> Statement:
    """Return the call of a function for its effect."""
    return Execute(Apply(function, arguments))


def _tuple(names: Iterable[str]) -> Expression:
    """Return variables as a tuple."""
    return Tuple(tuple(map(Name, names)))


def _room(depth: int) -> str:
    """Return the rows for as many shots as there are so many bodies deep."""
    return f"_room_{depth}"


def local(name: str, depth: int) -> str:
    """Return a variable as a name in a stage in NumPy, so many bodies deep.

    Parameters
    ----------
    name, depth
        The variable, and the number of bodies around it, 0 in the stage itself.
    """
    return f"_{name}_{depth}"
