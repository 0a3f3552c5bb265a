"""The registry of searches, by kind of surface and flight: a special one, else the general one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ..motion.air import AirFlight
from ..motion.flight import Flight
from ..motion.parabola import Parabola
from ..surfaces import (
    Box,
    Cone,
    EndPlane,
    InclinedPlane,
    ObliqueBox,
    ObliqueCylinder,
    Plane,
    RevolvedArc,
    Ring,
    Surface,
)
from ..surfaces.torus import Toroidal
from .air import AirBoxRootFinder, AirRootFinder
from .arc import ArcRootFinder
from .box import BoxRootFinder
from .end_plane import EndPlaneRootSearch, EndPlaneSearch
from .inclined_plane import InclinedPlaneSearch
from .oblique_box import AirObliqueBoxRootFinder, ObliqueBoxRootFinder
from .plane import PlaneSearch
from .polynomial import PolynomialRootFinder
from .ring.air import AirRingRootFinder
from .ring.air_sketch import AirRingSketch
from .ring.double import RingRootFinder
from .ring.single import SinglePrecisionRing
from .root_finder import RootFinder
from .root_search import PlaneRootSearch, RootSearch
from .search import Search

SearchFactory = Callable[[Any, Any], Search | None]
"""A function from a surface and a flight to their search; None if it does not support these two."""


def _ring(surface: Ring, flight: Parabola) -> Search | None:
    # Windows and bounds on F'' assume a ring that lies across gravity.
    if not flight.upright:
        return None
    coarse = None if surface.bounds else SinglePrecisionRing(flight, surface)
    return RootSearch(surface, flight, RingRootFinder(flight, surface), coarse)


def _box(surface: Box, flight: Parabola) -> Search:
    return RootSearch(surface, flight, BoxRootFinder(flight, surface))


def _oblique_box(surface: ObliqueBox, flight: Parabola) -> Search:
    return RootSearch(surface, flight, ObliqueBoxRootFinder(flight, surface))


def _oblique(surface: Surface, flight: Parabola) -> Search:
    return RootSearch(surface, flight, PolynomialRootFinder(flight, surface, two_sided=True))


def _arc(surface: RevolvedArc, flight: Parabola) -> Search:
    return RootSearch(surface, flight, ArcRootFinder(flight, surface, two_sided=True))


def _in_air(surface: Surface, flight: AirFlight) -> Search:
    if isinstance(surface, Plane):
        return PlaneRootSearch(surface, flight, AirRootFinder(flight, surface, two_sided=True))
    if isinstance(surface, Ring):
        sketch = AirRingSketch.of(flight, surface)
        return RootSearch(surface, flight, AirRingRootFinder(flight, surface), sketch=sketch)
    if isinstance(surface, ObliqueBox):
        return RootSearch(surface, flight, AirObliqueBoxRootFinder(flight, surface))
    if isinstance(surface, Box):
        return RootSearch(surface, flight, AirBoxRootFinder(flight, surface))
    return RootSearch(surface, flight, AirRootFinder(flight, surface, two_sided=True))


def _end_in_air(surface: EndPlane, flight: AirFlight) -> Search:
    return EndPlaneRootSearch(surface, flight, AirRootFinder(flight, surface, two_sided=True))


def _general(surface: Surface, flight: Flight) -> Search | None:
    # The polynomial in time is that of the path, which must be the flight itself.
    if not flight.exact:
        return None
    # The way out of the part of a tube that is not there bends much less than the largest |F''|.
    two_sided = isinstance(surface, Toroidal) and bool(surface.bounds)
    return RootSearch(surface, flight, PolynomialRootFinder(flight, surface, two_sided=two_sided))


SEARCHES: tuple[tuple[type[Surface], type[Flight], SearchFactory], ...] = (
    (EndPlane, Parabola, EndPlaneSearch),
    (EndPlane, AirFlight, _end_in_air),
    (Surface, AirFlight, _in_air),
    (Plane, Parabola, PlaneSearch),
    (Ring, Parabola, _ring),
    (ObliqueBox, Parabola, _oblique_box),
    (Box, Parabola, _box),
    (InclinedPlane, Parabola, InclinedPlaneSearch),
    (ObliqueCylinder, Parabola, _oblique),
    (Cone, Parabola, _oblique),
    (RevolvedArc, Parabola, _arc),
    (Surface, Flight, _general),
)
"""Kinds of surface and flight, with their search; the first row that supports both is taken."""


def search_for(surface: Surface, flight: Flight) -> Search:
    """Return the search of a surface along a flight.

    Parameters
    ----------
    surface
        The surface.
    flight
        The motion between contacts.

    Raises
    ------
    TypeError
        If there is none.
    """
    for kind, flight_kind, make in SEARCHES:
        if isinstance(surface, kind) and isinstance(flight, flight_kind):
            found = make(surface, flight)
            if found is not None:
                return found
    raise TypeError(
        f"surface {surface.name}: no search for a {type(surface).__name__} along a "
        f"{type(flight).__name__}; the general one expects a path without remainder or end"
    )


def root_finder_for(surface: Surface, flight: Flight) -> RootFinder:
    """Return the root finder of a curved surface along a flight.

    Parameters
    ----------
    surface
        A surface whose condition has no closed form of a root.
    flight
        The motion between contacts.

    Raises
    ------
    TypeError
        If the surface's arrival is a closed form.
    """
    found = search_for(surface, flight)
    if not isinstance(found, RootSearch):
        raise TypeError(f"surface {surface.name}: its arrival is a closed form")
    return found.root_finder
