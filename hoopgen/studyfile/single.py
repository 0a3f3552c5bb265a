"""One value of a study file: a quantity, a whole number, a share, a text, a word.

Each says in `words` what is allowed, for errors and for the reference.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from types import MappingProxyType
from typing import Any

from pydantic import (
    GetCoreSchemaHandler,
)
from pydantic_core import CoreSchema, InitErrorDetails, PydanticCustomError, core_schema

from hoopgen.brief import cut
from hoopgen.printable import printable
from hoopgen.units import NO_BARE, Kind, parse_quantity, readings

from .lines import Path

__all__ = [
    "EXAMPLES",
    "Name",
    "Quantity",
    "Share",
    "Single",
    "Text",
    "Whole",
    "Word",
    "meant",
    "show",
    "wrong",
]

EXAMPLES: Mapping[Kind, tuple[str, str]] = MappingProxyType(
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


class Single:
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
class Quantity(Single):
    """A number with a unit, read as SI.

    Attributes
    ----------
    kind
        What is measured.
    low, high
        What it may be, ends included.
    infinite
        Whether it may be infinite, too.
    """

    kind: Kind
    low: float = -math.inf
    high: float = math.inf
    infinite: bool = False

    @property
    def words(self) -> str:
        """What may be given."""
        said = f"a {self.kind}".replace("a a", "an a")
        said += "" if self.kind == "number" else f" such as {EXAMPLES[self.kind][0]}"
        said += ", or inf" if self.infinite else ""
        if self.high < math.inf:
            least = "at most" if self.low == -math.inf else f"from {self.low:g} to"
            return f"{said} {least} {self.high:g}"
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
            value = float(given) if abs(given) < 10**300 or given == math.inf else math.nan
        if value == math.inf and self.infinite:
            return value
        if not math.isfinite(value) or not self.low <= value <= self.high:
            raise self.refuse(given)
        return value

    def _parsed(self, given: str) -> float:
        try:
            return parse_quantity(given, self.kind, infinite=self.infinite)
        except ValueError as error:
            raise ValueError(f"expected {self.words}; {error}") from None


@dataclass(frozen=True)
class Whole(Single):
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
class Share(Single):
    """A number within 0 and 1."""

    words = "a number above 0 and below 1"

    def read(self, given: Any) -> float:
        """Return it."""
        if not isinstance(given, float) or not 0.0 < given < 1.0:
            raise self.refuse(given)
        return given


@dataclass(frozen=True)
class Text(Single):
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
class Truth(Single):
    """True or false."""

    @property
    def words(self) -> str:
        """What may be given."""
        return "true or false"

    def read(self, given: Any) -> bool:
        """Return it."""
        if not isinstance(given, bool):
            raise self.refuse(given)
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
class Word(Single):
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
