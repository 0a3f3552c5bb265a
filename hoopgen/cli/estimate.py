"""``hoopgen estimate``: how probably a shot is made, what a change does, with which scatter."""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import hoopgen
from hoopgen.report.quantities import format_variable
from hoopgen.study.questions.settings import settings
from hoopgen.study.questions.specification import CompareQuestion, EstimateQuestion, SolveQuestion
from hoopgen.text.shorten import join_names

from .command import ARGUMENTS, command
from .invalid_warnings import warn_invalid
from .messages import echo_json, echo_lines, examples, shown
from .options import UNITS_IN_WORDS, json_option, picture_option, units_option
from .question_options import check_caught, question_options
from .release_options import Releasing, from_option, release_needs, release_options

if TYPE_CHECKING:
    from hoopgen.simulation.engine import Engine

_PLAYER = "--scatter speed=0.07 --scatter elevation=1.3deg --scatter azimuth=1deg"
_PITCH = "--scatter vx=0.1 --scatter vy=0.05"


@command(
    short_help="Estimate how probably a shot is made.",
    needs=release_needs,
    epilog=UNITS_IN_WORDS
    + examples(
        "hoopgen estimate --speed 7.17 --elevation 52deg --backspin 3Hz --height 7ft \\",
        f"    --distance 13.75ft {_PLAYER} \\",
        "    --gradient mean.speed --gradient restitution --picture shares.svg",
        "hoopgen estimate --aim 5cm --elevation 52deg --backspin 3Hz --height 7ft \\",
        f"    --distance 13.75ft {_PLAYER} \\",
        "    --preset nba --precision 0.001 --versus backspin=0",
        "hoopgen estimate --scene golf.toml --position=-30cm,0,20cm --velocity 1.4,0,0 \\",
        "    --scatter vx=0.1 --scatter vy=0.05 --max-contacts 30",
        "hoopgen estimate --from releases.csv --place elbow --height 7ft --fitted --solve 70%",
    ),
)
@release_options
@from_option
@question_options(EstimateQuestion, CompareQuestion, SolveQuestion)
@picture_option("shares of how they end, and of what they touch")
@units_option
@json_option
def estimate(
    releasing: Releasing,
    versus: Mapping[str, float],
    share: float | None,
    precision: float | None,
    measures: tuple[str, ...],
    gradient: tuple[str, ...],
    picture: Path | None,
    as_json: bool,
    **work: Any,
) -> None:
    """Estimate how probably a shot is made.

    Shots scatter about a release, or are drawn from measured ones. The answer is the probability
    with its confidence interval, and the shares of swishes, shots off the rim, bank shots and so
    on; --measure adds the distribution of a measure, and of rebound_angle the rebounds by
    direction. --gradient adds derivatives of the probability. With --scene shots scatter about a
    position and a velocity, and the answer is the share of each end. --solve asks the other way
    round: how wide is the scatter of somebody who makes so many?
    """
    from hoopgen.study.named_units import in_units

    if share is not None and (versus or precision is not None):
        other = "--versus" if versus else "--precision"
        raise click.UsageError(f"--solve and {other} ask different questions; leave one out")
    if measures and (versus or share is not None):
        other = "--versus" if versus else "--solve"
        raise click.UsageError(f"--measure is of one setting, without {other}.")
    if gradient and (versus or share is not None):
        other = "--versus" if versus else "--solve"
        raise click.UsageError(f"--gradient is of one setting, without {other}.")
    if releasing.measured and not releasing.fitted and (own := [n for n in gradient if "." in n]):
        said = "is of a scatter, which measured releases have with --fitted"
        raise click.UsageError(f"--gradient: {own[0]} {said}.")
    if work["by"] is not None and not versus and share is None:
        from hoopgen.study.jobs.monte_carlo import outcome_by

        outcome_by(releasing.engine, work["by"])
        raise click.UsageError("--by is of --versus and --solve; without them each end has a share")
    check_caught(measures)
    work |= {"precision": precision, "measures": measures, "gradient": gradient}
    if share is not None and not (releasing.sd or releasing.measured):
        raise click.UsageError(_needs_scatter(releasing.engine))
    if releasing.fitted and share is None and not versus:
        options = _options_of(EstimateQuestion, work)
        _estimate_fitted(releasing, options, picture, as_json)
        return
    (model, parameters), scene = releasing.model(), releasing.engine
    question: Any = CompareQuestion if versus else EstimateQuestion
    question = SolveQuestion if share is not None else question
    options = _options_of(question, work)
    with shown() as progress:
        options |= {"scene": scene, "progress": progress}
        result: Any
        if share is not None:
            result = hoopgen.solve(model, share, parameters, **options)
        elif versus:
            result = hoopgen.compare((model, parameters), releasing.model(versus), **options)
        else:
            result = hoopgen.estimate(model, parameters, **options)
    if picture is not None:
        hoopgen.plots.save(hoopgen.plots.plot_estimate(result), picture)
    if as_json:
        echo_json(in_units(result.as_dict(), scene))
    else:
        if versus:
            changes = ", ".join(_changed(scene, name, to) for name, to in versus.items())
            click.echo(f"versus      {changes}")
        click.echo(result)
    if question is EstimateQuestion:
        invalid = result.invalid if scene.has_hoop else result.counts["invalid"]
        warn_invalid(model, parameters, scene, invalid, result.shots, work["seed"])
    if precision is not None and result.half_width > precision:
        click.echo("hoopgen: the precision was not reached; more --shots", err=True)


def _estimate_fitted(
    releasing: Releasing, options: Mapping[str, Any], picture: Path | None, as_json: bool
) -> None:
    """Print the fitted scatter and its estimate; with a group, of each player."""
    from hoopgen.study.models.fitted_scatter import FittedScatter
    from hoopgen.study.named_units import in_units

    fitted, scene = releasing.fit(), releasing.engine
    players = {"": fitted} if isinstance(fitted, FittedScatter) else dict(fitted)
    if picture is not None and len(players) > 1:
        raise click.UsageError("--picture is of one player; choose one by --where")
    found = {}
    for label, one in players.items():
        with shown() as progress:
            found[label] = hoopgen.estimate(
                one, releasing.parameters, scene=scene, progress=progress, **options
            )
    if picture is not None:
        hoopgen.plots.save(hoopgen.plots.plot_estimate(found[""]), picture)
    if as_json:
        both = {
            label: {"scatter": one.as_dict(), **in_units(found[label].as_dict(), scene)}
            for label, one in players.items()
        }
        echo_json(both.get("", {"players": both}))
        return
    for label, one in players.items():
        heading = f"{label}: " if label else ""
        echo_lines(f"{heading}{one}\n\n{found[label]}\n")
    if not isinstance(fitted, FittedScatter) and fitted.left_out:
        click.echo(f"too few releases: {join_names(fitted.left_out)}")


def _options_of(question: Any, given: Mapping[str, Any]) -> dict[str, Any]:
    """Return those of the options that the Python function of a question takes."""
    specifications = (question, *question.shared)
    names = {name for each in specifications for name, _, one, _ in settings(each) if one.argument}
    return {name: value for name, value in given.items() if name in names}


def _needs_scatter(scene: Engine) -> str:
    """Return the error that says with a whole command what ``--solve`` multiplies."""
    words = click.get_current_context().meta[ARGUMENTS]
    more = shlex.split(_PLAYER if scene.has_hoop else _PITCH)
    return (
        "--solve multiplies the scatter, and here nothing scatters: give --scatter, or --from with "
        f"measured releases. For example: {shlex.join(['hoopgen', 'estimate', *words, *more])}"
    )


def _changed(scene: Engine, name: str, value: float) -> str:
    return f"{name} {format_variable(name, value) if scene.has_hoop else f'{value:g}'}"
