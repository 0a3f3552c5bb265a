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

__all__ = ["EXTRAS", "MissingExtra", "checkout", "explain_import_error", "require", "version"]

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
    command = _command(missing, extra or EXTRAS[missing])
    return MissingExtra(f"{what} needs {missing}: {command}", name=error.name)


def _command(missing: str, extra: str) -> str:
    """Return the command that installs a module; no index needs to have hoopgen."""
    root = checkout()
    if root is not None and extra:
        option = "-e " if _is_editable() else ""
        return f"pip install {option}{shlex.quote(f'{root}[{extra}]')}"
    return f"pip install {' '.join(map(shlex.quote, _requirements(extra) or [missing]))}"


def _installed() -> Distribution | None:
    try:
        return distribution("hoopgen")
    except PackageNotFoundError:
        return None


def _is_editable() -> bool:
    """Return whether hoopgen is an editable installation (PEP 610)."""
    there = _installed()
    told = json.loads((there and there.read_text("direct_url.json")) or "{}")
    return bool(told.get("dir_info", {}).get("editable"))


def _requirements(extra: str) -> list[str]:
    """Return all requirements of an extra as pip takes them, since some may be too old."""
    there = _installed()
    asked = [line.partition(";") for line in (there and there.requires) or []]
    of_extra = re.compile(rf"""\bextra\s*==\s*["']{re.escape(extra)}["']""")
    return [asks.strip() for asks, _, marker in asked if extra and of_extra.search(marker)]
