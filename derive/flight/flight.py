"""What a flight is: where a ball is between two contacts, and how exactly formulas say it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import sympy as sp

from ..ground.choice import hold_all, largest
from ..ground.polynomials import Coefficients, derivative, horner
from ..ground.rounding import Rounded
from ..ground.symbols import POSITION, t


@dataclass(frozen=True)
class Flight(ABC):
    """How a ball moves from a state on; times since the last contact, s.

    Attributes
    ----------
    acceleration
        Of free fall, m/s², along x, y and z; not zero throughout.
    """

    acceleration: tuple[sp.Expr, sp.Expr, sp.Expr]

    def __post_init__(self) -> None:
        if all(component == 0 for component in self.acceleration):
            raise ValueError("a flight's acceleration: expected one that is not zero, got zero")

    @property
    def strength(self) -> sp.Expr:
        """No component of the acceleration is larger; along an axis, its size."""
        return largest(*(sp.Abs(component) for component in self.acceleration if component != 0))

    @property
    @abstractmethod
    def path(self) -> dict[sp.Symbol, Coefficients]:
        """Each coordinate as its coefficients in time, constant first."""

    @property
    @abstractmethod
    def span(self) -> sp.Expr:
        """Until when the path is the flight's, s."""

    @property
    @abstractmethod
    def remainder(self) -> sp.Expr:
        """Bound on how far any coordinate is from its path within the span, m."""

    @property
    def exact(self) -> bool:
        """Whether the path is the flight itself, at all times."""
        return bool(self.remainder == 0 and self.span == sp.oo)

    def at(self, time: sp.Expr = t) -> tuple[sp.Matrix, sp.Matrix]:
        """Return position and velocity on the path, `time` after the state, in Horner form."""
        rows = [self.path[coordinate] for coordinate in POSITION]
        moving = [horner(derivative(row), time) for row in rows]
        return sp.Matrix([horner(row, time) for row in rows]), sp.Matrix(moving)

    def named(self) -> tuple[sp.Matrix, sp.Matrix]:
        """Return position and velocity at the time t, each component held with a name."""
        position, velocity = self.at()
        return (
            hold_all(position, [f"{axis}_t" for axis in "xyz"]),
            hold_all(velocity, [rf"\dot {axis}_t" for axis in "xyz"]),
        )

    @abstractmethod
    def size(self, latest: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return bounds on every coordinate and every velocity up to the time `latest`."""

    @abstractmethod
    def rounding(self, latest: sp.Expr) -> tuple[Rounded, Rounded]:
        """Return bounds for any coordinate and any velocity up to the time `latest`.

        The time itself is an exact double: what is bounded is the evaluation at that double, of a
        flight whose start is off by at most `position_error` and `velocity_error`.
        """
