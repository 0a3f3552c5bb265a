"""What a ball can touch (Table 2): distance, condition, normal, bounds."""

from __future__ import annotations

from .body import Body, body
from .bounds import length
from .box import Box
from .cylinder import Cylinder
from .free import Free
from .gate import Gate
from .plane import Plane
from .ring import Ring
from .sphere import Sphere
from .surface import Surface
from .torus import Torus, torus

__all__ = [
    "Body",
    "Box",
    "Cylinder",
    "Free",
    "Gate",
    "Plane",
    "Ring",
    "Sphere",
    "Surface",
    "Torus",
    "body",
    "length",
    "torus",
]
