"""Surfaces of revolution in the engines, against the judge, an integrator and single bodies."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.surfaces import Surface
from numpy.typing import NDArray

pytest.importorskip("flint")

import hoopgen
from hoopgen.scene import Cone, End, Parameter, Plane, Revolution, Scene, Torus, revolution_faces
from hoopgen.simulation.engine import Engine
from hoopgen.viewer.page import _contact_points as contact_points
from tests.helpers.derived import engine_of
from tests.helpers.effort import exceptions, occurrences, trials
from tests.helpers.slow_scene import Slow
from tests.scene.test_oblique_bodies import aimed_at, rotated

# One worker: each scene is derived once.
pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("revolutions"),
]

Floats = NDArray[np.float64]

BALL, GRAVITY, MOST = 0.06, 9.81, 5
CENTRES = {"funnel": (0.0, 0.0, 0.3), "peg": (0.5, 0.1, 0.0), "tyre": (-0.6, 0.2, 0.1)}
PROFILES: dict[str, Sequence[tuple[Any, Any]]] = {
    "funnel": [(0.1, -0.2), (0.1, -0.1), ("wide", 0.15)],
    # A flat end, a waist that is narrower than the ball, and a tip.
    "peg": [(0, -0.3), (0.15, -0.3), (0.03, 0.0), (0.05, 0.1), (0, 0.25)],
    "tyre": [(0.2, -0.05), (0.35, -0.02), (0.3, 0.1), (0.2, -0.05)],
}
CLAIMS = ("outcome", "uncertain", "counts", "time", "state", "time_error", "state_error")


def own(body: str) -> tuple[str, str, str]:
    """Return the names of the parameters of an axis."""
    return f"{body}_1", f"{body}_2", f"{body}_3"


def scene(name: str, *bodies: Any, leaning: Sequence[str] = ()) -> Scene:
    return Scene(
        name,
        parameters=[
            Parameter("wide", 0.35),
            *(
                Parameter(part, value, "1", sign="any")
                for body in leaning
                for part, value in zip(own(body), (0.1, 0.2, 1.0), strict=True)
            ),
        ],
        bodies=[*bodies, Plane("floor", at=-0.9)],
        ball_radius=BALL,
        gravity=GRAVITY,
        restitution=0.75,
        ends={"gone": End(at=-4)},
    )


def revolved(body: str, **given: Any) -> Revolution:
    return Revolution(body, profile=PROFILES[body], centre=CENTRES[body], **given)


LEANING = scene("leaning_funnel", revolved("funnel", axis=own("funnel")), leaning=["funnel"])
UPRIGHT = scene("upright_profiles", revolved("peg"), revolved("tyre"))
TURNED = scene(
    "turned_profiles",
    *(revolved(body, axis=own(body)) for body in PROFILES),
    leaning=list(PROFILES),
)
SCENES = {"leaning": LEANING, "upright": UPRIGHT}


@pytest.fixture(scope="module")
def leaning(tmp_path_factory: pytest.TempPathFactory) -> Engine:
    return engine_of(LEANING, tmp_path_factory.mktemp("leaning"))


@pytest.fixture(scope="module")
def upright(tmp_path_factory: pytest.TempPathFactory) -> Engine:
    return engine_of(UPRIGHT, tmp_path_factory.mktemp("upright"))


def shots_for(made: Scene, count: int, seed: int) -> tuple[Floats, dict[str, Any]]:
    """Return shots that fly near the bodies, with axes at random and a funnel of any width."""
    centres = [CENTRES[body.name] for body in made.bodies if body.name in CENTRES]
    chance = np.random.default_rng(seed)
    values: dict[str, Any] = {
        name: chance.normal(0, 1, count) for name in made.defaults if name != "wide"
    }
    return aimed_at(centres, count, seed), values | {"wide": chance.uniform(0.2, 0.5, count)}


def check_proofs(engine: Engine, made: Scene, count: int, seed: int) -> hoopgen.Shots:
    """Compare shots with the judge; every body is met."""
    states, values = shots_for(made, count, seed)
    shots = engine.simulate(states, values, max_contacts=MOST, record=True, fields=CLAIMS)
    proofs = hoopgen.certify(states, values, scene=engine, max_contacts=MOST)
    assert proofs.decided.all()
    assert proofs.agrees(shots).all()
    valid = shots.outcome != engine.outcomes["INVALID"]
    assert valid.mean() > 0.8
    assert np.sum(shots.uncertain & valid) < exceptions(0.002, count)
    assert (shots.counts[valid].sum(axis=0) > occurrences(count // 20)).all()
    sure = valid & ~shots.uncertain
    away = np.abs(shots.state - proofs.state).reshape(-1, 3, 3).max(axis=2)
    assert (away <= shots.state_error + proofs.state_error)[sure].all()
    return shots


@pytest.mark.parametrize("which", SCENES)
def test_profiles_give_what_is_proved(which: str, request: pytest.FixtureRequest) -> None:
    """10,000 shots at full effort: the sequences proved, or flagged."""
    count = trials(10_000, at_least=1500)
    check_proofs(request.getfixturevalue(which), SCENES[which], count, seed=1)


def test_a_ball_inside_a_hole_that_is_too_narrow_for_it_is_invalid(tmp_path: Path) -> None:
    """About the axis it overlaps all of the rim, without being able to touch it."""
    rim, ball = 0.02, 0.03
    engine = engine_of(
        Scene(
            "narrow_hole",
            bodies=[Revolution("cup", profile=[(rim, 0), (0.1, 0.1)])],
            ball_radius=ball,
            gravity=GRAVITY,
            restitution=0.5,
            ends={"gone": End(at=-1)},
        ),
        tmp_path,
    )
    random = np.random.default_rng(0)
    states = np.zeros((500, 9))
    states[:, :2] = random.uniform(-0.006, 0.006, (500, 2))
    states[:, 2] = random.uniform(-0.02, 0.02, 500)
    farthest = np.hypot(np.hypot(states[:, 0], states[:, 1]) + rim, states[:, 2])
    states = states[farthest < 0.97 * ball]
    assert len(states) > 100
    assert (engine.simulate(states).outcome == engine.outcomes["INVALID"]).all()
    proofs = hoopgen.certify(states[:10], scene=engine)
    assert (proofs.outcome == engine.outcomes["INVALID"]).all()


@pytest.mark.slow
def test_both_engines_turn_all_profiles_at_random() -> None:
    """10,000 shots, each with its own axes: the same bits, and the sequences proved, or flagged."""
    engine, count = hoopgen.compile(TURNED), trials(10_000, at_least=1000)
    shots = check_proofs(engine, TURNED, count, seed=2)
    states, values = shots_for(TURNED, count, seed=2)
    twice = engine.simulate(states, values, max_contacts=MOST, backend="numpy", fields=CLAIMS)
    for name in CLAIMS:
        both = (np.asarray(getattr(found, name)) for found in (shots, twice))
        assert len({found.tobytes() for found in both}) == 1, name


def differing(
    engine: Engine, made: Scene, count: int, seed: int, most: int | None = None
) -> tuple[list[int], Any]:
    """Return which shots an integrator does not confirm, and the contacts that it does, by body.

    It knows no pieces and no edges: it asks for the nearest point of the whole line. After `most`
    shots that it does not confirm it stops.
    """
    states, values = shots_for(made, count, seed)
    shots = engine.simulate(states, values, max_contacts=3, record=True, time_limit=3.0)
    bodies = len(made.bodies)
    wrong, confirmed = [], np.zeros(bodies, int)
    for row in np.flatnonzero(shots.outcome != engine.outcomes["INVALID"]):
        slow = Slow(made, {name: float(v[row]) for name, v in values.items()})
        flown = slow.fly(states[row], 3, 3.0)
        if flown.close or shots.uncertain[row]:
            continue
        events = shots.events[(shots.events["shot"] == row) & (shots.events["surface"] < bodies)]
        times = [time for _, time in flown.contacts]
        same = events["surface"].tolist() == [body for body, _ in flown.contacts]
        if not same or np.abs(events["time"] - times).max(initial=0) > 1e-8:
            wrong.append(int(row))
            if len(wrong) == most:
                break
        confirmed += np.bincount(events["surface"], minlength=bodies)
    return wrong, confirmed


@pytest.mark.parametrize("which", SCENES)
def test_profiles_are_met_where_an_independent_integrator_meets_them(
    which: str, request: pytest.FixtureRequest
) -> None:
    count = trials(200, at_least=60)
    wrong, confirmed = differing(request.getfixturevalue(which), SCENES[which], count, seed=3)
    assert wrong == []
    assert (confirmed > occurrences(count // 15)).all()


def _without(word: str) -> Any:
    """Return what leaves out the faces whose names have a word."""
    made = revolution_faces.revolution_faces

    def faces(*given: Any) -> tuple[tuple[Surface, ...], list[Any]]:
        found, required = made(*given)
        return tuple(face for face in found if f"_{word}_" not in face.name), required

    return faces


def _longer(self: Any, line: Any, vertex: int) -> Any:
    """Return the way beyond a point of a profile as if every piece were longer by a centimetre."""
    return _BEYOND(self, line, vertex) + (-1 if vertex == line.end else 1) * _CENTIMETRE


_BEYOND = revolution_faces._Faces._beyond
_CENTIMETRE = revolution_faces.sp.Rational(1, 100)


@pytest.mark.parametrize("fault", ["edge", "tip", "inside", "outside", "below", "longer"])
def test_the_integrator_sees_a_planted_fault(
    fault: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    if fault == "longer":
        monkeypatch.setattr(revolution_faces._Faces, "_beyond", _longer)
    else:
        monkeypatch.setattr("hoopgen.scene.derivation.revolution_faces", _without(fault))
    engine = engine_of(UPRIGHT, tmp_path)
    assert differing(engine, UPRIGHT, 200, seed=4, most=1)[0]


def test_a_cone_as_a_profile_is_that_cone(tmp_path: Path) -> None:
    """With both of its sides and rims: the same contacts, states within the errors of both."""
    profile = scene("profile", Revolution("cup", profile=[(0.1, 0.2), (0.35, 0.7)]))
    cone = {"slope": 0.5, "span": (0.2, 0.7)}
    single = scene(
        "single",
        Cone("inner", inside=True, **cone),
        Cone("outer", **cone),
        Torus("low", radius=0.1, centre=(0, 0, 0.2)),
        Torus("high", radius=0.35, centre=(0, 0, 0.7)),
    )
    count = trials(2000, at_least=1000)
    states = aimed_at([(0.0, 0.0, 0.5)], count, 6)
    one, other = (
        engine_of(made, tmp_path).simulate(states, max_contacts=MOST, fields=CLAIMS)
        for made in (profile, single)
    )
    counts = np.stack([other.counts[:, :4].sum(axis=1), other.counts[:, 4]], axis=1)
    # A cone outside is solid: who begins inside is INVALID there.
    met = (one.counts.sum(axis=1) > 0) & (counts.sum(axis=1) > 0)
    sure = met & ~one.uncertain & ~other.uncertain
    assert sure.mean() > 0.5
    assert (one.counts == counts)[sure].all()
    away = np.abs(one.state - other.state).reshape(-1, 3, 3).max(axis=2)
    assert (away <= one.state_error + other.state_error)[sure].all()
    assert (np.abs(one.time - other.time) <= one.time_error + other.time_error)[sure].all()
    assert (other.counts[sure, :4].sum(axis=0) > occurrences(count // 50)).all()


def test_a_scene_turned_about_the_vertical_gives_the_turned_shots(leaning: Engine) -> None:
    """As far as the errors of both allow: the turned parameters are rounded, too."""
    count = trials(1000, at_least=300)
    angle = np.random.default_rng(7).uniform(-math.pi, math.pi, count)
    states, values = shots_for(LEANING, count, 8)
    turn = np.zeros((count, 3, 3))
    turn[:, 0, 0] = turn[:, 1, 1] = np.cos(angle)
    turn[:, 1, 0] = np.sin(angle)
    turn[:, 0, 1] = -turn[:, 1, 0]
    turn[:, 2, 2] = 1.0

    def turned(rows: Floats) -> Floats:
        vectors = np.einsum("nij,nkj->nki", turn, rows.reshape(count, 3, 3))
        return np.asarray(vectors.reshape(count, 9))

    one = leaning.simulate(states, values, max_contacts=MOST, fields=CLAIMS)
    after = rotated(values, angle)
    other = leaning.simulate(turned(states), after, max_contacts=MOST, fields=CLAIMS)
    sure = (one.outcome != leaning.outcomes["INVALID"]) & ~one.uncertain & ~other.uncertain
    assert sure.mean() > 0.8
    assert (one.counts == other.counts)[sure].all()
    away = np.abs(turned(one.state) - other.state).reshape(-1, 3, 3).max(axis=2)
    assert (away <= one.state_error + other.state_error)[sure].all()


def test_a_row_with_another_kind_of_profile_is_invalid_and_the_others_are_not(
    leaning: Engine,
) -> None:
    """A funnel that does not widen would need other faces; and so would one without an axis."""
    states, values = shots_for(LEANING, 4, 9)
    states[:] = 0.0
    states[:, 2] = 2.0
    values["wide"] = np.array([0.3, 0.05, 0.3, -1.0])
    for name in own("funnel"):
        values[name][2] = 0.0
    shots = leaning.simulate(states, values, max_contacts=1)
    invalid = shots.outcome == leaning.outcomes["INVALID"]
    assert invalid.tolist() == [False, True, True, True]


def test_the_page_marks_the_points_that_are_touched(upright: Engine) -> None:
    """Each is on the profile, at the ball's radius from its centre."""
    states, _ = shots_for(UPRIGHT, 100, 5)
    shots = upright.simulate(states, max_contacts=2, record=True)
    assert "peg" in hoopgen.view(shots).text
    marked = contact_points(shots, {"wide": 0.35})
    slow = Slow(UPRIGHT)
    for point, event in zip(marked, shots.events, strict=True):
        if event["surface"] < 2:
            nearest = slow.faces[event["surface"]].nearest(event["before"][:3])
            np.testing.assert_allclose(point, nearest, rtol=0, atol=1e-9)


def _each(made: Scene) -> Iterator[str]:
    yield from (surface.name for surface in made.derive().surfaces)


def test_a_body_has_one_column_whatever_its_faces(upright: Engine) -> None:
    assert UPRIGHT.derive().faces == (0,) * 10 + (1,) * 9 + (2,)
    assert len(set(_each(UPRIGHT))) == 20
    shots = upright.simulate(shots_for(UPRIGHT, 10, 1)[0], max_contacts=2)
    assert shots.counts.shape == (10, 3)
    assert "peg_tip_5" in UPRIGHT.explain()
