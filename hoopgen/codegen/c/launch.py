"""Lowering for C shots that touch nothing: from release to end in one pass, without worklists."""

from __future__ import annotations

from collections.abc import Mapping, Set
from dataclasses import dataclass

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.event_tree import live_before, needed, writes
from hoopgen.derive.ir.kernel import Kind
from hoopgen.derive.loop.launch import REFUSED, SIZE, launched
from hoopgen.derive.loop.loop import Loop
from hoopgen.derive.loop.predicates import GOES_ON
from hoopgen.derive.symbolic.symbols import STATE

from .. import visitors
from ..statements import Assign, Column, Declare, Expression, If, Name, Number, Operate
from ..variants import Stage
from .masked_loop import MaskedLoop, Statements
from .spelling import TYPES, ZERO, column_of, less, load, store

STATE_NAMES = {symbol.name for symbol in STATE}


@dataclass
class LaunchLoop(MaskedLoop):
    """A pass over rows of new shots, which refuses those that may touch something."""

    def _guarded(
        self, node: ir.If | ir.While, known: Mapping[str, Kind], mask: str, later: set[str]
    ) -> Statements:
        if REFUSED in writes(node.body):
            return [_refuse(Name(node.truth))]
        return super()._guarded(node, known, mask, later)

    def entering(self, mask: str, truth: str) -> Expression:
        """Return the lanes that enter a guarded body, of all lanes if there is no mask.

        Parameters
        ----------
        mask
            The name of the mask; empty for all lanes.
        truth
            The name of the condition of the body.
        """
        return super().entering(mask, truth) if mask else Name(truth)

    def launch(
        self, loop: Loop, stages: Mapping[str, Stage], results: Set[str]
    ) -> tuple[Statements, Statements]:
        """Return the statements before the pass, and those for a row of lanes.

        A scene with tables of surfaces has none, and none whose flights go on in pieces.

        Parameters
        ----------
        loop, stages
            The event loop, and its stages.
        results
            The fields that are results, which are left in the first row of their columns.
        """
        release, detect, resolve = (
            launched(stages[name][0]) for name in ("start", "detect", "resolve")
        )
        stepped = (*release, *detect, *resolve)
        if any(isinstance(n, ir.ForEach | ir.While) for n in stepped) or GOES_ON in writes(stepped):
            return [], []
        wanted = {*results, "outcome"}
        flight = needed((*detect, *resolve), wanted | {REFUSED})
        begun = needed(release, live_before(flight, wanted) | {"outcome", REFUSED})
        written = writes((*begun, *flight))
        live = live_before((*begun, *flight), wanted) - {REFUSED}
        kinds: dict[str, Kind] = {"permitted": "truth", **loop.kinds}
        known = {name: kinds.get(name, "double") for name in live}
        body = self.body(begun, known, set(), "", live_before(flight, wanted) | {"outcome"})
        body.append(_refuse(Operate("at_most", (ZERO, Name("outcome")))))
        body += self.body(flight, known, set(), "", wanted)
        body.append(_refuse(less(Name("outcome"), ZERO)))
        starts = {field.name: field.start for field in loop.fields} | {"last": -1.0}
        left = {n: store(known[n], Column(n), Name(n)) for n in sorted(results & set(written))}
        body += [one for name, one in left.items() if name not in STATE_NAMES]
        state = tuple(one for name, one in left.items() if name in STATE_NAMES)
        body.append(If(Name("job->results->state"), state))
        fixed: Statements = []
        begin: Statements = [Declare(REFUSED, "M", Operate("nowhere"))]
        read = visitors.live_before(body) | results - STATE_NAMES
        for name in sorted(read & live - {*loop.job, SIZE}):
            kind, start = known[name], starts.get(name)
            value: Expression = load(kind, Column(column_of("", name)))
            if start is not None:
                value = Number(float(start), kind == "single")
            own = begin if name in written or name in STATE_NAMES else fixed
            own.append(Declare(name, TYPES[kind], value, constant=name not in written))
            if own is fixed and name in results:
                fixed.append(store(kind, Column(name), Name(name)))
        return fixed, [*begin, *body]


def _refuse(shots: Expression) -> Assign:
    """Return the statement that refuses shots."""
    return Assign(Name(REFUSED), Operate("either", (Name(REFUSED), shots)))
