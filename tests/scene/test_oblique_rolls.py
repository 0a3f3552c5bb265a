"""Rolls on turned boxes, slanted cylinders, and parts of spheres and cylinders within bounds.

Each roll is integrated again, with the nearest point of the body and its rate as all that is known
of the body: by DOP853, up to where the normal force vanishes or a bound is passed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.model import build
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

pytest.importorskip("flint")

import hoopgen
from hoopgen import Event
from hoopgen.scene import Box, Cylinder, End, Parameter, Plane, Scene, Sphere
from hoopgen.simulation.engine import Engine
from tests.helpers.derived import DerivedKernels
from tests.helpers.effort import trials
from tests.scene.test_turned_boxes import rotation

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("oblique_rolls"),  # compiled once
]

GRAVITY, BALL, KAPPA = 9.81, 0.05, 2 / 3
SHARE = KAPPA / (1 + KAPPA)
FALL = np.array([0.0, 0.0, -GRAVITY])
CLAIMS = ("outcome", "uncertain", "counts", "time", "state", "rolls", "state_error", "time_error")

Floats = NDArray[np.float64]
Bounds = Sequence[Callable[[Floats], float]]
"""Functions of a point, at most 0 where a body is."""

STEP = 2e-3
"""The longest step on a box, s: a ball may be past a seam for a few milliseconds."""

SIZE, CENTRE = (1.0, 0.6, 0.4), (0.1, 0.2, -0.3)
TURN = ("q0", "q1", "q2", "q3")

CRATE = Scene(
    "crate",
    parameters=[
        Parameter(name, value, "1", sign="any")
        for name, value in zip(TURN, (0.98, 0.1, 0.05, 0.15), strict=True)
    ],
    bodies=[
        Box("crate", size=SIZE, centre=CENTRE, orientation=TURN),
        Plane("floor", at=-1.2),
    ],
    ball_radius=BALL,
    gravity=GRAVITY,
    restitution=0.4,
    rolls=True,
    ends={"past": End(axis="-x", at=-3), "back": End(axis="x", at=-3)},
)

LOG = {"radius": 0.15, "centre": (-2.0, 0.0, 0.0), "axis": (1.0, 0.3, -0.1)}
PIPE = {"radius": 0.4, "centre": (0.0, 0.0, 0.0), "axis": (0.2, 1.0, 0.15)}
DOME = {"radius": 0.4, "centre": (2.0, 0.0, -0.3)}
BOWL = {"radius": 0.5, "centre": (4.0, 0.0, 0.2)}
TROUGH = {"radius": 0.3, "centre": (6.0, 0.0, 0.0), "axis": (0.0, 1.0, 0.0)}

ROUND = Scene(
    "round_bodies_with_edges",
    bodies=[
        Cylinder("log", span=(-0.5, 0.5), **LOG),
        Cylinder("pipe", span=(-0.6, 0.6), inside=True, within=["z - 0.1"], **PIPE),
        Sphere("dome", within=["0.02 - z"], **DOME),
        Sphere("bowl", inside=True, within=["z - 0.1", "x - y - 4.3"], **BOWL),
        Cylinder("trough", inside=True, within=["2*z - x + 6.1"], **TROUGH | {"axis": "y"}),
        Plane("floor", at=-1.2),
    ],
    ball_radius=BALL,
    gravity=GRAVITY,
    restitution=0.3,
    rolls=True,
    ends={"past": End(axis="-x", at=-9), "back": End(axis="x", at=-5)},
)


@pytest.fixture(scope="module")
def crate() -> Engine:
    return hoopgen.compile(CRATE)


@pytest.fixture(scope="module")
def round_bodies() -> Engine:
    return hoopgen.compile(ROUND)


def turned(count: int, seed: int) -> tuple[Floats, dict[str, Any]]:
    """Return balls that fall onto the crate, and its rotations: half of them by little."""
    chance = np.random.default_rng(seed)
    turns = chance.normal(0, 1, (count, 4))
    turns[::2] *= (0.1, 0.1, 0.1, 1)
    turns[::2, 0] = 1
    states = np.zeros((count, 9))
    states[:, :2] = CENTRE[:2] + chance.uniform(-0.4, 0.4, (count, 2))
    states[:, 2] = chance.uniform(0.4, 0.6, count)
    states[:, 3:5] = chance.normal(0, 0.4, (count, 2))
    states[:, 6:] = chance.normal(0, 5, (count, 3))
    return states, dict(zip(TURN, turns.T, strict=True))


def dropped(count: int, seed: int) -> Floats:
    """Return balls that fall onto the round bodies."""
    chance = np.random.default_rng(seed)
    states = np.zeros((count, 9))
    states[:, 0] = 2.0 * (np.arange(count) % 5) - 2.0
    states[:, :2] += chance.uniform(-0.3, 0.3, (count, 2))
    states[:, 2] = chance.uniform(0.2, 0.4, count) - 0.2 * np.isin(np.arange(count) % 5, (1, 3, 4))
    states[:, 3:5] = chance.normal(0, 0.6, (count, 2))
    states[:, 6:] = chance.normal(0, 5, (count, 3))
    return states


# The second formulation


@dataclass(frozen=True)
class Body:
    """A body as the second formulation knows it.

    Attributes
    ----------
    nearest
        The function from the ball's centre to the nearest point, and to the matrix of its rate by
        that of the centre.
    within
        Functions of the nearest point, at most 0 where the body is.
    """

    nearest: Callable[[Floats], tuple[Floats, Floats]]
    within: Bounds = ()


def cylinder(given: Mapping[str, Any], *within: Callable[[Floats], float]) -> Body:
    centre, unit = np.array(given["centre"]), np.array(given["axis"])
    unit = unit / np.linalg.norm(unit)
    along = np.outer(unit, unit)

    def nearest(place: Floats) -> tuple[Floats, Floats]:
        height = (place - centre) @ unit
        across = place - centre - height * unit
        rho = np.linalg.norm(across)
        out, share = across / rho, given["radius"] / rho
        point = centre + height * unit + share * across
        return point, along + share * (np.eye(3) - along - np.outer(out, out))

    return Body(nearest, within)


def sphere(given: Mapping[str, Any], *within: Callable[[Floats], float]) -> Body:
    centre = np.array(given["centre"])

    def nearest(place: Floats) -> tuple[Floats, Floats]:
        rho = np.linalg.norm(place - centre)
        out, share = (place - centre) / rho, given["radius"] / rho
        return centre + given["radius"] * out, share * (np.eye(3) - np.outer(out, out))

    return Body(nearest, within)


def part_of_box(
    turn: Floats, state: Floats, within: Bounds = ()
) -> tuple[Body, Callable[[Floats], Floats]]:
    """Return the face, edge or corner that a ball is or moves onto, and the ways to its seams."""
    axes, half = rotation(turn[None])[0], np.array(SIZE) / 2
    place, rate = axes.T @ (state[:3] - CENTRE), axes.T @ state[3:6]
    beyond = np.abs(place) - half
    side = np.sign(place)
    bent = (beyond > 1e-12) | ((beyond > -1e-12) & (side * rate > 0))
    flat = axes @ np.diag(~bent) @ axes.T

    def nearest(there: Floats) -> tuple[Floats, Floats]:
        own = axes.T @ (there - CENTRE)
        return CENTRE + axes @ np.where(bent, side * half, own), flat

    def seams(there: Floats) -> Floats:
        return np.abs(axes.T @ (there - CENTRE)) - half

    return Body(nearest, within), seams


def pushed(body: Body, state: Floats) -> tuple[float, Floats]:
    """Return the normal force on a ball that rolls, and the rates of its state."""
    place, velocity, spin = state[:3], state[3:6], state[6:]
    point, moves = body.nearest(place)
    normal = (place - point) / np.linalg.norm(place - point)
    turning = (velocity - moves @ velocity) / np.linalg.norm(place - point)
    turning = turning if (place - point) @ normal > 0 else -turning
    force = float(-FALL @ normal - velocity @ turning)
    twist = BALL * (spin @ normal) * np.cross(normal, turning)
    friction = SHARE * (twist - FALL + (FALL @ normal) * normal)
    turns = -np.cross(normal, friction) / (KAPPA * BALL)
    return force, np.concatenate([velocity, FALL + force * normal + friction, turns])


def rolled(
    body: Body, state: Floats, until: float, *ends: Any, step: float = np.inf
) -> tuple[int, float, Floats]:
    """Return which event ended a roll, and when and where: 0 no force, then bounds, then `ends`.

    Without an event it is -1, at the time `until`. An event that is over within a step is missed.
    """

    def lost(_: float, now: Floats) -> float:
        return pushed(body, now)[0]

    def past(bound: Callable[[Floats], float]) -> Callable[[float, Floats], float]:
        return lambda time, now: bound(body.nearest(now[:3])[0]) if time > 1e-9 else -1e-9

    events: list[Any] = [lost, *map(past, body.within), *ends]
    for event in events:
        if not hasattr(event, "terminal"):
            event.terminal, event.direction = True, 1
    lost.direction = -1  # type: ignore[attr-defined]
    options = {"rtol": 1e-13, "atol": 1e-15, "method": "DOP853", "max_step": step}
    if lost(0.0, state) <= 0:
        return 0, 0.0, state
    path = solve_ivp(lambda _, s: pushed(body, s)[1], (0, until), state, events=events, **options)
    found = [k for k, times in enumerate(path.t_events) if len(times)]
    return (found[0] if found else -1), path.t[-1], path.y[:, -1]


def rolled_on_box(
    turn: Floats, state: Floats, until: float, within: Bounds = ()
) -> tuple[int, float, Floats]:
    """Return as `rolled` does; from seam to seam of a box."""
    time = 0.0
    while True:
        part, seams = part_of_box(turn, state, within)
        begun = np.sign(
            seams(state[:3]) + 1e-12 * np.sign(1e-300 - np.abs(seams(state[:3])) + 1e-12)
        )

        def crossing(k: int, begun: Floats = begun, seams: Any = seams) -> Any:
            def away(at: float, now: Floats) -> float:
                return float(seams(now[:3])[k]) if at > 1e-9 else 1e-9 * float(begun[k])

            away.terminal, away.direction = True, 0  # type: ignore[attr-defined]
            return away

        kind, lasting, state = rolled(
            part, state, until - time, *map(crossing, range(3)), step=STEP
        )
        time += lasting
        if kind <= len(within):
            return kind, time, state


def compare(
    shots: hoopgen.Shots, follow: Callable[[Any, float], tuple[int, float, Floats] | None]
) -> list[int]:
    """Compare the rolls of shots that are certain; return how each of them ended."""
    events, ends = shots.events, []
    for k in np.flatnonzero(events["kind"] == Event.ROLL):
        begin = events[k]
        if shots.uncertain[begin["shot"]] or k + 1 == len(events):
            continue
        end = events[k + 1]
        lasting = end["time"] - begin["time"]
        leaves = end["kind"] == Event.LEAVE
        found = follow(begin, lasting + (0.5 if leaves else 0.0))
        if found is None:
            continue
        kind, at, state = found
        assert (kind >= 0) == leaves
        assert at == pytest.approx(lasting, abs=2e-9)
        speed = 1 + np.abs(state[3:6]).max()
        assert end["before"][:3] == pytest.approx(state[:3], abs=2e-9 * speed)
        assert end["before"][3:6] == pytest.approx(state[3:6], abs=1e-7)
        ends.append(kind)
    return ends


def test_rolls_on_a_turned_box_are_those_of_a_second_formulation(crate: Engine) -> None:
    """They end where the normal force vanishes, at a face, an edge or a corner."""
    states, values = turned(trials(150, 60), 1)
    shots = crate.simulate(states, values, time_limit=6, record=True)
    turns = np.stack([values[name] for name in TURN], axis=1)

    def follow(begin: Any, until: float) -> tuple[int, float, Floats] | None:
        if begin["surface"] != 0:
            return None
        return rolled_on_box(turns[begin["shot"]], begin["after"], until)

    assert compare(shots, follow).count(0) > len(states) / 10
    assert not np.any(shots.outcome == crate.outcomes["CAPPED"])


def test_rolls_up_to_edges_are_those_of_a_second_formulation(round_bodies: Engine) -> None:
    """They end where the normal force vanishes, or where the point of contact passes a bound."""
    heights = [
        lambda q, one=one: (q - one["centre"]) @ one["axis"] / np.linalg.norm(one["axis"])
        for one in (LOG, PIPE)
    ]
    bodies = [
        cylinder(LOG, lambda q: abs(heights[0](q)) - 0.5),
        cylinder(PIPE, lambda q: abs(heights[1](q)) - 0.6, lambda q: q[2] - 0.1),
        sphere(DOME, lambda q: 0.02 - q[2]),
        sphere(BOWL, lambda q: q[2] - 0.1, lambda q: q[0] - q[1] - 4.3),
        cylinder(TROUGH, lambda q: 2 * q[2] - q[0] + 6.1),
    ]
    states = dropped(trials(250, 150), 1)
    shots = round_bodies.simulate(states, time_limit=6, record=True)
    for own, body in enumerate(bodies):

        def follow(
            begin: Any, until: float, own: int = own, body: Body = body
        ) -> tuple[int, float, Floats] | None:
            return rolled(body, begin["after"], until) if begin["surface"] == own else None

        ends = compare(shots, follow)
        assert len(ends) > len(states) / 50, own
        # Few balls roll along the log to its end.
        assert own == 0 or sum(kind > 0 for kind in ends) > len(states) / 50, own
    assert not np.any(shots.outcome == round_bodies.outcomes["CAPPED"])


def check_proofs(engine: Engine, states: Floats, values: Any) -> None:
    """Compare the contacts before the first roll with the judge, and both engines."""
    shots = engine.simulate(states, values, time_limit=4, record=True, fields=CLAIMS)
    twice = engine.simulate(states, values, time_limit=4, backend="numpy", fields=CLAIMS)
    for name in CLAIMS:
        both = (np.asarray(getattr(found, name)) for found in (shots, twice))
        assert len({found.tobytes() for found in both}) == 1, name
    proofs = hoopgen.certify(states, values, scene=engine, time_limit=4)
    assert proofs.agrees(shots).all()
    assert np.count_nonzero(shots.rolls) > len(states) / 4


def test_contacts_before_a_roll_on_a_turned_box_are_proved_or_flagged(crate: Engine) -> None:
    check_proofs(crate, *turned(trials(60, 20), 2))


def test_contacts_before_a_roll_on_round_bodies_are_proved_or_flagged(
    round_bodies: Engine,
) -> None:
    check_proofs(round_bodies, dropped(trials(200, 50), 2), None)


def test_a_ball_behind_a_round_body_meets_it_no_sooner_than_its_bound_says() -> None:
    """Past the middle of the body the distance bends up as it does nowhere else."""
    kernels = DerivedKernels(build(ROUND.derive()))
    chance = np.random.default_rng(4)
    given: dict[str, Any] = {
        kernels.VARIABLES[name]: default for name, (default, *_) in kernels.PARAMETERS.items()
    }

    def call(name: str, known: Mapping[str, Any]) -> dict[str, Any]:
        values = [known[argument] for argument in kernels.ARGUMENTS[name]]
        return dict(zip(kernels.OUTPUTS[name], getattr(kernels, name)(*values), strict=True))

    reach = DOME["radius"] + BALL
    met = 0
    for _ in range(trials(300, 100)):
        place = np.array(DOME["centre"]) + chance.normal(0, 0.05, 3)
        velocity = chance.normal(0, 0.3, 3)
        velocity[2] += np.sqrt(2 * GRAVITY * reach) * chance.uniform(0.98, 1.1)
        known = given | dict(zip(kernels.STATE, (*place, *velocity, 0, 0, 0), strict=True))
        known |= call("dome_beside", known)
        known |= {"free_time": np.inf, "outside_time": 0.0}
        claim = float(call("bounded_neighbour_free_time", known)["free_time"])
        times = np.linspace(0, 1, 4001)
        path = place + velocity * times[:, None] + FALL * times[:, None] ** 2 / 2
        gaps = np.linalg.norm(path - DOME["centre"], axis=1) - reach
        falls = np.flatnonzero((gaps[:-1] > 0) & (gaps[1:] <= 0))
        if len(falls):
            met += 1
            assert claim <= times[falls[0] + 1]
    assert met > 10
