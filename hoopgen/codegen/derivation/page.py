"""Everything that the template of the page shows."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from hoopgen.derive.contact.frame import frame_from_axis
from hoopgen.derive.errors import tangent
from hoopgen.derive.flight import circling, rolling
from hoopgen.derive.follow import gripping, settling
from hoopgen.derive.ground import rounding
from hoopgen.derive.ground.kernel import Kernel
from hoopgen.derive.ground.symbols import UNIT_ROUNDOFF, ParameterSymbol, normal
from hoopgen.derive.model import Model
from hoopgen.derive.scenes import validity
from hoopgen.derive.search import (
    approach,
    bernstein,
    coarse,
    curved,
    decisions,
    events,
    far,
    polar,
    ring,
    windows,
)
from hoopgen.derive.search.plane import plane_margin
from hoopgen.derive.surfaces import Plane

from .contacts import ContactText, contact_text
from .explain import Formulas, Line, explain, plainly
from .latex import number, show
from .letters import Letters
from .notation import (
    ARGUMENTS,
    AXES,
    FLIGHTS,
    LOOP,
    RESULTS,
    ROUNDOFF,
    SERIES,
    SERIES_TERM,
    STUDIES,
    latex_name,
    structured,
    text,
)
from .outline import outline
from .parts import Brief, SearchText, SurfaceText, known, search_text, surface_text
from .statements import DEFINITION, STATEMENTS, stated


def anchor(heading: str) -> str:
    """Return what a link to a heading ends with."""
    return re.sub(r"[^\w\- ]", "", heading).lower().replace(" ", "-")


@dataclass(frozen=True)
class SymbolText:
    """A row of a table of symbols."""

    latex: str
    name: str
    summary: str
    unit: str = ""
    value: str = ""


@dataclass(frozen=True)
class KernelText:
    """A kernel's results, what they are, and where they come from."""

    name: str
    formulas: Formulas
    summary: str
    equation: str


@dataclass(frozen=True)
class StatementText:
    """A statement, and the kernels that rest on it.

    Attributes
    ----------
    label
        Its kind and its number among the statements of the page.
    title
        What it is about.
    kernels
        Names; of a family of which the page has the first two formulas alone, those.
    omitted
        Names of the others of such families.
    """

    label: str
    title: str
    kernels: tuple[str, ...]
    omitted: tuple[str, ...]

    @property
    def heading(self) -> str:
        """Its heading."""
        return f"{self.label}: {self.title}"

    @property
    def anchor(self) -> str:
        """Return the fragment of a link to the heading."""
        return anchor(self.heading)


@dataclass(frozen=True)
class EndText:
    """An end of a shot, the plane that it is on, and its bounds there."""

    name: str
    plane: str
    bounds: tuple[Line, ...]
    passed: bool


@dataclass(frozen=True)
class Derivation:
    """Everything that the template shows; formulas are LaTeX."""

    name: str
    axes: str
    remarks: str
    radius: str
    roundoff: str
    constants: Mapping[str, str]
    parameters: tuple[SymbolText, ...]
    arguments: tuple[SymbolText, ...]
    brief: Formulas
    flight: Formulas
    surfaces: tuple[SurfaceText, ...]
    ends: tuple[EndText, ...]
    frame: str
    contact: ContactText
    crossing: Formulas
    searches: tuple[SearchText, ...]
    flight_rounding: Formulas
    plane_margins: Formulas
    displacement: Formulas
    outline: str
    kernels: Mapping[str, KernelText]
    statements: Mapping[str, StatementText]
    series: tuple[SymbolText, ...]

    @property
    def polynomial_surfaces(self) -> bool:
        """Whether a surface has a polynomial in time."""
        return any(surface.degree >= 0 for surface in self.surfaces)

    @property
    def resting(self) -> dict[str, str]:
        """The key of the statement that each kernel rests on."""
        return {
            name: key
            for key, statement in self.statements.items()
            for name in (*statement.kernels, *statement.omitted)
        }

    def shown(self, name: str) -> str:
        """Return a kernel's name, linked to its formulas if the page has them."""
        omitted = name in self.statements[self.resting[name]].omitted
        return f"`{name}`" if omitted else f"[`{name}`](#{name})"

    def refer(self, key: str) -> str:
        """Return how the text refers to a statement, linked; its title where the page lacks it."""
        found = self.statements.get(key)
        return f"[{found.label}](#{found.anchor})" if found else f"({STATEMENTS[key].title})"


def _kernel(
    kernel: Kernel, names: Mapping[sp.Basic, str], words: frozenset[str], letters: Letters
) -> KernelText:
    outputs = {
        RESULTS.get((kernel.name, name)) or latex_name(name, words): e for name, e in kernel.outputs
    }
    formulas = explain(outputs, names, letters)
    return KernelText(kernel.name, formulas, kernel.summary, kernel.equation)


def _arguments(model: Model) -> tuple[SymbolText, ...]:
    used = {
        argument.name
        for kernel in model.kernels
        for argument in kernel.arguments
        if not isinstance(argument, ParameterSymbol)
    }
    unknown = sorted(name for name in used - set(ARGUMENTS) if structured(name) is None)
    if unknown:
        raise ValueError(f"notation.py says nothing of {', '.join(unknown)}")
    return tuple(
        SymbolText(letter.latex, name, letter.meaning)
        for name, letter in ARGUMENTS.items()
        if name in used
    )


def _kernels(model: Model, letters: Letters) -> dict[str, KernelText]:
    """Return the results of all kernels, in the names that are known from the searches."""
    texts = {}
    for made in (*model.surfaces, *model.gates):
        names = {}
        if not isinstance(made.surface, Plane):
            names = known(approach(made.surface, model.scene.flight))
        for kernel in made.kernels.values():
            texts[kernel.name] = _kernel(kernel, names, frozenset(STUDIES), letters)
    study = {kernel.name for kernel in model.study}
    for kernel in model.kernels:
        words = frozenset(FLIGHTS | LOOP if kernel.name in study else STUDIES)
        if kernel.name not in texts:
            texts[kernel.name] = _kernel(kernel, {}, words, letters)
    return texts


FAMILY = re.compile(r"(?:roll|\w+_round)_(\d+)")
"""Kernels of the orders of a series: each as the one before, with longer sums."""


def _statements(model: Model) -> dict[str, StatementText]:
    """Return the statements of the page; lemmas and choices are numbered together."""
    texts, count = {}, 0
    for key, names in stated(model).items():
        statement = STATEMENTS[key]
        label = statement.kind
        if label != DEFINITION:
            count += 1
            label = f"{label} {count}"
        orders = {name: FAMILY.fullmatch(name) for name in names}
        omitted = tuple(name for name, order in orders.items() if order and int(order[1]) > 1)
        kept = tuple(name for name in names if name not in omitted)
        texts[key] = StatementText(label, statement.title, kept, omitted)
    return texts


def _series(model: Model) -> tuple[SymbolText, ...]:
    """Return the series of motions in contact that kernels have coefficients of."""
    names = (argument.name for kernel in model.kernels for argument in kernel.arguments)
    found = {match[1] for match in map(SERIES_TERM.fullmatch, names) if match}
    return tuple(
        SymbolText(letter.latex, name, letter.meaning)
        for name, letter in SERIES.items()
        if name in found
    )


def value_text(value: float) -> str:
    """Return a number as the shortest decimal that is as good; infinity as a formula."""
    return repr(value) if math.isfinite(value) else r"$\infty$"


def _constants() -> dict[str, str]:
    """Return the numbers that the text speaks of, in LaTeX."""
    found: dict[str, sp.Expr | int] = {
        "safety": rounding.SAFETY,
        "thicker": polar.WIDER,
        "wider": windows.WIDER,
        "ease": ring.RingApproach.ease,
        "single": coarse.CoarseRing.unit,
        "first_share": events.SHARES[0],
        "last_share": events.SHARES[-1],
        "finer": events.SHARES[1] / events.SHARES[0],
        "converged": decisions.CONVERGED,
        "found": decisions.CONVERGED**2 / 2,
        "steps": curved.STEP_LIMIT,
        "newton": curved.NEWTON_LIMIT,
        "turns": coarse.TURNS,
        "guard": tangent.GUARD,
        "claim": tangent.CLAIM,
        "lift": tangent.LIFT,
        "least": tangent.LEAST,
        "far": far.SHARE,
        "beyond": bernstein.BEYOND,
        "missed": rolling.MISSED,
        "missed_round": circling.MISSED,
        "order": rolling.ORDER,
        "order_round": circling.ORDER,
        "share": rolling.SHARE,
        "neighbour": settling.FAR,
        "watched": gripping.STEPS,
        "room": validity.ROOM,
    }
    values = {name: sp.Rational(value) for name, value in found.items()}
    return {name: number(value) or show(value) for name, value in values.items()}


def derivation_context(model: Model) -> Derivation:
    """Return what the template of derivation.md shows."""
    scene = model.scene
    flight, letters = scene.flight, Letters(scene)
    brief = Brief(scene, letters)
    place, motion = flight.at()
    there, moving = flight.rounding(events.horizon)
    surfaces = (*scene.surfaces, *scene.gates)
    planes = [s for s in surfaces if isinstance(s, Plane)]
    lengths = [p.symbol for p in scene.parameters if p.unit == "m"]
    flown = (f"{left}(t)" for left in (*AXES, *(f"v_{axis}" for axis in AXES)))
    kernels = _kernels(model, letters)

    statements = _statements(model)
    omitted = {name for text in statements.values() for name in text.omitted}

    def shown(name: str) -> str:
        return f"`{name}`" if name in omitted else f"[`{name}`](#{name})"

    return Derivation(
        name=scene.name,
        axes=scene.axes,
        remarks=scene.remarks,
        radius=letters(scene.ball_radius),
        roundoff=rf"{ROUNDOFF} = 2^{{{int(sp.log(UNIT_ROUNDOFF, 2))}}}",
        constants=_constants(),
        parameters=tuple(
            SymbolText(letters(p.symbol), p.name, p.summary, p.unit, value_text(p.default))
            for p in scene.parameters
        ),
        arguments=_arguments(model),
        brief=Formulas(tuple(brief.definitions)),
        flight=plainly(dict(zip(flown, (*place, *motion), strict=True)), {}, letters),
        surfaces=tuple(surface_text(s, flight, brief) for s in surfaces),
        ends=tuple(
            EndText(
                scene.ends[outcome].name,
                gate.name,
                tuple(brief.line("", side) for side in part),
                scene.ends[outcome].passed,
            )
            for gate in scene.gates
            for outcome, part in zip(gate.outcomes, gate.parts, strict=True)
        ),
        frame=show(frame_from_axis(normal, 0).applyfunc(sp.simplify)),
        contact=contact_text(scene, letters),
        crossing=explain({latex_name(n): e for n, e in events.crossing().items()}),
        searches=tuple(
            search_text(alike, flight, letters)
            for alike in model.kinds
            if not isinstance(alike[0], Plane)
        ),
        flight_rounding=explain(
            {
                r"\hat r": there.magnitude,
                r"\hat\varepsilon_r": there.error,
                r"\hat v": moving.magnitude,
                r"\hat\varepsilon_v": moving.error,
            },
            {},
            letters,
        ),
        plane_margins=explain(
            {f"m_{text(p.name)}": plane_margin(p, flight) for p in planes}, {}, letters
        ),
        displacement=explain({r"\epsilon": events.displacement(flight, lengths)}, {}, letters),
        outline=outline(model.loop, shown),
        kernels=kernels,
        statements=statements,
        series=_series(model),
    )
