"""Where we look from. Views are orthographic: two axes of the picture and a depth."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["FRONT", "SIDE", "TOP", "Limits", "Points", "View", "oblique"]

Vector = tuple[float, float, float]
Points = NDArray[np.float64]

Limits = tuple[float, float, float, float]
"""Of what is seen: left, right, bottom, top; m."""


@dataclass(frozen=True)
class View:
    """An orthographic view.

    Attributes
    ----------
    name
        In words.
    right, up
        Unit vectors of the picture's axes, orthogonal.
    labels
        Names of the picture's axes; None where they are no coordinate axes.
    middle, near
        From where depth counts, m, and how much a metre is.
    """

    name: str
    right: Vector
    up: Vector
    labels: tuple[str, str] | None = None
    middle: float = 0.0
    near: float = 1.0

    @property
    def towards(self) -> NDArray[np.float64]:
        """The unit vector from the scene to the eye."""
        return np.asarray(np.cross(self.right, self.up))

    def flatten(self, points: ArrayLike) -> NDArray[np.float64]:
        """Project points, shape (..., 3), on the picture, shape (..., 2)."""
        return np.asarray(np.asarray(points) @ np.array([self.right, self.up]).T)

    def depth(self, points: ArrayLike) -> NDArray[np.float64]:
        """How near to the eye points are; the larger, the nearer."""
        return np.asarray((np.asarray(points) @ self.towards - self.middle) * self.near)


SIDE = View("side view", (1.0, 0.0, 0.0), (0.0, 0.0, 1.0), ("x", "z"))
FRONT = View("side view", (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), ("y", "z"))
TOP = View("top view", (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), ("x", "y"))


def oblique(azimuth: float, elevation: float) -> View:
    """Look at the hoop from a direction.

    Parameters
    ----------
    azimuth
        Of the eye, rad: 0 in front of the board, positive towards +y.
    elevation
        Of the eye above the horizontal, rad.

    Returns
    -------
    View
        Named ``"3D view"``.
    """
    right = (-np.sin(azimuth), np.cos(azimuth), 0.0)
    eye = (
        np.cos(elevation) * np.cos(azimuth),
        np.cos(elevation) * np.sin(azimuth),
        np.sin(elevation),
    )
    up = np.cross(eye, right)
    return View("3D view", _vector(right), _vector(up))


def _vector(values: ArrayLike) -> Vector:
    x, y, z = np.asarray(values, dtype=float)
    return float(x), float(y), float(z)
