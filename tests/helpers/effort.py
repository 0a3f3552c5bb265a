"""The effort of random tests: one number, HOOPGEN_TEST_EFFORT, scales all of them."""

from __future__ import annotations

import ast
import math
import os
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import TypeVar

from tests.helpers import ROOT

Item = TypeVar("Item")

EFFORT = float(os.environ.get("HOOPGEN_TEST_EFFORT") or 1)
"""The effort, from 0.1 to 100; `make test-slow` has 1."""

if not 0.1 <= EFFORT <= 100:
    raise ValueError(f"HOOPGEN_TEST_EFFORT is {EFFORT:g}, and must be between 0.1 and 100")


def trials(count: int, at_least: int = 1) -> int:
    """Return how many shots, rows or examples a test tries.

    Parameters
    ----------
    count
        How many it tries at effort 1.
    at_least
        How many it needs at any effort, for its random numbers to hold what it claims of them.
    """
    return max(at_least, round(EFFORT * count))


def spread(items: Sequence[Item]) -> tuple[Item, ...]:
    """Return the items that are tried: all from effort 1 on, else a share, evenly spread.

    Parameters
    ----------
    items
        What is tried at effort 1; of one or more at least one is tried at any effort.
    """
    count = min(len(items), trials(len(items)))
    parts = max(count, 2)  # a single one is of the first half
    return tuple(items[(2 * k + 1) * len(items) // (2 * parts)] for k in range(count))


def occurrences(count: int) -> int:
    """Return how often something must at least occur among `trials`.

    Other efforts draw other numbers. What occurs n times on average occurs 5 sqrt(n) times less
    than that once in millions of runs, so that no test fails for lack of luck.

    Parameters
    ----------
    count
        How often it must occur at effort 1.
    """
    if EFFORT == 1:
        return count
    mean = EFFORT * count
    return max(0, math.floor(mean - 5 * math.sqrt(mean)))


def exceptions(share: float, of: int) -> float:
    """Return how many of so many trials must at most be exceptions.

    Parameters
    ----------
    share
        Which share of the trials must at most be exceptions at effort 1.
    of
        How many trials there are.
    """
    mean = share * of
    return mean if EFFORT == 1 else mean + 5 * math.sqrt(mean) + 3


@cache
def scaled_names(file: Path) -> frozenset[str]:
    """Return the names at the top level of a test file whose meaning depends on the effort.

    They are those that mention a name of this module, and those that mention one of them, here or
    in the test files that this one imports. A name of a function is also that of a fixture.
    """
    mentioned: dict[str, set[str]] = {}
    scaled = set[str]()
    bodies: list[tuple[str | None, ast.stmt]] = []
    for node in ast.parse(file.read_text(encoding="utf-8")).body:
        match node:
            case ast.ImportFrom(module=str(module), names=names) if module.startswith("tests"):
                for each in names:
                    if _depends(module, each.name):
                        scaled.add(each.asname or each.name)
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
                bodies.append((name, node))
            case ast.Assign() | ast.AnnAssign() | ast.AugAssign():
                bodies.append((None, node))
    if not scaled:
        return frozenset()
    for name, node in bodies:
        used = _names(node)
        for each in used if name is None else (name,):
            mentioned.setdefault(each, set()).update(used)
    while more := {name for name, used in mentioned.items() if used & scaled} - scaled:
        scaled |= more
    return frozenset(scaled)


def _names(node: ast.AST) -> set[str]:
    """Return the names that code mentions, those of arguments and thus of fixtures included."""
    return {
        each.id if isinstance(each, ast.Name) else each.arg
        for each in ast.walk(node)
        if isinstance(each, ast.Name | ast.arg)
    }


def _depends(module: str, name: str) -> bool:
    """Return whether a name that is imported from a module of the tests depends on the effort."""
    if module == __name__:
        return name != scaled_names.__name__
    place = ROOT.joinpath(*module.split("."))
    if (inner := place / f"{name}.py").is_file():  # a module
        return bool(scaled_names(inner))
    file = place / "__init__.py" if place.is_dir() else place.with_suffix(".py")
    return name in scaled_names(file)
