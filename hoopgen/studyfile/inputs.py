"""The files that a study reads: tables of releases, and its scene's file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from hoopgen.scenes import is_built_in

from . import lines
from .scene import named_by
from .schema import Batch, Compare, Given, StudyFile

__all__ = ["data_files", "read_files", "scene_file"]


def scene_file(file: Path, document: Mapping[str, Any]) -> Path | None:
    """Return the scene file that a study names, if it names one."""
    named = named_by(document)
    return None if named is None or is_built_in(named) else file.parent / named


def data_files(study: StudyFile) -> Iterator[tuple[lines.Path, str]]:
    """Yield the files that are read, and where the study file names them."""
    given: list[tuple[lines.Path, Any]] = [((), study)]
    for place, question in enumerate(study.question):
        path: lines.Path = ("question", place)
        given.append((path, question))
        if isinstance(question, Compare):
            given.append(((*path, "versus"), question.versus))
        if isinstance(question, Batch):
            yield (*path, "file"), question.file
    for path, tables in given:
        if tables.releases is not None:
            yield (*path, "releases", "file"), tables.releases.file


def read_files(file: Path, study: Given, document: Mapping[str, Any]) -> Iterator[Path]:
    """Yield all files that a study reads.

    Parameters
    ----------
    file
        The study file.
    study
        What it says.
    document
        The same as it is written.
    """
    yield file
    if isinstance(study, StudyFile):
        yield from (file.parent / name for _, name in data_files(study))
    if (scene := scene_file(file, document)) is not None:
        yield scene
