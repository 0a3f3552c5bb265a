"""The article's hoop in air, `AIR`, which is derived and compiled when it is first asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING

from hoopgen.hoop.air import PRESETS

from .compile import engine, find_entry, scene_store
from .engine import Engine

if TYPE_CHECKING:
    from hoopgen.derive.scenes.scene import Scene

__all__ = ["AIR"]


def _scene() -> Scene:
    try:
        from hoopgen.derive.scenes.air import AIR as SCENE
    except ImportError as error:
        from hoopgen.core.extras import explain_import_error

        raise explain_import_error(error, "hoopgen.AIR") from None
    return SCENE


def _air() -> Engine:
    return AIR


def _made() -> Engine:
    there = scene_store()
    entry = find_entry(_scene, "hoopgen.AIR", there)
    return engine(entry, there, _scene, rebuild=(_air, ()), has_hoop=True, presets=PRESETS)


AIR = _made()
"""The article's hoop, and a ball that flies through air: drag, buoyancy and the Magnus force of its
spin. It is kept as a scene of one's own is: compiled once in half a minute, then found."""
