"""Faces of surfaces of revolution for derivation: sides of cones, cylinders and arcs, rings, edges.

With `hoopgen.scene.derivation` the only module of this package that imports SymPy itself.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import sympy as sp

from hoopgen.derive.surfaces import (
    Cone,
    Cylinder,
    InclinedPlane,
    ObliqueCylinder,
    ObliqueTorus,
    Plane,
    RevolvedArc,
    Sphere,
    Surface,
    Torus,
)
from hoopgen.derive.surfaces.directions import along, distance_from_axis, per_length
from hoopgen.derive.symbolic.conditionals import IfLess, absolute, barrier, maximum
from hoopgen.derive.symbolic.symbols import POSITION

from .formulas import Formula
from .parsed_shapes import RevolvedShape
from .profile import Arc, Line
from .revolution import LEAST_OFFSET, ON_AXIS

Point = tuple[sp.Expr, sp.Expr, sp.Expr]
Bounds = tuple[sp.Expr, ...]


def revolution_faces(
    shape: RevolvedShape, sympy: Callable[[Formula], sp.Expr], ball: sp.Expr
) -> tuple[tuple[Surface, ...], list[sp.Expr]]:
    """Return the faces of a surface of revolution, and formulas that must be positive for them.

    Parameters
    ----------
    shape
        The surface.
    sympy
        The function from a size to its symbol.
    ball
        The ball's radius.
    """
    faces = _Faces(shape, sympy, ball)
    return (*faces.sides(), *faces.edges()), list(faces.requirements())


class _Faces:
    def __init__(
        self, shape: RevolvedShape, sympy: Callable[[Formula], sp.Expr], ball: sp.Expr
    ) -> None:
        self._name, self._profile, self._sympy, self._ball = shape.name, shape.profile, sympy, ball
        self._sizes = {argument: sympy(size) for argument, size in shape.sizes}
        self._direction = self._vector(self._sizes, "direction")
        self._fixed = all(part.is_Integer for part in self._direction)
        centre = self._vector(self._sizes, "centre")
        offset = [place - own for place, own in zip(POSITION, centre, strict=True)]
        self._rho = distance_from_axis(self._direction, offset)
        height = barrier(along(self._direction, offset))
        self._height = height if self._fixed else barrier(height * per_length(self._direction))
        self._vertices = [(sympy(v.radius), sympy(v.height)) for v in self._profile.vertices]

    @staticmethod
    def _vector(sizes: dict[str, sp.Expr], argument: str) -> Point:
        x, y, z = (sizes.get(f"{argument} {axis}", sp.Integer(0)) for axis in "xyz")
        return x, y, z

    def _beyond(self, line: Line | Arc, vertex: int) -> sp.Expr:
        """Return the way of the ball along a piece beyond one of its points, a length."""
        radius, height = self._vertices[vertex]
        c, s = map(self._sympy, line.ways[vertex == line.end])
        across = c * barrier(self._rho - radius) if c != 0 else sp.Integer(0)
        return across + (s * barrier(self._height - height) if s != 0 else 0)

    def sides(self) -> Iterator[Surface]:
        """Yield both sides of each piece, that which the ball does not reach left out."""
        for number, line in enumerate(self._profile.lines, start=1):
            bounds = self._ends(line)
            if isinstance(line, Arc):
                yield from self._arc(number, line, bounds)
            else:
                make = {"cone": self._cone, "cylinder": self._cylinder, "disc": self._disc}
                yield from make[line.kind](number, line, bounds)

    def _ends(self, line: Line | Arc) -> Bounds:
        """Return the bounds of a piece at its ends."""
        low, high = -self._beyond(line, line.start), self._beyond(line, line.end)
        # Of a flat piece or a sphere that reaches the axis nothing is beyond that end.
        through = [line.kind in ("disc", "sphere") and self._on_axis(k) for k in _numbers(line)]
        if isinstance(line, Arc) and all(through):
            # A bound that holds of every ball: the sphere is a thin wall, and a ball may be behind.
            return (-self._ball,)
        if isinstance(line, Arc) and line.long:
            # The less of the two, without a comparison, which would have to be decided.
            return (barrier(barrier(low + high) - barrier(absolute(barrier(low - high)))) / 2,)
        ends = zip((low, high), through, strict=True)
        return tuple(bound for bound, none in ends if not none)

    def _sides(self, bounds: Bounds, inward: bool) -> dict[str, Any]:
        return {"limits": bounds, "inward": inward, "reach": self._ball}

    def _on_axis(self, vertex: int) -> bool:
        return self._profile.vertices[vertex].radius.number == 0

    def _arc(self, number: int, line: Arc, bounds: Bounds) -> Iterator[Surface]:
        sizes = {argument: self._sympy(size) for argument, size in line.sizes}
        centre, radius = self._vector(sizes, "centre"), sizes["radius"]
        for side, inward in [("outside", False), ("inside", True)][: 2 if line.hollow else 1]:
            name = f"{self._name}_{side}_{number}"
            reach = radius - self._ball if inward else radius + self._ball
            sides = self._sides(bounds, inward)
            if line.kind == "sphere":
                yield Sphere(name, centre, reach, **sides)
                continue
            yield RevolvedArc(
                name,
                centre,
                self._direction,
                sizes["offset"],
                line.offset_sign,
                reach,
                line.across[inward],
                **sides,
            )

    def _cone(self, number: int, line: Line, bounds: Bounds) -> Iterator[Surface]:
        sizes = {argument: self._sympy(size) for argument, size in line.sizes}
        way = line.signs[0] * line.signs[1]
        x, y, z = (way * part for part in self._direction)
        for side, inward in self._round(line):
            apex = self._vector(sizes, f"{side} apex")
            name = f"{self._name}_{side}_{number}"
            own = self._sides(bounds, inward) | {"furthest": self._furthest(line, apex)}
            yield Cone(name, apex, (x, y, z), sizes["slope"], **own)

    def _round(self, line: Line) -> list[tuple[str, bool]]:
        return [("outside", False), ("inside", True)][: 2 if line.inner else 1]

    def _cylinder(self, number: int, line: Line, bounds: Bounds) -> Iterator[Surface]:
        sizes = {argument: self._sympy(size) for argument, size in line.sizes}
        kind = Cylinder if self._fixed else ObliqueCylinder
        for side, inward in self._round(line):
            name, radius = f"{self._name}_{side}_{number}", sizes["radius"]
            reach = radius - self._ball if inward else radius + self._ball
            axis = self._vector(sizes, "axis")
            own = self._sides(bounds, inward) | {"furthest": self._furthest(line, axis)}
            yield kind(name, axis, self._direction, reach, **own)

    def _furthest(self, line: Line, origin: Point) -> sp.Expr:
        """Return the largest distance from a point of the axis of a ball that touches a piece."""
        far = []
        for vertex in _numbers(line):
            place = map(self._sympy, self._profile.vertices[vertex].place)
            apart = (sp.Abs(a - b) for a, b in zip(place, origin, strict=True))
            far.append(self._vertices[vertex][0] + sp.Add(*apart))
        return maximum(*far) + self._ball

    def _disc(self, number: int, line: Line, bounds: Bounds) -> Iterator[Surface]:
        at = dict(line.sizes)["at"]
        for side, way in (("above", 1), ("below", -1)):
            name = f"{self._name}_{side}_{number}"
            offset = way * self._sympy(at) + self._ball
            x, y, z = (way * part for part in self._direction)
            if self._fixed:
                whole = (int(x), int(y), int(z))
                yield Plane(name, whole, offset, self._ball, bounds)
            else:
                yield InclinedPlane(name, (x, y, z), offset, self._ball, bounds)

    def edges(self) -> Iterator[Surface]:
        """Yield the circle that each point sweeps, and the tips of cones on the axis."""
        for number, vertex in enumerate(self._profile.vertices):
            lines = [one for one in self._profile.lines if number in _numbers(one)]
            if vertex.smooth:
                continue
            bounds = tuple(
                -self._beyond(one, number) if one.end == number else self._beyond(one, number)
                for one in lines
            )
            radius = self._vertices[number][0]
            x, y, z = map(self._sympy, vertex.place)
            if radius == 0:
                if lines[0].kind not in ("disc", "sphere"):
                    name = f"{self._name}_tip_{number + 1}"
                    yield Sphere(name, (x, y, z), self._ball, limits=bounds)
                continue
            hole = (self._hole(number),) if vertex.narrow else ()
            name = f"{self._name}_edge_{number + 1}"
            kind = Torus if self._fixed else ObliqueTorus
            yield kind(name, (x, y, z), self._direction, radius, self._ball, bounds, hole)

    def _hole(self, vertex: int) -> sp.Expr:
        """Return a bound that excludes the inner part of a torus that meets its axis.

        There the far side of the circle is at the ball's radius, and the near side is closer.
        """
        radius, height = self._vertices[vertex]
        far, above = barrier(self._rho + radius), barrier(self._height - height)
        return self._ball - barrier(sp.sqrt(barrier(far**2 + above**2)))

    def requirements(self) -> Iterator[sp.Expr]:
        """Yield formulas that must be positive: else other faces would be needed."""
        for line in self._profile.lines:
            if isinstance(line, Arc):
                yield from () if self._profile.fixed else self._arc_requirements(line)
                continue
            (first, low), (last, high) = (self._vertices[k] for k in (line.start, line.end))
            widest = last if line.signs[0] > 0 else first
            upright = line.signs[1] * self._sympy(line.ways[0][1])
            if line.kind == "cylinder" and line.inner:
                yield widest - self._ball
            if self._profile.fixed:
                continue
            if not line.inner:
                yield self._ball * upright - widest
            if line.signs[0]:
                yield line.signs[0] * (last - first)
            if line.signs[1]:
                yield line.signs[1] * (high - low)

    def _arc_requirements(self, arc: Arc) -> Iterator[sp.Expr]:
        """Yield formulas that are positive where an arc is as it is at the defaults."""
        sizes = {argument: self._sympy(size) for argument, size in arc.sizes}
        radius, offset = sizes["radius"], sizes.get("offset", sp.Integer(0))
        yield radius - self._ball if arc.hollow else self._ball - radius
        if "bend" not in sizes:
            return
        yield sizes["bend"]
        (first, low), (last, high) = (self._vertices[k] for k in _numbers(arc))
        (c, s), (final, _) = (map(self._sympy, way) for way in arc.ways)
        if arc.offset_sign:
            yield barrier(arc.offset_sign * offset - _rational(LEAST_OFFSET) * radius)
        else:
            yield barrier(_rational(ON_AXIS) * radius - barrier(absolute(offset)))
        ahead = barrier(c * barrier(last - first) + s * barrier(high - low))
        slack = _rational(ON_AXIS) * radius
        yield barrier((-1 if arc.long else 1) * ahead + slack)
        # Towards the axis at its start and away from it at its end, it is nearest to it between.
        least = barrier(offset - radius)
        if arc.long:
            yield IfLess(c, 0, least, IfLess(0, final, least, radius))
        else:
            yield IfLess(c, 0, IfLess(0, final, least, radius), radius)


def _numbers(line: Line | Arc) -> tuple[int, int]:
    return line.start, line.end


def _rational(value: float) -> sp.Rational:
    return sp.Rational(repr(value))
