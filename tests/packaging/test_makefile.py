"""`make test` and `make test-slow` leave no test out, and no random test at less than full effort.

`tests/conftest.py` marks as scaled every test that `scaled_names` gives, and every test with such a
fixture. What else could scale is looked for here.
"""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.helpers import ROOT
from tests.helpers.effort import scaled_names
from tests.helpers.syntax import parsed, statements

pytestmark = pytest.mark.xdist_group("sources")  # all files are parsed once

MAKEFILE = (ROOT / "Makefile").read_text(encoding="utf-8")
EFFORT = "tests/helpers/effort.py"


def command(target: str) -> str:
    """Return the one command of a target of the Makefile."""
    (found,) = re.findall(rf"^{target}:.*\n((?:\t.*\n)+)", MAKEFILE, re.MULTILINE)
    return str(found)


def selects(target: str, slow: bool, scaled: bool) -> bool:
    """Return whether a target runs a test with these marks."""
    (expression,) = re.findall(r'-m "([a-z ]+)"', command(target))
    return bool(eval(expression, {"slow": slow, "scaled": scaled}))


def importers() -> Iterator[tuple[str, ast.ImportFrom]]:
    """Yield the imports of the tests' effort, with the files in which they are."""
    for path in (ROOT / "tests").rglob("*.py"):
        for node in statements(parsed(path)):
            if isinstance(node, ast.ImportFrom) and "effort" in {
                *str(node.module).split("."),
                *(name.name for name in node.names),
            }:
                yield path.relative_to(ROOT).as_posix(), node


@pytest.mark.parametrize("slow", [False, True])
@pytest.mark.parametrize("scaled", [False, True])
def test_every_test_is_run_at_full_effort_by_one_of_the_two_targets(
    slow: bool, scaled: bool
) -> None:
    at_once, later = (selects(target, slow, scaled) for target in ("test", "test-slow"))
    assert at_once or later
    assert later or not scaled  # what does not scale is at full effort at any
    assert "HOOPGEN_TEST_EFFORT" not in command("test-slow")


def test_all_tests_are_run_at_full_effort_by_one_target() -> None:
    assert " -m pytest " in command("test-all")
    assert command("test-all").count(" -m ") == 1  # pytest selects nothing
    assert "HOOPGEN_TEST_EFFORT" not in command("test-all")


@pytest.mark.parametrize(
    ("effort", "tried"),
    [("0.1", (1,)), ("0.6", (0, 2, 4)), ("1", (0, 1, 2, 3, 4)), ("7", (0, 1, 2, 3, 4))],
)
def test_below_effort_1_a_share_of_the_cases_is_tried(
    effort: str, tried: tuple[int, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOOPGEN_TEST_EFFORT", effort)
    code = "from tests.helpers.effort import spread; print((spread(range(5)), spread('a')))"
    told = subprocess.run(
        [sys.executable, "-c", code],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    assert ast.literal_eval(told.stdout) == (tried, ("a",))


def test_the_effort_is_imported_by_the_names_of_its_functions() -> None:
    """A name given by `as`, or a helper that scales, would hide which tests scale."""
    files = list(importers())
    assert len({path for path, _ in files}) > 40
    for path, node in files:
        assert node.module == "tests.helpers.effort", path
        assert not any(name.asname for name in node.names), path
        assert Path(path).name.startswith("test_") or path == "tests/conftest.py", path


def test_a_test_scales_if_anything_that_it_uses_does(tmp_path: Path) -> None:
    file = tmp_path / "test_any.py"
    file.write_text(
        """
from tests.helpers import ROOT
from tests.helpers.effort import trials
from tests.packaging import test_makefile
from tests.derive.events import test_ring as other

ROWS = trials(100)

def rows(): return range(ROWS)

def shots(rows): return rows()

@settings(max_examples=trials(5))
def test_decorated(): pass

def test_with_a_fixture(shots): pass

def test_of_another_file(): other.check()

def test_alone(): return ROOT
"""
    )
    tests = {name for name in scaled_names(file) if name.startswith("test_")}
    assert tests == {"test_decorated", "test_with_a_fixture", "test_of_another_file"}


def test_no_other_file_reads_how_much_tests_try() -> None:
    name = "_".join(("HOOPGEN", "TEST", "EFFORT"))
    readers = {
        path.relative_to(ROOT).as_posix()
        for path in (ROOT / "tests").rglob("*.py")
        if re.search(rf"environ.*{name}", path.read_text(encoding="utf-8"))
    }
    assert readers == {EFFORT}


def test_the_marks_are_set(request: pytest.FixtureRequest) -> None:
    shared = scaled_names(ROOT / "tests" / "conftest.py")
    assert "mixed" in shared
    for item in request.session.items:
        names = {getattr(item, "originalname", item.name), *getattr(item, "fixturenames", ())}
        scales = not names.isdisjoint(scaled_names(item.path) | shared)
        assert scales == (item.get_closest_marker("scaled") is not None), item.nodeid
