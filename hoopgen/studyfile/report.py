"""The report of a study: what was asked, and the answers with their intervals; Markdown."""

from __future__ import annotations

import html
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from math import isfinite
from pathlib import Path
from types import MappingProxyType
from typing import Any

from hoopgen.installed import version
from hoopgen.phrases import percent
from hoopgen.printable import printable

from .asked import Answer, Asked
from .question_folders import answer_files

__all__ = ["CAPTIONS", "asked_of", "report"]

_SHOWN = (".svg", ".png")
"""Pictures that a page can show."""

CAPTIONS: Mapping[str, str] = MappingProxyType(
    {
        "fan": "Paths of the first shots",
        "landings": "Where misses reach the floor",
        "rebounds": "Where misses come down to the catching height",
        "map": "The map",
        "aim_points": "Where bank shots touch the board, and from where",
    }
)
"""What pictures show, by the names of their files."""

_MARKS = re.compile(r"[\\`*_\[\]|~$#]")

_HTML = re.compile(r"<(?!(?:https?://|mailto:)[^\s<>]*>)(?=[A-Za-z/!?])")
"""Where HTML would begin in Markdown; addresses alone may stand in such brackets."""

_OF_ITSELF = ("kind", "name", "title")


def report(
    questions: Sequence[Asked],
    document: Mapping[str, Any],
    answers: Mapping[str, Answer],
    errors: Mapping[str, Exception],
    folder: Path,
) -> str:
    """Return the report.

    Parameters
    ----------
    questions
        All of them, in order.
    document
        The study file as it is written.
    answers, errors
        By the name of the question: one of them each.
    folder
        Where the answers' files are.
    """
    return "\n\n".join(_sections(questions, document, answers, errors, folder)) + "\n"


def _sections(
    questions: Sequence[Asked],
    document: Mapping[str, Any],
    answers: Mapping[str, Answer],
    errors: Mapping[str, Exception],
    folder: Path,
) -> Iterator[str]:
    study = questions[0].study
    yield f"# {_text(study.name)}"
    if study.description.strip():
        yield _HTML.sub("&lt;", study.description.strip())
    yield (
        f"By hoopgen {version()} from [study.toml](study.toml), seed {study.seed}; "
        f"intervals of {percent(study.confidence, None)} confidence, of the simulation alone "
        "unless they are said to be of the sample. "
        "[versions.json](versions.json) says what computed."
    )
    rows = ["| question | answer |", "|---|---|"]
    for asked in questions:
        name = asked.question.name
        said = answers[name].line if name in answers else f"not answered: {_text(errors[name])}"
        rows.append(f"| [{_title(asked)}](#{name}) | {said} |")
    yield "\n".join(rows)
    shared = {key: value for key, value in document.items() if key not in ("study", "question")}
    if shared:
        yield f"All questions have in common:\n\n{_toml(shared)}"
    for asked, written in zip(questions, document["question"], strict=True):
        name = asked.question.name
        yield f'<a id="{name}"></a>\n\n## {_title(asked)}'
        options = {key: value for key, value in written.items() if key not in _OF_ITSELF}
        kind = f"{asked.question.kind}. {asked_of(asked)}"
        yield f"Asked: {kind}" + (f"\n\n{_toml(options)}" if options else "")
        if name in answers:
            yield from _answer(asked, answers[name], folder)
        else:
            yield f"Not answered: {_text(errors[name])}"


def _answer(asked: Asked, answer: Answer, folder: Path) -> Iterator[str]:
    yield f"**{answer.line}**"
    yield f"Scene: {asked.scene}."
    if answer.text:
        yield answer.text
    files = [file.name for file in answer_files(folder / asked.question.name)]
    shown: dict[str, str] = {}
    for file in files:
        stem, suffix = Path(file).stem, Path(file).suffix
        if suffix in _SHOWN:
            shown.setdefault(stem, file)
    yield from (
        f"![{CAPTIONS.get(stem, stem)}]({asked.question.name}/{file})"
        for stem, file in shown.items()
    )
    yield f"Files: {', '.join(f'[{file}]({asked.question.name}/{file})' for file in files)}"


def _title(asked: Asked) -> str:
    return _text(asked.question.title or asked.question.name)


def asked_of(asked: Asked) -> str:
    """Say what is asked: the first line of the question's description."""
    return (type(asked.question).__doc__ or "").partition("\n")[0]


def _toml(tables: Mapping[str, Any]) -> str:
    return "```toml\n" + "\n".join(_keys(tables)) + "\n```"


def _keys(values: Mapping[str, Any], prefix: str = "") -> Iterator[str]:
    """Yield keys as they are written, dotted, a line each."""
    for key, value in values.items():
        if isinstance(value, Mapping) and value:
            yield from _keys(value, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key} = {_value(value)}"


def _value(value: Any) -> str:
    if isinstance(value, list):
        return f"[{', '.join(map(_value, value))}]"
    if isinstance(value, float) and not isfinite(value):
        return str(value)  # as TOML has it, and JSON has not
    return json.dumps(value, ensure_ascii=False, default=str)


def _text(said: object) -> str:
    """Return what is no Markdown as a line of it that shows the same: no mark or tag counts."""
    line = printable(" ".join(str(said).split()))
    return _MARKS.sub(r"\\\g<0>", html.escape(line, quote=False))
