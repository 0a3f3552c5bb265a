"""Aiming: the release whose flight comes down through a wanted point.

The inverse of a flight: in closed form along a parabola, by Newton's method through air or where
the shooter moves.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.parameters import ParameterValues, complete
from hoopgen.core.si_checks import check_angles, check_lengths, check_spins
from hoopgen.core.validation import as_doubles
from hoopgen.hoop.flights import Flights
from hoopgen.hoop.parabolas import Arc
from hoopgen.hoop.releases import from_zero
from hoopgen.scene.lookup import SceneLike
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.lookup import engine_of
from hoopgen.text.shorten import brief

from .aim_scene import components, flights_of, target_of
from .aimed_point import Point, why_none
from .aimed_release import Aim, plain

_SPINS = ("backspin", "sidespin")


@check_arguments
def aim(
    *,
    height: ArrayLike | None = None,
    distance: ArrayLike | None = None,
    angle: ArrayLike = 0.0,
    position: ArrayLike | None = None,
    entry: ArrayLike | None = None,
    elevation: ArrayLike | None = None,
    speed: ArrayLike | None = None,
    arc: Arc = "high",
    depth: ArrayLike = 0.0,
    target: ArrayLike | str | None = None,
    backspin: ArrayLike | None = None,
    sidespin: ArrayLike | None = None,
    moving: ArrayLike | None = None,
    parameters: ParameterValues | None = None,
    scene: SceneLike = None,
) -> Aim:
    """Return the release whose flight comes down through a point.

    Of `entry`, `elevation` and `speed` one at most is given; without, it is the slowest release,
    which is flat and often touches the ring before. All arguments broadcast. The bodies are not
    looked at: ``print`` of the result, or its `Aim.simulate`, says what the ball touches, and
    whether before the point. Through air, and from a place that moves, the release is found by
    Newton's method on the simulated flight; `Aim.landing_error` says how far from the point it is.

    At a hoop `height` and `distance` are given, in any other scene `position` and `target`.

    Parameters
    ----------
    height
        Of the release above the floor, m.
    distance
        From the ring's centre on the floor plan, m.
    angle
        Of the place around the ring's centre, rad.
    position
        Of the ball's centre at the release in a scene without a hoop, x, y and z, m, (..., 3).
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
        In a scene without a hoop it may be the name of a body: of a torus, a disc, a sphere or a
        box it is the centre, of a cone the middle of its open end, and of a surface of revolution
        the middle of its highest circle.
    backspin, sidespin
        rad/s, as for `hoopgen.release`. Without air the flight does not depend on them; through air
        the azimuth corrects what a sidespin turns the ball aside. None: 0.
    moving
        Velocity of the place over the floor in the scene's x and y, m/s, (..., 2), such as that of
        a robot that shoots while it drives. Speed, elevation and azimuth are relative to it.
    parameters
        Of the scene; gravity matters, and in air the ball and the air. None: the usual ones.
    scene
        `hoopgen.HOOP`, `COURT`, `AIR` or `COURT_AIR`, or a scene whose gravity points along -z;
        None: `HOOP`.

    Returns
    -------
    Aim
        Numbers, or arrays of the arguments' common shape; NaN where no release does it.

    Raises
    ------
    TypeError
        If an argument is not numbers.
    ValueError
        If more than one of the three is given, or `depth` with `target`, the place is not given as
        the scene needs it, shapes do not broadcast, angles are degrees, gravity does not point
        along -z, or, where all arguments are numbers, no release does it.
    """
    problem = _problem(
        height=height,
        distance=distance,
        angle=angle,
        position=position,
        entry=entry,
        elevation=elevation,
        speed=speed,
        arc=arc,
        depth=depth,
        target=target,
        backspin=backspin,
        sidespin=sidespin,
        moving=moving,
        parameters=parameters,
        scene=scene,
    )
    point, arrays, shape = problem.point, problem.arrays, problem.shape
    found = point.solved(arrays, problem.flights, arc)
    if not shape and np.isnan(found["speed"]):
        raise ValueError(problem.why_none()[0])
    found |= point.release
    numbers = {name: plain(np.broadcast_to(value, shape)) for name, value in found.items()}
    spins = {name: arrays[name] for name in _SPINS if name in arrays}
    return Aim(
        **numbers,
        target=point.place,
        spins={name: plain(np.broadcast_to(value, shape)) for name, value in spins.items()},
        moving=_stacked(arrays, "moving", "xy"),
        parameters=problem.parameters,
        scene=problem.engine,
        position=_stacked(arrays, "position", "xyz"),
    )


def why_no_release(**arguments: Any) -> list[str]:
    """Return for each row of arguments of `aim` without a release the reason why it has none.

    Parameters
    ----------
    arguments
        Those of `aim`, numbers or (n,), for none of which there is a release.
    """
    return _problem(**arguments).why_none()


@dataclass(frozen=True)
class _Problem:
    """The checked arguments of `aim`, with the point and the flights that they mean."""

    engine: Engine
    parameters: Mapping[str, Any]
    point: Point
    arrays: Mapping[str, NDArray[np.float64]]
    shape: tuple[int, ...]
    flights: Flights
    arc: Arc

    def why_none(self) -> list[str]:
        """Return why no release comes down through the point, for each row."""
        return why_none(self.point, self.arrays, self.flights, self.arc, self.shape)


def _problem(
    *,
    height: ArrayLike | None = None,
    distance: ArrayLike | None = None,
    angle: ArrayLike = 0.0,
    position: ArrayLike | None = None,
    entry: ArrayLike | None = None,
    elevation: ArrayLike | None = None,
    speed: ArrayLike | None = None,
    arc: Arc = "high",
    depth: ArrayLike = 0.0,
    target: ArrayLike | str | None = None,
    backspin: ArrayLike | None = None,
    sidespin: ArrayLike | None = None,
    moving: ArrayLike | None = None,
    parameters: ParameterValues | None = None,
    scene: SceneLike = None,
) -> _Problem:
    """Return the checked arguments of `aim`."""
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
    place = {"height": height, "distance": distance, "angle": angle, "depth": depth}
    _check_place(engine, {**place, "position": position, "target": target})
    optional = {**wanted, "backspin": backspin, "sidespin": sidespin}
    if engine.has_hoop:
        optional |= place
    given = {name: value for name, value in optional.items() if value is not None}
    arrays = {name: as_doubles(name, value) for name, value in given.items()}
    if engine.has_hoop:
        arrays["distance"] = from_zero("distance", arrays["distance"])
        check_lengths("aim", {name: arrays[name] for name in ("height", "distance", "depth")})
    angles = ("angle", "entry", "elevation")
    check_angles("aim", {name: arrays[name] for name in angles if name in arrays})
    check_spins("aim", {name: arrays[name] for name in _SPINS if name in arrays})
    flights = flights_of(engine, parameters)
    if target is not None:
        arrays |= target_of(engine, parameters, target)
    for name, vector, axes in (("position", position, "xyz"), ("moving", moving, "xy")):
        if vector is not None:
            arrays |= components(name, vector, axes)
    arrays |= {f"parameters[{name!r}]": value for name, value in flights.parameters.items()}
    arrays.setdefault("parameters['gravity']", flights.gravity)
    try:
        shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items() if array.ndim)
        raise ValueError(f"aim: the shapes do not broadcast: {shapes}") from None
    return _Problem(engine, parameters, Point.of(arrays), arrays, shape, flights, arc)


def _check_place(engine: Engine, given: Mapping[str, Any]) -> None:
    """Refuse a place, or a target, that is not given as the scene needs it."""
    if engine.has_hoop:
        if given["position"] is not None:
            raise ValueError(
                "position: it is that of a release in a scene without a hoop; give height and "
                "distance"
            )
        missing = [name for name in ("height", "distance") if given[name] is None]
        if missing:
            raise TypeError(f"aim: missing {' and '.join(missing)}")
        if given["target"] is not None and np.any(given["depth"]):
            raise ValueError("aim: expected depth or target; got both")
        return
    stray = [name for name in ("height", "distance") if given[name] is not None]
    stray += [name for name in ("angle", "depth") if np.any(given[name])]
    if stray:
        raise ValueError(
            f"{stray[0]}: it is that of a release at a hoop, and the scene {engine.name} has none; "
            "give position and target"
        )
    missing = [name for name in ("position", "target") if given[name] is None]
    if missing:
        raise TypeError(f"aim: missing {' and '.join(missing)}, which a scene without a hoop needs")


def _stacked(
    arrays: Mapping[str, NDArray[np.float64]], name: str, axes: str
) -> NDArray[np.float64] | None:
    """Return the vector of components by name; None if it is not given."""
    if f"{name} {axes[0]}" not in arrays:
        return None
    return np.stack(np.broadcast_arrays(*(arrays[f"{name} {axis}"] for axis in axes)), axis=-1)
