"""The search for any surface with a polynomial condition: bounds from Bernstein coefficients."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.choice import largest
from ..ground.polynomials import Coefficients, bernstein, derivative, horner, taylor
from ..ground.rounding import SAFETY, Rounded, rounding, start_rounding
from ..ground.symbols import POSITION, VELOCITY, t
from ..surfaces import Surface
from .approach import Approach
from .events import Window, ceiling, event_coefficients, horizon, time_rounding


@dataclass(frozen=True)
class PolynomialApproach(Approach):
    """The search for any surface with a polynomial condition: M from Bernstein coefficients."""

    surface: Surface

    @property
    def _coefficients(self) -> Coefficients:
        return event_coefficients(self.surface, self.flight)

    def _along(self, expression: sp.Expr) -> sp.Expr:
        there = [component for vector in self.flight.named() for component in vector]
        moved = dict(zip((*POSITION, *VELOCITY), there, strict=True))
        return expression.subs(moved, simultaneous=True)

    @property
    def constants(self) -> dict[str, sp.Expr]:
        """None."""
        return {}

    @property
    def windows(self) -> list[Window]:
        """Up to Cauchy's bound on the roots."""
        *rest, leading = self._coefficients
        return [(sp.Integer(0), 1 + sum(sp.Abs(c) for c in rest) / sp.Abs(leading))]

    @property
    def gap(self) -> sp.Expr:
        """The condition at the position at time t, which loses less than its coefficients do."""
        return self._along(self.surface.condition)

    @property
    def leaving_gap(self) -> sp.Expr:
        """The deflated polynomial, times t."""
        return t * horner(self._coefficients[1:], t)

    @property
    def rate(self) -> sp.Expr:
        """Gradient times velocity."""
        gradient = [sp.diff(self.surface.condition, coordinate) for coordinate in POSITION]
        return self._along(sum(g * v for g, v in zip(gradient, VELOCITY, strict=True)))

    @property
    def bend(self) -> sp.Expr:
        """The polynomial's second derivative."""
        return horner(derivative(derivative(self._coefficients)), t)

    def curvature(self, width: sp.Expr) -> sp.Expr:
        """The largest Bernstein coefficient of -F'' on the window, rounding included."""
        second = derivative(derivative(self._coefficients))
        upper = largest(*(-c for c in bernstein(taylor(second, t), width)))
        return upper + sp.Rational(1, 2**40) * ceiling

    @property
    def ceiling(self) -> sp.Expr:
        """|F''| with every term taken positive, up to the horizon."""
        second = derivative(derivative(self._coefficients))
        return horner([rounding(c, start_rounding()).magnitude for c in second], horizon)

    @property
    def margins(self) -> dict[str, sp.Expr]:
        """By running error analysis of the gap, the deflated polynomial and the rate."""
        there, moved = self.flight.rounding(horizon)
        moving = dict.fromkeys(POSITION, there) | dict.fromkeys(VELOCITY, moved)
        start = start_rounding()
        start[t] = Rounded(horizon)
        condition = self.surface.condition
        gradient = [sp.diff(condition, coordinate) for coordinate in POSITION]
        gap = rounding(condition, moving)
        deflated = rounding(horner(self._coefficients[1:], t), start)
        rate = rounding(sum(g * v for g, v in zip(gradient, VELOCITY, strict=True)), moving)
        return {
            "margin": SAFETY * (gap.error + time_rounding(rate) * horizon),
            "leaving_margin": SAFETY * (deflated.error + time_rounding(rate)),
            "rate_margin": SAFETY * rate.error,
        }
