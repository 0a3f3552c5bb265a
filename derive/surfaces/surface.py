"""The interface of a surface that the ball can touch (Table 2): distance, bounds, normal.

A surface is given for the ball's *centre*: its distance is zero when the ball touches, positive
outside. The same distance, made polynomial, becomes the constraint polynomial
(`events/event_polynomials.py`).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, field

import sympy as sp

from ..symbolic.conditionals import absolute, barrier, release
from ..symbolic.symbols import POSITION
from .contact_bounds import ContactBounds, ContactPath, at_contact
from .rolling_surface import RollingSurface

Point = tuple[sp.Expr, sp.Expr, sp.Expr]

_ORIGIN = (sp.Integer(0), sp.Integer(0), sp.Integer(0))


def translated(shape: sp.Expr, centre: Point) -> sp.Expr:
    """Return a formula in x, y, z as one of the position relative to a centre.

    Parameters
    ----------
    shape
        The formula.
    centre
        The centre, (3,), m.
    """
    offsets = (place - own for place, own in zip(POSITION, centre, strict=True))
    return shape.xreplace(dict(zip(POSITION, offsets, strict=True)))


def overlap(
    distance: sp.Expr, limits: Sequence[sp.Expr], reach: sp.Expr | None
) -> tuple[sp.Expr, ...]:
    """Return expressions that are all negative if a ball overlaps a surface within its bounds.

    With a reach the surface is thin, and there is free space behind it; else all behind it is body.

    Parameters
    ----------
    distance
        The distance of the ball's surface from the surface, m; negative inside.
    limits
        The bounds g of Eq. 2 as lengths, which are negative within the surface's edges.
    reach
        The ball's radius where the surface is thin, m; else None.
    """
    behind = () if reach is None else (-distance - 2 * reach,)
    return (distance, *behind, *limits)


@dataclass(frozen=True)
class Surface(ABC):
    """A stationary surface.

    Attributes
    ----------
    name
        Its name in results and in the names of its kernels.
    contact_bounds
        Bounds (Eq. 2) of the point of contact where that is no linear map of the ball's centre;
        None if there are none. Other bounds are those of the ball's centre, its `limits`.
    """

    name: str
    contact_bounds: ContactBounds | None = field(default=None, kw_only=True)

    @property
    @abstractmethod
    def distance(self) -> sp.Expr:
        """Signed distance (m) from the ball to the surface, positive outside."""

    @property
    @abstractmethod
    def condition(self) -> sp.Expr:
        """Polynomial in x, y, z that is zero at a contact and positive outside."""

    @property
    def polynomial(self) -> bool:
        """True if the condition is one polynomial; False if each of several parts has one."""
        return True

    @property
    def reference_point(self) -> Point:
        """A point near which the coefficients of the shape are small; by default the origin."""
        return _ORIGIN

    @property
    def shape(self) -> sp.Expr:
        """The condition in x, y, z relative to the reference point."""
        return self.condition

    @property
    def small_parts(self) -> tuple[sp.Expr, ...]:
        """Held sums in the shape that are much less at a contact than their terms may be."""
        return ()

    @property
    def half_sizes(self) -> tuple[sp.Expr | None, ...]:
        """Half sizes of a box about the reference point that holds every contact; None: unknown."""
        return (None, None, None)

    @property
    def enclosed(self) -> bool:
        """True if the box holds all of the body.

        Then some expression of `inside` is at least the distance from the box, or half of
        `steepness` times that distance.
        """
        return False

    def aside(self, axis: int) -> tuple[sp.Expr, ...]:
        """Distances along an axis: if one is positive, the ball is that far from overlapping."""
        place, half = POSITION[axis], self.half_sizes[axis]
        if self.enclosed and half is not None:
            return (
                barrier(absolute(barrier(place - barrier(self.reference_point[axis]))))
                - barrier(half),
            )
        alone = (d for d in self.inside if d.free_symbols & set(POSITION) == {place})
        return tuple(alone) if self.steepness == 1 else ()

    def beyond(self, axis: int, side: int) -> tuple[sp.Expr, ...]:
        """Distances that grow along an axis, to one side: if one is positive, the ball is past.

        A ball that is past the surface, and moves on to that side, never touches it.

        Parameters
        ----------
        axis
            The number of the coordinate axis, 0 to 2.
        side
            1 for the side of larger coordinates, -1 for the other.
        """
        place, half = POSITION[axis], self.half_sizes[axis]
        if self.enclosed and half is not None:
            return (side * barrier(place - barrier(self.reference_point[axis])) - barrier(half),)
        lengths = self.inside if self.steepness == 1 else ()
        return tuple(d for d in lengths if sp.diff(release(d), place) == side)

    @property
    def cuts(self) -> tuple[sp.Expr, ...]:
        """The bounds of the point of contact as bounds of the ball's centre, as lengths."""
        given = self.contact_bounds
        return () if given is None else at_contact(given.polynomials, self, given.ball_radius)

    @property
    def contact_path(self) -> ContactPath | None:
        """The point of contact of a ball that is on the surface or beside it.

        None where a ball rolls on no such surface with `contact_bounds`.
        """
        return None

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The g of Eq. 2: a contact counts only if none is positive."""
        return self.cuts

    @property
    def images(self) -> tuple[sp.Expr, ...]:
        """Bounds past which the condition is zero on what is no part of the surface."""
        return ()

    @property
    def patches(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """The bounds by part: a contact counts if all bounds of any one part hold."""
        return (self.bounds,)

    @property
    @abstractmethod
    def normal(self) -> sp.Matrix:
        """Outward unit normal n3 at a contact, the gradient of the distance there."""

    @property
    def curvature(self) -> sp.Expr:
        """Bound on the rate (1/m) at which the normal turns along the contact surface."""
        return sp.Integer(0)

    def nearest_point(self, ball_radius: sp.Expr) -> list[sp.Expr]:
        """Return the point of the body that a ball touches, each coordinate held.

        Parameters
        ----------
        ball_radius
            R_B, m.
        """
        return [
            barrier(place - barrier(ball_radius * component))
            for place, component in zip(POSITION, self.normal, strict=True)
        ]

    def curvature_within(self, reach: Sequence[sp.Expr]) -> sp.Expr:
        """Return a bound on that rate along the part of the surface that is near the ball's place.

        Parameters
        ----------
        reach
            How far that part extends along each axis from the ball's centre on the surface, m.
        """
        del reach
        return self.curvature

    @property
    def rolling_surface(self) -> RollingSurface | None:
        """The surface under a ball that stays in contact; None: rolling is not supported."""
        return None

    @property
    def rolling_surface_across_gravity(self) -> RollingSurface | None:
        """The same where gravity does not act along -z, and coordinates of a ring are no use."""
        return self.rolling_surface

    def surface_below(self, upright: bool) -> RollingSurface | None:
        """Return the surface that the centre of a rolling ball stays on; None: it bounces on.

        Parameters
        ----------
        upright
            True if gravity acts along -z.
        """
        return self.rolling_surface if upright else self.rolling_surface_across_gravity

    @property
    def own_distance(self) -> sp.Expr:
        """The distance as rolling balls need it: smooth about the whole of the surface."""
        return self.distance

    @property
    def distance_ahead(self) -> sp.Expr:
        """The distance where the ball moves to, where the surface changes its form at a seam."""
        return self.own_distance

    @property
    def max_concavity(self) -> sp.Expr:
        """Bound on the downward curvature of the distance (1/m); 0 if the body is convex."""
        return sp.Integer(0)

    @property
    def max_convexity(self) -> sp.Expr:
        """Bound on the upward curvature of the distance (1/m) down to half of that radius."""
        return sp.Integer(0)

    @property
    def distance_without_bounds(self) -> sp.Expr | None:
        """Distance from the surface without its bounds, if no box holds it; None: not known.

        It has a gradient of at most 1 everywhere.
        """
        return None

    @property
    def azimuth_free_distance(self) -> sp.Expr | None:
        """Bound below the distance from all points at this height and distance from the z axis.

        It is convex in these two; None: no such bound is known.
        """
        return None

    @property
    @abstractmethod
    def inside(self) -> tuple[sp.Expr, ...]:
        """Expressions that are all negative exactly if the ball overlaps the body."""

    @property
    def steepness(self) -> sp.Expr:
        """Bound on the gradient of `inside` near its zeros."""
        return sp.Integer(1)
