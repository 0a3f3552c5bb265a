"""The names of the backends: the targets that run in this process."""

from __future__ import annotations

from typing import Literal, get_args

BackendName = Literal["auto", "c", "numpy", "cuda"]
"""Name of a backend: a target that runs in this process, or "auto" for the faster of those on the
processor. The registry of targets needs SymPy, so that a test compares the names."""

BACKEND_NAMES: tuple[BackendName, ...] = get_args(BackendName)
RUNTIME_BACKENDS = BACKEND_NAMES[1:]
"""Names of the targets that run in this process: the faster of those on the processor first, then
those that are used by name only."""
