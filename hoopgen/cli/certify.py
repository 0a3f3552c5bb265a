"""``hoopgen certify``: one release, and what it does, proved."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from itertools import takewhile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hoopgen.cli.command import command
from hoopgen.cli.options import (
    UNITS_IN_WORDS,
    argument_options,
    examples,
    json_option,
    max_contacts_option,
    preset_options,
)
from hoopgen.cli.own import (
    NEEDED,
    engine_of,
    max_contacts_of,
    own_options,
    parameters_of,
    released,
    shot_needs,
    state_of,
)
from hoopgen.cli.types import FILE, whole
from hoopgen.layout import table
from hoopgen.phrases import counted

if TYPE_CHECKING:
    from hoopgen.engines import Engine
    from hoopgen.judge import Proof

__all__ = ["certify"]

CLOSE = 1e-3
"""s before the last event of a shot: what happens on one body since then is one line of the log."""

FEW = 3
"""Events on one body, one soon after another, that have a line each."""


def _needs(typed: Mapping[str, Any]) -> list[str]:
    first, *rest = [*shot_needs(typed), ""]
    whole = len(rest) == len(NEEDED)
    return [name for name in (f"FILE, or {first}" if whole else first, *rest) if name]


@command(
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
@max_contacts_option
@click.option(
    "--max-bits",
    type=whole(128),
    default=4096,
    show_default=True,
    help="Precision at which to give up.",
)
@json_option
@click.pass_context
def certify(
    ctx: click.Context,
    /,
    file: Path | None,
    preset: str,
    settings: Mapping[str, float],
    max_contacts: int,
    max_bits: int,
    as_json: bool,
    position: Sequence[float] | None,
    velocity: Sequence[float] | None,
    spin: Sequence[float] | None,
    **release: float | None,
) -> None:
    """Prove what one shot does: its contacts, their order, its outcome.

    The shot is that of FILE, as `hoopgen shot --json` writes it, or that of the options. It is
    simulated in ball arithmetic with more and more bits, until every decision is proved. Exit
    status 1 if the outcome is not proved: two contacts at once, an exact touch, an exact edge; or
    a ball whose bounces accumulate, so that it rolls, which the judge does not follow. It then says
    how far the proof goes.
    """
    from hoopgen.judge import certify as prove
    from hoopgen.study.named import in_units
    from hoopgen.told import say_of

    engine = engine_of()
    if file is not None:
        state, written = _read(file, engine)
        parameters: Mapping[str, float] = {**written, **settings}
    elif engine.has_hoop:
        state, parameters = state_of(release), parameters_of(engine, preset, settings)
    else:
        there = {"position": position, "velocity": velocity, "spin": spin}
        state = released(tuple(release), there)
        parameters = parameters_of(engine, preset, settings)
    most = max_contacts_of(max_contacts)
    proof = prove(
        state, parameters, scene=engine, max_contacts=most, max_bits=max_bits, record=True
    )[0]
    scene_told = say_of(engine, parameters)
    if as_json:
        click.echo(json.dumps({**in_units(_record(proof, engine)), "scene": scene_told}, indent=2))
    else:
        click.echo(f"{_summary(proof, engine)}\nscene      {scene_told}")
    if not proof.decided:
        ctx.exit(1)


def _read(file: Path, scene: Engine) -> tuple[list[float], dict[str, float]]:
    from hoopgen.study.named import parameters_named

    try:
        record = json.loads(file.read_text(encoding="utf-8"))
        said = parameters_named(dict(record["parameters"]), scene)
        return list(record["release"]), {name: float(value) for name, value in said.items()}
    except (ValueError, KeyError, TypeError, RecursionError):
        raise click.ClickException(
            f"{file}: expected what `hoopgen shot --json` writes, with release and parameters"
        ) from None


def _outcome(proof: Proof, engine: Engine) -> str:
    return engine.outcomes(proof.outcome).name.lower() if proof.decided else "undecided"


def _together(proof: Proof) -> int:
    """Return how many events at the end are on one body and soon after one another, if many are."""
    events = reversed(list(zip(proof.surfaces, proof.times, strict=True)))
    run = takewhile(lambda e: e[0] == proof.surfaces[-1] and e[1] >= proof.until - CLOSE, events)
    found = sum(1 for _ in run)
    return found if found > FEW else 0


def _summary(proof: Proof, engine: Engine) -> str:
    from hoopgen.cli.report import surface_name

    alone = len(proof.events) - _together(proof)
    rows = [
        [str(number), surface_name(event.surface, engine.surfaces), str(event.time)]
        for number, event in enumerate(proof.events[:alone], 1)
    ]
    if alone < len(proof.events):
        first, last = proof.events[alone], len(proof.events)
        within = _duration(proof.times[-1] - proof.times[alone])
        name = surface_name(first.surface, engine.surfaces)
        rows.append([f"{alone + 1:,}-{last:,}", name, f"{first.time}, all within {within}"])
    lines = (
        [table(["#", "surface", "time (s), as far as proved"], rows, right=[0]), ""] if rows else []
    )
    impacts = counted(sum(k < len(engine.surfaces) for k in proof.surfaces), "impact")
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
    """Say a short time in a unit in which it has few digits."""
    for size, unit in ((1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return "1 ns"


def _record(proof: Proof, engine: Engine) -> dict[str, Any]:
    from hoopgen.cli.report import surface_name
    from hoopgen.study.named import COMPONENTS

    events: list[dict[str, Any]] = [
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
