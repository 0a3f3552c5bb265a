"""Lowering for C how the values of shots get into a list of some of them, and back."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.kernel import Kind

from ..statements import (
    Apply,
    Assign,
    Cast,
    Choose,
    Column,
    Compact,
    Declare,
    Expression,
    For,
    If,
    Infix,
    Item,
    Name,
    Operate,
    Scalar,
    Statement,
    Tuple,
)
from .hierarchy import GroupContext
from .masked_loop import Statements
from .outlining import OutlinedLoop
from .spelling import (
    TYPES,
    at,
    both,
    column_of,
    is_parameter,
    load,
    numbered_column,
    offset,
    pack,
    seldom,
    zeros,
)

MIN_COPIED = 34
"""Least number of columns that are copied to a list shot by shot. Packing costs each row of lanes
the same however few of its shots go to the list; a copy costs each of these. It is
chosen, and no result depends on it; the lists of HOOP and COURT are shorter."""


def moved(columns: Iterable[tuple[str, str]]) -> list[Statement]:
    """Return the statements that copy row `k` of a column to `row` of another, named first."""
    return [
        Assign(Item(Column(to), Name("row")), Item(Column(source), Name("k")))
        for to, source in columns
    ]


@dataclass
class TransferLoop(OutlinedLoop):
    """Transfers between the rows of a list and the columns of another.

    Attributes
    ----------
    bases
        By what is of the row at hand of a table, the array that has its values, as if a parameter.
    """

    bases: dict[str, Expression] = field(default_factory=dict)

    def _column(self, frame: GroupContext, name: str, kind: Kind) -> None:
        if is_parameter(name):
            self.parameter_lists[frame.prefix] = None
        else:
            self.columns.setdefault(frame.column(name), kind)

    def _shared(self, name: str) -> Expression:
        """Return the array of a parameter's values for all shots: one row of lanes, or more."""
        return self.bases.get(name, Column(column_of("", name)))

    def _parameter(self, frame: GroupContext, name: str) -> Expression:
        """Return a parameter's values for the row of lanes at hand."""
        shared = self._shared(name)
        if not frame.prefix:
            return load("double", offset(shared, Infix("&", Name("i"), Name("varying"))))
        return load("double", Choose(Name("varying"), at(frame.column(name), "i"), shared))

    def _taken(self, own: GroupContext, index: str, prefix: str | None = None) -> Expression:
        """Return the column, in a list or in the one of a prefix, of a parameter that it takes."""
        number = Item(Name(f"{own.prefix}taken"), Name(index))
        return numbered_column(own.prefix if prefix is None else prefix, number)

    def _over_taken(self, takes: Iterable[str], each: Statement) -> list[Statement]:
        """Return the statements for each parameter that a list takes."""
        many = sum(map(is_parameter, takes))
        return [For("_p", Scalar(many), (each,))] if many else []

    def _parameter_numbers(self, own: GroupContext, takes: Iterable[str]) -> list[Statement]:
        """Return the declaration of the numbers of the parameters that a list takes."""
        numbers = [Scalar(self.parameters.index(name)) for name in takes if is_parameter(name)]
        if not numbers:
            return []
        name, every = f"{own.prefix}taken", Tuple(tuple(numbers))
        return [Declare(name, "static const int", every, room=(None,))]

    def _pack(
        self,
        cut: ir.If | ir.While,
        frame: GroupContext,
        own: GroupContext,
        takes: Sequence[str],
        known: Mapping[str, Kind],
        copied: Sequence[str],
        loaded: Sequence[str],
    ) -> Statements:
        """Return the statement that appends the shots of a guarded body to its list.

        Parameters
        ----------
        cut
            The node of the guarded body.
        frame, own
            The list at hand, and that of the body.
        takes
            The variables that the body takes.
        known
            The kinds of variables.
        copied
            The variables that `_copy` takes to the list.
        loaded
            The variables that are loaded for it alone.
        """
        packed = Name("packed")
        number = Operate("add", (Apply("iota"), Apply("K", (Cast("double", Name("i")),))))
        moves = [
            *(
                Declare(name, TYPES[known[name]], load(known[name], at(frame.column(name), "i")))
                for name in loaded
            ),
            pack("double", at(own.column("row"), own.count), packed, number),
        ]
        to, source = self._taken(own, "_p"), self._taken(own, "_p", frame.prefix)
        value = load("double", offset(source, Name("i")))
        own_row = offset(to, Name(own.count))
        rare = self._over_taken(takes, pack("double", own_row, packed, value))
        self._column(own, "row", "double")
        for name in takes:
            if name in self.job:
                continue
            self._column(own, name, known[name])
            place = at(own.column(name), own.count)
            if name in self.parameters:
                if not is_parameter(name):
                    rare.append(pack("double", place, packed, self._parameter(frame, name)))
            elif not (isinstance(cut, ir.While) and name == cut.truth):
                own.known[name] = known[name]
                if name not in copied:
                    moves.append(pack(known[name], place, packed, Name(name)))
        moves += [If(seldom("varying"), tuple(rare))] if rare else []
        mask = Declare("packed", "M", both(Name("rows"), Name(cut.truth)), constant=True)
        return [mask, Compact(own.count, packed, tuple(moves))]

    def _copy(
        self, frame: GroupContext, own: GroupContext, copied: Sequence[str]
    ) -> list[Statement]:
        """Return the statements that copy columns of the shots of a list from those at hand."""
        if not copied:
            return []
        source = Cast("size_t", Item(Column(own.column("row")), Name("row")))
        k = Declare("k", "size_t", source, constant=True)
        moves = moved((own.column(name), frame.column(name)) for name in copied)
        return [For("row", Name(own.count), (k, *moves))]

    def _fill(self, own: GroupContext, takes: Sequence[str]) -> Statement:
        """Return the statement that clears the lanes behind a list's end."""

        def zero(name: str, kind: Kind) -> Statement:
            return zeros(kind, at(own.column(name), own.count))

        filled = [zero("row", "double")]
        filled += [zero(name, own.known[name]) for name in takes if name in own.known]
        own_row = offset(self._taken(own, "_p"), Name(own.count))
        rare = self._over_taken(takes, zeros("double", own_row))
        bases = (name for name in takes if name in self.parameters and not is_parameter(name))
        rare += [zero(name, "double") for name in bases]
        filled += [If(seldom("varying"), tuple(rare))] if rare else []
        return If(Name(own.count), tuple(filled))

    def _return(self, frame: GroupContext, own: GroupContext, gives: Sequence[str]) -> Statement:
        """Return the statements that store the results of a list in the rows of its shots."""
        for name in gives:
            self._column(frame, name, frame.known[name])
        source = Cast("size_t", Item(Column(own.column("row")), Name("k")))
        row = Declare("row", "size_t", source, constant=True)
        moves = moved((frame.column(name), own.column(name)) for name in gives)
        return For("k", Name(own.count), (row, *moves))
