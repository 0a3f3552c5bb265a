"""The map of first contacts of Okubo and Hubbard: what free throws touch first, and what follows.

Speed and angle of the release are theirs, the throw goes straight at the basket.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

import hoopgen
from benchmarks.free_throw import LINE
from hoopgen import COURT, NBA_COURT
from hoopgen.core.units import DEGREE
from hoopgen.plots.style import COLOURS, DARK, MADE, NOTE_SIZE, PAGE, style

Floats = NDArray[np.float64]

SPEEDS, ANGLES = (7.0, 8.0), (45.0, 65.0)
"""m/s and degrees."""

NAMES = ("nothing", "front of the ring", "back of the ring", "backboard", "bridge")
"""Names of what the ball may touch first."""

_COLOURS = ("#F2F2F2", "#F3B27E", COLOURS["ring"], "#A9B8C6", COLOURS["bridge"])
_DISTANCES, _STAYS = "YlOrRd", "white"


@dataclass(frozen=True)
class Contacts:
    """A grid of free throws.

    Attributes
    ----------
    speed, angle
        m/s and degrees, of the columns and of the rows.
    first
        Places in `NAMES`, (angles, speeds).
    made
        Which go in.
    landing
        Where the ball comes to the floor, m from the ring's centre towards the shooter; NaN of
        those that go in or stay.
    """

    speed: Floats
    angle: Floats
    first: NDArray[np.int64]
    made: NDArray[np.bool_]
    landing: Floats

    def shares(self) -> Mapping[str, float]:
        """Return the share of the box by what is touched first."""
        return {name: float(np.mean(self.first == k)) for k, name in enumerate(NAMES)}

    def ends(self) -> tuple[float, float]:
        """Return the least and the largest landing of the misses that touch something."""
        own = self.landing[self.first > 0]
        return float(np.nanmin(own)), float(np.nanmax(own))


PICTURE = [
    "Okubo and Hubbard's map, with our free throw: at left what the ball touches first, at right "
    "what goes in and where misses come down. Here x is measured on the floor from below the "
    "ring's centre towards the shooter. All throws go straight at the basket, so rebounds come "
    "straight back.",
    "",
    "![What a free throw touches first, and what becomes of it, over release speed and release "
    "angle](validation-contacts.svg)",
    "",
]
"""The picture on the page, and what is said of it."""


def first_contacts(cells: int = 401) -> Contacts:
    """Fly a grid of free throws with the NBA's sizes in `COURT`, of so many speeds and angles."""
    speed, angle = np.linspace(*SPEEDS, cells), np.linspace(*ANGLES, cells)
    across, up = np.meshgrid(speed, angle)
    states = hoopgen.release(across.ravel(), up.ravel() * DEGREE, **LINE)
    fields = ("outcome", "first", "state", "time", "contacts", "counts")
    shots = hoopgen.simulate(states, NBA_COURT, scene=COURT, fields=fields)
    log: Any = hoopgen.simulate(states, NBA_COURT, scene=COURT, max_contacts=1, record=True).events
    place = np.full(len(states), np.nan)
    touching, row = np.unique(log["shot"], return_index=True)
    place[touching] = log["before"][row, 0]
    ring, board, bridge = map(COURT.surfaces.index, ("ring", "backboard", "bridge"))
    on_ring, front = shots.first == ring, place > 0.0
    hit = [shots.first == -1, on_ring & front, on_ring & ~front]
    hit += [shots.first == board, shots.first == bridge]
    landing = hoopgen.measure(states, shots, NBA_COURT, ("floor_x",))["floor_x"]
    made = np.asarray(shots.made)
    shape = across.shape
    return Contacts(
        speed,
        angle,
        np.argmax(hit, axis=0).reshape(shape),
        made.reshape(shape),
        np.where(made, np.nan, landing).reshape(shape),
    )


def picture(found: Contacts) -> Figure:
    """Draw what is touched first, and beside it what goes in and where misses come down."""
    image: Mapping[str, Any] = {
        "origin": "lower",
        "extent": (*SPEEDS, *ANGLES),
        "interpolation": "nearest",
        "aspect": "auto",
    }
    with style():
        figure = Figure(figsize=(PAGE, 3.5), layout="constrained")
        left, right = figure.subplots(1, 2, sharey=True)
        left.imshow(found.first, cmap=ListedColormap(_COLOURS), vmin=-0.5, vmax=4.5, **image)
        left.contour(found.speed, found.angle, found.made, [0.5], colors=DARK, linewidths=0.5)
        right.imshow(found.made, cmap=ListedColormap([_STAYS, MADE["swish"]]), **image)
        drawn = right.imshow(np.ma.masked_invalid(found.landing), cmap=_DISTANCES, **image)
        bar = figure.colorbar(drawn, ax=right, pad=0.02)
        bar.set_label("a miss reaches the floor at x (m)")
        for axes, title in ((left, "Touched first"), (right, "What becomes of them")):
            axes.set(xlabel="release speed (m/s)", yticks=np.arange(45, 66, 5))
            axes.set_title(title, loc="left")
        left.set_ylabel("release angle (°)")
        for at, up, word, turn in ((7.11, 62.5, "too short", 0), (7.165, 52.0, "swishes", 90)):
            left.text(at, up, word, rotation=turn, ha="center", va="center", fontsize=NOTE_SIZE)
        edge: Mapping[str, Any] = {"ec": DARK, "lw": 0.5}
        swatches = [
            *(Patch(fc=c, label=n, **edge) for n, c in zip(NAMES, _COLOURS, strict=True)),
            Line2D([], [], color=DARK, lw=0.5, label="outline of what goes in"),
            Patch(fc=MADE["swish"], label="goes in", **edge),
            Patch(fc=_STAYS, label="stays on the hoop", **edge),
        ]
        figure.legend(handles=swatches, loc="outside lower center", ncols=4, frameon=False)
    return figure
