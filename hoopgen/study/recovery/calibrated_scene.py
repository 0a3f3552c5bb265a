"""Calibrated parameters of a scene: their likeliest values, and the intervals."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.plotting import plotting_module
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.report.provenance import describe_scene
from hoopgen.report.quantities import quantity
from hoopgen.simulation.hoop import HOOP
from hoopgen.study.result import Result
from hoopgen.text.numbers import format_count, format_percent
from hoopgen.text.shorten import join_names
from hoopgen.text.tables import table as text_table

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Calibrated:
    """A parameter and its interval.

    Attributes
    ----------
    value
        Where the likelihood is largest.
    low, high
        Ends of the interval; those of the grid where the likelihood does not bound it.
    bounded
        Whether the likelihood bounds it from below, and from above.
    grid, profile
        Values, and the largest log-likelihood over the other parameters less the maximum.
    """

    value: float
    low: float
    high: float
    bounded: tuple[bool, bool]
    grid: Floats
    profile: Floats

    @property
    def identified(self) -> bool:
        """True if the shots bound the parameter on a side, so that they say something of it."""
        return any(self.bounded)


_USED = {
    "made": "outcomes",
    "contacts": "contacts",
    "first": "first bodies touched",
    "rebound": "rebounds",
}


@dataclass(frozen=True, repr=False)
class CalibratedScene(Result):
    """Parameters of a scene that make the ends of measured shots likeliest.

    Attributes
    ----------
    values
        By name.
    parameters
        All parameters of the scene, with the likeliest values.
    log_likelihood
        The maximum.
    noise
        Standard error of the log-likelihood from the number of draws, by halves; the intervals
        are widened by twice that.
    shots, draws
        Shots, and draws of each.
    used
        What was seen of the shots: "made", and "contacts", "first" and "rebound" where known.
    confidence
        Of the intervals.
    scene
        In which the shots were simulated.
    """

    values: Mapping[str, Calibrated]
    parameters: Mapping[str, Any]
    log_likelihood: float
    noise: float
    shots: int
    draws: int
    used: tuple[str, ...]
    confidence: float
    scene: CompiledScene = field(default=HOOP, compare=False)

    @property
    def scene_words(self) -> str:
        """The scene in words, with the parameters that are held and not found."""
        held = {name: one for name, one in self.parameters.items() if name not in self.values}
        by_row = [name for name in self.scene.table.defaults if name not in self.parameters]
        return describe_scene(self.scene, held, by_row)

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows."""
        return {
            "values": {
                name: {
                    "value": one.value,
                    "low": one.low,
                    "high": one.high,
                    "bounded": list(one.bounded),
                    "grid": one.grid.tolist(),
                    "profile": one.profile.tolist(),
                }
                for name, one in self.values.items()
            },
            "log_likelihood": self.log_likelihood,
            "noise": self.noise,
            "shots": self.shots,
            "draws": self.draws,
            "used": list(self.used),
            "confidence": self.confidence,
            "scene": self.scene_words,
            "parameters": dict(self.parameters),
        }

    def plot(self, *, ax: Drawn | None = None, title: str = "") -> Drawn:
        """Draw the profiles of the likelihood; as of `hoopgen.plots.plot_likelihood`.

        Parameters
        ----------
        ax
            The axes to draw on; None makes a figure.
        title
            The title; empty for the usual one.
        """
        drawn: Drawn = plotting_module().plot_likelihood(self, ax=ax, title=title)
        return drawn

    def __str__(self) -> str:
        level = format_percent(self.confidence, None)
        rows = []
        for name, one in self.values.items():
            shown = quantity(name)
            value, low, high = (f"{v / shown.size:.3g}" for v in (one.value, one.low, one.high))
            ends = "".join(
                [
                    "" if one.bounded[0] else "below ",
                    f"{low} to {high}",
                    "" if one.bounded[1] else " and above",
                ]
            )
            unit = f" ({shown.unit})" if shown.unit else ""
            rows.append([f"{name}{unit}", value if one.identified else "not identified", ends])
        what = join_names([_USED[name] for name in self.used])
        lines = [
            text_table(["parameter", "likeliest", f"{level} interval"], rows, right=[1]),
            "",
            f"log-likelihood {self.log_likelihood:.2f} ± {self.noise:.2f} of the {what} of "
            f"{format_count(self.shots, 'shot')}, {self.draws:,} draws of each",
        ]
        if self.noise > 0.5:
            lines.append("the draws are too few for narrow intervals: give more")
        lines.append(f"scene {self.scene_words}; {join_names(self.values)} varied")
        return "\n".join(lines)
