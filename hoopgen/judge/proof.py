"""Proofs of single shots: enclosures, proved events, and what is proved of a shot."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from flint import arb, ctx

UNDECIDED = 255
"""Value of `Certificate.outcome` where no outcome was proved."""


class Enclosure(NamedTuple):
    """A real number proved to be within (middle ± radius) 2^exponent; all three whole numbers."""

    middle: int
    radius: int
    exponent: int

    @property
    def ball(self) -> arb:
        """The enclosure as an Arb ball."""
        with ctx.workprec(max(64, self.middle.bit_length())):
            scale = arb(2) ** self.exponent
            return arb(self.middle) * scale + arb(0, arb(self.radius) * scale)

    def __float__(self) -> float:
        return float(self.ball)

    def __str__(self) -> str:
        """Return the decimal digits that are proved, at most 40."""
        text: str = self.ball.str(40, radius=False)
        return text


def enclosure(ball: arb) -> Enclosure:
    """Return a finite ball as an enclosure."""
    middle, place = map(int, ball.mid().man_exp())
    radius, radius_place = map(int, ball.rad().man_exp())
    if not radius:
        return Enclosure(middle, 0, place)
    exponent = min(place, radius_place)
    return Enclosure(middle << (place - exponent), radius << (radius_place - exponent), exponent)


def doubles(balls: Sequence[arb]) -> tuple[list[float], list[float]]:
    """Return the doubles nearest to the balls' middles, and bounds on their errors."""
    nearest = [float(ball) for ball in balls]
    away = [(ball - arb(n)).abs_upper() for ball, n in zip(balls, nearest, strict=True)]
    # An upper bound, rounded to nearest and then up once.
    return nearest, [0.0 if a.is_zero() else math.nextafter(float(a), math.inf) for a in away]


class ProvedEvent(NamedTuple):
    """A contact or the end: surface, time since the release, states before and after, (9,)."""

    surface: int
    time: Enclosure
    before: tuple[Enclosure, ...]
    after: tuple[Enclosure, ...]


@dataclass(frozen=True)
class Proof:
    """The proof of one shot.

    Attributes
    ----------
    outcome
        Its number among the scene's outcomes (`Outcome`), or `UNDECIDED`.
    bits
        The precision at which every decision was proved, 106 for shots proved at once; if
        undecided, the last one tried.
    question
        Why the proof ends before the shot does: what could not be decided, or that bounces
        accumulate and the ball rolls from there. Empty if every decision was proved.
    surfaces, times, time_radii
        Of the events, as far as they are proved, the end included: index of the surface, the
        double nearest to the time (s), and how far the truth can be from that.
    time, time_radius
        As `Shots.time`, and how far the truth can be from it; NaN if undecided or invalid.
    state, state_radii
        As `Shots.state`, likewise.
    events
        With record: the events with all digits.
    hops
        Where bounces accumulate: the index of the first event of a run of hops that are too small
        to be told from rolling; else -1.
    """

    outcome: int
    bits: int
    question: str
    surfaces: list[int]
    times: list[float]
    time_radii: list[float]
    time: float
    time_radius: float
    state: list[float]
    state_radii: list[float]
    events: tuple[ProvedEvent, ...]
    hops: int = -1

    @property
    def decided(self) -> bool:
        """True if every decision was proved, and so is the outcome."""
        return self.outcome != UNDECIDED

    @property
    def accumulates(self) -> bool:
        """True if the proof ends because bounces accumulate: from there the ball rolls."""
        return self.hops >= 0

    @property
    def until(self) -> float:
        """The time of the last event that is proved, s since the release; 0 if there is none."""
        return self.times[-1] if self.times else 0.0
