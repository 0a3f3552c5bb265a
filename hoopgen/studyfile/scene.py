"""The scene of a study file, and the kinds of values that depend on it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import Any

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, core_schema

from hoopgen.core.units import Kind
from hoopgen.core.variables import STATE
from hoopgen.hoop.court_places import PLACES, find_place
from hoopgen.hoop.variables import ARGUMENTS, VARIABLES
from hoopgen.scene.lookup import variables_of
from hoopgen.simulation.hoop import HOOP
from hoopgen.study.questions import values as kinds
from hoopgen.study.questions.values import Choice, Listed, Quantity, Success, Text, Value

from .fields import Ends, Named, OneOf, Values

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
    """Return the scene entry of a study file; None if it names no scene."""
    given = document.get("scene")
    return given.get(FILE) if isinstance(given, dict) else given


def _own() -> tuple[str, ...]:
    return tuple(_SCENE.get().table.defaults)


def varying() -> tuple[str, ...]:
    """Return the variables that may be mapped and searched over."""
    return tuple(variables_of(_SCENE.get()))


def releasing() -> tuple[str, ...]:
    """Return the variables of a release: where there is no hoop, the components of a state."""
    return tuple(name for name in varying() if name not in _own())


def release_keys() -> tuple[str, ...]:
    """Return the keys of a table `release`: its variables, and where there is a hoop a place."""
    return (*releasing(), *(("place",) if _SCENE.get().has_hoop else ()))


class PlaceName(Text):
    """The name of a place of the court."""

    def __init__(self) -> None:
        super().__init__(words=f"a place: {', '.join(PLACES)}; left or right before some")

    def read(self, given: Any) -> str:
        """Return the name."""
        name = super().read(given)
        try:
            find_place(name)
        except ValueError as error:
            raise ValueError(str(error).removeprefix("place: ")) from None
        return name


def release_value(name: str) -> Value:
    """Return the kind of values of a key of a table `release`."""
    return PlaceName() if name == "place" else quantity(name)


def scattering() -> tuple[str, ...]:
    """Return the variables that may scatter."""
    return (*(ARGUMENTS if _SCENE.get().has_hoop else STATE), *_own())


def scene_keys() -> tuple[str, ...]:
    """Return the keys of a table `scene`: preset or file, and parameters."""
    return (*(("preset",) if _SCENE.get().presets else ()), FILE, *_own())


def kind_of(name: str) -> Kind:
    """Return the kind of quantity of a variable."""
    return variables_of(_SCENE.get())[name].kind


def may_be_infinite(name: str) -> bool:
    """Return whether a variable may be infinite."""
    return variables_of(_SCENE.get())[name].infinite


def limits_of(name: str) -> tuple[float, float]:
    """Return the least and the largest value that a variable may have."""
    limits: tuple[float, float] = _SCENE.get().table.limits.get(name, (-math.inf, math.inf))
    return limits


class Varying(Choice):
    """The name of a variable of the scene."""

    def read(self, given: Any) -> str:
        """Return the name."""
        return Choice(varying()).read(given)


class SuccessInScene(Success):
    """The shots that count or, where there is no hoop, an end, of which "any" is the first."""

    def read(self, given: Any) -> str:
        """Return the kind of shots, or the end."""
        scene = _SCENE.get()
        return Choice(self.allowed if scene.has_hoop else ("any", *scene.kernels.ENDS)).read(given)


@dataclass(frozen=True)
class InScene(Value):
    """A table `scene`; or a text, which stands for one with a file alone."""

    table: Named

    @property
    def words(self) -> str:
        """The allowed values."""
        return f"{self.table.words}; or a scene's name, or that of its file"

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        table = self.table.__get_pydantic_core_schema__(None, handler)
        return core_schema.no_info_before_validator_function(
            lambda given: {FILE: given} if isinstance(given, str) else given, table
        )


def quantity(name: str) -> Quantity:
    """Return the kind of a variable's values, within its limits."""
    return Quantity(kind_of(name), *limits_of(name), may_be_infinite(name))


def deviation(name: str) -> Quantity:
    """Return the kind of a variable's standard deviations."""
    return Quantity(kind_of(name), 0.0)


def correlations(_: str) -> Named:
    """Return the kind of a variable's correlations, with others that scatter."""
    return Named(scattering, lambda _: Quantity("number", -1.0, 1.0))


def scene_or_size(name: str) -> Value:
    """Return the kind of a scene's values: a scene, a preset, or a size."""
    if name == FILE:
        return Text(words="a scene's name, or that of a scene file")
    return Choice(tuple(_SCENE.get().presets)) if name == "preset" else quantity(name)


def _values_of(name: str) -> Values:
    return Values(kind_of(name), may_be_infinite(name))


class _Search(OneOf):
    """Variables to search over: their names alone are searched within their usual bounds."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return core_schema.no_info_after_validator_function(
            lambda read: dict.fromkeys(read) if isinstance(read, list) else read,
            super().__get_pydantic_core_schema__(source, handler),
        )


_READ: Mapping[Value, Value] = {
    kinds.AXES: Named(varying, _values_of, least=1),
    kinds.BOUNDS: _Search(
        Listed(Varying(tuple(VARIABLES)), 1),
        Named(varying, lambda name: Ends(kind_of(name)), least=1),
    ),
    kinds.DEVIATIONS: Named(scattering, deviation),
    kinds.PLACES: Named(("distance", "angle", "x", "y"), _values_of, least=2),
}


def in_file(value: Any) -> Any:
    """Return the kind of values as a study file writes them."""
    if isinstance(value, kinds.Quantities):
        return Values(value.kind)
    if isinstance(value, kinds.Success):
        return SuccessInScene(value.allowed)
    return _READ.get(value, value) if isinstance(value, kinds.Notation) else value
