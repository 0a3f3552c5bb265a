"""Garbage rows: the C engine under sanitizers, and as it is installed, against NumPy's bits.

A library that is compiled with a sanitizer runs in a Python that has loaded the sanitizer first, so
the rows fly in a process of its own: `python -m benchmarks.attack.rows LIBRARY SEED CASE`.
"""

import os
import subprocess
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unittest.mock import patch

import numpy as np
from numpy.typing import NDArray

import hoopgen
from benchmarks.families import FAMILIES
from hoopgen.engine import native
from hoopgen.simulation.hoop import HOOP
from tests.helpers.compiled import COMPILER, SANITIZERS, WIDTHS, same_bits, shared_library

from .cases import Attack, Attempt, Result, random_of

ROOT = Path(__file__).resolve().parents[2]

Floats = NDArray[np.float64]

EVERY = tuple(HOOP.layout.results)
KEY = "rows"
BATCHES = 2
"""Batches of a case."""

ROWS = 10_000
"""Rows of the largest batch."""

SECONDS = 300.0

ODD = np.array(
    [0.0, -0.0, 5e-324, -5e-324, 1e-310, 2.3e-308, 1e-150, -1e-150, 1e-30, 1e-9, 1.0, -0.25, 0.235]
    + [0.13128, 1e9, 1e30, 1e150, -1e150, 1.7e308, -1.7e308, np.inf, -np.inf, np.nan]
)

# ------------------------------------------------------------------------------------ what is flown


def _garbage(random: np.random.Generator, shape: tuple[int, ...]) -> Floats:
    """Any bits, odd numbers, or any order of magnitude."""
    bits = random.integers(0, 2**64, shape, np.uint64).view(np.float64)
    sizes = random.choice([-1.0, 1.0], shape) * 10.0 ** random.uniform(-320, 308, shape)
    kind = random.integers(0, 3, shape)
    return np.choose(kind, [bits, random.choice(ODD, shape), sizes])


def states(random: np.random.Generator, rows: int) -> Floats:
    """Garbage, and shots of the hard families, some of them with garbage in them."""
    flown, _ = FAMILIES[random.integers(len(FAMILIES))].make(4000)
    chosen = flown[random.integers(0, len(flown), rows)]
    kind = random.integers(0, 5, rows)[:, None]
    slightly = chosen * random.uniform(0.99, 1.01, chosen.shape)
    spoiled = np.where(
        np.arange(9) == random.integers(0, 9, (rows, 1)), _garbage(random, chosen.shape), chosen
    )
    near = random.uniform(-1, 1, chosen.shape) * [1, 1, 1, 6, 6, 6, 30, 30, 30]
    return np.choose(kind, [_garbage(random, chosen.shape), slightly, spoiled, near, chosen])


def parameters(random: np.random.Generator, rows: int) -> Mapping[str, Any]:
    """Return the article's parameters, some of them by row, some of those garbage."""
    given: dict[str, Any] = dict(hoopgen.PAPER)
    if random.integers(2):
        return given
    for name, usual in hoopgen.PAPER.items():
        if random.integers(2):
            kind = random.integers(0, 8, rows).clip(5) - 5
            near = usual * random.uniform(0.9, 1.1, rows)
            given[name] = np.choose(kind, [np.full(rows, usual), near, _garbage(random, (rows,))])
    return given


@contextmanager
def _held(library: native.Library, width: int) -> Iterator[None]:
    """Use this library, at this width, as the C engine within a context."""

    class Held:
        def run(self, *arguments: Any, **options: Any) -> None:
            library.run(*arguments, **{**options, "width": width})

    with patch.object(HOOP, "found", Held()):
        yield


def _differs(got: hoopgen.Shots, wanted: hoopgen.Shots, record: bool) -> str:
    """Name a field in which two results are not the same bits, and its first row."""
    columns = {name: (getattr(got, name), getattr(wanted, name)) for name in EVERY}
    if record:
        if len(got.events) != len(wanted.events):
            return f"events: {len(got.events)} and {len(wanted.events)}"
        for name in wanted.events.dtype.names or ():
            columns[f"events.{name}"] = (got.events[name], wanted.events[name])
    for name, (here, there) in columns.items():
        same = same_bits(here, there) if here.dtype.kind == "f" else here == there
        if not same.all():
            row = int(np.argwhere(~same)[0][0])
            return f"{name}[{row}]: {here[row]} in C, {there[row]} in NumPy"
    return ""


def fly(
    random: np.random.Generator, libraries: Mapping[str, native.Library], most: int
) -> tuple[int, str]:
    """Fly a batch with NumPy and with libraries of any width; say what differs."""
    rows = int(random.integers(35) if random.integers(2) else random.integers(most))
    record = bool(random.integers(2))
    given: dict[str, Any] = {
        "max_contacts": 40 if random.integers(4) else int(random.integers(1, 12)),
        "leaving": None if random.integers(4) else random.integers(-1, 3, rows).astype(np.int8),
        "fields": EVERY,
        "record": record,
        "threads": 1,
    }
    batch = (states(random, rows), parameters(random, rows))
    wanted = hoopgen.simulate(*batch, backend="numpy", **given)
    for name, library in libraries.items():
        for width in native.WIDTHS:
            with _held(library, width):
                try:
                    got = hoopgen.simulate(*batch, backend="c", **given)
                except ValueError:  # this processor does not have the width
                    if width == 1:
                        raise
                    continue
            if found := _differs(got, wanted, record):
                return rows, f"{name}, {width} abreast, {found}"
    return rows, ""


def _fly_all(library: Path, seed: int, most: int) -> None:
    libraries = {"sanitized": native.Library(library, HOOP.kernels)}
    if HOOP.library is not None:
        libraries["as installed"] = HOOP.library
    random, done = random_of(seed, KEY, 0), 0
    with np.errstate(all="ignore"):
        for _ in range(BATCHES):
            rows, found = fly(random, libraries, most)
            done += rows
            if found:
                print(found, file=sys.stderr)
                sys.exit(1)
    print(done)


# ------------------------------------------------------------------------------------ the attack


@dataclass(frozen=True)
class Rows:
    """A library with the sanitizers, what loads them first, and how many rows fly at most."""

    library: Path
    preload: str
    most: int

    def attempt(self, random: np.random.Generator, folder: Path) -> Result:
        """Fly the rows of a case, in a process that has loaded the sanitizer."""
        seed = int(random.integers(2**31))
        given = map(str, (self.library, seed, self.most))
        command = [sys.executable, "-m", f"{__package__}.rows", *given]
        # The engine allocates nothing, and Python does not give back all memory at its end.
        environment = os.environ | {
            "ASAN_OPTIONS": "detect_leaks=0",
            "LD_PRELOAD": self.preload,
            "PYTHONMALLOC": "malloc",
        }
        try:
            ended = subprocess.run(
                command, cwd=ROOT, env=environment, capture_output=True, text=True, timeout=SECONDS
            )
        except subprocess.TimeoutExpired:
            return Result(f"still at work after {SECONDS:.0f} s", _typed(command))
        if ended.returncode == 0:
            return Result(tries=int(ended.stdout))
        (folder / "stderr").write_text(ended.stderr)
        lines = [line for line in ended.stderr.splitlines() if line.strip()]
        speaking = (line for line in lines if "ERROR: " in line or "runtime error: " in line)
        last = next(speaking, lines[-1] if lines else f"status {ended.returncode}")
        return Result(last, _typed(command))


def _typed(command: list[str]) -> str:
    return " ".join(["python", *command[1:]])


ENGINE = '#include "hoop.c"\n'


def prepare(
    folder: Path, *, source: str = ENGINE, flags: tuple[str, ...] = (), most: int = ROWS
) -> Attempt:
    """Compile the engine with the sanitizers, for one lane and as many as the processor has."""
    file = folder / "engine.c"
    file.write_text(source)
    lanes = f"-DHOOP_NATIVE={WIDTHS[-1]}"
    library = shared_library(
        file, *SANITIZERS, lanes, *flags, "-Wno-psabi", f"-I{ROOT / 'generated' / 'c'}"
    )
    named = [*COMPILER, "-print-file-name=libasan.so"]
    preload = subprocess.run(named, capture_output=True, text=True, check=True).stdout.strip()
    return Rows(library, preload, most).attempt


ATTACK = Attack(
    KEY,
    "garbage rows",
    "rows",
    "Random bits, infinities, NaN, subnormal and huge numbers, in states and in parameters, and "
    "shots of the hard families. The C engine simulates them under AddressSanitizer and UBSan, in "
    "one lane and in as many as the processor has, and the installed C engine with every vector "
    "width. The attack fails on a report of a "
    "sanitizer, and on a result or an event with other bits than NumPy's (all NaN are equal).",
    prepare,
)

if __name__ == "__main__":
    _fly_all(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]))
