"""`map`: what becomes of a shot, or how probably it is made, over any of its variables."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sized
from dataclasses import dataclass
from functools import partial
from math import prod
from os import PathLike
from typing import Any, TypeAlias

import numpy as np
import pyarrow as pa
import xarray as xr
from numpy.typing import ArrayLike, NDArray

from hoopgen.brief import brief
from hoopgen.engines import Engine
from hoopgen.hoop.kinds import kinds
from hoopgen.hoop.variables import check_angles
from hoopgen.inputs import Backend, check_count, doubles
from hoopgen.results import Shots
from hoopgen.scenes import STATES, engine_of, variables_of
from hoopgen.sizes import check_room
from hoopgen.variables import Variable, check_names

from .chunks import Rest, run
from .draws import check_seed
from .mapped import dataset
from .resample import Resample
from .scatter import Scatter
from .scattering import check_thrown
from .tallies import BLOCK, Tally, check_scene, check_share, contacts_of, width_of
from .throws import check_states, flown, scene_identity

__all__ = ["check_cells", "map"]

SHOTS = 10_000
"""Of a cell, unless asked for otherwise."""

_CHUNK = 1 << 17
"""Shots in a chunk of few cells, at most, and single ones in any."""

_CHUNKS, _CELLS = 64, 512
"""Chunks that many cells are in, and most of them in one."""

_CELL, _TALLIED = 48, 720
"""Bytes that a cell takes at the most, single or with scatter, until it is in a file."""

Floats: TypeAlias = NDArray[np.float64]


def map(
    model: Scatter | Resample,
    over: Mapping[str, ArrayLike],
    parameters: Mapping[str, Any] | None = None,
    *,
    scene: Any = None,
    shots: int | None = None,
    confidence: float = 0.95,
    seed: int = 0,
    max_contacts: int | None = None,
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
        Variables, see `VARIABLES`, and the values that each takes; m, m/s, rad, rad/s. Of states
        their components, and in any scene its parameters.
    parameters
        Of the scene, for those that neither `over` nor the model names.
    scene
        As for `hoopgen.simulate`. Where there is no hoop the releases are states.
    shots
        Of each cell; by default 10,000. All cells have the same random numbers.
    confidence
        Of the intervals, within 0 and 1.
    seed
        From 0 to 2^64 - 1.
    max_contacts, backend
        As for `hoopgen.simulate`.
    threads, folder, scheduler, progress
        As for `hoopgen.estimate`; a folder may be asked for other `shots`, not for other cells.

    Returns
    -------
    xarray.Dataset
        Its dimensions are the names of `over`, in their order; coordinates, those of `release`
        too, have ``units`` and ``long_name``. With scatter there are `probability`, `low` and
        `high` (as of `Estimate`: of the simulation alone, which of measured releases the attribute
        ``interval`` says), numbers of shots `shots`, `made`, `capped`, `short`, `invalid`
        and `uncertain`, of those `uncertain_capped`, and `share` by `kind`. Without, `outcome` and
        `kind` (codes, named in ``flag_meanings``) and `uncertain`. A cell that cannot be simulated
        is INVALID, and its probability NaN. In a scene of one's own there are no kinds, and with
        scatter `share`, `low`, `high` and `count` by `ending`, its outcomes.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    scatters = check_thrown(model, over).scatters
    if shots is not None and not scatters:
        raise ValueError("shots: without scatter all shots of a cell are one; leave out")
    engine = engine_of(scene)
    check_states(model, engine, over)
    work = _Work(
        axes=_axes(over, model, engine),
        model=model,
        parameters=check_scene(parameters, engine),
        shots=check_count("shots", SHOTS if shots is None else shots) if scatters else 1,
        seed=check_seed(seed),
        max_contacts=contacts_of(max_contacts, engine),
        backend=backend,
        scene=engine,
    )
    level = check_share("confidence", confidence)
    check_cells(work.axes, scatters=scatters)
    work.simulate(0, 1, 1, model.noise(0, 1, seed))  # what is wrong shows before a folder is made
    tables = run(work, folder, scheduler=scheduler, threads=threads, progress=progress)
    columns = width_of(engine) if scatters else SINGLE
    return dataset(work, _gathered(work, tables, columns), level)


def check_cells(over: Mapping[str, Sized], *, scatters: bool) -> None:
    """Refuse a map of more cells than there is memory for.

    Raises
    ------
    ValueError
        If there are too many; with what they would take.
    """
    cells = prod(len(values) for values in over.values())
    check_room("over", cells, "cells", _TALLIED if scatters else _CELL)


def _axes(over: Mapping[str, ArrayLike], model: Any, scene: Engine) -> dict[str, Floats]:
    check_names("over", over, tuple(_variables(scene, state=model.is_state)))
    if not over:
        raise ValueError("over: expected a variable and its values at the least")
    axes = {name: doubles(f"over[{name!r}]", values) for name, values in over.items()}
    for name, values in axes.items():
        if values.ndim != 1 or not values.size:
            raise ValueError(f"over[{name!r}]: expected a list of numbers, got {brief(over[name])}")
    if not model.is_state:
        check_angles("over", axes)
    return axes


def _variables(scene: Engine, *, state: bool) -> Mapping[str, Variable]:
    """Return what can be mapped over: where the shots are states, their components."""
    return {**variables_of(scene), **(STATES if state else {})}


# ------------------------------------------------------------------------------------ the work


@dataclass(frozen=True)
class _Work:
    """A job of `chunks.run`: some shots of some cells, every cell with the same noise.

    Cells are numbered with the last axis fastest. A chunk goes over many cells, so that noise is
    drawn for all of them at once. Which cells and which shots are in it does not hang on the number
    of shots, so that a folder can be asked for more.
    """

    axes: Mapping[str, Floats]
    model: Scatter | Resample
    parameters: Mapping[str, float]
    shots: int
    seed: int
    max_contacts: int
    backend: Backend
    scene: Engine

    @property
    def shape(self) -> tuple[int, ...]:
        return tuple(len(values) for values in self.axes.values())

    @property
    def together(self) -> tuple[int, int]:
        """How many cells are in a chunk, and how many shots of each, at most."""
        if not self.model.scatters:
            return _CHUNK, 1
        return max(_CHUNK // BLOCK, min(_CELLS, -(-prod(self.shape) // _CHUNKS))), BLOCK

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
        start = chunk % self._blocks[0] * cells
        return start, min(start + cells, prod(self.shape))

    def _shots_of(self, chunk: int) -> tuple[int, int]:
        """Return the first shot of a chunk's cells, and the one after their last."""
        _, many = self.together
        start = chunk // self._blocks[0] * many
        return start, min(start + many, self.shots)

    def identity(self) -> dict[str, Any]:
        """Return what the chunks depend on."""
        return {
            "over": {name: values.tolist() for name, values in self.axes.items()},
            "model": self.model.identity(),
            "parameters": dict(self.parameters),
            "seed": self.seed,
            "max_contacts": self.max_contacts,
            **scene_identity(self.scene),
        }

    def compute(self, chunk: int) -> pa.Table:
        """Return a row of numbers for each cell of a chunk."""
        return self.counted(chunk, *self._shots_of(chunk))

    def rest(self, chunk: int, kept: pa.Table) -> Rest | None:
        """Return what goes on with a chunk whose cells have fewer shots, or that counts fewer."""
        if not self.model.scatters:
            return None
        start, stop = self._shots_of(chunk)
        numbers = _rows(kept)
        there = start + int(Tally.read(numbers[0], self.scene).shots)
        if there == stop:
            return None
        if there > stop:
            return Rest(partial(self.counted, chunk, start, stop), more=False)
        return Rest(partial(self.counted, chunk, there, stop, numbers), more=True)

    def counted(
        self, chunk: int, start: int, stop: int, before: NDArray[np.int64] | None = None
    ) -> pa.Table:
        """Return the numbers of some shots of a chunk's cells, and of those before them."""
        noise = self.model.noise(start, stop, self.seed)
        few = max(1, BLOCK // (stop - start))
        low, high = self.cells(chunk)
        parts = []
        for cell in range(low, high, few):
            last = min(cell + few, high)
            shots = self.simulate(cell, last, stop - start, noise)
            tallied = self.model.scatters
            parts.append(Tally.of(shots, last - cell).row() if tallied else _row(shots))
        numbers = np.concatenate(parts) + (0 if before is None else before)
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
        return flown(releases, self.max_contacts, self.backend, self.scene)


SINGLE = 3
"""Numbers of a cell without scatter."""


def _row(shots: Shots) -> NDArray[np.int64]:
    """Return outcome, kind and doubt of each shot, (n, 3); the kind is 0 without a hoop."""
    kind = np.zeros_like(shots.outcome)
    if shots.scene.has_hoop:
        kind = kinds(shots.outcome, shots.counts, shots.first)
    return np.stack([shots.outcome, kind, shots.uncertain], axis=-1).astype(np.int64)


def _gathered(work: _Work, tables: Iterable[pa.Table], columns: int) -> NDArray[np.int64]:
    """Return the sums of the cells' numbers, (cells, columns)."""
    total = np.zeros((prod(work.shape), columns), np.int64)
    for chunk, table in enumerate(tables):
        total[slice(*work.cells(chunk))] += _rows(table)
    return total


def _rows(table: pa.Table) -> NDArray[np.int64]:
    """Return the numbers of a chunk's cells, (cells, columns)."""
    numbers = table["numbers"].combine_chunks().flatten().to_numpy()
    return np.asarray(numbers.reshape(table.num_rows, -1))
