"""The installation: its version, its kind, and commands that install missing extras."""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Mapping
from importlib import import_module
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from pathlib import Path
from types import MappingProxyType
from typing import Any

EXTRAS: Mapping[str, str] = MappingProxyType(
    {
        "matplotlib": "plot",
        "sympy": "generate",
        "jinja2": "generate",
        "flint": "certify",
        "scipy": "study",
        "pyarrow": "study",
        "xarray": "study",
        "pydantic": "study",
        "markdown_it": "study",
        "dask": "scale",
        "distributed": "scale",
        "openpyxl": "xlsx",
        "cupy": "cuda",
        "jax": "jax",
        "jaxlib": "jax",
        "ziglang": "",
        "pandas": "",
    }
)
"""Modules that may be missing, and the extra that installs each; empty: its name installs it."""


class MissingExtra(ImportError):
    """A module that is not installed, with the command that installs it."""


def checkout() -> Path | None:
    """Return the source checkout from which this hoopgen runs, None if it is installed."""
    root = Path(__file__).resolve().parents[2]
    return root if (root / "pyproject.toml").is_file() and (root / "derive").is_dir() else None


def version() -> str:
    """Return the version; of a checkout that is not installed, that of its pyproject.toml."""
    there = _installed()
    if there is not None:
        return there.version
    import tomllib

    root = checkout()
    if root is None:
        raise RuntimeError("hoopgen: neither installed nor run from a checkout")
    text = (root / "pyproject.toml").read_text(encoding="utf-8")
    return str(tomllib.loads(text)["project"]["version"])


def require(module: str, what: str) -> Any:
    """Import a module that may be missing.

    Parameters
    ----------
    module
        Its name, as it is imported.
    what
        Needs it, in words.

    Raises
    ------
    MissingExtra
        If it is missing: what brings it.
    """
    try:
        return import_module(module)
    except ImportError as error:
        raise explain_import_error(error, what) from None


def explain_import_error(error: ImportError, what: str = "this", extra: str = "") -> ImportError:
    """Return an import error with the command that installs the missing module.

    Parameters
    ----------
    error
        Of an import.
    what
        Needs it, in words.
    extra
        That brings it; by default as `EXTRAS` has it.
    """
    missing = (error.name or "").partition(".")[0]
    if isinstance(error, MissingExtra) or missing not in EXTRAS:
        return error
    command = install_command(missing, extra or EXTRAS[missing], checkout(), _installed())
    return MissingExtra(f"{what} needs {missing}: {command}", name=error.name)


def command_for(module: str) -> str:
    """Return the command that installs a missing module of `EXTRAS`, with all of its extra."""
    return install_command(module, EXTRAS[module], checkout(), _installed())


def install_command(
    missing: str, extra: str, root: Path | None, installed: Distribution | None
) -> str:
    """Return the command that installs a module; no index needs to have hoopgen.

    Parameters
    ----------
    missing, extra
        The module and the extra that brings it; empty where its name does.
    root
        The checkout from which hoopgen runs; None if it is installed.
    installed
        The installation, if there is one: its requirements, and whether it is editable (PEP 610).
    """
    if root is not None and extra:
        url = json.loads((installed and installed.read_text("direct_url.json")) or "{}")
        option = "-e " if url.get("dir_info", {}).get("editable") else ""
        return f"pip install {option}{shlex.quote(f'{root}[{extra}]')}"
    # All requirements of the extra, since some may be too old.
    lines = [line.partition(";") for line in (installed and installed.requires) or []]
    of_extra = re.compile(rf"""\bextra\s*==\s*["']{re.escape(extra)}["']""")
    needed = [name.strip() for name, _, marker in lines if extra and of_extra.search(marker)]
    return f"pip install {' '.join(map(shlex.quote, needed or [missing]))}"


def _installed() -> Distribution | None:
    try:
        return distribution("hoopgen")
    except PackageNotFoundError:
        return None
