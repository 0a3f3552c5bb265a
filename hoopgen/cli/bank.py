"""``hoopgen bank``: off the board or not, from places on the court, in words."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np
from numpy.typing import NDArray

from hoopgen.cli.command import command
from hoopgen.cli.options import (
    UNITS_IN_WORDS,
    confidence_option,
    examples,
    folder_option,
    json_option,
    picture_option,
    scheduler_option,
    seed_option,
    threads_option,
    units_option,
)
from hoopgen.cli.releasing import Releasing, from_option, hoop_release_options, place_needs
from hoopgen.cli.types import AXIS, BOUNDS, COUNT, once

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["bank"]

_OF_PLACES = ("distance", "angle", "x", "y")

_SCATTER = "--scatter speed=0.07 --scatter elevation=1.3deg --scatter azimuth=1deg"


@command(
    needs=place_needs,
    epilog=UNITS_IN_WORDS
    + examples(
        "hoopgen bank --distance 10ft --angle 60deg --height 7ft --backspin 3Hz \\",
        f"    {_SCATTER}",
        "hoopgen bank --places distance=2m:5m:4 --places angle=0deg:75deg:6 --height 7ft \\",
        f"    --backspin 3Hz {_SCATTER} \\",
        "    --shots 5000 --picture bank.svg",
        "hoopgen bank --over elevation=45deg:65deg --over aim --over azimuth --json \\",
        f"    --x 1.5m --y 2.6m --height 7ft {_SCATTER}",
    ),
)
@click.option(
    "--places",
    type=AXIS,
    multiple=True,
    callback=once,
    help="In place of one place: distance and angle, or x and y, each from:to:count or "
    "one,two,three; every combination. Given twice.",
)
@click.option(
    "--over",
    type=BOUNDS,
    multiple=True,
    callback=once,
    help="A variable to search over; without low and high, over the usual range. May be repeated.  "
    "[default: elevation, aim and azimuth, those that are not given]",
)
@hoop_release_options
@from_option
@click.option(
    "--shots",
    type=COUNT,
    default=20_000,
    show_default=True,
    help="Of the last step of each search, and of the estimates.",
)
@seed_option
@confidence_option
@threads_option
@folder_option
@scheduler_option
@picture_option("board and the floor")
@units_option
@json_option
def bank(
    places: Mapping[str, NDArray[np.float64]],
    over: Mapping[str, tuple[float, float] | None],
    releasing: Releasing,
    picture: Path | None,
    as_json: bool,
    **work: Any,
) -> None:
    """Say from where a bank shot is better than a direct one, and where on the board it aims.

    From each place the best shot of either way is searched, as `hoopgen optimum` does, given a
    player's scatter. Their probabilities are of fresh shots, the same errors for both, or of
    measured releases that had no part in the search; the bank shot is the better one where the
    interval of the difference is above 0.
    """
    from hoopgen.cli.progress import shown
    from hoopgen.study.bank import bank_or_direct, places_of

    searched = (name for name in ("elevation", "aim", "azimuth") if name not in releasing.values)
    over = over or dict.fromkeys(searched)
    spots = places_of(_places(places, releasing.values))
    values = {name: one for name, one in releasing.values.items() if name not in _OF_PLACES}
    model, parameters = replace(releasing, values=values).model(over=over)
    with shown() as progress:
        dataset = bank_or_direct(model, spots, parameters, over=over, progress=progress, **work)
    if picture is not None:
        from hoopgen import plots

        plots.save(plots.plot_aim_points(dataset, parameters), picture)
    if as_json:
        click.echo(json.dumps(_record(dataset), indent=2, allow_nan=False))
    else:
        click.echo(_said(dataset))


def _places(places: Mapping[str, Any], values: Mapping[str, float]) -> dict[str, Any]:
    """Return what places are said by: the option of that name, and those of the release."""
    one = {name: [values[name]] for name in _OF_PLACES if name in values}
    if twice := [name for name in one if name in places]:
        raise click.UsageError(f"--{twice[0]} and --places {twice[0]}=...: leave one out")
    given = {**one, **places}
    if not given:
        raise click.UsageError("from where? Give --distance and --angle, --x and --y, or --places")
    return {"angle": [0.0], **given} if set(given) == {"distance"} else given


# ------------------------------------------------------------------------------------ in words


def _said(dataset: xr.Dataset) -> str:
    """Say one place at length, or many in a table; and what it rests on."""
    from hoopgen.phrases import percent
    from hoopgen.study.bank import verdict
    from hoopgen.told import footer, told_by

    if dataset.sizes["place"] == 1:
        lines = _one(dataset.isel(place=0))
    else:
        lines = [_many(dataset), "", verdict(dataset)[2]]
    level = percent(dataset.attrs["confidence"], None)
    shots = f"{dataset.attrs['shots']:,} fresh ones of each way, from each place; {level} intervals"
    if "columns" in dataset.attrs:
        shots = (
            "each measured release, held out of its search, each way from each place; "
            f"{level} intervals of the sample"
        )
    return "\n".join([*lines, "", footer(9, {"shots": shots} | told_by(dataset))])


def _one(here: xr.Dataset) -> list[str]:
    from hoopgen.phrases import interval, percent, points
    from hoopgen.study.best import touching, towards
    from hoopgen.words import say

    x, y = here["x"].item(), here["y"].item()
    distance, angle = math.hypot(x, y), math.atan2(y, x)
    lines = [
        f"place    {say('distance', distance)} from the ring, {say('angle', angle)} around it "
        f"(x {say('x', x)}, y {say('y', y)})"
    ]
    for way in here["way"].values.tolist():
        found = {str(name): one.item() for name, one in here.sel(way=way).items()}
        if math.isnan(found["speed"]):
            lines.append(f"{way:8} none that was tried goes in")
            continue
        shot = [
            f"{say('speed', found['speed'])} at {say('elevation', found['elevation'])}",
            towards(found["azimuth"]),
        ]
        if way == "bank":
            shot.append(touching(found["touch_y"], found["touch_z"]))
        lines.append(
            f"{way:8} {percent(found['probability'])} "
            f"({interval(found['low'], found['high'])}) from {', '.join(shot)}"
        )
    difference, low, high = (
        here[name].item() for name in ("difference", "difference_low", "difference_high")
    )
    better = "it is not decided which is better"
    if low > 0.0 or high < 0.0:
        better = f"the {'bank' if low > 0.0 else 'direct'} shot is better"
    said = f"bank less direct {points(difference)} points ({points(low)} to {points(high)})"
    lines.append(f"verdict  {said}: {better}")
    return lines


def _many(dataset: xr.Dataset) -> str:
    from hoopgen.layout import table
    from hoopgen.phrases import percent, points
    from hoopgen.units import shown
    from hoopgen.words import say

    def cell(name: str, value: float) -> str:
        return "-" if math.isnan(value) else say(name, value, unit=False)

    rows = []
    for place in range(dataset.sizes["place"]):
        here = dataset.isel(place=place)
        x, y = here["x"].item(), here["y"].item()
        direct, bank = here["probability"].values.tolist()
        rows.append(
            [
                cell("distance", math.hypot(x, y)),
                cell("angle", math.atan2(y, x)),
                cell("x", x),
                cell("y", y),
                percent(direct),
                percent(bank),
                *(points(here[f"difference{end}"].item()) for end in ("", "_low", "_high")),
                *(cell("aim", here[name].item()) for name in ("touch_y", "touch_z")),
            ]
        )
    length, angle = shown("length").symbol, shown("angle").symbol
    small = shown("short").symbol
    head = [f"dist. ({length})", f"angle ({angle})", f"x ({length})", f"y ({length})"]
    head += ["direct", "bank", "points", "from", "to", f"y ({small})", f"z ({small})"]
    groups = [(6, 8, "bank less direct"), (9, 10, "touches at")]
    return table(head, rows, right=range(len(head)), groups=groups)


# ------------------------------------------------------------------------------------ as JSON


def _record(dataset: xr.Dataset) -> dict[str, Any]:
    """Return all numbers; names have their units."""
    from hoopgen.study.named import in_units
    from hoopgen.told import told_by
    from hoopgen.words import for_json

    places = [dataset.isel(place=place) for place in range(dataset.sizes["place"])]
    found = {
        "places": [_place(here) for here in places],
        **{name: dataset.attrs[name] for name in ("confidence", "shots", "source")},
        "parameters": in_units(json.loads(dataset.attrs["parameters"])),
        **told_by(dataset),
    }
    return {name: for_json(value) for name, value in found.items()}


def _place(here: xr.Dataset) -> dict[str, Any]:
    """Return the numbers of a place, and those of each way in."""
    by_way = [str(name) for name, one in here.items() if "way" in one.dims]
    ways = {way: _numbers(here.sel(way=way), by_way) for way in here["way"].values.tolist()}
    alike = [str(name) for name in here if name not in by_way]
    return _numbers(here, ("x", "y")) | ways | _numbers(here, alike)


def _numbers(here: xr.Dataset, names: Iterable[str]) -> dict[str, float]:
    from hoopgen.units import column_name

    return {column_name(name, here[name].attrs["units"]): here[name].item() for name in names}
