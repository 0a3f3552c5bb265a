"""Lowering the event loop for C: passes over lists of the shots that do the same.

A body in which something repeats is not executed for all lanes with some of them masked: the shots
that need it are packed into a worklist of their own, on which all lanes work. A body that repeats
takes the next shots of its worklist into the lanes that are done. Results go back to the rows they
came from. Of a body that nearly all shots enter the others are idle lanes, which cost less than to
pack its shots; what repeats within it has its worklist.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.event_tree import Node, live_before, reads, walk, writes
from hoopgen.derive.ir.kernel import Kind

from .. import visitors
from ..lowering import carried, repeats, scope
from ..statements import (
    Apply,
    Block,
    Choose,
    Declare,
    Expression,
    For,
    If,
    Infix,
    Item,
    Name,
    Scalar,
    Statement,
    Table,
)
from .hierarchy import GroupContext
from .inner_columns import columns_within, read_within
from .masked_loop import Around, Statements
from .spelling import TYPES, any_lane, at, both, load, numbered_column, offset, store
from .transfers import MIN_COPIED
from .turns import TURNING, TurnLoop


@dataclass(frozen=True)
class Insertion:
    """Statements that come before the node of an index, and the variables that they declare.

    Those that declare variables come before each run of nodes that reads one of these.
    """

    index: int
    statements: tuple[Statement, ...]
    declares: Mapping[str, Kind] = field(default_factory=dict)

    def reads(self) -> set[str]:
        """Return the variables of a shot that they may read."""
        return visitors.reads(self.statements)


def _within(
    inserted: Insertion | None, nodes: Sequence[Node], start: int, end: int
) -> Insertion | None:
    """Return the insertion for a run of the nodes, if it belongs there."""
    if inserted is None:
        return None
    if inserted.declares:
        read = reads(nodes[start:end]) & set(inserted.declares)
        return replace(inserted, index=0) if read else None
    if not start <= inserted.index <= end:
        return None
    return replace(inserted, index=inserted.index - start)


def without_rows(nodes: Sequence[Node]) -> tuple[Node, ...]:
    """Return the tree with no rows in its tables, whose variables are loaded row by row."""
    changed: list[Node] = []
    for node in nodes:
        if not isinstance(node, ir.Call):
            node = replace(node, body=without_rows(node.body))
        changed.append(replace(node, rows=()) if isinstance(node, ir.ForEach) else node)
    return tuple(changed)


@dataclass
class CompactedLoop(TurnLoop):
    """Passes over lists, lowered stage by stage.

    Attributes
    ----------
    min_outlined_cost
        What is rarely done and costs more has a list of its own.
    beside
        Statements for the first pass to come: what is done beside it.
    frame
        The list that the pass at hand goes over.
    inner
        By a guarded body of the pass at hand, the columns that it stores; whether it loads them.
    inner_reads
        By a rare body of the pass at hand, the columns that it loads and does not store.
    over_rows
        Whether the passes at hand are repeated for each row of a table.
    """

    min_outlined_cost: int = 0
    beside: Statements = field(default_factory=list)
    frame: GroupContext = field(default_factory=lambda: GroupContext("", {}))
    inner: dict[int, dict[str, bool]] = field(default_factory=dict)
    inner_reads: dict[int, list[str]] = field(default_factory=dict)
    over_rows: bool = False

    def passes(
        self,
        nodes: Sequence[Node],
        frame: GroupContext,
        after: set[str],
        inserted: Insertion | None = None,
    ) -> Statements:
        """Return the statements of nodes for all shots of a list, given what is needed after.

        Parameters
        ----------
        nodes
            The nodes, in order.
        frame
            The variables of the list at hand, and the columns in which they lie.
        after
            The variables that are read after the nodes; no other one is stored.
        inserted
            Statements to put before one of the nodes; None for none.

        Returns
        -------
        list of Statement
            Passes over the list's lanes, one for each run of nodes between two lists.
        """
        start, found = 0, Statements()
        for index, node in enumerate(nodes):
            if isinstance(node, ir.Call) or not self._listed(node):
                continue
            later = live_before(nodes[index + 1 :], after)
            before, own = _within(inserted, nodes, start, index), Statements()
            if isinstance(node, ir.ForEach) or self._in_place(node):
                if start < index or before:
                    needed = live_before(nodes[index:], after)
                    self._pass(own, nodes[start:index], frame, needed, None, before)
                if isinstance(node, ir.ForEach):
                    own += self._table_rows(node, frame, later)
                else:
                    gives = frozenset(scope(node, later).gives)
                    within = replace(frame, guard=node.truth, outer=gives)
                    own += self.passes(node.body, within, set(gives))
            else:
                listed = self._pass(own, nodes[start:index], frame, later, node, before)
                own += self._of_list(node, frame, listed, later)
            # Lists of one name follow one another, and share their columns.
            found.append(Block(tuple(own), flush=True))
            start = index + 1
        if start < len(nodes):
            last = _within(inserted, nodes, start, len(nodes))
            self._pass(found, nodes[start:], frame, after, None, last)
        return found

    def _of_list(
        self, node: ir.If | ir.While, frame: GroupContext, own: GroupContext, later: set[str]
    ) -> Statements:
        """Return the statements for the shots of a packed list."""
        if isinstance(node, ir.While):
            return [self._turns(node, frame, own, later)]
        gives = scope(node, later).gives
        body = self.passes(node.body, own, set(gives))
        if node.rare:
            body = [self._outlined(node.truth, own, body)]
        return [*body, self._return(frame, own, gives)]

    def _table_rows(self, node: ir.ForEach, frame: GroupContext, later: set[str]) -> Statements:
        """Return passes for each row of a table."""
        outer = self.parameters, self.job, self.bases, self.over_rows
        self.frame, self.over_rows = frame, True
        row = self.fresh("k")
        if node.groups is None:
            made, bases, numbers = self.table(node, row)
            around = self._over_table(node, row, made)
        else:
            name, bases, numbers = self._boxes(node, node.groups, row)
            frame, around = self._near(node.groups, name, row, frame)
        assert not (frame.prefix and bases), (
            f"a table with a worklist of its own is within the worklist {frame.prefix!r}, which "
            f"has no columns for the parameters of the table's rows ({', '.join(bases)}): where "
            "these differ by shot, columns would be read that nothing has written"
        )
        own = [Declare(name, "V", value, constant=True) for name, value in numbers.items()]
        self.parameters = (*self.parameters, *bases)
        self.job = (*self.job, *numbers)
        self.bases = self.bases | bases
        body = self.passes(node.body, frame, carried(node, later))
        self.parameters, self.job, self.bases, self.over_rows = outer
        return around([*own, *body])

    def _over_table(self, node: ir.ForEach, row: str, made: Statements) -> Around:
        """Return the function that puts statements into a loop over a table, after the table."""
        return lambda body: [*made, For(row, Scalar(len(node.rows)), tuple(body))]

    def table(
        self, node: ir.ForEach, row: str
    ) -> tuple[Statements, dict[str, Expression], dict[str, Expression]]:
        """Return a table.

        Parameters
        ----------
        node
            The loop over surfaces of one kind.
        row
            The name of the variable that counts its rows.

        Returns
        -------
        tuple
            Its declaration; and of the row at hand, by name, the arrays of its variables, and its
            numbers.
        """
        columns = dict(zip(node.names, node.columns, strict=True))
        made: Statements = []
        found: list[dict[str, Expression]] = []
        for kind, wanted in (("static const int", str), ("static const double", float)):
            own = {name: c for name, c in columns.items() if isinstance(c[0], wanted)}
            table = self.fresh("t")
            at_hand = Item(Name(table), Name(row))
            found.append({name: Item(at_hand, Scalar(k)) for k, name in enumerate(own)})
            rows = (tuple(map(self._entry, values)) for values in zip(*own.values(), strict=True))
            made += [Table(table, kind, tuple(rows))] if own else []
        places, numbers = found
        bases = {name: self._base(place) for name, place in places.items()}
        return made, bases, {name: Apply("K", (value,)) for name, value in numbers.items()}

    def _entry(self, value: str | float) -> Expression:
        """Return an entry of a table: a number, or that of a parameter."""
        return Scalar(self.parameters.index(value) if isinstance(value, str) else value)

    def _base(self, number: Expression) -> Expression:
        """Return the array of the parameter of a number, in the list at hand."""
        shared = numbered_column("", number)
        prefix = TURNING if self.turning else self.frame.prefix
        if not prefix:
            return shared
        self.parameter_lists[prefix] = None
        return Choose(Name("varying"), numbered_column(prefix, number), shared)

    def row(self, node: ir.ForEach, mask: str) -> tuple[Around, dict[str, Expression]]:
        """Return the same for the rows of lanes of a pass, and the values of the row at hand.

        Arguments as for `hoopgen.codegen.c.masked_loop.MaskedLoop.row`.
        """
        row = self.fresh("k")
        if node.groups is None:
            made, bases, numbers = self.table(node, row)
            around = self._over_table(node, row, made)
        else:
            groups = node.groups
            name, bases, numbers = self._boxes(node, groups, row)
            near = Declare("_near", "int", self._any_near(groups, Name(mask)), constant=True)

            def around(body: Sequence[Statement]) -> Statements:
                return self._groups(groups, name, row, [near], Name("_near"), body)

        if not self.turning:
            varying = Infix("&", Name("i"), Name("varying"))
            bases = {name: offset(base, varying) for name, base in bases.items()}
        loaded = {name: load("double", base) for name, base in bases.items()}
        return around, loaded | numbers

    def _listed(self, node: ir.If | ir.While | ir.ForEach) -> bool:
        """Return whether a body has a worklist: without iterations packing mostly costs more."""
        return repeats(node) or self._long(node)

    def _in_place(self, node: ir.If | ir.While) -> bool:
        """Return whether a body with a worklist within has none itself: nearly all shots enter."""
        return isinstance(node, ir.If) and node.usual and not self.over_rows

    def _long(self, node: Node) -> bool:
        """Return whether a body is executed rarely and costs much."""
        cost = sum(self.costs[n.kernel.name] for n in walk([node]) if isinstance(n, ir.Call))
        return isinstance(node, ir.If) and node.rare and cost > self.min_outlined_cost

    def _pass(
        self,
        found: Statements,
        nodes: Sequence[Node],
        frame: GroupContext,
        later: set[str],
        cut: ir.If | ir.While | None,
        inserted: Insertion | None = None,
    ) -> GroupContext:
        """Append a pass over every row of a list, which packs those that go on to a body.

        Returns
        -------
        GroupContext
            The list of these.
        """
        written = writes(nodes)
        stored = {name: written[name] for name in sorted(written) if name in later}
        takes = scope(cut, later).takes if cut else ()
        shared = inserted.reads() if inserted else set()
        wanted = set(stored) | set(takes) | ({cut.truth} if cut else set())
        wanted |= shared - set(written)
        outer = frame.outer & set(written)
        need = live_before(without_rows(nodes), wanted) | outer
        own_columns = set(stored) & set(frame.known)
        asked = shared | ({cut.truth} if cut else set())
        self.inner = columns_within(nodes, own_columns, asked, self.cheap)
        inside = {name for names in self.inner.values() for name in names}
        alone = {name for names in self.inner.values() for name, loaded in names.items() if loaded}
        # What the pass only hands on is loaded where a row of lanes has something to pack.
        used = set(stored) | ({cut.truth} if cut else set()) | (shared - set(written))
        direct = live_before(without_rows(nodes), used) | outer
        late = (need - direct - set(written)) & set(frame.known) | alone & set(takes)
        need -= alone | late
        elsewhere = used | outer | set(written)
        self.inner_reads = read_within(nodes, need & set(frame.known) - elsewhere, self.cheap)
        within = {name for names in self.inner_reads.values() for name in names}
        need, late = need - within, late | within & set(takes)
        own = GroupContext(f"{frame.prefix}{cut.truth}_" if cut else "", {})
        copied: list[str] = []
        self.frame = frame
        self.named.clear()
        begin, self.beside = self.beside, []
        begin += self._fix(nodes, frame)
        known: dict[str, Kind] = dict.fromkeys(self.job, "double")
        body: Statements = []
        for name in sorted(need & set(frame.known)):
            kind = known[name] = frame.known[name]
            body.append(Declare(name, TYPES[kind], load(kind, at(frame.column(name), "i"))))
        known |= dict.fromkeys(self.parameters, "double")
        known |= {name: frame.known[name] for name in late}
        body += self._with_insertion(nodes, known, set(outer), wanted, inserted)
        for name, kind in stored.items():
            self._column(frame, name, kind)
            if name not in inside:
                body.append(store(kind, at(frame.column(name), "i"), Name(name)))
            frame.known[name] = kind
        if cut:
            homes = set(stored) | set(frame.known) - set(written)
            copied = [] if frame.prefix else [n for n in takes if n in homes and n != cut.truth]
            copied = copied if len(copied) >= MIN_COPIED else []
            loaded = sorted(late - set(copied))
            body += self._pack(cut, frame, own, takes, known, copied, loaded)
        read = visitors.live_before(body)
        body[:0] = [
            Declare(name, "V", self._parameter(frame, name), constant=True)
            for name in sorted(need & set(self.parameters) & read)
        ]
        begin += body
        if frame.guard or "rows" in read:
            left = Infix("-", Name(frame.count), Name("i"))
            rows: Expression = Apply("mask_first_n", (left,))
            if frame.guard:
                rows = both(rows, load("truth", at(frame.column(frame.guard), "i")))
                begin = [If(any_lane(Name("rows")), tuple(begin))]
            begin.insert(0, Declare("rows", "M", rows, constant=True))
        if cut:
            found += [Declare(own.count, "size_t", Scalar(0)), *self._parameter_numbers(own, takes)]
        found.append(frame.over(begin))
        found += [self._fill(own, takes), *self._copy(frame, own, copied)] if cut else []
        return own

    def beside_body(self, node: ir.If, known: dict[str, Kind]) -> tuple[Statements, Statements]:
        """Load and store what the body alone writes.

        Arguments as for `hoopgen.codegen.c.masked_loop.MaskedLoop.beside_body`.
        """
        begin, finish = Statements(), Statements()
        for name in self.inner_reads.get(id(node), ()):
            kind = known[name] = self.frame.known[name]
            begin.append(Declare(name, TYPES[kind], load(kind, at(self.frame.column(name), "i"))))
        for name, loaded in self.inner.get(id(node), {}).items():
            kind = self.frame.known[name]
            place = at(self.frame.column(name), "i")
            if loaded:
                begin.append(Declare(name, TYPES[kind], load(kind, place)))
                known[name] = kind
            finish.append(store(kind, place, Name(name)))
        return begin, finish

    def _with_insertion(
        self,
        nodes: Sequence[Node],
        known: dict[str, Kind],
        outer: set[str],
        wanted: set[str],
        inserted: Insertion | None,
    ) -> Statements:
        """Return the statements of nodes, and those that are inserted before one of them."""
        if inserted is None:
            return self.body(nodes, known, outer, "rows", wanted)
        before, rest = nodes[: inserted.index], nodes[inserted.index :]
        between = live_before(rest, wanted) | inserted.reads()
        found = self.body(before, known, outer, "rows", between)
        known |= inserted.declares
        return [*found, *inserted.statements, *self.body(rest, known, outer, "rows", wanted)]
