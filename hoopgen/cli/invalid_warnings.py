"""The warning about invalid sampled shots, which a command prints."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import click
import numpy as np

import hoopgen
from hoopgen.text.escape import printable
from hoopgen.text.numbers import format_count

if TYPE_CHECKING:
    from hoopgen.core.variables import Releases
    from hoopgen.simulation.engine import Engine

MAX_SHOTS = 1000
"""Number of shots whose reasons are looked for."""


def warn_invalid(
    model: Any, parameters: Mapping[str, Any], scene: Engine, invalid: int, total: int, seed: int
) -> None:
    """Print on stderr why shots that a model draws with a seed are invalid, where some are.

    Parameters
    ----------
    model
        The release model of the shots.
    parameters
        Parameters of the scene, SI.
    scene
        The scene that they were flown in.
    invalid, total
        The numbers of invalid shots and of all; without invalid ones nothing is printed.
    seed
        The seed of the shots, of which the first are drawn again to find the causes.
    """
    if invalid:
        released = model.draw(0, min(total, MAX_SHOTS), seed, parameters)
        shots = hoopgen.simulate(
            released.states, released.parameters, scene=scene, fields=["outcome"]
        )
        warn_invalid_shots(model, released, shots, invalid, total)


def warn_invalid_shots(
    model: Any, released: Releases, shots: hoopgen.Shots, invalid: int, total: int
) -> None:
    """Print on stderr why shots are invalid, where some are, by the first ones.

    Parameters
    ----------
    model
        The release model of the shots.
    invalid, total
        Number of invalid ones among all shots, and of all.
    """
    if not invalid:
        return
    from hoopgen.study.tables.invalid_rows import shot_reason

    rows = np.flatnonzero(shots.outcome == shots.scene.outcomes["INVALID"])[:MAX_SHOTS].tolist()
    said = model.identity()
    aimed = not {"aim", "entry"}.isdisjoint({*said.get("release", ()), *said.get("columns", ())})
    reasons = Counter(shot_reason(released, row, shots.scene, aimed=aimed) for row in rows)
    # If invalid shots are few, there may be none among the first.
    why = "; ".join(reason for reason, _ in reasons.most_common(3))
    text = f"{invalid:,} of {format_count(total, 'shot')} invalid{f': {why}' if why else ''}"
    click.echo(f"hoopgen: {printable(text)}", err=True)
