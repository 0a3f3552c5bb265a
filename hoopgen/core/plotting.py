"""The pictures that results can draw of themselves; the root package registers who draws them."""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType

_LOADERS: list[Callable[[], ModuleType]] = []


def register_plotting(load: Callable[[], ModuleType]) -> None:
    """Register `load`, which returns the module that draws results; pictures call it."""
    _LOADERS[:] = [load]


def plotting_module() -> ModuleType:
    """Return the module that draws results, `hoopgen.plots`.

    Raises
    ------
    ImportError
        If matplotlib is missing.
    """
    (load,) = _LOADERS
    return load()
