"""The inputs of a scene's kernels for each shot, computed from its parameters.

Every size that is a parameter's name is that parameter; every other one, a number or a formula, is
an input of its own, computed in doubles from the parameters before a shot. So no number is compiled
in, formulas cost nothing in a shot, and to kernels and judge every size is an exact double.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from .errors import SceneError, wrong
from .formula_parser import read
from .formulas import Formula, FormulaError, name
from .limits import current

NONNEGATIVE_ARGUMENTS = ("restitution", "friction", "tangential")
"""Arguments of bodies that zero is one of."""


_LONG_QUOTIENT = re.compile(r"(\d+)/(\d{7,})")


@dataclass(frozen=True)
class Input:
    """A number that the kernels of a scene take.

    Attributes
    ----------
    name
        A parameter's, or that of a body and its argument.
    formula
        Its value, of the scene's parameters; a parameter's is its own name.
    unit, summary, sign, upper, latex, infinite
        As those of a `Parameter`.
    default
        Its value at the parameters' defaults.
    argument
        What it is to the body that it is named after: what is the same to another shares it.
    lower
        The smallest value allowed, if it is not what the sign says.
    """

    name: str
    formula: Formula
    default: float
    unit: str = "m"
    summary: str = ""
    sign: str = "any"
    upper: float | None = None
    latex: str = ""
    argument: str = ""
    lower: float | None = None
    infinite: bool = False

    @property
    def own(self) -> bool:
        """True if it is one of the scene's parameters."""
        return self.formula == name(self.name)

    def allows(self, value: float) -> bool:
        """Return whether a number is allowed."""
        least = {"positive": value > 0, "nonnegative": value >= 0}.get(self.sign, True)
        finite = bool(np.isfinite(value)) or (self.infinite and value == math.inf)
        low, high = self.lower, self.upper
        return (
            finite and least and (low is None or value >= low) and (high is None or value <= high)
        )

    @property
    def allowed(self) -> str:
        """The allowed numbers in words."""
        words = {"positive": "above 0", "nonnegative": "of at least 0"}.get(self.sign, "")
        if self.lower is not None and self.lower > 0:
            words = ""
        least = "" if self.lower is None else f"of at least {self.lower:g}"
        most = "" if self.upper is None else f"at most {self.upper:g}"
        said = " and ".join(filter(None, (words, least, most)))
        return f"{said}, or inf".strip(", ") if self.infinite else said or "that is finite"


class Inputs:
    """The inputs of a scene in order: its parameters, then those that bodies add.

    Parameters
    ----------
    scene
        Its name, for complaints.
    parameters
        Its parameters, as inputs.
    as_written
        True: for readers. Every size is an input of its own, also where another one has the same
        value, and numbers are the decimals that the scene gives.
    """

    def __init__(self, scene: str, parameters: tuple[Input, ...], as_written: bool = False) -> None:
        self._scene = scene
        self.as_written = as_written
        self._inputs = {parameter.name: parameter for parameter in parameters}
        self._shared: dict[tuple[object, ...], str] = {}
        self.declared = tuple(self._inputs)

    @property
    def all(self) -> tuple[Input, ...]:
        """The inputs gathered so far."""
        return tuple(self._inputs.values())

    @property
    def defaults(self) -> Mapping[str, float]:
        """The defaults of the scene's parameters."""
        return {given: self._inputs[given].default for given in self.declared}

    def wrong(self, owner: str, argument: str, said: object) -> SceneError:
        """Return the error about an argument.

        Parameters
        ----------
        owner
            The body or end, empty for the scene itself.
        argument
            The argument.
        said
            The rest of the message.
        """
        return wrong(self._scene, owner, argument, said)

    def read(self, owner: str, argument: str, value: object, also: tuple[str, ...] = ()) -> Formula:
        """Return an argument as a formula of the parameters, and of the names in `also`.

        Parameters
        ----------
        owner
            The body or end, for error messages.
        argument
            The argument, for error messages.
        value
            The argument as the author wrote it.
        also
            Names that the formula may contain besides the parameters.

        Raises
        ------
        SceneError
            If it is none.
        """
        try:
            return read(value, (*self.declared, *also), self.as_written)
        except FormulaError as error:
            raise self.wrong(owner, argument, error) from None

    def number(self, owner: str, argument: str, formula: Formula, infinite: bool = False) -> float:
        """Return the value of a formula at the parameters' defaults, checked to be finite.

        Parameters
        ----------
        owner, argument
            As for `read`.
        formula
            The formula.
        infinite
            True if the value may be infinite.
        """
        if self.as_written:
            exact = {given: _fraction(value) for given, value in self.defaults.items()}
            value = float(formula.fold(exact, lambda number: number, _root))
        else:
            value = float(formula.evaluate(self.defaults))
        if not np.isfinite(value) and not (infinite and value == math.inf):
            raise self.wrong(owner, argument, f"{formula} is {value} at the defaults")
        return value

    def check_above(
        self, owner: str, argument: str, formula: Formula, least: Formula, said: str
    ) -> None:
        """Raise unless a formula is above another one at the parameters' defaults.

        Parameters
        ----------
        owner, argument, formula
            As for `number`.
        least
            The other formula.
        said
            The reason, in words.

        Raises
        ------
        SceneError
            With the reason, what is expected and what was given.
        """
        value, limit = (self.number(owner, argument, one) for one in (formula, least))
        if value <= limit:
            raise self.wrong(
                owner, argument, f"{said}: expected more than {limit:g}, got {value:g}"
            )

    def add(
        self,
        owner: str,
        argument: str,
        formula: Formula,
        *,
        sign: str = "any",
        upper: float | None = None,
        unit: str = "m",
        lower: float | None = None,
        infinite: bool = False,
    ) -> Formula:
        """Return the name of an input for a formula of the parameters; zero for zero.

        A parameter that is one itself is held to what is allowed here, too.

        Parameters
        ----------
        owner, argument
            As for `read`.
        formula
            The formula of the input.
        sign
            "positive", "nonnegative" or "any".
        upper, lower
            Limits of the value; None for none.
        unit
            The unit.
        infinite
            True if the value may be infinite.

        Raises
        ------
        SceneError
            If it is not allowed at the defaults.
        """
        short = f"{owner.partition(' ')[2]} {argument}".strip()
        made = Input(
            _free(short.replace(" ", "_"), self._inputs),
            formula,
            self.number(owner, argument, formula, infinite),
            unit,
            self._describe(owner, argument, formula),
            sign,
            upper,
            argument=argument,
            lower=lower,
            infinite=infinite,
        )
        if not made.allows(made.default):
            raise self.wrong(
                owner, argument, f"expected a number {made.allowed}, got {made.default:g}"
            )
        if formula.number == 0:
            return formula
        if formula.kind == "name":
            mine = str(formula.value)
            self._inputs[mine] = _stricter(self._inputs[mine], made)
            return formula
        own = made.name.rstrip("_") if self.as_written else ""
        shared = self._shared.setdefault((formula, sign, upper, argument, lower, own), made.name)
        if shared != made.name:
            return name(shared)
        self._inputs[made.name] = made
        if excess := current().excess("sizes", len(self._inputs), exact=False):
            raise self.wrong(owner, argument, excess)
        return name(made.name)

    def _describe(self, owner: str, argument: str, formula: Formula) -> str:
        """Return the summary of an input; readers see long quotients as decimals."""
        if not owner:
            return argument.replace("_", " ")
        text = str(formula)
        if self.as_written:
            text = _LONG_QUOTIENT.sub(lambda one: repr(int(one[1]) / int(one[2])), text)
        return f"{argument} of {owner}: {text}"


def _stricter(own: Input, asked: Input) -> Input:
    """Return a parameter restricted to what a body allows."""
    order = ("any", "nonnegative", "positive")
    sign = max(own.sign, asked.sign, key=order.index)
    if own.sign == "positive" and asked.argument in NONNEGATIVE_ARGUMENTS:
        # Zero is a restitution, whatever a parameter allows that says nothing.
        sign = asked.sign
    uppers = [upper for upper in (own.upper, asked.upper) if upper is not None]
    lowers = [lower for lower in (own.lower, asked.lower) if lower is not None]
    return replace(
        own,
        sign=sign,
        upper=min(uppers, default=None),
        lower=max(lowers, default=None),
        infinite=own.infinite and asked.infinite,
    )


def _fraction(value: float) -> Fraction | float:
    """Return the shortest decimal of a double as a fraction; infinity unchanged."""
    return Fraction(repr(value)) if math.isfinite(value) else value


def _root(value: Fraction | float) -> Fraction | float:
    return _fraction(math.sqrt(value)) if value >= 0 else math.nan


def _free(wanted: str, taken: Mapping[str, Input]) -> str:
    while wanted in taken:
        wanted += "_"
    return wanted
