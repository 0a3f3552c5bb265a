"""The report of a study as a page: one file that needs no other, to read, to print, to pass on.

Everything on it is text to Jinja2, which escapes it: names, titles, errors and the study file are
never HTML. Pictures are images, in which nothing runs, and the page allows no scripts at all.
"""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from importlib.resources import files
from pathlib import Path
from typing import Any

from hoopgen.core.extras import require, version
from hoopgen.report.provenance import describe_release, describe_setting
from hoopgen.study.measures.measures import MEASURES
from hoopgen.study.questions.settings import settings
from hoopgen.study.questions.specification import (
    QUESTIONS,
    AimQuestion,
    BankQuestion,
    BatchQuestion,
    CompareQuestion,
    MapQuestion,
    OptimumQuestion,
)
from hoopgen.text.escape import printable
from hoopgen.text.numbers import format_percent

from .context import Context
from .question_folders import answer_files
from .report import CAPTIONS, Results, asked_of
from .schema import Given, Question

_TYPES: Mapping[str, str] = {".svg": "image/svg+xml", ".png": "image/png"}
"""Types of pictures that a page can show, the better one first."""

_OF_ITSELF = {"kind", "name", "title", *(name for name, *_ in settings(Given)), "versus", "figures"}
"""Keys of a question that are said elsewhere on the page."""

_AIMED = ("height", "angle", "backspin", "sidespin")
"""Variables of the release that a table of aim takes."""


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
    """Return the module of the page's templates, Jinja2."""
    check_markdown()
    return require("jinja2", "a report page")


def page(content: bytes, results: Results, made_with: Mapping[str, str]) -> str:
    """Return the page, HTML.

    Parameters
    ----------
    content
        The study file.
    made_with
        The versions of what computed, by name.
    """
    jinja = check_page()
    environment = jinja.Environment(
        autoescape=True, undefined=jinja.StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    template = environment.from_string((files(__package__) / "page.html.j2").read_text("utf-8"))
    study = results.questions[0].study
    text: str = template.render(
        title=_clean(study.name),
        description=rendered(study.description),
        version=version(),
        seed=study.seed,
        confidence=format_percent(study.confidence, None),
        digest=hashlib.sha256(content).hexdigest(),
        sections=[_section(context, written, results) for context, written in results.written],
        made_with=dict(made_with),
        study_file=_clean(content.decode("utf-8", "replace")),
    )
    return text


def _clean(text: str) -> str:
    """Return a text whose lines hold nothing but what can be shown."""
    return "\n".join(map(printable, text.splitlines()))


def _section(context: Context, written: Mapping[str, Any], results: Results) -> _Section:
    question = context.question
    answer = results.answers.get(question.name)
    error = "" if answer else " ".join(str(results.errors[question.name]).split())
    here = results.folder / question.name
    there = answer_files(here) if answer else []
    shown = _shown(there)
    drawn = {file.stem for file in there if file.suffix in (*_TYPES, ".pdf")}
    return _Section(
        question.name,
        _clean(question.title or question.name),
        asked_of(context),
        {name: _clean(text) for name, text in _setting(context).items()},
        list(_options(question, written)),
        _clean(answer.line) if answer else "",
        _clean(error),
        list(_parts(answer.text)) if answer else [],
        [_Picture(CAPTIONS.get(stem, stem), _embedded(file)) for stem, file in shown.items()],
        [CAPTIONS.get(stem, stem) for stem in sorted(drawn - set(shown))],
        hashlib.sha256((here / "answer.json").read_bytes()).hexdigest() if answer else "",
    )


# ------------------------------------------------------------------------------------ what is asked


def _setting(context: Context) -> dict[str, str]:
    """Return the scene, the release and its scatter as text, by name."""
    question = context.question
    if isinstance(question, BatchQuestion | AimQuestion):
        release = {} if isinstance(question, AimQuestion) else context.shared_release
        if isinstance(question, AimQuestion):
            aimed = context.setting.release
            release = {name: aimed[name] for name in _AIMED if name in aimed}
        said = {"scene": context.scene}
        return said | ({"release": describe_release(release, context.engine)} if release else {})
    over = []
    if isinstance(question, MapQuestion | OptimumQuestion | BankQuestion):
        over = list(question.over)
    over += ["distance", "angle", "x", "y"] if isinstance(question, BankQuestion) else []
    identity = context.setting.model(over).identity()
    said = describe_setting({**identity, "parameters": context.setting.parameters}, context.engine)
    if not isinstance(question, CompareQuestion):
        return {name: text for name, text in said.items() if text}
    changed = describe_setting(context.changed(question.versus).identity(), context.engine)
    both = {name: text for name, text in said.items() if changed.get(name) == text}
    first = {f"{name}, first": said.get(name, "none") for name in said if name not in both}
    second = {f"{name}, second": changed[name] for name in changed if name not in both}
    return both | first | second


def _options(question: Question, written: Mapping[str, Any]) -> Iterator[tuple[str, str, str]]:
    """Yield the other settings of a question: the key, its value, and its meaning."""
    for key, value in written.items():
        if key in _OF_ITSELF:
            continue
        said = [MEASURES[name].label for name in value] if key == "measures" else value
        about = next(
            one.help for name, _, one, _ in settings(QUESTIONS[question.kind]) if name == key
        )
        yield key.replace("_", " "), _clean(_value_text(said)), about


def _value_text(value: Any) -> str:
    """Return a value of a study file as text, with its units as they are written."""
    if isinstance(value, Mapping):
        if set(value) == {"from", "to", "count"}:
            first, last = _value_text(value["from"]), _value_text(value["to"])
            return f"{first} to {last}, {value['count']} values"
        return "; ".join(f"{key}: {_value_text(one)}" for key, one in value.items())
    if isinstance(value, list):
        return ", ".join(map(_value_text, value)) or "none"
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


_BELOW = 2
"""Levels: a page has one title, and its questions' titles are the next."""

_DEEPEST = 6


def check_markdown() -> Any:
    """Return the module that parses Markdown, markdown_it."""
    return require("markdown_it", "a report page")


def rendered(text: str) -> str:
    """Return Markdown (CommonMark, and tables) as HTML.

    HTML in it is text, and of a picture, which a page that is one file has not, the words that
    stand for it. Links lead nowhere but to addresses of the web and of mail, and to files.
    """
    markdown = check_markdown().MarkdownIt("commonmark", {"html": False}).enable("table")
    markdown.add_render_rule("image", _in_words)
    tokens = markdown.parse("\n".join(map(printable, text.splitlines())))
    for token in tokens:
        if token.type in ("heading_open", "heading_close"):
            token.tag = f"h{min(int(token.tag[1:]) + _BELOW, _DEEPEST)}"
    shown = markdown.renderer.render(tokens, markdown.options, {})
    # What a number in it stood for, such as &#8238;, is there only now.
    return "\n".join(map(printable, shown.splitlines()))


def _in_words(renderer: Any, tokens: Sequence[Any], at: int, options: Any, env: Any) -> str:
    words: str = renderer.renderInlineAsText(tokens[at].children, options, env)
    return escape(words)
