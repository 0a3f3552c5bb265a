"""Presets of `COURT`, the hoop as it stands in a gym.

A comment beside each value names the rule book or the measurement; values without a good
measurement are marked as guesses.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from hoopgen.core.parameters import Parameters, Table
from hoopgen.generated.numpy import court

from .presets import FIBA, NBA

PAPER_COURT = Parameters(Table.from_kernels(court).defaults)
"""The article's sizes and its law on the whole hoop: every contact grips and leaves the ball
rolling, with a restitution of 0.7. The board's thickness is half an inch, the bridge's depth a
guess."""


def _real(sizes: Mapping[str, float], **own: float) -> Parameters[float]:
    """Return a preset of a real ball: usual values of a real ball, and those that are given.

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

PRESETS: Mapping[str, Parameters[float]] = MappingProxyType(
    {"paper": PAPER_COURT, "nba": NBA_COURT, "fiba": FIBA_COURT}
)
"""Presets of `COURT` by the names of the corresponding presets of the hoop."""
