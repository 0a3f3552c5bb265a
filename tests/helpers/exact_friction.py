"""Exact contacts with Coulomb friction, in balls of as many bits as the context of flint has.

Vectors are arrays (3, n) of such numbers. The law is that of `derive/contact/friction.py`.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.helpers.exact_contacts import EXACT, ROOT, Exact, cross, dot

BELOW_ZERO = np.vectorize(lambda ball: bool(ball < 0), otypes=[bool])
"""Function: true for numbers that are certainly below zero."""

NAMES = ("restitution", "friction", "tangential", "falling", "inertia", "ball_radius")


@dataclass(frozen=True)
class Contact:
    """Contacts before their impulse.

    Attributes
    ----------
    n, v, w
        Normals, velocities and spins.
    law
        The law's parameters by name, in doubles, and the radius of the ball.
    """

    n: Exact
    v: Exact
    w: Exact
    law: dict[str, Any]

    def _parameter(self, name: str) -> Exact:
        rows = self.n.shape[1]
        value = np.broadcast_to(np.asarray(self.law[name], float), rows)
        return EXACT(np.where(np.isfinite(value), value, 0))

    def _is_infinite(self, name: str) -> NDArray[np.bool_]:
        return np.broadcast_to(np.isinf(self.law[name]), self.n.shape[1])

    @cached_property
    def onto(self) -> Exact:
        """The velocity along the normal."""
        return dot(self.v, self.n)

    @cached_property
    def slip(self) -> Exact:
        """The slip u."""
        spun = cross(self.w, self.n) * self._parameter("ball_radius")
        return self.v - self.n * self.onto - spun

    @cached_property
    def speed(self) -> Exact:
        """The size of the slip."""
        return ROOT(dot(self.slip, self.slip))

    @cached_property
    def grip(self) -> Exact:
        """G, the share of the slip that a contact which grips takes."""
        inertia = self._parameter("inertia")
        return inertia * (1 + self._parameter("tangential")) / (1 + inertia)

    @cached_property
    def restitution(self) -> Exact:
        """The restitution at the speed towards the surface."""
        falling = self._is_infinite("falling")
        relative = np.where(falling, 0 * self.onto, self.onto)
        relative = relative / np.where(falling, EXACT(1.0), self._parameter("falling"))
        return self._parameter("restitution") / (1 - relative)

    @cached_property
    def slide(self) -> Exact:
        """S, mu times the normal impulse; zero for an infinite mu."""
        return -self._parameter("friction") * (1 + self.restitution) * self.onto

    @cached_property
    def margin(self) -> Exact:
        """S - G |u|; 1 where mu is infinite or zero."""
        one = 1 + 0 * self.onto
        return np.where(self.decided, one, self.slide - self.grip * self.speed)

    @property
    def decided(self) -> NDArray[np.bool_]:
        """True where mu is zero or infinite: nothing is decided."""
        none = np.broadcast_to(np.asarray(self.law["friction"]) == 0, self.n.shape[1])
        return np.asarray(none | self._is_infinite("friction"))

    @cached_property
    def slips(self) -> NDArray[np.bool_]:
        """True where contacts slip to their end."""
        return np.asarray(BELOW_ZERO(self.margin))

    @cached_property
    def share(self) -> Exact:
        """The share of the slip that friction takes."""
        one = 1 + 0 * self.onto
        sliding = self.slide / np.where(self.slips, self.speed, one)
        none = np.broadcast_to(np.asarray(self.law["friction"]) == 0, self.n.shape[1])
        return np.where(none, 0 * one, np.where(self.slips, sliding, self.grip))

    def after(self) -> tuple[Exact, Exact]:
        """Return velocity and spin after the contacts."""
        impulse = self.slip * self.share
        per = 1 / (self._parameter("inertia") * self._parameter("ball_radius"))
        rebound = self.n * (self.onto * (1 + self.restitution))
        return self.v - impulse - rebound, self.w + cross(self.n, impulse) * per
