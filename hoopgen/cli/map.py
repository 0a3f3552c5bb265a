"""``hoopgen map``: what becomes of a shot, or how probably it is made, over its variables."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np
from numpy.typing import NDArray

from hoopgen.cli.command import command
from hoopgen.cli.options import UNITS_IN_WORDS, examples, picture_option, units_option
from hoopgen.cli.releasing import (
    Releasing,
    from_option,
    release_needs,
    release_options,
    work_options,
)
from hoopgen.cli.types import AXIS, COUNT, MAP, once
from hoopgen.outputs import write, written_text

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["map_"]

_FREE_THROW = "--backspin 3Hz --height 7ft --distance 13.75ft"


@command(
    "map",
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
@click.option(
    "--over",
    type=AXIS,
    multiple=True,
    callback=once,
    required=True,
    help="A variable and its values, from:to:count or one,two,three; may be repeated.",
)
@release_options
@from_option
@click.option(
    "--shots",
    type=COUNT,
    help="Of each cell, with --scatter or --from. Of more than a --folder has, only the rest is "
    "thrown.  [default: 10,000]",
)
@click.option(
    "--out", type=MAP, help="Write the map: .nc (netCDF, for xarray) or .csv; SI, with the units."
)
@picture_option("map")
@work_options
@units_option
def map_(
    over: Mapping[str, NDArray[np.float64]],
    releasing: Releasing,
    out: Path | None,
    picture: Path | None,
    **work: Any,
) -> None:
    """Map a shot over any of its variables.

    Each cell is one shot; with --scatter or --from, the probability that it is made. The variables
    that are not mapped over are given as for `hoopgen shot`; with --scene, a component of
    --position or --velocity that is mapped over takes the place of the one given.
    """
    import hoopgen
    from hoopgen.cli.progress import shown
    from hoopgen.told import footer, told_by

    model, parameters = releasing.model(over=over)
    with shown() as progress:
        dataset = hoopgen.map(
            model, over, parameters, scene=releasing.engine, progress=progress, **work
        )
    if out is not None:
        _write(dataset, out)
    if picture is not None:
        from hoopgen import plots

        plots.save(plots.plot_map(dataset), picture)
    click.echo(_summary(dataset))
    click.echo(f"\n{footer(9, told_by(dataset))}")


def _write(dataset: xr.Dataset, file: Path) -> None:
    if file.suffix.lower() == ".nc":
        write(file, bytes(dataset.to_netcdf(engine="scipy")))
        return
    columns = dict(_columns(dataset))
    with written_text(file) as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(
            zip(*(column.ravel().tolist() for column in columns.values()), strict=True)
        )


def _columns(dataset: xr.Dataset) -> Iterator[tuple[str, NDArray[Any]]]:
    """Yield names and cells of the columns: what was mapped over, what was given, what came out.

    The names of the variables are those that `hoopgen batch` reads, with their units.
    """
    from hoopgen.units import column_name

    def named(name: str) -> str:
        return column_name(name, dataset[name].attrs.get("units", ""))

    axes = _axes(dataset)
    shape = tuple(dataset.sizes[name] for name in axes)
    for name, values in zip(
        axes, np.meshgrid(*(dataset[n] for n in axes), indexing="ij"), strict=True
    ):
        yield named(name), values
    for label, coordinate in dataset.coords.items():
        if not coordinate.dims:
            yield named(str(label)), np.broadcast_to(coordinate.values, shape)
    for name, value in _shared(dataset).items():
        yield name, np.broadcast_to(value, shape)
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


def _axes(dataset: xr.Dataset) -> list[str]:
    """Return what was mapped over: dimensions of numbers, not of kinds or endings."""
    return [str(name) for name in dataset.dims if np.issubdtype(dataset[name].dtype, np.number)]


def _shared(dataset: xr.Dataset) -> dict[str, Any]:
    """Return what else is the same in all cells: scene, scatter, seed, and what computed."""
    told = dataset.attrs
    scene = json.loads(told["parameters"])
    sd = json.loads(told.get("sd", "{}"))
    pairs = json.loads(told.get("correlation", "[]"))
    return {
        **{name: value for name, value in scene.items() if name not in dataset.coords},
        **{f"sd_{name}": value for name, value in sd.items()},
        **{f"correlation_{one}_{other}": value for one, other, value in pairs},
        **{name: told[name] for name in ("max_contacts", "seed", "source") if name in told},
    }


def _summary(dataset: xr.Dataset) -> str:
    """Say how large the map is, and its best cell or the shares of its outcomes."""
    from hoopgen.phrases import counted, interval, percent
    from hoopgen.words import say

    axes = _axes(dataset)
    cells = " × ".join(f"{dataset.sizes[name]} {name}" for name in axes)
    if "outcome" in dataset:
        names = dataset["outcome"].attrs["flag_meanings"].split()
        shares = [np.mean(dataset["outcome"].values == code) for code in range(len(names))]
        said = [
            f"{percent(share)} {name}" for name, share in zip(names, shares, strict=True) if share
        ]
        return f"map    {cells}, one shot each\nshots  {', '.join(said)}"
    shots = f"map    {cells}, {counted(dataset['shots'].values.max(), 'shot')} each"
    if "count" in dataset:
        counts = dataset["count"].sum(axes)
        valid = counts.sum() - counts.sel(ending="invalid")
        said = [
            f"{percent(float(count / valid))} {name}"
            for name, count in zip(dataset["ending"].values, counts, strict=True)
            if count and name != "invalid"
        ]
        return f"{shots}\nends   {', '.join(said) or 'none: no cell can be simulated'}"
    probability = dataset["probability"]
    if probability.isnull().all():
        return f"{shots}\nbest   none: no cell can be simulated"
    best = dataset.isel(probability.argmax(...))
    where = ", ".join(f"{name} {say(name, best[name].item())}" for name in axes)
    made, low, high = (best[name].item() for name in ("probability", "low", "high"))
    note = "its interval is that of one cell, and the best of many is a little too good"
    if "interval" in dataset.attrs:
        note += f"; {dataset.attrs['interval']}"
    ends = f"({interval(low, high)})"
    return f"{shots}\nbest   {percent(made)} made {ends} at {where}\n       {note}"
