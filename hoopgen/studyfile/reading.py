"""Reading a study file: every complaint names the file, the line and the key."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from hoopgen.engines import HOOP, Engine
from hoopgen.files import FileSizeError, read_regular
from hoopgen.printable import printable
from hoopgen.scene.limits import current
from hoopgen.scenes import engine_of, is_built_in, scene_from, variables_of

from . import lines
from .scene import named_by, within
from .schema import StudyFile
from .single import show

__all__ = ["StudyError", "complain", "parse", "read_study"]


class StudyError(ValueError):
    """What is wrong with a study file.

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

    Parameters
    ----------
    content
        Of the file.
    file
        Its name, for complaints.

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
            return StudyFile.model_validate(document), document, text, scene
    except ValidationError as error:
        found = [(_path(one["loc"]), _said(one)) for one in error.errors()]
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
    """Return the error that says what is wrong with keys, in the order of their lines."""
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
    """Say where: ``question #2, over.elevation``."""
    text = ""
    for place, step in enumerate(path):
        if isinstance(step, int):
            text += f" #{step + 1}"
        else:
            text += "" if not place else ", " if isinstance(path[place - 1], int) else "."
            text += step
    return text


def _said(wrong: Mapping[str, Any]) -> str:
    """Say what is wrong in the words used here."""
    if wrong["type"] == "said":
        return str(wrong["msg"])
    if wrong["type"] == "value_error":
        return str(wrong["ctx"]["error"])
    if wrong["type"] == "missing":
        return "missing"
    if wrong["type"] in ("list_type", "too_short"):
        return f"expected a list that is not empty; got {show(wrong['input'])}"
    return f"{wrong['msg']}; got {show(wrong['input'])}"
