"""What a key of a study file may be given: quantities, words, lists of them, tables of variables.

Each says in `words` what is allowed, for errors and for the reference.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from types import MappingProxyType
from typing import Annotated, Any

from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    GetCoreSchemaHandler,
    ValidationError,
    create_model,
    model_validator,
)
from pydantic_core import CoreSchema, InitErrorDetails, PydanticCustomError, core_schema

from hoopgen.brief import cut
from hoopgen.printable import printable
from hoopgen.sizes import evenly
from hoopgen.units import NO_BARE, Kind, parse_quantity, readings

from .lines import Path

__all__ = [
    "Ends",
    "Listed",
    "Name",
    "Named",
    "OneOf",
    "Quantity",
    "Share",
    "Table",
    "Text",
    "Values",
    "Whole",
    "Word",
    "show",
    "wrong",
]

_EXAMPLES: Mapping[Kind, tuple[str, str]] = MappingProxyType(
    {
        "length": ('"7 ft"', '"8 ft"'),
        "speed": ('"7.1 m/s"', '"7.3 m/s"'),
        "angle": ('"45 deg"', '"60 deg"'),
        "spin": ('"1 Hz"', '"3 Hz"'),
        "acceleration": ('"9.79 m/s2"', '"9.83 m/s2"'),
        "number": ("0.65", "0.75"),
    }
)
"""How quantities of each kind are written."""


def show(given: Any) -> str:
    """Show what was given about as it is in the file."""
    return cut(json.dumps(given, ensure_ascii=False, default=str))


def meant(given: Any, allowed: Iterable[str]) -> str:
    """Ask for the word that was perhaps meant."""
    close = get_close_matches(str(given).lower(), list(allowed), n=1)
    return f"; is {close[0]} meant?" if close else ""


def wrong(said: str, where: Path) -> InitErrorDetails:
    """Return an error of a key below the table at hand."""
    error = PydanticCustomError("said", "{said}", {"said": said})
    return {"type": error, "loc": where, "input": None}


# --------------------------------------------------------------------------------------- one value


class _Value:
    """A value that is read by a function of its own."""

    @property
    def words(self) -> str:
        """What may be given."""
        raise NotImplementedError

    def read(self, given: Any) -> Any:
        """Return the value.

        Raises
        ------
        ValueError
            If it is not as described.
        """
        raise NotImplementedError

    def refuse(self, given: Any, more: str = "") -> ValueError:
        """Return the error that says what is allowed and what was given."""
        return ValueError(f"expected {self.words}; got {show(given)}{more}")

    def __get_pydantic_core_schema__(self, _: Any, __: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.read)


@dataclass(frozen=True)
class Quantity(_Value):
    """A number with a unit, read as SI.

    Attributes
    ----------
    kind
        What is measured.
    low, high
        What it may be, ends included.
    """

    kind: Kind
    low: float = -math.inf
    high: float = math.inf

    @property
    def words(self) -> str:
        """What may be given."""
        said = f"a {self.kind}".replace("a a", "an a")
        said += "" if self.kind == "number" else f" such as {_EXAMPLES[self.kind][0]}"
        if self.high < math.inf:
            return f"{said} from {self.low:g} to {self.high:g}"
        return f"{said}, not below {self.low:g}" if self.low > -math.inf else said

    def read(self, given: Any) -> float:
        """Return the value in SI."""
        if isinstance(given, str):
            value = self._parsed(given)
        elif isinstance(given, bool) or not isinstance(given, int | float):
            raise self.refuse(given)
        elif self.kind in NO_BARE and given != 0:
            said = readings(show(given), self.kind, '"{} {}"')
            raise self.refuse(given, f", which has no unit: write {said}")
        else:
            value = float(given) if abs(given) < 10**300 else math.inf
        if not math.isfinite(value) or not self.low <= value <= self.high:
            raise self.refuse(given)
        return value

    def _parsed(self, given: str) -> float:
        try:
            return parse_quantity(given, self.kind)
        except ValueError as error:
            raise ValueError(f"expected {self.words}; {error}") from None


@dataclass(frozen=True)
class Whole(_Value):
    """A whole number; 1e6 is one too.

    Attributes
    ----------
    low
        The least.
    bits
        It is below 2 to the power of this.
    """

    low: int = 1
    bits: int = 63

    @property
    def words(self) -> str:
        """What may be given."""
        return f"a whole number from {self.low}"

    def read(self, given: Any) -> int:
        """Return it."""
        number = isinstance(given, int | float) and not isinstance(given, bool)
        if number and given >= 2**self.bits:
            raise self.refuse(given, f", more than 2^{self.bits} - 1")
        if not number or not given >= self.low or given != int(given):
            raise self.refuse(given)
        return int(given)


@dataclass(frozen=True)
class Share(_Value):
    """A number within 0 and 1."""

    words = "a number above 0 and below 1"

    def read(self, given: Any) -> float:
        """Return it."""
        if not isinstance(given, float) or not 0.0 < given < 1.0:
            raise self.refuse(given)
        return given


@dataclass(frozen=True)
class Text(_Value):
    """Text without control characters, which no picture and no page can show.

    Attributes
    ----------
    pattern
        What all of it matches.
    said
        The same in words.
    """

    pattern: str = r".+"
    said: str = "a line of text"

    @property
    def words(self) -> str:
        """What may be given."""
        return self.said

    def read(self, given: Any) -> str:
        """Return it."""
        if not isinstance(given, str) or not re.fullmatch(self.pattern, given):
            raise self.refuse(given)
        if printable(given) != given:
            raise self.refuse(given, ", with control characters")
        return given


@dataclass(frozen=True)
class Name(Text):
    """Text that names a folder.

    Attributes
    ----------
    taken
        What it may not be, and why.
    """

    taken: Mapping[str, str] = field(default_factory=dict)

    def read(self, given: Any) -> str:
        """Return it."""
        name = super().read(given)
        if name in self.taken:
            raise ValueError(f"{show(name)} cannot be a name: {self.taken[name]}")
        return name


@dataclass(frozen=True)
class Word(_Value):
    """One of a few words."""

    allowed: tuple[str, ...]

    @property
    def words(self) -> str:
        """What may be given."""
        *others, last = (f'"{word}"' for word in self.allowed)
        return f"{', '.join(others)} or {last}" if others else last

    def read(self, given: Any) -> str:
        """Return it."""
        if given not in self.allowed:
            raise self.refuse(given, meant(given, self.allowed))
        return str(given)


# ----------------------------------------------------------------------------------- several values


@dataclass(frozen=True)
class OneOf:
    """A list, or else a table."""

    listed: Listed
    named: Named

    @property
    def words(self) -> str:
        """What may be given."""
        return f"{self.listed.words}, or {self.named.words}"

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        ways = {
            # In angles: marks of pydantic's, no keys of the document.
            "<list>": handler.generate_schema(Annotated[Any, self.listed]),
            "<table>": handler.generate_schema(Annotated[Any, self.named]),
        }
        return core_schema.tagged_union_schema(
            ways, discriminator=lambda given: "<list>" if isinstance(given, list) else "<table>"
        )


@dataclass(frozen=True)
class Listed:
    """A list of values.

    Attributes
    ----------
    of
        What each is.
    least
        How many there must be.
    """

    of: _Value
    least: int = 0

    @property
    def words(self) -> str:
        """What may be given."""
        if isinstance(self.of, Word):
            return f"a list of {self.of.words.replace(' or ', ', ')}"
        return f"a list of {self.of.words}s".replace("a list of a ", "a list of ")

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_wrap_validator_function(
            self._read, core_schema.list_schema(handler.generate_schema(Annotated[Any, self.of]))
        )

    def _read(self, given: Any, handler: Callable[[Any], Any]) -> list[Any]:
        if not isinstance(given, list) or len(given) < self.least:
            raise ValueError(f"expected {self.words}; got {show(given)}")
        read: list[Any] = handler(given)
        return read


@dataclass(frozen=True)
class Values:
    """Values of a variable: one, a list, or from one to another."""

    kind: Kind

    @property
    def words(self) -> str:
        """What may be given."""
        first, last = _EXAMPLES[self.kind]
        return f"a list of {self.kind}s, or {{ from = {first}, to = {last}, count = 11 }}"

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        one = handler.generate_schema(Annotated[Any, Quantity(self.kind)])
        ways = {
            "<range>": handler.generate_schema(_range(self.kind)),
            "<list>": handler.generate_schema(Annotated[Any, Listed(Quantity(self.kind), 1)]),
            "<one>": one,
        }
        return core_schema.no_info_after_validator_function(
            self._listed, core_schema.tagged_union_schema(ways, discriminator=self._way)
        )

    @staticmethod
    def _way(given: Any) -> str:
        if isinstance(given, dict):
            return "<range>"
        return "<list>" if isinstance(given, list) else "<one>"

    @staticmethod
    def _listed(read: Any) -> list[float]:
        if isinstance(read, Table):
            ends: Any = read
            values: list[float] = evenly("count", ends.start, ends.to, ends.count).tolist()
            return values
        return read if isinstance(read, list) else [read]


@dataclass(frozen=True)
class Ends:
    """The ends of a variable's values; None for the usual ones."""

    kind: Kind

    @property
    def words(self) -> str:
        """What may be given."""
        low, high = _EXAMPLES[self.kind]
        return f'two {self.kind}s, [{low}, {high}], or "usual"'

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        one = handler.generate_schema(Annotated[Any, Quantity(self.kind)])
        return core_schema.no_info_wrap_validator_function(self._read, core_schema.list_schema(one))

    def _read(self, given: Any, handler: Callable[[Any], Any]) -> list[float] | None:
        if given == "usual":
            return None
        ends = handler(given) if isinstance(given, list) else []
        if len(ends) != 2 or not ends[0] < ends[1]:
            raise ValueError(f"expected {self.words}, the lower one first; got {show(given)}")
        return [float(end) for end in ends]


# ------------------------------------------------------------------------------------------- tables


class Table(BaseModel):
    """A table whose keys are all known."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)

    @model_validator(mode="before")
    @classmethod
    def _known(cls, given: Any) -> Any:
        """Refuse unknown keys, each at its line, with what was perhaps meant."""
        if not isinstance(given, dict):
            raise ValueError(f"expected a table of keys and values; got {show(given)}")
        known = [field.alias or name for name, field in cls.model_fields.items()]
        unknown = [key for key in given if key not in known]
        if unknown:
            errors = [
                wrong(f"unknown key{meant(key, known) or '.'} One of {', '.join(known)}", (key,))
                for key in unknown
            ]
            raise ValidationError.from_exception_data(cls.__name__, errors)
        return given


def _range(kind: Kind) -> type[Table]:
    end = Annotated[float, Quantity(kind)]
    count = Annotated[int, Whole(2)]
    return create_model(
        "Range", __base__=Table, start=(end, Field(alias="from")), to=(end, ...), count=(count, ...)
    )


@dataclass(frozen=True)
class Named:
    """A table whose keys are names, in the file's order.

    Attributes
    ----------
    names
        What the keys may be.
    value
        What each may be given.
    none
        Whether "none" may stand in place of the table.
    least
        Keys that there must be.
    """

    names: tuple[str, ...]
    value: Callable[[str], Any]
    none: bool = False
    least: int = 0

    @property
    def words(self) -> str:
        """What may be given."""
        return 'a table, or "none"' if self.none else "a table"

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        fields: dict[str, Any] = {
            name: (Annotated[Any, self.value(name)], None) for name in self.names
        }
        table = handler.generate_schema(create_model("Named", __base__=Table, **fields))
        return core_schema.no_info_wrap_validator_function(self._read, table)

    def _read(self, given: Any, handler: Callable[[Any], Any]) -> dict[str, Any] | None:
        if self.none and given == "none":
            return None
        table = handler(given)
        if len(given) < self.least:
            raise ValueError(f"expected {self.least} or more of {', '.join(self.names)}")
        return {name: getattr(table, name) for name in given}
