"""A release in a state: from speed and angles at a place on the floor plan.

With the heading h = azimuth + angle, the ball is released at the distance d and the angle a around
the ring's centre, and flies in the direction that is turned from there by half a turn:

    ahead = -(cos h, sin h)
    position = (d cos a, d sin a, height - ring_height)
    velocity = (v cos e ahead_x, v cos e ahead_y, v sin e)
    spin = (b ahead_y, -b ahead_x, s)

Backspin b turns about the horizontal axis across the line of flight: for ahead = -x it is +y.

The kernels are given the sine and the cosine of each angle, since every target computes these by
`derive/elementary`.
"""

from __future__ import annotations

import sympy as sp

from ..ir.kernel import Kernel, kernel
from ..symbolic.conditionals import barrier
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


_TURNS = {
    function(turned): sp.Symbol(f"{function.__name__}_{turned.name}", real=True)
    for turned in (heading, elevation, angle)
    for function in (sp.sin, sp.cos)
}
"""The sine and the cosine of each angle, as arguments of kernels."""

_ORDER = (*ARGUMENTS, ring_height, *_TURNS.values())


def _in_arguments(value: sp.Expr, steps: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
    """Return an expression of a release in the arguments of kernels, each step as a whole."""
    held = {step: barrier(v.xreplace(_TURNS)) for step, v in steps.items() if step != heading}
    return value.xreplace(_TURNS).xreplace(held)


def _derivatives() -> dict[str, sp.Expr]:
    """Return the derivatives of the state by the arguments that are not zero, by the chain rule."""
    steps, state = release()
    found = {}
    for argument in ARGUMENTS:
        rates: dict[sp.Symbol, sp.Expr] = {}
        for step, value in steps.items():
            through = sum(rate * sp.diff(value, other) for other, rate in rates.items())
            rates[step] = sp.diff(value, argument) + through
        for component, value in state.items():
            through = sum(
                barrier(rate) * sp.diff(value, step) for step, rate in rates.items() if rate != 0
            )
            total = sp.diff(value, argument) + through
            if total != 0:
                found[f"{component}_by_{argument.name}"] = _in_arguments(total, steps)
    return found


def kernels() -> tuple[Kernel, ...]:
    """Return the kernels of the heading, the state and its derivatives by the arguments."""
    steps, state = release()
    return (
        kernel(
            "release_heading",
            {"heading": steps[heading]},
            _ORDER,
            "Direction from the ring's centre opposite to which the ball is sent.",
            "h = azimuth + angle",
        ),
        kernel(
            "release_state",
            {name: _in_arguments(value, steps) for name, value in state.items()},
            _ORDER,
            "State of a release, given the sine and the cosine of its angles.",
            "ahead = -(cos h, sin h)",
        ),
        kernel(
            "release_jacobian",
            _derivatives(),
            _ORDER,
            "Derivatives of the state of a release by its arguments that are not zero.",
            "the chain rule",
        ),
    )
