"""The judge: it proves what is known, encloses the truth, and admits what is a tie."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from itertools import pairwise, product
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import sympy as sp

from tests.helpers.effort import occurrences, trials

pytest.importorskip("flint")

from click.testing import CliRunner
from flint import arb, arb_poly, ctx
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.symbolic.symbols import POSITION

import hoopgen
from benchmarks import exactness
from benchmarks.families import FAMILIES
from benchmarks.penetration import deepest
from benchmarks.report import section_of
from benchmarks.workloads import TABLE_3, WORKLOADS
from hoopgen.cli.certify import certify as command
from hoopgen.judge import UNDECIDED, Enclosure, Proof, certify
from hoopgen.judge.arrivals import arrival_at
from hoopgen.judge.expressions import compile_expressions
from hoopgen.judge.flight import fly as fly_in_balls
from hoopgen.judge.formulas import formulas
from hoopgen.judge.pieces import next_piece
from hoopgen.judge.proof import doubles, enclosure
from hoopgen.judge.roots import Arrival, first_arrival, sign_changes
from hoopgen.judge.settle import settle
from hoopgen.scene import Cylinder, Plane, Scene, Sphere
from tests.helpers import ROOT
from tests.helpers.hoop_shots import Batch
from tests.helpers.march import Flown

NAMES = (*hoopgen.SURFACES, "end")
RING, BOARD, BRIDGE, END = range(4)
GENEROUS = ("time_error", "state_error", *hoopgen.HOOP.layout.fields)

# Every length a multiple of 1/16, so that a tie can be a tie. The ball touches the board at
# x = -1/2 and the bridge at z = 3/16.
SQUARE = hoopgen.PAPER | {
    "ball_radius": 0.125,
    "wire_radius": 0.0625,
    "ring_radius": 0.5,
    "board_distance": 0.625,
    "board_half_width": 1.0,
    "board_bottom": -0.125,
    "board_top": 1.0,
    "bridge_half_width": 0.125,
    "restitution": 0.5,
    "gravity": 8.0,
    "end_depth": 0.0625,
}

NEWTON_CIRCLES = (
    "0x1.1d9493c7261a4p+2",
    "0x0.0p+0",
    "-0x1.6df1c111cbc88p+0",
    "-0x1.48b83a3cc4b10p+2",
    "0x0.0p+0",
    "0x1.85150b43e5f2cp+2",
    "0x0.0p+0",
    "-0x1.d4754f59eccc0p-5",
    "0x0.0p+0",
)


def state(
    position: tuple[float, float, float],
    velocity: tuple[float, float, float] = (0.0, 0.0, 0.0),
    spin: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> list[float]:
    return [*position, *velocity, *spin]


def prove(shot: Any, parameters: Any = SQUARE, **options: Any) -> Proof:
    return certify(shot, parameters, record=True, **options)[0]


def holds(enclosure: Enclosure, truth: Fraction | int) -> bool:
    middle, radius = (Fraction(part) * Fraction(2) ** enclosure.exponent for part in enclosure[:2])
    return abs(truth - middle) <= radius


# ------------------------------------------------------------------------------ what is known


@pytest.mark.parametrize(
    ("case", "surfaces", "outcome"),
    [
        ("5a", [END], "MADE"),
        ("5b", [RING, RING, END], "MADE"),
        ("5c", [BOARD, END], "MADE"),
        ("5d", [RING, BOARD, BRIDGE, END], "MADE"),
        ("6a", [BOARD, END], "MADE"),
        ("6b", [RING] * 9 + [END], "MISSED"),
        ("7", [RING, BOARD, END], "MISSED"),
    ],
)
def test_the_articles_shots_are_proved(case: str, surfaces: list[int], outcome: str) -> None:
    proof = prove(TABLE_3[case], hoopgen.PAPER)
    assert proof.decided
    assert proof.surfaces == surfaces
    assert hoopgen.Outcome(proof.outcome).name == outcome
    assert proof.time_radius < 1e-16


def test_a_bounce_off_the_board_is_the_one_worked_out_by_hand() -> None:
    # x = -t meets -1/2 at t = 1/2; there z = 3 t - 4 t² = 1/2 and vz = 3 - 8 t = -1.
    shot = state((0.0, 0.25, 0.0), (-1.0, 0.0, 3.0))
    contact = prove(shot).events[0]
    assert contact.surface == BOARD
    assert holds(contact.time, Fraction(1, 2))
    before = [Fraction(*pair) for pair in ((-1, 2), (1, 4), (1, 2), (-1, 1), (0, 1), (-1, 1))]
    # The tangential velocity falls to 3/5 without spin: w+ = (n × v_t)/R_B, n = (1, 0, 0).
    rolling = Fraction(-3, 5)
    after = [
        *before[:3],
        Fraction(1, 2),
        Fraction(0),
        rolling,
        Fraction(0),
        -rolling * 8,
        Fraction(0),
    ]
    for got, wanted in zip(contact.before, [*before, 0, 0, 0], strict=True):
        assert holds(got, wanted)
    for got, wanted in zip(contact.after, after, strict=True):
        assert holds(got, wanted)


def test_bounces_on_the_bridge_are_those_worked_out_by_hand() -> None:
    # From 1 m above the contact, g = 8: down after 1/2 s at 4 m/s; up again at 2 m/s for 1/2 s,
    # then at 1 m/s for 1/4 s, and so on.
    proof = prove(state((-0.55, 0.0, 0.1875 + 1.0)), SQUARE | {"board_distance": 2.0})
    assert proof.surfaces == [BRIDGE] * 40
    assert proof.outcome == hoopgen.Outcome.CAPPED
    truth = Fraction(1, 2)
    for k, event in enumerate(proof.events):
        assert holds(event.time, truth)
        assert event.before[2] == event.after[2] == Enclosure(3, 0, -4)
        truth += Fraction(1, 2 ** (k + 1))


def test_the_time_to_the_end_plane_is_the_root_of_a_parabola() -> None:
    proof = prove(state((0.0, 0.0, 1.0)))
    ball = proof.events[0].time.ball
    with ctx.workprec(200):
        assert ball.contains((arb(17) / 64).sqrt())  # (z + H) / 4
        assert ball.rad() < arb(2) ** -120
    assert proof.outcome == hoopgen.Outcome.MADE
    assert abs(Fraction(proof.time) ** 2 - Fraction(17, 64)) < Fraction(1, 2**52)


# ------------------------------------------------------------------- against another true answer


@pytest.mark.parametrize("family", ["free throw", "bank shot", "drop", "bridge", "anywhere"])
def test_enclosures_hold_the_answer_of_the_slow_march(
    fly: Callable[..., Flown], families: Callable[[int, int], dict[str, Any]], family: str
) -> None:
    states = families(4, 5)[family]
    certificate = certify(states, max_contacts=6, record=True, processes=1)
    for shot, proof in zip(states, certificate.proofs, strict=True):
        true = fly(shot.tolist(), max_contacts=6)
        assert hoopgen.Outcome(proof.outcome).name == true.outcome
        assert tuple(NAMES[k] for k in proof.surfaces) == tuple(name for name, _ in true.events)
        for event, (_, time) in zip(proof.events, true.events, strict=True):
            # The march bisects to 1e-45, and contacts multiply that by some tens each.
            with ctx.workprec(256):
                assert abs(event.time.ball - arb(str(time))) < arb("1e-25")
        for got, radius, wanted in zip(proof.state, proof.state_radii, true.state, strict=True):
            assert abs(Decimal(got) - wanted) <= Decimal(radius) + Decimal("1e-30")


def test_the_first_arrival_is_the_first_of_all_the_roots() -> None:
    surface = formulas().surfaces[RING]
    values = [arb(v) for v in hoopgen.PAPER.values()]
    found = 0
    with ctx.workprec(256):
        for shot in WORKLOADS[2].make(40):
            piece = next_piece(formulas(), [arb(c) for c in shot.tolist()], values)
            coefficients = surface.condition(piece.path, values)[0].coeffs()
            roots = [
                root.real
                for root in arb_poly(coefficients).complex_roots()
                if root.imag.contains(0) and root.real > 0
            ]
            arrival = first_arrival(coefficients, arb(2))
            if arrival is None:
                assert not any(root < 2 for root in roots)
                continue
            found += 1
            assert arrival.certain
            first = min(roots, key=float)
            assert arrival.time.overlaps(first)
    assert found > 10


# --------------------------------------------------------------------------- parts of the proof


def test_formulas_are_evaluated_as_they_stand() -> None:
    surface, names = HOOP.surfaces[RING], HOOP.symbols
    at = dict(
        zip(POSITION, (sp.Rational(3, 10), sp.Rational(-1, 7), sp.Rational(1, 9)), strict=True)
    )
    given = {symbol: sp.Rational(k + 2, 5) for k, symbol in enumerate(names)}
    expressions = [surface.distance, surface.condition, *surface.normal]
    function = compile_expressions(expressions, POSITION, names)
    with ctx.workprec(256):
        numbers = [[arb(v.p) / v.q for v in side.values()] for side in (at, given)]
        for ball, expression in zip(function(*numbers), expressions, strict=True):
            exact = sp.N(expression.subs(at | given).doit(), 60)
            exact = sp.N(
                exact.replace(lambda e: e.func.__name__ == "Barrier", lambda e: e.args[0]), 60
            )
            assert abs(ball - arb(str(exact))) < arb("1e-55")
            assert ball.rad() < arb("1e-70")


def test_what_has_no_ball_arithmetic_is_refused() -> None:
    x = sp.Symbol("x")
    for expression in (sp.sin(x), sp.pi * x, x ** sp.Rational(1, 3)):
        with pytest.raises(TypeError, match="no ball arithmetic"):
            compile_expressions([expression], [x])


def _from_roots(roots: list[float], lead: int) -> list[arb]:
    polynomial = arb_poly([lead])
    for root in roots:
        polynomial *= arb_poly([-arb(root), 1])
    return polynomial.coeffs()


@pytest.mark.parametrize(
    ("roots", "lead", "first"),
    [
        ([0.3, 0.7], 1, 0.3),
        ([0.3], -1, 0.3),
        ([0.5, 0.5 + 2.0**-30], 1, 0.5),
        ([2.0**-40, 0.9], 1, 2.0**-40),
        ([-0.3, 1.7], -1, None),
        ([1.25, 1.5], 1, None),
    ],
)
def test_the_first_root_is_enclosed_or_proved_absent(
    roots: list[float], lead: int, first: float | None
) -> None:
    with ctx.workprec(128):
        arrival = first_arrival(_from_roots(roots, lead), arb(1))
        if first is None:
            assert arrival is None
            return
        assert arrival is not None
        assert arrival.certain
        assert arrival.time.contains(arb(first))
        assert arrival.time.rad() < arb(2) ** -80


def test_unknown_signs_are_counted_as_all_that_they_can_be() -> None:
    for signs in product((1, 0, -1, None), repeat=6):
        changes = set()
        for guess in product((1, 0, -1), repeat=signs.count(None)):
            given = iter(guess)
            full = [1, *(next(given) if s is None else s for s in signs)]
            nonzero = [s for s in full if s]
            changes.add(sum(a != b for a, b in pairwise(nonzero)))
        assert sign_changes(signs) == (min(changes), max(changes))


def test_the_first_root_is_right_for_every_polynomial_within_the_balls() -> None:
    random = np.random.default_rng(11)
    certain = 0
    for _ in range(trials(300)):
        centre = np.polynomial.polynomial.polyfromroots(random.uniform(-0.5, 1.5, 4))
        centre *= np.sign(centre[0])
        radius = 10 ** random.uniform(-12, -3)
        with ctx.workprec(64):
            arrival = first_arrival([arb(c, radius) for c in centre], arb(1))
        if centre[0] <= 10 * radius:
            continue
        for _ in range(20):
            roots = np.polynomial.polynomial.polyroots(centre + random.uniform(-radius, radius, 5))
            inside = roots.real[(abs(roots.imag) < 1e-13) & (roots.real > 0) & (roots.real < 1)]
            first = inside.min(initial=2.0)
            if arrival is None:
                assert first > 1 - 1e-9
            elif arrival.certain:
                certain += 1
                assert abs(first - float(arrival.time)) <= float(arrival.time.rad()) + 1e-9
            else:
                assert first >= float(arrival.time) - 1e-9
    assert certain > occurrences(1000)


def test_a_root_that_newton_circles_is_found() -> None:
    # From the middle of the bracket Newton's step lands on its end, and from there on the middle.
    shot = [float.fromhex(text) for text in NEWTON_CIRCLES]
    proof = prove(shot, hoopgen.PAPER, max_bits=128)
    assert proof.surfaces == [RING, END]


def test_a_root_on_a_split_is_not_lost() -> None:
    with ctx.workprec(128):
        arrival = first_arrival(_from_roots([0.48828125, 0.7, 0.9], -1), arb(1))
        assert arrival is not None
        assert arrival.time.overlaps(arb(0.48828125)) or not arrival.certain
        assert arrival.time < arb(0.5)


def _arrival(surface: int, **components: arb) -> Arrival | None:
    """Ask for the arrival at a surface from a state that is partly known."""
    names = ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")
    values = [arb(float(v)) for v in SQUARE.values()]
    start = [components.get(name, arb(0)) for name in names]
    piece = next_piece(formulas(), start, values)
    return arrival_at(formulas(), surface, piece, values, 0, arb.pos_inf())


@pytest.mark.parametrize(
    ("surface", "components"),
    [
        (BOARD, {"x": arb(-0.5, 1e-30), "vx": arb(-1)}),  # on the plane, or just past it
        (BOARD, {"vx": arb(0, 1e-30)}),  # hardly moving, this way or that
        (BRIDGE, {"x": arb(-0.55), "z": arb(-0.8125), "vz": arb(4, 1e-30)}),  # up to it, or not
        (BRIDGE, {"x": arb(-0.5, 1e-30), "z": arb(1)}),  # onto the end of it, where rho is R_H
        (RING, {"x": arb(0.6875, 1e-30), "vx": arb(1)}),  # touching, or just not
        (RING, {"x": arb(0.6875, 1e-30), "z": arb(1)}),  # past it, or not
    ],
)
def test_what_a_ball_does_not_tell_is_not_certain(surface: int, components: dict[str, arb]) -> None:
    with ctx.workprec(128):
        arrival = _arrival(surface, **components)
    assert arrival is not None
    assert not arrival.certain


def test_a_double_root_is_never_certain() -> None:
    with ctx.workprec(128):
        arrival = first_arrival(_from_roots([0.3, 0.3], 1), arb(1))
    assert arrival is not None
    assert not arrival.certain
    assert arrival.time <= arb(0.3)


def test_enclosures_shrink_with_precision() -> None:
    values = [float(v) for v in hoopgen.PAPER.values()]
    flown = {}
    for bits in (128, 256, 512):
        with ctx.workprec(bits):
            flown[bits] = fly_in_balls(formulas(), TABLE_3["5d"].tolist(), values, 40)
    with ctx.workprec(1024):
        for wide, narrow in ((128, 256), (256, 512)):
            for outer, inner in zip(flown[wide].state, flown[narrow].state, strict=True):
                assert outer.overlaps(inner)
                assert inner.rad() <= outer.rad() * arb(2) ** (wide - narrow + 8)


def test_digits_in_print_are_proved() -> None:
    assert str(Enclosure(1, 0, -2)) == "0." + "25" + "0" * 38
    third = Enclosure((1 << 60) // 3, 1, -60)
    assert str(third).startswith("0.33333333333333333")
    assert len(str(third)) <= 22
    assert float(third) == 1 / 3


# ---------------------------------------------------------------- what no precision can decide


@pytest.mark.parametrize(
    ("shot", "question"),
    [
        # Both at t = 1/2: x = -t, z = 19/16 - 4 t².
        (state((0.0, 0.0, 1.1875), (-1.0, 0.0, 0.0)), "bridge or the backboard comes first"),
        # Straight up, and straight down, along the ring's outermost line.
        (state((0.6875, 0.0, -0.5), (0.0, 0.0, 6.0)), "meets the ring"),
        (state((0.0, 0.6875, 1.0)), "meets the ring"),
        # At t = 1/6 onto the board's edge, y = 1.
        (state((0.0, 0.75, 0.5), (-3.0, 1.5, 0.0)), "meets the backboard"),
        # On the ring's outermost line, rising, and back again.
        (state((0.6875, 0.0, 0.0), (0.0, 0.0, 1.0)), "meets the ring"),
    ],
)
def test_a_tie_and_a_touch_are_undecidable(shot: list[float], question: str) -> None:
    proof = prove(shot, max_bits=512)
    assert not proof.decided
    assert proof.outcome == UNDECIDED
    assert question in proof.question
    assert proof.bits == 512
    assert np.isnan([proof.time, *proof.state]).all()


def test_an_undecidable_shot_is_proved_as_far_as_it_goes() -> None:
    # Off the board, then into the corner: without restitution it slides down the board.
    shot = state((0.5, 0.0, 0.5), (-4.0, 0.0, 1.0), (0.0, 20.0, 0.0))
    proof = prove(shot, SQUARE | {"restitution": 0.0}, max_bits=512)
    assert proof.surfaces[:1] == [BOARD]
    assert proof.times[0] == 0.25


@pytest.mark.parametrize(
    ("top", "surfaces"),
    [(1.0, [BOARD, END]), (1.0 - 2.0**-53, None), (1.0 + 2.0**-52, [BOARD, END])],
)
def test_the_exact_edge_belongs_to_the_board(top: float, surfaces: list[int] | None) -> None:
    # At t = 1/2 x = -1/2 and z = 1 + 2 t - 4 t² = 1, on the edge itself.
    proof = prove(state((0.5, 0.0, 1.0), (-2.0, 0.0, 2.0)), SQUARE | {"board_top": top})
    assert proof.decided
    assert (proof.surfaces[0] == BOARD) == (surfaces is not None)


# -------------------------------------------------------------------- starts, ends and rests


def test_a_ball_that_starts_exactly_touching_is_not_inside() -> None:
    leaving = prove(state((0.6875, 0.0, 0.0), (1.0, 0.0, 1.0)))
    assert leaving.surfaces == [END]
    entering = prove(state((0.6875, 0.0, 0.0), (-1.0, 0.0, 1.0)))
    assert entering.surfaces[0] == RING
    assert entering.times[0] == 0.0
    inside = prove(state((0.6875 - 2.0**-50, 0.0, 0.0), (1.0, 0.0, 1.0)))
    assert inside.outcome == hoopgen.Outcome.INVALID


@pytest.mark.parametrize(
    ("shot", "changes"),
    [
        (state((0.0, float("nan"), 1.0)), {}),
        (state((0.0, 0.0, 1.0), (float("inf"), 0.0, 0.0)), {}),
        (state((0.5, 0.0, 0.1)), {}),
        (state((-0.55, 0.0, 0.5)), {}),
        (state((0.0, 0.0, 1.0)), {"ball_radius": 0.4375}),
        (state((0.0, 0.0, 1.0)), {"gravity": 0.0}),
        (state((0.0, 0.0, 1.0)), {"restitution": np.array([1.5])}),
        (state((0.0, 0.0, 1.0)), {"ring_radius": float("nan")}),
    ],
)
def test_what_cannot_be_flown_is_invalid(shot: list[float], changes: dict[str, Any]) -> None:
    proof = prove(shot, SQUARE | changes)
    assert proof.outcome == hoopgen.Outcome.INVALID
    assert proof.surfaces == []
    assert np.isnan([proof.time, *proof.state]).all()


def test_a_ball_below_that_does_not_rise_through_the_end_plane_is_short() -> None:
    certificate = certify(
        [state((2.0, 0.0, -1.0)), state((2.0, 0.0, -1.0), (0.0, 0.0, 3.0))], SQUARE
    )
    assert certificate.outcome.tolist() == [hoopgen.Outcome.SHORT] * 2
    assert certificate.time.tolist() == [0.0, 0.0]
    assert certificate.first.tolist() == [-1, -1]


@pytest.mark.parametrize("height", [1.0, 0.7])  # 0.5 s, and a time that no binary fraction is
def test_without_restitution_a_ball_stays_on_the_bridge(height: float) -> None:
    shot = state((-0.55, 0.0, 0.1875 + height))
    proof = prove(shot, SQUARE | {"restitution": 0.0, "board_distance": 2.0})
    assert proof.surfaces == [BRIDGE] * 40
    assert len(set(proof.times)) == 1
    # Two roundings, of the height and of the time.
    assert proof.times[0] == pytest.approx(np.sqrt(height / 4), rel=4e-16, abs=0)
    assert proof.outcome == hoopgen.Outcome.CAPPED
    assert proof.events[-1].after[2] == Enclosure(3, 0, -4)
    assert proof.events[-1].after[5] == Enclosure(0, 0, 0)


def test_without_restitution_a_ball_slides_down_the_board() -> None:
    shot = state((0.5, 0.5, 0.75), (-4.0, 0.5, 0.0))
    proof = prove(shot, SQUARE | {"restitution": 0.0})
    assert proof.surfaces == [BOARD, END]
    assert proof.events[0].after[3] == Enclosure(0, 0, 0)
    assert proof.events[1].before[0] == Enclosure(-1, 0, -1)


@pytest.mark.parametrize("x", [0.5, 0.46875, 0.53125])
def test_without_restitution_a_ball_that_the_ring_bears_stays_on_it(x: float) -> None:
    proof = prove(state((x, 0.0, 1.0)), SQUARE | {"restitution": 0.0})
    assert proof.surfaces == [RING] * 40
    assert len(set(proof.times)) == 1


def test_states_are_known_to_the_last_digit_of_a_double() -> None:
    certificate = certify(WORKLOADS[3].make(20), processes=1)
    assert certificate.bits.max() > 128
    # Half the spacing is the rounding to a double itself.
    known = 0.501 * np.spacing(np.abs(certificate.state)) + 2.0**-100
    assert (certificate.state_radius <= known).all()


def test_max_contacts_caps() -> None:
    proof = prove(TABLE_3["7"], hoopgen.PAPER, max_contacts=2)
    assert proof.outcome == hoopgen.Outcome.CAPPED
    assert proof.surfaces == [RING, BOARD]


# --------------------------------------------------------------------------- against the engine


@pytest.mark.sampled(4)
@pytest.mark.parametrize("family", FAMILIES, ids=lambda family: family.key)
def test_a_shot_that_the_engine_does_not_flag_is_as_proved(family: Any) -> None:
    states, parameters = family.make(60)
    shots = hoopgen.simulate(states, parameters, fields=GENEROUS, record=True)
    certificate = certify(states, parameters, processes=1)
    sure = ~shots.uncertain
    assert certificate.decided[sure].all()
    for shot in np.flatnonzero(sure):
        proof = certificate[shot]
        assert shots.outcome[shot] == proof.outcome
        assert shots.events["surface"][shots.events["shot"] == shot].tolist() == proof.surfaces
    flown = sure & (shots.outcome != hoopgen.Outcome.INVALID)
    late = np.abs(shots.time - certificate.time)[flown]
    assert (late <= shots.time_error[flown] + certificate.time_radius[flown]).all()
    for name in ("contacts", "counts", "first"):
        np.testing.assert_array_equal(getattr(shots, name)[sure], getattr(certificate, name)[sure])


def test_a_flight_goes_on_from_a_recorded_contact() -> None:
    shots = hoopgen.simulate(TABLE_3["5d"], record=True)
    contact = shots.events[0]
    after, surface = contact["after"], int(contact["surface"])
    alone, going_on = (prove(after, hoopgen.PAPER, leaving=k) for k in (-1, surface))
    assert going_on.surfaces == [BOARD, BRIDGE, END]
    assert going_on.times[-1] == pytest.approx(shots.time[0] - contact["time"], rel=0, abs=1e-12)
    # Its last digits put it inside the ring, or outside.
    assert alone.outcome == hoopgen.Outcome.INVALID or alone.surfaces == going_on.surfaces


def test_processes_change_nothing() -> None:
    states = WORKLOADS[1].make(150)
    one, two = (certify(states, processes=n) for n in (1, 2))
    assert one.proofs == two.proofs


# -------------------------------------------------------------------------------------- settling


def flagged(record: bool) -> tuple[hoopgen.Shots, Any, Any]:
    """Shots some of which are flagged, and some of those undecidable."""
    random = np.random.default_rng(3)
    states = np.array([state((0.5, 0.0, 0.5), (-4.0, 0.0, 1.0))] * 12)
    states[:6, :2] = random.uniform(-0.3, 0.3, (6, 2))
    states[6:10] = state((-0.55, 0.0, 1.1875))
    states[10] = state((0.6875, 0.0, 1.0))
    parameters = SQUARE | {"restitution": np.repeat([0.5, 0.0], 6), "board_distance": 0.75}
    names = (*GENEROUS,)
    return hoopgen.simulate(states, parameters, fields=names, record=record), states, parameters


def test_doubles_are_no_further_from_the_truth_than_they_say() -> None:
    """Held in whole numbers: a radius that is rounded to nearest is too short for half of them."""
    random = np.random.default_rng(6)
    with ctx.workprec(200):
        balls = [arb(m) / 3**k for m, k in random.integers(1, 300, (trials(200), 2)).tolist()]
        nearest, radii = doubles([*balls, arb(0.1), arb(0)])
    assert radii[-2:] == [0.0, 0.0]
    for ball, near, radius in zip(balls, nearest, radii, strict=False):
        middle, spread, exponent = enclosure(ball)
        scale = Fraction(2) ** exponent
        furthest = abs(middle * scale - Fraction(near)) + spread * scale
        assert furthest <= Fraction(radius) <= furthest * (1 + Fraction(1, 2**20))


@pytest.mark.sampled(1)
@pytest.mark.parametrize("record", [False, True])
def test_settled_shots_are_as_proved(record: bool) -> None:
    shots, states, parameters = flagged(record)
    uncertain_rows = np.flatnonzero(shots.uncertain)
    assert 10 in uncertain_rows
    fields = {name: getattr(shots, name).copy() for name in GENEROUS}
    if record:
        fields["events"] = shots.events
    settled = settle(fields, states, parameters, scene=hoopgen.HOOP)
    certificate = certify(states, parameters, record=True)
    np.testing.assert_array_equal(settled, [k for k in uncertain_rows if certificate[k].decided])
    assert fields["uncertain"].sum() == len(uncertain_rows) - len(settled)
    assert len(settled)
    for name in ("outcome", "contacts", "counts", "first", "time", "state"):
        np.testing.assert_array_equal(fields[name][settled], getattr(certificate, name)[settled])
    rest = np.setdiff1d(np.arange(len(states)), settled)
    np.testing.assert_array_equal(fields["time"][rest], shots.time[rest])
    if record:
        events = fields["events"]
        assert (np.diff(events["shot"]) >= 0).all()
        for shot in settled:
            own = events[events["shot"] == shot]
            assert own["surface"].tolist() == certificate[shot].surfaces
            np.testing.assert_array_equal(own["time"], certificate[shot].times)
            np.testing.assert_array_equal(own["after"][-1], certificate.state[shot])


def test_settling_takes_parameters_by_shot(mixed: Batch) -> None:
    batch = mixed.take(slice(0, 600, 7))
    shots = hoopgen.simulate(batch.states, batch.parameters)
    fields = {name: getattr(shots, name).copy() for name in hoopgen.HOOP.layout.fields}
    fields["uncertain"][:] = True
    settled = settle(fields, batch.states, batch.parameters, scene=hoopgen.HOOP)
    sure = np.intersect1d(settled, np.flatnonzero(~shots.uncertain))
    np.testing.assert_array_equal(fields["outcome"][sure], shots.outcome[sure])
    np.testing.assert_array_equal(fields["counts"][sure], shots.counts[sure])


@pytest.mark.parametrize("scene", [hoopgen.HOOP, hoopgen.COURT])
def test_certificates_have_the_results_that_the_record_says(scene: hoopgen.Engine) -> None:
    certificate = certify([0.0, 0.0, 1.0, 0, 0, 0, 0, 0, 0], None, scene=scene)
    results = {one.name: one for one in (*scene.kernels.RESULTS, *scene.kernels.ABSENT_RESULTS)}
    known = {name for name, one in results.items() if one.is_judged or one.proved is not None}
    assert known == {name for name in results if hasattr(certificate, name)}
    assert not [name for name, one in results.items() if one.is_judged and one.proved is not None]


def test_settling_keeps_a_result_that_the_judge_does_not_know(
    mixed: Batch, monkeypatch: pytest.MonkeyPatch
) -> None:
    batch, scene = mixed.take(slice(0, 60, 7)), hoopgen.HOOP
    own = type(scene.kernels.RESULTS[0])("longest_flight", "float64", ("longest_flight",), "s")
    monkeypatch.setattr(scene.layout, "results", {**scene.layout.results, own.name: own})
    shots = hoopgen.simulate(batch.states, batch.parameters, fields=("outcome", "uncertain"))
    fields = {name: getattr(shots, name).copy() for name in ("outcome", "uncertain")}
    fields["uncertain"][:] = True
    fields[own.name] = np.arange(float(len(shots)))
    assert len(settle(fields, batch.states, batch.parameters, scene=scene))
    np.testing.assert_array_equal(fields[own.name], np.arange(float(len(shots))))


@pytest.mark.slow
def test_a_settled_shots_errors_hold_the_radius_of_each_component() -> None:
    """The largest of three: every component is within it of the truth."""
    shots, states, parameters = flagged(False)
    fields = {name: getattr(shots, name).copy() for name in GENEROUS}
    settled = settle(fields, states, parameters, scene=hoopgen.HOOP)
    radii = certify(states, parameters).state_radius[settled].reshape(-1, 3, 3)
    assert np.any(radii.min(axis=2) < radii.max(axis=2))
    assert np.all(fields["state_error"][settled][:, :, None] >= radii)


@pytest.mark.slow
def test_a_certificate_has_every_result_by_its_name() -> None:
    """Settling takes each from there, in the form that the engine gives it."""
    shots, states, parameters = flagged(False)
    certificate = certify(states, parameters)
    for name in hoopgen.HOOP.layout.results:
        given, proved = getattr(shots, name), getattr(certificate, name)
        assert (proved.dtype, proved.shape) == (given.dtype, given.shape), name


# ----------------------------------------------------------------------------------- penetration


def test_the_deepest_point_of_a_flight_is_found() -> None:
    values = [float(v) for v in hoopgen.PAPER.values()]
    reach = hoopgen.PAPER["ball_radius"] + hoopgen.PAPER["wire_radius"]
    shot = [0.26, 0.03, 0.6, 0.1, 0.05, 0.0, 0.0, 0.0, 0.0]
    times = np.linspace(0.0, 0.5, 200_001)
    x, y = shot[0] + shot[3] * times, shot[1] + shot[4] * times
    z = shot[2] - hoopgen.PAPER["gravity"] * times**2 / 2
    distance = np.hypot(np.hypot(x, y) - hoopgen.PAPER["ring_radius"], z) - reach
    depth = deepest(shot, 0.5, values)[RING]
    # Sampled every 2.5 µs the minimum of a smooth distance is 1e-10 m above the true one at most.
    assert 0.0 <= depth + distance.min() < 1e-10


def test_a_flight_between_contacts_stays_outside() -> None:
    values = [float(v) for v in hoopgen.PAPER.values()]
    path = hoopgen.simulate(TABLE_3["5d"], record=True).trajectory(0)
    starts = [path.release, *path.events["after"][:-1]]
    times = np.diff(path.events["time"], prepend=0.0)
    left = [-1, *path.events["surface"][:-1].tolist()]
    for start, duration, surface in zip(starts, times.tolist(), left, strict=True):
        assert max(deepest(start.tolist(), duration, values, surface)) < 1e-14


def test_a_face_is_entered_through_it_and_not_around_its_edge() -> None:
    values = [float(v) for v in SQUARE.values()]
    through = deepest(state((0.0, 0.0, 0.5), (-2.0, 0.0, 0.0)), 0.375, values)
    # 1/4 m past the face at the end, less than twice the ball's radius.
    assert through[BOARD] == pytest.approx(0.25, rel=0, abs=1e-12)
    above = deepest(state((0.0, 0.0, 1.5), (-2.0, 0.0, 0.0)), 0.375, values)
    assert above[BOARD] == 0.0


def test_a_ball_that_leaves_a_face_from_behind_it_is_as_deep_as_it_starts() -> None:
    """Its arrival is the start itself, which no later one tells of."""
    values = [float(v) for v in SQUARE.values()]
    depth = 2.0**-30
    leaving = state((-0.5 - depth, 0.0, 0.5), (2.0, 0.0, 0.0))
    found = deepest(leaving, 0.25, values, BOARD)[BOARD]
    assert depth <= found < depth + 1e-12


# ------------------------------------------------------------------------------------ the report


@pytest.mark.slow
def test_the_report_finds_nothing_wrong_with_the_engine() -> None:
    tallies = [exactness.tally(family, 30, 3) for family in FAMILIES[:6]]
    for tally in tallies:
        assert (tally.shots, tally.wrong, tally.unseen) == (30, 0, 0)
        assert max(tally.ratios) <= 1
        assert max(tally.depths) < 1e-14
        assert not tally.examples
    text = exactness.as_markdown(tallies)
    assert "**0** have a wrong result" in text
    assert all(family.label in text for family in FAMILIES[:6])


def test_the_section_written_by_hand_is_kept_where_it_is() -> None:
    page = (ROOT / "docs" / "exactness.md").read_text("utf-8")
    lines = section_of(page, exactness.HEADING)
    tallies = [exactness.Tally("some")]
    text = exactness.as_markdown(tallies, page)
    assert section_of(text, exactness.HEADING) == lines
    assert text.replace("\n".join(lines) + "\n", "") == exactness.as_markdown(tallies)
    headings = [line for line in page.split("\n") if line.startswith("## ")]
    assert [line for line in text.split("\n") if line.startswith("## ")] == headings


def test_the_report_would_find_a_wrong_engine(monkeypatch: pytest.MonkeyPatch) -> None:
    simulate = hoopgen.simulate

    def wrong(states: Any, parameters: Any, **options: Any) -> hoopgen.Shots:
        # An engine that takes the ring to be a millimetre wider.
        thick = {**parameters, "wire_radius": parameters["wire_radius"] + 1e-3}
        shots = simulate(states, thick, **options)
        shots.parameters = simulate(states, parameters).parameters
        return shots

    monkeypatch.setattr(hoopgen, "simulate", wrong)
    tally = exactness.tally(FAMILIES[1], 60, 20)
    assert tally.wrong > 0
    assert max(tally.ratios) > 1
    kept = {example["what"]: example for example in tally.examples}
    assert "another sequence or outcome" in kept
    released = FAMILIES[1].make(60)[0].tolist()
    for example in kept.values():
        assert [float.fromhex(component) for component in example["state"]] in released


# ------------------------------------------------------------------------------------- its manners


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"max_contacts": 0}, "max_contacts: expected a whole number from 1"),
        ({"max_bits": 64}, "max_bits: expected a whole number from 128"),
        ({"processes": 0}, "processes: expected a whole number from 1"),
    ],
)
def test_a_wrong_argument_is_said(options: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        certify(TABLE_3["5a"], **options)


def test_no_shots_are_no_proofs() -> None:
    certificate = certify(np.empty((0, 9)))
    assert len(certificate) == 0
    assert certificate.state.shape == (0, 9)
    assert certificate.counts.shape == (0, 3)


@pytest.mark.parametrize("missing", ["flint", "sympy"])
def test_a_missing_dependency_is_named_in_one_line(missing: str) -> None:
    code = (
        f"import sys; sys.modules[{missing!r}] = None\n"
        "import hoopgen\n"
        "try:\n    from hoopgen.judge import certify\n"
        "except ImportError as error:\n    print(error)"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    said = rf"certify needs {missing}: pip install (-e )?'.+\[certify\]'\n"
    assert re.fullmatch(said, run.stdout), run.stdout


def test_the_command_prints_the_proof(tmp_path: Path) -> None:
    options = ["--speed", "7.3", "--elevation", "51deg", "--distance", "13.75ft", "--height", "7ft"]
    by_options = CliRunner().invoke(command, options)
    assert by_options.exit_code == 0, by_options.output
    assert "outcome    missed" in by_options.output
    state_ = hoopgen.release(7.3, np.deg2rad(51), distance=13.75 * 0.3048, height=7 * 0.3048)
    record = {"release": state_.tolist(), "parameters": dict(hoopgen.PAPER)}
    file = tmp_path / "shot.json"
    file.write_text(json.dumps(record), encoding="utf-8")
    by_file = CliRunner().invoke(command, [str(file), "--json"])
    assert by_file.exit_code == 0, by_file.output
    proved = json.loads(by_file.output)
    assert [event["surface"] for event in proved["events"]] == ["ring", "end"]
    assert proved["events"][0]["time_s"][:20] in by_options.output


def test_the_command_admits_a_tie(tmp_path: Path) -> None:
    shot = {"release": state((0.0, 0.0, 1.1875), (-1.0, 0.0, 0.0)), "parameters": dict(SQUARE)}
    file = tmp_path / "shot.json"
    file.write_text(json.dumps(shot), encoding="utf-8")
    result = CliRunner().invoke(command, [str(file)])
    assert result.exit_code == 1
    assert "undecided  at 4096 bits" in result.output


def test_the_command_says_what_it_needs(tmp_path: Path) -> None:
    nothing = CliRunner().invoke(command, [])
    assert nothing.exit_code == 2
    assert "missing FILE, or --speed, --elevation, --height and --distance" in nothing.stderr
    file = tmp_path / "shot.json"
    file.write_text("{}", encoding="utf-8")
    wrong = CliRunner().invoke(command, [str(file)])
    assert wrong.exit_code == 1
    assert "expected what `hoopgen shot --json` writes" in wrong.output


# ------------------------------------------------------------------------ bounces that accumulate

SMALL_BALL = hoopgen.PAPER_COURT | {
    "ball_radius": 0.03,
    "bridge_half_width": 0.5,
    "bridge_restitution": 0.6,
}
ONTO_THE_BRIDGE = state((-0.308, 0.0, 0.25), (0.02, 0.0, 0.0), (0.0, 5.0, 0.0))
TO_THE_SIDE = state((-0.308, 0.0, 0.25), (0.0, 0.1, 0.0))


def on_court(shot: Any, **options: Any) -> Any:
    return certify(shot, SMALL_BALL, scene=hoopgen.COURT, record=True, **options)


@pytest.mark.slow
def test_a_proof_ends_where_bounces_accumulate_and_says_so() -> None:
    """Its impacts are those that it has proved, it has no outcome, and no more digits are tried."""
    certificate = on_court(ONTO_THE_BRIDGE)
    proof = certificate[0]
    assert not proof.decided
    assert proof.accumulates
    assert proof.outcome == UNDECIDED
    assert proof.question == (
        "the bounces on the bridge accumulate; from there the ball rolls, which the judge does "
        "not follow"
    )
    assert set(proof.surfaces) == {BRIDGE}
    assert 20 < len(proof.surfaces) < 100
    assert 0 < proof.hops < len(proof.surfaces)
    assert proof.bits < 1024
    assert certificate.accumulates.tolist() == [True]
    assert certificate.until.tolist() == [proof.times[-1]] == [proof.until]
    assert certificate.contacts[0] == len(proof.surfaces)
    assert certificate.uncertain.tolist() == [True]
    assert "0 decided, 1 until they roll" in repr(certificate)
    # The sum of a geometric series of bounces: e = 0.6, from the first impact on.
    first, second = proof.times[:2]
    assert proof.until == pytest.approx(first + (second - first) / (1 - 0.6), rel=0, abs=1e-6)


@pytest.mark.slow
def test_a_proof_agrees_with_shots_as_far_as_it_goes() -> None:
    states = np.array([ONTO_THE_BRIDGE, TO_THE_SIDE])
    shots = hoopgen.simulate(states, SMALL_BALL, scene=hoopgen.COURT, record=True)
    assert np.all(shots.rolls > 0)
    certificate = on_court(states)
    assert certificate.accumulates.all()
    assert certificate.agrees(shots).all()
    # Nothing is compared beyond the proof, and everything before it.
    fields = {
        name: getattr(shots, name)
        for name in ("outcome", "rolls", "slip_left", "releases", "scene")
    }
    for changed, agrees in ((0, False), (5, False), (None, True)):
        events = shots.events.copy()
        rows = np.flatnonzero(events["shot"] == 0)
        if changed is not None:
            events["surface"][rows[changed]] = BOARD
        uncertain = np.zeros(2, np.bool_)
        own = SimpleNamespace(**fields, events=events, uncertain=uncertain)
        assert certificate.agrees(Copy(own))[0] == agrees


def test_agreement_on_a_ball_that_slips_needs_the_field_that_says_so() -> None:
    slippery = SMALL_BALL | {"bridge_friction": 0.05}
    spun = state((-0.308, 0.0, 0.1), (0.0, 0.0, 0.0), (0.0, 60.0, 0.0))
    certificate = certify(spun, slippery, scene=hoopgen.COURT)
    assert not certificate.decided[0]
    usual = ("outcome", "uncertain")
    court: dict[str, Any] = {"scene": hoopgen.COURT, "record": True}
    shots = hoopgen.simulate(spun, slippery, fields=(*usual, "slip_left"), **court)
    assert shots.outcome[0] == hoopgen.Outcome.CAPPED
    assert not shots.uncertain[0]
    assert certificate.agrees(shots)[0]
    with pytest.raises(AttributeError, match="slip_left"):
        certificate.agrees(hoopgen.simulate(spun, slippery, fields=usual, **court))


def test_a_ball_that_another_body_throws_off_an_inclined_plane_does_not_meet_the_plane() -> None:
    """Without gravity and restitution it drifts along the plane, at the distance zero."""
    drifting = Scene(
        "drifting",
        bodies=[Plane("ramp", normal=(0, -0.4, 1)), Sphere("knob", radius=0.2, centre=(1, 0, 0))],
        ball_radius=0.05,
        gravity=0,
        restitution=0,
    )
    states = np.array([state((0, 0, 0.3), (1, y, -0.5), (0, 0, 0)) for y in (-0.05, 0.02, 0.06)])
    proofs = certify(states, scene=drifting, time_limit=5, max_contacts=5)
    assert proofs.decided.all()
    assert [proof.surfaces for proof in proofs.proofs] == [[0, 1, 2]] * 3


class Copy:
    """Shots with some results replaced."""

    def __init__(self, results: SimpleNamespace) -> None:
        self._results = results

    def __len__(self) -> int:
        return len(self._results.outcome)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._results, name)


def test_few_contacts_are_capped_and_proved_where_bounces_are_still_large() -> None:
    """The shot is given up long before the ball could roll: as in the simulation."""
    shots = hoopgen.simulate(
        ONTO_THE_BRIDGE, SMALL_BALL, scene=hoopgen.COURT, max_contacts=6, record=True
    )
    certificate = on_court(ONTO_THE_BRIDGE, max_contacts=6)
    assert certificate.decided.all()
    assert certificate.outcome[0] == shots.outcome[0] == hoopgen.COURT.outcomes["CAPPED"]
    assert certificate.agrees(shots).all()


@pytest.mark.parametrize("most", [24, 30, 36, 1000])
@pytest.mark.sampled(2)
def test_no_capped_outcome_is_proved_of_a_ball_that_rolls(most: int) -> None:
    """However many contacts there may be: one that is small may be that after which it rolls."""
    shots = hoopgen.simulate(
        ONTO_THE_BRIDGE, SMALL_BALL, scene=hoopgen.COURT, max_contacts=most, record=True
    )
    proof = on_court(ONTO_THE_BRIDGE, max_contacts=most)
    assert proof.agrees(shots).all()
    rolled = shots.events["kind"] == hoopgen.Event.ROLL
    if rolled.any():
        assert not proof.decided[0]
        assert proof[0].accumulates
    if most == 1000:
        assert rolled.any()


def test_bounces_without_a_loss_do_not_accumulate() -> None:
    """Restitution 1 keeps a small hop as it is: the contacts cap the shot, as simulated."""
    hop = state((-0.308, 0.0, 0.04 + 1e-14))
    lossless = SMALL_BALL | {"bridge_restitution": 1.0}
    shots = hoopgen.simulate(hop, lossless, scene=hoopgen.COURT, max_contacts=50, record=True)
    certificate = certify(hop, lossless, scene=hoopgen.COURT, max_contacts=50)
    assert certificate.decided.all()
    assert certificate.outcome[0] == hoopgen.COURT.outcomes["CAPPED"]
    assert certificate.agrees(shots).all()


def test_a_root_of_a_short_polynomial_is_enclosed_at_the_first_precision() -> None:
    """All of its numbers are exact, so that Newton's last step is less than the roundings."""
    pipe = Cylinder("pipe", radius=0.5, centre=(0.1, 0, 0.29), axis="x", inside=True, restitution=1)
    scene = Scene("weightless", bodies=[pipe], ball_radius=0.02, gravity=0, restitution=0)
    there = [-0.3, 0.125, 0.75, -1, -1, -1, 0, 0, 0]
    proof = certify(there, scene=scene, max_contacts=5, time_limit=5)
    assert proof.decided[0]
    assert proof.bits[0] == 128


def rolling_file(folder: Path) -> Path:
    file = folder / "rolls.json"
    record = {"release": ONTO_THE_BRIDGE, "parameters": {**SMALL_BALL}}
    told = {n: "inf" if np.isinf(v) else v for n, v in record["parameters"].items()}
    file.write_text(json.dumps({**record, "parameters": told}), encoding="utf-8")
    return file


def test_the_command_says_how_far_the_proof_of_a_ball_that_rolls_goes(tmp_path: Path) -> None:
    """The log is short and never says that an outcome is proved."""
    result = CliRunner().invoke(command, [str(rolling_file(tmp_path)), "--scene", "court"])
    assert result.exit_code == 1, result.output
    lines = result.output.splitlines()
    assert len(lines) < 25
    assert re.search(r"^14-\d+  bridge   0\.8268457\d+, all within \d+ µs$", result.output, re.M)
    assert (
        "outcome    not proved: the bounces on the bridge accumulate; from there the ball rolls, "
        "which the judge does not follow"
    ) in lines
    assert any(
        re.match(r"proved     \d+ impacts, until 0\.827657 s, with \d+ bits$", line)
        for line in lines
    )
    assert "capped" not in result.output


def test_the_command_says_so_in_json_too(tmp_path: Path) -> None:
    options = [str(rolling_file(tmp_path)), "--scene", "court", "--json"]
    result = CliRunner().invoke(command, options)
    assert result.exit_code == 1, result.output
    proved = json.loads(result.output)
    assert proved["outcome"] == "undecided"
    assert proved["accumulates"] is True
    assert proved["impacts"] == len(proved["events"])
    assert proved["until_s"] == pytest.approx(0.827657, abs=1e-6)
    assert "accumulate" in proved["question"]
