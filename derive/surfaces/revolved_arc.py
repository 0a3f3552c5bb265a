"""A circular arc turned about an axis: a part of a torus, touched from either side of the arc.

In the half-plane of the distance rho from the axis and the height h, the centre of a ball of radius
R that touches an arc of radius s is at the distance r from the arc's centre: s + R on the round
side, s - R on the hollow one. With the arc's centre at rho = a, h = 0,

    (rho - a)² + h² = r².

The centre may be beyond the axis, with a negative a: then the arc sweeps a lemon. Free of the root
in rho the condition is F = p² - 4 a² rho² with p = rho² + h² + a² - r². It is zero on the mirror
image of the circle, too, on which (rho + a)² + h² = r². The two differ in the sign of p, which is
2 a rho on the circle and -2 a rho on its image.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import barrier
from ..symbolic.symbols import POSITION
from .about_axis import AboutAxis
from .bounds import as_length
from .directions import Direction, per_length, squared_distance, squared_length
from .surface import Point, translated
from .two_sided import TwoSided


@dataclass(frozen=True)
class RevolvedArc(AboutAxis, TwoSided):
    """The surface that an arc sweeps, of which the centre is not on the axis.

    With d from `centre` to the ball's centre and the vector u along the axis, of length 1 or not,
    the ball touches where |u|² (d² + a² - r²)² = 4 a² |d × u|².

    Attributes
    ----------
    centre
        The point of the axis at the height of the arc's centre.
    direction
        A vector along the axis, about of length 1.
    offset
        a, the distance of the arc's centre from the axis; negative if the arc is on the other side
        of the axis.
    offset_sign
        The sign of a, 1 or -1.
    radius
        r, the distance from the arc's centre to the ball's centre at a contact: the sum of the
        radii of arc and ball, or, on the hollow side, their difference.
    meets_axis
        False if r is certainly less than |a|, so that the mirror image of the circle is not at
        positive rho.
    """

    centre: Point
    direction: Direction
    offset: sp.Expr
    offset_sign: int
    radius: sp.Expr
    meets_axis: bool = True

    @property
    def images(self) -> tuple[sp.Expr, ...]:
        """At most 0 on the circle itself, and positive on its mirror image; a length."""
        if not self.meets_axis:
            return ()
        squared = sp.Add(*(part**2 for part in self._offset))
        own = -self.offset_sign * (squared + (self.offset**2 - self.radius**2))
        return (as_length(own),)

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The bounds as lengths; the circle's mirror image is no part of the surface."""
        return (*self.images, *self._ends)

    @property
    def distance(self) -> sp.Expr:
        """sqrt((rho - a)² + h²) - r, or the negative of that on the hollow side."""
        depth = barrier(self._rho - self.offset)
        away = sp.sqrt(barrier(depth**2 + self._height**2))
        return self._side * away - self._side * self.radius

    @property
    def reference_point(self) -> Point:
        """The point of the axis at the height of the arc's centre."""
        return self.centre

    @property
    def small_parts(self) -> tuple[sp.Expr, ...]:
        """d² + a² - r², of the size 2 |a| rho at a contact."""
        return (barrier(sp.Add(*(c**2 for c in POSITION), self.offset**2 - self.radius**2)),)

    @property
    def shape(self) -> sp.Expr:
        """|u|² (d² + a² - r²)² - 4 a² |d × u|², which rises with the distance if a is positive."""
        (squared,) = self.small_parts
        wide = squared_distance(self.direction, POSITION)
        way = self._side * self.offset_sign
        return way * squared_length(self.direction) * squared**2 - 4 * way * self.offset**2 * wide

    @property
    def condition(self) -> sp.Expr:
        """The shape, seen from the origin."""
        return translated(self.shape, self.centre)

    @property
    def half_sizes(self) -> tuple[sp.Expr | None, ...]:
        """|a| + r across the axis, r along it; |a| + r throughout if the axis is oblique.

        Where the condition is zero outside of the arc's own circle is in this box, too.
        """
        widest = self.offset_sign * self.offset + self.radius
        return tuple(
            self.radius if u.is_Integer and abs(u) == 1 else widest
            for u in map(sp.sympify, self.direction)
        )

    @property
    def enclosed(self) -> bool:
        """True if the ball is on the round side."""
        return not self.inward

    @property
    def normal(self) -> sp.Matrix:
        """The direction from the nearest point of the circle of the arc's centre, or against it."""
        per_radius, rho = barrier(self._side / self.radius), barrier(self._rho)
        outward = barrier(barrier(rho - self.offset) * per_radius * barrier(1 / rho))
        up = barrier(barrier(self._height * per_length(self.direction)) * per_radius)
        parts = zip(self._across, self.direction, strict=True)
        return sp.Matrix([c * outward + u * up for c, u in parts])

    @property
    def curvature(self) -> sp.Expr:
        """A bound on 1/r around the arc's centre and |rho - a|/(rho r) around the axis."""
        return 1 / self._rho + 1 / self.radius

    @property
    def max_concavity(self) -> sp.Expr:
        """Twice the bound on the curvature: down to half of rho and of r."""
        return 2 * self.curvature
