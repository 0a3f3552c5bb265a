"""The job of a map: some shots of some cells, every cell with the same noise."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import prod
from typing import Any, TypeAlias

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.core.backend_names import BackendName
from hoopgen.hoop.kinds import kinds
from hoopgen.results.shots import Shots
from hoopgen.simulation.engine import Engine
from hoopgen.study.jobs.chunks import ShotsJob
from hoopgen.study.jobs.monte_carlo import scene_identity, simulated
from hoopgen.study.models.resample import Resample
from hoopgen.study.models.scatter import Scatter
from hoopgen.study.statistics.tally import BLOCK, Tally

CHUNK = 1 << 17
"""Shots in a chunk of few cells, at most, and single ones in any."""

_CHUNKS, _CELLS = 64, 512
"""Chunks that many cells are in, and most of them in one."""

Floats: TypeAlias = NDArray[np.float64]


@dataclass(frozen=True)
class Sweep(ShotsJob):
    """A job of `chunks.run`: some shots of some cells, every cell with the same noise.

    Cells are numbered with the last axis fastest. A chunk goes over many cells, so that noise is
    drawn for all of them at once. Which cells and which shots are in it does not depend on the
    number of shots, so that a folder can be asked for more.
    """

    axes: Mapping[str, Floats]
    model: Scatter | Resample
    parameters: Mapping[str, float]
    shots: int
    seed: int
    max_contacts: int
    backend: BackendName
    scene: Engine

    @property
    def shape(self) -> tuple[int, ...]:
        """The number of values of each variable."""
        return tuple(len(values) for values in self.axes.values())

    @property
    def together(self) -> tuple[int, int]:
        """The number of cells in a chunk, and of shots of each, at most."""
        if not self.model.scatters:
            return CHUNK, 1
        return max(CHUNK // BLOCK, min(_CELLS, -(-prod(self.shape) // _CHUNKS))), BLOCK

    @property
    def _blocks(self) -> tuple[int, int]:
        cells, shots = self.together
        return -(-prod(self.shape) // cells), -(-self.shots // shots)

    @property
    def chunks(self) -> int:
        """The number of chunks."""
        return prod(self._blocks)

    def cells(self, chunk: int) -> tuple[int, int]:
        """Return the first cell of a chunk, and the one after its last."""
        cells, _ = self.together
        start = chunk % self._blocks[0] * cells
        return start, min(start + cells, prod(self.shape))

    def shots_of(self, chunk: int) -> tuple[int, int]:
        """Return the first shot of a chunk's cells, and the one after their last."""
        _, many = self.together
        start = chunk // self._blocks[0] * many
        return start, min(start + many, self.shots)

    def identity(self) -> dict[str, Any]:
        """Return the identity of the chunks: everything that they depend on."""
        return {
            "over": {name: values.tolist() for name, values in self.axes.items()},
            "model": self.model.identity(),
            "parameters": dict(self.parameters),
            "seed": self.seed,
            "max_contacts": self.max_contacts,
            **scene_identity(self.scene),
        }

    def shots_in(self, kept: pa.Table) -> int:
        """Return the number of shots per cell of a stored chunk."""
        return int(Tally.read(rows_of(kept)[0], self.scene).shots) if self.model.scatters else 1

    def counted(
        self, chunk: int, start: int, stop: int, before: pa.Table | None = None
    ) -> pa.Table:
        """Return the numbers of some shots of a chunk's cells, a row each, and of those before.

        Parameters
        ----------
        chunk
            The index of the chunk.
        start
            The index of the first shot of each cell.
        stop
            The index after that of the last shot.
        before
            The numbers of the shots before; None if there are none.
        """
        noise = self.model.noise(start, stop, self.seed)
        few = max(1, BLOCK // (stop - start))
        low, high = self.cells(chunk)
        parts = []
        for cell in range(low, high, few):
            last = min(cell + few, high)
            shots = self.simulate(cell, last, stop - start, noise)
            tallied = self.model.scatters
            parts.append(Tally.from_shots(shots, last - cell).row() if tallied else _row(shots))
        numbers = np.concatenate(parts) + (0 if before is None else rows_of(before))
        flat = pa.array(numbers.ravel())
        return pa.table({"numbers": pa.FixedSizeListArray.from_arrays(flat, numbers.shape[1])})

    def simulate(self, start: int, stop: int, shots: int, noise: Mapping[str, Floats]) -> Shots:
        """Return so many shots of each of the cells `start` to `stop` - 1, cell by cell.

        Parameters
        ----------
        start
            The index of the first cell.
        stop
            The index after that of the last cell.
        shots
            The number of shots of each cell.
        noise
            The scatter of the shots by variable, SI and rad.
        """
        places = np.unravel_index(np.arange(start, stop), self.shape)
        values = {
            name: axis[place][:, None]
            for (name, axis), place in zip(self.axes.items(), places, strict=True)
        }
        releases = self.model.around(values, noise, self.parameters, shots)
        return simulated(releases, self.max_contacts, self.backend, self.scene)


SINGLE = 3
"""Numbers of a cell without scatter."""


def _row(shots: Shots) -> NDArray[np.int64]:
    """Return outcome, kind and uncertainty of each shot, (n, 3); the kind is 0 without a hoop."""
    kind = np.zeros_like(shots.outcome)
    if shots.scene.has_hoop:
        kind = kinds(shots.outcome, shots.counts, shots.first)
    return np.stack([shots.outcome, kind, shots.uncertain], axis=-1).astype(np.int64)


def rows_of(table: pa.Table) -> NDArray[np.int64]:
    """Return the numbers of a chunk's cells, (cells, columns)."""
    numbers = table["numbers"].combine_chunks().flatten().to_numpy()
    return np.asarray(numbers.reshape(table.num_rows, -1))
