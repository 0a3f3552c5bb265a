"""Colours, type and files: what every picture of hoopgen has in common."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from types import MappingProxyType
from typing import Any

import matplotlib
from matplotlib.figure import Figure

__all__ = ["COLOURS", "FORMATS", "MARKERS", "save", "style"]

# Okabe and Ito's palette: told apart by readers with any colour vision, and in grey.
COLOURS: Mapping[str, str] = MappingProxyType(
    {
        "path": "#0072B2",
        "ball": "#E69F00",
        "ring": "#D55E00",
        "backboard": "#333333",
        "bridge": "#00795C",
        "end": "#8C4A76",
        "release": "#0072B2",
        "faint": "#8A8A8A",
        "paper": "#FFFFFF",
    }
)

MARKERS: Mapping[str, str] = MappingProxyType(
    {"ring": "o", "backboard": "s", "bridge": "D", "end": "o", "release": "o"}
)
"""A surface is told by the shape of its badge as well as by its colour."""

FORMATS = ("png", "svg", "pdf")

_SETTINGS: Mapping[Any, Any] = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],  # comes with matplotlib: the same widths everywhere
    "font.size": 8.0,
    "axes.labelsize": 8.5,
    "axes.linewidth": 0.6,
    "axes.edgecolor": "#444444",
    "xtick.labelsize": 8.0,
    "ytick.labelsize": 8.0,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.major.size": 3.0,
    "ytick.major.size": 3.0,
    "axes.unicode_minus": True,
    "svg.hashsalt": "hoopgen",
    "svg.fonttype": "path",
    "pdf.fonttype": 42,
}

# Nothing in a file tells when it was written.
_METADATA: Mapping[str, dict[str, str | None]] = MappingProxyType(
    {
        "png": {"Software": None},
        "svg": {"Date": None, "Creator": "hoopgen"},
        "pdf": {"CreationDate": None, "Creator": "hoopgen"},
    }
)


@contextmanager
def style() -> Iterator[None]:
    """Draw in hoopgen's style, and leave matplotlib's settings as they were."""
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(_SETTINGS)
        yield


def save(figure: Figure, path: str | Path, *, dpi: int = 200) -> Path:
    """Write a picture; the same figure gives the same bytes.

    Parameters
    ----------
    figure
        The picture.
    path
        Where to; its suffix, one of `FORMATS`, says in which format.
    dpi
        Dots per inch, of a PNG.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    ValueError
        The suffix is none of `FORMATS`.
    """
    target = Path(path)
    suffix = target.suffix.lower().lstrip(".")
    if suffix not in FORMATS:
        raise ValueError(f"{target.name!r}: a picture's name ends in .{', .'.join(FORMATS)}")
    with style():
        figure.savefig(target, format=suffix, dpi=dpi, metadata=_METADATA[suffix])
    return target
