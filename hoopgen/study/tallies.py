"""Tallies: how many shots were of which kind and outcome, and intervals of their shares."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from inspect import signature
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.brief import brief
from hoopgen.generated.numpy import hoop
from hoopgen.hoop.kinds import Kind, kinds
from hoopgen.hoop.presets import HOOP_TABLE, NAMES
from hoopgen.inputs import is_whole
from hoopgen.parameters import resolve
from hoopgen.results import Outcome, Shots

__all__ = [
    "BLOCK",
    "COLUMNS",
    "FIELDS",
    "Tally",
    "blocks",
    "check_scene",
    "check_share",
]

FIELDS = ("outcome", "counts", "first", "uncertain")
"""Results that a tally needs of a shot."""

BLOCK = 1 << 14
"""Shots drawn and simulated at a time; their states fit a processor's cache."""

_SHAPE = (len(Kind), len(Outcome))
_CELLS = _SHAPE[0] * _SHAPE[1]

COLUMNS = _CELLS + 2
"""Of a row of numbers of a `Tally`."""


def blocks(start: int, stop: int) -> Iterator[tuple[int, int]]:
    """Cut shots `start` to `stop` - 1 into blocks."""
    for low in range(start, stop, BLOCK):
        yield low, min(low + BLOCK, stop)


@dataclass(frozen=True)
class Tally:
    """Numbers of shots, of one setting or of many.

    Attributes
    ----------
    table
        int64 (..., kinds, outcomes).
    uncertain
        int64 (...), shots with a decision within its rounding-error bound.
    uncertain_capped
        int64 (...), those of them that are capped.
    """

    table: NDArray[np.int64]
    uncertain: NDArray[np.int64]
    uncertain_capped: NDArray[np.int64]

    @classmethod
    def none(cls, *settings: int) -> Tally:
        """Return a tally of no shots, of settings in the given shape."""
        return cls.read(np.zeros((*settings, COLUMNS), np.int64))

    @classmethod
    def of(cls, shots: Shots, settings: int) -> Tally:
        """Count shots of so many settings, as many of each, one setting after the other."""
        kind = kinds(shots.outcome, shots.counts, shots.first).astype(np.intp)
        cell = kind * len(Outcome) + shots.outcome
        cell.reshape(settings, -1)[:] += np.arange(0, settings * _CELLS, _CELLS)[:, None]
        counted = np.bincount(cell, minlength=settings * _CELLS)
        doubt = shots.uncertain.reshape(settings, -1)
        capped = (shots.outcome == Outcome.CAPPED).reshape(settings, -1)
        return cls(
            counted.reshape(settings, *_SHAPE),
            np.count_nonzero(doubt, axis=1),
            np.count_nonzero(doubt & capped, axis=1),
        )

    @classmethod
    def read(cls, row: NDArray[np.int64]) -> Tally:
        """Return what `row` gave, (..., columns)."""
        table = row[..., :_CELLS].reshape(*row.shape[:-1], *_SHAPE)
        return cls(table, row[..., _CELLS], row[..., _CELLS + 1])

    def row(self) -> NDArray[np.int64]:
        """Return all numbers side by side, (..., columns)."""
        flat = self.table.reshape(*self.uncertain.shape, _CELLS)
        doubt = np.stack([self.uncertain, self.uncertain_capped], axis=-1)
        return np.concatenate([flat, doubt], axis=-1)

    def __add__(self, other: Tally) -> Tally:
        return Tally.read(self.row() + other.row())

    @property
    def shots(self) -> NDArray[np.int64]:
        """All."""
        return np.asarray(self.table.sum(axis=(-2, -1)))

    @property
    def valid(self) -> NDArray[np.int64]:
        """Those that could be simulated."""
        return self.shots - self.ended(Outcome.INVALID)

    def ended(self, outcome: Outcome) -> NDArray[np.int64]:
        """Those with an outcome."""
        return np.asarray(self.table[..., outcome].sum(axis=-1))

    def of_kind(self) -> NDArray[np.int64]:
        """By kind, (..., kinds)."""
        return np.asarray(self.table.sum(axis=-1))


_ALLOWED = tuple(signature(hoop.allowed).parameters)


def check_scene(parameters: Mapping[str, Any]) -> dict[str, float]:
    """Return the parameters of the scene, each one number.

    Raises
    ------
    TypeError, ValueError
        If a name is unknown or missing, a value is not one number, or no shot can be simulated.
    """
    values = dict(zip(NAMES, resolve(parameters, 1, HOOP_TABLE), strict=True))
    wrong = [name for name, value in parameters.items() if np.ndim(value)]
    if wrong:
        raise ValueError(f"parameters: expected one number for {', '.join(wrong)}")
    given = {hoop.VARIABLES[name]: value for name, value in values.items()}
    if not hoop.allowed(*(given[name] for name in _ALLOWED))[0] > 0.0:
        raise ValueError(
            "parameters: no shot can be simulated with these: a size or gravity is not above zero, "
            "or the ball is too big for the ring"
        )
    return {name: float(value) for name, value in values.items()}


def check_share(name: str, value: Any) -> float:
    """Return a number within 0 and 1.

    Raises
    ------
    ValueError
        If it is none; the message begins with `name`.
    """
    number = isinstance(value, float | np.floating) or is_whole(value)
    if not number or not 0.0 < value < 1.0:
        raise ValueError(f"{name}: expected a number within 0 and 1, got {brief(value)}")
    return float(value)
