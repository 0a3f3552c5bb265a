"""``hoopgen estimate``: how probably a shot is made, what a change does, with which scatter."""

from __future__ import annotations

import json
import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hoopgen.cli.command import ARGUMENTS, command
from hoopgen.cli.invalid import warn_invalid
from hoopgen.cli.measuring import check_caught, measure_options
from hoopgen.cli.options import (
    UNITS_IN_WORDS,
    examples,
    json_option,
    picture_option,
    units_option,
)
from hoopgen.cli.releasing import (
    Releasing,
    from_option,
    release_needs,
    release_options,
    work_options,
)
from hoopgen.cli.types import ASSIGNMENT, COUNT, SHARE, once

if TYPE_CHECKING:
    from hoopgen.engines import Engine

__all__ = ["estimate"]

_PLAYER = "--scatter speed=0.07 --scatter elevation=1.3deg --scatter azimuth=1deg"
_PITCH = "--scatter vx=0.1 --scatter vy=0.05"


@command(
    needs=release_needs,
    epilog=UNITS_IN_WORDS
    + examples(
        "hoopgen estimate --speed 7.17 --elevation 52deg --backspin 3Hz --height 7ft \\",
        f"    --distance 13.75ft {_PLAYER} \\",
        "    --picture shares.svg",
        "hoopgen estimate --aim 5cm --elevation 52deg --backspin 3Hz --height 7ft \\",
        f"    --distance 13.75ft {_PLAYER} \\",
        "    --preset nba --precision 0.001 --versus backspin=0",
        "hoopgen estimate --scene golf.toml --position=-30cm,0,20cm --velocity 1.4,0,0 \\",
        "    --scatter vx=0.1 --scatter vy=0.05 --max-contacts 30",
        "hoopgen estimate --from releases.csv --height 7ft --distance 13.75ft --solve 70%",
    ),
)
@release_options
@from_option
@click.option(
    "--versus",
    type=ASSIGNMENT,
    multiple=True,
    callback=once,
    help="Compare with this variable changed, over the same random numbers; may be repeated.",
)
@click.option(
    "--solve",
    "share",
    type=SHARE,
    help="Find the factor times all of the scatter with which this share is made, 70%.",
)
@click.option(
    "--by",
    metavar="END",
    help="With --scene, and --versus or --solve: the end that counts; else the first.",
)
@click.option(
    "--shots",
    type=COUNT,
    help="100,000 by default; with --precision the most, 1e9 by default. Of more than a --folder "
    "has, only the rest is thrown.",
)
@click.option(
    "--precision",
    type=click.FloatRange(0, 1, min_open=True, max_open=True),
    help="Stop when half the interval is no wider: 0.001 is a tenth of a point.",
)
@measure_options("Say how it is spread")
@picture_option("shares of how they end, and of what they touch")
@work_options
@units_option
@json_option
def estimate(
    releasing: Releasing,
    versus: Mapping[str, float],
    share: float | None,
    by: str | None,
    precision: float | None,
    measures: tuple[str, ...],
    catching_height: float,
    picture: Path | None,
    as_json: bool,
    **work: Any,
) -> None:
    """Estimate how probably a shot is made.

    Shots scatter about a release, or are drawn from measured ones. Said are the probability with
    its interval, and the shares of swishes, shots off the rim, bank shots and so on; with --measure
    how a measure is spread too, and of rebound_angle how many rebounds go where. With --scene shots
    scatter about a position and a velocity, and said is the share of each end. With --solve it is
    asked the other way round: how wide the scatter is of somebody who makes so many.
    """
    import hoopgen
    from hoopgen.cli.progress import shown
    from hoopgen.study.named import in_units

    if share is not None and (versus or precision is not None):
        other = "--versus" if versus else "--precision"
        raise click.UsageError(f"--solve and {other} ask different questions; leave one out")
    if measures and (versus or share is not None):
        other = "--versus" if versus else "--solve"
        raise click.UsageError(f"--measure is of one setting, without {other}.")
    check_caught(measures)
    if share is not None and not (releasing.sd or releasing.measured):
        raise click.UsageError(_needs_scatter(releasing.engine))
    (model, parameters), scene = releasing.model(), releasing.engine
    with shown() as progress:
        options = {"scene": scene, "progress": progress, **work}
        result: Any
        if share is not None:
            result = hoopgen.solve(model, share, parameters, by=by, **options)
        elif versus:
            settings = (model, parameters), releasing.model(versus)
            result = hoopgen.compare(*settings, by=by, precision=precision, **options)
        else:
            options |= {"measures": measures, "catching_height": catching_height}
            result = hoopgen.estimate(model, parameters, precision=precision, **options)
    if picture is not None:
        from hoopgen import plots

        plots.save(plots.plot_estimate(result), picture)
    if as_json:
        click.echo(json.dumps(in_units(result.as_dict()), indent=2, allow_nan=False))
    else:
        if versus:
            click.echo(
                f"versus      {', '.join(_said(scene, name, to) for name, to in versus.items())}"
            )
        click.echo(result)
    if share is None and not versus:
        invalid = getattr(result, "invalid", None)
        invalid = result.counts["invalid"] if invalid is None else invalid
        warn_invalid(model, parameters, scene, invalid, result.shots, work["seed"])
    if precision is not None and result.half_width > precision:
        click.echo("hoopgen: the precision was not reached; more --shots", err=True)


def _needs_scatter(scene: Engine) -> str:
    """Say with a whole command what ``--solve`` multiplies."""
    words = click.get_current_context().meta[ARGUMENTS]
    more = shlex.split(_PLAYER if scene.has_hoop else _PITCH)
    return (
        "--solve multiplies the scatter, and here nothing scatters: give --scatter, or --from with "
        f"measured releases. For example: {shlex.join(['hoopgen', 'estimate', *words, *more])}"
    )


def _said(scene: Engine, name: str, value: float) -> str:
    """Say a variable and its value."""
    from hoopgen.words import say

    return f"{name} {say(name, value) if scene.has_hoop else f'{value:g}'}"
