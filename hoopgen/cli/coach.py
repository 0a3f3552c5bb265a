"""``hoopgen coach``: what a player should practise, in words for players."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import click

import hoopgen
from hoopgen.core.units import display_system
from hoopgen.study.questions.measured_specification import CoachQuestion

from .command import command
from .messages import echo_json, echo_lines, examples, shown
from .options import json_option, picture_option, preset_options, units_option_of
from .path_types import OUT
from .place_option import player_place_option
from .player_option import TableOptions, fitted_player, from_table
from .question_options import question_options
from .scene_option import engine_of, scene_option


@command(
    short_help="Find what a player should practise most.",
    epilog=examples(
        "hoopgen coach --makes 70% --place 'free throw'",
        "hoopgen coach --makes 35% --place 'corner three' --picture advice.svg",
        "hoopgen coach --from my_shots.csv --where 'player == Ann' --out ann.html",
    ),
)
@from_table
@player_place_option("From where; with --from the place of all rows of the table")
@scene_option
@preset_options
@question_options(CoachQuestion)
@click.option(
    "--out", type=OUT, help="A page for players, .html: the advice, pictures, before and after."
)
@picture_option("gains")
@units_option_of("us")
@json_option
def coach(
    file: Path | None,
    table: TableOptions,
    place: str | None,
    preset: str,
    settings: Mapping[str, float],
    out: Path | None,
    picture: Path | None,
    as_json: bool,
    **options: Any,
) -> None:
    """Find the part of a release that is worth practising most.

    Each part of the player's spread (speed, arc, left-right, spin) is halved alone, and each habit
    is changed a little. The answer is how many more shots go in, with confidence intervals. It is
    in feet, mph and rpm, or with --units si in metres, m/s and Hz.
    """
    from hoopgen.study.named_units import in_units

    engine = engine_of()
    if file is not None and options["makes"] is not None:
        raise click.UsageError("--from has the player's releases; leave out --makes")
    player = fitted_player(file, table, place, engine, preset, settings)
    if file is not None:
        place = None  # that of the measured releases
    options |= {"place": place, "parameters": player.parameters, "scene": engine}
    with shown() as progress:
        found = hoopgen.coach(player.fitted, progress=progress, **options)
    found = replace(found, units=display_system())
    if picture is not None:
        hoopgen.plots.save(found.plot(), picture)
    if out is not None:
        found.page(out, read=player.read)
    if as_json:
        echo_json(in_units(found.as_dict(), engine))
    else:
        echo_lines(str(found))
    player.echo(err=as_json)
