"""The gradient of the probability that a shot is made.

By what scatters it is the covariance of the score with made shots, which needs no other shots
(`hoopgen.study.models.scores`); by a parameter of the scene, a difference over the same random
numbers (`hoopgen.study.jobs.differences`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from math import nan, sqrt
from statistics import NormalDist
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.units import display_unit
from hoopgen.scene.lookup import variables_of
from hoopgen.simulation.engine import Engine
from hoopgen.study.jobs.differences import CENTRAL, COUNTS, Differences
from hoopgen.study.jobs.monte_carlo import ResolvedSetting
from hoopgen.study.models.resample import Resample
from hoopgen.study.models.scores import SUMS, UNIT, check_scored, split
from hoopgen.study.statistics.intervals import combined_interval, newcombe_interval
from hoopgen.text.numbers import format_percent
from hoopgen.text.tables import table

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Slope:
    """The derivative of the probability by one variable.

    Attributes
    ----------
    value
        Per SI unit of the variable.
    low, high
        The interval of it, of the confidence of the estimate: that of the simulation alone. Of a
        score it is normal; of a difference it is that of `newcombe_interval`, without the bias.
        Where nothing is known, all three are NaN: for a score if no shot or every shot is made, for
        a difference if no shot is valid.
    method
        "score" or "difference".
    bias
        Of a difference: a third of the change of the value with twice the step, which estimates
        the part of the value that is due to the step; it contains the noise of both. 0 for a score.
    """

    value: float
    low: float
    high: float
    method: str
    bias: float = 0.0

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows."""
        return asdict(self)


def slope_lines(
    slopes: Mapping[str, Slope], scene: Engine, level: float, *, sampled: bool = False
) -> list[str]:
    """Return the lines that say the derivatives with their intervals, in the units shown.

    Parameters
    ----------
    slopes
        The derivatives by variable, SI and rad.
    scene
        The scene whose variables they are.
    level
        The confidence of the intervals, from 0 to 1.
    sampled
        True if the model is fitted to a sample, whose uncertainty these intervals do not contain.
    """
    if not slopes:
        return []
    rows = []
    for name, slope in slopes.items():
        unit = display_unit(variables_of(scene)[split(name)[1]].kind)
        values = [f"{value * unit.size:+.4g}" for value in (slope.value, slope.low, slope.high)]
        per = unit.symbol.strip() or "1"
        bias = f", bias {slope.bias * unit.size:+.1g}" if slope.bias else ""
        ends = f"{values[1]} to {values[2]}"
        rows.append([name, values[0], f"per {per}", ends, f"{slope.method}{bias}"])
    alone = " of the simulation alone" if sampled else ""
    interval = f"{format_percent(level, None)} interval{alone}"
    head = ["gradient by", "share made", "", interval, "method"]
    return ["", *table(head, rows, right=[1]).splitlines()]


def check_gradient(names: Sequence[str], setting: ResolvedSetting) -> tuple[str, ...]:
    """Return the names of the variables; refuse those that the probability has no derivative by.

    Parameters
    ----------
    names
        The names that were given.
    setting
        The setting with its model and its scene.

    Raises
    ------
    TypeError
        If they are one text, or the model is no Scatter.
    ValueError
        If a name is unknown, there twice, or does not scatter; or the model draws from measured
        releases: the share made of a finite sample changes in jumps.
    """
    found = tuple(names)
    if len(set(found)) < len(found):
        raise ValueError(f"gradient: expected each name once, got {', '.join(found)}")
    if found and isinstance(setting.model, Resample):
        raise ValueError(
            f"gradient: the share made of measured releases changes in jumps with {found[0]}, so "
            "its derivative is none of the player's: fit a scatter to them (Scatter.fit, "
            "--fitted), or compare two values (hoopgen.compare, --versus)"
        )
    check_scored(setting.model, [name for name in found if name not in setting.parameters])
    for name in found:
        if name not in setting.parameters:
            continue
        value = setting.parameters[name]
        if not np.isfinite(value):
            raise ValueError(f"gradient: {name} is {value:g}; expected a finite number")
        changed = setting.differences(name).values[-1]
        drawn = setting.model.draw(0, 1, 0, {**setting.parameters, name: changed})
        if np.ndim(drawn.parameters[name]) or drawn.parameters[name] != changed:
            raise ValueError(f"gradient: {name} is of the release model; ask for mean.{name}")
    return found


def score_slopes(
    model: Any, names: Sequence[str], sums: NDArray[np.int64], valid: int, made: int, level: float
) -> dict[str, Slope]:
    """Return the derivatives by what scatters, from the sums of their scores.

    Parameters
    ----------
    model
        A Scatter.
    names
        Of the derivatives.
    sums
        As of `score_sums`, of all shots.
    valid, made
        Numbers of shots.
    level
        Of the intervals.
    """
    z = NormalDist().inv_cdf(0.5 + level / 2)
    found = {}
    for name, of_name in zip(names, sums.reshape(-1, SUMS), strict=True):
        if not 0 < made < valid:  # the covariance and its variance would be 0
            found[name] = Slope(nan, nan, nan, "score")
            continue
        every, of_made, squares, squares_made = (float(one) / UNIT / valid for one in of_name)
        share = made / valid
        # (made - P)(s - mean of s), whose mean is the covariance: its variance by its square.
        value = of_made - share * every
        centred = squares - every**2
        centred_made = squares_made - 2.0 * every * of_made + every**2 * share
        variance = (1.0 - 2.0 * share) * centred_made + share**2 * centred - value**2
        half = z * sqrt(max(variance, 0.0) / valid)
        sd = float(model.sd[split(name)[1]])
        found[name] = Slope(value / sd, (value - half) / sd, (value + half) / sd, "score")
    return found


def difference_slopes(
    differences: Mapping[str, Differences], counts: NDArray[np.int64], level: float
) -> dict[str, Slope]:
    """Return the derivatives by parameters of the scene, from shots with several values of each.

    Parameters
    ----------
    differences
        By the name of the parameter.
    counts
        As of `difference_counts`, of all shots, one parameter after the other.
    level
        Of the intervals.
    """
    found = {}
    for (name, own), of_name in zip(differences.items(), counts.reshape(-1, COUNTS), strict=True):
        if not of_name.any():
            found[name] = Slope(nan, nan, nan, "difference", nan)
            continue
        count, one_sided = of_name.tolist(), own.places != CENTRAL
        interval = _one_sided if one_sided else _central
        value, *ends = (each / own.step for each in interval(count, own.places, 1, level))
        wider = interval(count, own.places, 2, level)[0] / own.step
        low, high = sorted(ends)  # a step below zero changes their order
        found[name] = Slope(value, low, high, "difference", (wider - value) / 3.0)
    return found


Numbers = Sequence[int]
Interval = tuple[float, float, float]
"""A value, and the ends of its interval."""


def _central(counts: Numbers, places: Numbers, times: int, level: float) -> Interval:
    """Return the central difference with that many steps, for a step of 1."""
    difference = _paired(counts, places.index(times), places.index(-times), level)
    value, low, high = (each / (2.0 * times) for each in difference)
    return value, low, high


def _one_sided(counts: Numbers, places: Numbers, times: int, level: float) -> Interval:
    """Return the one-sided difference with that many steps, for a step of 1.

    Of the shares p it is 2 (p(h) - p(0)) / h - (p(2h) - p(0)) / 2h.
    """
    start, near, far = (places.index(place) for place in (0, times, 2 * times))
    first = [2.0 / times * each for each in _paired(counts, near, start, level)]
    second = [0.5 / times * each for each in _paired(counts, far, start, level)]
    # Each shot has -1, 0 or 1 for a difference.
    made = np.arange(len(counts))[:, None] >> np.array([start, near, far]) & 1
    changes = made[:, 1:] - made[:, :1]
    covariance = np.cov(changes.T, fweights=np.array(counts), ddof=0)
    spread = sqrt(covariance[0, 0] * covariance[1, 1])
    correlation = float(covariance[0, 1] / spread) if spread else 0.0
    ends = (first[1], first[2]), (second[1], second[2])
    low, high = combined_interval(first[0], ends[0], second[0], ends[1], correlation)
    return first[0] - second[0], low, high


def _paired(counts: Numbers, first: int, second: int, level: float) -> Interval:
    """Return the share made with one value less that with another, by their numbers."""
    pairs = [0, 0, 0, 0]  # neither, the first alone, the second alone, both
    for index, count in enumerate(counts):
        pairs[(index >> first & 1) + 2 * (index >> second & 1)] += count
    neither, alone, other, both = pairs
    ends = newcombe_interval(both, alone, other, neither, level)
    return (alone - other) / sum(pairs), *ends
