"""The path of one shot."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property
from itertools import groupby
from typing import TYPE_CHECKING, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.event_log import Event, describe_event, rolls
from hoopgen.core.plotting import plotting_module
from hoopgen.core.validation import as_doubles
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.engine.rolling import Roll
from hoopgen.text.shorten import brief

from . import frames
from .drawing import TrajectoryOptions

if TYPE_CHECKING:
    from pandas import DataFrame

    from .drawing import Drawn

FLIGHT_PIECE_DURATION = 0.01
"""s: so short a piece of a flight through air differs from a parabola by less than 0.1 mm."""


_MAX_ROLL_PIECES = 2000


@dataclass(frozen=True)
class Trajectory:
    """The path of one shot from its release to its end.

    Attributes
    ----------
    release
        State at time 0, (9,).
    events
        Rows of the event log; the last one is the end.
    parameters
        Parameters of the scene, one number each.
    scene
        The scene of the simulation.
    outcome
        How the shot ended, if that was requested.
    """

    release: NDArray[np.float64]
    events: NDArray[np.void]
    parameters: Mapping[str, float]
    scene: CompiledScene
    outcome: IntEnum | None = None

    @property
    def duration(self) -> float:
        """Time of the last event, s; 0 if there is none."""
        return float(self.events["time"][-1]) if len(self.events) else 0.0

    def at(self, t: ArrayLike) -> NDArray[np.float64]:
        """Return the states at the times `t`; at a contact, the state after it.

        Times may be in flight or in contact, where the ball rolls.

        Parameters
        ----------
        t
            Times since the release, s, within [0, duration]; any shape.

        Returns
        -------
        ndarray
            Shape ``(*t.shape, 9)``.

        Raises
        ------
        TypeError
            If they are not numbers.
        ValueError
            If a time is not within the trajectory.
        """
        times = as_doubles("t", t)
        if not np.all((times >= 0.0) & (times <= self.duration)):
            raise ValueError(f"t: expected times from 0 to {self.duration} s, got {brief(t)}")
        starts = np.concatenate([[0.0], self.events["time"]])
        states = np.concatenate([self.release[None], self.events["after"]])
        segment = np.searchsorted(starts, times, side="right") - 1
        since = times - starts[segment]
        moved = self.scene.fly(since, states[segment], self.parameters)
        for row, _, _ in self.rolls:
            there = segment == row + 1
            if there.any():
                moved[there] = self._roll(row).at(since[there])
        return moved

    @property
    def rolls(self) -> list[tuple[int, float, float]]:
        """Lasting contacts: the row of `events` at the begin of each, and its begin and end, s."""
        return rolls(self.events)

    def pieces(
        self, step: float
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.bool_]]:
        """Divide the path into its flights, and its rolls into pieces, for pictures.

        Pieces of a flight, which in pictures are parabolas, are short where it is none.

        Parameters
        ----------
        step
            Longest piece of a roll, s; a long roll has 2000 longer ones.

        Returns
        -------
        tuple of ndarray
            The begin of each piece, (n,), s; the state then, (n, 9); whether the ball rolls until
            the next one, (n,). The last one is the end.
        """
        starts = np.concatenate([[0.0], self.events["time"]])
        states = np.concatenate([self.release[None], self.events["after"]])
        times, there, rolling = [starts[:1]], [states[:1]], [np.zeros(1, np.bool_)]
        lasting = {row: stop - start for row, start, stop in self.rolls}
        curved = bool(self.scene.kernels.PIECES)
        for row in range(len(self.events)):
            if curved and row - 1 not in lasting:
                begin, end = starts[row : row + 2]
                between = np.linspace(begin, end, self._parts(row))[1:-1]
                times.append(between)
                there.append(self.at(between))
                rolling.append(np.zeros(len(between), np.bool_))
            times.append(starts[row + 1 : row + 2])
            there.append(states[row + 1 : row + 2])
            rolling.append(np.array([row in lasting]))
            if row in lasting:
                parts = max(1, min(_MAX_ROLL_PIECES, int(np.ceil(lasting[row] / step))))
                since = lasting[row] * np.arange(1, parts + 1) / parts
                # The end of the roll too, in the state before the event that ends it.
                times.append(np.append(starts[row + 1] + since[:-1], starts[row + 2]))
                there.append(self._roll(row).at(since))
                rolling.append(np.arange(1, parts + 1) < parts)
        return np.concatenate(times), np.concatenate(there), np.concatenate(rolling)

    def _parts(self, row: int) -> int:
        """Return the number of points, with its ends, of a flight in pictures."""
        start = self.events["time"][row - 1] if row else 0.0
        return 2 + int((self.events["time"][row] - start) / FLIGHT_PIECE_DURATION)

    @cached_property
    def _followed(self) -> dict[int, Roll]:
        """Rolls that have been computed, by the row with which they begin."""
        return {}

    def _roll(self, row: int) -> Roll:
        if row not in self._followed:
            event, until = self.events[row], self.events["time"][row + 1]
            self._followed[row] = self.scene.roll(
                int(event["surface"]), event["after"], until - event["time"], self.parameters
            )
        return self._followed[row]

    def __repr__(self) -> str:
        shown = self.events[self.events["kind"] != Event.LEAVE]
        words = [describe_event(event, self.scene.surfaces) for event in shown]
        runs = ((word, len(list(run))) for word, run in groupby(words))
        names = [f"{word}{f' {times} times' if times > 1 else ''}" for word, times in runs]
        ended = "" if self.outcome is None else f"; {self.outcome.name.lower()}"
        return f"Trajectory({self.duration:.3f} s: {', '.join(['release', *names])}{ended})"

    def plot(self, *, ax: Drawn | None = None, **options: Unpack[TrajectoryOptions]) -> Drawn:
        """Draw the path; options, and what is returned and raised, as for `plots.plot_trajectory`.

        The picture gives the outcome if it is known.

        Parameters
        ----------
        ax
            The axes to draw on; None makes a figure.
        **options
            Options of `plots.plot_trajectory`.
        """
        said: TrajectoryOptions = {"outcome": self.outcome}
        said |= options
        drawn: Drawn = plotting_module().plot_trajectory(self, self.parameters, ax=ax, **said)
        return drawn

    def to_pandas(self) -> DataFrame:
        """Return the events as a pandas.DataFrame, a row each, units in the columns' names.

        Time, kind, surface, position, and velocity and spin before and after.

        Raises
        ------
        ImportError
            If pandas is missing: what brings it.
        """
        return frames.contacts_frame(self)

    def _repr_html_(self) -> str:
        return frames.contacts_html(self)
