"""The type of ``--distance`` of ``hoopgen aim``: a length, several, or a range with its step."""

from __future__ import annotations

import math

from hoopgen.core.si_checks import MAX_LENGTH
from hoopgen.core.units import parse_quantity
from hoopgen.text.shorten import brief

from .types import Parsed

_MAX_DISTANCES = 10_000

_ROUNDING = 1e-6
"""Part of a step by which a range may miss a whole number of steps: 0.1 is no binary number."""


def _distances(text: str) -> tuple[float, ...]:
    parts = text.split(":")
    if len(parts) == 1:
        lengths = tuple(parse_quantity(part, "length") for part in text.split(","))
    elif len(parts) == 3:
        lengths = _range(text, *(parse_quantity(part, "length") for part in parts))
    else:
        raise ValueError(f"{brief(text)} is not FROM:TO:STEP, such as 1m:7m:0.5m")
    if not 0.0 <= min(lengths) <= max(lengths) <= MAX_LENGTH:
        raise ValueError(f"expected distances from 0m to {MAX_LENGTH:g}m; got {brief(text)}")
    return lengths


def _range(text: str, low: float, high: float, step: float) -> tuple[float, ...]:
    steps = (high - low) / step if step > 0.0 else -1.0  # more than any number is infinite
    count = 1 + math.floor(min(steps, _MAX_DISTANCES) + _ROUNDING)
    if not 2 <= count <= _MAX_DISTANCES:
        raise ValueError(
            f"{brief(text)}: expected FROM:TO:STEP of 2 to {_MAX_DISTANCES:,} distances, FROM "
            f"below TO; it is {low:.6g} m to {high:.6g} m in steps of {step:.6g} m"
        )
    return tuple(low + k * step for k in range(count))


DISTANCES = Parsed(_distances, "LENGTH [m] | FROM:TO:STEP")
"""A length; several, ``3m,4m,5m``; or a range, ``1m:7m:0.5m``."""
