"""A toy target: the event loop of one shot in scalar C, which shows what a target takes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import count
from pathlib import Path
from typing import Any

from hoopgen.derive.ir import event_tree as ir
from hoopgen.derive.ir.event_tree import Node, writes

from hoopgen.codegen.backend import KernelView, LoweredScene
from hoopgen.codegen.formatter import INFIX, Formatter, Spelling
from hoopgen.codegen.statements import (
    Assign,
    Break,
    Call,
    For,
    If,
    Member,
    Name,
    Number,
    Operate,
    Scalar,
    Statement,
)
from hoopgen.codegen.straight_line import PrintedBody, print_body, straight_line

DOUBLE = Spelling(
    operations=INFIX
    | {
        "sqrt": "sqrt({0})",
        "abs": "fabs({0})",
        "max": "({0} < {1} ? {1} : {0})",
        "min": "({0} < {1} ? {0} : {1})",
        "less": "({0} < {1})",
        "at_most": "({0} <= {1})",
        "equal": "({0} == {1})",
        "both": "({0} && {1})",
        "either": "({0} || {1})",
        "not": "(!{0})",
        "nowhere": "0",
        "select": "({0} ? {1} : {2})",
    },
    infinity="(INFINITY)",
    number="double",
    truth="int",
)
SINGLE = replace(
    DOUBLE,
    operations={**DOUBLE.operations, "sqrt": "sqrtf({0})", "abs": "fabsf({0})"},
    constant="((float){0})",
    infinity="((float)INFINITY)",
    number="float",
)
TYPES = {"double": "double", "single": "float", "truth": "int"}


class ToyFormatter(Formatter):
    def statement(self, statement: Statement) -> list[str]:
        match statement:
            case Assign(target, value):
                return [f"{self.expression(target)} = {self.expression(value)};"]
            case Call(name, given, (result,)):
                return [f"const {name}_out {result} = k_{name}({self.expressions(given)});"]
            case Break():
                return ["break;"]
            case If(test, body, ()):
                return [f"if ({self.expression(test)}) {{", *self.body(body), "}"]
            case For(index, end, body, ()):
                head = f"for (int {index} = 0; {index} < {self.expression(end)}; {index}++) {{"
                return [head, *self.body(body), "}"]
        return super().statement(statement)


FORMATTER = ToyFormatter(DOUBLE, SINGLE, "const {type} {name} = {value};")


class ToyKernel(KernelView):
    @property
    def body(self) -> PrintedBody:
        return print_body(straight_line(self.program, SINGLE if self.single else DOUBLE), FORMATTER)

    @property
    def outputs(self) -> str:
        kinds = zip(self.output_names, self.program.kernel.kinds, strict=True)
        return " ".join(f"{TYPES[kind]} {name};" for name, kind in kinds)

    @property
    def parameters(self) -> str:
        number = "float" if self.single else "double"  # a truth is 0 or 1 in it
        return ", ".join(f"{number} {name}" for name in self.arguments)


def scalar_statements(nodes: Iterable[Node], results: Iterator[int]) -> list[Statement]:
    """Return the statements of nodes for one shot."""
    found: list[Statement] = []
    for node in nodes:
        if isinstance(node, ir.Call):
            given = (Name(v) if isinstance(v, str) else Number(float(v)) for v in node.arguments)
            result = f"_o{next(results)}"
            found.append(Call(node.kernel.name, tuple(given), (result,)))
            found += [Assign(Name(v), Member(Name(result), o)) for o, v in node.assigned.items()]
        elif isinstance(node, ir.If):
            found.append(If(Name(node.truth), tuple(scalar_statements(node.body, results))))
        elif isinstance(node, ir.While):
            over = If(Operate("not", (Name(node.truth),)), (Break(),))
            body = (over, *scalar_statements(node.body, results))
            found.append(For("_turn", Scalar(node.limit), body))
        else:
            raise TypeError(f"the toy has no {type(node).__name__}")
    return found


@dataclass(frozen=True)
class ToyBackend:
    """The target; its template stands beside this file."""

    templates: Path = Path(__file__).parent
    name: str = "toy"
    options: None = None
    files: Mapping[str, str] = field(default_factory=lambda: {"toy.c.j2": "toy/{scene}.c"})
    spelling: Spelling = DOUBLE

    def kernels(self, lowered: LoweredScene) -> Mapping[str, Any]:
        called = (p for p in lowered.programs if p.kernel.name in lowered.called)
        return {"kernels": [ToyKernel(program) for program in called]}

    def loop(self, lowered: LoweredScene, kernels: Mapping[str, Any]) -> Mapping[str, Any]:
        bounded, results = lowered.variants[-1], count()
        stages = {name: nodes for name, (nodes, _) in bounded.stages.items()}
        lines = {name: FORMATTER.lines(scalar_statements(n, results)) for name, n in stages.items()}
        kinds = bounded.kinds | writes(node for nodes in stages.values() for node in nodes)
        return {
            "fields": bounded.fields,
            "variables": {name: TYPES[kind] for name, kind in kinds.items()},
            "begin": [*lines["validate"], *lines["start"]],
            "turn": [*lines["detect"], *lines["resolve"]],
        }
