"""Users' scenes for derivation: sizes are symbols, bodies are offset by the ball's radius.

The only module of this package that imports SymPy itself.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import sympy as sp

from hoopgen.derive.contact.friction import CoulombFriction
from hoopgen.derive.contact.law import Law
from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.scenes import scene as derive
from hoopgen.derive.scenes.air import with_air
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.validity import gravity_excess
from hoopgen.derive.surfaces import (
    Body,
    Box,
    Cone,
    ContactBounds,
    Cylinder,
    ImplicitSurface,
    InclinedPlane,
    ObliqueBox,
    ObliqueCylinder,
    ObliqueTorus,
    Plane,
    Sphere,
    Surface,
    Torus,
    torus,
)
from hoopgen.derive.surfaces.directions import along, squared_distance, squared_length
from hoopgen.derive.symbolic.conditionals import barrier, maximum
from hoopgen.derive.symbolic.symbols import POSITION

from .bounds import Terms
from .boxes import PARTS
from .contact_laws import Contact
from .errors import SceneError
from .formulas import Formula
from .parsed_shapes import RevolvedShape, Shape
from .revolution_faces import revolution_faces
from .scene_reader import ParsedScene

Point = tuple[sp.Expr, sp.Expr, sp.Expr]


def derivation_scene(read: ParsedScene, axes: str, remarks: str) -> derive.Scene:
    """Return a scene for derivation. Its parameters are the scene's inputs, in order.

    Parameters
    ----------
    read
        The scene.
    axes, remarks
        What it says to readers.

    Raises
    ------
    SceneError
        If a name is taken.
    """
    try:
        return _Builder(read).scene(axes, remarks)
    except ValueError as error:  # of names that derivation has taken
        raise SceneError(str(error)) from None


class _Builder:
    def __init__(self, read: ParsedScene) -> None:
        self._read = read
        self._parameters = tuple(
            derive.parameter(
                i.name,
                i.unit,
                i.summary,
                i.default,
                i.sign,
                i.upper,
                i.latex,
                i.lower,
                i.infinite,
            )
            for i in read.inputs
        )
        self._symbols = {p.name: p.symbol for p in self._parameters}
        self._requirements: list[sp.Expr] = []
        self._laws: dict[Contact | None, Law] = {}
        self._ball = self._sympy(read.ball_radius)

    def scene(self, axes: str, remarks: str) -> derive.Scene:
        """Return the scene."""
        read = self._read
        gravity = self._sympy(read.gravity)
        way, acceleration = (2, -1), None
        if len(read.down) == 2:
            way = read.down
            if not gravity.is_positive:
                ax, ay, az = (part * gravity for part in _direction(way))
                acceleration = (ax, ay, az)
        else:
            ax, ay, az = map(self._sympy, read.down)
            acceleration = (ax, ay, az)
            if read.rolls:
                self._requirements.append(gravity_excess(acceleration))
        bodies = tuple(self._body(shape) for shape in read.bodies)
        ends = tuple(self._end(shape) for shape in read.ends)
        scene = derive.Scene(
            name=read.name,
            parameters=self._parameters,
            bodies=bodies,
            ends=ends,
            ball_radius=self._ball,
            gravity=gravity,
            inertia=self._sympy(read.inertia),
            requirements=tuple(dict.fromkeys(self._requirements)),
            axes=axes,
            remarks=remarks,
            gravity_axis=_direction(way),
            acceleration=acceleration,
            rolls=read.rolls,
        )
        return with_air(scene) if read.air else scene

    def _sympy(self, formula: Formula) -> sp.Expr:
        return formula.fold(
            self._symbols, lambda value: sp.Rational(value.numerator, value.denominator), sp.sqrt
        )

    def _body(self, shape: Shape) -> Body:
        make: dict[str, Callable[[Shape], tuple[Surface, ...]]] = {
            "plane": self._plane,
            "sphere": self._sphere,
            "cylinder": self._cylinder,
            "torus": self._torus,
            "box": self._box,
            "oblique box": self._oblique_box,
            "surface": self._surface,
            "inclined plane": self._inclined_plane,
            "disc": self._disc,
            "oblique cylinder": self._oblique_cylinder,
            "oblique torus": self._oblique_torus,
            "cone": self._cone,
            "revolution": self._revolution,
        }
        return Body(shape.name, make[shape.kind](shape), self._law(shape))

    def _law(self, shape: Shape) -> Law:
        """Return the law of a body, the article's if possible; bodies with equal ones share it."""
        shared = {body.law for body in self._read.bodies}
        name = "impact" if len(shared) == 1 else f"{shape.name}_impact"
        return self._laws.setdefault(shape.law, self._named(name, shape.law))

    def _named(self, name: str, given: Contact | None) -> Law:
        assert given is not None  # an end has none, and no law
        restitution = self._sympy(given.restitution)
        if given == Contact(given.restitution):
            return NoSlip(name, restitution)
        friction, speed = (
            sp.oo if size is None else self._sympy(size) for size in (given.friction, given.speed)
        )
        return CoulombFriction(name, restitution, friction, self._sympy(given.tangential), speed)

    def _plane(self, shape: Shape) -> tuple[Surface, ...]:
        offset = self._sympy(shape["at"]) + self._ball
        bounds = self._bounds(shape)
        return (Plane(shape.name, _direction(shape.axis), offset, self._ball, bounds),)

    def _sphere(self, shape: Shape) -> tuple[Surface, ...]:
        radius, sides = self._curved(shape)
        return (Sphere(shape.name, self._centre(shape), radius, **sides),)

    def _cylinder(self, shape: Shape) -> tuple[Surface, ...]:
        radius, sides = self._curved(shape)
        centre, direction = self._centre(shape), _direction(shape.axis)
        return (Cylinder(shape.name, centre, direction, radius, **sides),)

    def _curved(
        self, shape: Shape, span: tuple[sp.Expr, ...] = ()
    ) -> tuple[sp.Expr, dict[str, Any]]:
        """Return the offset radius, and the sides: bounds, and the thickness of a shell."""
        radius, bounds = self._sympy(shape["radius"]), (*span, *self._bounds(shape))
        if not shape.inside:
            return radius + self._ball, {"limits": bounds}
        self._requirements.append(radius - self._ball)
        reach = self._ball if bounds else None
        return radius - self._ball, {"limits": bounds, "inward": True, "reach": reach}

    def _torus(self, shape: Shape) -> tuple[Surface, ...]:
        kind = Torus if shape.bounds else torus
        made = kind(shape.name, self._centre(shape), _direction(shape.axis), *self._tube(shape))
        return self._within(shape, made)

    def _oblique_torus(self, shape: Shape) -> tuple[Surface, ...]:
        direction = self._vector(shape, "direction")
        made = ObliqueTorus(shape.name, self._centre(shape), direction, *self._tube(shape))
        return self._within(shape, made)

    def _within(self, shape: Shape, *faces: Surface) -> tuple[Surface, ...]:
        """Return the faces of a body where its points of contact are within its bounds."""
        given = self._bounds(shape)
        if not given:
            return faces
        bounds = ContactBounds(given, self._ball)
        return tuple(replace(face, contact_bounds=bounds) for face in faces)

    def _tube(self, shape: Shape) -> tuple[sp.Expr, sp.Expr]:
        """Return the radius of a torus, and the reach of its tube, which leaves a hole."""
        radius, reach = self._sympy(shape["radius"]), self._sympy(shape["wire"]) + self._ball
        self._requirements.append(radius - reach)
        return radius, reach

    def _box(self, shape: Shape) -> tuple[Surface, ...]:
        low, high = (
            tuple(self._sympy(shape[f"{end} {axis}"]) for axis in "xyz") for end in ("from", "to")
        )
        self._requirements += [b - a for a, b in zip(low, high, strict=True)]
        low, high = ((x, y, z) for x, y, z in (low, high))
        return self._within(shape, Box(shape.name, low, high, self._ball))

    def _oblique_box(self, shape: Shape) -> tuple[Surface, ...]:
        high, centre = self._vector(shape, "half"), self._centre(shape)
        low = (-high[0], -high[1], -high[2])
        w, x, y, z = (self._sympy(shape[f"orientation {part}"]) for part in PARTS)
        made = ObliqueBox(shape.name, low, high, self._ball, centre, (w, x, y, z))
        return self._within(shape, made)

    def _surface(self, shape: Shape) -> tuple[Surface, ...]:
        condition = self._polynomial(shape.condition)
        return (ImplicitSurface(shape.name, condition, self._bounds(shape)),)

    def _inclined_plane(self, shape: Shape) -> tuple[Surface, ...]:
        offset = self._sympy(shape["at"]) + self._ball
        bounds, direction = self._bounds(shape), self._vector(shape, "direction")
        return (InclinedPlane(shape.name, direction, offset, self._ball, bounds),)

    def _disc(self, shape: Shape) -> tuple[Surface, ...]:
        """Return the plane of a disc, within its circle: a cylinder about its axis."""
        offset, direction = self._sympy(shape["at"]) + self._ball, self._vector(shape, "direction")
        around = squared_distance(direction, self._from(shape, "centre"))
        radius = self._sympy(shape["radius"])
        circle = sp.expand(around - radius**2 * squared_length(direction))
        bounds = (circle, *self._bounds(shape))
        if all(part.is_Integer for part in direction):
            x, y, z = map(int, direction)
            return (Plane(shape.name, (x, y, z), offset, self._ball, bounds),)
        return (InclinedPlane(shape.name, direction, offset, self._ball, bounds),)

    def _oblique_cylinder(self, shape: Shape) -> tuple[Surface, ...]:
        span = self._span(shape, "centre", "span from", "span to")
        radius, sides = self._curved(shape, span)
        axis, direction = self._vector(shape, "axis"), self._vector(shape, "direction")
        if len(span) == 2:
            aside = (sp.Abs(c - a) for c, a in zip(self._centre(shape), axis, strict=True))
            ends = (sp.Abs(self._sympy(shape[f"span {end}"])) for end in ("from", "to"))
            sides["furthest"] = radius + maximum(*ends) + sp.Add(*aside)
        return (ObliqueCylinder(shape.name, axis, direction, radius, **sides),)

    def _cone(self, shape: Shape) -> tuple[Surface, ...]:
        """Return the side of a cone, and, if the ball can touch it, its apex."""
        bounds = self._span(shape, "apex", "contact from", "contact to")
        apex, direction = self._vector(shape, "apex"), self._vector(shape, "direction")
        shell = self._ball if shape.inside and (bounds or shape.bounds) else None
        slope, sizes = self._sympy(shape["slope"]), dict(shape.sizes)
        furthest = None
        if "contact to" in sizes:
            per_height = barrier(sp.sqrt(1 + slope**2))
            to_apex = self._ball * per_height / slope
            furthest = (self._sympy(sizes["contact to"]) + to_apex) * per_height
        side = Cone(
            shape.name,
            self._vector(shape, "contact apex"),
            direction,
            slope,
            limits=bounds,
            inward=shape.inside,
            reach=shell,
            furthest=furthest,
        )
        if shape.inside or "span from" in sizes:
            return self._within(shape, side)
        tip = Sphere(f"{shape.name}_apex", apex, self._ball, limits=(-bounds[0],))
        return self._within(shape, side, tip)

    def _revolution(self, shape: Shape) -> tuple[Surface, ...]:
        assert isinstance(shape, RevolvedShape)
        faces, required = revolution_faces(shape, self._sympy, self._ball)
        self._requirements += required
        return self._within(shape, *faces)

    def _span(self, shape: Shape, origin: str, low: str, high: str) -> tuple[sp.Expr, ...]:
        """Return the bounds of a span along a direction, from a point."""
        sizes = dict(shape.sizes)
        height = sp.expand(along(self._vector(shape, "direction"), self._from(shape, origin)))
        found = [self._sympy(sizes[low]) - height] if low in sizes else []
        found += [height - self._sympy(sizes[high])] if high in sizes else []
        return tuple(found)

    def _from(self, shape: Shape, origin: str) -> list[sp.Expr]:
        there = self._vector(shape, origin)
        return [place - own for place, own in zip(POSITION, there, strict=True)]

    def _centre(self, shape: Shape) -> Point:
        return self._vector(shape, "centre")

    def _vector(self, shape: Shape, argument: str) -> Point:
        sizes = dict(shape.sizes)
        x, y, z = (
            self._sympy(sizes[f"{argument} {axis}"])
            if f"{argument} {axis}" in sizes
            else sp.Integer(0)
            for axis in "xyz"
        )
        return x, y, z

    def _bounds(self, shape: Shape) -> tuple[sp.Expr, ...]:
        return tuple(self._polynomial(bound) for bound in shape.bounds)

    def _polynomial(self, terms: Terms) -> sp.Expr:
        x, y, z = POSITION
        return sp.Add(*(self._sympy(factor) * x**i * y**j * z**k for (i, j, k), factor in terms))

    def _end(self, shape: Shape) -> End:
        direction, at = _direction(shape.axis), self._sympy(shape["at"])
        plane = Plane(f"{shape.name}_end", direction, at, sp.Integer(0), self._bounds(shape))
        return End(shape.name, plane)


def _direction(axis: tuple[int, int]) -> tuple[int, int, int]:
    parts = [axis[1] * (k == axis[0]) for k in range(3)]
    return parts[0], parts[1], parts[2]
