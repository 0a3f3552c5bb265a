"""Threads whose floating-point environment is not the default one."""

from __future__ import annotations

import ctypes
import gc
import platform
import sys
import threading
from collections.abc import Callable
from typing import Any

import pytest

linux_on_x86 = pytest.mark.skipif(
    sys.platform != "linux" or platform.machine() != "x86_64",
    reason="sets x86's control register by glibc",
)

FLAGS = 0x3F
"""Bits of exceptions that have occurred."""

MODES = {
    "results to zero": 0x8000,
    "operands to zero": 0x0040,
    "down": 0x2000,
    "up": 0x4000,
    "towards zero": 0x6000,
    "all at once": 0xE040,
}
"""Bits of x86's SSE control register: subnormals of results or operands to zero, roundings."""


def in_a_thread(work: Callable[[], Any]) -> Any:
    """Return what work returns, or the error that it raises; what it sets is its thread's.

    Garbage is not collected meanwhile: callbacks that Hypothesis and JAX have registered compute
    with inexact numbers, which sets a flag in whichever thread happens to collect.
    """
    results = []

    def run() -> None:
        try:
            results.append(work())
        except Exception as error:
            results.append(error)

    collected = gc.isenabled()
    gc.disable()
    try:
        thread = threading.Thread(target=run)
        thread.start()
        thread.join()
    finally:
        if collected:
            gc.enable()
    return results[0]


def control() -> int:
    """Return this thread's SSE control register."""
    environment = (ctypes.c_uint32 * 8)()
    ctypes.CDLL(None).fegetenv(environment)
    return environment[7]


def set_control(bits: int, cleared: int = 0) -> None:
    """Set and clear bits of this thread's SSE control register."""
    environment = (ctypes.c_uint32 * 8)()
    c = ctypes.CDLL(None)
    c.fegetenv(environment)
    environment[7] = (environment[7] | bits) & ~cleared
    c.fesetenv(environment)
