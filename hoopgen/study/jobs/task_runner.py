"""Executors for the questions of a search, one question after the other.

Each request depends on the answers before, so it is the same whenever it is asked again: the chunks
of all questions are numbered through, kept, and after an interruption read instead of computed.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass, field
from os import PathLike
from typing import Any, TypeAlias

import pyarrow as pa

from .chunk_store import check_folder
from .chunks import Progress, begin_work, run
from .executors import Task

TaskRunner: TypeAlias = Callable[[Sequence[Task]], list[pa.Table]]
"""Computes tasks, and returns what they give, in their order."""


def run_serially(tasks: Sequence[Task]) -> list[pa.Table]:
    """Compute tasks here, one by one, and keep nothing."""
    return [task() for task in tasks]


@contextmanager
def task_runner(
    identity: Mapping[str, Any],
    folder: str | PathLike[str] | None = None,
    *,
    scheduler: str | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Iterator[TaskRunner]:
    """Yield a runner of tasks, as long as it is needed.

    Parameters
    ----------
    identity
        All that the questions and their order depend on, in types that JSON knows.
    folder, scheduler, threads, progress
        As for `chunks.run`, which says what may be raised too.
    """
    if folder is not None:
        check_folder(folder)  # few shots are computed without it
    begin_work()
    asked = _Asked(identity)
    chunks = run(asked, folder, scheduler=scheduler, threads=threads, progress=progress)
    with closing(chunks):

        def together(tasks: Sequence[Task]) -> list[pa.Table]:
            asked.waiting.extend(tasks)
            return [next(chunks) for _ in tasks]

        yield together
        if asked.begun:  # else there is not even a folder
            asked.over = True
            deque(chunks, maxlen=0)  # which says how many there were


@dataclass
class _Asked:
    """A stream of `chunks.run`: what is waiting, until it is over."""

    of: Mapping[str, Any]
    waiting: deque[Task] = field(default_factory=deque)
    begun: bool = False
    over: bool = False

    chunks: None = None
    """The number of questions is not known in advance."""

    def tasks(self) -> Iterator[Task | None]:
        """Yield the waiting tasks; None while there is none."""
        self.begun = True
        while not self.over:
            yield self.waiting.popleft() if self.waiting else None

    def identity(self) -> Mapping[str, Any]:
        """Return the identity of the chunks: everything that they depend on."""
        return self.of
