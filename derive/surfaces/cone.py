"""A round cone, or the part of one within bounds, touched from outside or from inside.

The centre of a ball of radius R that touches a cone is on another cone: at the distance R from a
straight generator, across it. Its axis and its half-angle alpha are those of the cone itself, and
its apex is R/sin(alpha) from the cone's, against the axis outside and along it inside. With
k = tan(alpha) that is R sqrt(1 + k²)/k.

The ball touches a generator at the way h + R sin(alpha) along the axis if its centre is at h, both
from the cone's apex. Outside, a ball with h < -R sin(alpha) is nearest to the apex itself: there
its centre is on a sphere of radius R about the apex, which the cone of centres continues smoothly.
Inside, the apex of the centres' cone is where the ball touches all around: no closer to the cone's
apex can it come.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import IfLess, absolute, barrier
from ..symbolic.symbols import POSITION
from .about_axis import AboutAxis
from .bounds import as_length
from .contact_bounds import ContactPath, path_about_axis
from .directions import Direction, along, per_length, squared_distance
from .rolling_surface import RevolvedSurface, RollingSurface
from .surface import Point, overlap, translated
from .two_sided import TwoSided


@dataclass(frozen=True)
class Cone(AboutAxis, TwoSided):
    """One nappe of a cone, that to which its axis points.

    Outside, its `limits` exclude the region of the apex.

    With d from the apex of the centres' cone to the ball's centre, and the vector u along the axis,
    of length 1 or not, the ball touches where |d × u|² = k² (d·u)², on the side with d·u > 0.

    Attributes
    ----------
    apex
        The apex of the cone on which the ball's centre is at a contact.
    direction
        A vector along the axis from the apex into the cone, about of length 1.
    slope
        k, the tangent of the half-angle.
    """

    apex: Point
    direction: Direction
    slope: sp.Expr

    @property
    def _nappe(self) -> sp.Expr:
        """At most 0 on the side of the apex to which the axis points."""
        return -along(self.direction, self._offset)

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The bounds as lengths; the other nappe, on which the condition is zero, too, is none."""
        return (as_length(self._nappe), *self._ends)

    @property
    def _per_side(self) -> sp.Expr:
        """The cosine of the half-angle."""
        return barrier(1 / barrier(sp.sqrt(barrier(1 + self.slope**2))))

    def _away(self, height: sp.Expr) -> sp.Expr:
        return self._side * barrier(self._rho - self.slope * height) * self._per_side

    @property
    def distance(self) -> sp.Expr:
        """(rho - k |h|) cos(alpha), of the nearer nappe, or the negative of that from inside."""
        return self._away(barrier(absolute(self._height)))

    @property
    def reference_point(self) -> Point:
        """The apex of the centres' cone."""
        return self.apex

    @property
    def shape(self) -> sp.Expr:
        """|d × u|² - k² (d·u)², or the negative of that from inside."""
        width = squared_distance(self.direction, POSITION)
        height = along(self.direction, POSITION)
        return self._side * width - self._side * self.slope**2 * height**2

    @property
    def condition(self) -> sp.Expr:
        """The shape, seen from the origin."""
        return translated(self.shape, self.apex)

    @property
    def normal(self) -> sp.Matrix:
        """cos(alpha) away from the axis, and sin(alpha) against it, or the negative of that."""
        back = self._back
        return sp.Matrix(self._away_from(IfLess(self._height, 0, -back, back)))

    @property
    def _back(self) -> sp.Expr:
        """The slope, for the direction as it is, of length 1 or not."""
        return barrier(self.slope * per_length(self.direction))

    def _away_from(self, back: sp.Expr) -> list[sp.Expr]:
        """Return the unit vector away from the axis, and so much against the direction."""
        parts = self._across
        per_rho = barrier(1 / barrier(sp.sqrt(barrier(sp.Add(*(part**2 for part in parts))))))
        scale = barrier(self._side * self._per_side)
        return [
            barrier(part * per_rho - u * back) * scale
            for part, u in zip(parts, self.direction, strict=True)
        ]

    def nearest_point(self, ball_radius: sp.Expr) -> list[sp.Expr]:
        """Return the point that the ball touches, by the normal of this nappe."""
        away = self._away_from(self._back)
        return [
            barrier(place - barrier(ball_radius * component))
            for place, component in zip(POSITION, away, strict=True)
        ]

    @property
    def contact_path(self) -> ContactPath | None:
        """The normal is cos(alpha) e and a constant."""
        if self.contact_bounds is None:
            return None
        radius = self.contact_bounds.ball_radius
        place, per_rho = self.nearest_point(radius), barrier(1 / self._rho)
        return path_about_axis(place, radius, sp.Integer(0), self._per_side, per_rho)

    @property
    def curvature(self) -> sp.Expr:
        """A bound on cos(alpha)/rho, around the axis, down to half of rho."""
        return 2 / self._rho

    @property
    def max_concavity(self) -> sp.Expr:
        """Zero outside; inside the bound on the curvature, from which the path gets at any rho."""
        return self.curvature if self.inward else sp.Integer(0)

    @property
    def max_convexity(self) -> sp.Expr:
        """The bound on the curvature outside; zero inside."""
        return sp.Integer(0) if self.inward else self.curvature

    @property
    def own_distance(self) -> sp.Expr:
        """The distance from this nappe alone, which is smooth but on the axis."""
        return self._away(self._height)

    @property
    def rolling_surface(self) -> RollingSurface | None:
        """The cone of the ball's centre."""
        zero, per_width = sp.Integer(0), barrier(1 / self._rho)
        x, y, z = (part * per_width for part in self._across)
        azimuth_factor = self._side * self._per_side
        cone = RevolvedSurface(self._axis, (x, y, z), per_width, zero, azimuth_factor)
        return RollingSurface((zero, zero, zero), self._side * per_width, revolved=cone)

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """The distance from this nappe, the thickness of a shell, and the bounds."""
        return overlap(self._away(self._height), self._ends, self.reach)
