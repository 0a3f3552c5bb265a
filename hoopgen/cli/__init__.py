"""The command line: ``hoopgen paper``, ``hoopgen shot`` and their kin.

Every error is one line on stderr and exit status 2. What a command needs is imported when it runs,
so that help is quick.
"""

from __future__ import annotations

import io
import sys
from collections import UserDict
from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any

import click

from hoopgen.cli.examples import examples
from hoopgen.installed import explained

__all__ = ["main"]

_COMMANDS = {
    "paper": "paper",
    "shot": "shot",
    "estimate": "estimate",
    "map": "map",
    "optimum": "optimum",
    "aim": "aim",
    "batch": "batch",
    "study": "study",
    "view": "view",
    "certify": "certify",
    "generate": "develop",
    "check": "develop",
    "bench": "develop",
}
"""Each command, and the module that has it."""


class _Commands(UserDict[str, click.Command]):
    """Commands that are imported when they are asked for: `generate` stands on no other."""

    def __getitem__(self, name: str) -> click.Command:
        module = import_module(f"hoopgen.cli.{_COMMANDS[name]}")
        command: click.Command = getattr(module, "map_" if name == "map" else name)
        return command

    def __iter__(self) -> Iterator[str]:
        return iter(_COMMANDS)

    def __len__(self) -> int:
        return len(_COMMANDS)

    def __contains__(self, name: object) -> bool:
        return name in _COMMANDS


# What the library raises when it is asked for something wrong, or something is not there.
_EXPECTED = (click.ClickException, ImportError, LookupError, OSError, RuntimeError, ValueError)


class _Tour(click.Group):
    """A group that reports every error in one line."""

    def main(self, *args: Any, **kwargs: Any) -> Any:
        """Run the command line and exit with its status."""
        standalone = kwargs.pop("standalone_mode", True)
        if standalone:
            _write_what_can_be_written()
        kwargs.setdefault("prog_name", "hoopgen")
        run: Callable[..., Any] = super().main
        try:
            result = run(*args, standalone_mode=False, **kwargs)
        except click.Abort:
            _complain("interrupted")
            result = 130
        except _EXPECTED as error:
            if not standalone:
                raise
            _complain(_in_words(error))
            result = 2
        if standalone:
            sys.exit(result if isinstance(result, int) else 0)
        return result

    def list_commands(self, ctx: click.Context) -> list[str]:
        """List the commands in the order of a first visit, not of the alphabet."""
        return list(self.commands)


def _write_what_can_be_written() -> None:
    """Put ? for a sign that the terminal has not, such as ² in cp437, instead of failing."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper) and stream.errors == "strict":
            stream.reconfigure(errors="replace")


def _complain(text: str) -> None:
    click.echo(f"hoopgen: error: {' '.join(text.split())}", err=True)


def _in_words(error: Exception) -> str:
    if isinstance(error, click.UsageError) and error.ctx is not None:
        return f"{error.format_message()} (see {error.ctx.command_path} --help)"
    if isinstance(error, click.ClickException):
        return error.format_message()
    if isinstance(error, ImportError):
        return str(explained(error))
    if isinstance(error, OSError) and error.filename is not None:
        return f"{error.filename}: {error.strerror}"
    if isinstance(error, KeyError) and error.args:
        return str(error.args[0])  # str() of a KeyError is a repr
    return str(error)


@click.group(
    cls=_Tour,
    commands=_Commands(),
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog=examples(
        "hoopgen paper --out figures",
        "hoopgen shot --speed 7.17 --elevation 51 --distance 13.75ft --height 7ft",
        "hoopgen estimate --aim 5cm --elevation 52 --distance 13.75ft --height 7ft \\",
        "    --scatter speed=0.07 --scatter elevation=1.3 --scatter azimuth=1",
        "hoopgen estimate --help",
    ),
)
@click.version_option(package_name="hoopgen", message="%(prog)s %(version)s")
@click.pass_context
def main(ctx: click.Context) -> None:
    """Basketball trajectories, event by event.

    The ball flies until it meets the ring, the backboard or the bridge, bounces, and flies on,
    until it falls through the plane below the ring. No time steps, no missed contacts.
    """
    if ctx.invoked_subcommand is None:
        click.echo(ctx.get_help())
