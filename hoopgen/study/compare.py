"""`compare`: which of two settings is made more often, over the same random numbers."""

from __future__ import annotations

from dataclasses import dataclass, fields
from math import inf, nan
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.inputs import Backend
from hoopgen.phrases import decimals, percent, points
from hoopgen.told import footer
from hoopgen.words import for_json

from .draws import check_seed
from .estimate import NAMES, Estimate, estimated, told
from .intervals import newcombe
from .said import SharesOfShots
from .shares import Shares
from .tallies import check_share, contacts_of, width_of
from .throws import Progress, Setting, Until, Work, most_shots, outcome_by, setting_of

__all__ = ["Comparison", "compare"]


@dataclass(frozen=True, repr=False)
class Comparison(SharesOfShots):
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
        Pairs by what counts.
    first, second
        Each setting by itself.
    by
        What counts: in a scene of one's own, one of its ends.
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
        plain = {one.name: getattr(self, one.name) for one in fields(self)}
        more = {"pairs": self.pairs, "gain": self.gain, **settings}
        return {name: for_json(value) for name, value in (plain | more).items()}

    def __str__(self) -> str:
        digits = decimals(self.half_width)
        made = [percent(one.share_of(self.by), digits) for one in (self.first, self.second)]
        ends = f"{points(self.low, digits)} to {points(self.high, digits)}"
        return "\n".join(
            [
                f"first       {made[0]} {self.by}",
                f"second      {made[1]} {self.by}",
                f"difference  {points(self.difference, digits)} points, {ends} "
                f"(Newcombe's paired {percent(self.confidence, None)} interval)",
                f"pairs       {self.pairs:,}: {self.both:,} both {self.by}, "
                f"{self.only_first:,} the first only, {self.only_second:,} the second only, "
                f"{self.neither:,} neither",
                f"gain        worth {self.gain:.3g} times the shots without common random numbers",
                "",
                footer(NAMES + 3, told(self.first), told(self.second)),
            ]
        )


def compare(
    first: Setting,
    second: Setting,
    *,
    scene: Any = None,
    by: str | None = None,
    shots: int | None = None,
    precision: float | None = None,
    confidence: float = 0.95,
    seed: int = 0,
    max_contacts: int | None = None,
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
        setting_of(*one, scene) if isinstance(one, tuple) else setting_of(one, None, scene)
        for one in (first, second)
    )
    level = check_share("confidence", confidence)
    engine = settings[0].scene
    contacts = contacts_of(max_contacts, engine)
    most = most_shots(shots, precision, level, paired=True)
    work = Work(settings, most, check_seed(seed), contacts, backend, outcome_by(engine, by))
    until = Until(precision, lambda total: _comparison(work, total, level).half_width, progress)
    total = until.total(work, folder, scheduler, threads)
    return _comparison(work, total, level)


def _comparison(work: Work, total: NDArray[np.int64], level: float) -> Comparison:
    """Return what the numbers say of two settings."""
    both, only_first, only_second, neither = total[2 * width_of(work.scene) :].tolist()
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
        first=estimated(work, total, 0, level),
        second=estimated(work, total, 1, level),
        by=work.scene.kernels.ENDS[work.by],
    )
