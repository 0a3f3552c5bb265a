"""The C engine is used once it has shown that it can be: flags, stale builds, odd threads."""

from __future__ import annotations

import os
import platform
import shutil
import stat
import subprocess
import sys
import types
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hoopgen.generated.numpy import hoop

import hoopgen
from hoopgen.core import validation
from hoopgen.engine import arithmetic, c_build, native, verification
from hoopgen.simulation import backend_choice
from hoopgen.simulation import run as run_module
from hoopgen.simulation.hoop import HOOP, hoop_library, hoop_shots
from tests.helpers import ROOT, flags
from tests.helpers.compiled import needs_compiler, shared_library
from tests.helpers.environment import in_a_thread, linux_on_x86

SHOTS = hoop_shots()
FREE_THROW = [4.191, 0, -0.6096, -4.5, 0, 5.577, 0, 18.85, 0]
MACHINE = platform.machine()
FUSES = "-mfma " if MACHINE in ("x86_64", "AMD64") else ""
"""A processor's a*b + c in one operation; elsewhere compilers may take it without being told."""

# ------------------------------------------------------------------------------------------ flags

EVERY = (
    "-Ofast -ffast-math -funsafe-math-optimizations -fassociative-math -fno-signed-zeros "
    "-fno-trapping-math -freciprocal-math -ffinite-math-only -ffp-contract=fast"
)
OWN = {"gcc": "", "clang": "-ffp-model=fast -ffp-contract=fast -fno-honor-infinities"}
ADMITTED = {
    "gcc": (
        "-Ofast",
        "-ffast-math",
        "-funsafe-math-optimizations",
        "-fassociative-math -fno-signed-zeros -fno-trapping-math",
        "-freciprocal-math",
        "-ffinite-math-only",
        "-fno-signed-zeros",
        "-fsingle-precision-constant",
    ),
    "clang": ("-Ofast", "-ffast-math", "-ffinite-math-only", "-ffp-model=fast"),
}


def needs(compiler: str) -> None:
    if compiler not in flags.COMPILERS:
        pytest.skip(f"{compiler} is not installed")


@pytest.mark.parametrize("compiler", OWN)
@pytest.mark.slow
def test_setup_takes_back_every_flag_of_the_environment(compiler: str) -> None:
    needs(compiler)
    given = f"{FUSES}{EVERY} {OWN[compiler]}"
    verdict = flags.try_flags(compiler, given, link=given, widest=4)
    assert verdict == flags.Verdict("same", "")


@pytest.mark.parametrize(
    ("compiler", "flag"), [(c, flag) for c in ADMITTED for flag in ADMITTED[c]]
)
@pytest.mark.sampled(1)
def test_what_a_compiler_admits_to_does_not_compile(compiler: str, flag: str) -> None:
    needs(compiler)
    verdict = flags.try_flags(compiler, f"-fsyntax-only {flag}", ours=False, widest=1)
    assert verdict.kind == "refused"
    assert "compile without" in verdict.said


@pytest.mark.slow
@pytest.mark.parametrize("flag", [f"{FUSES}-ffp-contract=fast", "-freciprocal-math"])
def test_what_clang_does_not_admit_to_does_not_run(flag: str) -> None:
    needs("clang")
    verdict = flags.try_flags("clang", f"-O1 {flag}", ours=False, widest=1)
    assert verdict.kind == "found"
    assert "width 1: arithmetic" in verdict.said


@pytest.mark.slow
def test_a_library_that_runs_and_gives_other_bits_is_found() -> None:
    """The C file itself cannot notice that there is no infinity."""
    needs("clang")
    verdict = flags.try_flags("clang", "-O1 -fno-honor-infinities", ours=False, widest=1)
    assert verdict.kind == "found"
    assert "width 1: outcome, " in verdict.said


@pytest.mark.parametrize("compiler", OWN)
@pytest.mark.slow
def test_compiled_by_hand_nothing_is_contracted(compiler: str) -> None:
    """The C file forbids contraction itself, without a flag, on a processor that could contract."""
    needs(compiler)
    given = f"-O1 -std=gnu11 -fno-math-errno {FUSES}"
    verdict = flags.try_flags(compiler, given, ours=False, widest=1)
    assert verdict == flags.Verdict("same", "")


@needs_compiler
@linux_on_x86
def test_a_library_that_changes_the_process_is_not_used(tmp_path: Path) -> None:
    """Linking with -ffast-math makes such a library, before GCC 13."""
    source = tmp_path / "flushing.c"
    source.write_text(
        "#include <xmmintrin.h>\n"
        "__attribute__((constructor)) static void set(void)\n"
        "{ _mm_setcsr(_mm_getcsr() | 0x8040); }\n"
        "int hoop_share(void);\nint hoop_share(void) { return 0; }\n",
        encoding="utf-8",
    )
    library = shared_library(source)
    found = in_a_thread(lambda: hoop_library(library))
    assert isinstance(found, native.Rejection)
    assert "makes subnormals zero in this process" in found.reason


@needs_compiler
@linux_on_x86
@pytest.mark.slow
def test_a_library_for_another_processor_says_that_one_lane_serves(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Moved from a processor with 8 lanes to one that has only those that each x86 has."""
    folder = tmp_path / "c"
    shutil.copytree(ROOT / "generated" / "c", folder)
    source = folder / "hoop.c"
    moved = ["-O0", "-w", "-DHOOP_NATIVE=8", "-D__builtin_cpu_supports(x)=0"]
    found = native.Library(shared_library(source, *moved), hoop)
    assert found.missing_width == 8
    assert verification.available_widths(found, hoop) == [1]
    monkeypatch.setattr(HOOP, "found", found)
    backend_choice._warn_of_one_lane.cache_clear()
    for _ in range(2):
        assert hoopgen.simulate(FREE_THROW).outcome[0] == hoopgen.Outcome.MISSED
    assert capsys.readouterr().err == (
        "hoopgen: the C engine of hoop was compiled for a processor with 8 lanes, which this one "
        "has not. One lane serves, slower; install hoopgen again on this machine.\n"
    )
    backend_choice._warn_of_one_lane.cache_clear()


def test_the_installed_library_is_for_this_processor() -> None:
    if HOOP.library is None:
        pytest.skip("the C engine was not built")
    assert HOOP.library.missing_width == 0


# ---------------------------------------------------------------------------------------- threads


def test_this_thread_computes_as_it_should() -> None:
    assert arithmetic.is_exact()


@pytest.mark.parametrize(("asked", "taken"), [(1, 1), (3, 3), (20, 20), (21, 20), (2000, 20)])
def test_threads_that_would_only_crowd_are_not_started(
    asked: int, taken: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: set(range(5)), raising=False)
    assert validation.check_threads(asked) == taken
    assert validation.check_threads(None) == 5


def test_in_numpy_no_thread_takes_few_shots(monkeypatch: pytest.MonkeyPatch) -> None:
    sizes = []
    run = run_module.numpy_backend.run

    def counted(kernels: Any, states: Any, *rest: Any, **options: Any) -> None:
        sizes.append(len(states))
        run(kernels, states, *rest, **options)

    monkeypatch.setattr(run_module.numpy_backend, "run", counted)
    hoopgen.simulate(np.tile(FREE_THROW, (10_000, 1)), backend="numpy", threads=8)
    assert sorted(sizes) == [
        10_000 - 2 * run_module.MIN_SHOTS_PER_THREAD,
        run_module.MIN_SHOTS_PER_THREAD,
        run_module.MIN_SHOTS_PER_THREAD,
    ]


# ----------------------------------------------------------------------------------------- stamps


class Counted:
    """The installed engine; counts its runs, and can be made to err."""

    def __init__(self, wrong: str = "", width: int = 0) -> None:
        self.runs, self.wrong, self.width = 0, wrong, width

    def run(self, *arguments: Any, **options: Any) -> None:
        library = HOOP.library
        assert library is not None
        library.run(*arguments, **options)
        states, _, _, _, out, _, width = arguments
        self.runs += len(states) > 0
        if (
            self.wrong
            and width == self.width
            and getattr(out, self.wrong) is not None
            and len(states)
        ):
            array = getattr(out, self.wrong)
            row = array[7:8]
            row.view(np.uint8)[...] ^= 1


@pytest.fixture
def library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A file in the place of the library, and a home of one's own."""
    if HOOP.library is None:
        pytest.skip("the C engine was not built")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    path = tmp_path / "engine" / "_hoop.so"
    path.parent.mkdir()
    path.write_bytes(b"a library")
    return path


def compared(library: Path) -> bool:
    """Return whether loading compares anything."""
    engine = Counted()
    assert verification.verify(library, engine, hoop, SHOTS) == ""
    return engine.runs > 0


def stamp_of(library: Path) -> Path:
    (stamp,) = (library.parent / "__pycache__").iterdir()
    return stamp


@pytest.mark.slow
def test_what_has_been_compared_is_not_compared_again(library: Path) -> None:
    assert [compared(library) for _ in range(3)] == [True, False, False]


@pytest.mark.slow
@pytest.mark.parametrize("text", [b"", b"yes\n", b"\xff\xfe", b"0" * 64])
def test_a_stamp_that_says_something_else_is_none(library: Path, text: bytes) -> None:
    assert compared(library)
    stamp_of(library).write_bytes(text)
    assert [compared(library) for _ in range(2)] == [True, False]


@pytest.mark.slow
def test_a_stamp_that_cannot_be_read_is_none(library: Path) -> None:
    assert compared(library)
    stamp = stamp_of(library)
    stamp.unlink()
    stamp.mkdir()
    assert compared(library)


@pytest.mark.slow
def test_another_library_numpy_or_source_is_compared_again(
    library: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    assert compared(library)
    monkeypatch.setattr(np, "__version__", "9.9")
    assert [compared(library) for _ in range(2)] == [True, False]
    library.write_bytes(b"another library")
    assert [compared(library) for _ in range(2)] == [True, False]
    kernels = tmp_path / "hoop.py"
    kernels.write_bytes(Path(hoop.__file__).read_bytes() + b"\n# edited\n")
    monkeypatch.setattr(hoop, "__file__", str(kernels))
    assert [compared(library) for _ in range(2)] == [True, False]


@pytest.mark.slow
def test_without_a_place_beside_the_library_the_users_cache_has_the_stamp(
    library: Path, tmp_path: Path
) -> None:
    (library.parent / "__pycache__").write_bytes(b"in the way")
    assert [compared(library) for _ in range(2)] == [True, False]
    cache = tmp_path / "cache" / "hoopgen"
    assert [file.suffix for file in cache.iterdir()] == [".checked"]
    if os.name == "posix":
        assert stat.S_IMODE(cache.stat().st_mode) == 0o700


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="permissions are POSIX's")
def test_a_cache_that_others_write_to_is_not_used(library: Path, tmp_path: Path) -> None:
    (library.parent / "__pycache__").write_bytes(b"in the way")
    cache = tmp_path / "cache" / "hoopgen"
    cache.mkdir(parents=True)
    cache.chmod(0o777)
    assert [compared(library) for _ in range(2)] == [True, True]
    assert list(cache.iterdir()) == []


@pytest.mark.sampled(1)
@pytest.mark.skipif(os.name != "posix", reason="permissions are POSIX's")
@pytest.mark.parametrize("above", ["cache", "."])
def test_nor_is_one_below_a_folder_that_others_write_to(
    library: Path, tmp_path: Path, above: str
) -> None:
    """They could put a cache of their own in its place, and a verdict into it."""
    (library.parent / "__pycache__").write_bytes(b"in the way")
    assert [compared(library) for _ in range(2)] == [True, False]
    (tmp_path / above).chmod(0o777)
    assert compared(library)
    (tmp_path / above).chmod(0o700)
    assert not compared(library)


@pytest.mark.sampled(1)
@pytest.mark.parametrize("place", [0, 1, 31, 63])
def test_a_stamp_with_a_wrong_bit_is_none(library: Path, place: int) -> None:
    assert compared(library)
    content = bytearray(stamp_of(library).read_bytes())
    content[place] ^= 1 << place % 8
    stamp_of(library).write_bytes(content)
    assert [compared(library) for _ in range(2)] == [True, False]


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="there are no pipes")
def test_a_pipe_in_the_place_of_a_stamp_is_not_waited_for(library: Path) -> None:
    assert compared(library)
    stamp = stamp_of(library)
    stamp.unlink()
    os.mkfifo(stamp)
    assert [compared(library) for _ in range(2)] == [True, False]


@pytest.mark.sampled(1)
@pytest.mark.parametrize(
    "field",
    ["outcome", "contacts", "counts", "first", "time", "state", "uncertain"]
    + ["time_error", "state_error", "event_counts", "events"],
)
def test_one_wrong_bit_of_one_field_is_found_and_not_stamped(library: Path, field: str) -> None:
    """In the widest vectors of the installed build, whichever widths that has."""
    assert HOOP.library is not None
    width = verification.available_widths(HOOP.library, hoop)[-1]
    found = verification.verify(library, Counted(field, width=width), hoop, SHOTS)
    assert found.startswith(f"width {width}: ")
    assert field in found
    assert not (library.parent / "__pycache__").exists()


@pytest.mark.slow
def test_the_shots_compared_show_every_outcome_surface_and_flag() -> None:
    engine, seen = Counted(), []
    if HOOP.library is None:
        pytest.skip("the C engine was not built")
    run = engine.run

    def kept(*arguments: Any, **options: Any) -> None:
        run(*arguments, **options)
        seen.append(arguments[4])

    engine.run = kept  # type: ignore[method-assign]
    assert verification.differences(engine, hoop, verification.expected(hoop, SHOTS)) == ""
    whole = [out for out in seen if out.uncertain is not None]
    outcomes = np.concatenate([out.outcome for out in whole])
    assert set(outcomes) == set(hoopgen.Outcome) - {hoopgen.Outcome.LODGED}
    assert np.all(np.sum([out.counts.clip(0).sum(axis=0) for out in whole], axis=0) > 100)
    assert 0 < np.concatenate([out.uncertain for out in whole]).sum() < len(outcomes)
    assert len(whole[0].outcome) > 300


# -------------------------------------------------------------------------------- the whole of it

TELL = """
import sys, hoopgen
states = [4.191, 0, -0.6096, -4.5, 0, 5.577, 0, 18.85, 0]
for _ in range(2):
    assert hoopgen.simulate(states).outcome[0] == hoopgen.Outcome.MISSED
try:
    hoopgen.simulate(states, backend="c")
except RuntimeError as error:
    print(error)
else:
    print("used")
"""


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """hoopgen as it is installed, in a folder of its own."""
    if HOOP.library is None:
        pytest.skip("the C engine was not built")
    ignored = shutil.ignore_patterns("__pycache__")
    shutil.copytree(ROOT / "hoopgen", tmp_path / "hoopgen", ignore=ignored)
    for room in ("generated", "derive", "templates"):
        shutil.copytree(ROOT / room, tmp_path / "hoopgen" / room, ignore=ignored)
    return tmp_path


def told(package: Path) -> tuple[str, str]:
    """Return what a new process says of the C engine: to who asks for it, and to who does not."""
    result = subprocess.run(
        [sys.executable, "-c", TELL],
        cwd=package,
        env=os.environ | {"PYTHONPATH": str(package), "XDG_CACHE_HOME": str(package / "cache")},
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert result.returncode == 0, result.stderr
    return result.stdout.strip(), result.stderr.strip()


@pytest.mark.slow
def test_a_library_of_other_sources_is_not_used_and_one_line_says_so(package: Path) -> None:
    assert told(package) == ("used", "")
    engine = package / "hoopgen" / "generated" / "c" / "hoop_engine.h"
    engine.write_text(engine.read_text(encoding="utf-8") + "\n", encoding="utf-8")
    error, line = told(package)
    what = "was built from other sources than these; `pip install -e .` again"
    assert error == f"backend: 'c' {what}, or use 'numpy'"
    assert line == f"hoopgen: the C engine {what}. NumPy serves, slower."


@pytest.mark.slow
def test_a_library_that_differs_from_numpy_is_not_used_and_one_line_says_so(package: Path) -> None:
    assert told(package) == ("used", "")  # and there is a stamp, of the kernels as they were
    kernels = package / "hoopgen" / "generated" / "numpy" / "hoop.py"
    text = kernels.read_text(encoding="utf-8")  # the impact, and its errors
    edited = text.replace("_scalar(0.6)", "_scalar(0.6000000000000001)")
    assert edited != text
    kernels.write_text(edited, encoding="utf-8")
    error, line = told(package)
    assert error.startswith("backend: 'c' does not give NumPy's results (width 1: time, state, ")
    assert error.endswith("; install again without CFLAGS and LDFLAGS of your own, or use 'numpy'")
    assert len(line.splitlines()) == 1
    assert line.startswith("hoopgen: the C engine does not give NumPy's results (width 1: time, ")


def test_the_word_for_sources_is_of_the_names_and_bytes_of_what_is_compiled(tmp_path: Path) -> None:
    assert c_build.source_digest(tmp_path, "a") == ""
    (tmp_path / "a.c").write_bytes(b"int a;")
    (tmp_path / "other.h").write_bytes(b"int other;")
    first = c_build.source_digest(tmp_path, "a")
    assert first.isidentifier()
    (tmp_path / "b.c").write_bytes(b"int b;")
    assert c_build.source_digest(tmp_path, "a") == first
    (tmp_path / "a.c").write_bytes(b"int b;")
    second = c_build.source_digest(tmp_path, "a")
    (tmp_path / "a.c").write_bytes(b'#include "shared.h"\n#include <float.h>\n')
    found = [first, second, c_build.source_digest(tmp_path, "a")]
    for text in (b'#include "further.h"', b"int c;"):
        (tmp_path / "shared.h").write_bytes(text)
        found.append(c_build.source_digest(tmp_path, "a"))
    (tmp_path / "shared.h").write_bytes(b'#include "further.h"')
    (tmp_path / "further.h").write_bytes(b"int d;")
    found.append(c_build.source_digest(tmp_path, "a"))
    assert len(set(found)) == 6


def test_of_numbers_that_are_none_neither_sign_nor_rest_is_compared() -> None:
    """IEEE 754 leaves them open; the sign of a zero, and any other bit, it does not."""
    numbers = np.array([1.0, np.nan, 0.0])
    assert verification._have_same_bits(numbers, np.array([1.0, -np.nan, 0.0]))
    assert not verification._have_same_bits(numbers, np.array([1.0, np.nan, -0.0]))
    assert not verification._have_same_bits(numbers, np.array([1.0 + 2.0**-52, np.nan, 0.0]))
    assert not verification._have_same_bits(numbers, np.array([np.nan, np.nan, 0.0]))
    assert not verification._have_same_bits(np.array([1, 2]), np.array([1, 3]))


def test_shots_compared_leave_surfaces_that_there_are() -> None:
    """One byte says which: of two hundred surfaces the last are none that can be left."""
    for many in (1, 3, 128, 129, 200):
        kernels: Any = types.SimpleNamespace(
            PARAMETERS={}, NEEDS_TIME_LIMIT=False, BODIES=[f"body_{k}" for k in range(many)]
        )
        left = verification.batches(kernels, np.zeros((1000, 9)))[2][2]
        assert left is not None
        assert left.min() == -1
        assert left.max() == min(many, 128) - 1
