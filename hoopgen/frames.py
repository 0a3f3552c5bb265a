"""Results and events as tables: of pandas, of xarray, and of a notebook.

By field of `hoopgen.results.Shots`, which stands on this file.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.generated.numpy.hoop import BODIES, Outcome

from .installed import need
from .notebook import ROWS, some_rows, table
from .told import say_scene
from .units import column_name
from .variables import STATE, STATE_UNITS

__all__ = ["contacts_frame", "contacts_html", "shots_dataset", "shots_frame", "shots_html"]

Fields = Mapping[str, NDArray[Any]]
"""By name: those that were asked for."""

_ERRORS = {"position_error": "m", "velocity_error": "m/s", "spin_error": "rad/s"}

UNITS: Mapping[str, str] = {"time": "s", "time_error": "s", **STATE_UNITS, **_ERRORS}
"""Of the columns that have one."""


def _named(name: str, unit: str = "") -> str:
    return column_name(name, unit or UNITS.get(name, ""))


_OUTCOMES = [outcome.name.lower() for outcome in Outcome]
_END = (*BODIES, "end")


def _columns(fields: Fields, rows: Any = slice(None)) -> dict[str, NDArray[Any]]:
    """Return the results that there are, a column each; outcome and first surface as codes."""
    columns: dict[str, NDArray[Any]] = {}
    for name, split in _PARTS.items():
        if name in fields:
            part = fields[name][rows]
            columns |= dict(zip(split, part.T if part.ndim > 1 else [part], strict=True))
    return columns


_PARTS: Mapping[str, tuple[str, ...]] = {
    "outcome": ("outcome",),
    "contacts": ("contacts",),
    "counts": tuple(f"{name}_contacts" for name in BODIES),
    "first": ("first",),
    "time": ("time",),
    "state": STATE,
    "uncertain": ("uncertain",),
    "time_error": ("time_error",),
    "state_error": tuple(_ERRORS),
}
"""By field of `Shots`: its columns, in their order."""


def shots_frame(fields: Fields, parameters: Mapping[str, Any], count: int) -> Any:
    """Return what `Shots.to_pandas` does."""
    pd = need("pandas", "to_pandas")
    columns: dict[str, Any] = dict(_columns(fields))
    for name, words in (("outcome", _OUTCOMES), ("first", list(BODIES))):
        if name in columns:
            columns[name] = pd.Categorical.from_codes(columns[name], words)
    columns = {_named(name): column for name, column in columns.items()}
    frame = pd.DataFrame(columns, pd.RangeIndex(count, name="shot"))
    frame.attrs["scene"] = say_scene(parameters)
    return frame


def shots_dataset(fields: Fields, parameters: Mapping[str, Any], count: int) -> Any:
    """Return what `Shots.to_xarray` does."""
    xr = need("xarray", "to_xarray")
    data, coordinates = {}, {"shot": np.arange(count)}
    second = {
        "counts": ("surface", list(BODIES)),
        "state": ("component", list(STATE)),
        "state_error": ("part", [name.removesuffix("_error") for name in _ERRORS]),
    }
    flags = {"outcome": (0, _OUTCOMES), "first": (-1, ["none", *BODIES])}
    for name in filter(fields.__contains__, _PARTS):
        dimensions = ["shot"]
        if name in second:
            dimensions.append(second[name][0])
            coordinates[second[name][0]] = np.array(second[name][1])
        told: dict[str, Any] = {"units": UNITS[name]} if name in UNITS else {}
        if name in flags:
            low, words = flags[name]
            codes = np.arange(low, low + len(words), dtype=fields[name].dtype)
            told = {"flag_values": codes, "flag_meanings": " ".join(words)}
        data[name] = (dimensions, fields[name], told)
    dataset = xr.Dataset(data, coordinates)
    if "state" in data:
        dataset = dataset.assign_coords(unit=("component", list(STATE_UNITS.values())))
    alike = {name: value for name, value in parameters.items() if np.ndim(value) == 0}
    dataset.attrs["scene"] = say_scene(parameters)
    dataset.attrs["parameters"] = json.dumps(alike)
    apart = {name: ("shot", v) for name, v in parameters.items() if np.ndim(v)}
    return dataset.assign_coords(apart)


def shots_html(about: str, fields: Fields, count: int) -> str:
    """Return a table of the first and the last shots, below a line about them."""
    rows = some_rows(count)
    columns: dict[str, list[Any]] = {
        name: column.tolist() for name, column in _columns(fields, np.array(rows, np.intp)).items()
    }
    for name, words in (("outcome", _OUTCOMES), ("first", BODIES)):
        if name in columns:
            columns[name] = [words[code] if code >= 0 else "" for code in columns[name]]
    head = ["shot", *(_headed(name) for name in columns)]
    gap = ROWS // 2 if len(rows) < count else None
    return table(about, head, zip(rows, *columns.values(), strict=True), gap=gap)


def contacts_frame(events: NDArray[Any]) -> Any:
    """Return what `Trajectory.to_pandas` does."""
    pd = need("pandas", "to_pandas")
    words = pd.Categorical.from_codes(events["surface"], list(_END))
    columns = {_named("time"): events["time"], "surface": words}
    columns |= dict(zip(map(_named, STATE[:3]), events["before"].T, strict=False))
    for name in ("before", "after"):
        columns |= {
            _named(f"{name}_{one}", UNITS[one]): events[name][:, k]
            for k, one in enumerate(STATE)
            if k > 2
        }
    return pd.DataFrame(columns, pd.RangeIndex(1, len(events) + 1, name="event"))


def contacts_html(about: str, release: NDArray[np.float64], events: NDArray[Any]) -> str:
    """Return a table of the release and the events, below a line about them."""
    rows = [("", "release", 0.0, *release[:3].tolist(), "", _speed(release))]
    for number, event in enumerate(events, 1):
        where = event["before"][:3].tolist()
        speeds = _speed(event["before"]), _speed(event["after"])
        rows.append((number, _END[event["surface"]], float(event["time"]), *where, *speeds))
    head = ["", "event", "time (s)", "x (m)", "y (m)", "z (m)"]
    head += ["speed before (m/s)", "speed after (m/s)"]
    return table(about, head, rows)


def _speed(state: NDArray[np.float64]) -> float:
    return float(np.linalg.norm(state[3:6]))


def _headed(name: str) -> str:
    return f"{name} ({UNITS[name]})" if name in UNITS else name.replace("_contacts", "")
