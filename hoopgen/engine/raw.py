"""What a backend reads and writes: plain arrays, by shot, as the table of results says."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.generated.numpy.hoop import RESULTS, STATE

STATE_SIZE = len(STATE)
RESULT = {result.name: result for result in RESULTS}
FIELDS = tuple(result.name for result in RESULTS if not result.asked)
BOUNDS = tuple(result.name for result in RESULTS if result.asked)
LOG = ("events", "event_counts")

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


class Raw:
    """Result arrays of a batch, attributes by name; None is not wanted.

    Parameters
    ----------
    arrays
        The results of the table by name; `events` and `event_counts`, room for max_contacts + 1
        rows a shot, and how many of them are used.
    """

    def __init__(self, **arrays: NDArray[Any]) -> None:
        self.arrays = arrays

    def __getattr__(self, name: str) -> NDArray[Any] | None:
        if name in RESULT or name in LOG:
            return self.arrays.get(name)
        raise AttributeError(name)

    @property
    def certified(self) -> bool:
        """Whether anything that bounds errors is wanted."""
        return any(RESULT[name].bounds for name in self.arrays if name in RESULT)

    def rows(self, start: int, stop: int) -> Raw:
        """Return views of the arrays for some of the shots."""
        return Raw(**{name: array[start:stop] for name, array in self.arrays.items()})

    def joined(self, other: Raw) -> Raw:
        """Return these arrays and the others."""
        return Raw(**self.arrays, **other.arrays)


def allocate(shots: int, surfaces: int, wanted: Collection[str]) -> Raw:
    """Return uninitialised results of `shots` shots for the fields that are wanted."""

    def empty(name: str) -> NDArray[Any]:
        result = RESULT[name]
        width = surfaces if name == "counts" else len(result.columns)
        return np.empty((shots, width) if result.row else shots, result.dtype)

    return Raw(**{name: empty(name) for name in wanted})


def allocate_events(shots: int, max_contacts: int) -> Raw:
    """Return room for the event log of `shots` shots."""
    return Raw(
        events=np.empty((shots, max_contacts + 1), EVENT),
        event_counts=np.zeros(shots, np.int32),
    )
