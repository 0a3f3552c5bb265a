"""A table for a machine that shoots: the release for each distance, and what it forgives."""

from __future__ import annotations

import csv
import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import ceil
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.files import atomic_text_file
from hoopgen.core.si_checks import check_spins
from hoopgen.core.units import DEGREE, TURN, column_name
from hoopgen.core.validation import as_doubles
from hoopgen.hoop.flights import is_in_air
from hoopgen.hoop.parabolas import Arc
from hoopgen.hoop.presets import PAPER
from hoopgen.scene.lookup import SceneLike, check_hoop
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.hoop import HOOP
from hoopgen.simulation.lookup import engine_of
from hoopgen.study.jobs.chunks import Progress, run
from hoopgen.study.jobs.monte_carlo import scene_identity
from hoopgen.study.jobs.objective import By, Player
from hoopgen.study.named_units import UNIT_OF
from hoopgen.study.statistics.tally import check_scene

from .aim import aim
from .aimed_release import NUMBERS
from .margins import margins_about
from .specification import TOLERANCES

_SPINS = ("backspin", "sidespin")

TABLE: Mapping[str, str] = {
    name: UNIT_OF[name]
    for name in (
        *("distance", "angle", "height"),
        *_SPINS,
        *("speed", "elevation", "azimuth", "entry_angle", "time"),
        *(f"{end}_{name}" for name in TOLERANCES for end in ("low", "high")),
    )
}
"""Columns of a table and their units. From `low_speed` to `high_speed`, and so on, this one alone
may be off, and the ball still goes in."""


def aim_table(
    distances: ArrayLike,
    *,
    height: ArrayLike,
    angle: ArrayLike = 0.0,
    entry: ArrayLike | None = None,
    elevation: ArrayLike | None = None,
    speed: ArrayLike | None = None,
    arc: Arc = "high",
    depth: ArrayLike = 0.0,
    target: ArrayLike | None = None,
    backspin: ArrayLike = 0.0,
    sidespin: ArrayLike = 0.0,
    moving: ArrayLike | None = None,
    by: By = "any",
    parameters: Mapping[str, Any] | None = None,
    scene: SceneLike = None,
    threads: int | None = None,
    folder: str | os.PathLike[str] | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
) -> dict[str, NDArray[np.float64]]:
    """Return the release for each distance, and how far it may be off.

    Parameters
    ----------
    distances
        From the ring's centre on the floor plan, m, (n,).
    height, angle, entry, elevation, speed, arc, depth
        As for `aim`: one number, or (n,).
    target
        As for `aim`: one point, (3,), or (n, 3).
    backspin, sidespin
        rad/s: one number, or (n,).
    moving
        As for `aim`: one velocity, (2,), or (n, 2).
    by
        What counts: "any" shot made, "direct" if the board is not touched first, "bank" if it is.
    parameters
        Of the scene, one number each; None: the usual ones.
    scene
        As for `aim`.
    threads, folder, scheduler, progress
        As for `hoopgen.estimate`.

    Returns
    -------
    dict
        The columns of `TABLE`, (n,) each. The ends of a tolerance are those of the connected
        interval about the aim, found by simulation as `margins` does: looked for up to 25% of the
        speed and 25° away, in steps of a 2000th of that, within which a gap may be overlooked, and
        then bisected. They are NaN where the aimed shot does not go in itself; speed, angles and
        time too where there is no such aim.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    places = np.atleast_1d(as_doubles("distances", distances))
    if places.ndim != 1:
        raise ValueError(f"distances: expected shape (n,), got {places.shape}")
    check_hoop("aim_table", scene)
    engine = engine_of(scene)
    columns = {
        "backspin": as_doubles("backspin", backspin),
        "sidespin": as_doubles("sidespin", sidespin),
    }
    check_spins("aim", columns)
    found = aim(
        height=height,
        distance=places,
        angle=angle,
        entry=entry,
        elevation=elevation,
        speed=speed,
        arc=arc,
        depth=depth,
        target=target,
        moving=moving,
        parameters=parameters,
        scene=engine,
        **(columns if is_in_air(engine.parameters) else {}),
    )
    columns |= {name: np.asarray(getattr(found, name)) for name in NUMBERS}
    count = len(places)
    for name, column in columns.items():
        if column.shape not in ((), (count,)):
            raise ValueError(f"{name}: expected one number or {count}; got shape {column.shape}")
    table = {name: np.full(count, np.nan) for name in TABLE}
    for name, column in columns.items():
        table[name][:] = column
    checked = check_scene(parameters, engine)
    Player(parameters=checked, by=by, scene=engine)  # what is wrong shows before a folder is made
    rows = np.flatnonzero(np.isfinite(table["speed"]))
    names = dict.fromkeys((*found.arguments, *_SPINS))
    velocity = None
    if found.moving is not None:
        velocity = np.broadcast_to(found.moving, (count, 2))[rows]
    releases = {name: table[name][rows] for name in names}
    job = _TableJob(releases, checked, by, engine, velocity)
    done = run(job, folder, scheduler=scheduler, threads=threads, progress=progress)
    for chunk, ends in enumerate(done):
        some = rows[chunk * ROWS : (chunk + 1) * ROWS]
        for name in ends.column_names:
            table[name][some] = ends[name].to_numpy()
    return table


ROWS = 16
"""Rows in a chunk: a small part of a second."""


@dataclass(frozen=True)
class _TableJob:
    """A job of `chunks.run`: how far the releases of a table may be off, some rows a chunk."""

    releases: Mapping[str, NDArray[np.float64]]
    parameters: Mapping[str, float]
    by: By
    scene: Engine = HOOP
    moving: NDArray[np.float64] | None = None

    @property
    def chunks(self) -> int:
        """The number of chunks."""
        return ceil(len(self.releases["speed"]) / ROWS)

    def identity(self) -> dict[str, Any]:
        """Return the identity of the chunks: everything that they depend on."""
        releases = {name: column.tolist() for name, column in self.releases.items()}
        parameters = dict(self.parameters)
        identity = {"aim": releases, "parameters": parameters, "by": self.by}
        if self.moving is not None:
            identity["moving"] = self.moving.tolist()
        return identity | scene_identity(self.scene)

    def compute(self, chunk: int) -> pa.Table:
        """Return the ends of each row's tolerances, by the names of `TABLE`."""
        start = chunk * ROWS
        some = {name: c[start : start + ROWS] for name, c in self.releases.items()}
        columns = [f"{end}_{name}" for name in TOLERANCES for end in ("low", "high")]
        ends: dict[str, list[float]] = {name: [] for name in columns}
        player = Player(parameters=self.parameters, by=self.by, scene=self.scene)
        for row in range(len(some["speed"])):
            aimed = {name: column[row].item() for name, column in some.items()}
            if self.moving is not None:
                along, across = self.moving[start + row].tolist()
                player = replace(player, moving=(along, across))
            for name, margin in margins_about(aimed, TOLERANCES, player, 1, 0, 0.5).items():
                ends[f"low_{name}"].append(margin.low)
                ends[f"high_{name}"].append(margin.high)
        return pa.table(ends)


_SHOWN: Mapping[str, tuple[str, float]] = {"rad": ("deg", DEGREE), "rad/s": ("Hz", TURN)}
"""Units of files, whose numbers are set on a machine, in place of others, and their sizes."""


def write_csv(
    path: str | os.PathLike[str],
    table: Mapping[str, NDArray[np.float64]],
    parameters: Mapping[str, float] = PAPER,
) -> None:
    """Write a table of `aim_table`: degrees and Hz, the unit in each column's name.

    What is NaN is left empty. The last columns are the parameters of the scene, so that
    `hoopgen.batch` flies the releases in it; SI.

    Parameters
    ----------
    path
        The file.
    table
        Columns by name, (n,) each, SI and rad.
    parameters
        Parameters of the hoop by name, SI.

    Raises
    ------
    OSError
        If the file cannot be written; what was there before stays.
    """
    shown = {name: _SHOWN.get(TABLE[name], (TABLE[name], 1.0)) for name in table}
    columns = [table[name] / size for name, (_, size) in shown.items()]
    with atomic_text_file(path) as file:
        writer = csv.writer(file, lineterminator="\n")
        names = (column_name(name, unit) for name, (unit, _) in shown.items())
        writer.writerow([*names, *parameters])
        for row in zip(*columns, strict=True):
            # Ten digits: more than a machine holds, and no traces of the conversion.
            cells = ["" if np.isnan(cell) else f"{cell:.10g}" for cell in row]
            writer.writerow([*cells, *map(float, parameters.values())])
