"""Helpers of the tests: compilers, slow references, scenes and faults."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
"""The folder of the checkout."""


def contents(folder: Path) -> dict[str, bytes]:
    """Return every file of a folder, by its name."""
    return {file.name: file.read_bytes() for file in folder.iterdir()}
