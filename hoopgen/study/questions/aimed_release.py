"""Releases that are aimed, and what their flights meet."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.event_log import describe_passages
from hoopgen.core.extras import require
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.variables import STATE
from hoopgen.hoop.presets import PAPER
from hoopgen.hoop.releases import release
from hoopgen.report.quantities import format_variable
from hoopgen.results.shots import Shots
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.hoop import HOOP
from hoopgen.simulation.simulate import simulate
from hoopgen.study.named_units import UNIT_OF, named
from hoopgen.text.html import MAX_ROWS, some_rows, table
from hoopgen.text.numbers import format_count

if TYPE_CHECKING:
    from pandas import DataFrame

NUMBERS = ("speed", "elevation", "azimuth", "entry_angle", "time", "height", "distance", "angle")
"""The columns of an `Aim`, each a number or an array."""

_RELEASE = ("speed", "elevation", "azimuth", "height", "distance", "angle")

Number = float | NDArray[np.float64]


@dataclass(frozen=True)
class Aim:
    """A release that is aimed, or as many as were asked for.

    Attributes
    ----------
    speed
        m/s; NaN where no release does it.
    elevation
        rad.
    azimuth
        rad, as for `hoopgen.release`: 0 where the point lies on the line over the ring's centre and
        neither a spin nor a moving place turns the ball aside. In a scene without a hoop it is
        measured from the line to the point.
    entry_angle
        Below the horizontal, where the centre comes down through the point, rad.
    time
        From the release to there, s.
    height, distance, angle
        From where, as for `hoopgen.release`; in a scene without a hoop the height is its z, and the
        others are those around the point.
    target
        The point, x, y and z in the scene's coordinates, m, (..., 3).
    spins
        Those of `backspin` and `sidespin` that were given, rad/s.
    moving
        Velocity of the place, m/s, (..., 2).
    parameters
        Of the scene, as for `aim`.
    scene
        The scene.
    position
        Of the release in a scene without a hoop, m, (..., 3); None at a hoop.
    """

    speed: Number
    elevation: Number
    azimuth: Number
    entry_angle: Number
    time: Number
    height: Number
    distance: Number
    angle: Number
    target: NDArray[np.float64] = field(repr=False, compare=False)
    spins: Mapping[str, Number] = field(default_factory=dict)
    moving: NDArray[np.float64] | None = field(default=None, repr=False, compare=False)
    parameters: ParameterValues = field(default_factory=lambda: PAPER, repr=False, compare=False)
    scene: Engine = field(default=HOOP, repr=False, compare=False)
    position: NDArray[np.float64] | None = field(default=None, repr=False, compare=False)

    @property
    def arguments(self) -> dict[str, Number]:
        """The release for `hoopgen.Scatter`: at a hoop the arguments of `hoopgen.release`.

        They have the spins that were given; others may be added without air, where the flight does
        not depend on them. If the place moves, its velocity is added to that of the release;
        `states` does that. In a scene without a hoop they are the components of the state.
        """
        if self.position is not None:
            parts = np.moveaxis(self.states(), -1, 0)
            return {name: plain(part) for name, part in zip(STATE, parts, strict=True)}
        return self._release

    @property
    def _release(self) -> dict[str, Number]:
        return {**{name: getattr(self, name) for name in _RELEASE}, **self.spins}

    def states(
        self, *, backspin: ArrayLike | None = None, sidespin: ArrayLike | None = None
    ) -> NDArray[np.float64]:
        """Return the states of the releases, (..., 9), with the velocity of their place.

        Parameters
        ----------
        backspin, sidespin
            rad/s, as for `hoopgen.release`; None: as they were given to `aim`, else 0.
        """
        spins = {"backspin": backspin, "sidespin": sidespin}
        given = {name: one for name, one in spins.items() if one is not None}
        states = release(**{**self._release, **given})
        if self.position is not None:
            states[..., :3] = self.position
        if self.moving is not None:
            states[..., 3:5] += self.moving
        return states

    @property
    def landing_error(self) -> Number:
        """Distance of the ball's centre from the point at `time`, as it is simulated, m.

        NaN where no release does it.
        """
        states = self.states()
        parameters = {n: np.asarray(value) for n, value in self.parameters.items()}
        with np.errstate(invalid="ignore"):
            there = self.scene.fly(np.asarray(self.time), states, parameters)[..., :3]
            return plain(np.sqrt(np.sum((there - self.target) ** 2, axis=-1)))

    def simulate(
        self, *, backspin: ArrayLike | None = None, sidespin: ArrayLike | None = None
    ) -> Shots:
        """Return the simulated releases, with every contact recorded.

        Parameters
        ----------
        backspin, sidespin
            As for `states`.

        Returns
        -------
        Shots
            One a release, in their order; INVALID where no release does it.
        """
        states = self.states(backspin=backspin, sidespin=sidespin)
        shape, shots = states.shape[:-1], states.reshape(-1, 9)
        many = {
            name: np.broadcast_to(value, shape).ravel() if np.ndim(value) else value
            for name, value in self.parameters.items()
        }
        return simulate(shots, many, scene=self.scene, record=True)

    def __str__(self) -> str:
        """Say the release, and what it does; of many, how many meet what."""
        shots = self.simulate()
        spin = (
            "with its spin" if any(np.any(one) for one in self.spins.values()) else "without spin"
        )
        times = np.broadcast_to(self.time, np.shape(self.speed)).ravel()
        if np.ndim(self.speed):
            early = sum(1 for row in range(len(shots)) if met_before(shots, row, times[row]))
            ends = zip(*np.unique(shots.outcome, return_counts=True), strict=True)
            said = [f"{n:,} {shots.scene.outcomes(int(end)).name.lower()}" for end, n in ends]
            if shots.scene.has_hoop:
                said = [f"{int(shots.made.sum()):,} made"]
            return (
                f"{format_count(len(shots), 'release')}; {spin} {', '.join(said)}, {early:,} touch "
                "something before the point aimed at"
            )
        numbers = (format_variable(name, getattr(self, name)) for name in ("speed", "elevation"))
        entry = format_variable("entry", float(np.asarray(self.entry_angle)))
        aside = (
            f", azimuth {format_variable('azimuth', float(self.azimuth))}" if self.azimuth else ""
        )
        raised = self.position is not None or self.target[..., 2]
        where = "point" if raised else "ring's plane"
        return (
            f"{' at '.join(numbers)}{aside}, down through the {where} after {self.time:.3f} s at "
            f"{entry}; {spin} {flight_in_words(shots, 0, float(times[0]))}"
        )

    def to_pandas(self) -> DataFrame:
        """Return the releases as a pandas.DataFrame, a row each, units in the columns' names.

        Raises
        ------
        ImportError
            If pandas is missing: what brings it.
        """
        columns = {named(name): one for name, one in self._columns().items()}
        frame: DataFrame = require("pandas", "to_pandas").DataFrame(columns)
        return frame

    def _columns(self) -> dict[str, NDArray[np.float64]]:
        """Return the releases, (n,) each."""
        return {name: np.ravel(getattr(self, name)) for name in NUMBERS}

    def _repr_html_(self) -> str:
        columns = self._columns()
        rows = some_rows(len(columns["speed"]))
        turned = {name: UNIT_OF[name] == "rad" for name in columns}
        head = [f"{name} ({'°' if turned[name] else UNIT_OF[name]})" for name in columns]
        shown = [np.degrees(c[rows]) if turned[name] else c[rows] for name, c in columns.items()]
        gap = MAX_ROWS // 2 if len(rows) < len(columns["speed"]) else None
        return table("", head, zip(*(c.tolist() for c in shown), strict=True), gap=gap)


def met_before(shots: Shots, row: int, time: float) -> tuple[str, float] | None:
    """Return the body that a shot touches before a time, and when; None if it touches none.

    Parameters
    ----------
    shots
        Results with their contacts (``record=True``).
    row
        The index of the shot.
    time
        The time since its release, s.
    """
    if shots.contacts[row] == 0:
        return None
    first = shots.trajectory(row).events[0]
    if not float(first["time"]) < time:
        return None
    return shots.surfaces[int(first["surface"])], float(first["time"])


def flight_in_words(shots: Shots, row: int, time: float) -> str:
    """Describe the end of a shot, its contacts, and those before the point that it is aimed at.

    Parameters
    ----------
    time
        When it would come down through the point aimed at, s.
    """
    outcome = shots.scene.outcomes(int(shots.outcome[row])).name.lower()
    contacts = int(shots.contacts[row])
    ended = ", before the point aimed at" if shots.time[row] < time else ""
    if not contacts:
        return f"{outcome} without a contact{ended}"
    counts = zip(shots.surfaces, shots.counts[row].tolist(), strict=True)
    bodies = ", ".join(f"{name} {count}" for name, count in counts if count)
    bodies += describe_passages(contacts, int(shots.counts[row].sum()))
    text = f"{outcome} after {format_count(contacts, 'contact')} ({bodies})"
    if (met := met_before(shots, row, time)) is None:
        return text + ended
    body, at = met
    return f"{text}; it touches the {body} after {at:.3f} s, before the point aimed at"


def plain(array: NDArray[np.float64]) -> Number:
    """Return an array, or the float of an array without axes."""
    return array if array.ndim else float(array)
