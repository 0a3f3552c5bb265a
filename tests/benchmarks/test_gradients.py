"""The page on gradients: its truths, hoopgen's derivatives, and how absent peers are treated."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

for _library in ("flint", "matplotlib", "mpmath", "scipy", "sympy"):
    pytest.importorskip(_library)

from benchmarks.gradients import ball, free_throws, peers, run, steps  # noqa: E402
from benchmarks.gradients.ball import BALL, SPRING_BALL, SPRING_TIMES, TIMES, Ball  # noqa: E402
from benchmarks.gradients.peers import EVERYBODY, Peer  # noqa: E402

BALLS = [*((BALL, time) for time in TIMES), *((SPRING_BALL, time) for time in SPRING_TIMES)]


@pytest.mark.parametrize(("one", "time"), BALLS)
def test_the_closed_form_is_the_slope_of_its_own_height(one: Ball, time: float) -> None:
    step = 1e-6
    up, down = (replace(one, height=one.height + sign * step).truth(time)[0] for sign in (1, -1))
    # Differences of a smooth function in doubles, with this step.
    assert (up - down) / (2 * step) == pytest.approx(one.truth(time)[1], abs=1e-8)


@pytest.mark.slow
@pytest.mark.parametrize(("one", "times"), [(BALL, TIMES), (SPRING_BALL, SPRING_TIMES)])
@pytest.mark.sampled(1)
def test_bouncing_balls_have_the_derivatives_of_the_closed_form(
    one: Ball, times: tuple[float, ...]
) -> None:
    right = [one.truth(time)[1] for time in times]
    np.testing.assert_allclose(ball.hoopgen_slopes(one, times), right, rtol=1e-13, atol=0)


@pytest.mark.slow
@pytest.mark.parametrize("task", [ball.task_1, ball.task_2])
def test_the_tasks_have_the_derivatives_of_the_closed_form(task: object) -> None:
    found, right = task()  # type: ignore[operator]
    np.testing.assert_allclose(found, right, rtol=1e-12, atol=0)


def test_steps_have_the_wrong_sign_unless_divided_at_the_impact() -> None:
    assert steps.slopes_of_steps(False)[0] == pytest.approx(1.0, abs=1e-12)
    assert steps.slopes_of_steps(True) == pytest.approx((-1.0, -1.0), abs=1e-12)


def test_free_throws_have_the_derivatives_of_70_digits() -> None:
    for throw in free_throws.throws(1, (1, 3)):
        own = free_throws.error(free_throws.by_hoopgen(throw), throw.truth)
        assert len(throw.surfaces) == throw.contacts
        assert own < 1e-11
        assert own < free_throws.error(free_throws.by_differences(throw), throw.truth)


def test_a_peer_that_is_not_installed_is_a_line() -> None:
    there, absent = peers.taking_part(EVERYBODY, lambda package: package == "heyoka")
    assert {peer.package for peer in there} == {"heyoka"}
    assert len(absent) == len({peer.package for peer in EVERYBODY}) - 1
    assert all("not installed" in line for line in absent)


@pytest.mark.parametrize("peer", EVERYBODY[:2], ids=lambda peer: peer.key)
def test_heyoka_needs_the_jump_of_the_variations(peer: Peer) -> None:
    pytest.importorskip("heyoka")
    right = [BALL.truth(time)[1] for time in TIMES]
    expected = right if peer.key == "heyoka_jump" else [1.0] * len(TIMES)
    found = [peers.slope(peer, time) for time in TIMES]
    np.testing.assert_allclose(found, expected, rtol=1e-13, atol=0)


def test_costs_are_the_least_of_the_rounds() -> None:
    measured = iter((3.0, 10.0, 1.0, 20.0, 2.0, 30.0))  # in turns
    found = run.costs(dict.fromkeys(("first", "second"), lambda: None), 3, lambda _: next(measured))
    assert found == {"first": 1.0, "second": 10.0}
