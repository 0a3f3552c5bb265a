"""The player of a command: measured releases of a table, to which a scatter is fitted."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from .path_types import FILE

from_table = click.option(
    "--from",
    "file",
    type=FILE,
    help="Measured releases, .csv, .parquet, .arrow or .xlsx, to which the player is fitted, in "
    "place of the default player.",
)
"""``--from`` of a command about a player."""


def fitted_player(
    file: Path | None, where: tuple[str, ...], parameters: Any, engine: Any
) -> tuple[Any, str]:
    """Return the player fitted to a table, and how it was read; None and "" without a table.

    Parameters
    ----------
    file
        A table of measured releases: CSV, Parquet, Arrow or .xlsx.
    where
        Conditions such as ``player == Ann``, all of which a row has to meet.
    parameters
        Parameters of the scene, SI.
    engine
        The scene.

    Returns
    -------
    tuple
        What `Scatter.fit` gives, and lines that say how each column was read.

    Raises
    ------
    ValueError
        If the table cannot be read, or has too few rows to fit a player to.
    """
    if file is None:
        if where:
            raise click.UsageError("--where: there is no table; give --from")
        return None, ""
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
