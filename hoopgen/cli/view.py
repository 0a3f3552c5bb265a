"""``hoopgen view``: a sample of a table of releases, in motion on one page."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import click

from hoopgen.cli.options import backend_option, examples, seed_option, table_options
from hoopgen.cli.types import PAGE
from hoopgen.printable import printable

if TYPE_CHECKING:
    from typing import Literal

    from hoopgen.viewer.sample import Sample

__all__ = ["view"]


@click.command(
    epilog=examples(
        "hoopgen view releases.csv --out shots.html",
        "hoopgen view releases.csv --out shots.html --release height=7ft --preset nba",
        "hoopgen view results.parquet --out shots.html --sample 200 --seed 7",
    )
)
@click.option(
    "--out", type=PAGE, required=True, help="The page, .html: one file that needs no network."
)
@click.option(
    "--sample",
    "count",
    type=click.IntRange(1, 2000),
    default=50,
    show_default=True,
    help="Shots on the page, chosen at random.",
)
@seed_option
@click.option("--title", default="", help="At the top of the page; by default the number of shots.")
@table_options
@backend_option
def view(
    file: Path,
    out: Path,
    count: int,
    seed: int,
    title: str,
    release: tuple[tuple[str, float], ...],
    parameters: Mapping[str, float],
    max_contacts: int,
    format: str | None,
    own: tuple[str, ...],
    backend: Literal["auto", "c", "numpy"],
) -> None:
    """Show a sample of a table of releases in space, in motion.

    FILE is a table as `hoopgen batch` reads it, or the results that it writes: CSV, Parquet or
    Arrow, one release a row, with the units in the columns' names.
    """
    import numpy as np

    import hoopgen
    from hoopgen import viewer
    from hoopgen.viewer.sample import sample

    chosen = sample(file, count, seed, parameters, release=dict(release), format=format, own=own)
    states, given = chosen.releases.states, chosen.releases.parameters
    shots = hoopgen.simulate(states, given, max_contacts=max_contacts, backend=backend, record=True)
    invalid = int(np.count_nonzero(shots.outcome == hoopgen.Outcome.INVALID))
    labels = [f"Row {row + 1}" for row in chosen.rows]
    about = _about(file, chosen, seed, invalid)
    viewer.view(shots, given, out, title=title, about=about, labels=labels)
    click.echo(printable(f"{out}: {about}"))


def _about(file: Path, chosen: Sample, seed: int, invalid: int) -> str:
    """Say which rows are shown."""
    count = len(chosen.rows)
    if count == chosen.total:
        text = f"all {count} rows of {file.name}"
    else:
        text = f"{count} of {chosen.total} rows of {file.name}, chosen at random (seed {seed})"
    return f"{text}; {invalid} invalid, left out" if invalid else text
