"""The player of a command: measured releases of a table, to which a scatter is fitted."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .types import FILE

from_table = click.option(
    "--from",
    "file",
    type=FILE,
    help="Measured releases, .csv, .parquet, .arrow or .xlsx, to which the player is fitted, in "
    "place of the default player.",
)
"""``--from`` of a command about a player."""


def fitted_player(
    file: Path, where: tuple[str, ...], parameters: Any, engine: Any
) -> tuple[Any, str]:
    """Return the player fitted to a table, and how it was read."""
    from hoopgen.study.models.scatter import Scatter
    from hoopgen.study.tables.reading import ReadingOptions

    reading = ReadingOptions.from_options(where=where)
    source = reading.source(file)
    table = reading.interpreted(source, parameters, override=True, scene=engine)
    measured, invalid = table.measured(source)
    errors: Any = table.error_variances(source)
    columns: dict[str, Any] = {**table.origin.release, **measured}
    fitted = Scatter.fit(columns, measurement_covariance=errors)
    return fitted, f"{fitted}\n\n{table.interpretation}\n{invalid}"
