"""Options of the pictures of results, as their methods `plot` take them."""

from __future__ import annotations

from enum import IntEnum
from typing import TYPE_CHECKING, TypedDict

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from typing_extensions import TypeVar

    Drawn = TypeVar("Drawn", Figure, Axes, default=Figure)
    """A picture: the axes that are given; without any, a page of its own."""


class EstimateOptions(TypedDict, total=False):
    """Keywords of `hoopgen.plots.plot_estimate`, but for the axes."""

    title: str
    note: str | None
    width: float


class FanOptions(TypedDict, total=False):
    """Keywords of `hoopgen.plots.plot_fan`, but for the axes."""

    paths: int
    by: str
    title: str
    note: str
    width: float


class CounterfactualOptions(TypedDict, total=False):
    """Keywords of `hoopgen.plots.plot_counterfactual`, but for the axes."""

    title: str
    width: float


class TrajectoryOptions(TypedDict, total=False):
    """Keywords of `hoopgen.plots.plot_trajectory`, but for the axes."""

    outcome: IntEnum | None
    title: str
    three_d: bool | None
