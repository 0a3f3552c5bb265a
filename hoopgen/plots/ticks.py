"""Axes of lengths: drawings are in metres, ticks and labels in display units."""

from __future__ import annotations

from typing import Literal

from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, MaxNLocator

from hoopgen.core.units import display_unit


def label_lengths(axes: Axes, labels: tuple[str, str]) -> None:
    """Label axes whose data are metres in the display unit, and set their ticks.

    Parameters
    ----------
    axes
        The axes.
    labels
        The names of both axes.
    """
    unit = display_unit("length")
    axes.set_xlabel(f"{labels[0]} ({unit.symbol})")
    axes.set_ylabel(f"{labels[1]} ({unit.symbol})")
    if unit.size != 1.0:
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(_Steps(unit.size))
            axis.set_major_formatter(FuncFormatter(lambda value, _: number(value / unit.size)))


def few_ticks(axes: Axes) -> None:
    """Reduce the ticks of small axes whose data are metres."""
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(_Steps(display_unit("length").size, 5))


def number(value: float) -> str:
    """Format the number of a tick; never -0."""
    return f"{round(value, 6) + 0.0:g}".replace("-", "\N{MINUS SIGN}")


class _Steps(MaxNLocator):
    """A locator of ticks at round numbers of a unit, on an axis in metres."""

    def __init__(self, size: float, most: int | Literal["auto"] = "auto") -> None:
        super().__init__(nbins=most, steps=[1, 2, 5, 10])
        self._size = size

    def tick_values(self, vmin: float, vmax: float) -> list[float]:
        ticks = super().tick_values(vmin / self._size, vmax / self._size)
        return [tick * self._size for tick in ticks]
