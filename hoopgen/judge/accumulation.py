"""Detection of accumulating bounces, after which a ball rolls.

Bounces on a surface become ever smaller, and infinitely many of them take a finite time (a Zeno
accumulation). The engines then let the ball roll (`derive/rolling/settling.py`). The judge proves
impacts alone: it stops where hops have been too small for the engines to tell apart for long.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb

from .expressions import Function
from .formulas import SurfaceFormulas

MIN_SMALL_HOPS = 32
"""Small hops in a row with which bounces accumulate. Where a ball leaves a surface that curves away
under it, after fewer, or takes off from one that turns, the judge goes on."""


@dataclass
class Hops:
    """The latest successive small impacts on one surface.

    Attributes
    ----------
    small
        Two numbers of a state after an impact, the parameters and the normal; the first is less
        where the hop is small.
    face
        That surface of the scene, -1 for none.
    certain, possible
        How many of them have certainly been small, and how many may have been.
    """

    small: Function
    face: int = -1
    certain: int = 0
    possible: int = 0

    def add(
        self,
        surface: SurfaceFormulas,
        restitution: arb,
        after: Sequence[arb],
        values: Sequence[arb],
    ) -> None:
        """Add an impact: its surface and restitution, and the state after it.

        Parameters
        ----------
        surface
            The surface of the impact.
        restitution
            The restitution of the impact.
        after
            The state after it, nine balls.
        values
            The kernels' inputs.
        """
        if surface.face != self.face or not surface.allows_rolling:
            self.face, self.certain, self.possible = surface.face, 0, 0
        if not surface.allows_rolling:
            return
        hop, limit = self.small(after, values, surface.normal(after, values))
        # Without a loss bounces do not accumulate, however small they are.
        loses = bool(restitution < 1)
        self.certain = self.certain + 1 if loses and hop < limit else 0
        self.possible = self.possible + 1 if not (restitution >= 1 or hop >= limit) else 0

    def begin(self, impacts: int, last: bool) -> int:
        """Return the index of the first small hop if the bounces accumulate, else -1.

        Parameters
        ----------
        impacts
            The number of impacts so far.
        last
            True for the last impact, after which a shot is given up: one small hop is enough.
        """
        accumulate = self.certain >= MIN_SMALL_HOPS or (last and self.possible)
        return impacts - self.possible if accumulate else -1
