"""Probabilities that shots go in, each given the track of its ball."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.extras import require
from hoopgen.study.result import Result
from hoopgen.text.tables import table

if TYPE_CHECKING:
    from pandas import DataFrame

Floats = NDArray[np.float64]

_SHOWN = 10
"""Shots that are listed in text."""


@dataclass(frozen=True, eq=False, repr=False)
class MadeGivenTrack(Result):
    """Probabilities that shots go in, given their tracks.

    Attributes
    ----------
    probability
        (n,); NaN of a track that is not credible.
    low, high
        Wilson's interval of the simulation, (n,).
    shots
        Number of simulated shots that are valid, (n,).
    confidence
        Of the interval.
    labels
        Of the tracks.
    """

    probability: Floats
    low: Floats
    high: Floats
    shots: NDArray[np.int64]
    confidence: float
    labels: tuple[Hashable, ...]

    def __len__(self) -> int:
        return len(self.probability)

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows."""
        names = ("probability", "low", "high", "shots")
        found = {
            name: [None if one != one else one for one in getattr(self, name).tolist()]
            for name in names
        }
        return {"track": [str(one) for one in self.labels], **found, "confidence": self.confidence}

    def to_pandas(self) -> DataFrame:
        """Return a pandas.DataFrame, a row each track.

        Raises
        ------
        ImportError
            If pandas is missing: what brings it.
        """
        names = ("probability", "low", "high", "shots")
        columns = {"track": list(self.labels), **{name: getattr(self, name) for name in names}}
        frame: DataFrame = require("pandas", "to_pandas").DataFrame(columns)
        return frame

    def __str__(self) -> str:
        def percent(value: float) -> str:
            return "-" if value != value else f"{100.0 * value:.1f}%"

        rows = [
            [str(label), percent(share), f"{percent(low)} to {percent(high)}"]
            for label, share, low, high in zip(
                self.labels[:_SHOWN], self.probability, self.low, self.high, strict=False
            )
        ]
        head = f"{100.0 * self.confidence:g}% interval of the simulation"
        text = table(["track", "made", head], rows, right=[1])
        more = len(self) - len(rows)
        return text + (f"\nand {more:,} more" if more > 0 else "")
