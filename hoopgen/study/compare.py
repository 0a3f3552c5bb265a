"""`compare`: which of two settings is made more often, over the same random numbers."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from math import inf, nan
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.hoop.presets import PAPER
from hoopgen.inputs import MAX_CONTACTS, Backend, check_contacts
from hoopgen.phrases import decimals, percent, points
from hoopgen.told import footer
from hoopgen.words import for_json

from .draws import check_seed
from .estimate import NAMES, Estimate, estimated, told
from .intervals import newcombe
from .of_hoop import of_hoop
from .said import Said
from .tallies import COLUMNS, check_share
from .throws import Progress, Setting, Until, Work, most_shots, setting_of

__all__ = ["Comparison", "compare"]


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
                footer(NAMES + 3, told(self.first), told(self.second)),
            ]
        )


@of_hoop
def compare(
    first: Setting,
    second: Setting,
    *,
    shots: int | None = None,
    precision: float | None = None,
    confidence: float = 0.95,
    seed: int = 0,
    max_contacts: int = MAX_CONTACTS,
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
        setting_of(*one) if isinstance(one, tuple) else setting_of(one, PAPER)
        for one in (first, second)
    )
    level = check_share("confidence", confidence)
    contacts = check_contacts(max_contacts)
    most = most_shots(shots, precision, level, paired=True)
    work = Work(settings, most, check_seed(seed), contacts, backend)
    until = Until(precision, lambda total: _comparison(work, total, level).half_width, progress)
    total = until.total(work, folder, scheduler, threads)
    return _comparison(work, total, level)


def _comparison(work: Work, total: NDArray[np.int64], level: float) -> Comparison:
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
        first=estimated(work, total, 0, level),
        second=estimated(work, total, 1, level),
    )
