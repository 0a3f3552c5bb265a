"""A study in a process of its own that is killed in the middle of its work."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

_KILLED = """
import os, signal, sys
left, sync = [int(sys.argv[3])], os.fsync

def fsync(descriptor):
    left[0] -= 1
    if left[0] == 0:
        os.kill(os.getpid(), signal.SIGKILL)
    sync(descriptor)

os.fsync = fsync
from hoopgen.studyfile import run_study  # noqa: E402
run_study(sys.argv[1], sys.argv[2], threads=1)
print(int(sys.argv[3]) - left[0])
"""


def run_until_sync(file: Path, results: Path, sync: int) -> subprocess.CompletedProcess[str]:
    """Run a study file until it has written so many files to the disk, and kill it there.

    One that ends before that prints how many it has written.
    """
    command = [sys.executable, "-c", _KILLED, str(file), str(results), str(sync)]
    return subprocess.run(command, capture_output=True, text=True, check=False)
