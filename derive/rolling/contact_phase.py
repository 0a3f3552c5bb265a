"""The kernels of the contact phase that all surfaces share, and the decisions that count and name.

A ball begins to roll, rolls step by step, and leaves, rests or ends its shot.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from ..contact.ball import Ball
from ..errors.propagation import flight_start
from ..events.predicates import clear, index, last, undecided_time, when, which
from ..ir.kernel import Kernel, decision, loop_kernel
from ..motion import rolling_series
from ..motion.flight import Flight
from ..state.fields import IN_FLIGHT, NONE
from ..symbolic.conditionals import (
    AtMost,
    Boolean,
    Choose,
    Equal,
    Less,
    Not,
    Or,
    all_of,
    any_of,
    barrier,
    false,
)
from ..symbolic.error_terms import clock, contacts, earliest_delay, left_normal
from ..symbolic.rounding import position_error, velocity_error
from ..symbolic.symbols import normal
from .apex import apex_kernels
from .bounds import bounds_kernels
from .departure import departure_kernels
from .edges import edge_kernels, falls_off, successor
from .events import step_events
from .jump import jump_kernels
from .meeting import meeting_kernels
from .neighbour import neighbour_kernels
from .settling import settling_kernels
from .start import one_of, start_kernels
from .symbols import (
    BEGINS,
    FALLS_OFF,
    LEAVES,
    ROLLS,
    STARTS,
    EventCodes,
    assured,
    began,
    body,
    edge,
    ends,
    gap,
    gap_jerk,
    gap_snap,
    goes_on,
    held,
    lift,
    lodges,
    mode,
    most_contacts,
    nearly,
    outcome,
    reached,
    rests,
    rolls,
    settles,
    slides,
    uncertain,
    undecided,
    unpressed,
)

_BOUNDED = all_of(Less(position_error, sp.oo), Less(velocity_error, sp.oo))
"""True if the errors have bounds: they are no number if they have none."""


def kernels(
    flight: Flight,
    ball: Ball,
    faces: Sequence[int],
    codes: EventCodes,
    outcomes: Mapping[str, int],
    holders: Sequence[int],
    edges: bool = False,
    bounded: bool = False,
    oblique: bool = False,
    revolved: bool = False,
    tori: Sequence[int] = (),
) -> dict[str, Kernel]:
    """Return the kernels of the contact phase that all surfaces share.

    Parameters
    ----------
    flight
        The motion between contacts.
    ball
        The ball.
    faces
        The body of each surface.
    codes
        The indices of events in contact.
    outcomes
        The number of each outcome, by name.
    holders
        The indices of the surfaces that a ball can roll on, in order.
    edges
        True if a ball may roll off an edge of a surface.
    bounded
        True if the errors of the jump to the end of the bounces follow from the last bounce.
    oblique
        True if a ball may roll on a tube that lies along no axis.
    revolved
        True if a ball may roll on a cone or a torus, in the coordinates of the scene.
    tori
        The indices of those surfaces among `holders` that are about an axis and have no edge.
    """
    gravity = barrier(flight.gravity)
    every_kernel = (
        *_series(flight, ball, gravity, oblique, revolved),
        *settling_kernels(flight, gravity, ball, oblique, revolved),
        *jump_kernels(flight, ball, bounded, revolved),
        *step_events(gravity, ball.radius, codes, flight.surface_force, edges),
        *departure_kernels(flight, gravity, ball, edges, oblique),
        *bounds_kernels(ball.radius),
        *meeting_kernels(ball.radius, codes),
        *edge_kernels(flight, ball, codes),
        *(apex_kernels(ball.radius, codes) if revolved else ()),
        *neighbour_kernels(ball.radius, revolved),
        *start_kernels(holders, ball, flight.strength),
        *_flight_decisions(edges, not flight.exact),
        *_contact_decisions(codes, edges, oblique, revolved, tori),
        *_results(faces, codes, outcomes, edges, revolved),
    )
    return {kernel.name: kernel for kernel in every_kernel}


def _series(
    flight: Flight, ball: Ball, gravity: sp.Expr, oblique: bool, revolved: bool
) -> tuple[Kernel, ...]:
    """Return the kernels of the power series of rolling."""
    acceleration = flight.acceleration
    orders = (
        loop_kernel(
            f"roll_{k}",
            rolling_series.next_terms(k, acceleration, ball, oblique, revolved),
            f"Coefficients of order {k + 1} of a rolling ball, from those of lower order.",
            "Newton, Euler and rolling without slip",
        )
        for k in range(rolling_series.ORDER)
    )
    return (
        *orders,
        decision(
            "other_start_surface",
            {str(n): 0 for n in left_normal},
            "Start value of the normal where the flight began: another surface.",
        ),
        loop_kernel(
            "started", flight_start(flight), "Position at the start of a flight.", flight.source
        ),
        loop_kernel(
            "roll_start",
            rolling_series.start(ball, revolved),
            "Constant terms of the series.",
            "rolling",
        ),
        loop_kernel(
            "roll_moved",
            rolling_series.moved(),
            "Position, velocity and turn rate of a rolling ball at time t.",
            "its series",
        ),
        loop_kernel(
            "roll_placed",
            rolling_series.placed(ball),
            "State of a ball put onto the surface, rolling.",
            "v = R_B (w × n)",
        ),
        loop_kernel(
            "roll_step",
            rolling_series.step(acceleration, gravity, ball, flight.surface_force, revolved),
            "Length of a step of the series, bounds of the motion in it, and the normal force.",
            "the last terms of the series",
        ),
    )


def _flight_decisions(edges: bool, tested: bool) -> tuple[Kernel, ...]:
    """Return the decisions that keep balls in contact out of the searches of flights.

    `tested` is true of a flight whose tests of bodies are truths.
    """
    return (
        decision(
            "in_contact",
            {
                "in_contact": Less(0, mode),
                "when": Choose(Less(0, mode), 0, when),
                "rests": false,
                "rolling": false,
                "began": 0,
                **({str(successor): NONE} if edges else {}),
            },
            "Whether the ball is in contact, and has no flight to search.",
        ),
        decision(
            "open_in_flight" if tested else "opens_in_flight",
            {
                "open": all_of(
                    Boolean("open") if tested else Not(Less(0, clear)), Not(Boolean("in_contact"))
                )
            },
            "Whether a ball in flight may hit a surface.",
        ),
        decision(
            "reachable_in_flight",
            {"reachable": all_of(Boolean("reachable"), Not(Boolean("in_contact")))},
            "Whether a ball in flight may reach the box of a surface.",
        ),
    )


def _contact_decisions(
    codes: EventCodes, edges: bool, oblique: bool, revolved: bool, tori: Sequence[int]
) -> tuple[Kernel, ...]:
    """Return the decisions that open a turn in contact and tell which surface holds the ball."""
    leaves, falls = Equal(mode, LEAVES), Equal(mode, FALLS_OFF)
    ending = {"leaves": Or(leaves, falls), str(falls_off): falls} if edges else {"leaves": leaves}
    curved = sum(rolling_series.across, ()) if oblique else rolling_series.bent
    if revolved:
        curved += rolling_series.REVOLVED
    return (
        decision(
            "resumed",
            {
                "which": Choose(Equal(mode, STARTS), last, NONE),
                "earliest_delay": 0,
                "began": clock,
                "undecided_time": Choose(_BOUNDED, sp.oo, 0),
                "begins": Equal(mode, BEGINS),
                "rolling": Equal(mode, ROLLS),
                **ending,
                **{str(s): 0 for s in (*normal, gap, *curved, lift, gap_jerk, gap_snap)},
                str(rolling_series.per_reach): 0,
            },
            "Start values of a turn in contact: no event yet, and the surface that the ball is on.",
        ),
        decision(
            "contact_undecided",
            {
                "uncertain": Choose(
                    all_of(
                        Or(
                            all_of(
                                Not(Less(when + earliest_delay, undecided_time)),
                                Less(undecided_time, sp.oo),
                            ),
                            edge,
                        ),
                        Not(all_of(Less(0, assured), Equal(which, last), _BOUNDED)),
                    ),
                    1,
                    uncertain,
                )
            },
            "1 if a decision lies within its error, unless that only delays bounces on a surface.",
        ),
        decision("holding", {"here": Equal(held, index)}, "Whether the ball stays on a surface."),
        decision(
            "beside",
            {"beside": Not(Equal(held, index))},
            "Whether a surface is another than the one that the ball stays on.",
        ),
        decision(
            "other_surface",
            {"beside": Not(Equal(which, index))},
            "Whether a surface is another than that of the event.",
        ),
        decision(
            "beside_edgeless",
            {
                "beside": all_of(Not(Equal(held, index)), Not(one_of(held, tori))),
                "comes_over": all_of(Not(Equal(held, index)), one_of(held, tori)),
            },
            "The same, of a ball on a surface that may have edges, and of one on a torus.",
        ),
        decision("no_departure", {"hopped": false}, "Start value: the ball has not departed."),
        decision(
            "stays_put",
            {"moves": all_of(Boolean("moves"), Less(0, when))},
            "Whether a ball in contact flies: its step is behind it, and so are a flight's terms.",
        ),
        decision(
            "beginning_contact",
            {"which": codes.begins, "circled": 0},
            "Event: the contact begins.",
        ),
        decision("detachment", {"which": codes.hops}, "Event: the ball is off the surface."),
    )


def _results(
    faces: Sequence[int],
    codes: EventCodes,
    outcomes: Mapping[str, int],
    edges: bool,
    revolved: bool,
) -> tuple[Kernel, ...]:
    """Return the decisions that record what has happened to a ball in contact."""
    lodged, capped = outcomes["lodged"], outcomes["capped"]
    own: sp.Expr = sp.Integer(NONE)
    for face, of in enumerate(faces):
        own = Choose(Equal(held, face), of, own)
    begins, leaves, hops = (Equal(which, code) for code in (codes.begins, codes.leaves, codes.hops))
    beyond, endless = Less(codes.time, which), Equal(which, codes.endless)
    stuck = all_of(goes_on, AtMost(clock - began, sp.Rational(1, 2**24)))
    given_up: sp.Basic = endless
    if revolved:
        at_apex = Equal(which, codes.apex)
        stuck, given_up = Or(stuck, at_apex), Or(endless, at_apex)
    ending = Choose(leaves, LEAVES, 0)
    holds = Choose(any_of(begins, leaves, goes_on), held, NONE)
    released = leaves
    counts: dict[str, sp.Basic] = {}
    if edges:
        past = Equal(which, codes.over_edge)
        taken = all_of(past, Not(Less(successor, 0)))
        ending = Choose(past, Choose(Less(successor, 0), FALLS_OFF, BEGINS), ending)
        holds = Choose(taken, successor, Choose(any_of(begins, leaves, past, goes_on), held, NONE))
        released = Or(leaves, past)
        # A ball may pass on from surface to surface for ever: that counts as contacts do.
        counts = {"contacts": Choose(taken, contacts + 1, contacts)}
        spent = all_of(taken, AtMost(most_contacts, contacts + 1))
    starts = Equal(mode, STARTS)
    asked = Or(nearly, Not(starts))  # a ball that starts with a speed off the surface flies
    following = Choose(Or(begins, goes_on), ROLLS, Choose(starts, STARTS, ending))
    ongoing = Choose(any_of(beyond, goes_on, starts), IN_FLIGHT, reached)
    if edges:
        ongoing = Choose(spent, capped, ongoing)
    return (
        decision(
            "stay_in_contact",
            {
                "body": Choose(
                    begins,
                    codes.log_row(own, False),
                    Choose(
                        released,
                        codes.log_row(own, True),
                        Choose(hops, NONE, Choose(given_up, codes.bodies, body)),
                    ),
                ),
                "reached": Choose(
                    stuck,
                    capped,
                    Choose(
                        endless,
                        outcomes["endless"],
                        Choose(rests, lodged, ongoing),
                    ),
                ),
                "undecided_time": Choose(stuck, 0, undecided_time),
                "ends": all_of(ends, Not(beyond)),
                "hopped": hops,
                "last": Choose(hops, NONE, last),
                "mode": following,
                "held": holds,
                **counts,
                "rolls": Choose(begins, rolls + 1, rolls),
            },
            "Log entry, outcome and mode of a ball in contact after a turn.",
        ),
        decision(
            "settled",
            {
                "mode": Choose(nearly, Choose(settles, BEGINS, Choose(unpressed, LEAVES, 0)), 0),
                "held": Choose(all_of(nearly, Or(settles, unpressed)), index, NONE),
                "outcome": Choose(
                    all_of(nearly, Or(lodges, slides), Less(outcome, 0)),
                    Choose(lodges, lodged, capped),
                    outcome,
                ),
                "slip_left": Choose(all_of(nearly, slides), 1, 0),
                "uncertain": Choose(
                    any_of(lodges, all_of(undecided, asked), all_of(nearly, Not(_BOUNDED))),
                    1,
                    uncertain,
                ),
            },
            "Whether the ball stays on the surface, slides, leaves, or is wedged.",
        ),
    )
