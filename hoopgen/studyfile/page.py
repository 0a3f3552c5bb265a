"""The report of a study as a page: one file that needs no other, to read, to print, to pass on.

Everything on it is text to Jinja2, which escapes it: names, titles, errors and the study file are
never HTML. Pictures are images, in which nothing runs, and the page allows no scripts at all.
"""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import Any

from hoopgen.installed import need, version
from hoopgen.phrases import percent
from hoopgen.printable import printable
from hoopgen.study.measures import MEASURES
from hoopgen.told import say_release, told_setting

from .asked import Answer, Asked
from .markdown import check_markdown, rendered
from .question_folders import answer_files
from .report import CAPTIONS, asked_of
from .schema import Aim, Bank, Batch, Compare, Given, Map, Optimum, Question

__all__ = ["check_page", "page"]

_TYPES: Mapping[str, str] = {".svg": "image/svg+xml", ".png": "image/png"}
"""Of pictures that a page can show, the better one first."""

_OF_ITSELF = {"kind", "name", "title", *Given.model_fields, "versus", "figures"}
"""Keys of a question that are said elsewhere on the page."""

_AIMED = ("height", "angle", "backspin", "sidespin")
"""What a table of aim takes of the release."""


@dataclass(frozen=True)
class _Picture:
    """A picture of an answer: what it shows, and itself."""

    caption: str
    source: str


@dataclass(frozen=True)
class _Part:
    """A part of an answer: lines as they are printed, a table with its head, or a sentence."""

    lines: str = ""
    head: Sequence[str] = ()
    rows: Sequence[Sequence[str]] = ()
    text: str = ""


@dataclass(frozen=True)
class _Section:
    """A question with its answer, as the page shows them; see `page.html.j2`."""

    name: str
    title: str
    asked: str
    setting: Mapping[str, str]
    options: Sequence[tuple[str, str, str]]
    answer: str
    error: str
    parts: Sequence[_Part]
    pictures: Sequence[_Picture]
    elsewhere: Sequence[str]
    digest: str


def check_page() -> Any:
    """Return what makes the page.

    Raises
    ------
    ImportError
        If Jinja2 or markdown-it-py is missing: what brings it.
    """
    check_markdown()
    return need("jinja2", "a report page")


def page(
    content: bytes,
    questions: Sequence[Asked],
    document: Mapping[str, Any],
    answers: Mapping[str, Answer],
    errors: Mapping[str, Exception],
    folder: Path,
    made_with: Mapping[str, str],
) -> str:
    """Return the page, HTML.

    Parameters
    ----------
    content
        Of the study file.
    questions, document, answers, errors, folder
        As of `hoopgen.studyfile.report.report`.
    made_with
        Versions of what computed.
    """
    jinja = check_page()
    environment = jinja.Environment(
        autoescape=True, undefined=jinja.StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    template = environment.from_string((files(__package__) / "page.html.j2").read_text("utf-8"))
    study = questions[0].study
    text: str = template.render(
        title=_clean(study.name),
        description=rendered(study.description),
        version=version(),
        seed=study.seed,
        confidence=percent(study.confidence, None),
        digest=hashlib.sha256(content).hexdigest(),
        sections=[
            _section(asked, written, answers, errors, folder)
            for asked, written in zip(questions, document["question"], strict=True)
        ],
        made_with=dict(made_with),
        study_file=_clean(content.decode("utf-8", "replace")),
    )
    return text


def _clean(text: str) -> str:
    """Return a text whose lines hold nothing but what can be shown."""
    return "\n".join(map(printable, text.splitlines()))


def _section(
    asked: Asked,
    written: Mapping[str, Any],
    answers: Mapping[str, Answer],
    errors: Mapping[str, Exception],
    folder: Path,
) -> _Section:
    question = asked.question
    answer = answers.get(question.name)
    error = "" if answer else " ".join(str(errors[question.name]).split())
    here = folder / question.name
    there = answer_files(here) if answer else []
    shown = _shown(there)
    drawn = {file.stem for file in there if file.suffix in (*_TYPES, ".pdf")}
    return _Section(
        question.name,
        _clean(question.title or question.name),
        asked_of(asked),
        {name: _clean(text) for name, text in _setting(asked).items()},
        list(_options(question, written)),
        _clean(answer.line) if answer else "",
        _clean(error),
        list(_parts(answer.text)) if answer else [],
        [_Picture(CAPTIONS.get(stem, stem), _embedded(file)) for stem, file in shown.items()],
        [CAPTIONS.get(stem, stem) for stem in sorted(drawn - set(shown))],
        hashlib.sha256((here / "answer.json").read_bytes()).hexdigest() if answer else "",
    )


# ------------------------------------------------------------------------------------ what is asked


def _setting(asked: Asked) -> dict[str, str]:
    """Say what is thrown, by what it is: the scene, the release, its scatter."""
    question = asked.question
    if isinstance(question, Batch | Aim):
        release = dict(asked.setting.release if isinstance(question, Aim) else question.release)
        if isinstance(question, Aim):
            release = {name: release[name] for name in _AIMED if name in release}
        said = {"scene": asked.scene}
        return said | ({"release": say_release(release, asked.engine)} if release else {})
    over = list(question.over) if isinstance(question, Map | Optimum | Bank) else []
    over += ["distance", "angle", "x", "y"] if isinstance(question, Bank) else []
    identity = asked.setting.model(over).identity()
    said = told_setting({**identity, "parameters": asked.setting.parameters}, asked.engine)
    if not isinstance(question, Compare):
        return {name: text for name, text in said.items() if text}
    changed = told_setting(asked.changed(question.versus).identity(), asked.engine)
    both = {name: text for name, text in said.items() if changed.get(name) == text}
    first = {f"{name}, first": said.get(name, "none") for name in said if name not in both}
    second = {f"{name}, second": changed[name] for name in changed if name not in both}
    return both | first | second


def _options(question: Question, written: Mapping[str, Any]) -> Iterator[tuple[str, str, str]]:
    """Yield what else a question says: the key, its value, and what that says."""
    for key, value in written.items():
        if key in _OF_ITSELF:
            continue
        said = [MEASURES[name].label for name in value] if key == "measures" else value
        about = type(question).model_fields[key].description or ""
        # What says how to write a file, or leads to elsewhere in its reference, is none for here.
        plain = "`" not in about and not about.startswith("As of")
        yield key.replace("_", " "), _clean(_said(said)), about if plain else ""


def _said(value: Any) -> str:
    """Say a value of a study file, with its units as they are written."""
    if isinstance(value, Mapping):
        if set(value) == {"from", "to", "count"}:
            return f"{_said(value['from'])} to {_said(value['to'])}, {value['count']} values"
        return "; ".join(f"{key}: {_said(one)}" for key, one in value.items())
    if isinstance(value, list):
        return ", ".join(map(_said, value)) or "none"
    if isinstance(value, int) and not isinstance(value, bool):
        return f"{value:,}"
    return str(value)


# ------------------------------------------------------------------------------------ what came out


def _parts(text: str) -> Iterator[_Part]:
    """Yield the parts of an answer's text, which is Markdown of ours: see `fenced` and `_table`."""
    lines = text.splitlines()
    if text.startswith("```"):
        yield _Part(lines=_clean("\n".join(lines[1:-1])))
    elif text.startswith("|"):
        head, _, *rows = (list(map(str.strip, _clean(line).split("|")[1:-1])) for line in lines)
        yield _Part(head=head, rows=rows)
    elif text:
        yield _Part(text=_clean(text))


def _shown(there: Sequence[Path]) -> dict[str, Path]:
    """Return the pictures that a page can show, by what they are: of two formats the better."""
    found: dict[str, Path] = {}
    for suffix in _TYPES:
        for file in there:
            if file.suffix == suffix:
                found.setdefault(file.stem, file)
    return dict(sorted(found.items()))


def _embedded(file: Path) -> str:
    """Return a picture as an address that holds all of it."""
    return f"data:{_TYPES[file.suffix]};base64,{base64.b64encode(file.read_bytes()).decode()}"
