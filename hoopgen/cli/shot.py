"""``hoopgen shot``: one release, followed to its end."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hoopgen.cli.command import command
from hoopgen.cli.options import (
    UNITS_IN_WORDS,
    argument_options,
    backend_option,
    examples,
    json_option,
    max_contacts_option,
    preset_options,
    units_option,
)
from hoopgen.cli.own import (
    engine_of,
    max_contacts_of,
    own_options,
    parameters_of,
    released,
    shot_needs,
    state_of,
)
from hoopgen.cli.types import PAGE, PICTURE_OR_FILM
from hoopgen.inputs import Backend
from hoopgen.outputs import FILMS
from hoopgen.phrases import counted
from hoopgen.told import say_of
from hoopgen.words import for_json

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    import hoopgen

__all__ = ["shot"]


@command(
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
@max_contacts_option
@backend_option
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
    max_contacts: int,
    backend: Backend,
    picture: Path | None,
    page: Path | None,
    as_json: bool,
    position: Sequence[float] | None,
    velocity: Sequence[float] | None,
    spin: Sequence[float] | None,
    **release: float | None,
) -> None:
    """Simulate one shot: its events, its outcome, its picture, a page to turn it in space.

    The ball is released at a height and a distance, with a speed and an angle. Each contact is
    listed with its time and place and with the velocity before and after it. In a scene of one's
    own, the ball is released at a position, with a velocity.
    """
    import numpy as np

    import hoopgen

    engine = engine_of()
    parameters = parameters_of(engine, preset, settings)
    if engine.has_hoop:
        state = np.array(state_of(release))
    else:
        own = {"position": position, "velocity": velocity, "spin": spin}
        state = np.array(released(tuple(release), own))
    shots = hoopgen.simulate(
        state.reshape(1, 9),
        parameters=parameters,
        scene=engine,
        max_contacts=max_contacts_of(max_contacts),
        backend=backend,
        record=True,
    )
    if shots.outcome[0] == shots.scene.outcomes["INVALID"]:
        (why,) = hoopgen.why_invalid(state.reshape(1, 9), parameters, scene=engine)
        raise click.ClickException(f"this shot is invalid: {why}")
    if picture is not None:
        _draw(shots, picture)
    if page is not None:
        from hoopgen.viewer import view

        view(shots, parameters, page)
    if as_json:
        click.echo(
            json.dumps(for_json(_record(shots, state, parameters)), indent=2, allow_nan=False)
        )
    else:
        click.echo(_summary(shots, state))
        click.echo(f"scene      {say_of(shots.scene, parameters)}")


def _summary(shots: hoopgen.Shots, state: NDArray[np.float64]) -> str:
    from hoopgen.cli.report import event_table

    counts = zip(shots.surfaces, shots.counts[0], strict=True)
    by_surface = ", ".join(f"{name} {count}" for name, count in counts)
    path = shots.trajectory(0)
    lines = [
        event_table(state, path.events, shots.surfaces),
        "",
        f"outcome    {_outcome_text(shots)}",
        f"contacts   {shots.contacts[0]} ({by_surface})",
    ]
    for row, start, stop in path.rolls:
        name = shots.surfaces[int(path.events["surface"][row])]
        lines.append(f"rolls      on the {name} from {start:.3f} to {stop:.3f} s")
    if shots.uncertain[0]:
        lines.append("uncertain  yes: some decision is within the bound on its rounding error")
    return "\n".join(lines)


def _outcome_text(shots: hoopgen.Shots) -> str:
    """Say the outcome, and when and where the ball met the end plane."""
    import hoopgen
    from hoopgen.units import shown

    outcome = shots.scene.outcomes(int(shots.outcome[0]))
    said = outcome.name.lower()
    if not shots.scene.has_hoop:
        return f"{said}, after {shots.time[0]:.3f} s"
    if outcome == hoopgen.Outcome.CAPPED and shots.scene.rolls and shots.slip_left[0]:
        return f"{said}: its bounces end after {shots.time[0]:.3f} s, and slip is left"
    if outcome == hoopgen.Outcome.CAPPED:
        return f"{said}: {counted(shots.contacts[0], 'contact')}, and not yet at the end plane"
    if outcome == hoopgen.Outcome.SHORT:
        return f"{said}: the ball never comes down through the end plane"
    if outcome in (hoopgen.Outcome.LODGED, hoopgen.Outcome.ENDLESS):
        where = "at rest on the hoop" if outcome == hoopgen.Outcome.LODGED else "still on its way"
        return f"{said}: {where} after {shots.time[0]:.3f} s"
    off_centre = math.hypot(shots.state[0, 0], shots.state[0, 1])
    unit = shown("length")
    far = f"{off_centre / unit.size:.{unit.decimals}f} {unit.symbol}"
    return f"{said}, {far} from the centre of the ring after {shots.time[0]:.3f} s"


def _draw(shots: hoopgen.Shots, picture: Path) -> None:
    from hoopgen import plots

    path = shots.trajectory(0)
    title = shots.scene.outcomes(int(shots.outcome[0])).name.capitalize()
    if picture.suffix.lower() in FILMS:
        plots.save_film(path, path.parameters, picture, outcome=path.outcome)
    else:
        drawn = plots.plot_trajectory(path, path.parameters, outcome=path.outcome, title=title)
        plots.save(drawn, picture)


def _record(
    shots: hoopgen.Shots, state: NDArray[np.float64], parameters: Mapping[str, float]
) -> dict[str, Any]:
    """Collect everything about the shot in types that JSON knows."""
    from hoopgen.cli.report import surface_name
    from hoopgen.events import Event
    from hoopgen.study.named import COMPONENTS, in_units

    first = int(shots.first[0])
    record = {
        "outcome": shots.scene.outcomes(int(shots.outcome[0])).name.lower(),
        "uncertain": bool(shots.uncertain[0]),
        "contacts": int(shots.contacts[0]),
        "counts": dict(zip(shots.surfaces, shots.counts[0].tolist(), strict=True)),
        "first": surface_name(first, shots.surfaces) if first >= 0 else None,
        **(
            {"rolls": int(shots.rolls[0]), "slip_left": bool(shots.slip_left[0])}
            if shots.scene.rolls
            else {}
        ),
        "time": float(shots.time[0]),
        "state": shots.state[0].tolist(),
        "release": state.tolist(),
        "scene": say_of(shots.scene, parameters),
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
    return dict(in_units(record))
