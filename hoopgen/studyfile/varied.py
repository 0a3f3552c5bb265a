"""Answers about releases that are varied: maps, the best one, bank or direct, tables of aim."""

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
from hoopgen.outputs import write
from hoopgen.phrases import counted, interval, percent, points
from hoopgen.scenes import check_article, check_hoop
from hoopgen.study.aim import aim
from hoopgen.study.aim_table import OFF, aim_table, write_csv
from hoopgen.study.bank import bank_or_direct, check_kept, places_of, verdict
from hoopgen.study.chunks import run
from hoopgen.study.draws import check_two_seeds
from hoopgen.study.held_out import check_folds
from hoopgen.study.maps import check_cells
from hoopgen.study.maps import map as mapped
from hoopgen.study.named import in_units
from hoopgen.study.optimum import optimum, scattering
from hoopgen.study.resample import Resample
from hoopgen.study.scatter import Scatter
from hoopgen.study.search import bounds_of
from hoopgen.study.tallies import contacts_of
from hoopgen.study.throws import check_states
from hoopgen.words import between, say

from .asked import Answer, Asked, Work, fenced
from .schema import Aim, Bank, Map, Optimum, Study
from .settings import Setting

__all__ = [
    "answer_aim",
    "answer_bank",
    "answer_map",
    "answer_optimum",
    "check_aim",
    "check_bank",
    "check_map",
    "check_optimum",
]


def _try(asked: Asked, model: Scatter | Resample, values: Mapping[str, float]) -> None:
    """Look whether a release can be made of a model and what is varied."""
    model.around(values, model.noise(0, 1, asked.study.seed), asked.setting.parameters)


def check_map(asked: Asked, question: Map) -> None:
    """Look for what is wrong with a map."""
    model = asked.setting.model(question.over)
    check_states(model, asked.engine, question.over)
    _try(asked, model, {name: axis[0] for name, axis in question.over.items()})
    check_cells(question.over, scatters=model.scatters)
    contacts_of(question.max_contacts, asked.engine)
    if question.shots is not None and not model.scatters:
        raise ValueError("shots: without scatter a cell is one shot; leave out")


def answer_map(asked: Asked, question: Map, work: Work) -> Answer:
    """Return the best cell, or the share of each outcome; keep the map."""
    dataset = mapped(
        asked.setting.model(question.over),
        question.over,
        asked.setting.parameters,
        scene=asked.engine,
        shots=question.shots,
        confidence=asked.study.confidence,
        seed=asked.study.seed,
        max_contacts=question.max_contacts,
        **work.options,
    )
    write(work.file("map.nc"), bytes(dataset.to_netcdf(engine="scipy")))
    for name in question.figures:
        asked.draw(work, name, plots.plot_map(dataset, title=question.title))
    cells = " × ".join(f"{len(values)} {name}" for name, values in question.over.items())
    if "outcome" in dataset:
        shares = _outcomes(dataset)
        said = [f"{percent(share)} {name}" for name, share in shares.items() if share]
        return Answer(f"{cells}: {', '.join(said)}", "", {"shares": shares})
    if "count" in dataset:
        return _endings(dataset, cells)
    return _best_cell(dataset, f"{cells}, {counted(dataset['shots'].values.max(), 'shot')} each")


def _endings(dataset: xr.Dataset, cells: str) -> Answer:
    """Return the shares of all cells together, of a scene of one's own."""
    counts = dataset["count"].sum([name for name in dataset["count"].dims if name != "ending"])
    ended = dict(zip(dataset["ending"].values.tolist(), counts.values.tolist(), strict=True))
    valid = sum(count for name, count in ended.items() if name != "invalid")
    shares = {name: n / valid for name, n in ended.items() if valid and name != "invalid"}
    said = [f"{percent(share)} {name}" for name, share in shares.items() if share]
    return Answer(f"{cells}: {', '.join(said) or 'none valid'}", "", {"shares": shares})


def _outcomes(dataset: xr.Dataset) -> dict[str, float]:
    names = dataset["outcome"].attrs["flag_meanings"].split()
    codes = dataset["outcome"].values
    return {name: float(np.mean(codes == code)) for code, name in enumerate(names)}


def _best_cell(dataset: xr.Dataset, cells: str) -> Answer:
    probability = dataset["probability"]
    if probability.isnull().all():
        return Answer("no cell can be simulated", f"{cells}.", {"best": None})
    best = dataset.isel(probability.argmax(...))
    at = {str(name): best[name].item() for name in probability.dims}
    made, low, high = (best[name].item() for name in ("probability", "low", "high"))
    where = ", ".join(f"{name} {say(name, value)}" for name, value in at.items())
    line = f"at best {percent(made)} made ({interval(low, high)}), at {where}"
    note = "The best of many cells is a little too good, and its interval is that of one cell."
    note += _of_a_map(dataset)
    numbers = {"best": {**at, "probability": made, "low": low, "high": high}}
    return Answer(line, f"{cells}. {note}", in_units(numbers))


def _of_a_map(dataset: xr.Dataset) -> str:
    """Say what the intervals are of a map of measured releases."""
    said = dataset.attrs.get("interval")
    return f" Intervals are {said}." if said else ""


def check_optimum(asked: Asked, question: Optimum) -> None:
    """Look for what is wrong with a search for the best release."""
    if "margins" in question.model_fields_set:
        check_hoop("margins", asked.engine)
    check_two_seeds(asked.study.seed)
    setting, model = asked.setting, asked.setting.model(question.over)
    player = scattering(model, question.over, setting.parameters, question.by, asked.engine)
    ends = bounds_of(_ends(question.over), model.centre, player)
    if isinstance(model, Resample):
        check_folds(model)
    _try(asked, model, {name: low for name, (low, _) in ends.items()})


def _ends(
    over: Mapping[str, Sequence[float] | None],
) -> dict[str, tuple[float, float] | None]:
    return {name: None if ends is None else (ends[0], ends[1]) for name, ends in over.items()}


def answer_optimum(asked: Asked, question: Optimum, work: Work) -> Answer:
    """Return the best release."""
    best = optimum(
        asked.setting.model(question.over),
        _ends(question.over),
        asked.setting.parameters,
        scene=asked.engine,
        by=question.by,
        shots=question.shots,
        seed=asked.study.seed,
        confidence=asked.study.confidence,
        tolerance=question.tolerance,
        margins=question.margins if asked.engine.has_hoop else None,
        **work.options,
    )
    given = best.arguments
    if asked.engine.has_hoop:
        there = f"{say('speed', given['speed'])} at {say('elevation', given['elevation'])}"
    else:
        there = ", ".join(f"{name} {best.release[name]:g}" for name in best.bounds)
    of_sample = " of the sample" if isinstance(best.model, Resample) else ""
    off = ", off the board" if best.is_bank else ""
    ends = f"{interval(best.low, best.high)}{of_sample}"
    line = f"{percent(best.probability)} ({ends}) from {there}{off}"
    return Answer(line, fenced(best), in_units(best.as_dict()))


def _bank_model(asked: Asked, question: Bank) -> Scatter | Resample:
    return asked.setting.model((*question.over, "distance", "angle", "x", "y"))


def check_bank(asked: Asked, question: Bank) -> None:
    """Look for what is wrong with a comparison of bank and direct shots."""
    check_article("bank", asked.engine)
    check_two_seeds(asked.study.seed)
    model, parameters = _bank_model(asked, question), asked.setting.parameters
    check_kept(question.shots)
    if isinstance(model, Resample):
        check_folds(model)
    x, y = places_of(question.places)[0].tolist()
    here = {"distance": math.hypot(x, y), "angle": math.atan2(y, x)}
    player = scattering(model, question.over, parameters, "any")
    ends = bounds_of(_ends(question.over), model.centre | here, player)
    _try(asked, model, here | {name: low for name, (low, _) in ends.items()})


@dataclass(frozen=True)
class _Places:
    """A job of `chunks.run`: a chunk is a place."""

    places: tuple[tuple[float, float], ...]
    model: Scatter | Resample
    setting: Setting
    question: Bank
    study: Study

    @property
    def chunks(self) -> int:
        """How many."""
        return len(self.places)

    def identity(self) -> dict[str, Any]:
        """Return what the chunks depend on."""
        return {
            "places": self.places,
            "model": self.model.identity(),
            "parameters": self.setting.parameters,
            "over": self.question.over,
            "shots": self.question.shots,
            "seed": self.study.seed,
            "confidence": self.study.confidence,
        }

    def compute(self, chunk: int) -> pa.Table:
        """Return the dataset of a place, as the bytes of its netCDF file."""
        dataset = bank_or_direct(
            self.model,
            [self.places[chunk]],
            self.setting.parameters,
            over=_ends(self.question.over),
            shots=self.question.shots,
            seed=self.study.seed,
            confidence=self.study.confidence,
            threads=1,
        )
        return pa.table({"dataset": [bytes(dataset.to_netcdf(engine="scipy"))]})


def answer_bank(asked: Asked, question: Bank, work: Work) -> Answer:
    """Return from which places the bank shot is better; keep all numbers."""
    places = [(x, y) for x, y in places_of(question.places).tolist()]
    job = _Places(tuple(places), _bank_model(asked, question), asked.setting, question, asked.study)
    datasets = [_read(table) for table in run(job, **work.options)]
    dataset = xr.concat(
        datasets, "place", data_vars="all", coords="minimal", compat="override", join="exact"
    )
    write(work.file("bank.nc"), bytes(dataset.to_netcdf(engine="scipy")))
    for name in question.figures:
        picture = plots.plot_aim_points(dataset, asked.setting.parameters, title=question.title)
        asked.draw(work, name, picture)
    better, worse, line = verdict(dataset)
    if isinstance(job.model, Resample):
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
                *(say(name, here[name].item()) for name in "xy"),
                percent(direct),
                percent(bank),
                f"{points(here['difference'].item(), 1)} "
                f"({' to '.join(points(end, 1) for end in ends)})",
            ]
        )
    return _table(["x", "y", "direct", "bank", "bank less direct, points"], rows)


def _wanted(asked: Asked, question: Aim) -> dict[str, Any]:
    """Return arguments of `aim`."""
    if asked.setting.releases is not None:
        raise ValueError("releases: this question is about one release; leave out")
    release = asked.setting.release
    names = ("entry", "elevation", "speed", "arc", "depth")
    wanted = {name: getattr(question, name) for name in names}
    if "height" not in release:
        raise ValueError("release: missing height")
    return wanted | {name: release[name] for name in ("height", "angle") if name in release}


def check_aim(asked: Asked, question: Aim) -> None:
    """Look for what is wrong with a table of aim."""
    check_article("aim", asked.engine)
    aim(
        **_wanted(asked, question),
        distance=np.array(question.distance),
        parameters=asked.setting.parameters,
    )


def answer_aim(asked: Asked, question: Aim, work: Work) -> Answer:
    """Return a table of aim, and keep it."""
    release = asked.setting.release
    wanted = _wanted(asked, question)
    wanted |= {name: release[name] for name in ("backspin", "sidespin") if name in release}
    columns = aim_table(
        question.distance,
        **wanted,
        by=question.by,
        parameters=asked.setting.parameters,
        **work.options,
    )
    write_csv(work.file("table.csv"), columns, asked.setting.parameters)
    rows = [
        [
            *(_one_of(columns, name, row) for name in _AIMED),
            *(_ends_of(columns, name, row) for name in OFF),
        ]
        for row in range(len(columns["speed"]))
    ]
    good = int(np.isfinite(columns["low_speed"]).sum())
    line = f"{counted(len(rows), 'distance')}, {good} of them with a release that goes in"
    table = _table([*_AIMED, *(f"goes in with {name}" for name in OFF)], rows)
    numbers = {name: column.tolist() for name, column in columns.items()}
    return Answer(line, table, in_units(numbers))


_AIMED = ("distance", "speed", "elevation")


def _one_of(columns: Mapping[str, NDArray[np.float64]], name: str, row: int) -> str:
    value = float(columns[name][row])
    return "none" if math.isnan(value) else say(name, value)


def _ends_of(columns: Mapping[str, NDArray[np.float64]], name: str, row: int) -> str:
    low, high = (float(columns[f"{end}_{name}"][row]) for end in ("low", "high"))
    return "none" if math.isnan(low) else between(name, low, high)


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = [head, ["---:"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)
