"""``hoopgen paper``: the article's seven shots, beside what its figures show."""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import TYPE_CHECKING

import click

from hoopgen.brief import brief
from hoopgen.cli.command import command
from hoopgen.cli.options import backend_option, examples
from hoopgen.cli.own import no_scene_option
from hoopgen.cli.progress import shown
from hoopgen.cli.types import FOLDER
from hoopgen.inputs import Backend
from hoopgen.layout import NO_BREAK, table
from hoopgen.outputs import write
from hoopgen.printable import printable

if TYPE_CHECKING:
    from hoopgen.paper import Result

__all__ = ["TABLE", "paper"]

TABLE = "table.txt"
"""Name of the file that holds the table and its notes."""


@command(
    epilog=examples(
        "hoopgen paper",
        "hoopgen paper --events",
        "hoopgen paper --out figures --format svg",
    )
)
@click.option("--out", type=FOLDER, help="Write the table and draw Figs. 5-7 into this folder.")
@click.option(
    "--format",
    "formats",
    default="png,svg",
    show_default=True,
    help="Of the pictures: png, svg, pdf; several with commas.",
)
@click.option("--events", is_flag=True, help="List every event of every shot.")
@backend_option
@no_scene_option
@click.pass_context
def paper(
    ctx: click.Context,
    out: Path | None,
    formats: str,
    events: bool,
    backend: Backend,
) -> None:
    """Simulate the seven shots of the article and compare them with its figures.

    Releases are those of Table 3, in feet; the hoop is the preset "paper". Exit status 1 when a
    shot does not do what the article's figure shows.
    """
    from hoopgen.paper import run
    from hoopgen.told import say_scene

    suffixes = [] if out is None else _suffixes(formats)
    if out is not None:
        out.mkdir(parents=True, exist_ok=True)
    results = run(backend=backend)
    report = "\n".join(
        [
            _overview(results),
            f"\nScene: {say_scene(results[0].parameters)}; releases: Table 3",
            _notes(results),
            *([_logs(results)] if events else []),
        ]
    )
    click.echo(report)
    if out is not None:
        write(out / TABLE, f"{report}\n")
        count = _draw(results, out, suffixes)
        click.echo(printable(f"\nThe table, {TABLE}, and {count} pictures are in {out}"))
    wrong = [result.case.name for result in results if not result.agrees]
    if wrong:
        click.echo(f"\nNot as in the article: {'; '.join(wrong)}", err=True)
        ctx.exit(1)


def _suffixes(text: str) -> list[str]:
    from hoopgen.plots import FORMATS

    suffixes = [part.strip().lower() for part in text.split(",")]
    for suffix in suffixes:
        if suffix not in FORMATS:
            raise click.BadParameter(
                f"{brief(suffix)} is none of {', '.join(FORMATS)}", param_hint="'--format'"
            )
    return suffixes


def _overview(results: tuple[Result, ...]) -> str:
    from hoopgen.cli.report import story

    headers = ["figure", "events (s)", "outcome", "uncertain", "the article shows", "agrees"]
    rows = [
        [
            result.case.name.replace(" ", NO_BREAK),
            story(result.events),
            result.outcome.name.lower(),
            "yes" if result.uncertain else "no",
            result.case.shown.text,
            "yes" if result.agrees else f"NO: {', '.join(result.differences)}",
        ]
        for result in results
    ]
    return table(headers, rows, wrap={1: 31, 4: 22, 5: 12})


def _notes(results: tuple[Result, ...]) -> str:
    """List what is wrong or unclear in print, each once."""
    notes: dict[str, str] = {}
    for result in results:
        if result.case.note:
            notes.setdefault(result.case.note, result.case.figure)
    lines = [
        textwrap.fill(f"{figure}: {note}", 98, initial_indent="  ", subsequent_indent=" " * 6)
        for note, figure in notes.items()
    ]
    return "\n".join(["", "In print:", *lines])


def _logs(results: tuple[Result, ...]) -> str:
    from hoopgen.cli.report import event_table

    logs = (
        f"\nFig. {result.case.name}: {result.case.title}\n"
        + event_table(result.case.state, result.events)
        for result in results
    )
    return "\n".join(logs)


def _draw(results: tuple[Result, ...], folder: Path, suffixes: list[str]) -> int:
    """Write the pictures and return how many there are."""
    from hoopgen import plots

    total = len(results) * len(suffixes)
    with shown() as progress:
        for done, result in enumerate(results):
            progress(done * len(suffixes), total)
            figure = plots.plot_trajectory(
                result.trajectory,
                result.parameters,
                outcome=result.outcome,
                title=f"Fig. {result.case.figure}. {result.case.title}",
            )
            for suffix in suffixes:
                plots.save(figure, folder / f"figure-{result.case.slug}.{suffix}")
        progress(total, total)
    return total
