"""A contender in a process of its own: serves requests, a line of JSON each, until the last.

Run by its path, with the folder to import hoopgen from, or none for the installed one. It may be
the hoopgen of any commit, so all that is asked of it is `hoopgen.simulate`; and, for the widths of
the C engine, that some class has a method `run` with a parameter `width`, and that a ValueError
refuses a width that is not there.
"""

import importlib
import inspect
import json
import os
import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from time import perf_counter, process_time
from typing import Any

import numpy as np

WIDTHS = (1, 2, 4, 8, 16)
TOO_WIDE = 1 << 10
MAX_CONTACTS = 40

Request = dict[str, Any]


def _import(home: str) -> Any:
    """Return hoopgen, all of it from that folder."""
    if home:
        sys.path.insert(0, home)
        # Those of an editable installation would give what only the working tree has.
        sys.meta_path[:] = [
            finder
            for finder in sys.meta_path
            if not getattr(finder, "__module__", "").startswith("__editable__")
        ]
    hoopgen = importlib.import_module("hoopgen")
    if home and not Path(str(hoopgen.__file__)).is_relative_to(home):
        raise ImportError(f"hoopgen: expected it in {home}, found {hoopgen.__file__}")
    return hoopgen


def _of_width() -> list[tuple[type, Callable[..., Any]]]:
    """Every class of hoopgen that runs with a width, and its method."""
    modules = [module for name, module in sys.modules.items() if name.startswith("hoopgen.")]
    classes = {
        cls
        for module in modules
        for cls in vars(module).values()
        if isinstance(cls, type) and inspect.isfunction(vars(cls).get("run"))
    }
    runs = [(cls, vars(cls)["run"]) for cls in classes]
    return [(cls, run) for cls, run in runs if "width" in inspect.signature(run).parameters]


def _held(run: Callable[..., Any], width: int) -> Callable[..., Any]:
    def held(*arguments: Any, **options: Any) -> Any:
        return run(*arguments, **{**options, "width": width})

    return held


class Contender:
    """One hoopgen and the shots that it was given last."""

    def __init__(self, home: str) -> None:
        self._hoopgen = _import(home)
        self._states = np.zeros((1, 9))
        self._states[0, 2] = 1.0
        self._parameters: dict[str, Any] = {}
        self._runs: list[tuple[type, Callable[..., Any]]] = []

    def _hold(self, engine: str) -> str:
        """Hold the C engine to the width in an engine's name; return the backend."""
        backend, _, width = engine.partition(" ")
        for cls, run in self._runs:
            cls.run = _held(run, int(width)) if width else run  # type: ignore[attr-defined]
        return backend

    def _has(self, engine: str) -> bool:
        try:
            self._hoopgen.simulate(self._states, backend=self._hold(engine))
        except (RuntimeError, ValueError):
            return False
        return True

    def engines(self, _: Request) -> list[str]:
        """Return which engines there are: "numpy", "c" at its widest, and "c 4" and the like."""
        there = [engine for engine in ("numpy", "c") if self._has(engine)]
        self._runs = _of_width()
        if "c" in there and not self._has(f"c {TOO_WIDE}"):
            there += [f"c {width}" for width in WIDTHS if self._has(f"c {width}")]
        return there

    def load(self, request: Request) -> int:
        """Take states and parameters from the files that are named."""
        with np.load(request["file"]) as file:
            self._states = file["states"]
            self._parameters = {
                name: file[name] if file[name].ndim else float(file[name])
                for name in file.files
                if name != "states"
            }
        return len(self._states)

    def _fly(self, request: Request) -> Callable[[], Any]:
        rows = slice(*request["rows"])
        own = {n: v[rows] if np.ndim(v) else v for n, v in self._parameters.items()}
        states, fields = self._states[rows], request["fields"]
        options = {
            "max_contacts": MAX_CONTACTS,
            "backend": self._hold(request["engine"]),
            "threads": request["threads"],
            "fields": fields if fields == "all" else tuple(fields),
            "record": request.get("record", False),
        }
        return lambda: self._hoopgen.simulate(states, own, **options)

    def fly(self, request: Request) -> list[str]:
        """Fly some rows and write each field into a file; return the fields' names."""
        shots = self._fly(request)()
        names = [*request["fields"], *(["events"] if request["record"] else [])]
        for name in names:
            np.save(Path(request["out"], f"{name}.npy"), getattr(shots, name))
        return names

    def time(self, request: Request) -> dict[str, float]:
        """Fly some rows some times over; return the seconds of a flight, of clock and processor."""
        fly, repeats = self._fly(request), request["repeats"]
        wall, cpu = perf_counter(), process_time()
        for _ in range(repeats):
            fly()
        cpu, wall = process_time() - cpu, perf_counter() - wall
        return {"wall": wall / repeats, "cpu": cpu / repeats}


def main() -> None:
    """Serve; what hoopgen itself prints goes to the error stream."""
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    contender: Contender | None = None
    for line in sys.stdin:
        try:
            request = json.loads(line)
            if contender is None:
                contender = Contender(sys.argv[1] if len(sys.argv) > 1 else "")
            answer = {"answer": getattr(contender, request["do"])(request)}
        except Exception:
            answer = {"error": traceback.format_exc()}
        print(json.dumps(answer), file=answers, flush=True)


if __name__ == "__main__":
    main()
