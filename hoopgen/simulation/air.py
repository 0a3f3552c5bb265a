"""The article's hoop in air, `AIR`, which is derived and compiled when it is first asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hoopgen.hoop.air import PRESETS

from .derived_hoop import derived_hoop
from .engine import Engine

if TYPE_CHECKING:
    from hoopgen.derive.scenes.scene import Scene


def _scene() -> Scene:
    from hoopgen.derive.scenes.air import AIR as SCENE

    return SCENE


def _air() -> Engine:
    return AIR


AIR = derived_hoop("hoopgen.AIR", _scene, _air, PRESETS)
"""The article's hoop, and a ball that flies through air: drag, buoyancy and the Magnus force of its
spin. It is kept as a scene of one's own is: compiled once in half a minute, then found."""
