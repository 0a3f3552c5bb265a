"""Hard shots: grazes, ties, seams, edges, the axis, extreme numbers; saved ones and random ones.

Each saved case (diabolical/*.json) has its state and parameters as hex floats and what was proved
of it in ball arithmetic, null where that is undecidable; events are spelled in `LETTERS`. Whatever
an engine does not call uncertain must be what was proved. A shot that ever broke becomes a case;
what is not right yet is named in its `known_errors`, and fails once it is.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import hoopgen
from hoopgen import PAPER, Outcome
from hoopgen.judge import Proof, certify
from tests.helpers.compiled import same_bits
from tests.helpers.effort import trials
from tests.helpers.engines import ENGINES, Simulate, simulate_on

FOLDER = Path(__file__).with_name("hard_shots")
LETTERS = "RBPE"
"""Ring, backboard, bridge (a plate), end: the surfaces by their numbers."""

FIELDS = ("outcome", "contacts", "counts", "first", "uncertain")
FLOATS = ("time", "state", "time_error", "state_error")
REACH = PAPER["ball_radius"] + PAPER["wire_radius"]


@dataclass(frozen=True)
class Case:
    """A saved shot.

    Attributes
    ----------
    proved
        Outcome and events, None where undecidable.
    decided
        True if no engine may call it uncertain.
    known_errors
        Claims that do not hold yet, and why.
    """

    name: str
    why: str
    state: list[float]
    parameters: Mapping[str, float]
    max_contacts: int
    proved: tuple[str, str] | None
    decided: bool
    known_errors: Mapping[str, str]


def load() -> list[Case]:
    """Return all saved cases."""
    cases = []
    for path in sorted(FOLDER.glob("*.json")):
        for row in json.loads(path.read_text(encoding="utf-8")):
            proved, changed = row["proved"], row.get("parameters", {})
            cases.append(
                Case(
                    row["name"],
                    row["why"],
                    [float.fromhex(c) for c in row["state"]],
                    PAPER | {name: float.fromhex(value) for name, value in changed.items()},
                    row["max_contacts"],
                    proved and (proved["outcome"], proved["surfaces"]),
                    row["uncertain"] == "not allowed",
                    row.get("known_errors", {}),
                )
            )
    return cases


CASES = load()


def claims(claim: str) -> pytest.MarkDecorator:
    """Run a test on every case; it must fail where the claim is known not to hold."""
    parameters = []
    for case in CASES:
        known = case.known_errors.get(claim)
        marks = [pytest.mark.xfail(reason=known, strict=True)] if known else []
        parameters.append(pytest.param(case, id=case.name, marks=marks))
    return pytest.mark.parametrize("case", parameters)


@pytest.fixture(scope="session")
def engines() -> dict[str, Simulate]:
    """Every engine and width that there is."""
    found = {}
    for engine in ENGINES:
        try:
            found[engine] = simulate_on(engine)
        except pytest.skip.Exception:
            continue
    return found


def flown(simulate: Simulate, case: Case) -> hoopgen.Shots:
    return simulate(
        case.state,
        case.parameters,
        max_contacts=case.max_contacts,
        fields=FIELDS + FLOATS,
        record=True,
    )


def events_of(shots: hoopgen.Shots, shot: int = 0) -> str:
    return spelled(shots.events["surface"][shots.events["shot"] == shot])


def spelled(surfaces: Sequence[int]) -> str:
    return "".join(LETTERS[surface] for surface in surfaces)


@cache
def proof(number: int) -> Proof:
    case = CASES[number]
    return certify([case.state], case.parameters, max_contacts=case.max_contacts)[0]


def within(error: float, bound: float) -> bool:
    return error <= bound or not math.isfinite(error + bound)


# ------------------------------------------------------------------------------------ saved cases


def test_the_cases_are_many_and_each_has_its_name() -> None:
    assert len(CASES) > 250
    assert len({case.name for case in CASES}) == len(CASES)
    assert all(case.why for case in CASES)


@claims("proof")
@pytest.mark.sampled(80)
def test_what_is_saved_is_what_ball_arithmetic_proves(case: Case) -> None:
    proved = proof(CASES.index(case))
    if case.proved is None:
        assert not proved.decided
        assert proved.question
    else:
        assert (Outcome(proved.outcome).name, spelled(proved.surfaces)) == case.proved


@pytest.mark.sampled(40)
@claims("bits")
def test_all_engines_and_widths_give_the_same_bits(
    engines: dict[str, Simulate], case: Case
) -> None:
    wanted = flown(engines["numpy"], case)
    for engine, simulate in engines.items():
        got = flown(simulate, case)
        for name in FIELDS:
            assert getattr(got, name).tobytes() == getattr(wanted, name).tobytes(), (engine, name)
        for name in FLOATS:
            assert same_bits(getattr(got, name), getattr(wanted, name)).all(), (engine, name)
        assert len(got.events) == len(wanted.events)
        for name in ("shot", "surface"):
            assert np.array_equal(got.events[name], wanted.events[name]), (engine, name)
        for name in ("time", "before", "after"):
            assert same_bits(got.events[name], wanted.events[name]).all(), (engine, name)


@pytest.mark.sampled(80)
@claims("sequence")
def test_what_is_not_uncertain_is_what_was_proved(case: Case) -> None:
    shots = flown(hoopgen.simulate, case)
    if not shots.uncertain[0]:
        assert case.proved is not None
        assert (Outcome(shots.outcome[0]).name, events_of(shots)) == case.proved


@pytest.mark.parametrize("case", [c for c in CASES if c.decided], ids=lambda case: case.name)
def test_what_double_precision_decides_is_not_called_uncertain(case: Case) -> None:
    assert not flown(hoopgen.simulate, case).uncertain[0]


@pytest.mark.sampled(80)
@claims("bounds")
def test_time_and_state_are_within_their_bounds_of_the_truth(case: Case) -> None:
    shots, proved = flown(hoopgen.simulate, case), proof(CASES.index(case))
    if shots.uncertain[0] or case.proved is None or "sequence" in case.known_errors:
        return
    off = abs(shots.time[0] - proved.time)
    assert within(off, shots.time_error[0] + proved.time_radius)
    for k in range(9):
        bound = shots.state_error[0, k // 3] + proved.state_radii[k]
        assert within(abs(shots.state[0, k] - proved.state[k]), bound)


@pytest.mark.sampled(1)
@pytest.mark.parametrize("surface", [-1, 0, 1, 2])
def test_every_case_may_claim_to_leave_any_surface(
    engines: dict[str, Simulate], surface: int
) -> None:
    """All cases in one batch, each beside others: still the same bits, and an outcome."""
    states = [case.state for case in CASES]
    parameters = {name: np.array([case.parameters[name] for case in CASES]) for name in PAPER}
    options: dict[str, Any] = {"max_contacts": 12, "leaving": surface, "record": True}
    wanted = engines["numpy"](states, parameters, **options)
    assert np.all(np.isin(wanted.outcome, list(Outcome)))
    assert np.all(wanted.contacts <= 12)
    for simulate in engines.values():
        got = simulate(states, parameters, **options)
        for name in ("outcome", "contacts", "counts", "first"):
            np.testing.assert_array_equal(getattr(got, name), getattr(wanted, name))
        assert same_bits(got.state, wanted.state).all()
        assert same_bits(got.events["after"], wanted.events["after"]).all()


# ----------------------------------------------------------------------------------- random shots

SIZES = st.floats(-1.0, 1.0)
SPINS = st.just(0.0) | st.floats(-50.0, 50.0)
SPEEDS = st.floats(-4.0, 4.0)
ANGLES = st.floats(-math.pi, math.pi)
TINY = st.sampled_from([0.0, 1e-17, -1e-17, 1e-15, -1e-15, 1e-12, -1e-12, 1e-9, -1e-9])
OTHER_HOOPS = st.fixed_dictionaries(
    {},
    optional={
        "ball_radius": st.floats(0.02, 0.2),
        "bridge_half_width": st.floats(0.001, 0.3),
        "restitution": st.floats(0.0, 1.0),
        "gravity": st.floats(0.5, 100.0),
        "board_distance": st.floats(0.36, 0.6),
    },
)


def back_from(
    point: Sequence[float], velocity: Sequence[float], spin: Sequence[float], time: float
) -> list[float]:
    """Return the release that passes `point` with `velocity` after `time`, but for roundings."""
    gravity = PAPER["gravity"]
    up = velocity[2] + gravity * time
    x, y = (p - v * time for p, v in zip(point[:2], velocity[:2], strict=True))
    z = point[2] - up * time + gravity * time**2 / 2
    return [x, y, z, velocity[0], velocity[1], up, *spin]


@st.composite
def near_the_hoop(draw: st.DrawFn) -> list[float]:
    """Anything about the hoop."""
    place = [draw(st.floats(-0.4, 0.6)), draw(st.floats(-0.5, 0.5)), draw(st.floats(-0.3, 0.8))]
    return [*place, *(draw(SPEEDS) for _ in range(3)), *(draw(SPINS) for _ in range(3))]


@st.composite
def grazing(draw: st.DrawFn) -> list[float]:
    """Tangent to the ring, but for nanometres and less."""
    around, about = draw(ANGLES), draw(ANGLES)
    normal = [
        math.cos(about) * math.cos(around),
        math.cos(about) * math.sin(around),
        math.sin(about),
    ]
    centre = [PAPER["ring_radius"] * f(around) for f in (math.cos, math.sin)]
    away = REACH + draw(TINY)
    point = [c + away * n for c, n in zip([*centre, 0.0], normal, strict=True)]
    velocity = [draw(SPEEDS) for _ in range(3)]
    across = sum(v * n for v, n in zip(velocity, normal, strict=True))
    velocity = [v - across * n for v, n in zip(velocity, normal, strict=True)]
    return back_from(point, velocity, [draw(SPINS) for _ in range(3)], draw(st.floats(0.0, 0.6)))


@st.composite
def at_the_seam(draw: st.DrawFn) -> list[float]:
    """Down on the circle where ring and bridge join."""
    y, radius = draw(st.floats(-0.08, 0.08)), PAPER["ring_radius"]
    point = [-math.sqrt(radius**2 - y**2) + draw(TINY), y, REACH]
    velocity = [draw(SPEEDS), draw(SPEEDS), draw(st.floats(-5.0, -0.1))]
    return back_from(point, velocity, [draw(SPINS) for _ in range(3)], draw(st.floats(0.01, 0.3)))


@st.composite
def at_an_edge(draw: st.DrawFn) -> list[float]:
    """On an edge of the board or of the bridge."""
    width, bottom, top = (PAPER[f"board_{n}"] for n in ("half_width", "bottom", "top"))
    if draw(st.booleans()):
        side = draw(st.sampled_from([-width, width]))
        y, z = draw(
            st.tuples(st.just(side), st.floats(bottom, top))
            | st.tuples(st.floats(-width, width), st.sampled_from([bottom, top]))
        )
        x, down = PAPER["ball_radius"] - PAPER["board_distance"], draw(SPEEDS)
        point, velocity = (
            [x, y + draw(TINY), z + draw(TINY)],
            [-abs(draw(SPEEDS)), draw(SPEEDS), down],
        )
    else:
        half = PAPER["bridge_half_width"]
        y = draw(st.sampled_from([-half, half])) + draw(TINY)
        point = [draw(st.floats(-0.2597, -0.2228)), y, REACH]
        velocity = [draw(SIZES) / 10, draw(SIZES), draw(st.floats(-5.0, -0.1))]
    return back_from(point, velocity, [draw(SPINS) for _ in range(3)], draw(st.floats(0.01, 0.3)))


@st.composite
def at_a_tie(draw: st.DrawFn) -> list[float]:
    """Touching board and ring at once."""
    x = PAPER["ball_radius"] - PAPER["board_distance"]
    y = draw(st.floats(-0.23, 0.23))
    z = math.sqrt(REACH**2 - (math.hypot(x, y) - PAPER["ring_radius"]) ** 2)
    point = [x + draw(TINY), y, z + draw(TINY)]
    velocity = [draw(st.floats(-4.0, -1e-9)), draw(SPEEDS), draw(SPEEDS)]
    return back_from(point, velocity, [draw(SPINS) for _ in range(3)], draw(st.floats(0.01, 0.3)))


@st.composite
def fast_or_slow(draw: st.DrawFn) -> list[float]:
    """Draw a velocity from 1e-20 to 1e5 m/s."""
    scale = 10.0 ** draw(st.integers(-20, 5))
    place = [draw(st.floats(-0.25, 0.5)), draw(st.floats(-0.4, 0.4)), draw(st.floats(0.14, 0.4))]
    return [*place, *(scale * draw(SIZES) for _ in range(3)), *(draw(SPINS) for _ in range(3))]


def check(states: list[list[float]], parameters: Mapping[str, float], most: int = 12) -> None:
    """Check NumPy's bits against C's, and what is not uncertain against the judge."""
    fields = FIELDS + FLOATS
    options: dict[str, Any] = {"max_contacts": most, "fields": fields, "record": True}
    shots = hoopgen.simulate(states, PAPER | parameters, **options)
    other = hoopgen.simulate(states, PAPER | parameters, backend="numpy", **options)
    for name in fields:
        assert getattr(shots, name).tobytes() == getattr(other, name).tobytes(), name
    assert shots.events.tobytes() == other.events.tobytes()
    certificate = certify(states, PAPER | parameters, max_contacts=most)
    for row in np.flatnonzero(~shots.uncertain):
        proved = certificate[row]
        assert proved.decided, proved.question
        assert events_of(shots, row) == spelled(proved.surfaces)
        assert shots.outcome[row] == proved.outcome


SHOTS = {
    "near the hoop": near_the_hoop(),
    "grazing": grazing(),
    "at the seam": at_the_seam(),
    "at an edge": at_an_edge(),
    "at a tie": at_a_tie(),
    "fast or slow": fast_or_slow(),
}


@pytest.mark.parametrize("kind", SHOTS)
@pytest.mark.sampled(1)
def test_random_shots_do_what_the_judge_proves_or_say_that_they_do_not_know(kind: str) -> None:
    @settings(max_examples=trials(150), deadline=None, derandomize=True, database=None)
    @given(states=st.lists(SHOTS[kind], min_size=1, max_size=3))
    def holds(states: list[list[float]]) -> None:
        check(states, {})

    holds()


@pytest.mark.sampled(1)
@pytest.mark.parametrize("kind", SHOTS)
def test_the_same_holds_for_other_hoops(kind: str) -> None:
    @settings(max_examples=trials(80), deadline=None, derandomize=True, database=None)
    @given(states=st.lists(SHOTS[kind], min_size=1, max_size=3), parameters=OTHER_HOOPS)
    def holds(states: list[list[float]], parameters: dict[str, float]) -> None:
        check(states, parameters)

    holds()
