"""First roots of the event polynomials of many flights, isolated with balls of doubles.

**Lemma (first contact with a body).** Let p be a polynomial of degree n: the condition F of a
flight that begins off the body, or F/t of one that begins on it. De Casteljau's halving gives its
Bernstein coefficients on each dyadic part of [0, L]. A part whose coefficients are all positive has
no root, since the values of p there are convex combinations of them. A part whose coefficients
change sign once has exactly one root, by Descartes' rule. So if one part has exactly one root, and
all parts before it have positive coefficients, the body is first met there; and it is not met in
[0, L] if all coefficients of parts that cover it are positive. ∎

*Between departure and return.* On a return the exact ball is on the body at t = 0: F(0) = 0,
whatever is known of its place. F/t has no such coefficient, so that an error along the surface is
no offset from it. No expansion along the surface is needed, of first or second order: the balls of
the other coefficients hold what is not known.

*Roundings.* On [0, L] the coefficients are b_i = sum_k w_ik c_k L^k with 0 <= w_ik <= 1. The power,
the weight, two products and the sum have at most 2 n + 2 <= 4 n roundings. With B the sum of all
|c_k| L^k, 5 n u B and the radii r_k L^k bound the error of each, and no coefficient of a part is
larger than B. A halving takes means of two numbers, n times one after another: it rounds by at most
u B each time (halves are exact), and a mean does not enlarge the errors of both. So the error of
all coefficients on all parts is at most the sum of r_k L^k and (`MAX_HALVINGS` + 5) n u B.

**Lemma (planes).** The gap of a plane is c + b t + a t². Where a = 0 or a < 0 it falls through zero
at most once in t > 0: for a = 0 at t = -c/b if c > 0 > b; for a < 0 at the larger root,
2 c/(sqrt(D) - b) = -(b + sqrt(D))/(2 a) with D = b² - 4 a c, if D > 0 and this is positive. On a
return c = 0 exactly, and the time is -b/a, or none. Where it is not certain that b < 0, the time is
at least c/|b|; where it is not certain that D > 0, at least that of the apex, -b/(2 a). Planes from
which gravity pulls the ball off are left undecided. ∎
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from math import comb

import numpy as np

from .ball_array import INWARDS, OUTWARDS, TINY, UNIT, BallArray, Bools, Floats, where

MAX_HALVINGS = 28
"""A flight whose first root is not isolated after these is undecided."""

MAX_PARTS = 8
"""A flight with more parts of the same length that may have a root is undecided: coefficients are
not known well enough to tell."""

_NEWTON_STEPS = 40

_NEAR = 2.0**-36
"""Share of a time by which Newton's last step in doubles may change it: the next step, of a number
with twice as many digits, doubles them."""


@cache
def _to_bernstein(degree: int) -> Floats:
    """Return the matrix from coefficients of powers to Bernstein coefficients."""
    powers = range(degree + 1)
    return np.array([[comb(i, k) / comb(degree, k) for k in powers] for i in powers])


@dataclass(frozen=True)
class Arrivals:
    """Arrivals of many flights at one surface.

    Attributes
    ----------
    time
        The times, s; of use where `certain`.
    certain
        Where there is an arrival then.
    earliest
        No arrival is before this time; infinite where there is none, (n,), s.
    """

    time: BallArray
    certain: Bools
    earliest: Floats


def plane_arrivals(coefficients: Sequence[BallArray], leaving: Bools) -> Arrivals:
    """Return the arrivals at a plane, whatever its bounds say.

    Parameters
    ----------
    coefficients
        Of the gap, lowest power first, two or three.
    leaving
        Where the flight begins on the plane, (n,).
    """
    c, b = coefficients[:2]
    unknown = np.full(len(leaving), 0.0)
    if len(coefficients) == 2:
        time = -c / b
        falls = b.negative() & c.positive() & ~leaving
        never = b.positive() | (c.negative() & ~leaving)
        later = np.where(c.positive() & ~leaving, c.least_size() / b.size() * INWARDS, unknown)
        return _arrivals(time, falls, never, later)
    a = coefficients[2]
    squared = b * b - a * c * 4
    root = squared.sqrt()
    downwards = np.broadcast_to(b.middle < 0, leaving.shape)  # then this form cancels less
    time = where(downwards, c * 2 / (root - b), -(b + root) / (a * 2))
    time = where(leaving, -b / a, time)
    curved = a.negative()
    falls = curved & np.where(leaving, b.positive(), squared.positive() & time.positive())
    never = curved & ~leaving & (squared.negative() | (squared.positive() & time.negative()))
    later = np.where(curved & ~leaving, (-b / (a * 2)).lower(), unknown)
    return _arrivals(time, falls, never, later)


def _arrivals(time: BallArray, falls: Bools, never: Bools, later: Floats) -> Arrivals:
    earliest = np.where(falls, time.lower(), np.where(never, np.inf, np.maximum(later, 0.0)))
    return Arrivals(time, falls, np.where(np.isnan(earliest), 0.0, earliest))


@dataclass(frozen=True)
class Isolated:
    """Parts of time that have one root each, the first.

    Attributes
    ----------
    found
        Where there is a first root.
    none
        Where there is certainly no root. Flights in neither are undecided.
    low, high
        The ends of the parts, s; the root is between them.
    """

    found: Bools
    none: Bools
    low: Floats
    high: Floats


def first_roots(coefficients: Sequence[BallArray], end: Floats) -> Isolated:
    """Return a part of [0, end] that has the first root of a polynomial and no other, by flight.

    Parameters
    ----------
    coefficients
        Lowest power first.
    end
        (n,), s.
    """
    shots, degree = len(end), len(coefficients) - 1
    bernstein, error = _bernstein(coefficients, end)
    found, undecided = np.zeros(shots, np.bool_), ~np.isfinite(error)
    rows = np.flatnonzero(~undecided)
    bernstein, place, share = bernstein[:, rows], np.zeros(len(rows)), 1.0
    low, high = np.full(shots, np.inf), np.full(shots, np.inf)
    for _ in range(MAX_HALVINGS):
        positive, negative = bernstein > error[rows], -bernstein > error[rows]
        # All positive up to some coefficient, all negative from the next but one on.
        leading = np.cumprod(positive, axis=0).sum(axis=0)
        trailing = np.cumprod(negative[::-1], axis=0).sum(axis=0)
        one = (leading > 0) & (trailing > 0) & (leading + trailing >= degree)
        at, begins = rows[one], place[one] * share
        nearer = begins < low[at]
        at = at[nearer]
        np.minimum.at(low, at, begins[nearer])
        high[at], found[at] = low[at] + share, True
        # What comes after a root that was found does not matter.
        left = ~one & (leading <= degree) & (place * share < low[rows])
        undecided |= np.bincount(rows[left], minlength=shots) > MAX_PARTS
        left &= ~undecided[rows]
        bernstein, rows, place = bernstein[:, left], rows[left], place[left]
        if not len(rows):
            break
        halves = _halved(bernstein)
        bernstein = np.concatenate(halves, axis=1)
        rows, place = np.tile(rows, 2), np.concatenate([2 * place, 2 * place + 1])
        share /= 2
    undecided[rows] = True
    return Isolated(found & ~undecided, ~(found | undecided), low * end, high * end)


def _bernstein(coefficients: Sequence[BallArray], end: Floats) -> tuple[Floats, Floats]:
    """Return the Bernstein coefficients on [0, end] and one bound on their errors, by flight."""
    degree, powers = len(coefficients) - 1, [np.ones_like(end)]
    for _ in coefficients[1:]:
        powers.append(powers[-1] * end)
    middles = np.array([c.middle * power for c, power in zip(coefficients, powers, strict=True)])
    radii = np.array([c.radius * power for c, power in zip(coefficients, powers, strict=True)])
    roundings = (MAX_HALVINGS + 5) * degree * UNIT * np.abs(middles).sum(axis=0)
    error = radii.sum(axis=0) + roundings
    return _to_bernstein(degree) @ middles, np.asarray(error * OUTWARDS + TINY)


def _halved(own: Floats) -> tuple[Floats, Floats]:
    """Return the Bernstein coefficients on both halves of a part (de Casteljau)."""
    left, right = [own[0]], [own[-1]]
    while len(own) > 1:
        own = (own[:-1] + own[1:]) * 0.5
        left.append(own[0])
        right.append(own[-1])
    return np.array(left), np.array(right[::-1])


def near_roots(coefficients: Sequence[BallArray], low: Floats, high: Floats) -> Floats:
    """Return numbers near roots where polynomials fall; nothing is proved here.

    Newton's method; where a step leaves the bracket, the bracket is halved.

    Parameters
    ----------
    coefficients
        Lowest power first.
    low, high
        The ends of the brackets, (n,), s.
    """
    middles = np.array([np.broadcast_to(c.middle, low.shape) for c in coefficients])
    slopes = middles[1:] * np.arange(1.0, len(coefficients))[:, None]
    time = (low + high) / 2
    for _ in range(_NEWTON_STEPS):
        value, slope = (_in_doubles(own, time) for own in (middles, slopes))
        low, high = np.where(value > 0, time, low), np.where(value > 0, high, time)
        step = value / slope
        there = time - step
        inside = (there > low) & (there < high)
        there = np.where(inside, there, (low + high) / 2)
        if np.all(np.abs(there - time) <= _NEAR * np.abs(time)):
            return there
        time = there
    return time


def _in_doubles(coefficients: Floats, time: Floats) -> Floats:
    found = coefficients[-1]
    for coefficient in coefficients[-2::-1]:
        found = found * time + coefficient
    return np.asarray(found)
