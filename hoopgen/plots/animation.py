"""Films of a shot, as GIF or MP4: the ball moves as `Trajectory.at` says.

What does not move, axes and texts, is drawn once; each frame has the rest, the near over the far.
"""

from __future__ import annotations

import io
import tempfile
from collections.abc import Mapping
from enum import IntEnum
from itertools import pairwise
from pathlib import Path

import numpy as np
from matplotlib.animation import FFMpegWriter
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backend_bases import RendererBase
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle
from numpy.typing import NDArray
from PIL import Image

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.files import FILMS, check_output, write
from hoopgen.core.validation import as_number
from hoopgen.text.shorten import brief

from .contact_marks import LEGEND_ROW, Mark, draw_badges, draw_mark_legend, mark_legend_rows
from .hoop import drawing_order
from .page import stack_views
from .panels import Drawing, add_panel, label_flat_view, thin_rows
from .shot_text import LEFT, LINE, describe_shot, dot_times, draw_title, wrap_lines
from .shot_text import FlightPath as Trajectory
from .style import COLOURS, PAGE, style
from .trajectory import build_drawing, flat_limits, path_times
from .views import Panel, Points, View

FRAME_RATE = 25
"""Frames a second: a GIF counts in hundredths of one."""

_SPEEDS = (0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0)
_MAX_FRAMES = 160  # of a shot, at most, at the speed that is chosen
_END_DURATION = 1.0  # s, for which the end is shown
_FLASH_FRAMES = 5  # frames, for which a contact is seen on the ball
_DPI = 110
_PALETTE_SIZE = 128
_PATH_PIECES = 40  # of a path, with an order from far to near each
_MAX_OBSTACLES = 2_000
_DOT_ORDER = 0.005  # of the drawing order, above that of the path there

# Inches around and between the panels.
_RIGHT, _GAP, _BELOW, _ABOVE = 0.15, 0.72, 0.5, 0.62
_MAX_HEIGHT = 4.2
_MIN_WIDTH = 5.3


@check_arguments
def save_film(
    trajectory: Trajectory,
    parameters: Mapping[str, float],
    path: str | Path,
    *,
    outcome: IntEnum | None = None,
    title: str = "",
    speed: float | None = None,
) -> Path:
    """Write a shot in motion: from the side and, where it leaves the plane y = 0, from above.

    The ball is to scale. At a contact its outline takes the colour of what it touches for a moment,
    and a numbered badge stays there, and in the key. Nothing is said before it happens: the outcome
    is added to the title at the end.

    Parameters
    ----------
    trajectory, parameters, outcome, title
        As for `plot_trajectory`.
    path
        Where to: .gif, or .mp4 where the program ffmpeg is on the PATH.
    speed
        1 as fast as the ball is; by default a quarter of that, more for a shot that would take
        more than 160 frames. The picture says it.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    ValueError
        If its name ends otherwise, `speed` is not above 0, or the path leads further than 1e290 m.
    RuntimeError
        If it is an MP4 and there is no ffmpeg.
    OSError
        The file cannot be written; what was there before stays.
    """
    target = check_output(path, FILMS)
    if target.suffix.lower() == ".mp4" and not FFMpegWriter.isAvailable():
        raise RuntimeError(
            f"{target.name}: an MP4 needs the program ffmpeg, and there is none on the PATH; "
            "install it, or write a .gif"
        )
    if speed is not None and not 0.0 < as_number("speed", speed, "a number above 0") < np.inf:
        raise ValueError(f"speed: expected a number above 0, got {brief(speed)}")
    with style():
        film = Film(trajectory, parameters, outcome, title, speed)
        content = _gif(film) if target.suffix.lower() == ".gif" else _mp4(film)
    return write(target, content)


def _gif(film: Film) -> bytes:
    """Return an endless GIF; its frames share one palette, which avoids noise.

    The end has all colours: every badge is there then.
    """
    pixels = [film.frame(time) for time in film.times.tolist()]
    frames = [Image.fromarray(each).convert("RGB") for each in pixels]
    palette = frames[-1].quantize(_PALETTE_SIZE)
    drawn = [each.quantize(palette=palette, dither=Image.Dither.NONE) for each in frames]
    paper, colours = drawn[0].getpixel((0, 0)), drawn[0].getpalette()
    assert isinstance(paper, int)
    assert colours is not None
    colours[3 * paper : 3 * paper + 3] = 255, 255, 255  # which is a mean of near ones else
    for each in drawn:
        each.putpalette(colours)
    first, *others = drawn
    out = io.BytesIO()
    lasting = [*[1000 // FRAME_RATE] * len(others), round(1000 * _END_DURATION)]
    first.save(out, "GIF", save_all=True, append_images=others, duration=lasting, loop=0)
    return out.getvalue()


def _mp4(film: Film) -> bytes:
    """Return an MP4 by ffmpeg, which needs a seekable file."""
    writer = FFMpegWriter(FRAME_RATE)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "film.mp4"
        with writer.saving(film.figure, str(file), _DPI):
            for time in [
                *film.times.tolist(),
                *[film.times[-1]] * round(_END_DURATION * FRAME_RATE),
            ]:
                film.show(time)
                writer.grab_frame()
        return file.read_bytes()


class Film:
    """The frames of a film; arguments as for `save_film`.

    Attributes
    ----------
    figure
        As it is at the time shown last.
    times
        Of the frames, s; the last is the end.
    speed
        How many times as fast as the ball.
    """

    def __init__(
        self,
        trajectory: Trajectory,
        parameters: Mapping[str, float],
        outcome: IntEnum | None = None,
        title: str = "",
        speed: float | None = None,
    ) -> None:
        self._trajectory, drawing = trajectory, build_drawing(trajectory, parameters, outcome)
        self._scenery = drawing.scenery
        duration = trajectory.duration
        self.speed = _speed(duration) if speed is None else speed
        moving = np.arange(int(np.ceil(duration * FRAME_RATE / self.speed))) * (
            self.speed / FRAME_RATE
        )
        self.times = np.append(moving, duration)
        self._when = path_times(trajectory.events["time"], duration)
        self._beats = dot_times(duration)
        description = [
            *describe_shot(trajectory, parameters),
            f"Shown {_describe_speed(self.speed)}.",
        ]
        panels = _arrange(drawing)
        still = _draw_background(panels, drawing, description)
        size = still.get_size_inches().tolist()
        self.figure = Figure(figsize=(size[0], size[1]), dpi=_DPI, frameon=False)
        self.figure.add_artist(_Background(_pixels(still)))
        path = drawing.scenery.upright(trajectory.at(self._when)[:, :3])
        self._views = [_MovingView(self.figure, panel, drawing, path) for panel in panels]
        edge = panels[0].left + panels[0].width
        at = edge / size[0], (panels[0].top + 0.06) / size[1]
        self._clock = self.figure.text(*at, "", ha="right", fontsize=9.0)
        self._head = draw_title(self.figure, title, ())
        self._title, self._verdict = self._head.get_text(), ""
        if outcome is not None:
            self._verdict = outcome.name.lower() if self._title else outcome.name.capitalize()
        self._key = draw_mark_legend(self.figure, drawing.marks, panels[0].left, 0.12)

    def show(self, time: float) -> None:
        """Move everything to its place at a time, s."""
        centre = self._scenery.upright(self._trajectory.at(time)[:3])
        path = int(np.searchsorted(self._when, time, side="right"))
        beats = int(np.searchsorted(self._beats, time, side="right"))
        recent = time - _FLASH_FRAMES * self.speed / FRAME_RATE
        for view in self._views:
            view.show(centre, path, beats, time, recent)
        self._clock.set_text(f"{time:.2f} s")
        ended = time >= self._trajectory.duration
        for mark, artists in self._key:
            # What has no place in the scene says how it ends, but for what a line means.
            seen = ended or mark.kind == "line" or bool(mark.label and mark.time <= time)
            for artist in artists:
                artist.set_visible(seen)
        said = [self._title, self._verdict] if ended else [self._title]
        self._head.set_text(": ".join(filter(None, said)))

    def frame(self, time: float) -> NDArray[np.uint8]:
        """Return the picture at a time, s: its pixels, (height, width, 4)."""
        self.show(time)
        return _pixels(self.figure)


def _pixels(figure: Figure) -> NDArray[np.uint8]:
    canvas = FigureCanvasAgg(figure)
    canvas.draw()  # type: ignore[no-untyped-call]
    return np.array(canvas.buffer_rgba())  # type: ignore[no-untyped-call]


class _Background(Artist):
    """A still image behind all moving parts, drawn pixel by pixel without resampling."""

    def __init__(self, pixels: NDArray[np.uint8]) -> None:
        super().__init__()
        self.set(zorder=-10.0)
        self._pixels = pixels[::-1]

    def draw(self, renderer: RendererBase) -> None:
        """Draw it."""
        renderer.draw_image(renderer.new_gc(), 0.0, 0.0, self._pixels)


class _MovingView:
    """The moving parts of a view: the ball, its path so far and the badges of its contacts."""

    def __init__(self, figure: Figure, panel: Panel, drawing: Drawing, path: Points) -> None:
        axes = add_panel(figure, panel)
        axes.set_title("", loc="left")
        axes.set_axis_off()
        self.view = view = drawing.scenery.look(panel.view)
        drawing.scenery.draw(axes, view, panel.scale)
        self.bodies = list(axes.patches)
        self.path = view.flatten(path)
        piece = max(2, -(-len(path) // _PATH_PIECES))
        ends = [*range(0, len(path) - 1, piece), len(path) - 1]
        self.pieces: list[tuple[int, int, Line2D]] = []
        for first, last in pairwise(ends):
            order = drawing_order(view, path[first : last + 1].mean(axis=0))
            line = Line2D([], [], color=COLOURS["path"], lw=1.3, zorder=order)
            self.pieces.append((first, last, axes.add_line(line)))
        self.whole = [False] * len(self.pieces)  # those that stay as they are
        self.dots = [axes.add_line(_dot(view, beat)) for beat in drawing.beats]
        radius = drawing.scenery.ball_radius
        self.fill = axes.add_patch(Circle((0.0, 0.0), radius, alpha=0.85, lw=0))
        self.fill.set_facecolor(COLOURS[drawing.scenery.ball])
        self.edge = COLOURS[f"{drawing.scenery.ball}-edge"]
        self.outline = axes.add_patch(Circle((0.0, 0.0), radius, fill=False))
        self.badges = self._badges(axes, panel, drawing)

    def _badges(
        self, axes: Axes, panel: Panel, drawing: Drawing
    ) -> list[tuple[Mark, list[Artist]]]:
        marks = tuple(mark for mark in drawing.marks if mark.label and mark.kind != "release")
        lines, texts = len(axes.lines), len(axes.texts)
        radius = drawing.scenery.ball_radius
        around = np.vstack([thin_rows(drawing.path, _MAX_OBSTACLES), drawing.scenery.points()])
        obstacles = self.view.flatten(around)
        limits, bodies = panel.limits, self.bodies
        draw_badges(axes, self.view, marks, obstacles, limits, radius, panel.scale, bodies)
        drawn = zip(axes.lines[lines:], axes.texts[texts:], strict=True)
        return [(mark, list(pair)) for mark, pair in zip(marks, drawn, strict=True)]

    def show(self, centre: Points, path: int, beats: int, time: float, recent: float) -> None:
        """Draw the ball at a centre, with the first points and dots of its path.

        What is touched since `recent` is seen on the ball.
        """
        at = self.view.flatten(centre)
        for number, (first, last, line) in enumerate(self.pieces):
            whole = path > last
            if whole and self.whole[number]:
                continue
            some = self.path[first : min(last + 1, path)]
            here = some if whole or not len(some) else np.vstack([some, at])
            line.set_data(here[:, 0], here[:, 1])
            line.set_visible(len(here) > 0)
            self.whole[number] = whole
        for number, dot in enumerate(self.dots):
            dot.set_visible(number < beats)
        colour, wide = self.edge, 0.9
        for mark, artists in self.badges:
            for artist in artists:
                artist.set_visible(mark.time <= time)
            if recent < mark.time <= time and mark.kind != "end":
                colour, wide = mark.colour, 3.0
        order = drawing_order(self.view, centre)
        for circle, zorder in ((self.fill, order), (self.outline, order + 0.01)):
            circle.set(center=(at[0], at[1]), zorder=zorder)
        self.outline.set(ec=colour, lw=wide)


def _dot(view: View, beat: Points) -> Line2D:
    """Return a dot of the path, above the line and below the ball that is there."""
    (x, y), order = view.flatten(beat).tolist(), drawing_order(view, beat) + _DOT_ORDER
    dot = Line2D([x], [y], ls="none", marker="o", ms=2.4, mec="none", zorder=order)
    dot.set_color(COLOURS["path"])
    return dot


def _speed(duration: float) -> float:
    """Return the slowest speed at which a shot has no more frames than allowed."""
    enough = duration * FRAME_RATE / _MAX_FRAMES
    return next((speed for speed in _SPEEDS if speed >= enough), max(enough, _SPEEDS[-1]))


def _describe_speed(speed: float) -> str:
    if speed == 1.0:
        return "as fast as it is"
    return f"{speed:g} times as fast as it is" if speed > 1.0 else f"{1.0 / speed:.4g} times slower"


def _arrange(drawing: Drawing) -> list[Panel]:
    """Place the view that shows most and, if it shows more, the other below it."""
    flat = drawing.scenery.is_in_plane(drawing.path)
    shown = drawing.views[:1] if flat else drawing.views
    views = [(view, flat_limits(drawing, view)) for view in shown]
    across = max(limits[1] - limits[0] for _, limits in views)
    up = sum(limits[3] - limits[2] for _, limits in views)
    scale = min((PAGE - LEFT - _RIGHT) / across, _MAX_HEIGHT / up)
    bottom = (
        0.15 + LEGEND_ROW * mark_legend_rows(drawing.marks, _width(across * scale) - LEFT) + _BELOW
    )
    return stack_views(views, scale, LEFT, bottom, _GAP)


def _width(across: float) -> float:
    return max(LEFT + across + _RIGHT, _MIN_WIDTH)


def _draw_background(panels: list[Panel], drawing: Drawing, description: list[str]) -> Figure:
    """Draw the still image on a page of even numbers of pixels, as films need."""
    width = _width(panels[0].width)
    lines = wrap_lines(description, width)
    height = panels[0].top + _ABOVE + LINE * len(lines)
    size = [2.0 * np.ceil(side * _DPI / 2.0) / _DPI for side in (width, height)]
    figure = Figure(figsize=(size[0], size[1]), dpi=_DPI)
    for panel in panels:
        axes = add_panel(figure, panel)
        label_flat_view(axes, panel, drawing)
    draw_title(figure, "", lines)
    return figure
