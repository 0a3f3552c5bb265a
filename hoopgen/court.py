"""The real ball's scene, `COURT`: the hoop as it stands in a gym, and its presets.

What a preset takes from rule books is said beside it; what nobody has measured well is a guess, and
is called one.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from hoopgen.generated.numpy import court

from .engine import trust
from .engines import EACH, Engine, hoop_releases, installed_library, printed
from .hoop.presets import FIBA, NBA
from .parameters import Parameters

if TYPE_CHECKING:
    from .derive.scenes.scene import Scene

__all__ = ["COURT", "FIBA_COURT", "NBA_COURT", "PAPER_COURT", "PRESETS", "court_shots"]

# A release, and how far its shots lie apart, by kind: x y z, vx vy vz, wx wy wz.
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


def court_shots() -> list[trust.Batch]:
    """Return the shots with which its C is compared: the hoop's kinds, and those of its own.

    With the article's law, with one that slips, and with one after which balls soon roll.
    """
    apart = trust.spread(EACH, len(court.STATE))
    own = [np.asarray(centre) + np.asarray(width) * apart for centre, width in _KINDS]
    batches = trust.batches(court, np.concatenate([hoop_releases(), *own]))
    slipping = [float(NBA_COURT[name]) for name in court.PARAMETERS]
    soft = PAPER_COURT | {f"{name}_restitution": 0.2 for name in court.BODIES}
    rolling = [float(soft[name]) for name in court.PARAMETERS]
    states, _, _, longest = batches[0]
    return [*batches, (states, slipping, None, longest), (states, rolling, None, longest)]


def _scene() -> Scene:
    from .derive.scenes import COURT as SCENE

    return SCENE


def _again() -> Engine:
    return COURT


COURT = Engine(
    court,
    find=lambda: installed_library(court, court_shots()),
    sources=lambda: printed(court),
    scene=_scene,
    again=(_again, ()),
    has_hoop=True,
)
"""The hoop as it stands in a gym: ring, backboard and bridge from all sides, each with its own
restitution and friction. A ball that has come up through the ring is not MADE, whatever it does
then."""


def _real(sizes: Mapping[str, Any], **own: float) -> Parameters:
    """Return a preset of a real ball; what is not its own is in every one.

    Restitution e0 is that without speed: at 4 m/s, with 40 m/s for v0, it is a tenth less.
    """
    given = {name: value for name, value in sizes.items() if name in PAPER_COURT}
    usual = {
        # Drops on hard floors, 0.85 at 2.9 m/s and 0.81 at 5.07 m/s, give 0.912 and 40 m/s.
        "restitution_speed": 40.0,
        # A guess: a board gives way more than a floor does.
        "backboard_restitution": 0.85,
        # A guess, from rim testers: a rim takes 35 to 50 % of the energy; a bridge is taken alike.
        "ring_restitution": 0.65,
        "bridge_restitution": 0.65,
        # A guess: 0.1 to 0.2 is the order of what balls that grip give back.
        "tangential_restitution": 0.15,
        # A guess: how deep the bracket behind the ring is.
        "bridge_depth": 0.12,
    }
    return PAPER_COURT | given | usual | own


def _rough(friction: float) -> dict[str, float]:
    return {f"{name}_friction": friction for name in court.BODIES}


PAPER_COURT = COURT.parameters
"""The article's sizes and its law on the whole hoop: every contact grips and leaves the ball
rolling, with a restitution of 0.7. The board's thickness is half an inch, the bridge's depth a
guess."""

NBA_COURT = _real(
    NBA,
    board_thickness=0.0127,  # half an inch of tempered glass
    **_rough(0.5),  # a guess: leather on glass and painted steel, 0.4 to 0.6
)
"""NBA rule book, half an inch of glass, and a restitution that falls with speed as measured on hard
floors. Guesses: restitutions (board 0.85, ring and bridge 0.65), friction (0.5, for leather),
tangential restitution (0.15) and the bridge's depth (0.12 m)."""

FIBA_COURT = _real(
    FIBA,
    board_thickness=0.0127,  # a guess: as thick as the NBA's
    **_rough(0.7),  # a guess: composite leather, 0.6 to 0.9
)
"""FIBA equipment rules, middle of the tolerances; else as `NBA_COURT`, with its guesses, one more
for the board's thickness (0.0127 m), and friction 0.7, a guess for composite leather."""

PRESETS: Mapping[str, Parameters] = MappingProxyType(
    {"paper": PAPER_COURT, "nba": NBA_COURT, "fiba": FIBA_COURT}
)
"""By the names of the hoop's presets that they correspond to."""
