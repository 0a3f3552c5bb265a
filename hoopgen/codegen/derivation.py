"""The derivation, as a reader would want it: what generated/derivation.md says.

Formulas are printed from the objects of derive/ that the kernels are lowered from. A quantity that
a formula holds (`choice.Held`) gets a name of its own where it is long or used more than once.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

import sympy as sp
from sympy.core.sorting import default_sort_key
from sympy.printing.latex import LatexPrinter

from hoopgen.derive import events, rounding
from hoopgen.derive.choice import Held, IfAtMost, IfLess, hold, hold_all, release
from hoopgen.derive.events import Approach, approach, event_coefficients
from hoopgen.derive.flight import flight, flight_polynomials
from hoopgen.derive.frame import frame_from_axis
from hoopgen.derive.impact import (
    AFTER,
    BEFORE,
    INERTIA_FACTOR,
    impact_equations,
    impact_inverse,
    impact_system,
)
from hoopgen.derive.kernel import Kernel
from hoopgen.derive.model import Model
from hoopgen.derive.polynomials import compose
from hoopgen.derive.scene import Scene
from hoopgen.derive.surfaces import Plane, Surface
from hoopgen.derive.symbols import POSITION, VELOCITY, normal, t

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
    "end": r"t_\mathrm{end}",
    "leaving": r"\ell",
    "margin": "m",
    "rate_margin": "m'",
    "delay": r"\delta",
    "rate": "F'",
    "ceiling": "C",
    "horizon": "T",
    "share": r"\sigma",
    "last": "i",
    "steady": "K",
    "swing": "W",
    "rho_start": r"\rho_0",
    "extent": r"\lVert\mathbf{r}\rVert_1",
    "speed": r"\lVert\mathbf{v}\rVert_1",
    "position_error": r"\varepsilon_r",
    "velocity_error": r"\varepsilon_v",
    "clock": "t_c",
    "clock_error": r"\varepsilon_t",
    "curving": r"\kappa",
    "shift": r"\varsigma",
    "turn": r"\tau",
}
"""How symbols are written; any other by its own name."""

AXES = "xyz"
SHORT = 90
"""A formula of no more LaTeX than this fits a row of the table of kernels."""
ROW = 130
"""A sum of more LaTeX than this is broken into rows."""
HELD = 40
"""A held quantity of no more LaTeX than this, used once, needs no name."""


# -- Symbols and numbers


def latex_name(name: str) -> str:
    """Return the LaTeX of a symbol's name, such as ``\\omega_x`` of ``wx``."""
    if name in LATEX_NAMES:
        return LATEX_NAMES[name]
    if name.endswith("_after"):
        return latex_name(name.removesuffix("_after")) + "^+"
    letter, index = name[:1], name[1:]
    if letter == "d" and index and (index in AXES or latex_name(index) != index):
        return rf"\delta {latex_name(index)}"
    if letter in "vwn" and index and set(index) <= set(AXES + "123"):
        return rf"{r'\omega' if letter == 'w' else letter}_{{{index}}}"
    stem = name.rstrip("0123456789")
    if len(stem) == 1 and stem != name:
        return f"{stem}_{{{name.removeprefix(stem)}}}"
    return name if len(name) == 1 else rf"\text{{{name.replace('_', ' ')}}}"


class _Printer(LatexPrinter):
    """LaTeX for GitHub: no bars, no ``<``, no macros that it forbids."""

    def __init__(self, names: Names) -> None:
        super().__init__({"mat_delim": "("})
        self._names = names

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
            when = r",\ ".join(self._print_condition(c) for c in conditions)
            lines.append(rf"{self._print(value)} & {when or r'\text{else}'}")
        body = r" \\ ".join(lines)
        text = rf"\begin{{cases}} {body} \end{{cases}}"
        return text if exp is None else rf"\left({text}\right)^{{{exp}}}"

    _print_IfLess = _print_choice
    _print_IfAtMost = _print_choice

    def _print_condition(self, choice: sp.Expr) -> str:
        sign = r"\lt" if isinstance(choice, IfLess) else r"\le"
        return f"{self._print(choice.args[0])} {sign} {self._print(choice.args[1])}"


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
        else:
            rows.append((expression, conditions))

    visit(choice, [])
    # Rows at the end that say the same as the last need no conditions.
    while len(rows) > 1 and rows[-2][0] == rows[-1][0]:
        del rows[-2]
    return rows


def _small_number(number: sp.Expr) -> str | None:
    """Return the LaTeX of a number written with a power of two, none if that is no help."""
    if not number.is_Rational or number.q < 2**10 or number.q & (number.q - 1):
        return None
    exponent = rf"2^{{-{int(number.q).bit_length() - 1}}}"
    if number == rounding.SAFETY:
        return r"(1 + 2^{-10})"
    if number.p - number.q == 1:
        return rf"(1 + {exponent})"
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

        def visit(expression: sp.Expr) -> None:
            self.uses[expression] += 1
            if expression not in seen:
                seen.add(expression)
                for argument in expression.args:
                    visit(argument)

        for expression in expressions:
            visit(expression)

    def write(self, expression: sp.Expr, outermost: bool = False) -> sp.Expr:
        """Return the expression in names."""
        if expression not in self._written:
            self._written[expression] = self._write(expression, outermost)
        return self._written[expression]

    def _write(self, expression: sp.Expr, outermost: bool) -> sp.Expr:
        if expression in self.given:
            return self._symbol(self.given[expression])
        number = _small_number(expression)
        if number is not None:
            return self._symbol(number, first=True)
        if not expression.args:
            return expression
        inner = [self.write(a) for a in sorted(expression.args, key=default_sort_key)]
        changed = dict(zip(sorted(expression.args, key=default_sort_key), inner, strict=True))
        rebuilt = expression.func(*(changed[a] for a in expression.args))
        choice = isinstance(rebuilt, IfLess | IfAtMost)
        plain = not isinstance(rebuilt, Held) and not (choice and _extreme(rebuilt) is None)
        if plain or outermost:
            return rebuilt.args[0] if isinstance(rebuilt, Held) else rebuilt
        return self._named(rebuilt, self.uses[expression] > 1)

    def _named(self, quantity: sp.Expr, repeated: bool) -> sp.Expr:
        content = quantity.args[0] if isinstance(quantity, Held) else quantity
        if content.is_Atom:
            return content
        for symbol, known in self.where:
            if known == content:
                return symbol
        short = len(self.print(content)) <= HELD
        if isinstance(quantity, Held) and short and not repeated:
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
    lifted = {name: _lift(sp.sympify(expression)) for name, expression in outputs.items()}
    explanation.count(lifted.values())
    written = {name: explanation.write(e, outermost=True) for name, e in lifted.items()}
    return Formulas(
        tuple(explanation.line(name, e) for name, e in written.items()),
        tuple(explanation.line(explanation.names[s], e) for s, e in explanation.where),
    )


def _lift(expression: sp.Expr) -> sp.Expr:
    """Return a formula whose parts all choose by one condition as one choice of formulas."""
    if isinstance(expression, IfLess | IfAtMost) or not expression.args:
        return expression
    choices = [e for e in expression.args if isinstance(e, IfLess | IfAtMost)]
    choices += [e.base for e in expression.args if e.is_Pow and e.base.func in (IfLess, IfAtMost)]
    if not choices or len({(c.func, *c.args[:2]) for c in choices}) > 1:
        return expression
    first = choices[0]
    branches = [expression.xreplace({c: c.args[k] for c in choices}) for k in (2, 3)]
    return first.func(*first.args[:2], *branches)


def show(expression: sp.Expr | sp.Matrix, names: Names | None = None) -> str:
    """Return the LaTeX of an expression with nothing held."""
    return str(_Printer(names or {}).doprint(release(expression)))


# -- What the template shows


@dataclass(frozen=True)
class ParameterText:
    """A row of the table of parameters."""

    latex: str
    name: str
    unit: str
    summary: str


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
    gap: Formulas
    constants: Formulas
    windows: Formulas
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
    parameters: tuple[ParameterText, ...]
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
        arrival = explain(
            {
                latex: brief(e)
                for latex, e in zip(
                    ("t", "F'(t)", "F''"),
                    events.plane_arrival(surface, gravity).values(),
                    strict=True,
                )
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
    return show(sp.collect(change, v3), _before())


def _before() -> dict[sp.Expr, str]:
    return {symbol: latex_name(symbol.name) + "^-" for symbol in BEFORE}


def _moving_names(gravity: sp.Expr) -> dict[sp.Expr, str]:
    """Return names for the parts of a flight that its searches hold."""
    x, y, _ = POSITION
    vx, vy, _ = VELOCITY
    there, moving = (hold_all(vector) for vector in flight(gravity))
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
        if place.args and motion.args:
            names[motion] = rf"\dot{{{axis}}}"
        names[place] = f"{axis}(t)"
    return names


def _search(surface: Surface, gravity: sp.Expr) -> SearchText:
    search: Approach = approach(surface, gravity)
    names = _moving_names(gravity)
    if reach := getattr(surface, "reach", None):
        names |= {hold(reach): "R", reach: "R"}
    slopes = {
        "F": search.gap,
        "F'": search.rate,
        "F''": search.bend,
        r"F_\ell": search.leaving_gap,
    }
    known = names | {hold(e): latex for latex, e in slopes.items()}
    known |= {e: latex for latex, e in slopes.items()}
    width = sp.Symbol("w", nonnegative=True)
    bounds = {}
    for k, (low, high) in enumerate(search.windows):
        bounds |= {rf"\underline{{t}}_{{{k}}}": low, rf"\overline{{t}}_{{{k}}}": high}
    advance = search.advance()
    bent = [e for e in advance["step"].atoms(Held) if e.has(*search.constants)]
    known |= _curvature_names(search, advance["step"])
    del bent
    margins = {"m": "margin", r"m_\ell": "leaving_margin", "m'": "rate_margin"}
    return SearchText(
        surface.name,
        explain(slopes, names),
        explain({latex_name(n): e for n, e in search.constants.items()}, names),
        explain(bounds, names),
        explain({"M": search.curvature(width), "C": search.ceiling}, names),
        explain({r"\text{step}": advance["step"], r"\text{clearance}": advance["clearance"]}, known),
        explain({left: search.margins[name] for left, name in margins.items()}, names),
    )


def _curvature_names(search: Approach, step: sp.Expr) -> dict[sp.Expr, str]:
    """Return names for the width and the curvature that a step is made from."""
    held = sorted(step.atoms(Held), key=default_sort_key)
    for width in held:
        bound = hold(search.curvature(width))
        if bound in held:
            return {bound: "M(w)"}
    return {}


def _kernel(kernel: Kernel) -> KernelText:
    names: dict[sp.Expr, str] = {}
    return KernelText(
        kernel.name,
        explain({latex_name(name): e for name, e in kernel.outputs}, names),
    )


def derivation_context(model: Model) -> Derivation:
    """Return what the template of derivation.md shows."""
    scene = model.scene
    gravity, ball_radius, restitution = scene.gravity, scene.ball_radius, scene.restitution
    brief = _Brief(scene)
    matrix, right = impact_system(ball_radius, restitution)
    inverse = impact_inverse(ball_radius)
    equations = impact_equations(ball_radius, restitution)
    place, motion = flight(gravity)
    there, moving = rounding.flight_rounding(gravity, events.horizon)
    surfaces = (*scene.surfaces, scene.finish)
    planes = [s for s in surfaces if isinstance(s, Plane)]
    lengths = [p.symbol for p in scene.parameters if p.unit == "m"]
    return Derivation(
        name=scene.name,
        parameters=tuple(
            ParameterText(latex_name(p.symbol.name), p.symbol.name, p.unit, p.summary)
            for p in scene.parameters
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
            _search(s, gravity) for s in scene.surfaces if not isinstance(s, Plane)
        ),
        flight_rounding=explain(
            {
                r"\hat r": there.magnitude,
                r"\hat\varepsilon_r": there.error,
                r"\hat v": moving.magnitude,
                r"\hat\varepsilon_v": moving.error,
            }
        ),
        plane_margins=explain(
            {rf"m_\text{{{p.name}}}": events.plane_margin(p, gravity) for p in planes}
        ),
        displacement=explain({"d": events.displacement(gravity, lengths)}),
        kernels={kernel.name: _kernel(kernel) for kernel in model.kernels},
    )
