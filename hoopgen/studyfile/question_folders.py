"""The folder of a question: worked on as ``<name>.unfinished``, published when it is finished.

Both are folders that hoopgen owns (`hoopgen.core.owned_folders`): other files in them stay as they
are.
"""

from __future__ import annotations

import contextlib
import errno
import json
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from hoopgen.core.files import sync
from hoopgen.core.owned_folders import Store, find_store, open_store
from hoopgen.report.quantities import for_json
from hoopgen.study.jobs.chunk_store import (
    count_chunks,
    differences,
    flat,
    in_short,
    read_record,
    remove_chunks,
    written,
)
from hoopgen.study.questions.specification import CompareQuestion, EstimateQuestion, MapQuestion

from .answers import answer
from .context import Answer, Context, Workplace

_ASKED, _ANSWER = "question.json", "answer.json"
_KEPT = "kept.json"  # how many chunks the answer before has, while the question is asked anew
_CHUNKS = "chunks"
_UNFINISHED = ".unfinished"

_PURPOSE = "the answer to a question"
_Countable = EstimateQuestion | CompareQuestion | MapQuestion
"""Questions that may be asked for other numbers of shots."""

_DAMAGED = "cannot be read; move {} out of the study to have the question answered anew"


def answer_files(folder: Path) -> list[Path]:
    """Return the files of a finished question, sorted by name."""
    store = find_store(folder, _PURPOSE)
    return [] if store is None else [store.path / name for name in store.present()]


def _question_folders(folder: Path) -> Iterator[Store]:
    """Yield the folders of questions, finished or not, that hoopgen owns in that of a study."""
    for path in sorted(folder.iterdir()):
        with contextlib.suppress(ValueError):  # it is somebody else's
            store = find_store(path, _PURPOSE)
            if store is not None:
                yield store


def check_questions(
    folder: Path, identities: Mapping[str, Mapping[str, Any]], questions: Sequence[Context]
) -> None:
    """Compare the questions in the folder with those of the study.

    Parameters
    ----------
    folder
        The folder of a study, with one folder for each question.
    identities
        All that each answer depends on, by the name of the question.
    questions
        The questions of the study file.

    Raises
    ------
    ValueError
        If an answer in the folder is to another question of the same name, or to none of these; the
        message names each difference.
    """
    found = []
    contexts = {one.question.name: one for one in questions}
    for store in _question_folders(folder):
        name, file = store.path.name.removesuffix(_UNFINISHED), store.path / _ASKED
        if not os.path.lexists(file):
            continue  # it has just begun
        if name not in identities:
            found.append(f"it has the question {name}, which the study has not")
            continue
        there, here = _question(file), flat(identities[name])
        changed = differences(there, here)
        if changed and not _may_go_on(contexts[name], there, here):
            found.append(f"question {name}: {in_short(changed)}")
    if found:
        raise ValueError(
            f"{folder} holds another study: {in_short(found)}. Give another folder, or "
            "move the folders of those questions out of it to ask them anew"
        )


def _question(file: Path) -> dict[str, str]:
    """Return the identity of a question that is stored beside its answer."""
    try:
        return flat(read_record(file))
    except ValueError:
        raise ValueError(f"{file} {_DAMAGED.format(file.parent)}") from None


_HOW_MANY = {"shots", "precision", "units"}
"""Keys that may differ, as with a folder of chunks alone; units are those of texts."""


def _may_go_on(context: Context, there: Mapping[str, str], here: Mapping[str, str]) -> bool:
    """Tell whether a question is one that was asked before, but for how many shots."""
    changed = {name for name in {*there, *here} if there.get(name) != here.get(name)}
    return isinstance(context.question, _Countable) and changed <= _HOW_MANY


def answer_question(
    context: Context, identity: Mapping[str, Any], finished: Path, work: Callable[..., Workplace]
) -> Answer:
    """Return the answer that is in the folder, or find it and put it there.

    Parameters
    ----------
    identity
        All that the answer depends on, in types that JSON knows.
    finished
        The folder of the question when it is finished.
    work
        Makes a `Workplace` of its arguments ``store``, ``chunks`` and ``kept``.

    Raises
    ------
    ValueError
        If the folder is not hoopgen's, or a file in it cannot be read; or as the question does.
    OSError
        If a file cannot be written, or one that hoopgen did not make is in its place.
    """
    if os.path.lexists(finished) and not finished.is_dir():
        words = "this is no folder; move it away, or give another folder"
        raise FileExistsError(errno.EEXIST, words, str(finished))
    before = find_store(finished, _PURPOSE)
    unfinished = finished.with_name(f"{finished.name}{_UNFINISHED}")
    if before is not None and _question(finished / _ASKED) == flat(identity):
        if (stopped := find_store(unfinished, _PURPOSE)) is not None:
            stopped.dissolve()
    else:
        store = open_store(unfinished, _PURPOSE)
        chunks = (store if before is None else before).path / _CHUNKS
        # A figure of the attempt before, for instance, which fewer shots may not have.
        store.remove(set(store.present()) - {_ASKED, _KEPT})
        if before is not None and _KEPT not in store.present():
            write_file(store, _KEPT, as_json({"chunks": count_chunks(chunks)}))
        kept = 0 if before is None else int(read_record(unfinished / _KEPT)["chunks"])
        write_file(store, _ASKED, as_json(identity))
        found = answer(context, work(store=store, chunks=chunks, kept=kept))
        store.remove([_KEPT])
        _sync_files(store)
        write_file(store, _ANSWER, as_json(vars(found)))
        _publish(store, finished)
    if not isinstance(context.question, _Countable):
        with contextlib.suppress(ValueError):  # chunks is somebody else's
            remove_chunks(finished / _CHUNKS)
    return _answer(finished / _ANSWER)


def publish_finished(folder: Path) -> None:
    """Give the answers their names that were finished when the process was killed."""
    for store in _question_folders(folder):
        path = store.path
        if path.name.endswith(_UNFINISHED) and (path / _ANSWER).is_file():
            _publish(store, path.with_name(path.name.removesuffix(_UNFINISHED)))


def _publish(store: Store, finished: Path) -> None:
    """Give a finished answer its name; one that is there stays until then.

    The answer itself is moved last: as long as it is in the unfinished folder the next start moves
    what is left.
    """
    there = find_store(finished, _PURPOSE)
    if there is None:
        with contextlib.suppress(FileNotFoundError):
            finished.rmdir()
        store.path.rename(finished)
    else:
        there.claim(*store.files)
        for name in store.present():
            if name != _ANSWER:
                (store.path / name).replace(finished / name)
        there.keep_only(store.files)
        (store.path / _ANSWER).replace(finished / _ANSWER)
        sync({finished})
        store.dissolve()
    sync({finished.parent})


def _answer(file: Path) -> Answer:
    """Return the answer of a question that is finished."""
    try:
        record = read_record(file)
        line, text, numbers = (record[name] for name in ("line", "text", "numbers"))
        if not (isinstance(line, str) and isinstance(text, str) and isinstance(numbers, dict)):
            raise ValueError("expected two texts, and numbers by name")
    except (KeyError, ValueError):
        raise ValueError(f"{file} {_DAMAGED.format(file.parent)}") from None
    return Answer(line, text, numbers)


def _sync_files(store: Store) -> None:
    """Make files last before there is an answer, whatever happens to the power."""
    for name in store.present():
        with (store.path / name).open("rb+") as opened_file:
            os.fsync(opened_file.fileno())
    sync({store.path})


def write_file(store: Store, name: str, content: bytes) -> None:
    """Write a file that hoopgen owns in a folder; an error says what is not lost.

    Parameters
    ----------
    store
        The folder, which notes that the file is hoopgen's.
    name
        The name of the file in it.
    content
        All bytes of the file.

    Raises
    ------
    OSError
        If the file cannot be written; an earlier one of that name then stays whole.
    """
    store.claim(name)
    with written(store.path / name, store.temporary()) as out:
        out.write(content)


def as_json(values: Mapping[str, Any]) -> bytes:
    """Return names and values as JSON for a reader."""
    text = json.dumps(for_json(values), indent=1, allow_nan=False, ensure_ascii=False)
    return f"{text}\n".encode()
