"""What is measured of shots, as options: which measures, and where rebounds are caught."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import click
from click.shell_completion import CompletionItem

from hoopgen.cli.options import together
from hoopgen.cli.types import quantity
from hoopgen.hoop.releases import CATCHING_HEIGHT

__all__ = ["catching_height_option", "check_caught", "measure_options"]


def _complete(_: click.Context, __: click.Parameter, incomplete: str) -> list[CompletionItem]:
    from hoopgen.study.measures import MEASURES

    known = {name: one.label for name, one in MEASURES.items() if name.startswith(incomplete)}
    return [CompletionItem(name, help=label) for name, label in known.items()]


def measure_options(what: str) -> Callable[[Any], Any]:
    """Return ``--measure`` and ``--catching-height``; `what` says what becomes of a measure."""
    return together(
        click.option(
            "--measure",
            "measures",
            metavar="NAME",
            shell_complete=_complete,
            multiple=True,
            help=f"{what}: depth, entry_angle, apex, rebound_distance ...; may be repeated.",
        ),
        catching_height_option(
            "Of rebounds: of the ball's centre above the floor when it is caught; "
            f"{CATCHING_HEIGHT:g}m by default, a choice.",
            default=CATCHING_HEIGHT,
        ),
    )


def check_caught(measures: Iterable[str]) -> None:
    """Refuse a catching height where nothing is caught."""
    given = click.get_current_context().get_parameter_source("catching_height")
    asked = any(name.startswith("rebound") for name in measures)
    if given is click.core.ParameterSource.COMMANDLINE and not asked:
        raise click.UsageError("--catching-height is of rebounds, --measure rebound_distance ...")


def catching_height_option(what: str, *, default: float | None) -> Callable[[Any], Any]:
    """Return ``--catching-height``; `what` is its help."""
    return click.option("--catching-height", type=quantity("length"), default=default, help=what)
