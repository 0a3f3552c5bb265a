"""The real ball's scene, `COURT`, and the shots with which its C is compared."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from hoopgen.engine import verification
from hoopgen.engine.compiled_scene import generated_files, installed_library
from hoopgen.generated.numpy import court
from hoopgen.hoop.court import NBA_COURT, PAPER_COURT, PRESETS

from .engine import Engine
from .hoop import SHOTS_PER_KIND, hoop_releases

if TYPE_CHECKING:
    from hoopgen.derive.scenes.scene import Scene

# A release and the spread of its shots, by kind: x y z, vx vy vz, wx wy wz.
_KINDS = (
    # up through the ring
    ((0, 0, -0.8, 0, 0, 4.6, 0, 0, 0), (0.2, 0.2, 0.4, 0.4, 0.4, 0.7, 30, 30, 30)),
    # against the ring from below, and from the side
    ((0.4, 0, -0.5, -0.4, 0, 3.5, 0, 0, 0), (0.3, 0.6, 0.4, 0.7, 0.5, 1.0, 40, 40, 40)),
    # against the bridge from below
    ((-0.3, 0, -0.7, 0, 0, 4, 0, 0, 0), (0.1, 0.2, 0.4, 0.5, 0.6, 1.0, 40, 40, 40)),
    # from behind the board
    ((-1.1, 0, 0.2, 2.4, 0, 3, 0, 0, 0), (0.6, 1.2, 0.9, 2.4, 0.9, 2.4, 40, 40, 40)),
    # onto the board's edges
    ((-0.39, 0.6, 1.3, 0, 0, 0, 0, 0, 0), (0.2, 0.6, 0.5, 0.7, 0.7, 1.0, 40, 40, 40)),
)


def court_shots() -> list[verification.Batch]:
    """Return the shots with which the C of `COURT` is compared: the hoop's kinds, and further ones.

    They have the article's law of contact, a law with slip, and one after which balls soon roll.
    """
    apart = verification.even_numbers(SHOTS_PER_KIND, len(court.STATE))
    own = [np.asarray(centre) + np.asarray(width) * apart for centre, width in _KINDS]
    batches = verification.batches(court, np.concatenate([hoop_releases(), *own]))
    slipping = [float(NBA_COURT[name]) for name in court.PARAMETERS]
    soft = PAPER_COURT | {f"{name}_restitution": 0.2 for name in court.BODIES}
    rolling = [float(soft[name]) for name in court.PARAMETERS]
    states, _, _, longest = batches[0]
    return [*batches, (states, slipping, None, longest), (states, rolling, None, longest)]


def _scene() -> Scene:
    from hoopgen.derive.scenes import COURT as SCENE

    return SCENE


def _court() -> Engine:
    return COURT


COURT = Engine(
    court,
    find=lambda: installed_library(court, court_shots),
    sources=lambda target: generated_files(court),
    scene=_scene,
    rebuild=(_court, ()),
    has_hoop=True,
    presets=PRESETS,
    trial=court_shots,
)
"""The hoop as it stands in a gym: ring, backboard and bridge from all sides, each with its own
restitution and friction. A ball that has come up through the ring is not MADE, whatever it does
then."""
