"""Bounds (Eq. 2) and users' surfaces as polynomials of the ball's centre.

A user's bound is a polynomial in the coordinates of a point of the body; it counts where that is at
most 0. The search asks it of the ball's centre, which is a linear map away.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

from hoopgen.text.shorten import brief

from .formulas import ONE, POSITION, ZERO, Formula, FormulaError, constant, name
from .inputs import Inputs
from .polynomials import Polynomial, polynomial, product, total

Powers = tuple[int, int, int]

Terms = tuple[tuple[Powers, Formula], ...]
"""Powers of x, y, z and what they are multiplied by: a whole number, or the name of an input."""


@dataclass(frozen=True)
class Map:
    """The map from the ball's centre p to the point of contact: q_k = scale_k p_k + shift_k."""

    scale: tuple[Formula, Formula, Formula] = (ONE, ONE, ONE)
    shift: tuple[Formula, Formula, Formula] = (ZERO, ZERO, ZERO)

    def put(self, terms: Polynomial) -> Polynomial:
        """Return a polynomial in q as one in p; a linear one may be scaled by a positive factor."""
        steep = {self.scale[k] for powers in terms for k in range(3) if powers[k]}
        if max(map(sum, terms)) == 1 and len(steep) == 1:
            # Divided by the scale, which is positive: what it is multiplied by stays as it was.
            (scale,) = steep
            moved = [
                {(0, 0, 0): terms[_axis(k)] * self.shift[k]} for k in range(3) if _axis(k) in terms
            ]
            constant = total([{(0, 0, 0): terms.get((0, 0, 0), ZERO)}, *moved])
            slopes = {powers: factor for powers, factor in terms.items() if any(powers)}
            return slopes | {powers: factor / scale for powers, factor in constant.items()}
        there = [total([{_axis(k): self.scale[k]}, {(0, 0, 0): self.shift[k]}]) for k in range(3)]
        return _substitute(terms, there)


@dataclass(frozen=True)
class LinearMap:
    """The map from the ball's centre to the point of contact, each of its coordinates linear."""

    rows: tuple[Polynomial, Polynomial, Polynomial]

    def put(self, terms: Polynomial) -> Polynomial:
        """Return a polynomial in the point of contact as one in the ball's centre."""
        return _substitute(terms, self.rows)


def _substitute(terms: Polynomial, there: Sequence[Polynomial]) -> Polynomial:
    def term(powers: Powers, factor: Formula) -> Polynomial:
        found: Polynomial = {(0, 0, 0): factor}
        for place, power in zip(there, powers, strict=True):
            for _ in range(power):
                found = product(found, place)
        return found

    return total(term(powers, factor) for powers, factor in terms.items())


def bounds(
    inputs: Inputs, owner: str, within: object, there: Map | LinearMap | None = None
) -> tuple[Terms, ...]:
    """Return the bounds of a body or an end.

    Parameters
    ----------
    inputs
        Of the scene; what the bounds need is added.
    owner
        Whose they are, for complaints and names.
    within
        What a user wrote: polynomials that are at most 0 where the body is there.
    there
        From the centre to the body; None: the bounds are the centre's own.

    Raises
    ------
    SceneError
        If one is not polynomial.
    """
    if isinstance(within, str) or not isinstance(within, Sequence):
        raise inputs.wrong(owner, "within", f"expected a list of formulas, got {brief(within)}")
    return tuple(
        terms(inputs, owner, f"within {number}", given, there or Map())
        for number, given in enumerate(within, start=1)
    )


def terms(
    inputs: Inputs,
    owner: str,
    argument: str,
    given: object,
    there: Map | LinearMap | None = None,
    also: Mapping[str, Formula] = MappingProxyType({}),
) -> Terms:
    """Return a polynomial of the ball's centre, from one of the point of contact.

    Parameters
    ----------
    inputs
        The inputs of the scene, to which coefficients are added.
    owner, argument
        As for `hoopgen.scene.inputs.Inputs.read`.
    given
        The polynomial as the author wrote it.
    there
        The map from the ball's centre to the point of contact; None for the centre itself.
    also
        What other names stand for. A parameter of such a name comes first.

    Raises
    ------
    SceneError
        If it is not a polynomial in x, y and z.
    """
    others = {other: value for other, value in also.items() if other not in inputs.declared}
    formula = inputs.read(owner, argument, given, (*POSITION, *others))
    try:
        if formula.names & others.keys():
            formula = formula.fold(
                {own: name(own) for own in formula.names} | others, constant, Formula.sqrt
            )
        found = polynomial(formula)
        if not any(map(any, found)):
            raise FormulaError(f"{formula} has none of x, y, z")
        found = (there or Map()).put(found)
    except FormulaError as error:
        raise inputs.wrong(owner, argument, error) from None
    flat = max(map(sum, found)) == 1
    named = []
    for powers, factor in sorted(found.items(), reverse=True):
        unit = "m" if flat and not any(powers) else "1"
        said = f"{argument} {_format_powers(powers)}".strip()
        named.append((powers, _factor(inputs, owner, said, factor, unit)))
    return tuple(named)


def _factor(inputs: Inputs, owner: str, argument: str, factor: Formula, unit: str) -> Formula:
    """Return a whole number unchanged, any other factor as an input."""
    number = factor.number
    if number is not None and number.denominator == 1 and abs(number) <= 16:
        return factor
    return inputs.add(owner, argument, factor, unit=unit)


def _axis(axis: int) -> Powers:
    powers = [int(k == axis) for k in range(3)]
    return powers[0], powers[1], powers[2]


def _format_powers(powers: Iterable[int]) -> str:
    return "".join(axis * power for axis, power in zip(POSITION, powers, strict=True))


def degrees(bounds: Iterable[Terms]) -> tuple[int, ...]:
    """Return the degree of each bound."""
    return tuple(max(sum(powers) for powers, _ in bound) for bound in bounds)


def linear_powers(axis: int) -> Powers:
    """Return the powers of the term that is a coordinate itself."""
    return _axis(axis)


def is_along(terms: Terms, axis: int) -> bool:
    """Return whether a bound only limits a body along an axis.

    Parameters
    ----------
    terms
        The bound.
    axis
        The axis, 0 to 2.
    """
    return {powers for powers, _ in terms} - {(0, 0, 0)} == {_axis(axis)}
