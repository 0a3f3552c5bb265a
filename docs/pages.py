"""The reader of the site's pages: it turns their code blocks into the cells of a notebook.

A page is plain Markdown. The build of the site runs its blocks in order, in a temporary folder in
which ``examples`` and ``generated`` are those of the checkout:

- The page shows a ``python`` block and its output.
- The page shows an ``sh`` block and its output; the block stops at the first command that fails.
- A block with a file name after its language, such as ``toml hole.toml``, is written to that file.

All other blocks are text. A block that fails or writes to stderr is a warning of the build.
"""

from __future__ import annotations

import re
from pathlib import Path

from nbformat import NotebookNode, v4

ROOT = Path(__file__).resolve().parents[1]

_BLOCK = re.compile(
    r"^```(?P<kind>python|sh|\w+ (?P<file>[\w.-]+))\n(?P<text>.*?)^```$", re.M | re.S
)

_START = f"""
import os, subprocess, sys

for name in ("examples", "generated"):
    os.symlink({str(ROOT)!r} + "/" + name, name)

def run_commands(text):
    completed = subprocess.run(["bash", "-e", "-c", text], capture_output=True, encoding="utf-8")
    print(completed.stdout, end="")
    sys.stderr.write(completed.stderr)
    completed.check_returncode()
"""


def runs(text: str) -> bool:
    """Return whether a page has a block to run."""
    return _BLOCK.search(text) is not None


def read(text: str) -> NotebookNode:
    """Return a page as a notebook whose cells keep the line numbers of the page."""
    cells: list[NotebookNode] = []
    lines: list[int] = []

    def add(cell: NotebookNode, at: int) -> None:
        cells.append(cell)
        lines.append(text.count("\n", 0, at))

    if runs(text):
        add(_code(_START, "remove-cell"), 0)
    done = 0
    for block in _BLOCK.finditer(text):
        shown = block.start() if block["kind"] == "python" else block.end()
        if text[done:shown].strip():
            add(v4.new_markdown_cell(text[done:shown]), done)
        add(_cell(block), block.start())
        done = block.end()
    if text[done:].strip():
        add(v4.new_markdown_cell(text[done:]), done)
    return v4.new_notebook(cells=cells, metadata={"source_map": lines, **_PYTHON})


_PYTHON = {
    "kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"},
    "language_info": {"name": "python", "pygments_lexer": "python"},
}


def _cell(block: re.Match[str]) -> NotebookNode:
    if block["kind"] == "python":
        return _code(block["text"].rstrip())
    if block["kind"] == "sh":
        return _code(f"run_commands({block['text']!r})", "remove-input")
    written = f"open({block['file']!r}, 'w', encoding='utf-8').write({block['text']!r})"
    return _code(written, "remove-cell")


def _code(source: str, *tags: str) -> NotebookNode:
    return v4.new_code_cell(source, metadata={"tags": list(tags)})
