"""Which function checks and answers each kind of question."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from .asked import Answer, Asked, Work
from .schema import Aim, Bank, Batch, Compare, Estimate, Map, Optimum, Question, Solve
from .thrown import (
    answer_batch,
    answer_compare,
    answer_estimate,
    answer_solve,
    check_batch,
    check_solve,
    check_throws,
)
from .varied import (
    answer_aim,
    answer_bank,
    answer_map,
    answer_optimum,
    check_aim,
    check_bank,
    check_map,
    check_optimum,
)

__all__ = ["answer", "check"]


@dataclass(frozen=True)
class _Kind:
    """How questions of a kind are checked, before any work, and answered."""

    check: Callable[[Asked, Any], None]
    answer: Callable[[Asked, Any, Work], Answer]


_KINDS: Mapping[type[Question], _Kind] = MappingProxyType(
    {
        Estimate: _Kind(check_throws, answer_estimate),
        Compare: _Kind(check_throws, answer_compare),
        Solve: _Kind(check_solve, answer_solve),
        Map: _Kind(check_map, answer_map),
        Optimum: _Kind(check_optimum, answer_optimum),
        Bank: _Kind(check_bank, answer_bank),
        Aim: _Kind(check_aim, answer_aim),
        Batch: _Kind(check_batch, answer_batch),
    }
)


def check(asked: Asked) -> None:
    """Look for what can be seen to be wrong before any work.

    Raises
    ------
    TypeError, ValueError, OSError
        If something is.
    """
    _KINDS[type(asked.question)].check(asked, asked.question)


def answer(asked: Asked, work: Work) -> Answer:
    """Answer a question, its tables and figures written into the folder of the work."""
    return _KINDS[type(asked.question)].answer(asked, asked.question, work)
