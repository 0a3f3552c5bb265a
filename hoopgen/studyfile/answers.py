"""The answer to each kind of question: in one line, in a few, in numbers, tables and figures."""

from __future__ import annotations

import io
import itertools
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
import pyarrow as pa
import xarray as xr
from numpy.typing import NDArray

from hoopgen import plots
from hoopgen.inputs import check_contacts
from hoopgen.outputs import write
from hoopgen.parameters import NAMES
from hoopgen.phrases import counted, decimals, interval, percent, points
from hoopgen.results import Outcome, Shots
from hoopgen.simulation import check_log, simulate
from hoopgen.sizes import check_room
from hoopgen.study.aim import aim, aim_table, write_csv
from hoopgen.study.bank import bank_or_direct, check_kept
from hoopgen.study.batch import batch
from hoopgen.study.chunks import run
from hoopgen.study.compare import compare
from hoopgen.study.draws import check_two_seeds
from hoopgen.study.estimate import estimate
from hoopgen.study.maps import check_cells
from hoopgen.study.maps import map as mapped
from hoopgen.study.measures import measure
from hoopgen.study.models import Resample, Scatter
from hoopgen.study.named import in_units
from hoopgen.study.optimum import optimum, scattering
from hoopgen.study.origin import settle
from hoopgen.study.search import bounds_of
from hoopgen.study.tables import Source
from hoopgen.study.throws import most_shots
from hoopgen.study.told import in_a_note, say_scene, told_setting
from hoopgen.study.variables import Releases
from hoopgen.study.words import between, say

from .schema import Aim, Bank, Batch, Compare, Estimate, Given, Map, Optimum, Question, Study
from .settings import Setting

__all__ = ["Answer", "Asked", "Work", "answer", "check"]

_FAN = 2_000
"""Shots whose shares are beside the fan; it shows the first of them."""

_LANDINGS = 200_000
"""Shots whose misses are shown."""


@dataclass(frozen=True)
class Work:
    """Who works on a question, and where.

    Attributes
    ----------
    folder
        For files of the answer, and for finished chunks.
    threads, scheduler
        As for `hoopgen.study.chunks.run`.
    progress
        Called with what is done and its total, as far as that is known.
    """

    folder: Path
    threads: int | None
    scheduler: str | None
    progress: Callable[[int, int | None], None]

    @property
    def options(self) -> dict[str, Any]:
        """Return what functions that work in chunks are told."""
        return {
            "folder": self.folder / "chunks",
            "threads": self.threads,
            "scheduler": self.scheduler,
            "progress": self.progress,
        }


@dataclass(frozen=True)
class Answer:
    """What came out.

    Attributes
    ----------
    line
        In one line.
    text
        In more, Markdown.
    numbers
        In types that JSON knows; SI.
    """

    line: str
    text: str
    numbers: Mapping[str, Any]


@dataclass(frozen=True)
class Asked:
    """A question with what the study says beside it.

    Attributes
    ----------
    study
        What all questions have in common.
    given
        The tables above the questions.
    question
        The question itself.
    folder
        Of the study file.
    """

    study: Study
    given: Given
    question: Question
    folder: Path

    @cached_property
    def setting(self) -> Setting:
        """Where its shots come from."""
        return Setting.of((self.given, self.question), self.folder)

    @property
    def scene(self) -> str:
        """In words: the preset, and what differs from it."""
        table = self.question if isinstance(self.question, Batch) else None
        if table is not None:
            source = Source(self.folder / table.file, table.format or "")
            return say_scene(self.setting.parameters_of(source))
        own = {n: v for n, v in self.setting.release.items() if n in NAMES}
        return say_scene(self.setting.parameters | own)

    def changed(self, versus: Given) -> Setting:
        """Return the setting with changes."""
        return Setting.of((self.given, self.question, versus), self.folder)

    def identity(self) -> dict[str, Any]:
        """Return all that the answer depends on, in types that JSON knows."""
        question = self.question
        apart = {*Given.model_fields, "versus"}
        identity: dict[str, Any] = {
            **{name: getattr(self.study, name) for name in ("seed", "confidence", "formats")},
            **{name: value for name, value in question if name not in apart},
        }
        if isinstance(question, Batch):
            source = Source(self.folder / question.file, question.format or "")
            scene = self.setting.parameters_of(source)
            shared = {"release": question.release, "parameters": scene}
            return identity | {"setting": shared, "table": source.digest()[0]}
        identity["setting"] = self.setting.identity()
        if isinstance(question, Compare):
            identity["versus"] = self.changed(question.versus).identity()
        return identity

    def draw(self, work: Work, name: str, figure: Any) -> None:
        """Write a figure in the formats wanted."""
        for format in self.study.formats:
            plots.save(figure, work.folder / f"{name}.{format}")


# ---------------------------------------------------------------------------------------- estimate


def _check_estimate(asked: Asked, question: Estimate | Compare) -> None:
    settings = [asked.setting]
    settings += [asked.changed(question.versus)] if isinstance(question, Compare) else []
    for setting in settings:
        setting.model().draw(0, 1, 0, setting.parameters)
    paired = isinstance(question, Compare)
    most = most_shots(question.shots, question.precision, asked.study.confidence, paired=paired)
    contacts = check_contacts(question.max_contacts)
    if isinstance(question, Estimate) and "fan" in question.figures:
        check_log(min(_FAN, most), contacts)


def _estimate(asked: Asked, question: Estimate, work: Work) -> Answer:
    setting = asked.setting
    model = setting.model()
    found = estimate(
        model,
        setting.parameters,
        shots=question.shots,
        precision=question.precision,
        confidence=asked.study.confidence,
        seed=asked.study.seed,
        max_contacts=question.max_contacts,
        **work.options,
    )
    shooting = _Shooting(asked, question, found.shots)
    for name in question.figures:
        asked.draw(work, name, shooting.fan() if name == "fan" else shooting.landings())
    digits = decimals(found.half_width)
    ends = interval(found.low, found.high, digits)
    line = f"{percent(found.probability, digits)} made ({ends})"
    return Answer(
        line + _short_of(question, found.half_width), _fenced(found), in_units(found.as_dict())
    )


def _short_of(question: Estimate | Compare, half_width: float) -> str:
    """Say that a precision was not reached."""
    if question.precision is None or half_width <= question.precision:
        return ""
    return "; the precision was not reached: more shots"


@dataclass(frozen=True)
class _Shooting:
    """The first shots of an estimate, for figures."""

    asked: Asked
    question: Estimate
    shots: int

    def fan(self) -> Any:
        """Return the picture of paths."""
        released, shots = self._simulated(_FAN, record=True)
        note = in_a_note(self._told)
        return plots.plot_fan(shots, released.parameters, title=self.question.title, note=note)

    def landings(self) -> Any:
        """Return the picture of where misses reach the floor."""
        released, shots = self._simulated(_LANDINGS)
        states, scene = released.states, released.parameters
        floor = measure(states, shots, scene, ("floor_x", "floor_y"))
        x, y = (floor[name][shots.outcome == Outcome.MISSED] for name in ("floor_x", "floor_y"))
        place = states[:, :2].mean(axis=0).tolist()
        title = f"{self.question.title}: where misses land" if self.question.title else ""
        note = in_a_note(self._told)
        return plots.plot_landings(x, y, scene, place=tuple(place), title=title, note=note)

    @property
    def _told(self) -> dict[str, str]:
        return told_setting(self.asked.setting.identity()) | {"seed": str(self.asked.study.seed)}

    def _simulated(self, most: int, *, record: bool = False) -> tuple[Releases, Shots]:
        setting, seed = self.asked.setting, self.asked.study.seed
        released = setting.model().draw(0, min(most, self.shots), seed, setting.parameters)
        most_contacts = self.question.max_contacts
        return released, simulate(
            released.states, released.parameters, max_contacts=most_contacts, record=record
        )


# ----------------------------------------------------------------------------------------- compare


def _compare(asked: Asked, question: Compare, work: Work) -> Answer:
    first, second = asked.setting, asked.changed(question.versus)
    found = compare(
        (first.model(), first.parameters),
        (second.model(), second.parameters),
        shots=question.shots,
        precision=question.precision,
        confidence=asked.study.confidence,
        seed=asked.study.seed,
        max_contacts=question.max_contacts,
        **work.options,
    )
    digits = decimals(found.half_width)
    line = (
        f"{points(found.difference, digits)} points by the change "
        f"({points(found.low, digits)} to {points(found.high, digits)})"
    )
    return Answer(
        line + _short_of(question, found.half_width), _fenced(found), in_units(found.as_dict())
    )


# --------------------------------------------------------------------------------------------- map


def _try(asked: Asked, model: Scatter | Resample, values: Mapping[str, float]) -> None:
    """Look whether a release can be made of a model and what is varied."""
    model.around(values, model.noise(0, 1, asked.study.seed), asked.setting.parameters)


def _check_map(asked: Asked, question: Map) -> None:
    model = asked.setting.model(question.over)
    _try(asked, model, {name: axis[0] for name, axis in question.over.items()})
    check_cells(question.over, scatters=model.scatters)
    check_contacts(question.max_contacts)
    if question.shots is not None and not model.scatters:
        raise ValueError("shots: without scatter a cell is one shot; leave out")


def _map(asked: Asked, question: Map, work: Work) -> Answer:
    dataset = mapped(
        asked.setting.model(question.over),
        question.over,
        asked.setting.parameters,
        shots=question.shots,
        confidence=asked.study.confidence,
        seed=asked.study.seed,
        max_contacts=question.max_contacts,
        **work.options,
    )
    write(work.folder / "map.nc", bytes(dataset.to_netcdf(engine="scipy")))
    for name in question.figures:
        asked.draw(work, name, plots.plot_map(dataset, title=question.title))
    cells = " × ".join(f"{len(values)} {name}" for name, values in question.over.items())
    if "outcome" in dataset:
        shares = _outcomes(dataset)
        said = [f"{percent(share)} {name}" for name, share in shares.items() if share]
        return Answer(f"{cells}: {', '.join(said)}", "", {"shares": shares})
    return _best_cell(dataset, f"{cells}, {counted(dataset['shots'].values.max(), 'shot')} each")


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
    note = "The best of many cells is a little too good."
    numbers = {"best": {**at, "probability": made, "low": low, "high": high}}
    return Answer(line, f"{cells}. {note}", in_units(numbers))


# ----------------------------------------------------------------------------------------- optimum


def _check_optimum(asked: Asked, question: Optimum) -> None:
    check_two_seeds(asked.study.seed)
    setting, model = asked.setting, asked.setting.model(question.over)
    player = scattering(model, question.over, setting.parameters, question.by)
    ends = bounds_of(_ends(question.over), model.centre, player)
    _try(asked, model, {name: low for name, (low, _) in ends.items()})


def _ends(
    over: Mapping[str, Sequence[float] | None],
) -> dict[str, tuple[float, float] | None]:
    return {name: None if ends is None else (ends[0], ends[1]) for name, ends in over.items()}


def _optimum(asked: Asked, question: Optimum, work: Work) -> Answer:
    best = optimum(
        asked.setting.model(question.over),
        _ends(question.over),
        asked.setting.parameters,
        by=question.by,
        shots=question.shots,
        seed=asked.study.seed,
        confidence=asked.study.confidence,
        tolerance=question.tolerance,
        margins=question.margins,
        **work.options,
    )
    given = best.arguments
    line = (
        f"{percent(best.probability)} ({interval(best.low, best.high)}) from "
        f"{say('speed', given['speed'])} at {say('elevation', given['elevation'])}"
    )
    return Answer(line, _fenced(best), in_units(best.as_dict()))


# -------------------------------------------------------------------------------------------- bank


_PLACE = 400
"""Bytes that a place takes as one of a list."""


def _places(question: Bank) -> NDArray[np.float64]:
    """Return every combination, x and y, (n, 2)."""
    names = tuple(question.places)
    if set(names) not in ({"x", "y"}, {"distance", "angle"}):
        raise ValueError(f"places: expected distance and angle, or x and y; got {', '.join(names)}")
    axes = [question.places[name] for name in ("x", "y") if name in names]
    axes += [question.places[name] for name in ("distance", "angle") if name in names]
    check_room("places", math.prod(map(len, axes)), "places", _PLACE)
    first, second = np.array(list(itertools.product(*axes))).T
    if "x" not in names:
        first, second = first * np.cos(second), first * np.sin(second)
    return np.stack([first, second], axis=-1)


def _bank_model(asked: Asked, question: Bank) -> Scatter | Resample:
    return asked.setting.model((*question.over, "distance", "angle", "x", "y"))


def _check_bank(asked: Asked, question: Bank) -> None:
    check_two_seeds(asked.study.seed)
    model, parameters = _bank_model(asked, question), asked.setting.parameters
    check_kept(question.shots)
    x, y = _places(question)[0].tolist()
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


def _bank(asked: Asked, question: Bank, work: Work) -> Answer:
    places = [(x, y) for x, y in _places(question).tolist()]
    job = _Places(tuple(places), _bank_model(asked, question), asked.setting, question, asked.study)
    datasets = [_read(table) for table in run(job, **work.options)]
    dataset = xr.concat(
        datasets, "place", data_vars="all", coords="minimal", compat="override", join="exact"
    )
    write(work.folder / "bank.nc", bytes(dataset.to_netcdf(engine="scipy")))
    for name in question.figures:
        picture = plots.plot_aim_points(dataset, asked.setting.parameters, title=question.title)
        asked.draw(work, name, picture)
    better, worse = (dataset["difference_low"] > 0).values, (dataset["difference_high"] < 0).values
    undecided = len(places) - better.sum() - worse.sum()
    line = (
        f"{counted(len(places), 'place')}: the bank shot is better from {better.sum()}, the direct "
        f"one from {worse.sum()}, {undecided} undecided"
    )
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


# --------------------------------------------------------------------------------------------- aim


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


def _check_aim(asked: Asked, question: Aim) -> None:
    aim(
        **_wanted(asked, question),
        distance=np.array(question.distance),
        parameters=asked.setting.parameters,
    )


def _aim(asked: Asked, question: Aim, work: Work) -> Answer:
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
    write_csv(work.folder / "table.csv", columns, asked.setting.parameters)
    rows = [
        [
            *(_one_of(columns, name, row) for name in _AIMED),
            *(_ends_of(columns, name, row) for name in _OFF),
        ]
        for row in range(len(columns["speed"]))
    ]
    good = int(np.isfinite(columns["low_speed"]).sum())
    line = f"{counted(len(rows), 'distance')}, {good} of them with a release that goes in"
    table = _table([*_AIMED, *(f"goes in with {name}" for name in _OFF)], rows)
    numbers = {name: column.tolist() for name, column in columns.items()}
    return Answer(line, table, in_units(numbers))


_AIMED = ("distance", "speed", "elevation")
_OFF = ("speed", "elevation", "azimuth")


def _one_of(columns: Mapping[str, NDArray[np.float64]], name: str, row: int) -> str:
    value = float(columns[name][row])
    return "none" if math.isnan(value) else say(name, value)


def _ends_of(columns: Mapping[str, NDArray[np.float64]], name: str, row: int) -> str:
    low, high = (float(columns[f"{end}_{name}"][row]) for end in ("low", "high"))
    return "none" if math.isnan(low) else between(name, low, high)


# ------------------------------------------------------------------------------------------- batch


def _check_batch(asked: Asked, question: Batch) -> None:
    source = Source(asked.folder / question.file, question.format or "")
    origin = settle(source, None, question.release, None, question.own, override=True)
    source.columns(origin.own, origin.release)
    check_contacts(question.max_contacts)


def _most_contacts(question: Batch) -> int | None:
    """Return how many the study says; None where it leaves that to the table."""
    return question.max_contacts if "max_contacts" in question.model_fields_set else None


def _batch(asked: Asked, question: Batch, work: Work) -> Answer:
    source = Source(asked.folder / question.file, question.format or "")
    counts = batch(
        source.path,
        work.folder / "results.parquet",
        parameters=asked.setting.parameters_of(source),
        release=question.release,
        measures=question.measures,
        max_contacts=_most_contacts(question),
        override=True,  # what the study file says is said on purpose
        format=question.format,
        own=question.own,
        prefix=question.prefix,
        scheduler=work.scheduler,
        threads=work.threads,
        progress=work.progress,
    )
    said = ", ".join(f"{count:,} {name}" for name, count in counts.items() if count)
    return Answer(f"{counted(sum(counts.values()), 'shot')}: {said or 'none'}", "", counts)


# --------------------------------------------------------------------------------------- in common


@dataclass(frozen=True)
class _Kind:
    """How questions of a kind are checked, before any work, and answered."""

    check: Callable[[Asked, Any], None]
    answer: Callable[[Asked, Any, Work], Answer]


_KINDS: Mapping[type[Question], _Kind] = MappingProxyType(
    {
        Estimate: _Kind(_check_estimate, _estimate),
        Compare: _Kind(_check_estimate, _compare),
        Map: _Kind(_check_map, _map),
        Optimum: _Kind(_check_optimum, _optimum),
        Bank: _Kind(_check_bank, _bank),
        Aim: _Kind(_check_aim, _aim),
        Batch: _Kind(_check_batch, _batch),
    }
)


def check(asked: Asked) -> None:
    """Look for what can be seen to be wrong before any work.

    Raises
    ------
    TypeError, ValueError, OSError
        If something is.
    """
    _KINDS[type(asked.question)].check(asked, asked.question)


def answer(asked: Asked, work: Work) -> Answer:
    """Answer a question, its tables and figures written into the folder of the work."""
    return _KINDS[type(asked.question)].answer(asked, asked.question, work)


def _fenced(found: object) -> str:
    return f"```text\n{found}\n```"


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = [head, ["---:"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)
