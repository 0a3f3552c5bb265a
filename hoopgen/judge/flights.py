"""Many shots in flight at once: their states as models, and what is the same for all of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from .ball_array import BallArray, Floats, PolynomialArray, Rows
from .formulas import Formulas
from .model_array import SLOPES, ModelArray


@dataclass(frozen=True)
class Flights:
    """Shots at the start of a flight.

    Attributes
    ----------
    formulas
        The formulas of the scene.
    columns
        The kernels' inputs of the whole batch, exact: each (1,) if all shots share it.
    shots
        The numbers of these shots in the batch, (n,).
    state
        Nine models.
    clock
        The time since the release, s; without slopes.
    last
        The number of the surface that the ball leaves, or -1, (n,).
    contacts
        How many there have been, (n,).
    """

    formulas: Formulas
    columns: list[Floats]
    shots: Rows
    state: list[ModelArray]
    clock: ModelArray
    last: Rows
    contacts: Rows

    @classmethod
    def released(
        cls, formulas: Formulas, columns: list[Floats], states: Floats, shots: Rows
    ) -> Flights:
        """Return shots of a batch at their release.

        Parameters
        ----------
        formulas, columns, shots
            As above.
        states
            Of all shots of the batch, exact, (m, 9).
        """
        return cls(
            formulas,
            columns,
            shots,
            [ModelArray.exact(c) for c in np.ascontiguousarray(states[shots].T)],
            ModelArray.exact(np.zeros(len(shots))),
            np.full(len(shots), -1),
            np.zeros(len(shots), np.int64),
        )

    def __len__(self) -> int:
        return len(self.shots)

    def __getitem__(self, rows: Rows) -> Flights:
        return Flights(
            self.formulas,
            self.columns,
            self.shots[rows],
            [m[rows] for m in self.state],
            self.clock[rows],
            self.last[rows],
            self.contacts[rows],
        )

    @cached_property
    def exact(self) -> list[ModelArray]:
        """The kernels' inputs as models."""
        return [ModelArray.exact(c if len(c) == 1 else c[self.shots]) for c in self.columns]

    @cached_property
    def values(self) -> list[BallArray]:
        """The kernels' inputs as balls."""
        return [m.balls() for m in self.exact]

    @cached_property
    def balls(self) -> list[BallArray]:
        """The states as balls."""
        return [m.balls() for m in self.state]

    def at(self, time: ModelArray) -> list[ModelArray]:
        """Return the states after a time, nine models."""
        assert self.formulas.flight is not None
        return [*self.formulas.flight(self.state, self.exact, (time,)), *self.state[6:]]

    def near(self, time: BallArray | PolynomialArray) -> list[Any]:
        """Return positions and velocities after a time as balls, or as polynomials in the time."""
        assert self.formulas.flight is not None
        moved: list[Any] = self.formulas.flight(self.balls, self.values, (time,))
        return moved


def shared_columns(parameters: Floats) -> list[Floats]:
    """Return the columns of (m, p) parameters, those of one value as that, (1,)."""
    return [c[:1] if np.all(c == c[0]) else c for c in np.ascontiguousarray(parameters.T)]


def joined(parts: Sequence[Flights]) -> Flights:
    """Return several groups of shots of one batch as one."""
    first = parts[0]
    if len(parts) == 1:
        return first
    return Flights(
        first.formulas,
        first.columns,
        np.concatenate([p.shots for p in parts]),
        [_concatenated(own) for own in zip(*(p.state for p in parts), strict=True)],
        _concatenated([p.clock for p in parts]),
        np.concatenate([p.last for p in parts]),
        np.concatenate([p.contacts for p in parts]),
    )


def _concatenated(models: Sequence[ModelArray]) -> ModelArray:
    high, low, radius = map(np.concatenate, zip(*(m.arrays() for m in models), strict=True))
    if all(m.slopes is None for m in models):
        return ModelArray(high, low, radius, None)
    slopes = [np.zeros((SLOPES, len(m.high))) if m.slopes is None else m.slopes for m in models]
    return ModelArray(high, low, radius, np.concatenate(slopes, axis=1))
