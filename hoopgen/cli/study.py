"""``hoopgen study``: all of a study, from one file into one folder."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import click

from hoopgen.study.questions.settings import Workers
from hoopgen.text.escape import printable
from hoopgen.text.numbers import format_count

from .command import command
from .messages import OwnError, error_text, examples, is_expected, shown
from .options import units_option
from .path_types import FILE, FOLDER, PAGE
from .question_options import setting_options
from .scene_option import limit_option


def _print_reference(ctx: click.Context, _: click.Parameter, wanted: bool) -> None:
    if wanted:
        from hoopgen.studyfile.reference import reference

        click.echo(reference(), nl=False)
        ctx.exit()


@command(
    short_help="Answer the questions of a study file.",
    epilog=examples(
        "hoopgen study free-throw.toml",
        "hoopgen study free-throw.toml --out results --report results.html",
        "hoopgen study free-throw.toml --check",
        "hoopgen study --reference",
    ),
)
@click.argument("file", type=FILE)
@click.option(
    "--out",
    type=FOLDER,
    help="Folder of the results; by default beside FILE, <its name>-results.",
)
@click.option(
    "--report",
    type=PAGE,
    help="Also write the report as a page, .html: one file with all pictures, to print or to send.",
)
@limit_option
@setting_options(Workers)
@units_option
@click.option("--check", is_flag=True, help="List the errors in FILE, and compute nothing.")
@click.option(
    "--reference",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_print_reference,
    help="Print the reference of study files, and exit.",
)
def study(
    file: Path,
    out: Path | None,
    report: Path | None,
    threads: int | None,
    scheduler: str | None,
    check: bool,
) -> None:
    """Answer the questions of a study file.

    FILE is TOML: a player's scatter, and what is asked about it. The answers lie in a folder, with
    a report, the file itself and the versions of all that computed, so that they can be published.
    An interrupted run goes on where it was.
    """
    from hoopgen.studyfile import check_study, run_study
    from hoopgen.studyfile.reading import StudyError

    try:
        if check:
            questions = check_study(file)
            names = ", ".join(asked.question.name for asked in questions)
            click.echo(printable(f"{file}: {format_count(len(questions), 'question')}, {names}"))
            return
        with _shown() as progress:
            work: Any = {"threads": threads, "scheduler": scheduler, "progress": progress}
            answers = run_study(file, out, report=report, **work)
    except StudyError as error:
        raise _failed(error.complaints) from None
    except ExceptionGroup as group:
        texts = [f"{': '.join(e.__notes__)}: {error_text(e)}" for e in group.exceptions]
        kind = click.ClickException if all(map(is_expected, group.exceptions)) else OwnError
        raise _failed([*texts, group.message], kind) from group
    width = max(map(len, answers))
    for name, answer in answers.items():
        click.echo(f"{name:{width}}  {answer.line}")
    folder = out if out is not None else file.with_name(f"{file.stem}-results")
    for written in filter(None, (folder / "report.md", report)):
        click.echo(printable(f"{'report':{width}}  {written}"))


def _failed(
    complaints: Any, kind: type[click.ClickException] = click.ClickException
) -> click.ClickException:
    """Say all complaints but the last, a line each; that one is the error."""
    *others, last = (" ".join(complaint.split()) for complaint in complaints)
    for complaint in others:
        click.echo(f"hoopgen: error: {printable(complaint)}", err=True)
    return kind(last)


@contextmanager
def _shown() -> Iterator[Callable[[str, int, int | None], None]]:
    """Show how far each question is, one after the other."""
    with ExitStack() as stack:
        bars: dict[str, Callable[[int, int | None], None]] = {}

        def show(name: str, done: int, total: int | None) -> None:
            if name not in bars:
                stack.close()
                if sys.stderr.isatty():
                    click.echo(name, err=True)
                bars[name] = stack.enter_context(shown())
            bars[name](done, total)

        yield show
