"""Aiming: the release whose flight comes down through a wanted point of the ring's plane.

The inverse of a flight, in closed form.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.extras import require
from hoopgen.core.parameters import ParameterValues, complete
from hoopgen.core.validation import as_doubles, check_angles
from hoopgen.engine.elementary import arc_tangent, sine_cosine, tangent
from hoopgen.generated.numpy import hoop
from hoopgen.hoop.presets import HOOP_TABLE, PAPER
from hoopgen.hoop.releases import RING_HEIGHT, from_zero, release
from hoopgen.report.quantities import format_variable
from hoopgen.results.shots import Shots
from hoopgen.simulation.simulate import simulate
from hoopgen.study.article_only import of_hoop
from hoopgen.study.named_units import UNIT_OF, named
from hoopgen.text.html import MAX_ROWS, some_rows, table
from hoopgen.text.numbers import format_count
from hoopgen.text.shorten import brief

if TYPE_CHECKING:
    from pandas import DataFrame

NUMBERS = ("speed", "elevation", "entry_angle", "time", "height", "distance", "angle")
"""A value of an `Aim`: a number or an array."""

Arc = Literal["high", "low"]
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
    entry_angle
        Below the horizontal, where the centre comes down through the ring's plane, rad.
    time
        From the release to there, s.
    height, distance, angle
        From where, as for `hoopgen.release`.
    parameters
        Of the scene, as for `aim`.
    """

    speed: Number
    elevation: Number
    entry_angle: Number
    time: Number
    height: Number
    distance: Number
    angle: Number
    parameters: ParameterValues = field(default_factory=lambda: PAPER, repr=False, compare=False)

    @property
    def arguments(self) -> dict[str, Number]:
        """Arguments of `hoopgen.release`; spin may be added, the flight does not depend on it."""
        names = ("speed", "elevation", "height", "distance", "angle")
        return {name: getattr(self, name) for name in names}

    def simulate(self, *, backspin: ArrayLike = 0.0, sidespin: ArrayLike = 0.0) -> Shots:
        """Return the simulated releases, with every contact recorded.

        Parameters
        ----------
        backspin, sidespin
            rad/s, as for `hoopgen.release`.

        Returns
        -------
        Shots
            One a release, in their order; INVALID where no release does it.
        """
        states = release(**self.arguments, backspin=backspin, sidespin=sidespin)
        shape, shots = states.shape[:-1], states.reshape(-1, 9)
        many = {
            name: np.broadcast_to(value, shape).ravel() if np.ndim(value) else value
            for name, value in self.parameters.items()
        }
        return simulate(shots, many, record=True)

    def __str__(self) -> str:
        """Say the release, and what it does without spin; of many, how many meet what."""
        shots = self.simulate()
        times = np.broadcast_to(self.time, np.shape(self.speed)).ravel()
        if np.ndim(self.speed):
            early = sum(1 for row in range(len(shots)) if met_before(shots, row, times[row]))
            return (
                f"{format_count(len(shots), 'release')}; without spin {int(shots.made.sum()):,} "
                "made, "
                f"{early:,} touch something before the point aimed at"
            )
        numbers = (format_variable(name, getattr(self, name)) for name in ("speed", "elevation"))
        entry = format_variable("entry", float(np.asarray(self.entry_angle)))
        return (
            f"{' at '.join(numbers)}, down through the ring's plane after {self.time:.3f} s at "
            f"{entry}; without spin {flight_in_words(shots, 0, float(times[0]))}"
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


@of_hoop
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
    parameters: ParameterValues = PAPER,
) -> Aim:
    """Return the release whose flight comes down through a point of the ring's plane.

    The point lies as high as the ring, 3.048 m above the floor, on the line from the place over the
    ring's centre; no other point can be aimed at. Of `entry`, `elevation` and `speed` one at most
    is given; without, it is the slowest release, which is flat and often touches the ring before.
    All arguments broadcast. The board and the ring are not looked at: ``print`` of the result, or
    its `Aim.simulate`, says what the ball touches, and whether before the point.

    Parameters
    ----------
    height
        Of the release above the floor, m.
    distance
        From the ring's centre on the floor plan, m.
    angle
        Of the place around the ring's centre, rad; the aim does not depend on it.
    entry
        Wanted angle below the horizontal at the point, rad.
    elevation
        Wanted angle of the release above the horizontal, rad.
    speed
        Wanted speed of the release, m/s.
    arc
        High or low flight of the two with that speed.
    depth
        How far past the ring's centre, along the line from the place, the point lies, m.
    parameters
        Of the scene; only gravity matters.

    Returns
    -------
    Aim
        Numbers, or arrays of the arguments' common shape; NaN where no release does it.

    Raises
    ------
    TypeError
        If an argument is not numbers.
    ValueError
        If more than one of the three is given, shapes do not broadcast, angles are degrees, or,
        where all arguments are numbers, no release does it.
    """
    if arc not in ("high", "low"):
        raise ValueError(f"arc: expected 'high' or 'low', got {brief(arc)}")
    parameters = complete(parameters, HOOP_TABLE)
    wanted = {"entry": entry, "elevation": elevation, "speed": speed}
    chosen = [name for name, value in wanted.items() if value is not None]
    if len(chosen) > 1:
        raise ValueError(
            f"aim: expected entry, elevation or speed, or none of them; got {' and '.join(chosen)}"
        )
    given = {"height": height, "distance": distance, "angle": angle, "depth": depth}
    given |= {name: value for name, value in wanted.items() if value is not None}
    arrays = {name: as_doubles(name, value) for name, value in given.items()}
    arrays["distance"] = from_zero("distance", arrays["distance"])
    angles = ("angle", "entry", "elevation")
    check_angles("aim", {name: arrays[name] for name in angles if name in arrays})
    arrays["parameters['gravity']"] = as_doubles("parameters['gravity']", parameters["gravity"])
    try:
        shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items() if array.ndim)
        raise ValueError(f"aim: the shapes do not broadcast: {shapes}") from None
    found = _solved(arrays, arc)
    if not shape and np.isnan(found["speed"]):
        raise ValueError(_why(arrays, arc))
    found |= {name: arrays[name] for name in ("height", "distance", "angle")}
    numbers = {name: _plain(np.broadcast_to(value, shape)) for name, value in found.items()}
    return Aim(**numbers, parameters=parameters)


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


def _solved(given: Mapping[str, NDArray[np.float64]], arc: Arc) -> dict[str, NDArray[np.float64]]:
    """Return speed, elevation, entry angle and time; NaN where there are none."""
    with np.errstate(all="ignore"):
        reach, rise, gravity = _point(given)
        possible = reach > 0.0
        if "elevation" in given:
            slope = tangent(given["elevation"])
            possible &= sine_cosine(given["elevation"])[1] > 0.0
        elif "entry" in given:
            (slope,) = hoop.slope_of_entry(tangent(given["entry"]), reach, rise)
            possible &= sine_cosine(given["entry"])[1] > 0.0
        elif "speed" in given:
            low, high = hoop.slopes_of_speed(given["speed"], reach, rise, gravity)
            slope = high if arc == "high" else low
            possible &= given["speed"] > 0.0
        else:
            slope, _ = hoop.least_speed(reach, rise, gravity)
        (speed,) = hoop.aimed_speed(slope, reach, rise, gravity)
        (down,) = hoop.entry_slope(slope, reach, rise)
        elevation = given.get("elevation", arc_tangent(slope))
        time, _ = hoop.descent(-rise, speed * sine_cosine(elevation)[0], 0.0, gravity)
        found = {
            "speed": given.get("speed", speed),
            "elevation": elevation,
            "entry_angle": given.get("entry", arc_tangent(down)),
            "time": time,
        }
        possible = possible & (down > 0.0) & np.isfinite(speed) & np.isfinite(time)
        return {name: np.where(possible, value, np.nan) for name, value in found.items()}


def _point(given: Mapping[str, NDArray[np.float64]]) -> tuple[Any, Any, Any]:
    """Return distance and height of the point from the release, and gravity."""
    reach, rise = given["distance"] + given["depth"], RING_HEIGHT - given["height"]
    return reach, rise, given["parameters['gravity']"]


def _why(given: Mapping[str, NDArray[np.float64]], arc: Arc) -> str:
    """Say why no release comes down through the point."""
    for name, value in given.items():
        if not np.isfinite(value):
            return f"{name}: expected a finite number, got {value}"
    reach, rise, gravity = _point(given)
    if given["distance"] == 0.0 and reach <= 0.0:
        return (
            "distance: expected above 0: right above or below the ring's centre nothing is thrown "
            "at a point of the ring's plane, unless depth is past the centre; got 0"
        )
    if reach <= 0.0:
        return (
            f"depth: expected a point of the ring's plane before the ball, more than "
            f"{-given['distance']} m past the ring's centre; got {given['depth']}"
        )
    if gravity <= 0.0:
        return f"parameters['gravity']: expected above 0, got {gravity}"
    if "entry" in given or "elevation" in given:
        return _too_flat(given, reach, rise)
    if "speed" in given:
        _, least = hoop.least_speed(reach, rise, gravity)
        if not given["speed"] >= least:
            return (
                f"speed: the point of the ring's plane needs at least {least:.6g} m/s, got "
                f"{given['speed']}"
            )
        return (
            f"arc: the {arc} one of this speed does not come down through the point of the ring's "
            "plane"
        )
    return "aim: the numbers are too large or too small"


def _too_flat(given: Mapping[str, NDArray[np.float64]], reach: Any, rise: Any) -> str:
    """Say which angles there are: none flatter than the line to the point, and level at one end."""
    name = "entry" if "entry" in given else "elevation"
    end = float(hoop.slope_of_entry(0.0, reach, rise)[0]) if name == "elevation" else 0.0
    line = float(rise / reach) if name == "elevation" else float(-rise / reach)
    flattest, value = np.arctan(max(end, line)), given[name]
    return (
        f"{name}: the ball comes down through the point of the ring's plane only at angles within "
        f"{np.degrees(flattest):.2f} and 90° ({flattest:.4f} and 1.5708 rad); "
        f"got {np.degrees(value):.4g}° ({value} rad)"
    )


def _plain(array: NDArray[np.float64]) -> Number:
    return array if array.ndim else float(array)
