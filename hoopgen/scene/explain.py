"""The derivation's page for a scene of one's own."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .scene import Scene

__all__ = ["page"]


def page(scene: Scene) -> str:
    """Return the page, in Markdown with LaTeX."""
    try:
        from hoopgen.codegen.render import PAGE, render_scene
    except ImportError as error:
        from hoopgen.installed import explained

        raise explained(error, "Scene.explain") from None
    files = render_scene(scene.derive())
    stem = PAGE.partition(".")[0]
    return next(text for name, text in files.items() if name.startswith(stem))
