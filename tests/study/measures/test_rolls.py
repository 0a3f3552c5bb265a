"""Measures of shots that roll: how often, when grip is lost, and whether slip was left."""

from __future__ import annotations

import math
from typing import Any

import mpmath
import numpy as np
import pytest

import hoopgen
from hoopgen import COURT, NBA_COURT, PAPER_COURT, Event, Outcome
from tests.helpers.reaching import each, free_throws

# One worker: the C library of the scene is looked at once.
pytestmark = pytest.mark.xdist_group("rolling")

SIZES = PAPER_COURT
REACH = SIZES["ball_radius"] + SIZES["wire_radius"]
GRAVITY = SIZES["gravity"]
RING, BOARD, BRIDGE = range(3)


def _flown(state: Any, **options: Any) -> hoopgen.Shots:
    sizes = SIZES | options.pop("sizes", {})
    options.setdefault("fields", tuple(COURT.layout.results))
    return hoopgen.simulate(np.array(state), sizes, scene=COURT, record=True, **options)


# ------------------------------------------------------------------------------- how many roll


def test_rolls_counts_the_rows_of_the_log_that_say_so() -> None:
    shots = hoopgen.simulate(
        free_throws(400), SIZES | each("restitution", 0.3), scene=COURT, record=True, time_limit=3
    )
    rows = shots.events["shot"][shots.events["kind"] == Event.ROLL]
    assert np.array_equal(shots.rolls, np.bincount(rows, minlength=len(shots)))
    assert shots.rolls.max() > 1
    assert 0 < np.count_nonzero(shots.rolls) < len(shots)


def test_the_hoop_has_none_of_it() -> None:
    shots = hoopgen.simulate(free_throws(2))
    for name in ("rolls", "slip_left", "grip_lost"):
        assert name not in hoopgen.HOOP.layout.results
        with pytest.raises(AttributeError, match=f"{name}: in the scene hoop no ball rolls"):
            getattr(shots, name)


def test_grip_lost_is_had_by_name_and_changes_nothing() -> None:
    sizes = NBA_COURT | {"ring_restitution": 0.3}
    plain, asked = (
        hoopgen.simulate(free_throws(300), sizes, scene=COURT, time_limit=3, fields=fields)
        for fields in (("outcome", "state", "rolls"), ("outcome", "state", "rolls", "grip_lost"))
    )
    assert not hasattr(plain, "grip_lost")
    for name in ("outcome", "state", "rolls"):
        assert np.array_equal(getattr(plain, name), getattr(asked, name)), name
    assert np.all(np.isinf(asked.grip_lost[asked.rolls == 0]))
    lost = np.isfinite(asked.grip_lost)
    assert lost.any()
    assert np.all(asked.rolls[lost] > 0)


def test_tables_have_it() -> None:
    pytest.importorskip("pandas")
    shots = _flown(free_throws(3))
    frame = shots.to_pandas()
    assert {"rolls", "slip_left", "grip_lost_s"} <= set(frame.columns)
    pytest.importorskip("xarray")
    data = shots.to_xarray()
    assert data["grip_lost"].attrs["units"] == "s"
    assert np.array_equal(data["rolls"], shots.rolls)


# ------------------------------------------------------------------------------- when grip is lost


def _on_top(angle: float, **more: float) -> list[float]:
    """A ball a micrometre above the ring, at an angle around the wire from outwards, degrees."""
    a = math.radians(angle)
    far = REACH + 1e-6
    return [SIZES["ring_radius"] + far * math.cos(a), 0, far * math.sin(a), *[0.0] * 6]


def _lost_in_the_plane(begun: Any, friction: float) -> float:
    """Return when 2/5 g cos a = mu N, from energy and by quadrature, since contact began."""
    with mpmath.workdps(30):
        x, z, vx, vz = (mpmath.mpf(float(begun["after"][k])) for k in (0, 2, 3, 5))
        out = x - SIZES["ring_radius"]
        start, first = mpmath.atan2(z, out), (out * vz - z * vx) / REACH**2

        def rate(a: Any) -> Any:
            fallen = mpmath.mpf(6) / 5 * GRAVITY / REACH * (mpmath.sin(start) - mpmath.sin(a))
            return mpmath.sqrt(first**2 + fallen)

        def excess(a: Any) -> Any:
            force = GRAVITY * mpmath.sin(a) - REACH * rate(a) ** 2
            return mpmath.mpf(2) / 5 * GRAVITY * mpmath.cos(a) - friction * force

        end = mpmath.findroot(excess, (start * 0.9, start * 0.5), solver="anderson")
        # The rate is all but zero where it begins.
        turned = mpmath.quad(
            lambda root: 2 * root / rate(start - root**2), [0, mpmath.sqrt(start - end)]
        )
        return float(turned)


@pytest.mark.parametrize("backend", ["c", "numpy"])
@pytest.mark.parametrize(("angle", "friction"), [(80.0, 0.5), (85.0, 0.3), (70.0, 0.8)])
def test_grip_is_lost_when_the_plane_motion_says(
    backend: Any, angle: float, friction: float
) -> None:
    if backend == "c" and COURT.backend != "c":
        pytest.skip("the C library was not built")
    sizes = each("restitution", 0.0) | each("friction", friction)
    shots = _flown(_on_top(angle), sizes=sizes, backend=backend)
    begun = shots.events[shots.events["kind"] == Event.ROLL][0]
    expected = float(begun["time"]) + _lost_in_the_plane(begun, friction)
    left = shots.events["time"][shots.events["kind"] == Event.LEAVE][0]
    assert begun["time"] < expected < left
    # A cubic over a step of the series, of some hundredths of a second: some ten microseconds.
    assert shots.grip_lost[0] == pytest.approx(expected, rel=0, abs=2e-5)


def test_grip_that_is_infinite_is_never_lost() -> None:
    shots = _flown(_on_top(80.0), sizes=each("restitution", 0.0))
    assert shots.rolls[0] > 0
    assert shots.grip_lost[0] == math.inf


def test_an_invalid_shot_has_no_such_time() -> None:
    shots = _flown([math.nan] * 9)
    assert math.isnan(shots.grip_lost[0])
    assert (shots.rolls[0], shots.slip_left[0]) == (0, False)


# ------------------------------------------------------------------------------- slip that is left


def test_slip_left_tells_capped_shots_apart() -> None:
    state = [-0.308, 0, 0.05, 0, 0, 0, 100.0, 0, 0]
    sizes = {"ball_radius": 0.03, "bridge_half_width": 0.5} | each("restitution", 0.5)
    slips = _flown(state, sizes=sizes | {"bridge_friction": 0.05})
    assert (slips.outcome[0], slips.slip_left[0], slips.rolls[0]) == (Outcome.CAPPED, True, 0)
    assert not slips.uncertain[0]
    assert slips.contacts[0] < 100
    given_up = _flown(state, sizes=sizes | {"bridge_friction": 0.05}, max_contacts=3)
    assert (given_up.outcome[0], given_up.slip_left[0]) == (Outcome.CAPPED, False)
    grips = _flown(state, sizes=sizes)
    assert grips.rolls[0] > 0
    assert not grips.slip_left[0]


def test_a_slope_too_steep_for_friction_leaves_slip_of_any_size() -> None:
    """For 2 F > (1 + e) mu N no small bounce grips, and the ball cannot begin to roll."""
    sizes = each("restitution", 0.5) | each("friction", 0.1)
    shots = _flown(_on_top(60.0), sizes=sizes)
    assert (shots.outcome[0], shots.slip_left[0]) == (Outcome.CAPPED, True)


@pytest.mark.slow
def test_a_proof_agrees_with_a_shot_that_ends_with_slip_left() -> None:
    state = np.array([[-0.308, 0, 0.05, 0, 0, 0, 100.0, 0, 0]] * 2)
    state[1, 6] = 90.0
    sizes = SIZES | {"ball_radius": 0.03, "bridge_half_width": 0.5, "bridge_friction": 0.05}
    sizes |= each("restitution", 0.5)
    shots = hoopgen.simulate(state, sizes, scene=COURT, record=True)
    proof = hoopgen.certify(state, sizes, scene=COURT, max_contacts=12)
    assert shots.slip_left.all()
    assert proof.agrees(shots).all()


# ------------------------------------------------------------------------------- wedged, or not


def test_a_ball_that_rolls_over_the_ring_onto_the_bridge_is_not_wedged_there() -> None:
    """The ring's top goes over into the bridge's: the ball touches both, and rolls on."""
    x, speed = -SIZES["ring_radius"] + 0.005, -0.3
    state = [x, 0, math.sqrt(REACH**2 - 0.005**2) + 1e-7, speed, 0, 0]
    state += [0, speed / SIZES["ball_radius"], 0]
    for backend in ("numpy", COURT.backend):
        shots = _flown(state, sizes=each("restitution", 0.3), time_limit=1.0, backend=backend)
        begun = shots.events[shots.events["kind"] == Event.ROLL]["surface"]
        assert [*begun[:2]] == [RING, BRIDGE]
        assert shots.outcome[0] != Outcome.LODGED or abs(shots.state[0, 3]) < 1e-3


def test_what_is_lodged_between_ring_and_board_is_pressed_onto_both() -> None:
    sizes = SIZES | {"ring_restitution": 0.3}
    states = free_throws(6000)
    shots = hoopgen.simulate(states, sizes, scene=COURT, time_limit=5)
    lodged = np.flatnonzero(shots.outcome == Outcome.LODGED)
    again = hoopgen.simulate(states[lodged], sizes, scene=COURT, time_limit=5, record=True)
    wedged = 0
    for shot in range(len(lodged)):
        x, y, z, vx = again.state[shot, :4]
        rho = math.hypot(x, y)
        off_ring = math.hypot(rho - SIZES["ring_radius"], z) - REACH
        off_board = x + SIZES["board_distance"] - SIZES["ball_radius"]
        if abs(off_board) > 1e-8 or abs(off_ring) > 1e-8:
            continue
        wedged += 1
        # Off the board no faster than what lifts it by half a nanometre.
        assert abs(off_board) < 1e-9
        assert abs(vx) < 2e-4
        assert again.uncertain[shot]
        log = again.events[again.events["shot"] == shot]
        met = log[(log["surface"] == BOARD) & (log["kind"] == Event.IMPACT)]["before"][:, 3]
        assert np.all(np.diff(np.abs(met[-3:])) < 0)  # the bounces on the board end, too
    assert wedged > 3


def test_without_restitution_what_nothing_presses_on_leaves() -> None:
    """A ball that grazes the ring's top too fast to be held by it: one contact, and on it flies."""
    state = [SIZES["ring_radius"] - 0.03, 0, REACH + 0.01, 2.5, 0, -0.5, 0, 0, 0]
    for backend in ("numpy", COURT.backend):
        shots = _flown(state, sizes=each("restitution", 0.0), backend=backend)
        assert shots.outcome[0] == Outcome.MISSED
        assert (shots.contacts[0], shots.rolls[0]) == (1, 0)
        assert not shots.uncertain[0]


# ------------------------------------------------------------------------------- studies


MODEL = hoopgen.Scatter(
    {
        "speed": 7.17,
        "elevation": math.radians(52),
        "backspin": 6 * math.pi,
        "height": 2.1336,
        "distance": 4.191,
    },
    {"speed": 0.1, "azimuth": 0.02},
)


def test_an_estimate_says_how_many_rolled() -> None:
    sizes = NBA_COURT | {"ring_restitution": 0.4}
    found: Any = hoopgen.estimate(MODEL, sizes, scene=COURT, shots=2000)
    drawn = MODEL.draw(0, 2000, 0, sizes)
    shots = hoopgen.simulate(drawn.states, drawn.parameters, scene=COURT)
    assert found.rolled == np.count_nonzero(shots.rolls) > 0
    assert found.slip_left == np.count_nonzero(shots.slip_left) > 0
    assert f"rolled   {100 * found.rolled / 2000:.2f}%: {found.rolled} of the shots" in str(found)
    assert f"{found.slip_left} of them with slip left" in str(found)
    told = found.as_dict()
    assert (told["rolled"], told["slip_left"]) == (found.rolled, found.slip_left)


def test_that_of_the_hoop_says_nothing_of_it() -> None:
    found = hoopgen.estimate(MODEL, shots=10)
    assert (found.rolled, found.slip_left) == (0, 0)
    assert "rolled" not in str(found)


def test_a_map_counts_them() -> None:
    pytest.importorskip("xarray")
    sizes = NBA_COURT | {"ring_restitution": 0.4}
    over = {"aim": np.array([0.0, 0.05])}
    start = {name: value for name, value in MODEL.release.items() if name != "speed"}
    model = hoopgen.Scatter(start, {"speed": 0.1})
    found = hoopgen.map(model, over, sizes, scene=COURT, shots=300)
    assert np.all(found["rolled"] + found["slip_left"] <= found["shots"])
    assert int(found["rolled"].sum()) > 0
