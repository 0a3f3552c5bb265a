"""The symbols of state, time and normal.

Axes, units and order are the model's: the origin is the centre of the ring, z points up, the
backboard is at negative x; metres, seconds, radians.
"""

from __future__ import annotations

from typing import Any

import sympy as sp


class ParameterSymbol(sp.Symbol):  # type: ignore[misc]
    """The symbol of a scene's parameter, which differs from every other symbol of the same name."""

    def _hashable_content(self) -> tuple[Any, ...]:
        name, *assumptions = super()._hashable_content()
        return (f"{name}'", *assumptions)

    @classmethod
    def class_key(cls) -> Any:
        """Return the sort key of any symbol, so that parameters sort by name."""
        return sp.Symbol.class_key()


class ChangeSymbol(sp.Symbol):  # type: ignore[misc]
    """The symbol of the change of a scene's parameter."""


CHANGE = "change_"
"""Beginning of the names of changes of parameters."""


def change_of(parameter: sp.Symbol) -> ChangeSymbol:
    """Return the symbol of the change of a parameter."""
    return ChangeSymbol(f"{CHANGE}{parameter.name}", real=True)


def variable(symbol: sp.Symbol) -> str:
    """Return the name of a symbol as a variable of the event loop and in generated code.

    Names of parameters begin with ``p_``; no other name does.
    """
    return f"p_{symbol.name}" if isinstance(symbol, ParameterSymbol) else str(symbol.name)


x, y, z = POSITION = sp.symbols("x y z", real=True)
vx, vy, vz = VELOCITY = sp.symbols("vx vy vz", real=True)
wx, wy, wz = SPIN = sp.symbols("wx wy wz", real=True)
STATE = POSITION + VELOCITY + SPIN

t = sp.Symbol("t", real=True)
"""Time since the last contact, s."""

nx, ny, nz = NORMAL = sp.symbols("nx ny nz", real=True)
"""Outward unit normal at a contact, the article's n3."""

position = sp.Matrix(POSITION)
velocity = sp.Matrix(VELOCITY)
spin = sp.Matrix(SPIN)
normal = sp.Matrix(NORMAL)

UNIT_ROUNDOFF = sp.Rational(1, 2**53)
"""Largest relative error of one IEEE 754 double operation, rounded to nearest."""
