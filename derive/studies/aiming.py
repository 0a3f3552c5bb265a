"""Aiming: the flights from a place through a wanted point, in closed form.

Eq. 3 without its time: with the slope s (the tangent of the angle of release) and the speed v, the
ball has risen by

    h = L s - g L² (1 + s²) / (2 v²)

when it has come the horizontal distance L. Solved for v, for s, and for the s of the least v.
"""

from __future__ import annotations

import sympy as sp

from ..ground.choice import IfLess, hold

slope = sp.Symbol("slope", real=True)
"""s, tangent of the angle of release above the horizontal."""
entry = sp.Symbol("entry", real=True)
"""Tangent of the angle below the horizontal at the point."""
release_speed = sp.Symbol("release_speed", positive=True)
"""v, m/s."""
reach = sp.Symbol("reach", positive=True)
"""L, horizontal distance to the point, m."""
rise = sp.Symbol("rise", real=True)
"""h, height of the point above the release, m."""

ARGUMENTS = (slope, entry, release_speed, reach, rise)


def risen(gravity: sp.Expr) -> sp.Expr:
    """Return h after the horizontal distance L: Eq. 3 with t = L / (v cos(angle))."""
    return reach * slope - gravity * reach**2 * (1 + slope**2) / (2 * release_speed**2)


def aimed_speed(gravity: sp.Expr) -> dict[str, sp.Expr]:
    """Return the speed through the point: v² = g L² (1 + s²) / (2 (L s - h)).

    Not a number where the point lies above the line of release; infinite where it lies on it.
    """
    over = hold(reach * slope - rise)
    return {"speed": reach * sp.sqrt(hold(gravity * (1 + slope**2) / (2 * over)))}


def entry_slope() -> dict[str, sp.Expr]:
    """Return the slope at the point: s - 2 h/L, positive on the way down."""
    return {"entry": slope - 2 * rise / reach}


def slope_of_entry() -> dict[str, sp.Expr]:
    """Return the slope of release that has the slope `entry` at the point."""
    return {"slope": entry + 2 * rise / reach}


def _least() -> tuple[sp.Expr, sp.Expr]:
    """Return h + sqrt(h² + L²), and that over L.

    Where h is negative the sum cancels; it is L² / (sqrt(h² + L²) - h), too.
    """
    distance = hold(sp.sqrt(hold(rise**2 + reach**2)))
    above, below = hold(rise + distance), hold(distance - rise)
    return (
        hold(IfLess(rise, 0, reach**2 / below, above)),
        IfLess(rise, 0, reach / below, above / reach),
    )


def least_speed(gravity: sp.Expr) -> dict[str, sp.Expr]:
    """Return the slope and the speed of the slowest release through the point.

    The angle is 45° + atan(h/L)/2, and v² = g (h + sqrt(h² + L²)).
    """
    height, slowest = _least()
    return {"slope": slowest, "speed": sp.sqrt(hold(gravity * height))}


def slopes_of_speed(gravity: sp.Expr) -> dict[str, sp.Expr]:
    """Return the two slopes through the point at a speed; not numbers if it is too slow.

    The roots of g L² s² - 2 L v² s + (g L² + 2 h v²) = 0: the sum of the high one does not cancel,
    and the low one follows from their product. A quarter of the discriminant over L² is
    v⁴ - 2 g h v² - g² L², factored into v² less either of g (h ± sqrt(h² + L²)).
    """
    square = hold(release_speed**2)
    height, _ = _least()
    spare = hold(square - hold(gravity * height))
    other = hold(square + gravity * hold(sp.sqrt(hold(rise**2 + reach**2)) - rise))
    steep = hold(square + sp.sqrt(hold(spare * other)))
    fall = hold(gravity * reach)
    return {
        "low": hold(fall * reach + 2 * rise * square) / hold(reach * steep),
        "high": steep / fall,
    }
