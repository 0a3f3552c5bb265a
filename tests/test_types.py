"""Type checkers see the type of every public name."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from compiled import ROOT

import hoopgen

pytest.importorskip("mypy")

PUBLIC = sorted(name for name in dir(hoopgen) if not name.startswith("_"))


@pytest.fixture(scope="module")
def revealed(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Return what mypy says of each public name, and of one that does not exist."""
    folder = tmp_path_factory.mktemp("types")
    names = [*PUBLIC, "no_such_name"]
    lines = ["import hoopgen", *(f"reveal_type(hoopgen.{name})" for name in names)]
    (file := folder / "names.py").write_text("\n".join(lines) + "\n")
    # The installed names over the sources, as `make lint` has them.
    (rooms := folder / "typing" / "hoopgen").mkdir(parents=True)
    for room in ("derive", "generated", "templates"):
        (rooms / room).symlink_to(ROOT / room)
    command = [sys.executable, "-m", "mypy", "--config-file", str(ROOT / "pyproject.toml")]
    answer = subprocess.run(
        [*command, "--cache-dir", str(folder / "cache"), "--follow-imports=silent", str(file)],
        cwd=ROOT,
        env=os.environ | {"MYPYPATH": str(rooms.parent)},
        capture_output=True,
        text=True,
        check=False,
    ).stdout
    said = re.findall(r"names\.py:(\d+): (?:note: Revealed type is|error:) (.*)$", answer, re.M)
    return {names[int(line) - 2]: text for line, text in reversed(said)}


def test_every_public_name_has_a_type_of_its_own(revealed: dict[str, str]) -> None:
    assert {name for name in PUBLIC if revealed.get(name, "Any").strip('"') == "Any"} == set()


def test_a_misspelt_name_is_an_error_of_the_type_checker(revealed: dict[str, str]) -> None:
    assert "has no attribute" in revealed["no_such_name"]


def test_names_for_type_checkers_are_those_at_run_time() -> None:
    tree = ast.parse(Path(hoopgen.__file__).read_text("utf-8"))
    (block,) = (
        node
        for node in tree.body
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
    )
    typed = {
        alias.asname: (node.module or "")
        for node in block.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    submodules = dict.fromkeys(hoopgen._SUBMODULES, "")
    assert typed == {**hoopgen._LAZY, **submodules}
    assert sorted(typed) == PUBLIC
