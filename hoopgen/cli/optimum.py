"""``hoopgen optimum``: the best release for a player's scatter, in words."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hoopgen.cli.command import command
from hoopgen.cli.options import (
    UNITS_IN_WORDS,
    WAYS,
    by_option,
    confidence_option,
    examples,
    folder_option,
    json_option,
    picture_option,
    scheduler_option,
    seed_option,
    threads_option,
    units_option,
)
from hoopgen.cli.releasing import Releasing, from_option, release_needs, release_options
from hoopgen.cli.types import BOUNDS, COUNT, once

if TYPE_CHECKING:
    from hoopgen.study.best import Optimum
    from hoopgen.study.player import By

__all__ = ["optimum"]

_AIMING = ("speed", "aim", "azimuth")
"""Variables whose usual ranges are other ones for another way in."""


@command(
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
@click.option(
    "--over",
    type=BOUNDS,
    multiple=True,
    callback=once,
    required=True,
    help="A variable to search over; without low and high, over the usual range. May be repeated.",
)
@release_options
@from_option
@by_option
@click.option(
    "--versus",
    type=click.Choice(WAYS),
    help="Find the best shot of this way too, aimed within the usual range; say which is better.",
)
@click.option(
    "--shots",
    type=COUNT,
    default=100_000,
    show_default=True,
    help="Of the last step of the search, and of the estimate. Of --from every row is judged once.",
)
@seed_option
@confidence_option
@threads_option
@folder_option
@scheduler_option
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

    All candidates are thrown with the same random errors. The probability is of fresh shots; of
    measured releases, --from, it is of rows that had no part in the search. What the release
    forgives comes with it: how far off each variable alone may be.
    """
    from hoopgen.cli.progress import shown
    from hoopgen.scenes import check_hoop
    from hoopgen.study.best import advice
    from hoopgen.study.optimum import optimum as best_release

    model, parameters = releasing.model(over=over)
    scene = releasing.engine
    if versus is not None:
        check_hoop("--versus", scene)
    with shown() as progress:
        options = {"progress": progress, **work}
        best = best_release(model, over, parameters, scene=scene, by=by, folder=folder, **options)
        rival = None
        if versus is not None:
            # Another way in is aimed elsewhere.
            usual = {n: None if n in _AIMING else ends for n, ends in over.items()}
            beside = folder and folder / "versus"
            rival = best_release(
                model,
                usual,
                parameters,
                scene=scene,
                by=versus,
                margins=(),
                folder=beside,
                **options,
            )
    if picture is not None:
        from matplotlib.figure import Figure

        from hoopgen import plots

        drawn = best.plot()
        assert isinstance(drawn, Figure)
        plots.save(drawn, picture)
    if as_json:
        click.echo(json.dumps(_record(best, rival), indent=2, allow_nan=False))
    else:
        click.echo(advice(best, rival))


def _record(best: Optimum, rival: Optimum | None) -> dict[str, Any]:
    from hoopgen.study.named import in_units

    record = best.as_dict()
    if rival is not None:
        difference, low, high = best.lead(rival)
        record["versus"] = rival.as_dict() | {"lead": difference, "low": low, "high": high}
    return dict(in_units(record))
