"""The surfaces on the derivation page: polynomial, closed form or search of each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp
from sympy.core.sorting import default_sort_key

from hoopgen.derive.events import root_finder_for
from hoopgen.derive.events.event_polynomials import event_coefficients
from hoopgen.derive.events.plane import AnyPlane, plane_arrival
from hoopgen.derive.events.ring.air import AirRingRootFinder
from hoopgen.derive.events.ring.double import RingRootFinder
from hoopgen.derive.events.root_finder import RootFinder
from hoopgen.derive.motion.flight import Flight
from hoopgen.derive.motion.parabola import Parabola
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.surfaces import Box, Ring, Surface
from hoopgen.derive.symbolic.conditionals import Barrier, barrier, release
from hoopgen.derive.symbolic.letters import AXES
from hoopgen.derive.symbolic.notation import latex_name
from hoopgen.derive.symbolic.polynomials import compose
from hoopgen.derive.symbolic.symbols import POSITION

from .explain import Formulas, Line, explain, plainly
from .latex import show
from .scene_notation import SceneNotation

rho, reach = sp.symbols("rho R", positive=True)
"""Abbreviations: the distance from the axis, and the sum of two radii."""

EXCESS = sp.symbols("excess_x excess_y excess_z", real=True)
"""Distance of each coordinate beyond a face of a box."""


@dataclass(frozen=True)
class SurfaceText:
    """A surface, and its constraint polynomial with named inner polynomials.

    Attributes
    ----------
    excess
        Of a box: how far each coordinate is beyond a face; distance and condition use it.
    """

    name: str
    is_ring: bool
    distance: Formulas
    condition: Formulas
    excess: Formulas
    normal: str
    bounds: tuple[Line, ...]
    degree: int
    polynomials: tuple[Line, ...]
    coefficients: Formulas
    arrival: Formulas


@dataclass(frozen=True)
class SearchText:
    """The search of a curved surface."""

    name: str
    others: str
    is_ring: bool
    radius: str
    named: Formulas
    gap: Formulas
    curvature: Formulas


class Abbreviations:
    """Expressions with R for the sum of two radii and rho for the distance from the axis."""

    def __init__(self, scene: Scene, notation: SceneNotation) -> None:
        x, y, _ = POSITION
        self.notation = notation
        self.names = {rho: r"\rho", reach: "R"}
        self.names |= {e: rf"\Delta_{axis}" for e, axis in zip(EXCESS, AXES, strict=True)}
        self.definitions = [Line(r"\rho", (show(sp.sqrt(x**2 + y**2)),), sp.sqrt(x**2 + y**2))]
        self.known: dict[sp.Basic, str] = {}
        self._square = x**2 + y**2
        self._other: dict[sp.Expr, sp.Expr] = {}
        for surface in scene.surfaces:
            radii = getattr(surface, "reach", None)
            if isinstance(surface, Ring) and radii is not None and len(radii.args) == 2:
                (other,) = radii.free_symbols - {scene.ball_radius}
                self._other = {other: reach - scene.ball_radius}
                self.definitions.append(Line("R", (show(radii, None, notation),), radii))
        self.known |= {line.means: line.left for line in self.definitions}

    def __call__(self, expression: sp.Expr) -> sp.Expr:
        """Return the expression in abbreviations."""
        together = expression.subs(self._other)
        # Where one of the two radii is alone, it stays.
        shorter = len(together.free_symbols) < len(expression.free_symbols)
        return (together if shorter else expression).subs(self._square, rho**2)

    def show(self, expression: sp.Expr | sp.Matrix) -> str:
        """Return the LaTeX of an expression in abbreviations, with nothing held."""
        return show(self(release(expression)), self.names, self.notation)

    def line(self, left: str, expression: sp.Expr) -> Line:
        """Return an equation in abbreviations.

        Parameters
        ----------
        left
            The LaTeX of the left side.
        expression
            The right side.
        """
        return Line(left, (self.show(expression),), expression)


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
    surface: Surface, flight: Flight, brief: Abbreviations
) -> tuple[tuple[Line, ...], tuple[Line, ...], tuple[Line, ...]]:
    """Return a condition's inner polynomials, their coefficients, and its own coefficients."""
    if not (surface.polynomial and flight.exact):
        return (), (), ()
    condition = release(surface.condition)
    paths: dict[sp.Symbol, list[sp.Expr]] = dict(flight.path)
    named, inner, polynomials = {}, [], []
    ordered = sorted(_inner_sums(condition), key=lambda e: -len(compose(e, paths)))
    for letter, part in zip("SPQUV", ordered, strict=False):
        coefficients = compose(part, paths)
        named[part] = sp.Symbol(letter, real=True)
        paths[named[part]] = [
            sp.Symbol(f"{letter}{k}", real=True) for k in range(len(coefficients))
        ]
        polynomials.append(brief.line(rf"\mathcal{{{letter}}}(t)", part))
        inner += [
            brief.line(rf"\mathcal{{{letter}}}_{{{k}}}", c) for k, c in enumerate(coefficients)
        ]
    rows = means = event_coefficients(surface, flight)
    if named:
        rows = compose(condition.xreplace(named), paths)
    parts = (symbol for letter in named.values() for symbol in paths[letter])
    names = {symbol: rf"\mathcal{{{symbol.name[0]}}}_{{{symbol.name[1:]}}}" for symbol in parts}
    lines = tuple(
        Line(
            f"c_{{{k}}}", (show(brief(release(c)), brief.names | names, brief.notation),), means[k]
        )
        for k, c in enumerate(rows)
    )
    return tuple(polynomials), tuple(inner), lines


def surface_text(surface: Surface, flight: Flight, brief: Abbreviations) -> SurfaceText:
    """Return the text of a surface.

    Parameters
    ----------
    surface
        A surface of a body, or an end plane.
    flight
        The motion of the ball between contacts.
    brief
        The abbreviations of the page so far; new ones join them.

    Returns
    -------
    SurfaceText
        The condition of contact, its polynomial in time and, of a plane, the arrival.
    """
    polynomials, inner, coefficients = _polynomial(surface, flight, brief)
    arrival = Formulas(())
    if isinstance(surface, AnyPlane) and isinstance(flight, Parabola):
        outputs = {latex_name(name): e for name, e in plane_arrival(surface, flight).items()}
        arrival = explain(outputs, {}, brief.notation)
    beyond = surface.excess if isinstance(surface, Box) else []
    symbols = dict(zip(beyond, EXCESS, strict=False))
    names = {e: brief.names[symbol] for e, symbol in symbols.items()}

    def formula(expression: sp.Expr) -> Formulas:
        shown = brief.show(expression.xreplace(symbols))
        return Formulas((Line("", (shown,), expression),), (), brief.known | names)

    return SurfaceText(
        surface.name,
        isinstance(surface, Ring),
        formula(surface.distance),
        formula(surface.condition),
        Formulas(tuple(brief.line(latex, e) for e, latex in names.items()), (), brief.known),
        brief.show(surface.normal.T.xreplace(symbols)),
        tuple(brief.line("", bound) for bound in surface.bounds),
        len(coefficients) - 1,
        polynomials,
        Formulas(coefficients, inner, brief.known),
        arrival,
    )


def known(search: RootFinder) -> dict[sp.Basic, str]:
    """Return the names that a search defines for quantities, held or not."""
    names: dict[sp.Basic, str] = {}
    for latex, e in search.named.items():
        bare = e.args[0] if isinstance(e, Barrier) else e
        names |= dict.fromkeys((e, barrier(bare), barrier(bare, latex)), latex)
    return names


def search_text(alike: Sequence[Surface], flight: Flight, notation: SceneNotation) -> SearchText:
    """Return the text of the search of a curved surface and of others of its kind.

    The series of a piece of a flight stand on the page once, not with each search.

    Parameters
    ----------
    alike
        Surfaces of one kind; the first one's formulas are shown.
    flight
        The motion of the ball between contacts.
    notation
        The letters of the scene's parameters.

    Returns
    -------
    SearchText
        The gap, its derivatives, their bounds and the steps of the search.
    """
    surface, *others = alike
    search: RootFinder = root_finder_for(surface, flight)
    names = known(search)
    slopes = {"F": search.gap, "F'": search.rate, "F''": search.bend, r"F_\ell": search.leaving_gap}
    slopes |= {latex_name(name): e for name, e in search.constants.items()}
    width = sp.Symbol("w", nonnegative=True)
    shown = set() if flight.exact else set(flight.quantities())
    own = {latex: e for latex, e in search.named.items() if latex not in shown}
    bound = {"M(w)": search.curvature(width), "C": search.ceiling}
    return SearchText(
        surface.name,
        ", ".join(other.name for other in others),
        isinstance(search, RingRootFinder),
        show(search.ring.ring_radius, None, notation)
        if isinstance(search, RingRootFinder | AirRingRootFinder)
        else "",
        explain(own, names, notation),
        (explain if isinstance(surface, Box) else plainly)(slopes, names, notation),
        explain(bound, names, notation),
    )
