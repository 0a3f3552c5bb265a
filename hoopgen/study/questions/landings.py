"""The places where a player's missed shots come down: on the floor, or where they are caught."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.variables import Releases
from hoopgen.results.shots import Outcome, Shots
from hoopgen.study.measures.measures import measure
from hoopgen.study.measures.rebounds import CATCHING_HEIGHT


@dataclass(frozen=True)
class Landings:
    """Places where missed shots come down.

    Attributes
    ----------
    x, y
        Of the ball's centre, (n,), m from the ring's centre; NaN of a miss that never gets there.
    """

    x: NDArray[np.float64]
    y: NDArray[np.float64]
    place: tuple[float, float]  # where the shots are released in the mean, x and y, m
    height: float | None  # at which they are caught, m above the floor; None on the floor
    shots: Shots  # of which these are the misses

    @property
    def away(self) -> NDArray[np.float64]:
        """Distances from the point below the ring's centre at which balls come down, m."""
        away = np.hypot(self.x, self.y)
        return np.asarray(away[np.isfinite(away)])

    @property
    def seen(self) -> dict[str, Any]:
        """Options of `hoopgen.plots.plot_landings`, beside the places and the parameters."""
        return {"place": self.place, "height": self.height, "scene": self.shots.scene}


def landings_of(released: Releases, shots: Shots, height: float | None = None) -> Landings:
    """Return the places where missed shots come down; `height` None is the floor.

    Parameters
    ----------
    released
        The releases of the shots.
    shots
        Their results.
    height
        Where the ball's centre is when it is caught, m above the floor.
    """
    where = "floor" if height is None else "rebound"
    names = (f"{where}_x", f"{where}_y")
    caught = CATCHING_HEIGHT if height is None else height
    there = measure(released.states, shots, released.parameters, names, catching_height=caught)
    x, y = (there[name][shots.outcome == Outcome.MISSED] for name in names)
    place = released.states[:, :2].mean(axis=0)
    return Landings(x, y, (float(place[0]), float(place[1])), height, shots)
