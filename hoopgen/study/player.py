"""A player throws candidates with common random numbers: what differs is the release alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from types import MappingProxyType
from typing import Any, Literal

import numpy as np
import pyarrow as pa
from numpy.typing import ArrayLike, NDArray

from hoopgen.brief import brief
from hoopgen.engines import HOOP, Engine
from hoopgen.hoop.presets import NAMES, PAPER
from hoopgen.hoop.variables import ARGUMENTS, VARIABLES, check_angles, release_arguments
from hoopgen.inputs import doubles
from hoopgen.parameters import completed
from hoopgen.results import SURFACES, Outcome
from hoopgen.simulation import simulate
from hoopgen.variables import check_names

from .crew import Crew, alone
from .resample import Resample
from .scatter import Scatter
from .tallies import check_scene
from .throws import outcome_by

__all__ = ["BY", "Bounds", "By", "Player", "Thrown", "arguments_of", "one_each"]

Bounds = tuple[float, float]
"""Of a variable: low, high."""

By = Literal["any", "direct", "bank"]

BY: Mapping[str, str] = MappingProxyType(
    {
        "any": "made",
        "direct": "made, the board not touched first",
        "bank": "made, the board touched first",
    }
)
"""What may count as success."""

_BACKBOARD = SURFACES.index("backboard")

_TASK = 1 << 14
"""Shots of a task: some hundredths of a second."""


@dataclass(frozen=True)
class Thrown:
    """What became of shots.

    Attributes
    ----------
    made
        How many succeeded, or of single shots which did.
    valid
        How many could be simulated, or which. An invalid shot is no trial.
    """

    made: NDArray[Any]
    valid: NDArray[Any]

    @property
    def share(self) -> NDArray[np.float64]:
        """Share of the valid shots that succeeded; NaN if there are none."""
        share = np.full(self.valid.shape, np.nan)
        np.divide(self.made, self.valid, out=share, where=self.valid > 0)
        return share


@dataclass(frozen=True)
class Player:
    """A scatter, the scene, and what counts.

    Attributes
    ----------
    model
        How shots lie about a candidate; without scatter it is one shot.
    parameters
        Of the scene, one number each.
    by
        One of `BY`; where there is no hoop, an end of the scene.
    crew
        Who throws.
    scene
        The scene itself.

    Raises
    ------
    TypeError, ValueError
        If one is not as described.
    """

    model: Scatter | Resample = field(default_factory=lambda: Scatter({}))
    parameters: Mapping[str, Any] = field(default_factory=lambda: PAPER)
    by: str = "any"
    crew: Crew = field(default=alone, compare=False)
    scene: Engine = HOOP

    def __post_init__(self) -> None:
        if not self.scene.has_hoop:
            outcome_by(self.scene, self.by)
        elif self.by not in BY:
            raise ValueError(f"by: expected {', '.join(BY)}, got {brief(self.by)}")
        check_scene(self.parameters, self.scene)
        object.__setattr__(self, "parameters", completed(self.parameters, self.scene.table))

    def at(self, values: Mapping[str, float]) -> Player:
        """Return the player in the scene whose parameters are among the values, or as they were."""
        scene = {name: value for name, value in values.items() if name in self.parameters}
        return replace(self, parameters={**self.parameters, **scene})

    def thrown(self, values: Mapping[str, ArrayLike], shots: int, seed: int = 0) -> Thrown:
        """Return how many of the first shots of a seed succeed, and how many are valid.

        Parameters
        ----------
        values
            Variables of the candidates, one number or (m,).

        Returns
        -------
        Thrown
            Counts, (m,). The shots of each are those that the model's `draw` gives.
        """
        given = {name: np.atleast_1d(doubles(name, value)) for name, value in values.items()}
        names, columns = tuple(given), np.broadcast_arrays(*given.values())
        count, many = columns[0].size, min(shots, _TASK)
        few = _TASK // many
        worker, work = replace(self, crew=alone), []
        for low in range(0, count, few):
            some = {n: c[low : low + few] for n, c in zip(names, columns, strict=True)}
            work += [
                partial(worker.count, some, start, min(start + many, shots), seed)
                for start in range(0, shots, many)
            ]
        # One alone is done in less time than it takes to keep it.
        tables = self.crew(work) if len(work) > 1 else alone(work)
        total = np.zeros((2, count), np.int64)
        blocks = len(range(0, shots, many))
        for place, table in enumerate(tables):
            low = place // blocks * few
            counts = [table[name].to_numpy() for name in ("made", "valid")]
            total[:, low : low + few] += np.stack(counts)
        return Thrown(*total)

    def count(
        self, values: Mapping[str, NDArray[np.float64]], start: int, stop: int, seed: int
    ) -> pa.Table:
        """Return how many of shots `start` to `stop` - 1 of candidates (m,) succeed, are valid."""
        made, valid = self._throw(values, start, stop, seed).sum(axis=-1)
        return pa.table({"made": made, "valid": valid})

    def scored(self, values: Mapping[str, float], shots: int = 1, seed: int = 0) -> Thrown:
        """Return which shots of one candidate succeed, and which are valid, (shots,)."""
        one = {name: np.atleast_1d(doubles(name, value)) for name, value in values.items()}
        blocks = [
            self._throw(one, start, min(start + _TASK, shots), seed)[:, 0]
            for start in range(0, shots, _TASK)
        ]
        return Thrown(*np.concatenate(blocks, axis=-1))

    def _throw(
        self, values: Mapping[str, NDArray[np.float64]], start: int, stop: int, seed: int
    ) -> NDArray[np.bool_]:
        """Return which shots succeed, and which are valid, (2, candidates, shots)."""
        releases = self.model.around(
            {name: value[:, None] for name, value in values.items()},
            self.model.noise(start, stop, seed),
            self.parameters,
            stop - start,
        )
        shots = simulate(
            releases.states,
            releases.parameters,
            scene=self.scene,
            threads=1,
            fields=("outcome", "first"),
        )
        if self.scene.has_hoop:
            made = shots.outcome == Outcome.MADE
            if self.by != "any":
                made &= (shots.first == _BACKBOARD) == (self.by == "bank")
        else:
            made = shots.outcome == outcome_by(self.scene, self.by)
        valid = shots.outcome != self.scene.outcomes["INVALID"]
        return np.stack([made, valid]).reshape(2, -1, stop - start)


def one_each(argument: str, values: Mapping[str, Any]) -> dict[str, float]:
    """Return the values of variables, each one number.

    Raises
    ------
    TypeError, ValueError
        If a name is unknown, a value is not one number, or an angle is in degrees.
    """
    check_names(argument, values, VARIABLES)
    plain = {}
    for name, value in values.items():
        number = doubles(f"{argument}[{name!r}]", value)
        if number.ndim:
            raise ValueError(f"{argument}[{name!r}]: expected one number, got {brief(value)}")
        plain[name] = float(number)
    check_angles(argument, plain)
    return plain


def arguments_of(
    values: Mapping[str, float], parameters: Mapping[str, float] = PAPER
) -> dict[str, float]:
    """Return variables of one release as arguments of `hoopgen.release`.

    The parameters of the scene are not taken from the values; see `Player.at`.
    """
    given = {name: doubles(name, value) for name, value in values.items() if name not in NAMES}
    columns = release_arguments(given, parameters["gravity"])
    return {name: columns[name].item() for name in ARGUMENTS}
