"""Certificates: proved sequences of contacts, and enclosures of times and states."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from flint import arb, ctx
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.event_log import Event
from hoopgen.generated.numpy import hoop
from hoopgen.text.numbers import format_count

if TYPE_CHECKING:
    from hoopgen.results.shots import Shots

UNDECIDED = 255
"""Value of `Certificate.outcome` where no outcome was proved."""

EVENT_ERRORS = np.dtype(
    [
        ("shot", np.int64),
        ("surface", np.int64),
        ("time_error", np.float64),
        ("before_error", np.float64, 3),
        ("after_error", np.float64, 3),
    ]
)
"""A row of bounds; those of states are on position, velocity and spin."""


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


class Certificate:
    """Proofs of a batch: arrays by shot, and each shot's own by index.

    Every result of a simulation that the judge knows is here under its name.

    Attributes
    ----------
    proofs
        `Proof` by shot.
    decided
        bool (n,), every decision was proved.
    bits
        int32 (n,), the precision that this took; undecided: the last one tried.
    outcome
        uint8 (n,), an `Outcome`, or `UNDECIDED`.
    contacts, counts, first
        As in `Shots`; of an undecided shot, as far as it is proved.
    until
        float64 (n,), s since the release: the time of the last event that is proved, 0 if none is.
    accumulates
        bool (n,), the proof ends because bounces accumulate: from there the ball rolls, which the
        judge does not follow. Such a shot is undecided; `Proof.question` says on what it rolls.
    rolls, airless_rolls, slip_left, grip_lost
        As in `Shots`: no ball rolls or ends with slip left of whose shot the outcome is proved.
    time, time_radius
        float64 (n,), s: the doubles nearest to the proved times, and how far the truth can be from
        those. NaN where undecided or invalid.
    state, state_radius
        float64 (n, 9), likewise.
    uncertain, time_error, state_error
        As in `Shots`, of what is proved: bool (n,), float64 (n,) and (n, 3).
    """

    rolls: NDArray[np.int32]
    airless_rolls: NDArray[np.bool_]
    slip_left: NDArray[np.bool_]
    grip_lost: NDArray[np.float64]

    def __init__(
        self, proofs: Sequence[Proof], bodies: int, releases: NDArray[np.float64], scene: str
    ) -> None:
        self.proofs = tuple(proofs)
        self._releases, self._scene = releases, scene
        shots = len(proofs)
        outcome = np.array([p.outcome for p in proofs], np.uint8)
        self.outcome: NDArray[np.uint8] = outcome
        self.decided: NDArray[np.bool_] = outcome != UNDECIDED
        self.bits: NDArray[np.int32] = np.array([p.bits for p in proofs], np.int32)
        counts = np.zeros((shots, bodies + 1), np.int32)
        for row, proof in zip(counts, proofs, strict=True):
            row[:] = np.bincount(proof.surfaces, minlength=len(row)) if proof.surfaces else 0
        self.counts: NDArray[np.int32] = np.ascontiguousarray(counts[:, :-1])
        self.contacts: NDArray[np.int32] = self.counts.sum(axis=1, dtype=np.int32)
        first = [p.surfaces[0] if p.surfaces else -1 for p in proofs]
        self.first = np.array([-1 if k == bodies else k for k in first], np.int8)
        self.until: NDArray[np.float64] = np.array([p.until for p in proofs], float)
        self.accumulates: NDArray[np.bool_] = np.array([p.accumulates for p in proofs], np.bool_)
        # What the judge has proved to an end has bounced all the way.
        for result in (*hoop.RESULTS, *hoop.ABSENT_RESULTS):
            if result.proved is not None:
                setattr(self, result.name, np.full(shots, result.proved, result.dtype))
        self.time: NDArray[np.float64] = np.array([p.time for p in proofs], float)
        self.time_radius: NDArray[np.float64] = np.array([p.time_radius for p in proofs], float)
        states = [p.state for p in proofs], [p.state_radii for p in proofs]
        self.state, self.state_radius = (np.array(s, float).reshape(shots, 9) for s in states)

    @check_arguments
    def agrees(self, shots: Shots) -> NDArray[np.bool_]:
        """Return a mask of the shots that are as proved, or are marked as uncertain.

        A shot that rolls, or whose bounces have ended with slip left, is compared as far as both
        go: until it rolls, and until the proof ends (`until`). No outcome is proved of it.

        Parameters
        ----------
        shots
            Of the same releases; with their event log, ``record=True``.

        Returns
        -------
        ndarray
            bool (n,): the same surfaces in the same order, and the same outcome; or uncertain. Of
            an undecided proof, that the shot is uncertain; of one that ends because bounces
            accumulate, that the shot's impacts are those proved, as far as both go.

        Raises
        ------
        ValueError
            If they are not as many.
        AttributeError
            If they have no event log, or were simulated without "outcome" or "uncertain".
        """
        self._check_as_many(shots)
        ends = np.searchsorted(shots.events["shot"], np.arange(1, len(self)))
        found = np.split(shots.events, ends) if len(self) else []
        proved = [proof.surfaces for proof in self.proofs]
        same = [list(one["surface"]) == own for one, own in zip(found, proved, strict=True)]
        right = self.decided & (shots.outcome == self.outcome) & np.array(same, np.bool_)
        capped = int(shots.scene.outcomes["CAPPED"])
        slipping = getattr(shots, "slip_left", np.zeros(len(self), np.bool_))
        for shot, (one, own) in enumerate(zip(found, proved, strict=True)):
            begun = np.flatnonzero(one["kind"] == Event.ROLL)
            if not len(begun) and slipping[shot]:
                begun = np.array([len(one)])
            given_up = not self.decided[shot] or self.outcome[shot] == capped
            if self.accumulates[shot] or (len(begun) and given_up):
                until = min(int(begun[0]) if len(begun) else len(one), len(own))
                right[shot] = list(one["surface"][:until]) == own[:until]
        return np.asarray(right | shots.uncertain)

    @check_arguments
    def event_errors(self, shots: Shots) -> NDArray[np.void]:
        """Return proved bounds on the errors of each recorded event of simulated shots.

        This is a theorem for each row whose bounds are numbers: the exact shot from the given
        doubles has met the same surfaces in the same order up to this event, and its time and its
        states at this event differ from the recorded ones by no more than the bounds. Nothing is
        estimated, and the flag `uncertain` plays no part.

        Parameters
        ----------
        shots
            Of the same releases and parameters; with their event log, ``record=True``.

        Returns
        -------
        ndarray
            Structured, a row for each row of ``shots.events``, in its order: "shot", "surface",
            "time_error" (s), and "before_error" and "after_error", the largest error of any
            component of position (m), velocity (m/s) and spin (rad/s), (3,) each. They are NaN in
            rows of which nothing is proved: from the first event on that is not as proved, after
            the proof ends, and from a roll on.

        Raises
        ------
        ValueError
            If they are not as many, are of another scene or of other releases, or if the proofs are
            without ``record=True``.
        AttributeError
            If the shots have no event log.
        """
        self._check_as_many(shots)
        if shots.scene.name != self._scene:
            raise ValueError(
                f"shots: expected shots in the scene {self._scene}, which was proved; got some in "
                f"{shots.scene.name}"
            )
        own, given = self._releases, shots.releases
        same = (given == own) | (np.isnan(given) & np.isnan(own))
        if not same.all():
            row = int(np.flatnonzero(~same.all(axis=1))[0])
            raise ValueError(
                f"shots: expected the releases that were proved; that of shot {row} is another"
            )
        return _event_errors(self.proofs, shots.events)

    def _check_as_many(self, shots: Shots) -> None:
        if len(shots) != len(self):
            raise ValueError(
                f"shots: expected {len(self)}, as many as were proved; got {len(shots)}"
            )

    @property
    def uncertain(self) -> NDArray[np.bool_]:
        """A mask of the shots with a decision that is not proved."""
        return ~self.decided

    @property
    def time_error(self) -> NDArray[np.float64]:
        """The radii of the times, s."""
        return self.time_radius

    @property
    def state_error(self) -> NDArray[np.float64]:
        """The largest radius of each of position, velocity and spin."""
        largest: NDArray[np.float64] = self.state_radius.reshape(-1, 3, 3).max(axis=2)
        return largest

    def __len__(self) -> int:
        return len(self.proofs)

    def __getitem__(self, shot: int) -> Proof:
        return self.proofs[shot]

    def __repr__(self) -> str:
        rolling = int(self.accumulates.sum())
        until_rolling = f", {rolling:,} until they roll" if rolling else ""
        decided = f"{int(self.decided.sum()):,} decided"
        return f"Certificate({format_count(len(self), 'shot')}, {decided}{until_rolling})"


def _event_errors(proofs: Sequence[Proof], events: NDArray[np.void]) -> NDArray[np.void]:
    """Return proved bounds on the errors of each row of an event log.

    A bound is the upper end of a ball that holds the difference between the recorded number, an
    exact double, and the proved enclosure of the true one. It is rounded up to a double.

    Parameters
    ----------
    proofs
        Of the same shots, with their events.
    events
        The log, sorted by shot.

    Returns
    -------
    ndarray
        `EVENT_ERRORS`, a row for each row of the log; NaN where nothing is proved of it.

    Raises
    ------
    ValueError
        If the proofs have no events.
    """
    if any(proof.surfaces and not proof.events for proof in proofs):
        raise ValueError("event_errors needs the proved events: certify(..., record=True)")
    found = np.zeros(len(events), EVENT_ERRORS)
    found["shot"], found["surface"] = events["shot"], events["surface"]
    for name in ("time_error", "before_error", "after_error"):
        found[name] = math.nan
    ends = np.searchsorted(events["shot"], np.arange(len(proofs) + 1))
    for proof, (start, end) in zip(proofs, pairwise(ends.tolist()), strict=True):
        _bound(proof, events[start:end], found[start:end])
    return found


def _bound(proof: Proof, events: NDArray[np.void], found: NDArray[np.void]) -> None:
    """Write the bounds of one shot, as far as its events are those that are proved.

    Rows of a roll end the comparison: the judge follows impacts.
    """
    with ctx.workprec(4 * proof.bits):  # no digit of an enclosure is lost
        for row, proved, bounds in zip(events, proof.events, found, strict=False):
            if row["surface"] != proved.surface or row["kind"] not in (Event.IMPACT, Event.END):
                return
            bounds["time_error"] = _largest(proved, "time", [float(row["time"])])
            for name in ("before", "after"):
                state = row[name].tolist()
                bounds[f"{name}_error"] = [
                    _largest(proved, name, state[k : k + 3], k) for k in (0, 3, 6)
                ]


def _largest(proved: ProvedEvent, name: str, numbers: Sequence[float], first: int = 0) -> float:
    """Return a bound on the distance of each number from its enclosure."""
    value = getattr(proved, name)
    enclosures = [value] if name == "time" else value[first : first + len(numbers)]
    away = [
        abs(one.ball - arb(number)).upper() for one, number in zip(enclosures, numbers, strict=True)
    ]
    largest = max(away)
    # The conversion rounds to nearest, at worst half a unit down.
    return 0.0 if largest == 0 else math.nextafter(float(largest), math.inf)
