"""``hoopgen estimate``: how probably a shot is made, and what a change does to that."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hoopgen.cli.flown import flown
from hoopgen.cli.options import UNITS_IN_WORDS, examples, json_option, override_option
from hoopgen.cli.releasing import Releasing, release_options, work_options
from hoopgen.cli.types import ASSIGNMENT, COUNT, FILE

if TYPE_CHECKING:
    from hoopgen.study.models import ReleaseModel

__all__ = ["estimate"]

_PLAYER = "--scatter speed=0.07 --scatter elevation=1.3 --scatter azimuth=1"


@click.command(
    epilog=UNITS_IN_WORDS
    + examples(
        "hoopgen estimate --speed 7.17 --elevation 52 --backspin 3Hz --height 7ft \\",
        f"    --distance 13.75ft {_PLAYER}",
        "hoopgen estimate --aim 5cm --elevation 52 --backspin 3Hz --height 7ft \\",
        f"    --distance 13.75ft {_PLAYER} \\",
        "    --preset nba --precision 0.001 --versus backspin=0",
        "hoopgen estimate --from releases.csv --height 7ft --distance 13.75ft --json",
    )
)
@release_options
@click.option(
    "--from",
    "file",
    type=FILE,
    help="Draw from measured releases, .csv, .parquet or .arrow; the options above fill in.",
)
@override_option
@click.option(
    "--versus",
    type=ASSIGNMENT,
    multiple=True,
    help="Compare with this variable changed, over the same random numbers; may be repeated.",
)
@click.option(
    "--shots", type=COUNT, help="100,000 by default; with --precision the most, 1e9 by default."
)
@click.option(
    "--precision",
    type=click.FloatRange(0, 1, min_open=True, max_open=True),
    help="Stop when half the interval is no wider: 0.001 is a tenth of a point.",
)
@work_options
@json_option
def estimate(
    releasing: Releasing,
    file: Path | None,
    versus: tuple[tuple[str, float], ...],
    precision: float | None,
    as_json: bool,
    override: bool,
    **work: Any,
) -> None:
    """Estimate how probably a shot is made.

    Shots scatter about a release, or are drawn from measured ones. Said are the probability with
    its interval, and the shares of swishes, shots off the rim, bank shots and so on.
    """
    import hoopgen
    from hoopgen.cli.progress import shown
    from hoopgen.study.words import say

    measured: Mapping[str, Any] = {}
    assumed = ""
    if file is None and override:
        raise click.UsageError("--override: there is no file of results; leave it out")
    if file is not None:
        asked, assumed = flown(file)
        measured, releasing, work["max_contacts"] = _measured(file, releasing, asked, override)
    setting = _setting(releasing, measured, {})
    with shown() as progress:
        options = {"precision": precision, "progress": progress, **work}
        if versus:
            changed = _setting(releasing, measured, dict(versus))
            result: Any = hoopgen.compare(setting, changed, **options)
        else:
            result = hoopgen.estimate(*setting, **options)
    if as_json:
        click.echo(json.dumps(result.as_dict(), indent=2, allow_nan=False))
    else:
        if versus:
            click.echo(f"versus      {', '.join(f'{name} {say(name, to)}' for name, to in versus)}")
        click.echo(result)
    if assumed:
        click.echo(assumed, err=True)
    if precision is not None and result.half_width > precision:
        click.echo("hoopgen: the precision was not reached; more --shots", err=True)


def _measured(
    file: Path, releasing: Releasing, asked: Mapping[str, Any], override: bool
) -> tuple[Mapping[str, Any], Releasing, int]:
    """Return what the file says of releases, without what is given; its scene; its contacts."""
    import pyarrow as pa

    from hoopgen.study.origin import settle
    from hoopgen.study.tables import Source

    if releasing.sd:
        raise click.UsageError("--scatter is about a release, and --from has many; leave one out")
    source = Source(file)
    origin = settle(source, release=releasing.values, **asked, override=override)
    columns = source.columns(origin.own, origin.release)
    measured = source.values(pa.concat_tables(source.tables(_ROWS)), columns)
    releasing = replace(releasing, values=origin.release, parameters=origin.parameters)
    return measured, releasing, origin.max_contacts


_ROWS = 1 << 20
"""Read at a time."""


def _setting(
    releasing: Releasing, measured: Mapping[str, Any], changes: Mapping[str, float]
) -> tuple[ReleaseModel, Mapping[str, float]]:
    """Return the release model and the scene, with some variables changed."""
    from hoopgen.parameters import NAMES
    from hoopgen.study.models import Resample, Scatter
    from hoopgen.study.variables import change_variables

    values = change_variables({**measured, **releasing.values}, changes)
    scene = dict(releasing.parameters)
    scene |= {name: values.pop(name) for name in NAMES if name in changes}
    if measured:
        return Resample(values), scene
    return Scatter(values, releasing.sd, releasing.correlation), scene
