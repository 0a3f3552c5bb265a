"""The scene in air, which flies releases that are aimed; the root package registers it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from .parameters import Value


class FlyingScene(Protocol):
    """A compiled scene, of which free flights are needed."""

    @property
    def parameters(self) -> Mapping[str, float]:
        """Default value of each parameter; SI units."""
        ...

    def fly(
        self, times: ArrayLike, states: NDArray[np.float64], parameters: Mapping[str, Value]
    ) -> NDArray[np.float64]:
        """Return the states after free flights, as `CompiledScene.fly`."""
        ...

    def fall(
        self, states: NDArray[np.float64], level: ArrayLike, parameters: Mapping[str, Value]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return when balls come down to a height, and their states, as `CompiledScene.fall`."""
        ...


_FINDERS: list[Callable[[], FlyingScene]] = []


def register_air(find: Callable[[], FlyingScene]) -> None:
    """Register `find`, which returns the article's hoop in air, compiled when that is needed."""
    _FINDERS[:] = [find]


def air_scene() -> FlyingScene:
    """Return the article's hoop in air.

    Raises
    ------
    ImportError
        If what derives it is missing, and it was not compiled before.
    """
    (find,) = _FINDERS
    return find()
