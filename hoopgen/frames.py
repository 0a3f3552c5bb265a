"""Shots and trajectories as tables: of pandas, of xarray, and of a notebook."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import partial
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from .events import Event, event_words, numbered
from .installed import need
from .notebook import ROWS, some_rows, table
from .told import say_of
from .units import System, column_name, file_unit
from .variables import STATE, STATE_UNITS
from .words import for_json

__all__ = [
    "contacts_frame",
    "contacts_html",
    "event_columns",
    "event_numbers",
    "events_frame",
    "events_table",
    "scene_of",
    "shots_dataset",
    "shots_frame",
    "shots_html",
]

_ERRORS = {"position_error": "m", "velocity_error": "m/s", "spin_error": "rad/s"}

UNITS: Mapping[str, str] = {
    "time": "s",
    "time_error": "s",
    "grip_lost": "s",
    **STATE_UNITS,
    **_ERRORS,
}
"""Of the columns that have one."""


class Shots(Protocol):
    """What is read of `hoopgen.Shots`, which stands on this file; and its fields, by name."""

    parameters: Mapping[str, Any]
    scene: Any

    @property
    def surfaces(self) -> tuple[str, ...]: ...

    @property
    def events(self) -> NDArray[Any]: ...

    def __len__(self) -> int: ...


class Trajectory(Protocol):
    """What is read of `hoopgen.Trajectory`."""

    @property
    def scene(self) -> Any: ...

    @property
    def release(self) -> NDArray[np.float64]: ...

    @property
    def events(self) -> NDArray[Any]: ...


def _named(name: str, unit: str = "") -> str:
    return column_name(name, unit or UNITS.get(name, ""))


def _outcomes(shots: Shots) -> list[str]:
    return [outcome.name.lower() for outcome in shots.scene.outcomes]


def scene_of(shots: Shots) -> str:
    """Say the scene of shots."""
    return say_of(shots.scene, shots.parameters)


def _columns(shots: Shots, rows: Any = slice(None)) -> dict[str, NDArray[Any]]:
    """Return the results that there are, a column each; outcome and first surface as codes."""
    columns: dict[str, NDArray[Any]] = {}
    for name, split in _parts(shots).items():
        if hasattr(shots, name):
            part = getattr(shots, name)[rows]
            columns |= dict(zip(split, part.T if part.ndim > 1 else [part], strict=True))
    return columns


def _parts(shots: Shots) -> dict[str, tuple[str, ...]]:
    """Return the columns of each field of `Shots`, in their order."""
    return {
        "outcome": ("outcome",),
        "contacts": ("contacts",),
        "counts": tuple(f"{name}_contacts" for name in shots.surfaces),
        "first": ("first",),
        "time": ("time",),
        "state": STATE,
        "rolls": ("rolls",),
        "slip_left": ("slip_left",),
        "uncertain": ("uncertain",),
        "time_error": ("time_error",),
        "state_error": tuple(_ERRORS),
        "grip_lost": ("grip_lost",),
    }


def shots_frame(shots: Shots) -> Any:
    """Return what `Shots.to_pandas` does."""
    pd = need("pandas", "to_pandas")
    columns: dict[str, Any] = dict(_columns(shots))
    for name, words in (("outcome", _outcomes(shots)), ("first", list(shots.surfaces))):
        if name in columns:
            columns[name] = pd.Categorical.from_codes(columns[name], words)
    columns = {_named(name): column for name, column in columns.items()}
    frame = pd.DataFrame(columns, pd.RangeIndex(len(shots), name="shot"))
    frame.attrs["scene"] = scene_of(shots)
    return frame


def shots_dataset(shots: Shots) -> Any:
    """Return what `Shots.to_xarray` does."""
    xr = need("xarray", "to_xarray")
    data, coordinates = {}, {"shot": np.arange(len(shots))}
    second = {
        "counts": ("surface", list(shots.surfaces)),
        "state": ("component", list(STATE)),
        "state_error": ("part", [name.removesuffix("_error") for name in _ERRORS]),
    }
    flags = {"outcome": (0, _outcomes(shots)), "first": (-1, ["none", *shots.surfaces])}
    for name in filter(partial(hasattr, shots), _parts(shots)):
        dimensions = ["shot"]
        if name in second:
            dimensions.append(second[name][0])
            coordinates[second[name][0]] = np.array(second[name][1])
        told: dict[str, Any] = {"units": UNITS[name]} if name in UNITS else {}
        if name in flags:
            low, words = flags[name]
            codes = np.arange(low, low + len(words), dtype=getattr(shots, name).dtype)
            told = {"flag_values": codes, "flag_meanings": " ".join(words)}
        data[name] = (dimensions, getattr(shots, name), told)
    dataset = xr.Dataset(data, coordinates)
    if "state" in data:
        dataset = dataset.assign_coords(unit=("component", list(STATE_UNITS.values())))
    alike = {name: float(v) for name, v in shots.parameters.items() if np.ndim(v) == 0}
    dataset.attrs["scene"] = scene_of(shots)
    dataset.attrs["parameters"] = json.dumps(for_json(alike))
    apart = {name: ("shot", v) for name, v in shots.parameters.items() if np.ndim(v)}
    return dataset.assign_coords(apart)


def shots_html(shots: Shots) -> str:
    """Return a table of the first and the last shots."""
    rows = some_rows(len(shots))
    columns: dict[str, list[Any]] = {
        name: column.tolist() for name, column in _columns(shots, np.array(rows, np.intp)).items()
    }
    for name, words in (("outcome", _outcomes(shots)), ("first", shots.surfaces)):
        if name in columns:
            columns[name] = [words[code] if code >= 0 else "" for code in columns[name]]
    head = ["shot", *(_headed(name) for name in columns)]
    about = repr(shots).removeprefix("Shots(").removesuffix(")")
    gap = ROWS // 2 if len(rows) < len(shots) else None
    return table(about, head, zip(rows, *columns.values(), strict=True), gap=gap)


def event_columns(
    events: NDArray[Any], scene: Any, units: System = "si"
) -> dict[str, NDArray[Any] | tuple[NDArray[Any], list[str]]]:
    """Return an event log as columns, with units in their names.

    Time, kind, surface, position, and velocity and spin before and after.

    Parameters
    ----------
    events
        (n,), as of `hoopgen.Shots.events`.
    scene
        In which the shots are.
    units
        "si" or "us"; see `hoopgen.units.file_unit`.

    Returns
    -------
    dict
        (n,) each; of kind and surface codes, and the words that they stand for.
    """
    numbers = {"time": ("s", events["time"])}
    numbers |= {one: (UNITS[one], events["before"][:, k]) for k, one in enumerate(STATE[:3])}
    for name in ("before", "after"):
        moving = enumerate(STATE[3:], 3)
        numbers |= {f"{name}_{one}": (UNITS[one], events[name][:, k]) for k, one in moving}
    columns: dict[str, Any] = {}
    for name, (si, column) in numbers.items():
        unit, size = file_unit(si, units)
        columns[column_name(name, unit)] = column / size if size != 1.0 else column.copy()
        if name == "time":
            columns["kind"] = events["kind"], [one.name.lower() for one in Event]
            columns["surface"] = events["surface"], [*scene.surfaces, "end"]
    return columns


def _events_frame(events: NDArray[Any], scene: Any) -> dict[str, Any]:
    """Return an event log as columns for pandas."""
    pd = need("pandas", "to_pandas")
    return {
        name: pd.Categorical.from_codes(*column) if isinstance(column, tuple) else column
        for name, column in event_columns(events, scene).items()
    }


def contacts_frame(trajectory: Trajectory) -> Any:
    """Return what `Trajectory.to_pandas` does."""
    pd = need("pandas", "to_pandas")
    columns = _events_frame(trajectory.events, trajectory.scene)
    index = pd.RangeIndex(1, len(trajectory.events) + 1, name="event")
    return pd.DataFrame(columns, index)


def events_frame(shots: Shots) -> Any:
    """Return what `Shots.events_to_pandas` does."""
    pd = need("pandas", "events_to_pandas")
    events: NDArray[Any] = shots.events
    index = pd.MultiIndex.from_arrays([events["shot"], event_numbers(events)])
    return pd.DataFrame(_events_frame(events, shots.scene), index.set_names(["shot", "event"]))


def events_table(shots: Shots) -> Any:
    """Return what `Shots.events_to_arrow` does."""
    pa = need("pyarrow", "events_to_arrow")
    events: NDArray[Any] = shots.events
    columns = {"shot": events["shot"], "event": event_numbers(events)}
    columns |= {
        name: pa.DictionaryArray.from_arrays(*column) if isinstance(column, tuple) else column
        for name, column in event_columns(events, shots.scene).items()
    }
    return pa.table(columns).replace_schema_metadata({"scene": scene_of(shots)})


def event_numbers(events: NDArray[Any]) -> NDArray[np.int64]:
    """Return the number of each event among those of its shot, from 1."""
    rows = np.arange(len(events))
    return rows - np.searchsorted(events["shot"], events["shot"]) + 1


def contacts_html(trajectory: Trajectory) -> str:
    """Return a table of the events."""
    surfaces = trajectory.scene.surfaces
    rows = [("", "release", 0.0, *trajectory.release[:3].tolist(), "", _speed(trajectory.release))]
    for number, event in numbered(trajectory.events):
        where = event["before"][:3].tolist()
        speeds = _speed(event["before"]), _speed(event["after"])
        rows.append(
            (number or "", event_words(event, surfaces), float(event["time"]), *where, *speeds)
        )
    head = ["", "event", "time (s)", "x (m)", "y (m)", "z (m)"]
    head += ["speed before (m/s)", "speed after (m/s)"]
    return table(repr(trajectory).partition("(")[2].removesuffix(")"), head, rows)


def _speed(state: NDArray[np.float64]) -> float:
    return float(np.linalg.norm(state[3:6]))


def _headed(name: str) -> str:
    return f"{name} ({UNITS[name]})" if name in UNITS else name.replace("_contacts", "")
