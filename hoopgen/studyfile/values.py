"""What the keys of a study file's tables may hold."""

from __future__ import annotations

from typing import Annotated, Any, TypeAlias

from pydantic import AfterValidator

from hoopgen.hoop.presets import PRESETS
from hoopgen.hoop.variables import VARIABLES
from hoopgen.study.filters import parse_conditions
from hoopgen.study.measures import MEASURES
from hoopgen.study.player import BY
from hoopgen.study.rebounds import check_height
from hoopgen.study.tables import FORMATS

from .fields import Each, Ends, Listed, Named, OneOf, Values
from .scene import FILE, Varying, Way, kind_of, limits_of, may_be_infinite, scattering, varying
from .single import Quantity, Text, Truth, Whole, Word

__all__ = [
    "ByWay",
    "Columns",
    "Conditions",
    "Contacts",
    "Count",
    "File",
    "Format",
    "Height",
    "Measures",
    "Names",
    "Over",
    "Search",
    "YesNo",
    "correlations",
    "deviation",
    "quantity",
    "scene_or_size",
    "values_of",
]


def check_conditions(where: list[str]) -> list[str]:
    """Return conditions, once each is a comparison of a column with a value."""
    parse_conditions(where)
    return where


def quantity(name: str) -> Quantity:
    """Return a size of that name, within its limits."""
    return Quantity(kind_of(name), *limits_of(name), may_be_infinite(name))


def deviation(name: str) -> Quantity:
    """Return a standard deviation of it."""
    return Quantity(kind_of(name), 0.0)


def _correlation(_: str) -> Quantity:
    return Quantity("number", -1.0, 1.0)


def correlations(_: str) -> Named:
    """Return correlations with others that scatter."""
    return Named(scattering, _correlation)


def values_of(name: str) -> Values:
    """Return values of a size of that name."""
    return Values(kind_of(name), may_be_infinite(name))


def _ends(name: str) -> Ends:
    return Ends(kind_of(name))


def scene_or_size(name: str) -> Any:
    """Return a scene, a preset, or a size of a scene."""
    if name == FILE:
        return Text(said="a scene's name, or that of a scene file")
    return Word(tuple(PRESETS)) if name == "preset" else quantity(name)


_SEARCH = Named(varying, _ends, least=1)
_SEARCHED = OneOf(Listed(Varying(tuple(VARIABLES)), 1), _SEARCH)


def _search(given: Any) -> Any:
    """Names alone are searched within their usual ends."""
    return dict.fromkeys(given) if isinstance(given, list) else given


Count: TypeAlias = Annotated[int, Whole()]
Contacts: TypeAlias = Annotated[int | None, Whole()]
Over: TypeAlias = Annotated[dict[str, list[float]], Named(varying, values_of, least=1)]
Search: TypeAlias = Annotated[dict[str, list[float] | None], _SEARCHED, AfterValidator(_search)]
ByWay: TypeAlias = Annotated[str, Way(tuple(BY))]
Names: TypeAlias = Annotated[list[str], Listed(Text(said="a column's name"))]
Columns: TypeAlias = Annotated[dict[str, str], Each(Text(said="a column's name"))]
Conditions: TypeAlias = Annotated[
    list[str], Listed(Text(said="a comparison")), AfterValidator(check_conditions)
]
YesNo: TypeAlias = Annotated[bool, Truth()]
Format: TypeAlias = Annotated[str | None, Word(tuple(FORMATS))]
File: TypeAlias = Annotated[str, Text(said="the name of a file")]
Measures: TypeAlias = Annotated[list[str], Listed(Word(tuple(MEASURES)))]
Height: TypeAlias = Annotated[float, Quantity("length", 0.0), AfterValidator(check_height)]
