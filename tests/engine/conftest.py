"""Fixtures of tests of engines."""

from __future__ import annotations

import pytest

from hoopgen.engine import elementary


@pytest.fixture
def without_c(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let NumPy compute the elementary functions and draw releases."""
    monkeypatch.setattr(elementary, "library", lambda: None)
