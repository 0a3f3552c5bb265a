"""``hoopgen view``: a sample of a table of releases, in motion on one page."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from hoopgen.cli.command import command
from hoopgen.cli.flown import say_lines
from hoopgen.cli.options import backend_option, examples, seed_option, table_options, units_option
from hoopgen.cli.types import PAGE, whole
from hoopgen.inputs import Backend
from hoopgen.printable import printable

__all__ = ["view"]


@command(
    epilog=examples(
        "hoopgen view releases.csv --out shots.html",
        "hoopgen view releases.csv --out shots.html --release height=7ft --label player",
        "hoopgen view results.parquet --out shots.html --sample 200 --seed 7",
    )
)
@click.option(
    "--out", type=PAGE, required=True, help="The page, .html: one file that needs no network."
)
@click.option(
    "--sample",
    "count",
    type=whole(most=2000),
    default=50,
    show_default=True,
    help="Shots on the page, chosen at random.",
)
@seed_option
@click.option(
    "--label",
    metavar="COLUMN",
    help="What each shot on the page is called; by default its row.",
)
@click.option("--title", default="", help="At the top of the page; by default the number of shots.")
@table_options
@backend_option
@units_option
def view(
    file: Path,
    out: Path,
    count: int,
    seed: int,
    label: str | None,
    title: str,
    release: Mapping[str, float],
    parameters: Mapping[str, float] | None,
    max_contacts: int | None,
    override: bool,
    backend: Backend,
    scene: Any,
    **reading: Any,
) -> None:
    """Show a sample of a table of releases in space, in motion.

    FILE is a table as `hoopgen batch` reads it, or the results that it writes: CSV, Parquet or
    Arrow, one release a row, with the units in the columns' names. Results are flown in their own
    scene.
    """
    from hoopgen.viewer.table import view_table

    page = view_table(
        file,
        out,
        count=count,
        seed=seed,
        label=label,
        title=title,
        parameters=parameters,
        release=release,
        max_contacts=max_contacts,
        override=override,
        backend=backend,
        scene=scene,
        **{name: value for name, value in reading.items() if value is not None},
    )
    click.echo(printable(f"{out}: {page.about}"))
    say_lines(page.read)
