"""The layers of the packages: every import leads to a lower layer, and none is circular."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

from tests.helpers import ROOT
from tests.helpers.syntax import parsed, statements

pytestmark = pytest.mark.xdist_group("sources")  # all files are parsed once

LAYERS = (
    {"derive.symbolic", "generated", "templates", "text"},
    {"core", "derive.contact", "derive.ir"},
    {"derive.elementary", "derive.motion", "derive.surfaces"},
    {"derive.errors"},
    {"derive.events"},
    {"derive.scenes", "derive.state"},
    {"derive.rolling", "derive.studies", "engine"},
    {"derive.loop", "hoop"},
    {"derive.kernels"},
    {"derive.model"},
    {"codegen"},
    {"scene"},
    {"report", "study.models"},
    {"results"},
    {"judge"},
    {"simulation"},
    {"interop", "study.measures"},
    {"study.named_units"},
    {"study.result"},
    {"study.statistics"},
    {"study.jobs"},
    {"study.tables"},
    {"study.questions", "study.recovery", "viewer"},
    {"plots"},
    {"studyfile"},
    {"hoopgen"},
    {"cli"},
    {"__main__"},
)
"""Packages by layer, the lowest first. A package imports only from layers below its own."""

LONG: Mapping[str, str] = {}
"""Files of more than `LINES` lines, and why."""

LINES = 400

BY_NAME = {
    "hoopgen",  # the composition root: public names, and what draws results
    "hoopgen.cli",  # its own commands, when they are called
    "hoopgen.core.extras",  # packages that may be missing
    "hoopgen.scene.compilers",  # a module of NumPy
}
"""Modules that import by a name that is computed, which the other tests do not see."""

Arrows = Mapping[str, set[str]]


def modules() -> dict[str, Path]:
    """Return the files of hoopgen, by the name under which each is imported."""
    found = {}
    for top in ("derive", "generated", "hoopgen"):
        for file in sorted((ROOT / top).rglob("*.py")):
            parts = file.relative_to(ROOT).with_suffix("").parts
            full = parts if top == "hoopgen" else ("hoopgen", *parts)
            found[".".join(full[:-1] if full[-1] == "__init__" else full)] = file
    return found


def imported(tree: ast.AST, package: str) -> Iterator[str]:
    """Yield all that is imported anywhere in a file: in functions, and for types alone, too."""
    for node in statements(tree):
        if isinstance(node, ast.Import):
            yield from (each.name for each in node.names)
        elif isinstance(node, ast.ImportFrom):
            up = package.split(".")[: 1 - node.level or None] if node.level else []
            where = ".".join([*up, *([node.module] if node.module else [])])
            yield from (f"{where}.{each.name}" for each in node.names)


def within(name: str, known: Mapping[str, Path]) -> str:
    """Return the module that a name imported from it lies in; none if it is not of hoopgen."""
    while name and name not in known:
        name = name.rpartition(".")[0]
    return name


def arrows(known: Mapping[str, Path]) -> dict[str, set[str]]:
    """Return what every module imports of hoopgen."""
    found = {}
    for name, file in known.items():
        package = name if file.name == "__init__.py" else name.rpartition(".")[0]
        inner = imported(parsed(file), package)
        found[name] = {within(each, known) for each in inner} - {"", name}
    return found


def package_of(module: str) -> str:
    """Return the package of a module; of derive/ and study/ each sub-package is one."""
    parts = module.split(".")
    if len(parts) == 1:
        return module
    return ".".join(parts[1:3]) if parts[1] in ("derive", "study") else parts[1]


def layer_of(module: str) -> int:
    package = package_of(module)
    if package in ("derive", "study"):  # their own __init__.py, which imports nothing
        return 0
    (found,) = (level for level, packages in enumerate(LAYERS) if package in packages)
    return found


def upward(found: Arrows) -> set[tuple[str, str]]:
    """Return the imports that do not lead to a lower layer, except those within a package."""
    return {
        (name, other)
        for name, others in found.items()
        for other in others
        if package_of(name) != package_of(other) and layer_of(name) <= layer_of(other)
    }


def circle(found: Arrows) -> list[str]:
    """Return modules that import each other in a circle, or none."""
    try:
        TopologicalSorter(found).prepare()
    except CycleError as error:
        return list(error.args[1])
    return []


@cache
def imports() -> Arrows:
    """Return what every module imports of hoopgen, read once."""
    return arrows(modules())


def test_every_package_has_one_layer() -> None:
    packages = {package_of(name) for name in modules()} - {"derive", "study"}
    assert packages | {"templates"} == {each for level in LAYERS for each in level}
    assert len(packages) + 1 == sum(map(len, LAYERS))


def test_no_import_leads_up() -> None:
    assert upward(imports()) == set()


def test_no_imports_lead_round() -> None:
    assert circle(imports()) == []


def test_only_the_root_imports_modules_of_hoopgen_by_name() -> None:
    by_name = {
        name
        for name, file in modules().items()
        if re.search(r"\b(import_module|__import__)\(", file.read_text(encoding="utf-8"))
    }
    assert by_name == BY_NAME


def test_the_page_on_the_structure_lists_every_package_and_only_paths_that_exist() -> None:
    page = (ROOT / "docs" / "structure.md").read_text("utf-8")
    roots = (ROOT, ROOT / "derive", ROOT / "hoopgen")
    names = {name.removeprefix("derive.").replace(".", "/") for level in LAYERS for name in level}
    packages = {name for name in names if any((root / name).is_dir() for root in roots[1:])}
    assert packages <= set(re.findall(r"^\| `([\w/]+)` \|", page, re.M))
    paths = [path for path in re.findall(r"`([\w./*]+)`", page) if "/" in path]
    assert [path for path in paths if not any(any(root.glob(path)) for root in roots)] == []


@pytest.mark.parametrize(
    "source",
    [
        "from hoopgen import plots",
        "import hoopgen.plots.fan",
        "from .plots import save",
        "from . import plots",
        "def draw():\n    from .plots.style import save",
        "if TYPE_CHECKING:\n    from .plots import save",
    ],
)
def test_an_import_that_leads_up_is_seen(source: str) -> None:
    known = modules()
    found = {within(each, known) for each in imported(ast.parse(source), "hoopgen")}
    assert {package_of(each) for each in found} == {"plots"}
    assert upward({"hoopgen.simulation.simulate": found})


def test_a_circle_is_seen() -> None:
    lazy = "def said():\n    from .optimum import best"
    found = set(imported(ast.parse(lazy), "hoopgen.study.questions"))
    assert found == {"hoopgen.study.questions.optimum.best"}
    known = modules()
    there = {within(each, known) for each in found}
    assert circle(
        {
            "hoopgen.study.questions.bank": there,
            "hoopgen.study.questions.optimum": {"hoopgen.study.questions.bank"},
        }
    )


def test_no_file_is_long_without_a_reason() -> None:
    files = sorted((ROOT / "hoopgen").rglob("*.py"))
    long = {
        str(file.relative_to(ROOT))
        for file in files
        if len(file.read_text(encoding="utf-8").splitlines()) > LINES
    }
    assert files
    assert long == set(LONG)
