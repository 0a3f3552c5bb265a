"""Scraper of the gallery: each figure of a script's block as SVG, and each film."""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from weakref import WeakSet

from matplotlib.figure import Figure
from sphinx_gallery.scrapers import figure_rst

from hoopgen import plots

_DONE: WeakSet[Figure] = WeakSet()
_SHOWN: set[Path] = set()


def scrape(block: Any, variables: Mapping[str, Any], gallery: Mapping[str, Any]) -> str:
    """Write the pictures and films that a block has named, and return how they are shown."""
    files: list[str] = []
    for made in variables["example_globals"].values():
        if isinstance(made, Figure) and made not in _DONE:
            _DONE.add(made)
            path = Path(next(variables["image_path_iterator"])).with_suffix(".svg")
            files.append(str(plots.save(made, path)))
        elif isinstance(made, Path) and made.suffix == ".gif" and made not in _SHOWN:
            _SHOWN.add(made)
            path = Path(next(variables["image_path_iterator"])).with_suffix(".gif")
            files.append(shutil.copyfile(made, path).as_posix())
    return str(figure_rst(files, gallery["src_dir"]))
