"""`map`: what becomes of a shot, or how probably it is made, over any of its variables."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sized
from dataclasses import dataclass
from enum import IntEnum
from math import prod
from os import PathLike
from typing import Any, TypeAlias

import numpy as np
import pyarrow as pa
import xarray as xr
from numpy.typing import ArrayLike, NDArray

from hoopgen.brief import brief
from hoopgen.hoop.kinds import Kind, kinds
from hoopgen.hoop.presets import PAPER
from hoopgen.hoop.variables import STANDS_FOR, VARIABLES, change_variables, check_angles
from hoopgen.inputs import MAX_CONTACTS, Backend, check_contacts, check_count, doubles
from hoopgen.installed import version
from hoopgen.phrases import percent
from hoopgen.results import Outcome, Shots
from hoopgen.sizes import check_room
from hoopgen.told import model_told, say_scene
from hoopgen.variables import check_names

from .chunks import run
from .draws import check_seed
from .intervals import wilson
from .of_hoop import of_hoop
from .resample import Resample
from .scatter import Scatter
from .scattering import alike, check_thrown, scene_by_row
from .tallies import (
    BLOCK,
    COLUMNS,
    Tally,
    check_scene,
    check_share,
)
from .throws import flown

__all__ = ["check_cells", "map"]

SHOTS = 10_000
"""Of a cell, unless asked for otherwise."""

_CHUNK = 1 << 17
"""Shots in a chunk, at most."""

_CELL, _TALLIED = 48, 720
"""Bytes that a cell takes at the most, single or with scatter, until it is in a file."""

Floats: TypeAlias = NDArray[np.float64]


@of_hoop
def map(
    model: Scatter | Resample,
    over: Mapping[str, ArrayLike],
    parameters: Mapping[str, Any] = PAPER,
    *,
    shots: int | None = None,
    confidence: float = 0.95,
    seed: int = 0,
    max_contacts: int = MAX_CONTACTS,
    backend: Backend = "auto",
    threads: int | None = None,
    folder: str | PathLike[str] | None = None,
    scheduler: str | None = None,
    progress: Callable[[int, int | None], None] | None = None,
) -> xr.Dataset:
    """Map a shot over some of its variables.

    Parameters
    ----------
    model
        The player. Of a `Scatter` the release says the variables that are not mapped over; without
        deviations a cell is one shot. Of a `Resample` the columns are as they are, and one
        that is mapped over, or stands for what is, has its mean moved and keeps how far the
        measured releases are from it.
    over
        Variables, see `VARIABLES`, and the values that each takes; m, m/s, rad, rad/s.
    parameters
        Of the scene, for those that neither `over` nor the model names.
    shots
        Of each cell; by default 10,000. All cells have the same random numbers.
    confidence
        Of the intervals, within 0 and 1.
    seed
        From 0 to 2^64 - 1.
    max_contacts, backend
        As for `hoopgen.simulate`.
    threads, folder, scheduler, progress
        As for `hoopgen.estimate`.

    Returns
    -------
    xarray.Dataset
        Its dimensions are the names of `over`, in their order; coordinates, those of `release`
        too, have ``units`` and ``long_name``. With scatter there are `probability`, `low` and
        `high` (as of `Estimate`), numbers of shots `shots`, `made`, `capped`, `short`, `invalid`
        and `uncertain`, of those `uncertain_capped`, and `share` by `kind`. Without, `outcome` and
        `kind` (codes, named in ``flag_meanings``) and `uncertain`. A cell that cannot be simulated
        is INVALID, and its probability NaN.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    scatters = check_thrown(model, over).scatters
    if shots is not None and not scatters:
        raise ValueError("shots: without scatter all shots of a cell are one; leave out")
    work = _Work(
        axes=_axes(over),
        model=model,
        parameters=check_scene(parameters),
        shots=check_count("shots", SHOTS if shots is None else shots) if scatters else 1,
        seed=check_seed(seed),
        max_contacts=check_contacts(max_contacts),
        backend=backend,
    )
    level = check_share("confidence", confidence)
    check_cells(work.axes, scatters=scatters)
    work.simulate(0, 1, 1, model.noise(0, 1, seed))  # what is wrong shows before a folder is made
    tables = run(work, folder, scheduler=scheduler, threads=threads, progress=progress)
    data = _shares(work, tables, level) if scatters else _outcomes(work, tables)
    return xr.Dataset(data, _coordinates(work), _attributes(work, level))


def check_cells(over: Mapping[str, Sized], *, scatters: bool) -> None:
    """Refuse a map of more cells than there is memory for.

    Raises
    ------
    ValueError
        If there are too many; with what they would take.
    """
    cells = prod(len(values) for values in over.values())
    check_room("over", cells, "cells", _TALLIED if scatters else _CELL)


def _axes(over: Mapping[str, ArrayLike]) -> dict[str, Floats]:
    check_names("over", over, VARIABLES)
    if not over:
        raise ValueError("over: expected a variable and its values at the least")
    axes = {name: doubles(f"over[{name!r}]", values) for name, values in over.items()}
    for name, values in axes.items():
        if values.ndim != 1 or not values.size:
            raise ValueError(f"over[{name!r}]: expected a list of numbers, got {brief(over[name])}")
    check_angles("over", axes)
    return axes


# ------------------------------------------------------------------------------------ the work


@dataclass(frozen=True)
class _Work:
    """A job of `chunks.run`: some shots of some cells, every cell with the same noise.

    Cells are numbered with the last axis fastest. A chunk goes over many cells, so that noise is
    drawn for all of them at once.
    """

    axes: Mapping[str, Floats]
    model: Scatter | Resample
    parameters: Mapping[str, float]
    shots: int
    seed: int
    max_contacts: int
    backend: Backend

    @property
    def shape(self) -> tuple[int, ...]:
        return tuple(len(values) for values in self.axes.values())

    @property
    def together(self) -> tuple[int, int]:
        """How many cells are in a chunk, and how many shots of each."""
        shots = min(self.shots, BLOCK)
        return _CHUNK // shots, shots

    @property
    def _blocks(self) -> tuple[int, int]:
        cells, shots = self.together
        return -(-prod(self.shape) // cells), -(-self.shots // shots)

    @property
    def chunks(self) -> int:
        """How many."""
        return prod(self._blocks)

    def cells(self, chunk: int) -> tuple[int, int]:
        """Return the first cell of a chunk, and the one after its last."""
        cells, _ = self.together
        start = chunk // self._blocks[1] * cells
        return start, min(start + cells, prod(self.shape))

    def identity(self) -> dict[str, Any]:
        """Return what the chunks depend on."""
        return {
            "over": {name: values.tolist() for name, values in self.axes.items()},
            "model": self.model.identity(),
            "parameters": dict(self.parameters),
            "shots": self.shots,
            "seed": self.seed,
            "max_contacts": self.max_contacts,
        }

    def compute(self, chunk: int) -> pa.Table:
        """Return a row of numbers for each cell of a chunk."""
        _, many = self.together
        start = chunk % self._blocks[1] * many
        stop = min(start + many, self.shots)
        noise = self.model.noise(start, stop, self.seed)
        few = max(1, BLOCK // (stop - start))
        low, high = self.cells(chunk)
        parts = []
        for cell in range(low, high, few):
            last = min(cell + few, high)
            shots = self.simulate(cell, last, stop - start, noise)
            tallied = self.model.scatters
            parts.append(Tally.of(shots, last - cell).row() if tallied else _row(shots))
        numbers = np.concatenate(parts)
        flat = pa.array(numbers.ravel())
        return pa.table({"numbers": pa.FixedSizeListArray.from_arrays(flat, numbers.shape[1])})

    def simulate(self, start: int, stop: int, shots: int, noise: Mapping[str, Floats]) -> Shots:
        """Return so many shots of each of the cells `start` to `stop` - 1, cell by cell."""
        places = np.unravel_index(np.arange(start, stop), self.shape)
        values = {
            name: axis[place][:, None]
            for (name, axis), place in zip(self.axes.items(), places, strict=True)
        }
        releases = self.model.around(values, noise, self.parameters, shots)
        return flown(releases, self.max_contacts, self.backend)


def _row(shots: Shots) -> NDArray[np.int64]:
    """Return outcome, kind and doubt of each shot, (n, 3)."""
    kind = kinds(shots.outcome, shots.counts, shots.first)
    return np.stack([shots.outcome, kind, shots.uncertain], axis=-1).astype(np.int64)


def _gathered(work: _Work, tables: Iterable[pa.Table], columns: int) -> NDArray[np.int64]:
    """Return the sums of the cells' numbers, (cells, columns)."""
    total = np.zeros((prod(work.shape), columns), np.int64)
    for chunk, table in enumerate(tables):
        numbers = table["numbers"].combine_chunks().flatten().to_numpy()
        total[slice(*work.cells(chunk))] += numbers.reshape(-1, columns)
    return total


# ------------------------------------------------------------------------------------ the dataset


def _shares(work: _Work, tables: Iterable[pa.Table], level: float) -> dict[str, xr.Variable]:
    """Return the variables of a map with scatter."""
    tally = Tally.read(_gathered(work, tables, COLUMNS).reshape(*work.shape, COLUMNS))
    made, valid = tally.ended(Outcome.MADE), tally.valid
    low, high = wilson(made, valid, level)
    with np.errstate(invalid="ignore"):
        probability = made / valid
        share = tally.of_kind() / tally.shots[..., None]
    dims = tuple(work.axes)
    counts = {
        "shots": tally.shots,
        **{one: tally.ended(Outcome[one.upper()]) for one in _COUNTED},
        "uncertain": tally.uncertain,
        "uncertain_capped": tally.uncertain_capped,
    }
    return {
        "probability": _variable(dims, probability, "probability of a made shot"),
        "low": _variable(dims, low, f"lower end of its {percent(level, None)} interval (Wilson)"),
        "high": _variable(dims, high, f"upper end of its {percent(level, None)} interval (Wilson)"),
        "share": _variable((*dims, "kind"), share, "share of the shots that are of a kind"),
        **{name: _variable(dims, n, _LABELS[name]) for name, n in counts.items()},
    }


_COUNTED = ("made", "capped", "short", "invalid")

_LABELS = {
    "shots": "shots",
    "made": "shots made",
    "capped": "shots given up after so many contacts",
    "short": "shots that never come down through the end plane",
    "invalid": "shots that cannot be simulated, and are no trials",
    "uncertain": "shots with a decision within its rounding-error bound",
    "uncertain_capped": "those of them that were given up",
}


def _outcomes(work: _Work, tables: Iterable[pa.Table]) -> dict[str, xr.Variable]:
    """Return the variables of a map of single shots."""
    numbers = _gathered(work, tables, 3).astype(np.uint8).reshape(*work.shape, 3)
    outcome, kind, uncertain = np.moveaxis(numbers, -1, 0)
    dims = tuple(work.axes)
    return {
        "outcome": _flags(dims, outcome, "outcome", Outcome),
        "kind": _flags(dims, kind, "kind of shot", Kind),
        "uncertain": xr.Variable(
            dims,
            uncertain.astype(np.bool_),
            {"long_name": "some decision is within its rounding-error bound"},
        ),
    }


def _variable(dims: tuple[str, ...], values: ArrayLike, label: str) -> xr.Variable:
    return xr.Variable(dims, values, {"units": "1", "long_name": label})


def _flags(
    dims: tuple[str, ...], values: NDArray[np.uint8], label: str, of: type[IntEnum]
) -> xr.Variable:
    """Return codes with their names, by the CF conventions."""
    attributes = {
        "long_name": label,
        "flag_values": np.array([one.value for one in of], np.uint8),
        "flag_meanings": " ".join(one.name.lower() for one in of),
    }
    return xr.Variable(dims, values, attributes)


def _coordinates(work: _Work) -> dict[str, xr.Variable]:
    """Return the axes, and what is the same in all cells."""
    coordinates = {
        name: xr.Variable((name,), values, _units(name)) for name, values in work.axes.items()
    }
    for name, value in _same(work).items():
        coordinates[name] = xr.Variable((), value, _units(name))
    if work.model.scatters:
        names = [kind.name.lower() for kind in Kind]
        coordinates["kind"] = xr.Variable("kind", names, {"long_name": "kind of shot"})
    return coordinates


def _same(work: _Work) -> dict[str, float]:
    """Return the variables that are the same in all cells."""
    gone = {*work.axes, *(other for name in work.axes for other in STANDS_FOR.get(name, ()))}
    same = change_variables(alike(work.model), dict.fromkeys(work.axes))
    return {name: value for name, value in same.items() if name not in gone}


def _units(name: str) -> dict[str, str]:
    variable = VARIABLES[name]
    return {"units": variable.unit or "1", "long_name": variable.label}


def _attributes(work: _Work, level: float) -> dict[str, Any]:
    """Return what the map was made with; the mappings as JSON, which every file format takes."""
    by_row = [name for name in scene_by_row(work.model) if name not in work.axes]
    others = {n: v for n, v in work.parameters.items() if n not in (*work.axes, *by_row)}
    scene = others | {n: v for n, v in alike(work.model).items() if n in others}
    return {
        "Conventions": "CF-1.11",
        "source": f"hoopgen {version()}",
        "scene": say_scene(scene, by_row),
        "parameters": json.dumps(scene),
        "max_contacts": work.max_contacts,
        **(
            {}
            if not work.model.scatters
            else {
                **model_told(work.model.identity()),
                "seed": str(work.seed),
                "confidence": level,
            }
        ),
    }
