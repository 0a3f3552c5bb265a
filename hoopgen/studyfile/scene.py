"""The scene of a study file: a name or a scene file, and what it lets the other tables say."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import Any

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, core_schema

from hoopgen.engines import HOOP
from hoopgen.hoop.variables import ARGUMENTS
from hoopgen.scenes import presets_of, variables_of
from hoopgen.units import Kind
from hoopgen.variables import STATE

from .fields import Named
from .single import Word

__all__ = [
    "FILE",
    "InScene",
    "Varying",
    "Way",
    "kind_of",
    "limits_of",
    "may_be_infinite",
    "named_by",
    "releasing",
    "scattering",
    "scene_keys",
    "varying",
    "within",
]

FILE = "file"
"""The key of a table `scene` that says what the text alone says."""

_SCENE: ContextVar[Any] = ContextVar("scene of the study that is read", default=HOOP)


@contextmanager
def within(scene: Any) -> Iterator[None]:
    """Read tables as those of a study of a scene, an `Engine`, as long as the context lasts."""
    token = _SCENE.set(scene)
    try:
        yield
    finally:
        _SCENE.reset(token)


def named_by(document: Mapping[str, Any]) -> Any:
    """Return what a study file gives for its scene; None where it names none."""
    given = document.get("scene")
    return given.get(FILE) if isinstance(given, dict) else given


def _own() -> tuple[str, ...]:
    return tuple(_SCENE.get().table.defaults)


def varying() -> tuple[str, ...]:
    """Return what may be mapped and searched over."""
    return tuple(variables_of(_SCENE.get()))


def releasing() -> tuple[str, ...]:
    """Return the variables of a release: where there is no hoop, the components of a state."""
    return tuple(name for name in varying() if name not in _own())


def scattering() -> tuple[str, ...]:
    """Return what may scatter."""
    return (*(ARGUMENTS if _SCENE.get().has_hoop else STATE), *_own())


def scene_keys() -> tuple[str, ...]:
    """Return the keys of a table `scene`: preset or file, and parameters."""
    return (*(("preset",) if presets_of(_SCENE.get()) else ()), FILE, *_own())


def kind_of(name: str) -> Kind:
    """Return what a variable measures."""
    return variables_of(_SCENE.get())[name].kind


def may_be_infinite(name: str) -> bool:
    """Return whether a variable may be infinite."""
    return variables_of(_SCENE.get())[name].infinite


def limits_of(name: str) -> tuple[float, float]:
    """Return the least and the largest value that a variable may have."""
    limits: tuple[float, float] = _SCENE.get().table.limits.get(name, (-math.inf, math.inf))
    return limits


@dataclass(frozen=True)
class Varying(Word):
    """The name of a variable of the scene."""

    def read(self, given: Any) -> str:
        """Return it."""
        return Word(varying()).read(given)


@dataclass(frozen=True)
class Way(Word):
    """What counts: a way in or, where there is no hoop, an end; "any" is the first."""

    def read(self, given: Any) -> str:
        """Return it."""
        scene = _SCENE.get()
        return Word(self.allowed if scene.has_hoop else ("any", *scene.kernels.ENDS)).read(given)


@dataclass(frozen=True)
class InScene:
    """A table `scene`; or a text, which stands for one with a file alone."""

    table: Named

    @property
    def words(self) -> str:
        """What may be given."""
        return f"{self.table.words}; or a scene's name, or that of its file"

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        table = self.table.__get_pydantic_core_schema__(None, handler)
        return core_schema.no_info_before_validator_function(
            lambda given: {FILE: given} if isinstance(given, str) else given, table
        )
