"""The judge in air: its pieces hold the true flight, and the engine's shots are as it proves."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from tests.helpers.effort import trials

pytest.importorskip("flint")

import mpmath
from flint import arb, arb_poly, ctx
from hoopgen.derive.scenes.air import AIR as SCENE
from numpy.typing import NDArray

import hoopgen
from hoopgen.judge import Certificate, certify
from hoopgen.judge import air as air_pieces
from hoopgen.judge.formulas import formulas
from hoopgen.judge.pieces import Piece, meets_nothing, next_piece

CLAIMS = ("time_error", "state_error", "outcome", "uncertain", "time", "state", "contacts")
VALUES = [float(parameter.default) for parameter in SCENE.parameters]
NAMES = [parameter.name for parameter in SCENE.parameters]
MADE, MISSED, SHORT, ENDLESS = (SCENE.outcomes[n] for n in ("made", "missed", "short", "endless"))

Shots = NDArray[np.float64]


def free_throws(count: int, seed: int) -> Shots:
    random = np.random.default_rng(seed)
    spread = {"speed": (7.3, 0.35), "elevation": (0.89, 0.044), "backspin": (18.0, 3.0)}
    drawn = {name: random.uniform(m - w, m + w, count) for name, (m, w) in spread.items()}
    azimuth = random.normal(0.0, 0.01, count)
    return np.asarray(hoopgen.release(**drawn, azimuth=azimuth, height=2.1, distance=4.191))


def wild(count: int, seed: int) -> Shots:
    """Shots from anywhere, towards the hoop, with spins of 0.1 to 100 rad/s."""
    random = np.random.default_rng(seed)
    shots = np.empty((count, 9))
    shots[:, :3] = random.uniform((-0.2, -1.2, -0.3), (5.0, 1.2, 2.5), (count, 3))
    aim = np.c_[random.uniform(-0.5, 0.5, (count, 2)), np.zeros(count)]
    lasting = random.uniform(0.15, 1.4, (count, 1))
    shots[:, 3:6] = (aim - shots[:, :3]) / lasting + np.array([0.0, 0.0, 4.9]) * lasting
    shots[:, 6:] = random.normal(size=(count, 3)) * 10 ** random.uniform(-1.0, 2.0, (count, 1))
    return shots


def checked(
    shots: Shots, certificate: Certificate, parameters: Mapping[str, Any] | None = None
) -> float:
    """Return the largest error over what the engine claims, after the sequences are compared."""
    flown = hoopgen.AIR.simulate(shots, parameters, max_contacts=12, record=True, fields=CLAIMS)
    assert certificate.decided.all()
    assert certificate.agrees(flown).all()
    # The engine says of a short shot where it was when that was known, the judge where it met last.
    rows = ~flown.uncertain & np.isin(certificate.outcome, (MADE, MISSED))
    assert rows.sum() > 0.6 * len(shots)
    off = abs(flown.time - certificate.time)[rows] - certificate.time_radius[rows]
    away = np.linalg.norm((flown.state - certificate.state)[rows].reshape(-1, 3, 3), axis=2)
    away -= 2 * certificate.state_error[rows]
    worst = [(off / flown.time_error[rows]).max()]
    claims = flown.state_error[rows]
    worst += [np.divide(away, claims, out=np.zeros_like(away), where=away > 0.0).max()]
    return float(max(worst))


def in_air(shots: Shots, parameters: Mapping[str, Any] | None = None) -> Certificate:
    return certify(shots, parameters, scene=SCENE, max_contacts=12, max_bits=512, processes=1)


@pytest.mark.slow
def test_shots_are_as_proved_and_a_slightly_wrong_engine_is_not() -> None:
    shots = np.concatenate([free_throws(trials(20), 1), wild(trials(12), 2)])
    assert checked(shots, in_air(shots)) < 1
    # An engine whose drag is off by 1e-6 would be found by all that is not flagged.
    wrong = in_air(free_throws(4, 1), {"drag_coefficient": 0.5 * (1 + 1e-6)})
    assert checked(free_throws(4, 1), wrong) > 1


@pytest.mark.slow
@pytest.mark.parametrize(("family", "seed"), [(free_throws, 3), (wild, 4)])
def test_many_shots_are_as_proved(family: Any, seed: int) -> None:
    shots = family(trials(200), seed)
    assert checked(shots, in_air(shots)) < 1


@pytest.mark.slow
def test_shots_of_balls_of_inertias_from_a_tenth_to_one_are_as_proved() -> None:
    """A proof of thin shells is one of other shots: the judge knows the inertia of each."""
    shots = np.concatenate([free_throws(trials(40), 11), wild(trials(40), 12)])
    kappa = np.random.default_rng(13).uniform(0.1, 1.0, len(shots))
    assert checked(shots, in_air(shots, {"inertia": kappa}), {"inertia": kappa}) < 1
    flown = hoopgen.AIR.simulate(shots, {"inertia": kappa}, max_contacts=12)
    met = np.flatnonzero(~flown.uncertain & (flown.contacts > 0))[:12]
    assert len(met) > 0
    shells = in_air(shots[met])
    away = np.linalg.norm((flown.state[met] - shells.state).reshape(-1, 3, 3), axis=2)
    assert np.median(away.max(axis=1)) > 1e-3


# ------------------------------------------------------------------------------------- its pieces


def _true_path(state: list[float], times: list[float]) -> list[list[Any]]:
    """Return position and velocity of the equations of motion, typed again, to 40 digits."""
    with mpmath.workdps(60):
        of = {name: mpmath.mpf(value) for name, value in zip(NAMES, VALUES, strict=True)}
        half_column = of["air_density"] * mpmath.pi * of["ball_radius"] ** 2 / (2 * of["ball_mass"])
        braking = half_column * of["drag_coefficient"]
        lift = half_column * of["ball_radius"] * of["lift_coefficient"]
        wx, wy, wz = (lift * mpmath.mpf(w) for w in state[6:])
        weight = of["gravity"] * (1 - 8 * half_column * of["ball_radius"] / 3)

        def rates(_: Any, now: Any) -> list[Any]:
            vx, vy, vz = now[3:]
            s = mpmath.sqrt(vx**2 + vy**2 + vz**2 + of["drag_smoothing_speed"] ** 2)
            turned = (wy * vz - wz * vy, wz * vx - wx * vz, wx * vy - wy * vx - weight)
            forces = (m - braking * s * v for m, v in zip(turned, (vx, vy, vz), strict=True))
            return [vx, vy, vz, *forces]

        path = mpmath.odefun(rates, 0, [mpmath.mpf(c) for c in state[:6]], tol=mpmath.mpf("1e-50"))
        return [path(time) for time in times]


def _off(piece: Piece, truth: Any, time: float) -> list[tuple[float, float]]:
    """Return the distance of each component's middle from the truth, and its radius.

    The derivation's π is the double below π, of which all of these numbers know 16 digits.
    """
    found = []
    for ball, true in zip(piece.at(arb(time))[:6], truth, strict=True):
        exact = arb(mpmath.nstr(true, 50))
        found.append((float(abs(ball.mid() - exact)), float(ball.rad())))
    return found


@pytest.mark.slow
@pytest.mark.parametrize("state", [wild(1, 5)[0], [0.1, 0.2, 1.0, 0.01, 0.0, 1.0, 3.0, 9.0, 1.0]])
def test_a_piece_follows_the_equations_of_motion(state: Any) -> None:
    """They are integrated by mpmath; between the two is what a double loses of π."""
    start = [float(component) for component in state]
    with ctx.workprec(128):
        piece = next_piece(formulas(SCENE), [arb(c) for c in start], [arb(v) for v in VALUES])
        times = [float(piece.span) * share for share in (0.3, 1.0)]
        for time, truth in zip(times, _true_path(start, times), strict=True):
            for off, radius in _off(piece, truth, time):
                assert off < 2e-16
                assert radius < 1e-30


def _contains(coarse: Piece, fine: Piece) -> bool:
    """Return whether a piece holds the middle of one that is far more exact, wherever it holds."""
    shares = (arb(k) / 16 for k in range(1, 17))
    pairs = ((coarse.at(fine.span * s), fine.at(fine.span * s)) for s in shares)
    return all(c.contains(f.mid()) for one, other in pairs for c, f in zip(one, other, strict=True))


@pytest.mark.slow
def test_a_piece_holds_the_flight_and_what_it_adds_is_needed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """At 32 bits the remainder is seen at 128; without it the piece is wrong."""

    def contained() -> int:
        held = 0
        for shot in wild(20, 6):
            pieces = []
            for bits in (128, 32):
                with ctx.workprec(bits):
                    state, values = [arb(float(c)) for c in shot], [arb(v) for v in VALUES]
                    pieces.append(next_piece(formulas(SCENE), state, values))
            with ctx.workprec(128):
                span = pieces[0].span.min(pieces[1].span)
                held += _contains(pieces[1], replace(pieces[0], span=span))
        return held

    assert contained() == 20
    monkeypatch.setattr(air_pieces, "_proved_bend", lambda *_: arb(0))
    assert contained() < 10


@pytest.mark.slow
def test_a_piece_from_a_box_of_states_holds_the_flights_of_all_of_them() -> None:
    random = np.random.default_rng(7)
    values = [arb(v) for v in VALUES]
    for shot in wild(5, 8):
        width = 10.0 ** random.uniform(-8, -3)
        with ctx.workprec(128):
            box = [arb(float(component), width) for component in shot]
            coarse = next_piece(formulas(SCENE), box, values)
            for _ in range(8):
                inside = shot + random.uniform(-width, width, 9)
                fine = next_piece(formulas(SCENE), [arb(float(c)) for c in inside], values)
                span = fine.span.min(coarse.span)
                assert _contains(coarse, replace(fine, span=span))


def test_boxes_of_a_piece_hold_its_path() -> None:
    values = [arb(v) for v in VALUES]
    for shot in wild(5, 9):
        piece = next_piece(formulas(SCENE), [arb(float(c)) for c in shot], values)
        for k, box in enumerate(piece.boxes):
            place = piece.at(piece.span * (k + 0.5) / len(piece.boxes))[:3]
            assert all(side.contains(ball.mid()) for side, ball in zip(box, place, strict=True))


def test_a_state_that_is_not_known_is_undecided() -> None:
    with pytest.raises(air_pieces.Undecided, match="how the ball flies through the air"):
        next_piece(formulas(SCENE), [arb(0, 1e3)] * 9, [arb(v) for v in VALUES])


# -------------------------------------------------------------------------------------- its ends


@pytest.mark.slow
def test_a_ball_that_rises_through_the_end_plane_falls_through_it_later() -> None:
    proof = in_air(np.array([2.0, 0.0, -1.0, 0.0, 0.0, 6.0, 0.0, 0.0, 0.0]))[0]
    assert (proof.outcome, proof.surfaces) == (MISSED, [3])
    assert 1.0 < proof.time < 1.2


@pytest.mark.slow
def test_a_ball_that_meets_nothing_any_more_is_short_and_one_that_flies_on_is_endless() -> None:
    low = np.array([[2.0, 0.0, -3.0, 0.0, 0.0, 1.0, 0.0, 3.0, 0.0]])
    assert in_air(low).outcome.tolist() == [SHORT]
    high = np.array([[20.0, 0.0, 9.0, 0.0, 0.0, 0.0, 0.0, 3.0, 0.0]])
    limited = certify(high, scene=SCENE, time_limit=0.5, processes=1)
    assert limited.outcome.tolist() == [ENDLESS]
    flown = hoopgen.AIR.simulate(np.concatenate([low, high]), time_limit=0.5)
    assert flown.outcome.tolist() == [SHORT, ENDLESS]
    assert not flown.uncertain.any()
    assert np.linalg.norm(flown.state[1] - limited.state[0]) < 1e-12


def test_a_box_of_releases_is_proved() -> None:
    middle = {"speed": 7.45, "elevation": 0.89, "backspin": 18.0, "height": 2.1, "distance": 4.191}
    proof = hoopgen.certify_box(middle, {"speed": 1e-5}, scene=SCENE, max_parts=20)
    assert proof.proved
    ends = [hoopgen.release(**(middle | {"speed": 7.45 + d})) for d in (-1e-5, 1e-5)]
    flown = hoopgen.AIR.simulate(np.concatenate([np.atleast_2d(end) for end in ends]))
    assert flown.outcome.tolist() == [SCENE.outcomes[proof.outcome]] * 2


@pytest.mark.slow
def test_flagged_shots_are_settled() -> None:
    shots = free_throws(40_000, 10)
    flagged = shots[hoopgen.AIR.simulate(shots, max_contacts=12).uncertain][:3]
    assert len(flagged)
    settled = hoopgen.AIR.simulate(flagged, max_contacts=12, settle=True)
    proved = certify(flagged, scene=SCENE, max_contacts=12, processes=1)
    assert proved.decided.all()
    assert not settled.uncertain.any()
    assert settled.outcome.tolist() == proved.outcome.tolist()


def test_polynomials_of_a_flight_without_air_are_the_parabola() -> None:
    shot = [arb(k) / 8 for k in (1, 2, 3, 4, 5, 6, 7, 8, 9)]
    piece = next_piece(formulas(), shot, [arb(float(v)) for v in hoopgen.PAPER.values()])
    assert piece.exact
    assert [len(p) for p in piece.path] == [2, 2, 3]
    assert isinstance(piece.path[2], arb_poly)
    assert piece.path[2][2].overlaps(-arb(9.81) / 2)


def test_whether_a_ball_has_sunk_is_proved_both_ways() -> None:
    """A ball that may rise or fall is undecided."""
    own, values = formulas(SCENE), [arb(value) for value in VALUES]
    place = [arb(component) for component in (2.0, 0.0, -3.0)]
    spin = [arb(0)] * 3

    def sunk(rise: arb) -> bool | None:
        return meets_nothing(own, [*place, arb(0), arb(0), rise, *spin], values)

    assert [sunk(arb(-1)), sunk(arb(1)), sunk(arb(0, 1))] == [True, False, None]
    assert sunk(arb(-0.5, 0.4)) is True
