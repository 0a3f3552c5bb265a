"""Text of the command line: examples, errors, lines, JSON and progress."""

from __future__ import annotations

import itertools
import json
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import click

from hoopgen.core.extras import explain_import_error
from hoopgen.text.escape import printable

TRACEBACK = "HOOPGEN_TRACEBACK"
"""Environment variable: where it is 1, every error comes with Python's traceback."""

NOT_FORESEEN = f"this was not foreseen; {TRACEBACK}=1 in the environment shows where it happened"

OWN_ERROR = 70
"""Exit status of an error that nobody foresaw: EX_SOFTWARE of sysexits.h."""

# The library raises these when it is asked for something wrong, or something is not there.
_EXPECTED = (click.ClickException, ImportError, OSError, RuntimeError, ValueError)


class OwnError(click.ClickException):
    """Errors of which some were not foreseen."""


def is_expected(error: Exception) -> bool:
    """Return whether an error says what is wrong with what was asked."""
    return isinstance(error, _EXPECTED) and not isinstance(error, (OwnError, RecursionError))


def error_text(error: Exception) -> str:
    """Return an error as text, with its type if nobody foresaw it."""
    if isinstance(error, click.UsageError) and error.ctx is not None:
        return f"{error.format_message()} (see {error.ctx.command_path} --help)"
    if isinstance(error, click.ClickException):
        return error.format_message()
    if isinstance(error, ImportError):
        return str(explain_import_error(error))
    if isinstance(error, OSError) and error.filename is not None:
        return f"{error.filename}: {error.strerror}"
    return str(error) if is_expected(error) else f"{type(error).__name__}: {error}"


def examples(*lines: str) -> str:
    """Return example lines for the end of a command's help."""
    return "\b\nExamples:\n" + "\n".join(f"  {line}" for line in lines)


def echo_lines(text: str, *, err: bool = False) -> None:
    """Print lines, some of which may be in the words of a file.

    Parameters
    ----------
    text
        The lines; characters that steer a terminal are printed as escapes.
    err
        True to print on stderr.
    """
    for line in text.splitlines():
        click.echo(printable(line), err=err)


def echo_json(record: Any) -> None:
    """Print a record as JSON."""
    click.echo(json.dumps(record, indent=2, allow_nan=False))


class _Shown:
    """Function of progress that moves a bar, and begins its clock when the work begins."""

    def __init__(self, bar: Any) -> None:
        self.bar = bar
        self.begun: tuple[float, int] | None = None
        """The time of the first call, and what was done by then."""

    def __call__(self, done: int, total: int | None) -> None:
        """Show how much is done; a smaller number than before begins another stage."""
        bar, now = self.bar, time.time()  # the clock of click's bar
        if self.begun is None or done < bar.pos or (bar.length is None and total is not None):
            self.begun, bar.avg, bar.eta_known = (now, done), [], False
            bar.start = bar.last_eta = now
        started, before = self.begun
        if done > before:
            # click takes the time since the start for that of all steps, those before it too.
            bar.start = now - (now - started) * done / (done - before)
        bar.length = total
        if done < bar.pos:
            bar.pos = 0
        bar.update(done - bar.pos)


@contextmanager
def shown() -> Iterator[Callable[[int, int | None], None]]:
    """Show on stderr, if that is a terminal, how far work is and the time left.

    Notes on an interruption, which say how to go on, are printed.

    Yields
    ------
    callable
        Function of what is done and of its total (None: not known).
    """
    try:
        if not sys.stderr.isatty():
            yield lambda done, total: None
            return
        with click.progressbar(itertools.count(), file=sys.stderr) as bar:
            yield _Shown(bar)
    except KeyboardInterrupt as error:
        for note in getattr(error, "__notes__", ()):
            text = note.replace("the same call goes on", "the same command goes on")
            click.echo(f"hoopgen: {printable(text)}", err=True)
        raise
