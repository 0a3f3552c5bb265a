"""The scatter of players, fitted to their measured releases: what `Scatter.fit` returns."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.units import display_unit
from hoopgen.core.validation import check_count
from hoopgen.hoop.variables import VARIABLES
from hoopgen.text.html import Printed
from hoopgen.text.numbers import format_count
from hoopgen.text.shorten import brief, join_names
from hoopgen.text.tables import table

from .random import POSTERIOR, uniforms
from .shrinkage import PROBABILITIES

Floats = NDArray[np.float64]
Model = TypeVar("Model")
Make = Callable[[Mapping[str, float], Mapping[str, float], Mapping[tuple[str, str], float]], Model]

_STREAM = POSTERIOR + 1_000
"""Streams of the draws from what is known of a scatter."""

LARGEST_CORRELATION = 0.995
"""Largest correlation of a fitted scatter, of which every distribution exists."""


@dataclass(frozen=True, eq=False, repr=False)
class Uncertain:
    """A number that is known from a sample.

    Attributes
    ----------
    value
        The estimate.
    quantiles
        Of its confidence distribution, or of its posterior where players were shrunk; at
        `hoopgen.study.models.shrinkage.PROBABILITIES`.
    """

    value: float
    quantiles: Floats

    def interval(self, confidence: float = 0.95) -> tuple[float, float]:
        """Return the ends of the interval.

        Parameters
        ----------
        confidence
            From 0 to 0.998, within which the quantiles are kept.
        """
        if not 0.0 < confidence <= 0.998:
            raise ValueError(
                f"confidence: expected a number above 0, to 0.998, got {brief(confidence)}"
            )
        tail = 0.5 - 0.5 * confidence
        low, high = np.interp([tail, 1.0 - tail], PROBABILITIES, self.quantiles)
        return float(low), float(high)


@dataclass(frozen=True, eq=False, repr=False)
class FittedScatter(Printed, Generic[Model]):
    """A player's scatter that was fitted to measured releases, and how uncertain it is.

    Attributes
    ----------
    model
        The `Scatter`, for `estimate`, `optimum`, `compare` and the like.
    rows
        Measured releases.
    outliers
        Those so far from the others that one good row of 10,000 is there by chance. They have
        little weight.
    mean, sd
        Of each variable that scatters, SI; the measuring errors are not in them.
    correlation
        Of pairs of those.
    measured_sd
        Standard deviations with the measuring errors of a typical row.
    fixed
        Variables that are the same in all rows.
    shrunk
        Whether many players were fitted, and each was shrunk towards what they have in common.
    """

    model: Model
    rows: int
    outliers: int
    mean: Mapping[str, Uncertain]
    sd: Mapping[str, Uncertain]
    correlation: Mapping[tuple[str, str], Uncertain]
    measured_sd: Mapping[str, float]
    fixed: Mapping[str, float]
    shrunk: bool
    _make: Make[Model]

    def models(self, count: int, seed: int = 0) -> list[Model]:
        """Return scatters that the measured releases allow, drawn at random.

        How a result varies over them is what the sample leaves open. Means, standard deviations and
        correlations are drawn independently of each other.

        Parameters
        ----------
        count
            Number of models.
        seed
            From 0 to 2^64 - 1.
        """
        count = check_count("count", count)
        known = [*self.mean.values(), *self.sd.values(), *self.correlation.values()]
        drawn = [
            np.interp(uniforms(seed, _STREAM + k, 0, count), PROBABILITIES, one.quantiles)
            for k, one in enumerate(known)
        ]
        names, pairs = list(self.mean), list(self.correlation)
        found = []
        for row in zip(*drawn, strict=True) if drawn else [()] * count:
            mean = dict(zip(names, row, strict=False))
            sd = dict(zip(names, row[len(names) :], strict=False))
            rho = dict(zip(pairs, row[2 * len(names) :], strict=True))
            found.append(self._make({**self.fixed, **mean}, sd, consistent(sd, rho)))
        return found

    def as_dict(self) -> dict[str, Any]:
        """Return the numbers with their 95% intervals, in types that JSON knows; SI."""

        def said(one: Uncertain) -> dict[str, float]:
            low, high = one.interval()
            return {"value": one.value, "low": low, "high": high}

        return {
            "rows": self.rows,
            "outliers": self.outliers,
            "shrunk": self.shrunk,
            "mean": {name: said(one) for name, one in self.mean.items()},
            "sd": {name: said(one) for name, one in self.sd.items()},
            "measured_sd": dict(self.measured_sd),
            "correlation": [
                {"of": list(pair), **said(one)} for pair, one in self.correlation.items()
            ],
            "fixed": dict(self.fixed),
        }

    def cells(self) -> list[list[str]]:
        """Return the rows of a table: variable, mean and spread with their 95% intervals."""
        found = []
        for name, one in self.mean.items():
            spread = self.sd[name]
            ends = [one.interval(), spread.interval()]
            found.append(
                [
                    name,
                    _shown(name, one.value),
                    " to ".join(_shown(name, end, unit=False) for end in ends[0]),
                    _shown(name, spread.value),
                    " to ".join(_shown(name, end, unit=False) for end in ends[1]),
                    _shown(name, self.measured_sd[name], unit=False),
                ]
            )
        return found

    def __str__(self) -> str:
        lines = [f"{format_count(self.rows, 'release')}, {format_count(self.outliers, 'outlier')}"]
        if self.shrunk:
            lines[0] += "; shrunk towards the other players"
        lines += ["", table(HEADS, self.cells(), right=range(1, 6))]
        strong = [
            f"{a}, {b} {one.value:+.2f} ({one.interval()[0]:+.2f} to {one.interval()[1]:+.2f})"
            for (a, b), one in self.correlation.items()
            if one.interval()[0] * one.interval()[1] > 0.0
        ]
        if strong:
            lines += ["", f"correlations other than 0: {'; '.join(strong)}"]
        return "\n".join(lines)


HEADS = ["variable", "mean", "95% interval", "spread", "95% interval", "as measured"]
"""Headings of `FittedScatter.cells`."""


def _shown(name: str, value: float, unit: bool = True) -> str:
    """Return a value of a variable with the digits that a spread needs; a state's in SI."""
    if name not in VARIABLES:
        return f"{value:.4g}"
    one = display_unit(VARIABLES[name].kind)
    digits = max(one.decimals, 2)
    text = f"{value / one.size:.{digits}f}"
    blank = "" if one.symbol == "\u00b0" else " "
    return f"{text}{blank}{one.symbol}" if unit and one.symbol else text


@dataclass(frozen=True, eq=False, repr=False)
class FittedScatters(Printed, Mapping[str, FittedScatter[Model]], Generic[Model]):
    """The scatter of each player, by the player's label."""

    players: Mapping[str, FittedScatter[Model]]
    left_out: Mapping[str, int]  # players with too few rows for a scatter, and their rows

    def __getitem__(self, label: str) -> FittedScatter[Model]:
        return self.players[label]

    def __iter__(self) -> Iterator[str]:
        return iter(self.players)

    def __len__(self) -> int:
        return len(self.players)

    def as_dict(self) -> dict[str, Any]:
        """Return the numbers of each player, in types that JSON knows; SI."""
        players = {label: one.as_dict() for label, one in self.players.items()}
        return {"players": players, "left_out": dict(self.left_out)}

    def __str__(self) -> str:
        parts = [f"{label}: {one}" for label, one in self.players.items()]
        if self.left_out:
            parts.append(f"too few releases: {join_names(self.left_out)}")
        return "\n\n".join(parts)


def consistent(
    sd: Mapping[str, float], rho: Mapping[tuple[str, str], float]
) -> dict[tuple[str, str], float]:
    """Return correlations that some distribution has, near those given.

    Eigenvalues of the matrix that are too small are raised, and its diagonal is made 1 again.

    Parameters
    ----------
    sd
        The standard deviation of each variable, of which the names count.
    rho
        Correlations by pairs of names.
    """
    names = list(sd)
    matrix = np.eye(len(names))
    for (a, b), value in rho.items():
        i, j = names.index(a), names.index(b)
        matrix[i, j] = matrix[j, i] = float(
            np.clip(value, -LARGEST_CORRELATION, LARGEST_CORRELATION)
        )
    values, vectors = np.linalg.eigh(matrix)
    if len(values) and values[0] < 1.0 - LARGEST_CORRELATION:
        matrix = (vectors * np.maximum(values, 1.0 - LARGEST_CORRELATION)) @ vectors.T
        root = np.sqrt(np.diag(matrix))
        matrix = matrix / np.outer(root, root)
    return {
        (a, b): float(
            np.clip(
                matrix[names.index(a), names.index(b)], -LARGEST_CORRELATION, LARGEST_CORRELATION
            )
        )
        for a, b in rho
    }
