"""`run_study`: a study file in, a folder with its answers out.

A question is worked on in ``<name>.unfinished``, where its finished chunks are kept too. The folder
gets its name when all of it is there, so what bears a name is finished. Of an estimate, a
comparison or a map the chunks stay: asked for more shots, it goes on from them, and for fewer, it
takes the first of them. Nothing in a folder but ``versions.json`` hangs on the machine, the
threads, or when and how often the work was interrupted.
"""

from __future__ import annotations

import errno
import json
import os
import platform
import shutil
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from importlib import metadata
from pathlib import Path
from typing import Any

from hoopgen.files import read_regular
from hoopgen.installed import version
from hoopgen.outputs import PAGES, check_not_read, check_output, sync, write
from hoopgen.phrases import counted
from hoopgen.scene.limits import Limits, check_limits, raised
from hoopgen.study.chunks import check_workers, versions
from hoopgen.study.folders import (
    count_chunks,
    differences,
    flat,
    in_short,
    opened,
    read_record,
    written,
)
from hoopgen.words import for_json

from . import lines
from .answers import answer, check
from .asked import CHUNKS, Answer, Asked, Work
from .inputs import data_files, read_files, scene_file
from .page import check_page, page
from .reading import complain, parse, read_study
from .report import report as in_markdown
from .scene import FILE
from .schema import Compare, Estimate, Map, StudyFile

__all__ = ["check_study", "run_study"]

Progress = Callable[[str, int, int | None], None]

_STUDY, _SCENE = ("study.toml", "scene.toml")
_VERSIONS, _REPORT = ("versions.json", "report.md")
_ASKED, _ANSWER = "question.json", "answer.json"
_KEPT = "kept.json"  # of a question that was finished, while it is asked anew
_UNFINISHED = ".unfinished"
_GONE_ON_WITH = {_ASKED, _KEPT}

_Countable = Estimate | Compare | Map
"""Questions that may be asked for other numbers of shots."""

_JUST_BEGUN = {"lock", "identity.json", "identity.json.tmp", f"{_VERSIONS}.tmp"}
"""All that a study may leave that is killed before its first file is there."""

_MADE_WITH = ("numpy", "scipy", "pyarrow", "xarray", "matplotlib", "pydantic")


def check_study(
    path: str | os.PathLike[str], *, limits: Limits | Mapping[str, int] | None = None
) -> list[Asked]:
    """Read a study file and look for what is wrong, without any work.

    Parameters
    ----------
    path
        The file.
    limits
        How large the file and its scene may be, as for `hoopgen.load_scene`.

    Returns
    -------
    list of Asked
        Its questions.

    Raises
    ------
    StudyError
        If it is not as `hoopgen.studyfile.schema` describes: with all that is wrong, the lines
        and the keys.
    OSError
        If it cannot be read.
    """
    with raised(check_limits(limits)):
        return _read(Path(path))[1]


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
        If the folder holds another study, and what differs; or something else. If `out`,
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
    with raised(allowed):
        content, questions, document = _read(file)
    if target is not None:
        read = read_files(file, questions[0].given, document)
        check_not_read("report", target, "the study", read)
    folder = Path(out) if out is not None else file.with_name(f"{file.stem}-results")
    identities = {asked.question.name: _identity(asked) for asked in questions}
    _refuse_foreign(folder)
    with opened(folder, {"study": identities}) as kept:
        try:
            _reopen(folder, _asked_anew(folder, identities, questions))
            _write(folder / _VERSIONS, _json(_versions()))
            _write(folder / _STUDY, content)
            if (scene := scene_file(file, document)) is not None:
                _write(folder / _SCENE, read_regular(scene, allowed.file_size))
            answers: dict[str, Answer] = {}
            errors: dict[str, Exception] = {}
            for asked in questions:
                name = asked.question.name
                work = Work(
                    folder / f"{name}{_UNFINISHED}", threads, scheduler, _noted(progress, name)
                )
                try:
                    answers[name] = _answered(asked, identities[name], folder / name, work)
                except Exception as error:  # whatever it is, the other questions go on
                    error.add_note(f"question {name}")
                    errors[name] = error
            found = questions, document, answers, errors, folder
            _write(folder / _REPORT, in_markdown(*found).encode())
            if target is not None:
                write(target, page(content, *found, _versions()))
        finally:
            kept.remove()
    if errors:
        raise ExceptionGroup(
            f"{len(errors)} of {counted(len(questions), 'question')} could not be answered; "
            f"the others are in {folder}",
            list(errors.values()),
        )
    return answers


# -------------------------------------------------------------------------------------- the file


def _read(file: Path) -> tuple[bytes, list[Asked], Mapping[str, Any]]:
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
        Asked(study.study, study, question, file.parent, scene) for question in study.question
    ]
    for place, asked in enumerate(questions):
        try:
            check(asked)
        except (TypeError, ValueError, OSError) as error:
            found.append((("question", place), str(error)))
    if found:
        raise complain(file, text, found)
    return content, questions, document


def _scenes(study: StudyFile) -> Iterator[tuple[lines.Path, Mapping[str, Any]]]:
    """Yield what questions say of the scene, and where."""
    for place, question in enumerate(study.question):
        yield ("question", place, "scene"), question.scene
        if isinstance(question, Compare):
            yield ("question", place, "versus", "scene"), question.versus.scene


def _identity(asked: Asked) -> dict[str, Any]:
    return {**versions(), **asked.identity()}


# ------------------------------------------------------------------------------------ the folder


def _refuse_foreign(folder: Path) -> None:
    """Refuse a folder with files that are not of a study."""
    there = {entry.name for entry in folder.iterdir()} if folder.is_dir() else set()
    if _VERSIONS not in there and there - _JUST_BEGUN:
        raise ValueError(f"{folder} holds something else than a study; give another folder")


def _asked_anew(
    folder: Path, identities: Mapping[str, Mapping[str, Any]], questions: Sequence[Asked]
) -> list[str]:
    """Return the questions that are asked for more than is in the folder, or for less.

    Raises
    ------
    ValueError
        If questions in it are others, or are not among those asked.
    """
    found, anew = [], []
    asked = {one.question.name: one for one in questions}
    for file in sorted(folder.glob(f"*/{_ASKED}")):
        name = file.parent.name.removesuffix(_UNFINISHED)
        if name not in identities:
            found.append(f"it has the question {name}, which the study has not")
            continue
        try:
            there = flat(read_record(file))
        except ValueError:
            raise ValueError(f"{file} cannot be read; delete {file.parent}") from None
        here = flat(identities[name])
        if changed := differences(there, here):
            if _may_go_on(asked[name], there, here):
                anew.append(name)
            else:
                found.append(f"question {name}: {in_short(changed)}")
    if found:
        raise ValueError(
            f"{folder} holds another study: {in_short(found)}. Give another folder, or "
            "delete the folders of those questions in it to ask them anew"
        )
    return anew


def _reopen(folder: Path, names: Sequence[str]) -> None:
    """Make finished questions unfinished ones, which go on from their chunks and lose none."""
    for name in names:
        finished, unfinished = folder / name, folder / f"{name}{_UNFINISHED}"
        if finished.is_dir():
            finished.rename(unfinished)
            _write(unfinished / _KEPT, _json({"chunks": count_chunks(unfinished / CHUNKS)}))


_HOW_MANY = {"shots", "precision"}
"""What of these questions may be another, as with a folder of theirs alone."""


def _may_go_on(asked: Asked, there: Mapping[str, str], here: Mapping[str, str]) -> bool:
    """Tell whether a question is one that was asked before, but for how many shots."""
    changed = {name for name in {*there, *here} if there.get(name) != here.get(name)}
    return isinstance(asked.question, _Countable) and changed <= _HOW_MANY


def _noted(progress: Progress | None, name: str) -> Callable[[int, int | None], None]:
    return lambda done, total: None if progress is None else progress(name, done, total)


def _answered(asked: Asked, identity: Mapping[str, Any], finished: Path, work: Work) -> Answer:
    """Return the answer that is in the folder, or find it and put it there."""
    if not finished.is_dir():
        if os.path.lexists(finished):
            raise FileExistsError(errno.EEXIST, "this is no folder; remove it", str(finished))
        work.folder.mkdir(exist_ok=True)
        reopened = work.folder / _KEPT
        kept = int(read_record(reopened)["chunks"]) if reopened.exists() else 0
        for stale in _stale(asked, work.folder):
            stale.unlink()
        _write(work.folder / _ASKED, _json(identity))
        found = answer(asked, replace(work, kept=kept))
        reopened.unlink(missing_ok=True)
        _write(work.folder / _ANSWER, _json(vars(found)))
        _settle(work.folder)
        work.folder.rename(finished)
        sync({finished.parent})
    if not isinstance(asked.question, _Countable):
        shutil.rmtree(finished / CHUNKS, ignore_errors=True)
    return _answer(finished / _ANSWER)


def _stale(asked: Asked, folder: Path) -> list[Path]:
    """Return files that are not gone on with: figures too, which fewer shots may not have."""
    if not isinstance(asked.question, _Countable):
        return list(folder.glob("*.tmp"))
    return [file for file in folder.iterdir() if file.is_file() and file.name not in _GONE_ON_WITH]


def _answer(file: Path) -> Answer:
    """Return the answer of a question that is finished."""
    try:
        record = read_record(file)
        line, text, numbers = (record[name] for name in ("line", "text", "numbers"))
        if not (isinstance(line, str) and isinstance(text, str) and isinstance(numbers, dict)):
            raise ValueError("expected two texts, and numbers by name")
    except (KeyError, ValueError):
        raise ValueError(f"{file} cannot be read; delete {file.parent}") from None
    return Answer(line, text, numbers)


def _settle(folder: Path) -> None:
    """Make files last before their folder gets its name, whatever happens to the power."""
    for file in folder.iterdir():
        if file.is_file():
            with file.open("rb+") as opened_file:
                os.fsync(opened_file.fileno())
    sync({folder})


def _write(file: Path, content: bytes) -> None:
    with written(file) as out:
        out.write(content)


def _json(values: Mapping[str, Any]) -> bytes:
    text = json.dumps(for_json(values), indent=1, allow_nan=False, ensure_ascii=False)
    return f"{text}\n".encode()


def _versions() -> dict[str, str]:
    """Return what computes."""
    made_with = {"hoopgen": version()}
    made_with |= {name: metadata.version(name) for name in _MADE_WITH}
    system = {"python": platform.python_version(), "platform": platform.platform()}
    return made_with | system
