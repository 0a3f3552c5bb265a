"""Public names of the last release still work, with a DeprecationWarning where they are renamed."""

from __future__ import annotations

import inspect
import json
import re
from collections.abc import Callable
from functools import cache
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace

import pytest

import hoopgen
from hoopgen.study.questions.optimum_result import Optimum
from tests.helpers import ROOT

RELEASED: dict[str, list[str] | None] = json.loads(
    Path(__file__).with_name("public_names_0_2_0.json").read_text(encoding="utf-8")
)
"""Names of `hoopgen`, `hoopgen.scene` and `hoopgen.plots` in 0.2.0, with their arguments."""

CALLS: dict[str, Callable[[], object]] = {
    "Optimum.told": lambda: Optimum.told(SimpleNamespace(describe=lambda: {"seed": "1"})),  # type: ignore[arg-type]
}
"""A call of each deprecated name, which gives what the new name gives."""

OLD = {"hoopgen.codegen.derivation.notation", "hoopgen.studyfile.single"}
"""Modules that the changelog names because they are gone."""

UNRELEASED = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8").split("\n## [0.2.0]")[0]


@cache
def _one_shot(with_errors: bool) -> hoopgen.Shots:
    fields = ("time_error", "state_error") if with_errors else "all"
    state = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    return hoopgen.simulate(state, fields=fields, record=not with_errors)


def find(name: str) -> object:
    """Return what a dotted name of the package stands for; a field without a default is None.

    Attributes of `Shots` are those of one shot, since a result has its fields by `__getattr__`.
    """
    found: object = import_module("hoopgen")
    owner = "hoopgen"
    for part in name.split(".")[1:]:
        owner = f"{owner}.{part}"
        if found is hoopgen.Shots and not hasattr(found, part):
            found = getattr(_one_shot(part in ("time_error", "state_error")), part)
        elif hasattr(found, part):
            found = getattr(found, part)
        elif inspect.isclass(found) and part in getattr(found, "__dataclass_fields__", {}):
            found = None
        elif inspect.ismodule(found):
            found = import_module(owner)
        else:
            raise AttributeError(owner)
    return found


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_every_public_name_of_the_last_release_takes_its_arguments() -> None:
    changed = []
    for name, arguments in RELEASED.items():
        try:
            found = find(name)
        except (AttributeError, ImportError):
            changed.append(f"{name} is gone")
            continue
        if arguments is None:
            continue
        assert callable(found), name
        parameters = inspect.signature(found).parameters.values()
        if not any(one.kind is inspect.Parameter.VAR_KEYWORD for one in parameters):
            missing = set(arguments) - {one.name for one in parameters}
            changed += [f"{name} has no argument {argument}" for argument in sorted(missing)]
    assert not changed


def test_every_deprecated_name_warns_gives_what_its_new_name_gives_and_is_in_the_changelog() -> (
    None
):
    sources = (path.read_text(encoding="utf-8") for path in (ROOT / "hoopgen").rglob("*.py"))
    texts = [text for each in sources for text in re.findall(r'warn\("(.*)", DeprecationW', each)]
    assert {text.partition(":")[0] for text in texts} == set(CALLS)
    for name, call in CALLS.items():
        with pytest.warns(DeprecationWarning, match=re.escape(name)):
            assert call() == {"seed": "1"}
        assert f"`{name}()`" in UNRELEASED


@pytest.mark.slow
def test_the_changelog_names_places_that_exist() -> None:
    named = set(re.findall(r"`(hoopgen(?:\.\w+)+)", UNRELEASED)) - {"hoopgen.json"}
    assert len(named) > 30
    for name in OLD & named:
        with pytest.raises((AttributeError, ImportError)):
            find(name)
    for name in sorted(named - OLD):
        find(name)


def moved_modules() -> list[tuple[str, str]]:
    """Return the former and the present names of the modules that the changelog says have moved."""
    section = UNRELEASED.split("### Moved modules\n")[1].split("\n### ")[0]
    pairs = []
    for package, modules in re.findall(r"^- `([\w.]+)`: ((?:.|\n(?!- ))+)", section, re.MULTILINE):
        for former, renamed in re.findall(r"`([\w.]+)`(?:\s+as\s+`(\w+)`)?", modules):
            name = renamed or former.rpartition(".")[2]
            pairs.append((f"hoopgen.{former}", f"{package}.{name}"))
    return pairs


def test_moved_modules_are_where_the_changelog_says_and_no_longer_where_they_were() -> None:
    pairs = moved_modules()
    assert len(pairs) > 100
    for former, present in pairs:
        assert not hasattr(import_module(present), "__path__"), present
        try:
            left = import_module(former)
        except ImportError:
            continue
        assert hasattr(left, "__path__"), former  # a package has its name now
