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
from typing import Any

from flint import arb, arb_poly

from .air import OVERLAP, proved_piece
from .formulas import Formulas, SurfaceFormulas
from .roots import sign
from .taylor_model import Number, TaylorModel, as_model, ball

_PARTS = 8
"""Parts of a piece whose boxes are compared with a surface before its polynomial is."""


@dataclass(frozen=True)
class Piece:
    """A flight from a state on, or a piece of it.

    Attributes
    ----------
    start
        The state, nine balls or models.
    path
        The polynomials of the position, of balls or of models.
    span
        How long they hold, s; infinite if the flight is one parabola.
    """

    start: Sequence[Number]
    path: list[Any]
    span: arb

    @property
    def exact(self) -> bool:
        """True if the flight is a parabola."""
        return not self.span.is_finite()

    @cached_property
    def in_balls(self) -> Piece:
        """The piece in plain balls."""
        if not self.has_models:
            return self
        start, path = ([ball(one) for one in own] for own in (self.start, self.path))
        return Piece(start, path, self.span)

    @property
    def has_models(self) -> bool:
        """True if the path depends on the release through models."""
        return any(isinstance(coordinate, TaylorModel) for coordinate in self.path)

    def at(self, time: Number) -> list[Any]:
        """Return the state after a time, nine balls or models."""
        moving = (coordinate.derivative() for coordinate in self.path)
        there: list[Any] = [*self.path, *moving]
        if isinstance(time, TaylorModel):
            there = [as_model(polynomial) for polynomial in there]
        return [polynomial(time) for polynomial in there] + list(self.start[6:])

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


def next_piece(formulas: Formulas, state: Sequence[Number], values: list[arb]) -> Piece:
    """Return the piece of a flight that begins with a state.

    Parameters
    ----------
    formulas, state, values
        As for `hoopgen.judge.start.left_by`.

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


def meets_nothing(formulas: Formulas, state: Sequence[Number], values: list[arb]) -> bool | None:
    """Return whether a ball that flies through air sinks, and meets nothing again.

    None if that is undecided; False without air.

    Parameters
    ----------
    formulas, state, values
        As for `hoopgen.judge.start.left_by`.
    """
    air = formulas.air
    if air is None:
        return False
    certain, impossible = air.sinks(state, air.rates(state, values), values)
    return True if certain else False if impossible else None
