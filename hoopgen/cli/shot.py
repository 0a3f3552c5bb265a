"""``hoopgen shot``: one release, followed to its end."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click
import numpy as np

import hoopgen
from hoopgen.core.backend_names import BackendName
from hoopgen.core.event_log import Event, describe_passages
from hoopgen.core.files import FILMS
from hoopgen.core.units import display_unit
from hoopgen.report.provenance import describe_scene
from hoopgen.report.quantities import for_json
from hoopgen.study.questions.settings import Engines
from hoopgen.study.questions.specification import EstimateQuestion
from hoopgen.text.numbers import format_count

from .command import command
from .messages import echo_json, examples
from .options import UNITS_IN_WORDS, argument_options, json_option, preset_options, units_option
from .path_types import PAGE, PICTURE_OR_FILM
from .question_options import setting_options
from .scene_option import engine_of, own_options, parameters_of, release_state, shot_needs
from .shot_report import event_table, surface_name

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from hoopgen.generated.numpy.hoop import ResultField


@command(
    short_help="Simulate one shot: its events, its outcome, its picture.",
    needs=shot_needs,
    epilog=UNITS_IN_WORDS
    + examples(
        "hoopgen shot --speed 7.17 --elevation 51deg --distance 13.75ft --height 7ft",
        "hoopgen shot --speed 16mph --elevation 0.9rad --distance 4.2 --height 2.1 --backspin 3Hz",
        "hoopgen shot --speed 9.2 --elevation 48deg --distance 22ft --height 7ft --angle 90deg \\",
        "    --picture corner.gif",
        "hoopgen shot --speed 7.2 --elevation 52deg --distance 13.75ft --height 7ft \\",
        "    --preset nba --set restitution=0.75 --picture shot.svg --view shot.html",
    ),
)
@argument_options(required=False)
@own_options
@preset_options
@setting_options(EstimateQuestion, only="max_contacts")
@setting_options(Engines)
@click.option(
    "--picture",
    type=PICTURE_OR_FILM,
    help="Draw the shot: .png, .svg or .pdf; or in motion, .gif, and .mp4 where there is ffmpeg.",
)
@click.option(
    "--view",
    "page",
    type=PAGE,
    help="Show the shot in motion in space, on a page: .html, one file that needs no network.",
)
@units_option
@json_option
def shot(
    preset: str,
    settings: Mapping[str, float],
    max_contacts: int | None,
    backend: BackendName,
    picture: Path | None,
    page: Path | None,
    as_json: bool,
    **release: Any,
) -> None:
    """Simulate one shot: its events, its outcome, its picture, a page to turn it in space.

    The ball is released at a height and a distance, with a speed and an angle. Each contact is
    listed with its time and place and with the velocity before and after it. In a scene of one's
    own, the ball is released at a position, with a velocity.
    """
    engine = engine_of()
    parameters = parameters_of(engine, preset, settings)
    state = np.array(release_state(engine, release)).reshape(1, 9)
    options: dict[str, Any] = {"max_contacts": max_contacts, "backend": backend, "record": True}
    shots = hoopgen.simulate(state, parameters=parameters, scene=engine, **options)
    if shots.outcome[0] == shots.scene.outcomes["INVALID"]:
        (why,) = hoopgen.why_invalid(state, parameters, scene=engine)
        raise click.ClickException(f"this shot is invalid: {why}")
    if picture is not None:
        _draw(shots, picture)
    if page is not None:
        hoopgen.view(shots, parameters, page)
    if as_json:
        echo_json(for_json(_record(shots, state[0], parameters)))
    else:
        click.echo(_summary(shots, state[0]))
        click.echo(f"scene      {describe_scene(shots.scene, parameters)}")


_ROLLING = {"hoop": "--scene court", "air": "--scene court-air"}
"""The scene of the same hoop in which a ball rolls, by the name of that in which none does."""


def _summary(shots: hoopgen.Shots, state: NDArray[np.float64]) -> str:
    counts = zip(shots.surfaces, shots.counts[0], strict=True)
    by_surface = ", ".join(f"{name} {count}" for name, count in counts)
    passages = describe_passages(int(shots.contacts[0]), int(shots.counts[0].sum()))
    path = shots.trajectory(0)
    lines = [
        event_table(state, path.events, shots.surfaces),
        "",
        f"outcome    {_outcome_text(shots)}",
        f"contacts   {shots.contacts[0]} ({by_surface}{passages})",
    ]
    airless = ", without air along it" if "airless_rolls" in shots.scene.layout.results else ""
    for row, start, stop in path.rolls:
        name = shots.surfaces[int(path.events["surface"][row])]
        lines.append(f"rolls      on the {name} from {start:.3f} to {stop:.3f} s{airless}")
    if _bounces_out(shots, path.events["time"]):
        rolling = _ROLLING.get(shots.scene.name, "rolls = true in the scene")
        lines.append(
            f"hint       the bounces become ever smaller; with {rolling} the ball then rolls"
        )
    if shots.uncertain[0]:
        lines.append("uncertain  yes: some decision is within the bound on its rounding error")
    return "\n".join(lines)


def _bounces_out(shots: hoopgen.Shots, times: NDArray[np.float64]) -> bool:
    """Return whether a shot is capped amid bounces of less than a millisecond each."""
    capped = shots.outcome[0] == shots.scene.outcomes["CAPPED"]
    few = 10
    return bool(
        capped and not shots.scene.rolls and len(times) > few and times[-1] - times[-few] < 1e-3
    )


def _outcome_text(shots: hoopgen.Shots) -> str:
    """Say the outcome, and when and where the ball met the end plane."""
    outcome = shots.scene.outcomes(int(shots.outcome[0]))
    name = outcome.name.lower()
    if not shots.scene.has_hoop:
        return f"{name}, after {shots.time[0]:.3f} s"
    if outcome == hoopgen.Outcome.CAPPED and shots.scene.rolls and shots.slip_left[0]:
        return f"{name}: its bounces end after {shots.time[0]:.3f} s, and slip is left"
    if outcome == hoopgen.Outcome.CAPPED:
        return f"{name}: {format_count(shots.contacts[0], 'contact')}, and not yet at the end plane"
    if outcome == hoopgen.Outcome.SHORT:
        return f"{name}: the ball never comes down through the end plane"
    if outcome in (hoopgen.Outcome.LODGED, hoopgen.Outcome.ENDLESS):
        where = "at rest on the hoop" if outcome == hoopgen.Outcome.LODGED else "still on its way"
        return f"{name}: {where} after {shots.time[0]:.3f} s"
    off_centre = math.hypot(shots.state[0, 0], shots.state[0, 1])
    unit = display_unit("length")
    far = f"{off_centre / unit.size:.{unit.decimals}f} {unit.symbol}"
    return f"{name}, {far} from the centre of the ring after {shots.time[0]:.3f} s"


def _draw(shots: hoopgen.Shots, picture: Path) -> None:
    plots = hoopgen.plots
    path = shots.trajectory(0)
    title = shots.scene.outcomes(int(shots.outcome[0])).name.capitalize()
    if picture.suffix.lower() in FILMS:
        plots.save_film(path, path.parameters, picture, outcome=path.outcome)
    else:
        drawn = plots.plot_trajectory(path, path.parameters, outcome=path.outcome, title=title)
        plots.save(drawn, picture)


def _value(result: ResultField, value: Any) -> Any:
    """Return a result of the shot in types that JSON knows; None for a code that says nothing."""
    if result.flags:
        return result.flags[int(value) - result.first_flag] if value >= 0 else None
    if result.row and not result.units:
        return dict(zip(result.coordinates, value.tolist(), strict=True))
    return value.tolist()


def _record(
    shots: hoopgen.Shots, state: NDArray[np.float64], parameters: Mapping[str, float]
) -> dict[str, Any]:
    """Return everything about the shot in types that JSON knows."""
    from hoopgen.study.named_units import COMPONENTS, in_units

    layout = shots.scene.layout
    record = {
        **{name: _value(layout.results[name], getattr(shots, name)[0]) for name in layout.fields},
        "release": state.tolist(),
        "scene": describe_scene(shots.scene, parameters),
        "parameters": {name: float(value) for name, value in parameters.items()},
        "events": [
            {
                "kind": Event(int(event["kind"])).name.lower(),
                "surface": surface_name(int(event["surface"]), shots.surfaces),
                "time": float(event["time"]),
                "before": event["before"].tolist(),
                "after": event["after"].tolist(),
            }
            for event in shots.trajectory(0).events
        ],
        "components": COMPONENTS,
    }
    by_body = {name: value for name, value in record.items() if name in layout.results}
    by_body = {name: value for name, value in by_body.items() if isinstance(value, Mapping)}
    return {**in_units(record, shots.scene), **by_body}  # a body may be named as what has a unit
