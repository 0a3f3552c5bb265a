"""Presets of `COURT_AIR`, the hoop as it stands in a gym, in air.

They are those of `COURT` with the air of the presets of `AIR`, where their sources are named.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from hoopgen.core.parameters import AIR_DEFAULTS, Parameters

from .air import FIBA_AIR, NBA_AIR, PAPER_AIR
from .court import FIBA_COURT, NBA_COURT, PAPER_COURT


def _in_air(court: Mapping[str, float], air: Mapping[str, float]) -> Parameters[float]:
    """Return the parameters of a gym's hoop with the air's of another preset."""
    return Parameters({**court, **{name: air[name] for name in AIR_DEFAULTS}})


PAPER_COURT_AIR = _in_air(PAPER_COURT, PAPER_AIR)
"""`PAPER_COURT` in the air of `PAPER_AIR`."""

NBA_COURT_AIR = _in_air(NBA_COURT, NBA_AIR)
"""`NBA_COURT` in the air of `NBA_AIR`, with the guesses of both."""

FIBA_COURT_AIR = _in_air(FIBA_COURT, FIBA_AIR)
"""`FIBA_COURT` in the air of `FIBA_AIR`, with the guesses of both."""

PRESETS: Mapping[str, Parameters[float]] = MappingProxyType(
    {"paper": PAPER_COURT_AIR, "nba": NBA_COURT_AIR, "fiba": FIBA_COURT_AIR}
)
"""Presets of `COURT_AIR` by the names of the corresponding presets of the hoop."""
