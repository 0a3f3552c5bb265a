"""``hoopgen fit``: from a table of tracks to a table of releases."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from hoopgen.study.questions.measured_specification import FitQuestion

from .command import command
from .messages import echo_json, echo_lines, examples
from .options import json_option, preset_options
from .path_types import FILE, OUT
from .question_options import question_options
from .scene_option import engine_of, parameters_of, scene_option

_COLUMNS = """\b
One row is a frame; the columns, with their units after them (SI without):
  track           label of the track; --track names another column
  time            of the frame, time_s time_ms ...
  x y z           position of the ball's centre in hoopgen's axes, x_m x_ft x_in ...
A column of another name is read with --column time_ms=Timestamp. Rows need no order.

"""


@command(
    short_help="Fit the releases of measured tracks of the ball.",
    epilog=_COLUMNS
    + examples(
        "hoopgen fit tracks.csv --out releases.csv --preset nba",
        "hoopgen fit tracks.csv --out releases.csv --preset nba --noise 2cm --track shot \\",
        "    --release-time detect --keep player --backspin 3Hz",
        "hoopgen fit tracks.csv --out releases.csv --scene court --preset nba --backspin 3Hz \\",
        "    --backspin-sd 1Hz",
        "hoopgen batch releases.csv --out results.csv",
    ),
)
@click.argument("file", type=FILE)
@click.option(
    "--out",
    type=OUT,
    required=True,
    help=".csv, .parquet or .arrow: the releases with standard errors, one row a track.",
)
@scene_option
@preset_options
@question_options(FitQuestion)
@json_option
def fit(
    file: Path,
    out: Path,
    preset: str,
    settings: Mapping[str, float],
    as_json: bool,
    **options: Any,
) -> None:
    """Fit the releases of a table of tracks, positions of the ball by time.

    FILE is CSV, Parquet, Arrow or .xlsx. Each track is the flight of a ball from its release to
    its first contact; frames after that are left out, unless --backspin-sd asks for the backspin.
    """
    from hoopgen.study.named_units import in_units
    from hoopgen.study.recovery.table import fit_table

    engine = engine_of()
    parameters = parameters_of(engine, preset, settings)
    found = fit_table(file, out, scene=engine, parameters=parameters, **options)
    if as_json:
        echo_json(in_units(found.fitted.as_dict()))
        echo_lines(found.read, err=True)
        return
    echo_lines(f"{found.read}\n{found.fitted.summary}; in {out}")
