"""Answers to questions that vary releases: maps, optima, bank or direct shots, tables of aim."""

from __future__ import annotations

import io
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyarrow as pa
import xarray as xr
from numpy.typing import NDArray

from hoopgen import plots
from hoopgen.core.files import write
from hoopgen.report.quantities import format_launch, format_range, format_variable
from hoopgen.scene.lookup import check_hoop
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.hoop import HOOP
from hoopgen.study.jobs.chunks import preparing, run
from hoopgen.study.jobs.monte_carlo import scene_identity
from hoopgen.study.models.resample import Resample
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.named_units import in_units
from hoopgen.study.questions.aim_table import aim_table, write_csv
from hoopgen.study.questions.bank import bank_or_direct, places_of, verdict
from hoopgen.study.questions.map import map as mapped
from hoopgen.study.questions.map_dataset import best_cell, shares_of_ends
from hoopgen.study.questions.optimum import optimum
from hoopgen.study.questions.optimum_result import Optimum
from hoopgen.study.questions.specification import (
    TOLERANCES,
    AimQuestion,
    BankQuestion,
    MapQuestion,
    OptimumQuestion,
)
from hoopgen.text.numbers import format_count, format_interval, format_percent, format_points

from .context import Answer, Context, Workplace, fenced


def ask_map(context: Context, question: MapQuestion, **work: Any) -> xr.Dataset:
    """Map a shot over some of its variables.

    Arguments as for `hoopgen.studyfile.monte_carlo_questions.ask_estimate`.
    """
    return mapped(context.setting.model(question.over), **context.options, **work)


def tell_map(
    context: Context, question: MapQuestion, dataset: xr.Dataset, work: Workplace
) -> Answer:
    """Return the best cell, or the share of each outcome; keep the map.

    Arguments as for `hoopgen.studyfile.monte_carlo_questions.tell_estimate`.
    """
    write(work.file("map.nc"), bytes(dataset.to_netcdf(engine="scipy")))
    for name in question.figures:
        context.draw(work, name, plots.plot_map(dataset, title=context.question.title))
    cells = " × ".join(f"{len(values)} {name}" for name, values in question.over.items())
    if (shares := shares_of_ends(dataset)) is not None:
        texts = [f"{format_percent(share)} {name}" for name, share in shares.items() if share]
        return Answer(f"{cells}: {', '.join(texts) or 'none valid'}", "", {"shares": shares})
    cells += f", {format_count(dataset['shots'].values.max(), 'shot')} each"
    return _best_cell(dataset, cells, context.engine)


def _best_cell(dataset: xr.Dataset, cells: str, engine: Engine) -> Answer:
    best = best_cell(dataset)
    if best is None:
        return Answer("no cell can be simulated", f"{cells}.", {"best": None})
    made, low, high = (best[name] for name in ("probability", "low", "high"))
    where = ", ".join(
        f"{n} {format_variable(n, best[n])}" for n in map(str, dataset["probability"].dims)
    )
    line = f"at best {format_percent(made)} made ({format_interval(low, high)}), at {where}"
    note = "The best of many cells is a little too good, and its interval is that of one cell."
    return Answer(line, f"{cells}. {note}{_of_a_map(dataset)}", in_units({"best": best}, engine))


def _of_a_map(dataset: xr.Dataset) -> str:
    """Return a sentence about the intervals of a map of measured releases."""
    said = dataset.attrs.get("interval")
    return f" Intervals are {said}." if said else ""


def ask_optimum(context: Context, question: OptimumQuestion, **work: Any) -> Optimum:
    """Search the best release.

    Arguments as for `ask_map`.
    """
    return optimum(context.setting.model(question.over), **context.options, **work)


def tell_optimum(
    context: Context, question: OptimumQuestion, best: Optimum, work: Workplace
) -> Answer:
    """Return the best release.

    Arguments as for `tell_map`.
    """
    given = best.arguments
    if context.engine.has_hoop:
        there = format_launch(given)
    else:
        there = ", ".join(f"{name} {best.release[name]:g}" for name in best.bounds)
    of_sample = " of the sample" if isinstance(best.model, Resample) else ""
    off = ", off the board" if best.is_bank else ""
    ends = f"{format_interval(best.low, best.high)}{of_sample}"
    line = f"{format_percent(best.probability)} ({ends}) from {there}{off}"
    return Answer(line, fenced(best), in_units(best.as_dict(), context.engine))


@dataclass(frozen=True)
class _Places:
    """A job of `chunks.run`: a chunk is a place."""

    places: tuple[tuple[float, float], ...]
    model: Scatter | Resample
    parameters: Mapping[str, float]
    arguments: Mapping[str, Any]
    scene: Engine = HOOP

    @property
    def chunks(self) -> int:
        """The number of chunks."""
        return len(self.places)

    def identity(self) -> dict[str, Any]:
        """Return the identity of the chunks: everything that they depend on."""
        return {
            "places": self.places,
            "model": self.model.identity(),
            "parameters": self.parameters,
            **scene_identity(self.scene),
            **self.arguments,
        }

    def compute(self, chunk: int) -> pa.Table:
        """Return the dataset of a place, as the bytes of its netCDF file."""
        places = [self.places[chunk]]
        options = {"scene": self.scene, "threads": 1, **self.arguments}
        found = bank_or_direct(self.model, places, self.parameters, **options)
        return pa.table({"dataset": [bytes(found.to_netcdf(engine="scipy"))]})


def ask_bank(context: Context, question: BankQuestion, **work: Any) -> xr.Dataset:
    """Compare bank and direct shots, a chunk each place.

    Arguments as for `ask_map`.
    """
    check_hoop("bank", context.engine)
    model = context.setting.model((*question.over, "distance", "angle", "x", "y"))
    places = tuple((x, y) for x, y in places_of(question.places).tolist())
    job = _Places(places, model, context.setting.parameters, context.arguments, context.engine)
    with preparing():
        job.compute(0)
    datasets = [_read(table) for table in run(job, **work)]
    return xr.concat(
        datasets, "place", data_vars="all", coords="minimal", compat="override", join="exact"
    )


def tell_bank(
    context: Context, question: BankQuestion, dataset: xr.Dataset, work: Workplace
) -> Answer:
    """Return from which places the bank shot is better; keep all numbers.

    Arguments as for `tell_map`.
    """
    write(work.file("bank.nc"), bytes(dataset.to_netcdf(engine="scipy")))
    for name in question.figures:
        hoop, title = context.setting.parameters, context.question.title
        context.draw(work, name, plots.plot_aim_points(dataset, hoop, title=title))
    better, worse, line = verdict(dataset)
    if "columns" in dataset.attrs:
        line += "; intervals of the sample"
    return Answer(line, _bank_table(dataset), {"better": better.tolist(), "worse": worse.tolist()})


def _read(table: pa.Table) -> xr.Dataset:
    return xr.load_dataset(io.BytesIO(table["dataset"][0].as_py()), engine="scipy")


def _bank_table(dataset: xr.Dataset) -> str:
    rows = []
    for place in range(dataset.sizes["place"]):
        here = dataset.isel(place=place)
        direct, bank = here["probability"].values
        ends = (here[name].item() for name in ("difference_low", "difference_high"))
        rows.append(
            [
                *(format_variable(name, here[name].item()) for name in "xy"),
                format_percent(direct),
                format_percent(bank),
                f"{format_points(here['difference'].item(), 1)} "
                f"({' to '.join(format_points(end, 1) for end in ends)})",
            ]
        )
    return _table(["x", "y", "direct", "bank", "bank less direct, points"], rows)


def _wanted(context: Context) -> dict[str, Any]:
    """Return arguments of `aim`, and of a table of it."""
    if context.setting.releases is not None:
        raise ValueError("releases: this question is about one release; leave out")
    release = context.setting.release
    if "height" not in release:
        raise ValueError("release: missing height")
    names = ("height", "angle", "backspin", "sidespin")
    return context.arguments | {name: release[name] for name in names if name in release}


def ask_aim(context: Context, question: AimQuestion, **work: Any) -> Mapping[str, Any]:
    """Aim from each distance.

    Arguments as for `ask_map`.
    """
    check_hoop("aim", context.engine)
    wanted, parameters = _wanted(context), context.setting.parameters
    return aim_table(
        wanted.pop("distance"), **wanted, parameters=parameters, scene=context.engine, **work
    )


def tell_aim(
    context: Context, question: AimQuestion, columns: Mapping[str, Any], work: Workplace
) -> Answer:
    """Return a table of aim, and keep it.

    Arguments as for `tell_map`.
    """
    write_csv(work.file("table.csv"), columns, context.setting.parameters)
    rows = [
        [
            *(_one_of(columns, name, row) for name in _AIMED),
            *(_ends_of(columns, name, row) for name in TOLERANCES),
        ]
        for row in range(len(columns["speed"]))
    ]
    good = int(np.isfinite(columns["low_speed"]).sum())
    line = f"{format_count(len(rows), 'distance')}, {good} of them with a release that goes in"
    table = _table([*_AIMED, *(f"goes in with {name}" for name in TOLERANCES)], rows)
    numbers = {name: column.tolist() for name, column in columns.items()}
    return Answer(line, table, in_units(numbers, context.engine))


_AIMED = ("distance", "speed", "elevation")


def _one_of(columns: Mapping[str, NDArray[np.float64]], name: str, row: int) -> str:
    value = float(columns[name][row])
    return "none" if math.isnan(value) else format_variable(name, value)


def _ends_of(columns: Mapping[str, NDArray[np.float64]], name: str, row: int) -> str:
    low, high = (float(columns[f"{end}_{name}"][row]) for end in ("low", "high"))
    return "none" if math.isnan(low) else format_range(name, low, high)


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = [head, ["---:"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)
