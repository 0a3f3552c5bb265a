"""The premises of the theorem about flags and bounds, decided from the release of a shot.

The lemmas of the search on a ring with the radii R_H and R need 3/2 R <= R_H <= 16 R, and flights
with |v|² <= 2^16 g R and |x| + T (|v| + g T) <= 2^16 R, where |x| and |v| are sums of sizes, and T
is the last time at which anything is asked of the flight.

**Lemma (premises).** Let a level plane at the height h end every flight that crosses it downwards.
Let the ball be released in flight and have N contacts, with the restitution e <= 1 and the inertia
κ. With S the sum of the sizes of h and of the scene's lengths, X that of the release's coordinates,
and U = |v|² + κ R_B² |w|² + 2 g (X + S) of the release in Euclid's norms, all flights are such ones
if X + S + (2 N + 12) U/g <= 2^16 R, and if the ball is released above h, or comes to h upwards and
meets nothing before. Among boxes that sum also has to be at most 2^40 R_B (`events/box.py`).

It meets nothing before if it comes nearer to the axis until then and is there still further from
it than R_H + R of each ring, if it is on the same side of each vertical plane at the release and
there, if no level plane of a body is below h, and if each box, with the ball's radius about it, is
above h or on one side of both places along x or y.

*Proof.* Whoever is above h stays there until the shot ends: so all flights but the first begin
above h, and each flight comes to h downwards, or ends before. A contact adds no energy with -1 <=
e_t <= 1, so |v|² <= U, and a flight takes at most 2 sqrt(U)/g. Nothing is asked that is later by
more than a hundredth (`padded_horizon`), so that T (|v| + g T) <= 2.02 sqrt(U)/g (sqrt(3 U) + 2.02
sqrt(U)) < 8 U/g. With α the angle of its velocity at the start above the horizon, a flight takes
the ball away by at most cos α (sin α + 1) U/g < 1.3 U/g, which is a sum of two sizes below 2 U/g.
In N contacts it moves so N times, and it stays between -S and X + S + U/(2 g). So |x| <= X + S + (2
N + 1) U/g. Horizontally it flies straight, so it comes nearer to the axis until h if it does so
there, and what is on one side of both ends along x or y it does not meet. ∎

Each condition is tested with room for roundings: 2^-20 of the sizes compared, and where it is at h,
2^-20 of X + S + U/g. There vz² exceeds 2 g (h - z) by 2^-20 of itself, so that the time is off by
less than 2^-30 vz/g.
"""

from __future__ import annotations

import sympy as sp

from ..surfaces import Box, Plane, Ring
from ..symbolic.conditionals import (
    AtMost,
    Less,
    absolute,
    all_of,
    any_of,
    barrier,
    maximum,
    minimum,
)
from ..symbolic.error_terms import contacts
from ..symbolic.symbols import POSITION, SPIN, VELOCITY
from .scene import Scene

LARGEST = sp.Integer(2**16)
"""Largest size of a flight over R."""

LARGEST_BY_BALL = sp.Integer(2**40)
"""Largest size of a flight among boxes over R_B (`events/box.py`)."""

NARROWEST, WIDEST = sp.Rational(3, 2), sp.Integer(16)
"""Smallest and largest R_H over R."""

ROOM = sp.Rational(1, 2**20)
"""Room for roundings, a share of sizes."""


def premises(scene: Scene) -> dict[str, sp.Basic] | None:
    """Return the condition of the lemma, given a release in flight and how many contacts it has.

    Parameters
    ----------
    scene
        The scene.

    Returns
    -------
    dict or None
        None if its errors have no proved bounds, or if no level plane ends every shot.
    """
    floors = [
        plane
        for plane in scene.end_planes
        if isinstance(plane, Plane) and plane.direction == (0, 0, 1) and not plane.bounds
    ]
    rings = [surface for surface in scene.surfaces if isinstance(surface, Ring)]
    proves = scene.proves_errors or scene.proves_bounces
    if not (proves and floors and rings):
        return None
    ball, gravity, height = scene.ball, scene.flight.strength, barrier(floors[0].offset)
    around = barrier(
        sp.Add(*map(absolute, POSITION)) + sp.Add(*map(absolute, scene.lengths)) + absolute(height)
    )
    spinning = barrier(ball.inertia * ball.radius**2) * barrier(sp.Add(*(w**2 for w in SPIN)))
    energy = barrier(sp.Add(*(v**2 for v in VELOCITY)) + spinning)
    reach = barrier(energy / gravity + 2 * around)
    size = barrier(around + barrier(2 * contacts + 12) * reach)
    conditions = [AtMost(law.restitution_at(sp.Integer(0)), 1) for law in scene.laws]
    if any(isinstance(surface, Box) for surface in scene.surfaces):
        conditions.append(AtMost((1 + ROOM) * size, LARGEST_BY_BALL * ball.radius))
    for ring in rings:
        conditions += [
            AtMost((1 + ROOM) * size, LARGEST * ring.reach),
            AtMost((1 + ROOM) * NARROWEST * ring.reach, ring.ring_radius),
            AtMost((1 + ROOM) * ring.ring_radius, WIDEST * ring.reach),
        ]
    *_, z = POSITION
    above = AtMost(barrier(height + ROOM * around), z)
    conditions.append(any_of(above, _rises(scene, height, barrier(ROOM * barrier(around + reach)))))
    return {"holds": all_of(*conditions)}


def _rises(scene: Scene, height: sp.Expr, room: sp.Expr) -> sp.Basic:
    """Return whether the ball comes to a height upwards and meets nothing before.

    Parameters
    ----------
    scene
        A scene of rings, planes and boxes.
    height
        The height, m.
    room
        Room for roundings of the place there, m.
    """
    (x, y, z), (vx, vy, vz), gravity = POSITION, VELOCITY, scene.flight.strength
    squared = barrier(vz**2)
    left = barrier(squared - 2 * gravity * barrier(height - z))
    duration = barrier(barrier(vz - sp.sqrt(maximum(left, 0))) / gravity)
    there = dict(
        zip((x, y), (barrier(c + v * duration) for c, v in ((x, vx), (y, vy))), strict=True)
    )
    conditions = [
        Less(0, vz),
        AtMost(ROOM * squared, left),
        AtMost(
            barrier(there[x] * vx + there[y] * vy) + room * barrier(absolute(vx) + absolute(vy)), 0
        ),
    ]
    away = barrier(sp.sqrt(barrier(there[x] ** 2 + there[y] ** 2)))
    for surface in scene.surfaces:
        if isinstance(surface, Ring):
            conditions.append(Less(barrier(surface.ring_radius + surface.reach + room), away))
        elif isinstance(surface, Plane) and surface.direction[2]:
            level = barrier(surface.direction[2] * surface.offset)
            conditions.append(AtMost(barrier(height + room), level))
        elif isinstance(surface, Plane):
            axis = next(k for k, d in enumerate(surface.direction) if d)
            ends = (POSITION[axis], there[POSITION[axis]])
            gaps = [barrier(surface.direction[axis] * c - surface.offset) for c in ends]
            before = Less(room, barrier(minimum(*gaps)))
            conditions.append(any_of(before, Less(barrier(maximum(*gaps)), -room)))
        elif isinstance(surface, Box):
            lowest = barrier(surface.low[2] - surface.radius)
            passes = [AtMost(barrier(height + room), lowest)]
            for place, low, high in surface.faces[:2]:
                ends = (place, there[place])
                passes.append(Less(barrier(high + surface.radius + room), barrier(minimum(*ends))))
                passes.append(Less(barrier(maximum(*ends)), barrier(low - surface.radius - room)))
            conditions.append(any_of(*passes))
    return all_of(*conditions)
