"""What is drawn for orientation alone: the net, and the court's lines. Nothing simulates them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.hoop.courts import COURTS, court_of, lines_of
from hoopgen.hoop.releases import RING_HEIGHT
from hoopgen.results import Shots

__all__ = ["ghost"]

_LOOPS = 12  # by which a net hangs, in both rule books
_ROWS = 5
_LENGTH = 0.43  # m; 0.40 to 0.45 in both
_WAIST = 0.62  # of the ring's radius: a guess, as nets differ


def ghost(shots: Shots, parameters: Mapping[str, Any]) -> dict[str, Any] | None:
    """Return a net and a court's lines, points (x, y, z) in metres; None if there is no hoop.

    Of parameters that differ from shot to shot, the mean is drawn.
    """
    if not shots.scene.has_hoop:
        return None
    own = {name: float(np.mean(value)) for name, value in parameters.items()}
    court = court_of(own)
    lines = lines_of(COURTS[court], own["board_distance"]).values()
    floor = [np.column_stack([line, np.full(len(line), -RING_HEIGHT)]) for line in lines]
    net = _net(own["ring_radius"], own["wire_radius"])
    return {"court": court, "lines": _rounded(floor), "net": _rounded(net)}


def _net(radius: float, wire: float) -> list[NDArray[np.float64]]:
    """Return the cords of a net under a ring: from each loop one to either side."""
    down = np.linspace(0.0, 1.0, _ROWS + 1)
    wide = radius * (1.0 - (1.0 - _WAIST) * np.sin(np.pi / 2.0 * down))
    step = np.pi / _LOOPS * np.arange(_ROWS + 1)
    z = -wire - _LENGTH * down
    loops = 2.0 * np.pi / _LOOPS * np.arange(_LOOPS)
    turns = [loop + way * step for loop in loops for way in (1.0, -1.0)]
    return [np.stack([wide * np.cos(turn), wide * np.sin(turn), z], axis=1) for turn in turns]


def _rounded(lines: list[NDArray[np.float64]]) -> list[Any]:
    """Return points to the millimetre, which is finer than any of this is known."""
    return [np.round(line, 3).tolist() for line in lines]
