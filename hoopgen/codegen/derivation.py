"""The derivation, as a reader would want it: what generated/derivation.md says.

Formulas are printed from the objects of derive/ that the kernels are lowered from. A quantity that
a formula holds (`choice.Held`) gets a name of its own where it is long or used more than once.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import sympy as sp
from sympy.core.sorting import default_sort_key
from sympy.printing.latex import LatexPrinter

from hoopgen.derive.contact.frame import frame_from_axis
from hoopgen.derive.contact.rolling import (
    AFTER,
    BEFORE,
    INERTIA_FACTOR,
    impact_equations,
    impact_inverse,
    impact_system,
)
from hoopgen.derive.flight.parabola import flight, flight_polynomials
from hoopgen.derive.ground import rounding
from hoopgen.derive.ground.choice import (
    Both,
    Choose,
    Condition,
    Either,
    Held,
    IfAtMost,
    IfLess,
    Truth,
    hold,
    hold_all,
    release,
)
from hoopgen.derive.ground.kernel import Kernel
from hoopgen.derive.ground.polynomials import compose
from hoopgen.derive.ground.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY, normal
from hoopgen.derive.model import Model
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.search import approach, events
from hoopgen.derive.search.approach import Approach
from hoopgen.derive.search.events import event_coefficients
from hoopgen.derive.search.plane import plane_arrival, plane_margin
from hoopgen.derive.search.ring import WIDER
from hoopgen.derive.surfaces import Plane, Ring, Surface

Names = Mapping[sp.Expr, str]
Outputs = Mapping[str, sp.Expr]

LATEX_NAMES = {
    "ball_radius": "R_B",
    "ring_radius": "R_H",
    "wire_radius": "R_W",
    "board_distance": "a_0",
    "board_half_width": "y_B",
    "board_bottom": "z_{B1}",
    "board_top": "z_{B2}",
    "bridge_half_width": "y_{BR}",
    "restitution": "e",
    "gravity": "g",
    "end_depth": "H",
    "w": r"\omega",
}
"""How parameters and state are written; a symbol that is not here or below has its own name."""

ARGUMENTS = {
    "t": ("t", "time since the last contact"),
    "end": (r"t_\mathrm{end}", "end of the window that is searched"),
    "horizon": ("T", "no event later than this is wanted"),
    "leaving": (r"\ell", "1 if the flight starts on this very surface, else 0"),
    "last": ("i", "index of the surface that was touched last, -1 for none"),
    "extent": (r"\lVert\mathbf{r}\rVert_1", "sum of the sizes of the coordinates at the start"),
    "speed": (r"\lVert\mathbf{v}\rVert_1", "sum of the sizes of the velocities at the start"),
    "steady": ("K", "first constant of $F''$, see the ring's search"),
    "swing": ("W", "second constant of $F''$"),
    "rho_start": (r"\rho_0", "distance from the axis at the start"),
    "rate": ("F'", "rate of the gap $F$"),
    "margin": ("m", "bound on the error of a gap"),
    "rate_margin": ("m'", "bound on the error of its rate"),
    "ceiling": ("C", "bound on the size of $F''$"),
    "delay": (r"\delta", "bound on how far a computed arrival is from the true one"),
    "share": (r"\sigma", "error, relative to the size of the flight, that a search allows for"),
    "position_error": (r"\varepsilon_r", "bound on the error of each coordinate at the start"),
    "velocity_error": (r"\varepsilon_v", "bound on the error of each velocity at the start"),
    "late": (r"\hat\delta", "bound on the delay of the arrival"),
    "contacts": ("k", "how many contacts there were, this one too"),
    "clock": ("t_c", "time since the release"),
    "clock_error": (r"\varepsilon_t", "what the contacts' times are off by, summed"),
    "curving": (r"\kappa", "curvature of the surface, if it is met twice running"),
    "shift": (r"\varsigma", "error of the position at a contact, at worst after one flight"),
    "turn": (r"\tau", "error of the normal, at worst after one flight"),
    "slope": ("s", "tangent of the angle of release above the horizontal"),
    "entry": (r"s^\downarrow", "tangent of the angle below the horizontal at the wanted point"),
    "release_speed": ("v", "speed at release"),
    "reach": ("D", "horizontal distance from the release to the wanted point"),
    "rise": ("h", "height of the wanted point above the release"),
    "level": (r"\bar z", "height above the ring's plane"),
    "half": (r"\eta", "half the width of an interval of time"),
    "place_x": ("x_p", "place on the floor plan, x"),
    "place_y": ("y_p", "place on the floor plan, y"),
}
"""How the other arguments of kernels are written, and what they are."""

AXES = "xyz"
SHORT = 90
"""A formula of no more LaTeX than this fits a row of the table of kernels."""
ROW = 130
"""A sum of more LaTeX than this is broken into rows."""
HELD = 40
"""A held quantity of no more LaTeX than this, used once, needs no name."""
REPEATED = 25
"""A sum of more LaTeX than this, used more than once, gets a name."""


FACTORS = {WIDER: r"(1 + 2^{-20})", rounding.SAFETY: r"(1 + 2^{-10})"}
"""Factors that are written as such."""


# -- Symbols and numbers


def latex_name(name: str) -> str:
    r"""Return the LaTeX of a symbol's name, such as ``\omega_x`` of ``wx``."""
    if name in LATEX_NAMES:
        return LATEX_NAMES[name]
    if name in ARGUMENTS:
        return ARGUMENTS[name][0]
    if name.endswith("_after"):
        return latex_name(name.removesuffix("_after")) + "^+"
    letter, index = name[:1], name[1:]
    if letter == "d" and index and (index in AXES or latex_name(index) != index):
        return rf"\delta_{{{latex_name(index)}}}"
    if letter in "vwn" and index and set(index) <= set(AXES + "123"):
        return f"{LATEX_NAMES.get(letter, letter)}_{{{index}}}"
    stem = name.rstrip("0123456789")
    if len(stem) == 1 and stem != name:
        return f"{stem}_{{{name.removeprefix(stem)}}}"
    return name if len(name) == 1 else rf"\text{{{name.replace('_', ' ')}}}"


class _Printer(LatexPrinter):  # type: ignore[misc]
    """LaTeX for GitHub: no bars, which would end a cell of a table, and no macros it forbids."""

    def __init__(self, names: Names) -> None:
        super().__init__({"mat_delim": "("})
        self._names = names

    def _as_ordered_terms(self, expr: sp.Add, order: str | None = None) -> list[sp.Expr]:
        """Return what is added before what is taken away, short products and coordinates first."""
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
        return self._names.get(symbol) or latex_name(symbol.name)

    def _power(self, text: str, exponent: str | None) -> str:
        return text if exponent is None else f"{text}^{{{exponent}}}"

    def _print_Held(self, held: Held, exp: str | None = None) -> str:
        return self._power(rf"\left({self._print(held.args[0])}\right)", exp)

    def _print_Abs(self, size: sp.Abs, exp: str | None = None) -> str:
        return self._power(rf"\left\lvert {self._print(size.args[0])}\right\rvert", exp)

    def _print_choice(self, choice: sp.Expr, exp: str | None = None) -> str:
        extreme = _extreme(choice)
        if extreme is not None:
            name, values = extreme
            inner = ", ".join(self._print(value) for value in values)
            text = rf"{name}\left({inner}\right)"
            return text if exp is None else rf"\left({text}\right)^{{{exp}}}"
        lines = []
        for value, conditions in _cases(choice):
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
        if isinstance(choice, Condition | Truth):
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

    def _print_Both(self, condition: sp.Expr) -> str:
        return self._joined(condition, r"\wedge")

    def _print_Either(self, condition: sp.Expr) -> str:
        return self._joined(condition, r"\vee")

    def _joined(self, condition: sp.Expr, sign: str) -> str:
        """Return two conditions, joined; what is joined otherwise stands in brackets."""
        other = {Both: Either, Either: Both}[type(condition)]
        parts = [
            rf"\left({self._print(c)}\right)" if isinstance(c, other) else self._print(c)
            for c in condition.args
        ]
        return f" {sign} ".join(parts)

    def _print_Not(self, condition: sp.Expr) -> str:
        (inner,) = condition.args
        text: str = self._print(inner)
        return rf"\neg {text}" if isinstance(inner, Truth) else rf"\neg \left({text}\right)"

    def _print_Nowhere(self, _: sp.Expr) -> str:
        return r"\text{never}"


def _degree(term: sp.Expr) -> int:
    """Return how many factors a product has, powers counted as they are."""
    powers = (factor.as_base_exp()[1] for factor in sp.Mul.make_args(term) if not factor.is_number)
    return sum(int(p) if p.is_Integer and p > 0 else 1 for p in powers)


def _extreme(choice: sp.Expr) -> tuple[str, list[sp.Expr]] | None:
    """Return the name and the operands of a choice that is the larger or smaller of two values."""
    if not isinstance(choice, IfLess):
        return None
    left, right, then, other = choice.args
    if (then, other) == (right, left):
        name, first = r"\max", left
    elif (then, other) == (left, right):
        name, first = r"\min", right
    else:
        return None
    inner = _extreme(first)
    firsts = inner[1] if inner is not None and inner[0] == name else [first]
    return name, [*firsts, then if first is other else other]


def _cases(choice: sp.Expr) -> list[tuple[sp.Expr, list[sp.Expr]]]:
    """Return values with the conditions under which they hold, the first that do hold in order."""
    rows: list[tuple[sp.Expr, list[sp.Expr]]] = []

    def visit(expression: sp.Expr, conditions: list[sp.Expr]) -> None:
        if isinstance(expression, IfLess | IfAtMost) and _extreme(expression) is None:
            visit(expression.args[2], [*conditions, expression])
            visit(expression.args[3], conditions)
        elif isinstance(expression, Choose):
            visit(expression.args[1], [*conditions, expression.args[0]])
            visit(expression.args[2], conditions)
        else:
            rows.append((expression, conditions))

    visit(choice, [])
    # Rows at the end that say the same as the last need no conditions.
    while len(rows) > 1 and rows[-2][0] == rows[-1][0]:
        del rows[-2]
    return rows


def _number(number: sp.Rational) -> str | None:
    """Return the LaTeX of a positive number by powers of two, none if it is better as it is."""
    for factor, latex in FACTORS.items():
        rest = number / factor
        if number.p % factor.p == 0 and factor.p > 1:
            return latex if rest == 1 else f"{_number(rest) or show(rest)} {latex}"
    if number.q < 2**10 or number.q & (number.q - 1):
        return None
    units = number / UNIT_ROUNDOFF
    if units.q == 1 and units < 2**10:
        return "u" if units == 1 else f"{units} u"
    exponent = rf"2^{{-{int(number.q).bit_length() - 1}}}"
    return exponent if number.p == 1 else rf"{number.p} \cdot {exponent}"


# -- Formulas with their parts named


@dataclass(frozen=True)
class Line:
    """An equation: its left side, and the right side in rows."""

    left: str
    rows: tuple[str, ...]

    @property
    def right(self) -> str:
        """The right side in one row."""
        return " ".join(self.rows)


@dataclass(frozen=True)
class Formulas:
    """Equations, and the definitions of the names in them, each after what it uses."""

    lines: tuple[Line, ...]
    where: tuple[Line, ...] = ()


@dataclass
class _Explanation:
    """Expressions being rewritten with names for what they hold."""

    given: Names
    names: dict[sp.Expr, str] = field(default_factory=dict)
    where: list[tuple[sp.Symbol, sp.Expr]] = field(default_factory=list)
    uses: Counter[sp.Expr] = field(default_factory=Counter)
    _written: dict[sp.Expr, sp.Expr] = field(default_factory=dict)

    def count(self, expressions: Iterable[sp.Expr]) -> None:
        """Count how often each part is used by another."""
        seen: set[sp.Expr] = set()

        def visit(expression: sp.Expr, outermost: bool = False) -> None:
            self.uses[expression] += 1
            if expression not in seen and (outermost or expression not in self.given):
                seen.add(expression)
                # The larger or smaller of two values has each of them as a side and as a result.
                twice = _extreme(expression) is not None
                for argument in expression.args[:2] if twice else expression.args:
                    visit(argument)

        for expression in expressions:
            visit(expression, outermost=True)

    def write(self, expression: sp.Expr, outermost: bool = False) -> sp.Expr:
        """Return the expression in names, the outermost one without its own."""
        if outermost:
            bare = expression.args[0] if isinstance(expression, Held) else expression
            return self._write(bare, outermost)
        if expression not in self._written:
            self._written[expression] = self._write(expression, outermost)
        return self._written[expression]

    def _write(self, expression: sp.Expr, outermost: bool) -> sp.Expr:
        if expression in self.given and not outermost:
            return self._symbol(self.given[expression])
        if expression.is_Rational:
            sign = sp.sign(expression)
            number = _number(abs(expression)) if sign else None
            return expression if number is None else sign * self._symbol(number, first=True)
        if not expression.args:
            return expression
        written = {a: self.write(a) for a in sorted(expression.args, key=default_sort_key)}
        inner = [written[a] for a in expression.args]
        # A sum among summands, or times a number alone, would be spread if it were not held.
        spread = expression.is_Add or (len(inner) == 2 and inner[0].is_Rational)
        inner = [
            e.args[0] if isinstance(e, Held) and not (spread and e.args[0].is_Add) else e
            for e in inner
        ]
        rebuilt = expression.func(*inner)
        if outermost:
            return rebuilt
        return self._named(rebuilt, self.uses[expression] > 1)

    def _named(self, quantity: sp.Expr, repeated: bool) -> sp.Expr:
        """Return a name for what is held, chosen or repeated, if it is worth one."""
        content = quantity.args[0] if isinstance(quantity, Held) else quantity
        for symbol, known in self.where:
            if known == content:
                return symbol
        cases = isinstance(content, IfLess | IfAtMost | Choose) and _extreme(content) is None
        length = len(self.print(content))
        if isinstance(quantity, Held):
            worth = cases or (not content.is_Atom and (repeated or length > HELD))
        else:
            composed = content.is_Add or isinstance(content, IfLess)
            worth = cases or (composed and repeated and length > REPEATED)
        if not worth:
            return quantity
        symbol = self._symbol(f"h_{{{len(self.where) + 1}}}")
        self.where.append((symbol, content))
        return symbol

    def _symbol(self, latex: str, first: bool = False) -> sp.Symbol:
        # Numbers stand before other factors: SymPy orders them by name.
        symbol = sp.Symbol(f"0{latex}" if first else latex, real=True)
        self.names[symbol] = latex
        return symbol

    def print(self, expression: sp.Expr) -> str:
        return str(_Printer(self.names).doprint(expression))

    def line(self, left: str, expression: sp.Expr) -> Line:
        """Return an equation, a long sum in rows."""
        whole = self.print(expression)
        if len(whole) <= ROW or not expression.is_Add:
            return Line(left, (whole,))
        rows: list[str] = []
        for term in expression.as_ordered_terms():
            text = self.print(term)
            signed = text if not rows or text.startswith("-") else f"+ {text}"
            if rows and len(rows[-1]) + len(signed) <= ROW:
                rows[-1] += f" {signed}"
            else:
                rows.append(signed)
        return Line(left, tuple(rows))


def explain(outputs: Outputs, given: Names | None = None) -> Formulas:
    """Return the outputs as equations in named quantities.

    Parameters
    ----------
    outputs
        Expressions by name, the left sides.
    given
        LaTeX names of parts that the reader knows already.
    """
    explanation = _Explanation(given or {})
    lifted = {name: _lift(sp.sympify(e), explanation.given) for name, e in outputs.items()}
    explanation.count(lifted.values())
    written = {name: explanation.write(e, outermost=True) for name, e in lifted.items()}
    return Formulas(
        tuple(explanation.line(name, e) for name, e in written.items()),
        tuple(explanation.line(explanation.names[s], e) for s, e in explanation.where),
    )


def _lift(expression: sp.Expr, given: Names) -> sp.Expr:
    """Return a formula whose parts all choose by one condition as one choice of formulas."""
    if isinstance(expression, IfLess | IfAtMost) or expression in given:
        return expression
    parts = [part.base if part.is_Pow else part for part in expression.args]
    choices = [p for p in parts if isinstance(p, IfLess | IfAtMost) and p not in given]
    if not choices or len({(c.func, *c.args[:2]) for c in choices}) > 1:
        return expression
    branches = [expression.xreplace({c: c.args[k] for c in choices}) for k in (2, 3)]
    return choices[0].func(*choices[0].args[:2], *branches)


def show(expression: sp.Expr | sp.Matrix, names: Names | None = None) -> str:
    """Return the LaTeX of an expression with nothing held."""
    return str(_Printer(names or {}).doprint(release(expression)))


# -- What the template shows


@dataclass(frozen=True)
class SymbolText:
    """A row of a table of symbols."""

    latex: str
    name: str
    summary: str
    unit: str = ""


@dataclass(frozen=True)
class SurfaceText:
    """A surface, and its event polynomial with its inner polynomials named."""

    name: str
    is_plane: bool
    distance: str
    condition: str
    normal: str
    bounds: tuple[str, ...]
    degree: int
    inner: tuple[Line, ...]
    coefficients: tuple[Line, ...]
    arrival: Formulas


@dataclass(frozen=True)
class SearchText:
    """The search of a curved surface."""

    name: str
    is_ring: bool
    gap: Formulas
    windows: Formulas
    intervals: Formulas
    curvature: Formulas
    advance: Formulas
    margins: Formulas


@dataclass(frozen=True)
class KernelText:
    """A kernel's results."""

    name: str
    formulas: Formulas

    @property
    def short(self) -> str | None:
        """The results in one line, none if they are too long for it."""
        parts = [f"{line.left} = {line.right}" for line in self.formulas.lines]
        whole = r",\quad ".join(parts)
        fits = len(whole) <= SHORT and not self.formulas.where and "cases" not in whole
        return whole if fits else None


@dataclass(frozen=True)
class Derivation:
    """Everything that the template shows; formulas are LaTeX."""

    name: str
    parameters: tuple[SymbolText, ...]
    arguments: tuple[SymbolText, ...]
    reach: str
    flight: Formulas
    surfaces: tuple[SurfaceText, ...]
    target: str
    frame: str
    equations: tuple[str, ...]
    matrix: str
    unknowns: str
    right: str
    inverse: str
    solution: str
    lost: str
    crossing: Formulas
    searches: tuple[SearchText, ...]
    flight_rounding: Formulas
    plane_margins: Formulas
    displacement: Formulas
    kernels: Mapping[str, KernelText]


class _Brief:
    """Expressions with R for the two radii together and rho for the distance from the axis."""

    def __init__(self, scene: Scene) -> None:
        x, y, _ = POSITION
        self._rho = sp.Symbol("rho", positive=True)
        self._reach = sp.Symbol("R", positive=True)
        self.names = {self._rho: r"\rho", self._reach: "R"}
        self._square = x**2 + y**2
        self._other: dict[sp.Expr, sp.Expr] = {}
        self.reach = ""
        for surface in scene.surfaces:
            reach = getattr(surface, "reach", None)
            if not isinstance(surface, Plane) and reach is not None and len(reach.args) == 2:
                (other,) = reach.free_symbols - {scene.ball_radius}
                self._other = {other: self._reach - scene.ball_radius}
                self.reach = show(reach)

    def __call__(self, expression: sp.Expr) -> sp.Expr:
        """Return the expression in brief."""
        brief = expression.subs(self._other)
        return brief.subs(self._square, self._rho**2)

    def show(self, expression: sp.Expr | sp.Matrix) -> str:
        """Return the LaTeX of an expression in brief, with nothing held."""
        return show(self(release(expression)), self.names)


def _inner_sums(condition: sp.Expr) -> list[sp.Expr]:
    """Return the outermost sums within a condition that depend on the position."""
    found: list[sp.Expr] = []

    def visit(expression: sp.Expr) -> None:
        for argument in sorted(expression.args, key=default_sort_key):
            if argument.is_Add and argument.free_symbols & set(POSITION):
                found.extend([argument] if argument not in found else [])
            else:
                visit(argument)

    visit(condition)
    return found


def _polynomial(
    surface: Surface, gravity: sp.Expr, brief: _Brief
) -> tuple[tuple[Line, ...], tuple[Line, ...]]:
    """Return the inner polynomials of a condition, and its coefficients in theirs."""
    condition = release(surface.condition)
    paths: dict[sp.Symbol, list[sp.Expr]] = dict(flight_polynomials(gravity))
    named, inner = {}, []
    ordered = sorted(_inner_sums(condition), key=lambda e: -len(compose(e, paths)))
    for letter, part in zip("SPQUV", ordered, strict=False):
        coefficients = compose(part, paths)
        named[part] = sp.Symbol(letter, real=True)
        paths[named[part]] = [
            sp.Symbol(f"{letter}{k}", real=True) for k in range(len(coefficients))
        ]
        inner.append(Line(f"{letter}(t)", (brief.show(part),)))
        inner += [Line(f"{letter}_{k}", (brief.show(c),)) for k, c in enumerate(coefficients)]
    rows = event_coefficients(surface, gravity)
    if named:
        rows = compose(condition.xreplace(named), paths)
    lines = tuple(Line(f"c_{{{k}}}", (brief.show(c),)) for k, c in enumerate(rows))
    return tuple(inner), lines


def _surface(surface: Surface, gravity: sp.Expr, brief: _Brief) -> SurfaceText:
    inner, coefficients = _polynomial(surface, gravity, brief)
    arrival = Formulas(())
    if isinstance(surface, Plane):
        constant = hold(event_coefficients(surface, gravity)[0])
        start = IfLess(0, events.leaving, 0, constant)
        written = {"time": "t", "rate": "F'(t)", "bend": "F''"}
        arrival = explain(
            {
                written.get(name, rf"\text{{{name}}}"): brief(e)
                for name, e in plane_arrival(surface, gravity).items()
            },
            {brief(start): "c"} | brief.names,
        )
    return SurfaceText(
        surface.name,
        isinstance(surface, Plane),
        brief.show(surface.distance),
        brief.show(surface.condition),
        brief.show(surface.normal.T),
        tuple(rf"{brief.show(bound)} \le 0" for bound in surface.bounds),
        len(coefficients) - 1,
        inner,
        coefficients,
        arrival,
    )


def _lost_energy(ball_radius: sp.Expr, restitution: sp.Expr) -> str:
    """Return the kinetic energy per unit mass that a contact changes, by the slip before it."""
    _, right = impact_system(ball_radius, restitution)
    after = impact_inverse(ball_radius) * right
    before = sp.Matrix(BEFORE)
    slip = sp.symbols("s1 s2", real=True)
    v1, v2, v3, w1, w2, _ = BEFORE

    def energy(motion: sp.Matrix) -> sp.Expr:
        v, w = motion[:3, :], motion[3:, :]
        return (v.dot(v) + INERTIA_FACTOR * ball_radius**2 * w.dot(w)) / 2

    # The contact point slips by v + w × (-R_B n3).
    slipping = {w2: (v1 - slip[0]) / ball_radius, w1: (slip[1] - v2) / ball_radius}
    change = sp.expand(sp.expand(energy(after) - energy(before)).subs(slipping))
    across = sp.factor(change.subs(v3, 0))
    return show(across + v3**2 * sp.factor(change.coeff(v3, 2)), _before())


def _before() -> dict[sp.Expr, str]:
    return {symbol: latex_name(symbol.name) + "^-" for symbol in BEFORE}


def _known_names(scene: Scene) -> dict[sp.Expr, str]:
    """Return names for what a flight's searches hold, as the text defines them."""
    x, y, _ = POSITION
    vx, vy, _ = VELOCITY
    there, moving = (hold_all(vector) for vector in flight(scene.gravity))
    square = hold(there[0] ** 2 + there[1] ** 2)
    names = {
        sp.sqrt(square): r"\rho",
        square: r"\rho^2",
        hold(x**2 + y**2): r"\rho_0^2",
        hold(x * vx + y * vy): "q",
        hold(vx**2 + vy**2): "V^2",
        hold(x * vy - y * vx): "L",
    }
    for axis, place, motion in zip(AXES, there, moving, strict=True):
        names[place] = f"{axis}_t"
        if motion.args:
            names[motion] = rf"\dot {axis}_t"
    for surface in scene.surfaces:
        if isinstance(surface, Ring):
            reach = hold(surface.reach)
            wider = reach * WIDER
            names |= {reach: "R", surface.reach: "R", wider: r"\hat R"}
            names[hold(surface.ring_radius - wider)] = r"\rho_-"
            names[hold(surface.ring_radius + wider)] = r"\rho_+"
    return names


def _mathematical(expression: sp.Expr) -> sp.Expr:
    """Return the expression without what only widens it by roundings, its quotients as such."""
    tiny = {n: 0 for n in expression.atoms(sp.Rational) if 0 < abs(n) < sp.Rational(1, 2**30)}
    inverses = {h: h.args[0] for h in expression.atoms(Held) if h.args[0].is_Pow}
    return expression.xreplace(tiny).xreplace(inverses)


def _plainly(outputs: Outputs, names: Names) -> Formulas:
    """Return the outputs as equations with nothing held but what has a name."""
    symbols = {e: sp.Symbol(f"known{k}", real=True) for k, e in enumerate(names)}
    latex = {symbols[e]: name for e, name in names.items()}
    lines = ((left, release(e.xreplace(symbols))) for left, e in outputs.items())
    return Formulas(tuple(Line(left, (show(e, latex),)) for left, e in lines))


def _intervals(windows: list[events.Window]) -> dict[sp.Expr, str]:
    """Return names for the ends of the intervals whose intersections the windows are."""
    names: dict[sp.Expr, str] = {}
    for index, window in ((1, windows[0]), (2, windows[-1])):
        for mark, end in zip((r"\underline", r"\overline"), window, strict=True):
            _, parts = _extreme(end) or ("", [])
            named = (f"{mark} {letter}_{index}" for letter in "ZA")
            names |= dict(zip(parts, named, strict=False))
    return names


def _search(surface: Surface, gravity: sp.Expr, names: dict[sp.Expr, str]) -> SearchText:
    search: Approach = approach(surface, gravity)
    gap, leaving_gap, rate, bend = search.gap, search.leaving_gap, search.rate, search.bend
    slopes = {"F": gap, "F'": rate, "F''": bend, r"F_\ell": leaving_gap}
    slopes |= {latex_name(name): e for name, e in search.constants.items()}
    either = IfLess(0, events.leaving, hold(leaving_gap), hold(gap))
    known = names | {either: "F", hold(rate): "F'", hold(-bend): "(-F'')"}
    width = sp.Symbol("w", nonnegative=True)
    drawn = [(_mathematical(low), _mathematical(high)) for low, high in search.windows]
    windows: dict[str, sp.Expr] = {}
    for k, (low, high) in enumerate(drawn):
        windows |= {rf"\underline t_{k}": low, rf"\overline t_{k}": high}
    intervals = _intervals(drawn)
    advance = search.advance()
    step = advance["step"]
    # The smaller of the width that M holds for, and of the root.
    within = step.args[1]
    known |= {within: "w", hold(search.curvature(within)): "M(w)"}
    margins = search.margins
    return SearchText(
        surface.name,
        isinstance(surface, Ring),
        _plainly(slopes, names),
        explain(windows, names | intervals),
        explain({latex: e for e, latex in intervals.items()}, names | intervals),
        explain({"M(w)": search.curvature(width), "C": search.ceiling}, names | {width: "w"}),
        explain(
            {
                "w": within.args[0] if isinstance(within, Held) else within,
                "s": step,
                r"\text{clearance}": advance["clearance"],
            },
            known,
        ),
        explain(
            {
                "m": margins["margin"],
                r"m_\ell": margins["leaving_margin"],
                "m'": margins["rate_margin"],
            },
            names,
        ),
    )


def _kernel(kernel: Kernel, names: Names) -> KernelText:
    outputs = {latex_name(name): e for name, e in kernel.outputs}
    return KernelText(kernel.name, explain(outputs, names))


def derivation_context(model: Model) -> Derivation:
    """Return what the template of derivation.md shows."""
    scene = model.scene
    gravity, ball_radius = scene.gravity, scene.ball_radius
    restitution = scene.laws[0].restitution
    brief, names = _Brief(scene), _known_names(scene)
    matrix, right = impact_system(ball_radius, restitution)
    inverse = impact_inverse(ball_radius)
    equations = impact_equations(ball_radius, restitution)
    place, motion = flight(gravity)
    there, moving = rounding.flight_rounding(gravity, events.horizon)
    surfaces = (*scene.surfaces, scene.finish)
    planes = [s for s in surfaces if isinstance(s, Plane)]
    lengths = [p.symbol for p in scene.parameters if p.unit == "m"]
    used = {argument.name for kernel in model.kernels for argument in kernel.arguments}
    return Derivation(
        name=scene.name,
        parameters=tuple(
            SymbolText(latex_name(p.name), p.name, p.summary, p.unit) for p in scene.parameters
        ),
        arguments=tuple(
            SymbolText(latex, name, summary)
            for name, (latex, summary) in ARGUMENTS.items()
            if name in used
        ),
        reach=brief.reach,
        flight=Formulas(
            tuple(
                Line(f"{left}(t)", (show(e),))
                for left, e in zip(
                    (*AXES, *(f"v_{axis}" for axis in AXES)), (*place, *motion), strict=True
                )
            )
        ),
        surfaces=tuple(_surface(s, gravity, brief) for s in surfaces),
        target=rf"{brief.show(scene.target)} \le 0",
        frame=show(frame_from_axis(normal, 0).applyfunc(sp.simplify)),
        equations=tuple(f"{show(e, _before())} = 0" for e in equations),
        matrix=show(matrix),
        unknowns=show(sp.Matrix(AFTER)),
        right=show(right, _before()),
        inverse=show(inverse),
        solution=show((inverse * right).applyfunc(sp.expand), _before()),
        lost=_lost_energy(ball_radius, restitution),
        crossing=explain({rf"\text{{{n}}}": e for n, e in events.crossing().items()}),
        searches=tuple(
            _search(s, gravity, names) for s in scene.surfaces if not isinstance(s, Plane)
        ),
        flight_rounding=explain(
            {
                r"\hat r": there.magnitude,
                r"\hat\varepsilon_r": there.error,
                r"\hat v": moving.magnitude,
                r"\hat\varepsilon_v": moving.error,
            }
        ),
        plane_margins=explain({rf"m_\text{{{p.name}}}": plane_margin(p, gravity) for p in planes}),
        displacement=explain({"d": events.displacement(gravity, lengths)}),
        kernels={kernel.name: _kernel(kernel, names) for kernel in model.kernels},
    )
