"""Few shots, which NumPy takes one by one through what repeats: the same bits as in rows."""

from __future__ import annotations

import re
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from hoopgen.generated.numpy import court, hoop
from numpy.typing import NDArray

import hoopgen
from benchmarks.workloads import bouncing, free_throw, swirl
from hoopgen import COURT, PAPER_COURT
from hoopgen.engine import numpy_backend
from hoopgen.engine.result_arrays import Layout, ResultArrays
from tests.helpers.compiled import same_bits
from tests.helpers.court_shots import all_kinds
from tests.helpers.effort import trials

MOST = 40
Floats = NDArray[np.float64]


def hoops(shots: int) -> Floats:
    """Return shots that meet the ring, some of them forty times."""
    return np.concatenate([make(shots) for make in (free_throw, bouncing, swirl)])


def flown(
    monkeypatch: pytest.MonkeyPatch, module: ModuleType, states: Floats, bounds: bool, alone: int
) -> ResultArrays:
    """Return the results where so many shots go one by one."""
    monkeypatch.setattr(module, "ALONE", alone)
    layout = Layout(module)
    wanted = [name for name, result in layout.results.items() if bounds or not result.is_diagnostic]
    out = layout.allocate(len(states), wanted)
    given = [default for default, _, _ in module.PARAMETERS.values()]
    numpy_backend.run(module, states, given, None, MOST, out)
    return out


@pytest.mark.sampled(1)
@pytest.mark.parametrize("bounds", [False, True], ids=["plain", "bounded"])
@pytest.mark.parametrize("module", [hoop, court], ids=["hoop", "court"])
def test_shots_one_by_one_have_the_bits_of_those_in_rows(
    monkeypatch: pytest.MonkeyPatch, module: ModuleType, bounds: bool
) -> None:
    """None, as many as by default, and all of them, in what repeats and from a turn of it on."""
    count = trials(60, at_least=30)
    states = hoops(count) if module is hoop else all_kinds(count)
    usual = module.ALONE
    in_rows = flown(monkeypatch, module, states, bounds, 0)
    assert in_rows.contacts is not None
    assert in_rows.contacts.max() > 3
    for alone in (usual, len(states) // 3, len(states)):
        one_by_one = flown(monkeypatch, module, states, bounds, alone)
        for name, column in in_rows.arrays.items():
            assert same_bits(column, one_by_one.arrays[name]).all(), (alone, name)


@pytest.mark.parametrize("module", [hoop, court], ids=["hoop", "court"])
def test_no_number_of_python_meets_one_shot(module: ModuleType) -> None:
    """One of Python's raises where it is divided by zero, and NumPy's is infinite."""
    text = Path(str(module.__file__)).read_text(encoding="utf-8")
    alone = [part for part in text.split("\n\n\n") if re.match(r"def _\w+_alone\(", part)]
    assert len(alone) > 20
    assert not [part for part in alone if re.search(r"(?<![\w.])\d+\.\d|\b_inf\b", part)]


def test_a_ball_that_begins_to_roll_between_board_and_ring_is_followed_alone() -> None:
    """A board that is near: in rows something is divided by zero, and not a number is passed on."""
    own = {"board_distance": 0.30, "ring_restitution": 0.0}
    size = PAPER_COURT | own
    x, y = 0.245, 0.02
    reach = size["ball_radius"] + size["wire_radius"]
    z = np.sqrt(reach**2 - (np.hypot(x, y) - size["ring_radius"]) ** 2) + 1e-4
    state = [[x, y, z, 0, 0, 0, 0, 0, 0]]
    alone, lanes = (
        hoopgen.simulate(state, own, scene=COURT, backend=backend) for backend in ("numpy", "auto")
    )
    assert alone.contacts[0] == 1
    assert alone.time[0] == lanes.time[0]
