"""The frames of contacts with surfaces, their curvatures, and how exact a contact is there.

Each surface has the numbers with which `contact_frames` bounds errors: the horizontal tangent e,
the curvatures 1/R and 1/ρ along s and e, and bounds on the curvature within the errors, on how far
a flight is off the surface at its computed root, and on the rounding of the normal.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..motion.parabola import Parabola
from ..surfaces import Box, Plane, Ring, Surface
from ..symbolic.conditionals import (
    Choose,
    IfAtMost,
    IfLess,
    Less,
    absolute,
    all_of,
    barrier,
    maximum,
    minimum,
)
from ..symbolic.rounding import is_input, rounding
from ..symbolic.symbols import POSITION, UNIT_ROUNDOFF, normal, position, t, velocity
from .contact_frames import (
    BENDS,
    BOUNDS,
    FLOOR,
    TANGENT,
    back,
    flight_roundings,
    means,
    normal_rounding,
    normal_velocity,
    root_level,
    root_offset,
    sharpest_bend,
)

SEAM_SHARE = 50
"""Half of one over the largest share of the curvature's radius that errors may make
(`second_order`): the ball is off the surface by as much again."""

SEAM_ROUNDING = sp.Rational(1, 2**20)
"""Roundings of a distance from a face in single precision, of the sizes of the faces' places."""


def tangents(surface: Surface, flight: Parabola) -> dict[str, sp.Expr]:
    """Return the frame of a contact with a surface, its curvatures, and the roundings there.

    Parameters
    ----------
    surface
        A ring about the vertical axis, a plane across an axis, or a box along the axes.
    flight
        The motion between contacts.

    Raises
    ------
    TypeError
        If it is another surface.
    """
    if isinstance(surface, Plane):
        values = _of_plane(surface, flight)
    elif isinstance(surface, Ring):
        values = _of_ring(surface, flight)
    elif isinstance(surface, Box):
        values = _of_box(surface, flight)
    else:
        raise TypeError(
            f"expected a ring, a plane across an axis or a box along the axes, got {surface.name}"
        )
    names = (*TANGENT, *BENDS, sharpest_bend, root_offset, root_level, normal_rounding)
    return {s.name: sp.sympify(value) for s, value in zip(names, values, strict=True)}


def _of_plane(surface: Plane, flight: Parabola) -> Sequence[sp.Expr | int]:
    """Return the numbers of a contact with a plane.

    The root is off by u (|X| + |c| + max(0, -2 c) + k V t)/V, with the gap c at the start, k <= 4
    and V the speed towards the plane; |c| is the mean speed times t.
    """
    axis = next(k for k, d in enumerate(surface.direction) if d)
    along = barrier(absolute(velocity[axis]) + absolute(means(flight)[axis])) * t
    off = barrier(UNIT_ROUNDOFF * barrier(absolute(position[axis]) + 4 * along) + FLOOR)
    return (*((1, 0) if axis == 1 else (0, 1)), *(0, 0, 0), off, off, 0)


def _of_ring(surface: Ring, flight: Parabola) -> Sequence[sp.Expr | int]:
    """Return the numbers of a contact with the ring.

    The roundings of F are at most u (4 ρ |d| + 2 d² + 5 R²) + 2 |d| p_ρ + 2 |z| p_z
    (`tests/derive/errors/test_ring_condition.py`). On a return F is less its value at the start.
    With ℓ the length of the path, p a bound on the roundings of a place, and |d|, |d_0| <= R,
    (ρ + ρ_0) ℓ >= |ρ² - ρ_0²|, ρ_0/(ρ + ρ_0) <= (R_H + R)/(2 R_H) <= 5/6, the terms there add up to
    at most 2 R (u (16 + 2 R_H/R) ℓ + 3/2 K p ℓ). Newton's method leaves 9/8 of these roundings, or
    2^-49 F'²/C <= 2^-48 R² V²/v² (`events/ring/double.py`), and its last step u t of the time. The
    distance is F/(2 R).

    A search takes F less its value at the start where the margin of F/t times t is less than that
    of F (`events/predicates.py`). With V_T the speed at the end T of its windows that is so if
    V_T t <= min(R, R_H - R)/4: its terms are then at most three quarters of those of the latter,
    in either precision. There |z| <= R, so g T <= 2 max(0, vz) + 2 sqrt(g R) with vz at the start.
    On a longer return either may be taken, and F itself is off by the level of the start besides.
    """
    places, _ = flight_roundings(flight)
    path = _path(flight)
    x, y, _ = POSITION
    rho, reach = barrier(surface.rho), barrier(surface.reach)
    per_rho, per_reach = barrier(1 / rho), barrier(1 / reach)
    wide = barrier(surface.ring_radius * per_reach)
    rounded = barrier(sum(absolute(n) * r for n, r in zip(normal, places, strict=True)))
    again = barrier(
        UNIT_ROUNDOFF * barrier(16 + 2 * wide) * path
        + barrier(sp.Rational(3, 2) * barrier(sum(places)) * path) * surface.curvature
    )
    once = barrier(UNIT_ROUNDOFF * barrier(2 * rho + sp.Rational(7, 2) * reach) + rounded)
    again, once = _with_newton_residue((again, once), reach)
    begun = barrier(sum(map(absolute, velocity)) + flight.strength * t)
    rising = maximum(0, barrier(velocity[2] + flight.strength * t))
    half_gain = barrier(rising + barrier(sp.sqrt(flight.strength * reach)))
    swept = barrier(begun + 2 * half_gain) * t
    short = 4 * barrier(swept * surface.curvature)
    kept = barrier(BOUNDS[0] + again)
    pairs = zip((again, kept), _of_either_form(again, once), strict=True)
    returns = [IfAtMost(short, 1, one, either) for one, either in pairs]
    return (
        *(-y * per_rho, x * per_rho, per_reach, per_rho, surface.curvature),
        *(IfLess(0, back, on_return, once) for on_return in returns),
        UNIT_ROUNDOFF * barrier(2 * wide + 7),
    )


def _of_box(surface: Box, flight: Parabola) -> Sequence[sp.Expr | int]:
    """Return the numbers of a contact with a box along the axes.

    Around a face the normals are those of an axis, around an edge those of a cylinder, and around a
    corner those of a sphere, all with the radius R_B. e is horizontal, along an edge that is level
    and around one that is vertical, and s = e × n. At an edge along x or y the frame turns about
    e, by 1/R_B; at a vertical one about z, by 1/R_B; at a corner about e by 1/R_B, and about z by
    1/ρ = 1/(R_B h), with h for the horizontal part of the normal. K is the largest of 1/R_B and
    1/ρ, so that |Ω q| <= K |q|, as e and z are perpendicular.

    **Lemma (seams).** The bound K on the curvature also is at least 1/(50 d), with the distance d
    of the computed place from the nearest plane that a face lies in. So, where K Q <= 1/100
    (`second_order`), each e is zero all over the ball of radius Q about the nearest place on the
    surface, or nowhere in it, and G there is the distance from a plane, a line or a point less R_B,
    with derivatives as `second_order` asks. The true ball is in it at the contact, and departs
    there.

    *Proof.* Q <= d/2, and that place is no further from the computed one than Q. As computed d is
    less by 2^-20 of the faces' places, 16 units of single precision, of which place and difference
    have two. From a line or a point the distance r has DDG with the eigenvalues 0 and 1/r, and
    DDDG(u, u) = -(τ² n + 2 u_n τ)/r², with the part τ of u across n: at most 1.16/r², and r >= R_B
    - Q. The true ball meets the surface within Q ("delay"). ∎

    Where d is no larger than its rounding, K is infinite, and so are all bounds.

    The roundings of F = Σ e² - R_B² are 2 Σ |e| (p + q), with p those of the place and q = u |e|
    those of e, the difference of the place and a face, which is an input of the scene; of a sum of
    two, as in `COURT`, q has that rounding, too. There are at most 8 u R_B² of its squares and
    sums. At the start, too, q is at most u R_B, which Σ q is at least. On a return F less its value
    at the start is a sum of products t m (e + e_0) with the mean velocity m, or of e² - e_0² with
    |e|, |e_0| <= |m| t: as |e|, |e_0| <= R_B but for 2^-14, these add up to at most 2 (ℓ (p + 2 q)
    + 6 u R_B ℓ), ℓ the length of the path. Newton's method leaves 9/8 of the roundings, or 2^-49
    F'²/C with C >= 6 v², and u t of the time. On a return either form may be taken. The distance is
    F/(2 R_B). A product is off by |m| t (p + 2 q), and its m, sum and two products by 5 u 2 R_B ℓ;
    a difference of squares by 2 |m| t (p + 2 q) and 3 u R_B ℓ. Two sums follow. At both ends e is
    zero as computed if and only if it is, by "seams".

    The normal is e over its length, and so of the length 1; where e is zero, so is it. It is off by
    Σ q/R_B, and by 4 u of squares, sums, root and division.
    """
    places, _ = flight_roundings(flight)
    radius = barrier(surface.radius)
    per_radius = barrier(1 / radius)
    excess = surface.excess
    beside = []
    for e, (_, *sides) in zip(excess, surface.faces, strict=True):
        sums = (rounding(side, {}).error for side in sides if not is_input(side))
        beside.append(barrier(UNIT_ROUNDOFF * absolute(e) + sp.Add(*sums)))
    bent_x, bent_y, bent_z = (Less(0, absolute(e)) for e in excess)
    nx, ny, _ = normal
    horizontal = barrier(sp.sqrt(barrier(nx**2 + ny**2)))
    tilted = Less(0, horizontal)
    per_horizontal = barrier(1 / horizontal)
    around = barrier(per_radius * per_horizontal)
    bends = (
        Choose(all_of(bent_z, tilted), per_radius, 0),
        Choose(all_of(bent_x, bent_y), around, 0),
    )
    nearest = barrier(minimum(*surface.ways_to_seams))
    blurred = barrier(
        SEAM_ROUNDING
        * barrier(sp.Add(*(rounding(side, {}).magnitude for side in (*surface.low, *surface.high))))
    )
    apart = barrier(nearest - blurred)
    sharpest = IfLess(
        0, apart, maximum(per_radius, bends[1], barrier(1 / barrier(SEAM_SHARE * apart))), sp.oo
    )
    own = [barrier(p + 2 * q) for p, q in zip(places, beside, strict=True)]
    rounded = barrier(sum(absolute(n) * r for n, r in zip(normal, own, strict=True)))
    path = _path(flight)
    once = barrier(rounded + 8 * UNIT_ROUNDOFF * radius)
    again = barrier(barrier(sum(own)) * path * per_radius + 12 * UNIT_ROUNDOFF * path)
    again, once = _with_newton_residue((again, once), radius)
    return (
        Choose(tilted, -ny * per_horizontal, 0),
        Choose(tilted, nx * per_horizontal, 1),
        *bends,
        sharpest,
        *(IfLess(0, back, on_return, once) for on_return in _of_either_form(again, once)),
        barrier(2 * barrier(sum(beside)) * per_radius + 8 * UNIT_ROUNDOFF),
    )


def _with_newton_residue(roundings: Sequence[sp.Expr], radius: sp.Expr) -> list[sp.Expr]:
    """Return the distances of computed roots from a surface, given the roundings of its distance.

    Newton's method leaves 9/8 of the roundings, or 2^-49 F'²/C, and u t of the time.
    """
    steep = barrier(normal_velocity**2 / barrier(sum(v**2 for v in velocity)))
    moved = barrier(UNIT_ROUNDOFF * barrier(absolute(normal_velocity) * t) + FLOOR)
    residue = barrier(16 * UNIT_ROUNDOFF * barrier(radius * steep))
    return [
        barrier(rounded + maximum(sp.Rational(9, 8) * rounded, residue) + moved)
        for rounded in roundings
    ]


def _of_either_form(again: sp.Expr, once: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return A_F and the level on a return of which F, or F less its start, may be taken.

    Parameters
    ----------
    again, once
        How far the root is off the level of the start, and off the surface.
    """
    level = BOUNDS[0]
    return maximum(again, barrier(once + level)), maximum(barrier(level + again), once)


def _path(flight: Parabola) -> sp.Expr:
    """Return a bound on the length of a flight of time t, given the velocity at its end."""
    return barrier(sum(map(absolute, velocity)) * t + flight.strength * t**2)
