"""The report of a study as a page: all of it in one file, and nothing of it is anyone's HTML."""

from __future__ import annotations

import base64
import hashlib
import re
import sys
from html import unescape
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest

from tests.helpers import ROOT
from tests.helpers.commands import run, succeed

for _library in ("jinja2", "markdown_it", "matplotlib", "pyarrow", "pydantic", "scipy", "xarray"):
    pytest.importorskip(_library)

from hoopgen.studyfile import run_study, sweeps  # noqa: E402
from hoopgen.studyfile.page import rendered  # noqa: E402

pytestmark = pytest.mark.xdist_group("report_page")  # the study is run once

HEAD = """\
[study]
name = "Free throws"
description = "First of all.\\n\\nAnd then."
seed = 5
formats = ["svg"]

[release]
height = "7 ft"
distance = "13.75 ft"
elevation = "52 deg"
aim = "2 in"
backspin = "3 Hz"

[scatter]
speed = "0.063 m/s"
"""

ESTIMATE = """
[[question]]
kind = "estimate"
name = "probability"
title = "How often"
shots = 2000
"""

ALL = (
    HEAD
    + ESTIMATE
    + """measures = ["rebound_distance"]
figures = ["rebounds"]

[[question]]
kind = "compare"
name = "backspin"
versus.release.backspin = 0
shots = 1000

[[question]]
kind = "map"
name = "map"
over.elevation = { from = "48 deg", to = "56 deg", count = 3 }
over.aim = ["0 in", "2 in"]
shots = 100

[[question]]
kind = "aim"
name = "table"
distance = [3, "13.75 ft"]
entry = "45 deg"

[[question]]
kind = "batch"
name = "rows"
file = "releases.csv"
release = { height = "7 ft", distance = "13.75 ft" }
"""
)

VOID = {"meta", "link", "br", "img", "hr", "input"}


class _Read(HTMLParser):
    """A parsed page: its elements, their links, and text by element."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.links: list[str] = []
        self.open: list[str] = []
        self.ids: list[str] = []
        self.text: list[tuple[str, str]] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        given = {name: value or "" for name, value in attrs}
        assert not [name for name in given if name.startswith("on")]
        self.links += [given[name] for name in ("src", "href", "action") if name in given]
        self.ids += [given["id"]] if "id" in given else []
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if data.strip():
            self.text.append((self.open[-1], " ".join(data.split())))

    def said(self, tag: str) -> list[str]:
        return [text for where, text in self.text if where == tag]


def _written(folder: Path, text: str) -> Path:
    folder.mkdir(exist_ok=True)
    rows = "speed,elevation_deg\n7.1,52\n7.2,51\n"
    (folder / "releases.csv").write_text(rows, encoding="utf-8")
    file = folder / "study.toml"
    file.write_text(text, encoding="utf-8")
    return file


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path, Any]:
    """The page of a study, the folder of its results, and its answers."""
    folder = tmp_path_factory.mktemp("page")
    answers = run_study(_written(folder, ALL), report=folder / "report.html", threads=1)
    return (folder / "report.html").read_text("utf-8"), folder / "study-results", answers


@pytest.mark.slow
def test_the_page_is_one_file_that_needs_no_other_and_runs_nothing(
    whole: tuple[str, Path, Any],
) -> None:
    text, folder, _ = whole
    read = _Read(text)
    assert read.open == []
    assert not {"script", "link", "iframe", "object", "form", "base"} & set(read.tags)
    inside = [link for link in read.links if link.startswith("#")]
    assert {link.removeprefix("#") for link in inside} <= set(read.ids)
    (picture,) = [link for link in read.links if not link.startswith("#")]
    kind, content = picture.split(",", 1)
    assert kind == "data:image/svg+xml;base64"
    assert base64.b64decode(content) == (folder / "probability" / "rebounds.svg").read_bytes()
    policy = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"
    assert policy in text
    assert "url(" not in text
    assert "@import" not in text


@pytest.mark.slow
def test_the_page_has_every_question_answer_and_interval(whole: tuple[str, Path, Any]) -> None:
    text, _, answers = whole
    read = _Read(text)
    assert read.said("h1") == ["Free throws"]
    assert read.said("h2") == ["How often", *list(answers)[1:], "How it was made"]
    for answer in answers.values():
        assert answer.line in read.said("p")
        assert answer.line in read.said("td")
    made = answers["probability"].numbers
    assert re.search(rf"{100 * made['low']:.1f}\d*% to {100 * made['high']:.1f}", text)
    assert {"First of all.", "And then."} <= set(read.said("p"))
    # A table of ours is one there, a row for each distance.
    assert {"distance", "goes in with speed"} <= set(read.said("th"))
    assert {"3.000 m", "4.191 m"} <= set(read.said("td"))


def test_the_page_says_in_words_and_units_what_was_asked(whole: tuple[str, Path, Any]) -> None:
    read = _Read(whole[0])
    cells = read.said("td")
    release = "elevation 52°, backspin {} Hz, height 2.1336 m, distance 4.191 m, aim 0.0508 m"
    assert release.format(3) in cells
    assert release.format(0) in cells  # what the comparison changes
    assert {"release, first", "release, second"} <= set(read.said("th"))
    assert "speed 0.063 m/s" in cells
    assert "elevation: 48 deg to 56 deg, 3 values; aim: 0 in, 2 in" in cells
    # What a map varies is not said to be given; a table of aim takes height and spin alone.
    assert "backspin 3 Hz, height 2.1336 m, distance 4.191 m" in cells
    assert "backspin 3 Hz, height 2.1336 m" in cells
    assert "height 2.1336 m, distance 4.191 m" in cells  # of the table's rows
    assert "rebound distance" in cells
    assert "2,000" in cells
    assert cells.count("PAPER (the article's)") == 5


def test_the_page_says_how_it_was_made(whole: tuple[str, Path, Any]) -> None:
    text, folder, answers = whole
    read = _Read(text)
    digest = hashlib.sha256((folder / "study.toml").read_bytes()).hexdigest()
    found = [hashlib.sha256((folder / n / "answer.json").read_bytes()).hexdigest() for n in answers]
    assert [code for code in read.said("code") if len(code) == 64] == [digest, *found]
    assert {"hoopgen", "numpy", "python", "seed"} <= set(read.said("th"))
    assert "5" in read.said("td")
    (file,) = (said for said in read.said("pre") if said.startswith("[study]"))
    assert file == " ".join(ALL.split())


def test_the_page_is_read_in_the_dark_and_on_paper(whole: tuple[str, Path, Any]) -> None:
    """Each colour that is set for the light is set for the dark and for paper too."""
    style = re.findall(r"<style>(.*?)</style>", whole[0], re.DOTALL)[0]
    light, dark, paper = (
        set(re.findall(r"(--\w+):", block)) for block in re.findall(r":root \{(.*?)\}", style, re.S)
    )
    assert light == dark == paper
    assert "@media print" in style
    assert "prefers-color-scheme: dark" in style


def test_the_same_study_gives_the_same_page_also_from_its_folder(
    whole: tuple[str, Path, Any], tmp_path: Path
) -> None:
    text, folder, _ = whole
    run_study(folder.parent / "study.toml", report=tmp_path / "again.html")
    assert (tmp_path / "again.html").read_text("utf-8") == text


HOSTILE = "</pre></title><script>alert(1)</script> <img src=x onerror=alert(2)> &lt; {{ 7*7 }} \" '"


def test_names_titles_descriptions_and_comments_are_text(tmp_path: Path) -> None:
    head = HEAD.replace('"Free throws"', f"'''{HOSTILE}'''")
    head = head.replace('"First of all.\\n\\nAnd then."', f"'''{HOSTILE}'''")
    file = _written(tmp_path, f"# {HOSTILE}\n{head}{ESTIMATE}")
    file.write_text(file.read_text("utf-8").replace('"How often"', f"'''{HOSTILE}'''"), "utf-8")
    run_study(file, report=tmp_path / "page.html")
    read = _Read((tmp_path / "page.html").read_text("utf-8"))
    assert read.open == []
    assert not {"script", "img"} & set(read.tags)
    for tag in ("title", "h1", "h2", "a"):
        assert HOSTILE in read.said(tag)
    assert unescape(HOSTILE) in read.said("p")  # Markdown has entities
    assert f"# {HOSTILE}" in read.said("pre")[-1]


DESCRIPTION = """\
Two *things* are **asked**, of `speed`:

1. one
2. [two](https://example.org/a?b=1&c=2)

# Why

| a | b |
|---|--:|
| 1 | 2 |

```
<b>raw</b>
```

![the *court*](https://example.org/court.png)
"""


def test_a_description_is_shown_as_the_markdown_that_it_is(tmp_path: Path) -> None:
    head = HEAD.replace('"First of all.\\n\\nAnd then."', f"'''{DESCRIPTION}'''")
    assert DESCRIPTION in head
    run_study(_written(tmp_path, head + ESTIMATE), report=tmp_path / "page.html")
    text = (tmp_path / "page.html").read_text("utf-8")
    read = _Read(text)
    assert read.open == []
    assert (read.said("em"), read.said("strong"), read.said("li")) == (
        ["things"],
        ["asked"],
        ["one"],
    )
    assert {"speed", "<b>raw</b>"} <= set(read.said("code"))
    assert "https://example.org/a?b=1&c=2" in read.links
    # The page has one title, and a picture from elsewhere would not be in its one file.
    assert read.said("h1") == ["Free throws"]
    assert "Why" in read.said("h3")
    assert {"the court"} <= set(read.said("p"))
    assert not {"img", "b"} & set(read.tags)
    assert {"1", "2"} <= set(read.said("td"))


@pytest.mark.parametrize(
    "text",
    [
        "<script>alert(1)</script>",
        "a <img src=x onerror=alert(1)> b",
        "<!-- --><a href='x' onclick=alert(1)>x</a>",
        "[x](javascript:alert(1)) [y](JaVaScRiPt&colon;alert(1)) [z](vbscript:x) [u](file:///etc)",
        "[x]: javascript:alert(1)\n\n[x] ![x](javascript:alert(1))",
        "<javascript:alert(1)> <data:text/html,x>",
        '[x](<https://e.org/" onmouseover="alert(1)> "\\" onclick=alert(1)")',
        "![<script>](x 'y\" onerror=alert(1)')",
        '```"><script>alert(1)</script>\nx\n```',
        "| <svg/onload=alert(1)> |\n|---|\n| `<i>` |",
        "&lt;script&gt;alert(1)&lt;/script&gt; &#60;script&#62;",
        "{{ 7*7 }} {% raw %} ]]> </style></title>",
        "> " * 300 + "deep " + "[" * 300,
        "&#8238;&#27;[31m",
    ],
)
def test_nothing_of_a_description_acts(text: str) -> None:
    shown = rendered(text)
    read = _Read(shown)  # which refuses attributes that run something
    assert read.open == []
    allowed = {"p", "a", "pre", "code", "table", "thead", "tbody", "tr", "th", "td", "blockquote"}
    assert set(read.tags) <= allowed
    assert all(link.startswith("https://") for link in read.links)
    assert not set("\x1b\u202e") & set(shown)


def test_errors_are_text_and_what_was_answered_is_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(*_: Any, folder: Path | None = None, **__: Any) -> None:
        if folder is not None:  # not where the question is checked alone
            raise ValueError(f"{HOSTILE}\n\x1b[31m")

    monkeypatch.setattr(sweeps, "optimum", fails)
    lost = "[[question]]\nkind = 'optimum'\nname = 'lost'\nshots = 100\nover = ['elevation']\n"
    with pytest.raises(ExceptionGroup):
        run_study(_written(tmp_path, HEAD + lost + ESTIMATE), report=tmp_path / "page.html")
    read = _Read((tmp_path / "page.html").read_text("utf-8"))
    said = f"{HOSTILE} \\x1b[31m"
    assert f"not answered: {said}" in read.said("span")
    assert f"Not answered: {said}" in read.said("p")
    assert "script" not in read.tags
    assert any(" made (" in text for text in read.said("p"))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("formats", "kinds"),
    [
        ('["png"]', ["image/png"]),
        ('["pdf", "png", "svg"]', ["image/svg+xml"]),
        ('["pdf"]', []),
    ],
)
def test_pictures_are_shown_in_the_best_format_that_there_is(
    tmp_path: Path, formats: str, kinds: list[str]
) -> None:
    text = HEAD.replace('["svg"]', formats) + ESTIMATE + 'figures = ["landings"]\n'
    run_study(_written(tmp_path, text), report=tmp_path / "page.html")
    read = _Read((tmp_path / "page.html").read_text("utf-8"))
    shown = [link.split(";")[0] for link in read.links if link.startswith("data:")]
    assert shown == [f"data:{kind}" for kind in kinds]
    elsewhere = [said for said in read.said("p") if said.startswith("Drawn in formats")]
    assert bool(elsewhere) != bool(kinds)


@pytest.mark.slow
def test_a_study_of_another_scene_has_a_page_too(tmp_path: Path) -> None:
    scene = ROOT / "examples" / "scenes" / "golf.toml"
    (tmp_path / "golf.toml").write_bytes(scene.read_bytes())
    text = """\
scene = "golf.toml"
release = { x = -0.3, y = 0, z = 0.03, vx = 1.2, vy = 0, vz = 0 }
scatter = { vx = 0.1 }

[study]
name = "Golf"

[[question]]
kind = "estimate"
name = "ends"
shots = 200
"""
    run_study(_written(tmp_path, text), report=tmp_path / "page.html")
    read = _Read((tmp_path / "page.html").read_text("utf-8"))
    assert any(cell.startswith("golf") for cell in read.said("td"))
    assert any(cell.startswith("x -0.3") or "x −0.3" in cell for cell in read.said("td"))


def test_what_is_wrong_with_the_page_is_said_before_any_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = _written(tmp_path, HEAD + ESTIMATE)
    with pytest.raises(ValueError, match=r"'page\.pdf' ends in none of \.html, \.htm"):
        run_study(file, report=tmp_path / "page.pdf")
    with pytest.raises(FileNotFoundError):
        run_study(file, report=tmp_path / "nowhere" / "page.html")
    for missing in ("jinja2", "markdown_it"):
        with monkeypatch.context() as patch:
            patch.setitem(sys.modules, missing, None)
            with pytest.raises(ImportError, match=f"a report page needs {missing}"):
                run_study(file, report=tmp_path / "page.html")
    assert not (tmp_path / "study-results").exists()


def test_a_study_is_said_in_the_units_asked_for_also_when_it_was_kept(tmp_path: Path) -> None:
    file, out = _written(tmp_path, HEAD + ESTIMATE), tmp_path / "page.html"
    answers = set()
    for system, said in (("us", "13.75 ft"), ("si", "4.191 m"), ("us", "13.75 ft")):
        words = ["study", str(file), "--report", str(out), "--units", system]
        result = succeed(*words)
        (report,) = tmp_path.glob("*/report.md")
        for text in (report.read_text("utf-8"), out.read_text("utf-8")):
            assert f"distance {said}" in " ".join(text.split())
        answers.add(result.stdout.partition("report")[0])
    assert len(answers) == 1, "the same shots"


def test_the_command_writes_the_page_and_says_where(tmp_path: Path) -> None:
    file, out = _written(tmp_path, HEAD + ESTIMATE), tmp_path / "page.html"
    result = succeed("study", str(file), "--report", str(out))
    assert result.stdout.splitlines()[-1] == f"report       {out}"
    assert out.is_file()
    wrong = run("study", str(file), "--report", str(tmp_path / "page.pdf"))
    assert wrong.exit_code == 2
    assert "ends in none of .html, .htm" in wrong.stderr
