"""Shots a second as bars, a panel a workload."""

import json
from collections.abc import Mapping

from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import LogLocator, NullLocator

from benchmarks.contenders import contenders
from benchmarks.report import power, short
from benchmarks.timing import Rates
from benchmarks.workloads import WORKLOADS
from hoopgen.plots.style import style

# Okabe and Ito's palette, told apart by lightness too.
FAMILIES = {"hoopgen": "#0072B2", "peer in C": "#E69F00", "peer in Python": "#999999"}


def read(text: str) -> dict[str, dict[str, Rates]]:
    """Return the rates of benchmarks.json, by workload and contender."""
    return {
        workload: {key: Rates(one["shots"], tuple(one["rates"])) for key, one in own.items()}
        for workload, own in json.loads(text)["rates"].items()
    }


def draw(rates: Mapping[str, Mapping[str, Rates]]) -> Figure:
    """One row of panels, logarithmic, every bar with its median and its quartiles as a whisker."""
    field = [one for one in contenders() if not one.key.endswith("_all")]
    rows = range(len(field))
    with style():
        figure = Figure(figsize=(11.0, 0.32 * len(field) + 1.3), layout="constrained")
        panels = figure.subplots(1, len(WORKLOADS), sharex=True, sharey=True)
        for panel, workload in zip(panels, WORKLOADS, strict=True):
            spreads = [rates[workload.key][one.key].spread for one in field]
            medians = [spread.median for spread in spreads]
            whiskers = [
                [spread.median - spread.lower for spread in spreads],
                [spread.upper - spread.median for spread in spreads],
            ]
            colours = [FAMILIES[one.family] for one in field]
            panel.barh(rows, medians, xerr=whiskers, color=colours, error_kw={"lw": 0.8})
            for row, spread in zip(rows, spreads, strict=True):
                panel.text(1.3 * spread.upper, row, short(spread.median), va="center", fontsize=7)
            panel.set_xscale("log")
            panel.xaxis.set_major_locator(LogLocator(numticks=5))
            panel.xaxis.set_major_formatter(lambda value, _: power(value))
            panel.xaxis.set_minor_locator(NullLocator())
            panel.set_title(f"{workload.key} {workload.label}", fontsize=9)
            panel.grid(axis="x", color="#DDDDDD", linewidth=0.5)
            panel.set_axisbelow(True)
            panel.tick_params(axis="y", length=0)
            panel.spines[["top", "right"]].set_visible(False)
        everything = [rate.spread for of in rates.values() for rate in of.values()]
        fastest = max(spread.upper for spread in everything)
        slowest = min(spread.lower for spread in everything)
        panels[0].set_xlim(slowest / 3, 20 * fastest)
        panels[0].set_yticks(rows, [one.label.replace("`", "") for one in field])
        panels[0].invert_yaxis()
        figure.supxlabel("shots a second", fontsize=8.5)
        keys = [Patch(color=colour, label=family) for family, colour in FAMILIES.items()]
        figure.legend(handles=keys, loc="outside upper right", ncols=3, frameon=False, fontsize=8)
    return figure
