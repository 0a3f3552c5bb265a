"""The flights of releases, as columns of a table with units."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.core.units import System, column_name, file_unit
from hoopgen.core.variables import Releases
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.engine.result_arrays import labels
from hoopgen.hoop.kinds import Kind, kinds
from hoopgen.results.shots import Shots
from hoopgen.simulation.simulate import simulate
from hoopgen.study.jobs.monte_carlo import scene_identity
from hoopgen.study.measures.measures import measure
from hoopgen.study.measures.rebounds import CATCHING_HEIGHT, caught_at
from hoopgen.study.models.release_model import from_columns
from hoopgen.study.named_units import UNIT_OF, named

from .event_log import EVENTS, events_by_row


@dataclass(frozen=True)
class Flights:
    """The settings that all flights of a table share, and the columns that they get.

    Attributes
    ----------
    parameters
        Of the scene, where no column says otherwise.
    release
        Variables of the release that are the same for all.
    measures
        Names of `hoopgen.study.measures.measures.MEASURES`.
    max_contacts
        With which a shot ends as capped.
    scene
        In which they are.
    catching_height
        Of rebounds, m above the floor.
    units
        Of the columns of results: "si", or "us".
    events
        Whether each row has its part of the event log, too, in a column `EVENTS`.
    """

    parameters: dict[str, float]
    release: dict[str, float]
    measures: tuple[str, ...]
    max_contacts: int
    scene: CompiledScene
    catching_height: float = CATCHING_HEIGHT
    units: System = "si"
    events: bool = False

    def identity(self) -> dict[str, Any]:
        """Return the identity of the results, in types that JSON knows."""
        return {
            "parameters": self.parameters,
            "release": self.release,
            "measures": self.measures,
            "max_contacts": self.max_contacts,
            **caught_at(self.measures, self.catching_height),
            **({} if self.units == "si" else {"units": self.units}),
            **({"events": True} if self.events else {}),
            **scene_identity(self.scene),
        }

    def releases(self, given: Mapping[str, NDArray[np.float64]]) -> Releases:
        """Return the shots of columns, and of what they share."""
        number = len(next(iter(given.values())))
        shared = {name: np.full(number, value) for name, value in self.release.items()}
        return from_columns({**given, **shared}, self.parameters)

    def results(self, given: Mapping[str, NDArray[np.float64]]) -> pa.Table:
        """Return the results of releases or states, a column each, with their units."""
        releases = self.releases(given)
        states, scene = releases.states, releases.parameters
        most = self.max_contacts
        shots = simulate(
            *(states, scene),
            scene=self.scene,
            max_contacts=most,
            threads=1,
            record=self.events,
        )
        columns = _ends(shots)
        more = [name for name in self.measures if name not in columns]
        if more:
            height = self.catching_height
            columns |= measure(states, shots, scene, more, catching_height=height)
        found = [self._column(name, column) for name, column in columns.items()]
        if self.events:
            log = events_by_row(shots, self.units)
            found.append((pa.field(EVENTS, log.type), log))
        fields, cells = zip(*found, strict=True)
        return pa.Table.from_arrays(list(cells), schema=pa.schema(fields))

    def _column(self, name: str, column: Any) -> tuple[pa.Field, Any]:
        """Return a column of results, in its unit."""
        unit, size = file_unit(UNIT_OF.get(name, ""), self.units)
        cells = pa.array(column if size == 1.0 else column / size)
        about = {"unit": unit, **self._about(name)} if name in UNIT_OF else None
        return pa.field(column_name(name, unit), cells.type, metadata=about), cells

    def _about(self, name: str) -> dict[str, str]:
        """Return the metadata of a column besides its unit."""
        height = caught_at([name], self.catching_height)
        return {named(one): repr(value) for one, value in height.items()}


def _ends(shots: Shots) -> dict[str, Any]:
    """Return the columns that every table of results has."""
    scene = shots.scene
    ended = shots.outcome < len(scene.kernels.ENDS)
    kind: dict[str, Any] = {}
    if scene.has_hoop:
        found = kinds(shots.outcome, shots.counts, shots.first)
        kind["kind"] = _words(found, [kind.name for kind in Kind])
    columns: dict[str, Any] = {}
    usual = (result for result in scene.layout.by_column if not result.is_on_request)
    for result in sorted(usual, key=lambda one: (one.is_diagnostic, one.is_at_end)):
        values = getattr(shots, result.name)
        for name, column in zip(labels(result), values.T if result.row else [values], strict=True):
            if result.flags:
                columns[name] = _words(column, result.flags[-result.first_flag :])
            elif result.is_at_end:
                columns[f"end_{name}"] = np.where(ended, column, np.nan)
            else:
                columns[name] = column
    return {"outcome": columns.pop("outcome"), **kind, **columns}


def _words(indices: NDArray[Any], names: Sequence[str]) -> pa.DictionaryArray:
    """Return names by index, in small letters; none where it is negative."""
    return pa.DictionaryArray.from_arrays(
        pa.array(indices.astype(_index_type(names)), mask=indices < 0),
        [name.lower() for name in names],
    )


def _index_type(names: Sequence[str]) -> Any:
    """Return the smallest type of signed whole numbers that counts names, eight bits at least."""
    return np.min_scalar_type(-max(len(names), 1))
