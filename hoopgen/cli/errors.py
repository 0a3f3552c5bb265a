"""Errors in words: those that the library raises on purpose, and those that nobody foresaw."""

from __future__ import annotations

import click

from hoopgen.installed import explained

__all__ = ["NOT_FORESEEN", "OWN_ERROR", "TRACEBACK", "OwnError", "foreseen", "in_words"]

TRACEBACK = "HOOPGEN_TRACEBACK"
"""Environment variable: where it is 1, every error comes with Python's traceback."""

NOT_FORESEEN = f"this was not foreseen; {TRACEBACK}=1 in the environment shows where it happened"

OWN_ERROR = 70
"""Exit status of an error that nobody foresaw: EX_SOFTWARE of sysexits.h."""

# What the library raises when it is asked for something wrong, or something is not there.
_EXPECTED = (click.ClickException, ImportError, OSError, RuntimeError, ValueError)


class OwnError(click.ClickException):
    """Errors of which some were not foreseen."""


def foreseen(error: Exception) -> bool:
    """Tell whether an error says what is wrong with what was asked."""
    return isinstance(error, _EXPECTED) and not isinstance(error, (OwnError, RecursionError))


def in_words(error: Exception) -> str:
    """Say an error; of one that nobody foresaw its type too."""
    if isinstance(error, click.UsageError) and error.ctx is not None:
        return f"{error.format_message()} (see {error.ctx.command_path} --help)"
    if isinstance(error, click.ClickException):
        return error.format_message()
    if isinstance(error, ImportError):
        return str(explained(error))
    if isinstance(error, OSError) and error.filename is not None:
        return f"{error.filename}: {error.strerror}"
    return str(error) if foreseen(error) else f"{type(error).__name__}: {error}"
