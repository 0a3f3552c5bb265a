"""Bodies of a scene other than the hoop as triangles for the page, with gravity down."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.colours import body_colours, face_colours
from hoopgen.core.parameters import means
from hoopgen.results.shots import Shots
from hoopgen.results.trajectory import Trajectory
from hoopgen.scene.engine_pieces import scene_pieces
from hoopgen.scene.geometry import Body, SceneGeometry
from hoopgen.scene.mesh_lines import chains, loops
from hoopgen.scene.upright import acceleration

ROLL_PIECE_DURATION = 2.0**-7
"""s, of a roll: between its ends a cubic is off by less than 1e-6 m; longer where it lasts long."""

_DIGITS = 6
"""Significant, of a corner of a body: finer than can be seen."""

_SAME_DIRECTION = 1e-9
"""Difference of unit vectors that cannot be seen in a picture."""

Floats = NDArray[np.float64]


def scenery(
    shots: Shots, parameters: Mapping[str, Any], paths: Iterable[Trajectory]
) -> tuple[dict[str, Any], dict[str, str]]:
    """Return the scene of shots for the page, and its colours by their names in the style.

    Of parameters that differ, the mean is drawn. No name of a scene's author is in a style: bodies
    are body-0, body-1, ... there, and themselves drawn in face-0, face-1, ...

    Parameters
    ----------
    shots
        The recorded shots.
    parameters
        The scene's parameters.
    paths
        The shots' trajectories.
    """
    valid = shots.outcome != shots.scene.outcomes["INVALID"]
    seen = SceneGeometry.from_engine(shots.scene, means(parameters, valid))
    _check_direction(shots, parameters)
    turn, axes = seen.upright
    low, high = _path_corners(paths)
    room = seen.room(low, high)
    own, drawn_in = body_colours(seen.names), face_colours(seen.names)
    corners = seen.turned(room)
    named = {f"body-{k}": own[name] for k, name in enumerate(seen.names)}
    named |= {f"face-{k}": drawn_in[name] for k, name in enumerate(seen.names)}
    hoop = shots.scene.has_hoop  # with the board on the left
    along = 1 if hoop else seen.side(np.abs(turn) @ (high - low))
    found = {
        "axes": axes,
        "views": _views(seen.axis if seen.planar else None),
        "side": [1, 0, 0] if along == 0 else [0, -1, 0],
        "plain": not hoop,
        "room": corners.tolist(),
        "step": float(10.0 ** np.floor(np.log10((corners[1] - corners[0]).max() / 3.0))),
        "bodies": [_body(body, turn) for body in seen.bodies(room)],
        "ends": [line for end in seen.ends(room) for line in _lines(end.mesh.rims, turn)],
    }
    return found, named


def _check_direction(shots: Shots, parameters: Mapping[str, Any]) -> None:
    """Raise unless all shots have one direction of gravity, which the page shows as down."""
    written = scene_pieces(shots.scene)
    inputs = zip(written.inputs, written.values(parameters), strict=True)
    pull = acceleration(written.read, {one.name: value for one, value in inputs}).reshape(-1, 3)
    size = np.linalg.norm(pull, axis=1, keepdims=True)
    ways = (pull / np.where(size > 0.0, size, 1.0))[size[:, 0] > 0.0]
    if len(ways) and float(np.ptp(ways, axis=0).max()) > _SAME_DIRECTION:
        raise ValueError(
            "view: the direction of gravity differs from shot to shot; a page shows shots that "
            "have the same one"
        )


def turn_vectors(shots: Shots, parameters: Mapping[str, Any], states: Floats) -> Floats:
    """Return vectors, three columns each, turned so that gravity points down.

    Parameters
    ----------
    shots
        The shots, whose scene says where gravity points.
    parameters
        The scene's parameters, each a number or (n,).
    states
        Vectors, (..., 3 k).
    """
    if shots.scene.is_hoop:
        return states
    turn, _ = SceneGeometry.from_engine(shots.scene, parameters).upright
    return np.asarray((states.reshape(-1, 3) @ turn.T).reshape(states.shape))


def flight_parameters(shots: Shots, parameters: Mapping[str, Any], row: int) -> dict[str, float]:
    """Return the parameters of one shot that flights and the ball need.

    Parameters
    ----------
    shots
        The shots.
    parameters
        The scene's parameters, each a number or (n,).
    row
        The row of the shot.
    """
    own = {name: np.broadcast_to(v, len(shots))[row] for name, v in parameters.items()}
    seen = SceneGeometry.from_engine(shots.scene, own)
    return {"ball_radius": seen.ball_radius, "gravity": seen.gravity}


def ball_radius(shots: Shots, values: Mapping[str, Any]) -> Any:
    """Return the ball's radius, one or (n,).

    Parameters
    ----------
    shots
        The shots.
    values
        The scene's parameters, each a number or (n,).
    """
    written = scene_pieces(shots.scene)
    own = dict(zip((one.name for one in written.inputs), written.values(values), strict=True))
    found = np.asarray(written.read.ball_radius.evaluate(own), dtype=np.float64)
    return found if found.ndim else float(found)


def _path_corners(paths: Iterable[Trajectory]) -> tuple[Floats, Floats]:
    """Return the corners of the box that contains all paths, apexes included."""
    points = []
    for path in paths:
        times, states, rolling = path.pieces(ROLL_PIECE_DURATION)
        flights = np.flatnonzero(~rolling[:-1])
        some = np.linspace(0.0, 1.0, 9)[1:-1] * np.diff(times)[flights, None]
        flown = path.at(times[flights, None] + some)
        points += [states[:, :3], flown[..., :3].reshape(-1, 3)]
    rows = np.concatenate(points)
    return rows.min(axis=0), rows.max(axis=0)


def _views(across: int | None) -> list[str]:
    """Return the page's views, the default first; a planar scene has its plane's."""
    return {
        None: ["3D", "Side", "Top"],
        2: ["Top", "3D", "Side"],
    }.get(across, ["Side", "3D", "Top"])


def _body(body: Body, turn: NDArray[np.float64]) -> dict[str, Any]:
    corners = body.mesh.corners.reshape(-1, 6)
    rows, index = np.unique(corners, axis=0, return_inverse=True)
    flat = body.behind and _is_flat(body)
    return {
        "flat": flat,
        "inside": body.behind and not flat,
        "points": _round(rows[:, :3] @ turn.T).tolist(),
        "triangles": index.ravel().tolist(),
        "lines": _lines(body.lines, turn),
        "rims": _lines(_border(body) if flat else body.mesh.rims, turn),
    }


def _border(body: Body) -> Floats:
    """Return the border of a plane, (k, 2, 3), which makes it visible from the side."""
    lines = [np.stack([line[:-1], line[1:]], 1) for line in loops(body.mesh.corners[..., :3])]
    return np.concatenate([np.empty((0, 2, 3)), *lines])


def _is_flat(body: Body) -> bool:
    ways = (body.mesh.corners[..., 3:] - body.mesh.corners[..., :3]).reshape(-1, 3)
    return not len(ways) or bool(np.ptp(ways, axis=0).max() < 1e-9)


def _lines(segments: Floats, turn: NDArray[np.float64]) -> list[Any]:
    return [_round(line @ turn.T).tolist() for line in chains(segments)]


def _round(points: Floats) -> Floats:
    """Round numbers to a count of digits of the largest."""
    largest = float(np.abs(points).max(initial=1e-300))
    return np.asarray(np.round(points, _DIGITS - int(np.floor(np.log10(largest)))))
