"""The LaTeX of formulas: numbers by powers of two, choices in rows, conditions with their signs."""

from __future__ import annotations

import re
from collections.abc import Mapping

import sympy as sp
from sympy.printing.latex import LatexPrinter

from hoopgen.derive.symbolic.conditionals import (
    And,
    Barrier,
    Boolean,
    Choose,
    Condition,
    IfAtMost,
    IfLess,
    Not,
    Or,
    release,
)
from hoopgen.derive.symbolic.notation import ROUNDOFF
from hoopgen.derive.symbolic.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY

from .scene_notation import SceneNotation

Names = Mapping[sp.Basic, str]
"""LaTeX of symbols and quantities that have a name."""


class Printer(LatexPrinter):  # type: ignore[misc]
    """A printer of LaTeX for GitHub, without bars, which end a table cell, or forbidden macros."""

    def __init__(self, names: Names, notation: SceneNotation) -> None:
        super().__init__({"mat_delim": "("})
        self._names, self._notation = names, notation
        self._printed: dict[sp.Basic, str] = {}

    def _print(self, expr: sp.Basic, **options: object) -> str:
        """Return the LaTeX of a part, which is printed once: it occurs in many."""
        if options or not isinstance(expr, sp.Basic):
            return str(super()._print(expr, **options))
        if expr not in self._printed:
            self._printed[expr] = str(super()._print(expr))
        return self._printed[expr]

    def doprint(self, expr: sp.Basic) -> str:
        """Return the LaTeX, with space between words and their factors."""
        text = str(super().doprint(expr))
        text = re.sub(r"(\\text\{[^}]*\}) (?=\\text|\\left|[A-Za-z0-9])", r"\1\\, ", text)
        return re.sub(r"(?<![A-Za-z\\])([A-Za-z0-9]|_\{\w+\}) (?=\\text\{)", r"\1\\, ", text)

    def _as_ordered_terms(self, expr: sp.Add, order: str | None = None) -> list[sp.Expr]:
        """Return added terms before subtracted ones, short products and coordinates first."""
        moving = {*POSITION, *VELOCITY}
        terms = super()._as_ordered_terms(expr, order)
        return sorted(
            terms,
            key=lambda term: (
                term.could_extract_minus_sign(),
                _degree(term),
                not term.free_symbols & moving,
            ),
        )

    def _print_Symbol(self, symbol: sp.Symbol, style: str = "plain") -> str:
        return self._names.get(symbol) or self._notation(symbol)

    def _print_Pow(self, expr: sp.Pow) -> str:
        """Return a power; a name with an exponent of its own stands in brackets."""
        if expr.base.is_Symbol and expr.exp.is_Integer and expr.exp > 1:
            name = self._print(expr.base)
            if "^" in name or "'" in name:
                return self._power(rf"\left({name}\right)", str(expr.exp))
        return str(super()._print_Pow(expr))

    def _power(self, text: str, exponent: str | None) -> str:
        return text if exponent is None else f"{text}^{{{exponent}}}"

    def _print_Barrier(self, held: Barrier, exp: str | None = None) -> str:
        return self._power(rf"\left({self._print(held.args[0])}\right)", exp)

    def _print_Abs(self, size: sp.Abs, exp: str | None = None) -> str:
        return self._power(rf"\left\lvert {self._print(size.args[0])}\right\rvert", exp)

    def _print_choice(self, choice: sp.Expr, exp: str | None = None) -> str:
        found = extreme(choice)
        if found is not None:
            name, values = found
            inner = ", ".join(self._print(value) for value in values)
            text = rf"{name}\left({inner}\right)"
            return text if exp is None else rf"\left({text}\right)^{{{exp}}}"
        lines = []
        for value, conditions in cases(choice):
            when = r",\ ".join(self._print_condition(c) for c in conditions) or r"\text{else}"
            formula = self._print(value).replace(r"\frac", r"\dfrac")
            lines.append(f"{formula} & {when}")
        body = r" \\ ".join(lines)
        text = rf"\begin{{cases}} {body} \end{{cases}}"
        return text if exp is None else rf"\left({text}\right)^{{{exp}}}"

    _print_IfLess = _print_choice
    _print_IfAtMost = _print_choice
    _print_Choose = _print_choice

    def _print_condition(self, choice: sp.Expr) -> str:
        if isinstance(choice, Condition | Boolean):
            return str(self._print(choice))
        return self._compared(choice, "<" if isinstance(choice, IfLess) else r"\le")

    def _compared(self, condition: sp.Expr, sign: str) -> str:
        return f"{self._print(condition.args[0])} {sign} {self._print(condition.args[1])}"

    def _print_Less(self, condition: sp.Expr) -> str:
        return self._compared(condition, "<")

    def _print_AtMost(self, condition: sp.Expr) -> str:
        return self._compared(condition, r"\le")

    def _print_Equal(self, condition: sp.Expr) -> str:
        return self._compared(condition, "=")

    def _print_And(self, condition: sp.Expr) -> str:
        return self._joined(condition, r"\wedge")

    def _print_Or(self, condition: sp.Expr) -> str:
        return self._joined(condition, r"\vee")

    def _joined(self, condition: sp.Expr, sign: str) -> str:
        """Return two conditions, joined, with brackets around those joined otherwise."""
        other = {And: Or, Or: And}[type(condition)]
        parts = [
            rf"\left({self._print(c)}\right)" if isinstance(c, other) else self._print(c)
            for c in condition.args
        ]
        return f" {sign} ".join(parts)

    def _print_Not(self, condition: sp.Expr) -> str:
        (inner,) = condition.args
        text: str = self._print(inner)
        return rf"\neg {text}" if isinstance(inner, Boolean | Not) else rf"\neg \left({text}\right)"

    def _print_False_(self, _: sp.Expr) -> str:
        return r"\text{never}"


def _degree(term: sp.Expr) -> int:
    """Return the number of factors of a product, with powers counted by their exponents."""
    powers = (factor.as_base_exp()[1] for factor in sp.Mul.make_args(term) if not factor.is_number)
    return sum(int(p) if p.is_Integer and p > 0 else 1 for p in powers)


def extreme(choice: sp.Expr) -> tuple[str, list[sp.Expr]] | None:
    """Return the name and the operands of a choice that is a maximum or minimum of two values."""
    if not isinstance(choice, IfLess):
        return None
    left, right, then, other = choice.args
    if (then, other) == (right, left):
        name, first = r"\max", left
    elif (then, other) == (left, right):
        name, first = r"\min", right
    else:
        return None
    inner = extreme(first)
    firsts = inner[1] if inner is not None and inner[0] == name else [first]
    return name, [*firsts, then if first is other else other]


def cases(choice: sp.Expr) -> list[tuple[sp.Expr, list[sp.Expr]]]:
    """Return values with their conditions; the first value whose conditions hold is taken."""
    rows: list[tuple[sp.Expr, list[sp.Expr]]] = []

    def visit(expression: sp.Expr, conditions: list[sp.Expr]) -> None:
        if isinstance(expression, IfLess | IfAtMost) and extreme(expression) is None:
            visit(expression.args[2], [*conditions, expression])
            visit(expression.args[3], conditions)
        elif isinstance(expression, Choose):
            visit(expression.args[1], [*conditions, expression.args[0]])
            visit(expression.args[2], conditions)
        else:
            rows.append((expression, conditions))

    visit(choice, [])
    # The last rows with the same value need no conditions.
    while len(rows) > 1 and rows[-2][0] == rows[-1][0]:
        del rows[-2]
    return rows


def number(value: sp.Rational) -> str | None:
    """Return the LaTeX of a positive number by powers of two; None to print it plainly."""
    if value.q == 1:
        exponent = int(value.p).bit_length() - 1
        return f"2^{{{exponent}}}" if exponent >= 16 and value == 2**exponent else None
    if value.q & (value.q - 1):
        return None
    for k in range(8, 31):
        slightly = 1 + sp.Rational(1, 2**k)
        rest = value / slightly
        if value.p % slightly.p == 0 and rest.p < 2**10:
            factor = rf"\left(1 + 2^{{-{k}}}\right)"
            return factor if rest == 1 else f"{number(rest) or show(rest)} {factor}"
    if value.q < 2**10:
        return None
    units = value / UNIT_ROUNDOFF
    if units.q == 1 and units < 2**10:
        return ROUNDOFF if units == 1 else f"{units} {ROUNDOFF}"
    power = rf"2^{{-{int(value.q).bit_length() - 1}}}"
    return power if value.p == 1 else rf"{value.p} \cdot {power}"


def show(
    expression: sp.Expr | sp.Matrix,
    names: Names | None = None,
    notation: SceneNotation | None = None,
) -> str:
    """Return the LaTeX of an expression with nothing held.

    Parameters
    ----------
    expression
        A SymPy expression or matrix; barriers in it are left out.
    names
        The LaTeX of some of its parts, which stand for them; None for none.
    notation
        The letters of the parameters; None for words.
    """
    return str(Printer(names or {}, notation or SceneNotation()).doprint(release(expression)))
