"""`run_study`: a study file in, a folder with its answers out.

A question is worked on in ``<name>.unfinished``, where its finished chunks are kept too. The folder
gets its name when all of it is there, so what bears a name is finished. Of an estimate, a
comparison or a map the chunks stay: asked for more shots, it goes on from them, and for fewer, it
takes the first of them; the answer that is there stays until the new one is finished. Nothing in a
folder but ``versions.json`` depends on the machine, the threads, or when and how often the work was
interrupted. The folder and those of its questions are hoopgen's (`hoopgen.core.owned_folders`):
other files in them stay as they are.
"""

from __future__ import annotations

import os
import platform
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from importlib import metadata
from pathlib import Path
from typing import Any

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.extras import version
from hoopgen.core.files import PAGES, check_not_read, check_output, write
from hoopgen.core.owned_folders import locked_store
from hoopgen.core.regular_files import read_regular
from hoopgen.scene.limits import Limits, check_limits, use_limits
from hoopgen.study.jobs.executors import check_workers, versions
from hoopgen.study.questions.specification import CompareQuestion
from hoopgen.text.numbers import format_count

from . import lines
from .answers import check
from .context import Answer, Context, Workplace
from .page import check_page, page
from .question_folders import (
    answer_question,
    as_json,
    check_questions,
    publish_finished,
    write_file,
)
from .reading import complain, data_files, parse, read_files, read_study, scene_file
from .report import Results
from .report import report as report_of
from .scene import FILE
from .schema import StudyFile

Progress = Callable[[str, int, int | None], None]

_PURPOSE = "a study"
_STUDY, _SCENE = ("study.toml", "scene.toml")
_VERSIONS, _REPORT = ("versions.json", "report.md")
_MADE_WITH = ("numpy", "scipy", "pyarrow", "xarray", "matplotlib", "pydantic")


def check_study(path: str | os.PathLike[str]) -> list[Context]:
    """Read a study file and look for what is wrong, without any work.

    Parameters
    ----------
    path
        The file.

    Returns
    -------
    list of Context
        Its questions.

    Raises
    ------
    StudyError
        If it is not as `hoopgen.studyfile.schema` describes: with all that is wrong, the lines
        and the keys.
    OSError
        If it cannot be read.
    """
    return _read(Path(path))[1]


@check_arguments
def run_study(
    path: str | os.PathLike[str],
    out: str | os.PathLike[str] | None = None,
    *,
    report: str | os.PathLike[str] | None = None,
    threads: int | None = None,
    scheduler: str | None = None,
    progress: Progress | None = None,
    limits: Limits | Mapping[str, int] | None = None,
) -> dict[str, Answer]:
    """Answer all questions of a study file, and keep the answers in a folder.

    After an interruption the same call goes on where it was. Questions may be added to the file;
    those that are in the folder must not change, but for estimates, comparisons and maps, which may
    be asked for more shots, fewer, or another precision: what is kept is not computed again.

    Parameters
    ----------
    path
        The study file; see ``docs/study.md``.
    out
        The folder: made if it is not there, by default beside the file, ``<its name>-results``. It
        gets a copy of the file and of its scene's, the versions of what computed, a report, and a
        folder for each question with its answer, tables and figures.
    report
        Where to write the report as a page too: one file, .html, with all pictures in it.
    threads, scheduler
        As for `hoopgen.estimate`.
    progress
        Called with the name of a question, what of it is done, and its total (None: not known).
    limits
        How large the file and its scene may be, as for `hoopgen.load_scene`.

    Returns
    -------
    dict
        Answers by the name of their question.

    Raises
    ------
    StudyError
        If the file is not as described: with all that is wrong, the lines and the keys.
    ValueError
        If the folder holds another study, and what differs; or is not hoopgen's. If `out`,
        `report`, `threads` or the form of `scheduler` is not as described.
    ImportError
        If Jinja2 is missing, which makes the page: what brings it.
    ExceptionGroup
        If questions cannot be answered: their errors, each with a note that names it. The others
        are in the folder.
    OSError
        If files cannot be read or written.
    """
    file = Path(path)
    if out is not None and not os.fspath(out):
        raise ValueError("out: expected the name of a folder, got ''")
    check_workers(scheduler, threads)
    target = None if report is None else check_output(report, PAGES)
    if target is not None:
        check_page()
    allowed = check_limits(limits)
    with use_limits(allowed):
        content, questions, document = _read(file)
    if target is not None:
        read = read_files(file, questions[0].given, document)
        check_not_read("report", target, "the study", read)
    folder = Path(out) if out is not None else file.with_name(f"{file.stem}-results")
    identities = {
        context.question.name: {**versions(), **context.identity()} for context in questions
    }
    with locked_store(folder, _PURPOSE) as store:
        publish_finished(folder)
        check_questions(folder, identities, questions)
        write_file(store, _VERSIONS, as_json(_versions()))
        write_file(store, _STUDY, content)
        if (scene := scene_file(file, document)) is not None:
            write_file(store, _SCENE, read_regular(scene, allowed.file_size))
        answers: dict[str, Answer] = {}
        errors: dict[str, Exception] = {}
        for context in questions:
            name = context.question.name
            noted = _noted(progress, name)
            work = partial(Workplace, threads=threads, scheduler=scheduler, progress=noted)
            try:
                answers[name] = answer_question(context, identities[name], folder / name, work)
            except Exception as error:  # whatever it is, the other questions go on
                error.add_note(f"question {name}")
                errors[name] = error
        results = Results(questions, document, answers, errors, folder)
        write_file(store, _REPORT, report_of(results).encode())
        if target is not None:
            write(target, page(content, results, _versions()))
    if errors:
        raise ExceptionGroup(
            f"{len(errors)} of {format_count(len(questions), 'question')} could not be answered; "
            f"the others are in {folder}",
            list(errors.values()),
        )
    return answers


# -------------------------------------------------------------------------------------- the file


def _read(file: Path) -> tuple[bytes, list[Context], Mapping[str, Any]]:
    """Return the content of the file, its questions, checked, and all of it as it is written."""
    content = read_study(file)
    study, document, text, scene = parse(content, file)
    found = [
        (path, f"there is no file {file.parent / name}")
        for path, name in data_files(study)
        if not (file.parent / name).is_file()
    ]
    found += [
        (path, "a scene is named above the questions, and is that of all")
        for path, given in _scenes(study)
        if FILE in given
    ]
    if found:
        raise complain(file, text, found)
    questions = [
        Context(study.study, study, question, file.parent, scene) for question in study.question
    ]
    for place, context in enumerate(questions):
        try:
            check(context)
        except (TypeError, ValueError, OSError) as error:
            found.append((("question", place), str(error)))
    if found:
        raise complain(file, text, found)
    return content, questions, document


def _scenes(study: StudyFile) -> Iterator[tuple[lines.Path, Mapping[str, Any]]]:
    """Yield the settings of questions that concern the scene, with their locations."""
    for place, question in enumerate(study.question):
        yield ("question", place, "scene"), question.scene
        if isinstance(question, CompareQuestion):
            yield ("question", place, "versus", "scene"), question.versus.scene


# ------------------------------------------------------------------------------------- what is said


def _noted(progress: Progress | None, name: str) -> Callable[[int, int | None], None]:
    return lambda done, total: None if progress is None else progress(name, done, total)


def _versions() -> dict[str, str]:
    """Return the versions of hoopgen and of its libraries, and the platform."""
    made_with = {"hoopgen": version()}
    made_with |= {name: metadata.version(name) for name in _MADE_WITH}
    system = {"python": platform.python_version(), "platform": platform.platform()}
    return made_with | system
