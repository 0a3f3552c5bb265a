"""Operations of hoopgen's C for a shot, counted in kernels and search."""

import ctypes
import re
import subprocess
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unittest.mock import patch

import hoopgen
from benchmarks.peers.native import COMPILER, OUR_FLAGS
from benchmarks.workloads import States
from hoopgen.engine import native
from hoopgen.engine.c_build import source_files
from hoopgen.engine.verification import available_widths
from hoopgen.simulation.hoop import HOOP

GENERATED = Path(__file__).parents[1] / "generated" / "c"
ARITHMETIC = ("addition", "subtraction", "multiplication", "division", "square root")
DIVIDER = ("division", "square root")

# A kernel: the comment that counts its operations, "11 operations: 3 additions, ...", and its head.
_KERNEL = re.compile(
    r"/\*(?P<comment>(?:(?!\*/).)*)\*/\s*typedef struct.*?\nLANES\((?P<name>\w+)\)\([^)]*\)\n\{\n",
    re.DOTALL,
)
_COUNT = re.compile(r"(\d+) ([a-z ]+?)s?[,.]")
_TURNS = ("M stepping = active;", "M searching = active;")
"""First lines of an iteration of the event loop's search, in single and in double precision."""
_EVALUATIONS = ("hoop_ring_step", "hoop_ring_advance")
"""The kernels that evaluate the gap and its bound, in single precision and in double."""


@dataclass(frozen=True)
class Counts:
    """Counts per shot: all arithmetic, divisions and roots, evaluations of the search in either
    precision, and the share of the lanes that are busy in its turns at the widest."""

    operations: float
    divisions: float
    roots: float
    evaluations: float
    busy: float


class OfWidth(native.Library):
    """A compiled scene, run at one width."""

    width = 0

    def run(self, *arguments: Any, **named: Any) -> None:
        """Simulate shots."""
        super().run(*arguments, **(named | {"width": self.width}))


def _with_counter(kernel: re.Match[str]) -> str:
    counts = {what: int(count) for count, what in _COUNT.findall(kernel["comment"])}
    lines = [f"hoop_count[0] += {sum(counts.get(what, 0) for what in ARITHMETIC)};"]
    lines += [f"hoop_count[{k}] += {counts.get(w, 0)};" for k, w in enumerate(DIVIDER, start=1)]
    if kernel["name"] in _EVALUATIONS:
        lines.append("hoop_count[3]++;")
    return kernel[0] + "".join(f"    {line}\n" for line in lines)


def _in_kernels(name: str, text: str) -> str:
    return _KERNEL.sub(_with_counter, text) if name == "hoop_kernels.h" else text


def _in_search(name: str, text: str) -> str:
    if name != "hoop_loop.h":
        return text
    counters = "hoop_count[4] += (double)busy; hoop_count[5] += LANES_WIDTH;"
    for turn in _TURNS:
        if turn not in text:
            raise ValueError(f"{name} has no line {turn!r}")
        text = text.replace(turn, f"{turn} {counters}")
    return text


def _counted(states: States, width: int, change: Callable[[str, str], str]) -> list[float]:
    """Return the counters after shots at a width, with changed sources."""
    with tempfile.TemporaryDirectory() as folder:
        for source in source_files(GENERATED, "hoop"):
            text = change(source.name, source.read_text(encoding="utf-8"))
            if source.name == "hoop.c":
                text = f"double hoop_count[6];\n{text}"
            (Path(folder) / source.name).write_text(text, encoding="utf-8")
        target = Path(folder) / "counting.so"
        # Counts do not depend on the optimisation, and the compiler is soon done without.
        options = ["-O1", "-w", f"-DHOOP_ONLY={width}", "-shared", "-fPIC"]
        command = [*COMPILER, *OUR_FLAGS, *options, f"{folder}/hoop.c"]
        subprocess.run([*command, "-o", str(target), "-lm"], check=True)
        counting = OfWidth(target, HOOP.kernels)
        counting.width = width
        counters = (ctypes.c_double * 6).in_dll(ctypes.CDLL(str(target)), "hoop_count")
    with patch.object(HOOP, "found", counting):
        hoopgen.simulate(states, backend="c", threads=1, fields=("outcome",))
    return list(counters)


def operations(states: States) -> Counts | None:
    """Arithmetic a shot in hoopgen's kernels, without the event loop's comparisons and choices;
    None where there are no sources. One lane: what the lanes of a vector do for each other's sake
    is not counted, but how many of them are busy is, at the widest."""
    if not GENERATED.is_dir():
        return None
    first, second, third, fourth, *_ = (
        count / len(states) for count in _counted(states, 1, _in_kernels)
    )
    widest = available_widths(HOOP.library, HOOP.kernels)[-1] if HOOP.library else 1
    *_, busy, lanes = _counted(states, widest, _in_search)
    return Counts(first, second, third, fourth, busy / lanes if lanes else float("nan"))
