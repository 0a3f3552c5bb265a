"""The hoop of a gym in air, `COURT_AIR`, which is derived and compiled at its first use."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hoopgen.hoop.court_air import PRESETS

from .derived_hoop import derived_hoop
from .engine import Engine

if TYPE_CHECKING:
    from hoopgen.derive.scenes.scene import Scene


def _scene() -> Scene:
    from hoopgen.derive.scenes.air import COURT_AIR as SCENE

    return SCENE


def _court_air() -> Engine:
    return COURT_AIR


COURT_AIR = derived_hoop("hoopgen.COURT_AIR", _scene, _court_air, PRESETS)
"""The hoop as it stands in a gym, and a ball that flies through air. Rolls take no force of the air
along the surface: `Shots.airless_rolls` marks their shots. It is compiled once, then found."""
