"""Laws of contact of a body: restitution, friction and tangential restitution."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from .formulas import ZERO, Formula
from .inputs import Inputs


@dataclass(frozen=True)
class Contact:
    """The law of contact of a body; without friction or speed both are infinite."""

    restitution: Formula
    friction: Formula | None = None
    tangential: Formula = ZERO
    speed: Formula | None = None


CONTACT_ARGUMENTS = ("restitution", "friction", "tangential", "restitution_speed")
"""The arguments of a body, and of a scene for those that do not have them."""


def contact(inputs: Inputs, owner: str, body: object, usual: Mapping[str, Any]) -> Contact:
    """Return a body's law of contact, from its own arguments or else the scene's.

    Parameters
    ----------
    inputs
        The inputs of the scene, to which sizes are added.
    owner
        The body's name, for error messages.
    body
        The body as the author wrote it.
    usual
        The scene's own arguments, for those that the body does not have.

    Raises
    ------
    SceneError
        If one is missing or not allowed.
    """

    def size(argument: str, **allowed: Any) -> Formula | None:
        own = getattr(body, argument)
        given = usual[argument] if own is None else own
        if given is None or (allowed.get("infinite") and is_infinite(given)):
            return None
        formula = inputs.read(owner, argument, given)
        # Readers are told whose it is: bodies without one of their own have the scene's.
        whose = "" if inputs.as_written and own is None else owner
        return inputs.add(whose, argument, formula, **allowed)

    restitution = size("restitution", sign="nonnegative", upper=1.0, unit="1")
    if restitution is None:
        raise inputs.wrong(owner, "restitution", "missing, and the scene has none either")
    return Contact(
        restitution,
        size("friction", sign="nonnegative", unit="1", infinite=True),
        size("tangential", lower=-1.0, upper=1.0, unit="1") or ZERO,
        size("restitution_speed", sign="positive", unit="m/s", infinite=True),
    )


def is_infinite(given: object) -> bool:
    """Return whether a number is infinite and not negative."""
    return isinstance(given, float) and given == math.inf
