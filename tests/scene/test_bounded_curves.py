"""Curved surfaces with bounds, bodies with laws of their own, laws that decide within a contact."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.contact.ball import Ball
from hoopgen.derive.contact.law import Law
from hoopgen.derive.contact.no_slip import NoSlip, impact
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.symbolic.conditionals import AtMost, IfLess, absolute
from hoopgen.derive.symbolic.rounding import velocity_error
from numpy.typing import NDArray

from hoopgen.codegen import render
from hoopgen.engine import native, numpy_backend
from hoopgen.engine.result_arrays import Layout, ResultArrays
from hoopgen.judge.batch import prove
from hoopgen.results.shots import Outcome
from tests.helpers.compiled import (
    all_results,
    load_module,
    needs_compiler,
    same_bits,
    sequences,
    shared_library,
)
from tests.helpers.effort import exceptions, occurrences, trials
from tests.helpers.scenes.caps import CAPS

# One worker: the scene is rendered once.
pytestmark = pytest.mark.xdist_group("bounded_curves")

MOST = 40
DEFAULTS = [p.default for p in CAPS.parameters]
CAP, HALF, STEP = range(3)


def written(scene: Scene, folder: Path) -> Path:
    """Render a scene into a folder."""
    for name, text in render.render_scene(scene, page=False, targets=["numpy", "c"]).items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(CAPS, tmp_path_factory.mktemp("caps"))


@pytest.fixture(scope="module")
def module(folder: Path) -> ModuleType:
    return load_module(folder / "numpy" / "caps.py")


def aimed(count: int, seed: int) -> NDArray[np.float64]:
    """Return balls thrown at either sphere from all around, from below and inside it too."""
    rng = np.random.default_rng(seed)
    states = np.zeros((count, 9))
    states[:, :3] = rng.uniform((-1, -0.5, -0.3), (1.2, 0.5, 1.2), (count, 3))
    goal = rng.normal(0, 0.2, (count, 3))
    goal[:, 0] += rng.choice([-0.5, 0.5], count)
    time = rng.uniform(0.05, 0.5, count)
    states[:, 3:6] = (goal - states[:, :3]) / time[:, None]
    states[:, 5] += 9.81 * time / 2
    states[:, 6:] = rng.normal(0, 20, (count, 3))
    return states


def flown(module: ModuleType, states: NDArray[np.float64]) -> ResultArrays:
    out = all_results(module, len(states), MOST)
    numpy_backend.run(module, states, DEFAULTS, None, MOST, out)
    return out


@pytest.mark.slow
def test_a_root_out_of_bounds_lets_the_search_go_on(module: ModuleType) -> None:
    """2,000 shots against the judge, many through the part that is not there."""
    states = aimed(trials(2000, at_least=1000), seed=1)
    out = flown(module, states)
    proofs = prove(CAPS, states, DEFAULTS, None, MOST)
    assert proofs.decided.all()
    sure = ~out.arrays["uncertain"]
    ended = proofs.outcome != Outcome.CAPPED
    assert np.sum(~sure[ended]) < exceptions(0.001, np.sum(ended))
    found = sequences(out)
    for row in np.flatnonzero(sure):
        assert out.arrays["outcome"][row] == proofs.outcome[row], row
        assert found[row] == list(proofs[row].surfaces), row
    assert (proofs.counts[:, [CAP, HALF]].sum(axis=0) > occurrences(300)).all()
    assert _through(states, out).sum() > occurrences(50)


def _through(states: NDArray[np.float64], out: ResultArrays) -> NDArray[np.bool_]:
    """Return which shots are inside the missing half of the sphere on their first flight."""
    # A log without events has whatever the memory had before.
    logged = out.arrays["event_counts"] > 0
    end = np.where(logged, out.arrays["events"]["time"][:, 0], 0.0)
    inside = np.zeros(len(states), bool)
    for share in np.linspace(0, 1, 50):
        t = (share * end)[:, None]
        place = states[:, :3] + states[:, 3:6] * t
        place[:, 2] -= 9.81 / 2 * t[:, 0] ** 2
        place[:, 0] -= 0.5
        inside |= (np.linalg.norm(place, axis=1) < 0.34) & (place[:, 0] < -0.01)
    return inside & (out.arrays["outcome"] != Outcome.INVALID)


@pytest.mark.slow
def test_each_body_has_its_own_law(module: ModuleType) -> None:
    """The normal speed after a contact is that body's restitution times the one before."""
    out = flown(module, aimed(trials(500, at_least=250), seed=2))
    used = np.arange(MOST + 1) < out.arrays["event_counts"][:, None]
    log = out.arrays["events"][used]
    centre = {CAP: (-0.5, 0.0, 0.0), HALF: (0.5, 0.0, 0.0)}
    for surface, restitution in ((CAP, 0.9), (HALF, 0.9), (STEP, 0.4)):
        here = log[log["surface"] == surface]
        normal = np.tile([0.0, 0.0, 1.0], (len(here), 1))
        if surface in centre:
            normal = (here["before"][:, :3] - centre[surface]) / 0.35
        before = np.einsum("ij,ij->i", normal, here["before"][:, 3:6])
        after = np.einsum("ij,ij->i", normal, here["after"][:, 3:6])
        scale = np.abs(here["before"][:, 3:6]).max(axis=1)
        assert len(here) > occurrences(50)
        # The normal here is that of the rounded place: a few roundings of the speed.
        assert (np.abs(after + restitution * before) <= 1e-13 * scale).all()


@pytest.mark.slow
@needs_compiler
def test_both_engines_give_the_same_bits(module: ModuleType, folder: Path) -> None:
    states = aimed(trials(1500), seed=3)
    wanted = flown(module, states)
    source = folder / "c" / "caps.c"
    library = native.Library(shared_library(source, "-O1", "-DCAPS_WIDEST=4"), module)
    for width in (1, 4):
        out = all_results(module, len(states), MOST)
        library.run(states, DEFAULTS, None, MOST, out, np.zeros(1, np.int32), width)
        for name in Layout(module).results:
            assert same_bits(wanted.arrays[name], out.arrays[name]).all(), (width, name)
        assert sequences(out) == sequences(wanted)


@dataclass(frozen=True)
class Brittle(NoSlip):
    """A law that stops dead what arrives slowly: a decision within the contact."""

    least: sp.Expr

    def after(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball: Ball
    ) -> tuple[sp.Matrix, sp.Matrix]:
        moved, turned = super().after(normal, velocity, spin, ball)
        slow = absolute(velocity.dot(normal))
        kept = velocity - velocity.dot(normal) * normal
        chosen = [IfLess(slow, self.least, k, m) for k, m in zip(kept, moved, strict=True)]
        return sp.Matrix(chosen), turned

    def undecided(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball: Ball
    ) -> sp.Basic:
        return AtMost(absolute(absolute(velocity.dot(normal)) - self.least), 4 * velocity_error)


@pytest.fixture(scope="module")
def brittle(tmp_path_factory: pytest.TempPathFactory) -> Callable[[NDArray[np.float64]], Any]:
    symbols = {p.symbol.name: p.symbol for p in CAPS.parameters}
    law = Brittle("brittle_impact", symbols["dull"], 8 * symbols["apart"])  # 4 m/s
    bodies = tuple(b if b.name != "step" else replace(b, law=law) for b in CAPS.bodies)
    folder = written(replace(CAPS, bodies=bodies), tmp_path_factory.mktemp("brittle"))
    made = load_module(folder / "numpy" / "caps.py")
    return lambda states: flown(made, states)


@pytest.mark.slow
def test_a_law_can_be_undecided(brittle: Callable[[NDArray[np.float64]], ResultArrays]) -> None:
    """A ball that arrives with just the speed that decides is uncertain, others are not."""
    states = np.zeros((3, 9))
    states[:, 2] = 0.05 - 0.25 + 1e-9  # just above the step
    states[:, 5] = -np.sqrt(16.0 - 2 * 9.81 * 1e-9) * np.array([1.0, 1 - 1e-6, 1 + 1e-6])
    out = brittle(states)
    first = out.arrays["events"][:, 0]
    assert (first["surface"] == STEP).all()
    np.testing.assert_allclose(first["before"][0, 5], -4.0, rtol=0, atol=2e-15)
    assert out.arrays["uncertain"].tolist()[0]
    assert not out.arrays["uncertain"][1:].any() or out.arrays["outcome"][1] == Outcome.CAPPED
    assert first["after"][1, 5] == 0.0
    assert first["after"][2, 5] > 1.0


@dataclass(frozen=True)
class Fading(Law):
    """A law whose restitution falls with the speed along the normal: e / (1 + v / v0)."""

    slow: sp.Expr
    half: sp.Expr

    def restitution_at(self, speed: sp.Expr) -> sp.Expr:
        return self.slow / (1 + speed / self.half)

    def after(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball: Ball
    ) -> tuple[sp.Matrix, sp.Matrix]:
        restitution = self.restitution_at(-velocity.dot(normal))
        return impact(normal, velocity, spin, ball, restitution)


@pytest.mark.slow
def test_a_restitution_can_fall_with_the_speed(tmp_path: Path) -> None:
    """The judge asks the law for it at the speed of each contact, on planes too."""
    symbols = {p.symbol.name: p.symbol for p in CAPS.parameters}
    law = Fading("fading_impact", symbols["lively"], 8 * symbols["apart"])  # half at 4 m/s
    scene = replace(CAPS, bodies=tuple(replace(b, law=law) for b in CAPS.bodies))
    states = aimed(trials(300), seed=4)
    out = flown(load_module(written(scene, tmp_path) / "numpy" / "caps.py"), states)
    proofs = prove(scene, states, DEFAULTS, None, MOST)
    assert proofs.decided.all()
    sure = np.flatnonzero(~out.arrays["uncertain"] & (proofs.outcome != Outcome.INVALID))
    found = sequences(out)
    assert all(found[row] == list(proofs[row].surfaces) for row in sure)
    apart = np.abs(out.arrays["state"] - proofs.state).reshape(-1, 3, 3).max(axis=2)
    assert (apart <= out.arrays["state_error"] + proofs.state_error)[sure].all()
    log = out.arrays["events"][np.arange(MOST + 1) < out.arrays["event_counts"][:, None]]
    before, after = (log[log["surface"] == STEP][side][:, 5] for side in ("before", "after"))
    assert len(before) > occurrences(100)
    np.testing.assert_allclose(-after / before, 0.9 / (1 - before / 4.0), rtol=1e-14, atol=0)
