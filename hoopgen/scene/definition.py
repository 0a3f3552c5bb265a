"""What a scene says of itself, whichever way it was given: needs SymPy, and no engine."""

from __future__ import annotations

import math
from typing import Any

from hoopgen.brief import brief
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.scenes.scene import Scene
from hoopgen.engines import Engine
from hoopgen.parameters import Table

from . import scene as pieces

__all__ = ["definition", "table_of", "usual_contacts", "usual_limit"]


def definition(scene: Any) -> Scene:
    """Return the scene as derive/ has it; of None, the hoop.

    Raises
    ------
    TypeError
        If it is no scene.
    """
    if scene is None:
        return HOOP
    if isinstance(scene, Engine):
        return scene.scene
    derive = getattr(scene, "derive", None)
    derived = derive() if callable(derive) and not isinstance(scene, type) else scene
    if not isinstance(derived, Scene):
        raise TypeError(
            f"scene: expected None, a scene, or what hoopgen.compile returns; got {brief(scene)}"
        )
    return derived


def table_of(scene: Any, derived: Scene) -> Table:
    """Return the parameters of a scene.

    Parameters
    ----------
    scene, derived
        As it was given, and what `definition` makes of it.
    """
    if isinstance(scene, Engine):
        return scene.table
    limits = {
        p.name: (float(p.least), float(p.upper)) for p in derived.parameters if p.upper is not None
    }
    taken = {p.name: float(p.default) for p in derived.parameters}
    return Table.made(taken, limits, scene if isinstance(scene, pieces.Scene) else None)


def usual_contacts(scene: Scene) -> int:
    """Return the contacts with which a shot ends as capped, where nothing else is asked for."""
    return 40 if scene == HOOP else 1000


def usual_limit(scene: Scene) -> float:
    """Return the time at which a shot ends, where nothing else is asked for, s."""
    return math.inf if scene == HOOP else 60.0
