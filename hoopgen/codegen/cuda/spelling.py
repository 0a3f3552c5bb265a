"""CUDA's spelling of operations on the numbers of one shot, and its formatter."""

from __future__ import annotations

from dataclasses import dataclass, replace

from hoopgen.derive.ir.kernel import Kind

from ..c_syntax import CSyntax
from ..formatter import ONE_SHOT, Spelling
from ..statements import Apply, Call, Expression, Name, Statement

DOUBLE = Spelling(
    operations=ONE_SHOT
    | {
        "sqrt": "sqrt({0})",
        "abs": "fabs({0})",
        "max": "larger({0}, {1})",
        "min": "smaller({0}, {1})",
        "select": "choose({0}, {1}, {2})",
    },
    infinity="(INFINITE)",
    number="double",
    truth="bool",
)

SINGLE = replace(
    DOUBLE,
    operations={**DOUBLE.operations, "sqrt": "sqrtf({0})", "abs": "fabsf({0})"},
    constant="((float){0})",
    infinity="((float)INFINITE)",
    number="float",
)

TYPES: dict[Kind, str] = {"double": "double", "single": "float", "truth": "bool"}
"""The type of a variable in CUDA."""


def parameter_of_shot(number: Expression) -> Expression:
    """Return a parameter of the shot at hand, by its number."""
    return Apply("parameter", (Name("_given"), number))


@dataclass(frozen=True)
class CudaFormatter(CSyntax):
    """A formatter of CUDA: a kernel of derive/ is a function that returns a struct."""

    def statement(self, statement: Statement) -> list[str]:
        """Return the lines of one statement."""
        match statement:
            case Call(name, arguments, (result,)):
                return [f"const {name}_out {result} = {name}({self.expressions(arguments)});"]
        return super().statement(statement)


CUDA_FORMATTER = CudaFormatter(DOUBLE, SINGLE)
