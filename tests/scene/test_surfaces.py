"""Surfaces of scenes of one's own, each in C, NumPy, before the judge and a slow reference.

Spheres and cylinders from inside and outside, tori anywhere, boxes, formulas, bodies of several
faces.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.scenes.scene import Scene
from numpy.typing import NDArray

from hoopgen.codegen import render
from hoopgen.engine import native, numpy_backend
from hoopgen.engine.result_arrays import Layout, ResultArrays
from hoopgen.judge.batch import prove
from hoopgen.judge.certificate import Certificate
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
from tests.helpers.scenes.chamber import CHAMBER
from tests.helpers.scenes.crate import CRATE
from tests.helpers.scenes.posts import POSTS
from tests.helpers.scenes.rings import RINGS
from tests.helpers.slow_scene import Face, SlowFaces

Floats = NDArray[np.float64]

# One worker: each scene is rendered once.
pytestmark = [
    pytest.mark.sampled(1),
    pytest.mark.xdist_group("own_surfaces"),
]

MOST = 30


@dataclass(frozen=True)
class Case:
    """A scene, points to throw at and how far around them, and where balls start."""

    scene: Scene
    goals: Sequence[tuple[float, float, float]]
    spread: float
    room: float

    def aimed(self, count: int, seed: int) -> Floats:
        """Return balls thrown at the goals from all around, some from inside of something."""
        rng = np.random.default_rng(seed)
        states = np.zeros((count, 9))
        states[:, :3] = rng.uniform(-self.room, self.room, (count, 3))
        goal = np.array(self.goals)[rng.integers(len(self.goals), size=count)]
        goal += rng.normal(0, self.spread, (count, 3))
        time = rng.uniform(0.05, 0.6, count)
        states[:, 3:6] = (goal - states[:, :3]) / time[:, None]
        states[:, 5] += 9.81 * time / 2
        states[:, 6:] = rng.normal(0, 20, (count, 3))
        return states

    @property
    def defaults(self) -> list[float]:
        """The parameters' usual values, in order."""
        return [p.default for p in self.scene.parameters]


CASES = {
    "chamber": Case(CHAMBER, [(0.3, 0, -0.2), (-0.4, 0, 0.2)], 0.3, 0.6),
    "posts": Case(POSTS, [(-0.4, 0, 0.22), (-0.4, 0, 0), (0.5, 0.2, -0.1), (0, 0.25, 0)], 0.1, 0.8),
    "rings": Case(
        RINGS,
        [(-0.7, 0.2, 0), (0.7, 0.5, 0), (0.5, -0.7, 0), (0, 0, 0.1), (0, 0, -0.5)],
        0.1,
        0.9,
    ),
    "crate": Case(CRATE, [(0, 0, 0), (0.5, 0.25, -0.2), (-0.4, 0.3, 0.5), (-0.4, 0, 0)], 0.1, 0.9),
}


@pytest.fixture(scope="module", params=CASES, name="case")
def every_case(request: pytest.FixtureRequest) -> Case:
    return CASES[request.param]


@pytest.fixture(scope="module", name="folder")
def own_folder(tmp_path_factory: pytest.TempPathFactory, case: Case) -> Path:
    folder = tmp_path_factory.mktemp(case.scene.name)
    for name, text in render.render_scene(case.scene, page=False, targets=["numpy", "c"]).items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


def flown(case: Case, folder: Path, states: Floats) -> ResultArrays:
    module = load_module(folder / "numpy" / f"{case.scene.name}.py")
    out = all_results(module, len(states), MOST)
    numpy_backend.run(module, states, case.defaults, None, MOST, out)
    return out


def proved(case: Case, states: Floats) -> Certificate:
    return prove(case.scene, states, case.defaults, None, MOST)


@needs_compiler
def test_both_engines_give_the_same_bits(case: Case, folder: Path) -> None:
    """1,000 shots, invalid ones too; lanes are tested elsewhere, and are alike."""
    states = case.aimed(trials(1000), seed=1)
    wanted = flown(case, folder, states)
    name = case.scene.name
    source = folder / "c" / f"{name}.c"
    module = load_module(folder / "numpy" / f"{name}.py")
    library = native.Library(shared_library(source, "-O0", f"-D{name.upper()}_WIDEST=1"), module)
    out = all_results(module, len(states), MOST)
    library.run(states, case.defaults, None, MOST, out, np.zeros(1, np.int32), 1)
    for field in Layout(module).results:
        assert same_bits(wanted.arrays[field], out.arrays[field]).all(), field
    assert sequences(out) == sequences(wanted)
    assert {Outcome.INVALID, Outcome.MISSED} <= set(wanted.arrays["outcome"])


def test_no_shot_is_wrong_without_a_flag(case: Case, folder: Path) -> None:
    """1,000 shots against proofs: events in order, outcome, and what is claimed of time and state.

    Every body is met, and hardly a shot is uncertain but those whose bounces accumulate.
    """
    states = case.aimed(trials(1000), seed=2)
    out, proofs = flown(case, folder, states), proved(case, states)
    assert np.sum(~proofs.decided) < exceptions(0.01, len(states))
    found, sure = sequences(out), ~out.arrays["uncertain"]
    for row in np.flatnonzero(sure & proofs.decided):
        proof = proofs[row]
        assert out.arrays["outcome"][row] == proof.outcome, row
        assert found[row] == list(proof.surfaces), row
        if proof.outcome == Outcome.INVALID:
            continue
        off = abs(out.arrays["time"][row] - proof.time)
        assert off <= out.arrays["time_error"][row] + proof.time_radius, row
        away = np.abs(out.arrays["state"][row] - proof.state)
        allowed = np.repeat(out.arrays["state_error"][row], 3)
        assert (away <= allowed + proof.state_radii).all(), row
    ended = np.isin(proofs.outcome, (Outcome.MADE, Outcome.MISSED, Outcome.INVALID))
    assert np.sum(~sure[ended]) < exceptions(0.002, np.sum(ended))
    assert (proofs.counts.sum(axis=0) > occurrences(50)).all()
    assert np.array_equal(out.arrays["counts"][sure], proofs.counts[sure])


# -- By a slow reference, with gaps written by hand


def _norm(*components: Any) -> Any:
    return np.sqrt(sum(np.asarray(c) ** 2 for c in components))


def _torus(centre: Sequence[float], axis: Sequence[float], radius: float, tube: float) -> Any:
    def gap(p: Floats) -> Any:
        away = p - np.array(centre)
        along = away @ np.array(axis)
        across = np.linalg.norm(away - along[..., None] * np.array(axis), axis=-1)
        return _norm(across - radius, along) - tube

    return gap


def _box(low: Sequence[float], high: Sequence[float], ball: float) -> Any:
    def gap(p: Floats) -> Any:
        beyond = np.maximum(np.maximum(np.array(low) - p, p - np.array(high)), 0)
        return np.linalg.norm(beyond, axis=-1) - ball

    return gap


def _post(p: Floats) -> Any:
    side, top = _norm(p[..., 0] + 0.4, p[..., 1]) - 0.04, p[..., 2] - 0.2
    outside = _norm(np.maximum(side, 0), np.maximum(top, 0))
    return outside + np.minimum(np.maximum(side, top), 0) - 0.06


def _rod(p: Floats) -> Any:
    return np.linalg.norm(np.cross(p - [0, 0.25, 0], [0.6, 0, -0.8]), axis=-1) - 0.08


def _low(p: Floats) -> Any:
    return p[2] + 0.1


def _half_pipe(p: Floats) -> Any:
    return max(abs(p[1]) - 0.6, p[2])


def _egg(p: Floats) -> Any:
    """Return the condition over the length of its gradient: near a distance."""
    x, y, z = np.moveaxis(p, -1, 0)
    condition = x**2 + y**2 + z**2 / 2 * (1 + z / 0.4) - 0.04
    return condition / _norm(2 * x, 2 * y, z + 3.75 * z**2)


def _saddle(p: Floats) -> Any:
    x, y, z = np.moveaxis(p, -1, 0)
    return (z + 0.5 - 0.5 * (x**2 - y**2)) / _norm(x, y, 1)


def _bowl(p: Floats) -> Any:
    return np.linalg.norm(p - [0.3, 0, 0], axis=-1)


def _everywhere(p: Floats) -> float:
    return -np.inf


def _slow(ball: float, ground: float, *walls: Any) -> SlowFaces:
    """Return the reference of walls: bodies, gaps of places (..., 3), restitutions and bounds."""

    def face(body: int, gap: Any, restitution: float, within: Any = _everywhere) -> Face:
        def nearest(p: Floats) -> Floats:
            steps = np.eye(3) * 1e-6
            normal = gap(p + steps) - gap(p - steps)
            return np.asarray(p - ball * normal / np.linalg.norm(normal))

        return Face(body, gap, nearest, within, restitution, of_centre=True)

    end = ("ground", lambda p: p[2] - ground, _everywhere)
    faces = [face(*wall) for wall in walls]
    return SlowFaces(faces, [end], ball, inertia=2 / 3, fall=np.array([0, 0, -9.81]))


LEAN = (0, 5 / 13, 12 / 13)
SLOW = {
    "chamber": _slow(
        0.05,
        -0.7,
        (0, lambda p: 0.95 - np.linalg.norm(p, axis=-1), 0.9),
        (1, lambda p: 0.35 - _bowl(p), 0.6, _low),
        (1, lambda p: _bowl(p) - 0.45, 0.6, _low),
    ),
    "posts": _slow(
        0.06,
        -0.8,
        (0, _post, 0.8),
        (1, lambda p: 0.24 - _norm(p[..., 0] - 0.5, p[..., 2]), 0.5, _half_pipe),
        (1, lambda p: _norm(p[..., 0] - 0.5, p[..., 2]) - 0.36, 0.5, _half_pipe),
        (2, _rod, 0.8),
    ),
    "rings": _slow(
        0.05,
        -1.5,
        (0, _torus((-0.73, 0, 0), (1, 0, 0), 0.2, 0.07), 0.8),
        (1, _torus((0.5, 0.5, 0), (0, 0, 1), 0.2, 0.07), 0.8),
        (2, _torus((0.5, -0.5, 0), LEAN, 0.2, 0.07), 0.8),
        (3, lambda p: p[..., 0] + 0.75, 0.8),
        (4, _egg, 0.8, lambda p: p[2] - 0.4),
        (5, _saddle, 0.8, lambda p: _norm(p[0], p[1]) - 0.9),
    ),
    "crate": _slow(
        0.1213,
        -0.9,
        (0, _box((0, -0.25, -0.5), (0.5, 0.25, 0), 0.1213), 0.5),
        (1, _box((-0.43, -0.45, 0.05), (-0.4, 0.45, 0.5), 0.1213), 0.8),
    ),
}


def test_a_slow_reference_finds_the_same(case: Case, folder: Path) -> None:
    """Over 200 shots that end on the ground: the same bodies in order, and when.

    The reference is off by its normals, 1e-9 or so, which every bounce makes grow.
    """
    states = case.aimed(trials(700), seed=3)
    out = flown(case, folder, states)
    ended = np.isin(out.arrays["outcome"], (Outcome.MADE, Outcome.MISSED))
    rows = np.flatnonzero(ended & ~out.arrays["uncertain"] & (out.arrays["contacts"] > 0))[
        : trials(220)
    ]
    assert len(rows) >= occurrences(200)
    slow, ground = SLOW[case.scene.name], len(case.scene.bodies)
    found, log, close = sequences(out), out.arrays["events"]["time"], 0
    for row in rows:
        path = slow.fly(states[row], MOST)
        close += path.close
        if path.close:
            continue
        events = [*path.contacts, (ground, path.time)]
        assert [body for body, _ in events] == found[row], row
        times = [time for _, time in events]
        np.testing.assert_allclose(log[row, : len(times)], times, rtol=0, atol=1e-5)
        np.testing.assert_allclose(out.arrays["state"][row, :3], path.state[:3], rtol=0, atol=1e-4)
    assert close < exceptions(0.01, len(rows))


def test_no_flight_goes_into_a_surface(case: Case, folder: Path) -> None:
    """Every flight of 300 shots is sampled: no gap to an unbounded body is below a rounding.

    A plane is thin, and may be started behind: of what a ball is outside of, it stays so.
    """
    states = case.aimed(trials(300), seed=4)
    out = flown(case, folder, states)
    walls = [face for face in SLOW[case.scene.name].faces if face.within is _everywhere]
    log, used = out.arrays["events"], out.arrays["event_counts"]
    deepest = 0.0
    for row in np.flatnonzero(out.arrays["outcome"] != Outcome.INVALID):
        start, clock = states[row], 0.0
        outside = [wall for wall in walls if wall.distance(start[:3]) > 0]
        for event in log[row, : used[row]]:
            times = np.linspace(0, event["time"] - clock, 200)
            there = start[:3] + start[3:6] * times[:, None]
            there[:, 2] -= 9.81 / 2 * times**2
            deepest = max(deepest, *(-np.min(wall.distance(there)) for wall in outside))
            start, clock = event["after"], event["time"]
    assert deepest < 1e-13


# -- A box, whose parts no one can tell apart


@pytest.fixture(scope="module", name="crates")
def crate_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("crates")
    (folder / "numpy").mkdir()
    text = render.render_scene(CRATE, page=False, targets=["numpy"])["numpy/crate.py"]
    (folder / "numpy" / "crate.py").write_text(text, encoding="utf-8")
    return folder


def test_the_first_touch_of_a_box_is_continuous_from_part_to_part(crates: Path) -> None:
    """Balls side by side, dropped over a face, its edges and a corner: times have no step.

    Neighbours are 2e-5 m apart; a time changes with the place by less than the drop's length over
    its speed, but where the ball passes beside the crate. A seam itself leaves nothing undecided.
    """
    across = np.arange(0.2, 0.36, 2e-5)
    for offset in ((0.0, 0.0), (0.25, 0.0), (0.25, 1e-3)):
        states = np.zeros((len(across), 9))
        states[:, 1] = across
        states[:, 0] = 0.25 + offset[0] + offset[1] + 0.01 * (offset[0] > 0)
        states[:, 2] = 0.5
        out = flown(CASES["crate"], crates, states)
        first = out.arrays["events"]["time"][:, 0]
        hit = out.arrays["first"] == 0
        assert hit[:2_000].all()
        steps = np.abs(np.diff(first[hit]))
        assert steps.max() < 4e-3  # at the last, where it only just touches
        assert np.median(steps) < 2e-5
    on_seams = np.zeros((4, 9))
    on_seams[:, 2] = 0.5
    on_seams[:, :2] = (0.25, 0.25), (0.5, 0.1), (0.5, 0.25), (0.0, -0.25)
    out = flown(CASES["crate"], crates, on_seams)
    assert not out.arrays["uncertain"][out.arrays["outcome"] != Outcome.CAPPED].any()
    log = out.arrays["events"][:, 0]
    heights = log["before"][:, 2]
    assert np.ptp(heights) <= np.spacing(0.5)  # of what they fall from
    proofs = proved(CASES["crate"], on_seams)
    assert [proof.surfaces[0] for proof in proofs.proofs] == [0, 0, 0, 0]


def test_a_box_is_the_same_in_a_mirror(crates: Path) -> None:
    """The crate is between -y and y: mirrored shots are mirrored, to the last bit."""
    states = CASES["crate"].aimed(trials(1000), seed=5)
    mirrored = states * np.array([1, -1, 1, 1, -1, 1, -1, 1, -1])
    out, other = (flown(CASES["crate"], crates, s) for s in (states, mirrored))
    for name in ("outcome", "contacts", "first", "uncertain"):
        assert np.array_equal(out.arrays[name], other.arrays[name]), name
    assert same_bits(out.arrays["time"], other.arrays["time"]).all()
    turned = other.arrays["state"] * np.array([1, -1, 1, 1, -1, 1, -1, 1, -1])
    np.testing.assert_array_equal(out.arrays["state"], turned)


@pytest.mark.parametrize("leaving", [0, 1])
def test_a_ball_can_start_on_a_box_and_leave_it(crates: Path, leaving: int) -> None:
    """On top, at an edge, at a corner; the judge takes it from there."""
    states = np.zeros((3, 9))
    if leaving:  # the board
        states[:, :3] = (-0.2787, 0.0, 0.2), (-0.415, 0.1, 0.6213), (-0.2787, -0.45, 0.3)
    else:
        states[:, :3] = (0.2, 0.0, 0.1213), (0.5, 0.1, 0.1213), (0.1, -0.3713, -0.2)
    states[:, 3:6] = (2.0, -0.5, 1.0) if leaving else (-0.5, -1.0, 1.5)
    left = np.full(3, leaving, np.int8)
    case = CASES["crate"]
    module = load_module(crates / "numpy" / "crate.py")
    out = all_results(module, 3, MOST)
    numpy_backend.run(module, states, case.defaults, left, MOST, out)
    proofs = prove(case.scene, states, case.defaults, left, MOST)
    assert proofs.decided.all()
    for row, found in enumerate(sequences(out)):
        assert out.arrays["uncertain"][row] or found == list(proofs[row].surfaces)
    assert (proofs.outcome != Outcome.INVALID).all()
    assert (~out.arrays["uncertain"]).sum() >= 2


def test_faces_of_one_body_are_one_column(case: Case, folder: Path) -> None:
    """The post has three faces, the pipe two: counts, first and the log say the body."""
    module = load_module(folder / "numpy" / f"{case.scene.name}.py")
    if case.scene is POSTS:
        assert [len(b.faces) for b in POSTS.bodies] == [3, 2, 1]
    assert all_results(module, 1, MOST).arrays["counts"].shape == (1, len(case.scene.bodies))
