"""The C engine under sanitizers: no input makes it misbehave, nor do threads.

A driver in C hands it shots of every kind, garbage included, in buffers of exactly the documented
sizes, under AddressSanitizer and UndefinedBehaviorSanitizer. Another has threads share shots, under
ThreadSanitizer and MemorySanitizer, which Clang has. Whatever a sanitizer finds ends the driver
with a report.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from benchmarks.workloads import WORKLOADS
from hoopgen import NBA_COURT, PAPER
from hoopgen.engine import native
from hoopgen.engine.c_build import FLAGS
from tests.helpers import ROOT
from tests.helpers.compiled import SANITIZERS, WIDTHS, compiles, needs_compiler
from tests.helpers.court_shots import all_kinds
from tests.helpers.effort import trials

# One worker: the driver is compiled once.
pytestmark = [pytest.mark.slow, needs_compiler, pytest.mark.xdist_group("sanitizers")]

ROWS = trials(300_000, at_least=20_000)
"""Rows that every width flies."""

LOGGED = 0.05
"""Share of the calls that keep the event log, whose buffers are large."""

NOT_THERE = 77
"""The driver's exit status where the processor does not have the width."""

DRIVER = r"""
#include "hoop.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CHECK(c) ((c) ? (void)0 : (fprintf(stderr, "line %d: %s\n", __LINE__, #c), exit(3)))

static uint64_t random_state = 0x9E3779B97F4A7C15u;

static uint64_t bits(void) /* xorshift64 */
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return random_state;
}

static double unit(void) { return (double)(bits() >> 11) * 0x1p-53; }

static size_t below(size_t n) { return (size_t)(bits() >> 20) % n; }

static double odd(void)
{
    static const double values[] = {0.0, -0.0, 5e-324, -5e-324, 1e-310, 2.3e-308, 1e-150, -1e-150,
        1e150, -1e150, 1.7e308, -1.7e308, INFINITY, -INFINITY, NAN, 1.0, -0.25, 0.235, 0.13128};
    return values[below(sizeof values / sizeof *values)];
}

static double any_bits(void)
{
    const uint64_t b = bits();
    double a;
    memcpy(&a, &b, sizeof a);
    return a;
}

/* A release of the workloads; some with another speed, some with a component of garbage. */
static void draw(double *row, const double *shots, size_t count)
{
    memcpy(row, shots + HOOP_STATE * below(count), HOOP_STATE * sizeof *row);
    const size_t kind = below(8);
    for (int k = 0; k < HOOP_STATE; k++) {
        if (kind == 0)
            row[k] = any_bits();
        else if (kind == 1)
            row[k] = odd();
        else if (kind == 2)
            row[k] = below(4) ? 2.0 * unit() - 1.0 : odd();
        else if (kind == 3)
            row[k] *= 1.0 + 0.02 * (unit() - 0.5);
        else if (kind == 4)
            row[k] = k < 3 ? unit() - 0.5 : 6.0 * (unit() - 0.5);
    }
    if (kind == 5)
        row[below(HOOP_STATE)] = below(2) ? odd() : any_bits();
}

static void *room(size_t count, size_t size)
{
    /* Never less than a byte, never more than is documented; what is not written is seen. */
    void *memory = malloc(count * size ? count * size : 1);
    CHECK(memory);
    memset(memory, 0xA5, count * size);
    return memory;
}

static uint64_t mixed(uint64_t hash, uint64_t value) { return (hash ^ value) * 0x100000001B3u; }

static uint64_t call(size_t n, int width, int logged, const double *shots, size_t count,
                     const double *usual)
{
    const int32_t most = below(4) ? 1 + (int32_t)below(12) : 40;
    const double limit = below(4) ? INFINITY : 2.0 * unit();
    double *states = room(HOOP_STATE * n, sizeof *states);
    for (size_t i = 0; i < n; i++)
        draw(states + HOOP_STATE * i, shots, count);
    double *values[HOOP_PARAMETERS];
    const double *parameters[HOOP_PARAMETERS];
    int64_t strides[HOOP_PARAMETERS];
    const int varying = below(3) == 0;
    for (int k = 0; k < HOOP_PARAMETERS; k++) {
        strides[k] = varying && below(2);
        const size_t rows = strides[k] ? n : 1;
        values[k] = room(rows, sizeof **values);
        for (size_t i = 0; i < rows; i++) {
            values[k][i] = usual[k];
            if (strides[k] && below(4) == 0)
                values[k][i] = below(2)   ? usual[k] * (0.9 + 0.2 * unit())
                               : below(2) ? odd()
                                          : any_bits();
        }
        parameters[k] = values[k];
    }
    int8_t *leaving = below(4) ? NULL : room(n, sizeof *leaving);
    for (size_t i = 0; leaving && i < n; i++)
        leaving[i] = (int8_t)((int)below(HOOP_SURFACES + 1) - 1);
    const int32_t stop = 0;
    const int some = below(4) == 0; /* then some results are not wanted */
#define WANTED (!some || below(2))
    hoop_results out = {0};
    out.outcome = room(n, sizeof *out.outcome);
    out.contacts = room(n, sizeof *out.contacts);
    out.counts = WANTED ? room(HOOP_SURFACES * n, sizeof *out.counts) : NULL;
    out.first = WANTED ? room(n, sizeof *out.first) : NULL;
    out.time = WANTED ? room(n, sizeof *out.time) : NULL;
    out.state = WANTED ? room(HOOP_STATE * n, sizeof *out.state) : NULL;
    out.time_error = WANTED ? room(n, sizeof *out.time_error) : NULL;
    out.state_error = WANTED ? room(3 * n, sizeof *out.state_error) : NULL;
    out.uncertain = WANTED ? room(n, sizeof *out.uncertain) : NULL;
    const size_t rows = n * ((size_t)most + 1);
    out.events = logged ? room(rows, sizeof *out.events) : NULL;
    out.event_counts = logged ? room(n, sizeof *out.event_counts) : NULL;
    out.event_errors = logged && WANTED ? room(rows, sizeof *out.event_errors) : NULL;

    const int used = hoop_simulate(n, states, parameters, strides, leaving, most, limit, width,
                                   below(2) ? &stop : NULL, &out);
    if (used < 0)
        exit(77);
    CHECK(used == width);
    uint64_t hash = 0xCBF29CE484222325u;
    for (size_t i = 0; i < n; i++) {
        CHECK(out.outcome[i] <= HOOP_OUTCOME_ENDLESS);
        CHECK(out.outcome[i] != HOOP_OUTCOME_ENDLESS || isfinite(limit));
        CHECK(out.contacts[i] >= 0 && out.contacts[i] <= most);
        CHECK(out.outcome[i] != HOOP_OUTCOME_CAPPED || out.contacts[i] == most);
        CHECK(!out.uncertain || out.uncertain[i] <= 1);
        CHECK(!out.first || (out.first[i] >= -1 && out.first[i] < HOOP_SURFACES));
        hash = mixed(mixed(hash, out.outcome[i]), (uint64_t)out.contacts[i]);
        if (out.time) {
            uint64_t b = 0;
            if (out.time[i] == out.time[i])
                memcpy(&b, &out.time[i], sizeof b);
            hash = mixed(hash, b);
        }
        if (!logged)
            continue;
        const int ended = out.outcome[i] == HOOP_OUTCOME_MADE ||
                          out.outcome[i] == HOOP_OUTCOME_MISSED ||
                          out.outcome[i] == HOOP_OUTCOME_ENDLESS;
        CHECK(out.event_counts[i] == out.contacts[i] + ended);
        for (int32_t k = 0; k < out.event_counts[i]; k++) {
            const hoop_event *event = out.events + i * ((size_t)most + 1) + (size_t)k;
            CHECK(event->shot == (int64_t)i);
            CHECK(event->surface >= 0 && event->surface <= HOOP_BODY_END);
        }
    }
    for (int k = 0; k < HOOP_PARAMETERS; k++)
        free(values[k]);
    free(states), free(leaving), free(out.outcome), free(out.contacts), free(out.counts);
    free(out.first), free(out.time), free(out.state), free(out.time_error), free(out.state_error);
    free(out.uncertain), free(out.events), free(out.event_counts);
    free(out.event_errors);
    return hash;
}

/* driver WIDTH ROWS LOGGED PARAMETERS... < releases, doubles */
int main(int argc, char **argv)
{
    CHECK(argc == 4 + HOOP_PARAMETERS);
    const int width = atoi(argv[1]);
    const size_t rows = (size_t)atoll(argv[2]);
    const double logged = atof(argv[3]);
    double usual[HOOP_PARAMETERS];
    for (int k = 0; k < HOOP_PARAMETERS; k++)
        usual[k] = atof(argv[4 + k]);
    static double shots[HOOP_STATE << 13];
    const size_t count = fread(shots, HOOP_STATE * sizeof *shots, 1 << 13, stdin);
    CHECK(count);
    size_t done = 0;
    uint64_t hash = 0;
    while (done < rows) {
        /* No row, one, about a multiple of the lanes, and many. */
        size_t n = below(4) ? below(35) : below(4000);
        if (n > rows - done)
            n = rows - done;
        hash = mixed(hash, call(n, width, unit() < logged, shots, count, usual));
        done += n;
    }
    printf("%zu %016llx\n", done, (unsigned long long)hash);
    return 0;
}
"""


@pytest.fixture(scope="module")
def driver(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The engine and the driver, compiled with the sanitizers.

    Without the sanitizers' libraries, which are part of GCC, this fails with what the linker says.
    """
    folder = tmp_path_factory.mktemp("sanitizers")
    source, program = folder / "driver.c", folder / "driver"
    source.write_text(DRIVER, encoding="utf-8")
    scene = ROOT / "generated" / "c"
    flags = (*FLAGS, *SANITIZERS, "-Wno-psabi", f"-I{scene}")
    compiles(*flags, source, scene / "hoop.c", "-o", program, "-lm")
    return program


@dataclass(frozen=True)
class Run:
    """The driver's output and exit status."""

    status: int
    said: str
    report: str


@pytest.fixture(scope="module")
def runs(driver: Path) -> dict[int, Run]:
    """The driver's runs, at once; all widths fly the same rows."""
    releases = driver.with_name("releases")
    releases.write_bytes(np.concatenate([w.make(2000) for w in WORKLOADS]).tobytes())
    values = [repr(value) for value in PAPER.values()]
    # Where a debugger is not allowed, the search for leaks fails.
    environment = os.environ | {"ASAN_OPTIONS": "detect_leaks=0"}
    started = {}
    for width in native.WIDTHS:
        with releases.open("rb") as file:
            started[width] = subprocess.Popen(
                [driver, str(width), str(ROWS), str(LOGGED), *values],
                stdin=file,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                text=True,
                env=environment,
            )
    said = {width: process.communicate(timeout=600) for width, process in started.items()}
    return {width: Run(p.returncode, *said[width]) for width, p in started.items()}


@pytest.mark.parametrize("width", native.WIDTHS)
def test_no_row_makes_a_sanitizer_speak(runs: dict[int, Run], width: int) -> None:
    run = runs[width]
    if run.status == NOT_THERE:
        pytest.skip("this processor does not have the width")
    assert run.status == 0, run.report
    assert run.report == ""
    assert int(run.said.split()[0]) == ROWS


def test_widths_agree_on_garbage_too(runs: dict[int, Run]) -> None:
    """Outcomes, contacts and times of every row, by a hash of all."""
    assert len({run.said for run in runs.values() if run.status != NOT_THERE}) == 1


@pytest.mark.parametrize(
    ("wrong", "report"),
    [
        ("double *volatile a = malloc(8); free(a); return a[0] > 0.0;", "heap-use-after-free"),
        ("char *volatile a = malloc(8); return a[8];", "heap-buffer-overflow"),
        ("volatile int a = 0x7FFFFFFF; a = a + 1; return 0;", "signed integer overflow"),
        ("volatile double a = 1e10; return (int)a;", "outside the range"),
    ],
)
def test_the_sanitizers_are_at_work(tmp_path: Path, wrong: str, report: str) -> None:
    """A program that is wrong, and compiled alike, ends with a report."""
    source, program = tmp_path / "wrong.c", tmp_path / "wrong"
    source.write_text(f"#include <stdlib.h>\nint main(void) {{ {wrong} }}\n", encoding="utf-8")
    compiles(*FLAGS, *SANITIZERS, source, "-o", program)
    run = subprocess.run([program], capture_output=True, text=True, check=False, timeout=60)
    assert run.returncode != 0
    assert report in run.stderr


# ------------------------------------------------------------------------- threads, and memory

SHARING = r"""
#include "SCENE.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

#define CHECK(c) ((c) ? (void)0 : (fprintf(stderr, "line %d: %s\n", __LINE__, #c), exit(3)))

static double states[SCENE_STATE << 12], usual[SCENE_PARAMETERS];
static const double *parameters[SCENE_PARAMETERS];
static int64_t strides[SCENE_PARAMETERS];
static size_t shots, next;
static int width;
static int32_t stop;
static SCENE_results out;

static void *work(void *status)
{
    *(int *)status = SCENE_share(shots, states, parameters, strides, NULL, 100, 4.0, width, &stop,
                                 &out, &next, 8);
    return NULL;
}

/* Run all shots by two threads; return how many have results that make sense. */
static size_t run(int stopped)
{
    /* Not initialised: MemorySanitizer sees whether all of it is written. */
    out.outcome = malloc(shots * sizeof *out.outcome);
    out.contacts = malloc(shots * sizeof *out.contacts);
    out.time = malloc(shots * sizeof *out.time);
    out.state = malloc(SCENE_STATE * shots * sizeof *out.state);
    CHECK(out.outcome && out.contacts && out.time && out.state);
    pthread_t threads[2];
    int status[2];
    next = 0;
    atomic_store((_Atomic int32_t *)&stop, 0);
    for (int k = 0; k < 2; k++)
        CHECK(!pthread_create(&threads[k], NULL, work, &status[k]));
    if (stopped)
        atomic_store((_Atomic int32_t *)&stop, 1);
    for (int k = 0; k < 2; k++) {
        CHECK(!pthread_join(threads[k], NULL));
        CHECK(status[k] == width);
    }
    size_t good = 0;
    for (size_t i = 0; !stopped && i < shots; i++)
        good += out.outcome[i] <= SCENE_OUTCOME_ENDLESS && out.contacts[i] <= 100 &&
                !(out.time[i] < 0.0) && !(out.state[SCENE_STATE * i + 2] > 1e300);
    free(out.outcome), free(out.contacts), free(out.time), free(out.state);
    return good;
}

/* driver WIDTH < parameters, then releases: doubles. Many shots, and so few that lanes idle. */
int main(int argc, char **argv)
{
    CHECK(argc == 2);
    width = atoi(argv[1]);
    CHECK(fread(usual, sizeof *usual, SCENE_PARAMETERS, stdin) == SCENE_PARAMETERS);
    const size_t all = fread(states, SCENE_STATE * sizeof *states, 1 << 12, stdin);
    for (int k = 0; k < SCENE_PARAMETERS; k++)
        parameters[k] = &usual[k];
    for (shots = all; shots; shots /= 7) {
        out.uncertain = NULL, out.time_error = NULL;
        CHECK(run(0) == shots);
        out.uncertain = malloc(shots * sizeof *out.uncertain);
        out.time_error = malloc(shots * sizeof *out.time_error);
        CHECK(out.uncertain && out.time_error);
        CHECK(run(0) == shots);
        run(1);
        free(out.uncertain), free(out.time_error);
    }
    return 0;
}
"""

CLANG = shutil.which("clang")


def sanitized(sanitizer: str) -> list[str]:
    """Return Clang and its flags for a sanitizer."""
    return [CLANG or "clang", "-O1", "-g1", "-w", f"-fsanitize={sanitizer}", "-pthread"]


@pytest.fixture(scope="module", params=["thread", "memory"])
def sanitizer(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> str:
    """A sanitizer of Clang's whose programs run here."""
    name = str(request.param)
    if CLANG is None:
        pytest.skip(f"no clang, and so no sanitizer of {name}")
    folder = tmp_path_factory.mktemp(name)
    source, program = folder / "nothing.c", folder / "nothing"
    source.write_text("int main(void) { return 0; }\n", encoding="utf-8")
    for command in ([*sanitized(name), source, "-o", program], [program]):
        ran = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
        if ran.returncode:
            pytest.skip(f"clang's sanitizer of {name} does not work here: {ran.stderr[:200]}")
    return name


@pytest.mark.parametrize("scene", ["hoop", "court"])
def test_threads_that_share_shots_make_no_other_sanitizer_speak(
    sanitizer: str, scene: str, tmp_path: Path
) -> None:
    """The flag to stop is set meanwhile; lanes that idle compute with numbers, too."""
    if (sanitizer, scene) == ("thread", "court"):
        pytest.skip("what threads have in common is the same in every scene")
    generated = ROOT / "generated" / "c"
    source, program = tmp_path / "sharing.c", tmp_path / "sharing"
    text = SHARING
    for word in ("_STATE", "_PARAMETERS", "_OUTCOME"):
        text = text.replace(f"SCENE{word}", f"{scene.upper()}{word}")
    source.write_text(text.replace("SCENE", scene), encoding="utf-8")
    flags = [f for f in FLAGS if f.startswith(("-std", "-ffp"))]
    only = f"-D{scene.upper()}_ONLY={WIDTHS[-1]}"
    command = [*sanitized(sanitizer), *flags, only, f"-I{generated}"]
    files = [str(source), str(generated / f"{scene}.c"), "-o", str(program), "-lm"]
    made = subprocess.run([*command, *files], capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
    values = list((PAPER if scene == "hoop" else NBA_COURT).values())
    states = np.concatenate([*(w.make(100) for w in WORKLOADS), all_kinds(20)])
    given = np.array(values, np.float64).tobytes() + states.tobytes()
    run = subprocess.run(
        [program, str(WIDTHS[-1])], input=given, capture_output=True, check=False, timeout=600
    )
    assert run.returncode == 0, run.stderr.decode()
    assert run.stderr == b""


WRONG = {
    "thread": (
        "#include <pthread.h>\nint a;\nvoid *f(void *b) { a++; return b; }\n"
        "int main(void) { pthread_t t; pthread_create(&t, 0, f, 0); a++; pthread_join(t, 0); }",
        "data race",
    ),
    "memory": (
        "#include <stdlib.h>\nint main(void) { volatile int *a = malloc(4); if (*a) abort(); }",
        "use-of-uninitialized-value",
    ),
}


def test_the_other_sanitizers_are_at_work(sanitizer: str, tmp_path: Path) -> None:
    source, program = tmp_path / "wrong.c", tmp_path / "wrong"
    text, report = WRONG[sanitizer]
    source.write_text(text + "\n", encoding="utf-8")
    subprocess.run([*sanitized(sanitizer), source, "-o", program], check=True)
    run = subprocess.run([program], capture_output=True, text=True, check=False, timeout=60)
    assert run.returncode != 0
    assert report in run.stderr
