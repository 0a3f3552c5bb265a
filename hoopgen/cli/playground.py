"""``hoopgen playground``: a page on which shots are thrown, in any browser."""

from __future__ import annotations

from pathlib import Path

import click

from hoopgen.core.backend_names import BackendName
from hoopgen.study.questions.settings import Engines
from hoopgen.text.escape import printable

from .command import command
from .messages import examples
from .path_types import PAGE
from .question_options import setting_options


@command(
    short_help="Write a page on which sliders throw shots.",
    epilog=examples(
        "hoopgen playground --out playground.html",
        "hoopgen playground --out playground.html --backend numpy",
    ),
)
@click.option(
    "--out", type=PAGE, required=True, help="The page, .html: one file that needs no network."
)
@setting_options(Engines)
def playground(out: Path, backend: BackendName) -> None:
    """Write a page on which sliders throw shots, at the article's hoop or with a real ball.

    The page runs the C engines as WebAssembly, with the bits of every other backend, and compares
    the SHA-256 of 100,000 fixed shots with that of this installation. It shows the shot in motion,
    its contacts, 10,000 throws about it, a map of speed and elevation, and the smallest changes
    with which it ends otherwise. Its address contains the shot, so a link reproduces it.
    """
    from hoopgen.viewer.playground_page import playground as write_playground

    page = write_playground(out, backend=backend)
    click.echo(printable(f"{out}: {page.about}"))
