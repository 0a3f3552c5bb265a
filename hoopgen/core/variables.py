"""Variables: the named numbers of a shot that a study sets, scatters and maps over."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.generated.numpy import hoop
from hoopgen.text.shorten import brief, join_names, suggestion

from .argument_types import is_names
from .units import UNITS, Kind


@dataclass(frozen=True)
class Variable:
    """A named number of a shot.

    Attributes
    ----------
    name
        As it is given.
    kind
        What is measured; `hoopgen.core.units.UNITS` has its units.
    label
        In words, for axes and tables.
    infinite
        Whether it may be infinite.
    """

    name: str
    kind: Kind
    label: str
    infinite: bool = False

    @property
    def unit(self) -> str:
        """SI unit; empty for a plain number."""
        return next(iter(UNITS[self.kind]))


KIND_OF: Mapping[str, Kind] = MappingProxyType(
    {
        "m": "length",
        "m/s": "speed",
        "m/s\u00b2": "acceleration",
        "m/s2": "acceleration",
        "kg": "mass",
        "kg/m\u00b3": "density",
        "kg/m3": "density",
    }
)
"""The kind of a parameter by its unit; a parameter with any other unit is a plain number."""

STATE = hoop.STATE
"""Components of a state, in order."""

STATE_UNITS: Mapping[str, str] = MappingProxyType(
    dict(zip(STATE, (unit for unit in ("m", "m/s", "rad/s") for _ in "xyz"), strict=True))
)
"""The unit of each component of a state."""


def is_state(columns: Iterable[str]) -> bool:
    """Return whether columns of these names are states, which have z or vx, vy, vz."""
    return not set(STATE[2:]).isdisjoint(columns)


@dataclass(frozen=True)
class Releases:
    """Shots ready to be simulated.

    Attributes
    ----------
    states
        (n, 9), as for `hoopgen.simulate`.
    parameters
        Of the scene: one number, or (n,).
    columns
        The arguments of `hoopgen.release` that gave them, each (n,); none for measured states.
    """

    states: NDArray[np.float64]
    parameters: Mapping[str, Any]
    columns: Mapping[str, NDArray[np.float64]]

    def __len__(self) -> int:
        return len(self.states)


def check_names(name: str, given: Iterable[str], allowed: Iterable[str]) -> tuple[str, ...]:
    """Return the given names, checked against the allowed ones.

    Parameters
    ----------
    name
        The argument, for the error message.
    given
        The caller's names.
    allowed
        The allowed names.

    Raises
    ------
    TypeError
        If a text is given, whose letters are no names, or what has no names at all.
    ValueError
        The message begins with `name` and lists what is allowed.
    """
    if not is_names(given):
        raise TypeError(f"{name}: expected names in a list or a mapping, got {brief(given)}")
    names = tuple(given)
    known = allowed if isinstance(allowed, Mapping) else tuple(allowed)
    unknown = [key for key in names if key not in known]
    if unknown:
        meant = suggestion(unknown[0], known) if len(unknown) == 1 else ""
        listed = ", ".join(known)
        raise ValueError(f"{name}: unknown {join_names(unknown)}{meant or '.'} One of {listed}")
    return names
