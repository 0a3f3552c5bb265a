"""The hoop with friction: both engines, every contact of many shots, the judge, bad parameters."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
import sympy as sp
from flint import arb
from hoopgen.derive.symbolic.conditionals import IfAtMost, IfLess
from numpy.typing import NDArray

import hoopgen
from hoopgen.codegen import render
from hoopgen.engine import native, numpy_backend
from hoopgen.engine.result_arrays import Layout, ResultArrays
from hoopgen.judge.batch import prove
from hoopgen.judge.certificate import Certificate
from hoopgen.judge.expressions import compile_expressions
from hoopgen.results.shots import Outcome
from tests.helpers.compiled import load_module, needs_compiler, same_bits, sequences, shared_library
from tests.helpers.effort import occurrences, trials
from tests.helpers.hoop_shots import families
from tests.helpers.scenes.rough import ROUGH

# One worker: the scene is compiled once.
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("friction"), needs_compiler]

Floats = NDArray[np.float64]

EPS = float(np.finfo(float).eps)
MOST = 40
USUAL = {p.name: p.default for p in ROUGH.parameters}
BODIES = tuple(body.name for body in ROUGH.bodies)
RING, BACKBOARD, BRIDGE = range(3)
ARTICLE = {f"{body}_friction": np.inf for body in BODIES} | {"tangential": 0.0, "falling": np.inf}
ARTICLE |= {f"{body}_restitution": 0.7 for body in BODIES}


@dataclass(frozen=True)
class Engines:
    """Both targets of the scene."""

    module: Any
    library: native.Library

    def room(self, shots: int, most: int = MOST) -> ResultArrays:
        """Return room for all results and the event log."""
        layout = Layout(self.module)
        log = layout.allocate_events(shots, most)
        return layout.allocate(shots, layout.results).joined(log)

    def numpy(self, states: Floats, parameters: Mapping[str, Any]) -> ResultArrays:
        """Simulate on NumPy."""
        out = self.room(len(states))
        values = list(parameters.values())
        numpy_backend.run(self.module, states, values, None, MOST, out)
        return out

    def c(
        self, states: Floats, parameters: Mapping[str, Any], width: int = 0, most: int = MOST
    ) -> ResultArrays:
        """Simulate in C."""
        out = self.room(len(states), most)
        values, stop = list(parameters.values()), np.zeros(1, np.int32)
        self.library.run(states, values, None, most, out, stop, width)
        return out


@pytest.fixture(scope="module")
def engines(tmp_path_factory: pytest.TempPathFactory) -> Engines:
    folder = tmp_path_factory.mktemp("rough")
    for name, text in render.render_scene(ROUGH, page=False, targets=["numpy", "c"]).items():
        path = folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    source = folder / "c" / "rough.c"
    module = load_module(folder / "numpy" / "rough.py")
    return Engines(
        module, native.Library(shared_library(source, "-O1", "-DROUGH_WIDEST=4"), module)
    )


def thrown(count: int, seed: int) -> Floats:
    """Return shots of every kind, equally many."""
    kinds = list(families(-(-count // 7), seed).values())
    return np.concatenate(kinds)[:count]


def of_each(count: int, seed: int) -> dict[str, Any]:
    """Return parameters for each shot: the ends of what is allowed, and what lies between."""
    rng = np.random.default_rng(seed)
    own: dict[str, Any] = {name: np.full(count, value) for name, value in USUAL.items()}
    for body in BODIES:
        own[f"{body}_restitution"] = rng.choice([0.0, 0.5, 0.7, 0.9, 1.0], count)
        own[f"{body}_friction"] = rng.choice([0.0, 1e-9, 0.05, 0.3, 0.8, 1e6, np.inf], count)
    own["tangential"] = rng.choice([-1.0, -0.3, 0.0, 0.15, 1.0], count)
    own["falling"] = rng.choice([1e-3, 1.0, 40.0, np.inf], count)
    return own


# -- The engines


@pytest.mark.parametrize("width", [1, 4])
def test_both_engines_give_the_same_bits(engines: Engines, width: int) -> None:
    """Each shot has its own parameters, infinities and zeros too; only invalid rows have NaN."""
    count = trials(2100, at_least=700)
    states, own = thrown(count, seed=3), of_each(count, seed=4)
    own["tangential"][::50], own["falling"][1::50], own["ring_friction"][2::50] = 1.1, 0.0, np.nan
    wanted, out = engines.numpy(states, own), engines.c(states, own, width)
    for name in (*Layout(engines.module).results, "event_counts"):
        assert same_bits(wanted.arrays[name], out.arrays[name]).all(), name
    assert sequences(out) == sequences(wanted)
    invalid = wanted.arrays["outcome"] == Outcome.INVALID
    assert invalid.sum() >= 3 * (count // 50)
    for name in ("state", "time"):
        assert np.isfinite(wanted.arrays[name][~invalid]).all(), name
    for name in ("state_error", "time_error"):
        assert np.isfinite(wanted.arrays[name][~wanted.arrays["uncertain"] & ~invalid]).all(), name


def test_with_grip_and_nothing_that_falls_it_is_the_hoop(engines: Engines) -> None:
    """Its bits are not: here the slip is taken from the velocity, there the roll is put for it."""
    states = thrown(7000, seed=5)
    out = engines.c(states, USUAL | ARTICLE)
    hoop = {name: USUAL[name] for name in hoopgen.PAPER if name in USUAL} | {"restitution": 0.7}
    wanted = ("outcome", "counts", "state", "state_error", "uncertain")
    shots = hoopgen.simulate(states, hoop, max_contacts=MOST, fields=wanted)
    sure = ~shots.uncertain & ~out.arrays["uncertain"] & (shots.outcome != Outcome.INVALID)
    assert sure.mean() > 0.8
    assert np.array_equal(shots.outcome[sure], out.arrays["outcome"][sure])
    assert np.array_equal(shots.counts[sure], out.arrays["counts"][sure])
    apart = np.abs(shots.state - out.arrays["state"]).reshape(-1, 3, 3).max(axis=2)
    assert (apart <= shots.state_error + out.arrays["state_error"])[sure].all()


# -- Every contact


def contacts(out: ResultArrays) -> NDArray[Any]:
    """Return the contacts of all shots in one row."""
    used = np.arange(MOST + 1) < out.arrays["event_counts"][:, None]
    log = out.arrays["events"][used]
    return log[log["surface"] < len(BODIES)]


def check(log: NDArray[Any], law: Mapping[str, float]) -> tuple[int, int]:
    """Check what every contact keeps and loses; return how many slipped and how many gripped.

    The normals are those of places rounded to some 1e-15 m, over the 0.13 m to the wire.
    """
    place, radius = log["before"][:, :3], USUAL["ball_radius"]
    n = np.zeros_like(place)
    surface = log["surface"]
    n[surface == BACKBOARD] = 1, 0, 0
    n[surface == BRIDGE] = 0, 0, 1
    around = place[:, :2] / np.linalg.norm(place[:, :2], axis=1, keepdims=True)
    off = place - USUAL["ring_radius"] * np.c_[around, np.zeros(len(place))]
    ring = surface == RING
    n[ring] = (off / np.linalg.norm(off, axis=1, keepdims=True))[ring]

    def dot(a: Floats, b: Floats) -> Floats:
        return np.sum(a * b, axis=1)

    v, w = log["before"][:, 3:6], log["before"][:, 6:]
    va, wa = log["after"][:, 3:6], log["after"][:, 6:]
    speed = np.linalg.norm(v, axis=1) + radius * np.linalg.norm(w, axis=1)
    near = 512 * EPS * speed
    own = {
        part: np.array([law[f"{body}_{part}"] for body in BODIES])[surface]
        for part in ("restitution", "friction")
    }
    down = -dot(v, n)
    e = own["restitution"] / (1 + np.maximum(down, 0) / law["falling"])
    assert (np.abs(dot(va, n) - e * down) <= near).all()
    assert (np.abs(dot(wa - w, n)) * radius <= near).all()
    kept = (va - v) + 2 / 3 * radius * np.cross(wa - w, n)
    assert (np.linalg.norm(kept - dot(kept, n)[:, None] * n, axis=1) <= near).all()

    def slip(moving: Floats, turning: Floats) -> Floats:
        point = moving + np.cross(turning, -radius * n)
        return point - dot(point, n)[:, None] * n

    u, ua = slip(v, w), slip(va, wa)
    size, left = np.linalg.norm(u, axis=1), np.linalg.norm(ua, axis=1)
    assert (np.linalg.norm(np.cross(u, ua), axis=1) <= near * np.maximum(size, left)).all()
    # The direction stays where it slips; the size is Coulomb's, or what a grip leaves.
    slid = size - 2.5 * own["friction"] * (1 + e) * np.maximum(down, 0)
    grips = slid <= -law["tangential"] * size
    signed = np.copysign(left, dot(ua, u))
    assert (np.abs(signed - np.where(grips, -law["tangential"] * size, slid)) <= 4 * near).all()
    before, after = ((dot(a, a) + 2 / 3 * radius**2 * dot(b, b)) / 2 for a, b in ((v, w), (va, wa)))
    lost = (1 - e**2) * down**2 / 2 + (size**2 - left**2) / 5
    assert (np.abs(after - before + lost) <= near * speed).all()
    assert (after - before <= near * speed).all()
    return int(np.sum(~grips)), int(np.sum(grips))


def test_every_contact_keeps_and_loses_what_it_must(engines: Engines) -> None:
    """At effort 1 of 100,000 shots."""
    slipped = gripped = 0
    for seed in range(10):
        out = engines.c(thrown(trials(10_000), seed), USUAL)
        one, other = check(contacts(out), USUAL)
        slipped, gripped = slipped + one, gripped + other
    assert min(slipped, gripped) > occurrences(50_000)


@pytest.mark.parametrize(
    "ends",
    [
        {"tangential": 1.0, "falling": np.inf} | {f"{b}_restitution": 1.0 for b in BODIES},
        {"tangential": -1.0, "falling": 1e-3},
        {f"{body}_friction": 0.0 for body in BODIES},
        {f"{body}_friction": np.inf for body in BODIES},
        {f"{body}_restitution": 0.0 for body in BODIES} | {"tangential": 1.0},
    ],
    ids=["nothing lost", "no tangential impulse", "smooth", "grip", "no rebound"],
)
def test_at_the_ends_of_what_is_allowed_too(engines: Engines, ends: dict[str, float]) -> None:
    law = USUAL | ends
    out = engines.c(thrown(trials(3500, at_least=700), seed=8), law)
    log = contacts(out)
    # A ball that does not rebound lies there, is flagged, and its contacts are no contacts.
    first = np.diff(log["shot"], prepend=-1) != 0
    slipped, gripped = check(log[first | ~out.arrays["uncertain"][log["shot"]]], law)
    assert slipped + gripped > occurrences(2000)


def test_an_ideal_ball_keeps_its_energy_from_release_to_end(engines: Engines) -> None:
    """A gripping ball with e = e_t = 1 loses nothing, however often it touches."""
    law = USUAL | ARTICLE | {f"{b}_restitution": 1.0 for b in BODIES} | {"tangential": 1.0}
    states = thrown(trials(1400, at_least=140), seed=9)
    out = engines.c(states, law)
    fine = ~out.arrays["uncertain"] & (out.arrays["outcome"] != Outcome.INVALID)

    def energy(state: Floats) -> Floats:
        spin = 2 / 3 * (USUAL["ball_radius"] * state[:, 6:]) ** 2
        return np.sum(state[:, 3:6] ** 2 + spin, axis=1) / 2 + USUAL["gravity"] * state[:, 2]

    first, final = energy(states[fine]), energy(out.arrays["state"][fine])
    assert out.arrays["contacts"][fine].max() > 5
    np.testing.assert_allclose(final, first, rtol=1e-12, atol=0)


# -- In uncertain


def dropped(slip: float, height: float = 1.0) -> Floats:
    """Return a ball that comes down on the bridge with 4 m/s if gravity is 8, and moves along y."""
    high = TIE["ball_radius"] + TIE["wire_radius"] + height  # exact in doubles
    return np.array([[-0.25, -slip / 2 + 0.015625, high, 0.0, slip, 0.0, 0.0, 0.0, 0.0]])


TIE = USUAL | ARTICLE
TIE |= {"gravity": 8.0, "bridge_restitution": 1.0, "bridge_friction": 0.25}
TIE |= {"ball_radius": 0.125, "wire_radius": 0.0078125}
"""Parameters that just stop a ball of `dropped(5)`: 2/5 of 5 m/s is 1/4 of 2 times 4 m/s."""


def test_the_switch_between_grip_and_slip_is_undecided_within_its_error(engines: Engines) -> None:
    for apart, uncertain_rows in ((0.0, True), (1e-15, True), (1e-11, False), (-1e-11, False)):
        states = dropped(5.0 * (1 + apart))
        out = engines.c(states, TIE)
        log = contacts(out)[:1]
        assert log["surface"].tolist() == [BRIDGE]
        assert bool(out.arrays["uncertain"][0]) is uncertain_rows, apart
        proof = prove(ROUGH, states, list(TIE.values()), None, MOST, max_bits=512)
        if not uncertain_rows:
            assert proof.decided.all()
            assert log["after"][0, 4] == pytest.approx(3.0, abs=1e-10)


def test_the_judge_leaves_a_tie_between_grip_and_slip_undecided() -> None:
    proof = prove(ROUGH, dropped(5.0), list(TIE.values()), None, MOST, max_bits=512)
    assert not proof.decided.any()
    assert proof[0].question == "whether the ball slips on the bridge"


@pytest.mark.parametrize("friction", [0.0, np.inf])
def test_without_friction_or_with_grip_there_is_no_switch_to_flag(
    engines: Engines, friction: float
) -> None:
    """A ball that falls straight down has no slip, and no normal speed where it starts to lie."""
    states = np.zeros((2, 9))
    states[:, :3] = -0.25, 0.02, 0.25
    states[1, 8] = 3.0
    law = TIE | {"bridge_friction": friction, "bridge_restitution": 0.7}
    out = engines.c(states, law, most=4)
    assert (out.arrays["counts"][:, BRIDGE] == 4).all()
    assert not out.arrays["uncertain"].any()
    proof = prove(ROUGH, states, list(law.values()), None, 4)
    assert proof.decided.all()
    assert np.isfinite(out.arrays["state"]).all()
    assert np.isfinite(out.arrays["state_error"]).all()


# -- The judge


def test_what_balls_do_not_decide_is_no_number_unless_it_is_not_asked_for() -> None:
    a, b, c = sp.symbols("a b c")
    inner = IfAtMost(a, 1, 2, 1 / a)
    function = compile_expressions([IfLess(b, sp.oo, inner, c), IfLess(a, 1, 2, 3)], (a, b, c))
    near, infinite = arb(1, 1e-9), arb.pos_inf()
    for given, expected in (
        ((arb(4), arb(0), arb(5)), (arb(1) / 4, arb(3))),
        ((arb(1), arb(0), arb(5)), (arb(2), arb(3))),
        ((near, infinite, arb(5)), (arb(5), None)),
        ((near, arb(0), arb(5)), (None, None)),
        ((arb(0), infinite, arb(5)), (arb(5), arb(2))),
    ):
        for found, wanted in zip(function(given), expected, strict=True):
            assert found.is_nan() if wanted is None else found == wanted


def wrong(out: ResultArrays, proof: Certificate) -> list[str]:
    """Say which shots are not flagged and are not what is proved."""
    found = sequences(out)
    said = []
    for row, one in enumerate(proof.proofs):
        if out.arrays["uncertain"][row]:
            continue
        if not one.decided:
            said.append(f"{row} is undecided: {one.question}")
        elif one.outcome != out.arrays["outcome"][row]:
            said.append(f"{row} is {Outcome(one.outcome).name}")
        elif one.outcome != Outcome.INVALID:
            away = np.abs(out.arrays["state"][row] - one.state).reshape(3, 3).max(axis=1)
            radii = np.reshape(one.state_radii, (3, 3)).max(axis=1)
            if found[row] != list(one.surfaces):
                said.append(f"{row} touches others")
            elif (away > out.arrays["state_error"][row] + radii).any():
                said.append(f"{row} is further off than it says")
    return said


@pytest.mark.parametrize("usual", [True, False], ids=["usual", "each its own"])
def test_what_is_not_flagged_is_what_the_judge_proves(engines: Engines, usual: bool) -> None:
    count = 700
    law = USUAL if usual else of_each(count, seed=12)
    states = thrown(count, seed=13)
    out = engines.c(states, law)
    proof = prove(ROUGH, states, list(law.values()), None, MOST, max_bits=1024, processes=1)
    assert wrong(out, proof) == []
    assert out.arrays["uncertain"].mean() < (0.1 if usual else 0.4)


# -- Parameters

BAD = [
    *({f"{body}_friction": value} for body in BODIES for value in (-1e-300, -np.inf, np.nan)),
    *({"tangential": value} for value in (1.0000001, -1.0000001, np.inf, -np.inf, np.nan)),
    *({"falling": value} for value in (0.0, -40.0, -np.inf, np.nan)),
    *({"ring_restitution": value} for value in (-1e-9, 1.000001, np.inf, np.nan)),
    *({name: np.inf} for name in ("gravity", "ball_radius", "board_top", "end_depth")),
]


def test_what_is_not_allowed_makes_its_own_row_invalid_and_no_other(engines: Engines) -> None:
    states = np.repeat(thrown(7, seed=20)[:1], 2 * len(BAD), axis=0)
    own = {name: np.full(len(states), value) for name, value in USUAL.items()}
    for row, given in enumerate(BAD):
        for name, value in given.items():
            own[name][2 * row] = value
    for out in (engines.c(states, own), engines.numpy(states, own)):
        invalid = out.arrays["outcome"] == Outcome.INVALID
        assert invalid.tolist() == [True, False] * len(BAD)
        assert np.isnan(out.arrays["state"][invalid]).all()
    proof = prove(ROUGH, states, list(own.values()), None, MOST)
    assert (proof.outcome == Outcome.INVALID).tolist() == invalid.tolist()


def test_what_may_be_infinite_or_at_its_end_is_valid(engines: Engines) -> None:
    fine = [
        {"ring_friction": np.inf},
        {"ring_friction": 0.0},
        {"falling": np.inf},
        {"tangential": 1.0},
        {"tangential": -1.0},
        {"ring_restitution": 0.0},
    ]
    states = thrown(7, seed=20)[:1]
    for given in fine:
        law = USUAL | given
        assert engines.c(states, law).arrays["outcome"][0] != Outcome.INVALID
        proof = prove(ROUGH, states, list(law.values()), None, MOST)
        assert proof.outcome[0] != Outcome.INVALID
