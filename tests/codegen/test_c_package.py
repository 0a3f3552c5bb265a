"""The package of C sources: built by CMake, found by programs, with hoopgen's presets and bits."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from click.testing import CliRunner
from hoopgen.derive.studies import release

import hoopgen
from hoopgen.cli import main
from hoopgen.codegen.c.package import ERRORS, package_files, write_package
from hoopgen.core.variables import STATE
from hoopgen.hoop.releases import RING_HEIGHT
from hoopgen.simulation.engine import Engine
from tests.helpers.compiled import COMPILER, WARNINGS, needs_compiler

EPS = float(np.finfo(np.float64).eps)
GIVEN = {
    "speed": 7.17,
    "elevation": 0.91,
    "azimuth": -0.03,
    "backspin": 17.0,
    "sidespin": -2.5,
    "height": 2.2,
    "distance": 4.3,
    "angle": 0.7,
}

PRESETS = r"""
#include "hoop_tools.h"
#include <stdio.h>
int main(void)
{
    const double *const presets[] = {HOOP_PAPER, HOOP_NBA, HOOP_FIBA};
    for (int k = 0; k < 3; k++)
        for (int p = 0; p < HOOP_PARAMETERS; p++)
            printf("%a\n", presets[k][p]);
    const hoop_release_arguments given = {GIVEN};
    double state[HOOP_STATE];
    hoop_release(&given, state);
    for (int k = 0; k < HOOP_STATE; k++)
        printf("%a\n", state[k]);
    for (int code = 1; code > -16; code--)
        printf("%s\n", hoop_error_text(code));
    printf("%s %d %d ", HOOP_VERSION, HOOP_VERSION_MAJOR, HOOP_VERSION_MINOR);
    printf("%d\n", HOOP_VERSION_PATCH);
    return 0;
}
"""

CONSUMER = """\
cmake_minimum_required(VERSION 3.16)
project(consumer LANGUAGES C)
find_package(hoop {version} REQUIRED)
add_executable(program program.c)
target_link_libraries(program PRIVATE hoop::hoop)
"""


def run(*words: Any, **options: Any) -> str:
    """Return what a command prints, which must succeed."""
    done = subprocess.run(
        [*map(str, words)], capture_output=True, text=True, check=False, timeout=600, **options
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def unpacked(folder: Path) -> Path:
    """Return the folder of the hoop's package, written by the command."""
    file = folder / "hoop-c.zip"
    result = CliRunner().invoke(main, ["compile", "hoop", "--zip", str(file)])
    assert result.exit_code == 0, result.output
    with zipfile.ZipFile(file) as archive:
        archive.extractall(folder)
    return folder / "hoop-c"


@needs_compiler
def test_tools_have_the_presets_the_release_the_texts_and_the_version(tmp_path: Path) -> None:
    package = unpacked(tmp_path)
    given = ", ".join(f".{name} = {value!r}" for name, value in GIVEN.items())
    (tmp_path / "program.c").write_text(PRESETS.replace("GIVEN", given, 1))
    flags = [*WARNINGS, "-std=c11", f"-I{package / 'include'}"]
    run(*COMPILER, *flags, tmp_path / "program.c", "-lm", "-o", tmp_path / "program")
    lines = run(tmp_path / "program").splitlines()
    count = len(hoopgen.PAPER)
    wanted = [*hoopgen.PAPER.values(), *hoopgen.NBA.values(), *hoopgen.FIBA.values()]
    assert [float.fromhex(line) for line in lines[: 3 * count]] == wanted
    state = [float.fromhex(line) for line in lines[3 * count : 3 * count + 9]]
    expected: Any = hoopgen.release(**GIVEN)  # type: ignore[call-overload]
    # Sine and cosine may differ by a rounding, twice in a product.
    np.testing.assert_allclose(state, expected, rtol=4 * EPS, atol=0)
    texts = lines[3 * count + 9 : -1]
    assert texts == ["no error", "unknown code", *ERRORS.values(), "unknown code"]
    version = hoopgen.__version__
    assert lines[-1] == f"{version} {' '.join(re.findall(r'[0-9]+', version)[:3])}"


def test_the_release_in_c_is_the_one_of_python() -> None:
    """Python's own formulas, in NumPy, agree with derive/ at random arguments."""
    steps, state = release.release()
    assert tuple(state) == STATE
    arguments = list(release.ARGUMENTS)
    random = np.random.default_rng(4)
    for _ in range(20):
        numbers = random.uniform(0.1, 1.5, len(arguments))
        values = dict(zip(arguments, map(sp.Float, numbers), strict=True))
        values[release.ring_height] = sp.Float(RING_HEIGHT)
        for symbol, value in steps.items():
            values[symbol] = value.xreplace(values).evalf(30)
        exact = [float(value.xreplace(values).evalf(30)) for value in state.values()]
        given = {symbol.name: number for symbol, number in zip(arguments, numbers, strict=True)}
        found: Any = hoopgen.release(**given)  # type: ignore[call-overload]
        np.testing.assert_allclose(found, exact, rtol=8 * EPS, atol=8 * EPS)


@pytest.mark.parametrize("engine", [hoopgen.HOOP, hoopgen.COURT], ids=["hoop", "court"])
def test_every_error_and_outcome_of_the_header_has_a_text(engine: Engine) -> None:
    files = package_files(engine)
    name = engine.name
    header, tools = (files[f"include/{name}{part}.h"] for part in ("", "_tools"))
    codes = re.findall(rf"{name.upper()}_ERROR_(\w+) = -", header)
    assert codes == list(ERRORS)
    for outcome in engine.outcomes.__members__:
        assert f"case {name.upper()}_OUTCOME_{outcome}:" in tools


def test_the_same_sources_give_the_same_bytes(tmp_path: Path) -> None:
    for file in ("one.zip", "two.zip"):
        write_package(hoopgen.HOOP, tmp_path / file)
    assert (tmp_path / "one.zip").read_bytes() == (tmp_path / "two.zip").read_bytes()


def expected_lines() -> list[str]:
    """Return what the example prints, by hoopgen; the time is in a digest of its bits."""
    n = 1_000_000
    speed = 6.8 + 0.8 * np.arange(n, dtype=float) / n
    states = hoopgen.release(
        speed, 0.9075712110370514, backspin=18.84955592153876, height=2.1336, distance=4.191
    )
    shots = hoopgen.simulate(states, hoopgen.NBA, max_contacts=40, time_limit=60.0)
    names = (outcome.name.lower() for outcome in hoopgen.Outcome)
    counts = [f"{name:8} {(shots.outcome == k).sum()}" for k, name in enumerate(names)]
    return [line for line in counts if not line.endswith(" 0")]


@pytest.mark.slow
@needs_compiler
@pytest.mark.skipif(shutil.which("cmake") is None, reason="no CMake")
@pytest.mark.parametrize("shared", ["OFF", "ON"])
def test_cmake_builds_and_installs_it_and_programs_find_it(tmp_path: Path, shared: str) -> None:
    package, build, prefix = unpacked(tmp_path), tmp_path / "build", tmp_path / "installed"
    options = [f"-DBUILD_SHARED_LIBS={shared}", f"-DCMAKE_INSTALL_PREFIX={prefix}"]
    options += ["-DHOOP_EXAMPLE=ON", "-DCMAKE_C_FLAGS=-DHOOP_WIDEST=4"]  # in less time
    run("cmake", "-S", package, "-B", build, *options)
    run("cmake", "--build", build)
    run("cmake", "--install", build)
    said = {run(build / "share", threads) for threads in (1, 2, 5)}
    assert len(said) == 1  # any number of threads
    *counts, digest = said.pop().splitlines()
    assert counts == expected_lines()
    assert re.fullmatch(r"times    [0-9a-f]{16}", digest)

    own = tmp_path / "consumer"
    own.mkdir()
    (own / "program.c").write_text(PRESETS.replace("GIVEN", ".speed = 7.0", 1))
    (own / "CMakeLists.txt").write_text(CONSUMER.format(version=hoopgen.__version__))
    run("cmake", "-S", own, "-B", own / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", own / "build")
    assert "no error" in run(own / "build" / "program")

    if shutil.which("pkg-config") is not None:
        (folder,) = prefix.glob("lib*/**/pkgconfig")
        environment = os.environ | {"PKG_CONFIG_PATH": str(folder)}
        assert run("pkg-config", "--modversion", "hoop", env=environment).strip() == (
            hoopgen.__version__
        )
        flags = run("pkg-config", "--cflags", "--libs", "--static", "hoop", env=environment).split()
        program = own / "program"
        run(*COMPILER, own / "program.c", *flags, "-o", program)
        (library,) = {flag[2:] for flag in flags if flag.startswith("-L")}
        assert "no error" in run(program, env=os.environ | {"LD_LIBRARY_PATH": library})
