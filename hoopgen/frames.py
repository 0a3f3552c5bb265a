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
from .units import column_name
from .variables import STATE, STATE_UNITS
from .words import for_json

__all__ = [
    "contacts_frame",
    "contacts_html",
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


def contacts_frame(trajectory: Trajectory) -> Any:
    """Return what `Trajectory.to_pandas` does."""
    pd = need("pandas", "to_pandas")
    events = trajectory.events
    words = pd.Categorical.from_codes(events["surface"], [*trajectory.scene.surfaces, "end"])
    kinds = pd.Categorical.from_codes(events["kind"], [one.name.lower() for one in Event])
    columns = {_named("time"): events["time"], "kind": kinds, "surface": words}
    columns |= dict(zip(map(_named, STATE[:3]), events["before"].T, strict=False))
    for name in ("before", "after"):
        columns |= {
            _named(f"{name}_{one}", UNITS[one]): events[name][:, k]
            for k, one in enumerate(STATE)
            if k > 2
        }
    return pd.DataFrame(columns, pd.RangeIndex(1, len(events) + 1, name="event"))


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
