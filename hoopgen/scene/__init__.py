"""Scenes of one's own: what they are made of, and the files that they are in."""

from __future__ import annotations

from .errors import SceneError
from .files import load_scene
from .limits import Limits
from .pieces import (
    Box,
    Cone,
    Cylinder,
    Disc,
    End,
    Parameter,
    Plane,
    Revolution,
    Sphere,
    Surface,
    Torus,
)
from .scene import Scene

__all__ = [
    "Box",
    "Cone",
    "Cylinder",
    "Disc",
    "End",
    "Limits",
    "Parameter",
    "Plane",
    "Revolution",
    "Scene",
    "SceneError",
    "Sphere",
    "Surface",
    "Torus",
    "load_scene",
]
