"""Why shots are invalid: said of what a command throws, where some of it cannot be simulated."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import click
import numpy as np

from hoopgen.phrases import counted
from hoopgen.printable import printable

if TYPE_CHECKING:
    import hoopgen
    from hoopgen.engines import Engine
    from hoopgen.variables import Releases

__all__ = ["invalid_reasons", "warn_invalid", "warn_invalid_shots"]

MAX_LOOKED_AT = 1000
"""Shots whose reasons are looked for."""


def invalid_reasons(released: Releases, shots: hoopgen.Shots) -> list[str]:
    """Return why shots are invalid, the most frequent reason first, for the first such shots."""
    from hoopgen.study.reasons import shot_reason

    invalid = shots.outcome == shots.scene.outcomes["INVALID"]
    rows = np.flatnonzero(invalid)[:MAX_LOOKED_AT].tolist()
    found = [shot_reason(released, row, shots.scene) for row in rows]
    return [reason for reason, _ in Counter(found).most_common()]


def warn_invalid(
    model: Any, parameters: Mapping[str, Any], scene: Engine, invalid: int, total: int, seed: int
) -> None:
    """Say on stderr why shots of a model are invalid, where some are.

    Parameters
    ----------
    model
        That draws them.
    parameters
        Of the scene.
    scene
        In which they are simulated.
    invalid, total
        How many are, and of how many.
    seed
        With which they were drawn.
    """
    if not invalid:
        return
    import hoopgen

    released = model.draw(0, min(total, MAX_LOOKED_AT), seed, parameters)
    shots = hoopgen.simulate(released.states, released.parameters, scene=scene, fields=["outcome"])
    warn_invalid_shots(released, shots, invalid, total)


def warn_invalid_shots(released: Releases, shots: hoopgen.Shots, invalid: int, total: int) -> None:
    """Say on stderr why shots are invalid, where some are.

    Parameters
    ----------
    released, shots
        Some of them, or all.
    invalid, total
        How many are, and of how many.
    """
    if not invalid:
        return
    # Where they are few there may be none among the first.
    why = f": {'; '.join(said[:3])}" if (said := invalid_reasons(released, shots)) else ""
    click.echo(
        f"hoopgen: {invalid:,} of {counted(total, 'shot')} invalid{printable(why)}", err=True
    )
