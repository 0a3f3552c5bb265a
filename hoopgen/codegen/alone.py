"""Printing a body of the event loop for one shot: numbers in place of rows.

A call of NumPy costs as much for one shot as for some tens. Where a body that repeats is needed by
a few shots, they go through it one by one, in operations of NumPy's numbers, with the same bits.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from hoopgen.derive.ground.tree import Do, Each, Guard, Node, Repeat, Value

from .printers import Constants


@dataclass
class Alone:
    """The functions of a module that take one shot through a body.

    Attributes
    ----------
    constants
        The numbers of the module.
    lines
        What has been printed.
    called
        The kernels that are called.
    """

    constants: Constants
    lines: list[str] = field(default_factory=list)
    called: set[str] = field(default_factory=set)
    counter: int = 0

    def function(
        self, node: Guard | Repeat, takes: Sequence[str], gives: Sequence[str], short: set[str]
    ) -> str:
        """Print a body for a shot that needs it; return the name of the function.

        What is in single precision, a name of `short`, stays so.
        """
        name = f"_alone{self.counter}"
        self.counter += 1
        given = [_name(variable) for variable in takes]
        if isinstance(node, Repeat):
            given.append("_turns")
        line = self.lines.append
        self.lines += ["", ""]
        line(f"def {name}({', '.join(f'{one}: Any' for one in given)}) -> tuple[Any, ...]:")
        line(f'    """Do the body of `{node.truth}` for one shot."""')
        if isinstance(node, Repeat):
            self._turns(node, "_turns", "    ", short)
        else:
            self._body(node.body, "    ", short)
        line(f"    return ({', '.join(_name(variable) for variable in gives)},)")
        return name

    def _body(self, nodes: Sequence[Node], indent: str, short: set[str]) -> None:
        for node in nodes:
            if isinstance(node, Do):
                self._do(node, indent, short)
            elif isinstance(node, Each):
                self._each(node, indent, short)
            elif isinstance(node, Guard):
                self.lines.append(f"{indent}if {_name(node.truth)}:")
                self._body(node.body, indent + "    ", short)
            else:
                self._turns(node, str(node.limit), indent, short)

    def _turns(self, node: Repeat, turns: str, indent: str, short: set[str]) -> None:
        line = self.lines.append
        line(f"{indent}for _ in range({turns}):")
        line(f"{indent}    if not {_name(node.truth)}:")
        line(f"{indent}        break")
        self._body(node.body, indent + "    ", short)

    def _each(self, node: Each, indent: str, short: set[str]) -> None:
        line = self.lines.append
        line(f"{indent}for {', '.join(map(_name, node.names))}, in (")
        for row in node.rows:
            line(f"{indent}    ({', '.join(map(self._number, row))},),")
        line(f"{indent}):")
        self._body(node.body, indent + "    ", short)

    def _do(self, node: Do, indent: str, short: set[str]) -> None:
        kernel = node.kernel
        self.called.add(kernel.name)
        given = ", ".join(self._given(v, short, kernel.single) for v in node.arguments)
        kinds = dict(zip(kernel.output_names, kernel.kinds, strict=True))
        short |= {v for o, v in node.assigned.items() if kinds[o] == "single"}
        targets = [
            _name(node.assigned[o]) if o in node.assigned else "_" for o in kernel.output_names
        ]
        self.lines.append(f"{indent}{', '.join(targets)}, = _{kernel.name}_alone({given})")

    def _given(self, value: Value, short: set[str], single: bool) -> str:
        kind = "_float32" if single else "_float64"
        if isinstance(value, str) and (value in short) != single:
            return f"{kind}({_name(value)})"
        return self._number(value, kind)

    def _number(self, value: Value, kind: str = "_float64") -> str:
        return _name(value) if isinstance(value, str) else self.constants.name(float(value), kind)


def _name(variable: str) -> str:
    """Return a variable as a name in a function for one shot."""
    return f"_{variable}_"
