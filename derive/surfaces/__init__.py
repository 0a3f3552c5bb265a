"""What a ball can touch (Table 2): distance, condition, normal, bounds."""

from __future__ import annotations

from .body import Body, body
from .gate import Gate
from .plane import Plane
from .ring import Ring
from .sphere import Sphere
from .surface import Surface

__all__ = ["Body", "Gate", "Plane", "Ring", "Sphere", "Surface", "body"]
