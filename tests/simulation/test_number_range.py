"""Hoops and scenes of all sizes: scaled by powers of two, and with sizes near what is allowed.

A power of two scales every sum and product exactly, as long as nothing over- or underflows: so a
shot is the same in a scaled hoop, or hoopgen says that it does not know.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.symbolic.number_range import MAX_FLIGHT, MAX_SIZE, MAX_TIME, MIN_SIZE
from numpy.typing import NDArray

import hoopgen
from benchmarks.families import FAMILIES
from hoopgen.core.validation import check_time_limit
from hoopgen.judge import certify
from hoopgen.scene import Box, End, Parameter, Plane, Scene, Sphere, Surface, Torus
from hoopgen.simulation.engine import Engine
from tests.helpers.compiled import needs_compiler
from tests.helpers.court_shots import all_kinds
from tests.helpers.effort import trials
from tests.scene.test_example_scenes import numpy_engine

pytestmark = [
    pytest.mark.sampled(1),
    pytest.mark.xdist_group("number_range"),
]

Floats = NDArray[np.float64]
Dimension = tuple[int, int]
"""The powers of length and of time in a unit."""

UNITS: Mapping[str, Dimension] = {"m": (1, 0), "m/s": (1, -1), "m/s²": (1, -2), "1": (0, 0)}
STATE: tuple[Dimension, ...] = ((1, 0),) * 3 + ((1, -1),) * 3 + ((0, -1),) * 3
TIME: Dimension = (0, 1)
POWERS = sorted({*range(-340, 341, 20), *range(-32, -22), *range(22, 33), -12, -4, 4, 12})
FEW_POWERS = (-320, -240, -60, -26, -8, 8, 26, 60, 256, 300)
FIELDS = (
    *("outcome", "contacts", "counts", "first", "time", "state"),
    *("uncertain", "time_error", "state_error"),
)

OWN = Scene(
    "sizes",
    parameters=[Parameter("size", 1.0), Parameter("ball", 0.1), Parameter("g", 9.81, "m/s²")],
    ball_radius="ball",
    gravity="g",
    restitution=0.7,
    bodies=[
        Sphere("globe", radius="size/4", centre=("size/2", 0, "size/2")),
        Torus("wheel", radius="size/2", wire="size/20", centre=("-size", 0, 0), axis="x"),
        Box("block", size=("size/2", "size/4", "size/4"), centre=(0, "-size", 0)),
        Plane("shelf", at="-size", within=["x**2 + y**2 - size**2"]),
        Surface("bump", condition="z*size**3 + 4*size**4 - (x - size)**4 + y**4"),
    ],
    ends={"out": End(at="-2*size", within=["x - size"]), "far": End(at="-2*size")},
)
"""Bodies of other kinds, all of whose sizes scale with the parameters."""


@dataclass
class Case:
    """A scene, shots for it, and what they do."""

    scene: Engine
    parameters: Mapping[str, float]
    states: Floats
    backend: str
    powers: tuple[int, ...]
    plain: dict[str, Any] = field(init=False)

    def __post_init__(self) -> None:
        self.plain = self.results(0, 0)

    def results(self, length: int, time: int) -> dict[str, Any]:
        """Return what the shots do in the scene scaled by those powers of two."""
        states = np.stack(
            [
                scaled(column, of, length, time)
                for column, of in zip(self.states.T, STATE, strict=True)
            ],
            axis=1,
        )
        units = {name: unit for name, (_, unit, _) in self.scene.kernels.PARAMETERS.items()}
        parameters = {
            name: float(scaled(value, UNITS[units[name]], length, time))
            for name, value in self.parameters.items()
        }
        limit = min(self.scene.time_limit, 3.0 if self.scene.rolls else math.inf)
        if abs(time) <= 30:  # all shots are invalid elsewhere
            limit = float(scaled(limit, TIME, length, time))
        shots = self.scene.simulate(
            states,
            parameters,
            backend=self.backend,
            time_limit=limit if math.isfinite(limit) else None,
            fields=FIELDS,
            record=True,
        )
        found = {name: getattr(shots, name) for name in FIELDS}
        ends = np.searchsorted(shots.events["shot"], np.arange(1, len(states)))
        found["sequence"] = [list(one["surface"]) for one in np.split(shots.events, ends)]
        found["invalid"] = shots.outcome == self.scene.outcomes["INVALID"]
        invalid = (
            np.flatnonzero(found["invalid"] & ~self.plain["invalid"]) if length or time else []
        )
        if len(invalid):
            rows = invalid[:3]
            found["reasons"] = hoopgen.why_invalid(states[rows], parameters, scene=self.scene)
        return found


def scaled(value: Any, of: Dimension, length: int, time: int) -> Any:
    with np.errstate(over="ignore", under="ignore"):
        return np.ldexp(value, of[0] * length + of[1] * time)


def hoop_states(count: int) -> Floats:
    """Return shots at the article's hoop that are hard in different ways, so many of each kind."""
    shots = (family.make(count) for family in FAMILIES)
    return np.concatenate([states for states, given in shots if given is hoopgen.PAPER])


def own_states(count: int) -> Floats:
    """Return shots at the bodies of `OWN`."""
    rng = np.random.Generator(np.random.PCG64(5))
    goals = np.array([(0.5, 0, 0.5), (-1, 0, 0.4), (0, -1, 0.1), (0.2, 0.2, -1), (1.5, 0.5, -3.9)])
    states = np.zeros((count, 9))
    states[:, :3] = rng.uniform((-2, -2, 0.5), (2, 2, 2), (count, 3))
    time = rng.uniform(0.3, 0.8, (count, 1))
    goal = goals[rng.integers(len(goals), size=count)] + rng.normal(0, 0.15, (count, 3))
    states[:, 3:6] = (goal - states[:, :3]) / time
    states[:, 5] += 9.81 * time[:, 0] / 2
    states[:, 6:] = rng.normal(0, 10, (count, 3))
    return states


def usual(scene: Engine) -> dict[str, float]:
    """Return the parameters of a scene, those that may be infinite finite."""
    return {n: 0.5 if n in scene.infinite else v for n, v in scene.parameters.items()}


@pytest.fixture(
    scope="module",
    params=["hoop c", "court c", "own c", "own numpy", "court numpy", "hoop numpy"],
    name="case",
)
def every_case(request: pytest.FixtureRequest) -> Case:
    """Give each scene on each engine."""
    name, backend = request.param.split()
    scene = {"hoop": hoopgen.HOOP, "court": hoopgen.COURT}.get(name) or hoopgen.compile(OWN)
    if backend == "c" and scene.backend != "c":
        pytest.skip("the C engine was not built")
    many = backend == "c"
    states = {
        "hoop": lambda: hoop_states(trials(300, at_least=40) if many else 12),
        "court": lambda: all_kinds(trials(500, at_least=40) if many else 12),
        "own": lambda: own_states(trials(3000, at_least=300) if many else 100),
    }[name]()
    given = dict(hoopgen.PAPER) if name == "hoop" else usual(scene)
    return Case(scene, given, states, backend, tuple(POWERS) if many else FEW_POWERS)


def check(case: Case, length: int, time: int) -> int:
    """Compare a scaled scene with the plain one; return how many shots could be compared."""
    plain, found = case.plain, case.results(length, time)
    assert not np.any(plain["invalid"] & ~found["invalid"] & ~found["uncertain"])
    for reason in found.get("reasons", ()):
        assert reason.startswith("out of range: ")
    # What is uncertain in the plain scene may be decided otherwise where bounds round otherwise.
    sure = ~found["invalid"] & ~found["uncertain"] & ~plain["uncertain"]
    for name in ("outcome", "contacts", "counts", "first"):
        assert np.array_equal(found[name][sure], plain[name][sure])
    for row in np.flatnonzero(sure):
        assert found["sequence"][row] == plain["sequence"][row]
    assert np.isfinite(found["time_error"][sure]).all()
    assert np.isfinite(found["state_error"][sure]).all()
    moved = {"time": scaled(plain["time"], TIME, length, time)}
    moved["time_error"] = scaled(plain["time_error"], TIME, length, time)
    moved["state"] = np.stack(
        [scaled(c, of, length, time) for c, of in zip(plain["state"].T, STATE, strict=True)], axis=1
    )
    errors = zip(plain["state_error"].T, STATE[::3], strict=True)
    moved["state_error"] = np.stack([scaled(c, of, length, time) for c, of in errors], axis=1)
    if abs(length) + 2 * abs(time) <= 4 or case.scene.name == "sizes":
        # No search begins otherwise.
        assert np.array_equal(found["time"][sure], moved["time"][sure])
        assert np.array_equal(found["state"][sure], moved["state"][sure])
    allowed = found["time_error"] + moved["time_error"]
    assert np.all(np.abs(found["time"] - moved["time"])[sure] <= allowed[sure])
    allowed = np.repeat(found["state_error"] + moved["state_error"], 3, axis=1)
    assert np.all(np.abs(found["state"] - moved["state"])[sure] <= allowed[sure])
    return int(sure.sum())


@pytest.mark.parametrize("of", ["length", "time", "both"])
def test_a_scaled_scene_does_the_same_or_says_that_it_does_not_know(case: Case, of: str) -> None:
    """Lengths, times, or both at once scaled: what is certain is what happens in the plain one."""
    compared = {}
    for power in case.powers:
        by = {"length": (power, 0), "time": (0, power), "both": (power, -power)}[of]
        compared[power] = check(case, *by)
    most = int((~case.plain["invalid"] & ~case.plain["uncertain"]).sum())
    assert most > len(case.states) / 3
    near = [power for power in case.powers if abs(power) <= 14 // (1 + (of != "length"))]
    assert near or of != "length"
    assert all(compared[power] > 0.95 * most for power in near)
    assert all(not compared[power] for power in case.powers if abs(power) > 60)


def test_sizes_near_the_limits_are_proved_or_marked() -> None:
    """One size at a time is as large or as small as allowed: what is certain the judge proves."""
    rng = np.random.Generator(np.random.PCG64(8))
    large, small = float(MAX_SIZE), float(MIN_SIZE)
    states = hoop_states(3)
    for scene, given, own in (
        (hoopgen.HOOP, dict(hoopgen.PAPER), states),
        (hoopgen.COURT, usual(hoopgen.COURT), all_kinds(5)),
    ):
        extremes: list[tuple[str, float]] = [
            *(("gravity", factor) for factor in (small, 1e-4, 1e4, large)),
            *(("ball_radius", factor) for factor in (small, 1e-4)),
            *(("wire_radius", factor) for factor in (5e-324, small)),
            *(("board_distance", factor) for factor in (1e4, large)),
            *(("board_half_width", factor) for factor in (1e4, large)),
            *(("end_depth", factor) for factor in (5e-324, small, 1e4, large)),
            *(("state", factor) for factor in (1e-300, 1e-20, 1e4, 1e7, large)),
        ]
        certain = 0
        for name, value in extremes:
            rows = own.copy()
            parameters = dict(given)
            if name == "state":
                columns = rng.integers(9, size=len(rows))
                rows[np.arange(len(rows)), columns] = value * rng.choice([-1, 1], len(rows))
            else:
                parameters[name] = value
            shots = scene.simulate(rows, parameters, max_contacts=4, record=True, time_limit=60)
            shown = np.flatnonzero(~shots.uncertain)
            proof = certify(rows, parameters, scene=scene, max_contacts=4, time_limit=60)
            agrees = proof.agrees(shots)
            assert np.all(agrees[shown] | ~proof.decided[shown]), name
            certain += int((shots.outcome[shown] != scene.outcomes["INVALID"]).sum())
        assert certain > len(own)


def test_a_flight_that_becomes_too_large_is_uncertain() -> None:
    """A ball that rises higher than `MAX_FLIGHT` makes no shot certain."""
    kernels, most = hoopgen.HOOP.kernels, float(MAX_FLIGHT)
    given = dict.fromkeys(kernels.ARGUMENTS["scale"], 0.0) | {"p_gravity": 2.0}
    sizes = {"x": most, "vy": -most, "vz": math.sqrt(2.0 * most)}
    for name, limit in sizes.items():
        for share, too_large in ((0.99, False), (1.01, True)):
            arguments = given | {name: share * limit, "p_gravity": 1.0 if name == "x" else 2.0}
            if name == "vy":
                arguments["p_gravity"] = 2.0 * most
            excess = kernels.OUTPUTS["scale"].index("excess")
            assert (kernels.scale(**arguments)[excess] > 0) == too_large
    rising = [5.0, 0.0, 1.0, 0.0, 0.0, float(MAX_SIZE), 0.0, 0.0, 0.0]
    assert hoopgen.simulate(rising, {"gravity": 0.5}).uncertain[0]


LIMITS = pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"ball_radius": 2.0**-31}, "ball_radius 4.65661e-10, expected a size of 9.31323e-10 to"),
        ({"gravity": 1e10}, "gravity 1e+10"),
        ({"gravity": 1e-10}, "gravity 1e-10"),
        ({"board_distance": 1e10}, "board_distance 1e+10, expected a size of at most 1.07374e+09"),
        ({"board_top": 1e200}, "board_top 1e+200"),
    ],
)


@LIMITS
def test_parameters_out_of_range_are_invalid_and_named(
    change: Mapping[str, float], named: str
) -> None:
    release = hoopgen.release(7.17, 0.89, height=2.13, distance=4.19)
    for scene in (hoopgen.HOOP, hoopgen.COURT):
        shots = scene.simulate(release, change)
        assert shots.outcome[0] == scene.outcomes["INVALID"]
        assert np.isnan(shots.state).all()
        (reason,) = hoopgen.why_invalid(release, change, scene=scene)
        assert reason.startswith(f"out of range: {named}")
        assert certify(release, change, scene=scene).outcome[0] == scene.outcomes["INVALID"]


@LIMITS
def test_no_study_begins_with_parameters_out_of_range(
    change: Mapping[str, float], named: str
) -> None:
    player = hoopgen.Scatter(
        {"speed": 7.2, "elevation": 0.9, "height": 2.1, "distance": 4.2}, {"speed": 0.1}
    )
    with pytest.raises(
        ValueError, match="no shot can be simulated with these: out of range"
    ) as said:
        hoopgen.estimate(player, parameters=hoopgen.PAPER | change, shots=10)
    assert named in str(said.value)


def test_the_limits_themselves_are_in_range() -> None:
    edge = float(MAX_SIZE)
    for scene in (hoopgen.HOOP, hoopgen.COURT):
        assert hoopgen.why_invalid([edge] * 9, {"board_distance": edge}, scene=scene) == [""]
        beyond = np.nextafter(edge, np.inf)
        for place, name in enumerate(("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")):
            state = np.full(9, 1.0)
            state[place] = -beyond
            assert hoopgen.why_invalid(state, scene=scene) == [
                f"out of range: {name} -1.07374e+09; in a release at most 1.07374e+09"
            ]


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"board_bottom": 3.0}, "board_bottom 3; board_bottom has to be less than board_top"),
        ({"inertia": 0.0}, "inertia 0; inertia has to be from 0.015625 to 1"),
        ({"ball_radius": 0.0}, "ball_radius 0; ball_radius has to be above 0"),
        ({"ring_radius": 0.1}, "ring_radius 0.1; the ball is too big for the ring"),
        (
            {"ring_radius": 0.1, "board_bottom": 3.0},
            "ring_radius 0.1, board_bottom 3, together; "
            "ball_radius + wire_radius has to be less than ring_radius",
        ),
    ],
)
def test_the_condition_that_a_parameter_breaks_is_told(change: Any, said: str) -> None:
    state = [0, 0, 1, 0, 0, 0, 0, 0, 0]
    given = {name: np.array([value]) for name, value in change.items()}
    found = hoopgen.why_invalid(state, given, scene=hoopgen.COURT)
    assert found == [f"parameter not allowed: {said}"]


def test_other_reasons_are_told_as_well() -> None:
    states = np.zeros((4, 9))
    states[:, 2] = 1.0
    states[1, 3] = np.nan
    states[2, 0], states[2, 2] = 0.235, 0.0
    restitution = np.array([0.5, 0.5, 0.5, 1.5])
    assert hoopgen.why_invalid(states, {"restitution": restitution}) == [
        "",
        "not finite: the release",
        "inside the ring",
        "parameter not allowed: restitution 1.5; restitution has to be from 0 to 1",
    ]


def test_of_many_alike_bodies_the_one_is_named_that_a_ball_starts_in(tmp_path: Path) -> None:
    balls = [Sphere(f"stone_{k}", radius=0.2, centre=(k, 0, 0)) for k in range(4)]
    scene = Scene(
        "stones",
        ball_radius=0.1,
        gravity=9.81,
        restitution=0.7,
        bodies=balls,
        ends={"low": End(at=-4)},
    )
    states = np.zeros((3, 9))
    states[:, :3] = [(1, 0, 0.1), (3, 0, 0.1), (2, 0, 0.5)]
    assert hoopgen.why_invalid(states, scene=numpy_engine(scene, tmp_path)) == [
        "inside the stone_1",
        "inside the stone_3",
        "",
    ]


def test_a_time_limit_is_none_or_one_that_can_be_computed_with() -> None:
    assert check_time_limit(float(MAX_TIME)) == float(MAX_TIME)
    assert check_time_limit(math.inf) == math.inf
    with pytest.raises(ValueError, match=r"time_limit: expected at most 1\.09951e\+12 seconds"):
        check_time_limit(2 * float(MAX_TIME))


def hill(steepness: str) -> Scene:
    return Scene(
        "hill",
        parameters=[Parameter("k", 1.0, "1")],
        ball_radius=0.1,
        gravity=9.81,
        restitution=0.7,
        bodies=[Surface("hill", condition=f"{steepness}*z + {steepness}*x**2 + {steepness}*y**2")],
        ends={"low": End(at=-4)},
    )


@needs_compiler
def test_a_polynomial_of_any_scale_is_the_same_surface_or_says_so() -> None:
    """Its coefficients times any number: no contact is missed, no bound is made zero."""
    engine = hoopgen.compile(hill("k"))
    rng = np.random.Generator(np.random.PCG64(4))
    states = np.zeros((200, 9))
    states[:, :3] = rng.uniform((-1, -1, 0.2), (1, 1, 1), (200, 3))
    states[:, 3:6] = rng.normal(0, 1, (200, 3))
    plain = engine.simulate(states, fields=FIELDS)
    assert (plain.contacts > 0).mean() > 0.7
    for power in (-99, -60, -30, -10, 10, 30, 60, 62, 63, 64, 65, 70, 99):
        shots = engine.simulate(states, {"k": 2.0**power}, fields=FIELDS)
        sure = ~shots.uncertain & ~plain.uncertain
        assert np.array_equal(shots.outcome[sure], plain.outcome[sure])
        assert np.array_equal(shots.state[sure], plain.state[sure])
        assert np.all(shots.state_error[sure] >= plain.state_error[sure] / 2)
        assert np.isfinite(shots.state_error[sure]).all()
        if abs(power) <= 60:
            assert (sure & (plain.contacts > 0)).sum() > 100
    for power in (-101, 101, 300, -300):
        (reason,) = hoopgen.why_invalid(states[0], {"k": 2.0**power}, scene=engine)
        assert reason.startswith("out of range: ")
