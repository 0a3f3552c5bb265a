"""The report of a study: what was asked, and the answers with their intervals; Markdown."""

from __future__ import annotations

import html
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from pathlib import Path
from typing import Any

from hoopgen.core.extras import version
from hoopgen.text.escape import printable
from hoopgen.text.numbers import format_percent

from .context import Answer, Context
from .question_folders import answer_files

_SHOWN = (".svg", ".png")
"""Pictures that a page can show."""

CAPTIONS: Mapping[str, str] = {
    "fan": "Paths of the first shots",
    "landings": "Where misses reach the floor",
    "rebounds": "Where misses come down to the catching height",
    "map": "The map",
    "aim_points": "Where bank shots touch the board, and from where",
}
"""Captions of pictures, by the names of their files."""

_MARKS = re.compile(r"[\\`*_\[\]|~$#]")

_HTML = re.compile(r"<(?!(?:https?://|mailto:)[^\s<>]*>)(?=[A-Za-z/!?])")
"""Beginning of HTML in Markdown; addresses alone may stand in such brackets."""

_OF_ITSELF = ("kind", "name", "title")


@dataclass(frozen=True)
class Results:
    """The questions of a study, and what became of them."""

    questions: Sequence[Context]
    document: Mapping[str, Any]  # the study file as it is written
    answers: Mapping[str, Answer]  # by the name of the question
    errors: Mapping[str, Exception]  # of the questions without an answer
    folder: Path  # of the answers

    @property
    def written(self) -> Iterator[tuple[Context, Mapping[str, Any]]]:
        """The questions, and each as it is written."""
        return zip(self.questions, self.document["question"], strict=True)


def report(results: Results) -> str:
    """Return the report."""
    return "\n\n".join(_sections(results)) + "\n"


def _sections(results: Results) -> Iterator[str]:
    answers, errors = results.answers, results.errors
    study = results.questions[0].study
    yield f"# {_text(study.name)}"
    if study.description.strip():
        yield _HTML.sub("&lt;", study.description.strip())
    yield (
        f"By hoopgen {version()} from [study.toml](study.toml), seed {study.seed}; "
        f"intervals of {format_percent(study.confidence, None)} confidence, of the simulation "
        "alone "
        "unless they are said to be of the sample. "
        "[versions.json](versions.json) says what computed."
    )
    rows = ["| question | answer |", "|---|---|"]
    for context in results.questions:
        name = context.question.name
        text = answers[name].line if name in answers else f"not answered: {_text(errors[name])}"
        rows.append(f"| [{_title(context)}](#{name}) | {text} |")
    yield "\n".join(rows)
    apart = ("study", "question")
    shared = {key: value for key, value in results.document.items() if key not in apart}
    if shared:
        yield f"All questions have in common:\n\n{_toml(shared)}"
    for context, written in results.written:
        name = context.question.name
        yield f'<a id="{name}"></a>\n\n## {_title(context)}'
        options = {key: value for key, value in written.items() if key not in _OF_ITSELF}
        kind = f"{context.question.kind}. {asked_of(context)}"
        yield f"Asked: {kind}" + (f"\n\n{_toml(options)}" if options else "")
        if name in answers:
            yield from _answer(context, answers[name], results.folder)
        else:
            yield f"Not answered: {_text(errors[name])}"


def _answer(context: Context, answer: Answer, folder: Path) -> Iterator[str]:
    yield f"**{answer.line}**"
    yield f"Scene: {context.scene}."
    if answer.text:
        yield answer.text
    files = [file.name for file in answer_files(folder / context.question.name)]
    shown: dict[str, str] = {}
    for file in files:
        stem, suffix = Path(file).stem, Path(file).suffix
        if suffix in _SHOWN:
            shown.setdefault(stem, file)
    yield from (
        f"![{CAPTIONS.get(stem, stem)}]({context.question.name}/{file})"
        for stem, file in shown.items()
    )
    yield f"Files: {', '.join(f'[{file}]({context.question.name}/{file})' for file in files)}"


def _title(context: Context) -> str:
    return _text(context.question.title or context.question.name)


def asked_of(context: Context) -> str:
    """Return the first line of the question's description."""
    return (type(context.question).__doc__ or "").partition("\n")[0]


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
    """Return plain text as a line of Markdown, with marks and tags escaped."""
    line = printable(" ".join(str(said).split()))
    return _MARKS.sub(r"\\\g<0>", html.escape(line, quote=False))
