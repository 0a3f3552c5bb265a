"""A scene's own ends: several, on one plane or on many, with bounds or without, or none at all.

Both engines give the same bits, and what they are sure of the judge proves.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.surfaces import Plane
from hoopgen.derive.symbolic.symbols import POSITION
from numpy.typing import NDArray

from hoopgen.codegen import render
from hoopgen.engine import native, numpy_backend
from hoopgen.engine.result_arrays import Layout, ResultArrays
from hoopgen.judge import Certificate
from hoopgen.judge.batch import prove
from tests.helpers.compiled import WARNINGS, load_module, needs_compiler, same_bits, shared_library
from tests.helpers.scenes.caps import CAPS
from tests.helpers.scenes.plank import plank
from tests.helpers.scenes.table import TABLE

# One worker: each scene is compiled once.
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("ends"), needs_compiler]

MOST = 8
ENDLESS = math.inf
x, y, z = POSITION
ZERO = sp.Integer(0)


def symbols(scene: Scene) -> dict[str, sp.Symbol]:
    return {p.name: p.symbol for p in scene.parameters}


def floor(name: str, depth: sp.Expr, *limits: sp.Expr) -> Plane:
    return Plane(name, (0, 0, 1), -depth, ZERO, limits)


def _rows() -> Scene:
    """Return a table between walls: a cup and a mat on the ground, and gaps between them."""
    own = symbols(TABLE)
    depth, side = own["table_height"], own["half_length"]
    cup = sp.sqrt((x - own["cup_x"]) ** 2 + y**2) - own["cup_radius"]
    return replace(
        TABLE,
        name="rows",
        ends=(
            End("cup", floor("ground", depth, cup)),
            End("left", Plane("left_wall", (1, 0, 0), -2 * side, ZERO)),
            End("mat", floor("ground", depth, x, -y - side, y - side)),
            End("right", Plane("right_wall", (-1, 0, 0), -2 * side, ZERO, (-z - depth / 2,))),
        ),
    )


def _nested() -> Scene:
    """Return the caps over a target: rings about the origin, each end around the one before it.

    What bounds them is a length, or a polynomial, that is made one.
    """
    own = symbols(CAPS)
    rho, square = sp.sqrt(x**2 + y**2), x**2 + y**2
    rings = {
        "gold": square - (own["goal"] / 2) ** 2,
        "red": rho - own["goal"],
        "blue": square - 4 * own["goal"] ** 2,
    }
    ends = [End(name, floor("ground", own["depth"], ring)) for name, ring in rings.items()]
    return replace(CAPS, name="nested", ends=(*ends, End("out", floor("ground", own["depth"]))))


SCENES = {
    "rows": _rows(),
    "nested": _nested(),
    "open": replace(TABLE, name="open", ends=()),
    "plank": replace(plank(), name="bare", ends=()),
}
LIMITS = {"rows": ENDLESS, "nested": 0.8, "open": 1.2, "plank": 0.9}


@dataclass(frozen=True)
class Engines:
    """Both targets of a scene."""

    scene: Scene
    module: ModuleType
    library: native.Library

    def run(self, states: NDArray[np.float64], limit: float, most: int = MOST) -> ResultArrays:
        """Simulate on both, look that the bits are the same, and return them."""
        given = [p.default for p in self.scene.parameters]
        outs = []
        layout = Layout(self.module)
        for fields in (tuple(layout.results), layout.fields[:-1]):
            for in_c in (False, True):
                out = layout.allocate(len(states), fields)
                out = out.joined(layout.allocate_events(len(states), most))
                outs.append(out)
                if in_c:
                    stop = np.zeros(1, np.int32)
                    self.library.run(states, given, None, most, out, stop, time_limit=limit)
                else:
                    numpy_backend.run(self.module, states, given, None, most, out, time_limit=limit)
        for out in outs[1:]:
            self._check_same(outs[0], out)
        return outs[0]

    def _check_same(self, one: ResultArrays, other: ResultArrays) -> None:
        for name in (*Layout(self.module).results, "event_counts"):
            if getattr(other, name) is not None:
                assert same_bits(getattr(one, name), getattr(other, name)).all(), name
        for shot in range(len(one.outcome)):
            for name in ("shot", "surface", "time", "before", "after", "kind"):
                assert same_bits(events(one, shot)[name], events(other, shot)[name]).all()

    def names(self, out: ResultArrays) -> list[str]:
        """Return the outcomes by name."""
        names = list(self.scene.outcomes)
        return [names[code] for code in out.outcome]


def events(out: ResultArrays, shot: int) -> NDArray[np.void]:
    assert out.events is not None
    assert out.event_counts is not None
    found: NDArray[np.void] = out.events[shot, : out.event_counts[shot]]
    return found


def judged(scene: Scene, states: NDArray[np.float64], limit: float) -> Certificate:
    given = [p.default for p in scene.parameters]
    return prove(scene, states, given, None, MOST, max_bits=512, processes=1, time_limit=limit)


@pytest.fixture(scope="module")
def engines(tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, Engines]:
    """Render a scene that is asked for into a folder of its own; compile it without a warning."""

    class Made(dict[str, Engines]):
        def __missing__(self, name: str) -> Engines:
            self[name] = made(SCENES[name], tmp_path_factory.mktemp(name))
            return self[name]

    return Made()


def made(scene: Scene, folder: Path, widest: int = 4) -> Engines:
    for name, text in render.render_scene(scene, page=False, targets=["numpy", "c"]).items():
        path = folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    width = f"-D{scene.name.upper()}_WIDEST={widest}"
    # At -O1 GCC takes a lane that a loop fills for one that nothing does.
    flags = (*WARNINGS, "-Wno-maybe-uninitialized", "-O1", width)
    library = shared_library(folder / "c" / f"{scene.name}.c", *flags)
    module = load_module(folder / "numpy" / f"{scene.name}.py")
    return Engines(scene, module, native.Library(library, module))


def shots(count: int, seed: int) -> NDArray[np.float64]:
    """Return balls let go over the scene and about it, some of them below, some not finite."""
    random = np.random.default_rng(seed)
    states = np.zeros((count, 9))
    states[:, :3] = random.uniform((-1.0, -0.6, 0.3), (1.0, 0.6, 1.0), (count, 3))
    states[:, 3:6] = random.normal(0, 1.5, (count, 3))
    states[:, 6:] = random.normal(0, 20, (count, 3))
    states[::25, 2] = -0.6
    states[1::50, 3] = np.nan
    return states


def shot(place: Sequence[float], velocity: Sequence[float] = (0, 0, 0)) -> NDArray[np.float64]:
    return np.array([[*place, *velocity, 0.0, 0.0, 0.0]])


# All of them


@pytest.mark.parametrize("name", SCENES)
def test_engines_give_the_same_bits_and_the_judge_agrees(
    engines: Mapping[str, Engines], name: str
) -> None:
    """Outcome, contacts and events of every shot that is not uncertain; errors within claims."""
    own, limit = engines[name], LIMITS[name]
    states = shots(300, seed=11)
    out, proofs = own.run(states, limit), judged(own.scene, states, limit)
    sure = ~out.uncertain.astype(bool)
    assert sure.mean() > 0.95
    assert proofs.decided[sure].all()
    assert np.array_equal(out.outcome[sure], proofs.outcome[sure])
    assert np.array_equal(out.counts[sure], proofs.counts[sure])
    for row in np.flatnonzero(sure):
        assert events(out, row)["surface"].tolist() == proofs[row].surfaces, row
    valid = sure & (out.outcome != own.scene.outcomes["invalid"])
    apart = np.abs(out.state - proofs.state).reshape(-1, 3, 3).max(axis=2)
    assert (apart <= out.state_error)[valid].all()
    assert (np.abs(out.time - proofs.time) <= out.time_error)[valid].all()


@pytest.mark.parametrize("name", SCENES)
def test_outcomes_are_the_ends_in_order_and_then_the_others(
    engines: Mapping[str, Engines], name: str
) -> None:
    own = engines[name]
    ends = [end.name for end in own.scene.ends]
    others = ["capped", "short", "invalid", "lodged", "endless"]
    assert [o.name.lower() for o in own.module.Outcome] == [*ends, *others]
    assert list(own.module.Outcome) == list(range(len(ends) + 5))
    assert list(own.module.ENDS) == ends


# Ends by name


def test_each_end_is_reached_where_it_is(engines: Mapping[str, Engines]) -> None:
    """Through gaps between them, and beside a wall's bounds, a ball falls for ever."""
    own, p = engines["rows"], {q.name: q.default for q in TABLE.parameters}
    drop, beside = 0.5, p["half_width"] + 0.2
    wanted = {
        "cup": shot((p["cup_x"], 0, drop)),
        "mat": shot((-p["half_length"], beside, drop)),
        "left": shot((0, beside, drop), (-9, 0, 0)),
        "right": shot((0, beside, drop), (9, 0, 0)),
        "short": shot((0.2, beside, drop)),
        "capped": shot((0.4, 0, drop)),
    }
    out = own.run(np.concatenate(list(wanted.values())), ENDLESS)
    assert own.names(out) == list(wanted)
    assert not out.uncertain.any()
    assert out.event_counts.tolist() == [1, 1, 1, 1, 0, MOST]
    assert [events(out, k)["surface"][-1] for k in range(4)] == [len(own.scene.bodies)] * 4
    assert out.state[0, 2] == pytest.approx(-p["table_height"], abs=1e-15)
    # Below half the table's height the wall on the right has ended.
    low = own.run(shot((0.2, beside, drop), (1.5, 0, 0)), ENDLESS)
    assert own.names(low) == ["short"]


def test_of_ends_on_one_plane_the_first_counts(engines: Mapping[str, Engines]) -> None:
    """And one crossing on the edge of an end, whatever the others say, is uncertain."""
    own, goal = engines["nested"], {p.name: p.default for p in CAPS.parameters}["goal"]
    places = [0.1 * goal, 0.75 * goal, 1.5 * goal, 2.5 * goal]
    low = -0.4  # under the caps, over the ground
    out = own.run(np.concatenate([shot((0, place, low)) for place in places]), ENDLESS)
    assert own.names(out) == ["gold", "red", "blue", "out"]
    assert not out.uncertain.any()
    edges = own.run(np.concatenate([shot((0, k * goal, low)) for k in (0.5, 1, 2)]), ENDLESS)
    assert edges.uncertain.all()


@pytest.mark.slow
def test_the_edge_of_an_end_within_another_is_certain(tmp_path: Path) -> None:
    """A ball that an earlier end has surely taken is not uncertain."""
    own = symbols(CAPS)
    large, small = (sp.sqrt(x**2 + y**2) - k * own["goal"] for k in (2, 1))
    ends = (
        End("large", floor("ground", own["depth"], large)),
        End("small", floor("ground", own["depth"], small)),
    )
    made_here = made(replace(CAPS, name="within", ends=ends), tmp_path, widest=1)
    goal = {p.name: p.default for p in CAPS.parameters}["goal"]
    out = made_here.run(np.concatenate([shot((0, k * goal, -0.4)) for k in (1, 2)]), ENDLESS)
    assert made_here.names(out)[0] == "large"
    assert out.uncertain.tolist() == [False, True]


# No ends, and time


@pytest.mark.slow
def test_without_ends_the_time_limit_ends_what_is_not_capped(
    engines: Mapping[str, Engines],
) -> None:
    """Also a ball that meets nothing any more; without a limit nothing can end that."""
    own = engines["open"]
    states = np.concatenate([shot((0.4, 0, 0.5)), shot((2, 0, 0.5), (1, 0, 1)), shot((2, 0, 9))])
    out = own.run(states, 1.5)
    assert own.names(out) == ["endless"] * 3
    assert out.time.tolist() == [1.5] * 3
    assert out.time_error.tolist() == [0.0] * 3
    assert not out.uncertain.any()
    for row in range(3):
        end = events(out, row)[-1]
        assert (end["surface"], end["time"]) == (len(own.scene.bodies), 1.5)
        assert np.array_equal(end["before"], end["after"])
        assert np.array_equal(end["after"], out.state[row])
    g = {p.name: p.default for p in TABLE.parameters}["acceleration"]
    assert out.state[1, :6] == pytest.approx(
        [3.5, 0, 0.5 + 1.5 - g * 1.5**2 / 2, 1, 0, 1 - 1.5 * g], rel=1e-15
    )
    assert own.names(own.run(states, 60.0))[0] == "capped"
    assert own.names(own.run(states, ENDLESS)) == ["capped", "short", "short"]


def test_with_ends_a_ball_that_can_reach_none_is_short_whatever_the_limit(
    engines: Mapping[str, Engines],
) -> None:
    own = engines["rows"]
    states = np.concatenate([shot((0.2, 0.7, 0.5)), shot((0, 0.7, 0.5), (-0.1, 0, 0))])
    assert own.names(own.run(states, 0.1)) == ["short", "endless"]
    assert own.names(own.run(states, ENDLESS)) == ["short", "mat"]


@pytest.mark.parametrize("name", ["rows", "nested"])
def test_a_limit_that_no_shot_comes_to_changes_nothing(
    engines: Mapping[str, Engines], name: str
) -> None:
    own, states = engines[name], shots(200, seed=5)
    without, limited = own.run(states, ENDLESS), own.run(states, 1e3)
    for field in Layout(own.module).results:
        assert same_bits(getattr(without, field), getattr(limited, field)).all(), field


def test_a_contact_at_the_time_limit_is_uncertain(engines: Mapping[str, Engines]) -> None:
    """Contacts on either side of the limit are uncertain, those a little further off are not."""
    own = engines["open"]
    release = shot((0.4, 0, 0.5))
    times = events(own.run(release, ENDLESS), 0)["time"]
    for time in times[:3]:
        for limit, flag in ((time, 1), (np.nextafter(time, 9), 1), (time * (1 + 1e-9), 0)):
            assert own.run(release, float(limit)).uncertain.tolist() == [flag]
        assert own.run(release, time * (1 - 1e-9)).uncertain.tolist() == [0]


def test_a_cap_at_the_time_limit_leaves_room_in_the_log(engines: Mapping[str, Engines]) -> None:
    own, release = engines["open"], shot((0.4, 0, 0.5))
    times = events(own.run(release, ENDLESS), 0)["time"]
    out = own.run(release, float(times[1] + times[2]) / 2, most=3)
    assert (own.names(out), out.event_counts.tolist()) == (["endless"], [3])
    out = own.run(release, float(times[2]) + 1e-6, most=3)
    assert (own.names(out), out.event_counts.tolist()) == (["capped"], [3])


# What is refused


@pytest.mark.parametrize(
    ("names", "said"),
    [
        (("Made", "missed"), "scene 'plank': end 'Made': expected a small letter"),
        (("made", "made"), "scene plank: end 'made': 2 have this name"),
        (("made", "short"), "scene plank: end 'short': 2 have this name"),
    ],
)
def test_names_of_ends_are_checked(names: tuple[str, str], said: str) -> None:
    with pytest.raises(ValueError, match=f"^{said}"):
        plank(ends=names)


def test_an_end_behind_one_that_takes_the_whole_plane_is_refused() -> None:
    own = symbols(TABLE)
    ground = floor("ground", own["table_height"])
    with pytest.raises(
        ValueError, match=r"^scene table: end 'late': comes after 'all', which has no bounds"
    ):
        replace(TABLE, ends=(End("all", ground), End("late", replace(ground, limits=(x,)))))
