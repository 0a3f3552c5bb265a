"""The event loop of a scene as data: its fields, its arguments, and the tree of each stage.

`event_loop.py` derives it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from ..ir.event_tree import Call, ForEach, Node, check, live_before, needed, walk, without, writes
from ..ir.kernel import Kind as VariableKind
from ..ir.kernel import symbols_in
from ..state.fields import Field

REVIEW = "review"
"""The stage that decides whether a shot that has ended is simulated again with `TIGHTENING` 1."""

TIGHTENING = "tightening"
"""The number of the caller that is 1 in this second pass, else 0."""

TEMPORARY_BOUNDS = {"earliest_delay": 0.0, "delay": 0.0, "undecided_time": float("inf")}
"""Error bounds within a stage, with their values in a loop without error bounds."""


@dataclass(frozen=True)
class Loop:
    """The event loop of a scene.

    Attributes
    ----------
    fields
        The fields of a shot.
    job
        The numbers that the caller gives, equal for all shots of a batch.
    parameters
        The variables of the scene's parameters.
    stages
        The tree of each stage, by name, in order.
    """

    fields: tuple[Field, ...]
    job: tuple[str, ...]
    parameters: tuple[str, ...]
    stages: Mapping[str, tuple[Node, ...]] = field(repr=False)

    def __post_init__(self) -> None:
        known = {*self.job, *self.parameters, *(field.name for field in self.fields)}
        for nodes in self.stages.values():
            known = check(nodes, known)

    @property
    def counts_by_body(self) -> bool:
        """True if contacts are counted by body where they happen, and not in fields of a shot."""
        return all(field.name != "count_0" for field in self.fields)

    @cached_property
    def kinds(self) -> dict[str, VariableKind]:
        """The type of each field."""
        written = writes(node for stage in self.stages.values() for node in stage)
        return {field.name: written.get(field.name, "double") for field in self.fields}

    @property
    def influential(self) -> frozenset[str]:
        """The variables on which another one, or what is done with a shot, depends."""
        found: set[str] = set()
        for node in (node for stage in self.stages.values() for node in walk(stage)):
            if isinstance(node, Call):
                given = dict(zip(node.kernel.arguments, node.arguments, strict=True))
                for output, expression in node.kernel.outputs:
                    read = {given[symbol] for symbol in symbols_in([expression])}
                    to = node.assigned.get(output)
                    found |= {v for v in read if isinstance(v, str) and to not in (None, v)}
            elif not isinstance(node, ForEach):
                found.add(node.truth)
        return frozenset(found)

    @property
    def called(self) -> frozenset[str]:
        """The names of the kernels that the loop evaluates."""
        nodes = [node for stage in self.stages.values() for node in walk(stage)]
        groups = [table.groups for table in self.tables if table.groups is not None]
        tests = (evaluated for group in groups for evaluated in (group.box, group.near))
        return frozenset(node.kernel.name for node in (*nodes, *tests) if isinstance(node, Call))

    @property
    def shortcuts(self) -> tuple[Call, ...]:
        """The evaluations of kernels that a target may put before others."""
        nodes = (node for stage in self.stages.values() for node in walk(stage))
        return tuple(call for n in nodes if isinstance(n, Call) for call in n.shortcut)

    @property
    def tables(self) -> tuple[ForEach, ...]:
        """The nodes that are executed for each row of a table."""
        nodes = (node for stage in self.stages.values() for node in walk(stage))
        return tuple(node for node in nodes if isinstance(node, ForEach))

    @property
    def plain_values(self) -> dict[str, float]:
        """The values of the variables that the loop without diagnostic fields never assigns."""
        fixed = {f.name: f.start for f in self.fields if f.is_diagnostic and f.start is not None}
        fixed |= TEMPORARY_BOUNDS | {"position_error": 0.0, "velocity_error": 0.0, "claims": 0.0}
        return fixed | {TIGHTENING: 0.0}

    @property
    def tightens(self) -> bool:
        """True if some shots are simulated again, to tighten bounds on their errors."""
        return TIGHTENING in self.job

    def plain(self) -> Loop:
        """Return the loop without diagnostic fields; the trajectory is the same."""
        fixed = self.plain_values
        influential = tuple(field for field in self.fields if not field.is_diagnostic)
        wanted = {field.name for field in influential}
        stages: dict[str, tuple[Node, ...]] = {}
        for name, nodes in reversed(list(self.stages.items())):
            stages[name] = needed(without(nodes, fixed), wanted)
            wanted |= live_before(stages[name], wanted)
        stages = {name: own for name, own in reversed(stages.items()) if own}
        job = tuple(j for j in self.job if j not in fixed)
        return Loop(influential, job, self.parameters, stages)
