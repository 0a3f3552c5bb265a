"""The player of a command: measured releases of a table, to which a scatter is fitted."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from hoopgen.hoop.court_places import find_place
from hoopgen.text.shorten import join_names

from .options import instrument_option, reading_options, release_option
from .path_types import FILE
from .question_options import together
from .scene_option import given
from .shot_files import READING, names_table, option_of, reading_of

if TYPE_CHECKING:
    from hoopgen.study.tables.reading import ReadingOptions

_FROM = together(
    click.option(
        "--from",
        "file",
        type=FILE,
        help="Measured releases, .csv, .parquet, .arrow or .xlsx, to which the player is fitted, "
        "in place of the default player.",
    ),
    release_option,
    instrument_option(),
    reading_options,
)


@dataclass(frozen=True)
class TableOptions:
    """Settings for reading the table of measured releases.

    Attributes
    ----------
    reading
        The format, the columns and the rows.
    release
        Variables that all rows share, SI.
    errors
        Variances of the measuring errors by variable, in place of columns, SI.
    """

    reading: ReadingOptions
    release: Mapping[str, float]
    errors: Mapping[str, float]


def from_table(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add ``--from`` and what goes with it; give `file` and `table` to the command."""

    @functools.wraps(command)
    def collected(
        *arguments: Any,
        file: Path | None,
        release: Mapping[str, float],
        instrument: Mapping[str, float],
        **options: Any,
    ) -> Any:
        stray = [name for name in ("release", "instrument", *READING) if given(name)]
        if file is None and stray:
            raise click.UsageError(f"{option_of(stray[0])}: there is no table; give --from")
        errors = {name: sd**2 for name, sd in instrument.items()}
        table = TableOptions(reading_of(options), release, errors)
        return command(*arguments, file=file, table=table, **options)

    decorated: Callable[..., Any] = _FROM(collected)
    return decorated


def fitted_player(
    file: Path | None, options: TableOptions, place: str | None, parameters: Any, engine: Any
) -> tuple[Any, str]:
    """Return the player fitted to a table, and how it was read; None and "" without a table.

    Parameters
    ----------
    file
        A table of measured releases: CSV, Parquet, Arrow or .xlsx.
    options
        How it is read.
    place
        The name of the place where all rows were released; None where the table says it.
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
    click.UsageError
        If the options say twice where the rows were released.
    ValueError
        If the table cannot be read, or has too few rows to fit a player to.
    """
    if file is None:
        return None, ""
    from hoopgen.study.models.scatter import Scatter

    release = dict(options.release)
    if place is not None:
        if both := [name for name in ("distance", "angle", "x", "y") if name in release]:
            spelled = join_names(f"--release {name}" for name in both)
            raise click.UsageError(f"--place says where; leave out {spelled}")
        release |= find_place(place, parameters).variables
    source = options.reading.source(file)
    table = options.reading.interpreted(source, parameters, release, override=True, scene=engine)
    measured, invalid = table.measured(source)
    columns: dict[str, Any] = {**table.origin.release, **measured}
    errors: Any = {
        name: one
        for name, one in {**table.error_variances(source), **options.errors}.items()
        if np.ndim(columns.get(name, 0.0))
    }
    with names_table("--from", file):
        fitted = Scatter.fit(columns, measurement_covariance=errors)
    return fitted, f"{fitted}\n\n{table.interpretation}\n{invalid}"
