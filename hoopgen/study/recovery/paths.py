"""Paths of balls to the second contact: positions at the frames of tracks, and their derivatives.

A path is the flight from the release to the first contact and the flight after that. With the
derivatives Φ of a flight by the state at its beginning, those of the positions at a time t are

    Φ(t) dy            before the first contact, dy those of the state at the release,
    Φ(t - t1) dy1 - v(t) dt1     after it,

where dt1 and dy1 are the derivatives of the time of the contact and of the state after it, which
the scene's kernels of variation give (`hoopgen.simulation.event_variations`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.event_log import Event
from hoopgen.core.parameters import Value
from hoopgen.core.variables import STATE
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.event_variations import event_derivatives
from hoopgen.simulation.simulate import simulate

from .backspin import states_with_backspin

Floats = NDArray[np.float64]

VARIED = 7
"""Variables of a path: position, velocity and backspin at the release."""

_STEP = 1e-4
"""m/s, rad/s. Step of the differences for derivatives of flights through air, whose curvature is so
small that their error is below 1e-8 of them."""


@dataclass(frozen=True)
class Paths:
    """Positions on paths at frames, and the contacts.

    Attributes
    ----------
    positions
        (n, m, 3), m; NaN on the path of a release that cannot be simulated.
    jacobian
        Their derivatives by `VARIED` variables, (n, m, 3, 7); empty if they were not asked for.
    first, second
        Times of the first and the second event since the release, (n,), s; infinite where there is
        none, and the second where the ball stays in contact is the first.
    """

    positions: Floats
    jacobian: Floats
    first: Floats
    second: Floats


def release_states(variables: Floats) -> Floats:
    """Return the states at the release, (n, 9), of position, velocity and backspin, (n, 7)."""
    return states_with_backspin(variables[:, :3], variables[:, 3:6], variables[:, 6])


def follow_paths(
    engine: Engine,
    values: Mapping[str, Value],
    variables: Floats,
    times: Floats,
    varied: bool = True,
) -> Paths:
    """Return the positions at frames on the paths of releases to the second contact.

    Beyond it the second flight goes on as if there was none.

    Parameters
    ----------
    engine
        The scene.
    values
        Its parameters, one number each or (n,).
    variables
        Position, velocity and backspin at the release, (n, 7).
    times
        Times of the frames since the release, (n, m), s.
    varied
        Whether the derivatives are wanted.
    """
    states = release_states(variables)
    shots = simulate(
        states,
        values,
        scene=engine,
        max_contacts=2,
        record=True,
        fields=("outcome", "uncertain"),
    )
    events, every = shots.events, np.arange(len(states))
    row = np.searchsorted(events["shot"], every)
    there = row < np.searchsorted(events["shot"], every, "right")
    met = np.zeros(len(states), np.bool_)
    met[there] = events["kind"][row[there]] == Event.IMPACT
    first, second = np.full(len(states), np.inf), np.full(len(states), np.inf)
    first[there] = events["time"][row[there]]
    last = np.searchsorted(events["shot"], every, "right") - 1
    two = met & (last > row)
    second[two] = events["time"][row[two] + 1]
    second[there & ~met] = first[there & ~met]

    since = np.clip(times, 0.0, None)
    late = met[:, None] & (times > first[:, None])
    early = np.where(late, 0.0, since)
    positions = engine.follow(early, states, values)
    jacobian = np.zeros((0, 0, 3, VARIED))
    change = _release_derivatives(variables) if varied else np.zeros((0, 9, VARIED))
    if varied:
        jacobian = _flight_derivatives(engine, values, states, change, early)
    after = np.flatnonzero(late.any(axis=1))
    if len(after):
        own, chosen = part_of(values, after), late[after]
        begin = events["after"][row[after]]
        later = np.where(chosen, since[after] - first[after, None], 0.0)
        beyond = engine.follow(later, begin, own)
        positions[after] = np.where(chosen[..., None], beyond, positions[after])
    if len(after) and varied:
        certain = ~shots.uncertain[after]
        contacts = events[row[after]]
        contacts["shot"] = np.arange(len(after))
        found = event_derivatives(engine, STATE, own, states[after], certain, contacts)
        moved, delay = found["after"] @ change[after], found["time"] @ change[after]
        beyond = _flight_derivatives(engine, own, begin, moved, later)
        path, frame = np.nonzero(chosen)
        velocity = engine.fly(later[path, frame], begin[path], part_of(own, path))[:, 3:6]
        beyond[path, frame] -= velocity[..., None] * delay[path]
        jacobian[after] = np.where(chosen[..., None, None], beyond, jacobian[after])
    positions[shots.outcome == engine.outcomes["INVALID"]] = np.nan
    return Paths(positions, jacobian, first, second)


def part_of(values: Mapping[str, Value], rows: NDArray[np.intp]) -> dict[str, Value]:
    """Return the parameters of some shots.

    Parameters
    ----------
    values
        Parameters, one number each or (n,).
    rows
        The shots.
    """
    return {n: np.asarray(v)[rows] if np.ndim(v) else v for n, v in values.items()}


def _release_derivatives(variables: Floats) -> Floats:
    """Return the derivatives of states at the release, (n, 9, 7).

    The spin is b (v_y, -v_x, 0) / |v_h| with the backspin b and the horizontal velocity v_h.
    """
    x, y = variables[:, 3], variables[:, 4]
    level = np.hypot(x, y)
    found = np.zeros((len(variables), 9, VARIED))
    found[:, range(6), range(6)] = 1.0
    with np.errstate(invalid="ignore", divide="ignore"):
        found[:, 6, 6], found[:, 7, 6] = y / level, -x / level
        turn = variables[:, 6] / level**3
        found[:, 6, 3], found[:, 6, 4] = -turn * x * y, turn * x * x
        found[:, 7, 3], found[:, 7, 4] = -turn * y * y, turn * x * y
    return found


def _flight_derivatives(
    engine: Engine, values: Mapping[str, Value], start: Floats, change: Floats, since: Floats
) -> Floats:
    """Return derivatives of positions in flights, (n, m, 3, k), from those of the start, (n, 9, k).

    A flight does not depend on where it begins; on a parabola the velocity counts as it is, and
    through air differences give the derivatives.
    """
    found = np.broadcast_to(change[:, None, :3], (*since.shape, 3, change.shape[2])).copy()
    if not engine.kernels.PIECES:
        found += since[..., None, None] * change[:, None, 3:6]
        return found
    # All columns in which velocity or spin change at once: what a step costs is mostly the same for
    # one flight and for many.
    direction = np.moveaxis(change[:, 3:], 2, 1)
    moving = np.asarray((np.abs(direction) > 0.0).any(axis=2))
    moving &= np.any(since > 0.0, axis=1)[:, None]
    rows, columns = np.nonzero(moving)
    if not len(rows):
        return found
    direction = direction[rows, columns]
    size = np.maximum(np.abs(direction).max(axis=1), 1.0)[:, None]
    both = np.concatenate([rows, rows])
    moved = start[both].copy()
    moved[:, 3:] += np.concatenate([direction / size, -direction / size]) * _STEP
    after, before = np.split(engine.follow(since[both], moved, part_of(values, both)), 2)
    found[rows, :, :, columns] += (after - before) * (size / (2.0 * _STEP))[..., None]
    return found
