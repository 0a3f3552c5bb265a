"""Printing for C how the values of shots get into a list of some of them, and back."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ground.kernel import Kind
from hoopgen.derive.ground.tree import Guard, Repeat

from .apart import CApart
from .groups import Frame
from .loop import FILLED, PACKED


@dataclass
class CTransfers(CApart):
    """Transfers between the rows of a list and the columns of another.

    Attributes
    ----------
    bases
        By what is of the row at hand of a table, the array that has its values, as if a parameter.
    """

    bases: dict[str, str] = field(default_factory=dict)

    def _column(self, frame: Frame, name: str, kind: Kind) -> None:
        self.columns.setdefault(f"{frame.prefix}{name}", kind)

    def _parameter(self, frame: Frame, name: str, row: str = "i") -> str:
        """A parameter's values for the rows from i on; one that all share has one row of lanes."""
        shared = self.bases.get(name, f"lists->{name}")
        if not frame.prefix:
            return f"lanes_load({shared} + ({row} & varying))"
        return f"lanes_load(varying ? {frame.column(name)} + {row} : {shared})"

    def _pack(
        self,
        cut: Guard | Repeat,
        frame: Frame,
        own: Frame,
        takes: Iterable[str],
        known: dict[str, Kind],
    ) -> None:
        line = self.lines.append
        seldom: list[str] = []
        line(f"    const M packed = lanes_both(rows, {cut.truth});")
        line("    if (lanes_any(packed)) {")
        line(
            f"        lanes_pack({own.column('row')} + {own.count}, packed, "
            "lanes_add(lanes_count_up(), K((double)i)));"
        )
        self._column(own, "row", "double")
        for name in takes:
            if name in self.job:
                continue
            self._column(own, name, known[name])
            place = f"{own.column(name)} + {own.count}"
            if name in self.parameters:
                value = self._parameter(frame, name)
                seldom.append(f"            lanes_pack({place}, packed, {value});")
            elif isinstance(cut, Repeat) and name == cut.truth:
                continue
            else:
                line(f"        {PACKED[known[name]].format(place, name)};")
                own.known[name] = known[name]
        if seldom:
            self.lines += ["        if (LANES_SELDOM(varying)) {", *seldom, "        }"]
        line(f"        {own.count} += lanes_many(packed);")
        line("    }")

    def _fill(self, own: Frame, takes: Iterable[str]) -> None:
        """Print that the lanes behind a list's end have zeros, not what memory happened to hold."""
        line = self.lines.append
        line(f"if ({own.count}) {{")
        line(f"    lanes_store({own.column('row')} + {own.count}, K(0.0));")
        for name in takes:
            if name in own.known:
                line(f"    {FILLED[own.known[name]].format(f'{own.column(name)} + {own.count}')};")
        seldom = [name for name in takes if name in self.parameters]
        if seldom:
            line("    if (LANES_SELDOM(varying)) {")
            self.lines += [
                f"        lanes_store({own.column(name)} + {own.count}, K(0.0));" for name in seldom
            ]
            line("    }")
        line("}")

    def _return(self, frame: Frame, own: Frame, gives: Sequence[str]) -> None:
        line = self.lines.append
        line(f"for (size_t k = 0; k < {own.count}; k++) {{")
        line(f"    const size_t row = (size_t){own.column('row')}[k];")
        for name in gives:
            self._column(frame, name, frame.known[name])
            line(f"    {frame.column(name)}[row] = {own.column(name)}[k];")
        line("}")
