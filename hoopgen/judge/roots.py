"""Proof of the first root of a polynomial whose coefficients are balls.

Boxes of time are taken from the left. Descartes' rule of signs, through the map that takes the
box to (0, oo), proves that there is no root in a box, or exactly one; else the box is split. The
one root is then enclosed by Newton's method in intervals. No answer is guessed: where the signs of
balls stay unknown, the answer is "maybe, from here on".
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from flint import arb, arb_poly, ctx

from .taylor_model import Number, TaylorModel, ball, polynomial

_SPLIT_POINT = 0.48828125
"""Share of a box at which it is split: roots of simple shots fall on the middle, none does here."""

_MAP = arb_poly([1, 1])

_NARROWEST_OF_BOX = arb(2) ** -12
"""Share of a time interval below which it is not split for a box of releases: the box's width, not
the precision, decides what can be proved."""

_NEWTON_STEPS = 4
"""Each step of Newton's method about halves what is not linear in an enclosure, at first."""

_REACHES = (1.25, 2.0, 4.0)
"""Intervals about a root that are tried, in shares of the estimate of how far it moves in a box."""

Polynomial: TypeAlias = arb_poly | TaylorModel
"""A polynomial in the time, with balls or with models."""


class Undecided(Exception):
    """A decision that the balls cannot make at this precision; the message names it."""


@dataclass(frozen=True)
class Arrival:
    """A time at which there is an arrival or, if it is not certain, may be one.

    `onwards`: or at any later time.
    """

    time: Number
    certain: bool = True
    onwards: bool = False


def possible_from(time: arb) -> Arrival:
    """Return a possible arrival at a time or later."""
    return Arrival(time, certain=False, onwards=True)


def sign(number: Number) -> int | None:
    """Return 1, 0 or -1, or None if it is undecided."""
    if number > 0:
        return 1
    if number < 0:
        return -1
    return 0 if number.is_zero() else None


def root_bound(coefficients: Sequence[Number]) -> arb | None:
    """Return Fujiwara's bound on the size of all roots; None if the degree is not certain."""
    coefficients = [ball(coefficient) for coefficient in coefficients]
    leading = coefficients[-1]
    if not (leading > 0 or leading < 0):
        return None
    degree = len(coefficients) - 1
    largest = arb(0)
    for k, coefficient in enumerate(coefficients[:-1]):
        if not coefficient.is_zero():
            largest = largest.max((coefficient / leading).abs_upper().root(degree - k))
    return (2 * largest + 1).upper()


def descent(coefficients: Sequence[Number], moving: int | None) -> Arrival | None:
    """Return the arrival of a plane, in t > 0: the root where the polynomial falls.

    For degree two, the root of a t² + b t + c with the negative slope -sqrt(D) is
    2 c / (sqrt(D) - b) = -(b + sqrt(D)) / (2 a).

    Parameters
    ----------
    coefficients
        Coefficients of the polynomial in t, lowest power first.
    moving
        The sign of the constant term; None if it is undecided.
    """
    while coefficients and coefficients[-1].is_zero():
        coefficients = coefficients[:-1]
    if len(coefficients) < 2:
        return None
    c, b = coefficients[:2]
    if len(coefficients) == 2:
        falling = sign(b)
        if falling is None:
            return None if moving == -1 else possible_from(c.abs_lower() / b.abs_upper())
        time = -c / b if falling < 0 else None
    else:
        a = coefficients[2]
        discriminant = b * b - 4 * a * c
        certain = sign(discriminant)
        if certain in (0, -1):
            return None
        if certain is None:
            nearby = _apex(ball(b), ball(a), ball(discriminant))
            return None if nearby < 0 else Arrival(nearby, False)
        root = discriminant.sqrt()
        time = 2 * c / (root - b) if b < 0 else -(b + root) / (2 * a)
    if time is None or time < 0:
        return None
    return Arrival(time, time > 0)


def _apex(b: arb, a: arb, discriminant: arb) -> arb:
    """Return enclosures of both roots of a parabola that may touch zero."""
    reach = discriminant.abs_upper().sqrt() / (2 * abs(a))
    return -b / (2 * a) + arb(0, reach.abs_upper())


def first_arrival(coefficients: Sequence[Number], end: arb) -> Arrival | None:
    """Return the first root in (0, end) of a polynomial that is certainly positive at 0.

    There it goes from positive to negative. None is a proof that there is no root.

    Parameters
    ----------
    coefficients
        Coefficients, lowest power first.
    end
        The end of the interval.
    """
    condition = polynomial(coefficients)
    if isinstance(condition, TaylorModel):
        return _first_of_box(condition, end)
    return _first(condition, len(coefficients) - 1, end, arb(2) ** -(ctx.prec // 2))


def _first(condition: Polynomial, degree: int, end: arb, narrowest: arb) -> Arrival | None:
    """Return the first root; boxes of time are not split below a share of the whole."""
    boxes = [(arb(0), end)]
    while boxes:
        low, high = boxes.pop()
        fewest, most = sign_variations(condition, degree, low, high - low)
        if most == 0:
            continue
        if fewest == most == 1:
            return _enclose_root(condition, low, high)
        if not high - low > narrowest * end:
            return possible_from(low)
        split = (low + (high - low) * _SPLIT_POINT).mid()
        boxes += [(split, high), (low, split)]
    return None


def sign_variations(condition: Polynomial, degree: int, low: arb, width: arb) -> tuple[int, int]:
    """Return the fewest and the most sign changes of the polynomial mapped from the box.

    No root lies in the open box if there is none, exactly one if there is exactly one. With none
    the polynomial is positive there.

    Parameters
    ----------
    condition, degree
        The polynomial, of balls or of models, and its degree.
    low, width
        The lower end of the box and its width.
    """
    local = ball(condition(arb_poly([low, width]))).coeffs()
    local += [arb(0)] * (degree + 1 - len(local))
    mapped = arb_poly(local[::-1])(_MAP).coeffs()
    # Its constant is the value at the box's right end, its leading coefficient that at the left.
    return sign_changes(map(sign, reversed(mapped)))


def sign_changes(signs: Iterable[int | None]) -> tuple[int, int]:
    """Return the fewest and the most changes in signs some of which are unknown.

    Zeros do not count. Before the first of the signs stands a plus: the polynomial is positive up
    to its first root.
    """
    fewest = most = unknown = 0
    last = 1
    for now in signs:
        if now is None:
            unknown += 1
        elif now:
            change = now != last
            fewest += change
            # Up to unknown + 1 of them, and odd in number if the signs on both sides differ.
            most += unknown + (unknown % 2 != change)
            last, unknown = now, 0
    return fewest, most + unknown


def _first_of_box(condition: TaylorModel, end: arb) -> Arrival | None:
    """Return the first root for all releases of a box.

    A root for the middle of the box guides the search. Then it is proved that no release has one
    before an interval about it, and that each has exactly one in there.
    """
    coefficients = condition.coeffs()
    degree = len(coefficients) - 1
    guide = first_arrival([coefficient.mid() for coefficient in coefficients], end)
    if guide is not None and guide.certain:
        middle = guide.time.mid()
        local = condition(arb_poly([middle, 1]))
        step = ball(local).coeffs()[0] / ball(local.derivative()).coeffs()[0]
        reach = step.abs_upper() if step.is_finite() else middle
        for factor in _REACHES:
            low = (middle - factor * reach).mid().max(arb(0))
            high = (middle + factor * reach).mid()
            if not _falls_once(local, low - middle, high - middle):
                continue
            if low.is_zero() or _first(condition, degree, low, _NARROWEST_OF_BOX) is None:
                time = _newton(local, middle, low, high)
                return possible_from(low) if time is None else Arrival(time)
    return _first(condition, degree, end, _NARROWEST_OF_BOX)


def _falls_once(local: TaylorModel, low: arb, high: arb) -> bool:
    """Return whether a polynomial falls all the way from a positive to a negative value."""
    slope = local.derivative()(low.union(high))
    return bool(slope < 0 and local(low) > 0 and local(high) < 0)


def _newton(local: TaylorModel, middle: arb, low: arb, high: arb) -> TaylorModel | None:
    """Return the root in an interval that has exactly one, as a model; None if it finds none.

    By the mean value theorem t = m - p(m)/p'(ξ) with ξ between t and m (interval Newton). The
    first factor has the root's dependence on the release, as the implicit function theorem says.

    Parameters
    ----------
    local
        The polynomial, expanded about the middle.
    middle
        Where it is expanded.
    low, high
        The ends of the interval.
    """
    residue, slope = local.coeffs()[0], local.derivative()
    since = (low - middle).union(high - middle)
    found = None
    for _ in range(_NEWTON_STEPS):
        offset = -(residue / slope(since))
        if not offset.is_finite():
            break
        since = since.intersection(offset.range).union(arb(0))
        found = offset + middle
    return found


def _enclose_root(condition: Polynomial, low: arb, high: arb) -> Arrival:
    """Return an enclosure of the only root in the box; without one, an uncertain arrival."""
    if isinstance(condition, TaylorModel):
        middle = ((low + high) / 2).mid()
        found = _newton(condition(arb_poly([middle, 1])), middle, low, high)
        return possible_from(low) if found is None else Arrival(found)
    slope = condition.derivative()
    middle = _approximate(condition, slope, low, high)
    residue = condition(middle)
    step = residue / slope(middle)
    if step.is_finite():
        # Of a short exact polynomial the step may be smaller than the roundings of the enclosure.
        rounding = abs(middle) * arb(2) ** (2 - ctx.prec) + arb(2) ** -(2 * ctx.prec)
        room = middle + arb(0, (2 * step.abs_upper() + rounding).upper())
        enclosure = middle - residue / slope(room)
        if enclosure.is_finite() and room.contains(enclosure) and low <= room and room <= high:
            return Arrival(enclosure)
    return possible_from(low)


def _approximate(polynomial: arb_poly, slope: arb_poly, low: arb, high: arb) -> arb:
    """Return a number near the root; nothing is proved here.

    Newton's steps; where one leaves the bracket or does not shrink, the bracket is halved.
    """
    middle = ((low + high) / 2).mid()
    last = high - low
    near = arb(2) ** -(ctx.prec // 2)
    for _ in range(2 * ctx.prec):
        value = polynomial(middle)
        if value > 0:
            low = middle
        elif value < 0:
            high = middle
        else:
            break
        there = (middle - value / slope(middle)).mid()
        size = abs(there - middle)
        if size <= near * middle:  # the next step doubles the digits, and is the last
            return (there - polynomial(there) / slope(there)).mid()
        if low < there and there < high and size <= last / 2:
            middle, last = there, size
        else:
            middle, last = ((low + high) / 2).mid(), high - low
    return middle
