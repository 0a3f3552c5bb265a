"""The interface of a flight: the ball's path between two contacts, and bounds on its errors."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, field

import sympy as sp

from ..symbolic.conditionals import Barrier, IfLess, absolute, barrier, barrier_all, maximum
from ..symbolic.polynomials import Coefficients, derivative, horner
from ..symbolic.rounding import Rounded
from ..symbolic.symbols import POSITION, t

Acceleration = tuple[sp.Expr, sp.Expr, sp.Expr]
"""Components along x, y and z, m/s²."""


def has_sign(component: sp.Expr) -> bool:
    """Return True if an acceleration is positive, or negative, whatever the parameters are."""
    return bool(component.is_positive or component.is_negative)


def divisor(size: sp.Expr) -> sp.Expr:
    """Return a size, or 1 for zero: a divisor of quotients that count only if it is not zero."""
    return barrier(IfLess(0, size, size, 1))


@dataclass(frozen=True)
class SurfaceForce:
    """The force that presses a rolling ball onto its surface besides its weight, per unit mass.

    Attributes
    ----------
    buoyancy
        The share of the weight that is carried.
    lift
        The force onto the surface over the square of the speed, 1/m.
    """

    buoyancy: sp.Expr = sp.Integer(0)
    lift: sp.Expr = sp.Integer(0)

    @property
    def lift_size(self) -> sp.Expr:
        """The size of `lift`."""
        return sp.Integer(0) if self.lift == 0 else absolute(self.lift)

    def at(self, fall: sp.Expr, squared: sp.Expr) -> sp.Expr:
        """Return the force onto the surface, m/s².

        Parameters
        ----------
        fall
            The acceleration of free fall along the normal, m/s².
        squared
            The square of the speed, m²/s².
        """
        return barrier(self.buoyancy * fall) + barrier(self.lift * squared)


NO_FORCE = SurfaceForce()
"""Nothing besides the weight."""


@dataclass(frozen=True)
class Flight(ABC):
    """The motion of a ball from a state on; times are since the last contact, s.

    Attributes
    ----------
    acceleration
        The acceleration of free fall, m/s², along x, y and z.
    departs
        True if a ball may leave a surface tangentially, as one that has rolled there does.
    """

    acceleration: Acceleration
    departs: bool = field(default=False, kw_only=True)

    @property
    def source(self) -> str:
        """The equation of the path, for readers."""
        return "the flight's path"

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """Symbols that kernels of the flight pass to others, besides the state and parameters."""
        return ()

    @property
    def falls(self) -> bool:
        """True if some component of the acceleration is certainly not zero."""
        return any(has_sign(component) for component in self.acceleration)

    @property
    def upright(self) -> bool:
        """True if gravity acts along -z."""
        ax, ay, az = self.acceleration
        return bool(ax == 0 and ay == 0 and az.is_negative)

    @property
    def surface_force(self) -> SurfaceForce:
        """The force onto its surface of a rolling ball besides its weight: none."""
        return NO_FORCE

    def disturbance(self, speed: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return bounds on the force besides gravity, and on its change by the velocity.

        They are m/s² and 1/s; here zero.

        Parameters
        ----------
        speed
            A bound on the speed of the ball, and on that of its surface about its centre, m/s.
        """
        del speed
        return sp.Integer(0), sp.Integer(0)

    @property
    def strength(self) -> sp.Expr:
        """The largest size of a component of the acceleration; along an axis, its size."""
        sizes = [sp.Abs(component) for component in self.acceleration if component != 0]
        return maximum(*sizes) if sizes else sp.Integer(0)

    @property
    def along_axis(self) -> bool:
        """True if the acceleration is along one axis, or zero."""
        return len([component for component in self.acceleration if component != 0]) < 2

    @property
    def gravity(self) -> sp.Expr:
        """The size of the acceleration of free fall, m/s²."""
        if self.along_axis:
            return self.strength
        return sp.sqrt(barrier(sp.Add(*(component**2 for component in self.acceleration))))

    @property
    @abstractmethod
    def path(self) -> dict[sp.Symbol, Coefficients]:
        """The coefficients of each coordinate in time, constant first."""

    @property
    @abstractmethod
    def span(self) -> sp.Expr:
        """The time up to which the path approximates the flight, s."""

    @property
    @abstractmethod
    def remainder(self) -> sp.Expr:
        """Bound on the distance of any coordinate from its path within the span, m."""

    @property
    def exact(self) -> bool:
        """True if the path is the flight itself, at all times."""
        return bool(self.remainder == 0 and self.span == sp.oo)

    def at(self, time: sp.Expr = t) -> tuple[sp.Matrix, sp.Matrix]:
        """Return position and velocity on the path, `time` after the state, in Horner form."""
        rows = [self.path[coordinate] for coordinate in POSITION]
        moving = [horner(derivative(row), time) for row in rows]
        return sp.Matrix([horner(row, time) for row in rows]), sp.Matrix(moving)

    def start(self, time: sp.Expr = t) -> sp.Matrix:
        """Return the position at the start of a flight, given the state at its end."""
        there, _ = self.at(-time)
        return there

    def named(self) -> tuple[sp.Matrix, sp.Matrix]:
        """Return position and velocity at time t, each component held with a name."""
        position, velocity = self.at()
        return (
            barrier_all(position, [f"{axis}_t" for axis in "xyz"]),
            barrier_all(velocity, [rf"\dot {axis}_t" for axis in "xyz"]),
        )

    def quantities(self) -> dict[str, sp.Expr]:
        """Return the named parts of the motion at time t, by LaTeX, each after its own parts."""
        return {e.name: e for part in self.named() for e in part if isinstance(e, Barrier)}

    @abstractmethod
    def mean_velocity(self, time: sp.Expr = t) -> list[sp.Expr]:
        """Return the displacement up to a time over that time, m/s."""

    @abstractmethod
    def mean_rounding(self, latest: sp.Expr) -> Rounded:
        """Return the size and the error bound of any component of a mean velocity."""

    @property
    @abstractmethod
    def present_acceleration(self) -> tuple[sp.Expr, ...]:
        """The acceleration at the present velocity."""

    @abstractmethod
    def along(self) -> tuple[list[sp.Expr], list[sp.Expr]]:
        """Return the changes of position and velocity at time t by errors at the start."""

    @abstractmethod
    def path_lengths(self) -> list[sp.Expr]:
        """Return a bound on the way along each axis in a flight of time t, given its end."""

    def added_errors(self) -> tuple[sp.Expr, sp.Expr]:
        """Return the errors of position and velocity that the path adds, besides roundings."""
        return sp.Integer(0), sp.Integer(0)

    def returning_error(self) -> sp.Expr:
        """Return the error of the position that the path adds within a flight of time t."""
        return sp.Integer(0)

    @abstractmethod
    def size(self, latest: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return bounds on every coordinate and every velocity up to the time `latest`."""

    @abstractmethod
    def rounding(self, latest: sp.Expr) -> tuple[Rounded, Rounded]:
        """Return error bounds of any coordinate and any velocity up to the time `latest`.

        The time is an exact double. The bounds hold for the evaluation at that double, of a flight
        whose start is off by at most `position_error` and `velocity_error`.
        """
