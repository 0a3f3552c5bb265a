"""How far long work is, on the command line."""

from __future__ import annotations

import itertools
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import click

from hoopgen.printable import printable

__all__ = ["shown"]


@contextmanager
def shown() -> Iterator[Callable[[int, int | None], None]]:
    """Show on stderr, if that is a terminal, how far work is and the time left.

    Of an interrupted run it is said how to go on.

    Yields
    ------
    callable
        To be called with what is done and its total (None: not known).
    """
    try:
        if not sys.stderr.isatty():
            yield lambda done, total: None
            return
        with click.progressbar(itertools.count(), file=sys.stderr) as bar:

            def show(done: int, total: int | None) -> None:
                bar.length = total
                bar.update(done - bar.pos)

            yield show
    except KeyboardInterrupt as error:
        for note in getattr(error, "__notes__", ()):
            click.echo(f"hoopgen: {printable(note)}", err=True)
        raise
