"""Everything that the template of the page shows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from hoopgen.derive.contact.frame import frame_from_axis
from hoopgen.derive.contact.rolling import (
    AFTER,
    BEFORE,
    INERTIA_FACTOR,
    Rolling,
    impact_equations,
    impact_inverse,
    impact_system,
)
from hoopgen.derive.ground import rounding
from hoopgen.derive.ground.kernel import Kernel
from hoopgen.derive.ground.symbols import UNIT_ROUNDOFF, ParameterSymbol, normal
from hoopgen.derive.model import RESTITUTION, Model
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.search import approach, events
from hoopgen.derive.search.plane import plane_margin
from hoopgen.derive.surfaces import Plane

from .explain import Formulas, Line, explain, plainly
from .latex import number, show
from .letters import ARGUMENTS, AXES, FLIGHTS, LOOP, STUDIES, Letters, latex_name, structured, text
from .outline import outline
from .parts import Brief, SearchText, SurfaceText, known, search_text, surface_text

SHORT = 90
"""A formula of no more LaTeX than this fits a row of the table of kernels."""


@dataclass(frozen=True)
class SymbolText:
    """A row of a table of symbols."""

    latex: str
    name: str
    summary: str
    unit: str = ""


@dataclass(frozen=True)
class KernelText:
    """A kernel's results."""

    name: str
    formulas: Formulas

    @property
    def short(self) -> str | None:
        """The results in one line, none if they are too long for it."""
        parts = [rf"{line.left} \leftarrow {line.right}" for line in self.formulas.lines]
        whole = r",\quad ".join(parts)
        fits = len(whole) <= SHORT and not self.formulas.where and "cases" not in whole
        return whole if fits else None


@dataclass(frozen=True)
class ImpactText:
    """The equations of an impact, solved."""

    equations: tuple[str, ...]
    matrix: str
    unknowns: str
    right: str
    inverse: str
    solution: str
    inertia: str
    last_row: str
    kept: str
    rolled: str
    restitution: str
    lost: str


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
    safety: str
    parameters: tuple[SymbolText, ...]
    arguments: tuple[SymbolText, ...]
    brief: Formulas
    flight: Formulas
    surfaces: tuple[SurfaceText, ...]
    ends: tuple[EndText, ...]
    frame: str
    impact: ImpactText
    crossing: Formulas
    searches: tuple[SearchText, ...]
    flight_rounding: Formulas
    plane_margins: Formulas
    displacement: Formulas
    outline: str
    kernels: Mapping[str, KernelText]


def _before() -> dict[sp.Expr, str]:
    return {symbol: latex_name(symbol.name) + "^-" for symbol in BEFORE}


def _lost_energy(ball_radius: sp.Expr, restitution: sp.Expr, letters: Letters) -> str:
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
    return show(across + v3**2 * sp.factor(change.coeff(v3, 2)), _before(), letters)


def _impact(scene: Scene, letters: Letters) -> ImpactText:
    """Return the article's impact, with the restitution of the scene's first law if it has one."""
    given = (law.restitution for law in scene.laws if isinstance(law, Rolling))
    ball_radius, restitution = scene.ball_radius, next(given, RESTITUTION)
    matrix, right = impact_system(ball_radius, restitution)
    inverse = impact_inverse(ball_radius)
    solution = (inverse * right).applyfunc(sp.expand)
    v1, _, v3, _, w2, _ = BEFORE
    equations = impact_equations(ball_radius, restitution)
    return ImpactText(
        tuple(f"{show(e, _before(), letters)} &= 0" for e in equations),
        show(matrix, None, letters),
        show(sp.Matrix(AFTER), None, letters),
        show(right, _before(), letters),
        show(inverse, None, letters),
        show(solution, _before(), letters),
        show(INERTIA_FACTOR),
        show(matrix[5, 5], None, letters),
        show(solution[0].coeff(v1), None, letters),
        show(solution[0].coeff(w2), None, letters),
        show(-solution[2].coeff(v3), None, letters),
        _lost_energy(ball_radius, restitution, letters),
    )


def _kernel(
    kernel: Kernel, names: Mapping[sp.Basic, str], words: frozenset[str], letters: Letters
) -> KernelText:
    outputs = {latex_name(name, words): e for name, e in kernel.outputs}
    return KernelText(kernel.name, explain(outputs, names, letters))


def _arguments(model: Model) -> tuple[SymbolText, ...]:
    used = {
        argument.name
        for kernel in model.kernels
        for argument in kernel.arguments
        if not isinstance(argument, ParameterSymbol)
    }
    unknown = sorted(name for name in used - set(ARGUMENTS) if structured(name) is None)
    if unknown:
        raise ValueError(f"letters.py says nothing of {', '.join(unknown)}")
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

    def shown(name: str) -> str:
        return f"`{name}`" if kernels[name].short else f"[`{name}`](#{name})"

    return Derivation(
        name=scene.name,
        axes=scene.axes,
        remarks=scene.remarks,
        radius=letters(scene.ball_radius),
        roundoff=f"2^{{{int(sp.log(UNIT_ROUNDOFF, 2))}}}",
        safety=number(rounding.SAFETY) or show(rounding.SAFETY),
        parameters=tuple(
            SymbolText(letters(p.symbol), p.name, p.summary, p.unit) for p in scene.parameters
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
        impact=_impact(scene, letters),
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
    )
