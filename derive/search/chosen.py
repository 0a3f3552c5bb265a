"""Which search a surface has along a flight: one of their own, else the general one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ..flight.flight import Flight
from ..flight.parabola import Parabola
from ..surfaces import Box, Gate, Plane, Ring, Surface
from .approach import Approach
from .bernstein import PolynomialApproach
from .box import BoxApproach
from .coarse import CoarseRing
from .curved import CurvedSearch
from .gate import GateSearch
from .plane import PlaneSearch
from .ring import RingApproach
from .search import Search

Make = Callable[[Any, Any], Search | None]
"""From a surface and a flight to their search; None where it does not serve these two."""


def _ring(surface: Ring, flight: Parabola) -> Search | None:
    # All of it, from the windows to the bound on F'', is of a ring that lies across free fall.
    if not flight.upright:
        return None
    coarse = None if surface.bounds else CoarseRing(flight, surface)
    return CurvedSearch(surface, flight, RingApproach(flight, surface), coarse)


def _box(surface: Box, flight: Parabola) -> Search:
    return CurvedSearch(surface, flight, BoxApproach(flight, surface))


def _general(surface: Surface, flight: Flight) -> Search | None:
    # The polynomial in time is that of the path: no more is known of what is beside it.
    if not flight.exact:
        return None
    return CurvedSearch(surface, flight, PolynomialApproach(flight, surface))


CHOICES: tuple[tuple[type[Surface], type[Flight], Make], ...] = (
    (Gate, Parabola, GateSearch),
    (Plane, Parabola, PlaneSearch),
    (Ring, Parabola, _ring),
    (Box, Parabola, _box),
    (Surface, Flight, _general),
)
"""Kinds of surface and flight, and their search; the first that fits both and serves is taken."""


def search(surface: Surface, flight: Flight) -> Search:
    """Return the search of a surface along a flight.

    Raises
    ------
    TypeError
        If there is none.
    """
    for kind, flown, make in CHOICES:
        if isinstance(surface, kind) and isinstance(flight, flown):
            found = make(surface, flight)
            if found is not None:
                return found
    raise TypeError(
        f"surface {surface.name}: no search for a {type(surface).__name__} along a "
        f"{type(flight).__name__}; the general one expects a path without remainder or end"
    )


def approach(surface: Surface, flight: Flight) -> Approach:
    """Return what the search of a curved surface knows of it along a flight.

    Raises
    ------
    TypeError
        If the surface is not searched so.
    """
    found = search(surface, flight)
    if not isinstance(found, CurvedSearch):
        raise TypeError(f"surface {surface.name}: its arrival is a closed form")
    return found.approach
