"""``hoopgen coach``: what a player should practise, in words for players."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

import hoopgen
from hoopgen.hoop.court_places import PLACES
from hoopgen.study.questions.measured_specification import CoachQuestion
from hoopgen.study.questions.settings import TableSettings

from .command import command
from .messages import echo_json, echo_lines, examples
from .options import json_option, picture_option, preset_options
from .path_types import OUT
from .place_option import PlaceName
from .player_option import fitted_player, from_table
from .question_options import question_options, setting_options
from .scene_option import engine_of, scene_option


@command(
    epilog=examples(
        "hoopgen coach --makes 70% --place 'free throw'",
        "hoopgen coach --makes 35% --place 'corner three' --picture advice.svg",
        "hoopgen coach --from my_shots.csv --where 'player == Ann' --out ann.html",
    )
)
@from_table
@setting_options(TableSettings, only="where")
@click.option("--place", type=PlaceName(), help=f"From where: {', '.join(PLACES)}.")
@scene_option
@preset_options
@question_options(CoachQuestion)
@click.option(
    "--out", type=OUT, help="A page for players, .html: the advice, pictures, before and after."
)
@picture_option("gains")
@json_option
def coach(
    file: Path | None,
    where: tuple[str, ...],
    place: str | None,
    preset: str,
    settings: Mapping[str, float],
    override: bool,
    out: Path | None,
    picture: Path | None,
    as_json: bool,
    **options: Any,
) -> None:
    """Find the part of a release that is worth practising most, in feet, mph and rpm.

    Each part of the player's spread (speed, arc, left-right, spin) is halved alone, and each habit
    is changed a little. The answer is how many more shots go in, with confidence intervals.
    """
    from hoopgen.study.named_units import in_units

    engine = engine_of()
    if file is not None and (options["makes"] is not None or place is not None):
        raise click.UsageError("--from has the player's releases; leave out --makes, --place")
    player = fitted_player(file, where, engine, preset, settings, override=override)
    found = hoopgen.coach(
        player.fitted, place=place, parameters=player.parameters, scene=engine, **options
    )
    if picture is not None:
        hoopgen.plots.save(found.plot(), picture)
    if out is not None:
        found.page(out, read=player.read)
    if as_json:
        echo_json(in_units(found.as_dict(), engine))
    else:
        echo_lines(str(found))
    player.echo(err=as_json)
