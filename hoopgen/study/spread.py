"""How measures of shots are spread: quantiles, and of rebounds the shares by sector.

Values are counted in cells, whole numbers that add up to the same whoever counts them, so what is
said of millions of shots needs none of them to be kept. A quantile is off by less than a cell.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from math import inf
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.layout import table
from hoopgen.phrases import MINUS, counted, decimals, interval, percent
from hoopgen.results import Shots
from hoopgen.units import TURN, Shown, shown
from hoopgen.variables import Releases
from hoopgen.words import for_json

from .intervals import Ends, quantile_ranks, wilson
from .measures import MEASURES, measure
from .rebounds import SECTORS, caught_at, sector
from .sample import Rows

__all__ = [
    "QUANTILES",
    "Spread",
    "counts_of",
    "in_brief",
    "spread_lines",
    "spreads",
    "spreads_of_sample",
    "width_of",
]

QUANTILES = (0.05, 0.25, 0.5, 0.75, 0.95)
"""Shares of the shots that are below."""

_AROUND = 1440
"""Cells of a turn: a multiple of twice the sectors, whose ends then are ends of cells."""

_WIDTHS: Mapping[str, float] = MappingProxyType(
    {"m": 0.01, "s": 0.005, "rad": TURN / _AROUND, "m/s": 0.02}
)
"""Of a cell, by unit."""

_CELLS = 4096
"""About 0; what lies beyond is counted at both ends: that many centimetres, for one."""

_SEEN: Mapping[str, str] = MappingProxyType({"m": "length", "m/s": "speed", "rad": "angle"})
"""Kinds of quantities that are shown in units of one's own, by unit."""

_DECIMALS: Mapping[str, int] = MappingProxyType({"m": 2, "s": 2, "rad": 1, "m/s": 2})

_DIRECTION = "rebound_angle"
"""Which goes round, so that it has sectors."""


@dataclass(frozen=True)
class Spread:
    """How a measure is spread over the shots of which it is one.

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
        Of a direction of rebounds: shots by the names of `hoopgen.study.rebounds.SECTORS`.
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
        ends = {name: wilson(n, self.shots, self.confidence) for name, n in self.sectors.items()}
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
        told: dict[str, Any] = {"unit": unit, "shots": self.shots, "confidence": self.confidence}
        told |= {"quantiles": quantiles} if quantiles else {}
        told |= {"sectors": sectors} if self.sectors else {}
        told |= {"catching_height": height} if (height := self.catching_height) else {}
        sample = {
            name if isinstance(name, str) else f"{name:g}": {"low": low, "high": high}
            for name, (low, high) in self.sample.items()
        }
        told |= {"sample": sample} if sample else {}
        return {name: for_json(value) for name, value in told.items()}


# ---------------------------------------------------------------------------------------- counting


def width_of(names: Sequence[str]) -> int:
    """Return how many numbers the counts of measures are."""
    return len(names) * (_CELLS + 2)


def counts_of(
    releases: Releases, shots: Shots, names: Sequence[str], catching_height: float
) -> NDArray[np.int64]:
    """Return how many shots are in each cell of each measure, one measure after the other."""
    columns = measure(
        releases.states, shots, releases.parameters, names, catching_height=catching_height
    )
    found = np.zeros((len(names), _CELLS + 2), np.int64)
    for row, name in zip(found, names, strict=True):
        there = columns[name][~np.isnan(columns[name])] / _WIDTHS[MEASURES[name].unit]
        cells = np.clip(np.floor(there), -_CELLS // 2 - 1, _CELLS // 2).astype(np.int64)
        row += np.bincount(cells + _CELLS // 2 + 1, minlength=_CELLS + 2)
    return found.ravel()


def spreads(
    counts: NDArray[np.int64], names: Sequence[str], confidence: float, catching_height: float
) -> dict[str, Spread]:
    """Return what counts say, by the name of the measure."""
    found = {}
    for name, cells in zip(names, counts.reshape(len(names), _CELLS + 2), strict=True):
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
    """Return measures with the intervals that contain the uncertainty of measured releases."""
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
    """Return the end, 0 the lower, of where the shot with a rank is, those of a cell evenly spread.

    There are as many places in a cell as shots; rank 0 is below all, and one too many above.
    """
    upto = np.cumsum(cells)
    if not 0 < rank <= upto[-1]:
        return -inf if rank <= 0 else inf
    cell = int(np.searchsorted(upto, rank))
    if cell in (0, _CELLS + 1):
        return -inf if cell == 0 else inf
    inside = (rank - 1 + end - float(upto[cell] - cells[cell])) / int(cells[cell])
    return width * (cell - 1 - _CELLS // 2 + inside)


def _below(cells: NDArray[np.int64], level: float, width: float) -> float:
    """Return the value below which a share of the shots is, those of a cell evenly spread."""
    upto = np.cumsum(cells)
    rank = min(max(level, 0.0), 1.0) * int(upto[-1])
    cell = int(np.searchsorted(upto, rank))
    while not cells[cell]:  # the first shot of all is the least value
        cell += 1
    if cell in (0, _CELLS + 1):
        return -inf if cell == 0 else inf
    inside = (rank - float(upto[cell] - cells[cell])) / int(cells[cell])
    return width * (cell - 1 - _CELLS // 2 + inside)


def _sectors(cells: NDArray[np.int64]) -> dict[str, int]:
    """Return shots by sector, of cells of angles."""
    across = _AROUND // len(SECTORS)
    place = np.arange(_CELLS + 2) - 1 - _CELLS // 2
    sixth = (place + across // 2) // across % len(SECTORS)
    found = np.bincount(sixth, cells, minlength=len(SECTORS)).astype(np.int64)
    return dict(zip(SECTORS, found.tolist(), strict=True))


# ----------------------------------------------------------------------------------------- in words


def in_brief(found: Mapping[str, Spread]) -> str:
    """Say of each measure the median, and of a direction the sector that most rebounds go to."""
    said = []
    for one in found.values():
        if one.sectors and one.shots:
            name = max(one.sectors, key=one.sectors.__getitem__)
            said.append(f"{percent(one.sectors[name] / one.shots)} of the rebounds {name}")
        elif one.quantiles:
            seen = _shown(MEASURES[one.name].unit)
            blank = "" if seen.symbol == "°" else " "
            median = f"{_number(one.quantiles[0.5][0], seen)}{blank}{seen.symbol}"
            said.append(f"{MEASURES[one.name].label} {median} (median)")
    return "; ".join(said)


def spread_lines(found: Mapping[str, Spread]) -> list[str]:
    """Say measures in lines: quantiles in a table, and the sectors of a direction."""
    lines: list[str] = []
    lined = [one for one in found.values() if not one.sectors]
    if lined:
        level = percent(lined[0].confidence, None)
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


def _number(value: float, seen: Shown) -> str:
    """Return a value in the unit shown."""
    number = round(value / seen.size, seen.decimals) + 0.0  # no minus before a zero
    return f"{number:.{seen.decimals}f}".replace("-", MINUS)


def _shown(unit: str) -> Shown:
    """Return how values of a measure are shown."""
    kind: Any = _SEEN.get(unit)
    seen = shown(kind) if kind else Shown(unit, 1.0, 0)
    return Shown(seen.symbol, seen.size, _DECIMALS[unit])


def _sector_lines(one: Spread) -> list[str]:
    """Return the sectors of a direction, a line each."""
    if not one.shots:
        return ["no rebounds"]
    said = f"of {counted(one.shots, 'rebound')}, as the shooter sees them"
    shares = one.shares
    half = max(0.5 * (high - low) for _, low, high in shares.values())
    rows = [
        [
            name,
            percent(share, decimals(half)),
            f"({interval(low, high, decimals(half))})",
            *([interval(*one.sample[name])] if one.sample else []),
        ]
        for name, (share, low, high) in shares.items()
    ]
    heads = ["direction", "share", said, *(["of the sample"] if one.sample else [])]
    return [table(heads, rows, right=[1])]


def _height(height: float) -> str:
    unit = shown("length")
    return f"{height / unit.size:.{unit.decimals}f}".rstrip("0").rstrip(".") + f" {unit.symbol}"
