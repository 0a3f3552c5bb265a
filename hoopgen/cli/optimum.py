"""``hoopgen optimum``: the best release for a player's scatter, in words."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import hoopgen
from hoopgen.scene.lookup import check_hoop
from hoopgen.study.questions.settings import SUCCESSES
from hoopgen.study.questions.specification import OptimumQuestion

from .command import command
from .messages import echo_json, examples, shown
from .options import UNITS_IN_WORDS, json_option, picture_option, units_option
from .question_options import question_options
from .release_options import Releasing, from_option, release_needs, release_options

if TYPE_CHECKING:
    from hoopgen.study.jobs.objective import By

_AIMING = ("speed", "aim", "azimuth")
"""Variables whose usual ranges are other ones for another way in."""


@command(
    short_help="Find the release that goes in most often.",
    needs=release_needs,
    epilog=UNITS_IN_WORDS
    + examples(
        "hoopgen optimum --over elevation --over aim --height 7ft --distance 13.75ft \\",
        "    --backspin 3Hz --scatter speed=0.07 --scatter elevation=1.3deg --scatter azimuth=1deg",
        "hoopgen optimum --over elevation=45deg:60deg --over aim=-5cm:12cm --height 7ft \\",
        "    --distance 13.75ft --scatter speed=0.1 --scatter elevation=1.5deg --picture best.svg",
        "hoopgen optimum --over elevation --over aim --over azimuth --by bank --versus direct \\",
        "    --height 7ft --distance 10ft --angle 60deg --backspin 3Hz \\",
        "    --scatter speed=0.07 --scatter elevation=1.3deg --scatter azimuth=1deg",
    ),
)
@release_options
@from_option
@question_options(OptimumQuestion)
@click.option(
    "--versus",
    type=click.Choice(SUCCESSES),
    help="Also find the best shot of this kind, aimed within the usual range, and print which is "
    "better.",
)
@picture_option("paths of fresh shots of the best release")
@units_option
@json_option
def optimum(
    over: Mapping[str, tuple[float, float] | None],
    releasing: Releasing,
    by: By,
    versus: By | None,
    folder: Path | None,
    picture: Path | None,
    as_json: bool,
    **work: Any,
) -> None:
    """Find the release that goes in most often, given a player's scatter.

    All candidates are simulated with the same random errors. The probability is that of fresh
    shots; of measured releases, --from, it is that of rows that had no part in the search. The
    margins say how far off each variable alone may be.
    """
    from hoopgen.study.named_units import in_units
    from hoopgen.study.questions.optimum_result import advice

    model, parameters = releasing.model(over=over)
    scene = releasing.engine
    if versus is not None:
        check_hoop("--versus", scene)
    with shown() as progress:
        work |= {"scene": scene, "progress": progress}
        best = hoopgen.optimum(model, over, parameters, by=by, folder=folder, **work)
        rival = None
        if versus is not None:
            # Another way in is aimed elsewhere.
            usual = {n: None if n in _AIMING else ends for n, ends in over.items()}
            work |= {"margins": (), "folder": folder and folder / "versus"}
            rival = hoopgen.optimum(model, usual, parameters, by=versus, **work)
    if picture is not None:
        hoopgen.plots.save(best.plot(), picture)
    if as_json:
        record = best.as_dict()
        if rival is not None:
            lead = dict(zip(("lead", "low", "high"), best.lead(rival), strict=True))
            record["versus"] = rival.as_dict() | lead
        echo_json(in_units(record, scene))
    else:
        click.echo(advice(best, rival))
