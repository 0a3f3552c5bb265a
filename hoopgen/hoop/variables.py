"""Variables of a shot at a hoop: arguments of its release, their alternatives, and parameters."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.units import Kind
from hoopgen.core.validation import as_doubles, check_spins
from hoopgen.core.validation import check_angles as check_radians
from hoopgen.core.variables import STATE, Releases, Variable, check_names
from hoopgen.engine.elementary import arc_tangent, hypotenuse, sine_cosine, tangent
from hoopgen.generated.numpy import hoop
from hoopgen.text.shorten import join_names

from .presets import NAMES, PAPER
from .releases import RING_HEIGHT, states_of

__all__ = [
    "ARGUMENTS",
    "ALTERNATIVE_VARIABLES",
    "STANDS_FOR",
    "VARIABLES",
    "change_variables",
    "check_angles",
    "make_releases",
    "release_arguments",
    "resolve_variables",
]


def _listed(*variables: Variable) -> Mapping[str, Variable]:
    return MappingProxyType({variable.name: variable for variable in variables})


ARGUMENTS = _listed(
    Variable("speed", "speed", "release speed"),
    Variable("elevation", "angle", "release angle"),
    Variable("azimuth", "angle", "direction, positive to the left"),
    Variable("backspin", "spin", "backspin"),
    Variable("sidespin", "spin", "sidespin"),
    Variable("height", "length", "release height"),
    Variable("distance", "length", "distance from the ring's centre"),
    Variable("angle", "angle", "place around the ring"),
)
"""The arguments of `hoopgen.release`."""

ALTERNATIVE_VARIABLES = _listed(
    Variable("aim", "length", "aim past the ring's centre"),
    Variable("entry", "angle", "entry angle"),
    Variable("x", "length", "place on the floor, x"),
    Variable("y", "length", "place on the floor, y"),
)
"""Variables that replace arguments: `aim` the speed, `entry` the elevation, `x` and `y` the
distance and the angle."""

OF_PARABOLAS = ("aim", "entry")
"""The variables that stand for a release by the closed form of a parabola: not in air."""

STANDS_FOR: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "aim": ("speed",),
        "entry": ("speed", "elevation"),
        "x": ("distance", "angle"),
        "y": ("distance", "angle"),
    }
)
"""The arguments that each of them replaces."""

_KINDS: Mapping[str, Kind] = MappingProxyType(
    {"m": "length", "m/s²": "acceleration", "1": "number"}
)

_PARAMETERS = _listed(
    *(
        Variable(name, _KINDS[unit], name.replace("_", " "))
        for name, (_, unit, _) in hoop.PARAMETERS.items()
    )
)

VARIABLES: Mapping[str, Variable] = MappingProxyType(
    {**ARGUMENTS, **ALTERNATIVE_VARIABLES, **_PARAMETERS}
)
"""Every variable: arguments of a release, those that replace them, and parameters of the scene."""


def check_angles(name: str, values: Mapping[str, ArrayLike]) -> None:
    """Refuse angles that seem to be in degrees, and spins that seem not to be in rad/s.

    The limits are those of `hoopgen.core.validation`.

    Parameters
    ----------
    name
        The argument that errors name.
    values
        Values of variables by name, rad and rad/s.

    Raises
    ------
    ValueError
        The message begins with `name`.
    """
    for kind, check in (("angle", check_radians), ("spin", check_spins)):
        names = (one for one in values if one in VARIABLES and VARIABLES[one].kind == kind)
        check(name, {one: values[one] for one in names})


def resolve_variables(
    values: Mapping[str, ArrayLike], parameters: Mapping[str, Any] = PAPER
) -> Releases:
    """Return the shots that the variables describe.

    Parameters
    ----------
    values
        Name to value, m, m/s, rad, rad/s; the names are those of a release and of `parameters`. One
        number for all shots or (n,). Needed are height, a place (distance and, if not 0, angle; or
        x and y), a speed or `aim`, and an elevation or `entry`.
    parameters
        Of the scene, for those that are not among the values.

    Returns
    -------
    Releases
        Of 1 shot where every value is one number. Where no speed brings the ball down through the
        point aimed at, the speed is NaN, and the shot INVALID.

    Raises
    ------
    TypeError
        If a value is not numbers.
    ValueError
        If a name is unknown, one is missing, two stand for the same, or shapes disagree.
    """
    names = tuple(parameters) or NAMES
    check_names("variables", values, (*ARGUMENTS, *ALTERNATIVE_VARIABLES, *names))
    arrays = {name: as_doubles(name, value) for name, value in values.items()}
    lengths = {name: array.shape for name, array in arrays.items() if array.ndim}
    if any(len(shape) != 1 for shape in lengths.values()) or len(set(lengths.values())) > 1:
        shapes = ", ".join(f"{name} {shape}" for name, shape in lengths.items())
        raise ValueError(f"variables: expected one number or one a shot each, got shapes {shapes}")
    scene = dict(parameters)
    scene |= {name: _plain(arrays.pop(name)) for name in names if name in arrays}
    shots = max((shape[0] for shape in lengths.values()), default=1)
    # Without a gravity `simulate` says what is missing.
    arguments = release_arguments(arrays, scene.get("gravity", np.nan))
    return make_releases(arguments, scene, shots)


def make_releases(
    arguments: Mapping[str, NDArray[np.float64]], parameters: Mapping[str, Any], shots: int
) -> Releases:
    """Return so many shots of all arguments of `hoopgen.release`, each one number or (shots,).

    Parameters
    ----------
    arguments
        All arguments of `hoopgen.release` by name, () or (shots,), SI units.
    parameters
        Parameters of the scene.
    shots
        The number of shots.
    """
    return Releases(
        np.broadcast_to(states_of(arguments), (shots, len(STATE))),
        parameters,
        {name: np.broadcast_to(array, (shots,)) for name, array in arguments.items()},
    )


def release_arguments(
    values: Mapping[str, NDArray[np.float64]], gravity: ArrayLike
) -> dict[str, NDArray[np.float64]]:
    """Return all arguments of `hoopgen.release` that the variables stand for.

    Speed through the point aimed at, and the slope that comes down at an angle, are closed forms
    of a flight without contacts. Values broadcast; what is one number remains one.

    Parameters
    ----------
    values
        Values of the variables by name, SI units and rad.
    gravity
        Gravity, m/s².

    Raises
    ------
    ValueError
        If one is missing, or two stand for the same.
    """
    for name, others in STANDS_FOR.items():
        both = [other for other in others if name in values and other in values]
        if both:
            raise ValueError(f"variables: {name} takes the place of {' and '.join(both)}; got both")
    given = dict(values)
    if "x" in given or "y" in given:
        if "x" not in given or "y" not in given:
            raise ValueError("variables: x and y are given together")
        x, y = given.pop("x"), given.pop("y")
        given |= {"distance": hypotenuse(y, x), "angle": arc_tangent(y, x)}
    missing = [name for name in ("height", "distance") if name not in given]
    if missing:
        raise ValueError(f"variables: missing {', '.join(missing)}")
    aimed = "aim" in given or "entry" in given
    reach, rise = given["distance"] + given.pop("aim", 0.0), RING_HEIGHT - given["height"]
    if "entry" in given:
        with np.errstate(all="ignore"):  # from the point aimed at itself there is none
            (slope,) = hoop.slope_of_entry(tangent(given.pop("entry")), reach, rise)
        given["elevation"] = arc_tangent(slope)
    if "elevation" not in given or (not aimed and "speed" not in given):
        raise ValueError(
            "variables: expected speed and elevation, or aim in place of speed, "
            f"or entry in place of both; got {join_names(values)}"
        )
    if aimed:
        given["speed"] = _aimed_speed(given["elevation"], reach, rise, gravity)
    return {name: np.asarray(given.get(name, 0.0), dtype=np.float64) for name in ARGUMENTS}


def change_variables(values: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """Return the variables with some changed: one that stands for another takes its place.

    A `speed` drops `aim` and `entry`, an `entry` drops `speed` and `elevation`, and so on.

    Parameters
    ----------
    values
        Values of variables by name.
    changes
        New values by name.
    """
    release = ("aim", "entry")
    dropped = {other for name in release if name in changes for other in STANDS_FOR[name]}
    dropped |= {name for name in release for other in STANDS_FOR[name] if other in changes}
    return {name: value for name, value in values.items() if name not in dropped} | dict(changes)


def _aimed_speed(
    elevation: ArrayLike, reach: ArrayLike, rise: ArrayLike, gravity: ArrayLike
) -> NDArray[np.float64]:
    """Return the speed that comes down through a point ahead, or NaN where none does."""
    with np.errstate(all="ignore"):
        slope = tangent(elevation)
        (speed,) = hoop.aimed_speed(slope, reach, rise, gravity)
        (entry,) = hoop.entry_slope(slope, reach, rise)
        there = (sine_cosine(elevation)[1] > 0.0) & (np.asarray(reach) > 0.0) & (entry > 0.0)
        return np.where(there & np.isfinite(speed), speed, np.nan)


def _plain(array: NDArray[np.float64]) -> float | NDArray[np.float64]:
    return array if array.ndim else float(array)
