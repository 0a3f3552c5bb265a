"""The pieces of a scene as its author writes it: parameters, bodies, ends.

Plain data. A size is a number, the name of a parameter, or a small formula of them
(`formula_parser`). Sizes are those of the body itself: the derivation adds the ball's radius.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import KW_ONLY, dataclass
from typing import Protocol


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

Direction = Point | Mapping[str, str]
"""A vector of any length but 0, or ``{"tilt": "12deg", "towards": "30deg"}``.

`tilt` is the angle from the z axis, and `towards`, 0deg if it is left out, the direction on the
floor plan to which the vector leans, from x towards y.
"""


Orientation = tuple[Size, Size, Size, Size] | Mapping[str, object]
"""A rotation: a quaternion w, x, y, z of any length but 0, or a mapping.

``{"axis": "z", "angle": "30deg"}`` turns by an angle about an axis, counterclockwise as seen from
where it points; the axis may be any direction. ``{"yaw": "30deg", "pitch": "10deg", "roll":
"5deg"}`` turns by `yaw` about the z axis, then by `pitch` about the y axis of what is turned, then
by `roll` about its x axis; what is left out is 0deg.
"""


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
        Polynomials in x, y and z, of a point of the body: it is there where all are at most 0. Such
        as ``"x - half_width"`` or ``"x**2 + y**2 - r**2"``.
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
        Its normal: "x", "y", "z", or one of them with a minus; "z" without a `normal`.
    at
        The coordinate of the plane along its normal, 0 if neither this nor a point is given: with
        "-z", at 2 is at z = -2.
    normal
        In place of `axis`: a normal in any direction. Its length does not matter.
    point
        In place of `at`: a point of the plane.
    """

    _: KW_ONLY
    axis: str | None = None
    at: Size | None = None
    normal: Direction | None = None
    point: Point | None = None


@dataclass(frozen=True)
class Disc(Body):
    """A flat round plate, touched from the side to which its axis points.

    The ball touches it only if the point of contact is within the circle. It does not touch the
    rim: a `Torus` without a wire radius is such an edge.

    Attributes
    ----------
    radius, centre
        Those of its circle.
    axis
        Its normal: "x", "y", "z", one of them with a minus, or any direction.
    """

    _: KW_ONLY
    radius: Size
    centre: Point = (0.0, 0.0, 0.0)
    axis: str | Direction = "z"


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
        Its radius, a point of its axis, and "x", "y", "z" or any direction.
    span
        From where to where it goes along its axis: in coordinates along "x", "y" or "z", and from
        its centre along a direction. None: without end.
    inside
        Whether it is touched from inside, as a pipe; with ends or bounds it is a thin shell.
    """

    _: KW_ONLY
    radius: Size
    centre: Point = (0.0, 0.0, 0.0)
    axis: str | Direction = "z"
    span: tuple[Size | None, Size | None] = (None, None)
    inside: bool = False


@dataclass(frozen=True)
class Cone(Body):
    """The curved side of a round cone; its base is open.

    From outside the ball touches its apex, too, if the cone begins there.

    Attributes
    ----------
    apex
        Its apex.
    axis
        From the apex into the cone: "x", "y", "z", one of them with a minus, or any direction.
    half_angle
        The angle between its axis and its side, above 0deg and below 90deg, such as "30deg".
    slope
        In place of `half_angle` its tangent: the radius by the distance from the apex.
    span
        From where to where it goes along its axis, from the apex; None: from the apex, and without
        end.
    inside
        Whether it is touched from inside, as a funnel; with ends it is a thin shell.
    """

    _: KW_ONLY
    apex: Point = (0.0, 0.0, 0.0)
    axis: str | Direction = "z"
    half_angle: str | None = None
    slope: Size | None = None
    span: tuple[Size | None, Size | None] = (None, None)
    inside: bool = False


@dataclass(frozen=True)
class Torus(Body):
    """A ring, touched from outside: the wire circle's radius, and the wire's own.

    A wire of radius 0 is an edge, such as that of a hole. Its axis is "x", "y", "z", one of them
    with a minus, or any direction.
    """

    _: KW_ONLY
    radius: Size
    wire: Size = 0.0
    centre: Point = (0.0, 0.0, 0.0)
    axis: str | Direction = "z"


@dataclass(frozen=True)
class Box(Body):
    """A box, touched from outside: faces, edges and corners.

    Attributes
    ----------
    size
        Its three lengths, along its own axes.
    centre
        The middle of it.
    orientation
        How it is turned about its centre; None: it stands along the scene's axes.
    """

    _: KW_ONLY
    size: Point
    centre: Point = (0.0, 0.0, 0.0)
    orientation: Orientation | None = None


@dataclass(frozen=True)
class Revolution(Body):
    """A thin wall that is a line turned about an axis, touched from both sides and at its edges.

    Attributes
    ----------
    profile
        The line: points with their radius and their height along the axis, joined by straight
        pieces. ``{"through": (r, h), "to": (r, h)}`` in place of a point is a circular arc from the
        point before, through one point to another. The first and the last point may lie on the
        axis, or may be the same.
    centre, axis
        The point of the axis at the height 0, and "x", "y", "z", one of them with a minus, or any
        direction.
    """

    _: KW_ONLY
    profile: Sequence[tuple[Size, Size] | Mapping[str, tuple[Size, Size]]]
    centre: Point = (0.0, 0.0, 0.0)
    axis: str | Direction = "z"


@dataclass(frozen=True)
class Surface(Body):
    """A surface at the zero of a polynomial.

    Attributes
    ----------
    condition
        A polynomial in x, y and z of the *ball's centre*: positive where the ball is free, zero
        where it touches. Its gradient must not vanish there. `ball_radius` is the ball's radius.
    """

    _: KW_ONLY
    condition: Size


BODIES: tuple[type[Body], ...] = (
    Plane,
    Sphere,
    Cylinder,
    Cone,
    Disc,
    Torus,
    Box,
    Revolution,
    Surface,
)
"""Kinds of bodies that a scene may have."""


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
