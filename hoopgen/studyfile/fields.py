"""What a key of a study file may be given beside one value: lists of them, tables of variables.

Each says in `words` what is allowed, for errors and for the reference.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    GetCoreSchemaHandler,
    TypeAdapter,
    ValidationError,
    create_model,
    model_validator,
)
from pydantic_core import CoreSchema, core_schema

from hoopgen.sizes import evenly
from hoopgen.units import Kind

from .single import EXAMPLES, Quantity, Single, Whole, Word, meant, show, wrong

__all__ = ["Each", "Ends", "Listed", "Named", "OneOf", "Table", "Values"]


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

    of: Single
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
class Each:
    """A table whose values are alike, whatever their keys.

    Attributes
    ----------
    of
        What each is.
    """

    of: Single

    @property
    def words(self) -> str:
        """What may be given."""
        return f"a table, {self.of.words} each"

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        value = handler.generate_schema(Annotated[Any, self.of])
        return core_schema.no_info_wrap_validator_function(
            self._read, core_schema.dict_schema(core_schema.str_schema(), value)
        )

    def _read(self, given: Any, handler: Callable[[Any], Any]) -> dict[str, Any]:
        if not isinstance(given, dict):
            raise ValueError(f"expected {self.words}; got {show(given)}")
        read: dict[str, Any] = handler(given)
        return read


@dataclass(frozen=True)
class Values:
    """Values of a variable: one, a list, or from one to another.

    Attributes
    ----------
    kind
        What is measured.
    infinite
        Whether one of a list may be infinite.
    """

    kind: Kind
    infinite: bool = False

    @property
    def words(self) -> str:
        """What may be given."""
        first, last = EXAMPLES[self.kind]
        return f"a list of {self.kind}s, or {{ from = {first}, to = {last}, count = 11 }}"

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        value = Quantity(self.kind, infinite=self.infinite)
        one = handler.generate_schema(Annotated[Any, value])
        ways = {
            "<range>": handler.generate_schema(_range(self.kind)),
            "<list>": handler.generate_schema(Annotated[Any, Listed(value, 1)]),
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
        low, high = EXAMPLES[self.kind]
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
        What the keys may be; or what says so when a file is read, as it hangs on the scene.
    value
        What each may be given.
    none
        Whether "none" may stand in place of the table.
    least
        Keys that there must be.
    """

    names: tuple[str, ...] | Callable[[], tuple[str, ...]]
    value: Callable[[str], Any]
    none: bool = False
    least: int = 0

    @property
    def words(self) -> str:
        """What may be given."""
        return 'a table, or "none"' if self.none else "a table"

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        if not callable(self.names):
            table = handler.generate_schema(self._table(self.names))
            return core_schema.no_info_wrap_validator_function(self._read, table)
        return core_schema.no_info_plain_validator_function(self._read_now)

    def _table(self, names: tuple[str, ...]) -> type[Table]:
        fields: dict[str, Any] = {name: (Annotated[Any, self.value(name)], None) for name in names}
        made: type[Table] = create_model("Named", __base__=Table, **fields)
        return made

    def _read_now(self, given: Any) -> dict[str, Any] | None:
        assert callable(self.names)
        return self._read(given, TypeAdapter(self._table(self.names())).validate_python)

    def _read(self, given: Any, handler: Callable[[Any], Any]) -> dict[str, Any] | None:
        if self.none and given == "none":
            return None
        table = handler(given)
        if len(given) < self.least:
            names = self.names() if callable(self.names) else self.names
            raise ValueError(f"expected {self.least} or more of {', '.join(names)}")
        return {name: getattr(table, name) for name in given}
