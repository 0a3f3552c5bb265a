"""Lowering for C a body that repeats, over a list: a lane that is done takes the next shot."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.event_tree import writes
from hoopgen.derive.ir.kernel import Kind

from .. import visitors
from ..lowering import scope
from ..statements import (
    Apply,
    Assign,
    Block,
    Break,
    Cast,
    Choose,
    Column,
    Declare,
    For,
    If,
    Infix,
    Item,
    Name,
    Number,
    Operate,
    Scalar,
    Statement,
    While,
)
from .hierarchy import GroupContext
from .masked_loop import Statements
from .spelling import (
    TYPES,
    at,
    both,
    complement,
    expand,
    less,
    load,
    nothing,
    offset,
    pack,
    select,
    store,
)
from .transfers import TransferLoop, moved

TURNING = "turning_"
"""Prefix of the parameters of the shots that the lanes have at hand."""


@dataclass
class TurnLoop(TransferLoop):
    """Bodies that repeat.

    Attributes
    ----------
    turning
        Whether the statements at hand are of a body whose lanes are given further shots.
    """

    turning: bool = False

    def _turns(
        self, node: ir.While, frame: GroupContext, own: GroupContext, later: set[str]
    ) -> Statement:
        """Return a body that repeats, the lanes that are done given the next shots of the list."""
        scoped = scope(node, later)
        idle, row, active = Name("idle"), Name("row"), Name("active")
        fixing = self._fix(node.body, own, turning=True)
        known: dict[str, Kind] = dict.fromkeys((*self.job, *self.parameters), "double")
        known |= own.known | {node.truth: "truth"}
        needed = set(scoped.gives) | set(scoped.takes) | {node.truth}
        self.named.clear()
        self.turning = True
        body = self.body(node.body, known, set(), "active", needed)
        self.turning = False
        live = visitors.live_before(body)
        read = [name for name in scoped.takes if name in self.parameters and name in live]
        expands: Statements = [self._expanded(own, name, kind) for name, kind in own.known.items()]
        expands_too = [self._expanded(own, name) for name in read]
        if any(isinstance(one, ir.ForEach) and one.given for one in ir.walk(node.body)):
            expands_too += self._expanded_parameters(own, scoped.takes)
        expands += [If(Name("varying"), tuple(expands_too))] if expands_too else []
        spare = Infix("<=", Infix("+", Name("busy"), Name("LANES_SPARE")), Name("LANES_WIDTH"))
        more = Choose(Infix("<", Name("_left"), Name("room")), Name("_left"), Name("room"))
        refill = [
            Declare("idle", "M", complement(active), constant=True),
            Assign(Name("turns"), select(idle, Number(0.0), Name("turns"))),
            Assign(row, expand("double", at(own.column("row"), "taken"), idle, row)),
            *expands,
            *fixing,
            Declare("room", "size_t", Infix("-", Name("LANES_WIDTH"), Name("busy")), constant=True),
            Declare("_left", "size_t", Infix("-", Name(own.count), Name("taken")), constant=True),
            Assign(active, Apply("lanes_leading", (idle, Name("_left"), active))),
            Assign(Name("taken"), more, "+="),
            Assign(Name("busy"), more, "+="),
        ]
        untaken = Infix("<", Name("taken"), Name(own.count))
        ended, back = self._ended(node, frame, own, scoped.gives)
        turn = [
            If(Infix("&&", untaken, spare), tuple(refill)),
            If(Infix("==", Name("busy"), Scalar(0)), (Break(),)),
            Declare(node.truth, "M", active),
            *body,
            *ended,
        ]
        return Block(
            (
                Declare("taken", "size_t", Scalar(0)),
                Declare("done", "size_t", Scalar(0)),
                Declare("busy", "size_t", Scalar(0)),
                Declare("active", "M", Operate("nowhere")),
                Declare("row", "V", Number(0.0)),
                Declare("turns", "V", Number(0.0)),
                *(Declare(name, "V", load("double", self._shared(name))) for name in read),
                *(Declare(name, TYPES[kind], nothing(kind)) for name, kind in own.known.items()),
                While(None, tuple(turn)),
                back,
            )
        )

    def _expanded(self, own: GroupContext, name: str, kind: Kind = "double") -> Statement:
        """Return the statement that loads a variable of the next shots into free lanes."""
        place = at(own.column(name), "taken")
        return Assign(Name(name), expand(kind, place, Name("idle"), Name(name)))

    def _expanded_parameters(self, own: GroupContext, takes: Iterable[str]) -> Statements:
        """Return the statements that load the parameters of the next shots, for tables of them."""
        self.parameter_lists[TURNING] = None
        column = self._taken(own, "_p", TURNING)
        place = offset(self._taken(own, "_p"), Name("taken"))
        value = expand("double", place, Name("idle"), load("double", column))
        return self._over_taken(takes, store("double", column, value))

    def _ended(
        self, node: ir.While, frame: GroupContext, own: GroupContext, gives: Sequence[str]
    ) -> tuple[Statements, Statement]:
        """Return the statements that pack results of finished lanes, and those that store them.

        How many lanes are done in a turn is hardly predictable, so no loop goes over them there.
        """
        active, ended, turns = Name("active"), Name("ended"), Name("turns")
        going = both(Name(node.truth), less(turns, Number(float(node.limit))))
        kinds: dict[str, Kind] = {"row": "double", **{name: writes([node])[name] for name in gives}}
        columns = {name: own.column(f"ended_{name}") for name in kinds}
        self.columns |= {columns[name]: kind for name, kind in kinds.items()}
        packs = (
            pack(kind, at(columns[name], "done"), ended, Name(name)) for name, kind in kinds.items()
        )
        place = Cast("size_t", Item(Column(columns["row"]), Name("k")))
        moves = moved((frame.column(name), columns[name]) for name in gives)
        turn: Statements = [
            Assign(turns, Operate("add", (turns, Number(1.0)))),
            Declare("ended", "M", both(active, complement(going)), constant=True),
            *packs,
            Assign(Name("done"), Apply("popcount", (ended,)), "+="),
            Assign(Name("busy"), Apply("popcount", (ended,)), "-="),
            Assign(active, both(active, complement(ended))),
        ]
        row = Declare("row", "size_t", place, constant=True)
        return turn, For("k", Name("done"), (row, *moves))
