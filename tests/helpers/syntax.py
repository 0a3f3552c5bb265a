"""The syntax trees of source files, each file parsed once in a process."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path


@cache
def parsed(file: Path) -> ast.Module:
    """Return the syntax tree of a file, which nobody may change."""
    return ast.parse(file.read_text(encoding="utf-8"))


def statements(tree: ast.AST) -> Iterator[ast.AST]:
    """Yield a tree and all statements in it, nested ones too, in their order; no expressions."""
    yield tree
    for name in ("body", "handlers", "cases", "orelse", "finalbody"):
        inner = getattr(tree, name, None)
        for each in inner if isinstance(inner, list) else ():
            yield from statements(each)
