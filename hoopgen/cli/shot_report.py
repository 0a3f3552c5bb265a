"""A shot in words: its contacts in short, and its events in a table."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import groupby
from typing import Any

import numpy as np
from numpy.typing import NDArray

import hoopgen
from hoopgen.core.event_log import describe_event, number_contacts
from hoopgen.core.units import display_unit
from hoopgen.text.tables import NO_BREAK, table

_MAX_LISTED_EVENTS = 3  # in a row on one surface, each with its own time


def surface_name(index: int, surfaces: Sequence[str] = hoopgen.SURFACES) -> str:
    """Name a surface of the event log; the plane after the last is the end.

    Parameters
    ----------
    index
        The number of the surface in the event log, from 0.
    surfaces
        The names of the scene's surfaces, in order.

    Returns
    -------
    str
        The name of the surface, or "end".
    """
    return surfaces[index] if index < len(surfaces) else "end"


def story(events: NDArray[Any]) -> str:
    """Return events in short: ``ring 0.829, ring 0.915, end 1.409``; s.

    A longer run on one surface has its number of events, its first and its last time:
    ``ring ×40 0.292-0.958``. Lines break between events only.
    """
    return ", ".join(_runs(events)) or "none"


def _runs(events: NDArray[Any]) -> Iterable[str]:
    for surface, run in groupby(events, key=lambda event: int(event["surface"])):
        times = [float(event["time"]) for event in run]
        name = surface_name(surface)
        if len(times) > _MAX_LISTED_EVENTS:
            yield f"{name} ×{len(times)}{NO_BREAK}{times[0]:.3f}–{times[-1]:.3f}"
        else:
            yield from (f"{name}{NO_BREAK}{time:.3f}" for time in times)


def event_table(
    release: NDArray[np.float64],
    events: NDArray[Any],
    surfaces: Sequence[str] = hoopgen.SURFACES,
) -> str:
    """Lay out a shot's events, the release first, with times in s.

    Parameters
    ----------
    release
        The state at release, (9,), SI.
    events
        The records of the shot's events, in order of time.
    surfaces
        The names of the scene's surfaces, in order.

    Returns
    -------
    str
        A row for each event, with positions and velocities in the units that are shown.
    """
    unit, speed = display_unit("length"), display_unit("speed")

    def places(state: NDArray[np.float64]) -> list[str]:
        return _numbers(state[:3] / unit.size)

    def speeds(state: NDArray[np.float64]) -> list[str]:
        return _numbers(state[3:6] / speed.size)

    headers = ["#", "time (s)", "surface", "x", "y", "z", "vx", "vy", "vz", "vx", "vy", "vz"]
    first = ["", _time(0.0), "release", *places(release), *[""] * 3, *speeds(release)]
    rows = [first]
    for number, event in number_contacts(events):
        before, after = event["before"], event["after"]
        ended = int(event["surface"]) >= len(surfaces)
        rows.append(
            [
                "" if number is None else str(number),
                _time(float(event["time"])),
                describe_event(event, surfaces),
                *places(before),
                *speeds(before),
                *([""] * 3 if ended else speeds(after)),
            ]
        )
    groups = [(3, 5, f"position ({unit.symbol})")]
    groups += [(6, 8, f"before ({speed.symbol})"), (9, 11, f"after ({speed.symbol})")]
    return table(headers, rows, right=[0, 1, *range(3, 12)], groups=groups)


def _time(seconds: float) -> str:
    return f"{seconds:.6f}"


def _numbers(values: Sequence[float] | NDArray[np.float64]) -> list[str]:
    # Adding zero makes -0.000 a plain 0.000.
    return [f"{round(float(value), 4) + 0.0:.4f}" for value in values]
