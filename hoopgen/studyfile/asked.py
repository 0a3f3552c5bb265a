"""A question as it is asked, who works on it, and what an answer is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from hoopgen import plots
from hoopgen.core.store import Store
from hoopgen.engines import Engine
from hoopgen.study.folders import trim
from hoopgen.study.rebounds import REBOUNDS, caught_at
from hoopgen.study.throws import chunks_of, scene_identity
from hoopgen.told import say_of
from hoopgen.units import shown_system

from .schema import Batch, Compare, Estimate, Given, Question, Study
from .settings import Setting

__all__ = ["Answer", "Asked", "Work", "fenced"]


@dataclass(frozen=True)
class Work:
    """Who works on a question, and where.

    Attributes
    ----------
    store
        The folder for files of the answer.
    chunks
        The folder of finished chunks.
    threads, scheduler
        As for `hoopgen.study.chunks.run`.
    progress
        Called with what is done and its total, as far as that is known.
    kept
        Chunks that an answer before this one had, and that stay.
    """

    store: Store
    chunks: Path
    threads: int | None
    scheduler: str | None
    progress: Callable[[int, int | None], None]
    kept: int = 0

    @property
    def options(self) -> dict[str, Any]:
        """Return what functions that work in chunks are told."""
        return {
            "folder": self.chunks,
            "threads": self.threads,
            "scheduler": self.scheduler,
            "progress": self.progress,
        }

    def keep(self, shots: int) -> None:
        """Leave the chunks of so many shots, and those before, from which a study can go on."""
        trim(self.chunks, max(chunks_of(shots), self.kept))

    def file(self, name: str) -> Path:
        """Return where a file of the answer is to be written."""
        self.store.claim(name)
        return self.store.path / name


@dataclass(frozen=True)
class Answer:
    """What came out.

    Attributes
    ----------
    line
        In one line.
    text
        In more, Markdown.
    numbers
        In types that JSON knows; SI.
    """

    line: str
    text: str
    numbers: Mapping[str, Any]


@dataclass(frozen=True)
class Asked:
    """A question with what the study says beside it.

    Attributes
    ----------
    study
        What all questions have in common.
    given
        The tables above the questions.
    question
        The question itself.
    folder
        Of the study file.
    engine
        The scene that it is about.
    """

    study: Study
    given: Given
    question: Question
    folder: Path
    engine: Engine

    @cached_property
    def setting(self) -> Setting:
        """Where its shots come from."""
        return Setting.of((self.given, self.question), self.folder, self.engine)

    @property
    def scene(self) -> str:
        """In words: the preset, and what differs from it."""
        table = self.question if isinstance(self.question, Batch) else None
        if table is not None:
            source = table.reading.source(self.folder / table.file)
            return say_of(self.engine, self.setting.parameters_of(source))
        return say_of(self.engine, self.setting.parameters)

    def changed(self, versus: Given) -> Setting:
        """Return the setting with changes."""
        return Setting.of((self.given, self.question, versus), self.folder, self.engine)

    def identity(self) -> dict[str, Any]:
        """Return all that the answer depends on, in types that JSON knows."""
        question = self.question
        apart = {*Given.model_fields, "versus"}
        identity: dict[str, Any] = {
            **scene_identity(self.engine),
            **{name: getattr(self.study, name) for name in ("seed", "confidence", "formats")},
            **{name: value for name, value in question if name not in apart},
        }
        if identity.get("max_contacts", 0) is None:
            identity["max_contacts"] = self.engine.max_contacts
        caught = {"catching_height"} - set(self._caught)
        unsaid = {"measures"} if isinstance(question, Estimate) and not question.measures else set()
        if (system := shown_system()) != "si":  # in which its answer is said, and drawn
            identity["units"] = system
        identity = {name: v for name, v in identity.items() if name not in caught | unsaid}
        if isinstance(question, Batch):
            source = question.reading.source(self.folder / question.file)
            scene = self.setting.parameters_of(source)
            shared = {"release": question.release, "parameters": scene}
            return identity | {"setting": shared, "table": source.digest()[0]}
        identity["setting"] = self.setting.identity()
        if isinstance(question, Compare):
            identity["versus"] = self.changed(question.versus).identity()
        return identity

    @property
    def _caught(self) -> dict[str, float]:
        """The catching height by its name, where the answer hangs on it."""
        question = self.question
        if not isinstance(question, Estimate | Batch):
            return {}
        drawn = "rebounds" in getattr(question, "figures", ())
        return caught_at(REBOUNDS if drawn else question.measures, question.catching_height)

    def draw(self, work: Work, name: str, figure: Any) -> None:
        """Write a figure in the formats wanted."""
        for format in self.study.formats:
            plots.save(figure, work.file(f"{name}.{format}"))


def fenced(found: object) -> str:
    """Return what is printed of a result, as Markdown that keeps its columns."""
    return f"```text\n{found}\n```"
