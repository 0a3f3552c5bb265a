"""Shots and trajectories as tables of pandas, xarray and Arrow, and in notebooks."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.event_log import Event, describe_event, number_contacts
from hoopgen.core.extras import require
from hoopgen.core.jacobian import Jacobian
from hoopgen.core.parameters import Value
from hoopgen.core.units import System, column_name, file_unit
from hoopgen.core.variables import STATE, STATE_UNITS
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.engine.result_arrays import labels
from hoopgen.generated.numpy.hoop import ResultField
from hoopgen.report.provenance import describe_scene
from hoopgen.report.quantities import for_json
from hoopgen.text.html import MAX_ROWS, some_rows, table
from hoopgen.text.numbers import format_uncertain

from .variations import derivative_arrays, event_derivative_arrays

if TYPE_CHECKING:
    from pandas import DataFrame
    from pyarrow import Table as ArrowTable
    from xarray import Dataset

__all__ = [
    "contacts_frame",
    "contacts_html",
    "event_columns",
    "event_numbers",
    "events_frame",
    "events_table",
    "outcome_counts",
    "scene_of",
    "shots_dataset",
    "shots_frame",
    "shots_html",
    "shots_table",
]


class Shots(Protocol):
    """The part of `hoopgen.Shots` that tables need, besides its fields."""

    @property
    def outcome(self) -> NDArray[np.uint8]: ...

    @property
    def parameters(self) -> Mapping[str, Value]: ...

    @property
    def scene(self) -> CompiledScene: ...

    @property
    def surfaces(self) -> tuple[str, ...]: ...

    @property
    def events(self) -> NDArray[np.void]: ...

    @property
    def jacobian(self) -> Jacobian: ...

    @property
    def event_jacobian(self) -> Jacobian: ...

    @property
    def differentiable(self) -> NDArray[np.bool_]: ...

    def __len__(self) -> int: ...


class Trajectory(Protocol):
    """The part of `hoopgen.Trajectory` that tables need."""

    @property
    def scene(self) -> CompiledScene: ...

    @property
    def release(self) -> NDArray[np.float64]: ...

    @property
    def events(self) -> NDArray[np.void]: ...


def _present(shots: Shots) -> list[ResultField]:
    """Return the results that the shots have, in the order of columns."""
    return [result for result in shots.scene.layout.by_column if hasattr(shots, result.name)]


def scene_of(shots: Shots) -> str:
    """Return a description of the scene of shots."""
    return describe_scene(shots.scene, shots.parameters)


def _columns(shots: Shots, rows: Any = slice(None)) -> dict[str, NDArray[Any]]:
    """Return the present results as columns; outcome and first surface are codes."""
    columns: dict[str, NDArray[Any]] = {}
    for result in _present(shots):
        part = getattr(shots, result.name)[rows]
        columns |= dict(zip(labels(result), part.T if part.ndim > 1 else [part], strict=True))
    return columns


def _words(shots: Shots) -> dict[str, list[str]]:
    """Return the meanings of the values of columns, from 0 on; values below have none."""
    flagged = (result for result in _present(shots) if result.flags)
    return {result.name: list(result.flags[-result.first_flag :]) for result in flagged}


def shots_frame(shots: Shots) -> DataFrame:
    """Return the table of `Shots.to_pandas`."""
    pd = require("pandas", "to_pandas")
    columns: dict[str, Any] = dict(_columns(shots))
    for name, words in _words(shots).items():
        columns[name] = pd.Categorical.from_codes(columns[name], words)
    units = shots.scene.layout.units
    columns = {column_name(name, units.get(name, "")): one for name, one in columns.items()}
    frame = pd.DataFrame(columns, pd.RangeIndex(len(shots), name="shot"))
    frame.attrs["scene"] = scene_of(shots)
    return frame


def shots_table(shots: Shots) -> ArrowTable:
    """Return the table of `Shots.to_arrow`."""
    pa = require("pyarrow", "to_arrow")
    units, words = shots.scene.layout.units, _words(shots)
    columns: dict[str, Any] = {"shot": np.arange(len(shots))}
    for name, column in _columns(shots).items():
        codes = pa.array(column, mask=column < 0 if name in words else None)
        columns[column_name(name, units.get(name, ""))] = (
            pa.DictionaryArray.from_arrays(codes, words[name]) if name in words else codes
        )
    return pa.table(columns).replace_schema_metadata({"scene": scene_of(shots)})


def shots_dataset(shots: Shots) -> Dataset:
    """Return the dataset of `Shots.to_xarray`."""
    xr = require("xarray", "to_xarray")
    data, coordinates = {}, {"shot": np.arange(len(shots))}
    units: dict[str, Any] = {}
    for result in _present(shots):
        values, dimensions = getattr(shots, result.name), ["shot"]
        if result.dimension:
            dimensions.append(result.dimension)
            coordinates[result.dimension] = np.array(result.coordinates)
        if result.unit_coordinate:
            units[result.unit_coordinate] = (result.dimension, list(result.units))
        attributes: dict[str, Any] = {}
        if result.units and not result.row:
            attributes = {"units": result.units[0]}
        if result.flags:
            low = result.first_flag
            codes = np.arange(low, low + len(result.flags), dtype=values.dtype)
            attributes = {"flag_values": codes, "flag_meanings": " ".join(result.flags)}
        data[result.name] = (dimensions, values, attributes)
    if hasattr(shots, "jacobian"):
        more, along = derivative_arrays(shots.jacobian, shots.differentiable, shots.scene)
        data, units = data | more, units | along
    if hasattr(shots, "jacobian") and hasattr(shots, "events"):
        more, along = event_derivative_arrays(shots.event_jacobian, shots.events, shots.scene)
        data, units = data | more, units | along
    dataset: Dataset = xr.Dataset(data, coordinates).assign_coords(units)
    alike = {name: float(v) for name, v in shots.parameters.items() if np.ndim(v) == 0}
    dataset.attrs["scene"] = scene_of(shots)
    dataset.attrs["parameters"] = json.dumps(for_json(alike))
    apart = {name: ("shot", v) for name, v in shots.parameters.items() if np.ndim(v)}
    return dataset.assign_coords(apart)


def outcome_counts(shots: Shots) -> str:
    """Return the numbers of shots by outcome, and of uncertain ones, as text."""
    ended = {
        one.name.lower(): np.count_nonzero(shots.outcome == one) for one in shots.scene.outcomes
    }
    said = ", ".join(f"{count:,} {name}" for name, count in ended.items() if count)
    uncertain = getattr(shots, "uncertain", None)
    if uncertain is None or not uncertain.any():
        return said
    capped = uncertain & (shots.outcome == shots.scene.outcomes["CAPPED"])
    return f"{said}; {format_uncertain(int(uncertain.sum()), int(capped.sum()))}"


def shots_html(shots: Shots) -> str:
    """Return a table of the first and the last shots."""
    rows = some_rows(len(shots))
    columns: dict[str, list[Any]] = {
        name: column.tolist() for name, column in _columns(shots, np.array(rows, np.intp)).items()
    }
    for name, words in _words(shots).items():
        columns[name] = [words[code] if code >= 0 else "" for code in columns[name]]
    head = ["shot", *(heading for result in _present(shots) for heading in _headings(result))]
    about = repr(shots).removeprefix("Shots(").removesuffix(")")
    gap = MAX_ROWS // 2 if len(rows) < len(shots) else None
    return table(about, head, zip(rows, *columns.values(), strict=True), gap=gap)


def event_columns(
    events: NDArray[np.void], scene: CompiledScene, units: System = "si"
) -> dict[str, NDArray[Any] | tuple[NDArray[Any], list[str]]]:
    """Return an event log as columns, with units in their names.

    Time, kind, surface, position, velocity and spin before and after, and the bounds on errors that
    it has.

    Parameters
    ----------
    events
        (n,), as of `hoopgen.Shots.events`.
    scene
        The scene of the shots.
    units
        "si" or "us"; see `hoopgen.core.units.file_unit`.

    Returns
    -------
    dict
        Columns (n,); kind and surface are pairs of codes and the words for them.
    """
    numbers = {"time": ("s", events["time"])}
    numbers |= {one: (STATE_UNITS[one], events["before"][:, k]) for k, one in enumerate(STATE[:3])}
    for name in ("before", "after"):
        moving = enumerate(STATE[3:], 3)
        numbers |= {f"{name}_{one}": (STATE_UNITS[one], events[name][:, k]) for k, one in moving}
    for name in scene.layout.logged_errors(events.dtype.names or ()):
        result = scene.layout.results[name]
        own = zip(
            labels(result), result.units, events[name].reshape(len(events), -1).T, strict=True
        )
        numbers |= {label: (unit, column) for label, unit, column in own}
    columns: dict[str, Any] = {}
    for name, (si, column) in numbers.items():
        unit, size = file_unit(si, units)
        columns[column_name(name, unit)] = column / size if size != 1.0 else column.copy()
        if name == "time":
            columns["kind"] = events["kind"], [one.name.lower() for one in Event]
            columns["surface"] = events["surface"], [*scene.surfaces, "end"]
    return columns


def _events_frame(events: NDArray[np.void], scene: CompiledScene) -> dict[str, Any]:
    """Return an event log as columns for pandas."""
    pd = require("pandas", "to_pandas")
    return {
        name: pd.Categorical.from_codes(*column) if isinstance(column, tuple) else column
        for name, column in event_columns(events, scene).items()
    }


def contacts_frame(trajectory: Trajectory) -> DataFrame:
    """Return the table of `Trajectory.to_pandas`."""
    pd = require("pandas", "to_pandas")
    columns = _events_frame(trajectory.events, trajectory.scene)
    index = pd.RangeIndex(1, len(trajectory.events) + 1, name="event")
    return pd.DataFrame(columns, index)


def events_frame(shots: Shots) -> DataFrame:
    """Return the table of `Shots.events_to_pandas`."""
    pd = require("pandas", "events_to_pandas")
    events: NDArray[np.void] = shots.events
    index = pd.MultiIndex.from_arrays([events["shot"], event_numbers(events)])
    return pd.DataFrame(_events_frame(events, shots.scene), index.set_names(["shot", "event"]))


def events_table(shots: Shots) -> ArrowTable:
    """Return the table of `Shots.events_to_arrow`."""
    pa = require("pyarrow", "events_to_arrow")
    events: NDArray[np.void] = shots.events
    columns = {"shot": events["shot"], "event": event_numbers(events)}
    columns |= {
        name: pa.DictionaryArray.from_arrays(*column) if isinstance(column, tuple) else column
        for name, column in event_columns(events, shots.scene).items()
    }
    return pa.table(columns).replace_schema_metadata({"scene": scene_of(shots)})


def event_numbers(events: NDArray[np.void]) -> NDArray[np.int64]:
    """Return the number of each event among those of its shot, from 1."""
    rows = np.arange(len(events))
    return rows - np.searchsorted(events["shot"], events["shot"]) + 1


def contacts_html(trajectory: Trajectory) -> str:
    """Return a table of the events."""
    surfaces = trajectory.scene.surfaces
    rows = [("", "release", 0.0, *trajectory.release[:3].tolist(), "", _speed(trajectory.release))]
    for number, event in number_contacts(trajectory.events):
        where = event["before"][:3].tolist()
        speeds = _speed(event["before"]), _speed(event["after"])
        rows.append(
            (number or "", describe_event(event, surfaces), float(event["time"]), *where, *speeds)
        )
    head = ["", "event", "time (s)", "x (m)", "y (m)", "z (m)"]
    head += ["speed before (m/s)", "speed after (m/s)"]
    return table(repr(trajectory).partition("(")[2].removesuffix(")"), head, rows)


def _speed(state: NDArray[np.float64]) -> float:
    return float(np.linalg.norm(state[3:6]))


def _headings(result: ResultField) -> Sequence[str]:
    """Return the headings of the columns of a result, with units in brackets."""
    if result.units:
        units = zip(labels(result), result.units, strict=True)
        return [f"{name} ({unit})" for name, unit in units]
    return result.coordinates or labels(result)
