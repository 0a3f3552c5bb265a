"""Bodies of one kind share their kernels: the same shots, and sources that hardly grow."""

from __future__ import annotations

import inspect
from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive import model
from hoopgen.derive.events import grouping
from hoopgen.derive.ir.event_tree import Call, ForEach, check, live_before, needed, reads, walk
from hoopgen.derive.ir.kernel import decision
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.surfaces import Sphere as Ball
from hoopgen.derive.symbolic.isomorphism import Isomorphism, isomorphisms
from hoopgen.derive.symbolic.symbols import ParameterSymbol
from numpy.typing import NDArray

import hoopgen
from hoopgen import Shots
from hoopgen.codegen.render import render_scene
from hoopgen.scene import Box, Cylinder, End, Parameter, Plane, Scene, Sphere, Torus
from tests.helpers.compiled import needs_compiler
from tests.helpers.effort import occurrences, trials
from tests.scene.test_example_scenes import numpy_engine

# One worker: what is derived once serves them all.
pytestmark = pytest.mark.xdist_group("kinds")

MIXED = Scene(
    "mixed",
    parameters=[
        Parameter("ball", 0.05),
        Parameter("size", 0.2),
        Parameter("dull", 0.5, "1"),
    ],
    ball_radius="ball",
    gravity=9.81,
    restitution=0.8,
    bodies=[
        Sphere("a", radius="size", centre=(-1.2, 0, 0.2), restitution="dull"),
        Sphere("b", radius=0.14, centre=(-0.6, 0.1, 0.2), restitution=0.3),
        Sphere("c", radius="size/2", centre=(0.6, 0.2, 0.2)),
        Cylinder("d", radius=0.06, centre=(-1, 0.3, -0.4), axis="y", span=(-1, 0.5)),
        Cylinder("e", radius=0.08, centre=(0.5, 0.3, -0.4), axis="y", span=(-2, 0.6)),
        Box("f", size=(0.2, 0.3, 0.1), centre=(-1, -0.6, -0.5)),
        Box("g", size=(0.3, 0.3, 0.2), centre=(0.7, -0.6, -0.6), restitution=0.6),
        Plane("h", at=-1, within=["x + 1", "-2 - x"]),
        Plane("i", at=-0.8, within=["x - 2", "0.5 - x"]),
        Torus("j", radius=0.3, wire=0.02, centre=(-0.5, 0.5, 0.6)),
        Torus("k", radius=0.25, wire=0.03, centre=(0.5, 0.5, 0.7)),
    ],
    ends={"floor": End(at=-2)},
)
MOST = 6
RESULTS = ("outcome", "contacts", "counts", "first", "time", "state", "uncertain")


def pins(count: int) -> Scene:
    """Return spheres in a row, all of other sizes."""
    return Scene(
        "pins",
        parameters=[Parameter("scale", 1.0, "1")],
        ball_radius=0.1,
        gravity=9.81,
        restitution=0.7,
        bodies=[
            Sphere(
                f"pin{k}",
                radius=f"scale/{7 + k}",
                centre=(f"{k}*scale/2 + 1/64", f"scale/{k + 9}", f"scale/{k + 3}"),
            )
            for k in range(count)
        ],
        ends={"down": End(at=-1)},
    )


def thrown(count: int) -> NDArray[np.float64]:
    rng = np.random.default_rng(11)
    made = rng.normal(0, (1, 0.5, 0.2, 1, 1, 1, 9, 9, 9), (count, 9))
    made[:, 2] += 1.2
    return made


def sizes(count: int) -> dict[str, NDArray[np.float64]]:
    rng = np.random.default_rng(12)
    return {name: rng.uniform(0.8, 1.2, count) * MIXED.defaults[name] for name in ("size", "dull")}


def assert_same(one: Shots, other: Shots) -> None:
    for name in RESULTS:
        assert np.array_equal(getattr(one, name), getattr(other, name), equal_nan=True), name
    assert (one.events == other.events).all()


@cache
def sources(count: int) -> dict[str, str]:
    return render_scene(pins(count).derive(), page=False)


def symbols(*names: str) -> list[sp.Symbol]:
    return [ParameterSymbol(name, positive=True) for name in names]


def test_bodies_are_of_one_kind_if_their_symbols_alone_differ() -> None:
    ball, a, b, c, d = symbols("k_ball", "a", "b", "z", "d")
    zero, one = sp.Integer(0), sp.Integer(1)
    balls = [
        Ball("one", (a, zero, b), a + ball),
        Ball("other", (c, zero, d), c + ball),
        Ball("both", (d, zero, d), d + ball),
        Ball("elsewhere", (c, one, d), c + ball),
        Ball("crossed", (c, zero, d), d + ball),
        Ball("shared", (ball, zero, d), ball + ball),
        Ball("turned", (c, zero, d), c + ball, inward=True),
    ]
    found = isomorphisms(balls, {ball})
    assert found[:3] == (
        Isomorphism(0, {}),
        Isomorphism(0, {a: c, b: d}),
        Isomorphism(0, {a: d, b: d}),
    )
    assert [like.first for like in found[3:]] == [3, 4, 5, 6]


def test_terms_of_one_form_are_told_apart_by_what_their_symbols_are_elsewhere() -> None:
    """Alone they stand in the order of the symbols' names, which means nothing."""
    a, b, c, d = symbols("a", "b", "c", "d")
    zero = sp.Integer(0)
    balls = [
        Ball("one", (a, b, zero), a + b),
        Ball("crossed", (d, c, zero), c + d),
        Ball("other", (d, c, zero), c + c * d),
    ]
    found = isomorphisms(balls, ())
    assert found == (Isomorphism(0, {}), Isomorphism(0, {a: d, b: c}), Isomorphism(2, {}))


def test_what_is_assumed_of_symbols_counts() -> None:
    (a,) = symbols("a")
    any_sign = ParameterSymbol("b", real=True)
    zero = sp.Integer(0)
    made = [Ball("one", (a, zero, zero), a), Ball("other", (any_sign, zero, zero), a)]
    assert [like.first for like in isomorphisms(made, ())] == [0, 1]


def test_the_hoop_has_no_two_bodies_of_one_kind() -> None:
    """Nor does anything of a table cost it."""
    assert [like.first for like in isomorphisms(HOOP.surfaces, ())] == [0, 1, 2]


def test_a_table_is_read_by_its_rows() -> None:
    own, other, total = sp.symbols("own other total", real=True)
    adding = Call(decision("adding", {"total": total + own}, ""))
    naming = Call(decision("naming", {"name": other}, ""))
    rows = (("a", 1.0), ("b", 2.0))
    each = ForEach(("own", "other"), rows, (adding, naming))
    assert reads([each]) == live_before([each], []) == {"a", "b", "total"}
    assert live_before([each], ["c"]) == {"a", "b", "c", "total"}
    assert needed([each], ["c"]) == ()
    (kept,) = needed([each], ["total"])
    assert kept == ForEach(("own",), (("a",), ("b",)), kept.body)  # type: ignore[union-attr]
    assert [n.kernel.name for n in walk([kept]) if isinstance(n, Call)] == ["adding"]
    assert check([each], ["a", "b", "total"]) == {"a", "b", "total"}
    with pytest.raises(ValueError, match="unknown: b"):
        check([each], ["a", "total"])
    with pytest.raises(ValueError, match="own is both a variable and a number"):
        ForEach(("own",), (("a",), (1.0,)), (adding,))


@pytest.mark.slow
def test_kernels_are_derived_once_for_a_kind() -> None:
    few, many = (model.build(pins(count).derive()) for count in (2, 5))
    assert {k.name for k in few.kernels} == {k.name for k in many.kernels}
    assert [len(kind) for kind in many.kinds] == [5]


@pytest.mark.slow
def test_sources_hardly_grow_with_bodies_of_one_kind() -> None:
    """A body adds its name and the numbers of its parameters."""
    few, many = (
        sum(len(text) for name, text in sources(count).items() if name.startswith("c/"))
        for count in (20, 36)
    )
    assert (many - few) / 16 < 1_000


def test_the_law_of_a_contact_is_evaluated_once_whichever_body_it_is_with() -> None:
    """Each body adds what its sizes need, which is less than the whole law."""
    scene = Scene(
        "dulls",
        ball_radius=0.1,
        gravity=9.81,
        bodies=[
            Sphere(f"dull{k}", radius=0.1, centre=(k, 0, 0), restitution=0.5 + k / 8)
            for k in range(3)
        ],
        ends={"down": End(at=-1)},
    )
    stage = model.build(scene.derive()).loop.stages["resolve"]
    tables = [node for node in walk(stage) if isinstance(node, ForEach)]
    of_each = [n.kernel.name for table in tables for n in walk(table.body) if isinstance(n, Call)]
    of_all = [node.kernel.name for node in walk(stage) if isinstance(node, Call)]
    assert any(name.endswith("impact_taken") for name in of_each)
    laws = [name for name in of_all if name.endswith("impact")]
    assert len(laws) == len(set(laws)) == 2  # that of the motion, and that of its errors
    assert not any(name.endswith("impact") for name in of_each)


def unshared(things: Sequence[object], shared: object) -> tuple[Isomorphism, ...]:
    return tuple(Isomorphism(k, {}) for k in range(len(things)))


@pytest.mark.parametrize("varying", [False, True], ids=["usual sizes", "sizes of each shot"])
@pytest.mark.slow
def test_shared_kernels_fly_the_same_shots(
    varying: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Shared kernels give the same bits of every result as those of each body's own."""
    monkeypatch.setattr(grouping, "MIN_GROUPED_BODIES", 2)
    states = thrown(800)
    given = sizes(len(states)) if varying else {}
    one = numpy_engine(MIXED, tmp_path)
    (tmp_path / "own").mkdir()
    monkeypatch.setattr(model, "isomorphisms", unshared)
    other = numpy_engine(MIXED, tmp_path / "own")
    assert hasattr(one.kernels, "b_near_any")
    assert not hasattr(other.kernels, "b_near")
    shots = [
        engine.simulate(states, given, max_contacts=MOST, backend="numpy", record=True)
        for engine in (one, other)
    ]
    assert (shots[0].counts.sum(axis=0) > 0).all()
    assert_same(*shots)


@needs_compiler
@pytest.mark.slow
def test_c_and_numpy_have_the_same_bits_with_sizes_of_each_shot() -> None:
    engine = hoopgen.compile(pins(grouping.MIN_GROUPED_BODIES))
    assert engine.backend == "c"
    assert "_boxes" in engine.source("c")["pins_loop.h"]
    states = thrown(3000)
    states[:, 0] += np.random.default_rng(2).uniform(0, 9, len(states))
    states[::20, 2] -= 1
    scale = np.random.default_rng(3).uniform(0.7, 1.3, len(states))
    for given in ({}, {"scale": scale}):
        made = [
            engine.simulate(states, given, max_contacts=MOST, backend=backend, record=True)
            for backend in ("c", "numpy")
        ]
        assert (made[0].counts.sum(axis=0) > 0).all()
        assert 0 < (made[0].outcome == engine.outcomes["INVALID"]).mean() < 0.2
        assert_same(*made)


@pytest.mark.slow
def test_each_body_has_its_normal() -> None:
    """Pictures of a contact find the normal by the body's name."""
    place: dict[str, object] = {}
    exec(sources(4)["numpy/pins.py"], place)
    first, last = place["pin0_normal"], place["pin3_normal"]
    assert callable(first)
    assert callable(last)
    asked = list(inspect.signature(last).parameters)
    assert [name.replace("pin3", "pin0") for name in asked] == list(
        inspect.signature(first).parameters
    )
    values = np.arange(1.0, 1 + len(asked))
    assert last(*values) == first(*values)


@pytest.mark.slow
def test_a_scene_with_groups_is_explained() -> None:
    page = pins(grouping.MIN_GROUPED_BODIES).explain()
    for part in ("near_any", "box", "start"):
        assert f"pin0_{part}" in page


def exactly(values: NDArray[np.float64]) -> list[Fraction]:
    return [Fraction(float(value)) for value in values]


@pytest.mark.slow
def test_a_body_that_is_called_far_is_not_within_reach() -> None:
    """The true ball is followed in exact arithmetic, at many times up to the horizon."""
    place: dict[str, object] = {}
    exec(sources(4)["numpy/pins.py"], place)
    swept, near = place["swept"], place["pin0_near"]
    assert callable(swept)
    assert callable(near)
    arguments: Any = place["ARGUMENTS"]
    rng = np.random.default_rng(4)
    far = 0
    for _ in range(trials(400)):
        state = rng.normal(0, 1, 6) * 10 ** rng.uniform(-2, 1)
        centre = rng.normal(0, 1, 3) * 10 ** rng.uniform(-1, 1)
        radius, ball, gravity, horizon = 10 ** rng.uniform(-2, 0.5, 4)
        errors = 10 ** rng.uniform(-16, -3, 2) * rng.integers(0, 2, 2)
        known = {
            **dict(zip(("x", "y", "z", "vx", "vy", "vz"), state, strict=True)),
            "horizon": horizon,
            "extent": np.abs(state[:3]).sum(),
            "speed": np.abs(state[3:]).sum(),
            "position_error": errors[0],
            "velocity_error": errors[1],
            "pad": 1e-3,
            "earliest_delay": 0.0,
            "p_gravity": gravity,
            "p_ball_radius": ball,
            "p_pin0_radius": radius,
            **{f"p_pin0_centre_{axis}": c for axis, c in zip("xyz", centre, strict=True)},
        }
        box = swept(*(known[name] for name in arguments["swept"]))
        known |= dict(zip(place["OUTPUTS"]["swept"], box, strict=True))  # type: ignore[index]
        asked = [known[name] for name in arguments["pin0_near"]]
        late = known | {"pad": 0.0, "earliest_delay": 1e-9}
        endless = swept(*(late[name] for name in arguments["swept"]))
        late |= dict(zip(place["OUTPUTS"]["swept"], endless, strict=True))  # type: ignore[index]
        assert near(*(late[name] for name in arguments["pin0_near"]))[0]
        if near(*asked)[0]:
            continue
        far += 1
        start, move, middle = exactly(state[:3]), exactly(state[3:]), exactly(centre)
        shift, reach = exactly(errors), Fraction(float(radius)) + Fraction(float(ball))
        g = Fraction(float(gravity))
        apart = [True] * 3
        for k in range(33):
            time = Fraction(float(horizon)) * k / 32
            for axis in range(3):
                there = start[axis] + move[axis] * time - (g * time**2 / 2 if axis == 2 else 0)
                away = abs(there - middle[axis]) - shift[0] - shift[1] * time
                apart[axis] &= away > reach
        assert any(apart)
    assert occurrences(100) < far < trials(400) - occurrences(50)
