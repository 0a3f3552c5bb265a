"""``hoopgen counterfactual``: what would have to be different for a shot to end otherwise."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click
import numpy as np

import hoopgen
from hoopgen.study.questions.specification import CounterfactualQuestion

from .command import command
from .messages import echo_json, examples
from .options import UNITS_IN_WORDS, argument_options, json_option, preset_options, units_option
from .path_types import PICTURE
from .question_options import question_options
from .scene_option import engine_of, own_options, parameters_of, release_state, shot_needs


@command(
    short_help="Find the smallest changes with which a shot ends otherwise.",
    needs=shot_needs,
    epilog=UNITS_IN_WORDS
    + examples(
        "hoopgen counterfactual --speed 7.05 --elevation 51deg --distance 13.75ft --height 7ft",
        "hoopgen counterfactual --speed 20mph --elevation 50deg --distance 22ft --height 7ft \\",
        "    --azimuth 1deg --backspin 2Hz --scene court --preset nba --vary speed \\",
        "    --vary azimuth --vary backspin --units us --picture changes.svg",
    ),
)
@argument_options(required=False)
@own_options
@preset_options
@question_options(CounterfactualQuestion)
@click.option(
    "--prove/--no-prove",
    default=True,
    show_default=True,
    help="Prove in ball arithmetic how the shot ends on both sides of each change.",
)
@click.option(
    "--picture", type=PICTURE, help="Draw the shot and the changed ones: .png, .svg or .pdf."
)
@units_option
@json_option
def counterfactual(
    preset: str,
    settings: Mapping[str, float],
    vary: tuple[str, ...],
    by: str | None,
    steady: float,
    max_contacts: int | None,
    prove: bool,
    picture: Path | None,
    as_json: bool,
    **release: Any,
) -> None:
    """Find the smallest changes with which a shot ends otherwise.

    A missed shot goes in with a little more speed, a higher angle or another direction; a made
    one misses. Each variable is changed alone.
    """
    from hoopgen.study.named_units import in_units

    engine = engine_of()
    parameters = parameters_of(engine, preset, settings)
    state = np.array(release_state(engine, release)).reshape(1, 9)
    shots = hoopgen.simulate(state, parameters, scene=engine, max_contacts=max_contacts)
    answer = hoopgen.counterfactual(
        shots, vary=vary or None, by=by, steady=steady, max_contacts=max_contacts, prove=prove
    )
    if picture is not None:
        hoopgen.plots.save(answer.plot(), picture)
    if as_json:
        echo_json(in_units(answer.as_dict(), engine))
    else:
        click.echo(str(answer))
