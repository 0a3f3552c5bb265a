"""Types of options: values read from text, quantities, variables with their values."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, Generic, TypeVar

import click
import numpy as np
from click.shell_completion import CompletionItem
from numpy.typing import NDArray

from hoopgen.core.memory import even_values
from hoopgen.core.si_checks import MAX_DEVIATION
from hoopgen.core.units import DEGREE, Kind, parse_quantity
from hoopgen.core.variables import STATE, Variable
from hoopgen.hoop.variables import ALTERNATIVE_VARIABLES, ARGUMENTS, VARIABLES
from hoopgen.report.quantities import format_variable
from hoopgen.scene.lookup import variables_of
from hoopgen.study.questions.values import Quantity, Whole
from hoopgen.text.shorten import brief, suggestion

from .release_limits import check_release, from_zero

Value = TypeVar("Value")

if TYPE_CHECKING:

    class Type(click.ParamType[Value]):
        """The type of an option whose text becomes a value of one kind."""

    Choice = click.Choice[str]

else:  # older releases of click do not know theirs as generic

    class Type(click.ParamType, Generic[Value]):
        """The type of an option whose text becomes a value of one kind."""

    Choice = click.Choice


class Parsed(Type[Value]):
    """The type of a value that a function reads from text; its ValueError is the option's.

    Parameters
    ----------
    metavar
        Text of the help, as it is: click would put it in capitals.
    """

    def __init__(self, read: Callable[[str], Value], metavar: str) -> None:
        self.read = read
        self.name = metavar

    def convert(
        self, value: str | Value, param: click.Parameter | None, ctx: click.Context | None
    ) -> Value:
        """Read the text; a default that is none already stands.

        Arguments as for `click.ParamType.convert`.
        """
        if not isinstance(value, str):
            return value
        try:
            return self.read(value)
        except ValueError as error:
            self.fail(str(error), param, ctx)

    def get_metavar(self, param: click.Parameter, ctx: click.Context | None = None) -> str:
        """Return the text of the help.

        Arguments as for `click.ParamType.get_metavar`.
        """
        return self.name


def number_cell(name: str, value: float) -> str:
    """Return the value of a variable for a table, without its unit; "-" for NaN.

    Parameters
    ----------
    name
        The name of a variable at a hoop.
    value
        Its value, SI; NaN where there is none.

    Returns
    -------
    str
        The number in the unit that is shown.
    """
    return "-" if np.isnan(value) else format_variable(name, value, unit=False)


def quantity(
    kind: Kind, name: str = "", low: float = -math.inf, high: float = math.inf
) -> Parsed[float]:
    """Return the type of a number with a unit, given to the command in SI.

    Parameters
    ----------
    kind
        What is measured; see `hoopgen.core.units.UNITS`.
    name
        Of the variable at a hoop, whose value has to be plausible; one in `FROM_ZERO` is not
        negative.
    low, high
        The least and the largest value, SI.
    """
    value = Quantity(kind, low, high)
    return Parsed(lambda text: check_release(name, value.parse(text), text), value.metavar)


SCENE = "hoopgen.scene"
"""Key of the context's ``meta``: the scene that ``--scene`` names."""

Variables = Mapping[str, Variable]


class OfScene(Parsed[Value]):
    """The type of a value read from text, given the variables of the command's scene.

    A shell completes the names of those variables that `among` returns.
    """

    def __init__(
        self,
        read: Callable[[str, Variables], Value],
        metavar: str,
        among: Callable[[Variables], Variables] = lambda variables: variables,
    ) -> None:
        super().__init__(lambda text: read(text, VARIABLES), metavar)
        self.read_of, self.among = read, among

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        """Complete the name of a variable, and the equals sign after it.

        Arguments as for `click.ParamType.shell_complete`.
        """
        scene = ctx.meta.get(SCENE)
        known = self.among(VARIABLES if scene is None else variables_of(scene))
        return [
            CompletionItem(f"{name}=", help=variable.label)
            for name, variable in known.items()
            if name.startswith(incomplete)
        ]

    def convert(
        self, value: str | Value, param: click.Parameter | None, ctx: click.Context | None
    ) -> Value:
        """Read the text.

        Arguments as for `click.ParamType.convert`.
        """
        scene = None if ctx is None else ctx.meta.get(SCENE)
        if scene is None or not isinstance(value, str):
            return super().convert(value, param, ctx)
        try:
            return self.read_of(value, variables_of(scene))
        except ValueError as error:
            self.fail(str(error), param, ctx)


def _read(text: str, variable: Variable) -> float:
    try:
        value = parse_quantity(text, variable.kind, infinite=variable.infinite)
        at_a_hoop = VARIABLES.get(variable.name) is variable
        return (check_release if at_a_hoop else from_zero)(variable.name, value, text)
    except ValueError as error:
        raise ValueError(f"{variable.name}: {error}") from None


def _of_release(variable: Variable) -> bool:
    """Return whether a variable is one of a release at a hoop, and no component of a state."""
    name = variable.name
    return variable in (ARGUMENTS.get(name), ALTERNATIVE_VARIABLES.get(name))


def _known(name: str, allowed: Variables) -> Variable:
    if name not in allowed:
        meant = suggestion(name, allowed)
        raise ValueError(f"{brief(name)} is none of {', '.join(allowed)}{meant}")
    return allowed[name]


def _split(text: str, allowed: Variables) -> tuple[Variable, str]:
    name, separator, value = (part.strip() for part in text.partition("="))
    if not separator:
        raise ValueError(f"{brief(text)} is not name=value")
    return _known(name, allowed), value


def _assignment(text: str, allowed: Variables) -> tuple[str, float]:
    variable, value = _split(text, allowed)
    return variable.name, _read(value, variable)


def _deviation(text: str, allowed: Variables) -> tuple[str, float]:
    variable, value = _split(text, allowed)
    deviation = _read(value, variable)
    if not 0.0 <= deviation < np.inf:
        raise ValueError(
            f"{variable.name}: expected a standard deviation from 0, got {brief(value)}"
        )
    if variable.kind == "angle" and _of_release(variable) and deviation >= MAX_DEVIATION:
        raise ValueError(
            f"{variable.name}: expected a standard deviation below "
            f"{MAX_DEVIATION / DEGREE:.1f}deg, got {brief(value)}"
        )
    return variable.name, deviation


def _axis(text: str, among: Variables) -> tuple[str, NDArray[np.float64]]:
    variable, values = _split(text, among)
    parts = values.split(":")
    if len(parts) == 1:
        return variable.name, np.array([_read(part, variable) for part in values.split(",")])
    if len(parts) != 3 or not parts[2].strip().isdecimal() or int(parts[2]) < 2:
        raise ValueError(
            f"{variable.name}: {brief(values)} is neither from:to:count, count from 2, "
            "nor values with commas between"
        )
    first, last = (_read(part, variable) for part in parts[:2])
    return variable.name, even_values(variable.name, first, last, int(parts[2]))


def _bounds(text: str, among: Variables) -> tuple[str, tuple[float, float] | None]:
    if "=" not in text:
        return _known(text.strip(), among).name, None
    variable, values = _split(text, among)
    ends = values.split(":")
    if len(ends) != 2:
        raise ValueError(f"{variable.name}: {brief(values)} is not low:high")
    low, high = (_read(end, variable) for end in ends)
    if not low < high:
        raise ValueError(f"{variable.name}: expected low:high, low below high; got {brief(values)}")
    return variable.name, (low, high)


def _correlation(text: str) -> tuple[tuple[str, str], float]:
    names, _, value = text.partition("=")
    first, separator, second = (name.strip() for name in names.partition(","))
    if not separator or not value:
        raise ValueError(f"{brief(text)} is not name,name=value")
    return (first, second), parse_quantity(value, "number")


def whole(least: int = 1, most: int = 2**63 - 1) -> Parsed[int]:
    """Return the type of a whole number from `least` to `most`; ``1e6`` is one, too.

    Parameters
    ----------
    least, most
        The smallest and the largest number that is accepted; an error names them.

    Returns
    -------
    Parsed
        A type for `click.option`.
    """
    return Parsed(Whole(least, most).parse, "COUNT")


def once(ctx: click.Context, option: click.Parameter, given: Iterable[tuple[Any, Value]]) -> Any:
    """Return the values of a repeated option by name; each name may be given once.

    Parameters
    ----------
    ctx
        The context of the command.
    option
        The option, whose name an error has.
    given
        Names, or pairs of names, with their values.

    Returns
    -------
    dict
        The values by name, in the order in which they were given.

    Raises
    ------
    click.BadParameter
        If a name is given twice.
    """
    values: dict[Any, Value] = {}
    for name, value in given:
        if name in values:
            words = name if isinstance(name, str) else ",".join(name)
            raise click.BadParameter(f"{words} is given twice", ctx, option)
        values[name] = value
    return values


ASSIGNMENT = OfScene(_assignment, "NAME=VALUE")
"""A variable and its value, ``elevation=52deg``."""

DEVIATION = OfScene(_deviation, "NAME=VALUE")
"""A variable and its standard deviation, ``elevation=1.3deg``."""


def _parameters(among: Variables) -> Variables:
    return {name: one for name, one in among.items() if name not in NOT_OF_SCENE}


def _setting(text: str, among: Variables) -> tuple[str, float]:
    names = _parameters(among)
    if not names:
        raise ValueError("the scene has no parameters")
    return _assignment(text, names)


NOT_OF_SCENE = frozenset((*ARGUMENTS, *ALTERNATIVE_VARIABLES, *STATE))

SETTING = OfScene(_setting, "NAME=VALUE", _parameters)
"""A parameter of the scene and its value, ``restitution=0.75``."""


AXIS = OfScene(_axis, "NAME=FROM:TO:COUNT")
"""A variable and its values, ``elevation=45deg:60deg:61`` or ``restitution=0.6,0.7,0.8``."""

BOUNDS = OfScene(_bounds, "NAME=LOW:HIGH")
"""A variable and where to search, ``elevation=45deg:60deg``; or its name alone."""

PARAMETER_BOUNDS = OfScene(
    lambda text, among: _bounds(text, _parameters(among)), "NAME=LOW:HIGH", _parameters
)
"""A parameter of the scene and its bounds, ``ring_friction=0.1:1.0``; or its name alone."""

CORRELATION = Parsed(_correlation, "NAME,NAME=VALUE")
"""Two variables and their correlation, ``speed,elevation=-0.3``."""


def _column(text: str) -> tuple[str, str]:
    name, separator, column = (part.strip() for part in text.partition("="))
    if not (separator and name and column):
        raise ValueError(f"{brief(text)} is not VARIABLE=COLUMN")
    return name, column


COLUMN = Parsed(_column, "VARIABLE=COLUMN")
"""A variable and the column that is read as it, ``speed=release_speed_mph``."""

_BYTES = {"": 1, "b": 1, **{f"{letter}b": 1000**k for k, letter in enumerate("kmgt", 1)}}
_BYTES |= {f"{letter}ib": 1024**k for k, letter in enumerate("kmgt", 1)}


def _memory(text: str) -> int:
    found = re.fullmatch(r"\s*(\d+(?:\.\d*)?)\s*([a-z]*)\s*", text.lower(), re.ASCII)
    if found is None or found[2] not in _BYTES:
        raise ValueError(f"{brief(text)} is no size, such as 4GB or 500MB")
    return int(float(found[1]) * _BYTES[found[2]])


MEMORY = Parsed(_memory, "SIZE")
"""Bytes, ``4GB``."""


COUNT = whole()
"""A whole number from 1, ``1e6`` too."""
