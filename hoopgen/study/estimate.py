"""`estimate`: how probably a shot is made; `compare`: which of two settings is made more often.

Every share is of shots that were drawn by index, so that a result can be had again, and two
settings compared over the same random numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import closing
from dataclasses import asdict, dataclass
from fractions import Fraction
from math import ceil, inf, nan, sqrt
from os import PathLike
from typing import Any, Literal, TypeAlias

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray
from scipy.special import ndtri

from hoopgen.brief import brief
from hoopgen.inputs import check_contacts, check_count
from hoopgen.notebook import Said
from hoopgen.parameters import PAPER
from hoopgen.phrases import decimals, doubtful, interval, percent, points
from hoopgen.results import Outcome, Shots
from hoopgen.simulation import simulate
from hoopgen.sizes import in_short

from .chunks import run
from .draws import check_seed
from .measures import Kind
from .models import Grid, ReleaseModel
from .tallies import COLUMNS, FIELDS, Tally, blocks, check_scene, check_share, wilson
from .told import footer, told_setting
from .words import for_json

__all__ = [
    "CHUNK",
    "Comparison",
    "Estimate",
    "Setting",
    "compare",
    "estimate",
    "least_shots",
    "most_shots",
    "newcombe",
]

CHUNK = 1 << 17
"""Shots in a chunk: after each one the precision is looked at, and a folder has one file."""

SHOTS = 100_000
"""Without a precision."""

MOST = 1_000_000_000
"""With a precision."""

Setting: TypeAlias = ReleaseModel | tuple[ReleaseModel, Mapping[str, Any]]
"""A release model in the article's scene, or with parameters of its own."""

Backend = Literal["auto", "c", "numpy"]
Progress = Callable[[int, int | None], None]


@dataclass(frozen=True, repr=False)
class Estimate(Said):
    """How probably a shot is made.

    An invalid shot is no trial: `probability` is of the others. A capped one is a trial and not
    made, since the model does not decide it; `with_capped` is the probability if all had gone in.

    Attributes
    ----------
    probability
        made / (shots - invalid); NaN if all are invalid.
    low, high
        Wilson's interval of it.
    confidence
        Of the interval.
    shots
        Drawn.
    made, missed, capped, short, invalid
        Of them, by outcome.
    uncertain
        With a decision within its rounding-error bound.
    uncertain_capped
        Capped ones among those.
    kinds, kinds_made
        Shots by the name of their `Kind`, all and made.
    seed
        Of the random numbers.
    setting
        Release model and parameters.
    """

    probability: float
    low: float
    high: float
    confidence: float
    shots: int
    made: int
    missed: int
    capped: int
    short: int
    invalid: int
    uncertain: int
    uncertain_capped: int
    kinds: Mapping[str, int]
    kinds_made: Mapping[str, int]
    seed: int
    setting: Mapping[str, Any]

    @property
    def shares(self) -> dict[str, float]:
        """Shares of the kinds among all shots."""
        return {name: count / self.shots for name, count in self.kinds.items()}

    @property
    def with_capped(self) -> float:
        """Probability if all capped shots had been made."""
        valid = self.shots - self.invalid
        return (self.made + self.capped) / valid if valid else nan

    @property
    def half_width(self) -> float:
        """Half the width of the interval."""
        return 0.5 * (self.high - self.low)

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows; None for what is not a number."""
        more: dict[str, Any] = {"with_capped": self.with_capped, "shares": self.shares}
        more["scene"] = told_setting(self.setting)["scene"]
        return {name: for_json(value) for name, value in (asdict(self) | more).items()}

    def __str__(self) -> str:
        digits = decimals(self.half_width)
        ended = (outcome.name.lower() for outcome in Outcome)
        counts = [f"{getattr(self, name):,} {name}" for name in ended]
        counts.append(doubtful(self.uncertain, self.uncertain_capped))
        lines = [
            f"made     {percent(self.probability, digits)}, "
            f"{interval(self.low, self.high, digits)} "
            f"(Wilson's {percent(self.confidence, None)} interval)",
            f"shots    {self.shots:,}: {', '.join(counts)}",
            *([f"capped   {percent(self.with_capped, digits)} if made"] if self.capped else []),
            "",
            "kind         share  of it made",
        ]
        lines += [
            f"{name.replace('_', ', '):10}  {percent(self.shares[name]):>6}"
            f"  {percent(self.kinds_made[name] / count):>10}"
            for name, count in self.kinds.items()
            if count
        ]
        return "\n".join([*lines, "", footer(_NAMES, _told(self))])


@dataclass(frozen=True, repr=False)
class Comparison(Said):
    """What the second of two settings adds to the first, over the same random numbers.

    Attributes
    ----------
    difference
        Probability of the second less that of the first, over pairs of valid shots; NaN without.
    low, high
        Its interval: Newcombe's hybrid score interval for paired data (1998), method 10.
    confidence
        Of the interval.
    both, only_first, only_second, neither
        Pairs by what was made.
    first, second
        Each setting by itself.
    """

    difference: float
    low: float
    high: float
    confidence: float
    both: int
    only_first: int
    only_second: int
    neither: int
    first: Estimate
    second: Estimate

    @property
    def pairs(self) -> int:
        """Pairs in which neither shot is invalid."""
        return self.both + self.only_first + self.only_second + self.neither

    @property
    def half_width(self) -> float:
        """Half the width of the interval."""
        return 0.5 * (self.high - self.low)

    @property
    def gain(self) -> float:
        """How many times as many shots it would take without common random numbers.

        The ratio of the variances of the difference; infinite where no pair differs.
        """
        n = self.pairs
        first, second = self.both + self.only_first, self.both + self.only_second
        alone = first * (n - first) + second * (n - second)
        paired = n * (self.only_first + self.only_second) - (second - first) ** 2
        return alone / paired if paired else inf

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows; None for what is not a number."""
        settings = {"first": self.first.as_dict(), "second": self.second.as_dict()}
        more = {"pairs": self.pairs, "gain": self.gain, **settings}
        return {name: for_json(value) for name, value in (asdict(self) | more).items()}

    def __str__(self) -> str:
        digits = decimals(self.half_width)
        made = [percent(one.probability, digits) for one in (self.first, self.second)]
        ends = f"{points(self.low, digits)} to {points(self.high, digits)}"
        return "\n".join(
            [
                f"first       {made[0]} made",
                f"second      {made[1]} made",
                f"difference  {points(self.difference, digits)} points, {ends} "
                f"(Newcombe's paired {percent(self.confidence, None)} interval)",
                f"pairs       {self.pairs:,}: {self.both:,} both made, "
                f"{self.only_first:,} the first only, {self.only_second:,} the second only, "
                f"{self.neither:,} neither",
                f"gain        worth {self.gain:.3g} times the shots without common random numbers",
                "",
                footer(_NAMES + 3, _told(self.first), _told(self.second)),
            ]
        )


def estimate(
    model: ReleaseModel,
    parameters: Mapping[str, Any] = PAPER,
    *,
    shots: int | None = None,
    precision: float | None = None,
    confidence: float = 0.95,
    seed: int = 0,
    max_contacts: int = 40,
    backend: Backend = "auto",
    threads: int | None = None,
    folder: str | PathLike[str] | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> Estimate:
    """Estimate how probably a shot is made.

    Parameters
    ----------
    model
        Where the shots come from: `Scatter`, `Resample`, or one of your own.
    parameters
        Of the scene, one number each.
    shots
        How many; with a precision, at most. By default 100,000; with a precision 10^9.
    precision
        Stop as soon as half the interval is no wider; looked at after every `CHUNK` shots.
    confidence
        Of the interval, within 0 and 1.
    seed
        From 0 to 2^64 - 1. One seed gives one result, whatever computes it.
    max_contacts, backend
        As for `hoopgen.simulate`.
    threads, folder, scheduler
        Who computes, and where finished chunks are kept and gone on from; see `chunks.run`.
    progress
        Called with the chunks that are done and their number, as far as that is known.

    Returns
    -------
    Estimate
        Probability, interval, and shots by outcome and kind.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    settings = (_setting(model, parameters),)
    level = check_share("confidence", confidence)
    contacts = check_contacts(max_contacts)
    most = most_shots(shots, precision, level)
    work = _Work(settings, most, check_seed(seed), contacts, backend)
    until = _Until(precision, lambda total: _estimate(work, total, 0, level).half_width, progress)
    total = until.total(work, folder, scheduler, threads)
    return _estimate(work, total, 0, level)


def compare(
    first: Setting,
    second: Setting,
    *,
    shots: int | None = None,
    precision: float | None = None,
    confidence: float = 0.95,
    seed: int = 0,
    max_contacts: int = 40,
    backend: Backend = "auto",
    threads: int | None = None,
    folder: str | PathLike[str] | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> Comparison:
    """Compare two settings by common random numbers: shot i of both draws the same.

    Parameters
    ----------
    first, second
        A release model, or a pair of it and the parameters of its scene.
    precision
        Stop as soon as half the interval of the difference is no wider.
    shots, confidence, seed, max_contacts, backend, threads, folder, scheduler, progress
        As for `estimate`.

    Returns
    -------
    Comparison
        The difference of the probabilities, the second less the first.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    settings = tuple(
        _setting(*one) if isinstance(one, tuple) else _setting(one, PAPER)
        for one in (first, second)
    )
    level = check_share("confidence", confidence)
    contacts = check_contacts(max_contacts)
    most = most_shots(shots, precision, level, paired=True)
    work = _Work(settings, most, check_seed(seed), contacts, backend)
    until = _Until(precision, lambda total: _comparison(work, total, level).half_width, progress)
    total = until.total(work, folder, scheduler, threads)
    return _comparison(work, total, level)


# ------------------------------------------------------------------------------------ the work


@dataclass(frozen=True)
class _Set:
    """A release model and the parameters of its scene."""

    model: ReleaseModel
    parameters: Mapping[str, float]

    def identity(self) -> dict[str, Any]:
        return {**self.model.identity(), "parameters": dict(self.parameters)}


@dataclass(frozen=True)
class _Work:
    """A job of `chunks.run`: the tallies of one or two settings, and how their shots pair."""

    settings: tuple[_Set, ...]
    shots: int
    seed: int
    max_contacts: int
    backend: Backend

    @property
    def chunks(self) -> int:
        """How many."""
        return -(-self.shots // CHUNK)

    def identity(self) -> dict[str, Any]:
        """Return what the chunks depend on."""
        return {
            "settings": [setting.identity() for setting in self.settings],
            "shots": self.shots,
            "seed": self.seed,
            "max_contacts": self.max_contacts,
        }

    def compute(self, chunk: int) -> pa.Table:
        """Return the numbers of a chunk: one row."""
        start = chunk * CHUNK
        stop = min(start + CHUNK, self.shots)
        total = np.sum([self.count(*block) for block in blocks(start, stop)], axis=0)
        return pa.table({"numbers": pa.array([total], pa.list_(pa.int64()))})

    def count(self, start: int, stop: int) -> NDArray[np.int64]:
        """Return the tally of each setting, and of two the pairs, of some shots."""
        results = [self._simulate(setting, start, stop) for setting in self.settings]
        rows = [Tally.of(shots, 1).row()[0] for shots in results]
        return np.concatenate([*rows, *([_pairs(*results)] if len(results) == 2 else [])])

    def _simulate(self, setting: _Set, start: int, stop: int) -> Shots:
        releases = setting.model.draw(start, stop, self.seed, setting.parameters)
        return simulate(
            releases.states,
            releases.parameters,
            max_contacts=self.max_contacts,
            backend=self.backend,
            threads=1,
            fields=FIELDS,
        )


def _pairs(first: Shots, second: Shots) -> NDArray[np.int64]:
    """Return how many pairs are both made, the first only, the second only, neither."""
    outcomes = np.stack([first.outcome, second.outcome])
    missed = (outcomes != Outcome.MADE)[:, (outcomes != Outcome.INVALID).all(axis=0)]
    return np.bincount(2 * missed[0] + missed[1], minlength=4)


@dataclass(frozen=True)
class _Until:
    """Sums chunks in their order until the precision is reached."""

    precision: float | None
    half_width: Callable[[NDArray[np.int64]], float]
    progress: Progress | None

    def total(
        self,
        work: _Work,
        folder: str | PathLike[str] | None,
        scheduler: str | None,
        threads: int | None,
    ) -> NDArray[np.int64]:
        total = work.count(0, 1) * 0  # what is wrong shows before a folder is made
        note = self.progress or (lambda done, of: None)
        note(0, None if self.precision else work.chunks)
        tables = run(work, folder, scheduler=scheduler, threads=threads)
        with closing(tables):
            for done, table in enumerate(tables, 1):
                total += table["numbers"][0].values.to_numpy()
                needed = self._needed(done, total, work.chunks, len(work.settings))
                note(done, needed)
                if done == needed:
                    break
        return total

    def _needed(self, done: int, total: NDArray[np.int64], most: int, settings: int) -> int:
        """Return how many chunks it will take, as far as can be told."""
        if self.precision is None:
            return most
        if done == 1 and not all(_tally(total, which).valid for which in range(settings)):
            raise ValueError(
                f"model: none of the first {CHUNK:,} shots is valid, so no precision is reached: "
                "they are not finite, start inside a surface, or have parameters out of range"
            )
        # The width falls with the square root of the shots.
        half_width = self.half_width(total)
        if half_width <= self.precision:
            return min(most, done)
        # More than all: the quotient of doubles may be larger than any.
        if half_width >= self.precision * sqrt(most / done):
            return most
        return min(most, max(done + 1, ceil(done * (half_width / self.precision) ** 2)))


def _setting(model: ReleaseModel, parameters: Mapping[str, Any]) -> _Set:
    if isinstance(model, Grid) or not isinstance(model, ReleaseModel):
        raise TypeError(
            "model: expected a Scatter, a Resample, or what else draws at random (it has draw and "
            f"identity; a grid is for hoopgen.map), got {brief(model)}"
        )
    return _Set(model, check_scene(parameters))


def most_shots(
    shots: int | None, precision: float | None, level: float, *, paired: bool = False
) -> int:
    """Return the number of shots, or the most of them.

    Raises
    ------
    ValueError
        If one is not as described for `estimate`, or that precision cannot be reached.
    """
    if precision is not None:
        check_share("precision", precision)
    if shots is not None:
        return check_count("shots", shots)
    if precision is None:
        return SHOTS
    if (least := least_shots(precision, level, paired=paired)) > MOST:
        raise ValueError(
            f"precision: {precision} takes {in_short(least)} shots at least, whatever becomes of "
            f"them, and no more than {in_short(MOST)} are thrown unless shots says so"
        )
    return MOST


def least_shots(precision: float, confidence: float, *, paired: bool = False) -> int:
    """Return a number of shots with fewer of which no interval is so narrow.

    With z of the confidence, half of Wilson's interval is narrowest where all n shots end alike:
    z² / (n + z²) / 2. In Newcombe's the correlation is at most 1 - 2 / n, so that half of it is no
    less than that times √(2 / n).
    """
    square = float(ndtri(0.5 * (1.0 - confidence))) ** 2
    if paired:
        return int((square / sqrt(2.0)) ** (2 / 3) * precision ** (-2 / 3) - square)
    # Exactly: the quotient may be larger than any double.
    return int(Fraction(square) / Fraction(2.0 * precision) - Fraction(square))


# ------------------------------------------------------------------------------------ what it says

_NAMES = 9
"""Letters of the column of names in what is printed."""


def _told(found: Estimate) -> dict[str, str]:
    """Say what an estimate rests on."""
    return told_setting(found.setting) | {"seed": str(found.seed)}


def _tally(total: NDArray[np.int64], which: int) -> Tally:
    """Return the tally of one setting."""
    return Tally.read(total[which * COLUMNS : (which + 1) * COLUMNS])


def _estimate(work: _Work, total: NDArray[np.int64], which: int, level: float) -> Estimate:
    """Return what the numbers say of one setting."""
    tally = _tally(total, which)
    ended = {outcome.name.lower(): int(tally.ended(outcome)) for outcome in Outcome}
    valid = int(tally.valid)
    low, high = wilson(ended["made"], valid, level)
    names = [kind.name.lower() for kind in Kind]
    return Estimate(
        probability=ended["made"] / valid if valid else nan,
        low=float(low),
        high=float(high),
        confidence=level,
        shots=int(tally.shots),
        **ended,
        uncertain=int(tally.uncertain),
        uncertain_capped=int(tally.uncertain_capped),
        kinds=dict(zip(names, tally.of_kind().tolist(), strict=True)),
        kinds_made=dict(zip(names, tally.table[:, Outcome.MADE].tolist(), strict=True)),
        seed=work.seed,
        setting=work.settings[which].identity(),
    )


def _comparison(work: _Work, total: NDArray[np.int64], level: float) -> Comparison:
    """Return what the numbers say of two settings."""
    both, only_first, only_second, neither = total[2 * COLUMNS :].tolist()
    pairs = both + only_first + only_second + neither
    low, high = newcombe(both, only_second, only_first, neither, level)
    return Comparison(
        difference=(only_second - only_first) / pairs if pairs else nan,
        low=low,
        high=high,
        confidence=level,
        both=both,
        only_first=only_first,
        only_second=only_second,
        neither=neither,
        first=_estimate(work, total, 0, level),
        second=_estimate(work, total, 1, level),
    )


def newcombe(
    both: int, only_first: int, only_second: int, neither: int, confidence: float
) -> tuple[float, float]:
    """Return the interval of a difference of paired proportions, the first less the second.

    R. G. Newcombe (1998), Improved confidence intervals for the difference between binomial
    proportions based on paired data, Statistics in Medicine 17, method 10: the distances to the
    ends of Wilson's two intervals are combined as the sides of a triangle whose angle is that of
    the correlation, which is corrected for continuity. Of no pairs nothing is known: from -1 to 1.
    """
    pairs = both + only_first + only_second + neither
    if not pairs:
        return -1.0, 1.0
    made = both + only_first, both + only_second
    (low_1, low_2), (high_1, high_2) = wilson(made, pairs, confidence)
    first, second = made[0] / pairs, made[1] / pairs
    # Products of counts outgrow 64 bits: Python's whole numbers do not.
    spread = made[0] * (pairs - made[0]) * made[1] * (pairs - made[1])
    concord, discord = both * neither, only_first * only_second
    excess = max(concord - discord - pairs / 2, 0.0) if concord > discord else concord - discord
    correlation = excess / sqrt(spread) if spread else 0.0

    def combined(one: float, other: float) -> float:
        return sqrt(max(one * one - 2.0 * correlation * one * other + other * other, 0.0))

    difference = first - second
    return (
        float(difference - combined(first - low_1, high_2 - second)),
        float(difference + combined(high_1 - first, second - low_2)),
    )
