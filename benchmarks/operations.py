"""How many operations hoopgen spends on a shot: its C, compiled with a counter in every kernel."""

import ctypes
import re
import subprocess
import tempfile
from pathlib import Path
from typing import Any
from unittest.mock import patch

import hoopgen
from benchmarks.peers.native import COMPILER, OUR_FLAGS
from benchmarks.workloads import States
from hoopgen.engine import native
from hoopgen.engines import HOOP

GENERATED = Path(__file__).parents[1] / "generated" / "c"
ARITHMETIC = ("addition", "subtraction", "multiplication", "division", "square root")

# A kernel: the comment that counts its operations, "11 operations: 3 additions, ...", and its head.
_KERNEL = re.compile(
    r"/\*(?P<comment>(?:(?!\*/).)*)\*/\s*typedef struct.*?\nLANES\(\w+\)\([^)]*\)\n\{\n", re.DOTALL
)
_COUNT = re.compile(r"(\d+) ([a-z ]+?)s?[,.]")


class OneLane(native.Library):
    """A compiled scene, run without vectors."""

    def run(self, *arguments: Any, **named: Any) -> None:
        """Simulate shots one by one."""
        super().run(*arguments, **(named | {"width": 1}))


def _with_counter(kernel: re.Match[str]) -> str:
    counts = _COUNT.findall(kernel["comment"])
    cost = sum(int(count) for count, what in counts if what in ARITHMETIC)
    return f"{kernel[0]}    hoop_counter += {cost};\n"


def operations(states: States) -> float | None:
    """Arithmetic a shot in hoopgen's kernels, without the event loop's comparisons and choices;
    None where there are no sources. One lane: what the lanes of a vector do for each other's sake
    is not counted."""
    if not GENERATED.is_dir():
        return None
    with tempfile.TemporaryDirectory() as folder:
        for source in GENERATED.glob("*.[ch]"):
            text = source.read_text(encoding="utf-8")
            if source.name == "hoop_kernels.h":
                text = _KERNEL.sub(_with_counter, text)
            if source.name == "hoop.c":
                text = f"double hoop_counter;\n{text}"
            (Path(folder) / source.name).write_text(text, encoding="utf-8")
        target = Path(folder) / "counting.so"
        command = [COMPILER, *OUR_FLAGS, "-w", "-shared", "-fPIC", f"{folder}/hoop.c"]
        subprocess.run([*command, "-o", str(target), "-lm"], check=True)
        counting = OneLane(target, HOOP.kernels)
        counter = ctypes.c_double.in_dll(ctypes.CDLL(str(target)), "hoop_counter")
    with patch.object(HOOP, "found", counting):
        hoopgen.simulate(states, backend="c", threads=1, fields=("outcome",))
    return counter.value / len(states)
