"""Which search a surface has: its own where its kind has one, else the general one."""

from __future__ import annotations

from functools import singledispatch

import sympy as sp

from ..surfaces import Box, Plane, Ring, Surface
from .approach import Approach
from .bernstein import PolynomialApproach
from .box import BoxApproach
from .curved import CurvedSearch
from .plane import PlaneSearch
from .ring import RingApproach
from .search import Search


@singledispatch
def search(surface: Surface, gravity: sp.Expr) -> Search:
    """Return the search of a surface; a kind with one of its own registers it here."""
    return CurvedSearch(surface, gravity, PolynomialApproach(gravity, surface))


@search.register
def _(surface: Plane, gravity: sp.Expr) -> Search:
    return PlaneSearch(surface, gravity)


@search.register
def _(surface: Ring, gravity: sp.Expr) -> Search:
    return CurvedSearch(surface, gravity, RingApproach(gravity, surface))


@search.register
def _(surface: Box, gravity: sp.Expr) -> Search:
    return CurvedSearch(surface, gravity, BoxApproach(gravity, surface))


def approach(surface: Surface, gravity: sp.Expr) -> Approach:
    """Return what the search of a curved surface knows of it along a flight.

    Raises
    ------
    TypeError
        If the surface is not searched so.
    """
    found = search(surface, gravity)
    if not isinstance(found, CurvedSearch):
        raise TypeError(f"surface {surface.name}: its arrival is a closed form")
    return found.approach
