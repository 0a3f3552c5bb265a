"""Faults with a check of their own can be planted, at any effort: what each changes is there."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from pathlib import Path

import pytest

from tests.helpers.checked_faults import Planted

FILES = [
    file.stem
    for file in sorted(Path(__file__).parent.glob("test_*.py"))
    if file.stem == "test_air"
    or ("tripping(" in file.read_text(encoding="utf-8") and file != Path(__file__))
]


@pytest.mark.parametrize("file", FILES)
def test_every_fault_of_a_file_can_be_planted(file: str) -> None:
    faults = importlib.import_module(f"tests.mutations.{file}").FAULTS
    if isinstance(faults, Mapping):
        patches = [fault for fault, _ in faults.values()]
    else:
        assert all(isinstance(fault, Planted) for fault in faults)
        patches = [fault.patch for fault in faults]
    assert len(patches) > 1
    for planted in patches:
        with pytest.MonkeyPatch.context() as patch:
            planted(patch)
