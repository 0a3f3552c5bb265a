"""``hoopgen batch``: a table of releases, simulated row by row."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from hoopgen.cli.command import command
from hoopgen.cli.measuring import check_caught, measure_options
from hoopgen.cli.options import examples, scheduler_option, table_options, threads_option
from hoopgen.cli.types import OUT
from hoopgen.phrases import counted
from hoopgen.printable import printable

__all__ = ["batch"]

_COLUMNS = """\b
Columns are named like variables, with the unit after them. A length or a speed without is SI, m or
m/s; an angle or a spin needs its unit:
  releases    speed_mph elevation_deg azimuth_deg backspin_hz height_ft distance ...
  or states   x y z vx vy vz wx_rad_s wy_rad_s wz_rad_s, x_ft, vx_ft_s, wy_rpm ...
  and         ring_radius_in restitution ..., which change the scene of that row
All others are kept as they are. A row with no number where one is needed is invalid. In CSV with
semicolons or tabs, numbers may have decimal commas.

"""


@command(
    epilog=_COLUMNS
    + examples(
        "hoopgen batch releases.csv --out results.parquet",
        "hoopgen batch releases.csv --out results.parquet --release height=7ft \\",
        "    --release distance=13.75ft --preset nba --measure depth --measure entry_angle",
        "hoopgen batch releases.csv --out results.csv --reason",
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
    "--delimiter",
    metavar="CHARACTER",
    help="Between the cells of CSV, ; or tab; by default as its first line says.",
)
@click.option("--reason", is_flag=True, help="Add a column: why a row is invalid.")
@threads_option
@scheduler_option
def batch(file: Path, out: Path, release: Mapping[str, float], **options: Any) -> None:
    """Simulate the releases of a table, and write it with the results.

    FILE is CSV, Parquet or Arrow, and may be larger than the memory. The same command goes on
    where an interrupted one stopped.
    """
    import hoopgen
    from hoopgen.cli.progress import shown

    check_caught(options["measures"])
    with shown() as progress:
        outcomes = hoopgen.batch(file, out, release=release, progress=progress, **options)
    counts = [f"{count:,} {name}" for name, count in outcomes.items()]
    said = f"{counted(sum(outcomes.values()), 'shot')}: {', '.join(counts)}; in {out}"
    click.echo(printable(said))
    click.echo(printable(f"read {outcomes.read}"))
    for row, reason in outcomes.invalid:
        click.echo(printable(f"invalid: row {row}: {reason}"))
    more = outcomes["invalid"] - len(outcomes.invalid)
    if more:
        click.echo(f"invalid: and {more:,} more; --reason writes why into a column")
    click.echo(f"scene: {outcomes.scene}")
