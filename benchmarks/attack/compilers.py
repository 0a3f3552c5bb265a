"""Compilers' flags: the C engine, built under those that a stranger may have set."""

import shlex
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from .cases import Attack, Attempt, Result

sys.path.append(str(Path(__file__).resolve().parents[2] / "tests"))  # tests/ is not installed

from flags import COMPILERS, MATRIX, Verdict, try_flags

SHOTS = 50
"""Of each family, besides those that hoopgen compares itself."""

WIDEST = (1, 1, 4, 4, 4, 8, 16)
"""Wider vectors take longer to compile."""


@dataclass(frozen=True)
class Compilers:
    """What builds the engine under flags, and says what becomes of it."""

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
    "The C engine built by GCC and Clang, as `setup.py` does and by hand, under one to three sets "
    "of flags that a stranger may have in `CFLAGS` and `LDFLAGS`, fast-math and its parts among "
    "them. Each is refused, gives NumPy's bits, or is found out before it is used; none is silent.",
    prepare,
)
