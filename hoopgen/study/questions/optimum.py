"""The best release for a player's scatter.

Its probability is not that of the search, which is the greatest of many and so too good: it is
estimated with fresh random numbers, and of measured releases with rows that were held out; then its
interval contains that the releases which these are judged by are not the one that is given.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from math import nan
from os import PathLike

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.validation import check_count
from hoopgen.core.variables import check_names
from hoopgen.hoop.variables import change_variables, resolve_variables
from hoopgen.report.quantities import format_bounds
from hoopgen.scene.lookup import SceneLike, check_hoop, variables_of
from hoopgen.simulation.lookup import engine_of
from hoopgen.simulation.simulate import simulate
from hoopgen.study.jobs.chunks import Progress
from hoopgen.study.jobs.monte_carlo import check_states, outcome_by, scene_identity
from hoopgen.study.jobs.objective import Bounds, Player, Successes, arguments_of, ways_of
from hoopgen.study.jobs.task_runner import task_runner
from hoopgen.study.measures.measures import measure
from hoopgen.study.models.random import check_two_seeds
from hoopgen.study.models.requirements import check_model
from hoopgen.study.models.resample import Resample
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.models.smoothed import smoothed
from hoopgen.study.statistics.intervals import wilson_interval
from hoopgen.study.statistics.sample import share_of_rows
from hoopgen.study.statistics.tally import check_scene, check_share

from .held_out import check_folds, held_out, with_choice
from .margins import margins_about
from .optimum_result import Optimum
from .search import bounds_of, flat_about, search, searched_variables
from .specification import MARGINS


@check_arguments
def optimum(
    model: Scatter | Resample,
    over: Mapping[str, Bounds | None] | Sequence[str] | str,
    parameters: ParameterValues | None = None,
    *,
    scene: SceneLike = None,
    by: str = "any",
    shots: int = 100_000,
    seed: int = 0,
    confidence: float = 0.95,
    tolerance: float = 0.01,
    margins: Sequence[str] | None = None,
    threads: int | None = None,
    folder: str | PathLike[str] | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> Optimum:
    """Return the release with the greatest probability of success for a player's scatter.

    Parameters
    ----------
    model
        The player. Of a `Scatter` the release says the variables that are not searched over: height
        and place above all. Of a `Resample` the mean is moved, what is searched over and what that
        stands for, and how far the measured releases are from it stays as it is; of its `group`
        all rows are held out together.
    over
        Variables to search over and their bounds; None, or names alone, for the usual bounds.
        `aim` is searched more easily than `speed`, since it does not depend on the elevation.
    parameters
        Of the scene, one number each.
    scene
        As for `hoopgen.simulate`. Where there is no hoop the release is a state, and there are no
        usual bounds.
    by
        What counts: "any" shot made, "direct" if the board is not touched first, "bank" if it is.
        Where there is no hoop an end of the scene; "any" is the first.
    shots
        Of the last step of the search, and of the fresh estimate. Of measured releases the search
        throws each row once, or 4,000 shots if they are fewer, and never more than `shots`, with a
        little noise on them (see `hoopgen.study.models.smoothed`); all rows are judged, without
        noise.
    seed
        From 0 to 2^64 - 2. The search throws its shots, the estimate those of ``seed + 1``.
    confidence
        Of the interval.
    tolerance
        Fall in probability within which a range counts as flat.
    margins
        Variables whose margins are wanted: by default `MARGINS`, and none where there is no hoop.
    threads, folder, scheduler, progress
        As for `hoopgen.estimate`. How many chunks there will be is not known.

    Returns
    -------
    Optimum
        The same for the same arguments, whoever computes.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described, no release within the bounds succeeds, or there are too
        few measured releases, or groups of them, to hold some out.
    """
    over = searched_variables(over)
    player = scattering(model, over, parameters, by, scene)
    engine = player.scene
    hoop = engine.has_hoop
    fixed, centre = model.apart()[0], model.centre
    bounds = bounds_of(over, centre, player)
    check_count("shots", shots)
    check_share("confidence", confidence)
    check_share("tolerance", tolerance)
    check_two_seeds(seed)
    wanted = (MARGINS if hoop else ()) if margins is None else tuple(margins)
    if wanted:
        check_hoop("margins", engine)
    margins = check_names("margins", wanted, variables_of(engine))
    if isinstance(model, Resample):
        check_folds(model)
    lowest = {name: low for name, (low, _) in bounds.items()}
    player.sampled(fixed | lowest, 1, seed)  # what is wrong shows before a folder is made
    identity = {
        "optimum": {"model": model.identity(), "over": bounds, "parameters": player.parameters},
        **scene_identity(engine),
        "by": player.by,
        "shots": shots,
        "seed": seed,
        "tolerance": tolerance,
        "margins": list(margins),
    }
    with task_runner(
        identity, folder, scheduler=scheduler, threads=threads, progress=progress
    ) as together:
        player = replace(player, runner=together)
        searcher = player
        if isinstance(model, Resample):
            searcher = replace(player, model=smoothed(model, seed))
        point = search(searcher, bounds, fixed, shots, seed)
        if point is None:
            where = "; ".join(
                f"{n} {format_bounds(n, *ends, at_hoop=hoop)}" for n, ends in bounds.items()
            )
            raise ValueError(f"over: no release tried succeeds within {where}")
        best = change_variables(centre, point) if hoop else {**centre, **point}
        player = player.at(best)
        if isinstance(model, Resample):
            without = held_out(player, model, bounds, fixed, shots, seed)
            judged = without.scored(model, player, fixed)
            shares = without.shares(model, player, fixed, point, seed)
            sample = share_of_rows(judged.made, judged.valid, model.cluster, confidence)
            sample = with_choice(sample, shares, confidence)
            successes, folds = Successes(judged.made.sum(), judged.valid.sum()), without.points
            ways = ways_of(judged.made, judged.kind) if hoop else {}
            low, high, drawn = sample.low, sample.high, model.rows
            player = replace(player, model=searcher.model)
        else:
            successes, ways = player.tally(fixed | point, shots, seed + 1)
            low, high = map(float, wilson_interval(successes.made, successes.valid, confidence))
            folds, drawn = (), shots
        # Shots that the release was chosen by flatter it; others do not.
        few = min(shots, max(10_000, shots // 10)), seed + 1, tolerance
        flat = flat_about(player, bounds, fixed, point, *few)
        forgiven = margins_about(best, margins, player, *few)
    made, valid = int(successes.made), int(successes.valid)
    entry_angle, depth = _coming_down(best, player) if hoop else (nan, nan)
    return Optimum(
        release=best,
        arguments=arguments_of(best, player.parameters) if hoop else {},
        entry_angle=entry_angle,
        depth=depth,
        by=player.by,
        probability=float(successes.share),
        low=low,
        high=high,
        made=made,
        shots=drawn,
        invalid=drawn - valid,
        confidence=confidence,
        seed=seed,
        tolerance=tolerance,
        flat=flat,
        bounds=bounds,
        margins=forgiven,
        model=model,
        parameters=player.parameters,
        scene=engine,
        ways={name: count / valid if valid else nan for name, count in ways.items()},
        folds=folds,
    )


def scattering(
    model: Scatter | Resample,
    over: Iterable[str],
    parameters: ParameterValues | None,
    by: str,
    scene: SceneLike = None,
) -> Player:
    """Return a player who scatters.

    Parameters
    ----------
    model
        The model of the releases.
    over
        The variables whose means are varied.
    parameters
        Parameters of the scene by name, SI.
    by
        The way in that counts: direct, bank or any.
    scene
        The scene; None is the hoop.
    """
    engine = engine_of(scene)
    check_states(check_model(model, over), engine, over)
    if by == "any" and not engine.has_hoop:
        by = engine.kernels.ENDS[outcome_by(engine, None)]
    player = Player(model.apart()[1], check_scene(parameters, engine), by, scene=engine)
    if model.still:
        raise ValueError("sd: expected a deviation above 0; without scatter a shot succeeds or not")
    return player


def _coming_down(release: Mapping[str, float], player: Player) -> tuple[float, float]:
    """Return entry angle and depth of the shot without scatter."""
    shot = resolve_variables(release, player.parameters)
    shots = simulate(shot.states, shot.parameters, scene=player.scene)
    found = measure(shot.states, shots, shot.parameters, ("entry_angle", "depth"))
    return found["entry_angle"].item(), found["depth"].item()
