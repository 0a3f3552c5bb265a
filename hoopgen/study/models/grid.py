"""`Grid`: every combination of values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import prod

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_mapping
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.validation import as_doubles
from hoopgen.core.variables import Releases, is_state
from hoopgen.hoop.presets import PAPER
from hoopgen.text.shorten import brief

from .release_model import as_states, check_drawn, check_turns, from_columns


@dataclass(frozen=True, repr=False)
class Grid:
    """Every combination of values; the last axis varies fastest.

    Attributes
    ----------
    axes
        Variables, or components of a state and parameters of its scene, and the values they take,
        in order.
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
        check_mapping("axes", self.axes)
        check_mapping("fixed", self.fixed)
        twice = [name for name in self.axes if name in self.fixed]
        if twice:
            raise ValueError(f"fixed: {', '.join(twice)} already among the axes")
        for name, values in self.axes.items():
            if as_doubles(f"axes[{name!r}]", values).ndim != 1 or not np.size(values):
                raise ValueError(f"axes[{name!r}]: expected a list of numbers, got {brief(values)}")
        names = (*self.axes, *self.fixed)
        check_turns("axes", self.axes, names)
        check_turns("fixed", self.fixed, names)
        columns = self._columns(0, 1)
        if is_state(names):
            as_states(columns)
        else:
            self.draw(0, 1)

    def __repr__(self) -> str:
        axes = [f"{len(values)} {name}" for name, values in self.axes.items()]
        fixed = [f"{name} {float(value):.6g}" for name, value in self.fixed.items()]
        return f"Grid({'; '.join(filter(None, [' × '.join(axes), ', '.join(fixed)]))})"

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values on each axis."""
        return tuple(len(values) for values in self.axes.values())

    @property
    def shots(self) -> int:
        """Number of combinations."""
        return prod(self.shape)

    def draw(
        self, start: int, stop: int, seed: int = 0, parameters: ParameterValues = PAPER
    ) -> Releases:
        """Return combinations `start` to `stop` - 1; nothing is random.

        Parameters
        ----------
        start, stop
            The first combination, and the one after the last.
        seed
            Of no effect: every release model takes one.
        parameters
            Of the scene, for those that are neither axes nor fixed.

        Raises
        ------
        IndexError
            If there are not so many.
        """
        if not 0 <= start <= stop <= self.shots:
            raise IndexError(f"grid: shots {start} to {stop} of {self.shots}")
        check_drawn(start, stop)
        return from_columns(self._columns(start, stop), parameters)

    def _columns(self, start: int, stop: int) -> dict[str, NDArray[np.float64]]:
        places = np.unravel_index(np.arange(start, stop), self.shape) if self.axes else ()
        columns = {
            name: as_doubles(name, values)[place]
            for (name, values), place in zip(self.axes.items(), places, strict=True)
        }
        # One axis at the least is a column; without any, the single shot has none.
        fixed = {name: as_doubles(name, value) for name, value in self.fixed.items()}
        return {**columns, **fixed}

    def identity(self) -> dict[str, object]:
        """Return the identity of the model, in types that JSON knows."""
        return {
            "model": "grid",
            "axes": {name: as_doubles(name, values).tolist() for name, values in self.axes.items()},
            "fixed": {name: float(value) for name, value in self.fixed.items()},
        }
