"""``hoopgen compile``, ``cache`` and ``hash``: scenes of one's own, their store, and their bits."""

from __future__ import annotations

import json
from pathlib import Path

import click

from hoopgen.core.backend_names import BackendName
from hoopgen.study.questions.settings import Engines
from hoopgen.text.shorten import join_names
from hoopgen.text.tables import table

from .command import command
from .messages import error_text, examples
from .options import json_option
from .path_types import ZIP
from .question_options import setting_options
from .scene_option import SceneName, limit_option


@command(
    "compile",
    short_help="Compile a scene file for this processor.",
    epilog=examples("hoopgen compile netball.toml", "hoopgen compile hoop --zip hoop-c.zip"),
)
@click.argument("scene", type=SceneName(), metavar="SCENE")
@click.option(
    "--zip",
    "package",
    type=ZIP,
    help="Write its C sources as a package, .zip, with files for CMake and pkg-config.",
)
@limit_option
def compile_(scene: str, package: Path | None) -> None:
    """Compile a scene file for this processor, and compare it with NumPy.

    It takes seconds once; simulations of this scene then find it compiled. Exit status 1 where
    there is no C compiler, or it fails: then NumPy simulates, slower.

    SCENE is a scene file; hoop and court, which are compiled at installation, serve --zip.
    """
    from hoopgen.engine.native import Rejection
    from hoopgen.simulation.lookup import engine_of, scene_from

    engine = engine_of(scene_from(scene))
    if package is not None:
        from hoopgen.codegen.c.package import write_package

        write_package(engine, package)
    click.echo(f"scene       {engine.name}")
    click.echo(f"parameters  {', '.join(engine.parameters) or 'none'}")
    click.echo(f"surfaces    {', '.join(engine.surfaces)}")
    click.echo(f"outcomes    {', '.join(outcome.name.lower() for outcome in engine.outcomes)}")
    if isinstance(engine.found, Rejection):
        click.echo(f"backend     numpy: the C engine {engine.found.reason}; {engine.found.remedy}")
        raise click.exceptions.Exit(1)
    click.echo("backend     c, the same bits as numpy")


@command(
    short_help="Show or clear the folder of compiled scenes.",
    epilog=examples("hoopgen cache --show", "hoopgen cache --clear"),
)
@click.option(
    "--show",
    is_flag=True,
    help="List the compiled scenes; without options the command does the same.",
)
@click.option("--clear", is_flag=True, help="Remove all compiled scenes.")
def cache(show: bool, clear: bool) -> None:
    """Show or clear the folder of compiled scenes."""
    from hoopgen.scene.cache import clear_store, is_empty_store, user_store

    if show and clear:
        raise click.UsageError("--show and --clear exclude each other; leave one out")
    there = user_store()
    if isinstance(there, str):
        if not is_empty_store():
            raise click.ClickException(there)
        click.echo(f"no scene is kept; {there}")
        return
    if show or not clear:
        without = " (without bounds)"
        rows = [
            (
                f"{entry.record['scene']}{'' if entry.record.get('bounds', True) else without}",
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
        count = clear_store(there)
        click.echo(f"removed {count} scene{'s' * (count != 1)} from {there.folder}")


class _Scenes(click.Argument):
    """The argument of several scenes, whose errors name it without brackets."""

    def get_error_hint(self, ctx: click.Context | None) -> str:
        """Return the name.

        Parameters
        ----------
        ctx
            The context of the command.
        """
        return "'SCENES'"


@command(
    "hash",
    short_help="Print the SHA-256 of the results of fixed shots.",
    epilog=examples("hoopgen hash", "hoopgen hash examples/scenes/golf.toml --backend numpy"),
)
@click.argument("scenes", cls=_Scenes, nargs=-1, type=SceneName(), metavar="[SCENES]...")
@limit_option
@setting_options(Engines)
@json_option
def hash_(scenes: tuple[str, ...], backend: BackendName, as_json: bool) -> None:
    """Print the SHA-256 of the results of 100,000 fixed shots in each scene.

    SCENES are hoop, court, air, court-air or scene files; by default those four. Every
    installation should print the same digits, on any processor, with any compiler and backend.
    Other digits mean that some bit of some result differs. Exit status 2 where a scene needs what
    is not installed; the others are printed.
    """
    from hoopgen.simulation.fingerprint import fingerprint
    from hoopgen.simulation.lookup import BUILT_IN, scene_from
    from hoopgen.simulation.lookup import engine_of as engine_of_scene

    engines, missing = [], {}
    for scene in scenes or BUILT_IN:
        try:
            engine = engine_of_scene(scene_from(scene))
            engines.append((scene if scene in BUILT_IN else engine.name, engine))
        except ImportError as error:
            missing[scene] = error_text(error)
    names = [name for name, _ in engines]
    if twice := {name for name in names if names.count(name) > 1}:
        raise click.ClickException(f"SCENES: two are called {min(twice)}; ask for one at a time")
    found = {}
    for name, engine in engines:
        found[name] = fingerprint(engine, backend)
        if not as_json:
            click.echo(f"{found[name]}  {name}")
    if as_json:
        click.echo(json.dumps(found, indent=2))
    if missing:
        why, *_ = missing.values()
        raise click.ClickException(f"no hash of {join_names(missing)}: {why}")
