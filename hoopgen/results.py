"""Results of a batch, and the path of one shot."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property
from itertools import groupby
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.generated.numpy.hoop import Outcome as Outcome

from . import frames
from .brief import brief
from .engine.contact import Roll
from .engines import HOOP, Engine
from .events import Event, event_words, rolls
from .inputs import doubles
from .phrases import counted, doubtful

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


SURFACES = HOOP.surfaces
"""The hoop's, in the order of ``Shots.counts``; the event log numbers the end plane after them."""


def pictures() -> Any:
    """Return `hoopgen.plots`, for the `plot` of results, of shots and of studies.

    They draw results, and so stand on this file: no other import leads up, and this one waits until
    a picture is asked for.
    """
    from . import plots

    return plots


@dataclass(frozen=True)
class Trajectory:
    """The path of one shot from its release to its end.

    Attributes
    ----------
    release
        State at time 0, (9,).
    events
        Its rows of the event log; the end is the last one.
    parameters
        Of the scene, one number each.
    outcome
        If it was asked for.
    scene
        What it was simulated in.
    """

    release: NDArray[np.float64]
    events: NDArray[Any]
    parameters: Mapping[str, float]
    outcome: IntEnum | None = None
    scene: Engine = HOOP

    @property
    def duration(self) -> float:
        """Time of the last event, s; 0 if there is none."""
        return float(self.events["time"][-1]) if len(self.events) else 0.0

    def at(self, t: ArrayLike) -> NDArray[np.float64]:
        """Return the states at the times `t`; at a contact, the state after it.

        In flight and in contact: where the ball rolls, it is followed as far as it does.

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
        times = doubles("t", t)
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
        """Contacts that last: the row of `events` with which each begins, from when to when, s."""
        return rolls(self.events)

    def pieces(
        self, step: float, most: int = 2000
    ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.bool_]]:
        """Cut the path into its flights, and its rolls into pieces, for pictures.

        Parameters
        ----------
        step
            Longest piece of a roll, s.
        most
            Pieces of one roll, at most; then they are longer.

        Returns
        -------
        tuple of ndarray
            When each piece begins, (n,), s; the state there, (n, 9); whether the ball rolls from
            there to the next, (n,). The last one is the end.
        """
        starts = np.concatenate([[0.0], self.events["time"]])
        states = np.concatenate([self.release[None], self.events["after"]])
        times, there, rolling = [starts[:1]], [states[:1]], [np.zeros(1, np.bool_)]
        lasting = {row: stop - start for row, start, stop in self.rolls}
        for row in range(len(self.events)):
            times.append(starts[row + 1 : row + 2])
            there.append(states[row + 1 : row + 2])
            rolling.append(np.array([row in lasting]))
            if row in lasting:
                parts = max(1, min(most, int(np.ceil(lasting[row] / step))))
                since = lasting[row] * np.arange(1, parts + 1) / parts
                # Its end too, as it is before what ends it.
                times.append(np.append(starts[row + 1] + since[:-1], starts[row + 2]))
                there.append(self._roll(row).at(since))
                rolling.append(np.arange(1, parts + 1) < parts)
        return np.concatenate(times), np.concatenate(there), np.concatenate(rolling)

    @cached_property
    def _followed(self) -> dict[int, Roll]:
        """Those that were looked into, by the row with which they begin."""
        return {}

    def _roll(self, row: int) -> Roll:
        if row not in self._followed:
            event, until = self.events[row], self.events["time"][row + 1]
            self._followed[row] = self.scene.roll(
                int(event["surface"]), event["after"], until - event["time"], self.parameters
            )
        return self._followed[row]

    def __repr__(self) -> str:
        told = self.events[self.events["kind"] != Event.LEAVE]
        words = [event_words(event, self.scene.surfaces) for event in told]
        runs = ((word, len(list(run))) for word, run in groupby(words))
        names = [f"{word}{f' {times} times' if times > 1 else ''}" for word, times in runs]
        ended = "" if self.outcome is None else f"; {self.outcome.name.lower()}"
        return f"Trajectory({self.duration:.3f} s: {', '.join(['release', *names])}{ended})"

    def plot(self, **options: Any) -> Figure | Axes:
        """Draw the path; options, and what is returned and raised, as for `plots.plot_trajectory`.

        The outcome is said if it is known.
        """
        told = {"outcome": self.outcome} | options
        drawn: Figure | Axes = pictures().plot_trajectory(self, self.parameters, **told)
        return drawn

    def to_pandas(self) -> Any:
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


class Shots:
    """Results of a batch; arrays by shot. A field that was not asked for raises AttributeError.

    Attributes
    ----------
    outcome
        uint8 (n,), an `Outcome`.
    made
        bool (n,), whether `outcome` is MADE.
    contacts
        int32 (n,), contacts before the end.
    counts
        int32 (n, k), contacts by surface, in the order of `surfaces`.
    first
        int8 (n,), first surface touched, -1 for none; int16 among more than 128 bodies.
    time
        float64 (n,), s: at the end plane; capped or short, at the last contact.
    state
        float64 (n, 9), then.
    rolls
        int32 (n,), in a scene where a ball may roll: how many times it began to.
    slip_left
        bool (n,), there: its bounces ended with slip left that friction could not stop. Such a
        shot is CAPPED, at its last contact.
    uncertain
        bool (n,), some decision of the shot lies within its rounding-error bound.
    time_error, state_error
        float64 (n,) and (n, 3), when asked for by name: bounds on the errors of `time` and of each
        component of the position, velocity and spin in `state`, for shots that are not uncertain.
    grip_lost
        float64 (n,), s, when asked for by name, where a ball may roll: when the friction that
        rolling takes first exceeded the body's friction times the normal force; infinite if never.
        The ball is taken to roll on all the same.
    events
        With ``record=True``: the event log, rows in order of shot, then time; their ``kind`` is an
        `Event`. Between a ROLL row and the next one of its shot the ball stays in contact.
    parameters
        Of the scene, as they were simulated with: one number each or (n,).
    scene
        What they were simulated in.
    """

    outcome: NDArray[np.uint8]
    made: NDArray[np.bool_]
    contacts: NDArray[np.int32]
    counts: NDArray[np.int32]
    first: NDArray[np.int8]
    time: NDArray[np.float64]
    state: NDArray[np.float64]
    rolls: NDArray[np.int32]
    slip_left: NDArray[np.bool_]
    uncertain: NDArray[np.bool_]
    time_error: NDArray[np.float64]
    state_error: NDArray[np.float64]
    grip_lost: NDArray[np.float64]
    events: NDArray[Any]

    def __init__(
        self,
        fields: dict[str, NDArray[Any]],
        states: NDArray[np.float64],
        parameters: Mapping[str, float | NDArray[np.float64]],
        scene: Engine = HOOP,
    ) -> None:
        self._fields = fields
        self._states = states
        self.parameters = parameters
        self.scene = scene

    @property
    def surfaces(self) -> tuple[str, ...]:
        """What can be touched, in the order of the columns of `counts`."""
        return self.scene.surfaces

    def __getattr__(self, name: str) -> NDArray[Any]:
        fields = self.__dict__.get("_fields", {})
        if name in fields:
            return fields[name]  # type: ignore[no-any-return]
        if name == "made" and fields and "MADE" in self.scene.outcomes.__members__:
            return np.asarray(self.outcome == self.scene.outcomes["MADE"])
        if name == "events":
            raise AttributeError("events: simulate with record=True to keep the event log")
        if name in ("rolls", "slip_left", "grip_lost") and not self.scene.rolls:
            raise AttributeError(f"{name}: in the scene {self.scene.name} no ball rolls")
        if name in Shots.__annotations__:
            raise AttributeError(f"{name}: not among the fields asked for: {', '.join(fields)}")
        raise AttributeError(f"Shots has no attribute {name!r}")

    def __dir__(self) -> list[str]:
        made = ["made"] if hasattr(self, "made") else []
        return sorted({*super().__dir__(), *self._fields, *made})

    def __len__(self) -> int:
        return len(self._states)

    def __repr__(self) -> str:
        shots = counted(len(self), "shot")
        what = self._counts() if "outcome" in self._fields else ", ".join(self._fields)
        return f"Shots({shots}{': ' if what else ''}{what}; {frames.scene_of(self)})"

    def _counts(self) -> str:
        """Say how many ended how, and how many of them are uncertain."""
        ended = {
            one.name.lower(): np.count_nonzero(self.outcome == one) for one in self.scene.outcomes
        }
        said = ", ".join(f"{count:,} {name}" for name, count in ended.items() if count)
        if "uncertain" not in self._fields or not self.uncertain.any():
            return said
        capped = self.uncertain & (self.outcome == self.scene.outcomes["CAPPED"])
        return f"{said}; {doubtful(int(self.uncertain.sum()), int(capped.sum()))}"

    def plot(self, **options: Any) -> Figure | Axes:
        """Draw the paths; options, and what is returned and raised, as for `plots.plot_fan`."""
        drawn: Figure | Axes = pictures().plot_fan(self, self.parameters, **options)
        return drawn

    def to_pandas(self) -> Any:
        """Return the results as a pandas.DataFrame, a row a shot, units in the columns' names.

        Fields with several numbers a shot are as many columns: ``ring_contacts``, ..., ``x``, ...

        Raises
        ------
        ImportError
            If pandas is missing: what brings it.
        """
        return frames.shots_frame(self)

    def events_to_pandas(self) -> Any:
        """Return the event log as a pandas.DataFrame, a row each event, units in columns' names.

        Its index is the shot, from 0, and the event's number among those of the shot, from 1; the
        columns are those of `Trajectory.to_pandas`. The shots are simulated with ``record=True``.

        Raises
        ------
        AttributeError
            If they were not.
        ImportError
            If pandas is missing: what brings it.
        """
        return frames.events_frame(self)

    def events_to_arrow(self) -> Any:
        """Return the event log as a pyarrow.Table, which Polars takes too; as `events_to_pandas`.

        Shot and event are columns.

        Raises
        ------
        AttributeError
            If the shots were not simulated with ``record=True``.
        ImportError
            If pyarrow is missing: what brings it.
        """
        return frames.events_table(self)

    def to_xarray(self) -> Any:
        """Return the results as an xarray.Dataset over ``shot``, with what the codes mean.

        Parameters of the scene are coordinates where they differ from shot to shot, else in its
        ``attrs``.

        Raises
        ------
        ImportError
            If xarray is missing: what brings it.
        """
        return frames.shots_dataset(self)

    def _repr_html_(self) -> str:
        return frames.shots_html(self)

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
        own = {
            name: float(value if np.ndim(value) == 0 else np.asarray(value)[index])
            for name, value in self.parameters.items()
        }
        known = "outcome" in self._fields
        ended = self.scene.outcomes(int(self.outcome[index])) if known else None
        return Trajectory(self._states[index], self.events[low:high], own, ended, self.scene)
