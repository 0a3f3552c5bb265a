"""Hoops that are derived and compiled when they are first asked for, as a scene of one's own is."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from hoopgen.hoop import air, court_air

from .compile import engine, find_entry, scene_store
from .engine import Engine

if TYPE_CHECKING:
    from hoopgen.derive.scenes.scene import Scene

_PRESETS = {"AIR": air.PRESETS, "COURT_AIR": court_air.PRESETS}
"""The presets, by the name of the hoop in `hoopgen` and of its scene in `hoopgen.derive`."""


@cache
def derived_hoop(name: str) -> Engine:
    """Return the engine of a hoop, compiled at its first use and then found in the cache.

    Parameters
    ----------
    name
        A key of `_PRESETS`.
    """

    def scene() -> Scene:
        try:
            from hoopgen.derive.scenes import air as scenes
        except ImportError as error:
            from hoopgen.core.extras import explain_import_error

            raise explain_import_error(error, f"hoopgen.{name}") from None
        found: Scene = getattr(scenes, name)
        return found

    there = scene_store()
    entry = find_entry(scene, f"hoopgen.{name}", there)
    rebuild = (derived_hoop, (name,))  # in another process
    presets = _PRESETS[name]
    return engine(entry, there, scene, rebuild=rebuild, has_hoop=True, presets=presets)
