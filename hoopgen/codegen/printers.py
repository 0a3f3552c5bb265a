"""Printing programs: one small table of spellings per target."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from .program import Operations


@dataclass(frozen=True)
class Spelling:
    """How a target writes the operations; `{0}` … are the operands, already printed.

    Attributes
    ----------
    number, truth
        The types of what has a value, and of what holds or does not.
    told
        How a truth is given away.
    """

    operations: dict[str, str]
    constant: str
    infinity: str
    assignment: str
    number: str = ""
    truth: str = ""
    told: str = "{0}"


_INFIX = {
    "add": "({0} + {1})",
    "sub": "({0} - {1})",
    "mul": "({0} * {1})",
    "div": "({0} / {1})",
    "neg": "(-{0})",
}

NUMPY = Spelling(
    operations=_INFIX
    | {
        "sqrt": "_sqrt({0})",
        "abs": "_absolute({0})",
        "max": "_where({0} < {1}, {1}, {0})",
        "min": "_where({0} < {1}, {0}, {1})",
        "less": "({0} < {1})",
        "at_most": "({0} <= {1})",
        "equal": "({0} == {1})",
        "both": "_logical_and({0}, {1})",
        "either": "_logical_or({0}, {1})",
        "not": "_logical_not({0})",
        "nowhere": "False",
        "select": "_where({0}, {1}, {2})",
    },
    constant="{0}",
    infinity="_inf",
    assignment="{name} = {value}",
)

NUMPY_SINGLE = replace(NUMPY, constant="_float32({0})", infinity="_float32(_inf)")
"""Before NumPy 2 one number of single precision and one of Python's make a double."""

ALONE = replace(
    NUMPY,
    operations=NUMPY.operations
    | {
        "sqrt": "_root({0})",
        "abs": "abs({0})",
        "max": "({1} if {0} < {1} else {0})",
        "min": "({0} if {0} < {1} else {1})",
        "both": "({0} and {1})",
        "either": "({0} or {1})",
        "not": "(not {0})",
        "select": "({1} if {0} else {2})",
    },
)
"""NumPy for one shot: operations of numbers."""

C = Spelling(
    operations={
        "add": "lanes_add({0}, {1})",
        "sub": "lanes_sub({0}, {1})",
        "mul": "lanes_mul({0}, {1})",
        "div": "lanes_div({0}, {1})",
        "neg": "lanes_neg({0})",
        "sqrt": "lanes_sqrt({0})",
        "abs": "lanes_abs({0})",
        "max": "lanes_max({0}, {1})",
        "min": "lanes_min({0}, {1})",
        "less": "lanes_less({0}, {1})",
        "at_most": "lanes_at_most({0}, {1})",
        "equal": "lanes_equal({0}, {1})",
        "both": "lanes_both({0}, {1})",
        "either": "lanes_either({0}, {1})",
        "not": "lanes_not({0})",
        "nowhere": "lanes_nowhere()",
        "select": "lanes_select({0}, {1}, {2})",
    },
    constant="K({0})",
    infinity="K(INFINITY)",
    assignment="const {type} {name} = {value};",
    number="V",
    truth="M",
)

C_SINGLE = Spelling(
    operations={name: text.replace("lanes_", "singles_") for name, text in C.operations.items()},
    constant="KS({0})",
    infinity="KS(INFINITY)",
    assignment=C.assignment,
    number="S",
    truth="Q",
    told="singles_truth({0})",
)


JS = Spelling(
    operations=_INFIX
    | {
        "sqrt": "Math.sqrt({0})",
        "abs": "Math.abs({0})",
        "max": "({0} < {1} ? {1} : {0})",
        "min": "({0} < {1} ? {0} : {1})",
        "less": "({0} < {1})",
        "at_most": "({0} <= {1})",
        "equal": "({0} === {1})",
        "both": "({0} && {1})",
        "either": "({0} || {1})",
        "not": "(!{0})",
        "nowhere": "false",
        "select": "({0} ? {1} : {2})",
    },
    constant="{0}",
    infinity="Infinity",
    assignment="const {name} = {value};",
)


@dataclass(frozen=True)
class Body:
    """A printed program: statements, then one expression for each output; rows that it needs."""

    statements: list[str]
    outputs: list[str]
    rows: int = 0


def constant(value: float, spelling: Spelling) -> str:
    """Return a double so that it reads back to the same bits."""
    if math.isinf(value):
        return spelling.infinity if value > 0 else _negative(spelling)
    return spelling.constant.format(repr(value))


def _negative(spelling: Spelling) -> str:
    """Return minus infinity, within the brackets of a constant if it has some."""
    opening, bracket, rest = spelling.infinity.partition("(")
    return f"{opening}(-{rest}" if bracket else f"(-{spelling.infinity})"


class Constants:
    """The numbers in a module's kernels, each made once: to make one costs as much as its use.

    What meets rows is an array of no dimension, which NumPy need not turn into one; what meets
    numbers alone is a number, with which NumPy is quickest.
    """

    def __init__(self) -> None:
        self._names: dict[str, str] = {}

    def of(self, program: Operations, value: float, meets_rows: bool) -> str:
        """Return the name of a number of a program, or how it is written."""
        single = [_number_of(program)] if program.single else []
        return self.name(value, *["_scalar"] * meets_rows, *single)

    def name(self, value: float, *makers: str) -> str:
        """Return the name of what some functions make of a number, the last one first."""
        made = constant(value, NUMPY)
        if not makers:
            return made
        for maker in reversed(makers):
            made = f"{maker}({bare(made)})"
        return self._names.setdefault(made, f"_k{len(self._names)}")

    @property
    def lines(self) -> list[str]:
        """The lines that make them."""
        return [f"{name} = {made}" for made, name in self._names.items()]


def _number_of(program: Operations) -> str:
    """Return what makes a number of NumPy, in the precision of a program."""
    return "_float32" if program.single else "_float64"


def print_program(
    program: Operations, spelling: Spelling, constants: Constants | None = None
) -> Body:
    """Return the statements and output expressions of a program in one target's spelling.

    With constants its numbers are NumPy's throughout: one of Python's cannot be divided by zero.
    """
    named = program.named()
    text: list[str] = []
    statements: list[str] = []
    for index, operation in enumerate(program.operations):
        if operation.name in ("argument", "truth"):
            text.append(operation.symbol)
        elif operation.name == "constant":
            number = operation.value
            made = constants.name(number, _number_of(program)) if constants else ""
            text.append(made or constant(number, spelling))
        else:
            operands = (text[operand] for operand in operation.operands)
            value = spelling.operations[operation.name].format(*operands)
            if index in named:
                name = f"_s{len(statements)}"
                kind = spelling.truth if operation.is_truth else spelling.number
                statements.append(
                    spelling.assignment.format(name=name, type=kind, value=bare(value))
                )
                value = name
            text.append(value)
    outputs = []
    for output in program.outputs:
        value = bare(text[output])
        truth = program.operations[output].is_truth
        outputs.append(spelling.told.format(value) if truth else value)
    return Body(statements, outputs)


def bare(text: str) -> str:
    """Return text without a pair of parentheses that encloses all of it."""
    if not (text.startswith("(") and text.endswith(")")):
        return text
    depth = 0
    for position, character in enumerate(text):
        depth += {"(": 1, ")": -1}.get(character, 0)
        if depth == 0 and position < len(text) - 1:
            return text
    return text[1:-1]
