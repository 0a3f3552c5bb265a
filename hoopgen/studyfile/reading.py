"""Reading a study file and the files that it names; errors name the file, the line and the key."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from hoopgen.core.regular_files import FileSizeError, read_regular
from hoopgen.scene.limits import current
from hoopgen.scene.lookup import variables_of
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.hoop import HOOP
from hoopgen.simulation.lookup import engine_of, is_built_in, scene_from
from hoopgen.study.questions.specification import BatchQuestion, CompareQuestion
from hoopgen.study.questions.values import show
from hoopgen.text.escape import printable

from . import lines
from .scene import named_by, within
from .schema import Given, StudyFile, read_document


class StudyError(ValueError):
    """An error that lists all that is wrong with a study file.

    Attributes
    ----------
    complaints
        A line each, printable: a file's name and its keys may hold what acts on a terminal.
    """

    def __init__(self, complaints: Iterable[str]) -> None:
        self.complaints = tuple(map(printable, complaints))
        super().__init__("\n".join(self.complaints))


def read_study(file: Path) -> bytes:
    """Return the content of a study file.

    Raises
    ------
    OSError
        If it cannot be read, or is a pipe, a device or a folder.
    StudyError
        If it is too large.
    """
    limits = current()
    try:
        return read_regular(file, limits.file_size)
    except FileSizeError as error:
        raise StudyError([f"{file}: {limits.excess('file_size', error.size)}"]) from None


def parse(content: bytes, file: Path) -> tuple[StudyFile, dict[str, Any], str, Engine]:
    """Read a study file. Nothing in it is evaluated.

    Returns
    -------
    StudyFile, dict, str, Engine
        What it says, in SI; the same as it is written; its text; and its scene, compiled.

    Raises
    ------
    StudyError
        If it is not TOML, or not as `StudyFile` describes; with all that is wrong.
    """
    try:
        text = content.decode("utf-8-sig")
        document = tomllib.loads(text)
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        byte = content[error.start]
        raise StudyError(
            [f"{file}:{line}: expected text in UTF-8; got the byte {byte:#x}"]
        ) from None
    except tomllib.TOMLDecodeError as error:
        raise StudyError([_syntax(str(error), text, file)]) from None
    except RecursionError:
        raise StudyError([f"{file}: arrays or tables are nested too deep"]) from None
    scene = _scene(document, text, file)
    try:
        with within(scene):
            return read_document(document), document, text, scene
    except ValidationError as error:
        found = [(_path(one["loc"]), _error_text(one)) for one in error.errors()]
        raise complain(file, text, found) from None


def _scene(document: Mapping[str, Any], text: str, file: Path) -> Engine:
    """Return the scene of a study: nothing in its file is evaluated either."""
    given = named_by(document)
    if not isinstance(given, str):  # none; or wrong, which is said with all else
        return HOOP
    try:
        if not is_built_in(given) and not (file.parent / given).is_file():
            raise ValueError(f"there is no file {file.parent / given}")
        engine = engine_of(scene_from(given, file.parent))
        variables_of(engine)
        return engine
    except (ImportError, OSError, ValueError) as error:
        raise complain(file, text, [(("scene",), str(error))]) from None


def complain(file: Path, text: str, found: Iterable[tuple[lines.Path, str]]) -> StudyError:
    """Return the error that says what is wrong with keys, in the order of their lines.

    Parameters
    ----------
    file
        The study file, for the message.
    text
        Its content, in which the line of each key is looked for.
    found
        The path of each wrong key, and the words on what is wrong with it.

    Returns
    -------
    StudyError
        One line for each, with file, line and key.
    """
    placed = sorted((lines.line_of(text, path), _key(path), said) for path, said in found)
    return StudyError(f"{file}:{line}: {key}: {said}" for line, key, said in placed)


_AT = re.compile(r"\s*\(at (?:line (\d+), column (\d+)|end of document)\)$")


def _syntax(said: str, text: str, file: Path) -> str:
    """Put the place where this project has it."""
    place = _AT.search(said)
    line = place[1] if place and place[1] else len(text.splitlines())
    column = f", column {place[2]}" if place and place[2] else ", at the end"
    return f"{file}:{line}: this is not TOML{column}: {_AT.sub('', said)}"


def _path(where: Iterable[str | int]) -> lines.Path:
    """Return the path in the document: without pydantic's marks of alternatives."""
    return tuple(step for step in where if not (isinstance(step, str) and step.startswith("<")))


def _key(path: lines.Path) -> str:
    """Return a location as text: ``question #2, over.elevation``."""
    text = ""
    for place, step in enumerate(path):
        if isinstance(step, int):
            text += f" #{step + 1}"
        else:
            text += "" if not place else ", " if isinstance(path[place - 1], int) else "."
            text += step
    return text


def _error_text(wrong: Mapping[str, Any]) -> str:
    """Return an error of pydantic in hoopgen's words."""
    if wrong["type"] == "said":
        return str(wrong["msg"])
    if wrong["type"] == "value_error":
        return str(wrong["ctx"]["error"])
    if wrong["type"] == "missing":
        return "missing"
    if wrong["type"] in ("list_type", "too_short"):
        return f"expected a list that is not empty; got {show(wrong['input'])}"
    return f"{wrong['msg']}; got {show(wrong['input'])}"


def scene_file(file: Path, document: Mapping[str, Any]) -> Path | None:
    """Return the scene file that a study names, if it names one.

    Parameters
    ----------
    file
        The study file, whose folder relative names begin at.
    document
        Its tables, as TOML gives them.

    Returns
    -------
    Path or None
        None if the scene is one of hoopgen's own, or none is named.
    """
    named = named_by(document)
    return None if named is None or is_built_in(named) else file.parent / named


def data_files(study: StudyFile) -> Iterator[tuple[lines.Path, str]]:
    """Yield the files that are read, and where the study file names them."""
    given: list[tuple[lines.Path, Any]] = [((), study)]
    for place, question in enumerate(study.question):
        path: lines.Path = ("question", place)
        given.append((path, question))
        if isinstance(question, CompareQuestion):
            given.append(((*path, "versus"), question.versus))
        if isinstance(question, BatchQuestion):
            yield (*path, "file"), question.file
    for path, tables in given:
        if tables.releases is not None:
            yield (*path, "releases", "file"), tables.releases.file


def read_files(file: Path, study: Given, document: Mapping[str, Any]) -> Iterator[Path]:
    """Yield all files that a study reads.

    Parameters
    ----------
    file
        The study file, which is yielded first.
    study
        The study, whose tables name files of releases and shots.
    document
        The tables of the study file, as TOML gives them.
    """
    yield file
    if isinstance(study, StudyFile):
        yield from (file.parent / name for _, name in data_files(study))
    if (scene := scene_file(file, document)) is not None:
        yield scene
