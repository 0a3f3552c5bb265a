"""`Resample`: measured releases, drawn with replacement."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from hashlib import sha256
from math import isnan, nan
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.argument_types import check_mapping
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.validation import as_doubles
from hoopgen.core.variables import STATE, Releases, is_state
from hoopgen.hoop.presets import PAPER
from hoopgen.hoop.releases import states_of
from hoopgen.hoop.variables import STANDS_FOR, change_variables, release_arguments
from hoopgen.text.shorten import brief

from .random import ORDER_OF_ROWS, ROW_OF_RELEASES, uniforms
from .release_model import (
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


@dataclass(frozen=True, eq=False, repr=False)
class Resample:
    """Measured releases, drawn with replacement.

    It assumes no distribution, but that the rows are a representative sample of the player's
    releases, and independent of each other; or, with groups, that the groups are. Few rows are a
    rough picture of a player, however many shots are drawn from them: results give an interval that
    contains the uncertainty of the sample.

    Attributes
    ----------
    columns
        By name, (m,) each or one number for all: variables, or the nine components of a state
        (x y z vx vy vz wx wy wz) and parameters of the scene, whichever it is.
    group
        Label of each row, (m,): its game, say, or its player. Rows of a group may be alike, groups
        are independent. None: each row is independent of all others.

    Raises
    ------
    ValueError
        If a name is unknown, there is no row, the columns differ in length, a row has no label of
        its group, or angles are degrees: by their median, more than a turn.
    """

    columns: Mapping[str, ArrayLike]
    group: Iterable[object] | None = None

    def __post_init__(self) -> None:
        check_mapping("columns", self.columns)
        given = {
            name: as_doubles(f"columns[{name!r}]", column) for name, column in self.columns.items()
        }
        shapes = {column.shape for column in given.values() if column.ndim}
        if len(shapes) != 1 or len(next(iter(shapes))) != 1 or not next(iter(shapes))[0]:
            raise ValueError(
                "columns: expected columns of one length and at least one row, got shapes "
                + (", ".join(f"{name} {one.shape}" for name, one in given.items()) or "none")
            )
        check_turns("columns", given, given)
        object.__setattr__(self, "columns", given)
        if self.is_state:
            as_states(self._at(np.zeros(1, np.intp)))
        check_known("columns", given, given)
        if self.group is not None:
            object.__setattr__(self, "group", _labels(self.group, self.rows))

    def __repr__(self) -> str:
        own = [name for name, column in self.columns.items() if np.ndim(column)]
        shared = [f"{n} {self.centre[n]:.6g}" for n in self.columns if n not in own]
        groups = [f"{self.groups} groups"] if self.groups is not None else []
        rows = [f"{self.rows} rows of {', '.join(own)}", *([", ".join(shared)] if shared else [])]
        return f"{type(self).__name__}({'; '.join([*rows, *groups])})"

    @cached_property
    def cluster(self) -> NDArray[np.intp] | None:
        """Number of each row's group, (m,), from 0; None if the rows are independent."""
        if self.group is None:
            return None
        return np.unique(np.asarray(self.group), return_inverse=True)[1].astype(np.intp)

    @property
    def groups(self) -> int | None:
        """The number of groups; None if the rows are independent."""
        return None if self.cluster is None else int(self.cluster.max()) + 1

    def same_groups(self, other: Resample) -> bool:
        """Return whether another sample has as many rows, in the same groups.

        Parameters
        ----------
        other
            The sample that this one is compared with.
        """
        if self.rows != other.rows:
            return False
        if self.cluster is None or other.cluster is None:
            return self.cluster is other.cluster
        return bool(np.array_equal(self.cluster, other.cluster))

    def order(self, seed: int) -> NDArray[np.intp]:
        """Return all rows in an order that depends on the seed alone, (m,).

        Parameters
        ----------
        seed
            The seed of the random numbers.
        """
        numbers = uniforms(seed, ORDER_OF_ROWS, 0, self.rows)
        return np.argsort(numbers, kind="stable").astype(np.intp)

    def each(
        self, rows: NDArray[np.intp] | None = None, about: Mapping[str, float] | None = None
    ) -> EachRow:
        """Return a model of some rows, of which shot i is the i-th of them.

        Parameters
        ----------
        rows
            Their indices, (k,); by default all.
        about
            Means from which it is counted how far the rows are; by default their own.
        """
        chosen = np.arange(self.rows) if rows is None else rows
        return EachRow(self._at(chosen), about=dict(self.centre if about is None else about))

    @property
    def is_state(self) -> bool:
        """True if the releases are states, and no speeds and angles at a hoop."""
        return is_state(self.columns)

    @property
    def rows(self) -> int:
        """Measured releases."""
        return max(np.size(column) for column in self.columns.values())

    def draw(
        self, start: int, stop: int, seed: int = 0, parameters: ParameterValues = PAPER
    ) -> Releases:
        """Return shots `start` to `stop` - 1, each a row chosen at random.

        Parameters
        ----------
        start, stop
            The first shot, and the one after the last.
        seed
            Shot i is the same in every range with the same seed.
        parameters
            Of the scene, for those that are no columns.
        """
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
        """Return the columns of shots `start` to `stop` - 1, (n,) each or one number.

        Parameters
        ----------
        start, stop, seed
            As for `draw`.
        """
        return self._at(self._rows(start, stop, seed))

    def around(self, values: Given, noise: Given, parameters: Scene, shots: int = 1) -> Releases:
        """Return shots with some variables others, as `Scatter.around` does.

        The mean of a column that is among the values is moved there, and so is that of what `aim`,
        `entry`, `x` and `y` stand for: how far the rows are from their mean stays as it was. A
        variable that is no column has the value itself. The other columns are as they are.

        Parameters
        ----------
        values, noise, parameters, shots
            As for `Scatter.around`; the noise is what `noise` returned.
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
        arguments = release_arguments(columns, scene)
        return spread(states_of(arguments), scene, shots)

    def _moved(self, values: Given, noise: Given) -> dict[str, Any]:
        """Return the values, with the deviations of columns of their names."""
        return {name: as_doubles(name, v) + self._off(name, noise) for name, v in values.items()}

    def _off(self, name: str, noise: Given) -> Any:
        """Return the deviations of rows from the mean of a column; 0 if it is no column."""
        return np.asarray(noise[name]) - self.centre[name] if name in noise else 0.0

    def _replaced(self, values: Given, noise: Given, parameters: Scene) -> dict[str, Floats]:
        """Return the arguments that others among the values stand for, with their deviations."""
        standing = [name for name in values if name in STANDS_FOR and name not in self.columns]
        if not standing:
            return {}
        means = change_variables(self.centre, values)
        gone = {other for name in standing for other in STANDS_FOR[name]}
        means = {name: as_doubles(name, v) for name, v in means.items() if name not in gone}
        scene = {name: means.get(name, value) for name, value in parameters.items()}
        plain = {name: value for name, value in means.items() if name not in parameters}
        found = release_arguments(plain, scene)
        return {name: found[name] + self._off(name, noise) for name in gone}

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Resample) and self.identity() == other.identity()

    def __hash__(self) -> int:
        return hash(self.identity()["sha256"])

    def identity(self) -> dict[str, object]:
        """Return the identity of the model, in types that JSON knows."""
        digest = sha256()
        for name, column in self.columns.items():
            digest.update(f"{name} {np.shape(column)} ".encode())
            digest.update(np.ascontiguousarray(column, dtype="<f8").tobytes())
        record: dict[str, object] = {
            "model": "resample",
            "columns": list(self.columns),
            "sha256": digest.hexdigest(),
        }
        if self.cluster is not None:
            groups = sha256(np.ascontiguousarray(self.cluster, dtype="<i8").tobytes())
            record["groups_sha256"] = groups.hexdigest()
        return record

    def _at(self, rows: NDArray[np.intp]) -> dict[str, Floats]:
        columns = {name: np.asarray(column) for name, column in self.columns.items()}
        return {name: column[rows] if column.ndim else column for name, column in columns.items()}


@dataclass(frozen=True, eq=False, repr=False)
class EachRow(Resample):
    """Measured releases in their order: shot i is row i, and there are no more shots than rows.

    Without other scatter a row is made or not, so that nothing is learnt by drawing it again.

    Attributes
    ----------
    about
        Means from which it is counted how far the rows are.
    """

    about: Mapping[str, float] = field(default_factory=dict)

    @property
    def most(self) -> int:
        """The number of shots."""
        return self.rows

    @property
    def centre(self) -> dict[str, float]:
        """The means that were given."""
        return dict(self.about)

    def _rows(self, start: int, stop: int, seed: int) -> NDArray[np.intp]:
        check_drawn(start, stop)
        if stop > self.rows:
            raise IndexError(f"shots {start} to {stop} of {self.rows} rows")
        return np.arange(start, stop)


def _labels(group: Iterable[object], rows: int) -> tuple[str, ...]:
    """Return the labels of the rows' groups as text."""
    if isinstance(group, str) or not isinstance(group, Iterable):
        raise TypeError(f"group: expected a label for each row, got {brief(group)}")
    labels = ["" if one is None or _is_nan(one) else str(one) for one in group]
    if len(labels) != rows:
        raise ValueError(f"group: expected a label for each of {rows} rows, got {len(labels)}")
    if "" in labels:
        raise ValueError(f"group: row {labels.index('') + 1} of {len(labels)} has no label")
    return tuple(labels)


def _is_nan(label: object) -> bool:
    return isinstance(label, float | np.floating) and isnan(label)


def _centre(column: Floats) -> float:
    """Return the mean of the finite numbers; of equal ones exactly theirs."""
    finite = column[np.isfinite(column)]
    if not finite.size:
        return nan
    return float(finite[0] if np.all(finite == finite[0]) else np.mean(finite))
