"""Kinds of values that a setting of a question has.

Each kind reads a value from a study file, reads it from text of the command line, and describes in
`words` what is allowed, for errors and for the reference.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from decimal import Decimal, InvalidOperation
from typing import Annotated, Any

from hoopgen.core.units import UNIT_REQUIRED, UNITS, Kind, parse_quantity, readings
from hoopgen.text.escape import printable
from hoopgen.text.shorten import brief, cut, suggestion

EXAMPLES: Mapping[Kind, tuple[str, str]] = {
    "length": ('"7 ft"', '"8 ft"'),
    "speed": ('"7.1 m/s"', '"7.3 m/s"'),
    "angle": ('"45 deg"', '"60 deg"'),
    "spin": ('"1 Hz"', '"3 Hz"'),
    "acceleration": ('"9.79 m/s2"', '"9.83 m/s2"'),
    "mass": ('"595 g"', '"0.624 kg"'),
    "density": ('"1.15 kg/m3"', '"1.2 kg/m3"'),
    "number": ("0.65", "0.75"),
}
"""Examples of quantities of each kind, as a study file writes them."""


def show(given: Any) -> str:
    """Return a value about as it is written in a study file."""
    return cut(json.dumps(given, ensure_ascii=False, default=str))


class Value:
    """A kind of values."""

    @property
    def metavar(self) -> str:
        """The allowed values, for the help of a command."""
        return "VALUE"

    @property
    def words(self) -> str:
        """The allowed values, for errors and for the reference."""
        return "a value"

    def read(self, given: Any) -> Any:
        """Return the value that a study file gives.

        Raises
        ------
        ValueError
            If it is not allowed.
        """
        raise NotImplementedError

    def parse(self, text: str) -> Any:
        """Return the value that an option gives.

        Raises
        ------
        ValueError
            If it is not allowed.
        """
        return self.read(text)

    def refusal(self, given: Any, more: str = "") -> ValueError:
        """Return the error that says what is allowed and what was given.

        Parameters
        ----------
        given
            The value that was given.
        more
            What is added to the message.
        """
        return ValueError(f"expected {self.words}; got {show(given)}{more}")

    def __get_pydantic_core_schema__(self, _: Any, __: Any) -> Any:
        from pydantic_core import core_schema

        return core_schema.no_info_plain_validator_function(self.read)


@dataclass(frozen=True)
class Quantity(Value):
    """A number with a unit, read as SI.

    Attributes
    ----------
    low, high
        What it may be, ends included.
    """

    kind: Kind  # what is measured
    low: float = -math.inf
    high: float = math.inf
    infinite: bool = False  # true if it may be infinite, too

    @property
    def words(self) -> str:
        """The allowed values."""
        text = f"a {self.kind}".replace("a a", "an a")
        text += "" if self.kind == "number" else f" such as {EXAMPLES[self.kind][0]}"
        text += ", or inf" if self.infinite else ""
        if self.high < math.inf:
            least = "at most" if self.low == -math.inf else f"from {self.low:g} to"
            return f"{text} {least} {self.high:g}"
        return f"{text}, not below {self.low:g}" if self.low > -math.inf else text

    @property
    def unit(self) -> str:
        """The SI unit; empty for a plain number."""
        return next(iter(UNITS[self.kind]))

    @property
    def limits(self) -> str:
        """The range that is allowed, in SI units."""
        low, high = (f"{end:g} {self.unit}".rstrip() for end in (self.low, self.high))
        if self.high < math.inf:
            return f"of at most {high}" if self.low == -math.inf else f"from {low} to {high}"
        return f"of at least {low}" if self.low > -math.inf else ""

    @property
    def metavar(self) -> str:
        """The text in the help of a command."""
        units = "|".join(UNIT_REQUIRED.get(self.kind, tuple(UNITS[self.kind])[:1])[:2])
        return f"{self.kind.upper()} [{units}]" if units else self.kind.upper()

    def parse(self, text: str) -> float:
        """Return the value in SI."""
        value = parse_quantity(text, self.kind)
        if not self.low <= value <= self.high:
            raise ValueError(f"expected a {self.kind} {self.limits}; got {brief(text)}")
        return value

    def read(self, given: Any) -> float:
        """Return the value in SI."""
        if isinstance(given, str):
            try:
                value = parse_quantity(given, self.kind, infinite=self.infinite)
            except ValueError as error:
                raise ValueError(f"expected {self.words}; {error}") from None
        elif isinstance(given, bool) or not isinstance(given, int | float):
            raise self.refusal(given)
        elif self.kind in UNIT_REQUIRED and given != 0:
            said = readings(show(given), self.kind, '"{} {}"')
            raise self.refusal(given, f", which has no unit: write {said}")
        else:
            value = float(given) if abs(given) < 10**300 or given == math.inf else math.nan
        if value == math.inf and self.infinite:
            return value
        if not math.isfinite(value) or not self.low <= value <= self.high:
            raise self.refusal(given)
        return value


_MAX_WHOLE = 2**63 - 1


@dataclass(frozen=True)
class Whole(Value):
    """A whole number from `low` to `high`; 1e6 is one, too."""

    low: int = 1
    high: int = _MAX_WHOLE
    metavar: str = "COUNT"

    @property
    def words(self) -> str:
        """The allowed values."""
        return f"a whole number from {self.low}"

    def parse(self, text: str) -> int:
        """Return the number."""
        try:
            number = Decimal(text)
        except InvalidOperation:
            number = Decimal("nan")
        # In this order no number is made an int that would fill the memory.
        if number.is_finite() and self.low <= number <= self.high and number == int(number):
            return int(number)
        # An end that nobody comes near is told only to those who pass it.
        told = self.high != _MAX_WHOLE or (number.is_finite() and number > self.high)
        most = f" to {self.high}" if told else ""
        raise ValueError(f"{brief(text)} is not {self.words}{most}")

    def read(self, given: Any) -> int:
        """Return the number."""
        number = isinstance(given, int | float) and not isinstance(given, bool)
        if number and given > self.high:
            raise self.refusal(given, f", more than 2^{self.high.bit_length()} - 1")
        if not number or not given >= self.low or given != int(given):
            raise self.refusal(given)
        return int(given)


@dataclass(frozen=True)
class Share(Value):
    """A number above 0 and below 1."""

    percent: bool = False  # true if 70 is 70% in a text; with its sign every percentage is

    words = "a number above 0 and below 1"
    metavar = "SHARE"

    def parse(self, text: str) -> float:
        """Return the number."""
        number, percent, rest = text.strip().partition("%")
        value = parse_quantity(number, "number")
        # No share is above 1, so that 70 can only mean 70%; 1 may mean 1% or 100%.
        value /= 100.0 if percent or (self.percent and value > 1.0) else 1.0
        if rest or not 0.0 < value < 1.0:
            raise ValueError(
                f"{brief(text)} is no share above 0% and below 100%: expected one such as 70% or "
                "0.7"
            )
        return value

    def read(self, given: Any) -> float:
        """Return the number."""
        if not isinstance(given, float) or not 0.0 < given < 1.0:
            raise self.refusal(given)
        return given


@dataclass(frozen=True)
class Text(Value):
    """Text without control characters, which no picture and no page can show.

    Attributes
    ----------
    reserved
        Texts that it cannot be, and why.
    """

    pattern: str = r".+"  # A regular expression that all of it matches
    words: str = "a line of text"  # the same in words
    metavar: str = "TEXT"  # what the help of a command shows
    reserved: Mapping[str, str] = field(default_factory=dict, hash=False)

    def parse(self, text: str) -> str:
        """Return the text as it is."""
        return text

    def read(self, given: Any) -> str:
        """Return the text."""
        if not isinstance(given, str) or not re.fullmatch(self.pattern, given):
            raise self.refusal(given)
        if printable(given) != given:
            raise self.refusal(given, ", with control characters")
        if given in self.reserved:
            raise ValueError(f"{show(given)} cannot be a name: {self.reserved[given]}")
        return given


class Flag(Value):
    """True or false."""

    words = "true or false"

    def read(self, given: Any) -> bool:
        """Return the value."""
        if not isinstance(given, bool):
            raise self.refusal(given)
        return given


@dataclass(frozen=True)
class Choice(Value):
    """One of a few words."""

    allowed: tuple[str, ...]

    @property
    def words(self) -> str:
        """The allowed values."""
        *others, last = (f'"{word}"' for word in self.allowed)
        return f"{', '.join(others)} or {last}" if others else last

    def read(self, given: Any) -> str:
        """Return the word."""
        if given not in self.allowed:
            raise self.refusal(given, suggestion(given, self.allowed))
        return str(given)


class Success(Choice):
    """The shots that count: all made ones or those of a kind; in a scene of one's own, an end."""


@dataclass(frozen=True)
class Names(Value):
    """One of many names, which a shell completes; of an option the library refuses others.

    Attributes
    ----------
    labels
        Returns what each name is; called when they are needed, so that help is quick.
    """

    labels: Callable[[], Mapping[str, str]]
    metavar = "NAME"

    @property
    def words(self) -> str:
        """The allowed values."""
        return Choice(tuple(self.labels())).words

    def read(self, given: Any) -> str:
        """Return the name."""
        return Choice(tuple(self.labels())).read(given)


@dataclass(frozen=True)
class Listed(Value):
    """A list of values; an option that may be repeated."""

    of: Value  # the kind of each value
    least: int = 0  # the least number of values

    @property
    def words(self) -> str:
        """The allowed values."""
        if isinstance(self.of, Choice | Names):
            return f"a list of {self.of.words.replace(' or ', ', ')}"
        return f"a list of {self.of.words}s".replace("a list of a ", "a list of ")

    def read(self, given: Any) -> list[Any]:
        """Return the list, unless it is none or too short."""
        if not isinstance(given, list) or len(given) < self.least:
            raise self.refusal(given)
        return given

    def __get_pydantic_core_schema__(self, _: Any, handler: Any) -> Any:
        from pydantic_core import core_schema

        items = core_schema.list_schema(handler.generate_schema(Annotated[Any, self.of]))
        return core_schema.no_info_before_validator_function(self.read, items)


@dataclass(frozen=True)
class Each(Value):
    """A table whose values are alike, whatever their keys; an option that may be repeated."""

    of: Value

    @property
    def words(self) -> str:
        """The allowed values."""
        return f"a table, {self.of.words} each"

    def read(self, given: Any) -> dict[str, Any]:
        """Return the table, unless it is none."""
        if not isinstance(given, dict):
            raise self.refusal(given)
        return given

    def __get_pydantic_core_schema__(self, _: Any, handler: Any) -> Any:
        from pydantic_core import core_schema

        value = handler.generate_schema(Annotated[Any, self.of])
        table = core_schema.dict_schema(core_schema.str_schema(), value)
        return core_schema.no_info_before_validator_function(self.read, table)


@dataclass(frozen=True)
class Quantities(Value):
    """Quantities of one kind: one, a list, or from one to another."""

    kind: Kind


@dataclass(frozen=True)
class Notation(Value):
    """A kind of values that a study file and the command line write each in its own way."""

    name: str
    words: str = ""


AXES = Notation("variables of the scene and the values that each takes")
BOUNDS = Notation("variables of the scene and the bounds of each, or their names alone")
PLACES = Notation("places on the floor: distances and angles, or x and y")
DEVIATIONS = Notation("variables and standard deviations of each", "a table")
CHANGE = Notation("what changes in a second setting", "tables")
FOLDER = Notation("a folder to be written")
OUTPUT = Notation("a file to be written")
MEMORY = Notation("a number of bytes")
