"""Proved bounds on the errors of recorded events."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from flint import arb, ctx
from numpy.typing import NDArray

from hoopgen.core.event_log import Event

from .proof import Proof, ProvedEvent

EVENT_ERRORS = np.dtype(
    [
        ("shot", np.int64),
        ("surface", np.int64),
        ("time_error", np.float64),
        ("before_error", np.float64, 3),
        ("after_error", np.float64, 3),
    ]
)
"""A row of bounds; those of states are on position, velocity and spin."""


def event_errors(proofs: Sequence[Proof], events: NDArray[np.void]) -> NDArray[np.void]:
    """Return proved bounds on the errors of each row of an event log.

    A bound is the upper end of a ball that holds the difference between the recorded number, an
    exact double, and the proved enclosure of the true one. It is rounded up to a double.

    Parameters
    ----------
    proofs
        Of the same shots, with their events.
    events
        The log, sorted by shot.

    Returns
    -------
    ndarray
        `EVENT_ERRORS`, a row for each row of the log; NaN where nothing is proved of it.

    Raises
    ------
    ValueError
        If the proofs have no events.
    """
    if any(proof.surfaces and not proof.events for proof in proofs):
        raise ValueError("event_errors needs the proved events: certify(..., record=True)")
    found = np.zeros(len(events), EVENT_ERRORS)
    found["shot"], found["surface"] = events["shot"], events["surface"]
    for name in ("time_error", "before_error", "after_error"):
        found[name] = math.nan
    ends = np.searchsorted(events["shot"], np.arange(len(proofs) + 1))
    for proof, (start, end) in zip(proofs, pairwise(ends.tolist()), strict=True):
        _bound(proof, events[start:end], found[start:end])
    return found


def _bound(proof: Proof, events: NDArray[np.void], found: NDArray[np.void]) -> None:
    """Write the bounds of one shot, as far as its events are those that are proved.

    Rows of a roll end the comparison: the judge follows impacts.
    """
    with ctx.workprec(4 * proof.bits):  # no digit of an enclosure is lost
        for row, proved, bounds in zip(events, proof.events, found, strict=False):
            if row["surface"] != proved.surface or row["kind"] not in (Event.IMPACT, Event.END):
                return
            bounds["time_error"] = _largest(proved, "time", [float(row["time"])])
            for name in ("before", "after"):
                state = row[name].tolist()
                bounds[f"{name}_error"] = [
                    _largest(proved, name, state[k : k + 3], k) for k in (0, 3, 6)
                ]


def _largest(proved: ProvedEvent, name: str, numbers: Sequence[float], first: int = 0) -> float:
    """Return a bound on the distance of each number from its enclosure."""
    value = getattr(proved, name)
    enclosures = [value] if name == "time" else value[first : first + len(numbers)]
    away = [
        abs(one.ball - arb(number)).upper() for one, number in zip(enclosures, numbers, strict=True)
    ]
    largest = max(away)
    # The conversion rounds to nearest, at worst half a unit down.
    return 0.0 if largest == 0 else math.nextafter(float(largest), math.inf)
