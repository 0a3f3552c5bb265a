"""Type checkers see the type of every public name."""

from __future__ import annotations

import ast
import importlib
import inspect
import operator
import os
import re
import subprocess
import sys
import textwrap
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from types import ModuleType

import pytest

import hoopgen
from hoopgen.results.drawing import EstimateOptions, FanOptions, TrajectoryOptions
from tests.helpers import ROOT

pytest.importorskip("mypy")
pytest.importorskip("matplotlib")
pytest.importorskip("flint")

from hoopgen.judge import CertificationOptions
from hoopgen.simulation.run import SimulationOptions, run

PUBLIC = sorted(name for name in dir(hoopgen) if not name.startswith("_"))


OPERATORS = {"__call__", "__contains__", "__getitem__", "__iter__", "__len__", "__or__", "__ror__"}

STUBS = """
from typing import Any
class {name}:
    def __getattr__(self, name: str) -> Any: ...
def __getattr__(name: str) -> Any: ...
"""
"""Stubs of packages without types of their own, so that their names have types."""

HEAD = """
from typing import TypeVar
import hoopgen
from numpy.typing import ArrayLike
T = TypeVar("T")
def instance(cls: type[T]) -> T: raise NotImplementedError
def array(values: ArrayLike) -> None: ...
"""


def members(cls: type) -> set[str]:
    """Return the public attributes of instances of a class, those that methods assign, too."""
    found: set[str] = set()
    for base in cls.__mro__:
        if base.__module__.startswith("hoopgen."):
            tree = ast.parse(textwrap.dedent(inspect.getsource(base)))
            assigned = (
                node.attr
                for node in ast.walk(tree)
                if isinstance(node, ast.Attribute)
                and isinstance(node.ctx, ast.Store)
                and ast.unparse(node.value) == "self"
            )
            found |= {*vars(base), *vars(base).get("__annotations__", {}), *assigned}
    return {name for name in found if not name.startswith("_") or name in OPERATORS}


def public() -> dict[str, str]:
    """Return an expression of each public name, and of each attribute of its class, by name."""
    found = {name: f"hoopgen.{name}" for name in PUBLIC}
    for room in hoopgen._SUBMODULES:
        found |= {f"{room}.{name}": f"hoopgen.{room}.{name}" for name in _module(room).__all__}
    for name, expression in list(found.items()):
        value = operator.attrgetter(name)(hoopgen)
        if inspect.isclass(value) and value.__module__.startswith("hoopgen.generated."):
            continue  # outcomes and events: members of an enumeration
        if inspect.isclass(value):
            found |= {f"{name}.{one}": f"instance({expression}).{one}" for one in members(value)}
        elif type(value).__module__.startswith("hoopgen."):
            found |= {f"{name}.{one}": f"{expression}.{one}" for one in members(type(value))}
    return found


@cache
def expressions() -> dict[str, str]:
    """Return what mypy is asked about, by name: all that is public, and what is no name of it."""
    return {
        **public(),
        "no_such_name": "hoopgen.no_such_name",
        "Shots.no_such_name": "instance(hoopgen.Shots).no_such_name",
        "ArrayLike": "array",
    }


def _module(room: str) -> ModuleType:
    return importlib.import_module(f"hoopgen.{room}")


@pytest.fixture(scope="module")
def revealed(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Return what mypy says of each expression, by its name."""
    folder = tmp_path_factory.mktemp("types")
    lines = [*HEAD.splitlines(), *(f"reveal_type({one})" for one in expressions().values())]
    (file := folder / "names.py").write_text("\n".join(lines) + "\n")
    # The installed names over the sources, as `make lint` has them.
    (rooms := folder / "typing" / "hoopgen").mkdir(parents=True)
    for room in ("derive", "generated", "templates"):
        (rooms / room).symlink_to(ROOT / room)
    for package, name in (("pandas", "DataFrame"), ("pyarrow", "Table")):
        (stub := rooms.parent / package).mkdir()
        (stub / "__init__.pyi").write_text(STUBS.format(name=name))
    command = [sys.executable, "-m", "mypy", "--config-file", str(ROOT / "pyproject.toml")]
    answer = subprocess.run(
        [*command, "--cache-dir", str(folder / "cache"), "--follow-imports=silent", str(file)],
        cwd=ROOT,
        env=os.environ | {"MYPYPATH": str(rooms.parent)},
        capture_output=True,
        text=True,
        check=False,
    ).stdout
    said = re.findall(r"names\.py:(\d+): (?:note: Revealed type is )?(.*)$", answer, re.M)
    names = list(expressions())
    first = len(HEAD.splitlines()) + 1
    said.sort(key=lambda found: not found[1].startswith("error:"))  # of a line with one, that
    return {names[int(line) - first]: text for line, text in reversed(said)}


def with_any(revealed: Mapping[str, str]) -> dict[str, str]:
    """Return the types that have an Any, but for those of NumPy's ArrayLike and of shapes."""
    (array,) = re.findall(r"^\"def \(values: (.*)\)\"$", revealed["ArrayLike"])
    plain = {
        name: text.replace(array, "ArrayLike").replace("tuple[Any, ...]", "Shape")
        for name, text in revealed.items()
    }
    return {name: text for name, text in plain.items() if re.search(r"\bAny\b", text)}


@pytest.mark.slow
def test_every_public_name_has_a_type_of_its_own(revealed: dict[str, str]) -> None:
    assert set(revealed) == set(expressions())
    assert {"HOOP.simulate", "Shots.events", "Scatter.draw", "plots.plot_fan"} <= set(revealed)
    wrong = {name: text for name, text in revealed.items() if text.startswith("error:")}
    assert set(wrong) == {"no_such_name", "Shots.no_such_name"}


@pytest.mark.slow
def test_no_public_signature_has_an_any(revealed: dict[str, str]) -> None:
    assert with_any(revealed) == {}


@pytest.mark.slow
def test_an_any_in_a_signature_is_seen(revealed: dict[str, str]) -> None:
    text = revealed["HOOP.simulate"]
    for change in (text.replace("Shots", "Any"), text.replace("numpy.float64", "Any"), '"Any"'):
        found = with_any(revealed | {"changed": change})
        assert set(found) == ({"changed"} if change != text else set())
    assert "hoopgen.results.shots.Shots" in text


@pytest.mark.slow
def test_results_of_an_engine_have_their_types(revealed: dict[str, str]) -> None:
    returned = {
        "HOOP.simulate": "hoopgen.results.shots.Shots",
        "COURT.certify": "hoopgen.judge.certificate.Certificate",
        "compile": "hoopgen.simulation.engine.Engine",
        "Shots.to_pandas": "pandas.DataFrame",
        "Shots.events_to_arrow": "pyarrow.Table",
        "Shots.to_xarray": "xarray.core.dataset.Dataset",
    }
    assert {name: revealed[name].rpartition("-> ")[2].strip('"') for name in returned} == returned
    assert revealed["HOOP"] == '"hoopgen.simulation.engine.Engine"'
    assert revealed["NBA.__getitem__"] == '"def (str) -> float"'


@pytest.mark.parametrize(
    ("options", "function", "apart"),
    [
        (SimulationOptions, hoopgen.simulate, {"scene"}),
        (SimulationOptions, run, set()),
        (CertificationOptions, hoopgen.certify, {"scene"}),
        (EstimateOptions, hoopgen.plots.plot_estimate, {"ax"}),
        (FanOptions, hoopgen.plots.plot_fan, {"ax"}),
        (TrajectoryOptions, hoopgen.plots.plot_trajectory, {"ax"}),
    ],
)
def test_typed_options_are_the_keywords_of_the_function(
    options: type, function: Callable[..., object], apart: set[str]
) -> None:
    parameters = inspect.signature(function).parameters.values()
    keywords = {one.name for one in parameters if one.kind is one.KEYWORD_ONLY}
    assert set(options.__annotations__) == keywords - apart


@pytest.mark.slow
def test_a_misspelt_name_is_an_error_of_the_type_checker(revealed: dict[str, str]) -> None:
    assert "has no attribute" in revealed["no_such_name"]
    assert "has no attribute" in revealed["Shots.no_such_name"]


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
