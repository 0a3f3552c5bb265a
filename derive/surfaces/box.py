"""A box: faces, edges and corners as one surface, on which the distance is smooth throughout."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.choice import Both, Choose, Either, Less, hold, largest
from ..ground.symbols import POSITION, VELOCITY
from .surface import Point, Surface, overlap
from .tube import Tube


@dataclass(frozen=True)
class Box(Surface):
    """A box along the axes, touched from outside.

    Seen from the ball's centre it is a box with round edges and corners. The squared distance from
    the box less R_B² is a polynomial on each of 27 parts, by the coordinates that are beyond a
    face; where they meet it and its gradient are continuous, so that no seam is ever in doubt.

    Attributes
    ----------
    low, high
        Its corners of least and largest coordinates.
    radius
        R_B, the ball's.
    """

    low: Point
    high: Point
    radius: sp.Expr

    @property
    def polynomial(self) -> bool:
        """No: one on each part."""
        return False

    @property
    def excess(self) -> list[sp.Expr]:
        """How far each coordinate is beyond a face, negative beyond the lower one."""
        faces = zip(POSITION, self.low, self.high, strict=True)
        return [
            hold(hold(largest(hold(place - high), 0)) - hold(largest(hold(low - place), 0)))
            for place, low, high in faces
        ]

    @property
    def distance(self) -> sp.Expr:
        """The distance from the box less R_B; no less than -R_B within it."""
        return sp.sqrt(hold(sp.Add(*(e**2 for e in self.excess)))) - self.radius

    @property
    def around(self) -> sp.Expr:
        """From the box to the circle around the z axis on which the ball's centre is.

        In the plan the box begins at some distance from the axis, and the circle ends at another.
        """
        x, y, _ = POSITION
        sides = list(zip(self.low, self.high, strict=True))[:2]
        begins = sp.sqrt(hold(sp.Add(*(hold(largest(0, low, -high)) ** 2 for low, high in sides))))
        beyond = hold(largest(0, hold(begins) - hold(sp.sqrt(hold(x**2 + y**2)))))
        return sp.sqrt(hold(beyond**2 + self.excess[2] ** 2)) - self.radius

    @property
    def condition(self) -> sp.Expr:
        """The squared distance from the box less R_B²."""
        return sp.Add(*(e**2 for e in self.excess), -(self.radius**2))

    @property
    def about(self) -> Point:
        """Its middle."""
        x, y, z = ((low + high) / 2 for low, high in zip(self.low, self.high, strict=True))
        return (x, y, z)

    @property
    def halves(self) -> tuple[sp.Expr | None, ...]:
        """Half its sides, and R_B."""
        sides = zip(self.low, self.high, strict=True)
        return tuple((high - low) / 2 + self.radius for low, high in sides)

    @property
    def enclosed(self) -> bool:
        """It is."""
        return True

    @property
    def normal(self) -> sp.Matrix:
        """From the nearest point of the box, over R_B."""
        per = hold(1 / self.radius)
        return sp.Matrix([e * per for e in self.excess])

    @property
    def curvature(self) -> sp.Expr:
        """1/R_B around edges and corners."""
        return 1 / self.radius

    @property
    def tube(self) -> Tube:
        """A face, or the round about an edge or a corner, whichever the ball is on or comes onto.

        At a seam, within a few roundings, it is the one that the velocity goes to.
        """
        bent = []
        seams = []
        for place, v, low, high in zip(POSITION, VELOCITY, self.low, self.high, strict=True):
            near = hold(seam_width(high, low, self.radius))
            above, below = hold(place - high), hold(low - place)
            on = Either(_onto(above, v, near), _onto(below, -v, near))
            bent.append(Choose(on, 1, 0))
            seams += [(place, low, near), (place, high, near)]
        x, y, z = bent
        return Tube((x, y, z), 1 / self.radius, seams=tuple(seams))

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """Nearer to the box than touching, or in it."""
        return overlap(self.distance, (), None)


def seam_width(*lengths: sp.Expr) -> sp.Expr:
    """Return how near to a seam a coordinate may be on either side of it: some roundings."""
    return sp.Rational(1, 2**46) * sp.Add(*map(sp.Abs, lengths))


def _onto(beyond: sp.Expr, rate: sp.Expr, near: sp.Expr) -> sp.Basic:
    """Return where a coordinate is beyond a seam, or at it and on its way there."""
    return Either(Less(near, beyond), Both(Less(-near, beyond), Less(0, rate)))
