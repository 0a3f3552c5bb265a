"""Types of options and arguments that are paths: files to read, files and folders to write."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import click

from hoopgen.core.files import FILMS, MAPS, PAGES, PICTURES, check_folder, check_output

from .command import note_input, note_output
from .types import Type


class _Path(click.Path):
    """A path; one without a name would be the folder that the command is given in."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the path."""
        if value == "":
            self.fail("expected a name, got ''", param, ctx)
        return super().convert(value, param, ctx)


class _Input(_Path):
    """A file to be read, which no option of the command writes."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the path."""
        path = super().convert(value, param, ctx)
        note_input(ctx, param, path)
        return path


class Checked(Type[Path]):
    """A path that a function checks before any work, with a ValueError or OSError."""

    def __init__(self, check: Callable[[Path], Path], path: click.Path) -> None:
        self.check, self.path = check, path
        self.name = path.name

    def convert(
        self, value: str | Path, param: click.Parameter | None, ctx: click.Context | None
    ) -> Path:
        """Return the path, if it can be written.

        Arguments as for `click.ParamType.convert`.
        """
        try:
            path = self.check(Path(str(self.path.convert(value, param, ctx))))
        except OSError as error:
            self.fail(f"{error.filename}: {error.strerror}", param, ctx)
        except ValueError as error:
            self.fail(str(error), param, ctx)
        note_output(ctx, param, path)
        return path


def _ending(suffixes: Sequence[str]) -> Checked:
    """Return the type of a file to be written whose name ends in one of these."""
    return Checked(lambda path: check_output(path, suffixes), _Path(dir_okay=False, path_type=Path))


FILE = _Input(exists=True, dir_okay=False, path_type=Path)
"""A file to be read."""

OUT = Checked(check_output, _Path(dir_okay=False, path_type=Path))
"""A file to be written."""

PICTURE = _ending(PICTURES)
"""A picture to be written."""

PICTURE_OR_FILM = _ending((*PICTURES, *FILMS))
"""A picture to be written, or what it shows in motion."""

PAGE = _ending(PAGES)
"""A page to be written."""

MAP = _ending(MAPS)
"""A map to be written."""

ZIP = _ending((".zip",))
"""An archive to be written."""

FOLDER = Checked(check_folder, _Path(file_okay=False, path_type=Path))
"""A folder to be written."""
