"""Studies on the command line: options that say what is shot, with what scatter, and who works."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import click

from hoopgen.cli.options import (
    VARIABLE_HELP,
    backend_option,
    confidence_option,
    folder_option,
    max_contacts_option,
    scene_options,
    scheduler_option,
    seed_option,
    threads_option,
    together,
    variable_option,
)
from hoopgen.cli.types import ASSIGNMENT, CORRELATION

__all__ = ["Releasing", "release_options", "work_options"]


@dataclass(frozen=True)
class Releasing:
    """What the options say is shot.

    Attributes
    ----------
    values
        Variables of the release that were given; SI.
    sd
        Their standard deviations, ``--scatter``.
    correlation
        Of pairs of those.
    parameters
        Of the scene.
    """

    values: Mapping[str, float]
    sd: Mapping[str, float]
    correlation: Mapping[tuple[str, str], float]
    parameters: Mapping[str, float]


def release_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options of a release, its scatter and the scene; give `releasing` to the command."""

    @functools.wraps(command)
    def collected(*arguments: Any, parameters: Mapping[str, float], **options: Any) -> Any:
        given = {name: options.pop(name) for name in VARIABLE_HELP}
        releasing = Releasing(
            values={name: value for name, value in given.items() if value is not None},
            sd=dict(options.pop("scatter")),
            correlation=dict(options.pop("correlation")),
            parameters=parameters,
        )
        return command(*arguments, releasing=releasing, **options)

    options = (*map(variable_option, VARIABLE_HELP), *_SCATTER, scene_options)
    decorated: Callable[..., Any] = together(*options)(collected)
    return decorated


_SCATTER = (
    click.option(
        "--scatter",
        type=ASSIGNMENT,
        multiple=True,
        help="Standard deviation of a variable, speed=0.07, elevation=1.3deg; may be repeated.",
    ),
    click.option(
        "--correlation",
        type=CORRELATION,
        multiple=True,
        help="Of two that scatter, speed,elevation=-0.3; may be repeated.",
    ),
)

work_options = together(
    seed_option,
    confidence_option,
    max_contacts_option,
    backend_option,
    threads_option,
    folder_option,
    scheduler_option,
)
"""What `hoopgen.estimate` and `hoopgen.map` have too, under the same names."""
