"""The ball: a homogeneous body with the radius R_B and the moment of inertia kappa m R_B²."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import barrier

THIN_SHELL = sp.Rational(2, 3)
"""kappa of a thin shell, the article's ball."""

MIN_INERTIA, MAX_INERTIA = sp.Rational(1, 64), sp.Integer(1)
"""The allowed range of kappa. No ball has more than 1, with all mass at the distance R_B from its
axis; without inertia there is no friction to roll by."""


@dataclass(frozen=True)
class Ball:
    """A ball.

    Attributes
    ----------
    radius
        R_B.
    inertia
        kappa = I / (m R_B²), with I for the moment of inertia about the centre.
    """

    radius: sp.Expr
    inertia: sp.Expr = THIN_SHELL

    @property
    def moving_share(self) -> sp.Expr:
        """The share of a force along the surface that accelerates a rolling ball: 1/(1 + kappa)."""
        return barrier(1 / barrier(1 + self.inertia))

    @property
    def friction_share(self) -> sp.Expr:
        """The share of that force that friction takes, and of a slip that a grip takes.

        It is kappa/(1 + kappa), 2/5 for a thin shell.
        """
        return barrier(self.inertia * self.moving_share)
