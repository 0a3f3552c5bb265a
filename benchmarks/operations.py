"""How many operations hoopgen spends on a shot: its C, compiled with a counter in every kernel."""

import ctypes
import re
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from benchmarks.peers.native import COMPILER, OUR_FLAGS, SCENE
from benchmarks.workloads import States
from hoopgen import PAPER

GENERATED = Path(__file__).parents[1] / "generated" / "c"
ARITHMETIC = ("addition", "subtraction", "multiplication", "division", "square root")

# A kernel: the comment that counts its operations, "11 operations: 3 additions, ...", and its head.
_KERNEL = re.compile(
    r"/\*(?P<comment>(?:(?!\*/).)*)\*/\s*typedef struct.*?\nLANES\(\w+\)\([^)]*\)\n\{\n", re.DOTALL
)
_COUNT = re.compile(r"(\d+) ([a-z ]+?)s?[,.]")


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
        library = ctypes.CDLL(str(target))
    values = np.array([PAPER[name] for name in SCENE])
    pointers = values.ctypes.data + 8 * np.arange(len(SCENE), dtype=np.uint64)
    strides = np.zeros(len(SCENE), np.int64)
    nothing_wanted = np.zeros(32, np.uint64)
    rows = np.ascontiguousarray(states)
    width = library.hoop_simulate(
        ctypes.c_size_t(len(rows)),
        ctypes.c_void_p(rows.ctypes.data),
        ctypes.c_void_p(pointers.ctypes.data),
        ctypes.c_void_p(strides.ctypes.data),
        ctypes.c_int32(40),
        ctypes.c_int(1),
        None,
        ctypes.c_void_p(nothing_wanted.ctypes.data),
    )
    assert width == 1
    return ctypes.c_double.in_dll(library, "hoop_counter").value / len(rows)
