"""The number of shots of an estimate: as many as are asked for, or up to a precision."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass
from math import ceil, sqrt
from os import PathLike

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.memory import format_whole
from hoopgen.core.validation import check_count
from hoopgen.study.statistics.intervals import least_shots
from hoopgen.study.statistics.tally import check_share

from .chunks import Progress, run
from .monte_carlo import CHUNK, SHOTS, MonteCarloJob, numbers_of, tally_of

MAX_SHOTS = 1_000_000_000
"""Largest number of shots of an estimate that runs to a precision."""


@dataclass(frozen=True)
class StoppingRule:
    """The rule that sums chunks in their order until a precision is reached."""

    precision: float | None
    half_width: Callable[[NDArray[np.int64]], float]
    progress: Progress | None

    def total(
        self,
        work: MonteCarloJob,
        folder: str | PathLike[str] | None,
        scheduler: str | None,
        threads: int | None,
    ) -> NDArray[np.int64]:
        """Return the sum of as many chunks as it takes.

        Parameters
        ----------
        work
            The job; it has no more chunks than the most shots allow.
        folder
            The folder in which chunks are stored and found again; None to store none.
        scheduler
            The address of a Dask scheduler; None for threads.
        threads
            The number of threads; None for one per processor.

        Returns
        -------
        array of int64
            The sum of `MonteCarloJob.count` over the chunks.

        Raises
        ------
        ValueError
            If a precision is asked for and no shot of the first chunk is valid.
        """
        total = work.count(0, 1) * 0  # what is wrong shows before a folder is made
        note = self.progress or (lambda done, of: None)
        note(0, None if self.precision else work.chunks)
        tables = run(work, folder, scheduler=scheduler, threads=threads)
        with closing(tables):
            for done, table in enumerate(tables, 1):
                total += numbers_of(table)
                needed = self._needed(done, total, work)
                note(done, needed)
                if done == needed:
                    break
        return total

    def _needed(self, done: int, total: NDArray[np.int64], work: MonteCarloJob) -> int:
        """Return the expected number of chunks."""
        most = work.chunks
        if self.precision is None:
            return most
        tallies = (tally_of(total, which, work.scene) for which in range(len(work.settings)))
        if done == 1 and not all(tally.valid for tally in tallies):
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


def most_shots(
    shots: int | None, precision: float | None, level: float, *, paired: bool = False
) -> int:
    """Return the number of shots, or the most of them.

    Parameters
    ----------
    shots
        The number that the caller gave; None for the default.
    precision
        The half width of the interval that is asked for; None for a fixed number of shots.
    level
        The confidence of the interval.
    paired
        True if the answer is a difference of two settings with common random numbers.

    Raises
    ------
    ValueError
        If an argument is out of range, or the precision takes more shots than are simulated unless
        `shots` says so.
    """
    if precision is not None:
        check_share("precision", precision)
    if shots is not None:
        return check_count("shots", shots)
    if precision is None:
        return SHOTS
    if (least := least_shots(precision, level, paired=paired)) > MAX_SHOTS:
        raise ValueError(
            f"precision: {precision} takes {format_whole(least)} shots at least, whatever "
            "becomes of "
            f"them, and at most {format_whole(MAX_SHOTS)} are simulated unless shots says so"
        )
    return MAX_SHOTS
