"""Commands in processes of their own, with limits: how they ended, and what they said.

A server that has imported everything forks one for each, so that a command takes milliseconds and
takes nobody with it.
"""

import contextlib
import multiprocessing
import os
import resource
import shlex
import signal
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path

Entry = Callable[[list[str]], object]
"""A command line: takes arguments, ends as a program does."""

SECONDS = 20.0
"""Time limit of a small command on a busy machine, s; it usually takes one second."""

MEMORY = 4 << 30
"""Bytes of address space; libraries and threads take one of the four."""

_FILE_SIZE = 1 << 28
_SAID = 1 << 20

_HEEDS = 10.0
"""Seconds from Ctrl-C to the end."""

_ALLOWED = {0, 1, 2, 70}
_UNFORESEEN = 70

_CONTEXT = multiprocessing.get_context("forkserver")
_CONTEXT.set_forkserver_preload(
    [
        "hoopgen.cli",
        "hoopgen.judge",
        "hoopgen.plots",
        "hoopgen.study.questions.batch",
        "hoopgen.study.questions.compare",
        "hoopgen.study.questions.estimate",
        "hoopgen.study.questions.map",
        "hoopgen.study.questions.optimum",
        "hoopgen.studyfile",
        "matplotlib.pyplot",
        "scipy.optimize",
        "scipy.stats",
        "xarray",
    ]
)


@dataclass(frozen=True)
class Ended:
    """A process that has ended: its status, below 0 for a signal, and what it wrote.

    `late` says that it was still at work when its time was up.
    """

    status: int
    out: bytes
    err: str
    late: bool = False

    @property
    def unforeseen(self) -> bool:
        """True if it ended with an error that no check foresaw, and said so."""
        return self.status == _UNFORESEEN


def hoopgen(arguments: list[str]) -> None:
    """Return the command line."""
    from hoopgen.cli import main

    main(arguments)


def said(arguments: Sequence[str]) -> str:
    """Return a command line as one types it, on one line."""
    text = shlex.join(["hoopgen", *arguments])
    text = text if len(text) <= 400 else f"{text[:400]}..."
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text)


def run(
    arguments: Sequence[str],
    folder: Path,
    *,
    entry: Entry = hoopgen,
    seconds: float = SECONDS,
    last: signal.Signals = signal.SIGKILL,
) -> Ended:
    """Run a command in ``folder/work``; its output lies in `folder`.

    When its time is up it gets the signal `last`, and, if it does not heed that, SIGKILL. Its time
    begins when its process has imported what it is to run.
    """
    (folder / "work").mkdir(exist_ok=True)
    reader, writer = _CONTEXT.Pipe(duplex=False)
    process = _CONTEXT.Process(target=_begin, args=(writer, entry, list(arguments), folder))
    process.start()
    assert process.pid is not None  # it was started
    try:
        writer.close()
        with reader:
            reader.poll(None)  # until the process closes its end, or ends
        process.join(seconds)
        late = process.is_alive()
        if late:
            with contextlib.suppress(ProcessLookupError):  # it has ended meanwhile
                os.kill(process.pid, last)
            process.join(_HEEDS)
    finally:
        process.kill()
        process.join()
    out, err = (_read(folder / name) for name in ("stdout", "stderr"))
    assert process.exitcode is not None  # it was joined
    return Ended(process.exitcode, out, err.decode(errors="replace"), late)


def _read(file: Path) -> bytes:
    if not file.exists():  # killed before it began
        return b""
    with file.open("rb") as opened:
        return opened.read(_SAID)


def _begin(begun: Connection, entry: Entry, arguments: list[str], folder: Path) -> None:
    begun.close()
    os.setsid()
    for descriptor, name in ((1, "stdout"), (2, "stderr")):
        file = os.open(folder / name, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(file, descriptor)
        os.close(file)
    os.chdir(folder / "work")
    for limit, most in (
        (resource.RLIMIT_AS, MEMORY),
        (resource.RLIMIT_FSIZE, _FILE_SIZE),
        (resource.RLIMIT_CORE, 0),
    ):
        resource.setrlimit(limit, (most, most))
    sys.argv = ["hoopgen", *arguments]
    entry(arguments)


def wrong(ended: Ended, *, may_take_long: bool = False) -> str:
    """Describe what is wrong with how a command ended, "" if nothing is."""
    words = ended.err.strip().splitlines()
    last = _short(words[-1]) if words else ""
    if ended.late and ended.status == -signal.SIGKILL:
        return "does not heed Ctrl-C" if may_take_long else "still at work when its time was up"
    if ended.status < 0:
        return f"killed by {signal.Signals(-ended.status).name}"
    if "Traceback (most recent call last)" in ended.err:
        return f"traceback: {last}"
    if ended.status not in _ALLOWED and not (may_take_long and ended.late and ended.status == 130):
        return f"exit status {ended.status}: {last}"
    if ended.status in (2, _UNFORESEEN) and not any(
        w.startswith("hoopgen: error: ") for w in words
    ):
        return f"exit status {ended.status}, and no word of an error: {last}"
    return ""


def _short(line: str) -> str:
    line = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in line)
    return line if len(line) <= 160 else f"{line[:157]}..."
