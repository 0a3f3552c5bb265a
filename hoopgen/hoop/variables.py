"""Variables of a shot at a hoop: arguments of its release, their alternatives, and parameters."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.si_checks import check_angles as check_radians
from hoopgen.core.si_checks import check_lengths, check_speeds, check_spins
from hoopgen.core.validation import as_doubles
from hoopgen.core.variables import KIND_OF, STATE, Releases, Variable, check_names
from hoopgen.engine.elementary import arc_tangent, hypotenuse
from hoopgen.generated.numpy import hoop
from hoopgen.text.shorten import join_names

from .aiming import aimed
from .flights import Flights, is_in_air
from .parabolas import parabola_through
from .presets import NAMES, PAPER
from .releases import RING_HEIGHT, states_of


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

STANDS_FOR: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "aim": ("speed",),
        "entry": ("speed", "elevation"),
        "x": ("distance", "angle"),
        "y": ("distance", "angle"),
    }
)
"""The arguments that each of them replaces."""

_PARAMETERS = _listed(
    *(
        Variable(name, KIND_OF.get(unit, "number"), name.replace("_", " "))
        for name, (_, unit, _) in hoop.PARAMETERS.items()
    )
)

VARIABLES: Mapping[str, Variable] = MappingProxyType(
    {**ARGUMENTS, **ALTERNATIVE_VARIABLES, **_PARAMETERS}
)
"""Every variable: arguments of a release, those that replace them, and parameters of the scene."""


def check_angles(name: str, values: Mapping[str, ArrayLike]) -> None:
    """Refuse lengths, speeds, angles and spins that seem not to be in m, m/s, rad and rad/s.

    The limits are those of `hoopgen.core.si_checks`.

    Parameters
    ----------
    name
        The argument that errors name.
    values
        Values of variables by name, SI.

    Raises
    ------
    ValueError
        The message begins with `name`.
    """
    checks = {
        "length": check_lengths,
        "speed": check_speeds,
        "angle": check_radians,
        "spin": check_spins,
    }
    for kind, check in checks.items():
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
    arguments = release_arguments(arrays, scene)
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
    values: Mapping[str, NDArray[np.float64]], parameters: Mapping[str, ArrayLike]
) -> dict[str, NDArray[np.float64]]:
    """Return all arguments of `hoopgen.release` that the variables stand for.

    Speed through the point aimed at, and the elevation that comes down at an angle, are those of a
    flight without contacts: `hoopgen.hoop.aiming`. Through air it is a flight that comes down as
    far away as the point; a sidespin turns it aside. Values broadcast; what is one number remains
    one.

    Parameters
    ----------
    values
        Values of the variables by name, SI units and rad.
    parameters
        Parameters of the scene; one without a gravity aims nowhere.

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
    aims = "aim" in given or "entry" in given
    reach, rise = given["distance"] + given.pop("aim", 0.0), RING_HEIGHT - given["height"]
    entry = given.pop("entry", None)
    if ("elevation" not in given and entry is None) or (not aims and "speed" not in given):
        raise ValueError(
            "variables: expected speed and elevation, or aim in place of speed, "
            f"or entry in place of both; got {join_names(values)}"
        )
    if aims:
        wanted = {"elevation": given["elevation"]} if entry is None else {"entry": entry}
        spins = [given.get(name, np.zeros(())) for name in ("backspin", "sidespin")]
        given |= _aimed(wanted, reach, rise, parameters, *spins)
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


def _aimed(
    wanted: Mapping[str, NDArray[np.float64]],
    reach: NDArray[np.float64],
    rise: NDArray[np.float64],
    parameters: Mapping[str, ArrayLike],
    backspin: NDArray[np.float64],
    sidespin: NDArray[np.float64],
) -> dict[str, NDArray[np.float64]]:
    """Return speed and elevation of flights through a point; the speed is NaN where none is."""
    if is_in_air(parameters):
        flights = Flights.at_hoop(parameters)
        found = aimed(wanted, reach, rise, flights, backspin=backspin, sidespin=sidespin)
        # As where there is no air, one number remains one, and what is given remains as it is.
        return {n: wanted.get(n, found[n]) for n in ("speed", "elevation")}
    gravity = np.asarray(parameters.get("gravity", np.nan), np.float64)
    if "entry" in wanted:
        found, _ = parabola_through(wanted, reach, rise, gravity)
        wanted = {"elevation": found["elevation"]}
    found, possible = parabola_through(wanted, reach, rise, gravity)
    return {"speed": np.where(possible, found["speed"], np.nan), "elevation": wanted["elevation"]}


def _plain(array: NDArray[np.float64]) -> float | NDArray[np.float64]:
    return array if array.ndim else float(array)
