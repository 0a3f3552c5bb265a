"""``hoopgen batch``: a table of releases, simulated row by row."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from hoopgen.cli.command import command
from hoopgen.cli.flown import say_lines
from hoopgen.cli.measuring import check_caught, measure_options
from hoopgen.cli.options import examples, scheduler_option, table_options, threads_option
from hoopgen.cli.types import OUT
from hoopgen.phrases import counted

__all__ = ["batch"]

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
    epilog=_COLUMNS
    + examples(
        "hoopgen batch releases.csv --out results.parquet",
        "hoopgen batch releases.csv --out results.parquet --release height=7ft \\",
        "    --release distance=13.75ft --preset nba --measure depth --measure entry_angle",
        "hoopgen batch releases.xlsx --out results.parquet --column speed=release_speed_mph \\",
        "    --reason --group player --where 'season == 2024' --events contacts.parquet",
        "hoopgen batch states.arrow --out results.parquet --scheduler tcp://10.0.0.1:8786",
    )
)
@click.option(
    "--out",
    type=OUT,
    required=True,
    help="Parquet or CSV: the table with its results, in the same order.",
)
@table_options
@measure_options("Add a column")
@click.option("--prefix", default="", help="Of the names of the results.")
@click.option(
    "--group",
    metavar="COLUMN",
    help="Count results by the values of a column, too, with intervals.",
)
@click.option(
    "--events",
    type=OUT,
    help="Parquet or CSV: the event log, a row for each event of each row.",
)
@click.option(
    "--units",
    type=click.Choice(["si", "us"], case_sensitive=False),
    default="si",
    show_default=True,
    help="Of the columns of results: metres and m/s, or feet, mph and degrees.",
)
@click.option("--reason", is_flag=True, help="Add a column: why a row is invalid.")
@threads_option
@scheduler_option
def batch(file: Path, out: Path, release: Mapping[str, float], **options: Any) -> None:
    """Simulate the releases of a table, and write it with the results.

    FILE is CSV, Parquet, Arrow or .xlsx, and may be larger than the memory. The same command goes
    on where an interrupted one stopped.
    """
    import hoopgen
    from hoopgen.cli.progress import shown

    check_caught(options["measures"])
    options = {name: value for name, value in options.items() if value is not None}
    with shown() as progress:
        outcomes = hoopgen.batch(file, out, release=release, progress=progress, **options)
    counts = [f"{count:,} {name}" for name, count in outcomes.items()]
    said = f"{counted(sum(outcomes.values()), 'shot')}: {', '.join(counts)}; in {out}"
    say_lines(f"{said}\n{outcomes.read}")
    say_lines(outcomes.invalid_lines)
    if len(outcomes.invalid) < outcomes["invalid"] and not options["reason"]:
        click.echo("invalid: --reason writes why into a column")
    if outcomes.groups:
        from hoopgen.study.groups import groups_text

        say_lines(f"\n{groups_text(options['group'], outcomes.groups)}\n")
    click.echo(f"scene: {outcomes.scene}")
