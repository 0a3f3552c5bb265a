"""The premises of the derivation page, and the kernels that rest on each of them.

The prose is in the template, under the same keys; a kernel's formulas stand below the premise
that it rests on.
"""

from __future__ import annotations

from dataclasses import dataclass

LEMMA, CHOICE, DEFINITION = "Lemma", "Choice", "Definition"
"""A lemma is proved on the page; a choice is made and tested; a definition gives a word its
meaning."""


@dataclass(frozen=True)
class Premise:
    """A premise of the page.

    Attributes
    ----------
    kind
        `LEMMA`, `CHOICE` or `DEFINITION`.
    title
        Its subject.
    kernels
        The kernels that rest on it, by kind and part, such as ``ring.advance``; ``*`` as the kind
        stands for every kind, and at the end for all parts that begin so.
    beside
        For a premise without kernels: the key of the premise that it is shown with; "": always.
    proved
        True for a premise of scenes whose errors have proved bounds alone, False for one of the
        other scenes; None: of all.
    """

    kind: str
    title: str
    kernels: tuple[str, ...] = ()
    beside: str = ""
    proved: bool | None = None


def _kernels(text: str) -> tuple[str, ...]:
    return tuple(text.split())


PREMISES: dict[str, Premise] = {
    # A flight through air
    "air_motion": Premise(
        DEFINITION,
        "motion through air, and its series",
        _kernels("common.air_rates common.air_order_* common.air_short common.air_tail"),
    ),
    "piece_length": Premise(CHOICE, "length of a piece", beside="piece_remainder"),
    "piece_remainder": Premise(
        LEMMA,
        "what the series of a piece leaves out",
        _kernels("common.piece common.piece_excess"),
    ),
    # Definitions, and planes
    "geometry": Premise(
        DEFINITION,
        "flight, surfaces and contact frame",
        _kernels(
            "common.flight common.contact_frame *.coefficients *.deflated *.normal *.bounds *.place"
        ),
    ),
    "start": Premise(
        DEFINITION,
        "which shots can start",
        _kernels(
            "common.allowed common.parameters_in_range common.state_in_range common.valid "
            "common.aside *.start common.admitted common.starts_on_body common.left_surface"
        ),
    ),
    "plane_first": Premise(
        LEMMA,
        "the only arrival on a plane",
        _kernels("plane.arrival end.arrival common.plane_root common.level_root common.graze_*"),
    ),
    "impact": Premise(
        DEFINITION,
        "contacts",
        _kernels("law.impact law.taken *.taken common.impact_through_frame common.other_kind"),
    ),
    "law_undecided": Premise(LEMMA, "grip or slip", _kernels("law.undecided common.undecided")),
    # Rounding
    "rounding": Premise(
        LEMMA, "running error", _kernels("common.scale common.measure common.begun_with")
    ),
    "flight_rounding": Premise(LEMMA, "rounding of a flight"),
    "plane_margin": Premise(
        CHOICE, "margin of a plane", _kernels("plane.margin end.margin *.start_side")
    ),
    "displacement": Premise(
        LEMMA, "error of a length at a computed arrival", _kernels("common.displacement")
    ),
    # The search from the left
    "from_left": Premise(LEMMA, "a parabola from below", beside="one_root"),
    "first_root": Premise(
        LEMMA, "the first root of that parabola, without cancellation", beside="one_root"
    ),
    "bernstein": Premise(LEMMA, "a bound from Bernstein coefficients", beside="general"),
    "one_root": Premise(
        LEMMA,
        "existence of one simple root, and convergence of Newton's method",
        _kernels("common.refined_* common.found common.arrival_time common.candidate *.refine"),
    ),
    "crossing": Premise(
        LEMMA,
        "a certain crossing, and its delay",
        _kernels(
            "common.crossing common.crossing_undecided common.arrival_certainty "
            "common.return_certainty"
        ),
    ),
    "deflation": Premise(
        LEMMA, "deflation after a contact", _kernels("common.left* common.nearby common.own_margin")
    ),
    "ending": Premise(
        CHOICE,
        "end and error budget of a search",
        _kernels(
            "common.missed common.opens common.allowance common.beginning common.gap_closes "
            "common.gap_closes_or_stalls common.smaller_budget common.budget_undecided "
            "common.advanced common.outside common.gap_closes_bounded common.passed common.behind"
        ),
    ),
    # The ring
    "ring_bend": Premise(LEMMA, "second derivative of the ring's gap", beside="ring_windows"),
    "ring_windows": Premise(
        LEMMA, "three windows hold every contact", _kernels("ring.enter ring.prepare")
    ),
    "ring_curvature": Premise(
        LEMMA, "bounds on the second derivative within a window", _kernels("ring.advance")
    ),
    "ring_margins": Premise(LEMMA, "the ring's margins", _kernels("ring.margins ring.excess")),
    "ring_clear": Premise(
        LEMMA, "a certain miss of the ring", _kernels("ring.clear ring.drops_through")
    ),
    "single": Premise(
        CHOICE,
        "the ring's search in single precision",
        _kernels(
            "ring.opened ring.started ring.resolution ring.step ring.budget_exceeded "
            "ring.coarse_excess common.opened common.coarse common.stepped"
        ),
    ),
    # Boxes and other surfaces
    "box_windows": Premise(
        LEMMA,
        "windows of a box, and the time to leave it",
        _kernels("box.prepare box.enter general.prepare general.enter general.clear"),
    ),
    "box_bend": Premise(
        LEMMA,
        "second derivative of a box's gap",
        _kernels("box.advance box.margins air_box.advance air_box.margins"),
    ),
    "general": Premise(LEMMA, "any other surface", _kernels("general.advance general.margins")),
    # Along a piece of a flight through air
    "piece_windows": Premise(
        LEMMA,
        "pieces that come near a surface",
        _kernels(
            "air.prepare air.enter air.open air_box.prepare air_box.enter "
            "air_ring.prepare air_ring.enter air_ring.open"
        ),
    ),
    "piece_bend": Premise(
        LEMMA,
        "second and third derivative of a gap along a piece",
        _kernels("air.advance air.margins"),
    ),
    "piece_ring": Premise(
        LEMMA,
        "second derivative of the ring's gap along a piece",
        _kernels("air_ring.advance air_ring.margins"),
    ),
    "piece_sketch": Premise(
        CHOICE,
        "the ring's search along a sketch of a piece",
        _kernels("*.sketch* common.unsketched common.landing"),
    ),
    # The first event
    "within": Premise(
        LEMMA,
        "bounds at an arrival",
        _kernels("*.within *.edges *.reached *.edge *.crossed common.predicate_undecided"),
    ),
    "first": Premise(
        LEMMA,
        "the first event is certain or undecided",
        _kernels(
            "common.opening common.within_time common.tie_undecided common.earliest "
            "common.bounds_undecided common.flight_undecided common.apex_* common.side_*"
        ),
    ),
    "horizon": Premise(
        LEMMA,
        "the horizon",
        _kernels("common.horizon common.overdue common.out_of_budget*"),
    ),
    "sinking": Premise(
        LEMMA,
        "a ball that can never meet anything again",
        _kernels("common.piece_end common.sinks"),
    ),
    "plane_start": Premise(LEMMA, "flights that begin at a plane", _kernels("common.plane_start")),
    "plates": Premise(LEMMA, "a filter of plates", _kernels("common.released common.reachable")),
    "far": Premise(
        LEMMA,
        "disjoint boxes",
        _kernels("common.swept common.half_flight_boxes *.near *.near_any *.box"),
    ),
    "separation": Premise(LEMMA, "a ball that moves away from a box", _kernels("box.approaches")),
    "passage": Premise(LEMMA, "passage through the ring", _kernels("common.passing*")),
    # Errors
    "carried": Premise(
        LEMMA,
        "propagation of errors through a flight and a contact",
        _kernels(
            "common.carry_flight *.root_delay *.carry_root *.carry_normal law.carry "
            "common.carry_time common.clock_error_sum common.no_normal_error common.elsewhere "
            "common.again common.returned common.started common.other_start_surface *.curvature"
        ),
        proved=False,
    ),
    "frames": Premise(
        LEMMA,
        "growth of errors in the frames of contacts",
        _kernels(
            "common.normal_velocity common.came_back *.tangents law.carry "
            "common.carry_end common.unbounded common.without_bounds "
            "common.carry_time common.error_bounds common.claimed_errors common.clock_error_sum "
            "common.closing"
        ),
        proved=True,
    ),
    "seams": Premise(LEMMA, "seams of a box", _kernels("box.tangents"), proved=True),
    "friction": Premise(
        LEMMA,
        "growth of errors with friction",
        _kernels("law.slip"),
        proved=True,
    ),
    "provisional": Premise(
        LEMMA,
        "proved bounds until a ball may roll",
        _kernels(
            "law.bound common.bound_end common.bound_time common.clock_bound_sum common.proves "
            "common.estimated_after_contact common.estimates"
        ),
        proved=True,
    ),
    "premises": Premise(
        LEMMA,
        "premises of the proved bounds",
        _kernels("common.premises"),
        proved=True,
    ),
    "products": Premise(
        LEMMA,
        "bounds through the product of several contacts",
        _kernels("law.tighten common.tightens common.loose"),
        proved=True,
    ),
    "piece_errors": Premise(
        CHOICE, "propagation of errors through a piece", _kernels("common.carry_piece")
    ),
    "growth": Premise(
        CHOICE,
        "growth of errors",
        _kernels("common.error_bounds common.claimed_errors common.closing common.error_floor"),
        proved=False,
    ),
    "variations": Premise(
        LEMMA,
        "variations of a shot",
        _kernels(
            "common.vary_air_rates common.vary_air_order_* common.vary_flight *.vary law.vary "
            "common.vary_departure"
        ),
    ),
    # In contact
    "bounces": Premise(
        LEMMA,
        "Zeno accumulation of bounces",
        _kernels(
            "law.settling law.rebound common.leaves_slowly common.nearly "
            "common.no_bounce common.gripped common.pressed_on common.isolated common.near_apex "
            "common.near_end_plane common.near_body *.turning common.near_bounded_body "
            "*.closing *.separation common.settled common.jump_errors common.beginning_contact "
            "common.off_at_start common.placed_at_start common.start_errors "
            "common.undecided_at_start common.start_velocity_errors common.velocity_at_start "
            "common.seam_undecided"
        ),
    ),
    "series": Premise(
        LEMMA,
        "rolling as a power series",
        _kernels(
            "common.roll_turn_rate common.roll_start common.roll_* common.roll_step "
            "*.rolling_surface *.width *.distance common.roll_moved common.roll_placed"
        ),
    ),
    "round": Premise(
        LEMMA,
        "rolling on a ring",
        _kernels("*.round_* common.circles common.half_steps common.still_in_contact"),
    ),
    "endless": Premise(
        LEMMA,
        "rolling for ever",
        _kernels("*.swung common.clearance_at_any_azimuth common.rolls_for_ever *.around"),
    ),
    "leaving": Premise(
        LEMMA,
        "the end of a contact",
        _kernels(
            "common.leaving_force common.beside_* common.beside *.beside *.seam* "
            "common.rolled_on common.holding common.other_surface common.resumed "
            "common.reaches_apex"
        ),
    ),
    "parting": Premise(
        LEMMA,
        "tangential departure",
        _kernels(
            "common.no_contact common.neighbour_free_time common.end_plane_free_time "
            "common.seam_free_time common.separated common.detachment common.carry_hop "
            "common.bounded_neighbour_free_time"
        ),
    ),
    "edges": Premise(
        LEMMA,
        "edges",
        _kernels(
            "*.rim* *.crease *.facing common.no_edge common.near_edge common.reaches_edge "
            "common.unbounded common.outside_* common.at_edge common.succeeds common.edge_errors "
            "common.taking_over common.no_entry common.entering_bound"
        ),
    ),
    "neighbour": Premise(
        CHOICE,
        "errors of a motion in contact",
        _kernels("common.neighbour_scale common.neighbour common.compared"),
    ),
    "grip": Premise(
        CHOICE,
        "the limit of friction",
        _kernels(
            "common.ring_friction common.forget_grip_deficit common.exceeds_grip "
            "common.grip_lost_time common.remember_grip_deficit law.grip_deficit"
        ),
    ),
    # Definitions
    "bookkeeping": Premise(
        DEFINITION,
        "counts, clocks and outcomes",
        _kernels(
            "common.body_of common.expiry common.departed common.expired common.accounted "
            "common.limited common.event_clock common.meeting common.here common.counted "
            "common.touched common.ends_by_time_limit common.in_contact common.opens_in_flight "
            "common.open_in_flight common.reachable_in_flight common.contact_undecided "
            "common.no_departure common.stays_put common.stay_in_contact common.started_on_surface "
            "common.nothing_happens_yet common.slow_at_start common.no_rest common.rest"
        ),
    ),
    "pieces": Premise(
        DEFINITION, "pieces of a flight in the loop", _kernels("common.goes_on common.aloft")
    ),
    "studies": Premise(DEFINITION, "kernels of studies", _kernels("study.*")),
}
"""Premises of the page in their order, by the key in the template."""
