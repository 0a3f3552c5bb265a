"""Arcs of surfaces of revolution in the engines, against the judge, an integrator and spheres."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.surfaces import RevolvedArc
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.derive.symbolic.symbols import POSITION
from numpy.typing import NDArray

pytest.importorskip("flint")

import hoopgen
from hoopgen.scene import End, Parameter, Revolution, Scene, Sphere, Torus
from hoopgen.simulation.engine import Engine
from hoopgen.viewer.page import _contact_points as contact_points
from tests.helpers.derived import engine_of
from tests.helpers.effort import exceptions, occurrences, trials
from tests.helpers.slow_scene import Slow
from tests.scene.test_arc_profiles import HALF, arc, on_circle
from tests.scene.test_oblique_bodies import aimed_at

# One worker: each scene is derived once.
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("arcs")]

Floats = NDArray[np.float64]

BALL, GRAVITY, MOST = 0.06, 9.81, 5
CLAIMS = ("outcome", "uncertain", "counts", "time", "state", "time_error", "state_error")


def scene(name: str, *bodies: Any, **given: Any) -> Scene:
    usual: dict[str, Any] = {
        "ball_radius": BALL,
        "gravity": GRAVITY,
        "restitution": 0.75,
        "ends": {"gone": End(at=-3)},
    }
    return Scene(name, bodies=bodies, **(usual | given))


def curved(centre: Sequence[float], radius: float, *degrees: float) -> list[Any]:
    """Return the profile of an arc between two angles, through the one in the middle."""
    low, high = degrees
    first, middle, last = on_circle(centre, radius, low, (low + high) / 2, high)
    return [first, arc(middle, last)]


RADIUS = 0.35
BOWL: list[Any] = [(0, -RADIUS), arc((RADIUS * HALF, -RADIUS * HALF), (RADIUS, 0))]
# A cap, then a flare without a corner between them.
BELL: list[Any] = [
    (0, 0.3),
    arc((0.12 * HALF, 0.18 + 0.12 * HALF), (0.12, 0.18)),
    curved((0.37, 0.18), 0.25, 180, 255)[1],
]
# A flat end, a round shoulder, a groove that is narrower than the ball, and a neck.
BOTTLE: list[Any] = [
    (0, -0.3),
    (0.2, -0.3),
    (0.2, 0),
    arc((0.1 + 0.1 * HALF, 0.1 * HALF), (0.1, 0.1)),
    arc((0.1 - 0.02 * HALF, 0.12 - 0.02 * HALF), (0.08, 0.12)),
    (0.08, 0.25),
]
# Arcs that each shot has its own of: one beyond the axis, and one of more than half a circle.
VASE: list[Any] = [
    (0.05, -0.2),
    arc(("wide", 0), (0.05, 0.2)),
    arc(("0.1 + wide", 0.35), (0.05, 0.5)),
]
AXIS = ("way_1", "way_2", "way_3")

SCENES = {
    "bowl": scene("round_bowl", Revolution("bowl", profile=BOWL)),
    "bell": scene("round_bell", Revolution("bell", profile=BELL)),
    "bottle": scene("round_bottle", Revolution("bottle", profile=BOTTLE)),
    # The centre is beyond the axis: the wall has tips on it.
    "lemon": scene("lemon", Revolution("lemon", profile=[(0, -0.28), arc((0.2, 0), (0, 0.28))])),
    # The circle of the ball's centres crosses the axis, and the arc is three quarters of a circle.
    "crescent": scene("crescent", Revolution("crescent", profile=curved((0.16, 0), 0.13, 70, 340))),
    # The hole is narrower than the ball.
    "throat": scene(
        "throat", Revolution("throat", profile=curved((0.25, 0), 0.22, 250, 110), axis="-x")
    ),
    "globe": scene("globe", Revolution("globe", profile=[(0, -0.3), arc((0.3, 0), (0, 0.3))])),
    # An arc to the other side of its ends may have its centre on the same side as this one.
    "band": scene(
        "band",
        Revolution("band", profile=[(1, -0.1), arc(("wide", 0), (1, 0.1))]),
        parameters=[Parameter("wide", 1.05)],
    ),
    "leaning": scene(
        "leaning_vase",
        Revolution("vase", profile=VASE, axis=AXIS),
        parameters=[
            Parameter("wide", 0.15),
            *(Parameter(n, v, "1", sign="any") for n, v in zip(AXIS, (0.1, 0.2, 1), strict=True)),
        ],
    ),
}


@pytest.fixture(scope="module")
def engine(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Engine]:
    """Return the function from the name of a scene to its engine, printed once."""
    return cache(lambda which: engine_of(SCENES[which], tmp_path_factory.mktemp(which)))


Engines = Callable[[str], Engine]


def shots_for(made: Scene, count: int, seed: int) -> tuple[Floats, dict[str, Any]]:
    """Return shots that fly near the origin, with an axis at random and a width."""
    chance = np.random.default_rng(seed)
    values: dict[str, Any] = {
        name: chance.normal(0, 1, count) for name in made.defaults if name != "wide"
    }
    if "wide" in made.defaults:
        values["wide"] = chance.uniform(0.115, 0.17, count)
    return aimed_at([(0.0, 0.0, 0.0)], count, seed), values


def check_proofs(engine: Engine, made: Scene, count: int, seed: int = 1) -> hoopgen.Shots:
    """Compare shots with the judge."""
    states, values = shots_for(made, count, seed)
    shots = engine.simulate(states, values, max_contacts=MOST, record=True, fields=CLAIMS)
    proofs = hoopgen.certify(states, values, scene=engine, max_contacts=MOST, processes=1)
    assert proofs.decided.all()
    assert proofs.agrees(shots).all()
    valid = shots.outcome != engine.outcomes["INVALID"]
    assert valid.mean() > 0.8
    assert np.sum(shots.uncertain & valid) < exceptions(0.002, count) + 2
    assert shots.counts[valid].sum() > occurrences(count // 2)
    sure = valid & ~shots.uncertain
    away = np.abs(shots.state - proofs.state).reshape(-1, 3, 3).max(axis=2)
    assert (away <= shots.state_error + proofs.state_error)[sure].all()
    return shots


@pytest.mark.parametrize("which", ["bowl", "bell", "bottle"])
def test_round_walls_give_what_is_proved(which: str, engine: Engines) -> None:
    """The sequences proved, or flagged."""
    check_proofs(engine(which), SCENES[which], trials(1500, at_least=600))


@pytest.mark.slow
@pytest.mark.parametrize("which", ["lemon", "crescent", "throat", "globe", "leaning"])
def test_arcs_about_any_centre_and_axis_give_what_is_proved(which: str, engine: Engines) -> None:
    """The sequences proved, or flagged."""
    check_proofs(engine(which), SCENES[which], trials(1500, at_least=600))


def check_integrator(engine: Engine, made: Scene, count: int = 120) -> None:
    """Compare contacts with those of an integrator that knows no pieces and no edges.

    It asks for the nearest point of the whole line.
    """
    states, values = shots_for(made, count, 2)
    shots = engine.simulate(states, values, max_contacts=3, record=True, time_limit=2.0)
    compared = 0
    for row in np.flatnonzero((shots.outcome != engine.outcomes["INVALID"]) & ~shots.uncertain):
        slow = Slow(made, {name: float(value[row]) for name, value in values.items()})
        flown = slow.fly(states[row], 3, 2.0)
        if flown.close:
            continue
        events = shots.events[(shots.events["shot"] == row) & (shots.events["surface"] == 0)]
        times = [time for _, time in flown.contacts]
        assert len(events) == len(times), row
        assert np.allclose(events["time"], times, rtol=0, atol=1e-8), row
        compared += len(times)
    assert compared > count // 4


@pytest.mark.parametrize("which", ["bowl", "bell", "bottle"])
def test_round_walls_are_met_where_an_independent_integrator_meets_them(
    which: str, engine: Engines
) -> None:
    check_integrator(engine(which), SCENES[which])


@pytest.mark.slow
@pytest.mark.parametrize("which", ["lemon", "crescent", "throat", "globe", "leaning"])
def test_an_independent_integrator_meets_arcs_about_any_centre_and_axis(
    which: str, engine: Engines
) -> None:
    check_integrator(engine(which), SCENES[which])


def test_a_round_bowl_is_a_sphere_with_a_rim(engine: Engines, tmp_path: Path) -> None:
    """The same contacts, and states within the errors of both."""
    single = scene(
        "bowl_of_bodies",
        Sphere("inner", radius=RADIUS, inside=True, within=["z"]),
        Sphere("outer", radius=RADIUS, within=["z"]),
        Torus("rim", radius=RADIUS),
    )
    count = trials(2000, at_least=1000)
    states, _ = shots_for(SCENES["bowl"], count, 6)
    one, other = (
        made.simulate(states, max_contacts=MOST, fields=CLAIMS)
        for made in (engine("bowl"), engine_of(single, tmp_path))
    )
    # Outside a sphere is solid: who begins inside is INVALID there.
    met = (one.counts.sum(axis=1) > 0) & (other.counts.sum(axis=1) > 0)
    sure = met & ~one.uncertain & ~other.uncertain
    assert sure.mean() > 0.3
    assert (one.counts[:, 0] == other.counts.sum(axis=1))[sure].all()
    away = np.abs(one.state - other.state).reshape(-1, 3, 3).max(axis=2)
    assert (away <= one.state_error + other.state_error)[sure].all()
    assert (np.abs(one.time - other.time) <= one.time_error + other.time_error)[sure].all()
    assert (other.counts[sure].sum(axis=0) > occurrences(count // 50)).all()


def test_short_lines_tend_to_the_arc(engine: Engines) -> None:
    """The times of first contacts: twice as many lines are four times as near to the arc."""
    made = SCENES["bell"]
    states, _ = shots_for(made, 40, 3)
    shots = engine("bell").simulate(states, max_contacts=1, time_limit=2.0)
    rows = np.flatnonzero((shots.outcome == engine("bell").outcomes["CAPPED"]) & ~shots.uncertain)
    assert len(rows) > 8
    away = []
    for pieces in (12, 24, 48):
        slow = Slow(scene("lines", Revolution("bell", profile=cornered(BELL, pieces // 2))))
        times = [slow.fly(states[row], 1, 2.0).time for row in rows[:16]]
        away.append(np.abs(times - shots.time[rows[:16]]).mean())
    assert away[2] < 1e-3
    assert away[0] > 3 * away[1] > 9 * away[2]


def cornered(profile: Sequence[Any], count: int) -> list[tuple[float, float]]:
    """Return a profile with so many straight pieces in place of each arc."""
    found = [profile[0]]
    for piece in Slow(scene("whole", Revolution("bell", profile=profile)))._pieces(
        Revolution("bell", profile=profile)
    ):
        angles = piece.first + piece.turn * piece.sweep * np.arange(1, count) / count
        points = piece.centre + piece.radius * np.stack([np.cos(angles), np.sin(angles)], -1)
        found += [*map(tuple, points.tolist()), tuple(piece.end.tolist())]
    return found


INVALID = {
    "leaning": (
        (0.15, 0.04, 0.165, 0.05, 0.3, 0.235, 0.09, -0.2),
        "ok, no, ok, no, no, no, no, no",
    ),
    "band": ((1.05, 0.7, 1.02), "ok, no, ok"),
}
"""Widths of arcs, and which are allowed."""


@pytest.mark.parametrize("which", INVALID)
def test_shots_with_another_kind_of_arc_are_invalid_and_the_others_are_not(
    which: str, engine: Engines
) -> None:
    check_invalid(engine(which), which)


def check_invalid(engine: Engine, which: str) -> None:
    """Try arcs that would need other faces.

    They bend to the other side, are longer or shorter than half a circle, or have their centre on
    the other side of the axis.
    """
    widths, allowed = INVALID[which]
    states, values = shots_for(SCENES[which], len(widths), 9)
    states[:] = 0.0
    states[:, 2] = 2.0
    values["wide"] = np.array(widths)
    shots = engine.simulate(states, values, max_contacts=1)
    invalid = shots.outcome == engine.outcomes["INVALID"]
    assert invalid.tolist() == [one == "no" for one in allowed.split(", ")]


@pytest.mark.slow
@pytest.mark.parametrize("which", ["globe", "lemon"])
def test_a_ball_may_begin_on_either_side_of_a_closed_wall(which: str, engine: Engines) -> None:
    check_sides(engine(which), SCENES[which])


def check_sides(engine: Engine, made: Scene) -> None:
    """Compare starts with the distance from the wall; who begins inside stays there.

    After some more bounces the ball is wedged in the tip of a lemon, which is uncertain.
    """
    states = np.zeros((300, 9))
    states[:, :3] = np.random.default_rng(8).uniform(-0.3, 0.3, (300, 3))
    states[::3, :3] /= 4
    fields = ("outcome", "uncertain")
    shots = engine.simulate(states, max_contacts=4, time_limit=3.0, fields=fields)
    slow = Slow(made)
    away = np.array([slow.overlap(state[:3])[0] for state in states])
    valid = shots.outcome != engine.outcomes["INVALID"]
    clear = np.abs(away) > 1e-7
    assert (valid == (away > 0))[clear].all()
    inside = valid & (np.linalg.norm(states[:, :2], axis=1) < 0.1) & (np.abs(states[:, 2]) < 0.1)
    assert inside.sum() > 10
    assert shots.uncertain[inside].mean() < 0.1
    inside &= ~shots.uncertain
    assert (shots.outcome[inside] != engine.outcomes["GONE"]).all()


@cache
def in_air() -> Scene:
    """Return the bell in air."""
    return scene("bell_in_air", Revolution("bell", profile=BELL), air=True)


@pytest.mark.slow
def test_arcs_in_air_give_what_is_proved_and_without_air_the_same(
    engine: Engines, tmp_path: Path
) -> None:
    flown = engine_of(in_air(), tmp_path)
    states, _ = shots_for(SCENES["bell"], 200, 4)
    thin, none = (
        one.simulate(states, values, max_contacts=3)
        for one, values in ((flown, {"air_density": 1e-9}), (engine("bell"), None))
    )
    sure = ~thin.uncertain & ~none.uncertain
    assert sure.mean() > 0.95
    assert (thin.counts == none.counts)[sure].all()
    np.testing.assert_allclose(thin.time[sure], none.time[sure], rtol=0, atol=1e-8)
    shots = flown.simulate(states, max_contacts=2, record=True)
    hit = np.flatnonzero(shots.counts[:, 0] > 0)[:8]
    assert len(hit) == 8
    proofs = hoopgen.certify(states[hit], scene=flown, max_contacts=2, processes=1)
    shots = flown.simulate(states[hit], max_contacts=2, record=True)
    assert proofs.decided.all()
    assert proofs.agrees(shots).all()


@pytest.mark.slow
@pytest.mark.parametrize("which", ["bell", "throat"])
def test_c_and_numpy_give_the_same_bits(which: str) -> None:
    made = hoopgen.compile(SCENES[which])
    states, values = shots_for(SCENES[which], trials(2000, at_least=500), 5)
    one = made.simulate(states, values, max_contacts=MOST, fields=CLAIMS)
    other = made.simulate(states, values, max_contacts=MOST, backend="numpy", fields=CLAIMS)
    for name in CLAIMS:
        both = (np.asarray(getattr(found, name)) for found in (one, other))
        assert len({found.tobytes() for found in both}) == 1, name


def test_the_page_marks_the_points_of_arcs_that_are_touched(engine: Engines) -> None:
    """Each is on the profile, at the ball's radius from its centre."""
    made = SCENES["bell"]
    states, _ = shots_for(made, 100, 5)
    shots = engine("bell").simulate(states, max_contacts=2, record=True)
    assert "bell" in hoopgen.view(shots).text
    marked, (face,) = contact_points(shots, {}), Slow(made).faces
    for point, event in zip(marked, shots.events, strict=True):
        if event["surface"] == 0:
            nearest = face.nearest(event["before"][:3])
            np.testing.assert_allclose(point, nearest, rtol=0, atol=1e-9)


def test_the_page_of_the_derivation_has_the_arcs() -> None:
    text = SCENES["bell"].explain()
    assert "bell_outside_1" in text
    assert "bell_inside_2" in text


def test_the_normal_of_an_arc_turns_no_faster_than_its_bound() -> None:
    """On either side of arcs, the narrowest part of which is near the axis."""
    chance = np.random.default_rng(6)
    for which in ("crescent", "throat", "lemon"):
        derived = SCENES[which].derive()
        numbers = {p.symbol: p.default for p in derived.parameters}
        for surface in derived.surfaces:
            if not isinstance(surface, RevolvedArc):
                continue
            found = [release(e).xreplace(numbers) for e in (*surface.normal, surface.curvature)]
            at = sp.lambdify(POSITION, found, modules="math")
            centre = np.array([float(sp.sympify(c).xreplace(numbers)) for c in surface.centre])
            unit = np.array([float(u) for u in surface.direction])
            a, r = (float(e.xreplace(numbers)) for e in (surface.offset, surface.radius))
            worst = 0.0
            for _ in range(300):
                angle, turn = chance.uniform(-3, 3, 2)
                rho, height = a + r * np.cos(angle), r * np.sin(angle)
                if rho < 1e-3:
                    continue
                across = np.array([0.0, np.cos(turn), np.sin(turn)])
                across = across if abs(unit[0]) == 1 else np.roll(across, -1)
                sideways = np.cross(unit, across)
                place = centre + rho * across + height * unit
                *normal, bound = at(*place)
                for way in (sideways, np.sin(angle) * across - np.cos(angle) * unit):
                    *moved, _ = at(*(place + 1e-6 * way))
                    rate = np.linalg.norm(np.subtract(moved, normal)) / 1e-6
                    worst = max(worst, rate / bound)
            assert 0.5 < worst <= 1 + 1e-3, which
