"""The floors of the house: every import leads down, none leads round."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]

FLOORS = (
    {"derive"},
    {"templates"},
    {"generated"},
    # Text, files and what is installed: no physics.
    {"brief", "colours", "files", "installed", "layout", "notebook", "phrases", "printable"},
    {"outputs", "sizes", "units"},
    {"core"},
    {"codegen", "engine", "events", "inputs"},
    # What is given.
    {"parameters", "variables"},
    {"hoop"},
    # What simulates a scene, and how one becomes that.
    {"engines"},
    {"court"},
    {"scene"},
    # In which words it is said.
    {"scenes"},
    {"words"},
    {"told"},
    # What comes of it.
    {"frames"},
    {"results"},
    {"judge"},
    {"simulation"},
    {"invalid"},
    {"paper", "study"},
    {"plots", "viewer"},
    {"studyfile"},
    {"hoopgen"},
    {"cli"},
    {"__main__"},
)
"""Rooms, the lowest first. Those of one floor know nothing of each other."""

UPWARDS = {
    ("hoopgen.engines", "hoopgen.simulation"): "engine.simulate(): leads up when it is called",
    ("hoopgen.engines", "hoopgen.judge"): "engine.certify(): leads up when it is called",
    ("hoopgen.results", "hoopgen.plots"): "shots.plot(): leads up when it is called",
}
"""Every import that may lead up, and why."""

LONG: Mapping[str, str] = {}
"""Files of more than `LINES` lines, and why."""

LINES = 400

Arrows = Mapping[str, set[str]]


def modules() -> dict[str, Path]:
    """Return the files of the house, by the name under which each is imported."""
    found = {}
    for room in ("derive", "generated", "hoopgen"):
        for file in sorted((ROOT / room).rglob("*.py")):
            parts = file.relative_to(ROOT).with_suffix("").parts
            full = parts if room == "hoopgen" else ("hoopgen", *parts)
            found[".".join(full[:-1] if full[-1] == "__init__" else full)] = file
    return found


def imported(tree: ast.AST, package: str) -> Iterator[str]:
    """Yield all that is imported anywhere in a file: in functions, and for types alone, too."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (each.name for each in node.names)
        elif isinstance(node, ast.ImportFrom):
            up = package.split(".")[: 1 - node.level or None] if node.level else []
            where = ".".join([*up, *([node.module] if node.module else [])])
            yield from (f"{where}.{each.name}" for each in node.names)


def within(name: str, known: Mapping[str, Path]) -> str:
    """Return the module that a name imported from it lies in; none if it is not of the house."""
    while name and name not in known:
        name = name.rpartition(".")[0]
    return name


def arrows(known: Mapping[str, Path]) -> dict[str, set[str]]:
    """Return what every module imports of the house."""
    found = {}
    for name, file in known.items():
        package = name if file.name == "__init__.py" else name.rpartition(".")[0]
        tree = ast.parse(file.read_text(encoding="utf-8"))
        found[name] = {within(each, known) for each in imported(tree, package)} - {"", name}
    return found


def room(module: str) -> str:
    return (module.split(".") + ["hoopgen"])[1] if "." in module else module


def floor_of(module: str) -> int:
    (found,) = (level for level, rooms in enumerate(FLOORS) if room(module) in rooms)
    return found


def leading_up(found: Arrows) -> set[tuple[str, str]]:
    """Return the arrows that do not lead down, those within a room left out."""
    return {
        (name, other)
        for name, others in found.items()
        for other in others
        if room(name) != room(other) and floor_of(name) <= floor_of(other)
    }


def circle(found: Arrows) -> list[str]:
    """Return modules that import each other in a circle, or none."""
    try:
        TopologicalSorter(found).prepare()
    except CycleError as error:
        return list(error.args[1])
    return []


HOUSE = arrows(modules())


def test_every_room_has_a_floor() -> None:
    rooms = {room(name) for name in modules()}
    assert rooms | {"templates"} == {each for level in FLOORS for each in level}
    assert len(rooms) + 1 == sum(map(len, FLOORS))


def test_no_import_leads_up() -> None:
    assert leading_up(HOUSE) == set(UPWARDS)


def test_no_imports_lead_round() -> None:
    below = {
        name: {other for other in others if (name, other) not in UPWARDS}
        for name, others in HOUSE.items()
    }
    assert circle(below) == []


def test_what_may_lead_up_is_asked_for_in_one_place() -> None:
    for name, other in UPWARDS:
        tree = ast.parse(modules()[name].read_text(encoding="utf-8"))
        package = name.rpartition(".")[0]
        assert list(imported(tree, package)).count(other) == 1


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
    assert {room(each) for each in found} == {"plots"}
    assert leading_up({"hoopgen.simulation": found})


def test_a_circle_is_seen() -> None:
    lazy = "def said():\n    from .optimum import best"
    found = set(imported(ast.parse(lazy), "hoopgen.study"))
    assert found == {"hoopgen.study.optimum.best"}
    known = modules()
    there = {within(each, known) for each in found}
    assert circle({"hoopgen.study.bank": there, "hoopgen.study.optimum": {"hoopgen.study.bank"}})


def test_no_file_is_long_without_a_reason() -> None:
    files = sorted((ROOT / "hoopgen").rglob("*.py"))
    long = {
        str(file.relative_to(ROOT))
        for file in files
        if len(file.read_text(encoding="utf-8").splitlines()) > LINES
    }
    assert files
    assert long == set(LONG)
