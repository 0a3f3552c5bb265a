"""`Estimate`: the probability that a shot is made, with its interval, in words and numbers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from math import nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.hoop.kinds import Kind, hoop_outcomes
from hoopgen.report.provenance import describe_setting, footer
from hoopgen.report.quantities import STILL, for_json
from hoopgen.results.shots import Outcome
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.hoop import HOOP
from hoopgen.study.jobs.differences import COUNTS
from hoopgen.study.jobs.monte_carlo import MonteCarloJob, tally_of
from hoopgen.study.models.release_model import is_still
from hoopgen.study.models.scores import SUMS
from hoopgen.study.result import SharesOfShots
from hoopgen.study.statistics.distributions import (
    Spread,
    spread_lines,
    spreads,
    spreads_of_sample,
    width_of,
)
from hoopgen.study.statistics.intervals import wilson_interval
from hoopgen.study.statistics.outcome_shares import Shares, shares_of
from hoopgen.study.statistics.sample import Rows, SampleInterval, say_sample
from hoopgen.study.statistics.tally import Tally
from hoopgen.text.numbers import format_interval, format_percent, format_uncertain, percent_decimals

from .gradient import Slope, difference_slopes, score_slopes, slope_lines

NAMES = 9
"""Width of the column of names, in letters."""


@dataclass(frozen=True, repr=False)
class Estimate(SharesOfShots):
    """The probability that a shot is made.

    An invalid shot is no trial: `probability` is of the others. A capped one is a trial and not
    made, since the model does not decide it; `with_capped` is the probability if all had gone in.

    Attributes
    ----------
    probability
        made / (shots - invalid); NaN if all are invalid.
    low, high
        Wilson's interval of it: that of the simulation alone, which shrinks with the shots. Without
        scatter every throw is the same, and both are the probability.
    confidence
        Of the intervals.
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
    scene
        In which the shots were thrown.
    lodged, endless
        Shots at rest on the hoop, and those still on their way at the time limit: none where no
        ball rolls.
    measured
        How measures are spread, by their names: those that were asked for.
    rolled
        Shots that rolled, whatever became of them.
    slip_left
        Capped ones whose bounces ended with slip left, which friction could not stop.
    sample
        Of measured releases, and of a scatter fitted to them: the interval of the probability that
        contains the uncertainty of the sample. None of other models.
    still
        Whether nothing scatters, so that there is nothing to be estimated.
    gradient
        Derivatives of the probability by the names that were asked for, with their intervals.
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
    scene: Engine = field(default=HOOP, compare=False)
    lodged: int = 0
    endless: int = 0
    measured: Mapping[str, Spread] = field(default_factory=dict)
    rolled: int = 0
    slip_left: int = 0
    sample: SampleInterval | None = None
    still: bool = False
    gradient: Mapping[str, Slope] = field(default_factory=dict)

    @property
    def shares(self) -> dict[str, float]:
        """Shares of the kinds among the valid shots; NaN without any."""
        return {name: self._share(count) for name, count in self._valid_kinds.items()}

    @property
    def _valid_kinds(self) -> dict[str, int]:
        """The numbers of valid shots by kind; an invalid one is of the kind "none"."""
        none = Kind.NONE.name.lower()
        return {n: count - self.invalid * (n == none) for n, count in self.kinds.items()}

    def share_of(self, by: str) -> float:
        """Return the share of the valid shots that end in one way; NaN without any.

        Parameters
        ----------
        by
            The way: the name of an attribute with their number, such as "made".
        """
        return self._share(getattr(self, by))

    def _share(self, count: int) -> float:
        """Return the share of so many of the valid shots; NaN without any."""
        valid = self.shots - self.invalid
        return int(count) / valid if valid else nan

    def ends_of(self, by: str) -> tuple[float, float]:
        """Return both ends of the interval of `share_of`.

        Parameters
        ----------
        by
            As for `share_of`.
        """
        if self.still:
            return self.share_of(by), self.share_of(by)
        low, high = wilson_interval(getattr(self, by), self.shots - self.invalid, self.confidence)
        return float(low), float(high)

    def with_rows(self, rows: Rows | None) -> Estimate:
        """Return the estimate with intervals that contain the uncertainty of the sample.

        Parameters
        ----------
        rows
            The shots of each measured release; None leaves the estimate as it is.
        """
        if rows is None:
            return self
        sample = rows.share(Outcome.MADE, self.confidence)
        return replace(self, sample=sample, measured=spreads_of_sample(self.measured, rows))

    @property
    def with_capped(self) -> float:
        """Probability if all capped shots had been made."""
        return self._share(self.made + self.capped)

    @property
    def rolled_share(self) -> float:
        """Share of the shots that rolled; the invalid ones are no trials."""
        return self._share(self.rolled)

    def _made(self, digits: int) -> list[str]:
        """Say the probability with its intervals."""
        text = f"made     {format_percent(self.probability, digits)}"
        if self.still:
            return [f"{text} ({STILL})"]
        level = format_percent(self.confidence, None)
        alone = "" if self.sample is None else " of the simulation alone"
        ends = format_interval(self.low, self.high, digits)
        lines = [f"{text}, {ends} (Wilson's {level} interval{alone})"]
        if self.sample is not None:
            lines.append(f"sample   {say_sample(self.sample, self.confidence)}")
        return lines

    def _capped(self, digits: int) -> str:
        slipping = f"; {self.slip_left:,} of them with slip left" if self.slip_left else ""
        return f"{format_percent(self.with_capped, digits)} if made{slipping}"

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows; None for what is not a number."""
        more: dict[str, Any] = {"with_capped": self.with_capped, "shares": self.shares}
        plain = dict(vars(self))
        more["scene"] = describe_setting(self.setting, self.scene)["scene"]
        measured = {name: one.as_dict() for name, one in plain.pop("measured").items()}
        more |= {"measured": measured} if measured else {}
        slopes = {name: one.as_dict() for name, one in plain.pop("gradient").items()}
        more |= {"gradient": slopes} if slopes else {}
        sample = plain.pop("sample")
        more |= {"sample": sample.as_dict()} if sample is not None else {}
        return {name: for_json(value) for name, value in (plain | more).items()}

    def __str__(self) -> str:
        digits = percent_decimals(self.half_width)
        ended = (outcome.name.lower() for outcome in hoop_outcomes(self.scene.rolls))
        counts = [f"{getattr(self, name):,} {name}" for name in ended]
        counts.append(format_uncertain(self.uncertain, self.uncertain_capped))
        lines = [*self._made(digits), f"shots    {self.shots:,}: {', '.join(counts)}"]
        if self.scene.rolls:
            share = format_percent(self.rolled_share, 2)
            lines.append(f"rolled   {share}: {self.rolled:,} of the shots")
        if self.capped:
            lines.append(f"capped   {self._capped(digits)}")
        lines += ["", "kind         share  of it made"]
        lines += [
            f"{name.replace('_', ', '):10}  {format_percent(self.shares[name]):>6}"
            f"  {format_percent(self.kinds_made[name] / count):>10}"
            for name, count in self._valid_kinds.items()
            if count
        ]
        lines += spread_lines(self.measured)
        lines += slope_lines(self.gradient, self.scene, self.confidence)
        return "\n".join([*lines, "", footer(NAMES, describe_estimate(self))])


def estimated(
    job: MonteCarloJob, total: NDArray[np.int64], which: int, level: float
) -> Estimate | Shares:
    """Return the estimate of one setting from the numbers.

    Parameters
    ----------
    job
        The job that the shots were thrown in.
    total
        The numbers of all of its settings.
    which
        The index of the setting.
    level
        The confidence of the intervals, from 0 to 1.
    """
    tally = tally_of(total, which, job.scene)
    if not job.scene.has_hoop:
        return shares_of(tally, job.settings[which], level, job.seed)
    return _estimated(job, total, tally, which, level)


def _estimated(
    job: MonteCarloJob, total: NDArray[np.int64], tally: Tally, which: int, level: float
) -> Estimate:
    own, outcomes = job.settings[which], hoop_outcomes(job.scene.rolls)
    ended: dict[str, Any] = {one.name.lower(): int(tally.ended(one)) for one in outcomes}
    valid = int(tally.valid)
    still = is_still(own.model)
    share = ended["made"] / valid if valid else nan
    low, high = (share, share) if still and valid else wilson_interval(ended["made"], valid, level)
    names = [kind.name.lower() for kind in Kind]
    widths = [width_of(job.measures), SUMS * len(job.scored), COUNTS * len(job.differenced)]
    first = len(total) - sum(widths)
    counts, scores, pairs = np.split(total[first:], np.cumsum(widths)[:-1])
    differences = {name: own.differences(name) for name in job.differenced}
    slopes = {
        **score_slopes(own.model, job.scored, scores, valid, ended["made"], level),
        **difference_slopes(differences, pairs, level),
    }
    return Estimate(
        probability=share,
        low=float(low),
        high=float(high),
        confidence=level,
        shots=int(tally.shots),
        **ended,
        uncertain=int(tally.uncertain),
        uncertain_capped=int(tally.uncertain_capped),
        rolled=int(tally.counts.get("rolled", 0)),
        slip_left=int(tally.counts.get("slip_left", 0)),
        kinds=dict(zip(names, tally.of_kind().tolist(), strict=True)),
        kinds_made=dict(zip(names, tally.table[:, Outcome.MADE].tolist(), strict=True)),
        seed=job.seed,
        setting=own.identity(),
        scene=job.scene,
        measured=spreads(counts, job.measures, level, job.catching_height),
        still=still,
        gradient={name: slopes[name] for name in job.gradient},
    )


def describe_estimate(found: Estimate | Shares) -> dict[str, str]:
    """Return the provenance of an estimate as text."""
    return describe_setting(found.setting, found.scene) | {"seed": str(found.seed)}
