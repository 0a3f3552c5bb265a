"""The variants of the event loop, and what each of their stages must leave behind."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ir.event_tree import Node, live_before, needed, writes
from hoopgen.derive.ir.kernel import Kind
from hoopgen.derive.loop.loop import REVIEW, Loop
from hoopgen.derive.state.fields import Field

Stage = tuple[tuple[Node, ...], set[str]]
"""The nodes of a stage, and the variables that are needed after it."""


@dataclass(frozen=True)
class Variant:
    """One variant of the event loop: with bounds on errors, or without.

    Attributes
    ----------
    name
        "bounded" where errors are bounded, else "plain".
    loop
        The event loop.
    stages
        By name, what each stage does for the variables that are needed after it.
    kept
        The fields that the next turn needs as this one left them; the others it assigns first.
    """

    name: str
    bounds: bool
    loop: Loop
    stages: Mapping[str, Stage] = field(repr=False)
    kept: tuple[str, ...]

    @property
    def fields(self) -> tuple[Field, ...]:
        """The fields of a shot."""
        return self.loop.fields

    @property
    def tightening(self) -> tuple[str, ...]:
        """The names of the fields of shots whose errors are tightened."""
        return tuple(field.name for field in self.fields if field.is_tightening)

    @property
    def kinds(self) -> dict[str, Kind]:
        """The kind of each field."""
        return self.loop.kinds


def variants(loop: Loop) -> tuple[Variant, Variant]:
    """Return the variants of an event loop: the path alone, and with bounds on errors."""
    return _variant("plain", False, loop.plain()), _variant("bounded", True, loop)


def _variant(name: str, bounds: bool, loop: Loop) -> Variant:
    fields = [field.name for field in loop.fields]
    stages = _stages(loop, fields)
    return Variant(name, bounds, loop, stages, _kept(stages, fields))


def _kept(stages: Mapping[str, Stage], names: Sequence[str]) -> tuple[str, ...]:
    (detect, _), (resolve, _) = stages["detect"], stages["resolve"]
    needed_again = live_before((*detect, *resolve), names)
    return tuple(name for name in names if name in needed_again)


def _stages(loop: Loop, names: Sequence[str]) -> dict[str, Stage]:
    """Return each stage's nodes, and the variables that are needed after it."""
    found: dict[str, Stage] = {}
    wanted = {*names, "body"}
    for stage, nodes in reversed(list(loop.stages.items())):
        wanted |= set(writes(nodes)) if stage == REVIEW else set()
        kept = needed(nodes, wanted)
        found[stage] = (kept, set(wanted))
        wanted = set(names) | live_before(kept, wanted)
    return dict(reversed(found.items()))
