"""What a contact law is: from the motion before a contact to the motion after it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar

import sympy as sp


@dataclass(frozen=True)
class Law(ABC):
    """A contact law.

    Attributes
    ----------
    name
        Names its kernels; bodies that share a law share them.
    source, called
        The equations, or the laws, that it is made from, and what it is called beside its errors.
    """

    name: str

    source: ClassVar[str] = "Eqs. 11-17, the frame eliminated"
    called: ClassVar[str] = "the frame-free Eq. 17"

    @abstractmethod
    def restitution_at(self, speed: sp.Expr) -> sp.Expr:
        """Return e of a contact that is arrived at with a normal speed, positive: v_n+ = -e v_n.

        What `after` does along the normal, said apart: the judge keeps it exact on planes. It may
        fall with the speed.
        """

    @property
    def coefficient(self) -> sp.Expr:
        """Coulomb's mu; infinite: every contact grips."""
        return sp.oo

    @abstractmethod
    def after(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball_radius: sp.Expr
    ) -> tuple[sp.Matrix, sp.Matrix]:
        """Return velocity and spin after a contact, frame-free."""

    def doubt(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball_radius: sp.Expr
    ) -> sp.Basic | None:
        """Return where a decision within the contact lies within its error; None if it has none."""
        return None
