"""The forces of the air on a ball, per unit mass: drag, buoyancy and the Magnus force.

With the density ϱ of the air and the area A = π R² of a ball of radius R and mass m,

    drag -k_d σ v, k_d = ϱ A C_d / 2m;   Magnus force Ω × v, Ω = ϱ A R C_m w / 2m;
    buoyancy ϱ (4/3) π R³ / m of the weight.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import barrier, barrier_all
from ..symbolic.symbols import spin

PI = sp.floor(sp.pi * 2**51) / sp.Integer(2) ** 51
"""The greatest double below π, within 2 u of it."""


@dataclass(frozen=True)
class AirConstants:
    """The parameters of the motion through air: expressions in SI units.

    Attributes
    ----------
    ball_radius, ball_mass
        R and m, m and kg.
    air_density
        ϱ, kg/m³.
    drag_coefficient, lift_coefficient
        C_d and C_m.
    smoothing_speed
        v_s, m/s.
    """

    ball_radius: sp.Expr
    ball_mass: sp.Expr
    air_density: sp.Expr
    drag_coefficient: sp.Expr
    lift_coefficient: sp.Expr
    smoothing_speed: sp.Expr

    @property
    def _half_column(self) -> sp.Expr:
        """ϱ A / 2m, 1/m."""
        area = barrier(PI * barrier(self.ball_radius**2))
        return barrier(barrier(self.air_density * area) / barrier(2 * self.ball_mass))

    @property
    def drag(self) -> sp.Expr:
        """k_d, 1/m."""
        return barrier(self.drag_coefficient * self._half_column, "k_d")

    @property
    def rotation(self) -> sp.Matrix:
        """Ω, 1/s."""
        return barrier_all(self.lift_per_spin * spin, [rf"\Omega_{axis}" for axis in "xyz"])

    @property
    def buoyancy(self) -> sp.Expr:
        """Share of the weight that the air carries."""
        return barrier(barrier(self._half_column * self.ball_radius) * sp.Rational(8, 3))

    @property
    def lift_per_spin(self) -> sp.Expr:
        """k_m, the Magnus rate by the spin, a plain number."""
        return barrier(barrier(self.ball_radius * self._half_column) * self.lift_coefficient)
