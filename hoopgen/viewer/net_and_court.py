"""The net and the court's lines, drawn for orientation and not simulated."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.parameters import means
from hoopgen.hoop.court_lines import COURTS, court_of, lines_of
from hoopgen.hoop.releases import RING_HEIGHT
from hoopgen.results.shots import Shots

_NET_LOOPS = 12  # by which a net hangs, in both rule books
_NET_ROWS = 5
_NET_LENGTH = 0.43  # m; 0.40 to 0.45 in both
_NET_WAIST = 0.62  # of the ring's radius: a guess, as nets differ


def net_and_court(shots: Shots, parameters: Mapping[str, Any]) -> dict[str, Any] | None:
    """Return a net and a court's lines, points (x, y, z) in metres; None without a hoop.

    Of parameters that differ from shot to shot, the mean is drawn.

    Parameters
    ----------
    shots
        The shots, whose scene may have a hoop.
    parameters
        The scene's parameters.
    """
    if not shots.scene.has_hoop:
        return None
    own = means(parameters, shots.outcome != shots.scene.outcomes["INVALID"])
    court = court_of(own)
    lines = lines_of(COURTS[court], own["board_distance"]).values()
    floor = [np.column_stack([line, np.full(len(line), -RING_HEIGHT)]) for line in lines]
    net = _net(own["ring_radius"], own["wire_radius"])
    return {"court": court, "lines": _round_lines(floor), "net": _round_lines(net)}


def _net(radius: float, wire: float) -> list[NDArray[np.float64]]:
    """Return the cords of a net under a ring, one to either side from each loop."""
    down = np.linspace(0.0, 1.0, _NET_ROWS + 1)
    wide = radius * (1.0 - (1.0 - _NET_WAIST) * np.sin(np.pi / 2.0 * down))
    step = np.pi / _NET_LOOPS * np.arange(_NET_ROWS + 1)
    z = -wire - _NET_LENGTH * down
    loops = 2.0 * np.pi / _NET_LOOPS * np.arange(_NET_LOOPS)
    turns = [loop + way * step for loop in loops for way in (1.0, -1.0)]
    return [np.stack([wide * np.cos(turn), wide * np.sin(turn), z], axis=1) for turn in turns]


def _round_lines(lines: list[NDArray[np.float64]]) -> list[Any]:
    """Round points to the millimetre, which is finer than any of this is known."""
    return [np.round(line, 3).tolist() for line in lines]
