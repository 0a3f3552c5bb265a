"""The symbols of errors that are carried as a vector, and the factor of decisions.

Scenes of rings, planes and boxes carry proved bounds instead (`errors/contact_frames.py`), as long
as no ball rolls.
"""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from .conditionals import absolute, barrier, maximum
from .symbols import spin, velocity

DECISION_FACTOR = 16
"""Decisions allow for this many times the carried errors. Where errors have grown beyond single
roundings, true errors were up to eleven times as large in most shots, and every decision allows
for more than twice its errors besides. At one contact in 10,000 of the hoop they were larger, up to
87 times the carried ones, mostly near single roundings."""

dx = sp.symbols("dx dy dz", real=True)
dv = sp.symbols("dvx dvy dvz", real=True)
dw = sp.symbols("dwx dwy dwz", real=True)
dn = sp.symbols("dnx dny dnz", real=True)
ERRORS = dx + dv + dw
"""Errors of position, velocity and spin."""
curving, shift, turn = sp.symbols("curving shift turn", nonnegative=True)
"""Curvature of the surface if the ball meets it again, else infinite; bounds, after one flight,
on the error of the position at the contact and on that of the normal."""
earliest_delay = sp.Symbol("earliest_delay", nonnegative=True)
"""Bound on the delay of the arrival, s (`event_polynomials.crossing`)."""
left_normal = sp.Matrix(sp.symbols("left_nx left_ny left_nz", real=True))
"""Normal at the start of the flight if it began on the surface that it meets; else zero."""
lifting = sp.Symbol("lifting", positive=True)
"""Share of the worst case that errors do not fall below; after a short hop
1/`MIN_GROWTH_DIVISOR`."""
root_delay = sp.Symbol("root_delay", nonnegative=True)
"""Bound on the delay of a contact that the roundings of its condition cause, s."""
contacts = sp.Symbol("contacts", nonnegative=True)
"""Number of contacts, including this one."""
clock, clock_error = sp.symbols("clock clock_error", nonnegative=True)
"""Time since the release, and the sum of the errors of the contacts' times, s."""

time_error = sp.Symbol("time_error", nonnegative=True)
"""Bound on the error of the time since the release that decisions allow for, s."""


def greatest(components: Iterable[sp.Expr]) -> sp.Expr:
    """Return the largest absolute value of the components of an error, held."""
    return barrier(maximum(*map(absolute, components)))


def before_impact(ball_radius: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return the size of a motion at a contact, and a bound on its error, both as velocities."""
    speed = barrier(sum(map(absolute, velocity)) + ball_radius * barrier(sum(map(absolute, spin))))
    return speed, barrier(greatest(dv) + ball_radius * greatest(dw) + speed * turn)
