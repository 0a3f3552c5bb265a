"""Surroundings of the ball in a picture: the hoop, or the bodies of any other scene.

Bodies are drawn in flat colours, lighter where they face the light. Of what is touched from one
side only, planes and the insides of bowls, that side is drawn: the other one would hide the ball.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any, Protocol

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from numpy.typing import NDArray

from hoopgen.core.colours import body_colours, face_colours
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.results.shots import SURFACES
from hoopgen.scene.geometry import Body, SceneGeometry
from hoopgen.scene.meshes import Mesh, clip

from .hoop import draw_hoop, drawing_order, scene_corners, scene_points
from .outlines import (
    EDGE_ON,
    RIM_ORDER,
    draw_edge_on,
    draw_lines,
    edge_on,
    flat_chains,
    merge_triangles,
    mix_with_white,
    spans,
)
from .style import COLOURS
from .views import FRONT, SIDE, TOP, Points, View

_LIGHT_DIRECTION = (-0.35, 0.5, 0.79)
"""Direction towards the light: to the right, up and towards the eye."""

# The least share of the light, and the share of white in a colour from there on.
_TONES = ((-2.0, 0.0), (0.1, 0.12), (0.4, 0.26), (0.65, 0.4), (0.85, 0.54))

_INSIDE_LIGHTENING = 0.34  # more white in insides, so that paths stand out before them
_SEAM_WIDTH = 0.7  # points of the edges that close the seams of shapes: most of a pixel at 72 dpi
_PLANE_OPACITY = 0.13  # opacity of a plane
_PLANE_ORDER, _INSIDE_ORDER, _END_ORDER = 3.0, 3.5, 5.0  # drawing order, below paths
_FLATNESS = 1e-6  # distance of a planar path from its plane: m at a hoop, else of its size
_ORDER_RANGE = 4.0  # of the drawing order, over the depth of a room
_MAX_OBSTACLES = 600


class Scenery(Protocol):
    """The bodies of a scene in a picture, in metres, with gravity down.

    Attributes
    ----------
    ball_radius
        The ball's radius, m.
    names, colours
        The bodies, in the order of results, and their colours by name.
    axes
        The labels of the axes, with a minus if one is reversed.
    ball
        The name of the ball's colour in `COLOURS`; at a hoop it is a basketball's.
    said_of_ends
        The legend's entry for the lines at which shots end, "" if there are none.
    small
        True if it may be much smaller than a hoop and needs closer ticks.
    """

    ball_radius: float
    names: tuple[str, ...]
    colours: Mapping[str, str]
    axes: tuple[str, str, str]
    ball: str
    said_of_ends: str
    small: bool

    def upright(self, points: Points) -> Points:
        """Return points (..., 3) turned so that gravity points down."""
        return points

    def views(self, path: Points) -> tuple[View, ...]:
        """Return the flat views of an upright path (n, 3), the one that shows most first.

        Their axes are named as `axes` says. There is one alone where any other would show lines.
        """
        return SIDE, TOP

    def is_in_plane(self, path: Points) -> bool:
        """Return whether an upright path (n, 3) lies in one plane, which a flat view shows."""
        return bool(np.abs(path[:, 1]).max() <= _FLATNESS)

    def look(self, view: View) -> View:
        """Return a view with the drawing order that this scene needs."""
        return view

    def corners(self) -> Points:
        """Return points that span it."""
        ...

    def points(self) -> Points:
        """Return points along it, which labels leave visible."""
        ...

    def draw(self, axes: Axes, view: View, scale: float) -> None:
        """Draw the bodies.

        Parameters
        ----------
        axes, view
            The axes and the view.
        scale
            Inches of the picture per metre.
        """

    def draw_ends(self, axes: Axes, view: View) -> None:
        """Draw the ends of shots in a flat view.

        Parameters
        ----------
        axes, view
            The axes and the view.
        """


@dataclass(frozen=True)
class _Hoop(Scenery):
    """Ring, backboard and bridge: the board is on the left."""

    parameters: Mapping[str, float]
    ball_radius: float
    names: tuple[str, ...] = SURFACES
    colours: Mapping[str, str] = field(default_factory=lambda: COLOURS)
    axes: tuple[str, str, str] = ("x", "y", "z")
    ball: str = "ball"
    said_of_ends: str = "end plane"
    small: bool = False

    def corners(self) -> Points:
        return scene_corners(self.parameters)

    def points(self) -> Points:
        return scene_points(self.parameters)

    def look(self, view: View) -> View:
        if view.towards[0] < EDGE_ON:
            return view
        return replace(view, wall=-self.parameters["board_distance"])

    def draw(self, axes: Axes, view: View, scale: float) -> None:
        draw_hoop(axes, view, self.parameters, scale)

    def draw_ends(self, axes: Axes, view: View) -> None:
        """Draw the end plane if it appears as a line."""
        if view.up[2] == 1.0:
            depth = -self.parameters["end_depth"]
            axes.axhline(depth, color=COLOURS["end"], lw=0.7, ls=(0, (5, 3)), zorder=_END_ORDER)


def scenery_of(scene: CompiledScene, parameters: Mapping[str, Any], paths: Points) -> Scenery:
    """Return the surroundings of paths.

    Parameters
    ----------
    scene
        Whose.
    parameters
        Of it; of those that differ from shot to shot, the mean is drawn.
    paths
        Points of all of them, (n, 3).
    """
    if scene.is_hoop:
        return _Hoop(parameters, parameters["ball_radius"])
    seen = SceneGeometry.from_engine(scene, parameters)
    turn, names = seen.upright
    room = seen.room(paths.min(axis=0), paths.max(axis=0))
    bodies = tuple(_turn_body(body, turn) for body in seen.bodies(room))
    ends = tuple(_turn_body(body, turn) for body in seen.ends(room))
    span = seen.turned(room)
    own = body_colours(seen.names)
    return _Bodies(
        *(seen.ball_radius, seen.names, own, names, turn, bodies, ends, span, scene.has_hoop, seen),
        ball="ball" if scene.has_hoop else "plain-ball",
        said_of_ends="where shots end" if ends else "",
    )


def _turn_body(body: Body, turn: NDArray[np.float64]) -> Body:
    mesh = body.mesh
    points = np.stack([mesh.corners[..., :3], mesh.corners[..., 3:]], -2) @ turn.T
    corners = points.reshape(*points.shape[:2], 6)
    return replace(
        body, mesh=Mesh(corners, mesh.rims @ turn.T, mesh.parts), lines=body.lines @ turn.T
    )


@dataclass(frozen=True)
class _Bodies(Scenery):
    """Bodies of a scene.

    Attributes
    ----------
    room
        Its lowest and its highest corner.
    has_hoop
        Whether there is a hoop, and the ball a basketball.
    seen
        What they are made of.
    """

    ball_radius: float
    names: tuple[str, ...]
    colours: Mapping[str, str]
    axes: tuple[str, str, str]
    turn: NDArray[np.float64]
    bodies: tuple[Body, ...]
    ends: tuple[Body, ...]
    room: Points
    has_hoop: bool
    seen: SceneGeometry
    ball: str
    said_of_ends: str
    small: bool = True

    def views(self, path: Points) -> tuple[View, ...]:
        if self.has_hoop:
            return super().views(path)
        size = np.ptp(path, axis=0)
        along = (FRONT, SIDE, TOP)  # by the axis that they look along
        flat, side = size <= _FLATNESS * size.max(), self.seen.side(size)
        axis = self.seen.axis
        if self.seen.planar and axis is not None:
            views = (along[axis],) if flat[axis] else (along[axis], along[side if axis == 2 else 2])
        elif flat.any() and not flat[side]:
            axis = int(np.argmax(flat))
            views = (along[axis], along[side if axis == 2 else 2])
        else:
            views = (along[side], TOP)
        named = dict(zip("xyz", self.axes, strict=True))
        return tuple(
            replace(view, labels=(named[view.labels[0]], named[view.labels[1]]))
            for view in views
            if view.labels is not None
        )

    def is_in_plane(self, path: Points) -> bool:
        if self.has_hoop:
            return super().is_in_plane(path)
        size = np.ptp(path, axis=0)
        return bool(size.min() <= _FLATNESS * size.max())

    def upright(self, points: Points) -> Points:
        return np.asarray(points @ self.turn.T)

    def look(self, view: View) -> View:
        middle = float(view.depth(self.room.mean(axis=0)))
        size = float(np.linalg.norm(self.room[1] - self.room[0]))
        return replace(view, middle=middle, near=_ORDER_RANGE / size)

    def corners(self) -> Points:
        grid = np.stack(np.meshgrid(*self.room.T, indexing="ij"), axis=-1)
        return grid.reshape(-1, 3)

    def points(self) -> Points:
        solid = [body.mesh.corners[:, 0, :3] for body in self.bodies if not body.behind]
        lines = [part.reshape(-1, 3) for b in self.bodies for part in (b.mesh.rims, b.lines)]
        found = np.concatenate([np.empty((0, 3)), *solid, *lines])
        return found[:: max(1, len(found) // _MAX_OBSTACLES)]

    def draw(self, axes: Axes, view: View, scale: float) -> None:
        light = np.array(_LIGHT_DIRECTION) @ np.array([view.right, view.up, view.towards])
        drawn = face_colours(self.names)
        for body in self.bodies:
            colour = drawn[body.name]
            if body.behind:
                self._draw_behind(axes, view, body, light, colour)
            else:
                self._draw_solid(axes, view, body, light, colour)
            for lines, wide in ((body.mesh.rims, 0.7), (body.lines, 1.4)):
                draw_lines(axes, view, lines, colour, wide, behind=body.behind)

    def draw_ends(self, axes: Axes, view: View) -> None:
        for end in self.ends:
            outline = flat_chains(view, end.mesh.rims)
            if edge_on(end.mesh, view):
                outline = spans(view.flatten(end.mesh.corners[..., :3]))
            lines = LineCollection(
                outline,
                colors=COLOURS["end"],
                linewidths=0.7,
                linestyles=[(0, (5, 3))],
                zorder=_END_ORDER,
            )
            axes.add_collection(lines)

    # One body

    def _normals(self, corners: Points) -> Points:
        return np.asarray((corners[..., 3:] - corners[..., :3]) / self.ball_radius)

    def _draw_behind(self, axes: Axes, view: View, body: Body, light: Points, colour: str) -> None:
        """Draw a plane, or the far side of what is touched from inside."""
        corners = body.mesh.corners
        if edge_on(body.mesh, view):
            lines = spans(view.flatten(corners[..., :3]))
            axes.add_collection(
                LineCollection(lines, colors=[colour], linewidths=1.1, zorder=RIM_ORDER)
            )
            return
        facing = self._normals(corners) @ view.towards
        corners = clip(corners, -facing)[0]
        if not len(corners):
            draw_edge_on(axes, view, body.mesh.corners, facing, colour)
            return
        if np.ptp(self._normals(corners).reshape(-1, 3), axis=0).max() < EDGE_ON:
            axes.add_patch(
                merge_triangles(
                    corners, view, fc=colour, alpha=_PLANE_OPACITY, lw=0.0, zorder=_PLANE_ORDER
                )
            )
            return
        self._draw_toned(axes, view, corners, light, colour, _INSIDE_ORDER, _INSIDE_LIGHTENING)

    def _draw_solid(self, axes: Axes, view: View, body: Body, light: Points, colour: str) -> None:
        facing = self._normals(body.mesh.corners) @ view.towards
        corners, _, rows = clip(body.mesh.corners, -facing)
        if not len(corners):
            draw_edge_on(axes, view, body.mesh.corners, facing, colour)
        # Those of about one depth are drawn as one.
        depths = view.depth(corners[..., :3].mean(axis=1)) / (view.near * self.ball_radius)
        total = np.bincount(body.mesh.parts[rows], depths)
        count = np.bincount(body.mesh.parts[rows])
        parts = np.round(total / np.maximum(count, 1))[body.mesh.parts[rows]]
        for part in np.unique(parts):
            own = corners[parts == part]
            order = drawing_order(view, own[..., :3].reshape(-1, 3).mean(axis=0))
            self._draw_toned(axes, view, own, light, colour, order, 0.0)

    def _draw_toned(
        self,
        axes: Axes,
        view: View,
        corners: Points,
        light: Points,
        colour: str,
        order: float,
        pale: float,
    ) -> None:
        for (least, white), (most, _) in pairwise((*_TONES, (2.0, 0.0))):
            left = clip(corners, least - self._normals(corners) @ light)[0]
            left = clip(left, self._normals(left) @ light - most)[0]
            if len(left):
                tone = mix_with_white(colour, white + pale * (1.0 - white))
                axes.add_patch(
                    merge_triangles(left, view, fc=tone, ec=tone, lw=_SEAM_WIDTH, zorder=order)
                )
