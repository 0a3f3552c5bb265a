"""Reading of gravity: its size, which may be zero, and its direction."""

from __future__ import annotations

from collections.abc import Iterable

from .directions import Vector, aligned, direction, settled, vector_inputs
from .formulas import ZERO, Formula
from .inputs import Inputs
from .oblique_bodies import why_not_rolling

MIN_INERTIA, MAX_INERTIA = 1 / 64, 1.0
"""The allowed range of a ball's moment of inertia over m R_B² (`derive/contact/ball.py`)."""


def read_gravity(
    inputs: Inputs, gravity: object, down: object, along: tuple[int, int] | None
) -> tuple[Formula, tuple[int, int] | Vector]:
    """Return the size of gravity, and its axis or, in any other direction, the acceleration.

    Gravity may be zero if it is the number 0, or a parameter that is declared as nonnegative.

    Parameters
    ----------
    inputs
        The inputs of the scene.
    gravity, down
        The size and the direction, as the author wrote them.
    along
        Coordinate and sign of an axis that the direction names; None: it is a vector.

    Raises
    ------
    SceneError
        If gravity is negative, or one of them is not what it should be.
    """
    size = inputs.read("", "gravity", gravity)
    own = next((i for i in inputs.all if i.name == size.value and size.kind == "name"), None)
    zero = size == ZERO or (own is not None and own.sign == "nonnegative")
    sign = "nonnegative" if zero else "positive"
    vector = None if along is not None else direction(inputs, "", "down", down)
    axis = along if vector is None else aligned(vector)
    if size.number is not None and size.number < 0:
        said = f"expected a number of at least 0, got {float(size.number):g}; down is its direction"
        raise inputs.wrong("", "gravity", said)
    if axis is not None or vector is None or size == ZERO:
        return inputs.add("", "gravity", size, sign=sign, unit="m/s²"), axis or (2, -1)
    if size.number is None:
        inputs.add("", "gravity", size, sign=sign, unit="m/s²")
    parts = [settled(size * part) for part in vector]
    x, y, z = vector_inputs(inputs, "", "gravity", parts, unit="m/s²").values()
    return size, (x, y, z)


def check_rolling(
    inputs: Inputs,
    size: Formula,
    bodies: Iterable[tuple[str, str, tuple[int, ...]]],
) -> None:
    """Raise if a ball cannot roll in a scene: without gravity, or on one of its bodies.

    Parameters
    ----------
    inputs
        The inputs of the scene.
    size
        The size of gravity, as `read_gravity` returns it.
    bodies
        The name and kind of each body, and the degree of each of its bounds.

    Raises
    ------
    SceneError
        With the reason.
    """
    for own, kind, degrees in bodies:
        argument, said = why_not_rolling(kind, degrees)
        if said:
            raise inputs.wrong(f"body {own}", argument, said)
    signs = {i.name: i.sign for i in inputs.all}
    if size == ZERO or signs.get(str(size.value)) == "nonnegative":
        said = "a ball rolls only where gravity cannot be 0"
        hint = ": declare its sign as positive" if size != ZERO else "; expected gravity above 0"
        raise inputs.wrong("", "rolls", said + hint)
