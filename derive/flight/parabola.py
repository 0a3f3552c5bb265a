"""Free flight between contacts (Eq. 3): a parabola, with constant angular velocity."""

from __future__ import annotations

import sympy as sp

from ..ground.choice import hold_all
from ..ground.symbols import POSITION, VELOCITY, t


def flight(gravity: sp.Expr, time: sp.Expr = t) -> tuple[sp.Matrix, sp.Matrix]:
    """Return position and velocity `time` after the state (Eq. 3), in Horner form."""
    x, y, z = POSITION
    vx, vy, vz = VELOCITY
    position = sp.Matrix([x + vx * time, y + vy * time, z + time * (vz - gravity * time / 2)])
    velocity = sp.Matrix([vx, vy, vz - gravity * time])
    return position, velocity


def flight_named(gravity: sp.Expr) -> tuple[sp.Matrix, sp.Matrix]:
    """Return position and velocity at the time t, each component held with a name."""
    position, velocity = flight(gravity)
    return (
        hold_all(position, [f"{axis}_t" for axis in "xyz"]),
        hold_all(velocity, [rf"\dot {axis}_t" for axis in "xyz"]),
    )


def flight_polynomials(gravity: sp.Expr) -> dict[sp.Symbol, list[sp.Expr]]:
    """Return each coordinate of the flight as its coefficients in time, constant term first."""
    x, y, z = POSITION
    vx, vy, vz = VELOCITY
    return {x: [x, vx], y: [y, vy], z: [z, vz, -gravity / 2]}
