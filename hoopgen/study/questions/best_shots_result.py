"""The best shots of `best_shots` in words: what the numbers are, and how certain."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import numpy as np

from hoopgen.core.units import DEGREE, display_system, display_unit
from hoopgen.report.quantities import format_variable
from hoopgen.text.numbers import format_percent

from .coach_result import PARTS, say

if TYPE_CHECKING:
    import xarray as xr


def describe_best_shots(dataset: xr.Dataset) -> str:
    """Return a description of the numbers and their uncertainty, with that of a second search."""
    half = 50.0 * float((dataset["high"] - dataset["low"]).max())
    level = format_percent(dataset.attrs["confidence"], None)
    speed = display_unit("speed")
    moved = {
        name: float(np.nanmedian(np.abs(dataset[f"{name}_change"].values)))
        for name in ("speed", "elevation", "probability")
        if np.isfinite(dataset[f"{name}_change"].values).any()
    }
    lines = [
        f"{_player(dataset)} Scene: {dataset.attrs['scene']}. "
        f"Shares are of {dataset.attrs['shots']:,} fresh shots; "
        f"their {level} intervals are at most ±{half:.1f} points. "
        f"Seed: {dataset.attrs['seed']}."
    ]
    if moved:
        lines.append(
            "A second search changes half of the places by no more than "
            f"{moved['elevation'] / DEGREE:.1f}°, {moved['speed'] / speed.size:.2g} {speed.symbol} "
            f"and {100.0 * moved['probability']:.1f} points; the way of "
            f"{int(np.isnan(dataset['speed_change']).sum())} of {dataset.sizes['place']} changes."
        )
    if note := undecided(dataset):
        lines.append(note)
    return " ".join(lines)


def undecided(dataset: xr.Dataset) -> str:
    """Return a warning of places where the shots do not say that the way is the better one.

    It is empty if there are none.
    """
    unsure = ~dataset["decided"].values
    if not unsure.any():
        return ""
    wrong = int((dataset["lead_high"].values < 0.0).sum())
    low, high = (dataset[name].values[unsure] for name in ("lead_low", "lead_high"))
    widest = 50.0 * float((high - low).max())
    against = f", and at {wrong} of them they speak for the other" if wrong else ""
    return (
        f"At {int(unsure.sum())} of {len(unsure)} places the shots do not tell whether bank or "
        f"direct is better{against}: the lead of one over the other is known to ±{widest:.1f} "
        "points. More shots narrow this."
    )


def _player(dataset: xr.Dataset) -> str:
    """Return who throws, in the units that are shown: in US units those of players."""
    if "makes" not in dataset.attrs:
        return "The player is as measured."
    player = json.loads(dataset.attrs["player"])
    release, words = player["release"], say if display_system() == "us" else format_variable
    spread = ", ".join(f"{words(name, sd)} of {PARTS[name]}" for name, sd in player["sd"].items())
    return (
        f"A player who makes {format_percent(dataset.attrs['makes'], None)} of free throws: a "
        f"release {words('height', release['height'])} up with "
        f"{words('backspin', release['backspin'])} of backspin; the spread is {spread}, of which "
        "left or right and spin are assumed, as is that it is alike everywhere."
    )
