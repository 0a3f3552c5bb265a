"""The data of the derivation page's template."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from hoopgen.derive.contact.frame import frame_from_axis
from hoopgen.derive.events import (
    event_polynomials,
    search_for,
)
from hoopgen.derive.events.plane import AnyPlane, PlaneSearch, plane_margin
from hoopgen.derive.events.root_search import RootSearch
from hoopgen.derive.ir.kernel import Kernel
from hoopgen.derive.model import Model
from hoopgen.derive.motion.air import AirFlight
from hoopgen.derive.motion.air_forces import PI
from hoopgen.derive.motion.parabola import Parabola
from hoopgen.derive.surfaces import ObliqueBox
from hoopgen.derive.symbolic.letters import AXES, FLIGHTS, LOOP, RESULTS, SERIES, STUDIES, Entry
from hoopgen.derive.symbolic.notation import (
    ARGUMENTS,
    ROUNDOFF,
    SERIES_TERM,
    latex_name,
    structured,
    text,
)
from hoopgen.derive.symbolic.symbols import UNIT_ROUNDOFF, ParameterSymbol, normal

from .constants import constants
from .contacts import ContactText, contact_text
from .explain import Formulas, Line, explain, plainly
from .latex import show
from .outline import outline
from .page_entries import KernelEntry, PremiseEntry, premise_entries
from .parts import Abbreviations, SearchText, SurfaceText, known, search_text, surface_text
from .premises import PREMISES
from .scene_notation import SceneNotation
from .stated_premises import stated


@dataclass(frozen=True)
class SymbolText:
    """A row of a table of symbols."""

    latex: str
    name: str
    summary: str
    unit: str = ""
    value: str = ""


@dataclass(frozen=True)
class EndText:
    """An end of a shot: its name, its plane and its bounds there."""

    name: str
    plane: str
    bounds: tuple[Line, ...]
    passed: bool


@dataclass(frozen=True)
class AirText:
    """The air that a ball flies through: the constants of its equation of motion, and v_s."""

    rates: Formulas
    smoothing: str


@dataclass(frozen=True)
class PageData:
    """The data of the template; formulas are LaTeX.

    Attributes
    ----------
    reference
        The name of the scene whose page this one does not repeat; "" if it repeats all.
    falls
        True if gravity cannot be zero along its axis.
    turned
        True if a box is turned.
    returns
        True if bounces on a plane can become ever smaller until the ball rolls.
    air
        The air that the ball flies through; None: there is none, and no flight has pieces.
    """

    name: str
    reference: str
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
    returns: bool
    displacement: Formulas
    outline: str
    kernels: Mapping[str, KernelEntry]
    premises: Mapping[str, PremiseEntry]
    series: tuple[SymbolText, ...]
    falls: bool
    turned: bool
    revolved: bool
    air: AirText | None

    @property
    def polynomial_surfaces(self) -> bool:
        """True if a surface has a polynomial in time."""
        return any(surface.degree >= 0 for surface in self.surfaces)

    @property
    def resting(self) -> dict[str, str]:
        """The key of the premise that each kernel rests on."""
        return {name: key for key, premise in self.premises.items() for name in premise.links}

    @property
    def links(self) -> dict[str, str]:
        """Each kernel's name, linked to its formulas if a page has them."""
        return _links(self.premises)

    def refer(self, key: str) -> str:
        """Return a linked reference to a premise; its title if the page lacks it."""
        found = self.premises.get(key)
        return f"[{found.label}]({found.target})" if found else f"({PREMISES[key].title})"


def _kernel(
    kernel: Kernel, names: Mapping[sp.Basic, str], words: frozenset[str], notation: SceneNotation
) -> KernelEntry:
    outputs = {
        RESULTS.get((kernel.name, name)) or latex_name(name, words): e for name, e in kernel.outputs
    }
    formulas = explain(outputs, names, notation)
    return KernelEntry(kernel.name, formulas, kernel.summary, kernel.equation)


def _arguments(model: Model) -> tuple[SymbolText, ...]:
    fields = {field.name: Entry(text(field.name), field.summary) for field in model.loop.fields}
    known = ARGUMENTS | {
        name: entry
        for name, entry in fields.items()
        if name not in ARGUMENTS and structured(name) is None
    }
    used = {
        argument.name
        for kernel in model.kernels
        for argument in kernel.arguments
        if not isinstance(argument, ParameterSymbol)
    }
    unknown = sorted(name for name in used - set(known) if structured(name) is None)
    if unknown:
        raise ValueError(f"letters.py says nothing of {', '.join(unknown)}")
    return tuple(
        SymbolText(letter.latex, name, letter.meaning)
        for name, letter in known.items()
        if name in used
    )


def _kernels(model: Model, notation: SceneNotation) -> dict[str, KernelEntry]:
    """Return the formulas of all kernels, in the names that the searches define."""
    texts = {}
    for made in (*model.surfaces, *model.end_planes):
        names: Mapping[sp.Basic, str] = {}
        if isinstance(made.search, RootSearch):
            names = known(made.search.root_finder)
        for kernel in made.kernels.values():
            texts[kernel.name] = _kernel(kernel, names, frozenset(STUDIES), notation)
    study = {kernel.name for kernel in model.study}
    for kernel in model.kernels:
        words = frozenset(FLIGHTS | LOOP if kernel.name in study else STUDIES)
        if kernel.name not in texts:
            texts[kernel.name] = _kernel(kernel, PI, words, notation)
    return texts


def _links(premises: Mapping[str, PremiseEntry]) -> dict[str, str]:
    return {k: link for premise in premises.values() for k, link in premise.links.items()}


def _series(model: Model) -> tuple[SymbolText, ...]:
    """Return the series of motions in contact whose coefficients kernels use."""
    names = (argument.name for kernel in model.kernels for argument in kernel.arguments)
    found = {match[1] for match in map(SERIES_TERM.fullmatch, names) if match}
    return tuple(
        SymbolText(letter.latex, name, letter.meaning)
        for name, letter in SERIES.items()
        if name in found
    )


def _air(flight: AirFlight, notation: SceneNotation) -> AirText:
    outputs = {latex_name(name): rate for name, rate in flight.rates().items()}
    rates = plainly(outputs, PI, notation)
    return AirText(rates, show(flight.constants.smoothing_speed, None, notation))


PI = {PI: r"\pi"}
"""The name of a number that the page rounds."""

SHORT_DECIMAL, MAX_DENOMINATOR = 12, 99
"""Length of a decimal that is preferred to a fraction, and the largest denominator of one."""


def value_text(value: float) -> str:
    """Return the shortest decimal that represents a number; infinity as a formula.

    A double that is no short decimal, but that of a fraction of small numbers, is the fraction.
    """
    if not math.isfinite(value):
        return r"$\infty$"
    fraction = Fraction(value).limit_denominator(MAX_DENOMINATOR)
    long = len(repr(value)) > SHORT_DECIMAL and float(fraction) == value
    return str(fraction) if long else repr(value)


def derivation_context(model: Model, reference: PageData | None = None) -> PageData:
    """Return the data of the template of derivation.md.

    Parameters
    ----------
    model
        The derived scene.
    reference
        The page of the first scene, if this one is to link what that has instead of repeating it.
    """
    scene = model.scene
    flight, notation = scene.flight, SceneNotation(scene)
    brief = Abbreviations(scene, notation)
    place, motion = flight.at()
    there, moving = flight.rounding(event_polynomials.horizon)
    surfaces = (*scene.surfaces, *scene.end_planes)
    planes = [s for s in surfaces if isinstance(s, AnyPlane)]
    margins = {}
    if isinstance(flight, Parabola):
        margins = {f"m_{text(p.name)}": plane_margin(p, flight) for p in planes}
    searched = (*model.kinds, *((end_plane,) for end_plane in scene.end_planes))
    lengths = [p.symbol for p in scene.parameters if p.unit == "m"]
    flown = (f"{left}(t)" for left in (*AXES, *(f"v_{axis}" for axis in AXES)))
    kernels = _kernels(model, notation)

    premises = premise_entries(
        stated(model),
        kernels,
        reference.premises if reference else {},
        reference.kernels if reference else {},
    )
    letters = reference.arguments if reference else ()
    return PageData(
        name=scene.name,
        reference=reference.name if reference else "",
        axes=scene.axes,
        remarks=scene.remarks,
        radius=notation(scene.ball_radius),
        roundoff=rf"{ROUNDOFF} = 2^{{{int(sp.log(UNIT_ROUNDOFF, 2))}}}",
        constants=constants(),
        parameters=tuple(
            SymbolText(notation(p.symbol), p.name, p.summary, p.unit, value_text(p.default))
            for p in scene.parameters
        ),
        arguments=tuple(row for row in _arguments(model) if row not in letters),
        brief=Formulas(tuple(brief.definitions)),
        flight=plainly(
            dict(zip(flown, (*place, *motion), strict=True)) if flight.exact else {}, {}, notation
        ),
        surfaces=tuple(surface_text(s, flight, brief) for s in surfaces),
        ends=tuple(
            EndText(
                scene.ends[outcome].name,
                end_plane.name,
                tuple(brief.line("", side) for side in part),
                scene.ends[outcome].passed,
            )
            for end_plane in scene.end_planes
            for outcome, part in zip(end_plane.outcomes, end_plane.parts, strict=True)
        ),
        frame=show(frame_from_axis(normal, 0).applyfunc(sp.simplify)),
        contact=contact_text(scene, notation),
        crossing=explain({latex_name(n): e for n, e in event_polynomials.crossing().items()}),
        searches=tuple(
            search_text(alike, flight, notation)
            for alike in searched
            if isinstance(search_for(alike[0], flight), RootSearch)
        ),
        flight_rounding=explain(
            {
                r"\hat r": there.magnitude,
                r"\hat\varepsilon_r": there.error,
                r"\hat v": moving.magnitude,
                r"\hat\varepsilon_v": moving.error,
            },
            {},
            notation,
        ),
        plane_margins=explain(margins, {}, notation),
        returns=any(isinstance(s.search, PlaneSearch) and s.search.returns for s in model.surfaces),
        displacement=explain(
            {r"\epsilon": event_polynomials.displacement(flight, lengths)}, {}, notation
        ),
        outline=outline(model.loop, _links(premises)),
        kernels=kernels,
        premises=premises,
        series=_series(model),
        falls=flight.falls,
        turned=any(isinstance(surface, ObliqueBox) for surface in scene.surfaces),
        revolved=scene.rolls_about_axes,
        air=_air(flight, notation) if isinstance(flight, AirFlight) else None,
    )
