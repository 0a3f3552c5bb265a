"""Orthographic views: two axes of the picture and a depth."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Vector = tuple[float, float, float]
Points = NDArray[np.float64]

Limits = tuple[float, float, float, float]
"""Limits of a view: left, right, bottom, top; m."""


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
    wall
        The x of a wall across x that hides what is behind it, at smaller x, m; None for none.
    """

    name: str
    right: Vector
    up: Vector
    labels: tuple[str, str] | None = None
    middle: float = 0.0
    near: float = 1.0
    wall: float | None = None

    @property
    def towards(self) -> NDArray[np.float64]:
        """The unit vector from the scene to the eye."""
        return np.asarray(np.cross(self.right, self.up))

    def flatten(self, points: ArrayLike) -> NDArray[np.float64]:
        """Project points, shape (..., 3), on the picture, shape (..., 2)."""
        return np.asarray(np.asarray(points) @ np.array([self.right, self.up]).T)

    def depth(self, points: ArrayLike) -> NDArray[np.float64]:
        """Return the nearness of points to the eye; larger is nearer."""
        return np.asarray((np.asarray(points) @ self.towards - self.middle) * self.near)


@dataclass(frozen=True)
class Panel:
    """A view and its place on the page.

    Attributes
    ----------
    view
        From where.
    limits
        Left, right, bottom, top of the picture, m.
    scale
        Inches of the page per metre.
    left, bottom
        Of the axes, inches.
    """

    view: View
    limits: Limits
    scale: float
    left: float
    bottom: float

    @property
    def width(self) -> float:
        """The width of the axes, inches."""
        return (self.limits[1] - self.limits[0]) * self.scale

    @property
    def height(self) -> float:
        """The height of the axes, inches."""
        return (self.limits[3] - self.limits[2]) * self.scale

    @property
    def top(self) -> float:
        """The upper edge of the axes, inches."""
        return self.bottom + self.height

    @classmethod
    def fitted(
        cls, view: View, limits: Limits, left: float, bottom: float, width: float, tallest: float
    ) -> Panel:
        """Return the largest panel that is no wider and no taller than so many inches.

        Parameters
        ----------
        view, limits, left, bottom
            Of the panel.
        width, tallest
            The room there is, inches.
        """
        across, up = limits[1] - limits[0], limits[3] - limits[2]
        return cls(view, limits, min(width / across, tallest / up), left, bottom)


SIDE = View("side view", (1.0, 0.0, 0.0), (0.0, 0.0, 1.0), ("x", "z"))
FRONT = View("side view", (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), ("y", "z"))
TOP = View("top view", (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), ("x", "y"))


def oblique(azimuth: float, elevation: float) -> View:
    """Return the view of the hoop from a direction.

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


def limits_around(points: Points, margin: float) -> Limits:
    """Return the limits of a picture that shows points, with a margin on all four sides.

    Parameters
    ----------
    points
        Points of the picture, (n, 2), m.
    margin
        The width of the margin, m.
    """
    left, bottom = points.min(axis=0) - margin
    right, top = points.max(axis=0) + margin
    return float(left), float(right), float(bottom), float(top)


def _vector(values: ArrayLike) -> Vector:
    x, y, z = np.asarray(values, dtype=float)
    return float(x), float(y), float(z)
