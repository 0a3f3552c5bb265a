"""Where a bank shot touches the board."""

from __future__ import annotations

import math
from collections.abc import Mapping

from hoopgen.engines import HOOP, Engine
from hoopgen.hoop.releases import release
from hoopgen.hoop.variables import ARGUMENTS
from hoopgen.results import SURFACES
from hoopgen.simulation import simulate

__all__ = ["on_board"]

_BACKBOARD = SURFACES.index("backboard")


def on_board(
    arguments: Mapping[str, float], parameters: Mapping[str, float], scene: Engine = HOOP
) -> dict[str, float]:
    """Return where the ball of a bank shot touches the board, and where its release points.

    Parameters
    ----------
    arguments
        Of `hoopgen.release`, one number each.
    parameters
        Of the scene.
    scene
        The scene itself, with a hoop.

    Returns
    -------
    dict
        `touch_y` and `touch_z`, m, z from the ring's height; and `sight_y`, m, where the vertical
        plane of the release meets the board's front. NaN if the board is not touched first.
    """
    nowhere = {"touch_y": math.nan, "touch_z": math.nan, "sight_y": math.nan}
    if math.isnan(arguments["speed"]):
        return nowhere
    state = release(**{name: arguments[name] for name in ARGUMENTS})
    events = simulate(state, parameters, scene=scene, record=True).events
    if not len(events) or events["surface"][0] != _BACKBOARD:
        return nowhere
    # The board's normal is along x: the ball touches at its centre's y and z.
    _, y, z = events["before"][0][:3].tolist()
    ahead = -parameters["board_distance"] - state[0]
    return {"touch_y": y, "touch_z": z, "sight_y": state[1] + ahead * state[4] / state[3]}
