"""Parameters of a scene: named numbers, their usual values, and what callers give in place."""

from __future__ import annotations

from collections.abc import Iterator, KeysView, Mapping, Sequence
from dataclasses import dataclass
from types import ModuleType
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from .brief import brief, listed
from .inputs import doubles

Value = float | NDArray[np.float64]


class Written(Protocol):
    """A scene whose kernels take more than its parameters: sizes that are computed from them."""

    @property
    def defaults(self) -> Mapping[str, float]:
        """The parameters' usual values."""

    @property
    def key(self) -> str:
        """All that decides what it does, as text, the same in any process."""

    def values(self, parameters: Mapping[str, Any] | None = None) -> Sequence[Any]:
        """Return what the kernels take, in order."""


@dataclass(frozen=True)
class Table:
    """The parameters of a scene, in calling order.

    Attributes
    ----------
    defaults
        Their usual values, by name.
    limits
        The least and the largest value of those that have a largest.
    written
        The scene, where its kernels take more than them.
    """

    defaults: Mapping[str, float]
    limits: Mapping[str, tuple[float, float]]
    written: Written | None = None

    @classmethod
    def of(cls, kernels: ModuleType, written: Written | None = None) -> Table:
        """Return the table of a generated module."""
        usual = {name: default for name, (default, _, _) in kernels.PARAMETERS.items()}
        return cls.made(usual, kernels.LIMITS, written)

    @classmethod
    def made(
        cls,
        taken: Mapping[str, float],
        limits: Mapping[str, tuple[float, float]],
        written: Written | None,
    ) -> Table:
        """Return the table of a scene, from what its kernels take."""
        if written is None:
            return cls(taken, limits)
        own = written.defaults
        return cls(own, {name: ends for name, ends in limits.items() if name in own}, written)

    def inputs(self, parameters: Mapping[str, Value]) -> list[Value]:
        """Return what the kernels take, in order, from all the parameters in theirs."""
        if self.written is None:
            return list(parameters.values())
        values = self.written.values(parameters)
        return [np.ascontiguousarray(v, np.float64) if np.ndim(v) else float(v) for v in values]


class Parameters(Mapping[str, Any]):
    """A read-only mapping from parameter names to values that merges with ``|``.

    Parameters
    ----------
    values
        Names and values; SI units.
    """

    def __init__(self, values: Mapping[str, Any]) -> None:
        self._values = dict(values)

    def __getitem__(self, name: str) -> Any:
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def keys(self) -> KeysView[str]:
        """Return the names."""
        return self._values.keys()

    def __len__(self) -> int:
        return len(self._values)

    def __or__(self, other: Mapping[str, Any]) -> Parameters:
        """Return these parameters with those of `other` in their place."""
        return Parameters(self._values | dict(other))

    def __ror__(self, other: Mapping[str, Any]) -> Parameters:
        return Parameters(dict(other) | self._values)

    def __repr__(self) -> str:
        return f"Parameters({self._values!r})"


def completed(parameters: Mapping[str, Any] | None, table: Table) -> Mapping[str, Any]:
    """Return all parameters of a scene in calling order: usual values for those left out.

    Raises
    ------
    TypeError
        If `parameters` is not a mapping.
    ValueError
        If a name is unknown; the message lists the right ones.
    """
    if parameters is None:
        return table.defaults
    if not isinstance(parameters, Mapping):
        raise TypeError(
            f"parameters: expected a mapping of names to values, got {brief(parameters)}"
        )
    values = {**table.defaults, **parameters}
    if len(values) > len(table.defaults):
        named = listed(name for name in values if name not in table.defaults)
        names = ", ".join(table.defaults) or "none"
        raise ValueError(f"parameters: unknown {named}. The names are {names}")
    return values


def resolve(parameters: Mapping[str, Any] | None, shots: int, table: Table) -> list[Value]:
    """Return the parameters in calling order, each a number or of shape (shots,).

    Parameters
    ----------
    parameters
        Those that are given; the others have their usual values.
    table
        Those of the scene.

    Raises
    ------
    TypeError
        If `parameters` is not a mapping, or a value cannot become float64.
    ValueError
        If a name is unknown, a shape is wrong, or a number for all shots is not within its limits.
    """
    values: list[Value] = []
    for name, given in completed(parameters, table).items():
        if type(given) is float:  # the common case, without detours
            values.append(given)
            continue
        numbers = doubles(f"parameters[{name!r}]", given)
        if numbers.shape not in ((), (shots,)):
            raise ValueError(
                f"parameters[{name!r}]: expected one number or {shots}, one a shot; "
                f"got shape {numbers.shape}"
            )
        values.append(np.ascontiguousarray(numbers) if numbers.ndim else float(numbers))
    own = dict(zip(table.defaults, values, strict=True))
    for name, (low, high) in table.limits.items():
        value = own[name]
        if isinstance(value, float) and not low <= value <= high:
            expected = f"{low:g} to {high:g}" if low > -np.inf else f"at most {high:g}"
            raise ValueError(f"parameters[{name!r}]: expected {expected}, got {value}")
    return values
