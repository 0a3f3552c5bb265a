"""The functions that ask each kind of question, and tell its answer."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from hoopgen.study.jobs.chunks import preparing

from . import monte_carlo_questions as sampled
from . import sweeps
from .context import Answer, Context, Workplace

_KINDS: Mapping[str, tuple[Callable[..., Any], Callable[..., Answer]]] = {
    "estimate": (sampled.ask_estimate, sampled.tell_estimate),
    "compare": (sampled.ask_compare, sampled.tell_compare),
    "solve": (sampled.ask_solve, sampled.tell_solve),
    "map": (sweeps.ask_map, sweeps.tell_map),
    "optimum": (sweeps.ask_optimum, sweeps.tell_optimum),
    "bank": (sweeps.ask_bank, sweeps.tell_bank),
    "aim": (sweeps.ask_aim, sweeps.tell_aim),
    "batch": (sampled.ask_batch, sampled.tell_batch),
}
"""By kind: a function of the context, the question and keywords that say who works and where its
chunks lie, which returns a result; and one of that and the place of work, which returns its
answer."""


def check(context: Context) -> None:
    """Check a question before any work."""
    ask, _ = _KINDS[context.question.kind]
    with preparing():
        ask(context, context.question)


def answer(context: Context, work: Workplace) -> Answer:
    """Answer a question, its tables and figures written into the folder of the work.

    Parameters
    ----------
    context
        The question, and the study around it.
    work
        The folder for the answer's files and chunks, and the threads or the cluster that compute.

    Returns
    -------
    Answer
        A line, a text in Markdown and the numbers.

    Raises
    ------
    ValueError
        If the question cannot be asked; the message names the key.
    """
    ask, tell = _KINDS[context.question.kind]
    place = (
        {"out": work.file("results.parquet")}
        if ask is sampled.ask_batch
        else {"folder": work.chunks}
    )
    found = ask(context, context.question, **place, **work.workers)
    return tell(context, context.question, found, work)
