"""Each attack finds a fault that is planted for it, and nothing where there is none."""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

if os.name != "posix":
    pytest.skip("attacks need POSIX", allow_module_level=True)

from tests.helpers.compiled import needs_compiler
from tests.helpers.flags import Verdict

for package in ("pyarrow", "xarray", "scipy", "pydantic"):
    pytest.importorskip(package)

from benchmarks.attack import compilers, files, kills, lines, rows  # noqa: E402
from benchmarks.attack.cases import Attack, Attempt, Result, Tally, attacked  # noqa: E402
from benchmarks.attack.processes import Ended, Entry, hoopgen, run, wrong  # noqa: E402
from benchmarks.attack.report import page, summary  # noqa: E402
from hoopgen.study.jobs import chunk_store  # noqa: E402

# One worker: what is prepared is prepared once.
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("attack")]

# ------------------------------------------------------------------------- programs with a fault


def refuses(arguments: list[str]) -> None:
    print("hoopgen: error: no", file=sys.stderr)
    sys.exit(2)


def crashes(arguments: list[str]) -> None:
    os.kill(os.getpid(), signal.SIGSEGV)


def raises(arguments: list[str]) -> None:
    raise KeyError("nobody foresaw this")


def takes_all_memory(arguments: list[str]) -> None:
    bytearray(1 << 40)


def says_nothing(arguments: list[str]) -> None:
    sys.exit(2)


def ends_oddly(arguments: list[str]) -> None:
    sys.exit(3)


def hangs(arguments: list[str]) -> None:
    signal.pause()


FAULTS: dict[Entry, str] = {
    crashes: "killed by SIGSEGV",
    raises: "traceback: KeyError: 'nobody foresaw this'",
    takes_all_memory: "traceback: MemoryError",
    says_nothing: "exit status 2, and no word of an error",
    ends_oddly: "exit status 3",
}
NAMES = [fault.__name__ for fault in FAULTS]


def tallied(attack: Attack, attempt: Attempt, cases: int, keep: Path, seed: int = 1) -> Tally:
    return attacked(attack, attempt, seed, range(cases), keep, report=lambda line: None)


# ----------------------------------------------------------------------------------- processes


@pytest.mark.parametrize("fault", FAULTS, ids=NAMES)
def test_what_is_wrong_with_a_program_is_seen(fault: Entry, tmp_path: Path) -> None:
    assert wrong(run([], tmp_path, entry=fault)).startswith(FAULTS[fault])


def test_nothing_is_wrong_with_an_error_of_one_line(tmp_path: Path) -> None:
    ended = run([], tmp_path, entry=refuses)
    assert (ended.status, ended.err) == (2, "hoopgen: error: no\n")
    assert wrong(ended) == ""


def test_a_program_that_does_not_end_is_ended(tmp_path: Path) -> None:
    ended = run([], tmp_path, entry=hangs, seconds=0.1)
    assert wrong(ended) == "still at work when its time was up"


def test_the_command_line_runs_in_a_folder_and_is_heard(tmp_path: Path) -> None:
    words = ["aim", "--distance", "13.75ft", "--height", "7ft", "--csv", "table.csv"]
    ended = run(words, tmp_path)
    assert wrong(ended) == ""
    assert b"speed" in ended.out
    assert (tmp_path / "work" / "table.csv").is_file()


# ------------------------------------------------------------------------------- flipped bytes


@pytest.fixture(scope="module")
def flips(tmp_path_factory: pytest.TempPathFactory) -> files.Files:
    return files.write_files(tmp_path_factory.mktemp("files"))


@pytest.mark.parametrize("fault", FAULTS, ids=NAMES)
def test_a_reader_with_a_fault_is_found_and_its_file_kept(
    fault: Entry, flips: files.Files, tmp_path: Path
) -> None:
    tally = tallied(files.ATTACK, replace(flips, entry=fault).attempt, 2, tmp_path)
    assert [f.wrong.startswith(FAULTS[fault]) for f in tally.findings] == [True, True]
    for found in tally.findings:
        assert any((found.kept / "work").iterdir())
        assert found.wrong in (found.kept / "finding.txt").read_text()


def answers_otherwise(arguments: list[str]) -> None:
    if "kept" in arguments:  # it goes on from its own files
        print("42")
    else:
        refuses(arguments)


def test_another_result_out_of_damaged_chunks_is_found(flips: files.Files, tmp_path: Path) -> None:
    tally = tallied(files.ATTACK, replace(flips, entry=answers_otherwise).attempt, 12, tmp_path)
    assert {found.wrong for found in tally.findings} == {"another result, and not a word"}


def test_readers_without_a_fault_hold(flips: files.Files, tmp_path: Path) -> None:
    tally = tallied(files.ATTACK, flips.attempt, 6, tmp_path)
    assert (tally.tries, tally.findings) == (6, [])


# -------------------------------------------------------------------------------- garbage rows

PLANTED = r"""
#define hoop_share engine
#include "hoop.c"
#undef hoop_share
#include <stdlib.h>

int hoop_share(size_t shots, const double *states, const double *const *parameters,
               const int64_t *strides, const int8_t *leaving, int32_t max_contacts,
               double time_limit, int width, const volatile int32_t *stop,
               const hoop_results *results, size_t *next, size_t parts)
{
    const char *planted = getenv("HOOP_PLANTED");
    const int used = engine(shots, states, parameters, strides, leaving, max_contacts, time_limit,
                            width, stop, results, next, parts);
    if (planted && *planted == 'r') { /* reads past the end */
        volatile double past = states[HOOP_STATE * shots];
        (void)past;
    }
    /* As -ffinite-math-only does. */
    for (size_t i = 0; planted && *planted == 'b' && i < shots; i++)
        if (results->outcome[i] == HOOP_OUTCOME_INVALID)
            results->outcome[i] = HOOP_OUTCOME_SHORT;
    return used;
}
"""


@pytest.fixture(scope="module")
def garbage(tmp_path_factory: pytest.TempPathFactory) -> Attempt:
    """The engine with faults that a word of the environment wakes."""
    folder = tmp_path_factory.mktemp("rows")
    return rows.prepare(folder, source=PLANTED, flags=("-O0", "-DHOOP_WIDEST=1"), most=500)


@needs_compiler
@pytest.mark.parametrize(
    ("planted", "found"),
    [
        ("reads", "AddressSanitizer: heap-buffer-overflow"),
        ("bits", "sanitized, 1 abreast, outcome"),
    ],
)
def test_an_engine_with_a_fault_is_found(
    planted: str, found: str, garbage: Attempt, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOOP_PLANTED", planted)
    (finding,) = tallied(rows.ATTACK, garbage, 1, tmp_path).findings
    assert found in finding.wrong


@needs_compiler
def test_an_engine_without_a_fault_holds(garbage: Attempt, tmp_path: Path) -> None:
    tally = tallied(rows.ATTACK, garbage, 1, tmp_path)
    assert tally.findings == []
    assert tally.tries > 1


# ---------------------------------------------------------------------------------------- flags


@pytest.mark.parametrize("kind", ["refused", "same", "found", "silent"])
def test_flags_that_change_results_and_nobody_says_so_are_found(kind: Any, tmp_path: Path) -> None:
    def verdict(compiler: str, flags: str, **given: object) -> Verdict:
        return Verdict(kind, "width 4: time")

    attempt = compilers.Compilers(verdict).attempt
    tally = tallied(compilers.ATTACK, attempt, 2, tmp_path)
    silent = "silent: width 4: time"
    assert [found.wrong for found in tally.findings] == [silent] * 2 * (kind == "silent")


# ---------------------------------------------------------------------------------------- kills


def killed(arguments: list[str]) -> None:
    """The command line, which is killed once, when it has kept two chunks."""
    write, done = chunk_store.ChunkStore.write, []
    marked = Path.cwd().with_name("was killed")

    def last(folder: chunk_store.ChunkStore, chunk: int, table: object) -> None:
        write(folder, chunk, table)
        done.append(chunk)
        if len(done) == 2 and not marked.exists():
            marked.touch()
            os.kill(os.getpid(), signal.SIGKILL)

    chunk_store.ChunkStore.write = last  # type: ignore[method-assign]
    hoopgen(arguments)


def loses_a_chunk(arguments: list[str]) -> None:
    """The like, and what it goes on with is its first chunk, twice."""
    read = chunk_store.ChunkStore.read
    chunk_store.ChunkStore.read = lambda folder, chunk: read(folder, 0)  # type: ignore[method-assign]
    killed(arguments)


@pytest.fixture(scope="module")
def estimate(tmp_path_factory: pytest.TempPathFactory) -> kills.Kills:
    """An estimate of which nobody knows how long it takes: it ends, or kills itself, before."""
    folder = tmp_path_factory.mktemp("kills")
    given = kills.write_files(folder / "given")
    whole = kills.undisturbed(kills.COMMANDS[0], given, folder / "whole")
    return kills.Kills(given, [replace(whole, seconds=1000.0)])


def test_work_that_loses_a_chunk_is_found(estimate: kills.Kills, tmp_path: Path) -> None:
    tally = tallied(kills.ATTACK, replace(estimate, entry=loses_a_chunk).attempt, 1, tmp_path)
    assert ["stdout" in found.wrong for found in tally.findings] == [True]


def test_work_that_goes_on_holds(estimate: kills.Kills, tmp_path: Path) -> None:
    tally = tallied(kills.ATTACK, replace(estimate, entry=killed).attempt, 1, tmp_path)
    assert tally.findings == []
    assert tally.tries >= 1


# ---------------------------------------------------------------------------------------- lines


@pytest.mark.parametrize("fault", FAULTS, ids=NAMES)
def test_a_command_line_with_a_fault_is_found(fault: Entry, tmp_path: Path) -> None:
    (tmp_path / "given").mkdir()
    attempt = lines.prepare(tmp_path / "given", entry=fault)
    tally = tallied(lines.ATTACK, attempt, 3, tmp_path / "keep")
    assert [f.wrong.startswith(FAULTS[fault]) for f in tally.findings] == [True] * 3


def test_who_asks_for_much_can_still_stop() -> None:
    stopped = Ended(130, b"", "hoopgen: error: interrupted\n", late=True)
    assert wrong(stopped, may_take_long=True) == ""
    assert wrong(stopped).startswith("exit status 130")
    just_ended = Ended(0, b"", "", late=True)
    assert wrong(just_ended) == wrong(just_ended, may_take_long=True) == ""
    deaf = Ended(-signal.SIGKILL, b"", "", late=True)
    assert wrong(deaf, may_take_long=True) == "does not heed Ctrl-C"


def test_command_lines_without_a_fault_hold(tmp_path: Path) -> None:
    (tmp_path / "given").mkdir()
    tally = tallied(lines.ATTACK, lines.prepare(tmp_path / "given"), 6, tmp_path / "keep", seed=3)
    assert (tally.tries, tally.findings) == (6, [])


# --------------------------------------------------------------------------------- seeds, pages


def test_a_case_hangs_on_its_seed_and_number_alone(flips: files.Files, tmp_path: Path) -> None:
    attempt = replace(flips, entry=crashes).attempt
    first, alone = (
        attacked(files.ATTACK, attempt, 5, cases, tmp_path / name, report=lambda line: None)
        for name, cases in (("all", range(4)), ("alone", [3]))
    )
    assert first.findings[3].command == alone.findings[0].command

    def contents(folder: Path) -> dict[str, bytes]:
        return {
            str(f.relative_to(folder)): f.read_bytes() for f in folder.rglob("*") if f.is_file()
        }

    assert contents(first.findings[3].kept) == contents(alone.findings[0].kept)
    assert contents(first.findings[2].kept) != contents(alone.findings[0].kept)


def test_there_is_a_try_however_short_the_time(tmp_path: Path) -> None:
    attempt: Callable[..., Result] = lambda random, folder: Result()  # noqa: E731
    tally = attacked(lines.ATTACK, attempt, 1, range(9), tmp_path, seconds=0.0)
    assert tally.tries == 1


def test_the_page_says_what_was_tried_held_and_found(tmp_path: Path) -> None:
    def attempt(random: object, folder: Path) -> Result:
        return Result("killed by SIGSEGV", "hoopgen view x.feather")

    tallies = [tallied(attack, attempt, 2, tmp_path) for attack in (files.ATTACK, lines.ATTACK)]
    assert "| flipped bytes | 2 files | 0 |" in "\n".join(summary(tallies))
    text = page(tallies, 1.0)
    assert 'make attack ARGS="--only files --seed 1 --case 0"' in text
    for untried in ("Windows", "NFS", "Loss of power"):
        assert untried in text
