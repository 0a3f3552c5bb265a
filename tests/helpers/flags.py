"""Compilers' flags against the C engine, built by setup.py or by hand.

`try_flags` builds the engine under flags that a stranger has set, and loads it in a process of its
own. `MATRIX` is what there is to try; a flag may be refused, undone or found, and never be silent.
"""

from __future__ import annotations

import json
import math
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from hoopgen.engine import c_build
from tests.helpers import ROOT

COMPILERS = tuple(name for name in ("gcc", "clang") if shutil.which(name))

MATRIX = (
    "",
    "-O0",
    "-Og",
    "-Os",
    "-O3",
    "-Ofast",
    "-ffast-math",
    "-funsafe-math-optimizations",
    "-fassociative-math -fno-signed-zeros -fno-trapping-math",
    "-fno-signed-zeros",
    "-freciprocal-math",
    "-ffinite-math-only",
    "-fno-honor-nans",
    "-fno-honor-infinities",
    "-fapprox-func",
    "-fcx-limited-range",
    "-fsingle-precision-constant",
    "-fexcess-precision=fast",
    "-fdenormal-fp-math=positive-zero",
    "-frounding-math",
    "-fsignaling-nans",
    "-fmath-errno -ftrapping-math",
    "-ffp-contract=fast",
    "-ffp-contract=on",
    "-ffp-contract=fast -march=native",
    "-ffp-model=fast",
    "-ffp-model=strict",
    "-ffp-eval-method=extended",
    "-mfpmath=387",
    "-mfpmath=both",
    "-mrecip -ffast-math",
    "-mrecip=all -freciprocal-math",
    "-mdaz-ftz",
    "-march=native -mtune=native",
    "-march=native -std=gnu17",
    "-march=native -Ofast -flto",
    "-mprefer-vector-width=128",
    "-mno-avx512f",
    "-mno-avx2",
    "-ftree-vectorize -fvect-cost-model=unlimited",
    "-funroll-loops -fno-strict-aliasing -fwrapv",
    "-fno-inline -fno-builtin",
    "-flto",
    "-fno-semantic-interposition -fvisibility=hidden",
    "-std=c99",
    "-std=gnu2x",
)
"""Flags to try, one set at a time; a compiler that does not know one of them refuses."""

Kind = Literal["refused", "same", "found", "silent"]


@dataclass(frozen=True)
class Verdict:
    """The verdict on an engine that was built under flags.

    Attributes
    ----------
    kind
        "refused": it does not compile. "same": NumPy's bits. "found": it differs, and is not used.
        "silent": it differs, and hoopgen would use it.
    said
        By the compiler, or by hoopgen.
    """

    kind: Kind
    said: str


def try_flags(
    compiler: str,
    flags: str,
    *,
    link: str = "",
    ours: bool = True,
    widest: int = 16,
    shots: int = 0,
    source: Path = ROOT / "generated" / "c" / "hoop.c",
) -> Verdict:
    """Build the C engine under flags and look at what it gives.

    Parameters
    ----------
    compiler, flags, link
        What CC, CFLAGS and LDFLAGS hold.
    ours
        Whether setup.py builds it; else the compiler alone, -O3 before the flags.
    widest
        The widest vectors that are built; 1 and 4 take seconds, all of them about ten.
    shots
        Of each family of the benchmarks, compared besides those that hoopgen compares itself. With
        none, nothing is "silent".
    source
        The C file, if not setup.py builds.
    """
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        few = f"-DHOOP_WIDEST={widest}" if widest < 16 else ""
        few += " -DCOURT_WIDEST=1"  # setup.py builds it too, and nobody looks at it here
        if ours:
            library, said = _set_up(compiler, f"{few} {flags}", link, folder)
        else:
            library, said = _by_hand(compiler, f"{few} {flags}", link, source, folder)
        if library is None:
            errors = [line for line in said.splitlines() if "error" in line]
            return Verdict("refused", errors[0] if errors else said)
        answer = _run([sys.executable, "-m", "tests.helpers.flags", str(library), str(shots)])
        try:
            return Verdict(**json.loads(answer.splitlines()[-1]))
        except (IndexError, ValueError):
            return Verdict("silent", f"the process that loaded it ended with: {answer}")


def _set_up(compiler: str, flags: str, link: str, folder: Path) -> tuple[Path | None, str]:
    """Build as setup.py does; return the library, None if there is none, and what was said."""
    to = (f"--build-lib={folder}", f"--build-temp={folder / 'temp'}")
    command = [sys.executable, "setup.py", "build_ext", *to]
    said = _run(command, CC=compiler, CFLAGS=flags, LDFLAGS=link)
    return next(folder.glob("hoopgen/engine/_hoop*"), None), said


def _by_hand(
    compiler: str, flags: str, link: str, source: Path, folder: Path
) -> tuple[Path | None, str]:
    library, object_file = folder / "_hoop.so", str(folder / "hoop.o")
    word = c_build.source_digest(ROOT / "generated" / "c", "hoop")
    options = shlex.split(f"-O3 -fPIC -DHOOP_SOURCES={word} {flags}")
    said = _run([compiler, *options, "-c", str(source), "-o", object_file])
    if Path(object_file).exists():
        options = shlex.split(f"-shared {flags} {link}")
        said += _run([compiler, *options, object_file, "-o", str(library), "-lm"])
    return (library if library.exists() else None), said


def _run(command: Sequence[str], **environment: str) -> str:
    result = subprocess.run(
        command,
        cwd=ROOT,
        env=os.environ | environment,
        capture_output=True,
        text=True,
        encoding="utf-8",
        errors="replace",
        check=False,
        timeout=600,
    )
    return result.stderr + result.stdout


def _look(path: Path, shots: int) -> Verdict:
    """Return what hoopgen says of a library, and what it should have said."""
    from hoopgen.generated.numpy import hoop

    from benchmarks.families import FAMILIES
    from hoopgen.core.parameters import resolve
    from hoopgen.engine import native, verification
    from hoopgen.hoop.presets import HOOP_TABLE
    from hoopgen.simulation.hoop import hoop_library

    library = hoop_library(path)
    if isinstance(library, native.Rejection):
        return Verdict("found", library.reason)
    made = (family.make(shots) for family in FAMILIES if shots)
    batches = (
        (states, [*resolve(parameters, shots, HOOP_TABLE).values()], None, math.inf)
        for states, parameters in made
    )
    differences = verification.differences(library, hoop, verification.expected(hoop, batches))
    return Verdict("silent" if differences else "same", differences)


if __name__ == "__main__":
    verdict = _look(Path(sys.argv[1]), int(sys.argv[2]))
    print(json.dumps({"kind": verdict.kind, "said": verdict.said}))
