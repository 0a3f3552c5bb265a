"""``hoopgen compile`` and ``cache``: scenes of one's own, and where they are kept compiled."""

from __future__ import annotations

from pathlib import Path

import click

from hoopgen.cli.command import command
from hoopgen.cli.examples import examples
from hoopgen.cli.own import limit_option
from hoopgen.cli.types import FILE
from hoopgen.layout import table

__all__ = ["cache", "compile_"]


@command(
    "compile",
    epilog=examples("hoopgen compile netball.toml", "hoopgen compile examples/scenes/bowl.toml"),
)
@click.argument("file", type=FILE)
@limit_option
def compile_(file: Path) -> None:
    """Compile a scene file for this processor, and compare it with NumPy.

    It takes seconds once; simulations of this scene then find it compiled. Exit status 1 where
    there is no C compiler, or it fails: then NumPy simulates, slower.
    """
    import hoopgen
    from hoopgen.engine.native import Refused

    engine = hoopgen.compile(hoopgen.load_scene(file))
    click.echo(f"scene       {engine.name}")
    click.echo(f"parameters  {', '.join(engine.parameters) or 'none'}")
    click.echo(f"surfaces    {', '.join(engine.surfaces)}")
    click.echo(f"outcomes    {', '.join(outcome.name.lower() for outcome in engine.outcomes)}")
    if isinstance(engine.found, Refused):
        click.echo(f"backend     numpy: the C engine {engine.found.reason}; {engine.found.remedy}")
        raise click.exceptions.Exit(1)
    click.echo("backend     c, the same bits as numpy")


@command(epilog=examples("hoopgen cache --show", "hoopgen cache --clear"))
@click.option("--show", is_flag=True, help="List what is kept; this is done, too, without options.")
@click.option("--clear", is_flag=True, help="Remove all of it; scenes are then compiled anew.")
def cache(show: bool, clear: bool) -> None:
    """Show or clear the folder of compiled scenes."""
    from hoopgen.scene.cache import cleared, own

    there = own()
    if isinstance(there, str):
        raise click.ClickException(there)
    if show or not clear:
        rows = [
            (
                str(entry.record["scene"]),
                str(entry.record["compiler"]) or "none",
                str(entry.record["width"]),
                "numpy" if entry.record["refused"] else "c",
                f"{sum(map(len, entry.files.values())) // 1024}",
            )
            for entry in there.entries()
        ]
        click.echo(there.folder)
        if rows:
            headers = ("scene", "compiler", "lanes", "backend", "kB")
            click.echo(table(headers, rows, right=(2, 4)))
        else:
            click.echo("no scene is kept")
    if clear:
        count = cleared(there)
        click.echo(f"removed {count} scene{'s' * (count != 1)} from {there.folder}")
