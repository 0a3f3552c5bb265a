"""Aiming: the release whose flight comes down through a wanted point.

The inverse of a flight: in closed form along a parabola, by Newton's method through air or where
the shooter moves.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.extras import require
from hoopgen.core.parameters import ParameterValues, complete
from hoopgen.core.si_checks import check_angles, check_lengths, check_spins
from hoopgen.core.validation import as_doubles
from hoopgen.hoop.flights import is_in_air
from hoopgen.hoop.parabolas import Arc
from hoopgen.hoop.presets import PAPER
from hoopgen.hoop.releases import from_zero, release
from hoopgen.report.quantities import format_variable
from hoopgen.results.shots import Shots
from hoopgen.scene.lookup import SceneLike, check_hoop
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.hoop import HOOP
from hoopgen.simulation.lookup import engine_of
from hoopgen.simulation.simulate import simulate
from hoopgen.study.named_units import UNIT_OF, named
from hoopgen.text.html import MAX_ROWS, some_rows, table
from hoopgen.text.numbers import format_count
from hoopgen.text.shorten import brief

from .aimed_point import Point, why_none

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
        neither a spin nor a moving place turns the ball aside.
    entry_angle
        Below the horizontal, where the centre comes down through the point, rad.
    time
        From the release to there, s.
    height, distance, angle
        From where, as for `hoopgen.release`.
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

    @property
    def arguments(self) -> dict[str, Number]:
        """Arguments of `hoopgen.release`, with the spins that were given.

        Other spins may be added without air, where the flight does not depend on them. If the place
        moves, its velocity is added to that of the release; `states` does that.
        """
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
        states = release(**{**self.arguments, **given})
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
            return _plain(np.sqrt(np.sum((there - self.target) ** 2, axis=-1)))

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
            return (
                f"{format_count(len(shots), 'release')}; {spin} {int(shots.made.sum()):,} made, "
                f"{early:,} touch something before the point aimed at"
            )
        numbers = (format_variable(name, getattr(self, name)) for name in ("speed", "elevation"))
        entry = format_variable("entry", float(np.asarray(self.entry_angle)))
        aside = (
            f", azimuth {format_variable('azimuth', float(self.azimuth))}" if self.azimuth else ""
        )
        where = "point" if self.target[..., 2] else "ring's plane"
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


@check_arguments
def aim(
    *,
    height: ArrayLike,
    distance: ArrayLike,
    angle: ArrayLike = 0.0,
    entry: ArrayLike | None = None,
    elevation: ArrayLike | None = None,
    speed: ArrayLike | None = None,
    arc: Arc = "high",
    depth: ArrayLike = 0.0,
    target: ArrayLike | None = None,
    backspin: ArrayLike | None = None,
    sidespin: ArrayLike | None = None,
    moving: ArrayLike | None = None,
    parameters: ParameterValues | None = None,
    scene: SceneLike = None,
) -> Aim:
    """Return the release whose flight comes down through a point.

    Of `entry`, `elevation` and `speed` one at most is given; without, it is the slowest release,
    which is flat and often touches the ring before. All arguments broadcast. The board and the ring
    are not looked at: ``print`` of the result, or its `Aim.simulate`, says what the ball touches,
    and whether before the point. Through air, and from a place that moves, the release is found by
    Newton's method on the simulated flight; `Aim.landing_error` says how far from the point it is.

    Parameters
    ----------
    height
        Of the release above the floor, m.
    distance
        From the ring's centre on the floor plan, m.
    angle
        Of the place around the ring's centre, rad.
    entry
        Wanted angle below the horizontal at the point, rad.
    elevation
        Wanted angle of the release above the horizontal, rad.
    speed
        Wanted speed of the release, m/s.
    arc
        High or low flight of the two with that speed.
    depth
        How far past the ring's centre the point lies, m: as high as the ring, 3.048 m above the
        floor, on the line from the place over the centre.
    target
        The point itself, x, y and z in the scene's coordinates, m, (..., 3), in place of `depth`.
    backspin, sidespin
        rad/s, as for `hoopgen.release`. Without air the flight does not depend on them; through air
        the azimuth corrects what a sidespin turns the ball aside. None: 0.
    moving
        Velocity of the place over the floor in the scene's x and y, m/s, (..., 2), such as that of
        a robot that shoots while it drives. Speed, elevation and azimuth are relative to it.
    parameters
        Of the scene; gravity matters, and in air the ball and the air. None: the usual ones.
    scene
        A hoop: `hoopgen.HOOP`, `COURT`, `AIR` or `COURT_AIR`; None: `HOOP`.

    Returns
    -------
    Aim
        Numbers, or arrays of the arguments' common shape; NaN where no release does it.

    Raises
    ------
    TypeError
        If an argument is not numbers.
    ValueError
        If more than one of the three is given, or `depth` with `target`, shapes do not broadcast,
        angles are degrees, the scene has no hoop, or, where all arguments are numbers, no release
        does it.
    """
    check_hoop("aim", scene)
    engine = engine_of(scene)
    if arc not in ("high", "low"):
        raise ValueError(f"arc: expected 'high' or 'low', got {brief(arc)}")
    parameters = complete(parameters, engine.table)
    wanted = {"entry": entry, "elevation": elevation, "speed": speed}
    chosen = [name for name, value in wanted.items() if value is not None]
    if len(chosen) > 1:
        raise ValueError(
            f"aim: expected entry, elevation or speed, or none of them; got {' and '.join(chosen)}"
        )
    given = {"height": height, "distance": distance, "angle": angle, "depth": depth}
    optional = {**wanted, "backspin": backspin, "sidespin": sidespin}
    given |= {name: value for name, value in optional.items() if value is not None}
    arrays = {name: as_doubles(name, value) for name, value in given.items()}
    arrays["distance"] = from_zero("distance", arrays["distance"])
    check_lengths("aim", {name: arrays[name] for name in ("height", "distance", "depth")})
    angles = ("angle", "entry", "elevation")
    check_angles("aim", {name: arrays[name] for name in angles if name in arrays})
    spins: dict[str, NDArray[np.float64]] = {
        name: arrays[name] for name in ("backspin", "sidespin") if name in arrays
    }
    check_spins("aim", spins)
    if target is not None and np.any(arrays["depth"]):
        raise ValueError("aim: expected depth or target; got both")
    arrays |= _components("target", target, "xyz") | _components("moving", moving, "xy")
    flown = {n: v for n, v in parameters.items() if n == "gravity" or is_in_air(parameters)}
    arrays |= {f"parameters[{n!r}]": as_doubles(f"parameters[{n!r}]", v) for n, v in flown.items()}
    try:
        shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items() if array.ndim)
        raise ValueError(f"aim: the shapes do not broadcast: {shapes}") from None
    point = Point.of(arrays)
    found = point.solved(arrays, flown, arc)
    if not shape and np.isnan(found["speed"]):
        raise ValueError(why_none(point, arrays, flown, arc))
    found |= {name: arrays[name] for name in ("height", "distance", "angle")}
    numbers = {name: _plain(np.broadcast_to(value, shape)) for name, value in found.items()}
    velocity = None
    if moving is not None:
        parts = np.broadcast_arrays(arrays["moving x"], arrays["moving y"])
        velocity = np.stack(parts, axis=-1)
    return Aim(
        **numbers,
        target=point.place,
        spins={name: _plain(np.broadcast_to(value, shape)) for name, value in spins.items()},
        moving=velocity,
        parameters=parameters,
        scene=engine,
    )


def _components(name: str, given: ArrayLike | None, axes: str) -> dict[str, NDArray[np.float64]]:
    """Return the components of a vector by name; none if it is not given."""
    if given is None:
        return {}
    vector = as_doubles(name, given)
    if not vector.ndim or vector.shape[-1] != len(axes):
        expected = " and ".join(", ".join(axes).rsplit(", ", 1))
        raise ValueError(
            f"{name}: expected {expected}, shape (..., {len(axes)}), got shape {vector.shape}"
        )
    return {f"{name} {axis}": vector[..., k] for k, axis in enumerate(axes)}


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
    if not contacts:
        return f"{outcome} without a contact"
    counts = zip(shots.surfaces, shots.counts[row].tolist(), strict=True)
    bodies = ", ".join(f"{name} {count}" for name, count in counts if count)
    text = f"{outcome} after {format_count(contacts, 'contact')} ({bodies})"
    if (met := met_before(shots, row, time)) is None:
        return text
    body, at = met
    return f"{text}; it touches the {body} after {at:.3f} s, before the point aimed at"


def _plain(array: NDArray[np.float64]) -> Number:
    return array if array.ndim else float(array)
