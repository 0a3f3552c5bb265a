"""The context of a question: the study about it, where it is worked on, and its answer."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from hoopgen import plots
from hoopgen.core.owned_folders import Store
from hoopgen.core.units import display_system
from hoopgen.report.provenance import describe_scene
from hoopgen.simulation.engine import Engine
from hoopgen.study.jobs.chunk_store import trim
from hoopgen.study.jobs.monte_carlo import SHOTS, chunks_of, scene_identity
from hoopgen.study.measures.rebounds import REBOUNDS, caught_at
from hoopgen.study.questions.settings import Sampling, arguments, settings
from hoopgen.study.questions.specification import (
    MARGINS,
    QUESTIONS,
    BatchQuestion,
    CompareQuestion,
    EstimateQuestion,
    SolveQuestion,
)

from .schema import Given, Question, Study, reading
from .shot_source import ShotSource, placed


@dataclass(frozen=True)
class Workplace:
    """The place where a question is worked on, and who works.

    Attributes
    ----------
    threads, scheduler
        As for `hoopgen.study.jobs.chunks.run`.
    progress
        Called with what is done and its total, as far as that is known.
    """

    store: Store  # the folder for files of the answer
    chunks: Path  # the folder of finished chunks
    threads: int | None
    scheduler: str | None
    progress: Callable[[int, int | None], None]
    kept: int = 0  # number of chunks of the answer before this one, which stay

    @property
    def workers(self) -> dict[str, Any]:
        """Return who works, and hears of it."""
        return {
            "threads": self.threads,
            "scheduler": self.scheduler,
            "progress": self.progress,
        }

    def keep(self, shots: int) -> None:
        """Remove the chunks beyond so many shots, but for those of the answer before."""
        trim(self.chunks, max(chunks_of(shots), self.kept))

    def file(self, name: str) -> Path:
        """Return the path of a file of the answer."""
        self.store.claim(name)
        return self.store.path / name


@dataclass(frozen=True)
class Answer:
    """The answer to a question."""

    line: str  # the answer in one line
    text: str  # the answer at length, Markdown
    numbers: Mapping[str, Any]  # its numbers in types that JSON knows; SI


@dataclass(frozen=True)
class Context:
    """A question with what the study says beside it."""

    study: Study  # what all questions have in common
    given: Given  # the tables above the questions
    question: Question  # the question itself
    folder: Path  # folder of the study file
    engine: Engine  # the scene of the study

    @cached_property
    def setting(self) -> ShotSource:
        """The setting of its shots."""
        return ShotSource.from_tables((self.given, self.question), self.folder, self.engine)

    @property
    def arguments(self) -> dict[str, Any]:
        """Return the arguments of the Python function that the question and its study say."""
        specification = QUESTIONS[self.question.kind]
        shared = arguments(self.study, Sampling) if Sampling in specification.shared else {}
        return arguments(self.question, specification) | shared

    @property
    def options(self) -> dict[str, Any]:
        """Return the arguments, the scene and its parameters."""
        scene = {"scene": self.engine, "parameters": self.setting.parameters}
        return {**scene, **self.arguments}

    @property
    def source(self) -> Any:
        """The table that a batch reads; None for other questions."""
        if not isinstance(self.question, BatchQuestion):
            return None
        return reading(self.question).source(self.folder / self.question.file)

    @property
    def scene(self) -> str:
        """The preset in words, and what differs from it."""
        setting, source = self.setting, self.source
        return describe_scene(
            self.engine, setting.parameters_of(source) if source else setting.parameters
        )

    @property
    def shared_release(self) -> dict[str, Any]:
        """Return the variables that all rows of a batch share."""
        return placed(self.question.release, self.setting.parameters_of(self.source))

    def changed(self, versus: Given) -> ShotSource:
        """Return the setting with changes."""
        return ShotSource.from_tables((self.given, self.question, versus), self.folder, self.engine)

    def identity(self) -> dict[str, Any]:
        """Return all that the answer depends on, in types that JSON knows."""
        question = self.question
        apart = {*(name for name, *_ in settings(Given)), "versus"}
        if isinstance(question, EstimateQuestion | BatchQuestion):
            drawn = "rebounds" in getattr(question, "figures", ())
            caught = caught_at(REBOUNDS if drawn else question.measures, question.catching_height)
            apart |= {"catching_height"} - set(caught)
        if isinstance(question, EstimateQuestion) and not question.measures:
            apart.add("measures")
        if isinstance(question, EstimateQuestion) and not question.gradient:
            apart.add("gradient")
        identity: dict[str, Any] = {
            **scene_identity(self.engine),
            **{name: getattr(self.study, name) for name in ("seed", "confidence", "formats")},
            **{name: value for name, value in vars(question).items() if name not in apart},
        }
        defaults = {"max_contacts": self.engine.max_contacts, "margins": MARGINS, "columns": {}}
        defaults |= {"shots": SHOTS} if isinstance(question, SolveQuestion) else {}
        identity |= {name: it for name, it in defaults.items() if identity.get(name, 0) is None}
        if (system := display_system()) != "si":  # the units of text and pictures
            identity["units"] = system
        if isinstance(question, BatchQuestion):
            scene = self.setting.parameters_of(self.source)
            shared = {"release": self.shared_release, "parameters": scene}
            return identity | {"setting": shared, "table": self.source.digest()[0]}
        identity["setting"] = self.setting.identity()
        if isinstance(question, CompareQuestion):
            identity["versus"] = self.changed(question.versus).identity()
        return identity

    def draw(self, work: Workplace, name: str, figure: Any) -> None:
        """Write a figure in the formats wanted.

        Parameters
        ----------
        work
            The place of the answer's files.
        name
            The name of the file, without a suffix.
        figure
            A figure of matplotlib.
        """
        for format in self.study.formats:
            plots.save(figure, work.file(f"{name}.{format}"))


def fenced(found: object) -> str:
    """Return the printed form of a result as Markdown that keeps its columns."""
    return f"```text\n{found}\n```"
