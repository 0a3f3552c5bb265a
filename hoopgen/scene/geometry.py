"""Bodies and ends of any scene as triangles and lines, from the scene's own data."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.parameters import means
from hoopgen.engine.compiled_scene import CompiledScene

from .bounds import Terms, is_along
from .box_geometry import BOXES, box_extent, box_mesh
from .engine_pieces import scene_pieces
from .formulas import Formula
from .meshes import Bound, Box, Floats, Mesh, contact_mesh, cut, flat, grid, level_set, walls
from .oblique_geometry import FLAT, OBLIQUE, oblique_extent, oblique_mesh
from .parsed_shapes import RevolvedShape, Shape
from .polynomials import derivative, evaluate
from .revolution_geometry import is_hollow, revolution_extent, revolution_mesh
from .scene import Scene
from .sizes import turn_angles, vector
from .torus_geometry import torus_extent, torus_lines, torus_mesh
from .upright import acceleration, upright

_TURN_PIECES, _HALF_TURN_PIECES = 48, 24
"""Pieces of a turn and of a half one."""

_PATH_MARGIN = 1.25  # visible room around a path, ball radii

# Shares of a path's length: the visible margin of a plane, and the distance of a visible plane.
_PLANE_MARGIN, _PLANE_DISTANCE = 0.06, 0.25


@dataclass(frozen=True)
class Body:
    """The geometry of a body or an end.

    Attributes
    ----------
    name
        Its own.
    mesh
        Its triangles.
    behind
        Whether what faces the eye hides no ball: a plane, or what is touched from inside.
    lines
        Edges without a thickness, (k, 2, 3).
    """

    name: str
    mesh: Mesh
    behind: bool
    lines: Floats


@dataclass(frozen=True)
class SceneGeometry:
    """The visible geometry of a scene, at one value of each parameter.

    Attributes
    ----------
    scene
        As its author wrote it.
    values
        Of the inputs, by name.
    """

    scene: Scene
    values: Mapping[str, float]

    @classmethod
    def from_engine(cls, engine: CompiledScene, parameters: Mapping[str, Any]) -> SceneGeometry:
        """Return the geometry of a scene, at the means of parameters that differ by shot.

        Parameters
        ----------
        engine
            The compiled scene.
        parameters
            Its parameters, each a number or (n,).

        Raises
        ------
        ValueError
            If the scene has no pieces that could be drawn.
        """
        scene = scene_pieces(engine)
        own = zip(scene.inputs, scene.values(means(parameters)), strict=True)
        return cls(scene, {one.name: float(value) for one, value in own})

    @property
    def ball_radius(self) -> float:
        """The ball's radius, m."""
        return self._number(self.scene.read.ball_radius)

    @property
    def gravity(self) -> float:
        """The size of gravity, m/s²."""
        return float(np.linalg.norm(self.acceleration))

    @cached_property
    def acceleration(self) -> Floats:
        """The acceleration of free fall, (3,), m/s²."""
        return acceleration(self.scene.read, self.values)

    @cached_property
    def upright(self) -> tuple[NDArray[np.float64], tuple[str, str, str]]:
        """The rotation (3, 3) that turns gravity down, and the names of the axes after it."""
        return upright(self.scene.read, self.values)

    def turned(self, room: Box) -> Floats:
        """Return the lowest and the highest corner (2, 3) of a room after that rotation.

        Parameters
        ----------
        room
            Its lowest and its highest corner.
        """
        corners = np.stack(np.meshgrid(*np.stack(room).T, indexing="ij"), axis=-1).reshape(-1, 3)
        corners = corners @ self.upright[0].T
        return np.stack([corners.min(axis=0), corners.max(axis=0)])

    @cached_property
    def axis(self) -> int | None:
        """The common axis of all cylinders, when upright; None if there is none."""
        axes = {shape.axis[0] for shape in self.scene.read.bodies if shape.kind == "cylinder"}
        if len(axes) != 1:
            return None
        along = np.flatnonzero(self.upright[0][:, axes.pop()])
        return int(along[0]) if len(along) == 1 else None

    @cached_property
    def planar(self) -> bool:
        """True if nothing changes along that axis: all curved bodies are cylinders."""
        bodies = self.scene.read.bodies
        along = {shape.axis[0] for shape in bodies if shape.kind == "cylinder"}
        if {shape.kind for shape in bodies} - {"plane", "box"} != {"cylinder"} or len(along) > 1:
            return False
        (axis,) = along
        bounds = (terms for shape in bodies for terms in shape.bounds if not is_along(terms, axis))
        changes = any(powers[axis] for terms in bounds for powers, _ in terms)
        return self.axis is not None and not changes

    def side(self, size: Floats) -> int:
        """Return which axis a side view looks along, 0 or 1, when upright.

        It is that of the cylinders, else that along which paths, of a size (3,), are shorter.
        """
        axis = self.axis
        return axis if axis is not None and axis < 2 else int(size[1] <= size[0])

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The names of the bodies."""
        return tuple(shape.name for shape in self.scene.read.bodies)

    def _number(self, formula: Formula) -> float:
        return float(formula.evaluate(self.values))

    def room(self, low: Floats, high: Floats) -> Box:
        """Return the room that contains paths between two corners, and the bodies near them.

        Parameters
        ----------
        low, high
            The lowest and highest coordinates of the paths, (3,) each, m.
        """
        air = _PATH_MARGIN * self.ball_radius
        low, high = low - air, high + air
        reach = float((high - low).max())
        corners = [low, high]
        for shape in self.scene.read.bodies:
            first, last = (np.array(side) for side in self._extent(shape, (low, high)))
            within = np.all((first <= high + reach) & (last >= low - reach))
            if shape.kind not in ("plane", "inclined plane", "surface") and within:
                first = np.where(np.isfinite(first), np.maximum(first, low - reach), low)
                last = np.where(np.isfinite(last), np.minimum(last, high + reach), high)
                corners += [first, last]
        low, high = np.min(corners, axis=0), np.max(corners, axis=0)
        planes = [shape for shape in self.scene.read.bodies if shape.kind == "plane"]
        if planes or any(shape.kind == "inclined plane" for shape in self.scene.read.bodies):
            low, high = low - _PLANE_MARGIN * reach, high + _PLANE_MARGIN * reach
        for shape in planes:
            axis, way = shape.axis
            at = way * self._number(shape["at"])
            if low[axis] - _PLANE_DISTANCE * reach <= at <= high[axis] + _PLANE_DISTANCE * reach:
                low[axis], high[axis] = min(low[axis], at), max(high[axis], at)
        return low, high

    def bodies(self, room: Box) -> list[Body]:
        """Return the bodies, cut to a room."""
        return [self._body(shape, room) for shape in self.scene.read.bodies]

    def ends(self, room: Box) -> list[Body]:
        """Return the ends; a plane without bounds reaches through the room."""
        found = []
        for shape in self.scene.read.ends:
            axis, way = shape.axis
            at = way * self._number(shape["at"])
            if room[0][axis] <= at <= room[1][axis]:
                mesh = flat(axis, way, at, room, 0.0, self._bounds(shape.bounds))
                found.append(Body(shape.name, mesh, behind=True, lines=np.empty((0, 2, 3))))
        return found

    # One body

    def _body(self, shape: Shape, room: Box) -> Body:
        if isinstance(shape, RevolvedShape):
            bounds = self._bounds(shape.bounds)
            mesh = revolution_mesh(shape, self._number, bounds, room, self.ball_radius)
            return Body(shape.name, mesh, is_hollow(shape), np.empty((0, 2, 3)))
        if shape.kind in OBLIQUE:
            bounds = self._bounds(shape.bounds)
            mesh = oblique_mesh(shape, self._number, bounds, room, self.ball_radius)
            return Body(shape.name, mesh, shape.kind in FLAT or shape.inside, np.empty((0, 2, 3)))
        made = {
            "plane": self._plane,
            "sphere": self._sphere,
            "torus": self._torus,
            "oblique torus": self._torus,
            "box": self._box,
            "oblique box": self._box,
            "surface": self._surface,
        }[shape.kind](shape, room)
        lines = np.empty((0, 2, 3))
        if shape.kind.endswith("torus"):
            lines = torus_lines(shape, self._number, self._bounds(shape.bounds))
        return Body(shape.name, made, shape.kind == "plane" or shape.inside, lines)

    def _plane(self, shape: Shape, room: Box) -> Mesh:
        axis, way = shape.axis
        at = way * self._number(shape["at"])
        if not room[0][axis] <= at <= room[1][axis]:
            return Mesh.from_corners(np.empty((0, 3, 6)))
        return flat(axis, way, at, room, self.ball_radius, self._bounds(shape.bounds))

    def _sphere(self, shape: Shape, room: Box) -> Mesh:
        u = turn_angles(_TURN_PIECES)
        v = np.linspace(0.0, np.pi, _HALF_TURN_PIECES + 1)
        unit = np.stack(
            [
                np.sin(v)[:, None] * np.cos(u),
                np.sin(v)[:, None] * np.sin(u),
                np.broadcast_to(np.cos(v)[:, None], (len(v), len(u))),
            ],
            -1,
        )
        unit[0], unit[-1] = (0.0, 0.0, 1.0), (0.0, 0.0, -1.0)
        points = vector(shape, self._number, "centre") + self._number(shape["radius"]) * unit
        normals = -unit if shape.inside else unit
        corners = grid(contact_mesh(points, normals, self.ball_radius), (False, True))
        if shape.inside:
            corners = corners[:, ::-1]
        real = ~np.all(corners == np.roll(corners, -1, axis=1), axis=2).any(axis=1)
        whole = Mesh.from_corners(corners[real])
        return cut(whole, self._bounds(shape.bounds), walls(room))

    def _torus(self, shape: Shape, room: Box) -> Mesh:
        bounds = self._bounds(shape.bounds)
        return torus_mesh(shape, self._number, bounds, room, self.ball_radius)

    def _box(self, shape: Shape, room: Box) -> Mesh:
        bounds = self._bounds(shape.bounds)
        return cut(box_mesh(shape, self._number, bounds, self.ball_radius), (), walls(room))

    def _surface(self, shape: Shape, room: Box) -> Mesh:
        condition = self._bounds([shape.condition])[0]
        terms = [(powers, self._number(factor)) for powers, factor in shape.condition]

        def gradient(points: Floats) -> Floats:
            return np.stack([evaluate(derivative(terms, k), points) for k in range(3)], -1)

        whole = level_set(condition, gradient, room, self.ball_radius)
        return cut(whole, self._bounds(shape.bounds), walls(room))

    # Its data

    def _extent(self, shape: Shape, near: Box) -> tuple[list[float], list[float]]:
        """Return the corners of the box that contains a body, as far as it is beside another."""
        if isinstance(shape, RevolvedShape):
            return revolution_extent(shape, self._number)
        if shape.kind in BOXES:
            return box_extent(shape, self._number)
        if shape.kind in OBLIQUE:
            return oblique_extent(shape, self._number, near)
        if shape.kind.endswith("torus"):
            return torus_extent(shape, self._number)
        if shape.kind in ("plane", "surface"):
            return [-np.inf] * 3, [np.inf] * 3
        centre, radius = vector(shape, self._number, "centre"), self._number(shape["radius"])
        return (centre - radius).tolist(), (centre + radius).tolist()

    def _bounds(self, bounds: Sequence[Terms]) -> list[Bound]:
        def bound(terms: Terms) -> Bound:
            numbers = [(powers, self._number(factor)) for powers, factor in terms]
            return lambda points: evaluate(numbers, points)

        return [bound(terms) for terms in bounds]
