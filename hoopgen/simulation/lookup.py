"""Scenes by name or file, and the engine of any scene."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

from hoopgen.scene.files import load_scene
from hoopgen.scene.lookup import SceneLike
from hoopgen.scene.scene import Scene
from hoopgen.text.shorten import brief, join_names

from .engine import Engine
from .hoop import HOOP


def _court() -> Engine:
    from .court import COURT  # whose kernels are many

    return COURT


def _air() -> Engine:
    from .air import AIR  # which is compiled when it is first asked for

    return AIR


def _court_air() -> Engine:
    from .court_air import COURT_AIR

    return COURT_AIR


BUILT_IN: Mapping[str, Callable[[], Engine]] = MappingProxyType(
    {"hoop": lambda: HOOP, "court": _court, "air": _air, "court-air": _court_air}
)
"""Functions that return the scenes of hoopgen, by the names on the command line and in files."""

SUFFIX = ".toml"
"""Suffix of the name of a scene file."""


def is_built_in(text: str) -> bool:
    """Return whether a text names a scene that comes with hoopgen; else it names a file.

    Raises
    ------
    ValueError
        If it names neither.
    """
    if text in BUILT_IN:
        return True
    if Path(text).suffix.lower() != SUFFIX:
        raise ValueError(
            f"expected {join_names(BUILT_IN)}, or a scene file, {SUFFIX}; got {brief(text)}"
        )
    return False


def scene_from(text: str, folder: Path | None = None) -> Engine | Scene:
    """Return the scene with a name or in a scene file.

    The file is data: nothing in it is run. Its scene is not compiled yet; see `engine_of`.

    Parameters
    ----------
    text
        A key of `BUILT_IN`, or a file whose name ends in ``.toml``.
    folder
        Folder that the path of the file is relative to.

    Raises
    ------
    ValueError
        If it is neither, or the file does not describe a scene.
    OSError
        If the file cannot be read.
    """
    if is_built_in(text):
        return BUILT_IN[text]()
    return load_scene((folder or Path()) / text)


def engine_of(scene: SceneLike) -> Engine:
    """Return the engine of a scene; a scene of one's own is compiled. None is the article's hoop.

    Raises
    ------
    TypeError, ValueError, ImportError
        As of `hoopgen.compile`.
    """
    if scene is None:
        return HOOP
    if isinstance(scene, Engine):
        return scene
    from .compile import compile  # runs compilers, which the hoop never needs

    return compile(scene)
