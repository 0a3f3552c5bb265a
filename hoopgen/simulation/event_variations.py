"""Derivatives at the events of shots: of their times, and of the states before and after them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.event_log import Event
from hoopgen.core.jacobian import Jacobian
from hoopgen.core.parameters import Value
from hoopgen.core.variables import STATE
from hoopgen.engine.compiled_scene import CompiledScene

from .variations import SHOTS_AT_ONCE, VARIATION, VariedPath

Floats = NDArray[np.float64]


def event_derivatives(
    scene: CompiledScene,
    names: Sequence[str],
    parameters: Mapping[str, Value],
    releases: Floats,
    certain: NDArray[np.bool_],
    events: NDArray[np.void],
) -> Jacobian:
    """Return the derivatives of the time of each event and of the states before and after it.

    Parameters
    ----------
    scene, names, parameters, releases, events
        As of `derivatives`; m events.
    certain
        The shots of which no decision is uncertain, (n,).

    Returns
    -------
    Jacobian
        "time" (m, 1, k), "before" and "after" (m, 9, k), rows as of the event log: how the event
        itself changes, whose time varies too. NaN in shots that are not certain, from an exact
        graze on, and from the first event at which the ball stays in contact.
    """
    columns = len(names)
    time = np.full((len(events), 1, columns), np.nan)
    before, after = (np.full((len(events), len(STATE), columns), np.nan) for _ in range(2))
    every = np.arange(len(certain))
    first = np.searchsorted(events["shot"], every)
    stop = np.searchsorted(events["shot"], every, "right")
    stays = np.flatnonzero(np.isin(events["kind"], (Event.ROLL, Event.LEAVE)))
    np.minimum.at(stop, events["shot"][stays], stays)
    followed = np.flatnonzero(certain & (first < stop))
    with np.errstate(all="ignore"):  # what a kernel does not choose may be divided by 0
        for start in range(0, len(followed), SHOTS_AT_ONCE):
            rows = followed[start : start + SHOTS_AT_ONCE]
            own = {n: v if isinstance(v, float) else v[rows] for n, v in parameters.items()}
            log = _EventLog(first[rows].copy(), time, before, after)
            VariedPath(scene, names, own, releases[rows]).follow(
                events, first[rows], log, stop[rows] - 1
            )
    known = np.ones(len(events), np.bool_)
    for matrix in (time, before, after):
        known &= np.isfinite(matrix).all(axis=(1, 2))
    for matrix in (time, before, after):
        matrix[~known] = np.nan
    return Jacobian({"time": time, "before": before, "after": after}, names, events["shot"])


@dataclass
class _EventLog:
    """The derivatives of events, stored in the order of the event log.

    Attributes
    ----------
    row
        The row of the next event of each shot, (m,).
    time, before, after
        As of `event_derivatives`.
    """

    row: NDArray[np.intp]
    time: Floats
    before: Floats
    after: Floats

    def flight(
        self, rows: NDArray[np.intp], events: NDArray[np.void], duration: Floats, start: Floats
    ) -> None:
        """Note nothing of flights."""

    def event(
        self,
        face: str,
        rows: NDArray[np.intp],
        events: NDArray[np.void],
        found: dict[str, Any],
        arrival: Floats,
    ) -> None:
        """Store the derivatives of events."""
        own, shape = self.row[rows], arrival.shape[1:]
        self.row[rows] += 1
        self.time[own, 0] = np.broadcast_to(found["contact_delay"], shape).T
        self.before[own] = np.moveaxis(arrival, 2, 0)
        for index, name in enumerate(VARIATION):
            self.after[own, index] = np.broadcast_to(found[name], shape).T
