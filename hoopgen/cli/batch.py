"""``hoopgen batch``: a table of releases, simulated row by row."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

import hoopgen
from hoopgen.study.questions.specification import BatchQuestion
from hoopgen.text.numbers import format_count

from .command import command
from .messages import echo_lines, examples, shown
from .options import table_options
from .path_types import OUT
from .question_options import check_caught, question_options

_COLUMNS = """\b
Columns are named like variables, with the unit after them. A length or a speed without is SI, m or
m/s; an angle or a spin needs its unit:
  releases    speed_mph elevation_deg azimuth_deg backspin_hz height_ft distance ...
  or states   x y z vx vy vz wx_rad_s wy_rad_s wz_rad_s, x_ft, vx_ft_s, wy_rpm ...
  and         ring_radius_in restitution ..., which change the scene of that row
A column of another name is read with --column speed=release_speed_mph. All others are kept as they
are. A row is invalid that has no number where one is needed, an implausible one, or more or fewer
cells than the header. In CSV with semicolons or tabs, numbers may have decimal commas.

"""


@command(
    short_help="Simulate the releases of a table.",
    epilog=_COLUMNS
    + examples(
        "hoopgen batch releases.csv --out results.parquet",
        "hoopgen batch releases.csv --out results.parquet --release height=7ft \\",
        "    --release distance=13.75ft --preset nba --measure depth --measure entry_angle",
        "hoopgen batch releases.xlsx --out results.parquet --column speed=release_speed_mph \\",
        "    --reason --by player --where 'season == 2024' --events contacts.parquet",
        "hoopgen batch states.arrow --out results.parquet --scheduler tcp://10.0.0.1:8786",
    ),
)
@click.option(
    "--out",
    type=OUT,
    required=True,
    help=".csv, .parquet or .arrow: the table with its results, in the same order.",
)
@table_options
@question_options(BatchQuestion)
@click.option("--group", hidden=True)
def batch(
    file: Path, out: Path, release: Mapping[str, float], group: str | None, **options: Any
) -> None:
    """Simulate the releases of a table, and write it with the results.

    FILE is CSV, Parquet, Arrow or .xlsx, and may be larger than the memory. The same command goes
    on where an interrupted one stopped.
    """
    check_caught(options["measures"])
    if group is not None:
        if options["by"] is not None:
            raise click.UsageError("--group: the old name of --by; give --by alone")
        click.echo("--group is deprecated: use --by", err=True)
        options["by"] = group
    options = {name: value for name, value in options.items() if value is not None}
    with shown() as progress:
        outcomes = hoopgen.batch(file, out, release=release, progress=progress, **options)
    counts = [f"{count:,} {name}" for name, count in outcomes.items()]
    text = f"{format_count(sum(outcomes.values()), 'shot')}: {', '.join(counts)}; in {out}"
    echo_lines(f"{text}\n{outcomes.read}")
    echo_lines(outcomes.invalid_lines)
    if len(outcomes.invalid) < outcomes["invalid"] and not options["reason"]:
        click.echo("invalid: --reason writes why into a column")
    if outcomes.groups:
        from hoopgen.study.tables.groups import groups_text

        echo_lines(f"\n{groups_text(options['by'], outcomes.groups)}\n")
    click.echo(f"scene: {outcomes.scene}")
