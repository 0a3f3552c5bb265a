"""Formulas with named parts: a part that is held, repeated or long has a line of its own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import sympy as sp
from sympy.core.sorting import default_sort_key

from hoopgen.derive.symbolic.conditionals import (
    And,
    Barrier,
    Boolean,
    Choose,
    Condition,
    IfAtMost,
    IfLess,
    Or,
    release,
)

from .latex import Names, Printer, extreme, number
from .scene_notation import SceneNotation

Outputs = Mapping[str, sp.Basic]

ROW = 130
"""Length of LaTeX beyond which a sum is broken into rows."""
HELD = 40
"""Length of LaTeX up to which a held quantity that is used once has no name."""
REPEATED = 25
"""Length of LaTeX beyond which a sum that is used more than once has a name."""


@dataclass(frozen=True)
class Line:
    """An equation.

    Attributes
    ----------
    left
        The left side, in LaTeX.
    rows
        The rows of the right side, in LaTeX.
    means
        The object of derive/ that the right side is printed from.
    """

    left: str
    rows: tuple[str, ...]
    means: sp.Basic

    @property
    def right(self) -> str:
        """The right side in one row."""
        return " ".join(self.rows)


@dataclass(frozen=True)
class Formulas:
    """Equations.

    Attributes
    ----------
    lines
        The equations to explain.
    where
        Definitions of names in them, each after those that it uses.
    given
        Quantities that the reader knows by these names.
    """

    lines: tuple[Line, ...]
    where: tuple[Line, ...] = ()
    given: Names = field(default_factory=dict)


@dataclass(frozen=True)
class _Named:
    symbol: sp.Symbol
    content: sp.Basic
    means: sp.Basic


@dataclass
class _Explanation:
    """Expressions that are rewritten with names for held quantities."""

    given: Names
    notation: SceneNotation
    names: dict[sp.Basic, str] = field(default_factory=dict)
    where: list[_Named] = field(default_factory=list)
    uses: Counter[sp.Basic] = field(default_factory=Counter)
    _written: dict[sp.Basic, sp.Basic] = field(default_factory=dict)
    _printer: Printer = field(init=False)

    def __post_init__(self) -> None:
        self._printer = Printer(self.names, self.notation)

    def count(self, expressions: Iterable[sp.Basic]) -> None:
        """Count the uses of each part by others."""
        seen: set[sp.Basic] = set()

        def visit(expression: sp.Basic, outermost: bool = False) -> None:
            self.uses[expression] += 1
            if expression not in seen and (outermost or expression not in self.given):
                seen.add(expression)
                # A maximum or minimum contains each value twice, as a side and as a result.
                twice = extreme(expression) is not None
                for argument in expression.args[:2] if twice else expression.args:
                    visit(argument)

        for expression in expressions:
            visit(expression, outermost=True)

    def write(self, expression: sp.Basic, outermost: bool = False) -> sp.Basic:
        """Return the expression in names, the outermost one without its own."""
        if outermost:
            bare = expression.args[0] if isinstance(expression, Barrier) else expression
            return self._write(bare, outermost)
        if expression not in self._written:
            self._written[expression] = self._write(expression, outermost)
        return self._written[expression]

    def _write(self, expression: sp.Basic, outermost: bool) -> sp.Basic:
        if expression in self.given and not outermost:
            return self._symbol(self.given[expression])
        if expression.is_Rational:
            sign = sp.sign(expression)
            latex = number(abs(expression)) if sign else None
            return expression if latex is None else sign * self._symbol(latex, first=True)
        if not expression.args:
            return expression
        named = isinstance(expression, Barrier) and bool(expression.name)
        ordered = sorted(expression.args, key=default_sort_key)
        written = {a: self._write(a, outermost=True) if named else self.write(a) for a in ordered}
        inner = [written[a] for a in expression.args]
        # SymPy would distribute a sum in a sum, or times a number, if it were not held.
        spread = expression.is_Add or (len(inner) == 2 and inner[0].is_Rational)
        inner = [
            e.args[0] if isinstance(e, Barrier) and not (spread and e.args[0].is_Add) else e
            for e in inner
        ]
        rebuilt = expression.func(*inner)
        if outermost:
            return rebuilt
        return self._named(rebuilt, expression)

    def _named(self, quantity: sp.Basic, means: sp.Basic) -> sp.Basic:
        """Return a name for a quantity that is held, chosen or repeated, if it deserves one."""
        content = quantity.args[0] if isinstance(quantity, Barrier) else quantity
        own = means.name if isinstance(means, Barrier) else ""
        for known in self.where:
            if known.content == content and own in ("", self.names[known.symbol]):
                return known.symbol
        if not (own or self._worth(quantity, content, self.uses[means] > 1)):
            return quantity
        truth = isinstance(content, Condition)
        symbol = self._symbol(own or self._fresh("B" if truth else "h"), truth=truth)
        if any(known.symbol == symbol for known in self.where):
            raise ValueError(f"two quantities are called {own}")
        self.where.append(_Named(symbol, content, means))
        return symbol

    def _fresh(self, letter: str) -> str:
        taken = sum(self.names[known.symbol].startswith(f"{letter}_{{") for known in self.where)
        return f"{letter}_{{{taken + 1}}}"

    def _worth(self, quantity: sp.Basic, content: sp.Basic, repeated: bool) -> bool:
        def longer(limit: int) -> bool:
            return len(self.print(content)) > limit

        if isinstance(content, Condition):
            return repeated and longer(REPEATED)
        choice = isinstance(content, IfLess | IfAtMost | Choose) and extreme(content) is None
        if choice:
            return True
        if isinstance(quantity, Barrier):
            return not content.is_Atom and (repeated or longer(HELD))
        return (content.is_Add or isinstance(content, IfLess)) and repeated and longer(REPEATED)

    def _symbol(self, latex: str, first: bool = False, truth: bool = False) -> sp.Symbol:
        # Numbers stand before other factors: SymPy orders them by name.
        name = f"0{latex}" if first else latex
        symbol = Boolean(name) if truth else sp.Symbol(name, real=True)
        self.names[symbol] = latex
        return symbol

    def print(self, expression: sp.Basic) -> str:
        return self._printer.doprint(expression)

    def line(self, left: str, expression: sp.Basic, means: sp.Basic) -> Line:
        """Return an equation, with a long sum, conjunction or disjunction in rows."""
        whole = self.print(expression)
        if len(whole) <= ROW or not (expression.is_Add or isinstance(expression, And | Or)):
            return Line(left, (whole,), means)
        joined = type(expression)
        if expression.is_Add:
            sign, terms = "+", expression.as_ordered_terms()
        else:
            sign, terms = (r"\wedge" if joined is And else r"\vee"), _joined(expression, joined)
        rows: list[str] = []
        for term in terms:
            text = self.print(term)
            if isinstance(term, And | Or):
                text = rf"\left({text}\right)"
            signed = text if not rows or text.startswith("-") else f"{sign} {text}"
            if rows and len(rows[-1]) + len(signed) <= ROW:
                rows[-1] += f" {signed}"
            else:
                rows.append(signed)
        return Line(left, tuple(rows), means)


def _joined(condition: sp.Basic, kind: type[sp.Basic]) -> list[sp.Basic]:
    """Return the conditions that a conjunction or a disjunction joins, in order."""
    if not isinstance(condition, kind):
        return [condition]
    return [part for side in condition.args for part in _joined(side, kind)]


def explain(
    outputs: Outputs, given: Names | None = None, notation: SceneNotation | None = None
) -> Formulas:
    """Return the outputs as equations in named quantities.

    Parameters
    ----------
    outputs
        Expressions by name, the left sides.
    given
        LaTeX names of parts that the reader knows already.
    notation
        The LaTeX of symbols.
    """
    known = dict(given or {})
    explanation = _Explanation(known, notation or SceneNotation())
    lifted = {name: _lift(sp.sympify(e), known) for name, e in outputs.items()}
    explanation.count(lifted.values())
    written = {
        name: explanation.write(e, outermost=not isinstance(e, Barrier) or e.name in ("", name))
        for name, e in lifted.items()
    }
    line = explanation.line
    return Formulas(
        tuple(line(name, e, sp.sympify(outputs[name])) for name, e in written.items()),
        tuple(
            line(explanation.names[n.symbol], n.content, n.means)
            for n in _used(explanation.where, written.values())
        ),
        known,
    )


def _used(where: list[_Named], written: Iterable[sp.Basic]) -> list[_Named]:
    """Return the definitions that SymPy has not simplified away."""
    symbols = set().union(*(e.free_symbols for e in written))
    used = []
    for named in reversed(where):
        if named.symbol in symbols:
            symbols |= named.content.free_symbols
            used.append(named)
    return used[::-1]


def plainly(
    outputs: Outputs, given: Names | None = None, notation: SceneNotation | None = None
) -> Formulas:
    """Return the outputs as equations in which only the names that the reader knows are held.

    Parameters
    ----------
    outputs
        Expressions by the LaTeX of their left sides.
    given
        The LaTeX of expressions that the reader knows; they are not written out.
    notation
        The letters of the parameters; None for words.
    """
    known = dict(given or {})
    symbols = {e: sp.Symbol(f"known{k}", real=True) for k, e in enumerate(known)}
    printer = Printer(
        {symbols[e]: latex for e, latex in known.items()}, notation or SceneNotation()
    )
    lines = (
        Line(left, (str(printer.doprint(release(_but(e, left, known, symbols)))),), e)
        for left, e in outputs.items()
    )
    return Formulas(tuple(lines), (), known)


def _but(
    expression: sp.Basic, left: str, known: Names, symbols: Mapping[sp.Basic, sp.Symbol]
) -> sp.Basic:
    """Return the expression with known parts as symbols, but not as that of its own left side."""
    inner = expression.args[0] if isinstance(expression, Barrier) else expression
    own = {e for e in (expression, inner) if known.get(e) == left}
    given = {e: s for e, s in symbols.items() if e not in own}
    return given.get(expression, inner.xreplace(given))


def _lift(expression: sp.Basic, given: Names) -> sp.Basic:
    """Return one choice between formulas for a formula whose parts all choose by one condition."""
    if isinstance(expression, IfLess | IfAtMost | Barrier) or expression in given:
        return expression
    parts = [part.base if part.is_Pow else part for part in expression.args]
    choices = [p for p in parts if isinstance(p, IfLess | IfAtMost) and p not in given]
    if not choices or len({(c.func, *c.args[:2]) for c in choices}) > 1:
        return expression
    branches = [expression.xreplace({c: c.args[k] for c in choices}) for k in (2, 3)]
    return choices[0].func(*choices[0].args[:2], *branches)
