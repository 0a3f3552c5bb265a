"""What a scene says of itself, whichever way it was given: needs SymPy, and no engine."""

from __future__ import annotations

import math
from typing import Any

from hoopgen.brief import brief
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.scenes.scene import Scene
from hoopgen.engines import Engine
from hoopgen.parameters import Table

__all__ = ["definition", "table_of", "usual_contacts"]


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


def table_of(scene: Scene) -> Table:
    """Return the parameters of a scene."""
    low = {"any": -math.inf}
    limits = {
        p.name: (low.get(p.sign, 0.0), float(p.upper))
        for p in scene.parameters
        if p.upper is not None
    }
    return Table({p.name: float(p.default) for p in scene.parameters}, limits)


def usual_contacts(scene: Scene) -> int:
    """Return the contacts with which a shot ends as capped, where nothing else is asked for."""
    return 40 if scene == HOOP else 1000
