"""The calculus of errors: derivatives along a flight, a contact time, a normal and an impact.

They are exact to first order and hold no policy: how much larger bounds are taken than what follows
from these derivatives is decided in `propagation`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from types import MappingProxyType

import sympy as sp

from ..contact.ball import Ball
from ..contact.law import Law
from ..motion.flight import Flight
from ..surfaces import Surface
from ..symbolic.conditionals import Barrier, Choose, IfAtMost, IfLess, barrier
from ..symbolic.error_terms import dn, dv, dw, dx
from ..symbolic.symbols import POSITION, normal, spin, velocity


def directional(expression: sp.Expr, tangents: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
    """Return the derivative of `expression` along `tangents`, held where the expression is held.

    Parameters
    ----------
    expression
        An expression, in which parts may be held against reassociation.
    tangents
        The change of each symbol; other symbols do not change.

    Raises
    ------
    TypeError
        If the expression holds a function without a derivative rule here.
    """

    @cache
    def changes(e: sp.Basic) -> bool:
        return e in tangents or any(map(changes, e.args))

    @cache
    def derive(e: sp.Expr) -> sp.Expr:
        if e.is_Symbol:
            return tangents.get(e, sp.Integer(0))
        if not changes(e):
            return sp.Integer(0)
        if e.is_Add:
            return sp.Add(*map(derive, e.args))
        if e.is_Mul:
            # Constant factors stand outside, so that equal products are computed once.
            moving = [f for f in e.args if changes(f)]
            still = sp.Mul(*(f for f in e.args if f not in moving))
            rest = [sp.Mul(*(f for f in moving if f is not one)) for one in moving]
            turned = sp.Add(*(derive(f) * r for f, r in zip(moving, rest, strict=True)))
            return still * (turned if len(moving) == 1 else barrier(turned))
        if e.is_Pow and e.exp.is_Rational:
            return e.exp * e.base ** (e.exp - 1) * derive(e.base)
        if isinstance(e, Barrier) and e.args[0].is_Pow and e.args[0].exp == -1:
            return barrier(-(e**2) * derive(e.args[0].base))  # reuses the computed inverse
        if isinstance(e, Barrier) and e.args[0].is_Pow and e.args[0].exp == sp.Rational(1, 2):
            return barrier(
                _halved(derive(e.args[0].base)) * barrier(1 / e)
            )  # reuses the computed root
        if isinstance(e, Barrier):
            return barrier(derive(e.args[0]))
        if isinstance(e, sp.Abs):
            (quantity,) = e.args
            return IfLess(quantity, 0, -derive(quantity), derive(quantity))
        if isinstance(e, IfLess | IfAtMost):
            return e.func(e.args[0], e.args[1], derive(e.args[2]), derive(e.args[3]))
        if isinstance(e, Choose):
            return Choose(e.args[0], derive(e.args[1]), derive(e.args[2]))
        raise TypeError(f"no derivative rule for {type(e).__name__}")

    return derive(expression)


def _halved(total: sp.Expr) -> sp.Expr:
    return sp.Add(*(term / 2 for term in sp.Add.make_args(total)))


def per_approach() -> sp.Expr:
    """Return the inverse of the normal velocity at the contact."""
    return barrier(1 / barrier(velocity.dot(normal)))


def contact_delay(offset: sp.Expr) -> sp.Expr:
    """Return the delay of the contact of a ball that is further off the surface by `offset`."""
    return barrier(-offset * per_approach())


def at_contact(moved: Sequence[sp.Expr], delay: sp.Expr) -> list[sp.Expr]:
    """Return the change of the position at the delayed contact: it lies in the surface.

    Parameters
    ----------
    moved
        The change of the position at the time of the undisturbed contact, (3,).
    delay
        The change of the time of the contact.
    """
    return [barrier(value) for value in sp.Matrix(moved) + delay * velocity]


def velocity_change(flight: Flight, delay: sp.Expr) -> list[sp.Expr]:
    """Return the change of the velocity during the delay.

    Parameters
    ----------
    flight
        The motion before the contact.
    delay
        The change of the time of the contact.

    Returns
    -------
    list of Expr
        (3,).
    """
    return [acceleration * delay for acceleration in flight.present_acceleration]


def along_normal(surface: Surface) -> list[sp.Expr]:
    """Return the change of a surface's normal by an error of the position."""
    tangents = dict(zip(POSITION, dx, strict=True))
    return [directional(component, tangents) for component in surface.normal]


def along_impact(
    law: Law, ball: Ball, changes: Mapping[sp.Symbol, sp.Expr] = MappingProxyType({})
) -> tuple[list[sp.Expr], list[sp.Expr]]:
    """Return the change of velocity and spin after a contact by errors before it.

    Parameters
    ----------
    law
        The contact law.
    ball
        The ball.
    changes
        The changes of parameters, none by default.
    """
    inputs = (*velocity, *spin, *normal)
    tangents = dict(zip(inputs, (*dv, *dw, *dn), strict=True)) | dict(changes)
    after = law.after(normal, velocity, spin, ball)
    v, w = ([barrier(directional(component, tangents)) for component in part] for part in after)
    return v, w
