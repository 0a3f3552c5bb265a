"""Compilers' flags: the C engine, built under those that a stranger may have set."""

import shlex
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from tests.helpers.flags import COMPILERS, MATRIX, Verdict, try_flags

from .cases import Attack, Attempt, Result

SHOTS = 50
"""Shots of each family, besides those that hoopgen compares itself."""

WIDEST = (1, 1, 4, 4, 4, 8, 16)
"""Wider vectors take longer to compile."""


@dataclass(frozen=True)
class Compilers:
    """Builds of the engine under flags, and their results."""

    try_flags: Callable[..., Verdict] = try_flags

    def attempt(self, random: np.random.Generator, folder: Path) -> Result:
        """Build with one to three sets of the matrix, by setup.py or by hand."""
        sets = random.choice(np.array(MATRIX), random.integers(1, 4)).tolist()
        flags = " ".join(dict.fromkeys(filter(None, sets)))
        given: dict[str, Any] = {
            "link": flags if random.integers(2) else "",
            "ours": bool(random.integers(2)),
            "widest": int(random.choice(WIDEST)),
            "shots": SHOTS,
        }
        compiler = COMPILERS[random.integers(len(COMPILERS))]
        verdict = self.try_flags(compiler, flags, **given)
        wrong = f"silent: {verdict.said}" if verdict.kind == "silent" else ""
        how = "setup.py" if given["ours"] else "by hand"
        command = f"CC={compiler} CFLAGS={shlex.quote(flags)} LDFLAGS={shlex.quote(given['link'])}"
        return Result(wrong, f"{command} {how}, {given['widest']} abreast")


def prepare(folder: Path) -> Attempt:
    """Look whether there is a compiler."""
    if not COMPILERS:
        raise LookupError("compilers: neither gcc nor clang is here")
    return Compilers().attempt


ATTACK = Attack(
    "compilers",
    "compiler flags",
    "builds",
    "The C engine, built by GCC and Clang, both by `setup.py` and by hand, under one to three "
    "sets of flags that a user may have in `CFLAGS` and `LDFLAGS`, including fast-math and its "
    "parts. The build must refuse the flags, or the engine must give NumPy's bits, or hoopgen "
    "must detect the difference before it uses the engine.",
    prepare,
)
