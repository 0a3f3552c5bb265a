"""``hoopgen map``: what becomes of a shot, or how probably it is made, over its variables."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np
from numpy.typing import NDArray

import hoopgen
from hoopgen.core.files import atomic_text_file, write
from hoopgen.core.units import column_name
from hoopgen.report.provenance import describe_dataset, footer
from hoopgen.report.quantities import for_json, format_variable
from hoopgen.study.questions.specification import MapQuestion
from hoopgen.text.numbers import format_count, format_interval, format_percent

from .command import command
from .messages import echo_json, examples, shown
from .options import UNITS_IN_WORDS, json_option, picture_option, units_option
from .path_types import MAP
from .question_options import question_options
from .release_options import Releasing, from_option, release_needs, release_options

if TYPE_CHECKING:
    import xarray as xr

    from hoopgen.simulation.engine import Engine

_FREE_THROW = "--backspin 3Hz --height 7ft --distance 13.75ft"


@command(
    "map",
    short_help="Map a shot over any of its variables.",
    needs=release_needs,
    epilog=UNITS_IN_WORDS
    + examples(
        "hoopgen map --over elevation=45deg:60deg:61 --over speed=6.8:7.6:81 --picture map.svg \\",
        f"    {_FREE_THROW}",
        "hoopgen map --over elevation=45deg:60deg:31 --over aim=-10cm:20cm:31 --out map.nc \\",
        f"    {_FREE_THROW} \\",
        "    --scatter speed=0.07 --scatter elevation=1.3deg --scatter azimuth=1deg --shots 1e5",
    ),
)
@release_options
@from_option
@question_options(MapQuestion)
@click.option(
    "--out", type=MAP, help="Write the map: .nc (netCDF, for xarray) or .csv; SI, with the units."
)
@picture_option("map")
@units_option
@json_option
def map_(
    over: Mapping[str, NDArray[np.float64]],
    releasing: Releasing,
    out: Path | None,
    picture: Path | None,
    as_json: bool,
    **work: Any,
) -> None:
    """Map a shot over any of its variables.

    Each cell is one shot; with --scatter or --from, the probability that it is made. The variables
    that are not mapped over are given as for `hoopgen shot`; with --scene, a component of
    --position or --velocity that is mapped over takes the place of the one given.
    """
    model, parameters = releasing.model(over=over)
    options = {"scene": releasing.engine, **work}
    with shown() as progress:
        dataset = hoopgen.map(model, over, parameters, progress=progress, **options)
    if out is not None:
        _write(dataset, out)
    if picture is not None:
        hoopgen.plots.save(hoopgen.plots.plot_map(dataset), picture)
    if as_json:
        echo_json(_record(dataset, releasing.engine))
    else:
        click.echo(_summary(dataset))
        click.echo(f"\n{footer(9, describe_dataset(dataset))}")


def _write(dataset: xr.Dataset, file: Path) -> None:
    if file.suffix.lower() == ".nc":
        write(file, bytes(dataset.to_netcdf(engine="scipy")))
        return
    columns = dict(_columns(dataset))
    with atomic_text_file(file) as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(
            zip(*(column.ravel().tolist() for column in columns.values()), strict=True)
        )


def _columns(dataset: xr.Dataset) -> Iterator[tuple[str, NDArray[Any]]]:
    """Yield names and cells of the columns: what was mapped over, what was given, what came out.

    The names of the variables are those that `hoopgen batch` reads, with their units.
    """
    axes = _axes(dataset)
    shape = tuple(dataset.sizes[name] for name in axes)
    grid = np.meshgrid(*(dataset[n] for n in axes), indexing="ij")
    yield from zip((_unit_name(dataset, name) for name in axes), grid, strict=True)
    for name, value in (_given(dataset) | _shared(dataset)).items():
        yield name, np.broadcast_to(value, shape)
    yield from _found(dataset, axes)


def _unit_name(dataset: xr.Dataset, name: str) -> str:
    return column_name(name, dataset[name].attrs.get("units", ""))


def _given(dataset: xr.Dataset) -> dict[str, Any]:
    """Return the variables of the release that are the same in all cells."""
    same = (str(name) for name, coordinate in dataset.coords.items() if not coordinate.dims)
    return {_unit_name(dataset, name): dataset[name].item() for name in same}


def _found(dataset: xr.Dataset, axes: Sequence[str]) -> Iterator[tuple[str, NDArray[Any]]]:
    """Yield names and cells of what came out."""
    for label, variable in dataset.items():
        name = str(label)
        further = [dim for dim in variable.dims if dim not in axes]
        if further:
            for each in dataset[further[0]].values:
                yield f"{name}_{each}", variable.sel({further[0]: each}).values
        elif "flag_meanings" in variable.attrs:
            yield name, np.array(variable.attrs["flag_meanings"].split())[variable.values]
        else:
            yield name, variable.values


def _record(dataset: xr.Dataset, engine: Engine) -> dict[str, Any]:
    """Return all numbers, those of the cells in order with the last axis the fastest."""
    from hoopgen.study.named_units import in_units
    from hoopgen.study.questions.map_dataset import best_cell

    axes, attributes = _axes(dataset), dataset.attrs
    said = ("parameters", "sd", "correlation", "columns", "sha256")
    setting = {name: json.loads(attributes[name]) for name in said if name in attributes}
    best = {"best": best_cell(dataset)} if "probability" in dataset else {}
    seed = {"seed": int(attributes["seed"])} if "seed" in attributes else {}
    shared = ("max_contacts", "confidence", "interval", "source", "scene")
    record = {
        "over": {_unit_name(dataset, name): dataset[name].values.tolist() for name in axes},
        "cells": {name: column.ravel().tolist() for name, column in _found(dataset, axes)},
        **in_units(best, engine),
        "setting": {"release": _given(dataset), **in_units(setting, engine)},
        **seed,
        **{name: attributes[name] for name in shared if name in attributes},
    }
    found: dict[str, Any] = for_json(record)
    return found


def _axes(dataset: xr.Dataset) -> list[str]:
    """Return the names that were mapped over: dimensions of numbers, not of kinds or endings."""
    return [str(name) for name in dataset.dims if np.issubdtype(dataset[name].dtype, np.number)]


def _shared(dataset: xr.Dataset) -> dict[str, Any]:
    """Return the values common to all cells: scene, scatter, seed, and hoopgen's version."""
    attributes = dataset.attrs
    scene = json.loads(attributes["parameters"])
    sd = json.loads(attributes.get("sd", "{}"))
    pairs = json.loads(attributes.get("correlation", "[]"))
    return {
        **{name: value for name, value in scene.items() if name not in dataset.coords},
        **{f"sd_{name}": value for name, value in sd.items()},
        **{f"correlation_{one}_{other}": value for one, other, value in pairs},
        **{n: attributes[n] for n in ("max_contacts", "seed", "source") if n in attributes},
    }


def _summary(dataset: xr.Dataset) -> str:
    """Describe the size of the map, and its best cell or the shares of its outcomes."""
    from hoopgen.study.questions.map_dataset import best_cell, shares_of_ends

    axes = _axes(dataset)
    cells = " × ".join(f"{dataset.sizes[name]} {name}" for name in axes)
    shares = shares_of_ends(dataset) or {}
    ends = ", ".join(f"{format_percent(share)} {name}" for name, share in shares.items() if share)
    if "outcome" in dataset:
        return f"map    {cells}, one shot each\nshots  {ends}"
    shots = f"map    {cells}, {format_count(dataset['shots'].values.max(), 'shot')} each"
    if "count" in dataset:
        return f"{shots}\nends   {ends or 'none: no cell can be simulated'}"
    best = best_cell(dataset)
    if best is None:
        return f"{shots}\nbest   none: no cell can be simulated"
    where = ", ".join(f"{name} {format_variable(name, best[name])}" for name in axes)
    note = "its interval is that of one cell, and the best of many is a little too good"
    if "interval" in dataset.attrs:
        note += f"; {dataset.attrs['interval']}"
    interval = format_interval(best["low"], best["high"])
    made = f"{format_percent(best['probability'])} made ({interval})"
    return f"{shots}\nbest   {made} at {where}\n       {note}"
