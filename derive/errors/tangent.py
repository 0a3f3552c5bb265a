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

LEAST = sp.Rational(1, 2**100)
"""No rounding counts for less: single precision, in which errors are carried where balls do not
roll, has no smaller numbers to speak of. It rounds the errors themselves by 2^-24 of them, which
`GUARD` covers; what it does not hold is infinite, or not a number, with which no contact is sure.
What a shot may be of is within what it holds (`ground/number_range.py`)."""

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
"""The share of the worst than which errors are no smaller: after a short hop, 1/`LIFT` itself."""
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
            # What is the same for all terms is outside, so that products that are alike serve once.
            moving = [f for f in e.args if f.free_symbols & set(tangents)]
            still = sp.Mul(*(f for f in e.args if f not in moving))
            rest = [sp.Mul(*(f for f in moving if f is not one)) for one in moving]
            turned = sp.Add(*(derive(f) * r for f, r in zip(moving, rest, strict=True)))
            return still * (turned if len(moving) == 1 else hold(turned))
        if e.is_Pow and e.exp.is_Rational:
            return e.exp * e.base ** (e.exp - 1) * derive(e.base)
        if isinstance(e, Held) and e.args[0].is_Pow and e.args[0].exp == -1:
            return hold(-(e**2) * derive(e.args[0].base))  # the inverse, once computed, serves
        if isinstance(e, Held) and e.args[0].is_Pow and e.args[0].exp == sp.Rational(1, 2):
            return hold(_halved(derive(e.args[0].base)) * hold(1 / e))  # so does the root
        if isinstance(e, Held):
            return hold(derive(e.args[0]))
        if isinstance(e, IfLess | IfAtMost):
            return e.func(e.args[0], e.args[1], derive(e.args[2]), derive(e.args[3]))
        raise TypeError(f"no derivative rule for {type(e).__name__}")

    return derive(expression)


def _halved(total: sp.Expr) -> sp.Expr:
    return sp.Add(*(term / 2 for term in sp.Add.make_args(total)))


def _signed(length: sp.Expr, like: sp.Expr) -> sp.Expr:
    return IfLess(like, 0, -length, length)


def _away(error: sp.Expr, rounding: sp.Expr) -> sp.Expr:
    """Return the error, further from zero by `rounding`."""
    return error + _signed(rounding, error)


def _greatest(components: Iterable[sp.Expr]) -> sp.Expr:
    return hold(largest(*map(size, components)))


_usual = hold(1 / hold(LIFT * (1 + contacts)))
"""The share of the worst than which errors are no smaller: 1/(LIFT k)."""


def _lifted(length: sp.Expr, floor: sp.Expr) -> sp.Expr:
    """Return the size of an error, no smaller than that share of the worst."""
    return hold(largest(length, floor))


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
    per_approach = hold(1 / hold(velocity.dot(normal)))
    delay = hold(-off * per_approach)
    _, fallen = flight.at(delay)
    falling = [after - before for after, before in zip(fallen, velocity, strict=True)]
    # An error along the surface that the ball left is across it only as far as the normal turned.
    across = smallest(1, hold(_greatest(velocity) * t) * curving)
    drift = hold(_greatest(dv) * t + hold(largest(*roundings)))
    glancing = hold(_greatest(velocity) * size(per_approach))
    aside, slow = drift, hold(_greatest(dx) + drift)
    if returning:
        aside = hold(_greatest(dv) * t + hold(largest(*_returned(flight, roundings))))
    slid = hold(slow + hold(hold(across * _greatest(dx)) + aside) * glancing)
    places = [hold(value) for value in moved + delay * velocity]
    floor = hold(slid * _usual)
    lifts = [_signed(_lifted(size(value), floor), value) for value in places]
    told: dict[str, sp.Expr] = {}
    if returning:
        # A hop changes errors by little of them, and leaves what V is off by in proportion to V.
        short = sp.Rational(1, 4)
        slid = hold(IfLess(across, short, slow, slid))
        lifts = [IfLess(across, short, *both) for both in zip(places, lifts, strict=True)]
        told["lifting"] = IfLess(across, short, sp.Rational(1, LIFT), _usual)
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
        hold(UNIT_ROUNDOFF * hold(size(place) + far) + LEAST)
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
    per_radius = hold(1 / ball_radius)
    for names, vector, per_length in ((dv, after[0], 1), (dw, after[1], per_radius)):
        rounded = hold(hold(2 * UNIT_ROUNDOFF * speed + LEAST) * per_length)
        grown = [hold(directional(component, tangents)) for component in vector]
        lengths = [hold(size(one) + rounded) for one in grown]
        floor = hold(hold(worst * (lifting if returning else _usual)) * per_length)
        lifted = [_lifted(length, floor) for length in lengths]
        lifts = [_signed(length, one) for length, one in zip(lifted, grown, strict=True)]
        if returning and names is dv:
            gained = [
                _signed(hold(more - length), one)
                for more, length, one in zip(lifted, lengths, grown, strict=True)
            ]
            off = hold(normal.dot(sp.Matrix(gained)))
            lifts = [more - off * n for more, n in zip(lifts, normal, strict=True)]
        outputs |= {str(name): value for name, value in zip(names, lifts, strict=True)}
    return outputs


def bounds(times: int) -> dict[str, sp.Expr]:
    """Return so many times the carried errors of a state and its time."""
    sizes = [largest(*(size(e) for e in errors)) for errors in (dx, dv, dw)]
    names = ("position_error", "velocity_error", "spin_error", "time_error")
    return {name: times * s for name, s in zip(names, (*sizes, clock_error), strict=True)}
