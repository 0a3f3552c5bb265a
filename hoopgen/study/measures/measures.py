"""Measures of a shot at a hoop besides its outcome.

The flight that brings the ball to the ring is the one from the release or, where the backboard is
touched first, the one after that contact, continued as if nothing else were in its way.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.extras import require
from hoopgen.core.parameters import ParameterValues, Value, resolve
from hoopgen.core.validation import check_states
from hoopgen.core.variables import check_names
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.engine.elementary import arc_tangent, hypotenuse
from hoopgen.generated.numpy import hoop
from hoopgen.hoop.presets import PAPER
from hoopgen.hoop.releases import RING_HEIGHT
from hoopgen.results.shots import SURFACES, Outcome, Shots
from hoopgen.scene.lookup import check_hoop

from .measure_context import Block, Floats, rows_of
from .rebounds import CATCHING_HEIGHT, check_height, delay, rebound

_RING, _BOARD, _BRIDGE = (SURFACES.index(name) for name in ("ring", "backboard", "bridge"))

BLOCK = 1 << 14
"""Shots measured at a time; their columns fit a processor's cache."""


@check_arguments
def measure(
    states: ArrayLike,
    shots: Shots,
    parameters: ParameterValues = PAPER,
    names: Iterable[str] | None = None,
    *,
    catching_height: float = CATCHING_HEIGHT,
) -> dict[str, Floats]:
    """Return measures of simulated shots.

    Parameters
    ----------
    states
        The releases that were simulated, (n, 9) or (9,); not states that leave a surface.
    shots
        Their results: all fields, or at least those in `Measure.fields` of what is wanted.
    parameters
        Of the scene, as they were then: one number, or (n,).
    names
        Of `measures_of` the scene; None for all. What is not wanted is not computed.
    catching_height
        m above the floor: where the ball's centre is when a rebound is caught.

    Returns
    -------
    dict
        By name, float64 (n,); NaN where there is nothing to measure, as of an invalid shot.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described, or the shots are not a hoop's.
    AttributeError
        If `shots` lacks a field.
    """
    check_hoop("measure", shots.scene)
    there = measures_of(shots.scene)
    wanted = check_names("names", there if names is None else names, there)
    height = check_height(catching_height)
    releases = check_states(states)
    if len(releases) != len(shots):
        raise ValueError(
            f"states: expected the {len(shots)} releases of shots, got {len(releases)}"
        )
    scene = shots.scene
    values = resolve(parameters, len(shots), scene.table)
    columns = {name: np.full(len(shots), np.nan) for name in wanted}
    needed = {"outcome", *(name for measured in wanted for name in MEASURES[measured].fields)}
    results = {name: getattr(shots, name) for name in sorted(needed)}
    groups = dict.fromkeys(MEASURES[name].compute for name in wanted)
    for start in range(0, len(shots), BLOCK):
        rows = slice(start, start + BLOCK)
        block = Block(
            releases[rows],
            {name: result[rows] for name, result in results.items()},
            {name: rows_of(value, rows) for name, value in values.items()},
            scene,
            height,
        )
        with np.errstate(all="ignore"):  # what is out of range there is NaN
            for group in groups:
                for name, column in group(block).items():
                    if name in columns:
                        columns[name][rows] = np.where(block.valid, column, np.nan)
    return columns


# The columns of each group, from a block


def _to_the_ring(block: Block) -> dict[str, Floats]:
    """Return place and velocity at which the flight to the ring crosses the ring's plane."""
    flights = block.states.copy()
    banked = np.flatnonzero(block.results["first"] == _BOARD)
    if len(banked):
        flights[banked] = block.again(banked, 1, fields=("state",)).state
    _, (x, y, _, vx, vy, vz) = block.descent(flights, 0.0)
    depth, left = hoop.line_of_sight(x, y, block.states[:, 0], block.states[:, 1])
    return {"entry_angle": arc_tangent(-vz, hypotenuse(vy, vx)), "depth": depth, "left_right": left}


def _highest(block: Block) -> dict[str, Floats]:
    """Return the height of the path up to the first contact."""
    time, height = block.scene.apex(block.states, block.parameters)
    touched = np.flatnonzero(block.results["contacts"] > 0)
    if len(touched):
        contact = block.again(touched, 1, fields=("time", "state"))
        rising = contact.time < time[touched]
        height[touched] = np.where(rising, contact.state[:, 2], height[touched])
    return {"apex": height + RING_HEIGHT}


def _at_the_end(block: Block) -> dict[str, Floats]:
    """Return place and velocity at the end plane."""
    x, y, _, vx, vy, vz, *_ = np.where(block.ended, block.results["state"].T, np.nan)
    return {"end_x": x, "end_y": y, "end_vx": vx, "end_vy": vy, "end_vz": vz}


def _on_the_floor(block: Block) -> dict[str, Floats]:
    """Return when, where and how the ball comes to the floor."""
    outcome = block.results["outcome"]
    falls = block.ended | (outcome == Outcome.SHORT)
    time, there = block.descent(block.results["state"], block.floor)
    time, (x, y, _, vx, vy, vz) = np.where(falls, time, np.nan), np.where(falls, there, np.nan)
    return {
        "floor_time": block.results["time"] + time,
        "floor_x": x,
        "floor_y": y,
        "floor_vx": vx,
        "floor_vy": vy,
        "floor_vz": vz,
    }


def _past_the_wire(block: Block) -> dict[str, Floats]:
    """Return the closest approach to the ring."""
    contacts = block.results["contacts"]
    missed_it = block.valid & (block.results["counts"][:, _RING] == 0)
    fall, _ = block.descent(block.results["state"], block.floor)
    short = block.results["outcome"] == Outcome.SHORT
    ends = block.results["time"] + np.where(short, fall, 0.0)
    clearance = np.zeros(len(block))
    free = np.flatnonzero(missed_it & (contacts == 0))
    clearance[free] = nearest(block.states[free], ends[free], block.parameters_of(free))
    around = np.flatnonzero(missed_it & (contacts > 0))
    if len(around):
        owner, states, durations = _flights(block, around, ends)
        clearance[around] = np.inf
        np.minimum.at(clearance, owner, nearest(states, durations, block.parameters_of(owner)))
    return {"clearance": np.maximum(clearance, 0.0)}


def _flights(
    block: Block, rows: NDArray[np.intp], ends: Floats
) -> tuple[NDArray[np.intp], Floats, Floats]:
    """Return every flight of some of the shots: whose it is, its first state, its duration."""
    contacts = block.results["contacts"][rows]
    # One more than they had: then none of them is capped that was not.
    log = block.again(rows, int(contacts.max()) + 1, fields=(), record=True).events
    shot = log["shot"].astype(np.intp)
    order = np.arange(len(log)) - np.searchsorted(shot, shot)
    log = log[(order < contacts[shot]) & (log["surface"] < len(SURFACES))]
    owner = rows[np.concatenate([np.arange(len(rows)), log["shot"]])]
    states = np.concatenate([block.states[rows], log["after"]])
    starts = np.concatenate([np.zeros(len(rows)), log["time"]])
    path = np.lexsort((starts, owner))  # stable: the release comes first
    owner, states, starts = owner[path], states[path], starts[path]
    last = np.append(owner[1:] != owner[:-1], True)
    until = np.where(last, ends[owner], np.append(starts[1:], np.nan))
    return owner, states, until - starts


_HALVINGS = 50
"""Halvings of a flight's time in the search for the wire: then a cell is shorter than the
resolution."""

_SIZES = ("ball_radius", "ring_radius", "wire_radius", "gravity")


def nearest(states: Floats, durations: Floats, parameters: Mapping[str, Value]) -> Floats:
    """Return the least distance of ball and wire along flights, within their resolution.

    Branch and bound: a cell of time is left where the kernel's bound shows that no place in it is
    nearer than the nearest one known, and halved until the distance has at most one minimum in it.

    Parameters
    ----------
    states
        Position, velocity and spin at the starts of the flights, (n, 9), SI.
    durations
        How long each flight lasts, (n,), s.
    parameters
        Parameters of the hoop by name, one number or (n,) each, SI.
    """

    def near(rows: NDArray[np.intp], t: Floats, half: Floats) -> Any:
        sizes = (rows_of(parameters[name], rows) for name in _SIZES)
        arguments = [t, *states[rows].T[:6], half, *sizes]
        return hoop.ring_nearness(*arguments)

    def note(rows: NDArray[np.intp], t: Floats) -> Any:
        gap, rate, *_ = near(rows, t, np.zeros_like(t))
        np.minimum.at(best, rows, gap)
        return rate

    rows = np.arange(len(states))
    best = np.full(len(states), np.inf)
    note(rows, np.zeros(len(states)))
    note(rows, durations)
    t = half = durations / 2
    for _ in range(_HALVINGS):
        gap, _, lower, concavity, resolution = near(rows, t, half)
        np.minimum.at(best, rows, gap)
        open_ = lower < best[rows] - resolution
        single = open_ & (concavity < 0.0)
        _bottom(near, note, rows[single], t[single], half[single])
        # What was found there may leave less to do.
        split = open_ & ~single & (lower < best[rows] - resolution)
        rows, half = np.repeat(rows[split], 2), np.repeat(half[split] / 2, 2)
        t = np.repeat(t[split], 2) + half * np.tile([-1.0, 1.0], len(t[split]))
        if not len(rows):
            break
    return best


def _bottom(
    near: Callable[..., Any],
    note: Callable[..., Any],
    rows: NDArray[np.intp],
    t: Floats,
    half: Floats,
) -> None:
    """Note the least distance in cells in which its rate rises throughout."""
    # Imported here, since a picture that needs a `Kind` need not have SciPy.
    elementwise = require("scipy.optimize.elementwise", "this measure")

    begin, end = t - half, t + half
    falls, rises = note(rows, begin) < 0.0, note(rows, end) > 0.0
    inside = falls & rises
    if np.any(inside):
        ends = (begin[inside], end[inside])
        found = elementwise.find_root(
            lambda at, row: near(row.astype(np.intp), at, np.zeros_like(at))[1],
            ends,
            args=(rows[inside],),
        )
        note(rows[inside], found.x)


@dataclass(frozen=True)
class Measure:
    """Something that is measured of a shot.

    Attributes
    ----------
    compute
        Computes it, and others with it.
    """

    name: str  # as it is asked for
    label: str  # in words, for axes and tables
    unit: str  # SI
    summary: str  # what it is
    fields: tuple[str, ...]  # of `Shots`, that it is computed from
    compute: Callable[[Block], dict[str, Floats]] = field(repr=False)


def _measures() -> Iterator[Measure]:
    def measure_from(
        compute: Callable[[Block], dict[str, Floats]], *fields: str
    ) -> Callable[..., Measure]:
        return partial(Measure, fields=("outcome", *fields), compute=compute)

    ring = measure_from(_to_the_ring, "first")
    yield ring(
        "entry_angle",
        "entry angle",
        "rad",
        "Below the horizontal, of the flight that brings the ball to the ring, where its centre "
        "comes down through the ring's plane.",
    )
    yield ring(
        "depth",
        "depth past the ring's centre",
        "m",
        "How far past the ring's centre that is, along the line from the place of release. A "
        "coach's depth, from the front of the rim, is ring_radius - wire_radius more.",
    )
    yield ring(
        "left_right", "left-right", "m", "How far that is to the shooter's left of that line."
    )
    yield measure_from(_highest, "contacts")(
        "apex", "apex", "m", "Greatest height of the centre above the floor up to a first contact."
    )
    yield measure_from(_past_the_wire, "contacts", "counts", "time", "state")(
        "clearance",
        "clearance of the ring",
        "m",
        "Closest approach of the ball's surface to the ring's wire; 0 if that was touched.",
    )
    end, floor = measure_from(_at_the_end, "state"), measure_from(_on_the_floor, "time", "state")
    yield floor(
        "floor_time", "time at the floor", "s", "Since the release, at floor level; see floor_x."
    )
    for axis in "xy":
        yield end(f"end_{axis}", f"{axis} at the end", "m", "Of the centre, at the end plane.")
        yield floor(
            f"floor_{axis}",
            f"{axis} at the floor",
            "m",
            "Of the centre, when the ball comes to the floor with nothing more in its way.",
        )
    for axis in "xyz":
        yield end(f"end_v{axis}", f"v{axis} at the end", "m/s", "At the end plane.")
        yield floor(f"floor_v{axis}", f"v{axis} at the floor", "m/s", "There; see floor_x.")
    back = measure_from(rebound, "contacts", "time", "state")
    where = "Of the centre, when a miss comes down to the catching height after its last contact."
    for axis in "xy":
        yield back(f"rebound_{axis}", f"{axis} of the rebound", "m", where)
    yield back(
        "rebound_distance", "rebound distance", "m", "Of that place, from the ring's centre."
    )
    yield back(
        "rebound_angle",
        "rebound direction",
        "rad",
        "Of that place around the ring, as the shooter sees it: 0 back to the shooter, positive to "
        "the left, ±π beyond the ring.",
    )
    yield back("rebound_time", "time of the rebound", "s", "Since the release; see rebound_x.")
    yield measure_from(delay, "contacts", "time", "state")(
        "rebound_delay",
        "rebound after the first contact",
        "s",
        "Since the first contact; none if nothing was touched. See rebound_x.",
    )


MEASURES: Mapping[str, Measure] = MappingProxyType({each.name: each for each in _measures()})
"""All measures by name."""


def measures_of(scene: CompiledScene) -> Mapping[str, Measure]:
    """Return the measures of a scene, by name.

    The clearance is that of parabolas, and so none where a ball may roll or flies through air.
    """
    parabolas = not scene.rolls and not scene.kernels.PIECES
    return {n: one for n, one in MEASURES.items() if parabolas or n != "clearance"}
