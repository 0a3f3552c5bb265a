"""A box that is turned by a quaternion, whose components are parameters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import Choose, Or, absolute, barrier
from ..symbolic.symbols import POSITION, VELOCITY
from .box import Box, past_faces, seam_width
from .rolling_surface import RollingSurface
from .rotation import Matrix, Quaternion, scaled_rotation, squared_norm, times, transposed
from .surface import Point


@dataclass(frozen=True)
class ObliqueBox(Box):
    """A box along any three directions at right angles, touched from outside.

    It is a `Box` in the coordinates Rᵀ d with the offset d from its centre and the matrix R of
    `rotation`. They are |q|² times as long as the scene's, and so are its corners and R_B there.

    Attributes
    ----------
    low, high
        Its corners with the smallest and the largest coordinates, seen from its centre along its
        own axes.
    radius
        R_B.
    centre
        The centre of the box.
    orientation
        The quaternion that turns the scene's axes onto those of the box, about of length 1.
    """

    centre: Point
    orientation: Quaternion

    @property
    def scale(self) -> sp.Expr:
        """|q|²."""
        return barrier(squared_norm(self.orientation))

    @property
    def rotation(self) -> Matrix:
        """R, each entry held."""
        return [[barrier(entry) for entry in row] for row in scaled_rotation(self.orientation)]

    @property
    def offsets(self) -> list[sp.Expr]:
        """The place of the ball's centre as seen from that of the box."""
        return [barrier(place - own) for place, own in zip(POSITION, self.centre, strict=True)]

    @property
    def faces(self) -> list[tuple[sp.Expr, sp.Expr, sp.Expr]]:
        """The coordinates along the box's axes, and its corners there."""
        corners = ([barrier(self.scale * c) for c in end] for end in (self.low, self.high))
        return list(zip(self.turned(self.offsets), *corners, strict=True))

    @property
    def scaled_radius(self) -> sp.Expr:
        """|q|² R_B."""
        return barrier(self.scale * self.radius)

    def turned(self, vector: Sequence[sp.Expr]) -> list[sp.Expr]:
        """Return Rᵀ times a vector."""
        return [barrier(part) for part in times(transposed(self.rotation), vector)]

    def turned_sizes(self, sizes: Sequence[sp.Expr]) -> list[sp.Expr]:
        """Return |Rᵀ| times the sizes, with each entry's absolute value."""
        return [barrier(part) for part in times(transposed(self._shares), sizes)]

    @property
    def _shares(self) -> Matrix:
        """The sizes of the entries of R; 0 stays as it is, whose absolute value has no digits."""
        return [
            [absolute(entry) if entry != 0 else entry for entry in row] for row in self.rotation
        ]

    @property
    def distance(self) -> sp.Expr:
        """The distance from the box less R_B; at least -R_B within it."""
        away = barrier(sp.sqrt(barrier(sp.Add(*(e**2 for e in self.excess)))))
        return barrier(away * barrier(1 / self.scale)) - self.radius

    @property
    def azimuth_free_distance(self) -> sp.Expr | None:
        """None."""
        return None

    @property
    def condition(self) -> sp.Expr:
        """The squared distance from the box less R_B², times |q|⁴."""
        return sp.Add(*(e**2 for e in self.excess), -(self.scaled_radius**2))

    @property
    def reference_point(self) -> Point:
        """The centre."""
        return self.centre

    @property
    def half_sizes(self) -> tuple[sp.Expr | None, ...]:
        """Half sizes, plus R_B, of the box along the scene's axes that the turned one is in."""
        halves = [(high - low) / 2 for low, high in zip(self.low, self.high, strict=True)]
        per_scale = barrier(1 / self.scale)
        sizes = times(self._shares, halves)
        return tuple(barrier(barrier(size) * per_scale) + self.radius for size in sizes)

    @property
    def steepness(self) -> sp.Expr:
        """2: its gradient is 1, but the turning adds as many roundings again."""
        return sp.Integer(2)

    @property
    def normal(self) -> sp.Matrix:
        """The direction from the nearest point of the box, turned back."""
        per = barrier(1 / self.scale)
        directions = [barrier(e / self._length) for e in self.excess]
        return sp.Matrix([part * per for part in times(self.rotation, directions)])

    def nearest_point(self, ball_radius: sp.Expr) -> list[sp.Expr]:
        """Return the nearest point of the box, also of a ball that overlaps it."""
        del ball_radius
        per = barrier(1 / barrier(self.scale * self.scale))
        away = (barrier(barrier(part) * per) for part in times(self.rotation, self.excess))
        return [barrier(place - e) for place, e in zip(POSITION, away, strict=True)]

    @property
    def _unit_axes(self) -> Matrix:
        """The rotation itself, in rows."""
        per_scale = barrier(1 / self.scale)
        return [[barrier(entry * per_scale) for entry in row] for row in self.rotation]

    @property
    def _sides(self) -> list[tuple[sp.Expr, sp.Expr, sp.Expr]]:
        """The ball's coordinates along the axes of the box, their rates, half widths of seams."""
        turned = transposed(self._unit_axes)
        away = barrier(sp.Add(*map(sp.Abs, self.offsets)))
        return [
            (
                barrier(place),
                barrier(rate),
                barrier(seam_width(high, low, self.radius, away, *self.centre)),
            )
            for place, rate, low, high in zip(
                times(turned, self.offsets),
                times(turned, VELOCITY),
                self.low,
                self.high,
                strict=True,
            )
        ]

    @property
    def _past_faces(self) -> list[tuple[sp.Basic, sp.Basic]]:
        """For each axis, if the ball is or moves past the upper face, and the lower one."""
        return [
            past_faces(place, rate, low, high, near)
            for (place, rate, near), low, high in zip(self._sides, self.low, self.high, strict=True)
        ]

    @property
    def _per_scale(self) -> sp.Expr:
        """1/|q|²."""
        return barrier(1 / self.scale)

    @property
    def _bent(self) -> list[sp.Expr]:
        """For each axis of the box 1 if the ball is or moves past a face across it, else 0."""
        return [barrier(Choose(Or(*past), 1, 0)) for past in self._past_faces]

    @property
    def _rates(self) -> list[sp.Expr]:
        """The rate of the nearest point, turned back."""
        own = [
            barrier(barrier(1 - bent) * rate)
            for bent, (_, rate, _) in zip(self._bent, self._sides, strict=True)
        ]
        return [barrier(part) for part in times(self._unit_axes, own)]

    @property
    def ways_to_seams(self) -> list[sp.Expr]:
        """The distances of the ball's centre from the planes of the faces, m."""
        return [
            barrier(absolute(barrier(place - barrier(side))))
            for (place, _, _), low, high in zip(self._sides, self.low, self.high, strict=True)
            for side in (low, high)
        ]

    @property
    def distance_ahead(self) -> sp.Expr:
        """The distance from the part of the box that the ball is on or moves onto."""
        beyond = [
            Choose(above, barrier(place - high), Choose(below, barrier(place - low), 0))
            for (place, _, _), (above, below), low, high in zip(
                self._sides, self._past_faces, self.low, self.high, strict=True
            )
        ]
        return sp.sqrt(barrier(sp.Add(*(barrier(e) ** 2 for e in beyond)))) - self.radius

    @property
    def rolling_surface(self) -> RollingSurface | None:
        """The face, edge or corner that the ball is on or moves onto.

        Along the axes of the box it is that of `Box`, and the projection P is turned back.
        """
        axes, sides = self._unit_axes, self._sides
        bent, seams = self._bent, []
        for (place, _, near), low, high in zip(sides, self.low, self.high, strict=True):
            seams += [(place, low, near), (place, high, near)]
        across = [
            [
                sp.Add(*(barrier(a * b) * own for a, b, own in zip(one, other, bent, strict=True)))
                for other in axes
            ]
            for one in axes
        ]
        return RollingSurface(None, 1 / self.radius, seams=tuple(seams), across=across)
