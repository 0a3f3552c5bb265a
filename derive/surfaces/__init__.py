"""Surfaces and bodies that a ball can touch (Table 2): distance, condition, normal, bounds."""

from __future__ import annotations

from .body import Body, body
from .bounds import as_length
from .box import Box
from .cone import Cone
from .contact_bounds import ContactBounds, at_contact
from .cylinder import Cylinder
from .end_plane import EndPlane
from .implicit import ImplicitSurface
from .inclined_plane import InclinedPlane
from .oblique_box import ObliqueBox
from .oblique_cylinder import ObliqueCylinder
from .oblique_torus import ObliqueTorus
from .plane import Plane
from .revolved_arc import RevolvedArc
from .ring import Ring
from .sphere import Sphere
from .surface import Surface
from .torus import Torus, torus

__all__ = [
    "Body",
    "Box",
    "Cone",
    "ContactBounds",
    "Cylinder",
    "ImplicitSurface",
    "InclinedPlane",
    "ObliqueBox",
    "ObliqueCylinder",
    "ObliqueTorus",
    "EndPlane",
    "Plane",
    "RevolvedArc",
    "Ring",
    "Sphere",
    "Surface",
    "Torus",
    "body",
    "as_length",
    "at_contact",
    "torus",
]
