"""The pieces of a scene as its author writes it: parameters, bodies, ends.

Plain data. A size is a number, the name of a parameter, or a small formula of them
(`formula_parser`). Sizes are those of the body itself: the derivation adds the ball's radius.
"""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import KW_ONLY, dataclass
from typing import Protocol

__all__ = [
    "Body",
    "Box",
    "Cylinder",
    "End",
    "Parameter",
    "Plane",
    "Sphere",
    "Surface",
    "Torus",
]


class Expression(Protocol):
    """An expression of SymPy, which need not be installed."""

    @property
    def args(self) -> tuple[object, ...]:
        """Its parts."""

    @property
    def free_symbols(self) -> AbstractSet[object]:
        """The symbols in it."""


Size = float | str | Expression
"""A number, a formula as text, or an expression of SymPy."""

Point = tuple[Size, Size, Size]


@dataclass(frozen=True)
class Parameter:
    """A number of the scene; each shot may have its own value.

    Attributes
    ----------
    name
        A small letter, then small letters, digits and ``_``, 100 at most; not ``x``, ``y`` or
        ``z``, nor the name of a result, such as ``time``.
    default
        Its value where none is given.
    unit
        As text; lengths are in "m".
    summary
        What it is, in a few words.
    sign
        Which values are allowed: "positive", "nonnegative" or "any".
    upper
        The largest value allowed, if there is one.
    latex
        How formulas on the derivation's page write it; "": its name.
    infinite
        Whether it may be infinite: a friction, or the speed of a restitution.
    """

    name: str
    default: float
    unit: str = "m"
    summary: str = ""
    sign: str = "positive"
    upper: float | None = None
    latex: str = ""
    infinite: bool = False


@dataclass(frozen=True)
class Body:
    """A body that the ball can touch; it has one column of results.

    Attributes
    ----------
    name
        As that of a parameter; ``end``, ``none``, ``release``, ``own`` and ``error`` are taken.
    restitution
        Of its contacts, 0 to 1; None: that of the scene.
    friction
        Coulomb's coefficient, 0 to infinite, at which every contact grips; None: that of the scene.
    tangential
        What a contact that grips leaves of the slip, turned about, -1 to 1; None: the scene's.
    restitution_speed
        The normal speed at which the restitution is half of what it is without speed; infinite: it
        is the same at any. None: that of the scene.
    within
        Formulas in x, y and z, of a point of the body: it is there where all are at most 0. Each is
        flat, such as ``"x - half_width"``, or, on a plane, round: ``"x**2 + y**2 - r**2"``.
    """

    name: str
    _: KW_ONLY
    restitution: Size | None = None
    friction: Size | None = None
    tangential: Size | None = None
    restitution_speed: Size | None = None
    within: Sequence[Size] = ()


@dataclass(frozen=True)
class Plane(Body):
    """A flat body, touched from the side to which its axis points.

    Attributes
    ----------
    axis
        Its normal: "x", "y", "z", or one of them with a minus.
    at
        The coordinate of the plane along that axis: with "-z", at 2 is at z = -2.
    """

    _: KW_ONLY
    axis: str = "z"
    at: Size = 0.0


@dataclass(frozen=True)
class Sphere(Body):
    """A sphere, touched from outside or, as a bowl, from inside.

    From inside, one with bounds is a thin shell; else no ball is outside of it.
    """

    _: KW_ONLY
    radius: Size
    centre: Point = (0.0, 0.0, 0.0)
    inside: bool = False


@dataclass(frozen=True)
class Cylinder(Body):
    """The curved side of a round cylinder; its ends are open.

    Attributes
    ----------
    radius, centre, axis
        Its radius, a point of its axis, and "x", "y" or "z".
    span
        From where to where it goes along its axis, in coordinates; None: without end.
    inside
        Whether it is touched from inside, as a pipe; with ends or bounds it is a thin shell.
    """

    _: KW_ONLY
    radius: Size
    centre: Point = (0.0, 0.0, 0.0)
    axis: str = "z"
    span: tuple[Size | None, Size | None] = (None, None)
    inside: bool = False


@dataclass(frozen=True)
class Torus(Body):
    """A ring, touched from outside: the wire circle's radius, and the wire's own.

    A wire of radius 0 is an edge, such as that of a hole.
    """

    _: KW_ONLY
    radius: Size
    wire: Size = 0.0
    centre: Point = (0.0, 0.0, 0.0)
    axis: str = "z"


@dataclass(frozen=True)
class Box(Body):
    """A box along the axes, touched from outside: faces, edges and corners.

    Attributes
    ----------
    size
        Its three lengths.
    centre
        The middle of it.
    """

    _: KW_ONLY
    size: Point
    centre: Point = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Surface(Body):
    """A surface at the zero of a polynomial.

    Attributes
    ----------
    condition
        A polynomial in x, y and z of the *ball's centre*: positive where the ball is free, zero
        where it touches. Its gradient must not vanish there.
    """

    _: KW_ONLY
    condition: Size


@dataclass(frozen=True)
class End:
    """A plane on which a shot ends, crossed by the ball's centre against its axis.

    Attributes
    ----------
    axis, at
        As those of a `Plane`.
    within
        Formulas in x, y and z of the ball's centre: it ends there where all are at most 0.
    """

    axis: str = "z"
    at: Size = 0.0
    within: Sequence[Size] = ()
