"""`estimate`: the probability that a shot is made, from shots that a seed reproduces."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from os import PathLike
from typing import TypedDict, Unpack, overload

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.backend_names import BackendName
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.variables import check_names
from hoopgen.scene.lookup import SceneLike, check_hoop
from hoopgen.simulation.engine import Engine
from hoopgen.study.jobs.chunks import Progress
from hoopgen.study.jobs.monte_carlo import MonteCarloJob, setting_of
from hoopgen.study.jobs.stopping import StoppingRule, most_shots
from hoopgen.study.measures.measures import MEASURES, measures_of
from hoopgen.study.measures.rebounds import CATCHING_HEIGHT, check_height
from hoopgen.study.models.fitted_scatter import FittedScatter
from hoopgen.study.models.random import check_seed
from hoopgen.study.models.release_model import ReleaseModel
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.statistics.fitted_sample import sample_of_fit
from hoopgen.study.statistics.outcome_shares import Shares
from hoopgen.study.statistics.tally import check_share, contacts_of

from .estimate_result import Estimate, estimated
from .gradient import check_gradient


class _Options(TypedDict, total=False):
    shots: int | None
    precision: float | None
    measures: Iterable[str]
    catching_height: float
    gradient: Sequence[str]
    confidence: float
    seed: int
    max_contacts: int | None
    backend: BackendName
    threads: int | None
    folder: str | PathLike[str] | None
    scheduler: str | None
    progress: Progress | None


@overload
def estimate(
    model: ReleaseModel | FittedScatter[Scatter],
    parameters: ParameterValues | None = None,
    *,
    scene: None = None,
    **options: Unpack[_Options],
) -> Estimate: ...


@overload
def estimate(
    model: ReleaseModel | FittedScatter[Scatter],
    parameters: ParameterValues | None = None,
    *,
    scene: SceneLike,
    **options: Unpack[_Options],
) -> Estimate | Shares: ...


@check_arguments
def estimate(
    model: ReleaseModel | FittedScatter[Scatter],
    parameters: ParameterValues | None = None,
    *,
    scene: SceneLike = None,
    shots: int | None = None,
    precision: float | None = None,
    measures: Iterable[str] = (),
    catching_height: float = CATCHING_HEIGHT,
    gradient: Sequence[str] = (),
    confidence: float = 0.95,
    seed: int = 0,
    max_contacts: int | None = None,
    backend: BackendName = "auto",
    threads: int | None = None,
    folder: str | PathLike[str] | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> Estimate | Shares:
    """Estimate how probably a shot is made; in a scene of one's own, how it ends.

    Parameters
    ----------
    model
        Where the shots come from: `Scatter`, `Resample`, one of your own, or what `Scatter.fit`
        returned for a player. Where there is no hoop, of states.
    parameters
        Of the scene, one number each; those left out have its usual values.
    scene
        As for `hoopgen.simulate`.
    shots
        How many; with a precision, at most. By default 100,000; with a precision 10^9.
    precision
        Stop as soon as half the interval, the widest of several, is no wider; looked at after
        every `CHUNK` shots.
    measures
        Names of `hoopgen.study.measures.measures.MEASURES`: how each is spread is in
        `Estimate.measured`; of rebound_angle, how many rebounds go where. Only where there is a
        hoop.
    catching_height
        Of rebounds, as for `hoopgen.measure`.
    gradient
        Names of what the probability is differentiated by: ``mean.speed`` and ``sd.speed`` of a
        variable that scatters, of a `Scatter`, by its score; or a parameter of the scene, by a
        difference over the same random numbers, which takes four times the shots for each. Only
        where there is a hoop, and not of measured releases without a fitted scatter. See
        `hoopgen.study.questions.gradient`.
    confidence
        Of the interval, within 0 and 1.
    seed
        From 0 to 2^64 - 1. One seed gives one result, whatever computes it.
    max_contacts, backend
        As for `hoopgen.simulate`.
    threads, folder, scheduler
        Who computes, and where finished chunks are kept and gone on from; see `chunks.run`. A
        folder may be asked for more shots, fewer, or another precision: what it has not is thrown,
        and the result is that of an estimate which asked for as much from the start.
    progress
        Called with the chunks that are done and their number, as far as that is known.

    Returns
    -------
    Estimate or Shares
        Where there is a hoop, the probability of a made shot with its interval, and shots by
        outcome and kind; else the share of each outcome with its interval.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    fitted, model = (model, model.model) if isinstance(model, FittedScatter) else (None, model)
    setting = setting_of(model, parameters, scene)
    level = check_share("confidence", confidence)
    contacts = contacts_of(max_contacts, setting.scene)
    most = most_shots(shots, precision, level)
    names = _measured(measures, setting.scene)
    slopes = check_gradient(gradient, setting)
    if slopes:
        check_hoop("gradient", setting.scene)
    job = MonteCarloJob(
        (setting,),
        most,
        check_seed(seed),
        contacts,
        backend,
        measures=names,
        catching_height=check_height(catching_height),
        gradient=slopes,
    )
    rule = StoppingRule(
        precision, lambda total: estimated(job, total, 0, level).half_width, progress
    )
    total = rule.total(job, folder, scheduler, threads)
    found = estimated(job, total, 0, level).with_rows(job.rows(0, threads))
    if fitted is None or isinstance(found, Shares):
        return found
    return replace(found, sample=sample_of_fit(fitted, setting, found, contacts, backend, threads))


def _measured(measures: Iterable[str], scene: Engine) -> tuple[str, ...]:
    """Return the names of measures, each once; refuse those that there are not."""
    names = tuple(dict.fromkeys(check_names("measures", measures, MEASURES)))
    if names:
        check_hoop("measures", scene)
        check_names("measures", names, measures_of(scene))
    return names
