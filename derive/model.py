"""The kernels of a scene and its event loop: everything that a simulation evaluates, gathered."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, field

import sympy as sp

from .contact.frame import contact_frame
from .contact.law import Law
from .contact.rolling import impact_through_frame
from .errors import tangent
from .follow import circling, decisions, gripping, settling
from .follow import kinds as of_kinds
from .follow.fields import Result, fields, results
from .follow.kinds import Contact
from .follow.loop import Loop, event_loop
from .ground.choice import hold, largest, release
from .ground.kernel import Kernel, decision, kernel
from .ground.kinds import Like, Symbols, kinds
from .ground.number_range import MAX_FLIGHT
from .ground.rounding import extent, position_error, speed, velocity_error
from .ground.symbols import (
    NORMAL,
    POSITION,
    SPIN,
    STATE,
    VELOCITY,
    normal,
    spin,
    t,
    variable,
    velocity,
)
from .scenes import validity
from .scenes.check import check
from .scenes.names import check_kernels
from .scenes.passage import passage_kernels
from .scenes.scene import Scene
from .search import events, far, groups, search
from .search.decisions import pad
from .search.plate import reachable
from .search.search import Formula, Search
from .studies import ARGUMENTS, study_kernels
from .surfaces import Box, Surface

FRAME = sp.Matrix(3, 3, lambda i, j: sp.Symbol(f"n{i + 1}{j + 1}", real=True))
"""The contact frame's components, R of Eq. 10."""

MOTION = (*VELOCITY, *SPIN)

_NEAR = "Where a flight may reach the box of a surface at all."

RESTITUTION = sp.Symbol("restitution", nonnegative=True)
"""That of the impact through the frame, which no scene has a law for."""


@dataclass(frozen=True)
class SurfaceKernels:
    """A surface, how it is searched, and its kernels by their part.

    Attributes
    ----------
    sizes
        Of a surface that shares search and kernels with the first of its kind: its own symbol for
        each of that one's, where they differ.
    """

    surface: Surface
    search: Search
    kernels: dict[str, Kernel]
    sizes: Symbols = field(default_factory=dict)


@dataclass(frozen=True)
class Model:
    """A scene, all its kernels, and its event loop."""

    scene: Scene
    common: dict[str, Kernel]
    laws: dict[Law, dict[str, Kernel]]
    surfaces: tuple[SurfaceKernels, ...]
    gates: tuple[SurfaceKernels, ...]
    study: tuple[Kernel, ...]
    loop: Loop
    results: tuple[Result, ...]

    @property
    def kernels(self) -> tuple[Kernel, ...]:
        """Every kernel, in order."""
        of_laws = (k for kernels in self.laws.values() for k in kernels.values())
        of_surfaces = (k for s in (*self.surfaces, *self.gates) for k in s.kernels.values())
        of_kinds = {id(k): k for k in (*of_laws, *of_surfaces)}
        return (*self.common.values(), *of_kinds.values(), *self.study)

    @property
    def kinds(self) -> tuple[tuple[Surface, ...], ...]:
        """The surfaces by kind: those that share their kernels, which are named after the first."""
        found: dict[int, list[Surface]] = {}
        for made in self.surfaces:
            found.setdefault(id(made.search), []).append(made.surface)
        return tuple(tuple(alike) for alike in found.values())


def _order(scene: Scene) -> tuple[sp.Symbol, ...]:
    searching = (t, events.end, events.leaving, events.margin, events.rate_margin)
    crossing = (events.rate, events.ceiling, events.delay, events.share, events.horizon)
    sizes = (extent, speed, position_error, velocity_error)
    halves = (*far.MIDDLES, *far.REACHES, *far.LATER_MIDDLES, *far.LATER_REACHES)
    boxes = (validity.lengths, pad, *halves, *far.LEASTS, *far.MOSTS, *far.WIDES)
    own = (s for surface in scene.surfaces for s in search(surface, scene.flight).constants)
    return (
        *(*searching, *crossing, *STATE, *NORMAL, *FRAME, *sizes),
        *tangent.ARGUMENTS,
        *boxes,
        *dict.fromkeys(own),
        *ARGUMENTS,
        *scene.symbols,
        RESTITUTION,
    )


def _named(prefix: str, values: list[sp.Expr]) -> dict[str, sp.Expr]:
    return {f"{prefix}{k}": value for k, value in enumerate(values)}


def _components(names: tuple[sp.Symbol, ...], *vectors: sp.Matrix) -> dict[str, sp.Expr]:
    values = [component for vector in vectors for component in vector]
    return {symbol.name: value for symbol, value in zip(names, values, strict=True)}


def _flight_size(scene: Scene) -> sp.Expr:
    """Return the largest number of the sizes of a flight: its place, its speed and v²/g."""
    place, fastest = (hold(sum(map(sp.Abs, of))) for of in (POSITION, VELOCITY))
    return largest(place, fastest, hold(fastest**2 * hold(1 / scene.flight.strength)))


def _plain_order(scene: Scene) -> tuple[sp.Symbol, ...]:
    """Return the order of arguments of what is asked before the parameters are known to be good."""
    so_far = (
        *(validity.index, validity.blur, validity.measured),
        *(validity.valid_so_far, validity.doubt_so_far),
    )
    return (validity.last, *so_far, *STATE, *map(validity.plain, scene.symbols))


def _lengths(scene: Scene, tabled: Set[int]) -> tuple[sp.Expr, ...]:
    """Return what lengths are measured by: of many bodies, one sum that a shot begins with."""
    return (validity.lengths,) if tabled else scene.lengths


def _measuring(scene: Scene) -> dict[str, Kernel]:
    measure = kernel(
        "measure",
        validity.measure(scene),
        _plain_order(scene),
        "The sum of the sizes of the scene's lengths.",
        "what roundings are measured by",
    )
    begun = decision(
        "begun_with", {"lengths": validity.measured}, "The same, of a shot that has begun."
    )
    return {"measure": measure, "begun_with": begun}


def _common(scene: Scene, order: tuple[sp.Symbol, ...], tabled: Set[int]) -> list[Kernel]:
    through = impact_through_frame(FRAME, velocity, spin, scene.ball_radius, RESTITUTION)
    plain_order = _plain_order(scene)
    return [
        kernel(
            "flight",
            _components((*POSITION, *VELOCITY), *scene.flight.at()),
            order,
            "Position and velocity at time t of a flight.",
            "Eq. 3",
        ),
        kernel(
            "contact_frame",
            {symbol.name: e for symbol, e in zip(FRAME, contact_frame(), strict=True)},
            order,
            "The contact frame R = [n1 n2 n3] of a unit normal.",
            "Eqs. 7-10, Eq. 7 with the smallest component",
        ),
        kernel(
            "impact_through_frame",
            _components(MOTION, *through),
            order,
            "Velocity and spin after a contact, through the contact frame.",
            "Eqs. 11-17 by the closed-form inverse",
        ),
        kernel(
            "crossing",
            events.crossing(),
            order,
            "Positive clearance if a crossing is certain, and the bound on its delay.",
            "Taylor's theorem with the margins of the gap and its rate",
        ),
        kernel(
            "allowance",
            events.allowance(scene.flight),
            order,
            "Errors of a state that a search allows for, and by how much the errors exceed them.",
            "a share of the size of the flight",
        ),
        kernel(
            "horizon",
            events.padded_horizon(scene.flight),
            order,
            "A time after which no event is wanted, and how long that is after t.",
            "the earliest arrival, with room for its delay",
        ),
        kernel(
            "scale",
            {
                "extent": sp.Add(*map(sp.Abs, POSITION)),
                "speed": sp.Add(*map(sp.Abs, VELOCITY)),
                "excess": _flight_size(scene) - MAX_FLIGHT,
            },
            order,
            "Sums of the sizes of place and velocity; by how much a flight exceeds the largest.",
            "what rounding errors are measured by",
        ),
        kernel(
            "displacement",
            {"margin": events.displacement(scene.flight, _lengths(scene, tabled))},
            order,
            "Bound on the error of a length at a computed arrival.",
            "running error analysis",
        ),
        kernel(
            "carry_flight",
            tangent.carried_to_contact(scene.flight, scene.rolls),
            order,
            "Errors of a state at the end of a flight to a surface, from those at its start.",
            "derivative of Eq. 3 and of the contact time, with roundings",
            not scene.rolls,
        ),
        kernel(
            "carry_time",
            tangent.carried_to_time(scene.flight),
            order,
            "Errors of a state at the time limit, from those at the start of the flight.",
            "derivative of Eq. 3, with roundings",
            not scene.rolls,
        ),
        kernel(
            "error_bounds",
            tangent.bounds(tangent.GUARD),
            order,
            "Bounds on the errors of a state and its time that decisions allow for.",
            "the carried errors times a guard",
            not scene.rolls,
        ),
        kernel(
            "claimed_errors",
            tangent.bounds(tangent.CLAIM),
            order,
            "Bounds on the errors of a state and its time that a shot claims.",
            "the carried errors times a larger guard",
            not scene.rolls,
        ),
        kernel(
            "allowed",
            validity.allowed(scene),
            plain_order,
            "1 where finite parameters are allowed.",
            "the scene's requirements",
        ),
        kernel(
            "parameters_in_range",
            validity.parameters_in_range(scene),
            (*plain_order, validity.permission),
            "Where the parameters are allowed, and no arithmetic with them over- or underflows.",
            "the range of numbers",
        ),
        kernel(
            "valid",
            validity.valid(scene, tabled),
            plain_order,
            "1 where no surface is overlapped; 1 where that is in doubt.",
            "Table 2",
        ),
        *_aside(scene, tabled, plain_order),
    ]


def _aside(scene: Scene, tabled: Set[int], order: tuple[sp.Symbol, ...]) -> Iterator[Kernel]:
    found = {} if tabled else validity.aside(scene)
    if found:
        said = "Where a start may overlap a surface, or be in doubt; and what is said elsewhere."
        yield kernel("aside", found, order, said, "Table 2")


def _law_kernels(
    law: Law, scene: Scene, order: tuple[sp.Symbol, ...], differing: Set[sp.Symbol]
) -> dict[str, Kernel]:
    ball_radius = scene.ball_radius
    kernels = {}
    if differing:
        sizes = [symbol for symbol in scene.symbols if symbol in differing]
        said = "What the law of one body has for its own."
        kernels["taken"] = kernel(f"{law.name}_taken", of_kinds.taken(sizes), order, said, "data")
    doubt = law.doubt(normal, velocity, spin, ball_radius)
    if doubt is not None:
        kernels["doubt"] = kernel(
            f"{law.name}_doubt",
            {"unsure": doubt},
            order,
            "Where a decision within a contact lies within its error.",
            "the law's own slack",
        )
    if scene.rolls:
        kernels["settling"] = settling.settling(law, ball_radius)
        kernels["strained"] = gripping.strained(law)
    return kernels | {
        "impact": kernel(
            law.name,
            _components(MOTION, *law.after(normal, velocity, spin, ball_radius)),
            order,
            "Velocity and spin after a contact, frame-free.",
            law.source,
        ),
        "carry": kernel(
            f"carry_{law.name}",
            tangent.carried_through_impact(law, ball_radius, scene.rolls),
            order,
            "Errors of velocity and spin after a contact, from those before it.",
            f"derivative of {law.called}, with roundings",
            not scene.rolls,
        ),
    }


def _surface_kernels(
    surface: Surface,
    scene: Scene,
    order: tuple[sp.Symbol, ...],
    differing: set[sp.Symbol] | None = None,
    alike: int = 1,
) -> SurfaceKernels:
    found = search(surface, scene.flight)
    formulas: dict[str, Formula] = {}
    if surface.polynomial:
        formulas |= {
            "coefficients": (
                _named("c", events.event_coefficients(surface, scene.flight)),
                "Coefficients in time of the event polynomial, constant first.",
                "Eq. 3 in Table 2",
            ),
            "deflated": (
                _named("c", events.deflated_coefficients(surface, scene.flight)),
                "Coefficients of the event polynomial over t, after a contact at t = 0.",
                "Eq. 3 in Table 2, the exact root divided out",
            ),
        }
    formulas |= {
        "normal": (
            _components(NORMAL, surface.normal),
            "Outward unit normal n3 at a contact.",
            "Table 2",
        ),
        "curvature": (
            {"curvature": surface.curvature},
            "Bound on the rate at which the normal turns along the contact surface.",
            "Table 2",
        ),
    }
    if surface.bounds:
        formulas["bounds"] = (
            _named("g", list(surface.bounds)),
            "The g of Eq. 2: a contact counts where none is positive.",
            "Eq. 2, Table 2",
        )
    formulas |= found.formulas
    if differing is not None:
        sizes = [symbol for symbol in scene.symbols if symbol in differing]
        formulas["taken"] = (of_kinds.taken(sizes), "The sizes of one surface of a kind.", "data")
        if not found.closed and (near := far.near(surface)):
            formulas["near"] = (near, _NEAR, "boxes that do not meet")
            if alike >= groups.FEWEST:
                formulas |= _of_groups(surface)
    elif isinstance(surface, Box):
        formulas["near"] = (far.near_box(surface), _NEAR, "boxes that do not meet")
    single = found.single | (frozenset() if scene.rolls else {"carry_normal"})
    kernels = {
        part: kernel(f"{surface.name}_{part}", outputs, order, summary, equation, part in single)
        for part, (outputs, summary, equation) in formulas.items()
    }
    if differing is not None:
        kernels["start"] = kernel(
            f"{surface.name}_start",
            validity.start(surface),
            _plain_order(scene),
            "1 where a surface is not overlapped either; 1 where that is in doubt.",
            "Table 2",
        )
    if scene.rolls:
        kernels |= settling.of_surface(surface, scene.flight)
        kernels |= circling.on_ring(surface, scene.flight, scene.ball_radius)
        kernels |= circling.aside(surface)
    return SurfaceKernels(surface, found, kernels | found.decisions)


def _of_groups(surface: Surface) -> dict[str, Formula]:
    return {
        "box": (
            far.box(surface),
            "The box of a surface, of which a group has the largest.",
            "boxes that do not meet",
        ),
        "near_any": (
            far.near_any(surface),
            "Where a flight may reach the box of a group of such surfaces at all.",
            "boxes that do not meet",
        ),
    }


def _usual_box(surface: Surface, usual: Mapping[sp.Symbol, sp.Expr]) -> groups.Box:
    """Return where a surface usually is, along each axis along which it has ends."""
    found = []
    for centre, half in zip(surface.about, surface.halves, strict=True):
        if half is not None:
            middle, reach = (float(release(sp.sympify(e)).xreplace(usual)) for e in (centre, half))
            found.append((middle - reach, middle + reach))
    return found


def _in_contact(scene: Scene) -> dict[str, Kernel]:
    codes = settling.Codes(len(scene.surfaces) + len(scene.gates), len(scene.bodies))
    watch = {kernel.name: kernel for kernel in gripping.kernels(scene.flight.acceleration)}
    own = settling.kernels(scene.flight, scene.ball_radius, scene.faces, codes, scene.outcomes)
    return circling.kernels(codes) | own | watch


def _shared(scene: Scene) -> set[sp.Symbol]:
    """Return what kernels of surfaces and laws have from elsewhere, too."""
    return {scene.gravity, scene.ball_radius}


def _variables(symbols: Symbols) -> dict[str, str]:
    return {variable(one): variable(other) for one, other in symbols.items()}


def _of_kinds(
    scene: Scene, likes: Sequence[Like], order: tuple[sp.Symbol, ...]
) -> tuple[SurfaceKernels, ...]:
    """Return the surfaces; those that differ by their sizes alone share what is derived."""
    made: list[SurfaceKernels] = []
    many = Counter(like.first for like in likes)
    differing: dict[int, set[sp.Symbol]] = {}
    for index, like in enumerate(likes):
        if like.first < index:
            differing.setdefault(like.first, set()).update(like.symbols)
    for index, (surface, like) in enumerate(zip(scene.surfaces, likes, strict=True)):
        if like.first < index:
            first = made[like.first]
            made.append(SurfaceKernels(surface, first.search, first.kernels, like.symbols))
        else:
            own = differing.get(index)
            made.append(_surface_kernels(surface, scene, order, own, many[index]))
    return tuple(made)


def build(scene: Scene) -> Model:
    """Return all kernels of a scene, and its event loop.

    Raises
    ------
    ValueError
        If a formula of the scene is not what it is taken for, or two kernels have one name.
    """
    check(scene)
    order = _order(scene)
    likes = kinds(scene.surfaces, _shared(scene))
    alike = Counter(like.first for like in likes)
    tabled = {index for index, like in enumerate(likes) if alike[like.first] > 1}
    common = {k.name: k for k in _common(scene, order, tabled)}
    if tabled:
        common |= _measuring(scene)
    if scene.passage is not None:
        common |= passage_kernels(scene.passage, scene.flight, order)
    swept = kernel(
        "swept",
        far.swept(scene.flight),
        order,
        "A box that the ball is within until the horizon: its middle, and its half sizes.",
        "Eq. 3, its ends and its apex",
    )
    halved = kernel(
        "halved",
        far.halved(scene.flight),
        order,
        "The same of its first and its second half.",
        "Eq. 3, the chords of both and what it is off them",
    )
    choices = (
        {"swept": swept, "halved": halved}
        | of_kinds.KERNELS
        | decisions.kernels(scene.faces, scene.outcomes, len(scene.gates), not scene.rolls)
    )
    laws: dict[Law, dict[str, Kernel]] = {}
    of_laws = kinds(scene.laws, _shared(scene))
    for law, like in zip(scene.laws, of_laws, strict=True):
        first = scene.laws[like.first]
        own = {size for other in of_laws if other.first == like.first for size in other.symbols}
        laws[law] = laws[first] if first in laws else _law_kernels(law, scene, order, own)
    if scene.rolls:
        choices |= _in_contact(scene)
    surfaces = _of_kinds(scene, likes, order)
    tests = [made.search.apart for k, made in enumerate(surfaces) if k not in tabled]
    if any(tests):
        choices["reachable"] = reachable([test for test in tests if test])
    gates = tuple(_surface_kernels(gate, scene, order) for gate in scene.gates)
    usual = {p.symbol: sp.Rational(p.default) for p in scene.parameters if not p.infinite}
    contacts = [
        Contact(
            index,
            body,
            made.kernels,
            made.search,
            laws[scene.bodies[body].law],
            _variables(made.sizes),
            _variables(of_laws[scene.laws.index(scene.bodies[body].law)].symbols),
            _usual_box(made.surface, usual) if "box" in made.kernels else (),
            made.surface.enclosed and made.surface.steepness == 1,
        )
        for index, (body, made) in enumerate(zip(scene.faces, surfaces, strict=True))
    ]
    ends = [
        Contact(len(contacts) + k, len(scene.bodies), made.kernels, made.search, {})
        for k, made in enumerate(gates)
    ]
    names = [body.name for body in scene.bodies]
    tallied = bool(tabled) and not scene.rolls
    loop = event_loop(
        common | choices,
        contacts,
        ends,
        fields(names, scene.rolls, scene.passage is not None, tallied, bool(tabled)),
        [variable(symbol) for symbol in scene.symbols],
    )
    study = tuple(study_kernels(scene, order))
    common |= {name: made for name, made in choices.items() if name in loop.called}
    told = results(names, scene.rolls, tallied)
    model = Model(scene, common, laws, surfaces, gates, study, loop, told)
    check_kernels(scene.name, (kernel.name for kernel in model.kernels))
    return model
