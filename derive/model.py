"""The kernels of a scene: everything that a simulation evaluates, gathered."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from . import aiming, events, measures, sensitivity
from .choice import AtMost, Choose, Either, IfAtMost, IfLess, Less, Not, Nowhere, every, hold, largest, size
from .events import approach, crossing, deflated_coefficients, event_coefficients
from .flight import flight
from .follow import decisions, fields
from .follow.fields import Field, Result, results
from .follow.loop import Contact, Loop, event_loop
from .frame import contact_frame
from .impact import impact, impact_through_frame
from .kernel import Kernel, kernel
from .ring import CONSTANTS, Ring
from .rounding import extent, position_error, speed, velocity_error
from .scene import Scene
from .surfaces import Plane, Surface
from .symbols import (
    NORMAL,
    POSITION,
    STATE,
    UNIT_ROUNDOFF,
    VELOCITY,
    normal,
    position,
    spin,
    t,
    velocity,
)

last = sp.Symbol("last", real=True)
"""Index of the surface that the ball touched last, -1 for none."""

LARGEST = sp.Integer(2) ** 450
"""Squares of larger coordinates and velocities come near to overflow: no result is certain."""

FRAME = sp.Matrix(3, 3, lambda i, j: sp.Symbol(f"n{i + 1}{j + 1}", real=True))
"""The contact frame's components, R of Eq. 10."""


@dataclass(frozen=True)
class SurfaceKernels:
    """The kernels of one surface, by their part in the search."""

    surface: Surface
    kernels: dict[str, Kernel]
    window_count: int = 0
    constants: tuple[str, ...] = ()

    @property
    def is_plane(self) -> bool:
        """True if its arrival is a closed form."""
        return isinstance(self.surface, Plane)


@dataclass(frozen=True)
class Model:
    """A scene and all its kernels."""

    scene: Scene
    common: dict[str, Kernel]
    surfaces: tuple[SurfaceKernels, ...]
    finish: SurfaceKernels
    study: tuple[Kernel, ...]
    loop: Loop
    results: tuple[Result, ...]

    @property
    def kernels(self) -> tuple[Kernel, ...]:
        """Every kernel, in order."""
        per_surface = (s.kernels.values() for s in (*self.surfaces, self.finish))
        found = (k for kernels in per_surface for k in kernels)
        return (*self.common.values(), *found, *self.study)


def _order(scene: Scene) -> tuple[sp.Symbol, ...]:
    searching = (t, events.end, events.leaving, events.margin, events.rate_margin)
    crossing_ = (events.rate, events.ceiling, events.delay, events.share, events.horizon)
    return (
        *(*searching, *crossing_, *STATE, *NORMAL, *FRAME),
        *(
            extent,
            speed,
            position_error,
            velocity_error,
            sensitivity.clock,
            sensitivity.clock_error,
        ),
        sensitivity.contacts,
        sensitivity.late,
        *(
            *sensitivity.ERRORS,
            *sensitivity.dn,
            sensitivity.curving,
            sensitivity.shift,
            sensitivity.turn,
        ),
        *CONSTANTS,
        *aiming.ARGUMENTS,
        *measures.ARGUMENTS,
        *scene.symbols,
    )


RESERVED = {"a", "at", "b", "c", "f", "g", "p", "r", "n", "end", "when", "which", "doubt", "bounds"}
"""Names that the targets use beside those of the kernels' arguments."""


def _check_names(scene: Scene, order: tuple[sp.Symbol, ...]) -> None:
    taken = RESERVED | {symbol.name for symbol in order if symbol not in scene.symbols}
    clashes = sorted(taken & {symbol.name for symbol in scene.symbols})
    if clashes:
        raise ValueError(f"scene {scene.name}: parameters need other names: {', '.join(clashes)}")


def _named(prefix: str, values: list[sp.Expr]) -> dict[str, sp.Expr]:
    return {f"{prefix}{k}": value for k, value in enumerate(values)}


def _components(names: tuple[sp.Symbol, ...], *vectors: sp.Matrix) -> dict[str, sp.Expr]:
    values = [component for vector in vectors for component in vector]
    return {symbol.name: value for symbol, value in zip(names, values, strict=True)}


def _plain(expression: sp.Basic) -> sp.Basic:
    """Return the expression in symbols that assume nothing of their sign."""
    return expression.xreplace({s: sp.Symbol(s.name, real=True) for s in expression.free_symbols})


def _valid(scene: Scene) -> dict[str, sp.Expr]:
    """Return whether a ball can start at a finite position, and whether that is in doubt.

    A ball is inside a surface if the largest of the surface's `inside` is negative; in doubt if
    it is within the rounding of its evaluation. The surface that the ball leaves is not asked.
    """
    lengths = [sp.Abs(_plain(p.symbol)) for p in scene.parameters if p.unit == "m"]
    slack = hold(16 * UNIT_ROUNDOFF * hold(sum(map(sp.Abs, POSITION)) + sum(lengths)))
    verdict: sp.Expr = sp.Integer(1)
    doubt: sp.Expr = sp.Integer(0)
    for index, surface in enumerate(scene.surfaces):
        overlap = hold(largest(*map(_plain, surface.inside)))
        left = hold(sp.Abs(last - index))
        verdict = IfLess(left, sp.Rational(1, 2), verdict, IfAtMost(0, overlap, verdict, 0))
        near = IfAtMost(size(overlap), hold(_plain(surface.steepness)) * slack, 1, doubt)
        doubt = IfLess(left, sp.Rational(1, 2), doubt, near)
    return {"valid": verdict, "doubt": doubt}


def _allowed(scene: Scene) -> dict[str, sp.Expr]:
    """Return 1 where the parameters are allowed; each condition falls through to the rest or 0."""
    verdict: sp.Expr = sp.Integer(1)
    for requirement in scene.requirements:
        verdict = IfLess(0, _plain(requirement), verdict, 0)
    for parameter in scene.parameters:
        value = _plain(parameter.symbol)
        if parameter.sign == "positive":
            verdict = IfLess(0, value, verdict, 0)
        if parameter.sign == "nonnegative":
            verdict = IfAtMost(0, value, verdict, 0)
        if parameter.upper is not None:
            verdict = IfAtMost(value, parameter.upper, verdict, 0)
    return {"allowed": verdict}


def _finite(scene: Scene) -> dict[str, sp.Expr]:
    """Return where every parameter is finite, and all are allowed."""
    finite = (Less(size(_plain(p.symbol)), sp.oo) for p in scene.parameters)
    return {"permitted": every(Less(0, decisions.allowed), *finite)}


def _largest_input(scene: Scene) -> sp.Expr:
    """Return the largest of what is squared or divided by."""
    return largest(1 / scene.gravity, *map(sp.Abs, (*POSITION, *VELOCITY)))


def _common(scene: Scene, order: tuple[sp.Symbol, ...]) -> list[Kernel]:
    ball_radius, restitution = scene.ball_radius, scene.restitution
    after = impact(normal, velocity, spin, ball_radius, restitution)
    through = impact_through_frame(FRAME, velocity, spin, ball_radius, restitution)
    motion = (*VELOCITY, *STATE[6:])
    plain_order = (last, *STATE, *(sp.Symbol(s.name, real=True) for s in scene.symbols))
    return [
        kernel(
            "flight",
            _components((*POSITION, *VELOCITY), *flight(scene.gravity)),
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
            _components(motion, *through),
            order,
            "Velocity and spin after a contact, through the contact frame.",
            "Eqs. 11-17 by the closed-form inverse",
        ),
        kernel(
            "impact",
            _components(motion, *after),
            order,
            "Velocity and spin after a contact, frame-free.",
            "Eqs. 11-17, the frame eliminated",
        ),
        kernel(
            "crossing",
            crossing(),
            order,
            "Positive clearance if a crossing is certain, and the bound on its delay.",
            "Taylor's theorem with the margins of the gap and its rate",
        ),
        kernel(
            "allowance",
            events.allowance(scene.gravity),
            order,
            "Errors of a state that a search allows for, and by how much the errors exceed them.",
            "a share of the size of the flight",
        ),
        kernel(
            "horizon",
            events.padded_horizon(scene.gravity),
            order,
            "A time after which no event is wanted, and how long that is after t.",
            "the earliest arrival, with room for its delay",
        ),
        kernel(
            "scale",
            {
                "extent": sp.Add(*map(sp.Abs, POSITION)),
                "speed": sp.Add(*map(sp.Abs, VELOCITY)),
                "excess": _largest_input(scene) - LARGEST,
            },
            order,
            "Sums of the sizes of the coordinates and of the velocities; excess over the largest.",
            "what rounding errors are measured by",
        ),
        kernel(
            "displacement",
            {
                "margin": events.displacement(
                    scene.gravity, [p.symbol for p in scene.parameters if p.unit == "m"]
                )
            },
            order,
            "Bound on the error of a length at a computed arrival.",
            "running error analysis",
        ),
        kernel(
            "carry_flight",
            sensitivity.carried_to_contact(scene.gravity),
            order,
            "Errors of a state at the end of a flight to a surface, from those at its start.",
            "derivative of Eq. 3 and of the contact time, with roundings",
        ),
        kernel(
            "carry_impact",
            sensitivity.carried_through_impact(ball_radius, restitution),
            order,
            "Errors of velocity and spin after a contact, from those before it.",
            "derivative of the frame-free Eq. 17, with roundings",
        ),
        kernel(
            "error_bounds",
            sensitivity.bounds(sensitivity.GUARD),
            order,
            "Bounds on the errors of a state and its time that decisions allow for.",
            "the carried errors times a guard",
        ),
        kernel(
            "claimed_errors",
            sensitivity.bounds(sensitivity.CLAIM),
            order,
            "Bounds on the errors of a state and its time that a shot claims.",
            "the carried errors times a larger guard",
        ),
        kernel(
            "allowed",
            _allowed(scene),
            plain_order,
            "1 where finite parameters are allowed.",
            "the scene's requirements",
        ),
        kernel(
            "finite_parameters",
            _finite(scene),
            (*plain_order, decisions.allowed),
            "Where the parameters are finite and allowed.",
            "IEEE 754",
        ),
        kernel(
            "valid",
            _valid(scene),
            plain_order,
            "1 where no surface is overlapped; 1 where that is in doubt.",
            "Table 2",
        ),
        kernel(
            "target",
            {"target": scene.target},
            order,
            "Not positive where a crossing of the end plane is made.",
            "Table 2, success",
        ),
    ]


def _edges(count: int) -> dict[str, tuple[dict[str, sp.Basic], str]]:
    """Return whether a contact lies within its bounds, and whether that is in doubt."""
    bounds = sp.symbols(f"g:{count}", real=True)
    slack, clearance = decisions.slack, decisions.clearance
    surely = every(*(Less(g, -slack) for g in bounds), Less(0, clearance))
    within = every(*(AtMost(g, 0) for g in bounds))
    near = every(*(AtMost(g, slack) for g in bounds))
    return {
        "within": ({"arrives": within}, "Where a contact counts (Eq. 2)."),
        "edges": (
            {"unsure": every(near, Not(surely))},
            "Where that, or the crossing, lies within its error.",
        ),
    }


def _enter(count: int) -> dict[str, sp.Basic]:
    """Return the first window, of those that a search has, that begins no earlier than `after`."""
    after = sp.Symbol("after", real=True)
    start, stop = decisions.t, decisions.end
    found: sp.Basic = Nowhere()
    for low, high in reversed(list(zip(*_windows(count), strict=True))):
        opens = every(Less(low, high), AtMost(after, low))
        start, stop = Choose(opens, low, start), Choose(opens, high, stop)
        found = Either(found, opens)
    return {"t": start, "end": stop, "searching": found}


def _windows(count: int) -> tuple[tuple[sp.Symbol, ...], tuple[sp.Symbol, ...]]:
    lows, highs = (sp.symbols(f"{name}:{count}", real=True) for name in ("low", "high"))
    return lows, highs


def _surface_kernels(
    surface: Surface, scene: Scene, order: tuple[sp.Symbol, ...]
) -> SurfaceKernels:
    name, gravity = surface.name, scene.gravity
    made: dict[str, Kernel] = {}

    def add(part: str, outputs: dict[str, sp.Expr], summary: str, equation: str) -> None:
        made[part] = kernel(f"{name}_{part}", outputs, order, summary, equation)

    add(
        "coefficients",
        _named("c", event_coefficients(surface, gravity)),
        "Coefficients in time of the event polynomial, constant first.",
        "Eq. 3 in Table 2",
    )
    add(
        "deflated",
        _named("c", deflated_coefficients(surface, gravity)),
        "Coefficients of the event polynomial over t, after a contact at t = 0.",
        "Eq. 3 in Table 2, the exact root divided out",
    )
    add(
        "normal",
        _components(NORMAL, surface.normal),
        "Outward unit normal n3 at a contact.",
        "Table 2",
    )
    add(
        "curvature",
        {"curvature": surface.curvature},
        "Bound on the rate at which the normal turns along the contact surface.",
        "Table 2",
    )
    if surface.bounds:
        add(
            "bounds",
            _named("g", list(surface.bounds)),
            "The g of Eq. 2: a contact counts where none is positive.",
            "Eq. 2, Table 2",
        )
        for part, outputs in _edges(len(surface.bounds)).items():
            found = decisions.decided(f"{name}_{part}", outputs[0], outputs[1])
            made[part] = found
    windows = 0
    constants: tuple[str, ...] = ()
    if isinstance(surface, Plane):
        add(
            "arrival",
            events.plane_arrival(surface, gravity),
            "Time of the only arrival, the gap's rate there and its bend.",
            "Eq. 3 in Table 2, solved",
        )
        add(
            "margin",
            {"margin": events.plane_margin(surface, gravity)},
            "Rounding-error bound of the gap up to the horizon.",
            "running error analysis",
        )
        add(
            "place",
            _components(POSITION, position - surface.distance * surface.normal),
            "The point of the contact plane nearest to a position.",
            "Table 2",
        )
    else:
        add(
            "carry_normal",
            sensitivity.carried_normal(surface),
            "Error of the normal, from that of the position.",
            "derivative of Table 2's normal",
        )
        search = approach(surface, gravity)
        windows, constants = len(search.windows), tuple(search.constants)
        add(
            "clear",
            {"clear": search.clear},
            "Positive if there certainly is no contact before the horizon.",
            "bounds of the event condition",
        )
        add(
            "prepare",
            search.prepare(),
            "Constants and windows of the search along a flight, and the errors it allows for.",
            "bounds of the event condition",
        )
        made["enter"] = decisions.decided(
            f"{name}_enter",
            _enter(len(search.windows)),
            "The start and end of the first window that begins no earlier than a time, if any.",
        )
        add(
            "margins",
            search.margins,
            "Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.",
            "running error analysis",
        )
        add(
            "refine",
            search.refine(),
            "Newton's next value of a root near t, and the rate there.",
            "Newton's method",
        )
        add(
            "advance",
            search.advance(),
            "Gap, rate, bend, a step without a root and its end, Newton's root and its clearance.",
            "Newton from the left under a curvature bound",
        )
    return SurfaceKernels(surface, made, windows, constants)


def _study(scene: Scene, order: tuple[sp.Symbol, ...]) -> list[Kernel]:
    """Return what studies ask: releases that go through a point, and what a flight measures."""
    gravity, source = scene.gravity, "Eq. 3 without its time"
    rings = [surface for surface in scene.surfaces if isinstance(surface, Ring)]
    return [
        kernel(
            "aimed_speed",
            aiming.aimed_speed(gravity),
            order,
            "Speed of the flight that goes through a point with a slope of release.",
            f"{source}, solved for the speed",
        ),
        kernel(
            "entry_slope",
            aiming.entry_slope(),
            order,
            "Slope at a point, positive downwards, of the flight with a slope of release.",
            f"derivative of {source}",
        ),
        kernel(
            "slope_of_entry",
            aiming.slope_of_entry(),
            order,
            "Slope of release of the flight that has a slope at a point, positive downwards.",
            f"derivative of {source}, solved for the release",
        ),
        kernel(
            "least_speed",
            aiming.least_speed(gravity),
            order,
            "Slope and speed of the slowest release through a point.",
            f"{source}, least speed: at 45° + atan(rise/reach)/2, v² = g (rise + distance)",
        ),
        kernel(
            "slopes_of_speed",
            aiming.slopes_of_speed(gravity),
            order,
            "The low and the high slope of release through a point at a speed.",
            f"{source}, solved for the slope",
        ),
        kernel(
            "descent",
            measures.descent(gravity),
            order,
            "When the centre comes down to a height, and its upward velocity then.",
            "Eq. 3, solved",
        ),
        kernel(
            "apex",
            measures.apex(gravity),
            order,
            "When the centre is highest, and its height then.",
            "Eq. 3, its derivative zero",
        ),
        kernel(
            "sighted",
            measures.sighted(),
            order,
            "How far a point is past the ring's centre and to the left, seen from a place.",
            "components along and across the line of sight",
        ),
        *(
            kernel(
                f"{ring.name}_nearness",
                measures.nearness(ring, gravity),
                order,
                "Distance of ball and wire at time t, and what bounds it within half a width of t.",
                "Eq. 3 in Table 2, Taylor's theorem",
            )
            for ring in rings
        ),
    ]


def build(scene: Scene) -> Model:
    """Return all kernels of a scene."""
    order = _order(scene)
    _check_names(scene, order)
    common = {k.name: k for k in _common(scene, order)} | decisions.KERNELS
    surfaces = tuple(_surface_kernels(surface, scene, order) for surface in scene.surfaces)
    finish = _surface_kernels(scene.finish, scene, order)
    names = [surface.name for surface in scene.surfaces]
    contacts = [
        Contact(index, made.kernels, made.window_count)
        for index, made in enumerate((*surfaces, finish))
    ]
    loop = event_loop(common, contacts, fields.fields(names), [s.name for s in scene.symbols])
    study = tuple(_study(scene, order))
    return Model(scene, common, surfaces, finish, study, loop, results(names))
