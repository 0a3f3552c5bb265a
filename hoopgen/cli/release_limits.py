"""Limits of the variables of a release at a hoop, for options: errors are in the user's units."""

from __future__ import annotations

from collections.abc import Mapping

import click

from hoopgen.core.si_checks import MAX_LENGTH, MAX_SPIN
from hoopgen.core.units import DEGREE, Kind
from hoopgen.hoop.releases import FROM_ZERO
from hoopgen.hoop.variables import ALTERNATIVE_VARIABLES, ARGUMENTS
from hoopgen.study.models.plausible import check_plausible
from hoopgen.text.shorten import brief

from .command import ARGUMENTS as WORDS

_LIMITS: Mapping[Kind, tuple[float, str]] = {
    "angle": (360 * DEGREE, "an angle from -360deg to 360deg"),
    "spin": (MAX_SPIN, f"a spin from -{MAX_SPIN:g}rad/s to {MAX_SPIN:g}rad/s, 15.9Hz or 955rpm"),
    "length": (MAX_LENGTH, f"a length from -{MAX_LENGTH:g}m to {MAX_LENGTH:g}m"),
}
"""The largest sizes of quantities of a release, SI, as of `hoopgen.core.si_checks`."""


def check_release(name: str, value: float, text: str) -> float:
    """Return the value of a variable at a hoop, if it is plausible, or asked for within limits.

    Parameters
    ----------
    name
        The name of the variable; "" and others have no limits.
    value
        Its value, SI.
    text
        The value as it was written, for the error.

    Raises
    ------
    ValueError
        If it is negative or outside of the limits, which the message says.
    """
    value = from_zero(name, value, text)
    kept = _keeps_implausible()
    variable = ARGUMENTS.get(name) or ALTERNATIVE_VARIABLES.get(name)
    if variable and (kept or variable.kind == "spin"):
        most, words = _LIMITS.get(variable.kind, (float("inf"), ""))
        if abs(value) > most:
            raise ValueError(f"expected {words}; got {brief(text)}")
    return value if kept else check_plausible(name, value, text)


def from_zero(name: str, value: float, text: str) -> float:
    """Return the value of a variable; refuse a negative one of those in `FROM_ZERO`.

    Parameters
    ----------
    name, value, text
        As for `check_release`.

    Raises
    ------
    ValueError
        If it is negative, and the variable has no negative values.
    """
    if name in FROM_ZERO and value < 0.0:
        raise ValueError(f"expected 0 {FROM_ZERO[name]} or more, got {brief(text)}")
    return value


def _keeps_implausible() -> bool:
    """Return whether the command's words ask for implausible numbers."""
    context = click.get_current_context(silent=True)
    return context is not None and "--keep-implausible" in context.meta.get(WORDS, ())
