"""`solve`: how wide a player's scatter is, given how often the shots are made.

The share of shots made with a factor times the scatter, all factors with the same random numbers,
is a function of the factor that hardly jumps: where it passes the wanted share is found by its
sign. Factors whose interval of the share has the wanted one in it are not excluded: those about the
one found are its interval.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import pairwise
from math import inf, isfinite, log2
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.backend_names import BackendName
from hoopgen.core.parameters import ParameterValues
from hoopgen.report.quantities import for_json
from hoopgen.scene.lookup import SceneLike
from hoopgen.simulation.engine import Engine
from hoopgen.study.jobs.chunks import Progress
from hoopgen.study.jobs.monte_carlo import (
    MonteCarloJob,
    numbers_of,
    outcome_by,
    scene_identity,
    setting_of,
    tally_of,
)
from hoopgen.study.jobs.stopping import most_shots
from hoopgen.study.jobs.task_runner import TaskRunner, task_runner
from hoopgen.study.models.random import check_two_seeds
from hoopgen.study.models.requirements import scaled
from hoopgen.study.models.resample import Resample
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.result import SharesOfShots
from hoopgen.study.statistics.intervals import wilson_interval
from hoopgen.study.statistics.outcome_shares import Shares
from hoopgen.study.statistics.tally import blocks, check_share, contacts_of
from hoopgen.text.numbers import format_count, format_percent, percent_decimals
from hoopgen.text.shorten import brief

from .estimate_result import Estimate, estimated

FACTORS = (0.0, *(2.0 ** (half / 2) for half in range(-8, 9)))
"""Times the scatter: between which of them the share passes the wanted one is looked at first."""


@dataclass(frozen=True, repr=False)
class Solution(SharesOfShots):
    """The factor times a scatter with which a wanted share of the shots is made.

    Attributes
    ----------
    share
        What was wanted, of the valid shots.
    by
        What counts: "made"; in a scene of one's own, one of its ends.
    factor
        All of the scatter times this gives that share.
    low, high
        Its interval: with any other factor near it, Wilson's interval of the share does not have
        the wanted one in it. Infinite, if the greatest of `FACTORS` is not excluded. It is that of
        the simulation alone; of measured releases the sample leaves more open, which `estimate`
        says of the share.
        Both are the factor where the share jumps past the wanted one, as of few measured releases.
    confidence
        Of the intervals.
    elsewhere
        Other factors with which the share is the wanted one; `factor` is the nearest to 1.
    shots, seed
        Thrown with each factor.
    model
        The player with the scaled scatter.
    estimate
        At it, of as many fresh shots, those of ``seed + 1``.
    scene
        In which the shots were thrown.
    """

    share: float
    by: str
    factor: float
    low: float
    high: float
    confidence: float
    elsewhere: Sequence[float]
    shots: int
    seed: int
    model: Scatter | Resample
    estimate: Estimate | Shares
    scene: Engine = field(compare=False)

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows."""
        plain = dict(vars(self)) | {"estimate": self.estimate.as_dict()}
        del plain["scene"]
        plain |= {"elsewhere": list(self.elsewhere), "model": self.model.identity()}
        return {name: for_json(value) for name, value in plain.items()}

    @property
    def line(self) -> str:
        """The factor with its interval, and for what."""
        if self.low == self.high:
            wanted = f"{_exactly(self.share)} {self.by}"
            return f"{self.factor:.3g} times the scatter, where the share jumps past {wanted}"
        half = 0.5 * (self.high - self.low)
        digits = percent_decimals(0.01 * half) if isfinite(half) else 3
        high = f"to {self.high:.{digits}f}" if isfinite(self.high) else "or more"
        return (
            f"{self.factor:.{digits}f} times the scatter, {self.low:.{digits}f} {high}, "
            f"for {_exactly(self.share)} {self.by}"
        )

    def __str__(self) -> str:
        measured = isinstance(self.model, Resample)
        alone = " of the simulation alone" if measured else ""
        interval = f" ({format_percent(self.confidence, None)} interval{alone})"
        interval = interval if self.low < self.high else ""
        lines = [
            f"factor   {self.line}{interval}",
            f"thrown   {format_count(self.shots, 'shot')} with each factor, seed {self.seed}; "
            "below, as many fresh ones with this",
        ]
        if measured:
            lines.append("scatter  how far each measured release is from their means, times that")
        if self.elsewhere:
            text = ", ".join(f"{factor:.3g}" for factor in self.elsewhere)
            lines.append(f"caution  so it is with {text} times the scatter, too")
        return "\n".join([*lines, "", str(self.estimate)])


def _exactly(share: float) -> str:
    """Say a share as it was given."""
    return f"{100.0 * share:.12g}%"


@check_arguments
def solve(
    model: Scatter | Resample,
    share: float,
    parameters: ParameterValues | None = None,
    *,
    scene: SceneLike = None,
    by: str | None = None,
    shots: int | None = None,
    confidence: float = 0.95,
    seed: int = 0,
    max_contacts: int | None = None,
    backend: BackendName = "auto",
    threads: int | None = None,
    folder: str | PathLike[str] | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> Solution:
    """Find the factor times all of a scatter with which a share of the shots is made.

    "I make 70%", and how speed, angle and direction scatter beside each other is known from others:
    how much do mine?

    Parameters
    ----------
    model
        The player. Of a `Scatter` all standard deviations are multiplied, of a `Resample` how far
        each measured release is from their means.
    share
        Wanted, within 0 and 1: made ones of the valid shots.
    parameters, scene
        As for `hoopgen.estimate`.
    by
        What counts, an end of the scene: by default the first, and of the hoop made shots.
    shots
        Thrown with each factor, the same random numbers with all; and for the estimate. By default
        100,000.
    confidence
        Of the intervals.
    seed
        From 0 to 2^64 - 2. The estimate is of fresh shots, those of ``seed + 1``.
    max_contacts, backend
        As for `hoopgen.simulate`.
    threads, folder, scheduler, progress
        As for `hoopgen.estimate`. How many chunks there will be is not known; and a folder is for
        one number of shots.

    Returns
    -------
    Solution
        The factor, its interval, and the estimate at it. Of several factors the nearest to 1.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described; if nothing scatters; or if none of the factors tried,
        `FACTORS`, leads to the share: with what they lead to.
    """
    check_scatters(model)
    setting = setting_of(model, parameters, scene)
    engine = setting.scene
    end = outcome_by(engine, by)
    check_share("share", share)
    level = check_share("confidence", confidence)
    many = most_shots(shots, None, level)
    contacts = contacts_of(max_contacts, engine)

    def work(factor: float, seed: int) -> MonteCarloJob:
        scaled_setting = setting_of(scaled(model, factor), parameters, engine)
        return MonteCarloJob((scaled_setting,), many, seed, contacts, backend, end)

    first = check_two_seeds(seed)
    work(0.0, first).count(0, 1)  # what is wrong shows before a folder is made
    identity = {
        "solve": {"share": float(share), "confidence": level, **setting.identity()},
        **scene_identity(engine),
        "by": end,
        "shots": many,
        "seed": first,
        "max_contacts": contacts,
    }
    with task_runner(
        identity, folder, scheduler=scheduler, threads=threads, progress=progress
    ) as together:
        curve = _Curve(partial(work, seed=first), together, float(share), level)
        factor, elsewhere = curve.solved(_possible(model))
        low, high = curve.edge(factor, -1), curve.edge(factor, 1)
        fresh = work(factor, first + 1)
        (total,) = _totals([fresh], together)
    return Solution(
        share=float(share),
        by=engine.kernels.ENDS[end],
        factor=factor,
        low=low,
        high=high,
        confidence=level,
        elsewhere=elsewhere,
        shots=many,
        seed=first,
        model=scaled(model, factor),
        estimate=estimated(fresh, total, 0, level).with_rows(fresh.rows(0, threads)),
        scene=engine,
    )


def check_scatters(model: Any) -> None:
    """Refuse a model whose scatter cannot be multiplied."""
    if not isinstance(model, Scatter | Resample):
        raise TypeError(f"model: expected a Scatter or a Resample, got {brief(model)}")
    if model.still:
        raise ValueError(
            "model: nothing scatters, so there is nothing to multiply; give sd, --scatter"
        )


def _possible(model: Scatter | Resample) -> list[float]:
    """Return the factors with which there is a scatter: that of an angle has a limit."""
    found = []
    for factor in FACTORS:
        try:
            scaled(model, factor)
        except ValueError:
            break
        found.append(factor)
    return found


def _totals(works: Sequence[MonteCarloJob], runner: TaskRunner) -> list[NDArray[np.int64]]:
    """Return the sums of the numbers of each work."""
    parts = [list(blocks(0, work.shots)) for work in works]
    tasks = [
        partial(work.counted, 0, *block)
        for work, own in zip(works, parts, strict=True)
        for block in own
    ]
    tables = iter(runner(tasks))
    return [np.sum([numbers_of(next(tables)) for _ in own], axis=0) for own in parts]


@dataclass(frozen=True)
class _Curve:
    """The share over the factor, with common random numbers.

    Attributes
    ----------
    seen
        Shots that count, and valid ones, by factor.
    """

    work: Callable[[float], MonteCarloJob]  # throws the shots with a factor
    runner: TaskRunner  # runs the tasks
    wanted: float  # the share that is looked for
    level: float  # confidence of its intervals
    seen: dict[float, tuple[int, int]] = field(default_factory=dict)

    def look(self, factors: Sequence[float]) -> None:
        """Throw with factors that were not looked at yet."""
        works = {factor: self.work(factor) for factor in factors if factor not in self.seen}
        for (factor, work), total in zip(
            works.items(), _totals([*works.values()], self.runner), strict=True
        ):
            tally = tally_of(total, 0, work.scene)
            self.seen[factor] = int(tally.ended(work.by)), int(tally.valid)

    def above(self, factor: float) -> float:
        """Return the difference of the share from the wanted one."""
        self.look([factor])
        made, valid = self.seen[factor]
        if not valid:
            raise ValueError(f"model: no shot is valid with {factor:.6g} times the scatter")
        return made / valid - self.wanted

    def excluded(self, factor: float) -> float:
        """Return the distance of the wanted share from the interval; negative within it."""
        self.look([factor])
        low, high = wilson_interval(*self.seen[factor], self.level)
        return max(float(low) - self.wanted, self.wanted - float(high))

    def solved(self, factors: Sequence[float]) -> tuple[float, list[float]]:
        """Return the factor nearest to 1 that gives the wanted share, and the others."""
        self.look(factors)
        known = [factor for factor in factors if self.seen[factor][1]]
        if not known:
            raise ValueError("model: no shot is valid, with any factor times the scatter")
        pairs = [
            (low, high)
            for low, high in pairwise(known)
            if (self.above(low) >= 0.0) != (self.above(high) >= 0.0)
        ]
        if not pairs:
            raise ValueError(self._never(known))
        found = [self._root(self.above, *pair) for pair in pairs]
        nearest = min(found, key=lambda factor: abs(log2(max(factor, FACTORS[1] / 2.0))))
        return nearest, [factor for factor in found if factor != nearest]

    def edge(self, factor: float, side: int) -> float:
        """Return an end of the interval: beyond it the wanted share is outside of those seen."""
        inside = factor
        if self.excluded(inside) > 0.0:  # of so few shots that one more is too many
            return factor
        for other in sorted(FACTORS, reverse=side < 0):
            if other not in self.seen or side * (other - factor) <= 0.0:
                continue
            if self.excluded(other) > 0.0:
                return self._root(self.excluded, inside, other)
            inside = other
        return 0.0 if side < 0 else inf

    def _root(self, of: Callable[[float], float], one: float, other: float) -> float:
        """Return the factor at which a function changes its sign, to a part of the interval."""
        _, valid = self.seen[other]
        # The factor is open by about the root of the shots; a hundredth of that is not seen.
        near = 0.01 * max(one, other) / max(valid, 1) ** 0.5
        return float(brentq(of, *sorted((one, other)), xtol=near))

    def _never(self, known: Sequence[float]) -> str:
        """Return the shares at the factors tried, as text."""
        shares = {factor: self.above(factor) + self.wanted for factor in known}
        over = self.above(known[0]) >= 0.0
        ending = (min if over else max)(known, key=lambda factor: shares[factor])
        name = self.work(0.0).scene.kernels.ENDS[self.work(0.0).by]

        def said(factor: float) -> str:
            where = f"with {factor:.3g} times the scatter" if factor else "without scatter"
            return f"{format_percent(shares[factor])} {where}"

        beside = [said(known[0])] if ending != known[0] else []
        return (
            f"share: {_exactly(self.wanted)} {name} is reached by no factor from 0 to "
            f"{known[-1]:.3g}: {'at least' if over else 'at most'} "
            f"{'; '.join([said(ending), *beside])}"
        )
