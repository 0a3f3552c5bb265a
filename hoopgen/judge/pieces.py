"""Pieces of a flight, on which polynomials with balls hold the ball's position.

At every time of a piece the position and the velocity are those of some polynomial in the balls of
the coefficients, with the same constant term, but perhaps of another one at another time. So where
none of the polynomials has a root, the flight has none, and all of the flight's roots are between
the first and the last of theirs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from flint import arb, arb_poly

from .air import OVERLAP, proved_piece
from .formulas import Formulas, SurfaceFormulas
from .roots import sign

_PARTS = 8
"""Parts of a piece whose boxes are compared with a surface before its polynomial is."""


@dataclass(frozen=True)
class Piece:
    """A flight from a state on, or a piece of it.

    Attributes
    ----------
    start
        The state, nine balls.
    path
        The polynomials of the position.
    span
        How long they hold, s; infinite if the flight is one parabola.
    """

    start: Sequence[arb]
    path: list[arb_poly]
    span: arb

    @property
    def exact(self) -> bool:
        """True if the flight is a parabola."""
        return not self.span.is_finite()

    def at(self, time: arb) -> list[arb]:
        """Return the state after a time, nine balls."""
        moving = (coordinate.derivative() for coordinate in self.path)
        return [polynomial(time) for polynomial in (*self.path, *moving)] + list(self.start[6:])

    @cached_property
    def boxes(self) -> list[list[arb]]:
        """Boxes that hold the position in parts of the piece."""
        width = self.span * (1 + OVERLAP) / (2 * _PARTS)
        times = [width * (2 * k + 1) + arb(0, width.upper()) for k in range(_PARTS)]
        return [[coordinate(time) for coordinate in self.path] for time in times]

    def is_aside(self, surface: SurfaceFormulas, values: list[arb]) -> bool:
        """Return True if the ball certainly stays on one side of a surface throughout the piece.

        Parameters
        ----------
        surface
            The surface.
        values
            The kernels' inputs.
        """
        if self.exact:
            return False
        sides = {sign(surface.condition(box, values)[0]) for box in self.boxes}
        return len(sides) == 1 and not sides & {None, 0}


def next_piece(formulas: Formulas, state: Sequence[arb], values: list[arb]) -> Piece:
    """Return the piece of a flight that begins with a state.

    Parameters
    ----------
    formulas
        The formulas of the scene.
    state
        The state, nine balls.
    values
        The kernels' inputs.

    Raises
    ------
    Undecided
        If the ball flies through air, and the state is known too little.
    """
    if formulas.air is not None:
        return Piece(state, *proved_piece(formulas.air, state, values))
    assert formulas.flight is not None
    path = formulas.flight(state, values, (arb_poly([0, 1]),))[:3]
    return Piece(state, path, arb.pos_inf())


def meets_nothing(formulas: Formulas, state: Sequence[arb], values: list[arb]) -> bool:
    """Return True if the ball flies through air and certainly meets nothing again.

    Parameters
    ----------
    formulas
        The formulas of the scene.
    state
        The state, nine balls.
    values
        The kernels' inputs.
    """
    air = formulas.air
    return air is not None and bool(air.sinks(state, air.rates(state, values), values)[0])
