"""Ctrl-C stops a batch that would take days, on every engine."""

from __future__ import annotations

import os
import signal
import subprocess
import sys

import pytest

from hoopgen.engines import HOOP

BOUNCING = """
import hoopgen

states = [[-0.3, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]] * 64  # above the bridge
forever = {"max_contacts": 2**31 - 1, "backend": "%s", "threads": %d}
try:
    print("begun", flush=True)
    hoopgen.simulate(states, hoopgen.PAPER | {"restitution": 1.0}, **forever)
except KeyboardInterrupt:
    print("stopped", flush=True)
"""


@pytest.mark.skipif(os.name == "nt", reason="no SIGINT can be sent to another process")
@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_ctrl_c_stops_a_long_batch(backend: str, threads: int) -> None:
    if backend == "c" and HOOP.library is None:
        pytest.skip("the C engine was not built")
    command = [sys.executable, "-c", BOUNCING % (backend, threads)]
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
