"""Tallies: how many shots were of which kind and outcome, and intervals of their shares."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.brief import brief, listed
from hoopgen.engines import HOOP, Engine
from hoopgen.hoop.kinds import Kind, kinds
from hoopgen.inputs import check_contacts, is_whole
from hoopgen.invalid import allowed, not_allowed, out_of_range
from hoopgen.parameters import resolve
from hoopgen.results import Shots

__all__ = [
    "BLOCK",
    "fields_of",
    "Tally",
    "blocks",
    "check_scene",
    "check_share",
    "width_of",
    "contacts_of",
]

_FIELDS = ("outcome", "counts", "first", "uncertain")
_ROLLING = ("rolls", "slip_left")

BLOCK = 1 << 14
"""Shots drawn and simulated at a time; their states fit a processor's cache."""


def fields_of(scene: Engine) -> tuple[str, ...]:
    """Return the results that a tally needs of a shot."""
    return (*_FIELDS, *(_ROLLING if scene.rolls else ()))


def _shared(scene: Engine) -> int:
    """Return how many numbers of a tally there are beside its table."""
    return 4 if scene.rolls else 2


def _shape(scene: Engine) -> tuple[int, int]:
    """Return how many kinds there are, one where there is no hoop, and how many outcomes."""
    return len(Kind) if scene.has_hoop else 1, len(scene.outcomes)


def width_of(scene: Engine) -> int:
    """Return how many columns a row of numbers of a `Tally` has."""
    return prod(_shape(scene)) + _shared(scene)


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
    rolled, slip_left
        int64 (...), shots that rolled, and those that ended with slip left: 0 where none can.
    scene
        Whose kinds and outcomes they are; without a hoop there is one kind.
    """

    table: NDArray[np.int64]
    uncertain: NDArray[np.int64]
    uncertain_capped: NDArray[np.int64]
    rolled: NDArray[np.int64]
    slip_left: NDArray[np.int64]
    scene: Engine

    @classmethod
    def none(cls, *settings: int, scene: Engine = HOOP) -> Tally:
        """Return a tally of no shots, of settings in the given shape."""
        return cls.read(np.zeros((*settings, width_of(scene)), np.int64), scene)

    @classmethod
    def of(cls, shots: Shots, settings: int) -> Tally:
        """Count shots of so many settings, as many of each, one setting after the other."""
        scene = shots.scene
        shape = _shape(scene)
        cell = shots.outcome.astype(np.intp)
        if scene.has_hoop:
            cell += kinds(shots.outcome, shots.counts, shots.first).astype(np.intp) * shape[1]
        cells = prod(shape)
        cell.reshape(settings, -1)[:] += np.arange(0, settings * cells, cells)[:, None]
        counted = np.bincount(cell, minlength=settings * cells)
        doubt = shots.uncertain.reshape(settings, -1)
        capped = (shots.outcome == scene.outcomes["CAPPED"]).reshape(settings, -1)
        there = (
            [getattr(shots, name) > 0 for name in _ROLLING] if scene.rolls else [~doubt & doubt] * 2
        )
        rolled, slipping = (np.count_nonzero(t.reshape(settings, -1), axis=1) for t in there)
        return cls(
            counted.reshape(settings, *shape),
            np.count_nonzero(doubt, axis=1),
            np.count_nonzero(doubt & capped, axis=1),
            rolled,
            slipping,
            scene,
        )

    @classmethod
    def read(cls, row: NDArray[np.int64], scene: Engine) -> Tally:
        """Return what `row` gave, (..., columns)."""
        shared = _shared(scene)
        table = row[..., :-shared].reshape(*row.shape[:-1], *_shape(scene))
        numbers = [row[..., k - shared] for k in range(shared)]
        numbers += [np.zeros_like(numbers[0])] * (4 - shared)
        uncertain, capped, rolled, slip_left = numbers
        return cls(table, uncertain, capped, rolled, slip_left, scene)

    def row(self) -> NDArray[np.int64]:
        """Return all numbers side by side, (..., columns)."""
        flat = self.table.reshape(*self.uncertain.shape, prod(_shape(self.scene)))
        numbers = [self.uncertain, self.uncertain_capped, self.rolled, self.slip_left]
        shared = np.stack(numbers[: _shared(self.scene)], axis=-1)
        return np.concatenate([flat, shared], axis=-1)

    def __add__(self, other: Tally) -> Tally:
        return Tally.read(self.row() + other.row(), self.scene)

    @property
    def shots(self) -> NDArray[np.int64]:
        """All."""
        return np.asarray(self.table.sum(axis=(-2, -1)))

    @property
    def valid(self) -> NDArray[np.int64]:
        """Those that could be simulated."""
        return self.shots - self.ended(self.scene.outcomes["INVALID"])

    def ended(self, outcome: int) -> NDArray[np.int64]:
        """Those with an outcome."""
        return np.asarray(self.table[..., outcome].sum(axis=-1))

    def of_kind(self) -> NDArray[np.int64]:
        """By kind, (..., kinds)."""
        return np.asarray(self.table.sum(axis=-1))


def check_scene(parameters: Mapping[str, Any] | None, scene: Engine = HOOP) -> dict[str, float]:
    """Return all parameters of a scene, each one number: usual values for those left out.

    Raises
    ------
    TypeError, ValueError
        If a name is unknown, a value is not one number, or no shot can be simulated.
    """
    values = dict(zip(scene.table.defaults, resolve(parameters, 1, scene.table), strict=True))
    wrong = [name for name, value in (parameters or {}).items() if np.ndim(value)]
    if wrong:
        raise ValueError(f"parameters: expected one number for {', '.join(wrong)}")
    endless = [n for n, v in values.items() if not np.isfinite(v) and not _infinite(scene, n, v)]
    if endless:
        said = listed(f"{name} {values[name]}" for name in endless)
        raise ValueError(f"parameters: no shot can be simulated with these: {said} is not finite")
    if not allowed(scene, values):
        alone = listed(f"{name} {values[name]}" for name in not_allowed(scene, values))
        why = f"{alone} not allowed" if alone else "one is not allowed, beside the others"
        if scene.is_hoop:
            why = "a size or gravity is not above zero, or the ball is too big for the ring"
        raise ValueError(f"parameters: no shot can be simulated with these: {why}")
    if sizes := out_of_range(scene, values):
        raise ValueError(
            f"parameters: no shot can be simulated with these: out of range: {'; '.join(sizes)}"
        )
    return {name: float(value) for name, value in values.items()}


def _infinite(scene: Engine, name: str, value: Any) -> bool:
    return name in scene.infinite and bool(value == np.inf)


def contacts_of(max_contacts: int | None, scene: Engine) -> int:
    """Return the contacts with which a shot ends as capped; of None, as many as is usual there.

    Raises
    ------
    ValueError
        If it is no whole number from 1, or more than the engines count.
    """
    return scene.max_contacts if max_contacts is None else check_contacts(max_contacts)


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
