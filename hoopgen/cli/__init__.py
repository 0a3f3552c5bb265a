"""The command line: ``hoopgen paper``, ``hoopgen shot`` and their kin.

Every error is one line on stderr and exit status 2; 70 where it is hoopgen's own. What a command
needs is imported when it runs, so that help is quick.
"""

from __future__ import annotations

import io
import os
import sys
import traceback
from collections import UserDict
from collections.abc import Callable, Iterator, Sequence
from importlib import import_module
from typing import Any

import click

from hoopgen.text.escape import printable

from .messages import NOT_FORESEEN, OWN_ERROR, TRACEBACK, error_text, examples, is_expected

_COMMANDS = {
    "paper": "paper",
    "shot": "shot",
    "estimate": "estimate",
    "map": "map",
    "fan": "shot_pictures",
    "landings": "shot_pictures",
    "optimum": "optimum",
    "aim": "aim",
    "bank": "bank",
    "best": "best",
    "batch": "batch",
    "fit": "fit",
    "calibrate": "calibrate",
    "study": "study",
    "view": "view",
    "playground": "playground",
    "certify": "certify",
    "counterfactual": "counterfactual",
    "coach": "coach",
    "compile": "scenes",
    "cache": "scenes",
    "hash": "scenes",
    "generate": "develop",
    "check": "develop",
    "bench": "develop",
}
"""Each command, and the module that has it."""

_NAMES = {"map": "map_", "compile": "compile_", "hash": "hash_"}
"""Function names of commands whose own names Python has taken."""


class _Commands(UserDict[str, click.Command]):
    """Commands that are imported when they are asked for: `generate` stands on no other."""

    def __getitem__(self, name: str) -> click.Command:
        module = import_module(f"hoopgen.cli.{_COMMANDS[name]}")
        command: click.Command = getattr(module, _NAMES.get(name, name))
        return command

    def __iter__(self) -> Iterator[str]:
        return iter(_COMMANDS)

    def __len__(self) -> int:
        return len(_COMMANDS)

    def __contains__(self, name: object) -> bool:
        return name in _COMMANDS


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
        except Exception as error:
            if not standalone:
                raise
            result = self._failed(error, args[0] if args else kwargs.get("args"))
        if standalone:
            sys.exit(result if isinstance(result, int) else 0)
        return result

    def _failed(self, error: Exception, arguments: Sequence[str] | None) -> int:
        """Print an error in a line, and return the exit status."""
        if os.environ.get(TRACEBACK) == "1":
            traceback.print_exception(error)
        if is_expected(error):
            _complain(error_text(error))
            return 2
        words = sys.argv[1:] if arguments is None else arguments
        command = next((word for word in words if word in self.commands), "")
        _complain(f"hoopgen {command}: {error_text(error)} ({NOT_FORESEEN})")
        return OWN_ERROR

    def list_commands(self, ctx: click.Context) -> list[str]:
        """List the commands in the order of a first visit, not of the alphabet."""
        return list(self.commands)


def _write_what_can_be_written() -> None:
    """Print ? for a character that the terminal lacks, such as ² in cp437, instead of failing."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper) and stream.errors == "strict":
            stream.reconfigure(errors="replace")


def _complain(text: str) -> None:
    click.echo(f"hoopgen: error: {printable(' '.join(text.split()))}", err=True)


@click.group(
    cls=_Tour,
    commands=_Commands(),
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog=examples(
        "hoopgen paper --out figures",
        "hoopgen shot --speed 7.17 --elevation 51deg --distance 13.75ft --height 7ft",
        "hoopgen estimate --aim 5cm --elevation 52deg --distance 13.75ft --height 7ft \\",
        "    --scatter speed=0.07 --scatter elevation=1.3deg --scatter azimuth=1deg",
        "hoopgen estimate --help",
    ),
)
@click.version_option(package_name="hoopgen", message="%(prog)s %(version)s")
@click.pass_context
def main(ctx: click.Context) -> None:
    """Basketball trajectories, event by event.

    The ball flies until it meets the ring, the backboard or the bridge, bounces, and flies on,
    until it falls through the plane below the ring. No time steps, no missed contacts.

    Exit status: 0; 1 where a command says so; 2 for an error; 70 for one of hoopgen's own, of
    which HOOPGEN_TRACEBACK=1 in the environment shows more; 130 when interrupted.
    """
    if ctx.invoked_subcommand is None:
        click.echo(ctx.get_help())
