"""Printing for C what is seldom done: functions, out of the way of what is done often."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ground.kernel import Kind
from hoopgen.derive.ground.tree import Node

from .groups import CGroups, Frame


@dataclass(frozen=True)
class Apart:
    """A rare body that is a function of its own: its name, what it is given, and its lines.

    In the long function of all the others it would take registers from what most shots do.
    """

    name: str
    given: dict[str, str]
    lines: list[str]


@dataclass
class CApart(CGroups):
    """What makes functions.

    Attributes
    ----------
    job
        What has one value for all.
    variant
        Of the loop, as its functions have it in their names.
    columns
        By array, in order, what it holds: what the struct of the lists has room for.
    apart
        The functions, each after those that it calls.
    """

    job: Sequence[str] = ()
    variant: str = ""
    columns: dict[str, Kind] = field(default_factory=dict)
    apart: list[Apart] = field(default_factory=list)

    def _set_apart(self, name: str, frame: Frame, first: int) -> None:
        """Make a function of the lines from one on, and call it where it has any shots."""
        lines = self.lines[first:]
        words = set(re.findall(r"\w+", "\n".join(lines)))
        kinds = {frame.count: "size_t", "varying": "size_t"} | dict.fromkeys(self.job, "V")
        given = {value: kind for value, kind in kinds.items() if value in words}
        self.lines[first:] = [f"if ({frame.count})", f"    {self._call(name, given, lines)}"]

    def _call(self, name: str, given: dict[str, str], lines: list[str]) -> str:
        """Make a function of lines, and return a call of it."""
        self.apart.append(Apart(name, given, lines))
        return f"LANES({self.prefix}_{self.variant}_{name})({', '.join(('lists', *given))});"

    def _fix(self, nodes: Sequence[Node], frame: Frame, turning: bool = False) -> None:
        """Print what kernels are given ready made, where each shot has its own parameters.

        It is a function: beside what is done for all it would be in the way.
        """
        rows = self.fixed.of(nodes)
        given = {"taken": "size_t", "idle": "M"} if turning else {"i": "size_t"}
        held = "lanes_expand({0} + taken, idle, lanes_load(lists->turning_{1}))"
        value = held if turning else "lanes_load({0} + i)"
        read = {name: value.format(frame.column(name), name) for name in self.fixed.reads(rows)}
        if read:
            lines = [f"const V {name} = {text};" for name, text in read.items()]
            if turning:
                self.columns |= dict[str, Kind]((f"turning_{name}", "double") for name in read)
                lines += [f"lanes_store(lists->turning_{name}, {name});" for name in read]
            call = self._call(f"fix{self.fresh('f')}", given, [*lines, *self.fixed.lines(rows)])
            indent = " " * (12 if turning else 4)
            self.lines += [f"{indent}if (LANES_SELDOM(varying))", f"{indent}    {call}"]

    def _read(self, name: str, first: int) -> bool:
        """Whether lines from one on have a name in them."""
        return any(re.search(rf"(?<!->)\b{name}\b", text) for text in self.lines[first:])
