"""``hoopgen best``: from each place of the court the shot that a player makes most often."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import hoopgen
from hoopgen.core.units import DEGREE, column_name, display_unit
from hoopgen.report.quantities import for_json
from hoopgen.study.questions.measured_specification import BestQuestion
from hoopgen.text.numbers import format_interval, format_percent, format_points
from hoopgen.text.tables import table

from .command import command
from .messages import echo_json, echo_lines, examples, shown
from .options import json_option, picture_option, preset_options, units_option
from .place_option import player_place_option
from .player_option import TableOptions, fitted_player, from_table
from .question_options import question_options
from .scene_option import engine_of, scene_option

if TYPE_CHECKING:
    import xarray as xr

    from hoopgen.simulation.engine import Engine


@command(
    short_help="Say which shot a player makes most often from each place.",
    epilog=examples(
        "hoopgen best --makes 70% --preset nba --picture best.svg",
        "hoopgen best --makes 80% --preset fiba --step 1m --units us",
        "hoopgen best --scene court --preset nba --step 3m --shots 2000",
        "hoopgen best --from my_shots.csv --where 'player == Ann' --preset nba --json",
    ),
)
@from_table
@player_place_option("Where all rows of the table were released")
@scene_option
@preset_options
@question_options(BestQuestion)
@picture_option("half court with each place's best shot")
@units_option
@json_option
def best(
    file: Path | None,
    table: TableOptions,
    place: str | None,
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
    if file is not None and options["makes"] is not None:
        raise click.UsageError("--from has the player's releases; leave out --makes")
    if file is None and place is not None:
        raise click.UsageError("--place: it is of measured releases; give --from")
    player = fitted_player(file, table, place, engine, preset, settings)
    with shown() as progress:
        found = hoopgen.best_shots(
            player.fitted, player.parameters, scene=engine, progress=progress, **options
        )
    if picture is not None:
        hoopgen.plots.save(hoopgen.plots.plot_best_shots(found), picture)
    if as_json:
        echo_json(_record(found, engine))
    else:
        echo_lines(_text(found))
    player.echo(err=as_json)


def _text(found: xr.Dataset) -> str:
    from hoopgen.study.questions.best_shots_result import describe_best_shots

    length, speed = display_unit("length"), display_unit("speed")
    heads = [f"x ({length.symbol})", f"y ({length.symbol})", "way", "made", "interval"]
    heads += ["lead (points)", f"speed ({speed.symbol})", "angle"]
    rows = []
    for k in range(found.sizes["place"]):
        one = {name: found[name].values[k] for name in ("x", "y", *found.data_vars)}
        way = "bank" if one["bank"] else "direct"
        lead = (format_points(float(one[f"lead_{end}"])) for end in ("low", "high"))
        rows.append(
            [
                f"{one['x'] / length.size:.1f}",
                f"{one['y'] / length.size:.1f}",
                way if one["decided"] else f"{way}?",
                format_percent(float(one["probability"])),
                format_interval(float(one["low"]), float(one["high"])),
                " to ".join(lead),
                f"{one['speed'] / speed.size:.2f}",
                f"{one['elevation'] / DEGREE:.1f}\N{DEGREE SIGN}",
            ]
        )
    notes = ["lead: by how much more often it goes in than the best shot of the other way."]
    if not found["decided"].values.all():
        notes.append("way?: that may be 0, or less.")
    columns = table(heads, rows, right=(0, 1, 3, 4, 5, 6, 7))
    return "\n".join([columns, "", " ".join(notes), describe_best_shots(found)])


def _record(found: xr.Dataset, engine: Engine) -> dict[str, Any]:
    """Return all numbers; names have their units."""
    from hoopgen.study.named_units import in_units, named

    columns = {
        column_name(str(name), found[name].attrs["units"]): found[name].values.tolist()
        for name in ("x", "y", *found.data_vars)
    }
    clean = {
        name: [None if value != value else value for value in column]
        for name, column in columns.items()
    }
    said = {str(name): value for name, value in found.attrs.items()}
    player, parameters = (json.loads(said.pop(name)) for name in ("player", "parameters"))
    nested = {
        "player": in_units(player),
        "parameters": {named(name, engine): value for name, value in parameters.items()},
    }
    return {"places": clean, "step_m": said.pop("step"), **said, **for_json(nested)}
