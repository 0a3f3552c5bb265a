"""The premises of the theorem about flags and bounds, decided from the release of a shot.

The lemmas of the search on a ring with the radii R_H and R need 3/2 R <= R_H <= 16 R, and flights
with |v|² <= 2^16 g R and |x| + T (|v| + g T) <= 2^16 R, where |x| and |v| are sums of sizes, and T
is the last time at which anything is asked of the flight.

**Lemma (premises).** Let a level plane at the height h end every flight that crosses it downwards.
Let the ball be released in flight and have N contacts, with the restitution e <= 1 and the inertia
κ. With S the sum of the sizes of h and of the scene's lengths, X that of the release's coordinates,
and U = |v|² + κ R_B² |w|² + 2 g (X + S) of the release in Euclid's norms, all flights are such ones
if X + S + (2 N + 12) U/g <= 2^16 R.

*Proof.* A contact without slip adds no energy, so |v|² <= U wherever the ball is above h, and each
flight reaches h, or ends before, within 2 sqrt(U)/g. Nothing is asked that is later by more than a
hundredth (`padded_horizon`), so T (|v| + g T) <= 2.02 sqrt(U)/g (sqrt(3 U) + 2.02 sqrt(U)) < 8 U/g.
With α the angle of its velocity at the start above the horizon, a flight takes the ball away by at
most cos α (sin α + 1) U/g < 1.3 U/g, which is a sum of two sizes below 2 U/g. In N contacts it
moves so N times, and it stays between -S and X + S + U/(2 g). So |x| <= X + S + (2 N + 1) U/g. ∎

Each condition is tested with 2^-20 of room, for roundings.
"""

from __future__ import annotations

import sympy as sp

from ..surfaces import Plane, Ring
from ..symbolic.conditionals import AtMost, absolute, all_of, barrier
from ..symbolic.error_terms import contacts
from ..symbolic.symbols import POSITION, SPIN, VELOCITY
from .scene import Scene

LARGEST = sp.Integer(2**16)
"""Largest size of a flight over R."""

NARROWEST, WIDEST = sp.Rational(3, 2), sp.Integer(16)
"""Smallest and largest R_H over R."""

ROOM = 1 + sp.Rational(1, 2**20)
"""Room for roundings."""


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
    if not (scene.proves_errors and floors and rings):
        return None
    ball, gravity = scene.ball, scene.flight.strength
    around = barrier(
        sp.Add(*map(absolute, POSITION))
        + sp.Add(*map(absolute, scene.lengths))
        + absolute(floors[0].offset)
    )
    spinning = barrier(ball.inertia * ball.radius**2) * barrier(sp.Add(*(w**2 for w in SPIN)))
    energy = barrier(sp.Add(*(v**2 for v in VELOCITY)) + spinning)
    height = barrier(energy / gravity + 2 * around)
    size = barrier(around + barrier(2 * contacts + 12) * height)
    conditions = [AtMost(law.restitution_at(sp.Integer(0)), 1) for law in scene.laws]
    for ring in rings:
        reach, radius = barrier(ring.reach), ring.ring_radius
        conditions += [
            AtMost(ROOM * size, LARGEST * reach),
            AtMost(NARROWEST * ROOM * reach, radius),
            AtMost(ROOM * radius, WIDEST * reach),
        ]
    return {"premised": all_of(*conditions)}
