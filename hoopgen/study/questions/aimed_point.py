"""The point that a release is aimed at, as the place of the release sees it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.engine.elementary import arc_tangent, hypotenuse, sine_cosine
from hoopgen.generated.numpy import hoop
from hoopgen.hoop.aiming import aimed
from hoopgen.hoop.flights import Flights
from hoopgen.hoop.parabolas import Arc
from hoopgen.hoop.releases import RING_HEIGHT

Floats = NDArray[np.float64]
Given = Mapping[str, Floats]

_WANTED = ("entry", "elevation", "speed")
_SPINS = ("backspin", "sidespin")


@dataclass(frozen=True)
class Point:
    """A point, and the velocity of the place, in the directions to the point and left of that.

    Attributes
    ----------
    reach, rise
        Horizontal distance and height of the point from the release, m.
    bearing
        Of the point, rad, from the line over the ring's centre; positive to the left.
    place
        x, y and z of the point in the scene's coordinates, m, (..., 3).
    moving
        m/s, ahead and to the left; None if the place is at rest.
    release
        `height`, `distance` and `angle` of the release.
    """

    reach: Floats
    rise: Floats
    bearing: Floats
    place: Floats
    moving: tuple[Floats, Floats] | None
    release: Given

    @classmethod
    def of(cls, given: Given) -> Point:
        """Return the point of the arguments of `aim`, of which vectors are components."""
        if "position x" in given:
            return cls._between(given)
        sine, cosine = sine_cosine(given["angle"])
        if "target x" in given:
            x, y, z = (given[f"target {axis}"] for axis in "xyz")
            ahead = given["distance"] - (x * cosine + y * sine)
            left = x * sine - y * cosine
            reach, bearing = hypotenuse(left, ahead), arc_tangent(left, ahead)
            rise = z + (RING_HEIGHT - given["height"])
        else:
            x, y, z = -given["depth"] * cosine, -given["depth"] * sine, np.zeros(())
            reach, rise = given["distance"] + given["depth"], RING_HEIGHT - given["height"]
            bearing = np.zeros(())
        place = np.stack(np.broadcast_arrays(x, y, z), axis=-1)
        release = {name: given[name] for name in ("height", "distance", "angle")}
        return cls(reach, rise, bearing, place, _ahead(given, given["angle"], bearing), release)

    @classmethod
    def _between(cls, given: Given) -> Point:
        """Return the point of a scene without a hoop, where the release has a position."""
        way = [given[f"position {axis}"] - given[f"target {axis}"] for axis in "xyz"]
        reach, angle = hypotenuse(way[1], way[0]), arc_tangent(way[1], way[0])
        place = np.stack(np.broadcast_arrays(*(given[f"target {a}"] for a in "xyz")), axis=-1)
        release = {"height": given["position z"], "distance": reach, "angle": angle}
        bearing = np.zeros(())
        return cls(reach, -way[2], bearing, place, _ahead(given, angle, bearing), release)

    def solved(self, given: Given, flights: Flights, arc: Arc) -> dict[str, Any]:
        """Return speed, elevation, azimuth, entry angle and time; NaN where there are none.

        Parameters
        ----------
        given
            The arguments of `aim`, numbers or arrays.
        flights
            How balls fly in the scene.
        arc
            Which of two arcs is wanted where there are two.
        """
        wanted = {name: given[name] for name in _WANTED if name in given}
        spins = {name: given[name] for name in _SPINS if name in given}
        found: dict[str, Any] = aimed(
            wanted, self.reach, self.rise, flights, arc, moving=self.moving, **spins
        )
        return found | {"azimuth": self.bearing + found["azimuth"]}


def _ahead(given: Given, angle: Floats, bearing: Floats) -> tuple[Floats, Floats] | None:
    """Return the velocity of the place towards the point and to the left; None if it is at rest.

    Parameters
    ----------
    angle
        Of the place around the origin of the floor plan, or around the point, rad.
    bearing
        Of the point from the line over that, rad.
    """
    if "moving x" not in given:
        return None
    along, across = given["moving x"], given["moving y"]
    sine, cosine = sine_cosine(angle)
    ahead, left = -(along * cosine + across * sine), along * sine - across * cosine
    sine, cosine = sine_cosine(bearing)
    return ahead * cosine + left * sine, left * cosine - ahead * sine


def why_none(
    point: Point, given: Given, flights: Flights, arc: Arc, shape: tuple[int, ...]
) -> list[str]:
    """Return for each row why no release comes down through the point.

    Parameters
    ----------
    point
        The points of the arguments.
    given
        The arguments of `aim`, numbers or arrays.
    flights
        How balls fly in the scene.
    arc
        Which of two arcs is wanted.
    shape
        The shape to which the arguments broadcast; its entries are the rows.
    """
    least = np.full((), np.nan)
    parabola = flights.scene is None and point.moving is None
    if "speed" in given and not parabola:
        others = {name: value for name, value in given.items() if name != "speed"}
        least = point.solved(others, flights, arc)["speed"]

    def at(value: Floats, row: tuple[int, ...]) -> Floats:
        return np.asarray(np.broadcast_to(value, shape)[row])

    return [
        _why_none(
            at(point.reach, row),
            at(point.rise, row),
            {name: at(value, row) for name, value in given.items()},
            float(at(flights.gravity, row)),
            arc,
            None if parabola else float(at(least, row)),
        )
        for row in np.ndindex(shape)
    ]


def _why_none(
    reach: Floats, rise: Floats, given: Given, gravity: float, arc: Arc, least: float | None
) -> str:
    """Say why there is no release; `least` is the least speed of flights that are no parabolas."""
    for name, value in given.items():
        if not np.isfinite(value):
            return f"{name}: expected a finite number, got {value}"
    if reach <= 0.0:
        if "target x" in given:
            return "target: expected a point that is not right above or below the release"
        if given["distance"] == 0.0:
            return (
                "distance: expected above 0: right above or below the ring's centre nothing is "
                "thrown at a point of the ring's plane, unless depth is past the centre; got 0"
            )
        return (
            f"depth: expected a point of the ring's plane before the ball, more than "
            f"{-given['distance']} m past the ring's centre; got {given['depth']}"
        )
    if gravity <= 0.0:
        return f"parameters['gravity']: expected above 0, got {gravity}"
    if least is not None:
        return _none_found(given, arc, least)
    where = "the point" if "target x" in given else "the point of the ring's plane"
    if "entry" in given or "elevation" in given:
        return _too_flat(given, where, reach, rise)
    if "speed" in given:
        _, slowest = hoop.least_speed(reach, rise, gravity)
        if not given["speed"] >= slowest:
            return f"speed: {where} needs at least {slowest:.6g} m/s, got {given['speed']}"
        return f"arc: the {arc} one of this speed does not come down through {where}"
    return "aim: the numbers are too large or too small"


def _none_found(given: Given, arc: Arc, least: float) -> str:
    """Say why no flight was found that is no parabola from a place at rest."""
    named = [name for name in _WANTED if name in given]
    if not named or (named == ["speed"] and np.isnan(least)):
        return (
            "aim: no flight comes down through the point; it is too far, or the numbers too large"
        )
    (name,) = named
    if name == "speed":
        if not given["speed"] >= least:
            return f"speed: the point needs at least {least:.6g} m/s, got {given['speed']}"
        return f"arc: no {arc} one of this speed comes down through the point"
    return (
        f"{name}: no flight with this angle comes down through the point; "
        f"got {np.degrees(given[name]):.4g}° ({given[name]} rad)"
    )


def _too_flat(given: Given, where: str, reach: Any, rise: Any) -> str:
    """Say which angles there are: none flatter than the line to the point, and level at one end."""
    name = "entry" if "entry" in given else "elevation"
    end = float(hoop.slope_of_entry(0.0, reach, rise)[0]) if name == "elevation" else 0.0
    line = float(rise / reach) if name == "elevation" else float(-rise / reach)
    flattest, value = np.arctan(max(end, line)), given[name]
    return (
        f"{name}: the ball comes down through {where} only at angles within "
        f"{np.degrees(flattest):.2f} and 90° ({flattest:.4f} and 1.5708 rad); "
        f"got {np.degrees(value):.4g}° ({value} rad)"
    )
