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

import hoopgen
from hoopgen.core.units import column_name, display_unit
from hoopgen.report.provenance import describe_dataset, footer
from hoopgen.report.quantities import for_json, format_launch, format_variable
from hoopgen.study.questions.specification import BankQuestion
from hoopgen.text.numbers import format_interval, format_percent, format_points
from hoopgen.text.tables import table

from .command import command
from .messages import echo_json, examples, shown
from .options import UNITS_IN_WORDS, json_option, picture_option, units_option
from .question_options import question_options
from .release_options import Releasing, from_option, place_needs, release_options
from .types import number_cell

if TYPE_CHECKING:
    import xarray as xr

    from hoopgen.simulation.engine import Engine

_PLACE_VARIABLES = ("distance", "angle", "x", "y")

_SCATTER = "--scatter speed=0.07 --scatter elevation=1.3deg --scatter azimuth=1deg"


@command(
    short_help="Say from where a bank shot is better than a direct one.",
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
@release_options
@from_option
@question_options(BankQuestion, optional=("places",))
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
    from hoopgen.study.questions.bank import bank_or_direct, places_of

    given = {*releasing.values, *(["aim"] if "speed" in releasing.values else [])}
    searched = (name for name in ("elevation", "aim", "azimuth") if name not in given)
    over = over or dict.fromkeys(searched)
    spots = places_of(_places(places, releasing.values))
    values = {n: value for n, value in releasing.values.items() if n not in _PLACE_VARIABLES}
    model, parameters = replace(releasing, values=values).model(over=over)
    with shown() as progress:
        work |= {"scene": releasing.engine, "progress": progress}
        dataset = bank_or_direct(model, spots, parameters, over=over, **work)
    if as_json:
        echo_json(_record(dataset, releasing.engine))
    else:
        click.echo(_text(dataset))
    if picture is not None:
        if dataset["touch_y"].isnull().all():
            raise click.UsageError("--picture: no place has a bank shot to draw")
        hoopgen.plots.save(hoopgen.plots.plot_aim_points(dataset, parameters), picture)


def _places(places: Mapping[str, Any], values: Mapping[str, float]) -> dict[str, Any]:
    """Return the places that are given: by the option of that name, and by those of the release."""
    one = {name: [values[name]] for name in _PLACE_VARIABLES if name in values}
    if twice := [name for name in one if name in places]:
        raise click.UsageError(f"--{twice[0]} and --places {twice[0]}=...: leave one out")
    given = {**one, **places}
    if not given:
        raise click.UsageError("from where? Give --distance and --angle, --x and --y, or --places")
    return {"angle": [0.0], **given} if set(given) == {"distance"} else given


def _text(dataset: xr.Dataset) -> str:
    """Describe one place at length, or many in a table; and the provenance."""
    from hoopgen.study.questions.bank import verdict

    if dataset.sizes["place"] == 1:
        lines = _one(dataset.isel(place=0))
    else:
        lines = [_many(dataset), "", verdict(dataset)[2]]
    level = format_percent(dataset.attrs["confidence"], None)
    shots = f"{dataset.attrs['shots']:,} fresh ones of each way, from each place; {level} intervals"
    if "columns" in dataset.attrs:
        shots = (
            "each measured release, held out of its search, each way from each place; "
            f"{level} intervals of the sample"
        )
    return "\n".join([*lines, "", footer(9, {"shots": shots} | describe_dataset(dataset))])


def _one(here: xr.Dataset) -> list[str]:
    from hoopgen.study.questions.optimum_result import touching, towards

    x, y = here["x"].item(), here["y"].item()
    distance, angle = math.hypot(x, y), math.atan2(y, x)
    lines = [
        f"place    {format_variable('distance', distance)} from the ring, "
        f"{format_variable('angle', angle)} around it "
        f"(x {format_variable('x', x)}, y {format_variable('y', y)})"
    ]
    for way in here["way"].values.tolist():
        best = {str(name): one.item() for name, one in here.sel(way=way).items()}
        if math.isnan(best["speed"]):
            lines.append(f"{way:8} none that was tried goes in")
            continue
        shot = [format_launch(best), towards(best["azimuth"])]
        if way == "bank":
            shot.append(touching(best))
        lines.append(
            f"{way:8} {format_percent(best['probability'])} "
            f"({format_interval(best['low'], best['high'])}) from {', '.join(shot)}"
        )
    difference, low, high = (here[f"difference{end}"].item() for end in ("", "_low", "_high"))
    better = "it is not decided which is better"
    if low > 0.0 or high < 0.0:
        better = f"the {'bank' if low > 0.0 else 'direct'} shot is better"
    lines.append(
        f"verdict  bank less direct {format_points(difference)} points ({format_points(low)} to "
        f"{format_points(high)}): {better}"
    )
    return lines


def _many(dataset: xr.Dataset) -> str:

    rows = []
    for place in range(dataset.sizes["place"]):
        here = dataset.isel(place=place)
        x, y = here["x"].item(), here["y"].item()
        polar = {"distance": math.hypot(x, y), "angle": math.atan2(y, x)}
        rows.append(
            [
                *(number_cell(name, value) for name, value in (polar | {"x": x, "y": y}).items()),
                *map(format_percent, here["probability"].values.tolist()),
                *(format_points(here[f"difference{end}"].item()) for end in ("", "_low", "_high")),
                *(number_cell("aim", here[name].item()) for name in ("touch_y", "touch_z")),
            ]
        )
    length, angle = display_unit("length").symbol, display_unit("angle").symbol
    small = display_unit("short").symbol
    head = [f"dist. ({length})", f"angle ({angle})", f"x ({length})", f"y ({length})"]
    head += ["direct", "bank", "points", "from", "to", f"y ({small})", f"z ({small})"]
    groups = [(6, 8, "bank less direct"), (9, 10, "touches at")]
    return table(head, rows, right=range(len(head)), groups=groups)


def _record(dataset: xr.Dataset, engine: Engine) -> dict[str, Any]:
    """Return all numbers; names have their units."""
    from hoopgen.study.named_units import named

    places = [dataset.isel(place=place) for place in range(dataset.sizes["place"])]
    record = {
        "places": [_place(here) for here in places],
        **{name: dataset.attrs[name] for name in ("confidence", "shots", "source")},
        "parameters": {
            named(name, engine): value
            for name, value in json.loads(dataset.attrs["parameters"]).items()
        },
        **describe_dataset(dataset),
        "seed": int(dataset.attrs["seed"]),
    }
    return {name: for_json(value) for name, value in record.items()}


def _place(here: xr.Dataset) -> dict[str, Any]:
    """Return the numbers of a place, and those of each way in."""
    by_way = [str(name) for name, one in here.items() if "way" in one.dims]
    ways = {way: _numbers(here.sel(way=way), by_way) for way in here["way"].values.tolist()}
    alike = [str(name) for name in here if name not in by_way]
    return _numbers(here, ("x", "y")) | ways | _numbers(here, alike)


def _numbers(here: xr.Dataset, names: Iterable[str]) -> dict[str, float]:
    return {column_name(name, here[name].attrs["units"]): here[name].item() for name in names}
