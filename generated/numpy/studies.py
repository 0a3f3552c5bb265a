"""Formulas of studies that need no scene: releases, and the interval of a share.

Generated from templates/numpy/studies.py.j2, the same for every scene, with
Jinja2 3.1.6. Do not edit: change templates/ and run `make generate`.
Every function takes scalars or arrays that broadcast and is evaluated element by element.
"""

# ruff: noqa: E501

from __future__ import annotations

from typing import Any

from numpy import sqrt as _sqrt
from numpy import where as _where

RESULTS: dict[str, tuple[str, ...]] = {
    "uniform_number": ("uniform",),
    "first_term": ("total",),
    "next_term": ("total",),
    "deviation_of_sum": ("noise",),
    "release_heading": ("heading",),
    "release_state": ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz",),
    "release_jacobian": ("vx_by_speed", "vy_by_speed", "vz_by_speed", "vx_by_elevation", "vy_by_elevation", "vz_by_elevation", "vx_by_azimuth", "vy_by_azimuth", "wx_by_azimuth", "wy_by_azimuth", "wx_by_backspin", "wy_by_backspin", "wz_by_sidespin", "z_by_height", "x_by_distance", "y_by_distance", "x_by_angle", "y_by_angle", "vx_by_angle", "vy_by_angle", "wx_by_angle", "wy_by_angle",),
    "wilson_interval": ("low", "high",),
}
"""The names of the results of each function."""


def uniform_number(bits: Any) -> tuple[Any, ...]:
    """Uniform number in the open interval (0, 1), an odd multiple of 2^-53.

    the middle of an interval of width 2^-52. 2 operations: 1 addition, 1 multiplication.
    """
    return (1.1102230246251565e-16 + (2.220446049250313e-16 * bits),)


def first_term(weight: Any, normal: Any) -> tuple[Any, ...]:
    """First term of a sum of weighted normal numbers.

    the product of the correlations' factor with normal numbers. 1 operation: 1 multiplication.
    """
    return (weight * normal,)


def next_term(total: Any, weight: Any, normal: Any) -> tuple[Any, ...]:
    """Sum of weighted normal numbers with one more term.

    the product of the correlations' factor with normal numbers. 2 operations: 1 addition, 1 multiplication.
    """
    return (total + (weight * normal),)


def deviation_of_sum(total: Any, deviation: Any) -> tuple[Any, ...]:
    """Noise of a variable.

    the deviation times a sum with variance 1. 1 operation: 1 multiplication.
    """
    return (total * deviation,)


def release_heading(azimuth: Any, angle: Any) -> tuple[Any, ...]:
    """Direction from the ring's centre opposite to which the ball is sent.

    h = azimuth + angle. 1 operation: 1 addition.
    """
    return (azimuth + angle,)


def release_state(speed: Any, backspin: Any, sidespin: Any, height: Any, distance: Any, ring_height: Any, sin_heading: Any, cos_heading: Any, sin_elevation: Any, cos_elevation: Any, sin_angle: Any, cos_angle: Any) -> tuple[Any, ...]:
    """State of a release, given the sine and the cosine of its angles.

    ahead = -(cos h, sin h). 12 operations: 1 subtraction, 8 multiplications, 3 negations.
    """
    _s0 = -cos_heading
    _s1 = speed * cos_elevation
    _s2 = -sin_heading
    return (distance * cos_angle, distance * sin_angle, height - ring_height, _s0 * _s1, _s2 * _s1, speed * sin_elevation, backspin * _s2, -(backspin * _s0), sidespin,)


def release_jacobian(speed: Any, backspin: Any, distance: Any, sin_heading: Any, cos_heading: Any, sin_elevation: Any, cos_elevation: Any, sin_angle: Any, cos_angle: Any) -> tuple[Any, ...]:
    """Derivatives of the state of a release by its arguments that are not zero.

    the chain rule. 18 operations: 12 multiplications, 6 negations.
    """
    _s0 = -cos_heading
    _s1 = -sin_heading
    _s2 = -(speed * sin_elevation)
    _s3 = speed * cos_elevation
    _s4 = sin_heading * _s3
    _s5 = _s0 * _s3
    _s6 = backspin * _s0
    _s7 = -(backspin * sin_heading)
    return (cos_elevation * _s0, cos_elevation * _s1, sin_elevation, _s0 * _s2, _s1 * _s2, _s3, _s4, _s5, _s6, _s7, _s1, -_s0, 1.0, 1.0, cos_angle, sin_angle, -(distance * sin_angle), distance * cos_angle, _s4, _s5, _s6, _s7,)


def wilson_interval(made: Any, shots: Any, quantile: Any) -> tuple[Any, ...]:
    """Ends of the score interval of a share.

    Wilson (1927). 19 operations: 4 additions, 2 subtractions, 5 multiplications, 3 divisions, 1 square root, 2 comparisons, 2 selections.
    """
    _s0 = quantile * quantile
    _s1 = shots + _s0
    _s2 = made + (0.5 * _s0)
    _s3 = quantile * _sqrt(((0.25 * _s0) + ((made * (shots - made)) / shots)))
    return (_where((0.0 < made), ((_s2 - _s3) / _s1), 0.0), _where((made < shots), ((_s3 + _s2) / _s1), 1.0),)
