"""``hoopgen calibrate``: restitution and friction of a hoop from how measured shots ended."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

import hoopgen
from hoopgen.study.questions.measured_specification import CalibrateQuestion

from .command import command
from .messages import echo_json, echo_lines, examples
from .options import (
    instrument_option,
    json_option,
    override_option,
    picture_option,
    preset_options,
    units_option,
)
from .path_types import FILE
from .question_options import question_options
from .scene_option import engine_of, scene_option
from .shot_files import reading_of, simulation_options, with_its_scene
from .types import PARAMETER_BOUNDS

_COLUMNS = """\b
One row is a shot: its release, as for hoopgen batch, and what was seen of its end:
  made            or outcome: made, missed; true, false; 1, 0
  contacts        impacts before the end
  first           body touched first: ring, backboard, bridge or none
  rebound_x rebound_y   where a miss came down to --catching-height, rebound_x_ft ...
  sd_speed_m_s ...      standard errors of the release, as hoopgen fit writes them
Only made or outcome is needed; an empty cell is not known.

"""


@command(
    short_help="Find restitution and friction from how shots ended.",
    epilog=_COLUMNS
    + examples(
        "hoopgen calibrate shots.csv --vary restitution --preset nba",
        "hoopgen calibrate shots.csv --vary ring_restitution --vary ring_friction=0.1:1.0 \\",
        "    --scene court --preset nba \\",
        "    --instrument speed=3cm/s --instrument elevation=0.5deg",
    ),
)
@click.argument("file", type=FILE, is_eager=True, callback=with_its_scene)
@scene_option
@preset_options
@override_option
@instrument_option()
@question_options(CalibrateQuestion, vary={"type": PARAMETER_BOUNDS})
@picture_option("profiles of the likelihood")
@units_option
@json_option
def calibrate(
    file: Path,
    override: bool,
    instrument: Mapping[str, float],
    picture: Path | None,
    as_json: bool,
    preset: str,
    settings: Mapping[str, float],
    **options: Any,
) -> None:
    """Find the restitution and friction with which measured shots most likely end as they did.

    FILE is CSV, Parquet, Arrow or .xlsx. Each release is simulated many times with its measuring
    errors at each point of a grid; the interval of each parameter is that of its profile
    likelihood. A parameter that the shots do not tell is called not identified.
    """
    from hoopgen.study.recovery.calibrate_table import calibrate_table

    engine = engine_of()
    asked, assumption = simulation_options(engine, file, reading_of(dict(options)))
    found = calibrate_table(
        file,
        scene=engine,
        parameters=asked["parameters"],
        errors=instrument or None,
        override=override,
        **options,
    )
    if picture is not None:
        hoopgen.plots.save(found.scene.plot(), picture)
    if as_json:
        echo_json(found.scene.as_dict())
    else:
        echo_lines(str(found.scene))
    echo_lines(f"\n{found.read}", err=as_json)
    if assumption:
        click.echo(assumption, err=True)
