"""Hoops that are derived and compiled when they are first asked for, as a scene of one's own is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from hoopgen.core.parameters import Parameters

from .compile import engine, find_entry, scene_store
from .engine import Engine

if TYPE_CHECKING:
    from hoopgen.derive.scenes.scene import Scene


def derived_hoop(
    name: str,
    scene: Callable[[], Scene],
    rebuild: Callable[[], Engine],
    presets: Mapping[str, Parameters[float]],
) -> Engine:
    """Return the engine of a hoop, compiled at its first use and then found in the cache.

    Parameters
    ----------
    name
        The public name, for errors.
    scene
        A function that returns the scene, which may lack what derives it.
    rebuild
        A function of a module that returns the engine in another process.
    presets
        The presets by name.
    """

    def explained() -> Scene:
        try:
            return scene()
        except ImportError as error:
            from hoopgen.core.extras import explain_import_error

            raise explain_import_error(error, name) from None

    there = scene_store()
    entry = find_entry(explained, name, there)
    return engine(entry, there, explained, rebuild=(rebuild, ()), has_hoop=True, presets=presets)
