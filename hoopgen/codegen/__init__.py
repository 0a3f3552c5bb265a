"""From derive/ through templates/ to generated/: `generate` writes it, `check` compares it."""

from __future__ import annotations

from .committed import check, generate
from .render import render_scene

__all__ = ["check", "generate", "render_scene"]
