"""Bars of an estimate: the share of each outcome and kind, with its interval."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.colours import outcome_colours
from hoopgen.report.provenance import describe_setting, sentences
from hoopgen.report.quantities import STILL
from hoopgen.text.numbers import (
    format_count,
    format_interval,
    format_percent,
    format_points,
    percent_decimals,
)

from .figure import add_title, draw_picture
from .page import add_axes, new_page
from .style import (
    DARK,
    EDGES,
    GRID,
    INK,
    MADE,
    MISSED,
    NARROW_PAGE,
    NOTE_SIZE,
    OTHER_OUTCOME_COLOURS,
    PAGE,
    Inches,
)
from .ticks import number

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn
    from hoopgen.study.questions.compare import Comparison
    from hoopgen.study.questions.estimate_result import Estimate
    from hoopgen.study.questions.solve import Solution
    from hoopgen.study.statistics.outcome_shares import Shares

# Inches.
_LEFT, _RIGHT, _GAP, _ROW, _BELOW, _ABOVE = 1.05, 0.15, 0.12, 0.27, 0.44, 0.3
_LABEL_WIDTH, _EXTRA_LABEL_WIDTH = 0.66, 1.6  # beside the bars, and more where there is room

_BAR_HEIGHT = 0.62  # of a row
_PLAIN_COLOUR = "#E2E2E2"


@check_arguments
def plot_estimate(
    found: Estimate | Shares | Comparison | Solution,
    *,
    title: str = "",
    note: str | None = None,
    width: Inches = PAGE,
    ax: Drawn | None = None,
) -> Drawn:
    """Draw how shots end: the share of each outcome and, at a hoop, of what they touched.

    A line across the end of a bar is the interval of its share. Of a comparison both settings are
    drawn, and the difference.

    Parameters
    ----------
    found
        Of `hoopgen.estimate`, `compare` or `solve`, of which the estimate is drawn.
    title
        Above the picture; of `solve` by default the factor.
    note
        Below the title; by default how many shots there are and what they rest on.
    width
        Of the page, inches, as of `plot_fan`.
    ax
        To draw on, the outcomes alone; of a comparison, both settings.

    Returns
    -------
    Figure or Axes
        A page of its own, or `ax`; as of `plot_fan`.

    Raises
    ------
    TypeError
        If `ax` is not axes, or `found` is another result.
    """
    result: Any = found
    if hasattr(result, "factor"):
        title, result = title or result.line, result.estimate
    groups = _groups(result)
    description = _default_note(result) if note is None else note
    return draw_picture(
        ax,
        lambda: _page(groups, title, description, width),
        lambda axes: _draw_on(axes, groups[0], title, description),
    )


@dataclass(frozen=True)
class _Bar:
    """A bar: the share's name, its parts, its interval, and the texts beside it."""

    name: str
    parts: Sequence[tuple[float, str]]
    low: float
    high: float
    said: str
    more: str


@dataclass(frozen=True)
class _Group:
    """A group of bars with one scale; differences are in percentage points."""

    head: str
    label: str
    bars: Sequence[_Bar]
    signed: bool = False


def _groups(found: Any) -> list[_Group]:
    if hasattr(found, "only_first"):
        return _comparison_groups(found)
    if hasattr(found, "kinds"):
        return [_Group("how they end", "shots (%)", _outcome_bars(found)), _kind_bars(found)]
    if hasattr(found, "share_of"):
        return [_Group("how they end", "shots (%)", _end_bars(found))]
    raise TypeError(f"found: expected what estimate or compare return, got {type(found).__name__}")


def _outcome_bars(found: Estimate) -> list[_Bar]:
    """Return the bars of the outcomes; the bar of made shots consists of their kinds."""
    valid = found.shots - found.invalid
    digits = percent_decimals(found.half_width)
    bars = []
    for name in ("made", "missed", *(one for one in OTHER_OUTCOME_COLOURS if one != "invalid")):
        count = getattr(found, name)
        if not (count or name in ("made", "missed")):
            continue
        share = count / valid if valid else 0.0
        low, high = found.ends_of(name) if valid else (0.0, 1.0)
        parts = [(share, OTHER_OUTCOME_COLOURS.get(name, _PLAIN_COLOUR))]
        if name == "made":
            parts = [(n / valid, MADE[kind]) for kind, n in found.kinds_made.items() if n]
        ends = "" if found.still else f"({format_interval(low, high, digits)})"
        said = format_percent(share, digits), ends
        bars.append(_Bar(name, parts, low, high, *said))
    return bars


def _kind_bars(found: Estimate) -> _Group:
    """Return the bars of the kinds, made and missed."""
    from hoopgen.study.statistics.intervals import wilson_interval

    bars = []
    for kind, count in found.kinds.items():
        if not count or kind == "none":
            continue
        made = found.kinds_made[kind]
        share = count / found.shots
        low, high = map(float, wilson_interval(count, found.shots, found.confidence))
        low, high = (share, share) if found.still else (low, high)
        parts = [(made / found.shots, MADE.get(kind, _PLAIN_COLOUR))]
        parts += [((count - made) / found.shots, MISSED.get(kind, _PLAIN_COLOUR))]
        said = format_percent(count / found.shots), f"{format_percent(made / count)} of it made"
        bars.append(_Bar(kind.replace("_", ", "), parts, low, high, *said))
    return _Group("what they touch: dark are made, pale are not", "shots (%)", bars)


def _end_bars(found: Shares) -> list[_Bar]:
    """Return the bars of the ends of a user's scene, and of its other outcomes."""
    ends = found.scene.kernels.ENDS
    inks = outcome_colours((name.upper() for name in found.shares), len(ends))
    digits = percent_decimals(found.half_width)
    return [
        _Bar(
            name,
            [(share if np.isfinite(share) else 0.0, inks[name.upper()])],
            found.low[name],
            found.high[name],
            format_percent(share, digits),
            ""
            if found.still
            else f"({format_interval(found.low[name], found.high[name], digits)})",
        )
        for name, share in found.shares.items()
        if name in ends or found.counts[name]
    ]


def _comparison_groups(found: Comparison) -> list[_Group]:
    """Return the groups of both settings and of their differences."""
    digits = percent_decimals(found.half_width)
    settings = {"first": found.first, "second": found.second}
    bars = [
        replace(next(bar for bar in _groups(one)[0].bars if bar.name == found.by), name=name)
        for name, one in settings.items()
    ]
    shown = [format_points(one, digits) for one in (found.low, found.high)]
    said = format_points(found.difference, digits), f"({' to '.join(shown)})"
    more = _Bar("difference", [(found.difference, _PLAIN_COLOUR)], found.low, found.high, *said)
    return [
        _Group(f"{found.by}, of each setting", "shots (%)", bars),
        _Group("the second less the first, of pairs", "points", [more], signed=True),
    ]


def _describe_sample_interval(found: Any) -> str:
    """Describe the lines of the intervals and, of measured releases, the sample's interval."""
    sample = found.sample
    if not sample:
        return ""
    said = " of the simulation alone"
    if hasattr(found, "only_first"):
        ends = format_points(sample.low), format_points(sample.high)
        said += f"; the sample's of the difference is {' to '.join(ends)} points"
    elif hasattr(found, "kinds"):
        said += f"; the sample's of those made is {format_interval(sample.low, sample.high)}"
    return said


def _default_note(found: Any) -> str:
    first = getattr(found, "first", found)
    description = describe_setting(first.setting, first.scene) | {"seed": str(first.seed)}
    if first is not found:
        other = describe_setting(found.second.setting, found.second.scene)
        apart = [n for n in other if other[n] != description.get(n)]
        description |= {n: f"{description.get(n, 'none')}; second {other[n]}" for n in apart}
    invalid = getattr(first, "invalid", 0) or getattr(first, "counts", {}).get("invalid", 0)
    left = f", of them {invalid:,} invalid, which are no trials" if invalid else ""
    level = format_percent(found.confidence, None)
    ends = f"lines are {level} intervals{_describe_sample_interval(found)}"
    if found.still:
        ends = STILL
    lines = f"{format_count(first.shots, 'shot')}{left}; {ends}."
    return f"{lines} {sentences(description, scene=True)}"


# --------------------------------------------------------------------------------------- drawing


def _draw_on(axes: Axes, group: _Group, title: str, note: str) -> None:
    """Draw a group on given axes."""
    _draw(axes, group)
    add_title(axes, title, note)


def _page(groups: Sequence[_Group], title: str, note: str, width: float) -> Figure:
    """Draw the groups one above the other, with one scale of shares."""
    rows = [len(group.bars) * _ROW for group in groups]
    body = sum(rows) + len(groups) * (_ABOVE + _BELOW)
    figure = new_page(width, body, title=title, note=note)
    more = _EXTRA_LABEL_WIDTH if width >= NARROW_PAGE else 0.0
    across = width - _LEFT - _GAP - _LABEL_WIDTH - more - _RIGHT
    bottom = body
    most = max(bar.high for group in groups if not group.signed for bar in group.bars)
    for group, tall in zip(groups, rows, strict=True):
        bottom -= _ABOVE + tall
        axes = add_axes(figure, _LEFT, bottom, across, tall, group.head)
        _draw(axes, group, None if group.signed else _round(most))
        axes.set_title(group.head, loc="left", fontsize=NOTE_SIZE, color=INK)
        for row, bar in enumerate(group.bars):
            for text, left in ((bar.said, 0.0), (bar.more if more else "", _LABEL_WIDTH)):
                at = (1.0 + (_GAP + left) / across, row)
                where = axes.get_yaxis_transform()
                axes.text(*at, text, transform=where, va="center_baseline", fontsize=NOTE_SIZE)
        bottom -= _BELOW
    return figure


def _round(share: float) -> float:
    """Return the next tenth above a share, so that its interval ends inside."""
    return min(1.0, float(np.floor(share * 10.0 + 1.0)) / 10.0)


def _draw(axes: Axes, group: _Group, most: float | None = None) -> None:
    """Draw bars, the first at the top."""
    for row, bar in enumerate(group.bars):
        start = 0.0
        for share, colour in bar.parts:
            axes.barh(row, share, _BAR_HEIGHT, start, color=colour, ec=EDGES, lw=0.4, zorder=2.0)
            start += share
        axes.plot([bar.low, bar.high], [row, row], color=DARK, lw=1.2, zorder=3.0)
        axes.plot(
            [bar.low, bar.high], [row, row], ls="none", marker="|", ms=7.0, color=DARK, zorder=3.0
        )
    axes.set_yticks(range(len(group.bars)), [bar.name for bar in group.bars])
    axes.tick_params(axis="y", length=0.0)
    axes.set_ylim(len(group.bars) - 0.5, -0.5)
    axes.set_xlabel(group.label)
    axes.xaxis.set_major_locator(MaxNLocator(nbins=6, steps=[1, 2, 5, 10]))
    axes.xaxis.set_major_formatter(lambda share, _: number(100.0 * share))
    if group.signed:
        reach = 1.15 * max(abs(end) for bar in group.bars for end in (bar.low, bar.high))
        axes.axvline(0.0, color=DARK, lw=0.8, zorder=4.0)
        axes.set_xlim(-reach, reach)
    else:
        axes.set_xlim(0.0, most or _round(max(bar.high for bar in group.bars)))
    axes.grid(axis="x", color=GRID, lw=0.5)
    axes.set_axisbelow(True)
