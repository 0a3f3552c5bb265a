"""The player of a command: measured releases of a table, to which a scatter is fitted."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hoopgen.hoop.court_places import find_place
from hoopgen.text.shorten import join_names

from .messages import echo_lines
from .options import instrument_option, override_option, reading_options, release_option
from .path_types import FILE
from .question_options import together
from .scene_option import given, parameters_of
from .shot_files import (
    READING,
    names_table,
    option_of,
    reading_of,
    simulation_options,
    with_its_scene,
)

if TYPE_CHECKING:
    from hoopgen.simulation.engine import Engine
    from hoopgen.study.models.fitted_scatter import FittedScatter
    from hoopgen.study.models.scatter import Scatter
    from hoopgen.study.tables.reading import ReadingOptions

_FROM = together(
    click.option(
        "--from",
        "file",
        type=FILE,
        is_eager=True,
        callback=with_its_scene,
        help="Measured releases, .csv, .parquet, .arrow or .xlsx, to which the player is fitted, "
        "in place of the default player; a file of results says the scene, too.",
    ),
    override_option,
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
    override
        True if the options replace the scene that a file of results says.
    """

    reading: ReadingOptions
    release: Mapping[str, float]
    errors: Mapping[str, float]
    override: bool


def from_table(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add ``--from`` and what goes with it; give `file` and `table` to the command."""

    @functools.wraps(command)
    def collected(
        *arguments: Any,
        file: Path | None,
        release: Mapping[str, float],
        instrument: Mapping[str, float],
        override: bool,
        **options: Any,
    ) -> Any:
        stray = [name for name in ("release", "instrument", "override", *READING) if given(name)]
        if file is None and stray:
            raise click.UsageError(f"{option_of(stray[0])}: there is no table; give --from")
        errors = {name: sd**2 for name, sd in instrument.items()}
        table = TableOptions(reading_of(options), release, errors, override)
        return command(*arguments, file=file, table=table, **options)

    decorated: Callable[..., Any] = _FROM(collected)
    return decorated


@dataclass(frozen=True)
class Player:
    """The player of a command, and the scene.

    Attributes
    ----------
    fitted
        The scatter fitted to the table; None without a table.
    parameters
        Of the scene: those of the options, or else those that a file of results says; SI.
    read
        How the table was read, line by line; empty without a table.
    assumption
        The scene that is assumed where neither the table nor an option names one; else empty.
    """

    fitted: FittedScatter[Scatter] | None
    parameters: Mapping[str, float]
    read: str = ""
    assumption: str = ""

    def echo(self, *, err: bool) -> None:
        """Print how the table was read, to stderr if `err`; what is assumed always goes there."""
        if self.read:
            echo_lines(f"\n{self.read}", err=err)
        if self.assumption:
            click.echo(self.assumption, err=True)


def fitted_player(
    file: Path | None,
    options: TableOptions,
    place: str | None,
    engine: Engine,
    preset: str,
    settings: Mapping[str, float],
) -> Player:
    """Return the player fitted to a table, in the scene of the table or of the options.

    Parameters
    ----------
    file
        A table of measured releases: CSV, Parquet, Arrow or .xlsx.
    options
        How it is read.
    place
        The name of the place where all rows were released; None where the table says it.
    engine
        The scene.
    preset, settings
        ``--preset`` and ``--set``.

    Raises
    ------
    click.UsageError
        If the options say twice where the rows were released.
    ValueError
        If the table cannot be read, contradicts the options, or has too few rows to fit a player.
    """
    if file is None:
        return Player(None, parameters_of(engine, preset, settings))
    from hoopgen.study.models.measured_columns import measuring_errors
    from hoopgen.study.models.scatter import Scatter
    from hoopgen.study.tables.provenance import origin_of

    asked, assumption = simulation_options(engine, file, options.reading)
    source = options.reading.source(file)
    parameters, release = asked["parameters"], dict(options.release)
    if place is not None:
        if both := [name for name in ("distance", "angle", "x", "y") if name in release]:
            spelled = join_names(f"--release {name}" for name in both)
            raise click.UsageError(f"--place says where; leave out {spelled}")
        origin = None if options.override else origin_of(source, engine)
        scene = parameters or (origin.parameters if origin else engine.parameters)
        release |= find_place(place, scene).variables
    table = options.reading.interpreted(
        source, parameters, release, override=options.override, scene=engine
    )
    measured, invalid = table.measured(source)
    columns: dict[str, Any] = {**table.origin.release, **measured}
    errors: Any = measuring_errors(columns, table.error_variances(source), options.errors)
    fitted: Any
    with names_table("--from", file):
        fitted = Scatter.fit(columns, measurement_covariance=errors)  # without groups, of one
    read = f"{fitted}\n\n{table.interpretation}\n{invalid}"
    return Player(fitted, table.origin.parameters, read, assumption)
