"""Release models: where the shots of a study come from."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from hashlib import sha256
from math import nan, prod
from typing import Any, ClassVar, Protocol, TypeAlias, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.brief import brief
from hoopgen.inputs import doubles
from hoopgen.parameters import NAMES, PAPER
from hoopgen.releases import released
from hoopgen.sizes import check_room

from .draws import ROW_OF_RELEASES, normals, uniforms
from .variables import (
    ARGUMENTS,
    STANDS_FOR,
    STATE,
    VARIABLES,
    Releases,
    change_variables,
    check_angles,
    check_names,
    make_releases,
    release_arguments,
    resolve_variables,
)

__all__ = [
    "Grid",
    "ReleaseModel",
    "Resample",
    "Scatter",
    "alike",
    "check_thrown",
    "is_state",
    "scene_by_row",
]

Floats: TypeAlias = NDArray[np.float64]
Scene: TypeAlias = Mapping[str, Any]
Given: TypeAlias = Mapping[str, ArrayLike]

_SHOT = 200
"""Bytes that a shot takes while it is drawn."""

_SCATTERED = (*ARGUMENTS, *NAMES)
"""What may scatter; its index is the stream of its random numbers."""


@runtime_checkable
class ReleaseModel(Protocol):
    """Anything that releases shots by index."""

    def draw(
        self, start: int, stop: int, seed: int = 0, parameters: Mapping[str, Any] = PAPER
    ) -> Releases:
        """Return shots `start` to `stop` - 1; shot i is the same however it is asked for."""
        ...

    def identity(self) -> dict[str, Any]:
        """Return what tells this model from others, in types that JSON knows."""
        ...


@dataclass(frozen=True)
class Scatter:
    """A player's scatter: normal about a mean release.

    Attributes
    ----------
    release
        Variables of the release aimed at, one number each; m, m/s, rad, rad/s. See `VARIABLES`.
    sd
        Standard deviations of arguments of `hoopgen.release`, or of parameters of the scene. The
        noise is added to that release, where `aim` and `entry` have become speed and elevation.
    correlation
        Of pairs of names in `sd`; 0 where none is given.

    Raises
    ------
    ValueError
        If a name is unknown, a deviation is negative or not finite, an angle is in degrees, or the
        correlations are not within -1 and 1, given twice, or no distribution has all of them.
    """

    release: Mapping[str, float]
    sd: Mapping[str, float] = field(default_factory=dict)
    correlation: Mapping[tuple[str, str], float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        check_names("release", self.release, VARIABLES)
        check_names("sd", self.sd, _SCATTERED)
        for name, value in self.release.items():
            if doubles(f"release[{name!r}]", value).ndim:
                raise ValueError(f"release[{name!r}]: expected one number, got {brief(value)}")
        check_angles("release", self.release)
        for name, value in self.sd.items():
            deviation = doubles(f"sd[{name!r}]", value)
            if deviation.ndim or not 0.0 <= deviation < np.inf:
                raise ValueError(f"sd[{name!r}]: expected a number from 0, got {brief(value)}")
        check_angles("sd", self.sd)
        self._mix()

    def noise(self, start: int, stop: int, seed: int = 0) -> dict[str, NDArray[np.float64]]:
        """Return what is added in shots `start` to `stop` - 1, by name, (n,) each."""
        _check_drawn(start, stop)
        names = self._scattered()
        draws = [normals(seed, _SCATTERED.index(name), start, stop) for name in names]
        mixed = {}
        for name, row in zip(names, self._mix(), strict=True):
            # A sum in a fixed order: a matrix product's could depend on the number of shots.
            parts = [weight * z for weight, z in zip(row, draws, strict=False) if weight]
            with np.errstate(over="ignore"):  # it is an invalid shot
                mixed[name] = self.sd[name] * sum(parts[1:], parts[0])
        return mixed

    def draw(
        self, start: int, stop: int, seed: int = 0, parameters: Mapping[str, Any] = PAPER
    ) -> Releases:
        """Return shots `start` to `stop` - 1.

        Parameters
        ----------
        start, stop
            Indices of shots.
        seed
            From 0 to 2^64 - 1.
        parameters
            Of the scene, for those that neither `release` nor `sd` names.
        """
        values, scene = self._about(self.release, self.noise(start, stop, seed), parameters)
        return make_releases(values, scene, stop - start)

    @property
    def scatters(self) -> bool:
        """Whether there are deviations, be they 0."""
        return bool(self.sd)

    @property
    def still(self) -> bool:
        """Whether none is above 0."""
        return not any(self.sd.values())

    @property
    def centre(self) -> dict[str, float]:
        """Variables of the release aimed at."""
        return {name: float(value) for name, value in self.release.items()}

    def apart(self) -> tuple[dict[str, float], Scatter]:
        """Return the release aimed at, and the scatter alone."""
        return self.centre, Scatter({}, self.sd, self.correlation)

    def around(self, values: Given, noise: Given, parameters: Scene, shots: int = 1) -> Releases:
        """Return shots about other releases, the scatter as it is.

        Parameters
        ----------
        values
            Variables, one number or (m, 1).
        noise
            What `noise` gave, (shots,) each.
        parameters
            Of the scene, for those that are not among the values.
        shots
            Of each of the m releases; one comes after the other.
        """
        columns, scene = self._about({**self.release, **values}, noise, parameters)
        return spread(released(columns), scene, shots)

    def _about(
        self, values: Given, noise: Given, parameters: Scene
    ) -> tuple[dict[str, Floats], dict[str, Any]]:
        """Return arguments of `hoopgen.release` and the scene, the noise added."""
        scene = dict(parameters) | {name: v for name, v in values.items() if name in NAMES}
        means = {name: doubles(name, v) for name, v in values.items() if name not in NAMES}
        added: dict[str, Any] = {**scene, **release_arguments(means, scene["gravity"])}
        for name, one in noise.items():
            added[name] = added[name] + one
        scene = {name: added.pop(name) for name in scene}
        return added, scene

    def identity(self) -> dict[str, Any]:
        """Return what tells this model from others, in types that JSON knows."""
        return {
            "model": "scatter",
            "release": self.centre,
            "sd": {name: float(value) for name, value in self.sd.items()},
            "correlation": [[a, b, float(value)] for (a, b), value in self.correlation.items()],
        }

    def _scattered(self) -> list[str]:
        return [name for name in _SCATTERED if self.sd.get(name)]

    def _mix(self) -> list[NDArray[np.float64]]:
        """Return the rows of the lower triangular factor of the correlation matrix."""
        names = self._scattered()
        matrix = np.eye(len(names))
        for (a, b), value in self.correlation.items():
            if a == b or a not in self.sd or b not in self.sd:
                known = ", ".join(self.sd) or "none"
                raise ValueError(f"correlation: ({brief(a)}, {brief(b)}) is no pair of {known}")
            if (b, a) in self.correlation:
                raise ValueError(f"correlation: {a} and {b} are given twice")
            pair = f"correlation: {a} and {b}"
            if not -1.0 < doubles(pair, value) < 1.0:
                raise ValueError(f"{pair}: expected a number within -1 and 1, got {brief(value)}")
            if a in names and b in names:
                i, j = names.index(a), names.index(b)
                matrix[i, j] = matrix[j, i] = value
        try:
            factor = np.linalg.cholesky(matrix)
        except np.linalg.LinAlgError:
            raise ValueError(
                f"correlation: no distribution has all of these: {brief(dict(self.correlation))}"
            ) from None
        return [row[: i + 1] for i, row in enumerate(factor)]


@dataclass(frozen=True, eq=False)
class Resample:
    """Measured releases, drawn with replacement.

    Attributes
    ----------
    columns
        By name, (m,) each or one number for all: variables, or the nine components of a state
        (x y z vx vy vz wx wy wz) and parameters of the scene.

    Raises
    ------
    ValueError
        If a name is unknown, there is no row, the columns differ in length, or angles are degrees:
        by their median, more than a turn.
    """

    columns: Mapping[str, ArrayLike]

    def __post_init__(self) -> None:
        given = {name: doubles(name, column) for name, column in self.columns.items()}
        shapes = {column.shape for column in given.values() if column.ndim}
        if len(shapes) != 1 or len(next(iter(shapes))) != 1 or not next(iter(shapes))[0]:
            raise ValueError(
                "columns: expected columns of one length and at least one row, got shapes "
                + ", ".join(f"{name} {column.shape}" for name, column in given.items())
            )
        check_angles("columns", given)
        object.__setattr__(self, "columns", given)
        if is_state(given):
            from_columns(self._at(np.zeros(1, np.intp)))
        else:
            check_names("columns", given, VARIABLES)

    @property
    def rows(self) -> int:
        """Measured releases."""
        return max(np.size(column) for column in self.columns.values())

    def draw(
        self, start: int, stop: int, seed: int = 0, parameters: Mapping[str, Any] = PAPER
    ) -> Releases:
        """Return shots `start` to `stop` - 1, each a row chosen at random."""
        return from_columns(self.noise(start, stop, seed), parameters)

    def _rows(self, start: int, stop: int, seed: int) -> NDArray[np.intp]:
        _check_drawn(start, stop)
        chosen = uniforms(seed, ROW_OF_RELEASES, start, stop) * self.rows
        return chosen.astype(np.intp)

    scatters: ClassVar[bool] = True
    still: ClassVar[bool] = False
    """The rows may all be the same; that is not looked at."""

    @cached_property
    def centre(self) -> dict[str, float]:
        """Means of the columns, of their finite numbers."""
        return {name: _centre(np.asarray(column)) for name, column in self.columns.items()}

    def apart(self) -> tuple[dict[str, float], Resample]:
        """Return nothing, and itself: the releases are about their own means."""
        return {}, self

    def noise(self, start: int, stop: int, seed: int = 0) -> dict[str, Floats]:
        """Return the columns of shots `start` to `stop` - 1, (n,) each or one number."""
        return self._at(self._rows(start, stop, seed))

    def around(self, values: Given, noise: Given, parameters: Scene, shots: int = 1) -> Releases:
        """Return shots with some variables others, as `Scatter.around` does.

        The mean of a column that is among the values is moved there, and so is that of what `aim`,
        `entry`, `x` and `y` stand for: how far the rows are from their mean stays as it was. A
        variable that is no column has the value itself. The other columns are as they are.
        """
        if is_state(self.columns):
            wrong = [name for name in values if name not in NAMES]
            if wrong:
                raise ValueError(
                    f"columns: these are states, of which {', '.join(wrong)} cannot be varied; "
                    "give speed, elevation, height and distance"
                )
            drawn = from_columns(noise, parameters)
            scene = {**drawn.parameters, **self._moved(values, noise)}
            return spread(drawn.states, scene, shots)
        columns = {**noise, **self._moved(values, noise)}
        columns |= self._replaced(values, noise, parameters)
        for name in values:
            if name in STANDS_FOR and name not in self.columns:
                del columns[name]
        scene = dict(parameters) | {name: columns.pop(name) for name in NAMES if name in columns}
        arguments = release_arguments(columns, scene["gravity"])
        return spread(released(arguments), scene, shots)

    def _moved(self, values: Given, noise: Given) -> dict[str, Any]:
        """Return the values, with the deviations of columns of their names."""
        return {name: doubles(name, v) + self._off(name, noise) for name, v in values.items()}

    def _off(self, name: str, noise: Given) -> Any:
        """Return how far rows are from the mean of a column; nothing, if it is none."""
        return np.asarray(noise[name]) - self.centre[name] if name in noise else 0.0

    def _replaced(self, values: Given, noise: Given, parameters: Scene) -> dict[str, Floats]:
        """Return the arguments that others among the values stand for, with their deviations."""
        standing = [name for name in values if name in STANDS_FOR and name not in self.columns]
        if not standing:
            return {}
        means = change_variables(self.centre, values)
        gone = {other for name in standing for other in STANDS_FOR[name]}
        means = {name: doubles(name, v) for name, v in means.items() if name not in gone}
        gravity = means["gravity"] if "gravity" in means else parameters["gravity"]
        plain = {name: value for name, value in means.items() if name not in NAMES}
        found = release_arguments(plain, gravity)
        return {name: found[name] + self._off(name, noise) for name in gone}

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Resample) and self.identity() == other.identity()

    def __hash__(self) -> int:
        return hash(self.identity()["sha256"])

    def identity(self) -> dict[str, Any]:
        """Return what tells this model from others, in types that JSON knows."""
        digest = sha256()
        for name, column in self.columns.items():
            digest.update(f"{name} {np.shape(column)} ".encode())
            digest.update(np.ascontiguousarray(column, dtype="<f8").tobytes())
        return {"model": "resample", "columns": list(self.columns), "sha256": digest.hexdigest()}

    def _at(self, rows: NDArray[np.intp]) -> dict[str, Floats]:
        columns = {name: np.asarray(column) for name, column in self.columns.items()}
        return {name: column[rows] if column.ndim else column for name, column in columns.items()}


@dataclass(frozen=True)
class Grid:
    """Every combination of values; the last axis varies fastest.

    Attributes
    ----------
    axes
        Variables, or components of a state, and the values they take, in order.
    fixed
        The others, one number each.

    Raises
    ------
    ValueError
        If a name is unknown or twice there, an axis is not (m,), or angles are degrees: by their
        median, more than a turn.
    """

    axes: Mapping[str, Sequence[float] | NDArray[np.float64]]
    fixed: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        twice = [name for name in self.axes if name in self.fixed]
        if twice:
            raise ValueError(f"fixed: {', '.join(twice)} already among the axes")
        for name, values in self.axes.items():
            if doubles(f"axes[{name!r}]", values).ndim != 1 or not np.size(values):
                raise ValueError(f"axes[{name!r}]: expected a list of numbers, got {brief(values)}")
        check_angles("axes", self.axes)
        check_angles("fixed", self.fixed)
        self.draw(0, 1)

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values on each axis."""
        return tuple(len(values) for values in self.axes.values())

    @property
    def shots(self) -> int:
        """Number of combinations."""
        return prod(self.shape)

    def draw(
        self, start: int, stop: int, seed: int = 0, parameters: Mapping[str, Any] = PAPER
    ) -> Releases:
        """Return combinations `start` to `stop` - 1; nothing is random.

        Raises
        ------
        IndexError
            If there are not so many.
        """
        if not 0 <= start <= stop <= self.shots:
            raise IndexError(f"grid: shots {start} to {stop} of {self.shots}")
        _check_drawn(start, stop)
        places = np.unravel_index(np.arange(start, stop), self.shape) if self.axes else ()
        columns = {
            name: doubles(name, values)[place]
            for (name, values), place in zip(self.axes.items(), places, strict=True)
        }
        # One axis at the least is a column; without any, the single shot has none.
        fixed = {name: doubles(name, value) for name, value in self.fixed.items()}
        return from_columns({**columns, **fixed}, parameters)

    def identity(self) -> dict[str, Any]:
        """Return what tells this model from others, in types that JSON knows."""
        return {
            "model": "grid",
            "axes": {name: doubles(name, values).tolist() for name, values in self.axes.items()},
            "fixed": {name: float(value) for name, value in self.fixed.items()},
        }


def _check_drawn(start: int, stop: int) -> None:
    """Refuse to draw more shots at once than there is memory for."""
    check_room("stop", stop - start, "shots drawn at once", _SHOT)


def is_state(columns: Iterable[str]) -> bool:
    """Return whether columns of these names are states: z or vx, vy, vz say so."""
    return not set(STATE[2:]).isdisjoint(columns)


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


def check_thrown(model: object, over: Iterable[str]) -> Scatter | Resample:
    """Return a model whose release is varied over some variables.

    Raises
    ------
    TypeError
        If it is none that can be.
    ValueError
        If what is varied is given in its release too.
    """
    if not isinstance(model, Scatter | Resample):
        raise TypeError(f"model: expected a Scatter or a Resample, got {model!r}")
    twice = [name for name in over if isinstance(model, Scatter) and name in model.release]
    if twice:
        raise ValueError(f"release: {', '.join(twice)} already in over; leave out of one")
    return model


def alike(model: Scatter | Resample) -> dict[str, float]:
    """Return the variables that are the same in all shots, be it for the scatter."""
    if isinstance(model, Scatter):
        return model.centre
    same = (name for name, column in model.columns.items() if not np.ndim(column))
    return {name: model.centre[name] for name in same if name in VARIABLES}


def scene_by_row(model: Scatter | Resample) -> list[str]:
    """Return the parameters of the scene that were measured with each release."""
    columns = {} if isinstance(model, Scatter) else model.columns
    return [name for name in NAMES if np.ndim(columns.get(name, 0.0))]


def _centre(column: Floats) -> float:
    """Return the mean of the finite numbers; of equal ones exactly theirs."""
    finite = column[np.isfinite(column)]
    if not finite.size:
        return nan
    return float(finite[0] if np.all(finite == finite[0]) else np.mean(finite))


def from_columns(
    columns: Mapping[str, ArrayLike], parameters: Mapping[str, Any] = PAPER
) -> Releases:
    """Return the shots of columns, one number for all or (n,) each: states, or variables.

    Columns z or vx, vy, vz say that they are states.

    Raises
    ------
    ValueError
        If a name is unknown or missing.
    """
    if not is_state(columns):
        return resolve_variables(columns, parameters)
    check_names("columns", columns, (*STATE, *NAMES))
    missing = [name for name in STATE[:6] if name not in columns]
    if missing:
        raise ValueError(f"columns: a state needs {', '.join(missing)} too")
    # A spin that was not measured is none.
    components = [doubles(name, columns.get(name, 0.0)) for name in STATE]
    scene = {name: columns[name] for name in NAMES if name in columns}
    shots = np.broadcast_shapes((1,), *(np.shape(column) for column in columns.values()))
    states = np.empty((*shots, len(STATE)))
    for index, component in enumerate(components):
        states[:, index] = component
    return Releases(states, dict(parameters) | scene, {})
