"""What a page shows of any scene but the hoop: its bodies as triangles, with gravity down."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.colours import colours, faces
from hoopgen.results import Shots, Trajectory
from hoopgen.scene.drawn import drawn
from hoopgen.scene.meshes import chains, loops
from hoopgen.scene.seen import Body, Seen, upright

__all__ = ["PIECE", "ball_radius", "scenery", "shown_parameters", "turned"]

PIECE = 2.0**-7
"""s, of a roll: between its ends a cubic is off by less than 1e-6 m; longer where it lasts long."""

_DIGITS = 6
"""Significant, of a corner of a body: finer than can be seen."""

Floats = NDArray[np.float64]


def scenery(
    shots: Shots, parameters: Mapping[str, Any], paths: Iterable[Trajectory]
) -> tuple[dict[str, Any], dict[str, str]]:
    """Return the scene of shots for the page, and its colours by their names in the style.

    Of parameters that differ, the mean is drawn. No name of a scene's author is in a style: bodies
    are body-0, body-1, ... there, and themselves drawn in face-0, face-1, ...
    """
    seen = Seen.of(shots.scene, parameters)
    turn, axes = upright(seen.scene.read.down)
    low, high = _reach(paths)
    room = seen.room(low, high)
    own, drawn_in = colours(seen.names), faces(seen.names)
    corners = np.sort(np.stack(room) @ turn.T, axis=0)
    named = {f"body-{k}": own[name] for k, name in enumerate(seen.names)}
    named |= {f"face-{k}": drawn_in[name] for k, name in enumerate(seen.names)}
    hoop = shots.scene.has_hoop  # with the board on the left
    along = 1 if hoop else seen.side(np.abs(turn @ (high - low)))
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


def turned(shots: Shots, states: Floats) -> Floats:
    """Return vectors, three columns each, turned so that the gravity of shots is down."""
    if shots.scene.is_hoop:
        return states
    turn, _ = upright(drawn(shots.scene).read.down)
    return np.asarray((states.reshape(-1, 3) @ turn.T).reshape(states.shape))


def shown_parameters(shots: Shots, parameters: Mapping[str, Any], row: int) -> dict[str, float]:
    """Return what flights and balls need, of one shot."""
    own = {name: np.broadcast_to(v, len(shots))[row] for name, v in parameters.items()}
    seen = Seen.of(shots.scene, own)
    return {"ball_radius": seen.ball_radius, "gravity": seen.gravity}


def ball_radius(shots: Shots, values: Mapping[str, Any]) -> Any:
    """Return the ball's radius, one or (n,)."""
    written = drawn(shots.scene)
    own = dict(zip((one.name for one in written.inputs), written.values(values), strict=True))
    found = np.asarray(written.read.ball_radius.evaluate(own), dtype=np.float64)
    return found if found.ndim else float(found)


def _reach(paths: Iterable[Trajectory]) -> tuple[Floats, Floats]:
    """Return the corners of the box in which balls fly and roll, apexes included."""
    points = []
    for path in paths:
        times, states, rolling = path.pieces(PIECE)
        flights = np.flatnonzero(~rolling[:-1])
        some = np.linspace(0.0, 1.0, 9)[1:-1] * np.diff(times)[flights, None]
        flown = path.at(times[flights, None] + some)
        points += [states[:, :3], flown[..., :3].reshape(-1, 3)]
    rows = np.concatenate(points)
    return rows.min(axis=0), rows.max(axis=0)


def _views(across: int | None) -> list[str]:
    """Return the views to choose from, the first one first: of a plane that in which it is."""
    return {
        None: ["3D", "Side", "Top"],
        2: ["Top", "3D", "Side"],
    }.get(across, ["Side", "3D", "Top"])


def _body(body: Body, turn: NDArray[np.int64]) -> dict[str, Any]:
    corners = body.mesh.corners.reshape(-1, 6)
    rows, index = np.unique(corners, axis=0, return_inverse=True)
    flat = body.behind and _is_flat(body)
    return {
        "flat": flat,
        "inside": body.behind and not flat,
        "points": _rounded(rows[:, :3] @ turn.T).tolist(),
        "triangles": index.ravel().tolist(),
        "lines": _lines(body.lines, turn),
        "rims": _lines(_border(body) if flat else body.mesh.rims, turn),
    }


def _border(body: Body) -> Floats:
    """Return the lines around a plane, (k, 2, 3): seen from its side it would not be seen else."""
    lines = [np.stack([line[:-1], line[1:]], 1) for line in loops(body.mesh.corners[..., :3])]
    return np.concatenate([np.empty((0, 2, 3)), *lines])


def _is_flat(body: Body) -> bool:
    ways = (body.mesh.corners[..., 3:] - body.mesh.corners[..., :3]).reshape(-1, 3)
    return not len(ways) or bool(np.ptp(ways, axis=0).max() < 1e-9)


def _lines(segments: Floats, turn: NDArray[np.int64]) -> list[Any]:
    return [_rounded(line @ turn.T).tolist() for line in chains(segments)]


def _rounded(points: Floats) -> Floats:
    """Return numbers of so many digits, counted from the largest."""
    largest = float(np.abs(points).max(initial=1e-300))
    return np.asarray(np.round(points, _DIGITS - int(np.floor(np.log10(largest)))))
