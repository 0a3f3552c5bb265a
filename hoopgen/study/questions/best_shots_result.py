"""The best shots of `best_shots` in words: what the numbers are, and how certain."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from hoopgen.core.units import DEGREE, display_unit
from hoopgen.text.numbers import format_percent

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
        f"{dataset.attrs['provenance']} Shares are of {dataset.attrs['shots']:,} fresh shots; "
        f"their {level} intervals are at most ±{half:.1f} points."
    ]
    if moved:
        lines.append(
            "A second search changes half of the places by no more than "
            f"{moved['elevation'] / DEGREE:.1f}°, {moved['speed'] / speed.size:.2g} {speed.symbol} "
            f"and {100.0 * moved['probability']:.1f} points; the way of "
            f"{int(np.isnan(dataset['speed_change']).sum())} of {dataset.sizes['place']} changes."
        )
    return " ".join(lines)
