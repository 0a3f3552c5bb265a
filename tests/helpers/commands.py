"""Commands of hoopgen, run in this process."""

from __future__ import annotations

from click.testing import CliRunner, Result

from hoopgen.cli import main

RELEASE = [
    *["--speed", "7.17", "--elevation", "51deg", "--distance", "13.75ft", "--height", "7ft"],
]
"""Options of a free throw."""


def run(*words: object) -> Result:
    """Run a command."""
    return CliRunner().invoke(main, [str(word) for word in words])


def succeed(*words: object) -> Result:
    """Run a command that must not fail."""
    result = run(*words)
    assert result.exit_code == 0, result.output
    return result


def output(*words: object) -> str:
    """Return what a command prints that must not fail."""
    return succeed(*words).stdout


def failure(*words: object, status: int = 2) -> str:
    """Run a command that must fail; return its one line."""
    result = run(*words)
    assert result.exit_code == status, result.output
    assert result.stdout == ""
    assert result.stderr.startswith("hoopgen: error: ")
    assert result.stderr.count("\n") == 1
    return result.stderr
