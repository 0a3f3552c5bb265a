"""The event loop as a tree: a guard guards however it is printed, and the path needs no bounds."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hoopgen.derive.ir.event_tree import Call, If, While, reads, walk, writes
from hoopgen.derive.loop.loop import TEMPORARY_BOUNDS
from hoopgen.derive.model import Model, build
from hoopgen.derive.scenes.hoop import HOOP
from hoopgen.generated.numpy import hoop

from benchmarks.families import FAMILIES
from hoopgen import PAPER
from hoopgen.codegen.numpy import NumPyBackend
from hoopgen.codegen.numpy.options import Options
from hoopgen.codegen.registry import BACKENDS
from hoopgen.engine.result_arrays import Layout, ResultArrays, need_bounds
from tests.helpers.compiled import same_bits
from tests.helpers.hoop_shots import Batch
from tests.helpers.mutants import Fault, Run, derived, numpy_engine, numpy_module

# One worker: the derivation is made once.
pytestmark = pytest.mark.xdist_group("codegen")

MOST = 12
LAYOUT = Layout(hoop)
RESULT = LAYOUT.results
PATH = tuple(name for name, result in RESULT.items() if not result.is_diagnostic)


@cache
def hoop_model() -> Model:
    return build(HOOP)


@cache
def shots() -> Batch:
    """Shots of every family, a parameter a column, rows that cannot start among them."""
    made = [family.make(60) for family in FAMILIES]
    states = np.concatenate([states for states, _ in made])
    columns = {
        name: np.concatenate([np.broadcast_to(p[name], len(s)) for s, p in made]) for name in PAPER
    }
    states[::97, 0] = np.nan
    columns["gravity"][5::101] = -1.0
    mixed = np.random.default_rng(3).permutation(len(states))
    return Batch(states, columns).take(mixed)


def flown(run: Run, fields: tuple[str, ...]) -> ResultArrays:
    given = shots()
    # Blank: a row without an event leaves the log as it was.
    room = LAYOUT.allocate_events(len(given), MOST)
    assert room.events is not None
    room.events[:] = 0
    out = LAYOUT.allocate(len(given), fields).joined(room)
    run(given.states, list(given.parameters.values()), MOST, out)
    return out


def assert_same(one: ResultArrays, other: ResultArrays, fields: tuple[str, ...]) -> None:
    for name in fields:
        assert same_bits(one.arrays[name], other.arrays[name]).all(), name
    assert np.array_equal(one.arrays["event_counts"], other.arrays["event_counts"])
    for name in ("shot", "surface", "time", "before", "after", "kind"):
        columns = (raw.arrays["events"][name] for raw in (one, other))
        assert same_bits(*columns).all(), name


@pytest.mark.parametrize("cheap", [-1, 10**9], ids=["rows taken", "all done, then chosen"])
@pytest.mark.slow
def test_a_guarded_body_changes_nothing_outside_its_guard(
    cheap: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Taking the rows that a guard lets through, or choosing after all: the same bits."""
    limits = Options(max_inline_cost=cheap, max_inline_cost_in_turns=cheap)
    monkeypatch.setitem(BACKENDS, "numpy", NumPyBackend(options=limits))
    files = derived(Fault("none"))
    text = files["numpy/hoop.py"]
    nodes = [n for s in hoop_model().loop.stages.values() for n in walk(s)]
    guards, repeats = ([n for n in nodes if isinstance(n, kind)] for kind in (If, While))
    plain = [g for g in guards if not g.rare and all(isinstance(n, Call) for n in g.body)]
    taken = len(re.findall(r" = _(?:rows|most)\(", text.partition("def start_bounded")[2]))
    assert taken == len(guards) + len(repeats) - (len(plain) if cheap > 0 else 0)
    assert len(plain) > len(guards) / 2
    fields = tuple(RESULT)
    other = flown(numpy_engine(numpy_module(files, tmp_path)), fields)
    assert_same(flown(numpy_engine(hoop), fields), other, fields)


def test_the_plain_loop_reads_and_writes_nothing_that_bounds_errors() -> None:
    """Error bounds are left out: a number stands for them where a kernel takes them."""
    whole = hoop_model().loop
    plain = whole.plain()
    bounds = {field.name for field in whole.fields if field.is_diagnostic} | set(TEMPORARY_BOUNDS)
    bounds |= {"position_error", "velocity_error", "claims"}
    met = set()
    for stage, nodes in plain.stages.items():
        assert not reads(nodes) & bounds, stage
        assert not set(writes(nodes)) & bounds, stage
        met |= reads(whole.stages[stage]) & bounds
    assert len(met) > 10  # they are there to be left out
    names = {n.kernel.name for s in plain.stages.values() for n in walk(s) if isinstance(n, Call)}
    assert not names & {
        "carry_flight",
        "carry_impact",
        "claimed_errors",
        "displacement",
        "tie_undecided",
    }


def test_the_plain_loop_flies_the_path_of_the_bounded_one() -> None:
    whole = flown(numpy_engine(hoop), tuple(RESULT))
    plain = flown(numpy_engine(hoop), PATH)
    assert need_bounds(hoop, whole.arrays)
    assert not need_bounds(hoop, plain.arrays)
    assert_same(whole, plain, PATH)
