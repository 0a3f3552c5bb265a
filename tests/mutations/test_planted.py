"""Every fault can be planted, whatever the effort: what it changes is there."""

from __future__ import annotations

import importlib
from pathlib import Path

import pytest

from tests.helpers.checked_faults import Planted

FILES = sorted(file.stem for file in Path(__file__).parent.glob("test_*.py"))


@pytest.mark.parametrize("file", FILES)
def test_every_fault_of_a_file_can_be_planted(file: str) -> None:
    module = importlib.import_module(f"tests.mutations.{file}")
    for fault in vars(module).get("FAULTS", ()):
        if isinstance(fault, Planted):
            with pytest.MonkeyPatch.context() as patch:
                fault.patch(patch)
