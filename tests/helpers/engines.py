"""The engines that behavioural tests are replayed on."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import pytest

import hoopgen
from hoopgen.engine import native
from hoopgen.simulation.hoop import HOOP

Simulate = Callable[..., hoopgen.Shots]

ENGINES = ("numpy", "c", *(f"c, {width} abreast" for width in native.WIDTHS))


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


def engines_here() -> dict[str, Simulate]:
    """Return those of the engines that this build and this processor have."""
    there = {}
    for engine in ENGINES:
        with contextlib.suppress(pytest.skip.Exception):
            there[engine] = simulate_on(engine)
    return there
