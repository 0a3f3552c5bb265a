"""Kinds of values that a study file writes in a way of its own: tables, and variables in them."""

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
from pydantic_core import CoreSchema, InitErrorDetails, PydanticCustomError, core_schema

from hoopgen.core.memory import even_values
from hoopgen.core.units import Kind
from hoopgen.study.questions.values import EXAMPLES, Listed, Quantity, Value, Whole, show
from hoopgen.text.shorten import suggestion

from .lines import Path


def error_at(said: str, where: Path) -> InitErrorDetails:
    """Return an error of a key below the table at hand.

    Parameters
    ----------
    said
        The error in words, without the key.
    where
        The keys and positions that lead from the table at hand to the wrong value.

    Returns
    -------
    InitErrorDetails
        An error for `pydantic_core.ValidationError.from_exception_data`.
    """
    error = PydanticCustomError("said", "{said}", {"said": said})
    return {"type": error, "loc": where, "input": None}


@dataclass(frozen=True)
class OneOf(Value):
    """A list, or else a table."""

    listed: Listed
    named: Named

    @property
    def words(self) -> str:
        """The allowed values."""
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
class Values(Value):
    """Values of a variable: one, a list, or from one to another."""

    kind: Kind  # what is measured
    infinite: bool = False  # whether one of a list may be infinite

    @property
    def words(self) -> str:
        """The allowed values."""
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
            values: list[float] = even_values("count", ends.start, ends.to, ends.count).tolist()
            return values
        return read if isinstance(read, list) else [read]


@dataclass(frozen=True)
class Ends(Value):
    """The ends of a variable's values; None for the usual ones."""

    kind: Kind

    @property
    def words(self) -> str:
        """The allowed values."""
        low, high = EXAMPLES[self.kind]
        return f'two {self.kind}s, [{low}, {high}], or "usual"'

    def __get_pydantic_core_schema__(self, _: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        one = handler.generate_schema(Annotated[Any, Quantity(self.kind)])
        return core_schema.no_info_wrap_validator_function(self._read, core_schema.list_schema(one))

    def _read(self, given: Any, handler: Callable[[Any], Any]) -> tuple[float, float] | None:
        if given == "usual":
            return None
        ends = handler(given) if isinstance(given, list) else []
        if len(ends) != 2 or not ends[0] < ends[1]:
            raise ValueError(f"expected {self.words}, the lower one first; got {show(given)}")
        return float(ends[0]), float(ends[1])


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
                error_at(
                    f"unknown key{suggestion(key, known) or '.'} One of {', '.join(known)}", (key,)
                )
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
class Named(Value):
    """A table whose keys are names, in the file's order.

    Attributes
    ----------
    names
        What the keys may be; or what says so when a file is read, as it depends on the scene.
    """

    names: tuple[str, ...] | Callable[[], tuple[str, ...]]
    value: Callable[[str], Any]  # what each may be given
    none: bool = False  # whether "none" may stand in place of the table
    least: int = 0  # keys that there must be

    @property
    def words(self) -> str:
        """The allowed values."""
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
