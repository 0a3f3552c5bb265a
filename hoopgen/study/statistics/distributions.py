"""Distributions of measures of shots: quantiles, and of rebounds the shares by sector.

Values are counted in cells, whole numbers that add up to the same whoever counts them, so what is
said of millions of shots needs none of them to be kept. A quantile is off by less than a cell.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from math import inf
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.units import TURN, DisplayUnit, display_unit
from hoopgen.core.variables import Releases
from hoopgen.report.quantities import for_json
from hoopgen.results.shots import Shots
from hoopgen.study.measures.measures import MEASURES, measure
from hoopgen.study.measures.rebounds import SECTORS, caught_at, sector
from hoopgen.text.numbers import (
    MINUS,
    format_count,
    format_interval,
    format_percent,
    percent_decimals,
)
from hoopgen.text.tables import table

from .intervals import Ends, quantile_ranks, wilson_interval
from .sample import Rows

QUANTILES = (0.05, 0.25, 0.5, 0.75, 0.95)
"""Shares of the shots that are below."""

_AROUND = 1440
"""Cells of a turn: a multiple of twice the sectors, whose ends then are ends of cells."""

_WIDTHS: Mapping[str, float] = {"m": 0.01, "s": 0.005, "rad": TURN / _AROUND, "m/s": 0.02}
"""Width of a cell, by unit."""

CELLS = 4096
"""About 0; what lies beyond is counted at both ends: that many centimetres, for one."""

_SEEN: Mapping[str, str] = {"m": "length", "m/s": "speed", "rad": "angle"}
"""Kinds of quantities that are shown in units of one's own, by unit."""

_DECIMALS: Mapping[str, int] = {"m": 2, "s": 2, "rad": 1, "m/s": 2}

_DIRECTION = "rebound_angle"
"""The measure that is an angle, so that it has sectors."""


@dataclass(frozen=True)
class Spread:
    """The distribution of a measure over the shots that have it.

    Attributes
    ----------
    name
        Of the measure.
    shots
        Of which it was measured: no rebounds, for one, of those that are made.
    quantiles
        By share: the value below which so many are, and its interval; SI. Infinite where it lies
        beyond the cells, or the shots are too few for an end. None of no shots, and of a
        direction. The interval is that of the simulation alone.
    sectors
        Of a direction of rebounds: shots by the names of `hoopgen.study.measures.rebounds.SECTORS`.
    confidence
        Of the intervals.
    catching_height
        Of rebounds, m above the floor.
    sample
        Of measured releases: by share the interval of that quantile which contains the uncertainty
        of the sample; of a direction, by sector that of its share.
    """

    name: str
    shots: int
    quantiles: Mapping[float, tuple[float, float, float]]
    sectors: Mapping[str, int]
    confidence: float
    catching_height: float | None = None
    sample: Mapping[float | str, Ends] = field(default_factory=dict)

    @property
    def shares(self) -> dict[str, tuple[float, float, float]]:
        """Shares of the sectors, each with Wilson's interval."""
        ends = {
            name: wilson_interval(n, self.shots, self.confidence)
            for name, n in self.sectors.items()
        }
        found = self.sectors.items() if self.shots else ()
        return {n: (k / self.shots, float(ends[n][0]), float(ends[n][1])) for n, k in found}

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows."""
        ends = ("value", "low", "high")
        quantiles = {f"{p:g}": dict(zip(ends, q, strict=True)) for p, q in self.quantiles.items()}
        ends = ("share", "low", "high")
        sectors = {
            name: {"shots": self.sectors[name], **dict(zip(ends, share, strict=True))}
            for name, share in self.shares.items()
        }
        unit = MEASURES[self.name].unit
        record: dict[str, Any] = {"unit": unit, "shots": self.shots, "confidence": self.confidence}
        record |= {"quantiles": quantiles} if quantiles else {}
        record |= {"sectors": sectors} if self.sectors else {}
        record |= {"catching_height": height} if (height := self.catching_height) else {}
        sample = {
            name if isinstance(name, str) else f"{name:g}": {"low": low, "high": high}
            for name, (low, high) in self.sample.items()
        }
        record |= {"sample": sample} if sample else {}
        return {name: for_json(value) for name, value in record.items()}


# ---------------------------------------------------------------------------------------- counting


def width_of(names: Sequence[str]) -> int:
    """Return the size of the counts of measures."""
    return len(names) * (CELLS + 2)


def counts_of(
    releases: Releases, shots: Shots, names: Sequence[str], catching_height: float
) -> NDArray[np.int64]:
    """Return the number of shots in each cell of each measure, one measure after the other.

    Parameters
    ----------
    releases
        The releases of the shots, n of them.
    shots
        Their results.
    names
        The names of the measures, k of them.
    catching_height
        Where the ball's centre is when a rebound is caught, m above the floor.
    """
    columns = measure(
        releases.states, shots, releases.parameters, names, catching_height=catching_height
    )
    found = np.zeros((len(names), CELLS + 2), np.int64)
    for row, name in zip(found, names, strict=True):
        there = columns[name][~np.isnan(columns[name])] / _WIDTHS[MEASURES[name].unit]
        cells = np.clip(np.floor(there), -CELLS // 2 - 1, CELLS // 2).astype(np.int64)
        row += np.bincount(cells + CELLS // 2 + 1, minlength=CELLS + 2)
    return found.ravel()


def spreads(
    counts: NDArray[np.int64], names: Sequence[str], confidence: float, catching_height: float
) -> dict[str, Spread]:
    """Return the distributions from counts, by the name of the measure.

    Parameters
    ----------
    counts
        The numbers that `counts_of` gives, summed over shots.
    names
        The names of the measures, in that order.
    confidence
        The confidence of the intervals, from 0 to 1.
    catching_height
        Where the ball's centre is when a rebound is caught, m above the floor.
    """
    found = {}
    for name, cells in zip(names, counts.reshape(len(names), CELLS + 2), strict=True):
        total, turns = int(cells.sum()), name == _DIRECTION
        levels = QUANTILES if total and not turns else ()
        found[name] = Spread(
            name,
            total,
            {p: _quantile(cells, p, _WIDTHS[MEASURES[name].unit], confidence) for p in levels},
            _sectors(cells) if turns else {},
            confidence,
            caught_at([name], catching_height).get("catching_height"),
        )
    return found


def spreads_of_sample(found: Mapping[str, Spread], rows: Rows) -> dict[str, Spread]:
    """Return measures with the intervals that contain the uncertainty of measured releases.

    Parameters
    ----------
    found
        The distributions by the name of the measure.
    rows
        The same measures of each measured release.
    """
    return {name: replace(one, sample=_of_sample(one, rows)) for name, one in found.items()}


def _of_sample(found: Spread, rows: Rows) -> dict[float | str, Ends]:
    """Return the intervals of the sample, by quantile or by sector."""
    level, name = found.confidence, found.name
    sample: dict[float | str, Ends] = {p: rows.quantile(name, p, level) for p in found.quantiles}
    if found.sectors and found.shots:
        where = sector(rows.measured[name])
        for number, one in enumerate(SECTORS):
            share = rows.within(name, where == number, level)
            sample[one] = share.low, share.high
    return sample


def _quantile(
    cells: NDArray[np.int64], level: float, width: float, confidence: float
) -> tuple[float, float, float]:
    """Return a quantile and its interval, that of the ranks: so many shots are binomial."""
    low, high = quantile_ranks(level, int(cells.sum()), confidence)
    ends = _ranked(cells, low, 0, width), _ranked(cells, high, 1, width)
    return _below(cells, level, width), *ends


def _ranked(cells: NDArray[np.int64], rank: int, end: int, width: float) -> float:
    """Return the lower end, 0, or the upper one, 1, of the place of the shot with a rank.

    There are as many places in a cell as shots; rank 0 is below all, and one too many above.
    """
    upto = np.cumsum(cells)
    if not 0 < rank <= upto[-1]:
        return -inf if rank <= 0 else inf
    return _value(cells, int(np.searchsorted(upto, rank)), rank - 1 + end, width)


def _below(cells: NDArray[np.int64], level: float, width: float) -> float:
    """Return the value below which a share of the shots is."""
    upto = np.cumsum(cells)
    rank = min(max(level, 0.0), 1.0) * int(upto[-1])
    cell = int(np.searchsorted(upto, rank))
    while not cells[cell]:  # the first shot of all is the least value
        cell += 1
    return _value(cells, cell, rank, width)


def _value(cells: NDArray[np.int64], cell: int, rank: float, width: float) -> float:
    """Return the value of a rank that lies in a cell, whose shots are evenly spread."""
    if cell in (0, CELLS + 1):
        return -inf if cell == 0 else inf
    inside = (rank - float(cells[:cell].sum())) / int(cells[cell])
    return width * (cell - 1 - CELLS // 2 + inside)


def _sectors(cells: NDArray[np.int64]) -> dict[str, int]:
    """Return shots by sector, of cells of angles."""
    across = _AROUND // len(SECTORS)
    place = np.arange(CELLS + 2) - 1 - CELLS // 2
    sixth = (place + across // 2) // across % len(SECTORS)
    found = np.bincount(sixth, cells, minlength=len(SECTORS)).astype(np.int64)
    return dict(zip(SECTORS, found.tolist(), strict=True))


# ----------------------------------------------------------------------------------------- in words


def in_brief(found: Mapping[str, Spread]) -> str:
    """Say of each measure the median, and of a direction the sector that most rebounds go to."""
    texts = []
    for one in found.values():
        if one.sectors and one.shots:
            name = max(one.sectors, key=one.sectors.__getitem__)
            texts.append(f"{format_percent(one.sectors[name] / one.shots)} of the rebounds {name}")
        elif one.quantiles:
            seen = _shown(MEASURES[one.name].unit)
            blank = "" if seen.symbol == "°" else " "
            median = f"{_number(one.quantiles[0.5][0], seen)}{blank}{seen.symbol}"
            texts.append(f"{MEASURES[one.name].label} {median} (median)")
    return "; ".join(texts)


def spread_lines(found: Mapping[str, Spread]) -> list[str]:
    """Say measures in lines: quantiles in a table, and the sectors of a direction."""
    lines: list[str] = []
    lined = [one for one in found.values() if not one.sectors]
    if lined:
        level = format_percent(lined[0].confidence, None)
        sampled = any(one.sample for one in lined)
        heads = ["measure", "shots", "5%", "25%", "median", f"({level} interval)", "75%", "95%"]
        heads += [f"median, {level} of the sample"] if sampled else []
        rows = [_row(one) + [_median_of_sample(one)] * sampled for one in lined]
        lines += ["", table(heads, rows, right=[1, 2, 3, 4, 6, 7])]
    for one in found.values():
        if one.sectors:
            lines += ["", *_sector_lines(one)]
    heights = {one.catching_height for one in found.values() if one.catching_height is not None}
    lines += [f"rebounds are caught at {_height(height)} above the floor" for height in heights]
    return lines


def _row(one: Spread) -> list[str]:
    """Return a measure as a row: how many, and quantiles in the unit shown."""
    unit = MEASURES[one.name].unit
    seen = _shown(unit)
    said = partial(_number, seen=seen)
    label = f"{MEASURES[one.name].label} ({seen.symbol})"
    if not one.quantiles:
        return [label, "0", *[""] * 6]
    at = {level: said(quantile[0]) for level, quantile in one.quantiles.items()}
    low, high = (said(end) for end in one.quantiles[0.5][1:])
    between = f"({low} to {high})"
    return [label, f"{one.shots:,}", at[0.05], at[0.25], at[0.5], between, at[0.75], at[0.95]]


def _median_of_sample(one: Spread) -> str:
    """Return the interval of the median that contains the uncertainty of the sample."""
    if 0.5 not in one.sample:
        return ""
    seen = _shown(MEASURES[one.name].unit)
    return " to ".join(_number(end, seen) for end in one.sample[0.5])


def _number(value: float, seen: DisplayUnit) -> str:
    """Return a value in the unit shown."""
    number = round(value / seen.size, seen.decimals) + 0.0  # no minus before a zero
    return f"{number:.{seen.decimals}f}".replace("-", MINUS)


def _shown(unit: str) -> DisplayUnit:
    """Return the display unit of a measure's values."""
    kind: Any = _SEEN.get(unit)
    seen = display_unit(kind) if kind else DisplayUnit(unit, 1.0, 0)
    return DisplayUnit(seen.symbol, seen.size, _DECIMALS[unit])


def _sector_lines(one: Spread) -> list[str]:
    """Return the sectors of a direction, a line each."""
    if not one.shots:
        return ["no rebounds"]
    text = f"of {format_count(one.shots, 'rebound')}, as the shooter sees them"
    shares = one.shares
    half = max(0.5 * (high - low) for _, low, high in shares.values())
    rows = [
        [
            name,
            format_percent(share, percent_decimals(half)),
            f"({format_interval(low, high, percent_decimals(half))})",
            *([format_interval(*one.sample[name])] if one.sample else []),
        ]
        for name, (share, low, high) in shares.items()
    ]
    heads = ["direction", "share", text, *(["of the sample"] if one.sample else [])]
    return [table(heads, rows, right=[1])]


def _height(height: float) -> str:
    unit = display_unit("length")
    return f"{height / unit.size:.{unit.decimals}f}".rstrip("0").rstrip(".") + f" {unit.symbol}"
