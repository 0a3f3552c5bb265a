"""Proofs of single shots take short cuts: they find the same events."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import pytest

pytest.importorskip("flint")

from flint import ctx
from hoopgen.derive.scenes import COURT, HOOP
from hoopgen.derive.scenes.scene import Scene

import hoopgen
from benchmarks.workloads import bouncing, free_throw, swirl
from hoopgen.judge import earliest
from hoopgen.judge.flight import ProvedFlight, fly
from hoopgen.judge.formulas import Formulas, formulas
from hoopgen.judge.roots import Undecided
from hoopgen.judge.taylor_model import Number
from tests.helpers.effort import trials

SCENES = {"hoop": (HOOP, hoopgen.HOOP, 40), "court": (COURT, hoopgen.COURT, 30)}

Known = Sequence[tuple[int, Number]]


def shots(count: int) -> list[list[float]]:
    """Return releases that bounce on the ring and on the board."""
    states = np.concatenate([make(count) for make in (free_throw, bouncing, swirl)])
    return [[*map(float, state)] for state in states]


def proof_of(name: str, state: Sequence[float], bits: int, known: Known = ()) -> ProvedFlight:
    """Return what is proved of a shot at a precision."""
    scene, compiled, most = SCENES[name]
    values = [float(value) for value in inputs(scene, compiled)]
    with ctx.workprec(bits):
        try:
            return fly(formulas(scene), state, values, most, known=known)
        except Undecided as undecided:
            found: ProvedFlight = undecided.args[1]
            return found


def inputs(scene: Scene, compiled: Any) -> list[float]:
    """Return the kernels' inputs for the scene's usual parameters."""
    return [compiled.parameters[parameter.name] for parameter in scene.parameters]


def check_same(one: ProvedFlight, other: ProvedFlight) -> None:
    """Both have the same events, at times and with states that overlap."""
    assert one.outcome == other.outcome
    assert len(one.events) == len(other.events)
    for here, there in zip(one.events, other.events, strict=True):
        assert here.surface == there.surface
        assert here.time.overlaps(there.time)
        pairs = zip(here.after, there.after, strict=True)
        assert all(one.overlaps(other) for one, other in pairs)


@pytest.mark.parametrize("name", SCENES)
def test_events_that_are_known_are_found_again_with_more_digits(name: str) -> None:
    again = 0
    for state in shots(trials(20, at_least=4)):
        coarse = proof_of(name, state, 128)
        fine = proof_of(name, state, 512)
        found = proof_of(name, state, 512, coarse.found)
        check_same(found, fine)
        again += len(coarse.found)
        for (surface, time), (same, better) in zip(coarse.found, found.found, strict=False):
            assert surface == same
            assert better.overlaps(time)
            assert better.rad() < time.rad()
    assert again > 20


def check_bodies_that_are_left_out() -> None:
    """The same is proved if no body, and no part of one, is left out of the search."""
    states = shots(trials(20, at_least=4))
    quick = [proof_of("court", state, 256) for state in states]
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(earliest, "_reached", lambda _, parts, *_rest: iter(parts))
        for shot, state in zip(quick, states, strict=True):
            check_same(shot, proof_of("court", state, 256))
    assert len({event.surface for shot in quick for event in shot.events}) > 2


def test_bodies_of_many_parts_that_are_left_out_are_missed(monkeypatch: pytest.MonkeyPatch) -> None:
    shares: list[float] = []
    reached = earliest._reached

    def share(formulas: Formulas, parts: Sequence[int], *given: Any) -> Iterator[int]:
        found = [*reached(formulas, parts, *given)]
        shares.append(len(found) / len(parts))
        return iter(found)

    monkeypatch.setattr(earliest, "_reached", share)
    check_bodies_that_are_left_out()
    assert shares.count(0) > len(shares) / 8  # whole bodies
    assert 0 < min(s for s in shares if s) < 0.3  # parts of them
