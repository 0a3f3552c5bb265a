"""Deliberate faults in the proofs of batches: in each term of a bound, and in decisions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

pytest.importorskip("flint")

from hoopgen.judge import (
    ball_array,
    batch_flight,
    batch_proofs,
    earliest,
    error_set_array,
    first_events,
    first_roots,
    flight,
    model_array,
)
from hoopgen.judge.ball_array import BallArray
from hoopgen.judge.model_array import ModelArray
from tests.helpers.checked_faults import OfFormulas, Planted, passing, tripping
from tests.helpers.mutants import in_text
from tests.judge import (
    test_ball_array,
    test_batch_flight,
    test_first_roots,
    test_model_array,
    test_single_proofs,
)

pytestmark = pytest.mark.xdist_group("batch_mutations")


def each(test: Callable[..., None], *arguments: Any) -> OfFormulas:
    return OfFormulas(test, tuple((argument,) for argument in arguments) or ((),))


in_balls = each(
    test_ball_array.test_results_hold_the_exact_ones_of_all_numbers_in_the_balls, "+", "*", "/"
)
root_of_balls = each(test_ball_array.test_roots_hold_the_exact_ones_of_all_numbers_in_the_balls)
ends_of_balls = each(
    test_ball_array.test_signs_sizes_and_ends_are_those_of_all_numbers_in_the_balls
)
in_models = each(test_model_array.test_results_are_of_the_models_for_the_same_causes, "+", "*", "/")
midpoints = each(
    test_model_array.test_midpoints_are_exact_but_for_their_bound_where_low_parts_cancel, "+", "*"
)
underflow = each(test_model_array.test_products_that_underflow_are_held)
root_of_models = each(test_model_array.test_roots_are_of_the_models_for_the_same_causes)
balls_of_models = each(test_model_array.test_balls_of_models_hold_them)
error_set = each(test_model_array.test_an_error_set_holds_all_numbers_of_the_models)
skewed = each(
    test_model_array.test_an_error_set_whose_sides_are_not_quite_orthogonal_holds_them_too
)
several = each(test_first_roots.test_the_first_of_several_roots_is_isolated)
close = each(test_first_roots.test_roots_that_are_too_close_are_left_open_and_none_is_missed)
touch = each(test_first_roots.test_an_exact_touch_is_left_open)
hardly_known = each(test_first_roots.test_coefficients_that_are_hardly_known_decide_nothing)
planes = OfFormulas(
    test_first_roots.test_arrivals_at_planes_are_those_of_exact_arithmetic,
    ((False, False), (True, False), (True, True)),
)
exact = each(
    test_batch_flight.test_an_exact_tie_touch_or_edge_is_never_proved_at_once,
    *test_batch_flight.EXACT,
)
article = each(
    test_batch_flight.test_the_article_s_shots_are_proved_at_once, *test_batch_flight.TABLE_3
)
limits = each(test_batch_flight.test_shots_that_may_last_until_the_time_limit_are_proved_singly)
known = each(test_batch_flight.test_final_times_and_states_are_known_to_more_than_a_double_s_digits)
invalid = each(
    test_batch_flight.test_what_is_invalid_has_no_end_or_no_restitution_is_left_to_others
)
again = each(
    test_single_proofs.test_events_that_are_known_are_found_again_with_more_digits, "hoop", "court"
)
left_out = each(test_single_proofs.check_bodies_that_are_left_out)


def _open_parts_have_no_root(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(first_roots, "MAX_PARTS", 10**6)
    in_text(first_roots, "first_roots", "undecided[rows] = True", "pass")(patch)


def _all_is_known(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(batch_flight, "LARGEST_ERROR", 1.0)
    in_text(batch_proofs, "_well_known", "KNOWN * sizes", "sizes")(patch)


ADD, MUL, DIV = "__add__", "__mul__", "__truediv__"

FAULTS = (
    Planted(
        "a sum of balls has the radius of one",
        in_text(BallArray, ADD, "self.radius + b.radius", "self.radius"),
        in_balls,
    ),
    Planted(
        "a product of balls has no radius of the second factor",
        in_text(BallArray, MUL, "np.abs(self.middle) * b.radius + ", ""),
        in_balls,
    ),
    Planted(
        "a product of balls has no radius of the first factor",
        in_text(BallArray, MUL, "(np.abs(b.middle) + b.radius)", "b.radius"),
        in_balls,
    ),
    Planted(
        "a product of balls has no product of radii",
        in_text(BallArray, MUL, "(np.abs(b.middle) + b.radius)", "np.abs(b.middle)"),
        in_balls,
    ),
    Planted(
        "a quotient of balls has no radius of the divisor",
        in_text(BallArray, DIV, "self.radius + np.abs(quotient) * b.radius", "self.radius"),
        in_balls,
    ),
    Planted(
        "a quotient of balls has no radius of the dividend",
        in_text(BallArray, DIV, "self.radius + np.abs", "np.abs"),
        in_balls,
    ),
    Planted(
        "what divides balls is as large as its midpoint",
        in_text(BallArray, DIV, "b.least_size()", "np.abs(b.middle)"),
        in_balls,
    ),
    Planted(
        "results of balls are not rounded",
        in_text(ball_array, "_rounded", " + UNIT * np.abs(middle)", ""),
        in_balls,
    ),
    Planted(
        "radii are not rounded outwards",
        in_text(ball_array, "_rounded", " * OUTWARDS", ""),
        in_balls,
    ),
    Planted("balls do not underflow", in_text(ball_array, "_rounded", " + TINY", ""), in_balls),
    Planted(
        "the root of a ball is as steep as that of its midpoint",
        in_text(BallArray, "sqrt", "self.radius / root", "self.radius / (2 * root)"),
        root_of_balls,
    ),
    Planted(
        "the root of a ball that holds zero is that of its midpoint at most",
        in_text(BallArray, "sqrt", "self.size()", "np.abs(self.middle)"),
        root_of_balls,
    ),
    Planted(
        "the upper end of a ball is not rounded up",
        in_text(BallArray, "upper", "ENDS * np.abs(self.middle) + ", ""),
        ends_of_balls,
    ),
    Planted(
        "the lower end of a ball is not rounded down",
        in_text(BallArray, "lower", "ENDS * np.abs(self.middle) + ", ""),
        ends_of_balls,
    ),
    Planted(
        "the least size of a ball is not rounded inwards",
        in_text(BallArray, "least_size", " * INWARDS", ""),
        ends_of_balls,
    ),
    Planted(
        "the low parts of a sum are added without rounding",
        in_text(ModelArray, ADD, "np.abs(t) + np.abs(m)", "np.abs(m)"),
        midpoints,
    ),
    Planted(
        "the low part of a sum is not rounded",
        in_text(ModelArray, ADD, "np.abs(t) + np.abs(m)", "np.abs(t)"),
        midpoints,
    ),
    Planted(
        "slopes of a sum are not rounded",
        in_text(ModelArray, ADD, "SLOPE * (self.spread + b.spread)", "0.0"),
        in_models,
    ),
    Planted(
        "the second low part of a product is not rounded",
        in_text(ModelArray, MUL, "np.abs(f) + np.abs(g)", "np.abs(g)"),
        midpoints,
    ),
    Planted(
        "the first low part of a product is not rounded",
        in_text(ModelArray, MUL, "np.abs(f) + np.abs(g)", "np.abs(f)"),
        midpoints,
    ),
    Planted(
        "the low part of a product is not rounded",
        in_text(ModelArray, MUL, " + np.abs(m)", ""),
        midpoints,
    ),
    Planted(
        "a product of models has no radius times the other midpoint",
        in_text(ModelArray, MUL, "(other_size + b.spread", "(b.spread"),
        in_models,
    ),
    Planted(
        "a product of models has no radius times the other slopes",
        in_text(ModelArray, MUL, "(other_size + b.spread", "(other_size"),
        in_models,
    ),
    Planted(
        "a product of models has no product of radii",
        in_text(ModelArray, MUL, "b.spread + b.radius)", "b.spread)"),
        in_models,
    ),
    Planted(
        "a product of models has no midpoint times the other radius",
        in_text(ModelArray, MUL, "(size + self.spread)", "self.spread"),
        in_models,
    ),
    Planted(
        "a product of models has no slopes times the other radius",
        in_text(ModelArray, MUL, "(size + self.spread)", "size"),
        in_models,
    ),
    Planted(
        "a product of models has no product of slopes",
        in_text(ModelArray, MUL, "(SLOPE * other_size + b.spread)", "(SLOPE * other_size)"),
        in_models,
    ),
    Planted(
        "the first slopes of a product are not rounded",
        in_text(ModelArray, MUL, "(SLOPE * other_size + b.spread)", "b.spread"),
        in_models,
    ),
    Planted(
        "the second slopes of a product are not rounded",
        in_text(ModelArray, MUL, "SLOPE * size * b.spread", "0.0"),
        in_models,
    ),
    Planted(
        "a quotient of models has no residue",
        in_text(ModelArray, DIV, "error = (", "error = 0.0 * ("),
        in_models,
    ),
    Planted(
        "what divides models is as large as its midpoint",
        in_text(ModelArray, DIV, "b.balls().least_size()", "np.abs(b.high)"),
        in_models,
    ),
    Planted(
        "a root of models has no residue",
        in_text(ModelArray, "sqrt", "error = (", "error = 0.0 * ("),
        root_of_models,
    ),
    Planted("models do not underflow", in_text(model_array, "_outwards", " + TINY", ""), underflow),
    Planted(
        "the balls of models have no low part",
        in_text(ModelArray, "away", "np.abs(self.low) + ", ""),
        balls_of_models,
    ),
    Planted(
        "the errors of models have no slopes",
        in_text(ModelArray, "errors", "self.spread + ", ""),
        balls_of_models,
    ),
    Planted(
        "the sizes of models have no slopes",
        in_text(ModelArray, "size", "self.spread + ", ""),
        balls_of_models,
    ),
    Planted(
        "an error set has no slopes",
        in_text(error_set_array, "condensed", "lengths = onto + ", "lengths = "),
        error_set,
    ),
    Planted(
        "an error set has no radii",
        in_text(
            error_set_array,
            "condensed",
            'onto + np.einsum("kin,kn->in", np.abs(sides), radii)',
            "onto",
        ),
        error_set,
    ),
    Planted(
        "the sides of an error set are orthogonal",
        in_text(error_set_array, "condensed", "2 * skew", "0.0 * skew"),
        skewed,
    ),
    Planted(
        "coefficients are known exactly",
        in_text(
            first_roots, "_bernstein", "error = radii.sum(axis=0) + roundings", "error = roundings"
        ),
        hardly_known,
    ),
    Planted(
        "Bernstein coefficients are not rounded",
        in_text(first_roots, "_bernstein", "radii.sum(axis=0) + roundings", "radii.sum(axis=0)"),
        close,
    ),
    Planted(
        "two unknown signs make one change",
        in_text(first_roots, "first_roots", ">= degree)", ">= degree - 1)"),
        close,
    ),
    Planted("parts that stay undecided have no root", _open_parts_have_no_root, touch),
    Planted(
        "flights with too many undecided parts have no root",
        in_text(first_roots, "first_roots", "~(found | undecided)", "~found"),
        touch,
    ),
    Planted(
        "the first part with a root that is seen has the first root",
        in_text(first_roots, "first_roots", " & (place * share < low[rows])", " & ~found[rows]"),
        close,
    ),
    Planted(
        "a parabola that nearly touches a plane meets it",
        in_text(
            first_roots,
            "plane_arrivals",
            "squared.positive() & time.positive())\n    never",
            "time.positive())\n    never",
        ),
        planes,
    ),
    Planted(
        "an arrival at a plane may be in the past",
        in_text(
            first_roots,
            "plane_arrivals",
            "squared.positive() & time.positive())\n    never",
            "squared.positive())\n    never",
        ),
        planes,
    ),
    Planted(
        "a plane that is met has been met",
        in_text(first_roots, "plane_arrivals", " & time.negative())", ")"),
        planes,
    ),
    Planted(
        "a ball that hardly moves along the normal never meets a plane",
        in_text(first_roots, "plane_arrivals", "never = b.positive()", "never = ~b.negative()"),
        planes,
    ),
    Planted(
        "what is met at the same time does not matter",
        in_text(batch_flight, "first_events", "(earliest > until)", "(earliest > 0)"),
        exact,
    ),
    Planted(
        "a plane is not met where one of its bounds is open",
        in_text(first_events, "_candidates", "rows[outside]", "rows[~inside]"),
        exact,
    ),
    Planted(
        "a plane is met where none of its bounds is certainly broken",
        in_text(first_events, "_candidates", "rows[inside]", "rows[~outside]"),
        exact,
    ),
    Planted(
        "on a return the place where the flight began is a contact",
        in_text(
            first_events,
            "_candidates",
            "returns = flights.last == k",
            "returns = flights.last < -1",
        ),
        article,
    ),
    Planted(
        "the second end is reached where the first is open",
        in_text(batch_flight, "_crossing_outcome", "passed_by &= outside", "passed_by &= ~inside"),
        exact,
    ),
    Planted(
        "time limits do not end shots",
        in_text(
            batch_flight, "_next_event", "clock.balls().upper() < time_limit", "clock.radius < 1"
        ),
        limits,
    ),
    Planted("a shot's end is known well enough whatever its errors are", _all_is_known, known),
    Planted(
        "a ball may start inside a body",
        in_text(batch_flight, "surely_valid", "sure &= np.any", "np.any"),
        invalid,
    ),
    # Short cuts of single proofs.
    Planted(
        "of the events that are known the one before is meant",
        in_text(flight, "_follow", "known[len(flown.events)]", "known[len(flown.events) - 1]"),
        again,
    ),
    Planted(
        "a body is missed that is at the start",
        in_text(earliest, "_reached", "-_float_below(-latest)", "2.0**-20"),
        left_out,
    ),
    Planted(
        "a part is left out within whose bounds the ball may come",
        in_text(earliest, "_reached", "is not False", "is True"),
        left_out,
    ),
)

test_without_a_fault_every_check_passes = passing(FAULTS)
test_a_fault_trips_its_check = tripping(FAULTS)
