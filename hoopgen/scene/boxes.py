"""Reading of boxes, along the axes or turned, and of the ways to write how one is turned."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from hoopgen.text.shorten import join_names

from . import pieces
from .directions import Reader, angle, axis_or_direction, rounded, unit_sizes
from .formulas import ZERO, Formula, constant

PARTS = ("w", "x", "y", "z")
"""The components of a quaternion, the real part first."""

_ANGLES = ("yaw", "pitch", "roll")
_QUARTERS = ((1.0, 0.0), (math.sqrt(0.5), math.sqrt(0.5)), (0.0, 1.0))
"""Cosine and sine of half of so many quarter turns; the sign of a quaternion does not matter."""

_EXPECTED = "four sizes w, x, y, z of a quaternion, or axis and angle, or yaw, pitch and roll"

Half = tuple[float, float]
"""Cosine and sine of half of an angle."""


def read_box(
    reader: Reader, owner: str, body: pieces.Box
) -> tuple[str, tuple[tuple[str, Formula], ...]]:
    """Return a box: the kind of its shape, "" along the axes, and its sizes.

    Parameters
    ----------
    reader, owner, body
        As for `hoopgen.scene.oblique_bodies.read_disc`.

    Raises
    ------
    SceneError
        If a size is not allowed, or the orientation is none.
    """
    inputs = reader.inputs
    size = reader.point(owner, "size", body.size)
    centre = reader.point(owner, "centre", body.centre)
    turn = None if body.orientation is None else _quaternion(reader, owner, body.orientation)
    sizes: dict[str, Formula] = {}
    for (argument, length), middle in zip(size.items(), centre.values(), strict=True):
        if (given := inputs.number(owner, argument, length)) <= 0:
            raise inputs.wrong(owner, argument, f"expected a number above 0, got {given:g}")
        half = length / constant(2)
        axis = argument.rpartition(" ")[2]
        if turn is None:
            sizes |= reader.add(owner, {f"from {axis}": middle - half, f"to {axis}": middle + half})
        else:
            own = f"half {axis}"
            sizes[own] = inputs.add(owner, own, half, sign="positive")
    if turn is None:
        return "", tuple(sizes.items())
    sizes |= reader.add(owner, centre)
    for name, part in zip(PARTS, turn, strict=True):
        own = f"orientation {name}"
        sizes[own] = inputs.add(owner, own, part, unit="1")
    return "oblique box", tuple(sizes.items())


def _quaternion(reader: Reader, owner: str, given: object) -> tuple[Formula, ...] | None:
    """Return a quaternion of length 1; None for one that turns nothing."""
    if isinstance(given, Mapping):
        parts = _from_angles(reader, owner, given)
    else:
        none = "is no rotation: all four sizes are 0"
        parts = unit_sizes(reader.inputs, owner, "orientation", given, PARTS, _EXPECTED, none)
    return None if parts[1:] == [ZERO] * 3 else tuple(parts)


def _from_angles(reader: Reader, owner: str, given: Mapping[Any, Any]) -> list[Formula]:
    """Return the quaternion of an axis and an angle, or of yaw, pitch and roll."""
    inputs = reader.inputs
    known = ("axis", "angle") if {"axis", "angle"} & set(given) else _ANGLES
    strange = [name for name in given if name not in known]
    if strange or not given:
        got = f"got {join_names(list(given))}" if given else "got none of them"
        raise inputs.wrong(owner, "orientation", f"expected {_EXPECTED}; {got}")
    if known == _ANGLES:
        halves = [
            _of_half(angle(inputs, owner, f"orientation {name}", given.get(name, "0deg")))
            for name in _ANGLES
        ]
        return rounded(_turned_three_times(*halves))
    for name in known:
        if name not in given:
            raise inputs.wrong(owner, f"orientation {name}", "missing")
    half = _of_half(angle(inputs, owner, "orientation angle", given["angle"]))
    axis = axis_or_direction(reader, owner, "orientation axis", given["axis"])
    real, imaginary = rounded(half)
    return [real, *(part * imaginary for part in axis)]


def _of_half(turn: float) -> Half:
    """Return cosine and sine of half of an angle, which are equal for a quarter turn."""
    quarters = round(turn / (math.pi / 2))
    if abs(turn - quarters * (math.pi / 2)) <= 2.0**-50 * abs(turn):
        # Three quarters forwards are one back.
        back = quarters % 4 == 3
        cosine, sine = _QUARTERS[1 if back else quarters % 4]
        return cosine, -sine if back else sine
    return math.cos(turn / 2), math.sin(turn / 2)


def _turned_three_times(yaw: Half, pitch: Half, roll: Half) -> list[float]:
    """Return the quaternion of turns about z, then the new y, then the new x."""
    (cz, sz), (cy, sy), (cx, sx) = yaw, pitch, roll
    return [
        cz * cy * cx + sz * sy * sx,
        cz * cy * sx - sz * sy * cx,
        cz * sy * cx + sz * cy * sx,
        sz * cy * cx - cz * sy * sx,
    ]
