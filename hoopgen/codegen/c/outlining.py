"""Outlining for C: what is seldom done is a function, out of the way of what is done often."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ir.event_tree import Node
from hoopgen.derive.ir.kernel import Kind

from ..statements import Apply, Column, Declare, Execute, Function, If, Name, Statement
from ..visitors import live_before
from .hierarchy import GroupContext, GroupedLoop
from .masked_loop import Statements
from .spelling import at, expand, load, seldom, store


@dataclass
class OutlinedLoop(GroupedLoop):
    """Rare bodies in functions of their own.

    In the long function of all the others they would take registers from what most shots do.

    Attributes
    ----------
    job
        What has one value for all.
    columns
        By array, in order, what it holds: what the struct of the lists has room for.
    parameter_lists
        The prefixes of the lists that have columns for parameters, in order.
    functions
        The functions, each after those that it calls.
    """

    job: Sequence[str] = ()
    columns: dict[str, Kind] = field(default_factory=dict)
    parameter_lists: dict[str, None] = field(default_factory=dict)
    functions: list[Function] = field(default_factory=list)

    def _outlined(self, name: str, frame: GroupContext, body: Statements) -> Statement:
        """Make a function of statements, and return its call where the list has any shots."""
        types = {frame.count: "size_t", "varying": "size_t"} | dict.fromkeys(self.job, "V")
        needed = live_before(body)
        given = {value: kind for value, kind in types.items() if value in needed}
        return If(Name(frame.count), (self._function(name, given, body),))

    def apart(self, passes: Sequence[Statement]) -> Statements:
        """Make a function of each pass over the shots in flight, and return their calls.

        Parameters
        ----------
        passes
            The passes, in order, none of which declares what another reads.
        """
        shots = dict.fromkeys(("shots", "fresh", "begun", "varying"), "size_t")
        types = shots | dict.fromkeys(("recording", "streams"), "int")
        types |= {"job": f"const {self.prefix}_job *"} | dict.fromkeys(self.job, "V")
        calls: Statements = []
        for one in passes:
            needed = live_before([one])
            given = {value: kind for value, kind in types.items() if value in needed}
            calls.append(self._function(self.fresh("pass").lstrip("_"), given, [one]))
        return calls

    def _function(
        self, name: str, given: Mapping[str, str], body: Sequence[Statement]
    ) -> Statement:
        """Make a function of statements, and return a call of it."""
        self.functions.append(Function(name, tuple(given.items()), tuple(body)))
        arguments = (Name("worklist"), *map(Name, given))
        return Execute(Apply(f"LOOP({name})", arguments))

    def _fix(self, nodes: Sequence[Node], frame: GroupContext, turning: bool = False) -> Statements:
        """Return the statements of loop invariant results for shots with parameters of their own.

        It is a function: beside what is done for all it would be in the way.
        """
        rows = self.hoisted.rows_of(nodes)
        read = self.hoisted.reads(rows)
        if not read:
            return []
        body: Statements = []
        for name in read:
            place = at(frame.column(name), "taken" if turning else "i")
            value = load("double", place)
            if turning:
                old = load("double", Column(f"turning_{name}"))
                value = expand("double", place, Name("idle"), old)
            body.append(Declare(name, "V", value, constant=True))
        if turning:
            self.columns |= dict[str, Kind]((f"turning_{name}", "double") for name in read)
            body += [store("double", Column(f"turning_{name}"), Name(name)) for name in read]
        given = {"taken": "size_t", "idle": "M"} if turning else {"i": "size_t"}
        body += self.hoisted.statements(rows)
        name = self.fresh(f"fix_{frame.prefix}rows").lstrip("_")
        call = self._function(name, given, body)
        return [If(seldom("varying"), (call,))]
