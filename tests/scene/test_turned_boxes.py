"""Turned boxes in the engines, against the judge, an integrator and boxes along the axes."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("flint")

import hoopgen
from hoopgen.scene import Box, End, Parameter, Plane, Scene
from hoopgen.simulation.engine import Engine
from tests.helpers.derived import engine_of
from tests.helpers.effort import exceptions, occurrences, trials
from tests.scene.test_oblique_bodies import aimed_at, check_integrator, check_shots

# One worker: each scene is compiled once.
pytestmark = [pytest.mark.xdist_group("turned_boxes")]

Floats = NDArray[np.float64]

BALL, GRAVITY, MOST = 0.06, 9.81, 6
SIZES = {"crate": (0.5, 0.3, 0.2), "board": (0.02, 0.6, 0.4)}
CENTRES = {"crate": (0.1, 0.2, 0.3), "board": (-0.7, -0.4, 0.1)}
CLAIMS = ("outcome", "uncertain", "counts", "time", "state", "time_error", "state_error")


def named(what: str, count: int = 4) -> tuple[str, ...]:
    """Return the names of the parameters of a quaternion, or of a vector."""
    return tuple(f"{what}_{k}" for k in range(count))


def free(what: str, *defaults: float) -> list[Parameter]:
    names = named(what, len(defaults))
    return [Parameter(n, value, "1", sign="any") for n, value in zip(names, defaults, strict=True)]


def turned_boxes(*bodies: Any, parameters: list[Parameter], **given: Any) -> Scene:
    boxes = [
        Box(name, size=size, centre=CENTRES[name], orientation=named(name))
        for name, size in SIZES.items()
    ]
    turns = free("crate", 0.9, 0.1, 0.3, 0.2) + free("board", 0.5, -0.4, 0.2, 0.8)
    settings = {"ball_radius": BALL, "gravity": GRAVITY, "restitution": 0.75} | given
    return Scene("boxes", parameters=turns + parameters, bodies=[*boxes, *bodies], **settings)


BOXES = turned_boxes(Plane("floor", at=-0.9), parameters=[], ends={"gone": End(at=-4)})

TUMBLED = turned_boxes(
    Plane("floor", normal=named("floor", 3), at=-0.9),
    parameters=free("floor", 0, 0.1, 1) + free("down", 0, 0.1, -1),
    down=named("down", 3),
)
"""Gravity and the floor turn, too."""

PERFECT = turned_boxes(
    Plane("floor", at=-0.9), parameters=[], restitution=1.0, friction=0, tangential=0
)

IN_AIR = Scene(
    "boxes_in_air",
    bodies=[
        Box("crate", size=SIZES["crate"], centre=CENTRES["crate"], orientation=(0.9, 0.1, 0.3, 0.2))
    ],
    ball_radius=BALL,
    gravity=GRAVITY,
    restitution=0.75,
    ends={"gone": End(at=-2)},
    air=True,
)


@pytest.fixture(scope="module")
def boxes() -> Engine:
    return hoopgen.compile(BOXES)


def turns(count: int, seed: int) -> dict[str, Any]:
    """Return quaternions at random, of lengths other than 1."""
    chance = np.random.default_rng(seed)
    return {name: chance.normal(0, 1, count) for body in SIZES for name in named(body)}


def aimed(count: int, seed: int, bodies: tuple[str, ...] = tuple(SIZES)) -> Floats:
    """Return shots that fly near the boxes; many slow ones graze edges and corners."""
    return aimed_at([CENTRES[name] for name in bodies], count, seed)


def rotation(quaternion: Floats) -> Floats:
    """Return the matrices of quaternions (n, 4) of any length."""
    w, x, y, z = (quaternion / np.linalg.norm(quaternion, axis=1, keepdims=True)).T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), -1, 0)


def product(left: Floats, right: Floats) -> Floats:
    """Return the products of quaternions (n, 4): first the right one turns, then the left one."""
    (a, u), (b, v) = ((q[:, :1], q[:, 1:]) for q in (left, right))
    real = a * b - np.sum(u * v, axis=1, keepdims=True)
    return np.concatenate([real, a * v + b * u + np.cross(u, v)], axis=1)


def away(one: Any, other: Any, turned: Floats | None = None) -> Floats:
    state = one.state if turned is None else turned
    return np.asarray(np.abs(state - other.state).reshape(-1, 3, 3).max(axis=2))


@pytest.mark.slow
def test_boxes_turn_at_random(boxes: Engine) -> None:
    """10,000 shots, each with its own rotations: the sequences proved, or flagged."""
    count = trials(10_000, at_least=300)
    check_shots(boxes, aimed(count, 1), turns(count, 1))


@pytest.mark.slow
def test_turned_boxes_are_met_where_an_independent_integrator_meets_them(boxes: Engine) -> None:
    count = trials(200, at_least=40)
    states, values = aimed(count, 2), turns(count, 2)
    check_integrator(boxes, BOXES, states, values, {})


QUARTERS = {
    "x": ((1, 1, 0, 0), (0, 2, 1)),
    "y": ((-3, 0, 3, 0), (2, 1, 0)),
    "z": ((0.5, 0, 0, 0.5), (1, 0, 2)),
    "all": ((0.5, 0.5, 0.5, 0.5), (2, 0, 1)),
}
"""Turns, and which side is along each axis after them."""


@pytest.mark.slow
@pytest.mark.parametrize("way", QUARTERS)
def test_a_quarter_turn_swaps_the_sides_of_a_box(way: str, boxes: Engine, tmp_path: Path) -> None:
    """As far as the errors of both allow."""
    turn, sides = QUARTERS[way]
    swapped = [
        Box(name, size=tuple(size[k] for k in sides), centre=CENTRES[name])
        for name, size in SIZES.items()
    ]
    upright = engine_of(
        Scene(
            "upright",
            bodies=[*swapped, Plane("floor", at=-0.9)],
            ball_radius=BALL,
            gravity=GRAVITY,
            restitution=0.75,
            ends={"gone": End(at=-4)},
        ),
        tmp_path,
    )
    count = trials(1000, at_least=200)
    states = aimed(count, 3)
    values = {
        name: np.full(count, float(part))
        for body in SIZES
        for name, part in zip(named(body), turn, strict=True)
    }
    one = boxes.simulate(states, values, max_contacts=MOST, fields=CLAIMS)
    other = upright.simulate(states, max_contacts=MOST, fields=CLAIMS)
    sure = (one.outcome != boxes.outcomes["INVALID"]) & ~one.uncertain & ~other.uncertain
    assert sure.mean() > 0.7
    assert (one.counts[sure] == other.counts[sure]).all()
    assert (one.counts[sure].sum(axis=0) > occurrences(count // 20)).all()
    assert (away(one, other) <= one.state_error + other.state_error)[sure].all()
    assert (np.abs(one.time - other.time) <= one.time_error + other.time_error)[sure].all()


@pytest.mark.slow
def test_a_scene_turned_with_its_gravity_gives_the_turned_shots() -> None:
    """As far as the errors of both allow: the turned parameters are rounded, too."""
    engine = hoopgen.compile(TUMBLED)
    count = trials(1000, at_least=200)
    states, values = aimed(count, 5, ("crate",)), turns(count, 5)
    values |= {f"floor_{k}": np.full(count, float(k == 2)) for k in range(3)}
    values |= {f"down_{k}": np.full(count, -float(k == 2)) for k in range(3)}
    turn = np.random.default_rng(5).normal(0, 1, (count, 4))
    matrix, pivot = rotation(turn), np.array([*CENTRES["crate"], 0, 0, 0, 0, 0, 0])

    def turned(rows: Floats) -> Floats:
        """Return states turned about the centre of the crate."""
        vectors = np.einsum("nij,nkj->nki", matrix, (rows - pivot).reshape(count, 3, 3))
        return np.asarray(vectors.reshape(count, 9) + pivot)

    # The board and the floor stay where they are, so only first contacts with the crate count.
    after = dict(values)
    quaternion = np.stack([values[name] for name in named("crate")], axis=1)
    after |= dict(zip(named("crate"), product(turn, quaternion).T, strict=True))
    after |= dict(zip(named("down", 3), -matrix[..., 2].T, strict=True))
    one = engine.simulate(states, values, max_contacts=1, fields=CLAIMS)
    other = engine.simulate(turned(states), after, max_contacts=1, fields=CLAIMS)
    both = (one.counts[:, 0] == 1) & (other.counts[:, 0] == 1)
    assert both.mean() > 0.4
    sure = both & ~one.uncertain & ~other.uncertain
    assert (both & ~sure).sum() < exceptions(0.01, count)
    late = np.abs(one.time - other.time)
    assert (away(one, other, turned(one.state)) <= one.state_error + other.state_error)[sure].all()
    assert (late <= one.time_error + other.time_error)[sure].all()


@pytest.mark.slow
def test_energy_is_kept_at_restitution_1() -> None:
    """Without friction: what is lost or gained is a few roundings of each contact."""
    count = trials(300, at_least=100)
    engine = hoopgen.compile(PERFECT)
    states, values = aimed(count, 7), turns(count, 7)
    shots = engine.simulate(states, values, max_contacts=MOST, fields=CLAIMS)
    valid = shots.outcome != engine.outcomes["INVALID"]
    assert (shots.counts[valid, :2].sum(axis=0) > occurrences(count // 20)).all()

    def energy(state: Floats) -> Floats:
        return np.asarray(np.sum(state[:, 3:6] ** 2, axis=1) / 2 + GRAVITY * state[:, 2])

    before = energy(states)
    scale = np.sum(states[:, 3:6] ** 2, axis=1) + GRAVITY * (2 + np.abs(states[:, 2]))
    lost = np.abs(energy(shots.state) - before)[valid]
    # By contact some twenty roundings, those of the normal among them.
    assert (lost <= 20 * MOST * 2.0**-53 * scale[valid] / BALL).all()
    assert (shots.state[valid, 6:] == states[valid, 6:]).all()


@pytest.mark.slow
def test_a_turned_box_is_met_through_air() -> None:
    engine = hoopgen.compile(IN_AIR)
    count = trials(100, at_least=40)
    states = aimed(count, 8, ("crate",))
    shots = engine.simulate(states, max_contacts=3, record=True, fields=CLAIMS)
    twice = engine.simulate(states, max_contacts=3, backend="numpy", fields=CLAIMS)
    for name in CLAIMS:
        both = (np.asarray(getattr(found, name)) for found in (shots, twice))
        assert len({found.tobytes() for found in both}) == 1, name
    proofs = hoopgen.certify(states, scene=engine, max_contacts=3)
    assert proofs.agrees(shots).all()
    sure = (shots.outcome != engine.outcomes["INVALID"]) & ~shots.uncertain & proofs.decided
    assert sure.mean() > 0.8
    assert (shots.counts[sure, 0] > 0).mean() > 0.3
    assert (away(shots, proofs) <= shots.state_error + proofs.state_error)[sure].all()


@pytest.mark.slow
def test_a_row_without_a_rotation_is_invalid_and_the_others_are_not(boxes: Engine) -> None:
    states = aimed(4, 9)
    values: dict[str, Any] = {name: np.full(4, 0.5) for name in named("crate")}
    for name in values:
        values[name][1] = 0.0
    values["crate_2"][2] = math.nan
    values["crate_3"][3] = math.inf
    shots = boxes.simulate(states, values, max_contacts=MOST)
    invalid = shots.outcome == boxes.outcomes["INVALID"]
    assert invalid.tolist() == [False, True, True, True]
