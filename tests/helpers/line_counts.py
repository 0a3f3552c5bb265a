"""Count what the shots of reaching.py reach of a scene's generated engines.

`python -m tests.helpers.line_counts SCENE numpy` prints the counts as JSON, and so does
`python -m tests.helpers.line_counts SCENE c`, which compiles the C engine for it.
"""

from __future__ import annotations

import ctypes
import importlib
import json
import math
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path
from typing import Any

from tests.helpers import ROOT


def count_numpy(scene: str) -> dict[str, Any]:
    """Return what is reached of the NumPy module; nothing may have imported it before."""
    import coverage

    counted = coverage.Coverage(
        branch=True, data_file=None, config_file=False, include=[f"*/generated/numpy/{scene}.py"]
    )
    counted.start()
    from tests.helpers import reaching

    reaching.simulate_all(scene, "numpy")
    reaching.call_kernels(importlib.import_module(f"hoopgen.generated.numpy.{scene}"))
    counted.stop()
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        counted.json_report(outfile=str(report))
        (found,) = json.loads(report.read_text("utf-8"))["files"].values()
    summary = found["summary"]
    return {
        "lines": summary["num_statements"],
        "branches": summary["num_branches"],
        "missing_branches": summary["missing_branches"],
        "missing": _texts(ROOT / "generated" / "numpy" / f"{scene}.py", found["missing_lines"]),
    }


def count_c(scene: str) -> dict[str, Any]:
    """Return what is reached of the C sources, one lane and four lanes wide together."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        library = folder / f"{scene}.so"
        source = ROOT / "generated" / "c" / f"{scene}.c"
        flags = ["-std=c11", "-ffp-contract=off", "-O0", "-fPIC", "--coverage", "-Wno-psabi"]
        only = f"-D{scene.upper()}_WIDEST=4"
        subprocess.run(
            ["gcc", *flags, only, "-c", source, "-o", f"{scene}.o"], cwd=folder, check=True
        )
        linked = ["gcc", "--coverage", "-shared", f"{scene}.o", "-o", library, "-lm"]
        subprocess.run(linked, cwd=folder, check=True)
        # The counts are written when a process ends.
        command = [sys.executable, "-m", "tests.helpers.line_counts", scene, str(library)]
        subprocess.run(command, cwd=ROOT, check=True)
        said = subprocess.run(
            ["gcov", "--json-format", "--stdout", f"{scene}.gcda"],
            cwd=folder,
            check=True,
            capture_output=True,
            text=True,
        )
    files = json.loads(said.stdout)["files"]
    # Both loops are compiled from one text: each must reach every line of its own.
    lines: dict[tuple[str, int, str], int] = defaultdict(int)
    for file in files:
        path = Path(file["file"]).name
        for line in file["lines"] if (ROOT / "generated" / "c" / path).is_file() else ():
            function = line.get("function_name", "").rpartition("_w")[0]
            lines[path, line["line_number"], function] += line["count"]
    missing = [
        text
        for path in sorted({path for path, _, _ in lines})
        for text in _texts(
            ROOT / "generated" / "c" / path,
            [line for (own, line, _), often in sorted(lines.items()) if own == path and not often],
        )
    ]
    return {
        "lines": len(lines),
        "missing": missing,
    }


def _texts(path: Path, numbers: list[int]) -> list[str]:
    """Return lines of a file, with where they are."""
    text = path.read_text("utf-8").splitlines()
    return [f"{path.name}:{number}: {text[number - 1].strip()}" for number in numbers]


def _run_in(scene: str, library: str) -> None:
    """Simulate the shots with a library, one and four lanes wide, and hand it bad arguments."""
    import hoopgen
    from benchmarks.workloads import WORKLOADS
    from hoopgen.engine import native
    from tests.engine.test_c_interface import BAD, Call
    from tests.helpers import reaching
    from tests.helpers.engines import OfWidth

    engine = {"hoop": hoopgen.HOOP, "court": hoopgen.COURT}[scene]
    own = native.Library(Path(library), engine.kernels)
    for width in (1, 4):
        vars(engine)["found"] = OfWidth(own, width)
        reaching.simulate_all(scene, "c")
    vars(engine)["found"] = own
    for changed in (*(wrong for wrong, _ in BAD), {"width": 16}):
        Call(engine)(**changed)
    call = Call(engine)
    call.leaving[0] = 127
    call()
    call = Call(engine)
    call.strides[-1] = 2
    call()
    call = Call(engine)  # swishes, without a limit of time that the package would set
    call.states[:] = WORKLOADS[0].make(len(call.states))
    unrecorded = call.results("events", "event_counts", "time_error", "state_error")
    call(width=1, time_limit=math.inf, leaving=None, results=unrecorded)
    call = Call(engine)
    call(results=call.results("event_counts"))
    call(shots=1 << 40, max_contacts=1 << 20, leaving=None)  # too many rows of the log
    call(shots=0)
    plain = ctypes.CDLL(library)
    sources = getattr(plain, f"{scene}_sources")
    sources()
    getattr(plain, f"{scene}_missing_width")()
    once = getattr(plain, f"{scene}_simulate")
    call = Call(engine)
    once.argtypes = own._simulate.argtypes[:-2]
    once(*[*call.given.values()][:-2])


if __name__ == "__main__":
    if sys.argv[2] in ("numpy", "c"):
        print(json.dumps({"numpy": count_numpy, "c": count_c}[sys.argv[2]](sys.argv[1])))
    else:
        _run_in(*sys.argv[1:])
