"""The parts of a box for the judge: faces, edges and corners, each with its bounds.

The engines search a box as one surface. That both find the same is what the judge is for. The parts
of a turned box are those of one along the axes, seen from its centre along its own axes.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import Any

import sympy as sp

from hoopgen.derive.surfaces import Box, Cylinder, ObliqueBox, Plane, Sphere, Surface
from hoopgen.derive.surfaces.rotation import scaled_rotation, squared_norm, times, transposed
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.derive.symbolic.symbols import POSITION


def box_parts(surface: Surface) -> tuple[Surface, ...]:
    """Return the parts of a box, each with one polynomial; of any other surface, itself."""
    if not isinstance(surface, Box):
        return (surface,)
    if isinstance(surface, ObliqueBox):
        return tuple(
            _TurnedPart(surface.name, part, surface, contact_bounds=surface.contact_bounds)
            for part in box_parts(_own(surface))
        )
    # For each coordinate: beyond the lower face, between both, or beyond the upper one.
    sides = [side for side in product((-1, 0, 1), repeat=3) if any(side)]
    return tuple(_part(surface, side) for side in sides)


def region(part: Surface) -> tuple[sp.Expr, ...]:
    """Return polynomials that are not positive where a part of a box is the nearest one."""
    if isinstance(part, _TurnedPart):
        return tuple(_turned(limit, part.box) for limit in region(part.part))
    assert isinstance(part, Plane | Sphere | Cylinder)
    return part.limits


def _part(box: Box, side: tuple[int, ...]) -> Surface:
    limits: list[sp.Expr] = []
    corner: list[sp.Expr] = []
    for place, low, high, beyond in zip(POSITION, box.low, box.high, side, strict=True):
        corner.append(high if beyond > 0 else low)
        limits += [] if beyond > 0 else [place - high if beyond == 0 else place - low]
        limits += [] if beyond < 0 else [low - place if beyond == 0 else high - place]
    centre = (corner[0], corner[1], corner[2])
    bounds: dict[str, Any] = {"limits": tuple(limits), "contact_bounds": box.contact_bounds}
    touching = [k for k, beyond in enumerate(side) if beyond]
    if len(touching) == 3:
        return Sphere(box.name, centre, box.radius, **bounds)
    if len(touching) == 2:
        along = tuple(int(k not in touching) for k in range(3))
        return Cylinder(box.name, centre, along, box.radius, **bounds)
    (axis,) = touching
    towards = tuple(int(k == axis) * side[axis] for k in range(3))
    offset = side[axis] * corner[axis] + box.radius
    inner = tuple(bound for bound in limits if POSITION[axis] not in bound.free_symbols)
    return Plane(
        box.name,
        (towards[0], towards[1], towards[2]),
        offset,
        box.radius,
        inner,
        contact_bounds=box.contact_bounds,
    )


def _own(box: ObliqueBox) -> Box:
    """Return the box along its own axes, in the coordinates of `_turned`."""
    scale = squared_norm(box.orientation)
    corners = (tuple(scale * length for length in end) for end in (box.low, box.high))
    low, high = ((x, y, z) for x, y, z in corners)
    return Box(box.name, low, high, scale * box.radius)


def _turned(formula: sp.Expr, box: ObliqueBox) -> sp.Expr:
    """Return a formula in the coordinates along a box's axes as one of the scene's."""
    offsets = [place - own for place, own in zip(POSITION, box.centre, strict=True)]
    turned = times(transposed(scaled_rotation(box.orientation)), offsets)
    return formula.xreplace(dict(zip(POSITION, turned, strict=True)))


@dataclass(frozen=True)
class _TurnedPart(Surface):
    """A part of a turned box.

    Attributes
    ----------
    part
        The part of the box along its own axes.
    box
        The box.
    """

    part: Surface
    box: ObliqueBox

    @property
    def condition(self) -> sp.Expr:
        """The part's condition, turned."""
        return _turned(self.part.condition, self.box)

    @property
    def distance(self) -> sp.Expr:
        """The part's distance, in metres."""
        return _turned(self.part.distance, self.box) / squared_norm(self.box.orientation)

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The part's bounds, turned, and those of the box."""
        own = (_turned(bound, self.box) for bound in self.part.bounds)
        return (*own, *self.cuts)

    @property
    def normal(self) -> sp.Matrix:
        """The part's normal, turned back."""
        there = [_turned(component, self.box) for component in self.part.normal]
        back = times(scaled_rotation(self.box.orientation), there)
        return sp.Matrix(back) / squared_norm(self.box.orientation)

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """Expressions that are negative inside of the part, turned."""
        return tuple(_turned(expression, self.box) for expression in self.part.inside)


def box_solid(box: Box) -> tuple[sp.Expr, ...]:
    """Return the squared distance from a box less R_B², and the bounds at its nearest point.

    All are negative if the ball overlaps the box where it exists.
    """
    own = _own(box) if isinstance(box, ObliqueBox) else box
    beyond, squares = [], []
    for place, low, high in zip(POSITION, own.low, own.high, strict=True):
        # The larger of q and 0 is (q + |q|)/2, which balls can say; only one of the two is not 0.
        above, below = ((q + sp.Abs(q)) / 2 for q in (place - high, low - place))
        squares += [above**2, below**2]
        beyond.append(above - below)
    away = sp.Add(*squares, -(own.radius**2))
    if isinstance(box, ObliqueBox):
        away, turned = _turned(away, box), [_turned(part, box) for part in beyond]
        back = times(scaled_rotation(box.orientation), turned)
        beyond = [part / squared_norm(box.orientation) ** 2 for part in back]
    nearest = (place - part for place, part in zip(POSITION, beyond, strict=True))
    there = dict(zip(POSITION, nearest, strict=True))
    given = box.contact_bounds.polynomials if box.contact_bounds else ()
    return (away, *(release(bound).xreplace(there) for bound in given))
