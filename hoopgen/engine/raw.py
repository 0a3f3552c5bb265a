"""What a backend reads and writes: plain arrays, by shot."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

STATE_SIZE = 9
FIELDS = ("outcome", "contacts", "counts", "first", "time", "state", "uncertain")
BOUNDS = ("time_error", "state_error")

EVENT = np.dtype(
    [
        ("shot", np.int64),
        ("surface", np.int64),
        ("time", np.float64),
        ("before", np.float64, STATE_SIZE),
        ("after", np.float64, STATE_SIZE),
    ]
)
"""A row of the event log; the layout of the C struct."""

_DTYPES: dict[str, Any] = {
    "outcome": np.uint8,
    "contacts": np.int32,
    "counts": np.int32,
    "first": np.int8,
    "time": np.float64,
    "state": np.float64,
    "uncertain": np.bool_,
    "time_error": np.float64,
    "state_error": np.float64,
}


@dataclass(frozen=True)
class Raw:
    """Result arrays of a batch; None is not wanted.

    Attributes
    ----------
    events, event_counts
        Room for max_contacts + 1 rows a shot, and how many of them are used.
    """

    outcome: NDArray[np.uint8] | None = None
    contacts: NDArray[np.int32] | None = None
    counts: NDArray[np.int32] | None = None
    first: NDArray[np.int8] | None = None
    time: NDArray[np.float64] | None = None
    state: NDArray[np.float64] | None = None
    uncertain: NDArray[np.bool_] | None = None
    time_error: NDArray[np.float64] | None = None
    state_error: NDArray[np.float64] | None = None
    events: NDArray[Any] | None = None
    event_counts: NDArray[np.int32] | None = None

    @property
    def certified(self) -> bool:
        """Whether anything that bounds errors is wanted."""
        return not (self.uncertain is None and self.time_error is None and self.state_error is None)

    def rows(self, start: int, stop: int) -> Raw:
        """Return views of the arrays for some of the shots."""
        arrays = {f.name: getattr(self, f.name) for f in fields(self)}
        return Raw(**{n: None if a is None else a[start:stop] for n, a in arrays.items()})


def allocate(shots: int, surfaces: int, wanted: Collection[str]) -> Raw:
    """Return uninitialised results of `shots` shots for the fields that are wanted."""
    tails = {"counts": (surfaces,), "state": (STATE_SIZE,), "state_error": (3,)}
    return Raw(**{name: np.empty((shots, *tails.get(name, ())), _DTYPES[name]) for name in wanted})


def allocate_events(shots: int, max_contacts: int) -> Raw:
    """Return room for the event log of `shots` shots."""
    return Raw(
        events=np.empty((shots, max_contacts + 1), EVENT),
        event_counts=np.zeros(shots, np.int32),
    )
