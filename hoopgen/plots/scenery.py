"""What stands around the ball in a picture: the hoop as it is, or the bodies of any other scene.

Bodies are drawn in flat colours, lighter where they face the light. Of what is touched from one
side only, planes and the insides of bowls, that side is drawn: the other one would hide the ball.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any, Protocol

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from numpy.typing import NDArray

from hoopgen.colours import colours, faces
from hoopgen.engines import Engine
from hoopgen.plots.outlines import (
    EDGE_ON,
    RIMS,
    draw_edge_on,
    draw_lines,
    edge_on,
    mixed,
    patch,
    spans,
)
from hoopgen.plots.scene import draw_hoop, order_of, scene_corners, scene_points
from hoopgen.plots.style import COLOURS
from hoopgen.plots.views import FRONT, SIDE, TOP, Points, View
from hoopgen.results import SURFACES
from hoopgen.scene.meshes import Mesh, chains, clip
from hoopgen.scene.seen import Body, Seen, upright

__all__ = ["Hoop", "Scenery", "scenery_of"]

_LIGHT = (-0.35, 0.5, 0.79)
"""Where the light comes from: to the right, up and towards the eye."""

_TONES = ((-2.0, 0.0), (0.1, 0.12), (0.4, 0.26), (0.65, 0.4), (0.85, 0.54))
"""Least share of the light, and how far a colour then is on the way to white."""

_PALE = 0.34
"""How much further what is seen from inside is, so that paths stand out before it."""

_FAINT = 0.13  # opacity of a plane
_PLANES, _INSIDES, _ENDS = 3.0, 3.5, 5.0  # drawing order, below paths
_FLAT = 1e-6
"""How far off a plane a path in it may be: m at a hoop, else of the path's size."""
_SPREAD = 4.0  # of the drawing order, over the depth of a room
_OBSTACLES = 600


class Scenery(Protocol):
    """What of a scene is drawn, in metres, with gravity down."""

    @property
    def ball_radius(self) -> float:
        """Of the ball, m."""

    @property
    def names(self) -> tuple[str, ...]:
        """Of what can be touched, in the order of results."""

    @property
    def colours(self) -> Mapping[str, str]:
        """Of what can be touched, by name."""

    @property
    def axes(self) -> tuple[str, str, str]:
        """What the axes are called, with a minus where one is turned round."""

    def upright(self, points: Points) -> Points:
        """Return points (..., 3) turned so that gravity points down."""

    @property
    def ball(self) -> str:
        """The colour of the ball, by its name in `COLOURS`: at a hoop it is a basketball."""

    @property
    def said_of_ends(self) -> str:
        """Return the entry of the key for the lines where shots end; empty where there are none."""

    def views(self, path: Points) -> tuple[View, ...]:
        """Return the flat views that show a path, upright, (n, 3): the one that shows most first.

        Their axes are named as `axes` says. There is one alone where any other would show lines.
        """

    def is_in_plane(self, path: Points) -> bool:
        """Return whether a path, upright, (n, 3), is in one plane, which a flat view shows."""

    @property
    def small(self) -> bool:
        """Whether it may be much smaller than a hoop, so that ticks lie closer."""

    def look(self, view: View) -> View:
        """Return a view that orders what is drawn as this needs."""

    def corners(self) -> Points:
        """Return points that span it."""

    def points(self) -> Points:
        """Return points all along it, which labels leave visible."""

    def draw(self, axes: Axes, view: View, scale: float) -> None:
        """Draw it; `scale` is inches of the picture per metre."""

    def draw_ends(self, axes: Axes, view: View) -> None:
        """Draw where shots end, in a flat view."""


@dataclass(frozen=True)
class Hoop:
    """Ring, backboard and bridge."""

    parameters: Mapping[str, float]
    names: tuple[str, ...] = SURFACES
    axes: tuple[str, str, str] = ("x", "y", "z")

    @property
    def ball_radius(self) -> float:
        """Of the ball, m."""
        return self.parameters["ball_radius"]

    @property
    def colours(self) -> Mapping[str, str]:
        """Of what it is made of."""
        return COLOURS

    @property
    def ball(self) -> str:
        """That of a basketball."""
        return "ball"

    @property
    def said_of_ends(self) -> str:
        """There is one plane."""
        return "end plane"

    def views(self, path: Points) -> tuple[View, ...]:
        """Return the views from the side and from above: the board is on the left."""
        return SIDE, TOP

    def is_in_plane(self, path: Points) -> bool:
        """Return whether a path is in the hoop's own plane of symmetry."""
        return bool(np.abs(path[:, 1]).max() <= _FLAT)

    @property
    def small(self) -> bool:
        """A hoop is as large as it is."""
        return False

    def upright(self, points: Points) -> Points:
        """Return the points: the hoop's gravity points down."""
        return points

    def look(self, view: View) -> View:
        """Return the view."""
        return view

    def corners(self) -> Points:
        """Return points that span it."""
        return scene_corners(self.parameters)

    def points(self) -> Points:
        """Return points all along it."""
        return scene_points(self.parameters)

    def draw(self, axes: Axes, view: View, scale: float) -> None:
        """Draw it."""
        draw_hoop(axes, view, self.parameters, scale)

    def draw_ends(self, axes: Axes, view: View) -> None:
        """Draw the end plane where it is seen edge on."""
        if view.up[2] == 1.0:
            depth = -self.parameters["end_depth"]
            axes.axhline(depth, color=COLOURS["end"], lw=0.7, ls=(0, (5, 3)), zorder=_ENDS)


def scenery_of(scene: Engine, parameters: Mapping[str, Any], paths: Points) -> Scenery:
    """Return what is drawn around paths.

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
        return Hoop(parameters)
    seen = Seen.of(scene, parameters)
    turn, names = upright(seen.scene.read.down)
    room = seen.room(paths.min(axis=0), paths.max(axis=0))
    bodies = tuple(_turned(body, turn) for body in seen.bodies(room))
    ends = tuple(_turned(body, turn) for body in seen.ends(room))
    span = np.sort(np.stack(room) @ turn.T, axis=0)
    own = colours(seen.names)
    drawn = bodies, ends, span
    return _Bodies(seen.ball_radius, seen.names, own, names, turn, *drawn, scene.has_hoop, seen)


def _turned(body: Body, turn: NDArray[np.int64]) -> Body:
    mesh = body.mesh
    points = np.stack([mesh.corners[..., :3], mesh.corners[..., 3:]], -2) @ turn.T
    corners = points.reshape(*points.shape[:2], 6)
    return replace(
        body, mesh=Mesh(corners, mesh.rims @ turn.T, mesh.parts), lines=body.lines @ turn.T
    )


@dataclass(frozen=True)
class _Bodies:
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
    turn: NDArray[np.int64]
    bodies: tuple[Body, ...]
    ends: tuple[Body, ...]
    room: Points
    has_hoop: bool
    seen: Seen

    @property
    def ball(self) -> str:
        return "ball" if self.has_hoop else "plain-ball"

    @property
    def small(self) -> bool:
        return True

    @property
    def said_of_ends(self) -> str:
        return "where shots end" if self.ends else ""

    def views(self, path: Points) -> tuple[View, ...]:
        if self.has_hoop:
            return SIDE, TOP
        size = np.ptp(path, axis=0)
        along = (FRONT, SIDE, TOP)  # by the axis that they look along
        flat, side = size <= _FLAT * size.max(), self.seen.side(size)
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
            return bool(np.abs(path[:, 1]).max() <= _FLAT)
        size = np.ptp(path, axis=0)
        return bool(size.min() <= _FLAT * size.max())

    def upright(self, points: Points) -> Points:
        return np.asarray(points @ self.turn.T)

    def look(self, view: View) -> View:
        middle = float(view.depth(self.room.mean(axis=0)))
        size = float(np.linalg.norm(self.room[1] - self.room[0]))
        return replace(view, middle=middle, near=_SPREAD / size)

    def corners(self) -> Points:
        grid = np.stack(np.meshgrid(*self.room.T, indexing="ij"), axis=-1)
        return grid.reshape(-1, 3)

    def points(self) -> Points:
        solid = [body.mesh.corners[:, 0, :3] for body in self.bodies if not body.behind]
        lines = [part.reshape(-1, 3) for b in self.bodies for part in (b.mesh.rims, b.lines)]
        found = np.concatenate([np.empty((0, 3)), *solid, *lines])
        return found[:: max(1, len(found) // _OBSTACLES)]

    def draw(self, axes: Axes, view: View, scale: float) -> None:
        light = np.array(_LIGHT) @ np.array([view.right, view.up, view.towards])
        drawn = faces(self.names)
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
            outline = [view.flatten(line) for line in chains(end.mesh.rims)]
            if edge_on(end.mesh, view):
                outline = spans(view.flatten(end.mesh.corners[..., :3]))
            lines = LineCollection(
                outline,
                colors=COLOURS["end"],
                linewidths=0.7,
                linestyles=[(0, (5, 3))],
                zorder=_ENDS,
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
            axes.add_collection(LineCollection(lines, colors=[colour], linewidths=1.1, zorder=RIMS))
            return
        facing = self._normals(corners) @ view.towards
        corners = clip(corners, -facing)[0]
        if not len(corners):
            draw_edge_on(axes, view, body.mesh.corners, facing, colour)
            return
        if np.ptp(self._normals(corners).reshape(-1, 3), axis=0).max() < EDGE_ON:
            axes.add_patch(patch(corners, view, fc=colour, alpha=_FAINT, lw=0.0, zorder=_PLANES))
            return
        self._draw_toned(axes, view, corners, light, colour, _INSIDES, _PALE)

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
            order = order_of(view, own[..., :3].reshape(-1, 3).mean(axis=0))
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
                tone = mixed(colour, white + pale * (1.0 - white))
                axes.add_patch(patch(left, view, fc=tone, ec=tone, lw=0.3, zorder=order))
