"""The engines that behavioural tests are replayed on."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import pytest

import hoopgen
from hoopgen.core.backend_names import RUNTIME_BACKENDS
from hoopgen.engine import elementary, native
from hoopgen.simulation.hoop import HOOP
from tests.helpers.host_cuda import HostCuPy, has_compiler, on_host

Simulate = Callable[..., hoopgen.Shots]

ENGINES = (*RUNTIME_BACKENDS, *(f"c, {width} abreast" for width in native.WIDTHS))


@dataclass(frozen=True)
class OfWidth:
    """The C engine, held to one vector width."""

    library: native.Library
    width: int

    def run(self, *arguments: Any, **options: Any) -> None:
        self.library.run(*arguments, **options, width=self.width)


def simulate_on(engine: str) -> Simulate:
    """Return `hoopgen.simulate` on one engine; skip the test where it is not there."""
    if engine == "numpy":
        return partial(hoopgen.simulate, backend="numpy")
    if engine == "cuda":
        if not has_compiler():
            pytest.skip("no C++ compiler")
        return _simulate_on_host
    library = HOOP.library
    if library is None:
        pytest.skip("the C engine was not built")
    if engine == "c":
        return partial(hoopgen.simulate, backend="c")
    held = OfWidth(library, int(engine.split()[1]))

    def simulate(*arguments: Any, **options: Any) -> hoopgen.Shots:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(HOOP, "found", held)
            return hoopgen.simulate(*arguments, backend="c", **options)

    try:
        simulate([0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    except ValueError:
        pytest.skip("this processor does not have the width")
    return simulate


_HOST = HostCuPy()
"""The stand-in for a GPU; the scene is compiled once."""


def _simulate_on_host(*arguments: Any, **options: Any) -> hoopgen.Shots:
    """Simulate with the CUDA source and its driver, on this processor."""
    with on_host(HOOP, _HOST):
        return hoopgen.simulate(*arguments, backend="cuda", **options)


def engines_here() -> dict[str, Simulate]:
    """Return those of the engines that this build and this processor have."""
    there = {}
    for engine in ENGINES:
        with contextlib.suppress(pytest.skip.Exception):
            there[engine] = simulate_on(engine)
    return there


def elementary_library() -> elementary.Library:
    """Return the C library of the elementary functions; skip the test if it was not built."""
    found = elementary.library()
    if found is None:
        pytest.skip("the C library was not built")
    return found
