"""Coverage of hoopgen's intervals, on players whose truth is known.

The players are normal about a free throw. What is true of one is the share, the difference or the
quantile of many shots; that this has an error, too, lowers the coverage to be expected by as much
as it adds to the variance. Each repetition draws its own shots, or its own measured releases from
the player, and asks hoopgen for the interval.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import cache
from multiprocessing import get_context
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from scipy.special import ndtr, ndtri
from scipy.stats import binom, binomtest

import hoopgen
from benchmarks.free_throw import LINE, RELEASE, SEVENTY
from benchmarks.report import table
from hoopgen import PAPER, Resample, Scatter
from hoopgen.core.units import DEGREE
from hoopgen.study.jobs.monte_carlo import setting_of
from hoopgen.study.jobs.objective import Player
from hoopgen.study.models.requirements import scaled
from hoopgen.study.questions.bank import bank_or_direct
from hoopgen.study.questions.optimum import optimum
from hoopgen.text.numbers import format_percent

Floats = NDArray[np.float64]
Claim = Literal["95%", "at least 95%"]

AT = RELEASE | {"azimuth": 0.0}
PLAYER = Scatter({**LINE, **AT}, SEVENTY)
STEADIER = Scatter({**LINE, **AT}, SEVENTY | {"speed": 0.05})
SURE = Scatter({**LINE, **AT, "speed": 7.2}, {"speed": 0.035, "elevation": 0.7 * DEGREE})
DEADER = PAPER | {"restitution": 0.6}

LEVEL = 0.95
WORST = 0.01
"""Smallest probability of a coverage with which an interval counts as right."""

ENOUGH = 50
"""Repetitions. Of half an interval two thirds contain the truth: with fewer that is not found."""

SHOTS, ROWS, GROUPS = 1_000, 200, 20
"""Shots of a simulated interval; measured releases, and the groups that they come in."""

TRUTH, TRUTH_EACH = 4_000_000, 50_000
"""Shots of a truth; and of one that each repetition has of its own."""

_OTHERS, _DATA = 1 << 40, 1 << 41
"""Seeds of the truths and of the measured releases, far from those of the repetitions."""


@dataclass(frozen=True)
class Interval:
    """One interval, what it should contain, and the standard error of that."""

    low: float
    high: float
    truth: float
    error: float

    def halved(self) -> "Interval":
        """Return it half as wide about its middle: what a test must find out."""
        middle, half = 0.5 * (self.low + self.high), 0.25 * (self.high - self.low)
        return Interval(middle - half, middle + half, self.truth, self.error)


@dataclass(frozen=True)
class Case:
    """An interval that hoopgen prints, and how to get one with its truth."""

    name: str
    of: str
    claim: Claim
    repetitions: int
    once: Callable[[int], Interval]

    def intervals(self, repetitions: int) -> Iterator[Interval]:
        """Yield one interval a repetition."""
        return map(self.once, range(repetitions))


@dataclass(frozen=True)
class Coverage:
    """The coverage of a case: how many of its intervals contain the truth."""

    case: Case
    repetitions: int
    covered: int
    expected: float
    width: float

    @property
    def share(self) -> float:
        """Return the share of the intervals that contain the truth."""
        return self.covered / self.repetitions

    @property
    def probability(self) -> float:
        """Return the probability of a share at least as far from the claim, if that holds."""
        side = "two-sided" if self.case.claim == "95%" else "less"
        return float(
            binomtest(self.covered, self.repetitions, self.expected, alternative=side).pvalue
        )

    @property
    def holds(self) -> bool:
        """True if the coverage is what is claimed, by a binomial test at 1%."""
        return self.probability >= WORST


def coverage(case: Case, intervals: Sequence[Interval]) -> Coverage:
    """Count the intervals that contain the truth."""
    covered = sum(bool(one.low <= one.truth <= one.high) for one in intervals)
    z = -float(ndtri(0.5 * (1.0 - LEVEL)))
    finite = [one.high - one.low for one in intervals if math.isfinite(one.high - one.low)]
    width = float(np.median(finite))
    more = float(np.mean([(one.error / (0.5 * width / z)) ** 2 for one in intervals]))
    expected = 2.0 * float(ndtr(z / math.sqrt(1.0 + more))) - 1.0
    return Coverage(case, len(intervals), covered, expected, width)


# ------------------------------------------------------------------------------------- the truth


def _share(model: Any, parameters: Mapping[str, Any], shots: int) -> tuple[float, float]:
    """Return the share of shots that are made, and its standard error."""
    found = hoopgen.estimate(model, parameters, shots=shots, seed=_OTHERS)
    return found.probability, math.sqrt(found.probability * (1 - found.probability) / shots)


@cache
def _truth(name: str) -> tuple[float, float]:
    """Return the share of shots that a player makes."""
    models = {
        "player": (PLAYER, PAPER),
        "sure": (SURE, PAPER),
        "steadier": (STEADIER, PAPER),
        "deader": (PLAYER, DEADER),
    }
    return _share(*models[name], TRUTH)


@cache
def _lead(name: str) -> tuple[float, float]:
    """Return the difference of two players' shares of the same shots."""
    second = {"steadier": (STEADIER, PAPER), "deader": (PLAYER, DEADER)}[name]
    found = hoopgen.compare((PLAYER, PAPER), second, shots=TRUTH, seed=_OTHERS)
    apart = found.only_first + found.only_second
    return found.difference, math.sqrt(apart) / found.pairs


@cache
def _depths() -> Floats:
    """Return the depths of many shots, sorted, m."""
    setting, parts = setting_of(PLAYER, PAPER), []
    for start in range(0, TRUTH // 4, 1 << 16):
        drawn = setting.model.draw(start, start + (1 << 16), _OTHERS, PAPER)
        shots = hoopgen.simulate(drawn.states, PAPER)
        parts.append(hoopgen.measure(drawn.states, shots, PAPER, ("depth",))["depth"])
    found = np.concatenate(parts)
    return np.sort(found[~np.isnan(found)])


def _depth(level: float) -> tuple[float, float]:
    """Return a quantile of the depth, and its standard error."""
    values = _depths()
    off = math.sqrt(level * (1 - level) / len(values))
    low, middle, high = np.quantile(values, [level - off, level, level + off])
    return float(middle), float(0.5 * (high - low))


@cache
def _back() -> tuple[float, float]:
    """Return the share of the rebounds that come back to the shooter."""
    found = hoopgen.estimate(PLAYER, shots=TRUTH // 4, seed=_OTHERS, measures=["rebound_angle"])
    spread = found.measured["rebound_angle"]
    share = next(iter(spread.shares.values()))[0]
    return share, math.sqrt(share * (1 - share) / spread.shots)


def _of_release(arguments: Mapping[str, float], by: str, sample: Resample | None, seed: int) -> Any:
    """Return the results of many shots of the player about a release.

    Of measured releases the player moves the mean of all throws as far as that of the sample.
    """
    at = dict(arguments)
    if sample is not None:
        at |= {name: at[name] + AT[name] - sample.centre[name] for name in AT}
    return Player(Scatter({}, SEVENTY), PAPER, by).scored(at, TRUTH_EACH, _OTHERS + seed)


# --------------------------------------------------------------------------------- the intervals


def measured(repetition: int, groups: bool) -> Resample:
    """Return measured releases of the player; of groups, each has its own speed beside the mean.

    Of the variance of the speed a third is between the groups, so that all throws together scatter
    as the player's do.
    """
    start = repetition * ROWS
    if not groups:
        drawn = PLAYER.draw(start, start + ROWS, _DATA)
        return Resample({**{n: np.asarray(drawn.columns[n]) for n in AT}, **LINE})
    within = Scatter({**LINE, **AT}, SEVENTY | {"speed": SEVENTY["speed"] * math.sqrt(2 / 3)})
    drawn = within.draw(start, start + ROWS, _DATA)
    group = np.arange(ROWS) % GROUPS
    columns = {n: np.asarray(drawn.columns[n]) for n in AT} | LINE
    days = np.random.default_rng(repetition).normal(0.0, SEVENTY["speed"] / math.sqrt(3), GROUPS)
    return Resample(columns | {"speed": columns["speed"] + days[group]}, group)


def _simulated(name: str) -> Callable[[int], Interval]:
    def once(seed: int) -> Interval:
        model = SURE if name == "sure" else PLAYER
        found = hoopgen.estimate(model, shots=SHOTS, seed=seed, threads=1)
        return Interval(found.low, found.high, *_truth(name))

    return once


def _of_sample(groups: bool) -> Callable[[int], Interval]:
    def once(repetition: int) -> Interval:
        found = hoopgen.estimate(measured(repetition, groups), shots=1, threads=1).sample
        assert found is not None
        return Interval(found.low, found.high, *_truth("player"))

    return once


@cache
def _slope() -> float:
    """Return by how much the share falls with the factor times the scatter, about 1."""
    less, more = (_share(scaled(PLAYER, one), PAPER, TRUTH // 10)[0] for one in (0.9, 1.1))
    return (less - more) / 0.2


def _compared(seed: int) -> Interval:
    found = hoopgen.compare(PLAYER, STEADIER, shots=SHOTS, seed=seed, threads=1)
    return Interval(found.low, found.high, *_lead("steadier"))


def _compared_rows(groups: bool) -> Callable[[int], Interval]:
    def once(repetition: int) -> Interval:
        model = measured(repetition, groups)
        found = hoopgen.compare(model, (model, DEADER), shots=1, threads=1).sample
        assert found is not None
        return Interval(found.low, found.high, *_lead("deader"))

    return once


def _compared_apart(repetition: int) -> Interval:
    """Two players' releases, of one fewer rows than of the other: nothing pairs."""
    drawn = STEADIER.draw(repetition * ROWS, (repetition + 1) * ROWS - 1, _DATA + 1)
    second = Resample({**{n: np.asarray(drawn.columns[n]) for n in AT}, **LINE})
    found = hoopgen.compare(measured(repetition, False), second, shots=1, threads=1).sample
    assert found is not None
    return Interval(found.low, found.high, *_lead("steadier"))


def _solved(seed: int) -> Interval:
    share, error = _truth("player")  # which is that with the factor 1
    found = hoopgen.solve(PLAYER, share, shots=SHOTS, seed=seed, threads=1)
    return Interval(found.low, found.high, 1.0, error / _slope())


def _quantile(level: float) -> Callable[[int], Interval]:
    def once(seed: int) -> Interval:
        found = hoopgen.estimate(PLAYER, shots=SHOTS, seed=seed, measures=["depth"], threads=1)
        _, low, high = found.measured["depth"].quantiles[level]
        return Interval(low, high, *_depth(level))

    return once


def _quantile_rows(level: float, groups: bool) -> Callable[[int], Interval]:
    def once(repetition: int) -> Interval:
        model = measured(repetition, groups)
        found = hoopgen.estimate(model, shots=1, measures=["depth"], threads=1)
        low, high = found.measured["depth"].sample[level]
        return Interval(low, high, *_depth(level))

    return once


def _sector(seed: int) -> Interval:
    found = hoopgen.estimate(PLAYER, shots=SHOTS, seed=seed, measures=["rebound_angle"], threads=1)
    _, low, high = next(iter(found.measured["rebound_angle"].shares.values()))
    return Interval(low, high, *_back())


_AIMED = {**LINE, "elevation": RELEASE["elevation"]}


def _best(seed: int) -> Interval:
    found = optimum(
        Scatter(_AIMED, SEVENTY),
        ["aim"],
        by="direct",
        shots=SHOTS,
        seed=2 * seed,
        margins=(),
        threads=1,
    )
    made = _of_release(found.arguments, "direct", None, seed).made
    return Interval(found.low, found.high, made.mean(), made.std() / math.sqrt(TRUTH_EACH))


def _best_of_rows(groups: bool) -> Callable[[int], Interval]:
    def once(repetition: int) -> Interval:
        model, over = measured(repetition, groups), ["elevation", "aim"]
        found = optimum(model, over, by="direct", shots=SHOTS, margins=(), threads=1)
        made = _of_release(found.arguments, "direct", model, repetition).made
        return Interval(found.low, found.high, made.mean(), made.std() / math.sqrt(TRUTH_EACH))

    return once


_HERE = [(2.7, 0.0)]


def _banked(rows: bool) -> Callable[[int], Interval]:
    """Return the difference of the best bank and direct shots, from straight in front."""

    def once(seed: int) -> Interval:
        sample = measured(seed, False) if rows else None
        model = Scatter({n: v for n, v in _AIMED.items() if n != "distance"}, SEVENTY)
        found = bank_or_direct(
            sample or model, _HERE, over=["aim"], shots=SHOTS, seed=2 * seed, threads=1
        ).isel(place=0)
        bank, direct = (
            _of_release(
                {name: found.sel(way=way)[name].item() for name in (*LINE, *AT)}, way, sample, seed
            ).made
            for way in ("bank", "direct")
        )
        apart = bank.astype(float) - direct
        low, high = (found[f"difference_{end}"].item() for end in ("low", "high"))
        return Interval(low, high, apart.mean(), apart.std() / math.sqrt(TRUTH_EACH))

    return once


_MANY, _FEW = 2_000, 400
_N, _M = f"{SHOTS:,} shots", f"{ROWS} measured releases"
_G = f"{_M} in {GROUPS} groups"

CASES = (
    Case("`estimate`, of the simulation", f"{_N}, 67% made", "95%", _MANY, _simulated("player")),
    Case(
        "`estimate`, of the simulation", f"{_N}, nearly all made", "95%", _MANY, _simulated("sure")
    ),
    Case("`estimate`, of the sample", _M, "95%", _MANY, _of_sample(False)),
    Case("`estimate`, of the sample", _G, "95%", _MANY, _of_sample(True)),
    Case("`compare`, of the simulation", _N, "95%", _MANY, _compared),
    Case("`compare`, of the sample, row by row", _M, "95%", _MANY, _compared_rows(False)),
    Case("`compare`, of the sample, row by row", _G, "95%", _MANY, _compared_rows(True)),
    Case("`compare`, of two samples", f"{ROWS} and {ROWS - 1}", "95%", _MANY, _compared_apart),
    Case("`solve`, of the simulation", _N, "95%", _FEW, _solved),
    *(
        Case(f"depth, {said}, of the simulation", _N, "at least 95%", _MANY, _quantile(level))
        for level, said in ((0.05, "5%"), (0.5, "median"), (0.95, "95%"))
    ),
    Case("depth, median, of the sample", _M, "at least 95%", _MANY, _quantile_rows(0.5, False)),
    Case("depth, 5%, of the sample", _M, "at least 95%", _MANY, _quantile_rows(0.05, False)),
    Case("depth, median, of the sample", _G, "at least 95%", _MANY, _quantile_rows(0.5, True)),
    Case("rebounds back to the shooter", _N, "95%", _MANY, _sector),
    Case("`optimum`", f"{_N}, fresh", "95%", _FEW, _best),
    Case("`optimum`, of the sample", f"{_M}, held out", "95%", _FEW, _best_of_rows(False)),
    Case("`optimum`, of the sample", f"{_G}, held out", "95%", _FEW, _best_of_rows(True)),
    Case("`bank_or_direct`, difference", f"{_N}, fresh", "95%", _FEW, _banked(False)),
    Case("`bank_or_direct`, of the sample", f"{_M}, held out", "95%", _FEW, _banked(True)),
)
"""Every kind of interval that hoopgen prints; those of a map and of a scene of one's own are the
first."""


# ------------------------------------------------------------------------------------- the page


def count(number: int, part: float = 1.0) -> dict[str, Any]:
    """Return the result of a case for a part of its repetitions, in types that JSON knows."""
    case = CASES[number]
    repetitions = max(20, round(part * case.repetitions))
    found = coverage(case, list(case.intervals(repetitions)))
    numbers = {name: getattr(found, name) for name in ("covered", "expected", "width")}
    return {"name": case.name, "of": case.of, "repetitions": repetitions, **numbers}


def counts(part: float = 1.0) -> list[dict[str, Any]]:
    """Return the results of all cases in order, each computed by a process of its own."""
    slow_first = sorted(range(len(CASES)), key=lambda number: CASES[number].repetitions)
    with ProcessPoolExecutor(mp_context=get_context("spawn")) as pool:
        found = {number: pool.submit(count, number, part) for number in slow_first}
        return [found[number].result() for number in range(len(CASES))]


def section(found: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return the lines of the page."""
    done = [
        Coverage(case, one["repetitions"], one["covered"], one["expected"], one["width"])
        for case, one in zip(CASES, found, strict=True)
    ]
    rows = [
        [
            one.case.name,
            one.case.of,
            one.case.claim,
            f"{one.repetitions:,}",
            f"{100 * one.share:.1f}%",
            f"{one.probability:.2f}",
            _verdict(one),
        ]
        for one in done
    ]
    head = ["interval", "of", "claimed", "repetitions", "contain the truth", "P", "holds"]
    return [
        HEADING,
        "",
        "Each interval is computed many times, from other shots or from other measured releases "
        f"of a player whose truth is known. The truth comes from {TRUTH:,} shots, or from "
        f"{TRUTH_EACH:,} shots of its own release if each repetition finds a release. The test "
        "takes the error of the truth into account. P is the probability of a coverage at least "
        f"as far from the claimed one. An interval holds if P is "
        f"{format_percent(WORST, None)} or more. The test is a binomial test, and "
        "one-sided for a claim of *at least*: a quantile lies "
        "between two shots, and no pair of ranks gives exactly 95%. The player shoots from the "
        "free-throw line with the errors above. Groups differ in their mean speed, by a third "
        "of its variance.",
        "",
        "The table gives the number of repetitions. Few repetitions detect only gross errors: "
        "an interval that claims 95% and contains the truth in 90% fails this test with a "
        f"probability of {format_percent(found_out(100), 0)} after 100 repetitions, and of "
        f"{format_percent(found_out(400), 0)} after 400.",
        "",
        "The truth of an `optimum` is the success rate of the release that the search found, "
        "not that of the best release. For measured releases the search uses all rows, and each "
        "row is judged by another release, found without a fifth of the rows. The interval "
        "therefore contains the variance of the rows and also that of the release: 1 + 1/5 "
        "times the variance between the six releases over the same shots, as for one more draw "
        "beside a mean of five. Effects common to the six cancel. The factor of the jackknife, "
        "(5 − 1)²/5, is larger because it describes releases found from other samples, which "
        "also differ in these common effects.",
        "",
        *table(head, rows),
        "Flat ranges, and margins with scatter, are estimates of a range and not confidence "
        "intervals. Maps and scenes of your own have the intervals of the first rows.",
        "",
    ]


def found_out(repetitions: int, covers: float = 0.90) -> float:
    """Return with which probability an interval fails the test that covers less than it claims."""
    covered = np.arange(repetitions + 1)
    within = binom.pmf(covered, repetitions, LEVEL)
    # As `Coverage.probability`: all that is no more probable than what was found.
    order = np.argsort(within)
    tail = np.empty_like(within)
    tail[order] = np.cumsum(within[order])
    return float(binom.pmf(covered[tail < WORST], repetitions, covers).sum())


def _verdict(found: Coverage) -> str:
    """Describe whether an interval holds; a few repetitions can only show that it fails."""
    if not found.holds:
        return "**no**"
    return "yes" if found.repetitions >= ENOUGH else "too few to say"


HEADING = "## Coverage of the intervals"
