"""What is measured of shots, as options: which measures, and where rebounds are caught."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import click

from hoopgen.cli.options import together
from hoopgen.cli.types import quantity
from hoopgen.hoop.releases import CATCHING_HEIGHT

__all__ = ["measure_options"]


def measure_options(what: str) -> Callable[[Any], Any]:
    """Return ``--measure`` and ``--catching-height``; `what` says what becomes of a measure."""
    return together(
        click.option(
            "--measure",
            "measures",
            metavar="NAME",
            multiple=True,
            help=f"{what}: depth, entry_angle, apex, rebound_distance ...; may be repeated.",
        ),
        click.option(
            "--catching-height",
            type=quantity("length"),
            default=CATCHING_HEIGHT,
            help="Of rebounds: of the ball's centre above the floor when it is caught; "
            f"{CATCHING_HEIGHT:g}m by default, a choice.",
        ),
    )
