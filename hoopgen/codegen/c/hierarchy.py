"""Lowering groups of bodies for C: those that no shot comes near are left out as a whole.

A pass over a list of shots goes over its rows of lanes; for the bodies of a group over those alone
that have a shot near it, and for a group within another over some of those.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.event_tree import Group
from hoopgen.derive.ir.kernel import Kind

from ..statements import (
    Apply,
    Assign,
    Block,
    Call,
    Choose,
    Column,
    Declare,
    Expression,
    For,
    ForLanes,
    If,
    Infix,
    Item,
    Member,
    Name,
    Number,
    Operate,
    Scalar,
    Statement,
    Table,
    Tuple,
    While,
)
from .masked_loop import Around, MaskedLoop, Statements
from .spelling import any_lane, at, both, column_of, function, load, store


@dataclass
class GroupContext:
    """A list of shots, the variables that it has columns for, and the row that it begins with.

    With `blocks`, where they begin and how many, a pass goes over those rows of lanes alone. With
    `guard`, a column of truths, only shots of which it is true take part; of what others need
    again, `outer`, they keep their values.
    """

    prefix: str
    known: dict[str, Kind]
    first: Expression = field(default_factory=lambda: Scalar(0))
    blocks: tuple[Expression, Expression] | None = None
    guard: str = ""
    outer: frozenset[str] = frozenset()

    @property
    def count(self) -> str:
        """The C variable of its length."""
        return f"{self.prefix}shots"

    def column(self, name: str) -> str:
        """Return the name of the column of a variable."""
        return column_of(self.prefix, name)

    def over(self, body: Sequence[Statement]) -> Statement:
        """Return a loop over its rows of lanes, the first of them at `i`."""
        if self.blocks is None:
            return ForLanes("i", self.first, Name(self.count), tuple(body))
        begin, many = self.blocks
        row = Declare("i", "size_t", Item(begin, Name("_b")), constant=True)
        return For("_b", many, (row, *body))


@dataclass
class GroupedLoop(MaskedLoop):
    """Tables in groups.

    Attributes
    ----------
    parameters
        What has one value for all shots, or one for each.
    once
        Statements that are done once, before the others.
    """

    parameters: Sequence[str] = ()
    once: Statements = field(default_factory=list)

    def table(
        self, node: ir.ForEach, row: str
    ) -> tuple[Statements, dict[str, Expression], dict[str, Expression]]:
        """Return a table; and what is of the row at hand: arrays, and numbers.

        Arguments as for `hoopgen.codegen.c.compaction.CompactedLoop.table`.
        """
        raise NotImplementedError

    def _boxes(
        self, node: ir.ForEach, groups: ir.BoundingVolumes, row: str
    ) -> tuple[str, dict[str, Expression], dict[str, Expression]]:
        """Compute a table's groups and their boxes once, endless where a shot has own sizes.

        Returns
        -------
        tuple
            What the table of groups is called, and what `table` returns of the row at hand.
        """
        made, bases, numbers = self.table(node, row)
        name = self.fresh("g")
        columns = dict(zip(node.names, node.columns, strict=True))
        asked = [v for v in groups.box.arguments if isinstance(v, str)]
        sizes = {size for v in asked for size in columns.get(v, (v,))}
        places = sorted(self.parameters.index(size) for size in sizes if isinstance(size, str))
        outputs = groups.box.kernel.output_names
        depth_of = depths(groups.members)
        rows = [
            tuple(map(Scalar, (group.first, group.past, group.after, depth)))
            for group, depth in zip(groups.members, depth_of, strict=True)
        ]
        strides = Item(Name("job->strides"), Item(Name(f"{name}_sizes"), Name("_k")))
        given = (load("double", bases.get(v, Column(column_of("", v)))) for v in asked)
        box = Call(f"{self.prefix}_{groups.box.kernel.name}", tuple(given), ("_box",))
        wider = [
            Assign(Name(o), Operate("max", (Name(o), Member(Name("_box"), o)))) for o in outputs
        ]
        stored = [
            part
            for k, output in enumerate(outputs)
            for part in (
                store("double", Name("_all"), Name(output)),
                Assign(
                    Item(Item(Name(f"{name}_boxes"), Name("_g")), Scalar(k)),
                    Choose(Name("_differing"), Name("INFINITY"), Item(Name("_all"), Scalar(0))),
                ),
            )
        ]
        own = Item(Name(name), Name("_g"))
        over_rows = For(row, Item(own, Scalar(1)), (box, *wider), first=Item(own, Scalar(0)))
        each = (
            *(Declare(output, "V", Number(float("-inf"))) for output in outputs),
            over_rows,
            Declare("_all", "double", room=(Name("LANES_WIDTH"),)),
            *stored,
        )
        many = Scalar(len(groups.members))
        self.once += [
            *made,
            Table(name, "static const size_t", tuple(rows)),
            Declare(
                f"{name}_sizes", "static const int", Tuple(tuple(map(Scalar, places))), room=(None,)
            ),
            Declare(f"{name}_boxes", "double", room=(many, Scalar(len(outputs)))),
            Block(
                (
                    Declare("_differing", "int64_t", Scalar(0)),
                    For("_k", Scalar(len(places)), (Assign(Name("_differing"), strides, "|="),)),
                    For("_g", many, each),
                )
            ),
        ]
        return name, bases, numbers

    def _near(
        self, groups: ir.BoundingVolumes, name: str, row: str, frame: GroupContext
    ) -> tuple[GroupContext, Around]:
        """Return the list without the rows of lanes that have no shot near the group at hand.

        And what puts statements into the loop over the groups and that over the rows of one.
        """
        levels = Scalar(max(depths(groups.members)) + 2)
        blocks, many = Name(f"{name}_blocks"), Name(f"{name}_many")
        own, deeper = (
            Item(blocks, Name("_depth")),
            Item(blocks, Infix("+", Name("_depth"), Scalar(1))),
        )
        begin: Statements = [
            Declare(
                blocks.name,
                "size_t",
                room=(levels, Infix("/", Name("LANES_ROWS"), Name("LANES_WIDTH"))),
            ),
            Declare(many.name, "size_t", Tuple((Scalar(0),)), room=(levels,)),
            frame.over(_append(Item(blocks, Scalar(0)), Item(many, Scalar(0)))),
        ]
        mask = Apply("mask_first_n", (Infix("-", Name(frame.count), Name("i")),))
        asked = [
            Declare(name, "V", load("double", at(frame.column(name), "i")), constant=True)
            for name in sorted(groups.test_reads)
        ]
        kept = Name("_kept")
        look: Statements = [
            Declare(
                "_depth", "size_t", Item(Item(Name(name), Name("_g")), Scalar(3)), constant=True
            ),
            Declare(kept.name, "size_t", Scalar(0)),
            For(
                "_b",
                Item(many, Name("_depth")),
                (
                    Declare("i", "size_t", Item(own, Name("_b")), constant=True),
                    *asked,
                    If(self._any_near(groups, mask), tuple(_append(deeper, kept))),
                ),
            ),
            Assign(Item(many, Infix("+", Name("_depth"), Scalar(1))), kept),
        ]

        def around(body: Sequence[Statement]) -> Statements:
            return [*begin, *self._groups(groups, name, row, look, kept, body)]

        return replace(frame, blocks=(deeper, kept)), around

    def _any_near(self, groups: ir.BoundingVolumes, mask: Expression) -> Expression:
        """Return whether a shot of a mask is near the group at hand."""
        kernel = groups.near.kernel
        (truth,) = kernel.output_names
        given = (
            Name(value) if isinstance(value, str) else Number(float(value))
            for value in groups.near.arguments
        )
        near = Apply(function(f"{self.prefix}_{kernel.name}"), tuple(given))
        return any_lane(both(mask, Member(near, truth)))

    def _groups(
        self,
        groups: ir.BoundingVolumes,
        name: str,
        row: str,
        look: Sequence[Statement],
        near: Name,
        body: Sequence[Statement],
    ) -> Statements:
        """Return a loop over the groups, and over the rows of one that some shot is near."""
        group, following = Name("_g"), Name("_next")
        own = Item(Name(name), group)
        after = Item(own, Scalar(2))
        last = Infix("&&", near, Infix("==", following, after))
        boxes = [
            Declare(
                output,
                "V",
                _lanes(Item(Item(Name(f"{name}_boxes"), group), Scalar(k))),
                constant=True,
            )
            for k, output in enumerate(groups.box.kernel.output_names)
        ]
        turn = (
            *boxes,
            *look,
            Declare(
                "_next", "size_t", Choose(near, Infix("+", group, Scalar(1)), after), constant=True
            ),
            Declare(
                "_past", "size_t", Choose(last, Item(own, Scalar(1)), Scalar(0)), constant=True
            ),
            For(row, Name("_past"), tuple(body), first=Item(own, Scalar(0))),
            Assign(group, following),
        )
        return [
            Declare("_g", "size_t", Scalar(0)),
            While(Infix("<", group, Scalar(len(groups.members))), turn),
        ]


def _lanes(number: Expression) -> Expression:
    """Return a number in all lanes."""
    return Apply("K", (number,))


def _append(array: Expression, count: Expression) -> Statements:
    """Append the row of lanes at hand to an array."""
    return [Assign(Item(array, count), Name("i")), Assign(count, Scalar(1), "+=")]


def depths(members: Sequence[Group]) -> list[int]:
    """Return the number of groups that contain each group."""
    found: list[int] = []
    for k, group in enumerate(members):
        around = [j for j in range(k) if members[j].after > k]
        found.append(len(around))
        assert all(members[j].past >= group.past for j in around), "a group reaches out of another"
    return found
