"""What a backend reads and writes: plain arrays, by shot, as the table of results says."""

from __future__ import annotations

from collections.abc import Collection
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import blocks

LOG = ("events", "event_counts")


class Raw:
    """Result arrays of a batch, attributes by name; None is not wanted.

    Parameters
    ----------
    arrays
        Results of the table by name; `events` and `event_counts`, room for max_contacts + 1 rows a
        shot, and how many of them are used.
    """

    def __init__(self, **arrays: NDArray[Any]) -> None:
        self.arrays = arrays

    def __getattr__(self, name: str) -> NDArray[Any] | None:
        if name.startswith("_"):
            raise AttributeError(name)
        return self.arrays.get(name)

    def rows(self, start: int, stop: int) -> Raw:
        """Return views of the arrays for some of the shots."""
        return Raw(**{name: array[start:stop] for name, array in self.arrays.items()})

    def joined(self, other: Raw) -> Raw:
        """Return these arrays and the others."""
        return Raw(**self.arrays, **other.arrays)


class Layout:
    """The arrays of a scene: its table of results, in NumPy's terms.

    Parameters
    ----------
    kernels
        The scene's generated NumPy module.

    Attributes
    ----------
    results
        Each result of the table by its name.
    fields, bounds
        Names of the results that a batch has, and of those had by name only.
    event
        Type of a row of the event log; the layout of the C struct.
    surfaces
        How many bodies there are, and columns of `counts`.
    rows
        Of the event log for each contact, at most.
    """

    def __init__(self, kernels: ModuleType) -> None:
        self.results: dict[str, Any] = {result.name: result for result in kernels.RESULTS}
        self._rooms: dict[str, tuple[tuple[int, ...], np.dtype[Any]]] = {
            name: ((len(result.columns),) if result.row else (), np.dtype(result.dtype))
            for name, result in self.results.items()
        }
        self.fields = tuple(name for name, result in self.results.items() if not result.asked)
        self.bounds = tuple(name for name, result in self.results.items() if result.asked)
        self.state_size = len(kernels.STATE)
        self.surfaces = len(kernels.BODIES)
        self.rows = int(kernels.LOG_ROWS)
        self.event = np.dtype(
            [
                ("shot", np.int64),
                ("surface", np.int64),
                ("time", np.float64),
                ("before", np.float64, self.state_size),
                ("after", np.float64, self.state_size),
                ("kind", np.int64),
            ]
        )

    def log_rows(self, max_contacts: int) -> int:
        """Return the rows of the event log that a shot with so many contacts has room for."""
        return self.rows * max_contacts + 1

    def allocate(self, shots: int, wanted: Collection[str]) -> Raw:
        """Return uninitialised results of `shots` shots for the fields that are wanted."""
        rooms = [(name, *self._rooms[name]) for name in wanted]
        return Raw(**{name: blocks.empty((shots, *each), dtype) for name, each, dtype in rooms})

    def allocate_events(self, shots: int, max_contacts: int) -> Raw:
        """Return room for the event log of `shots` shots."""
        return Raw(
            events=np.empty((shots, self.log_rows(max_contacts)), self.event),
            event_counts=np.zeros(shots, np.int32),
        )
