"""A box: faces, edges and corners as one surface with a smooth distance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import sympy as sp

from ..symbolic.conditionals import (
    And,
    Choose,
    IfLess,
    Less,
    Or,
    absolute,
    barrier,
    maximum,
    minimum,
)
from ..symbolic.symbols import POSITION, VELOCITY
from .contact_bounds import ContactPath
from .rolling_surface import RollingSurface
from .surface import Point, Surface, overlap


@dataclass(frozen=True)
class Box(Surface):
    """A box along the axes, touched from outside.

    Seen from the ball's centre it is a box with round edges and corners. The squared distance from
    the box less R_B² is a polynomial on each of 27 parts, which differ in the coordinates that are
    beyond a face. At the seams it is continuous, and so is its gradient; no seam is ever undecided.

    Attributes
    ----------
    low, high
        Its corners with the smallest and the largest coordinates.
    radius
        R_B.
    plate_axis
        Of a plate, the axis across its large faces: 0, 1 or 2. A flight that comes near their
        planes mostly comes near the plate. No result depends on it. None of any other box.
    """

    low: Point
    high: Point
    radius: sp.Expr
    plate_axis: int | None = field(default=None, kw_only=True)

    @property
    def polynomial(self) -> bool:
        """False: each part has a polynomial of its own."""
        return False

    @property
    def faces(self) -> list[tuple[sp.Expr, sp.Expr, sp.Expr]]:
        """Each coordinate of the ball's centre, and those of the two faces across it."""
        return list(zip(POSITION, self.low, self.high, strict=True))

    @property
    def scaled_radius(self) -> sp.Expr:
        """R_B in the unit of length of `faces`."""
        return self.radius

    def turned(self, vector: Sequence[sp.Expr]) -> list[sp.Expr]:
        """Return the components of a vector along the box's axes, in the unit of `faces`."""
        return list(vector)

    @property
    def excess(self) -> list[sp.Expr]:
        """Distance of each coordinate beyond a face, negative beyond the lower one."""
        return [
            barrier(
                barrier(maximum(barrier(place - high), 0))
                - barrier(maximum(barrier(low - place), 0))
            )
            for place, low, high in self.faces
        ]

    @property
    def distance(self) -> sp.Expr:
        """The distance from the box less R_B; at least -R_B within it."""
        return sp.sqrt(barrier(sp.Add(*(e**2 for e in self.excess)))) - self.radius

    @property
    def azimuth_free_distance(self) -> sp.Expr | None:
        """The distance from the box to the circle about the z axis through the ball's centre.

        In the plan view the box begins at some distance from the axis, and the circle ends at
        another.
        """
        x, y, _ = POSITION
        sides = list(zip(self.low, self.high, strict=True))[:2]
        begins = sp.sqrt(
            barrier(sp.Add(*(barrier(maximum(0, low, -high)) ** 2 for low, high in sides)))
        )
        beyond = barrier(maximum(0, barrier(begins) - barrier(sp.sqrt(barrier(x**2 + y**2)))))
        return sp.sqrt(barrier(beyond**2 + self.excess[2] ** 2)) - self.radius

    @property
    def condition(self) -> sp.Expr:
        """The squared distance from the box less R_B²."""
        return sp.Add(*(e**2 for e in self.excess), -(self.radius**2))

    @property
    def reference_point(self) -> Point:
        """The centre of the box."""
        x, y, z = ((low + high) / 2 for low, high in zip(self.low, self.high, strict=True))
        return (x, y, z)

    @property
    def half_sizes(self) -> tuple[sp.Expr | None, ...]:
        """Half its sides, plus R_B."""
        sides = zip(self.low, self.high, strict=True)
        return tuple((high - low) / 2 + self.radius for low, high in sides)

    @property
    def enclosed(self) -> bool:
        """True: a box is bounded."""
        return True

    @property
    def normal(self) -> sp.Matrix:
        """The direction from the nearest point of the box: on a face exactly that of an axis."""
        return sp.Matrix([e / self._length for e in self.excess])

    @property
    def _length(self) -> sp.Expr:
        """The distance from the box, and half of R_B where the ball overlaps it by more."""
        away = barrier(sp.sqrt(barrier(sp.Add(*(e**2 for e in self.excess)))))
        return barrier(maximum(away, self.scaled_radius / 2))

    def nearest_point(self, ball_radius: sp.Expr) -> list[sp.Expr]:
        """Return the nearest point of the box, also of a ball that overlaps it."""
        del ball_radius
        return [barrier(place - e) for place, e in zip(POSITION, self.excess, strict=True)]

    @property
    def own_distance(self) -> sp.Expr:
        """The distance; of a box with bounds, which a ball may be within, at least -R_B/2."""
        if self.contact_bounds is None:
            return self.distance
        return barrier(self._length * self._per_scale) - self.radius

    @property
    def _per_scale(self) -> sp.Expr:
        """One metre in the unit of length of `faces`, inverted."""
        return sp.Integer(1)

    @property
    def max_convexity(self) -> sp.Expr:
        """A bound on 1/D down to half of the distance D from the box, or of R_B/2."""
        return 2 / barrier(self._length * self._per_scale)

    @property
    def contact_path(self) -> ContactPath | None:
        """The nearest point of the box moves along the axes between whose faces the centre is."""
        if self.contact_bounds is None:
            return None
        zero, crease = sp.Integer(0), barrier(minimum(*self.ways_to_seams))
        point = self.nearest_point(self.radius)
        return ContactPath(point, sp.Integer(1), zero, zero, self._rates, crease)

    @property
    def _bent(self) -> list[sp.Expr]:
        """For each axis 1 if the ball is or moves past a face across it, else 0."""
        found = []
        for place, v, low, high in zip(POSITION, VELOCITY, self.low, self.high, strict=True):
            near = barrier(seam_width(high, low, self.radius))
            found.append(Choose(Or(*past_faces(place, v, low, high, near)), 1, 0))
        return found

    @property
    def _rates(self) -> list[sp.Expr]:
        """The rate of the nearest point."""
        return [barrier(1 - bent) * v for bent, v in zip(self._bent, VELOCITY, strict=True)]

    @property
    def ways_to_seams(self) -> list[sp.Expr]:
        """The distances of the ball's centre from the planes of the faces, m."""
        return [
            barrier(absolute(barrier(place - barrier(side))))
            for place, low, high in zip(POSITION, self.low, self.high, strict=True)
            for side in (low, high)
        ]

    @property
    def curvature(self) -> sp.Expr:
        """The curvature of edges and corners, 1/R_B."""
        return 1 / self.radius

    def curvature_within(self, reach: Sequence[sp.Expr]) -> sp.Expr:
        """Return 0 where the ball stays on one face within that distance, else 1/R_B.

        On a face two coordinates are between those of its edges. Within that distance the ball does
        not get around the box to the opposite face.
        """
        x, y, z = (
            barrier(maximum(barrier(place - high), barrier(low - place)) + way)
            for (place, low, high), way in zip(self.faces, self.turned_sizes(reach), strict=True)
        )
        pairs = (barrier(maximum(*pair)) for pair in ((x, y), (y, z), (z, x)))
        return IfLess(barrier(minimum(*pairs)), 0, 0, self.curvature)

    def turned_sizes(self, sizes: Sequence[sp.Expr]) -> list[sp.Expr]:
        """Return bounds on the components of a vector along the box's axes, in the unit of `faces`.

        Parameters
        ----------
        sizes
            The sizes of its components along the scene's axes.
        """
        return list(sizes)

    @property
    def rolling_surface(self) -> RollingSurface | None:
        """The face, edge or corner that the ball is on or moves onto.

        At a seam, within a few roundings, the direction of the velocity decides.
        """
        seams = []
        for place, low, high in zip(POSITION, self.low, self.high, strict=True):
            near = barrier(seam_width(high, low, self.radius))
            seams += [(place, low, near), (place, high, near)]
        x, y, z = self._bent
        return RollingSurface((x, y, z), 1 / self.radius, seams=tuple(seams))

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """The distance itself, and the bounds."""
        return overlap(self.distance, self.bounds, None)


def past_faces(
    place: sp.Expr, rate: sp.Expr, low: sp.Expr, high: sp.Expr, near: sp.Expr
) -> tuple[sp.Basic, sp.Basic]:
    """Return whether a ball is or moves past the upper face across an axis, and the lower one.

    Parameters
    ----------
    place, rate
        The coordinate of the ball's centre along that axis, and its rate.
    low, high
        Those of the faces.
    near
        Half the width of a seam.
    """
    above, below = barrier(place - high), barrier(low - place)
    return _onto(above, rate, near), _onto(below, -rate, near)


def seam_width(*lengths: sp.Expr) -> sp.Expr:
    """Return half the width of a seam: a few roundings of the coordinates."""
    return sp.Rational(1, 2**46) * sp.Add(*map(sp.Abs, lengths))


def _onto(beyond: sp.Expr, rate: sp.Expr, near: sp.Expr) -> sp.Basic:
    """Return the condition that a coordinate is beyond a seam, or at it and moving there."""
    return Or(Less(near, beyond), And(Less(-near, beyond), Less(0, rate)))
