"""Definitions of scenes for derivation and the judge; SymPy is needed, an engine is not."""

from __future__ import annotations

import math
from collections.abc import Mapping
from os import PathLike

from hoopgen.core.parameters import Table
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.scenes.scene import Scene
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.text.shorten import brief

from . import scene as pieces
from .lookup import SceneLike


def definition(scene: SceneLike) -> Scene:
    """Return the scene for derive/; the hoop for None.

    Raises
    ------
    TypeError
        If it is no scene.
    """
    if scene is None:
        return HOOP
    if isinstance(scene, CompiledScene):
        return scene.scene
    derive = getattr(scene, "derive", None)
    derived = derive() if callable(derive) and not isinstance(scene, type) else scene
    if not isinstance(derived, Scene):
        raise TypeError(
            "scene: expected None, a scene, or what hoopgen.compile returns; got "
            f"{brief(scene)}{_hint(scene)}"
        )
    return derived


def _hint(scene: object) -> str:
    """Return the way to give a scene, for a text, a path or parameters given in its place."""
    if isinstance(scene, Mapping):
        return "; give parameters, such as hoopgen.NBA, as parameters="
    if isinstance(scene, PathLike) or (isinstance(scene, str) and scene.endswith(".toml")):
        return "; hoopgen.load_scene reads a file"
    if not isinstance(scene, str):
        return ""
    return (
        "; scenes are hoopgen.HOOP, COURT, AIR, COURT_AIR; parameters=hoopgen.NBA or FIBA is a hoop"
    )


def table_of(scene: SceneLike, derived: Scene) -> Table:
    """Return the parameters of a scene.

    Parameters
    ----------
    scene, derived
        As it was given, and what `definition` makes of it.
    """
    if isinstance(scene, CompiledScene):
        return scene.table
    limits = {
        p.name: (float(p.least), float(p.upper)) for p in derived.parameters if p.upper is not None
    }
    taken = {p.name: float(p.default) for p in derived.parameters}
    return Table.from_defaults(taken, limits, scene if isinstance(scene, pieces.Scene) else None)


def default_max_contacts(scene: Scene) -> int:
    """Return the default number of contacts at which a shot is capped."""
    return 40 if scene == HOOP else 1000


def default_time_limit(scene: Scene) -> float:
    """Return the default time limit of a shot, s."""
    return math.inf if scene == HOOP else 60.0
