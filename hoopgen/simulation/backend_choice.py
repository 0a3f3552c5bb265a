"""The backend of a call: which engine runs it, and whether its arrays stay in a GPU's memory."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from functools import cache
from typing import Any

from hoopgen.core.backend_names import BackendName
from hoopgen.core.parameters import ParameterValues
from hoopgen.engine import native
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.engine.cuda import CudaEngine, to_host

Library = native.Library | CudaEngine
"""An engine that a compiler has made; the other one is NumPy."""


def find_library(
    backend: BackendName, scene: CompiledScene, shots: int, *, bounds: bool
) -> Library | None:
    """Return the engine of a backend for a call; None is NumPy.

    Parameters
    ----------
    backend
        Its name, or "auto".
    scene
        The scene.
    shots
        The number of shots of the call.
    bounds
        Whether the call needs bounds on errors.

    Raises
    ------
    RuntimeError
        If the backend is asked for by name, and is not there or cannot be trusted.
    ImportError
        If it is "cuda" and CuPy is missing: what brings it.
    """
    if backend == "numpy":
        return None
    if backend == "cuda":
        return scene.cuda
    found = scene.found
    if not isinstance(found, native.Rejection):
        if isinstance(found, native.Library) and found.missing_width:
            _warn_of_one_lane(scene.name, found.missing_width)
        return found if bounds else scene.library_without_bounds(shots)
    if backend == "c":
        raise RuntimeError(f"backend: 'c' {found.reason}; {found.remedy}, or use 'numpy'")
    _warn_once(found)
    return None


def device_states(states: Any, scene: CompiledScene, on_host: Mapping[str, bool]) -> Any:
    """Return releases that are in the memory of a GPU, where their results will be, too.

    Parameters
    ----------
    states
        The caller's.
    scene
        The scene.
    on_host
        By argument, whether it is asked for what is computed in this machine's memory.

    Raises
    ------
    TypeError, ValueError
        If something else is asked for, or they are not float64 of shape (n, 9) or (9,).
    """
    for name, asked in on_host.items():
        if asked:
            raise ValueError(
                f"{name}: expected with states of NumPy, and these are in the memory of a GPU; "
                "cupy.asnumpy(states) copies them"
            )
    return scene.cuda.states(states)


def host_parameters(parameters: ParameterValues | None) -> ParameterValues | None:
    """Return parameters with those of NumPy in place of arrays in the memory of a GPU."""
    if not isinstance(parameters, Mapping):
        return parameters
    return {name: to_host(value) for name, value in parameters.items()}


@cache
def _warn_once(refused: native.Rejection) -> None:
    print(
        f"hoopgen: the C engine {refused.reason}; {refused.remedy}. NumPy serves, slower.",
        file=sys.stderr,
    )


@cache
def _warn_of_one_lane(scene: str, width: int) -> None:
    print(
        f"hoopgen: the C engine of {scene} was compiled for a processor with {width} lanes, which "
        "this one has not. One lane serves, slower; install hoopgen again on this machine.",
        file=sys.stderr,
    )
