"""Answers about shots that are thrown: how many are made, what a change adds, a table's."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from hoopgen import plots
from hoopgen.phrases import counted, decimals, interval, percent, points
from hoopgen.results import Shots
from hoopgen.scenes import check_hoop
from hoopgen.simulation import check_log, simulate
from hoopgen.study.batch import batch
from hoopgen.study.best import PLOTTED
from hoopgen.study.compare import compare
from hoopgen.study.draws import check_two_seeds
from hoopgen.study.estimate import STILL, estimate
from hoopgen.study.landings import landings_of
from hoopgen.study.measures import measures_of
from hoopgen.study.named import in_units
from hoopgen.study.resample import Resample
from hoopgen.study.sample import SampleInterval
from hoopgen.study.scatter import Scatter
from hoopgen.study.shares import Shares
from hoopgen.study.solve import check_scatters, solve
from hoopgen.study.spread import in_brief
from hoopgen.study.tallies import contacts_of
from hoopgen.study.throws import check_states, most_shots, outcome_by
from hoopgen.told import in_a_note, told_setting
from hoopgen.variables import Releases, check_names

from .asked import Answer, Asked, Work, fenced
from .schema import Batch, Compare, Estimate, Solve
from .settings import Setting

__all__ = [
    "answer_batch",
    "answer_compare",
    "answer_estimate",
    "answer_solve",
    "check_batch",
    "check_solve",
    "check_throws",
]

_LANDINGS = 200_000
"""Shots whose misses are shown."""


def check_throws(asked: Asked, question: Estimate | Compare) -> None:
    """Look for what is wrong with an estimate or a comparison."""
    settings = [asked.setting]
    settings += [asked.changed(question.versus)] if isinstance(question, Compare) else []
    for setting in settings:
        _try(asked, setting)
    paired = isinstance(question, Compare)
    most = most_shots(question.shots, question.precision, asked.study.confidence, paired=paired)
    if isinstance(question, Compare):
        outcome_by(asked.engine, question.by)
    else:
        _check_measured(asked, question)
    contacts = contacts_of(question.max_contacts, asked.engine)
    if isinstance(question, Estimate) and "fan" in question.figures:
        check_log(min(PLOTTED, most), contacts, scene=asked.engine)


def _try(asked: Asked, setting: Setting) -> Scatter | Resample:
    """Look whether shots can be drawn, and return their model."""
    model = setting.model()
    check_states(model, asked.engine)
    model.draw(0, 1, 0, setting.parameters)
    return model


def check_solve(asked: Asked, question: Solve) -> None:
    """Look for what is wrong with a search for the scatter."""
    check_scatters(_try(asked, asked.setting))
    check_two_seeds(asked.study.seed)
    outcome_by(asked.engine, question.by)
    contacts_of(question.max_contacts, asked.engine)


def answer_solve(asked: Asked, question: Solve, work: Work) -> Answer:
    """Return the factor times the scatter."""
    found = solve(
        asked.setting.model(),
        question.share,
        asked.setting.parameters,
        scene=asked.engine,
        by=question.by,
        shots=question.shots,
        confidence=asked.study.confidence,
        seed=asked.study.seed,
        max_contacts=question.max_contacts,
        **work.options,
    )
    return Answer(found.line, fenced(found), in_units(found.as_dict()))


def _check_measured(asked: Asked, question: Estimate) -> None:
    """Look for what is measured where it cannot be."""
    for name in {"landings", "rebounds"} & set(question.figures):
        check_hoop(name, asked.engine)
    if question.measures:
        check_hoop("measures", asked.engine)
        check_names("measures", question.measures, measures_of(asked.engine))


def answer_estimate(asked: Asked, question: Estimate, work: Work) -> Answer:
    """Return how probably a shot is made, and draw its figures."""
    setting = asked.setting
    model = setting.model()
    found = estimate(
        model,
        setting.parameters,
        scene=asked.engine,
        shots=question.shots,
        precision=question.precision,
        measures=question.measures,
        catching_height=question.catching_height,
        confidence=asked.study.confidence,
        seed=asked.study.seed,
        max_contacts=question.max_contacts,
        **work.options,
    )
    work.keep(found.shots)
    shooting = _Shooting(asked, question, found.shots)
    figures = {name: shooting.figure(name) for name in question.figures}
    for name, figure in figures.items():
        if figure is not None:
            asked.draw(work, name, figure)
    digits = decimals(found.half_width)
    if isinstance(found, Shares):
        ends = asked.engine.kernels.ENDS or tuple(n for n, share in found.shares.items() if share)
        line = ", ".join(
            f"{percent(found.shares[name], digits)} {name} "
            f"({_ends(found, found.low[name], found.high[name], found.sample.get(name))})"
            for name in ends
        )
    else:
        ends = _ends(found, found.low, found.high, found.sample)
        line = f"{percent(found.probability, digits)} made ({ends})"
        line = "; ".join(filter(None, (line, in_brief(found.measured))))
    line += "".join(f"; {_EMPTY[name]}" for name, figure in figures.items() if figure is None)
    return Answer(
        line + _short_of(question, found.half_width), fenced(found), in_units(found.as_dict())
    )


def _ends(found: Any, low: float, high: float, sample: SampleInterval | None) -> str:
    """Say the interval of a share, and of measured releases that of the sample too."""
    if found.still:
        return STILL
    said = interval(low, high, decimals(found.half_width))
    if sample is None:
        return said
    return f"{said} of the simulation alone, {interval(sample.low, sample.high)} of the sample"


_EMPTY = {
    "landings": "no miss reaches the floor, so there is no picture of where",
    "rebounds": "no miss comes down to the catching height, so there is no picture of where",
}
"""What is said in place of a figure that has nothing to show."""


def _short_of(question: Estimate | Compare, half_width: float) -> str:
    """Say that a precision was not reached."""
    if question.precision is None or half_width <= question.precision:
        return ""
    return "; the precision was not reached: more shots"


@dataclass(frozen=True)
class _Shooting:
    """The first shots of an estimate, for figures."""

    asked: Asked
    question: Estimate
    shots: int

    def figure(self, name: str) -> Any:
        """Return a picture by its name; none where no shot is to be seen in it."""
        draw = {"fan": self._fan, "landings": self._landings, "rebounds": self._rebounds}
        return draw[name]()

    def _fan(self) -> Any:
        """Return the picture of paths."""
        released, shots = self._simulated(PLOTTED, record=True)
        note = in_a_note(self._told)
        return plots.plot_fan(shots, released.parameters, title=self.question.title, note=note)

    def _landings(self) -> Any:
        """Return the picture of where misses reach the floor."""
        return self._on_the_floor_plan("where misses land")

    def _rebounds(self) -> Any:
        """Return the picture of where misses come down to the catching height."""
        height = self.question.catching_height
        return self._on_the_floor_plan("where rebounds are caught", height)

    def _on_the_floor_plan(self, said: str, height: float | None = None) -> Any:
        released, shots = self._simulated(_LANDINGS)
        there = landings_of(released, shots, height)
        if not len(there.away):
            return None
        title = f"{self.question.title}: {said}" if self.question.title else ""
        note = in_a_note(self._told)
        return plots.plot_landings(
            there.x, there.y, released.parameters, title=title, note=note, **there.seen
        )

    @property
    def _told(self) -> dict[str, str]:
        return told_setting(self.asked.setting.identity(), self.asked.engine) | {
            "seed": str(self.asked.study.seed)
        }

    def _simulated(self, most: int, *, record: bool = False) -> tuple[Releases, Shots]:
        setting, seed = self.asked.setting, self.asked.study.seed
        released = setting.model().draw(0, min(most, self.shots), seed, setting.parameters)
        most_contacts = self.question.max_contacts
        return released, simulate(
            released.states,
            released.parameters,
            scene=self.asked.engine,
            max_contacts=most_contacts,
            record=record,
        )


def answer_compare(asked: Asked, question: Compare, work: Work) -> Answer:
    """Return what a change adds."""
    first, second = asked.setting, asked.changed(question.versus)
    found = compare(
        (first.model(), first.parameters),
        (second.model(), second.parameters),
        scene=asked.engine,
        by=question.by,
        shots=question.shots,
        precision=question.precision,
        confidence=asked.study.confidence,
        seed=asked.study.seed,
        max_contacts=question.max_contacts,
        **work.options,
    )
    work.keep(found.first.shots)
    digits = decimals(found.half_width)
    ends = f"{points(found.low, digits)} to {points(found.high, digits)}"
    if found.sample is not None:
        sample = [points(end) for end in (found.sample.low, found.sample.high)]
        ends += f" of the simulation alone, {' to '.join(sample)} of the sample"
    ends = STILL if found.still else ends
    line = f"{points(found.difference, digits)} points by the change ({ends})"
    return Answer(
        line + _short_of(question, found.half_width), fenced(found), in_units(found.as_dict())
    )


def check_batch(asked: Asked, question: Batch) -> None:
    """Look for what is wrong with a batch."""
    source = question.reading.source(asked.folder / question.file)
    question.reading.interpreted(
        source, None, question.release, None, override=True, scene=asked.engine
    )
    contacts_of(question.max_contacts, asked.engine)
    if question.measures:
        check_hoop("measures", asked.engine)


def _most_contacts(question: Batch) -> int | None:
    """Return how many the study says; None where it leaves that to the table."""
    return question.max_contacts if "max_contacts" in question.model_fields_set else None


def answer_batch(asked: Asked, question: Batch, work: Work) -> Answer:
    """Return how the shots of a table end, each in the table of results."""
    source = question.reading.source(asked.folder / question.file)
    counts = batch(
        source.path,
        work.file("results.parquet"),
        parameters=asked.setting.parameters_of(source),
        scene=asked.engine,
        release=question.release,
        measures=question.measures,
        catching_height=question.catching_height,
        max_contacts=_most_contacts(question),
        override=True,  # what the study file says is said on purpose
        format=question.format,
        own=question.own,
        columns=question.columns,
        where=question.where,
        implausible=question.implausible,
        prefix=question.prefix,
        scheduler=work.scheduler,
        threads=work.threads,
        progress=work.progress,
    )
    said = ", ".join(f"{count:,} {name}" for name, count in counts.items() if count)
    return Answer(f"{counted(sum(counts.values()), 'shot')}: {said or 'none'}", "", counts)
