"""The formatter of C: statements and expressions of lanes."""

from __future__ import annotations

import re
from dataclasses import dataclass

from ..c_syntax import CSyntax
from ..statements import Apply, Assign, Call, Column, Compact, ForLanes, Name, Statement
from .columns import MACROS, PAIRS, alike
from .spelling import LANES, SINGLES


@dataclass(frozen=True)
class CFormatter(CSyntax):
    """A formatter of C: columns are arrays of the struct `worklist`, values are lanes."""

    def column(self, column: Column) -> str:
        """Return a column of a list."""
        return f"worklist->{column.name}"

    def statement(self, statement: Statement) -> list[str]:
        """Return the lines of one statement."""
        if found := alike(statement):
            return [f"EACH({', '.join(found)})"]
        match statement:
            case Call(called, arguments, (result,)):
                return [f"CALL({called}, {result})({self.expressions(arguments)});"]
            case Compact(count, mask, body):
                more = Assign(Name(count), Apply("popcount", (mask,)), "+=")
                return self.braces(f"if (lanes_any({mask.name}))", (*body, more))
            case ForLanes(index, first, count, body):
                start, past = self.expression(first), self.expression(count)
                head = f"for (size_t {index} = {start}; {index} < {past}; {index} += LANES_WIDTH)"
                return self.braces(head, body)
        return super().statement(statement)


C_FORMATTER = CFormatter(LANES, SINGLES)


def macro_definitions() -> list[str]:
    """Return the definitions of the macros that stand for statements, a line each."""
    lines = []
    for macro, make in MACROS.items():
        given = ("one##", "two##") if macro in PAIRS else "of##"
        (text,) = CSyntax.statement(C_FORMATTER, make(given, "##x"))
        # A name that is part of a word is joined to it by the preprocessor; others stand alone.
        text = re.sub(r"\B##|##\B", "", text.replace("####", "##"))
        if macro in PAIRS:
            lines += [
                f"#define {macro}_IN(x, one, two) {text}",
                f"#define {macro}_OF(x, ...) {macro}_IN(x, __VA_ARGS__)",
                f"#define {macro}(of, x) {macro}_OF(x, BOTH of)",
            ]
        else:
            lines.append(f"#define {macro}(of, x) {text}")
    return lines
