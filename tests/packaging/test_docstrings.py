"""Checks of docstrings beyond ruff's pydocstyle: first words and sections."""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Iterator
from functools import cache
from itertools import pairwise
from pathlib import Path

import pytest

from tests.helpers import ROOT
from tests.helpers.syntax import parsed, statements

pytestmark = pytest.mark.xdist_group("sources")  # all files are parsed once

EVERYWHERE = ("benchmarks", "derive", "hoopgen", "tests", "setup.py")
"""Sources whose docstrings begin with a full statement."""

WITH_SENTENCES = tuple(path for path in EVERYWHERE if path != "benchmarks")
"""Sources whose docstrings of modules, classes and functions have a sentence as first line."""

WITH_PARAMETERS = (
    "derive",
    *(f"hoopgen/{one.parent.name}" for one in sorted((ROOT / "hoopgen").glob("*/__init__.py"))),
)
"""Packages whose public functions with two or more arguments have a section Parameters."""

VAGUE = {"What", "Where", "It", "Those", "Of", "Such", "Which", "How", "Whether"}
"""First words that name nothing. A predicate, which returns a bool, may begin with Whether."""

VAGUE_OBJECT = re.compile(r"(Return|Yield|Give) (what|where|how)\b")
"""Beginnings that name an action and leave out the noun."""

Documented = ast.Module | ast.ClassDef | ast.FunctionDef | ast.Assign | ast.AnnAssign


def sources(path: str) -> list[Path]:
    files = sorted((ROOT / path).rglob("*.py")) if (ROOT / path).is_dir() else [ROOT / path]
    assert files
    return files


@cache
def documented(path: str) -> list[tuple[str, Documented, str]]:
    """Return where each docstring is, the node that it documents and its text.

    A string after an assignment documents the name that is assigned.
    """
    found: list[tuple[str, Documented, str]] = []
    for file in sources(path):
        for owner in statements(parsed(file)):
            body = getattr(owner, "body", None)
            for before, node in pairwise([owner, *body] if isinstance(body, list) else []):
                match node:
                    case ast.Expr(value=ast.Constant(value=str() as text)) if isinstance(
                        before, Documented
                    ):
                        where = f"{file.relative_to(ROOT)}:{node.lineno}"
                        found.append((where, before, inspect.cleandoc(text)))
    return found


def is_predicate(node: Documented) -> bool:
    return isinstance(node, ast.FunctionDef) and ast.unparse(node.returns or node) == "bool"


def is_command(function: ast.FunctionDef) -> bool:
    """Return whether a function is a command, whose docstring is its ``--help``."""
    return any(
        re.match(r"(click\.)?command\b", ast.unparse(one)) for one in function.decorator_list
    )


def public_functions(folder: str) -> Iterator[tuple[str, ast.FunctionDef]]:
    """Yield the documented functions and methods whose names, and whose class's, are public."""
    for file in sources(folder):
        module = parsed(file)
        classes = [one for one in module.body if isinstance(one, ast.ClassDef)]
        for owner in (module, *(one for one in classes if not one.name.startswith("_"))):
            for one in owner.body:
                if isinstance(one, ast.FunctionDef) and not one.name.startswith("_"):
                    yield f"{file.relative_to(ROOT)}:{one.lineno} {one.name}", one


def implemented(folder: str) -> set[str]:
    """Return the names of the methods that a protocol or an abstract class documents."""
    return {
        method.name
        for file in sources(folder)
        for one in parsed(file).body
        if isinstance(one, ast.ClassDef) and {"ABC", "Protocol"} & set(map(ast.unparse, one.bases))
        for method in one.body
        if isinstance(method, ast.FunctionDef)
        and "Parameters\n" in (ast.get_docstring(method) or "")
    }


def arguments(function: ast.FunctionDef) -> list[str]:
    given = function.args
    every = [*given.posonlyargs, *given.args, *given.kwonlyargs]
    return [one.arg for one in every if one.arg not in ("self", "cls")]


@pytest.mark.parametrize("path", EVERYWHERE)
def test_a_docstring_begins_with_a_statement(path: str) -> None:
    vague = [
        f"{where}: {text.splitlines()[0]}"
        for where, node, text in documented(path)
        if (
            (first := text.split()[0].strip(",:")) in VAGUE
            or (path != "tests" and VAGUE_OBJECT.match(text))
        )
        and not (first == "Whether" and is_predicate(node))
    ]
    assert not vague


@pytest.mark.slow
@pytest.mark.parametrize("path", WITH_SENTENCES)
def test_the_first_line_is_a_sentence(path: str) -> None:
    unended = [
        f"{where}: {text.splitlines()[0]}"
        for where, node, text in documented(path)
        if not isinstance(node, ast.Assign | ast.AnnAssign)
        and not text.splitlines()[0].endswith(".")
    ]
    assert not unended


@pytest.mark.parametrize("folder", WITH_PARAMETERS)
def test_public_functions_say_what_their_arguments_are(folder: str) -> None:
    silent = [
        where
        for where, function in public_functions(folder)
        if len(arguments(function)) > 1
        and (text := ast.get_docstring(function))
        and "Parameters\n----------" not in text
        and not is_command(function)
        and not re.search(r"\bas (for )?`\w", text)  # of another function, which says it
        and function.name not in implemented(folder)
    ]
    assert not silent
