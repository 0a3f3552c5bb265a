"""NumPy kernels of the scene hoop.

Generated from templates/numpy/kernels.py.j2, scene hoop, derivation d045c64f80c6d78c,
with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
and run `make generate`.
Every function takes scalars or arrays that broadcast and is evaluated element by element; SI units.
"""

# ruff: noqa: E501

from __future__ import annotations

from enum import IntEnum
from math import sqrt as _square_root
from typing import Any, NamedTuple

from numpy import absolute as _absolute
from numpy import add as _add
from numpy import array as _array
from numpy import bitwise_and as _bitwise_and
from numpy import bitwise_xor as _bitwise_xor
from numpy import count_nonzero as _count_nonzero
from numpy import divide as _divide
from numpy import empty_like as _empty_like
from numpy import flatnonzero as _flatnonzero
from numpy import float32 as _float32
from numpy import float64 as _float64
from numpy import full as _full
from numpy import inf as _inf
from numpy import int8 as _int8
from numpy import int32 as _int32
from numpy import int64 as _int64
from numpy import logical_and as _logical_and
from numpy import logical_not as _logical_not
from numpy import logical_or as _logical_or
from numpy import multiply as _multiply
from numpy import ndim as _ndim
from numpy import ndarray as _ndarray
from numpy import negative as _negative
from numpy import sqrt as _sqrt
from numpy import subtract as _subtract
from numpy import where as _where

SCENE = "hoop"

PARAMETERS: dict[str, tuple[float, str, str]] = {
    "ball_radius": (0.12128, "m", "R_B, radius of the ball"),
    "ring_radius": (0.235, "m", "R_H, radius of the wire's centre circle"),
    "wire_radius": (0.01, "m", "radius of the ring's wire"),
    "board_distance": (0.381, "m", "a_0, from the ring's centre to the backboard"),
    "board_half_width": (0.9144, "m", "y_B, half the backboard's width"),
    "board_bottom": (-0.14, "m", "z_B1, height of its lower edge"),
    "board_top": (0.9268, "m", "z_B2, height of its upper edge"),
    "bridge_half_width": (0.0762, "m", "y_BR, half the bridge's width"),
    "restitution": (0.7, "1", "e, of every contact"),
    "gravity": (9.81, "m/s²", "g"),
    "end_depth": (0.024256, "m", "H, of the end plane below the ring"),
}
"""Parameters in calling order: default, unit, meaning."""

LIMITS: dict[str, tuple[float, float]] = {
    "restitution": (0.0, 1.0),
}
"""Of parameters with a largest value: between which they are."""

SIZE_LIMITS: dict[str, tuple[float, float]] = {
    "ball_radius": (9.313225746154785e-10, 1073741824.0),
    "ring_radius": (0.0, 1073741824.0),
    "wire_radius": (0.0, 1073741824.0),
    "board_distance": (0.0, 1073741824.0),
    "board_half_width": (0.0, 1073741824.0),
    "board_bottom": (0.0, 1073741824.0),
    "board_top": (0.0, 1073741824.0),
    "bridge_half_width": (0.0, 1073741824.0),
    "restitution": (0.0, 1.2676506002282294e+30),
    "gravity": (9.313225746154785e-10, 1073741824.0),
    "end_depth": (0.0, 1073741824.0),
}
"""The least and the largest size of each parameter with which no arithmetic over- or underflows."""

MAX_SIZE = 1073741824.0
"""The largest size of a component of a release."""

MAX_TIME = 1099511627776.0
"""The largest finite time limit, s."""

VARIABLES: dict[str, str] = {
    "ball_radius": "p_ball_radius",
    "ring_radius": "p_ring_radius",
    "wire_radius": "p_wire_radius",
    "board_distance": "p_board_distance",
    "board_half_width": "p_board_half_width",
    "board_bottom": "p_board_bottom",
    "board_top": "p_board_top",
    "bridge_half_width": "p_bridge_half_width",
    "restitution": "p_restitution",
    "gravity": "p_gravity",
    "end_depth": "p_end_depth",
}
"""What each parameter is called as an argument, and as a column of the event loop."""

BALL_RADIUS = "ball_radius"
"""The parameter that is the radius of the ball."""

BODIES: tuple[str, ...] = ("ring", "backboard", "bridge",)
"""What can be touched, in the order of the results; what ends a shot comes after them."""

FACES: tuple[tuple[str, ...], ...] = (("ring",), ("backboard",), ("bridge",), )
"""Surfaces of each body."""

VARIED_LAWS: dict[str, tuple[str, tuple[str, ...]]] = {
    "ring": ("vary_impact", ("vx", "vy", "vz", "wx", "wy", "wz", "nx", "ny", "nz", "dvx", "dvy", "dvz", "dwx", "dwy", "dwz", "dnx", "dny", "dnz", "p_ball_radius", "p_restitution", "change_ball_radius", "change_restitution",)),
    "backboard": ("vary_impact", ("vx", "vy", "vz", "wx", "wy", "wz", "nx", "ny", "nz", "dvx", "dvy", "dvz", "dwx", "dwy", "dwz", "dnx", "dny", "dnz", "p_ball_radius", "p_restitution", "change_ball_radius", "change_restitution",)),
    "bridge": ("vary_impact", ("vx", "vy", "vz", "wx", "wy", "wz", "nx", "ny", "nz", "dvx", "dvy", "dvz", "dwx", "dwy", "dwz", "dnx", "dny", "dnz", "p_ball_radius", "p_restitution", "change_ball_radius", "change_restitution",)),
}
"""The variation of each body's contact law: a kernel, and what it is given."""

END_PLANES: tuple[str, ...] = ("end",)
"""Planes that end a shot."""

ENDS: tuple[str, ...] = ("made", "missed",)
"""What ends a shot, in the order of the outcomes; none: a time limit does."""

STATE: tuple[str, ...] = ('x', 'y', 'z', 'vx', 'vy', 'vz', 'wx', 'wy', 'wz')
"""The state of the ball, in order: m, m/s, rad/s."""


class Outcome(IntEnum):
    """How a shot ended.

    A code, not a verdict: MADE is 0, so ``bool(outcome)`` is false for a shot that is made. Compare
    with a member, or ask `Shots.made`.
    """

    MADE = 0
    """Crossed the end plane downwards inside the target."""
    MISSED = 1
    """Crossed it outside."""
    CAPPED = 2
    """Had max_contacts contacts before it ended."""
    SHORT = 3
    """Can never reach an end."""
    INVALID = 4
    """Not finite, not allowed, a size out of range, or a start inside a surface."""
    LODGED = 5
    """At rest, or wedged between bodies."""
    ENDLESS = 6
    """Still moving at the time limit."""


class Event(IntEnum):
    """What a row of the event log is."""

    IMPACT = 0
    """The ball meets a body."""
    ROLL = 1
    """Its bounces have accumulated: it stays in contact with the body."""
    LEAVE = 2
    """That contact ends."""
    END = 3
    """The shot ends."""


LOG_ROWS = 1
"""Rows of the event log for each contact, at most; the end is one more."""

NEEDS_TIME_LIMIT = False
"""Whether a shot may go on for ever without a time limit."""

PIECES: tuple[str, ...] = ()
"""The kernels that begin a piece of a flight, in order; none: a flight is one formula."""


class Field(NamedTuple):
    """A number that a shot keeps from event to event: its start, None if given; whether it is
    diagnostic, and never influences the trajectory; whether only shots whose bounds are tightened
    need it."""

    name: str
    start: float | None
    is_diagnostic: bool
    dtype: str = "float64"
    is_tightening: bool = False


class ResultField(NamedTuple):
    """A result of a batch, one row for each shot: all that is known of it.

    `hoopgen.derive.state.fields.ResultField` describes each attribute.
    """

    name: str
    dtype: str
    columns: tuple[str, ...]
    summary: str
    row: bool = False
    is_empty_if_invalid: bool = False
    is_diagnostic: bool = False
    is_on_request: bool = False
    is_counted: bool = False
    switch: str = ""
    absence: str = ""
    labels: tuple[str, ...] = ()
    units: tuple[str, ...] = ()
    dimension: str = ""
    coordinates: tuple[str, ...] = ()
    unit_coordinate: str = ""
    flags: tuple[str, ...] = ()
    first_flag: int = 0
    is_at_end: bool = False
    tally: str = ""
    tally_summary: str = ""
    proved: float | None = None
    is_judged: bool = False


FIELDS: tuple[Field, ...] = (
    Field("x", None, False),
    Field("y", None, False),
    Field("z", None, False),
    Field("vx", None, False),
    Field("vy", None, False),
    Field("vz", None, False),
    Field("wx", None, False),
    Field("wy", None, False),
    Field("wz", None, False),
    Field("place_n", 0.0, True, "float32"),
    Field("place_s", 0.0, True, "float32"),
    Field("place_e", 0.0, True, "float32"),
    Field("pace_n", 0.0, True, "float32"),
    Field("pace_s", 0.0, True, "float32"),
    Field("pace_e", 0.0, True, "float32"),
    Field("turn_n", 0.0, True, "float32"),
    Field("turn_z", 0.0, True, "float32"),
    Field("position_bound", 0.0, True, "float32"),
    Field("velocity_bound", 0.0, True, "float32"),
    Field("spin_bound", 0.0, True, "float32"),
    Field("left_nx", 0.0, True, "float32"),
    Field("left_ny", 0.0, True, "float32"),
    Field("left_nz", 0.0, True, "float32"),
    Field("left_ex", 0.0, True, "float32"),
    Field("left_ey", 0.0, True, "float32"),
    Field("left_bend_s", 0.0, True, "float32"),
    Field("left_bend_e", 0.0, True, "float32"),
    Field("origin_s", 0.0, True, "float32", is_tightening=True),
    Field("origin_e", 0.0, True, "float32", is_tightening=True),
    Field("origin_u", 0.0, True, "float32", is_tightening=True),
    Field("origin_v", 0.0, True, "float32", is_tightening=True),
    Field("origin_w", 0.0, True, "float32", is_tightening=True),
    Field("origin_t", 0.0, True, "float32", is_tightening=True),
    Field("product_11", 0.0, True, "float32", is_tightening=True),
    Field("product_12", 0.0, True, "float32", is_tightening=True),
    Field("product_13", 0.0, True, "float32", is_tightening=True),
    Field("product_14", 0.0, True, "float32", is_tightening=True),
    Field("product_15", 0.0, True, "float32", is_tightening=True),
    Field("product_16", 0.0, True, "float32", is_tightening=True),
    Field("product_21", 0.0, True, "float32", is_tightening=True),
    Field("product_22", 0.0, True, "float32", is_tightening=True),
    Field("product_23", 0.0, True, "float32", is_tightening=True),
    Field("product_24", 0.0, True, "float32", is_tightening=True),
    Field("product_25", 0.0, True, "float32", is_tightening=True),
    Field("product_26", 0.0, True, "float32", is_tightening=True),
    Field("product_31", 0.0, True, "float32", is_tightening=True),
    Field("product_32", 0.0, True, "float32", is_tightening=True),
    Field("product_33", 0.0, True, "float32", is_tightening=True),
    Field("product_34", 0.0, True, "float32", is_tightening=True),
    Field("product_35", 0.0, True, "float32", is_tightening=True),
    Field("product_36", 0.0, True, "float32", is_tightening=True),
    Field("product_41", 0.0, True, "float32", is_tightening=True),
    Field("product_42", 0.0, True, "float32", is_tightening=True),
    Field("product_43", 0.0, True, "float32", is_tightening=True),
    Field("product_44", 0.0, True, "float32", is_tightening=True),
    Field("product_45", 0.0, True, "float32", is_tightening=True),
    Field("product_46", 0.0, True, "float32", is_tightening=True),
    Field("product_51", 0.0, True, "float32", is_tightening=True),
    Field("product_52", 0.0, True, "float32", is_tightening=True),
    Field("product_53", 0.0, True, "float32", is_tightening=True),
    Field("product_54", 0.0, True, "float32", is_tightening=True),
    Field("product_55", 0.0, True, "float32", is_tightening=True),
    Field("product_56", 0.0, True, "float32", is_tightening=True),
    Field("product_61", 0.0, True, "float32", is_tightening=True),
    Field("product_62", 0.0, True, "float32", is_tightening=True),
    Field("product_63", 0.0, True, "float32", is_tightening=True),
    Field("product_64", 0.0, True, "float32", is_tightening=True),
    Field("product_65", 0.0, True, "float32", is_tightening=True),
    Field("product_66", 0.0, True, "float32", is_tightening=True),
    Field("recent_s", 0.0, True, "float32", is_tightening=True),
    Field("recent_e", 0.0, True, "float32", is_tightening=True),
    Field("recent_u", 0.0, True, "float32", is_tightening=True),
    Field("recent_v", 0.0, True, "float32", is_tightening=True),
    Field("recent_w", 0.0, True, "float32", is_tightening=True),
    Field("recent_t", 0.0, True, "float32", is_tightening=True),
    Field("continued", 0.0, True, "float32", is_tightening=True),
    Field("clock", 0.0, False),
    Field("clock_error", 0.0, True, "float32"),
    Field("last", None, False),
    Field("first", -1, False),
    Field("contacts", 0.0, False),
    Field("count_0", 0.0, False),
    Field("count_1", 0.0, False),
    Field("count_2", 0.0, False),
    Field("uncertain", 0.0, True),
    Field("position_claim", 0.0, True, "float32"),
    Field("velocity_claim", 0.0, True, "float32"),
    Field("spin_claim", 0.0, True, "float32"),
    Field("time_claim", 0.0, True, "float32"),
    Field("outcome", -1, False),
)

RESULTS: tuple[ResultField, ...] = (
    ResultField(name="outcome", dtype="uint8", columns=("outcome",), summary="how it ended", flags=("made", "missed", "capped", "short", "invalid", "lodged", "endless"), is_judged=True),
    ResultField(name="contacts", dtype="int32", columns=("contacts",), summary="contacts before the end", is_judged=True),
    ResultField(name="counts", dtype="int32", columns=("count_0", "count_1", "count_2"), summary="contacts with each body", row=True, labels=("ring_contacts", "backboard_contacts", "bridge_contacts"), dimension="surface", coordinates=("ring", "backboard", "bridge"), is_judged=True),
    ResultField(name="first", dtype="int8", columns=("first",), summary="first body touched, -1: none", flags=("none", "ring", "backboard", "bridge"), first_flag=-1, is_judged=True),
    ResultField(name="time", dtype="float64", columns=("clock",), summary="s, at the end; capped or short: at the last contact", is_empty_if_invalid=True, units=("s",), is_at_end=True, is_judged=True),
    ResultField(name="state", dtype="float64", columns=("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz"), summary="then", row=True, is_empty_if_invalid=True, labels=("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz"), units=("m", "m", "m", "m/s", "m/s", "m/s", "rad/s", "rad/s", "rad/s"), dimension="component", coordinates=("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz"), unit_coordinate="unit", is_at_end=True, is_judged=True),
    ResultField(name="time_error", dtype="float64", columns=("time_claim",), summary="bound on the error of time", is_empty_if_invalid=True, is_diagnostic=True, is_on_request=True, switch="claims", units=("s",), is_judged=True),
    ResultField(name="state_error", dtype="float64", columns=("position_claim", "velocity_claim", "spin_claim"), summary="bounds on the errors of each component of position, velocity and spin", row=True, is_empty_if_invalid=True, is_diagnostic=True, is_on_request=True, switch="claims", labels=("position_error", "velocity_error", "spin_error"), units=("m", "m/s", "rad/s"), dimension="part", coordinates=("position", "velocity", "spin"), is_judged=True),
    ResultField(name="uncertain", dtype="bool", columns=("uncertain",), summary="a decision lies within its rounding-error bound", is_diagnostic=True, is_judged=True),
)
"""The results of a shot, in the order of the C struct."""

DIAGNOSTIC_RESULTS = frozenset(result.name for result in RESULTS if result.is_diagnostic)
"""The names of those that need bounds on errors."""

ABSENT_RESULTS: tuple[ResultField, ...] = (
    ResultField(name="rolls", dtype="int32", columns=("rolls",), summary="how many times it began to roll", absence="no ball rolls", tally="rolled", tally_summary="shots that rolled", proved=0.0),
    ResultField(name="airless_rolls", dtype="bool", columns=("rolls",), summary="it rolled, without the air's force along the surface", absence="no ball rolls in air", tally="rolled_airless", tally_summary="shots that rolled without the air's force along the surface", proved=0.0),
    ResultField(name="slip_left", dtype="bool", columns=("slip_left",), summary="its bounces ended with slip left, and so it is capped", absence="no ball rolls", tally="slip_left", tally_summary="capped shots whose bounces ended with slip left", proved=0.0),
    ResultField(name="grip_lost", dtype="float64", columns=("grip_lost",), summary="s, when friction first was too little for the ball to roll as it did; infinite: never", is_empty_if_invalid=True, is_diagnostic=True, is_on_request=True, absence="no ball rolls", units=("s",), proved=_inf),
    ResultField(name="estimated", dtype="bool", columns=("estimated",), summary="its flag and the bounds on its errors are estimated, not proved", is_diagnostic=True, absence="the bounds of all shots are proved, or those of all are estimated", proved=0.0),
)
"""The results of other scenes that this one lacks."""

OUTPUTS: dict[str, tuple[str, ...]] = {
    "flight": ("x", "y", "z", "vx", "vy", "vz",),
    "contact_frame": ("n11", "n12", "n13", "n21", "n22", "n23", "n31", "n32", "n33",),
    "impact_through_frame": ("vx", "vy", "vz", "wx", "wy", "wz",),
    "crossing": ("clearance", "delay",),
    "allowance": ("position_level", "velocity_level", "excess",),
    "horizon": ("horizon", "pad",),
    "scale": ("extent", "speed", "excess",),
    "displacement": ("margin",),
    "normal_velocity": ("normal_velocity",),
    "carry_end": ("position_bound", "velocity_bound", "spin_bound", "delay",),
    "unbounded": ("unbounded",),
    "carry_time": ("position_bound", "velocity_bound", "spin_bound", "clock_error",),
    "error_bounds": ("position_error", "velocity_error", "spin_error", "time_error",),
    "claimed_errors": ("position_error", "velocity_error", "spin_error", "time_error",),
    "premises": ("holds",),
    "allowed": ("allowed",),
    "parameters_in_range": ("permitted",),
    "valid": ("valid", "undecided_time",),
    "aside": ("close", "valid", "undecided_time",),
    "vary_flight": ("dx", "dy", "dz", "dvx", "dvy", "dvz",),
    "vary_departure": ("dx", "dy", "dz", "dvx", "dvy", "dvz",),
    "left": ("leaving",),
    "released": ("released", "reachable",),
    "plane_root": ("arrives", "ceiling", "nearest",),
    "level_root": ("arrives", "ceiling", "nearest",),
    "within_time": ("possible",),
    "apex_undecided": ("undecided_time",),
    "side_undecided": ("undecided_time",),
    "predicate_undecided": ("undecided_time",),
    "bounds_undecided": ("undecided_time",),
    "crossing_undecided": ("undecided_time",),
    "tie_undecided": ("undecided_time", "earliest_delay",),
    "earliest": ("when", "which",),
    "missed": ("clear",),
    "opens": ("open",),
    "beginning": ("share", "arrival", "certain",),
    "out_of_budget": ("undecided_time",),
    "overdue": ("undecided_time",),
    "nearby": ("leaving", "margin",),
    "opened": ("time", "latest",),
    "coarse": ("stepping", "searching", "single_precision", "ceiling", "flat", "tilt", "allowing",),
    "stepped": ("arrival", "t", "searching",),
    "gap_closes": ("hit", "sure", "needs_refinement",),
    "smaller_budget": ("share",),
    "budget_undecided": ("undecided_time",),
    "advanced": ("arrival", "certain", "exhausted", "searching", "t",),
    "found": ("arrives", "refining", "rate",),
    "refined_root": ("arrival", "refining",),
    "own_margin": ("margin",),
    "arrival_time": ("time",),
    "arrival_certainty": ("delay", "undecided_time",),
    "state_in_range": ("in_range",),
    "opening": ("when", "which", "earliest_delay", "undecided_time",),
    "limited": ("limited",),
    "event_clock": ("clock",),
    "flight_undecided": ("uncertain",),
    "meeting": ("meeting",),
    "here": ("here",),
    "counted": ("count",),
    "without_bounds": ("uncertain",),
    "tightens": ("carries", "tightens",),
    "came_back": ("back",),
    "touched": ("first", "last",),
    "ends_by_time_limit": ("ends_by_time_limit",),
    "body_of": ("body",),
    "admitted": ("outcome", "uncertain",),
    "loose": ("loose",),
    "expiry": ("time", "delay", "arrives", "undecided_time",),
    "departed": ("stays", "moves", "ends", "touches", "reached", "edge",),
    "expired": ("clock", "body", "reached", "ends",),
    "accounted": ("contacts", "outcome",),
    "clock_error_sum": ("clock_error",),
    "closing": ("reports", "position_claim", "velocity_claim", "spin_claim", "time_claim",),
    "reachable": ("reachable",),
    "plane_start": ("undecided_time",),
    "tighten_impact": ("place_n", "place_s", "place_e", "pace_n", "pace_s", "pace_e", "turn_n", "turn_z", "position_bound", "velocity_bound", "spin_bound", "left_nx", "left_ny", "left_nz", "left_ex", "left_ey", "left_bend_s", "left_bend_e", "delay", "origin_s", "origin_e", "origin_u", "origin_v", "origin_w", "origin_t", "recent_s", "recent_e", "recent_u", "recent_v", "recent_w", "recent_t", "product_11", "product_12", "product_13", "product_14", "product_15", "product_16", "product_21", "product_22", "product_23", "product_24", "product_25", "product_26", "product_31", "product_32", "product_33", "product_34", "product_35", "product_36", "product_41", "product_42", "product_43", "product_44", "product_45", "product_46", "product_51", "product_52", "product_53", "product_54", "product_55", "product_56", "product_61", "product_62", "product_63", "product_64", "product_65", "product_66", "continued",),
    "impact": ("vx", "vy", "vz", "wx", "wy", "wz",),
    "carry_impact": ("place_n", "place_s", "place_e", "pace_n", "pace_s", "pace_e", "turn_n", "turn_z", "position_bound", "velocity_bound", "spin_bound", "left_nx", "left_ny", "left_nz", "left_ex", "left_ey", "left_bend_s", "left_bend_e", "delay",),
    "vary_impact": ("dvx", "dvy", "dvz", "dwx", "dwy", "dwz",),
    "ring_coefficients": ("c0", "c1", "c2", "c3", "c4", "c5", "c6", "c7", "c8",),
    "ring_deflated": ("c0", "c1", "c2", "c3", "c4", "c5", "c6", "c7",),
    "ring_normal": ("nx", "ny", "nz",),
    "ring_tangents": ("tangent_x", "tangent_y", "bend_s", "bend_e", "sharpest_bend", "root_offset", "root_level", "normal_rounding",),
    "ring_vary": ("contact_delay", "gap", "gap_change", "dx", "dy", "dz", "dvx", "dvy", "dvz", "dnx", "dny", "dnz",),
    "ring_excess": ("excess",),
    "ring_clear": ("clear",),
    "ring_prepare": ("energy2", "moment2", "rho_start", "low0", "high0", "low1", "high1", "low2", "high2", "ceiling", "latest", "budget_exceeded",),
    "ring_margins": ("margin", "leaving_margin", "rate_margin",),
    "ring_refine": ("time", "gap", "rate",),
    "ring_advance": ("gap", "rate", "bend", "step", "next", "clearance",),
    "ring_opened": ("t", "end", "searching", "low1", "high1", "low2", "high2", "latest", "representable",),
    "ring_resolution": ("share", "t", "end", "x", "y", "z", "vx", "vy", "vz", "energy2", "moment2", "rho_start", "ceiling", "flat", "tilt", "jerk", "quotient_margin", "start_rate", "rho_rate", "rate_margin", "low1", "high1", "low2", "high2", "fits",),
    "ring_step": ("t", "end", "certain", "stepping",),
    "ring_started": ("rho_start", "start_rate", "rho_rate",),
    "ring_coarse_excess": ("excess",),
    "ring_budget_exceeded": ("budget_exceeded",),
    "ring_drops_through": ("unproved",),
    "ring_enter": ("t", "end", "searching",),
    "backboard_coefficients": ("c0", "c1",),
    "backboard_deflated": ("c0",),
    "backboard_normal": ("nx", "ny", "nz",),
    "backboard_tangents": ("tangent_x", "tangent_y", "bend_s", "bend_e", "sharpest_bend", "root_offset", "root_level", "normal_rounding",),
    "backboard_vary": ("contact_delay", "gap", "gap_change", "dx", "dy", "dz", "dvx", "dvy", "dvz", "dnx", "dny", "dnz", "g0", "g0_change", "g1", "g1_change", "g2", "g2_change", "g3", "g3_change",),
    "backboard_bounds": ("g0", "g1", "g2", "g3",),
    "backboard_arrival": ("time", "rate", "bend", "apex", "height",),
    "backboard_margin": ("margin",),
    "backboard_place": ("x", "y", "z",),
    "backboard_within": ("arrives",),
    "backboard_edges": ("undecided",),
    "bridge_coefficients": ("c0", "c1", "c2",),
    "bridge_deflated": ("c0", "c1",),
    "bridge_normal": ("nx", "ny", "nz",),
    "bridge_tangents": ("tangent_x", "tangent_y", "bend_s", "bend_e", "sharpest_bend", "root_offset", "root_level", "normal_rounding",),
    "bridge_vary": ("contact_delay", "gap", "gap_change", "dx", "dy", "dz", "dvx", "dvy", "dvz", "dnx", "dny", "dnz", "g0", "g0_change", "g1", "g1_change", "g2", "g2_change", "g3", "g3_change", "g4", "g4_change",),
    "bridge_bounds": ("g0", "g1", "g2", "g3", "g4",),
    "bridge_arrival": ("time", "rate", "bend", "apex", "height",),
    "bridge_margin": ("margin",),
    "bridge_place": ("x", "y", "z",),
    "bridge_within": ("arrives",),
    "bridge_edges": ("undecided",),
    "end_coefficients": ("c0", "c1", "c2",),
    "end_deflated": ("c0", "c1",),
    "end_normal": ("nx", "ny", "nz",),
    "end_tangents": ("tangent_x", "tangent_y", "bend_s", "bend_e", "sharpest_bend", "root_offset", "root_level", "normal_rounding",),
    "end_vary": ("contact_delay", "gap", "gap_change", "dx", "dy", "dz", "dvx", "dvy", "dvz", "dnx", "dny", "dnz", "g0", "g0_change",),
    "end_arrival": ("time", "rate", "bend", "apex", "height",),
    "end_margin": ("margin",),
    "end_place": ("x", "y", "z",),
    "end_bounds": ("g0",),
    "end_reached": ("reached",),
    "end_edge": ("edge",),
    "aimed_speed": ("speed",),
    "entry_slope": ("entry",),
    "slope_of_entry": ("slope",),
    "least_speed": ("slope", "speed",),
    "slopes_of_speed": ("low", "high",),
    "descent": ("time", "vz",),
    "apex": ("time", "height",),
    "line_of_sight": ("past", "left",),
    "ring_nearness": ("gap", "rate", "lower", "concavity", "resolution",),
}
"""Names of each kernel's outputs."""

ROWS = 123
"""Rows that a kernel writes into, at the most: what it computes on the way to its results."""

FEW = 1 << 10
"""So few shots are quicker with fresh arrays than with rows, and without a look at how many differ."""

ALONE = 8
"""So few shots go one by one through a body that repeats."""

NO_ROWS: tuple[None, ...] = (None,) * ROWS
"""With these in their place it makes arrays of its own."""


def _scalar(value: Any) -> Any:
    """Return a number as an array of no dimension, which nothing may write into."""
    scalar = _array(value)
    scalar.flags.writeable = False
    return scalar


_k0 = _float64(0.5)
_k1 = _float64(1.0)
_k2 = _float64(0.0)
_k3 = _float64(0.4)
_k4 = _float64(0.6)
_k5 = _float64(0.6666666666666666)
_k6 = _scalar(6.0)
_k7 = _scalar(0.0)
_k8 = _scalar(_inf)
_k9 = _float64(6.0)
_k10 = _float64(_inf)
_k11 = _float64(9.5367431640625e-07)
_k12 = _scalar(1.152921504606847e+18)
_k13 = _float64(1.152921504606847e+18)
_k14 = _scalar(1.0009765625)
_k15 = _scalar(4.445228907190568e-16)
_k16 = _scalar(3.0029296875)
_k17 = _scalar(4.440892098500626e-16)
_k18 = _float64(1.0009765625)
_k19 = _float64(4.445228907190568e-16)
_k20 = _float64(3.0029296875)
_k21 = _float64(4.440892098500626e-16)
_k22 = _scalar(_float32(2.0))
_k23 = _float32(0.5)
_k24 = _scalar(_float32(7.888609052210118e-31))
_k25 = _scalar(_float32(1.1102230246251565e-16))
_k26 = _scalar(_float32(1.1))
_k27 = _scalar(_float32(1.0009765625))
_k28 = _scalar(_float32(12.0))
_k29 = _scalar(_float32(0.0))
_k30 = _scalar(_float32(_inf))
_k31 = _scalar(_float32(4.440892098500626e-16))
_k32 = _float32(12.0)
_k33 = _float32(1.1)
_k34 = _float32(7.888609052210118e-31)
_k35 = _float32(1.1102230246251565e-16)
_k36 = _float32(2.0)
_k37 = _float32(0.0)
_k38 = _float32(1.0009765625)
_k39 = _float32(_inf)
_k40 = _float32(4.440892098500626e-16)
_k41 = _float64(1.0000009536743164)
_k42 = _float64(12.0)
_k43 = _float64(2.0)
_k44 = _float64(65536.0)
_k45 = _float64(1.5000014305114746)
_k46 = _float64(16.0)
_k47 = _float64(1073741824.0)
_k48 = _float64(9.313225746154785e-10)
_k49 = _float64(1.2676506002282294e+30)
_k50 = _scalar(0.5)
_k51 = _scalar(1.0)
_k52 = _scalar(2.0)
_k53 = _scalar(1.7763568394002505e-15)
_k54 = _float64(1.7763568394002505e-15)
_k55 = _float64(4.0)
_k56 = _scalar(8.0)
_k57 = _float64(8.0)
_k58 = _float64(2.9802322387695312e-08)
_k59 = _float64(2.842170943040401e-14)
_k60 = _float64(0.03125)
_k61 = _float64(5.960464477539063e-08)
_k62 = _scalar(1073741824.0)
_k63 = _float64(-1.0)
_k64 = _float64(3.0)
_k65 = _float32(1.0)
_k66 = _scalar(9.313225746154785e-10)
_k67 = _scalar(1.0000000000009095)
_k68 = _float64(1.0000000000009095)
_k69 = _scalar(_float32(7.62939453125e-06))
_k70 = _scalar(_float32(1.02))
_k71 = _scalar(_float32(100.0))
_k72 = _scalar(_float32(1.0))
_k73 = _scalar(_float32(4194304.0))
_k74 = _scalar(_float32(9.5367431640625e-07))
_k75 = _float32(0.6)
_k76 = _float32(0.4)
_k77 = _scalar(_float32(1.5543122344752192e-15))
_k78 = _scalar(_float32(4.0))
_k79 = _scalar(_float32(0.6))
_k80 = _scalar(_float32(0.421875))
_k81 = _scalar(_float32(0.578125))
_k82 = _scalar(_float32(0.25))
_k83 = _scalar(_float32(0.125))
_k84 = _scalar(_float32(0.015625))
_k85 = _float32(1.02)
_k86 = _float32(7.62939453125e-06)
_k87 = _float32(100.0)
_k88 = _float32(4194304.0)
_k89 = _float32(9.5367431640625e-07)
_k90 = _float32(1.5543122344752192e-15)
_k91 = _float32(4.0)
_k92 = _float32(0.421875)
_k93 = _float32(0.578125)
_k94 = _float32(0.125)
_k95 = _float32(0.015625)
_k96 = _float32(0.25)
_k97 = _scalar(0.6)
_k98 = _float64(0.0625)
_k99 = _scalar(_float32(1.5))
_k100 = _float32(16.0)
_k101 = _scalar(_float32(1.125))
_k102 = _scalar(_float32(1.7763568394002505e-15))
_k103 = _float32(3.5)
_k104 = _float32(7.0)
_k105 = _float32(1.5)
_k106 = _float32(1.125)
_k107 = _float32(1.7763568394002505e-15)
_k108 = _float64(1.00006103515625)
_k109 = _float64(0.0001220703125)
_k110 = _scalar(4.0)
_k111 = _float64(0.000244140625)
_k112 = _float64(1.52587890625e-05)
_k113 = _float64(5.820766091346741e-11)
_k114 = _float64(6.0003662109375)
_k115 = _scalar(8.881784197001252e-16)
_k116 = _scalar(2.409919865102884e-181)
_k117 = _scalar(-_inf)
_k118 = _float64(8.881784197001252e-16)
_k119 = _float64(2.409919865102884e-181)
_k120 = _float64(-_inf)
_k121 = _scalar(5.0)
_k122 = _scalar(2.220446049250313e-16)
_k123 = _scalar(3.552713678800501e-15)
_k124 = _float64(1.3323489447131243e-15)
_k125 = _float64(5.00030517578125)
_k126 = _float64(3.552713678800501e-15)
_k127 = _float64(5.0)
_k128 = _float64(2.220446049250313e-16)
_k129 = _scalar(9.094947017729282e-13)
_k130 = _float64(9.094947017729282e-13)
_k131 = _float32(1.00006103515625)
_k132 = _scalar(_float32(4.76837158203125e-07))
_k133 = _scalar(_float32(8.673617379884035e-19))
_k134 = _scalar(_float32(-_inf))
_k135 = _float32(0.0001220703125)
_k136 = _scalar(_float32(1.000000238418579))
_k137 = _float32(32.0)
_k138 = _float32(4096.0)
_k139 = _float32(0.000244140625)
_k140 = _scalar(_float32(4096.0))
_k141 = _float32(4.76837158203125e-07)
_k142 = _float32(8.673617379884035e-19)
_k143 = _float32(-_inf)
_k144 = _float32(1.000000238418579)
_k145 = _scalar(_float32(5.0))
_k146 = _scalar(_float32(0.00390625))
_k147 = _scalar(_float32(2.9802322387695312e-08))
_k148 = _scalar(_float32(2.842170943040401e-14))
_k149 = _float32(6.0003662109375)
_k150 = _scalar(_float32(0.5))
_k151 = _float32(5.0048828125)
_k152 = _scalar(_float32(5.684341886080802e-14))
_k153 = _scalar(_float32(2.384185791015625e-07))
_k154 = _float32(128.0)
_k155 = _float32(2.842170943040401e-14)
_k156 = _float32(0.00390625)
_k157 = _float32(5.0)
_k158 = _float32(2.9802322387695312e-08)
_k159 = _float32(5.684341886080802e-14)
_k160 = _float32(2.384185791015625e-07)
_k161 = _float32(6.0)
_k162 = _scalar(_float32(8.0))
_k163 = _scalar(_float32(0.0001220703125))
_k164 = _scalar(_float32(3.814697265625e-06))
_k165 = _scalar(_float32(3.0))
_k166 = _scalar(_float32(0.000244140625))
_k167 = _float32(8.0)
_k168 = _float32(3.814697265625e-06)
_k169 = _float32(3.0)
_k170 = _float64(8.940696716308594e-08)
_k171 = _float32(1.00048828125)
_k172 = _float32(0.00048828125)
_k173 = _float32(1.4143014047294855)
_k174 = _float32(1.52587890625e-05)
_k175 = _scalar(2.222614453595284e-16)
_k176 = _scalar(2.001953125)
_k177 = _float64(6.667843360785852e-16)
_k178 = _float64(8.890457814381136e-16)
_k179 = _float64(2.222614453595284e-16)
_k180 = _float64(2.001953125)
_k181 = _float64(7.105427357601002e-15)


def _bits(value: Any, row: Any) -> Any:
    """Return numbers as the whole numbers of the same bits, of the size of those in a row."""
    return (value if type(value) is _ndarray and value.ndim else row.dtype.type(value)).view(_whole(row))


def _whole(row: Any) -> Any:
    """Return the type of whole numbers as long as those in a row."""
    return _int64 if row.itemsize == 8 else _int32


def _single(value: Any) -> Any:
    """Return numbers rounded to single precision."""
    return value.astype(_float32, copy=False) if type(value) is _ndarray else _float32(value)


def _double(value: Any) -> Any:
    """Return numbers of single precision as doubles."""
    return value.astype(float) if type(value) is _ndarray else float(value)


def _halves(room: Any) -> Any:
    """Return rows as rows of single precision."""
    if room[0] is None:
        return room
    return [row.view(_float32)[: len(row)] for row in room]


def _select(truth: Any, then: Any, other: Any, row: Any, keep: bool = True) -> Any:
    """Return one value where a truth holds, and another where it does not: either, or a row.

    Where it holds for some shots and not for their neighbours, a branch for each would be guessed
    wrong more often than not: the bits are taken from both.
    """
    if row is None:
        return _where(truth, then, other)
    shots = len(row)
    many = _count_nonzero(truth) if type(truth) is _ndarray and truth.ndim else shots * bool(truth)
    if many in (0, shots):
        all_of = then if many else other
        if keep and _ndim(all_of):
            return all_of
        row[...] = all_of
        return row
    if not shots < 16 * many < 15 * shots:
        return _where(truth, then, other)
    bits, unlike = row.view(_whole(row)), _bits(other, row)
    _bitwise_xor(_bits(then, row), unlike, bits)
    _bitwise_and(bits, _negative(truth.view(_int8)).astype(bits.dtype), bits)
    _bitwise_xor(bits, unlike, bits)
    return row


def _result(truth: Any, then: Any, other: Any, row: Any) -> Any:
    """Do the same, in an array of its own."""
    return _select(truth, then, other, None if row is None else _empty_like(row), False)


def flight(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Position and velocity at time t of a flight.

    Eq. 3. 11 operations: 3 additions, 2 subtractions, 6 multiplications.
    """
    _r0, = _room[:1]
    return x + _multiply(vx, t, _r0), y + _multiply(vy, t, _r0), z + _multiply(t, _subtract(vz, _multiply(0.5 * p_gravity, t, _r0), _r0), _r0), vx, vy, vz - _multiply(p_gravity, t, _r0)


def contact_frame(nx: Any, ny: Any, nz: Any) -> tuple[Any, ...]:
    """Contact frame R = [n1 n2 n3] of a unit normal.

    Eqs. 7-10, Eq. 7 with the smallest component. 72 operations: 6 additions, 3 subtractions, 18 multiplications, 12 divisions, 3 square roots, 9 negations, 3 comparisons, 18 selections.
    """
    _s0 = nx * nx
    _s1 = ny * ny
    _s2 = nz * nz
    _s3 = _sqrt((1.0 - _s0))
    _s4 = _sqrt((1.0 - _s1))
    _s5 = nx * ny
    _s6 = _sqrt((1.0 - _s2))
    _s7 = nx * nz
    _s8 = _s1 <= _s2
    _s9 = _where(_s8, (-(_s5 / _s4)), (-(_s7 / _s6)))
    _s10 = _s0 <= _s2
    _s11 = _s0 <= _s1
    _s12 = _where(_s8, (-((nz * _s4) + ((_s1 * nz) / _s4))), ((ny * _s6) + ((ny * _s2) / _s6)))
    _s13 = ny * nz
    _s14 = _where(_s8, _s4, (-(_s13 / _s6)))
    _s15 = _where(_s8, 0.0, (-((nx * _s6) + ((nx * _s2) / _s6))))
    _s16 = _where(_s8, (-(_s13 / _s4)), _s6)
    _s17 = _where(_s8, ((nx * _s4) + ((nx * _s1) / _s4)), 0.0)
    _s18 = _where(_s11, _where(_s10, (-((ny * _s3) + ((_s0 * ny) / _s3))), _s17), _s17)
    return _where(_s11, _where(_s10, _s3, _s9), _s9), _where(_s11, _where(_s10, 0.0, _s12), _s12), nx, _where(_s11, _where(_s10, (-(_s5 / _s3)), _s14), _s14), _where(_s11, _where(_s10, ((nz * _s3) + ((_s0 * nz) / _s3)), _s15), _s15), ny, _where(_s11, _where(_s10, (-(_s7 / _s3)), _s16), _s16), _s18, nz


def impact_through_frame(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, n11: Any, n12: Any, n13: Any, n21: Any, n22: Any, n23: Any, n31: Any, n32: Any, n33: Any, p_ball_radius: Any, restitution: Any) -> tuple[Any, ...]:
    """Velocity and spin after an impact, through the contact frame.

    Eqs. 11-17 by the closed-form inverse. 96 operations: 21 additions, 11 subtractions, 57 multiplications, 6 divisions, 1 negation.
    """
    _s0 = ((n12 * wx) + (n22 * wy)) + (n32 * wz)
    _s1 = 0.4 * p_ball_radius
    _s2 = 0.6 * n11
    _s3 = 0.6 * n21
    _s4 = 0.6 * n31
    _s5 = (((_s1 * _s0) + (_s2 * vx)) + (_s3 * vy)) + (_s4 * vz)
    _s6 = 0.6 * n12
    _s7 = 0.6 * n22
    _s8 = 0.6 * n32
    _s9 = ((n11 * wx) + (n21 * wy)) + (n31 * wz)
    _s10 = (((_s6 * vx) + (_s7 * vy)) + (_s8 * vz)) - (_s1 * _s9)
    _s11 = ((n13 * vx) + (n23 * vy)) + (n33 * vz)
    _s12 = ((n13 * wx) + (n23 * wy)) + (n33 * wz)
    _s13 = 0.6666666666666666 * p_ball_radius
    _s14 = (((n12 * vx) + (n22 * vy)) + (n32 * vz)) - (_s13 * _s9)
    _s15 = -((((_s13 * _s0) + (n11 * vx)) + (n21 * vy)) + (n31 * vz))
    return ((n11 * _s5) + (n12 * _s10)) - ((n13 * restitution) * _s11), ((n21 * _s5) + (n22 * _s10)) - ((n23 * restitution) * _s11), ((n31 * _s5) + (n32 * _s10)) - ((n33 * restitution) * _s11), ((n13 * _s12) - ((_s2 * _s14) / p_ball_radius)) - ((_s6 * _s15) / p_ball_radius), ((n23 * _s12) - ((_s3 * _s14) / p_ball_radius)) - ((_s7 * _s15) / p_ball_radius), ((n33 * _s12) - ((_s4 * _s14) / p_ball_radius)) - ((_s8 * _s15) / p_ball_radius)


def crossing(margin: Any, rate_margin: Any, rate: Any, ceiling: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Clearance, positive if a crossing is certain, and a bound on its delay.

    Taylor's theorem with the margins of the gap and its rate. 10 operations: 1 addition, 1 subtraction, 3 multiplications, 1 division, 1 negation, 1 comparison, 2 selections.
    """
    _r0, _r1, _r2, _r3 = _room[:4]
    _s0 = _negative(_add(rate, rate_margin, _r0), _r0)
    _s1 = _multiply(_k6, margin, _r1)
    _s2 = _k7 < _s0
    return _result(_s2, _subtract(_multiply(_s0, _s0, _r2), _multiply(_s1, ceiling, _r3), _r3), _s0, _r0), _result(_s2, _divide(_s1, _s0, _r1), _k8, _r0)


def allowance(share: Any, horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Errors of the state that a search allows for, and by how much the errors exceed them.

    a share of the size of the flight. 10 operations: 2 additions, 2 subtractions, 4 multiplications, 1 comparison, 1 selection.
    """
    _r0, _r1 = _room[:2]
    _s0 = _add(speed, _multiply(p_gravity, horizon, _r0), _r0)
    _s1 = share * _add(extent, _multiply(horizon, _s0, _r1), _r1)
    _s2 = share * _s0
    _s3 = _subtract(position_error, _s1, _r0)
    _s4 = _subtract(velocity_error, _s2, _r1)
    return _s1, _s2, _result(_s3 < _s4, _s4, _s3, _r0)


def horizon(t: Any, speed: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Time after which no event is wanted, and how long that is after t.

    the earliest arrival, with room for its delay. 5 operations: 2 additions, 2 multiplications, 1 division.
    """
    _s0 = 9.5367431640625e-07 * (t + (speed * (1.0 / p_gravity)))
    return t + _s0, _s0


def scale(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Sums of the sizes of position and velocity, and the excess of the flight's size.

    the measure of rounding errors. 18 operations: 4 additions, 1 subtraction, 2 multiplications, 1 division, 6 absolute values, 2 comparisons, 2 selections.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = _add(_absolute(x, _r0), _absolute(y, _r1), _r1) + _absolute(z, _r0)
    _s1 = _add(_absolute(vx, _r0), _absolute(vy, _r1), _r1) + _absolute(vz, _r0)
    _s2 = _select(_s0 < _s1, _s1, _s0, _r0)
    _s3 = _multiply(1.0 / p_gravity, _multiply(_s1, _s1, _r1), _r1)
    return _s0, _s1, _select(_s2 < _s3, _s3, _s2, _r2) - _k12


def displacement(delay: Any, horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_bridge_half_width: Any, p_gravity: Any, p_end_depth: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Bound on the error of a length at a computed arrival.

    running error analysis. 25 operations: 15 additions, 8 multiplications, 2 absolute values.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = _add(speed, _multiply(p_gravity, horizon, _r0), _r0)
    _s1 = _add(extent, _multiply(horizon, _s0, _r1), _r1)
    _s2 = (((((p_ball_radius + p_ring_radius) + p_wire_radius) + p_board_distance) + p_board_half_width) + p_bridge_half_width) + p_end_depth
    _s3 = _add(_multiply(_multiply(_k14, delay, _r2), _s0, _r2), _multiply(_k15, _add(_s1, (_s2 + _absolute(p_board_bottom)) + _absolute(p_board_top), _r0), _r0), _r0)
    return _s3 + _multiply(_k16, _add(_add(position_error, _multiply(horizon, velocity_error, _r2), _r2), _multiply(_k17, _s1, _r1), _r1), _r1),


def normal_velocity(vx: Any, vy: Any, vz: Any, nx: Any, ny: Any, nz: Any) -> tuple[Any, ...]:
    """Velocity along the normal before the impact.

    Table 2. 5 operations: 2 additions, 3 multiplications.
    """
    return ((nx * vx) + (ny * vy)) + (nz * vz),


def carry_end(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, clock: Any, position_bound: Any, velocity_bound: Any, spin_bound: Any, root_offset: Any, normal_velocity: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Bounds on the errors where a flight crosses the end plane.

    Eq. 3, with roundings. 63 operations: 25 additions, 1 subtraction, 23 multiplications, 1 division, 8 absolute values, 1 comparison, 4 selections.
    """
    t, x, y, z, vx, vy, vz, clock, position_bound, velocity_bound, spin_bound, root_offset, normal_velocity, p_gravity, = [_single(value) for value in (t, x, y, z, vx, vy, vz, clock, position_bound, velocity_bound, spin_bound, root_offset, normal_velocity, p_gravity,)]
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7 = _halves(_room[:8])
    _s0 = _absolute(vx, _r0)
    _s1 = _multiply(_k22, t, _r1)
    _s2 = _absolute(vy, _r2)
    _s3 = _k23 * p_gravity
    _s4 = _add(_add(_multiply(_s3, _multiply(t, t, _r3), _r3), _multiply(_s1, _absolute(_add(vz, _multiply(_s3, t, _r4), _r4), _r4), _r4), _r4), _absolute(z, _r3), _r3)
    _s5 = _add(_add(_add(_k24, _multiply(_k25, _add(_multiply(_s1, _s0, _r4), _absolute(x, _r5), _r5), _r5), _r5), _add(_k24, _multiply(_k25, _add(_multiply(_s1, _s2, _r1), _absolute(y, _r4), _r4), _r4), _r4), _r4), _add(_k24, _multiply(_k25, _s4, _r3), _r3), _r3)
    _s6 = _add(_add(_add(position_bound, root_offset, _r4), _multiply(t, velocity_bound, _r5), _r5), _s5, _r3)
    _s7 = _absolute(normal_velocity, _r5)
    _s8 = _divide(_multiply(_k26, _s6, _r4), _s7, _r4)
    _s9 = _absolute(vz, _r1)
    _s10 = _add(_k24, _multiply(_k25, _add(_add(_add(_multiply(p_gravity, t, _r6), _s0, _r6), _s2, _r6), _s9, _r6), _r6), _r6)
    _s11 = _add(_multiply(p_gravity, _s8, _r7), _add(velocity_bound, _s10, _r6), _r6)
    _s12 = _multiply(_k27, _add(_multiply(_s8, _add(_s11, _add(_add(_s0, _s2, _r2), _s9, _r2), _r2), _r2), _s6, _r2), _r2)
    _s13 = _subtract(_multiply(_k28, _s11, _r3), _s7, _r3) <= _k29
    return _result(_s13, _s12, _k30, _r0), _result(_s13, _multiply(_k27, _s11, _r6), _k30, _r0), _result(_s13, _multiply(_k27, spin_bound, _r6), _k30, _r0), _multiply(_k31, _add(t, clock, _r6), _r6) + _select(_s13, _multiply(_k27, _s8, _r4), _k30, _r2)


def unbounded(clock_error: Any, position_bound: Any, velocity_bound: Any, spin_bound: Any) -> tuple[Any, ...]:
    """Whether a bound on an error is not finite.

    comparison. 8 operations: 4 comparisons, 3 conjunctions, 1 complement.
    """
    clock_error, position_bound, velocity_bound, spin_bound, = [_single(value) for value in (clock_error, position_bound, velocity_bound, spin_bound,)]
    return _logical_not(_logical_and(_logical_and(_logical_and((position_bound < _float32(_inf)), (velocity_bound < _float32(_inf))), (spin_bound < _float32(_inf))), (clock_error < _float32(_inf)))),


def carry_time(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, clock: Any, clock_error: Any, position_bound: Any, velocity_bound: Any, spin_bound: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Bounds on the errors at the time limit.

    Eq. 3, with roundings. 51 operations: 24 additions, 20 multiplications, 7 absolute values.
    """
    t, x, y, z, vx, vy, vz, clock, clock_error, position_bound, velocity_bound, spin_bound, p_gravity, = [_single(value) for value in (t, x, y, z, vx, vy, vz, clock, clock_error, position_bound, velocity_bound, spin_bound, p_gravity,)]
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8 = _halves(_room[:9])
    _s0 = _add(clock_error, _multiply(_k31, _add(t, clock, _r0), _r0), _r0)
    _s1 = _absolute(vx, _r1)
    _s2 = _absolute(vy, _r2)
    _s3 = _absolute(vz, _r3)
    _s4 = _add(_k24, _multiply(_k25, _add(_add(_add(_multiply(p_gravity, t, _r4), _s1, _r4), _s2, _r4), _s3, _r4), _r4), _r4)
    _s5 = _add(_add(velocity_bound, _multiply(p_gravity, _s0, _r5), _r5), _s4, _r4)
    _s6 = _multiply(_k22, t, _r5)
    _s7 = _k23 * p_gravity
    _s8 = _add(_add(_multiply(_s7, _multiply(t, t, _r6), _r6), _multiply(_s6, _absolute(_add(vz, _multiply(_s7, t, _r7), _r7), _r7), _r7), _r7), _absolute(z, _r6), _r6)
    _s9 = _add(_add(_add(_k24, _multiply(_k25, _add(_multiply(_s6, _s1, _r7), _absolute(x, _r8), _r8), _r8), _r8), _add(_k24, _multiply(_k25, _add(_multiply(_s6, _s2, _r5), _absolute(y, _r7), _r7), _r7), _r7), _r7), _add(_k24, _multiply(_k25, _s8, _r6), _r6), _r6)
    _s10 = _add(_add(_add(position_bound, _multiply(t, velocity_bound, _r7), _r7), _multiply(_s0, _add(_s5, _add(_add(_s1, _s2, _r2), _s3, _r2), _r2), _r2), _r2), _s9, _r6)
    return _k27 * _s10, _k27 * _s5, _k27 * spin_bound, _k37


def error_bounds(clock_error: Any, position_bound: Any, velocity_bound: Any, spin_bound: Any) -> tuple[Any, ...]:
    """Bounds on the errors of state and time that decisions use.

    the carried bounds. No operations.
    """
    clock_error, position_bound, velocity_bound, spin_bound, = [_single(value) for value in (clock_error, position_bound, velocity_bound, spin_bound,)]
    return position_bound, velocity_bound, spin_bound, clock_error


def claimed_errors(clock_error: Any, position_bound: Any, velocity_bound: Any, spin_bound: Any) -> tuple[Any, ...]:
    """Bounds on the errors of state and time that are reported.

    the carried bounds. No operations.
    """
    clock_error, position_bound, velocity_bound, spin_bound, = [_single(value) for value in (clock_error, position_bound, velocity_bound, spin_bound,)]
    return position_bound, velocity_bound, spin_bound, clock_error


def premises(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, contacts: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_bridge_half_width: Any, p_restitution: Any, p_gravity: Any, p_end_depth: Any) -> tuple[Any, ...]:
    """Whether a shot released in flight fulfils the premises of the proved bounds.

    conservation of energy. 125 operations: 38 additions, 5 subtractions, 32 multiplications, 2 divisions, 2 square roots, 2 negations, 15 absolute values, 15 comparisons, 9 conjunctions, 2 disjunctions, 3 selections.
    """
    _s0 = vz * vz
    _s1 = ((((vx * vx) + (vy * vy)) + _s0) + ((0.6666666666666666 * (p_ball_radius * p_ball_radius)) * (((wx * wx) + (wy * wy)) + (wz * wz)))) / p_gravity
    _s2 = ((((_absolute(p_ball_radius) + _absolute(p_ring_radius)) + _absolute(p_wire_radius)) + _absolute(p_board_distance)) + _absolute(p_board_half_width)) + _absolute(p_board_bottom)
    _s3 = ((((_s2 + _absolute(p_board_top)) + _absolute(p_bridge_half_width)) + _absolute(p_end_depth)) + _absolute(x)) + _absolute(y)
    _s4 = -p_end_depth
    _s5 = (_s3 + _absolute(z)) + _absolute(_s4)
    _s6 = _s1 + (2.0 * _s5)
    _s7 = (1.0000009536743164 * (((12.0 + (2.0 * contacts)) * _s6) + _s5)) <= ((65536.0 * p_ball_radius) + (65536.0 * p_wire_radius))
    _s8 = _s0 - ((2.0 * p_gravity) * (_s4 - z))
    _s9 = 9.5367431640625e-07 * (_s6 + _s5)
    _s10 = (vz - _sqrt(_where(_s8 < 0.0, 0.0, _s8))) / p_gravity
    _s11 = x + (vx * _s10)
    _s12 = y + (vy * _s10)
    _s13 = _logical_and(_logical_and((0.0 < vz), ((9.5367431640625e-07 * _s0) <= _s8)), ((((_absolute(vx) + _absolute(vy)) * _s9) + ((vx * _s11) + (vy * _s12))) <= 0.0))
    _s14 = (p_board_distance + _s11) - p_ball_radius
    _s15 = (p_board_distance + x) - p_ball_radius
    _s16 = _logical_and(_logical_and(_s13, ((((p_ball_radius + p_ring_radius) + p_wire_radius) + _s9) < _sqrt(((_s11 * _s11) + (_s12 * _s12))))), _logical_or((_s9 < _where(_s14 < _s15, _s14, _s15)), (_where(_s15 < _s14, _s14, _s15) < (-_s9))))
    _s17 = _logical_and(_logical_and(_logical_and(_logical_and((p_restitution <= 1.0), _s7), (((1.5000014305114746 * p_ball_radius) + (1.5000014305114746 * p_wire_radius)) <= p_ring_radius)), ((1.0000009536743164 * p_ring_radius) <= ((16.0 * p_ball_radius) + (16.0 * p_wire_radius)))), _logical_or(((_s4 + (9.5367431640625e-07 * _s5)) <= z), _logical_and(_s16, ((_s4 + _s9) <= (p_ball_radius + p_wire_radius)))))
    return _s17,


def allowed(p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_bridge_half_width: Any, p_restitution: Any, p_gravity: Any, p_end_depth: Any) -> tuple[Any, ...]:
    """1 if finite parameters are allowed.

    the scene's requirements. 24 operations: 2 subtractions, 11 comparisons, 11 selections.
    """
    _s0 = _where((0.0 < p_ring_radius), _where((0.0 < p_ball_radius), _where((0.0 < ((p_ring_radius - p_ball_radius) - p_wire_radius)), 1.0, 0.0), 0.0), 0.0)
    _s1 = _where((0.0 <= p_restitution), _where((0.0 < p_bridge_half_width), _where((0.0 < p_board_half_width), _where((0.0 < p_board_distance), _where((0.0 < p_wire_radius), _s0, 0.0), 0.0), 0.0), 0.0), 0.0)
    return _where((0.0 < p_end_depth), _where((0.0 < p_gravity), _where((p_restitution <= 1.0), _s1, 0.0), 0.0), 0.0),


def parameters_in_range(p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_bridge_half_width: Any, p_restitution: Any, p_gravity: Any, p_end_depth: Any, allowed: Any) -> tuple[Any, ...]:
    """Whether the parameters are allowed, and no arithmetic with them over- or underflows.

    the range of numbers. 38 operations: 11 absolute values, 14 comparisons, 13 conjunctions.
    """
    _s0 = _absolute(p_ball_radius)
    _s1 = _logical_and(_logical_and(_logical_and(_logical_and(_logical_and((0.0 < allowed), (_s0 <= 1073741824.0)), (9.313225746154785e-10 <= _s0)), (_absolute(p_ring_radius) <= 1073741824.0)), (_absolute(p_wire_radius) <= 1073741824.0)), (_absolute(p_board_distance) <= 1073741824.0))
    _s2 = _logical_and(_logical_and(_logical_and(_logical_and(_s1, (_absolute(p_board_half_width) <= 1073741824.0)), (_absolute(p_board_bottom) <= 1073741824.0)), (_absolute(p_board_top) <= 1073741824.0)), (_absolute(p_bridge_half_width) <= 1073741824.0))
    _s3 = _absolute(p_gravity)
    _s4 = _logical_and(_logical_and(_logical_and(_logical_and(_s2, (_absolute(p_restitution) <= 1.2676506002282294e+30)), (_s3 <= 1073741824.0)), (9.313225746154785e-10 <= _s3)), (_absolute(p_end_depth) <= 1073741824.0))
    return _s4,


def valid(last: Any, x: Any, y: Any, z: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_bridge_half_width: Any, p_end_depth: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """1 if the ball overlaps no surface; 1 if that is undecided.

    Table 2. 129 operations: 18 additions, 19 subtractions, 11 multiplications, 2 square roots, 3 negations, 21 absolute values, 26 comparisons, 29 selections.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18, _r19, _r20, _r21, _r22, _r23, _r24, _r25, _r26, _r27, _r28, _r29, _r30, _r31, _r32, _r33 = _room[:34]
    _s0 = _sqrt(_add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1), _r1)
    _s1 = _subtract(_s0, p_ring_radius, _r0)
    _s2 = _add(_multiply(z, z, _r2), _multiply(_s1, _s1, _r0), _r0)
    _s3 = p_ball_radius + p_wire_radius
    _s4 = _subtract(_s2, _s3 * _s3, _r2)
    _s5 = _absolute(last, _r3) < _k50
    _s6 = _select(_s5, _k51, _select(_k7 <= _s4, _k51, _k7, _r3), _r4)
    _s7 = p_ball_radius - p_board_distance
    _s8 = _subtract(x, _s7, _r5)
    _s9 = 2.0 * p_ball_radius
    _s10 = _subtract(_s7 - _s9, x, _r6)
    _s11 = _select(_s8 < _s10, _s10, _s8, _r7)
    _s12 = _negative(_add(p_board_half_width, y, _r8), _r8)
    _s13 = _select(_s11 < _s12, _s12, _s11, _r9)
    _s14 = _subtract(y, p_board_half_width, _r10)
    _s15 = _select(_s13 < _s14, _s14, _s13, _r11)
    _s16 = _subtract(p_board_bottom, z, _r12)
    _s17 = _select(_s15 < _s16, _s16, _s15, _r13)
    _s18 = _subtract(z, p_board_top, _r14)
    _s19 = _select(_s17 < _s18, _s18, _s17, _r15)
    _s20 = _absolute(_subtract(last, _k51, _r16), _r16) < _k50
    _s21 = _select(_s20, _s6, _select(_k7 <= _s19, _s6, _k7, _r16), _r17)
    _s22 = _subtract(z, _s3, _r18)
    _s23 = _subtract((_s3 - _s9) - (2.0 * p_wire_radius), z, _r19)
    _s24 = _select(_s22 < _s23, _s23, _s22, _r20)
    _s25 = _negative(_add(p_bridge_half_width, y, _r21), _r21)
    _s26 = _select(_s24 < _s25, _s25, _s24, _r22)
    _s27 = _subtract(y, p_bridge_half_width, _r23)
    _s28 = _select(_s26 < _s27, _s27, _s26, _r24)
    _s29 = _subtract(p_ring_radius, _s0, _r1)
    _s30 = _select(_s28 < _s29, _s29, _s28, _r25)
    _s31 = _select(_s30 < x, x, _s30, _r26)
    _s32 = _negative(_add(p_board_distance, x, _r27), _r27)
    _s33 = _select(_s31 < _s32, _s32, _s31, _r28)
    _s34 = _absolute(_subtract(last, _k52, _r29), _r29) < _k50
    _s35 = ((((_absolute(p_board_bottom) + _absolute(p_board_top)) + _absolute(p_ball_radius)) + _absolute(p_ring_radius)) + _absolute(p_wire_radius)) + _absolute(p_board_distance)
    _s36 = _add(_add(((_s35 + _absolute(p_board_half_width)) + _absolute(p_bridge_half_width)) + _absolute(p_end_depth), _absolute(x, _r29), _r29), _absolute(y, _r30), _r30)
    _s37 = _multiply(_k53, _add(_s36, _absolute(z, _r29), _r29), _r29)
    _s38 = _multiply((4.0 * p_ball_radius) + (4.0 * p_wire_radius), _s37, _r30)
    _s39 = _select(_absolute(_subtract(_subtract(_sqrt(_s2, _r0), p_ball_radius, _r0), p_wire_radius, _r0), _r0) <= _s37, _select(_s4 <= _s38, _k7, _k51, _r0), _k51, _r31)
    _s40 = _select(_s5, _s39, _select(_absolute(_s4, _r2) <= _s38, _k51, _k7, _r2), _r30)
    _s41 = _select(_s20, _select(_absolute(_s8, _r32) <= _s37, _select(_s19 <= _s37, _s40, _k51, _r32), _k51, _r33), _select(_absolute(_s19, _r15) <= _s37, _k51, _s40, _r15), _r14)
    return _result(_s34, _s21, _select(_k7 <= _s33, _s21, _k7, _r13), _r0), _result(_s34, _select(_absolute(_s22, _r13) <= _s37, _select(_s33 <= _s37, _s41, _k51, _r13), _k51, _r17), _select(_absolute(_s33, _r28) <= _s37, _k51, _s41, _r28), _r0)


def aside(x: Any, y: Any, z: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_bridge_half_width: Any, p_end_depth: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Whether the ball starts near a surface; otherwise its start is valid and decided.

    Table 2. 45 operations: 14 additions, 5 subtractions, 3 multiplications, 1 negation, 12 absolute values, 5 comparisons, 2 conjunctions, 2 disjunctions, 1 complement.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = ((((_absolute(p_board_bottom) + _absolute(p_board_top)) + _absolute(p_ball_radius)) + _absolute(p_ring_radius)) + _absolute(p_wire_radius)) + _absolute(p_board_distance)
    _s1 = _absolute(x, _r0)
    _s2 = _add(_add(((_s0 + _absolute(p_board_half_width)) + _absolute(p_bridge_half_width)) + _absolute(p_end_depth), _s1, _r1), _absolute(y, _r2), _r2)
    _s3 = _multiply(_k56, _multiply(_k53, _add(_s2, _absolute(z, _r1), _r1), _r1), _r1)
    _s4 = p_ball_radius - p_board_distance
    _s5 = _logical_and((_s3 < _subtract(_s1, (p_ball_radius + p_ring_radius) + p_wire_radius, _r0)), _logical_or((_s3 < _subtract(x, _s4, _r0)), (_s3 < _subtract(_s4 - (2.0 * p_ball_radius), x, _r0))))
    _s6 = _logical_not(_logical_and(_s5, _logical_or((_s3 < x), (_s3 < _negative(_add(p_board_distance, x, _r0), _r0)))))
    return _s6, 1.0, 0.0


def vary_flight(t: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, change_gravity: Any) -> tuple[Any, ...]:
    """Variations of position and velocity at time t of a flight, from those at its start.

    derivative of Eq. 3. 11 operations: 3 additions, 2 subtractions, 6 multiplications.
    """
    return dx + (dvx * t), dy + (dvy * t), dz + (t * (dvz - ((0.5 * t) * change_gravity))), dvx, dvy, dvz - (t * change_gravity)


def vary_departure(vx: Any, vy: Any, vz: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, p_gravity: Any, contact_delay: Any) -> tuple[Any, ...]:
    """Variations of position and velocity after a contact, at the time of the contact.

    derivative of Eq. 3 at its start. 8 operations: 1 addition, 3 subtractions, 4 multiplications.
    """
    return dx - (vx * contact_delay), dy - (vy * contact_delay), dz - (vz * contact_delay), dvx, dvy, dvz + (p_gravity * contact_delay)


def left(index: Any, last: Any) -> tuple[Any, ...]:
    """1 if the flight starts on this surface.

    Table 1. 2 operations: 1 comparison, 1 selection.
    """
    return _where((last == index), 1.0, 0.0),


def released(last: Any) -> tuple[Any, ...]:
    """Whether the ball has touched nothing yet.

    Table 1. 2 operations: 1 comparison, 1 complement.
    """
    _s0 = last < 0.0
    return _s0, _logical_not(_s0)


def plane_root(rate: Any, bend: Any, apex: Any, time: Any) -> tuple[Any, ...]:
    """Whether a plane's only root is an arrival, the size of F'', and the nearest time.

    Table 1. 13 operations: 1 absolute value, 6 comparisons, 4 conjunctions, 1 disjunction, 1 selection.
    """
    _s0 = _logical_and(_logical_and(_logical_or((rate < 0.0), _logical_and(_logical_and((rate <= 0.0), (bend < 0.0)), (time == 0.0))), (0.0 <= time)), (time < _inf))
    return _s0, _absolute(bend), _where(_s0, time, apex)


def level_root(rate: Any, bend: Any, height: Any, time: Any, when: Any) -> tuple[Any, ...]:
    """Whether a plane's only root is an arrival, the size of F'', and the nearest time.

    Table 1. 17 operations: 1 absolute value, 8 comparisons, 4 conjunctions, 1 disjunction, 3 selections.
    """
    _s0 = _logical_and(_logical_and(_logical_or((rate < 0.0), _logical_and(_logical_and((rate <= 0.0), (bend < 0.0)), (time == 0.0))), (0.0 <= time)), (time < _inf))
    _s1 = _where(_s0, time, _where((height < 0.0), 0.0, _inf))
    return _s0, _absolute(bend), _where(when < _s1, when, _s1)


def within_time(time: Any, when: Any, delay: Any, earliest_delay: Any, arrives: Any) -> tuple[Any, ...]:
    """Whether an arrival may be the earliest within the delays.

    Table 1. 5 operations: 1 addition, 1 subtraction, 1 comparison, 1 conjunction, 1 complement.
    """
    return _logical_and(arrives, _logical_not(((delay + earliest_delay) < (time - when)))),


def apex_undecided(margin: Any, apex: Any, height: Any, undecided_time: Any) -> tuple[Any, ...]:
    """Undecided time 0 if the largest gap from the start on is zero within its error.

    Table 1. 5 operations: 1 absolute value, 2 comparisons, 1 conjunction, 1 selection.
    """
    return _where(_logical_and((0.0 <= apex), (_absolute(height) <= margin)), 0.0, undecided_time),


def side_undecided(rate: Any, margin: Any, height: Any, undecided_time: Any, velocity_error: Any) -> tuple[Any, ...]:
    """Undecided time 0 if the gap of a plane is zero within its error, and falls.

    Table 1. 7 operations: 2 multiplications, 1 absolute value, 2 comparisons, 1 conjunction, 1 selection.
    """
    return _where(_logical_and((rate < (2.0 * velocity_error)), (_absolute(height) <= (2.0 * margin))), 0.0, undecided_time),


def predicate_undecided(time: Any, undecided_time: Any, undecided: Any) -> tuple[Any, ...]:
    """Earliest undecided time, with that of an undecided predicate.

    Table 1. 3 operations: 1 comparison, 1 conjunction, 1 selection.
    """
    return _where(_logical_and(undecided, (time < undecided_time)), time, undecided_time),


def bounds_undecided(time: Any, undecided_time: Any, undecided: Any) -> tuple[Any, ...]:
    """Earliest undecided time, with that from which on a contact near an edge may be.

    Table 1. 4 operations: 1 multiplication, 1 comparison, 1 conjunction, 1 selection.
    """
    _s0 = 0.5 * time
    return _where(_logical_and(undecided, (_s0 < undecided_time)), _s0, undecided_time),


def crossing_undecided(clearance: Any, time: Any, undecided_time: Any, arrives: Any) -> tuple[Any, ...]:
    """Earliest undecided time, with that of an arrival whose crossing is not certain.

    Table 1. 6 operations: 2 comparisons, 2 conjunctions, 1 complement, 1 selection.
    """
    return _where(_logical_and(_logical_and(arrives, _logical_not((0.0 < clearance))), (time < undecided_time)), time, undecided_time),


def tie_undecided(time: Any, when: Any, delay: Any, earliest_delay: Any, undecided_time: Any, arrives: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Earliest undecided time, with that of a tie; the delay of the earlier arrival.

    Table 1. 16 operations: 1 addition, 2 subtractions, 1 multiplication, 1 absolute value, 4 comparisons, 3 conjunctions, 4 selections.
    """
    _r0, _r1, _r2, _r3 = _room[:4]
    _s0 = _add(delay, earliest_delay, _r0)
    _s1 = time < when
    _s2 = _select(_s1, time, when, _r1)
    _s3 = _multiply(_k50, _s2, _r2)
    _s4 = _subtract(_s2, _select(_s3 < _s0, _s3, _s0, _r3), _r3)
    _s5 = _result(_logical_and(_logical_and(arrives, (_absolute(_subtract(time, when, _r2), _r2) <= _s0)), (_s4 < undecided_time)), _s4, undecided_time, _r0)
    return _s5, _result(_logical_and(arrives, _s1), delay, earliest_delay, _r0)


def earliest(index: Any, time: Any, when: Any, which: Any, arrives: Any) -> tuple[Any, ...]:
    """Time and surface of the earliest arrival, with this one.

    Table 1. 4 operations: 1 comparison, 1 conjunction, 2 selections.
    """
    _s0 = _logical_and(arrives, (time < when))
    return _where(_s0, time, when), _where(_s0, index, which)


def missed() -> tuple[Any, ...]:
    """Start value: the surface is certainly missed.

    Table 1. No operations.
    """
    return 1.0,


def opens(clear: Any) -> tuple[Any, ...]:
    """Whether the flight may hit a surface.

    Table 1. 2 operations: 1 comparison, 1 complement.
    """
    return _logical_not((0.0 < clear)),


def beginning() -> tuple[Any, ...]:
    """Start values of a search: its error budget, and no arrival.

    Table 1. No operations.
    """
    return 2.9802322387695312e-08, _inf, False


def out_of_budget(pad: Any, budget_exceeded: Any, earliest_delay: Any, undecided_time: Any, excess: Any) -> tuple[Any, ...]:
    """Undecided time 0 if errors exceed the budget of a search, or its bounds fail.

    Table 1. 7 operations: 1 multiplication, 3 comparisons, 2 disjunctions, 1 selection.
    """
    return _where(_logical_or(_logical_or((0.0 < excess), (pad < (0.5 * earliest_delay))), (0.0 < budget_exceeded)), 0.0, undecided_time),


def overdue(pad: Any, earliest_delay: Any, undecided_time: Any) -> tuple[Any, ...]:
    """Undecided time 0 if the earliest arrival may be after the horizon.

    Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection.
    """
    return _where((pad < (0.5 * earliest_delay)), 0.0, undecided_time),


def nearby(t: Any, flat: Any, tilt: Any, index: Any, last: Any) -> tuple[Any, ...]:
    """1 near the surface that the ball left, where F/t is more exact than F; the margin.

    Table 1. 6 operations: 1 multiplication, 2 comparisons, 1 conjunction, 2 selections.
    """
    _s0 = t * tilt
    _s1 = _logical_and((last == index), (_s0 < flat))
    return _where(_s1, 1.0, 0.0), _where(_s1, _s0, flat)


def opened(horizon: Any, time: Any) -> tuple[Any, ...]:
    """Begin of the first window and end of the last one, from single precision.

    Table 1. No operations.
    """
    return time, horizon


def coarse(rate_margin: Any, flat: Any, ceiling: Any, share: Any, searching: Any, representable: Any, fits: Any) -> tuple[Any, ...]:
    """Whether a search begins in single precision; its ceiling, margins and error budget.

    Table 1. 6 operations: 3 conjunctions, 1 disjunction, 1 complement, 1 selection.
    """
    _s0 = _logical_and(_logical_and(searching, representable), fits)
    return _s0, _logical_or(searching, _logical_not(representable)), _s0, ceiling, flat, rate_margin, _where(_logical_and(representable, fits), share, 2.9802322387695312e-08)


def stepped(arrival: Any, lasting: Any, searching: Any, since: Any, single_precision: Any, certain: Any) -> tuple[Any, ...]:
    """Root from the search in single precision; whether and where the search goes on.

    Table 1. 7 operations: 1 addition, 1 comparison, 2 conjunctions, 1 complement, 2 selections.
    """
    _s0 = lasting + since
    return _where(certain, _s0, arrival), _where(single_precision, _s0, 0.0), _logical_and(_logical_and(searching, _logical_not(certain)), (lasting < _inf))


def gap_closes(gap: Any, rate: Any, bend: Any, margin: Any, rate_margin: Any, clearance: Any, share: Any) -> tuple[Any, ...]:
    """Whether the gap closes, certainly closes, or needs a smaller error budget.

    Table 1. 17 operations: 1 subtraction, 6 comparisons, 6 conjunctions, 2 disjunctions, 2 complements.
    """
    _s0 = _logical_or((rate < 0.0), _logical_and((rate <= rate_margin), (bend < 0.0)))
    _s1 = 0.0 < clearance
    _s2 = _logical_and(_s0, _logical_or(((gap - margin) <= margin), _s1))
    _s3 = _logical_and(_s0, _s1)
    _s4 = _logical_and(_logical_and(_s2, _logical_not(_s3)), (0.0 < share))
    return _logical_and(_s2, _logical_not(_s4)), _s3, _s4


def smaller_budget(share: Any) -> tuple[Any, ...]:
    """Next smaller error budget.

    Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection.
    """
    return _where((2.842170943040401e-14 < share), (0.03125 * share), 0.0),


def budget_undecided(t: Any, undecided_time: Any, excess: Any) -> tuple[Any, ...]:
    """Earliest undecided time, with the present one if the errors exceed the budget.

    Table 1. 4 operations: 2 comparisons, 1 conjunction, 1 selection.
    """
    return _where(_logical_and((0.0 < excess), (t < undecided_time)), t, undecided_time),


def advanced(t: Any, end: Any, step: Any, next: Any, arrival: Any, hit: Any, sure: Any, needs_refinement: Any, certain: Any) -> tuple[Any, ...]:
    """Root, time and state of a search after a step, and whether its window is exhausted.

    Table 1. 14 operations: 1 subtraction, 1 comparison, 4 conjunctions, 2 disjunctions, 3 complements, 3 selections.
    """
    _s0 = _logical_not(hit)
    _s1 = _logical_and(_logical_and(_s0, _logical_not(needs_refinement)), ((end - t) <= step))
    return _where(hit, _where(sure, next, t), arrival), _logical_or(certain, _logical_and(hit, sure)), _s1, _logical_and(_s0, _logical_not(_s1)), _where(_logical_or(hit, needs_refinement), t, next)


def found(arrival: Any) -> tuple[Any, ...]:
    """Whether a search found an arrival.

    Table 1. 1 operation: 1 comparison.
    """
    _s0 = arrival < _inf
    return _s0, _s0, 0.0


def refined_root(gap: Any, rate: Any, ceiling: Any, arrival: Any, refined: Any, certain: Any) -> tuple[Any, ...]:
    """A certain root, refined, and whether h is above 2^-24, so that it is refined again.

    Table 1. 7 operations: 3 multiplications, 1 absolute value, 1 comparison, 1 conjunction, 1 selection.
    """
    return _where(certain, refined, arrival), _logical_and(certain, ((5.960464477539063e-08 * (rate * rate)) < (ceiling * _absolute(gap))))


def own_margin(leaving: Any, flat: Any, tilt: Any, arrival: Any) -> tuple[Any, ...]:
    """Margin of the form, F or F/t, in which an arrival was found.

    Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection.
    """
    return _where((0.0 < leaving), (tilt * arrival), flat),


def arrival_time(arrival: Any) -> tuple[Any, ...]:
    """Time of an arrival, not before the flight.

    Table 1. 2 operations: 1 comparison, 1 selection.
    """
    return _where((arrival < 0.0), 0.0, arrival),


def arrival_certainty(clearance: Any, time: Any, delay: Any, undecided_time: Any, arrives: Any, certain: Any) -> tuple[Any, ...]:
    """Delay of a certain arrival; the earliest undecided time, with that of any other one.

    Table 1. 10 operations: 1 subtraction, 2 comparisons, 3 conjunctions, 1 complement, 3 selections.
    """
    _s0 = _logical_and(certain, (0.0 < clearance))
    _s1 = _where(certain, (time - delay), time)
    return _where(_s0, delay, 0.0), _where(_logical_and(_logical_and(arrives, _logical_not(_s0)), (_s1 < undecided_time)), _s1, undecided_time)


def state_in_range(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Whether all numbers of a release are small enough not to overflow.

    Table 1. 26 operations: 9 absolute values, 9 comparisons, 8 conjunctions.
    """
    _r0, = _room[:1]
    _s0 = _logical_and(_logical_and(_logical_and(_logical_and((_absolute(x, _r0) <= _k62), (_absolute(y, _r0) <= _k62)), (_absolute(z, _r0) <= _k62)), (_absolute(vx, _r0) <= _k62)), (_absolute(vy, _r0) <= _k62))
    _s1 = _logical_and(_logical_and(_logical_and(_logical_and(_s0, (_absolute(vz, _r0) <= _k62)), (_absolute(wx, _r0) <= _k62)), (_absolute(wy, _r0) <= _k62)), (_absolute(wz, _r0) <= _k62))
    return _s1,


def opening(excess: Any, position_error: Any, velocity_error: Any) -> tuple[Any, ...]:
    """Start values: no arrival; an uncertain shot if its errors are not bounded.

    Table 1. 6 operations: 3 comparisons, 2 conjunctions, 1 selection.
    """
    return _inf, -1.0, 0.0, _where(_logical_and(_logical_and((position_error < _inf), (velocity_error < _inf)), (excess <= 0.0)), _inf, 0.0)


def limited(time_limit: Any) -> tuple[Any, ...]:
    """Whether there is a time limit.

    Table 1. 1 operation: 1 comparison.
    """
    return time_limit < _inf,


def event_clock(when: Any, clock: Any) -> tuple[Any, ...]:
    """Time of the event.

    Table 1. 1 operation: 1 addition.
    """
    return when + clock,


def flight_undecided(when: Any, earliest_delay: Any, undecided_time: Any, uncertain: Any, edge: Any) -> tuple[Any, ...]:
    """1 if a decision up to this event, or the choice of the end, lies within its error.

    Table 1. 7 operations: 1 addition, 2 comparisons, 1 conjunction, 1 disjunction, 1 complement, 1 selection.
    """
    _s0 = _where(_logical_or(_logical_and(_logical_not(((when + earliest_delay) < undecided_time)), (undecided_time < _inf)), edge), 1.0, uncertain)
    return _s0,


def meeting(claims: Any, ends: Any, touches: Any) -> tuple[Any, ...]:
    """Whether an event changes the motion, or its errors are wanted.

    Table 1. 3 operations: 1 comparison, 1 conjunction, 1 disjunction.
    """
    return _logical_or(touches, _logical_and(ends, (0.0 < claims))),


def here(index: Any, which: Any) -> tuple[Any, ...]:
    """Whether the event is on a surface.

    Table 1. 1 operation: 1 comparison.
    """
    return which == index,


def counted(count: Any) -> tuple[Any, ...]:
    """One more contact.

    Table 1. 1 operation: 1 addition.
    """
    return 1.0 + count,


def without_bounds(unbounded: Any, uncertain: Any) -> tuple[Any, ...]:
    """1 if a bound on an error is not finite.

    Table 1. 1 operation: 1 selection.
    """
    return _where(unbounded, 1.0, uncertain),


def tightens(tightening: Any, touches: Any) -> tuple[Any, ...]:
    """How the bounds on errors are carried over a contact.

    Table 1. 4 operations: 2 comparisons, 2 conjunctions.
    """
    return _logical_and(touches, (tightening <= 0.0)), _logical_and(touches, (0.0 < tightening))


def came_back(last: Any, which: Any) -> tuple[Any, ...]:
    """1 if the flight began on the surface that the ball meets.

    Table 1. 2 operations: 1 comparison, 1 selection.
    """
    return _where((last == which), 1.0, 0.0),


def touched(which: Any, body: Any, first: Any) -> tuple[Any, ...]:
    """Body touched first and surface touched last.

    Table 1. 2 operations: 1 comparison, 1 selection.
    """
    return _where((first < 0.0), body, first), which


def ends_by_time_limit(index: Any, which: Any, claims: Any) -> tuple[Any, ...]:
    """Whether a shot has ended at the time limit and its errors are wanted.

    Table 1. 3 operations: 2 comparisons, 1 conjunction.
    """
    return _logical_and((which == index), (0.0 < claims)),


def body_of(which: Any) -> tuple[Any, ...]:
    """Body that the event is on.

    Table 1. No operations.
    """
    return which,


def admitted(undecided_time: Any, valid: Any, permitted: Any, in_range: Any) -> tuple[Any, ...]:
    """Outcome of a shot at its start, and whether that is uncertain.

    Table 1. 7 operations: 2 comparisons, 3 conjunctions, 2 selections.
    """
    _s0 = _logical_and(permitted, in_range)
    return _where(_logical_and(_s0, (0.0 < valid)), -1.0, 4.0), _where(_logical_and(_s0, (0.0 < undecided_time)), 1.0, 0.0)


def loose(contacts: Any, outcome: Any, uncertain: Any) -> tuple[Any, ...]:
    """Whether a shot that has ended may be certain with tighter bounds: it is not capped.

    Table 1. 6 operations: 3 comparisons, 2 conjunctions, 1 complement.
    """
    return _logical_and(_logical_and((0.0 < uncertain), (0.0 < contacts)), _logical_not((outcome == 2.0))),


def expiry(when: Any, which: Any, earliest_delay: Any, undecided_time: Any, time_error: Any, clock: Any, time_limit: Any) -> tuple[Any, ...]:
    """The time limit as an arrival.

    Table 1. 12 operations: 2 additions, 1 subtraction, 1 multiplication, 4 comparisons, 1 conjunction, 1 complement, 2 selections.
    """
    _s0 = time_limit - clock
    return _where(0.0 < _s0, _s0, 0.0), time_error + (4.440892098500626e-16 * time_limit), 0.0 <= which, _where(_logical_and(_logical_not(((when + earliest_delay) < undecided_time)), (undecided_time < _inf)), 0.0, undecided_time)


def departed(index: Any, which: Any) -> tuple[Any, ...]:
    """Whether there is no event, an end, or a contact, and the outcome without one.

    Table 1. 5 operations: 3 comparisons, 1 conjunction, 1 complement.
    """
    _s0 = which < 0.0
    _s1 = _logical_not(_s0)
    return _s0, _s1, index <= which, _logical_and(_s1, (which < index)), 3.0, False


def expired(index: Any, which: Any, body: Any, clock: Any, reached: Any, time_limit: Any, ends: Any) -> tuple[Any, ...]:
    """Time, body and outcome of a shot that the time limit ends.

    Table 1. 6 operations: 1 comparison, 1 conjunction, 1 complement, 3 selections.
    """
    _s0 = which == index
    return _where(_s0, time_limit, clock), _where(_s0, 3.0, body), _where(_s0, 6.0, reached), _logical_and(ends, _logical_not(_s0))


def accounted(contacts: Any, most_contacts: Any, reached: Any, touches: Any) -> tuple[Any, ...]:
    """Number of contacts, and the outcome if the shot ends.

    Table 1. 5 operations: 1 addition, 1 comparison, 3 selections.
    """
    _s0 = 1.0 + contacts
    return _where(touches, _s0, contacts), _where(touches, _where((most_contacts <= _s0), 2.0, -1.0), reached)


def clock_error_sum(delay: Any, clock_error: Any) -> tuple[Any, ...]:
    """Sum of the errors of the contacts' times.

    Table 1. 1 operation: 1 addition.
    """
    delay, clock_error, = [_single(value) for value in (delay, clock_error,)]
    return delay + clock_error,


def closing(outcome: Any, claims: Any) -> tuple[Any, ...]:
    """Whether bounds on errors are wanted here, and their start values.

    Table 1. 5 operations: 3 comparisons, 1 conjunction, 1 disjunction.
    """
    outcome, claims, = [_single(value) for value in (outcome, claims,)]
    return _logical_or(_logical_and((_float32(0.0) < claims), (_float32(0.0) <= outcome)), (_float32(1.0) < claims)), _float32(0.0), _float32(0.0), _float32(0.0), _float32(0.0)


def reachable(p_ball_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_gravity: Any, p_ring_radius: Any, x: Any, vx: Any, horizon: Any, extent: Any, speed: Any, pad: Any, earliest_delay: Any, position_error: Any, velocity_error: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Whether a flight with these ends may come to a plate.

    Table 1. 34 operations: 6 additions, 3 subtractions, 10 multiplications, 1 negation, 7 comparisons, 2 conjunctions, 1 complement, 4 selections.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7 = _room[:8]
    _s0 = _add(_add(position_error, _multiply(horizon, velocity_error, _r0), _r0), _multiply(_k66, _add(extent, _multiply(horizon, _add(speed, _multiply(p_gravity, horizon, _r1), _r1), _r1), _r1), _r1), _r1)
    _s1 = _select(pad < earliest_delay, _k8, _s0, _r0)
    _s2 = _add(x, _multiply(vx, horizon, _r2), _r2)
    _s3 = _select(_s2 < x, _s2, x, _r3)
    _s4 = _subtract(p_ring_radius, _multiply(_k52, _s1, _r4), _r4)
    _s5 = -p_board_distance
    _s6 = _select(_s3 < _s5, _s5, _s3, _r5)
    _s7 = _select(_k7 < _s6, _k7, _s6, _r6)
    _s8 = _logical_and((_s1 < _subtract(_s3, p_ball_radius - p_board_distance, _r7)), _logical_and((_k7 < _s4), (_multiply(_k67, _add(p_bridge_half_width * p_bridge_half_width, _multiply(_s7, _s7, _r6), _r6), _r6) < _multiply(_s4, _s4, _r4))))
    return _logical_not(_s8),


def plane_start(p_gravity: Any, undecided_time: Any, position_error: Any, velocity_error: Any) -> tuple[Any, ...]:
    """Undecided time 0 if errors are too large to decide on which side a flight begins.

    Table 1. 8 operations: 4 multiplications, 1 negation, 1 absolute value, 1 comparison, 1 selection.
    """
    _s0 = 2.0 * velocity_error
    _s1 = _where(((position_error * (0.5 * _absolute((-p_gravity)))) < (_s0 * _s0)), 0.0, undecided_time)
    return _s1,


def tighten_impact(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, clock: Any, left_nx: Any, left_ny: Any, left_nz: Any, place_n: Any, place_s: Any, place_e: Any, pace_n: Any, pace_s: Any, pace_e: Any, turn_n: Any, turn_z: Any, position_bound: Any, velocity_bound: Any, spin_bound: Any, tangent_x: Any, tangent_y: Any, bend_s: Any, bend_e: Any, left_ex: Any, left_ey: Any, left_bend_s: Any, left_bend_e: Any, sharpest_bend: Any, root_offset: Any, root_level: Any, normal_rounding: Any, normal_velocity: Any, back: Any, origin_s: Any, origin_e: Any, origin_u: Any, origin_v: Any, origin_w: Any, origin_t: Any, product_11: Any, product_12: Any, product_13: Any, product_14: Any, product_15: Any, product_16: Any, product_21: Any, product_22: Any, product_23: Any, product_24: Any, product_25: Any, product_26: Any, product_31: Any, product_32: Any, product_33: Any, product_34: Any, product_35: Any, product_36: Any, product_41: Any, product_42: Any, product_43: Any, product_44: Any, product_45: Any, product_46: Any, product_51: Any, product_52: Any, product_53: Any, product_54: Any, product_55: Any, product_56: Any, product_61: Any, product_62: Any, product_63: Any, product_64: Any, product_65: Any, product_66: Any, recent_s: Any, recent_e: Any, recent_u: Any, recent_v: Any, recent_w: Any, recent_t: Any, continued: Any, p_ball_radius: Any, p_restitution: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The same, through the product of derivatives since an earlier contact.

    derivative of the frame-free Eq. 17, with roundings. 1515 operations: 469 additions, 68 subtractions, 712 multiplications, 7 divisions, 40 negations, 129 absolute values, 16 comparisons, 74 selections.
    """
    t, x, y, z, vx, vy, vz, wx, wy, wz, nx, ny, nz, clock, left_nx, left_ny, left_nz, place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, tangent_x, tangent_y, bend_s, bend_e, left_ex, left_ey, left_bend_s, left_bend_e, sharpest_bend, root_offset, root_level, normal_rounding, normal_velocity, back, origin_s, origin_e, origin_u, origin_v, origin_w, origin_t, product_11, product_12, product_13, product_14, product_15, product_16, product_21, product_22, product_23, product_24, product_25, product_26, product_31, product_32, product_33, product_34, product_35, product_36, product_41, product_42, product_43, product_44, product_45, product_46, product_51, product_52, product_53, product_54, product_55, product_56, product_61, product_62, product_63, product_64, product_65, product_66, recent_s, recent_e, recent_u, recent_v, recent_w, recent_t, continued, p_ball_radius, p_restitution, p_gravity, = [_single(value) for value in (t, x, y, z, vx, vy, vz, wx, wy, wz, nx, ny, nz, clock, left_nx, left_ny, left_nz, place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, tangent_x, tangent_y, bend_s, bend_e, left_ex, left_ey, left_bend_s, left_bend_e, sharpest_bend, root_offset, root_level, normal_rounding, normal_velocity, back, origin_s, origin_e, origin_u, origin_v, origin_w, origin_t, product_11, product_12, product_13, product_14, product_15, product_16, product_21, product_22, product_23, product_24, product_25, product_26, product_31, product_32, product_33, product_34, product_35, product_36, product_41, product_42, product_43, product_44, product_45, product_46, product_51, product_52, product_53, product_54, product_55, product_56, product_61, product_62, product_63, product_64, product_65, product_66, recent_s, recent_e, recent_u, recent_v, recent_w, recent_t, continued, p_ball_radius, p_restitution, p_gravity,)]
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18, _r19, _r20, _r21, _r22, _r23, _r24, _r25, _r26, _r27, _r28, _r29, _r30, _r31, _r32, _r33, _r34, _r35, _r36, _r37, _r38, _r39, _r40, _r41, _r42, _r43, _r44, _r45, _r46, _r47, _r48, _r49, _r50, _r51, _r52, _r53, _r54, _r55, _r56, _r57, _r58, _r59, _r60, _r61, _r62, _r63, _r64, _r65, _r66, _r67, _r68, _r69, _r70, _r71, _r72, _r73, _r74, _r75, _r76, _r77, _r78, _r79, _r80, _r81, _r82, _r83, _r84, _r85, _r86, _r87, _r88, _r89, _r90, _r91, _r92, _r93, _r94, _r95, _r96, _r97, _r98, _r99, _r100, _r101, _r102, _r103, _r104, _r105, _r106, _r107, _r108, _r109, _r110, _r111, _r112, _r113, _r114, _r115, _r116, _r117, _r118, _r119, _r120, _r121, _r122 = _halves(_room[:123])
    _s0 = _negative(_multiply(p_gravity, nz, _r0), _r0)
    _s1 = _absolute(vx, _r1)
    _s2 = _multiply(_k22, t, _r2)
    _s3 = _add(_k24, _multiply(_k25, _add(_multiply(_s2, _s1, _r3), _absolute(x, _r4), _r4), _r4), _r4)
    _s4 = _absolute(vy, _r3)
    _s5 = _add(_k24, _multiply(_k25, _add(_multiply(_s2, _s4, _r5), _absolute(y, _r6), _r6), _r6), _r6)
    _s6 = _k23 * p_gravity
    _s7 = _add(_add(_multiply(_s6, _multiply(t, t, _r5), _r5), _multiply(_s2, _absolute(_add(vz, _multiply(_s6, t, _r7), _r7), _r7), _r7), _r7), _absolute(z, _r5), _r5)
    _s8 = _add(_k24, _multiply(_k25, _s7, _r5), _r5)
    _s9 = _add(_add(_add(position_bound, _multiply(t, velocity_bound, _r7), _r7), _add(_add(_s3, _s5, _r2), _s8, _r2), _r2), _select(root_offset < root_level, root_level, root_offset, _r7), _r7)
    _s10 = _add(_add(_multiply(nx, left_nx, _r2), _multiply(ny, left_ny, _r8), _r8), _multiply(nz, left_nz, _r2), _r2)
    _s11 = _subtract(_s10, back, _r8)
    _s12 = _multiply(nz, tangent_y, _r9)
    _s13 = _negative(_multiply(nz, tangent_x, _r10), _r10)
    _s14 = _add(_multiply(left_ex, _s12, _r11), _multiply(left_ey, _s13, _r12), _r12)
    _s15 = _multiply(left_bend_s, _s14, _r11)
    _s16 = _add(_multiply(vx, tangent_x, _r13), _multiply(vy, tangent_y, _r14), _r14)
    _s17 = _add(_multiply(tangent_x, left_ex, _r13), _multiply(tangent_y, left_ey, _r15), _r15)
    _s18 = _multiply(left_bend_s, _s17, _r13)
    _s19 = _subtract(_multiply(ny, tangent_x, _r16), _multiply(nx, tangent_y, _r17), _r17)
    _s20 = _add(_add(_multiply(vx, _s12, _r16), _multiply(vy, _s13, _r18), _r18), _multiply(vz, _s19, _r16), _r16)
    _s21 = _negative(_multiply(p_gravity, _s19, _r18), _r18)
    _s22 = _subtract(_s20, _multiply(t, _s21, _r19), _r19)
    _s23 = _subtract(_multiply(_s15, _s16, _r20), _multiply(_s18, _s22, _r21), _r21)
    _s24 = _multiply(left_nz, left_ey, _r20)
    _s25 = _negative(_multiply(left_nz, left_ex, _r22), _r22)
    _s26 = _subtract(_multiply(left_ny, left_ex, _r23), _multiply(left_nx, left_ey, _r24), _r24)
    _s27 = _add(_add(_multiply(nx, _s24, _r23), _multiply(ny, _s25, _r25), _r25), _multiply(nz, _s26, _r23), _r23)
    _s28 = _add(_multiply(t, _s23, _r25), _s27, _r25)
    _s29 = _multiply(left_bend_e, _s19, _r26)
    _s30 = _multiply(_s29, _s16, _r27)
    _s31 = _add(_multiply(nx, left_ex, _r28), _multiply(ny, left_ey, _r29), _r29)
    _s32 = _add(_multiply(t, _s30, _r28), _s31, _r28)
    _s33 = _multiply(t, _s10, _r30)
    _s34 = _multiply(t, _s27, _r31)
    _s35 = _add(_add(_add(_add(_multiply(place_n, _absolute(_s11, _r32), _r32), _multiply(place_s, _absolute(_s28, _r33), _r33), _r33), _multiply(place_e, _absolute(_s32, _r32), _r32), _r32), _multiply(pace_n, _absolute(_s33, _r33), _r33), _r33), _multiply(pace_s, _absolute(_s34, _r32), _r32), _r32)
    _s36 = _multiply(t, _s31, _r33)
    _s37 = _multiply(p_gravity, t, _r34)
    _s38 = _absolute(vz, _r35)
    _s39 = _add(_add(_s1, _s4, _r36), _s38, _r36)
    _s40 = _add(_multiply(place_s, left_bend_s, _r37), _multiply(place_e, left_bend_e, _r38), _r38)
    _s41 = _multiply(_add(_s37, _s39, _r37), _s40, _r37)
    _s42 = _multiply(_k69, _add(_multiply(t, _s41, _r39), _s9, _r39), _r39)
    _s43 = _add(_add(_add(root_offset, _multiply(_multiply(_k70, _multiply(sharpest_bend, _s9, _r40), _r40), _s9, _r40), _r40), _add(_s35, _multiply(pace_e, _absolute(_s36, _r41), _r41), _r41), _r41), _s42, _r41)
    _s44 = _absolute(normal_velocity, _r40)
    _s45 = _divide(_multiply(_k26, _s43, _r41), _s44, _r41)
    _s46 = _add(_k24, _multiply(_k25, _add(_add(_add(_s37, _s1, _r34), _s4, _r34), _s38, _r34), _r34), _r34)
    _s47 = _add(velocity_bound, _s46, _r35)
    _s48 = _add(_multiply(p_gravity, _s45, _r3), _s47, _r3)
    _s49 = _add(_s48, _s39, _r1)
    _s50 = _add(_multiply(_s45, _s49, _r32), _s9, _r32)
    _s51 = _multiply(_k70, sharpest_bend, _r7)
    _s52 = _multiply(_s51, _s50, _r42)
    _s53 = _subtract(_multiply(_k28, _add(_add(_multiply(_absolute(_s0, _r43), _s45, _r43), _multiply(_s52, _s49, _r44), _r44), _s47, _r44), _r44), _s44, _r44)
    _s54 = _subtract(_multiply(_k71, _multiply(sharpest_bend, _s50, _r43), _r43), _k72, _r43)
    _s55 = _select(_s53 < _s54, _s54, _s53, _r45)
    _s56 = _add(_multiply(_s6, _multiply(_s45, _s45, _r46), _r46), _multiply(_s45, _s47, _r35), _r35)
    _s57 = _divide(_add(_multiply(_s52, _s50, _r46), _s56, _r46), _s44, _r46)
    _s58 = _add(_multiply(_s57, _s39, _r47), _s56, _r47)
    _s59 = _add(_add(root_level, _s58, _r35), _add(_add(_multiply(_absolute(nx, _r48), _s3, _r48), _multiply(_absolute(ny, _r49), _s5, _r49), _r49), _multiply(_absolute(nz, _r48), _s8, _r48), _r48), _r48)
    _s60 = _multiply(bend_s, _s59, _r35)
    _s61 = _subtract(_multiply(_k73, _add(_multiply(place_n, left_bend_s, _r49), _s60, _r49), _r49), _k72, _r49)
    _s62 = _multiply(_k27, _s59, _r48)
    _s63 = _select(_s55 < _s61, _s61, _s55, _r50) <= _k29
    _s64 = _divide(_k72, normal_velocity, _r50)
    _s65 = _negative(_multiply(_s64, _s36, _r33), _r33)
    _s66 = _add(_multiply(_s65, _s20, _r49), _multiply(t, _s14, _r45), _r45)
    _s67 = _k29 < continued
    _s68 = _select(_s67, product_51, _k29, _r49)
    _s69 = _negative(_multiply(_s64, _s33, _r30), _r30)
    _s70 = _add(_add(_multiply(left_nx, _s12, _r43), _multiply(left_ny, _s13, _r44), _r44), _multiply(left_nz, _s19, _r43), _r43)
    _s71 = _add(_multiply(_s69, _s20, _r44), _multiply(t, _s70, _r51), _r51)
    _s72 = _select(_s67, product_31, _k29, _r44)
    _s73 = _negative(_multiply(_s64, _s34, _r31), _r31)
    _s74 = _add(_add(_multiply(_s13, _s25, _r52), _multiply(_s12, _s24, _r53), _r53), _multiply(_s19, _s26, _r24), _r24)
    _s75 = _add(_multiply(_s73, _s20, _r53), _multiply(t, _s74, _r52), _r52)
    _s76 = _select(_s67, product_41, _k29, _r53)
    _s77 = _negative(_multiply(_s64, _s32, _r28), _r28)
    _s78 = _multiply(nz, left_bend_e, _r54)
    _s79 = _negative(_multiply(_s78, _s16, _r55), _r55)
    _s80 = _add(_multiply(_s77, _s20, _r56), _add(_multiply(t, _s79, _r57), _s14, _r57), _r57)
    _s81 = _select(_s67, product_21, _k29, _r56)
    _s82 = _negative(_multiply(_s64, _s28, _r25), _r25)
    _s83 = _subtract(normal_velocity, _multiply(t, _s0, _r58), _r58)
    _s84 = _multiply(left_bend_s, _s31, _r59)
    _s85 = _subtract(_multiply(_s18, _s83, _r60), _multiply(_s84, _s16, _r61), _r61)
    _s86 = _add(_multiply(_s82, _s20, _r60), _add(_multiply(t, _s85, _r62), _s74, _r62), _r62)
    _s87 = _select(_s67, product_11, _k72, _r60)
    _s88 = _add(_add(_add(_multiply(_s66, _s68, _r63), _multiply(_s71, _s72, _r64), _r64), _multiply(_s75, _s76, _r63), _r63), _multiply(_s80, _s81, _r64), _r64) + _multiply(_s86, _s87, _r63)
    _s89 = _result(_s67, origin_s, place_s, _r0)
    _s90 = _select(_s67, product_52, _k29, _r63)
    _s91 = _select(_s67, product_32, _k29, _r64)
    _s92 = _select(_s67, product_42, _k29, _r65)
    _s93 = _select(_s67, product_22, _k72, _r66)
    _s94 = _select(_s67, product_12, _k29, _r67)
    _s95 = _add(_add(_add(_multiply(_s66, _s90, _r68), _multiply(_s71, _s91, _r69), _r69), _multiply(_s75, _s92, _r68), _r68), _multiply(_s80, _s93, _r69), _r69) + _multiply(_s86, _s94, _r68)
    _s96 = _result(_s67, origin_e, place_e, _r0)
    _s97 = _select(_s67, product_53, _k29, _r68)
    _s98 = _select(_s67, product_33, _k72, _r69)
    _s99 = _select(_s67, product_43, _k29, _r70)
    _s100 = _select(_s67, product_23, _k29, _r71)
    _s101 = _select(_s67, product_13, _k29, _r72)
    _s102 = _add(_add(_add(_multiply(_s66, _s97, _r73), _multiply(_s71, _s98, _r74), _r74), _multiply(_s75, _s99, _r73), _r73), _multiply(_s80, _s100, _r74), _r74) + _multiply(_s86, _s101, _r73)
    _s103 = _result(_s67, origin_u, pace_n, _r0)
    _s104 = _select(_s67, product_54, _k29, _r73)
    _s105 = _select(_s67, product_34, _k29, _r74)
    _s106 = _select(_s67, product_44, _k72, _r75)
    _s107 = _select(_s67, product_24, _k29, _r76)
    _s108 = _select(_s67, product_14, _k29, _r77)
    _s109 = _add(_add(_add(_multiply(_s66, _s104, _r78), _multiply(_s71, _s105, _r79), _r79), _multiply(_s75, _s106, _r78), _r78), _multiply(_s80, _s107, _r79), _r79) + _multiply(_s86, _s108, _r78)
    _s110 = _result(_s67, origin_v, pace_s, _r0)
    _s111 = _select(_s67, product_55, _k72, _r78)
    _s112 = _select(_s67, product_35, _k29, _r79)
    _s113 = _select(_s67, product_45, _k29, _r80)
    _s114 = _select(_s67, product_25, _k29, _r81)
    _s115 = _select(_s67, product_15, _k29, _r82)
    _s116 = _add(_add(_add(_multiply(_s66, _s111, _r83), _multiply(_s71, _s112, _r84), _r84), _multiply(_s75, _s113, _r83), _r83), _multiply(_s80, _s114, _r84), _r84) + _multiply(_s86, _s115, _r83)
    _s117 = _result(_s67, origin_w, pace_e, _r0)
    _s118 = _add(_add(_add(_add(_multiply(_absolute(_s88, _r83), _s89, _r83), _multiply(_absolute(_s95, _r84), _s96, _r84), _r84), _multiply(_absolute(_s102, _r83), _s103, _r83), _r83), _multiply(_absolute(_s109, _r84), _s110, _r84), _r84), _multiply(_absolute(_s116, _r83), _s117, _r83), _r83)
    _s119 = _select(_s67, product_56, _k29, _r84)
    _s120 = _select(_s67, product_36, _k29, _r85)
    _s121 = _select(_s67, product_46, _k29, _r86)
    _s122 = _select(_s67, product_26, _k29, _r87)
    _s123 = _select(_s67, product_16, _k29, _r88)
    _s124 = _add(_add(_add(_multiply(_s66, _s119, _r89), _multiply(_s71, _s120, _r90), _r90), _multiply(_s75, _s121, _r89), _r89), _multiply(_s80, _s122, _r90), _r90) + _multiply(_s86, _s123, _r89)
    _s125 = _result(_s67, origin_t, turn_n, _r0)
    _s126 = _add(_s118, _multiply(_absolute(_s124, _r89), _s125, _r89), _r89)
    _s127 = _absolute(_s20, _r83)
    _s128 = _divide(_add(root_offset, _s42, _r90), _s44, _r90)
    _s129 = _add(_multiply(_s127, _s128, _r91), _add(_add(_multiply(_absolute(_s13, _r92), _s5, _r92), _multiply(_absolute(_s12, _r93), _s3, _r93), _r93), _multiply(_absolute(_s19, _r92), _s8, _r92), _r92), _r92)
    _s130 = _add(_add(_s58, _multiply(_k69, _s50, _r32), _r32), _s42, _r32)
    _s131 = _negative(_multiply(_s64, _s11, _r50), _r50)
    _s132 = _add(_multiply(_s131, _s20, _r8), _s70, _r8)
    _s133 = _add(_multiply(_k74, pace_e, _r39), _select(_s67, recent_w, _k29, _r91), _r91)
    _s134 = _add(_multiply(_k74, pace_n, _r39), _select(_s67, recent_u, _k29, _r93), _r93)
    _s135 = _add(_multiply(_k74, pace_s, _r39), _select(_s67, recent_v, _k29, _r94), _r94)
    _s136 = _add(_multiply(_k74, place_e, _r39), _select(_s67, recent_e, _k29, _r95), _r95)
    _s137 = _add(_add(_add(_add(_multiply(place_n, _absolute(_s132, _r39), _r39), _multiply(_absolute(_s66, _r96), _s133, _r96), _r96), _multiply(_absolute(_s71, _r39), _s134, _r39), _r39), _multiply(_absolute(_s75, _r96), _s135, _r96), _r96), _multiply(_absolute(_s80, _r39), _s136, _r39), _r39)
    _s138 = _add(_multiply(_k74, place_s, _r96), _select(_s67, recent_s, _k29, _r97), _r97)
    _s139 = _k27 * _add(_add(_s129, _s130, _r96), _add(_s137, _multiply(_absolute(_s86, _r98), _s138, _r98), _r98), _r98)
    _s140 = _multiply(_k27, _add(_s126, _s139, _r98), _r98)
    _s141 = _add(_multiply(_s65, _s16, _r96), _multiply(t, _s17, _r39), _r39)
    _s142 = _add(_multiply(left_nx, tangent_x, _r96), _multiply(left_ny, tangent_y, _r99), _r99)
    _s143 = _add(_multiply(_s69, _s16, _r96), _multiply(t, _s142, _r100), _r100)
    _s144 = _add(_multiply(tangent_x, _s24, _r20), _multiply(tangent_y, _s25, _r22), _r22)
    _s145 = _add(_multiply(_s73, _s16, _r20), _multiply(t, _s144, _r96), _r96)
    _s146 = _subtract(_multiply(_s78, _s22, _r20), _multiply(_s29, _s83, _r101), _r101)
    _s147 = _add(_multiply(_s77, _s16, _r20), _add(_multiply(t, _s146, _r102), _s17, _r102), _r102)
    _s148 = _subtract(_multiply(_s84, _s22, _r19), _multiply(_s15, _s83, _r58), _r58)
    _s149 = _add(_multiply(_s82, _s16, _r19), _add(_multiply(t, _s148, _r20), _s144, _r20), _r20)
    _s150 = _add(_add(_add(_multiply(_s141, _s68, _r19), _multiply(_s143, _s72, _r103), _r103), _multiply(_s145, _s76, _r19), _r19), _multiply(_s147, _s81, _r103), _r103) + _multiply(_s149, _s87, _r19)
    _s151 = _add(_add(_add(_multiply(_s141, _s90, _r19), _multiply(_s143, _s91, _r103), _r103), _multiply(_s145, _s92, _r19), _r19), _multiply(_s147, _s93, _r103), _r103) + _multiply(_s149, _s94, _r19)
    _s152 = _add(_add(_add(_multiply(_s141, _s97, _r19), _multiply(_s143, _s98, _r103), _r103), _multiply(_s145, _s99, _r19), _r19), _multiply(_s147, _s100, _r103), _r103) + _multiply(_s149, _s101, _r19)
    _s153 = _add(_add(_add(_multiply(_s141, _s104, _r19), _multiply(_s143, _s105, _r103), _r103), _multiply(_s145, _s106, _r19), _r19), _multiply(_s147, _s107, _r103), _r103) + _multiply(_s149, _s108, _r19)
    _s154 = _add(_add(_add(_multiply(_s141, _s111, _r19), _multiply(_s143, _s112, _r103), _r103), _multiply(_s145, _s113, _r19), _r19), _multiply(_s147, _s114, _r103), _r103) + _multiply(_s149, _s115, _r19)
    _s155 = _add(_add(_add(_add(_multiply(_absolute(_s150, _r19), _s89, _r19), _multiply(_absolute(_s151, _r103), _s96, _r103), _r103), _multiply(_absolute(_s152, _r19), _s103, _r19), _r19), _multiply(_absolute(_s153, _r103), _s110, _r103), _r103), _multiply(_absolute(_s154, _r19), _s117, _r19), _r19)
    _s156 = _add(_add(_add(_multiply(_s141, _s119, _r103), _multiply(_s143, _s120, _r104), _r104), _multiply(_s145, _s121, _r103), _r103), _multiply(_s147, _s122, _r104), _r104) + _multiply(_s149, _s123, _r103)
    _s157 = _add(_s155, _multiply(_absolute(_s156, _r103), _s125, _r103), _r103)
    _s158 = _absolute(_s16, _r19)
    _s159 = _absolute(_k37)
    _s160 = _add(_multiply(_s158, _s128, _r104), _add(_add(_multiply(_s159, _s8, _r5), _multiply(_absolute(tangent_x, _r105), _s3, _r105), _r105), _multiply(_absolute(tangent_y, _r5), _s5, _r5), _r5), _r5)
    _s161 = _add(_multiply(_s131, _s16, _r104), _s142, _r104)
    _s162 = _add(_add(_add(_add(_multiply(place_n, _absolute(_s161, _r105), _r105), _multiply(_absolute(_s141, _r6), _s133, _r6), _r6), _multiply(_absolute(_s143, _r105), _s134, _r105), _r105), _multiply(_absolute(_s145, _r6), _s135, _r6), _r6), _multiply(_absolute(_s147, _r105), _s136, _r105), _r105)
    _s163 = _k27 * _add(_add(_s160, _s130, _r6), _add(_s162, _multiply(_absolute(_s149, _r4), _s138, _r4), _r4), _r4)
    _s164 = _multiply(_k27, _add(_s157, _s163, _r4), _r4)
    _s165 = _negative(_multiply(p_restitution, _s0, _r0), _r0)
    _s166 = _negative(_multiply(bend_s, _s20, _r6), _r6)
    _s167 = _negative(_multiply(p_restitution, _s166, _r105), _r105)
    _s168 = _multiply(bend_e, _s19, _r106)
    _s169 = _multiply(_s168, _s16, _r107)
    _s170 = _negative(_multiply(p_restitution, _s169, _r108), _r108)
    _s171 = _subtract(_subtract(_add(_multiply(_s165, _s65, _r109), _negative(_multiply(p_restitution, _s31, _r110), _r110), _r110), _multiply(_s167, _s66, _r109), _r109), _multiply(_s170, _s141, _r110), _r110)
    _s172 = _subtract(_subtract(_add(_multiply(_s165, _s69, _r109), _negative(_multiply(p_restitution, _s10, _r111), _r111), _r111), _multiply(_s167, _s71, _r109), _r109), _multiply(_s170, _s143, _r111), _r111)
    _s173 = _subtract(_subtract(_add(_multiply(_s165, _s73, _r109), _negative(_multiply(p_restitution, _s27, _r112), _r112), _r112), _multiply(_s167, _s75, _r109), _r109), _multiply(_s170, _s145, _r112), _r112)
    _s174 = _subtract(_subtract(_add(_multiply(_s165, _s77, _r109), _negative(_multiply(p_restitution, _s30, _r27), _r27), _r27), _multiply(_s167, _s80, _r109), _r109), _multiply(_s170, _s147, _r27), _r27)
    _s175 = _subtract(_subtract(_add(_multiply(_s165, _s82, _r109), _negative(_multiply(p_restitution, _s23, _r21), _r21), _r21), _multiply(_s167, _s86, _r109), _r109), _multiply(_s170, _s149, _r21), _r21)
    _s176 = _add(_add(_add(_multiply(_s171, _s68, _r109), _multiply(_s172, _s72, _r113), _r113), _multiply(_s173, _s76, _r109), _r109), _multiply(_s174, _s81, _r113), _r113) + _multiply(_s175, _s87, _r109)
    _s177 = _add(_add(_add(_multiply(_s171, _s90, _r109), _multiply(_s172, _s91, _r113), _r113), _multiply(_s173, _s92, _r109), _r109), _multiply(_s174, _s93, _r113), _r113) + _multiply(_s175, _s94, _r109)
    _s178 = _add(_add(_add(_multiply(_s171, _s97, _r109), _multiply(_s172, _s98, _r113), _r113), _multiply(_s173, _s99, _r109), _r109), _multiply(_s174, _s100, _r113), _r113) + _multiply(_s175, _s101, _r109)
    _s179 = _add(_add(_add(_multiply(_s171, _s104, _r109), _multiply(_s172, _s105, _r113), _r113), _multiply(_s173, _s106, _r109), _r109), _multiply(_s174, _s107, _r113), _r113) + _multiply(_s175, _s108, _r109)
    _s180 = _add(_add(_add(_multiply(_s171, _s111, _r109), _multiply(_s172, _s112, _r113), _r113), _multiply(_s173, _s113, _r109), _r109), _multiply(_s174, _s114, _r113), _r113) + _multiply(_s175, _s115, _r109)
    _s181 = _add(_add(_add(_add(_multiply(_absolute(_s176, _r109), _s89, _r109), _multiply(_absolute(_s177, _r113), _s96, _r113), _r113), _multiply(_absolute(_s178, _r109), _s103, _r109), _r109), _multiply(_absolute(_s179, _r113), _s110, _r113), _r113), _multiply(_absolute(_s180, _r109), _s117, _r109), _r109)
    _s182 = _add(_add(_add(_multiply(_s171, _s119, _r113), _multiply(_s172, _s120, _r114), _r114), _multiply(_s173, _s121, _r113), _r113), _multiply(_s174, _s122, _r114), _r114) + _multiply(_s175, _s123, _r113)
    _s183 = _add(_s181, _multiply(_absolute(_s182, _r113), _s125, _r113), _r113)
    _s184 = _add(_multiply(p_gravity, _s128, _r90), _s46, _r90)
    _s185 = _add(_s184, _add(_multiply(_absolute(_s166, _r6), _s129, _r6), _multiply(_absolute(_s169, _r107), _s160, _r107), _r107), _r107)
    _s186 = _k75 + p_restitution
    _s187 = _k76 * p_ball_radius
    _s188 = _add(normal_rounding, _s60, _r6)
    _s189 = _add(_add(_absolute(wx, _r34), _absolute(wy, _r109), _r109), _absolute(wz, _r34), _r34)
    _s190 = _multiply(_multiply(_s187, _s188, _r109), _s189, _r109)
    _s191 = _multiply(p_ball_radius, _s189, _r114)
    _s192 = _add(_s191, _s39, _r115)
    _s193 = _add(_k24, _multiply(_k77, _s192, _r116), _r116)
    _s194 = _multiply(p_gravity, _s57, _r46)
    _s195 = _k36 * _s186
    _s196 = _multiply(_add(bend_s, bend_e, _r117), _s130, _r117)
    _s197 = _multiply(_s52, _s52, _r32)
    _s198 = _add(_multiply(_s51, _s58, _r47), _multiply(_k22, _s197, _r7), _r7)
    _s199 = _add(_add(_add(_s194, _multiply(_s52, _add(_multiply(spin_bound, _s187, _r47), _multiply(_s195, _s48, _r118), _r118), _r118), _r118), _multiply(_s196, _s192, _r47), _r47), _multiply(_s198, _add(_multiply(_s187, _s189, _r118), _multiply(_s195, _s39, _r119), _r119), _r119), _r119)
    _s200 = _add(spin_bound, _multiply(_s40, _s189, _r38), _r38)
    _s201 = _multiply(_k69, _add(_add(_multiply(p_ball_radius, _s200, _r47), _multiply(_s52, _add(_s191, _multiply(_k78, _s39, _r118), _r118), _r118), _r118), _multiply(_k22, _add(_s41, _s48, _r37), _r37), _r37), _r37)
    _s202 = _add(_add(_s199, _multiply(_multiply(_s197, _s186, _r118), _s49, _r118), _r118), _s201, _r118)
    _s203 = _add(_add(_multiply(p_restitution, _s185, _r119), _multiply(_s186, _add(_multiply(normal_rounding, _add(_s39, _s44, _r1), _r1), _multiply(_multiply(_k22, _s60, _r35), _s44, _r35), _r35), _r35), _r35), _add(_add(_s190, _s193, _r119), _s202, _r119), _r119)
    _s204 = _add(_multiply(place_n, _absolute(_subtract(_subtract(_multiply(_s165, _s131, _r0), _multiply(_s167, _s132, _r105), _r105), _multiply(_s170, _s161, _r108), _r108), _r108), _r108), _multiply(_absolute(_s171, _r110), _s133, _r110), _r110)
    _s205 = _add(_add(_add(_add(_s204, _multiply(_absolute(_s172, _r111), _s134, _r111), _r111), _multiply(_absolute(_s173, _r112), _s135, _r112), _r112), _multiply(_absolute(_s174, _r27), _s136, _r27), _r27), _multiply(_absolute(_s175, _r21), _s138, _r21), _r21)
    _s206 = _k27 * _add(_s203, _s205, _r21)
    _s207 = _multiply(_k27, _add(_s183, _s206, _r21), _r21)
    _s208 = _multiply(_s187, _s142, _r119)
    _s209 = _select(_s67, product_61, _k29, _r27)
    _s210 = _multiply(_k79, _s21, _r18)
    _s211 = _k65 / p_ball_radius
    _s212 = _add(_add(_multiply(wx, _s12, _r9), _multiply(wy, _s13, _r10), _r10), _multiply(wz, _s19, _r9), _r9)
    _s213 = _add(_add(_multiply(nx, wx, _r10), _multiply(ny, wy, _r112), _r112), _multiply(nz, wz, _r10), _r10)
    _s214 = _multiply(_s19, _s213, _r112)
    _s215 = _multiply(bend_e, _subtract(_multiply(nz, _s212, _r111), _s214, _r111), _r111)
    _s216 = _multiply(nz, bend_e, _r110)
    _s217 = _negative(_multiply(_s216, _s16, _r108), _r108)
    _s218 = _add(_multiply(_s187, _s215, _r105), _multiply(_k79, _s217, _r0), _r0)
    _s219 = _subtract(_add(_multiply(_s65, _s210, _r33), _add(_multiply(_s187, _negative(_multiply(_s211, _s144, _r105), _r105), _r105), _multiply(_k79, _s14, _r35), _r35), _r35), _multiply(_s218, _s141, _r33), _r33)
    _s220 = _multiply(bend_s, normal_velocity, _r35)
    _s221 = _multiply(_k79, _s220, _r105)
    _s222 = _subtract(_s219, _multiply(_s66, _s221, _r1), _r1)
    _s223 = _subtract(_subtract(_add(_multiply(_s69, _s210, _r30), _multiply(_k79, _s70, _r33), _r33), _multiply(_s218, _s143, _r30), _r30), _multiply(_s71, _s221, _r33), _r33)
    _s224 = _subtract(_subtract(_add(_multiply(_s73, _s210, _r31), _add(_multiply(_s187, _multiply(_s211, _s17, _r30), _r30), _multiply(_k79, _s74, _r47), _r47), _r47), _multiply(_s218, _s145, _r31), _r31), _multiply(_s75, _s221, _r47), _r47)
    _s225 = _subtract(_add(_multiply(_s77, _s210, _r28), _add(_multiply(_s187, _subtract(_multiply(_s78, _s212, _r31), _multiply(_s29, _s213, _r30), _r30), _r30), _multiply(_k79, _s79, _r55), _r55), _r55), _multiply(_s218, _s147, _r28), _r28)
    _s226 = _subtract(_s225, _multiply(_s80, _s221, _r55), _r55)
    _s227 = _subtract(_add(_multiply(_s82, _s210, _r25), _add(_multiply(_s187, _subtract(_multiply(_s84, _s212, _r28), _multiply(_s15, _s213, _r30), _r30), _r30), _multiply(_k79, _s85, _r61), _r61), _r61), _multiply(_s218, _s149, _r25), _r25)
    _s228 = _subtract(_s227, _multiply(_s86, _s221, _r61), _r61)
    _s229 = _add(_add(_add(_add(_multiply(_s208, _s209, _r25), _multiply(_s222, _s68, _r30), _r30), _multiply(_s223, _s72, _r25), _r25), _multiply(_s224, _s76, _r30), _r30), _multiply(_s226, _s81, _r25), _r25) + _multiply(_s228, _s87, _r30)
    _s230 = _select(_s67, product_62, _k29, _r30)
    _s231 = _add(_add(_add(_add(_multiply(_s208, _s230, _r25), _multiply(_s222, _s90, _r28), _r28), _multiply(_s223, _s91, _r25), _r25), _multiply(_s224, _s92, _r28), _r28), _multiply(_s226, _s93, _r25), _r25) + _multiply(_s228, _s94, _r28)
    _s232 = _select(_s67, product_63, _k29, _r28)
    _s233 = _add(_add(_add(_add(_multiply(_s208, _s232, _r25), _multiply(_s222, _s97, _r31), _r31), _multiply(_s223, _s98, _r25), _r25), _multiply(_s224, _s99, _r31), _r31), _multiply(_s226, _s100, _r25), _r25) + _multiply(_s228, _s101, _r31)
    _s234 = _select(_s67, product_64, _k29, _r31)
    _s235 = _add(_add(_add(_add(_multiply(_s208, _s234, _r25), _multiply(_s222, _s104, _r114), _r114), _multiply(_s223, _s105, _r25), _r25), _multiply(_s224, _s106, _r114), _r114), _multiply(_s226, _s107, _r25), _r25) + _multiply(_s228, _s108, _r114)
    _s236 = _select(_s67, product_65, _k29, _r114)
    _s237 = _add(_add(_add(_add(_multiply(_s208, _s236, _r25), _multiply(_s222, _s111, _r120), _r120), _multiply(_s223, _s112, _r25), _r25), _multiply(_s224, _s113, _r120), _r120), _multiply(_s226, _s114, _r25), _r25) + _multiply(_s228, _s115, _r120)
    _s238 = _add(_add(_add(_add(_multiply(_absolute(_s229, _r120), _s89, _r120), _multiply(_absolute(_s231, _r25), _s96, _r25), _r25), _multiply(_absolute(_s233, _r120), _s103, _r120), _r120), _multiply(_absolute(_s235, _r25), _s110, _r25), _r25), _multiply(_absolute(_s237, _r120), _s117, _r120), _r120)
    _s239 = _select(_s67, product_66, _k72, _r25)
    _s240 = _add(_add(_add(_add(_multiply(_s208, _s239, _r121), _multiply(_s222, _s119, _r122), _r122), _multiply(_s223, _s120, _r121), _r121), _multiply(_s224, _s121, _r122), _r122), _multiply(_s226, _s122, _r121), _r121) + _multiply(_s228, _s123, _r122)
    _s241 = _add(_s238, _multiply(_absolute(_s240, _r122), _s125, _r122), _r122)
    _s242 = _multiply(_s159, _s129, _r120)
    _s243 = _add(_s242, _multiply(_absolute(_s215, _r111), _s160, _r111), _r111)
    _s244 = _add(_s184, _add(_multiply(_absolute(_s220, _r35), _s129, _r35), _multiply(_absolute(_s217, _r108), _s160, _r108), _r108), _r108)
    _s245 = _add(_add(_add(_multiply(_multiply(normal_rounding, _s186, _r35), _s44, _r35), _s190, _r35), _s193, _r35), _s202, _r35)
    _s246 = _add(_multiply(place_n, _absolute(_subtract(_subtract(_multiply(_s131, _s210, _r18), _multiply(_s218, _s161, _r0), _r0), _multiply(_s132, _s221, _r105), _r105), _r105), _r105), _multiply(turn_z, _absolute(_multiply(_s187, _s17, _r0), _r0), _r0), _r0)
    _s247 = _add(_multiply(_k74, turn_n, _r105), _select(_s67, recent_t, _k29, _r18), _r18)
    _s248 = _add(_add(_add(_s246, _multiply(turn_z, _absolute(_multiply(_s187, _s144, _r105), _r105), _r105), _r105), _multiply(_absolute(_s208, _r119), _s247, _r119), _r119), _multiply(_absolute(_s222, _r1), _s133, _r1), _r1)
    _s249 = _add(_add(_add(_add(_s248, _multiply(_absolute(_s223, _r33), _s134, _r33), _r33), _multiply(_absolute(_s224, _r47), _s135, _r47), _r47), _multiply(_absolute(_s226, _r55), _s136, _r55), _r55), _multiply(_absolute(_s228, _r61), _s138, _r61), _r61)
    _s250 = _k27 * _add(_add(_add(_multiply(_s187, _s243, _r55), _multiply(_k79, _s244, _r47), _r47), _s245, _r47), _s249, _r61)
    _s251 = _multiply(_k27, _add(_s241, _s250, _r61), _r61)
    _s252 = _negative(_multiply(_s187, _s70, _r43), _r43)
    _s253 = _multiply(bend_s, _s213, _r47)
    _s254 = _negative(_multiply(_s187, _s253, _r55), _r55)
    _s255 = _multiply(bend_e, _subtract(_multiply(nz, _s20, _r33), _multiply(normal_velocity, _s19, _r1), _r1), _r1)
    _s256 = _add(_multiply(wx, tangent_x, _r33), _multiply(wy, tangent_y, _r119), _r119)
    _s257 = _negative(_multiply(_s216, _s256, _r33), _r33)
    _s258 = _subtract(_multiply(_k79, _s255, _r105), _multiply(_s187, _s257, _r0), _r0)
    _s259 = _subtract(_subtract(_subtract(_multiply(_k79, _s17, _r15), _multiply(_s187, _negative(_multiply(_s211, _s74, _r105), _r105), _r105), _r105), _multiply(_s254, _s66, _r15), _r15), _multiply(_s258, _s141, _r105), _r105)
    _s260 = _subtract(_subtract(_multiply(_k79, _s142, _r99), _multiply(_s254, _s71, _r15), _r15), _multiply(_s258, _s143, _r99), _r99)
    _s261 = _subtract(_subtract(_subtract(_multiply(_k79, _s144, _r22), _multiply(_s187, _multiply(_s211, _s14, _r15), _r15), _r15), _multiply(_s254, _s75, _r22), _r22), _multiply(_s258, _s145, _r15), _r15)
    _s262 = _subtract(_subtract(_subtract(_multiply(_k79, _s146, _r101), _multiply(_s187, _negative(_multiply(_s78, _s256, _r54), _r54), _r54), _r54), _multiply(_s254, _s80, _r101), _r101), _multiply(_s258, _s147, _r54), _r54)
    _s263 = _subtract(_subtract(_subtract(_multiply(_k79, _s148, _r58), _multiply(_s187, _subtract(_multiply(_s18, _s213, _r10), _multiply(_s84, _s256, _r59), _r59), _r59), _r59), _multiply(_s254, _s86, _r58), _r58), _multiply(_s258, _s149, _r59), _r59)
    _s264 = _add(_add(_add(_add(_multiply(_s252, _s209, _r58), _multiply(_s259, _s68, _r10), _r10), _multiply(_s260, _s72, _r58), _r58), _multiply(_s261, _s76, _r10), _r10), _multiply(_s262, _s81, _r58), _r58) + _multiply(_s263, _s87, _r10)
    _s265 = _add(_add(_add(_add(_multiply(_s252, _s230, _r10), _multiply(_s259, _s90, _r58), _r58), _multiply(_s260, _s91, _r10), _r10), _multiply(_s261, _s92, _r58), _r58), _multiply(_s262, _s93, _r10), _r10) + _multiply(_s263, _s94, _r58)
    _s266 = _add(_add(_add(_add(_multiply(_s252, _s232, _r58), _multiply(_s259, _s97, _r10), _r10), _multiply(_s260, _s98, _r58), _r58), _multiply(_s261, _s99, _r10), _r10), _multiply(_s262, _s100, _r58), _r58) + _multiply(_s263, _s101, _r10)
    _s267 = _add(_add(_add(_add(_multiply(_s252, _s234, _r10), _multiply(_s259, _s104, _r58), _r58), _multiply(_s260, _s105, _r10), _r10), _multiply(_s261, _s106, _r58), _r58), _multiply(_s262, _s107, _r10), _r10) + _multiply(_s263, _s108, _r58)
    _s268 = _add(_add(_add(_add(_multiply(_s252, _s236, _r58), _multiply(_s259, _s111, _r10), _r10), _multiply(_s260, _s112, _r58), _r58), _multiply(_s261, _s113, _r10), _r10), _multiply(_s262, _s114, _r58), _r58) + _multiply(_s263, _s115, _r10)
    _s269 = _add(_add(_add(_add(_multiply(_absolute(_s264, _r10), _s89, _r10), _multiply(_absolute(_s265, _r58), _s96, _r58), _r58), _multiply(_absolute(_s266, _r10), _s103, _r10), _r10), _multiply(_absolute(_s267, _r58), _s110, _r58), _r58), _multiply(_absolute(_s268, _r10), _s117, _r10), _r10)
    _s270 = _add(_add(_add(_add(_multiply(_s252, _s239, _r58), _multiply(_s259, _s119, _r101), _r101), _multiply(_s260, _s120, _r58), _r58), _multiply(_s261, _s121, _r101), _r101), _multiply(_s262, _s122, _r58), _r58) + _multiply(_s263, _s123, _r101)
    _s271 = _add(_s269, _multiply(_absolute(_s270, _r101), _s125, _r101), _r101)
    _s272 = _absolute(_s253, _r47)
    _s273 = _add(_multiply(_s272, _s129, _r10), _multiply(_absolute(_s257, _r33), _s160, _r33), _r33)
    _s274 = _add(_s184, _add(_s242, _multiply(_absolute(_s255, _r1), _s160, _r1), _r1), _r1)
    _s275 = _add(_multiply(place_n, _absolute(_negative(_add(_multiply(_s254, _s132, _r55), _multiply(_s258, _s161, _r0), _r0), _r0), _r0), _r0), _multiply(turn_z, _absolute(_negative(_multiply(_s187, _s14, _r12), _r12), _r12), _r12), _r12)
    _s276 = _add(_add(_s275, _multiply(turn_z, _absolute(_negative(_multiply(_s187, _s74, _r24), _r24), _r24), _r24), _r24), _multiply(_absolute(_s252, _r43), _s247, _r43), _r43)
    _s277 = _add(_add(_add(_add(_s276, _multiply(_absolute(_s259, _r105), _s133, _r105), _r105), _multiply(_absolute(_s260, _r99), _s134, _r99), _r99), _multiply(_absolute(_s261, _r15), _s135, _r15), _r15), _multiply(_absolute(_s262, _r54), _s136, _r54), _r54)
    _s278 = _k27 * _add(_add(_add(_multiply(_s187, _s273, _r15), _multiply(_k79, _s274, _r99), _r99), _s245, _r99), _add(_s277, _multiply(_absolute(_s263, _r59), _s138, _r59), _r59), _r59)
    _s279 = _multiply(_k27, _add(_s271, _s278, _r59), _r59)
    _s280 = _negative(_multiply(bend_s, _s212, _r99), _r99)
    _s281 = _multiply(_s168, _s256, _r54)
    _s282 = _negative(_add(_multiply(_s280, _s71, _r51), _multiply(_s281, _s143, _r100), _r100), _r100)
    _s283 = _subtract(_subtract(_negative(_multiply(_s211, _s27, _r51), _r51), _multiply(_s280, _s66, _r45), _r45), _multiply(_s281, _s141, _r39), _r39)
    _s284 = _subtract(_subtract(_multiply(_s211, _s31, _r45), _multiply(_s280, _s75, _r52), _r52), _multiply(_s281, _s145, _r96), _r96)
    _s285 = _subtract(_subtract(_multiply(_s29, _s256, _r26), _multiply(_s280, _s80, _r57), _r57), _multiply(_s281, _s147, _r102), _r102)
    _s286 = _subtract(_subtract(_subtract(_multiply(_s15, _s256, _r11), _multiply(_s18, _s212, _r13), _r13), _multiply(_s280, _s86, _r62), _r62), _multiply(_s281, _s149, _r20), _r20)
    _s287 = _add(_add(_add(_add(_multiply(_s282, _s72, _r44), _multiply(_s10, _s209, _r27), _r27), _multiply(_s283, _s68, _r49), _r49), _multiply(_s284, _s76, _r53), _r53), _multiply(_s285, _s81, _r56), _r56) + _multiply(_s286, _s87, _r60)
    _s288 = _add(_add(_add(_add(_multiply(_s282, _s91, _r64), _multiply(_s10, _s230, _r30), _r30), _multiply(_s283, _s90, _r63), _r63), _multiply(_s284, _s92, _r65), _r65), _multiply(_s285, _s93, _r66), _r66) + _multiply(_s286, _s94, _r67)
    _s289 = _add(_add(_add(_add(_multiply(_s282, _s98, _r69), _multiply(_s10, _s232, _r28), _r28), _multiply(_s283, _s97, _r68), _r68), _multiply(_s284, _s99, _r70), _r70), _multiply(_s285, _s100, _r71), _r71) + _multiply(_s286, _s101, _r72)
    _s290 = _add(_add(_add(_add(_multiply(_s282, _s105, _r74), _multiply(_s10, _s234, _r31), _r31), _multiply(_s283, _s104, _r73), _r73), _multiply(_s284, _s106, _r75), _r75), _multiply(_s285, _s107, _r76), _r76) + _multiply(_s286, _s108, _r77)
    _s291 = _add(_add(_add(_add(_multiply(_s282, _s112, _r79), _multiply(_s10, _s236, _r114), _r114), _multiply(_s283, _s111, _r78), _r78), _multiply(_s284, _s113, _r80), _r80), _multiply(_s285, _s114, _r81), _r81) + _multiply(_s286, _s115, _r82)
    _s292 = _add(_add(_add(_add(_multiply(_absolute(_s287, _r82), _s89, _r82), _multiply(_absolute(_s288, _r81), _s96, _r81), _r81), _multiply(_absolute(_s289, _r82), _s103, _r82), _r82), _multiply(_absolute(_s290, _r81), _s110, _r81), _r81), _multiply(_absolute(_s291, _r82), _s117, _r82), _r82)
    _s293 = _add(_add(_add(_add(_multiply(_s282, _s120, _r85), _multiply(_s10, _s239, _r25), _r25), _multiply(_s283, _s119, _r84), _r84), _multiply(_s284, _s121, _r86), _r86), _multiply(_s285, _s122, _r87), _r87) + _multiply(_s286, _s123, _r88)
    _s294 = _add(_s292, _multiply(_absolute(_s293, _r88), _s125, _r88), _r88)
    _s295 = _add(_multiply(_absolute(_s280, _r82), _s129, _r82), _multiply(_absolute(_s281, _r92), _s160, _r92), _r92)
    _s296 = _k75 * _s211
    _s297 = _add(_multiply(_s211, _s39, _r82), _s189, _r82)
    _s298 = _add(_add(_add(_multiply(_s211, _add(_s194, _s201, _r37), _r37), _multiply(_s52, _add(_multiply(_k22, spin_bound, _r46), _multiply(_s296, _s48, _r3), _r3), _r3), _r3), _multiply(_s197, _add(spin_bound, _s189, _r37), _r37), _r37), _multiply(_s196, _s297, _r117), _r117)
    _s299 = _add(_add(_s298, _multiply(_s198, _add(_multiply(_s296, _s39, _r37), _multiply(_k22, _s189, _r3), _r3), _r3), _r3), _multiply(_k69, _add(_multiply(_s52, _s189, _r42), _s200, _r42), _r42), _r42)
    _s300 = _add(_add(_add(_add(_multiply(_s211, _s193, _r3), _multiply(_k22, _multiply(_s188, _s189, _r38), _r38), _r38), _multiply(_k79, _multiply(_multiply(normal_rounding, _s211, _r3), _s39, _r3), _r3), _r3), _s295, _r3), _s299, _r3)
    _s301 = _add(_multiply(place_n, _absolute(_negative(_add(_multiply(_s280, _s132, _r99), _multiply(_s281, _s161, _r54), _r54), _r54), _r54), _r54), _multiply(turn_z, _absolute(_s31, _r29), _r29), _r29)
    _s302 = _add(_add(_add(_add(_s301, _multiply(turn_z, _absolute(_s27, _r23), _r23), _r23), _multiply(_absolute(_s282, _r100), _s134, _r100), _r100), _multiply(_absolute(_s10, _r2), _s247, _r2), _r2), _multiply(_absolute(_s283, _r39), _s133, _r39), _r39)
    _s303 = _add(_s300, _add(_add(_add(_s302, _multiply(_absolute(_s284, _r96), _s135, _r96), _r96), _multiply(_absolute(_s285, _r102), _s136, _r102), _r102), _multiply(_absolute(_s286, _r20), _s138, _r20), _r20), _r20)
    _s304 = _k27 * _s303
    _s305 = _multiply(_k27, _add(_s294, _s304, _r20), _r20)
    _s306 = _add(_multiply(_s211, _add(_s193, _s245, _r35), _r35), _multiply(_k22, _multiply(_s188, _add(_multiply(_s296, _add(_s158, _s127, _r19), _r19), _s189, _r19), _r19), _r19), _r19)
    _s307 = _select(_s185 < _s244, _s244, _s185, _r35)
    _s308 = _select(_s295 < _s273, _s273, _s295, _r6)
    _s309 = _multiply(_k27, _add(_add(_s306, _add(_multiply(_s211, _select(_s307 < _s274, _s274, _s307, _r34), _r34), _select(_s308 < _s243, _s243, _s308, _r35), _r35), _r35), _s299, _r35), _r35)
    _s310 = _select(_s62 < _s140, _s140, _s62, _r42)
    _s311 = _result(_s63, _multiply(_k27, _add(_multiply(_k80, _add(_add(_s164, _s140, _r19), _s62, _r19), _r19), _multiply(_k81, _select(_s310 < _s164, _s164, _s310, _r6), _r6), _r6), _r6), _k30, _r0)
    _s312 = _multiply(_s159, _s140, _r6)
    _s313 = _add(_multiply(_s187, _s256, _r119), _multiply(_k79, _s20, _r16), _r16)
    _s314 = _negative(_multiply(p_restitution, normal_velocity, _r119), _r119)
    _s315 = _add(_s312, _multiply(_absolute(_multiply(bend_e, _subtract(_multiply(nz, _s313, _r19), _multiply(_s314, _s19, _r42), _r42), _r42), _r42), _s164, _r42), _r42)
    _s316 = _multiply(_k69, _add(_multiply(bend_s, _s140, _r19), _multiply(bend_e, _s164, _r34), _r34), _r34)
    _s317 = _multiply(_s192, _s316, _r115)
    _s318 = _add(_add(_s315, _s317, _r42), _s279, _r42)
    _s319 = _subtract(_multiply(_k79, _s16, _r14), _multiply(_s187, _s212, _r9), _r9)
    _s320 = _add(_add(_multiply(_absolute(_multiply(bend_s, _s314, _r119), _r119), _s140, _r119), _multiply(_absolute(_negative(_multiply(_s216, _s319, _r14), _r14), _r14), _s164, _r14), _r14), _s317, _r14)
    _s321 = _add(_s320, _s251, _r14)
    _s322 = _add(_add(_multiply(_absolute(_negative(_multiply(bend_s, _s313, _r119), _r119), _r119), _s140, _r119), _multiply(_absolute(_multiply(_s168, _s319, _r106), _r106), _s164, _r106), _r106), _s317, _r106)
    _s323 = _add(_s322, _s207, _r106)
    _s324 = _select(_s323 < _s321, _s321, _s323, _r115)
    _s325 = _result(_s63, _multiply(_k27, _add(_multiply(_k80, _add(_add(_s318, _s321, _r119), _s323, _r119), _r119), _multiply(_k81, _select(_s324 < _s318, _s318, _s324, _r19), _r19), _r19), _r19), _k30, _r0)
    _s326 = _negative(_multiply(_s211, _s319, _r9), _r9)
    _s327 = _multiply(_s211, _s313, _r16)
    _s328 = _multiply(_s297, _s316, _r34)
    _s329 = _add(_add(_multiply(_absolute(_negative(_multiply(bend_s, _s326, _r82), _r82), _r82), _s140, _r82), _multiply(_absolute(_multiply(_multiply(bend_e, _s327, _r19), _s19, _r19), _r19), _s164, _r19), _r19), _s328, _r19)
    _s330 = _add(_s329, _s305, _r19)
    _s331 = _add(_add(_divide(_s251, p_ball_radius, _r82), _s312, _r82), _multiply(_absolute(_multiply(bend_e, _subtract(_multiply(nz, _s326, _r9), _s214, _r9), _r9), _r9), _s164, _r9), _r9)
    _s332 = _add(_add(_s331, _s328, _r9), _s309, _r9)
    _s333 = _add(_add(_add(_divide(_s279, p_ball_radius, _r82), _multiply(_s272, _s140, _r47), _r47), _multiply(_absolute(_negative(_multiply(_s216, _s327, _r16), _r16), _r16), _s164, _r16), _r16), _s328, _r16)
    _s334 = _add(_s333, _s309, _r16)
    _s335 = _select(_s330 < _s334, _s334, _s330, _r34)
    _s336 = _result(_s63, _multiply(_k27, _add(_multiply(_k80, _add(_add(_s330, _s332, _r47), _s334, _r47), _r47), _multiply(_k81, _select(_s335 < _s332, _s332, _s335, _r110), _r110), _r110), _r110), _k30, _r0)
    _s337 = _multiply(_k82, _add(_add(_add(_add(_add(_s157, _s126, _r103), _multiply(_k83, _s183, _r113), _r113), _multiply(_k83, _s241, _r122), _r122), _multiply(_k83, _s271, _r101), _r101), _multiply(_k84, _s294, _r88), _r88), _r88)
    _s338 = _add(_add(_add(_add(_add(_s163, _s139, _r101), _multiply(_k83, _s206, _r122), _r122), _multiply(_k83, _s250, _r101), _r101), _multiply(_k83, _s278, _r122), _r122), _multiply(_k84, _s304, _r101), _r101) <= _s337
    return _result(_s63, _s62, _k30, _r0), _result(_s63, _s140, _k30, _r0), _result(_s63, _s164, _k30, _r0), _result(_s63, _s207, _k30, _r0), _result(_s63, _s251, _k30, _r0), _result(_s63, _s279, _k30, _r0), _result(_s63, _s305, _k30, _r0), _result(_s63, _s309, _k30, _r0), _s311, _s325, _s336, nx, ny, nz, tangent_x, tangent_y, bend_s, bend_e, _multiply(_k31, _add(t, clock, _r35), _r35) + _select(_s63, _multiply(_k27, _s45, _r41), _k30, _r20), _s89, _s96, _s103, _s110, _s117, _s125, _s139, _s163, _s206, _s250, _s278, _s304, _s88, _s95, _s102, _s109, _s116, _s124, _s150, _s151, _s152, _s153, _s154, _s156, _s176, _s177, _s178, _s179, _s180, _s182, _s229, _s231, _s233, _s235, _s237, _s240, _s264, _s265, _s266, _s267, _s268, _s270, _s287, _s288, _s289, _s290, _s291, _s293, _result(_s338, _k72, _k29, _r0)


def impact(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, p_ball_radius: Any, p_restitution: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Velocity and spin after a contact, frame-free.

    Eqs. 11-17, the frame eliminated. 63 operations: 10 additions, 12 subtractions, 40 multiplications, 1 division.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6 = _room[:7]
    _s0 = 0.4 * p_ball_radius
    _s1 = _add(_add(_multiply(nx, vx, _r0), _multiply(ny, vy, _r1), _r1), _multiply(nz, vz, _r0), _r0)
    _s2 = _add(_multiply(_s0, _subtract(_multiply(nz, wy, _r1), _multiply(ny, wz, _r2), _r2), _r2), _multiply(_k97, _subtract(vx, _multiply(nx, _s1, _r1), _r1), _r1), _r1)
    _s3 = _add(_multiply(_s0, _subtract(_multiply(nx, wz, _r2), _multiply(nz, wx, _r3), _r3), _r3), _multiply(_k97, _subtract(vy, _multiply(ny, _s1, _r2), _r2), _r2), _r2)
    _s4 = _add(_multiply(_s0, _subtract(_multiply(ny, wx, _r3), _multiply(nx, wy, _r4), _r4), _r4), _multiply(_k97, _subtract(vz, _multiply(nz, _s1, _r3), _r3), _r3), _r3)
    _s5 = _add(_add(_multiply(nx, wx, _r4), _multiply(ny, wy, _r5), _r5), _multiply(nz, wz, _r4), _r4)
    _s6 = 1.0 / p_ball_radius
    return _s2 - _multiply(_multiply(p_restitution, nx, _r5), _s1, _r5), _s3 - _multiply(_multiply(p_restitution, ny, _r5), _s1, _r5), _s4 - _multiply(_multiply(p_restitution, nz, _r5), _s1, _r5), _multiply(nx, _s5, _r5) + _multiply(_s6, _subtract(_multiply(ny, _s4, _r0), _multiply(nz, _s3, _r6), _r6), _r6), _multiply(ny, _s5, _r6) + _multiply(_s6, _subtract(_multiply(nz, _s2, _r5), _multiply(nx, _s4, _r3), _r3), _r3), _multiply(nz, _s5, _r4) + _multiply(_s6, _subtract(_multiply(nx, _s3, _r2), _multiply(ny, _s2, _r1), _r1), _r1)


def carry_impact(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, clock: Any, left_nx: Any, left_ny: Any, left_nz: Any, place_n: Any, place_s: Any, place_e: Any, pace_n: Any, pace_s: Any, pace_e: Any, turn_n: Any, turn_z: Any, position_bound: Any, velocity_bound: Any, spin_bound: Any, tangent_x: Any, tangent_y: Any, bend_s: Any, bend_e: Any, left_ex: Any, left_ey: Any, left_bend_s: Any, left_bend_e: Any, sharpest_bend: Any, root_offset: Any, root_level: Any, normal_rounding: Any, normal_velocity: Any, back: Any, p_ball_radius: Any, p_restitution: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Bounds on errors after a contact, from those at the departure before it.

    derivative of the frame-free Eq. 17, with roundings. 959 operations: 255 additions, 68 subtractions, 457 multiplications, 7 divisions, 40 negations, 93 absolute values, 14 comparisons, 25 selections.
    """
    t, x, y, z, vx, vy, vz, wx, wy, wz, nx, ny, nz, clock, left_nx, left_ny, left_nz, place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, tangent_x, tangent_y, bend_s, bend_e, left_ex, left_ey, left_bend_s, left_bend_e, sharpest_bend, root_offset, root_level, normal_rounding, normal_velocity, back, p_ball_radius, p_restitution, p_gravity, = [_single(value) for value in (t, x, y, z, vx, vy, vz, wx, wy, wz, nx, ny, nz, clock, left_nx, left_ny, left_nz, place_n, place_s, place_e, pace_n, pace_s, pace_e, turn_n, turn_z, position_bound, velocity_bound, spin_bound, tangent_x, tangent_y, bend_s, bend_e, left_ex, left_ey, left_bend_s, left_bend_e, sharpest_bend, root_offset, root_level, normal_rounding, normal_velocity, back, p_ball_radius, p_restitution, p_gravity,)]
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18, _r19, _r20, _r21, _r22, _r23, _r24, _r25, _r26, _r27, _r28, _r29, _r30, _r31, _r32, _r33, _r34, _r35, _r36, _r37, _r38, _r39, _r40, _r41, _r42, _r43, _r44, _r45, _r46, _r47, _r48, _r49, _r50, _r51, _r52, _r53, _r54, _r55, _r56, _r57, _r58, _r59, _r60, _r61, _r62, _r63, _r64, _r65, _r66, _r67, _r68, _r69, _r70, _r71, _r72, _r73, _r74, _r75, _r76, _r77, _r78 = _halves(_room[:79])
    _s0 = _negative(_multiply(p_gravity, nz, _r0), _r0)
    _s1 = _absolute(vx, _r1)
    _s2 = _multiply(_k22, t, _r2)
    _s3 = _add(_k24, _multiply(_k25, _add(_multiply(_s2, _s1, _r3), _absolute(x, _r4), _r4), _r4), _r4)
    _s4 = _absolute(vy, _r3)
    _s5 = _add(_k24, _multiply(_k25, _add(_multiply(_s2, _s4, _r5), _absolute(y, _r6), _r6), _r6), _r6)
    _s6 = _k23 * p_gravity
    _s7 = _add(_add(_multiply(_s6, _multiply(t, t, _r5), _r5), _multiply(_s2, _absolute(_add(vz, _multiply(_s6, t, _r7), _r7), _r7), _r7), _r7), _absolute(z, _r5), _r5)
    _s8 = _add(_k24, _multiply(_k25, _s7, _r5), _r5)
    _s9 = _add(_add(_add(position_bound, _multiply(t, velocity_bound, _r7), _r7), _add(_add(_s3, _s5, _r2), _s8, _r2), _r2), _select(root_offset < root_level, root_level, root_offset, _r7), _r7)
    _s10 = _add(_add(_multiply(nx, left_nx, _r2), _multiply(ny, left_ny, _r8), _r8), _multiply(nz, left_nz, _r2), _r2)
    _s11 = _subtract(_s10, back, _r8)
    _s12 = _multiply(nz, tangent_y, _r9)
    _s13 = _negative(_multiply(nz, tangent_x, _r10), _r10)
    _s14 = _add(_multiply(left_ex, _s12, _r11), _multiply(left_ey, _s13, _r12), _r12)
    _s15 = _multiply(left_bend_s, _s14, _r11)
    _s16 = _add(_multiply(vx, tangent_x, _r13), _multiply(vy, tangent_y, _r14), _r14)
    _s17 = _add(_multiply(tangent_x, left_ex, _r13), _multiply(tangent_y, left_ey, _r15), _r15)
    _s18 = _multiply(left_bend_s, _s17, _r13)
    _s19 = _subtract(_multiply(ny, tangent_x, _r16), _multiply(nx, tangent_y, _r17), _r17)
    _s20 = _add(_add(_multiply(vx, _s12, _r16), _multiply(vy, _s13, _r18), _r18), _multiply(vz, _s19, _r16), _r16)
    _s21 = _negative(_multiply(p_gravity, _s19, _r18), _r18)
    _s22 = _subtract(_s20, _multiply(t, _s21, _r19), _r19)
    _s23 = _subtract(_multiply(_s15, _s16, _r20), _multiply(_s18, _s22, _r21), _r21)
    _s24 = _multiply(left_nz, left_ey, _r20)
    _s25 = _negative(_multiply(left_nz, left_ex, _r22), _r22)
    _s26 = _subtract(_multiply(left_ny, left_ex, _r23), _multiply(left_nx, left_ey, _r24), _r24)
    _s27 = _add(_add(_multiply(nx, _s24, _r23), _multiply(ny, _s25, _r25), _r25), _multiply(nz, _s26, _r23), _r23)
    _s28 = _add(_multiply(t, _s23, _r25), _s27, _r25)
    _s29 = _multiply(left_bend_e, _s19, _r26)
    _s30 = _multiply(_s29, _s16, _r27)
    _s31 = _add(_multiply(nx, left_ex, _r28), _multiply(ny, left_ey, _r29), _r29)
    _s32 = _add(_multiply(t, _s30, _r28), _s31, _r28)
    _s33 = _multiply(t, _s10, _r30)
    _s34 = _multiply(t, _s27, _r31)
    _s35 = _add(_add(_add(_add(_multiply(place_n, _absolute(_s11, _r32), _r32), _multiply(place_s, _absolute(_s28, _r33), _r33), _r33), _multiply(place_e, _absolute(_s32, _r32), _r32), _r32), _multiply(pace_n, _absolute(_s33, _r33), _r33), _r33), _multiply(pace_s, _absolute(_s34, _r32), _r32), _r32)
    _s36 = _multiply(t, _s31, _r33)
    _s37 = _multiply(p_gravity, t, _r34)
    _s38 = _absolute(vz, _r35)
    _s39 = _add(_add(_s1, _s4, _r36), _s38, _r36)
    _s40 = _add(_multiply(place_s, left_bend_s, _r37), _multiply(place_e, left_bend_e, _r38), _r38)
    _s41 = _multiply(_add(_s37, _s39, _r37), _s40, _r37)
    _s42 = _multiply(_k69, _add(_multiply(t, _s41, _r39), _s9, _r39), _r39)
    _s43 = _add(_add(_add(root_offset, _multiply(_multiply(_k70, _multiply(sharpest_bend, _s9, _r40), _r40), _s9, _r40), _r40), _add(_s35, _multiply(pace_e, _absolute(_s36, _r41), _r41), _r41), _r41), _s42, _r41)
    _s44 = _absolute(normal_velocity, _r40)
    _s45 = _divide(_multiply(_k26, _s43, _r41), _s44, _r41)
    _s46 = _add(_k24, _multiply(_k25, _add(_add(_add(_s37, _s1, _r34), _s4, _r34), _s38, _r34), _r34), _r34)
    _s47 = _add(velocity_bound, _s46, _r35)
    _s48 = _add(_multiply(p_gravity, _s45, _r3), _s47, _r3)
    _s49 = _add(_s48, _s39, _r1)
    _s50 = _add(_multiply(_s45, _s49, _r32), _s9, _r32)
    _s51 = _multiply(_k70, sharpest_bend, _r7)
    _s52 = _multiply(_s51, _s50, _r42)
    _s53 = _subtract(_multiply(_k28, _add(_add(_multiply(_absolute(_s0, _r43), _s45, _r43), _multiply(_s52, _s49, _r44), _r44), _s47, _r44), _r44), _s44, _r44)
    _s54 = _subtract(_multiply(_k71, _multiply(sharpest_bend, _s50, _r43), _r43), _k72, _r43)
    _s55 = _select(_s53 < _s54, _s54, _s53, _r45)
    _s56 = _add(_multiply(_s6, _multiply(_s45, _s45, _r46), _r46), _multiply(_s45, _s47, _r35), _r35)
    _s57 = _divide(_add(_multiply(_s52, _s50, _r46), _s56, _r46), _s44, _r46)
    _s58 = _add(_multiply(_s57, _s39, _r47), _s56, _r47)
    _s59 = _add(_add(root_level, _s58, _r35), _add(_add(_multiply(_absolute(nx, _r48), _s3, _r48), _multiply(_absolute(ny, _r49), _s5, _r49), _r49), _multiply(_absolute(nz, _r48), _s8, _r48), _r48), _r48)
    _s60 = _multiply(bend_s, _s59, _r35)
    _s61 = _subtract(_multiply(_k73, _add(_multiply(place_n, left_bend_s, _r49), _s60, _r49), _r49), _k72, _r49)
    _s62 = _multiply(_k27, _s59, _r48)
    _s63 = _select(_s55 < _s61, _s61, _s55, _r50) <= _k29
    _s64 = _absolute(_s20, _r50)
    _s65 = _divide(_add(root_offset, _s42, _r49), _s44, _r49)
    _s66 = _add(_multiply(_s64, _s65, _r45), _add(_add(_multiply(_absolute(_s13, _r43), _s5, _r43), _multiply(_absolute(_s12, _r44), _s3, _r44), _r44), _multiply(_absolute(_s19, _r43), _s8, _r43), _r43), _r43)
    _s67 = _add(_add(_s58, _multiply(_k69, _s50, _r32), _r32), _s42, _r32)
    _s68 = _divide(_k72, normal_velocity, _r39)
    _s69 = _negative(_multiply(_s68, _s11, _r8), _r8)
    _s70 = _add(_add(_multiply(left_nx, _s12, _r45), _multiply(left_ny, _s13, _r44), _r44), _multiply(left_nz, _s19, _r45), _r45)
    _s71 = _add(_multiply(_s69, _s20, _r44), _s70, _r44)
    _s72 = _negative(_multiply(_s68, _s28, _r25), _r25)
    _s73 = _subtract(normal_velocity, _multiply(t, _s0, _r51), _r51)
    _s74 = _multiply(left_bend_s, _s31, _r52)
    _s75 = _subtract(_multiply(_s18, _s73, _r53), _multiply(_s74, _s16, _r54), _r54)
    _s76 = _add(_add(_multiply(_s13, _s25, _r53), _multiply(_s12, _s24, _r55), _r55), _multiply(_s19, _s26, _r24), _r24)
    _s77 = _add(_multiply(_s72, _s20, _r55), _add(_multiply(t, _s75, _r53), _s76, _r53), _r53)
    _s78 = _negative(_multiply(_s68, _s32, _r28), _r28)
    _s79 = _multiply(nz, left_bend_e, _r55)
    _s80 = _negative(_multiply(_s79, _s16, _r56), _r56)
    _s81 = _add(_multiply(_s78, _s20, _r57), _add(_multiply(t, _s80, _r58), _s14, _r58), _r58)
    _s82 = _negative(_multiply(_s68, _s33, _r30), _r30)
    _s83 = _add(_multiply(_s82, _s20, _r57), _multiply(t, _s70, _r59), _r59)
    _s84 = _negative(_multiply(_s68, _s34, _r31), _r31)
    _s85 = _add(_multiply(_s84, _s20, _r57), _multiply(t, _s76, _r60), _r60)
    _s86 = _add(_add(_add(_add(_multiply(place_n, _absolute(_s71, _r57), _r57), _multiply(place_s, _absolute(_s77, _r61), _r61), _r61), _multiply(place_e, _absolute(_s81, _r57), _r57), _r57), _multiply(pace_n, _absolute(_s83, _r61), _r61), _r61), _multiply(pace_s, _absolute(_s85, _r57), _r57), _r57)
    _s87 = _negative(_multiply(_s68, _s36, _r39), _r39)
    _s88 = _add(_multiply(_s87, _s20, _r33), _multiply(t, _s14, _r61), _r61)
    _s89 = _multiply(_k27, _add(_add(_s66, _s67, _r33), _add(_s86, _multiply(pace_e, _absolute(_s88, _r62), _r62), _r62), _r62), _r62)
    _s90 = _absolute(_s16, _r33)
    _s91 = _absolute(_k37)
    _s92 = _add(_multiply(_s90, _s65, _r57), _add(_add(_multiply(_s91, _s8, _r5), _multiply(_absolute(tangent_x, _r63), _s3, _r63), _r63), _multiply(_absolute(tangent_y, _r5), _s5, _r5), _r5), _r5)
    _s93 = _add(_multiply(left_nx, tangent_x, _r57), _multiply(left_ny, tangent_y, _r63), _r63)
    _s94 = _add(_multiply(_s69, _s16, _r57), _s93, _r57)
    _s95 = _subtract(_multiply(_s74, _s22, _r6), _multiply(_s15, _s73, _r4), _r4)
    _s96 = _add(_multiply(tangent_x, _s24, _r20), _multiply(tangent_y, _s25, _r22), _r22)
    _s97 = _add(_multiply(_s72, _s16, _r20), _add(_multiply(t, _s95, _r6), _s96, _r6), _r6)
    _s98 = _subtract(_multiply(_s79, _s22, _r19), _multiply(_s29, _s73, _r51), _r51)
    _s99 = _add(_multiply(_s78, _s16, _r19), _add(_multiply(t, _s98, _r20), _s17, _r20), _r20)
    _s100 = _add(_multiply(_s82, _s16, _r19), _multiply(t, _s93, _r64), _r64)
    _s101 = _add(_multiply(_s84, _s16, _r19), _multiply(t, _s96, _r65), _r65)
    _s102 = _add(_add(_add(_add(_multiply(place_n, _absolute(_s94, _r19), _r19), _multiply(place_s, _absolute(_s97, _r66), _r66), _r66), _multiply(place_e, _absolute(_s99, _r19), _r19), _r19), _multiply(pace_n, _absolute(_s100, _r66), _r66), _r66), _multiply(pace_s, _absolute(_s101, _r19), _r19), _r19)
    _s103 = _add(_multiply(_s87, _s16, _r66), _multiply(t, _s17, _r67), _r67)
    _s104 = _multiply(_k27, _add(_add(_s92, _s67, _r66), _add(_s102, _multiply(pace_e, _absolute(_s103, _r68), _r68), _r68), _r68), _r68)
    _s105 = _add(_multiply(p_gravity, _s65, _r49), _s46, _r49)
    _s106 = _negative(_multiply(bend_s, _s20, _r34), _r34)
    _s107 = _multiply(bend_e, _s19, _r66)
    _s108 = _multiply(_s107, _s16, _r19)
    _s109 = _add(_s105, _add(_multiply(_absolute(_s106, _r69), _s66, _r69), _multiply(_absolute(_s108, _r70), _s92, _r70), _r70), _r70)
    _s110 = _k75 + p_restitution
    _s111 = _k76 * p_ball_radius
    _s112 = _add(normal_rounding, _s60, _r69)
    _s113 = _add(_add(_absolute(wx, _r71), _absolute(wy, _r72), _r72), _absolute(wz, _r71), _r71)
    _s114 = _multiply(_multiply(_s111, _s112, _r72), _s113, _r72)
    _s115 = _multiply(p_ball_radius, _s113, _r73)
    _s116 = _add(_s115, _s39, _r74)
    _s117 = _add(_k24, _multiply(_k77, _s116, _r75), _r75)
    _s118 = _multiply(p_gravity, _s57, _r46)
    _s119 = _k36 * _s110
    _s120 = _multiply(_add(bend_s, bend_e, _r76), _s67, _r76)
    _s121 = _multiply(_s52, _s52, _r32)
    _s122 = _add(_multiply(_s51, _s58, _r47), _multiply(_k22, _s121, _r7), _r7)
    _s123 = _add(_add(_add(_s118, _multiply(_s52, _add(_multiply(spin_bound, _s111, _r47), _multiply(_s119, _s48, _r77), _r77), _r77), _r77), _multiply(_s120, _s116, _r47), _r47), _multiply(_s122, _add(_multiply(_s111, _s113, _r77), _multiply(_s119, _s39, _r78), _r78), _r78), _r78)
    _s124 = _add(spin_bound, _multiply(_s40, _s113, _r38), _r38)
    _s125 = _multiply(_k69, _add(_add(_multiply(p_ball_radius, _s124, _r47), _multiply(_s52, _add(_s115, _multiply(_k78, _s39, _r77), _r77), _r77), _r77), _multiply(_k22, _add(_s41, _s48, _r37), _r37), _r37), _r37)
    _s126 = _add(_add(_s123, _multiply(_multiply(_s121, _s110, _r77), _s49, _r77), _r77), _s125, _r77)
    _s127 = _add(_add(_multiply(p_restitution, _s109, _r78), _multiply(_s110, _add(_multiply(normal_rounding, _add(_s39, _s44, _r1), _r1), _multiply(_multiply(_k22, _s60, _r35), _s44, _r35), _r35), _r35), _r35), _add(_add(_s114, _s117, _r78), _s126, _r78), _r78)
    _s128 = _negative(_multiply(p_restitution, _s0, _r0), _r0)
    _s129 = _negative(_multiply(p_restitution, _s106, _r34), _r34)
    _s130 = _negative(_multiply(p_restitution, _s108, _r19), _r19)
    _s131 = _absolute(_subtract(_subtract(_add(_multiply(_s128, _s72, _r35), _negative(_multiply(p_restitution, _s23, _r21), _r21), _r21), _multiply(_s129, _s77, _r35), _r35), _multiply(_s130, _s97, _r21), _r21), _r21)
    _s132 = _add(_multiply(place_n, _absolute(_subtract(_subtract(_multiply(_s128, _s69, _r35), _multiply(_s129, _s71, _r1), _r1), _multiply(_s130, _s94, _r35), _r35), _r35), _r35), _multiply(place_s, _s131, _r21), _r21)
    _s133 = _absolute(_subtract(_subtract(_add(_multiply(_s128, _s78, _r35), _negative(_multiply(p_restitution, _s30, _r27), _r27), _r27), _multiply(_s129, _s81, _r35), _r35), _multiply(_s130, _s99, _r27), _r27), _r27)
    _s134 = _absolute(_subtract(_subtract(_add(_multiply(_s128, _s82, _r35), _negative(_multiply(p_restitution, _s10, _r1), _r1), _r1), _multiply(_s129, _s83, _r35), _r35), _multiply(_s130, _s100, _r1), _r1), _r1)
    _s135 = _absolute(_subtract(_subtract(_add(_multiply(_s128, _s84, _r35), _negative(_multiply(p_restitution, _s27, _r47), _r47), _r47), _multiply(_s129, _s85, _r35), _r35), _multiply(_s130, _s101, _r47), _r47), _r47)
    _s136 = _absolute(_subtract(_subtract(_add(_multiply(_s128, _s87, _r0), _negative(_multiply(p_restitution, _s31, _r35), _r35), _r35), _multiply(_s129, _s88, _r34), _r34), _multiply(_s130, _s103, _r19), _r19), _r19)
    _s137 = _add(_s127, _add(_add(_add(_add(_s132, _multiply(place_e, _s133, _r27), _r27), _multiply(pace_n, _s134, _r1), _r1), _multiply(pace_s, _s135, _r47), _r47), _multiply(pace_e, _s136, _r19), _r19), _r19)
    _s138 = _multiply(_k27, _s137, _r19)
    _s139 = _multiply(_s91, _s66, _r78)
    _s140 = _add(_add(_multiply(wx, _s12, _r9), _multiply(wy, _s13, _r10), _r10), _multiply(wz, _s19, _r9), _r9)
    _s141 = _add(_add(_multiply(nx, wx, _r10), _multiply(ny, wy, _r47), _r47), _multiply(nz, wz, _r10), _r10)
    _s142 = _multiply(_s19, _s141, _r47)
    _s143 = _multiply(bend_e, _subtract(_multiply(nz, _s140, _r1), _s142, _r1), _r1)
    _s144 = _add(_s139, _multiply(_absolute(_s143, _r27), _s92, _r27), _r27)
    _s145 = _multiply(bend_s, normal_velocity, _r21)
    _s146 = _multiply(nz, bend_e, _r34)
    _s147 = _negative(_multiply(_s146, _s16, _r35), _r35)
    _s148 = _add(_s105, _add(_multiply(_absolute(_s145, _r0), _s66, _r0), _multiply(_absolute(_s147, _r73), _s92, _r73), _r73), _r73)
    _s149 = _add(_add(_add(_multiply(_multiply(normal_rounding, _s110, _r0), _s44, _r0), _s114, _r0), _s117, _r0), _s126, _r0)
    _s150 = _multiply(_k79, _s21, _r18)
    _s151 = _add(_multiply(_s111, _s143, _r1), _multiply(_k79, _s147, _r35), _r35)
    _s152 = _multiply(_k79, _s145, _r21)
    _s153 = _subtract(_add(_multiply(_s72, _s150, _r25), _add(_multiply(_s111, _subtract(_multiply(_s74, _s140, _r1), _multiply(_s15, _s141, _r77), _r77), _r77), _multiply(_k79, _s75, _r54), _r54), _r54), _multiply(_s151, _s97, _r25), _r25)
    _s154 = _add(_multiply(place_n, _absolute(_subtract(_subtract(_multiply(_s69, _s150, _r8), _multiply(_s151, _s94, _r54), _r54), _multiply(_s71, _s152, _r8), _r8), _r8), _r8), _multiply(place_s, _absolute(_subtract(_s153, _multiply(_s77, _s152, _r54), _r54), _r54), _r54), _r54)
    _s155 = _subtract(_add(_multiply(_s78, _s150, _r28), _add(_multiply(_s111, _subtract(_multiply(_s79, _s140, _r8), _multiply(_s29, _s141, _r25), _r25), _r25), _multiply(_k79, _s80, _r56), _r56), _r56), _multiply(_s151, _s99, _r28), _r28)
    _s156 = _multiply(pace_n, _absolute(_subtract(_subtract(_add(_multiply(_s82, _s150, _r30), _multiply(_k79, _s70, _r56), _r56), _multiply(_s151, _s100, _r30), _r30), _multiply(_s83, _s152, _r56), _r56), _r56), _r56)
    _s157 = _add(_add(_s154, _multiply(place_e, _absolute(_subtract(_s155, _multiply(_s81, _s152, _r30), _r30), _r30), _r30), _r30), _s156, _r56)
    _s158 = _k65 / p_ball_radius
    _s159 = _subtract(_subtract(_add(_multiply(_s84, _s150, _r31), _add(_multiply(_s111, _multiply(_s158, _s17, _r30), _r30), _multiply(_k79, _s76, _r54), _r54), _r54), _multiply(_s151, _s101, _r31), _r31), _multiply(_s85, _s152, _r54), _r54)
    _s160 = _subtract(_add(_multiply(_s87, _s150, _r18), _add(_multiply(_s111, _negative(_multiply(_s158, _s96, _r39), _r39), _r39), _multiply(_k79, _s14, _r31), _r31), _r31), _multiply(_s151, _s103, _r35), _r35)
    _s161 = _add(_add(_add(_s157, _multiply(pace_s, _absolute(_s159, _r54), _r54), _r54), _multiply(pace_e, _absolute(_subtract(_s160, _multiply(_s88, _s152, _r21), _r21), _r21), _r21), _r21), _multiply(turn_n, _absolute(_multiply(_s111, _s93, _r54), _r54), _r54), _r54)
    _s162 = _add(_add(_add(_multiply(_s111, _s144, _r21), _multiply(_k79, _s148, _r35), _r35), _s149, _r35), _add(_add(_s161, _multiply(turn_z, _absolute(_multiply(_s111, _s17, _r21), _r21), _r21), _r21), _multiply(turn_z, _absolute(_multiply(_s111, _s96, _r54), _r54), _r54), _r54), _r54)
    _s163 = _multiply(_k27, _s162, _r54)
    _s164 = _multiply(bend_s, _s141, _r35)
    _s165 = _absolute(_s164, _r21)
    _s166 = _add(_multiply(wx, tangent_x, _r56), _multiply(wy, tangent_y, _r31), _r31)
    _s167 = _negative(_multiply(_s146, _s166, _r56), _r56)
    _s168 = _add(_multiply(_s165, _s66, _r18), _multiply(_absolute(_s167, _r39), _s92, _r39), _r39)
    _s169 = _multiply(bend_e, _subtract(_multiply(nz, _s20, _r18), _multiply(normal_velocity, _s19, _r30), _r30), _r30)
    _s170 = _add(_s105, _add(_s139, _multiply(_absolute(_s169, _r18), _s92, _r18), _r18), _r18)
    _s171 = _negative(_multiply(_s111, _s164, _r35), _r35)
    _s172 = _subtract(_multiply(_k79, _s169, _r30), _multiply(_s111, _s167, _r56), _r56)
    _s173 = _subtract(_subtract(_subtract(_multiply(_k79, _s95, _r4), _multiply(_s111, _subtract(_multiply(_s18, _s141, _r10), _multiply(_s74, _s166, _r52), _r52), _r52), _r52), _multiply(_s171, _s77, _r4), _r4), _multiply(_s172, _s97, _r52), _r52)
    _s174 = _add(_multiply(place_n, _absolute(_negative(_add(_multiply(_s171, _s71, _r4), _multiply(_s172, _s94, _r10), _r10), _r10), _r10), _r10), _multiply(place_s, _absolute(_s173, _r52), _r52), _r52)
    _s175 = _subtract(_subtract(_subtract(_multiply(_k79, _s98, _r51), _multiply(_s111, _negative(_multiply(_s79, _s166, _r55), _r55), _r55), _r55), _multiply(_s171, _s81, _r51), _r51), _multiply(_s172, _s99, _r55), _r55)
    _s176 = _add(_add(_s174, _multiply(place_e, _absolute(_s175, _r55), _r55), _r55), _multiply(pace_n, _absolute(_subtract(_subtract(_multiply(_k79, _s93, _r63), _multiply(_s171, _s83, _r52), _r52), _multiply(_s172, _s100, _r63), _r63), _r63), _r63), _r63)
    _s177 = _absolute(_subtract(_subtract(_subtract(_multiply(_k79, _s96, _r22), _multiply(_s111, _multiply(_s158, _s14, _r55), _r55), _r55), _multiply(_s171, _s85, _r22), _r22), _multiply(_s172, _s101, _r55), _r55), _r55)
    _s178 = _subtract(_subtract(_subtract(_multiply(_k79, _s17, _r15), _multiply(_s111, _negative(_multiply(_s158, _s76, _r22), _r22), _r22), _r22), _multiply(_s171, _s88, _r35), _r35), _multiply(_s172, _s103, _r56), _r56)
    _s179 = _add(_add(_add(_add(_s176, _multiply(pace_s, _s177, _r55), _r55), _multiply(pace_e, _absolute(_s178, _r56), _r56), _r56), _multiply(turn_n, _absolute(_negative(_multiply(_s111, _s70, _r45), _r45), _r45), _r45), _r45), _multiply(turn_z, _absolute(_negative(_multiply(_s111, _s14, _r12), _r12), _r12), _r12), _r12)
    _s180 = _add(_add(_add(_multiply(_s111, _s168, _r45), _multiply(_k79, _s170, _r56), _r56), _s149, _r56), _add(_s179, _multiply(turn_z, _absolute(_negative(_multiply(_s111, _s76, _r24), _r24), _r24), _r24), _r24), _r24)
    _s181 = _multiply(_k27, _s180, _r24)
    _s182 = _negative(_multiply(bend_s, _s140, _r56), _r56)
    _s183 = _multiply(_s107, _s166, _r12)
    _s184 = _add(_multiply(_absolute(_s182, _r45), _s66, _r45), _multiply(_absolute(_s183, _r43), _s92, _r43), _r43)
    _s185 = _k75 * _s158
    _s186 = _add(_multiply(_s158, _s39, _r45), _s113, _r45)
    _s187 = _add(_add(_add(_multiply(_s158, _add(_s118, _s125, _r37), _r37), _multiply(_s52, _add(_multiply(_k22, spin_bound, _r46), _multiply(_s185, _s48, _r3), _r3), _r3), _r3), _multiply(_s121, _add(spin_bound, _s113, _r37), _r37), _r37), _multiply(_s120, _s186, _r76), _r76)
    _s188 = _add(_add(_s187, _multiply(_s122, _add(_multiply(_s185, _s39, _r37), _multiply(_k22, _s113, _r3), _r3), _r3), _r3), _multiply(_k69, _add(_multiply(_s52, _s113, _r42), _s124, _r42), _r42), _r42)
    _s189 = _add(_add(_add(_add(_multiply(_s158, _s117, _r3), _multiply(_k22, _multiply(_s112, _s113, _r38), _r38), _r38), _multiply(_k79, _multiply(_multiply(normal_rounding, _s158, _r3), _s39, _r3), _r3), _r3), _s184, _r3), _s188, _r3)
    _s190 = _multiply(place_s, _absolute(_subtract(_subtract(_subtract(_multiply(_s15, _s166, _r11), _multiply(_s18, _s140, _r13), _r13), _multiply(_s182, _s77, _r53), _r53), _multiply(_s183, _s97, _r6), _r6), _r6), _r6)
    _s191 = _add(_multiply(place_n, _absolute(_negative(_add(_multiply(_s182, _s71, _r44), _multiply(_s183, _s94, _r57), _r57), _r57), _r57), _r57), _s190, _r6)
    _s192 = _add(_s191, _multiply(place_e, _absolute(_subtract(_subtract(_multiply(_s29, _s166, _r26), _multiply(_s182, _s81, _r58), _r58), _multiply(_s183, _s99, _r20), _r20), _r20), _r20), _r20)
    _s193 = _add(_s192, _multiply(pace_n, _absolute(_negative(_add(_multiply(_s182, _s83, _r59), _multiply(_s183, _s100, _r64), _r64), _r64), _r64), _r64), _r64)
    _s194 = _add(_s193, _multiply(pace_s, _absolute(_subtract(_subtract(_multiply(_s158, _s31, _r20), _multiply(_s182, _s85, _r60), _r60), _multiply(_s183, _s101, _r65), _r65), _r65), _r65), _r65)
    _s195 = _multiply(pace_e, _absolute(_subtract(_subtract(_negative(_multiply(_s158, _s27, _r64), _r64), _multiply(_s182, _s88, _r56), _r56), _multiply(_s183, _s103, _r12), _r12), _r12), _r12)
    _s196 = _add(_s189, _add(_add(_add(_add(_s194, _s195, _r12), _multiply(turn_n, _absolute(_s10, _r2), _r2), _r2), _multiply(turn_z, _absolute(_s31, _r29), _r29), _r29), _multiply(turn_z, _absolute(_s27, _r23), _r23), _r23), _r23)
    _s197 = _multiply(_k27, _s196, _r23)
    _s198 = _add(_multiply(_s158, _add(_s117, _s149, _r0), _r0), _multiply(_k22, _multiply(_s112, _add(_multiply(_s185, _add(_s90, _s64, _r33), _r33), _s113, _r33), _r33), _r33), _r33)
    _s199 = _select(_s109 < _s148, _s148, _s109, _r0)
    _s200 = _select(_s184 < _s168, _s168, _s184, _r69)
    _s201 = _multiply(_k27, _add(_add(_s198, _add(_multiply(_s158, _select(_s199 < _s170, _s170, _s199, _r71), _r71), _select(_s200 < _s144, _s144, _s200, _r0), _r0), _r0), _s188, _r0), _r0)
    _s202 = _select(_s62 < _s89, _s89, _s62, _r42)
    _s203 = _result(_s63, _multiply(_k27, _add(_multiply(_k80, _add(_add(_s62, _s104, _r33), _s89, _r33), _r33), _multiply(_k81, _select(_s202 < _s104, _s104, _s202, _r69), _r69), _r69), _r69), _k30, _r0)
    _s204 = _multiply(_s91, _s89, _r69)
    _s205 = _add(_multiply(_s111, _s166, _r31), _multiply(_k79, _s20, _r16), _r16)
    _s206 = _negative(_multiply(p_restitution, normal_velocity, _r31), _r31)
    _s207 = _add(_s204, _multiply(_absolute(_multiply(bend_e, _subtract(_multiply(nz, _s205, _r33), _multiply(_s206, _s19, _r42), _r42), _r42), _r42), _s104, _r42), _r42)
    _s208 = _multiply(_k69, _add(_multiply(bend_s, _s89, _r33), _multiply(bend_e, _s104, _r71), _r71), _r71)
    _s209 = _multiply(_s116, _s208, _r74)
    _s210 = _add(_add(_s207, _s209, _r42), _s181, _r42)
    _s211 = _subtract(_multiply(_k79, _s16, _r14), _multiply(_s111, _s140, _r9), _r9)
    _s212 = _add(_add(_multiply(_absolute(_multiply(bend_s, _s206, _r31), _r31), _s89, _r31), _multiply(_absolute(_negative(_multiply(_s146, _s211, _r14), _r14), _r14), _s104, _r14), _r14), _s209, _r14)
    _s213 = _add(_s212, _s163, _r14)
    _s214 = _add(_add(_multiply(_absolute(_negative(_multiply(bend_s, _s205, _r31), _r31), _r31), _s89, _r31), _multiply(_absolute(_multiply(_s107, _s211, _r66), _r66), _s104, _r66), _r66), _s209, _r66)
    _s215 = _add(_s214, _s138, _r66)
    _s216 = _select(_s215 < _s213, _s213, _s215, _r74)
    _s217 = _result(_s63, _multiply(_k27, _add(_multiply(_k80, _add(_add(_s210, _s213, _r31), _s215, _r31), _r31), _multiply(_k81, _select(_s216 < _s210, _s210, _s216, _r33), _r33), _r33), _r33), _k30, _r0)
    _s218 = _negative(_multiply(_s158, _s211, _r9), _r9)
    _s219 = _multiply(_s158, _s205, _r16)
    _s220 = _multiply(_s186, _s208, _r71)
    _s221 = _add(_add(_multiply(_absolute(_negative(_multiply(bend_s, _s218, _r45), _r45), _r45), _s89, _r45), _multiply(_absolute(_multiply(_multiply(bend_e, _s219, _r33), _s19, _r33), _r33), _s104, _r33), _r33), _s220, _r33)
    _s222 = _add(_s221, _s197, _r33)
    _s223 = _add(_add(_divide(_s163, p_ball_radius, _r45), _s204, _r45), _multiply(_absolute(_multiply(bend_e, _subtract(_multiply(nz, _s218, _r9), _s142, _r9), _r9), _r9), _s104, _r9), _r9)
    _s224 = _add(_add(_s223, _s220, _r9), _s201, _r9)
    _s225 = _add(_add(_add(_divide(_s181, p_ball_radius, _r45), _multiply(_s165, _s89, _r21), _r21), _multiply(_absolute(_negative(_multiply(_s146, _s219, _r16), _r16), _r16), _s104, _r16), _r16), _s220, _r16)
    _s226 = _add(_s225, _s201, _r16)
    _s227 = _select(_s222 < _s226, _s226, _s222, _r71)
    _s228 = _result(_s63, _multiply(_k27, _add(_multiply(_k80, _add(_add(_s222, _s224, _r21), _s226, _r21), _r21), _multiply(_k81, _select(_s227 < _s224, _s224, _s227, _r34), _r34), _r34), _r34), _k30, _r0)
    return _result(_s63, _s62, _k30, _r0), _result(_s63, _s89, _k30, _r0), _result(_s63, _s104, _k30, _r0), _result(_s63, _s138, _k30, _r0), _result(_s63, _s163, _k30, _r0), _result(_s63, _s181, _k30, _r0), _result(_s63, _s197, _k30, _r0), _result(_s63, _s201, _k30, _r0), _s203, _s217, _s228, nx, ny, nz, tangent_x, tangent_y, bend_s, bend_e, _multiply(_k31, _add(t, clock, _r0), _r0) + _select(_s63, _multiply(_k27, _s45, _r41), _k30, _r23)


def vary_impact(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, dnx: Any, dny: Any, dnz: Any, p_ball_radius: Any, p_restitution: Any, change_ball_radius: Any, change_restitution: Any) -> tuple[Any, ...]:
    """Variations of velocity and spin after a contact, from those before it.

    derivative of the frame-free Eq. 17. 190 operations: 53 additions, 21 subtractions, 114 multiplications, 1 division, 1 negation.
    """
    _s0 = (((nx * dvx) + (vx * dnx)) + ((ny * dvy) + (vy * dny))) + ((nz * dvz) + (vz * dnz))
    _s1 = ((nx * vx) + (ny * vy)) + (nz * vz)
    _s2 = (nz * wy) - (ny * wz)
    _s3 = 0.4 * ((p_ball_radius * (((nz * dwy) + (wy * dnz)) - ((ny * dwz) + (wz * dny)))) + (change_ball_radius * _s2))
    _s4 = (0.6 * (dvx - ((nx * _s0) + (dnx * _s1)))) + _s3
    _s5 = (nx * wz) - (nz * wx)
    _s6 = 0.4 * ((p_ball_radius * (((nx * dwz) + (wz * dnx)) - ((nz * dwx) + (wx * dnz)))) + (change_ball_radius * _s5))
    _s7 = (0.6 * (dvy - ((ny * _s0) + (dny * _s1)))) + _s6
    _s8 = (ny * wx) - (nx * wy)
    _s9 = 0.4 * ((p_ball_radius * (((ny * dwx) + (wx * dny)) - ((nx * dwy) + (wy * dnx)))) + (change_ball_radius * _s8))
    _s10 = (0.6 * (dvz - ((nz * _s0) + (dnz * _s1)))) + _s9
    _s11 = (((nx * dwx) + (wx * dnx)) + ((ny * dwy) + (wy * dny))) + ((nz * dwz) + (wz * dnz))
    _s12 = ((nx * wx) + (ny * wy)) + (nz * wz)
    _s13 = 1.0 / p_ball_radius
    _s14 = 0.4 * p_ball_radius
    _s15 = (_s14 * _s8) + (0.6 * (vz - (nz * _s1)))
    _s16 = (_s14 * _s5) + (0.6 * (vy - (ny * _s1)))
    _s17 = -(change_ball_radius * (_s13 * _s13))
    _s18 = ((nx * _s11) + (dnx * _s12)) + ((_s13 * (((ny * _s10) + (dny * _s15)) - ((nz * _s7) + (dnz * _s16)))) + (_s17 * ((ny * _s15) - (nz * _s16))))
    _s19 = (_s14 * _s2) + (0.6 * (vx - (nx * _s1)))
    _s20 = ((ny * _s11) + (dny * _s12)) + ((_s13 * (((nz * _s4) + (dnz * _s19)) - ((nx * _s10) + (dnx * _s15)))) + (_s17 * ((nz * _s19) - (nx * _s15))))
    _s21 = ((nz * _s11) + (dnz * _s12)) + ((_s13 * (((nx * _s7) + (dnx * _s16)) - ((ny * _s4) + (dny * _s19)))) + (_s17 * ((nx * _s16) - (ny * _s19))))
    return _s4 - ((((p_restitution * nx) * _s0) + ((p_restitution * dnx) * _s1)) + ((nx * change_restitution) * _s1)), _s7 - ((((p_restitution * ny) * _s0) + ((p_restitution * dny) * _s1)) + ((ny * change_restitution) * _s1)), _s10 - ((((p_restitution * nz) * _s0) + ((p_restitution * dnz) * _s1)) + ((nz * change_restitution) * _s1)), _s18, _s20, _s21


def ring_coefficients(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Coefficients in time of the constraint polynomial, constant first.

    Eq. 3 in Table 2. 64 operations: 12 additions, 8 subtractions, 43 multiplications, 1 negation.
    """
    _s0 = p_ring_radius * p_ring_radius
    _s1 = x * x
    _s2 = y * y
    _s3 = p_ball_radius + p_wire_radius
    _s4 = (((_s0 + _s1) + _s2) + (z * z)) - (_s3 * _s3)
    _s5 = 4.0 * _s0
    _s6 = ((2.0 * x) * vx) + ((2.0 * y) * vy)
    _s7 = _s6 + ((2.0 * z) * vz)
    _s8 = 2.0 * _s7
    _s9 = (vx * vx) + (vy * vy)
    _s10 = vz * vz
    _s11 = (_s9 + _s10) - (p_gravity * z)
    _s12 = (2.0 * p_gravity) * vz
    _s13 = p_gravity * p_gravity
    _s14 = 0.5 * _s13
    return (_s4 * _s4) - (_s5 * (_s1 + _s2)), (_s8 * _s4) - (_s5 * _s6), (((2.0 * _s11) * _s4) + (_s7 * _s7)) - (_s5 * _s9), (_s8 * _s11) - (_s12 * _s4), ((_s14 * _s4) + (_s11 * _s11)) - (_s12 * _s7), (_s14 * _s7) - (_s12 * _s11), (_s13 * _s10) + (_s14 * _s11), -((0.5 * (p_gravity * _s13)) * vz), 0.0625 * (_s13 * _s13)


def ring_deflated(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Coefficients of the constraint polynomial over t, after a contact at t = 0.

    Eq. 3 in Table 2, the exact root divided out. 60 operations: 11 additions, 7 subtractions, 41 multiplications, 1 negation.
    """
    _s0 = ((2.0 * x) * vx) + ((2.0 * y) * vy)
    _s1 = _s0 + ((2.0 * z) * vz)
    _s2 = p_ring_radius * p_ring_radius
    _s3 = p_ball_radius + p_wire_radius
    _s4 = (((_s2 + (x * x)) + (y * y)) + (z * z)) - (_s3 * _s3)
    _s5 = 2.0 * _s1
    _s6 = 4.0 * _s2
    _s7 = (vx * vx) + (vy * vy)
    _s8 = vz * vz
    _s9 = (_s7 + _s8) - (p_gravity * z)
    _s10 = (2.0 * p_gravity) * vz
    _s11 = p_gravity * p_gravity
    _s12 = 0.5 * _s11
    return (_s5 * _s4) - (_s6 * _s0), (((2.0 * _s9) * _s4) + (_s1 * _s1)) - (_s6 * _s7), (_s5 * _s9) - (_s10 * _s4), ((_s12 * _s4) + (_s9 * _s9)) - (_s10 * _s1), (_s12 * _s1) - (_s10 * _s9), (_s11 * _s8) + (_s12 * _s9), -((0.5 * (p_gravity * _s11)) * vz), 0.0625 * (_s11 * _s11)


def ring_normal(x: Any, y: Any, z: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Outward unit normal n3 at a contact.

    Table 2. 13 operations: 2 additions, 1 subtraction, 7 multiplications, 2 divisions, 1 square root.
    """
    _r0, _r1 = _room[:2]
    _s0 = 1.0 / (p_ball_radius + p_wire_radius)
    _s1 = _sqrt(_add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1), _r1)
    _s2 = _multiply(_multiply(_s0, _subtract(_s1, p_ring_radius, _r0), _r0), _divide(_k51, _s1, _r1), _r0)
    return x * _s2, y * _s2, z * _s0


def ring_tangents(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, nx: Any, ny: Any, nz: Any, place_n: Any, normal_velocity: Any, back: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Tangent and curvatures at a contact, and bounds on the roundings there.

    Table 2, running error analysis. 123 operations: 37 additions, 2 subtractions, 45 multiplications, 6 divisions, 3 square roots, 1 negation, 11 absolute values, 8 comparisons, 10 selections.
    """
    t, x, y, z, vx, vy, vz, nx, ny, nz, place_n, normal_velocity, back, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity, = [_single(value) for value in (t, x, y, z, vx, vy, vz, nx, ny, nz, place_n, normal_velocity, back, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity,)]
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10 = _halves(_room[:11])
    _s0 = _sqrt(_add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1), _r1)
    _s1 = _k72 / _s0
    _s2 = p_ball_radius + p_wire_radius
    _s3 = _k65 / _s2
    _s4 = (p_ring_radius - p_ball_radius) - p_wire_radius
    _s5 = _where(_s4 < _s2, _s4, _s2)
    _s6 = _multiply(p_gravity, t, _r0)
    _s7 = _add(vz, _s6, _r2)
    _s8 = _absolute(vx, _r3)
    _s9 = _absolute(vy, _r4)
    _s10 = _absolute(vz, _r5)
    _s11 = _multiply(t, _add(_multiply(_k22, _add(_sqrt(p_gravity) * _sqrt(_s2), _select(_k29 < _s7, _s7, _k29, _r6), _r6), _r6), _add(_add(_add(_s6, _s8, _r0), _s9, _r0), _s10, _r0), _r0), _r0)
    _s12 = _add(_k24, _multiply(_k25, _multiply(t, _absolute(normal_velocity, _r6), _r6), _r6), _r6)
    _s13 = _multiply(t, t, _r2)
    _s14 = _add(_multiply(p_gravity, _s13, _r7), _multiply(t, _add(_add(_s8, _s9, _r8), _s10, _r8), _r8), _r8)
    _s15 = _multiply(_k22, t, _r7)
    _s16 = _add(_k24, _multiply(_k25, _add(_multiply(_s15, _s8, _r3), _absolute(x, _r5), _r5), _r5), _r5)
    _s17 = _add(_k24, _multiply(_k25, _add(_multiply(_s15, _s9, _r4), _absolute(y, _r3), _r3), _r3), _r3)
    _s18 = _k23 * p_gravity
    _s19 = _add(_add(_multiply(_s18, _s13, _r2), _multiply(_s15, _absolute(_add(vz, _multiply(_s18, t, _r4), _r4), _r4), _r4), _r4), _absolute(z, _r2), _r2)
    _s20 = _add(_k24, _multiply(_k25, _s19, _r2), _r2)
    _s21 = _k36 * (p_ring_radius * _s3)
    _s22 = _add(_divide(_multiply(_multiply(_k99, _s14, _r4), _add(_add(_s16, _s17, _r7), _s20, _r7), _r4), _s5, _r4), _multiply(_k35 * (_k100 + _s21), _s14, _r8), _r8)
    _s23 = _multiply(_k101, _s22, _r4)
    _s24 = _multiply(_k102, _multiply(_divide(_multiply(normal_velocity, normal_velocity, _r7), _add(_add(_multiply(vx, vx, _r9), _multiply(vy, vy, _r10), _r10), _multiply(vz, vz, _r9), _r9), _r9), _s2, _r9), _r9)
    _s25 = _add(_add(_s12, _s22, _r8), _select(_s23 < _s24, _s24, _s23, _r7), _r7)
    _s26 = _add(_multiply(_k25, _add(_k103 * _s2, _multiply(_k22, _s0, _r1), _r1), _r1), _add(_add(_multiply(_absolute(nx, _r4), _s16, _r4), _multiply(_absolute(ny, _r5), _s17, _r5), _r5), _multiply(_absolute(nz, _r4), _s20, _r4), _r4), _r4)
    _s27 = _multiply(_k101, _s26, _r1)
    _s28 = _add(_add(_s12, _s26, _r4), _select(_s27 < _s24, _s24, _s27, _r6), _r6)
    _s29 = _add(place_n, _s28, _r1)
    _s30 = _multiply(_k78, _divide(_s11, _s5, _r0), _r0) <= _k72
    _s31 = _k29 < back
    _s32 = _add(place_n, _s25, _r0)
    return -_multiply(y, _s1, _r4), x * _s1, _s3, _s1, _k65 / _s5, _result(_s31, _select(_s30, _s25, _select(_s25 < _s29, _s29, _s25, _r4), _r9), _s28, _r0), _result(_s31, _select(_s30, _s32, _select(_s32 < _s28, _s28, _s32, _r9), _r4), _s28, _r0), _k35 * (_k104 + _s21)


def ring_vary(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, nx: Any, ny: Any, nz: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, change_ball_radius: Any, change_ring_radius: Any, change_wire_radius: Any) -> tuple[Any, ...]:
    """Delay of a contact, distance there, and variations of position, velocity and normal; the change of the distance at a fixed time, and bounds with their changes at the contact.

    derivatives of the distance, of Eq. 3, of the normal and of Eq. 2. 75 operations: 17 additions, 9 subtractions, 40 multiplications, 4 divisions, 2 square roots, 3 negations.
    """
    _s0 = _sqrt(((x * x) + (y * y)))
    _s1 = _s0 - p_ring_radius
    _s2 = _sqrt(((z * z) + (_s1 * _s1)))
    _s3 = (((((nx * dx) + (ny * dy)) + (nz * dz)) - change_ball_radius) - change_wire_radius) - (((0.5 * change_ring_radius) * ((2.0 * _s0) - (2.0 * p_ring_radius))) / _s2)
    _s4 = -(_s3 * (1.0 / (((nx * vx) + (ny * vy)) + (nz * vz))))
    _s5 = dx + (vx * _s4)
    _s6 = dy + (vy * _s4)
    _s7 = dz + (vz * _s4)
    _s8 = 1.0 / (p_ball_radius + p_wire_radius)
    _s9 = -((change_ball_radius + change_wire_radius) * (_s8 * _s8))
    _s10 = 1.0 / _s0
    _s11 = ((x * _s5) + (y * _s6)) * _s10
    _s12 = ((_s9 * _s1) * _s10) + (((-(_s11 * (_s10 * _s10))) * _s8) * _s1)
    _s13 = _s12 + ((_s8 * (_s11 - change_ring_radius)) * _s10)
    _s14 = (_s8 * _s1) * _s10
    return _s4, (_s2 - p_ball_radius) - p_wire_radius, _s3, _s5, _s6, _s7, dvx, dvy, dvz - (p_gravity * _s4), (x * _s13) + (_s14 * _s5), (y * _s13) + (_s14 * _s6), (z * _s9) + (_s8 * _s7)


def ring_excess(share: Any, horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Positive if errors of the state exceed those that a search allows for.

    running error analysis. 26 operations: 6 additions, 3 subtractions, 10 multiplications, 1 division, 3 comparisons, 3 selections.
    """
    _r0, _r1, _r2, _r3 = _room[:4]
    _s0 = _add(speed, _multiply(p_gravity, horizon, _r0), _r0)
    _s1 = _multiply(horizon, _s0, _r1)
    _s2 = _subtract(_add(position_error, _multiply(horizon, velocity_error, _r2), _r2), _multiply(share, _add(_s1, _add(extent, _s1, _r3), _r3), _r3), _r3)
    _s3 = 1.00006103515625 * (p_ball_radius + p_wire_radius)
    _s4 = p_ring_radius - _s3
    _s5 = 0.0001220703125 * p_ring_radius
    _s6 = _s3 / _where(_s4 < _s5, _s5, _s4)
    _s7 = _add(_multiply(_multiply(_s0, _where(1.0 < _s6, _s6, 1.0), _r2), _s2, _r2), _multiply(_s3, _subtract(velocity_error, _multiply(share, _s0, _r0), _r0), _r0), _r0)
    return _result(_s2 < _s7, _s7, _s2, _r0),


def ring_clear(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Positive if there is certainly no contact before the horizon.

    bounds of the event condition. 146 operations: 27 additions, 19 subtractions, 67 multiplications, 1 division, 2 square roots, 15 comparisons, 15 selections.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15 = _room[:16]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = (0.000244140625 * p_ring_radius) - (p_ring_radius - _s0)
    _s2 = _add(position_error, _multiply(horizon, velocity_error, _r0), _r0)
    _s3 = _subtract(_subtract(_s2, 1.52587890625e-05 * p_ball_radius, _r1), 1.52587890625e-05 * p_wire_radius, _r1)
    _s4 = 1.00006103515625 * _s0
    _s5 = p_ring_radius + _s4
    _s6 = _multiply(vz, vz, _r2)
    _s7 = _add(_s6, _multiply(2.0 * p_gravity, _subtract(z, _s4, _r3), _r3), _r3)
    _s8 = 1.0 / p_gravity
    _s9 = _sqrt(_s7, _r4)
    _s10 = _multiply(_s8, _subtract(vz, _s9, _r5), _r5)
    _s11 = _multiply(_s8, _add(vz, _s9, _r4), _r4)
    _s12 = _add(x, _multiply(vx, _s11, _r6), _r6)
    _s13 = _add(y, _multiply(vy, _s11, _r7), _r7)
    _s14 = _add(_multiply(_s12, _s12, _r8), _multiply(_s13, _s13, _r9), _r9)
    _s15 = _sqrt(_s14, _r8)
    _s16 = _subtract(_s15, p_ring_radius, _r10)
    _s17 = _add(z, _multiply(_subtract(vz, _multiply(0.5 * p_gravity, _s11, _r11), _r11), _s11, _r11), _r11)
    _s18 = _s5 * _s5
    _s19 = 9.313225746154785e-10 * _s18
    _s20 = _subtract(_subtract(_add(_multiply(_s16, _s16, _r12), _multiply(_s17, _s17, _r13), _r13), _s0 * _s0, _r13), _s19, _r13)
    _s21 = _add(_multiply(vx, vx, _r12), _multiply(vy, vy, _r14), _r14)
    _s22 = p_ring_radius - _s4
    _s23 = 0.0001220703125 * p_ring_radius
    _s24 = _where(_s22 < _s23, _s23, _s22)
    _s25 = _s24 * _s24
    _s26 = _s24 * _s25
    _s27 = _multiply(_subtract(_add(_add(_multiply(_k52, _s6, _r2), _multiply(4.0 * p_gravity, z, _r12), _r12), _multiply(_k52, _s21, _r2), _r2), (6.0003662109375 * p_gravity) * _s0, _r2), _s26, _r2)
    _s28 = _subtract(_multiply(x, vy, _r12), _multiply(y, vx, _r15), _r15)
    _s29 = _multiply(_s28, _s28, _r15)
    _s30 = _subtract(_s27, _multiply(2.0 * p_ring_radius, _s29, _r12), _r12)
    _s31 = _add(_multiply(_s16, _add(_multiply(vx, _s12, _r6), _multiply(vy, _s13, _r7), _r7), _r7), _multiply(_multiply(_s17, _subtract(vz, _multiply(p_gravity, _s11, _r10), _r10), _r10), _s15, _r10), _r10)
    _s32 = _add(x, _multiply(vx, horizon, _r7), _r7)
    _s33 = _add(y, _multiply(vy, horizon, _r8), _r8)
    _s34 = _select(_subtract(_add(_add(_s19, _multiply(_s32, _s32, _r7), _r7), _multiply(_s33, _s33, _r8), _r8), _s25, _r8) < _k7, _k51, _select(_subtract(_multiply(_s21, _s19 + _s25, _r8), _s29, _r8) < _k7, _k51, _k7, _r8), _r15)
    _s35 = _select(_subtract(_multiply(_multiply(_k110, _multiply(_s31, _s31, _r10), _r10), _s26, _r10), _multiply(_multiply(_multiply(_k52, _s30, _r7), _s14, _r7), _s20, _r7), _r7) < _k7, _s34, _k7, _r7)
    _s36 = _select(horizon < _subtract(_s11, _multiply(_k66, horizon, _r10), _r10), _k51, _select(_k7 < _s20, _select(_k7 < _s30, _s35, _k7, _r12), _k7, _r13), _r10)
    _s37 = _add(_multiply(x, vx, _r4), _multiply(y, vy, _r9), _r9)
    _s38 = _add(_multiply(_s10, _s21, _r14), _s37, _r14)
    _s39 = _select(_s38 < _k7, _select(_s18 < _add(_multiply(_s10, _add(_s37, _s38, _r14), _r14), _add(_multiply(x, x, _r9), _multiply(y, y, _r4), _r4), _r4), _s36, _k7, _r4), _k7, _r14)
    _s40 = _select(_add(extent, _multiply(horizon, _add(speed, _multiply(p_gravity, horizon, _r9), _r9), _r9), _r9) < (65536.0 * _s5), _select(_k7 < _s7, _select(_s10 < _k7, _s36, _s39, _r5), _k7, _r3), _k7, _r9)
    return _result(_k7 < _select(_s1 < _s3, _s3, _s1, _r11), _k7, _select(_s2 < (5.820766091346741e-11 * _s5), _s40, _k7, _r0), _r0),


def ring_prepare(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Constants and windows of the search along a flight, and its error budget.

    bounds of the event condition. 190 operations: 31 additions, 20 subtractions, 54 multiplications, 3 divisions, 7 square roots, 1 negation, 5 absolute values, 31 comparisons, 38 selections.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18, _r19, _r20, _r21, _r22, _r23, _r24, _r25, _r26, _r27, _r28, _r29, _r30, _r31, _r32, _r33, _r34, _r35 = _room[:36]
    _s0 = _multiply(vz, vz, _r0)
    _s1 = _add(_multiply(vx, vx, _r1), _multiply(vy, vy, _r2), _r2)
    _s2 = _add(_multiply(_k52, _s0, _r1), _multiply(4.0 * p_gravity, z, _r3), _r3) + _multiply(_k52, _s1, _r1)
    _s3 = _subtract(_multiply(x, vy, _r1), _multiply(y, vx, _r3), _r3)
    _s4 = _multiply(_s3, _s3, _r1)
    _s5 = (2.0 * p_ring_radius) * _s4
    _s6 = _add(_multiply(x, x, _r4), _multiply(y, y, _r5), _r5)
    _s7 = p_ball_radius + p_wire_radius
    _s8 = 1.00006103515625 * _s7
    _s9 = 2.0 * p_gravity
    _s10 = _multiply(_k115, _add(_s0, _multiply(_s9, _add(_absolute(z, _r4), _s8, _r4), _r4), _r4), _r4)
    _s11 = _add(_add(_s0, _multiply(_s9, _add(z, _s8, _r6), _r6), _r6), _s10, _r6)
    _s12 = 1.0 / p_gravity
    _s13 = _sqrt(_s11, _r7)
    _s14 = _multiply(_k53, _add(_absolute(vz, _r8), _s13, _r8), _r8)
    _s15 = _k7 <= _s11
    _s16 = _select(_s15, _multiply(_s12, _subtract(_subtract(vz, _s13, _r6), _s14, _r6), _r6), _k8, _r9)
    _s17 = p_ring_radius + _s8
    _s18 = _s17 * _s17
    _s19 = _multiply(_multiply(_k53, _s1, _r10), _add(_s18, _s6, _r11), _r10)
    _s20 = _subtract(_add(_multiply(_s18, _s1, _r11), _s19, _r11), _s4, _r11)
    _s21 = _add(_multiply(x, vx, _r12), _multiply(y, vy, _r13), _r13)
    _s22 = _sqrt(_s20, _r12)
    _s23 = _multiply(_k53, _add(_add(_absolute(_s21, _r14), _absolute(_s3, _r3), _r3), _s22, _r3), _r3)
    _s24 = _divide(_k51, _s1, _r14)
    _s25 = _k7 <= _s20
    _s26 = _k116 < _s1
    _s27 = _select(_s26, _select(_s25, _multiply(_negative(_add(_add(_s21, _s22, _r11), _s23, _r11), _r11), _s24, _r11), _k8, _r15), _k117, _r16)
    _s28 = _select(_s16 < _s27, _s27, _s16, _r17)
    _s29 = p_ring_radius - _s8
    _s30 = 0.0001220703125 * p_ring_radius
    _s31 = _where(_s29 < _s30, _s30, _s29)
    _s32 = _subtract(_subtract(_multiply(_s1, _s31 * _s31, _r2), _s19, _r2), _s4, _r2)
    _s33 = _sqrt(_select(_s32 < _k7, _k7, _s32, _r1), _r1)
    _s34 = _select(_s26, _select(_s25, _multiply(_subtract(_add(_s22, _s23, _r12), _s21, _r12), _s24, _r12), _k117, _r10), _k8, _r18)
    _s35 = _k7 < _select(_s26, _s32, _k7, _r19)
    _s36 = _select(_s35, _multiply(_subtract(_subtract(_s23, _s21, _r19), _s33, _r19), _s24, _r19), _s34, _r2)
    _s37 = _subtract(_add(_s0, _multiply(_s9, _subtract(z, _s8, _r20), _r20), _r20), _s10, _r20)
    _s38 = _sqrt(_select(_s37 < _k7, _k7, _s37, _r4), _r4)
    _s39 = _select(_s15, _multiply(_s12, _add(_add(vz, _s13, _r7), _s14, _r7), _r7), _k117, _r0)
    _s40 = _k7 < _s37
    _s41 = _select(_s40, _multiply(_s12, _subtract(_add(vz, _s14, _r20), _s38, _r20), _r20), _s39, _r21)
    _s42 = _select(_s36 < _s41, _s36, _s41, _r22)
    _s43 = _select(_s35, _multiply(_subtract(_subtract(_s33, _s21, _r1), _s23, _r1), _s24, _r1), _k8, _r14)
    _s44 = _select(_s43 < _s36, _s36, _s43, _r3)
    _s45 = _select(_s16 < _s44, _s44, _s16, _r13)
    _s46 = _select(_s34 < _s41, _s34, _s41, _r23)
    _s47 = _select(_s40, _multiply(_s12, _subtract(_add(vz, _s38, _r4), _s14, _r4), _r4), _k8, _r8)
    _s48 = _select(_s47 < _s41, _s41, _s47, _r24)
    _s49 = _s45 <= _s46
    _s50 = _select(_s49, _s45, _select(_s48 < _s27, _s27, _s48, _r25), _r26)
    _s51 = _select(_s49, _s46, _select(_s36 < _s39, _s36, _s39, _r27), _r28)
    _s52 = _select(_s48 < _s44, _s44, _s48, _r29)
    _s53 = _select(_s34 < _s39, _s34, _s39, _r30)
    _s54 = 1.0 / _s31
    _s55 = _select(_k7 < _s42, _s42, _k7, _r31)
    _s56 = _select(_s55 < _s51, _s51, _s55, _r32)
    _s57 = _select(_s56 < _s53, _s53, _s56, _r33)
    _s58 = (0.000244140625 * p_ring_radius) - (p_ring_radius - _s7)
    _s59 = _multiply(_sqrt(2.0), _sqrt(_multiply(_s12, _add((2.0 * p_ball_radius) + (2.0 * p_wire_radius), extent, _r34), _r34), _r34), _r34)
    _s60 = _add(_s59, _multiply(_multiply(_k52, speed, _r35), _s12, _r35), _r35)
    _s61 = _subtract(_subtract(_add(position_error, _multiply(velocity_error, _select(_s60 < horizon, _s60, horizon, _r34), _r34), _r34), 1.52587890625e-05 * p_ball_radius, _r34), 1.52587890625e-05 * p_wire_radius, _r34)
    return _s2, _s5, _sqrt(_s6), _result(_k7 < _s28, _s28, _k7, _r0), _result(_s42 < horizon, _s42, horizon, _r0), _result(_k7 < _s50, _s50, _k7, _r0), _result(_s51 < horizon, _s51, horizon, _r0), _result(_k7 < _s52, _s52, _k7, _r0), _result(_s53 < horizon, _s53, horizon, _r0), _add((6.0003662109375 * p_gravity) * _s7, _multiply(_s5, _s54 * (_s54 * _s54), _r29), _r29) + _absolute(_s2, _r24), _result(_s57 < horizon, _s57, horizon, _r0), _result(_s58 < _s61, _s61, _s58, _r0)


def ring_margins(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.

    running error analysis. 47 operations: 14 additions, 1 subtraction, 27 multiplications, 1 division, 2 comparisons, 2 selections.
    """
    _r0, _r1, _r2, _r3, _r4, _r5 = _room[:6]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = _add(speed, _multiply(p_gravity, horizon, _r0), _r0)
    _s2 = 1.00006103515625 * _s0
    _s3 = _multiply(_s2, _s1, _r1)
    _s4 = p_ring_radius + _s2
    _s5 = _add(extent, _multiply(horizon, _s1, _r2), _r2)
    _s6 = _add(_add(position_error, _multiply(horizon, velocity_error, _r3), _r3), _multiply(_k17, _s5, _r4), _r4)
    _s7 = p_ring_radius - _s2
    _s8 = 0.0001220703125 * p_ring_radius
    _s9 = _s2 / _where(_s7 < _s8, _s8, _s7)
    _s10 = _where(1.0 < _s9, _s9, 1.0)
    _s11 = _multiply(_k121, _add(_multiply(_multiply(_s1, _s10, _r3), _s6, _r3), _multiply(_s2, _add(velocity_error, _multiply(_k122, _s1, _r5), _r5), _r5), _r5), _r5)
    _s12 = _k14 * _add(_add(_multiply(_multiply(_k123, _s1, _r3), _add(_multiply(_s5, _s10, _r2), _s4, _r2), _r3), _multiply(_k17, _s3, _r2), _r2), _s11, _r2)
    return _k14 * _add(_add(_multiply(_multiply(_k17, horizon, _r2), _s3, _r2), (1.3323489447131243e-15 * _s0) * _s4, _r2), _multiply(5.00030517578125 * _s0, _s6, _r4), _r4), _s12, _k14 * _add(_multiply(_k123, _multiply(_s4, _s1, _r0), _r0), _s11, _r0)


def ring_refine(t: Any, leaving: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, rho_start: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Newton's next value of a root near t, and gap and rate there.

    Newton's method. 56 operations: 15 additions, 6 subtractions, 30 multiplications, 2 divisions, 1 square root, 1 comparison, 1 selection.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7 = _room[:8]
    _s0 = _add(x, _multiply(vx, t, _r0), _r0)
    _s1 = _add(y, _multiply(vy, t, _r1), _r1)
    _s2 = _sqrt(_add(_multiply(_s0, _s0, _r2), _multiply(_s1, _s1, _r3), _r3), _r3)
    _s3 = _add(rho_start, _s2, _r2)
    _s4 = _divide(_k51, _multiply(_s3, _s2, _r4), _r4)
    _s5 = _subtract(_s2, p_ring_radius, _r5)
    _s6 = _subtract(vz, _multiply(0.5 * p_gravity, t, _r6), _r6)
    _s7 = _add(z, _multiply(t, _s6, _r7), _r7)
    _s8 = _k52 * _add(_multiply(_multiply(_multiply(_s3, _s4, _r2), _add(_multiply(vx, _s0, _r0), _multiply(vy, _s1, _r1), _r1), _r1), _s5, _r1), _multiply(_s7, _subtract(vz, _multiply(p_gravity, t, _r2), _r2), _r2), _r2)
    _s9 = _multiply(_multiply(_add(_multiply(t, _add(_multiply(vx, vx, _r2), _multiply(vy, vy, _r1), _r1), _r1), _multiply(_k52, _add(_multiply(x, vx, _r2), _multiply(y, vy, _r0), _r0), _r0), _r0), _add(_subtract(rho_start, p_ring_radius, _r1), _s5, _r1), _r1), _multiply(_s2, _s4, _r4), _r4)
    _s10 = p_ball_radius + p_wire_radius
    _s11 = _result(_k7 < leaving, _multiply(t, _add(_s9, _multiply(_add(z, _s7, _r1), _s6, _r1), _r1), _r1), _subtract(_add(_multiply(_s5, _s5, _r5), _multiply(_s7, _s7, _r7), _r7), _s10 * _s10, _r7), _r0)
    return t - _divide(_s11, _s8, _r7), _s11, _s8


def ring_advance(t: Any, end: Any, leaving: Any, margin: Any, rate_margin: Any, ceiling: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, energy2: Any, moment2: Any, rho_start: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Gap, rate, second derivative, a step without a root, its end, and the clearance.

    Newton from the left under a curvature bound. 143 operations: 29 additions, 16 subtractions, 53 multiplications, 4 divisions, 2 square roots, 2 negations, 2 absolute values, 16 comparisons, 19 selections.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15 = _room[:16]
    _s0 = _add(x, _multiply(vx, t, _r0), _r0)
    _s1 = _add(y, _multiply(vy, t, _r1), _r1)
    _s2 = _sqrt(_add(_multiply(_s0, _s0, _r2), _multiply(_s1, _s1, _r3), _r3), _r3)
    _s3 = _subtract(_s2, p_ring_radius, _r2)
    _s4 = _add(rho_start, _s2, _r4)
    _s5 = _divide(_k51, _multiply(_s4, _s2, _r5), _r5)
    _s6 = _multiply(_multiply(_add(_multiply(t, _add(_multiply(vx, vx, _r6), _multiply(vy, vy, _r7), _r7), _r7), _multiply(_k52, _add(_multiply(x, vx, _r6), _multiply(y, vy, _r8), _r8), _r8), _r8), _add(_subtract(rho_start, p_ring_radius, _r7), _s3, _r7), _r7), _multiply(_s2, _s5, _r8), _r8)
    _s7 = _subtract(vz, _multiply(0.5 * p_gravity, t, _r7), _r7)
    _s8 = _add(z, _multiply(t, _s7, _r6), _r6)
    _s9 = p_ball_radius + p_wire_radius
    _s10 = _result(_k7 < leaving, _multiply(t, _add(_s6, _multiply(_add(z, _s8, _r9), _s7, _r9), _r9), _r9), _subtract(_add(_multiply(_s3, _s3, _r8), _multiply(_s8, _s8, _r7), _r7), _s9 * _s9, _r7), _r0)
    _s11 = _multiply(_s4, _s5, _r5)
    _s12 = _multiply(_s11, _add(_multiply(vx, _s0, _r0), _multiply(vy, _s1, _r1), _r1), _r1)
    _s13 = _subtract(vz, _multiply(p_gravity, t, _r0), _r0)
    _s14 = _k52 * _add(_multiply(_s12, _s3, _r2), _multiply(_s8, _s13, _r4), _r4)
    _s15 = 6.0 * p_gravity
    _s16 = _multiply(_s15, _s8, _r4)
    _s17 = _multiply(moment2, _multiply(_s11, _multiply(_s11, _s11, _r2), _r2), _r2)
    _s18 = 1.00006103515625 * _s9
    _s19 = 9.094947017729282e-13 * (p_ring_radius + _s18)
    _s20 = _subtract(_s14, rate_margin, _r5)
    _s21 = _subtract(_s10, margin, _r7)
    _s22 = _select(_s21 < _k7, _k7, _s21, _r9)
    _s23 = _subtract(_add(_s16, _s17, _r8), energy2, _r8)
    _s24 = _s20 < _k7
    _s25 = _multiply(_k52, _s22, _r10)
    _s26 = _select(_k7 < _select(_k7 <= _s20, _s22, _k7, _r11), _k8, _divide(_select(_s24, _s25, _multiply(_k110, _s20, _r11), _r12), _select(_s24, _negative(_s20, _r13), _select(_k7 < _s23, _s23, _k7, _r14), _r15), _r12), _r11)
    _s27 = _subtract(end, t, _r15)
    _s28 = _select(_s26 < _s27, _s26, _s27, _r14)
    _s29 = _add(_s19, _add(_multiply(_s28, _select(_s13 < _k7, _k7, _s13, _r8), _r8), _s8, _r8), _r8)
    _s30 = _multiply(_s15, _select(_s18 < _s29, _s18, _s29, _r6), _r6)
    _s31 = _subtract(_add(_multiply(_s28, _select(_k7 < _s12, _k7, _s12, _r8), _r8), _s2, _r8), _s19, _r8)
    _s32 = p_ring_radius - _s18
    _s33 = 0.0001220703125 * p_ring_radius
    _s34 = _where(_s32 < _s33, _s33, _s32)
    _s35 = _divide(_k51, _select(_s31 < _s34, _s34, _s31, _r3), _r3)
    _s36 = _multiply(moment2, _multiply(_s35, _multiply(_s35, _s35, _r8), _r8), _r8)
    _s37 = _subtract(_add(_add(_s30, _s36, _r3), _multiply(_k129, _add(_add(_s36, _absolute(energy2, _r1), _r1), _absolute(_s30, _r6), _r6), _r6), _r6), energy2, _r6)
    _s38 = _add(_multiply(_multiply(_k52, _s37, _r3), _s22, _r3), _multiply(_s20, _s20, _r9), _r9)
    _s39 = _sqrt(_s38, _r3)
    _s40 = _select(_k7 <= _s38, _divide(_select(_s24, _s25, _add(_s20, _s39, _r9), _r7), _select(_s24, _subtract(_s39, _s20, _r3), _select(_k7 < _s37, _s37, _k7, _r5), _r1), _r7), _k8, _r9)
    _s41 = _result(_s40 < _s28, _s40, _s28, _r0)
    _s42 = _negative(_add(rate_margin, _s14, _r1), _r1)
    return _s10, _s14, _subtract(energy2, _s16, _r4) - _s17, _s41, t + _s41, _result(_k7 < _s42, _subtract(_multiply(_s42, _s42, _r9), _multiply(_multiply(_k56, ceiling, _r7), _add(margin, _s25, _r10), _r7), _r7), _s42, _r0)


def ring_opened(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Windows of the search along a flight, and whether single precision serves for it.

    bounds of the event condition. 186 operations: 24 additions, 16 subtractions, 37 multiplications, 2 divisions, 4 square roots, 1 negation, 4 absolute values, 43 comparisons, 7 conjunctions, 3 disjunctions, 45 selections.
    """
    horizon, x, y, z, vx, vy, vz, extent, speed, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity, = [_single(value) for value in (horizon, x, y, z, vx, vy, vz, extent, speed, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity,)]
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18, _r19, _r20, _r21, _r22, _r23, _r24, _r25, _r26, _r27, _r28, _r29, _r30, _r31, _r32, _r33, _r34, _r35, _r36, _r37, _r38, _r39, _r40 = _halves(_room[:41])
    _s0 = _multiply(vz, vz, _r0)
    _s1 = _k131 * (p_ball_radius + p_wire_radius)
    _s2 = _k36 * p_gravity
    _s3 = _multiply(_k132, _add(_s0, _multiply(_s2, _add(_absolute(z, _r1), _s1, _r1), _r1), _r1), _r1)
    _s4 = _add(_add(_s0, _multiply(_s2, _add(z, _s1, _r2), _r2), _r2), _s3, _r2)
    _s5 = _k65 / p_gravity
    _s6 = _sqrt(_s4, _r3)
    _s7 = _multiply(_k74, _add(_absolute(vz, _r4), _s6, _r4), _r4)
    _s8 = _k29 <= _s4
    _s9 = _select(_s8, _multiply(_s5, _subtract(_subtract(vz, _s6, _r2), _s7, _r2), _r2), _k30, _r5)
    _s10 = _add(_multiply(vx, vx, _r6), _multiply(vy, vy, _r7), _r7)
    _s11 = p_ring_radius + _s1
    _s12 = _s11 * _s11
    _s13 = _multiply(_multiply(_k74, _s10, _r6), _add(_s12, _add(_multiply(x, x, _r8), _multiply(y, y, _r9), _r9), _r9), _r6)
    _s14 = _subtract(_multiply(x, vy, _r9), _multiply(y, vx, _r8), _r8)
    _s15 = _multiply(_s14, _s14, _r9)
    _s16 = _subtract(_add(_multiply(_s12, _s10, _r10), _s13, _r10), _s15, _r10)
    _s17 = _add(_multiply(x, vx, _r11), _multiply(y, vy, _r12), _r12)
    _s18 = _sqrt(_s16, _r11)
    _s19 = _multiply(_k74, _add(_add(_absolute(_s17, _r13), _absolute(_s14, _r8), _r8), _s18, _r8), _r8)
    _s20 = _divide(_k72, _s10, _r13)
    _s21 = _k29 <= _s16
    _s22 = _k133 < _s10
    _s23 = _select(_s22, _select(_s21, _multiply(_negative(_add(_add(_s17, _s18, _r10), _s19, _r10), _r10), _s20, _r10), _k30, _r14), _k134, _r15)
    _s24 = _select(_s9 < _s23, _s23, _s9, _r16)
    _s25 = _select(_k29 < _s24, _s24, _k29, _r17)
    _s26 = _select(_k29 < _s25, _s25, _k29, _r18)
    _s27 = p_ring_radius - _s1
    _s28 = _k135 * p_ring_radius
    _s29 = _where(_s27 < _s28, _s28, _s27)
    _s30 = _subtract(_subtract(_multiply(_s10, _s29 * _s29, _r7), _s13, _r7), _s15, _r7)
    _s31 = _sqrt(_select(_s30 < _k29, _k29, _s30, _r9), _r9)
    _s32 = _select(_s22, _select(_s21, _multiply(_subtract(_add(_s18, _s19, _r11), _s17, _r11), _s20, _r11), _k134, _r6), _k30, _r19)
    _s33 = _k29 < _select(_s22, _s30, _k29, _r20)
    _s34 = _select(_s33, _multiply(_subtract(_subtract(_s19, _s17, _r20), _s31, _r20), _s20, _r20), _s32, _r7)
    _s35 = _subtract(_add(_s0, _multiply(_s2, _subtract(z, _s1, _r21), _r21), _r21), _s3, _r21)
    _s36 = _sqrt(_select(_s35 < _k29, _k29, _s35, _r1), _r1)
    _s37 = _select(_s8, _multiply(_s5, _add(_add(vz, _s6, _r3), _s7, _r3), _r3), _k134, _r0)
    _s38 = _k29 < _s35
    _s39 = _select(_s38, _multiply(_s5, _subtract(_add(vz, _s7, _r21), _s36, _r21), _r21), _s37, _r22)
    _s40 = _select(_s34 < _s39, _s34, _s39, _r23)
    _s41 = _multiply(_k136, horizon, _r24)
    _s42 = _select(_s40 < _s41, _s40, _s41, _r25)
    _s43 = _s26 < _s42
    _s44 = _select(_s33, _multiply(_subtract(_subtract(_s31, _s17, _r9), _s19, _r9), _s20, _r9), _k30, _r13)
    _s45 = _select(_s44 < _s34, _s34, _s44, _r8)
    _s46 = _select(_s9 < _s45, _s45, _s9, _r12)
    _s47 = _select(_s32 < _s39, _s32, _s39, _r26)
    _s48 = _select(_s38, _multiply(_s5, _subtract(_add(vz, _s36, _r1), _s7, _r1), _r1), _k30, _r4)
    _s49 = _select(_s48 < _s39, _s39, _s48, _r27)
    _s50 = _s46 <= _s47
    _s51 = _select(_s50, _s46, _select(_s49 < _s23, _s23, _s49, _r28), _r29)
    _s52 = _result(_k29 < _s51, _s51, _k29, _r0)
    _s53 = _select(_k29 < _s52, _s52, _k29, _r30)
    _s54 = _select(_s50, _s47, _select(_s34 < _s37, _s34, _s37, _r31), _r32)
    _s55 = _result(_s54 < _s41, _s54, _s41, _r0)
    _s56 = _s53 < _s55
    _s57 = _select(_s49 < _s45, _s45, _s49, _r33)
    _s58 = _result(_k29 < _s57, _s57, _k29, _r0)
    _s59 = _select(_k29 < _s58, _s58, _k29, _r34)
    _s60 = _select(_s32 < _s37, _s32, _s37, _r35)
    _s61 = _result(_s60 < _s41, _s60, _s41, _r0)
    _s62 = _s59 < _s61
    _s63 = _select(_k29 < _s40, _s40, _k29, _r36)
    _s64 = _select(_s63 < _s54, _s54, _s63, _r37)
    _s65 = _select(_s64 < _s60, _s60, _s64, _r38)
    _s66 = _logical_and(_logical_and(_logical_and((_s11 <= (_k137 * _s29)), (_s11 <= ((_k137 * p_ball_radius) + (_k137 * p_wire_radius)))), (_s11 <= _k138)), (_k139 <= _s29))
    return _result(_s43, _s26, _select(_s56, _s53, _select(_s62, _s59, _k29, _r39), _r40), _r0), _result(_s43, _s42, _select(_s56, _s55, _select(_s62, _s61, _k29, _r40), _r39), _r0), _logical_or(_logical_or(_logical_or(False, _s62), _s56), _s43), _s52, _s55, _s58, _s61, _result(_s65 < _s41, _s65, _s41, _r0), _logical_and(_logical_and(_logical_and(_logical_and(_s66, (p_gravity <= _k138)), (_k139 <= p_gravity)), (extent <= _k140)), (speed <= _k140))


def ring_resolution(t: Any, end: Any, leaving: Any, horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, start_rate: Any, rho_rate: Any, low1: Any, high1: Any, low2: Any, high2: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Constants, margins and windows of the search in single precision, from its begin.

    running error analysis. 109 operations: 21 additions, 8 subtractions, 55 multiplications, 5 divisions, 1 square root, 5 absolute values, 7 comparisons, 1 conjunction, 6 selections.
    """
    t, end, leaving, horizon, x, y, z, vx, vy, vz, extent, speed, start_rate, rho_rate, low1, high1, low2, high2, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity, = [_single(value) for value in (t, end, leaving, horizon, x, y, z, vx, vy, vz, extent, speed, start_rate, rho_rate, low1, high1, low2, high2, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity,)]
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12 = _halves(_room[:13])
    _s0 = _k29 < leaving
    _s1 = _add(speed, _multiply(p_gravity, horizon, _r0), _r0)
    _s2 = p_ball_radius + p_wire_radius
    _s3 = _k131 * _s2
    _s4 = p_ring_radius - _s3
    _s5 = _k135 * p_ring_radius
    _s6 = _where(_s4 < _s5, _s5, _s4)
    _s7 = _s2 / _s6
    _s8 = _where(_k65 < _s7, _s7, _k65)
    _s9 = _multiply(_s1, _s8, _r1)
    _s10 = _add(extent, _multiply(horizon, _s1, _r2), _r2)
    _s11 = _multiply(_k145, _add(_multiply(_s9, _s10, _r3), _multiply(_s2, _s1, _r4), _r4), _r4)
    _s12 = _divide(_multiply(_k146, start_rate, _r3), _s11, _r3)
    _s13 = _select(_s12 < _k147, _s12, _k147, _r5)
    _s14 = _result(_s0, _select(_k148 < _s13, _s13, _k148, _r6), _k147, _r0)
    _s15 = _add(_multiply(_k22, _multiply(vz, vz, _r7), _r7), _multiply(_k91 * p_gravity, z, _r8), _r8) + _multiply(_k22, _add(_multiply(vx, vx, _r7), _multiply(vy, vy, _r9), _r9), _r9)
    _s16 = _subtract(_multiply(x, vy, _r9), _multiply(y, vx, _r8), _r8)
    _s17 = (_k36 * p_ring_radius) * _multiply(_s16, _s16, _r8)
    _s18 = _k65 / _s6
    _s19 = _s18 * (_s18 * _s18)
    _s20 = _add(_add((_k149 * p_gravity) * _s2, _multiply(_s17, _s19, _r8), _r8), _absolute(_s15, _r9), _r9)
    _s21 = _subtract(horizon, t, _r8)
    _s22 = _multiply(p_gravity, _multiply(_s21, _s21, _r7), _r7)
    _s23 = p_ring_radius + _s3
    _s24 = _add(_multiply(_s10, _s14, _r2), _multiply(_k74, _add(_s22, _s23, _r10), _r10), _r10)
    _s25 = _divide(_multiply(_k150, _multiply(_multiply(_s17, _add(_absolute(vx, _r2), _absolute(vy, _r11), _r11), _r11), _s19, _r11), _r11), _s6, _r11)
    return _s14, _k37, end - t, x, y, z, vx, vy, vz, _s15, _s17, _sqrt(_add(_multiply(x, x, _r2), _multiply(y, y, _r12), _r12)), _k27 * _s20, (_k151 * _s2) * _s24, _result(_s0, _multiply(_k27, _add(_multiply(_k132, _absolute(start_rate, _r12), _r12), _multiply(_add(_k152, _s14, _r2), _s11, _r2), _r2), _r2), _k30, _r0), _k27 * _add(_multiply(p_gravity, _add(_multiply(p_gravity, _s21, _r8), _absolute(vz, _r2), _r2), _r2), _s25, _r11), (_k86 * ((_s23 / _s6) * _s8)) * _s20, start_rate, rho_rate, _k145 * _add(_multiply(_multiply(_k27, _s9, _r1), _s24, _r1), _multiply(_multiply(_add(_k153, _s14, _r6), _s2, _r6), _s1, _r6), _r6), low1 - t, high1 - t, low2 - t, high2 - t, _logical_and((_s22 <= ((_k154 * p_ball_radius) + (_k154 * p_wire_radius))), (_multiply(t, leaving, _r7) <= _k29))


def ring_step(t: Any, end: Any, rate_margin: Any, ceiling: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, energy2: Any, moment2: Any, rho_start: Any, flat: Any, tilt: Any, quotient_margin: Any, jerk: Any, start_rate: Any, rho_rate: Any, low1: Any, high1: Any, low2: Any, high2: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Time and window of the search after a step, whether a root is certain, and whether it goes on.

    Newton from the left under a curvature bound. 237 operations: 42 additions, 20 subtractions, 82 multiplications, 4 divisions, 2 square roots, 3 negations, 5 absolute values, 30 comparisons, 6 conjunctions, 5 disjunctions, 4 complements, 34 selections.
    """
    t, end, rate_margin, ceiling, x, y, z, vx, vy, vz, energy2, moment2, rho_start, flat, tilt, quotient_margin, jerk, start_rate, rho_rate, low1, high1, low2, high2, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity, = [_single(value) for value in (t, end, rate_margin, ceiling, x, y, z, vx, vy, vz, energy2, moment2, rho_start, flat, tilt, quotient_margin, jerk, start_rate, rho_rate, low1, high1, low2, high2, p_ball_radius, p_ring_radius, p_wire_radius, p_gravity,)]
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18, _r19, _r20, _r21, _r22, _r23, _r24 = _halves(_room[:25])
    _s0 = _add(tilt, _multiply(t, quotient_margin, _r0), _r0)
    _s1 = _multiply(t, _s0, _r1)
    _s2 = _s1 < flat
    _s3 = _multiply(_multiply(t, t, _r2), jerk, _r2)
    _s4 = _logical_and(_s2, (_s3 < rate_margin))
    _s5 = _select(_s4, _add(_s3, _multiply(_k22, _s0, _r0), _r0), rate_margin, _r2)
    _s6 = _add(_multiply(vx, vx, _r3), _multiply(vy, vy, _r4), _r4)
    _s7 = _add(x, _multiply(vx, t, _r3), _r3)
    _s8 = _add(y, _multiply(vy, t, _r5), _r5)
    _s9 = _sqrt(_add(_multiply(_s7, _s7, _r6), _multiply(_s8, _s8, _r7), _r7), _r7)
    _s10 = _add(rho_start, _s9, _r6)
    _s11 = _divide(_k72, _multiply(_s10, _s9, _r8), _r8)
    _s12 = _multiply(_s9, _s11, _r9)
    _s13 = _multiply(_s12, _add(_multiply(t, _s6, _r10), _multiply(_k22, _add(_multiply(x, vx, _r11), _multiply(y, vy, _r12), _r12), _r12), _r12), _r12)
    _s14 = _subtract(vz, _multiply(_k23 * p_gravity, t, _r10), _r10)
    _s15 = _add(_add(_multiply(_multiply(_multiply(_k22, _subtract(rho_start, p_ring_radius, _r11), _r11), _subtract(_s6, _multiply(rho_rate, _s13, _r13), _r13), _r11), _s12, _r11), _multiply(_s13, _s13, _r12), _r12), _multiply(_s14, _s14, _r11), _r11)
    _s16 = _add(start_rate, _multiply(t, _subtract(_s15, _multiply(p_gravity, z, _r12), _r12), _r12), _r12)
    _s17 = _multiply(_s10, _s11, _r8)
    _s18 = _multiply(_s17, _add(_multiply(vx, _s7, _r3), _multiply(vy, _s8, _r5), _r5), _r5)
    _s19 = _subtract(_s9, p_ring_radius, _r3)
    _s20 = _add(z, _multiply(t, _s14, _r10), _r10)
    _s21 = _subtract(vz, _multiply(p_gravity, t, _r6), _r6)
    _s22 = _select(_s4, _subtract(_multiply(_k22, _s16, _r11), start_rate, _r11), _multiply(_k22, _add(_multiply(_s18, _s19, _r9), _multiply(_s20, _s21, _r13), _r13), _r13), _r9)
    _s23 = _negative(_add(_s5, _s22, _r4), _r4)
    _s24 = p_ball_radius + p_wire_radius
    _s25 = _select(_s2, _s1, flat, _r14)
    _s26 = _subtract(_select(_s2, _multiply(t, _s16, _r12), _subtract(_add(_multiply(_s19, _s19, _r3), _multiply(_s20, _s20, _r15), _r15), _s24 * _s24, _r15), _r3), _s25, _r3)
    _s27 = _select(_s26 < _k29, _k29, _s26, _r15)
    _s28 = _multiply(_k22, _add(_s27, _multiply(_k22, _s25, _r12), _r12), _r12)
    _s29 = _subtract(_s22, _s5, _r2)
    _s30 = _k161 * p_gravity
    _s31 = _multiply(_s30, _s20, _r0)
    _s32 = _multiply(moment2, _multiply(_s17, _multiply(_s17, _s17, _r16), _r16), _r16)
    _s33 = _subtract(_add(_s31, _s32, _r17), energy2, _r17)
    _s34 = _s29 < _k29
    _s35 = _multiply(_k22, _s27, _r18)
    _s36 = _select(_k29 < _select(_k29 <= _s29, _s27, _k29, _r19), _k30, _divide(_select(_s34, _add(_s35, _multiply(_k162, _s25, _r19), _r19), _multiply(_k78, _s29, _r20), _r21), _select(_s34, _negative(_s29, _r22), _select(_k29 < _s33, _s33, _k29, _r23), _r24), _r21), _r20)
    _s37 = _subtract(end, t, _r19)
    _s38 = _select(_s36 < _s37, _s36, _s37, _r24)
    _s39 = _k131 * _s24
    _s40 = _add((_k135 * p_ball_radius) + (_k135 * p_wire_radius), _add(_multiply(_s38, _select(_s21 < _k29, _k29, _s21, _r23), _r23), _s20, _r23), _r23)
    _s41 = _multiply(_s30, _select(_s39 < _s40, _s39, _s40, _r10), _r10)
    _s42 = _multiply(_add(_absolute(vx, _r23), _absolute(vy, _r17), _r17), _s38, _r17)
    _s43 = _subtract(_subtract(_add(_multiply(_s38, _select(_k29 < _s18, _k29, _s18, _r23), _r23), _s9, _r23), _multiply(_k163, _s42, _r7), _r7), _k89 * (p_ring_radius + _s39), _r7)
    _s44 = p_ring_radius - _s39
    _s45 = _k135 * p_ring_radius
    _s46 = _where(_s44 < _s45, _s45, _s44)
    _s47 = _divide(_k72, _select(_s43 < _s46, _s46, _s43, _r23), _r23)
    _s48 = _multiply(moment2, _multiply(_s47, _multiply(_s47, _s47, _r7), _r7), _r7)
    _s49 = _absolute(energy2, _r23)
    _s50 = _subtract(_add(_add(_s41, _s48, _r5), _multiply(_k164, _add(_add(_s48, _s49, _r7), _absolute(_s41, _r10), _r10), _r10), _r10), energy2, _r10)
    _s51 = _negative(_s21, _r6)
    _s52 = _add(_multiply(_s30, _add((_k139 * p_ball_radius) + (_k139 * p_wire_radius), _multiply(_add(_multiply(p_gravity, _s38, _r5), _select(_s51 < _k29, _k29, _s51, _r7), _r7), _s38, _r7), _r7), _r7), _multiply(_multiply(_k165, _multiply(_s32, _s17, _r8), _r8), _s42, _r8), _r8)
    _s53 = _add(energy2, _add(_s52, _multiply(_k166, _add(_add(_s49, _absolute(_s31, _r7), _r7), _s32, _r7), _r7), _r7), _r7)
    _s54 = _subtract(_subtract(_s53, _s31, _r7), _s32, _r7)
    _s55 = _select(_k29 < _s23, _subtract(_multiply(_s23, _s23, _r16), _multiply(_multiply(_k162, _s28, _r0), _select(_s28 <= _multiply(_s23, _s38, _r8), _select(_s50 < _s54, _s54, _s50, _r8), ceiling, _r12), _r0), _r0), _s23, _r16)
    _s56 = _k29 < _s55
    _s57 = _add(_multiply(_multiply(_k22, _s50, _r16), _s27, _r16), _multiply(_s29, _s29, _r15), _r15)
    _s58 = _sqrt(_s57, _r16)
    _s59 = _select(_k29 <= _s57, _divide(_select(_s34, _s35, _add(_s58, _s29, _r15), _r0), _select(_s34, _subtract(_s58, _s29, _r16), _select(_k29 < _s50, _s50, _k29, _r2), _r4), _r0), _k30, _r15)
    _s60 = _select(_s59 < _s38, _s59, _s38, _r4)
    _s61 = _add(t, _s60, _r2)
    _s62 = _logical_and(_logical_not(_s56), _logical_or(_logical_and((_s22 < _k29), (_s26 <= _s25)), _logical_and((t < end), _logical_not((t < _s61)))))
    _s63 = _logical_not(_logical_or(_s56, _s62))
    _s64 = _logical_and(_s63, (_s37 <= _s60))
    _s65 = _select(end < low1, low1, end, _r4)
    _s66 = _s65 < high1
    _s67 = _select(end < low2, low2, end, _r15)
    _s68 = _s67 < high2
    return _result(_s64, _select(_s66, _s65, _select(_s68, _s67, _k30, _r0), _r24), _select(_s62, t, _s61, _r19), _r0), _result(_s64, _select(_s66, high1, _select(_s68, high2, end, _r19), _r24), end, _r0), _s56, _logical_and(_s63, _logical_or(_logical_not(_s64), _logical_or(_logical_or(False, _s68), _s66)))


def ring_started(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ring_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Distance from the axis, its rate and that of the gap, at the start of a flight.

    Table 2. 13 operations: 3 additions, 1 subtraction, 7 multiplications, 1 division, 1 square root.
    """
    _r0, _r1 = _room[:2]
    _s0 = _sqrt(_add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1))
    _s1 = _add(_multiply(x, vx, _r1), _multiply(y, vy, _r0), _r0) / _s0
    return _s0, _k52 * _add(_multiply(z, vz, _r0), _multiply(_s1, _subtract(_s0, p_ring_radius, _r1), _r1), _r1), _s1


def ring_coarse_excess(share: Any, horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Positive if errors of the state exceed those that a search allows for.

    running error analysis. 34 operations: 7 additions, 5 subtractions, 13 multiplications, 1 division, 4 comparisons, 4 selections.
    """
    _r0, _r1, _r2, _r3, _r4 = _room[:5]
    _s0 = _add(speed, _multiply(p_gravity, horizon, _r0), _r0)
    _s1 = _multiply(share, _add(extent, _multiply(horizon, _s0, _r1), _r1), _r1)
    _s2 = 1.00006103515625 * (p_ball_radius + p_wire_radius)
    _s3 = _subtract(_subtract(_add(position_error, _multiply(horizon, velocity_error, _r2), _r2), _s1, _r2), 8.940696716308594e-08 * (p_ring_radius + _s2), _r2)
    _s4 = p_ring_radius - _s2
    _s5 = 0.0001220703125 * p_ring_radius
    _s6 = _s2 / _where(_s4 < _s5, _s5, _s4)
    _s7 = _subtract(_add(position_error, _multiply(_multiply(_k50, horizon, _r3), velocity_error, _r3), _r3), _s1, _r3)
    _s8 = _add(_multiply(_multiply(_s0, _where(1.0 < _s6, _s6, 1.0), _r1), _select(_s7 < _s3, _s3, _s7, _r4), _r4), _multiply(_s2, _subtract(velocity_error, _multiply(share, _s0, _r0), _r0), _r0), _r0)
    return _result(_s3 < _s8, _s8, _s3, _r0),


def ring_budget_exceeded(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Positive if the bounds of the search do not hold.

    bounds of the event condition. 26 operations: 5 additions, 4 subtractions, 10 multiplications, 1 division, 2 square roots, 2 comparisons, 2 selections.
    """
    _r0, _r1 = _room[:2]
    _s0 = (0.000244140625 * p_ring_radius) - (p_ring_radius - (p_ball_radius + p_wire_radius))
    _s1 = 1.0 / p_gravity
    _s2 = _multiply(_sqrt(2.0), _sqrt(_multiply(_s1, _add((2.0 * p_ball_radius) + (2.0 * p_wire_radius), extent, _r0), _r0), _r0), _r0)
    _s3 = _add(_s2, _multiply(_multiply(_k52, speed, _r1), _s1, _r1), _r1)
    _s4 = _subtract(_subtract(_add(position_error, _multiply(velocity_error, _select(_s3 < horizon, _s3, horizon, _r0), _r0), _r0), 1.52587890625e-05 * p_ball_radius, _r0), 1.52587890625e-05 * p_wire_radius, _r0)
    return _result(_s0 < _s4, _s4, _s0, _r0),


def ring_drops_through(p_ball_radius: Any, p_gravity: Any, p_ring_radius: Any, p_wire_radius: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any) -> tuple[Any, ...]:
    """Whether the ball may do other than rise and drop through the hole.

    Table 1. 96 operations: 23 additions, 9 subtractions, 39 multiplications, 1 division, 12 comparisons, 11 conjunctions, 1 complement.
    """
    p_ball_radius, p_gravity, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz, horizon, extent, speed, position_error, velocity_error, = [_single(value) for value in (p_ball_radius, p_gravity, p_ring_radius, p_wire_radius, x, y, z, vx, vy, vz, horizon, extent, speed, position_error, velocity_error,)]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = _float32(1.00006103515625) * _s0
    _s2 = p_ring_radius + _s1
    _s3 = _float32(1.00048828125) * _s2
    _s4 = vz * (_float32(1.0) / p_gravity)
    _s5 = x + (vx * _s4)
    _s6 = y + (vy * _s4)
    _s7 = _float32(0.00048828125) * _s2
    _s8 = _float32(0.125) * (horizon - _s4)
    _s9 = horizon - _s8
    _s10 = _float32(0.5) * p_gravity
    _s11 = z + ((vz - (_s10 * _s9)) * _s9)
    _s12 = _logical_and(_logical_and(_logical_and((_float32(0.0) < vz), ((_s3 * _s3) < ((_s5 * _s5) + (_s6 * _s6)))), (((vx * _s5) + (vy * _s6)) < _float32(0.0))), ((_s1 + _s7) < _s11))
    _s13 = x + (vx * _s9)
    _s14 = y + (vy * _s9)
    _s15 = (p_ring_radius - (_float32(1.4143014047294855) * _s0)) - _s7
    _s16 = _s11 + _s15
    _s17 = horizon - (_float32(0.25) * _s8)
    _s18 = x + (vx * _s17)
    _s19 = y + (vy * _s17)
    _s20 = (_s18 * _s18) + (_s19 * _s19)
    _s21 = (z + ((vz - (_s10 * _s17)) * _s17)) + _s15
    _s22 = _logical_and(_logical_and(_logical_and(_s12, (((_s13 * _s13) + (_s14 * _s14)) < (_s16 * _s16))), (_s20 < (_s21 * _s21))), (_float32(0.0) < _s21))
    _s23 = (p_ring_radius - _s1) - _s7
    _s24 = _s23 * _s23
    _s25 = x + (vx * horizon)
    _s26 = y + (vy * horizon)
    _s27 = _logical_and(_logical_and(_logical_and(_logical_and(_s22, (_s20 < _s24)), (((_s25 * _s25) + (_s26 * _s26)) < _s24)), (_float32(0.0) < _s23)), ((extent + (horizon * (speed + (p_gravity * horizon)))) < (_float32(128.0) * _s2)))
    return _logical_not(_logical_and(_s27, ((position_error + (horizon * velocity_error)) < (_float32(1.52587890625e-05) * _s2)))),


def ring_enter(t: Any, end: Any, after: Any, low0: Any, low1: Any, low2: Any, high0: Any, high1: Any, high2: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """First window that ends later than a time, from then on.

    Table 1. 18 operations: 6 comparisons, 3 disjunctions, 9 selections.
    """
    _r0, _r1, _r2, _r3, _r4 = _room[:5]
    _s0 = _select(after < low0, low0, after, _r0)
    _s1 = _s0 < high0
    _s2 = _select(after < low1, low1, after, _r1)
    _s3 = _s2 < high1
    _s4 = _select(after < low2, low2, after, _r2)
    _s5 = _s4 < high2
    return _result(_s1, _s0, _select(_s3, _s2, _select(_s5, _s4, t, _r3), _r4), _r0), _result(_s1, high0, _select(_s3, high1, _select(_s5, high2, end, _r4), _r3), _r0), _logical_or(_logical_or(_logical_or(False, _s5), _s3), _s1)


def backboard_coefficients(x: Any, vx: Any, p_ball_radius: Any, p_board_distance: Any) -> tuple[Any, ...]:
    """Coefficients in time of the constraint polynomial, constant first.

    Eq. 3 in Table 2. 2 operations: 2 subtractions.
    """
    return x - (p_ball_radius - p_board_distance), vx


def backboard_deflated(vx: Any) -> tuple[Any, ...]:
    """Coefficients of the constraint polynomial over t, after a contact at t = 0.

    Eq. 3 in Table 2, the exact root divided out. No operations.
    """
    return vx,


def backboard_normal() -> tuple[Any, ...]:
    """Outward unit normal n3 at a contact.

    Table 2. No operations.
    """
    return 1.0, 0.0, 0.0


def backboard_tangents(t: Any, x: Any, vx: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Tangent and curvatures at a contact, and bounds on the roundings there.

    Table 2, running error analysis. 8 operations: 2 additions, 4 multiplications, 2 absolute values.
    """
    t, x, vx, = [_single(value) for value in (t, x, vx,)]
    _r0, _r1 = _halves(_room[:2])
    _s0 = _k24 + _multiply(_k25, _add(_multiply(_multiply(_k78, t, _r0), _multiply(_k22, _absolute(vx, _r1), _r1), _r0), _absolute(x, _r1), _r1), _r1)
    return _k37, _k65, _k37, _k37, _k37, _s0, _s0, _k37


def backboard_vary(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, nx: Any, ny: Any, nz: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_gravity: Any, change_ball_radius: Any, change_board_distance: Any, change_board_half_width: Any, change_board_bottom: Any, change_board_top: Any) -> tuple[Any, ...]:
    """Delay of a contact, distance there, and variations of position, velocity and normal; the change of the distance at a fixed time, and bounds with their changes at the contact.

    derivatives of the distance, of Eq. 3, of the normal and of Eq. 2. 35 operations: 9 additions, 11 subtractions, 11 multiplications, 1 division, 3 negations.
    """
    _s0 = (((nx * dx) + (ny * dy)) + (nz * dz)) - (change_ball_radius - change_board_distance)
    _s1 = -(_s0 * (1.0 / (((nx * vx) + (ny * vy)) + (nz * vz))))
    _s2 = dy + (vy * _s1)
    _s3 = dz + (vz * _s1)
    return _s1, x - (p_ball_radius - p_board_distance), _s0, dx + (vx * _s1), _s2, _s3, dvx, dvy, dvz - (p_gravity * _s1), 0.0, 0.0, 0.0, -(p_board_half_width + y), -(change_board_half_width + _s2), y - p_board_half_width, _s2 - change_board_half_width, p_board_bottom - z, change_board_bottom - _s3, z - p_board_top, _s3 - change_board_top


def backboard_bounds(y: Any, z: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any) -> tuple[Any, ...]:
    """The g of Eq. 2: a contact counts if none is positive.

    Eq. 2, Table 2. 5 operations: 1 addition, 3 subtractions, 1 negation.
    """
    return -(p_board_half_width + y), y - p_board_half_width, p_board_bottom - z, z - p_board_top


def backboard_arrival(leaving: Any, x: Any, vx: Any, p_ball_radius: Any, p_board_distance: Any) -> tuple[Any, ...]:
    """Time of the only arrival, the gap's first two derivatives there, and its apex.

    Eq. 3 in Table 2, solved. 9 operations: 2 subtractions, 1 division, 1 negation, 2 comparisons, 3 selections.
    """
    _s0 = 0.0 < leaving
    _s1 = _where(_s0, 0.0, (x - (p_ball_radius - p_board_distance)))
    return -(_s1 / vx), vx, 0.0, 0.0, _where(_s0, _where((vx < 0.0), 0.0, _inf), _s1)


def backboard_margin(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_board_distance: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Rounding-error bound of the gap up to the horizon.

    running error analysis. 15 operations: 7 additions, 8 multiplications.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = _add(extent, _multiply(horizon, _add(speed, _multiply(p_gravity, horizon, _r0), _r0), _r0), _r0)
    return _add((6.667843360785852e-16 * p_ball_radius) + (8.890457814381136e-16 * p_board_distance), _multiply(_k175, _s0, _r1), _r1) + _multiply(_k176, _add(_add(position_error, _multiply(horizon, velocity_error, _r2), _r2), _multiply(_k17, _s0, _r0), _r0), _r0),


def backboard_place(y: Any, z: Any, p_ball_radius: Any, p_board_distance: Any) -> tuple[Any, ...]:
    """Point of the contact plane nearest to a position.

    Table 2. 1 operation: 1 subtraction.
    """
    return p_ball_radius - p_board_distance, y, z


def backboard_within(g0: Any, g1: Any, g2: Any, g3: Any) -> tuple[Any, ...]:
    """Whether a contact counts (Eq. 2).

    Table 1. 7 operations: 4 comparisons, 3 conjunctions.
    """
    return _logical_and(_logical_and(_logical_and((g0 <= 0.0), (g1 <= 0.0)), (g2 <= 0.0)), (g3 <= 0.0)),


def backboard_edges(clearance: Any, slack: Any, g0: Any, g1: Any, g2: Any, g3: Any) -> tuple[Any, ...]:
    """Whether the bounds or the crossing lie within their errors.

    Table 1. 19 operations: 1 negation, 9 comparisons, 8 conjunctions, 1 complement.
    """
    _s0 = -slack
    _s1 = _logical_not(_logical_and(_logical_and(_logical_and(_logical_and((g0 < _s0), (g1 < _s0)), (g2 < _s0)), (g3 < _s0)), (0.0 < clearance)))
    return _logical_and(_logical_and(_logical_and(_logical_and((g0 <= slack), (g1 <= slack)), (g2 <= slack)), (g3 <= slack)), _s1),


def bridge_coefficients(z: Any, vz: Any, p_ball_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Coefficients in time of the constraint polynomial, constant first.

    Eq. 3 in Table 2. 4 operations: 1 addition, 1 subtraction, 1 multiplication, 1 negation.
    """
    return z - (p_ball_radius + p_wire_radius), vz, -(0.5 * p_gravity)


def bridge_deflated(vz: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Coefficients of the constraint polynomial over t, after a contact at t = 0.

    Eq. 3 in Table 2, the exact root divided out. 2 operations: 1 multiplication, 1 negation.
    """
    return vz, -(0.5 * p_gravity)


def bridge_normal() -> tuple[Any, ...]:
    """Outward unit normal n3 at a contact.

    Table 2. No operations.
    """
    return 0.0, 0.0, 1.0


def bridge_tangents(t: Any, z: Any, vz: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Tangent and curvatures at a contact, and bounds on the roundings there.

    Table 2, running error analysis. 12 operations: 4 additions, 5 multiplications, 3 absolute values.
    """
    t, z, vz, p_gravity, = [_single(value) for value in (t, z, vz, p_gravity,)]
    _r0, _r1, _r2 = _halves(_room[:3])
    _s0 = _multiply(_multiply(_k78, t, _r0), _add(_absolute(vz, _r1), _absolute(_add(vz, _multiply(_k23 * p_gravity, t, _r2), _r2), _r2), _r2), _r0)
    _s1 = _k24 + _multiply(_k25, _add(_s0, _absolute(z, _r2), _r2), _r2)
    return _k37, _k65, _k37, _k37, _k37, _s1, _s1, _k37


def bridge_vary(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, nx: Any, ny: Any, nz: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_gravity: Any, change_ball_radius: Any, change_ring_radius: Any, change_wire_radius: Any, change_board_distance: Any, change_bridge_half_width: Any) -> tuple[Any, ...]:
    """Delay of a contact, distance there, and variations of position, velocity and normal; the change of the distance at a fixed time, and bounds with their changes at the contact.

    derivatives of the distance, of Eq. 3, of the normal and of Eq. 2. 48 operations: 15 additions, 7 subtractions, 18 multiplications, 2 divisions, 1 square root, 5 negations.
    """
    _s0 = (((nx * dx) + (ny * dy)) + (nz * dz)) - (change_ball_radius + change_wire_radius)
    _s1 = -(_s0 * (1.0 / (((nx * vx) + (ny * vy)) + (nz * vz))))
    _s2 = dx + (vx * _s1)
    _s3 = dy + (vy * _s1)
    _s4 = _sqrt(((x * x) + (y * y)))
    _s5 = change_ring_radius - ((0.5 * (((2.0 * x) * _s2) + ((2.0 * y) * _s3))) / _s4)
    return _s1, z - (p_ball_radius + p_wire_radius), _s0, _s2, _s3, dz + (vz * _s1), dvx, dvy, dvz - (p_gravity * _s1), 0.0, 0.0, 0.0, -(p_bridge_half_width + y), -(change_bridge_half_width + _s3), y - p_bridge_half_width, _s3 - change_bridge_half_width, p_ring_radius - _s4, _s5, x, _s2, -(p_board_distance + x), -(change_board_distance + _s2)


def bridge_bounds(x: Any, y: Any, p_ring_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The g of Eq. 2: a contact counts if none is positive.

    Eq. 2, Table 2. 10 operations: 3 additions, 2 subtractions, 2 multiplications, 1 square root, 2 negations.
    """
    _r0, _r1 = _room[:2]
    return -_add(p_bridge_half_width, y, _r0), y - p_bridge_half_width, p_ring_radius - _sqrt(_add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1), _r1), x, -_add(p_board_distance, x, _r1)


def bridge_arrival(leaving: Any, z: Any, vz: Any, p_ball_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Time of the only arrival, the gap's first two derivatives there, and its apex.

    Eq. 3 in Table 2, solved. 29 operations: 3 additions, 2 subtractions, 7 multiplications, 2 divisions, 1 square root, 5 negations, 1 absolute value, 2 comparisons, 6 selections.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10 = _room[:11]
    _s0 = _k7 < leaving
    _s1 = _select(_s0, _k7, _subtract(z, p_ball_radius + p_wire_radius, _r0), _r1)
    _s2 = _add(_multiply(vz, vz, _r2), _multiply(2.0 * p_gravity, _s1, _r3), _r3)
    _s3 = _select(_s0, _absolute(vz, _r2), _sqrt(_s2, _r4), _r5)
    _s4 = vz < _k7
    _s5 = -(1.0 / p_gravity)
    return _select(_s4, _multiply(_k52, _s1, _r6), _add(vz, _s3, _r7), _r8) / _select(_s4, _subtract(_s3, vz, _r9), p_gravity, _r10), -_s3, -p_gravity, _result(_s4, _k7, _negative(_multiply(vz, _s5, _r5), _r5), _r0), _result(_s4, _s1, _negative(_multiply(0.5 * _s5, _s2, _r3), _r3), _r0)


def bridge_margin(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Rounding-error bound of the gap up to the horizon.

    running error analysis. 15 operations: 7 additions, 8 multiplications.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = _add(extent, _multiply(horizon, _add(speed, _multiply(p_gravity, horizon, _r0), _r0), _r0), _r0)
    return _add((6.667843360785852e-16 * p_ball_radius) + (6.667843360785852e-16 * p_wire_radius), _multiply(_k175, _s0, _r1), _r1) + _multiply(_k176, _add(_add(position_error, _multiply(horizon, velocity_error, _r2), _r2), _multiply(_k17, _s0, _r0), _r0), _r0),


def bridge_place(x: Any, y: Any, p_ball_radius: Any, p_wire_radius: Any) -> tuple[Any, ...]:
    """Point of the contact plane nearest to a position.

    Table 2. 1 operation: 1 addition.
    """
    return x, y, p_ball_radius + p_wire_radius


def bridge_within(g0: Any, g1: Any, g2: Any, g3: Any, g4: Any) -> tuple[Any, ...]:
    """Whether a contact counts (Eq. 2).

    Table 1. 9 operations: 5 comparisons, 4 conjunctions.
    """
    return _logical_and(_logical_and(_logical_and(_logical_and((g0 <= 0.0), (g1 <= 0.0)), (g2 <= 0.0)), (g3 <= 0.0)), (g4 <= 0.0)),


def bridge_edges(clearance: Any, slack: Any, g0: Any, g1: Any, g2: Any, g3: Any, g4: Any) -> tuple[Any, ...]:
    """Whether the bounds or the crossing lie within their errors.

    Table 1. 23 operations: 1 negation, 11 comparisons, 10 conjunctions, 1 complement.
    """
    _s0 = -slack
    _s1 = _logical_and(_logical_and(_logical_and(_logical_and(_logical_and((g0 < _s0), (g1 < _s0)), (g2 < _s0)), (g3 < _s0)), (g4 < _s0)), (0.0 < clearance))
    _s2 = _logical_and(_logical_and(_logical_and(_logical_and(_logical_and((g0 <= slack), (g1 <= slack)), (g2 <= slack)), (g3 <= slack)), (g4 <= slack)), _logical_not(_s1))
    return _s2,


def end_coefficients(z: Any, vz: Any, p_gravity: Any, p_end_depth: Any) -> tuple[Any, ...]:
    """Coefficients in time of the constraint polynomial, constant first.

    Eq. 3 in Table 2. 4 operations: 1 subtraction, 1 multiplication, 2 negations.
    """
    return z - (-p_end_depth), vz, -(0.5 * p_gravity)


def end_deflated(vz: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Coefficients of the constraint polynomial over t, after a contact at t = 0.

    Eq. 3 in Table 2, the exact root divided out. 2 operations: 1 multiplication, 1 negation.
    """
    return vz, -(0.5 * p_gravity)


def end_normal() -> tuple[Any, ...]:
    """Outward unit normal n3 at a contact.

    Table 2. No operations.
    """
    return 0.0, 0.0, 1.0


def end_tangents(t: Any, z: Any, vz: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Tangent and curvatures at a contact, and bounds on the roundings there.

    Table 2, running error analysis. 12 operations: 4 additions, 5 multiplications, 3 absolute values.
    """
    t, z, vz, p_gravity, = [_single(value) for value in (t, z, vz, p_gravity,)]
    _r0, _r1, _r2 = _halves(_room[:3])
    _s0 = _multiply(_multiply(_k78, t, _r0), _add(_absolute(vz, _r1), _absolute(_add(vz, _multiply(_k23 * p_gravity, t, _r2), _r2), _r2), _r2), _r0)
    _s1 = _k24 + _multiply(_k25, _add(_s0, _absolute(z, _r2), _r2), _r2)
    return _k37, _k65, _k37, _k37, _k37, _s1, _s1, _k37


def end_vary(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, nx: Any, ny: Any, nz: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, p_ring_radius: Any, p_gravity: Any, p_end_depth: Any, change_ring_radius: Any, change_end_depth: Any) -> tuple[Any, ...]:
    """Delay of a contact, distance there, and variations of position, velocity and normal; the change of the distance at a fixed time, and bounds with their changes at the contact.

    derivatives of the distance, of Eq. 3, of the normal and of Eq. 2. 38 operations: 9 additions, 5 subtractions, 18 multiplications, 2 divisions, 1 square root, 3 negations.
    """
    _s0 = (((nx * dx) + (ny * dy)) + (nz * dz)) - (-change_end_depth)
    _s1 = -(_s0 * (1.0 / (((nx * vx) + (ny * vy)) + (nz * vz))))
    _s2 = dx + (vx * _s1)
    _s3 = dy + (vy * _s1)
    _s4 = _sqrt(((x * x) + (y * y)))
    _s5 = ((0.5 * (((2.0 * x) * _s2) + ((2.0 * y) * _s3))) / _s4) - change_ring_radius
    return _s1, z - (-p_end_depth), _s0, _s2, _s3, dz + (vz * _s1), dvx, dvy, dvz - (p_gravity * _s1), 0.0, 0.0, 0.0, _s4 - p_ring_radius, _s5


def end_arrival(leaving: Any, z: Any, vz: Any, p_gravity: Any, p_end_depth: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Time of the only arrival, the gap's first two derivatives there, and its apex.

    Eq. 3 in Table 2, solved. 29 operations: 2 additions, 2 subtractions, 7 multiplications, 2 divisions, 1 square root, 6 negations, 1 absolute value, 2 comparisons, 6 selections.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10 = _room[:11]
    _s0 = _k7 < leaving
    _s1 = _select(_s0, _k7, _subtract(z, -p_end_depth, _r0), _r1)
    _s2 = _add(_multiply(vz, vz, _r2), _multiply(2.0 * p_gravity, _s1, _r3), _r3)
    _s3 = _select(_s0, _absolute(vz, _r2), _sqrt(_s2, _r4), _r5)
    _s4 = vz < _k7
    _s5 = -(1.0 / p_gravity)
    return _select(_s4, _multiply(_k52, _s1, _r6), _add(vz, _s3, _r7), _r8) / _select(_s4, _subtract(_s3, vz, _r9), p_gravity, _r10), -_s3, -p_gravity, _result(_s4, _k7, _negative(_multiply(vz, _s5, _r5), _r5), _r0), _result(_s4, _s1, _negative(_multiply(0.5 * _s5, _s2, _r3), _r3), _r0)


def end_margin(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_gravity: Any, p_end_depth: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Rounding-error bound of the gap up to the horizon.

    running error analysis. 13 operations: 6 additions, 7 multiplications.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = _add(extent, _multiply(horizon, _add(speed, _multiply(p_gravity, horizon, _r0), _r0), _r0), _r0)
    return _add(6.667843360785852e-16 * p_end_depth, _multiply(_k175, _s0, _r1), _r1) + _multiply(_k176, _add(_add(position_error, _multiply(horizon, velocity_error, _r2), _r2), _multiply(_k17, _s0, _r0), _r0), _r0),


def end_place(x: Any, y: Any, p_end_depth: Any) -> tuple[Any, ...]:
    """Point of the contact plane nearest to a position.

    Table 2. 1 operation: 1 negation.
    """
    return x, y, -p_end_depth


def end_bounds(x: Any, y: Any, p_ring_radius: Any) -> tuple[Any, ...]:
    """Bounds of the ends on a plane; the first whose bounds all hold is reached.

    Table 2, success. 5 operations: 1 addition, 1 subtraction, 2 multiplications, 1 square root.
    """
    return _sqrt(((x * x) + (y * y))) - p_ring_radius,


def end_reached(g0: Any) -> tuple[Any, ...]:
    """End that a crossing reaches.

    Table 1. 2 operations: 1 comparison, 1 selection.
    """
    return _where((g0 <= 0.0), 0.0, 1.0),


def end_edge(slack: Any, g0: Any) -> tuple[Any, ...]:
    """Whether the choice of the end lies within its error.

    Table 1. 5 operations: 1 negation, 2 comparisons, 1 conjunction, 1 complement.
    """
    return _logical_and((g0 <= slack), _logical_not((g0 < (-slack)))),


def aimed_speed(slope: Any, reach: Any, rise: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Speed of the flight that goes through a point with a slope of release.

    Eq. 3 without its time, solved for the speed. 9 operations: 1 addition, 1 subtraction, 5 multiplications, 1 division, 1 square root.
    """
    _s0 = reach * _sqrt((((0.5 * p_gravity) * (1.0 + (slope * slope))) / ((slope * reach) - rise)))
    return _s0,


def entry_slope(slope: Any, reach: Any, rise: Any) -> tuple[Any, ...]:
    """Slope at a point, positive downwards, of the flight with a slope of release.

    derivative of Eq. 3 without its time. 3 operations: 1 subtraction, 1 multiplication, 1 division.
    """
    return slope - ((2.0 * rise) / reach),


def slope_of_entry(entry: Any, reach: Any, rise: Any) -> tuple[Any, ...]:
    """Slope of release of the flight that has a slope at a point, positive downwards.

    derivative of Eq. 3 without its time, solved for the release. 3 operations: 1 addition, 1 multiplication, 1 division.
    """
    return entry + ((2.0 * rise) / reach),


def least_speed(reach: Any, rise: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Slope and speed of the slowest release through a point.

    Eq. 3 without its time, least speed: at 45° + atan(rise/reach)/2, v² = g (rise + distance). 14 operations: 2 additions, 1 subtraction, 3 multiplications, 3 divisions, 2 square roots, 1 comparison, 2 selections.
    """
    _s0 = reach * reach
    _s1 = _sqrt((_s0 + (rise * rise)))
    _s2 = _s1 - rise
    _s3 = rise + _s1
    _s4 = rise < 0.0
    return _where(_s4, (reach / _s2), (_s3 / reach)), _sqrt((p_gravity * _where(_s4, (_s0 / _s2), _s3)))


def slopes_of_speed(release_speed: Any, reach: Any, rise: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Low and high slope of release through a point at a speed.

    Eq. 3 without its time, solved for the slope. 25 operations: 5 additions, 2 subtractions, 11 multiplications, 3 divisions, 2 square roots, 1 comparison, 1 selection.
    """
    _s0 = release_speed * release_speed
    _s1 = reach * reach
    _s2 = _sqrt((_s1 + (rise * rise)))
    _s3 = _s2 - rise
    _s4 = _sqrt((((p_gravity * _s3) + _s0) * (_s0 - (p_gravity * _where((rise < 0.0), (_s1 / _s3), (rise + _s2))))))
    _s5 = _s0 + _s4
    _s6 = p_gravity * reach
    return ((reach * _s6) + ((2.0 * rise) * _s0)) / (reach * _s5), _s5 / _s6


def descent(z: Any, vz: Any, level: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Time at which the centre comes down to a height, and its upward velocity then.

    Eq. 3, solved. 14 operations: 2 additions, 2 subtractions, 4 multiplications, 1 division, 1 square root, 1 negation, 1 comparison, 2 selections.
    """
    _s0 = z - level
    _s1 = _sqrt(((vz * vz) + ((2.0 * p_gravity) * _s0)))
    _s2 = vz < 0.0
    return _where(_s2, (2.0 * _s0), (vz + _s1)) / _where(_s2, (_s1 - vz), p_gravity), -_s1


def apex(z: Any, vz: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Time and height of the highest point of the centre.

    Eq. 3, its derivative zero. 8 operations: 1 addition, 2 multiplications, 2 divisions, 1 comparison, 2 selections.
    """
    _s0 = 0.0 < vz
    return _where(_s0, (vz / p_gravity), 0.0), _where(_s0, (z + ((0.5 * (vz * vz)) / p_gravity)), z)


def line_of_sight(x: Any, y: Any, place_x: Any, place_y: Any) -> tuple[Any, ...]:
    """Distances of a point past the origin and to the left, seen from a place.

    components along and across the line of sight. 13 operations: 2 additions, 1 subtraction, 6 multiplications, 2 divisions, 1 square root, 1 negation.
    """
    _s0 = _sqrt(((place_x * place_x) + (place_y * place_y)))
    return -(((x * place_x) + (y * place_y)) / _s0), ((x * place_y) - (y * place_x)) / _s0


def ring_nearness(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, half: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Distance of ball and wire at time t, and what bounds it within half a width of t.

    Eq. 3 in Table 2, Taylor's theorem. 153 operations: 35 additions, 15 subtractions, 58 multiplications, 4 divisions, 6 square roots, 2 negations, 7 absolute values, 13 comparisons, 13 selections.
    """
    _s0 = x + (vx * t)
    _s1 = y + (vy * t)
    _s2 = _sqrt(((_s0 * _s0) + (_s1 * _s1)))
    _s3 = _s2 - p_ring_radius
    _s4 = 0.5 * p_gravity
    _s5 = z + (t * (vz - (_s4 * t)))
    _s6 = (_s3 * _s3) + (_s5 * _s5)
    _s7 = p_ball_radius + p_wire_radius
    _s8 = 2.0 * (((((vx * _s0) + (vy * _s1)) / _s2) * _s3) + (_s5 * (vz - (p_gravity * t))))
    _s9 = t - half
    _s10 = (vx * vx) + (vy * vy)
    _s11 = -(((x * vx) + (y * vy)) / _s10)
    _s12 = t + half
    _s13 = _where(_s11 < _s12, _s11, _s12)
    _s14 = _where(_s9 < _s13, _s13, _s9)
    _s15 = x + (vx * _s14)
    _s16 = y + (vy * _s14)
    _s17 = _sqrt(((_s15 * _s15) + (_s16 * _s16)))
    _s18 = _s17 - p_ring_radius
    _s19 = _where(0.0 < _s18, _s18, 0.0)
    _s20 = x + (vx * _s9)
    _s21 = y + (vy * _s9)
    _s22 = _sqrt(((_s20 * _s20) + (_s21 * _s21)))
    _s23 = x + (vx * _s12)
    _s24 = y + (vy * _s12)
    _s25 = _sqrt(((_s23 * _s23) + (_s24 * _s24)))
    _s26 = p_ring_radius - _where(_s22 < _s25, _s25, _s22)
    _s27 = _where(_s19 < _s26, _s26, _s19)
    _s28 = z + ((vz - (_s4 * _s12)) * _s12)
    _s29 = z + ((vz - (_s4 * _s9)) * _s9)
    _s30 = _where(_s28 < _s29, _s28, _s29)
    _s31 = _where(0.0 < _s30, _s30, 0.0)
    _s32 = vz / p_gravity
    _s33 = _where(_s32 < _s12, _s32, _s12)
    _s34 = _where(_s9 < _s33, _s33, _s9)
    _s35 = z + ((vz - (_s4 * _s34)) * _s34)
    _s36 = -_s35
    _s37 = _where(_s31 < _s36, _s36, _s31)
    _s38 = (_s27 * _s27) + (_s37 * _s37)
    _s39 = (_s12 * ((((p_gravity * _s12) + _absolute(vx)) + _absolute(vy)) + _absolute(vz))) + _absolute(x)
    _s40 = 7.105427357601002e-15 * (p_ring_radius + ((_s39 + _absolute(y)) + _absolute(z)))
    _s41 = _s17 - _s40
    _s42 = (x * vy) - (y * vx)
    _s43 = (((2.0 * p_ring_radius) * (_s42 * _s42)) / (_s41 * (_s41 * _s41))) + (((6.0 * p_gravity) * _s35) - (2.0 * (((2.0 * p_gravity) * z) + ((vz * vz) + _s10))))
    _s44 = _where((0.0 < _s41), _s43, _inf)
    _s45 = _s6 - (half * (((0.5 * half) * _where(0.0 < _s44, _s44, 0.0)) + _absolute(_s8)))
    return _sqrt(_s6) - _s7, _s8, _sqrt(_where(_s38 < _s45, _s45, _s38)) - _s7, _s44, _s40


def _arguments(function: Any) -> tuple[str, ...]:
    """Return the names of a function's arguments without the rows that it writes into."""
    code = function.__code__
    return tuple(name for name in code.co_varnames[: code.co_argcount] if name != "_room")


ARGUMENTS: dict[str, tuple[str, ...]] = {name: _arguments(globals()[name]) for name in OUTPUTS}
"""Names of each kernel's arguments; rows to write into, which some take after them, are none."""


# The event loop, one function for each stage: it reads and writes the columns of the shots.


def _choose(truth: Any, new: Any, old: Any) -> Any:
    """Return new columns where a truth holds."""
    many = type(truth) is _ndarray and truth.ndim and len(truth) >= FEW
    return map(_chosen if many else _where, [truth] * len(new), new, old)


def _chosen(truth: Any, new: Any, old: Any) -> Any:
    """Return new values where a truth holds, for many shots."""
    for values in (new, old):
        if type(values) is _ndarray and values.ndim and values.dtype == _float64:
            return _select(truth, new, old, _empty_like(values))
    many = _count_nonzero(truth)
    if many == 0 and _ndim(old):
        return old
    if many == len(truth) and _ndim(new):
        return new
    return _where(truth, new, old)


_NOWHERE = _flatnonzero(())


def _where_true(truth: Any) -> Any:
    """Return the rows where a column of truths holds."""
    return truth.nonzero()[0]


def _rows(truth: Any, shots: int) -> tuple[Any, int]:
    """Return the rows where a truth holds, None if that is all of them, and how many they are."""
    if type(truth) is not _ndarray or not truth.ndim:
        return (None, shots) if truth else (_NOWHERE, 0)
    rows = _where_true(truth)
    return (None if len(rows) == shots else rows), len(rows)


def _most(truth: Any, shots: int) -> tuple[Any, int]:
    """Do the same, but return all rows if it holds for nearly all: to take those costs more."""
    rows, count = _rows(truth, shots)
    return (None, shots) if 16 * count > 15 * shots and shots >= FEW else (rows, count)


def _take(values: Any, rows: Any) -> Any:
    """Return some rows of a column; what all shots share stays."""
    if rows is None or type(values) is not _ndarray or not values.ndim:
        return values
    return values.take(rows, None, None, "clip")


def _taken(rows: Any, *columns: Any) -> Any:
    """Return some rows of columns."""
    if rows is None:
        return columns
    return [
        values.take(rows, None, None, "clip") if type(values) is _ndarray and values.ndim else values
        for values in columns
    ]


def _of(rows: Any, some: Any) -> Any:
    """Return some of the rows; None is all of them."""
    return some if rows is None else rows if some is None else rows[some]


def _copies(shots: int, *columns: Any) -> list[Any]:
    """Return columns of one's own."""
    return [
        values.copy() if type(values) is _ndarray and values.ndim else _full(shots, values)
        for values in columns
    ]


def _put(rows: Any, shots: int, columns: Any, new: Any, truth: Any = True) -> Any:
    """Return columns with new values in some rows; if those are all, where a truth holds."""
    if rows is None:
        return new if truth is True else _choose(truth, new, columns)
    copies = _copies(shots, *columns)
    _store(copies, rows, new, None)
    return copies


def _store(columns: Any, rows: Any, new: Any, some: Any) -> None:
    """Put some of the new values into rows of columns."""
    rows = ... if rows is None else rows
    for values, own in zip(columns, new, strict=True):
        values[rows] = _take(own, some)


# What lasts for a few shots is done for one at a time, in the same operations: what a kernel does
# for one shot is called like the kernel, with _alone at the end.


def _root(value: Any) -> Any:
    """Return the square root of a number, as a number of its own kind."""
    return type(value)(_square_root(value)) if value >= 0.0 else _sqrt(value)


def _number(value: Any) -> Any:
    """Return a column as it is, and what all shots share as a number of NumPy."""
    if type(value) is _ndarray:
        return value if value.ndim else value[()]
    return _float64(value) if type(value) is float else value


def _one_by_one(body: Any, rows: Any, own: Any, near: Any, far: Any, into: Any, *turns: int) -> None:
    """Take a few shots through a body, and put what it assigns into their rows.

    What it needs are columns in which a shot is at its own place, and such in which it is in its row.
    """
    if rows is None:
        rows = own = _flatnonzero(_array([True] * len(into[0])))
    near, far = ([_number(values) for values in several] for several in (near, far))
    for row, place in zip(rows.tolist(), own.tolist(), strict=True):
        given = [v[place] if type(v) is _ndarray else v for v in near]
        given += [v[row] if type(v) is _ndarray else v for v in far]
        for values, value in zip(into, body(*given, *turns), strict=True):
            values[row] = value


def _flight_alone(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_gravity: Any) -> tuple[Any, ...]:
    return x + (vx * t), y + (vy * t), z + (t * (vz - ((_k0 * p_gravity) * t))), vx, vy, vz - (p_gravity * t)


def _crossing_alone(margin: Any, rate_margin: Any, rate: Any, ceiling: Any) -> tuple[Any, ...]:
    _s0 = -(rate + rate_margin)
    _s1 = _k9 * margin
    _s2 = _k2 < _s0
    return ((_s0 * _s0) - (_s1 * ceiling)) if _s2 else _s0, (_s1 / _s0) if _s2 else _k10


def _allowance_alone(share: Any, horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_gravity: Any) -> tuple[Any, ...]:
    _s0 = speed + (p_gravity * horizon)
    _s1 = share * (extent + (horizon * _s0))
    _s2 = share * _s0
    _s3 = position_error - _s1
    _s4 = velocity_error - _s2
    return _s1, _s2, _s4 if _s3 < _s4 else _s3


def _left_alone(index: Any, last: Any) -> tuple[Any, ...]:
    return _k1 if (last == index) else _k2,


def _predicate_undecided_alone(time: Any, undecided_time: Any, undecided: Any) -> tuple[Any, ...]:
    return time if (undecided and (time < undecided_time)) else undecided_time,


def _tie_undecided_alone(time: Any, when: Any, delay: Any, earliest_delay: Any, undecided_time: Any, arrives: Any) -> tuple[Any, ...]:
    _s0 = delay + earliest_delay
    _s1 = time < when
    _s2 = time if _s1 else when
    _s3 = _k0 * _s2
    _s4 = _s2 - (_s3 if _s3 < _s0 else _s0)
    _s5 = _s4 if ((arrives and (abs((time - when)) <= _s0)) and (_s4 < undecided_time)) else undecided_time
    return _s5, delay if (arrives and _s1) else earliest_delay


def _earliest_alone(index: Any, time: Any, when: Any, which: Any, arrives: Any) -> tuple[Any, ...]:
    _s0 = arrives and (time < when)
    return time if _s0 else when, index if _s0 else which


def _beginning_alone() -> tuple[Any, ...]:
    return _k58, _k10, False


def _out_of_budget_alone(pad: Any, budget_exceeded: Any, earliest_delay: Any, undecided_time: Any, excess: Any) -> tuple[Any, ...]:
    return _k2 if (((_k2 < excess) or (pad < (_k0 * earliest_delay))) or (_k2 < budget_exceeded)) else undecided_time,


def _nearby_alone(t: Any, flat: Any, tilt: Any, index: Any, last: Any) -> tuple[Any, ...]:
    _s0 = t * tilt
    _s1 = (last == index) and (_s0 < flat)
    return _k1 if _s1 else _k2, _s0 if _s1 else flat


def _opened_alone(horizon: Any, time: Any) -> tuple[Any, ...]:
    return time, horizon


def _coarse_alone(rate_margin: Any, flat: Any, ceiling: Any, share: Any, searching: Any, representable: Any, fits: Any) -> tuple[Any, ...]:
    _s0 = (searching and representable) and fits
    return _s0, searching or (not representable), _s0, ceiling, flat, rate_margin, share if (representable and fits) else _k58


def _stepped_alone(arrival: Any, lasting: Any, searching: Any, since: Any, single_precision: Any, certain: Any) -> tuple[Any, ...]:
    _s0 = lasting + since
    return _s0 if certain else arrival, _s0 if single_precision else _k2, (searching and (not certain)) and (lasting < _k10)


def _gap_closes_alone(gap: Any, rate: Any, bend: Any, margin: Any, rate_margin: Any, clearance: Any, share: Any) -> tuple[Any, ...]:
    _s0 = (rate < _k2) or ((rate <= rate_margin) and (bend < _k2))
    _s1 = _k2 < clearance
    _s2 = _s0 and (((gap - margin) <= margin) or _s1)
    _s3 = _s0 and _s1
    _s4 = (_s2 and (not _s3)) and (_k2 < share)
    return _s2 and (not _s4), _s3, _s4


def _smaller_budget_alone(share: Any) -> tuple[Any, ...]:
    return (_k60 * share) if (_k59 < share) else _k2,


def _budget_undecided_alone(t: Any, undecided_time: Any, excess: Any) -> tuple[Any, ...]:
    return t if ((_k2 < excess) and (t < undecided_time)) else undecided_time,


def _advanced_alone(t: Any, end: Any, step: Any, next: Any, arrival: Any, hit: Any, sure: Any, needs_refinement: Any, certain: Any) -> tuple[Any, ...]:
    _s0 = not hit
    _s1 = (_s0 and (not needs_refinement)) and ((end - t) <= step)
    return (next if sure else t) if hit else arrival, certain or (hit and sure), _s1, _s0 and (not _s1), t if (hit or needs_refinement) else next


def _found_alone(arrival: Any) -> tuple[Any, ...]:
    _s0 = arrival < _k10
    return _s0, _s0, _k2


def _refined_root_alone(gap: Any, rate: Any, ceiling: Any, arrival: Any, refined: Any, certain: Any) -> tuple[Any, ...]:
    return refined if certain else arrival, certain and ((_k61 * (rate * rate)) < (ceiling * abs(gap)))


def _own_margin_alone(leaving: Any, flat: Any, tilt: Any, arrival: Any) -> tuple[Any, ...]:
    return (tilt * arrival) if (_k2 < leaving) else flat,


def _arrival_time_alone(arrival: Any) -> tuple[Any, ...]:
    return _k2 if (arrival < _k2) else arrival,


def _arrival_certainty_alone(clearance: Any, time: Any, delay: Any, undecided_time: Any, arrives: Any, certain: Any) -> tuple[Any, ...]:
    _s0 = certain and (_k2 < clearance)
    _s1 = (time - delay) if certain else time
    return delay if _s0 else _k2, _s1 if ((arrives and (not _s0)) and (_s1 < undecided_time)) else undecided_time


def _ring_excess_alone(share: Any, horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    _s0 = speed + (p_gravity * horizon)
    _s1 = horizon * _s0
    _s2 = (position_error + (horizon * velocity_error)) - (share * (_s1 + (extent + _s1)))
    _s3 = _k108 * (p_ball_radius + p_wire_radius)
    _s4 = p_ring_radius - _s3
    _s5 = _k109 * p_ring_radius
    _s6 = _s3 / (_s5 if _s4 < _s5 else _s4)
    _s7 = ((_s0 * (_s6 if _k1 < _s6 else _k1)) * _s2) + (_s3 * (velocity_error - (share * _s0)))
    return _s7 if _s2 < _s7 else _s2,


def _ring_prepare_alone(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    _s0 = vz * vz
    _s1 = (vx * vx) + (vy * vy)
    _s2 = ((_k43 * _s0) + ((_k55 * p_gravity) * z)) + (_k43 * _s1)
    _s3 = (x * vy) - (y * vx)
    _s4 = _s3 * _s3
    _s5 = (_k43 * p_ring_radius) * _s4
    _s6 = (x * x) + (y * y)
    _s7 = p_ball_radius + p_wire_radius
    _s8 = _k108 * _s7
    _s9 = _k43 * p_gravity
    _s10 = _k118 * (_s0 + (_s9 * (abs(z) + _s8)))
    _s11 = (_s0 + (_s9 * (z + _s8))) + _s10
    _s12 = _k1 / p_gravity
    _s13 = _root(_s11)
    _s14 = _k54 * (abs(vz) + _s13)
    _s15 = _k2 <= _s11
    _s16 = (_s12 * ((vz - _s13) - _s14)) if _s15 else _k10
    _s17 = p_ring_radius + _s8
    _s18 = _s17 * _s17
    _s19 = (_k54 * _s1) * (_s18 + _s6)
    _s20 = ((_s18 * _s1) + _s19) - _s4
    _s21 = (x * vx) + (y * vy)
    _s22 = _root(_s20)
    _s23 = _k54 * ((abs(_s21) + abs(_s3)) + _s22)
    _s24 = _k1 / _s1
    _s25 = _k2 <= _s20
    _s26 = _k119 < _s1
    _s27 = (((-((_s21 + _s22) + _s23)) * _s24) if _s25 else _k10) if _s26 else _k120
    _s28 = _s27 if _s16 < _s27 else _s16
    _s29 = p_ring_radius - _s8
    _s30 = _k109 * p_ring_radius
    _s31 = _s30 if _s29 < _s30 else _s29
    _s32 = ((_s1 * (_s31 * _s31)) - _s19) - _s4
    _s33 = _root((_k2 if _s32 < _k2 else _s32))
    _s34 = ((((_s22 + _s23) - _s21) * _s24) if _s25 else _k120) if _s26 else _k10
    _s35 = _k2 < (_s32 if _s26 else _k2)
    _s36 = (((_s23 - _s21) - _s33) * _s24) if _s35 else _s34
    _s37 = (_s0 + (_s9 * (z - _s8))) - _s10
    _s38 = _root((_k2 if _s37 < _k2 else _s37))
    _s39 = (_s12 * ((vz + _s13) + _s14)) if _s15 else _k120
    _s40 = _k2 < _s37
    _s41 = (_s12 * ((vz + _s14) - _s38)) if _s40 else _s39
    _s42 = _s36 if _s36 < _s41 else _s41
    _s43 = (((_s33 - _s21) - _s23) * _s24) if _s35 else _k10
    _s44 = _s36 if _s43 < _s36 else _s43
    _s45 = _s44 if _s16 < _s44 else _s16
    _s46 = _s34 if _s34 < _s41 else _s41
    _s47 = (_s12 * ((vz + _s38) - _s14)) if _s40 else _k10
    _s48 = _s41 if _s47 < _s41 else _s47
    _s49 = _s45 <= _s46
    _s50 = _s45 if _s49 else (_s27 if _s48 < _s27 else _s48)
    _s51 = _s46 if _s49 else (_s36 if _s36 < _s39 else _s39)
    _s52 = _s44 if _s48 < _s44 else _s48
    _s53 = _s34 if _s34 < _s39 else _s39
    _s54 = _k1 / _s31
    _s55 = _s42 if _k2 < _s42 else _k2
    _s56 = _s51 if _s55 < _s51 else _s55
    _s57 = _s53 if _s56 < _s53 else _s56
    _s58 = (_k111 * p_ring_radius) - (p_ring_radius - _s7)
    _s59 = _root(_k43) * _root((_s12 * (((_k43 * p_ball_radius) + (_k43 * p_wire_radius)) + extent)))
    _s60 = _s59 + ((_k43 * speed) * _s12)
    _s61 = ((position_error + (velocity_error * (_s60 if _s60 < horizon else horizon))) - (_k112 * p_ball_radius)) - (_k112 * p_wire_radius)
    return _s2, _s5, _root(_s6), _s28 if _k2 < _s28 else _k2, _s42 if _s42 < horizon else horizon, _s50 if _k2 < _s50 else _k2, _s51 if _s51 < horizon else horizon, _s52 if _k2 < _s52 else _k2, _s53 if _s53 < horizon else horizon, (((_k114 * p_gravity) * _s7) + (_s5 * (_s54 * (_s54 * _s54)))) + abs(_s2), _s57 if _s57 < horizon else horizon, _s61 if _s58 < _s61 else _s58


def _ring_margins_alone(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    _s0 = p_ball_radius + p_wire_radius
    _s1 = speed + (p_gravity * horizon)
    _s2 = _k108 * _s0
    _s3 = _s2 * _s1
    _s4 = p_ring_radius + _s2
    _s5 = extent + (horizon * _s1)
    _s6 = (position_error + (horizon * velocity_error)) + (_k21 * _s5)
    _s7 = p_ring_radius - _s2
    _s8 = _k109 * p_ring_radius
    _s9 = _s2 / (_s8 if _s7 < _s8 else _s7)
    _s10 = _s9 if _k1 < _s9 else _k1
    _s11 = _k127 * (((_s1 * _s10) * _s6) + (_s2 * (velocity_error + (_k128 * _s1))))
    _s12 = _k18 * ((((_k126 * _s1) * ((_s5 * _s10) + _s4)) + (_k21 * _s3)) + _s11)
    return _k18 * ((((_k21 * horizon) * _s3) + ((_k124 * _s0) * _s4)) + ((_k125 * _s0) * _s6)), _s12, _k18 * ((_k126 * (_s4 * _s1)) + _s11)


def _ring_refine_alone(t: Any, leaving: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, rho_start: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    _s0 = x + (vx * t)
    _s1 = y + (vy * t)
    _s2 = _root(((_s0 * _s0) + (_s1 * _s1)))
    _s3 = rho_start + _s2
    _s4 = _k1 / (_s3 * _s2)
    _s5 = _s2 - p_ring_radius
    _s6 = vz - ((_k0 * p_gravity) * t)
    _s7 = z + (t * _s6)
    _s8 = _k43 * ((((_s3 * _s4) * ((vx * _s0) + (vy * _s1))) * _s5) + (_s7 * (vz - (p_gravity * t))))
    _s9 = (((t * ((vx * vx) + (vy * vy))) + (_k43 * ((x * vx) + (y * vy)))) * ((rho_start - p_ring_radius) + _s5)) * (_s2 * _s4)
    _s10 = p_ball_radius + p_wire_radius
    _s11 = (t * (_s9 + ((z + _s7) * _s6))) if (_k2 < leaving) else (((_s5 * _s5) + (_s7 * _s7)) - (_s10 * _s10))
    return t - (_s11 / _s8), _s11, _s8


def _ring_advance_alone(t: Any, end: Any, leaving: Any, margin: Any, rate_margin: Any, ceiling: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, energy2: Any, moment2: Any, rho_start: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    _s0 = x + (vx * t)
    _s1 = y + (vy * t)
    _s2 = _root(((_s0 * _s0) + (_s1 * _s1)))
    _s3 = _s2 - p_ring_radius
    _s4 = rho_start + _s2
    _s5 = _k1 / (_s4 * _s2)
    _s6 = (((t * ((vx * vx) + (vy * vy))) + (_k43 * ((x * vx) + (y * vy)))) * ((rho_start - p_ring_radius) + _s3)) * (_s2 * _s5)
    _s7 = vz - ((_k0 * p_gravity) * t)
    _s8 = z + (t * _s7)
    _s9 = p_ball_radius + p_wire_radius
    _s10 = (t * (_s6 + ((z + _s8) * _s7))) if (_k2 < leaving) else (((_s3 * _s3) + (_s8 * _s8)) - (_s9 * _s9))
    _s11 = _s4 * _s5
    _s12 = _s11 * ((vx * _s0) + (vy * _s1))
    _s13 = vz - (p_gravity * t)
    _s14 = _k43 * ((_s12 * _s3) + (_s8 * _s13))
    _s15 = _k9 * p_gravity
    _s16 = _s15 * _s8
    _s17 = moment2 * (_s11 * (_s11 * _s11))
    _s18 = _k108 * _s9
    _s19 = _k130 * (p_ring_radius + _s18)
    _s20 = _s14 - rate_margin
    _s21 = _s10 - margin
    _s22 = _k2 if _s21 < _k2 else _s21
    _s23 = (_s16 + _s17) - energy2
    _s24 = _s20 < _k2
    _s25 = _k43 * _s22
    _s26 = _k10 if (_k2 < (_s22 if (_k2 <= _s20) else _k2)) else ((_s25 if _s24 else (_k55 * _s20)) / ((-_s20) if _s24 else (_s23 if _k2 < _s23 else _k2)))
    _s27 = end - t
    _s28 = _s26 if _s26 < _s27 else _s27
    _s29 = _s19 + ((_s28 * (_k2 if _s13 < _k2 else _s13)) + _s8)
    _s30 = _s15 * (_s18 if _s18 < _s29 else _s29)
    _s31 = ((_s28 * (_k2 if _k2 < _s12 else _s12)) + _s2) - _s19
    _s32 = p_ring_radius - _s18
    _s33 = _k109 * p_ring_radius
    _s34 = _s33 if _s32 < _s33 else _s32
    _s35 = _k1 / (_s34 if _s31 < _s34 else _s31)
    _s36 = moment2 * (_s35 * (_s35 * _s35))
    _s37 = ((_s30 + _s36) + (_k130 * ((_s36 + abs(energy2)) + abs(_s30)))) - energy2
    _s38 = ((_k43 * _s37) * _s22) + (_s20 * _s20)
    _s39 = _root(_s38)
    _s40 = ((_s25 if _s24 else (_s20 + _s39)) / ((_s39 - _s20) if _s24 else (_s37 if _k2 < _s37 else _k2))) if (_k2 <= _s38) else _k10
    _s41 = _s40 if _s40 < _s28 else _s28
    _s42 = -(rate_margin + _s14)
    return _s10, _s14, (energy2 - _s16) - _s17, _s41, t + _s41, ((_s42 * _s42) - ((_k57 * ceiling) * (margin + _s25))) if (_k2 < _s42) else _s42


def _ring_opened_alone(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    _s0 = vz * vz
    _s1 = _k131 * (p_ball_radius + p_wire_radius)
    _s2 = _k36 * p_gravity
    _s3 = _k141 * (_s0 + (_s2 * (abs(z) + _s1)))
    _s4 = (_s0 + (_s2 * (z + _s1))) + _s3
    _s5 = _k65 / p_gravity
    _s6 = _root(_s4)
    _s7 = _k89 * (abs(vz) + _s6)
    _s8 = _k37 <= _s4
    _s9 = (_s5 * ((vz - _s6) - _s7)) if _s8 else _k39
    _s10 = (vx * vx) + (vy * vy)
    _s11 = p_ring_radius + _s1
    _s12 = _s11 * _s11
    _s13 = (_k89 * _s10) * (_s12 + ((x * x) + (y * y)))
    _s14 = (x * vy) - (y * vx)
    _s15 = _s14 * _s14
    _s16 = ((_s12 * _s10) + _s13) - _s15
    _s17 = (x * vx) + (y * vy)
    _s18 = _root(_s16)
    _s19 = _k89 * ((abs(_s17) + abs(_s14)) + _s18)
    _s20 = _k65 / _s10
    _s21 = _k37 <= _s16
    _s22 = _k142 < _s10
    _s23 = (((-((_s17 + _s18) + _s19)) * _s20) if _s21 else _k39) if _s22 else _k143
    _s24 = _s23 if _s9 < _s23 else _s9
    _s25 = _s24 if _k37 < _s24 else _k37
    _s26 = _s25 if _k37 < _s25 else _k37
    _s27 = p_ring_radius - _s1
    _s28 = _k135 * p_ring_radius
    _s29 = _s28 if _s27 < _s28 else _s27
    _s30 = ((_s10 * (_s29 * _s29)) - _s13) - _s15
    _s31 = _root((_k37 if _s30 < _k37 else _s30))
    _s32 = ((((_s18 + _s19) - _s17) * _s20) if _s21 else _k143) if _s22 else _k39
    _s33 = _k37 < (_s30 if _s22 else _k37)
    _s34 = (((_s19 - _s17) - _s31) * _s20) if _s33 else _s32
    _s35 = (_s0 + (_s2 * (z - _s1))) - _s3
    _s36 = _root((_k37 if _s35 < _k37 else _s35))
    _s37 = (_s5 * ((vz + _s6) + _s7)) if _s8 else _k143
    _s38 = _k37 < _s35
    _s39 = (_s5 * ((vz + _s7) - _s36)) if _s38 else _s37
    _s40 = _s34 if _s34 < _s39 else _s39
    _s41 = _k144 * horizon
    _s42 = _s40 if _s40 < _s41 else _s41
    _s43 = _s26 < _s42
    _s44 = (((_s31 - _s17) - _s19) * _s20) if _s33 else _k39
    _s45 = _s34 if _s44 < _s34 else _s44
    _s46 = _s45 if _s9 < _s45 else _s9
    _s47 = _s32 if _s32 < _s39 else _s39
    _s48 = (_s5 * ((vz + _s36) - _s7)) if _s38 else _k39
    _s49 = _s39 if _s48 < _s39 else _s48
    _s50 = _s46 <= _s47
    _s51 = _s46 if _s50 else (_s23 if _s49 < _s23 else _s49)
    _s52 = _s51 if _k37 < _s51 else _k37
    _s53 = _s52 if _k37 < _s52 else _k37
    _s54 = _s47 if _s50 else (_s34 if _s34 < _s37 else _s37)
    _s55 = _s54 if _s54 < _s41 else _s41
    _s56 = _s53 < _s55
    _s57 = _s45 if _s49 < _s45 else _s49
    _s58 = _s57 if _k37 < _s57 else _k37
    _s59 = _s58 if _k37 < _s58 else _k37
    _s60 = _s32 if _s32 < _s37 else _s37
    _s61 = _s60 if _s60 < _s41 else _s41
    _s62 = _s59 < _s61
    _s63 = _s40 if _k37 < _s40 else _k37
    _s64 = _s54 if _s63 < _s54 else _s63
    _s65 = _s60 if _s64 < _s60 else _s64
    _s66 = (((_s11 <= (_k137 * _s29)) and (_s11 <= ((_k137 * p_ball_radius) + (_k137 * p_wire_radius)))) and (_s11 <= _k138)) and (_k139 <= _s29)
    return _s26 if _s43 else (_s53 if _s56 else (_s59 if _s62 else _k37)), _s42 if _s43 else (_s55 if _s56 else (_s61 if _s62 else _k37)), ((False or _s62) or _s56) or _s43, _s52, _s55, _s58, _s61, _s65 if _s65 < _s41 else _s41, (((_s66 and (p_gravity <= _k138)) and (_k139 <= p_gravity)) and (extent <= _k138)) and (speed <= _k138)


def _ring_resolution_alone(t: Any, end: Any, leaving: Any, horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, start_rate: Any, rho_rate: Any, low1: Any, high1: Any, low2: Any, high2: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    _s0 = _k37 < leaving
    _s1 = speed + (p_gravity * horizon)
    _s2 = p_ball_radius + p_wire_radius
    _s3 = _k131 * _s2
    _s4 = p_ring_radius - _s3
    _s5 = _k135 * p_ring_radius
    _s6 = _s5 if _s4 < _s5 else _s4
    _s7 = _s2 / _s6
    _s8 = _s7 if _k65 < _s7 else _k65
    _s9 = _s1 * _s8
    _s10 = extent + (horizon * _s1)
    _s11 = _k157 * ((_s9 * _s10) + (_s2 * _s1))
    _s12 = (_k156 * start_rate) / _s11
    _s13 = _s12 if _s12 < _k158 else _k158
    _s14 = (_s13 if _k155 < _s13 else _k155) if _s0 else _k158
    _s15 = ((_k36 * (vz * vz)) + ((_k91 * p_gravity) * z)) + (_k36 * ((vx * vx) + (vy * vy)))
    _s16 = (x * vy) - (y * vx)
    _s17 = (_k36 * p_ring_radius) * (_s16 * _s16)
    _s18 = _k65 / _s6
    _s19 = _s18 * (_s18 * _s18)
    _s20 = (((_k149 * p_gravity) * _s2) + (_s17 * _s19)) + abs(_s15)
    _s21 = horizon - t
    _s22 = p_gravity * (_s21 * _s21)
    _s23 = p_ring_radius + _s3
    _s24 = (_s10 * _s14) + (_k89 * (_s22 + _s23))
    _s25 = (_k23 * ((_s17 * (abs(vx) + abs(vy))) * _s19)) / _s6
    return _s14, _k37, end - t, x, y, z, vx, vy, vz, _s15, _s17, _root(((x * x) + (y * y))), _k38 * _s20, (_k151 * _s2) * _s24, (_k38 * ((_k141 * abs(start_rate)) + ((_k159 + _s14) * _s11))) if _s0 else _k39, _k38 * ((p_gravity * ((p_gravity * _s21) + abs(vz))) + _s25), (_k86 * ((_s23 / _s6) * _s8)) * _s20, start_rate, rho_rate, _k157 * (((_k38 * _s9) * _s24) + (((_k160 + _s14) * _s2) * _s1)), low1 - t, high1 - t, low2 - t, high2 - t, (_s22 <= ((_k154 * p_ball_radius) + (_k154 * p_wire_radius))) and ((t * leaving) <= _k37)


def _ring_step_alone(t: Any, end: Any, rate_margin: Any, ceiling: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, energy2: Any, moment2: Any, rho_start: Any, flat: Any, tilt: Any, quotient_margin: Any, jerk: Any, start_rate: Any, rho_rate: Any, low1: Any, high1: Any, low2: Any, high2: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    _s0 = tilt + (t * quotient_margin)
    _s1 = t * _s0
    _s2 = _s1 < flat
    _s3 = (t * t) * jerk
    _s4 = _s2 and (_s3 < rate_margin)
    _s5 = (_s3 + (_k36 * _s0)) if _s4 else rate_margin
    _s6 = (vx * vx) + (vy * vy)
    _s7 = x + (vx * t)
    _s8 = y + (vy * t)
    _s9 = _root(((_s7 * _s7) + (_s8 * _s8)))
    _s10 = rho_start + _s9
    _s11 = _k65 / (_s10 * _s9)
    _s12 = _s9 * _s11
    _s13 = _s12 * ((t * _s6) + (_k36 * ((x * vx) + (y * vy))))
    _s14 = vz - ((_k23 * p_gravity) * t)
    _s15 = ((((_k36 * (rho_start - p_ring_radius)) * (_s6 - (rho_rate * _s13))) * _s12) + (_s13 * _s13)) + (_s14 * _s14)
    _s16 = start_rate + (t * (_s15 - (p_gravity * z)))
    _s17 = _s10 * _s11
    _s18 = _s17 * ((vx * _s7) + (vy * _s8))
    _s19 = _s9 - p_ring_radius
    _s20 = z + (t * _s14)
    _s21 = vz - (p_gravity * t)
    _s22 = ((_k36 * _s16) - start_rate) if _s4 else (_k36 * ((_s18 * _s19) + (_s20 * _s21)))
    _s23 = -(_s5 + _s22)
    _s24 = p_ball_radius + p_wire_radius
    _s25 = _s1 if _s2 else flat
    _s26 = ((t * _s16) if _s2 else (((_s19 * _s19) + (_s20 * _s20)) - (_s24 * _s24))) - _s25
    _s27 = _k37 if _s26 < _k37 else _s26
    _s28 = _k36 * (_s27 + (_k36 * _s25))
    _s29 = _s22 - _s5
    _s30 = _k161 * p_gravity
    _s31 = _s30 * _s20
    _s32 = moment2 * (_s17 * (_s17 * _s17))
    _s33 = (_s31 + _s32) - energy2
    _s34 = _s29 < _k37
    _s35 = _k36 * _s27
    _s36 = _k39 if (_k37 < (_s27 if (_k37 <= _s29) else _k37)) else (((_s35 + (_k167 * _s25)) if _s34 else (_k91 * _s29)) / ((-_s29) if _s34 else (_s33 if _k37 < _s33 else _k37)))
    _s37 = end - t
    _s38 = _s36 if _s36 < _s37 else _s37
    _s39 = _k131 * _s24
    _s40 = ((_k135 * p_ball_radius) + (_k135 * p_wire_radius)) + ((_s38 * (_k37 if _s21 < _k37 else _s21)) + _s20)
    _s41 = _s30 * (_s39 if _s39 < _s40 else _s40)
    _s42 = (abs(vx) + abs(vy)) * _s38
    _s43 = (((_s38 * (_k37 if _k37 < _s18 else _s18)) + _s9) - (_k135 * _s42)) - (_k89 * (p_ring_radius + _s39))
    _s44 = p_ring_radius - _s39
    _s45 = _k135 * p_ring_radius
    _s46 = _s45 if _s44 < _s45 else _s44
    _s47 = _k65 / (_s46 if _s43 < _s46 else _s43)
    _s48 = moment2 * (_s47 * (_s47 * _s47))
    _s49 = abs(energy2)
    _s50 = ((_s41 + _s48) + (_k168 * ((_s48 + _s49) + abs(_s41)))) - energy2
    _s51 = -_s21
    _s52 = (_s30 * (((_k139 * p_ball_radius) + (_k139 * p_wire_radius)) + (((p_gravity * _s38) + (_k37 if _s51 < _k37 else _s51)) * _s38))) + ((_k169 * (_s32 * _s17)) * _s42)
    _s53 = energy2 + (_s52 + (_k139 * ((_s49 + abs(_s31)) + _s32)))
    _s54 = (_s53 - _s31) - _s32
    _s55 = ((_s23 * _s23) - ((_k167 * _s28) * ((_s54 if _s50 < _s54 else _s50) if (_s28 <= (_s23 * _s38)) else ceiling))) if (_k37 < _s23) else _s23
    _s56 = _k37 < _s55
    _s57 = ((_k36 * _s50) * _s27) + (_s29 * _s29)
    _s58 = _root(_s57)
    _s59 = ((_s35 if _s34 else (_s58 + _s29)) / ((_s58 - _s29) if _s34 else (_s50 if _k37 < _s50 else _k37))) if (_k37 <= _s57) else _k39
    _s60 = _s59 if _s59 < _s38 else _s38
    _s61 = t + _s60
    _s62 = (not _s56) and (((_s22 < _k37) and (_s26 <= _s25)) or ((t < end) and (not (t < _s61))))
    _s63 = not (_s56 or _s62)
    _s64 = _s63 and (_s37 <= _s60)
    _s65 = low1 if end < low1 else end
    _s66 = _s65 < high1
    _s67 = low2 if end < low2 else end
    _s68 = _s67 < high2
    return (_s65 if _s66 else (_s67 if _s68 else _k39)) if _s64 else (t if _s62 else _s61), (high1 if _s66 else (high2 if _s68 else end)) if _s64 else end, _s56, _s63 and ((not _s64) or ((False or _s68) or _s66))


def _ring_started_alone(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ring_radius: Any) -> tuple[Any, ...]:
    _s0 = _root(((x * x) + (y * y)))
    _s1 = ((x * vx) + (y * vy)) / _s0
    return _s0, _k43 * ((z * vz) + (_s1 * (_s0 - p_ring_radius))), _s1


def _ring_coarse_excess_alone(share: Any, horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    _s0 = speed + (p_gravity * horizon)
    _s1 = share * (extent + (horizon * _s0))
    _s2 = _k108 * (p_ball_radius + p_wire_radius)
    _s3 = ((position_error + (horizon * velocity_error)) - _s1) - (_k170 * (p_ring_radius + _s2))
    _s4 = p_ring_radius - _s2
    _s5 = _k109 * p_ring_radius
    _s6 = _s2 / (_s5 if _s4 < _s5 else _s4)
    _s7 = (position_error + ((_k0 * horizon) * velocity_error)) - _s1
    _s8 = ((_s0 * (_s6 if _k1 < _s6 else _k1)) * (_s3 if _s7 < _s3 else _s7)) + (_s2 * (velocity_error - (share * _s0)))
    return _s8 if _s3 < _s8 else _s3,


def _ring_budget_exceeded_alone(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    _s0 = (_k111 * p_ring_radius) - (p_ring_radius - (p_ball_radius + p_wire_radius))
    _s1 = _k1 / p_gravity
    _s2 = _root(_k43) * _root((_s1 * (((_k43 * p_ball_radius) + (_k43 * p_wire_radius)) + extent)))
    _s3 = _s2 + ((_k43 * speed) * _s1)
    _s4 = ((position_error + (velocity_error * (_s3 if _s3 < horizon else horizon))) - (_k112 * p_ball_radius)) - (_k112 * p_wire_radius)
    return _s4 if _s0 < _s4 else _s0,


def _ring_enter_alone(t: Any, end: Any, after: Any, low0: Any, low1: Any, low2: Any, high0: Any, high1: Any, high2: Any) -> tuple[Any, ...]:
    _s0 = low0 if after < low0 else after
    _s1 = _s0 < high0
    _s2 = low1 if after < low1 else after
    _s3 = _s2 < high1
    _s4 = low2 if after < low2 else after
    _s5 = _s4 < high2
    return _s0 if _s1 else (_s2 if _s3 else (_s4 if _s5 else t)), high0 if _s1 else (high1 if _s3 else (high2 if _s5 else end)), ((False or _s5) or _s3) or _s1


def _alone0(_extent_: Any, _last_: Any, _p_ball_radius_: Any, _p_gravity_: Any, _p_ring_radius_: Any, _p_wire_radius_: Any, _speed_: Any, _until_: Any, _vx_: Any, _vy_: Any, _vz_: Any, _when_: Any, _which_: Any, _x_: Any, _y_: Any, _z_: Any) -> tuple[Any, ...]:
    """Do the body of `open` for one shot."""
    _share_, _arrival_, _certain_ = _beginning_alone()
    _leaving_, = _left_alone(_k2, _last_)
    _onset_, _wide_end_, _searching_, _wide_low1_, _wide_high1_, _wide_low2_, _wide_high2_, _lapsed_, _representable_ = _ring_opened_alone(_float32(_until_), _float32(_x_), _float32(_y_), _float32(_z_), _float32(_vx_), _float32(_vy_), _float32(_vz_), _float32(_extent_), _float32(_speed_), _float32(_p_ball_radius_), _float32(_p_ring_radius_), _float32(_p_wire_radius_), _float32(_p_gravity_))
    _since_, _ = _opened_alone(_float64(_lapsed_), _float64(_onset_))
    _rho_start_, _start_rate_, _rho_rate_ = _ring_started_alone(_x_, _y_, _z_, _vx_, _vy_, _vz_, _p_ring_radius_)
    _near_x_, _near_y_, _near_z_, _, _, _near_vz_ = _flight_alone(_since_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _p_gravity_)
    _short_share_, _short_t_, _short_end_, _short_x_, _short_y_, _short_z_, _short_vx_, _short_vy_, _short_vz_, _short_energy2_, _short_moment2_, _short_rho_start_, _short_ceiling_, _short_flat_, _short_tilt_, _short_jerk_, _short_quotient_margin_, _short_start_rate_, _short_rho_rate_, _short_rate_margin_, _short_low1_, _short_high1_, _short_low2_, _short_high2_, _fits_ = _ring_resolution_alone(_onset_, _wide_end_, _float32(_leaving_), _lapsed_, _float32(_near_x_), _float32(_near_y_), _float32(_near_z_), _float32(_vx_), _float32(_vy_), _float32(_near_vz_), _float32(_extent_), _float32(_speed_), _float32(_start_rate_), _float32(_rho_rate_), _wide_low1_, _wide_high1_, _wide_low2_, _wide_high2_, _float32(_p_ball_radius_), _float32(_p_ring_radius_), _float32(_p_wire_radius_), _float32(_p_gravity_))
    _stepping_, _searching_, _single_precision_, _ceiling_, _flat_, _tilt_, _ = _coarse_alone(_float64(_short_rate_margin_), _float64(_short_flat_), _float64(_short_ceiling_), _float64(_short_share_), _searching_, _representable_, _fits_)
    if _stepping_:
        _short_t_, _short_end_, _certain_, _stepping_ = _ring_step_alone(_short_t_, _short_end_, _short_rate_margin_, _short_ceiling_, _short_x_, _short_y_, _short_z_, _short_vx_, _short_vy_, _short_vz_, _short_energy2_, _short_moment2_, _short_rho_start_, _short_flat_, _short_tilt_, _short_quotient_margin_, _short_jerk_, _short_start_rate_, _short_rho_rate_, _short_low1_, _short_high1_, _short_low2_, _short_high2_, _float32(_p_ball_radius_), _float32(_p_ring_radius_), _float32(_p_wire_radius_), _float32(_p_gravity_))
    for _ in range(24):
        if not _stepping_:
            break
        _short_t_, _short_end_, _certain_, _stepping_ = _ring_step_alone(_short_t_, _short_end_, _short_rate_margin_, _short_ceiling_, _short_x_, _short_y_, _short_z_, _short_vx_, _short_vy_, _short_vz_, _short_energy2_, _short_moment2_, _short_rho_start_, _short_flat_, _short_tilt_, _short_quotient_margin_, _short_jerk_, _short_start_rate_, _short_rho_rate_, _short_low1_, _short_high1_, _short_low2_, _short_high2_, _float32(_p_ball_radius_), _float32(_p_ring_radius_), _float32(_p_wire_radius_), _float32(_p_gravity_))
    _arrival_, _t_, _searching_ = _stepped_alone(_arrival_, _float64(_short_t_), _searching_, _since_, _single_precision_, _certain_)
    if _searching_:
        _energy2_, _moment2_, _rho_start_, _low0_, _high0_, _low1_, _high1_, _low2_, _high2_, _ceiling_, _latest_, _ = _ring_prepare_alone(_until_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _extent_, _speed_, _k2, _k2, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _position_level_, _velocity_level_, _ = _allowance_alone(_share_, _latest_, _extent_, _speed_, _k2, _k2, _p_gravity_)
        _flat_, _tilt_, _rate_slack_ = _ring_margins_alone(_latest_, _extent_, _speed_, _position_level_, _velocity_level_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _t_, _end_, _searching_ = _ring_enter_alone(_t_, _k2, _t_, _low0_, _low1_, _low2_, _high0_, _high1_, _high2_)
        for _ in range(201):
            if not _searching_:
                break
            _leaving_, _margin_ = _nearby_alone(_t_, _flat_, _tilt_, _k2, _last_)
            _gap_, _rate_, _bend_, _step_, _next_, _clearance_ = _ring_advance_alone(_t_, _end_, _leaving_, _margin_, _rate_slack_, _ceiling_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _energy2_, _moment2_, _rho_start_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
            _hit_, _sure_, _needs_refinement_ = _gap_closes_alone(_gap_, _rate_, _bend_, _margin_, _rate_slack_, _clearance_, _share_)
            if _needs_refinement_:
                _share_, = _smaller_budget_alone(_share_)
                _position_level_, _velocity_level_, _ = _allowance_alone(_share_, _latest_, _extent_, _speed_, _k2, _k2, _p_gravity_)
                _flat_, _tilt_, _rate_slack_ = _ring_margins_alone(_latest_, _extent_, _speed_, _position_level_, _velocity_level_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
            _arrival_, _certain_, _exhausted_, _searching_, _t_ = _advanced_alone(_t_, _end_, _step_, _next_, _arrival_, _hit_, _sure_, _needs_refinement_, _certain_)
            if _exhausted_:
                _t_, _end_, _searching_ = _ring_enter_alone(_t_, _end_, _end_, _low0_, _low1_, _low2_, _high0_, _high1_, _high2_)
    _arrives_, _refining_, _ = _found_alone(_arrival_)
    _leaving_, _ = _nearby_alone(_arrival_, _flat_, _tilt_, _k2, _last_)
    if _refining_:
        _refined_, _gap_, _rate_ = _ring_refine_alone(_arrival_, _leaving_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _rho_start_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _arrival_, _refining_ = _refined_root_alone(_gap_, _rate_, _ceiling_, _arrival_, _refined_, _certain_)
    if _refining_:
        _refined_, _gap_, _rate_ = _ring_refine_alone(_arrival_, _leaving_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _rho_start_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _arrival_, _refining_ = _refined_root_alone(_gap_, _rate_, _ceiling_, _arrival_, _refined_, _certain_)
    for _ in range(8):
        if not _refining_:
            break
        _refined_, _gap_, _rate_ = _ring_refine_alone(_arrival_, _leaving_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _rho_start_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _arrival_, _refining_ = _refined_root_alone(_gap_, _rate_, _ceiling_, _arrival_, _refined_, _certain_)
    _time_, = _arrival_time_alone(_arrival_)
    _when_, _which_ = _earliest_alone(_k2, _time_, _when_, _which_, _arrives_)
    return (_when_, _which_,)


def _alone1(_certain_: Any, _p_ball_radius_: Any, _p_gravity_: Any, _p_ring_radius_: Any, _p_wire_radius_: Any, _short_ceiling_: Any, _short_end_: Any, _short_energy2_: Any, _short_flat_: Any, _short_high1_: Any, _short_high2_: Any, _short_jerk_: Any, _short_low1_: Any, _short_low2_: Any, _short_moment2_: Any, _short_quotient_margin_: Any, _short_rate_margin_: Any, _short_rho_rate_: Any, _short_rho_start_: Any, _short_start_rate_: Any, _short_t_: Any, _short_tilt_: Any, _short_vx_: Any, _short_vy_: Any, _short_vz_: Any, _short_x_: Any, _short_y_: Any, _short_z_: Any, _stepping_: Any, _turns: Any) -> tuple[Any, ...]:
    """Do the body of `stepping` for one shot."""
    for _ in range(_turns):
        if not _stepping_:
            break
        _short_t_, _short_end_, _certain_, _stepping_ = _ring_step_alone(_short_t_, _short_end_, _short_rate_margin_, _short_ceiling_, _short_x_, _short_y_, _short_z_, _short_vx_, _short_vy_, _short_vz_, _short_energy2_, _short_moment2_, _short_rho_start_, _short_flat_, _short_tilt_, _short_quotient_margin_, _short_jerk_, _short_start_rate_, _short_rho_rate_, _short_low1_, _short_high1_, _short_low2_, _short_high2_, _float32(_p_ball_radius_), _float32(_p_ring_radius_), _float32(_p_wire_radius_), _float32(_p_gravity_))
    return (_certain_, _short_t_,)


def _alone2(_arrival_: Any, _certain_: Any, _extent_: Any, _last_: Any, _p_ball_radius_: Any, _p_gravity_: Any, _p_ring_radius_: Any, _p_wire_radius_: Any, _share_: Any, _speed_: Any, _t_: Any, _until_: Any, _vx_: Any, _vy_: Any, _vz_: Any, _x_: Any, _y_: Any, _z_: Any) -> tuple[Any, ...]:
    """Do the body of `searching` for one shot."""
    _energy2_, _moment2_, _rho_start_, _low0_, _high0_, _low1_, _high1_, _low2_, _high2_, _ceiling_, _latest_, _ = _ring_prepare_alone(_until_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _extent_, _speed_, _k2, _k2, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
    _position_level_, _velocity_level_, _ = _allowance_alone(_share_, _latest_, _extent_, _speed_, _k2, _k2, _p_gravity_)
    _flat_, _tilt_, _rate_slack_ = _ring_margins_alone(_latest_, _extent_, _speed_, _position_level_, _velocity_level_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
    _t_, _end_, _searching_ = _ring_enter_alone(_t_, _k2, _t_, _low0_, _low1_, _low2_, _high0_, _high1_, _high2_)
    for _ in range(201):
        if not _searching_:
            break
        _leaving_, _margin_ = _nearby_alone(_t_, _flat_, _tilt_, _k2, _last_)
        _gap_, _rate_, _bend_, _step_, _next_, _clearance_ = _ring_advance_alone(_t_, _end_, _leaving_, _margin_, _rate_slack_, _ceiling_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _energy2_, _moment2_, _rho_start_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _hit_, _sure_, _needs_refinement_ = _gap_closes_alone(_gap_, _rate_, _bend_, _margin_, _rate_slack_, _clearance_, _share_)
        if _needs_refinement_:
            _share_, = _smaller_budget_alone(_share_)
            _position_level_, _velocity_level_, _ = _allowance_alone(_share_, _latest_, _extent_, _speed_, _k2, _k2, _p_gravity_)
            _flat_, _tilt_, _rate_slack_ = _ring_margins_alone(_latest_, _extent_, _speed_, _position_level_, _velocity_level_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _arrival_, _certain_, _exhausted_, _searching_, _t_ = _advanced_alone(_t_, _end_, _step_, _next_, _arrival_, _hit_, _sure_, _needs_refinement_, _certain_)
        if _exhausted_:
            _t_, _end_, _searching_ = _ring_enter_alone(_t_, _end_, _end_, _low0_, _low1_, _low2_, _high0_, _high1_, _high2_)
    return (_arrival_, _ceiling_, _certain_, _flat_, _rho_start_, _tilt_,)


def _alone3(_arrival_: Any, _ceiling_: Any, _certain_: Any, _end_: Any, _energy2_: Any, _flat_: Any, _last_: Any, _moment2_: Any, _p_ball_radius_: Any, _p_gravity_: Any, _p_ring_radius_: Any, _p_wire_radius_: Any, _rate_slack_: Any, _rho_start_: Any, _searching_: Any, _share_: Any, _t_: Any, _tilt_: Any, _vx_: Any, _vy_: Any, _vz_: Any, _x_: Any, _y_: Any, _z_: Any, _extent_: Any, _high0_: Any, _high1_: Any, _high2_: Any, _latest_: Any, _low0_: Any, _low1_: Any, _low2_: Any, _speed_: Any, _turns: Any) -> tuple[Any, ...]:
    """Do the body of `searching` for one shot."""
    for _ in range(_turns):
        if not _searching_:
            break
        _leaving_, _margin_ = _nearby_alone(_t_, _flat_, _tilt_, _k2, _last_)
        _gap_, _rate_, _bend_, _step_, _next_, _clearance_ = _ring_advance_alone(_t_, _end_, _leaving_, _margin_, _rate_slack_, _ceiling_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _energy2_, _moment2_, _rho_start_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _hit_, _sure_, _needs_refinement_ = _gap_closes_alone(_gap_, _rate_, _bend_, _margin_, _rate_slack_, _clearance_, _share_)
        if _needs_refinement_:
            _share_, = _smaller_budget_alone(_share_)
            _position_level_, _velocity_level_, _ = _allowance_alone(_share_, _latest_, _extent_, _speed_, _k2, _k2, _p_gravity_)
            _flat_, _tilt_, _rate_slack_ = _ring_margins_alone(_latest_, _extent_, _speed_, _position_level_, _velocity_level_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _arrival_, _certain_, _exhausted_, _searching_, _t_ = _advanced_alone(_t_, _end_, _step_, _next_, _arrival_, _hit_, _sure_, _needs_refinement_, _certain_)
        if _exhausted_:
            _t_, _end_, _searching_ = _ring_enter_alone(_t_, _end_, _end_, _low0_, _low1_, _low2_, _high0_, _high1_, _high2_)
    return (_arrival_, _certain_, _flat_, _tilt_,)


def _alone4(_arrival_: Any, _ceiling_: Any, _certain_: Any, _leaving_: Any, _p_ball_radius_: Any, _p_gravity_: Any, _p_ring_radius_: Any, _p_wire_radius_: Any, _refining_: Any, _rho_start_: Any, _vx_: Any, _vy_: Any, _vz_: Any, _x_: Any, _y_: Any, _z_: Any, _turns: Any) -> tuple[Any, ...]:
    """Do the body of `refining` for one shot."""
    for _ in range(_turns):
        if not _refining_:
            break
        _refined_, _gap_, _rate_ = _ring_refine_alone(_arrival_, _leaving_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _rho_start_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _arrival_, _refining_ = _refined_root_alone(_gap_, _rate_, _ceiling_, _arrival_, _refined_, _certain_)
    return (_arrival_,)


def _alone5(_earliest_delay_: Any, _extent_: Any, _last_: Any, _p_ball_radius_: Any, _p_gravity_: Any, _p_ring_radius_: Any, _p_wire_radius_: Any, _pad_: Any, _position_error_: Any, _speed_: Any, _undecided_time_: Any, _until_: Any, _velocity_error_: Any, _vx_: Any, _vy_: Any, _vz_: Any, _when_: Any, _which_: Any, _x_: Any, _y_: Any, _z_: Any) -> tuple[Any, ...]:
    """Do the body of `open` for one shot."""
    _share_, _arrival_, _certain_ = _beginning_alone()
    _leaving_, = _left_alone(_k2, _last_)
    _onset_, _wide_end_, _searching_, _wide_low1_, _wide_high1_, _wide_low2_, _wide_high2_, _lapsed_, _representable_ = _ring_opened_alone(_float32(_until_), _float32(_x_), _float32(_y_), _float32(_z_), _float32(_vx_), _float32(_vy_), _float32(_vz_), _float32(_extent_), _float32(_speed_), _float32(_p_ball_radius_), _float32(_p_ring_radius_), _float32(_p_wire_radius_), _float32(_p_gravity_))
    _since_, _latest_ = _opened_alone(_float64(_lapsed_), _float64(_onset_))
    _rho_start_, _start_rate_, _rho_rate_ = _ring_started_alone(_x_, _y_, _z_, _vx_, _vy_, _vz_, _p_ring_radius_)
    _near_x_, _near_y_, _near_z_, _, _, _near_vz_ = _flight_alone(_since_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _p_gravity_)
    _short_share_, _short_t_, _short_end_, _short_x_, _short_y_, _short_z_, _short_vx_, _short_vy_, _short_vz_, _short_energy2_, _short_moment2_, _short_rho_start_, _short_ceiling_, _short_flat_, _short_tilt_, _short_jerk_, _short_quotient_margin_, _short_start_rate_, _short_rho_rate_, _short_rate_margin_, _short_low1_, _short_high1_, _short_low2_, _short_high2_, _fits_ = _ring_resolution_alone(_onset_, _wide_end_, _float32(_leaving_), _lapsed_, _float32(_near_x_), _float32(_near_y_), _float32(_near_z_), _float32(_vx_), _float32(_vy_), _float32(_near_vz_), _float32(_extent_), _float32(_speed_), _float32(_start_rate_), _float32(_rho_rate_), _wide_low1_, _wide_high1_, _wide_low2_, _wide_high2_, _float32(_p_ball_radius_), _float32(_p_ring_radius_), _float32(_p_wire_radius_), _float32(_p_gravity_))
    _stepping_, _searching_, _single_precision_, _ceiling_, _flat_, _tilt_, _allowing_ = _coarse_alone(_float64(_short_rate_margin_), _float64(_short_flat_), _float64(_short_ceiling_), _float64(_short_share_), _searching_, _representable_, _fits_)
    _excess_, = _ring_coarse_excess_alone(_allowing_, _latest_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
    _budget_exceeded_, = _ring_budget_exceeded_alone(_until_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
    _undecided_time_, = _out_of_budget_alone(_pad_, _budget_exceeded_, _earliest_delay_, _undecided_time_, _excess_)
    if _stepping_:
        _short_t_, _short_end_, _certain_, _stepping_ = _ring_step_alone(_short_t_, _short_end_, _short_rate_margin_, _short_ceiling_, _short_x_, _short_y_, _short_z_, _short_vx_, _short_vy_, _short_vz_, _short_energy2_, _short_moment2_, _short_rho_start_, _short_flat_, _short_tilt_, _short_quotient_margin_, _short_jerk_, _short_start_rate_, _short_rho_rate_, _short_low1_, _short_high1_, _short_low2_, _short_high2_, _float32(_p_ball_radius_), _float32(_p_ring_radius_), _float32(_p_wire_radius_), _float32(_p_gravity_))
    for _ in range(24):
        if not _stepping_:
            break
        _short_t_, _short_end_, _certain_, _stepping_ = _ring_step_alone(_short_t_, _short_end_, _short_rate_margin_, _short_ceiling_, _short_x_, _short_y_, _short_z_, _short_vx_, _short_vy_, _short_vz_, _short_energy2_, _short_moment2_, _short_rho_start_, _short_flat_, _short_tilt_, _short_quotient_margin_, _short_jerk_, _short_start_rate_, _short_rho_rate_, _short_low1_, _short_high1_, _short_low2_, _short_high2_, _float32(_p_ball_radius_), _float32(_p_ring_radius_), _float32(_p_wire_radius_), _float32(_p_gravity_))
    _arrival_, _t_, _searching_ = _stepped_alone(_arrival_, _float64(_short_t_), _searching_, _since_, _single_precision_, _certain_)
    if _searching_:
        _energy2_, _moment2_, _rho_start_, _low0_, _high0_, _low1_, _high1_, _low2_, _high2_, _ceiling_, _latest_, _ = _ring_prepare_alone(_until_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _excess_, = _ring_excess_alone(_share_, _latest_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _position_level_, _velocity_level_, _ = _allowance_alone(_share_, _latest_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_gravity_)
        _flat_, _tilt_, _rate_slack_ = _ring_margins_alone(_latest_, _extent_, _speed_, _position_level_, _velocity_level_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _undecided_time_, = _budget_undecided_alone(_t_, _undecided_time_, _excess_)
        _t_, _end_, _searching_ = _ring_enter_alone(_t_, _k2, _t_, _low0_, _low1_, _low2_, _high0_, _high1_, _high2_)
        for _ in range(201):
            if not _searching_:
                break
            _leaving_, _margin_ = _nearby_alone(_t_, _flat_, _tilt_, _k2, _last_)
            _gap_, _rate_, _bend_, _step_, _next_, _clearance_ = _ring_advance_alone(_t_, _end_, _leaving_, _margin_, _rate_slack_, _ceiling_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _energy2_, _moment2_, _rho_start_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
            _hit_, _sure_, _needs_refinement_ = _gap_closes_alone(_gap_, _rate_, _bend_, _margin_, _rate_slack_, _clearance_, _share_)
            if _needs_refinement_:
                _share_, = _smaller_budget_alone(_share_)
                _excess_, = _ring_excess_alone(_share_, _latest_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
                _position_level_, _velocity_level_, _ = _allowance_alone(_share_, _latest_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_gravity_)
                _flat_, _tilt_, _rate_slack_ = _ring_margins_alone(_latest_, _extent_, _speed_, _position_level_, _velocity_level_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
                _undecided_time_, = _budget_undecided_alone(_t_, _undecided_time_, _excess_)
            _arrival_, _certain_, _exhausted_, _searching_, _t_ = _advanced_alone(_t_, _end_, _step_, _next_, _arrival_, _hit_, _sure_, _needs_refinement_, _certain_)
            if _exhausted_:
                _t_, _end_, _searching_ = _ring_enter_alone(_t_, _end_, _end_, _low0_, _low1_, _low2_, _high0_, _high1_, _high2_)
        _undecided_time_, = _predicate_undecided_alone(_t_, _undecided_time_, _searching_)
    _arrives_, _refining_, _rate_ = _found_alone(_arrival_)
    _leaving_, _ = _nearby_alone(_arrival_, _flat_, _tilt_, _k2, _last_)
    if _refining_:
        _refined_, _gap_, _rate_ = _ring_refine_alone(_arrival_, _leaving_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _rho_start_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _arrival_, _refining_ = _refined_root_alone(_gap_, _rate_, _ceiling_, _arrival_, _refined_, _certain_)
    if _refining_:
        _refined_, _gap_, _rate_ = _ring_refine_alone(_arrival_, _leaving_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _rho_start_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _arrival_, _refining_ = _refined_root_alone(_gap_, _rate_, _ceiling_, _arrival_, _refined_, _certain_)
    for _ in range(8):
        if not _refining_:
            break
        _refined_, _gap_, _rate_ = _ring_refine_alone(_arrival_, _leaving_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _rho_start_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _arrival_, _refining_ = _refined_root_alone(_gap_, _rate_, _ceiling_, _arrival_, _refined_, _certain_)
    _flat_, _tilt_, _rate_margin_ = _ring_margins_alone(_latest_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
    _margin_, = _own_margin_alone(_leaving_, _flat_, _tilt_, _arrival_)
    _clearance_, _delay_ = _crossing_alone(_margin_, _rate_margin_, _rate_, _ceiling_)
    _time_, = _arrival_time_alone(_arrival_)
    _delay_, _undecided_time_ = _arrival_certainty_alone(_clearance_, _time_, _delay_, _undecided_time_, _arrives_, _certain_)
    _undecided_time_, _earliest_delay_ = _tie_undecided_alone(_time_, _when_, _delay_, _earliest_delay_, _undecided_time_, _arrives_)
    _when_, _which_ = _earliest_alone(_k2, _time_, _when_, _which_, _arrives_)
    return (_earliest_delay_, _undecided_time_, _when_, _which_,)


def _alone6(_certain_: Any, _p_ball_radius_: Any, _p_gravity_: Any, _p_ring_radius_: Any, _p_wire_radius_: Any, _short_ceiling_: Any, _short_end_: Any, _short_energy2_: Any, _short_flat_: Any, _short_high1_: Any, _short_high2_: Any, _short_jerk_: Any, _short_low1_: Any, _short_low2_: Any, _short_moment2_: Any, _short_quotient_margin_: Any, _short_rate_margin_: Any, _short_rho_rate_: Any, _short_rho_start_: Any, _short_start_rate_: Any, _short_t_: Any, _short_tilt_: Any, _short_vx_: Any, _short_vy_: Any, _short_vz_: Any, _short_x_: Any, _short_y_: Any, _short_z_: Any, _stepping_: Any, _turns: Any) -> tuple[Any, ...]:
    """Do the body of `stepping` for one shot."""
    for _ in range(_turns):
        if not _stepping_:
            break
        _short_t_, _short_end_, _certain_, _stepping_ = _ring_step_alone(_short_t_, _short_end_, _short_rate_margin_, _short_ceiling_, _short_x_, _short_y_, _short_z_, _short_vx_, _short_vy_, _short_vz_, _short_energy2_, _short_moment2_, _short_rho_start_, _short_flat_, _short_tilt_, _short_quotient_margin_, _short_jerk_, _short_start_rate_, _short_rho_rate_, _short_low1_, _short_high1_, _short_low2_, _short_high2_, _float32(_p_ball_radius_), _float32(_p_ring_radius_), _float32(_p_wire_radius_), _float32(_p_gravity_))
    return (_certain_, _short_t_,)


def _alone7(_arrival_: Any, _certain_: Any, _extent_: Any, _last_: Any, _p_ball_radius_: Any, _p_gravity_: Any, _p_ring_radius_: Any, _p_wire_radius_: Any, _position_error_: Any, _share_: Any, _speed_: Any, _t_: Any, _undecided_time_: Any, _until_: Any, _velocity_error_: Any, _vx_: Any, _vy_: Any, _vz_: Any, _x_: Any, _y_: Any, _z_: Any) -> tuple[Any, ...]:
    """Do the body of `searching` for one shot."""
    _energy2_, _moment2_, _rho_start_, _low0_, _high0_, _low1_, _high1_, _low2_, _high2_, _ceiling_, _latest_, _ = _ring_prepare_alone(_until_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
    _excess_, = _ring_excess_alone(_share_, _latest_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
    _position_level_, _velocity_level_, _ = _allowance_alone(_share_, _latest_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_gravity_)
    _flat_, _tilt_, _rate_slack_ = _ring_margins_alone(_latest_, _extent_, _speed_, _position_level_, _velocity_level_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
    _undecided_time_, = _budget_undecided_alone(_t_, _undecided_time_, _excess_)
    _t_, _end_, _searching_ = _ring_enter_alone(_t_, _k2, _t_, _low0_, _low1_, _low2_, _high0_, _high1_, _high2_)
    for _ in range(201):
        if not _searching_:
            break
        _leaving_, _margin_ = _nearby_alone(_t_, _flat_, _tilt_, _k2, _last_)
        _gap_, _rate_, _bend_, _step_, _next_, _clearance_ = _ring_advance_alone(_t_, _end_, _leaving_, _margin_, _rate_slack_, _ceiling_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _energy2_, _moment2_, _rho_start_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _hit_, _sure_, _needs_refinement_ = _gap_closes_alone(_gap_, _rate_, _bend_, _margin_, _rate_slack_, _clearance_, _share_)
        if _needs_refinement_:
            _share_, = _smaller_budget_alone(_share_)
            _excess_, = _ring_excess_alone(_share_, _latest_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
            _position_level_, _velocity_level_, _ = _allowance_alone(_share_, _latest_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_gravity_)
            _flat_, _tilt_, _rate_slack_ = _ring_margins_alone(_latest_, _extent_, _speed_, _position_level_, _velocity_level_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
            _undecided_time_, = _budget_undecided_alone(_t_, _undecided_time_, _excess_)
        _arrival_, _certain_, _exhausted_, _searching_, _t_ = _advanced_alone(_t_, _end_, _step_, _next_, _arrival_, _hit_, _sure_, _needs_refinement_, _certain_)
        if _exhausted_:
            _t_, _end_, _searching_ = _ring_enter_alone(_t_, _end_, _end_, _low0_, _low1_, _low2_, _high0_, _high1_, _high2_)
    _undecided_time_, = _predicate_undecided_alone(_t_, _undecided_time_, _searching_)
    return (_arrival_, _ceiling_, _certain_, _flat_, _latest_, _rho_start_, _tilt_, _undecided_time_,)


def _alone8(_arrival_: Any, _ceiling_: Any, _certain_: Any, _end_: Any, _energy2_: Any, _flat_: Any, _last_: Any, _moment2_: Any, _p_ball_radius_: Any, _p_gravity_: Any, _p_ring_radius_: Any, _p_wire_radius_: Any, _rate_slack_: Any, _rho_start_: Any, _searching_: Any, _share_: Any, _t_: Any, _tilt_: Any, _undecided_time_: Any, _vx_: Any, _vy_: Any, _vz_: Any, _x_: Any, _y_: Any, _z_: Any, _extent_: Any, _high0_: Any, _high1_: Any, _high2_: Any, _latest_: Any, _low0_: Any, _low1_: Any, _low2_: Any, _position_error_: Any, _speed_: Any, _velocity_error_: Any, _turns: Any) -> tuple[Any, ...]:
    """Do the body of `searching` for one shot."""
    for _ in range(_turns):
        if not _searching_:
            break
        _leaving_, _margin_ = _nearby_alone(_t_, _flat_, _tilt_, _k2, _last_)
        _gap_, _rate_, _bend_, _step_, _next_, _clearance_ = _ring_advance_alone(_t_, _end_, _leaving_, _margin_, _rate_slack_, _ceiling_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _energy2_, _moment2_, _rho_start_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _hit_, _sure_, _needs_refinement_ = _gap_closes_alone(_gap_, _rate_, _bend_, _margin_, _rate_slack_, _clearance_, _share_)
        if _needs_refinement_:
            _share_, = _smaller_budget_alone(_share_)
            _excess_, = _ring_excess_alone(_share_, _latest_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
            _position_level_, _velocity_level_, _ = _allowance_alone(_share_, _latest_, _extent_, _speed_, _float64(_position_error_), _float64(_velocity_error_), _p_gravity_)
            _flat_, _tilt_, _rate_slack_ = _ring_margins_alone(_latest_, _extent_, _speed_, _position_level_, _velocity_level_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
            _undecided_time_, = _budget_undecided_alone(_t_, _undecided_time_, _excess_)
        _arrival_, _certain_, _exhausted_, _searching_, _t_ = _advanced_alone(_t_, _end_, _step_, _next_, _arrival_, _hit_, _sure_, _needs_refinement_, _certain_)
        if _exhausted_:
            _t_, _end_, _searching_ = _ring_enter_alone(_t_, _end_, _end_, _low0_, _low1_, _low2_, _high0_, _high1_, _high2_)
    return (_arrival_, _certain_, _flat_, _searching_, _t_, _tilt_, _undecided_time_,)


def _alone9(_arrival_: Any, _ceiling_: Any, _certain_: Any, _leaving_: Any, _p_ball_radius_: Any, _p_gravity_: Any, _p_ring_radius_: Any, _p_wire_radius_: Any, _rate_: Any, _refining_: Any, _rho_start_: Any, _vx_: Any, _vy_: Any, _vz_: Any, _x_: Any, _y_: Any, _z_: Any, _turns: Any) -> tuple[Any, ...]:
    """Do the body of `refining` for one shot."""
    for _ in range(_turns):
        if not _refining_:
            break
        _refined_, _gap_, _rate_ = _ring_refine_alone(_arrival_, _leaving_, _x_, _y_, _z_, _vx_, _vy_, _vz_, _rho_start_, _p_ball_radius_, _p_ring_radius_, _p_wire_radius_, _p_gravity_)
        _arrival_, _refining_ = _refined_root_alone(_gap_, _rate_, _ceiling_, _arrival_, _refined_, _certain_)
    return (_arrival_, _rate_,)


def validate_plain(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage validate of the event loop, the path alone."""
    _p_ball_radius_0, _p_board_bottom_0, _p_board_distance_0, _p_board_half_width_0, _p_board_top_0, _p_bridge_half_width_0, _p_end_depth_0, _p_gravity_0, _p_restitution_0, _p_ring_radius_0, _p_wire_radius_0, = map(columns.__getitem__, ("p_ball_radius", "p_board_bottom", "p_board_distance", "p_board_half_width", "p_board_top", "p_bridge_half_width", "p_end_depth", "p_gravity", "p_restitution", "p_ring_radius", "p_wire_radius",))
    _allowed_0, = allowed(_p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_bridge_half_width_0, _p_restitution_0, _p_gravity_0, _p_end_depth_0)
    _permitted_0, = parameters_in_range(_p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_bridge_half_width_0, _p_restitution_0, _p_gravity_0, _p_end_depth_0, _allowed_0)
    columns |= {"permitted": _permitted_0, }


def start_plain(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage start of the event loop, the path alone."""
    _last_0, _p_ball_radius_0, _p_board_bottom_0, _p_board_distance_0, _p_board_half_width_0, _p_board_top_0, _p_bridge_half_width_0, _p_end_depth_0, _p_ring_radius_0, _p_wire_radius_0, _permitted_0, _vx_0, _vy_0, _vz_0, _wx_0, _wy_0, _wz_0, _x_0, _y_0, _z_0, = map(columns.__getitem__, ("last", "p_ball_radius", "p_board_bottom", "p_board_distance", "p_board_half_width", "p_board_top", "p_bridge_half_width", "p_end_depth", "p_ring_radius", "p_wire_radius", "permitted", "vx", "vy", "vz", "wx", "wy", "wz", "x", "y", "z",))
    _room_0 = room(shots)
    _in_range_0, = state_in_range(_x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _wx_0, _wy_0, _wz_0, _room_0)
    _close_0, _valid_0, *_ = aside(_x_0, _y_0, _z_0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_bridge_half_width_0, _p_end_depth_0, _room_0)
    _rows1, _count2 = _most(_close_0, shots)
    if _count2:
        _last_1, _p_ball_radius_1, _p_board_bottom_1, _p_board_distance_1, _p_board_half_width_1, _p_board_top_1, _p_bridge_half_width_1, _p_end_depth_1, _p_ring_radius_1, _p_wire_radius_1, _x_1, _y_1, _z_1 = _taken(_rows1, _last_0, _p_ball_radius_0, _p_board_bottom_0, _p_board_distance_0, _p_board_half_width_0, _p_board_top_0, _p_bridge_half_width_0, _p_end_depth_0, _p_ring_radius_0, _p_wire_radius_0, _x_0, _y_0, _z_0)
        _room_1 = room(_count2)
        _valid_1, *_ = valid(_last_1, _x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_bridge_half_width_1, _p_end_depth_1, _room_1)
        _valid_0, = _put(_rows1, shots, (_valid_0,), (_valid_1,), _close_0)
    _outcome_0, *_ = admitted(_inf, _valid_0, _permitted_0, _in_range_0)
    columns |= {"outcome": _outcome_0, }


def detect_plain(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage detect of the event loop, the path alone."""
    _clock_0, _contacts_0, _last_0, _most_contacts_0, _p_ball_radius_0, _p_board_bottom_0, _p_board_distance_0, _p_board_half_width_0, _p_board_top_0, _p_bridge_half_width_0, _p_end_depth_0, _p_gravity_0, _p_ring_radius_0, _p_wire_radius_0, _time_limit_0, _vx_0, _vy_0, _vz_0, _x_0, _y_0, _z_0, = map(columns.__getitem__, ("clock", "contacts", "last", "most_contacts", "p_ball_radius", "p_board_bottom", "p_board_distance", "p_board_half_width", "p_board_top", "p_bridge_half_width", "p_end_depth", "p_gravity", "p_ring_radius", "p_wire_radius", "time_limit", "vx", "vy", "vz", "x", "y", "z",))
    _room_0 = room(shots)
    _, _, _, _time_error_0 = error_bounds(0.0, 0.0, 0.0, 0.0)
    _extent_0, _speed_0, _excess_0 = scale(_x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _p_gravity_0, _room_0)
    _when_0, _which_0, *_ = opening(_excess_0, 0.0, 0.0)
    _limited_0, = limited(_time_limit_0)
    _leaving_0, = left(3.0, _last_0)
    _time_0, _rate_0, _bend_0, _apex_0, *_ = end_arrival(_leaving_0, _z_0, _vz_0, _p_gravity_0, _p_end_depth_0, _room_0)
    _arrives_0, *_ = plane_root(_rate_0, _bend_0, _apex_0, _time_0)
    _possible_0, = within_time(_time_0, _when_0, 0.0, 0.0, _arrives_0)
    _when_1, _which_1 = earliest(3.0, _time_0, _when_0, _which_0, _arrives_0)
    _when_0, _which_0 = _choose(_possible_0, (_when_1, _which_1,), (_when_0, _which_0,))
    _released_0, _reachable_0 = released(_last_0)
    _rows1, _count2 = _most(_released_0, shots)
    if _count2:
        _extent_1, _p_ball_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_gravity_1, _p_ring_radius_1, _speed_1, _vx_1, _when_1, _x_1 = _taken(_rows1, _extent_0, _p_ball_radius_0, _p_board_distance_0, _p_bridge_half_width_0, _p_gravity_0, _p_ring_radius_0, _speed_0, _vx_0, _when_0, _x_0)
        _room_1 = room(_count2)
        _until_1, _pad_1 = horizon(_when_1, _speed_1, _p_gravity_1)
        _reachable_1, = reachable(_p_ball_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_gravity_1, _p_ring_radius_1, _x_1, _vx_1, _until_1, _extent_1, _speed_1, _pad_1, 0.0, 0.0, 0.0, _room_1)
        _reachable_0, = _put(_rows1, shots, (_reachable_0,), (_reachable_1,), _released_0)
    _rows3, _count4 = _rows(_reachable_0, shots)
    if _count4:
        _last_1, _p_ball_radius_1, _p_board_bottom_1, _p_board_distance_1, _p_board_half_width_1, _p_board_top_1, _p_bridge_half_width_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _vx_1, _vy_1, _vz_1, _when_1, _which_1, _x_1, _y_1, _z_1 = _taken(_rows3, _last_0, _p_ball_radius_0, _p_board_bottom_0, _p_board_distance_0, _p_board_half_width_0, _p_board_top_0, _p_bridge_half_width_0, _p_gravity_0, _p_ring_radius_0, _p_wire_radius_0, _vx_0, _vy_0, _vz_0, _when_0, _which_0, _x_0, _y_0, _z_0)
        _room_1 = room(_count4)
        _leaving_1, = left(1.0, _last_1)
        _time_1, _rate_1, _bend_1, _, _height_1 = backboard_arrival(_leaving_1, _x_1, _vx_1, _p_ball_radius_1, _p_board_distance_1)
        _arrives_1, *_ = level_root(_rate_1, _bend_1, _height_1, _time_1, _when_1)
        _possible_1, = within_time(_time_1, _when_1, 0.0, 0.0, _arrives_1)
        _, _there_y_2, _there_z_2, *_ = flight(_time_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_gravity_1, _room_1)
        _g0_2, _g1_2, _g2_2, _g3_2 = backboard_bounds(_there_y_2, _there_z_2, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1)
        _arrives_2, = backboard_within(_g0_2, _g1_2, _g2_2, _g3_2)
        _when_2, _which_2 = earliest(1.0, _time_1, _when_1, _which_1, _arrives_2)
        _when_1, _which_1 = _choose(_possible_1, (_when_2, _which_2,), (_when_1, _which_1,))
        _leaving_1, = left(2.0, _last_1)
        _time_1, _rate_1, _bend_1, _apex_1, *_ = bridge_arrival(_leaving_1, _z_1, _vz_1, _p_ball_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _arrives_1, *_ = plane_root(_rate_1, _bend_1, _apex_1, _time_1)
        _possible_1, = within_time(_time_1, _when_1, 0.0, 0.0, _arrives_1)
        _rows5, _count6 = _most(_possible_1, _count4)
        if _count6:
            _p_board_distance_2, _p_bridge_half_width_2, _p_gravity_2, _p_ring_radius_2, _time_2, _vx_2, _vy_2, _vz_2, _when_2, _which_2, _x_2, _y_2, _z_2 = _taken(_rows5, _p_board_distance_1, _p_bridge_half_width_1, _p_gravity_1, _p_ring_radius_1, _time_1, _vx_1, _vy_1, _vz_1, _when_1, _which_1, _x_1, _y_1, _z_1)
            _room_2 = room(_count6)
            _there_x_2, _there_y_2, *_ = flight(_time_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_gravity_2, _room_2)
            _g0_2, _g1_2, _g2_2, _g3_2, _g4_2 = bridge_bounds(_there_x_2, _there_y_2, _p_ring_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _room_2)
            _arrives_2, = bridge_within(_g0_2, _g1_2, _g2_2, _g3_2, _g4_2)
            _when_2, _which_2 = earliest(2.0, _time_2, _when_2, _which_2, _arrives_2)
            _when_1, _which_1 = _put(_rows5, _count4, (_when_1, _which_1,), (_when_2, _which_2,), _possible_1)
        _when_0, _which_0 = _put(_rows3, shots, (_when_0, _which_0,), (_when_1, _which_1,))
    _until_0, *_ = horizon(_when_0, _speed_0, _p_gravity_0)
    _clear_0, = ring_clear(_until_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _extent_0, _speed_0, 0.0, 0.0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_gravity_0, _room_0)
    _open_0, = opens(_clear_0)
    _rows7, _count8 = _rows(_open_0, shots)
    if (0 < _count8) and (_count8 <= ALONE):
        _when_0, _which_0 = _copies(shots, _when_0, _which_0)
        _one_by_one(_alone0, _rows7, _rows7, (_extent_0, _last_0, _p_ball_radius_0, _p_gravity_0, _p_ring_radius_0, _p_wire_radius_0, _speed_0, _until_0, _vx_0, _vy_0, _vz_0, _when_0, _which_0, _x_0, _y_0, _z_0,), (), (_when_0, _which_0,))
    elif _count8:
        _extent_1, _last_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _speed_1, _until_1, _vx_1, _vy_1, _vz_1, _when_1, _which_1, _x_1, _y_1, _z_1 = _taken(_rows7, _extent_0, _last_0, _p_ball_radius_0, _p_gravity_0, _p_ring_radius_0, _p_wire_radius_0, _speed_0, _until_0, _vx_0, _vy_0, _vz_0, _when_0, _which_0, _x_0, _y_0, _z_0)
        _room_1 = room(_count8)
        _share_1, _arrival_1, _certain_1 = beginning()
        _leaving_1, = left(0.0, _last_1)
        _onset_1, _wide_end_1, _searching_1, _wide_low1_1, _wide_high1_1, _wide_low2_1, _wide_high2_1, _lapsed_1, _representable_1 = ring_opened(_until_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _since_1, *_ = opened(_double(_lapsed_1), _double(_onset_1))
        _rho_start_1, _start_rate_1, _rho_rate_1 = ring_started(_x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ring_radius_1, _room_1)
        _near_x_1, _near_y_1, _near_z_1, _, _, _near_vz_1 = flight(_since_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_gravity_1, _room_1)
        _short_share_1, _short_t_1, _short_end_1, _short_x_1, _short_y_1, _short_z_1, _short_vx_1, _short_vy_1, _short_vz_1, _short_energy2_1, _short_moment2_1, _short_rho_start_1, _short_ceiling_1, _short_flat_1, _short_tilt_1, _short_jerk_1, _short_quotient_margin_1, _short_start_rate_1, _short_rho_rate_1, _short_rate_margin_1, _short_low1_1, _short_high1_1, _short_low2_1, _short_high2_1, _fits_1 = ring_resolution(_onset_1, _wide_end_1, _leaving_1, _lapsed_1, _near_x_1, _near_y_1, _near_z_1, _vx_1, _vy_1, _near_vz_1, _extent_1, _speed_1, _start_rate_1, _rho_rate_1, _wide_low1_1, _wide_high1_1, _wide_low2_1, _wide_high2_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _stepping_1, _searching_1, _single_precision_1, _ceiling_1, _flat_1, _tilt_1, *_ = coarse(_double(_short_rate_margin_1), _double(_short_flat_1), _double(_short_ceiling_1), _double(_short_share_1), _searching_1, _representable_1, _fits_1)
        _rows9, _count10 = _most(_stepping_1, _count8)
        if _count10:
            _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _short_ceiling_2, _short_end_2, _short_energy2_2, _short_flat_2, _short_high1_2, _short_high2_2, _short_jerk_2, _short_low1_2, _short_low2_2, _short_moment2_2, _short_quotient_margin_2, _short_rate_margin_2, _short_rho_rate_2, _short_rho_start_2, _short_start_rate_2, _short_t_2, _short_tilt_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_x_2, _short_y_2, _short_z_2 = _taken(_rows9, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _short_ceiling_1, _short_end_1, _short_energy2_1, _short_flat_1, _short_high1_1, _short_high2_1, _short_jerk_1, _short_low1_1, _short_low2_1, _short_moment2_1, _short_quotient_margin_1, _short_rate_margin_1, _short_rho_rate_1, _short_rho_start_1, _short_start_rate_1, _short_t_1, _short_tilt_1, _short_vx_1, _short_vy_1, _short_vz_1, _short_x_1, _short_y_1, _short_z_1)
            _room_2 = room(_count10)
            _short_t_2, _short_end_2, _certain_2, _stepping_2 = ring_step(_short_t_2, _short_end_2, _short_rate_margin_2, _short_ceiling_2, _short_x_2, _short_y_2, _short_z_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_energy2_2, _short_moment2_2, _short_rho_start_2, _short_flat_2, _short_tilt_2, _short_quotient_margin_2, _short_jerk_2, _short_start_rate_2, _short_rho_rate_2, _short_low1_2, _short_high1_2, _short_low2_2, _short_high2_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _certain_1, _short_end_1, _short_t_1, _stepping_1 = _put(_rows9, _count8, (_certain_1, _short_end_1, _short_t_1, _stepping_1,), (_certain_2, _short_end_2, _short_t_2, _stepping_2,), _stepping_1)
        _rows11, _count12 = _rows(_stepping_1, _count8)
        if (0 < _count12) and (_count12 <= ALONE):
            _certain_1, _short_t_1 = _copies(_count8, _certain_1, _short_t_1)
            _one_by_one(_alone1, _rows11, _rows11, (_certain_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _short_ceiling_1, _short_end_1, _short_energy2_1, _short_flat_1, _short_high1_1, _short_high2_1, _short_jerk_1, _short_low1_1, _short_low2_1, _short_moment2_1, _short_quotient_margin_1, _short_rate_margin_1, _short_rho_rate_1, _short_rho_start_1, _short_start_rate_1, _short_t_1, _short_tilt_1, _short_vx_1, _short_vy_1, _short_vz_1, _short_x_1, _short_y_1, _short_z_1, _stepping_1,), (), (_certain_1, _short_t_1,), 24)
        elif _count12:
            _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _short_ceiling_2, _short_end_2, _short_energy2_2, _short_flat_2, _short_high1_2, _short_high2_2, _short_jerk_2, _short_low1_2, _short_low2_2, _short_moment2_2, _short_quotient_margin_2, _short_rate_margin_2, _short_rho_rate_2, _short_rho_start_2, _short_start_rate_2, _short_t_2, _short_tilt_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_x_2, _short_y_2, _short_z_2, _stepping_2 = _taken(_rows11, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _short_ceiling_1, _short_end_1, _short_energy2_1, _short_flat_1, _short_high1_1, _short_high2_1, _short_jerk_1, _short_low1_1, _short_low2_1, _short_moment2_1, _short_quotient_margin_1, _short_rate_margin_1, _short_rho_rate_1, _short_rho_start_1, _short_start_rate_1, _short_t_1, _short_tilt_1, _short_vx_1, _short_vy_1, _short_vz_1, _short_x_1, _short_y_1, _short_z_1, _stepping_1)
            _certain_1, _short_t_1 = _copies(_count8, _certain_1, _short_t_1)
            for _turn13 in range(24):
                _room_2 = room(_count12)
                _short_t_2, _short_end_2, _certain_2, _stepping_2 = ring_step(_short_t_2, _short_end_2, _short_rate_margin_2, _short_ceiling_2, _short_x_2, _short_y_2, _short_z_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_energy2_2, _short_moment2_2, _short_rho_start_2, _short_flat_2, _short_tilt_2, _short_quotient_margin_2, _short_jerk_2, _short_start_rate_2, _short_rho_rate_2, _short_low1_2, _short_high1_2, _short_low2_2, _short_high2_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
                _going14 = _where_true(_stepping_2)
                if len(_going14) == _count12:
                    continue
                _done = _where_true(_logical_not(_stepping_2))
                _store((_certain_1, _short_t_1,), _of(_rows11, _done), (_certain_2, _short_t_2,), _done)
                _rows11 = _of(_rows11, _going14)
                _count12 = len(_going14)
                if _count12 == 0:
                    break
                if _count12 <= ALONE:
                    _one_by_one(_alone1, _rows11, _going14, (_certain_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _short_ceiling_2, _short_end_2, _short_energy2_2, _short_flat_2, _short_high1_2, _short_high2_2, _short_jerk_2, _short_low1_2, _short_low2_2, _short_moment2_2, _short_quotient_margin_2, _short_rate_margin_2, _short_rho_rate_2, _short_rho_start_2, _short_start_rate_2, _short_t_2, _short_tilt_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_x_2, _short_y_2, _short_z_2, _stepping_2,), (), (_certain_1, _short_t_1,), 23 - _turn13)
                    break
                _certain_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _short_ceiling_2, _short_end_2, _short_energy2_2, _short_flat_2, _short_high1_2, _short_high2_2, _short_jerk_2, _short_low1_2, _short_low2_2, _short_moment2_2, _short_quotient_margin_2, _short_rate_margin_2, _short_rho_rate_2, _short_rho_start_2, _short_start_rate_2, _short_t_2, _short_tilt_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_x_2, _short_y_2, _short_z_2, _stepping_2 = _taken(_going14, _certain_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _short_ceiling_2, _short_end_2, _short_energy2_2, _short_flat_2, _short_high1_2, _short_high2_2, _short_jerk_2, _short_low1_2, _short_low2_2, _short_moment2_2, _short_quotient_margin_2, _short_rate_margin_2, _short_rho_rate_2, _short_rho_start_2, _short_start_rate_2, _short_t_2, _short_tilt_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_x_2, _short_y_2, _short_z_2, _stepping_2)
            else:
                _store((_certain_1, _short_t_1,), _rows11, (_certain_2, _short_t_2,), None)
        _arrival_1, _t_1, _searching_1 = stepped(_arrival_1, _double(_short_t_1), _searching_1, _since_1, _single_precision_1, _certain_1)
        _rows15, _count16 = _rows(_searching_1, _count8)
        if (0 < _count16) and (_count16 <= ALONE):
            _arrival_1, _ceiling_1, _certain_1, _flat_1, _rho_start_1, _tilt_1 = _copies(_count8, _arrival_1, _ceiling_1, _certain_1, _flat_1, _rho_start_1, _tilt_1)
            _one_by_one(_alone2, _rows15, _rows15, (_arrival_1, _certain_1, _extent_1, _last_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _share_1, _speed_1, _t_1, _until_1, _vx_1, _vy_1, _vz_1, _x_1, _y_1, _z_1,), (), (_arrival_1, _ceiling_1, _certain_1, _flat_1, _rho_start_1, _tilt_1,))
        elif _count16:
            _arrival_2, _certain_2, _extent_2, _last_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _share_2, _speed_2, _t_2, _until_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2 = _taken(_rows15, _arrival_1, _certain_1, _extent_1, _last_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _share_1, _speed_1, _t_1, _until_1, _vx_1, _vy_1, _vz_1, _x_1, _y_1, _z_1)
            _room_2 = room(_count16)
            _energy2_2, _moment2_2, _rho_start_2, _low0_2, _high0_2, _low1_2, _high1_2, _low2_2, _high2_2, _ceiling_2, _latest_2, *_ = ring_prepare(_until_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _extent_2, _speed_2, 0.0, 0.0, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _position_level_2, _velocity_level_2, *_ = allowance(_share_2, _latest_2, _extent_2, _speed_2, 0.0, 0.0, _p_gravity_2, _room_2)
            _flat_2, _tilt_2, _rate_slack_2 = ring_margins(_latest_2, _extent_2, _speed_2, _position_level_2, _velocity_level_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _t_2, _end_2, _searching_2 = ring_enter(_t_2, 0.0, _t_2, _low0_2, _low1_2, _low2_2, _high0_2, _high1_2, _high2_2, _room_2)
            _rows17, _count18 = _rows(_searching_2, _count16)
            if (0 < _count18) and (_count18 <= ALONE):
                _arrival_2, _certain_2, _flat_2, _tilt_2 = _copies(_count16, _arrival_2, _certain_2, _flat_2, _tilt_2)
                _one_by_one(_alone3, _rows17, _rows17, (_arrival_2, _ceiling_2, _certain_2, _end_2, _energy2_2, _flat_2, _last_2, _moment2_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _rate_slack_2, _rho_start_2, _searching_2, _share_2, _t_2, _tilt_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2, _extent_2, _high0_2, _high1_2, _high2_2, _latest_2, _low0_2, _low1_2, _low2_2, _speed_2,), (), (_arrival_2, _certain_2, _flat_2, _tilt_2,), 201)
            elif _count18:
                _arrival_3, _ceiling_3, _certain_3, _end_3, _energy2_3, _flat_3, _last_3, _moment2_3, _p_ball_radius_3, _p_gravity_3, _p_ring_radius_3, _p_wire_radius_3, _rate_slack_3, _rho_start_3, _searching_3, _share_3, _t_3, _tilt_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3 = _taken(_rows17, _arrival_2, _ceiling_2, _certain_2, _end_2, _energy2_2, _flat_2, _last_2, _moment2_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _rate_slack_2, _rho_start_2, _searching_2, _share_2, _t_2, _tilt_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2)
                _arrival_2, _certain_2, _flat_2, _tilt_2 = _copies(_count16, _arrival_2, _certain_2, _flat_2, _tilt_2)
                for _turn19 in range(201):
                    _room_3 = room(_count18)
                    _leaving_3, _margin_3 = nearby(_t_3, _flat_3, _tilt_3, 0.0, _last_3)
                    _gap_3, _rate_3, _bend_3, _step_3, _next_3, _clearance_3 = ring_advance(_t_3, _end_3, _leaving_3, _margin_3, _rate_slack_3, _ceiling_3, _x_3, _y_3, _z_3, _vx_3, _vy_3, _vz_3, _energy2_3, _moment2_3, _rho_start_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_gravity_3, _room_3)
                    _hit_3, _sure_3, _needs_refinement_3 = gap_closes(_gap_3, _rate_3, _bend_3, _margin_3, _rate_slack_3, _clearance_3, _share_3)
                    _rows20, _count21 = _most(_needs_refinement_3, _count18)
                    if _count21:
                        _far = _of(_rows17, _rows20)
                        _extent_4, _latest_4, _speed_4 = _taken(_far, _extent_2, _latest_2, _speed_2)
                        _p_ball_radius_4, _p_gravity_4, _p_ring_radius_4, _p_wire_radius_4, _share_4 = _taken(_rows20, _p_ball_radius_3, _p_gravity_3, _p_ring_radius_3, _p_wire_radius_3, _share_3)
                        _room_4 = room(_count21)
                        _share_4, = smaller_budget(_share_4)
                        _position_level_4, _velocity_level_4, *_ = allowance(_share_4, _latest_4, _extent_4, _speed_4, 0.0, 0.0, _p_gravity_4, _room_4)
                        _flat_4, _tilt_4, _rate_slack_4 = ring_margins(_latest_4, _extent_4, _speed_4, _position_level_4, _velocity_level_4, _p_ball_radius_4, _p_ring_radius_4, _p_wire_radius_4, _p_gravity_4, _room_4)
                        _flat_3, _rate_slack_3, _share_3, _tilt_3 = _put(_rows20, _count18, (_flat_3, _rate_slack_3, _share_3, _tilt_3,), (_flat_4, _rate_slack_4, _share_4, _tilt_4,), _needs_refinement_3)
                    _arrival_3, _certain_3, _exhausted_3, _searching_3, _t_3 = advanced(_t_3, _end_3, _step_3, _next_3, _arrival_3, _hit_3, _sure_3, _needs_refinement_3, _certain_3)
                    _rows22, _count23 = _most(_exhausted_3, _count18)
                    if _count23:
                        _far = _of(_rows17, _rows22)
                        _high0_4, _high1_4, _high2_4, _low0_4, _low1_4, _low2_4 = _taken(_far, _high0_2, _high1_2, _high2_2, _low0_2, _low1_2, _low2_2)
                        _end_4, _t_4 = _taken(_rows22, _end_3, _t_3)
                        _room_4 = room(_count23)
                        _t_4, _end_4, _searching_4 = ring_enter(_t_4, _end_4, _end_4, _low0_4, _low1_4, _low2_4, _high0_4, _high1_4, _high2_4, _room_4)
                        _end_3, _searching_3, _t_3 = _put(_rows22, _count18, (_end_3, _searching_3, _t_3,), (_end_4, _searching_4, _t_4,), _exhausted_3)
                    _going24 = _where_true(_searching_3)
                    if len(_going24) == _count18:
                        continue
                    _done = _where_true(_logical_not(_searching_3))
                    _store((_arrival_2, _certain_2, _flat_2, _tilt_2,), _of(_rows17, _done), (_arrival_3, _certain_3, _flat_3, _tilt_3,), _done)
                    _rows17 = _of(_rows17, _going24)
                    _count18 = len(_going24)
                    if _count18 == 0:
                        break
                    if _count18 <= ALONE:
                        _one_by_one(_alone3, _rows17, _going24, (_arrival_3, _ceiling_3, _certain_3, _end_3, _energy2_3, _flat_3, _last_3, _moment2_3, _p_ball_radius_3, _p_gravity_3, _p_ring_radius_3, _p_wire_radius_3, _rate_slack_3, _rho_start_3, _searching_3, _share_3, _t_3, _tilt_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3,), (_extent_2, _high0_2, _high1_2, _high2_2, _latest_2, _low0_2, _low1_2, _low2_2, _speed_2,), (_arrival_2, _certain_2, _flat_2, _tilt_2,), 200 - _turn19)
                        break
                    _arrival_3, _ceiling_3, _certain_3, _end_3, _energy2_3, _flat_3, _last_3, _moment2_3, _p_ball_radius_3, _p_gravity_3, _p_ring_radius_3, _p_wire_radius_3, _rate_slack_3, _rho_start_3, _searching_3, _share_3, _t_3, _tilt_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3 = _taken(_going24, _arrival_3, _ceiling_3, _certain_3, _end_3, _energy2_3, _flat_3, _last_3, _moment2_3, _p_ball_radius_3, _p_gravity_3, _p_ring_radius_3, _p_wire_radius_3, _rate_slack_3, _rho_start_3, _searching_3, _share_3, _t_3, _tilt_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3)
                else:
                    _store((_arrival_2, _certain_2, _flat_2, _tilt_2,), _rows17, (_arrival_3, _certain_3, _flat_3, _tilt_3,), None)
            _arrival_1, _ceiling_1, _certain_1, _flat_1, _rho_start_1, _tilt_1 = _put(_rows15, _count8, (_arrival_1, _ceiling_1, _certain_1, _flat_1, _rho_start_1, _tilt_1,), (_arrival_2, _ceiling_2, _certain_2, _flat_2, _rho_start_2, _tilt_2,))
        _arrives_1, _refining_1, *_ = found(_arrival_1)
        _leaving_1, *_ = nearby(_arrival_1, _flat_1, _tilt_1, 0.0, _last_1)
        _rows25, _count26 = _most(_refining_1, _count8)
        if _count26:
            _arrival_2, _ceiling_2, _certain_2, _leaving_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _rho_start_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2 = _taken(_rows25, _arrival_1, _ceiling_1, _certain_1, _leaving_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _rho_start_1, _vx_1, _vy_1, _vz_1, _x_1, _y_1, _z_1)
            _room_2 = room(_count26)
            _refined_2, _gap_2, _rate_2 = ring_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _rho_start_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = refined_root(_gap_2, _rate_2, _ceiling_2, _arrival_2, _refined_2, _certain_2)
            _arrival_1, _refining_1 = _put(_rows25, _count8, (_arrival_1, _refining_1,), (_arrival_2, _refining_2,), _refining_1)
        _rows27, _count28 = _most(_refining_1, _count8)
        if _count28:
            _arrival_2, _ceiling_2, _certain_2, _leaving_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _rho_start_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2 = _taken(_rows27, _arrival_1, _ceiling_1, _certain_1, _leaving_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _rho_start_1, _vx_1, _vy_1, _vz_1, _x_1, _y_1, _z_1)
            _room_2 = room(_count28)
            _refined_2, _gap_2, _rate_2 = ring_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _rho_start_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = refined_root(_gap_2, _rate_2, _ceiling_2, _arrival_2, _refined_2, _certain_2)
            _arrival_1, _refining_1 = _put(_rows27, _count8, (_arrival_1, _refining_1,), (_arrival_2, _refining_2,), _refining_1)
        _rows29, _count30 = _rows(_refining_1, _count8)
        if (0 < _count30) and (_count30 <= ALONE):
            _arrival_1, = _copies(_count8, _arrival_1)
            _one_by_one(_alone4, _rows29, _rows29, (_arrival_1, _ceiling_1, _certain_1, _leaving_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _refining_1, _rho_start_1, _vx_1, _vy_1, _vz_1, _x_1, _y_1, _z_1,), (), (_arrival_1,), 8)
        elif _count30:
            _arrival_2, _ceiling_2, _certain_2, _leaving_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _refining_2, _rho_start_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2 = _taken(_rows29, _arrival_1, _ceiling_1, _certain_1, _leaving_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _refining_1, _rho_start_1, _vx_1, _vy_1, _vz_1, _x_1, _y_1, _z_1)
            _arrival_1, = _copies(_count8, _arrival_1)
            for _turn31 in range(8):
                _room_2 = room(_count30)
                _refined_2, _gap_2, _rate_2 = ring_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _rho_start_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
                _arrival_2, _refining_2 = refined_root(_gap_2, _rate_2, _ceiling_2, _arrival_2, _refined_2, _certain_2)
                _going32 = _where_true(_refining_2)
                if len(_going32) == _count30:
                    continue
                _done = _where_true(_logical_not(_refining_2))
                _store((_arrival_1,), _of(_rows29, _done), (_arrival_2,), _done)
                _rows29 = _of(_rows29, _going32)
                _count30 = len(_going32)
                if _count30 == 0:
                    break
                if _count30 <= ALONE:
                    _one_by_one(_alone4, _rows29, _going32, (_arrival_2, _ceiling_2, _certain_2, _leaving_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _refining_2, _rho_start_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2,), (), (_arrival_1,), 7 - _turn31)
                    break
                _arrival_2, _ceiling_2, _certain_2, _leaving_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _refining_2, _rho_start_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2 = _taken(_going32, _arrival_2, _ceiling_2, _certain_2, _leaving_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _refining_2, _rho_start_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2)
            else:
                _store((_arrival_1,), _rows29, (_arrival_2,), None)
        _time_1, = arrival_time(_arrival_1)
        _when_1, _which_1 = earliest(0.0, _time_1, _when_1, _which_1, _arrives_1)
        _when_0, _which_0 = _put(_rows7, shots, (_when_0, _which_0,), (_when_1, _which_1,))
    _rows33, _count34 = _most(_limited_0, shots)
    if _count34:
        _clock_1, _time_error_1, _time_limit_1, _when_1, _which_1 = _taken(_rows33, _clock_0, _time_error_0, _time_limit_0, _when_0, _which_0)
        _time_1, _, _arrives_1, *_ = expiry(_when_1, _which_1, 0.0, _inf, _double(_time_error_1), _clock_1, _time_limit_1)
        _when_1, _which_1 = earliest(4.0, _time_1, _when_1, _which_1, _arrives_1)
        _when_0, _which_0 = _put(_rows33, shots, (_when_0, _which_0,), (_when_1, _which_1,), _limited_0)
    _, _moves_0, _ends_0, _touches_0, _reached_0, *_ = departed(3.0, _which_0)
    _body_0, = body_of(_which_0)
    _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1 = flight(_when_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _p_gravity_0, _room_0)
    _clock_1, = event_clock(_when_0, _clock_0)
    _clock_0, _vx_0, _vy_0, _vz_0, _x_0, _y_0, _z_0 = _choose(_moves_0, (_clock_1, _vx_1, _vy_1, _vz_1, _x_1, _y_1, _z_1,), (_clock_0, _vx_0, _vy_0, _vz_0, _x_0, _y_0, _z_0,))
    _rows35, _count36 = _most(_limited_0, shots)
    if _count36:
        _body_1, _clock_1, _ends_1, _reached_1, _time_limit_1, _which_1 = _taken(_rows35, _body_0, _clock_0, _ends_0, _reached_0, _time_limit_0, _which_0)
        _clock_1, _body_1, _reached_1, _ends_1 = expired(4.0, _which_1, _body_1, _clock_1, _reached_1, _time_limit_1, _ends_1)
        _body_0, _clock_0, _ends_0, _reached_0 = _put(_rows35, shots, (_body_0, _clock_0, _ends_0, _reached_0,), (_body_1, _clock_1, _ends_1, _reached_1,), _limited_0)
    _here_0, = here(3.0, _which_0)
    _g0_1, = end_bounds(_x_0, _y_0, _p_ring_radius_0)
    _reached_1, = end_reached(_g0_1)
    _reached_0, = _choose(_here_0, (_reached_1,), (_reached_0,))
    _contacts_0, _outcome_0 = accounted(_contacts_0, _most_contacts_0, _reached_0, _touches_0)
    columns |= {"body": _body_0, "clock": _clock_0, "contacts": _contacts_0, "ends": _ends_0, "outcome": _outcome_0, "touches": _touches_0, "vx": _vx_0, "vy": _vy_0, "vz": _vz_0, "which": _which_0, "x": _x_0, "y": _y_0, "z": _z_0, }


def resolve_plain(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage resolve of the event loop, the path alone."""
    _body_0, _count_0_0, _count_1_0, _count_2_0, _ends_0, _first_0, _last_0, _p_ball_radius_0, _p_board_distance_0, _p_restitution_0, _p_ring_radius_0, _p_wire_radius_0, _touches_0, _vx_0, _vy_0, _vz_0, _which_0, _wx_0, _wy_0, _wz_0, _x_0, _y_0, _z_0, = map(columns.__getitem__, ("body", "count_0", "count_1", "count_2", "ends", "first", "last", "p_ball_radius", "p_board_distance", "p_restitution", "p_ring_radius", "p_wire_radius", "touches", "vx", "vy", "vz", "which", "wx", "wy", "wz", "x", "y", "z",))
    _meeting_0, = meeting(0.0, _ends_0, _touches_0)
    _rows1, _count2 = _rows(_meeting_0, shots)
    if _count2:
        _body_1, _count_0_1, _count_1_1, _count_2_1, _first_1, _last_1, _p_ball_radius_1, _p_board_distance_1, _p_restitution_1, _p_ring_radius_1, _p_wire_radius_1, _touches_1, _vx_1, _vy_1, _vz_1, _which_1, _wx_1, _wy_1, _wz_1, _x_1, _y_1, _z_1 = _taken(_rows1, _body_0, _count_0_0, _count_1_0, _count_2_0, _first_0, _last_0, _p_ball_radius_0, _p_board_distance_0, _p_restitution_0, _p_ring_radius_0, _p_wire_radius_0, _touches_0, _vx_0, _vy_0, _vz_0, _which_0, _wx_0, _wy_0, _wz_0, _x_0, _y_0, _z_0)
        _room_1 = room(_count2)
        _nx_1, _ny_1, _nz_1 = end_normal()
        _here_1, = here(0.0, _which_1)
        _nx_2, _ny_2, _nz_2 = ring_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _room_1)
        _count_0_2, = counted(_count_0_1)
        _count_0_1, _nx_1, _ny_1, _nz_1 = _choose(_here_1, (_count_0_2, _nx_2, _ny_2, _nz_2,), (_count_0_1, _nx_1, _ny_1, _nz_1,))
        _here_1, = here(1.0, _which_1)
        _nx_2, _ny_2, _nz_2 = backboard_normal()
        _count_1_2, = counted(_count_1_1)
        _count_1_1, _nx_1, _ny_1, _nz_1 = _choose(_here_1, (_count_1_2, _nx_2, _ny_2, _nz_2,), (_count_1_1, _nx_1, _ny_1, _nz_1,))
        _here_1, = here(2.0, _which_1)
        _nx_2, _ny_2, _nz_2 = bridge_normal()
        _count_2_2, = counted(_count_2_1)
        _count_2_1, _nx_1, _ny_1, _nz_1 = _choose(_here_1, (_count_2_2, _nx_2, _ny_2, _nz_2,), (_count_2_1, _nx_1, _ny_1, _nz_1,))
        _rows3, _count4 = _most(_touches_1, _count2)
        if _count4:
            _nx_2, _ny_2, _nz_2, _p_ball_radius_2, _p_restitution_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = _taken(_rows3, _nx_1, _ny_1, _nz_1, _p_ball_radius_1, _p_restitution_1, _vx_1, _vy_1, _vz_1, _wx_1, _wy_1, _wz_1)
            _room_2 = room(_count4)
            _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = impact(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _p_ball_radius_2, _p_restitution_2, _room_2)
            _vx_1, _vy_1, _vz_1, _wx_1, _wy_1, _wz_1 = _put(_rows3, _count2, (_vx_1, _vy_1, _vz_1, _wx_1, _wy_1, _wz_1,), (_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2,), _touches_1)
        _here_1, = here(1.0, _which_1)
        _x_2, _y_2, _z_2 = backboard_place(_y_1, _z_1, _p_ball_radius_1, _p_board_distance_1)
        _x_1, _y_1, _z_1 = _choose(_here_1, (_x_2, _y_2, _z_2,), (_x_1, _y_1, _z_1,))
        _here_1, = here(2.0, _which_1)
        _x_2, _y_2, _z_2 = bridge_place(_x_1, _y_1, _p_ball_radius_1, _p_wire_radius_1)
        _x_1, _y_1, _z_1 = _choose(_here_1, (_x_2, _y_2, _z_2,), (_x_1, _y_1, _z_1,))
        _first_2, _last_2 = touched(_which_1, _body_1, _first_1)
        _first_1, _last_1 = _choose(_touches_1, (_first_2, _last_2,), (_first_1, _last_1,))
        _count_0_0, _count_1_0, _count_2_0, _first_0, _last_0, _vx_0, _vy_0, _vz_0, _wx_0, _wy_0, _wz_0, _x_0, _y_0, _z_0 = _put(_rows1, shots, (_count_0_0, _count_1_0, _count_2_0, _first_0, _last_0, _vx_0, _vy_0, _vz_0, _wx_0, _wy_0, _wz_0, _x_0, _y_0, _z_0,), (_count_0_1, _count_1_1, _count_2_1, _first_1, _last_1, _vx_1, _vy_1, _vz_1, _wx_1, _wy_1, _wz_1, _x_1, _y_1, _z_1,))
    columns |= {"count_0": _count_0_0, "count_1": _count_1_0, "count_2": _count_2_0, "first": _first_0, "last": _last_0, "vx": _vx_0, "vy": _vy_0, "vz": _vz_0, "wx": _wx_0, "wy": _wy_0, "wz": _wz_0, "x": _x_0, "y": _y_0, "z": _z_0, }


def validate_bounded(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage validate of the event loop, with bounds on errors."""
    _p_ball_radius_0, _p_board_bottom_0, _p_board_distance_0, _p_board_half_width_0, _p_board_top_0, _p_bridge_half_width_0, _p_end_depth_0, _p_gravity_0, _p_restitution_0, _p_ring_radius_0, _p_wire_radius_0, = map(columns.__getitem__, ("p_ball_radius", "p_board_bottom", "p_board_distance", "p_board_half_width", "p_board_top", "p_bridge_half_width", "p_end_depth", "p_gravity", "p_restitution", "p_ring_radius", "p_wire_radius",))
    _allowed_0, = allowed(_p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_bridge_half_width_0, _p_restitution_0, _p_gravity_0, _p_end_depth_0)
    _permitted_0, = parameters_in_range(_p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_bridge_half_width_0, _p_restitution_0, _p_gravity_0, _p_end_depth_0, _allowed_0)
    columns |= {"permitted": _permitted_0, }


def start_bounded(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage start of the event loop, with bounds on errors."""
    _last_0, _p_ball_radius_0, _p_board_bottom_0, _p_board_distance_0, _p_board_half_width_0, _p_board_top_0, _p_bridge_half_width_0, _p_end_depth_0, _p_ring_radius_0, _p_wire_radius_0, _permitted_0, _vx_0, _vy_0, _vz_0, _wx_0, _wy_0, _wz_0, _x_0, _y_0, _z_0, = map(columns.__getitem__, ("last", "p_ball_radius", "p_board_bottom", "p_board_distance", "p_board_half_width", "p_board_top", "p_bridge_half_width", "p_end_depth", "p_ring_radius", "p_wire_radius", "permitted", "vx", "vy", "vz", "wx", "wy", "wz", "x", "y", "z",))
    _room_0 = room(shots)
    _in_range_0, = state_in_range(_x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _wx_0, _wy_0, _wz_0, _room_0)
    _close_0, _valid_0, _undecided_time_0 = aside(_x_0, _y_0, _z_0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_bridge_half_width_0, _p_end_depth_0, _room_0)
    _rows1, _count2 = _most(_close_0, shots)
    if _count2:
        _last_1, _p_ball_radius_1, _p_board_bottom_1, _p_board_distance_1, _p_board_half_width_1, _p_board_top_1, _p_bridge_half_width_1, _p_end_depth_1, _p_ring_radius_1, _p_wire_radius_1, _x_1, _y_1, _z_1 = _taken(_rows1, _last_0, _p_ball_radius_0, _p_board_bottom_0, _p_board_distance_0, _p_board_half_width_0, _p_board_top_0, _p_bridge_half_width_0, _p_end_depth_0, _p_ring_radius_0, _p_wire_radius_0, _x_0, _y_0, _z_0)
        _room_1 = room(_count2)
        _valid_1, _undecided_time_1 = valid(_last_1, _x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_bridge_half_width_1, _p_end_depth_1, _room_1)
        _undecided_time_0, _valid_0 = _put(_rows1, shots, (_undecided_time_0, _valid_0,), (_undecided_time_1, _valid_1,), _close_0)
    _outcome_0, _uncertain_0 = admitted(_undecided_time_0, _valid_0, _permitted_0, _in_range_0)
    columns |= {"outcome": _outcome_0, "uncertain": _uncertain_0, }


def detect_bounded(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage detect of the event loop, with bounds on errors."""
    _clock_0, _clock_error_0, _contacts_0, _last_0, _most_contacts_0, _p_ball_radius_0, _p_board_bottom_0, _p_board_distance_0, _p_board_half_width_0, _p_board_top_0, _p_bridge_half_width_0, _p_end_depth_0, _p_gravity_0, _p_ring_radius_0, _p_wire_radius_0, _position_bound_0, _spin_bound_0, _time_limit_0, _uncertain_0, _velocity_bound_0, _vx_0, _vy_0, _vz_0, _x_0, _y_0, _z_0, = map(columns.__getitem__, ("clock", "clock_error", "contacts", "last", "most_contacts", "p_ball_radius", "p_board_bottom", "p_board_distance", "p_board_half_width", "p_board_top", "p_bridge_half_width", "p_end_depth", "p_gravity", "p_ring_radius", "p_wire_radius", "position_bound", "spin_bound", "time_limit", "uncertain", "velocity_bound", "vx", "vy", "vz", "x", "y", "z",))
    _room_0 = room(shots)
    _position_error_0, _velocity_error_0, _, _time_error_0 = error_bounds(_clock_error_0, _position_bound_0, _velocity_bound_0, _spin_bound_0)
    _extent_0, _speed_0, _excess_0 = scale(_x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _p_gravity_0, _room_0)
    _when_0, _which_0, _earliest_delay_0, _undecided_time_0 = opening(_excess_0, _double(_position_error_0), _double(_velocity_error_0))
    _limited_0, = limited(_time_limit_0)
    _leaving_0, = left(3.0, _last_0)
    _time_0, _rate_0, _bend_0, _apex_0, _height_0 = end_arrival(_leaving_0, _z_0, _vz_0, _p_gravity_0, _p_end_depth_0, _room_0)
    _arrives_0, _ceiling_0, _nearest_0 = plane_root(_rate_0, _bend_0, _apex_0, _time_0)
    _margin_0, = end_margin(_nearest_0, _extent_0, _speed_0, _double(_position_error_0), _double(_velocity_error_0), _p_gravity_0, _p_end_depth_0, _room_0)
    _clearance_0, _delay_0 = crossing(_margin_0, 0.0, _rate_0, _ceiling_0, _room_0)
    _possible_0, = within_time(_time_0, _when_0, _delay_0, _earliest_delay_0, _arrives_0)
    _undecided_time_0, = apex_undecided(_margin_0, _apex_0, _height_0, _undecided_time_0)
    _undecided_time_1, = crossing_undecided(_clearance_0, _time_0, _undecided_time_0, _arrives_0)
    _undecided_time_1, _earliest_delay_1 = tie_undecided(_time_0, _when_0, _delay_0, _earliest_delay_0, _undecided_time_1, _arrives_0, _room_0)
    _when_1, _which_1 = earliest(3.0, _time_0, _when_0, _which_0, _arrives_0)
    _earliest_delay_0, _undecided_time_0, _when_0, _which_0 = _choose(_possible_0, (_earliest_delay_1, _undecided_time_1, _when_1, _which_1,), (_earliest_delay_0, _undecided_time_0, _when_0, _which_0,))
    _released_0, _reachable_0 = released(_last_0)
    _rows1, _count2 = _most(_released_0, shots)
    if _count2:
        _earliest_delay_1, _extent_1, _p_ball_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_gravity_1, _p_ring_radius_1, _position_error_1, _speed_1, _velocity_error_1, _vx_1, _when_1, _x_1 = _taken(_rows1, _earliest_delay_0, _extent_0, _p_ball_radius_0, _p_board_distance_0, _p_bridge_half_width_0, _p_gravity_0, _p_ring_radius_0, _position_error_0, _speed_0, _velocity_error_0, _vx_0, _when_0, _x_0)
        _room_1 = room(_count2)
        _until_1, _pad_1 = horizon(_when_1, _speed_1, _p_gravity_1)
        _reachable_1, = reachable(_p_ball_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_gravity_1, _p_ring_radius_1, _x_1, _vx_1, _until_1, _extent_1, _speed_1, _pad_1, _earliest_delay_1, _double(_position_error_1), _double(_velocity_error_1), _room_1)
        _reachable_0, = _put(_rows1, shots, (_reachable_0,), (_reachable_1,), _released_0)
    _rows3, _count4 = _rows(_reachable_0, shots)
    if _count4:
        _earliest_delay_1, _extent_1, _last_1, _p_ball_radius_1, _p_board_bottom_1, _p_board_distance_1, _p_board_half_width_1, _p_board_top_1, _p_bridge_half_width_1, _p_end_depth_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _position_error_1, _speed_1, _undecided_time_1, _velocity_error_1, _vx_1, _vy_1, _vz_1, _when_1, _which_1, _x_1, _y_1, _z_1 = _taken(_rows3, _earliest_delay_0, _extent_0, _last_0, _p_ball_radius_0, _p_board_bottom_0, _p_board_distance_0, _p_board_half_width_0, _p_board_top_0, _p_bridge_half_width_0, _p_end_depth_0, _p_gravity_0, _p_ring_radius_0, _p_wire_radius_0, _position_error_0, _speed_0, _undecided_time_0, _velocity_error_0, _vx_0, _vy_0, _vz_0, _when_0, _which_0, _x_0, _y_0, _z_0)
        _room_1 = room(_count4)
        _leaving_1, = left(1.0, _last_1)
        _time_1, _rate_1, _bend_1, _, _height_1 = backboard_arrival(_leaving_1, _x_1, _vx_1, _p_ball_radius_1, _p_board_distance_1)
        _arrives_1, _ceiling_1, _nearest_1 = level_root(_rate_1, _bend_1, _height_1, _time_1, _when_1)
        _margin_1, = backboard_margin(_nearest_1, _extent_1, _speed_1, _double(_position_error_1), _double(_velocity_error_1), _p_ball_radius_1, _p_board_distance_1, _p_gravity_1, _room_1)
        _clearance_1, _delay_1 = crossing(_margin_1, 0.0, _rate_1, _ceiling_1, _room_1)
        _possible_1, = within_time(_time_1, _when_1, _delay_1, _earliest_delay_1, _arrives_1)
        _undecided_time_1, = side_undecided(_rate_1, _margin_1, _height_1, _undecided_time_1, _double(_velocity_error_1))
        _rows5, _count6 = _most(_possible_1, _count4)
        if _count6:
            _clearance_2, _delay_2, _earliest_delay_2, _extent_2, _p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_top_2, _p_bridge_half_width_2, _p_end_depth_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _position_error_2, _speed_2, _time_2, _undecided_time_2, _velocity_error_2, _vx_2, _vy_2, _vz_2, _when_2, _which_2, _x_2, _y_2, _z_2 = _taken(_rows5, _clearance_1, _delay_1, _earliest_delay_1, _extent_1, _p_ball_radius_1, _p_board_bottom_1, _p_board_distance_1, _p_board_half_width_1, _p_board_top_1, _p_bridge_half_width_1, _p_end_depth_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _position_error_1, _speed_1, _time_1, _undecided_time_1, _velocity_error_1, _vx_1, _vy_1, _vz_1, _when_1, _which_1, _x_1, _y_1, _z_1)
            _room_2 = room(_count6)
            _, _there_y_2, _there_z_2, *_ = flight(_time_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_gravity_2, _room_2)
            _g0_2, _g1_2, _g2_2, _g3_2 = backboard_bounds(_there_y_2, _there_z_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2)
            _slack_2, = displacement(_delay_2, _time_2, _extent_2, _speed_2, _double(_position_error_2), _double(_velocity_error_2), _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_bridge_half_width_2, _p_gravity_2, _p_end_depth_2, _room_2)
            _undecided_2, = backboard_edges(_clearance_2, _slack_2, _g0_2, _g1_2, _g2_2, _g3_2)
            _undecided_time_2, = bounds_undecided(_time_2, _undecided_time_2, _undecided_2)
            _arrives_2, = backboard_within(_g0_2, _g1_2, _g2_2, _g3_2)
            _undecided_time_2, _earliest_delay_2 = tie_undecided(_time_2, _when_2, _delay_2, _earliest_delay_2, _undecided_time_2, _arrives_2, _room_2)
            _when_2, _which_2 = earliest(1.0, _time_2, _when_2, _which_2, _arrives_2)
            _earliest_delay_1, _undecided_time_1, _when_1, _which_1 = _put(_rows5, _count4, (_earliest_delay_1, _undecided_time_1, _when_1, _which_1,), (_earliest_delay_2, _undecided_time_2, _when_2, _which_2,), _possible_1)
        _leaving_1, = left(2.0, _last_1)
        _time_1, _rate_1, _bend_1, _apex_1, _height_1 = bridge_arrival(_leaving_1, _z_1, _vz_1, _p_ball_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _arrives_1, _ceiling_1, _nearest_1 = plane_root(_rate_1, _bend_1, _apex_1, _time_1)
        _margin_1, = bridge_margin(_nearest_1, _extent_1, _speed_1, _double(_position_error_1), _double(_velocity_error_1), _p_ball_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _clearance_1, _delay_1 = crossing(_margin_1, 0.0, _rate_1, _ceiling_1, _room_1)
        _possible_1, = within_time(_time_1, _when_1, _delay_1, _earliest_delay_1, _arrives_1)
        _undecided_time_1, = apex_undecided(_margin_1, _apex_1, _height_1, _undecided_time_1)
        _rows7, _count8 = _most(_possible_1, _count4)
        if _count8:
            _clearance_2, _delay_2, _earliest_delay_2, _extent_2, _p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_top_2, _p_bridge_half_width_2, _p_end_depth_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _position_error_2, _speed_2, _time_2, _undecided_time_2, _velocity_error_2, _vx_2, _vy_2, _vz_2, _when_2, _which_2, _x_2, _y_2, _z_2 = _taken(_rows7, _clearance_1, _delay_1, _earliest_delay_1, _extent_1, _p_ball_radius_1, _p_board_bottom_1, _p_board_distance_1, _p_board_half_width_1, _p_board_top_1, _p_bridge_half_width_1, _p_end_depth_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _position_error_1, _speed_1, _time_1, _undecided_time_1, _velocity_error_1, _vx_1, _vy_1, _vz_1, _when_1, _which_1, _x_1, _y_1, _z_1)
            _room_2 = room(_count8)
            _there_x_2, _there_y_2, *_ = flight(_time_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_gravity_2, _room_2)
            _g0_2, _g1_2, _g2_2, _g3_2, _g4_2 = bridge_bounds(_there_x_2, _there_y_2, _p_ring_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _room_2)
            _slack_2, = displacement(_delay_2, _time_2, _extent_2, _speed_2, _double(_position_error_2), _double(_velocity_error_2), _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_bridge_half_width_2, _p_gravity_2, _p_end_depth_2, _room_2)
            _undecided_2, = bridge_edges(_clearance_2, _slack_2, _g0_2, _g1_2, _g2_2, _g3_2, _g4_2)
            _undecided_time_2, = bounds_undecided(_time_2, _undecided_time_2, _undecided_2)
            _arrives_2, = bridge_within(_g0_2, _g1_2, _g2_2, _g3_2, _g4_2)
            _undecided_time_2, _earliest_delay_2 = tie_undecided(_time_2, _when_2, _delay_2, _earliest_delay_2, _undecided_time_2, _arrives_2, _room_2)
            _when_2, _which_2 = earliest(2.0, _time_2, _when_2, _which_2, _arrives_2)
            _earliest_delay_1, _undecided_time_1, _when_1, _which_1 = _put(_rows7, _count4, (_earliest_delay_1, _undecided_time_1, _when_1, _which_1,), (_earliest_delay_2, _undecided_time_2, _when_2, _which_2,), _possible_1)
        _undecided_time_1, = plane_start(_p_gravity_1, _undecided_time_1, _double(_position_error_1), _double(_velocity_error_1))
        _earliest_delay_0, _undecided_time_0, _when_0, _which_0 = _put(_rows3, shots, (_earliest_delay_0, _undecided_time_0, _when_0, _which_0,), (_earliest_delay_1, _undecided_time_1, _when_1, _which_1,))
    _until_0, _pad_0 = horizon(_when_0, _speed_0, _p_gravity_0)
    _undecided_time_0, = overdue(_pad_0, _earliest_delay_0, _undecided_time_0)
    _clear_0, = ring_clear(_until_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _extent_0, _speed_0, _double(_position_error_0), _double(_velocity_error_0), _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_gravity_0, _room_0)
    _open_0, = opens(_clear_0)
    _rows9, _count10 = _rows(_open_0, shots)
    if (0 < _count10) and (_count10 <= ALONE):
        _earliest_delay_0, _undecided_time_0, _when_0, _which_0 = _copies(shots, _earliest_delay_0, _undecided_time_0, _when_0, _which_0)
        _one_by_one(_alone5, _rows9, _rows9, (_earliest_delay_0, _extent_0, _last_0, _p_ball_radius_0, _p_gravity_0, _p_ring_radius_0, _p_wire_radius_0, _pad_0, _position_error_0, _speed_0, _undecided_time_0, _until_0, _velocity_error_0, _vx_0, _vy_0, _vz_0, _when_0, _which_0, _x_0, _y_0, _z_0,), (), (_earliest_delay_0, _undecided_time_0, _when_0, _which_0,))
    elif _count10:
        _earliest_delay_1, _extent_1, _last_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _pad_1, _position_error_1, _speed_1, _undecided_time_1, _until_1, _velocity_error_1, _vx_1, _vy_1, _vz_1, _when_1, _which_1, _x_1, _y_1, _z_1 = _taken(_rows9, _earliest_delay_0, _extent_0, _last_0, _p_ball_radius_0, _p_gravity_0, _p_ring_radius_0, _p_wire_radius_0, _pad_0, _position_error_0, _speed_0, _undecided_time_0, _until_0, _velocity_error_0, _vx_0, _vy_0, _vz_0, _when_0, _which_0, _x_0, _y_0, _z_0)
        _room_1 = room(_count10)
        _share_1, _arrival_1, _certain_1 = beginning()
        _leaving_1, = left(0.0, _last_1)
        _onset_1, _wide_end_1, _searching_1, _wide_low1_1, _wide_high1_1, _wide_low2_1, _wide_high2_1, _lapsed_1, _representable_1 = ring_opened(_until_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _since_1, _latest_1 = opened(_double(_lapsed_1), _double(_onset_1))
        _rho_start_1, _start_rate_1, _rho_rate_1 = ring_started(_x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ring_radius_1, _room_1)
        _near_x_1, _near_y_1, _near_z_1, _, _, _near_vz_1 = flight(_since_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_gravity_1, _room_1)
        _short_share_1, _short_t_1, _short_end_1, _short_x_1, _short_y_1, _short_z_1, _short_vx_1, _short_vy_1, _short_vz_1, _short_energy2_1, _short_moment2_1, _short_rho_start_1, _short_ceiling_1, _short_flat_1, _short_tilt_1, _short_jerk_1, _short_quotient_margin_1, _short_start_rate_1, _short_rho_rate_1, _short_rate_margin_1, _short_low1_1, _short_high1_1, _short_low2_1, _short_high2_1, _fits_1 = ring_resolution(_onset_1, _wide_end_1, _leaving_1, _lapsed_1, _near_x_1, _near_y_1, _near_z_1, _vx_1, _vy_1, _near_vz_1, _extent_1, _speed_1, _start_rate_1, _rho_rate_1, _wide_low1_1, _wide_high1_1, _wide_low2_1, _wide_high2_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _stepping_1, _searching_1, _single_precision_1, _ceiling_1, _flat_1, _tilt_1, _allowing_1 = coarse(_double(_short_rate_margin_1), _double(_short_flat_1), _double(_short_ceiling_1), _double(_short_share_1), _searching_1, _representable_1, _fits_1)
        _excess_1, = ring_coarse_excess(_allowing_1, _latest_1, _extent_1, _speed_1, _double(_position_error_1), _double(_velocity_error_1), _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _budget_exceeded_1, = ring_budget_exceeded(_until_1, _extent_1, _speed_1, _double(_position_error_1), _double(_velocity_error_1), _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _undecided_time_1, = out_of_budget(_pad_1, _budget_exceeded_1, _earliest_delay_1, _undecided_time_1, _excess_1)
        _rows11, _count12 = _most(_stepping_1, _count10)
        if _count12:
            _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _short_ceiling_2, _short_end_2, _short_energy2_2, _short_flat_2, _short_high1_2, _short_high2_2, _short_jerk_2, _short_low1_2, _short_low2_2, _short_moment2_2, _short_quotient_margin_2, _short_rate_margin_2, _short_rho_rate_2, _short_rho_start_2, _short_start_rate_2, _short_t_2, _short_tilt_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_x_2, _short_y_2, _short_z_2 = _taken(_rows11, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _short_ceiling_1, _short_end_1, _short_energy2_1, _short_flat_1, _short_high1_1, _short_high2_1, _short_jerk_1, _short_low1_1, _short_low2_1, _short_moment2_1, _short_quotient_margin_1, _short_rate_margin_1, _short_rho_rate_1, _short_rho_start_1, _short_start_rate_1, _short_t_1, _short_tilt_1, _short_vx_1, _short_vy_1, _short_vz_1, _short_x_1, _short_y_1, _short_z_1)
            _room_2 = room(_count12)
            _short_t_2, _short_end_2, _certain_2, _stepping_2 = ring_step(_short_t_2, _short_end_2, _short_rate_margin_2, _short_ceiling_2, _short_x_2, _short_y_2, _short_z_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_energy2_2, _short_moment2_2, _short_rho_start_2, _short_flat_2, _short_tilt_2, _short_quotient_margin_2, _short_jerk_2, _short_start_rate_2, _short_rho_rate_2, _short_low1_2, _short_high1_2, _short_low2_2, _short_high2_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _certain_1, _short_end_1, _short_t_1, _stepping_1 = _put(_rows11, _count10, (_certain_1, _short_end_1, _short_t_1, _stepping_1,), (_certain_2, _short_end_2, _short_t_2, _stepping_2,), _stepping_1)
        _rows13, _count14 = _rows(_stepping_1, _count10)
        if (0 < _count14) and (_count14 <= ALONE):
            _certain_1, _short_t_1 = _copies(_count10, _certain_1, _short_t_1)
            _one_by_one(_alone6, _rows13, _rows13, (_certain_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _short_ceiling_1, _short_end_1, _short_energy2_1, _short_flat_1, _short_high1_1, _short_high2_1, _short_jerk_1, _short_low1_1, _short_low2_1, _short_moment2_1, _short_quotient_margin_1, _short_rate_margin_1, _short_rho_rate_1, _short_rho_start_1, _short_start_rate_1, _short_t_1, _short_tilt_1, _short_vx_1, _short_vy_1, _short_vz_1, _short_x_1, _short_y_1, _short_z_1, _stepping_1,), (), (_certain_1, _short_t_1,), 24)
        elif _count14:
            _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _short_ceiling_2, _short_end_2, _short_energy2_2, _short_flat_2, _short_high1_2, _short_high2_2, _short_jerk_2, _short_low1_2, _short_low2_2, _short_moment2_2, _short_quotient_margin_2, _short_rate_margin_2, _short_rho_rate_2, _short_rho_start_2, _short_start_rate_2, _short_t_2, _short_tilt_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_x_2, _short_y_2, _short_z_2, _stepping_2 = _taken(_rows13, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _short_ceiling_1, _short_end_1, _short_energy2_1, _short_flat_1, _short_high1_1, _short_high2_1, _short_jerk_1, _short_low1_1, _short_low2_1, _short_moment2_1, _short_quotient_margin_1, _short_rate_margin_1, _short_rho_rate_1, _short_rho_start_1, _short_start_rate_1, _short_t_1, _short_tilt_1, _short_vx_1, _short_vy_1, _short_vz_1, _short_x_1, _short_y_1, _short_z_1, _stepping_1)
            _certain_1, _short_t_1 = _copies(_count10, _certain_1, _short_t_1)
            for _turn15 in range(24):
                _room_2 = room(_count14)
                _short_t_2, _short_end_2, _certain_2, _stepping_2 = ring_step(_short_t_2, _short_end_2, _short_rate_margin_2, _short_ceiling_2, _short_x_2, _short_y_2, _short_z_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_energy2_2, _short_moment2_2, _short_rho_start_2, _short_flat_2, _short_tilt_2, _short_quotient_margin_2, _short_jerk_2, _short_start_rate_2, _short_rho_rate_2, _short_low1_2, _short_high1_2, _short_low2_2, _short_high2_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
                _going16 = _where_true(_stepping_2)
                if len(_going16) == _count14:
                    continue
                _done = _where_true(_logical_not(_stepping_2))
                _store((_certain_1, _short_t_1,), _of(_rows13, _done), (_certain_2, _short_t_2,), _done)
                _rows13 = _of(_rows13, _going16)
                _count14 = len(_going16)
                if _count14 == 0:
                    break
                if _count14 <= ALONE:
                    _one_by_one(_alone6, _rows13, _going16, (_certain_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _short_ceiling_2, _short_end_2, _short_energy2_2, _short_flat_2, _short_high1_2, _short_high2_2, _short_jerk_2, _short_low1_2, _short_low2_2, _short_moment2_2, _short_quotient_margin_2, _short_rate_margin_2, _short_rho_rate_2, _short_rho_start_2, _short_start_rate_2, _short_t_2, _short_tilt_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_x_2, _short_y_2, _short_z_2, _stepping_2,), (), (_certain_1, _short_t_1,), 23 - _turn15)
                    break
                _certain_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _short_ceiling_2, _short_end_2, _short_energy2_2, _short_flat_2, _short_high1_2, _short_high2_2, _short_jerk_2, _short_low1_2, _short_low2_2, _short_moment2_2, _short_quotient_margin_2, _short_rate_margin_2, _short_rho_rate_2, _short_rho_start_2, _short_start_rate_2, _short_t_2, _short_tilt_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_x_2, _short_y_2, _short_z_2, _stepping_2 = _taken(_going16, _certain_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _short_ceiling_2, _short_end_2, _short_energy2_2, _short_flat_2, _short_high1_2, _short_high2_2, _short_jerk_2, _short_low1_2, _short_low2_2, _short_moment2_2, _short_quotient_margin_2, _short_rate_margin_2, _short_rho_rate_2, _short_rho_start_2, _short_start_rate_2, _short_t_2, _short_tilt_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_x_2, _short_y_2, _short_z_2, _stepping_2)
            else:
                _store((_certain_1, _short_t_1,), _rows13, (_certain_2, _short_t_2,), None)
        _arrival_1, _t_1, _searching_1 = stepped(_arrival_1, _double(_short_t_1), _searching_1, _since_1, _single_precision_1, _certain_1)
        _rows17, _count18 = _rows(_searching_1, _count10)
        if (0 < _count18) and (_count18 <= ALONE):
            _arrival_1, _ceiling_1, _certain_1, _flat_1, _latest_1, _rho_start_1, _tilt_1, _undecided_time_1 = _copies(_count10, _arrival_1, _ceiling_1, _certain_1, _flat_1, _latest_1, _rho_start_1, _tilt_1, _undecided_time_1)
            _one_by_one(_alone7, _rows17, _rows17, (_arrival_1, _certain_1, _extent_1, _last_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _position_error_1, _share_1, _speed_1, _t_1, _undecided_time_1, _until_1, _velocity_error_1, _vx_1, _vy_1, _vz_1, _x_1, _y_1, _z_1,), (), (_arrival_1, _ceiling_1, _certain_1, _flat_1, _latest_1, _rho_start_1, _tilt_1, _undecided_time_1,))
        elif _count18:
            _arrival_2, _certain_2, _extent_2, _last_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _position_error_2, _share_2, _speed_2, _t_2, _undecided_time_2, _until_2, _velocity_error_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2 = _taken(_rows17, _arrival_1, _certain_1, _extent_1, _last_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _position_error_1, _share_1, _speed_1, _t_1, _undecided_time_1, _until_1, _velocity_error_1, _vx_1, _vy_1, _vz_1, _x_1, _y_1, _z_1)
            _room_2 = room(_count18)
            _energy2_2, _moment2_2, _rho_start_2, _low0_2, _high0_2, _low1_2, _high1_2, _low2_2, _high2_2, _ceiling_2, _latest_2, *_ = ring_prepare(_until_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _extent_2, _speed_2, _double(_position_error_2), _double(_velocity_error_2), _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _excess_2, = ring_excess(_share_2, _latest_2, _extent_2, _speed_2, _double(_position_error_2), _double(_velocity_error_2), _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _position_level_2, _velocity_level_2, *_ = allowance(_share_2, _latest_2, _extent_2, _speed_2, _double(_position_error_2), _double(_velocity_error_2), _p_gravity_2, _room_2)
            _flat_2, _tilt_2, _rate_slack_2 = ring_margins(_latest_2, _extent_2, _speed_2, _position_level_2, _velocity_level_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _undecided_time_2, = budget_undecided(_t_2, _undecided_time_2, _excess_2)
            _t_2, _end_2, _searching_2 = ring_enter(_t_2, 0.0, _t_2, _low0_2, _low1_2, _low2_2, _high0_2, _high1_2, _high2_2, _room_2)
            _rows19, _count20 = _rows(_searching_2, _count18)
            if (0 < _count20) and (_count20 <= ALONE):
                _arrival_2, _certain_2, _flat_2, _searching_2, _t_2, _tilt_2, _undecided_time_2 = _copies(_count18, _arrival_2, _certain_2, _flat_2, _searching_2, _t_2, _tilt_2, _undecided_time_2)
                _one_by_one(_alone8, _rows19, _rows19, (_arrival_2, _ceiling_2, _certain_2, _end_2, _energy2_2, _flat_2, _last_2, _moment2_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _rate_slack_2, _rho_start_2, _searching_2, _share_2, _t_2, _tilt_2, _undecided_time_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2, _extent_2, _high0_2, _high1_2, _high2_2, _latest_2, _low0_2, _low1_2, _low2_2, _position_error_2, _speed_2, _velocity_error_2,), (), (_arrival_2, _certain_2, _flat_2, _searching_2, _t_2, _tilt_2, _undecided_time_2,), 201)
            elif _count20:
                _arrival_3, _ceiling_3, _certain_3, _end_3, _energy2_3, _flat_3, _last_3, _moment2_3, _p_ball_radius_3, _p_gravity_3, _p_ring_radius_3, _p_wire_radius_3, _rate_slack_3, _rho_start_3, _searching_3, _share_3, _t_3, _tilt_3, _undecided_time_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3 = _taken(_rows19, _arrival_2, _ceiling_2, _certain_2, _end_2, _energy2_2, _flat_2, _last_2, _moment2_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _rate_slack_2, _rho_start_2, _searching_2, _share_2, _t_2, _tilt_2, _undecided_time_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2)
                _arrival_2, _certain_2, _flat_2, _searching_2, _t_2, _tilt_2, _undecided_time_2 = _copies(_count18, _arrival_2, _certain_2, _flat_2, _searching_2, _t_2, _tilt_2, _undecided_time_2)
                for _turn21 in range(201):
                    _room_3 = room(_count20)
                    _leaving_3, _margin_3 = nearby(_t_3, _flat_3, _tilt_3, 0.0, _last_3)
                    _gap_3, _rate_3, _bend_3, _step_3, _next_3, _clearance_3 = ring_advance(_t_3, _end_3, _leaving_3, _margin_3, _rate_slack_3, _ceiling_3, _x_3, _y_3, _z_3, _vx_3, _vy_3, _vz_3, _energy2_3, _moment2_3, _rho_start_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_gravity_3, _room_3)
                    _hit_3, _sure_3, _needs_refinement_3 = gap_closes(_gap_3, _rate_3, _bend_3, _margin_3, _rate_slack_3, _clearance_3, _share_3)
                    _rows22, _count23 = _most(_needs_refinement_3, _count20)
                    if _count23:
                        _far = _of(_rows19, _rows22)
                        _extent_4, _latest_4, _position_error_4, _speed_4, _velocity_error_4 = _taken(_far, _extent_2, _latest_2, _position_error_2, _speed_2, _velocity_error_2)
                        _p_ball_radius_4, _p_gravity_4, _p_ring_radius_4, _p_wire_radius_4, _share_4, _t_4, _undecided_time_4 = _taken(_rows22, _p_ball_radius_3, _p_gravity_3, _p_ring_radius_3, _p_wire_radius_3, _share_3, _t_3, _undecided_time_3)
                        _room_4 = room(_count23)
                        _share_4, = smaller_budget(_share_4)
                        _excess_4, = ring_excess(_share_4, _latest_4, _extent_4, _speed_4, _double(_position_error_4), _double(_velocity_error_4), _p_ball_radius_4, _p_ring_radius_4, _p_wire_radius_4, _p_gravity_4, _room_4)
                        _position_level_4, _velocity_level_4, *_ = allowance(_share_4, _latest_4, _extent_4, _speed_4, _double(_position_error_4), _double(_velocity_error_4), _p_gravity_4, _room_4)
                        _flat_4, _tilt_4, _rate_slack_4 = ring_margins(_latest_4, _extent_4, _speed_4, _position_level_4, _velocity_level_4, _p_ball_radius_4, _p_ring_radius_4, _p_wire_radius_4, _p_gravity_4, _room_4)
                        _undecided_time_4, = budget_undecided(_t_4, _undecided_time_4, _excess_4)
                        _flat_3, _rate_slack_3, _share_3, _tilt_3, _undecided_time_3 = _put(_rows22, _count20, (_flat_3, _rate_slack_3, _share_3, _tilt_3, _undecided_time_3,), (_flat_4, _rate_slack_4, _share_4, _tilt_4, _undecided_time_4,), _needs_refinement_3)
                    _arrival_3, _certain_3, _exhausted_3, _searching_3, _t_3 = advanced(_t_3, _end_3, _step_3, _next_3, _arrival_3, _hit_3, _sure_3, _needs_refinement_3, _certain_3)
                    _rows24, _count25 = _most(_exhausted_3, _count20)
                    if _count25:
                        _far = _of(_rows19, _rows24)
                        _high0_4, _high1_4, _high2_4, _low0_4, _low1_4, _low2_4 = _taken(_far, _high0_2, _high1_2, _high2_2, _low0_2, _low1_2, _low2_2)
                        _end_4, _t_4 = _taken(_rows24, _end_3, _t_3)
                        _room_4 = room(_count25)
                        _t_4, _end_4, _searching_4 = ring_enter(_t_4, _end_4, _end_4, _low0_4, _low1_4, _low2_4, _high0_4, _high1_4, _high2_4, _room_4)
                        _end_3, _searching_3, _t_3 = _put(_rows24, _count20, (_end_3, _searching_3, _t_3,), (_end_4, _searching_4, _t_4,), _exhausted_3)
                    _going26 = _where_true(_searching_3)
                    if len(_going26) == _count20:
                        continue
                    _done = _where_true(_logical_not(_searching_3))
                    _store((_arrival_2, _certain_2, _flat_2, _searching_2, _t_2, _tilt_2, _undecided_time_2,), _of(_rows19, _done), (_arrival_3, _certain_3, _flat_3, _searching_3, _t_3, _tilt_3, _undecided_time_3,), _done)
                    _rows19 = _of(_rows19, _going26)
                    _count20 = len(_going26)
                    if _count20 == 0:
                        break
                    if _count20 <= ALONE:
                        _one_by_one(_alone8, _rows19, _going26, (_arrival_3, _ceiling_3, _certain_3, _end_3, _energy2_3, _flat_3, _last_3, _moment2_3, _p_ball_radius_3, _p_gravity_3, _p_ring_radius_3, _p_wire_radius_3, _rate_slack_3, _rho_start_3, _searching_3, _share_3, _t_3, _tilt_3, _undecided_time_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3,), (_extent_2, _high0_2, _high1_2, _high2_2, _latest_2, _low0_2, _low1_2, _low2_2, _position_error_2, _speed_2, _velocity_error_2,), (_arrival_2, _certain_2, _flat_2, _searching_2, _t_2, _tilt_2, _undecided_time_2,), 200 - _turn21)
                        break
                    _arrival_3, _ceiling_3, _certain_3, _end_3, _energy2_3, _flat_3, _last_3, _moment2_3, _p_ball_radius_3, _p_gravity_3, _p_ring_radius_3, _p_wire_radius_3, _rate_slack_3, _rho_start_3, _searching_3, _share_3, _t_3, _tilt_3, _undecided_time_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3 = _taken(_going26, _arrival_3, _ceiling_3, _certain_3, _end_3, _energy2_3, _flat_3, _last_3, _moment2_3, _p_ball_radius_3, _p_gravity_3, _p_ring_radius_3, _p_wire_radius_3, _rate_slack_3, _rho_start_3, _searching_3, _share_3, _t_3, _tilt_3, _undecided_time_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3)
                else:
                    _store((_arrival_2, _certain_2, _flat_2, _searching_2, _t_2, _tilt_2, _undecided_time_2,), _rows19, (_arrival_3, _certain_3, _flat_3, _searching_3, _t_3, _tilt_3, _undecided_time_3,), None)
            _undecided_time_2, = predicate_undecided(_t_2, _undecided_time_2, _searching_2)
            _arrival_1, _ceiling_1, _certain_1, _flat_1, _latest_1, _rho_start_1, _tilt_1, _undecided_time_1 = _put(_rows17, _count10, (_arrival_1, _ceiling_1, _certain_1, _flat_1, _latest_1, _rho_start_1, _tilt_1, _undecided_time_1,), (_arrival_2, _ceiling_2, _certain_2, _flat_2, _latest_2, _rho_start_2, _tilt_2, _undecided_time_2,))
        _arrives_1, _refining_1, _rate_1 = found(_arrival_1)
        _leaving_1, *_ = nearby(_arrival_1, _flat_1, _tilt_1, 0.0, _last_1)
        _rows27, _count28 = _most(_refining_1, _count10)
        if _count28:
            _arrival_2, _ceiling_2, _certain_2, _leaving_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _rho_start_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2 = _taken(_rows27, _arrival_1, _ceiling_1, _certain_1, _leaving_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _rho_start_1, _vx_1, _vy_1, _vz_1, _x_1, _y_1, _z_1)
            _room_2 = room(_count28)
            _refined_2, _gap_2, _rate_2 = ring_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _rho_start_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = refined_root(_gap_2, _rate_2, _ceiling_2, _arrival_2, _refined_2, _certain_2)
            _arrival_1, _rate_1, _refining_1 = _put(_rows27, _count10, (_arrival_1, _rate_1, _refining_1,), (_arrival_2, _rate_2, _refining_2,), _refining_1)
        _rows29, _count30 = _most(_refining_1, _count10)
        if _count30:
            _arrival_2, _ceiling_2, _certain_2, _leaving_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _rho_start_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2 = _taken(_rows29, _arrival_1, _ceiling_1, _certain_1, _leaving_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _rho_start_1, _vx_1, _vy_1, _vz_1, _x_1, _y_1, _z_1)
            _room_2 = room(_count30)
            _refined_2, _gap_2, _rate_2 = ring_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _rho_start_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = refined_root(_gap_2, _rate_2, _ceiling_2, _arrival_2, _refined_2, _certain_2)
            _arrival_1, _rate_1, _refining_1 = _put(_rows29, _count10, (_arrival_1, _rate_1, _refining_1,), (_arrival_2, _rate_2, _refining_2,), _refining_1)
        _rows31, _count32 = _rows(_refining_1, _count10)
        if (0 < _count32) and (_count32 <= ALONE):
            _arrival_1, _rate_1 = _copies(_count10, _arrival_1, _rate_1)
            _one_by_one(_alone9, _rows31, _rows31, (_arrival_1, _ceiling_1, _certain_1, _leaving_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _rate_1, _refining_1, _rho_start_1, _vx_1, _vy_1, _vz_1, _x_1, _y_1, _z_1,), (), (_arrival_1, _rate_1,), 8)
        elif _count32:
            _arrival_2, _ceiling_2, _certain_2, _leaving_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _refining_2, _rho_start_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2 = _taken(_rows31, _arrival_1, _ceiling_1, _certain_1, _leaving_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _refining_1, _rho_start_1, _vx_1, _vy_1, _vz_1, _x_1, _y_1, _z_1)
            _arrival_1, _rate_1 = _copies(_count10, _arrival_1, _rate_1)
            for _turn33 in range(8):
                _room_2 = room(_count32)
                _refined_2, _gap_2, _rate_2 = ring_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _rho_start_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
                _arrival_2, _refining_2 = refined_root(_gap_2, _rate_2, _ceiling_2, _arrival_2, _refined_2, _certain_2)
                _going34 = _where_true(_refining_2)
                if len(_going34) == _count32:
                    continue
                _done = _where_true(_logical_not(_refining_2))
                _store((_arrival_1, _rate_1,), _of(_rows31, _done), (_arrival_2, _rate_2,), _done)
                _rows31 = _of(_rows31, _going34)
                _count32 = len(_going34)
                if _count32 == 0:
                    break
                if _count32 <= ALONE:
                    _one_by_one(_alone9, _rows31, _going34, (_arrival_2, _ceiling_2, _certain_2, _leaving_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _rate_2, _refining_2, _rho_start_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2,), (), (_arrival_1, _rate_1,), 7 - _turn33)
                    break
                _arrival_2, _ceiling_2, _certain_2, _leaving_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _rate_2, _refining_2, _rho_start_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2 = _taken(_going34, _arrival_2, _ceiling_2, _certain_2, _leaving_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _rate_2, _refining_2, _rho_start_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2)
            else:
                _store((_arrival_1, _rate_1,), _rows31, (_arrival_2, _rate_2,), None)
        _flat_1, _tilt_1, _rate_margin_1 = ring_margins(_latest_1, _extent_1, _speed_1, _double(_position_error_1), _double(_velocity_error_1), _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _margin_1, = own_margin(_leaving_1, _flat_1, _tilt_1, _arrival_1)
        _clearance_1, _delay_1 = crossing(_margin_1, _rate_margin_1, _rate_1, _ceiling_1, _room_1)
        _time_1, = arrival_time(_arrival_1)
        _delay_1, _undecided_time_1 = arrival_certainty(_clearance_1, _time_1, _delay_1, _undecided_time_1, _arrives_1, _certain_1)
        _undecided_time_1, _earliest_delay_1 = tie_undecided(_time_1, _when_1, _delay_1, _earliest_delay_1, _undecided_time_1, _arrives_1, _room_1)
        _when_1, _which_1 = earliest(0.0, _time_1, _when_1, _which_1, _arrives_1)
        _earliest_delay_0, _undecided_time_0, _when_0, _which_0 = _put(_rows9, shots, (_earliest_delay_0, _undecided_time_0, _when_0, _which_0,), (_earliest_delay_1, _undecided_time_1, _when_1, _which_1,))
    _rows35, _count36 = _most(_limited_0, shots)
    if _count36:
        _clock_1, _earliest_delay_1, _time_error_1, _time_limit_1, _undecided_time_1, _when_1, _which_1 = _taken(_rows35, _clock_0, _earliest_delay_0, _time_error_0, _time_limit_0, _undecided_time_0, _when_0, _which_0)
        _room_1 = room(_count36)
        _time_1, _delay_1, _arrives_1, _undecided_time_1 = expiry(_when_1, _which_1, _earliest_delay_1, _undecided_time_1, _double(_time_error_1), _clock_1, _time_limit_1)
        _undecided_time_1, _earliest_delay_1 = tie_undecided(_time_1, _when_1, _delay_1, _earliest_delay_1, _undecided_time_1, _arrives_1, _room_1)
        _when_1, _which_1 = earliest(4.0, _time_1, _when_1, _which_1, _arrives_1)
        _earliest_delay_0, _undecided_time_0, _when_0, _which_0 = _put(_rows35, shots, (_earliest_delay_0, _undecided_time_0, _when_0, _which_0,), (_earliest_delay_1, _undecided_time_1, _when_1, _which_1,), _limited_0)
    _, _moves_0, _ends_0, _touches_0, _reached_0, _edge_0 = departed(3.0, _which_0)
    _body_0, = body_of(_which_0)
    _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1 = flight(_when_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _p_gravity_0, _room_0)
    _clock_1, = event_clock(_when_0, _clock_0)
    _clock_0, _vx_0, _vy_0, _vz_0, _x_0, _y_0, _z_0 = _choose(_moves_0, (_clock_1, _vx_1, _vy_1, _vz_1, _x_1, _y_1, _z_1,), (_clock_0, _vx_0, _vy_0, _vz_0, _x_0, _y_0, _z_0,))
    _rows37, _count38 = _most(_limited_0, shots)
    if _count38:
        _body_1, _clock_1, _ends_1, _reached_1, _time_limit_1, _which_1 = _taken(_rows37, _body_0, _clock_0, _ends_0, _reached_0, _time_limit_0, _which_0)
        _clock_1, _body_1, _reached_1, _ends_1 = expired(4.0, _which_1, _body_1, _clock_1, _reached_1, _time_limit_1, _ends_1)
        _body_0, _clock_0, _ends_0, _reached_0 = _put(_rows37, shots, (_body_0, _clock_0, _ends_0, _reached_0,), (_body_1, _clock_1, _ends_1, _reached_1,), _limited_0)
    _slack_0, = displacement(_earliest_delay_0, _when_0, _extent_0, _speed_0, _double(_position_error_0), _double(_velocity_error_0), _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_bridge_half_width_0, _p_gravity_0, _p_end_depth_0, _room_0)
    _here_0, = here(3.0, _which_0)
    _g0_1, = end_bounds(_x_0, _y_0, _p_ring_radius_0)
    _reached_1, = end_reached(_g0_1)
    _edge_1, = end_edge(_slack_0, _g0_1)
    _edge_0, _reached_0 = _choose(_here_0, (_edge_1, _reached_1,), (_edge_0, _reached_0,))
    _uncertain_0, = flight_undecided(_when_0, _earliest_delay_0, _undecided_time_0, _uncertain_0, _edge_0)
    _contacts_0, _outcome_0 = accounted(_contacts_0, _most_contacts_0, _reached_0, _touches_0)
    columns |= {"body": _body_0, "clock": _clock_0, "contacts": _contacts_0, "ends": _ends_0, "limited": _limited_0, "outcome": _outcome_0, "touches": _touches_0, "uncertain": _uncertain_0, "vx": _vx_0, "vy": _vy_0, "vz": _vz_0, "when": _when_0, "which": _which_0, "x": _x_0, "y": _y_0, "z": _z_0, }


def resolve_bounded(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage resolve of the event loop, with bounds on errors."""
    _body_0, _claims_0, _clock_0, _clock_error_0, _continued_0, _count_0_0, _count_1_0, _count_2_0, _ends_0, _first_0, _last_0, _left_bend_e_0, _left_bend_s_0, _left_ex_0, _left_ey_0, _left_nx_0, _left_ny_0, _left_nz_0, _limited_0, _origin_e_0, _origin_s_0, _origin_t_0, _origin_u_0, _origin_v_0, _origin_w_0, _outcome_0, _p_ball_radius_0, _p_board_distance_0, _p_gravity_0, _p_restitution_0, _p_ring_radius_0, _p_wire_radius_0, _pace_e_0, _pace_n_0, _pace_s_0, _place_e_0, _place_n_0, _place_s_0, _position_bound_0, _product_11_0, _product_12_0, _product_13_0, _product_14_0, _product_15_0, _product_16_0, _product_21_0, _product_22_0, _product_23_0, _product_24_0, _product_25_0, _product_26_0, _product_31_0, _product_32_0, _product_33_0, _product_34_0, _product_35_0, _product_36_0, _product_41_0, _product_42_0, _product_43_0, _product_44_0, _product_45_0, _product_46_0, _product_51_0, _product_52_0, _product_53_0, _product_54_0, _product_55_0, _product_56_0, _product_61_0, _product_62_0, _product_63_0, _product_64_0, _product_65_0, _product_66_0, _recent_e_0, _recent_s_0, _recent_t_0, _recent_u_0, _recent_v_0, _recent_w_0, _spin_bound_0, _tightening_0, _touches_0, _turn_n_0, _turn_z_0, _uncertain_0, _velocity_bound_0, _vx_0, _vy_0, _vz_0, _when_0, _which_0, _wx_0, _wy_0, _wz_0, _x_0, _y_0, _z_0, = map(columns.__getitem__, ("body", "claims", "clock", "clock_error", "continued", "count_0", "count_1", "count_2", "ends", "first", "last", "left_bend_e", "left_bend_s", "left_ex", "left_ey", "left_nx", "left_ny", "left_nz", "limited", "origin_e", "origin_s", "origin_t", "origin_u", "origin_v", "origin_w", "outcome", "p_ball_radius", "p_board_distance", "p_gravity", "p_restitution", "p_ring_radius", "p_wire_radius", "pace_e", "pace_n", "pace_s", "place_e", "place_n", "place_s", "position_bound", "product_11", "product_12", "product_13", "product_14", "product_15", "product_16", "product_21", "product_22", "product_23", "product_24", "product_25", "product_26", "product_31", "product_32", "product_33", "product_34", "product_35", "product_36", "product_41", "product_42", "product_43", "product_44", "product_45", "product_46", "product_51", "product_52", "product_53", "product_54", "product_55", "product_56", "product_61", "product_62", "product_63", "product_64", "product_65", "product_66", "recent_e", "recent_s", "recent_t", "recent_u", "recent_v", "recent_w", "spin_bound", "tightening", "touches", "turn_n", "turn_z", "uncertain", "velocity_bound", "vx", "vy", "vz", "when", "which", "wx", "wy", "wz", "x", "y", "z",))
    _meeting_0, = meeting(_claims_0, _ends_0, _touches_0)
    _rows1, _count2 = _rows(_meeting_0, shots)
    if _count2:
        _body_1, _clock_1, _clock_error_1, _continued_1, _count_0_1, _count_1_1, _count_2_1, _ends_1, _first_1, _last_1, _left_bend_e_1, _left_bend_s_1, _left_ex_1, _left_ey_1, _left_nx_1, _left_ny_1, _left_nz_1, _origin_e_1, _origin_s_1, _origin_t_1, _origin_u_1, _origin_v_1, _origin_w_1, _p_ball_radius_1, _p_board_distance_1, _p_gravity_1, _p_restitution_1, _p_ring_radius_1, _p_wire_radius_1, _pace_e_1, _pace_n_1, _pace_s_1, _place_e_1, _place_n_1, _place_s_1, _position_bound_1, _product_11_1, _product_12_1, _product_13_1, _product_14_1, _product_15_1, _product_16_1, _product_21_1, _product_22_1, _product_23_1, _product_24_1, _product_25_1, _product_26_1, _product_31_1, _product_32_1, _product_33_1, _product_34_1, _product_35_1, _product_36_1, _product_41_1, _product_42_1, _product_43_1, _product_44_1, _product_45_1, _product_46_1, _product_51_1, _product_52_1, _product_53_1, _product_54_1, _product_55_1, _product_56_1, _product_61_1, _product_62_1, _product_63_1, _product_64_1, _product_65_1, _product_66_1, _recent_e_1, _recent_s_1, _recent_t_1, _recent_u_1, _recent_v_1, _recent_w_1, _spin_bound_1, _tightening_1, _touches_1, _turn_n_1, _turn_z_1, _uncertain_1, _velocity_bound_1, _vx_1, _vy_1, _vz_1, _when_1, _which_1, _wx_1, _wy_1, _wz_1, _x_1, _y_1, _z_1 = _taken(_rows1, _body_0, _clock_0, _clock_error_0, _continued_0, _count_0_0, _count_1_0, _count_2_0, _ends_0, _first_0, _last_0, _left_bend_e_0, _left_bend_s_0, _left_ex_0, _left_ey_0, _left_nx_0, _left_ny_0, _left_nz_0, _origin_e_0, _origin_s_0, _origin_t_0, _origin_u_0, _origin_v_0, _origin_w_0, _p_ball_radius_0, _p_board_distance_0, _p_gravity_0, _p_restitution_0, _p_ring_radius_0, _p_wire_radius_0, _pace_e_0, _pace_n_0, _pace_s_0, _place_e_0, _place_n_0, _place_s_0, _position_bound_0, _product_11_0, _product_12_0, _product_13_0, _product_14_0, _product_15_0, _product_16_0, _product_21_0, _product_22_0, _product_23_0, _product_24_0, _product_25_0, _product_26_0, _product_31_0, _product_32_0, _product_33_0, _product_34_0, _product_35_0, _product_36_0, _product_41_0, _product_42_0, _product_43_0, _product_44_0, _product_45_0, _product_46_0, _product_51_0, _product_52_0, _product_53_0, _product_54_0, _product_55_0, _product_56_0, _product_61_0, _product_62_0, _product_63_0, _product_64_0, _product_65_0, _product_66_0, _recent_e_0, _recent_s_0, _recent_t_0, _recent_u_0, _recent_v_0, _recent_w_0, _spin_bound_0, _tightening_0, _touches_0, _turn_n_0, _turn_z_0, _uncertain_0, _velocity_bound_0, _vx_0, _vy_0, _vz_0, _when_0, _which_0, _wx_0, _wy_0, _wz_0, _x_0, _y_0, _z_0)
        _room_1 = room(_count2)
        _nx_1, _ny_1, _nz_1 = end_normal()
        _here_1, = here(0.0, _which_1)
        _nx_2, _ny_2, _nz_2 = ring_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _room_1)
        _count_0_2, = counted(_count_0_1)
        _count_0_1, _nx_1, _ny_1, _nz_1 = _choose(_here_1, (_count_0_2, _nx_2, _ny_2, _nz_2,), (_count_0_1, _nx_1, _ny_1, _nz_1,))
        _here_1, = here(1.0, _which_1)
        _nx_2, _ny_2, _nz_2 = backboard_normal()
        _count_1_2, = counted(_count_1_1)
        _count_1_1, _nx_1, _ny_1, _nz_1 = _choose(_here_1, (_count_1_2, _nx_2, _ny_2, _nz_2,), (_count_1_1, _nx_1, _ny_1, _nz_1,))
        _here_1, = here(2.0, _which_1)
        _nx_2, _ny_2, _nz_2 = bridge_normal()
        _count_2_2, = counted(_count_2_1)
        _count_2_1, _nx_1, _ny_1, _nz_1 = _choose(_here_1, (_count_2_2, _nx_2, _ny_2, _nz_2,), (_count_2_1, _nx_1, _ny_1, _nz_1,))
        _normal_velocity_1, = normal_velocity(_vx_1, _vy_1, _vz_1, _nx_1, _ny_1, _nz_1)
        _back_1, = came_back(_last_1, _which_1)
        _tangent_x_1, _tangent_y_1, _bend_s_1, _bend_e_1, _sharpest_bend_1, _root_offset_1, _root_level_1, _normal_rounding_1 = end_tangents(_when_1, _z_1, _vz_1, _p_gravity_1, _room_1)
        _here_1, = here(0.0, _which_1)
        _rows3, _count4 = _most(_here_1, _count2)
        if _count4:
            _back_2, _normal_velocity_2, _nx_2, _ny_2, _nz_2, _p_ball_radius_2, _p_gravity_2, _p_ring_radius_2, _p_wire_radius_2, _place_n_2, _vx_2, _vy_2, _vz_2, _when_2, _x_2, _y_2, _z_2 = _taken(_rows3, _back_1, _normal_velocity_1, _nx_1, _ny_1, _nz_1, _p_ball_radius_1, _p_gravity_1, _p_ring_radius_1, _p_wire_radius_1, _place_n_1, _vx_1, _vy_1, _vz_1, _when_1, _x_1, _y_1, _z_1)
            _room_2 = room(_count4)
            _tangent_x_2, _tangent_y_2, _bend_s_2, _bend_e_2, _sharpest_bend_2, _root_offset_2, _root_level_2, _normal_rounding_2 = ring_tangents(_when_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _nx_2, _ny_2, _nz_2, _place_n_2, _normal_velocity_2, _back_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _bend_e_1, _bend_s_1, _normal_rounding_1, _root_level_1, _root_offset_1, _sharpest_bend_1, _tangent_x_1, _tangent_y_1 = _put(_rows3, _count2, (_bend_e_1, _bend_s_1, _normal_rounding_1, _root_level_1, _root_offset_1, _sharpest_bend_1, _tangent_x_1, _tangent_y_1,), (_bend_e_2, _bend_s_2, _normal_rounding_2, _root_level_2, _root_offset_2, _sharpest_bend_2, _tangent_x_2, _tangent_y_2,), _here_1)
        _here_1, = here(1.0, _which_1)
        _tangent_x_2, _tangent_y_2, _bend_s_2, _bend_e_2, _sharpest_bend_2, _root_offset_2, _root_level_2, _normal_rounding_2 = backboard_tangents(_when_1, _x_1, _vx_1, _room_1)
        _bend_e_1, _bend_s_1, _normal_rounding_1, _root_level_1, _root_offset_1, _sharpest_bend_1, _tangent_x_1, _tangent_y_1 = _choose(_here_1, (_bend_e_2, _bend_s_2, _normal_rounding_2, _root_level_2, _root_offset_2, _sharpest_bend_2, _tangent_x_2, _tangent_y_2,), (_bend_e_1, _bend_s_1, _normal_rounding_1, _root_level_1, _root_offset_1, _sharpest_bend_1, _tangent_x_1, _tangent_y_1,))
        _here_1, = here(2.0, _which_1)
        _tangent_x_2, _tangent_y_2, _bend_s_2, _bend_e_2, _sharpest_bend_2, _root_offset_2, _root_level_2, _normal_rounding_2 = bridge_tangents(_when_1, _z_1, _vz_1, _p_gravity_1, _room_1)
        _bend_e_1, _bend_s_1, _normal_rounding_1, _root_level_1, _root_offset_1, _sharpest_bend_1, _tangent_x_1, _tangent_y_1 = _choose(_here_1, (_bend_e_2, _bend_s_2, _normal_rounding_2, _root_level_2, _root_offset_2, _sharpest_bend_2, _tangent_x_2, _tangent_y_2,), (_bend_e_1, _bend_s_1, _normal_rounding_1, _root_level_1, _root_offset_1, _sharpest_bend_1, _tangent_x_1, _tangent_y_1,))
        _rows5, _count6 = _most(_ends_1, _count2)
        if _count6:
            _clock_2, _clock_error_2, _normal_velocity_2, _p_gravity_2, _position_bound_2, _root_offset_2, _spin_bound_2, _velocity_bound_2, _vx_2, _vy_2, _vz_2, _when_2, _x_2, _y_2, _z_2 = _taken(_rows5, _clock_1, _clock_error_1, _normal_velocity_1, _p_gravity_1, _position_bound_1, _root_offset_1, _spin_bound_1, _velocity_bound_1, _vx_1, _vy_1, _vz_1, _when_1, _x_1, _y_1, _z_1)
            _room_2 = room(_count6)
            _position_bound_2, _velocity_bound_2, _spin_bound_2, _belated_2 = carry_end(_when_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _clock_2, _position_bound_2, _velocity_bound_2, _spin_bound_2, _root_offset_2, _normal_velocity_2, _p_gravity_2, _room_2)
            _clock_error_2, = clock_error_sum(_belated_2, _clock_error_2)
            _clock_error_1, _position_bound_1, _spin_bound_1, _velocity_bound_1 = _put(_rows5, _count2, (_clock_error_1, _position_bound_1, _spin_bound_1, _velocity_bound_1,), (_clock_error_2, _position_bound_2, _spin_bound_2, _velocity_bound_2,), _ends_1)
        _carries_1, _tightens_1 = tightens(_tightening_1, _touches_1)
        _rows7, _count8 = _most(_carries_1, _count2)
        if _count8:
            _back_2, _bend_e_2, _bend_s_2, _clock_2, _clock_error_2, _left_bend_e_2, _left_bend_s_2, _left_ex_2, _left_ey_2, _left_nx_2, _left_ny_2, _left_nz_2, _normal_rounding_2, _normal_velocity_2, _nx_2, _ny_2, _nz_2, _p_ball_radius_2, _p_gravity_2, _p_restitution_2, _pace_e_2, _pace_n_2, _pace_s_2, _place_e_2, _place_n_2, _place_s_2, _position_bound_2, _root_level_2, _root_offset_2, _sharpest_bend_2, _spin_bound_2, _tangent_x_2, _tangent_y_2, _turn_n_2, _turn_z_2, _velocity_bound_2, _vx_2, _vy_2, _vz_2, _when_2, _wx_2, _wy_2, _wz_2, _x_2, _y_2, _z_2 = _taken(_rows7, _back_1, _bend_e_1, _bend_s_1, _clock_1, _clock_error_1, _left_bend_e_1, _left_bend_s_1, _left_ex_1, _left_ey_1, _left_nx_1, _left_ny_1, _left_nz_1, _normal_rounding_1, _normal_velocity_1, _nx_1, _ny_1, _nz_1, _p_ball_radius_1, _p_gravity_1, _p_restitution_1, _pace_e_1, _pace_n_1, _pace_s_1, _place_e_1, _place_n_1, _place_s_1, _position_bound_1, _root_level_1, _root_offset_1, _sharpest_bend_1, _spin_bound_1, _tangent_x_1, _tangent_y_1, _turn_n_1, _turn_z_1, _velocity_bound_1, _vx_1, _vy_1, _vz_1, _when_1, _wx_1, _wy_1, _wz_1, _x_1, _y_1, _z_1)
            _room_2 = room(_count8)
            _place_n_2, _place_s_2, _place_e_2, _pace_n_2, _pace_s_2, _pace_e_2, _turn_n_2, _turn_z_2, _position_bound_2, _velocity_bound_2, _spin_bound_2, _left_nx_2, _left_ny_2, _left_nz_2, _left_ex_2, _left_ey_2, _left_bend_s_2, _left_bend_e_2, _belated_2 = carry_impact(_when_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _clock_2, _left_nx_2, _left_ny_2, _left_nz_2, _place_n_2, _place_s_2, _place_e_2, _pace_n_2, _pace_s_2, _pace_e_2, _turn_n_2, _turn_z_2, _position_bound_2, _velocity_bound_2, _spin_bound_2, _tangent_x_2, _tangent_y_2, _bend_s_2, _bend_e_2, _left_ex_2, _left_ey_2, _left_bend_s_2, _left_bend_e_2, _sharpest_bend_2, _root_offset_2, _root_level_2, _normal_rounding_2, _normal_velocity_2, _back_2, _p_ball_radius_2, _p_restitution_2, _p_gravity_2, _room_2)
            _clock_error_2, = clock_error_sum(_belated_2, _clock_error_2)
            _clock_error_1, _left_bend_e_1, _left_bend_s_1, _left_ex_1, _left_ey_1, _left_nx_1, _left_ny_1, _left_nz_1, _pace_e_1, _pace_n_1, _pace_s_1, _place_e_1, _place_n_1, _place_s_1, _position_bound_1, _spin_bound_1, _turn_n_1, _turn_z_1, _velocity_bound_1 = _put(_rows7, _count2, (_clock_error_1, _left_bend_e_1, _left_bend_s_1, _left_ex_1, _left_ey_1, _left_nx_1, _left_ny_1, _left_nz_1, _pace_e_1, _pace_n_1, _pace_s_1, _place_e_1, _place_n_1, _place_s_1, _position_bound_1, _spin_bound_1, _turn_n_1, _turn_z_1, _velocity_bound_1,), (_clock_error_2, _left_bend_e_2, _left_bend_s_2, _left_ex_2, _left_ey_2, _left_nx_2, _left_ny_2, _left_nz_2, _pace_e_2, _pace_n_2, _pace_s_2, _place_e_2, _place_n_2, _place_s_2, _position_bound_2, _spin_bound_2, _turn_n_2, _turn_z_2, _velocity_bound_2,), _carries_1)
        _rows9, _count10 = _most(_tightens_1, _count2)
        if _count10:
            _back_2, _bend_e_2, _bend_s_2, _clock_2, _clock_error_2, _continued_2, _left_bend_e_2, _left_bend_s_2, _left_ex_2, _left_ey_2, _left_nx_2, _left_ny_2, _left_nz_2, _normal_rounding_2, _normal_velocity_2, _nx_2, _ny_2, _nz_2, _origin_e_2, _origin_s_2, _origin_t_2, _origin_u_2, _origin_v_2, _origin_w_2, _p_ball_radius_2, _p_gravity_2, _p_restitution_2, _pace_e_2, _pace_n_2, _pace_s_2, _place_e_2, _place_n_2, _place_s_2, _position_bound_2, _product_11_2, _product_12_2, _product_13_2, _product_14_2, _product_15_2, _product_16_2, _product_21_2, _product_22_2, _product_23_2, _product_24_2, _product_25_2, _product_26_2, _product_31_2, _product_32_2, _product_33_2, _product_34_2, _product_35_2, _product_36_2, _product_41_2, _product_42_2, _product_43_2, _product_44_2, _product_45_2, _product_46_2, _product_51_2, _product_52_2, _product_53_2, _product_54_2, _product_55_2, _product_56_2, _product_61_2, _product_62_2, _product_63_2, _product_64_2, _product_65_2, _product_66_2, _recent_e_2, _recent_s_2, _recent_t_2, _recent_u_2, _recent_v_2, _recent_w_2, _root_level_2, _root_offset_2, _sharpest_bend_2, _spin_bound_2, _tangent_x_2, _tangent_y_2, _turn_n_2, _turn_z_2, _velocity_bound_2, _vx_2, _vy_2, _vz_2, _when_2, _wx_2, _wy_2, _wz_2, _x_2, _y_2, _z_2 = _taken(_rows9, _back_1, _bend_e_1, _bend_s_1, _clock_1, _clock_error_1, _continued_1, _left_bend_e_1, _left_bend_s_1, _left_ex_1, _left_ey_1, _left_nx_1, _left_ny_1, _left_nz_1, _normal_rounding_1, _normal_velocity_1, _nx_1, _ny_1, _nz_1, _origin_e_1, _origin_s_1, _origin_t_1, _origin_u_1, _origin_v_1, _origin_w_1, _p_ball_radius_1, _p_gravity_1, _p_restitution_1, _pace_e_1, _pace_n_1, _pace_s_1, _place_e_1, _place_n_1, _place_s_1, _position_bound_1, _product_11_1, _product_12_1, _product_13_1, _product_14_1, _product_15_1, _product_16_1, _product_21_1, _product_22_1, _product_23_1, _product_24_1, _product_25_1, _product_26_1, _product_31_1, _product_32_1, _product_33_1, _product_34_1, _product_35_1, _product_36_1, _product_41_1, _product_42_1, _product_43_1, _product_44_1, _product_45_1, _product_46_1, _product_51_1, _product_52_1, _product_53_1, _product_54_1, _product_55_1, _product_56_1, _product_61_1, _product_62_1, _product_63_1, _product_64_1, _product_65_1, _product_66_1, _recent_e_1, _recent_s_1, _recent_t_1, _recent_u_1, _recent_v_1, _recent_w_1, _root_level_1, _root_offset_1, _sharpest_bend_1, _spin_bound_1, _tangent_x_1, _tangent_y_1, _turn_n_1, _turn_z_1, _velocity_bound_1, _vx_1, _vy_1, _vz_1, _when_1, _wx_1, _wy_1, _wz_1, _x_1, _y_1, _z_1)
            _room_2 = room(_count10)
            _place_n_2, _place_s_2, _place_e_2, _pace_n_2, _pace_s_2, _pace_e_2, _turn_n_2, _turn_z_2, _position_bound_2, _velocity_bound_2, _spin_bound_2, _left_nx_2, _left_ny_2, _left_nz_2, _left_ex_2, _left_ey_2, _left_bend_s_2, _left_bend_e_2, _belated_2, _origin_s_2, _origin_e_2, _origin_u_2, _origin_v_2, _origin_w_2, _origin_t_2, _recent_s_2, _recent_e_2, _recent_u_2, _recent_v_2, _recent_w_2, _recent_t_2, _product_11_2, _product_12_2, _product_13_2, _product_14_2, _product_15_2, _product_16_2, _product_21_2, _product_22_2, _product_23_2, _product_24_2, _product_25_2, _product_26_2, _product_31_2, _product_32_2, _product_33_2, _product_34_2, _product_35_2, _product_36_2, _product_41_2, _product_42_2, _product_43_2, _product_44_2, _product_45_2, _product_46_2, _product_51_2, _product_52_2, _product_53_2, _product_54_2, _product_55_2, _product_56_2, _product_61_2, _product_62_2, _product_63_2, _product_64_2, _product_65_2, _product_66_2, _continued_2 = tighten_impact(_when_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _clock_2, _left_nx_2, _left_ny_2, _left_nz_2, _place_n_2, _place_s_2, _place_e_2, _pace_n_2, _pace_s_2, _pace_e_2, _turn_n_2, _turn_z_2, _position_bound_2, _velocity_bound_2, _spin_bound_2, _tangent_x_2, _tangent_y_2, _bend_s_2, _bend_e_2, _left_ex_2, _left_ey_2, _left_bend_s_2, _left_bend_e_2, _sharpest_bend_2, _root_offset_2, _root_level_2, _normal_rounding_2, _normal_velocity_2, _back_2, _origin_s_2, _origin_e_2, _origin_u_2, _origin_v_2, _origin_w_2, _origin_t_2, _product_11_2, _product_12_2, _product_13_2, _product_14_2, _product_15_2, _product_16_2, _product_21_2, _product_22_2, _product_23_2, _product_24_2, _product_25_2, _product_26_2, _product_31_2, _product_32_2, _product_33_2, _product_34_2, _product_35_2, _product_36_2, _product_41_2, _product_42_2, _product_43_2, _product_44_2, _product_45_2, _product_46_2, _product_51_2, _product_52_2, _product_53_2, _product_54_2, _product_55_2, _product_56_2, _product_61_2, _product_62_2, _product_63_2, _product_64_2, _product_65_2, _product_66_2, _recent_s_2, _recent_e_2, _recent_u_2, _recent_v_2, _recent_w_2, _recent_t_2, _continued_2, _p_ball_radius_2, _p_restitution_2, _p_gravity_2, _room_2)
            _clock_error_2, = clock_error_sum(_belated_2, _clock_error_2)
            _clock_error_1, _continued_1, _left_bend_e_1, _left_bend_s_1, _left_ex_1, _left_ey_1, _left_nx_1, _left_ny_1, _left_nz_1, _origin_e_1, _origin_s_1, _origin_t_1, _origin_u_1, _origin_v_1, _origin_w_1, _pace_e_1, _pace_n_1, _pace_s_1, _place_e_1, _place_n_1, _place_s_1, _position_bound_1, _product_11_1, _product_12_1, _product_13_1, _product_14_1, _product_15_1, _product_16_1, _product_21_1, _product_22_1, _product_23_1, _product_24_1, _product_25_1, _product_26_1, _product_31_1, _product_32_1, _product_33_1, _product_34_1, _product_35_1, _product_36_1, _product_41_1, _product_42_1, _product_43_1, _product_44_1, _product_45_1, _product_46_1, _product_51_1, _product_52_1, _product_53_1, _product_54_1, _product_55_1, _product_56_1, _product_61_1, _product_62_1, _product_63_1, _product_64_1, _product_65_1, _product_66_1, _recent_e_1, _recent_s_1, _recent_t_1, _recent_u_1, _recent_v_1, _recent_w_1, _spin_bound_1, _turn_n_1, _turn_z_1, _velocity_bound_1 = _put(_rows9, _count2, (_clock_error_1, _continued_1, _left_bend_e_1, _left_bend_s_1, _left_ex_1, _left_ey_1, _left_nx_1, _left_ny_1, _left_nz_1, _origin_e_1, _origin_s_1, _origin_t_1, _origin_u_1, _origin_v_1, _origin_w_1, _pace_e_1, _pace_n_1, _pace_s_1, _place_e_1, _place_n_1, _place_s_1, _position_bound_1, _product_11_1, _product_12_1, _product_13_1, _product_14_1, _product_15_1, _product_16_1, _product_21_1, _product_22_1, _product_23_1, _product_24_1, _product_25_1, _product_26_1, _product_31_1, _product_32_1, _product_33_1, _product_34_1, _product_35_1, _product_36_1, _product_41_1, _product_42_1, _product_43_1, _product_44_1, _product_45_1, _product_46_1, _product_51_1, _product_52_1, _product_53_1, _product_54_1, _product_55_1, _product_56_1, _product_61_1, _product_62_1, _product_63_1, _product_64_1, _product_65_1, _product_66_1, _recent_e_1, _recent_s_1, _recent_t_1, _recent_u_1, _recent_v_1, _recent_w_1, _spin_bound_1, _turn_n_1, _turn_z_1, _velocity_bound_1,), (_clock_error_2, _continued_2, _left_bend_e_2, _left_bend_s_2, _left_ex_2, _left_ey_2, _left_nx_2, _left_ny_2, _left_nz_2, _origin_e_2, _origin_s_2, _origin_t_2, _origin_u_2, _origin_v_2, _origin_w_2, _pace_e_2, _pace_n_2, _pace_s_2, _place_e_2, _place_n_2, _place_s_2, _position_bound_2, _product_11_2, _product_12_2, _product_13_2, _product_14_2, _product_15_2, _product_16_2, _product_21_2, _product_22_2, _product_23_2, _product_24_2, _product_25_2, _product_26_2, _product_31_2, _product_32_2, _product_33_2, _product_34_2, _product_35_2, _product_36_2, _product_41_2, _product_42_2, _product_43_2, _product_44_2, _product_45_2, _product_46_2, _product_51_2, _product_52_2, _product_53_2, _product_54_2, _product_55_2, _product_56_2, _product_61_2, _product_62_2, _product_63_2, _product_64_2, _product_65_2, _product_66_2, _recent_e_2, _recent_s_2, _recent_t_2, _recent_u_2, _recent_v_2, _recent_w_2, _spin_bound_2, _turn_n_2, _turn_z_2, _velocity_bound_2,), _tightens_1)
        _rows11, _count12 = _most(_touches_1, _count2)
        if _count12:
            _nx_2, _ny_2, _nz_2, _p_ball_radius_2, _p_restitution_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = _taken(_rows11, _nx_1, _ny_1, _nz_1, _p_ball_radius_1, _p_restitution_1, _vx_1, _vy_1, _vz_1, _wx_1, _wy_1, _wz_1)
            _room_2 = room(_count12)
            _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = impact(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _p_ball_radius_2, _p_restitution_2, _room_2)
            _vx_1, _vy_1, _vz_1, _wx_1, _wy_1, _wz_1 = _put(_rows11, _count2, (_vx_1, _vy_1, _vz_1, _wx_1, _wy_1, _wz_1,), (_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2,), _touches_1)
        _here_1, = here(1.0, _which_1)
        _x_2, _y_2, _z_2 = backboard_place(_y_1, _z_1, _p_ball_radius_1, _p_board_distance_1)
        _x_1, _y_1, _z_1 = _choose(_here_1, (_x_2, _y_2, _z_2,), (_x_1, _y_1, _z_1,))
        _here_1, = here(2.0, _which_1)
        _x_2, _y_2, _z_2 = bridge_place(_x_1, _y_1, _p_ball_radius_1, _p_wire_radius_1)
        _x_1, _y_1, _z_1 = _choose(_here_1, (_x_2, _y_2, _z_2,), (_x_1, _y_1, _z_1,))
        _unbounded_2, = unbounded(_clock_error_1, _position_bound_1, _velocity_bound_1, _spin_bound_1)
        _uncertain_2, = without_bounds(_unbounded_2, _uncertain_1)
        _first_2, _last_2 = touched(_which_1, _body_1, _first_1)
        _first_1, _last_1, _uncertain_1 = _choose(_touches_1, (_first_2, _last_2, _uncertain_2,), (_first_1, _last_1, _uncertain_1,))
        _clock_error_0, _continued_0, _count_0_0, _count_1_0, _count_2_0, _first_0, _last_0, _left_bend_e_0, _left_bend_s_0, _left_ex_0, _left_ey_0, _left_nx_0, _left_ny_0, _left_nz_0, _origin_e_0, _origin_s_0, _origin_t_0, _origin_u_0, _origin_v_0, _origin_w_0, _pace_e_0, _pace_n_0, _pace_s_0, _place_e_0, _place_n_0, _place_s_0, _position_bound_0, _product_11_0, _product_12_0, _product_13_0, _product_14_0, _product_15_0, _product_16_0, _product_21_0, _product_22_0, _product_23_0, _product_24_0, _product_25_0, _product_26_0, _product_31_0, _product_32_0, _product_33_0, _product_34_0, _product_35_0, _product_36_0, _product_41_0, _product_42_0, _product_43_0, _product_44_0, _product_45_0, _product_46_0, _product_51_0, _product_52_0, _product_53_0, _product_54_0, _product_55_0, _product_56_0, _product_61_0, _product_62_0, _product_63_0, _product_64_0, _product_65_0, _product_66_0, _recent_e_0, _recent_s_0, _recent_t_0, _recent_u_0, _recent_v_0, _recent_w_0, _spin_bound_0, _turn_n_0, _turn_z_0, _uncertain_0, _velocity_bound_0, _vx_0, _vy_0, _vz_0, _wx_0, _wy_0, _wz_0, _x_0, _y_0, _z_0 = _put(_rows1, shots, (_clock_error_0, _continued_0, _count_0_0, _count_1_0, _count_2_0, _first_0, _last_0, _left_bend_e_0, _left_bend_s_0, _left_ex_0, _left_ey_0, _left_nx_0, _left_ny_0, _left_nz_0, _origin_e_0, _origin_s_0, _origin_t_0, _origin_u_0, _origin_v_0, _origin_w_0, _pace_e_0, _pace_n_0, _pace_s_0, _place_e_0, _place_n_0, _place_s_0, _position_bound_0, _product_11_0, _product_12_0, _product_13_0, _product_14_0, _product_15_0, _product_16_0, _product_21_0, _product_22_0, _product_23_0, _product_24_0, _product_25_0, _product_26_0, _product_31_0, _product_32_0, _product_33_0, _product_34_0, _product_35_0, _product_36_0, _product_41_0, _product_42_0, _product_43_0, _product_44_0, _product_45_0, _product_46_0, _product_51_0, _product_52_0, _product_53_0, _product_54_0, _product_55_0, _product_56_0, _product_61_0, _product_62_0, _product_63_0, _product_64_0, _product_65_0, _product_66_0, _recent_e_0, _recent_s_0, _recent_t_0, _recent_u_0, _recent_v_0, _recent_w_0, _spin_bound_0, _turn_n_0, _turn_z_0, _uncertain_0, _velocity_bound_0, _vx_0, _vy_0, _vz_0, _wx_0, _wy_0, _wz_0, _x_0, _y_0, _z_0,), (_clock_error_1, _continued_1, _count_0_1, _count_1_1, _count_2_1, _first_1, _last_1, _left_bend_e_1, _left_bend_s_1, _left_ex_1, _left_ey_1, _left_nx_1, _left_ny_1, _left_nz_1, _origin_e_1, _origin_s_1, _origin_t_1, _origin_u_1, _origin_v_1, _origin_w_1, _pace_e_1, _pace_n_1, _pace_s_1, _place_e_1, _place_n_1, _place_s_1, _position_bound_1, _product_11_1, _product_12_1, _product_13_1, _product_14_1, _product_15_1, _product_16_1, _product_21_1, _product_22_1, _product_23_1, _product_24_1, _product_25_1, _product_26_1, _product_31_1, _product_32_1, _product_33_1, _product_34_1, _product_35_1, _product_36_1, _product_41_1, _product_42_1, _product_43_1, _product_44_1, _product_45_1, _product_46_1, _product_51_1, _product_52_1, _product_53_1, _product_54_1, _product_55_1, _product_56_1, _product_61_1, _product_62_1, _product_63_1, _product_64_1, _product_65_1, _product_66_1, _recent_e_1, _recent_s_1, _recent_t_1, _recent_u_1, _recent_v_1, _recent_w_1, _spin_bound_1, _turn_n_1, _turn_z_1, _uncertain_1, _velocity_bound_1, _vx_1, _vy_1, _vz_1, _wx_1, _wy_1, _wz_1, _x_1, _y_1, _z_1,))
    _rows13, _count14 = _rows(_limited_0, shots)
    if _count14:
        _claims_1, _clock_1, _clock_error_1, _p_gravity_1, _position_bound_1, _spin_bound_1, _velocity_bound_1, _vx_1, _vy_1, _vz_1, _when_1, _which_1, _x_1, _y_1, _z_1 = _taken(_rows13, _claims_0, _clock_0, _clock_error_0, _p_gravity_0, _position_bound_0, _spin_bound_0, _velocity_bound_0, _vx_0, _vy_0, _vz_0, _when_0, _which_0, _x_0, _y_0, _z_0)
        _ends_by_time_limit_1, = ends_by_time_limit(4.0, _which_1, _claims_1)
        _rows15, _count16 = _most(_ends_by_time_limit_1, _count14)
        if _count16:
            _clock_2, _clock_error_2, _p_gravity_2, _position_bound_2, _spin_bound_2, _velocity_bound_2, _vx_2, _vy_2, _vz_2, _when_2, _x_2, _y_2, _z_2 = _taken(_rows15, _clock_1, _clock_error_1, _p_gravity_1, _position_bound_1, _spin_bound_1, _velocity_bound_1, _vx_1, _vy_1, _vz_1, _when_1, _x_1, _y_1, _z_1)
            _room_2 = room(_count16)
            _position_bound_2, _velocity_bound_2, _spin_bound_2, _clock_error_2 = carry_time(_when_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _clock_2, _clock_error_2, _position_bound_2, _velocity_bound_2, _spin_bound_2, _p_gravity_2, _room_2)
            _clock_error_1, _position_bound_1, _spin_bound_1, _velocity_bound_1 = _put(_rows15, _count14, (_clock_error_1, _position_bound_1, _spin_bound_1, _velocity_bound_1,), (_clock_error_2, _position_bound_2, _spin_bound_2, _velocity_bound_2,), _ends_by_time_limit_1)
        _clock_error_0, _position_bound_0, _spin_bound_0, _velocity_bound_0 = _put(_rows13, shots, (_clock_error_0, _position_bound_0, _spin_bound_0, _velocity_bound_0,), (_clock_error_1, _position_bound_1, _spin_bound_1, _velocity_bound_1,))
    _reports_0, _position_claim_0, _velocity_claim_0, _spin_claim_0, _time_claim_0 = closing(_outcome_0, _claims_0)
    _rows17, _count18 = _most(_reports_0, shots)
    if _count18:
        _clock_error_1, _position_bound_1, _spin_bound_1, _velocity_bound_1 = _taken(_rows17, _clock_error_0, _position_bound_0, _spin_bound_0, _velocity_bound_0)
        _position_claim_1, _velocity_claim_1, _spin_claim_1, _time_claim_1 = claimed_errors(_clock_error_1, _position_bound_1, _velocity_bound_1, _spin_bound_1)
        _position_claim_0, _spin_claim_0, _time_claim_0, _velocity_claim_0 = _put(_rows17, shots, (_position_claim_0, _spin_claim_0, _time_claim_0, _velocity_claim_0,), (_position_claim_1, _spin_claim_1, _time_claim_1, _velocity_claim_1,), _reports_0)
    columns |= {"clock_error": _clock_error_0, "continued": _continued_0, "count_0": _count_0_0, "count_1": _count_1_0, "count_2": _count_2_0, "first": _first_0, "last": _last_0, "left_bend_e": _left_bend_e_0, "left_bend_s": _left_bend_s_0, "left_ex": _left_ex_0, "left_ey": _left_ey_0, "left_nx": _left_nx_0, "left_ny": _left_ny_0, "left_nz": _left_nz_0, "origin_e": _origin_e_0, "origin_s": _origin_s_0, "origin_t": _origin_t_0, "origin_u": _origin_u_0, "origin_v": _origin_v_0, "origin_w": _origin_w_0, "pace_e": _pace_e_0, "pace_n": _pace_n_0, "pace_s": _pace_s_0, "place_e": _place_e_0, "place_n": _place_n_0, "place_s": _place_s_0, "position_bound": _position_bound_0, "position_claim": _position_claim_0, "product_11": _product_11_0, "product_12": _product_12_0, "product_13": _product_13_0, "product_14": _product_14_0, "product_15": _product_15_0, "product_16": _product_16_0, "product_21": _product_21_0, "product_22": _product_22_0, "product_23": _product_23_0, "product_24": _product_24_0, "product_25": _product_25_0, "product_26": _product_26_0, "product_31": _product_31_0, "product_32": _product_32_0, "product_33": _product_33_0, "product_34": _product_34_0, "product_35": _product_35_0, "product_36": _product_36_0, "product_41": _product_41_0, "product_42": _product_42_0, "product_43": _product_43_0, "product_44": _product_44_0, "product_45": _product_45_0, "product_46": _product_46_0, "product_51": _product_51_0, "product_52": _product_52_0, "product_53": _product_53_0, "product_54": _product_54_0, "product_55": _product_55_0, "product_56": _product_56_0, "product_61": _product_61_0, "product_62": _product_62_0, "product_63": _product_63_0, "product_64": _product_64_0, "product_65": _product_65_0, "product_66": _product_66_0, "recent_e": _recent_e_0, "recent_s": _recent_s_0, "recent_t": _recent_t_0, "recent_u": _recent_u_0, "recent_v": _recent_v_0, "recent_w": _recent_w_0, "spin_bound": _spin_bound_0, "spin_claim": _spin_claim_0, "time_claim": _time_claim_0, "turn_n": _turn_n_0, "turn_z": _turn_z_0, "uncertain": _uncertain_0, "velocity_bound": _velocity_bound_0, "velocity_claim": _velocity_claim_0, "vx": _vx_0, "vy": _vy_0, "vz": _vz_0, "wx": _wx_0, "wy": _wy_0, "wz": _wz_0, "x": _x_0, "y": _y_0, "z": _z_0, }


def review_bounded(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage review of the event loop, with bounds on errors."""
    _contacts_0, _outcome_0, _uncertain_0, = map(columns.__getitem__, ("contacts", "outcome", "uncertain",))
    _loose_0, = loose(_contacts_0, _outcome_0, _uncertain_0)
    columns |= {"loose": _loose_0, }
