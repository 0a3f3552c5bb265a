"""Printing groups of bodies for C: those that no shot comes near are left out as a whole.

A pass over a list of shots goes over its rows of lanes; for the bodies of a group over those alone
that have a shot near it, and for a group within another over some of those.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from hoopgen.derive.ground.kernel import Kind
from hoopgen.derive.ground.tree import Each, Group, Groups

from .loop import CLoop


@dataclass
class Frame:
    """A list of shots, the variables that it has columns for, and the row that it begins with.

    With `blocks`, where they begin and how many, a pass goes over those rows of lanes alone.
    """

    prefix: str
    known: dict[str, Kind]
    first: str = "0"
    blocks: tuple[str, str] = ("", "")

    @property
    def count(self) -> str:
        """The C variable of its length."""
        return f"{self.prefix}shots"

    def column(self, name: str) -> str:
        """Return the array of a variable."""
        return f"lists->{self.prefix}{name}"

    @property
    def over(self) -> list[str]:
        """Where a loop over its rows of lanes begins, the first of them at `i`."""
        begin, many = self.blocks
        if not begin:
            return [f"for (size_t i = {self.first}; i < {self.count}; i += LANES_WIDTH) {{"]
        return [f"for (size_t b = 0; b < {many}; b++) {{", f"    const size_t i = {begin}[b];"]


@dataclass
class CGroups(CLoop):
    """What prints the groups of a table.

    Attributes
    ----------
    parameters
        What has one value for all shots, or one for each.
    once
        Lines that are done once, before the others.
    """

    parameters: Sequence[str] = ()
    once: list[str] = field(default_factory=list)

    def table(self, node: Each, row: str, indent: str) -> tuple[dict[str, str], dict[str, str]]:
        """Print a table; return what is of the row at hand: arrays, and numbers."""
        raise NotImplementedError

    def _boxes(
        self, node: Each, groups: Groups, row: str
    ) -> tuple[str, dict[str, str], dict[str, str]]:
        """Print a table and its groups, once, and their boxes, endless where a shot has own sizes.

        Returns
        -------
        tuple
            What the table of groups is called, and what `table` returns.
        """
        begun = len(self.lines)
        bases, numbers = self.table(node, row, "")
        self.once += self.lines[begun:]
        del self.lines[begun:]
        name, line = self.fresh("g"), self.once.append
        columns = dict(zip(node.names, node.columns, strict=True))
        asked = [v for v in groups.box.arguments if isinstance(v, str)]
        sizes = {size for v in asked for size in columns.get(v, (v,))}
        places = sorted(self.parameters.index(size) for size in sizes if isinstance(size, str))
        kernel, outputs = groups.box.kernel, groups.box.kernel.output_names
        line(f"static const size_t {name}[][4] = {{")
        for group, depth in zip(groups.members, depths(groups.members), strict=True):
            line(f"    {{{group.first}, {group.past}, {group.after}, {depth}}},")
        line("};")
        line(f"static const int {name}_sizes[] = {{{', '.join(map(str, places))}}};")
        line(f"double {name}_boxes[{len(groups.members)}][{len(outputs)}];")
        line("{")
        line("    int64_t differing = 0;")
        line(f"    for (size_t k = 0; k < {len(places)}; k++)")
        line(f"        differing |= job->strides[{name}_sizes[k]];")
        line(f"    for (size_t g = 0; g < {len(groups.members)}; g++) {{")
        line(f"        V {', '.join(f'{output} = K(-INFINITY)' for output in outputs)};")
        line(f"        for (size_t {row} = {name}[g][0]; {row} < {name}[g][1]; {row}++) {{")
        line(f"            const LANES({self.prefix}_{kernel.name}_out) box =")
        given = ", ".join(f"lanes_load({bases.get(v, f'lists->{v}')})" for v in asked)
        line(f"                LANES({self.prefix}_{kernel.name})({given});")
        for output in outputs:
            line(f"            {output} = lanes_max({output}, box.{output});")
        line("        }")
        line("        double all[LANES_WIDTH];")
        for k, output in enumerate(outputs):
            line(f"        lanes_store(all, {output});")
            line(f"        {name}_boxes[g][{k}] = differing ? INFINITY : *all;")
        line("    }")
        line("}")
        return name, bases, numbers

    def _near(self, groups: Groups, name: str, row: str, frame: Frame) -> Frame:
        """Print where the loop over the groups begins, and that over the rows of one.

        Returns
        -------
        Frame
            The list, without the rows of lanes that have no shot near the group.
        """
        line, levels = self.lines.append, max(depths(groups.members)) + 2
        blocks, many = f"{name}_blocks", f"{name}_many"
        line(f"size_t {blocks}[{levels}][LANES_ROWS / LANES_WIDTH], {many}[{levels}] = {{0}};")
        self.lines += frame.over
        line(f"    {blocks}[0][{many}[0]++] = i;")
        line("}")
        self._group(groups, name)
        line(f"    const size_t depth = {name}[g][3];")
        line("    size_t kept = 0;")
        line(f"    for (size_t b = 0; b < {many}[depth]; b++) {{")
        line(f"        const size_t i = {blocks}[depth][b];")
        for asked in sorted(groups.asked):
            line(f"        const V {asked} = lanes_load({frame.column(asked)} + i);")
        line(f"        if ({self._any_near(groups, f'lanes_first({frame.count} - i)')})")
        line(f"            {blocks}[depth + 1][kept++] = i;")
        line("    }")
        line(f"    {many}[depth + 1] = kept;")
        self._members(name, row, "kept")
        return replace(frame, blocks=(f"{blocks}[depth + 1]", "kept"))

    def _group(self, groups: Groups, name: str, indent: str = "") -> None:
        """Print where the loop over the groups begins."""
        line = self.lines.append
        line(f"{indent}for (size_t g = 0, next; g < {len(groups.members)}; g = next) {{")
        for k, output in enumerate(groups.box.kernel.output_names):
            line(f"{indent}    const V {output} = K({name}_boxes[g][{k}]);")

    def _any_near(self, groups: Groups, mask: str) -> str:
        """Return whether a shot of a mask is near the group at hand."""
        kernel = groups.near.kernel
        (truth,) = kernel.output_names
        given = ", ".join(self._value(value) for value in groups.near.arguments)
        return f"lanes_any(lanes_both({mask}, LANES({self.prefix}_{kernel.name})({given}).{truth}))"

    def _members(self, name: str, row: str, near: str, indent: str = "") -> None:
        """Print which group is next, and where the loop begins over the rows of this one alone."""
        line = self.lines.append
        line(f"{indent}    next = {near} ? g + 1 : {name}[g][2];")
        line(f"{indent}    const size_t past = {near} && next == {name}[g][2] ? {name}[g][1] : 0;")
        line(f"{indent}    for (size_t {row} = {name}[g][0]; {row} < past; {row}++) {{")


def depths(members: Sequence[Group]) -> list[int]:
    """Return how many groups each one is within."""
    found: list[int] = []
    for k, group in enumerate(members):
        around = [j for j in range(k) if members[j].after > k]
        found.append(len(around))
        assert all(members[j].past >= group.past for j in around), "a group reaches out of another"
    return found
