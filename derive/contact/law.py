"""The interface of a contact law: from the motion before a contact to the motion after it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from .ball import Ball


@dataclass(frozen=True)
class Law(ABC):
    """A contact law.

    Attributes
    ----------
    name
        The name of its kernels; bodies with equal laws share them.
    source, description
        The equations or laws that it follows from, and its name in texts about its errors.
    """

    name: str

    source: ClassVar[str] = "Eqs. 11-17, the frame eliminated"
    description: ClassVar[str] = "the frame-free Eq. 17"

    @abstractmethod
    def restitution_at(self, speed: sp.Expr) -> sp.Expr:
        """Return e of a contact with a positive normal speed of approach: v_n+ = -e v_n.

        It states separately what `after` does along the normal, since the judge keeps that exact on
        planes. It may fall with the speed.
        """

    @property
    def friction_coefficient(self) -> sp.Expr:
        """Coulomb's mu; infinite: every contact grips."""
        return sp.oo

    @abstractmethod
    def after(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball: Ball
    ) -> tuple[sp.Matrix, sp.Matrix]:
        """Return velocity and spin after a contact, frame-free.

        Parameters
        ----------
        normal
            The outward unit normal at the contact, (3,).
        velocity, spin
            The velocity of the ball's centre and its angular velocity before the contact, (3,)
            each.
        ball
            The radius and the inertia of the ball.
        """

    def undecided(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball: Ball
    ) -> sp.Basic | None:
        """Return the condition that a decision in the contact is undecided; None: no decision.

        Parameters
        ----------
        normal, velocity, spin, ball
            As for `after`.
        """
        return None

    def grip_margin(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball: Ball
    ) -> sp.Expr | None:
        """Return by how much a contact grips, m/s; negative: it slips; None: it always does one.

        Parameters
        ----------
        normal, velocity, spin, ball
            As for `after`.
        """
        return None
