"""Release models: where the shots of a study come from."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Protocol, TypeAlias, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.memory import check_room
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.si_checks import check_deviations
from hoopgen.core.validation import as_doubles
from hoopgen.core.variables import STATE, Releases, check_names, is_state
from hoopgen.hoop.presets import NAMES, PAPER
from hoopgen.hoop.variables import ALTERNATIVE_VARIABLES, ARGUMENTS, check_angles, resolve_variables
from hoopgen.scene.lookup import HOOP_VARIABLES

Floats: TypeAlias = NDArray[np.float64]
Scene: TypeAlias = ParameterValues
Given: TypeAlias = Mapping[str, ArrayLike]

_SHOT = 200
"""Bytes that a shot takes while it is drawn."""


@runtime_checkable
class ReleaseModel(Protocol):
    """Anything that releases shots by index."""

    def draw(
        self, start: int, stop: int, seed: int = 0, parameters: Mapping[str, float] = PAPER
    ) -> Releases:
        """Return shots `start` to `stop` - 1; shot i is the same in every such range.

        Parameters
        ----------
        start, stop
            The first shot, and the one after the last.
        seed
            Other seeds give other shots, where any are random.
        parameters
            Of the scene, for those that the model has no values of.
        """
        ...

    def identity(self) -> Mapping[str, object]:
        """Return the identity of the model, in types that JSON knows."""
        ...


def is_still(model: ReleaseModel) -> bool:
    """Return whether nothing scatters, so that every shot is the same."""
    return bool(getattr(model, "still", False))


def check_drawn(start: int, stop: int) -> None:
    """Refuse to draw more shots at once than there is memory for.

    Parameters
    ----------
    start
        The index of the first shot.
    stop
        The index after that of the last shot.
    """
    check_room("stop", stop - start, "shots drawn at once", _SHOT)


def check_known(
    argument: str, names: Iterable[str], among: Iterable[str], scene: Iterable[str] = ()
) -> None:
    """Refuse what is no variable of a release at a hoop or, of states, of the scene.

    Which parameters go with states is only known with the scene, when shots are drawn.

    Parameters
    ----------
    among
        All names of the shots, which tell whether they are states.
    scene
        Its parameters; none before shots are drawn.
    """
    own = tuple(scene)
    if is_state(among):
        if own:
            check_names(argument, names, (*STATE, *own))
    else:
        known = (*ARGUMENTS, *ALTERNATIVE_VARIABLES, *own) if own else HOOP_VARIABLES
        check_names(argument, names, known)


def check_turns(argument: str, values: Mapping[str, ArrayLike], among: Iterable[str]) -> None:
    """Refuse degrees among the angles of releases; states have none.

    Parameters
    ----------
    argument
        The name of the argument, for the error.
    values
        Values of variables by name, one number or (n,) each, SI and rad.
    among
        All variables that are given; they tell states from releases.
    """
    if not is_state(among):
        check_angles(argument, values)


AIMED = ("elevation", "azimuth")
"""Angles of a release at which a player aims; `angle`, the place, may be anywhere."""


def check_spread(argument: str, deviations: Mapping[str, ArrayLike], among: Iterable[str]) -> None:
    """Refuse standard deviations in degrees among those of releases; states have no angles.

    Parameters
    ----------
    argument, among
        As for `check_turns`.
    deviations
        Standard deviations of variables by name, one number or (n,) each, SI and rad.
    """
    if not is_state(among):
        check_turns(argument, deviations, among)
        check_deviations(argument, {n: deviations[n] for n in AIMED if n in deviations})


def as_states(columns: Mapping[str, ArrayLike]) -> Floats:
    """Return columns that broadcast as states, (..., 9); a spin that is not there is none."""
    missing = [name for name in STATE[:6] if name not in columns]
    if missing:
        raise ValueError(f"columns: a state needs {', '.join(missing)} too")
    components = [as_doubles(name, columns.get(name, 0.0)) for name in STATE]
    states = np.empty((*np.broadcast_shapes(*(one.shape for one in components)), len(STATE)))
    for index, component in enumerate(components):
        states[..., index] = component
    return states


def spread(states: Floats, scene: Mapping[str, Any], shots: int) -> Releases:
    """Return so many shots of each of m releases, one release after the other.

    Parameters
    ----------
    states
        (m, shots, 9) or what broadcasts to it.
    scene
        Numbers, or what broadcasts to (m, shots).
    """
    apart = [np.shape(value) for value in scene.values()]
    shape = np.broadcast_shapes(states.shape[:-1], (1, shots), *apart)
    return Releases(
        np.broadcast_to(states, (*shape, len(STATE))).reshape(-1, len(STATE)),
        {n: np.broadcast_to(v, shape).ravel() if np.ndim(v) else v for n, v in scene.items()},
        {},
    )


def from_columns(columns: Mapping[str, ArrayLike], parameters: ParameterValues = PAPER) -> Releases:
    """Return the shots of columns, one number for all or (n,) each: states, or variables.

    Columns z or vx, vy, vz say that they are states.

    Parameters
    ----------
    columns
        Variables and parameters of the hoop by name, one number or (n,) each, SI and rad.
    parameters
        Parameters of the hoop for those that no column has, SI.
    """
    if not is_state(columns):
        return resolve_variables(columns, parameters)
    check_known("columns", columns, columns, parameters or NAMES)
    scene = {name: columns[name] for name in columns if name not in STATE}
    shots = np.broadcast_shapes((1,), *(np.shape(column) for column in columns.values()))
    states = np.broadcast_to(as_states(columns), (*shots, len(STATE)))
    return Releases(states, dict(parameters) | scene, {})
