"""`compare`: which of two settings is made more often, over the same random numbers."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import inf, isinf, nan
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.backend_names import BackendName
from hoopgen.report.provenance import footer
from hoopgen.report.quantities import STILL, for_json
from hoopgen.scene.lookup import SceneLike
from hoopgen.study.jobs.chunks import Progress
from hoopgen.study.jobs.monte_carlo import (
    MonteCarloJob,
    ResolvedSetting,
    SettingLike,
    outcome_by,
    setting_of,
)
from hoopgen.study.jobs.stopping import StoppingRule, most_shots
from hoopgen.study.models.random import check_seed
from hoopgen.study.models.release_model import is_still
from hoopgen.study.models.resample import Resample
from hoopgen.study.result import SharesOfShots
from hoopgen.study.statistics.intervals import newcombe_apart, newcombe_interval
from hoopgen.study.statistics.outcome_shares import Shares
from hoopgen.study.statistics.sample import Rows, SampleInterval, difference_of_rows, say_difference
from hoopgen.study.statistics.tally import check_share, contacts_of, width_of
from hoopgen.text.numbers import format_percent, format_points, percent_decimals
from hoopgen.text.shorten import brief

from .estimate_result import NAMES, Estimate, describe_estimate, estimated


@dataclass(frozen=True, repr=False)
class Comparison(SharesOfShots):
    """The difference of the second setting from the first, over the same random numbers.

    Attributes
    ----------
    difference
        Probability of the second less that of the first, over pairs of valid shots; NaN without.
    low, high
        Its interval: Newcombe's hybrid score interval for paired data (1998), method 10. That of
        the simulation alone, which shrinks with the shots. Where neither scatters both are the
        difference.
    confidence
        Of the intervals.
    both, only_first, only_second, neither
        Pairs by what counts.
    first, second
        Each setting by itself.
    by
        What counts: in a scene of one's own, one of its ends.
    sample
        Where there are measured releases: the interval of the difference which contains the
        uncertainty of the sample. As many rows in the same groups are pairs, row by row; others are
        independent samples. None without measured releases.
    """

    difference: float
    low: float
    high: float
    confidence: float
    both: int
    only_first: int
    only_second: int
    neither: int
    first: Estimate | Shares
    second: Estimate | Shares
    by: str = "made"
    sample: SampleInterval | None = None

    @property
    def still(self) -> bool:
        """True if neither setting scatters, so that nothing needs to be estimated."""
        return self.first.still and self.second.still

    @property
    def pairs(self) -> int:
        """Pairs in which neither shot is invalid."""
        return self.both + self.only_first + self.only_second + self.neither

    @property
    def gain(self) -> float:
        """The factor by which more shots would be needed without common random numbers.

        The ratio of the variances of the difference; infinite where no pair differs.
        """
        n = self.pairs
        first, second = self.both + self.only_first, self.both + self.only_second
        alone = first * (n - first) + second * (n - second)
        paired = n * (self.only_first + self.only_second) - (second - first) ** 2
        return alone / paired if paired else inf

    def _gain_in_words(self) -> str:
        if isinf(self.gain):
            return "no pair differs"
        return f"worth {self.gain:.3g} times the shots without common random numbers"

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows; None for what is not a number."""
        settings = {"first": self.first.as_dict(), "second": self.second.as_dict()}
        plain = dict(vars(self))
        more = {"pairs": self.pairs, "gain": self.gain, **settings}
        sample = plain.pop("sample")
        more |= {"sample": sample.as_dict()} if sample is not None else {}
        return {name: for_json(value) for name, value in (plain | more).items()}

    def __str__(self) -> str:
        digits = percent_decimals(self.half_width)
        made = [format_percent(one.share_of(self.by), digits) for one in (self.first, self.second)]
        alone = "" if self.sample is None else " of the simulation alone"
        level = format_percent(self.confidence, None)
        ends = f", {format_points(self.low, digits)} to {format_points(self.high, digits)}"
        text = f"{ends} (Newcombe's paired {level} interval{alone})"
        of_sample = self.sample and say_difference(self.sample, self.confidence)
        return "\n".join(
            [
                f"first       {made[0]} {self.by}",
                f"second      {made[1]} {self.by}",
                f"difference  {format_points(self.difference, digits)} points"
                f"{f' ({STILL})' if self.still else text}",
                *([f"sample      {of_sample}"] if of_sample else []),
                f"pairs       {self.pairs:,}: {self.both:,} both {self.by}, "
                f"{self.only_first:,} the first only, {self.only_second:,} the second only, "
                f"{self.neither:,} neither",
                f"gain        {self._gain_in_words()}",
                "",
                footer(NAMES + 3, describe_estimate(self.first), describe_estimate(self.second)),
            ]
        )


@check_arguments
def compare(
    first: SettingLike,
    second: SettingLike,
    *,
    scene: SceneLike = None,
    by: str | None = None,
    shots: int | None = None,
    precision: float | None = None,
    confidence: float = 0.95,
    seed: int = 0,
    max_contacts: int | None = None,
    backend: BackendName = "auto",
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
    scene
        As for `hoopgen.simulate`.
    by
        What counts, an end of the scene: by default the first, and of the hoop made shots.
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
        _setting(name, one, scene) for name, one in (("first", first), ("second", second))
    )
    level = check_share("confidence", confidence)
    engine = settings[0].scene
    contacts = contacts_of(max_contacts, engine)
    most = most_shots(shots, precision, level, paired=True)
    job = MonteCarloJob(settings, most, check_seed(seed), contacts, backend, outcome_by(engine, by))
    rule = StoppingRule(
        precision, lambda total: _comparison(job, total, level).half_width, progress
    )
    total = rule.total(job, folder, scheduler, threads)
    return _with_sample(_comparison(job, total, level), job, threads)


def _setting(argument: str, given: Any, scene: SceneLike) -> ResolvedSetting:
    """Return a setting of a comparison, a model or a pair of it and parameters."""
    pair = given if isinstance(given, tuple) else (given, None)
    if len(pair) != 2:
        raise TypeError(
            f"{argument}: expected a release model or a pair of it and parameters, "
            f"got {brief(given)}"
        )
    return setting_of(*pair, scene, argument)


def _with_sample(found: Comparison, job: MonteCarloJob, threads: int | None) -> Comparison:
    """Return a comparison with the intervals that contain the uncertainty of measured releases."""
    rows = [job.rows(which, threads) for which in (0, 1)]
    first, second = rows
    if first is None and second is None:
        return found
    one, other = (setting.model for setting in job.settings)
    paired = isinstance(one, Resample) and isinstance(other, Resample) and one.same_groups(other)
    if first is not None and second is not None and paired:
        valid = first.valid & second.valid
        made, before = second.outcome == job.by, first.outcome == job.by
        sample = difference_of_rows(made, before, valid, first.cluster, found.confidence)
    else:
        sample = _apart(found, rows, job.by)
    return replace(
        found,
        first=found.first.with_rows(first),
        second=found.second.with_rows(second),
        sample=sample,
    )


def _apart(found: Comparison, rows: list[Rows | None], by: int) -> SampleInterval:
    """Return the interval of the difference of samples that do not pair.

    A model that is no sample has the interval of the simulation.
    """
    name, sides, samples = found.by, [], []
    for one, of_rows in zip((found.first, found.second), rows, strict=True):
        if of_rows is None:
            sides.append((one.share_of(name), one.ends_of(name)))
        else:
            share = of_rows.share(by, found.confidence)
            sides.append((share.value, (share.low, share.high)))
            samples.append(share)
    low, high = newcombe_apart(*sides[1], *sides[0])
    groups = [share.groups for share in samples if share.groups is not None]
    return SampleInterval(
        sides[1][0] - sides[0][0],
        low,
        high,
        sum(share.rows for share in samples),
        sum(groups) if len(groups) == len(samples) else None,
    )


def _comparison(job: MonteCarloJob, total: NDArray[np.int64], level: float) -> Comparison:
    """Return the comparison of two settings from the numbers."""
    both, only_first, only_second, neither = total[2 * width_of(job.scene) :].tolist()
    pairs = both + only_first + only_second + neither
    difference = (only_second - only_first) / pairs if pairs else nan
    low, high = newcombe_interval(both, only_second, only_first, neither, level)
    if pairs and all(is_still(setting.model) for setting in job.settings):
        low = high = difference
    return Comparison(
        difference=difference,
        low=low,
        high=high,
        confidence=level,
        both=both,
        only_first=only_first,
        only_second=only_second,
        neither=neither,
        first=estimated(job, total, 0, level),
        second=estimated(job, total, 1, level),
        by=job.scene.kernels.ENDS[job.by],
    )
