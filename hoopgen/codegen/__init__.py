"""Printing of derive/ through templates/ to generated/: `generate` writes, `check` compares."""

from __future__ import annotations

from .committed import check, generate
from .render import render_scene

__all__ = ["check", "generate", "render_scene"]
