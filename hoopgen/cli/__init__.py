"""The command line: ``hoopgen paper``, ``hoopgen shot`` and their kin.

Every error is one line on stderr and exit status 2. What a command needs is imported when it runs,
so that help is quick.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import click

from hoopgen.cli.aim import aim
from hoopgen.cli.batch import batch
from hoopgen.cli.certify import certify
from hoopgen.cli.develop import bench, check, generate
from hoopgen.cli.estimate import estimate
from hoopgen.cli.map import map_
from hoopgen.cli.optimum import optimum
from hoopgen.cli.options import examples
from hoopgen.cli.paper import paper
from hoopgen.cli.shot import shot
from hoopgen.cli.study import study
from hoopgen.cli.view import view
from hoopgen.printable import printable

__all__ = ["main"]

# What the library raises when it is asked for something wrong, or something is not there.
_EXPECTED = (click.ClickException, ImportError, LookupError, OSError, RuntimeError, ValueError)

_EXTRAS = {
    "matplotlib": "plot",
    "sympy": "generate",
    "jinja2": "generate",
    "flint": "certify",
    "scipy": "study",
    "pyarrow": "study",
    "xarray": "study",
    "pydantic": "study",
    "distributed": "scale",
}
"""What may be missing, and the extra that brings it."""


class _Tour(click.Group):
    """A group that reports every error in one line."""

    def main(self, *args: Any, **kwargs: Any) -> Any:
        """Run the command line and exit with its status."""
        standalone = kwargs.pop("standalone_mode", True)
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


def _complain(text: str) -> None:
    click.echo(f"hoopgen: error: {printable(' '.join(text.split()))}", err=True)


def _in_words(error: Exception) -> str:
    if isinstance(error, click.UsageError) and error.ctx is not None:
        return f"{error.format_message()} (see {error.ctx.command_path} --help)"
    if isinstance(error, click.ClickException):
        return error.format_message()
    if isinstance(error, ImportError):
        missing = (error.name or "").partition(".")[0]
        if missing in _EXTRAS:
            return f"this needs {missing}: pip install 'hoopgen[{_EXTRAS[missing]}]'"
    if isinstance(error, OSError) and error.filename is not None:
        return f"{error.filename}: {error.strerror}"
    if isinstance(error, KeyError) and error.args:
        return str(error.args[0])  # str() of a KeyError is a repr
    return str(error)


@click.group(
    cls=_Tour,
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


for _command in (
    paper,
    shot,
    estimate,
    map_,
    optimum,
    aim,
    batch,
    study,
    view,
    certify,
    generate,
    check,
    bench,
):
    main.add_command(_command)
