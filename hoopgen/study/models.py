"""Release models: where the shots of a study come from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from hashlib import sha256
from math import prod
from typing import Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.brief import brief
from hoopgen.inputs import doubles
from hoopgen.parameters import NAMES, PAPER
from hoopgen.sizes import check_room

from .draws import ROW_OF_RELEASES, normals, uniforms
from .variables import (
    ARGUMENTS,
    STATE,
    VARIABLES,
    Releases,
    check_angles,
    check_names,
    make_releases,
    release_arguments,
    resolve_variables,
)

__all__ = ["Grid", "ReleaseModel", "Resample", "Scatter"]

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
    mean
        Variables of the release aimed at, one number each; m, m/s, rad, rad/s. See `VARIABLES`.
    sd
        Standard deviations of arguments of `hoopgen.release`, or of parameters of the scene. The
        noise is added to the mean, where `aim` and `entry` have become speed and elevation.
    correlation
        Of pairs of names in `sd`; 0 where none is given.

    Raises
    ------
    ValueError
        If a name is unknown, a deviation is negative or not finite, an angle is in degrees, or the
        correlations are not within -1 and 1, given twice, or no distribution has all of them.
    """

    mean: Mapping[str, float]
    sd: Mapping[str, float] = field(default_factory=dict)
    correlation: Mapping[tuple[str, str], float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        check_names("mean", self.mean, VARIABLES)
        check_names("sd", self.sd, _SCATTERED)
        for name, value in self.mean.items():
            if doubles(f"mean[{name!r}]", value).ndim:
                raise ValueError(f"mean[{name!r}]: expected one number, got {brief(value)}")
        check_angles("mean", self.mean)
        for name, value in self.sd.items():
            deviation = doubles(f"sd[{name!r}]", value)
            if deviation.ndim or not 0.0 <= deviation < np.inf:
                raise ValueError(f"sd[{name!r}]: expected a number from 0, got {brief(value)}")
        check_angles("sd", self.sd)
        self._mix()

    def noise(self, start: int, stop: int, seed: int = 0) -> dict[str, NDArray[np.float64]]:
        """Return what is added to the mean in shots `start` to `stop` - 1, by name, (n,) each."""
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
            Of the scene, for those that neither `mean` nor `sd` names.
        """
        _check_drawn(start, stop)
        scene = dict(parameters) | {name: v for name, v in self.mean.items() if name in NAMES}
        mean = {name: doubles(name, v) for name, v in self.mean.items() if name not in NAMES}
        values: dict[str, Any] = {**scene, **release_arguments(mean, scene["gravity"])}
        for name, noise in self.noise(start, stop, seed).items():
            values[name] = values[name] + noise
        scene = {name: values.pop(name) for name in scene}
        return make_releases(values, scene, stop - start)

    def identity(self) -> dict[str, Any]:
        """Return what tells this model from others, in types that JSON knows."""
        return {
            "model": "scatter",
            "mean": {name: float(value) for name, value in self.mean.items()},
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


@dataclass(frozen=True)
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
        self._take(np.zeros(1, np.intp), PAPER)

    @property
    def rows(self) -> int:
        """Measured releases."""
        return max(np.size(column) for column in self.columns.values())

    def draw(
        self, start: int, stop: int, seed: int = 0, parameters: Mapping[str, Any] = PAPER
    ) -> Releases:
        """Return shots `start` to `stop` - 1, each a row chosen at random."""
        _check_drawn(start, stop)
        chosen = uniforms(seed, ROW_OF_RELEASES, start, stop) * self.rows
        return self._take(chosen.astype(np.intp), parameters)

    def identity(self) -> dict[str, Any]:
        """Return what tells this model from others, in types that JSON knows."""
        digest = sha256()
        for name, column in self.columns.items():
            digest.update(f"{name} {np.shape(column)} ".encode())
            digest.update(np.ascontiguousarray(column, dtype="<f8").tobytes())
        return {"model": "resample", "columns": list(self.columns), "sha256": digest.hexdigest()}

    def _take(self, rows: NDArray[np.intp], parameters: Mapping[str, Any]) -> Releases:
        columns = {name: np.asarray(column) for name, column in self.columns.items()}
        return from_columns(
            {name: column[rows] if column.ndim else column for name, column in columns.items()},
            parameters,
        )


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
    if not any(name in columns for name in STATE[2:]):
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
