"""The kernels of one surface in the contact phase: beside a rolling ball, and under it."""

from __future__ import annotations

import sympy as sp

from ..errors.derivative import directional
from ..ir.kernel import Kernel, loop_kernel
from ..motion import rolling_series
from ..motion.flight import Flight
from ..surfaces import Surface
from ..surfaces.rolling_surface import RollingSurface
from ..symbolic.conditionals import barrier
from ..symbolic.symbols import POSITION, VELOCITY, normal
from .bounds import bound_kernels, limits
from .symbols import gap_convexity, rolled, rolling_acceleration, turning


def contact_phase_kernels(
    surface: Surface,
    flight: Flight,
    ball_radius: sp.Expr,
    edges: bool,
    oblique: bool,
    revolved: bool,
) -> dict[str, Kernel]:
    """Return the kernels of one surface by part: all have those beside it, some those on it.

    Parameters
    ----------
    surface
        The surface.
    flight
        The motion between contacts.
    ball_radius
        R_B.
    edges
        True if the scene has surfaces with bounds.
    oblique
        True if a ball may roll on a tube of the scene that lies along no axis.
    revolved
        True if a ball may roll on a cone or a torus of the scene, in the coordinates of the scene.
    """
    kernels = _beside(surface, edges)
    if edges:
        kernels |= bound_kernels(surface, ball_radius) | {"facing": _facing(surface)}
    if surface.surface_below(flight.upright) is None:
        return kernels
    return kernels | _under(surface, flight, oblique, revolved)


def _beside(surface: Surface, edges: bool) -> dict[str, Kernel]:
    """Return the distance to the surface of a ball that rolls on another one, and its rates."""
    behind = {str(gap_convexity): surface.max_convexity} if edges and limits(surface) else {}
    along = dict(zip(POSITION, VELOCITY, strict=True))
    turns = dict(zip(POSITION, rolled, strict=True))
    pushed = dict(zip(rolled, rolling_acceleration, strict=True))
    facing_on = dict(zip(POSITION, normal, strict=True))
    held = _hold_all_parts(surface.own_distance)
    rate = directional(held, turns)
    return {
        "beside": loop_kernel(
            f"{surface.name}_beside",
            {
                "gap": barrier(surface.own_distance),
                "nearing": directional(surface.own_distance, along),
                "gap_curvature": surface.max_concavity,
                **behind,
            },
            "Distance, its rate, and a bound on how fast it bends down, by the squared speed.",
            "Table 2",
        ),
        "closing": loop_kernel(
            f"{surface.name}_closing",
            {
                "gap": barrier(surface.own_distance),
                "nearing": rate,
                "rolling_gap_acceleration": directional(rate, turns | pushed),
                "normal_cosine": directional(held, facing_on),
            },
            "Distance of a ball that rolls on another surface, and its first two derivatives.",
            "derivatives of Table 2's distance",
        ),
    }


def _facing(surface: Surface) -> Kernel:
    """Return the kernel of the angle between the normals of the surface and of the one below."""
    facing_on = dict(zip(POSITION, normal, strict=True))
    cosine = directional(_hold_all_parts(surface.own_distance), facing_on)
    return loop_kernel(
        f"{surface.name}_facing",
        {"normal_cosine": cosine},
        "Cosine of the angle between the normals of two surfaces.",
        "derivative of Table 2's distance",
    )


def _under(surface: Surface, flight: Flight, oblique: bool, revolved: bool) -> dict[str, Kernel]:
    """Return the kernels from which the motion on the surface is computed."""
    name, rolling_surface = surface.name, surface.surface_below(flight.upright)
    assert rolling_surface is not None
    along = dict(zip(POSITION, VELOCITY, strict=True))
    rates = along | dict(zip(VELOCITY, flight.present_acceleration, strict=True))
    turns = dict(zip(POSITION, rolled, strict=True))
    derivatives = [_hold_all_parts(surface.distance_ahead)]
    for _ in range(4):
        derivatives.append(directional(derivatives[-1], rates))
    named = zip(turning, surface.normal, strict=True)
    curved: dict[str, sp.Expr] = {}
    if oblique:
        rows = zip(rolling_series.across, rolling_surface.projection, strict=True)
        for symbols, row in rows:
            curved |= dict(zip(map(str, symbols), row, strict=True))
    else:
        assert rolling_surface.curved is not None
        curved = dict(zip(map(str, rolling_series.bent), rolling_surface.curved, strict=True))
    if revolved:
        curved |= _revolved(rolling_surface)
    kernels = {
        "distance": loop_kernel(
            f"{name}_distance",
            {"gap": surface.own_distance},
            "Distance from the surface.",
            "Table 2",
        ),
        "rolling_surface": loop_kernel(
            f"{name}_rolling_surface",
            curved | {"per_reach": rolling_surface.per_reach},
            "Curvature of the surface that the centre of a rolling ball stays on.",
            "Table 2",
        ),
        "turning": loop_kernel(
            f"{name}_turning",
            {str(rate): barrier(directional(component, turns)) for rate, component in named},
            "Rate of the normal.",
            "derivative of Table 2's normal",
        ),
        "separation": loop_kernel(
            f"{name}_separation",
            dict(zip(("lift", "gap_jerk", "gap_snap"), derivatives[2:], strict=True)),
            "Second to fourth derivative of the distance along a flight.",
            "derivatives of Table 2's distance",
        ),
    }
    if (about := rolling_surface.revolved) is not None:
        away = (rolling_series.per_width, *rolling_series.outward)
        kernels["width"] = loop_kernel(
            f"{name}_width",
            dict(zip(map(str, away), (about.per_width, *about.outward), strict=True)),
            "Inverse distance of the ball from the axis of the surface, and the direction from it.",
            "Table 2",
        )
    seams = {
        f"seam{k}": loop_kernel(
            f"{name}_seam{k}",
            {"gap": barrier(place - value), "nearing": directional(place, along), "near": width},
            "Distance of the ball from a seam of the surface, its rate, and half the seam's width.",
            "Table 2",
        )
        for k, (place, value, width) in enumerate(rolling_surface.seams)
    }
    return kernels | seams


def _revolved(rolling_surface: RollingSurface) -> dict[str, sp.Expr]:
    """Return the numbers of a cone or a torus for its series: zeros for any other surface."""
    names, about = list(map(str, rolling_series.REVOLVED)), rolling_surface.revolved
    if about is None:
        return dict.fromkeys(names, sp.Integer(0))
    own = (*about.axis, *about.outward, about.per_width, about.per_tube, about.azimuth_factor)
    return dict(zip(names, own, strict=True))


def _hold_all_parts(expression: sp.Expr) -> sp.Expr:
    """Return the expression with its sums and powers held, so that its derivatives share them."""
    if expression.is_Atom:
        return expression
    inner = expression.func(*map(_hold_all_parts, expression.args))
    return barrier(inner) if inner.is_Add or inner.is_Pow else inner
