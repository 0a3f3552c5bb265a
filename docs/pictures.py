"""What the gallery shows of a script: each picture that a block makes, as SVG."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any
from weakref import WeakSet

from matplotlib.figure import Figure
from sphinx_gallery.scrapers import figure_rst

from hoopgen import plots

_DONE: WeakSet[Figure] = WeakSet()


def scrape(block: Any, variables: Mapping[str, Any], gallery: Mapping[str, Any]) -> str:
    """Write the pictures that a block has named or ended with, and return how they are shown."""
    made = [each for each in variables["example_globals"].values() if isinstance(each, Figure)]
    files: list[str] = []
    for figure in made:
        if figure not in _DONE:
            _DONE.add(figure)
            path = Path(next(variables["image_path_iterator"])).with_suffix(".svg")
            files.append(str(plots.save(figure, path)))
    return str(figure_rst(files, gallery["src_dir"]))
