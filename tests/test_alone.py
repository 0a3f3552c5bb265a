"""Few shots, which NumPy takes one by one through what repeats: the same bits as in rows."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest
from compiled import same_bits
from court_shots import all_kinds
from hoopgen.generated.numpy import court, hoop
from numpy.typing import NDArray

from benchmarks.workloads import bouncing, free_throw, swirl
from hoopgen.engine import numpy_backend
from hoopgen.engine.raw import Layout, Raw

MOST = 40
Floats = NDArray[np.float64]


def hoops(shots: int) -> Floats:
    """Return shots that meet the ring, some of them forty times."""
    return np.concatenate([make(shots) for make in (free_throw, bouncing, swirl)])


def flown(
    monkeypatch: pytest.MonkeyPatch, module: ModuleType, states: Floats, bounds: bool, alone: int
) -> Raw:
    """Return the results where so many shots go one by one."""
    monkeypatch.setattr(module, "ALONE", alone)
    layout = Layout(module)
    wanted = [name for name, result in layout.results.items() if bounds or not result.bounds]
    out = layout.allocate(len(states), wanted)
    given = [default for default, _, _ in module.PARAMETERS.values()]
    numpy_backend.run(module, states, given, None, MOST, out)
    return out


@pytest.mark.parametrize("bounds", [False, True], ids=["plain", "bounded"])
@pytest.mark.parametrize("module", [hoop, court], ids=["hoop", "court"])
def test_shots_one_by_one_have_the_bits_of_those_in_rows(
    monkeypatch: pytest.MonkeyPatch, module: ModuleType, bounds: bool
) -> None:
    """None, as many as by default, and all of them, in what repeats and from a turn of it on."""
    states = hoops(60) if module is hoop else all_kinds(60)
    usual = module.ALONE
    in_rows = flown(monkeypatch, module, states, bounds, 0)
    assert in_rows.contacts is not None
    assert in_rows.contacts.max() > 3
    for alone in (usual, len(states) // 3, len(states)):
        one_by_one = flown(monkeypatch, module, states, bounds, alone)
        for name, column in in_rows.arrays.items():
            assert same_bits(column, one_by_one.arrays[name]).all(), (alone, name)
