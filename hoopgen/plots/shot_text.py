"""Text of pictures of one shot: its release and scene, and the title of a page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Protocol

import numpy as np
from matplotlib.figure import Figure
from matplotlib.text import Text
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.units import display_system, display_unit
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.hoop.releases import RING_HEIGHT
from hoopgen.report.provenance import describe_scene
from hoopgen.text.escape import printable
from hoopgen.text.numbers import MINUS

from .style import INK, NOTE_SIZE, wrap

__all__ = ["LEFT", "LINE", "TITLE", "describe_shot", "dot_times", "draw_title", "wrap_lines"]

LEFT = 0.62
"""Left margin of the text, inches."""

TITLE, LINE = 0.24, 0.14
"""Heights of a title and of a line below it, inches."""

_PAD = 0.1  # inches, above the first line

DOT_INTERVAL = 0.1
"""Seconds between the dots on the path; of a longer shot more, so that there are not too many."""

_MAX_DOTS = 100

_ROUNDING = 1e-12
"""Part of the largest component of a spin below which another is the rounding of a direction."""


class FlightPath(Protocol):
    """The part of `Trajectory` that pictures need."""

    @property
    def release(self) -> NDArray[np.float64]: ...
    @property
    def events(self) -> NDArray[Any]: ...
    @property
    def duration(self) -> float: ...
    @property
    def scene(self) -> CompiledScene: ...
    def at(self, t: ArrayLike) -> NDArray[np.float64]: ...


def dot_times(duration: float) -> NDArray[np.float64]:
    """Return the times of the dots on the path, s."""
    beat = _dot_interval(duration)
    times = beat * np.arange(1.0, duration / beat + 1.0)
    return times[times < duration]


def _dot_interval(duration: float) -> float:
    """Return the time between dots: 0.1 s, or 0.2, 0.5, 1 ... where that would be too many."""
    longer = (float(f"{digit}e{power}") for power in range(-1, 308) for digit in (2, 5, 10))
    return next(beat for beat in (DOT_INTERVAL, *longer) if duration <= _MAX_DOTS * beat)


def wrap_lines(description: Sequence[str], width: float) -> list[str]:
    """Wrap the texts below a title into lines that fit a page's width, inches.

    Parameters
    ----------
    description
        The texts.
    width
        The width of the page, inches.
    """
    return [line for text in description for line in wrap(text, width - LEFT, NOTE_SIZE)]


def describe_shot(trajectory: FlightPath, parameters: Mapping[str, float]) -> tuple[str, str]:
    """Describe the release and the scene of a shot.

    Parameters
    ----------
    trajectory
        The path.
    parameters
        The scene's parameters.
    """
    x, y, z, vx, vy, vz, *spin = (float(value) for value in trajectory.release)
    speed = np.hypot(np.hypot(vx, vy), vz)
    angle = np.degrees(np.arctan2(vz, np.hypot(vx, vy)))
    unit, spins, length = display_unit("speed"), display_unit("spin"), display_unit("length")
    digits = length.decimals
    # The article's figures say angular velocities, coaches turns a second.
    us = display_system() == "us"
    sign, symbol, size = ("/2\\pi", spins.symbol, spins.size) if us else ("", "rad/s", 1.0)
    up = f"{angle:.1f}\N{DEGREE SIGN} up{_describe_azimuth(x, y, vx, vy)}"
    said = f"Released at {speed / unit.size:.2f} {unit.symbol}, {up}"
    turning = [  # no blanks in formulas: lines are broken there
        f"$\\omega_{axis}{sign}={w / size:.4g}$ {symbol}"
        for axis, w in zip("xyz", spin, strict=True)
        if abs(w) > _ROUNDING * max(map(abs, spin))
    ]
    scene = describe_scene(trajectory.scene, parameters)
    dots = f"Scene: {scene}. Dots on the path every {_dot_interval(trajectory.duration):g} s."
    turns = ", ".join(turning) or "no spin"
    if not trajectory.scene.is_hoop:
        at = ", ".join(f"{one / length.size:.{digits}f}".replace("-", MINUS) for one in (x, y, z))
        fast = f"{speed / unit.size:.2f} {unit.symbol}"
        return f"Released at {fast}, {turns}; from ({at}) {length.symbol}.", dots
    away, high = (
        f"{one / length.size:.{digits}f} {length.symbol}"
        for one in (np.hypot(x, y), RING_HEIGHT + z)
    )
    place = f"{away} from the ring's centre, {high} high"
    return f"{said}, {turns}; {place}.", dots


def _describe_azimuth(x: float, y: float, vx: float, vy: float) -> str:
    """Describe the azimuth of a flight, "" if it is zero."""
    if not ((x or y) and (vx or vy)):
        return ""
    azimuth = np.degrees(np.arctan2(y * vx - x * vy, -x * vx - y * vy))
    if round(abs(azimuth), 1) == 0.0:
        return ""
    return f" and {abs(azimuth):.1f}\N{DEGREE SIGN} to the {'left' if azimuth > 0.0 else 'right'}"


def draw_title(
    figure: Figure, title: str, description: Sequence[str], *, room: float = TITLE
) -> Text:
    """Add a title to a page, and lines below it; return the title.

    Parameters
    ----------
    figure
        The page.
    title
        The title.
    description
        The lines below it.
    room
        The height of the room for the title, inches.
    """
    width, height = figure.get_size_inches()
    x = LEFT / width
    head = printable(title)
    top = 1.0 - 0.16 / height
    written = figure.text(x, top, head, fontsize=10, fontweight="bold", va="center")
    for number, line in enumerate(description):
        y = 1.0 - (_PAD + room + LINE * number) / height
        figure.text(x, y, line, fontsize=NOTE_SIZE, color=INK, va="center", parse_math=True)
    return written
