"""The kernels of first-order variations: how a shot changes with its release and its parameters.

At a contact their matrix is called the saltation matrix (Kong et al., Proc. IEEE 112(6), 2024).

They are exact derivatives, apart from the roundings of their own evaluation: of the flight, of the
time and place of a contact, of the normal there, and of the contact law. The event loop evaluates
none of them; they follow the events of a shot afterwards. A variation holds at a fixed time, and
the variations of an event at the event itself, whose time varies too.

A flight through air has no formula. The coefficients of its series follow from each other, order by
order, and so do their variations: those of an order from those of the orders before, by the
derivative of the same recurrence. What the series leaves out of the variation of the velocity is
the derivative of what it leaves out of the velocity.
"""

from __future__ import annotations

import sympy as sp

from ..contact.law import Law
from ..errors import derivative
from ..events.search import Formula
from ..ir.kernel import Kernel, kernel
from ..motion.air import AirFlight
from ..motion.air_series import ORDER, PLAIN_SERIES
from ..scenes.scene import Scene
from ..surfaces import EndPlane, Surface
from ..symbolic.conditionals import barrier
from ..symbolic.error_terms import dn, dv, dw, dx
from ..symbolic.symbols import POSITION, SPIN, VELOCITY, change_of, normal, spin, velocity

contact_delay = sp.Symbol("contact_delay", real=True)
"""Variation of the time of a contact, s."""


def _changes(scene: Scene) -> dict[sp.Symbol, sp.Expr]:
    """Return the change of each parameter of a scene."""
    return {symbol: change_of(symbol) for symbol in scene.symbols}


def variation_of(symbol: sp.Symbol) -> sp.Symbol:
    """Return the symbol of the variation of a symbol of the flight."""
    return sp.Symbol(f"d{symbol.name}", real=True)


def _series_changes(scene: Scene) -> dict[sp.Symbol, sp.Expr]:
    """Return the variations of the symbols on which the coefficients of a piece's series depend."""
    if not isinstance(scene.flight, AirFlight):
        return {}
    return {symbol: variation_of(symbol) for symbol in scene.flight.coefficients}


def variation_symbols(scene: Scene) -> tuple[sp.Symbol, ...]:
    """Return the symbols of variations that kernels of the flight pass to others."""
    return tuple(_series_changes(scene).values())


def piece_variations(scene: Scene, order: tuple[sp.Symbol, ...]) -> tuple[Kernel, ...]:
    """Return the variations of a piece's series, if the flight has pieces.

    Each is named after the kernel of which it is the derivative.

    Parameters
    ----------
    scene
        The scene.
    order
        The symbols in the order of arguments.
    """
    flight = scene.flight
    if not isinstance(flight, AirFlight):
        return ()
    moved = dict(zip((*VELOCITY, *SPIN), (*dv, *dw), strict=True))
    moved |= _series_changes(scene) | _changes(scene)

    def varied(name: str, outputs: dict[str, sp.Expr], summary: str) -> Kernel:
        changes = {f"d{key}": derivative.directional(e, moved) for key, e in outputs.items()}
        return kernel(f"vary_{name}", changes, order, summary, f"derivative of {name}")

    rates = "Variations of the rates of drag and Magnus force, and of gravity less buoyancy."
    terms = "Variations of the coefficients of order {} of a piece's series."
    return (
        varied("air_rates", flight.rates(), rates),
        *(
            varied(f"air_order_{k}", flight.order(k, PLAIN_SERIES), terms.format(k))
            for k in range(ORDER + 1)
        ),
    )


def scene_variations(scene: Scene, order: tuple[sp.Symbol, ...]) -> tuple[Kernel, ...]:
    """Return the variations of a flight, and of the flight that begins at a varied contact.

    Parameters
    ----------
    scene, order
        As for `piece_variations`.
    """
    start = dict(zip((*POSITION, *VELOCITY), (*dx, *dv), strict=True))
    start |= _series_changes(scene) | _changes(scene)
    moved = [
        derivative.directional(component, start) for part in scene.flight.at() for component in part
    ]
    names = [symbol.name for symbol in (*dx, *dv)]
    changes = derivative.velocity_change(scene.flight, -contact_delay)
    back = (
        *(place - speed * contact_delay for place, speed in zip(dx, velocity, strict=True)),
        *(speed + change for speed, change in zip(dv, changes, strict=True)),
    )
    return (
        kernel(
            "vary_flight",
            dict(zip(names, moved, strict=True)),
            order,
            "Variations of position and velocity at time t of a flight, from those at its start.",
            f"derivative of {scene.flight.source}",
        ),
        kernel(
            "vary_departure",
            dict(zip(names, back, strict=True)),
            order,
            "Variations of position and velocity after a contact, at the time of the contact.",
            f"derivative of {scene.flight.source} at its start",
        ),
    )


def contact_variation(surface: Surface, scene: Scene) -> Formula:
    """Return the variations at the contact with a surface, from those at its time.

    With the distance d, the normal n and the velocity v the delay of the contact is
    dt = -(n·dx + the change of d by the parameters) / (n·v); there the position varies by dx + v dt
    and the velocity by dv + a dt. The change of d at the time itself, and the bounds g of Eq. 2
    with their changes at the contact, tell how far decisions are from being others.

    Parameters
    ----------
    surface
        The surface that is touched.
    scene
        The scene, whose parameters vary, too.

    Returns
    -------
    Formula
        Its outputs, its summary and its source.
    """
    changes = _changes(scene)
    offset = normal.dot(sp.Matrix(dx)) + derivative.directional(surface.distance, changes)
    gap_change = barrier(offset)
    delay_of = derivative.contact_delay(gap_change)
    place = derivative.at_contact(dx, delay_of)
    sped = derivative.velocity_change(scene.flight, delay_of)
    along = dict(zip(POSITION, place, strict=True)) | changes
    turned = [derivative.directional(component, along) for component in surface.normal]
    names = [symbol.name for symbol in (*dx, *dv, *dn)]
    speeds = [before + change for before, change in zip(dv, sped, strict=True)]
    values = (*place, *speeds, *turned)
    formulas = dict(zip(names, values, strict=True))
    bounds = surface.sides if isinstance(surface, EndPlane) else surface.bounds
    for k, bound in enumerate(bounds):
        formulas[f"g{k}"] = bound
        formulas[f"g{k}_change"] = derivative.directional(bound, along)
    return (
        {"contact_delay": delay_of, "gap": surface.distance, "gap_change": gap_change} | formulas,
        "Delay of a contact, distance there, and variations of position, velocity and normal; the "
        "change of the distance at a fixed time, and bounds with their changes at the contact.",
        f"derivatives of the distance, of {scene.flight.source}, of the normal and of Eq. 2",
    )


def law_variation(law: Law, scene: Scene, order: tuple[sp.Symbol, ...]) -> Kernel:
    """Return the variations of velocity and spin after a contact, from those before it.

    Parameters
    ----------
    law
        The contact law.
    scene
        The scene, whose parameters vary, too.
    order
        The symbols in the order of arguments.
    """
    velocities, spins = derivative.along_impact(law, scene.ball, _changes(scene))
    names = [symbol.name for symbol in (*dv, *dw)]
    formulas = dict(zip(names, (*velocities, *spins), strict=True))
    margin = law.grip_margin(normal, velocity, spin, scene.ball)
    if margin is not None:
        inputs = dict(zip((*velocity, *spin, *normal), (*dv, *dw, *dn), strict=True))
        formulas["grip_margin"] = margin
        formulas["grip_margin_change"] = derivative.directional(margin, inputs | _changes(scene))
    return kernel(
        f"vary_{law.name}",
        formulas,
        order,
        "Variations of velocity and spin after a contact, from those before it.",
        f"derivative of {law.description}",
    )
