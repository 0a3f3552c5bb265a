"""Decisions in contact whose margins keep errors from turning them: each margin by itself.

The kernels are called with numbers of which one at a time is at its limit: how bounces end
(`settling`), where the normal force vanishes, and another surface beside a rolling ball.
"""

from __future__ import annotations

import math
from typing import Any

import pytest
from hoopgen.derive.rolling import settling
from hoopgen.derive.rolling.symbols import STARTS
from hoopgen.generated.numpy import court

NONE = -1.0
RADIUS, GRAVITY, RESTITUTION, FRICTION = 0.12, 9.81, 0.7, 0.5
TOLERANCE = float(settling.tolerance(RADIUS))
LEFT = 1 - RESTITUTION
LOSS = LEFT * (1 + RESTITUTION)


def called(kernel: str, values: dict[str, Any], **changed: Any) -> dict[str, Any]:
    """Return what a kernel computes of the values, with some of them changed."""
    given = values | changed
    arguments = [float(given[name]) for name in court.ARGUMENTS[kernel]]
    return dict(zip(court.OUTPUTS[kernel], getattr(court, kernel)(*arguments), strict=True))


# --------------------------------------------------------------------------- how the bounces end

BOUNCING = {
    "p_ball_radius": RADIUS,
    "p_inertia": 2 / 3,
    "p_ring_friction": FRICTION,
    "p_ring_restitution": RESTITUTION,
    "p_gravity": GRAVITY,
    "mode": 0.0,
    "position_error": 0.0,
    "velocity_error": 0.0,
    "per_reach": 5.0,
    "x": 0.2,
    "y": 0.0,
    "z": 0.1,
    **dict.fromkeys(("wx", "wy", "wz", "rolled_y", "rolled_z", "turning_y", "turning_z"), 0.0),
    **dict.fromkeys(("vy", "vz", "nx", "ny"), 0.0),
    "nz": 1.0,
    "vx": 0.1,
    "rolled_x": 0.1,
    "turning_x": 0.5,
    "slip": 0.0,
    "bounce": 5e-10,
    "nearest": math.inf,
    "second_contact_gap": math.inf,
    "press": GRAVITY,
    "weight": -GRAVITY,
    "rolling_friction": 1.0,
    "lift": -GRAVITY,
    "gap_jerk": 0.0,
}
"""A ball that is pressed onto the ring, whose hops are far below the tolerance; nothing is near."""


def ended(**changed: Any) -> dict[str, Any]:
    return called("ring_impact_settling", BOUNCING, **changed)


def test_a_ball_that_hardly_bounces_settles_without_a_question() -> None:
    found = ended()
    assert found["settles"]
    assert found["assured"] == 1
    assert not found["undecided"]


def test_bounces_end_for_certain_only_if_the_force_is_steady_until_they_do() -> None:
    """A hop lasts 2 bounce / press; meanwhile the force turns with the surface."""
    assert ended(bounce=1e-3)["assured"] == 1
    assert ended(bounce=0.2)["assured"] == 0
    assert ended(bounce=0.2, turning_x=0.0)["assured"] == 1


def test_bounces_end_for_certain_only_if_no_body_is_near_until_they_do() -> None:
    way = 16 * 1e-3 / GRAVITY * 0.1 / LEFT
    assert ended(bounce=1e-3, nearest=way / 2)["assured"] == 0
    assert ended(bounce=1e-3, nearest=way * 1.01)["assured"] == 1


def test_beside_a_body_that_is_nearer_than_the_bounces_go_a_ball_is_undecided() -> None:
    beside = ended(nearest=1e-10)
    assert beside["settles"]
    assert beside["undecided"]
    assert not ended(nearest=1e-8)["undecided"]


@pytest.mark.parametrize("force", ["press", "lift"])
def test_a_force_is_undecided_within_the_errors_of_the_state(force: str) -> None:
    """The error is 8 κ ((g + v² κ) P + v E), and a rounding of the force."""
    curvature, speed = 5.0, 0.1
    pull = GRAVITY + speed**2 * curvature
    for place, pace in ((0.0, 0.0), (1e-13, 0.0), (0.0, 1e-13)):
        error = 8 * curvature * (pull * place + speed * pace) + 2.0**-48 * pull
        given = {"bounce": 0.0, "position_error": place, "velocity_error": pace}
        for sign in (1, -1):
            assert ended(**given, **{force: sign * error * 0.999})["undecided"]
            assert not ended(**given, **{force: sign * error * 1.001})["undecided"]


def test_the_last_bounce_is_undecided_within_the_error_of_the_velocity() -> None:
    """The limit is left by bounce² (4 F / (loss N²) + 1 / 2 N)."""
    limit = math.sqrt(TOLERANCE / (4 / (LOSS * GRAVITY**2) + 1 / (2 * GRAVITY)))
    assert ended(bounce=limit * (1 - 1e-6))["settles"]
    assert not ended(bounce=limit * (1 + 1e-6))["settles"]
    for bounce in (limit * (1 - 1e-6), limit * (1 + 1e-6)):
        assert ended(bounce=bounce, velocity_error=1e-5 * limit)["undecided"]
        assert not ended(bounce=bounce, velocity_error=1e-8 * limit)["undecided"]


def test_without_restitution_no_error_of_the_velocity_leaves_the_last_bounce_undecided() -> None:
    """The speed off a surface across no axis is then a rounding, and not exactly zero."""
    for error in (1e-15, 1e-9):
        found = ended(
            p_ring_restitution=0.0, p_ring_friction=math.inf, bounce=1e-17, velocity_error=error
        )
        assert found["settles"]
        assert not found["undecided"]


def test_slip_that_the_bounces_may_stop_is_undecided_within_the_error_of_the_velocity() -> None:
    """They take 2 (mu (1 + e) bounce + 2 F bounce / N) / (share (1 - e)), and a rounding."""
    bounce, quick = 1e-7, 0.1 + math.sqrt(GRAVITY * RADIUS)
    takes = FRICTION * (1 + RESTITUTION) * bounce + 2 * bounce / GRAVITY
    stopped = 2 * takes / (0.4 * LEFT) + 2.0**-36 * quick
    for part in (1 - 1e-3, 1 + 1e-3):
        sure = ended(bounce=bounce, slip=stopped * part)
        assert sure["slides"] == (part > 1)
        assert not sure["undecided"]
        assert ended(bounce=bounce, slip=stopped * part, velocity_error=2e-4 * stopped)["undecided"]


def test_whether_friction_suffices_is_undecided_within_the_error_of_the_velocity() -> None:
    enough = FRICTION * (1 + RESTITUTION) * GRAVITY / 2
    for part in (1 - 1e-9, 1 + 1e-9):
        # No slip is left, and the last bounce is far from the limit.
        given = {"bounce": 5e-7, "rolling_friction": enough * part}
        sure = ended(**given)
        assert sure["slides"] == (part > 1)
        assert not sure["undecided"]
        assert ended(**given, velocity_error=1e-8)["undecided"]


@pytest.mark.parametrize("force", [1e-15, 1e-12])
@pytest.mark.parametrize("friction", [FRICTION, 1e18])
def test_a_ball_that_starts_where_its_force_vanishes_leaves_if_the_gap_opens(
    force: float, friction: float
) -> None:
    """Only then, and only at the start; the force is one of roundings."""
    given = {
        "bounce": 0.0,
        "press": force,
        "lift": -force,
        "gap_jerk": 1.0,
        "mode": STARTS,
        "p_ring_friction": friction,
    }
    verdicts = ("settles", "slides", "unpressed", "undecided")

    def found(**changed: float) -> list[bool]:
        made = ended(**(given | changed))
        return [bool(made[name]) for name in verdicts]

    assert found() == [False, False, True, False]
    assert found(velocity_error=1e-9) == [False, False, True, False]
    presses = [friction > 1, friction < 1, False, force < 1e-14]
    assert found(gap_jerk=-1.0) == presses
    assert found(mode=0.0) == presses
    assert found(press=1e-9, lift=-1e-9) == [*presses[:3], False]


@pytest.mark.parametrize("name", ["position_error", "velocity_error"])
def test_bounces_that_end_with_errors_without_bounds_are_undecided(name: str) -> None:
    given: dict[str, Any] = {
        **dict.fromkeys(court.ARGUMENTS["settled"], 0.0),
        "outcome": NONE,
        "nearly": True,
        "settles": True,
        "unpressed": False,
        "lodges": False,
        "slides": False,
        "undecided": False,
    }
    assert called("settled", given)["uncertain"] == 0
    assert called("settled", given, **{name: math.nan})["uncertain"] == 1
    assert called("settled", given, **{name: math.inf})["uncertain"] == 1
    assert called("settled", given, nearly=False, **{name: math.nan})["uncertain"] == 0


@pytest.mark.parametrize("name", ["position_error", "velocity_error"])
def test_errors_without_bounds_are_undecided_also_where_bounces_end_for_certain(name: str) -> None:
    given: dict[str, Any] = {
        **dict.fromkeys(court.ARGUMENTS["contact_undecided"], 0.0),
        "undecided_time": 0.0,
        "when": 1.0,
        "which": 1.0,
        "last": 1.0,
        "assured": 1.0,
    }
    assert called("contact_undecided", given)["uncertain"] == 0
    assert called("contact_undecided", given, assured=0.0)["uncertain"] == 1
    assert called("contact_undecided", given, **{name: math.nan})["uncertain"] == 1


def test_a_ball_that_may_stay_on_a_surface_is_undecided_on_its_seam() -> None:
    for error in (0.0, 1e-9):
        width = 4 * error + 8 * 2.0**-53 * (0.3 + RADIUS)
        given = BOUNCING | {"uncertain": 0.0, "nearly": 1.0, "position_error": error}
        for gap in (width, -width):
            assert called("seam_undecided", given, gap=gap * 0.999)["uncertain"] == 1
            assert called("seam_undecided", given, gap=gap * 1.001)["uncertain"] == 0
        assert called("seam_undecided", given, gap=0.0, nearly=0.0)["uncertain"] == 0


# ------------------------------------------------------------------------------ where a ball starts

SPEED_LIMIT = 32 * 2.0**-53 * 0.1 * (1 + 0.3 / RADIUS)
FORCE_LIMIT = 2.0**-42 * (GRAVITY + 0.1**2 / RADIUS)
"""The limits of roundings, of the ball that `BOUNCING` describes."""


def test_a_ball_that_starts_with_a_velocity_into_the_surface_hits_it() -> None:
    """A ball whose velocity into it is a rounding leaves, if a force lifts it."""
    lifted = {"press": -1.0, "lift": 1.0, "bounce": 0.0, "mode": STARTS}
    assert ended(**lifted)["unpressed"]
    assert ended(**lifted, vz=-0.49 * SPEED_LIMIT)["unpressed"]
    assert not ended(**lifted, vz=-0.51 * SPEED_LIMIT)["unpressed"]
    # Neither does it leave where the force vanishes.
    gone = {"press": 1e-20, "lift": -1e-20, "gap_jerk": 1.0, "bounce": 0.0, "mode": STARTS}
    assert ended(**gone, vz=-0.99 * SPEED_LIMIT)["unpressed"]
    assert not ended(**gone, vz=-1.01 * SPEED_LIMIT)["unpressed"]
    # After a contact the velocity off the surface is one of roundings.
    assert ended(**(lifted | {"mode": 0.0}), vz=-SPEED_LIMIT)["unpressed"]


def test_whether_the_force_at_the_start_is_one_of_roundings_is_undecided_near_the_limit() -> None:
    started = {"bounce": 0.0, "gap_jerk": 1.0, "mode": STARTS}
    for part, leaves, undecided in (
        (0.49, True, False),
        (0.51, True, True),
        (0.999, True, True),
        (1.001, False, True),
        (1.99, False, True),
        (2.01, False, False),
    ):
        force = part * FORCE_LIMIT
        found = ended(**started, press=force, lift=-force)
        assert found["unpressed"] == leaves
        assert found["undecided"] == undecided


def test_a_ball_that_starts_along_a_surface_has_no_last_bounce_to_decide() -> None:
    given = {"bounce": 0.999 * SPEED_LIMIT, "velocity_error": 1e-12}
    assert not ended(**given, mode=STARTS)["undecided"]
    assert ended(**given)["undecided"]


@pytest.mark.parametrize("sign", [1, -1])
def test_a_velocity_off_the_surface_of_roundings_is_taken_away_at_the_start(sign: int) -> None:
    """The errors grow by 1/32 of the limit, and near the limit the shot is flagged."""
    errors = dict.fromkeys(("dvx", "dvy", "dvz"), 1.0)
    for part, is_rounding, near in (
        (0.49, True, 0.0),
        (0.51, True, 1.0),
        (0.999, True, 1.0),
        (1.001, False, 1.0),
        (1.99, False, 1.0),
        (2.01, False, 0.0),
    ):
        own = {"vz": sign * part * SPEED_LIMIT, "uncertain": 0.0, **errors}
        after = called("velocity_at_start", BOUNCING, **own)
        assert after["vz"] == (0.0 if is_rounding else own["vz"])
        assert after["vx"] == BOUNCING["vx"]
        assert called("undecided_at_start", BOUNCING, **own)["uncertain"] == near
        tiny = own | dict.fromkeys(errors, 0.0)
        grown = called("start_velocity_errors", BOUNCING, **tiny)
        expected = dict.fromkeys(errors, SPEED_LIMIT / 32)
        assert grown == pytest.approx(expected, rel=1e-9, abs=0)


# ------------------------------------------------------------------------------- the normal force

PRESSED = {
    "p_ball_radius": RADIUS,
    "p_gravity": GRAVITY,
    **dict.fromkeys(("vx_1", "vy", "vy_1", "vz", "vz_1", "friction_force_rate"), 0.0),
    "vx": 1.0,
    "which": NONE,
    "undecided_time": math.inf,
    "position_error": 0.0,
    "velocity_error": 0.0,
    "per_reach": 4.0,
    "force": 1e-9,
    "force_rate": 0.0,
    "force_bend": 1.0,
    "stride": 1.0,
    "fastest": 1.0,
}
"""A rolling ball that is hardly pressed on."""


@pytest.mark.parametrize("name", ["position_error", "velocity_error"])
def test_a_force_near_zero_is_undecided_within_the_errors_of_the_state(name: str) -> None:
    assert called("leaving_force", PRESSED)["undecided_time"] == math.inf
    assert called("leaving_force", PRESSED, **{name: 1e-10})["undecided_time"] == 0
    # Where it passes zero quickly it does so in any case.
    passing = PRESSED | {"force_rate": -1.0}
    assert called("leaving_force", passing, **{name: 1e-10})["undecided_time"] == math.inf


# ---------------------------------------------------------------------------- surfaces beside it

BESIDE = {
    "p_ball_radius": RADIUS,
    "x": 0.2,
    "y": 0.0,
    "z": 0.1,
    "gap": 1e-10,
    "index": 1.0,
    "which": NONE,
    "earliest_delay": 0.0,
    "undecided_time": math.inf,
    "position_error": 0.0,
    "nearing": -1e-9,
    "gap_curvature": 1.0,
    "stride": 1.0,
    "strongest": 1.0,
    "fastest": 1.0,
}
"""A rolling ball that a body or an end plane is beside."""

EACH_KERNEL = pytest.mark.parametrize("kernel", ["beside_body", "beside_end_plane"])


@EACH_KERNEL
def test_a_surface_that_a_rolling_ball_may_graze_is_undecided(kernel: str) -> None:
    assert called(kernel, BESIDE)["undecided_time"] == math.inf
    assert called(kernel, BESIDE, position_error=1e-9)["undecided_time"] == 0
    coming = BESIDE | {"nearing": -1.0}
    assert called(kernel, coming, position_error=1e-9)["undecided_time"] == math.inf


@EACH_KERNEL
def test_the_delay_of_a_meeting_holds_the_error_of_the_place(kernel: str) -> None:
    meets = called(kernel, BESIDE, gap=0.0, nearing=-0.5, position_error=1e-9)
    assert meets["which"] == 1
    assert meets["earliest_delay"] >= 1e-9 / 0.5


@EACH_KERNEL
def test_two_events_of_a_rolling_ball_at_once_are_undecided(kernel: str) -> None:
    second = called(kernel, BESIDE, gap=0.0, nearing=-0.5, which=0.0)
    assert second["which"] == 0
    assert second["undecided_time"] == 0
