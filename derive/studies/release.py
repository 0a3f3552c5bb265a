"""A release in a state: from speed and angles at a place on the floor plan.

With the heading h = azimuth + angle, the ball is released at the distance d and the angle a around
the ring's centre, and flies in the direction that is turned from there by half a turn:

    ahead = -(cos h, sin h)
    position = (d cos a, d sin a, height - ring_height)
    velocity = (v cos e ahead_x, v cos e ahead_y, v sin e)
    spin = (b ahead_y, -b ahead_x, s)

Backspin b turns about the horizontal axis across the line of flight: for ahead = -x it is +y.
"""

from __future__ import annotations

import sympy as sp

from ..symbolic.symbols import STATE

speed, elevation, azimuth, backspin, sidespin, height, distance, angle = ARGUMENTS = sp.symbols(
    "speed elevation azimuth backspin sidespin height distance angle", real=True
)
"""The arguments of a release, in the order of `hoopgen.release`."""

ring_height = sp.Symbol("ring_height", positive=True)
"""Height of the ring above the floor, m."""

heading, ahead_x, ahead_y, level = sp.symbols("heading ahead_x ahead_y level", real=True)


def release() -> tuple[dict[sp.Symbol, sp.Expr], dict[str, sp.Expr]]:
    """Return the intermediate values of a release, in order, and the state by component.

    Each value has one operation after sine and cosine, so that every target rounds it alike.
    """
    steps = {
        heading: azimuth + angle,
        ahead_x: -sp.cos(heading),
        ahead_y: -sp.sin(heading),
        level: speed * sp.cos(elevation),
    }
    state = (
        *(distance * sp.cos(angle), distance * sp.sin(angle), height - ring_height),
        *(level * ahead_x, level * ahead_y, speed * sp.sin(elevation)),
        *(backspin * ahead_y, -backspin * ahead_x, sidespin),
    )
    return steps, {symbol.name: value for symbol, value in zip(STATE, state, strict=True)}
