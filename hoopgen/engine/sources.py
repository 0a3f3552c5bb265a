"""What C is built with, and a word for what it is built from: a load compares it.

Standard library alone, and nothing of hoopgen: setup.py runs this file by its path.
"""

from __future__ import annotations

from pathlib import Path

__all__ = ["FLAGS", "word"]

# Every operation is done as it is written, and gives the bits of the NumPy target. These come after
# CFLAGS and LDFLAGS, and take back each of their flags that would change that, by its name: with
# -fno-fast-math alone GCC 12 compiles as it should, but still links the start-up code of fast-math.
# The C file refuses to compile, or to run, with what is left.
# No -march: the C file chooses its vector width at run time.
FLAGS = [
    "-O3",
    "-g0",
    "-std=c11",
    "-fno-fast-math",
    "-fno-unsafe-math-optimizations",
    "-fno-associative-math",
    "-fno-reciprocal-math",
    "-fno-finite-math-only",
    "-fsigned-zeros",
    "-ffp-contract=off",
    "-fno-math-errno",
    "-fno-trapping-math",
]


def word(folder: Path, scene: str) -> str:
    """Return a word for the names and bytes of a scene's C files in a folder, "" without any.

    It is a C identifier: the compiler gets it as the value of a macro, whatever the shell.
    """
    import hashlib  # loads OpenSSL, which importing hoopgen need not

    digest = hashlib.sha256()
    files = sorted(folder.glob(f"{scene}*.[ch]"))
    for file in files:
        text = file.read_bytes()
        digest.update(f"{file.name} {len(text)}\n".encode() + text)
    return f"s{digest.hexdigest()}" if files else ""
