"""Parameters of a scene: named numbers, their defaults and callers' values."""

from __future__ import annotations

from collections.abc import Iterator, KeysView, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType, ModuleType
from typing import Protocol, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.text.shorten import brief, join_names, suggestion

from .argument_types import check_mapping
from .validation import as_doubles

Value = float | NDArray[np.float64]

ParameterValues = Mapping[str, ArrayLike]
"""Parameters of a scene as callers give them: names and values, one number each or (n,)."""

AIR_DEFAULTS: Mapping[str, float] = MappingProxyType(
    {
        "ball_mass": 0.624,
        "air_density": 1.2,
        "drag_coefficient": 0.5,
        "lift_coefficient": 0.6,
        "drag_smoothing_speed": 0.05,
    }
)
"""Parameters that every scene in air has beside its own, and their usual values, SI units: those of
`derive/scenes/air.py`, which a test compares, since they are asked for without SymPy."""

THIN_SHELL = 2.0 / 3.0
"""The usual value of `inertia`, the ball's moment of inertia over m R_B²: that of
`derive/contact/ball.py`, which a test compares. Every hoop but the article's has this parameter."""

OF_COURT = (
    "board_thickness",
    "bridge_depth",
    "ring_restitution",
    "backboard_restitution",
    "bridge_restitution",
    "ring_friction",
    "backboard_friction",
    "bridge_friction",
    "tangential_restitution",
    "restitution_speed",
)
"""Parameters of `COURT` that neither the article's hoop nor `AIR` has; a test compares them."""


Held = TypeVar("Held", bound=Value, covariant=True)
Other = TypeVar("Other", bound=Value)


class DerivedInputs(Protocol):
    """A scene whose kernels take inputs that are computed from its parameters."""

    @property
    def defaults(self) -> Mapping[str, float]:
        """The parameters' defaults."""

    @property
    def key(self) -> str:
        """The scene's identity as text, the same in any process."""

    def values(self, parameters: ParameterValues | None = None) -> Sequence[Value]:
        """Return the kernels' inputs, in order."""

    def changes(self, parameters: ParameterValues, name: str) -> Sequence[Value]:
        """Return the derivatives of the kernels' inputs by a parameter, in order.

        Parameters
        ----------
        parameters
            All parameters.
        name
            The parameter.
        """


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
    written: DerivedInputs | None = None

    @classmethod
    def from_kernels(cls, kernels: ModuleType, written: DerivedInputs | None = None) -> Table:
        """Return the table of a generated module.

        Parameters
        ----------
        kernels
            The generated module.
        written
            The inputs that are computed from parameters; None if there are none.
        """
        usual = {name: default for name, (default, _, _) in kernels.PARAMETERS.items()}
        return cls.from_defaults(usual, kernels.LIMITS, written)

    @classmethod
    def from_defaults(
        cls,
        taken: Mapping[str, float],
        limits: Mapping[str, tuple[float, float]],
        written: DerivedInputs | None,
    ) -> Table:
        """Return the table of a scene with derived inputs.

        Parameters
        ----------
        taken
            Defaults of the kernels' inputs by name.
        limits
            Lowest and highest allowed value by name.
        written
            The inputs that are computed from parameters; None if there are none.
        """
        if written is None:
            return cls(taken, limits)
        own = written.defaults
        return cls(own, {name: ends for name, ends in limits.items() if name in own}, written)

    def inputs(self, parameters: Mapping[str, Value]) -> list[Value]:
        """Return the kernels' inputs, in order, from all parameters in calling order."""
        if self.written is None:
            return list(parameters.values())
        values = self.written.values(parameters)
        return [np.ascontiguousarray(v, np.float64) if np.ndim(v) else float(v) for v in values]

    def changes(self, parameters: Mapping[str, Value], name: str) -> list[Value]:
        """Return the derivatives of the kernels' inputs by a parameter, in order.

        Parameters
        ----------
        parameters
            All parameters in calling order.
        name
            The parameter.
        """
        if self.written is None:
            return [1.0 if own == name else 0.0 for own in parameters]
        return list(self.written.changes(parameters, name))


class Parameters(Mapping[str, Held]):
    """A read-only mapping from parameter names to values that merges with ``|``.

    Parameters
    ----------
    values
        Names and values; SI units.
    """

    def __init__(self, values: Mapping[str, Held]) -> None:
        self._values = dict(values)

    def __getitem__(self, name: str) -> Held:
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def keys(self) -> KeysView[str]:
        """Return the names."""
        return self._values.keys()

    def __len__(self) -> int:
        return len(self._values)

    def __or__(self, other: Mapping[str, Other]) -> Parameters[Held | Other]:
        """Return these parameters with those of `other` in their place."""
        return Parameters({**self._values, **other})

    def __ror__(self, other: Mapping[str, Other]) -> Parameters[Held | Other]:
        return Parameters({**other, **self._values})

    def __repr__(self) -> str:
        return f"Parameters({self._values!r})"


def complete(parameters: ParameterValues | None, table: Table) -> ParameterValues:
    """Return all parameters of a scene in calling order, with defaults for those left out.

    Parameters
    ----------
    parameters
        Values by name; None for the defaults.
    table
        The parameters of the scene.

    Raises
    ------
    TypeError
        If `parameters` is not a mapping.
    ValueError
        If a name is unknown; the message lists the right ones.
    """
    if parameters is None:
        return table.defaults
    check_mapping("parameters", parameters)
    values = {**table.defaults, **parameters}
    if len(values) > len(table.defaults):
        unknown = [name for name in values if name not in table.defaults]
        meant = suggestion(unknown[0], table.defaults) if len(unknown) == 1 else ""
        names = ", ".join(table.defaults) or "none"
        raise ValueError(
            f"parameters: unknown {join_names(unknown)}{meant or _scene_of(unknown, table)} "
            f"The names are {names}"
        )
    return values


def _scene_of(unknown: Sequence[str], table: Table) -> str:
    """Return which scene of a hoop has parameters that another one has not; "." for none."""
    air, court = (not set(names).isdisjoint(unknown) for names in (AIR_DEFAULTS, OF_COURT))
    if "ring_radius" not in table.defaults or not (air or court or "inertia" in unknown):
        return "."
    if air and court:
        return "; give scene=hoopgen.COURT_AIR for these."
    if air or court:
        return f"; give scene=hoopgen.{'AIR' if air else 'COURT'}, or COURT_AIR, for these."
    return "; give scene=hoopgen.COURT, AIR or COURT_AIR for these."


def of_scene(parameters: ParameterValues, table: Table) -> ParameterValues:
    """Return all parameters of a scene as `complete` does, of some that have to be given."""
    check_mapping("parameters", parameters)
    return complete(parameters, table)


def resolve(
    parameters: ParameterValues | None, shots: int | None, table: Table
) -> dict[str, Value]:
    """Return the parameters by name in calling order, each a number or of shape (shots,).

    Parameters
    ----------
    parameters
        Those that are given; the others have their usual values.
    shots
        The number of shots; None if each parameter is to be one number.
    table
        Those of the scene.

    Raises
    ------
    TypeError
        If `parameters` is not a mapping, or a value cannot become float64.
    ValueError
        If a name is unknown, a shape is wrong, or a number for all shots is not within its limits.
    """
    values: dict[str, Value] = {}
    for name, given in complete(parameters, table).items():
        if type(given) is float:  # the common case, without detours
            values[name] = given
            continue
        numbers = as_doubles(f"parameters[{name!r}]", given)
        if shots is None and numbers.ndim:
            raise ValueError(
                f"parameters[{name!r}]: expected one number for all shots, got {brief(given)}"
            )
        if numbers.shape not in ((), (shots,)):
            raise ValueError(
                f"parameters[{name!r}]: expected one number or {shots}, one a shot; "
                f"got shape {numbers.shape}"
            )
        values[name] = np.ascontiguousarray(numbers) if numbers.ndim else float(numbers)
    for name, (low, high) in table.limits.items():
        value = values[name]
        if isinstance(value, float) and not low <= value <= high:
            expected = f"{low:g} to {high:g}" if low > -np.inf else f"at most {high:g}"
            raise ValueError(f"parameters[{name!r}]: expected {expected}, got {value}")
    return values


def means(
    parameters: Mapping[str, ArrayLike], valid: NDArray[np.bool_] | None = None
) -> dict[str, float]:
    """Return one number for each parameter, as a picture of many shots needs.

    Parameters
    ----------
    parameters
        By name, each a number or (n,). Of those that differ from shot to shot it is the mean of the
        finite ones, since a shot whose own is none is INVALID and not in the picture.
    valid
        Which shots count, (n,); None for all. If none does, all do.
    """
    found = {}
    for name, value in parameters.items():
        own = as_doubles(f"parameters[{name!r}]", value)
        if own.ndim:
            counted = np.isfinite(own) if valid is None else np.isfinite(own) & valid
            own = own[counted] if counted.any() else own
        found[name] = float(np.mean(own))
    return found
