"""The C compiler's flags, and a digest of the sources that is compared at every load.

This file uses the standard library alone, since setup.py runs it by its path.
"""

from __future__ import annotations

import re
from pathlib import Path

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


def source_files(folder: Path, scene: str) -> list[Path]:
    """Return a scene's C file in a folder and the headers there that it includes, by name.

    Parameters
    ----------
    folder
        The folder of the C files.
    scene
        The name of the scene, with which its own files begin.
    """
    found, left = set(), [f"{scene}.c"]
    while left:
        file = folder / left.pop()
        if file not in found and file.is_file():
            found.add(file)
            left += re.findall(r'#include "(.+)"', file.read_text(encoding="utf-8"))
    return sorted(found)


def source_digest(folder: Path, scene: str) -> str:
    """Return a digest of the names and bytes of a scene's `source_files`, "" without any.

    The digest is a C identifier, because the compiler gets it as the value of a macro.

    Parameters
    ----------
    folder, scene
        As for `source_files`.
    """
    import hashlib  # loads OpenSSL, which importing hoopgen need not

    digest = hashlib.sha256()
    files = source_files(folder, scene)
    for file in files:
        text = file.read_bytes()
        digest.update(f"{file.name} {len(text)}\n".encode() + text)
    return f"s{digest.hexdigest()}" if files else ""
