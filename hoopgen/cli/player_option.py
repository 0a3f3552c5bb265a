"""The player of a command: measured releases of a table, to which a scatter is fitted."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from .messages import echo_lines
from .options import override_option
from .path_types import FILE
from .question_options import together
from .scene_option import parameters_of
from .shot_files import simulation_options, with_its_scene

if TYPE_CHECKING:
    from hoopgen.simulation.engine import Engine
    from hoopgen.study.models.fitted_scatter import FittedScatter
    from hoopgen.study.models.scatter import Scatter

from_table = together(
    click.option(
        "--from",
        "file",
        type=FILE,
        callback=with_its_scene,
        help="Measured releases, .csv, .parquet, .arrow or .xlsx, to which the player is fitted, "
        "in place of the default player; a file of results says the scene, too.",
    ),
    override_option,
)
"""``--from`` of a command about a player, and ``--override`` with it."""


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
    where: tuple[str, ...],
    engine: Engine,
    preset: str,
    settings: Mapping[str, float],
    *,
    override: bool,
) -> Player:
    """Return the player fitted to a table, in the scene of the table or of the options.

    Parameters
    ----------
    file
        A table of measured releases: CSV, Parquet, Arrow or .xlsx.
    where
        Conditions such as ``player == Ann``, all of which a row has to meet.
    engine
        The scene.
    preset, settings
        ``--preset`` and ``--set``.
    override
        True if the options replace the scene that a file of results says.

    Raises
    ------
    click.UsageError
        If an option is of a table and there is none.
    ValueError
        If the table cannot be read, contradicts the options, or has too few rows to fit a player.
    """
    if file is None:
        for option, given in (("--where", where), ("--override", override)):
            if given:
                raise click.UsageError(f"{option}: there is no table; give --from")
        return Player(None, parameters_of(engine, preset, settings))
    from hoopgen.study.models.scatter import Scatter
    from hoopgen.study.tables.reading import ReadingOptions

    reading = ReadingOptions.from_options(where=where)
    asked, assumption = simulation_options(engine, file, reading)
    source = reading.source(file)
    table = reading.interpreted(source, asked["parameters"], override=override, scene=engine)
    measured, invalid = table.measured(source)
    errors: Any = table.error_variances(source)
    columns: dict[str, Any] = {**table.origin.release, **measured}
    fitted: Any = Scatter.fit(columns, measurement_covariance=errors)  # without groups, of one
    read = f"{fitted}\n\n{table.interpretation}\n{invalid}"
    return Player(fitted, table.origin.parameters, read, assumption)
