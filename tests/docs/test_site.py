"""Every example of the site is run when it is built, and it speaks of all that is public."""

from __future__ import annotations

import json
import re
import tomllib
from itertools import pairwise
from pathlib import Path
from runpy import run_path

import pytest

import hoopgen
from hoopgen.cli import main
from tests.helpers import ROOT

pytest.importorskip("nbclient")

from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

READER = run_path(str(ROOT / "docs" / "pages.py"))
MADE = ("_build", "gallery", "notebooks")
PAGES = [
    page
    for page in (ROOT / "docs").rglob("*.md")
    if page.relative_to(ROOT / "docs").parts[0] not in MADE
]
REFERENCE = "\n".join(page.read_text("utf-8") for page in (ROOT / "docs" / "reference").iterdir())


def run(text: str, folder: Path) -> str:
    """Run a page in a folder, and return what its cells print."""
    notebook = READER["read"](text)
    NotebookClient(notebook, resources={"metadata": {"path": str(folder)}}).execute()
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", ())]
    return "".join(output.get("text", "") for output in outputs)


@pytest.mark.slow
@pytest.mark.xdist_group("kernels")
def test_a_page_s_blocks_are_run_in_order(tmp_path: Path) -> None:
    page = """# A page
```text note.txt
kept
```
then
```python
word = open("note.txt").read().strip()
print(word)
```
```sh
ls examples/shots.c
cat note.txt
```
"""
    assert run(page, tmp_path) == "kept\nexamples/shots.c\nkept\n"


@pytest.mark.slow
@pytest.mark.xdist_group("kernels")
@pytest.mark.parametrize("block", ["```python\n1 / 0\n```\n", "```sh\nfalse\ntrue\n```\n"])
def test_a_block_that_fails_fails_the_page(block: str, tmp_path: Path) -> None:
    with pytest.raises(CellExecutionError):
        run(block, tmp_path)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_no_example_of_a_page_is_left_out(page: Path) -> None:
    """However it is fenced; what a page includes is not read as cells, so it may have none."""
    text = page.read_text("utf-8")
    fences = re.findall(r"^[ >]*(?:`{3,}|~{3,}) *\{?(?:python|py|sh|bash|code-cell)\b", text, re.M)
    cells = [cell for cell in READER["read"](text).cells if cell.cell_type == "code"]
    shown = [cell for cell in cells if "remove-cell" not in cell.metadata.tags]
    assert len(fences) == len(shown)
    for included in re.findall(r"^```\{include\} (.*)$", text, re.M):
        other = (page.parent / included).read_text("utf-8")
        assert not READER["runs"](other), included


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_a_page_s_lines_keep_their_numbers(page: Path) -> None:
    """So a warning names the line that it is of."""
    text = page.read_text("utf-8")
    notebook = READER["read"](text)
    assert all(first <= then for first, then in pairwise(notebook.metadata.source_map))
    for cell, line in zip(notebook.cells, notebook.metadata.source_map, strict=True):
        if cell.cell_type == "markdown":
            assert "\n".join(text.split("\n")[line:]).startswith(cell.source.split("\n")[0])


def test_the_reference_has_all_that_is_public() -> None:
    said = set(re.findall(r"^\.\. (?:auto\w+|py:data):: (?:[\w.]+\.)?(\w+)$", REFERENCE, re.M))
    rooms = {"plots", "scene", "__version__"}
    public = {name for name in dir(hoopgen) if not name.startswith("_")} - rooms
    public |= {*hoopgen.plots.__all__, *hoopgen.scene.__all__}
    assert public - said == set()


def test_the_reference_has_every_command() -> None:
    asked = re.findall(r"^hoopgen (\w+) --help$", REFERENCE, re.M)
    assert sorted(asked) == sorted(main.commands)


@pytest.mark.parametrize("notebook", sorted((ROOT / "examples").glob("*.ipynb")), ids=str)
def test_notebooks_are_kept_without_what_they_gave(notebook: Path) -> None:
    cells = json.loads(notebook.read_text("utf-8"))["cells"]
    code = [cell for cell in cells if cell["cell_type"] == "code"]
    assert code
    assert [cell for cell in code if cell["outputs"] or cell["execution_count"]] == []


def test_the_citation_is_of_this_version() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    citation = (ROOT / "CITATION.cff").read_text("utf-8")
    assert re.findall(r"^version: (.*)$", citation, re.M) == [project["version"]]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_a_page_of_measurements_is_of_this_version(page: Path) -> None:
    """A page that a command writes names the version it was measured with."""
    measured = re.findall(
        r"^(?:hoopgen: |\| hoopgen \| `)(\d+\.\d+\.\d+)", page.read_text("utf-8"), re.M
    )
    assert set(measured) <= {hoopgen.__version__}


def test_the_paper_cites_what_its_list_has() -> None:
    cited = set(re.findall(r"@(\w+\d{4})", (ROOT / "paper" / "paper.md").read_text("utf-8")))
    listed = set(
        re.findall(r"^@\w+\{(\w+),", (ROOT / "paper" / "paper.bib").read_text("utf-8"), re.M)
    )
    assert cited == listed
