"""Presets of `AIR`, the article's hoop in air.

A comment beside each value names its source; values without a good measurement are marked as
guesses.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from hoopgen.core.parameters import AIR_DEFAULTS, THIN_SHELL, Parameters

from .presets import FIBA, NBA, PAPER

PAPER_AIR = Parameters({**PAPER, "inertia": THIN_SHELL, **AIR_DEFAULTS})
"""`PAPER` in air of 1.2 kg/m³, that of 20 °C at sea level, with the article's thin shell as the
ball. The mass is 22 oz, the rule books' largest. C_d 0.5 lies in the literature's 0.45 to 0.54; C_m
0.6 is a guess from Magnus forces of other balls."""

NBA_AIR = Parameters({**PAPER_AIR, **NBA, "ball_mass": 0.595})
"""`NBA` in that air; the rule book's 20 to 22 oz, in the middle."""

FIBA_AIR = Parameters({**PAPER_AIR, **FIBA, "ball_mass": 0.600})
"""`FIBA` in that air; the equipment rules' 580 to 620 g, in the middle."""

PRESETS: Mapping[str, Parameters[float]] = MappingProxyType(
    {"paper": PAPER_AIR, "nba": NBA_AIR, "fiba": FIBA_AIR}
)
"""Presets of `AIR` by the names of the corresponding presets of the hoop."""
