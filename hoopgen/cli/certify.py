"""``hoopgen certify``: one release, and what it does, proved."""

from __future__ import annotations

import json
from collections.abc import Mapping
from itertools import takewhile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hoopgen.report.provenance import describe_scene
from hoopgen.study.questions.specification import EstimateQuestion
from hoopgen.text.numbers import format_count
from hoopgen.text.tables import table

from .command import command
from .messages import examples
from .options import UNITS_IN_WORDS, argument_options, json_option, preset_options, units_option
from .path_types import FILE
from .question_options import setting_options
from .scene_option import NEEDED, engine_of, own_options, parameters_of, release_state, shot_needs
from .shot_report import surface_name
from .types import whole

if TYPE_CHECKING:
    from hoopgen.judge import Proof
    from hoopgen.simulation.engine import Engine

CLOSE = 1e-3
"""Seconds before the last event of a shot; the events of one body since then share a line."""

MAX_LISTED_EVENTS = 3
"""Events on one body, one soon after another, that have a line each."""


def _needs(typed: Mapping[str, Any]) -> list[str]:
    first, *rest = [*shot_needs(typed), ""]
    all_missing = len(rest) == len(NEEDED)
    return [name for name in (f"FILE, or {first}" if all_missing else first, *rest) if name]


@command(
    short_help="Prove what a shot does, in ball arithmetic.",
    needs=_needs,
    epilog=UNITS_IN_WORDS
    + examples(
        "hoopgen certify --speed 7.17 --elevation 51deg --distance 13.75ft --height 7ft",
        "hoopgen shot --speed 7.3 --elevation 51deg --distance 4.2 --height 2.1 --json > shot.json",
        "hoopgen certify shot.json",
    ),
)
@click.argument("file", required=False, type=FILE)
@argument_options(required=False)
@own_options
@preset_options
@setting_options(EstimateQuestion, only="max_contacts")
@click.option(
    "--max-bits",
    type=whole(128),
    default=4096,
    show_default=True,
    help="Precision, in bits, up to which decisions are tried.",
)
@units_option
@json_option
@click.pass_context
def certify(
    ctx: click.Context,
    /,
    file: Path | None,
    preset: str,
    settings: Mapping[str, float],
    max_contacts: int | None,
    max_bits: int,
    as_json: bool,
    **release: Any,
) -> None:
    """Prove what one shot does: its contacts, their order, its outcome.

    The shot is that of FILE, as `hoopgen shot --json` writes it, or that of the options. It is
    simulated in ball arithmetic with more and more bits, until every decision is proved. Exit
    status 1 if the outcome is not proved: two contacts at once, an exact touch, an exact edge; or
    a ball whose bounces accumulate, so that it rolls, which the judge does not follow. It then says
    how far the proof goes.
    """
    from hoopgen.judge import certify as prove
    from hoopgen.study.named_units import in_units

    engine = engine_of()
    if file is not None:
        state, written = _read(file, engine)
        parameters: Mapping[str, float] = {**written, **settings}
    else:
        state, parameters = release_state(engine, release), parameters_of(engine, preset, settings)
    proof = prove(
        state, parameters, scene=engine, max_contacts=max_contacts, max_bits=max_bits, record=True
    )[0]
    scene = describe_scene(engine, parameters)
    if as_json:
        click.echo(
            json.dumps({**in_units(_record(proof, engine), engine), "scene": scene}, indent=2)
        )
    else:
        click.echo(f"{_summary(proof, engine)}\nscene      {scene}")
    if not proof.decided:
        ctx.exit(1)


def _read(file: Path, scene: Engine) -> tuple[list[float], dict[str, float]]:
    from hoopgen.study.named_units import parameters_named

    try:
        record = json.loads(file.read_text(encoding="utf-8"))
        parameters = parameters_named(dict(record["parameters"]), scene)
        return list(record["release"]), {name: float(it) for name, it in parameters.items()}
    except (ValueError, KeyError, TypeError, RecursionError):
        raise click.ClickException(
            f"{file}: expected what `hoopgen shot --json` writes, with release and parameters"
        ) from None


def _outcome(proof: Proof, engine: Engine) -> str:
    return engine.outcomes(proof.outcome).name.lower() if proof.decided else "undecided"


def _together(proof: Proof) -> int:
    """Return the number of final events on one body in quick succession, 0 if they are few."""
    events = reversed(list(zip(proof.surfaces, proof.times, strict=True)))
    run = takewhile(lambda e: e[0] == proof.surfaces[-1] and e[1] >= proof.until - CLOSE, events)
    count = sum(1 for _ in run)
    return count if count > MAX_LISTED_EVENTS else 0


def _summary(proof: Proof, engine: Engine) -> str:
    alone = len(proof.events) - _together(proof)
    names = [surface_name(event.surface, engine.surfaces) for event in proof.events]
    rows = [
        [str(number), names[number - 1], str(event.time)]
        for number, event in enumerate(proof.events[:alone], 1)
    ]
    if alone < len(proof.events):
        within = _duration(proof.times[-1] - proof.times[alone])
        numbers = f"{alone + 1:,}-{len(proof.events):,}"
        rows.append([numbers, names[alone], f"{proof.events[alone].time}, all within {within}"])
    head = ["#", "surface", "time (s), as far as proved"]
    lines = [table(head, rows, right=[0]), ""] if rows else []
    impacts = format_count(sum(k < len(engine.surfaces) for k in proof.surfaces), "impact")
    if proof.decided:
        lines += [f"outcome    {_outcome(proof, engine)}", f"proved     with {proof.bits} bits"]
    else:
        why = "not proved: " if proof.accumulates else f"at {proof.bits} bits: "
        lines += [
            f"{'outcome  ' if proof.accumulates else 'undecided'}  {why}{proof.question}",
            f"proved     {impacts}, until {proof.until:.6f} s, with {proof.bits} bits",
        ]
    return "\n".join(lines)


def _duration(seconds: float) -> str:
    """Return a short time as text, in a unit in which it has few digits."""
    for size, unit in ((1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return "1 ns"


def _record(proof: Proof, engine: Engine) -> dict[str, Any]:
    from hoopgen.study.named_units import COMPONENTS

    events = [
        {
            "surface": surface_name(event.surface, engine.surfaces),
            "time": str(event.time),
            "before": [str(component) for component in event.before],
            "after": [str(component) for component in event.after],
        }
        for event in proof.events
    ]
    return {
        "outcome": _outcome(proof, engine),
        "bits": proof.bits,
        "question": proof.question,
        "impacts": sum(k < len(engine.surfaces) for k in proof.surfaces),
        "until_s": proof.until,
        "accumulates": proof.accumulates,
        "events": events,
        "components": COMPONENTS,
    }
