"""The best release for a player's scatter.

Its probability is estimated again with fresh random numbers: that of the search is the greatest of
many, and so a little too good.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, fields, replace
from os import PathLike
from typing import TYPE_CHECKING, Any

from hoopgen.inputs import check_count
from hoopgen.notebook import Said
from hoopgen.parameters import PAPER
from hoopgen.simulation import simulate

from .advice import advice
from .crew import crew
from .draws import check_two_seeds
from .intervals import newcombe, wilson
from .margins import MARGINS, Margin, margins_about
from .measures import measure
from .player import By, Player, Thrown, arguments_of
from .resample import Resample
from .scatter import Scatter
from .scattering import check_thrown
from .search import Bounds, bounds_of, flat_about, search
from .tallies import check_scene, check_share
from .told import in_a_note, say_release, told_setting
from .variables import VARIABLES, change_variables, check_names, resolve_variables
from .words import between, for_json

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["Optimum", "optimum", "paired", "scattering"]

_PLOTTED = 2_000
"""Shots whose shares are beside their paths."""


@dataclass(frozen=True, repr=False)
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
    model
        The player: where the shots about it come from.
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
    model: Scatter | Resample
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
            one._player().scored(one.point, one.shots, one.seed + 1) for one in (self, other)
        )
        return paired(mine, others, self.confidence)

    def plot(self, **options: Any) -> Figure | Axes:
        """Draw paths of its fresh shots; options, and what is returned, as for `plots.plot_fan`.

        The shares in the key are those of the first 2000 at most.
        """
        player, few = self._player(), min(self.shots, _PLOTTED)
        noise = player.model.noise(0, few, self.seed + 1)
        shots = player.model.around(self.point, noise, self.parameters, few)
        options = {"note": in_a_note(self._drawn())} | options
        return simulate(shots.states, shots.parameters, record=True).plot(**options)

    def told(self) -> dict[str, str]:
        """Return what it rests on, in words, by what it is: scene, release, scatter, seed."""
        setting = {**self.model.identity(), "parameters": self.parameters}
        return {**told_setting(setting), "seed": str(self.seed)}

    def _drawn(self) -> dict[str, str]:
        """Return what its fresh shots rest on."""
        told = self.told()
        if isinstance(self.model, Scatter):
            release = say_release(self.release)
        else:
            moved = say_release({name: self.release[name] for name in self.bounds})
            release = f"{told['release']}, their means at {moved}"
        return told | {"release": release, "seed": str(self.seed + 1)}

    @property
    def point(self) -> dict[str, float]:
        """What its shots are thrown about: the release, but for what measured releases say."""
        fixed, _ = self.model.apart()
        return fixed | {name: self.release[name] for name in self.bounds}

    def _player(self) -> Player:
        return Player(self.model.apart()[1], self.parameters, self.by)

    def as_dict(self) -> dict[str, Any]:
        """Return everything in types that JSON knows; SI. What is not a number is None."""
        plain = {one.name: getattr(self, one.name) for one in fields(self)}
        plain["scene"] = self.told()["scene"]
        plain["margins"] = {name: asdict(margin) for name, margin in self.margins.items()}
        plain["model"] = self.model.identity()
        plain["at_bounds"] = list(self.at_bounds)
        return {name: for_json(value) for name, value in plain.items()}

    def __str__(self) -> str:
        return advice(self)


def optimum(
    model: Scatter | Resample,
    over: Mapping[str, Bounds | None] | Sequence[str],
    parameters: Mapping[str, Any] = PAPER,
    *,
    by: By = "any",
    shots: int = 100_000,
    seed: int = 0,
    confidence: float = 0.95,
    tolerance: float = 0.01,
    margins: Sequence[str] = MARGINS,
    threads: int | None = None,
    folder: str | PathLike[str] | None = None,
    scheduler: str | None = None,
    progress: Callable[[int, int | None], None] | None = None,
) -> Optimum:
    """Return the release with the greatest probability of success for a player's scatter.

    Parameters
    ----------
    model
        The player. Of a `Scatter` the release says the variables that are not searched over: height
        and place above all. Of a `Resample` the mean is moved, what is searched over and what that
        stands for, and how far the measured releases are from it stays as it is.
    over
        Variables to search over and their bounds; None, or names alone, for the usual bounds.
        `aim` is searched more easily than `speed`, since it does not hang on the elevation.
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
    threads, folder, scheduler, progress
        As for `hoopgen.estimate`. How many chunks there will be is not known.

    Returns
    -------
    Optimum
        The same for the same arguments, whoever computes.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described, or no release within the bounds succeeds.
    """
    over = over if isinstance(over, Mapping) else (over,) if isinstance(over, str) else tuple(over)
    player = scattering(model, over, parameters, by)
    fixed, centre = model.apart()[0], model.centre
    bounds = bounds_of(over, centre, player)
    check_count("shots", shots)
    check_share("confidence", confidence)
    check_share("tolerance", tolerance)
    check_two_seeds(seed)
    margins = check_names("names", margins, VARIABLES)
    lowest = {name: low for name, (low, _) in bounds.items()}
    player.thrown(fixed | lowest, 1, seed)  # what is wrong shows before a folder is made
    identity = {
        "optimum": {"model": model.identity(), "over": bounds, "parameters": player.parameters},
        "by": by,
        "shots": shots,
        "seed": seed,
        "tolerance": tolerance,
        "margins": list(margins),
    }
    with crew(
        identity, folder, scheduler=scheduler, threads=threads, progress=progress
    ) as together:
        player = replace(player, crew=together)
        point = search(player, bounds, fixed, shots, seed)
        if point is None:
            where = "; ".join(f"{name} {between(name, *ends)}" for name, ends in bounds.items())
            raise ValueError(f"over: no release tried succeeds within {where}")
        best = change_variables(centre, point)
        player = player.at(best)
        thrown = player.thrown(fixed | point, shots, seed + 1)
        few = min(shots, max(10_000, shots // 10))
        flat = flat_about(player, bounds, fixed, point, few, seed, tolerance)
        forgiven = margins_about(best, margins, player, few, seed, tolerance)
    made, valid = int(thrown.made[0]), int(thrown.valid[0])
    low, high = map(float, wilson(made, valid, confidence))
    entry_angle, depth = _coming_down(best, player)
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
        flat=flat,
        bounds=bounds,
        margins=forgiven,
        model=model,
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
    model: Scatter | Resample, over: Iterable[str], parameters: Mapping[str, Any], by: By
) -> Player:
    """Return a player who scatters.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described for `optimum`.
    """
    names = (over,) if isinstance(over, str) else over
    player = Player(check_thrown(model, names).apart()[1], check_scene(parameters), by)
    if model.still:
        raise ValueError("sd: expected a deviation above 0; without scatter a shot succeeds or not")
    return player


def _coming_down(release: Mapping[str, float], player: Player) -> tuple[float, float]:
    """Return entry angle and depth of the shot without scatter."""
    shot = resolve_variables(release, player.parameters)
    shots = simulate(shot.states, shot.parameters)
    found = measure(shot.states, shots, shot.parameters, ("entry_angle", "depth"))
    return found["entry_angle"].item(), found["depth"].item()
