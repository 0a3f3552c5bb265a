"""`map`: what becomes of a shot, or how probably it is made, over any of its variables."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import prod
from os import PathLike
from typing import Any, TypeAlias

import numpy as np
import pyarrow as pa
import xarray as xr
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.backend_names import BackendName
from hoopgen.core.memory import check_room
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.validation import as_doubles, check_count
from hoopgen.core.variables import Variable, check_names
from hoopgen.hoop.variables import check_angles
from hoopgen.scene.lookup import STATES, SceneLike, variables_of
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.lookup import engine_of
from hoopgen.study.jobs.chunks import Progress, run
from hoopgen.study.jobs.monte_carlo import check_states
from hoopgen.study.models.random import check_seed
from hoopgen.study.models.requirements import check_model
from hoopgen.study.models.resample import Resample
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.statistics.tally import check_scene, check_share, contacts_of, width_of
from hoopgen.text.shorten import brief

from .map_dataset import dataset
from .sweep import SINGLE, Sweep, rows_of

SHOTS = 10_000
"""Number of shots of a cell, unless asked for otherwise."""

_CELL, _TALLIED = 48, 720
"""Bytes that a cell takes at the most, single or with scatter, until it is in a file."""

Floats: TypeAlias = NDArray[np.float64]


@check_arguments
def map(
    model: Scatter | Resample,
    over: Mapping[str, ArrayLike],
    parameters: ParameterValues | None = None,
    *,
    scene: SceneLike = None,
    shots: int | None = None,
    confidence: float = 0.95,
    seed: int = 0,
    max_contacts: int | None = None,
    backend: BackendName = "auto",
    threads: int | None = None,
    folder: str | PathLike[str] | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
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
    scatters = check_model(model, over).scatters
    if shots is not None and not scatters:
        raise ValueError("shots: without scatter all shots of a cell are one; leave out")
    engine = engine_of(scene)
    check_states(model, engine, over)
    work = Sweep(
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
    check_room("over", prod(work.shape), "cells", _TALLIED if scatters else _CELL)
    work.simulate(0, 1, 1, model.noise(0, 1, seed))  # what is wrong shows before a folder is made
    tables = run(work, folder, scheduler=scheduler, threads=threads, progress=progress)
    columns = width_of(engine) if scatters else SINGLE
    return dataset(work, _gathered(work, tables, columns), level)


def _axes(over: Mapping[str, ArrayLike], model: Any, scene: Engine) -> dict[str, Floats]:
    check_names("over", over, tuple(_variables(scene, state=model.is_state)))
    if not over:
        raise ValueError("over: expected a variable and its values at the least")
    axes = {name: as_doubles(f"over[{name!r}]", values) for name, values in over.items()}
    for name, values in axes.items():
        if values.ndim != 1 or not values.size:
            raise ValueError(f"over[{name!r}]: expected a list of numbers, got {brief(over[name])}")
        if np.isnan(values).any():
            raise ValueError(f"over[{name!r}]: expected numbers, got NaN among {brief(over[name])}")
    if not model.is_state:
        check_angles("over", axes)
    return axes


def _variables(scene: Engine, *, state: bool) -> Mapping[str, Variable]:
    """Return the variables that can be mapped over: of states their components."""
    return {**variables_of(scene), **(STATES if state else {})}


def _gathered(work: Sweep, tables: Iterable[pa.Table], columns: int) -> NDArray[np.int64]:
    """Return the sums of the cells' numbers, (cells, columns)."""
    total = np.zeros((prod(work.shape), columns), np.int64)
    for chunk, table in enumerate(tables):
        total[slice(*work.cells(chunk))] += rows_of(table)
    return total
