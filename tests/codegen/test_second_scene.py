"""A scene that is not the hoop goes the whole way: derived, generated, compiled, run and right.

Physics is checked by hand and against `Slow`, which shares no formula and no search with hoopgen.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from hoopgen.derive import scenes
from hoopgen.derive.model import Model, build
from mpmath import mp, mpf
from numpy.typing import NDArray

from hoopgen.codegen import render
from hoopgen.codegen.stamp import shared_stamp_of
from hoopgen.engine import native, numpy_backend
from hoopgen.engine.result_arrays import Layout, ResultArrays
from tests.helpers import ROOT
from tests.helpers.compiled import (
    WARNINGS,
    WIDTHS,
    load_module,
    needs_compiler,
    same_bits,
    shared_library,
)
from tests.helpers.scenes.table import TABLE

# One worker: the scene is compiled once.
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("second_scene"), needs_compiler]

EPS = float(np.finfo(float).eps)
PARAMETERS = {p.name: p.default for p in TABLE.parameters}
STATE = ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")
TOP, DOME, GROUND = range(3)
MADE, MISSED, CAPPED, SHORT, INVALID = range(5)
MAX_CONTACTS = 12
REST = PARAMETERS["marble"]
"""Height of the centre of a ball on the table."""


# The engines


@dataclass(frozen=True)
class Engines:
    """Both targets of the scene."""

    module: ModuleType
    library: native.Library
    files: Mapping[str, str]

    def values(self, parameters: Mapping[str, Any]) -> list[Any]:
        """Return the parameters in calling order, each a number or an array (n,)."""
        return [parameters[name] for name in self.module.PARAMETERS]

    def numpy(
        self, states: NDArray[np.float64], parameters: Mapping[str, Any] = PARAMETERS
    ) -> ResultArrays:
        """Simulate on NumPy."""
        out = room(self.module, len(states))
        numpy_backend.run(
            self.module,
            states,
            self.values(parameters),
            leaving=None,
            max_contacts=MAX_CONTACTS,
            out=out,
        )
        return out

    def c(
        self,
        states: NDArray[np.float64],
        parameters: Mapping[str, Any] = PARAMETERS,
        width: int = 0,
    ) -> ResultArrays:
        """Simulate in C."""
        out = room(self.module, len(states))
        self.library.run(
            states,
            self.values(parameters),
            leaving=None,
            max_contacts=MAX_CONTACTS,
            out=out,
            stop=np.zeros(1, np.int32),
            width=width,
        )
        return out


def room(module: ModuleType, shots: int) -> ResultArrays:
    """Return room for all results and the event log."""
    layout = Layout(module)
    log = layout.allocate_events(shots, MAX_CONTACTS)
    return layout.allocate(shots, layout.results).joined(log)


def events(out: ResultArrays, shot: int) -> NDArray[Any]:
    """Return the event log of a shot."""
    assert out.events is not None
    assert out.event_counts is not None
    return out.events[shot, : out.event_counts[shot]]


@pytest.fixture(scope="module")
def engines(tmp_path_factory: pytest.TempPathFactory) -> Engines:
    """Render the scene into a folder of its own and compile it there, without a warning."""
    root = tmp_path_factory.mktemp("generated")
    files = render.render_scene(TABLE)
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    library = shared_library(root / "c" / "table.c", "-O1", *WARNINGS)
    module = load_module(root / "numpy" / "table.py")
    return Engines(module, native.Library(library, module), files)


def state(**given: float) -> list[float]:
    """Return a state; what is not given is zero."""
    return [given.get(name, 0.0) for name in STATE]


def shots(count: int, seed: int) -> NDArray[np.float64]:
    """Return balls let go over the table and about it, some thrown from outside onto it."""
    rng = np.random.default_rng(seed)
    states = np.zeros((count, 9))
    states[:, 0] = rng.uniform(-0.9, 0.9, count)
    states[:, 1] = rng.uniform(-0.55, 0.55, count)
    states[:, 2] = rng.uniform(0.25, 1.2, count)
    states[:, 3:5] = rng.normal(0, 0.6, (count, 2))
    states[:, 5] = rng.normal(0, 1.5, count)
    states[:, 6:] = rng.normal(0, 20, (count, 3))
    aimed = rng.random(count) < 0.5  # at the dome
    goal = np.stack([PARAMETERS["dome_x"] + 0 * states[:, 0], 0 * states[:, 0]], axis=1)
    goal += rng.normal(0, 0.1, (count, 2))
    states[aimed, 3:5] = ((goal - states[:, :2]) / rng.uniform(0.3, 0.8, (count, 1)))[aimed]
    return states


# The slow reference


Vector = list[mpf]


def dot(left: Sequence[mpf], right: Sequence[mpf]) -> mpf:
    return sum((p * q for p, q in zip(left, right, strict=True)), mpf(0))


def cross(p: Sequence[mpf], q: Sequence[mpf]) -> Vector:
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


class Slow:
    """A ball on the table, to 40 digits.

    The dome's quartic in time is solved for all its roots at once. A contact is the impulse that
    stops the slip of a thin shell: a tangential push m dv turns it by -(3 / 2R) n × dv, and 2/5 of
    the slip are lost in velocity.
    """

    def __init__(self, parameters: Mapping[str, float]) -> None:
        self._p = {name: mpf(float(value)) for name, value in parameters.items()}
        self._centre = [self._p["dome_x"], mpf(0), self._p["dome_z"]]

    def fly(self, start: Sequence[float]) -> tuple[int, list[tuple[int, mpf]], Vector]:
        """Return the outcome, the surface and time of every event, and the last state."""
        p, last, clock = self._p, None, mpf(0)
        position, velocity, spin = ([mpf(float(c)) for c in start[k : k + 3]] for k in (0, 3, 6))
        found: list[tuple[int, mpf]] = []
        while True:
            arrivals = [
                *self._plane(TOP, p["marble"], position, velocity, last),
                *self._dome(position, velocity, last),
                *self._plane(GROUND, -p["table_height"], position, velocity, last),
            ]
            if not arrivals:
                return SHORT, found, [*position, *velocity, *spin]
            t, last = min(arrivals)
            clock += t
            found.append((last, clock))
            position, velocity = self._there(t, position, velocity)
            if last == GROUND:
                away = mp.hypot(position[0] - p["cup_x"], position[1])
                outcome = MADE if away <= p["cup_radius"] else MISSED
                return outcome, found, [*position, *velocity, *spin]
            normal = [mpf(0), mpf(0), mpf(1)]
            if last == DOME:
                offset = [c - o for c, o in zip(position, self._centre, strict=True)]
                normal = [c / mp.norm(offset) for c in offset]
            velocity, spin = self._bounce(normal, velocity, spin)
            if len(found) == MAX_CONTACTS:
                return CAPPED, found, [*position, *velocity, *spin]

    def _there(self, t: mpf, position: Vector, velocity: Vector) -> tuple[Vector, Vector]:
        g = self._p["acceleration"]
        there = [c + v * t for c, v in zip(position, velocity, strict=True)]
        there[2] -= g * t * t / 2
        return there, [velocity[0], velocity[1], velocity[2] - g * t]

    def _plane(
        self, surface: int, level: mpf, position: Vector, velocity: Vector, last: int | None
    ) -> list[tuple[mpf, int]]:
        g, up = self._p["acceleration"], velocity[2]
        height = mpf(0) if last == surface else position[2] - level
        room_left = up * up + 2 * g * height
        if room_left <= 0:
            return []
        t = (up + mp.sqrt(room_left)) / g
        x, y, _ = self._there(t, position, velocity)[0]
        on_table = abs(x) <= self._p["half_length"] and abs(y) <= self._p["half_width"]
        return [(t, surface)] if t > 0 and (surface == GROUND or on_table) else []

    def _dome(self, position: Vector, velocity: Vector, last: int | None) -> list[tuple[mpf, int]]:
        g, reach = self._p["acceleration"], self._p["dome_radius"] + self._p["marble"]
        offset = [c - o for c, o in zip(position, self._centre, strict=True)]
        quartic = [
            g * g / 4,
            -g * velocity[2],
            dot(velocity, velocity) - g * offset[2],
            2 * dot(offset, velocity),
            dot(offset, offset) - reach * reach,
        ]
        if last == DOME:
            quartic.pop()  # zero: t divides the rest
        roots = mp.polyroots(quartic, maxsteps=500, extraprec=200)
        slopes = [(r.real, self._slope(quartic, r.real, last)) for r in roots if self._real(r)]
        return [(t, DOME) for t, slope in slopes if t > 0 and slope < 0]

    @staticmethod
    def _real(root: Any) -> bool:
        return abs(mp.im(root)) < mpf(10) ** -25 * (1 + abs(root))

    @staticmethod
    def _slope(coefficients: Vector, t: mpf, last: int | None) -> mpf:
        value, slope = mp.polyval(coefficients, t, derivative=1)
        return value + t * slope if last == DOME else slope

    def _bounce(self, normal: Vector, velocity: Vector, spin: Vector) -> tuple[Vector, Vector]:
        radius, e = self._p["marble"], self._p["bounce"]
        arrival = dot(velocity, normal)
        slip = [
            v + s for v, s in zip(velocity, cross(spin, [-radius * n for n in normal]), strict=True)
        ]
        slip = [s - arrival * n for s, n in zip(slip, normal, strict=True)]
        push = [-2 * s / 5 for s in slip]
        after = [
            v + q - (1 + e) * arrival * n for v, q, n in zip(velocity, push, normal, strict=True)
        ]
        turn = cross(normal, push)
        return after, [w - 3 * c / (2 * radius) for w, c in zip(spin, turn, strict=True)]


# The pipeline


def test_a_file_that_two_scenes_have_is_the_same_for_both(engines: Engines) -> None:
    same = {name for name in engines.files if (ROOT / "generated" / name).exists()}
    assert same == {file for file in render.outputs().values() if "{scene}" not in file}
    for template, name in render.outputs().items():
        if name in same:  # but for the note that says who made it
            ours, own = (shared_stamp_of(template, scene)("   ") for scene in (scenes.HOOP, TABLE))
            assert own in engines.files[name]
            text = (ROOT / "generated" / name).read_text(encoding="utf-8")
            assert text == engines.files[name].replace(own, ours)


def test_every_file_is_named_after_the_scene_and_says_so(engines: Engines) -> None:
    for name, text in engines.files.items():
        assert ("scene table, derivation" in text) == ("table" in name), name
        assert "hoop" not in text.replace("hoopgen", "").replace("HOOPGEN", ""), name


def test_the_scene_has_kernels_for_its_own_surfaces_only() -> None:
    model: Model = build(TABLE)
    assert [s.surface.name for s in model.surfaces] == ["top", "dome"]
    assert not any("ring" in kernel.name for kernel in model.kernels)


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("shared", [True, False], ids=["shared parameters", "own parameters"])
def test_both_engines_give_the_same_bits(engines: Engines, width: int, shared: bool) -> None:
    """Shots are valid and invalid ones, at all vector widths."""
    states = shots(1000, seed=1)
    states[::50, 4] = np.nan
    states[1::50, 2] = 0.0  # inside the table
    states[2::50, :3] = PARAMETERS["dome_x"], 0.0, 0.1  # inside the dome
    states[3::50, 2] = -1.0  # under the ground already
    states[3::50, 5] = -1.0
    rng = np.random.default_rng(2)
    own = {n: v * rng.uniform(0.9, 1.1, len(states)) for n, v in PARAMETERS.items()}
    parameters = PARAMETERS if shared else own
    numpy = engines.numpy(states, parameters)
    try:
        c = engines.c(states, parameters, width)
    except ValueError:
        pytest.skip("this processor does not have the width")
    assert np.array_equal(numpy.outcome, c.outcome)
    assert set(range(5)) == set(np.unique(c.outcome))
    for name in (*Layout(engines.module).results, "event_counts"):
        assert same_bits(getattr(numpy, name), getattr(c, name)).all(), name
    for shot in range(len(states)):
        for name in ("shot", "surface", "time", "before", "after", "kind"):
            left, right = events(numpy, shot)[name], events(c, shot)[name]
            assert same_bits(left, right).all(), name


# By hand


def test_a_ball_dropped_on_the_table_bounces_when_it_must(engines: Engines) -> None:
    """First after sqrt(2 h / g), then every 2 e^k v / g; all of it vertical.

    Each flight adds a few roundings of its own time: 8 units in the last place of the whole.
    """
    height, x, y = 0.6, -0.6, 0.2
    out = engines.c(np.array([state(x=x, y=y, z=REST + height)]))
    log = events(out, 0)
    with mp.workdps(40):
        g, e = mpf(PARAMETERS["acceleration"]), mpf(PARAMETERS["bounce"])
        fallen = mpf(REST + height) - mpf(REST)
        clock, speed = mp.sqrt(2 * fallen / g), mp.sqrt(2 * fallen * g)
        for k, event in enumerate(log):
            assert event["surface"] == TOP
            assert abs(event["time"] - clock) <= 8 * (k + 1) * EPS * clock
            assert abs(event["before"][5] + speed) <= 8 * (k + 1) * EPS * speed
            assert abs(event["after"][5] - e * speed) <= 8 * (k + 1) * EPS * speed
            assert list(event["after"][[0, 1, 2, 3, 4, 6, 7, 8]]) == [x, y, REST, 0, 0, 0, 0, 0]
            speed *= e
            clock += 2 * speed / g
    assert out.outcome is not None
    assert out.outcome[0] == CAPPED
    assert len(log) == MAX_CONTACTS


def test_a_ball_falling_on_the_dome_hits_where_and_when_it_must(engines: Engines) -> None:
    """A ball that falls at b beside the dome's axis meets it sqrt(r² - b²) over its centre.

    There the normal leans by asin(b / r); a ball without spin keeps e of its normal velocity and
    3/5 of the rest, and turns with the velocity that it keeps along the dome.
    """
    reach, beside, start = PARAMETERS["dome_radius"] + REST, 0.09, 0.9
    out = engines.c(np.array([state(x=PARAMETERS["dome_x"] + beside, z=start)]))
    event = events(out, 0)[0]
    assert event["surface"] == DOME
    with mp.workdps(40):
        g, e = mpf(PARAMETERS["acceleration"]), mpf(PARAMETERS["bounce"])
        b = mpf(PARAMETERS["dome_x"] + beside) - mpf(PARAMETERS["dome_x"])
        r = mpf(PARAMETERS["dome_radius"]) + mpf(REST)
        above = mp.sqrt(r * r - b * b)
        top = mpf(PARAMETERS["dome_z"]) + above
        time = mp.sqrt(2 * (mpf(start) - top) / g)
        sine, cosine = b / r, above / r
        down = g * time
        normal, along = e * down * cosine, mpf(3) / 5 * down * sine
        # The velocity along the dome points down it: (cosine, -sine) in x and z.
        after = [normal * sine + along * cosine, normal * cosine - along * sine]
        # The time is off by its own rounding and by that of the gap, over its rate.
        allowed = 16 * EPS * (1 + 1 / (down * cosine))
        assert abs(event["time"] - time) <= allowed
        assert abs(event["after"][2] - top) <= allowed * down
        assert abs(event["after"][3] - after[0]) <= allowed * (g + down / reach)
        assert abs(event["after"][5] - after[1]) <= allowed * (g + down / reach)
        assert abs(event["after"][7] - along / mpf(REST)) <= allowed * (g + down / reach) / REST
    assert list(event["after"][[1, 4, 6, 8]]) == [0, 0, 0, 0]


def test_a_ball_beside_the_table_meets_only_the_ground(engines: Engines) -> None:
    """And is in the cup where its centre is over it, bounds included."""
    side = PARAMETERS["half_length"]
    beyond = np.nextafter(side, np.inf)
    states = [
        state(x=side + 0.1, z=0.5),
        state(x=PARAMETERS["cup_x"] + PARAMETERS["cup_radius"] + 0.01, z=0.5),
        state(x=beyond, z=0.5),
        state(x=side, z=0.5),
    ]
    out = engines.c(np.array(states))
    assert [events(out, k)["surface"][0] for k in range(4)] == [GROUND, GROUND, GROUND, TOP]
    assert out.outcome is not None
    assert out.uncertain is not None
    assert list(out.outcome[:2]) == [MADE, MISSED]
    assert list(out.uncertain[:2]) == [False, False]
    assert list(out.uncertain[2:]) == [True, True], "within rounding of the table's edge"
    drop = 0.5 + PARAMETERS["table_height"]
    time = np.sqrt(2 * drop / PARAMETERS["acceleration"])
    assert out.time is not None
    assert abs(out.time[0] - time) <= 4 * EPS * time


# Against the slow reference


def test_a_random_batch_is_that_of_the_slow_reference(engines: Engines) -> None:
    """The same events, at the same times and in the same last state within the stated bounds.

    Shots that the engine calls uncertain are few, and may differ.
    """
    states = shots(300, seed=3)
    out = engines.c(states)
    assert out.outcome is not None
    assert out.uncertain is not None
    assert out.time_error is not None
    assert out.state_error is not None
    assert out.state is not None
    slow = Slow(PARAMETERS)
    valid = out.outcome != INVALID
    hits = np.zeros(3, np.int64)
    for shot in np.flatnonzero(valid & ~out.uncertain):
        log = events(out, shot)
        with mp.workdps(40):
            outcome, expected, last = slow.fly(states[shot])
            assert list(log["surface"]) == [surface for surface, _ in expected], shot
            assert out.outcome[shot] == outcome, shot
            for event, (surface, time) in zip(log, expected, strict=True):
                assert abs(event["time"] - time) <= out.time_error[shot], shot
                hits[surface] += 1
            allowed = np.repeat(out.state_error[shot], 3)
            for found, value, error in zip(out.state[shot], last, allowed, strict=True):
                assert abs(found - value) <= error, shot
    assert out.uncertain.sum() < 0.02 * len(states)
    assert valid.mean() > 0.9
    assert hits.min() > 50
    assert {MADE, MISSED, CAPPED} <= set(out.outcome)
