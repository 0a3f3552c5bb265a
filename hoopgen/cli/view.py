"""``hoopgen view``: a sample of a table of releases, in motion on one page."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from hoopgen.study.questions.settings import Engines, Seeded
from hoopgen.study.questions.specification import EstimateQuestion
from hoopgen.text.escape import printable

from .command import command
from .messages import echo_lines, examples
from .options import reading_options, table_options, units_option
from .path_types import PAGE
from .question_options import setting_options
from .types import whole


@command(
    short_help="Show shots of a table in space, in motion.",
    epilog=examples(
        "hoopgen view releases.csv --out shots.html",
        "hoopgen view releases.csv --out shots.html --release height=7ft --label player",
        "hoopgen view results.parquet --out shots.html --sample 200 --seed 7",
    ),
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
@setting_options(Seeded)
@click.option(
    "--label",
    metavar="COLUMN",
    help="Column with the name of each shot on the page; by default its row.",
)
@click.option("--title", default="", help="Title of the page; by default the number of shots.")
@table_options
@reading_options
@setting_options(EstimateQuestion, only="max_contacts")
@setting_options(Engines)
@units_option
def view(file: Path, out: Path, **options: Any) -> None:
    """Show a sample of a table of releases in space, in motion.

    FILE is a table as `hoopgen batch` reads it, or the results that it writes: CSV, Parquet or
    Arrow, one release a row, with the units in the columns' names. Results are simulated in
    their own scene.
    """
    from hoopgen.viewer.view_table import view_table

    options = {name: value for name, value in options.items() if value is not None}
    page = view_table(file, out, **options)
    click.echo(printable(f"{out}: {page.about}"))
    echo_lines(page.read)
