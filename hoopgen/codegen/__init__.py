"""From derive/ through templates/ to generated/: `generate` writes it, `check` compares it."""

from __future__ import annotations

from .render import check, generate, render_scene

__all__ = ["check", "generate", "render_scene"]
