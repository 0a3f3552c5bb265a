"""Printing the event loop for C: passes over lists of the shots that do the same.

A body in which something repeats is not done beside shots that sit out: those that need it are
packed into a list of their own, on which all lanes work. A body that repeats takes the next shots
of its list into the lanes that are done. What was found goes back to the row it came from.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ground.kernel import Kind
from hoopgen.derive.ground.tree import Do, Each, Guard, Node, Repeat, live_before, writes

from .groups import Frame
from .loop import (
    EXPANDED,
    LOADED,
    NONE,
    STORED,
    TYPES,
    Note,
    bare,
    carried,
    repeats,
    scope,
    within,
    written_within,
)
from .transfers import CTransfers


@dataclass
class CLists(CTransfers):
    """Passes over lists, printed stage by stage.

    Attributes
    ----------
    beside
        A line for the first pass to come: what is done beside it.
    frame
        The list that the pass at hand goes over.
    inner
        By a guarded body of the pass at hand, the columns that it stores; whether it loads them.
    """

    beside: str = ""
    frame: Frame = field(default_factory=lambda: Frame("", {}))
    inner: dict[int, dict[str, bool]] = field(default_factory=dict)

    def passes(self, nodes: Sequence[Node], frame: Frame, after: Iterable[str], note: Note) -> None:
        """Print nodes for all shots of a list, given what is needed after them."""
        self._rows(nodes, frame, set(after), note)

    def _rows(
        self,
        nodes: Sequence[Node],
        frame: Frame,
        after: set[str],
        note: Note | None = None,
    ) -> None:
        start = 0
        for index, node in enumerate(nodes):
            if isinstance(node, Do) or not self._listed(node):
                continue
            later = live_before(nodes[index + 1 :], after)
            # Lists of one name follow one another, and share their columns.
            self.lines.append("{")
            if isinstance(node, Each):
                before = within(note, start, index)
                if start < index or before:
                    needed = live_before(nodes[index:], after)
                    self._pass(nodes[start:index], frame, needed, None, before)
                self._table_rows(node, frame, later)
                self.lines.append("}")
                start = index + 1
                continue
            own = self._pass(nodes[start:index], frame, later, node, within(note, start, index))
            if isinstance(node, Guard):
                first = len(self.lines)
                self._rows(node.body, own, set(scope(node, later).gives))
                if node.rare:
                    self._set_apart(node.truth, own, first)
                self._return(frame, own, scope(node, later).gives)
            else:
                self._turns(node, frame, own, later)
            self.lines.append("}")
            start = index + 1
        if start < len(nodes):
            last = within(note, start, len(nodes))
            self._pass(nodes[start:], frame, after, None, last)

    def _table_rows(self, node: Each, frame: Frame, later: set[str]) -> None:
        """Print passes for each row of a table."""
        outer = self.parameters, self.job, self.bases
        self.frame = frame
        row = self.fresh("k")
        if node.groups is None:
            bases, numbers = self.table(node, row, "")
            self.lines.append(f"for (size_t {row} = 0; {row} < {len(node.rows)}; {row}++) {{")
        else:
            name, bases, numbers = self._boxes(node, node.groups, row)
            frame = self._near(node.groups, name, row, frame)
        self.lines += [f"const V {name} = {value};" for name, value in numbers.items()]
        self.parameters = (*self.parameters, *bases)
        self.job = (*self.job, *numbers)
        self.bases = self.bases | bases
        self._rows(node.body, frame, carried(node, later))
        self.parameters, self.job, self.bases = outer
        self.lines += ["}"] * (1 if node.groups is None else 2)

    def table(self, node: Each, row: str, indent: str) -> tuple[dict[str, str], dict[str, str]]:
        """Print a table.

        Returns
        -------
        tuple
            Of the row at hand: by name, the arrays of its variables, and its numbers.
        """
        columns = dict(zip(node.names, node.columns, strict=True))
        found: list[dict[str, str]] = []
        for kind, wanted in (("const double *const", str), ("static const double", float)):
            own = {name: c for name, c in columns.items() if isinstance(c[0], wanted)}
            table = self.fresh("t")
            found.append({name: f"{table}[{row}][{k}]" for k, name in enumerate(own)})
            if own:
                self.lines.append(f"{indent}{kind} {table}[][{len(own)}] = {{")
                for values in zip(*own.values(), strict=True):
                    given = (self._source(v) if isinstance(v, str) else repr(v) for v in values)
                    self.lines.append(f"{indent}    {{{', '.join(given)}}},")
                self.lines.append(f"{indent}}};")
        bases, numbers = found
        return bases, {name: f"K({value})" for name, value in numbers.items()}

    def row(self, node: Each, indent: str, mask: str) -> dict[str, str]:
        """Print the same; return the values of the row at hand, for the rows of the pass."""
        row = self.fresh("k")
        if node.groups is None:
            bases, numbers = self.table(node, row, indent)
            line = f"for (size_t {row} = 0; {row} < {len(node.rows)}; {row}++) {{"
            self.lines.append(f"{indent}{line}")
        else:
            name, bases, numbers = self._boxes(node, node.groups, row)
            self._group(node.groups, name, indent)
            near = self._any_near(node.groups, mask)
            self.lines.append(f"{indent}    const int near = {near};")
            self._members(name, row, "near", indent)
        return {k: f"lanes_load({base} + (i & varying))" for k, base in bases.items()} | numbers

    def _source(self, name: str) -> str:
        """Return the array of a parameter in the list that is gone over."""
        shared = self.bases.get(name, f"lists->{name}")
        if not self.frame.prefix:
            return shared
        return f"varying ? {self.frame.column(name)} : {shared}"

    def _listed(self, node: Guard | Repeat | Each) -> bool:
        """Whether a body has a list of its own: for most without turns the packing costs more."""
        return repeats(node) or self.long(node)

    def _pass(
        self,
        nodes: Sequence[Node],
        frame: Frame,
        later: set[str],
        cut: Guard | Repeat | None,
        note: Note | None = None,
    ) -> Frame:
        """Print nodes for every row of a list; pack those that go on to a body of their own."""
        written = writes(nodes)
        stored = {name: written[name] for name in sorted(written) if name in later}
        takes = scope(cut, later).takes if cut else ()
        wanted = set(stored) | set(takes) | ({cut.truth} if cut else set())
        wanted |= note.reads - set(written) if note else set()
        need = live_before(bare(nodes), wanted)
        shared = note.reads if note else frozenset()
        guards = [node for node in nodes if isinstance(node, Guard) and not self.cheap(node)]
        self.inner = {
            id(node): written_within(node, nodes, set(stored) & set(frame.known), shared)
            for node in (guards if cut is None else ())
        }
        inside = {name for names in self.inner.values() for name in names}
        need -= {name for names in self.inner.values() for name, loaded in names.items() if loaded}
        own = Frame(f"{frame.prefix}{cut.truth}_" if cut else "", {})
        self.frame = frame
        line = self.lines.append
        if cut:
            line(f"size_t {own.count} = 0;")
        self.lines += frame.over
        first = len(self.lines)
        if self.beside:
            line(f"    {self.beside}")
            self.beside = ""
        known: dict[str, Kind] = dict.fromkeys(self.job, "double")
        self._fix(nodes, frame)
        loads = len(self.lines)
        for name in sorted(need):
            if name in frame.known:
                known[name] = frame.known[name]
                value = LOADED[known[name]].format(f"{frame.column(name)} + i")
                line(f"    {TYPES[known[name]]} {name} = {value};")
        for name in self.parameters:
            known[name] = "double"
        self._noted(nodes, known, wanted, note)
        for name, kind in stored.items():
            self._column(frame, name, kind)
            if name in inside:
                frame.known[name] = kind
                continue
            line(f"    {STORED[kind].format(f'{frame.column(name)} + i', name)};")
            frame.known[name] = kind
        if cut:
            self._pack(cut, frame, own, takes, known)
        line("}")
        self.lines[loads:loads] = [
            f"    const V {name} = {self._parameter(frame, name)};"
            for name in sorted(need & set(self.parameters))
            if self._read(name, loads)
        ]
        if self._read("rows", first):
            self.lines.insert(first, f"    const M rows = lanes_first({frame.count} - i);")
        if cut:
            self._fill(own, takes)
        return own

    def beside_body(
        self, node: Guard, known: dict[str, Kind], indent: str
    ) -> tuple[list[str], list[str]]:
        """Load and store what the body alone writes."""
        begin, finish = [], []
        for name, loaded in self.inner.get(id(node), {}).items():
            kind = self.frame.known[name]
            place = f"{self.frame.column(name)} + i"
            if loaded:
                begin.append(f"{indent}{TYPES[kind]} {name} = {LOADED[kind].format(place)};")
                known[name] = kind
            finish.append(f"{indent}{STORED[kind].format(place, name)};")
        return begin, finish

    def _noted(
        self, nodes: Sequence[Node], known: dict[str, Kind], wanted: set[str], note: Note | None
    ) -> None:
        if note is None:
            self._body(nodes, known, set(), "rows", "    ", wanted)
            return
        between = live_before(nodes[note.index :], wanted) | note.reads
        self._body(nodes[: note.index], known, set(), "rows", "    ", between)
        self.lines.extend("    " + text for text in note.lines)
        known |= note.gives
        self._body(nodes[note.index :], known, set(), "rows", "    ", wanted)

    def _turns(self, node: Repeat, frame: Frame, own: Frame, later: set[str]) -> None:
        """Print a body that repeats, the lanes that are done given the next shots of the list."""
        scoped = scope(node, later)
        line = self.lines.append
        line("{")
        line("    size_t taken = 0, busy = 0;")
        line("    M active = lanes_nowhere();")
        line("    V row = K(0.0), turns = K(0.0);")
        loads = len(self.lines)
        for name, kind in own.known.items():
            line(f"    {TYPES[kind]} {name} = {NONE[kind]};")
        line("    for (;;) {")
        line(f"        if (taken < {own.count} && busy + LANES_SPARE <= LANES_WIDTH) {{")
        line("            const M idle = lanes_not(active);")
        line(f"            row = lanes_expand({own.column('row')} + taken, idle, row);")
        line("            turns = lanes_select(idle, K(0.0), turns);")
        for name, kind in own.known.items():
            value = EXPANDED[kind].format(f"{own.column(name)} + taken", name)
            line(f"            {name} = {value};")
        expands = len(self.lines)
        self._fix(node.body, own, turning=True)
        line(f"            const size_t room = LANES_WIDTH - busy, left = {own.count} - taken;")
        line("            active = lanes_leading(idle, left, active);")
        line("            taken += left < room ? left : room;")
        line("            busy += left < room ? left : room;")
        line("        }")
        line("        if (busy == 0)")
        line("            break;")
        known: dict[str, Kind] = dict.fromkeys((*self.job, *self.parameters), "double")
        known |= own.known
        known[node.truth] = "truth"
        line(f"        M {node.truth} = active;")
        first = len(self.lines)
        self._body(
            node.body,
            known,
            set(),
            "active",
            "        ",
            set(scoped.gives) | set(scoped.takes) | {node.truth},
        )
        read = [
            name for name in scoped.takes if name in self.parameters and self._read(name, first)
        ]
        self.lines[expands:expands] = [
            text
            for name in read
            for text in (
                "            if (varying)",
                f"                {name} = lanes_expand({own.column(name)} + taken, idle, {name});",
            )
        ]
        self.lines[loads:loads] = [
            f"    V {name} = lanes_load({self.bases.get(name, f'lists->{name}')});" for name in read
        ]
        line("        turns = lanes_add(turns, K(1.0));")
        line(
            f"        const M ended = lanes_both(active, lanes_not(lanes_both({node.truth}, "
            f"lanes_less(turns, K({float(node.limit)})))));"
        )
        line("        if (lanes_any(ended)) {")
        line("            double ended_row[LANES_WIDTH];")
        line("            lanes_store(ended_row, row);")
        for name in scoped.gives:
            kind = writes([node])[name]
            number = "float" if kind == "single" else "double"
            line(f"            {number} ended_{name}[LANES_WIDTH];")
            line(f"            {STORED[kind].format(f'ended_{name}', name)};")
        line("            for (unsigned bits = lanes_bits(ended); bits; bits &= bits - 1) {")
        line("                const int lane = LANES_LOWEST(bits);")
        line("                const size_t k = (size_t)ended_row[lane];")
        for name in scoped.gives:
            line(f"                {frame.column(name)}[k] = ended_{name}[lane];")
        line("            }")
        line("            busy -= lanes_many(ended);")
        line("            active = lanes_both(active, lanes_not(ended));")
        line("        }")
        line("    }")
        line("}")
