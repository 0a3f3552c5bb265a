"""The page that `view` returns: its file, which notebooks display."""

from __future__ import annotations

import html
import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

_FRAME_HEIGHT = 640
"""Height of the page in a notebook, pixels."""


@dataclass(frozen=True)
class Page(os.PathLike[str]):
    """A page of shots, usable as the path of its file.

    Attributes
    ----------
    path
        The file written; None if there is none.
    text
        The page, HTML.
    about
        What is said below its title, the scene at the end.
    read
        Of a table, what each of its columns was read as, line by line; see `hoopgen.batch`.
    """

    path: Path | None
    text: str = field(repr=False)
    about: str = field(default="", repr=False)
    read: str = field(default="", repr=False)

    def __fspath__(self) -> str:
        return os.fspath(self._file())

    def __str__(self) -> str:
        return "a page without a file" if self.path is None else str(self.path)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or not hasattr(Path, name):
            raise AttributeError(f"Page has no attribute {name!r}")
        if self.path is None:
            raise AttributeError(f"Page has no attribute {name!r} without a file: give view a path")
        return getattr(self.path, name)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *(dir(self.path) if self.path is not None else ())})

    def _file(self) -> Path:
        if self.path is None:
            raise ValueError("the page has no file: give view a path")
        return self.path

    def _repr_html_(self) -> str:
        # All of it is text of one attribute, and its scripts see nothing of the notebook.
        return (
            f'<iframe srcdoc="{html.escape(self.text)}" width="100%" height="{_FRAME_HEIGHT}" '
            'sandbox="allow-scripts" style="border: 0" title="Shots in motion"></iframe>'
        )
