"""Answers to questions about sampled shots: estimates, comparisons, solutions; and batches."""

from __future__ import annotations

from typing import Any

from hoopgen import plots
from hoopgen.report.provenance import describe_setting, sentences
from hoopgen.report.quantities import STILL
from hoopgen.scene.lookup import check_hoop
from hoopgen.simulation.run import check_log
from hoopgen.simulation.simulate import simulate
from hoopgen.study.jobs.stopping import most_shots
from hoopgen.study.named_units import in_units
from hoopgen.study.questions.batch import batch
from hoopgen.study.questions.compare import Comparison, compare
from hoopgen.study.questions.estimate import estimate
from hoopgen.study.questions.estimate_result import Estimate
from hoopgen.study.questions.landings import landings_of
from hoopgen.study.questions.optimum_result import PLOTTED
from hoopgen.study.questions.solve import Solution, solve
from hoopgen.study.questions.specification import (
    BatchQuestion,
    CompareQuestion,
    EstimateQuestion,
    SolveQuestion,
)
from hoopgen.study.statistics.distributions import in_brief
from hoopgen.study.statistics.outcome_shares import Shares
from hoopgen.study.statistics.sample import SampleInterval
from hoopgen.study.statistics.tally import contacts_of
from hoopgen.study.tables.batch_result import Batch
from hoopgen.text.numbers import (
    format_count,
    format_interval,
    format_percent,
    format_points,
    percent_decimals,
)

from .context import Answer, Context, Workplace, fenced

_LANDINGS = 200_000
"""Number of shots whose misses a figure shows."""


def ask_solve(context: Context, question: SolveQuestion, **work: Any) -> Solution:
    """Find the factor times the scatter.

    Arguments as for `ask_estimate`.
    """
    return solve(context.setting.model(), **context.options, **work)


def tell_solve(
    context: Context, question: SolveQuestion, found: Solution, work: Workplace
) -> Answer:
    """Return the factor times the scatter.

    Arguments as for `tell_estimate`.
    """
    return Answer(found.line, fenced(found), in_units(found.as_dict(), context.engine))


def ask_estimate(context: Context, question: EstimateQuestion, **work: Any) -> Estimate | Shares:
    """Estimate how shots end, once the scene has what the figures show.

    Parameters
    ----------
    context
        The study around the question, with its scene and the source of shots.
    question
        The question itself, as the study file has it.
    **work
        The keywords of the library's function that say who works, and where its chunks lie:
        `threads`, `scheduler`, `progress` and `folder` (of a batch `out`).

    Returns
    -------
    object
        The result of the library's function.

    Raises
    ------
    ValueError
        If the question cannot be answered in this scene, or its figures need more memory than there
        is.
    """
    for name in {"landings", "rebounds"} & set(question.figures):
        check_hoop(name, context.engine)
    if "fan" in question.figures:
        contacts = contacts_of(question.max_contacts, context.engine)
        level = context.study.confidence
        most = most_shots(question.shots, question.precision, level)
        check_log(min(PLOTTED, most), contacts, scene=context.engine)
    found: Estimate | Shares = estimate(context.setting.player(), **context.options, **work)
    return found


def tell_estimate(
    context: Context, question: EstimateQuestion, found: Any, work: Workplace
) -> Answer:
    """Return an estimate, and draw its figures.

    Parameters
    ----------
    context
        The study around the question.
    question
        The question itself, which says what figures are wanted.
    found
        The result of the function that asked.
    work
        The place for the figures and tables of the answer.

    Returns
    -------
    Answer
        The answer in a line, in a text and in numbers, SI.
    """
    work.keep(found.shots)
    figures = {name: _figure(context, question, name, found.shots) for name in question.figures}
    for name, figure in figures.items():
        if figure is not None:
            context.draw(work, name, figure)
    digits = percent_decimals(found.half_width)
    if isinstance(found, Shares):
        ends = context.engine.kernels.ENDS or tuple(n for n, share in found.shares.items() if share)
        line = ", ".join(
            f"{format_percent(found.shares[name], digits)} {name} "
            f"({_ends(found, found.low[name], found.high[name], found.sample.get(name))})"
            for name in ends
        )
    else:
        ends = _ends(found, found.low, found.high, found.sample)
        line = f"{format_percent(found.probability, digits)} made ({ends})"
        line = "; ".join(filter(None, (line, in_brief(found.measured))))
    line += "".join(f"; {_EMPTY[name]}" for name, figure in figures.items() if figure is None)
    return Answer(
        line + _short_of(question, found.half_width),
        fenced(found),
        in_units(found.as_dict(), context.engine),
    )


def _ends(found: Any, low: float, high: float, sample: SampleInterval | None) -> str:
    """Describe the interval of a share, and of measured releases that of the sample, too."""
    if found.still:
        return STILL
    text = format_interval(low, high, percent_decimals(found.half_width))
    if sample is None:
        return text
    return (
        f"{text} of the simulation alone, {format_interval(sample.low, sample.high)} of the sample"
    )


_EMPTY = {
    "landings": "no miss reaches the floor, so there is no picture of where",
    "rebounds": "no miss comes down to the catching height, so there is no picture of where",
}
"""Sentences in place of a figure that has nothing to show."""


def _short_of(question: EstimateQuestion | CompareQuestion, half_width: float) -> str:
    """Return a sentence if a precision was not reached."""
    if question.precision is None or half_width <= question.precision:
        return ""
    return "; the precision was not reached: more shots"


_TITLES = {"landings": "where misses land", "rebounds": "where rebounds are caught"}


def _figure(context: Context, question: EstimateQuestion, name: str, shots: int) -> Any:
    """Return a picture of the first shots of an estimate; None where none is to be seen in it."""
    setting, seed, title = context.setting, context.study.seed, context.question.title
    most, record = (PLOTTED, True) if name == "fan" else (_LANDINGS, False)
    released = setting.model().draw(0, min(most, shots), seed, setting.parameters)
    simulated = simulate(
        released.states,
        released.parameters,
        scene=context.engine,
        max_contacts=question.max_contacts,
        record=record,
    )
    said = describe_setting(setting.identity(), context.engine) | {"seed": str(seed)}
    note = sentences(said)
    if name == "fan":
        return plots.plot_fan(simulated, released.parameters, title=title, note=note)
    height = question.catching_height if name == "rebounds" else None
    there = landings_of(released, simulated, height)
    if not len(there.away):
        return None
    title = f"{title}: {_TITLES[name]}" if title else ""
    hoop = released.parameters
    return plots.plot_landings(there.x, there.y, hoop, title=title, note=note, **there.seen)


def ask_compare(context: Context, question: CompareQuestion, **work: Any) -> Comparison:
    """Compare two settings.

    Arguments as for `ask_estimate`.
    """
    settings = context.setting, context.changed(question.versus)
    first, second = ((one.model(), one.parameters) for one in settings)
    return compare(first, second, scene=context.engine, **context.arguments, **work)


def tell_compare(
    context: Context, question: CompareQuestion, found: Comparison, work: Workplace
) -> Answer:
    """Return a comparison.

    Arguments as for `tell_estimate`.
    """
    work.keep(found.first.shots)
    digits = percent_decimals(found.half_width)
    ends = f"{format_points(found.low, digits)} to {format_points(found.high, digits)}"
    if found.sample is not None:
        sample = [format_points(end) for end in (found.sample.low, found.sample.high)]
        ends += f" of the simulation alone, {' to '.join(sample)} of the sample"
    ends = STILL if found.still else ends
    line = f"{format_points(found.difference, digits)} points by the change ({ends})"
    return Answer(
        line + _short_of(question, found.half_width),
        fenced(found),
        in_units(found.as_dict(), context.engine),
    )


def ask_batch(context: Context, question: BatchQuestion, **work: Any) -> Batch:
    """Simulate the shots of a table.

    Arguments as for `ask_estimate`.
    """
    return batch(
        context.source.path,
        parameters=context.setting.parameters_of(context.source),
        scene=context.engine,
        release=context.shared_release,
        override=True,  # what the study file says is said on purpose
        **context.arguments,
        **work,
    )


def tell_batch(context: Context, question: BatchQuestion, counts: Batch, work: Workplace) -> Answer:
    """Return the outcomes of a table's shots, as in the table of results.

    Arguments as for `tell_estimate`.
    """
    text = ", ".join(f"{count:,} {name}" for name, count in counts.items() if count)
    return Answer(f"{format_count(sum(counts.values()), 'shot')}: {text or 'none'}", "", counts)
