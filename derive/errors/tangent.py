"""How far a computed state can be from the true one, estimated along the shot's own path.

A vector of errors D = (dx, dv, dw) is carried from contact to contact by the derivative of the
segment's map (flight, contact time, normal, impact), and grows at each by that segment's roundings,
each added with the sign of the component it meets, so that they do not cancel. Products of
worst-case factors would grow much faster than errors do: after a few contacts D points where the
errors grow most, as they do themselves. Where D happens to shrink in a segment, each of its
components is lifted to 1/(`LIFT` k) of what that one segment, the shot's k-th, could at worst make
of D's size before; `GUARD` covers what D has not met.

Where balls roll, bounces become ever smaller, and what they are off by across the surface must not
be mistaken for a delay of the next: with V the speed off the surface it would count |v|/V times,
and D grow by orders of magnitude that errors do not (`carried_to_contact`).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache

import sympy as sp

from ..contact.law import Law
from ..flight.parabola import Parabola
from ..ground.choice import Held, IfAtMost, IfLess, hold, largest, size, smallest
from ..ground.symbols import POSITION, UNIT_ROUNDOFF, normal, position, spin, t, velocity
from ..surfaces import Surface

GUARD = 16
"""Decisions allow for this many times the carried errors. It is generous: where these have grown
beyond single roundings, true errors were up to seven times as large, and every decision allows for
more than twice its errors besides. Near single roundings, which have bounds of their own, glancing
contacts make true errors up to fifty times the carried ones."""

CLAIM = 64
"""What a shot claims of its own time and state is more: where a decision stands far from its limit,
a bound on a number is held to the last digit, and a segment can be worse than its predecessors
foretell. `make exactness` holds both against the judge."""

LIFT = 8
"""See above. Constant, it would make an exponential growth of its own; so it is a power's."""

dx = sp.symbols("dx dy dz", real=True)
dv = sp.symbols("dvx dvy dvz", real=True)
dw = sp.symbols("dwx dwy dwz", real=True)
dn = sp.symbols("dnx dny dnz", real=True)
ERRORS = dx + dv + dw
curving, shift, turn = sp.symbols("curving shift turn", nonnegative=True)
"""Curvature of the surface that a ball meets again, infinite if it meets another one; and, at worst
after one flight, the error of the position at the contact and of the normal."""
late = sp.Symbol("late", nonnegative=True)
"""Bound on the delay of the arrival, s (`events.crossing`)."""
left_normal = sp.Matrix(sp.symbols("left_nx left_ny left_nz", real=True))
"""Normal where the flight to a contact began, if on the very surface that it meets; else zero."""
lifting = sp.Symbol("lifting", positive=True)
"""By how much of the worst errors are no smaller: after a short hop, `LIFT` itself."""
contacts = sp.Symbol("contacts", nonnegative=True)
"""How many contacts there were, this one too."""
clock, clock_error = sp.symbols("clock clock_error", nonnegative=True)
"""Time since the release, and the sum of what the contacts' times were off by, s."""

time_error = sp.Symbol("time_error", nonnegative=True)
"""Bound on the error of the time since the release that decisions allow for, s."""

ARGUMENTS = (
    clock,
    clock_error,
    contacts,
    late,
    *ERRORS,
    *dn,
    *left_normal,
    curving,
    shift,
    turn,
    lifting,
)
"""What the kernels of this room are given, in calling order."""


def directional(expression: sp.Expr, tangents: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
    """Return the derivative of `expression` along `tangents`, held where the expression is held.

    Raises
    ------
    TypeError
        If the expression holds a function without a derivative rule here.
    """

    @cache
    def derive(e: sp.Expr) -> sp.Expr:
        if e.is_Symbol:
            return tangents.get(e, sp.Integer(0))
        if not e.args or not e.free_symbols & set(tangents):
            return sp.Integer(0)
        if e.is_Add:
            return sp.Add(*map(derive, e.args))
        if e.is_Mul:
            rest = [
                sp.Mul(*(f for j, f in enumerate(e.args) if j != i)) for i in range(len(e.args))
            ]
            return sp.Add(*(derive(f) * r for f, r in zip(e.args, rest, strict=True)))
        if e.is_Pow and e.exp.is_Rational:
            return e.exp * e.base ** (e.exp - 1) * derive(e.base)
        if isinstance(e, Held) and e.args[0].is_Pow and e.args[0].exp == -1:
            return hold(-(e**2) * derive(e.args[0].base))  # the inverse, once computed, serves
        if isinstance(e, Held):
            return hold(derive(e.args[0]))
        if isinstance(e, IfLess | IfAtMost):
            return e.func(e.args[0], e.args[1], derive(e.args[2]), derive(e.args[3]))
        raise TypeError(f"no derivative rule for {type(e).__name__}")

    return derive(expression)


def _away(error: sp.Expr, rounding: sp.Expr) -> sp.Expr:
    """Return the error, further from zero by `rounding`."""
    return error + IfLess(error, 0, -rounding, rounding)


def _greatest(components: Iterable[sp.Expr]) -> sp.Expr:
    return hold(largest(*map(size, components)))


def _lifted(error: sp.Expr, worst: sp.Expr, by: sp.Expr | None = None) -> sp.Expr:
    """Return the error, not nearer to zero than 1/(LIFT k) of the worst."""
    floor = hold(worst / (hold(LIFT * (1 + contacts)) if by is None else by))
    return IfLess(size(error), floor, IfLess(error, 0, -floor, floor), error)


def carried_to_contact(flight: Parabola, returning: bool = False) -> dict[str, sp.Expr]:
    """Return the errors at the end of a flight of time t that meets a surface there.

    Arguments are the errors at its start, and the state and normal at its end. The contact of the
    erring flight is dt = -(n·dx)/(n·v) later: there its error lies in the surface.

    With `returning` a ball that comes back to the surface it left has the normal there too,
    `left_normal`. Its arrival is a root of F/t: as far off the surface as it began, so it comes
    back, and what it was off by is no delay. Of ever smaller bounces, n·v going to zero, that would
    be nearly all.
    """
    roundings = _flown(flight)
    shifts = [
        hold(_away(hold(error + drift * t), rounding))
        for error, drift, rounding in zip(dx, dv, roundings, strict=True)
    ]
    moved = sp.Matrix(shifts)
    off = hold(_off_level(flight, roundings)) if returning else moved.dot(normal)
    delay = hold(-off / hold(velocity.dot(normal)))
    _, fallen = flight.at(delay)
    falling = [after - before for after, before in zip(fallen, velocity, strict=True)]
    # An error along the surface that the ball left is across it only as far as the normal turned.
    across = smallest(1, hold(_greatest(velocity) * t) * curving)
    drift = hold(_greatest(dv) * t + hold(largest(*roundings)))
    glancing = hold(_greatest(velocity) / size(hold(velocity.dot(normal))))
    aside, slow = drift, hold(_greatest(dx) + drift)
    if returning:
        aside = hold(_greatest(dv) * t + hold(largest(*_returned(flight, roundings))))
    slid = hold(slow + hold(hold(across * _greatest(dx)) + aside) * glancing)
    places = [hold(value) for value in moved + delay * velocity]
    lifts = [_lifted(value, slid) for value in places]
    told: dict[str, sp.Expr] = {}
    if returning:
        # A hop changes errors by little of them, and leaves what V is off by in proportion to V.
        short = sp.Rational(1, 4)
        slid = hold(IfLess(across, short, slow, slid))
        lifts = [IfLess(across, short, *both) for both in zip(places, lifts, strict=True)]
        told["lifting"] = IfLess(across, short, LIFT, hold(LIFT * (1 + contacts)))
    outputs = {str(name): value for name, value in zip(dx, lifts, strict=True)} | told
    outputs |= {str(s): s + f for s, f in zip(dv, falling, strict=True)}
    return outputs | {
        "delay": largest(size(delay), late / GUARD) + 4 * UNIT_ROUNDOFF * hold(clock + t),
        "shift": slid,
    }


def started(flight: Parabola) -> dict[str, sp.Expr]:
    """Return where a flight of time t began, given the state at its end."""
    back, _ = flight.at(-t)
    return {f"from_{s}": place for s, place in zip(POSITION, back, strict=True)}


def _off_level(flight: Parabola, roundings: Sequence[sp.Expr]) -> sp.Expr:
    """Return how much further off the surface errors bring a ball than it was when it left it."""
    moved = [
        hold(_away(hold(error + drift * t), rounding))
        for error, drift, rounding in zip(dx, dv, _returned(flight, roundings), strict=True)
    ]
    return hold(normal.dot(sp.Matrix(moved))) - hold(left_normal.dot(sp.Matrix(dx)))


def _returned(flight: Parabola, roundings: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Return the roundings of a flight that count across the surface: back on it, those of F/t.

    They are some u of how far the ball flew, and as many more as its place is larger than the
    surface's radius of curvature: F/t is made of sums of such places, times a speed.
    """
    wide = hold(1 + curving * hold(sum(map(size, position))))
    return [
        IfLess(curving, sp.oo, hold(4 * UNIT_ROUNDOFF * hold(wide * far)), rounding)
        for far, rounding in zip(_ways(flight), roundings, strict=True)
    ]


def _ways(flight: Parabola) -> list[sp.Expr]:
    return [
        2 * size(v) * t + sp.Abs(pull) * t**2
        for v, pull in zip(velocity, flight.acceleration, strict=True)
    ]


def _flown(flight: Parabola) -> list[sp.Expr]:
    """Return what a flight of time t rounds of each coordinate, given the state at its end."""
    return [
        UNIT_ROUNDOFF * hold(size(place) + far)
        for place, far in zip(position, _ways(flight), strict=True)
    ]


def carried_to_time(flight: Parabola) -> dict[str, sp.Expr]:
    """Return the errors at the end of a flight of time t that ends at a time since the release.

    Arguments are the errors at its start, and the state at its end. What the contacts' times were
    off by, the flight is too short or too long; its end's own time is exact. Errors are those that
    one flight can make at worst, without their signs, since no further one shows what these do.
    """
    astray = hold(clock_error + 4 * UNIT_ROUNDOFF * hold(clock + t))
    drift = hold(_greatest(dv) * t + hold(largest(*_flown(flight))))
    worst = hold(_greatest(dx) + drift)
    _, fallen = flight.at(astray)
    outputs: dict[str, sp.Expr] = {
        str(name): worst + size(speed) * astray for name, speed in zip(dx, velocity, strict=True)
    }
    for name, after, before in zip(dv, fallen, velocity, strict=True):
        outputs[str(name)] = size(name) + size(after - before) + 2 * UNIT_ROUNDOFF * size(before)
    return outputs | {"clock_error": sp.Integer(0)}


def carried_normal(surface: Surface) -> dict[str, sp.Expr]:
    """Return the error of a surface's normal that an error of the position makes."""
    tangents = dict(zip(POSITION, dx, strict=True))
    turned = [directional(component, tangents) for component in surface.normal]
    outputs = dict(zip(map(str, dn), turned, strict=True))
    return outputs | {"turn": shift * hold(surface.curvature)}


def before_impact(ball_radius: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return the size of a motion at a contact, as velocities, and what it may at worst be off."""
    speed = hold(sum(map(size, velocity)) + ball_radius * hold(sum(map(size, spin))))
    return speed, hold(_greatest(dv) + ball_radius * _greatest(dw) + speed * turn)


def carried_through_impact(
    law: Law, ball_radius: sp.Expr, returning: bool = False
) -> dict[str, sp.Expr]:
    """Return the errors of velocity and spin after a contact, from those before it.

    With `returning` the velocity's are lifted along the surface alone: what the speed off it is
    off by is that by which the ball came, and falls with it from hop to hop.
    """
    inputs = (*velocity, *spin, *normal)
    tangents = dict(zip(inputs, (*dv, *dw, *dn), strict=True))
    after = law.after(normal, velocity, spin, ball_radius)
    speed, worst = before_impact(ball_radius)
    outputs: dict[str, sp.Expr] = {}
    for names, vector, scale in ((dv, after[0], speed), (dw, after[1], speed / ball_radius)):
        largest_one = worst if scale is speed else worst / ball_radius
        grown = [
            hold(_away(hold(directional(component, tangents)), 2 * UNIT_ROUNDOFF * scale))
            for component in vector
        ]
        lifts = [_lifted(one, largest_one, lifting if returning else None) for one in grown]
        if returning and scale is speed:
            gained = [hold(more - one) for more, one in zip(lifts, grown, strict=True)]
            off = hold(normal.dot(sp.Matrix(gained)))
            lifts = [more - off * n for more, n in zip(lifts, normal, strict=True)]
        outputs |= {str(name): value for name, value in zip(names, lifts, strict=True)}
    return outputs


def bounds(times: int) -> dict[str, sp.Expr]:
    """Return so many times the carried errors of a state and its time."""
    sizes = [largest(*(size(e) for e in errors)) for errors in (dx, dv, dw)]
    names = ("position_error", "velocity_error", "spin_error", "time_error")
    return {name: times * s for name, s in zip(names, (*sizes, clock_error), strict=True)}
