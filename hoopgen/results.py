"""Results of a batch, and the path of one shot."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.generated.numpy import hoop

Outcome = hoop.Outcome

SURFACES = hoop.BODIES
"""Surfaces, in the order of ``Shots.counts``; the event log numbers the end plane after them."""


@dataclass(frozen=True)
class Trajectory:
    """The path of one shot from its release to its end.

    Attributes
    ----------
    release
        State at time 0, (9,).
    events
        Its rows of the event log; the end is the last one.
    gravity
        m/s².
    """

    release: NDArray[np.float64]
    events: NDArray[Any]
    gravity: float

    @property
    def duration(self) -> float:
        """Time of the last event, s; 0 if there is none."""
        return float(self.events["time"][-1]) if len(self.events) else 0.0

    def at(self, t: ArrayLike) -> NDArray[np.float64]:
        """Return the states at the times `t`; at a contact, the state after it.

        Parameters
        ----------
        t
            Times since the release, s, within [0, duration]; any shape.

        Returns
        -------
        ndarray
            Shape (*t.shape, 9).

        Raises
        ------
        ValueError
            If a time is not within the trajectory.
        """
        times = np.asarray(t, dtype=np.float64)
        if not np.all((times >= 0.0) & (times <= self.duration)):
            raise ValueError(f"t: expected times from 0 to {self.duration} s, got {t!r}")
        starts = np.concatenate([[0.0], self.events["time"]])
        states = np.concatenate([self.release[None], self.events["after"]])
        segment = np.searchsorted(starts, times, side="right") - 1
        origin = states[segment]
        x, y, z, vx, vy, vz, *spin = np.moveaxis(origin, -1, 0)
        moved = hoop.flight(times - starts[segment], x, y, z, vx, vy, vz, self.gravity)
        return np.stack([*moved, *spin], -1)


class Shots:
    """Results of a batch; arrays by shot. A field that was not asked for raises AttributeError.

    Attributes
    ----------
    outcome
        uint8 (n,), an `Outcome`.
    contacts
        int32 (n,), contacts before the end.
    counts
        int32 (n, k), contacts by surface, in the order of `SURFACES`.
    first
        int8 (n,), first surface touched, -1 for none.
    time
        float64 (n,), s: at the end plane; capped or short, at the last contact.
    state
        float64 (n, 9), then.
    uncertain
        bool (n,), some decision of the shot lies within its rounding-error bound.
    time_error, state_error
        float64 (n,) and (n, 3), when asked for by name: bounds on the errors of `time` and of each
        component of the position, velocity and spin in `state`, for shots that are not uncertain.
    events
        With ``record=True``: the event log, rows in order of shot, then time.
    """

    outcome: NDArray[np.uint8]
    contacts: NDArray[np.int32]
    counts: NDArray[np.int32]
    first: NDArray[np.int8]
    time: NDArray[np.float64]
    state: NDArray[np.float64]
    uncertain: NDArray[np.bool_]
    time_error: NDArray[np.float64]
    state_error: NDArray[np.float64]
    events: NDArray[Any]

    def __init__(
        self,
        fields: dict[str, NDArray[Any]],
        states: NDArray[np.float64],
        gravity: float | NDArray[np.float64],
    ) -> None:
        self._fields = fields
        self._states = states
        self._gravity = gravity

    def __getattr__(self, name: str) -> NDArray[Any]:
        fields = self.__dict__.get("_fields", {})
        if name in fields:
            return fields[name]  # type: ignore[no-any-return]
        if name == "events":
            raise AttributeError("events: simulate with record=True to keep the event log")
        if name in Shots.__annotations__:
            raise AttributeError(f"{name}: not among the fields asked for: {', '.join(fields)}")
        raise AttributeError(f"Shots has no attribute {name!r}")

    def __len__(self) -> int:
        return len(self._states)

    def __repr__(self) -> str:
        return f"Shots({len(self)} shots: {', '.join(self._fields)})"

    def trajectory(self, shot: int) -> Trajectory:
        """Return the path of one shot; needs ``record=True``.

        Raises
        ------
        IndexError
            If there is no such shot.
        """
        if not -len(self) <= shot < len(self):
            raise IndexError(f"shot {shot}: there are {len(self)}")
        index = shot % len(self)
        low, high = np.searchsorted(self.events["shot"], [index, index + 1])
        gravity = self._gravity if isinstance(self._gravity, float) else self._gravity[index]
        return Trajectory(self._states[index], self.events[low:high], float(gravity))
