"""Directions as an author writes them: three sizes, or a tilt from the z axis.

Every direction is brought to the length 1 once for each set of parameters, in doubles. To the
kernels and the judge its components are these doubles.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any, Protocol

from hoopgen.core.units import parse_quantity
from hoopgen.text.shorten import brief, join_names

from .formulas import ONE, POSITION, ZERO, Formula, constant
from .inputs import Inputs

Vector = tuple[Formula, Formula, Formula]

_ANGLES = ("tilt", "towards")
_DIGITS = 15
"""Decimals of the components that angles give: one fewer than a double has, so that those of 30deg
are the same on every machine and 90deg is exactly horizontal."""


class Reader(Protocol):
    """A reader of arguments as formulas, with the inputs of a scene."""

    @property
    def inputs(self) -> Inputs:
        """The inputs."""

    def formula(self, owner: str, argument: str, given: object) -> Formula:
        """Return a size as a formula of the parameters.

        Parameters
        ----------
        owner
            The body, for error messages.
        argument
            The argument, for error messages.
        given
            The size as the author wrote it.
        """

    def size(self, owner: str, argument: str, given: object, **allowed: Any) -> Formula:
        """Return a size as an input; arguments as for `formula`, and what an input allows."""

    def point(self, owner: str, argument: str, given: object) -> dict[str, Formula]:
        """Return three sizes as formulas, by name; arguments as for `formula`."""

    def add(self, owner: str, formulas: Mapping[str, Formula]) -> dict[str, Formula]:
        """Return formulas, by argument, as inputs of a body; `owner` as for `formula`."""

    def axis(self, owner: str, argument: str, given: object) -> tuple[int, int]:
        """Return coordinate and direction of an axis; arguments as for `formula`."""

    def flag(self, owner: str, argument: str, given: object) -> bool:
        """Return a truth value, checked; arguments as for `formula`."""


def direction(inputs: Inputs, owner: str, argument: str, given: object) -> Vector:
    """Return a direction as three formulas of a vector of length 1.

    Parameters
    ----------
    inputs
        The inputs of the scene.
    owner, argument
        As for `Reader.formula`.
    given
        Three sizes of any length but 0, or a mapping with the angles `tilt` and `towards`.

    Raises
    ------
    SceneError
        If it is neither, or is zero at the parameters' defaults.
    """
    if isinstance(given, Mapping):
        return _tilted(inputs, owner, argument, given)
    none = "has no direction: all three sizes are 0"
    said = "three sizes, or tilt and towards"
    x, y, z = unit_sizes(inputs, owner, argument, given, POSITION, said, none)
    return x, y, z


def axis_or_direction(reader: Reader, owner: str, argument: str, given: object) -> Vector:
    """Return the direction of an axis by its name, or of a vector.

    Parameters
    ----------
    reader
        The reader of the scene's arguments.
    owner, argument
        As for `direction`.
    given
        The name of an axis, such as ``"-z"``, or what `direction` takes.

    Raises
    ------
    SceneError
        If it is neither.
    """
    if isinstance(given, str):
        axis, way = reader.axis(owner, argument, given)
        x, y, z = (constant(way * (k == axis)) for k in range(3))
        return x, y, z
    return direction(reader.inputs, owner, argument, given)


def unit_sizes(
    inputs: Inputs,
    owner: str,
    argument: str,
    given: object,
    names: Sequence[str],
    expected: str,
    none: str,
) -> list[Formula]:
    """Return sizes over the root of the sum of their squares.

    Parameters
    ----------
    inputs, owner, argument
        As for `direction`.
    given
        The sizes as the author wrote them.
    names
        The name of each size.
    expected, none
        What an error says if they are not so many sizes, and if all of them are 0.

    Raises
    ------
    SceneError
        If they are not so many sizes, or all are 0 at the parameters' defaults.
    """
    if isinstance(given, str) or not isinstance(given, Sequence) or len(given) != len(names):
        raise inputs.wrong(owner, argument, f"expected {expected}; got {brief(given)}")
    named = [f"{argument} {name}" for name in names]
    parts = [inputs.read(owner, own, part) for own, part in zip(named, given, strict=True)]
    numbers = [inputs.number(owner, own, part) for own, part in zip(named, parts, strict=True)]
    fixed = all(part.number is not None for part in parts)
    if not any(numbers):
        raise inputs.wrong(owner, argument, none if fixed else f"{none} at the defaults")
    if fixed:
        return _fixed_unit(parts)
    length = sum((part**2 for part in parts), ZERO).sqrt()
    return [part if part == ZERO else part / length for part in parts]


def _fixed_unit(parts: Sequence[Formula]) -> list[Formula]:
    """Return fixed numbers over their length; along an axis, whole numbers."""
    sizes = [part.number or Fraction(0) for part in parts]
    largest = max(map(abs, sizes))
    shares = [size / largest for size in sizes]
    if sum(map(bool, shares)) == 1:
        return [constant(share) for share in shares]
    length = math.sqrt(float(sum(share**2 for share in shares)))
    return [constant(Fraction(repr(float(share) / length))) for share in shares]


def rounded(numbers: Sequence[float]) -> list[Formula]:
    """Return numbers that were computed of angles as decimals, the same on every machine."""
    return [constant(Fraction(repr(round(number, _DIGITS)))) for number in numbers]


def _tilted(inputs: Inputs, owner: str, argument: str, given: Mapping[Any, Any]) -> Vector:
    """Return the direction that leans from the z axis by an angle, towards another one."""
    strange = [name for name in given if name not in _ANGLES]
    if strange:
        said = f"unknown {join_names(strange)}. There are {join_names(_ANGLES)}"
        raise inputs.wrong(owner, argument, said)
    if "tilt" not in given:
        raise inputs.wrong(owner, f"{argument} tilt", "missing")
    tilt, towards = (
        angle(inputs, owner, f"{argument} {name}", given.get(name, "0deg")) for name in _ANGLES
    )
    parts = (
        math.sin(tilt) * math.cos(towards),
        math.sin(tilt) * math.sin(towards),
        math.cos(tilt),
    )
    x, y, z = _fixed_unit(rounded(parts))
    return x, y, z


def angle(inputs: Inputs, owner: str, argument: str, given: object) -> float:
    """Return an angle in radians, from text with a unit such as ``"12deg"``.

    Parameters
    ----------
    inputs, owner, argument
        As for `direction`.
    given
        The angle.

    Raises
    ------
    SceneError
        If it is no text of a number and the unit deg or rad.
    """
    if not isinstance(given, str):
        said = f'expected text with a unit, such as "12deg" or "0.2rad"; got {brief(given)}'
        raise inputs.wrong(owner, argument, said)
    try:
        return parse_quantity(given, "angle")
    except ValueError as error:
        raise inputs.wrong(owner, argument, error) from None


def aligned(vector: Vector) -> tuple[int, int] | None:
    """Return coordinate and sign of a direction that is fixed along an axis; None of any other."""
    for axis, part in enumerate(vector):
        if all(other == ZERO for k, other in enumerate(vector) if k != axis):
            if part == ONE:
                return axis, 1
            if part == constant(-1):
                return axis, -1
    return None


def dot(left: Sequence[Formula], right: Sequence[Formula]) -> Formula:
    """Return the scalar product of two vectors.

    Parameters
    ----------
    left, right
        The vectors, three components each.
    """
    return sum((a * b for a, b in zip(left, right, strict=True)), ZERO)


def settled(formula: Formula) -> Formula:
    """Return a formula without names as the double that it is, and any other one as it is."""
    if formula.names or formula == ZERO:
        return formula
    value = float(formula.evaluate({}))
    return constant(Fraction(repr(value))) if math.isfinite(value) else formula


def vector_inputs(
    inputs: Inputs, owner: str, argument: str, vector: Sequence[Formula], unit: str = "m"
) -> dict[str, Formula]:
    """Return the components of a vector as inputs; whole numbers remain what they are.

    Parameters
    ----------
    inputs, owner
        As for `direction`.
    argument
        The argument after which the inputs are named.
    vector, unit
        The components, and their unit.
    """
    found = {}
    for axis, part in zip(POSITION, vector, strict=True):
        whole = unit == "1" and part in (ONE, constant(-1))
        own = f"{argument} {axis}"
        found[own] = part if whole else inputs.add(owner, own, part, unit=unit)
    return found
