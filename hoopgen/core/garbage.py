"""The collection of garbage while many objects are made that stay."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

THRESHOLDS = (50_000, 20, 50)
"""Thresholds of `gc` with which little time goes into what stays."""


@contextmanager
def rare_collection() -> Iterator[None]:
    """Look for garbage seldom: to look through SymPy's expressions takes up to a third of the time.

    It holds for all threads of the process.
    """
    before = gc.get_threshold()
    gc.set_threshold(*THRESHOLDS)
    try:
        yield
    finally:
        gc.set_threshold(*before)
