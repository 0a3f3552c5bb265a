"""The targets, by name: every list of targets comes from here."""

from __future__ import annotations

from .backend import Backend
from .c import C_BACKEND
from .cuda import CUDA_BACKEND
from .js import JS_BACKEND
from .numpy import NUMPY_BACKEND

BACKENDS: dict[str, Backend] = {}
"""The registered targets, by name, in the order in which their files are written."""


def register(backend: Backend) -> None:
    """Add a target.

    Raises
    ------
    ValueError
        If there is one of this name, or one of its files is another target's.
    """
    if backend.name in BACKENDS:
        raise ValueError(f"target {backend.name!r} is registered already")
    for other in BACKENDS.values():
        if common := set(backend.files.values()) & set(other.files.values()):
            files = ", ".join(sorted(common))
            raise ValueError(
                f"target {backend.name!r} would write files of {other.name!r}: {files}"
            )
    BACKENDS[backend.name] = backend


for _backend in (NUMPY_BACKEND, C_BACKEND, CUDA_BACKEND, JS_BACKEND):
    register(_backend)
