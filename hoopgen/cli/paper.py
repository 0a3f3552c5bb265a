"""``hoopgen paper``: the article's seven shots, beside what its figures show."""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import TYPE_CHECKING

import click

import hoopgen
from hoopgen.core.backend_names import BackendName
from hoopgen.core.files import write
from hoopgen.report.provenance import describe_hoop
from hoopgen.study.questions.settings import Engines
from hoopgen.text.escape import printable
from hoopgen.text.shorten import brief
from hoopgen.text.tables import NO_BREAK, table

from .command import command
from .messages import examples, shown
from .path_types import FOLDER
from .question_options import setting_options
from .scene_option import no_scene_option
from .shot_report import event_table, story

if TYPE_CHECKING:
    from hoopgen.simulation.article import ArticleResult

TABLE = "table.txt"
"""Name of the file that holds the table and its notes."""


@command(
    short_help="Simulate the article's shots and compare with its numbers.",
    epilog=examples(
        "hoopgen paper",
        "hoopgen paper --events",
        "hoopgen paper --out figures --format svg",
    ),
)
@click.option("--out", type=FOLDER, help="Write the table and draw Figs. 5-7 into this folder.")
@click.option(
    "--format",
    "formats",
    default="png,svg",
    show_default=True,
    help="Formats of the pictures: png, svg, pdf; separate several by commas.",
)
@click.option("--events", is_flag=True, help="List every event of every shot.")
@setting_options(Engines)
@no_scene_option
@click.pass_context
def paper(
    ctx: click.Context, out: Path | None, formats: str, events: bool, backend: BackendName
) -> None:
    """Simulate the seven shots of the article and compare them with its figures.

    Releases are those of Table 3, in feet; the hoop is the preset "paper". Exit status 1 when a
    shot does not do what the article's figure shows.
    """
    from hoopgen.simulation.article import run

    suffixes = [] if out is None else _suffixes(formats)
    if out is not None:
        out.mkdir(parents=True, exist_ok=True)
    results = run(backend=backend)
    report = "\n".join(
        [
            _overview(results),
            f"\nScene: {describe_hoop(results[0].parameters)}; releases: Table 3",
            _notes(results),
            *(_log(result) for result in results if events),
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


def _overview(results: tuple[ArticleResult, ...]) -> str:
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


def _notes(results: tuple[ArticleResult, ...]) -> str:
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


def _log(result: ArticleResult) -> str:
    events = event_table(result.case.state, result.events)
    return f"\nFig. {result.case.name}: {result.case.title}\n{events}"


def _draw(results: tuple[ArticleResult, ...], folder: Path, suffixes: list[str]) -> int:
    """Write the pictures and return how many there are."""
    plots = hoopgen.plots

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
