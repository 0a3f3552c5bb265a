"""Ctrl-C stops a batch that would take days, on every engine."""

from __future__ import annotations

import enum
import os
import signal
import subprocess
import sys
from types import FrameType
from typing import Any

import pytest

import hoopgen
from hoopgen.simulation.court import COURT
from hoopgen.simulation.hoop import HOOP

# An interrupt while a module is imported can end Python with the signal's status although it is
# caught: CPython remembers one that leaves an `exec` of a text, as dataclasses are made by.
BOUNCING = """
import hoopgen

states = [[-0.3, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]] * 64  # above the bridge
forever = {"max_contacts": 2**31 - 1, "backend": "%s", "threads": %d}
hoopgen.simulate(states, **forever | {"max_contacts": 40})  # imports what it needs
try:
    print("begun", flush=True)
    hoopgen.simulate(states, hoopgen.PAPER | {"restitution": 1.0}, **forever)
except KeyboardInterrupt:
    print("stopped", flush=True)
"""


ROLLING = """
import hoopgen

states = [[4.191, 0.0, -0.6096, -4.416290204654659, 0.07983296977604547, 5.210307727362474,
           0.34068644728053055, 18.846476890492195, 0.0]] * %d  # it comes to swirl in the ring
soft = {f"{body}_restitution": 0.2 for body in hoopgen.COURT.surfaces}
options = {"scene": hoopgen.COURT, "time_limit": 1e12, "backend": "%s", "threads": %s}
hoopgen.simulate(states, hoopgen.PAPER_COURT | soft, **options | {"time_limit": 1.0})
try:
    print("begun", flush=True)
    hoopgen.simulate(states, hoopgen.PAPER_COURT | soft, **options, record=%s)
except KeyboardInterrupt:
    print("stopped", flush=True)
"""

FLYING = ("advance", "_record", "_states", "_ended", "_finish")
"""Functions of the driver in NumPy that run at every event."""

needs_signals = pytest.mark.skipif(
    os.name == "nt", reason="no SIGINT can be sent to another process"
)


@pytest.mark.sampled(1)
@needs_signals
@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_ctrl_c_stops_a_long_batch(backend: str, threads: int) -> None:
    if backend == "c" and HOOP.library is None:
        pytest.skip("the C engine was not built")
    assert_stops(BOUNCING % (backend, threads))


@needs_signals
@pytest.mark.parametrize("record", [False, True])
@pytest.mark.parametrize("threads", [1, None])
@pytest.mark.parametrize("shots", [1, 3])
@pytest.mark.parametrize("backend", ["c", "numpy"])
@pytest.mark.slow
def test_ctrl_c_stops_a_few_shots_that_roll(
    backend: str, shots: int, threads: int | None, record: bool
) -> None:
    if backend == "c" and COURT.library is None:
        pytest.skip("the C engine was not built")
    assert_stops(ROLLING % (shots, backend, threads, record))


@pytest.mark.parametrize("record", [False, True])
def test_no_code_of_an_enumeration_runs_between_events_in_numpy(record: bool) -> None:
    # NumPy asks an enumeration's member for attributes and drops any error that this raises, and
    # so would lose a Ctrl-C that arrives in the enumeration's own Python code.
    called = []

    def note(frame: FrameType, event: str, _: Any) -> None:
        if event == "call" and frame.f_code.co_filename == enum.__file__:
            caller = frame.f_back
            if caller is not None and caller.f_code.co_name in FLYING:
                called.append((caller.f_code.co_name, frame.f_code.co_name))

    state = [[-0.3, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]]  # above the bridge
    hoopgen.simulate(state, backend="numpy", record=record)
    sys.setprofile(note)
    try:
        shots = hoopgen.simulate(state, backend="numpy", record=record)
    finally:
        sys.setprofile(None)
    assert shots.contacts[0] > 0
    assert called == []


def assert_stops(script: str) -> None:
    command = [sys.executable, "-c", script]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "begun\n"
        with pytest.raises(subprocess.TimeoutExpired):
            process.wait(timeout=0.5)  # it is under way
        process.send_signal(signal.SIGINT)
        try:
            said, _ = process.communicate(timeout=60)  # far more than it takes, far less than days
        finally:
            process.kill()
    assert said == "stopped\n"
    assert process.returncode == 0
