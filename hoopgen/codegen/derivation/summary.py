"""The derivation on two pages with one worked shot, generated/summary.md.

The shot is computed in many digits from the objects that the kernels are generated from: the
polynomial of each surface, its roots, the normal and the impact. No engine takes part.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from hoopgen.derive.events.event_polynomials import deflated_coefficients, event_coefficients
from hoopgen.derive.motion.parabola import Parabola
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.surfaces import EndPlane, Surface
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.derive.symbolic.symbols import (
    NORMAL,
    POSITION,
    SPIN,
    STATE,
    VELOCITY,
    normal,
    spin,
    velocity,
)
from hoopgen.derive.symbolic.symbols import t as time

DIGITS = 40
"""Digits of the numbers of the worked shot."""

EVENTS = 10
"""Number of events that is too large for two pages."""

FREE_THROW = {
    "speed": sp.Rational("7.166"),
    "elevation": sp.Rational("51.101"),
    "backspin": sp.Integer(3),
    "height": sp.Rational("2.4384"),
    "distance": sp.Rational("4.191"),
}
"""The article's missed free throw: m/s, degrees, Hz, m above the floor and from the ring."""

RING_HEIGHT = sp.Rational("3.048")
"""Height of the ring above the floor, m."""

Numbers = Mapping[sp.Basic, sp.Expr]


@dataclass(frozen=True)
class ArrivalText:
    """An arrival on a surface: the first falling root of a flight, and whether it counts."""

    surface: str
    degree: int
    time: str
    counts: str


@dataclass(frozen=True)
class EventText:
    """An event of the shot; vectors as text."""

    time: str
    name: str
    position: str
    before: str
    after: str


@dataclass(frozen=True)
class ShotText:
    """A worked shot.

    Attributes
    ----------
    release
        The arguments of the release.
    state
        The state at the release.
    surface
        The surface of the first event.
    coefficients
        The coefficients of the first flight's polynomial of its first event, with their numbers.
    roots
        The real roots of that polynomial, after the release.
    arrivals
        The arrival of the first flight on each surface.
    normal, before, after
        At the first impact: the normal, and velocity and spin before and after it.
    events
        All events of the shot.
    """

    release: Mapping[str, str]
    state: tuple[tuple[str, str], ...]
    surface: str
    coefficients: tuple[tuple[str, str], ...]
    roots: tuple[str, ...]
    arrivals: tuple[ArrivalText, ...]
    normal: str
    before: tuple[str, str]
    after: tuple[str, str]
    events: tuple[EventText, ...]


def decimal(value: sp.Expr) -> str:
    """Return a number rounded to four decimals; never minus zero."""
    text = f"{float(value):.4f}"
    return text.lstrip("-") if float(text) == 0 else text


def _vector(values: Sequence[sp.Expr]) -> str:
    return "(" + ", ".join(decimal(value) for value in values) + ")"


def free_throw() -> dict[sp.Basic, sp.Expr]:
    """Return the state of the release, with many digits: along -x, backspin about y."""
    angle = FREE_THROW["elevation"] * sp.pi / 180
    values = (
        *(FREE_THROW["distance"], 0, FREE_THROW["height"] - RING_HEIGHT),
        *(-FREE_THROW["speed"] * sp.cos(angle), 0, FREE_THROW["speed"] * sp.sin(angle)),
        *(0, 2 * sp.pi * FREE_THROW["backspin"], 0),
    )
    return {s: sp.sympify(value).evalf(DIGITS) for s, value in zip(STATE, values, strict=True)}


def _value(expression: sp.Basic, numbers: Numbers) -> sp.Expr:
    return sp.sympify(release(sp.sympify(expression))).subs(numbers).doit().evalf(DIGITS)


@dataclass(frozen=True)
class Arrival:
    """The first time at which a flight meets a surface within its bounds, and its polynomial."""

    surface: Surface
    coefficients: tuple[sp.Expr, ...]
    roots: tuple[sp.Expr, ...]
    falling: tuple[sp.Expr, ...]
    counted: tuple[sp.Expr, ...]

    @property
    def time(self) -> sp.Expr:
        """The time of the arrival; infinite if there is none."""
        return min(self.counted, default=sp.oo)


def arrival(surface: Surface, flight: Parabola, numbers: Numbers, leaving: bool) -> Arrival:
    """Return the arrival of a flight on a surface, from all roots of its polynomial.

    Parameters
    ----------
    surface
        The surface that the ball comes to.
    flight
        The flight, a parabola.
    numbers
        The state and the parameters, SI, as exact numbers of SymPy.
    leaving
        True if the flight starts on this surface; the root 0 is then divided out.

    Returns
    -------
    Arrival
        The time, s, infinite without an arrival; and the polynomial.
    """
    made = deflated_coefficients if leaving else event_coefficients
    coefficients = [_value(c, numbers) for c in made(surface, flight)]
    polynomial = sp.Poly(coefficients[::-1], time)
    found = polynomial.nroots(n=DIGITS // 2, maxsteps=200) if polynomial.degree() > 0 else []
    tiny = sp.Rational(1, 10**12)
    roots = sorted(sp.re(root) for root in found if abs(sp.im(root)) < tiny and sp.re(root) > tiny)
    # At a root F and F/t have rates of the same sign.
    slope = polynomial.diff(time)
    falling = [root for root in roots if slope.eval(root) < 0]
    counted = [root for root in falling if _inside(surface, flight, numbers, root)]
    return Arrival(surface, *map(tuple, (coefficients, roots, falling, counted)))


def _inside(surface: Surface, flight: Parabola, numbers: Numbers, at: sp.Expr) -> bool:
    there = moved(flight, numbers, at)
    return all(_value(bound, there) <= 0 for bound in surface.bounds)


def moved(flight: Parabola, numbers: Numbers, at: sp.Expr) -> dict[sp.Basic, sp.Expr]:
    """Return the numbers after a flight of that duration.

    Parameters
    ----------
    flight
        The flight, a parabola.
    numbers
        The state at its start and the parameters, SI.
    at
        The duration, s.

    Returns
    -------
    dict
        The same with the state at its end.
    """
    place, motion = flight.at()
    now = {**numbers, time: at}
    names = (*POSITION, *VELOCITY)
    flown = {s: _value(e, now) for s, e in zip(names, (*place, *motion), strict=True)}
    return {**numbers, **flown}


def _outcome(scene: Scene, end_plane: EndPlane, numbers: Numbers) -> str:
    for outcome, bounds in zip(end_plane.outcomes, end_plane.parts, strict=True):
        if all(_value(bound, numbers) <= 0 for bound in bounds):
            return scene.ends[outcome].name
    raise ValueError(f"scene {scene.name}: a crossing of {end_plane.name} is none of its ends")


def worked_shot(scene: Scene) -> ShotText:
    """Return the article's missed free throw in a scene with its hoop, at the default parameters.

    Raises
    ------
    ValueError
        If a surface has no polynomial condition, or the shot more than `EVENTS` events, or none on
        a surface.
    """
    without = [surface.name for surface in scene.surfaces if not surface.polynomial]
    if without:
        raise ValueError(
            f"scene {scene.name}: expected surfaces with a polynomial condition, got "
            f"{', '.join(without)} without"
        )
    usual = {p.symbol: sp.Rational(repr(p.default)) for p in scene.parameters}
    numbers: dict[sp.Basic, sp.Expr] = {**usual, **free_throw()}
    clock, last = sp.Integer(0), None
    events: list[EventText] = []
    first: tuple[list[Arrival], Arrival, str, tuple[str, str], tuple[str, str]] | None = None
    while len(events) < EVENTS:
        surfaces = (*scene.surfaces, *scene.end_planes)
        found = [arrival(s, scene.parabola, numbers, s is last) for s in surfaces]
        event = min(found, key=lambda one: one.time)
        clock += event.time
        numbers = moved(scene.parabola, numbers, event.time)
        place, before = ([numbers[s] for s in part] for part in (POSITION, VELOCITY))
        if isinstance(event.surface, EndPlane):
            name = _outcome(scene, event.surface, numbers)
            events.append(EventText(decimal(clock), name, _vector(place), _vector(before), ""))
            break
        turning = [numbers[s] for s in SPIN]
        facing = [_value(component, numbers) for component in event.surface.normal]
        law = scene.bodies[scene.faces[scene.surfaces.index(event.surface)]].law
        after = law.after(normal, velocity, spin, scene.ball)
        known = {**numbers, **dict(zip(NORMAL, facing, strict=True))}
        v, w = ([_value(component, known) for component in part] for part in after)
        numbers |= dict(zip((*VELOCITY, *SPIN), (*v, *w), strict=True))
        events.append(
            EventText(
                *(decimal(clock), event.surface.name, _vector(place)),
                *(_vector(before), _vector(v)),
            )
        )
        if first is None:
            motions = ((_vector(before), _vector(turning)), (_vector(v), _vector(w)))
            first = (found, event, _vector(facing), *motions)
        last = event.surface
    if first is None or len(events) == EVENTS:
        raise ValueError(f"scene {scene.name}: its shot is not one for two pages")
    arrivals, event, facing_text, came, left = first
    return ShotText(
        {name: f"{float(value):g}" for name, value in FREE_THROW.items()},
        tuple((s.name, decimal(free_throw()[s])) for s in STATE),
        event.surface.name,
        tuple((f"c_{{{k}}}", decimal(c)) for k, c in enumerate(event.coefficients)),
        tuple(decimal(root) for root in event.roots),
        tuple(map(_arrival_text, arrivals)),
        facing_text,
        came,
        left,
        tuple(events),
    )


def _arrival_text(found: Arrival) -> ArrivalText:
    counts, at = "there is no root at which the gap falls", "–"
    if found.falling:
        at, counts = decimal(found.falling[0]), "out of bounds"
    if found.counted:
        at, counts = decimal(found.counted[0]), "yes"
    return ArrivalText(found.surface.name, len(found.coefficients) - 1, at, counts)
