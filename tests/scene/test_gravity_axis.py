"""Free fall along any axis: a scene turned on its side has the same motion, turned."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from hoopgen.derive.model import build
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.scenes.scene import Scene
from numpy.typing import NDArray

from hoopgen.codegen.render import render_scene
from hoopgen.engine import native, numpy_backend
from hoopgen.engine.result_arrays import Layout, ResultArrays
from hoopgen.judge.batch import prove
from hoopgen.results.shots import Outcome
from tests.helpers.compiled import load_module, needs_compiler, same_bits, shared_library
from tests.helpers.effort import exceptions, occurrences, trials
from tests.helpers.scenes.caps import CAPS
from tests.helpers.scenes.turned import ALONG_X, DOWN_Y, WHEEL, Turn, turned, turned_states
from tests.scene.test_bounded_curves import MOST, aimed, sequences, written

# One worker: scenes are rendered once.
pytestmark = pytest.mark.xdist_group("gravity_axis")


@dataclass(frozen=True)
class Made:
    """A scene, rendered into a folder, and its NumPy module."""

    scene: Scene
    folder: Path
    module: ModuleType

    @property
    def defaults(self) -> list[float]:
        return [p.default for p in self.scene.parameters]

    def room(self, shots: int) -> ResultArrays:
        layout = Layout(self.module)
        return layout.allocate(shots, layout.results).joined(layout.allocate_events(shots, MOST))

    def numpy(self, states: NDArray[np.float64]) -> ResultArrays:
        out = self.room(len(states))
        numpy_backend.run(self.module, states, self.defaults, None, MOST, out)
        return out


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Callable[[Scene], Made]:
    done: dict[str, Made] = {}

    def make(scene: Scene) -> Made:
        if scene.name not in done:
            folder = written(scene, tmp_path_factory.mktemp(scene.name))
            module = load_module(folder / "numpy" / f"{scene.name}.py")
            done[scene.name] = Made(scene, folder, module)
        return done[scene.name]

    return make


TURNS = {"caps_y": DOWN_Y, "caps_x": ALONG_X}
turns = pytest.mark.parametrize(("name", "turn"), TURNS.items(), ids=list(TURNS))


@pytest.mark.slow
@turns
def test_a_turned_scene_has_the_motion_of_the_upright_one(
    made: Callable[[Scene], Made], name: str, turn: Turn
) -> None:
    """The same exact shots: apart by no more than both say that they can be off by."""
    states = aimed(trials(1500), seed=11)
    upright, aside = made(CAPS), made(turned(CAPS, name, turn))
    one, other = upright.numpy(states), aside.numpy(turned_states(states, turn))
    sure = ~one.arrays["uncertain"] & ~other.arrays["uncertain"]
    ended = one.arrays["outcome"] != Outcome.CAPPED
    assert np.sum(~sure[ended]) < exceptions(0.001, np.sum(ended))
    assert np.array_equal(one.arrays["outcome"][sure], other.arrays["outcome"][sure])
    found, there = sequences(one), sequences(other)
    assert all(found[row] == there[row] for row in np.flatnonzero(sure))
    assert sum(map(len, found)) > occurrences(3000)
    flown = sure & (one.arrays["outcome"] != Outcome.INVALID)
    apart = np.abs(one.arrays["time"] - other.arrays["time"])
    assert (apart <= one.arrays["time_error"] + other.arrays["time_error"])[flown].all()
    back = turned_states(one.arrays["state"], turn)
    apart = np.abs(back - other.arrays["state"]).reshape(-1, 3, 3).max(axis=2)
    assert (apart <= one.arrays["state_error"] + other.arrays["state_error"])[flown].all()


@pytest.mark.sampled(1)
@turns
def test_the_judge_proves_the_same_of_both(name: str, turn: Turn) -> None:
    states = aimed(trials(300), seed=12)
    scene = turned(CAPS, name, turn)
    defaults = [p.default for p in CAPS.parameters]
    upright = prove(CAPS, states, defaults, None, MOST)
    aside = prove(scene, turned_states(states, turn), defaults, None, MOST)
    assert upright.decided.all()
    assert aside.decided.all()
    assert [p.surfaces for p in upright] == [p.surfaces for p in aside]
    flown = upright.outcome != Outcome.INVALID
    late = np.abs(upright.time - aside.time)
    assert (late <= upright.time_radius + aside.time_radius)[flown].all()


@pytest.mark.slow
@pytest.mark.parametrize("name", [*TURNS, "wheel"])
def test_results_are_those_of_the_judge(made: Callable[[Scene], Made], name: str) -> None:
    scene, states = scene_and_states(name, 600)
    own = made(scene)
    out = own.numpy(states)
    proofs = prove(scene, states, own.defaults, None, MOST)
    assert proofs.decided.all()
    sure = ~out.arrays["uncertain"]
    # Of a torus, an octic, the general search can allow for errors in which the rate at which the
    # ball leaves is lost: it then makes no headway, and leaves the shot uncertain.
    unsure = ~sure[proofs.outcome != Outcome.CAPPED]
    assert np.sum(unsure) < exceptions(0.1 if name == "wheel" else 0.001, len(unsure))
    found = sequences(out)
    for row in np.flatnonzero(sure):
        assert out.arrays["outcome"][row] == proofs.outcome[row], row
        assert found[row] == list(proofs[row].surfaces), row
    assert (proofs.counts.sum(axis=0) > 100).all()


@pytest.mark.slow
@needs_compiler
@pytest.mark.parametrize("name", [*TURNS, "wheel"])
def test_both_engines_give_the_same_bits(made: Callable[[Scene], Made], name: str) -> None:
    scene, states = scene_and_states(name, 1000)
    own = made(scene)
    wanted = own.numpy(states)
    source = own.folder / "c" / f"{name}.c"
    flags = ("-O1", f"-D{name.upper()}_WIDEST=4")
    library = native.Library(shared_library(source, *flags), own.module)
    for width in (1, 4):
        out = own.room(len(states))
        library.run(states, own.defaults, None, MOST, out, np.zeros(1, np.int32), width)
        for field in Layout(own.module).results:
            assert same_bits(wanted.arrays[field], out.arrays[field]).all(), (width, field)
        assert sequences(out) == sequences(wanted)


def scene_and_states(name: str, count: int) -> tuple[Scene, NDArray[np.float64]]:
    if name in TURNS:
        states = turned_states(aimed(count, seed=13), TURNS[name])
        return turned(CAPS, name, TURNS[name]), states
    return WHEEL, thrown(count)


def thrown(count: int) -> NDArray[np.float64]:
    """Return balls thrown at the wheel from around and above it, to the left of it in x."""
    rng = np.random.default_rng(14)
    states = np.zeros((count, 9))
    states[:, :3] = rng.uniform((-1.5, -0.8, -0.5), (-0.7, 0.8, 0.5), (count, 3))
    goal = rng.normal(0, 0.3, (count, 3))
    time = rng.uniform(0.1, 0.6, count)
    states[:, 3:6] = (goal - states[:, :3]) / time[:, None]
    states[:, 3] -= 9.81 * time / 2
    states[:, 6:] = rng.normal(0, 20, (count, 3))
    return states


@pytest.mark.slow
def test_studies_speak_of_heights_only_where_free_fall_is_down() -> None:
    assert not build(WHEEL).study
    assert build(HOOP).study


@pytest.mark.slow
def test_the_page_of_a_turned_scene_speaks_of_its_own_axes() -> None:
    page = render_scene(WHEEL)["derivation_wheel.md"]
    assert "A shot ends where it crosses a plane of an end against the plane's normal" in page
    assert "| missed | ground | everywhere |" in page
    assert "way down" not in page
    assert r"v_x(t) &= v_{x} + g t" in page


@pytest.mark.parametrize("axis", [(0, 0, 0), (0, 0, -2), (1, 1, 0), "z"])
def test_free_fall_goes_along_an_axis(axis: tuple[int, int, int]) -> None:
    with pytest.raises(ValueError, match=r"scene hoop: gravity_axis: expected one of .*, got "):
        replace(HOOP, gravity_axis=axis)
