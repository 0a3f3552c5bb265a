"""`Resample`: measured releases, drawn with replacement."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from hashlib import sha256
from math import nan
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.hoop.presets import PAPER
from hoopgen.hoop.releases import released
from hoopgen.hoop.variables import STANDS_FOR, change_variables, release_arguments
from hoopgen.inputs import doubles
from hoopgen.variables import STATE, Releases, is_state

from .draws import ROW_OF_RELEASES, uniforms
from .models import (
    Floats,
    Given,
    Scene,
    as_states,
    check_drawn,
    check_known,
    check_turns,
    from_columns,
    spread,
)

__all__ = ["Resample"]


@dataclass(frozen=True, eq=False)
class Resample:
    """Measured releases, drawn with replacement.

    Attributes
    ----------
    columns
        By name, (m,) each or one number for all: variables, or the nine components of a state
        (x y z vx vy vz wx wy wz) and parameters of the scene, whichever it is.

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
        check_turns("columns", given, given)
        object.__setattr__(self, "columns", given)
        if self.is_state:
            as_states(self._at(np.zeros(1, np.intp)))
        check_known("columns", given, given)

    @property
    def is_state(self) -> bool:
        """Whether the releases are states, and no speeds and angles at a hoop."""
        return is_state(self.columns)

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
        check_drawn(start, stop)
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
        columns = {**noise, **self._moved(values, noise)}
        if self.is_state:
            wrong = [name for name in values if name not in (*STATE, *parameters)]
            if wrong:
                raise ValueError(
                    f"columns: these are states, of which {', '.join(wrong)} cannot be varied; "
                    "give speed, elevation, height and distance"
                )
            check_known("columns", noise, noise, parameters)
            own = {name: column for name, column in columns.items() if name not in STATE}
            return spread(as_states(columns), {**parameters, **own}, shots)
        columns |= self._replaced(values, noise, parameters)
        for name in values:
            if name in STANDS_FOR and name not in self.columns:
                del columns[name]
        scene = dict(parameters) | {
            name: columns.pop(name) for name in parameters if name in columns
        }
        arguments = release_arguments(columns, scene.get("gravity", nan))
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
        gravity = means["gravity"] if "gravity" in means else parameters.get("gravity", nan)
        plain = {name: value for name, value in means.items() if name not in parameters}
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


def _centre(column: Floats) -> float:
    """Return the mean of the finite numbers; of equal ones exactly theirs."""
    finite = column[np.isfinite(column)]
    if not finite.size:
        return nan
    return float(finite[0] if np.all(finite == finite[0]) else np.mean(finite))
