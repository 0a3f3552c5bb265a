"""Installation: what is installed and where, and that a missing compiler or extra costs nothing."""

import ctypes
import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import zipfile
from importlib.metadata import distribution
from pathlib import Path

import pytest

from tests.helpers import ROOT

ROOMS = ("derive", "generated", "templates")
FILES = ("LICENSE", "MANIFEST.in", "README.md", "pyproject.toml", "setup.py")
NOT_SHIPPED = shutil.ignore_patterns("__pycache__", "*.py[cod]", "*.so", "*.pyd", "*.dylib")
PLATFORM = f"{sysconfig.get_platform()}-{sys.implementation.cache_tag}"
COMMAND = (os.environ.get("CC") or sysconfig.get_config_var("CC") or "cl").split()
COMPILER = COMMAND[0]

# One worker: the wheels are built once.
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("packaging")]


def run(*command: str | Path, cwd: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    result = subprocess.run(
        command,
        cwd=cwd,
        env=os.environ | environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
    )
    assert result.returncode == 0, result.stdout + result.stderr
    return result


def python(code: str, cwd: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    return run(sys.executable, "-c", code, cwd=cwd, **environment)


def copy_sources(to: Path) -> Path:
    for folder in ("hoopgen", *ROOMS):
        shutil.copytree(ROOT / folder, to / folder, ignore=NOT_SHIPPED)
    for name in FILES:
        shutil.copy(ROOT / name, to)
    return to


def build_wheel(source: Path, to: Path, **environment: str) -> Path:
    options = ("--no-build-isolation", "--no-deps", "--no-index", "--wheel-dir", to)
    run(sys.executable, "-m", "pip", "wheel", *options, source, cwd=to, **environment)
    (wheel,) = to.glob("*.whl")
    return wheel


def unpack(wheel: Path, to: Path) -> Path:
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(to)
    return to


def names(unpacked: Path) -> set[str]:
    return {p.relative_to(unpacked).as_posix() for p in unpacked.rglob("*") if p.is_file()}


def libraries(unpacked: Path) -> list[Path]:
    return [p for p in unpacked.rglob("*") if p.suffix in {".so", ".pyd", ".dylib", ".dll"}]


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build a wheel as an index would: from the source distribution."""
    source = copy_sources(tmp_path_factory.mktemp("source"))
    out = tmp_path_factory.mktemp("out")
    python(f"from setuptools import build_meta; build_meta.build_sdist({str(out)!r})", cwd=source)
    (sdist,) = out.glob("*.tar.gz")
    return unpack(build_wheel(sdist, out), tmp_path_factory.mktemp("installed"))


@pytest.fixture(scope="module")
def installed_without_compiler(tmp_path_factory: pytest.TempPathFactory) -> Path:
    source = copy_sources(tmp_path_factory.mktemp("source"))
    wheel = build_wheel(source, tmp_path_factory.mktemp("out"), CC="/bin/false", CXX="/bin/false")
    return unpack(wheel, tmp_path_factory.mktemp("installed"))


def expected_names(tmp_path: Path) -> set[str]:
    """Every source file under the name it is installed by."""
    paths = names(copy_sources(tmp_path)) - set(FILES)
    return {p if p.startswith("hoopgen/") else f"hoopgen/{p}" for p in paths}


def test_wheel_holds_every_source_under_hoopgen_and_nothing_else(
    installed: Path, tmp_path: Path
) -> None:
    built = {p.relative_to(installed).as_posix() for p in libraries(installed)}
    found = {p for p in names(installed) - built if ".dist-info/" not in p}
    assert found == expected_names(tmp_path)
    assert "hoopgen/py.typed" in found


def test_wheel_without_compiler_is_the_same_less_the_library(
    installed_without_compiler: Path, tmp_path: Path
) -> None:
    assert libraries(installed_without_compiler) == []
    found = {p for p in names(installed_without_compiler) if ".dist-info/" not in p}
    assert found == expected_names(tmp_path)


@pytest.mark.skipif(shutil.which(COMPILER) is None, reason="no C compiler")
def test_wheel_with_compiler_holds_a_library_of_each_scene_for_ctypes(installed: Path) -> None:
    names = ("_court", "_elementary", "_hoop")
    for library, name in zip(sorted(libraries(installed)), names, strict=True):
        assert library.parent == installed / "hoopgen" / "engine"
        assert library.name == f"{name}.so"
        assert not hasattr(ctypes.CDLL(str(library)), f"PyInit_{name}")


@pytest.mark.skipif(shutil.which(COMPILER) is None, reason="no C compiler")
def test_one_wheel_serves_every_python_of_a_platform(installed: Path, tmp_path: Path) -> None:
    """No name in the wheel, and no symbol in a library, is one interpreter's."""
    (tags,) = (file.read_text() for file in installed.glob("*.dist-info/WHEEL"))
    (tag,) = (line for line in tags.splitlines() if line.startswith("Tag: "))
    assert tag.startswith("Tag: py3-none-")
    assert not tag.endswith("-any")
    for library in libraries(installed):
        assert not re.search(rb"\bPy[A-Z_]", library.read_bytes())
    code = "import hoopgen; print(hoopgen.HOOP.backend, hoopgen.COURT.backend)"
    # Without a compiler on the path.
    found = python(code, tmp_path, PYTHONPATH=str(installed), PATH="", HOME=str(tmp_path))
    assert found.stdout.split() == ["c", "c"]


@pytest.mark.skipif(os.name == "nt" or shutil.which(COMPILER) is None, reason="no C compiler")
def test_a_second_installation_from_a_checkout_compiles_nothing(tmp_path: Path) -> None:
    """`make paper` and then `pip install '.[study]'` took two minutes of compiling each."""
    source, log = copy_sources(tmp_path / "source"), tmp_path / "log"
    for other in ("court", "elementary"):
        (source / "generated" / "c" / f"{other}.c").unlink()
    compiler = tmp_path / "cc"
    narrow = "-DHOOP_WIDEST=1 -O0"  # compiles in a second
    compiler.write_text(f'#!/bin/sh\necho "$@" >>{log}\nexec {shlex.join(COMMAND)} "$@" {narrow}\n')
    compiler.chmod(0o755)
    plain = {"CC": str(compiler), "CFLAGS": "", "CPPFLAGS": "", "LDFLAGS": ""}

    def compile_engine(leave: bool = False) -> tuple[dict[str, bytes], int]:
        """Return the library of a wheel, by its name, and how many files were compiled for it."""
        log.write_text("")
        (out := tmp_path / "out").mkdir()
        unpacked = unpack(build_wheel(source, out, **plain), out)
        if not leave:  # as after an editable installation, which leaves no such folder
            shutil.rmtree(source / "build" / f"lib.{PLATFORM}")
        found = {library.name: library.read_bytes() for library in libraries(unpacked)}
        shutil.rmtree(out)
        return found, sum(" -c " in f" {line} " for line in log.read_text().splitlines())

    first, compiled = compile_engine()
    assert (len(first), compiled) == (1, 1)
    assert compile_engine() == (first, 0)

    # Other sources, another compiler and flags of the user's own are compiled.
    with (source / "generated" / "c" / "hoop.c").open("a") as file:
        file.write("/* changed */\n")
    assert compile_engine()[1] == 1
    version = f'#!/bin/sh\n[ "$1" = --version ] && echo newer && exit\n{compiler.read_text()}'
    compiler.write_text(version)
    assert compile_engine(leave=True)[1] == 1
    compiler.write_text(version.replace("newer", "newest"))
    assert compile_engine()[1] == 1, "the library that was left is of another compiler"
    plain["CFLAGS"] = "-DANYTHING"
    assert compile_engine()[1] == 1


def test_without_the_library_numpy_serves_and_one_line_says_so(
    installed_without_compiler: Path, tmp_path: Path
) -> None:
    # Table 3, case 5a, twice: what is said is said once.
    code = """
import warnings
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    import hoopgen
    states = [[2.4384, 0, -0.6096, -2.8956, 0, 4.8768, 0, 0, 0]]
    for _ in range(2):
        shots = hoopgen.simulate(states, parameters=hoopgen.PAPER, backend="auto")
import sys
for warning in caught:
    print(warning.message, file=sys.stderr)
print(hoopgen.__file__)
print(hoopgen.Outcome(shots.outcome[0]).name)
"""
    result = python(code, cwd=tmp_path, PYTHONPATH=str(installed_without_compiler))
    where, outcome = result.stdout.splitlines()
    assert installed_without_compiler in Path(where).parents
    assert outcome == "MADE"
    (line,) = result.stderr.splitlines()
    assert "NumPy" in line


def test_importing_hoopgen_loads_only_what_running_needs(tmp_path: Path) -> None:
    optional = "click dask flint jinja2 matplotlib mpmath pandas pyarrow scipy sympy xarray"
    code = f"import sys, hoopgen; print(*sorted(set({optional.split()}) & set(sys.modules)))"
    assert python(code, cwd=tmp_path).stdout.split() == []


def test_the_development_install_is_the_live_tree(tmp_path: Path) -> None:
    code = """
import hoopgen, hoopgen.derive, hoopgen.generated, hoopgen.templates
for package in (hoopgen, hoopgen.derive, hoopgen.generated, hoopgen.templates):
    print(package.__path__[0])
"""
    found = [Path(line) for line in python(code, cwd=tmp_path).stdout.splitlines()]
    assert found == [ROOT / "hoopgen", *(ROOT / room for room in ROOMS)]


@pytest.mark.parametrize("name", ["benchmarks", *ROOMS, "tests"])
def test_no_bare_name_is_installed(name: str, tmp_path: Path) -> None:
    code = f"import importlib.util; print(importlib.util.find_spec({name!r}))"
    assert python(code, cwd=tmp_path).stdout.strip() == "None"


def test_running_needs_numpy_and_click_alone() -> None:
    requirements = distribution("hoopgen").requires or []
    needed = {r.split(">")[0] for r in requirements if "extra ==" not in r}
    assert needed == {"numpy", "click"}
