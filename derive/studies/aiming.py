"""Aiming: the flights from a place through a wanted point, in closed form.

Eq. 3 without its time: with the slope s (the tangent of the angle of release) and the speed v, the
ball has risen by

    h = L s - g L² (1 + s²) / (2 v²)

after the horizontal distance L. The kernels solve this for v, for s, and for the s of the least v.
"""

from __future__ import annotations

import sympy as sp

from ..symbolic.conditionals import IfLess, barrier

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


def aimed_speed(gravity: sp.Expr) -> dict[str, sp.Expr]:
    """Return the speed through the point: v² = g L² (1 + s²) / (2 (L s - h)).

    It is NaN if the point lies above the line of release, and infinite if it lies on it.
    """
    over = barrier(reach * slope - rise)
    return {"speed": reach * sp.sqrt(barrier(gravity * (1 + slope**2) / (2 * over)))}


def entry_slope() -> dict[str, sp.Expr]:
    """Return the slope at the point: s - 2 h/L, positive on the way down."""
    return {"entry": slope - 2 * rise / reach}


def slope_of_entry() -> dict[str, sp.Expr]:
    """Return the slope of release with the slope `entry` at the point."""
    return {"slope": entry + 2 * rise / reach}


def _least() -> tuple[sp.Expr, sp.Expr]:
    """Return h + sqrt(h² + L²), and that over L.

    For a negative h the sum cancels; it equals L² / (sqrt(h² + L²) - h).
    """
    distance = barrier(sp.sqrt(barrier(rise**2 + reach**2)))
    above, below = barrier(rise + distance), barrier(distance - rise)
    return (
        barrier(IfLess(rise, 0, reach**2 / below, above)),
        IfLess(rise, 0, reach / below, above / reach),
    )


def least_speed(gravity: sp.Expr) -> dict[str, sp.Expr]:
    """Return the slope and the speed of the slowest release through the point.

    The angle is 45° + atan(h/L)/2, and v² = g (h + sqrt(h² + L²)).
    """
    height, slowest = _least()
    return {"slope": slowest, "speed": sp.sqrt(barrier(gravity * height))}


def slopes_of_speed(gravity: sp.Expr) -> dict[str, sp.Expr]:
    """Return the two slopes through the point at a speed; NaN if it is too slow.

    The roots of g L² s² - 2 L v² s + (g L² + 2 h v²) = 0: the sum of the high one does not cancel,
    and the low one follows from their product. A quarter of the discriminant over L² is
    v⁴ - 2 g h v² - g² L², factored into v² less either of g (h ± sqrt(h² + L²)).
    """
    square = barrier(release_speed**2)
    height, _ = _least()
    spare = barrier(square - barrier(gravity * height))
    other = barrier(square + gravity * barrier(sp.sqrt(barrier(rise**2 + reach**2)) - rise))
    steep = barrier(square + sp.sqrt(barrier(spare * other)))
    fall = barrier(gravity * reach)
    return {
        "low": barrier(fall * reach + 2 * rise * square) / barrier(reach * steep),
        "high": steep / fall,
    }
