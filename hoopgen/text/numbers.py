"""Formats of counts, shares and intervals, the same in text, tables and pictures."""

from __future__ import annotations

from math import floor, isnan, log10
from numbers import Integral

MINUS = "\N{MINUS SIGN}"


def format_count(count: float, noun: str) -> str:
    """Return a count with its noun: 1 shot, 2 shots, 1,000 shots.

    Parameters
    ----------
    count
        A number; whole ones have their thousands apart.
    noun
        The noun in the singular.
    """
    number = f"{count:,}" if isinstance(count, Integral) else f"{count:,.6g}"
    return f"{number} {noun}{'' if count == 1 else 's'}"


def format_uncertain(uncertain: int, capped: int) -> str:
    """Return the number of uncertain shots, and of the capped ones among them.

    Rounding errors grow with each contact, so most uncertain shots are capped ones.

    Parameters
    ----------
    uncertain
        Number of uncertain shots.
    capped
        Number of capped shots among them.
    """
    return f"{uncertain:,} uncertain" + (f" ({capped:,} of them capped)" if capped else "")


def format_percent(share: float, digits: int | None = 1) -> str:
    """Format a share as a percentage.

    The share of none, NaN, is unknown.

    Parameters
    ----------
    share
        The share, 0 to 1.
    digits
        Decimals; None for four significant digits.
    """
    if isnan(share):
        return "unknown"
    if digits is None:
        return f"{100.0 * share:.4g}%"
    least = 0.1**digits
    if 0.0 < 100.0 * share < least / 2.0:
        return f"<{least:.{digits}f}%"
    return f"{100.0 * share:.{digits}f}%"


def format_interval(low: float, high: float, digits: int = 1) -> str:
    """Format the ends of a share's interval as percentages.

    Parameters
    ----------
    low, high
        The ends, shares from 0 to 1.
    digits
        Decimals of the percentages.
    """
    return f"{format_percent(low, digits)} to {format_percent(high, digits)}"


def format_points(difference: float, digits: int = 1) -> str:
    """Format a difference of shares in percentage points, with its sign; a minus is U+2212.

    Parameters
    ----------
    difference
        The difference of two shares, -1 to 1.
    digits
        Decimals of the percentage points.
    """
    return f"{100.0 * difference:+.{digits}f}".replace("-", MINUS)


def percent_decimals(half_width: float) -> int:
    """Return the decimals of a percentage that show two digits of half an interval."""
    return max(1, min(9, 1 - floor(log10(100.0 * half_width)))) if half_width > 0.0 else 1
