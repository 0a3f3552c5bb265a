"""`Fan`: the projected paths of shots, with the class and the release angle of each."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.path import Path
from numpy.typing import NDArray

from hoopgen.core.parameters import ParameterValues, means, of_scene
from hoopgen.hoop.kinds import kinds
from hoopgen.results.shots import Shots
from hoopgen.results.trajectory import Trajectory

from .class_legend import CLASSES, Class, classify, outcome_classes
from .scenery import Scenery, scenery_of
from .views import Limits, Points, View, limits_around

_MARGIN = 0.02  # around what is drawn, of its size
_RING_MARGIN = 0.08  # m around ring and board
_LEVEL = 0.05  # height above a plane over width, below which paths are seen from above
_ROLL_PIECE_DURATION = 0.01  # s, of a roll: less than can be seen off a parabola


@dataclass(frozen=True)
class Fan:
    """Projected paths of the ball's centre, each with its row, its class and release angle (°).

    The article's scene has its parameters, `hoop`; there shots have kinds. `known` are the classes
    of the scene, in order.
    """

    curves: list[Path]
    rows: list[int]
    classes: list[Class]
    known: Sequence[Class]
    view: View
    scenery: Scenery
    hoop: Mapping[str, float] | None
    elevations: list[float]

    @property
    def ends(self) -> str:
        """The legend's entry for the lines at which shots end, "" if none are drawn."""
        return "" if self.hoop else self.scenery.said_of_ends

    def part(self, members: Iterable[int]) -> Fan:
        """Return a fan of some of the paths."""
        places = list(members)
        return replace(
            self,
            curves=[self.curves[place] for place in places],
            rows=[self.rows[place] for place in places],
            classes=[self.classes[place] for place in places],
            elevations=[self.elevations[place] for place in places],
        )

    def limits(self) -> Limits:
        """Return limits around all paths."""
        boxes = [curve.get_extents().get_points() for curve in self.curves]
        points = np.vstack([*boxes, self.view.flatten(self.scenery.corners())])
        return limits_around(points, _MARGIN * float(np.ptp(points, axis=0).max()))

    def near_the_ring(self) -> Limits:
        """Return limits around ring and board."""
        assert self.hoop is not None
        ring, ball = self.hoop["ring_radius"], self.hoop["ball_radius"]
        corners = self.view.flatten(self.scenery.corners())[:, 0]
        left, low = min(float(corners.min()), -ring) - _RING_MARGIN, -self.hoop["end_depth"] - ball
        return left, 3.0 * ring, low, max(3.0 * ring, low + 0.8 * (3.0 * ring - left))


def classes_of(shots: Shots) -> tuple[Sequence[Class], NDArray[np.intp]]:
    """Return the classes of a scene's shots, and the index of each shot's, intp (n,)."""
    if shots.scene.is_hoop:
        return CLASSES, classify(shots.outcome, kinds(shots.outcome, shots.counts, shots.first))
    names = [name.lower() for name in shots.scene.outcomes.__members__]
    return outcome_classes(names), np.asarray(shots.outcome, np.intp)


def gather_fan(shots: Shots, parameters: ParameterValues, drawn: Iterable[int]) -> Fan:
    """Return the paths of the valid shots; arguments as for `plot_fan`.

    Parameters
    ----------
    shots
        The recorded shots.
    parameters
        The scene's parameters.
    drawn
        The rows of the shots to draw.

    Raises
    ------
    ValueError
        If none has: short and invalid shots have not.
    """
    flown = {shot: shots.trajectory(shot) for shot in drawn}
    flown = {shot: trajectory for shot, trajectory in flown.items() if len(trajectory.events)}
    if not flown:
        raise ValueError("shots: expected one at least that touches something or ends, got none")
    curves = [bezier(trajectory) for trajectory in flown.values()]
    own = means(
        of_scene(parameters, shots.scene.table), shots.outcome != shots.scene.outcomes["INVALID"]
    )
    hoop = None
    if shots.scene.is_hoop:
        hoop = own
    points = np.concatenate([_points_of(curve) for curve in curves])
    scenery = scenery_of(shots.scene, own, points)
    releases = [trajectory.release for trajectory in flown.values()]
    view = _side_view(releases)
    if hoop is None:
        view = scenery.look(_view_of(scenery, scenery.upright(points)))
    classes, codes = classes_of(shots)
    return Fan(
        [
            Path(view.flatten(scenery.upright(c)), [Path.MOVETO, *[Path.CURVE3] * (len(c) - 1)])
            for c in curves
        ],
        [*flown],
        [classes[codes[shot]] for shot in flown],
        classes,
        view,
        scenery,
        hoop,
        [_elevation(release) for release in releases],
    )


def _points_of(curve: Points) -> Points:
    """Return points of Bézier curves (2 n + 1, 3): the ends of each, and three between."""
    start, aim, stop = curve[:-1:2], curve[1::2], curve[2::2]
    between = [
        (1.0 - t) ** 2 * start + 2.0 * t * (1.0 - t) * aim + t**2 * stop for t in (0.25, 0.5, 0.75)
    ]
    return np.concatenate([curve[::2], *between])


def _view_of(scenery: Scenery, points: Points) -> View:
    """Return the side view, or the top view of paths that are all but level.

    It is the top view, too, of paths that are all but in a plane, such as a table that leans, and
    of which the side view shows less.
    """
    side, *others = scenery.views(points)
    wide, high = np.ptp(side.flatten(points), axis=0)
    if not others or wide == 0.0 or side.up[2] != 1.0:
        return side
    if high < _LEVEL * wide:
        return others[0]
    leaning = high < np.ptp(points @ side.towards) and _off_plane(points / wide) < _LEVEL
    return others[0] if leaning else side


def _off_plane(points: Points) -> float:
    """Return the height of points (n, 3) above the plane that fits them best."""
    across = np.column_stack([points[:, :2], np.ones(len(points))])
    plane = np.linalg.lstsq(across, points[:, 2])[0]
    return float(np.ptp(points[:, 2] - across @ plane))


def _side_view(releases: list[NDArray[np.float64]]) -> View:
    """Return the view across the line from the releases to the ring."""
    x, y = np.mean([release[:2] for release in releases], axis=0)
    angle = np.arctan2(y, x)
    right = (float(np.cos(angle)), float(np.sin(angle)), 0.0)
    labels = ("from the ring's centre", "above the ring")
    return View("side view", right, (0.0, 0.0, 1.0), labels)


def _elevation(release: NDArray[np.float64]) -> float:
    """Return the angle of a release above the horizontal, degrees."""
    return float(np.degrees(np.arctan2(release[5], np.hypot(release[3], release[4]))))


def bezier(trajectory: Trajectory) -> NDArray[np.float64]:
    """Return a path as Bézier curves: its start, then two points for each flight (2 n + 1, 3).

    Each flight is a parabola, which is one quadratic Bézier curve; a roll is cut into short ones.
    """
    times, states, _ = trajectory.pieces(_ROLL_PIECE_DURATION)
    lasting = np.diff(times)[:, np.newaxis]
    start, velocity = states[:-1, :3], states[:-1, 3:6]
    points = np.stack([start + velocity * lasting / 2.0, states[1:, :3]], axis=1).reshape(-1, 3)
    return np.concatenate([states[:1, :3], points])
