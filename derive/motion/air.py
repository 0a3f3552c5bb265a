"""Flight through air: a Taylor series of one step, and a proved bound on what it leaves out.

The forces on a ball of mass m, radius R and constant spin w are gravity less buoyancy, drag and the
Magnus force. Per unit mass, with the density ϱ of the air and the area A = π R² of the ball,

    v' = f(v) = -g_e e_z - k_d σ v + Ω × v,   σ = √(v·v + v_s²),
    k_d = ϱ A C_d / 2m,   Ω = ϱ A R C_m w / 2m,   g_e = g (1 - ϱ (4/3) π R³ / m).

The speed v_s makes the drag analytic where the ball is at rest. The coefficients of v and σ in time
follow from those before:

    q_k = Σ V_i·V_{k-i} (+ v_s² at k = 0),   σ_0 = √q_0,   σ_k = (q_k - Σ' σ_i σ_{k-i}) / 2σ_0,
    V_{k+1} = (-k_d Σ σ_i V_{k-i} + Ω × V_k - g_e e_z [k = 0]) / (k+1),

where Σ' leaves out the first and the last term.

The bound. The polynomials v_n and σ_n of degree P fulfil both equations up to their degree, except
for roundings. With A_k = |V_k|₁ h^k, B_k = |σ_k| h^k and suffix sums S, on [0, h]

    |q_n - σ_n²| <= D = Σ_k (A_k S^A_{P+1-k} + B_k S^B_{P+1-k}) + ρ,
    |σ(v_n) - σ_n| <= D / s,   s = B_0 - S^B_1,
    |v_n' - f(v_n)| <= d = k_d (Σ_k B_k S^A_{P-k} + (D/s) S^A_0) + |Ω|₁ A_P + ρ'.

Within `TUBE` of v_n the derivative of f is at most L = 2 k_d (S^B_0 + D/s + `TUBE`) + |Ω|₁, so by
Gronwall's lemma an error E of the velocity at the start is at most (E + d h) / (1 - L h) at the
end, since 1/(1 - L h) >= exp(L h); that is proved if it does not exceed `TUBE`. The position is off
by h times that. ρ and ρ' are what `COEFFICIENT_ROUNDINGS` leave of the two equations.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from ..symbolic.conditionals import (
    Choose,
    IfLess,
    Less,
    absolute,
    all_of,
    barrier,
    barrier_all,
    minimum,
)
from ..symbolic.polynomials import horner
from ..symbolic.rounding import ROUNDING_SLACK
from ..symbolic.symbols import UNIT_ROUNDOFF, position, spin, velocity

ORDER = 15
"""Degree of the velocity in time. The step's root is then of degree 16: four square roots."""

TOLERANCE = sp.Rational(1, 2**46)
"""m/s: the step is so long that about this much of the velocity is left out."""

SAFETY = sp.Rational(27, 32)
"""Share of the estimated step that is taken."""

LONGEST = sp.Integer(1)
"""Longest step, s."""

STEP_GRAIN = sp.Rational(3, 2) * 2**26
"""A number to which a shorter time is added as a multiple of 2^-26 s. Times of steps are such
multiples, so that sums and differences of them are exact."""

TUBE = sp.Rational(1, 2**10)
"""Largest error of the velocity for which the bound is proved, m/s."""

COEFFICIENT_ROUNDINGS = 64
"""Roundings, each at most u, between a coefficient and the sum of the sizes of its terms. There are
fewer: 17 of a sum of products, 12 of the constants, three of each product, two of a quotient."""

CANCELLATION = sp.Rational(1, 2**40)
"""Share of a positive quantity that covers the roundings of what is subtracted from it."""

UNDERFLOW = sp.Rational(1, 2**600)
"""m/s²: far more than what is lost of the defect where coefficients underflow."""

PI = sp.floor(sp.pi * 2**51) / sp.Integer(2) ** 51
"""The greatest double below π, within 2 u of it."""


@dataclass(frozen=True)
class AirConstants:
    """The parameters of the motion through air: expressions in SI units.

    Attributes
    ----------
    gravity
        g, m/s².
    ball_radius, ball_mass
        R and m, m and kg.
    air_density
        ϱ, kg/m³.
    drag_coefficient, lift_coefficient
        C_d and C_m.
    smoothing_speed
        v_s, m/s.
    """

    gravity: sp.Expr
    ball_radius: sp.Expr
    ball_mass: sp.Expr
    air_density: sp.Expr
    drag_coefficient: sp.Expr
    lift_coefficient: sp.Expr
    smoothing_speed: sp.Expr

    @cached_property
    def _half_column(self) -> sp.Expr:
        """ϱ A / 2m, 1/m."""
        area = barrier(PI * barrier(self.ball_radius**2))
        return barrier(barrier(self.air_density * area) / barrier(2 * self.ball_mass))

    @cached_property
    def drag(self) -> sp.Expr:
        """k_d, 1/m."""
        return barrier(self.drag_coefficient * self._half_column, "k_d")

    @cached_property
    def rotation(self) -> sp.Matrix:
        """Ω, 1/s."""
        lift = barrier(barrier(self.ball_radius * self._half_column) * self.lift_coefficient)
        return barrier_all(lift * spin, [rf"\Omega_{axis}" for axis in "xyz"])

    @cached_property
    def buoyancy(self) -> sp.Expr:
        """Share of the weight that the air carries."""
        return barrier(barrier(self._half_column * self.ball_radius) * sp.Rational(8, 3))

    @cached_property
    def fall(self) -> sp.Expr:
        """g_e, m/s²."""
        return barrier(self.gravity * barrier(1 - self.buoyancy), "g_e")


def _norm(vector: sp.Matrix) -> sp.Expr:
    """Return the sum of the sizes of the components."""
    return barrier(sum(map(absolute, vector)))


def _suffix_sums(sizes: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Return the sums of all sizes from each one on."""
    found = [sizes[-1]]
    for size in reversed(sizes[:-1]):
        found.append(barrier(size + found[-1]))
    return found[::-1]


def _sum(terms: Sequence[sp.Expr]) -> sp.Expr:
    return barrier(sp.Add(*terms))


@dataclass(frozen=True)
class AirSeries:
    """The series of a flight through air from a state on.

    Attributes
    ----------
    constants
        What the motion depends on.
    order
        P, the degree of the velocity.
    """

    constants: AirConstants
    order: int = ORDER

    @cached_property
    def coefficients(self) -> tuple[list[sp.Matrix], list[sp.Expr]]:
        """V_0 to V_P and σ_0 to σ_P."""
        of, moved, sizes = self.constants, [velocity], list[sp.Expr]()
        twice: sp.Expr = sp.Integer(0)
        for k in range(self.order + 1):
            square = barrier(self._convolved(moved, k) + self._smoothing(k))
            if k == 0:
                sizes.append(barrier(sp.sqrt(square), r"\sigma_0"))
                twice = barrier(1 / barrier(2 * sizes[0]))
            else:
                inner = [barrier(2 * sizes[i] * sizes[k - i]) for i in range(1, (k + 1) // 2)]
                middle = [barrier(sizes[k // 2] ** 2)] if k % 2 == 0 else []
                rest = barrier(square - _sum([*inner, *middle])) if inner or middle else square
                sizes.append(barrier(rest * twice, rf"\sigma_{{{k}}}"))
            if k < self.order:
                moved.append(self._next(moved, sizes, k, of))
        return moved, sizes

    def _smoothing(self, k: int) -> sp.Expr:
        return barrier(self.constants.smoothing_speed**2) if k == 0 else sp.Integer(0)

    @staticmethod
    def _convolved(moved: Sequence[sp.Matrix], k: int) -> sp.Expr:
        """Return the k-th coefficient of v·v; of equal products it computes one."""
        pairs = [barrier(2 * barrier(moved[i].dot(moved[k - i]))) for i in range((k + 1) // 2)]
        middle = [barrier(moved[k // 2].dot(moved[k // 2]))] if k % 2 == 0 else []
        return _sum([*pairs, *middle])

    @staticmethod
    def _next(
        moved: Sequence[sp.Matrix], sizes: Sequence[sp.Expr], k: int, of: AirConstants
    ) -> sp.Matrix:
        """Return V_{k+1}."""
        turned = of.rotation.cross(moved[k])
        found = []
        for axis in range(3):
            braked = _sum([barrier(sizes[i] * moved[k - i][axis]) for i in range(k + 1)])
            force = barrier(barrier(turned[axis]) - barrier(of.drag * braked))
            if k == 0 and axis == 2:
                force = barrier(force - of.fall)
            found.append(barrier(force / (k + 1), rf"V_{{{k + 1}{'xyz'[axis]}}}"))
        return sp.Matrix(found)

    @cached_property
    def step(self) -> sp.Expr:
        """The longest step that the series is good for, s, a multiple of 2^-26 s."""
        moved, sizes = self.coefficients
        radius = barrier(sizes[0] / self.constants.fall)
        longest: sp.Expr = LONGEST**16
        for k in (self.order - 1, self.order):
            size = _norm(moved[k])
            reach = barrier(TOLERANCE * barrier(radius ** (self.order + 1 - k)))
            longest = minimum(longest, IfLess(0, size, barrier(reach / size), sp.oo))
        for _ in range(4):
            longest = barrier(sp.sqrt(longest))
        return barrier(barrier(SAFETY * longest + STEP_GRAIN) - STEP_GRAIN)

    def at(self, time: sp.Expr) -> tuple[sp.Matrix, sp.Matrix]:
        """Return position and velocity on the series, `time` after the state, in Horner form."""
        moved, _ = self.coefficients
        rows = [[v[axis] for v in moved] for axis in range(3)]
        places = [
            start + barrier(time * horner([v / (k + 1) for k, v in enumerate(row)], time))
            for start, row in zip(position, rows, strict=True)
        ]
        return sp.Matrix(places), sp.Matrix([horner(row, time) for row in rows])

    def errors(
        self, time: sp.Expr, position_error: sp.Expr, velocity_error: sp.Expr
    ) -> tuple[sp.Expr, sp.Expr]:
        """Return bounds on the errors of `at`, infinite where none is proved.

        They bound the Euclidean norms of the errors of position and velocity, m and m/s, with all
        roundings, given such bounds at the start.
        """
        moved, sizes = self.coefficients
        of, last = self.constants, self.order
        powers = [sp.Integer(1)]
        for _ in range(last):
            powers.append(barrier(powers[-1] * time))
        a = [barrier(_norm(v) * power) for v, power in zip(moved, powers, strict=True)]
        b = [barrier(absolute(s) * power) for s, power in zip(sizes, powers, strict=True)]
        sums_a, sums_b = _suffix_sums(a), _suffix_sums(b)
        rounded = COEFFICIENT_ROUNDINGS * UNIT_ROUNDOFF
        square = _sum(
            [
                barrier(barrier(a[k] * sums_a[last + 1 - k]) + barrier(b[k] * sums_b[last + 1 - k]))
                for k in range(1, last + 1)
            ]
        )
        squares = barrier(
            barrier(sums_a[0] ** 2) + barrier(sums_b[0] ** 2) + barrier(of.smoothing_speed**2)
        )
        least = barrier(barrier((1 - CANCELLATION) * b[0]) - sums_b[1])
        off = barrier(barrier(square + barrier(rounded * squares)) / least)
        turning = _norm(of.rotation)
        left_out = _sum([barrier(b[k] * sums_a[last - k]) for k in range(last + 1)])
        dragged = barrier(of.drag * barrier(left_out + barrier(off * sums_a[0])))
        largest_drag = barrier(of.drag * barrier(sums_b[0] * sums_a[0]))
        weight = barrier(of.gravity * barrier(1 + of.buoyancy))
        terms = barrier(barrier(largest_drag + barrier(turning * sums_a[0])) + weight)
        defect = barrier(
            barrier(dragged + barrier(turning * a[last])) + barrier(rounded * terms) + UNDERFLOW
        )
        widest = barrier(barrier(sums_b[0] + off) + TUBE)
        growth = barrier(time * barrier(barrier(2 * of.drag * widest) + turning))
        room = barrier((1 - CANCELLATION) - growth)
        exact = barrier(ROUNDING_SLACK * barrier(velocity_error + barrier(defect * time)) / room)
        proved = all_of(Less(0, least), Less(0, room), Less(exact, TUBE))
        carried = barrier(position_error + barrier(time * exact))
        path = barrier(8 * barrier(time * sums_a[0]) + _norm(position))
        rolled = barrier(barrier(2 * _sum(sums_a)) + sums_a[0])
        place_error = barrier(ROUNDING_SLACK * barrier(carried + UNIT_ROUNDOFF * path))
        speed_error = barrier(exact + UNIT_ROUNDOFF * rolled)
        return (
            barrier(Choose(proved, place_error, sp.oo)),
            barrier(Choose(proved, speed_error, sp.oo)),
        )
