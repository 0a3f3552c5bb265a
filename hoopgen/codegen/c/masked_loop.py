"""Lowering the event loop for C: a body is skipped where no lane needs it, else selected.

This makes statements, with masks of lanes; `formatter.py` and `spelling.py` write them as text.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.event_tree import Node, live_before, writes
from hoopgen.derive.ir.kernel import Kind

from ..lowering import Lowering, carried, scope
from ..statements import (
    Apply,
    Assign,
    Block,
    Break,
    Call,
    Declare,
    Expression,
    For,
    If,
    Member,
    Name,
    Number,
    Operate,
    Scalar,
    Statement,
)
from .hoisted import Hoisted
from .spelling import TYPES, any_lane, both, choose, is_parameter, usual_lane

Statements = list[Statement]
Around = Callable[[Sequence[Statement]], Statements]
"""A function that puts statements into a loop, with the statements before it."""


@dataclass
class MaskedLoop(Lowering):
    """Lanes: `lanes_any` skips a body, `lanes_select` keeps the other lanes as they are.

    Attributes
    ----------
    hoisted
        What kernels are given ready made.
    by_columns
        The kernels that are given all parameters at once, as columns, and the row at hand.
    used
        How many names there are of each kind.
    named
        The same of what only the pass at hand has.
    """

    hoisted: Hoisted = field(default_factory=Hoisted)
    by_columns: frozenset[str] = frozenset()
    used: Counter[str] = field(default_factory=Counter)
    named: Counter[str] = field(default_factory=Counter)

    def fresh(self, letter: str) -> str:
        """Return a name that is not in use: what it is for, and which of those it is.

        So names are mostly the same in all variants of the loop, whose texts are merged.
        """
        self.used[letter] += 1
        number = self.used[letter]
        return f"_{letter}{number}" if len(letter) == 1 else f"_{letter}_{number}"

    def local(self, name: str) -> str:
        """Return a name that is not in use in the pass at hand, for what it alone has."""
        self.named[name] += 1
        return f"_{name}_{self.named[name]}"

    def body(
        self,
        nodes: Sequence[Node],
        known: dict[str, Kind],
        outer: set[str],
        mask: str,
        after: set[str],
    ) -> Statements:
        """Return the statements of nodes for the lanes of a mask; `known` gets what they declare.

        What they assign of `outer` is selected by the mask.

        Parameters
        ----------
        nodes
            The nodes, in order.
        known
            The kinds of the variables that are declared so far, by name.
        outer
            The variables that are declared outside of this body.
        mask
            The name of the mask of the lanes that take part.
        after
            The variables that are read after the nodes.

        Returns
        -------
        list of Statement
            The statements of the nodes, in order.
        """
        found: Statements = []
        for index, node in enumerate(nodes):
            later = live_before(nodes[index + 1 :], after)
            if isinstance(node, ir.Call):
                found += self._call(node, known, outer, mask)
            elif isinstance(node, ir.ForEach):
                found += self._each(node, known, outer, mask, later)
            else:
                found += self._guarded(node, known, mask, later)
        return found

    def _guarded(
        self, node: ir.If | ir.While, known: Mapping[str, Kind], mask: str, later: set[str]
    ) -> Statements:
        own, truth, inside = scope(node, later), self.local(f"if_{node.truth}"), dict(known)
        shared = set(own.gives) | set(own.keeps)
        # What the body has for itself alone it declares, if it needs no value from around it.
        for name in set(writes(node.body)) - shared - set(own.takes):
            inside.pop(name, None)
        asked = Declare(truth, "M", self.entering(mask, node.truth), constant=True)
        if isinstance(node, ir.While):
            again = later | set(own.takes) | {node.truth}
            over = If(Operate("not", (any_lane(Name(truth)),)), (Break(),))
            body = self.body(node.body, inside, shared, truth, again)
            return [For(self.fresh(f"turn_{node.truth}"), Scalar(node.limit), (asked, over, *body))]
        begin, finish = self.beside_body(node, inside)
        body = [*begin, *self.body(node.body, inside, shared, truth, later), *finish]
        if self.cheap(node):
            return [asked, Block(tuple(body))]
        enters = usual_lane(Name(truth)) if node.usual else any_lane(Name(truth))
        return [asked, If(enters, tuple(body))]

    def entering(self, mask: str, truth: str) -> Expression:
        """Return the lanes of a mask that enter a guarded body.

        Parameters
        ----------
        mask
            The name of the mask around the body.
        truth
            The name of the condition of the body.
        """
        return both(Name(mask), Name(truth))

    def beside_body(self, node: ir.If, known: dict[str, Kind]) -> tuple[Statements, Statements]:
        """Return the statements at the begin and at the end of a guarded body.

        Parameters
        ----------
        node
            The guard, whose body is meant.
        known
            The kinds of the variables that are declared so far; those that are loaded join them.

        Returns
        -------
        tuple
            The statements before the body, and those after it.
        """
        return [], []

    def _each(
        self,
        node: ir.ForEach,
        known: Mapping[str, Kind],
        outer: set[str],
        mask: str,
        later: set[str],
    ) -> Statements:
        after = carried(node, later)
        inside = dict(known)
        for name in set(writes(node.body)) - after:
            inside.pop(name, None)
        around, values = self.row(node, mask)
        inside |= dict.fromkeys(values, "double")
        own = [Declare(name, "V", value, constant=True) for name, value in values.items()]
        body = self.body(node.body, inside, outer, mask, after)
        return [Block(tuple(around([*own, *body])))]

    def row(self, node: ir.ForEach, mask: str) -> tuple[Around, dict[str, Expression]]:
        """Return the wrapper of a loop over the rows of a table, and the values of a row.

        Parameters
        ----------
        node
            The loop over surfaces of one kind.
        mask
            The name of the mask of the lanes that take part.

        Returns
        -------
        tuple
            A function that puts statements into the loop, and the expressions of the row's numbers
            and names, by variable.
        """
        raise NotImplementedError

    def _call(
        self, node: ir.Call, known: dict[str, Kind], outer: set[str], mask: str
    ) -> Iterable[Statement]:
        single = node.kernel.single
        arguments = node.arguments
        columns: list[Expression] = []
        if node.kernel.name in self.by_columns:
            arguments = tuple(a for a in arguments if not (isinstance(a, str) and is_parameter(a)))
            columns = [Name("p"), Name("row")]
        values = [*columns, *(self._given(value, known, single) for value in arguments)]
        given, result = self.hoisted.given(node, values), self.local(node.kernel.name)
        yield Call(f"{self.prefix}_{node.kernel.name}", tuple(given), (result,))
        for output, variable in node.assigned.items():
            value: Expression = Member(Name(result), output)
            kind = node.kinds[variable]
            if variable not in known:
                known[variable] = kind
                yield Declare(variable, TYPES[kind], value)
                continue
            if variable in outer:
                value = choose(kind, Name(mask), value, Name(variable))
            yield Assign(Name(variable), value)

    def _given(self, value: str | float, known: Mapping[str, Kind], single: bool) -> Expression:
        """Return an argument of a kernel, in the kernel's precision."""
        if not isinstance(value, str):
            return Number(float(value), single)
        kind = known.get(value, "double")
        if kind == "truth" or (kind == "single") == single:
            return Name(value)
        return Apply("lanes_narrow" if single else "lanes_wide", (Name(value),))
