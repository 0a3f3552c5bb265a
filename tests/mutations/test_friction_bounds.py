"""Deliberate faults in the bounds on errors through friction: each trips a test of the lemma.

Terms of the second order that are small beside others with the same cause, as the tilt of a normal
beside its turn, trip the test that the code has the terms of the lemma's text. Not seen are faults
in what is small beside other terms wherever it counts:

- `FLOOR`, of all sizes beside which it counts;
- the turn of velocity and spin by the second order of the place, beside that order itself;
- the normal velocity after the impact in the norms, where restitution falls with speed.
"""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from hoopgen.derive.contact.friction import CoulombFriction
from hoopgen.derive.errors import contact_frames as frames
from hoopgen.derive.errors import friction
from hoopgen.derive.errors import tighter_bounds as tighter

pytest.importorskip("flint")

from tests.derive.errors import test_friction_growth as growth
from tests.derive.errors import test_friction_order as order
from tests.derive.errors import test_friction_roundings as roundings
from tests.helpers.checked_faults import OfFormulas, OfKernels, Planted, passing, tripping
from tests.helpers.mutants import Patch, in_text
from tests.helpers.scenes.slipping import SLIPPING

pytestmark = [pytest.mark.xdist_group("friction_mutations")]


def check(test: Any, *given: tuple[Any, ...]) -> OfKernels:
    """Return a test of the growth of errors with the kernels of a derivation."""
    return OfKernels(test, given or ((),), ((growth.__name__, "kernels"),), scene=SLIPPING)


of_roundings, of_one = (
    check(growth.test_errors_at_their_limits_stay_within_the_bounds, (bounds, growth.MANY_LAWS))
    for bounds in ("none", "one")
)
of_spin = check(
    growth.test_large_errors_of_the_spin_alone_stay_within_the_bounds, (growth.MANY_LAWS,)
)
through_many = check(
    growth.test_errors_since_an_earlier_contact_stay_within_the_tighter_bounds,
    ("many", growth.MANY_LAWS),
)
undecided = check(growth.test_where_the_contact_is_not_decided_or_hardly_slips_bounds_are_infinite)
lemma = OfFormulas(order.test_the_code_has_the_terms_of_the_lemma)
conditions = OfFormulas(order.test_where_the_code_s_condition_holds_so_do_those_of_the_lemma)
blurred = OfFormulas(order.test_what_is_within_its_roundings_is_undecided_without_any_errors)
normals = OfFormulas(order.test_a_normal_that_is_off_changes_motions_by_no_more_than_is_counted)
directions = OfFormulas(order.test_directions_that_change_by_a_fifth_are_within_the_bounds)
of_matrix = OfFormulas(growth.test_roundings_of_t_are_within_what_the_bounds_count_for_them)
of_impact = OfFormulas(roundings.test_the_impact_s_roundings_are_within_their_counts)
of_margin = OfFormulas(roundings.test_the_margin_s_roundings_are_half_of_those_that_count)
of_share = OfFormulas(roundings.test_the_count_of_the_share_is_at_most_ten_times_what_is_reached)


def in_rest(old: str, new: str) -> Patch:
    """Replace text of the terms beside |T| B."""
    return in_text(friction.FrictionImpact, "rest", old, new)


def in_law(old: str, new: str) -> Patch:
    """Replace text of the derivative of the law."""
    return in_text(friction.FrictionImpact, "law", old, new)


def in_after(old: str, new: str) -> Patch:
    """Replace text of the motion after the impact."""
    return in_text(friction.FrictionImpact, "after", old, new)


def in_property(name: str, faulty: Any) -> Patch:
    """Replace a property of the impact."""
    return lambda patch: patch.setattr(friction.FrictionImpact, name, property(faulty))


def with_constant(name: str, value: Any) -> Patch:
    """Replace a constant."""
    return lambda patch: patch.setattr(friction, name, value)


FAULTS = (
    # The derivative of the law.
    Planted(
        "a contact that slips takes the share of one that grips",
        in_law("held(self._share * one)", "held(self._grip * one)"),
        of_one,
    ),
    Planted(
        "a slip's size changes its impulse",
        in_law("-_where_it_slips(slip_share) * along - steeper", "-steeper"),
        of_one,
    ),
    Planted(
        "the normal impulse does not change friction", in_law("- steeper * pace[0]", ""), of_one
    ),
    Planted(
        "friction changes with the normal speed where a contact grips",
        in_law(
            "_where_it_slips(barrier(self.friction.friction * barrier(1 + rebound)))",
            "barrier(self.friction.friction * barrier(1 + rebound))",
        ),
        of_one,
    ),
    Planted(
        "the rebound does not change the impulse of friction",
        in_law("barrier(1 + rebound)", "sp.Integer(1)"),
        of_one,
    ),
    Planted(
        "restitution does not fall with speed",
        in_property("_rebound_slope", lambda self: self.friction.restitution),
        of_one,
    ),
    Planted(
        "what is off along the normal does not rebound",
        in_law("held(-rebound * pace[0])", "0 * pace[0]"),
        of_one,
    ),
    Planted(
        "friction does not change velocities",
        in_law("*(held(v - f) for v, f in zip(pace[1:], impulse, strict=True))", "*pace[1:]"),
        of_one,
    ),
    Planted(
        "friction does not turn the ball",
        in_law("barrier(1 + barrier(1 / self.ball.inertia))", "sp.Integer(1)"),
        of_one,
    ),
    Planted(
        "y_z across e does not come", in_law("held(left[1] * per_radius)", "0 * left[1]"), of_one
    ),
    Planted(
        "y_z along e does not come", in_law("held(-left[0] * per_radius)", "0 * left[0]"), of_one
    ),
    Planted("y_w is lost", in_law("        turn[0],\n", "        0 * turn[0],\n"), of_one),
    Planted(
        "the spin does not slide",
        in_text(
            friction.FrictionImpact,
            "_slip",
            "held(pace[1] - radius * turn[2])",
            "held(pace[1] + 0 * turn[2])",
        ),
        of_one,
    ),
    Planted(
        "a spin about s slides the wrong way",
        in_text(
            friction.FrictionImpact,
            "_slip",
            "pace[2] + radius * turn[1]",
            "pace[2] - radius * turn[1]",
        ),
        of_one,
    ),
    Planted(
        "the direction of the slip is mirrored",
        in_property(
            "_direction",
            lambda self: tuple(
                reversed(
                    frames.Frame.of(friction.normal, friction.TANGENT, friction.BENDS).of_vector(
                        friction.DIRECTION
                    )[1:]
                )
            ),
        ),
        of_one,
    ),
    Planted(
        "slips have no direction",
        in_text(CoulombFriction, "slip", "one * per_speed", "0 * one"),
        of_one,
    ),
    Planted(
        "a contact that slips counts as one that grips",
        in_text(
            friction,
            "_where_it_slips",
            "IfLess(slip_margin, 0, value, 0)",
            "IfLess(slip_margin, 0, 0, 0)",
        ),
        of_one,
    ),
    # The motion after the impact, which turns with the frame.
    Planted(
        "the ball leaves as without friction",
        in_after("barrier(moving[1] - f_s), barrier(moving[2] - f_e)", "moving[1], moving[2]"),
        of_one,
    ),
    Planted(
        "the ball leaves with the spin of before",
        in_after(
            "(turning[0], barrier(turning[1] - gives * f_e), barrier(turning[2] + gives * f_s))",
            "turning",
        ),
        of_one,
    ),
    Planted("the ball does not leave the surface", in_after("(away,", "(0 * away,"), of_one),
    # The second order.
    Planted(
        "a motion's second order does not change it",
        in_rest("        speeds\n        + bent\n", "        bent\n"),
        lemma,
    ),
    Planted(
        "the second order of a slip's impulse is lost",
        in_rest("        + bent\n        + bending", "        + bending"),
        lemma,
    ),
    Planted(
        "an impulse's second order does not turn the ball",
        in_rest("        + turning * bent\n", ""),
        lemma,
    ),
    Planted(
        "slips have no second order",
        in_rest("barrier(bent + _where_it_slips(barrier(curving + falling)))", "bent"),
        lemma,
    ),
    Planted(
        "directions have no second order",
        in_rest(
            "barrier(first + DIRECTION_SLOPE * slope * change)",
            "barrier(DIRECTION_SLOPE * slope * change)",
        ),
        lemma,
    ),
    Planted(
        "directions and normal impulses do not change at once",
        in_rest("barrier(first + DIRECTION_SLOPE * slope * change)", "first"),
        lemma,
    ),
    Planted(
        "the second order of a direction is as in a slip twice as large",
        in_rest("/ slip_speed)", "/ (2 * slip_speed))"),
        lemma,
    ),
    Planted(
        "restitution that falls has no second order of friction",
        in_rest("barrier(curving + falling)", "curving"),
        lemma,
    ),
    Planted(
        "restitution that falls has no second order",
        in_rest("        + bending * change**2\n", ""),
        lemma,
    ),
    Planted(
        "restitution has half of its bend",
        in_property("_bending", lambda self: self.friction.restitution / self.friction.falling / 2),
        lemma,
    ),
    Planted(
        "a tilt does not turn the velocity after",
        in_rest("        + ROOM * here.tilt * speed_after\n", ""),
        lemma,
    ),
    Planted(
        "a tilt does not turn the spin after",
        in_rest("        + ROOM * here.tilt * spin_after\n", ""),
        lemma,
    ),
    Planted(
        "a turn does not turn the change of the velocity",
        in_rest("        + ROOM * here.turn * barrier(change + ROOM * moved)\n", ""),
        lemma,
    ),
    Planted(
        "a turn does not turn the change of the spin",
        in_rest("        + ROOM * here.turn * barrier(twist + ROOM * turning * moved)\n", ""),
        lemma,
    ),
    Planted(
        "a velocity before does not turn",
        in_rest(
            "here.change + ROOM * here.turn * barrier(size + here.change)", "here.change + 0 * size"
        ),
        lemma,
    ),
    Planted(
        "a spin before does not turn",
        in_rest("w + ROOM * here.turn * barrier(spinning + w)", "w + 0 * spinning"),
        lemma,
    ),
    Planted(
        "velocities do not tilt",
        in_rest("ROOM * barrier(here.tilt * size + here.turn * here.change)", "0 * size"),
        lemma,
    ),
    Planted(
        "spins do not tilt",
        in_rest("barrier(ROOM * barrier(here.tilt * spinning + here.turn * w))", "0 * w"),
        lemma,
    ),
    Planted("a ball does not fall while it is late", in_rest("here.pull + ROOM", "ROOM"), lemma),
    Planted(
        "impulses do not change with the spin",
        in_rest("barrier(pace + radius * turn)", "barrier(pace + 0 * turn)"),
        lemma,
    ),
    Planted(
        "impulses do not change with the normal impulse", in_rest("+ slope * pace)", ")"), lemma
    ),
    Planted(
        "friction is twice as small",
        in_property(
            "_steepest", lambda self: self.friction.friction * (1 + self.friction.restitution) / 2
        ),
        lemma,
    ),
    Planted(
        "a direction's second order is half of what is possible",
        with_constant("DIRECTION_ORDER", sp.Rational(1, 2)),
        directions,
    ),
    Planted(
        "directions turn less than slips change",
        with_constant("DIRECTION_SLOPE", sp.Rational(1, 1)),
        directions,
    ),
    # The conditions.
    Planted(
        "a slip may be as small as its change",
        in_rest("IfLess(slip_margin, 0, small, -1)", "-1"),
        conditions,
    ),
    Planted(
        "every contact is decided",
        in_rest("maximum(excess, decided, ", "maximum(excess, "),
        conditions,
    ),
    Planted(
        "a changed slip decides nothing",
        in_rest("share * changed + steepest", "steepest"),
        conditions,
    ),
    Planted(
        "a changed normal impulse decides nothing",
        in_rest("share * changed + steepest * barrier(change + steered)", "share * changed"),
        conditions,
    ),
    Planted("a slip may change by half of it", with_constant("LARGEST_CHANGE", 2), conditions),
    Planted(
        "margins have no roundings",
        in_rest("ROOM * turned + blurred - absolute", "ROOM * turned - absolute"),
        blurred,
    ),
    Planted(
        "margins have one rounding",
        with_constant("MARGIN_ROUNDING", sp.Rational(1, 2**53)),
        of_margin,
    ),
    Planted(
        "directions of the smallest slips are known",
        in_rest("changed + LEAST_SLIP * total", "changed"),
        blurred,
    ),
    Planted("the smallest slips are proved", with_constant("LEAST_SLIP", sp.Integer(0)), undecided),
    Planted(
        "a normal that is off decides nothing",
        in_rest("+ slid)\n        small", ")\n        small"),
        normals,
    ),
    Planted(
        "a normal that is off changes no normal impulse that decides",
        in_rest("barrier(change + steered)", "change"),
        normals,
    ),
    # Normals that are off, and roundings.
    Planted(
        "a normal that is off changes no impulse of friction",
        in_rest("barrier(ROOM * barrier(share * slid + slope * steered))", "0 * slid"),
        normals,
    ),
    Planted(
        "a normal that is off changes no slip",
        in_rest("share * slid + slope * steered", "slope * steered"),
        normals,
    ),
    Planted(
        "a normal that is off changes no normal speed",
        in_rest("share * slid + slope * steered", "share * slid"),
        normals,
    ),
    Planted(
        "a spin does not slide along a normal that is off",
        in_rest("barrier(bumped + radius * spinning * off)", "bumped"),
        normals,
    ),
    Planted(
        "a velocity has no part along a normal that is off",
        in_rest("barrier(bumped + radius * spinning * off)", "barrier(radius * spinning * off)"),
        normals,
    ),
    Planted(
        "a normal that is off does not turn the rebound",
        in_rest("law + bounce * nearing * normal_rounding + rubbed", "law + rubbed"),
        normals,
    ),
    Planted(
        "a normal that is off does not change the rebound",
        in_rest("rows[0] + bounce * bumped", "rows[0]"),
        normals,
    ),
    Planted(
        "a rebound counts once",
        in_rest("bounce = barrier(1 + e_0)", "bounce = sp.Integer(1)"),
        normals,
    ),
    Planted(
        "a normal that is off does not turn the impulse's moment",
        in_rest("barrier(rubbed + share * total * off)", "rubbed"),
        normals,
    ),
    Planted(
        "a normal that is too long changes no rebound",
        in_rest("+ 2 * nearing * here.longer)", ")"),
        normals,
    ),
    Planted(
        "the law has no roundings",
        in_rest("UNIT_ROUNDOFF * barrier(MOTION_ROUNDINGS * total + pushed)", "UNIT_ROUNDOFF"),
        of_roundings,
    ),
    Planted(
        "the impulse has no roundings",
        in_rest("MOTION_ROUNDINGS * total + pushed", "MOTION_ROUNDINGS * total"),
        of_roundings,
    ),
    Planted(
        "the impulse's roundings do not turn the ball",
        in_rest("SPIN_ROUNDINGS * spinning + turning * pushed", "SPIN_ROUNDINGS * spinning"),
        of_roundings,
    ),
    Planted(
        "the impulse has no roundings of the slip",
        in_rest("SHARE_ROUNDINGS * share * total + SLOPE_ROUNDINGS", "SLOPE_ROUNDINGS"),
        of_roundings,
    ),
    Planted(
        "the impulse has no roundings of the normal speed",
        in_rest("+ SLOPE_ROUNDINGS * slope * size)", ")"),
        of_roundings,
    ),
    Planted("an impact has two roundings", with_constant("MOTION_ROUNDINGS", 2), of_impact),
    Planted("a spin has no roundings", with_constant("SPIN_ROUNDINGS", 0), of_impact),
    Planted(
        "an impulse has two roundings of the slip", with_constant("SHARE_ROUNDINGS", 2), of_share
    ),
    Planted(
        "an impulse has no roundings of the normal speed",
        with_constant("SLOPE_ROUNDINGS", 0),
        of_impact,
    ),
    Planted(
        "places have no roundings",
        in_rest("here.own[0] + here.beyond", "here.beyond"),
        of_roundings,
    ),
    Planted(
        "places around have no roundings",
        in_rest("here.own[1] + here.beyond", "here.beyond"),
        of_roundings,
    ),
    Planted(
        "roundings of the impact leave y_z alone",
        in_rest("+ twisted + across * barrier(1 / radius)", ""),
        of_roundings,
    ),
    Planted(
        "roundings of the spin leave y_z alone",
        in_rest("+ twisted + across", "+ across"),
        of_roundings,
    ),
    Planted(
        "roundings of the velocity leave y_z alone",
        in_rest("+ twisted + across * barrier(1 / radius)", "+ twisted"),
        of_roundings,
    ),
    Planted(
        "roundings of the spin leave y_w alone",
        in_rest("here.turns[0] + twisted", "here.turns[0]"),
        of_roundings,
    ),
    Planted(
        "T has no rows for y_z",
        in_text(
            frames.Growth,
            "errors_after",
            "maximum(*rolled) + rest.unrolled if rolled else rest.unrolled",
            "rest.unrolled",
        ),
        of_spin,
    ),
    Planted(
        "roundings of the flight leave velocities alone",
        in_rest("(*here.paces, *here.turns[1:])", "(0, 0, 0, 0, 0)"),
        of_roundings,
    ),
    Planted(
        "roundings of the flight leave y_z alone",
        in_rest("maximum(*rows[3:]) + twisted", "twisted"),
        of_roundings,
    ),
    Planted(
        "roundings of the flight leave y_w alone",
        in_rest("here.turns[0] + twisted", "twisted"),
        of_roundings,
    ),
    Planted(
        "the spin's own roundings do not count",
        in_rest("SPIN_ROUNDINGS * spinning + turning * pushed", "turning * pushed"),
        of_roundings,
    ),
    Planted(
        "velocities in T have no roundings",
        in_rest("T_ROUNDING * barrier(paced + products)", "0 * paced"),
        of_matrix,
    ),
    Planted(
        "spins in T have no roundings",
        in_rest("T_ROUNDING * barrier(spun + turning * products)", "0 * spun"),
        of_matrix,
    ),
    Planted("T has a few roundings", with_constant("T_ROUNDING", sp.Rational(1, 2**24)), of_matrix),
    Planted(
        "T has no columns for y_z",
        in_text(frames, "growth", "(still, still, across)", "(still, still, still)"),
        of_spin,
    ),
    Planted(
        "y_z does not come to the errors since an earlier contact",
        in_text(tighter, "tighter_errors", "*rounded, BOUNDS[-1], BOUNDS[-1])", "*rounded, 0, 0)"),
        through_many,
    ),
)

test_a_fault_trips_its_check = tripping(FAULTS)
test_without_a_fault_the_checks_pass = passing(FAULTS)
