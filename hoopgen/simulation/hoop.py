"""The article's scene, `HOOP`, and the shots with which its C is compared."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hoopgen.engine import native, verification
from hoopgen.engine.compiled_scene import generated_files, installed_library
from hoopgen.generated.numpy import hoop
from hoopgen.hoop.presets import PRESETS

from .engine import Engine

if TYPE_CHECKING:
    from hoopgen.derive.scenes.scene import Scene

SHOTS_PER_KIND = 32
"""Number of shots of each kind."""

KINDS = (
    # a free throw, through the ring, onto it and short of it
    ((4.19, 0, -0.61, -4.5, 0, 5.577, 0, 19, 0), (0, 0, 0, 0.3, 0.1, 0.3, 2, 8, 2)),
    # a bank shot, 45 degrees from the side
    ((2.1, 2.1, -0.85, -3.2, -2.4, 5.6, 3, 4, 0), (0, 0, 0, 0.5, 0.5, 0.4, 9, 9, 9)),
    # a swirl
    ((0.2286, -0.945, -0.61, -0.838, 2.134, 3.856, 0, 0, 1), (0, 0, 0, 4e-3, 9e-3, 1e-2, 0, 0, 2)),
    # dropped onto the ring
    ((0, 0, 1.1, 0, 0, 0, 0, 0, 0), (0.7, 0.7, 1.8, 0.6, 0.6, 0.6, 40, 40, 40)),
    # dropped onto the bridge
    ((-0.247, 0, 0.36, 0, 0, 0, 0, 0, 0), (0.03, 0.16, 0.46, 0.6, 0.6, 2, 9, 9, 9)),
    # over the board from behind
    ((-1.2, 0, 0.1, 2.2, 0, 4, 0, 0, 0), (1.4, 1, 1.8, 3.4, 0.6, 3, 0, 0, 0)),
    # a side of the backboard
    ((1, 0.9, 0.2, -2.5, 0, 3, 0, 0, 0), (0, 0.2, 0.8, 1, 0.2, 2, 30, 30, 30)),
    # from anywhere
    ((0.7, 0, 0.2, 0, 0, 2, 0, 0, 0), (4, 3, 2.5, 9, 9, 9, 60, 60, 60)),
)
"""A release and the spread of its shots, by kind: x y z, vx vy vz, wx wy wz."""


def hoop_releases(each: int = SHOTS_PER_KIND) -> NDArray[np.float64]:
    """Return releases that meet all that a hoop has, as many of each kind, (n, 9)."""
    apart = verification.even_numbers(each, len(hoop.STATE))
    kinds = [np.asarray(centre) + np.asarray(width) * apart for centre, width in KINDS]
    return np.concatenate(kinds)


def hoop_shots() -> list[verification.Batch]:
    """Return the shots with which the hoop's C is compared."""
    return verification.batches(hoop, hoop_releases())


def hoop_library(path: Path | None = None) -> native.Library | native.Rejection:
    """Return the hoop's C engine, or why it cannot be trusted.

    Parameters
    ----------
    path
        The shared library; by default the installed one.
    """
    return installed_library(hoop, hoop_shots, path)


def _hoop_scene() -> Scene:
    from hoopgen.derive.scenes import HOOP as SCENE

    return SCENE


def _hoop() -> Engine:
    return HOOP


HOOP = Engine(
    hoop,
    find=hoop_library,
    sources=lambda target: generated_files(hoop),
    scene=_hoop_scene,
    max_contacts=40,
    time_limit=math.inf,
    rebuild=(_hoop, ()),
    has_hoop=True,
    presets=PRESETS,
    trial=hoop_shots,
)
"""The article's scene."""
