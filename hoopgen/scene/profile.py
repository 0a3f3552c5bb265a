"""The profile of a surface of revolution as formulas: its points, straight pieces and arcs."""

from __future__ import annotations

from dataclasses import dataclass

from .directions import Vector
from .formulas import Formula

Sizes = tuple[tuple[str, Formula], ...]

Way = tuple[Formula, Formula]
"""A unit vector in the half-plane: along radii, and along heights."""


@dataclass(frozen=True)
class Vertex:
    """A point of a profile.

    Attributes
    ----------
    radius, height
        Its place: inputs.
    place
        The point of the axis at its height: inputs.
    narrow
        Whether the ball does not fit through its circle at the defaults.
    smooth
        Whether an arc continues its neighbour there without a corner.
    """

    radius: Formula
    height: Formula
    place: Vector
    narrow: bool
    smooth: bool


@dataclass(frozen=True)
class Line:
    """A straight piece of a profile.

    Attributes
    ----------
    start, end
        The numbers of its points.
    kind
        "cone", "cylinder" or "disc".
    ways
        Its unit vector (c, s), twice: inputs.
    signs
        The signs of c and s at the defaults, 0 where one is 0 itself.
    sizes
        What its faces need: inputs by argument.
    inner
        Whether the ball fits inside of it, at the defaults, so far that it touches it there.
    """

    start: int
    end: int
    kind: str
    ways: tuple[Way, Way]
    signs: tuple[int, int]
    sizes: Sizes
    inner: bool


@dataclass(frozen=True)
class Arc:
    """A circular arc of a profile.

    Attributes
    ----------
    start, end, sizes
        As for `Line`.
    kind
        "sphere" if its centre is on the axis, else "torus".
    ways
        The unit vectors along it at its start and at its end: inputs.
    middle
        Radius and height of the point through which it runs, formulas of the parameters.
    offset_sign
        The sign of the radius of its centre at the defaults, 0 on the axis.
    turn
        1 if it turns to the left, from radii to heights, -1 if to the right.
    long
        Whether it is longer than half a circle.
    hollow
        Whether the ball fits into it, at the defaults, so that it touches its hollow side.
    across
        Whether the circle of the ball's centre may cross the axis, on its round side and on its
        hollow one.
    inner
        Whether the ball touches the side of it that faces the axis.
    """

    start: int
    end: int
    kind: str
    ways: tuple[Way, Way]
    sizes: Sizes
    middle: Way
    offset_sign: int
    turn: int
    long: bool
    hollow: bool
    across: tuple[bool, bool]
    inner: bool


@dataclass(frozen=True)
class Profile:
    """The line that is turned about the axis.

    Attributes
    ----------
    vertices, lines
        Its points and pieces in order; a line that ends where it begins names that point once.
    fixed
        Whether all of it is numbers, so that nothing changes from shot to shot.
    """

    vertices: tuple[Vertex, ...]
    lines: tuple[Line | Arc, ...]
    fixed: bool
