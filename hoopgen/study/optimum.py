"""The best release for a player's scatter.

Its probability is estimated again with fresh random numbers: that of the search is the greatest of
many, and so a little too good.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from os import PathLike
from typing import Any

from hoopgen.hoop.presets import PAPER
from hoopgen.hoop.variables import VARIABLES, change_variables, resolve_variables
from hoopgen.inputs import check_count
from hoopgen.simulation import simulate
from hoopgen.variables import check_names
from hoopgen.words import between

from .best import Optimum
from .crew import crew
from .draws import check_two_seeds
from .intervals import wilson
from .margins import MARGINS, margins_about
from .measures import measure
from .of_hoop import of_hoop
from .player import Bounds, By, Player, arguments_of
from .resample import Resample
from .scatter import Scatter
from .scattering import check_thrown
from .search import bounds_of, flat_about, search
from .tallies import check_scene, check_share

__all__ = ["optimum", "scattering"]


@of_hoop
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
