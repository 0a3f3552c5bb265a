"""Intervals that contain the uncertainty of a sample of measured releases.

The interval of a simulation shrinks with the shots; that of a sample does not, since more shots
from the same rows tell nothing new of the player. Every row is thrown once: without other scatter
it succeeds or not, and the rows, or their groups, are the trials.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from math import inf, nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.backend_names import BackendName
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.report.quantities import for_json
from hoopgen.simulation.simulate import simulate
from hoopgen.study.measures.measures import MEASURES, measure
from hoopgen.study.models.resample import Resample
from hoopgen.text.numbers import format_count, format_interval, format_percent, format_points

from .intervals import (
    Ends,
    grouped_difference,
    grouped_wilson,
    newcombe_interval,
    quantile_ranks,
    wilson_interval,
)
from .tally import blocks

Truths = NDArray[np.bool_]


@dataclass(frozen=True)
class SampleInterval:
    """An interval that contains the uncertainty of a sample of measured releases.

    Attributes
    ----------
    value
        Of the rows, each thrown once: a share, or a difference of shares. NaN if none is valid.
    low, high
        Ends of the interval.
    rows
        Measured releases that could be simulated.
    groups
        How many groups they are in; None if each row is independent of all others.
    """

    value: float
    low: float
    high: float
    rows: int
    groups: int | None

    @property
    def words(self) -> str:
        """The sample in words."""
        return f"{format_count(self.rows, 'measured release')}{in_groups(self.groups)}"

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows; None for what is not a number."""
        return {name: for_json(value) for name, value in asdict(self).items()}


def in_groups(groups: int | None) -> str:
    """Say in how many groups the rows are, after their number; nothing if they are independent."""
    return "" if groups is None else f" in {format_count(groups, 'group')}"


def say_sample(found: SampleInterval, confidence: float) -> str:
    """Say the interval of a share, and that it contains the uncertainty of the sample.

    Parameters
    ----------
    found
        The interval, of a share from 0 to 1.
    confidence
        The confidence of the interval, from 0 to 1.
    """
    ends = format_interval(found.low, found.high)
    return f"{ends} ({format_percent(confidence, None)} interval of the sample, {found.words})"


def say_difference(found: SampleInterval, confidence: float) -> str:
    """Say the interval of a difference, and that it contains the uncertainty of the sample.

    Parameters
    ----------
    found
        The interval, of a difference from -1 to 1.
    confidence
        The confidence of the interval, from 0 to 1.
    """
    ends = f"{format_points(found.low)} to {format_points(found.high)}"
    return f"{ends} ({format_percent(confidence, None)} interval of the sample, {found.words})"


def _totals_by_group(counts: NDArray[Any], cluster: NDArray[np.intp] | None) -> NDArray[np.int64]:
    """Return the sums of the rows' numbers by group, (g,); of independent rows themselves."""
    if cluster is None:
        return np.asarray(counts, np.int64)
    return np.bincount(cluster, counts).astype(np.int64)


def share_of_rows(
    made: Truths, valid: Truths, cluster: NDArray[np.intp] | None, confidence: float
) -> SampleInterval:
    """Return the share of the valid rows that succeed, with the interval of the sample.

    Parameters
    ----------
    made, valid
        Which rows succeed, and which could be simulated, (m,).
    cluster
        Number of each row's group, (m,), or None if the rows are independent.
    """
    good, trials = int((made & valid).sum()), int(valid.sum())
    if cluster is None:
        low, high = map(float, wilson_interval(good, trials, confidence))
    else:
        by_group = [_totals_by_group(one, cluster) for one in (made & valid, valid)]
        low, high = grouped_wilson(by_group[0], by_group[1], confidence)
    share = good / trials if trials else nan
    return SampleInterval(share, low, high, trials, _group_count(cluster, valid))


def difference_of_rows(
    first: Truths, second: Truths, valid: Truths, cluster: NDArray[np.intp] | None, level: float
) -> SampleInterval:
    """Return the share of the first less that of the second, of the same rows, with the interval.

    Parameters
    ----------
    first, second
        Which rows succeed the one way and the other, (m,).
    cluster, level
        As of `share_of_rows`.
    """
    one, other = first & valid, second & valid
    trials = int(valid.sum())
    difference = (int(one.sum()) - int(other.sum())) / trials if trials else nan
    if cluster is None:
        pairs = one & other, one & ~other, ~one & other, ~one & ~other & valid
        both, only_first, only_second, neither = (int(pair.sum()) for pair in pairs)
        low, high = newcombe_interval(both, only_first, only_second, neither, level)
    else:
        by_group = [_totals_by_group(some, cluster) for some in (one, other, valid)]
        low, high = grouped_difference(by_group[0], by_group[1], by_group[2], level)
    return SampleInterval(difference, low, high, trials, _group_count(cluster, valid))


def _group_count(cluster: NDArray[np.intp] | None, valid: Truths) -> int | None:
    return None if cluster is None else len(np.unique(cluster[valid]))


@dataclass(frozen=True)
class Rows:
    """Measured releases, each thrown once.

    Attributes
    ----------
    measured
        By the name of a measure its values, (m,); NaN where it has none.
    """

    outcome: NDArray[np.uint8]  # of each row, (m,)
    cluster: NDArray[np.intp] | None  # number of each row's group, or None
    scene: CompiledScene  # in which they were thrown
    measured: Mapping[str, NDArray[np.float64]] = field(default_factory=dict)

    @property
    def valid(self) -> Truths:
        """True for each row that is valid."""
        return np.asarray(self.outcome != self.scene.outcomes["INVALID"])

    def share(self, outcome: int, confidence: float) -> SampleInterval:
        """Return the share of the rows that end so, with the interval of the sample.

        Parameters
        ----------
        outcome
            The code of the outcome.
        confidence
            The confidence of the interval, from 0 to 1.
        """
        return share_of_rows(self.outcome == outcome, self.valid, self.cluster, confidence)

    def quantile(self, name: str, level: float, confidence: float) -> Ends:
        """Return the interval of a measure's quantile; infinite where the rows are too few.

        Of independent rows by the ranks of their values; of groups as R. S. Woodruff (1952),
        Confidence intervals for medians and other position measures, Journal of the American
        Statistical Association 47: of the share that is below, read off the values.

        Parameters
        ----------
        name
            The name of the measure.
        level
            The quantile that is meant, from 0 to 1.
        confidence
            The confidence of the interval, from 0 to 1.
        """
        there = ~np.isnan(self.measured[name])
        values = np.sort(self.measured[name][there])
        if self.cluster is None:
            low, high = quantile_ranks(level, len(values), confidence)
        else:
            middle = np.quantile(values, level) if len(values) else 0.0
            below = there & (self.measured[name] <= middle)
            by_group = [_totals_by_group(one, self.cluster) for one in (below, there)]
            ends = grouped_wilson(by_group[0], by_group[1], confidence)
            low, high = int(np.floor(ends[0] * len(values))), int(np.ceil(ends[1] * len(values)))
        bounded = np.concatenate([[-inf], values, [inf]])
        return float(bounded[low]), float(bounded[min(high, len(values) + 1)])

    def within(self, name: str, inside: Truths, confidence: float) -> SampleInterval:
        """Return the share of the rows with a measure whose values are inside of something.

        Parameters
        ----------
        name, confidence
            As for `Rows.quantile`.
        inside
            Whether the measure of each row is inside, (n,).
        """
        there = ~np.isnan(self.measured[name])
        return share_of_rows(inside, there, self.cluster, confidence)


def sampled_rows(
    setting: Any,
    max_contacts: int,
    backend: BackendName,
    threads: int | None = None,
    measures: Sequence[str] = (),
    catching_height: float = 0.0,
) -> Rows:
    """Throw every measured release once.

    Parameters
    ----------
    setting
        The releases, a `Resample`, and their scene: a setting of `hoopgen.study.jobs.monte_carlo`.
    max_contacts, backend, threads
        As for `hoopgen.simulate`.
    measures, catching_height
        As for `hoopgen.measure`.
    """
    model: Resample = setting.model
    each = model.each()
    needed = {"outcome", *(one for name in measures for one in MEASURES[name].fields)}
    outcomes, found = [], []
    for start, stop in blocks(0, model.rows):
        releases = each.draw(start, stop, 0, setting.parameters)
        shots = simulate(
            releases.states,
            releases.parameters,
            scene=setting.scene,
            max_contacts=max_contacts,
            backend=backend,
            threads=threads,
            fields=sorted(needed),
        )
        outcomes.append(shots.outcome)
        if measures:
            own = releases.parameters
            found.append(
                measure(releases.states, shots, own, measures, catching_height=catching_height)
            )
    columns = {name: np.concatenate([part[name] for part in found]) for name in measures}
    return Rows(np.concatenate(outcomes), model.cluster, setting.scene, columns)
