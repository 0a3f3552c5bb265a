"""The style of all pictures: colours, type and files."""

from __future__ import annotations

import io
import re
import textwrap
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from types import MappingProxyType
from typing import Any, TypeAlias

import matplotlib
from matplotlib.figure import Figure

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.colours import COLOURS, MADE, MISSED, OTHER_OUTCOME_COLOURS
from hoopgen.core.files import PICTURES, atomic_file, check_output
from hoopgen.core.validation import check_count

__all__ = [
    "COLOURS",
    "COLUMN",
    "DARK",
    "EDGES",
    "FORMATS",
    "FRAME",
    "GRID",
    "INK",
    "Inches",
    "LINES",
    "MADE",
    "MISSED",
    "NARROW_PAGE",
    "OTHER_OUTCOME_COLOURS",
    "PAGE",
    "POINTS_PER_INCH",
    "SHARE_COLOURS",
    "NOTE_SIZE",
    "letter",
    "save",
    "style",
    "wrap",
]

Inches: TypeAlias = float

COLUMN, PAGE = 3.5, 7.1
"""Widths of a journal's column and of its page, inches."""

NARROW_PAGE = 5.0
"""Inches: on a page less wide, panels stand one above the other."""

POINTS_PER_INCH = 72.0

NOTE_SIZE = 7.5
"""Points: of what is said beside a picture."""

INK, DARK, FRAME, EDGES, GRID = "#333333", "#222222", "#444444", "#777777", "#ECECEC"
"""Colours of text, lines over colours, axes, edges of areas, and of the grid behind everything."""

# Lines have a contrast of 3 with paper at least (WCAG 2.2, 1.4.11). As in `MADE` and `MISSED`, the
# colours of areas, no two are nearer than 10 (CIEDE2000) to readers of any colour vision.
LINES: Mapping[str, Mapping[str, str]] = MappingProxyType(
    {
        "made": MappingProxyType(
            {
                "swish": "#072A63",
                "rim": "#721800",
                "bank": "#025732",
                "bank_rim": "#704C8B",
                "rim_board": "#875B09",
            }
        ),
        "missed": MappingProxyType(
            {
                "rim": "#D76E21",
                "bank": "#567F65",
                "bank_rim": "#AC709F",
                "rim_board": "#A39165",
                "airball": "#217CE5",
            }
        ),
    }
)
"""Colours of paths, by outcome and kind."""

SHARE_COLOURS = "YlGnBu"
"""Matplotlib's colours of a share: lightness falls evenly, in grey and with any colour vision."""

_MIN_LETTERS = 20  # letters of a line
_NUMBER_AND_UNIT = re.compile(r"(?<=[\d$]) (?=(?:m|cm|mm|m/s|ft|in|ft/s|mph|s|Hz|rad/s)\b)")

FORMATS = tuple(suffix.removeprefix(".") for suffix in PICTURES)

_SETTINGS: Mapping[Any, Any] = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],  # comes with matplotlib: the same widths everywhere
    "font.size": 8.0,
    "axes.labelsize": 8.5,
    "axes.linewidth": 0.6,
    "axes.edgecolor": FRAME,
    "xtick.labelsize": 8.0,
    "ytick.labelsize": 8.0,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.major.size": 3.0,
    "ytick.major.size": 3.0,
    "axes.unicode_minus": True,
    "text.parse_math": False,  # titles and names are others': "$5 off" is no formula
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


_NUMBERS = re.compile(rb'(?: (?:d|x|y)="|translate\()[^")]*')
_LONG_NUMBER = re.compile(rb"-?\d+\.\d{4,}")
_SVG_DIGITS = 3  # decimals of a coordinate in an SVG file, whose unit is a point


def letter(size: float) -> float:
    """Return the mean width of a letter in DejaVu Sans, inches; its size is in points."""
    return 0.56 * size / POINTS_PER_INCH


def wrap(text: str, width: float, size: float) -> list[str]:
    """Wrap a text into lines of a width, inches, in letters of a size, points.

    A number stays with its unit.

    Parameters
    ----------
    text
        The text.
    width
        The width of a line, inches.
    size
        The size of the letters, points.
    """
    kept = _NUMBER_AND_UNIT.sub("\N{NO-BREAK SPACE}", text)
    lines = textwrap.wrap(kept, max(_MIN_LETTERS, int(width / letter(size))))
    return [line.replace("\N{NO-BREAK SPACE}", " ") for line in lines]


@contextmanager
def style() -> Iterator[None]:
    """Use hoopgen's style within a context; matplotlib's settings are restored."""
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(_SETTINGS)
        yield


@check_arguments
def save(figure: Figure, path: str | Path, *, dpi: int = 300) -> Path:
    """Write a picture; the same figure gives the same bytes.

    Parameters
    ----------
    figure
        The picture.
    path
        Where to; its suffix, one of `FORMATS`, says in which format.
    dpi
        Dots per inch: of a PNG, and of a map's cells, which alone are pixels in the other formats.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    ValueError
        The suffix is none of `FORMATS`.
    OSError
        The file cannot be written; what was there before stays.
    """
    check_count("dpi", dpi, least=20, most=10_000)
    target = check_output(path, PICTURES)
    suffix = target.suffix.lower().lstrip(".")
    with style(), atomic_file(target) as file, io.BytesIO() as drawn:
        figure.savefig(drawn, format=suffix, dpi=dpi, metadata=_METADATA[suffix])
        file.write(_shorten(drawn.getvalue()) if suffix == "svg" else drawn.getbuffer())
    return target


def _shorten(svg: bytes) -> bytes:
    """Return an SVG file with the digits of its coordinates that can be seen."""
    return _NUMBERS.sub(lambda part: _LONG_NUMBER.sub(_round, part[0]), svg)


def _round(number: re.Match[bytes]) -> bytes:
    return b"%.15g" % (round(float(number[0]), _SVG_DIGITS) + 0.0)  # no "-0"
