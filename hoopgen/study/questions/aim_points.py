"""The points at which bank shots touch the board."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from hoopgen.hoop.releases import release
from hoopgen.hoop.variables import ARGUMENTS
from hoopgen.results.shots import SURFACES, Outcome
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.hoop import HOOP
from hoopgen.simulation.simulate import simulate
from hoopgen.study.jobs.objective import Player

_BACKBOARD = SURFACES.index("backboard")

_WITHIN = 0.9
"""Share of the made shots that a window holds, each way."""

_THROWN = 2_000
"""Shots whose contacts are looked at, at most: enough for two digits of a window."""

NOWHERE: Mapping[str, float] = dict.fromkeys(
    ("touch_y_low", "touch_y_high", "touch_z_low", "touch_z_high"), math.nan
)
"""The window of a shot that is not there."""


def on_board(
    arguments: Mapping[str, float], parameters: Mapping[str, float], scene: Engine = HOOP
) -> dict[str, float]:
    """Return the place on the board that a bank shot touches, and the direction of its release.

    Parameters
    ----------
    arguments
        Of `hoopgen.release`, one number each.

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


def window(
    player: Player, values: Mapping[str, float], shots: int, seed: int = 0
) -> dict[str, float]:
    """Return within which ends nine tenths of a player's made bank shots touch the board.

    Parameters
    ----------
    shots, seed
        How many are thrown, of which the first 2,000 are looked at, and which.

    Returns
    -------
    dict
        `touch_y_low`, `touch_y_high`, `touch_z_low` and `touch_z_high`, m, as of `on_board`: the
        twentieth parts left out are below and above, in y and in z each. NaN if none is made.
    """
    many = min(shots, _THROWN)
    releases = player.model.around(
        {name: np.full((1, 1), value) for name, value in values.items()},
        player.model.noise(0, many, seed),
        player.parameters,
        many,
    )
    recorded = simulate(
        releases.states, releases.parameters, scene=player.scene, threads=1, record=True
    )
    shot, row = np.unique(recorded.events["shot"], return_index=True)
    good = (recorded.outcome[shot] == Outcome.MADE) & (recorded.first[shot] == _BACKBOARD)
    touches = recorded.events["before"][row[good], 1:3]
    if not len(touches):
        return dict(NOWHERE)
    outside = (1.0 - _WITHIN) / 2.0
    ends = np.quantile(touches, [outside, 1.0 - outside], axis=0)
    return dict(zip(NOWHERE, ends.T.ravel().tolist(), strict=True))
