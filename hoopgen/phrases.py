"""Numbers of shots, shares and intervals in words: one form in text, tables and pictures."""

from __future__ import annotations

from math import floor, isnan, log10
from numbers import Integral

__all__ = ["MINUS", "counted", "decimals", "doubtful", "interval", "percent", "points"]

MINUS = "\N{MINUS SIGN}"


def counted(count: float, noun: str) -> str:
    """Say how many: 1 shot, 2 shots, 1,000 shots."""
    number = f"{count:,}" if isinstance(count, Integral) else f"{count:,.6g}"
    return f"{number} {noun}{'' if count == 1 else 's'}"


def doubtful(uncertain: int, capped: int) -> str:
    """Say how many shots are uncertain, and how many of those were given up as capped.

    After so many contacts rounding errors have grown: most of those in doubt are mostly these.
    """
    return f"{uncertain:,} uncertain" + (f" ({capped:,} of them capped)" if capped else "")


def percent(share: float, digits: int | None = 1) -> str:
    """Say a share with so many decimals, or with four digits; less than would be seen is said.

    The share of none, NaN, is unknown.
    """
    if isnan(share):
        return "unknown"
    if digits is None:
        return f"{100.0 * share:.4g}%"
    least = 0.1**digits
    if 0.0 < 100.0 * share < least / 2.0:
        return f"<{least:.{digits}f}%"
    return f"{100.0 * share:.{digits}f}%"


def interval(low: float, high: float, digits: int = 1) -> str:
    """Say the ends of a share's interval."""
    return f"{percent(low, digits)} to {percent(high, digits)}"


def points(difference: float, digits: int = 1) -> str:
    """Say a difference of shares in percentage points, with its sign; a minus is U+2212."""
    return f"{100.0 * difference:+.{digits}f}".replace("-", MINUS)


def decimals(half_width: float) -> int:
    """Return the decimals of percents at which two digits of half an interval are seen."""
    return max(1, min(9, 1 - floor(log10(100.0 * half_width)))) if half_width > 0.0 else 1
