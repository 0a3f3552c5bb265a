"""``hoopgen best``: from each place of the court the shot that a player makes most often."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import hoopgen
from hoopgen.core.units import DEGREE, display_unit
from hoopgen.study.questions.measured_specification import BestQuestion
from hoopgen.study.questions.settings import TableSettings
from hoopgen.text.numbers import format_interval, format_percent
from hoopgen.text.tables import table

from .command import command
from .messages import echo_json, echo_lines, examples, shown
from .options import json_option, picture_option, preset_options, units_option
from .player_option import fitted_player, from_table
from .question_options import question_options, setting_options
from .scene_option import engine_of, no_scene_option, parameters_of

if TYPE_CHECKING:
    import xarray as xr


@command(
    epilog=examples(
        "hoopgen best --makes 70% --preset nba --picture best.svg",
        "hoopgen best --makes 80% --preset fiba --step 1m --units us",
        "hoopgen best --from my_shots.csv --where 'player == Ann' --preset nba --json",
    )
)
@from_table
@setting_options(TableSettings, only="where")
@no_scene_option
@preset_options
@question_options(BestQuestion)
@picture_option("half court with each place's best shot")
@units_option
@json_option
def best(
    file: Path | None,
    where: tuple[str, ...],
    preset: str,
    settings: Mapping[str, float],
    picture: Path | None,
    as_json: bool,
    **options: Any,
) -> None:
    """Say which shot a player makes most often, from each place of the half court.

    From each place the speed and the angles of the best direct and of the best bank shot are
    searched, with the player's scatter; the shares are of fresh shots. A second search with
    another seed says how far the results are from exact.
    """
    engine = engine_of()
    parameters = parameters_of(engine, preset, settings)
    player: Any = None
    read = ""
    if file is not None:
        player, read = fitted_player(file, where, parameters, engine)
    elif where:
        raise click.UsageError("--where: there is no table; give --from")
    with shown() as progress:
        found = hoopgen.best_shots(player, parameters, progress=progress, **options)
    if picture is not None:
        hoopgen.plots.save(hoopgen.plots.plot_best_shots(found), picture)
    if as_json:
        echo_json(_record(found))
    else:
        echo_lines(_text(found))
    if read:
        echo_lines(f"\n{read}", err=as_json)


def _text(found: xr.Dataset) -> str:
    from hoopgen.study.questions.best_shots_result import describe_best_shots

    length, speed = display_unit("length"), display_unit("speed")
    heads = [f"x ({length.symbol})", f"y ({length.symbol})", "way", "made", "interval"]
    heads += [f"speed ({speed.symbol})", "angle"]
    rows = []
    for k in range(found.sizes["place"]):
        one = {name: found[name].values[k] for name in ("x", "y", *found.data_vars)}
        way = "bank" if one["bank"] else "direct"
        rows.append(
            [
                f"{one['x'] / length.size:.1f}",
                f"{one['y'] / length.size:.1f}",
                way if one["decided"] else f"{way}?",
                format_percent(float(one["probability"])),
                format_interval(float(one["low"]), float(one["high"])),
                f"{one['speed'] / speed.size:.2f}",
                f"{one['elevation'] / DEGREE:.1f}\N{DEGREE SIGN}",
            ]
        )
    note = "way?: bank and direct shot are not told apart there."
    return "\n".join(
        [table(heads, rows, right=(0, 1, 3, 4, 5, 6)), "", note, describe_best_shots(found)]
    )


def _record(found: xr.Dataset) -> dict[str, Any]:
    columns = {str(name): found[name].values.tolist() for name in ("x", "y", *found.data_vars)}
    clean = {
        name: [None if value != value else value for value in column]
        for name, column in columns.items()
    }
    return {"places": clean, **{str(name): value for name, value in found.attrs.items()}}
