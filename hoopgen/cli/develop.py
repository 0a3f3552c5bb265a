"""``hoopgen generate``, ``check`` and ``bench``: for work in a source checkout."""

from __future__ import annotations

import subprocess
import sys
from functools import partial
from pathlib import Path

import click

from .messages import examples


def _checkout() -> Path:
    """Find the source checkout this hoopgen runs from."""
    from hoopgen.core.extras import checkout

    root = checkout()
    if root is None:
        raise click.UsageError("hoopgen does not run from a source checkout; give --root")
    return root


def _listed(root: Path, written: list[Path]) -> bool:
    """Print the files that were written; return whether there are any."""
    for path in written:
        click.echo(path.relative_to(root) if path.is_relative_to(root) else path)
    return bool(written)


def _check_root(ctx: click.Context, param: click.Parameter, root: Path | None) -> Path | None:
    """Refuse a folder from which nothing can be generated, before anything is written into it."""
    if root is not None and (
        missing := [f"{name}/" for name in _SOURCES if not (root / name).is_dir()]
    ):
        text = f"{root} is no source checkout: it has no {' and no '.join(missing)}"
        raise click.BadParameter(text, ctx, param)
    return root


_SOURCES = ("derive", "templates")
"""Folders of a source checkout from which generated/ is written."""


_root_option = click.option(
    "--root",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    callback=_check_root,
    help="The source checkout; by default the one hoopgen runs from.",
)


@click.command(
    short_help="Write generated/ anew from derive/ and templates/.",
    epilog=examples("hoopgen generate", "hoopgen generate --root ../hoopgen"),
)
@_root_option
def generate(root: Path | None) -> None:
    """Write generated/ anew from derive/ and templates/.

    Files that would not change are not touched. WebAssembly is compiled from generated/c if it is
    of other sources, which needs the extra `compile`, with its version of zig.
    """
    from hoopgen import codegen
    from hoopgen.engine import web_assembly

    root = root or _checkout()
    folder = root / "generated"
    check_before_writing = partial(web_assembly.check_before_writing, folder)
    written = _listed(root, codegen.generate(root, check_before_writing))
    written |= _listed(root, web_assembly.build(folder, web_assembly.stale_modules(folder)))
    if not written:
        click.echo("nothing to write: generated/ is up to date")


@click.command(
    short_help="Compare generated/ with what derive/ and templates/ give.",
    epilog=examples("hoopgen check", "hoopgen check --root ../hoopgen"),
)
@_root_option
@click.pass_context
def check(ctx: click.Context, root: Path | None) -> None:
    """Compare generated/ with what derive/ and templates/ give.

    Exit status 1 when a file is stale, missing or extra.
    """
    from hoopgen import codegen
    from hoopgen.engine import web_assembly

    root = root or _checkout()
    differences = codegen.check(root)
    differences += [
        f"stale or missing file: generated/wasm/{name}"
        for name in web_assembly.stale_modules(root / "generated")
    ]
    for difference in differences:
        click.echo(difference)
    if differences:
        ctx.exit(1)
    click.echo("generated/ is up to date")


@click.command(
    short_help="Measure how fast hoopgen is, in a source checkout.",
    context_settings={"ignore_unknown_options": True},
    epilog=examples("hoopgen bench", "hoopgen bench -- --help"),
)
@click.argument("arguments", nargs=-1, type=click.UNPROCESSED)
@click.pass_context
def bench(ctx: click.Context, arguments: tuple[str, ...]) -> None:
    """Measure how fast hoopgen is, in a source checkout.

    Arguments go to `python -m benchmarks`, which runs in the checkout's folder.
    """
    root = _checkout()
    if not (root / "benchmarks").is_dir():
        raise click.ClickException(f"no benchmarks in {root}")
    command = [sys.executable, "-m", "benchmarks", *arguments]
    ctx.exit(subprocess.run(command, cwd=root, check=False).returncode)
