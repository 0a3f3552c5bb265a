"""Any thread gets the same bits, and has its floating-point environment afterwards."""

from __future__ import annotations

import ctypes
import math
import os
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.engine import arithmetic, native
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.hoop import HOOP, hoop_library, hoop_releases
from tests.helpers.compiled import needs_compiler, shared_library
from tests.helpers.environment import (
    FLAGS,
    MODES,
    control,
    in_a_thread,
    linux_on_x86,
    set_control,
)

pytestmark = linux_on_x86

STATES = hoop_releases()[::4]
TABLE = {"restitution": np.linspace(0.6, 0.9, len(STATES)), "ball_radius": 0.12}
OPTIONS: dict[str, dict[str, Any]] = {
    "plain": {},
    "recorded": {"record": True},
    "a table": {"parameters": TABLE},
    "bounds": {"fields": ("state", "time", "uncertain", "time_error", "state_error")},
    "threads": {"threads": 3, "record": True},
}
BACKENDS: tuple[Any, ...] = ("c", "numpy")


def bits(shots: hoopgen.Shots) -> dict[str, bytes]:
    """Return all that shots have, as bytes."""
    return {name: np.asarray(array).tobytes() for name, array in shots._fields.items()}


def altered(mode: int, work: Callable[[], Any]) -> Any:
    """Return what work returns in a thread of that mode, in which it is afterwards, flags too."""

    def inside() -> Any:
        set_control(mode | FLAGS)
        before = control()
        found = work()
        assert control() == before
        return found

    found = in_a_thread(inside)
    if isinstance(found, Exception):
        raise found
    return found


def need_library(engine: Engine) -> native.Library:
    if engine.library is None:
        pytest.skip("the C engine was not built")
    return engine.library


@cache
def usual_bits(backend: Any, options: str) -> dict[str, bytes]:
    """Return all that the shots have in a thread of the usual mode."""
    return bits(HOOP.simulate(STATES, backend=backend, **OPTIONS[options]))


@pytest.mark.sampled(2)
@pytest.mark.parametrize("options", OPTIONS)
@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("backend", BACKENDS)
def test_a_thread_in_any_mode_gets_the_same_bits(backend: Any, mode: str, options: str) -> None:
    need_library(HOOP)
    given = {"backend": backend, **OPTIONS[options]}
    found = altered(MODES[mode], lambda: HOOP.simulate(STATES, **given))
    assert bits(found) == usual_bits(backend, options)


@pytest.mark.parametrize("backend", BACKENDS)
def test_balls_roll_as_they_do_in_any_thread(backend: Any) -> None:
    need_library(hoopgen.COURT)
    given: Any = {"time_limit": 1.0, "record": True, "backend": backend}
    usual = hoopgen.COURT.simulate(STATES[::4], **given)
    found = altered(MODES["all at once"], lambda: hoopgen.COURT.simulate(STATES[::4], **given))
    assert bits(found) == bits(usual)


@pytest.mark.slow
def test_threads_that_an_altered_thread_started_compute_as_they_should() -> None:
    """A new thread has the modes of the one that starts it, and the pool keeps it."""
    need_library(HOOP)
    many = np.tile(STATES, (-(-10_000 // len(STATES)), 1))
    given: Any = {"backend": "numpy", "threads": 2, "fields": ("state",)}
    usual = HOOP.simulate(many, **given)
    found = altered(MODES["up"], lambda: HOOP.simulate(many, **given))
    assert bits(found) == bits(usual) == bits(HOOP.simulate(many, **given))


@pytest.mark.sampled(1)
@pytest.mark.parametrize("mode", [0x400, 0x800, 0xC00])
@pytest.mark.parametrize("backend", BACKENDS)
def test_a_rounding_mode_of_the_c_library_stays(backend: Any, mode: int) -> None:
    need_library(HOOP)
    c = ctypes.CDLL(None)

    def work() -> tuple[hoopgen.Shots, int]:
        assert c.fesetround(mode) == 0
        return HOOP.simulate(STATES, TABLE, backend=backend), c.fegetround()

    shots, after = in_a_thread(work)
    assert after == mode
    assert bits(shots) == bits(HOOP.simulate(STATES, TABLE, backend=backend))


@needs_compiler
@pytest.mark.parametrize("backend", BACKENDS)
def test_a_thread_that_loads_a_library_of_fast_math_gets_the_same_bits(
    backend: Any, tmp_path: Path
) -> None:
    """Linking with -ffast-math does this, before GCC 13."""
    need_library(HOOP)
    source = tmp_path / "fast.c"
    source.write_text(
        "#include <xmmintrin.h>\n"
        "__attribute__((constructor)) static void set(void)\n"
        "{ _mm_setcsr(_mm_getcsr() | 0x8040); }\n",
        encoding="utf-8",
    )
    library = shared_library(source)

    def work() -> tuple[hoopgen.Shots, bool]:
        ctypes.CDLL(str(library))
        assert not arithmetic.is_exact()
        return HOOP.simulate(STATES, backend=backend), arithmetic.is_exact()

    shots, exact = in_a_thread(work)
    assert not exact
    assert bits(shots) == bits(HOOP.simulate(STATES, backend=backend))


def of_library(library: native.Library, **changed: Any) -> dict[str, bytes]:
    """Return the results of a call of the library, as bytes."""
    out = HOOP.layout.allocate(len(STATES), ("state", "outcome", "time_error"))
    given: dict[str, Any] = {
        "states": np.ascontiguousarray(STATES),
        "parameters": HOOP.table.inputs(dict(HOOP.table.defaults)),
        "leaving": None,
        "max_contacts": 40,
        "out": out,
        "stop": np.zeros(1, np.int32),
    }
    library.run(**given | changed)
    return {name: array.tobytes() for name, array in out.arrays.items()}


@pytest.mark.parametrize("width", native.WIDTHS)
def test_a_call_of_c_sets_the_environment_itself(width: int) -> None:
    """Traps of the exceptions that some shots raise are not sprung: an infinite state, a NaN."""
    library = need_library(HOOP)
    states = np.array(STATES)
    states[::7, 0] = math.inf
    states[1::7, 4] = math.nan
    try:
        usual = of_library(library, states=states, width=width)
    except ValueError:
        pytest.skip("this processor does not have the width")
    mode, traps = MODES["all at once"], 0x0E80

    def work() -> dict[str, bytes]:
        set_control(mode, traps | FLAGS)
        before = control()
        found = of_library(library, states=states, width=width)
        after = control()
        set_control(traps, mode)
        assert after == before
        return found

    assert in_a_thread(work) == usual


@pytest.mark.parametrize(
    "wrong", [{"max_contacts": 0}, {"width": 3}, {"time_limit": math.nan}, {"time_limit": -1.0}]
)
def test_a_call_of_c_that_is_refused_restores_it_too(wrong: dict[str, Any]) -> None:
    library = need_library(HOOP)

    def work() -> None:
        with pytest.raises(ValueError, match=r"expected|width"):
            of_library(library, **wrong)

    altered(MODES["all at once"], work)


def test_a_tiny_time_limit_is_a_time_limit_where_subnormals_are_zero() -> None:
    """Arguments are looked at in the default environment."""
    library = need_library(HOOP)
    found = altered(MODES["operands to zero"], lambda: of_library(library, time_limit=5e-324))
    assert found == of_library(library, time_limit=5e-324)


def test_an_error_restores_the_environment() -> None:
    need_library(HOOP)

    def work() -> None:
        with pytest.raises(ValueError, match="states"):
            HOOP.simulate(STATES[:, :5])

    altered(MODES["down"], work)


def test_an_engine_is_found_in_a_thread_that_computes_otherwise() -> None:
    """The comparison with NumPy is done in the default environment."""
    need_library(HOOP)
    assert isinstance(altered(MODES["all at once"], hoop_library), native.Library)


def test_without_a_c_engine_the_thread_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(HOOP, "found", native.Rejection("was not built", ""))

    def work() -> object:
        set_control(0x8040)
        return HOOP.simulate(STATES, backend="numpy")

    error = in_a_thread(work)
    assert isinstance(error, RuntimeError)
    assert "rounds otherwise than to the nearest double, or takes subnormals for zero" in str(error)
    assert HOOP.simulate(STATES, backend="numpy").outcome.size == len(STATES)


@pytest.mark.slow
@pytest.mark.parametrize("mode", [0x400, 0x800, 0xC00])
def test_modules_imported_in_another_mode_have_the_usual_constants(
    mode: int, tmp_path: Path
) -> None:
    """Without stored bytecode Python reads the constants of a module when it is imported."""
    backends = [one for one in BACKENDS if one == "numpy" or HOOP.library]
    code = f"""
import ctypes, hoopgen
set_mode = ctypes.CDLL(None).fesetround
set_mode({mode})
states = [4.191, 0, -0.6096, -4.5, 0, 5.577, 0, 18.8, 0]
found = [hoopgen.simulate(states, backend=b).state.tobytes().hex() for b in {backends}]
assert ctypes.CDLL(None).fegetround() == {mode}
set_mode(0)
print(*found)
"""
    environment = os.environ | {
        "PYTHONPYCACHEPREFIX": str(tmp_path),
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    command = [sys.executable, "-c", code]
    ran = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    states = [4.191, 0, -0.6096, -4.5, 0, 5.577, 0, 18.8, 0]
    wanted = hoopgen.simulate(states, backend="numpy").state.tobytes().hex()
    assert set(ran.stdout.split()) == {wanted}
