"""Tallies: the number of shots by kind, outcome and contacts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.parameters import ParameterValues, resolve
from hoopgen.core.validation import check_contacts, is_whole
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.hoop.kinds import TOUCHES, Kind, sum_by_kind, touches
from hoopgen.results.shots import Shots
from hoopgen.simulation.hoop import HOOP
from hoopgen.simulation.invalid_shots import allowed, not_allowed, out_of_range
from hoopgen.text.shorten import brief, join_names

_FIELDS = ("outcome", "counts", "first", "uncertain")
_SHARED = ("uncertain", "uncertain_capped")

BLOCK = 1 << 14
"""Shots drawn and simulated at a time; their states fit a processor's cache."""


def fields_of(scene: CompiledScene) -> tuple[str, ...]:
    """Return the results that a tally needs of a shot."""
    return (*_FIELDS, *(result.name for result in scene.layout.counted_results))


def _shared(scene: CompiledScene) -> int:
    """Return the number of entries of a tally besides its table."""
    return len(_SHARED) + len(scene.layout.counted_results)


def _shape(scene: CompiledScene) -> tuple[int, int]:
    """Return the number of kinds, one without a hoop, and the number of outcomes."""
    return len(Kind) if scene.has_hoop else 1, len(scene.outcomes)


def width_of(scene: CompiledScene) -> int:
    """Return the number of columns of a `Tally` as a row of numbers."""
    return prod(_shape(scene)) + _shared(scene)


def blocks(start: int, stop: int) -> Iterator[tuple[int, int]]:
    """Cut shots `start` to `stop` - 1 into blocks.

    Parameters
    ----------
    start
        The index of the first shot.
    stop
        The index after that of the last shot.
    """
    for low in range(start, stop, BLOCK):
        yield low, min(low + BLOCK, stop)


@dataclass(frozen=True)
class Tally:
    """Numbers of shots, of one setting or of many.

    Attributes
    ----------
    uncertain
        int64 (...), shots with a decision within its rounding-error bound.
    counts
        int64 (...) each: by name the shots in which a result of the scene is not zero, for the
        results that are counted so, such as those that rolled.
    """

    table: NDArray[np.int64]  # int64 (..., kinds, outcomes)
    uncertain: NDArray[np.int64]
    uncertain_capped: NDArray[np.int64]  # int64 (...), those of them that are capped
    counts: Mapping[str, NDArray[np.int64]]
    scene: CompiledScene  # whose kinds and outcomes they are; without a hoop there is one kind

    @classmethod
    def none(cls, *settings: int, scene: CompiledScene = HOOP) -> Tally:
        """Return a tally of no shots, of settings in the given shape."""
        return cls.read(np.zeros((*settings, width_of(scene)), np.int64), scene)

    @classmethod
    def from_shots(cls, shots: Shots, settings: int) -> Tally:
        """Count shots of so many settings, as many of each, one setting after the other.

        Parameters
        ----------
        shots
            The results, of equally many shots in each setting.
        settings
            The number of settings.
        """
        scene = shots.scene
        rows, columns = TOUCHES if scene.has_hoop else 1, len(scene.outcomes)
        cell = shots.outcome
        if scene.has_hoop:
            cell = touches(shots.counts, shots.first) * np.uint8(columns) + cell
        if settings > 1:
            cell = cell.astype(np.intp)
            cell.reshape(settings, -1)[:] += np.arange(settings)[:, None] * (rows * columns)
        counted = np.bincount(cell, minlength=settings * rows * columns)
        counted = counted.reshape(settings, rows, columns)
        uncertain = shots.uncertain.reshape(settings, -1)
        capped = (shots.outcome == scene.outcomes["CAPPED"]).reshape(settings, -1)
        counts = {
            result.tally: np.count_nonzero(
                getattr(shots, result.name).reshape(settings, -1), axis=1
            )
            for result in scene.layout.counted_results
        }
        return cls(
            sum_by_kind(counted) if scene.has_hoop else counted,
            np.count_nonzero(uncertain, axis=1),
            np.count_nonzero(uncertain & capped, axis=1),
            counts,
            scene,
        )

    @classmethod
    def read(cls, row: NDArray[np.int64], scene: CompiledScene) -> Tally:
        """Return the tally from the result of `row`, (..., columns).

        Parameters
        ----------
        row
            The numbers, (..., columns).
        scene
            The scene in which the shots were thrown.
        """
        shared = _shared(scene)
        table = row[..., :-shared].reshape(*row.shape[:-1], *_shape(scene))
        uncertain, capped, *others = (row[..., k - shared] for k in range(shared))
        names = (result.tally for result in scene.layout.counted_results)
        return cls(table, uncertain, capped, dict(zip(names, others, strict=True)), scene)

    def row(self) -> NDArray[np.int64]:
        """Return all numbers side by side, (..., columns)."""
        flat = self.table.reshape(*self.uncertain.shape, prod(_shape(self.scene)))
        numbers = (self.uncertain, self.uncertain_capped, *self.counts.values())
        shared = np.stack(numbers, axis=-1)
        return np.concatenate([flat, shared], axis=-1)

    def __add__(self, other: Tally) -> Tally:
        return Tally.read(self.row() + other.row(), self.scene)

    @property
    def shots(self) -> NDArray[np.int64]:
        """The number of all shots."""
        return np.asarray(self.table.sum(axis=(-2, -1)))

    @property
    def valid(self) -> NDArray[np.int64]:
        """The number of valid shots."""
        return self.shots - self.ended(self.scene.outcomes["INVALID"])

    def ended(self, outcome: int) -> NDArray[np.int64]:
        """The number of shots with an outcome."""
        return np.asarray(self.table[..., outcome].sum(axis=-1))

    def of_kind(self) -> NDArray[np.int64]:
        """Counts by kind, (..., kinds)."""
        return np.asarray(self.table.sum(axis=-1))


def check_scene(
    parameters: ParameterValues | None, scene: CompiledScene = HOOP
) -> dict[str, float]:
    """Return all parameters of a scene, each one number: usual values for those left out.

    Parameters
    ----------
    parameters
        Parameters by name, one number each, SI.
    scene
        The scene whose parameters they are.
    """
    values = {n: float(value) for n, value in resolve(parameters, None, scene.table).items()}
    endless = [n for n, v in values.items() if not np.isfinite(v) and not _infinite(scene, n, v)]
    if endless:
        text = join_names(f"{name} {values[name]}" for name in endless)
        raise ValueError(f"parameters: no shot can be simulated with these: {text} is not finite")
    if not allowed(scene, values):
        alone = join_names(f"{name} {values[name]}" for name in not_allowed(scene, values))
        why = f"{alone} not allowed" if alone else "one is not allowed, beside the others"
        if scene.is_hoop:
            why = "a size or gravity is not above zero, or the ball is too big for the ring"
        raise ValueError(f"parameters: no shot can be simulated with these: {why}")
    if sizes := out_of_range(scene, values):
        raise ValueError(
            f"parameters: no shot can be simulated with these: out of range: {'; '.join(sizes)}"
        )
    return values


def _infinite(scene: CompiledScene, name: str, value: Any) -> bool:
    return name in scene.infinite and bool(value == np.inf)


def contacts_of(max_contacts: int | None, scene: CompiledScene) -> int:
    """Return the contacts with which a shot ends as capped; of None, as many as is usual there.

    Parameters
    ----------
    max_contacts
        The number that was given.
    scene
        The scene in which shots are thrown.
    """
    return scene.max_contacts if max_contacts is None else check_contacts(max_contacts)


def check_share(name: str, value: Any) -> float:
    """Return a number within 0 and 1.

    Parameters
    ----------
    name
        The name of the argument, for the error.
    value
        The value that was given.
    """
    number = isinstance(value, float | np.floating) or is_whole(value)
    if not number or not 0.0 < value < 1.0:
        raise ValueError(f"{name}: expected a number within 0 and 1, got {brief(value)}")
    return float(value)
