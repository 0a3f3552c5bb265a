"""`assess`: predicted probabilities of shots beside what happened, in all and by player."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.plotting import plotting_module
from hoopgen.core.units import use_units
from hoopgen.core.validation import as_doubles, check_count
from hoopgen.study.models.fitted_scatter import FittedScatter
from hoopgen.study.models.measured_columns import Measured
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.result import Result
from hoopgen.study.statistics.intervals import wilson_interval
from hoopgen.study.statistics.success_counts import count_quantile
from hoopgen.study.statistics.tally import check_share
from hoopgen.text.numbers import format_count, format_interval, format_percent
from hoopgen.text.shorten import brief
from hoopgen.text.tables import table

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

_BINS, _LEAST = 10, 10
"""Most bins of a calibration, and the fewest shots of one where there are more."""


@dataclass(frozen=True)
class Predicted:
    """Shots, how many were predicted to be made, and how many were.

    Attributes
    ----------
    shots
        With a probability.
    predicted
        Sum of the probabilities.
    low, high
        The made shots that the probabilities allow: the interval of a sum of independent shots.
    made
        Made shots.
    share_low, share_high
        Wilson's interval of the share made.
    """

    shots: int
    predicted: float
    low: int
    high: int
    made: int
    share_low: float
    share_high: float

    @property
    def agrees(self) -> bool:
        """True if the made shots are as many as the probabilities allow."""
        return self.low <= self.made <= self.high


@dataclass(frozen=True, repr=False)
class Assessment(Result):
    """Predictions beside what happened.

    Attributes
    ----------
    total
        All shots.
    bins
        Shots with similar probabilities, the smallest first: the calibration.
    players
        By label; empty without labels.
    log_likelihood
        Sum of the logarithms of the probabilities of what happened.
    brier
        Mean squared difference of the probability from 1 for made and 0 for missed.
    base_log_likelihood, base_brier
        The same of one probability for all shots, the share made among the others (leave-one-out).
    left_out
        Shots without a probability.
    scatters
        Of fitted releases, the scatter of each player with enough of them.
    confidence
        Of the intervals.
    """

    total: Predicted
    bins: tuple[Predicted, ...]
    players: Mapping[str, Predicted]
    log_likelihood: float
    brier: float
    base_log_likelihood: float
    base_brier: float
    left_out: int
    scatters: Mapping[str, FittedScatter[Scatter]]
    confidence: float

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows."""
        return {
            "total": vars(self.total),
            "bins": [vars(one) for one in self.bins],
            "players": {label: vars(one) for label, one in self.players.items()},
            "log_likelihood": self.log_likelihood,
            "brier": self.brier,
            "base_log_likelihood": self.base_log_likelihood,
            "base_brier": self.base_brier,
            "left_out": self.left_out,
            "scatters": {label: one.as_dict() for label, one in self.scatters.items()},
            "confidence": self.confidence,
        }

    def plot(self, *, ax: Drawn | None = None, title: str = "") -> Drawn:
        """Draw the calibration; as of `hoopgen.plots.plot_calibration`.

        Parameters
        ----------
        ax
            The axes to draw on; None makes a figure.
        title
            The title; empty for the usual one.
        """
        drawn: Drawn = plotting_module().plot_calibration(self, ax=ax, title=title)
        return drawn

    def report(self, player: str) -> str:
        """Return a short report on a player, in feet and mph.

        Parameters
        ----------
        player
            A label in `players`.
        """
        if player not in self.players:
            known = ", ".join(self.players) or "none"
            raise ValueError(f"player: expected one of {known}, got {brief(player)}")
        one = self.players[player]
        verdict = "as many as predicted" if one.agrees else "not as many as predicted"
        lines = [
            f"{player}: {one.made} of {format_count(one.shots, 'shot')} made, {verdict} "
            f"({one.predicted:.1f}; {one.low} to {one.high})"
        ]
        if player in self.scatters:
            with use_units("us"):
                lines.append(str(self.scatters[player]))
        return "\n".join(lines)

    def __str__(self) -> str:
        level = format_percent(self.confidence, None)
        heads = ["", "shots", "predicted", f"{level} of such", "made", "share", f"{level} interval"]
        rows = [_row("all", self.total)]
        rows += [_row(f"bin {k}", one) for k, one in enumerate(self.bins, 1)]
        rows += [_row(label, one) for label, one in self.players.items()]
        lines = [
            table(heads, rows, right=range(1, 7)),
            "",
            f"log-likelihood {self.log_likelihood:.2f}, of one share for all "
            f"{self.base_log_likelihood:.2f}; Brier score {self.brier:.3f}, of one share "
            f"{self.base_brier:.3f}",
        ]
        if self.left_out:
            lines.append(f"left out: {format_count(self.left_out, 'shot')} without a probability")
        return "\n".join(lines)


def _row(label: str, one: Predicted) -> list[str]:
    share = one.made / one.shots
    return [
        label,
        f"{one.shots:,}",
        f"{one.predicted:.1f}",
        f"{one.low} to {one.high}",
        f"{one.made:,}",
        format_percent(share),
        format_interval(one.share_low, one.share_high),
    ]


@runtime_checkable
class SimulatedProbabilities(Protocol):
    """Probabilities that were simulated, such as `FittedReleases.made` returns."""

    @property
    def probability(self) -> Floats:
        """Return the probability of each shot, (n,)."""
        ...

    @property
    def shots(self) -> NDArray[np.int64]:
        """Return the number of simulated shots of each, (n,)."""
        ...


@check_arguments
def assess(
    probability: ArrayLike | SimulatedProbabilities,
    made: ArrayLike,
    *,
    player: Iterable[object] | None = None,
    releases: Measured | None = None,
    shots: int | None = None,
    confidence: float = 0.95,
) -> Assessment:
    """Compare predicted probabilities of shots with what happened.

    Parameters
    ----------
    probability
        Of each shot, (n,), NaN where there is none; or what `FittedReleases.made` returned.
    made
        Whether each shot was made, (n,).
    player
        Label of each shot's player, (n,).
    releases
        What `hoopgen.fit_release` returned for the same shots: the reports on players then have
        their mean release and spread.
    shots
        Number of shots that were simulated for each probability, by which 0 and 1 are no
        certainties: a share of k shots counts as (k p + 1/2) / (k + 1). Of what
        `FittedReleases.made` returned it is known. None: the probabilities are exact.
    confidence
        Of the intervals.

    Returns
    -------
    Assessment
        In all, by bins of probability, and by player.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described, or no shot has a probability.
    """
    level = check_share("confidence", confidence)
    if isinstance(probability, SimulatedProbabilities):
        shots = int(np.max(probability.shots, initial=0)) if shots is None else shots
        probability = probability.probability
    elif shots is not None:
        check_count("shots", shots)
    p = as_doubles("probability", probability)
    hit = np.asarray(made)
    if p.ndim != 1:
        raise ValueError(f"probability: expected one for each shot, (n,), got {brief(probability)}")
    if hit.shape != p.shape:
        raise ValueError(
            f"made: expected a value for each of {p.shape} probabilities, got {hit.shape}"
        )
    if not np.isin(hit, (0, 1)).all():
        raise ValueError(f"made: expected true or false, got {brief(made)}")
    if np.any((p < 0.0) | (p > 1.0)):
        raise ValueError(f"probability: expected numbers from 0 to 1, got {brief(probability)}")
    labels = None if player is None else np.array([str(one) for one in player], dtype=object)
    if labels is not None and labels.shape != p.shape:
        raise ValueError(f"player: expected a label for each of {len(p)} shots, got {len(labels)}")
    there = np.isfinite(p)
    if not there.any():
        raise ValueError("probability: no shot has one")
    q, truth = p[there], hit[there].astype(bool)
    if shots:
        q = (shots * q + 0.5) / (shots + 1.0)
    owners = None if labels is None else labels[there]
    by_player = {} if owners is None else {one: owners == one for one in dict.fromkeys(owners)}
    likelihood = _log_likelihood(q, truth)
    if len(q) > 1:
        # The share made among the other shots; the half keeps it off 0 and 1.
        base = (truth.sum() - truth + 0.5) / len(q)
    else:
        base = np.full(1, 0.5)
    return Assessment(
        _predicted(q, truth, level),
        tuple(_predicted(q[rows], truth[rows], level) for rows in _bins(q)),
        {label: _predicted(q[rows], truth[rows], level) for label, rows in by_player.items()},
        likelihood,
        float(np.mean((q - truth) ** 2)),
        _log_likelihood(base, truth),
        float(np.mean((base - truth) ** 2)),
        int((~there).sum()),
        _scatters(releases, labels),
        level,
    )


def _log_likelihood(p: Floats, made: Flags) -> float:
    with np.errstate(divide="ignore"):
        return float(np.sum(np.log(np.where(made, p, 1.0 - p))))


def _bins(p: Floats) -> list[NDArray[np.intp]]:
    """Return the shots of bins with about as many each, by probability; equal ones together."""
    count = max(1, min(_BINS, len(p) // _LEAST))
    edges = np.unique(np.quantile(p, np.linspace(0.0, 1.0, count + 1)[1:-1]))
    which = np.searchsorted(edges, p, side="right")
    return [np.flatnonzero(which == k) for k in np.unique(which)]


def _predicted(p: Floats, made: Flags, level: float) -> Predicted:
    """Return the made shots, and how many there are by the probabilities."""
    tail = 0.5 - 0.5 * level
    low, high = (count_quantile(p, at) for at in (tail, 1.0 - tail))
    count = int(made.sum())
    ends = wilson_interval(count, len(p), level)
    most = min(high, len(p))
    return Predicted(len(p), float(p.sum()), low, most, count, float(ends[0]), float(ends[1]))


def _scatters(
    releases: Measured | None, labels: NDArray[np.object_] | None
) -> dict[str, FittedScatter[Scatter]]:
    """Return the scatter of each player with enough releases."""
    if releases is None:
        return {}
    if labels is None:
        found = Scatter.fit(releases)
        return {"all": found} if isinstance(found, FittedScatter) else {}
    by_player = Scatter.fit(releases, group=labels)
    return {} if isinstance(by_player, FittedScatter) else dict(by_player)
