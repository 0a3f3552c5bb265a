"""Rebounds: where and when a miss comes down to the height at which hands can be.

Past its last contact a ball flies one parabola, so any state of it, such as that at the end plane,
gives the place at any height: the time from there (Eq. 3, solved) is negative where the height is
above. Before that contact the ball was on another flight, and still to be turned by the hoop.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.si_checks import MAX_LENGTH
from hoopgen.core.units import DEGREE
from hoopgen.core.validation import as_number
from hoopgen.engine.elementary import arc_tangent, hypotenuse
from hoopgen.generated.numpy import hoop
from hoopgen.hoop.releases import CATCHING_HEIGHT as CATCHING_HEIGHT
from hoopgen.hoop.releases import RING_HEIGHT
from hoopgen.results.shots import SURFACES, Outcome
from hoopgen.text.shorten import brief

from .measure_context import Block, Floats

REBOUNDS = tuple(f"rebound_{name}" for name in ("x", "y", "distance", "angle", "time", "delay"))
"""Names of the measures that depend on the catching height."""

_WIDTH = 60 * DEGREE

SECTORS: Mapping[str, float] = MappingProxyType(
    {
        "back to the shooter": 0.0,
        "near left": _WIDTH,
        "far left": 2 * _WIDTH,
        "beyond the ring": 3 * _WIDTH,
        "far right": -2 * _WIDTH,
        "near right": -_WIDTH,
    }
)
"""Sixths of the floor plan around the ring, as the shooter sees them, by the angle of their middle,
rad: a measure `rebound_angle` lies in the sector within half a sixth of whose middle it is."""


def check_height(height: Any) -> float:
    """Return a catching height.

    Raises
    ------
    TypeError, ValueError
        If it is not one number above 0.
    """
    found = as_number("catching_height", height, "a number, m above the floor")
    if not 0.0 < found <= MAX_LENGTH:
        raise ValueError(
            f"catching_height: expected m above the floor, more than 0 and at most {MAX_LENGTH:g}, "
            f"got {brief(height)}"
        )
    return found


def caught_at(measures: Iterable[str], height: float) -> dict[str, float]:
    """Return the catching height by its name where measures depend on it, else nothing.

    Parameters
    ----------
    measures
        The names of the measures that are asked for.
    height
        Where the ball's centre is when a rebound is caught, m above the floor.
    """
    return {"catching_height": height} if set(measures) & set(REBOUNDS) else {}


def sector(angle: ArrayLike) -> NDArray[np.int8]:
    """Return in which of `SECTORS` directions lie, by number; -1 where there is none."""
    given = np.asarray(angle, np.float64)
    # Sixths in the order of SECTORS, to the left; the last half of beyond has negative angles.
    sixth = np.floor(np.where(np.isnan(given), 0.0, given) / _WIDTH + 0.5)
    return np.where(np.isnan(given), -1, np.mod(sixth, len(SECTORS))).astype(np.int8)


def directions(places: ArrayLike, seen_from: tuple[float, float]) -> Floats:
    """Return the measure `rebound_angle` of places, (n, 2), as it is seen from one; rad, (n,).

    Parameters
    ----------
    places
        x and y of the places, (n, 2), m.
    seen_from
        x and y of the place of the shooter, m.
    """
    x, y = np.asarray(places, np.float64).T
    return direction_from(x, y, *map(np.float64, seen_from))


def direction_from(x: Floats, y: Floats, from_x: ArrayLike, from_y: ArrayLike) -> Floats:
    """Return the measure `rebound_angle` of places, each seen from its own; rad.

    Parameters
    ----------
    x
        x of the places, (n,), m.
    y
        y of the places, (n,), m.
    from_x
        x of the shooter's place, one number or (n,), m.
    from_y
        y of the shooter's place, likewise.
    """
    past, left = hoop.line_of_sight(x, y, from_x, from_y)
    return arc_tangent(left, -past)


def _caught(block: Block) -> Floats:
    """Return time, x and y of rebounds, (3, n): of misses, and of shots that fall short."""
    outcome, ends = block.results["outcome"], block.results["time"]
    time, place = _descent(block)
    missed, short = outcome == Outcome.MISSED, outcome == Outcome.SHORT
    last = np.where(short, ends, 0.0)  # the state of such a shot is that at its last contact
    back = np.flatnonzero(missed & (time < 0))
    last[back] = _last_contact(block, back)
    above_floor = block.catching_height >= block.parameters["ball_radius"]
    there = (missed | short) & (ends + time >= last) & above_floor
    return np.where(there, [ends + time, *place[:2]], np.nan)


def _descent(block: Block) -> tuple[Floats, Floats]:
    """Return when the flights from the last states come down to the catching height, and where.

    A time before those states, of a parabola, says when the ball was there. Through air, where such
    a flight is not followed backwards, there is none.
    """
    states, level = block.results["state"], block.catching_height - RING_HEIGHT
    if block.scene.kernels.PIECES:
        time, there = block.scene.fall(states, level, block.parameters)
        return time, there[:, :3].T
    x, y, z, vx, vy, vz, *_ = states.T
    gravity = block.parameters["gravity"]
    time, _ = hoop.descent(z, vz, level, gravity)
    return time, np.array(hoop.flight(time, x, y, z, vx, vy, vz, gravity))


def _last_contact(block: Block, rows: NDArray[np.intp]) -> Floats:
    """Return when some of the shots were last in contact; 0 for those that touched nothing."""
    last = np.zeros(len(rows))
    contacts = block.results["contacts"][rows]
    touched = np.flatnonzero(contacts)
    if len(touched):
        # One more than they had: then none of them is capped that was not.
        most = int(contacts.max()) + 1
        log = block.again(rows[touched], most, fields=(), record=True).events
        log = log[log["surface"] < len(SURFACES)]
        last[touched[log["shot"]]] = log["time"]  # in order of time: the last one stays
    return last


def rebound(block: Block) -> dict[str, Floats]:
    """Return when and where a miss comes down to the catching height."""
    time, x, y = _caught(block)
    angle = direction_from(x, y, block.states[:, 0], block.states[:, 1])
    found = {"x": x, "y": y, "distance": hypotenuse(y, x), "angle": angle, "time": time}
    return {f"rebound_{name}": column for name, column in found.items()}


def delay(block: Block) -> dict[str, Floats]:
    """Return the time from the first contact to the rebound."""
    after = np.full(len(block), np.nan)
    touched = np.flatnonzero(block.results["contacts"])
    if len(touched):
        first = block.again(touched, 1, fields=("time",)).time
        after[touched] = _caught(block)[0][touched] - first
    return {"rebound_delay": after}
