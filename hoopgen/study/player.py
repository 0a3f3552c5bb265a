"""A player throws candidates with common random numbers: what differs is the release alone."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.brief import brief
from hoopgen.inputs import doubles
from hoopgen.parameters import NAMES, PAPER
from hoopgen.releases import released
from hoopgen.results import SURFACES, Outcome
from hoopgen.simulation import simulate

from .models import Scatter
from .tallies import check_scene
from .variables import ARGUMENTS, VARIABLES, check_angles, check_names, release_arguments

__all__ = ["BY", "By", "Player", "Thrown", "arguments_of", "one_each"]

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

_BLOCK = 1 << 17
"""Shots made and simulated at a time: some 20 MB."""


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
    sd, correlation
        As for `Scatter`; none, and a candidate is one shot.
    parameters
        Of the scene, one number each.
    by
        One of `BY`.
    threads
        As for `hoopgen.simulate`; 1 where others work beside this one.

    Raises
    ------
    TypeError, ValueError
        If one is not as described.
    """

    sd: Mapping[str, float] = field(default_factory=dict)
    correlation: Mapping[tuple[str, str], float] = field(default_factory=dict)
    parameters: Mapping[str, Any] = field(default_factory=lambda: PAPER)
    by: By = "any"
    threads: int | None = None

    def __post_init__(self) -> None:
        if self.by not in BY:
            raise ValueError(f"by: expected {', '.join(BY)}, got {brief(self.by)}")
        check_scene(self.parameters)
        Scatter({}, self.sd, self.correlation)

    def at(self, values: Mapping[str, float]) -> Player:
        """Return the player in the scene whose parameters are among the values, or as they were."""
        scene = {name: value for name, value in values.items() if name in NAMES}
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
            Counts, (m,). The shots of each are those that `Scatter.draw` gives.
        """
        counts = [block.sum(axis=-1) for block in self._blocks(values, shots, seed)]
        return Thrown(*np.array(counts).sum(axis=0))

    def scored(self, values: Mapping[str, float], shots: int = 1, seed: int = 0) -> Thrown:
        """Return which shots of one candidate succeed, and which are valid, (shots,)."""
        blocks = self._blocks(values, shots, seed)
        return Thrown(*np.concatenate([block[:, 0] for block in blocks], axis=-1))

    def _blocks(
        self, values: Mapping[str, ArrayLike], shots: int, seed: int
    ) -> Iterator[NDArray[np.bool_]]:
        """Yield which succeed, and which are valid: (2, m, some shots) after (2, m, some shots)."""
        means = self._means(values)
        candidates = max(mean.size for mean in means.values())
        scatter = Scatter({}, self.sd, self.correlation)
        for start in range(0, shots, _BLOCK):
            stop = min(start + _BLOCK, shots)
            noise = scatter.noise(start, stop, seed)
            few = _BLOCK // (stop - start)
            parts = [
                self._throw({n: mean[low : low + few] for n, mean in means.items()}, noise)
                for low in range(0, candidates, few)
            ]
            yield np.concatenate(parts, axis=1)

    def _means(self, values: Mapping[str, ArrayLike]) -> dict[str, NDArray[np.float64]]:
        """Return the candidates' arguments, and the parameters that vary; (m,) each."""
        given = {name: doubles(name, value) for name, value in values.items()}
        scene = {
            name: given.pop(name, doubles(name, self.parameters[name]))
            for name in NAMES
            if name in given or name in self.sd
        }
        gravity = scene.get("gravity", self.parameters["gravity"])
        means = release_arguments(given, gravity) | scene
        names, arrays = tuple(means), np.broadcast_arrays(*map(np.atleast_1d, means.values()))
        return dict(zip(names, arrays, strict=True))

    def _throw(
        self, means: Mapping[str, NDArray[np.float64]], noise: Mapping[str, NDArray[np.float64]]
    ) -> NDArray[np.bool_]:
        """Return which succeed, and which are valid, (2, candidates, shots)."""
        columns = {name: mean[:, None] + noise.get(name, 0.0) for name, mean in means.items()}
        scene = {name: columns.pop(name) for name in NAMES if name in columns}
        states = released(columns)
        shape = np.broadcast_shapes(states.shape[:-1], *(value.shape for value in scene.values()))
        varying = {name: np.broadcast_to(value, shape).ravel() for name, value in scene.items()}
        shots = simulate(
            np.broadcast_to(states, (*shape, states.shape[-1])).reshape(-1, states.shape[-1]),
            {**self.parameters, **varying},
            threads=self.threads,
            fields=("outcome", "first"),
        )
        made = shots.outcome == Outcome.MADE
        if self.by != "any":
            made &= (shots.first == _BACKBOARD) == (self.by == "bank")
        return np.stack([made, shots.outcome != Outcome.INVALID]).reshape(2, *shape)


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
