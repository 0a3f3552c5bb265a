"""The best release for a player's scatter.

Its probability is estimated again with fresh random numbers: that of the search is the greatest of
many, and so a little too good.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

from hoopgen.notebook import Said
from hoopgen.parameters import PAPER
from hoopgen.simulation import simulate

from .draws import check_two_seeds
from .estimate import newcombe
from .margins import MARGINS, Margin
from .margins import margins as margins_of
from .measures import measure
from .models import Scatter
from .player import BY, By, Player, Thrown, arguments_of, one_each
from .search import Bounds, bounds_of, flat_about, search
from .tallies import check_count, check_scene, check_share, wilson
from .told import footer, in_a_note, say_scene, told_of
from .variables import resolve_variables
from .words import between, for_json, percent, say

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["Optimum", "optimum", "paired", "scattering"]

_PLOTTED = 2_000
"""Shots whose shares are beside their paths."""


@dataclass(frozen=True)
class Optimum(Said):
    """The release with the greatest probability of success.

    Attributes
    ----------
    release
        The variables searched over, at their best, and those given; SI.
    arguments
        The same as arguments of `hoopgen.release`.
    entry_angle, depth
        Of the shot without scatter, as `hoopgen.measure` gives them: angle below the horizontal at
        the ring's plane, rad, and how far past the ring's centre it comes down, or without contact
        would have come down, m.
    by
        What counts as success.
    probability, low, high
        Share of fresh shots, other than those of the search, that succeed; its Wilson interval.
        An invalid shot is no trial.
    made, shots, invalid
        How many of them succeed, were drawn, and could not be simulated.
    confidence
        Of the interval.
    seed
        Of the search; the fresh shots are those of the next one.
    tolerance
        What `flat` and `Margin.steady` let the probability fall by.
    flat
        By variable searched over: the range in which, the others chosen to suit, the probability
        was found to stay within the tolerance of the best.
    bounds
        Where was searched.
    margins
        By variable.
    sd, correlation
        The scatter.
    parameters
        Of the scene, those in `release` among them.
    """

    release: Mapping[str, float]
    arguments: Mapping[str, float]
    entry_angle: float
    depth: float
    by: By
    probability: float
    low: float
    high: float
    made: int
    shots: int
    invalid: int
    confidence: float
    seed: int
    tolerance: float
    flat: Mapping[str, Bounds]
    bounds: Mapping[str, Bounds]
    margins: Mapping[str, Margin]
    sd: Mapping[str, float]
    correlation: Mapping[tuple[str, str], float]
    parameters: Mapping[str, float]

    @property
    def at_bounds(self) -> tuple[str, ...]:
        """Variables whose flat range reaches a bound: the best may lie beyond it."""
        return tuple(
            name
            for name, (low, high) in self.flat.items()
            if low <= self.bounds[name][0] or high >= self.bounds[name][1]
        )

    def lead(self, other: Optimum) -> tuple[float, float, float]:
        """Return by how much this probability is above another's, and the interval of it.

        Of the same fresh shots for both: Newcombe's interval for paired data (1998). Pairs with an
        invalid shot do not count.

        Raises
        ------
        ValueError
            If the two are not of as many shots and one seed.
        """
        if (self.shots, self.seed) != (other.shots, other.seed):
            raise ValueError("other: expected an optimum of as many shots and the same seed")
        mine, others = (
            Player(one.sd, one.correlation, one.parameters, one.by).scored(
                one.release, one.shots, one.seed + 1
            )
            for one in (self, other)
        )
        return paired(mine, others, self.confidence)

    def plot(self, **options: Any) -> Figure | Axes:
        """Draw paths of its fresh shots; options, and what is returned, as for `plots.plot_fan`.

        The shares in the key are those of the first 2000 at most.
        """
        player = Scatter(self.release, self.sd, self.correlation)
        shots = player.draw(0, min(self.shots, _PLOTTED), self.seed + 1, self.parameters)
        told = told_of(self.parameters, self.sd, self.correlation, self.seed + 1, self.release)
        options = {"note": in_a_note(told)} | options
        return simulate(shots.states, shots.parameters, record=True).plot(**options)

    def told(self) -> dict[str, str]:
        """Return what it rests on, in words, by what it is: scene, scatter, seed."""
        return told_of(self.parameters, self.sd, self.correlation, self.seed)

    def as_dict(self) -> dict[str, Any]:
        """Return everything in types that JSON knows; SI. What is not a number is None."""
        plain = asdict(self)
        plain["scene"] = say_scene(self.parameters)
        plain["correlation"] = {",".join(pair): r for pair, r in self.correlation.items()}
        plain["at_bounds"] = list(self.at_bounds)
        return {name: for_json(value) for name, value in plain.items()}

    def __str__(self) -> str:
        given = self.arguments
        shot = [f"{say('speed', given['speed'])} at {say('elevation', given['elevation'])}"]
        shot += [f"{name} {say(name, given[name])}" for name in ("azimuth", "backspin", "sidespin")]
        flat = "; ".join(f"{name} {between(name, *ends)}" for name, ends in self.flat.items())
        lines = [
            f"release  {', '.join(shot)}",
            f"flight   down at {say('entry', self.entry_angle)}, {say('aim', self.depth)} past the "
            "centre",
            f"success  {percent(self.probability)}, {100 * self.low:.1f} to {percent(self.high)} "
            f"({self.confidence:.0%} of {self.shots:,} shots, seed {self.seed}): {BY[self.by]}",
            *([f"invalid  {self.invalid:,} shots, not counted"] if self.invalid else []),
            f"flat     {flat}: within {100 * self.tolerance:g} points of that",
            *(f"bound    {name}: the best may lie beyond" for name in self.at_bounds),
            *(f"margin   {margin.line}" for margin in self.margins.values()),
            "",
            footer(9, self.told()),
        ]
        return "\n".join(lines)


def optimum(
    over: Mapping[str, Bounds | None] | Sequence[str],
    release: Mapping[str, float],
    sd: Mapping[str, float],
    correlation: Mapping[tuple[str, str], float] | None = None,
    parameters: Mapping[str, Any] = PAPER,
    *,
    by: By = "any",
    shots: int = 100_000,
    seed: int = 0,
    confidence: float = 0.95,
    tolerance: float = 0.01,
    margins: Sequence[str] = MARGINS,
    threads: int | None = None,
) -> Optimum:
    """Return the release with the greatest probability of success for a player's scatter.

    Parameters
    ----------
    over
        Variables to search over and their bounds; None, or names alone, for the usual bounds.
        `aim` is searched more easily than `speed`, since it does not hang on the elevation.
    release
        The other variables, one number each: height and place above all.
    sd
        Standard deviations, as for `Scatter`.
    correlation
        Of pairs of names in `sd`.
    parameters
        Of the scene, one number each.
    by
        What counts: "any" shot made, "direct" if the board is not touched first, "bank" if it is.
    shots
        Of the last step of the search, and of the fresh estimate.
    seed
        From 0 to 2^64 - 2. The search throws its shots, the estimate those of ``seed + 1``.
    confidence
        Of the interval.
    tolerance
        The fall in probability that is still called flat.
    margins
        Variables whose margins are wanted.
    threads
        As for `hoopgen.simulate`.

    Returns
    -------
    Optimum
        The same for the same arguments, whatever the threads.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described, or no release within the bounds succeeds.
    """
    player = scattering(sd, correlation, parameters, by, threads)
    fixed = one_each("release", release)
    bounds = bounds_of(over, fixed, player)
    check_count("shots", shots)
    check_share("confidence", confidence)
    check_share("tolerance", tolerance)
    check_two_seeds(seed)
    point = search(player, bounds, fixed, shots, seed)
    if point is None:
        where = "; ".join(f"{name} {between(name, *ends)}" for name, ends in bounds.items())
        raise ValueError(f"over: no release tried succeeds within {where}")
    best = fixed | point
    player = player.at(best)
    thrown = player.thrown(best, shots, seed + 1)
    made, valid = int(thrown.made[0]), int(thrown.valid[0])
    low, high = map(float, wilson(made, valid, confidence))
    entry_angle, depth = _coming_down(best, player)
    few = min(shots, max(10_000, shots // 10))
    return Optimum(
        release=best,
        arguments=arguments_of(best, player.parameters),
        entry_angle=entry_angle,
        depth=depth,
        by=by,
        probability=float(thrown.share[0]),
        low=low,
        high=high,
        made=made,
        shots=shots,
        invalid=shots - valid,
        confidence=confidence,
        seed=seed,
        tolerance=tolerance,
        flat=flat_about(player, bounds, fixed, point, few, seed, tolerance),
        bounds=bounds,
        margins=margins_of(
            best,
            player.parameters,
            names=margins,
            by=by,
            sd=sd,
            correlation=correlation,
            shots=few,
            seed=seed,
            tolerance=tolerance,
            threads=threads,
        ),
        sd=player.sd,
        correlation=player.correlation,
        parameters=player.parameters,
    )


def paired(mine: Thrown, others: Thrown, confidence: float) -> tuple[float, float, float]:
    """Return by how much the share of the first shots is above that of the second, and interval.

    Of the pairs in which both are valid; the difference is NaN if there are none.
    """
    valid = mine.valid & others.valid
    first, second = mine.made[valid], others.made[valid]
    both, only_first, only_second, neither = (
        int((a & b).sum()) for a in (first, ~first) for b in (second, ~second)
    )
    difference = (only_first - only_second) / len(first) if len(first) else math.nan
    return difference, *newcombe(both, only_first, only_second, neither, confidence)


def scattering(
    sd: Mapping[str, float],
    correlation: Mapping[tuple[str, str], float] | None,
    parameters: Mapping[str, Any],
    by: By,
    threads: int | None = None,
) -> Player:
    """Return a player who scatters.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described for `optimum`.
    """
    player = Player(dict(sd), dict(correlation or {}), check_scene(parameters), by, threads)
    if not any(sd.values()):
        raise ValueError("sd: expected a deviation above 0; without scatter a shot succeeds or not")
    return player


def _coming_down(release: Mapping[str, float], player: Player) -> tuple[float, float]:
    """Return entry angle and depth of the shot without scatter."""
    shot = resolve_variables(release, player.parameters)
    shots = simulate(shot.states, shot.parameters)
    found = measure(shot.states, shots, shot.parameters, ("entry_angle", "depth"))
    return found["entry_angle"].item(), found["depth"].item()
