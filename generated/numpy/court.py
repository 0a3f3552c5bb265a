"""NumPy kernels of the scene court.

Generated from templates/numpy/kernels.py.j2, scene court, derivation 17608efa79d077d6,
with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
and run `make generate`.
Every function takes scalars or arrays that broadcast and is evaluated element by element; SI units.
"""

# ruff: noqa: E501

from __future__ import annotations

from enum import IntEnum
from typing import Any, NamedTuple

from numpy import absolute as _absolute
from numpy import add as _add
from numpy import bitwise_and as _bitwise_and
from numpy import bitwise_xor as _bitwise_xor
from numpy import count_nonzero as _count_nonzero
from numpy import divide as _divide
from numpy import empty_like as _empty_like
from numpy import flatnonzero as _flatnonzero
from numpy import float32 as _float32
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

SCENE = "court"

PARAMETERS: dict[str, tuple[float, str, str]] = {
    "ball_radius": (0.12128, "m", "R_B, radius of the ball"),
    "ring_radius": (0.235, "m", "R_H, radius of the wire's centre circle"),
    "wire_radius": (0.01, "m", "radius of the ring's wire"),
    "board_distance": (0.381, "m", "a_0, from the ring's centre to the backboard"),
    "board_half_width": (0.9144, "m", "y_B, half the backboard's width"),
    "board_bottom": (-0.14, "m", "z_B1, height of its lower edge"),
    "board_top": (0.9268, "m", "z_B2, height of its upper edge"),
    "board_thickness": (0.0127, "m", "d, from the board's front to its back"),
    "bridge_half_width": (0.0762, "m", "y_BR, half the bridge's width"),
    "bridge_depth": (0.12, "m", "h, from the bridge's top to its underside"),
    "gravity": (9.81, "m/s²", "g"),
    "end_depth": (0.024256, "m", "H, of the end plane below the ring"),
    "ring_restitution": (0.7, "1", "e0 of the ring"),
    "backboard_restitution": (0.7, "1", "e0 of the backboard"),
    "bridge_restitution": (0.7, "1", "e0 of the bridge"),
    "ring_friction": (_inf, "1", "mu of the ring; infinite: every contact grips"),
    "backboard_friction": (_inf, "1", "mu of the backboard; infinite: every contact grips"),
    "bridge_friction": (_inf, "1", "mu of the bridge; infinite: every contact grips"),
    "tangential_restitution": (0.0, "1", "e_t, of every contact that grips"),
    "restitution_speed": (_inf, "m/s", "v0, at which e is half of e0; infinite: it does not fall"),
}
"""Parameters in calling order: default, unit, meaning."""

LIMITS: dict[str, tuple[float, float]] = {
    "ring_restitution": (0.0, 1.0),
    "backboard_restitution": (0.0, 1.0),
    "bridge_restitution": (0.0, 1.0),
    "tangential_restitution": (-1.0, 1.0),
}
"""Of parameters with a largest value: between which they are."""

VARIABLES: dict[str, str] = {
    "ball_radius": "p_ball_radius",
    "ring_radius": "p_ring_radius",
    "wire_radius": "p_wire_radius",
    "board_distance": "p_board_distance",
    "board_half_width": "p_board_half_width",
    "board_bottom": "p_board_bottom",
    "board_top": "p_board_top",
    "board_thickness": "p_board_thickness",
    "bridge_half_width": "p_bridge_half_width",
    "bridge_depth": "p_bridge_depth",
    "gravity": "p_gravity",
    "end_depth": "p_end_depth",
    "ring_restitution": "p_ring_restitution",
    "backboard_restitution": "p_backboard_restitution",
    "bridge_restitution": "p_bridge_restitution",
    "ring_friction": "p_ring_friction",
    "backboard_friction": "p_backboard_friction",
    "bridge_friction": "p_bridge_friction",
    "tangential_restitution": "p_tangential_restitution",
    "restitution_speed": "p_restitution_speed",
}
"""What each parameter is called as an argument, and as a column of the event loop."""

BODIES: tuple[str, ...] = ("ring", "backboard", "bridge",)
"""What can be touched, in the order of the results; what ends a shot comes after them."""

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
    """Fell through the ring, and crossed the end plane inside the target."""
    MISSED = 1
    """Crossed the end plane otherwise."""
    CAPPED = 2
    """Had max_contacts contacts before it ended."""
    SHORT = 3
    """Can never reach an end."""
    INVALID = 4
    """Not finite, a parameter not allowed, or a ball that starts inside a surface."""
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


LOG_ROWS = 3
"""Rows of the event log for each contact, at most; the end is one more."""


class Field(NamedTuple):
    """What a shot takes from event to event: its start, None if given; whether it bounds errors."""

    name: str
    start: float | None
    bounds: bool


class Result(NamedTuple):
    """A result: the fields that it is made of, whether they make a row, whether it is not a number
    where a shot is invalid, whether it bounds errors, whether it is had by name only, whether it
    counts contacts by body where they happen."""

    name: str
    dtype: str
    columns: tuple[str, ...]
    row: bool
    blank: bool
    bounds: bool
    asked: bool
    tallied: bool = False


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
    Field("dx", 0.0, True),
    Field("dy", 0.0, True),
    Field("dz", 0.0, True),
    Field("dvx", 0.0, True),
    Field("dvy", 0.0, True),
    Field("dvz", 0.0, True),
    Field("dwx", 0.0, True),
    Field("dwy", 0.0, True),
    Field("dwz", 0.0, True),
    Field("clock", 0.0, False),
    Field("clock_error", 0.0, True),
    Field("last", None, False),
    Field("first", -1, False),
    Field("contacts", 0.0, False),
    Field("count_0", 0.0, False),
    Field("count_1", 0.0, False),
    Field("count_2", 0.0, False),
    Field("held", -1, False),
    Field("mode", 0.0, False),
    Field("circled", 0.0, False),
    Field("assured", 0.0, True),
    Field("rolls", 0.0, False),
    Field("slip_left", 0.0, False),
    Field("grip_lost", _inf, True),
    Field("taut", _inf, True),
    Field("taut_rate", 0.0, True),
    Field("taut_clock", 0.0, True),
    Field("through", 0.0, False),
    Field("uncertain", 0.0, True),
    Field("position_claim", 0.0, True),
    Field("velocity_claim", 0.0, True),
    Field("spin_claim", 0.0, True),
    Field("time_claim", 0.0, True),
    Field("outcome", -1, False),
)

RESULTS: tuple[Result, ...] = (
    Result("outcome", "uint8", ('outcome',), False, False, False, False),
    Result("contacts", "int32", ('contacts',), False, False, False, False),
    Result("counts", "int32", ('count_0', 'count_1', 'count_2'), True, False, False, False),
    Result("first", "int8", ('first',), False, False, False, False),
    Result("time", "float64", ('clock',), False, True, False, False),
    Result("state", "float64", ('x', 'y', 'z', 'vx', 'vy', 'vz', 'wx', 'wy', 'wz'), True, True, False, False),
    Result("rolls", "int32", ('rolls',), False, False, False, False),
    Result("slip_left", "bool", ('slip_left',), False, False, False, False),
    Result("grip_lost", "float64", ('grip_lost',), False, True, True, True),
    Result("time_error", "float64", ('time_claim',), False, True, True, True),
    Result("state_error", "float64", ('position_claim', 'velocity_claim', 'spin_claim'), True, True, True, True),
    Result("uncertain", "bool", ('uncertain',), False, False, True, False),
)

ARGUMENTS: dict[str, tuple[str, ...]] = {
    "flight": ("t", "x", "y", "z", "vx", "vy", "vz", "p_gravity",),
    "contact_frame": ("nx", "ny", "nz",),
    "impact_through_frame": ("vx", "vy", "vz", "wx", "wy", "wz", "n11", "n12", "n13", "n21", "n22", "n23", "n31", "n32", "n33", "p_ball_radius", "restitution",),
    "crossing": ("margin", "rate_margin", "rate", "ceiling",),
    "allowance": ("share", "horizon", "extent", "speed", "position_error", "velocity_error", "p_gravity",),
    "horizon": ("t", "speed", "p_gravity",),
    "scale": ("x", "y", "z", "vx", "vy", "vz", "p_gravity",),
    "displacement": ("delay", "horizon", "extent", "speed", "position_error", "velocity_error", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_board_distance", "p_board_half_width", "p_board_bottom", "p_board_top", "p_board_thickness", "p_bridge_half_width", "p_bridge_depth", "p_gravity", "p_end_depth",),
    "carry_flight": ("t", "x", "y", "z", "vx", "vy", "vz", "nx", "ny", "nz", "clock", "contacts", "late", "dx", "dy", "dz", "dvx", "dvy", "dvz", "left_nx", "left_ny", "left_nz", "curving", "p_gravity",),
    "carry_time": ("t", "x", "y", "z", "vx", "vy", "vz", "clock", "clock_error", "dx", "dy", "dz", "dvx", "dvy", "dvz", "p_gravity",),
    "error_bounds": ("clock_error", "dx", "dy", "dz", "dvx", "dvy", "dvz", "dwx", "dwy", "dwz",),
    "claimed_errors": ("clock_error", "dx", "dy", "dz", "dvx", "dvy", "dvz", "dwx", "dwy", "dwz",),
    "allowed": ("p_ball_radius", "p_ring_radius", "p_wire_radius", "p_board_distance", "p_board_half_width", "p_board_bottom", "p_board_top", "p_board_thickness", "p_bridge_half_width", "p_bridge_depth", "p_gravity", "p_end_depth", "p_ring_restitution", "p_backboard_restitution", "p_bridge_restitution", "p_ring_friction", "p_backboard_friction", "p_bridge_friction", "p_tangential_restitution", "p_restitution_speed",),
    "finite_parameters": ("p_ball_radius", "p_ring_radius", "p_wire_radius", "p_board_distance", "p_board_half_width", "p_board_bottom", "p_board_top", "p_board_thickness", "p_bridge_half_width", "p_bridge_depth", "p_gravity", "p_end_depth", "p_ring_restitution", "p_backboard_restitution", "p_bridge_restitution", "p_ring_friction", "p_backboard_friction", "p_bridge_friction", "p_tangential_restitution", "p_restitution_speed", "allowed",),
    "valid": ("last", "x", "y", "z", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_board_distance", "p_board_half_width", "p_board_bottom", "p_board_top", "p_board_thickness", "p_bridge_half_width", "p_bridge_depth", "p_end_depth",),
    "passing_start": ("last", "outcome", "uncertain", "x", "y", "z", "p_ring_radius", "p_end_depth",),
    "passing": ("through", "t", "x", "y", "z", "vx", "vy", "vz", "p_ring_radius", "p_gravity",),
    "passing_doubt": ("t", "x", "y", "z", "vx", "vy", "vz", "extent", "speed", "position_error", "velocity_error", "p_ring_radius", "p_gravity",),
    "passing_from": ("z",),
    "passing_in_contact": ("over", "p_ring_radius", "through", "x", "y", "z",),
    "halved": ("horizon", "x", "y", "z", "vx", "vy", "vz", "extent", "speed", "position_error", "velocity_error", "late", "pad", "p_gravity",),
    "untaken": (),
    "left": ("index", "last",),
    "meeting_plane": ("bend", "rate", "time",),
    "timely": ("arrives", "delay", "late", "time", "when",),
    "grazed": ("apex", "doubt", "height", "margin",),
    "questioned": ("doubt", "time", "unsure",),
    "crossed": ("arrives", "clearance", "doubt", "time",),
    "tied": ("arrives", "delay", "doubt", "late", "time", "when",),
    "sooner": ("arrives", "index", "time", "when", "which",),
    "beginning": (),
    "beyond": ("doubt", "excess", "late", "lost", "pad",),
    "beyond_windows": ("doubt", "excess", "late", "lost", "pad", "searching",),
    "nearby": ("flat", "index", "last", "t", "tilt",),
    "opened": ("horizon", "time",),
    "coarse": ("ceiling", "fits", "flat", "rate_margin", "searching", "share", "sound",),
    "leapt": ("arrival", "certain", "lasting", "searching", "served", "since",),
    "struck": ("bend", "clearance", "gap", "margin", "rate", "rate_margin", "share",),
    "struck_or_still": ("bend", "clearance", "end", "gap", "margin", "next", "rate", "rate_margin", "share", "t",),
    "finer": ("share",),
    "exceeded": ("doubt", "excess", "t",),
    "advanced": ("arrival", "certain", "end", "hit", "next", "step", "sure", "t", "vague",),
    "found": ("arrival",),
    "polished": ("arrival", "ceiling", "certain", "gap", "rate", "refined",),
    "own_margin": ("arrival", "flat", "leaving", "tilt",),
    "landed": ("arrival",),
    "landed_surely": ("arrives", "certain", "clearance", "delay", "doubt", "time",),
    "outside": (),
    "finite_state": ("vx", "vy", "vz", "wx", "wy", "wz", "x", "y", "z",),
    "opening": ("excess", "position_error", "velocity_error",),
    "limited": ("time_limit",),
    "ticked": ("clock", "when",),
    "meeting": ("claims", "ends", "touches",),
    "here": ("index", "which",),
    "counted": ("count",),
    "elsewhere": (),
    "again": ("index", "last", "which",),
    "delayed": ("clock_error", "delay",),
    "floored": ("dx", "dy", "dz", "shift",),
    "unturned": (),
    "touched": ("body", "first", "which",),
    "timed": ("claims", "index", "which",),
    "closing": ("claims", "outcome",),
    "undecided": ("uncertain", "unsure",),
    "body_of": ("which",),
    "admitted": ("doubt", "finite", "permitted", "valid",),
    "expiry": ("clock", "doubt", "late", "time_error", "time_limit", "when", "which",),
    "departed": ("index", "which",),
    "expired": ("body", "clock", "ends", "index", "reached", "time_limit", "which",),
    "accounted": ("contacts", "most_contacts", "reached", "touches",),
    "circles": ("held", "index", "rolling",),
    "leaps": ("stride",),
    "cleared": ("berth", "gap", "leap", "nearing",),
    "for_ever": ("endless", "which",),
    "rejoined": ("circling", "rolling",),
    "roll_0": ("bent_x", "bent_y", "bent_z", "p_gravity", "nx_0", "ny_0", "nz_0", "per_reach", "turn_rate_0", "vx_0", "vy_0", "vz_0",),
    "roll_1": ("bent_x", "bent_y", "bent_z", "p_gravity", "lift_0", "nx_0", "nx_1", "ny_0", "ny_1", "nz_0", "nz_1", "per_reach", "turn_rate_0", "turn_rate_1", "tx_0", "ty_0", "tz_0", "vx_0", "vx_1", "vy_0", "vy_1", "vz_0", "vz_1",),
    "roll_2": ("bent_x", "bent_y", "bent_z", "p_gravity", "lift_0", "lift_1", "nx_0", "nx_1", "nx_2", "ny_0", "ny_1", "ny_2", "nz_0", "nz_1", "nz_2", "per_reach", "turn_rate_0", "turn_rate_1", "turn_rate_2", "tx_0", "tx_1", "ty_0", "ty_1", "tz_0", "tz_1", "vx_0", "vx_1", "vx_2", "vy_0", "vy_1", "vy_2", "vz_0", "vz_1", "vz_2",),
    "roll_3": ("bent_x", "bent_y", "bent_z", "p_gravity", "lift_0", "lift_1", "lift_2", "nx_0", "nx_1", "nx_2", "nx_3", "ny_0", "ny_1", "ny_2", "ny_3", "nz_0", "nz_1", "nz_2", "nz_3", "per_reach", "turn_rate_0", "turn_rate_1", "turn_rate_2", "turn_rate_3", "tx_0", "tx_1", "tx_2", "ty_0", "ty_1", "ty_2", "tz_0", "tz_1", "tz_2", "vx_0", "vx_1", "vx_2", "vx_3", "vy_0", "vy_1", "vy_2", "vy_3", "vz_0", "vz_1", "vz_2", "vz_3",),
    "roll_4": ("bent_x", "bent_y", "bent_z", "p_gravity", "lift_0", "lift_1", "lift_2", "lift_3", "nx_0", "nx_1", "nx_2", "nx_3", "nx_4", "ny_0", "ny_1", "ny_2", "ny_3", "ny_4", "nz_0", "nz_1", "nz_2", "nz_3", "nz_4", "per_reach", "turn_rate_0", "turn_rate_1", "turn_rate_2", "turn_rate_3", "turn_rate_4", "tx_0", "tx_1", "tx_2", "tx_3", "ty_0", "ty_1", "ty_2", "ty_3", "tz_0", "tz_1", "tz_2", "tz_3", "vx_0", "vx_1", "vx_2", "vx_3", "vx_4", "vy_0", "vy_1", "vy_2", "vy_3", "vy_4", "vz_0", "vz_1", "vz_2", "vz_3", "vz_4",),
    "roll_5": ("bent_x", "bent_y", "bent_z", "p_gravity", "lift_0", "lift_1", "lift_2", "lift_3", "lift_4", "nx_0", "nx_1", "nx_2", "nx_3", "nx_4", "nx_5", "ny_0", "ny_1", "ny_2", "ny_3", "ny_4", "ny_5", "nz_0", "nz_1", "nz_2", "nz_3", "nz_4", "nz_5", "per_reach", "turn_rate_0", "turn_rate_1", "turn_rate_2", "turn_rate_3", "turn_rate_4", "turn_rate_5", "tx_0", "tx_1", "tx_2", "tx_3", "tx_4", "ty_0", "ty_1", "ty_2", "ty_3", "ty_4", "tz_0", "tz_1", "tz_2", "tz_3", "tz_4", "vx_0", "vx_1", "vx_2", "vx_3", "vx_4", "vx_5", "vy_0", "vy_1", "vy_2", "vy_3", "vy_4", "vy_5", "vz_0", "vz_1", "vz_2", "vz_3", "vz_4", "vz_5",),
    "roll_6": ("bent_x", "bent_y", "bent_z", "p_gravity", "lift_0", "lift_1", "lift_2", "lift_3", "lift_4", "lift_5", "nx_0", "nx_1", "nx_2", "nx_3", "nx_4", "nx_5", "nx_6", "ny_0", "ny_1", "ny_2", "ny_3", "ny_4", "ny_5", "ny_6", "nz_0", "nz_1", "nz_2", "nz_3", "nz_4", "nz_5", "nz_6", "per_reach", "turn_rate_0", "turn_rate_1", "turn_rate_2", "turn_rate_3", "turn_rate_4", "turn_rate_5", "turn_rate_6", "tx_0", "tx_1", "tx_2", "tx_3", "tx_4", "tx_5", "ty_0", "ty_1", "ty_2", "ty_3", "ty_4", "ty_5", "tz_0", "tz_1", "tz_2", "tz_3", "tz_4", "tz_5", "vx_0", "vx_1", "vx_2", "vx_3", "vx_4", "vx_5", "vx_6", "vy_0", "vy_1", "vy_2", "vy_3", "vy_4", "vy_5", "vy_6", "vz_0", "vz_1", "vz_2", "vz_3", "vz_4", "vz_5", "vz_6",),
    "roll_7": ("bent_x", "bent_y", "bent_z", "p_gravity", "lift_0", "lift_1", "lift_2", "lift_3", "lift_4", "lift_5", "lift_6", "nx_0", "nx_1", "nx_2", "nx_3", "nx_4", "nx_5", "nx_6", "nx_7", "ny_0", "ny_1", "ny_2", "ny_3", "ny_4", "ny_5", "ny_6", "ny_7", "nz_0", "nz_1", "nz_2", "nz_3", "nz_4", "nz_5", "nz_6", "nz_7", "per_reach", "turn_rate_0", "turn_rate_1", "turn_rate_2", "turn_rate_3", "turn_rate_4", "turn_rate_5", "turn_rate_6", "turn_rate_7", "tx_0", "tx_1", "tx_2", "tx_3", "tx_4", "tx_5", "tx_6", "ty_0", "ty_1", "ty_2", "ty_3", "ty_4", "ty_5", "ty_6", "tz_0", "tz_1", "tz_2", "tz_3", "tz_4", "tz_5", "tz_6", "vx_0", "vx_1", "vx_2", "vx_3", "vx_4", "vx_5", "vx_6", "vx_7", "vy_0", "vy_1", "vy_2", "vy_3", "vy_4", "vy_5", "vy_6", "vy_7", "vz_0", "vz_1", "vz_2", "vz_3", "vz_4", "vz_5", "vz_6", "vz_7",),
    "anew": (),
    "started": ("p_gravity", "t", "vx", "vy", "vz", "x", "y", "z",),
    "roll_start": ("p_ball_radius", "nx", "ny", "nz", "vx", "vy", "vz", "wx", "wy", "wz",),
    "roll_moved": ("t", "turn_rate_0", "turn_rate_1", "turn_rate_2", "turn_rate_3", "turn_rate_4", "turn_rate_5", "turn_rate_6", "turn_rate_7", "turn_rate_8", "vx_0", "vx_1", "vx_2", "vx_3", "vx_4", "vx_5", "vx_6", "vx_7", "vx_8", "vy_0", "vy_1", "vy_2", "vy_3", "vy_4", "vy_5", "vy_6", "vy_7", "vy_8", "vz_0", "vz_1", "vz_2", "vz_3", "vz_4", "vz_5", "vz_6", "vz_7", "vz_8", "x", "y", "z",),
    "roll_placed": ("p_ball_radius", "gap", "nx", "ny", "nz", "turn_rate", "vx", "vy", "vz", "x", "y", "z",),
    "roll_pace": ("p_gravity", "lift_0", "lift_1", "lift_2", "lift_3", "lift_4", "lift_5", "lift_6", "lift_7", "nx_8", "ny_8", "nz_0", "nz_1", "nz_2", "nz_3", "nz_4", "nz_5", "nz_6", "nz_7", "nz_8", "per_reach", "turn_rate_0", "turn_rate_1", "turn_rate_2", "turn_rate_3", "turn_rate_4", "turn_rate_5", "turn_rate_6", "turn_rate_7", "turn_rate_8", "vx_0", "vx_1", "vx_2", "vx_3", "vx_4", "vx_5", "vx_6", "vx_7", "vx_8", "vy_0", "vy_1", "vy_2", "vy_3", "vy_4", "vy_5", "vy_6", "vy_7", "vy_8", "vz_0", "vz_1", "vz_2", "vz_3", "vz_4", "vz_5", "vz_6", "vz_7", "vz_8",),
    "roll_turn_rate": ("p_ball_radius", "nx", "ny", "nz", "wx", "wy", "wz",),
    "pressed_on": ("p_ball_radius", "p_gravity", "nx", "ny", "nz", "rolled_x", "rolled_y", "rolled_z", "turning_x", "turning_y", "turning_z", "wx", "wy", "wz",),
    "slowed": ("p_ball_radius", "p_gravity", "nx", "ny", "nz", "position_error", "vx", "vy", "vz",),
    "unslowed": (),
    "nearly": ("p_ball_radius", "p_gravity", "nx", "ny", "nz", "vx", "vy", "vz",),
    "gripped": ("p_ball_radius", "nx", "ny", "nz", "vx", "vy", "vz", "wx", "wy", "wz",),
    "alone": (),
    "neared_body": ("facing", "gap", "nearest", "nearing", "press", "swerve", "wedge",),
    "neared": ("gap", "nearest",),
    "begun_errors": ("p_ball_radius", "dvx", "dvy", "dvz", "dwx", "dwy", "dwz", "dx", "dy", "dz", "vx", "vy", "vz",),
    "leaving_force": ("p_ball_radius", "brace", "doubt", "fastest", "force", "force_bend", "force_rate", "p_gravity", "per_reach", "position_error", "stride", "velocity_error", "vx", "vx_1", "vy", "vy_1", "vz", "vz_1", "which",),
    "beside_body": ("p_ball_radius", "dent", "doubt", "fastest", "gap", "index", "late", "nearing", "position_error", "stride", "strongest", "which", "x", "y", "z",),
    "beside_gate": ("p_ball_radius", "dent", "doubt", "fastest", "gap", "index", "late", "nearing", "position_error", "stride", "strongest", "which", "x", "y", "z",),
    "beside_seam": ("fastest", "gap", "near", "nearing", "stride", "strongest",),
    "beside_time": ("clock", "stride", "time_limit", "which",),
    "rolled_on": ("clock", "rests", "stride", "which",),
    "unmet": (),
    "spared": ("dent", "gap", "p_gravity", "nearing", "spare", "vx", "vy", "vz",),
    "spared_seam": ("gap", "p_gravity", "near", "nearing", "spare",),
    "parted": ("doubt", "p_gravity", "lift", "per_reach", "position_error", "snap", "spare", "surge", "velocity_error", "vx", "vy", "vz",),
    "apart": ("p_ball_radius", "dvx", "dvy", "dvz", "dwx", "dwy", "dwz", "dx", "dy", "dz",),
    "neighbour": ("apart", "dvx", "dvy", "dvz", "dwx", "dwy", "dwz", "dx", "dy", "dz", "vx", "vy", "vz", "wx", "wy", "wz", "x", "y", "z",),
    "compared": ("apart", "p_ball_radius", "far_vx", "far_vy", "far_vz", "far_wx", "far_wy", "far_wz", "far_x", "far_y", "far_z", "vx", "vy", "vz", "wx", "wy", "wz", "x", "y", "z",),
    "carry_hop": ("dvx", "dvy", "dvz", "dx", "dy", "dz", "vx", "vy", "vz", "when", "x", "y", "z",),
    "kept": ("mode", "when",),
    "opens_in_flight": ("clear", "kept",),
    "reachable_in_flight": ("kept", "reachable",),
    "resumed": ("clock", "mode", "position_error", "velocity_error",),
    "doubted_in_contact": ("assured", "doubt", "edge", "last", "late", "uncertain", "when", "which",),
    "holding": ("held", "index",),
    "beside": ("held", "index",),
    "unhopped": (),
    "beginning_contact": (),
    "hopping": (),
    "kept_on": ("began", "body", "clock", "doubt", "ends", "held", "last", "reached", "rests", "rolling", "rolls", "which",),
    "settled": ("index", "lodges", "nearly", "outcome", "parts", "settles", "slides", "uncertain", "unsure",),
    "pulled": ("p_gravity", "nx_0", "nx_1", "ny_0", "ny_1", "nz_0", "nz_1", "turn_rate_0", "turn_rate_1", "tx_0", "tx_1", "ty_0", "ty_1", "tz_0", "tz_1",),
    "untaut": (),
    "losing": ("grip_lost", "strain",),
    "lost_grip": ("clock", "strain", "strain_rate", "taut", "taut_clock", "taut_rate",),
    "tightened": ("clock", "strain", "strain_rate",),
    "ring_impact_taken": ("p_ring_restitution", "p_ring_friction",),
    "ring_impact_doubt": ("vx", "vy", "vz", "wx", "wy", "wz", "nx", "ny", "nz", "dvx", "dvy", "dvz", "dwx", "dwy", "dwz", "turn", "p_ball_radius", "p_ring_restitution", "p_ring_friction", "p_tangential_restitution", "p_restitution_speed",),
    "ring_impact_settling": ("p_ball_radius", "bounce", "drag", "lift", "nearest", "press", "p_ring_friction", "p_ring_restitution", "rolled_x", "rolled_y", "rolled_z", "slip", "turning_x", "turning_y", "turning_z", "velocity_error", "wedge", "weight", "wx", "wy", "wz",),
    "ring_impact_strained": ("drag", "drag_rate", "force", "force_rate", "p_ring_friction",),
    "ring_impact": ("vx", "vy", "vz", "wx", "wy", "wz", "nx", "ny", "nz", "p_ball_radius", "p_ring_restitution", "p_ring_friction", "p_tangential_restitution", "p_restitution_speed",),
    "carry_ring_impact": ("vx", "vy", "vz", "wx", "wy", "wz", "nx", "ny", "nz", "dvx", "dvy", "dvz", "dwx", "dwy", "dwz", "dnx", "dny", "dnz", "turn", "lifting", "p_ball_radius", "p_ring_restitution", "p_ring_friction", "p_tangential_restitution", "p_restitution_speed",),
    "ring_coefficients": ("x", "y", "z", "vx", "vy", "vz", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_gravity",),
    "ring_deflated": ("x", "y", "z", "vx", "vy", "vz", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_gravity",),
    "ring_normal": ("x", "y", "z", "p_ball_radius", "p_ring_radius", "p_wire_radius",),
    "ring_curvature": ("p_ball_radius", "p_ring_radius", "p_wire_radius",),
    "ring_carry_normal": ("x", "y", "dx", "dy", "dz", "shift", "p_ball_radius", "p_ring_radius", "p_wire_radius",),
    "ring_clear": ("horizon", "x", "y", "z", "vx", "vy", "vz", "extent", "speed", "position_error", "velocity_error", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_gravity",),
    "ring_prepare": ("horizon", "x", "y", "z", "vx", "vy", "vz", "extent", "speed", "position_error", "velocity_error", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_gravity",),
    "ring_margins": ("horizon", "extent", "speed", "position_error", "velocity_error", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_gravity",),
    "ring_refine": ("t", "leaving", "x", "y", "z", "vx", "vy", "vz", "rho_start", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_gravity",),
    "ring_advance": ("t", "end", "leaving", "margin", "rate_margin", "ceiling", "x", "y", "z", "vx", "vy", "vz", "steady", "swing", "rho_start", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_gravity",),
    "ring_opened": ("horizon", "x", "y", "z", "vx", "vy", "vz", "extent", "speed", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_gravity",),
    "ring_grain": ("t", "end", "leaving", "horizon", "x", "y", "z", "vx", "vy", "vz", "extent", "speed", "parting", "drift", "low1", "high1", "low2", "high2", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_gravity",),
    "ring_leap": ("t", "end", "rate_margin", "ceiling", "x", "y", "z", "vx", "vy", "vz", "steady", "swing", "rho_start", "flat", "tilt", "grit", "jerk", "parting", "drift", "low1", "high1", "low2", "high2", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_gravity",),
    "ring_started": ("x", "y", "z", "vx", "vy", "vz", "p_ring_radius",),
    "ring_lost": ("horizon", "extent", "speed", "position_error", "velocity_error", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_gravity",),
    "ring_beside": ("p_ball_radius", "p_ring_radius", "vx", "vy", "vz", "p_wire_radius", "x", "y", "z",),
    "ring_closing": ("p_ball_radius", "nx", "ny", "nz", "p_ring_radius", "rolled_x", "rolled_y", "rolled_z", "thrust_x", "thrust_y", "thrust_z", "p_wire_radius", "x", "y", "z",),
    "ring_off": ("p_ball_radius", "p_ring_radius", "p_wire_radius", "x", "y", "z",),
    "ring_tube": ("p_ball_radius", "p_wire_radius",),
    "ring_turning": ("p_ball_radius", "p_ring_radius", "rolled_x", "rolled_y", "rolled_z", "p_wire_radius", "x", "y",),
    "ring_parting": ("p_gravity", "p_ring_radius", "vx", "vy", "vz", "x", "y", "z",),
    "ring_round_start": ("p_ball_radius", "p_ring_radius", "vx", "vy", "vz", "p_wire_radius", "wx", "wy", "wz", "x", "y", "z",),
    "ring_round_moved": ("along_0", "along_1", "along_10", "along_11", "along_12", "along_2", "along_3", "along_4", "along_5", "along_6", "along_7", "along_8", "along_9", "p_ball_radius", "climb_0", "climb_1", "climb_10", "climb_11", "climb_12", "climb_2", "climb_3", "climb_4", "climb_5", "climb_6", "climb_7", "climb_8", "climb_9", "cos_0", "cos_1", "cos_10", "cos_11", "cos_12", "cos_2", "cos_3", "cos_4", "cos_5", "cos_6", "cos_7", "cos_8", "cos_9", "cosine_0", "cosine_1", "cosine_10", "cosine_11", "cosine_12", "cosine_2", "cosine_3", "cosine_4", "cosine_5", "cosine_6", "cosine_7", "cosine_8", "cosine_9", "p_ring_radius", "sin_0", "sin_1", "sin_10", "sin_11", "sin_12", "sin_2", "sin_3", "sin_4", "sin_5", "sin_6", "sin_7", "sin_8", "sin_9", "sine_0", "sine_1", "sine_10", "sine_11", "sine_12", "sine_2", "sine_3", "sine_4", "sine_5", "sine_6", "sine_7", "sine_8", "sine_9", "t", "turn_rate_0", "turn_rate_1", "turn_rate_10", "turn_rate_11", "turn_rate_12", "turn_rate_2", "turn_rate_3", "turn_rate_4", "turn_rate_5", "turn_rate_6", "turn_rate_7", "turn_rate_8", "turn_rate_9", "p_wire_radius",),
    "ring_round_pace": ("along_0", "along_1", "along_10", "along_11", "along_12", "along_2", "along_3", "along_4", "along_5", "along_6", "along_7", "along_8", "along_9", "p_ball_radius", "climb_0", "climb_1", "climb_10", "climb_11", "climb_12", "climb_2", "climb_3", "climb_4", "climb_5", "climb_6", "climb_7", "climb_8", "climb_9", "cos_0", "cos_12", "cosine_0", "cosine_12", "force_0", "force_1", "force_10", "force_11", "force_2", "force_3", "force_4", "force_5", "force_6", "force_7", "force_8", "force_9", "p_gravity", "omega_0", "p_ring_radius", "sin_0", "sin_12", "sine_0", "sine_12", "turn_rate_0", "turn_rate_11", "turn_rate_12", "p_wire_radius",),
    "ring_round_pulled": ("climb_0", "climb_1", "cosine_0", "cosine_1", "p_gravity", "omega_0", "omega_1", "turn_rate_0", "turn_rate_1",),
    "ring_swung": ("p_ball_radius", "berth", "circled", "climb", "climb_0", "doubt", "fastest", "force", "force_bend", "force_rate", "p_gravity", "position_error", "stride", "sway", "velocity_error", "which", "p_wire_radius",),
    "ring_round_0": ("along_0", "p_ball_radius", "climb_0", "cos_0", "cosine_0", "p_gravity", "near_0", "p_ring_radius", "sin_0", "sine_0", "turn_rate_0", "p_wire_radius",),
    "ring_round_1": ("along_0", "along_1", "around_0", "p_ball_radius", "climb_0", "climb_1", "cos_0", "cos_1", "cosine_0", "cosine_1", "p_gravity", "near_0", "omega_0", "pressed_0", "p_ring_radius", "sin_0", "sin_1", "sine_0", "sine_1", "tilted_0", "turn_rate_0", "turn_rate_1", "p_wire_radius",),
    "ring_round_2": ("along_0", "along_1", "along_2", "around_0", "around_1", "p_ball_radius", "climb_0", "climb_1", "climb_2", "cos_0", "cos_1", "cos_2", "cosine_0", "cosine_1", "cosine_2", "p_gravity", "near_0", "near_1", "omega_0", "omega_1", "pressed_0", "pressed_1", "p_ring_radius", "sin_0", "sin_1", "sin_2", "sine_0", "sine_1", "sine_2", "tilted_0", "tilted_1", "turn_rate_0", "turn_rate_1", "turn_rate_2", "p_wire_radius",),
    "ring_round_3": ("along_0", "along_1", "along_2", "along_3", "around_0", "around_1", "around_2", "p_ball_radius", "climb_0", "climb_1", "climb_2", "climb_3", "cos_0", "cos_1", "cos_2", "cos_3", "cosine_0", "cosine_1", "cosine_2", "cosine_3", "p_gravity", "near_0", "near_1", "near_2", "omega_0", "omega_1", "omega_2", "pressed_0", "pressed_1", "pressed_2", "p_ring_radius", "sin_0", "sin_1", "sin_2", "sin_3", "sine_0", "sine_1", "sine_2", "sine_3", "tilted_0", "tilted_1", "tilted_2", "turn_rate_0", "turn_rate_1", "turn_rate_2", "turn_rate_3", "p_wire_radius",),
    "ring_round_4": ("along_0", "along_1", "along_2", "along_3", "along_4", "around_0", "around_1", "around_2", "around_3", "p_ball_radius", "climb_0", "climb_1", "climb_2", "climb_3", "climb_4", "cos_0", "cos_1", "cos_2", "cos_3", "cos_4", "cosine_0", "cosine_1", "cosine_2", "cosine_3", "cosine_4", "p_gravity", "near_0", "near_1", "near_2", "near_3", "omega_0", "omega_1", "omega_2", "omega_3", "pressed_0", "pressed_1", "pressed_2", "pressed_3", "p_ring_radius", "sin_0", "sin_1", "sin_2", "sin_3", "sin_4", "sine_0", "sine_1", "sine_2", "sine_3", "sine_4", "tilted_0", "tilted_1", "tilted_2", "tilted_3", "turn_rate_0", "turn_rate_1", "turn_rate_2", "turn_rate_3", "turn_rate_4", "p_wire_radius",),
    "ring_round_5": ("along_0", "along_1", "along_2", "along_3", "along_4", "along_5", "around_0", "around_1", "around_2", "around_3", "around_4", "p_ball_radius", "climb_0", "climb_1", "climb_2", "climb_3", "climb_4", "climb_5", "cos_0", "cos_1", "cos_2", "cos_3", "cos_4", "cos_5", "cosine_0", "cosine_1", "cosine_2", "cosine_3", "cosine_4", "cosine_5", "p_gravity", "near_0", "near_1", "near_2", "near_3", "near_4", "omega_0", "omega_1", "omega_2", "omega_3", "omega_4", "pressed_0", "pressed_1", "pressed_2", "pressed_3", "pressed_4", "p_ring_radius", "sin_0", "sin_1", "sin_2", "sin_3", "sin_4", "sin_5", "sine_0", "sine_1", "sine_2", "sine_3", "sine_4", "sine_5", "tilted_0", "tilted_1", "tilted_2", "tilted_3", "tilted_4", "turn_rate_0", "turn_rate_1", "turn_rate_2", "turn_rate_3", "turn_rate_4", "turn_rate_5", "p_wire_radius",),
    "ring_round_6": ("along_0", "along_1", "along_2", "along_3", "along_4", "along_5", "along_6", "around_0", "around_1", "around_2", "around_3", "around_4", "around_5", "p_ball_radius", "climb_0", "climb_1", "climb_2", "climb_3", "climb_4", "climb_5", "climb_6", "cos_0", "cos_1", "cos_2", "cos_3", "cos_4", "cos_5", "cos_6", "cosine_0", "cosine_1", "cosine_2", "cosine_3", "cosine_4", "cosine_5", "cosine_6", "p_gravity", "near_0", "near_1", "near_2", "near_3", "near_4", "near_5", "omega_0", "omega_1", "omega_2", "omega_3", "omega_4", "omega_5", "pressed_0", "pressed_1", "pressed_2", "pressed_3", "pressed_4", "pressed_5", "p_ring_radius", "sin_0", "sin_1", "sin_2", "sin_3", "sin_4", "sin_5", "sin_6", "sine_0", "sine_1", "sine_2", "sine_3", "sine_4", "sine_5", "sine_6", "tilted_0", "tilted_1", "tilted_2", "tilted_3", "tilted_4", "tilted_5", "turn_rate_0", "turn_rate_1", "turn_rate_2", "turn_rate_3", "turn_rate_4", "turn_rate_5", "turn_rate_6", "p_wire_radius",),
    "ring_round_7": ("along_0", "along_1", "along_2", "along_3", "along_4", "along_5", "along_6", "along_7", "around_0", "around_1", "around_2", "around_3", "around_4", "around_5", "around_6", "p_ball_radius", "climb_0", "climb_1", "climb_2", "climb_3", "climb_4", "climb_5", "climb_6", "climb_7", "cos_0", "cos_1", "cos_2", "cos_3", "cos_4", "cos_5", "cos_6", "cos_7", "cosine_0", "cosine_1", "cosine_2", "cosine_3", "cosine_4", "cosine_5", "cosine_6", "cosine_7", "p_gravity", "near_0", "near_1", "near_2", "near_3", "near_4", "near_5", "near_6", "omega_0", "omega_1", "omega_2", "omega_3", "omega_4", "omega_5", "omega_6", "pressed_0", "pressed_1", "pressed_2", "pressed_3", "pressed_4", "pressed_5", "pressed_6", "p_ring_radius", "sin_0", "sin_1", "sin_2", "sin_3", "sin_4", "sin_5", "sin_6", "sin_7", "sine_0", "sine_1", "sine_2", "sine_3", "sine_4", "sine_5", "sine_6", "sine_7", "tilted_0", "tilted_1", "tilted_2", "tilted_3", "tilted_4", "tilted_5", "tilted_6", "turn_rate_0", "turn_rate_1", "turn_rate_2", "turn_rate_3", "turn_rate_4", "turn_rate_5", "turn_rate_6", "turn_rate_7", "p_wire_radius",),
    "ring_round_8": ("along_0", "along_1", "along_2", "along_3", "along_4", "along_5", "along_6", "along_7", "along_8", "around_0", "around_1", "around_2", "around_3", "around_4", "around_5", "around_6", "around_7", "p_ball_radius", "climb_0", "climb_1", "climb_2", "climb_3", "climb_4", "climb_5", "climb_6", "climb_7", "climb_8", "cos_0", "cos_1", "cos_2", "cos_3", "cos_4", "cos_5", "cos_6", "cos_7", "cos_8", "cosine_0", "cosine_1", "cosine_2", "cosine_3", "cosine_4", "cosine_5", "cosine_6", "cosine_7", "cosine_8", "p_gravity", "near_0", "near_1", "near_2", "near_3", "near_4", "near_5", "near_6", "near_7", "omega_0", "omega_1", "omega_2", "omega_3", "omega_4", "omega_5", "omega_6", "omega_7", "pressed_0", "pressed_1", "pressed_2", "pressed_3", "pressed_4", "pressed_5", "pressed_6", "pressed_7", "p_ring_radius", "sin_0", "sin_1", "sin_2", "sin_3", "sin_4", "sin_5", "sin_6", "sin_7", "sin_8", "sine_0", "sine_1", "sine_2", "sine_3", "sine_4", "sine_5", "sine_6", "sine_7", "sine_8", "tilted_0", "tilted_1", "tilted_2", "tilted_3", "tilted_4", "tilted_5", "tilted_6", "tilted_7", "turn_rate_0", "turn_rate_1", "turn_rate_2", "turn_rate_3", "turn_rate_4", "turn_rate_5", "turn_rate_6", "turn_rate_7", "turn_rate_8", "p_wire_radius",),
    "ring_round_9": ("along_0", "along_1", "along_2", "along_3", "along_4", "along_5", "along_6", "along_7", "along_8", "along_9", "around_0", "around_1", "around_2", "around_3", "around_4", "around_5", "around_6", "around_7", "around_8", "p_ball_radius", "climb_0", "climb_1", "climb_2", "climb_3", "climb_4", "climb_5", "climb_6", "climb_7", "climb_8", "climb_9", "cos_0", "cos_1", "cos_2", "cos_3", "cos_4", "cos_5", "cos_6", "cos_7", "cos_8", "cos_9", "cosine_0", "cosine_1", "cosine_2", "cosine_3", "cosine_4", "cosine_5", "cosine_6", "cosine_7", "cosine_8", "cosine_9", "p_gravity", "near_0", "near_1", "near_2", "near_3", "near_4", "near_5", "near_6", "near_7", "near_8", "omega_0", "omega_1", "omega_2", "omega_3", "omega_4", "omega_5", "omega_6", "omega_7", "omega_8", "pressed_0", "pressed_1", "pressed_2", "pressed_3", "pressed_4", "pressed_5", "pressed_6", "pressed_7", "pressed_8", "p_ring_radius", "sin_0", "sin_1", "sin_2", "sin_3", "sin_4", "sin_5", "sin_6", "sin_7", "sin_8", "sin_9", "sine_0", "sine_1", "sine_2", "sine_3", "sine_4", "sine_5", "sine_6", "sine_7", "sine_8", "sine_9", "tilted_0", "tilted_1", "tilted_2", "tilted_3", "tilted_4", "tilted_5", "tilted_6", "tilted_7", "tilted_8", "turn_rate_0", "turn_rate_1", "turn_rate_2", "turn_rate_3", "turn_rate_4", "turn_rate_5", "turn_rate_6", "turn_rate_7", "turn_rate_8", "turn_rate_9", "p_wire_radius",),
    "ring_round_10": ("along_0", "along_1", "along_10", "along_2", "along_3", "along_4", "along_5", "along_6", "along_7", "along_8", "along_9", "around_0", "around_1", "around_2", "around_3", "around_4", "around_5", "around_6", "around_7", "around_8", "around_9", "p_ball_radius", "climb_0", "climb_1", "climb_10", "climb_2", "climb_3", "climb_4", "climb_5", "climb_6", "climb_7", "climb_8", "climb_9", "cos_0", "cos_1", "cos_10", "cos_2", "cos_3", "cos_4", "cos_5", "cos_6", "cos_7", "cos_8", "cos_9", "cosine_0", "cosine_1", "cosine_10", "cosine_2", "cosine_3", "cosine_4", "cosine_5", "cosine_6", "cosine_7", "cosine_8", "cosine_9", "p_gravity", "near_0", "near_1", "near_2", "near_3", "near_4", "near_5", "near_6", "near_7", "near_8", "near_9", "omega_0", "omega_1", "omega_2", "omega_3", "omega_4", "omega_5", "omega_6", "omega_7", "omega_8", "omega_9", "pressed_0", "pressed_1", "pressed_2", "pressed_3", "pressed_4", "pressed_5", "pressed_6", "pressed_7", "pressed_8", "pressed_9", "p_ring_radius", "sin_0", "sin_1", "sin_10", "sin_2", "sin_3", "sin_4", "sin_5", "sin_6", "sin_7", "sin_8", "sin_9", "sine_0", "sine_1", "sine_10", "sine_2", "sine_3", "sine_4", "sine_5", "sine_6", "sine_7", "sine_8", "sine_9", "tilted_0", "tilted_1", "tilted_2", "tilted_3", "tilted_4", "tilted_5", "tilted_6", "tilted_7", "tilted_8", "tilted_9", "turn_rate_0", "turn_rate_1", "turn_rate_10", "turn_rate_2", "turn_rate_3", "turn_rate_4", "turn_rate_5", "turn_rate_6", "turn_rate_7", "turn_rate_8", "turn_rate_9", "p_wire_radius",),
    "ring_round_11": ("along_0", "along_1", "along_10", "along_11", "along_2", "along_3", "along_4", "along_5", "along_6", "along_7", "along_8", "along_9", "around_0", "around_1", "around_10", "around_2", "around_3", "around_4", "around_5", "around_6", "around_7", "around_8", "around_9", "p_ball_radius", "climb_0", "climb_1", "climb_10", "climb_11", "climb_2", "climb_3", "climb_4", "climb_5", "climb_6", "climb_7", "climb_8", "climb_9", "cos_0", "cos_1", "cos_10", "cos_11", "cos_2", "cos_3", "cos_4", "cos_5", "cos_6", "cos_7", "cos_8", "cos_9", "cosine_0", "cosine_1", "cosine_10", "cosine_11", "cosine_2", "cosine_3", "cosine_4", "cosine_5", "cosine_6", "cosine_7", "cosine_8", "cosine_9", "p_gravity", "near_0", "near_1", "near_10", "near_2", "near_3", "near_4", "near_5", "near_6", "near_7", "near_8", "near_9", "omega_0", "omega_1", "omega_10", "omega_2", "omega_3", "omega_4", "omega_5", "omega_6", "omega_7", "omega_8", "omega_9", "pressed_0", "pressed_1", "pressed_10", "pressed_2", "pressed_3", "pressed_4", "pressed_5", "pressed_6", "pressed_7", "pressed_8", "pressed_9", "p_ring_radius", "sin_0", "sin_1", "sin_10", "sin_11", "sin_2", "sin_3", "sin_4", "sin_5", "sin_6", "sin_7", "sin_8", "sin_9", "sine_0", "sine_1", "sine_10", "sine_11", "sine_2", "sine_3", "sine_4", "sine_5", "sine_6", "sine_7", "sine_8", "sine_9", "tilted_0", "tilted_1", "tilted_10", "tilted_2", "tilted_3", "tilted_4", "tilted_5", "tilted_6", "tilted_7", "tilted_8", "tilted_9", "turn_rate_0", "turn_rate_1", "turn_rate_10", "turn_rate_11", "turn_rate_2", "turn_rate_3", "turn_rate_4", "turn_rate_5", "turn_rate_6", "turn_rate_7", "turn_rate_8", "turn_rate_9", "p_wire_radius",),
    "ring_enter": ("after", "end", "high0", "high1", "high2", "low0", "low1", "low2", "t",),
    "backboard_normal": ("x", "y", "z", "p_ball_radius", "p_board_distance", "p_board_half_width", "p_board_bottom", "p_board_top", "p_board_thickness",),
    "backboard_curvature": ("p_ball_radius",),
    "backboard_carry_normal": ("x", "y", "z", "dx", "dy", "dz", "shift", "p_ball_radius", "p_board_distance", "p_board_half_width", "p_board_bottom", "p_board_top", "p_board_thickness",),
    "backboard_prepare": ("horizon", "x", "y", "z", "vx", "vy", "vz", "extent", "speed", "position_error", "velocity_error", "p_ball_radius", "p_board_distance", "p_board_half_width", "p_board_bottom", "p_board_top", "p_board_thickness", "p_gravity",),
    "backboard_margins": ("horizon", "extent", "speed", "position_error", "velocity_error", "p_ball_radius", "p_board_distance", "p_board_half_width", "p_board_bottom", "p_board_top", "p_board_thickness", "p_gravity",),
    "backboard_refine": ("t", "leaving", "x", "y", "z", "vx", "vy", "vz", "p_ball_radius", "p_board_distance", "p_board_half_width", "p_board_bottom", "p_board_top", "p_board_thickness", "p_gravity",),
    "backboard_advance": ("t", "end", "leaving", "margin", "rate_margin", "ceiling", "x", "y", "z", "vx", "vy", "vz", "p_ball_radius", "p_board_distance", "p_board_half_width", "p_board_bottom", "p_board_top", "p_board_thickness", "p_gravity",),
    "backboard_near": ("middle_x", "middle_y", "middle_z", "reach_x", "reach_y", "reach_z", "later_middle_x", "later_middle_y", "later_middle_z", "later_reach_x", "later_reach_y", "later_reach_z", "p_ball_radius", "p_board_distance", "p_board_half_width", "p_board_bottom", "p_board_top", "p_board_thickness",),
    "backboard_beside": ("p_ball_radius", "p_board_bottom", "p_board_distance", "p_board_half_width", "p_board_thickness", "p_board_top", "vx", "vy", "vz", "x", "y", "z",),
    "backboard_closing": ("p_ball_radius", "p_board_bottom", "p_board_distance", "p_board_half_width", "p_board_thickness", "p_board_top", "nx", "ny", "nz", "rolled_x", "rolled_y", "rolled_z", "thrust_x", "thrust_y", "thrust_z", "x", "y", "z",),
    "backboard_off": ("p_ball_radius", "p_board_bottom", "p_board_distance", "p_board_half_width", "p_board_thickness", "p_board_top", "x", "y", "z",),
    "backboard_tube": ("p_ball_radius", "p_board_bottom", "p_board_distance", "p_board_half_width", "p_board_thickness", "p_board_top", "vx", "vy", "vz", "x", "y", "z",),
    "backboard_turning": ("p_ball_radius", "p_board_bottom", "p_board_distance", "p_board_half_width", "p_board_thickness", "p_board_top", "rolled_x", "rolled_y", "rolled_z", "x", "y", "z",),
    "backboard_parting": ("p_board_bottom", "p_board_distance", "p_board_half_width", "p_board_thickness", "p_board_top", "p_gravity", "vx", "vy", "vz", "x", "y", "z",),
    "backboard_seam0": ("p_ball_radius", "p_board_distance", "p_board_thickness", "vx", "x",),
    "backboard_seam1": ("p_ball_radius", "p_board_distance", "p_board_thickness", "vx", "x",),
    "backboard_seam2": ("p_ball_radius", "p_board_half_width", "vy", "y",),
    "backboard_seam3": ("p_ball_radius", "p_board_half_width", "vy", "y",),
    "backboard_seam4": ("p_ball_radius", "p_board_bottom", "p_board_top", "vz", "z",),
    "backboard_seam5": ("p_ball_radius", "p_board_bottom", "p_board_top", "vz", "z",),
    "backboard_around": ("p_ball_radius", "p_board_bottom", "p_board_distance", "p_board_half_width", "p_board_thickness", "p_board_top", "vx", "vy", "vz", "x", "y", "z",),
    "backboard_enter": ("after", "end", "high0", "high1", "low0", "low1", "t",),
    "bridge_normal": ("x", "y", "z", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_board_distance", "p_bridge_half_width", "p_bridge_depth",),
    "bridge_curvature": ("p_ball_radius",),
    "bridge_carry_normal": ("x", "y", "z", "dx", "dy", "dz", "shift", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_board_distance", "p_bridge_half_width", "p_bridge_depth",),
    "bridge_prepare": ("horizon", "x", "y", "z", "vx", "vy", "vz", "extent", "speed", "position_error", "velocity_error", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_board_distance", "p_bridge_half_width", "p_bridge_depth", "p_gravity",),
    "bridge_margins": ("horizon", "extent", "speed", "position_error", "velocity_error", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_board_distance", "p_bridge_half_width", "p_bridge_depth", "p_gravity",),
    "bridge_refine": ("t", "leaving", "x", "y", "z", "vx", "vy", "vz", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_board_distance", "p_bridge_half_width", "p_bridge_depth", "p_gravity",),
    "bridge_advance": ("t", "end", "leaving", "margin", "rate_margin", "ceiling", "x", "y", "z", "vx", "vy", "vz", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_board_distance", "p_bridge_half_width", "p_bridge_depth", "p_gravity",),
    "bridge_near": ("middle_x", "middle_y", "middle_z", "reach_x", "reach_y", "reach_z", "later_middle_x", "later_middle_y", "later_middle_z", "later_reach_x", "later_reach_y", "later_reach_z", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_board_distance", "p_bridge_half_width", "p_bridge_depth",),
    "bridge_beside": ("p_ball_radius", "p_board_distance", "p_bridge_depth", "p_bridge_half_width", "p_ring_radius", "vx", "vy", "vz", "p_wire_radius", "x", "y", "z",),
    "bridge_closing": ("p_ball_radius", "p_board_distance", "p_bridge_depth", "p_bridge_half_width", "nx", "ny", "nz", "p_ring_radius", "rolled_x", "rolled_y", "rolled_z", "thrust_x", "thrust_y", "thrust_z", "p_wire_radius", "x", "y", "z",),
    "bridge_off": ("p_ball_radius", "p_board_distance", "p_bridge_depth", "p_bridge_half_width", "p_ring_radius", "p_wire_radius", "x", "y", "z",),
    "bridge_tube": ("p_ball_radius", "p_board_distance", "p_bridge_depth", "p_bridge_half_width", "p_ring_radius", "vx", "vy", "vz", "p_wire_radius", "x", "y", "z",),
    "bridge_turning": ("p_ball_radius", "p_board_distance", "p_bridge_depth", "p_bridge_half_width", "p_ring_radius", "rolled_x", "rolled_y", "rolled_z", "p_wire_radius", "x", "y", "z",),
    "bridge_parting": ("p_board_distance", "p_bridge_depth", "p_bridge_half_width", "p_gravity", "p_ring_radius", "vx", "vy", "vz", "p_wire_radius", "x", "y", "z",),
    "bridge_seam0": ("p_ball_radius", "p_board_distance", "p_ring_radius", "vx", "x",),
    "bridge_seam1": ("p_ball_radius", "p_board_distance", "p_ring_radius", "vx", "x",),
    "bridge_seam2": ("p_ball_radius", "p_bridge_half_width", "vy", "y",),
    "bridge_seam3": ("p_ball_radius", "p_bridge_half_width", "vy", "y",),
    "bridge_seam4": ("p_ball_radius", "p_bridge_depth", "vz", "p_wire_radius", "z",),
    "bridge_seam5": ("p_ball_radius", "p_bridge_depth", "vz", "p_wire_radius", "z",),
    "bridge_around": ("p_ball_radius", "p_board_distance", "p_bridge_depth", "p_bridge_half_width", "p_ring_radius", "vx", "vy", "vz", "p_wire_radius", "x", "y", "z",),
    "bridge_enter": ("after", "end", "high0", "high1", "low0", "low1", "t",),
    "end_coefficients": ("z", "vz", "p_gravity", "p_end_depth",),
    "end_deflated": ("vz", "p_gravity",),
    "end_normal": (),
    "end_curvature": (),
    "end_arrival": ("leaving", "z", "vz", "p_gravity", "p_end_depth",),
    "end_margin": ("horizon", "extent", "speed", "position_error", "velocity_error", "p_gravity", "p_end_depth",),
    "end_place": ("x", "y", "p_end_depth",),
    "end_bounds": ("x", "y", "p_ring_radius",),
    "end_beside": ("p_end_depth", "vz", "z",),
    "end_closing": ("p_end_depth", "nz", "rolled_z", "thrust_z", "z",),
    "end_off": ("p_end_depth", "z",),
    "end_tube": (),
    "end_turning": (),
    "end_parting": ("p_gravity",),
    "end_around": ("p_end_depth", "vz", "z",),
    "end_reached": ("g0", "through",),
    "end_edge": ("g0", "slack", "through",),
    "aimed_speed": ("slope", "reach", "rise", "p_gravity",),
    "entry_slope": ("slope", "reach", "rise",),
    "slope_of_entry": ("entry", "reach", "rise",),
    "least_speed": ("reach", "rise", "p_gravity",),
    "slopes_of_speed": ("release_speed", "reach", "rise", "p_gravity",),
    "descent": ("z", "vz", "level", "p_gravity",),
    "apex": ("z", "vz", "p_gravity",),
    "sighted": ("x", "y", "place_x", "place_y",),
    "ring_nearness": ("t", "x", "y", "z", "vx", "vy", "vz", "half", "p_ball_radius", "p_ring_radius", "p_wire_radius", "p_gravity",),
}
"""Names of each kernel's arguments; rows to write into, which some take after them, are none."""

OUTPUTS: dict[str, tuple[str, ...]] = {
    "flight": ("x", "y", "z", "vx", "vy", "vz",),
    "contact_frame": ("n11", "n12", "n13", "n21", "n22", "n23", "n31", "n32", "n33",),
    "impact_through_frame": ("vx", "vy", "vz", "wx", "wy", "wz",),
    "crossing": ("clearance", "delay",),
    "allowance": ("position_level", "velocity_level", "excess",),
    "horizon": ("horizon", "pad",),
    "scale": ("extent", "speed", "excess",),
    "displacement": ("margin",),
    "carry_flight": ("dx", "dy", "dz", "lifting", "dvx", "dvy", "dvz", "delay", "shift",),
    "carry_time": ("dx", "dy", "dz", "dvx", "dvy", "dvz", "clock_error",),
    "error_bounds": ("position_error", "velocity_error", "spin_error", "time_error",),
    "claimed_errors": ("position_error", "velocity_error", "spin_error", "time_error",),
    "allowed": ("allowed",),
    "finite_parameters": ("permitted",),
    "valid": ("valid", "doubt",),
    "passing_start": ("through", "uncertain",),
    "passing": ("through",),
    "passing_doubt": ("unsure",),
    "passing_from": ("over",),
    "passing_in_contact": ("through",),
    "halved": ("middle_x", "reach_x", "later_middle_x", "later_reach_x", "middle_y", "reach_y", "later_middle_y", "later_reach_y", "middle_z", "reach_z", "later_middle_z", "later_reach_z",),
    "untaken": ("mine",),
    "left": ("leaving",),
    "meeting_plane": ("arrives", "ceiling",),
    "timely": ("possible",),
    "grazed": ("doubt",),
    "questioned": ("doubt",),
    "crossed": ("doubt",),
    "tied": ("doubt", "late",),
    "sooner": ("when", "which",),
    "beginning": ("share", "arrival", "certain",),
    "beyond": ("doubt",),
    "beyond_windows": ("doubt",),
    "nearby": ("leaving", "margin",),
    "opened": ("time", "latest",),
    "coarse": ("leaping", "searching", "served", "ceiling", "flat", "tilt", "allowing",),
    "leapt": ("arrival", "t", "searching",),
    "struck": ("hit", "sure", "vague",),
    "struck_or_still": ("hit", "sure", "vague",),
    "finer": ("share",),
    "exceeded": ("doubt",),
    "advanced": ("arrival", "certain", "exhausted", "searching", "t",),
    "found": ("arrives", "refining", "rate",),
    "polished": ("arrival", "refining",),
    "own_margin": ("margin",),
    "landed": ("time",),
    "landed_surely": ("delay", "doubt",),
    "outside": ("side",),
    "finite_state": ("finite",),
    "opening": ("when", "which", "late", "doubt",),
    "limited": ("limited",),
    "ticked": ("clock",),
    "meeting": ("meeting",),
    "here": ("here",),
    "counted": ("count",),
    "elsewhere": ("curving",),
    "again": ("again",),
    "delayed": ("clock_error",),
    "floored": ("dx", "dy", "dz",),
    "unturned": ("dnx", "dny", "dnz", "turn",),
    "touched": ("first", "last",),
    "timed": ("timed",),
    "closing": ("closed",),
    "undecided": ("uncertain",),
    "body_of": ("body",),
    "admitted": ("outcome", "uncertain",),
    "expiry": ("time", "delay", "arrives", "doubt",),
    "departed": ("stays", "moves", "ends", "touches", "reached", "edge",),
    "expired": ("clock", "body", "reached", "ends",),
    "accounted": ("contacts", "outcome",),
    "circles": ("circling", "rolling",),
    "leaps": ("forth", "back",),
    "cleared": ("berth",),
    "for_ever": ("which",),
    "rejoined": ("rolling",),
    "roll_0": ("lift_0", "tx_0", "ty_0", "tz_0", "vx_1", "vy_1", "vz_1", "nx_1", "ny_1", "nz_1", "turn_rate_1",),
    "roll_1": ("lift_1", "tx_1", "ty_1", "tz_1", "vx_2", "vy_2", "vz_2", "nx_2", "ny_2", "nz_2", "turn_rate_2",),
    "roll_2": ("lift_2", "tx_2", "ty_2", "tz_2", "vx_3", "vy_3", "vz_3", "nx_3", "ny_3", "nz_3", "turn_rate_3",),
    "roll_3": ("lift_3", "tx_3", "ty_3", "tz_3", "vx_4", "vy_4", "vz_4", "nx_4", "ny_4", "nz_4", "turn_rate_4",),
    "roll_4": ("lift_4", "tx_4", "ty_4", "tz_4", "vx_5", "vy_5", "vz_5", "nx_5", "ny_5", "nz_5", "turn_rate_5",),
    "roll_5": ("lift_5", "tx_5", "ty_5", "tz_5", "vx_6", "vy_6", "vz_6", "nx_6", "ny_6", "nz_6", "turn_rate_6",),
    "roll_6": ("lift_6", "tx_6", "ty_6", "tz_6", "vx_7", "vy_7", "vz_7", "nx_7", "ny_7", "nz_7", "turn_rate_7",),
    "roll_7": ("lift_7", "tx_7", "ty_7", "tz_7", "vx_8", "vy_8", "vz_8", "nx_8", "ny_8", "nz_8", "turn_rate_8",),
    "anew": ("left_nx", "left_ny", "left_nz",),
    "started": ("from_x", "from_y", "from_z",),
    "roll_start": ("vx_0", "vy_0", "vz_0", "nx_0", "ny_0", "nz_0", "turn_rate_0",),
    "roll_moved": ("x", "vx", "y", "vy", "z", "vz", "turn_rate",),
    "roll_placed": ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz",),
    "roll_pace": ("stride", "strongest", "fastest", "force", "force_rate", "force_bend", "brace",),
    "roll_turn_rate": ("turn_rate",),
    "pressed_on": ("press", "weight", "drag", "thrust_x", "thrust_y", "thrust_z",),
    "slowed": ("slow", "assured",),
    "unslowed": ("slow",),
    "nearly": ("nearly",),
    "gripped": ("rolled_x", "rolled_y", "rolled_z", "slip", "bounce",),
    "alone": ("nearest", "wedge",),
    "neared_body": ("nearest", "wedge",),
    "neared": ("nearest",),
    "begun_errors": ("dx", "dy", "dz", "dvx", "dvy", "dvz", "dwx", "dwy", "dwz",),
    "leaving_force": ("stride", "which", "rests", "doubt",),
    "beside_body": ("stride", "which", "doubt", "late",),
    "beside_gate": ("stride", "which", "doubt", "late",),
    "beside_seam": ("stride",),
    "beside_time": ("stride", "which",),
    "rolled_on": ("clock", "rolling",),
    "unmet": ("spare",),
    "spared": ("spare",),
    "spared_seam": ("spare",),
    "parted": ("when", "doubt",),
    "apart": ("apart",),
    "neighbour": ("far_x", "far_y", "far_z", "far_vx", "far_vy", "far_vz", "far_wx", "far_wy", "far_wz", "far_nx", "far_ny", "far_nz", "far_gap",),
    "compared": ("dx", "dy", "dz", "dvx", "dvy", "dvz", "dwx", "dwy", "dwz",),
    "carry_hop": ("dx", "dy", "dz",),
    "kept": ("kept", "when", "rests", "rolling", "began",),
    "opens_in_flight": ("open",),
    "reachable_in_flight": ("reachable",),
    "resumed": ("which", "late", "began", "doubt", "begins", "rolling", "leaves", "nx", "ny", "nz", "gap", "bent_x", "bent_y", "bent_z", "lift", "surge", "snap", "per_reach",),
    "doubted_in_contact": ("uncertain",),
    "holding": ("here",),
    "beside": ("beside",),
    "unhopped": ("hopped",),
    "beginning_contact": ("which", "circled",),
    "hopping": ("which",),
    "kept_on": ("body", "reached", "doubt", "ends", "hopped", "last", "mode", "held", "rolls",),
    "settled": ("mode", "held", "outcome", "slip_left", "uncertain",),
    "pulled": ("drag", "drag_rate", "strain", "strain_rate",),
    "untaut": ("taut",),
    "losing": ("loses",),
    "lost_grip": ("grip_lost",),
    "tightened": ("taut", "taut_rate", "taut_clock",),
    "ring_impact_taken": ("mine", "its_0", "its_1",),
    "ring_impact_doubt": ("unsure",),
    "ring_impact_settling": ("settles", "lodges", "slides", "parts", "assured", "unsure",),
    "ring_impact_strained": ("strain", "strain_rate",),
    "ring_impact": ("vx", "vy", "vz", "wx", "wy", "wz",),
    "carry_ring_impact": ("dvx", "dvy", "dvz", "dwx", "dwy", "dwz",),
    "ring_coefficients": ("c0", "c1", "c2", "c3", "c4", "c5", "c6", "c7", "c8",),
    "ring_deflated": ("c0", "c1", "c2", "c3", "c4", "c5", "c6", "c7",),
    "ring_normal": ("nx", "ny", "nz",),
    "ring_curvature": ("curvature",),
    "ring_carry_normal": ("dnx", "dny", "dnz", "turn",),
    "ring_clear": ("clear",),
    "ring_prepare": ("steady", "swing", "rho_start", "low0", "high0", "low1", "high1", "low2", "high2", "ceiling", "latest", "lost",),
    "ring_margins": ("margin", "leaving_margin", "rate_margin",),
    "ring_refine": ("time", "gap", "rate",),
    "ring_advance": ("gap", "rate", "bend", "step", "next", "clearance",),
    "ring_opened": ("t", "end", "searching", "low1", "high1", "low2", "high2", "latest", "sound",),
    "ring_grain": ("share", "t", "end", "x", "y", "z", "vx", "vy", "vz", "steady", "swing", "rho_start", "ceiling", "flat", "tilt", "jerk", "grit", "parting", "drift", "rate_margin", "low1", "high1", "low2", "high2", "fits",),
    "ring_leap": ("t", "end", "certain", "leaping",),
    "ring_started": ("rho_start", "parting", "drift",),
    "ring_lost": ("lost",),
    "ring_beside": ("gap", "nearing", "dent",),
    "ring_closing": ("gap", "nearing", "swerve", "facing",),
    "ring_off": ("gap",),
    "ring_tube": ("bent_x", "bent_y", "bent_z", "per_reach",),
    "ring_turning": ("turning_x", "turning_y", "turning_z",),
    "ring_parting": ("lift", "surge", "snap",),
    "ring_round_start": ("cosine_0", "sine_0", "climb_0", "along_0", "turn_rate_0", "cos_0", "sin_0", "near_0",),
    "ring_round_moved": ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz", "climb",),
    "ring_round_pace": ("stride", "strongest", "fastest", "sway", "force", "force_rate", "force_bend", "brace", "vx_1", "vy_1", "vz_1",),
    "ring_round_pulled": ("drag", "drag_rate", "strain", "strain_rate",),
    "ring_swung": ("circled", "endless", "doubt",),
    "ring_round_0": ("omega_0", "around_0", "tilted_0", "pressed_0", "force_0", "cosine_1", "sine_1", "climb_1", "along_1", "turn_rate_1", "cos_1", "sin_1",),
    "ring_round_1": ("near_1", "omega_1", "around_1", "tilted_1", "pressed_1", "force_1", "cosine_2", "sine_2", "climb_2", "along_2", "turn_rate_2", "cos_2", "sin_2",),
    "ring_round_2": ("near_2", "omega_2", "around_2", "tilted_2", "pressed_2", "force_2", "cosine_3", "sine_3", "climb_3", "along_3", "turn_rate_3", "cos_3", "sin_3",),
    "ring_round_3": ("near_3", "omega_3", "around_3", "tilted_3", "pressed_3", "force_3", "cosine_4", "sine_4", "climb_4", "along_4", "turn_rate_4", "cos_4", "sin_4",),
    "ring_round_4": ("near_4", "omega_4", "around_4", "tilted_4", "pressed_4", "force_4", "cosine_5", "sine_5", "climb_5", "along_5", "turn_rate_5", "cos_5", "sin_5",),
    "ring_round_5": ("near_5", "omega_5", "around_5", "tilted_5", "pressed_5", "force_5", "cosine_6", "sine_6", "climb_6", "along_6", "turn_rate_6", "cos_6", "sin_6",),
    "ring_round_6": ("near_6", "omega_6", "around_6", "tilted_6", "pressed_6", "force_6", "cosine_7", "sine_7", "climb_7", "along_7", "turn_rate_7", "cos_7", "sin_7",),
    "ring_round_7": ("near_7", "omega_7", "around_7", "tilted_7", "pressed_7", "force_7", "cosine_8", "sine_8", "climb_8", "along_8", "turn_rate_8", "cos_8", "sin_8",),
    "ring_round_8": ("near_8", "omega_8", "around_8", "tilted_8", "pressed_8", "force_8", "cosine_9", "sine_9", "climb_9", "along_9", "turn_rate_9", "cos_9", "sin_9",),
    "ring_round_9": ("near_9", "omega_9", "around_9", "tilted_9", "pressed_9", "force_9", "cosine_10", "sine_10", "climb_10", "along_10", "turn_rate_10", "cos_10", "sin_10",),
    "ring_round_10": ("near_10", "omega_10", "around_10", "tilted_10", "pressed_10", "force_10", "cosine_11", "sine_11", "climb_11", "along_11", "turn_rate_11", "cos_11", "sin_11",),
    "ring_round_11": ("near_11", "omega_11", "around_11", "tilted_11", "pressed_11", "force_11", "cosine_12", "sine_12", "climb_12", "along_12", "turn_rate_12", "cos_12", "sin_12",),
    "ring_enter": ("t", "end", "searching",),
    "backboard_normal": ("nx", "ny", "nz",),
    "backboard_curvature": ("curvature",),
    "backboard_carry_normal": ("dnx", "dny", "dnz", "turn",),
    "backboard_prepare": ("low0", "high0", "low1", "high1", "ceiling", "latest", "lost",),
    "backboard_margins": ("margin", "leaving_margin", "rate_margin",),
    "backboard_refine": ("time", "gap", "rate",),
    "backboard_advance": ("gap", "rate", "bend", "step", "next", "clearance",),
    "backboard_near": ("near",),
    "backboard_beside": ("gap", "nearing", "dent",),
    "backboard_closing": ("gap", "nearing", "swerve", "facing",),
    "backboard_off": ("gap",),
    "backboard_tube": ("bent_x", "bent_y", "bent_z", "per_reach",),
    "backboard_turning": ("turning_x", "turning_y", "turning_z",),
    "backboard_parting": ("lift", "surge", "snap",),
    "backboard_seam0": ("gap", "nearing", "near",),
    "backboard_seam1": ("gap", "nearing", "near",),
    "backboard_seam2": ("gap", "nearing", "near",),
    "backboard_seam3": ("gap", "nearing", "near",),
    "backboard_seam4": ("gap", "nearing", "near",),
    "backboard_seam5": ("gap", "nearing", "near",),
    "backboard_around": ("gap", "nearing",),
    "backboard_enter": ("t", "end", "searching",),
    "bridge_normal": ("nx", "ny", "nz",),
    "bridge_curvature": ("curvature",),
    "bridge_carry_normal": ("dnx", "dny", "dnz", "turn",),
    "bridge_prepare": ("low0", "high0", "low1", "high1", "ceiling", "latest", "lost",),
    "bridge_margins": ("margin", "leaving_margin", "rate_margin",),
    "bridge_refine": ("time", "gap", "rate",),
    "bridge_advance": ("gap", "rate", "bend", "step", "next", "clearance",),
    "bridge_near": ("near",),
    "bridge_beside": ("gap", "nearing", "dent",),
    "bridge_closing": ("gap", "nearing", "swerve", "facing",),
    "bridge_off": ("gap",),
    "bridge_tube": ("bent_x", "bent_y", "bent_z", "per_reach",),
    "bridge_turning": ("turning_x", "turning_y", "turning_z",),
    "bridge_parting": ("lift", "surge", "snap",),
    "bridge_seam0": ("gap", "nearing", "near",),
    "bridge_seam1": ("gap", "nearing", "near",),
    "bridge_seam2": ("gap", "nearing", "near",),
    "bridge_seam3": ("gap", "nearing", "near",),
    "bridge_seam4": ("gap", "nearing", "near",),
    "bridge_seam5": ("gap", "nearing", "near",),
    "bridge_around": ("gap", "nearing",),
    "bridge_enter": ("t", "end", "searching",),
    "end_coefficients": ("c0", "c1", "c2",),
    "end_deflated": ("c0", "c1",),
    "end_normal": ("nx", "ny", "nz",),
    "end_curvature": ("curvature",),
    "end_arrival": ("time", "rate", "bend", "apex", "height",),
    "end_margin": ("margin",),
    "end_place": ("x", "y", "z",),
    "end_bounds": ("g0",),
    "end_beside": ("gap", "nearing", "dent",),
    "end_closing": ("gap", "nearing", "swerve", "facing",),
    "end_off": ("gap",),
    "end_tube": ("bent_x", "bent_y", "bent_z", "per_reach",),
    "end_turning": ("turning_x", "turning_y", "turning_z",),
    "end_parting": ("lift", "surge", "snap",),
    "end_around": ("gap", "nearing",),
    "end_reached": ("reached",),
    "end_edge": ("edge",),
    "aimed_speed": ("speed",),
    "entry_slope": ("entry",),
    "slope_of_entry": ("slope",),
    "least_speed": ("slope", "speed",),
    "slopes_of_speed": ("low", "high",),
    "descent": ("time", "vz",),
    "apex": ("time", "height",),
    "sighted": ("past", "left",),
    "ring_nearness": ("gap", "rate", "lower", "concavity", "resolution",),
}
"""Names of each kernel's outputs."""

ROWS = 41
"""Rows that a kernel writes into, at the most: what it computes on the way to its results."""

FEW = 1 << 10
"""So few shots are quicker with fresh arrays than with rows, and without a look at how many differ."""

NO_ROWS: tuple[None, ...] = (None,) * ROWS
"""With these in their place it makes arrays of its own."""


def _bits(value: Any, row: Any) -> Any:
    """Return numbers as the whole numbers of the same bits, of the size of those in a row."""
    return (value if _ndim(value) else row.dtype.type(value)).view(_whole(row))


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
    return [None if row is None else row.view(_float32)[: len(row)] for row in room]


def _select(truth: Any, then: Any, other: Any, row: Any, keep: bool = True) -> Any:
    """Return one value where a truth holds, and another where it does not: either, or a row.

    Where it holds for some shots and not for their neighbours, a branch for each would be guessed
    wrong more often than not: the bits are taken from both.
    """
    if row is None:
        return _where(truth, then, other)
    shots = len(row)
    many = _count_nonzero(truth) if _ndim(truth) else shots * bool(truth)
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
    Returns x, y, z, vx, vy, vz.
    """
    _r0, = _room[:1]
    return x + _multiply(t, vx, _r0), y + _multiply(t, vy, _r0), z + _multiply(t, _subtract(vz, _multiply(0.5 * p_gravity, t, _r0), _r0), _r0), vx, vy, vz - _multiply(p_gravity, t, _r0)


def contact_frame(nx: Any, ny: Any, nz: Any) -> tuple[Any, ...]:
    """The contact frame R = [n1 n2 n3] of a unit normal.

    Eqs. 7-10, Eq. 7 with the smallest component. 72 operations: 6 additions, 3 subtractions, 18 multiplications, 12 divisions, 3 square roots, 9 negations, 3 comparisons, 18 selections.
    Returns n11, n12, n13, n21, n22, n23, n31, n32, n33.
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
    """Velocity and spin after a contact, through the contact frame.

    Eqs. 11-17 by the closed-form inverse. 96 operations: 21 additions, 11 subtractions, 57 multiplications, 6 divisions, 1 negation.
    Returns vx, vy, vz, wx, wy, wz.
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
    """Positive clearance if a crossing is certain, and the bound on its delay.

    Taylor's theorem with the margins of the gap and its rate. 11 operations: 1 addition, 1 subtraction, 4 multiplications, 1 division, 1 negation, 1 comparison, 2 selections.
    Returns clearance, delay.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = _negative(_add(rate, rate_margin, _r0), _r0)
    _s1 = 0.0 < _s0
    return _result(_s1, _subtract(_multiply(_s0, _s0, _r1), _multiply(_multiply(6.0, ceiling, _r2), margin, _r2), _r2), _s0, _r0), _result(_s1, _divide(_multiply(6.0, margin, _r2), _s0, _r2), _inf, _r0)


def allowance(share: Any, horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Errors of a state that a search allows for, and by how much the errors exceed them.

    a share of the size of the flight. 10 operations: 2 additions, 2 subtractions, 4 multiplications, 1 comparison, 1 selection.
    Returns position_level, velocity_level, excess.
    """
    _r0, _r1 = _room[:2]
    _s0 = _add(speed, _multiply(p_gravity, horizon, _r0), _r0)
    _s1 = share * _add(extent, _multiply(horizon, _s0, _r1), _r1)
    _s2 = share * _s0
    _s3 = _subtract(position_error, _s1, _r0)
    _s4 = _subtract(velocity_error, _s2, _r1)
    return _s1, _s2, _result(_s3 < _s4, _s4, _s3, _r0)


def horizon(t: Any, speed: Any, p_gravity: Any) -> tuple[Any, ...]:
    """A time after which no event is wanted, and how long that is after t.

    the earliest arrival, with room for its delay. 5 operations: 2 additions, 2 multiplications, 1 division.
    Returns horizon, pad.
    """
    _s0 = 9.5367431640625e-07 * (t + (speed * (1.0 / p_gravity)))
    return t + _s0, _s0


def scale(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Sums of the sizes of the coordinates and of the velocities; excess over the largest.

    what rounding errors are measured by. 24 operations: 4 additions, 1 subtraction, 1 division, 6 absolute values, 6 comparisons, 6 selections.
    Returns extent, speed, excess.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11 = _room[:12]
    _s0 = _absolute(x, _r0)
    _s1 = _absolute(y, _r1)
    _s2 = _absolute(z, _r2)
    _s3 = _absolute(vx, _r3)
    _s4 = _absolute(vy, _r4)
    _s5 = _absolute(vz, _r5)
    _s6 = 1.0 / p_gravity
    _s7 = _select(_s6 < _s0, _s0, _s6, _r6)
    _s8 = _select(_s7 < _s1, _s1, _s7, _r7)
    _s9 = _select(_s8 < _s2, _s2, _s8, _r8)
    _s10 = _select(_s9 < _s3, _s3, _s9, _r9)
    _s11 = _select(_s10 < _s4, _s4, _s10, _r10)
    return _add(_s0, _s1, _r11) + _s2, _add(_s3, _s4, _r11) + _s5, _select(_s11 < _s5, _s5, _s11, _r11) - 2.9073548971824276e+135


def displacement(delay: Any, horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_gravity: Any, p_end_depth: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Bound on the error of a length at a computed arrival.

    running error analysis. 27 operations: 17 additions, 8 multiplications, 2 absolute values.
    Returns margin.
    """
    _r0, _r1, _r2, _r3 = _room[:4]
    _s0 = _add(speed, _multiply(p_gravity, horizon, _r0), _r0)
    _s1 = _add(extent, _multiply(horizon, _s0, _r1), _r1)
    _s2 = (((((p_ball_radius + p_board_distance) + p_board_half_width) + p_board_thickness) + p_bridge_depth) + p_bridge_half_width) + p_end_depth
    _s3 = _multiply(4.445228907190568e-16, _add(_s1, (((_s2 + p_ring_radius) + p_wire_radius) + _absolute(p_board_bottom)) + _absolute(p_board_top), _r2), _r2)
    return _add(_multiply(_multiply(1.0009765625, delay, _r3), _s0, _r3), _s3, _r2) + _multiply(3.0029296875, _add(_add(position_error, _multiply(horizon, velocity_error, _r3), _r3), _multiply(4.440892098500626e-16, _s1, _r1), _r1), _r1),


def carry_flight(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, nx: Any, ny: Any, nz: Any, clock: Any, contacts: Any, late: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, left_nx: Any, left_ny: Any, left_nz: Any, curving: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Errors of a state at the end of a flight to a surface, from those at its start.

    derivative of Eq. 3 and of the contact time, with roundings. 158 operations: 33 additions, 2 subtractions, 40 multiplications, 3 divisions, 8 negations, 17 absolute values, 23 comparisons, 32 selections.
    Returns dx, dy, dz, lifting, dvx, dvy, dvz, delay, shift.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18, _r19, _r20, _r21, _r22, _r23, _r24, _r25, _r26, _r27, _r28, _r29, _r30, _r31 = _room[:32]
    _s0 = _absolute(vx, _r0)
    _s1 = _absolute(vy, _r1)
    _s2 = _select(_s0 < _s1, _s1, _s0, _r2)
    _s3 = _absolute(vz, _r3)
    _s4 = _select(_s2 < _s3, _s3, _s2, _r4)
    _s5 = _multiply(curving, _multiply(t, _s4, _r5), _r5)
    _s6 = _select(_s5 < 1.0, _s5, 1.0, _r6)
    _s7 = _add(dx, _multiply(dvx, t, _r7), _r7)
    _s8 = _absolute(x, _r8)
    _s9 = _absolute(y, _r9)
    _s10 = _absolute(z, _r10)
    _s11 = _add(1.0, _multiply(curving, _add(_add(_s8, _s9, _r11), _s10, _r11), _r11), _r11)
    _s12 = _multiply(2.0, t, _r12)
    _s13 = _multiply(_s12, _s0, _r13)
    _s14 = _multiply(1.1102230246251565e-16, _add(_s13, _s8, _r8), _r8)
    _s15 = curving < _inf
    _s16 = _select(_s15, _multiply(4.440892098500626e-16, _multiply(_s13, _s11, _r13), _r13), _s14, _r14)
    _s17 = _s7 < 0.0
    _s18 = _add(dy, _multiply(dvy, t, _r15), _r15)
    _s19 = _multiply(_s12, _s1, _r16)
    _s20 = _multiply(1.1102230246251565e-16, _add(_s19, _s9, _r9), _r9)
    _s21 = _select(_s15, _multiply(4.440892098500626e-16, _multiply(_s19, _s11, _r16), _r16), _s20, _r17)
    _s22 = _s18 < 0.0
    _s23 = _add(dz, _multiply(dvz, t, _r18), _r18)
    _s24 = _add(_multiply(p_gravity, _multiply(t, t, _r19), _r19), _multiply(_s12, _s3, _r12), _r12)
    _s25 = _multiply(1.1102230246251565e-16, _add(_s24, _s10, _r10), _r10)
    _s26 = _select(_s15, _multiply(4.440892098500626e-16, _multiply(_s24, _s11, _r12), _r12), _s25, _r11)
    _s27 = _s23 < 0.0
    _s28 = _add(_add(_multiply(nx, _add(_s7, _select(_s17, _negative(_s16, _r19), _s16, _r20), _r20), _r20), _multiply(ny, _add(_s18, _select(_s22, _negative(_s21, _r19), _s21, _r21), _r21), _r21), _r21), _multiply(nz, _add(_s23, _select(_s27, _negative(_s26, _r20), _s26, _r19), _r19), _r19), _r19)
    _s29 = _add(_add(_multiply(nx, vx, _r21), _multiply(ny, vy, _r20), _r20), _multiply(nz, vz, _r21), _r21)
    _s30 = _negative(_divide(_subtract(_s28, _add(_add(_multiply(dx, left_nx, _r20), _multiply(dy, left_ny, _r22), _r22), _multiply(dz, left_nz, _r20), _r20), _r20), _s29, _r20), _r20)
    _s31 = _add(_multiply(vx, _s30, _r19), _add(_s7, _select(_s17, _negative(_s14, _r22), _s14, _r23), _r23), _r23)
    _s32 = _add(8.0, _multiply(8.0, contacts, _r19), _r19)
    _s33 = _absolute(dx, _r22)
    _s34 = _absolute(dy, _r7)
    _s35 = _select(_s33 < _s34, _s34, _s33, _r24)
    _s36 = _absolute(dz, _r25)
    _s37 = _select(_s35 < _s36, _s36, _s35, _r26)
    _s38 = _absolute(dvx, _r27)
    _s39 = _absolute(dvy, _r28)
    _s40 = _select(_s38 < _s39, _s39, _s38, _r29)
    _s41 = _absolute(dvz, _r30)
    _s42 = _multiply(t, _select(_s40 < _s41, _s41, _s40, _r31), _r31)
    _s43 = _select(_s16 < _s21, _s21, _s16, _r30)
    _s44 = _select(_s14 < _s20, _s20, _s14, _r29)
    _s45 = _add(_add(_s42, _select(_s44 < _s25, _s25, _s44, _r28), _r28), _s37, _r28)
    _s46 = _add(_multiply(_divide(_s4, _absolute(_s29, _r21), _r21), _add(_multiply(_s37, _s6, _r26), _add(_s42, _select(_s43 < _s26, _s26, _s43, _r25), _r25), _r25), _r25), _s45, _r25)
    _s47 = _divide(_s46, _s32, _r21)
    _s48 = _negative(_s47, _r26)
    _s49 = _s6 < 0.25
    _s50 = _add(_multiply(vy, _s30, _r6), _add(_s18, _select(_s22, _negative(_s20, _r5), _s20, _r30), _r30), _r30)
    _s51 = _add(_multiply(vz, _s30, _r6), _add(_s23, _select(_s27, _negative(_s25, _r5), _s25, _r9), _r9), _r9)
    _s52 = _absolute(_s30, _r6)
    _s53 = _multiply(0.0625, late, _r5)
    return _result(_s49, _s31, _select(_absolute(_s31, _r10) < _s47, _select(_s31 < 0.0, _s48, _s47, _r10), _s31, _r18), _r0), _result(_s49, _s50, _select(_absolute(_s50, _r18) < _s47, _select(_s50 < 0.0, _s48, _s47, _r18), _s50, _r10), _r0), _result(_s49, _s51, _select(_absolute(_s51, _r10) < _s47, _select(_s51 < 0.0, _s48, _s47, _r10), _s51, _r18), _r0), _result(_s49, 8.0, _s32, _r0), dvx, dvy, dvz - _multiply(p_gravity, _s30, _r20), _multiply(4.440892098500626e-16, _add(clock, t, _r20), _r20) + _select(_s52 < _s53, _s53, _s52, _r19), _result(_s49, _s45, _s46, _r0)


def carry_time(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, clock: Any, clock_error: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Errors of a state at the time limit, from those at the start of the flight.

    derivative of Eq. 3, with roundings. 62 operations: 17 additions, 18 multiplications, 1 negation, 14 absolute values, 6 comparisons, 6 selections.
    Returns dx, dy, dz, dvx, dvy, dvz, clock_error.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16 = _room[:17]
    _s0 = _absolute(vx, _r0)
    _s1 = _add(clock_error, _multiply(4.440892098500626e-16, _add(clock, t, _r1), _r1), _r1)
    _s2 = _absolute(dvx, _r2)
    _s3 = _absolute(dvy, _r3)
    _s4 = _select(_s2 < _s3, _s3, _s2, _r4)
    _s5 = _absolute(dvz, _r5)
    _s6 = _multiply(2.0, t, _r6)
    _s7 = _multiply(1.1102230246251565e-16, _add(_multiply(_s6, _s0, _r7), _absolute(x, _r8), _r8), _r8)
    _s8 = _absolute(vy, _r7)
    _s9 = _multiply(1.1102230246251565e-16, _add(_multiply(_s6, _s8, _r9), _absolute(y, _r10), _r10), _r10)
    _s10 = _select(_s7 < _s9, _s9, _s7, _r9)
    _s11 = _absolute(vz, _r11)
    _s12 = _multiply(1.1102230246251565e-16, _add(_add(_multiply(p_gravity, _multiply(t, t, _r12), _r12), _multiply(_s6, _s11, _r6), _r6), _absolute(z, _r12), _r12), _r12)
    _s13 = _absolute(dx, _r6)
    _s14 = _absolute(dy, _r13)
    _s15 = _select(_s13 < _s14, _s14, _s13, _r14)
    _s16 = _absolute(dz, _r15)
    _s17 = _add(_add(_multiply(t, _select(_s4 < _s5, _s5, _s4, _r16), _r16), _select(_s10 < _s12, _s12, _s10, _r4), _r4), _select(_s15 < _s16, _s16, _s15, _r12), _r12)
    _s18 = _absolute(0.0)
    return _multiply(_s0, _s1, _r15) + _s17, _multiply(_s8, _s1, _r15) + _s17, _multiply(_s11, _s1, _r15) + _s17, _add(_s18, _s2, _r2) + _multiply(2.220446049250313e-16, _s0, _r0), _add(_s18, _s3, _r3) + _multiply(2.220446049250313e-16, _s8, _r7), _add(_s5, _multiply(2.220446049250313e-16, _s11, _r11), _r11) + _absolute(_negative(_multiply(p_gravity, _s1, _r1), _r1), _r1), 0.0


def error_bounds(clock_error: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Bounds on the errors of a state and its time that decisions allow for.

    the carried errors times a guard. 25 operations: 4 multiplications, 9 absolute values, 6 comparisons, 6 selections.
    Returns position_error, velocity_error, spin_error, time_error.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12 = _room[:13]
    _s0 = _absolute(dx, _r0)
    _s1 = _absolute(dy, _r1)
    _s2 = _select(_s0 < _s1, _s1, _s0, _r2)
    _s3 = _absolute(dz, _r3)
    _s4 = _absolute(dvx, _r4)
    _s5 = _absolute(dvy, _r5)
    _s6 = _select(_s4 < _s5, _s5, _s4, _r6)
    _s7 = _absolute(dvz, _r7)
    _s8 = _absolute(dwx, _r8)
    _s9 = _absolute(dwy, _r9)
    _s10 = _select(_s8 < _s9, _s9, _s8, _r10)
    _s11 = _absolute(dwz, _r11)
    return 16.0 * _select(_s2 < _s3, _s3, _s2, _r12), 16.0 * _select(_s6 < _s7, _s7, _s6, _r12), 16.0 * _select(_s10 < _s11, _s11, _s10, _r12), 16.0 * clock_error


def claimed_errors(clock_error: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Bounds on the errors of a state and its time that a shot claims.

    the carried errors times a larger guard. 25 operations: 4 multiplications, 9 absolute values, 6 comparisons, 6 selections.
    Returns position_error, velocity_error, spin_error, time_error.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12 = _room[:13]
    _s0 = _absolute(dx, _r0)
    _s1 = _absolute(dy, _r1)
    _s2 = _select(_s0 < _s1, _s1, _s0, _r2)
    _s3 = _absolute(dz, _r3)
    _s4 = _absolute(dvx, _r4)
    _s5 = _absolute(dvy, _r5)
    _s6 = _select(_s4 < _s5, _s5, _s4, _r6)
    _s7 = _absolute(dvz, _r7)
    _s8 = _absolute(dwx, _r8)
    _s9 = _absolute(dwy, _r9)
    _s10 = _select(_s8 < _s9, _s9, _s8, _r10)
    _s11 = _absolute(dwz, _r11)
    return 64.0 * _select(_s2 < _s3, _s3, _s2, _r12), 64.0 * _select(_s6 < _s7, _s7, _s6, _r12), 64.0 * _select(_s10 < _s11, _s11, _s10, _r12), 64.0 * clock_error


def allowed(p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_gravity: Any, p_end_depth: Any, p_ring_restitution: Any, p_backboard_restitution: Any, p_bridge_restitution: Any, p_ring_friction: Any, p_backboard_friction: Any, p_bridge_friction: Any, p_tangential_restitution: Any, p_restitution_speed: Any) -> tuple[Any, ...]:
    """1 where finite parameters are allowed.

    the scene's requirements. 58 operations: 6 subtractions, 26 comparisons, 26 selections.
    Returns allowed.
    """
    _s0 = _where((0.0 < (p_board_top - p_board_bottom)), _where((0.0 < ((p_board_distance - p_ring_radius) - p_wire_radius)), _where((0.0 < ((p_ring_radius - p_ball_radius) - p_wire_radius)), 1.0, 0.0), 0.0), 0.0)
    _s1 = _where((0.0 < p_wire_radius), _where((0.0 < p_ring_radius), _where((0.0 < p_ball_radius), _where((0.0 < (p_board_half_width - p_bridge_half_width)), _s0, 0.0), 0.0), 0.0), 0.0)
    _s2 = _where((0.0 < p_bridge_depth), _where((0.0 < p_bridge_half_width), _where((0.0 < p_board_thickness), _where((0.0 < p_board_half_width), _where((0.0 < p_board_distance), _s1, 0.0), 0.0), 0.0), 0.0), 0.0)
    _s3 = _where((0.0 <= p_backboard_restitution), _where((p_ring_restitution <= 1.0), _where((0.0 <= p_ring_restitution), _where((0.0 < p_end_depth), _where((0.0 < p_gravity), _s2, 0.0), 0.0), 0.0), 0.0), 0.0)
    _s4 = _where((0.0 <= p_backboard_friction), _where((0.0 <= p_ring_friction), _where((p_bridge_restitution <= 1.0), _where((0.0 <= p_bridge_restitution), _where((p_backboard_restitution <= 1.0), _s3, 0.0), 0.0), 0.0), 0.0), 0.0)
    return _where((0.0 < p_restitution_speed), _where((p_tangential_restitution <= 1.0), _where((-1.0 <= p_tangential_restitution), _where((0.0 <= p_bridge_friction), _s4, 0.0), 0.0), 0.0), 0.0),


def finite_parameters(p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_gravity: Any, p_end_depth: Any, p_ring_restitution: Any, p_backboard_restitution: Any, p_bridge_restitution: Any, p_ring_friction: Any, p_backboard_friction: Any, p_bridge_friction: Any, p_tangential_restitution: Any, p_restitution_speed: Any, allowed: Any) -> tuple[Any, ...]:
    """Where the parameters are finite and allowed.

    IEEE 754. 61 operations: 20 absolute values, 21 comparisons, 20 conjunctions.
    Returns permitted.
    """
    _s0 = _logical_and(_logical_and(_logical_and(_logical_and((0.0 < allowed), (_absolute(p_ball_radius) < _inf)), (_absolute(p_ring_radius) < _inf)), (_absolute(p_wire_radius) < _inf)), (_absolute(p_board_distance) < _inf))
    _s1 = _logical_and(_logical_and(_logical_and(_logical_and(_s0, (_absolute(p_board_half_width) < _inf)), (_absolute(p_board_bottom) < _inf)), (_absolute(p_board_top) < _inf)), (_absolute(p_board_thickness) < _inf))
    _s2 = _logical_and(_logical_and(_logical_and(_logical_and(_s1, (_absolute(p_bridge_half_width) < _inf)), (_absolute(p_bridge_depth) < _inf)), (_absolute(p_gravity) < _inf)), (_absolute(p_end_depth) < _inf))
    _s3 = _logical_and(_logical_and(_logical_and(_logical_and(_s2, (_absolute(p_ring_restitution) < _inf)), (_absolute(p_backboard_restitution) < _inf)), (_absolute(p_bridge_restitution) < _inf)), (_absolute(p_ring_friction) <= _inf))
    _s4 = _logical_and(_logical_and(_logical_and(_logical_and(_s3, (_absolute(p_backboard_friction) <= _inf)), (_absolute(p_bridge_friction) <= _inf)), (_absolute(p_tangential_restitution) < _inf)), (_absolute(p_restitution_speed) <= _inf))
    return _s4,


def valid(last: Any, x: Any, y: Any, z: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_end_depth: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """1 where no surface is overlapped; 1 where that is in doubt.

    Table 2. 133 operations: 27 additions, 19 subtractions, 15 multiplications, 3 square roots, 4 negations, 20 absolute values, 21 comparisons, 24 selections.
    Returns valid, doubt.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11 = _room[:12]
    _s0 = _subtract(_sqrt(_add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1), _r1), p_ring_radius, _r1)
    _s1 = p_ball_radius + p_wire_radius
    _s2 = _subtract(_add(_multiply(z, z, _r0), _multiply(_s0, _s0, _r1), _r1), _s1 * _s1, _r1)
    _s3 = _absolute(last, _r0) < 0.5
    _s4 = _select(_s3, 1.0, _select(0.0 <= _s2, 1.0, 0.0, _r0), _r2)
    _s5 = _subtract(z, p_board_top, _r3)
    _s6 = _subtract(p_board_bottom, z, _r4)
    _s7 = _subtract(_select(_s5 < 0.0, 0.0, _s5, _r5), _select(_s6 < 0.0, 0.0, _s6, _r6), _r6)
    _s8 = _add(p_board_distance, x, _r4)
    _s9 = _negative(_add(p_board_distance + p_board_thickness, x, _r5), _r5)
    _s10 = _subtract(_select(_s8 < 0.0, 0.0, _s8, _r3), _select(_s9 < 0.0, 0.0, _s9, _r7), _r7)
    _s11 = _subtract(y, p_board_half_width, _r5)
    _s12 = _negative(_add(p_board_half_width, y, _r3), _r3)
    _s13 = _subtract(_select(_s11 < 0.0, 0.0, _s11, _r8), _select(_s12 < 0.0, 0.0, _s12, _r9), _r9)
    _s14 = _subtract(_sqrt(_add(_add(_multiply(_s7, _s7, _r6), _multiply(_s10, _s10, _r7), _r7), _multiply(_s13, _s13, _r9), _r9), _r9), p_ball_radius, _r9)
    _s15 = _absolute(_subtract(last, 1.0, _r7), _r7) < 0.5
    _s16 = _select(_s15, _s4, _select(0.0 <= _s14, _s4, 0.0, _r7), _r6)
    _s17 = _add(p_ring_radius, x, _r3)
    _s18 = _negative(_s8, _r4)
    _s19 = _subtract(_select(_s17 < 0.0, 0.0, _s17, _r8), _select(_s18 < 0.0, 0.0, _s18, _r5), _r5)
    _s20 = _subtract(y, p_bridge_half_width, _r4)
    _s21 = _negative(_add(p_bridge_half_width, y, _r8), _r8)
    _s22 = _subtract(_select(_s20 < 0.0, 0.0, _s20, _r3), _select(_s21 < 0.0, 0.0, _s21, _r10), _r10)
    _s23 = _subtract(z, p_wire_radius, _r8)
    _s24 = _subtract(p_wire_radius - p_bridge_depth, z, _r3)
    _s25 = _subtract(_select(_s23 < 0.0, 0.0, _s23, _r4), _select(_s24 < 0.0, 0.0, _s24, _r11), _r11)
    _s26 = _subtract(_sqrt(_add(_add(_multiply(_s19, _s19, _r5), _multiply(_s22, _s22, _r10), _r10), _multiply(_s25, _s25, _r11), _r11), _r11), p_ball_radius, _r11)
    _s27 = _absolute(_subtract(last, 2.0, _r10), _r10) < 0.5
    _s28 = ((((_absolute(p_ball_radius) + _absolute(p_board_bottom)) + _absolute(p_board_distance)) + _absolute(p_board_half_width)) + _absolute(p_board_thickness)) + _absolute(p_board_top)
    _s29 = ((((_s28 + _absolute(p_bridge_depth)) + _absolute(p_bridge_half_width)) + _absolute(p_end_depth)) + _absolute(p_ring_radius)) + _absolute(p_wire_radius)
    _s30 = _multiply(1.7763568394002505e-15, _add(_add(_add(_s29, _absolute(x, _r10), _r10), _absolute(y, _r5), _r5), _absolute(z, _r10), _r10), _r10)
    _s31 = _select(_s3, 0.0, _select(_absolute(_s2, _r1) <= _multiply((4.0 * p_ball_radius) + (4.0 * p_wire_radius), _s30, _r5), 1.0, 0.0, _r5), _r1)
    _s32 = _select(_s15, _s31, _select(_absolute(_s14, _r9) <= _s30, 1.0, _s31, _r9), _r3)
    return _result(_s27, _s16, _select(0.0 <= _s26, _s16, 0.0, _r4), _r0), _result(_s27, _s32, _select(_absolute(_s26, _r11) <= _s30, 1.0, _s32, _r11), _r0)


def passing_start(last: Any, outcome: Any, uncertain: Any, x: Any, y: Any, z: Any, p_ring_radius: Any, p_end_depth: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Whether a ball starts as one that has fallen through the ring.

    Table 2, success. 22 operations: 2 additions, 1 subtraction, 4 multiplications, 1 negation, 1 absolute value, 6 comparisons, 5 conjunctions, 2 selections.
    Returns through, uncertain.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = _logical_and(_logical_and((0.0 <= last), (z < 0.0)), ((-p_end_depth) <= z))
    _s1 = _add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1)
    _s2 = p_ring_radius * p_ring_radius
    _s3 = _result(_logical_and(_logical_and(_s0, (_absolute(_subtract(_s1, _s2, _r0), _r0) <= _multiply(8.881784197001252e-16, _add(_s2, _s1, _r2), _r2))), (outcome < 0.0)), 1.0, uncertain, _r0)
    return _result(_logical_and(_s0, (_s1 < _s2)), 1.0, 0.0, _r0), _s3


def passing(through: Any, t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ring_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """1 for a ball that is down through the ring's disc, -1 for one that came up, else 0.

    Eq. 3, its roots in the ring's plane. 66 operations: 9 additions, 2 subtractions, 18 multiplications, 1 division, 1 square root, 16 comparisons, 9 conjunctions, 2 disjunctions, 8 selections.
    Returns through.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6 = _room[:7]
    _s0 = z < 0.0
    _s1 = _add(z, _multiply(t, _subtract(vz, _multiply(0.5 * p_gravity, t, _r0), _r0), _r0), _r0)
    _s2 = _s1 < 0.0
    _s3 = _add(_multiply(vz, vz, _r1), _multiply(2.0 * p_gravity, z, _r2), _r2)
    _s4 = _logical_and(_logical_and(_logical_and(_logical_and(_s0, _s2), (0.0 < vz)), (0.0 < _s3)), (vz < _multiply(p_gravity, t, _r1)))
    _s5 = _sqrt(_select(_s3 < 0.0, 0.0, _s3, _r1), _r1)
    _s6 = 1.0 / p_gravity
    _s7 = _multiply(_add(vz, _s5, _r2), _s6, _r2)
    _s8 = _select(0.0 < _s7, _s7, 0.0, _r3)
    _s9 = _select(_s8 < t, _s8, t, _r4)
    _s10 = _add(x, _multiply(vx, _s9, _r5), _r5)
    _s11 = _add(y, _multiply(vy, _s9, _r4), _r4)
    _s12 = p_ring_radius * p_ring_radius
    _s13 = _multiply(_subtract(vz, _s5, _r1), _s6, _r1)
    _s14 = _select(0.0 < _s13, _s13, 0.0, _r3)
    _s15 = _select(_s14 < t, _s14, t, _r2)
    _s16 = _add(x, _multiply(vx, _s15, _r6), _r6)
    _s17 = _add(y, _multiply(vy, _s15, _r2), _r2)
    _s18 = _select(_logical_and(_logical_or(_s4, _logical_and(_s0, (0.0 <= _s1))), (_add(_multiply(_s16, _s16, _r6), _multiply(_s17, _s17, _r2), _r2) < _s12)), _select(through == 1.0, 0.0, -1.0, _r2), through, _r6)
    _s19 = _result(_logical_and(_logical_and(_logical_or(_s4, _logical_and(_s2, (0.0 <= z))), (_add(_multiply(_s10, _s10, _r5), _multiply(_s11, _s11, _r4), _r4) < _s12)), (_s18 == 0.0)), 1.0, _s18, _r0)
    return _s19,


def passing_doubt(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ring_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Where that lies within its error.

    running error analysis. 107 operations: 18 additions, 4 subtractions, 31 multiplications, 1 division, 4 square roots, 6 absolute values, 20 comparisons, 11 conjunctions, 6 disjunctions, 6 selections.
    Returns unsure.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10 = _room[:11]
    _s0 = _add(z, _multiply(t, _subtract(vz, _multiply(0.5 * p_gravity, t, _r0), _r0), _r0), _r0)
    _s1 = _multiply(vz, vz, _r1)
    _s2 = 1.0 / p_gravity
    _s3 = _multiply(p_gravity, t, _r2)
    _s4 = _add(speed, _s3, _r3)
    _s5 = _multiply(1.0009765625, _add(_add(position_error, _multiply(t, velocity_error, _r4), _r4), _multiply(4.440892098500626e-16, _add(extent, _multiply(t, _s4, _r5), _r5), _r5), _r5), _r5)
    _s6 = _add(_multiply(8.881784197001252e-16, _multiply(_s1, _s2, _r4), _r4), _s5, _r4)
    _s7 = z < 0.0
    _s8 = _s0 < 0.0
    _s9 = _logical_and(_logical_and(_s7, _s8), (0.0 < vz))
    _s10 = _add(_s1, _multiply(2.0 * p_gravity, z, _r6), _r6)
    _s11 = _sqrt(_select(_s10 < 0.0, 0.0, _s10, _r1), _r1)
    _s12 = _multiply(_add(vz, _s11, _r7), _s2, _r7)
    _s13 = _select(0.0 < _s12, _s12, 0.0, _r8)
    _s14 = _select(_s13 < t, _s13, t, _r9)
    _s15 = _add(x, _multiply(vx, _s14, _r10), _r10)
    _s16 = _add(y, _multiply(vy, _s14, _r9), _r9)
    _s17 = _sqrt(_add(_multiply(_s15, _s15, _r10), _multiply(_s16, _s16, _r9), _r9), _r9)
    _s18 = _multiply(_subtract(vz, _s11, _r1), _s2, _r1)
    _s19 = _select(0.0 < _s18, _s18, 0.0, _r10)
    _s20 = _select(_s19 < t, _s19, t, _r8)
    _s21 = _add(x, _multiply(vx, _s20, _r7), _r7)
    _s22 = _add(y, _multiply(vy, _s20, _r8), _r8)
    _s23 = _sqrt(_add(_multiply(_s21, _s21, _r7), _multiply(_s22, _s22, _r8), _r8), _r8)
    _s24 = _multiply(_multiply(1.0009765625, _s4, _r3), _add(_sqrt(_multiply(8.0 * _s2, _s6, _r7), _r7), _multiply(8.881784197001252e-16, _add(t, _multiply(_absolute(vz, _r10), _s2, _r10), _r10), _r10), _r10), _r3)
    _s25 = _add(_s24, _s5, _r3)
    _s26 = _logical_and(_logical_or(_logical_or(_logical_and((0.0 < position_error), (_absolute(z, _r5) <= position_error)), (_absolute(_s0, _r5) <= _s6)), _logical_and(_s9, (_absolute(_s10, _r5) <= _multiply(4.0 * p_gravity, _s6, _r4)))), (_select(_s17 < _s23, _s17, _s23, _r4) <= _add(p_ring_radius, _s25, _r5)))
    _s27 = _logical_and(_logical_and(_s9, (0.0 < _s10)), (vz < _s3))
    _s28 = _logical_or(_s26, _logical_or(_logical_and(_logical_or(_s27, _logical_and(_s7, (0.0 <= _s0))), (_absolute(_subtract(_s23, p_ring_radius, _r8), _r8) <= _s25)), _logical_and(_logical_or(_s27, _logical_and(_s8, (0.0 <= z))), (_absolute(_subtract(_s17, p_ring_radius, _r9), _r9) <= _s25))))
    return _s28,


def passing_from(z: Any) -> tuple[Any, ...]:
    """Whether a ball in contact is over the ring's disc, or beside it.

    Table 1. 1 operation: 1 comparison.
    Returns over.
    """
    return 0.0 <= z,


def passing_in_contact(over: Any, p_ring_radius: Any, through: Any, x: Any, y: Any, z: Any) -> tuple[Any, ...]:
    """The same for a ball in contact, after a step.

    Table 1. 18 operations: 1 addition, 3 multiplications, 5 comparisons, 5 conjunctions, 1 complement, 3 selections.
    Returns through.
    """
    _s0 = ((x * x) + (y * y)) < (p_ring_radius * p_ring_radius)
    _s1 = _where(_logical_and(_logical_and(_logical_not(over), (0.0 <= z)), _s0), _where((through == 1.0), 0.0, -1.0), through)
    return _where(_logical_and(_logical_and(_logical_and(over, (z < 0.0)), _s0), (_s1 == 0.0)), 1.0, _s1),


def halved(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, late: Any, pad: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The same of its first and its second half.

    Eq. 3, the chords of both and what it is off them. 62 operations: 21 additions, 5 subtractions, 27 multiplications, 1 negation, 6 absolute values, 1 comparison, 1 selection.
    Returns middle_x, reach_x, later_middle_x, later_reach_x, middle_y, reach_y, later_middle_y, later_reach_y, middle_z, reach_z, later_middle_z, later_reach_z.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11 = _room[:12]
    _s0 = _multiply(0.5, horizon, _r0)
    _s1 = _multiply(vx, _s0, _r1)
    _s2 = _multiply(0.5, _s1, _r2)
    _s3 = _absolute(0.0)
    _s4 = _add(_add(position_error, _multiply(horizon, velocity_error, _r3), _r3), _multiply(9.313225746154785e-10, _add(extent, _multiply(horizon, _add(speed, _multiply(p_gravity, horizon, _r4), _r4), _r4), _r4), _r4), _r4)
    _s5 = _select(pad < late, _inf, _s4, _r3)
    _s6 = 1.0000000009313226 * _add(_add(_s3, _multiply(0.5, _absolute(_s1, _r5), _r5), _r5), _s5, _r5)
    _s7 = _multiply(vy, _s0, _r5)
    _s8 = _multiply(0.5, _s7, _r6)
    _s9 = 1.0000000009313226 * _add(_add(_s3, _multiply(0.5, _absolute(_s7, _r7), _r7), _r7), _s5, _r7)
    _s10 = _multiply(0.5 * p_gravity, _s0, _r7)
    _s11 = _multiply(_s0, _subtract(vz, _s10, _r8), _r8)
    _s12 = _negative(_multiply(0.0625 * p_gravity, _multiply(_s0, _s0, _r9), _r9), _r9)
    _s13 = _absolute(_s12, _r10)
    _s14 = _multiply(_s0, _subtract(_subtract(vz, _multiply(p_gravity, _s0, _r11), _r11), _s10, _r11), _r11)
    return x + _s2, _s6, _s2 + _add(x, _s1, _r1), _s6, y + _s8, _s9, _s8 + _add(y, _s7, _r5), _s9, _add(z, _multiply(0.5, _s11, _r5), _r5) - _s12, 1.0000000009313226 * _add(_add(_s13, _multiply(0.5, _absolute(_s11, _r5), _r5), _r5), _s5, _r5), _add(_multiply(0.5, _s14, _r5), _add(z, _s11, _r8), _r8) - _s12, 1.0000000009313226 * _add(_add(_s13, _multiply(0.5, _absolute(_s14, _r11), _r11), _r11), _s5, _r11)


def untaken() -> tuple[Any, ...]:
    """An event that is on no surface of a kind yet.

    Table 1. No operations.
    Returns mine.
    """
    return False,


def left(index: Any, last: Any) -> tuple[Any, ...]:
    """1 where the ball leaves a surface.

    Table 1. 2 operations: 1 comparison, 1 selection.
    Returns leaving.
    """
    return _where((last == index), 1.0, 0.0),


def meeting_plane(bend: Any, rate: Any, time: Any) -> tuple[Any, ...]:
    """Whether a plane's only arrival is one, and the size of the bend there.

    Table 1. 12 operations: 1 absolute value, 6 comparisons, 4 conjunctions, 1 disjunction.
    Returns arrives, ceiling.
    """
    _s0 = _logical_and(_logical_and(_logical_or((rate < 0.0), _logical_and(_logical_and((rate <= 0.0), (bend < 0.0)), (time == 0.0))), (0.0 <= time)), (time < _inf))
    return _s0, _absolute(bend)


def timely(arrives: Any, delay: Any, late: Any, time: Any, when: Any) -> tuple[Any, ...]:
    """Whether an arrival may be the earliest, as far as their delays are bounded.

    Table 1. 5 operations: 1 addition, 1 subtraction, 1 comparison, 1 conjunction, 1 complement.
    Returns possible.
    """
    return _logical_and(arrives, _logical_not(((delay + late) < (time - when)))),


def grazed(apex: Any, doubt: Any, height: Any, margin: Any) -> tuple[Any, ...]:
    """A doubt where the gap's apex is zero within its error.

    Table 1. 7 operations: 1 absolute value, 3 comparisons, 2 conjunctions, 1 selection.
    Returns doubt.
    """
    return _where(_logical_and(_logical_and((0.0 <= apex), (_absolute(height) <= margin)), (apex < doubt)), apex, doubt),


def questioned(doubt: Any, time: Any, unsure: Any) -> tuple[Any, ...]:
    """A doubt about a decision at a time.

    Table 1. 3 operations: 1 comparison, 1 conjunction, 1 selection.
    Returns doubt.
    """
    return _where(_logical_and(unsure, (time < doubt)), time, doubt),


def crossed(arrives: Any, clearance: Any, doubt: Any, time: Any) -> tuple[Any, ...]:
    """A doubt about an arrival whose crossing is not certain.

    Table 1. 6 operations: 2 comparisons, 2 conjunctions, 1 complement, 1 selection.
    Returns doubt.
    """
    return _where(_logical_and(_logical_and(arrives, _logical_not((0.0 < clearance))), (time < doubt)), time, doubt),


def tied(arrives: Any, delay: Any, doubt: Any, late: Any, time: Any, when: Any) -> tuple[Any, ...]:
    """A doubt about two arrivals within their delays; the delay of the earlier one.

    Table 1. 12 operations: 1 addition, 1 subtraction, 1 absolute value, 3 comparisons, 3 conjunctions, 3 selections.
    Returns doubt, late.
    """
    _s0 = time < when
    _s1 = _where(_s0, time, when)
    _s2 = _where(_logical_and(_logical_and(arrives, (_absolute((time - when)) <= (delay + late))), (_s1 < doubt)), _s1, doubt)
    return _s2, _where(_logical_and(arrives, _s0), delay, late)


def sooner(arrives: Any, index: Any, time: Any, when: Any, which: Any) -> tuple[Any, ...]:
    """The earlier of the earliest arrival so far and this one.

    Table 1. 4 operations: 1 comparison, 1 conjunction, 2 selections.
    Returns when, which.
    """
    _s0 = _logical_and(arrives, (time < when))
    return _where(_s0, time, when), _where(_s0, index, which)


def beginning() -> tuple[Any, ...]:
    """How a search begins: with the errors that it allows for, and nothing found.

    Table 1. No operations.
    Returns share, arrival, certain.
    """
    return 2.9802322387695312e-08, _inf, False


def beyond(doubt: Any, excess: Any, late: Any, lost: Any, pad: Any) -> tuple[Any, ...]:
    """Nothing is certain where the errors exceed what the search allows for.

    Table 1. 6 operations: 3 comparisons, 2 disjunctions, 1 selection.
    Returns doubt.
    """
    return _where(_logical_or(_logical_or((0.0 < excess), (0.0 < lost)), (pad < late)), 0.0, doubt),


def beyond_windows(doubt: Any, excess: Any, late: Any, lost: Any, pad: Any, searching: Any) -> tuple[Any, ...]:
    """The same where a search has windows: with none its errors do not matter.

    Table 1. 7 operations: 3 comparisons, 1 conjunction, 2 disjunctions, 1 selection.
    Returns doubt.
    """
    return _where(_logical_or(_logical_and(searching, _logical_or((0.0 < excess), (pad < late))), (0.0 < lost)), 0.0, doubt),


def nearby(flat: Any, index: Any, last: Any, t: Any, tilt: Any) -> tuple[Any, ...]:
    """1 near the surface that the ball left, where F/t is known better than F; the margin.

    Table 1. 6 operations: 1 multiplication, 2 comparisons, 1 conjunction, 2 selections.
    Returns leaving, margin.
    """
    _s0 = t * tilt
    _s1 = _logical_and((last == index), (_s0 < flat))
    return _where(_s1, 1.0, 0.0), _where(_s1, _s0, flat)


def opened(horizon: Any, time: Any) -> tuple[Any, ...]:
    """When the first window opens, in single precision, and when the last one ends.

    Table 1. No operations.
    Returns time, latest.
    """
    return time, horizon


def coarse(ceiling: Any, fits: Any, flat: Any, rate_margin: Any, searching: Any, share: Any, sound: Any) -> tuple[Any, ...]:
    """Whether a search begins in single precision, and what it is known by.

    Table 1. 6 operations: 3 conjunctions, 1 disjunction, 1 complement, 1 selection.
    Returns leaping, searching, served, ceiling, flat, tilt, allowing.
    """
    _s0 = _logical_and(_logical_and(searching, sound), fits)
    return _s0, _logical_or(searching, _logical_not(sound)), _s0, ceiling, flat, rate_margin, _where(_logical_and(sound, fits), share, 2.9802322387695312e-08)


def leapt(arrival: Any, certain: Any, lasting: Any, searching: Any, served: Any, since: Any) -> tuple[Any, ...]:
    """What a search in single precision found, and whether it goes on, and from when.

    Table 1. 7 operations: 1 addition, 1 comparison, 2 conjunctions, 1 complement, 2 selections.
    Returns arrival, t, searching.
    """
    _s0 = lasting + since
    return _where(certain, _s0, arrival), _where(served, _s0, 0.0), _logical_and(_logical_and(searching, _logical_not(certain)), (lasting < _inf))


def struck(bend: Any, clearance: Any, gap: Any, margin: Any, rate: Any, rate_margin: Any, share: Any) -> tuple[Any, ...]:
    """Whether the gap closes, surely, or is to be looked at with smaller errors allowed.

    Table 1. 17 operations: 1 subtraction, 6 comparisons, 6 conjunctions, 2 disjunctions, 2 complements.
    Returns hit, sure, vague.
    """
    _s0 = _logical_or((rate < 0.0), _logical_and((rate <= rate_margin), (bend < 0.0)))
    _s1 = 0.0 < clearance
    _s2 = _logical_and(_s0, _logical_or(((gap - margin) <= margin), _s1))
    _s3 = _logical_and(_s0, _s1)
    _s4 = _logical_and(_logical_and(_s2, _logical_not(_s3)), (0.0 < share))
    return _logical_and(_s2, _logical_not(_s4)), _s3, _s4


def struck_or_still(bend: Any, clearance: Any, end: Any, gap: Any, margin: Any, next: Any, rate: Any, rate_margin: Any, share: Any, t: Any) -> tuple[Any, ...]:
    """The same; or that it is, as no step is possible with errors as large as these.

    Table 1. 25 operations: 1 subtraction, 8 comparisons, 9 conjunctions, 3 disjunctions, 4 complements.
    Returns hit, sure, vague.
    """
    _s0 = _logical_or((rate < 0.0), _logical_and((rate <= rate_margin), (bend < 0.0)))
    _s1 = 0.0 < clearance
    _s2 = _logical_and(_s0, _logical_or(((gap - margin) <= margin), _s1))
    _s3 = _logical_and(_s0, _s1)
    _s4 = 0.0 < share
    _s5 = _logical_and(_logical_and(_s2, _logical_not(_s3)), _s4)
    _s6 = _logical_or(_s5, _logical_and(_logical_and(_logical_not(_s2), _logical_and((t < end), _logical_not((t < next)))), _s4))
    return _logical_and(_s2, _logical_not(_s5)), _s3, _s6


def finer(share: Any) -> tuple[Any, ...]:
    """The next smaller errors that a search allows for.

    Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection.
    Returns share.
    """
    return _where((2.842170943040401e-14 < share), (0.03125 * share), 0.0),


def exceeded(doubt: Any, excess: Any, t: Any) -> tuple[Any, ...]:
    """A doubt where the errors exceed what is allowed for.

    Table 1. 4 operations: 2 comparisons, 1 conjunction, 1 selection.
    Returns doubt.
    """
    return _where(_logical_and((0.0 < excess), (t < doubt)), t, doubt),


def advanced(arrival: Any, certain: Any, end: Any, hit: Any, next: Any, step: Any, sure: Any, t: Any, vague: Any) -> tuple[Any, ...]:
    """The search after a step: what it found, whether its window is exhausted, where it is.

    Table 1. 14 operations: 1 subtraction, 1 comparison, 4 conjunctions, 2 disjunctions, 3 complements, 3 selections.
    Returns arrival, certain, exhausted, searching, t.
    """
    _s0 = _logical_not(hit)
    _s1 = _logical_and(_logical_and(_s0, _logical_not(vague)), ((end - t) <= step))
    return _where(hit, _where(sure, next, t), arrival), _logical_or(certain, _logical_and(hit, sure)), _s1, _logical_and(_s0, _logical_not(_s1)), _where(_logical_or(hit, vague), t, next)


def found(arrival: Any) -> tuple[Any, ...]:
    """Whether a search found an arrival.

    Table 1. 1 operation: 1 comparison.
    Returns arrives, refining, rate.
    """
    _s0 = arrival < _inf
    return _s0, _s0, 0.0


def polished(arrival: Any, ceiling: Any, certain: Any, gap: Any, rate: Any, refined: Any) -> tuple[Any, ...]:
    """A root that is certain, refined, and whether h is above 2^-24: then it is again.

    Table 1. 7 operations: 3 multiplications, 1 absolute value, 1 comparison, 1 conjunction, 1 selection.
    Returns arrival, refining.
    """
    return _where(certain, refined, arrival), _logical_and(certain, ((5.960464477539063e-08 * (rate * rate)) < (ceiling * _absolute(gap))))


def own_margin(arrival: Any, flat: Any, leaving: Any, tilt: Any) -> tuple[Any, ...]:
    """The margin of the form that an arrival was found with.

    Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection.
    Returns margin.
    """
    return _where((0.0 < leaving), (arrival * tilt), flat),


def landed(arrival: Any) -> tuple[Any, ...]:
    """The time of an arrival, not before the flight.

    Table 1. 2 operations: 1 comparison, 1 selection.
    Returns time.
    """
    return _where((arrival < 0.0), 0.0, arrival),


def landed_surely(arrives: Any, certain: Any, clearance: Any, delay: Any, doubt: Any, time: Any) -> tuple[Any, ...]:
    """The delay of an arrival that is certain, a doubt about another one.

    Table 1. 8 operations: 2 comparisons, 3 conjunctions, 1 complement, 2 selections.
    Returns delay, doubt.
    """
    _s0 = _logical_and(certain, (0.0 < clearance))
    return _where(_s0, delay, 0.0), _where(_logical_and(_logical_and(arrives, _logical_not(_s0)), (time < doubt)), time, doubt)


def outside() -> tuple[Any, ...]:
    """A search that begins outside the surface.

    Table 1. No operations.
    Returns side.
    """
    return 1.0,


def finite_state(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Where every number of a state is finite.

    Table 1. 26 operations: 9 absolute values, 9 comparisons, 8 conjunctions.
    Returns finite.
    """
    _r0, = _room[:1]
    _s0 = _logical_and(_logical_and(_logical_and(_logical_and((_absolute(x, _r0) < _inf), (_absolute(y, _r0) < _inf)), (_absolute(z, _r0) < _inf)), (_absolute(vx, _r0) < _inf)), (_absolute(vy, _r0) < _inf))
    _s1 = _logical_and(_logical_and(_logical_and(_logical_and(_s0, (_absolute(vz, _r0) < _inf)), (_absolute(wx, _r0) < _inf)), (_absolute(wy, _r0) < _inf)), (_absolute(wz, _r0) < _inf))
    return _s1,


def opening(excess: Any, position_error: Any, velocity_error: Any) -> tuple[Any, ...]:
    """No arrival yet; nothing is certain where the errors are not bounded.

    Table 1. 6 operations: 3 comparisons, 2 conjunctions, 1 selection.
    Returns when, which, late, doubt.
    """
    return _inf, -1.0, 0.0, _where(_logical_and(_logical_and((position_error < _inf), (velocity_error < _inf)), (excess <= 0.0)), _inf, 0.0)


def limited(time_limit: Any) -> tuple[Any, ...]:
    """Whether there is a time limit.

    Table 1. 1 operation: 1 comparison.
    Returns limited.
    """
    return time_limit < _inf,


def ticked(clock: Any, when: Any) -> tuple[Any, ...]:
    """The time of the event.

    Table 1. 1 operation: 1 addition.
    Returns clock.
    """
    return clock + when,


def meeting(claims: Any, ends: Any, touches: Any) -> tuple[Any, ...]:
    """Where an event changes the ball, or its errors are asked for.

    Table 1. 3 operations: 1 comparison, 1 conjunction, 1 disjunction.
    Returns meeting.
    """
    return _logical_or(touches, _logical_and(ends, (0.0 < claims))),


def here(index: Any, which: Any) -> tuple[Any, ...]:
    """Whether the event is on a surface.

    Table 1. 1 operation: 1 comparison.
    Returns here.
    """
    return which == index,


def counted(count: Any) -> tuple[Any, ...]:
    """One more contact.

    Table 1. 1 operation: 1 addition.
    Returns count.
    """
    return 1.0 + count,


def elsewhere() -> tuple[Any, ...]:
    """A ball that meets another surface.

    Table 1. No operations.
    Returns curving.
    """
    return _inf,


def again(index: Any, last: Any, which: Any) -> tuple[Any, ...]:
    """Whether the ball meets the surface that it touched last.

    Table 1. 3 operations: 2 comparisons, 1 conjunction.
    Returns again.
    """
    return _logical_and((which == index), (last == which)),


def delayed(clock_error: Any, delay: Any) -> tuple[Any, ...]:
    """The error of the event's time.

    Table 1. 1 operation: 1 addition.
    Returns clock_error.
    """
    return clock_error + delay,


def floored(dx: Any, dy: Any, dz: Any, shift: Any) -> tuple[Any, ...]:
    """Errors of the position at the end, not below what one flight can make.

    Table 1. 9 operations: 3 absolute values, 3 comparisons, 3 selections.
    Returns dx, dy, dz.
    """
    return _where((_absolute(dx) < shift), shift, dx), _where((_absolute(dy) < shift), shift, dy), _where((_absolute(dz) < shift), shift, dz)


def unturned() -> tuple[Any, ...]:
    """A normal without error.

    Table 1. No operations.
    Returns dnx, dny, dnz, turn.
    """
    return 0.0, 0.0, 0.0, 0.0


def touched(body: Any, first: Any, which: Any) -> tuple[Any, ...]:
    """The surfaces that were touched first and last.

    Table 1. 2 operations: 1 comparison, 1 selection.
    Returns first, last.
    """
    return _where((first < 0.0), body, first), which


def timed(claims: Any, index: Any, which: Any) -> tuple[Any, ...]:
    """Where a shot has ended at the time limit whose errors are asked for.

    Table 1. 3 operations: 2 comparisons, 1 conjunction.
    Returns timed.
    """
    return _logical_and((which == index), (0.0 < claims)),


def closing(claims: Any, outcome: Any) -> tuple[Any, ...]:
    """Where a shot has ended whose errors are asked for.

    Table 1. 3 operations: 2 comparisons, 1 conjunction.
    Returns closed.
    """
    return _logical_and((0.0 < claims), (0.0 <= outcome)),


def undecided(uncertain: Any, unsure: Any) -> tuple[Any, ...]:
    """1 where a decision within a contact lies within its error.

    Table 1. 1 operation: 1 selection.
    Returns uncertain.
    """
    return _where(unsure, 1.0, uncertain),


def body_of(which: Any) -> tuple[Any, ...]:
    """The body that the event is on.

    Table 1. No operations.
    Returns body.
    """
    return which,


def admitted(doubt: Any, finite: Any, permitted: Any, valid: Any) -> tuple[Any, ...]:
    """Whether a shot can start, and whether that is in doubt.

    Table 1. 7 operations: 2 comparisons, 3 conjunctions, 2 selections.
    Returns outcome, uncertain.
    """
    _s0 = _logical_and(permitted, finite)
    return _where(_logical_and(_s0, (0.0 < valid)), -1.0, 4.0), _where(_logical_and(_s0, (0.0 < doubt)), 1.0, 0.0)


def expiry(clock: Any, doubt: Any, late: Any, time_error: Any, time_limit: Any, when: Any, which: Any) -> tuple[Any, ...]:
    """The time limit, taken for an arrival.

    Table 1. 12 operations: 2 additions, 1 subtraction, 1 multiplication, 4 comparisons, 1 conjunction, 1 complement, 2 selections.
    Returns time, delay, arrives, doubt.
    """
    _s0 = time_limit - clock
    return _where(0.0 < _s0, _s0, 0.0), time_error + (4.440892098500626e-16 * time_limit), 0.0 <= which, _where(_logical_and(_logical_not(((late + when) < doubt)), (doubt < _inf)), 0.0, doubt)


def departed(index: Any, which: Any) -> tuple[Any, ...]:
    """Whether there is no event, an end, or a contact.

    Table 1. 5 operations: 3 comparisons, 1 conjunction, 1 complement.
    Returns stays, moves, ends, touches, reached, edge.
    """
    _s0 = which < 0.0
    _s1 = _logical_not(_s0)
    return _s0, _s1, index <= which, _logical_and(_s1, (which < index)), 3.0, False


def expired(body: Any, clock: Any, ends: Any, index: Any, reached: Any, time_limit: Any, which: Any) -> tuple[Any, ...]:
    """What a shot ends with that the time limit ends.

    Table 1. 6 operations: 1 comparison, 1 conjunction, 1 complement, 3 selections.
    Returns clock, body, reached, ends.
    """
    _s0 = which == index
    return _where(_s0, time_limit, clock), _where(_s0, 3.0, body), _where(_s0, 6.0, reached), _logical_and(ends, _logical_not(_s0))


def accounted(contacts: Any, most_contacts: Any, reached: Any, touches: Any) -> tuple[Any, ...]:
    """How many contacts there were, and whether the shot ends and how.

    Table 1. 5 operations: 1 addition, 1 comparison, 3 selections.
    Returns contacts, outcome.
    """
    _s0 = 1.0 + contacts
    return _where(touches, _s0, contacts), _where(touches, _where((most_contacts <= _s0), 2.0, -1.0), reached)


def circles(held: Any, index: Any, rolling: Any) -> tuple[Any, ...]:
    """Which of the balls in contact are on the ring.

    Table 1. 4 operations: 1 comparison, 2 conjunctions, 1 complement.
    Returns circling, rolling.
    """
    _s0 = held == index
    return _logical_and(rolling, _s0), _logical_and(rolling, _logical_not(_s0))


def leaps(stride: Any) -> tuple[Any, ...]:
    """From where half a step is looked over.

    Table 1. 2 operations: 1 multiplication, 1 negation.
    Returns forth, back.
    """
    _s0 = 0.5 * stride
    return _s0, -_s0


def cleared(berth: Any, gap: Any, leap: Any, nearing: Any) -> tuple[Any, ...]:
    """What is nearest.

    tangents. 6 operations: 1 addition, 1 multiplication, 2 comparisons, 2 selections.
    Returns berth.
    """
    _s0 = leap * nearing
    _s1 = gap + _where(_s0 < 0.0, _s0, 0.0)
    return _where(_s1 < berth, _s1, berth),


def for_ever(endless: Any, which: Any) -> tuple[Any, ...]:
    """That a ball rolls for ever ends its shot.

    Table 1. 1 operation: 1 selection.
    Returns which.
    """
    return _where(endless, 8.0, which),


def rejoined(circling: Any, rolling: Any) -> tuple[Any, ...]:
    """All that go on.

    Table 1. 1 operation: 1 disjunction.
    Returns rolling.
    """
    return _logical_or(rolling, circling),


def roll_0(bent_x: Any, bent_y: Any, bent_z: Any, p_gravity: Any, nx_0: Any, ny_0: Any, nz_0: Any, per_reach: Any, turn_rate_0: Any, vx_0: Any, vy_0: Any, vz_0: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 1 of a ball that rolls, from those before.

    Newton, Euler and rolling without slip. 42 operations: 7 additions, 5 subtractions, 29 multiplications, 1 negation.
    Returns lift_0, tx_0, ty_0, tz_0, vx_1, vy_1, vz_1, nx_1, ny_1, nz_1, turn_rate_1.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = 0.6 * p_gravity
    _s1 = _multiply(bent_x, per_reach, _r0) * vx_0
    _s2 = _multiply(bent_y, per_reach, _r0) * vy_0
    _s3 = _multiply(bent_z, per_reach, _r0) * vz_0
    _s4 = _multiply(_s0, nz_0, _r0) - _add(_add(_multiply(vx_0, _s1, _r1), _multiply(vy_0, _s2, _r2), _r2), _multiply(vz_0, _s3, _r1), _r1)
    _s5 = _multiply(ny_0, _s3, _r1) - _multiply(nz_0, _s2, _r0)
    _s6 = _multiply(nz_0, _s1, _r0) - _multiply(nx_0, _s3, _r1)
    _s7 = _multiply(nx_0, _s2, _r1) - _multiply(ny_0, _s1, _r0)
    return _s4, _s5, _s6, _s7, _multiply(nx_0, _s4, _r0) + _multiply(0.4, _multiply(turn_rate_0, _s5, _r1), _r1), _multiply(ny_0, _s4, _r1) + _multiply(0.4, _multiply(turn_rate_0, _s6, _r0), _r0), _add(_multiply(nz_0, _s4, _r0), _multiply(0.4, _multiply(turn_rate_0, _s7, _r1), _r1), _r1) - _s0, _s1, _s2, _s3, -_add(_add(_multiply(vx_0, _s5, _r1), _multiply(vy_0, _s6, _r0), _r0), _multiply(vz_0, _s7, _r1), _r1)


def roll_1(bent_x: Any, bent_y: Any, bent_z: Any, p_gravity: Any, lift_0: Any, nx_0: Any, nx_1: Any, ny_0: Any, ny_1: Any, nz_0: Any, nz_1: Any, per_reach: Any, turn_rate_0: Any, turn_rate_1: Any, tx_0: Any, ty_0: Any, tz_0: Any, vx_0: Any, vx_1: Any, vy_0: Any, vy_1: Any, vz_0: Any, vz_1: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 2 of a ball that rolls, from those before.

    Newton, Euler and rolling without slip. 81 operations: 25 additions, 4 subtractions, 51 multiplications, 1 negation.
    Returns lift_1, tx_1, ty_1, tz_1, vx_2, vy_2, vz_2, nx_2, ny_2, nz_2, turn_rate_2.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6 = _room[:7]
    _s0 = _multiply(_multiply(bent_x, per_reach, _r0), vx_1, _r0)
    _s1 = _multiply(_multiply(bent_y, per_reach, _r1), vy_1, _r1)
    _s2 = _multiply(_multiply(bent_z, per_reach, _r2), vz_1, _r2)
    _s3 = _multiply(0.6 * p_gravity, nz_1, _r3) - _add(_add(_add(_multiply(nx_1, vx_1, _r4), _multiply(vx_0, _s0, _r5), _r5), _add(_multiply(ny_1, vy_1, _r4), _multiply(vy_0, _s1, _r6), _r6), _r6), _add(_multiply(nz_1, vz_1, _r5), _multiply(vz_0, _s2, _r4), _r4), _r4)
    _s4 = _multiply(ny_1, nz_1, _r4)
    _s5 = _add(_multiply(ny_0, _s2, _r3), _s4, _r3) - _add(_s4, _multiply(nz_0, _s1, _r6), _r6)
    _s6 = _multiply(nx_1, nz_1, _r6)
    _s7 = _add(_s6, _multiply(nz_0, _s0, _r3), _r3) - _add(_multiply(nx_0, _s2, _r4), _s6, _r4)
    _s8 = _multiply(nx_1, ny_1, _r4)
    _s9 = _add(_multiply(nx_0, _s1, _r3), _s8, _r3) - _add(_s8, _multiply(ny_0, _s0, _r6), _r6)
    _s10 = -_multiply(0.5, _add(_add(_add(_multiply(tx_0, vx_1, _r6), _multiply(vx_0, _s5, _r3), _r3), _add(_multiply(ty_0, vy_1, _r6), _multiply(vy_0, _s7, _r4), _r4), _r4), _add(_multiply(tz_0, vz_1, _r3), _multiply(vz_0, _s9, _r6), _r6), _r6), _r6)
    return _s3, _s5, _s7, _s9, 0.5 * _add(_add(_multiply(lift_0, nx_1, _r6), _multiply(nx_0, _s3, _r4), _r4), _multiply(0.4, _add(_multiply(turn_rate_0, _s5, _r6), _multiply(turn_rate_1, tx_0, _r3), _r3), _r3), _r3), 0.5 * _add(_add(_multiply(lift_0, ny_1, _r3), _multiply(ny_0, _s3, _r4), _r4), _multiply(0.4, _add(_multiply(turn_rate_0, _s7, _r3), _multiply(turn_rate_1, ty_0, _r6), _r6), _r6), _r6), 0.5 * _add(_add(_multiply(lift_0, nz_1, _r6), _multiply(nz_0, _s3, _r4), _r4), _multiply(0.4, _add(_multiply(turn_rate_0, _s9, _r6), _multiply(turn_rate_1, tz_0, _r3), _r3), _r3), _r3), 0.5 * _s0, 0.5 * _s1, 0.5 * _s2, _s10


def roll_2(bent_x: Any, bent_y: Any, bent_z: Any, p_gravity: Any, lift_0: Any, lift_1: Any, nx_0: Any, nx_1: Any, nx_2: Any, ny_0: Any, ny_1: Any, ny_2: Any, nz_0: Any, nz_1: Any, nz_2: Any, per_reach: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, tx_0: Any, tx_1: Any, ty_0: Any, ty_1: Any, tz_0: Any, tz_1: Any, vx_0: Any, vx_1: Any, vx_2: Any, vy_0: Any, vy_1: Any, vy_2: Any, vz_0: Any, vz_1: Any, vz_2: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 3 of a ball that rolls, from those before.

    Newton, Euler and rolling without slip. 125 operations: 43 additions, 4 subtractions, 77 multiplications, 1 negation.
    Returns lift_2, tx_2, ty_2, tz_2, vx_3, vy_3, vz_3, nx_3, ny_3, nz_3, turn_rate_3.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8 = _room[:9]
    _s0 = _multiply(2.0, nx_2, _r0)
    _s1 = _multiply(_multiply(bent_x, per_reach, _r1), vx_2, _r1)
    _s2 = _multiply(2.0, ny_2, _r2)
    _s3 = _multiply(_multiply(bent_y, per_reach, _r3), vy_2, _r3)
    _s4 = _multiply(_multiply(bent_z, per_reach, _r4), vz_2, _r4)
    _s5 = _multiply(0.6 * p_gravity, nz_2, _r5) - _add(_add(_add(_add(_multiply(nx_1, vx_2, _r6), _multiply(_s0, vx_1, _r7), _r7), _multiply(vx_0, _s1, _r6), _r6), _add(_add(_multiply(ny_1, vy_2, _r7), _multiply(_s2, vy_1, _r8), _r8), _multiply(vy_0, _s3, _r7), _r7), _r7), _add(_add(_multiply(nz_1, vz_2, _r6), _multiply(_multiply(2.0, nz_2, _r8), vz_1, _r8), _r8), _multiply(vz_0, _s4, _r6), _r6), _r6)
    _s6 = _add(_add(_multiply(ny_0, _s4, _r6), _multiply(_multiply(2.0, ny_1, _r5), nz_2, _r5), _r5), _multiply(ny_2, nz_1, _r6), _r6) - _add(_add(_multiply(ny_1, nz_2, _r5), _multiply(_s2, nz_1, _r2), _r2), _multiply(nz_0, _s3, _r5), _r5)
    _s7 = _multiply(2.0, nx_1, _r5)
    _s8 = _add(_add(_multiply(nx_1, nz_2, _r6), _multiply(_s0, nz_1, _r2), _r2), _multiply(nz_0, _s1, _r6), _r6) - _add(_add(_multiply(nx_0, _s4, _r2), _multiply(_s7, nz_2, _r7), _r7), _multiply(nx_2, nz_1, _r2), _r2)
    _s9 = _add(_add(_multiply(nx_0, _s3, _r2), _multiply(_s7, ny_2, _r5), _r5), _multiply(nx_2, ny_1, _r2), _r2) - _add(_add(_multiply(nx_1, ny_2, _r5), _multiply(_s0, ny_1, _r0), _r0), _multiply(ny_0, _s1, _r5), _r5)
    _s10 = 0.3333333333333333 * _add(_add(_add(_multiply(lift_0, nx_2, _r5), _multiply(lift_1, nx_1, _r2), _r2), _multiply(nx_0, _s5, _r5), _r5), _multiply(0.4, _add(_add(_multiply(turn_rate_0, _s6, _r2), _multiply(turn_rate_1, tx_1, _r0), _r0), _multiply(turn_rate_2, tx_0, _r2), _r2), _r2), _r2)
    _s11 = 0.3333333333333333 * _add(_add(_add(_multiply(lift_0, ny_2, _r2), _multiply(lift_1, ny_1, _r5), _r5), _multiply(ny_0, _s5, _r2), _r2), _multiply(0.4, _add(_add(_multiply(turn_rate_0, _s8, _r5), _multiply(turn_rate_1, ty_1, _r0), _r0), _multiply(turn_rate_2, ty_0, _r5), _r5), _r5), _r5)
    _s12 = 0.3333333333333333 * _add(_add(_add(_multiply(lift_0, nz_2, _r5), _multiply(lift_1, nz_1, _r2), _r2), _multiply(nz_0, _s5, _r5), _r5), _multiply(0.4, _add(_add(_multiply(turn_rate_0, _s9, _r2), _multiply(turn_rate_1, tz_1, _r0), _r0), _multiply(turn_rate_2, tz_0, _r2), _r2), _r2), _r2)
    _s13 = _multiply(0.3333333333333333, _add(_add(_add(_add(_multiply(tx_0, vx_2, _r2), _multiply(tx_1, vx_1, _r5), _r5), _multiply(vx_0, _s6, _r2), _r2), _add(_add(_multiply(ty_0, vy_2, _r5), _multiply(ty_1, vy_1, _r0), _r0), _multiply(vy_0, _s8, _r5), _r5), _r5), _add(_add(_multiply(tz_0, vz_2, _r2), _multiply(tz_1, vz_1, _r0), _r0), _multiply(vz_0, _s9, _r2), _r2), _r2), _r2)
    return _s5, _s6, _s8, _s9, _s10, _s11, _s12, 0.3333333333333333 * _s1, 0.3333333333333333 * _s3, 0.3333333333333333 * _s4, -_s13


def roll_3(bent_x: Any, bent_y: Any, bent_z: Any, p_gravity: Any, lift_0: Any, lift_1: Any, lift_2: Any, nx_0: Any, nx_1: Any, nx_2: Any, nx_3: Any, ny_0: Any, ny_1: Any, ny_2: Any, ny_3: Any, nz_0: Any, nz_1: Any, nz_2: Any, nz_3: Any, per_reach: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, turn_rate_3: Any, tx_0: Any, tx_1: Any, tx_2: Any, ty_0: Any, ty_1: Any, ty_2: Any, tz_0: Any, tz_1: Any, tz_2: Any, vx_0: Any, vx_1: Any, vx_2: Any, vx_3: Any, vy_0: Any, vy_1: Any, vy_2: Any, vy_3: Any, vz_0: Any, vz_1: Any, vz_2: Any, vz_3: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 4 of a ball that rolls, from those before.

    Newton, Euler and rolling without slip. 161 operations: 61 additions, 4 subtractions, 95 multiplications, 1 negation.
    Returns lift_3, tx_3, ty_3, tz_3, vx_4, vy_4, vz_4, nx_4, ny_4, nz_4, turn_rate_4.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9 = _room[:10]
    _s0 = _multiply(2.0, nx_2, _r0)
    _s1 = _multiply(3.0, nx_3, _r1)
    _s2 = _multiply(_multiply(bent_x, per_reach, _r2), vx_3, _r2)
    _s3 = _multiply(2.0, ny_2, _r3)
    _s4 = _multiply(3.0, ny_3, _r4)
    _s5 = _multiply(_multiply(bent_y, per_reach, _r5), vy_3, _r5)
    _s6 = _multiply(_multiply(bent_z, per_reach, _r6), vz_3, _r6)
    _s7 = _add(_add(_add(_add(_add(_multiply(nx_1, vx_3, _r7), _multiply(_s0, vx_2, _r8), _r8), _multiply(_s1, vx_1, _r7), _r7), _multiply(vx_0, _s2, _r8), _r8), _add(_add(_add(_multiply(ny_1, vy_3, _r7), _multiply(_s3, vy_2, _r9), _r9), _multiply(_s4, vy_1, _r7), _r7), _multiply(vy_0, _s5, _r9), _r9), _r9), _add(_add(_add(_multiply(nz_1, vz_3, _r8), _multiply(_multiply(2.0, nz_2, _r7), vz_2, _r7), _r7), _multiply(_multiply(3.0, nz_3, _r8), vz_1, _r8), _r8), _multiply(vz_0, _s6, _r7), _r7), _r7)
    _s8 = _multiply(0.6 * p_gravity, nz_3, _r9) - _s7
    _s9 = _multiply(_s3, nz_2, _r3)
    _s10 = _add(_add(_add(_multiply(ny_0, _s6, _r7), _multiply(_multiply(3.0, ny_1, _r9), nz_3, _r9), _r9), _s9, _r9), _multiply(ny_3, nz_1, _r7), _r7) - _add(_add(_add(_multiply(ny_1, nz_3, _r9), _s9, _r9), _multiply(_s4, nz_1, _r4), _r4), _multiply(nz_0, _s5, _r9), _r9)
    _s11 = _multiply(_s0, nz_2, _r9)
    _s12 = _multiply(3.0, nx_1, _r7)
    _s13 = _add(_add(_add(_multiply(nx_1, nz_3, _r4), _s11, _r4), _multiply(_s1, nz_1, _r3), _r3), _multiply(nz_0, _s2, _r4), _r4) - _add(_add(_add(_multiply(nx_0, _s6, _r3), _multiply(_s12, nz_3, _r8), _r8), _s11, _r8), _multiply(nx_3, nz_1, _r9), _r9)
    _s14 = _multiply(_s0, ny_2, _r0)
    _s15 = _add(_add(_add(_multiply(nx_0, _s5, _r9), _multiply(_s12, ny_3, _r7), _r7), _s14, _r7), _multiply(nx_3, ny_1, _r9), _r9) - _add(_add(_add(_multiply(nx_1, ny_3, _r7), _s14, _r7), _multiply(_s1, ny_1, _r1), _r1), _multiply(ny_0, _s2, _r7), _r7)
    _s16 = _add(_add(_add(_add(_multiply(lift_0, nx_3, _r7), _multiply(lift_1, nx_2, _r9), _r9), _multiply(lift_2, nx_1, _r7), _r7), _multiply(nx_0, _s8, _r9), _r9), _multiply(0.4, _add(_add(_add(_multiply(turn_rate_0, _s10, _r7), _multiply(turn_rate_1, tx_2, _r1), _r1), _multiply(turn_rate_2, tx_1, _r7), _r7), _multiply(turn_rate_3, tx_0, _r1), _r1), _r1), _r1)
    _s17 = _add(_add(_add(_add(_multiply(lift_0, ny_3, _r9), _multiply(lift_1, ny_2, _r7), _r7), _multiply(lift_2, ny_1, _r9), _r9), _multiply(ny_0, _s8, _r7), _r7), _multiply(0.4, _add(_add(_add(_multiply(turn_rate_0, _s13, _r9), _multiply(turn_rate_1, ty_2, _r0), _r0), _multiply(turn_rate_2, ty_1, _r9), _r9), _multiply(turn_rate_3, ty_0, _r0), _r0), _r0), _r0)
    _s18 = _add(_add(_add(_add(_multiply(lift_0, nz_3, _r7), _multiply(lift_1, nz_2, _r9), _r9), _multiply(lift_2, nz_1, _r7), _r7), _multiply(nz_0, _s8, _r9), _r9), _multiply(0.4, _add(_add(_add(_multiply(turn_rate_0, _s15, _r7), _multiply(turn_rate_1, tz_2, _r4), _r4), _multiply(turn_rate_2, tz_1, _r7), _r7), _multiply(turn_rate_3, tz_0, _r4), _r4), _r4), _r4)
    _s19 = _add(_add(_add(_add(_add(_multiply(tx_0, vx_3, _r9), _multiply(tx_1, vx_2, _r7), _r7), _multiply(tx_2, vx_1, _r9), _r9), _multiply(vx_0, _s10, _r7), _r7), _add(_add(_add(_multiply(ty_0, vy_3, _r9), _multiply(ty_1, vy_2, _r8), _r8), _multiply(ty_2, vy_1, _r9), _r9), _multiply(vy_0, _s13, _r8), _r8), _r8), _add(_add(_add(_multiply(tz_0, vz_3, _r7), _multiply(tz_1, vz_2, _r9), _r9), _multiply(tz_2, vz_1, _r7), _r7), _multiply(vz_0, _s15, _r9), _r9), _r9)
    return _s8, _s10, _s13, _s15, 0.25 * _s16, 0.25 * _s17, 0.25 * _s18, 0.25 * _s2, 0.25 * _s5, 0.25 * _s6, -_multiply(0.25, _s19, _r9)


def roll_4(bent_x: Any, bent_y: Any, bent_z: Any, p_gravity: Any, lift_0: Any, lift_1: Any, lift_2: Any, lift_3: Any, nx_0: Any, nx_1: Any, nx_2: Any, nx_3: Any, nx_4: Any, ny_0: Any, ny_1: Any, ny_2: Any, ny_3: Any, ny_4: Any, nz_0: Any, nz_1: Any, nz_2: Any, nz_3: Any, nz_4: Any, per_reach: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, tx_0: Any, tx_1: Any, tx_2: Any, tx_3: Any, ty_0: Any, ty_1: Any, ty_2: Any, ty_3: Any, tz_0: Any, tz_1: Any, tz_2: Any, tz_3: Any, vx_0: Any, vx_1: Any, vx_2: Any, vx_3: Any, vx_4: Any, vy_0: Any, vy_1: Any, vy_2: Any, vy_3: Any, vy_4: Any, vz_0: Any, vz_1: Any, vz_2: Any, vz_3: Any, vz_4: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 5 of a ball that rolls, from those before.

    Newton, Euler and rolling without slip. 207 operations: 79 additions, 4 subtractions, 123 multiplications, 1 negation.
    Returns lift_4, tx_4, ty_4, tz_4, vx_5, vy_5, vz_5, nx_5, ny_5, nz_5, turn_rate_5.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11 = _room[:12]
    _s0 = _multiply(2.0, nx_2, _r0)
    _s1 = _multiply(3.0, nx_3, _r1)
    _s2 = _multiply(4.0, nx_4, _r2)
    _s3 = _multiply(_multiply(bent_x, per_reach, _r3), vx_4, _r3)
    _s4 = _multiply(2.0, ny_2, _r4)
    _s5 = _multiply(3.0, ny_3, _r5)
    _s6 = _multiply(4.0, ny_4, _r6)
    _s7 = _multiply(_multiply(bent_y, per_reach, _r7), vy_4, _r7)
    _s8 = _add(_add(_add(_add(_add(_multiply(nx_1, vx_4, _r8), _multiply(_s0, vx_3, _r9), _r9), _multiply(_s1, vx_2, _r8), _r8), _multiply(_s2, vx_1, _r9), _r9), _multiply(vx_0, _s3, _r8), _r8), _add(_add(_add(_add(_multiply(ny_1, vy_4, _r9), _multiply(_s4, vy_3, _r10), _r10), _multiply(_s5, vy_2, _r9), _r9), _multiply(_s6, vy_1, _r10), _r10), _multiply(vy_0, _s7, _r9), _r9), _r9)
    _s9 = _multiply(_multiply(bent_z, per_reach, _r8), vz_4, _r8)
    _s10 = _add(_add(_add(_add(_multiply(nz_1, vz_4, _r10), _multiply(_multiply(2.0, nz_2, _r11), vz_3, _r11), _r11), _multiply(_multiply(3.0, nz_3, _r10), vz_2, _r10), _r10), _multiply(_multiply(4.0, nz_4, _r11), vz_1, _r11), _r11), _multiply(vz_0, _s9, _r10), _r10)
    _s11 = _multiply(0.6 * p_gravity, nz_4, _r11) - _add(_s8, _s10, _r10)
    _s12 = _add(_add(_add(_add(_multiply(ny_0, _s9, _r10), _multiply(_multiply(4.0, ny_1, _r11), nz_4, _r11), _r11), _multiply(_multiply(3.0, ny_2, _r10), nz_3, _r10), _r10), _multiply(_multiply(2.0, ny_3, _r11), nz_2, _r11), _r11), _multiply(ny_4, nz_1, _r10), _r10)
    _s13 = _s12 - _add(_add(_add(_add(_multiply(ny_1, nz_4, _r11), _multiply(_s4, nz_3, _r4), _r4), _multiply(_s5, nz_2, _r5), _r5), _multiply(_s6, nz_1, _r6), _r6), _multiply(nz_0, _s7, _r5), _r5)
    _s14 = _multiply(4.0, nx_1, _r5)
    _s15 = _multiply(3.0, nx_2, _r10)
    _s16 = _multiply(2.0, nx_3, _r6)
    _s17 = _add(_add(_add(_add(_multiply(nx_1, nz_4, _r4), _multiply(_s0, nz_3, _r11), _r11), _multiply(_s1, nz_2, _r4), _r4), _multiply(_s2, nz_1, _r11), _r11), _multiply(nz_0, _s3, _r4), _r4) - _add(_add(_add(_add(_multiply(nx_0, _s9, _r11), _multiply(_s14, nz_4, _r9), _r9), _multiply(_s15, nz_3, _r11), _r11), _multiply(_s16, nz_2, _r9), _r9), _multiply(nx_4, nz_1, _r11), _r11)
    _s18 = _add(_add(_add(_add(_multiply(nx_0, _s7, _r11), _multiply(_s14, ny_4, _r5), _r5), _multiply(_s15, ny_3, _r10), _r10), _multiply(_s16, ny_2, _r6), _r6), _multiply(nx_4, ny_1, _r10), _r10) - _add(_add(_add(_add(_multiply(nx_1, ny_4, _r6), _multiply(_s0, ny_3, _r0), _r0), _multiply(_s1, ny_2, _r1), _r1), _multiply(_s2, ny_1, _r2), _r2), _multiply(ny_0, _s3, _r1), _r1)
    _s19 = _multiply(0.4, _add(_add(_add(_add(_multiply(turn_rate_0, _s13, _r1), _multiply(turn_rate_1, tx_3, _r10), _r10), _multiply(turn_rate_2, tx_2, _r1), _r1), _multiply(turn_rate_3, tx_1, _r10), _r10), _multiply(turn_rate_4, tx_0, _r1), _r1), _r1)
    _s20 = _add(_add(_add(_add(_add(_multiply(lift_0, nx_4, _r10), _multiply(lift_1, nx_3, _r2), _r2), _multiply(lift_2, nx_2, _r10), _r10), _multiply(lift_3, nx_1, _r2), _r2), _multiply(nx_0, _s11, _r10), _r10), _s19, _r1)
    _s21 = _multiply(0.4, _add(_add(_add(_add(_multiply(turn_rate_0, _s17, _r10), _multiply(turn_rate_1, ty_3, _r2), _r2), _multiply(turn_rate_2, ty_2, _r10), _r10), _multiply(turn_rate_3, ty_1, _r2), _r2), _multiply(turn_rate_4, ty_0, _r10), _r10), _r10)
    _s22 = _add(_add(_add(_add(_add(_multiply(lift_0, ny_4, _r2), _multiply(lift_1, ny_3, _r0), _r0), _multiply(lift_2, ny_2, _r2), _r2), _multiply(lift_3, ny_1, _r0), _r0), _multiply(ny_0, _s11, _r2), _r2), _s21, _r10)
    _s23 = _multiply(0.4, _add(_add(_add(_add(_multiply(turn_rate_0, _s18, _r2), _multiply(turn_rate_1, tz_3, _r0), _r0), _multiply(turn_rate_2, tz_2, _r2), _r2), _multiply(turn_rate_3, tz_1, _r0), _r0), _multiply(turn_rate_4, tz_0, _r2), _r2), _r2)
    _s24 = _add(_add(_add(_add(_add(_multiply(lift_0, nz_4, _r0), _multiply(lift_1, nz_3, _r6), _r6), _multiply(lift_2, nz_2, _r0), _r0), _multiply(lift_3, nz_1, _r6), _r6), _multiply(nz_0, _s11, _r0), _r0), _s23, _r2)
    _s25 = _add(_add(_add(_add(_add(_multiply(tx_0, vx_4, _r0), _multiply(tx_1, vx_3, _r6), _r6), _multiply(tx_2, vx_2, _r0), _r0), _multiply(tx_3, vx_1, _r6), _r6), _multiply(vx_0, _s13, _r0), _r0), _add(_add(_add(_add(_multiply(ty_0, vy_4, _r6), _multiply(ty_1, vy_3, _r5), _r5), _multiply(ty_2, vy_2, _r6), _r6), _multiply(ty_3, vy_1, _r5), _r5), _multiply(vy_0, _s17, _r6), _r6), _r6)
    _s26 = _add(_s25, _add(_add(_add(_add(_multiply(tz_0, vz_4, _r0), _multiply(tz_1, vz_3, _r5), _r5), _multiply(tz_2, vz_2, _r0), _r0), _multiply(tz_3, vz_1, _r5), _r5), _multiply(vz_0, _s18, _r0), _r0), _r0)
    return _s11, _s13, _s17, _s18, 0.2 * _s20, 0.2 * _s22, 0.2 * _s24, 0.2 * _s3, 0.2 * _s7, 0.2 * _s9, -_multiply(0.2, _s26, _r0)


def roll_5(bent_x: Any, bent_y: Any, bent_z: Any, p_gravity: Any, lift_0: Any, lift_1: Any, lift_2: Any, lift_3: Any, lift_4: Any, nx_0: Any, nx_1: Any, nx_2: Any, nx_3: Any, nx_4: Any, nx_5: Any, ny_0: Any, ny_1: Any, ny_2: Any, ny_3: Any, ny_4: Any, ny_5: Any, nz_0: Any, nz_1: Any, nz_2: Any, nz_3: Any, nz_4: Any, nz_5: Any, per_reach: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, turn_rate_5: Any, tx_0: Any, tx_1: Any, tx_2: Any, tx_3: Any, tx_4: Any, ty_0: Any, ty_1: Any, ty_2: Any, ty_3: Any, ty_4: Any, tz_0: Any, tz_1: Any, tz_2: Any, tz_3: Any, tz_4: Any, vx_0: Any, vx_1: Any, vx_2: Any, vx_3: Any, vx_4: Any, vx_5: Any, vy_0: Any, vy_1: Any, vy_2: Any, vy_3: Any, vy_4: Any, vy_5: Any, vz_0: Any, vz_1: Any, vz_2: Any, vz_3: Any, vz_4: Any, vz_5: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 6 of a ball that rolls, from those before.

    Newton, Euler and rolling without slip. 243 operations: 97 additions, 4 subtractions, 141 multiplications, 1 negation.
    Returns lift_5, tx_5, ty_5, tz_5, vx_6, vy_6, vz_6, nx_6, ny_6, nz_6, turn_rate_6.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14 = _room[:15]
    _s0 = _multiply(2.0, nx_2, _r0)
    _s1 = _multiply(3.0, nx_3, _r1)
    _s2 = _multiply(4.0, nx_4, _r2)
    _s3 = _multiply(5.0, nx_5, _r3)
    _s4 = _multiply(_multiply(bent_x, per_reach, _r4), vx_5, _r4)
    _s5 = _add(_add(_add(_add(_add(_multiply(nx_1, vx_5, _r5), _multiply(_s0, vx_4, _r6), _r6), _multiply(_s1, vx_3, _r5), _r5), _multiply(_s2, vx_2, _r6), _r6), _multiply(_s3, vx_1, _r5), _r5), _multiply(vx_0, _s4, _r6), _r6)
    _s6 = _multiply(2.0, ny_2, _r5)
    _s7 = _multiply(3.0, ny_3, _r7)
    _s8 = _multiply(4.0, ny_4, _r8)
    _s9 = _multiply(5.0, ny_5, _r9)
    _s10 = _multiply(_multiply(bent_y, per_reach, _r10), vy_5, _r10)
    _s11 = _add(_add(_add(_add(_add(_multiply(ny_1, vy_5, _r11), _multiply(_s6, vy_4, _r12), _r12), _multiply(_s7, vy_3, _r11), _r11), _multiply(_s8, vy_2, _r12), _r12), _multiply(_s9, vy_1, _r11), _r11), _multiply(vy_0, _s10, _r12), _r12)
    _s12 = _add(_add(_add(_add(_multiply(nz_1, vz_5, _r11), _multiply(_multiply(2.0, nz_2, _r13), vz_4, _r13), _r13), _multiply(_multiply(3.0, nz_3, _r11), vz_3, _r11), _r11), _multiply(_multiply(4.0, nz_4, _r13), vz_2, _r13), _r13), _multiply(_multiply(5.0, nz_5, _r11), vz_1, _r11), _r11)
    _s13 = _multiply(_multiply(bent_z, per_reach, _r13), vz_5, _r13)
    _s14 = _multiply(0.6 * p_gravity, nz_5, _r14) - _add(_add(_s5, _s11, _r12), _add(_s12, _multiply(vz_0, _s13, _r6), _r6), _r6)
    _s15 = _multiply(_s7, nz_3, _r7)
    _s16 = _add(_add(_add(_add(_multiply(ny_0, _s13, _r6), _multiply(_multiply(5.0, ny_1, _r14), nz_5, _r14), _r14), _multiply(_multiply(4.0, ny_2, _r6), nz_4, _r6), _r6), _s15, _r6), _multiply(_multiply(2.0, ny_4, _r14), nz_2, _r14), _r14)
    _s17 = _add(_add(_add(_add(_add(_multiply(ny_1, nz_5, _r6), _multiply(_s6, nz_4, _r5), _r5), _s15, _r5), _multiply(_s8, nz_2, _r8), _r8), _multiply(_s9, nz_1, _r9), _r9), _multiply(nz_0, _s10, _r8), _r8)
    _s18 = _add(_s16, _multiply(ny_5, nz_1, _r9), _r9) - _s17
    _s19 = _multiply(_s1, nz_3, _r8)
    _s20 = _add(_add(_add(_add(_add(_multiply(nx_1, nz_5, _r9), _multiply(_s0, nz_4, _r14), _r14), _s19, _r14), _multiply(_s2, nz_2, _r9), _r9), _multiply(_s3, nz_1, _r14), _r14), _multiply(nz_0, _s4, _r9), _r9)
    _s21 = _multiply(5.0, nx_1, _r14)
    _s22 = _multiply(4.0, nx_2, _r5)
    _s23 = _multiply(2.0, nx_4, _r7)
    _s24 = _add(_add(_add(_add(_add(_multiply(nx_0, _s13, _r6), _multiply(_s21, nz_5, _r12), _r12), _multiply(_s22, nz_4, _r6), _r6), _s19, _r6), _multiply(_s23, nz_2, _r8), _r8), _multiply(nx_5, nz_1, _r6), _r6)
    _s25 = _s20 - _s24
    _s26 = _multiply(_s1, ny_3, _r1)
    _s27 = _add(_add(_add(_add(_add(_multiply(nx_0, _s10, _r6), _multiply(_s21, ny_5, _r14), _r14), _multiply(_s22, ny_4, _r5), _r5), _s26, _r5), _multiply(_s23, ny_2, _r7), _r7), _multiply(nx_5, ny_1, _r5), _r5)
    _s28 = _add(_add(_add(_add(_add(_multiply(nx_1, ny_5, _r7), _multiply(_s0, ny_4, _r0), _r0), _s26, _r0), _multiply(_s2, ny_2, _r2), _r2), _multiply(_s3, ny_1, _r3), _r3), _multiply(ny_0, _s4, _r2), _r2)
    _s29 = _s27 - _s28
    _s30 = _add(_add(_add(_add(_add(_multiply(lift_0, nx_5, _r2), _multiply(lift_1, nx_4, _r5), _r5), _multiply(lift_2, nx_3, _r2), _r2), _multiply(lift_3, nx_2, _r5), _r5), _multiply(lift_4, nx_1, _r2), _r2), _multiply(nx_0, _s14, _r5), _r5)
    _s31 = _add(_add(_add(_add(_add(_multiply(turn_rate_0, _s18, _r2), _multiply(turn_rate_1, tx_4, _r3), _r3), _multiply(turn_rate_2, tx_3, _r2), _r2), _multiply(turn_rate_3, tx_2, _r3), _r3), _multiply(turn_rate_4, tx_1, _r2), _r2), _multiply(turn_rate_5, tx_0, _r3), _r3)
    _s32 = _add(_add(_add(_add(_add(_multiply(lift_0, ny_5, _r2), _multiply(lift_1, ny_4, _r0), _r0), _multiply(lift_2, ny_3, _r2), _r2), _multiply(lift_3, ny_2, _r0), _r0), _multiply(lift_4, ny_1, _r2), _r2), _multiply(ny_0, _s14, _r0), _r0)
    _s33 = _add(_add(_add(_add(_add(_multiply(turn_rate_0, _s25, _r2), _multiply(turn_rate_1, ty_4, _r1), _r1), _multiply(turn_rate_2, ty_3, _r2), _r2), _multiply(turn_rate_3, ty_2, _r1), _r1), _multiply(turn_rate_4, ty_1, _r2), _r2), _multiply(turn_rate_5, ty_0, _r1), _r1)
    _s34 = _add(_add(_add(_add(_add(_multiply(lift_0, nz_5, _r2), _multiply(lift_1, nz_4, _r7), _r7), _multiply(lift_2, nz_3, _r2), _r2), _multiply(lift_3, nz_2, _r7), _r7), _multiply(lift_4, nz_1, _r2), _r2), _multiply(nz_0, _s14, _r7), _r7)
    _s35 = _add(_add(_add(_add(_add(_multiply(turn_rate_0, _s29, _r2), _multiply(turn_rate_1, tz_4, _r14), _r14), _multiply(turn_rate_2, tz_3, _r2), _r2), _multiply(turn_rate_3, tz_2, _r14), _r14), _multiply(turn_rate_4, tz_1, _r2), _r2), _multiply(turn_rate_5, tz_0, _r14), _r14)
    _s36 = _add(_add(_add(_add(_add(_multiply(tx_0, vx_5, _r2), _multiply(tx_1, vx_4, _r6), _r6), _multiply(tx_2, vx_3, _r2), _r2), _multiply(tx_3, vx_2, _r6), _r6), _multiply(tx_4, vx_1, _r2), _r2), _multiply(vx_0, _s18, _r6), _r6)
    _s37 = _add(_add(_add(_add(_add(_multiply(ty_0, vy_5, _r2), _multiply(ty_1, vy_4, _r9), _r9), _multiply(ty_2, vy_3, _r2), _r2), _multiply(ty_3, vy_2, _r9), _r9), _multiply(ty_4, vy_1, _r2), _r2), _multiply(vy_0, _s25, _r9), _r9)
    _s38 = _add(_add(_add(_add(_add(_multiply(tz_0, vz_5, _r2), _multiply(tz_1, vz_4, _r8), _r8), _multiply(tz_2, vz_3, _r2), _r2), _multiply(tz_3, vz_2, _r8), _r8), _multiply(tz_4, vz_1, _r2), _r2), _multiply(vz_0, _s29, _r8), _r8)
    return _s14, _s18, _s25, _s29, 0.16666666666666666 * _add(_s30, _multiply(0.4, _s31, _r3), _r3), 0.16666666666666666 * _add(_s32, _multiply(0.4, _s33, _r1), _r1), 0.16666666666666666 * _add(_s34, _multiply(0.4, _s35, _r14), _r14), 0.16666666666666666 * _s4, 0.16666666666666666 * _s10, 0.16666666666666666 * _s13, -_multiply(0.16666666666666666, _add(_add(_s36, _s37, _r9), _s38, _r8), _r8)


def roll_6(bent_x: Any, bent_y: Any, bent_z: Any, p_gravity: Any, lift_0: Any, lift_1: Any, lift_2: Any, lift_3: Any, lift_4: Any, lift_5: Any, nx_0: Any, nx_1: Any, nx_2: Any, nx_3: Any, nx_4: Any, nx_5: Any, nx_6: Any, ny_0: Any, ny_1: Any, ny_2: Any, ny_3: Any, ny_4: Any, ny_5: Any, ny_6: Any, nz_0: Any, nz_1: Any, nz_2: Any, nz_3: Any, nz_4: Any, nz_5: Any, nz_6: Any, per_reach: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, turn_rate_5: Any, turn_rate_6: Any, tx_0: Any, tx_1: Any, tx_2: Any, tx_3: Any, tx_4: Any, tx_5: Any, ty_0: Any, ty_1: Any, ty_2: Any, ty_3: Any, ty_4: Any, ty_5: Any, tz_0: Any, tz_1: Any, tz_2: Any, tz_3: Any, tz_4: Any, tz_5: Any, vx_0: Any, vx_1: Any, vx_2: Any, vx_3: Any, vx_4: Any, vx_5: Any, vx_6: Any, vy_0: Any, vy_1: Any, vy_2: Any, vy_3: Any, vy_4: Any, vy_5: Any, vy_6: Any, vz_0: Any, vz_1: Any, vz_2: Any, vz_3: Any, vz_4: Any, vz_5: Any, vz_6: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 7 of a ball that rolls, from those before.

    Newton, Euler and rolling without slip. 289 operations: 115 additions, 4 subtractions, 169 multiplications, 1 negation.
    Returns lift_6, tx_6, ty_6, tz_6, vx_7, vy_7, vz_7, nx_7, ny_7, nz_7, turn_rate_7.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17 = _room[:18]
    _s0 = _multiply(2.0, nx_2, _r0)
    _s1 = _multiply(3.0, nx_3, _r1)
    _s2 = _multiply(4.0, nx_4, _r2)
    _s3 = _multiply(5.0, nx_5, _r3)
    _s4 = _multiply(6.0, nx_6, _r4)
    _s5 = _add(_add(_add(_add(_add(_multiply(nx_1, vx_6, _r5), _multiply(_s0, vx_5, _r6), _r6), _multiply(_s1, vx_4, _r5), _r5), _multiply(_s2, vx_3, _r6), _r6), _multiply(_s3, vx_2, _r5), _r5), _multiply(_s4, vx_1, _r6), _r6)
    _s6 = _multiply(_multiply(bent_x, per_reach, _r5), vx_6, _r5)
    _s7 = _multiply(2.0, ny_2, _r7)
    _s8 = _multiply(3.0, ny_3, _r8)
    _s9 = _multiply(4.0, ny_4, _r9)
    _s10 = _multiply(5.0, ny_5, _r10)
    _s11 = _multiply(6.0, ny_6, _r11)
    _s12 = _add(_add(_add(_add(_add(_multiply(ny_1, vy_6, _r12), _multiply(_s7, vy_5, _r13), _r13), _multiply(_s8, vy_4, _r12), _r12), _multiply(_s9, vy_3, _r13), _r13), _multiply(_s10, vy_2, _r12), _r12), _multiply(_s11, vy_1, _r13), _r13)
    _s13 = _multiply(_multiply(bent_y, per_reach, _r12), vy_6, _r12)
    _s14 = _add(_add(_add(_add(_multiply(nz_1, vz_6, _r14), _multiply(_multiply(2.0, nz_2, _r15), vz_5, _r15), _r15), _multiply(_multiply(3.0, nz_3, _r14), vz_4, _r14), _r14), _multiply(_multiply(4.0, nz_4, _r15), vz_3, _r15), _r15), _multiply(_multiply(5.0, nz_5, _r14), vz_2, _r14), _r14)
    _s15 = _multiply(_multiply(bent_z, per_reach, _r15), vz_6, _r15)
    _s16 = _multiply(0.6 * p_gravity, nz_6, _r16) - _add(_add(_add(_s5, _multiply(vx_0, _s6, _r17), _r17), _add(_s12, _multiply(vy_0, _s13, _r6), _r6), _r6), _add(_add(_s14, _multiply(_multiply(6.0, nz_6, _r17), vz_1, _r17), _r17), _multiply(vz_0, _s15, _r14), _r14), _r14)
    _s17 = _add(_add(_add(_add(_multiply(ny_0, _s15, _r14), _multiply(_multiply(6.0, ny_1, _r16), nz_6, _r16), _r16), _multiply(_multiply(5.0, ny_2, _r14), nz_5, _r14), _r14), _multiply(_multiply(4.0, ny_3, _r16), nz_4, _r16), _r16), _multiply(_multiply(3.0, ny_4, _r14), nz_3, _r14), _r14)
    _s18 = _add(_add(_add(_add(_add(_multiply(ny_1, nz_6, _r16), _multiply(_s7, nz_5, _r7), _r7), _multiply(_s8, nz_4, _r8), _r8), _multiply(_s9, nz_3, _r9), _r9), _multiply(_s10, nz_2, _r10), _r10), _multiply(_s11, nz_1, _r11), _r11)
    _s19 = _add(_add(_s17, _multiply(_multiply(2.0, ny_5, _r10), nz_2, _r10), _r10), _multiply(ny_6, nz_1, _r14), _r14) - _add(_s18, _multiply(nz_0, _s13, _r10), _r10)
    _s20 = _add(_add(_add(_add(_add(_multiply(nx_1, nz_6, _r10), _multiply(_s0, nz_5, _r14), _r14), _multiply(_s1, nz_4, _r10), _r10), _multiply(_s2, nz_3, _r14), _r14), _multiply(_s3, nz_2, _r10), _r10), _multiply(_s4, nz_1, _r14), _r14)
    _s21 = _multiply(6.0, nx_1, _r10)
    _s22 = _multiply(5.0, nx_2, _r11)
    _s23 = _multiply(4.0, nx_3, _r9)
    _s24 = _multiply(3.0, nx_4, _r8)
    _s25 = _multiply(2.0, nx_5, _r7)
    _s26 = _add(_add(_add(_add(_add(_multiply(nx_0, _s15, _r16), _multiply(_s21, nz_6, _r6), _r6), _multiply(_s22, nz_5, _r16), _r16), _multiply(_s23, nz_4, _r6), _r6), _multiply(_s24, nz_3, _r16), _r16), _multiply(_s25, nz_2, _r6), _r6)
    _s27 = _add(_s20, _multiply(nz_0, _s6, _r16), _r16) - _add(_s26, _multiply(nx_6, nz_1, _r14), _r14)
    _s28 = _add(_add(_add(_add(_add(_multiply(nx_0, _s13, _r14), _multiply(_s21, ny_6, _r10), _r10), _multiply(_s22, ny_5, _r11), _r11), _multiply(_s23, ny_4, _r9), _r9), _multiply(_s24, ny_3, _r8), _r8), _multiply(_s25, ny_2, _r7), _r7)
    _s29 = _add(_add(_add(_add(_add(_multiply(nx_1, ny_6, _r8), _multiply(_s0, ny_5, _r0), _r0), _multiply(_s1, ny_4, _r1), _r1), _multiply(_s2, ny_3, _r2), _r2), _multiply(_s3, ny_2, _r3), _r3), _multiply(_s4, ny_1, _r4), _r4)
    _s30 = _add(_s28, _multiply(nx_6, ny_1, _r3), _r3) - _add(_s29, _multiply(ny_0, _s6, _r7), _r7)
    _s31 = _add(_add(_add(_add(_add(_multiply(lift_0, nx_6, _r7), _multiply(lift_1, nx_5, _r3), _r3), _multiply(lift_2, nx_4, _r7), _r7), _multiply(lift_3, nx_3, _r3), _r3), _multiply(lift_4, nx_2, _r7), _r7), _multiply(lift_5, nx_1, _r3), _r3)
    _s32 = _add(_add(_add(_add(_add(_multiply(turn_rate_0, _s19, _r7), _multiply(turn_rate_1, tx_5, _r4), _r4), _multiply(turn_rate_2, tx_4, _r7), _r7), _multiply(turn_rate_3, tx_3, _r4), _r4), _multiply(turn_rate_4, tx_2, _r7), _r7), _multiply(turn_rate_5, tx_1, _r4), _r4)
    _s33 = _add(_add(_add(_add(_add(_multiply(lift_0, ny_6, _r7), _multiply(lift_1, ny_5, _r2), _r2), _multiply(lift_2, ny_4, _r7), _r7), _multiply(lift_3, ny_3, _r2), _r2), _multiply(lift_4, ny_2, _r7), _r7), _multiply(lift_5, ny_1, _r2), _r2)
    _s34 = _add(_add(_add(_add(_add(_multiply(turn_rate_0, _s27, _r7), _multiply(turn_rate_1, ty_5, _r1), _r1), _multiply(turn_rate_2, ty_4, _r7), _r7), _multiply(turn_rate_3, ty_3, _r1), _r1), _multiply(turn_rate_4, ty_2, _r7), _r7), _multiply(turn_rate_5, ty_1, _r1), _r1)
    _s35 = _add(_add(_add(_add(_add(_multiply(lift_0, nz_6, _r7), _multiply(lift_1, nz_5, _r0), _r0), _multiply(lift_2, nz_4, _r7), _r7), _multiply(lift_3, nz_3, _r0), _r0), _multiply(lift_4, nz_2, _r7), _r7), _multiply(lift_5, nz_1, _r0), _r0)
    _s36 = _add(_add(_add(_add(_add(_multiply(turn_rate_0, _s30, _r7), _multiply(turn_rate_1, tz_5, _r8), _r8), _multiply(turn_rate_2, tz_4, _r7), _r7), _multiply(turn_rate_3, tz_3, _r8), _r8), _multiply(turn_rate_4, tz_2, _r7), _r7), _multiply(turn_rate_5, tz_1, _r8), _r8)
    _s37 = _add(_add(_add(_add(_add(_multiply(tx_0, vx_6, _r7), _multiply(tx_1, vx_5, _r9), _r9), _multiply(tx_2, vx_4, _r7), _r7), _multiply(tx_3, vx_3, _r9), _r9), _multiply(tx_4, vx_2, _r7), _r7), _multiply(tx_5, vx_1, _r9), _r9)
    _s38 = _add(_add(_add(_add(_add(_multiply(ty_0, vy_6, _r7), _multiply(ty_1, vy_5, _r11), _r11), _multiply(ty_2, vy_4, _r7), _r7), _multiply(ty_3, vy_3, _r11), _r11), _multiply(ty_4, vy_2, _r7), _r7), _multiply(ty_5, vy_1, _r11), _r11)
    _s39 = _add(_add(_add(_add(_add(_multiply(tz_0, vz_6, _r7), _multiply(tz_1, vz_5, _r10), _r10), _multiply(tz_2, vz_4, _r7), _r7), _multiply(tz_3, vz_3, _r10), _r10), _multiply(tz_4, vz_2, _r7), _r7), _multiply(tz_5, vz_1, _r10), _r10)
    _s40 = -_multiply(0.14285714285714285, _add(_add(_add(_s37, _multiply(vx_0, _s19, _r7), _r7), _add(_s38, _multiply(vy_0, _s27, _r9), _r9), _r9), _add(_s39, _multiply(vz_0, _s30, _r7), _r7), _r7), _r7)
    return _s16, _s19, _s27, _s30, 0.14285714285714285 * _add(_add(_s31, _multiply(nx_0, _s16, _r7), _r7), _multiply(0.4, _add(_s32, _multiply(turn_rate_6, tx_0, _r3), _r3), _r3), _r3), 0.14285714285714285 * _add(_add(_s33, _multiply(ny_0, _s16, _r3), _r3), _multiply(0.4, _add(_s34, _multiply(turn_rate_6, ty_0, _r2), _r2), _r2), _r2), 0.14285714285714285 * _add(_add(_s35, _multiply(nz_0, _s16, _r2), _r2), _multiply(0.4, _add(_s36, _multiply(turn_rate_6, tz_0, _r0), _r0), _r0), _r0), 0.14285714285714285 * _s6, 0.14285714285714285 * _s13, 0.14285714285714285 * _s15, _s40


def roll_7(bent_x: Any, bent_y: Any, bent_z: Any, p_gravity: Any, lift_0: Any, lift_1: Any, lift_2: Any, lift_3: Any, lift_4: Any, lift_5: Any, lift_6: Any, nx_0: Any, nx_1: Any, nx_2: Any, nx_3: Any, nx_4: Any, nx_5: Any, nx_6: Any, nx_7: Any, ny_0: Any, ny_1: Any, ny_2: Any, ny_3: Any, ny_4: Any, ny_5: Any, ny_6: Any, ny_7: Any, nz_0: Any, nz_1: Any, nz_2: Any, nz_3: Any, nz_4: Any, nz_5: Any, nz_6: Any, nz_7: Any, per_reach: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, turn_rate_5: Any, turn_rate_6: Any, turn_rate_7: Any, tx_0: Any, tx_1: Any, tx_2: Any, tx_3: Any, tx_4: Any, tx_5: Any, tx_6: Any, ty_0: Any, ty_1: Any, ty_2: Any, ty_3: Any, ty_4: Any, ty_5: Any, ty_6: Any, tz_0: Any, tz_1: Any, tz_2: Any, tz_3: Any, tz_4: Any, tz_5: Any, tz_6: Any, vx_0: Any, vx_1: Any, vx_2: Any, vx_3: Any, vx_4: Any, vx_5: Any, vx_6: Any, vx_7: Any, vy_0: Any, vy_1: Any, vy_2: Any, vy_3: Any, vy_4: Any, vy_5: Any, vy_6: Any, vy_7: Any, vz_0: Any, vz_1: Any, vz_2: Any, vz_3: Any, vz_4: Any, vz_5: Any, vz_6: Any, vz_7: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 8 of a ball that rolls, from those before.

    Newton, Euler and rolling without slip. 325 operations: 133 additions, 4 subtractions, 187 multiplications, 1 negation.
    Returns lift_7, tx_7, ty_7, tz_7, vx_8, vy_8, vz_8, nx_8, ny_8, nz_8, turn_rate_8.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18 = _room[:19]
    _s0 = _multiply(2.0, nx_2, _r0)
    _s1 = _multiply(3.0, nx_3, _r1)
    _s2 = _multiply(4.0, nx_4, _r2)
    _s3 = _multiply(5.0, nx_5, _r3)
    _s4 = _multiply(6.0, nx_6, _r4)
    _s5 = _add(_add(_add(_add(_add(_multiply(nx_1, vx_7, _r5), _multiply(_s0, vx_6, _r6), _r6), _multiply(_s1, vx_5, _r5), _r5), _multiply(_s2, vx_4, _r6), _r6), _multiply(_s3, vx_3, _r5), _r5), _multiply(_s4, vx_2, _r6), _r6)
    _s6 = _multiply(7.0, nx_7, _r5)
    _s7 = _multiply(_multiply(bent_x, per_reach, _r7), vx_7, _r7)
    _s8 = _multiply(2.0, ny_2, _r8)
    _s9 = _multiply(3.0, ny_3, _r9)
    _s10 = _multiply(4.0, ny_4, _r10)
    _s11 = _multiply(5.0, ny_5, _r11)
    _s12 = _multiply(6.0, ny_6, _r12)
    _s13 = _add(_add(_add(_add(_add(_multiply(ny_1, vy_7, _r13), _multiply(_s8, vy_6, _r14), _r14), _multiply(_s9, vy_5, _r13), _r13), _multiply(_s10, vy_4, _r14), _r14), _multiply(_s11, vy_3, _r13), _r13), _multiply(_s12, vy_2, _r14), _r14)
    _s14 = _multiply(7.0, ny_7, _r13)
    _s15 = _multiply(_multiply(bent_y, per_reach, _r15), vy_7, _r15)
    _s16 = _add(_add(_add(_add(_multiply(nz_1, vz_7, _r16), _multiply(_multiply(2.0, nz_2, _r17), vz_6, _r17), _r17), _multiply(_multiply(3.0, nz_3, _r16), vz_5, _r16), _r16), _multiply(_multiply(4.0, nz_4, _r17), vz_4, _r17), _r17), _multiply(_multiply(5.0, nz_5, _r16), vz_3, _r16), _r16)
    _s17 = _multiply(_multiply(bent_z, per_reach, _r17), vz_7, _r17)
    _s18 = _add(_add(_add(_add(_s5, _multiply(_s6, vx_1, _r18), _r18), _multiply(vx_0, _s7, _r6), _r6), _add(_add(_s13, _multiply(_s14, vy_1, _r18), _r18), _multiply(vy_0, _s15, _r14), _r14), _r14), _add(_add(_add(_s16, _multiply(_multiply(6.0, nz_6, _r6), vz_2, _r6), _r6), _multiply(_multiply(7.0, nz_7, _r16), vz_1, _r16), _r16), _multiply(vz_0, _s17, _r6), _r6), _r6)
    _s19 = _multiply(0.6 * p_gravity, nz_7, _r14) - _s18
    _s20 = _multiply(_s10, nz_4, _r10)
    _s21 = _add(_add(_add(_add(_multiply(ny_0, _s17, _r6), _multiply(_multiply(7.0, ny_1, _r14), nz_7, _r14), _r14), _multiply(_multiply(6.0, ny_2, _r6), nz_6, _r6), _r6), _multiply(_multiply(5.0, ny_3, _r14), nz_5, _r14), _r14), _s20, _r14)
    _s22 = _add(_add(_add(_add(_add(_multiply(ny_1, nz_7, _r6), _multiply(_s8, nz_6, _r8), _r8), _multiply(_s9, nz_5, _r9), _r9), _s20, _r9), _multiply(_s11, nz_3, _r11), _r11), _multiply(_s12, nz_2, _r12), _r12)
    _s23 = _add(_add(_add(_s21, _multiply(_multiply(3.0, ny_5, _r11), nz_3, _r11), _r11), _multiply(_multiply(2.0, ny_6, _r14), nz_2, _r14), _r14), _multiply(ny_7, nz_1, _r11), _r11) - _add(_add(_s22, _multiply(_s14, nz_1, _r13), _r13), _multiply(nz_0, _s15, _r12), _r12)
    _s24 = _multiply(_s2, nz_4, _r12)
    _s25 = _add(_add(_add(_add(_add(_multiply(nx_1, nz_7, _r11), _multiply(_s0, nz_6, _r13), _r13), _multiply(_s1, nz_5, _r11), _r11), _s24, _r11), _multiply(_s3, nz_3, _r13), _r13), _multiply(_s4, nz_2, _r11), _r11)
    _s26 = _multiply(7.0, nx_1, _r13)
    _s27 = _multiply(6.0, nx_2, _r14)
    _s28 = _multiply(5.0, nx_3, _r9)
    _s29 = _multiply(3.0, nx_5, _r10)
    _s30 = _add(_add(_add(_add(_add(_multiply(nx_0, _s17, _r8), _multiply(_s26, nz_7, _r6), _r6), _multiply(_s27, nz_6, _r8), _r8), _multiply(_s28, nz_5, _r6), _r6), _s24, _r6), _multiply(_s29, nz_3, _r12), _r12)
    _s31 = _multiply(2.0, nx_6, _r6)
    _s32 = _add(_add(_s25, _multiply(_s6, nz_1, _r8), _r8), _multiply(nz_0, _s7, _r11), _r11) - _add(_add(_s30, _multiply(_s31, nz_2, _r8), _r8), _multiply(nx_7, nz_1, _r12), _r12)
    _s33 = _multiply(_s2, ny_4, _r2)
    _s34 = _add(_add(_add(_add(_add(_multiply(nx_0, _s15, _r12), _multiply(_s26, ny_7, _r13), _r13), _multiply(_s27, ny_6, _r14), _r14), _multiply(_s28, ny_5, _r9), _r9), _s33, _r9), _multiply(_s29, ny_3, _r10), _r10)
    _s35 = _add(_add(_add(_add(_add(_multiply(nx_1, ny_7, _r9), _multiply(_s0, ny_6, _r0), _r0), _multiply(_s1, ny_5, _r1), _r1), _s33, _r1), _multiply(_s3, ny_3, _r3), _r3), _multiply(_s4, ny_2, _r4), _r4)
    _s36 = _add(_add(_s34, _multiply(_s31, ny_2, _r6), _r6), _multiply(nx_7, ny_1, _r10), _r10) - _add(_add(_s35, _multiply(_s6, ny_1, _r5), _r5), _multiply(ny_0, _s7, _r4), _r4)
    _s37 = _add(_add(_add(_add(_add(_multiply(lift_0, nx_7, _r4), _multiply(lift_1, nx_6, _r10), _r10), _multiply(lift_2, nx_5, _r4), _r4), _multiply(lift_3, nx_4, _r10), _r10), _multiply(lift_4, nx_3, _r4), _r4), _multiply(lift_5, nx_2, _r10), _r10)
    _s38 = _add(_add(_add(_add(_add(_multiply(turn_rate_0, _s23, _r4), _multiply(turn_rate_1, tx_6, _r5), _r5), _multiply(turn_rate_2, tx_5, _r4), _r4), _multiply(turn_rate_3, tx_4, _r5), _r5), _multiply(turn_rate_4, tx_3, _r4), _r4), _multiply(turn_rate_5, tx_2, _r5), _r5)
    _s39 = 0.125 * _add(_add(_add(_s37, _multiply(lift_6, nx_1, _r4), _r4), _multiply(nx_0, _s19, _r10), _r10), _multiply(0.4, _add(_add(_s38, _multiply(turn_rate_6, tx_1, _r4), _r4), _multiply(turn_rate_7, tx_0, _r5), _r5), _r5), _r5)
    _s40 = _add(_add(_add(_add(_add(_multiply(lift_0, ny_7, _r5), _multiply(lift_1, ny_6, _r10), _r10), _multiply(lift_2, ny_5, _r5), _r5), _multiply(lift_3, ny_4, _r10), _r10), _multiply(lift_4, ny_3, _r5), _r5), _multiply(lift_5, ny_2, _r10), _r10)
    _s41 = _add(_add(_add(_add(_add(_multiply(turn_rate_0, _s32, _r5), _multiply(turn_rate_1, ty_6, _r4), _r4), _multiply(turn_rate_2, ty_5, _r5), _r5), _multiply(turn_rate_3, ty_4, _r4), _r4), _multiply(turn_rate_4, ty_3, _r5), _r5), _multiply(turn_rate_5, ty_2, _r4), _r4)
    _s42 = 0.125 * _add(_add(_add(_s40, _multiply(lift_6, ny_1, _r5), _r5), _multiply(ny_0, _s19, _r10), _r10), _multiply(0.4, _add(_add(_s41, _multiply(turn_rate_6, ty_1, _r5), _r5), _multiply(turn_rate_7, ty_0, _r4), _r4), _r4), _r4)
    _s43 = _add(_add(_add(_add(_add(_multiply(lift_0, nz_7, _r4), _multiply(lift_1, nz_6, _r10), _r10), _multiply(lift_2, nz_5, _r4), _r4), _multiply(lift_3, nz_4, _r10), _r10), _multiply(lift_4, nz_3, _r4), _r4), _multiply(lift_5, nz_2, _r10), _r10)
    _s44 = _add(_add(_add(_add(_add(_multiply(turn_rate_0, _s36, _r4), _multiply(turn_rate_1, tz_6, _r5), _r5), _multiply(turn_rate_2, tz_5, _r4), _r4), _multiply(turn_rate_3, tz_4, _r5), _r5), _multiply(turn_rate_4, tz_3, _r4), _r4), _multiply(turn_rate_5, tz_2, _r5), _r5)
    _s45 = 0.125 * _add(_add(_add(_s43, _multiply(lift_6, nz_1, _r4), _r4), _multiply(nz_0, _s19, _r10), _r10), _multiply(0.4, _add(_add(_s44, _multiply(turn_rate_6, tz_1, _r4), _r4), _multiply(turn_rate_7, tz_0, _r5), _r5), _r5), _r5)
    _s46 = _add(_add(_add(_add(_add(_multiply(tx_0, vx_7, _r5), _multiply(tx_1, vx_6, _r10), _r10), _multiply(tx_2, vx_5, _r5), _r5), _multiply(tx_3, vx_4, _r10), _r10), _multiply(tx_4, vx_3, _r5), _r5), _multiply(tx_5, vx_2, _r10), _r10)
    _s47 = _add(_add(_add(_add(_add(_multiply(ty_0, vy_7, _r5), _multiply(ty_1, vy_6, _r4), _r4), _multiply(ty_2, vy_5, _r5), _r5), _multiply(ty_3, vy_4, _r4), _r4), _multiply(ty_4, vy_3, _r5), _r5), _multiply(ty_5, vy_2, _r4), _r4)
    _s48 = _add(_add(_add(_add(_add(_multiply(tz_0, vz_7, _r5), _multiply(tz_1, vz_6, _r6), _r6), _multiply(tz_2, vz_5, _r5), _r5), _multiply(tz_3, vz_4, _r6), _r6), _multiply(tz_4, vz_3, _r5), _r5), _multiply(tz_5, vz_2, _r6), _r6)
    _s49 = _multiply(0.125, _add(_add(_add(_add(_s46, _multiply(tx_6, vx_1, _r5), _r5), _multiply(vx_0, _s23, _r10), _r10), _add(_add(_s47, _multiply(ty_6, vy_1, _r5), _r5), _multiply(vy_0, _s32, _r4), _r4), _r4), _add(_add(_s48, _multiply(tz_6, vz_1, _r10), _r10), _multiply(vz_0, _s36, _r6), _r6), _r6), _r6)
    return _s19, _s23, _s32, _s36, _s39, _s42, _s45, 0.125 * _s7, 0.125 * _s15, 0.125 * _s17, -_s49


def anew() -> tuple[Any, ...]:
    """A ball that has come from elsewhere.

    Table 1. No operations.
    Returns left_nx, left_ny, left_nz.
    """
    return 0.0, 0.0, 0.0


def started(p_gravity: Any, t: Any, vx: Any, vy: Any, vz: Any, x: Any, y: Any, z: Any) -> tuple[Any, ...]:
    """Where a flight began.

    Eq. 3. 9 operations: 1 addition, 3 subtractions, 5 multiplications.
    Returns from_x, from_y, from_z.
    """
    return x - (t * vx), y - (t * vy), z - (t * (vz + ((0.5 * p_gravity) * t)))


def roll_start(p_ball_radius: Any, nx: Any, ny: Any, nz: Any, vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any) -> tuple[Any, ...]:
    """The constant terms.

    rolling. 6 operations: 2 additions, 4 multiplications.
    Returns vx_0, vy_0, vz_0, nx_0, ny_0, nz_0, turn_rate_0.
    """
    return vx, vy, vz, nx, ny, nz, p_ball_radius * (((nx * wx) + (ny * wy)) + (nz * wz))


def roll_moved(t: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, turn_rate_5: Any, turn_rate_6: Any, turn_rate_7: Any, turn_rate_8: Any, vx_0: Any, vx_1: Any, vx_2: Any, vx_3: Any, vx_4: Any, vx_5: Any, vx_6: Any, vx_7: Any, vx_8: Any, vy_0: Any, vy_1: Any, vy_2: Any, vy_3: Any, vy_4: Any, vy_5: Any, vy_6: Any, vy_7: Any, vy_8: Any, vz_0: Any, vz_1: Any, vz_2: Any, vz_3: Any, vz_4: Any, vz_5: Any, vz_6: Any, vz_7: Any, vz_8: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Where a rolling ball is at time t.

    its series. 140 operations: 59 additions, 81 multiplications.
    Returns x, vx, y, vy, z, vz, turn_rate.
    """
    _r0, _r1, _r2, _r3, _r4, _r5 = _room[:6]
    _s0 = _multiply(0.1111111111111111, t, _r0)
    _s1 = _add(_multiply(0.16666666666666666, vx_5, _r1), _multiply(t, _add(_multiply(0.14285714285714285, vx_6, _r2), _multiply(t, _add(_multiply(0.125, vx_7, _r3), _multiply(_s0, vx_8, _r4), _r4), _r4), _r4), _r4), _r4)
    _s2 = _add(_multiply(0.3333333333333333, vx_2, _r1), _multiply(t, _add(_multiply(0.25, vx_3, _r2), _multiply(t, _add(_multiply(0.2, vx_4, _r3), _multiply(t, _s1, _r4), _r4), _r4), _r4), _r4), _r4)
    _s3 = x + _multiply(t, _add(vx_0, _multiply(t, _add(_multiply(0.5, vx_1, _r1), _multiply(t, _s2, _r4), _r4), _r4), _r4), _r4)
    _s4 = _add(vx_5, _multiply(t, _add(vx_6, _multiply(t, _add(vx_7, _multiply(t, vx_8, _r4), _r4), _r4), _r4), _r4), _r4)
    _s5 = _add(vx_2, _multiply(t, _add(vx_3, _multiply(t, _add(vx_4, _multiply(t, _s4, _r4), _r4), _r4), _r4), _r4), _r4)
    _s6 = _add(_multiply(0.16666666666666666, vy_5, _r1), _multiply(t, _add(_multiply(0.14285714285714285, vy_6, _r2), _multiply(t, _add(_multiply(0.125, vy_7, _r3), _multiply(_s0, vy_8, _r5), _r5), _r5), _r5), _r5), _r5)
    _s7 = _add(_multiply(0.3333333333333333, vy_2, _r1), _multiply(t, _add(_multiply(0.25, vy_3, _r2), _multiply(t, _add(_multiply(0.2, vy_4, _r3), _multiply(t, _s6, _r5), _r5), _r5), _r5), _r5), _r5)
    _s8 = y + _multiply(t, _add(vy_0, _multiply(t, _add(_multiply(0.5, vy_1, _r1), _multiply(t, _s7, _r5), _r5), _r5), _r5), _r5)
    _s9 = _add(vy_5, _multiply(t, _add(vy_6, _multiply(t, _add(vy_7, _multiply(t, vy_8, _r5), _r5), _r5), _r5), _r5), _r5)
    _s10 = _add(vy_2, _multiply(t, _add(vy_3, _multiply(t, _add(vy_4, _multiply(t, _s9, _r5), _r5), _r5), _r5), _r5), _r5)
    _s11 = _add(_multiply(0.16666666666666666, vz_5, _r1), _multiply(t, _add(_multiply(0.14285714285714285, vz_6, _r2), _multiply(t, _add(_multiply(0.125, vz_7, _r3), _multiply(_s0, vz_8, _r0), _r0), _r0), _r0), _r0), _r0)
    _s12 = _add(_multiply(0.3333333333333333, vz_2, _r1), _multiply(t, _add(_multiply(0.25, vz_3, _r2), _multiply(t, _add(_multiply(0.2, vz_4, _r3), _multiply(t, _s11, _r0), _r0), _r0), _r0), _r0), _r0)
    _s13 = z + _multiply(t, _add(vz_0, _multiply(t, _add(_multiply(0.5, vz_1, _r1), _multiply(t, _s12, _r0), _r0), _r0), _r0), _r0)
    _s14 = _add(vz_5, _multiply(t, _add(vz_6, _multiply(t, _add(vz_7, _multiply(t, vz_8, _r0), _r0), _r0), _r0), _r0), _r0)
    _s15 = _add(vz_2, _multiply(t, _add(vz_3, _multiply(t, _add(vz_4, _multiply(t, _s14, _r0), _r0), _r0), _r0), _r0), _r0)
    _s16 = _add(turn_rate_5, _multiply(t, _add(turn_rate_6, _multiply(t, _add(turn_rate_7, _multiply(t, turn_rate_8, _r1), _r1), _r1), _r1), _r1), _r1)
    _s17 = _add(turn_rate_2, _multiply(t, _add(turn_rate_3, _multiply(t, _add(turn_rate_4, _multiply(t, _s16, _r1), _r1), _r1), _r1), _r1), _r1)
    return _s3, vx_0 + _multiply(t, _add(vx_1, _multiply(t, _s5, _r4), _r4), _r4), _s8, vy_0 + _multiply(t, _add(vy_1, _multiply(t, _s10, _r5), _r5), _r5), _s13, vz_0 + _multiply(t, _add(vz_1, _multiply(t, _s15, _r0), _r0), _r0), turn_rate_0 + _multiply(t, _add(turn_rate_1, _multiply(t, _s17, _r1), _r1), _r1)


def roll_placed(p_ball_radius: Any, gap: Any, nx: Any, ny: Any, nz: Any, turn_rate: Any, vx: Any, vy: Any, vz: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """A ball put onto a surface, rolling.

    v = R_B (w × n). 36 operations: 5 additions, 9 subtractions, 21 multiplications, 1 division.
    Returns x, y, z, vx, vy, vz, wx, wy, wz.
    """
    _r0, _r1 = _room[:2]
    _s0 = _add(_add(_multiply(nx, vx, _r0), _multiply(ny, vy, _r1), _r1), _multiply(nz, vz, _r0), _r0)
    _s1 = vx - _multiply(nx, _s0, _r1)
    _s2 = vy - _multiply(ny, _s0, _r1)
    _s3 = vz - _multiply(nz, _s0, _r0)
    _s4 = 1.0 / p_ball_radius
    return x - _multiply(gap, nx, _r0), y - _multiply(gap, ny, _r0), z - _multiply(gap, nz, _r0), _s1, _s2, _s3, _s4 * _subtract(_add(_multiply(nx, turn_rate, _r0), _multiply(ny, _s3, _r1), _r1), _multiply(nz, _s2, _r0), _r0), _s4 * _subtract(_add(_multiply(ny, turn_rate, _r0), _multiply(nz, _s1, _r1), _r1), _multiply(nx, _s3, _r0), _r0), _s4 * _subtract(_add(_multiply(nx, _s2, _r0), _multiply(nz, turn_rate, _r1), _r1), _multiply(ny, _s1, _r0), _r0)


def roll_pace(p_gravity: Any, lift_0: Any, lift_1: Any, lift_2: Any, lift_3: Any, lift_4: Any, lift_5: Any, lift_6: Any, lift_7: Any, nx_8: Any, ny_8: Any, nz_0: Any, nz_1: Any, nz_2: Any, nz_3: Any, nz_4: Any, nz_5: Any, nz_6: Any, nz_7: Any, nz_8: Any, per_reach: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, turn_rate_5: Any, turn_rate_6: Any, turn_rate_7: Any, turn_rate_8: Any, vx_0: Any, vx_1: Any, vx_2: Any, vx_3: Any, vx_4: Any, vx_5: Any, vx_6: Any, vx_7: Any, vx_8: Any, vy_0: Any, vy_1: Any, vy_2: Any, vy_3: Any, vy_4: Any, vy_5: Any, vy_6: Any, vy_7: Any, vy_8: Any, vz_0: Any, vz_1: Any, vz_2: Any, vz_3: Any, vz_4: Any, vz_5: Any, vz_6: Any, vz_7: Any, vz_8: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """A step of the series, bounds of the motion in it, and the normal force.

    the last terms of the series. 159 operations: 53 additions, 49 multiplications, 1 division, 4 square roots, 2 negations, 46 absolute values, 2 comparisons, 2 selections.
    Returns stride, strongest, fastest, force, force_rate, force_bend, brace.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13 = _room[:14]
    _s0 = _add(_add(_add(_absolute(turn_rate_0, _r0), _absolute(vx_0, _r1), _r1), _absolute(vy_0, _r0), _r0), _absolute(vz_0, _r1), _r1)
    _s1 = _add(0.015625 * p_gravity, _s0, _r0)
    _s2 = _absolute(per_reach, _r2)
    _s3 = _add(_add(_add(_absolute(turn_rate_7, _r3), _absolute(vx_7, _r4), _r4), _absolute(vy_7, _r3), _r3), _absolute(vz_7, _r4), _r4)
    _s4 = _add(_add(_add(_absolute(turn_rate_8, _r3), _absolute(vx_8, _r5), _r5), _absolute(vy_8, _r3), _r3), _absolute(vz_8, _r5), _r5)
    _s5 = _add(_multiply(_add(_multiply(_s2, _s0, _r3), _sqrt(_multiply(p_gravity, _s2, _r2), _r2), _r2), _s3, _r2), _s4, _r2)
    _s6 = _multiply(_s1, _add(_add(_absolute(nx_8, _r3), _absolute(ny_8, _r6), _r6), _absolute(nz_8, _r3), _r3), _r3)
    _s7 = _sqrt(_sqrt(_sqrt(_divide(_multiply(1.1102230246251565e-16, _s1, _r0), _select(_s5 < _s6, _s6, _s5, _r6), _r0), _r0), _r0), _r0)
    _s8 = _result(_s7 < 1.0, _s7, 1.0, _r0)
    _s9 = _multiply(_multiply(2.0, _add(_add(_add(_absolute(turn_rate_2, _r6), _absolute(vx_2, _r3), _r3), _absolute(vy_2, _r6), _r6), _absolute(vz_2, _r3), _r3), _r3), _s8, _r3)
    _s10 = _multiply(_s8, _s8, _r6)
    _s11 = _multiply(_multiply(3.0, _add(_add(_add(_absolute(turn_rate_3, _r2), _absolute(vx_3, _r7), _r7), _absolute(vy_3, _r2), _r2), _absolute(vz_3, _r7), _r7), _r7), _s10, _r7)
    _s12 = _multiply(_s8, _s10, _r2)
    _s13 = _multiply(_multiply(4.0, _add(_add(_add(_absolute(turn_rate_4, _r8), _absolute(vx_4, _r9), _r9), _absolute(vy_4, _r8), _r8), _absolute(vz_4, _r9), _r9), _r9), _s12, _r9)
    _s14 = _multiply(_s10, _s10, _r8)
    _s15 = _multiply(_multiply(5.0, _add(_add(_add(_absolute(turn_rate_5, _r10), _absolute(vx_5, _r11), _r11), _absolute(vy_5, _r10), _r10), _absolute(vz_5, _r11), _r11), _r11), _s14, _r11)
    _s16 = _multiply(_s8, _s14, _r10)
    _s17 = _multiply(_multiply(6.0, _add(_add(_add(_absolute(turn_rate_6, _r12), _absolute(vx_6, _r13), _r13), _absolute(vy_6, _r12), _r12), _absolute(vz_6, _r13), _r13), _r13), _s16, _r13)
    _s18 = _add(_add(_add(_add(_add(_add(_s9, _s11, _r7), _s13, _r9), _s15, _r11), _s17, _r13), _multiply(_multiply(7.0, _s3, _r4), _multiply(_s10, _s14, _r11), _r4), _r4), _multiply(_multiply(8.0, _s4, _r5), _multiply(_s12, _s14, _r13), _r5), _r5)
    _s19 = _s18 + _add(_add(_add(_absolute(turn_rate_1, _r4), _absolute(vx_1, _r13), _r13), _absolute(vy_1, _r4), _r4), _absolute(vz_1, _r13), _r13)
    _s20 = 0.4 * p_gravity
    _s21 = _add(_multiply(_multiply(6.0, _absolute(_add(lift_3, _multiply(_s20, nz_3, _r13), _r13), _r13), _r13), _s8, _r13), _multiply(_multiply(12.0, _absolute(_add(lift_4, _multiply(_s20, nz_4, _r5), _r5), _r5), _r5), _s10, _r5), _r5)
    _s22 = _add(_s21, _multiply(_multiply(20.0, _absolute(_add(lift_5, _multiply(_s20, nz_5, _r13), _r13), _r13), _r13), _s12, _r13), _r13)
    _s23 = _add(_s22, _multiply(_multiply(30.0, _absolute(_add(lift_6, _multiply(_s20, nz_6, _r5), _r5), _r5), _r5), _s14, _r5), _r5)
    _s24 = _add(_s23, _multiply(_multiply(42.0, _absolute(_add(lift_7, _multiply(_s20, nz_7, _r13), _r13), _r13), _r13), _s16, _r13), _r13)
    return _s8, _s19, _multiply(_s19, _s8, _r0) + _s0, lift_0 + _multiply(_s20, nz_0, _r0), lift_1 + _multiply(_s20, nz_1, _r0), _s24 + _multiply(2.0, _absolute(_add(lift_2, _multiply(_s20, nz_2, _r0), _r0), _r0), _r0), -_multiply(0.8, _negative(_multiply(p_gravity, nz_1, _r0), _r0), _r0)


def roll_turn_rate(p_ball_radius: Any, nx: Any, ny: Any, nz: Any, wx: Any, wy: Any, wz: Any) -> tuple[Any, ...]:
    """The spin about the normal, times the ball's radius.

    s = R_B (w·n). 6 operations: 2 additions, 4 multiplications.
    Returns turn_rate.
    """
    return p_ball_radius * (((nx * wx) + (ny * wy)) + (nz * wz)),


def pressed_on(p_ball_radius: Any, p_gravity: Any, nx: Any, ny: Any, nz: Any, rolled_x: Any, rolled_y: Any, rolled_z: Any, turning_x: Any, turning_y: Any, turning_z: Any, wx: Any, wy: Any, wz: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Normal force, its part of the free fall, friction and acceleration of a ball that rolls.

    N = -a·n - v·n', F = beta (-a_t + s n × n'). 54 operations: 13 additions, 5 subtractions, 33 multiplications, 1 square root, 2 negations.
    Returns press, weight, drag, thrust_x, thrust_y, thrust_z.
    """
    _r0, _r1, _r2, _r3, _r4, _r5 = _room[:6]
    _s0 = -_multiply(p_gravity, nz, _r0)
    _s1 = _negative(_s0, _r0) - _add(_add(_multiply(rolled_x, turning_x, _r1), _multiply(rolled_y, turning_y, _r2), _r2), _multiply(rolled_z, turning_z, _r1), _r1)
    _s2 = _add(_add(_multiply(nx, wx, _r1), _multiply(ny, wy, _r0), _r0), _multiply(nz, wz, _r1), _r1)
    _s3 = 0.4 * p_ball_radius
    _s4 = _add(_multiply(_multiply(0.4, ny, _r0), _s0, _r0), _multiply(_multiply(_s3, _subtract(_multiply(nz, turning_x, _r2), _multiply(nx, turning_z, _r3), _r3), _r3), _s2, _r3), _r3)
    _s5 = _add(_multiply(_multiply(0.4, nx, _r0), _s0, _r0), _multiply(_multiply(_s3, _subtract(_multiply(ny, turning_z, _r2), _multiply(nz, turning_y, _r4), _r4), _r4), _s2, _r4), _r4)
    _s6 = _add(_add(0.4 * p_gravity, _multiply(_multiply(0.4, nz, _r0), _s0, _r0), _r0), _multiply(_multiply(_s3, _subtract(_multiply(nx, turning_y, _r2), _multiply(ny, turning_x, _r5), _r5), _r5), _s2, _r5), _r5)
    return _s1, _s0, _sqrt(_add(_add(_multiply(_s4, _s4, _r0), _multiply(_s5, _s5, _r1), _r1), _multiply(_s6, _s6, _r0), _r0)), _multiply(nx, _s1, _r0) + _s5, _multiply(ny, _s1, _r0) + _s4, _add(_multiply(nz, _s1, _r0), _s6, _r0) - p_gravity


def slowed(p_ball_radius: Any, p_gravity: Any, nx: Any, ny: Any, nz: Any, position_error: Any, vx: Any, vy: Any, vz: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Where a ball hardly leaves the surface that it has touched, and is looked at.

    a hop of less than a micrometre. 21 operations: 5 additions, 10 multiplications, 1 division, 3 comparisons, 1 conjunction, 1 disjunction.
    Returns slow, assured.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = _add(_add(_multiply(nx, vx, _r0), _multiply(ny, vy, _r1), _r1), _multiply(nz, vz, _r0), _r0)
    _s1 = _multiply(_s0, _s0, _r0)
    _s2 = _multiply(7.275957614183426e-12 * p_ball_radius, _add(p_gravity, _divide(_add(_add(_multiply(vx, vx, _r1), _multiply(vy, vy, _r2), _r2), _multiply(vz, vz, _r1), _r1), p_ball_radius, _r1), _r1), _r1)
    return _logical_or((_s1 < _s2), _logical_and((_s1 < (1.1920928955078125e-07 * p_ball_radius)), (0.0 < position_error))), 0.0


def unslowed() -> tuple[Any, ...]:
    """A ball that has touched nothing.

    Table 1. No operations.
    Returns slow.
    """
    return False,


def nearly(p_ball_radius: Any, p_gravity: Any, nx: Any, ny: Any, nz: Any, vx: Any, vy: Any, vz: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Where its bounces are so small that this may be the last.

    half a hop's height. 16 operations: 5 additions, 9 multiplications, 1 division, 1 comparison.
    Returns nearly.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = _add(_add(_multiply(nx, vx, _r0), _multiply(ny, vy, _r1), _r1), _multiply(nz, vz, _r0), _r0)
    _s1 = _multiply(7.275957614183426e-12 * p_ball_radius, _add(p_gravity, _divide(_add(_add(_multiply(vx, vx, _r1), _multiply(vy, vy, _r2), _r2), _multiply(vz, vz, _r1), _r1), p_ball_radius, _r1), _r1), _r1)
    return _multiply(_s0, _s0, _r0) < _s1,


def gripped(p_ball_radius: Any, nx: Any, ny: Any, nz: Any, vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The velocity of a ball whose contact point stops; its slip, and how fast it leaves.

    the momenta that a contact keeps. 40 operations: 4 additions, 12 subtractions, 21 multiplications, 1 square root, 1 comparison, 1 selection.
    Returns rolled_x, rolled_y, rolled_z, slip, bounce.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7 = _room[:8]
    _s0 = _add(_add(_multiply(nx, vx, _r0), _multiply(ny, vy, _r1), _r1), _multiply(nz, vz, _r0), _r0)
    _s1 = _subtract(vx, _multiply(nx, _s0, _r1), _r1)
    _s2 = _subtract(_s1, _multiply(p_ball_radius, _subtract(_multiply(nz, wy, _r2), _multiply(ny, wz, _r3), _r3), _r3), _r3)
    _s3 = _subtract(vy, _multiply(ny, _s0, _r2), _r2)
    _s4 = _subtract(_s3, _multiply(p_ball_radius, _subtract(_multiply(nx, wz, _r4), _multiply(nz, wx, _r5), _r5), _r5), _r5)
    _s5 = _subtract(vz, _multiply(nz, _s0, _r4), _r4)
    _s6 = _subtract(_s5, _multiply(p_ball_radius, _subtract(_multiply(ny, wx, _r6), _multiply(nx, wy, _r7), _r7), _r7), _r7)
    return _s1 - _multiply(0.4, _s2, _r6), _s3 - _multiply(0.4, _s4, _r6), _s5 - _multiply(0.4, _s6, _r6), _sqrt(_add(_add(_multiply(_s6, _s6, _r7), _multiply(_s4, _s4, _r5), _r5), _multiply(_s2, _s2, _r3), _r3)), _result(0.0 < _s0, _s0, 0.0, _r0)


def alone() -> tuple[Any, ...]:
    """Nothing next to the ball.

    Table 1. No operations.
    Returns nearest, wedge.
    """
    return _inf, _inf


def neared_body(facing: Any, gap: Any, nearest: Any, nearing: Any, press: Any, swerve: Any, wedge: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """A body next to a ball that rolls on.

    Table 1. 18 operations: 1 addition, 4 multiplications, 1 division, 2 absolute values, 5 comparisons, 1 conjunction, 4 selections.
    Returns nearest, wedge.
    """
    _r0, _r1, _r2, _r3, _r4 = _room[:5]
    _s0 = _absolute(gap, _r0)
    _s1 = _absolute(swerve, _r1)
    _s2 = _multiply(9.5367431640625e-07, press, _r2)
    _s3 = _select(_logical_and((swerve < _multiply(9.094947017729282e-13, press, _r3)), (facing < 0.9999990463256836)), _add(_divide(_multiply(0.5, _multiply(nearing, nearing, _r3), _r3), _select(_s1 < _s2, _s2, _s1, _r4), _r3), _s0, _r3), _inf, _r4)
    return _result(_s0 < nearest, _s0, nearest, _r0), _result(_s3 < wedge, _s3, wedge, _r0)


def neared(gap: Any, nearest: Any) -> tuple[Any, ...]:
    """The distance to what is next to the ball.

    Table 1. 3 operations: 1 absolute value, 1 comparison, 1 selection.
    Returns nearest.
    """
    _s0 = _absolute(gap)
    return _where(_s0 < nearest, _s0, nearest),


def begun_errors(p_ball_radius: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, dx: Any, dy: Any, dz: Any, vx: Any, vy: Any, vz: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """What a jump to the end of the bounces adds.

    its bound. 41 operations: 12 additions, 3 multiplications, 2 divisions, 3 negations, 3 absolute values, 9 comparisons, 9 selections.
    Returns dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz.
    """
    _r0, _r1, _r2, _r3, _r4 = _room[:5]
    _s0 = 3.637978807091713e-12 * p_ball_radius
    _s1 = -_s0
    _s2 = _multiply(1.4551915228366852e-11 * p_ball_radius, _add(1.0, _divide(_add(_add(_absolute(vx, _r0), _absolute(vy, _r1), _r1), _absolute(vz, _r0), _r0), p_ball_radius, _r0), _r0), _r0)
    _s3 = _negative(_s2, _r1)
    _s4 = _divide(_s2, p_ball_radius, _r2)
    _s5 = _negative(_s4, _r3)
    return dx + _select(dx < 0.0, _s1, _s0, _r4), dy + _select(dy < 0.0, _s1, _s0, _r4), dz + _select(dz < 0.0, _s1, _s0, _r4), dvx + _select(dvx < 0.0, _s3, _s2, _r4), dvy + _select(dvy < 0.0, _s3, _s2, _r4), dvz + _select(dvz < 0.0, _s3, _s2, _r4), dwx + _select(dwx < 0.0, _s5, _s4, _r4), dwy + _select(dwy < 0.0, _s5, _s4, _r4), dwz + _select(dwz < 0.0, _s5, _s4, _r4)


def leaving_force(p_ball_radius: Any, brace: Any, doubt: Any, fastest: Any, force: Any, force_bend: Any, force_rate: Any, p_gravity: Any, per_reach: Any, position_error: Any, stride: Any, velocity_error: Any, vx: Any, vx_1: Any, vy: Any, vy_1: Any, vz: Any, vz_1: Any, which: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Where the normal force is spent, or nothing moves; else how long it certainly lasts.

    N = 0. 85 operations: 12 additions, 1 subtraction, 20 multiplications, 2 divisions, 2 square roots, 2 negations, 8 absolute values, 14 comparisons, 7 conjunctions, 3 disjunctions, 3 complements, 11 selections.
    Returns stride, which, rests, doubt.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10 = _room[:11]
    _s0 = _absolute(per_reach, _r0)
    _s1 = _add(p_gravity, _multiply(_multiply(fastest, fastest, _r1), _s0, _r1), _r1)
    _s2 = _multiply(5.684341886080802e-14, _s1, _r2)
    _s3 = force_rate < 0.0
    _s4 = _logical_or((force < _negative(_s2, _r3)), _logical_and((force <= _s2), _s3))
    _s5 = _negative(_add(brace, force_rate, _r3), _r3)
    _s6 = _add(force, _select(_s5 < 0.0, _divide(_multiply(_s5, _s5, _r3), _multiply(p_gravity, _multiply(_s0, _s1, _r4), _r4), _r3), 0.0, _r4), _r4)
    _s7 = _logical_and(_s4, (_s2 < _s6))
    _s8 = _logical_and(_s4, _logical_not(_s7))
    _s9 = _logical_and((_add(_add(_absolute(vx, _r3), _absolute(vy, _r5), _r5), _absolute(vz, _r3), _r3) <= (5.684341886080802e-14 * _sqrt((p_ball_radius * p_gravity)))), (_add(_add(_absolute(vx_1, _r3), _absolute(vy_1, _r5), _r5), _absolute(vz_1, _r3), _r3) <= (5.684341886080802e-14 * p_gravity)))
    _s10 = _multiply(force_rate, force_rate, _r3)
    _s11 = _add(force_bend, _multiply(9.094947017729282e-13, _s1, _r5), _r5)
    _s12 = _select(_s7, _s6, _select(force < 0.0, 0.0, force, _r6), _r7)
    _s13 = _add(_s10, _multiply(_multiply(2.0, _s11, _r8), _s12, _r8), _r8)
    _s14 = _sqrt(_s13, _r9)
    _s15 = _select(0.0 <= _s13, _divide(_select(_s3, _multiply(2.0, _s12, _r7), _add(force_rate, _s14, _r6), _r4), _select(_s3, _subtract(_s14, force_rate, _r9), _select(0.0 < _s11, _s11, 0.0, _r8), _r10), _r4), _inf, _r6)
    _s16 = _add(_multiply(_multiply(8.0, _s0, _r0), _add(_multiply(fastest, velocity_error, _r7), _multiply(position_error, _s1, _r1), _r1), _r0), _s2, _r0)
    _s17 = _logical_or(_s7, _logical_and((_absolute(force, _r2) <= _s16), _logical_not((_multiply(_multiply(8.0, _s11, _r5), _s16, _r5) < _s10))))
    return _result(_logical_or(_s8, _s9), 0.0, _select(_s15 < stride, _s15, stride, _r5), _r0), _result(_logical_and(_s8, (which == -1.0)), 6.0, which, _r0), _logical_and(_s9, _logical_not(_s8)), _result(_s17, 0.0, doubt, _r0)


def beside_body(p_ball_radius: Any, dent: Any, doubt: Any, fastest: Any, gap: Any, index: Any, late: Any, nearing: Any, position_error: Any, stride: Any, strongest: Any, which: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Where a rolling ball meets another surface; else how long it certainly does not.

    a parabola below the distance. 55 operations: 7 additions, 1 subtraction, 12 multiplications, 2 divisions, 1 square root, 1 negation, 4 absolute values, 9 comparisons, 5 conjunctions, 1 disjunction, 2 complements, 10 selections.
    Returns stride, which, doubt, late.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8 = _room[:9]
    _s0 = _multiply(7.105427357601002e-15, _add(_add(_add(p_ball_radius, _absolute(x, _r0), _r0), _absolute(y, _r1), _r1), _absolute(z, _r0), _r0), _r0)
    _s1 = gap <= _s0
    _s2 = nearing < 0.0
    _s3 = _logical_and(_s1, _s2)
    _s4 = _multiply(nearing, nearing, _r1)
    _s5 = _add(strongest, _multiply(dent, _multiply(fastest, fastest, _r2), _r2), _r2)
    _s6 = _select(_s1, 3.637978807091713e-12 * p_ball_radius, gap, _r3)
    _s7 = _add(_s4, _multiply(_multiply(2.0, _s5, _r4), _s6, _r4), _r4)
    _s8 = _sqrt(_s7, _r5)
    _s9 = _select(0.0 <= _s7, _divide(_select(_s2, _multiply(2.0, _s6, _r3), _add(nearing, _s8, _r4), _r6), _select(_s2, _subtract(_s8, nearing, _r5), _select(0.0 < _s5, _s5, 0.0, _r7), _r8), _r6), _inf, _r4)
    _s10 = which == -1.0
    _s11 = _logical_and(_s3, _s10)
    _s12 = _add(_multiply(2.0, position_error, _r3), _s0, _r3)
    _s13 = _logical_or(_logical_and(_logical_and((gap <= _s12), (_negative(_s12, _r0) <= gap)), _logical_not((_multiply(_multiply(8.0, _s12, _r0), _s5, _r0) < _s4))), _logical_and(_s3, _logical_not(_s10)))
    return _result(_s3, 0.0, _select(_s9 < stride, _s9, stride, _r0), _r0), _result(_s11, index, which, _r0), _result(_s13, 0.0, doubt, _r0), _result(_s11, _divide(_multiply(2.0, _s12, _r3), _absolute(nearing, _r0), _r3), late, _r0)


def beside_gate(p_ball_radius: Any, dent: Any, doubt: Any, fastest: Any, gap: Any, index: Any, late: Any, nearing: Any, position_error: Any, stride: Any, strongest: Any, which: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The same of a plane that ends a shot, which counts from above.

    a parabola below the distance. 60 operations: 7 additions, 1 subtraction, 11 multiplications, 2 divisions, 1 square root, 2 negations, 4 absolute values, 12 comparisons, 6 conjunctions, 1 disjunction, 2 complements, 11 selections.
    Returns stride, which, doubt, late.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8 = _room[:9]
    _s0 = _multiply(7.105427357601002e-15, _add(_add(_add(p_ball_radius, _absolute(x, _r0), _r0), _absolute(y, _r1), _r1), _absolute(z, _r0), _r0), _r0)
    _s1 = nearing < 0.0
    _s2 = _logical_and(_logical_and((gap <= _s0), _s1), (_negative(_s0, _r1) <= gap))
    _s3 = _multiply(nearing, nearing, _r1)
    _s4 = _add(strongest, _multiply(dent, _multiply(fastest, fastest, _r2), _r2), _r2)
    _s5 = _select(gap < 0.0, 0.0, gap, _r3)
    _s6 = _add(_s3, _multiply(_multiply(2.0, _s4, _r4), _s5, _r4), _r4)
    _s7 = _sqrt(_s6, _r5)
    _s8 = _select(0.0 < gap, _select(0.0 <= _s6, _divide(_select(_s1, _multiply(2.0, _s5, _r3), _add(nearing, _s7, _r4), _r6), _select(_s1, _subtract(_s7, nearing, _r5), _select(0.0 < _s4, _s4, 0.0, _r7), _r8), _r6), _inf, _r4), _inf, _r3)
    _s9 = which == -1.0
    _s10 = _logical_and(_s2, _s9)
    _s11 = _add(_multiply(2.0, position_error, _r8), _s0, _r8)
    _s12 = _logical_or(_logical_and(_logical_and((gap <= _s11), (_negative(_s11, _r0) <= gap)), _logical_not((_multiply(_multiply(8.0, _s11, _r0), _s4, _r0) < _s3))), _logical_and(_s2, _logical_not(_s9)))
    return _result(_s2, 0.0, _select(_s8 < stride, _s8, stride, _r0), _r0), _result(_s10, index, which, _r0), _result(_s12, 0.0, doubt, _r0), _result(_s10, _divide(_multiply(2.0, _s11, _r8), _absolute(nearing, _r0), _r8), late, _r0)


def beside_seam(fastest: Any, gap: Any, near: Any, nearing: Any, stride: Any, strongest: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """How long a rolling ball certainly stays on a part of its surface.

    a parabola below the distance. 28 operations: 3 additions, 1 subtraction, 5 multiplications, 1 division, 1 square root, 1 negation, 2 absolute values, 6 comparisons, 8 selections.
    Returns stride.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7 = _room[:8]
    _s0 = _absolute(gap, _r0)
    _s1 = _s0 <= near
    _s2 = _select(_s1, 0.0, _s0, _r1)
    _s3 = _select(_s1, _add(_multiply(9.5367431640625e-07, fastest, _r2), _absolute(nearing, _r3), _r3), _select(0.0 < gap, nearing, _negative(nearing, _r2), _r4), _r5)
    _s4 = _add(_multiply(_multiply(2.0, strongest, _r6), _s2, _r6), _multiply(_s3, _s3, _r7), _r7)
    _s5 = _sqrt(_s4, _r6)
    _s6 = _s3 < 0.0
    _s7 = _select(0.0 <= _s4, _divide(_select(_s6, _multiply(2.0, _s2, _r1), _add(_s3, _s5, _r0), _r7), _select(_s6, _subtract(_s5, _s3, _r6), _select(0.0 < strongest, strongest, 0.0, _r5), _r4), _r7), _inf, _r0)
    return _result(_s7 < stride, _s7, stride, _r0),


def beside_time(clock: Any, stride: Any, time_limit: Any, which: Any) -> tuple[Any, ...]:
    """The time limit.

    Table 1. 10 operations: 1 subtraction, 4 comparisons, 1 conjunction, 1 complement, 3 selections.
    Returns stride, which.
    """
    _s0 = time_limit - clock
    _s1 = _where(_s0 < stride, _s0, stride)
    return _where(0.0 < _s1, _s1, 0.0), _where(_logical_and(_logical_not((clock < time_limit)), (which == -1.0)), 4.0, which)


def rolled_on(clock: Any, rests: Any, stride: Any, which: Any) -> tuple[Any, ...]:
    """The time after a step, and whether there is a next one.

    Table 1. 4 operations: 1 addition, 1 comparison, 1 conjunction, 1 complement.
    Returns clock, rolling.
    """
    return clock + stride, _logical_and((which == -1.0), _logical_not(rests))


def unmet() -> tuple[Any, ...]:
    """Nothing next to the ball.

    Table 1. No operations.
    Returns spare.
    """
    return _inf,


def spared(dent: Any, gap: Any, p_gravity: Any, nearing: Any, spare: Any, vx: Any, vy: Any, vz: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """What it meets first.

    a parabola below the distance. 30 operations: 6 additions, 1 subtraction, 7 multiplications, 1 division, 1 square root, 3 absolute values, 5 comparisons, 6 selections.
    Returns spare.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6 = _room[:7]
    _s0 = _add(_add(_add(0.0078125 * p_gravity, _absolute(vx, _r0), _r0), _absolute(vy, _r1), _r1), _absolute(vz, _r0), _r0)
    _s1 = _add(p_gravity, _multiply(dent, _multiply(_s0, _s0, _r0), _r0), _r0)
    _s2 = _select(gap < 0.0, 0.0, gap, _r1)
    _s3 = _add(_multiply(nearing, nearing, _r2), _multiply(_multiply(2.0, _s1, _r3), _s2, _r3), _r3)
    _s4 = _sqrt(_s3, _r2)
    _s5 = nearing < 0.0
    _s6 = _select(0.0 <= _s3, _divide(_select(_s5, _multiply(2.0, _s2, _r1), _add(nearing, _s4, _r3), _r4), _select(_s5, _subtract(_s4, nearing, _r2), _select(0.0 < _s1, _s1, 0.0, _r5), _r6), _r4), _inf, _r3)
    return _result(_s6 < spare, _s6, spare, _r0),


def spared_seam(gap: Any, p_gravity: Any, near: Any, nearing: Any, spare: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """How long it stays off one part of the surface: there the distance bends anew.

    a parabola below the distance. 24 operations: 2 additions, 1 subtraction, 4 multiplications, 1 division, 1 square root, 1 negation, 1 absolute value, 6 comparisons, 7 selections.
    Returns spare.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6 = _room[:7]
    _s0 = _absolute(gap, _r0)
    _s1 = _select(0.0 < gap, nearing, _negative(nearing, _r1), _r2)
    _s2 = _add(_multiply(2.0 * p_gravity, _s0, _r3), _multiply(_s1, _s1, _r4), _r4)
    _s3 = _sqrt(_s2, _r3)
    _s4 = _s1 < 0.0
    _s5 = _select(0.0 <= _s2, _divide(_select(_s4, _multiply(2.0, _s0, _r4), _add(_s1, _s3, _r5), _r6), _select(_s4, _subtract(_s3, _s1, _r3), _where(0.0 < p_gravity, p_gravity, 0.0), _r2), _r6), _inf, _r5)
    return _result(_s0 <= near, spare, _select(_s5 < spare, _s5, spare, _r0), _r0),


def parted(doubt: Any, p_gravity: Any, lift: Any, per_reach: Any, position_error: Any, snap: Any, spare: Any, surge: Any, velocity_error: Any, vx: Any, vy: Any, vz: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """How long a ball that leaves a surface certainly does not meet it, nor anything else.

    Taylor's theorem of the gap. 66 operations: 10 additions, 21 multiplications, 5 divisions, 4 square roots, 6 absolute values, 10 comparisons, 1 disjunction, 9 selections.
    Returns when, doubt.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15 = _room[:16]
    _s0 = _multiply(0.25, spare, _r0)
    _s1 = _add(_add(_add(0.0078125 * p_gravity, _absolute(vx, _r1), _r1), _absolute(vy, _r2), _r2), _absolute(vz, _r1), _r1)
    _s2 = _absolute(per_reach, _r2)
    _s3 = _add(p_gravity, _multiply(_multiply(_s1, _s1, _r3), _s2, _r3), _r3)
    _s4 = _add(_add(1.0, _multiply(_s1, _s2, _r4), _r4), _sqrt(_multiply(p_gravity, _s2, _r5), _r5), _r5)
    _s5 = _multiply(_multiply(64.0, _s3, _r4), _multiply(_s4, _multiply(_s4, _s4, _r6), _r6), _r4)
    _s6 = _multiply(0.5, surge, _r6)
    _s7 = _sqrt(_divide(_s6, _s5, _r7), _r7)
    _s8 = _multiply(9.313225746154785e-10, _s5, _r8)
    _s9 = _add(_absolute(snap, _r9), _s8, _r9)
    _s10 = _divide(_s6, _s9, _r6)
    _s11 = _select(0.0 < lift, lift, 0.0, _r10)
    _s12 = _sqrt(_divide(_multiply(128.0, _s11, _r11), _s5, _r11), _r11)
    _s13 = _sqrt(_divide(_multiply(0.5, _s11, _r4), _s9, _r4), _r4)
    _s14 = _divide(_s11, _add(_multiply(4.0, _absolute(surge, _r9), _r9), _s8, _r9), _r9)
    _s15 = _select(_s13 < _s14, _s13, _s14, _r10)
    _s16 = _select(0.0 < surge, _select(_s7 < _s10, _s7, _s10, _r8), _select(_s12 < _s15, _s12, _s15, _r12), _r13)
    _s17 = _select(_s16 < 0.0078125, _s16, 0.0078125, _r14)
    _s18 = _select(_s0 < _s17, _s0, _s17, _r15)
    _s19 = _add(5.684341886080802e-14 * p_gravity, _multiply(_multiply(16.0, _add(_multiply(position_error, _s3, _r3), _multiply(velocity_error, _s1, _r1), _r1), _r1), _s2, _r1), _r1)
    return _result(0.0 < _s18, _s18, 0.0, _r0), _result(_logical_or((_multiply(_s19, _s4, _r5) < surge), (_s19 < lift)), doubt, 0.0, _r0)


def apart(p_ball_radius: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, dx: Any, dy: Any, dz: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """How often an error makes a neighbouring motion.

    FAR. 29 operations: 3 additions, 4 multiplications, 1 division, 9 absolute values, 6 comparisons, 6 selections.
    Returns apart.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12 = _room[:13]
    _s0 = _absolute(dwx, _r0)
    _s1 = _absolute(dwy, _r1)
    _s2 = _select(_s0 < _s1, _s1, _s0, _r2)
    _s3 = _absolute(dwz, _r3)
    _s4 = _absolute(dvx, _r4)
    _s5 = _absolute(dvy, _r5)
    _s6 = _select(_s4 < _s5, _s5, _s4, _r6)
    _s7 = _absolute(dvz, _r7)
    _s8 = _absolute(dx, _r8)
    _s9 = _absolute(dy, _r9)
    _s10 = _select(_s8 < _s9, _s9, _s8, _r10)
    _s11 = _absolute(dz, _r11)
    _s12 = _add(_add(1.1102230246251565e-16 * p_ball_radius, _multiply(0.125, _add(_multiply(p_ball_radius, _select(_s2 < _s3, _s3, _s2, _r12), _r12), _select(_s6 < _s7, _s7, _s6, _r3), _r3), _r3), _r3), _select(_s10 < _s11, _s11, _s10, _r7), _r7)
    return (2.384185791015625e-07 * p_ball_radius) / _s12,


def neighbour(apart: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, dx: Any, dy: Any, dz: Any, vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """A neighbouring motion, along the errors.

    Table 1. 18 operations: 9 additions, 9 multiplications.
    Returns far_x, far_y, far_z, far_vx, far_vy, far_vz, far_wx, far_wy, far_wz, far_nx, far_ny, far_nz, far_gap.
    """
    _r0, = _room[:1]
    return x + _multiply(apart, dx, _r0), y + _multiply(apart, dy, _r0), z + _multiply(apart, dz, _r0), vx + _multiply(apart, dvx, _r0), vy + _multiply(apart, dvy, _r0), vz + _multiply(apart, dvz, _r0), wx + _multiply(apart, dwx, _r0), wy + _multiply(apart, dwy, _r0), wz + _multiply(apart, dwz, _r0), 0.0, 0.0, 0.0, 0.0


def compared(apart: Any, p_ball_radius: Any, far_vx: Any, far_vy: Any, far_vz: Any, far_wx: Any, far_wy: Any, far_wz: Any, far_x: Any, far_y: Any, far_z: Any, vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The errors after a step, with its roundings.

    differences. 69 operations: 17 additions, 9 subtractions, 3 multiplications, 10 divisions, 3 negations, 9 absolute values, 9 comparisons, 9 selections.
    Returns dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15 = _room[:16]
    _s0 = _divide(_subtract(far_x, x, _r0), apart, _r0)
    _s1 = _multiply(4.440892098500626e-16, _add(_add(_add(p_ball_radius, _absolute(x, _r1), _r1), _absolute(y, _r2), _r2), _absolute(z, _r1), _r1), _r1)
    _s2 = _negative(_s1, _r2)
    _s3 = _divide(_subtract(far_y, y, _r3), apart, _r3)
    _s4 = _divide(_subtract(far_z, z, _r4), apart, _r4)
    _s5 = _divide(_subtract(far_vx, vx, _r5), apart, _r5)
    _s6 = _add(_add(_multiply(p_ball_radius, _add(_add(_absolute(wx, _r6), _absolute(wy, _r7), _r7), _absolute(wz, _r6), _r6), _r6), _absolute(vx, _r7), _r7), _absolute(vy, _r6), _r6)
    _s7 = _multiply(4.440892098500626e-16, _add(_s6, _absolute(vz, _r7), _r7), _r7)
    _s8 = _negative(_s7, _r6)
    _s9 = _divide(_subtract(far_vy, vy, _r8), apart, _r8)
    _s10 = _divide(_subtract(far_vz, vz, _r9), apart, _r9)
    _s11 = _divide(_subtract(far_wx, wx, _r10), apart, _r10)
    _s12 = _divide(_s7, p_ball_radius, _r11)
    _s13 = _negative(_s12, _r12)
    _s14 = _divide(_subtract(far_wy, wy, _r13), apart, _r13)
    _s15 = _divide(_subtract(far_wz, wz, _r14), apart, _r14)
    return _s0 + _select(_s0 < 0.0, _s2, _s1, _r15), _s3 + _select(_s3 < 0.0, _s2, _s1, _r15), _s4 + _select(_s4 < 0.0, _s2, _s1, _r15), _s5 + _select(_s5 < 0.0, _s8, _s7, _r15), _s9 + _select(_s9 < 0.0, _s8, _s7, _r15), _s10 + _select(_s10 < 0.0, _s8, _s7, _r15), _s11 + _select(_s11 < 0.0, _s13, _s12, _r15), _s14 + _select(_s14 < 0.0, _s13, _s12, _r15), _s15 + _select(_s15 < 0.0, _s13, _s12, _r15)


def carry_hop(dvx: Any, dvy: Any, dvz: Any, dx: Any, dy: Any, dz: Any, vx: Any, vy: Any, vz: Any, when: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Errors after a while of flight.

    derivative of Eq. 3. 34 operations: 9 additions, 10 multiplications, 3 negations, 6 absolute values, 3 comparisons, 3 selections.
    Returns dx, dy, dz.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7 = _room[:8]
    _s0 = _add(dx, _multiply(dvx, when, _r0), _r0)
    _s1 = _multiply(2.0, when, _r1)
    _s2 = _multiply(1.1102230246251565e-16, _add(_multiply(_s1, _absolute(vx, _r2), _r2), _absolute(x, _r3), _r3), _r3)
    _s3 = _add(dy, _multiply(dvy, when, _r2), _r2)
    _s4 = _multiply(1.1102230246251565e-16, _add(_multiply(_s1, _absolute(vy, _r4), _r4), _absolute(y, _r5), _r5), _r5)
    _s5 = _add(dz, _multiply(dvz, when, _r4), _r4)
    _s6 = _multiply(1.1102230246251565e-16, _add(_multiply(_s1, _absolute(vz, _r6), _r6), _absolute(z, _r1), _r1), _r1)
    return _s0 + _select(_s0 < 0.0, _negative(_s2, _r6), _s2, _r7), _s3 + _select(_s3 < 0.0, _negative(_s4, _r7), _s4, _r6), _s5 + _select(_s5 < 0.0, _negative(_s6, _r6), _s6, _r7)


def kept(mode: Any, when: Any) -> tuple[Any, ...]:
    """Where a ball is in contact: no flight to search.

    Table 1. 2 operations: 1 comparison, 1 selection.
    Returns kept, when, rests, rolling, began.
    """
    _s0 = 0.0 < mode
    return _s0, _where(_s0, 0.0, when), False, False, 0.0


def opens_in_flight(clear: Any, kept: Any) -> tuple[Any, ...]:
    """Where a surface is not certainly missed by a ball in flight.

    Table 1. 4 operations: 1 comparison, 1 conjunction, 2 complements.
    Returns open.
    """
    return _logical_and(_logical_not((0.0 < clear)), _logical_not(kept)),


def reachable_in_flight(kept: Any, reachable: Any) -> tuple[Any, ...]:
    """Where a ball in flight may reach a surface.

    Table 1. 2 operations: 1 conjunction, 1 complement.
    Returns reachable.
    """
    return _logical_and(reachable, _logical_not(kept)),


def resumed(clock: Any, mode: Any, position_error: Any, velocity_error: Any) -> tuple[Any, ...]:
    """No event yet, of a ball in contact.

    Table 1. 7 operations: 5 comparisons, 1 conjunction, 1 selection.
    Returns which, late, began, doubt, begins, rolling, leaves, nx, ny, nz, gap, bent_x, bent_y, bent_z, lift, surge, snap, per_reach.
    """
    return -1.0, 0.0, clock, _where(_logical_and((position_error < _inf), (velocity_error < _inf)), _inf, 0.0), mode == 1.0, mode == 2.0, mode == 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0


def doubted_in_contact(assured: Any, doubt: Any, edge: Any, last: Any, late: Any, uncertain: Any, when: Any, which: Any) -> tuple[Any, ...]:
    """1 where a decision lies within its error; that a ball bounces on is none.

    Table 1. 12 operations: 1 addition, 4 comparisons, 3 conjunctions, 1 disjunction, 2 complements, 1 selection.
    Returns uncertain.
    """
    _s0 = _logical_and(_logical_or(_logical_and(_logical_not(((late + when) < doubt)), (doubt < _inf)), edge), _logical_not(_logical_and((0.0 < assured), (which == last))))
    return _where(_s0, 1.0, uncertain),


def holding(held: Any, index: Any) -> tuple[Any, ...]:
    """Whether it stays on this.

    Table 1. 1 operation: 1 comparison.
    Returns here.
    """
    return held == index,


def beside(held: Any, index: Any) -> tuple[Any, ...]:
    """Whether it does not.

    Table 1. 2 operations: 1 comparison, 1 complement.
    Returns beside.
    """
    return _logical_not((held == index)),


def unhopped() -> tuple[Any, ...]:
    """A ball in flight.

    Table 1. No operations.
    Returns hopped.
    """
    return False,


def beginning_contact() -> tuple[Any, ...]:
    """The contact begins.

    Table 1. No operations.
    Returns which, circled.
    """
    return 5.0, 0.0


def hopping() -> tuple[Any, ...]:
    """The ball is off.

    Table 1. No operations.
    Returns which.
    """
    return 7.0,


def kept_on(began: Any, body: Any, clock: Any, doubt: Any, ends: Any, held: Any, last: Any, reached: Any, rests: Any, rolling: Any, rolls: Any, which: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """What comes of a ball in contact.

    Table 1. 38 operations: 3 additions, 1 subtraction, 1 multiplication, 9 comparisons, 2 conjunctions, 4 disjunctions, 1 complement, 17 selections.
    Returns body, reached, doubt, ends, hopped, last, mode, held, rolls.
    """
    _r0, _r1, _r2, _r3, _r4 = _room[:5]
    _s0 = which == 5.0
    _s1 = _multiply(2.0, _select(held == 2.0, 2.0, _select(held == 1.0, 1.0, _select(held == 0.0, 0.0, -1.0, _r0), _r1), _r2), _r2)
    _s2 = which == 6.0
    _s3 = which == 7.0
    _s4 = which == 8.0
    _s5 = _logical_and(rolling, (_subtract(clock, began, _r1) <= 5.960464477539063e-08))
    _s6 = 4.0 < which
    return _result(_s0, _add(4.0, _s1, _r1), _select(_s2, _add(5.0, _s1, _r2), _select(_s3, -1.0, _select(_s4, 3.0, body, _r0), _r3), _r4), _r0), _result(_s5, 2.0, _select(_s4, 6.0, _select(rests, 5.0, _select(_logical_or(_s6, rolling), -1.0, reached, _r4), _r3), _r0), _r0), _result(_s5, 0.0, doubt, _r0), _logical_and(ends, _logical_not(_s6)), _s3, _result(_s3, -1.0, last, _r0), _result(_logical_or(_s0, rolling), 2.0, _select(_s2, 3.0, 0.0, _r0), _r0), _result(_logical_or(_logical_or(_s0, _s2), rolling), held, -1.0, _r0), _result(_s0, _add(1.0, rolls, _r0), rolls, _r0)


def settled(index: Any, lodges: Any, nearly: Any, outcome: Any, parts: Any, settles: Any, slides: Any, uncertain: Any, unsure: Any) -> tuple[Any, ...]:
    """Whether the ball stays on a surface, slides, leaves, or is wedged between two.

    Table 1. 16 operations: 1 comparison, 4 conjunctions, 3 disjunctions, 8 selections.
    Returns mode, held, outcome, slip_left, uncertain.
    """
    return _where(nearly, _where(settles, 1.0, _where(parts, 3.0, 0.0)), 0.0), _where(_logical_and(nearly, _logical_or(settles, parts)), index, -1.0), _where(_logical_and(_logical_and(nearly, _logical_or(lodges, slides)), (outcome < 0.0)), _where(lodges, 5.0, 2.0), outcome), _where(_logical_and(nearly, slides), 1.0, 0.0), _where(_logical_or(lodges, unsure), 1.0, uncertain)


def pulled(p_gravity: Any, nx_0: Any, nx_1: Any, ny_0: Any, ny_1: Any, nz_0: Any, nz_1: Any, turn_rate_0: Any, turn_rate_1: Any, tx_0: Any, tx_1: Any, ty_0: Any, ty_1: Any, tz_0: Any, tz_1: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The square of the friction that rolling takes, per unit mass, and its rate.

    F = beta (-a_t + s n × n'). 57 operations: 17 additions, 38 multiplications, 2 negations.
    Returns drag, drag_rate, strain, strain_rate.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11 = _room[:12]
    _s0 = _negative(_multiply(p_gravity, nz_0, _r0), _r0)
    _s1 = _multiply(0.4, nx_0, _r1)
    _s2 = _multiply(0.4, turn_rate_0, _r2)
    _s3 = _add(_multiply(_s1, _s0, _r3), _multiply(_s2, tx_0, _r4), _r4)
    _s4 = _multiply(0.4, ny_0, _r3)
    _s5 = _add(_multiply(_s4, _s0, _r5), _multiply(_s2, ty_0, _r6), _r6)
    _s6 = _multiply(0.4, nz_0, _r5)
    _s7 = _add(_add(0.4 * p_gravity, _multiply(_s6, _s0, _r7), _r7), _multiply(_s2, tz_0, _r8), _r8)
    _s8 = _negative(_multiply(p_gravity, nz_1, _r7), _r7)
    _s9 = _multiply(0.4, turn_rate_1, _r9)
    _s10 = _multiply(_multiply(2.0, _s3, _r10), _add(_add(_add(_multiply(_s1, _s8, _r1), _multiply(_multiply(0.4, nx_1, _r11), _s0, _r11), _r11), _multiply(_s2, tx_1, _r1), _r1), _multiply(_s9, tx_0, _r11), _r11), _r10)
    _s11 = _multiply(_multiply(2.0, _s5, _r11), _add(_add(_add(_multiply(_s4, _s8, _r3), _multiply(_multiply(0.4, ny_1, _r1), _s0, _r1), _r1), _multiply(_s2, ty_1, _r3), _r3), _multiply(_s9, ty_0, _r1), _r1), _r11)
    _s12 = _multiply(_multiply(2.0, _s7, _r1), _add(_add(_add(_multiply(_s6, _s8, _r7), _multiply(_multiply(0.4, nz_1, _r5), _s0, _r5), _r5), _multiply(_s2, tz_1, _r2), _r2), _multiply(_s9, tz_0, _r9), _r9), _r1)
    return _add(_multiply(_s3, _s3, _r4), _multiply(_s5, _s5, _r6), _r6) + _multiply(_s7, _s7, _r8), _add(_s10, _s11, _r11) + _s12, -_inf, 0.0


def untaut() -> tuple[Any, ...]:
    """A contact begins, of which nothing is known yet.

    Table 1. No operations.
    Returns taut.
    """
    return _inf,


def losing(grip_lost: Any, strain: Any) -> tuple[Any, ...]:
    """Whether grip would not last any more.

    F² > mu² N². 3 operations: 2 comparisons, 1 conjunction.
    Returns loses.
    """
    return _logical_and((0.0 < strain), (grip_lost == _inf)),


def lost_grip(clock: Any, strain: Any, strain_rate: Any, taut: Any, taut_clock: Any, taut_rate: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """When friction began to be asked for more than there is.

    a cubic between the ends of a step. 97 operations: 22 additions, 9 subtractions, 28 multiplications, 5 divisions, 1 negation, 16 comparisons, 1 conjunction, 15 selections.
    Returns grip_lost.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12 = _room[:13]
    _s0 = _subtract(clock, taut_clock, _r0)
    _s1 = _subtract(strain, taut, _r1)
    _s2 = _negative(_divide(taut, _s1, _r2), _r2)
    _s3 = _select(_s2 < 1.0, _s2, 1.0, _r3)
    _s4 = _select(0.0 < _s3, _s3, 0.0, _r4)
    _s5 = _multiply(strain_rate, _s0, _r5)
    _s6 = _multiply(taut_rate, _s0, _r6)
    _s7 = _subtract(_add(_s5, _s6, _r7), _multiply(2.0, _s1, _r8), _r8)
    _s8 = _multiply(3.0, _s7, _r7)
    _s9 = _subtract(_subtract(_multiply(3.0, _s1, _r9), _s5, _r9), _multiply(2.0, _s6, _r5), _r5)
    _s10 = _multiply(2.0, _s9, _r9)
    _s11 = _add(_multiply(_add(_multiply(_s8, _s4, _r10), _s10, _r10), _s4, _r10), _s6, _r10)
    _s12 = _add(taut, _multiply(_add(_multiply(_add(_multiply(_s7, _s4, _r11), _s9, _r11), _s4, _r11), _s6, _r11), _s4, _r11), _r11)
    _s13 = _subtract(_s4, _divide(_s12, _select(0.0 < _s11, _s11, _s1, _r12), _r11), _r11)
    _s14 = _select(_s13 < 1.0, _s13, 1.0, _r4)
    _s15 = _select(0.0 < _s14, _s14, 0.0, _r3)
    _s16 = _add(_multiply(_add(_multiply(_s8, _s15, _r2), _s10, _r2), _s15, _r2), _s6, _r2)
    _s17 = _add(taut, _multiply(_add(_multiply(_add(_multiply(_s7, _s15, _r12), _s9, _r12), _s15, _r12), _s6, _r12), _s15, _r12), _r12)
    _s18 = _subtract(_s15, _divide(_s17, _select(0.0 < _s16, _s16, _s1, _r10), _r12), _r12)
    _s19 = _select(_s18 < 1.0, _s18, 1.0, _r3)
    _s20 = _select(0.0 < _s19, _s19, 0.0, _r4)
    _s21 = _add(_multiply(_add(_multiply(_s8, _s20, _r11), _s10, _r11), _s20, _r11), _s6, _r11)
    _s22 = _add(taut, _multiply(_add(_multiply(_add(_multiply(_s7, _s20, _r10), _s9, _r10), _s20, _r10), _s6, _r10), _s20, _r10), _r10)
    _s23 = _subtract(_s20, _divide(_s22, _select(0.0 < _s21, _s21, _s1, _r2), _r10), _r10)
    _s24 = _select(_s23 < 1.0, _s23, 1.0, _r4)
    _s25 = _select(0.0 < _s24, _s24, 0.0, _r3)
    _s26 = _add(_multiply(_add(_multiply(_s8, _s25, _r7), _s10, _r7), _s25, _r7), _s6, _r7)
    _s27 = _add(taut, _multiply(_add(_multiply(_add(_multiply(_s7, _s25, _r8), _s9, _r8), _s25, _r8), _s6, _r8), _s25, _r8), _r8)
    _s28 = _subtract(_s25, _divide(_s27, _select(0.0 < _s26, _s26, _s1, _r6), _r8), _r8)
    _s29 = _select(_s28 < 1.0, _s28, 1.0, _r3)
    return _result(_logical_and((taut < _inf), (taut < strain)), _add(taut_clock, _multiply(_s0, _select(0.0 < _s29, _s29, 0.0, _r4), _r4), _r4), clock, _r0),


def tightened(clock: Any, strain: Any, strain_rate: Any) -> tuple[Any, ...]:
    """What the next end of a step is seen beside.

    Table 1. No operations.
    Returns taut, taut_rate, taut_clock.
    """
    return strain, strain_rate, clock


def ring_impact_taken(p_ring_restitution: Any, p_ring_friction: Any) -> tuple[Any, ...]:
    """What the law of one body has for its own.

    data. 1 operation: 1 complement.
    Returns mine, its_0, its_1.
    """
    return _logical_not(False), p_ring_restitution, p_ring_friction


def ring_impact_doubt(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, turn: Any, p_ball_radius: Any, p_ring_restitution: Any, p_ring_friction: Any, p_tangential_restitution: Any, p_restitution_speed: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Where a decision within a contact lies within its error.

    the law's own slack. 86 operations: 15 additions, 11 subtractions, 29 multiplications, 2 divisions, 1 square root, 1 negation, 13 absolute values, 7 comparisons, 2 conjunctions, 1 complement, 4 selections.
    Returns unsure.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9 = _room[:10]
    _s0 = 0.4 + (0.4 * p_tangential_restitution)
    _s1 = _absolute(dwx, _r0)
    _s2 = _absolute(dwy, _r1)
    _s3 = _select(_s1 < _s2, _s2, _s1, _r2)
    _s4 = _absolute(dwz, _r3)
    _s5 = _add(_add(_multiply(p_ball_radius, _add(_add(_absolute(wx, _r4), _absolute(wy, _r5), _r5), _absolute(wz, _r4), _r4), _r4), _absolute(vx, _r5), _r5), _absolute(vy, _r4), _r4)
    _s6 = _add(_s5, _absolute(vz, _r5), _r5)
    _s7 = _absolute(dvx, _r4)
    _s8 = _absolute(dvy, _r6)
    _s9 = _select(_s7 < _s8, _s8, _s7, _r7)
    _s10 = _absolute(dvz, _r8)
    _s11 = _multiply(64.0, _add(_add(_add(_multiply(p_ball_radius, _select(_s3 < _s4, _s4, _s3, _r9), _r9), _multiply(turn, _s6, _r3), _r3), _select(_s9 < _s10, _s10, _s9, _r9), _r9), _multiply(4.440892098500626e-16, _s6, _r5), _r5), _r5)
    _s12 = _add(_add(_multiply(nx, vx, _r9), _multiply(ny, vy, _r8), _r8), _multiply(nz, vz, _r9), _r9)
    _s13 = _subtract(_subtract(vz, _multiply(nz, _s12, _r8), _r8), _multiply(p_ball_radius, _subtract(_multiply(ny, wx, _r7), _multiply(nx, wy, _r6), _r6), _r6), _r6)
    _s14 = _subtract(_subtract(vy, _multiply(ny, _s12, _r8), _r8), _multiply(p_ball_radius, _subtract(_multiply(nx, wz, _r7), _multiply(nz, wx, _r4), _r4), _r4), _r4)
    _s15 = _subtract(_subtract(vx, _multiply(nx, _s12, _r8), _r8), _multiply(p_ball_radius, _subtract(_multiply(nz, wy, _r7), _multiply(ny, wz, _r3), _r3), _r3), _r3)
    _s16 = _multiply(p_ring_friction, _multiply(_add(1.0, _divide(p_ring_restitution, _subtract(1.0, _divide(_s12, p_restitution_speed, _r8), _r8), _r8), _r8), _s12, _r8), _r8)
    _s17 = _subtract(_multiply(_s0, _sqrt(_add(_add(_multiply(_s13, _s13, _r6), _multiply(_s14, _s14, _r4), _r4), _multiply(_s15, _s15, _r3), _r3), _r3), _r3), _negative(_s16, _r8), _r8)
    _s18 = _logical_and(_logical_and((0.0 < p_ring_friction), (p_ring_friction < _inf)), _logical_not((_multiply((2.0 * p_ring_friction) + _s0, _s11, _r5) < _absolute(_s17, _r8))))
    return _s18,


def ring_impact_settling(p_ball_radius: Any, bounce: Any, drag: Any, lift: Any, nearest: Any, press: Any, p_ring_friction: Any, p_ring_restitution: Any, rolled_x: Any, rolled_y: Any, rolled_z: Any, slip: Any, turning_x: Any, turning_y: Any, turning_z: Any, velocity_error: Any, wedge: Any, weight: Any, wx: Any, wy: Any, wz: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Where a ball stays on a surface, slides on it or leaves it: its bounces end before anything else can happen, and from when on that is certain.

    a geometric series of bounces. 149 operations: 20 additions, 4 subtractions, 47 multiplications, 8 divisions, 1 square root, 1 negation, 14 absolute values, 23 comparisons, 19 conjunctions, 7 disjunctions, 2 complements, 3 selections.
    Returns settles, lodges, slides, parts, assured, unsure.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13 = _room[:14]
    _s0 = 1.0 - p_ring_restitution
    _s1 = 0.0 < _s0
    _s2 = _divide(bounce, press, _r0)
    _s3 = _add(4.440892098500626e-16, _add(_add(_absolute(turning_x, _r1), _absolute(turning_y, _r2), _r2), _absolute(turning_z, _r1), _r1), _r1)
    _s4 = _add(_add(_multiply(p_ball_radius, _add(_add(_absolute(wx, _r2), _absolute(wy, _r3), _r3), _absolute(wz, _r2), _r2), _r2), _absolute(rolled_x, _r3), _r3), _absolute(rolled_y, _r2), _r2)
    _s5 = _add(_s4, _absolute(rolled_z, _r3), _r3)
    _s6 = _absolute(weight, _r2)
    _s7 = _multiply(_multiply(8.0, _add(_multiply(_s3, _s5, _r4), _s6, _r4), _r4), _s3, _r4)
    _s8 = _s0 * _s0
    _s9 = _add(_sqrt(_multiply(p_ball_radius, _s6, _r2), _r2), _s5, _r2)
    _s10 = _multiply(1.4210854715202004e-14, _s9, _r5)
    _s11 = _multiply(2.0, drag, _r6)
    _s12 = 1.0 + p_ring_restitution
    _s13 = p_ring_friction * _s12
    _s14 = _multiply(press, _s13, _r7)
    _s15 = _logical_and(_logical_and(_logical_and(_logical_and((0.0 < press), _s1), (_multiply(_multiply(3.0, _s2, _r8), _s7, _r8) < _multiply(press, _s8, _r9))), (slip <= _add(_multiply(_multiply(8.0, drag, _r9), _s2, _r9), _s10, _r9))), (_s11 <= _s14))
    _s16 = _multiply(0.5, bounce, _r9)
    _s17 = _s12 * _s0
    _s18 = _multiply(4.0, drag, _r8)
    _s19 = _add(_add(_multiply(_s16, _s2, _r10), _divide(_multiply(_s18, _multiply(_s2, _s2, _r11), _r11), _s17, _r11), _r11), _divide(_multiply(_multiply(1.6, slip, _r10), _s2, _r10), _s0, _r10), _r10)
    _s20 = 3.637978807091713e-12 * p_ball_radius
    _s21 = _logical_and(_s15, (_s19 <= _s20))
    _s22 = 3.725290298461914e-09 * p_ball_radius
    _s23 = wedge <= _s22
    _s24 = _divide(_multiply(_multiply(16.0, _s2, _r0), _s5, _r0), _s0, _r0)
    _s25 = _add(_s22, _s24, _r11) < nearest
    _s26 = _s24 <= _s22
    _s27 = _negative(lift, _r0)
    _s28 = _select(_s27 < press, _s27, press, _r11)
    _s29 = _divide(bounce, _s28, _r12)
    _s30 = _logical_and(_logical_and(_logical_and((0.0 < _s28), _s1), (_multiply(_multiply(3.0, _s29, _r13), _s7, _r13) < _multiply(_s8, _s28, _r11))), (_add(_s22, _divide(_multiply(_multiply(16.0, _s29, _r11), _s5, _r11), _s0, _r11), _r11) < nearest))
    _s31 = _logical_and(_s30, (_add(_multiply(_s16, _s29, _r9), _divide(_multiply(_s18, _multiply(_s29, _s29, _r11), _r11), _s17, _r11), _r11) <= _s20))
    _s32 = 0.0 < bounce
    _s33 = _add(_divide(_multiply(5.0, _add(_multiply(_s11, _s29, _r12), _select(_s32, _multiply(bounce, _s13, _r11), 0.0, _r9), _r9), _r9), _s0, _r9), _multiply(1.4551915228366852e-11, _s9, _r2), _r2)
    _s34 = _logical_or((_absolute(press, _r9) <= _multiply(_multiply(4.0, velocity_error, _r11), _s3, _r11)), _logical_and((_multiply(bounce, _absolute(_subtract(_s19, _s20, _r10), _r10), _r10) <= _multiply(_multiply(2.0, velocity_error, _r11), _s20, _r11)), _s32))
    _s35 = _multiply(16.0, velocity_error, _r11)
    _s36 = _logical_and(_s31, _logical_or((_absolute(_subtract(slip, _s33, _r10), _r10) < _s35), (_absolute(_subtract(_s11, _s14, _r10), _r10) < _multiply(_s35, _add(_multiply(_s13, _s3, _r9), _s3, _r9), _r9))))
    return _logical_and(_logical_and(_s21, _logical_not(_s23)), _logical_or(_s25, _s26)), _logical_and(_s21, _s23), _logical_and(_s31, _logical_or((_s33 < slip), (_s14 < _s11))), _logical_and((bounce <= _s10), (0.0 <= lift)), _result(_logical_or(_logical_and(_s15, _s25), _s30), 1.0, 0.0, _r0), _logical_or(_logical_or(_s34, _s36), _logical_and(_logical_and(_s21, _s26), _logical_not(_s25)))


def ring_impact_strained(drag: Any, drag_rate: Any, force: Any, force_rate: Any, p_ring_friction: Any) -> tuple[Any, ...]:
    """F² - mu² N², and its rate.

    Coulomb's law. 8 operations: 2 subtractions, 6 multiplications.
    Returns strain, strain_rate.
    """
    _s0 = p_ring_friction * p_ring_friction
    return drag - ((force * force) * _s0), drag_rate - (_s0 * (2.0 * (force * force_rate)))


def ring_impact(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, p_ball_radius: Any, p_ring_restitution: Any, p_ring_friction: Any, p_tangential_restitution: Any, p_restitution_speed: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Velocity and spin after a contact, frame-free.

    momentum, angular momentum and Coulomb's law of friction. 83 operations: 9 additions, 19 subtractions, 43 multiplications, 4 divisions, 1 square root, 1 negation, 3 comparisons, 3 selections.
    Returns vx, vy, vz, wx, wy, wz.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13 = _room[:14]
    _s0 = _add(_add(_multiply(nx, vx, _r0), _multiply(ny, vy, _r1), _r1), _multiply(nz, vz, _r0), _r0)
    _s1 = _subtract(vx, _multiply(nx, _s0, _r1), _r1)
    _s2 = _subtract(_s1, _multiply(p_ball_radius, _subtract(_multiply(nz, wy, _r2), _multiply(ny, wz, _r3), _r3), _r3), _r3)
    _s3 = _subtract(vz, _multiply(nz, _s0, _r2), _r2)
    _s4 = _subtract(_s3, _multiply(p_ball_radius, _subtract(_multiply(ny, wx, _r4), _multiply(nx, wy, _r5), _r5), _r5), _r5)
    _s5 = _subtract(vy, _multiply(ny, _s0, _r4), _r4)
    _s6 = _subtract(_s5, _multiply(p_ball_radius, _subtract(_multiply(nx, wz, _r6), _multiply(nz, wx, _r7), _r7), _r7), _r7)
    _s7 = _add(_add(_multiply(_s4, _s4, _r6), _multiply(_s6, _s6, _r8), _r8), _multiply(_s2, _s2, _r6), _r6)
    _s8 = 0.4 + (0.4 * p_tangential_restitution)
    _s9 = _divide(p_ring_restitution, _subtract(1.0, _divide(_s0, p_restitution_speed, _r8), _r8), _r8)
    _s10 = _negative(_multiply(p_ring_friction, _multiply(_add(1.0, _s9, _r9), _s0, _r9), _r9), _r9)
    _s11 = _select(0.0 < p_ring_friction, _select(p_ring_friction < _inf, _select(_multiply(_s7, _s8 * _s8, _r10) <= _multiply(_s10, _s10, _r11), _s8, _divide(_s10, _sqrt(_s7, _r6), _r6), _r9), _s8, _r11), 0.0, _r10)
    _s12 = _divide(_multiply(1.5, _s11, _r12), p_ball_radius, _r12)
    return _subtract(_s1, _multiply(_s2, _s11, _r13), _r13) - _multiply(_multiply(nx, _s9, _r1), _s0, _r1), _subtract(_s5, _multiply(_s6, _s11, _r1), _r1) - _multiply(_multiply(ny, _s9, _r4), _s0, _r4), _subtract(_s3, _multiply(_s4, _s11, _r10), _r10) - _multiply(_multiply(nz, _s9, _r8), _s0, _r8), wx + _multiply(_s12, _subtract(_multiply(ny, _s4, _r8), _multiply(nz, _s6, _r10), _r10), _r10), wy + _multiply(_s12, _subtract(_multiply(nz, _s2, _r10), _multiply(nx, _s4, _r5), _r5), _r5), wz + _multiply(_s12, _subtract(_multiply(nx, _s6, _r7), _multiply(ny, _s2, _r3), _r3), _r3)


def carry_ring_impact(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, dnx: Any, dny: Any, dnz: Any, turn: Any, lifting: Any, p_ball_radius: Any, p_ring_restitution: Any, p_ring_friction: Any, p_tangential_restitution: Any, p_restitution_speed: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Errors of velocity and spin after a contact, from those before it.

    derivative of the contact with friction, with roundings. 315 operations: 41 additions, 56 subtractions, 126 multiplications, 12 divisions, 1 square root, 8 negations, 18 absolute values, 25 comparisons, 28 selections.
    Returns dvx, dvy, dvz, dwx, dwy, dwz.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18, _r19, _r20, _r21, _r22, _r23, _r24, _r25, _r26, _r27, _r28, _r29, _r30, _r31, _r32 = _room[:33]
    _s0 = _add(_add(_multiply(nx, vx, _r0), _multiply(ny, vy, _r1), _r1), _multiply(nz, vz, _r0), _r0)
    _s1 = _add(_add(_add(_add(_add(_multiply(dnx, vx, _r1), _multiply(dny, vy, _r2), _r2), _multiply(dnz, vz, _r1), _r1), _multiply(dvx, nx, _r2), _r2), _multiply(dvy, ny, _r1), _r1), _multiply(dvz, nz, _r2), _r2)
    _s2 = _subtract(_subtract(dvx, _multiply(dnx, _s0, _r1), _r1), _multiply(nx, _s1, _r3), _r3)
    _s3 = _subtract(_subtract(vx, _multiply(nx, _s0, _r1), _r1), _multiply(p_ball_radius, _subtract(_multiply(nz, wy, _r4), _multiply(ny, wz, _r5), _r5), _r5), _r5)
    _s4 = _subtract(_subtract(vz, _multiply(nz, _s0, _r1), _r1), _multiply(p_ball_radius, _subtract(_multiply(ny, wx, _r4), _multiply(nx, wy, _r6), _r6), _r6), _r6)
    _s5 = _subtract(_subtract(vy, _multiply(ny, _s0, _r1), _r1), _multiply(p_ball_radius, _subtract(_multiply(nx, wz, _r4), _multiply(nz, wx, _r7), _r7), _r7), _r7)
    _s6 = _add(_add(_multiply(_s4, _s4, _r1), _multiply(_s5, _s5, _r4), _r4), _multiply(_s3, _s3, _r1), _r1)
    _s7 = 0.4 + (0.4 * p_tangential_restitution)
    _s8 = _subtract(1.0, _divide(_s0, p_restitution_speed, _r4), _r4)
    _s9 = _divide(p_ring_restitution, _s8, _r8)
    _s10 = _add(1.0, _s9, _r9)
    _s11 = _negative(_multiply(p_ring_friction, _multiply(_s10, _s0, _r10), _r10), _r10)
    _s12 = _negative(_divide(_multiply(p_ring_restitution, _negative(_divide(_s1, p_restitution_speed, _r11), _r11), _r11), _multiply(_s8, _s8, _r4), _r11), _r11)
    _s13 = _sqrt(_s6, _r4)
    _s14 = _subtract(_subtract(dvz, _multiply(dnz, _s0, _r12), _r12), _multiply(nz, _s1, _r13), _r13)
    _s15 = _subtract(_s14, _multiply(p_ball_radius, _subtract(_subtract(_add(_multiply(dny, wx, _r12), _multiply(dwx, ny, _r14), _r14), _multiply(dnx, wy, _r12), _r12), _multiply(dwy, nx, _r14), _r14), _r14), _r14)
    _s16 = _subtract(_subtract(dvy, _multiply(dny, _s0, _r12), _r12), _multiply(ny, _s1, _r15), _r15)
    _s17 = _subtract(_s16, _multiply(p_ball_radius, _subtract(_subtract(_add(_multiply(dnx, wz, _r12), _multiply(dwz, nx, _r16), _r16), _multiply(dnz, wx, _r12), _r12), _multiply(dwx, nz, _r16), _r16), _r16), _r16)
    _s18 = _subtract(_s2, _multiply(p_ball_radius, _subtract(_subtract(_add(_multiply(dnz, wy, _r12), _multiply(dwy, nz, _r17), _r17), _multiply(dny, wz, _r12), _r12), _multiply(dwz, ny, _r17), _r17), _r17), _r17)
    _s19 = _divide(_multiply(_multiply(0.5, _s11, _r12), _add(_add(_multiply(_multiply(2.0, _s4, _r18), _s15, _r18), _multiply(_multiply(2.0, _s5, _r19), _s17, _r19), _r19), _multiply(_multiply(2.0, _s3, _r18), _s18, _r18), _r18), _r12), _multiply(_s13, _s6, _r18), _r12)
    _s20 = _subtract(_divide(_negative(_multiply(p_ring_friction, _add(_multiply(_s10, _s1, _r9), _multiply(_s12, _s0, _r18), _r18), _r18), _r18), _s13, _r18), _s19, _r12)
    _s21 = _multiply(_s6, _s7 * _s7, _r1) <= _multiply(_s11, _s11, _r18)
    _s22 = p_ring_friction < _inf
    _s23 = 0.0 < p_ring_friction
    _s24 = _select(_s23, _select(_s22, _select(_s21, 0.0, _s20, _r18), 0.0, _r1), 0.0, _r9)
    _s25 = _select(_s23, _select(_s22, _select(_s21, _s7, _divide(_s11, _s13, _r4), _r10), _s7, _r19), 0.0, _r20)
    _s26 = _subtract(_subtract(_subtract(_subtract(_subtract(_s2, _multiply(_s3, _s24, _r21), _r21), _multiply(_s18, _s25, _r3), _r3), _multiply(_multiply(dnx, _s9, _r21), _s0, _r21), _r21), _multiply(_multiply(nx, _s9, _r3), _s1, _r3), _r3), _multiply(_multiply(nx, _s12, _r21), _s0, _r21), _r21)
    _s27 = _add(_add(_multiply(p_ball_radius, _add(_add(_absolute(wx, _r3), _absolute(wy, _r22), _r22), _absolute(wz, _r3), _r3), _r3), _absolute(vx, _r22), _r22), _absolute(vy, _r3), _r3)
    _s28 = _add(_s27, _absolute(vz, _r22), _r22)
    _s29 = _multiply(2.220446049250313e-16, _s28, _r3)
    _s30 = _negative(_s29, _r23)
    _s31 = _add(_s26, _select(_s26 < 0.0, _s30, _s29, _r24), _r24)
    _s32 = _absolute(dwx, _r21)
    _s33 = _absolute(dwy, _r25)
    _s34 = _select(_s32 < _s33, _s33, _s32, _r26)
    _s35 = _absolute(dwz, _r27)
    _s36 = _absolute(dvx, _r28)
    _s37 = _absolute(dvy, _r29)
    _s38 = _select(_s36 < _s37, _s37, _s36, _r30)
    _s39 = _absolute(dvz, _r31)
    _s40 = _add(_add(_multiply(p_ball_radius, _select(_s34 < _s35, _s35, _s34, _r32), _r32), _multiply(turn, _s28, _r22), _r22), _select(_s38 < _s39, _s39, _s38, _r32), _r32)
    _s41 = _divide(_s40, lifting, _r31)
    _s42 = _negative(_s41, _r30)
    _s43 = _select(_absolute(_s31, _r29) < _s41, _select(_s31 < 0.0, _s42, _s41, _r29), _s31, _r28)
    _s44 = _subtract(_subtract(_subtract(_subtract(_subtract(_s16, _multiply(_s5, _s24, _r22), _r22), _multiply(_s17, _s25, _r15), _r15), _multiply(_multiply(dny, _s9, _r22), _s0, _r22), _r22), _multiply(_multiply(ny, _s9, _r15), _s1, _r15), _r15), _multiply(_multiply(ny, _s12, _r22), _s0, _r22), _r22)
    _s45 = _add(_s44, _select(_s44 < 0.0, _s30, _s29, _r15), _r15)
    _s46 = _select(_absolute(_s45, _r22) < _s41, _select(_s45 < 0.0, _s42, _s41, _r22), _s45, _r27)
    _s47 = _subtract(_subtract(_subtract(_subtract(_subtract(_s14, _multiply(_s4, _s24, _r26), _r26), _multiply(_s15, _s25, _r13), _r13), _multiply(_multiply(dnz, _s9, _r26), _s0, _r26), _r26), _multiply(_multiply(nz, _s9, _r8), _s1, _r8), _r8), _multiply(_multiply(nz, _s12, _r11), _s0, _r11), _r11)
    _s48 = _add(_s47, _select(_s47 < 0.0, _s30, _s29, _r8), _r8)
    _s49 = _select(_absolute(_s48, _r11) < _s41, _select(_s48 < 0.0, _s42, _s41, _r11), _s48, _r23)
    _s50 = _add(_add(_multiply(nx, _subtract(_s43, _s31, _r0), _r0), _multiply(ny, _subtract(_s46, _s45, _r26), _r26), _r26), _multiply(nz, _subtract(_s49, _s48, _r0), _r0), _r0)
    _s51 = _divide(_multiply(1.5, _s24, _r9), p_ball_radius, _r9)
    _s52 = _divide(_multiply(1.5, _s25, _r20), p_ball_radius, _r20)
    _s53 = _add(_add(dwx, _multiply(_s51, _subtract(_multiply(ny, _s4, _r19), _multiply(nz, _s5, _r10), _r10), _r10), _r10), _multiply(_s52, _subtract(_subtract(_add(_multiply(dny, _s4, _r19), _multiply(ny, _s15, _r4), _r4), _multiply(dnz, _s5, _r19), _r19), _multiply(nz, _s17, _r4), _r4), _r4), _r4)
    _s54 = _divide(_s29, p_ball_radius, _r3)
    _s55 = _negative(_s54, _r10)
    _s56 = _add(_s53, _select(_s53 < 0.0, _s55, _s54, _r19), _r19)
    _s57 = _divide(_s40, _multiply(p_ball_radius, lifting, _r4), _r4)
    _s58 = _negative(_s57, _r32)
    _s59 = _add(_add(dwy, _multiply(_s51, _subtract(_multiply(nz, _s3, _r1), _multiply(nx, _s4, _r18), _r18), _r18), _r18), _multiply(_s52, _subtract(_subtract(_add(_multiply(dnz, _s3, _r1), _multiply(nz, _s18, _r12), _r12), _multiply(dnx, _s4, _r6), _r6), _multiply(nx, _s15, _r14), _r14), _r14), _r14)
    _s60 = _add(_s59, _select(_s59 < 0.0, _s55, _s54, _r18), _r18)
    _s61 = _add(_add(dwz, _multiply(_s51, _subtract(_multiply(nx, _s5, _r14), _multiply(ny, _s3, _r6), _r6), _r6), _r6), _multiply(_s52, _subtract(_subtract(_add(_multiply(dnx, _s5, _r7), _multiply(nx, _s17, _r16), _r16), _multiply(dny, _s3, _r5), _r5), _multiply(ny, _s18, _r17), _r17), _r17), _r17)
    _s62 = _add(_s61, _select(_s61 < 0.0, _s55, _s54, _r6), _r6)
    return _s43 - _multiply(nx, _s50, _r17), _s46 - _multiply(ny, _s50, _r17), _s49 - _multiply(nz, _s50, _r0), _result(_absolute(_s56, _r0) < _s57, _select(_s56 < 0.0, _s58, _s57, _r0), _s56, _r0), _result(_absolute(_s60, _r0) < _s57, _select(_s60 < 0.0, _s58, _s57, _r0), _s60, _r0), _result(_absolute(_s62, _r0) < _s57, _select(_s62 < 0.0, _s58, _s57, _r0), _s62, _r0)


def ring_coefficients(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Coefficients in time of the event polynomial, constant first.

    Eq. 3 in Table 2. 64 operations: 12 additions, 8 subtractions, 43 multiplications, 1 negation.
    Returns c0, c1, c2, c3, c4, c5, c6, c7, c8.
    """
    _s0 = p_ring_radius * p_ring_radius
    _s1 = x * x
    _s2 = y * y
    _s3 = p_ball_radius + p_wire_radius
    _s4 = (((_s0 + _s1) + _s2) + (z * z)) - (_s3 * _s3)
    _s5 = 4.0 * _s0
    _s6 = ((2.0 * vx) * x) + ((2.0 * vy) * y)
    _s7 = _s6 + ((2.0 * vz) * z)
    _s8 = 2.0 * _s7
    _s9 = (vx * vx) + (vy * vy)
    _s10 = vz * vz
    _s11 = (_s9 + _s10) - (p_gravity * z)
    _s12 = (2.0 * p_gravity) * vz
    _s13 = p_gravity * p_gravity
    _s14 = 0.5 * _s13
    return (_s4 * _s4) - (_s5 * (_s1 + _s2)), (_s8 * _s4) - (_s5 * _s6), (((2.0 * _s11) * _s4) + (_s7 * _s7)) - (_s5 * _s9), (_s8 * _s11) - (_s12 * _s4), ((_s14 * _s4) + (_s11 * _s11)) - (_s12 * _s7), (_s14 * _s7) - (_s12 * _s11), (_s13 * _s10) + (_s14 * _s11), -((0.5 * (p_gravity * _s13)) * vz), 0.0625 * (_s13 * _s13)


def ring_deflated(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Coefficients of the event polynomial over t, after a contact at t = 0.

    Eq. 3 in Table 2, the exact root divided out. 60 operations: 11 additions, 7 subtractions, 41 multiplications, 1 negation.
    Returns c0, c1, c2, c3, c4, c5, c6, c7.
    """
    _s0 = ((2.0 * vx) * x) + ((2.0 * vy) * y)
    _s1 = _s0 + ((2.0 * vz) * z)
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
    Returns nx, ny, nz.
    """
    _r0, _r1 = _room[:2]
    _s0 = 1.0 / (p_ball_radius + p_wire_radius)
    _s1 = _sqrt(_add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1), _r1)
    _s2 = _multiply(_multiply(_s0, _subtract(_s1, p_ring_radius, _r0), _r0), _divide(1.0, _s1, _r1), _r0)
    return x * _s2, y * _s2, z * _s0


def ring_curvature(p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any) -> tuple[Any, ...]:
    """Bound on the rate at which the normal turns along the contact surface.

    Table 2. 6 operations: 1 addition, 2 subtractions, 1 division, 1 comparison, 1 selection.
    Returns curvature.
    """
    _s0 = (p_ring_radius - p_ball_radius) - p_wire_radius
    _s1 = p_ball_radius + p_wire_radius
    return 1.0 / _where(_s0 < _s1, _s0, _s1),


def ring_carry_normal(x: Any, y: Any, dx: Any, dy: Any, dz: Any, shift: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Error of the normal, from that of the position.

    derivative of Table 2's normal. 38 operations: 6 additions, 3 subtractions, 21 multiplications, 4 divisions, 1 square root, 1 negation, 1 comparison, 1 selection.
    Returns dnx, dny, dnz, turn.
    """
    _r0, _r1, _r2, _r3, _r4, _r5 = _room[:6]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = 1.0 / _s0
    _s2 = _sqrt(_add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1), _r1)
    _s3 = _subtract(_s2, p_ring_radius, _r0)
    _s4 = _divide(1.0, _s2, _r2)
    _s5 = _multiply(_multiply(_s1, _s3, _r3), _s4, _r3)
    _s6 = _divide(_multiply(0.5, _add(_multiply(_multiply(2.0, dx, _r4), x, _r4), _multiply(_multiply(2.0, dy, _r5), y, _r5), _r5), _r5), _s2, _r5)
    _s7 = _add(_multiply(_multiply(_s6, _s1, _r1), _s4, _r1), _multiply(_multiply(_negative(_multiply(_s6, _multiply(_s4, _s4, _r2), _r2), _r2), _s1, _r2), _s3, _r2), _r2)
    _s8 = (p_ring_radius - p_ball_radius) - p_wire_radius
    return _multiply(dx, _s5, _r1) + _multiply(x, _s7, _r0), _multiply(dy, _s5, _r3) + _multiply(y, _s7, _r2), dz * _s1, shift * (1.0 / _where(_s8 < _s0, _s8, _s0))


def ring_clear(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Positive if there certainly is no contact before the horizon.

    bounds of the event condition. 161 operations: 31 additions, 19 subtractions, 74 multiplications, 1 division, 4 square roots, 16 comparisons, 16 selections.
    Returns clear.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14 = _room[:15]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = (0.000244140625 * p_ring_radius) - (p_ring_radius - _s0)
    _s2 = 1.0 / p_gravity
    _s3 = _multiply(_sqrt(2.0), _sqrt(_multiply(_s2, _add(_add(2.0 * p_ball_radius, extent, _r0), 2.0 * p_wire_radius, _r0), _r0), _r0), _r0)
    _s4 = _add(_s3, _multiply(_multiply(2.0, speed, _r1), _s2, _r1), _r1)
    _s5 = _subtract(_subtract(_add(position_error, _multiply(velocity_error, _select(_s4 < horizon, _s4, horizon, _r0), _r0), _r0), 1.52587890625e-05 * p_ball_radius, _r0), 1.52587890625e-05 * p_wire_radius, _r0)
    _s6 = 1.00006103515625 * _s0
    _s7 = p_ring_radius + _s6
    _s8 = _multiply(vz, vz, _r1)
    _s9 = _add(_s8, _multiply(2.0 * p_gravity, _subtract(z, _s6, _r2), _r2), _r2)
    _s10 = _sqrt(_s9, _r3)
    _s11 = _multiply(_s2, _subtract(vz, _s10, _r4), _r4)
    _s12 = _multiply(_s2, _add(vz, _s10, _r3), _r3)
    _s13 = _add(x, _multiply(vx, _s12, _r5), _r5)
    _s14 = _add(y, _multiply(vy, _s12, _r6), _r6)
    _s15 = _add(_multiply(_s13, _s13, _r7), _multiply(_s14, _s14, _r8), _r8)
    _s16 = _sqrt(_s15, _r7)
    _s17 = _subtract(_s16, p_ring_radius, _r9)
    _s18 = _add(z, _multiply(_subtract(vz, _multiply(0.5 * p_gravity, _s12, _r10), _r10), _s12, _r10), _r10)
    _s19 = _s7 * _s7
    _s20 = 9.313225746154785e-10 * _s19
    _s21 = _subtract(_subtract(_add(_multiply(_s17, _s17, _r11), _multiply(_s18, _s18, _r12), _r12), _s0 * _s0, _r12), _s20, _r12)
    _s22 = _add(_multiply(vx, vx, _r11), _multiply(vy, vy, _r13), _r13)
    _s23 = p_ring_radius - _s6
    _s24 = 0.0001220703125 * p_ring_radius
    _s25 = _where(_s23 < _s24, _s24, _s23)
    _s26 = _s25 * _s25
    _s27 = _s25 * _s26
    _s28 = _multiply(_subtract(_add(_add(_multiply(2.0, _s8, _r1), _multiply(4.0 * p_gravity, z, _r11), _r11), _multiply(2.0, _s22, _r1), _r1), (6.0003662109375 * p_gravity) * _s0, _r1), _s27, _r1)
    _s29 = _subtract(_multiply(vy, x, _r11), _multiply(vx, y, _r14), _r14)
    _s30 = _multiply(_s29, _s29, _r14)
    _s31 = _subtract(_s28, _multiply(2.0 * p_ring_radius, _s30, _r11), _r11)
    _s32 = _add(_multiply(_s17, _add(_multiply(vx, _s13, _r5), _multiply(vy, _s14, _r6), _r6), _r6), _multiply(_multiply(_s18, _subtract(vz, _multiply(p_gravity, _s12, _r9), _r9), _r9), _s16, _r9), _r9)
    _s33 = _add(x, _multiply(horizon, vx, _r6), _r6)
    _s34 = _add(y, _multiply(horizon, vy, _r7), _r7)
    _s35 = _select(_subtract(_add(_add(_s20, _multiply(_s33, _s33, _r6), _r6), _multiply(_s34, _s34, _r7), _r7), _s26, _r7) < 0.0, 1.0, _select(_subtract(_multiply(_s22, _s20 + _s26, _r7), _s30, _r7) < 0.0, 1.0, 0.0, _r7), _r14)
    _s36 = _select(_subtract(_multiply(_multiply(4.0, _multiply(_s32, _s32, _r9), _r9), _s27, _r9), _multiply(_multiply(_multiply(2.0, _s31, _r6), _s15, _r6), _s21, _r6), _r6) < 0.0, _s35, 0.0, _r6)
    _s37 = _select(horizon < _subtract(_s12, _multiply(9.313225746154785e-10, horizon, _r9), _r9), 1.0, _select(0.0 < _s21, _select(0.0 < _s31, _s36, 0.0, _r11), 0.0, _r12), _r9)
    _s38 = _add(_multiply(vx, x, _r3), _multiply(vy, y, _r8), _r8)
    _s39 = _add(_multiply(_s11, _s22, _r13), _s38, _r13)
    _s40 = _select(_s39 < 0.0, _select(_s19 < _add(_multiply(_s11, _add(_s38, _s39, _r13), _r13), _add(_multiply(x, x, _r8), _multiply(y, y, _r3), _r3), _r3), _s37, 0.0, _r3), 0.0, _r13)
    _s41 = _select(_add(extent, _multiply(horizon, _add(speed, _multiply(p_gravity, horizon, _r8), _r8), _r8), _r8) < (65536.0 * _s7), _select(0.0 < _s9, _select(_s11 < 0.0, _s37, _s40, _r4), 0.0, _r2), 0.0, _r8)
    return _result(0.0 < _select(_s1 < _s5, _s5, _s1, _r10), 0.0, _select(_add(position_error, _multiply(horizon, velocity_error, _r10), _r10) < (5.820766091346741e-11 * _s7), _s41, 0.0, _r10), _r0),


def ring_prepare(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Constants and windows of the search along a flight, and the errors it allows for.

    bounds of the event condition. 190 operations: 31 additions, 20 subtractions, 54 multiplications, 3 divisions, 7 square roots, 1 negation, 5 absolute values, 31 comparisons, 38 selections.
    Returns steady, swing, rho_start, low0, high0, low1, high1, low2, high2, ceiling, latest, lost.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18, _r19, _r20, _r21, _r22, _r23, _r24, _r25, _r26, _r27, _r28, _r29, _r30, _r31, _r32, _r33, _r34, _r35 = _room[:36]
    _s0 = _multiply(vz, vz, _r0)
    _s1 = _add(_multiply(vx, vx, _r1), _multiply(vy, vy, _r2), _r2)
    _s2 = _add(_multiply(2.0, _s0, _r1), _multiply(4.0 * p_gravity, z, _r3), _r3) + _multiply(2.0, _s1, _r1)
    _s3 = _subtract(_multiply(vy, x, _r1), _multiply(vx, y, _r3), _r3)
    _s4 = _multiply(_s3, _s3, _r1)
    _s5 = (2.0 * p_ring_radius) * _s4
    _s6 = _add(_multiply(x, x, _r4), _multiply(y, y, _r5), _r5)
    _s7 = p_ball_radius + p_wire_radius
    _s8 = 1.00006103515625 * _s7
    _s9 = 2.0 * p_gravity
    _s10 = _multiply(8.881784197001252e-16, _add(_s0, _multiply(_s9, _add(_absolute(z, _r4), _s8, _r4), _r4), _r4), _r4)
    _s11 = _add(_add(_s0, _multiply(_s9, _add(z, _s8, _r6), _r6), _r6), _s10, _r6)
    _s12 = 1.0 / p_gravity
    _s13 = _sqrt(_s11, _r7)
    _s14 = _multiply(1.7763568394002505e-15, _add(_absolute(vz, _r8), _s13, _r8), _r8)
    _s15 = 0.0 <= _s11
    _s16 = _select(_s15, _multiply(_s12, _subtract(_subtract(vz, _s13, _r6), _s14, _r6), _r6), _inf, _r9)
    _s17 = p_ring_radius + _s8
    _s18 = _s17 * _s17
    _s19 = _multiply(_multiply(1.7763568394002505e-15, _s1, _r10), _add(_s18, _s6, _r11), _r10)
    _s20 = _subtract(_add(_multiply(_s18, _s1, _r11), _s19, _r11), _s4, _r11)
    _s21 = _add(_multiply(vx, x, _r12), _multiply(vy, y, _r13), _r13)
    _s22 = _sqrt(_s20, _r12)
    _s23 = _multiply(1.7763568394002505e-15, _add(_add(_absolute(_s21, _r14), _absolute(_s3, _r3), _r3), _s22, _r3), _r3)
    _s24 = _divide(1.0, _s1, _r14)
    _s25 = 0.0 <= _s20
    _s26 = 2.409919865102884e-181 < _s1
    _s27 = _select(_s26, _select(_s25, _multiply(_negative(_add(_add(_s21, _s22, _r11), _s23, _r11), _r11), _s24, _r11), _inf, _r15), -_inf, _r16)
    _s28 = _select(_s16 < _s27, _s27, _s16, _r17)
    _s29 = p_ring_radius - _s8
    _s30 = 0.0001220703125 * p_ring_radius
    _s31 = _where(_s29 < _s30, _s30, _s29)
    _s32 = _subtract(_subtract(_multiply(_s1, _s31 * _s31, _r2), _s19, _r2), _s4, _r2)
    _s33 = _sqrt(_select(_s32 < 0.0, 0.0, _s32, _r1), _r1)
    _s34 = _select(_s26, _select(_s25, _multiply(_subtract(_add(_s22, _s23, _r12), _s21, _r12), _s24, _r12), -_inf, _r10), _inf, _r18)
    _s35 = 0.0 < _select(_s26, _s32, 0.0, _r19)
    _s36 = _select(_s35, _multiply(_subtract(_subtract(_s23, _s21, _r19), _s33, _r19), _s24, _r19), _s34, _r2)
    _s37 = _subtract(_add(_s0, _multiply(_s9, _subtract(z, _s8, _r20), _r20), _r20), _s10, _r20)
    _s38 = _sqrt(_select(_s37 < 0.0, 0.0, _s37, _r4), _r4)
    _s39 = _select(_s15, _multiply(_s12, _add(_add(vz, _s13, _r7), _s14, _r7), _r7), -_inf, _r0)
    _s40 = 0.0 < _s37
    _s41 = _select(_s40, _multiply(_s12, _subtract(_add(vz, _s14, _r20), _s38, _r20), _r20), _s39, _r21)
    _s42 = _select(_s36 < _s41, _s36, _s41, _r22)
    _s43 = _select(_s35, _multiply(_subtract(_subtract(_s33, _s21, _r1), _s23, _r1), _s24, _r1), _inf, _r14)
    _s44 = _select(_s43 < _s36, _s36, _s43, _r3)
    _s45 = _select(_s16 < _s44, _s44, _s16, _r13)
    _s46 = _select(_s34 < _s41, _s34, _s41, _r23)
    _s47 = _select(_s40, _multiply(_s12, _subtract(_add(vz, _s38, _r4), _s14, _r4), _r4), _inf, _r8)
    _s48 = _select(_s47 < _s41, _s41, _s47, _r24)
    _s49 = _s45 <= _s46
    _s50 = _select(_s49, _s45, _select(_s48 < _s27, _s27, _s48, _r25), _r26)
    _s51 = _select(_s49, _s46, _select(_s36 < _s39, _s36, _s39, _r27), _r28)
    _s52 = _select(_s48 < _s44, _s44, _s48, _r29)
    _s53 = _select(_s34 < _s39, _s34, _s39, _r30)
    _s54 = 1.0 / _s31
    _s55 = _select(0.0 < _s42, _s42, 0.0, _r31)
    _s56 = _select(_s55 < _s51, _s51, _s55, _r32)
    _s57 = _select(_s56 < _s53, _s53, _s56, _r33)
    _s58 = (0.000244140625 * p_ring_radius) - (p_ring_radius - _s7)
    _s59 = _multiply(_sqrt(2.0), _sqrt(_multiply(_s12, _add(_add(2.0 * p_ball_radius, extent, _r34), 2.0 * p_wire_radius, _r34), _r34), _r34), _r34)
    _s60 = _add(_s59, _multiply(_multiply(2.0, speed, _r35), _s12, _r35), _r35)
    _s61 = _subtract(_subtract(_add(position_error, _multiply(velocity_error, _select(_s60 < horizon, _s60, horizon, _r34), _r34), _r34), 1.52587890625e-05 * p_ball_radius, _r34), 1.52587890625e-05 * p_wire_radius, _r34)
    return _s2, _s5, _sqrt(_s6), _result(0.0 < _s28, _s28, 0.0, _r0), _result(_s42 < horizon, _s42, horizon, _r0), _result(0.0 < _s50, _s50, 0.0, _r0), _result(_s51 < horizon, _s51, horizon, _r0), _result(0.0 < _s52, _s52, 0.0, _r0), _result(_s53 < horizon, _s53, horizon, _r0), _add((6.0003662109375 * p_gravity) * _s7, _multiply(_s5, _s54 * (_s54 * _s54), _r29), _r29) + _absolute(_s2, _r24), _result(_s57 < horizon, _s57, horizon, _r0), _result(_s58 < _s61, _s61, _s58, _r0)


def ring_margins(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.

    running error analysis. 47 operations: 14 additions, 1 subtraction, 27 multiplications, 1 division, 2 comparisons, 2 selections.
    Returns margin, leaving_margin, rate_margin.
    """
    _r0, _r1, _r2, _r3, _r4, _r5 = _room[:6]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = _add(speed, _multiply(p_gravity, horizon, _r0), _r0)
    _s2 = 1.00006103515625 * _s0
    _s3 = _multiply(_s2, _s1, _r1)
    _s4 = p_ring_radius + _s2
    _s5 = _add(extent, _multiply(horizon, _s1, _r2), _r2)
    _s6 = _add(_add(position_error, _multiply(horizon, velocity_error, _r3), _r3), _multiply(4.440892098500626e-16, _s5, _r4), _r4)
    _s7 = p_ring_radius - _s2
    _s8 = 0.0001220703125 * p_ring_radius
    _s9 = _s2 / _where(_s7 < _s8, _s8, _s7)
    _s10 = _where(1.0 < _s9, _s9, 1.0)
    _s11 = _multiply(5.0, _add(_multiply(_multiply(_s1, _s10, _r3), _s6, _r3), _multiply(_s2, _add(velocity_error, _multiply(2.220446049250313e-16, _s1, _r5), _r5), _r5), _r5), _r5)
    _s12 = 1.0009765625 * _add(_add(_multiply(_multiply(3.552713678800501e-15, _s1, _r3), _add(_multiply(_s5, _s10, _r2), _s4, _r2), _r3), _multiply(4.440892098500626e-16, _s3, _r2), _r2), _s11, _r2)
    return 1.0009765625 * _add(_add(_multiply(_multiply(4.440892098500626e-16, horizon, _r2), _s3, _r2), (1.3323489447131243e-15 * _s0) * _s4, _r2), _multiply(5.00030517578125 * _s0, _s6, _r4), _r4), _s12, 1.0009765625 * _add(_multiply(3.552713678800501e-15, _multiply(_s4, _s1, _r0), _r0), _s11, _r0)


def ring_refine(t: Any, leaving: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, rho_start: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Newton's next value of a root near t, and gap and rate there.

    Newton's method. 56 operations: 15 additions, 6 subtractions, 30 multiplications, 2 divisions, 1 square root, 1 comparison, 1 selection.
    Returns time, gap, rate.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7 = _room[:8]
    _s0 = _add(x, _multiply(t, vx, _r0), _r0)
    _s1 = _add(y, _multiply(t, vy, _r1), _r1)
    _s2 = _sqrt(_add(_multiply(_s0, _s0, _r2), _multiply(_s1, _s1, _r3), _r3), _r3)
    _s3 = _add(rho_start, _s2, _r2)
    _s4 = _divide(1.0, _multiply(_s3, _s2, _r4), _r4)
    _s5 = _subtract(_s2, p_ring_radius, _r5)
    _s6 = _subtract(vz, _multiply(0.5 * p_gravity, t, _r6), _r6)
    _s7 = _add(z, _multiply(t, _s6, _r7), _r7)
    _s8 = 2.0 * _add(_multiply(_multiply(_multiply(_s3, _s4, _r2), _add(_multiply(vx, _s0, _r0), _multiply(vy, _s1, _r1), _r1), _r1), _s5, _r1), _multiply(_subtract(vz, _multiply(p_gravity, t, _r2), _r2), _s7, _r2), _r2)
    _s9 = _multiply(_multiply(_add(_multiply(t, _add(_multiply(vx, vx, _r2), _multiply(vy, vy, _r1), _r1), _r1), _multiply(2.0, _add(_multiply(vx, x, _r2), _multiply(vy, y, _r0), _r0), _r0), _r0), _add(_subtract(rho_start, p_ring_radius, _r1), _s5, _r1), _r1), _multiply(_s2, _s4, _r4), _r4)
    _s10 = p_ball_radius + p_wire_radius
    _s11 = _result(0.0 < leaving, _multiply(t, _add(_s9, _multiply(_add(z, _s7, _r1), _s6, _r1), _r1), _r1), _subtract(_add(_multiply(_s5, _s5, _r5), _multiply(_s7, _s7, _r7), _r7), _s10 * _s10, _r7), _r0)
    return t - _divide(_s11, _s8, _r7), _s11, _s8


def ring_advance(t: Any, end: Any, leaving: Any, margin: Any, rate_margin: Any, ceiling: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, steady: Any, swing: Any, rho_start: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Gap, rate, bend, a step without a root, its end, and the clearance of a root.

    Newton from the left under a curvature bound. 143 operations: 29 additions, 16 subtractions, 53 multiplications, 4 divisions, 2 square roots, 2 negations, 2 absolute values, 16 comparisons, 19 selections.
    Returns gap, rate, bend, step, next, clearance.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15 = _room[:16]
    _s0 = _add(x, _multiply(t, vx, _r0), _r0)
    _s1 = _add(y, _multiply(t, vy, _r1), _r1)
    _s2 = _sqrt(_add(_multiply(_s0, _s0, _r2), _multiply(_s1, _s1, _r3), _r3), _r3)
    _s3 = _subtract(_s2, p_ring_radius, _r2)
    _s4 = _add(rho_start, _s2, _r4)
    _s5 = _divide(1.0, _multiply(_s4, _s2, _r5), _r5)
    _s6 = _multiply(_multiply(_add(_multiply(t, _add(_multiply(vx, vx, _r6), _multiply(vy, vy, _r7), _r7), _r7), _multiply(2.0, _add(_multiply(vx, x, _r6), _multiply(vy, y, _r8), _r8), _r8), _r8), _add(_subtract(rho_start, p_ring_radius, _r7), _s3, _r7), _r7), _multiply(_s2, _s5, _r8), _r8)
    _s7 = _subtract(vz, _multiply(0.5 * p_gravity, t, _r7), _r7)
    _s8 = _add(z, _multiply(t, _s7, _r6), _r6)
    _s9 = p_ball_radius + p_wire_radius
    _s10 = _result(0.0 < leaving, _multiply(t, _add(_s6, _multiply(_add(z, _s8, _r9), _s7, _r9), _r9), _r9), _subtract(_add(_multiply(_s3, _s3, _r8), _multiply(_s8, _s8, _r7), _r7), _s9 * _s9, _r7), _r0)
    _s11 = _multiply(_s4, _s5, _r5)
    _s12 = _multiply(_s11, _add(_multiply(vx, _s0, _r0), _multiply(vy, _s1, _r1), _r1), _r1)
    _s13 = _subtract(vz, _multiply(p_gravity, t, _r0), _r0)
    _s14 = 2.0 * _add(_multiply(_s12, _s3, _r2), _multiply(_s13, _s8, _r4), _r4)
    _s15 = 6.0 * p_gravity
    _s16 = _multiply(_s15, _s8, _r4)
    _s17 = _multiply(swing, _multiply(_s11, _multiply(_s11, _s11, _r2), _r2), _r2)
    _s18 = 1.00006103515625 * _s9
    _s19 = 9.094947017729282e-13 * (p_ring_radius + _s18)
    _s20 = _subtract(_s14, rate_margin, _r5)
    _s21 = _subtract(_s10, margin, _r7)
    _s22 = _select(_s21 < 0.0, 0.0, _s21, _r9)
    _s23 = _subtract(_add(_s16, _s17, _r8), steady, _r8)
    _s24 = _s20 < 0.0
    _s25 = _multiply(2.0, _s22, _r10)
    _s26 = _select(0.0 < _select(0.0 <= _s20, _s22, 0.0, _r11), _inf, _divide(_select(_s24, _s25, _multiply(4.0, _s20, _r11), _r12), _select(_s24, _negative(_s20, _r13), _select(0.0 < _s23, _s23, 0.0, _r14), _r15), _r12), _r11)
    _s27 = _subtract(end, t, _r15)
    _s28 = _select(_s26 < _s27, _s26, _s27, _r14)
    _s29 = _add(_s19, _add(_multiply(_s28, _select(_s13 < 0.0, 0.0, _s13, _r8), _r8), _s8, _r8), _r8)
    _s30 = _multiply(_s15, _select(_s18 < _s29, _s18, _s29, _r6), _r6)
    _s31 = _subtract(_add(_multiply(_s28, _select(0.0 < _s12, 0.0, _s12, _r8), _r8), _s2, _r8), _s19, _r8)
    _s32 = p_ring_radius - _s18
    _s33 = 0.0001220703125 * p_ring_radius
    _s34 = _where(_s32 < _s33, _s33, _s32)
    _s35 = _divide(1.0, _select(_s31 < _s34, _s34, _s31, _r3), _r3)
    _s36 = _multiply(swing, _multiply(_s35, _multiply(_s35, _s35, _r8), _r8), _r8)
    _s37 = _subtract(_add(_add(_s30, _s36, _r3), _multiply(9.094947017729282e-13, _add(_add(_s36, _absolute(steady, _r1), _r1), _absolute(_s30, _r6), _r6), _r6), _r6), steady, _r6)
    _s38 = _add(_multiply(_multiply(2.0, _s37, _r3), _s22, _r3), _multiply(_s20, _s20, _r9), _r9)
    _s39 = _sqrt(_s38, _r3)
    _s40 = _select(0.0 <= _s38, _divide(_select(_s24, _s25, _add(_s20, _s39, _r9), _r7), _select(_s24, _subtract(_s39, _s20, _r3), _select(0.0 < _s37, _s37, 0.0, _r5), _r1), _r7), _inf, _r9)
    _s41 = _result(_s40 < _s28, _s40, _s28, _r0)
    _s42 = _negative(_add(rate_margin, _s14, _r1), _r1)
    return _s10, _s14, _subtract(steady, _s16, _r4) - _s17, _s41, t + _s41, _result(0.0 < _s42, _subtract(_multiply(_s42, _s42, _r9), _multiply(_multiply(8.0, ceiling, _r7), _add(margin, _s25, _r10), _r7), _r7), _s42, _r0)


def ring_opened(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Windows of the search along a flight, and whether single precision serves for it.

    bounds of the event condition. 186 operations: 24 additions, 16 subtractions, 37 multiplications, 2 divisions, 4 square roots, 1 negation, 4 absolute values, 43 comparisons, 7 conjunctions, 3 disjunctions, 45 selections.
    Returns t, end, searching, low1, high1, low2, high2, latest, sound.
    """
    horizon = _single(horizon)
    x = _single(x)
    y = _single(y)
    z = _single(z)
    vx = _single(vx)
    vy = _single(vy)
    vz = _single(vz)
    extent = _single(extent)
    speed = _single(speed)
    p_ball_radius = _single(p_ball_radius)
    p_ring_radius = _single(p_ring_radius)
    p_wire_radius = _single(p_wire_radius)
    p_gravity = _single(p_gravity)
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18, _r19, _r20, _r21, _r22, _r23, _r24, _r25, _r26, _r27, _r28, _r29, _r30, _r31, _r32, _r33, _r34, _r35, _r36, _r37, _r38, _r39, _r40 = _halves(_room[:41])
    _s0 = _multiply(vz, vz, _r0)
    _s1 = _float32(1.00006103515625) * (p_ball_radius + p_wire_radius)
    _s2 = _float32(2.0) * p_gravity
    _s3 = _multiply(_float32(4.76837158203125e-07), _add(_s0, _multiply(_s2, _add(_absolute(z, _r1), _s1, _r1), _r1), _r1), _r1)
    _s4 = _add(_add(_s0, _multiply(_s2, _add(z, _s1, _r2), _r2), _r2), _s3, _r2)
    _s5 = _float32(1.0) / p_gravity
    _s6 = _sqrt(_s4, _r3)
    _s7 = _multiply(_float32(9.5367431640625e-07), _add(_absolute(vz, _r4), _s6, _r4), _r4)
    _s8 = _float32(0.0) <= _s4
    _s9 = _select(_s8, _multiply(_s5, _subtract(_subtract(vz, _s6, _r2), _s7, _r2), _r2), _float32(_inf), _r5)
    _s10 = _add(_multiply(vx, vx, _r6), _multiply(vy, vy, _r7), _r7)
    _s11 = p_ring_radius + _s1
    _s12 = _s11 * _s11
    _s13 = _multiply(_multiply(_float32(9.5367431640625e-07), _s10, _r6), _add(_s12, _add(_multiply(x, x, _r8), _multiply(y, y, _r9), _r9), _r9), _r6)
    _s14 = _subtract(_multiply(vy, x, _r9), _multiply(vx, y, _r8), _r8)
    _s15 = _multiply(_s14, _s14, _r9)
    _s16 = _subtract(_add(_multiply(_s12, _s10, _r10), _s13, _r10), _s15, _r10)
    _s17 = _add(_multiply(vx, x, _r11), _multiply(vy, y, _r12), _r12)
    _s18 = _sqrt(_s16, _r11)
    _s19 = _multiply(_float32(9.5367431640625e-07), _add(_add(_absolute(_s17, _r13), _absolute(_s14, _r8), _r8), _s18, _r8), _r8)
    _s20 = _divide(_float32(1.0), _s10, _r13)
    _s21 = _float32(0.0) <= _s16
    _s22 = _float32(8.673617379884035e-19) < _s10
    _s23 = _select(_s22, _select(_s21, _multiply(_negative(_add(_add(_s17, _s18, _r10), _s19, _r10), _r10), _s20, _r10), _float32(_inf), _r14), _float32(-_inf), _r15)
    _s24 = _select(_s9 < _s23, _s23, _s9, _r16)
    _s25 = _select(_float32(0.0) < _s24, _s24, _float32(0.0), _r17)
    _s26 = _select(_float32(0.0) < _s25, _s25, _float32(0.0), _r18)
    _s27 = p_ring_radius - _s1
    _s28 = _float32(0.0001220703125) * p_ring_radius
    _s29 = _where(_s27 < _s28, _s28, _s27)
    _s30 = _subtract(_subtract(_multiply(_s10, _s29 * _s29, _r7), _s13, _r7), _s15, _r7)
    _s31 = _sqrt(_select(_s30 < _float32(0.0), _float32(0.0), _s30, _r9), _r9)
    _s32 = _select(_s22, _select(_s21, _multiply(_subtract(_add(_s18, _s19, _r11), _s17, _r11), _s20, _r11), _float32(-_inf), _r6), _float32(_inf), _r19)
    _s33 = _float32(0.0) < _select(_s22, _s30, _float32(0.0), _r20)
    _s34 = _select(_s33, _multiply(_subtract(_subtract(_s19, _s17, _r20), _s31, _r20), _s20, _r20), _s32, _r7)
    _s35 = _subtract(_add(_s0, _multiply(_s2, _subtract(z, _s1, _r21), _r21), _r21), _s3, _r21)
    _s36 = _sqrt(_select(_s35 < _float32(0.0), _float32(0.0), _s35, _r1), _r1)
    _s37 = _select(_s8, _multiply(_s5, _add(_add(vz, _s6, _r3), _s7, _r3), _r3), _float32(-_inf), _r0)
    _s38 = _float32(0.0) < _s35
    _s39 = _select(_s38, _multiply(_s5, _subtract(_add(vz, _s7, _r21), _s36, _r21), _r21), _s37, _r22)
    _s40 = _select(_s34 < _s39, _s34, _s39, _r23)
    _s41 = _multiply(_float32(1.000000238418579), horizon, _r24)
    _s42 = _select(_s40 < _s41, _s40, _s41, _r25)
    _s43 = _s26 < _s42
    _s44 = _select(_s33, _multiply(_subtract(_subtract(_s31, _s17, _r9), _s19, _r9), _s20, _r9), _float32(_inf), _r13)
    _s45 = _select(_s44 < _s34, _s34, _s44, _r8)
    _s46 = _select(_s9 < _s45, _s45, _s9, _r12)
    _s47 = _select(_s32 < _s39, _s32, _s39, _r26)
    _s48 = _select(_s38, _multiply(_s5, _subtract(_add(vz, _s36, _r1), _s7, _r1), _r1), _float32(_inf), _r4)
    _s49 = _select(_s48 < _s39, _s39, _s48, _r27)
    _s50 = _s46 <= _s47
    _s51 = _select(_s50, _s46, _select(_s49 < _s23, _s23, _s49, _r28), _r29)
    _s52 = _result(_float32(0.0) < _s51, _s51, _float32(0.0), _r0)
    _s53 = _select(_float32(0.0) < _s52, _s52, _float32(0.0), _r30)
    _s54 = _select(_s50, _s47, _select(_s34 < _s37, _s34, _s37, _r31), _r32)
    _s55 = _result(_s54 < _s41, _s54, _s41, _r0)
    _s56 = _s53 < _s55
    _s57 = _select(_s49 < _s45, _s45, _s49, _r33)
    _s58 = _result(_float32(0.0) < _s57, _s57, _float32(0.0), _r0)
    _s59 = _select(_float32(0.0) < _s58, _s58, _float32(0.0), _r34)
    _s60 = _select(_s32 < _s37, _s32, _s37, _r35)
    _s61 = _result(_s60 < _s41, _s60, _s41, _r0)
    _s62 = _s59 < _s61
    _s63 = _select(_float32(0.0) < _s40, _s40, _float32(0.0), _r36)
    _s64 = _select(_s63 < _s54, _s54, _s63, _r37)
    _s65 = _select(_s64 < _s60, _s60, _s64, _r38)
    _s66 = _logical_and(_logical_and(_logical_and((_s11 <= (_float32(32.0) * _s29)), (_s11 <= ((_float32(32.0) * p_ball_radius) + (_float32(32.0) * p_wire_radius)))), (_s11 <= _float32(4096.0))), (_float32(0.000244140625) <= _s29))
    return _result(_s43, _s26, _select(_s56, _s53, _select(_s62, _s59, _float32(0.0), _r39), _r40), _r0), _result(_s43, _s42, _select(_s56, _s55, _select(_s62, _s61, _float32(0.0), _r40), _r39), _r0), _logical_or(_logical_or(_logical_or(False, _s62), _s56), _s43), _s52, _s55, _s58, _s61, _result(_s65 < _s41, _s65, _s41, _r0), _logical_and(_logical_and(_logical_and(_logical_and(_s66, (p_gravity <= _float32(4096.0))), (_float32(0.000244140625) <= p_gravity)), (extent <= _float32(4096.0))), (speed <= _float32(4096.0)))


def ring_grain(t: Any, end: Any, leaving: Any, horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, parting: Any, drift: Any, low1: Any, high1: Any, low2: Any, high2: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """What a search in single precision is given, from where it begins.

    running error analysis. 109 operations: 21 additions, 8 subtractions, 55 multiplications, 5 divisions, 1 square root, 5 absolute values, 7 comparisons, 1 conjunction, 6 selections.
    Returns share, t, end, x, y, z, vx, vy, vz, steady, swing, rho_start, ceiling, flat, tilt, jerk, grit, parting, drift, rate_margin, low1, high1, low2, high2, fits.
    """
    t = _single(t)
    end = _single(end)
    leaving = _single(leaving)
    horizon = _single(horizon)
    x = _single(x)
    y = _single(y)
    z = _single(z)
    vx = _single(vx)
    vy = _single(vy)
    vz = _single(vz)
    extent = _single(extent)
    speed = _single(speed)
    parting = _single(parting)
    drift = _single(drift)
    low1 = _single(low1)
    high1 = _single(high1)
    low2 = _single(low2)
    high2 = _single(high2)
    p_ball_radius = _single(p_ball_radius)
    p_ring_radius = _single(p_ring_radius)
    p_wire_radius = _single(p_wire_radius)
    p_gravity = _single(p_gravity)
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12 = _halves(_room[:13])
    _s0 = _float32(0.0) < leaving
    _s1 = _add(speed, _multiply(p_gravity, horizon, _r0), _r0)
    _s2 = p_ball_radius + p_wire_radius
    _s3 = _float32(1.00006103515625) * _s2
    _s4 = p_ring_radius - _s3
    _s5 = _float32(0.0001220703125) * p_ring_radius
    _s6 = _where(_s4 < _s5, _s5, _s4)
    _s7 = _s2 / _s6
    _s8 = _where(_float32(1.0) < _s7, _s7, _float32(1.0))
    _s9 = _multiply(_s1, _s8, _r1)
    _s10 = _add(extent, _multiply(horizon, _s1, _r2), _r2)
    _s11 = _multiply(_float32(5.0), _add(_multiply(_s9, _s10, _r3), _multiply(_s2, _s1, _r4), _r4), _r4)
    _s12 = _divide(_multiply(_float32(0.00390625), parting, _r3), _s11, _r3)
    _s13 = _select(_s12 < _float32(2.9802322387695312e-08), _s12, _float32(2.9802322387695312e-08), _r5)
    _s14 = _result(_s0, _select(_float32(2.842170943040401e-14) < _s13, _s13, _float32(2.842170943040401e-14), _r6), _float32(2.9802322387695312e-08), _r0)
    _s15 = _add(_multiply(_float32(2.0), _multiply(vz, vz, _r7), _r7), _multiply(_float32(4.0) * p_gravity, z, _r8), _r8) + _multiply(_float32(2.0), _add(_multiply(vx, vx, _r7), _multiply(vy, vy, _r9), _r9), _r9)
    _s16 = _subtract(_multiply(vy, x, _r9), _multiply(vx, y, _r8), _r8)
    _s17 = (_float32(2.0) * p_ring_radius) * _multiply(_s16, _s16, _r8)
    _s18 = _float32(1.0) / _s6
    _s19 = _s18 * (_s18 * _s18)
    _s20 = _add(_add((_float32(6.0003662109375) * p_gravity) * _s2, _multiply(_s17, _s19, _r8), _r8), _absolute(_s15, _r9), _r9)
    _s21 = _subtract(horizon, t, _r8)
    _s22 = _multiply(p_gravity, _multiply(_s21, _s21, _r7), _r7)
    _s23 = p_ring_radius + _s3
    _s24 = _add(_multiply(_s10, _s14, _r2), _multiply(_float32(9.5367431640625e-07), _add(_s22, _s23, _r10), _r10), _r10)
    _s25 = _divide(_multiply(_float32(0.5), _multiply(_multiply(_s17, _add(_absolute(vx, _r2), _absolute(vy, _r11), _r11), _r11), _s19, _r11), _r11), _s6, _r11)
    return _s14, _float32(0.0), end - t, x, y, z, vx, vy, vz, _s15, _s17, _sqrt(_add(_multiply(x, x, _r2), _multiply(y, y, _r12), _r12)), _float32(1.0009765625) * _s20, (_float32(5.0048828125) * _s2) * _s24, _result(_s0, _multiply(_float32(1.0009765625), _add(_multiply(_float32(4.76837158203125e-07), _absolute(parting, _r12), _r12), _multiply(_add(_float32(5.684341886080802e-14), _s14, _r2), _s11, _r2), _r2), _r2), _float32(_inf), _r0), _float32(1.0009765625) * _add(_multiply(p_gravity, _add(_multiply(p_gravity, _s21, _r8), _absolute(vz, _r2), _r2), _r2), _s25, _r11), (_float32(7.62939453125e-06) * ((_s23 / _s6) * _s8)) * _s20, parting, drift, _float32(5.0) * _add(_multiply(_multiply(_float32(1.0009765625), _s9, _r1), _s24, _r1), _multiply(_multiply(_add(_float32(2.384185791015625e-07), _s14, _r6), _s2, _r6), _s1, _r6), _r6), low1 - t, high1 - t, low2 - t, high2 - t, _logical_and((_s22 <= ((_float32(128.0) * p_ball_radius) + (_float32(128.0) * p_wire_radius))), (_multiply(leaving, t, _r7) <= _float32(0.0)))


def ring_leap(t: Any, end: Any, rate_margin: Any, ceiling: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, steady: Any, swing: Any, rho_start: Any, flat: Any, tilt: Any, grit: Any, jerk: Any, parting: Any, drift: Any, low1: Any, high1: Any, low2: Any, high2: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Where a search is after a step, in which window, whether surely before a root, and whether it goes on.

    Newton from the left under a curvature bound. 237 operations: 42 additions, 20 subtractions, 82 multiplications, 4 divisions, 2 square roots, 3 negations, 5 absolute values, 30 comparisons, 6 conjunctions, 5 disjunctions, 4 complements, 34 selections.
    Returns t, end, certain, leaping.
    """
    t = _single(t)
    end = _single(end)
    rate_margin = _single(rate_margin)
    ceiling = _single(ceiling)
    x = _single(x)
    y = _single(y)
    z = _single(z)
    vx = _single(vx)
    vy = _single(vy)
    vz = _single(vz)
    steady = _single(steady)
    swing = _single(swing)
    rho_start = _single(rho_start)
    flat = _single(flat)
    tilt = _single(tilt)
    grit = _single(grit)
    jerk = _single(jerk)
    parting = _single(parting)
    drift = _single(drift)
    low1 = _single(low1)
    high1 = _single(high1)
    low2 = _single(low2)
    high2 = _single(high2)
    p_ball_radius = _single(p_ball_radius)
    p_ring_radius = _single(p_ring_radius)
    p_wire_radius = _single(p_wire_radius)
    p_gravity = _single(p_gravity)
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18, _r19, _r20, _r21, _r22, _r23, _r24 = _halves(_room[:25])
    _s0 = _add(tilt, _multiply(grit, t, _r0), _r0)
    _s1 = _multiply(t, _s0, _r1)
    _s2 = _s1 < flat
    _s3 = _multiply(jerk, _multiply(t, t, _r2), _r2)
    _s4 = _logical_and(_s2, (_s3 < rate_margin))
    _s5 = _add(_multiply(vx, vx, _r3), _multiply(vy, vy, _r4), _r4)
    _s6 = _add(x, _multiply(t, vx, _r3), _r3)
    _s7 = _add(y, _multiply(t, vy, _r5), _r5)
    _s8 = _sqrt(_add(_multiply(_s6, _s6, _r6), _multiply(_s7, _s7, _r7), _r7), _r7)
    _s9 = _add(rho_start, _s8, _r6)
    _s10 = _divide(_float32(1.0), _multiply(_s9, _s8, _r8), _r8)
    _s11 = _multiply(_s8, _s10, _r9)
    _s12 = _multiply(_s11, _add(_multiply(t, _s5, _r10), _multiply(_float32(2.0), _add(_multiply(vx, x, _r11), _multiply(vy, y, _r12), _r12), _r12), _r12), _r12)
    _s13 = _subtract(vz, _multiply(_float32(0.5) * p_gravity, t, _r10), _r10)
    _s14 = _add(_add(_multiply(_multiply(_multiply(_float32(2.0), _subtract(rho_start, p_ring_radius, _r11), _r11), _subtract(_s5, _multiply(drift, _s12, _r13), _r13), _r11), _s11, _r11), _multiply(_s12, _s12, _r12), _r12), _multiply(_s13, _s13, _r11), _r11)
    _s15 = _add(parting, _multiply(t, _subtract(_s14, _multiply(p_gravity, z, _r12), _r12), _r12), _r12)
    _s16 = _multiply(_s9, _s10, _r8)
    _s17 = _multiply(_s16, _add(_multiply(vx, _s6, _r3), _multiply(vy, _s7, _r5), _r5), _r5)
    _s18 = _subtract(_s8, p_ring_radius, _r3)
    _s19 = _subtract(vz, _multiply(p_gravity, t, _r6), _r6)
    _s20 = _add(z, _multiply(t, _s13, _r10), _r10)
    _s21 = _select(_s4, _subtract(_multiply(_float32(2.0), _s15, _r11), parting, _r11), _multiply(_float32(2.0), _add(_multiply(_s17, _s18, _r9), _multiply(_s19, _s20, _r13), _r13), _r13), _r9)
    _s22 = _select(_s4, _add(_s3, _multiply(_float32(2.0), _s0, _r0), _r0), rate_margin, _r2)
    _s23 = _negative(_add(_s21, _s22, _r4), _r4)
    _s24 = _select(_s2, _s1, flat, _r14)
    _s25 = p_ball_radius + p_wire_radius
    _s26 = _subtract(_select(_s2, _multiply(t, _s15, _r12), _subtract(_add(_multiply(_s18, _s18, _r3), _multiply(_s20, _s20, _r15), _r15), _s25 * _s25, _r15), _r3), _s24, _r3)
    _s27 = _select(_s26 < _float32(0.0), _float32(0.0), _s26, _r15)
    _s28 = _multiply(_float32(2.0), _add(_multiply(_float32(2.0), _s24, _r12), _s27, _r12), _r12)
    _s29 = _subtract(_s21, _s22, _r2)
    _s30 = _float32(6.0) * p_gravity
    _s31 = _multiply(_s30, _s20, _r0)
    _s32 = _multiply(swing, _multiply(_s16, _multiply(_s16, _s16, _r16), _r16), _r16)
    _s33 = _subtract(_add(_s31, _s32, _r17), steady, _r17)
    _s34 = _s29 < _float32(0.0)
    _s35 = _multiply(_float32(2.0), _s27, _r18)
    _s36 = _select(_float32(0.0) < _select(_float32(0.0) <= _s29, _s27, _float32(0.0), _r19), _float32(_inf), _divide(_select(_s34, _add(_multiply(_float32(8.0), _s24, _r19), _s35, _r19), _multiply(_float32(4.0), _s29, _r20), _r21), _select(_s34, _negative(_s29, _r22), _select(_float32(0.0) < _s33, _s33, _float32(0.0), _r23), _r24), _r21), _r20)
    _s37 = _subtract(end, t, _r19)
    _s38 = _select(_s36 < _s37, _s36, _s37, _r24)
    _s39 = _float32(1.00006103515625) * _s25
    _s40 = _add((_float32(0.0001220703125) * p_ball_radius) + (_float32(0.0001220703125) * p_wire_radius), _add(_multiply(_s38, _select(_s19 < _float32(0.0), _float32(0.0), _s19, _r23), _r23), _s20, _r23), _r23)
    _s41 = _multiply(_s30, _select(_s39 < _s40, _s39, _s40, _r10), _r10)
    _s42 = _multiply(_add(_absolute(vx, _r23), _absolute(vy, _r17), _r17), _s38, _r17)
    _s43 = _subtract(_subtract(_add(_multiply(_s38, _select(_float32(0.0) < _s17, _float32(0.0), _s17, _r23), _r23), _s8, _r23), _multiply(_float32(0.0001220703125), _s42, _r7), _r7), _float32(9.5367431640625e-07) * (p_ring_radius + _s39), _r7)
    _s44 = p_ring_radius - _s39
    _s45 = _float32(0.0001220703125) * p_ring_radius
    _s46 = _where(_s44 < _s45, _s45, _s44)
    _s47 = _divide(_float32(1.0), _select(_s43 < _s46, _s46, _s43, _r23), _r23)
    _s48 = _multiply(swing, _multiply(_s47, _multiply(_s47, _s47, _r7), _r7), _r7)
    _s49 = _absolute(steady, _r23)
    _s50 = _subtract(_add(_add(_s41, _s48, _r5), _multiply(_float32(3.814697265625e-06), _add(_add(_s48, _s49, _r7), _absolute(_s41, _r10), _r10), _r10), _r10), steady, _r10)
    _s51 = _negative(_s19, _r6)
    _s52 = _add(_multiply(_s30, _add((_float32(0.000244140625) * p_ball_radius) + (_float32(0.000244140625) * p_wire_radius), _multiply(_add(_multiply(p_gravity, _s38, _r5), _select(_s51 < _float32(0.0), _float32(0.0), _s51, _r7), _r7), _s38, _r7), _r7), _r7), _multiply(_multiply(_float32(3.0), _multiply(_s32, _s16, _r8), _r8), _s42, _r8), _r8)
    _s53 = _add(steady, _add(_s52, _multiply(_float32(0.000244140625), _add(_add(_s49, _absolute(_s31, _r7), _r7), _s32, _r7), _r7), _r7), _r7)
    _s54 = _subtract(_subtract(_s53, _s31, _r7), _s32, _r7)
    _s55 = _subtract(_multiply(_s23, _s23, _r16), _multiply(_multiply(_float32(8.0), _select(_s28 <= _multiply(_s23, _s38, _r0), _select(_s50 < _s54, _s54, _s50, _r0), ceiling, _r8), _r8), _s28, _r8), _r8)
    _s56 = _float32(0.0) < _select(_float32(0.0) < _s23, _s55, _s23, _r16)
    _s57 = _add(_multiply(_multiply(_float32(2.0), _s50, _r16), _s27, _r16), _multiply(_s29, _s29, _r15), _r15)
    _s58 = _sqrt(_s57, _r16)
    _s59 = _select(_float32(0.0) <= _s57, _divide(_select(_s34, _s35, _add(_s58, _s29, _r15), _r8), _select(_s34, _subtract(_s58, _s29, _r16), _select(_float32(0.0) < _s50, _s50, _float32(0.0), _r2), _r4), _r8), _float32(_inf), _r15)
    _s60 = _select(_s59 < _s38, _s59, _s38, _r4)
    _s61 = _add(t, _s60, _r2)
    _s62 = _logical_and(_logical_not(_s56), _logical_or(_logical_and((_s21 < _float32(0.0)), (_s26 <= _s24)), _logical_and((t < end), _logical_not((t < _s61)))))
    _s63 = _logical_not(_logical_or(_s56, _s62))
    _s64 = _logical_and(_s63, (_s37 <= _s60))
    _s65 = _select(end < low1, low1, end, _r4)
    _s66 = _s65 < high1
    _s67 = _select(end < low2, low2, end, _r15)
    _s68 = _s67 < high2
    return _result(_s64, _select(_s66, _s65, _select(_s68, _s67, _float32(_inf), _r8), _r24), _select(_s62, t, _s61, _r19), _r0), _result(_s64, _select(_s66, high1, _select(_s68, high2, end, _r19), _r24), end, _r0), _s56, _logical_and(_s63, _logical_or(_logical_not(_s64), _logical_or(_logical_or(False, _s68), _s66)))


def ring_started(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ring_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Distance from the axis, its rate and that of the gap, at the start of a flight.

    Table 2. 13 operations: 3 additions, 1 subtraction, 7 multiplications, 1 division, 1 square root.
    Returns rho_start, parting, drift.
    """
    _r0, _r1 = _room[:2]
    _s0 = _sqrt(_add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1))
    _s1 = _add(_multiply(vx, x, _r1), _multiply(vy, y, _r0), _r0) / _s0
    return _s0, 2.0 * _add(_multiply(vz, z, _r0), _multiply(_s1, _subtract(_s0, p_ring_radius, _r1), _r1), _r1), _s1


def ring_lost(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Positive where the bounds of the search do not hold.

    bounds of the event condition. 26 operations: 5 additions, 4 subtractions, 10 multiplications, 1 division, 2 square roots, 2 comparisons, 2 selections.
    Returns lost.
    """
    _r0, _r1 = _room[:2]
    _s0 = (0.000244140625 * p_ring_radius) - (p_ring_radius - (p_ball_radius + p_wire_radius))
    _s1 = 1.0 / p_gravity
    _s2 = _multiply(_sqrt(2.0), _sqrt(_multiply(_s1, _add(_add(2.0 * p_ball_radius, extent, _r0), 2.0 * p_wire_radius, _r0), _r0), _r0), _r0)
    _s3 = _add(_s2, _multiply(_multiply(2.0, speed, _r1), _s1, _r1), _r1)
    _s4 = _subtract(_subtract(_add(position_error, _multiply(velocity_error, _select(_s3 < horizon, _s3, horizon, _r0), _r0), _r0), 1.52587890625e-05 * p_ball_radius, _r0), 1.52587890625e-05 * p_wire_radius, _r0)
    return _result(_s0 < _s4, _s4, _s0, _r0),


def ring_beside(p_ball_radius: Any, p_ring_radius: Any, vx: Any, vy: Any, vz: Any, p_wire_radius: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The distance, its rate, and how fast it bends down at most, by the squared speed.

    Table 2. 33 operations: 5 additions, 5 subtractions, 15 multiplications, 4 divisions, 2 square roots, 1 comparison, 1 selection.
    Returns gap, nearing, dent.
    """
    _r0, _r1, _r2, _r3, _r4, _r5 = _room[:6]
    _s0 = _sqrt(_add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1), _r1)
    _s1 = _subtract(_s0, p_ring_radius, _r0)
    _s2 = _sqrt(_add(_multiply(z, z, _r2), _multiply(_s1, _s1, _r0), _r0), _r0)
    _s3 = 2.0 * p_ring_radius
    _s4 = _add(_multiply(_multiply(2.0, vz, _r2), z, _r2), _divide(_multiply(_multiply(0.5, _subtract(_multiply(2.0, _s0, _r3), _s3, _r3), _r3), _add(_multiply(_multiply(2.0, vx, _r4), x, _r4), _multiply(_multiply(2.0, vy, _r5), y, _r5), _r5), _r3), _s0, _r3), _r3)
    _s5 = _subtract(_divide(_s3, _s0, _r1), 1.0, _r1)
    return _subtract(_s2, p_ball_radius, _r2) - p_wire_radius, _multiply(0.5, _s4, _r3) / _s2, _select(0.0 < _s5, _s5, 0.0, _r3) / (p_ball_radius + p_wire_radius)


def ring_closing(p_ball_radius: Any, nx: Any, ny: Any, nz: Any, p_ring_radius: Any, rolled_x: Any, rolled_y: Any, rolled_z: Any, thrust_x: Any, thrust_y: Any, thrust_z: Any, p_wire_radius: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The distance, its rate and its second derivative, of a ball that rolls on something else.

    derivatives of Table 2's distance. 75 operations: 12 additions, 5 subtractions, 48 multiplications, 8 divisions, 2 square roots.
    Returns gap, nearing, swerve, facing.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10 = _room[:11]
    _s0 = _add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1)
    _s1 = _sqrt(_s0, _r0)
    _s2 = _subtract(_s1, p_ring_radius, _r2)
    _s3 = _add(_multiply(z, z, _r3), _multiply(_s2, _s2, _r4), _r4)
    _s4 = _sqrt(_s3, _r3)
    _s5 = _add(_multiply(_multiply(2.0, rolled_x, _r5), x, _r5), _multiply(_multiply(2.0, rolled_y, _r6), y, _r6), _r6)
    _s6 = _divide(_multiply(0.5, _s5, _r5), _s1, _r5)
    _s7 = _add(_multiply(_multiply(2.0, rolled_z, _r7), z, _r7), _multiply(_multiply(2.0, _s6, _r8), _s2, _r8), _r8)
    _s8 = _divide(_multiply(0.5, _add(_add(_multiply(2.0, _multiply(rolled_x, rolled_x, _r7), _r7), _multiply(_multiply(2.0, thrust_x, _r9), x, _r9), _r9), _add(_multiply(2.0, _multiply(rolled_y, rolled_y, _r7), _r7), _multiply(_multiply(2.0, thrust_y, _r10), y, _r10), _r10), _r10), _r10), _s1, _r10)
    _s9 = _add(_multiply(_multiply(2.0, _s2, _r9), _subtract(_s8, _divide(_multiply(0.25, _multiply(_s5, _s5, _r6), _r6), _multiply(_s1, _s0, _r1), _r6), _r6), _r9), _multiply(2.0, _multiply(_s6, _s6, _r5), _r5), _r5)
    _s10 = _divide(_multiply(0.5, _add(_add(_multiply(2.0, _multiply(rolled_z, rolled_z, _r9), _r9), _multiply(_multiply(2.0, thrust_z, _r6), z, _r6), _r6), _s9, _r5), _r5), _s4, _r5)
    _s11 = _multiply(2.0, _divide(_multiply(0.5, _add(_multiply(_multiply(2.0, nx, _r6), x, _r6), _multiply(_multiply(2.0, ny, _r9), y, _r9), _r9), _r9), _s1, _r9), _r9)
    return _subtract(_s4, p_ball_radius, _r0) - p_wire_radius, _multiply(0.5, _s7, _r0) / _s4, _s10 - _divide(_multiply(0.25, _multiply(_s7, _s7, _r8), _r8), _multiply(_s4, _s3, _r4), _r8), _multiply(0.5, _add(_multiply(_multiply(2.0, nz, _r8), z, _r8), _multiply(_s11, _s2, _r9), _r9), _r9) / _s4


def ring_off(p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The distance.

    Table 2. 11 operations: 2 additions, 3 subtractions, 4 multiplications, 2 square roots.
    Returns gap.
    """
    _r0, _r1 = _room[:2]
    _s0 = _subtract(_sqrt(_add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1), _r1), p_ring_radius, _r1)
    return _subtract(_sqrt(_add(_multiply(z, z, _r0), _multiply(_s0, _s0, _r1), _r1), _r1), p_ball_radius, _r1) - p_wire_radius,


def ring_tube(p_ball_radius: Any, p_wire_radius: Any) -> tuple[Any, ...]:
    """What a ball that stays on it rolls on.

    Table 2. 2 operations: 1 addition, 1 division.
    Returns bent_x, bent_y, bent_z, per_reach.
    """
    return 1.0, 1.0, 1.0, 1.0 / (p_ball_radius + p_wire_radius)


def ring_turning(p_ball_radius: Any, p_ring_radius: Any, rolled_x: Any, rolled_y: Any, rolled_z: Any, p_wire_radius: Any, x: Any, y: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The rate at which the normal turns.

    derivative of Table 2's normal. 32 operations: 6 additions, 1 subtraction, 20 multiplications, 3 divisions, 1 square root, 1 negation.
    Returns turning_x, turning_y, turning_z.
    """
    _r0, _r1, _r2, _r3, _r4, _r5 = _room[:6]
    _s0 = 1.0 / (p_ball_radius + p_wire_radius)
    _s1 = _sqrt(_add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1), _r1)
    _s2 = _subtract(_s1, p_ring_radius, _r0)
    _s3 = _divide(1.0, _s1, _r2)
    _s4 = _multiply(_multiply(_s0, _s2, _r3), _s3, _r3)
    _s5 = _divide(_multiply(0.5, _add(_multiply(_multiply(2.0, rolled_x, _r4), x, _r4), _multiply(_multiply(2.0, rolled_y, _r5), y, _r5), _r5), _r5), _s1, _r5)
    _s6 = _add(_multiply(_multiply(_s5, _s0, _r1), _s3, _r1), _multiply(_multiply(_negative(_multiply(_s5, _multiply(_s3, _s3, _r2), _r2), _r2), _s0, _r2), _s2, _r2), _r2)
    return _multiply(rolled_x, _s4, _r1) + _multiply(x, _s6, _r0), _multiply(rolled_y, _s4, _r3) + _multiply(y, _s6, _r2), rolled_z * _s0


def ring_parting(p_gravity: Any, p_ring_radius: Any, vx: Any, vy: Any, vz: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The second to the fourth derivative of the distance along a flight.

    derivatives of Table 2's distance. 120 operations: 14 additions, 11 subtractions, 74 multiplications, 18 divisions, 2 square roots, 1 negation.
    Returns lift, surge, snap.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18 = _room[:19]
    _s0 = _add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1)
    _s1 = _sqrt(_s0, _r0)
    _s2 = _subtract(_s1, p_ring_radius, _r2)
    _s3 = _add(_multiply(z, z, _r3), _multiply(_s2, _s2, _r4), _r4)
    _s4 = _sqrt(_s3, _r3)
    _s5 = _add(_multiply(2.0, _multiply(vx, vx, _r5), _r5), _multiply(2.0, _multiply(vy, vy, _r6), _r6), _r6)
    _s6 = _multiply(_s1, _s0, _r5)
    _s7 = _add(_multiply(_multiply(2.0, vx, _r7), x, _r7), _multiply(_multiply(2.0, vy, _r8), y, _r8), _r8)
    _s8 = _multiply(_s7, _s7, _r7)
    _s9 = _subtract(_divide(_multiply(0.5, _s5, _r9), _s1, _r9), _divide(_multiply(0.25, _s8, _r10), _s6, _r10), _r10)
    _s10 = _multiply(2.0, _s2, _r9)
    _s11 = _divide(_multiply(0.5, _s7, _r11), _s1, _r11)
    _s12 = _add(_subtract(_multiply(2.0, _multiply(vz, vz, _r12), _r12), _multiply(2.0 * p_gravity, z, _r13), _r13), _add(_multiply(_s10, _s9, _r12), _multiply(2.0, _multiply(_s11, _s11, _r14), _r14), _r14), _r14)
    _s13 = _multiply(_s4, _s3, _r13)
    _s14 = _add(_multiply(_multiply(2.0, vz, _r12), z, _r12), _multiply(_multiply(2.0, _s11, _r15), _s2, _r15), _r15)
    _s15 = _multiply(_s14, _s14, _r12)
    _s16 = _multiply(_s3, _s3, _r4)
    _s17 = _multiply(_s4, _s16, _r2)
    _s18 = _multiply(_s0, _s0, _r1)
    _s19 = _multiply(_s1, _s18, _r0)
    _s20 = _subtract(_divide(_multiply(0.375, _multiply(_s7, _s8, _r16), _r16), _s19, _r16), _divide(_multiply(_multiply(0.75, _s5, _r17), _s7, _r17), _s6, _r17), _r17)
    _s21 = _add(_negative(_multiply(6.0 * p_gravity, vz, _r16), _r16), _add(_multiply(_multiply(6.0, _s11, _r8), _s9, _r8), _multiply(_s10, _s20, _r18), _r18), _r18)
    _s22 = _multiply(_s10, _subtract(_subtract(_divide(_multiply(_multiply(2.25, _s5, _r16), _s8, _r16), _s19, _r16), _divide(_multiply(0.75, _multiply(_s5, _s5, _r6), _r6), _s6, _r6), _r6), _divide(_multiply(0.9375, _multiply(_s8, _s8, _r7), _r7), _multiply(_s6, _s18, _r1), _r7), _r7), _r7)
    _s23 = _multiply(0.5, _add(6.0 * (p_gravity * p_gravity), _add(_add(_multiply(_multiply(8.0, _s11, _r11), _s20, _r11), _s22, _r7), _multiply(6.0, _multiply(_s9, _s9, _r10), _r10), _r10), _r10), _r10)
    _s24 = _subtract(_subtract(_add(_divide(_s23, _s4, _r10), _divide(_multiply(_multiply(2.25, _s15, _r7), _s12, _r7), _s17, _r7), _r7), _divide(_multiply(0.9375, _multiply(_s15, _s15, _r10), _r10), _multiply(_s13, _s16, _r4), _r10), _r10), _divide(_multiply(0.75, _multiply(_s12, _s12, _r7), _r7), _s13, _r7), _r7)
    return _divide(_multiply(0.5, _s12, _r10), _s4, _r10) - _divide(_multiply(0.25, _s15, _r4), _s13, _r4), _add(_divide(_multiply(0.375, _multiply(_s14, _s15, _r12), _r12), _s17, _r12), _divide(_multiply(0.5, _s21, _r2), _s4, _r2), _r2) - _divide(_multiply(_multiply(0.75, _s14, _r12), _s12, _r12), _s13, _r12), _s24 - _divide(_multiply(_s21, _s14, _r18), _s13, _r18)


def ring_round_start(p_ball_radius: Any, p_ring_radius: Any, vx: Any, vy: Any, vz: Any, p_wire_radius: Any, wx: Any, wy: Any, wz: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The constant terms, in the ring's coordinates.

    Routh's equations. 36 operations: 7 additions, 3 subtractions, 20 multiplications, 4 divisions, 2 square roots.
    Returns cosine_0, sine_0, climb_0, along_0, turn_rate_0, cos_0, sin_0, near_0.
    """
    _r0, _r1, _r2, _r3 = _room[:4]
    _s0 = _sqrt(_add(_multiply(x, x, _r0), _multiply(y, y, _r1), _r1), _r1)
    _s1 = _subtract(_s0, p_ring_radius, _r0)
    _s2 = _divide(1.0, _sqrt(_add(_multiply(z, z, _r2), _multiply(_s1, _s1, _r3), _r3), _r3), _r3)
    _s3 = _s1 * _s2
    _s4 = z * _s2
    _s5 = p_ball_radius + p_wire_radius
    _s6 = _divide(1.0, _s0, _r1)
    _s7 = x * _s6
    _s8 = y * _s6
    return _s3, _s4, _subtract(_multiply(vz, _s3, _r1), _multiply(_s4, _add(_multiply(vx, _s7, _r3), _multiply(vy, _s8, _r0), _r0), _r0), _r0) / _s5, _multiply(vy, _s7, _r0) - _multiply(vx, _s8, _r1), p_ball_radius * _add(_multiply(wz, _s4, _r1), _multiply(_s3, _add(_multiply(wx, _s7, _r0), _multiply(wy, _s8, _r3), _r3), _r3), _r3), _s7, _s8, 1.0 / _add(p_ring_radius, _multiply(_s3, _s5, _r3), _r3)


def ring_round_moved(along_0: Any, along_1: Any, along_10: Any, along_11: Any, along_12: Any, along_2: Any, along_3: Any, along_4: Any, along_5: Any, along_6: Any, along_7: Any, along_8: Any, along_9: Any, p_ball_radius: Any, climb_0: Any, climb_1: Any, climb_10: Any, climb_11: Any, climb_12: Any, climb_2: Any, climb_3: Any, climb_4: Any, climb_5: Any, climb_6: Any, climb_7: Any, climb_8: Any, climb_9: Any, cos_0: Any, cos_1: Any, cos_10: Any, cos_11: Any, cos_12: Any, cos_2: Any, cos_3: Any, cos_4: Any, cos_5: Any, cos_6: Any, cos_7: Any, cos_8: Any, cos_9: Any, cosine_0: Any, cosine_1: Any, cosine_10: Any, cosine_11: Any, cosine_12: Any, cosine_2: Any, cosine_3: Any, cosine_4: Any, cosine_5: Any, cosine_6: Any, cosine_7: Any, cosine_8: Any, cosine_9: Any, p_ring_radius: Any, sin_0: Any, sin_1: Any, sin_10: Any, sin_11: Any, sin_12: Any, sin_2: Any, sin_3: Any, sin_4: Any, sin_5: Any, sin_6: Any, sin_7: Any, sin_8: Any, sin_9: Any, sine_0: Any, sine_1: Any, sine_10: Any, sine_11: Any, sine_12: Any, sine_2: Any, sine_3: Any, sine_4: Any, sine_5: Any, sine_6: Any, sine_7: Any, sine_8: Any, sine_9: Any, t: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_10: Any, turn_rate_11: Any, turn_rate_12: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, turn_rate_5: Any, turn_rate_6: Any, turn_rate_7: Any, turn_rate_8: Any, turn_rate_9: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Where a ball that rolls on the ring is at time t.

    Routh's equations. 214 operations: 91 additions, 3 subtractions, 114 multiplications, 3 divisions, 2 square roots, 1 negation.
    Returns x, y, z, vx, vy, vz, wx, wy, wz, climb.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10 = _room[:11]
    _s0 = _add(cos_9, _multiply(t, _add(cos_10, _multiply(t, _add(cos_11, _multiply(cos_12, t, _r0), _r0), _r0), _r0), _r0), _r0)
    _s1 = _add(cos_6, _multiply(t, _add(cos_7, _multiply(t, _add(cos_8, _multiply(t, _s0, _r0), _r0), _r0), _r0), _r0), _r0)
    _s2 = _add(cos_3, _multiply(t, _add(cos_4, _multiply(t, _add(cos_5, _multiply(t, _s1, _r0), _r0), _r0), _r0), _r0), _r0)
    _s3 = _add(cos_0, _multiply(t, _add(cos_1, _multiply(t, _add(cos_2, _multiply(t, _s2, _r0), _r0), _r0), _r0), _r0), _r0)
    _s4 = _add(sin_9, _multiply(t, _add(sin_10, _multiply(t, _add(sin_11, _multiply(sin_12, t, _r1), _r1), _r1), _r1), _r1), _r1)
    _s5 = _add(sin_6, _multiply(t, _add(sin_7, _multiply(t, _add(sin_8, _multiply(t, _s4, _r1), _r1), _r1), _r1), _r1), _r1)
    _s6 = _add(sin_3, _multiply(t, _add(sin_4, _multiply(t, _add(sin_5, _multiply(t, _s5, _r1), _r1), _r1), _r1), _r1), _r1)
    _s7 = _add(sin_0, _multiply(t, _add(sin_1, _multiply(t, _add(sin_2, _multiply(t, _s6, _r1), _r1), _r1), _r1), _r1), _r1)
    _s8 = _divide(1.0, _sqrt(_add(_multiply(_s3, _s3, _r2), _multiply(_s7, _s7, _r3), _r3), _r3), _r3)
    _s9 = _multiply(_s3, _s8, _r0)
    _s10 = _add(cosine_9, _multiply(t, _add(cosine_10, _multiply(t, _add(cosine_11, _multiply(cosine_12, t, _r2), _r2), _r2), _r2), _r2), _r2)
    _s11 = _add(cosine_6, _multiply(t, _add(cosine_7, _multiply(t, _add(cosine_8, _multiply(t, _s10, _r2), _r2), _r2), _r2), _r2), _r2)
    _s12 = _add(cosine_3, _multiply(t, _add(cosine_4, _multiply(t, _add(cosine_5, _multiply(t, _s11, _r2), _r2), _r2), _r2), _r2), _r2)
    _s13 = _add(cosine_0, _multiply(t, _add(cosine_1, _multiply(t, _add(cosine_2, _multiply(t, _s12, _r2), _r2), _r2), _r2), _r2), _r2)
    _s14 = _add(sine_9, _multiply(t, _add(sine_10, _multiply(t, _add(sine_11, _multiply(sine_12, t, _r4), _r4), _r4), _r4), _r4), _r4)
    _s15 = _add(sine_6, _multiply(t, _add(sine_7, _multiply(t, _add(sine_8, _multiply(t, _s14, _r4), _r4), _r4), _r4), _r4), _r4)
    _s16 = _add(sine_3, _multiply(t, _add(sine_4, _multiply(t, _add(sine_5, _multiply(t, _s15, _r4), _r4), _r4), _r4), _r4), _r4)
    _s17 = _add(sine_0, _multiply(t, _add(sine_1, _multiply(t, _add(sine_2, _multiply(t, _s16, _r4), _r4), _r4), _r4), _r4), _r4)
    _s18 = _divide(1.0, _sqrt(_add(_multiply(_s13, _s13, _r5), _multiply(_s17, _s17, _r6), _r6), _r6), _r6)
    _s19 = _multiply(_s13, _s18, _r2)
    _s20 = p_ball_radius + p_wire_radius
    _s21 = _add(p_ring_radius, _multiply(_s19, _s20, _r5), _r5)
    _s22 = _multiply(_s7, _s8, _r3)
    _s23 = _multiply(_s17, _s18, _r6)
    _s24 = _add(climb_9, _multiply(t, _add(climb_10, _multiply(t, _add(climb_11, _multiply(climb_12, t, _r4), _r4), _r4), _r4), _r4), _r4)
    _s25 = _add(climb_6, _multiply(t, _add(climb_7, _multiply(t, _add(climb_8, _multiply(t, _s24, _r4), _r4), _r4), _r4), _r4), _r4)
    _s26 = _add(climb_3, _multiply(t, _add(climb_4, _multiply(t, _add(climb_5, _multiply(t, _s25, _r4), _r4), _r4), _r4), _r4), _r4)
    _s27 = climb_0 + _multiply(t, _add(climb_1, _multiply(t, _add(climb_2, _multiply(t, _s26, _r4), _r4), _r4), _r4), _r4)
    _s28 = _multiply(_s20, _s27, _r4)
    _s29 = _negative(_multiply(_s28, _s23, _r1), _r1)
    _s30 = _add(along_9, _multiply(t, _add(along_10, _multiply(t, _add(along_11, _multiply(along_12, t, _r7), _r7), _r7), _r7), _r7), _r7)
    _s31 = _add(along_6, _multiply(t, _add(along_7, _multiply(t, _add(along_8, _multiply(t, _s30, _r7), _r7), _r7), _r7), _r7), _r7)
    _s32 = _add(along_3, _multiply(t, _add(along_4, _multiply(t, _add(along_5, _multiply(t, _s31, _r7), _r7), _r7), _r7), _r7), _r7)
    _s33 = _add(along_0, _multiply(t, _add(along_1, _multiply(t, _add(along_2, _multiply(t, _s32, _r7), _r7), _r7), _r7), _r7), _r7)
    _s34 = 1.0 / p_ball_radius
    _s35 = _add(turn_rate_9, _multiply(t, _add(turn_rate_10, _multiply(t, _add(turn_rate_11, _multiply(t, turn_rate_12, _r8), _r8), _r8), _r8), _r8), _r8)
    _s36 = _add(turn_rate_6, _multiply(t, _add(turn_rate_7, _multiply(t, _add(turn_rate_8, _multiply(t, _s35, _r8), _r8), _r8), _r8), _r8), _r8)
    _s37 = _add(turn_rate_3, _multiply(t, _add(turn_rate_4, _multiply(t, _add(turn_rate_5, _multiply(t, _s36, _r8), _r8), _r8), _r8), _r8), _r8)
    _s38 = _add(turn_rate_0, _multiply(t, _add(turn_rate_1, _multiply(t, _add(turn_rate_2, _multiply(t, _s37, _r8), _r8), _r8), _r8), _r8), _r8)
    _s39 = _subtract(_multiply(_s19, _s38, _r9), _multiply(_s23, _s33, _r10), _r10)
    return _s9 * _s21, _s22 * _s21, _s23 * _s20, _multiply(_s29, _s9, _r5) - _multiply(_s22, _s33, _r9), _multiply(_s29, _s22, _r1) + _multiply(_s9, _s33, _r9), _s28 * _s19, _s34 * _add(_multiply(_s28, _s22, _r9), _multiply(_s9, _s39, _r1), _r1), _s34 * _subtract(_multiply(_s22, _s39, _r10), _multiply(_s28, _s9, _r4), _r4), _s34 * _add(_multiply(_s19, _s33, _r7), _multiply(_s23, _s38, _r8), _r8), _s27


def ring_round_pace(along_0: Any, along_1: Any, along_10: Any, along_11: Any, along_12: Any, along_2: Any, along_3: Any, along_4: Any, along_5: Any, along_6: Any, along_7: Any, along_8: Any, along_9: Any, p_ball_radius: Any, climb_0: Any, climb_1: Any, climb_10: Any, climb_11: Any, climb_12: Any, climb_2: Any, climb_3: Any, climb_4: Any, climb_5: Any, climb_6: Any, climb_7: Any, climb_8: Any, climb_9: Any, cos_0: Any, cos_12: Any, cosine_0: Any, cosine_12: Any, force_0: Any, force_1: Any, force_10: Any, force_11: Any, force_2: Any, force_3: Any, force_4: Any, force_5: Any, force_6: Any, force_7: Any, force_8: Any, force_9: Any, p_gravity: Any, omega_0: Any, p_ring_radius: Any, sin_0: Any, sin_12: Any, sine_0: Any, sine_12: Any, turn_rate_0: Any, turn_rate_11: Any, turn_rate_12: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """A step of the series, and bounds of the motion in it.

    Routh's equations. 268 operations: 77 additions, 4 subtractions, 126 multiplications, 6 divisions, 7 square roots, 1 negation, 43 absolute values, 2 comparisons, 2 selections.
    Returns stride, strongest, fastest, sway, force, force_rate, force_bend, brace, vx_1, vy_1, vz_1.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18 = _room[:19]
    _s0 = _absolute(climb_0, _r0)
    _s1 = p_ball_radius + p_wire_radius
    _s2 = _absolute(along_0, _r1)
    _s3 = _add(_multiply(_s0, _s1, _r2), _add(_s2, _absolute(turn_rate_0, _r3), _r3), _r3)
    _s4 = _add(0.015625 * p_gravity, _s3, _r2)
    _s5 = _absolute(climb_11, _r4)
    _s6 = _absolute(along_11, _r5)
    _s7 = _absolute(climb_12, _r6)
    _s8 = _absolute(along_12, _r7)
    _s9 = _add(_multiply(_multiply(0.25, _add(_multiply(_s5, _s1, _r8), _add(_s6, _absolute(turn_rate_11, _r9), _r9), _r9), _r9), _add(_divide(_s3, _s1, _r3), _sqrt((p_gravity / _s1)), _r3), _r9), _add(_multiply(_s7, _s1, _r3), _add(_s8, _absolute(turn_rate_12, _r8), _r8), _r8), _r8)
    _s10 = _multiply(_s4, _add(_add(_add(_absolute(cos_12, _r9), _absolute(cosine_12, _r3), _r3), _absolute(sin_12, _r9), _r9), _absolute(sine_12, _r3), _r3), _r3)
    _s11 = _sqrt(_sqrt(_divide(_multiply(1.7763568394002505e-15, _s4, _r2), _select(_s9 < _s10, _s10, _s9, _r9), _r2), _r2), _r2)
    _s12 = _sqrt(_sqrt(_s11, _r9), _r9)
    _s13 = _multiply(_s12, _sqrt(_sqrt(_s12, _r3), _r3), _r3)
    _s14 = _add(_divide(_s11, _multiply(3.0, _multiply(_s13, _s13, _r9), _r9), _r9), _multiply(0.6666666666666666, _s13, _r3), _r3)
    _s15 = _add(_divide(_s11, _multiply(3.0, _multiply(_s14, _s14, _r9), _r9), _r9), _multiply(0.6666666666666666, _s14, _r3), _r3)
    _s16 = _result(_s15 < 0.0625, _s15, 0.0625, _r0)
    _s17 = _absolute(climb_10, _r9)
    _s18 = _multiply(_add(_multiply(_add(_multiply(_multiply(12.0, _s7, _r2), _s16, _r2), _multiply(11.0, _s5, _r8), _r8), _s16, _r8), _multiply(10.0, _s17, _r2), _r2), _s16, _r2)
    _s19 = _absolute(climb_9, _r8)
    _s20 = _absolute(climb_8, _r10)
    _s21 = _absolute(climb_7, _r11)
    _s22 = _add(_multiply(_add(_multiply(_add(_s18, _multiply(9.0, _s19, _r12), _r12), _s16, _r12), _multiply(8.0, _s20, _r2), _r2), _s16, _r2), _multiply(7.0, _s21, _r12), _r12)
    _s23 = _absolute(climb_6, _r2)
    _s24 = _absolute(climb_5, _r13)
    _s25 = _absolute(climb_4, _r14)
    _s26 = _add(_multiply(_add(_multiply(_add(_multiply(_s22, _s16, _r12), _multiply(6.0, _s23, _r15), _r15), _s16, _r15), _multiply(5.0, _s24, _r12), _r12), _s16, _r12), _multiply(4.0, _s25, _r15), _r15)
    _s27 = _absolute(climb_3, _r12)
    _s28 = _absolute(climb_2, _r16)
    _s29 = _absolute(climb_1, _r17)
    _s30 = _add(_multiply(_add(_multiply(_add(_multiply(_s26, _s16, _r15), _multiply(3.0, _s27, _r18), _r18), _s16, _r18), _multiply(2.0, _s28, _r15), _r15), _s16, _r15), _s29, _r15)
    _s31 = _add(_multiply(_add(_multiply(_add(_multiply(_s7, _s16, _r6), _s5, _r6), _s16, _r6), _s17, _r6), _s16, _r6), _s19, _r6)
    _s32 = _add(_multiply(_add(_multiply(_add(_multiply(_s31, _s16, _r6), _s20, _r6), _s16, _r6), _s21, _r6), _s16, _r6), _s23, _r6)
    _s33 = _add(_multiply(_add(_multiply(_add(_multiply(_s32, _s16, _r6), _s24, _r6), _s16, _r6), _s25, _r6), _s16, _r6), _s27, _r6)
    _s34 = _add(_multiply(_add(_multiply(_add(_multiply(_s33, _s16, _r6), _s28, _r6), _s16, _r6), _s29, _r6), _s16, _r6), _s0, _r6)
    _s35 = _s1 * _add(_s30, _multiply(_s34, _s34, _r0), _r0)
    _s36 = _absolute(along_10, _r0)
    _s37 = _absolute(along_9, _r15)
    _s38 = _add(_multiply(_add(_multiply(_add(_multiply(_s8, _s16, _r17), _s6, _r17), _s16, _r17), _s36, _r17), _s16, _r17), _s37, _r17)
    _s39 = _absolute(along_8, _r16)
    _s40 = _absolute(along_7, _r12)
    _s41 = _absolute(along_6, _r14)
    _s42 = _add(_multiply(_add(_multiply(_add(_multiply(_s38, _s16, _r17), _s39, _r17), _s16, _r17), _s40, _r17), _s16, _r17), _s41, _r17)
    _s43 = _absolute(along_5, _r13)
    _s44 = _absolute(along_4, _r2)
    _s45 = _absolute(along_3, _r11)
    _s46 = _add(_multiply(_add(_multiply(_add(_multiply(_s42, _s16, _r17), _s43, _r17), _s16, _r17), _s44, _r17), _s16, _r17), _s45, _r17)
    _s47 = _absolute(along_2, _r10)
    _s48 = _absolute(along_1, _r8)
    _s49 = _add(_multiply(_add(_multiply(_add(_multiply(_s46, _s16, _r17), _s47, _r17), _s16, _r17), _s48, _r17), _s16, _r17), _s2, _r17)
    _s50 = _multiply(_s1, _s34, _r6) + _s49
    _s51 = _multiply(_add(_multiply(_add(_multiply(_multiply(12.0, _s8, _r7), _s16, _r7), _multiply(11.0, _s6, _r5), _r5), _s16, _r5), _multiply(10.0, _s36, _r0), _r0), _s16, _r0)
    _s52 = _add(_multiply(_add(_multiply(_add(_s51, _multiply(9.0, _s37, _r15), _r15), _s16, _r15), _multiply(8.0, _s39, _r16), _r16), _s16, _r16), _multiply(7.0, _s40, _r12), _r12)
    _s53 = _add(_multiply(_add(_multiply(_add(_multiply(_s52, _s16, _r12), _multiply(6.0, _s41, _r14), _r14), _s16, _r14), _multiply(5.0, _s43, _r13), _r13), _s16, _r13), _multiply(4.0, _s44, _r2), _r2)
    _s54 = _add(_multiply(_add(_multiply(_add(_multiply(_s53, _s16, _r2), _multiply(3.0, _s45, _r11), _r11), _s16, _r11), _multiply(2.0, _s47, _r10), _r10), _s16, _r10), _s48, _r10)
    _s55 = _s35 + _add(_multiply(_multiply(_s49, 1.0 / (p_ring_radius - _s1), _r17), _s50, _r17), _s54, _r10)
    _s56 = _add(_multiply(_add(_multiply(_multiply(110.0, _absolute(force_11, _r10), _r10), _s16, _r10), _multiply(90.0, _absolute(force_10, _r17), _r17), _r17), _s16, _r17), _multiply(72.0, _absolute(force_9, _r10), _r10), _r10)
    _s57 = _multiply(_add(_multiply(_add(_multiply(_s56, _s16, _r10), _multiply(56.0, _absolute(force_8, _r17), _r17), _r17), _s16, _r17), _multiply(42.0, _absolute(force_7, _r10), _r10), _r10), _s16, _r10)
    _s58 = _multiply(_add(_multiply(_add(_s57, _multiply(30.0, _absolute(force_6, _r17), _r17), _r17), _s16, _r17), _multiply(20.0, _absolute(force_5, _r10), _r10), _r10), _s16, _r10)
    _s59 = _multiply(_add(_multiply(_add(_s58, _multiply(12.0, _absolute(force_4, _r17), _r17), _r17), _s16, _r17), _multiply(6.0, _absolute(force_3, _r10), _r10), _r10), _s16, _r10)
    _s60 = _multiply(_multiply(climb_0, climb_0, _r3), _s1, _r3)
    _s61 = _negative(_add(_add(_multiply(along_0, omega_0, _r17), _multiply(cosine_0, _s60, _r8), _r8), _multiply(_multiply(climb_1, sine_0, _r17), _s1, _r17), _r17), _r17)
    _s62 = _subtract(along_1, _multiply(omega_0, _multiply(_multiply(climb_0, sine_0, _r8), _s1, _r8), _r8), _r8)
    return _s16, _s55, _s50, _s35, force_0, force_1, _s59 + _multiply(2.0, _absolute(force_2, _r11), _r11), (0.8 * p_gravity) * _multiply(climb_0, cosine_0, _r11), _multiply(cos_0, _s61, _r11) - _multiply(sin_0, _s62, _r10), _multiply(cos_0, _s62, _r8) + _multiply(sin_0, _s61, _r17), _multiply(_multiply(climb_1, cosine_0, _r17), _s1, _r17) - _multiply(sine_0, _s60, _r3)


def ring_round_pulled(climb_0: Any, climb_1: Any, cosine_0: Any, cosine_1: Any, p_gravity: Any, omega_0: Any, omega_1: Any, turn_rate_0: Any, turn_rate_1: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The square of the friction that rolling on the ring takes, and its rate.

    Routh's equations. 24 operations: 6 additions, 18 multiplications.
    Returns drag, drag_rate, strain, strain_rate.
    """
    _r0, _r1, _r2, _r3, _r4 = _room[:5]
    _s0 = _multiply(0.4, _multiply(climb_0, turn_rate_0, _r0), _r0)
    _s1 = _add(p_gravity, _multiply(omega_0, turn_rate_0, _r1), _r1)
    _s2 = _multiply(0.4, _multiply(cosine_0, _s1, _r2), _r2)
    _s3 = _multiply(_s2, _multiply(0.4, _add(_multiply(cosine_0, _add(_multiply(omega_0, turn_rate_1, _r3), _multiply(omega_1, turn_rate_0, _r4), _r4), _r4), _multiply(cosine_1, _s1, _r1), _r1), _r1), _r1)
    _s4 = 2.0 * _add(_multiply(_s0, _multiply(0.4, _add(_multiply(climb_0, turn_rate_1, _r4), _multiply(climb_1, turn_rate_0, _r3), _r3), _r3), _r3), _s3, _r1)
    return _multiply(_s0, _s0, _r0) + _multiply(_s2, _s2, _r2), _s4, -_inf, 0.0


def ring_swung(p_ball_radius: Any, berth: Any, circled: Any, climb: Any, climb_0: Any, doubt: Any, fastest: Any, force: Any, force_bend: Any, force_rate: Any, p_gravity: Any, position_error: Any, stride: Any, sway: Any, velocity_error: Any, which: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Whether it is certain to roll for ever.

    Routh's equations. 49 operations: 4 additions, 3 subtractions, 21 multiplications, 1 division, 1 absolute value, 8 comparisons, 6 conjunctions, 1 complement, 4 selections.
    Returns circled, endless, doubt.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = _multiply(stride, stride, _r0)
    _s2 = _logical_and(((0.000244140625 * _s0) < _subtract(berth, _multiply(_multiply(0.125, sway, _r1), _s1, _r1), _r1)), ((0.00390625 * p_gravity) < _subtract(_add(force, _multiply(stride, _select(force_rate < 0.0, force_rate, 0.0, _r1), _r1), _r1), _multiply(_multiply(0.5, force_bend, _r2), _s1, _r2), _r2)))
    _s3 = _logical_and(_s2, (which == -1.0))
    _s4 = _logical_and((_multiply(climb, climb_0, _r2) < 0.0), (_multiply(0.015625 * p_gravity, stride, _r2) < _multiply(_absolute(_subtract(climb, climb_0, _r1), _r1), _s0, _r1)))
    _s5 = _logical_and(_logical_and(_s3, _s4), (0.0 < circled))
    _s6 = _add(p_gravity, _multiply(_multiply(fastest, fastest, _r1), 1.0 / _s0, _r1), _r1)
    _s7 = _logical_not((_multiply(_s6, _multiply(512.0, _add(_multiply(fastest, velocity_error, _r2), _multiply(position_error, _s6, _r0), _r0), _r0), _r0) < ((0.000244140625 * (p_gravity * p_gravity)) * _s0)))
    return _result(_s3, _select(_s4, 1.0, circled, _r0), 0.0, _r0), _s5, _result(_logical_and(_s5, _s7), 0.0, doubt, _r0)


def ring_round_0(along_0: Any, p_ball_radius: Any, climb_0: Any, cos_0: Any, cosine_0: Any, p_gravity: Any, near_0: Any, p_ring_radius: Any, sin_0: Any, sine_0: Any, turn_rate_0: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 1, from those before.

    Routh's equations. 32 operations: 2 additions, 4 subtractions, 22 multiplications, 1 division, 3 negations.
    Returns omega_0, around_0, tilted_0, pressed_0, force_0, cosine_1, sine_1, climb_1, along_1, turn_rate_1, cos_1, sin_1.
    """
    _r0, _r1 = _room[:2]
    _s0 = along_0 * near_0
    _s1 = climb_0 * _s0
    _s2 = _multiply(along_0, sine_0, _r0) - _multiply(0.4, _multiply(cosine_0, turn_rate_0, _r1), _r1)
    _s3 = along_0 * cosine_0
    _s4 = p_ball_radius + p_wire_radius
    return _s0, _s1, _s2, _s3, _subtract(_multiply(p_gravity, sine_0, _r1), _multiply(_multiply(climb_0, climb_0, _r0), _s4, _r0), _r0) - _multiply(_s3, _s0, _r1), -_multiply(climb_0, sine_0, _r1), climb_0 * cosine_0, -_divide(_add(_multiply(_multiply(0.6, cosine_0, _r1), p_gravity, _r1), _multiply(_s0, _s2, _r0), _r0), _s4, _r0), _multiply(_multiply(sine_0, _s1, _r0), _s4, _r0) - _multiply(0.4, _multiply(climb_0, turn_rate_0, _r1), _r1), p_ring_radius * _s1, -_multiply(sin_0, _s0, _r1), cos_0 * _s0


def ring_round_1(along_0: Any, along_1: Any, around_0: Any, p_ball_radius: Any, climb_0: Any, climb_1: Any, cos_0: Any, cos_1: Any, cosine_0: Any, cosine_1: Any, p_gravity: Any, near_0: Any, omega_0: Any, pressed_0: Any, p_ring_radius: Any, sin_0: Any, sin_1: Any, sine_0: Any, sine_1: Any, tilted_0: Any, turn_rate_0: Any, turn_rate_1: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 2, from those before.

    Routh's equations. 70 operations: 15 additions, 4 subtractions, 46 multiplications, 1 division, 4 negations.
    Returns near_1, omega_1, around_1, tilted_1, pressed_1, force_1, cosine_2, sine_2, climb_2, along_2, turn_rate_2, cos_2, sin_2.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = -_multiply(_multiply(near_0, _multiply(cosine_1, near_0, _r0), _r0), _s0, _r0)
    _s2 = _multiply(along_0, _s1, _r0) + _multiply(along_1, near_0, _r1)
    _s3 = _multiply(climb_0, _s2, _r1) + _multiply(climb_1, omega_0, _r0)
    _s4 = _add(_multiply(along_0, sine_1, _r0), _multiply(along_1, sine_0, _r1), _r1) - _multiply(0.4, _add(_multiply(cosine_0, turn_rate_1, _r0), _multiply(cosine_1, turn_rate_0, _r2), _r2), _r2)
    _s5 = _multiply(along_0, cosine_1, _r2) + _multiply(along_1, cosine_0, _r1)
    _s6 = -_divide(_multiply(0.5, _add(_multiply(_multiply(0.6, cosine_1, _r1), p_gravity, _r1), _add(_multiply(omega_0, _s4, _r2), _multiply(tilted_0, _s2, _r0), _r0), _r0), _r0), _s0, _r0)
    return _s1, _s2, _s3, _s4, _s5, _subtract(_multiply(p_gravity, sine_1, _r0), _multiply(_multiply(_multiply(2.0, climb_0, _r1), climb_1, _r1), _s0, _r1), _r1) - _add(_multiply(omega_0, _s5, _r0), _multiply(pressed_0, _s2, _r2), _r2), -_multiply(0.5, _add(_multiply(climb_0, sine_1, _r2), _multiply(climb_1, sine_0, _r1), _r1), _r1), 0.5 * _add(_multiply(climb_0, cosine_1, _r1), _multiply(climb_1, cosine_0, _r2), _r2), _s6, 0.5 * _subtract(_multiply(_s0, _add(_multiply(around_0, sine_1, _r2), _multiply(sine_0, _s3, _r1), _r1), _r1), _multiply(0.4, _add(_multiply(climb_0, turn_rate_1, _r2), _multiply(climb_1, turn_rate_0, _r0), _r0), _r0), _r0), (0.5 * p_ring_radius) * _s3, -_multiply(0.5, _add(_multiply(omega_0, sin_1, _r0), _multiply(sin_0, _s2, _r1), _r1), _r1), 0.5 * _add(_multiply(cos_0, _s2, _r1), _multiply(cos_1, omega_0, _r0), _r0)


def ring_round_2(along_0: Any, along_1: Any, along_2: Any, around_0: Any, around_1: Any, p_ball_radius: Any, climb_0: Any, climb_1: Any, climb_2: Any, cos_0: Any, cos_1: Any, cos_2: Any, cosine_0: Any, cosine_1: Any, cosine_2: Any, p_gravity: Any, near_0: Any, near_1: Any, omega_0: Any, omega_1: Any, pressed_0: Any, pressed_1: Any, p_ring_radius: Any, sin_0: Any, sin_1: Any, sin_2: Any, sine_0: Any, sine_1: Any, sine_2: Any, tilted_0: Any, tilted_1: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 3, from those before.

    Routh's equations. 100 operations: 30 additions, 4 subtractions, 61 multiplications, 1 division, 4 negations.
    Returns near_2, omega_2, around_2, tilted_2, pressed_2, force_2, cosine_3, sine_3, climb_3, along_3, turn_rate_3, cos_3, sin_3.
    """
    _r0, _r1, _r2, _r3 = _room[:4]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = -_multiply(_multiply(near_0, _s0, _r0), _add(_multiply(cosine_1, near_1, _r1), _multiply(cosine_2, near_0, _r2), _r2), _r0)
    _s2 = _add(_multiply(along_0, _s1, _r0), _multiply(along_1, near_1, _r2), _r2) + _multiply(along_2, near_0, _r0)
    _s3 = _add(_multiply(climb_0, _s2, _r0), _multiply(climb_1, omega_1, _r2), _r2) + _multiply(climb_2, omega_0, _r0)
    _s4 = _add(_add(_multiply(along_0, sine_2, _r0), _multiply(along_1, sine_1, _r2), _r2), _multiply(along_2, sine_0, _r0), _r0) - _multiply(0.4, _add(_add(_multiply(cosine_0, turn_rate_2, _r2), _multiply(cosine_1, turn_rate_1, _r1), _r1), _multiply(cosine_2, turn_rate_0, _r2), _r2), _r2)
    _s5 = _add(_multiply(along_0, cosine_2, _r2), _multiply(along_1, cosine_1, _r0), _r0) + _multiply(along_2, cosine_0, _r2)
    _s6 = _subtract(_multiply(p_gravity, sine_2, _r2), _multiply(_s0, _add(_multiply(climb_1, climb_1, _r0), _multiply(_multiply(2.0, climb_0, _r1), climb_2, _r1), _r1), _r1), _r1) - _add(_add(_multiply(omega_0, _s5, _r2), _multiply(omega_1, pressed_1, _r0), _r0), _multiply(pressed_0, _s2, _r2), _r2)
    _s7 = _divide(_multiply(0.3333333333333333, _add(_multiply(_multiply(0.6, cosine_2, _r2), p_gravity, _r2), _add(_add(_multiply(omega_0, _s4, _r1), _multiply(omega_1, tilted_1, _r0), _r0), _multiply(tilted_0, _s2, _r1), _r1), _r1), _r1), _s0, _r1)
    _s8 = 0.3333333333333333 * _subtract(_multiply(_s0, _add(_add(_multiply(around_0, sine_2, _r2), _multiply(around_1, sine_1, _r0), _r0), _multiply(sine_0, _s3, _r2), _r2), _r2), _multiply(0.4, _add(_add(_multiply(climb_0, turn_rate_2, _r0), _multiply(climb_1, turn_rate_1, _r3), _r3), _multiply(climb_2, turn_rate_0, _r0), _r0), _r0), _r0)
    return _s1, _s2, _s3, _s4, _s5, _s6, -_multiply(0.3333333333333333, _add(_add(_multiply(climb_0, sine_2, _r0), _multiply(climb_1, sine_1, _r2), _r2), _multiply(climb_2, sine_0, _r0), _r0), _r0), 0.3333333333333333 * _add(_add(_multiply(climb_0, cosine_2, _r0), _multiply(climb_1, cosine_1, _r2), _r2), _multiply(climb_2, cosine_0, _r0), _r0), -_s7, _s8, (0.3333333333333333 * p_ring_radius) * _s3, -_multiply(0.3333333333333333, _add(_add(_multiply(omega_0, sin_2, _r1), _multiply(omega_1, sin_1, _r0), _r0), _multiply(sin_0, _s2, _r1), _r1), _r1), 0.3333333333333333 * _add(_add(_multiply(cos_0, _s2, _r1), _multiply(cos_1, omega_1, _r0), _r0), _multiply(cos_2, omega_0, _r1), _r1)


def ring_round_3(along_0: Any, along_1: Any, along_2: Any, along_3: Any, around_0: Any, around_1: Any, around_2: Any, p_ball_radius: Any, climb_0: Any, climb_1: Any, climb_2: Any, climb_3: Any, cos_0: Any, cos_1: Any, cos_2: Any, cos_3: Any, cosine_0: Any, cosine_1: Any, cosine_2: Any, cosine_3: Any, p_gravity: Any, near_0: Any, near_1: Any, near_2: Any, omega_0: Any, omega_1: Any, omega_2: Any, pressed_0: Any, pressed_1: Any, pressed_2: Any, p_ring_radius: Any, sin_0: Any, sin_1: Any, sin_2: Any, sin_3: Any, sine_0: Any, sine_1: Any, sine_2: Any, sine_3: Any, tilted_0: Any, tilted_1: Any, tilted_2: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, turn_rate_3: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 4, from those before.

    Routh's equations. 129 operations: 44 additions, 4 subtractions, 76 multiplications, 1 division, 4 negations.
    Returns near_3, omega_3, around_3, tilted_3, pressed_3, force_3, cosine_4, sine_4, climb_4, along_4, turn_rate_4, cos_4, sin_4.
    """
    _r0, _r1, _r2, _r3 = _room[:4]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = -_multiply(_multiply(near_0, _s0, _r0), _add(_add(_multiply(cosine_1, near_2, _r1), _multiply(cosine_2, near_1, _r2), _r2), _multiply(cosine_3, near_0, _r1), _r1), _r0)
    _s2 = _add(_add(_multiply(along_0, _s1, _r0), _multiply(along_1, near_2, _r1), _r1), _multiply(along_2, near_1, _r0), _r0) + _multiply(along_3, near_0, _r1)
    _s3 = _add(_add(_multiply(climb_0, _s2, _r1), _multiply(climb_1, omega_2, _r0), _r0), _multiply(climb_2, omega_1, _r1), _r1) + _multiply(climb_3, omega_0, _r0)
    _s4 = _add(_add(_add(_multiply(along_0, sine_3, _r0), _multiply(along_1, sine_2, _r1), _r1), _multiply(along_2, sine_1, _r0), _r0), _multiply(along_3, sine_0, _r1), _r1) - _multiply(0.4, _add(_add(_add(_multiply(cosine_0, turn_rate_3, _r0), _multiply(cosine_1, turn_rate_2, _r2), _r2), _multiply(cosine_2, turn_rate_1, _r0), _r0), _multiply(cosine_3, turn_rate_0, _r2), _r2), _r2)
    _s5 = _add(_add(_multiply(along_0, cosine_3, _r2), _multiply(along_1, cosine_2, _r1), _r1), _multiply(along_2, cosine_1, _r2), _r2) + _multiply(along_3, cosine_0, _r1)
    _s6 = _subtract(_multiply(p_gravity, sine_3, _r1), _multiply(_s0, _add(_multiply(_multiply(2.0, climb_0, _r2), climb_3, _r2), _multiply(_multiply(2.0, climb_1, _r0), climb_2, _r0), _r0), _r0), _r0) - _add(_add(_add(_multiply(omega_0, _s5, _r1), _multiply(omega_1, pressed_2, _r2), _r2), _multiply(omega_2, pressed_1, _r1), _r1), _multiply(pressed_0, _s2, _r2), _r2)
    _s7 = -_multiply(0.25, _add(_add(_add(_multiply(climb_0, sine_3, _r2), _multiply(climb_1, sine_2, _r0), _r0), _multiply(climb_2, sine_1, _r2), _r2), _multiply(climb_3, sine_0, _r0), _r0), _r0)
    _s8 = _multiply(0.25, _add(_multiply(_multiply(0.6, cosine_3, _r0), p_gravity, _r0), _add(_add(_add(_multiply(omega_0, _s4, _r2), _multiply(omega_1, tilted_2, _r1), _r1), _multiply(omega_2, tilted_1, _r2), _r2), _multiply(tilted_0, _s2, _r1), _r1), _r1), _r1)
    _s9 = _subtract(_multiply(_s0, _add(_add(_add(_multiply(around_0, sine_3, _r0), _multiply(around_1, sine_2, _r2), _r2), _multiply(around_2, sine_1, _r0), _r0), _multiply(sine_0, _s3, _r2), _r2), _r2), _multiply(0.4, _add(_add(_add(_multiply(climb_0, turn_rate_3, _r0), _multiply(climb_1, turn_rate_2, _r3), _r3), _multiply(climb_2, turn_rate_1, _r0), _r0), _multiply(climb_3, turn_rate_0, _r3), _r3), _r3), _r3)
    _s10 = -_multiply(0.25, _add(_add(_add(_multiply(omega_0, sin_3, _r2), _multiply(omega_1, sin_2, _r0), _r0), _multiply(omega_2, sin_1, _r2), _r2), _multiply(sin_0, _s2, _r0), _r0), _r0)
    return _s1, _s2, _s3, _s4, _s5, _s6, _s7, 0.25 * _add(_add(_add(_multiply(climb_0, cosine_3, _r0), _multiply(climb_1, cosine_2, _r2), _r2), _multiply(climb_2, cosine_1, _r0), _r0), _multiply(climb_3, cosine_0, _r2), _r2), -_divide(_s8, _s0, _r1), 0.25 * _s9, (0.25 * p_ring_radius) * _s3, _s10, 0.25 * _add(_add(_add(_multiply(cos_0, _s2, _r3), _multiply(cos_1, omega_2, _r1), _r1), _multiply(cos_2, omega_1, _r3), _r3), _multiply(cos_3, omega_0, _r1), _r1)


def ring_round_4(along_0: Any, along_1: Any, along_2: Any, along_3: Any, along_4: Any, around_0: Any, around_1: Any, around_2: Any, around_3: Any, p_ball_radius: Any, climb_0: Any, climb_1: Any, climb_2: Any, climb_3: Any, climb_4: Any, cos_0: Any, cos_1: Any, cos_2: Any, cos_3: Any, cos_4: Any, cosine_0: Any, cosine_1: Any, cosine_2: Any, cosine_3: Any, cosine_4: Any, p_gravity: Any, near_0: Any, near_1: Any, near_2: Any, near_3: Any, omega_0: Any, omega_1: Any, omega_2: Any, omega_3: Any, pressed_0: Any, pressed_1: Any, pressed_2: Any, pressed_3: Any, p_ring_radius: Any, sin_0: Any, sin_1: Any, sin_2: Any, sin_3: Any, sin_4: Any, sine_0: Any, sine_1: Any, sine_2: Any, sine_3: Any, sine_4: Any, tilted_0: Any, tilted_1: Any, tilted_2: Any, tilted_3: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 5, from those before.

    Routh's equations. 159 operations: 59 additions, 4 subtractions, 91 multiplications, 1 division, 4 negations.
    Returns near_4, omega_4, around_4, tilted_4, pressed_4, force_4, cosine_5, sine_5, climb_5, along_5, turn_rate_5, cos_5, sin_5.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6 = _room[:7]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = -_multiply(_multiply(near_0, _s0, _r0), _add(_add(_add(_multiply(cosine_1, near_3, _r1), _multiply(cosine_2, near_2, _r2), _r2), _multiply(cosine_3, near_1, _r1), _r1), _multiply(cosine_4, near_0, _r2), _r2), _r0)
    _s2 = _add(_add(_add(_multiply(along_0, _s1, _r0), _multiply(along_1, near_3, _r2), _r2), _multiply(along_2, near_2, _r0), _r0), _multiply(along_3, near_1, _r2), _r2) + _multiply(along_4, near_0, _r0)
    _s3 = _add(_add(_add(_multiply(climb_0, _s2, _r0), _multiply(climb_1, omega_3, _r2), _r2), _multiply(climb_2, omega_2, _r0), _r0), _multiply(climb_3, omega_1, _r2), _r2) + _multiply(climb_4, omega_0, _r0)
    _s4 = _multiply(0.4, _add(_add(_add(_add(_multiply(cosine_0, turn_rate_4, _r0), _multiply(cosine_1, turn_rate_3, _r2), _r2), _multiply(cosine_2, turn_rate_2, _r0), _r0), _multiply(cosine_3, turn_rate_1, _r2), _r2), _multiply(cosine_4, turn_rate_0, _r0), _r0), _r0)
    _s5 = _add(_add(_add(_add(_multiply(along_0, sine_4, _r2), _multiply(along_1, sine_3, _r1), _r1), _multiply(along_2, sine_2, _r2), _r2), _multiply(along_3, sine_1, _r1), _r1), _multiply(along_4, sine_0, _r2), _r2) - _s4
    _s6 = _add(_add(_add(_multiply(along_0, cosine_4, _r0), _multiply(along_1, cosine_3, _r2), _r2), _multiply(along_2, cosine_2, _r0), _r0), _multiply(along_3, cosine_1, _r2), _r2) + _multiply(along_4, cosine_0, _r0)
    _s7 = _subtract(_multiply(p_gravity, sine_4, _r0), _multiply(_s0, _add(_add(_multiply(climb_2, climb_2, _r2), _multiply(_multiply(2.0, climb_0, _r1), climb_4, _r1), _r1), _multiply(_multiply(2.0, climb_1, _r2), climb_3, _r2), _r2), _r2), _r2)
    _s8 = _s7 - _add(_add(_add(_add(_multiply(omega_0, _s6, _r0), _multiply(omega_1, pressed_3, _r1), _r1), _multiply(omega_2, pressed_2, _r0), _r0), _multiply(omega_3, pressed_1, _r1), _r1), _multiply(pressed_0, _s2, _r0), _r0)
    _s9 = _multiply(0.2, _add(_add(_add(_add(_multiply(climb_0, sine_4, _r0), _multiply(climb_1, sine_3, _r2), _r2), _multiply(climb_2, sine_2, _r0), _r0), _multiply(climb_3, sine_1, _r2), _r2), _multiply(climb_4, sine_0, _r0), _r0), _r0)
    _s10 = 0.2 * _add(_add(_add(_add(_multiply(climb_0, cosine_4, _r2), _multiply(climb_1, cosine_3, _r1), _r1), _multiply(climb_2, cosine_2, _r2), _r2), _multiply(climb_3, cosine_1, _r1), _r1), _multiply(climb_4, cosine_0, _r2), _r2)
    _s11 = _add(_multiply(_multiply(0.6, cosine_4, _r2), p_gravity, _r2), _add(_add(_add(_add(_multiply(omega_0, _s5, _r1), _multiply(omega_1, tilted_3, _r3), _r3), _multiply(omega_2, tilted_2, _r1), _r1), _multiply(omega_3, tilted_1, _r3), _r3), _multiply(tilted_0, _s2, _r1), _r1), _r1)
    _s12 = _multiply(_s0, _add(_add(_add(_add(_multiply(around_0, sine_4, _r2), _multiply(around_1, sine_3, _r3), _r3), _multiply(around_2, sine_2, _r2), _r2), _multiply(around_3, sine_1, _r3), _r3), _multiply(sine_0, _s3, _r2), _r2), _r2)
    _s13 = _multiply(0.4, _add(_add(_add(_add(_multiply(climb_0, turn_rate_4, _r3), _multiply(climb_1, turn_rate_3, _r4), _r4), _multiply(climb_2, turn_rate_2, _r3), _r3), _multiply(climb_3, turn_rate_1, _r4), _r4), _multiply(climb_4, turn_rate_0, _r3), _r3), _r3)
    _s14 = _multiply(0.2, _add(_add(_add(_add(_multiply(omega_0, sin_4, _r4), _multiply(omega_1, sin_3, _r5), _r5), _multiply(omega_2, sin_2, _r4), _r4), _multiply(omega_3, sin_1, _r5), _r5), _multiply(sin_0, _s2, _r4), _r4), _r4)
    _s15 = 0.2 * _add(_add(_add(_add(_multiply(cos_0, _s2, _r5), _multiply(cos_1, omega_3, _r6), _r6), _multiply(cos_2, omega_2, _r5), _r5), _multiply(cos_3, omega_1, _r6), _r6), _multiply(cos_4, omega_0, _r5), _r5)
    return _s1, _s2, _s3, _s5, _s6, _s8, -_s9, _s10, -_divide(_multiply(0.2, _s11, _r1), _s0, _r1), 0.2 * _subtract(_s12, _s13, _r3), (0.2 * p_ring_radius) * _s3, -_s14, _s15


def ring_round_5(along_0: Any, along_1: Any, along_2: Any, along_3: Any, along_4: Any, along_5: Any, around_0: Any, around_1: Any, around_2: Any, around_3: Any, around_4: Any, p_ball_radius: Any, climb_0: Any, climb_1: Any, climb_2: Any, climb_3: Any, climb_4: Any, climb_5: Any, cos_0: Any, cos_1: Any, cos_2: Any, cos_3: Any, cos_4: Any, cos_5: Any, cosine_0: Any, cosine_1: Any, cosine_2: Any, cosine_3: Any, cosine_4: Any, cosine_5: Any, p_gravity: Any, near_0: Any, near_1: Any, near_2: Any, near_3: Any, near_4: Any, omega_0: Any, omega_1: Any, omega_2: Any, omega_3: Any, omega_4: Any, pressed_0: Any, pressed_1: Any, pressed_2: Any, pressed_3: Any, pressed_4: Any, p_ring_radius: Any, sin_0: Any, sin_1: Any, sin_2: Any, sin_3: Any, sin_4: Any, sin_5: Any, sine_0: Any, sine_1: Any, sine_2: Any, sine_3: Any, sine_4: Any, sine_5: Any, tilted_0: Any, tilted_1: Any, tilted_2: Any, tilted_3: Any, tilted_4: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, turn_rate_5: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 6, from those before.

    Routh's equations. 188 operations: 73 additions, 4 subtractions, 106 multiplications, 1 division, 4 negations.
    Returns near_5, omega_5, around_5, tilted_5, pressed_5, force_5, cosine_6, sine_6, climb_6, along_6, turn_rate_6, cos_6, sin_6.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8 = _room[:9]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = _multiply(_multiply(near_0, _s0, _r0), _add(_add(_add(_add(_multiply(cosine_1, near_4, _r1), _multiply(cosine_2, near_3, _r2), _r2), _multiply(cosine_3, near_2, _r1), _r1), _multiply(cosine_4, near_1, _r2), _r2), _multiply(cosine_5, near_0, _r1), _r1), _r0)
    _s2 = -_s1
    _s3 = _add(_add(_add(_add(_multiply(along_0, _s2, _r0), _multiply(along_1, near_4, _r1), _r1), _multiply(along_2, near_3, _r0), _r0), _multiply(along_3, near_2, _r1), _r1), _multiply(along_4, near_1, _r0), _r0) + _multiply(along_5, near_0, _r1)
    _s4 = _add(_add(_add(_add(_multiply(climb_0, _s3, _r1), _multiply(climb_1, omega_4, _r0), _r0), _multiply(climb_2, omega_3, _r1), _r1), _multiply(climb_3, omega_2, _r0), _r0), _multiply(climb_4, omega_1, _r1), _r1) + _multiply(climb_5, omega_0, _r0)
    _s5 = _add(_add(_add(_add(_add(_multiply(along_0, sine_5, _r0), _multiply(along_1, sine_4, _r1), _r1), _multiply(along_2, sine_3, _r0), _r0), _multiply(along_3, sine_2, _r1), _r1), _multiply(along_4, sine_1, _r0), _r0), _multiply(along_5, sine_0, _r1), _r1)
    _s6 = _add(_add(_add(_add(_add(_multiply(cosine_0, turn_rate_5, _r0), _multiply(cosine_1, turn_rate_4, _r2), _r2), _multiply(cosine_2, turn_rate_3, _r0), _r0), _multiply(cosine_3, turn_rate_2, _r2), _r2), _multiply(cosine_4, turn_rate_1, _r0), _r0), _multiply(cosine_5, turn_rate_0, _r2), _r2)
    _s7 = _s5 - _multiply(0.4, _s6, _r2)
    _s8 = _add(_add(_add(_add(_multiply(along_0, cosine_5, _r2), _multiply(along_1, cosine_4, _r1), _r1), _multiply(along_2, cosine_3, _r2), _r2), _multiply(along_3, cosine_2, _r1), _r1), _multiply(along_4, cosine_1, _r2), _r2) + _multiply(along_5, cosine_0, _r1)
    _s9 = _subtract(_multiply(p_gravity, sine_5, _r1), _multiply(_s0, _add(_add(_multiply(_multiply(2.0, climb_0, _r2), climb_5, _r2), _multiply(_multiply(2.0, climb_1, _r0), climb_4, _r0), _r0), _multiply(_multiply(2.0, climb_2, _r2), climb_3, _r2), _r2), _r2), _r2)
    _s10 = _add(_add(_add(_add(_add(_multiply(omega_0, _s8, _r1), _multiply(omega_1, pressed_4, _r0), _r0), _multiply(omega_2, pressed_3, _r1), _r1), _multiply(omega_3, pressed_2, _r0), _r0), _multiply(omega_4, pressed_1, _r1), _r1), _multiply(pressed_0, _s3, _r0), _r0)
    _s11 = _add(_add(_add(_add(_add(_multiply(climb_0, sine_5, _r1), _multiply(climb_1, sine_4, _r3), _r3), _multiply(climb_2, sine_3, _r1), _r1), _multiply(climb_3, sine_2, _r3), _r3), _multiply(climb_4, sine_1, _r1), _r1), _multiply(climb_5, sine_0, _r3), _r3)
    _s12 = _add(_add(_add(_add(_add(_multiply(climb_0, cosine_5, _r1), _multiply(climb_1, cosine_4, _r4), _r4), _multiply(climb_2, cosine_3, _r1), _r1), _multiply(climb_3, cosine_2, _r4), _r4), _multiply(climb_4, cosine_1, _r1), _r1), _multiply(climb_5, cosine_0, _r4), _r4)
    _s13 = _add(_add(_add(_add(_add(_multiply(omega_0, _s7, _r1), _multiply(omega_1, tilted_4, _r5), _r5), _multiply(omega_2, tilted_3, _r1), _r1), _multiply(omega_3, tilted_2, _r5), _r5), _multiply(omega_4, tilted_1, _r1), _r1), _multiply(tilted_0, _s3, _r5), _r5)
    _s14 = -_divide(_multiply(0.16666666666666666, _add(_multiply(_multiply(0.6, cosine_5, _r1), p_gravity, _r1), _s13, _r5), _r5), _s0, _r5)
    _s15 = _add(_add(_add(_add(_add(_multiply(around_0, sine_5, _r5), _multiply(around_1, sine_4, _r1), _r1), _multiply(around_2, sine_3, _r5), _r5), _multiply(around_3, sine_2, _r1), _r1), _multiply(around_4, sine_1, _r5), _r5), _multiply(sine_0, _s4, _r1), _r1)
    _s16 = _add(_add(_add(_add(_add(_multiply(climb_0, turn_rate_5, _r5), _multiply(climb_1, turn_rate_4, _r6), _r6), _multiply(climb_2, turn_rate_3, _r5), _r5), _multiply(climb_3, turn_rate_2, _r6), _r6), _multiply(climb_4, turn_rate_1, _r5), _r5), _multiply(climb_5, turn_rate_0, _r6), _r6)
    _s17 = _add(_add(_add(_add(_add(_multiply(omega_0, sin_5, _r5), _multiply(omega_1, sin_4, _r7), _r7), _multiply(omega_2, sin_3, _r5), _r5), _multiply(omega_3, sin_2, _r7), _r7), _multiply(omega_4, sin_1, _r5), _r5), _multiply(sin_0, _s3, _r7), _r7)
    _s18 = _add(_add(_add(_add(_add(_multiply(cos_0, _s3, _r5), _multiply(cos_1, omega_4, _r8), _r8), _multiply(cos_2, omega_3, _r5), _r5), _multiply(cos_3, omega_2, _r8), _r8), _multiply(cos_4, omega_1, _r5), _r5), _multiply(cos_5, omega_0, _r8), _r8)
    return _s2, _s3, _s4, _s7, _s8, _s9 - _s10, -_multiply(0.16666666666666666, _s11, _r3), 0.16666666666666666 * _s12, _s14, 0.16666666666666666 * _subtract(_multiply(_s0, _s15, _r1), _multiply(0.4, _s16, _r6), _r6), (0.16666666666666666 * p_ring_radius) * _s4, -_multiply(0.16666666666666666, _s17, _r7), 0.16666666666666666 * _s18


def ring_round_6(along_0: Any, along_1: Any, along_2: Any, along_3: Any, along_4: Any, along_5: Any, along_6: Any, around_0: Any, around_1: Any, around_2: Any, around_3: Any, around_4: Any, around_5: Any, p_ball_radius: Any, climb_0: Any, climb_1: Any, climb_2: Any, climb_3: Any, climb_4: Any, climb_5: Any, climb_6: Any, cos_0: Any, cos_1: Any, cos_2: Any, cos_3: Any, cos_4: Any, cos_5: Any, cos_6: Any, cosine_0: Any, cosine_1: Any, cosine_2: Any, cosine_3: Any, cosine_4: Any, cosine_5: Any, cosine_6: Any, p_gravity: Any, near_0: Any, near_1: Any, near_2: Any, near_3: Any, near_4: Any, near_5: Any, omega_0: Any, omega_1: Any, omega_2: Any, omega_3: Any, omega_4: Any, omega_5: Any, pressed_0: Any, pressed_1: Any, pressed_2: Any, pressed_3: Any, pressed_4: Any, pressed_5: Any, p_ring_radius: Any, sin_0: Any, sin_1: Any, sin_2: Any, sin_3: Any, sin_4: Any, sin_5: Any, sin_6: Any, sine_0: Any, sine_1: Any, sine_2: Any, sine_3: Any, sine_4: Any, sine_5: Any, sine_6: Any, tilted_0: Any, tilted_1: Any, tilted_2: Any, tilted_3: Any, tilted_4: Any, tilted_5: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, turn_rate_5: Any, turn_rate_6: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 7, from those before.

    Routh's equations. 218 operations: 88 additions, 4 subtractions, 121 multiplications, 1 division, 4 negations.
    Returns near_6, omega_6, around_6, tilted_6, pressed_6, force_6, cosine_7, sine_7, climb_7, along_7, turn_rate_7, cos_7, sin_7.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8 = _room[:9]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = _add(_add(_add(_add(_add(_multiply(cosine_1, near_5, _r0), _multiply(cosine_2, near_4, _r1), _r1), _multiply(cosine_3, near_3, _r0), _r0), _multiply(cosine_4, near_2, _r1), _r1), _multiply(cosine_5, near_1, _r0), _r0), _multiply(cosine_6, near_0, _r1), _r1)
    _s2 = -_multiply(_multiply(near_0, _s0, _r0), _s1, _r0)
    _s3 = _add(_add(_add(_add(_add(_multiply(along_0, _s2, _r0), _multiply(along_1, near_5, _r1), _r1), _multiply(along_2, near_4, _r0), _r0), _multiply(along_3, near_3, _r1), _r1), _multiply(along_4, near_2, _r0), _r0), _multiply(along_5, near_1, _r1), _r1)
    _s4 = _s3 + _multiply(along_6, near_0, _r0)
    _s5 = _add(_add(_add(_add(_add(_multiply(climb_0, _s4, _r0), _multiply(climb_1, omega_5, _r1), _r1), _multiply(climb_2, omega_4, _r0), _r0), _multiply(climb_3, omega_3, _r1), _r1), _multiply(climb_4, omega_2, _r0), _r0), _multiply(climb_5, omega_1, _r1), _r1)
    _s6 = _s5 + _multiply(climb_6, omega_0, _r0)
    _s7 = _add(_add(_add(_add(_add(_multiply(along_0, sine_6, _r0), _multiply(along_1, sine_5, _r1), _r1), _multiply(along_2, sine_4, _r0), _r0), _multiply(along_3, sine_3, _r1), _r1), _multiply(along_4, sine_2, _r0), _r0), _multiply(along_5, sine_1, _r1), _r1)
    _s8 = _add(_add(_add(_add(_add(_multiply(cosine_0, turn_rate_6, _r0), _multiply(cosine_1, turn_rate_5, _r2), _r2), _multiply(cosine_2, turn_rate_4, _r0), _r0), _multiply(cosine_3, turn_rate_3, _r2), _r2), _multiply(cosine_4, turn_rate_2, _r0), _r0), _multiply(cosine_5, turn_rate_1, _r2), _r2)
    _s9 = _add(_s7, _multiply(along_6, sine_0, _r0), _r0) - _multiply(0.4, _add(_s8, _multiply(cosine_6, turn_rate_0, _r1), _r1), _r1)
    _s10 = _add(_add(_add(_add(_add(_multiply(along_0, cosine_6, _r1), _multiply(along_1, cosine_5, _r0), _r0), _multiply(along_2, cosine_4, _r1), _r1), _multiply(along_3, cosine_3, _r0), _r0), _multiply(along_4, cosine_2, _r1), _r1), _multiply(along_5, cosine_1, _r0), _r0)
    _s11 = _s10 + _multiply(along_6, cosine_0, _r1)
    _s12 = _multiply(_s0, _add(_add(_add(_multiply(climb_3, climb_3, _r1), _multiply(_multiply(2.0, climb_0, _r0), climb_6, _r0), _r0), _multiply(_multiply(2.0, climb_1, _r1), climb_5, _r1), _r1), _multiply(_multiply(2.0, climb_2, _r0), climb_4, _r0), _r0), _r0)
    _s13 = _add(_add(_add(_add(_add(_multiply(omega_0, _s11, _r1), _multiply(omega_1, pressed_5, _r2), _r2), _multiply(omega_2, pressed_4, _r1), _r1), _multiply(omega_3, pressed_3, _r2), _r2), _multiply(omega_4, pressed_2, _r1), _r1), _multiply(omega_5, pressed_1, _r2), _r2)
    _s14 = _add(_add(_add(_add(_add(_multiply(climb_0, sine_6, _r1), _multiply(climb_1, sine_5, _r3), _r3), _multiply(climb_2, sine_4, _r1), _r1), _multiply(climb_3, sine_3, _r3), _r3), _multiply(climb_4, sine_2, _r1), _r1), _multiply(climb_5, sine_1, _r3), _r3)
    _s15 = _add(_add(_add(_add(_add(_multiply(climb_0, cosine_6, _r1), _multiply(climb_1, cosine_5, _r4), _r4), _multiply(climb_2, cosine_4, _r1), _r1), _multiply(climb_3, cosine_3, _r4), _r4), _multiply(climb_4, cosine_2, _r1), _r1), _multiply(climb_5, cosine_1, _r4), _r4)
    _s16 = _add(_add(_add(_add(_add(_multiply(omega_0, _s9, _r1), _multiply(omega_1, tilted_5, _r5), _r5), _multiply(omega_2, tilted_4, _r1), _r1), _multiply(omega_3, tilted_3, _r5), _r5), _multiply(omega_4, tilted_2, _r1), _r1), _multiply(omega_5, tilted_1, _r5), _r5)
    _s17 = -_divide(_multiply(0.14285714285714285, _add(_multiply(_multiply(0.6, cosine_6, _r1), p_gravity, _r1), _add(_s16, _multiply(tilted_0, _s4, _r6), _r6), _r6), _r6), _s0, _r6)
    _s18 = _add(_add(_add(_add(_add(_multiply(around_0, sine_6, _r6), _multiply(around_1, sine_5, _r1), _r1), _multiply(around_2, sine_4, _r6), _r6), _multiply(around_3, sine_3, _r1), _r1), _multiply(around_4, sine_2, _r6), _r6), _multiply(around_5, sine_1, _r1), _r1)
    _s19 = _add(_add(_add(_add(_add(_multiply(climb_0, turn_rate_6, _r6), _multiply(climb_1, turn_rate_5, _r5), _r5), _multiply(climb_2, turn_rate_4, _r6), _r6), _multiply(climb_3, turn_rate_3, _r5), _r5), _multiply(climb_4, turn_rate_2, _r6), _r6), _multiply(climb_5, turn_rate_1, _r5), _r5)
    _s20 = _add(_add(_add(_add(_add(_multiply(omega_0, sin_6, _r6), _multiply(omega_1, sin_5, _r7), _r7), _multiply(omega_2, sin_4, _r6), _r6), _multiply(omega_3, sin_3, _r7), _r7), _multiply(omega_4, sin_2, _r6), _r6), _multiply(omega_5, sin_1, _r7), _r7)
    _s21 = _add(_add(_add(_add(_add(_multiply(cos_0, _s4, _r6), _multiply(cos_1, omega_5, _r8), _r8), _multiply(cos_2, omega_4, _r6), _r6), _multiply(cos_3, omega_3, _r8), _r8), _multiply(cos_4, omega_2, _r6), _r6), _multiply(cos_5, omega_1, _r8), _r8)
    return _s2, _s4, _s6, _s9, _s11, _subtract(_multiply(p_gravity, sine_6, _r6), _s12, _r0) - _add(_s13, _multiply(pressed_0, _s4, _r6), _r6), -_multiply(0.14285714285714285, _add(_s14, _multiply(climb_6, sine_0, _r6), _r6), _r6), 0.14285714285714285 * _add(_s15, _multiply(climb_6, cosine_0, _r6), _r6), _s17, 0.14285714285714285 * _subtract(_multiply(_s0, _add(_s18, _multiply(sine_0, _s6, _r6), _r6), _r6), _multiply(0.4, _add(_s19, _multiply(climb_6, turn_rate_0, _r1), _r1), _r1), _r1), (0.14285714285714285 * p_ring_radius) * _s6, -_multiply(0.14285714285714285, _add(_s20, _multiply(sin_0, _s4, _r1), _r1), _r1), 0.14285714285714285 * _add(_s21, _multiply(cos_6, omega_0, _r1), _r1)


def ring_round_7(along_0: Any, along_1: Any, along_2: Any, along_3: Any, along_4: Any, along_5: Any, along_6: Any, along_7: Any, around_0: Any, around_1: Any, around_2: Any, around_3: Any, around_4: Any, around_5: Any, around_6: Any, p_ball_radius: Any, climb_0: Any, climb_1: Any, climb_2: Any, climb_3: Any, climb_4: Any, climb_5: Any, climb_6: Any, climb_7: Any, cos_0: Any, cos_1: Any, cos_2: Any, cos_3: Any, cos_4: Any, cos_5: Any, cos_6: Any, cos_7: Any, cosine_0: Any, cosine_1: Any, cosine_2: Any, cosine_3: Any, cosine_4: Any, cosine_5: Any, cosine_6: Any, cosine_7: Any, p_gravity: Any, near_0: Any, near_1: Any, near_2: Any, near_3: Any, near_4: Any, near_5: Any, near_6: Any, omega_0: Any, omega_1: Any, omega_2: Any, omega_3: Any, omega_4: Any, omega_5: Any, omega_6: Any, pressed_0: Any, pressed_1: Any, pressed_2: Any, pressed_3: Any, pressed_4: Any, pressed_5: Any, pressed_6: Any, p_ring_radius: Any, sin_0: Any, sin_1: Any, sin_2: Any, sin_3: Any, sin_4: Any, sin_5: Any, sin_6: Any, sin_7: Any, sine_0: Any, sine_1: Any, sine_2: Any, sine_3: Any, sine_4: Any, sine_5: Any, sine_6: Any, sine_7: Any, tilted_0: Any, tilted_1: Any, tilted_2: Any, tilted_3: Any, tilted_4: Any, tilted_5: Any, tilted_6: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, turn_rate_5: Any, turn_rate_6: Any, turn_rate_7: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 8, from those before.

    Routh's equations. 247 operations: 102 additions, 4 subtractions, 136 multiplications, 1 division, 4 negations.
    Returns near_7, omega_7, around_7, tilted_7, pressed_7, force_7, cosine_8, sine_8, climb_8, along_8, turn_rate_8, cos_8, sin_8.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7 = _room[:8]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = _add(_add(_add(_add(_add(_multiply(cosine_1, near_6, _r0), _multiply(cosine_2, near_5, _r1), _r1), _multiply(cosine_3, near_4, _r0), _r0), _multiply(cosine_4, near_3, _r1), _r1), _multiply(cosine_5, near_2, _r0), _r0), _multiply(cosine_6, near_1, _r1), _r1)
    _s2 = -_multiply(_multiply(near_0, _s0, _r0), _add(_s1, _multiply(cosine_7, near_0, _r2), _r2), _r0)
    _s3 = _add(_add(_add(_add(_add(_multiply(along_0, _s2, _r0), _multiply(along_1, near_6, _r2), _r2), _multiply(along_2, near_5, _r0), _r0), _multiply(along_3, near_4, _r2), _r2), _multiply(along_4, near_3, _r0), _r0), _multiply(along_5, near_2, _r2), _r2)
    _s4 = _add(_s3, _multiply(along_6, near_1, _r0), _r0) + _multiply(along_7, near_0, _r2)
    _s5 = _add(_add(_add(_add(_add(_multiply(climb_0, _s4, _r2), _multiply(climb_1, omega_6, _r0), _r0), _multiply(climb_2, omega_5, _r2), _r2), _multiply(climb_3, omega_4, _r0), _r0), _multiply(climb_4, omega_3, _r2), _r2), _multiply(climb_5, omega_2, _r0), _r0)
    _s6 = _add(_s5, _multiply(climb_6, omega_1, _r2), _r2) + _multiply(climb_7, omega_0, _r0)
    _s7 = _add(_add(_add(_add(_add(_multiply(along_0, sine_7, _r0), _multiply(along_1, sine_6, _r2), _r2), _multiply(along_2, sine_5, _r0), _r0), _multiply(along_3, sine_4, _r2), _r2), _multiply(along_4, sine_3, _r0), _r0), _multiply(along_5, sine_2, _r2), _r2)
    _s8 = _add(_add(_add(_add(_add(_multiply(cosine_0, turn_rate_7, _r0), _multiply(cosine_1, turn_rate_6, _r1), _r1), _multiply(cosine_2, turn_rate_5, _r0), _r0), _multiply(cosine_3, turn_rate_4, _r1), _r1), _multiply(cosine_4, turn_rate_3, _r0), _r0), _multiply(cosine_5, turn_rate_2, _r1), _r1)
    _s9 = _add(_add(_s7, _multiply(along_6, sine_1, _r0), _r0), _multiply(along_7, sine_0, _r2), _r2) - _multiply(0.4, _add(_add(_s8, _multiply(cosine_6, turn_rate_1, _r0), _r0), _multiply(cosine_7, turn_rate_0, _r1), _r1), _r1)
    _s10 = _add(_add(_add(_add(_add(_multiply(along_0, cosine_7, _r1), _multiply(along_1, cosine_6, _r2), _r2), _multiply(along_2, cosine_5, _r1), _r1), _multiply(along_3, cosine_4, _r2), _r2), _multiply(along_4, cosine_3, _r1), _r1), _multiply(along_5, cosine_2, _r2), _r2)
    _s11 = _add(_s10, _multiply(along_6, cosine_1, _r1), _r1) + _multiply(along_7, cosine_0, _r2)
    _s12 = _multiply(_s0, _add(_add(_add(_multiply(_multiply(2.0, climb_0, _r2), climb_7, _r2), _multiply(_multiply(2.0, climb_1, _r1), climb_6, _r1), _r1), _multiply(_multiply(2.0, climb_2, _r2), climb_5, _r2), _r2), _multiply(_multiply(2.0, climb_3, _r1), climb_4, _r1), _r1), _r1)
    _s13 = _add(_add(_add(_add(_add(_multiply(omega_0, _s11, _r2), _multiply(omega_1, pressed_6, _r0), _r0), _multiply(omega_2, pressed_5, _r2), _r2), _multiply(omega_3, pressed_4, _r0), _r0), _multiply(omega_4, pressed_3, _r2), _r2), _multiply(omega_5, pressed_2, _r0), _r0)
    _s14 = _add(_add(_add(_add(_add(_multiply(climb_0, sine_7, _r2), _multiply(climb_1, sine_6, _r3), _r3), _multiply(climb_2, sine_5, _r2), _r2), _multiply(climb_3, sine_4, _r3), _r3), _multiply(climb_4, sine_3, _r2), _r2), _multiply(climb_5, sine_2, _r3), _r3)
    _s15 = _add(_add(_add(_add(_add(_multiply(climb_0, cosine_7, _r2), _multiply(climb_1, cosine_6, _r4), _r4), _multiply(climb_2, cosine_5, _r2), _r2), _multiply(climb_3, cosine_4, _r4), _r4), _multiply(climb_4, cosine_3, _r2), _r2), _multiply(climb_5, cosine_2, _r4), _r4)
    _s16 = _add(_add(_add(_add(_add(_multiply(omega_0, _s9, _r2), _multiply(omega_1, tilted_6, _r5), _r5), _multiply(omega_2, tilted_5, _r2), _r2), _multiply(omega_3, tilted_4, _r5), _r5), _multiply(omega_4, tilted_3, _r2), _r2), _multiply(omega_5, tilted_2, _r5), _r5)
    _s17 = _divide(_multiply(0.125, _add(_multiply(_multiply(0.6, cosine_7, _r2), p_gravity, _r2), _add(_add(_s16, _multiply(omega_6, tilted_1, _r6), _r6), _multiply(tilted_0, _s4, _r5), _r5), _r5), _r5), _s0, _r5)
    _s18 = _add(_add(_add(_add(_add(_multiply(around_0, sine_7, _r2), _multiply(around_1, sine_6, _r6), _r6), _multiply(around_2, sine_5, _r2), _r2), _multiply(around_3, sine_4, _r6), _r6), _multiply(around_4, sine_3, _r2), _r2), _multiply(around_5, sine_2, _r6), _r6)
    _s19 = _add(_add(_add(_add(_add(_multiply(climb_0, turn_rate_7, _r2), _multiply(climb_1, turn_rate_6, _r7), _r7), _multiply(climb_2, turn_rate_5, _r2), _r2), _multiply(climb_3, turn_rate_4, _r7), _r7), _multiply(climb_4, turn_rate_3, _r2), _r2), _multiply(climb_5, turn_rate_2, _r7), _r7)
    _s20 = 0.125 * _subtract(_multiply(_s0, _add(_add(_s18, _multiply(around_6, sine_1, _r2), _r2), _multiply(sine_0, _s6, _r6), _r6), _r6), _multiply(0.4, _add(_add(_s19, _multiply(climb_6, turn_rate_1, _r2), _r2), _multiply(climb_7, turn_rate_0, _r7), _r7), _r7), _r7)
    _s21 = _add(_add(_add(_add(_add(_multiply(omega_0, sin_7, _r7), _multiply(omega_1, sin_6, _r6), _r6), _multiply(omega_2, sin_5, _r7), _r7), _multiply(omega_3, sin_4, _r6), _r6), _multiply(omega_4, sin_3, _r7), _r7), _multiply(omega_5, sin_2, _r6), _r6)
    _s22 = _add(_add(_add(_add(_add(_multiply(cos_0, _s4, _r7), _multiply(cos_1, omega_6, _r2), _r2), _multiply(cos_2, omega_5, _r7), _r7), _multiply(cos_3, omega_4, _r2), _r2), _multiply(cos_4, omega_3, _r7), _r7), _multiply(cos_5, omega_2, _r2), _r2)
    return _s2, _s4, _s6, _s9, _s11, _subtract(_multiply(p_gravity, sine_7, _r7), _s12, _r1) - _add(_add(_s13, _multiply(omega_6, pressed_1, _r7), _r7), _multiply(pressed_0, _s4, _r0), _r0), -_multiply(0.125, _add(_add(_s14, _multiply(climb_6, sine_1, _r0), _r0), _multiply(climb_7, sine_0, _r3), _r3), _r3), 0.125 * _add(_add(_s15, _multiply(climb_6, cosine_1, _r3), _r3), _multiply(climb_7, cosine_0, _r4), _r4), -_s17, _s20, (0.125 * p_ring_radius) * _s6, -_multiply(0.125, _add(_add(_s21, _multiply(omega_6, sin_1, _r5), _r5), _multiply(sin_0, _s4, _r6), _r6), _r6), 0.125 * _add(_add(_s22, _multiply(cos_6, omega_1, _r6), _r6), _multiply(cos_7, omega_0, _r2), _r2)


def ring_round_8(along_0: Any, along_1: Any, along_2: Any, along_3: Any, along_4: Any, along_5: Any, along_6: Any, along_7: Any, along_8: Any, around_0: Any, around_1: Any, around_2: Any, around_3: Any, around_4: Any, around_5: Any, around_6: Any, around_7: Any, p_ball_radius: Any, climb_0: Any, climb_1: Any, climb_2: Any, climb_3: Any, climb_4: Any, climb_5: Any, climb_6: Any, climb_7: Any, climb_8: Any, cos_0: Any, cos_1: Any, cos_2: Any, cos_3: Any, cos_4: Any, cos_5: Any, cos_6: Any, cos_7: Any, cos_8: Any, cosine_0: Any, cosine_1: Any, cosine_2: Any, cosine_3: Any, cosine_4: Any, cosine_5: Any, cosine_6: Any, cosine_7: Any, cosine_8: Any, p_gravity: Any, near_0: Any, near_1: Any, near_2: Any, near_3: Any, near_4: Any, near_5: Any, near_6: Any, near_7: Any, omega_0: Any, omega_1: Any, omega_2: Any, omega_3: Any, omega_4: Any, omega_5: Any, omega_6: Any, omega_7: Any, pressed_0: Any, pressed_1: Any, pressed_2: Any, pressed_3: Any, pressed_4: Any, pressed_5: Any, pressed_6: Any, pressed_7: Any, p_ring_radius: Any, sin_0: Any, sin_1: Any, sin_2: Any, sin_3: Any, sin_4: Any, sin_5: Any, sin_6: Any, sin_7: Any, sin_8: Any, sine_0: Any, sine_1: Any, sine_2: Any, sine_3: Any, sine_4: Any, sine_5: Any, sine_6: Any, sine_7: Any, sine_8: Any, tilted_0: Any, tilted_1: Any, tilted_2: Any, tilted_3: Any, tilted_4: Any, tilted_5: Any, tilted_6: Any, tilted_7: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, turn_rate_5: Any, turn_rate_6: Any, turn_rate_7: Any, turn_rate_8: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 9, from those before.

    Routh's equations. 277 operations: 117 additions, 4 subtractions, 151 multiplications, 1 division, 4 negations.
    Returns near_8, omega_8, around_8, tilted_8, pressed_8, force_8, cosine_9, sine_9, climb_9, along_9, turn_rate_9, cos_9, sin_9.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6 = _room[:7]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = _add(_add(_add(_add(_add(_multiply(cosine_1, near_7, _r0), _multiply(cosine_2, near_6, _r1), _r1), _multiply(cosine_3, near_5, _r0), _r0), _multiply(cosine_4, near_4, _r1), _r1), _multiply(cosine_5, near_3, _r0), _r0), _multiply(cosine_6, near_2, _r1), _r1)
    _s2 = -_multiply(_multiply(near_0, _s0, _r0), _add(_add(_s1, _multiply(cosine_7, near_1, _r2), _r2), _multiply(cosine_8, near_0, _r1), _r1), _r0)
    _s3 = _add(_add(_add(_add(_add(_multiply(along_0, _s2, _r0), _multiply(along_1, near_7, _r1), _r1), _multiply(along_2, near_6, _r0), _r0), _multiply(along_3, near_5, _r1), _r1), _multiply(along_4, near_4, _r0), _r0), _multiply(along_5, near_3, _r1), _r1)
    _s4 = _add(_add(_s3, _multiply(along_6, near_2, _r0), _r0), _multiply(along_7, near_1, _r1), _r1) + _multiply(along_8, near_0, _r0)
    _s5 = _add(_add(_add(_add(_add(_multiply(climb_0, _s4, _r0), _multiply(climb_1, omega_7, _r1), _r1), _multiply(climb_2, omega_6, _r0), _r0), _multiply(climb_3, omega_5, _r1), _r1), _multiply(climb_4, omega_4, _r0), _r0), _multiply(climb_5, omega_3, _r1), _r1)
    _s6 = _add(_add(_s5, _multiply(climb_6, omega_2, _r0), _r0), _multiply(climb_7, omega_1, _r1), _r1) + _multiply(climb_8, omega_0, _r0)
    _s7 = _add(_add(_add(_add(_add(_multiply(along_0, sine_8, _r0), _multiply(along_1, sine_7, _r1), _r1), _multiply(along_2, sine_6, _r0), _r0), _multiply(along_3, sine_5, _r1), _r1), _multiply(along_4, sine_4, _r0), _r0), _multiply(along_5, sine_3, _r1), _r1)
    _s8 = _add(_add(_add(_add(_add(_multiply(cosine_0, turn_rate_8, _r0), _multiply(cosine_1, turn_rate_7, _r2), _r2), _multiply(cosine_2, turn_rate_6, _r0), _r0), _multiply(cosine_3, turn_rate_5, _r2), _r2), _multiply(cosine_4, turn_rate_4, _r0), _r0), _multiply(cosine_5, turn_rate_3, _r2), _r2)
    _s9 = _add(_add(_add(_s7, _multiply(along_6, sine_2, _r0), _r0), _multiply(along_7, sine_1, _r1), _r1), _multiply(along_8, sine_0, _r0), _r0) - _multiply(0.4, _add(_add(_add(_s8, _multiply(cosine_6, turn_rate_2, _r1), _r1), _multiply(cosine_7, turn_rate_1, _r2), _r2), _multiply(cosine_8, turn_rate_0, _r1), _r1), _r1)
    _s10 = _add(_add(_add(_add(_add(_multiply(along_0, cosine_8, _r1), _multiply(along_1, cosine_7, _r0), _r0), _multiply(along_2, cosine_6, _r1), _r1), _multiply(along_3, cosine_5, _r0), _r0), _multiply(along_4, cosine_4, _r1), _r1), _multiply(along_5, cosine_3, _r0), _r0)
    _s11 = _add(_add(_s10, _multiply(along_6, cosine_2, _r1), _r1), _multiply(along_7, cosine_1, _r0), _r0) + _multiply(along_8, cosine_0, _r1)
    _s12 = _add(_add(_add(_add(_multiply(climb_4, climb_4, _r1), _multiply(_multiply(2.0, climb_0, _r0), climb_8, _r0), _r0), _multiply(_multiply(2.0, climb_1, _r1), climb_7, _r1), _r1), _multiply(_multiply(2.0, climb_2, _r0), climb_6, _r0), _r0), _multiply(_multiply(2.0, climb_3, _r1), climb_5, _r1), _r1)
    _s13 = _add(_add(_add(_add(_add(_multiply(omega_0, _s11, _r0), _multiply(omega_1, pressed_7, _r2), _r2), _multiply(omega_2, pressed_6, _r0), _r0), _multiply(omega_3, pressed_5, _r2), _r2), _multiply(omega_4, pressed_4, _r0), _r0), _multiply(omega_5, pressed_3, _r2), _r2)
    _s14 = _add(_add(_add(_add(_add(_multiply(climb_0, sine_8, _r0), _multiply(climb_1, sine_7, _r3), _r3), _multiply(climb_2, sine_6, _r0), _r0), _multiply(climb_3, sine_5, _r3), _r3), _multiply(climb_4, sine_4, _r0), _r0), _multiply(climb_5, sine_3, _r3), _r3)
    _s15 = -_multiply(0.1111111111111111, _add(_add(_add(_s14, _multiply(climb_6, sine_2, _r0), _r0), _multiply(climb_7, sine_1, _r3), _r3), _multiply(climb_8, sine_0, _r0), _r0), _r0)
    _s16 = _add(_add(_add(_add(_add(_multiply(climb_0, cosine_8, _r0), _multiply(climb_1, cosine_7, _r3), _r3), _multiply(climb_2, cosine_6, _r0), _r0), _multiply(climb_3, cosine_5, _r3), _r3), _multiply(climb_4, cosine_4, _r0), _r0), _multiply(climb_5, cosine_3, _r3), _r3)
    _s17 = _add(_add(_add(_add(_add(_multiply(omega_0, _s9, _r0), _multiply(omega_1, tilted_7, _r4), _r4), _multiply(omega_2, tilted_6, _r0), _r0), _multiply(omega_3, tilted_5, _r4), _r4), _multiply(omega_4, tilted_4, _r0), _r0), _multiply(omega_5, tilted_3, _r4), _r4)
    _s18 = _multiply(0.1111111111111111, _add(_multiply(_multiply(0.6, cosine_8, _r0), p_gravity, _r0), _add(_add(_add(_s17, _multiply(omega_6, tilted_2, _r5), _r5), _multiply(omega_7, tilted_1, _r4), _r4), _multiply(tilted_0, _s4, _r5), _r5), _r5), _r5)
    _s19 = _add(_add(_add(_add(_add(_multiply(around_0, sine_8, _r0), _multiply(around_1, sine_7, _r4), _r4), _multiply(around_2, sine_6, _r0), _r0), _multiply(around_3, sine_5, _r4), _r4), _multiply(around_4, sine_4, _r0), _r0), _multiply(around_5, sine_3, _r4), _r4)
    _s20 = _add(_add(_add(_add(_add(_multiply(climb_0, turn_rate_8, _r0), _multiply(climb_1, turn_rate_7, _r6), _r6), _multiply(climb_2, turn_rate_6, _r0), _r0), _multiply(climb_3, turn_rate_5, _r6), _r6), _multiply(climb_4, turn_rate_4, _r0), _r0), _multiply(climb_5, turn_rate_3, _r6), _r6)
    _s21 = _subtract(_multiply(_s0, _add(_add(_add(_s19, _multiply(around_6, sine_2, _r0), _r0), _multiply(around_7, sine_1, _r4), _r4), _multiply(sine_0, _s6, _r0), _r0), _r0), _multiply(0.4, _add(_add(_add(_s20, _multiply(climb_6, turn_rate_2, _r4), _r4), _multiply(climb_7, turn_rate_1, _r6), _r6), _multiply(climb_8, turn_rate_0, _r4), _r4), _r4), _r4)
    _s22 = _add(_add(_add(_add(_add(_multiply(omega_0, sin_8, _r0), _multiply(omega_1, sin_7, _r6), _r6), _multiply(omega_2, sin_6, _r0), _r0), _multiply(omega_3, sin_5, _r6), _r6), _multiply(omega_4, sin_4, _r0), _r0), _multiply(omega_5, sin_3, _r6), _r6)
    _s23 = -_multiply(0.1111111111111111, _add(_add(_add(_s22, _multiply(omega_6, sin_2, _r0), _r0), _multiply(omega_7, sin_1, _r6), _r6), _multiply(sin_0, _s4, _r0), _r0), _r0)
    _s24 = _add(_add(_add(_add(_add(_multiply(cos_0, _s4, _r0), _multiply(cos_1, omega_7, _r6), _r6), _multiply(cos_2, omega_6, _r0), _r0), _multiply(cos_3, omega_5, _r6), _r6), _multiply(cos_4, omega_4, _r0), _r0), _multiply(cos_5, omega_3, _r6), _r6)
    return _s2, _s4, _s6, _s9, _s11, _subtract(_multiply(p_gravity, sine_8, _r0), _multiply(_s0, _s12, _r1), _r1) - _add(_add(_add(_s13, _multiply(omega_6, pressed_2, _r0), _r0), _multiply(omega_7, pressed_1, _r2), _r2), _multiply(pressed_0, _s4, _r0), _r0), _s15, 0.1111111111111111 * _add(_add(_add(_s16, _multiply(climb_6, cosine_2, _r0), _r0), _multiply(climb_7, cosine_1, _r3), _r3), _multiply(climb_8, cosine_0, _r0), _r0), -_divide(_s18, _s0, _r5), 0.1111111111111111 * _s21, (0.1111111111111111 * p_ring_radius) * _s6, _s23, 0.1111111111111111 * _add(_add(_add(_s24, _multiply(cos_6, omega_2, _r4), _r4), _multiply(cos_7, omega_1, _r6), _r6), _multiply(cos_8, omega_0, _r4), _r4)


def ring_round_9(along_0: Any, along_1: Any, along_2: Any, along_3: Any, along_4: Any, along_5: Any, along_6: Any, along_7: Any, along_8: Any, along_9: Any, around_0: Any, around_1: Any, around_2: Any, around_3: Any, around_4: Any, around_5: Any, around_6: Any, around_7: Any, around_8: Any, p_ball_radius: Any, climb_0: Any, climb_1: Any, climb_2: Any, climb_3: Any, climb_4: Any, climb_5: Any, climb_6: Any, climb_7: Any, climb_8: Any, climb_9: Any, cos_0: Any, cos_1: Any, cos_2: Any, cos_3: Any, cos_4: Any, cos_5: Any, cos_6: Any, cos_7: Any, cos_8: Any, cos_9: Any, cosine_0: Any, cosine_1: Any, cosine_2: Any, cosine_3: Any, cosine_4: Any, cosine_5: Any, cosine_6: Any, cosine_7: Any, cosine_8: Any, cosine_9: Any, p_gravity: Any, near_0: Any, near_1: Any, near_2: Any, near_3: Any, near_4: Any, near_5: Any, near_6: Any, near_7: Any, near_8: Any, omega_0: Any, omega_1: Any, omega_2: Any, omega_3: Any, omega_4: Any, omega_5: Any, omega_6: Any, omega_7: Any, omega_8: Any, pressed_0: Any, pressed_1: Any, pressed_2: Any, pressed_3: Any, pressed_4: Any, pressed_5: Any, pressed_6: Any, pressed_7: Any, pressed_8: Any, p_ring_radius: Any, sin_0: Any, sin_1: Any, sin_2: Any, sin_3: Any, sin_4: Any, sin_5: Any, sin_6: Any, sin_7: Any, sin_8: Any, sin_9: Any, sine_0: Any, sine_1: Any, sine_2: Any, sine_3: Any, sine_4: Any, sine_5: Any, sine_6: Any, sine_7: Any, sine_8: Any, sine_9: Any, tilted_0: Any, tilted_1: Any, tilted_2: Any, tilted_3: Any, tilted_4: Any, tilted_5: Any, tilted_6: Any, tilted_7: Any, tilted_8: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, turn_rate_5: Any, turn_rate_6: Any, turn_rate_7: Any, turn_rate_8: Any, turn_rate_9: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 10, from those before.

    Routh's equations. 306 operations: 131 additions, 4 subtractions, 166 multiplications, 1 division, 4 negations.
    Returns near_9, omega_9, around_9, tilted_9, pressed_9, force_9, cosine_10, sine_10, climb_10, along_10, turn_rate_10, cos_10, sin_10.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6 = _room[:7]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = _add(_add(_add(_add(_add(_multiply(cosine_1, near_8, _r0), _multiply(cosine_2, near_7, _r1), _r1), _multiply(cosine_3, near_6, _r0), _r0), _multiply(cosine_4, near_5, _r1), _r1), _multiply(cosine_5, near_4, _r0), _r0), _multiply(cosine_6, near_3, _r1), _r1)
    _s2 = -_multiply(_multiply(near_0, _s0, _r0), _add(_add(_add(_s1, _multiply(cosine_7, near_2, _r2), _r2), _multiply(cosine_8, near_1, _r1), _r1), _multiply(cosine_9, near_0, _r2), _r2), _r0)
    _s3 = _add(_add(_add(_add(_add(_multiply(along_0, _s2, _r0), _multiply(along_1, near_8, _r2), _r2), _multiply(along_2, near_7, _r0), _r0), _multiply(along_3, near_6, _r2), _r2), _multiply(along_4, near_5, _r0), _r0), _multiply(along_5, near_4, _r2), _r2)
    _s4 = _add(_add(_add(_s3, _multiply(along_6, near_3, _r0), _r0), _multiply(along_7, near_2, _r2), _r2), _multiply(along_8, near_1, _r0), _r0) + _multiply(along_9, near_0, _r2)
    _s5 = _add(_add(_add(_add(_add(_multiply(climb_0, _s4, _r2), _multiply(climb_1, omega_8, _r0), _r0), _multiply(climb_2, omega_7, _r2), _r2), _multiply(climb_3, omega_6, _r0), _r0), _multiply(climb_4, omega_5, _r2), _r2), _multiply(climb_5, omega_4, _r0), _r0)
    _s6 = _add(_add(_add(_s5, _multiply(climb_6, omega_3, _r2), _r2), _multiply(climb_7, omega_2, _r0), _r0), _multiply(climb_8, omega_1, _r2), _r2) + _multiply(climb_9, omega_0, _r0)
    _s7 = _add(_add(_add(_add(_add(_multiply(along_0, sine_9, _r0), _multiply(along_1, sine_8, _r2), _r2), _multiply(along_2, sine_7, _r0), _r0), _multiply(along_3, sine_6, _r2), _r2), _multiply(along_4, sine_5, _r0), _r0), _multiply(along_5, sine_4, _r2), _r2)
    _s8 = _add(_add(_add(_add(_add(_multiply(cosine_0, turn_rate_9, _r0), _multiply(cosine_1, turn_rate_8, _r1), _r1), _multiply(cosine_2, turn_rate_7, _r0), _r0), _multiply(cosine_3, turn_rate_6, _r1), _r1), _multiply(cosine_4, turn_rate_5, _r0), _r0), _multiply(cosine_5, turn_rate_4, _r1), _r1)
    _s9 = _multiply(0.4, _add(_add(_add(_add(_s8, _multiply(cosine_6, turn_rate_3, _r0), _r0), _multiply(cosine_7, turn_rate_2, _r1), _r1), _multiply(cosine_8, turn_rate_1, _r0), _r0), _multiply(cosine_9, turn_rate_0, _r1), _r1), _r1)
    _s10 = _add(_add(_add(_add(_s7, _multiply(along_6, sine_3, _r0), _r0), _multiply(along_7, sine_2, _r2), _r2), _multiply(along_8, sine_1, _r0), _r0), _multiply(along_9, sine_0, _r2), _r2) - _s9
    _s11 = _add(_add(_add(_add(_add(_multiply(along_0, cosine_9, _r1), _multiply(along_1, cosine_8, _r2), _r2), _multiply(along_2, cosine_7, _r1), _r1), _multiply(along_3, cosine_6, _r2), _r2), _multiply(along_4, cosine_5, _r1), _r1), _multiply(along_5, cosine_4, _r2), _r2)
    _s12 = _add(_add(_add(_s11, _multiply(along_6, cosine_3, _r1), _r1), _multiply(along_7, cosine_2, _r2), _r2), _multiply(along_8, cosine_1, _r1), _r1) + _multiply(along_9, cosine_0, _r2)
    _s13 = _add(_add(_add(_add(_multiply(_multiply(2.0, climb_0, _r2), climb_9, _r2), _multiply(_multiply(2.0, climb_1, _r1), climb_8, _r1), _r1), _multiply(_multiply(2.0, climb_2, _r2), climb_7, _r2), _r2), _multiply(_multiply(2.0, climb_3, _r1), climb_6, _r1), _r1), _multiply(_multiply(2.0, climb_4, _r2), climb_5, _r2), _r2)
    _s14 = _add(_add(_add(_add(_add(_multiply(omega_0, _s12, _r1), _multiply(omega_1, pressed_8, _r0), _r0), _multiply(omega_2, pressed_7, _r1), _r1), _multiply(omega_3, pressed_6, _r0), _r0), _multiply(omega_4, pressed_5, _r1), _r1), _multiply(omega_5, pressed_4, _r0), _r0)
    _s15 = _subtract(_multiply(p_gravity, sine_9, _r1), _multiply(_s0, _s13, _r2), _r2) - _add(_add(_add(_add(_s14, _multiply(omega_6, pressed_3, _r1), _r1), _multiply(omega_7, pressed_2, _r0), _r0), _multiply(omega_8, pressed_1, _r1), _r1), _multiply(pressed_0, _s4, _r0), _r0)
    _s16 = _add(_add(_add(_add(_add(_multiply(climb_0, sine_9, _r0), _multiply(climb_1, sine_8, _r2), _r2), _multiply(climb_2, sine_7, _r0), _r0), _multiply(climb_3, sine_6, _r2), _r2), _multiply(climb_4, sine_5, _r0), _r0), _multiply(climb_5, sine_4, _r2), _r2)
    _s17 = _multiply(0.1, _add(_add(_add(_add(_s16, _multiply(climb_6, sine_3, _r0), _r0), _multiply(climb_7, sine_2, _r2), _r2), _multiply(climb_8, sine_1, _r0), _r0), _multiply(climb_9, sine_0, _r2), _r2), _r2)
    _s18 = _add(_add(_add(_add(_add(_multiply(climb_0, cosine_9, _r0), _multiply(climb_1, cosine_8, _r1), _r1), _multiply(climb_2, cosine_7, _r0), _r0), _multiply(climb_3, cosine_6, _r1), _r1), _multiply(climb_4, cosine_5, _r0), _r0), _multiply(climb_5, cosine_4, _r1), _r1)
    _s19 = 0.1 * _add(_add(_add(_add(_s18, _multiply(climb_6, cosine_3, _r0), _r0), _multiply(climb_7, cosine_2, _r1), _r1), _multiply(climb_8, cosine_1, _r0), _r0), _multiply(climb_9, cosine_0, _r1), _r1)
    _s20 = _add(_add(_add(_add(_add(_multiply(omega_0, _s10, _r1), _multiply(omega_1, tilted_8, _r0), _r0), _multiply(omega_2, tilted_7, _r1), _r1), _multiply(omega_3, tilted_6, _r0), _r0), _multiply(omega_4, tilted_5, _r1), _r1), _multiply(omega_5, tilted_4, _r0), _r0)
    _s21 = _add(_multiply(_multiply(0.6, cosine_9, _r1), p_gravity, _r1), _add(_add(_add(_add(_s20, _multiply(omega_6, tilted_3, _r3), _r3), _multiply(omega_7, tilted_2, _r0), _r0), _multiply(omega_8, tilted_1, _r3), _r3), _multiply(tilted_0, _s4, _r0), _r0), _r0)
    _s22 = _add(_add(_add(_add(_add(_multiply(around_0, sine_9, _r1), _multiply(around_1, sine_8, _r3), _r3), _multiply(around_2, sine_7, _r1), _r1), _multiply(around_3, sine_6, _r3), _r3), _multiply(around_4, sine_5, _r1), _r1), _multiply(around_5, sine_4, _r3), _r3)
    _s23 = _multiply(_s0, _add(_add(_add(_add(_s22, _multiply(around_6, sine_3, _r1), _r1), _multiply(around_7, sine_2, _r3), _r3), _multiply(around_8, sine_1, _r1), _r1), _multiply(sine_0, _s6, _r3), _r3), _r3)
    _s24 = _add(_add(_add(_add(_add(_multiply(climb_0, turn_rate_9, _r1), _multiply(climb_1, turn_rate_8, _r4), _r4), _multiply(climb_2, turn_rate_7, _r1), _r1), _multiply(climb_3, turn_rate_6, _r4), _r4), _multiply(climb_4, turn_rate_5, _r1), _r1), _multiply(climb_5, turn_rate_4, _r4), _r4)
    _s25 = _multiply(0.4, _add(_add(_add(_add(_s24, _multiply(climb_6, turn_rate_3, _r1), _r1), _multiply(climb_7, turn_rate_2, _r4), _r4), _multiply(climb_8, turn_rate_1, _r1), _r1), _multiply(climb_9, turn_rate_0, _r4), _r4), _r4)
    _s26 = _add(_add(_add(_add(_add(_multiply(omega_0, sin_9, _r1), _multiply(omega_1, sin_8, _r5), _r5), _multiply(omega_2, sin_7, _r1), _r1), _multiply(omega_3, sin_6, _r5), _r5), _multiply(omega_4, sin_5, _r1), _r1), _multiply(omega_5, sin_4, _r5), _r5)
    _s27 = _multiply(0.1, _add(_add(_add(_add(_s26, _multiply(omega_6, sin_3, _r1), _r1), _multiply(omega_7, sin_2, _r5), _r5), _multiply(omega_8, sin_1, _r1), _r1), _multiply(sin_0, _s4, _r5), _r5), _r5)
    _s28 = _add(_add(_add(_add(_add(_multiply(cos_0, _s4, _r1), _multiply(cos_1, omega_8, _r6), _r6), _multiply(cos_2, omega_7, _r1), _r1), _multiply(cos_3, omega_6, _r6), _r6), _multiply(cos_4, omega_5, _r1), _r1), _multiply(cos_5, omega_4, _r6), _r6)
    _s29 = 0.1 * _add(_add(_add(_add(_s28, _multiply(cos_6, omega_3, _r1), _r1), _multiply(cos_7, omega_2, _r6), _r6), _multiply(cos_8, omega_1, _r1), _r1), _multiply(cos_9, omega_0, _r6), _r6)
    return _s2, _s4, _s6, _s10, _s12, _s15, -_s17, _s19, -_divide(_multiply(0.1, _s21, _r0), _s0, _r0), 0.1 * _subtract(_s23, _s25, _r4), (0.1 * p_ring_radius) * _s6, -_s27, _s29


def ring_round_10(along_0: Any, along_1: Any, along_10: Any, along_2: Any, along_3: Any, along_4: Any, along_5: Any, along_6: Any, along_7: Any, along_8: Any, along_9: Any, around_0: Any, around_1: Any, around_2: Any, around_3: Any, around_4: Any, around_5: Any, around_6: Any, around_7: Any, around_8: Any, around_9: Any, p_ball_radius: Any, climb_0: Any, climb_1: Any, climb_10: Any, climb_2: Any, climb_3: Any, climb_4: Any, climb_5: Any, climb_6: Any, climb_7: Any, climb_8: Any, climb_9: Any, cos_0: Any, cos_1: Any, cos_10: Any, cos_2: Any, cos_3: Any, cos_4: Any, cos_5: Any, cos_6: Any, cos_7: Any, cos_8: Any, cos_9: Any, cosine_0: Any, cosine_1: Any, cosine_10: Any, cosine_2: Any, cosine_3: Any, cosine_4: Any, cosine_5: Any, cosine_6: Any, cosine_7: Any, cosine_8: Any, cosine_9: Any, p_gravity: Any, near_0: Any, near_1: Any, near_2: Any, near_3: Any, near_4: Any, near_5: Any, near_6: Any, near_7: Any, near_8: Any, near_9: Any, omega_0: Any, omega_1: Any, omega_2: Any, omega_3: Any, omega_4: Any, omega_5: Any, omega_6: Any, omega_7: Any, omega_8: Any, omega_9: Any, pressed_0: Any, pressed_1: Any, pressed_2: Any, pressed_3: Any, pressed_4: Any, pressed_5: Any, pressed_6: Any, pressed_7: Any, pressed_8: Any, pressed_9: Any, p_ring_radius: Any, sin_0: Any, sin_1: Any, sin_10: Any, sin_2: Any, sin_3: Any, sin_4: Any, sin_5: Any, sin_6: Any, sin_7: Any, sin_8: Any, sin_9: Any, sine_0: Any, sine_1: Any, sine_10: Any, sine_2: Any, sine_3: Any, sine_4: Any, sine_5: Any, sine_6: Any, sine_7: Any, sine_8: Any, sine_9: Any, tilted_0: Any, tilted_1: Any, tilted_2: Any, tilted_3: Any, tilted_4: Any, tilted_5: Any, tilted_6: Any, tilted_7: Any, tilted_8: Any, tilted_9: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_10: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, turn_rate_5: Any, turn_rate_6: Any, turn_rate_7: Any, turn_rate_8: Any, turn_rate_9: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 11, from those before.

    Routh's equations. 336 operations: 146 additions, 4 subtractions, 181 multiplications, 1 division, 4 negations.
    Returns near_10, omega_10, around_10, tilted_10, pressed_10, force_10, cosine_11, sine_11, climb_11, along_11, turn_rate_11, cos_11, sin_11.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6 = _room[:7]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = _add(_add(_add(_add(_add(_multiply(cosine_1, near_9, _r0), _multiply(cosine_10, near_0, _r1), _r1), _multiply(cosine_2, near_8, _r0), _r0), _multiply(cosine_3, near_7, _r1), _r1), _multiply(cosine_4, near_6, _r0), _r0), _multiply(cosine_5, near_5, _r1), _r1)
    _s2 = _multiply(_multiply(near_0, _s0, _r0), _add(_add(_add(_add(_s1, _multiply(cosine_6, near_4, _r2), _r2), _multiply(cosine_7, near_3, _r1), _r1), _multiply(cosine_8, near_2, _r2), _r2), _multiply(cosine_9, near_1, _r1), _r1), _r0)
    _s3 = -_s2
    _s4 = _add(_add(_add(_add(_add(_multiply(along_0, _s3, _r0), _multiply(along_1, near_9, _r1), _r1), _multiply(along_10, near_0, _r0), _r0), _multiply(along_2, near_8, _r1), _r1), _multiply(along_3, near_7, _r0), _r0), _multiply(along_4, near_6, _r1), _r1)
    _s5 = _add(_add(_add(_add(_s4, _multiply(along_5, near_5, _r0), _r0), _multiply(along_6, near_4, _r1), _r1), _multiply(along_7, near_3, _r0), _r0), _multiply(along_8, near_2, _r1), _r1) + _multiply(along_9, near_1, _r0)
    _s6 = _add(_add(_add(_add(_add(_multiply(climb_0, _s5, _r0), _multiply(climb_1, omega_9, _r1), _r1), _multiply(climb_10, omega_0, _r0), _r0), _multiply(climb_2, omega_8, _r1), _r1), _multiply(climb_3, omega_7, _r0), _r0), _multiply(climb_4, omega_6, _r1), _r1)
    _s7 = _add(_add(_add(_add(_s6, _multiply(climb_5, omega_5, _r0), _r0), _multiply(climb_6, omega_4, _r1), _r1), _multiply(climb_7, omega_3, _r0), _r0), _multiply(climb_8, omega_2, _r1), _r1) + _multiply(climb_9, omega_1, _r0)
    _s8 = _add(_add(_add(_add(_add(_multiply(along_0, sine_10, _r0), _multiply(along_1, sine_9, _r1), _r1), _multiply(along_10, sine_0, _r0), _r0), _multiply(along_2, sine_8, _r1), _r1), _multiply(along_3, sine_7, _r0), _r0), _multiply(along_4, sine_6, _r1), _r1)
    _s9 = _add(_add(_add(_add(_add(_s8, _multiply(along_5, sine_5, _r0), _r0), _multiply(along_6, sine_4, _r1), _r1), _multiply(along_7, sine_3, _r0), _r0), _multiply(along_8, sine_2, _r1), _r1), _multiply(along_9, sine_1, _r0), _r0)
    _s10 = _add(_add(_add(_add(_add(_multiply(cosine_0, turn_rate_10, _r1), _multiply(cosine_1, turn_rate_9, _r2), _r2), _multiply(cosine_10, turn_rate_0, _r1), _r1), _multiply(cosine_2, turn_rate_8, _r2), _r2), _multiply(cosine_3, turn_rate_7, _r1), _r1), _multiply(cosine_4, turn_rate_6, _r2), _r2)
    _s11 = _add(_add(_add(_add(_add(_s10, _multiply(cosine_5, turn_rate_5, _r1), _r1), _multiply(cosine_6, turn_rate_4, _r2), _r2), _multiply(cosine_7, turn_rate_3, _r1), _r1), _multiply(cosine_8, turn_rate_2, _r2), _r2), _multiply(cosine_9, turn_rate_1, _r1), _r1)
    _s12 = _s9 - _multiply(0.4, _s11, _r1)
    _s13 = _add(_add(_add(_add(_add(_multiply(along_0, cosine_10, _r1), _multiply(along_1, cosine_9, _r0), _r0), _multiply(along_10, cosine_0, _r1), _r1), _multiply(along_2, cosine_8, _r0), _r0), _multiply(along_3, cosine_7, _r1), _r1), _multiply(along_4, cosine_6, _r0), _r0)
    _s14 = _add(_add(_add(_add(_s13, _multiply(along_5, cosine_5, _r1), _r1), _multiply(along_6, cosine_4, _r0), _r0), _multiply(along_7, cosine_3, _r1), _r1), _multiply(along_8, cosine_2, _r0), _r0) + _multiply(along_9, cosine_1, _r1)
    _s15 = _add(_add(_add(_add(_multiply(climb_5, climb_5, _r1), _multiply(_multiply(2.0, climb_0, _r0), climb_10, _r0), _r0), _multiply(_multiply(2.0, climb_1, _r1), climb_9, _r1), _r1), _multiply(_multiply(2.0, climb_2, _r0), climb_8, _r0), _r0), _multiply(_multiply(2.0, climb_3, _r1), climb_7, _r1), _r1)
    _s16 = _add(_add(_add(_add(_add(_multiply(omega_0, _s14, _r0), _multiply(omega_1, pressed_9, _r2), _r2), _multiply(omega_2, pressed_8, _r0), _r0), _multiply(omega_3, pressed_7, _r2), _r2), _multiply(omega_4, pressed_6, _r0), _r0), _multiply(omega_5, pressed_5, _r2), _r2)
    _s17 = _add(_add(_add(_add(_add(_s16, _multiply(omega_6, pressed_4, _r0), _r0), _multiply(omega_7, pressed_3, _r2), _r2), _multiply(omega_8, pressed_2, _r0), _r0), _multiply(omega_9, pressed_1, _r2), _r2), _multiply(pressed_0, _s5, _r0), _r0)
    _s18 = _subtract(_multiply(p_gravity, sine_10, _r2), _multiply(_s0, _add(_s15, _multiply(_multiply(2.0, climb_4, _r3), climb_6, _r3), _r3), _r3), _r3) - _s17
    _s19 = _add(_add(_add(_add(_add(_multiply(climb_0, sine_10, _r0), _multiply(climb_1, sine_9, _r3), _r3), _multiply(climb_10, sine_0, _r0), _r0), _multiply(climb_2, sine_8, _r3), _r3), _multiply(climb_3, sine_7, _r0), _r0), _multiply(climb_4, sine_6, _r3), _r3)
    _s20 = _add(_add(_add(_add(_add(_s19, _multiply(climb_5, sine_5, _r0), _r0), _multiply(climb_6, sine_4, _r3), _r3), _multiply(climb_7, sine_3, _r0), _r0), _multiply(climb_8, sine_2, _r3), _r3), _multiply(climb_9, sine_1, _r0), _r0)
    _s21 = _add(_add(_add(_add(_add(_multiply(climb_0, cosine_10, _r3), _multiply(climb_1, cosine_9, _r2), _r2), _multiply(climb_10, cosine_0, _r3), _r3), _multiply(climb_2, cosine_8, _r2), _r2), _multiply(climb_3, cosine_7, _r3), _r3), _multiply(climb_4, cosine_6, _r2), _r2)
    _s22 = _add(_add(_add(_add(_add(_s21, _multiply(climb_5, cosine_5, _r3), _r3), _multiply(climb_6, cosine_4, _r2), _r2), _multiply(climb_7, cosine_3, _r3), _r3), _multiply(climb_8, cosine_2, _r2), _r2), _multiply(climb_9, cosine_1, _r3), _r3)
    _s23 = _add(_add(_add(_add(_add(_multiply(omega_0, _s12, _r2), _multiply(omega_1, tilted_9, _r1), _r1), _multiply(omega_2, tilted_8, _r2), _r2), _multiply(omega_3, tilted_7, _r1), _r1), _multiply(omega_4, tilted_6, _r2), _r2), _multiply(omega_5, tilted_5, _r1), _r1)
    _s24 = _add(_add(_add(_add(_add(_s23, _multiply(omega_6, tilted_4, _r2), _r2), _multiply(omega_7, tilted_3, _r1), _r1), _multiply(omega_8, tilted_2, _r2), _r2), _multiply(omega_9, tilted_1, _r1), _r1), _multiply(tilted_0, _s5, _r2), _r2)
    _s25 = -_divide(_multiply(0.09090909090909091, _add(_multiply(_multiply(0.6, cosine_10, _r1), p_gravity, _r1), _s24, _r2), _r2), _s0, _r2)
    _s26 = _add(_add(_add(_add(_add(_multiply(around_0, sine_10, _r2), _multiply(around_1, sine_9, _r1), _r1), _multiply(around_2, sine_8, _r2), _r2), _multiply(around_3, sine_7, _r1), _r1), _multiply(around_4, sine_6, _r2), _r2), _multiply(around_5, sine_5, _r1), _r1)
    _s27 = _add(_add(_add(_add(_add(_s26, _multiply(around_6, sine_4, _r2), _r2), _multiply(around_7, sine_3, _r1), _r1), _multiply(around_8, sine_2, _r2), _r2), _multiply(around_9, sine_1, _r1), _r1), _multiply(sine_0, _s7, _r2), _r2)
    _s28 = _add(_add(_add(_add(_add(_multiply(climb_0, turn_rate_10, _r1), _multiply(climb_1, turn_rate_9, _r4), _r4), _multiply(climb_10, turn_rate_0, _r1), _r1), _multiply(climb_2, turn_rate_8, _r4), _r4), _multiply(climb_3, turn_rate_7, _r1), _r1), _multiply(climb_4, turn_rate_6, _r4), _r4)
    _s29 = _add(_add(_add(_add(_add(_s28, _multiply(climb_5, turn_rate_5, _r1), _r1), _multiply(climb_6, turn_rate_4, _r4), _r4), _multiply(climb_7, turn_rate_3, _r1), _r1), _multiply(climb_8, turn_rate_2, _r4), _r4), _multiply(climb_9, turn_rate_1, _r1), _r1)
    _s30 = _add(_add(_add(_add(_add(_multiply(omega_0, sin_10, _r4), _multiply(omega_1, sin_9, _r5), _r5), _multiply(omega_2, sin_8, _r4), _r4), _multiply(omega_3, sin_7, _r5), _r5), _multiply(omega_4, sin_6, _r4), _r4), _multiply(omega_5, sin_5, _r5), _r5)
    _s31 = _add(_add(_add(_add(_add(_s30, _multiply(omega_6, sin_4, _r4), _r4), _multiply(omega_7, sin_3, _r5), _r5), _multiply(omega_8, sin_2, _r4), _r4), _multiply(omega_9, sin_1, _r5), _r5), _multiply(sin_0, _s5, _r4), _r4)
    _s32 = _add(_add(_add(_add(_add(_multiply(cos_0, _s5, _r5), _multiply(cos_1, omega_9, _r6), _r6), _multiply(cos_10, omega_0, _r5), _r5), _multiply(cos_2, omega_8, _r6), _r6), _multiply(cos_3, omega_7, _r5), _r5), _multiply(cos_4, omega_6, _r6), _r6)
    _s33 = _add(_add(_add(_add(_add(_s32, _multiply(cos_5, omega_5, _r5), _r5), _multiply(cos_6, omega_4, _r6), _r6), _multiply(cos_7, omega_3, _r5), _r5), _multiply(cos_8, omega_2, _r6), _r6), _multiply(cos_9, omega_1, _r5), _r5)
    return _s3, _s5, _s7, _s12, _s14, _s18, -_multiply(0.09090909090909091, _s20, _r0), 0.09090909090909091 * _s22, _s25, 0.09090909090909091 * _subtract(_multiply(_s0, _s27, _r2), _multiply(0.4, _s29, _r1), _r1), (0.09090909090909091 * p_ring_radius) * _s7, -_multiply(0.09090909090909091, _s31, _r4), 0.09090909090909091 * _s33


def ring_round_11(along_0: Any, along_1: Any, along_10: Any, along_11: Any, along_2: Any, along_3: Any, along_4: Any, along_5: Any, along_6: Any, along_7: Any, along_8: Any, along_9: Any, around_0: Any, around_1: Any, around_10: Any, around_2: Any, around_3: Any, around_4: Any, around_5: Any, around_6: Any, around_7: Any, around_8: Any, around_9: Any, p_ball_radius: Any, climb_0: Any, climb_1: Any, climb_10: Any, climb_11: Any, climb_2: Any, climb_3: Any, climb_4: Any, climb_5: Any, climb_6: Any, climb_7: Any, climb_8: Any, climb_9: Any, cos_0: Any, cos_1: Any, cos_10: Any, cos_11: Any, cos_2: Any, cos_3: Any, cos_4: Any, cos_5: Any, cos_6: Any, cos_7: Any, cos_8: Any, cos_9: Any, cosine_0: Any, cosine_1: Any, cosine_10: Any, cosine_11: Any, cosine_2: Any, cosine_3: Any, cosine_4: Any, cosine_5: Any, cosine_6: Any, cosine_7: Any, cosine_8: Any, cosine_9: Any, p_gravity: Any, near_0: Any, near_1: Any, near_10: Any, near_2: Any, near_3: Any, near_4: Any, near_5: Any, near_6: Any, near_7: Any, near_8: Any, near_9: Any, omega_0: Any, omega_1: Any, omega_10: Any, omega_2: Any, omega_3: Any, omega_4: Any, omega_5: Any, omega_6: Any, omega_7: Any, omega_8: Any, omega_9: Any, pressed_0: Any, pressed_1: Any, pressed_10: Any, pressed_2: Any, pressed_3: Any, pressed_4: Any, pressed_5: Any, pressed_6: Any, pressed_7: Any, pressed_8: Any, pressed_9: Any, p_ring_radius: Any, sin_0: Any, sin_1: Any, sin_10: Any, sin_11: Any, sin_2: Any, sin_3: Any, sin_4: Any, sin_5: Any, sin_6: Any, sin_7: Any, sin_8: Any, sin_9: Any, sine_0: Any, sine_1: Any, sine_10: Any, sine_11: Any, sine_2: Any, sine_3: Any, sine_4: Any, sine_5: Any, sine_6: Any, sine_7: Any, sine_8: Any, sine_9: Any, tilted_0: Any, tilted_1: Any, tilted_10: Any, tilted_2: Any, tilted_3: Any, tilted_4: Any, tilted_5: Any, tilted_6: Any, tilted_7: Any, tilted_8: Any, tilted_9: Any, turn_rate_0: Any, turn_rate_1: Any, turn_rate_10: Any, turn_rate_11: Any, turn_rate_2: Any, turn_rate_3: Any, turn_rate_4: Any, turn_rate_5: Any, turn_rate_6: Any, turn_rate_7: Any, turn_rate_8: Any, turn_rate_9: Any, p_wire_radius: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The terms of order 12, from those before.

    Routh's equations. 365 operations: 160 additions, 4 subtractions, 196 multiplications, 1 division, 4 negations.
    Returns near_11, omega_11, around_11, tilted_11, pressed_11, force_11, cosine_12, sine_12, climb_12, along_12, turn_rate_12, cos_12, sin_12.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6 = _room[:7]
    _s0 = p_ball_radius + p_wire_radius
    _s1 = _add(_add(_add(_add(_add(_multiply(cosine_1, near_10, _r0), _multiply(cosine_10, near_1, _r1), _r1), _multiply(cosine_11, near_0, _r0), _r0), _multiply(cosine_2, near_9, _r1), _r1), _multiply(cosine_3, near_8, _r0), _r0), _multiply(cosine_4, near_7, _r1), _r1)
    _s2 = _add(_add(_add(_add(_add(_s1, _multiply(cosine_5, near_6, _r0), _r0), _multiply(cosine_6, near_5, _r1), _r1), _multiply(cosine_7, near_4, _r0), _r0), _multiply(cosine_8, near_3, _r1), _r1), _multiply(cosine_9, near_2, _r0), _r0)
    _s3 = -_multiply(_multiply(near_0, _s0, _r1), _s2, _r1)
    _s4 = _add(_add(_add(_add(_add(_multiply(along_0, _s3, _r1), _multiply(along_1, near_10, _r0), _r0), _multiply(along_10, near_1, _r1), _r1), _multiply(along_11, near_0, _r0), _r0), _multiply(along_2, near_9, _r1), _r1), _multiply(along_3, near_8, _r0), _r0)
    _s5 = _add(_add(_add(_add(_add(_s4, _multiply(along_4, near_7, _r1), _r1), _multiply(along_5, near_6, _r0), _r0), _multiply(along_6, near_5, _r1), _r1), _multiply(along_7, near_4, _r0), _r0), _multiply(along_8, near_3, _r1), _r1)
    _s6 = _s5 + _multiply(along_9, near_2, _r0)
    _s7 = _add(_add(_add(_add(_add(_multiply(climb_0, _s6, _r0), _multiply(climb_1, omega_10, _r1), _r1), _multiply(climb_10, omega_1, _r0), _r0), _multiply(climb_11, omega_0, _r1), _r1), _multiply(climb_2, omega_9, _r0), _r0), _multiply(climb_3, omega_8, _r1), _r1)
    _s8 = _add(_add(_add(_add(_add(_s7, _multiply(climb_4, omega_7, _r0), _r0), _multiply(climb_5, omega_6, _r1), _r1), _multiply(climb_6, omega_5, _r0), _r0), _multiply(climb_7, omega_4, _r1), _r1), _multiply(climb_8, omega_3, _r0), _r0)
    _s9 = _s8 + _multiply(climb_9, omega_2, _r1)
    _s10 = _add(_add(_add(_add(_add(_multiply(along_0, sine_11, _r1), _multiply(along_1, sine_10, _r0), _r0), _multiply(along_10, sine_1, _r1), _r1), _multiply(along_11, sine_0, _r0), _r0), _multiply(along_2, sine_9, _r1), _r1), _multiply(along_3, sine_8, _r0), _r0)
    _s11 = _add(_add(_add(_add(_add(_s10, _multiply(along_4, sine_7, _r1), _r1), _multiply(along_5, sine_6, _r0), _r0), _multiply(along_6, sine_5, _r1), _r1), _multiply(along_7, sine_4, _r0), _r0), _multiply(along_8, sine_3, _r1), _r1)
    _s12 = _add(_add(_add(_add(_add(_multiply(cosine_0, turn_rate_11, _r0), _multiply(cosine_1, turn_rate_10, _r2), _r2), _multiply(cosine_10, turn_rate_1, _r0), _r0), _multiply(cosine_11, turn_rate_0, _r2), _r2), _multiply(cosine_2, turn_rate_9, _r0), _r0), _multiply(cosine_3, turn_rate_8, _r2), _r2)
    _s13 = _add(_add(_add(_add(_add(_s12, _multiply(cosine_4, turn_rate_7, _r0), _r0), _multiply(cosine_5, turn_rate_6, _r2), _r2), _multiply(cosine_6, turn_rate_5, _r0), _r0), _multiply(cosine_7, turn_rate_4, _r2), _r2), _multiply(cosine_8, turn_rate_3, _r0), _r0)
    _s14 = _add(_s11, _multiply(along_9, sine_2, _r2), _r2) - _multiply(0.4, _add(_s13, _multiply(cosine_9, turn_rate_2, _r1), _r1), _r1)
    _s15 = _add(_add(_add(_add(_add(_multiply(along_0, cosine_11, _r1), _multiply(along_1, cosine_10, _r2), _r2), _multiply(along_10, cosine_1, _r1), _r1), _multiply(along_11, cosine_0, _r2), _r2), _multiply(along_2, cosine_9, _r1), _r1), _multiply(along_3, cosine_8, _r2), _r2)
    _s16 = _add(_add(_add(_add(_add(_s15, _multiply(along_4, cosine_7, _r1), _r1), _multiply(along_5, cosine_6, _r2), _r2), _multiply(along_6, cosine_5, _r1), _r1), _multiply(along_7, cosine_4, _r2), _r2), _multiply(along_8, cosine_3, _r1), _r1)
    _s17 = _s16 + _multiply(along_9, cosine_2, _r2)
    _s18 = _add(_add(_add(_add(_multiply(_multiply(2.0, climb_0, _r2), climb_11, _r2), _multiply(_multiply(2.0, climb_1, _r1), climb_10, _r1), _r1), _multiply(_multiply(2.0, climb_2, _r2), climb_9, _r2), _r2), _multiply(_multiply(2.0, climb_3, _r1), climb_8, _r1), _r1), _multiply(_multiply(2.0, climb_4, _r2), climb_7, _r2), _r2)
    _s19 = _add(_add(_add(_add(_add(_multiply(omega_0, _s17, _r1), _multiply(omega_1, pressed_10, _r0), _r0), _multiply(omega_10, pressed_1, _r1), _r1), _multiply(omega_2, pressed_9, _r0), _r0), _multiply(omega_3, pressed_8, _r1), _r1), _multiply(omega_4, pressed_7, _r0), _r0)
    _s20 = _add(_add(_add(_add(_add(_s19, _multiply(omega_5, pressed_6, _r1), _r1), _multiply(omega_6, pressed_5, _r0), _r0), _multiply(omega_7, pressed_4, _r1), _r1), _multiply(omega_8, pressed_3, _r0), _r0), _multiply(omega_9, pressed_2, _r1), _r1)
    _s21 = _subtract(_multiply(p_gravity, sine_11, _r0), _multiply(_s0, _add(_s18, _multiply(_multiply(2.0, climb_5, _r3), climb_6, _r3), _r3), _r3), _r3) - _add(_s20, _multiply(pressed_0, _s6, _r0), _r0)
    _s22 = _add(_add(_add(_add(_add(_multiply(climb_0, sine_11, _r0), _multiply(climb_1, sine_10, _r3), _r3), _multiply(climb_10, sine_1, _r0), _r0), _multiply(climb_11, sine_0, _r3), _r3), _multiply(climb_2, sine_9, _r0), _r0), _multiply(climb_3, sine_8, _r3), _r3)
    _s23 = _add(_add(_add(_add(_add(_s22, _multiply(climb_4, sine_7, _r0), _r0), _multiply(climb_5, sine_6, _r3), _r3), _multiply(climb_6, sine_5, _r0), _r0), _multiply(climb_7, sine_4, _r3), _r3), _multiply(climb_8, sine_3, _r0), _r0)
    _s24 = _add(_add(_add(_add(_add(_multiply(climb_0, cosine_11, _r3), _multiply(climb_1, cosine_10, _r1), _r1), _multiply(climb_10, cosine_1, _r3), _r3), _multiply(climb_11, cosine_0, _r1), _r1), _multiply(climb_2, cosine_9, _r3), _r3), _multiply(climb_3, cosine_8, _r1), _r1)
    _s25 = _add(_add(_add(_add(_add(_s24, _multiply(climb_4, cosine_7, _r3), _r3), _multiply(climb_5, cosine_6, _r1), _r1), _multiply(climb_6, cosine_5, _r3), _r3), _multiply(climb_7, cosine_4, _r1), _r1), _multiply(climb_8, cosine_3, _r3), _r3)
    _s26 = _add(_add(_add(_add(_add(_multiply(omega_0, _s14, _r1), _multiply(omega_1, tilted_10, _r2), _r2), _multiply(omega_10, tilted_1, _r1), _r1), _multiply(omega_2, tilted_9, _r2), _r2), _multiply(omega_3, tilted_8, _r1), _r1), _multiply(omega_4, tilted_7, _r2), _r2)
    _s27 = _add(_add(_add(_add(_add(_s26, _multiply(omega_5, tilted_6, _r1), _r1), _multiply(omega_6, tilted_5, _r2), _r2), _multiply(omega_7, tilted_4, _r1), _r1), _multiply(omega_8, tilted_3, _r2), _r2), _multiply(omega_9, tilted_2, _r1), _r1)
    _s28 = -_divide(_multiply(0.08333333333333333, _add(_multiply(_multiply(0.6, cosine_11, _r2), p_gravity, _r2), _add(_s27, _multiply(tilted_0, _s6, _r4), _r4), _r4), _r4), _s0, _r4)
    _s29 = _add(_add(_add(_add(_add(_multiply(around_0, sine_11, _r4), _multiply(around_1, sine_10, _r2), _r2), _multiply(around_10, sine_1, _r4), _r4), _multiply(around_2, sine_9, _r2), _r2), _multiply(around_3, sine_8, _r4), _r4), _multiply(around_4, sine_7, _r2), _r2)
    _s30 = _add(_add(_add(_add(_add(_s29, _multiply(around_5, sine_6, _r4), _r4), _multiply(around_6, sine_5, _r2), _r2), _multiply(around_7, sine_4, _r4), _r4), _multiply(around_8, sine_3, _r2), _r2), _multiply(around_9, sine_2, _r4), _r4)
    _s31 = _add(_add(_add(_add(_add(_multiply(climb_0, turn_rate_11, _r2), _multiply(climb_1, turn_rate_10, _r1), _r1), _multiply(climb_10, turn_rate_1, _r2), _r2), _multiply(climb_11, turn_rate_0, _r1), _r1), _multiply(climb_2, turn_rate_9, _r2), _r2), _multiply(climb_3, turn_rate_8, _r1), _r1)
    _s32 = _add(_add(_add(_add(_add(_s31, _multiply(climb_4, turn_rate_7, _r2), _r2), _multiply(climb_5, turn_rate_6, _r1), _r1), _multiply(climb_6, turn_rate_5, _r2), _r2), _multiply(climb_7, turn_rate_4, _r1), _r1), _multiply(climb_8, turn_rate_3, _r2), _r2)
    _s33 = _add(_add(_add(_add(_add(_multiply(omega_0, sin_11, _r1), _multiply(omega_1, sin_10, _r5), _r5), _multiply(omega_10, sin_1, _r1), _r1), _multiply(omega_2, sin_9, _r5), _r5), _multiply(omega_3, sin_8, _r1), _r1), _multiply(omega_4, sin_7, _r5), _r5)
    _s34 = _add(_add(_add(_add(_add(_s33, _multiply(omega_5, sin_6, _r1), _r1), _multiply(omega_6, sin_5, _r5), _r5), _multiply(omega_7, sin_4, _r1), _r1), _multiply(omega_8, sin_3, _r5), _r5), _multiply(omega_9, sin_2, _r1), _r1)
    _s35 = _add(_add(_add(_add(_add(_multiply(cos_0, _s6, _r5), _multiply(cos_1, omega_10, _r6), _r6), _multiply(cos_10, omega_1, _r5), _r5), _multiply(cos_11, omega_0, _r6), _r6), _multiply(cos_2, omega_9, _r5), _r5), _multiply(cos_3, omega_8, _r6), _r6)
    _s36 = _add(_add(_add(_add(_add(_s35, _multiply(cos_4, omega_7, _r5), _r5), _multiply(cos_5, omega_6, _r6), _r6), _multiply(cos_6, omega_5, _r5), _r5), _multiply(cos_7, omega_4, _r6), _r6), _multiply(cos_8, omega_3, _r5), _r5)
    return _s3, _s6, _s9, _s14, _s17, _s21, -_multiply(0.08333333333333333, _add(_s23, _multiply(climb_9, sine_2, _r6), _r6), _r6), 0.08333333333333333 * _add(_s25, _multiply(climb_9, cosine_2, _r6), _r6), _s28, 0.08333333333333333 * _subtract(_multiply(_s0, _add(_s30, _multiply(sine_0, _s9, _r6), _r6), _r6), _multiply(0.4, _add(_s32, _multiply(climb_9, turn_rate_2, _r4), _r4), _r4), _r4), (0.08333333333333333 * p_ring_radius) * _s9, -_multiply(0.08333333333333333, _add(_s34, _multiply(sin_0, _s6, _r4), _r4), _r4), 0.08333333333333333 * _add(_s36, _multiply(cos_9, omega_2, _r4), _r4)


def ring_enter(after: Any, end: Any, high0: Any, high1: Any, high2: Any, low0: Any, low1: Any, low2: Any, t: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The first window that ends later than a time, if there is one, from then on.

    Table 1. 18 operations: 6 comparisons, 3 disjunctions, 9 selections.
    Returns t, end, searching.
    """
    _r0, _r1, _r2, _r3, _r4 = _room[:5]
    _s0 = _select(after < low0, low0, after, _r0)
    _s1 = _s0 < high0
    _s2 = _select(after < low1, low1, after, _r1)
    _s3 = _s2 < high1
    _s4 = _select(after < low2, low2, after, _r2)
    _s5 = _s4 < high2
    return _result(_s1, _s0, _select(_s3, _s2, _select(_s5, _s4, t, _r3), _r4), _r0), _result(_s1, high0, _select(_s3, high1, _select(_s5, high2, end, _r4), _r3), _r0), _logical_or(_logical_or(_logical_or(False, _s5), _s3), _s1)


def backboard_normal(x: Any, y: Any, z: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Outward unit normal n3 at a contact.

    Table 2. 28 operations: 4 additions, 6 subtractions, 3 multiplications, 1 division, 2 negations, 6 comparisons, 6 selections.
    Returns nx, ny, nz.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7 = _room[:8]
    _s0 = 1.0 / p_ball_radius
    _s1 = _add(p_board_distance, x, _r0)
    _s2 = _negative(_add(p_board_distance + p_board_thickness, x, _r1), _r1)
    _s3 = _subtract(y, p_board_half_width, _r2)
    _s4 = _negative(_add(p_board_half_width, y, _r3), _r3)
    _s5 = _subtract(z, p_board_top, _r4)
    _s6 = _subtract(p_board_bottom, z, _r5)
    return _s0 * _subtract(_select(_s1 < 0.0, 0.0, _s1, _r6), _select(_s2 < 0.0, 0.0, _s2, _r7), _r7), _s0 * _subtract(_select(_s3 < 0.0, 0.0, _s3, _r7), _select(_s4 < 0.0, 0.0, _s4, _r1), _r1), _s0 * _subtract(_select(_s5 < 0.0, 0.0, _s5, _r1), _select(_s6 < 0.0, 0.0, _s6, _r3), _r3)


def backboard_curvature(p_ball_radius: Any) -> tuple[Any, ...]:
    """Bound on the rate at which the normal turns along the contact surface.

    Table 2. 1 operation: 1 division.
    Returns curvature.
    """
    return 1.0 / p_ball_radius,


def backboard_carry_normal(x: Any, y: Any, z: Any, dx: Any, dy: Any, dz: Any, shift: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Error of the normal, from that of the position.

    derivative of Table 2's normal. 32 operations: 4 additions, 6 subtractions, 4 multiplications, 1 division, 5 negations, 6 comparisons, 6 selections.
    Returns dnx, dny, dnz, turn.
    """
    _r0, _r1, _r2, _r3 = _room[:4]
    _s0 = 1.0 / p_ball_radius
    _s1 = _subtract(_select(_add(p_board_distance, x, _r0) < 0.0, 0.0, dx, _r0), _select(_negative(_add(p_board_distance + p_board_thickness, x, _r1), _r1) < 0.0, 0.0, _negative(dx, _r1), _r2), _r2)
    _s2 = _s0 * _subtract(_select(_subtract(y, p_board_half_width, _r1) < 0.0, 0.0, dy, _r1), _select(_negative(_add(p_board_half_width, y, _r0), _r0) < 0.0, 0.0, _negative(dy, _r0), _r3), _r3)
    return _s0 * _s1, _s2, _s0 * _subtract(_select(_subtract(z, p_board_top, _r2) < 0.0, 0.0, dz, _r2), _select(_subtract(p_board_bottom, z, _r3) < 0.0, 0.0, _negative(dz, _r3), _r0), _r0), shift * _s0


def backboard_prepare(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Constants and windows of the search along a flight, and the errors it allows for.

    bounds of the event condition. 135 operations: 27 additions, 10 subtractions, 28 multiplications, 5 divisions, 4 square roots, 5 negations, 4 absolute values, 25 comparisons, 27 selections.
    Returns low0, high0, low1, high1, ceiling, latest, lost.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18, _r19, _r20, _r21, _r22 = _room[:23]
    _s0 = _absolute(vx, _r0)
    _s1 = 0.5 * p_board_thickness
    _s2 = p_ball_radius + _s1
    _s3 = 0.5 * p_board_top
    _s4 = p_ball_radius + _s3
    _s5 = 0.5 * p_board_bottom
    _s6 = _s4 - _s5
    _s7 = p_ball_radius + p_board_half_width
    _s8 = _where(_s7 < _s2, _s7, _s2)
    _s9 = _where(_s6 < _s8, _s6, _s8)
    _s10 = 6.103515625e-05 * _s9
    _s11 = _s2 + _s10
    _s12 = p_board_distance + _s1
    _s13 = _add(_s12, x, _r1)
    _s14 = _select(vx < 0.0, _negative(_s13, _r2), _s13, _r3)
    _s15 = _divide(_negative(_add(_s11, _s14, _r4), _r4), _s0, _r4)
    _s16 = _select(0.0 < _s15, _s15, 0.0, _r5)
    _s17 = _absolute(vy, _r6)
    _s18 = _s7 + _s10
    _s19 = _select(vy < 0.0, _negative(y, _r7), y, _r8)
    _s20 = _divide(_negative(_add(_s18, _s19, _r9), _r9), _s17, _r9)
    _s21 = _select(_s16 < _s20, _s20, _s16, _r10)
    _s22 = _multiply(vz, vz, _r11)
    _s23 = _subtract(_subtract(z, _s5, _r12), _s3, _r12)
    _s24 = (_s4 + _s10) - _s5
    _s25 = 2.0 * p_gravity
    _s26 = _add(_s22, _multiply(_s25, _add(_s23, _s24, _r13), _r13), _r13)
    _s27 = 1.0 / p_gravity
    _s28 = _sqrt(_s26, _r14)
    _s29 = 0.0 <= _s26
    _s30 = _select(_s29, _multiply(_s27, _subtract(vz, _s28, _r13), _r13), _inf, _r15)
    _s31 = _select(_s21 < _s30, _s30, _s21, _r16)
    _s32 = _add(_s22, _multiply(_s25, _subtract(_s23, _s24, _r12), _r12), _r12)
    _s33 = _sqrt(_select(_s32 < 0.0, 0.0, _s32, _r11), _r11)
    _s34 = _select(_s29, _multiply(_s27, _add(vz, _s28, _r14), _r14), -_inf, _r17)
    _s35 = 0.0 < _s32
    _s36 = _select(_s35, _multiply(_s27, _subtract(vz, _s33, _r12), _r12), _s34, _r18)
    _s37 = _divide(_subtract(_s18, _s19, _r8), _s17, _r8)
    _s38 = _divide(_subtract(_s11, _s14, _r3), _s0, _r3)
    _s39 = _select(_s38 < _inf, _s38, _inf, _r0)
    _s40 = _select(_s37 < _s39, _s37, _s39, _r2)
    _s41 = _select(_s36 < _s40, _s36, _s40, _r1)
    _s42 = _select(_s35, _multiply(_s27, _add(vz, _s33, _r11), _r11), _inf, _r6)
    _s43 = _select(_s21 < _s42, _s42, _s21, _r7)
    _s44 = _select(_s34 < _s40, _s34, _s40, _r19)
    _s45 = _select(0.0 < _s41, _s41, 0.0, _r20)
    _s46 = _select(_s45 < _s44, _s44, _s45, _r21)
    _s47 = _result(_s46 < horizon, _s46, horizon, _r0)
    _s48 = _add(speed, _multiply(p_gravity, _s47, _r21), _r21)
    _s49 = 2.0 * _add((1.25 * _absolute((-p_gravity))) * (p_ball_radius + (0.0001220703125 * _s9)), _multiply(3.0, _multiply(_s48, _s48, _r21), _r21), _r21)
    _s50 = _where(_s2 < _s7, _s7, _s2)
    _s51 = _add(_add(_add(_s12, extent, _r21), _absolute((_s5 + _s3)), _r21), _where(_s50 < _s6, _s6, _s50), _r21)
    _s52 = _add(_multiply(_sqrt(2.0), _sqrt(_multiply(_s27, _add(_s51, _s9, _r20), _r20), _r20), _r20), _multiply(_multiply(2.0, speed, _r22), _s27, _r22), _r22)
    _s53 = _add(_add(position_error, _multiply(velocity_error, _select(_s52 < horizon, _s52, horizon, _r20), _r20), _r20), _multiply(3.552713678800501e-15, _add(_multiply(_multiply(speed, speed, _r22), _s27, _r22), _s51, _r22), _r22), _r22) - (1.52587890625e-05 * _s9)
    return _result(0.0 < _s31, _s31, 0.0, _r0), _result(_s41 < horizon, _s41, horizon, _r0), _result(0.0 < _s43, _s43, 0.0, _r0), _result(_s44 < horizon, _s44, horizon, _r0), _s49, _s47, _s53


def backboard_margins(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.

    running error analysis. 83 operations: 31 additions, 1 subtraction, 45 multiplications, 2 absolute values, 2 comparisons, 2 selections.
    Returns margin, leaving_margin, rate_margin.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8 = _room[:9]
    _s0 = (p_ball_radius + (0.5 * p_board_top)) - (0.5 * p_board_bottom)
    _s1 = p_ball_radius + p_board_half_width
    _s2 = p_ball_radius + (0.5 * p_board_thickness)
    _s3 = _where(_s1 < _s2, _s1, _s2)
    _s4 = p_ball_radius + (0.0001220703125 * _where(_s0 < _s3, _s0, _s3))
    _s5 = _add(speed, _multiply(p_gravity, horizon, _r0), _r0)
    _s6 = _add(extent, _multiply(horizon, _s5, _r1), _r1)
    _s7 = _multiply(2.220446049250313e-16, _s6, _r2)
    _s8 = _multiply(2.0, _add(_add(position_error, _multiply(horizon, velocity_error, _r3), _r3), _multiply(4.440892098500626e-16, _s6, _r4), _r4), _r4)
    _s9 = _add(_add(3.3306690738754696e-16 * p_board_half_width, _s7, _r3), _s8, _r3)
    _s10 = 2.001953125 * _s4
    _s11 = _add(_add((3.3306690738754696e-16 * p_board_distance) + (2.220446049250313e-16 * p_board_thickness), _multiply(3.3306690738754696e-16, _s6, _r1), _r1), _s8, _r1)
    _s12 = _add(_add((2.220446049250313e-16 * _absolute(p_board_bottom)) + (2.220446049250313e-16 * _absolute(p_board_top)), _s7, _r2), _s8, _r2)
    _s13 = _add(_add(_add(_add(5.55653613398821e-16 * (p_ball_radius * p_ball_radius), _multiply(_s10, _s9, _r4), _r4), _multiply(_s10, _s11, _r5), _r5), _multiply(_s10, _s12, _r4), _r4), _multiply(_multiply(_multiply(1.3335686721571705e-15, horizon, _r5), _s4, _r5), _s5, _r5), _r5)
    _s14 = _multiply(4.00390625, _s5, _r4)
    _s15 = _add(_add(_add(_multiply(12.01171875 * _s4, _add(velocity_error, _multiply(3.3306690738754696e-16, _s5, _r6), _r6), _r6), _multiply(6.667843360785852e-15 * _s4, _s5, _r7), _r7), _multiply(_s14, _s9, _r6), _r6), _multiply(_s14, _s11, _r7), _r7)
    _s16 = _multiply(2.001953125, _s5, _r6)
    _s17 = _add(_add(_add(_multiply(6.005859375 * _s4, _add(velocity_error, _multiply(2.220446049250313e-16, _s5, _r8), _r8), _r8), _multiply(2.667137344314341e-15 * _s4, _s5, _r0), _r0), _multiply(_s16, _s9, _r3), _r3), _multiply(_s16, _s11, _r1), _r1)
    return _s13 + (1.3335686721571705e-15 * (_s4 * _s4)), _s15 + _multiply(_s14, _s12, _r4), _s17 + _multiply(_s16, _s12, _r6)


def backboard_refine(t: Any, leaving: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Newton's next value of a root near t, and gap and rate there.

    Newton's method. 101 operations: 19 additions, 19 subtractions, 26 multiplications, 1 division, 4 negations, 16 comparisons, 16 selections.
    Returns time, gap, rate.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11 = _room[:12]
    _s0 = _add(x, _multiply(t, vx, _r0), _r0)
    _s1 = _add(p_board_distance, _s0, _r1)
    _s2 = p_board_distance + p_board_thickness
    _s3 = _negative(_add(_s2, _s0, _r0), _r0)
    _s4 = _subtract(_select(_s1 < 0.0, 0.0, _s1, _r2), _select(_s3 < 0.0, 0.0, _s3, _r3), _r3)
    _s5 = _add(y, _multiply(t, vy, _r0), _r0)
    _s6 = _subtract(_s5, p_board_half_width, _r2)
    _s7 = _negative(_add(p_board_half_width, _s5, _r0), _r0)
    _s8 = _subtract(_select(_s6 < 0.0, 0.0, _s6, _r1), _select(_s7 < 0.0, 0.0, _s7, _r4), _r4)
    _s9 = _subtract(vz, _multiply(0.5 * p_gravity, t, _r0), _r0)
    _s10 = _add(z, _multiply(t, _s9, _r1), _r1)
    _s11 = _subtract(_s10, p_board_top, _r2)
    _s12 = _subtract(p_board_bottom, _s10, _r1)
    _s13 = _subtract(_select(_s11 < 0.0, 0.0, _s11, _r5), _select(_s12 < 0.0, 0.0, _s12, _r6), _r6)
    _s14 = 2.0 * _add(_add(_multiply(vx, _s4, _r1), _multiply(vy, _s8, _r5), _r5), _multiply(_subtract(vz, _multiply(p_gravity, t, _r1), _r1), _s13, _r1), _r1)
    _s15 = _subtract(z, p_board_top, _r1)
    _s16 = _subtract(p_board_bottom, z, _r5)
    _s17 = _subtract(_select(_s15 < 0.0, 0.0, _s15, _r2), _select(_s16 < 0.0, 0.0, _s16, _r7), _r7)
    _s18 = _multiply(_s13, _s13, _r5)
    _s19 = _add(p_board_distance, x, _r2)
    _s20 = _negative(_add(_s2, x, _r1), _r1)
    _s21 = _subtract(_select(_s19 < 0.0, 0.0, _s19, _r8), _select(_s20 < 0.0, 0.0, _s20, _r9), _r9)
    _s22 = _multiply(_s4, _s4, _r1)
    _s23 = _subtract(y, p_board_half_width, _r8)
    _s24 = _negative(_add(p_board_half_width, y, _r2), _r2)
    _s25 = _subtract(_select(_s23 < 0.0, 0.0, _s23, _r10), _select(_s24 < 0.0, 0.0, _s24, _r11), _r11)
    _s26 = _multiply(_s8, _s8, _r2)
    _s27 = _add(_add(_select(0.0 < _multiply(_s17, _s13, _r10), _multiply(t, _multiply(_s9, _add(_s17, _s13, _r6), _r6), _r6), _subtract(_s18, _multiply(_s17, _s17, _r7), _r7), _r0), _select(0.0 < _multiply(_s21, _s4, _r10), _multiply(t, _multiply(vx, _add(_s21, _s4, _r3), _r3), _r3), _subtract(_s22, _multiply(_s21, _s21, _r9), _r9), _r10), _r10), _select(0.0 < _multiply(_s25, _s8, _r9), _multiply(t, _multiply(vy, _add(_s25, _s8, _r4), _r4), _r4), _subtract(_s26, _multiply(_s25, _s25, _r11), _r11), _r9), _r9)
    _s28 = _result(0.0 < leaving, _s27, _subtract(_add(_add(_s18, _s22, _r1), _s26, _r1), p_ball_radius * p_ball_radius, _r1), _r0)
    return t - _divide(_s28, _s14, _r1), _s28, _s14


def backboard_advance(t: Any, end: Any, leaving: Any, margin: Any, rate_margin: Any, ceiling: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Gap, rate, bend, a step without a root, its end, and the clearance of a root.

    Newton from the left under a curvature bound. 190 operations: 33 additions, 25 subtractions, 49 multiplications, 2 divisions, 1 square root, 8 negations, 5 absolute values, 32 comparisons, 35 selections.
    Returns gap, rate, bend, step, next, clearance.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12 = _room[:13]
    _s0 = _subtract(z, p_board_top, _r0)
    _s1 = _subtract(p_board_bottom, z, _r1)
    _s2 = _subtract(_select(_s0 < 0.0, 0.0, _s0, _r2), _select(_s1 < 0.0, 0.0, _s1, _r3), _r3)
    _s3 = _subtract(vz, _multiply(0.5 * p_gravity, t, _r1), _r1)
    _s4 = _add(z, _multiply(t, _s3, _r2), _r2)
    _s5 = _subtract(_s4, p_board_top, _r0)
    _s6 = _subtract(p_board_bottom, _s4, _r2)
    _s7 = _subtract(_select(_s5 < 0.0, 0.0, _s5, _r4), _select(_s6 < 0.0, 0.0, _s6, _r5), _r5)
    _s8 = _multiply(_s7, _s7, _r2)
    _s9 = _add(p_board_distance, x, _r4)
    _s10 = p_board_distance + p_board_thickness
    _s11 = _negative(_add(_s10, x, _r0), _r0)
    _s12 = _subtract(_select(_s9 < 0.0, 0.0, _s9, _r6), _select(_s11 < 0.0, 0.0, _s11, _r7), _r7)
    _s13 = _add(x, _multiply(t, vx, _r0), _r0)
    _s14 = _add(p_board_distance, _s13, _r6)
    _s15 = _negative(_add(_s10, _s13, _r0), _r0)
    _s16 = _subtract(_select(_s14 < 0.0, 0.0, _s14, _r4), _select(_s15 < 0.0, 0.0, _s15, _r8), _r8)
    _s17 = _multiply(_s16, _s16, _r0)
    _s18 = _subtract(y, p_board_half_width, _r4)
    _s19 = _negative(_add(p_board_half_width, y, _r6), _r6)
    _s20 = _subtract(_select(_s18 < 0.0, 0.0, _s18, _r9), _select(_s19 < 0.0, 0.0, _s19, _r10), _r10)
    _s21 = _add(y, _multiply(t, vy, _r6), _r6)
    _s22 = _subtract(_s21, p_board_half_width, _r9)
    _s23 = _negative(_add(p_board_half_width, _s21, _r6), _r6)
    _s24 = _subtract(_select(_s22 < 0.0, 0.0, _s22, _r4), _select(_s23 < 0.0, 0.0, _s23, _r11), _r11)
    _s25 = _multiply(_s24, _s24, _r6)
    _s26 = _add(_add(_select(0.0 < _multiply(_s2, _s7, _r4), _multiply(t, _multiply(_s3, _add(_s2, _s7, _r4), _r4), _r4), _subtract(_s8, _multiply(_s2, _s2, _r3), _r3), _r1), _select(0.0 < _multiply(_s12, _s16, _r9), _multiply(t, _multiply(vx, _add(_s12, _s16, _r9), _r9), _r9), _subtract(_s17, _multiply(_s12, _s12, _r7), _r7), _r12), _r12), _select(0.0 < _multiply(_s20, _s24, _r7), _multiply(t, _multiply(vy, _add(_s20, _s24, _r7), _r7), _r7), _subtract(_s25, _multiply(_s20, _s20, _r10), _r10), _r9), _r9)
    _s27 = _result(0.0 < leaving, _s26, _subtract(_add(_add(_s8, _s17, _r0), _s25, _r0), p_ball_radius * p_ball_radius, _r0), _r0)
    _s28 = _subtract(vz, _multiply(p_gravity, t, _r6), _r6)
    _s29 = 2.0 * _add(_add(_multiply(vx, _s16, _r2), _multiply(vy, _s24, _r10), _r10), _multiply(_s28, _s7, _r2), _r2)
    _s30 = _absolute(_s7, _r2)
    _s31 = 2.0 * _add(_add(_select(0.0 < _s30, _subtract(_multiply(_s28, _s28, _r10), _multiply(p_gravity, _s7, _r5), _r5), 0.0, _r10), _select(0.0 < _absolute(_s16, _r8), _multiply(vx, vx, _r8), 0.0, _r7), _r7), _select(0.0 < _absolute(_s24, _r11), _multiply(vy, vy, _r11), 0.0, _r8), _r8)
    _s32 = _absolute((-p_gravity))
    _s33 = (p_ball_radius + (0.5 * p_board_top)) - (0.5 * p_board_bottom)
    _s34 = p_ball_radius + p_board_half_width
    _s35 = p_ball_radius + (0.5 * p_board_thickness)
    _s36 = _where(_s34 < _s35, _s34, _s35)
    _s37 = p_ball_radius + (0.0001220703125 * _where(_s33 < _s36, _s33, _s36))
    _s38 = _subtract(_s29, rate_margin, _r8)
    _s39 = _subtract(_s27, margin, _r0)
    _s40 = _select(_s39 < 0.0, 0.0, _s39, _r9)
    _s41 = _negative(_s31, _r11)
    _s42 = _s38 < 0.0
    _s43 = _multiply(2.0, _s40, _r7)
    _s44 = _select(0.0 < _select(0.0 <= _s38, _s40, 0.0, _r10), _inf, _divide(_select(_s42, _s43, _multiply(4.0, _s38, _r10), _r5), _select(_s42, _negative(_s38, _r12), _select(0.0 < _s41, _s41, 0.0, _r1), _r3), _r5), _r10)
    _s45 = _subtract(end, t, _r3)
    _s46 = _select(_s44 < _s45, _s44, _s45, _r1)
    _s47 = _add(_multiply(_add(_multiply(0.5 * _s32, _s46, _r11), _absolute(_s28, _r6), _r6), _s46, _r6), _s30, _r6)
    _s48 = _add(_multiply(9.094947017729282e-13, ceiling, _r2), _multiply(2.0, _multiply(_s32, _select(_s37 < _s47, _s37, _s47, _r11), _r11), _r11), _r11)
    _s49 = _add(_multiply(_multiply(2.0, _s48, _r2), _s40, _r2), _multiply(_s38, _s38, _r9), _r9)
    _s50 = _sqrt(_s49, _r2)
    _s51 = _select(0.0 <= _s49, _divide(_select(_s42, _s43, _add(_s38, _s50, _r9), _r0), _select(_s42, _subtract(_s50, _s38, _r2), _select(0.0 < _s48, _s48, 0.0, _r8), _r6), _r0), _inf, _r9)
    _s52 = _result(_s51 < _s46, _s51, _s46, _r0)
    _s53 = _negative(_add(rate_margin, _s29, _r6), _r6)
    return _s27, _s29, _s31, _s52, t + _s52, _result(0.0 < _s53, _subtract(_multiply(_s53, _s53, _r9), _multiply(_multiply(8.0, ceiling, _r0), _add(margin, _s43, _r7), _r0), _r0), _s53, _r0)


def backboard_near(middle_x: Any, middle_y: Any, middle_z: Any, reach_x: Any, reach_y: Any, reach_z: Any, later_middle_x: Any, later_middle_y: Any, later_middle_z: Any, later_reach_x: Any, later_reach_y: Any, later_reach_z: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Where a flight may reach the box of a surface at all.

    boxes that do not meet. 62 operations: 12 additions, 11 subtractions, 14 multiplications, 3 negations, 6 absolute values, 8 comparisons, 1 conjunction, 1 complement, 6 selections.
    Returns near.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11 = _room[:12]
    _s0 = 1.0000000009313226 * (p_ball_radius * p_ball_radius)
    _s1 = 0.5 * p_board_thickness
    _s2 = -(p_board_distance + _s1)
    _s3 = 1.0000000009313226 * _s1
    _s4 = _subtract(_absolute(_subtract(_s2, middle_x, _r0), _r0), _add(reach_x, _s3, _r1), _r1)
    _s5 = _select(_s4 < 0.0, 0.0, _s4, _r0)
    _s6 = 1.0000000009313226 * p_board_half_width
    _s7 = _subtract(_absolute(_negative(middle_y, _r2), _r2), _add(reach_y, _s6, _r3), _r3)
    _s8 = _select(_s7 < 0.0, 0.0, _s7, _r2)
    _s9 = 0.5 * p_board_bottom
    _s10 = 0.5 * p_board_top
    _s11 = _s9 + _s10
    _s12 = 1.0000000009313226 * (_s10 - _s9)
    _s13 = _subtract(_absolute(_subtract(_s11, middle_z, _r4), _r4), _add(reach_z, _s12, _r5), _r5)
    _s14 = _select(_s13 < 0.0, 0.0, _s13, _r4)
    _s15 = _subtract(_absolute(_subtract(_s2, later_middle_x, _r6), _r6), _add(later_reach_x, _s3, _r7), _r7)
    _s16 = _select(_s15 < 0.0, 0.0, _s15, _r6)
    _s17 = _subtract(_absolute(_negative(later_middle_y, _r8), _r8), _add(later_reach_y, _s6, _r9), _r9)
    _s18 = _select(_s17 < 0.0, 0.0, _s17, _r8)
    _s19 = _subtract(_absolute(_subtract(_s11, later_middle_z, _r10), _r10), _add(later_reach_z, _s12, _r11), _r11)
    _s20 = _select(_s19 < 0.0, 0.0, _s19, _r10)
    _s21 = _logical_not(_logical_and((_s0 < _add(_add(_multiply(_s5, _s5, _r0), _multiply(_s8, _s8, _r2), _r2), _multiply(_s14, _s14, _r4), _r4)), (_s0 < _add(_add(_multiply(_s16, _s16, _r6), _multiply(_s18, _s18, _r8), _r8), _multiply(_s20, _s20, _r10), _r10))))
    return _s21,


def backboard_beside(p_ball_radius: Any, p_board_bottom: Any, p_board_distance: Any, p_board_half_width: Any, p_board_thickness: Any, p_board_top: Any, vx: Any, vy: Any, vz: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The distance, its rate, and how fast it bends down at most, by the squared speed.

    Table 2. 59 operations: 8 additions, 10 subtractions, 10 multiplications, 1 division, 1 square root, 5 negations, 12 comparisons, 12 selections.
    Returns gap, nearing, dent.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10 = _room[:11]
    _s0 = _subtract(z, p_board_top, _r0)
    _s1 = _subtract(p_board_bottom, z, _r1)
    _s2 = _subtract(_select(_s0 < 0.0, 0.0, _s0, _r2), _select(_s1 < 0.0, 0.0, _s1, _r3), _r3)
    _s3 = _add(p_board_distance, x, _r2)
    _s4 = _negative(_add(p_board_distance + p_board_thickness, x, _r4), _r4)
    _s5 = _subtract(_select(_s3 < 0.0, 0.0, _s3, _r5), _select(_s4 < 0.0, 0.0, _s4, _r6), _r6)
    _s6 = _subtract(y, p_board_half_width, _r5)
    _s7 = _negative(_add(p_board_half_width, y, _r7), _r7)
    _s8 = _subtract(_select(_s6 < 0.0, 0.0, _s6, _r8), _select(_s7 < 0.0, 0.0, _s7, _r9), _r9)
    _s9 = _sqrt(_add(_add(_multiply(_s2, _s2, _r8), _multiply(_s5, _s5, _r10), _r10), _multiply(_s8, _s8, _r8), _r8), _r8)
    _s10 = _add(_multiply(_multiply(2.0, _subtract(_select(_s0 < 0.0, 0.0, vz, _r0), _select(_s1 < 0.0, 0.0, _negative(vz, _r1), _r10), _r10), _r10), _s2, _r10), _multiply(_multiply(2.0, _subtract(_select(_s3 < 0.0, 0.0, vx, _r2), _select(_s4 < 0.0, 0.0, _negative(vx, _r4), _r3), _r3), _r3), _s5, _r3), _r3)
    _s11 = _add(_s10, _multiply(_multiply(2.0, _subtract(_select(_s6 < 0.0, 0.0, vy, _r5), _select(_s7 < 0.0, 0.0, _negative(vy, _r7), _r10), _r10), _r10), _s8, _r10), _r10)
    return _s9 - p_ball_radius, _multiply(0.5, _s11, _r10) / _s9, 0.0


def backboard_closing(p_ball_radius: Any, p_board_bottom: Any, p_board_distance: Any, p_board_half_width: Any, p_board_thickness: Any, p_board_top: Any, nx: Any, ny: Any, nz: Any, rolled_x: Any, rolled_y: Any, rolled_z: Any, thrust_x: Any, thrust_y: Any, thrust_z: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The distance, its rate and its second derivative, of a ball that rolls on something else.

    derivatives of Table 2's distance. 117 operations: 15 additions, 17 subtractions, 33 multiplications, 4 divisions, 1 square root, 11 negations, 12 comparisons, 24 selections.
    Returns gap, nearing, swerve, facing.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11 = _room[:12]
    _s0 = _subtract(z, p_board_top, _r0)
    _s1 = _subtract(p_board_bottom, z, _r1)
    _s2 = _subtract(_select(_s0 < 0.0, 0.0, _s0, _r2), _select(_s1 < 0.0, 0.0, _s1, _r3), _r3)
    _s3 = _add(p_board_distance, x, _r2)
    _s4 = _negative(_add(p_board_distance + p_board_thickness, x, _r4), _r4)
    _s5 = _subtract(_select(_s3 < 0.0, 0.0, _s3, _r5), _select(_s4 < 0.0, 0.0, _s4, _r6), _r6)
    _s6 = _subtract(y, p_board_half_width, _r5)
    _s7 = _negative(_add(p_board_half_width, y, _r7), _r7)
    _s8 = _subtract(_select(_s6 < 0.0, 0.0, _s6, _r8), _select(_s7 < 0.0, 0.0, _s7, _r9), _r9)
    _s9 = _add(_add(_multiply(_s2, _s2, _r8), _multiply(_s5, _s5, _r10), _r10), _multiply(_s8, _s8, _r8), _r8)
    _s10 = _sqrt(_s9, _r10)
    _s11 = _s0 < 0.0
    _s12 = _s1 < 0.0
    _s13 = _subtract(_select(_s11, 0.0, rolled_z, _r1), _select(_s12, 0.0, _negative(rolled_z, _r0), _r11), _r11)
    _s14 = _s3 < 0.0
    _s15 = _s4 < 0.0
    _s16 = _subtract(_select(_s14, 0.0, rolled_x, _r4), _select(_s15, 0.0, _negative(rolled_x, _r2), _r0), _r0)
    _s17 = _s6 < 0.0
    _s18 = _s7 < 0.0
    _s19 = _subtract(_select(_s17, 0.0, rolled_y, _r7), _select(_s18, 0.0, _negative(rolled_y, _r5), _r2), _r2)
    _s20 = _add(_add(_multiply(_multiply(2.0, _s13, _r5), _s2, _r5), _multiply(_multiply(2.0, _s16, _r7), _s5, _r7), _r7), _multiply(_multiply(2.0, _s19, _r5), _s8, _r5), _r5)
    _s21 = _add(_multiply(_multiply(2.0, _subtract(_select(_s11, 0.0, thrust_z, _r7), _select(_s12, 0.0, _negative(thrust_z, _r4), _r1), _r1), _r1), _s2, _r1), _multiply(2.0, _multiply(_s13, _s13, _r11), _r11), _r11)
    _s22 = _add(_multiply(_multiply(2.0, _subtract(_select(_s14, 0.0, thrust_x, _r1), _select(_s15, 0.0, _negative(thrust_x, _r4), _r7), _r7), _r7), _s5, _r7), _multiply(2.0, _multiply(_s16, _s16, _r0), _r0), _r0)
    _s23 = _add(_multiply(_multiply(2.0, _subtract(_select(_s17, 0.0, thrust_y, _r7), _select(_s18, 0.0, _negative(thrust_y, _r4), _r1), _r1), _r1), _s8, _r1), _multiply(2.0, _multiply(_s19, _s19, _r2), _r2), _r2)
    _s24 = _add(_multiply(_multiply(2.0, _subtract(_select(_s11, 0.0, nz, _r1), _select(_s12, 0.0, _negative(nz, _r4), _r7), _r7), _r7), _s2, _r7), _multiply(_multiply(2.0, _subtract(_select(_s14, 0.0, nx, _r3), _select(_s15, 0.0, _negative(nx, _r4), _r1), _r1), _r1), _s5, _r1), _r1)
    _s25 = _add(_s24, _multiply(_multiply(2.0, _subtract(_select(_s17, 0.0, ny, _r7), _select(_s18, 0.0, _negative(ny, _r6), _r4), _r4), _r4), _s8, _r4), _r4)
    return _s10 - p_ball_radius, _multiply(0.5, _s20, _r1) / _s10, _divide(_multiply(0.5, _add(_add(_s21, _s22, _r0), _s23, _r2), _r2), _s10, _r2) - _divide(_multiply(0.25, _multiply(_s20, _s20, _r5), _r5), _multiply(_s10, _s9, _r8), _r5), _multiply(0.5, _s25, _r4) / _s10


def backboard_off(p_ball_radius: Any, p_board_bottom: Any, p_board_distance: Any, p_board_half_width: Any, p_board_thickness: Any, p_board_top: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The distance.

    Table 2. 31 operations: 6 additions, 7 subtractions, 3 multiplications, 1 square root, 2 negations, 6 comparisons, 6 selections.
    Returns gap.
    """
    _r0, _r1, _r2, _r3, _r4, _r5 = _room[:6]
    _s0 = _subtract(z, p_board_top, _r0)
    _s1 = _subtract(p_board_bottom, z, _r1)
    _s2 = _subtract(_select(_s0 < 0.0, 0.0, _s0, _r2), _select(_s1 < 0.0, 0.0, _s1, _r3), _r3)
    _s3 = _add(p_board_distance, x, _r1)
    _s4 = _negative(_add(p_board_distance + p_board_thickness, x, _r2), _r2)
    _s5 = _subtract(_select(_s3 < 0.0, 0.0, _s3, _r0), _select(_s4 < 0.0, 0.0, _s4, _r4), _r4)
    _s6 = _subtract(y, p_board_half_width, _r2)
    _s7 = _negative(_add(p_board_half_width, y, _r0), _r0)
    _s8 = _subtract(_select(_s6 < 0.0, 0.0, _s6, _r1), _select(_s7 < 0.0, 0.0, _s7, _r5), _r5)
    return _sqrt(_add(_add(_multiply(_s2, _s2, _r3), _multiply(_s5, _s5, _r4), _r4), _multiply(_s8, _s8, _r5), _r5), _r5) - p_ball_radius,


def backboard_tube(p_ball_radius: Any, p_board_bottom: Any, p_board_distance: Any, p_board_half_width: Any, p_board_thickness: Any, p_board_top: Any, vx: Any, vy: Any, vz: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """What a ball that stays on it rolls on.

    Table 2. 65 operations: 9 additions, 3 subtractions, 6 multiplications, 1 division, 8 negations, 2 absolute values, 18 comparisons, 6 conjunctions, 9 disjunctions, 3 selections.
    Returns bent_x, bent_y, bent_z, per_reach.
    """
    _r0, _r1 = _room[:2]
    _s0 = 1.4210854715202004e-14 * p_ball_radius
    _s1 = (_s0 + (2.842170943040401e-14 * p_board_distance)) + (1.4210854715202004e-14 * p_board_thickness)
    _s2 = _add(p_board_distance, x, _r0)
    _s3 = -_s1
    _s4 = _negative(_add(p_board_distance + p_board_thickness, x, _r1), _r1)
    _s5 = _result(_logical_or(_logical_or((_s1 < _s2), _logical_and((_s3 < _s2), (0.0 < vx))), _logical_or((_s1 < _s4), _logical_and((_s3 < _s4), (0.0 < _negative(vx, _r1))))), 1.0, 0.0, _r0)
    _s6 = _s0 + (2.842170943040401e-14 * p_board_half_width)
    _s7 = _subtract(y, p_board_half_width, _r1)
    _s8 = -_s6
    _s9 = _negative(_add(p_board_half_width, y, _r0), _r0)
    _s10 = _result(_logical_or(_logical_or((_s6 < _s7), _logical_and((_s8 < _s7), (0.0 < vy))), _logical_or((_s6 < _s9), _logical_and((_s8 < _s9), (0.0 < _negative(vy, _r0))))), 1.0, 0.0, _r0)
    _s11 = (_s0 + (1.4210854715202004e-14 * _absolute(p_board_bottom))) + (1.4210854715202004e-14 * _absolute(p_board_top))
    _s12 = _subtract(z, p_board_top, _r0)
    _s13 = -_s11
    _s14 = _subtract(p_board_bottom, z, _r1)
    _s15 = _result(_logical_or(_logical_or((_s11 < _s12), _logical_and((_s13 < _s12), (0.0 < vz))), _logical_or((_s11 < _s14), _logical_and((_s13 < _s14), (0.0 < _negative(vz, _r1))))), 1.0, 0.0, _r0)
    return _s5, _s10, _s15, 1.0 / p_ball_radius


def backboard_turning(p_ball_radius: Any, p_board_bottom: Any, p_board_distance: Any, p_board_half_width: Any, p_board_thickness: Any, p_board_top: Any, rolled_x: Any, rolled_y: Any, rolled_z: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The rate at which the normal turns.

    derivative of Table 2's normal. 31 operations: 4 additions, 6 subtractions, 3 multiplications, 1 division, 5 negations, 6 comparisons, 6 selections.
    Returns turning_x, turning_y, turning_z.
    """
    _r0, _r1, _r2, _r3 = _room[:4]
    _s0 = 1.0 / p_ball_radius
    _s1 = _subtract(_select(_add(p_board_distance, x, _r0) < 0.0, 0.0, rolled_x, _r0), _select(_negative(_add(p_board_distance + p_board_thickness, x, _r1), _r1) < 0.0, 0.0, _negative(rolled_x, _r1), _r2), _r2)
    _s2 = _s0 * _subtract(_select(_subtract(y, p_board_half_width, _r1) < 0.0, 0.0, rolled_y, _r1), _select(_negative(_add(p_board_half_width, y, _r0), _r0) < 0.0, 0.0, _negative(rolled_y, _r0), _r3), _r3)
    return _s0 * _s1, _s2, _s0 * _subtract(_select(_subtract(z, p_board_top, _r2) < 0.0, 0.0, rolled_z, _r2), _select(_subtract(p_board_bottom, z, _r3) < 0.0, 0.0, _negative(rolled_z, _r3), _r0), _r0)


def backboard_parting(p_board_bottom: Any, p_board_distance: Any, p_board_half_width: Any, p_board_thickness: Any, p_board_top: Any, p_gravity: Any, vx: Any, vy: Any, vz: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The second to the fourth derivative of the distance along a flight.

    derivatives of Table 2's distance. 112 operations: 13 additions, 15 subtractions, 41 multiplications, 10 divisions, 1 square root, 6 negations, 12 comparisons, 14 selections.
    Returns lift, surge, snap.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11 = _room[:12]
    _s0 = _subtract(z, p_board_top, _r0)
    _s1 = _s0 < 0.0
    _s2 = _subtract(p_board_bottom, z, _r1)
    _s3 = _s2 < 0.0
    _s4 = _subtract(_select(_s1, 0.0, -p_gravity, _r2), _select(_s3, 0.0, p_gravity, _r3), _r3)
    _s5 = _subtract(_select(_s0 < 0.0, 0.0, _s0, _r2), _select(_s2 < 0.0, 0.0, _s2, _r4), _r4)
    _s6 = _subtract(_select(_s1, 0.0, vz, _r2), _select(_s3, 0.0, _negative(vz, _r1), _r0), _r0)
    _s7 = _add(p_board_distance, x, _r1)
    _s8 = _negative(_add(p_board_distance + p_board_thickness, x, _r2), _r2)
    _s9 = _subtract(_select(_s7 < 0.0, 0.0, vx, _r5), _select(_s8 < 0.0, 0.0, _negative(vx, _r6), _r7), _r7)
    _s10 = _subtract(y, p_board_half_width, _r6)
    _s11 = _negative(_add(p_board_half_width, y, _r5), _r5)
    _s12 = _subtract(_select(_s10 < 0.0, 0.0, vy, _r8), _select(_s11 < 0.0, 0.0, _negative(vy, _r9), _r10), _r10)
    _s13 = _add(_add(_add(_multiply(_multiply(2.0, _s4, _r9), _s5, _r9), _multiply(2.0, _multiply(_s6, _s6, _r8), _r8), _r8), _multiply(2.0, _multiply(_s9, _s9, _r9), _r9), _r9), _multiply(2.0, _multiply(_s12, _s12, _r8), _r8), _r8)
    _s14 = _subtract(_select(_s7 < 0.0, 0.0, _s7, _r9), _select(_s8 < 0.0, 0.0, _s8, _r11), _r11)
    _s15 = _subtract(_select(_s10 < 0.0, 0.0, _s10, _r9), _select(_s11 < 0.0, 0.0, _s11, _r2), _r2)
    _s16 = _add(_add(_multiply(_s5, _s5, _r9), _multiply(_s14, _s14, _r5), _r5), _multiply(_s15, _s15, _r9), _r9)
    _s17 = _sqrt(_s16, _r5)
    _s18 = _add(_add(_multiply(_multiply(2.0, _s6, _r6), _s5, _r6), _multiply(_multiply(2.0, _s9, _r7), _s14, _r7), _r7), _multiply(_multiply(2.0, _s12, _r10), _s15, _r10), _r10)
    _s19 = _multiply(_s18, _s18, _r7)
    _s20 = _multiply(_s17, _s16, _r2)
    _s21 = _multiply(_multiply(6.0, _s4, _r6), _s6, _r6)
    _s22 = _multiply(_s16, _s16, _r9)
    _s23 = _multiply(_s17, _s22, _r0)
    _s24 = _subtract(_add(_divide(_multiply(0.5, _multiply(6.0, _multiply(_s4, _s4, _r3), _r3), _r3), _s17, _r3), _divide(_multiply(_multiply(2.25, _s19, _r11), _s13, _r11), _s23, _r11), _r11), _divide(_multiply(0.9375, _multiply(_s19, _s19, _r3), _r3), _multiply(_s20, _s22, _r9), _r3), _r3)
    return _divide(_multiply(0.5, _s13, _r11), _s17, _r11) - _divide(_multiply(0.25, _s19, _r9), _s20, _r9), _add(_divide(_multiply(0.5, _s21, _r9), _s17, _r9), _divide(_multiply(0.375, _multiply(_s18, _s19, _r7), _r7), _s23, _r7), _r7) - _divide(_multiply(_multiply(0.75, _s18, _r9), _s13, _r9), _s20, _r9), _subtract(_s24, _divide(_multiply(0.75, _multiply(_s13, _s13, _r8), _r8), _s20, _r8), _r8) - _divide(_multiply(_s21, _s18, _r6), _s20, _r6)


def backboard_seam0(p_ball_radius: Any, p_board_distance: Any, p_board_thickness: Any, vx: Any, x: Any) -> tuple[Any, ...]:
    """How far the ball is from a seam of the surface, and how fast.

    Table 2. 7 operations: 4 additions, 3 multiplications.
    Returns gap, nearing, near.
    """
    return (p_board_distance + p_board_thickness) + x, vx, ((1.4210854715202004e-14 * p_ball_radius) + (2.842170943040401e-14 * p_board_distance)) + (1.4210854715202004e-14 * p_board_thickness)


def backboard_seam1(p_ball_radius: Any, p_board_distance: Any, p_board_thickness: Any, vx: Any, x: Any) -> tuple[Any, ...]:
    """How far the ball is from a seam of the surface, and how fast.

    Table 2. 6 operations: 3 additions, 3 multiplications.
    Returns gap, nearing, near.
    """
    return p_board_distance + x, vx, ((1.4210854715202004e-14 * p_ball_radius) + (2.842170943040401e-14 * p_board_distance)) + (1.4210854715202004e-14 * p_board_thickness)


def backboard_seam2(p_ball_radius: Any, p_board_half_width: Any, vy: Any, y: Any) -> tuple[Any, ...]:
    """How far the ball is from a seam of the surface, and how fast.

    Table 2. 4 operations: 2 additions, 2 multiplications.
    Returns gap, nearing, near.
    """
    return p_board_half_width + y, vy, (1.4210854715202004e-14 * p_ball_radius) + (2.842170943040401e-14 * p_board_half_width)


def backboard_seam3(p_ball_radius: Any, p_board_half_width: Any, vy: Any, y: Any) -> tuple[Any, ...]:
    """How far the ball is from a seam of the surface, and how fast.

    Table 2. 4 operations: 1 addition, 1 subtraction, 2 multiplications.
    Returns gap, nearing, near.
    """
    return y - p_board_half_width, vy, (1.4210854715202004e-14 * p_ball_radius) + (2.842170943040401e-14 * p_board_half_width)


def backboard_seam4(p_ball_radius: Any, p_board_bottom: Any, p_board_top: Any, vz: Any, z: Any) -> tuple[Any, ...]:
    """How far the ball is from a seam of the surface, and how fast.

    Table 2. 8 operations: 2 additions, 1 subtraction, 3 multiplications, 2 absolute values.
    Returns gap, nearing, near.
    """
    return z - p_board_bottom, vz, ((1.4210854715202004e-14 * p_ball_radius) + (1.4210854715202004e-14 * _absolute(p_board_bottom))) + (1.4210854715202004e-14 * _absolute(p_board_top))


def backboard_seam5(p_ball_radius: Any, p_board_bottom: Any, p_board_top: Any, vz: Any, z: Any) -> tuple[Any, ...]:
    """How far the ball is from a seam of the surface, and how fast.

    Table 2. 8 operations: 2 additions, 1 subtraction, 3 multiplications, 2 absolute values.
    Returns gap, nearing, near.
    """
    return z - p_board_top, vz, ((1.4210854715202004e-14 * p_ball_radius) + (1.4210854715202004e-14 * _absolute(p_board_bottom))) + (1.4210854715202004e-14 * _absolute(p_board_top))


def backboard_around(p_ball_radius: Any, p_board_bottom: Any, p_board_distance: Any, p_board_half_width: Any, p_board_thickness: Any, p_board_top: Any, vx: Any, vy: Any, vz: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """A bound below the distance from all places at this height and distance from the axis.

    Table 2. 57 operations: 6 additions, 6 subtractions, 16 multiplications, 2 divisions, 3 square roots, 4 negations, 10 comparisons, 10 selections.
    Returns gap, nearing.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8 = _room[:9]
    _s0 = _subtract(z, p_board_top, _r0)
    _s1 = _subtract(p_board_bottom, z, _r1)
    _s2 = _subtract(_select(_s0 < 0.0, 0.0, _s0, _r2), _select(_s1 < 0.0, 0.0, _s1, _r3), _r3)
    _s3 = -p_board_half_width
    _s4 = _where(0.0 < _s3, _s3, 0.0)
    _s5 = _where(_s4 < _s3, _s3, _s4)
    _s6 = -(p_board_distance + p_board_thickness)
    _s7 = _where(0.0 < _s6, _s6, 0.0)
    _s8 = _where(_s7 < p_board_distance, p_board_distance, _s7)
    _s9 = _sqrt(_add(_multiply(x, x, _r2), _multiply(y, y, _r4), _r4), _r4)
    _s10 = _subtract(_sqrt(((_s5 * _s5) + (_s8 * _s8))), _s9, _r2)
    _s11 = _select(0.0 < _s10, _s10, 0.0, _r5)
    _s12 = _sqrt(_add(_multiply(_s2, _s2, _r6), _multiply(_s11, _s11, _r7), _r7), _r7)
    _s13 = _negative(_divide(_multiply(0.5, _add(_multiply(_multiply(2.0, vx, _r6), x, _r6), _multiply(_multiply(2.0, vy, _r8), y, _r8), _r8), _r8), _s9, _r8), _r8)
    _s14 = _add(_multiply(_multiply(2.0, _subtract(_select(_s0 < 0.0, 0.0, vz, _r0), _select(_s1 < 0.0, 0.0, _negative(vz, _r1), _r4), _r4), _r4), _s2, _r4), _multiply(_multiply(2.0, _s11, _r5), _select(0.0 < _s10, _s13, 0.0, _r2), _r5), _r5)
    return _s12 - p_ball_radius, _multiply(0.5, _s14, _r5) / _s12


def backboard_enter(after: Any, end: Any, high0: Any, high1: Any, low0: Any, low1: Any, t: Any) -> tuple[Any, ...]:
    """The first window that ends later than a time, if there is one, from then on.

    Table 1. 12 operations: 4 comparisons, 2 disjunctions, 6 selections.
    Returns t, end, searching.
    """
    _s0 = _where(after < low0, low0, after)
    _s1 = _s0 < high0
    _s2 = _where(after < low1, low1, after)
    _s3 = _s2 < high1
    return _where(_s1, _s0, _where(_s3, _s2, t)), _where(_s1, high0, _where(_s3, high1, end)), _logical_or(_logical_or(False, _s3), _s1)


def bridge_normal(x: Any, y: Any, z: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_bridge_depth: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Outward unit normal n3 at a contact.

    Table 2. 28 operations: 3 additions, 7 subtractions, 3 multiplications, 1 division, 2 negations, 6 comparisons, 6 selections.
    Returns nx, ny, nz.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7 = _room[:8]
    _s0 = 1.0 / p_ball_radius
    _s1 = _add(p_ring_radius, x, _r0)
    _s2 = _negative(_add(p_board_distance, x, _r1), _r1)
    _s3 = _subtract(y, p_bridge_half_width, _r2)
    _s4 = _negative(_add(p_bridge_half_width, y, _r3), _r3)
    _s5 = _subtract(z, p_wire_radius, _r4)
    _s6 = _subtract(p_wire_radius - p_bridge_depth, z, _r5)
    return _s0 * _subtract(_select(_s1 < 0.0, 0.0, _s1, _r6), _select(_s2 < 0.0, 0.0, _s2, _r7), _r7), _s0 * _subtract(_select(_s3 < 0.0, 0.0, _s3, _r7), _select(_s4 < 0.0, 0.0, _s4, _r1), _r1), _s0 * _subtract(_select(_s5 < 0.0, 0.0, _s5, _r1), _select(_s6 < 0.0, 0.0, _s6, _r3), _r3)


def bridge_curvature(p_ball_radius: Any) -> tuple[Any, ...]:
    """Bound on the rate at which the normal turns along the contact surface.

    Table 2. 1 operation: 1 division.
    Returns curvature.
    """
    return 1.0 / p_ball_radius,


def bridge_carry_normal(x: Any, y: Any, z: Any, dx: Any, dy: Any, dz: Any, shift: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_bridge_depth: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Error of the normal, from that of the position.

    derivative of Table 2's normal. 32 operations: 3 additions, 7 subtractions, 4 multiplications, 1 division, 5 negations, 6 comparisons, 6 selections.
    Returns dnx, dny, dnz, turn.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = 1.0 / p_ball_radius
    _s1 = _s0 * _subtract(_select(_add(p_ring_radius, x, _r0) < 0.0, 0.0, dx, _r0), _select(_negative(_add(p_board_distance, x, _r1), _r1) < 0.0, 0.0, _negative(dx, _r1), _r2), _r2)
    _s2 = _s0 * _subtract(_select(_subtract(y, p_bridge_half_width, _r2) < 0.0, 0.0, dy, _r2), _select(_negative(_add(p_bridge_half_width, y, _r1), _r1) < 0.0, 0.0, _negative(dy, _r1), _r0), _r0)
    _s3 = _s0 * _subtract(_select(_subtract(z, p_wire_radius, _r0) < 0.0, 0.0, dz, _r0), _select(_subtract(p_wire_radius - p_bridge_depth, z, _r1) < 0.0, 0.0, _negative(dz, _r1), _r2), _r2)
    return _s1, _s2, _s3, shift * _s0


def bridge_prepare(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Constants and windows of the search along a flight, and the errors it allows for.

    bounds of the event condition. 136 operations: 28 additions, 10 subtractions, 28 multiplications, 5 divisions, 4 square roots, 5 negations, 4 absolute values, 25 comparisons, 27 selections.
    Returns low0, high0, low1, high1, ceiling, latest, lost.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13, _r14, _r15, _r16, _r17, _r18, _r19, _r20, _r21, _r22 = _room[:23]
    _s0 = _absolute(vx, _r0)
    _s1 = 0.5 * p_board_distance
    _s2 = p_ball_radius + _s1
    _s3 = 0.5 * p_bridge_depth
    _s4 = p_ball_radius + _s3
    _s5 = p_ball_radius + p_bridge_half_width
    _s6 = 0.5 * p_ring_radius
    _s7 = _s2 - _s6
    _s8 = _where(_s5 < _s7, _s5, _s7)
    _s9 = _where(_s4 < _s8, _s4, _s8)
    _s10 = 6.103515625e-05 * _s9
    _s11 = (_s2 + _s10) - _s6
    _s12 = _add(_s1 + _s6, x, _r1)
    _s13 = _select(vx < 0.0, _negative(_s12, _r2), _s12, _r3)
    _s14 = _divide(_negative(_add(_s11, _s13, _r4), _r4), _s0, _r4)
    _s15 = _select(0.0 < _s14, _s14, 0.0, _r5)
    _s16 = _absolute(vy, _r6)
    _s17 = _s5 + _s10
    _s18 = _select(vy < 0.0, _negative(y, _r7), y, _r8)
    _s19 = _divide(_negative(_add(_s17, _s18, _r9), _r9), _s16, _r9)
    _s20 = _select(_s15 < _s19, _s19, _s15, _r10)
    _s21 = _multiply(vz, vz, _r11)
    _s22 = _s4 + _s10
    _s23 = _subtract(_add(_s3, z, _r12), p_wire_radius, _r12)
    _s24 = 2.0 * p_gravity
    _s25 = _add(_s21, _multiply(_s24, _add(_s22, _s23, _r13), _r13), _r13)
    _s26 = 1.0 / p_gravity
    _s27 = _sqrt(_s25, _r14)
    _s28 = 0.0 <= _s25
    _s29 = _select(_s28, _multiply(_s26, _subtract(vz, _s27, _r13), _r13), _inf, _r15)
    _s30 = _select(_s20 < _s29, _s29, _s20, _r16)
    _s31 = _add(_s21, _multiply(_s24, _subtract(_s23, _s22, _r12), _r12), _r12)
    _s32 = _sqrt(_select(_s31 < 0.0, 0.0, _s31, _r11), _r11)
    _s33 = _select(_s28, _multiply(_s26, _add(vz, _s27, _r14), _r14), -_inf, _r17)
    _s34 = 0.0 < _s31
    _s35 = _select(_s34, _multiply(_s26, _subtract(vz, _s32, _r12), _r12), _s33, _r18)
    _s36 = _divide(_subtract(_s17, _s18, _r8), _s16, _r8)
    _s37 = _divide(_subtract(_s11, _s13, _r3), _s0, _r3)
    _s38 = _select(_s37 < _inf, _s37, _inf, _r0)
    _s39 = _select(_s36 < _s38, _s36, _s38, _r2)
    _s40 = _select(_s35 < _s39, _s35, _s39, _r1)
    _s41 = _select(_s34, _multiply(_s26, _add(vz, _s32, _r11), _r11), _inf, _r6)
    _s42 = _select(_s20 < _s41, _s41, _s20, _r7)
    _s43 = _select(_s33 < _s39, _s33, _s39, _r19)
    _s44 = _select(0.0 < _s40, _s40, 0.0, _r20)
    _s45 = _select(_s44 < _s43, _s43, _s44, _r21)
    _s46 = _result(_s45 < horizon, _s45, horizon, _r0)
    _s47 = _add(speed, _multiply(p_gravity, _s46, _r21), _r21)
    _s48 = 2.0 * _add((1.25 * _absolute((-p_gravity))) * (p_ball_radius + (0.0001220703125 * _s9)), _multiply(3.0, _multiply(_s47, _s47, _r21), _r21), _r21)
    _s49 = _where(_s7 < _s5, _s5, _s7)
    _s50 = _add(_add(_add(_add(_s1, extent, _r21), _s6, _r21), _absolute((_s3 - p_wire_radius)), _r21), _where(_s49 < _s4, _s4, _s49), _r21)
    _s51 = _add(_multiply(_sqrt(2.0), _sqrt(_multiply(_s26, _add(_s50, _s9, _r20), _r20), _r20), _r20), _multiply(_multiply(2.0, speed, _r22), _s26, _r22), _r22)
    _s52 = _add(_add(position_error, _multiply(velocity_error, _select(_s51 < horizon, _s51, horizon, _r20), _r20), _r20), _multiply(3.552713678800501e-15, _add(_multiply(_multiply(speed, speed, _r22), _s26, _r22), _s50, _r22), _r22), _r22) - (1.52587890625e-05 * _s9)
    return _result(0.0 < _s30, _s30, 0.0, _r0), _result(_s40 < horizon, _s40, horizon, _r0), _result(0.0 < _s42, _s42, 0.0, _r0), _result(_s43 < horizon, _s43, horizon, _r0), _s48, _s46, _s52


def bridge_margins(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.

    running error analysis. 81 operations: 31 additions, 1 subtraction, 45 multiplications, 2 comparisons, 2 selections.
    Returns margin, leaving_margin, rate_margin.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8 = _room[:9]
    _s0 = p_ball_radius + (0.5 * p_bridge_depth)
    _s1 = p_ball_radius + p_bridge_half_width
    _s2 = (p_ball_radius + (0.5 * p_board_distance)) - (0.5 * p_ring_radius)
    _s3 = _where(_s1 < _s2, _s1, _s2)
    _s4 = p_ball_radius + (0.0001220703125 * _where(_s0 < _s3, _s0, _s3))
    _s5 = _add(speed, _multiply(p_gravity, horizon, _r0), _r0)
    _s6 = _add(extent, _multiply(horizon, _s5, _r1), _r1)
    _s7 = _multiply(2.220446049250313e-16, _s6, _r2)
    _s8 = _multiply(2.0, _add(_add(position_error, _multiply(horizon, velocity_error, _r3), _r3), _multiply(4.440892098500626e-16, _s6, _r4), _r4), _r4)
    _s9 = _add(_add(3.3306690738754696e-16 * p_bridge_half_width, _s7, _r3), _s8, _r3)
    _s10 = 2.001953125 * _s4
    _s11 = _add(_add((1.1102230246251565e-16 * p_board_distance) + (1.1102230246251565e-16 * p_ring_radius), _s7, _r2), _s8, _r2)
    _s12 = _add(_add((2.220446049250313e-16 * p_bridge_depth) + (5.551115123125783e-16 * p_wire_radius), _multiply(3.3306690738754696e-16, _s6, _r1), _r1), _s8, _r1)
    _s13 = _add(_add(_add(_add(5.55653613398821e-16 * (p_ball_radius * p_ball_radius), _multiply(_s10, _s9, _r4), _r4), _multiply(_s10, _s11, _r5), _r5), _multiply(_s10, _s12, _r4), _r4), _multiply(_multiply(_multiply(1.3335686721571705e-15, horizon, _r5), _s4, _r5), _s5, _r5), _r5)
    _s14 = _multiply(4.00390625, _s5, _r4)
    _s15 = _add(_add(_add(_multiply(12.01171875 * _s4, _add(velocity_error, _multiply(3.3306690738754696e-16, _s5, _r6), _r6), _r6), _multiply(6.667843360785852e-15 * _s4, _s5, _r7), _r7), _multiply(_s14, _s9, _r6), _r6), _multiply(_s14, _s11, _r7), _r7)
    _s16 = _multiply(2.001953125, _s5, _r6)
    _s17 = _add(_add(_add(_multiply(6.005859375 * _s4, _add(velocity_error, _multiply(2.220446049250313e-16, _s5, _r8), _r8), _r8), _multiply(2.667137344314341e-15 * _s4, _s5, _r0), _r0), _multiply(_s16, _s9, _r3), _r3), _multiply(_s16, _s11, _r2), _r2)
    return _s13 + (1.3335686721571705e-15 * (_s4 * _s4)), _s15 + _multiply(_s14, _s12, _r4), _s17 + _multiply(_s16, _s12, _r6)


def bridge_refine(t: Any, leaving: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Newton's next value of a root near t, and gap and rate there.

    Newton's method. 101 operations: 18 additions, 20 subtractions, 26 multiplications, 1 division, 4 negations, 16 comparisons, 16 selections.
    Returns time, gap, rate.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11 = _room[:12]
    _s0 = _add(x, _multiply(t, vx, _r0), _r0)
    _s1 = _add(p_ring_radius, _s0, _r1)
    _s2 = _negative(_add(p_board_distance, _s0, _r0), _r0)
    _s3 = _subtract(_select(_s1 < 0.0, 0.0, _s1, _r2), _select(_s2 < 0.0, 0.0, _s2, _r3), _r3)
    _s4 = _add(y, _multiply(t, vy, _r0), _r0)
    _s5 = _subtract(_s4, p_bridge_half_width, _r2)
    _s6 = _negative(_add(p_bridge_half_width, _s4, _r0), _r0)
    _s7 = _subtract(_select(_s5 < 0.0, 0.0, _s5, _r1), _select(_s6 < 0.0, 0.0, _s6, _r4), _r4)
    _s8 = _subtract(vz, _multiply(0.5 * p_gravity, t, _r0), _r0)
    _s9 = _add(z, _multiply(t, _s8, _r1), _r1)
    _s10 = _subtract(_s9, p_wire_radius, _r2)
    _s11 = p_wire_radius - p_bridge_depth
    _s12 = _subtract(_s11, _s9, _r1)
    _s13 = _subtract(_select(_s10 < 0.0, 0.0, _s10, _r5), _select(_s12 < 0.0, 0.0, _s12, _r6), _r6)
    _s14 = 2.0 * _add(_add(_multiply(vx, _s3, _r1), _multiply(vy, _s7, _r5), _r5), _multiply(_subtract(vz, _multiply(p_gravity, t, _r1), _r1), _s13, _r1), _r1)
    _s15 = _add(p_ring_radius, x, _r1)
    _s16 = _negative(_add(p_board_distance, x, _r5), _r5)
    _s17 = _subtract(_select(_s15 < 0.0, 0.0, _s15, _r2), _select(_s16 < 0.0, 0.0, _s16, _r7), _r7)
    _s18 = _multiply(_s3, _s3, _r5)
    _s19 = _subtract(y, p_bridge_half_width, _r2)
    _s20 = _negative(_add(p_bridge_half_width, y, _r1), _r1)
    _s21 = _subtract(_select(_s19 < 0.0, 0.0, _s19, _r8), _select(_s20 < 0.0, 0.0, _s20, _r9), _r9)
    _s22 = _multiply(_s7, _s7, _r1)
    _s23 = _subtract(z, p_wire_radius, _r8)
    _s24 = _subtract(_s11, z, _r2)
    _s25 = _subtract(_select(_s23 < 0.0, 0.0, _s23, _r10), _select(_s24 < 0.0, 0.0, _s24, _r11), _r11)
    _s26 = _multiply(_s13, _s13, _r2)
    _s27 = _add(_add(_select(0.0 < _multiply(_s17, _s3, _r10), _multiply(t, _multiply(vx, _add(_s17, _s3, _r3), _r3), _r3), _subtract(_s18, _multiply(_s17, _s17, _r7), _r7), _r10), _select(0.0 < _multiply(_s21, _s7, _r8), _multiply(t, _multiply(vy, _add(_s21, _s7, _r4), _r4), _r4), _subtract(_s22, _multiply(_s21, _s21, _r9), _r9), _r8), _r8), _select(0.0 < _multiply(_s25, _s13, _r9), _multiply(t, _multiply(_s8, _add(_s25, _s13, _r6), _r6), _r6), _subtract(_s26, _multiply(_s25, _s25, _r11), _r11), _r0), _r0)
    _s28 = _result(0.0 < leaving, _s27, _subtract(_add(_add(_s18, _s22, _r1), _s26, _r1), p_ball_radius * p_ball_radius, _r1), _r0)
    return t - _divide(_s28, _s14, _r1), _s28, _s14


def bridge_advance(t: Any, end: Any, leaving: Any, margin: Any, rate_margin: Any, ceiling: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_gravity: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Gap, rate, bend, a step without a root, its end, and the clearance of a root.

    Newton from the left under a curvature bound. 190 operations: 32 additions, 26 subtractions, 49 multiplications, 2 divisions, 1 square root, 8 negations, 5 absolute values, 32 comparisons, 35 selections.
    Returns gap, rate, bend, step, next, clearance.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11, _r12, _r13 = _room[:14]
    _s0 = _add(p_ring_radius, x, _r0)
    _s1 = _negative(_add(p_board_distance, x, _r1), _r1)
    _s2 = _subtract(_select(_s0 < 0.0, 0.0, _s0, _r2), _select(_s1 < 0.0, 0.0, _s1, _r3), _r3)
    _s3 = _add(x, _multiply(t, vx, _r1), _r1)
    _s4 = _add(p_ring_radius, _s3, _r2)
    _s5 = _negative(_add(p_board_distance, _s3, _r1), _r1)
    _s6 = _subtract(_select(_s4 < 0.0, 0.0, _s4, _r0), _select(_s5 < 0.0, 0.0, _s5, _r4), _r4)
    _s7 = _multiply(_s6, _s6, _r1)
    _s8 = _subtract(y, p_bridge_half_width, _r0)
    _s9 = _negative(_add(p_bridge_half_width, y, _r2), _r2)
    _s10 = _subtract(_select(_s8 < 0.0, 0.0, _s8, _r5), _select(_s9 < 0.0, 0.0, _s9, _r6), _r6)
    _s11 = _add(y, _multiply(t, vy, _r2), _r2)
    _s12 = _subtract(_s11, p_bridge_half_width, _r5)
    _s13 = _negative(_add(p_bridge_half_width, _s11, _r2), _r2)
    _s14 = _subtract(_select(_s12 < 0.0, 0.0, _s12, _r0), _select(_s13 < 0.0, 0.0, _s13, _r7), _r7)
    _s15 = _multiply(_s14, _s14, _r2)
    _s16 = _subtract(z, p_wire_radius, _r0)
    _s17 = p_wire_radius - p_bridge_depth
    _s18 = _subtract(_s17, z, _r5)
    _s19 = _subtract(_select(_s16 < 0.0, 0.0, _s16, _r8), _select(_s18 < 0.0, 0.0, _s18, _r9), _r9)
    _s20 = _subtract(vz, _multiply(0.5 * p_gravity, t, _r5), _r5)
    _s21 = _add(z, _multiply(t, _s20, _r8), _r8)
    _s22 = _subtract(_s21, p_wire_radius, _r0)
    _s23 = _subtract(_s17, _s21, _r8)
    _s24 = _subtract(_select(_s22 < 0.0, 0.0, _s22, _r10), _select(_s23 < 0.0, 0.0, _s23, _r11), _r11)
    _s25 = _multiply(_s24, _s24, _r8)
    _s26 = _add(_add(_select(0.0 < _multiply(_s2, _s6, _r10), _multiply(t, _multiply(vx, _add(_s2, _s6, _r10), _r10), _r10), _subtract(_s7, _multiply(_s2, _s2, _r3), _r3), _r0), _select(0.0 < _multiply(_s10, _s14, _r12), _multiply(t, _multiply(vy, _add(_s10, _s14, _r12), _r12), _r12), _subtract(_s15, _multiply(_s10, _s10, _r6), _r6), _r13), _r13), _select(0.0 < _multiply(_s19, _s24, _r6), _multiply(t, _multiply(_s20, _add(_s19, _s24, _r6), _r6), _r6), _subtract(_s25, _multiply(_s19, _s19, _r9), _r9), _r5), _r5)
    _s27 = _result(0.0 < leaving, _s26, _subtract(_add(_add(_s7, _s15, _r2), _s25, _r2), p_ball_radius * p_ball_radius, _r2), _r0)
    _s28 = _subtract(vz, _multiply(p_gravity, t, _r8), _r8)
    _s29 = 2.0 * _add(_add(_multiply(vx, _s6, _r1), _multiply(vy, _s14, _r9), _r9), _multiply(_s28, _s24, _r1), _r1)
    _s30 = _absolute(_s24, _r1)
    _s31 = 2.0 * _add(_add(_select(0.0 < _absolute(_s6, _r4), _multiply(vx, vx, _r4), 0.0, _r9), _select(0.0 < _absolute(_s14, _r7), _multiply(vy, vy, _r7), 0.0, _r6), _r6), _select(0.0 < _s30, _subtract(_multiply(_s28, _s28, _r7), _multiply(p_gravity, _s24, _r11), _r11), 0.0, _r7), _r7)
    _s32 = _absolute((-p_gravity))
    _s33 = p_ball_radius + (0.5 * p_bridge_depth)
    _s34 = p_ball_radius + p_bridge_half_width
    _s35 = (p_ball_radius + (0.5 * p_board_distance)) - (0.5 * p_ring_radius)
    _s36 = _where(_s34 < _s35, _s34, _s35)
    _s37 = p_ball_radius + (0.0001220703125 * _where(_s33 < _s36, _s33, _s36))
    _s38 = _subtract(_s29, rate_margin, _r7)
    _s39 = _subtract(_s27, margin, _r2)
    _s40 = _select(_s39 < 0.0, 0.0, _s39, _r5)
    _s41 = _negative(_s31, _r11)
    _s42 = _s38 < 0.0
    _s43 = _multiply(2.0, _s40, _r6)
    _s44 = _select(0.0 < _select(0.0 <= _s38, _s40, 0.0, _r9), _inf, _divide(_select(_s42, _s43, _multiply(4.0, _s38, _r9), _r4), _select(_s42, _negative(_s38, _r13), _select(0.0 < _s41, _s41, 0.0, _r12), _r0), _r4), _r9)
    _s45 = _subtract(end, t, _r0)
    _s46 = _select(_s44 < _s45, _s44, _s45, _r12)
    _s47 = _add(_multiply(_add(_multiply(0.5 * _s32, _s46, _r11), _absolute(_s28, _r8), _r8), _s46, _r8), _s30, _r8)
    _s48 = _add(_multiply(9.094947017729282e-13, ceiling, _r1), _multiply(2.0, _multiply(_s32, _select(_s37 < _s47, _s37, _s47, _r11), _r11), _r11), _r11)
    _s49 = _add(_multiply(_multiply(2.0, _s48, _r1), _s40, _r1), _multiply(_s38, _s38, _r5), _r5)
    _s50 = _sqrt(_s49, _r1)
    _s51 = _select(0.0 <= _s49, _divide(_select(_s42, _s43, _add(_s38, _s50, _r5), _r2), _select(_s42, _subtract(_s50, _s38, _r1), _select(0.0 < _s48, _s48, 0.0, _r7), _r8), _r2), _inf, _r5)
    _s52 = _result(_s51 < _s46, _s51, _s46, _r0)
    _s53 = _negative(_add(rate_margin, _s29, _r8), _r8)
    return _s27, _s29, _s31, _s52, t + _s52, _result(0.0 < _s53, _subtract(_multiply(_s53, _s53, _r5), _multiply(_multiply(8.0, ceiling, _r2), _add(margin, _s43, _r6), _r2), _r2), _s53, _r0)


def bridge_near(middle_x: Any, middle_y: Any, middle_z: Any, reach_x: Any, reach_y: Any, reach_z: Any, later_middle_x: Any, later_middle_y: Any, later_middle_z: Any, later_reach_x: Any, later_reach_y: Any, later_reach_z: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_bridge_depth: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Where a flight may reach the box of a surface at all.

    boxes that do not meet. 62 operations: 11 additions, 12 subtractions, 14 multiplications, 3 negations, 6 absolute values, 8 comparisons, 1 conjunction, 1 complement, 6 selections.
    Returns near.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11 = _room[:12]
    _s0 = 1.0000000009313226 * (p_ball_radius * p_ball_radius)
    _s1 = 0.5 * p_board_distance
    _s2 = 0.5 * p_ring_radius
    _s3 = -(_s1 + _s2)
    _s4 = 1.0000000009313226 * (_s1 - _s2)
    _s5 = _subtract(_absolute(_subtract(_s3, middle_x, _r0), _r0), _add(reach_x, _s4, _r1), _r1)
    _s6 = _select(_s5 < 0.0, 0.0, _s5, _r0)
    _s7 = 1.0000000009313226 * p_bridge_half_width
    _s8 = _subtract(_absolute(_negative(middle_y, _r2), _r2), _add(reach_y, _s7, _r3), _r3)
    _s9 = _select(_s8 < 0.0, 0.0, _s8, _r2)
    _s10 = 0.5 * p_bridge_depth
    _s11 = p_wire_radius - _s10
    _s12 = 1.0000000009313226 * _s10
    _s13 = _subtract(_absolute(_subtract(_s11, middle_z, _r4), _r4), _add(reach_z, _s12, _r5), _r5)
    _s14 = _select(_s13 < 0.0, 0.0, _s13, _r4)
    _s15 = _subtract(_absolute(_subtract(_s3, later_middle_x, _r6), _r6), _add(later_reach_x, _s4, _r7), _r7)
    _s16 = _select(_s15 < 0.0, 0.0, _s15, _r6)
    _s17 = _subtract(_absolute(_negative(later_middle_y, _r8), _r8), _add(later_reach_y, _s7, _r9), _r9)
    _s18 = _select(_s17 < 0.0, 0.0, _s17, _r8)
    _s19 = _subtract(_absolute(_subtract(_s11, later_middle_z, _r10), _r10), _add(later_reach_z, _s12, _r11), _r11)
    _s20 = _select(_s19 < 0.0, 0.0, _s19, _r10)
    _s21 = _logical_not(_logical_and((_s0 < _add(_add(_multiply(_s6, _s6, _r0), _multiply(_s9, _s9, _r2), _r2), _multiply(_s14, _s14, _r4), _r4)), (_s0 < _add(_add(_multiply(_s16, _s16, _r6), _multiply(_s18, _s18, _r8), _r8), _multiply(_s20, _s20, _r10), _r10))))
    return _s21,


def bridge_beside(p_ball_radius: Any, p_board_distance: Any, p_bridge_depth: Any, p_bridge_half_width: Any, p_ring_radius: Any, vx: Any, vy: Any, vz: Any, p_wire_radius: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The distance, its rate, and how fast it bends down at most, by the squared speed.

    Table 2. 59 operations: 7 additions, 11 subtractions, 10 multiplications, 1 division, 1 square root, 5 negations, 12 comparisons, 12 selections.
    Returns gap, nearing, dent.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10 = _room[:11]
    _s0 = _add(p_ring_radius, x, _r0)
    _s1 = _negative(_add(p_board_distance, x, _r1), _r1)
    _s2 = _subtract(_select(_s0 < 0.0, 0.0, _s0, _r2), _select(_s1 < 0.0, 0.0, _s1, _r3), _r3)
    _s3 = _subtract(y, p_bridge_half_width, _r2)
    _s4 = _negative(_add(p_bridge_half_width, y, _r4), _r4)
    _s5 = _subtract(_select(_s3 < 0.0, 0.0, _s3, _r5), _select(_s4 < 0.0, 0.0, _s4, _r6), _r6)
    _s6 = _subtract(z, p_wire_radius, _r5)
    _s7 = _subtract(p_wire_radius - p_bridge_depth, z, _r7)
    _s8 = _subtract(_select(_s6 < 0.0, 0.0, _s6, _r8), _select(_s7 < 0.0, 0.0, _s7, _r9), _r9)
    _s9 = _sqrt(_add(_add(_multiply(_s2, _s2, _r8), _multiply(_s5, _s5, _r10), _r10), _multiply(_s8, _s8, _r8), _r8), _r8)
    _s10 = _add(_multiply(_multiply(2.0, _subtract(_select(_s0 < 0.0, 0.0, vx, _r0), _select(_s1 < 0.0, 0.0, _negative(vx, _r1), _r10), _r10), _r10), _s2, _r10), _multiply(_multiply(2.0, _subtract(_select(_s3 < 0.0, 0.0, vy, _r2), _select(_s4 < 0.0, 0.0, _negative(vy, _r4), _r3), _r3), _r3), _s5, _r3), _r3)
    _s11 = _add(_s10, _multiply(_multiply(2.0, _subtract(_select(_s6 < 0.0, 0.0, vz, _r5), _select(_s7 < 0.0, 0.0, _negative(vz, _r7), _r10), _r10), _r10), _s8, _r10), _r10)
    return _s9 - p_ball_radius, _multiply(0.5, _s11, _r10) / _s9, 0.0


def bridge_closing(p_ball_radius: Any, p_board_distance: Any, p_bridge_depth: Any, p_bridge_half_width: Any, nx: Any, ny: Any, nz: Any, p_ring_radius: Any, rolled_x: Any, rolled_y: Any, rolled_z: Any, thrust_x: Any, thrust_y: Any, thrust_z: Any, p_wire_radius: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The distance, its rate and its second derivative, of a ball that rolls on something else.

    derivatives of Table 2's distance. 117 operations: 14 additions, 18 subtractions, 33 multiplications, 4 divisions, 1 square root, 11 negations, 12 comparisons, 24 selections.
    Returns gap, nearing, swerve, facing.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11 = _room[:12]
    _s0 = _add(p_ring_radius, x, _r0)
    _s1 = _negative(_add(p_board_distance, x, _r1), _r1)
    _s2 = _subtract(_select(_s0 < 0.0, 0.0, _s0, _r2), _select(_s1 < 0.0, 0.0, _s1, _r3), _r3)
    _s3 = _subtract(y, p_bridge_half_width, _r2)
    _s4 = _negative(_add(p_bridge_half_width, y, _r4), _r4)
    _s5 = _subtract(_select(_s3 < 0.0, 0.0, _s3, _r5), _select(_s4 < 0.0, 0.0, _s4, _r6), _r6)
    _s6 = _subtract(z, p_wire_radius, _r5)
    _s7 = _subtract(p_wire_radius - p_bridge_depth, z, _r7)
    _s8 = _subtract(_select(_s6 < 0.0, 0.0, _s6, _r8), _select(_s7 < 0.0, 0.0, _s7, _r9), _r9)
    _s9 = _add(_add(_multiply(_s2, _s2, _r8), _multiply(_s5, _s5, _r10), _r10), _multiply(_s8, _s8, _r8), _r8)
    _s10 = _sqrt(_s9, _r10)
    _s11 = _s0 < 0.0
    _s12 = _s1 < 0.0
    _s13 = _subtract(_select(_s11, 0.0, rolled_x, _r1), _select(_s12, 0.0, _negative(rolled_x, _r0), _r11), _r11)
    _s14 = _s3 < 0.0
    _s15 = _s4 < 0.0
    _s16 = _subtract(_select(_s14, 0.0, rolled_y, _r4), _select(_s15, 0.0, _negative(rolled_y, _r2), _r0), _r0)
    _s17 = _s6 < 0.0
    _s18 = _s7 < 0.0
    _s19 = _subtract(_select(_s17, 0.0, rolled_z, _r7), _select(_s18, 0.0, _negative(rolled_z, _r5), _r2), _r2)
    _s20 = _add(_add(_multiply(_multiply(2.0, _s13, _r5), _s2, _r5), _multiply(_multiply(2.0, _s16, _r7), _s5, _r7), _r7), _multiply(_multiply(2.0, _s19, _r5), _s8, _r5), _r5)
    _s21 = _add(_multiply(_multiply(2.0, _subtract(_select(_s11, 0.0, thrust_x, _r7), _select(_s12, 0.0, _negative(thrust_x, _r4), _r1), _r1), _r1), _s2, _r1), _multiply(2.0, _multiply(_s13, _s13, _r11), _r11), _r11)
    _s22 = _add(_multiply(_multiply(2.0, _subtract(_select(_s14, 0.0, thrust_y, _r1), _select(_s15, 0.0, _negative(thrust_y, _r4), _r7), _r7), _r7), _s5, _r7), _multiply(2.0, _multiply(_s16, _s16, _r0), _r0), _r0)
    _s23 = _add(_multiply(_multiply(2.0, _subtract(_select(_s17, 0.0, thrust_z, _r7), _select(_s18, 0.0, _negative(thrust_z, _r4), _r1), _r1), _r1), _s8, _r1), _multiply(2.0, _multiply(_s19, _s19, _r2), _r2), _r2)
    _s24 = _add(_multiply(_multiply(2.0, _subtract(_select(_s11, 0.0, nx, _r1), _select(_s12, 0.0, _negative(nx, _r4), _r7), _r7), _r7), _s2, _r7), _multiply(_multiply(2.0, _subtract(_select(_s14, 0.0, ny, _r3), _select(_s15, 0.0, _negative(ny, _r4), _r1), _r1), _r1), _s5, _r1), _r1)
    _s25 = _add(_s24, _multiply(_multiply(2.0, _subtract(_select(_s17, 0.0, nz, _r7), _select(_s18, 0.0, _negative(nz, _r6), _r4), _r4), _r4), _s8, _r4), _r4)
    return _s10 - p_ball_radius, _multiply(0.5, _s20, _r1) / _s10, _divide(_multiply(0.5, _add(_add(_s21, _s22, _r0), _s23, _r2), _r2), _s10, _r2) - _divide(_multiply(0.25, _multiply(_s20, _s20, _r5), _r5), _multiply(_s10, _s9, _r8), _r5), _multiply(0.5, _s25, _r4) / _s10


def bridge_off(p_ball_radius: Any, p_board_distance: Any, p_bridge_depth: Any, p_bridge_half_width: Any, p_ring_radius: Any, p_wire_radius: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The distance.

    Table 2. 31 operations: 5 additions, 8 subtractions, 3 multiplications, 1 square root, 2 negations, 6 comparisons, 6 selections.
    Returns gap.
    """
    _r0, _r1, _r2, _r3, _r4, _r5 = _room[:6]
    _s0 = _add(p_ring_radius, x, _r0)
    _s1 = _negative(_add(p_board_distance, x, _r1), _r1)
    _s2 = _subtract(_select(_s0 < 0.0, 0.0, _s0, _r2), _select(_s1 < 0.0, 0.0, _s1, _r3), _r3)
    _s3 = _subtract(y, p_bridge_half_width, _r1)
    _s4 = _negative(_add(p_bridge_half_width, y, _r2), _r2)
    _s5 = _subtract(_select(_s3 < 0.0, 0.0, _s3, _r0), _select(_s4 < 0.0, 0.0, _s4, _r4), _r4)
    _s6 = _subtract(z, p_wire_radius, _r2)
    _s7 = _subtract(p_wire_radius - p_bridge_depth, z, _r0)
    _s8 = _subtract(_select(_s6 < 0.0, 0.0, _s6, _r1), _select(_s7 < 0.0, 0.0, _s7, _r5), _r5)
    return _sqrt(_add(_add(_multiply(_s2, _s2, _r3), _multiply(_s5, _s5, _r4), _r4), _multiply(_s8, _s8, _r5), _r5), _r5) - p_ball_radius,


def bridge_tube(p_ball_radius: Any, p_board_distance: Any, p_bridge_depth: Any, p_bridge_half_width: Any, p_ring_radius: Any, vx: Any, vy: Any, vz: Any, p_wire_radius: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """What a ball that stays on it rolls on.

    Table 2. 65 operations: 8 additions, 5 subtractions, 6 multiplications, 1 division, 8 negations, 1 absolute value, 18 comparisons, 6 conjunctions, 9 disjunctions, 3 selections.
    Returns bent_x, bent_y, bent_z, per_reach.
    """
    _r0, _r1 = _room[:2]
    _s0 = 1.4210854715202004e-14 * p_ball_radius
    _s1 = (_s0 + (1.4210854715202004e-14 * p_board_distance)) + (1.4210854715202004e-14 * p_ring_radius)
    _s2 = _add(p_ring_radius, x, _r0)
    _s3 = -_s1
    _s4 = _negative(_add(p_board_distance, x, _r1), _r1)
    _s5 = _result(_logical_or(_logical_or((_s1 < _s2), _logical_and((_s3 < _s2), (0.0 < vx))), _logical_or((_s1 < _s4), _logical_and((_s3 < _s4), (0.0 < _negative(vx, _r1))))), 1.0, 0.0, _r0)
    _s6 = _s0 + (2.842170943040401e-14 * p_bridge_half_width)
    _s7 = _subtract(y, p_bridge_half_width, _r1)
    _s8 = -_s6
    _s9 = _negative(_add(p_bridge_half_width, y, _r0), _r0)
    _s10 = _result(_logical_or(_logical_or((_s6 < _s7), _logical_and((_s8 < _s7), (0.0 < vy))), _logical_or((_s6 < _s9), _logical_and((_s8 < _s9), (0.0 < _negative(vy, _r0))))), 1.0, 0.0, _r0)
    _s11 = (_s0 + (1.4210854715202004e-14 * p_wire_radius)) + (1.4210854715202004e-14 * _absolute((p_bridge_depth - p_wire_radius)))
    _s12 = _subtract(z, p_wire_radius, _r0)
    _s13 = -_s11
    _s14 = _subtract(p_wire_radius - p_bridge_depth, z, _r1)
    _s15 = _result(_logical_or(_logical_or((_s11 < _s12), _logical_and((_s13 < _s12), (0.0 < vz))), _logical_or((_s11 < _s14), _logical_and((_s13 < _s14), (0.0 < _negative(vz, _r1))))), 1.0, 0.0, _r0)
    return _s5, _s10, _s15, 1.0 / p_ball_radius


def bridge_turning(p_ball_radius: Any, p_board_distance: Any, p_bridge_depth: Any, p_bridge_half_width: Any, p_ring_radius: Any, rolled_x: Any, rolled_y: Any, rolled_z: Any, p_wire_radius: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The rate at which the normal turns.

    derivative of Table 2's normal. 31 operations: 3 additions, 7 subtractions, 3 multiplications, 1 division, 5 negations, 6 comparisons, 6 selections.
    Returns turning_x, turning_y, turning_z.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = 1.0 / p_ball_radius
    _s1 = _s0 * _subtract(_select(_add(p_ring_radius, x, _r0) < 0.0, 0.0, rolled_x, _r0), _select(_negative(_add(p_board_distance, x, _r1), _r1) < 0.0, 0.0, _negative(rolled_x, _r1), _r2), _r2)
    _s2 = _s0 * _subtract(_select(_subtract(y, p_bridge_half_width, _r2) < 0.0, 0.0, rolled_y, _r2), _select(_negative(_add(p_bridge_half_width, y, _r1), _r1) < 0.0, 0.0, _negative(rolled_y, _r1), _r0), _r0)
    _s3 = _s0 * _subtract(_select(_subtract(z, p_wire_radius, _r0) < 0.0, 0.0, rolled_z, _r0), _select(_subtract(p_wire_radius - p_bridge_depth, z, _r1) < 0.0, 0.0, _negative(rolled_z, _r1), _r2), _r2)
    return _s1, _s2, _s3


def bridge_parting(p_board_distance: Any, p_bridge_depth: Any, p_bridge_half_width: Any, p_gravity: Any, p_ring_radius: Any, vx: Any, vy: Any, vz: Any, p_wire_radius: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """The second to the fourth derivative of the distance along a flight.

    derivatives of Table 2's distance. 112 operations: 12 additions, 16 subtractions, 41 multiplications, 10 divisions, 1 square root, 6 negations, 12 comparisons, 14 selections.
    Returns lift, surge, snap.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8, _r9, _r10, _r11 = _room[:12]
    _s0 = _subtract(z, p_wire_radius, _r0)
    _s1 = _s0 < 0.0
    _s2 = _subtract(p_wire_radius - p_bridge_depth, z, _r1)
    _s3 = _s2 < 0.0
    _s4 = _subtract(_select(_s1, 0.0, -p_gravity, _r2), _select(_s3, 0.0, p_gravity, _r3), _r3)
    _s5 = _subtract(_select(_s0 < 0.0, 0.0, _s0, _r2), _select(_s2 < 0.0, 0.0, _s2, _r4), _r4)
    _s6 = _subtract(_select(_s1, 0.0, vz, _r2), _select(_s3, 0.0, _negative(vz, _r1), _r0), _r0)
    _s7 = _add(p_ring_radius, x, _r1)
    _s8 = _negative(_add(p_board_distance, x, _r2), _r2)
    _s9 = _subtract(_select(_s7 < 0.0, 0.0, vx, _r5), _select(_s8 < 0.0, 0.0, _negative(vx, _r6), _r7), _r7)
    _s10 = _subtract(y, p_bridge_half_width, _r6)
    _s11 = _negative(_add(p_bridge_half_width, y, _r5), _r5)
    _s12 = _subtract(_select(_s10 < 0.0, 0.0, vy, _r8), _select(_s11 < 0.0, 0.0, _negative(vy, _r9), _r10), _r10)
    _s13 = _add(_add(_add(_multiply(_multiply(2.0, _s4, _r9), _s5, _r9), _multiply(2.0, _multiply(_s6, _s6, _r8), _r8), _r8), _multiply(2.0, _multiply(_s9, _s9, _r9), _r9), _r9), _multiply(2.0, _multiply(_s12, _s12, _r8), _r8), _r8)
    _s14 = _subtract(_select(_s7 < 0.0, 0.0, _s7, _r9), _select(_s8 < 0.0, 0.0, _s8, _r11), _r11)
    _s15 = _subtract(_select(_s10 < 0.0, 0.0, _s10, _r9), _select(_s11 < 0.0, 0.0, _s11, _r2), _r2)
    _s16 = _add(_add(_multiply(_s14, _s14, _r9), _multiply(_s15, _s15, _r5), _r5), _multiply(_s5, _s5, _r9), _r9)
    _s17 = _sqrt(_s16, _r5)
    _s18 = _add(_add(_multiply(_multiply(2.0, _s9, _r7), _s14, _r7), _multiply(_multiply(2.0, _s12, _r10), _s15, _r10), _r10), _multiply(_multiply(2.0, _s6, _r7), _s5, _r7), _r7)
    _s19 = _multiply(_s18, _s18, _r10)
    _s20 = _multiply(_s17, _s16, _r4)
    _s21 = _multiply(_multiply(6.0, _s4, _r2), _s6, _r2)
    _s22 = _multiply(_s16, _s16, _r9)
    _s23 = _multiply(_s17, _s22, _r0)
    _s24 = _subtract(_add(_divide(_multiply(0.5, _multiply(6.0, _multiply(_s4, _s4, _r3), _r3), _r3), _s17, _r3), _divide(_multiply(_multiply(2.25, _s19, _r11), _s13, _r11), _s23, _r11), _r11), _divide(_multiply(0.9375, _multiply(_s19, _s19, _r3), _r3), _multiply(_s20, _s22, _r9), _r3), _r3)
    return _divide(_multiply(0.5, _s13, _r11), _s17, _r11) - _divide(_multiply(0.25, _s19, _r9), _s20, _r9), _add(_divide(_multiply(0.5, _s21, _r9), _s17, _r9), _divide(_multiply(0.375, _multiply(_s18, _s19, _r10), _r10), _s23, _r10), _r10) - _divide(_multiply(_multiply(0.75, _s18, _r9), _s13, _r9), _s20, _r9), _subtract(_s24, _divide(_multiply(0.75, _multiply(_s13, _s13, _r8), _r8), _s20, _r8), _r8) - _divide(_multiply(_s21, _s18, _r2), _s20, _r2)


def bridge_seam0(p_ball_radius: Any, p_board_distance: Any, p_ring_radius: Any, vx: Any, x: Any) -> tuple[Any, ...]:
    """How far the ball is from a seam of the surface, and how fast.

    Table 2. 6 operations: 3 additions, 3 multiplications.
    Returns gap, nearing, near.
    """
    return p_board_distance + x, vx, ((1.4210854715202004e-14 * p_ball_radius) + (1.4210854715202004e-14 * p_board_distance)) + (1.4210854715202004e-14 * p_ring_radius)


def bridge_seam1(p_ball_radius: Any, p_board_distance: Any, p_ring_radius: Any, vx: Any, x: Any) -> tuple[Any, ...]:
    """How far the ball is from a seam of the surface, and how fast.

    Table 2. 6 operations: 3 additions, 3 multiplications.
    Returns gap, nearing, near.
    """
    return p_ring_radius + x, vx, ((1.4210854715202004e-14 * p_ball_radius) + (1.4210854715202004e-14 * p_board_distance)) + (1.4210854715202004e-14 * p_ring_radius)


def bridge_seam2(p_ball_radius: Any, p_bridge_half_width: Any, vy: Any, y: Any) -> tuple[Any, ...]:
    """How far the ball is from a seam of the surface, and how fast.

    Table 2. 4 operations: 2 additions, 2 multiplications.
    Returns gap, nearing, near.
    """
    return p_bridge_half_width + y, vy, (1.4210854715202004e-14 * p_ball_radius) + (2.842170943040401e-14 * p_bridge_half_width)


def bridge_seam3(p_ball_radius: Any, p_bridge_half_width: Any, vy: Any, y: Any) -> tuple[Any, ...]:
    """How far the ball is from a seam of the surface, and how fast.

    Table 2. 4 operations: 1 addition, 1 subtraction, 2 multiplications.
    Returns gap, nearing, near.
    """
    return y - p_bridge_half_width, vy, (1.4210854715202004e-14 * p_ball_radius) + (2.842170943040401e-14 * p_bridge_half_width)


def bridge_seam4(p_ball_radius: Any, p_bridge_depth: Any, vz: Any, p_wire_radius: Any, z: Any) -> tuple[Any, ...]:
    """How far the ball is from a seam of the surface, and how fast.

    Table 2. 9 operations: 3 additions, 2 subtractions, 3 multiplications, 1 absolute value.
    Returns gap, nearing, near.
    """
    return (p_bridge_depth + z) - p_wire_radius, vz, ((1.4210854715202004e-14 * p_ball_radius) + (1.4210854715202004e-14 * p_wire_radius)) + (1.4210854715202004e-14 * _absolute((p_bridge_depth - p_wire_radius)))


def bridge_seam5(p_ball_radius: Any, p_bridge_depth: Any, vz: Any, p_wire_radius: Any, z: Any) -> tuple[Any, ...]:
    """How far the ball is from a seam of the surface, and how fast.

    Table 2. 8 operations: 2 additions, 2 subtractions, 3 multiplications, 1 absolute value.
    Returns gap, nearing, near.
    """
    return z - p_wire_radius, vz, ((1.4210854715202004e-14 * p_ball_radius) + (1.4210854715202004e-14 * p_wire_radius)) + (1.4210854715202004e-14 * _absolute((p_bridge_depth - p_wire_radius)))


def bridge_around(p_ball_radius: Any, p_board_distance: Any, p_bridge_depth: Any, p_bridge_half_width: Any, p_ring_radius: Any, vx: Any, vy: Any, vz: Any, p_wire_radius: Any, x: Any, y: Any, z: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """A bound below the distance from all places at this height and distance from the axis.

    Table 2. 57 operations: 5 additions, 7 subtractions, 16 multiplications, 2 divisions, 3 square roots, 4 negations, 10 comparisons, 10 selections.
    Returns gap, nearing.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8 = _room[:9]
    _s0 = _subtract(z, p_wire_radius, _r0)
    _s1 = _subtract(p_wire_radius - p_bridge_depth, z, _r1)
    _s2 = _subtract(_select(_s0 < 0.0, 0.0, _s0, _r2), _select(_s1 < 0.0, 0.0, _s1, _r3), _r3)
    _s3 = -p_board_distance
    _s4 = _where(0.0 < _s3, _s3, 0.0)
    _s5 = _where(_s4 < p_ring_radius, p_ring_radius, _s4)
    _s6 = -p_bridge_half_width
    _s7 = _where(0.0 < _s6, _s6, 0.0)
    _s8 = _where(_s7 < _s6, _s6, _s7)
    _s9 = _sqrt(_add(_multiply(x, x, _r2), _multiply(y, y, _r4), _r4), _r4)
    _s10 = _subtract(_sqrt(((_s5 * _s5) + (_s8 * _s8))), _s9, _r2)
    _s11 = _select(0.0 < _s10, _s10, 0.0, _r5)
    _s12 = _sqrt(_add(_multiply(_s2, _s2, _r6), _multiply(_s11, _s11, _r7), _r7), _r7)
    _s13 = _negative(_divide(_multiply(0.5, _add(_multiply(_multiply(2.0, vx, _r6), x, _r6), _multiply(_multiply(2.0, vy, _r8), y, _r8), _r8), _r8), _s9, _r8), _r8)
    _s14 = _add(_multiply(_multiply(2.0, _subtract(_select(_s0 < 0.0, 0.0, vz, _r0), _select(_s1 < 0.0, 0.0, _negative(vz, _r1), _r4), _r4), _r4), _s2, _r4), _multiply(_multiply(2.0, _s11, _r5), _select(0.0 < _s10, _s13, 0.0, _r2), _r5), _r5)
    return _s12 - p_ball_radius, _multiply(0.5, _s14, _r5) / _s12


def bridge_enter(after: Any, end: Any, high0: Any, high1: Any, low0: Any, low1: Any, t: Any) -> tuple[Any, ...]:
    """The first window that ends later than a time, if there is one, from then on.

    Table 1. 12 operations: 4 comparisons, 2 disjunctions, 6 selections.
    Returns t, end, searching.
    """
    _s0 = _where(after < low0, low0, after)
    _s1 = _s0 < high0
    _s2 = _where(after < low1, low1, after)
    _s3 = _s2 < high1
    return _where(_s1, _s0, _where(_s3, _s2, t)), _where(_s1, high0, _where(_s3, high1, end)), _logical_or(_logical_or(False, _s3), _s1)


def end_coefficients(z: Any, vz: Any, p_gravity: Any, p_end_depth: Any) -> tuple[Any, ...]:
    """Coefficients in time of the event polynomial, constant first.

    Eq. 3 in Table 2. 4 operations: 1 subtraction, 1 multiplication, 2 negations.
    Returns c0, c1, c2.
    """
    return z - (-p_end_depth), vz, -(0.5 * p_gravity)


def end_deflated(vz: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Coefficients of the event polynomial over t, after a contact at t = 0.

    Eq. 3 in Table 2, the exact root divided out. 2 operations: 1 multiplication, 1 negation.
    Returns c0, c1.
    """
    return vz, -(0.5 * p_gravity)


def end_normal() -> tuple[Any, ...]:
    """Outward unit normal n3 at a contact.

    Table 2. No operations.
    Returns nx, ny, nz.
    """
    return 0.0, 0.0, 1.0


def end_curvature() -> tuple[Any, ...]:
    """Bound on the rate at which the normal turns along the contact surface.

    Table 2. No operations.
    Returns curvature.
    """
    return 0.0,


def end_arrival(leaving: Any, z: Any, vz: Any, p_gravity: Any, p_end_depth: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Time of the only arrival, the gap's rate there and its bend.

    Eq. 3 in Table 2, solved. 27 operations: 2 additions, 2 subtractions, 7 multiplications, 2 divisions, 1 square root, 6 negations, 1 absolute value, 2 comparisons, 4 selections.
    Returns time, rate, bend, apex, height.
    """
    _r0, _r1, _r2, _r3, _r4, _r5, _r6, _r7, _r8 = _room[:9]
    _s0 = 0.0 < leaving
    _s1 = _select(_s0, 0.0, _subtract(z, -p_end_depth, _r0), _r1)
    _s2 = _add(_multiply(vz, vz, _r2), _multiply(2.0 * p_gravity, _s1, _r3), _r3)
    _s3 = _select(_s0, _absolute(vz, _r2), _sqrt(_s2, _r4), _r5)
    _s4 = vz < 0.0
    _s5 = -(1.0 / p_gravity)
    return _select(_s4, _multiply(2.0, _s1, _r1), _add(vz, _s3, _r0), _r6) / _select(_s4, _subtract(_s3, vz, _r7), p_gravity, _r8), -_s3, -p_gravity, -_multiply(vz, _s5, _r5), -_multiply(0.5 * _s5, _s2, _r3)


def end_margin(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_gravity: Any, p_end_depth: Any, _room: Any = NO_ROWS) -> tuple[Any, ...]:
    """Rounding-error bound of the gap up to the horizon.

    running error analysis. 13 operations: 6 additions, 7 multiplications.
    Returns margin.
    """
    _r0, _r1, _r2 = _room[:3]
    _s0 = _add(extent, _multiply(horizon, _add(speed, _multiply(p_gravity, horizon, _r0), _r0), _r0), _r0)
    return _add(6.667843360785852e-16 * p_end_depth, _multiply(2.222614453595284e-16, _s0, _r1), _r1) + _multiply(2.001953125, _add(_add(position_error, _multiply(horizon, velocity_error, _r2), _r2), _multiply(4.440892098500626e-16, _s0, _r0), _r0), _r0),


def end_place(x: Any, y: Any, p_end_depth: Any) -> tuple[Any, ...]:
    """The point of the contact plane nearest to a position.

    Table 2. 1 operation: 1 negation.
    Returns x, y, z.
    """
    return x, y, -p_end_depth


def end_bounds(x: Any, y: Any, p_ring_radius: Any) -> tuple[Any, ...]:
    """The bounds of the ends on a plane: the first whose bounds all hold is reached.

    Table 2, success. 5 operations: 1 addition, 1 subtraction, 2 multiplications, 1 square root.
    Returns g0.
    """
    return _sqrt(((x * x) + (y * y))) - p_ring_radius,


def end_beside(p_end_depth: Any, vz: Any, z: Any) -> tuple[Any, ...]:
    """The distance, its rate, and how fast it bends down at most, by the squared speed.

    Table 2. 2 operations: 1 subtraction, 1 negation.
    Returns gap, nearing, dent.
    """
    return z - (-p_end_depth), vz, 0.0


def end_closing(p_end_depth: Any, nz: Any, rolled_z: Any, thrust_z: Any, z: Any) -> tuple[Any, ...]:
    """The distance, its rate and its second derivative, of a ball that rolls on something else.

    derivatives of Table 2's distance. 2 operations: 1 subtraction, 1 negation.
    Returns gap, nearing, swerve, facing.
    """
    return z - (-p_end_depth), rolled_z, thrust_z, nz


def end_off(p_end_depth: Any, z: Any) -> tuple[Any, ...]:
    """The distance.

    Table 2. 2 operations: 1 subtraction, 1 negation.
    Returns gap.
    """
    return z - (-p_end_depth),


def end_tube() -> tuple[Any, ...]:
    """What a ball that stays on it rolls on.

    Table 2. No operations.
    Returns bent_x, bent_y, bent_z, per_reach.
    """
    return 0.0, 0.0, 0.0, 0.0


def end_turning() -> tuple[Any, ...]:
    """The rate at which the normal turns.

    derivative of Table 2's normal. No operations.
    Returns turning_x, turning_y, turning_z.
    """
    return 0.0, 0.0, 0.0


def end_parting(p_gravity: Any) -> tuple[Any, ...]:
    """The second to the fourth derivative of the distance along a flight.

    derivatives of Table 2's distance. 1 operation: 1 negation.
    Returns lift, surge, snap.
    """
    return -p_gravity, 0.0, 0.0


def end_around(p_end_depth: Any, vz: Any, z: Any) -> tuple[Any, ...]:
    """A bound below the distance from all places at this height and distance from the axis.

    Table 2. 2 operations: 1 subtraction, 1 negation.
    Returns gap, nearing.
    """
    return z - (-p_end_depth), vz


def end_reached(g0: Any, through: Any) -> tuple[Any, ...]:
    """The end that a crossing reaches.

    Table 1. 4 operations: 2 comparisons, 1 conjunction, 1 selection.
    Returns reached.
    """
    return _where(_logical_and((g0 <= 0.0), (through == 1.0)), 0.0, 1.0),


def end_edge(g0: Any, slack: Any, through: Any) -> tuple[Any, ...]:
    """Whether that lies within its error.

    Table 1. 7 operations: 1 negation, 3 comparisons, 2 conjunctions, 1 complement.
    Returns edge.
    """
    return _logical_and(_logical_and((g0 <= slack), _logical_not((g0 < (-slack)))), (through == 1.0)),


def aimed_speed(slope: Any, reach: Any, rise: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Speed of the flight that goes through a point with a slope of release.

    Eq. 3 without its time, solved for the speed. 9 operations: 1 addition, 1 subtraction, 5 multiplications, 1 division, 1 square root.
    Returns speed.
    """
    _s0 = reach * _sqrt((((0.5 * p_gravity) * (1.0 + (slope * slope))) / ((reach * slope) - rise)))
    return _s0,


def entry_slope(slope: Any, reach: Any, rise: Any) -> tuple[Any, ...]:
    """Slope at a point, positive downwards, of the flight with a slope of release.

    derivative of Eq. 3 without its time. 3 operations: 1 subtraction, 1 multiplication, 1 division.
    Returns entry.
    """
    return slope - ((2.0 * rise) / reach),


def slope_of_entry(entry: Any, reach: Any, rise: Any) -> tuple[Any, ...]:
    """Slope of release of the flight that has a slope at a point, positive downwards.

    derivative of Eq. 3 without its time, solved for the release. 3 operations: 1 addition, 1 multiplication, 1 division.
    Returns slope.
    """
    return entry + ((2.0 * rise) / reach),


def least_speed(reach: Any, rise: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Slope and speed of the slowest release through a point.

    Eq. 3 without its time, least speed: at 45° + atan(rise/reach)/2, v² = g (rise + distance). 14 operations: 2 additions, 1 subtraction, 3 multiplications, 3 divisions, 2 square roots, 1 comparison, 2 selections.
    Returns slope, speed.
    """
    _s0 = reach * reach
    _s1 = _sqrt((_s0 + (rise * rise)))
    _s2 = _s1 - rise
    _s3 = rise + _s1
    _s4 = rise < 0.0
    return _where(_s4, (reach / _s2), (_s3 / reach)), _sqrt((p_gravity * _where(_s4, (_s0 / _s2), _s3)))


def slopes_of_speed(release_speed: Any, reach: Any, rise: Any, p_gravity: Any) -> tuple[Any, ...]:
    """The low and the high slope of release through a point at a speed.

    Eq. 3 without its time, solved for the slope. 25 operations: 5 additions, 2 subtractions, 11 multiplications, 3 divisions, 2 square roots, 1 comparison, 1 selection.
    Returns low, high.
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
    """When the centre comes down to a height, and its upward velocity then.

    Eq. 3, solved. 14 operations: 2 additions, 2 subtractions, 4 multiplications, 1 division, 1 square root, 1 negation, 1 comparison, 2 selections.
    Returns time, vz.
    """
    _s0 = z - level
    _s1 = _sqrt(((vz * vz) + ((2.0 * p_gravity) * _s0)))
    _s2 = vz < 0.0
    return _where(_s2, (2.0 * _s0), (vz + _s1)) / _where(_s2, (_s1 - vz), p_gravity), -_s1


def apex(z: Any, vz: Any, p_gravity: Any) -> tuple[Any, ...]:
    """When the centre is highest, and its height then.

    Eq. 3, its derivative zero. 8 operations: 1 addition, 2 multiplications, 2 divisions, 1 comparison, 2 selections.
    Returns time, height.
    """
    _s0 = 0.0 < vz
    return _where(_s0, (vz / p_gravity), 0.0), _where(_s0, (z + ((0.5 * (vz * vz)) / p_gravity)), z)


def sighted(x: Any, y: Any, place_x: Any, place_y: Any) -> tuple[Any, ...]:
    """How far a point is past the origin and to the left, seen from a place.

    components along and across the line of sight. 13 operations: 2 additions, 1 subtraction, 6 multiplications, 2 divisions, 1 square root, 1 negation.
    Returns past, left.
    """
    _s0 = _sqrt(((place_x * place_x) + (place_y * place_y)))
    return -(((place_x * x) + (place_y * y)) / _s0), ((place_y * x) - (place_x * y)) / _s0


def ring_nearness(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, half: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Distance of ball and wire at time t, and what bounds it within half a width of t.

    Eq. 3 in Table 2, Taylor's theorem. 153 operations: 35 additions, 15 subtractions, 58 multiplications, 4 divisions, 6 square roots, 2 negations, 7 absolute values, 13 comparisons, 13 selections.
    Returns gap, rate, lower, concavity, resolution.
    """
    _s0 = x + (t * vx)
    _s1 = y + (t * vy)
    _s2 = _sqrt(((_s0 * _s0) + (_s1 * _s1)))
    _s3 = _s2 - p_ring_radius
    _s4 = 0.5 * p_gravity
    _s5 = z + (t * (vz - (_s4 * t)))
    _s6 = (_s3 * _s3) + (_s5 * _s5)
    _s7 = p_ball_radius + p_wire_radius
    _s8 = 2.0 * (((((vx * _s0) + (vy * _s1)) / _s2) * _s3) + ((vz - (p_gravity * t)) * _s5))
    _s9 = t - half
    _s10 = (vx * vx) + (vy * vy)
    _s11 = -(((vx * x) + (vy * y)) / _s10)
    _s12 = half + t
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
    _s42 = (vy * x) - (vx * y)
    _s43 = (((2.0 * p_ring_radius) * (_s42 * _s42)) / (_s41 * (_s41 * _s41))) + (((6.0 * p_gravity) * _s35) - (2.0 * (((2.0 * p_gravity) * z) + ((vz * vz) + _s10))))
    _s44 = _where((0.0 < _s41), _s43, _inf)
    _s45 = _s6 - (half * (((0.5 * half) * _where(0.0 < _s44, _s44, 0.0)) + _absolute(_s8)))
    return _sqrt(_s6) - _s7, _s8, _sqrt(_where(_s38 < _s45, _s45, _s38)) - _s7, _s44, _s40


# The event loop, one function for each stage: it reads and writes the columns of the shots.


def _choose(truth: Any, new: Any, old: Any) -> Any:
    """Return new values where a truth holds."""
    if _ndim(truth) and len(truth) >= FEW:
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


def _take(values: Any, rows: Any) -> Any:
    """Return some rows of a column; what all shots share stays."""
    if rows is None or type(values) is not _ndarray or not values.ndim:
        return values
    return values[rows]


def _of(rows: Any, some: Any) -> Any:
    """Return some of the rows; None is all of them."""
    return some if rows is None else rows if some is None else rows[some]


def _copy(values: Any, shots: int) -> Any:
    """Return a column of one's own."""
    return values.copy() if _ndim(values) else _full(shots, values)


def _put(values: Any, rows: Any, new: Any, shots: int) -> Any:
    """Return a column with new values in some rows."""
    if rows is None:
        return new
    column = _copy(values, shots)
    column[rows] = new
    return column


def _store(values: Any, rows: Any, new: Any, some: Any) -> None:
    """Put some of the new values into rows of a column."""
    values[... if rows is None else rows] = _take(new, some)


def permit_plain(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage permit of the event loop, the path alone."""
    _p_backboard_friction_0 = columns["p_backboard_friction"]
    _p_backboard_restitution_0 = columns["p_backboard_restitution"]
    _p_ball_radius_0 = columns["p_ball_radius"]
    _p_board_bottom_0 = columns["p_board_bottom"]
    _p_board_distance_0 = columns["p_board_distance"]
    _p_board_half_width_0 = columns["p_board_half_width"]
    _p_board_thickness_0 = columns["p_board_thickness"]
    _p_board_top_0 = columns["p_board_top"]
    _p_bridge_depth_0 = columns["p_bridge_depth"]
    _p_bridge_friction_0 = columns["p_bridge_friction"]
    _p_bridge_half_width_0 = columns["p_bridge_half_width"]
    _p_bridge_restitution_0 = columns["p_bridge_restitution"]
    _p_end_depth_0 = columns["p_end_depth"]
    _p_gravity_0 = columns["p_gravity"]
    _p_restitution_speed_0 = columns["p_restitution_speed"]
    _p_ring_friction_0 = columns["p_ring_friction"]
    _p_ring_radius_0 = columns["p_ring_radius"]
    _p_ring_restitution_0 = columns["p_ring_restitution"]
    _p_tangential_restitution_0 = columns["p_tangential_restitution"]
    _p_wire_radius_0 = columns["p_wire_radius"]
    _allowed_0, = allowed(_p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_board_thickness_0, _p_bridge_half_width_0, _p_bridge_depth_0, _p_gravity_0, _p_end_depth_0, _p_ring_restitution_0, _p_backboard_restitution_0, _p_bridge_restitution_0, _p_ring_friction_0, _p_backboard_friction_0, _p_bridge_friction_0, _p_tangential_restitution_0, _p_restitution_speed_0)
    _permitted_0, = finite_parameters(_p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_board_thickness_0, _p_bridge_half_width_0, _p_bridge_depth_0, _p_gravity_0, _p_end_depth_0, _p_ring_restitution_0, _p_backboard_restitution_0, _p_bridge_restitution_0, _p_ring_friction_0, _p_backboard_friction_0, _p_bridge_friction_0, _p_tangential_restitution_0, _p_restitution_speed_0, _allowed_0)
    columns["permitted"] = _permitted_0


def admit_plain(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage admit of the event loop, the path alone."""
    _last_0 = columns["last"]
    _p_ball_radius_0 = columns["p_ball_radius"]
    _p_board_bottom_0 = columns["p_board_bottom"]
    _p_board_distance_0 = columns["p_board_distance"]
    _p_board_half_width_0 = columns["p_board_half_width"]
    _p_board_thickness_0 = columns["p_board_thickness"]
    _p_board_top_0 = columns["p_board_top"]
    _p_bridge_depth_0 = columns["p_bridge_depth"]
    _p_bridge_half_width_0 = columns["p_bridge_half_width"]
    _p_end_depth_0 = columns["p_end_depth"]
    _p_ring_radius_0 = columns["p_ring_radius"]
    _p_wire_radius_0 = columns["p_wire_radius"]
    _permitted_0 = columns["permitted"]
    _vx_0 = columns["vx"]
    _vy_0 = columns["vy"]
    _vz_0 = columns["vz"]
    _wx_0 = columns["wx"]
    _wy_0 = columns["wy"]
    _wz_0 = columns["wz"]
    _x_0 = columns["x"]
    _y_0 = columns["y"]
    _z_0 = columns["z"]
    _room_0 = room(shots)
    _finite_0, = finite_state(_vx_0, _vy_0, _vz_0, _wx_0, _wy_0, _wz_0, _x_0, _y_0, _z_0, _room_0)
    _valid_0, *_ = valid(_last_0, _x_0, _y_0, _z_0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_board_thickness_0, _p_bridge_half_width_0, _p_bridge_depth_0, _p_end_depth_0, _room_0)
    _outcome_0, *_ = admitted(_inf, _finite_0, _permitted_0, _valid_0)
    _through_0, *_ = passing_start(_last_0, _outcome_0, 0.0, _x_0, _y_0, _z_0, _p_ring_radius_0, _p_end_depth_0, _room_0)
    columns["outcome"] = _outcome_0
    columns["through"] = _through_0


def reach_plain(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage reach of the event loop, the path alone."""
    _circled_0 = columns["circled"]
    _clock_0 = columns["clock"]
    _contacts_0 = columns["contacts"]
    _held_0 = columns["held"]
    _last_0 = columns["last"]
    _mode_0 = columns["mode"]
    _most_contacts_0 = columns["most_contacts"]
    _p_ball_radius_0 = columns["p_ball_radius"]
    _p_board_bottom_0 = columns["p_board_bottom"]
    _p_board_distance_0 = columns["p_board_distance"]
    _p_board_half_width_0 = columns["p_board_half_width"]
    _p_board_thickness_0 = columns["p_board_thickness"]
    _p_board_top_0 = columns["p_board_top"]
    _p_bridge_depth_0 = columns["p_bridge_depth"]
    _p_bridge_half_width_0 = columns["p_bridge_half_width"]
    _p_end_depth_0 = columns["p_end_depth"]
    _p_gravity_0 = columns["p_gravity"]
    _p_ring_radius_0 = columns["p_ring_radius"]
    _p_wire_radius_0 = columns["p_wire_radius"]
    _rolls_0 = columns["rolls"]
    _through_0 = columns["through"]
    _time_limit_0 = columns["time_limit"]
    _vx_0 = columns["vx"]
    _vy_0 = columns["vy"]
    _vz_0 = columns["vz"]
    _wx_0 = columns["wx"]
    _wy_0 = columns["wy"]
    _wz_0 = columns["wz"]
    _x_0 = columns["x"]
    _y_0 = columns["y"]
    _z_0 = columns["z"]
    _room_0 = room(shots)
    _, _, _, _time_error_0 = error_bounds(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, _room_0)
    _extent_0, _speed_0, _excess_0 = scale(_x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _p_gravity_0, _room_0)
    _when_0, _which_0, *_ = opening(_excess_0, 0.0, 0.0)
    _limited_0, = limited(_time_limit_0)
    _kept_0, _when_0, _rests_0, _rolling_0, _began_0 = kept(_mode_0, _when_0)
    _leaving_0, = left(3.0, _last_0)
    _time_0, _rate_0, _bend_0, *_ = end_arrival(_leaving_0, _z_0, _vz_0, _p_gravity_0, _p_end_depth_0, _room_0)
    _arrives_0, *_ = meeting_plane(_bend_0, _rate_0, _time_0)
    _possible_0, = timely(_arrives_0, 0.0, 0.0, _time_0, _when_0)
    _when_1, _which_1 = sooner(_arrives_0, 3.0, _time_0, _when_0, _which_0)
    _when_0 = _choose(_possible_0, _when_1, _when_0)
    _which_0 = _choose(_possible_0, _which_1, _which_0)
    _until_0, *_ = horizon(_when_0, _speed_0, _p_gravity_0)
    _clear_0, = ring_clear(_until_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _extent_0, _speed_0, 0.0, 0.0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_gravity_0, _room_0)
    _open_0, = opens_in_flight(_clear_0, _kept_0)
    _rows1, _count2 = _rows(_open_0, shots)
    if _count2:
        _extent_1 = _take(_extent_0, _rows1)
        _last_1 = _take(_last_0, _rows1)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows1)
        _p_gravity_1 = _take(_p_gravity_0, _rows1)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows1)
        _p_wire_radius_1 = _take(_p_wire_radius_0, _rows1)
        _speed_1 = _take(_speed_0, _rows1)
        _until_1 = _take(_until_0, _rows1)
        _vx_1 = _take(_vx_0, _rows1)
        _vy_1 = _take(_vy_0, _rows1)
        _vz_1 = _take(_vz_0, _rows1)
        _when_1 = _take(_when_0, _rows1)
        _which_1 = _take(_which_0, _rows1)
        _x_1 = _take(_x_0, _rows1)
        _y_1 = _take(_y_0, _rows1)
        _z_1 = _take(_z_0, _rows1)
        _room_1 = room(_count2)
        _share_1, _arrival_1, _certain_1 = beginning()
        _leaving_1, = left(0.0, _last_1)
        _onset_1, _wide_end_1, _searching_1, _wide_low1_1, _wide_high1_1, _wide_low2_1, _wide_high2_1, _lapsed_1, _sound_1 = ring_opened(_until_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _since_1, *_ = opened(_double(_lapsed_1), _double(_onset_1))
        _rho_start_1, _parting_1, _drift_1 = ring_started(_x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ring_radius_1, _room_1)
        _near_x_1, _near_y_1, _near_z_1, _, _, _near_vz_1 = flight(_since_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_gravity_1, _room_1)
        _short_share_1, _short_t_1, _short_end_1, _short_x_1, _short_y_1, _short_z_1, _short_vx_1, _short_vy_1, _short_vz_1, _short_steady_1, _short_swing_1, _short_rho_start_1, _short_ceiling_1, _short_flat_1, _short_tilt_1, _short_jerk_1, _short_grit_1, _short_parting_1, _short_drift_1, _short_rate_margin_1, _short_low1_1, _short_high1_1, _short_low2_1, _short_high2_1, _fits_1 = ring_grain(_onset_1, _wide_end_1, _leaving_1, _lapsed_1, _near_x_1, _near_y_1, _near_z_1, _vx_1, _vy_1, _near_vz_1, _extent_1, _speed_1, _parting_1, _drift_1, _wide_low1_1, _wide_high1_1, _wide_low2_1, _wide_high2_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _leaping_1, _searching_1, _served_1, _ceiling_1, _flat_1, _tilt_1, *_ = coarse(_double(_short_ceiling_1), _fits_1, _double(_short_flat_1), _double(_short_rate_margin_1), _searching_1, _double(_short_share_1), _sound_1)
        _rows3, _count4 = _rows(_leaping_1, _count2)
        if _count4:
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows3)
            _p_gravity_2 = _take(_p_gravity_1, _rows3)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows3)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows3)
            _short_ceiling_2 = _take(_short_ceiling_1, _rows3)
            _short_drift_2 = _take(_short_drift_1, _rows3)
            _short_end_2 = _take(_short_end_1, _rows3)
            _short_flat_2 = _take(_short_flat_1, _rows3)
            _short_grit_2 = _take(_short_grit_1, _rows3)
            _short_high1_2 = _take(_short_high1_1, _rows3)
            _short_high2_2 = _take(_short_high2_1, _rows3)
            _short_jerk_2 = _take(_short_jerk_1, _rows3)
            _short_low1_2 = _take(_short_low1_1, _rows3)
            _short_low2_2 = _take(_short_low2_1, _rows3)
            _short_parting_2 = _take(_short_parting_1, _rows3)
            _short_rate_margin_2 = _take(_short_rate_margin_1, _rows3)
            _short_rho_start_2 = _take(_short_rho_start_1, _rows3)
            _short_steady_2 = _take(_short_steady_1, _rows3)
            _short_swing_2 = _take(_short_swing_1, _rows3)
            _short_t_2 = _take(_short_t_1, _rows3)
            _short_tilt_2 = _take(_short_tilt_1, _rows3)
            _short_vx_2 = _take(_short_vx_1, _rows3)
            _short_vy_2 = _take(_short_vy_1, _rows3)
            _short_vz_2 = _take(_short_vz_1, _rows3)
            _short_x_2 = _take(_short_x_1, _rows3)
            _short_y_2 = _take(_short_y_1, _rows3)
            _short_z_2 = _take(_short_z_1, _rows3)
            _room_2 = room(_count4)
            _short_t_2, _short_end_2, _certain_2, _leaping_2 = ring_leap(_short_t_2, _short_end_2, _short_rate_margin_2, _short_ceiling_2, _short_x_2, _short_y_2, _short_z_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_steady_2, _short_swing_2, _short_rho_start_2, _short_flat_2, _short_tilt_2, _short_grit_2, _short_jerk_2, _short_parting_2, _short_drift_2, _short_low1_2, _short_high1_2, _short_low2_2, _short_high2_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _certain_1 = _put(_certain_1, _rows3, _certain_2, _count2)
            _leaping_1 = _put(_leaping_1, _rows3, _leaping_2, _count2)
            _short_end_1 = _put(_short_end_1, _rows3, _short_end_2, _count2)
            _short_t_1 = _put(_short_t_1, _rows3, _short_t_2, _count2)
        _rows5, _count6 = _rows(_leaping_1, _count2)
        if _count6:
            _leaping_2 = _take(_leaping_1, _rows5)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows5)
            _p_gravity_2 = _take(_p_gravity_1, _rows5)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows5)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows5)
            _short_ceiling_2 = _take(_short_ceiling_1, _rows5)
            _short_drift_2 = _take(_short_drift_1, _rows5)
            _short_end_2 = _take(_short_end_1, _rows5)
            _short_flat_2 = _take(_short_flat_1, _rows5)
            _short_grit_2 = _take(_short_grit_1, _rows5)
            _short_high1_2 = _take(_short_high1_1, _rows5)
            _short_high2_2 = _take(_short_high2_1, _rows5)
            _short_jerk_2 = _take(_short_jerk_1, _rows5)
            _short_low1_2 = _take(_short_low1_1, _rows5)
            _short_low2_2 = _take(_short_low2_1, _rows5)
            _short_parting_2 = _take(_short_parting_1, _rows5)
            _short_rate_margin_2 = _take(_short_rate_margin_1, _rows5)
            _short_rho_start_2 = _take(_short_rho_start_1, _rows5)
            _short_steady_2 = _take(_short_steady_1, _rows5)
            _short_swing_2 = _take(_short_swing_1, _rows5)
            _short_t_2 = _take(_short_t_1, _rows5)
            _short_tilt_2 = _take(_short_tilt_1, _rows5)
            _short_vx_2 = _take(_short_vx_1, _rows5)
            _short_vy_2 = _take(_short_vy_1, _rows5)
            _short_vz_2 = _take(_short_vz_1, _rows5)
            _short_x_2 = _take(_short_x_1, _rows5)
            _short_y_2 = _take(_short_y_1, _rows5)
            _short_z_2 = _take(_short_z_1, _rows5)
            _certain_1 = _copy(_certain_1, _count2)
            _short_t_1 = _copy(_short_t_1, _count2)
            for _ in range(24):
                _room_2 = room(_count6)
                _short_t_2, _short_end_2, _certain_2, _leaping_2 = ring_leap(_short_t_2, _short_end_2, _short_rate_margin_2, _short_ceiling_2, _short_x_2, _short_y_2, _short_z_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_steady_2, _short_swing_2, _short_rho_start_2, _short_flat_2, _short_tilt_2, _short_grit_2, _short_jerk_2, _short_parting_2, _short_drift_2, _short_low1_2, _short_high1_2, _short_low2_2, _short_high2_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
                _going7 = _where_true(_leaping_2)
                if len(_going7) == _count6:
                    continue
                _done = _where_true(_logical_not(_leaping_2))
                _store(_certain_1, _of(_rows5, _done), _certain_2, _done)
                _store(_short_t_1, _of(_rows5, _done), _short_t_2, _done)
                _rows5, _count6 = _of(_rows5, _going7), len(_going7)
                if not _count6:
                    break
                _certain_2 = _take(_certain_2, _going7)
                _leaping_2 = _take(_leaping_2, _going7)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going7)
                _p_gravity_2 = _take(_p_gravity_2, _going7)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going7)
                _p_wire_radius_2 = _take(_p_wire_radius_2, _going7)
                _short_ceiling_2 = _take(_short_ceiling_2, _going7)
                _short_drift_2 = _take(_short_drift_2, _going7)
                _short_end_2 = _take(_short_end_2, _going7)
                _short_flat_2 = _take(_short_flat_2, _going7)
                _short_grit_2 = _take(_short_grit_2, _going7)
                _short_high1_2 = _take(_short_high1_2, _going7)
                _short_high2_2 = _take(_short_high2_2, _going7)
                _short_jerk_2 = _take(_short_jerk_2, _going7)
                _short_low1_2 = _take(_short_low1_2, _going7)
                _short_low2_2 = _take(_short_low2_2, _going7)
                _short_parting_2 = _take(_short_parting_2, _going7)
                _short_rate_margin_2 = _take(_short_rate_margin_2, _going7)
                _short_rho_start_2 = _take(_short_rho_start_2, _going7)
                _short_steady_2 = _take(_short_steady_2, _going7)
                _short_swing_2 = _take(_short_swing_2, _going7)
                _short_t_2 = _take(_short_t_2, _going7)
                _short_tilt_2 = _take(_short_tilt_2, _going7)
                _short_vx_2 = _take(_short_vx_2, _going7)
                _short_vy_2 = _take(_short_vy_2, _going7)
                _short_vz_2 = _take(_short_vz_2, _going7)
                _short_x_2 = _take(_short_x_2, _going7)
                _short_y_2 = _take(_short_y_2, _going7)
                _short_z_2 = _take(_short_z_2, _going7)
            else:
                _store(_certain_1, _rows5, _certain_2, None)
                _store(_short_t_1, _rows5, _short_t_2, None)
        _arrival_1, _t_1, _searching_1 = leapt(_arrival_1, _certain_1, _double(_short_t_1), _searching_1, _served_1, _since_1)
        _rows8, _count9 = _rows(_searching_1, _count2)
        if _count9:
            _arrival_2 = _take(_arrival_1, _rows8)
            _certain_2 = _take(_certain_1, _rows8)
            _extent_2 = _take(_extent_1, _rows8)
            _last_2 = _take(_last_1, _rows8)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows8)
            _p_gravity_2 = _take(_p_gravity_1, _rows8)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows8)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows8)
            _share_2 = _take(_share_1, _rows8)
            _speed_2 = _take(_speed_1, _rows8)
            _t_2 = _take(_t_1, _rows8)
            _until_2 = _take(_until_1, _rows8)
            _vx_2 = _take(_vx_1, _rows8)
            _vy_2 = _take(_vy_1, _rows8)
            _vz_2 = _take(_vz_1, _rows8)
            _x_2 = _take(_x_1, _rows8)
            _y_2 = _take(_y_1, _rows8)
            _z_2 = _take(_z_1, _rows8)
            _room_2 = room(_count9)
            _steady_2, _swing_2, _rho_start_2, _low0_2, _high0_2, _low1_2, _high1_2, _low2_2, _high2_2, _ceiling_2, _latest_2, *_ = ring_prepare(_until_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _extent_2, _speed_2, 0.0, 0.0, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _position_level_2, _velocity_level_2, *_ = allowance(_share_2, _latest_2, _extent_2, _speed_2, 0.0, 0.0, _p_gravity_2, _room_2)
            _flat_2, _tilt_2, _rate_slack_2 = ring_margins(_latest_2, _extent_2, _speed_2, _position_level_2, _velocity_level_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _t_2, _end_2, _searching_2 = ring_enter(_t_2, 0.0, _high0_2, _high1_2, _high2_2, _low0_2, _low1_2, _low2_2, _t_2, _room_2)
            _rows10, _count11 = _rows(_searching_2, _count9)
            if _count11:
                _arrival_3 = _take(_arrival_2, _rows10)
                _ceiling_3 = _take(_ceiling_2, _rows10)
                _certain_3 = _take(_certain_2, _rows10)
                _end_3 = _take(_end_2, _rows10)
                _flat_3 = _take(_flat_2, _rows10)
                _last_3 = _take(_last_2, _rows10)
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows10)
                _p_gravity_3 = _take(_p_gravity_2, _rows10)
                _p_ring_radius_3 = _take(_p_ring_radius_2, _rows10)
                _p_wire_radius_3 = _take(_p_wire_radius_2, _rows10)
                _rate_slack_3 = _take(_rate_slack_2, _rows10)
                _rho_start_3 = _take(_rho_start_2, _rows10)
                _searching_3 = _take(_searching_2, _rows10)
                _share_3 = _take(_share_2, _rows10)
                _steady_3 = _take(_steady_2, _rows10)
                _swing_3 = _take(_swing_2, _rows10)
                _t_3 = _take(_t_2, _rows10)
                _tilt_3 = _take(_tilt_2, _rows10)
                _vx_3 = _take(_vx_2, _rows10)
                _vy_3 = _take(_vy_2, _rows10)
                _vz_3 = _take(_vz_2, _rows10)
                _x_3 = _take(_x_2, _rows10)
                _y_3 = _take(_y_2, _rows10)
                _z_3 = _take(_z_2, _rows10)
                _arrival_2 = _copy(_arrival_2, _count9)
                _certain_2 = _copy(_certain_2, _count9)
                _flat_2 = _copy(_flat_2, _count9)
                _tilt_2 = _copy(_tilt_2, _count9)
                for _ in range(201):
                    _room_3 = room(_count11)
                    _leaving_3, _margin_3 = nearby(_flat_3, 0.0, _last_3, _t_3, _tilt_3)
                    _gap_3, _rate_3, _bend_3, _step_3, _next_3, _clearance_3 = ring_advance(_t_3, _end_3, _leaving_3, _margin_3, _rate_slack_3, _ceiling_3, _x_3, _y_3, _z_3, _vx_3, _vy_3, _vz_3, _steady_3, _swing_3, _rho_start_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_gravity_3, _room_3)
                    _hit_3, _sure_3, _vague_3 = struck(_bend_3, _clearance_3, _gap_3, _margin_3, _rate_3, _rate_slack_3, _share_3)
                    _rows12, _count13 = _rows(_vague_3, _count11)
                    if _count13:
                        _far = _of(_rows10, _rows12)
                        _extent_4 = _take(_extent_2, _far)
                        _latest_4 = _take(_latest_2, _far)
                        _p_ball_radius_4 = _take(_p_ball_radius_3, _rows12)
                        _p_gravity_4 = _take(_p_gravity_3, _rows12)
                        _p_ring_radius_4 = _take(_p_ring_radius_3, _rows12)
                        _p_wire_radius_4 = _take(_p_wire_radius_3, _rows12)
                        _share_4 = _take(_share_3, _rows12)
                        _speed_4 = _take(_speed_2, _far)
                        _room_4 = room(_count13)
                        _share_4, = finer(_share_4)
                        _position_level_4, _velocity_level_4, *_ = allowance(_share_4, _latest_4, _extent_4, _speed_4, 0.0, 0.0, _p_gravity_4, _room_4)
                        _flat_4, _tilt_4, _rate_slack_4 = ring_margins(_latest_4, _extent_4, _speed_4, _position_level_4, _velocity_level_4, _p_ball_radius_4, _p_ring_radius_4, _p_wire_radius_4, _p_gravity_4, _room_4)
                        _flat_3 = _put(_flat_3, _rows12, _flat_4, _count11)
                        _rate_slack_3 = _put(_rate_slack_3, _rows12, _rate_slack_4, _count11)
                        _share_3 = _put(_share_3, _rows12, _share_4, _count11)
                        _tilt_3 = _put(_tilt_3, _rows12, _tilt_4, _count11)
                    _arrival_3, _certain_3, _exhausted_3, _searching_3, _t_3 = advanced(_arrival_3, _certain_3, _end_3, _hit_3, _next_3, _step_3, _sure_3, _t_3, _vague_3)
                    _rows14, _count15 = _rows(_exhausted_3, _count11)
                    if _count15:
                        _far = _of(_rows10, _rows14)
                        _end_4 = _take(_end_3, _rows14)
                        _high0_4 = _take(_high0_2, _far)
                        _high1_4 = _take(_high1_2, _far)
                        _high2_4 = _take(_high2_2, _far)
                        _low0_4 = _take(_low0_2, _far)
                        _low1_4 = _take(_low1_2, _far)
                        _low2_4 = _take(_low2_2, _far)
                        _t_4 = _take(_t_3, _rows14)
                        _room_4 = room(_count15)
                        _t_4, _end_4, _searching_4 = ring_enter(_end_4, _end_4, _high0_4, _high1_4, _high2_4, _low0_4, _low1_4, _low2_4, _t_4, _room_4)
                        _end_3 = _put(_end_3, _rows14, _end_4, _count11)
                        _searching_3 = _put(_searching_3, _rows14, _searching_4, _count11)
                        _t_3 = _put(_t_3, _rows14, _t_4, _count11)
                    _going16 = _where_true(_searching_3)
                    if len(_going16) == _count11:
                        continue
                    _done = _where_true(_logical_not(_searching_3))
                    _store(_arrival_2, _of(_rows10, _done), _arrival_3, _done)
                    _store(_certain_2, _of(_rows10, _done), _certain_3, _done)
                    _store(_flat_2, _of(_rows10, _done), _flat_3, _done)
                    _store(_tilt_2, _of(_rows10, _done), _tilt_3, _done)
                    _rows10, _count11 = _of(_rows10, _going16), len(_going16)
                    if not _count11:
                        break
                    _arrival_3 = _take(_arrival_3, _going16)
                    _ceiling_3 = _take(_ceiling_3, _going16)
                    _certain_3 = _take(_certain_3, _going16)
                    _end_3 = _take(_end_3, _going16)
                    _flat_3 = _take(_flat_3, _going16)
                    _last_3 = _take(_last_3, _going16)
                    _p_ball_radius_3 = _take(_p_ball_radius_3, _going16)
                    _p_gravity_3 = _take(_p_gravity_3, _going16)
                    _p_ring_radius_3 = _take(_p_ring_radius_3, _going16)
                    _p_wire_radius_3 = _take(_p_wire_radius_3, _going16)
                    _rate_slack_3 = _take(_rate_slack_3, _going16)
                    _rho_start_3 = _take(_rho_start_3, _going16)
                    _searching_3 = _take(_searching_3, _going16)
                    _share_3 = _take(_share_3, _going16)
                    _steady_3 = _take(_steady_3, _going16)
                    _swing_3 = _take(_swing_3, _going16)
                    _t_3 = _take(_t_3, _going16)
                    _tilt_3 = _take(_tilt_3, _going16)
                    _vx_3 = _take(_vx_3, _going16)
                    _vy_3 = _take(_vy_3, _going16)
                    _vz_3 = _take(_vz_3, _going16)
                    _x_3 = _take(_x_3, _going16)
                    _y_3 = _take(_y_3, _going16)
                    _z_3 = _take(_z_3, _going16)
                else:
                    _store(_arrival_2, _rows10, _arrival_3, None)
                    _store(_certain_2, _rows10, _certain_3, None)
                    _store(_flat_2, _rows10, _flat_3, None)
                    _store(_tilt_2, _rows10, _tilt_3, None)
            _arrival_1 = _put(_arrival_1, _rows8, _arrival_2, _count2)
            _ceiling_1 = _put(_ceiling_1, _rows8, _ceiling_2, _count2)
            _certain_1 = _put(_certain_1, _rows8, _certain_2, _count2)
            _flat_1 = _put(_flat_1, _rows8, _flat_2, _count2)
            _rho_start_1 = _put(_rho_start_1, _rows8, _rho_start_2, _count2)
            _tilt_1 = _put(_tilt_1, _rows8, _tilt_2, _count2)
        _arrives_1, _refining_1, *_ = found(_arrival_1)
        _leaving_1, *_ = nearby(_flat_1, 0.0, _last_1, _arrival_1, _tilt_1)
        _rows17, _count18 = _rows(_refining_1, _count2)
        if _count18:
            _arrival_2 = _take(_arrival_1, _rows17)
            _ceiling_2 = _take(_ceiling_1, _rows17)
            _certain_2 = _take(_certain_1, _rows17)
            _leaving_2 = _take(_leaving_1, _rows17)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows17)
            _p_gravity_2 = _take(_p_gravity_1, _rows17)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows17)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows17)
            _rho_start_2 = _take(_rho_start_1, _rows17)
            _vx_2 = _take(_vx_1, _rows17)
            _vy_2 = _take(_vy_1, _rows17)
            _vz_2 = _take(_vz_1, _rows17)
            _x_2 = _take(_x_1, _rows17)
            _y_2 = _take(_y_1, _rows17)
            _z_2 = _take(_z_1, _rows17)
            _room_2 = room(_count18)
            _refined_2, _gap_2, _rate_2 = ring_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _rho_start_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
            _arrival_1 = _put(_arrival_1, _rows17, _arrival_2, _count2)
            _refining_1 = _put(_refining_1, _rows17, _refining_2, _count2)
        _rows19, _count20 = _rows(_refining_1, _count2)
        if _count20:
            _arrival_2 = _take(_arrival_1, _rows19)
            _ceiling_2 = _take(_ceiling_1, _rows19)
            _certain_2 = _take(_certain_1, _rows19)
            _leaving_2 = _take(_leaving_1, _rows19)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows19)
            _p_gravity_2 = _take(_p_gravity_1, _rows19)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows19)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows19)
            _rho_start_2 = _take(_rho_start_1, _rows19)
            _vx_2 = _take(_vx_1, _rows19)
            _vy_2 = _take(_vy_1, _rows19)
            _vz_2 = _take(_vz_1, _rows19)
            _x_2 = _take(_x_1, _rows19)
            _y_2 = _take(_y_1, _rows19)
            _z_2 = _take(_z_1, _rows19)
            _room_2 = room(_count20)
            _refined_2, _gap_2, _rate_2 = ring_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _rho_start_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
            _arrival_1 = _put(_arrival_1, _rows19, _arrival_2, _count2)
            _refining_1 = _put(_refining_1, _rows19, _refining_2, _count2)
        _rows21, _count22 = _rows(_refining_1, _count2)
        if _count22:
            _arrival_2 = _take(_arrival_1, _rows21)
            _ceiling_2 = _take(_ceiling_1, _rows21)
            _certain_2 = _take(_certain_1, _rows21)
            _leaving_2 = _take(_leaving_1, _rows21)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows21)
            _p_gravity_2 = _take(_p_gravity_1, _rows21)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows21)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows21)
            _refining_2 = _take(_refining_1, _rows21)
            _rho_start_2 = _take(_rho_start_1, _rows21)
            _vx_2 = _take(_vx_1, _rows21)
            _vy_2 = _take(_vy_1, _rows21)
            _vz_2 = _take(_vz_1, _rows21)
            _x_2 = _take(_x_1, _rows21)
            _y_2 = _take(_y_1, _rows21)
            _z_2 = _take(_z_1, _rows21)
            _arrival_1 = _copy(_arrival_1, _count2)
            for _ in range(8):
                _room_2 = room(_count22)
                _refined_2, _gap_2, _rate_2 = ring_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _rho_start_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
                _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
                _going23 = _where_true(_refining_2)
                if len(_going23) == _count22:
                    continue
                _done = _where_true(_logical_not(_refining_2))
                _store(_arrival_1, _of(_rows21, _done), _arrival_2, _done)
                _rows21, _count22 = _of(_rows21, _going23), len(_going23)
                if not _count22:
                    break
                _arrival_2 = _take(_arrival_2, _going23)
                _ceiling_2 = _take(_ceiling_2, _going23)
                _certain_2 = _take(_certain_2, _going23)
                _leaving_2 = _take(_leaving_2, _going23)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going23)
                _p_gravity_2 = _take(_p_gravity_2, _going23)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going23)
                _p_wire_radius_2 = _take(_p_wire_radius_2, _going23)
                _refining_2 = _take(_refining_2, _going23)
                _rho_start_2 = _take(_rho_start_2, _going23)
                _vx_2 = _take(_vx_2, _going23)
                _vy_2 = _take(_vy_2, _going23)
                _vz_2 = _take(_vz_2, _going23)
                _x_2 = _take(_x_2, _going23)
                _y_2 = _take(_y_2, _going23)
                _z_2 = _take(_z_2, _going23)
            else:
                _store(_arrival_1, _rows21, _arrival_2, None)
        _time_1, = landed(_arrival_1)
        _when_1, _which_1 = sooner(_arrives_1, 0.0, _time_1, _when_1, _which_1)
        _when_0 = _put(_when_0, _rows1, _when_1, shots)
        _which_0 = _put(_which_0, _rows1, _which_1, shots)
    _until_0, _pad_0 = horizon(_when_0, _speed_0, _p_gravity_0)
    _middle_x_0, _reach_x_0, _later_middle_x_0, _later_reach_x_0, _middle_y_0, _reach_y_0, _later_middle_y_0, _later_reach_y_0, _middle_z_0, _reach_z_0, _later_middle_z_0, _later_reach_z_0 = halved(_until_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _extent_0, _speed_0, 0.0, 0.0, 0.0, _pad_0, _p_gravity_0, _room_0)
    _reachable_0, = backboard_near(_middle_x_0, _middle_y_0, _middle_z_0, _reach_x_0, _reach_y_0, _reach_z_0, _later_middle_x_0, _later_middle_y_0, _later_middle_z_0, _later_reach_x_0, _later_reach_y_0, _later_reach_z_0, _p_ball_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_board_thickness_0, _room_0)
    _reachable_0, = reachable_in_flight(_kept_0, _reachable_0)
    _rows24, _count25 = _rows(_reachable_0, shots)
    if _count25:
        _extent_1 = _take(_extent_0, _rows24)
        _last_1 = _take(_last_0, _rows24)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows24)
        _p_board_bottom_1 = _take(_p_board_bottom_0, _rows24)
        _p_board_distance_1 = _take(_p_board_distance_0, _rows24)
        _p_board_half_width_1 = _take(_p_board_half_width_0, _rows24)
        _p_board_thickness_1 = _take(_p_board_thickness_0, _rows24)
        _p_board_top_1 = _take(_p_board_top_0, _rows24)
        _p_gravity_1 = _take(_p_gravity_0, _rows24)
        _speed_1 = _take(_speed_0, _rows24)
        _vx_1 = _take(_vx_0, _rows24)
        _vy_1 = _take(_vy_0, _rows24)
        _vz_1 = _take(_vz_0, _rows24)
        _when_1 = _take(_when_0, _rows24)
        _which_1 = _take(_which_0, _rows24)
        _x_1 = _take(_x_0, _rows24)
        _y_1 = _take(_y_0, _rows24)
        _z_1 = _take(_z_0, _rows24)
        _room_1 = room(_count25)
        _until_1, *_ = horizon(_when_1, _speed_1, _p_gravity_1)
        _low0_1, _high0_1, _low1_1, _high1_1, _ceiling_1, _latest_1, *_ = backboard_prepare(_until_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, 0.0, 0.0, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _p_gravity_1, _room_1)
        _share_1, _arrival_1, _certain_1 = beginning()
        _position_level_1, _velocity_level_1, *_ = allowance(_share_1, _latest_1, _extent_1, _speed_1, 0.0, 0.0, _p_gravity_1, _room_1)
        _flat_1, _tilt_1, _rate_slack_1 = backboard_margins(_latest_1, _extent_1, _speed_1, _position_level_1, _velocity_level_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _p_gravity_1, _room_1)
        _t_1, _end_1, _searching_1 = backboard_enter(0.0, 0.0, _high0_1, _high1_1, _low0_1, _low1_1, 0.0)
        _rows26, _count27 = _rows(_searching_1, _count25)
        if _count27:
            _arrival_2 = _take(_arrival_1, _rows26)
            _ceiling_2 = _take(_ceiling_1, _rows26)
            _certain_2 = _take(_certain_1, _rows26)
            _end_2 = _take(_end_1, _rows26)
            _extent_2 = _take(_extent_1, _rows26)
            _flat_2 = _take(_flat_1, _rows26)
            _high0_2 = _take(_high0_1, _rows26)
            _high1_2 = _take(_high1_1, _rows26)
            _last_2 = _take(_last_1, _rows26)
            _latest_2 = _take(_latest_1, _rows26)
            _low0_2 = _take(_low0_1, _rows26)
            _low1_2 = _take(_low1_1, _rows26)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows26)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows26)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows26)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows26)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows26)
            _p_board_top_2 = _take(_p_board_top_1, _rows26)
            _p_gravity_2 = _take(_p_gravity_1, _rows26)
            _rate_slack_2 = _take(_rate_slack_1, _rows26)
            _share_2 = _take(_share_1, _rows26)
            _speed_2 = _take(_speed_1, _rows26)
            _t_2 = _take(_t_1, _rows26)
            _tilt_2 = _take(_tilt_1, _rows26)
            _vx_2 = _take(_vx_1, _rows26)
            _vy_2 = _take(_vy_1, _rows26)
            _vz_2 = _take(_vz_1, _rows26)
            _x_2 = _take(_x_1, _rows26)
            _y_2 = _take(_y_1, _rows26)
            _z_2 = _take(_z_1, _rows26)
            _room_2 = room(_count27)
            _leaving_2, _margin_2 = nearby(_flat_2, 1.0, _last_2, _t_2, _tilt_2)
            _gap_2, _rate_2, _bend_2, _step_2, _next_2, _clearance_2 = backboard_advance(_t_2, _end_2, _leaving_2, _margin_2, _rate_slack_2, _ceiling_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _p_gravity_2, _room_2)
            _hit_2, _sure_2, _vague_2 = struck_or_still(_bend_2, _clearance_2, _end_2, _gap_2, _margin_2, _next_2, _rate_2, _rate_slack_2, _share_2, _t_2)
            _rows28, _count29 = _rows(_vague_2, _count27)
            if _count29:
                _extent_3 = _take(_extent_2, _rows28)
                _latest_3 = _take(_latest_2, _rows28)
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows28)
                _p_board_bottom_3 = _take(_p_board_bottom_2, _rows28)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows28)
                _p_board_half_width_3 = _take(_p_board_half_width_2, _rows28)
                _p_board_thickness_3 = _take(_p_board_thickness_2, _rows28)
                _p_board_top_3 = _take(_p_board_top_2, _rows28)
                _p_gravity_3 = _take(_p_gravity_2, _rows28)
                _share_3 = _take(_share_2, _rows28)
                _speed_3 = _take(_speed_2, _rows28)
                _room_3 = room(_count29)
                _share_3, = finer(_share_3)
                _position_level_3, _velocity_level_3, *_ = allowance(_share_3, _latest_3, _extent_3, _speed_3, 0.0, 0.0, _p_gravity_3, _room_3)
                _flat_3, _tilt_3, _rate_slack_3 = backboard_margins(_latest_3, _extent_3, _speed_3, _position_level_3, _velocity_level_3, _p_ball_radius_3, _p_board_distance_3, _p_board_half_width_3, _p_board_bottom_3, _p_board_top_3, _p_board_thickness_3, _p_gravity_3, _room_3)
                _flat_2 = _put(_flat_2, _rows28, _flat_3, _count27)
                _rate_slack_2 = _put(_rate_slack_2, _rows28, _rate_slack_3, _count27)
                _share_2 = _put(_share_2, _rows28, _share_3, _count27)
                _tilt_2 = _put(_tilt_2, _rows28, _tilt_3, _count27)
            _arrival_2, _certain_2, _exhausted_2, _searching_2, _t_2 = advanced(_arrival_2, _certain_2, _end_2, _hit_2, _next_2, _step_2, _sure_2, _t_2, _vague_2)
            _t_3, _end_3, _searching_3 = backboard_enter(_end_2, _end_2, _high0_2, _high1_2, _low0_2, _low1_2, _t_2)
            _end_2 = _choose(_exhausted_2, _end_3, _end_2)
            _searching_2 = _choose(_exhausted_2, _searching_3, _searching_2)
            _t_2 = _choose(_exhausted_2, _t_3, _t_2)
            _arrival_1 = _put(_arrival_1, _rows26, _arrival_2, _count25)
            _certain_1 = _put(_certain_1, _rows26, _certain_2, _count25)
            _end_1 = _put(_end_1, _rows26, _end_2, _count25)
            _flat_1 = _put(_flat_1, _rows26, _flat_2, _count25)
            _rate_slack_1 = _put(_rate_slack_1, _rows26, _rate_slack_2, _count25)
            _searching_1 = _put(_searching_1, _rows26, _searching_2, _count25)
            _share_1 = _put(_share_1, _rows26, _share_2, _count25)
            _t_1 = _put(_t_1, _rows26, _t_2, _count25)
            _tilt_1 = _put(_tilt_1, _rows26, _tilt_2, _count25)
        _rows30, _count31 = _rows(_searching_1, _count25)
        if _count31:
            _arrival_2 = _take(_arrival_1, _rows30)
            _ceiling_2 = _take(_ceiling_1, _rows30)
            _certain_2 = _take(_certain_1, _rows30)
            _end_2 = _take(_end_1, _rows30)
            _flat_2 = _take(_flat_1, _rows30)
            _last_2 = _take(_last_1, _rows30)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows30)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows30)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows30)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows30)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows30)
            _p_board_top_2 = _take(_p_board_top_1, _rows30)
            _p_gravity_2 = _take(_p_gravity_1, _rows30)
            _rate_slack_2 = _take(_rate_slack_1, _rows30)
            _searching_2 = _take(_searching_1, _rows30)
            _share_2 = _take(_share_1, _rows30)
            _t_2 = _take(_t_1, _rows30)
            _tilt_2 = _take(_tilt_1, _rows30)
            _vx_2 = _take(_vx_1, _rows30)
            _vy_2 = _take(_vy_1, _rows30)
            _vz_2 = _take(_vz_1, _rows30)
            _x_2 = _take(_x_1, _rows30)
            _y_2 = _take(_y_1, _rows30)
            _z_2 = _take(_z_1, _rows30)
            _arrival_1 = _copy(_arrival_1, _count25)
            _certain_1 = _copy(_certain_1, _count25)
            _flat_1 = _copy(_flat_1, _count25)
            _tilt_1 = _copy(_tilt_1, _count25)
            for _ in range(201):
                _room_2 = room(_count31)
                _leaving_2, _margin_2 = nearby(_flat_2, 1.0, _last_2, _t_2, _tilt_2)
                _gap_2, _rate_2, _bend_2, _step_2, _next_2, _clearance_2 = backboard_advance(_t_2, _end_2, _leaving_2, _margin_2, _rate_slack_2, _ceiling_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _p_gravity_2, _room_2)
                _hit_2, _sure_2, _vague_2 = struck_or_still(_bend_2, _clearance_2, _end_2, _gap_2, _margin_2, _next_2, _rate_2, _rate_slack_2, _share_2, _t_2)
                _rows32, _count33 = _rows(_vague_2, _count31)
                if _count33:
                    _far = _of(_rows30, _rows32)
                    _extent_3 = _take(_extent_1, _far)
                    _latest_3 = _take(_latest_1, _far)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows32)
                    _p_board_bottom_3 = _take(_p_board_bottom_2, _rows32)
                    _p_board_distance_3 = _take(_p_board_distance_2, _rows32)
                    _p_board_half_width_3 = _take(_p_board_half_width_2, _rows32)
                    _p_board_thickness_3 = _take(_p_board_thickness_2, _rows32)
                    _p_board_top_3 = _take(_p_board_top_2, _rows32)
                    _p_gravity_3 = _take(_p_gravity_2, _rows32)
                    _share_3 = _take(_share_2, _rows32)
                    _speed_3 = _take(_speed_1, _far)
                    _room_3 = room(_count33)
                    _share_3, = finer(_share_3)
                    _position_level_3, _velocity_level_3, *_ = allowance(_share_3, _latest_3, _extent_3, _speed_3, 0.0, 0.0, _p_gravity_3, _room_3)
                    _flat_3, _tilt_3, _rate_slack_3 = backboard_margins(_latest_3, _extent_3, _speed_3, _position_level_3, _velocity_level_3, _p_ball_radius_3, _p_board_distance_3, _p_board_half_width_3, _p_board_bottom_3, _p_board_top_3, _p_board_thickness_3, _p_gravity_3, _room_3)
                    _flat_2 = _put(_flat_2, _rows32, _flat_3, _count31)
                    _rate_slack_2 = _put(_rate_slack_2, _rows32, _rate_slack_3, _count31)
                    _share_2 = _put(_share_2, _rows32, _share_3, _count31)
                    _tilt_2 = _put(_tilt_2, _rows32, _tilt_3, _count31)
                _arrival_2, _certain_2, _exhausted_2, _searching_2, _t_2 = advanced(_arrival_2, _certain_2, _end_2, _hit_2, _next_2, _step_2, _sure_2, _t_2, _vague_2)
                _rows34, _count35 = _rows(_exhausted_2, _count31)
                if _count35:
                    _far = _of(_rows30, _rows34)
                    _end_3 = _take(_end_2, _rows34)
                    _high0_3 = _take(_high0_1, _far)
                    _high1_3 = _take(_high1_1, _far)
                    _low0_3 = _take(_low0_1, _far)
                    _low1_3 = _take(_low1_1, _far)
                    _t_3 = _take(_t_2, _rows34)
                    _t_3, _end_3, _searching_3 = backboard_enter(_end_3, _end_3, _high0_3, _high1_3, _low0_3, _low1_3, _t_3)
                    _end_2 = _put(_end_2, _rows34, _end_3, _count31)
                    _searching_2 = _put(_searching_2, _rows34, _searching_3, _count31)
                    _t_2 = _put(_t_2, _rows34, _t_3, _count31)
                _going36 = _where_true(_searching_2)
                if len(_going36) == _count31:
                    continue
                _done = _where_true(_logical_not(_searching_2))
                _store(_arrival_1, _of(_rows30, _done), _arrival_2, _done)
                _store(_certain_1, _of(_rows30, _done), _certain_2, _done)
                _store(_flat_1, _of(_rows30, _done), _flat_2, _done)
                _store(_tilt_1, _of(_rows30, _done), _tilt_2, _done)
                _rows30, _count31 = _of(_rows30, _going36), len(_going36)
                if not _count31:
                    break
                _arrival_2 = _take(_arrival_2, _going36)
                _ceiling_2 = _take(_ceiling_2, _going36)
                _certain_2 = _take(_certain_2, _going36)
                _end_2 = _take(_end_2, _going36)
                _flat_2 = _take(_flat_2, _going36)
                _last_2 = _take(_last_2, _going36)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going36)
                _p_board_bottom_2 = _take(_p_board_bottom_2, _going36)
                _p_board_distance_2 = _take(_p_board_distance_2, _going36)
                _p_board_half_width_2 = _take(_p_board_half_width_2, _going36)
                _p_board_thickness_2 = _take(_p_board_thickness_2, _going36)
                _p_board_top_2 = _take(_p_board_top_2, _going36)
                _p_gravity_2 = _take(_p_gravity_2, _going36)
                _rate_slack_2 = _take(_rate_slack_2, _going36)
                _searching_2 = _take(_searching_2, _going36)
                _share_2 = _take(_share_2, _going36)
                _t_2 = _take(_t_2, _going36)
                _tilt_2 = _take(_tilt_2, _going36)
                _vx_2 = _take(_vx_2, _going36)
                _vy_2 = _take(_vy_2, _going36)
                _vz_2 = _take(_vz_2, _going36)
                _x_2 = _take(_x_2, _going36)
                _y_2 = _take(_y_2, _going36)
                _z_2 = _take(_z_2, _going36)
            else:
                _store(_arrival_1, _rows30, _arrival_2, None)
                _store(_certain_1, _rows30, _certain_2, None)
                _store(_flat_1, _rows30, _flat_2, None)
                _store(_tilt_1, _rows30, _tilt_2, None)
        _arrives_1, _refining_1, *_ = found(_arrival_1)
        _leaving_1, *_ = nearby(_flat_1, 1.0, _last_1, _arrival_1, _tilt_1)
        _rows37, _count38 = _rows(_refining_1, _count25)
        if _count38:
            _arrival_2 = _take(_arrival_1, _rows37)
            _ceiling_2 = _take(_ceiling_1, _rows37)
            _certain_2 = _take(_certain_1, _rows37)
            _leaving_2 = _take(_leaving_1, _rows37)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows37)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows37)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows37)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows37)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows37)
            _p_board_top_2 = _take(_p_board_top_1, _rows37)
            _p_gravity_2 = _take(_p_gravity_1, _rows37)
            _vx_2 = _take(_vx_1, _rows37)
            _vy_2 = _take(_vy_1, _rows37)
            _vz_2 = _take(_vz_1, _rows37)
            _x_2 = _take(_x_1, _rows37)
            _y_2 = _take(_y_1, _rows37)
            _z_2 = _take(_z_1, _rows37)
            _room_2 = room(_count38)
            _refined_2, _gap_2, _rate_2 = backboard_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
            _arrival_1 = _put(_arrival_1, _rows37, _arrival_2, _count25)
            _refining_1 = _put(_refining_1, _rows37, _refining_2, _count25)
        _rows39, _count40 = _rows(_refining_1, _count25)
        if _count40:
            _arrival_2 = _take(_arrival_1, _rows39)
            _ceiling_2 = _take(_ceiling_1, _rows39)
            _certain_2 = _take(_certain_1, _rows39)
            _leaving_2 = _take(_leaving_1, _rows39)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows39)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows39)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows39)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows39)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows39)
            _p_board_top_2 = _take(_p_board_top_1, _rows39)
            _p_gravity_2 = _take(_p_gravity_1, _rows39)
            _vx_2 = _take(_vx_1, _rows39)
            _vy_2 = _take(_vy_1, _rows39)
            _vz_2 = _take(_vz_1, _rows39)
            _x_2 = _take(_x_1, _rows39)
            _y_2 = _take(_y_1, _rows39)
            _z_2 = _take(_z_1, _rows39)
            _room_2 = room(_count40)
            _refined_2, _gap_2, _rate_2 = backboard_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
            _arrival_1 = _put(_arrival_1, _rows39, _arrival_2, _count25)
            _refining_1 = _put(_refining_1, _rows39, _refining_2, _count25)
        _rows41, _count42 = _rows(_refining_1, _count25)
        if _count42:
            _arrival_2 = _take(_arrival_1, _rows41)
            _ceiling_2 = _take(_ceiling_1, _rows41)
            _certain_2 = _take(_certain_1, _rows41)
            _leaving_2 = _take(_leaving_1, _rows41)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows41)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows41)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows41)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows41)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows41)
            _p_board_top_2 = _take(_p_board_top_1, _rows41)
            _p_gravity_2 = _take(_p_gravity_1, _rows41)
            _refining_2 = _take(_refining_1, _rows41)
            _vx_2 = _take(_vx_1, _rows41)
            _vy_2 = _take(_vy_1, _rows41)
            _vz_2 = _take(_vz_1, _rows41)
            _x_2 = _take(_x_1, _rows41)
            _y_2 = _take(_y_1, _rows41)
            _z_2 = _take(_z_1, _rows41)
            _arrival_1 = _copy(_arrival_1, _count25)
            for _ in range(8):
                _room_2 = room(_count42)
                _refined_2, _gap_2, _rate_2 = backboard_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _p_gravity_2, _room_2)
                _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
                _going43 = _where_true(_refining_2)
                if len(_going43) == _count42:
                    continue
                _done = _where_true(_logical_not(_refining_2))
                _store(_arrival_1, _of(_rows41, _done), _arrival_2, _done)
                _rows41, _count42 = _of(_rows41, _going43), len(_going43)
                if not _count42:
                    break
                _arrival_2 = _take(_arrival_2, _going43)
                _ceiling_2 = _take(_ceiling_2, _going43)
                _certain_2 = _take(_certain_2, _going43)
                _leaving_2 = _take(_leaving_2, _going43)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going43)
                _p_board_bottom_2 = _take(_p_board_bottom_2, _going43)
                _p_board_distance_2 = _take(_p_board_distance_2, _going43)
                _p_board_half_width_2 = _take(_p_board_half_width_2, _going43)
                _p_board_thickness_2 = _take(_p_board_thickness_2, _going43)
                _p_board_top_2 = _take(_p_board_top_2, _going43)
                _p_gravity_2 = _take(_p_gravity_2, _going43)
                _refining_2 = _take(_refining_2, _going43)
                _vx_2 = _take(_vx_2, _going43)
                _vy_2 = _take(_vy_2, _going43)
                _vz_2 = _take(_vz_2, _going43)
                _x_2 = _take(_x_2, _going43)
                _y_2 = _take(_y_2, _going43)
                _z_2 = _take(_z_2, _going43)
            else:
                _store(_arrival_1, _rows41, _arrival_2, None)
        _time_1, = landed(_arrival_1)
        _when_1, _which_1 = sooner(_arrives_1, 1.0, _time_1, _when_1, _which_1)
        _when_0 = _put(_when_0, _rows24, _when_1, shots)
        _which_0 = _put(_which_0, _rows24, _which_1, shots)
    _until_0, _pad_0 = horizon(_when_0, _speed_0, _p_gravity_0)
    _middle_x_0, _reach_x_0, _later_middle_x_0, _later_reach_x_0, _middle_y_0, _reach_y_0, _later_middle_y_0, _later_reach_y_0, _middle_z_0, _reach_z_0, _later_middle_z_0, _later_reach_z_0 = halved(_until_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _extent_0, _speed_0, 0.0, 0.0, 0.0, _pad_0, _p_gravity_0, _room_0)
    _reachable_0, = bridge_near(_middle_x_0, _middle_y_0, _middle_z_0, _reach_x_0, _reach_y_0, _reach_z_0, _later_middle_x_0, _later_middle_y_0, _later_middle_z_0, _later_reach_x_0, _later_reach_y_0, _later_reach_z_0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_bridge_half_width_0, _p_bridge_depth_0, _room_0)
    _reachable_0, = reachable_in_flight(_kept_0, _reachable_0)
    _rows44, _count45 = _rows(_reachable_0, shots)
    if _count45:
        _extent_1 = _take(_extent_0, _rows44)
        _last_1 = _take(_last_0, _rows44)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows44)
        _p_board_distance_1 = _take(_p_board_distance_0, _rows44)
        _p_bridge_depth_1 = _take(_p_bridge_depth_0, _rows44)
        _p_bridge_half_width_1 = _take(_p_bridge_half_width_0, _rows44)
        _p_gravity_1 = _take(_p_gravity_0, _rows44)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows44)
        _p_wire_radius_1 = _take(_p_wire_radius_0, _rows44)
        _speed_1 = _take(_speed_0, _rows44)
        _vx_1 = _take(_vx_0, _rows44)
        _vy_1 = _take(_vy_0, _rows44)
        _vz_1 = _take(_vz_0, _rows44)
        _when_1 = _take(_when_0, _rows44)
        _which_1 = _take(_which_0, _rows44)
        _x_1 = _take(_x_0, _rows44)
        _y_1 = _take(_y_0, _rows44)
        _z_1 = _take(_z_0, _rows44)
        _room_1 = room(_count45)
        _until_1, *_ = horizon(_when_1, _speed_1, _p_gravity_1)
        _low0_1, _high0_1, _low1_1, _high1_1, _ceiling_1, _latest_1, *_ = bridge_prepare(_until_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, 0.0, 0.0, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _p_gravity_1, _room_1)
        _share_1, _arrival_1, _certain_1 = beginning()
        _position_level_1, _velocity_level_1, *_ = allowance(_share_1, _latest_1, _extent_1, _speed_1, 0.0, 0.0, _p_gravity_1, _room_1)
        _flat_1, _tilt_1, _rate_slack_1 = bridge_margins(_latest_1, _extent_1, _speed_1, _position_level_1, _velocity_level_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _p_gravity_1, _room_1)
        _t_1, _end_1, _searching_1 = bridge_enter(0.0, 0.0, _high0_1, _high1_1, _low0_1, _low1_1, 0.0)
        _rows46, _count47 = _rows(_searching_1, _count45)
        if _count47:
            _arrival_2 = _take(_arrival_1, _rows46)
            _ceiling_2 = _take(_ceiling_1, _rows46)
            _certain_2 = _take(_certain_1, _rows46)
            _end_2 = _take(_end_1, _rows46)
            _extent_2 = _take(_extent_1, _rows46)
            _flat_2 = _take(_flat_1, _rows46)
            _high0_2 = _take(_high0_1, _rows46)
            _high1_2 = _take(_high1_1, _rows46)
            _last_2 = _take(_last_1, _rows46)
            _latest_2 = _take(_latest_1, _rows46)
            _low0_2 = _take(_low0_1, _rows46)
            _low1_2 = _take(_low1_1, _rows46)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows46)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows46)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows46)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows46)
            _p_gravity_2 = _take(_p_gravity_1, _rows46)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows46)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows46)
            _rate_slack_2 = _take(_rate_slack_1, _rows46)
            _share_2 = _take(_share_1, _rows46)
            _speed_2 = _take(_speed_1, _rows46)
            _t_2 = _take(_t_1, _rows46)
            _tilt_2 = _take(_tilt_1, _rows46)
            _vx_2 = _take(_vx_1, _rows46)
            _vy_2 = _take(_vy_1, _rows46)
            _vz_2 = _take(_vz_1, _rows46)
            _x_2 = _take(_x_1, _rows46)
            _y_2 = _take(_y_1, _rows46)
            _z_2 = _take(_z_1, _rows46)
            _room_2 = room(_count47)
            _leaving_2, _margin_2 = nearby(_flat_2, 2.0, _last_2, _t_2, _tilt_2)
            _gap_2, _rate_2, _bend_2, _step_2, _next_2, _clearance_2 = bridge_advance(_t_2, _end_2, _leaving_2, _margin_2, _rate_slack_2, _ceiling_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _p_gravity_2, _room_2)
            _hit_2, _sure_2, _vague_2 = struck_or_still(_bend_2, _clearance_2, _end_2, _gap_2, _margin_2, _next_2, _rate_2, _rate_slack_2, _share_2, _t_2)
            _rows48, _count49 = _rows(_vague_2, _count47)
            if _count49:
                _extent_3 = _take(_extent_2, _rows48)
                _latest_3 = _take(_latest_2, _rows48)
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows48)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows48)
                _p_bridge_depth_3 = _take(_p_bridge_depth_2, _rows48)
                _p_bridge_half_width_3 = _take(_p_bridge_half_width_2, _rows48)
                _p_gravity_3 = _take(_p_gravity_2, _rows48)
                _p_ring_radius_3 = _take(_p_ring_radius_2, _rows48)
                _p_wire_radius_3 = _take(_p_wire_radius_2, _rows48)
                _share_3 = _take(_share_2, _rows48)
                _speed_3 = _take(_speed_2, _rows48)
                _room_3 = room(_count49)
                _share_3, = finer(_share_3)
                _position_level_3, _velocity_level_3, *_ = allowance(_share_3, _latest_3, _extent_3, _speed_3, 0.0, 0.0, _p_gravity_3, _room_3)
                _flat_3, _tilt_3, _rate_slack_3 = bridge_margins(_latest_3, _extent_3, _speed_3, _position_level_3, _velocity_level_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_board_distance_3, _p_bridge_half_width_3, _p_bridge_depth_3, _p_gravity_3, _room_3)
                _flat_2 = _put(_flat_2, _rows48, _flat_3, _count47)
                _rate_slack_2 = _put(_rate_slack_2, _rows48, _rate_slack_3, _count47)
                _share_2 = _put(_share_2, _rows48, _share_3, _count47)
                _tilt_2 = _put(_tilt_2, _rows48, _tilt_3, _count47)
            _arrival_2, _certain_2, _exhausted_2, _searching_2, _t_2 = advanced(_arrival_2, _certain_2, _end_2, _hit_2, _next_2, _step_2, _sure_2, _t_2, _vague_2)
            _t_3, _end_3, _searching_3 = bridge_enter(_end_2, _end_2, _high0_2, _high1_2, _low0_2, _low1_2, _t_2)
            _end_2 = _choose(_exhausted_2, _end_3, _end_2)
            _searching_2 = _choose(_exhausted_2, _searching_3, _searching_2)
            _t_2 = _choose(_exhausted_2, _t_3, _t_2)
            _arrival_1 = _put(_arrival_1, _rows46, _arrival_2, _count45)
            _certain_1 = _put(_certain_1, _rows46, _certain_2, _count45)
            _end_1 = _put(_end_1, _rows46, _end_2, _count45)
            _flat_1 = _put(_flat_1, _rows46, _flat_2, _count45)
            _rate_slack_1 = _put(_rate_slack_1, _rows46, _rate_slack_2, _count45)
            _searching_1 = _put(_searching_1, _rows46, _searching_2, _count45)
            _share_1 = _put(_share_1, _rows46, _share_2, _count45)
            _t_1 = _put(_t_1, _rows46, _t_2, _count45)
            _tilt_1 = _put(_tilt_1, _rows46, _tilt_2, _count45)
        _rows50, _count51 = _rows(_searching_1, _count45)
        if _count51:
            _arrival_2 = _take(_arrival_1, _rows50)
            _ceiling_2 = _take(_ceiling_1, _rows50)
            _certain_2 = _take(_certain_1, _rows50)
            _end_2 = _take(_end_1, _rows50)
            _flat_2 = _take(_flat_1, _rows50)
            _last_2 = _take(_last_1, _rows50)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows50)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows50)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows50)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows50)
            _p_gravity_2 = _take(_p_gravity_1, _rows50)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows50)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows50)
            _rate_slack_2 = _take(_rate_slack_1, _rows50)
            _searching_2 = _take(_searching_1, _rows50)
            _share_2 = _take(_share_1, _rows50)
            _t_2 = _take(_t_1, _rows50)
            _tilt_2 = _take(_tilt_1, _rows50)
            _vx_2 = _take(_vx_1, _rows50)
            _vy_2 = _take(_vy_1, _rows50)
            _vz_2 = _take(_vz_1, _rows50)
            _x_2 = _take(_x_1, _rows50)
            _y_2 = _take(_y_1, _rows50)
            _z_2 = _take(_z_1, _rows50)
            _arrival_1 = _copy(_arrival_1, _count45)
            _certain_1 = _copy(_certain_1, _count45)
            _flat_1 = _copy(_flat_1, _count45)
            _tilt_1 = _copy(_tilt_1, _count45)
            for _ in range(201):
                _room_2 = room(_count51)
                _leaving_2, _margin_2 = nearby(_flat_2, 2.0, _last_2, _t_2, _tilt_2)
                _gap_2, _rate_2, _bend_2, _step_2, _next_2, _clearance_2 = bridge_advance(_t_2, _end_2, _leaving_2, _margin_2, _rate_slack_2, _ceiling_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _p_gravity_2, _room_2)
                _hit_2, _sure_2, _vague_2 = struck_or_still(_bend_2, _clearance_2, _end_2, _gap_2, _margin_2, _next_2, _rate_2, _rate_slack_2, _share_2, _t_2)
                _rows52, _count53 = _rows(_vague_2, _count51)
                if _count53:
                    _far = _of(_rows50, _rows52)
                    _extent_3 = _take(_extent_1, _far)
                    _latest_3 = _take(_latest_1, _far)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows52)
                    _p_board_distance_3 = _take(_p_board_distance_2, _rows52)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_2, _rows52)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_2, _rows52)
                    _p_gravity_3 = _take(_p_gravity_2, _rows52)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows52)
                    _p_wire_radius_3 = _take(_p_wire_radius_2, _rows52)
                    _share_3 = _take(_share_2, _rows52)
                    _speed_3 = _take(_speed_1, _far)
                    _room_3 = room(_count53)
                    _share_3, = finer(_share_3)
                    _position_level_3, _velocity_level_3, *_ = allowance(_share_3, _latest_3, _extent_3, _speed_3, 0.0, 0.0, _p_gravity_3, _room_3)
                    _flat_3, _tilt_3, _rate_slack_3 = bridge_margins(_latest_3, _extent_3, _speed_3, _position_level_3, _velocity_level_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_board_distance_3, _p_bridge_half_width_3, _p_bridge_depth_3, _p_gravity_3, _room_3)
                    _flat_2 = _put(_flat_2, _rows52, _flat_3, _count51)
                    _rate_slack_2 = _put(_rate_slack_2, _rows52, _rate_slack_3, _count51)
                    _share_2 = _put(_share_2, _rows52, _share_3, _count51)
                    _tilt_2 = _put(_tilt_2, _rows52, _tilt_3, _count51)
                _arrival_2, _certain_2, _exhausted_2, _searching_2, _t_2 = advanced(_arrival_2, _certain_2, _end_2, _hit_2, _next_2, _step_2, _sure_2, _t_2, _vague_2)
                _rows54, _count55 = _rows(_exhausted_2, _count51)
                if _count55:
                    _far = _of(_rows50, _rows54)
                    _end_3 = _take(_end_2, _rows54)
                    _high0_3 = _take(_high0_1, _far)
                    _high1_3 = _take(_high1_1, _far)
                    _low0_3 = _take(_low0_1, _far)
                    _low1_3 = _take(_low1_1, _far)
                    _t_3 = _take(_t_2, _rows54)
                    _t_3, _end_3, _searching_3 = bridge_enter(_end_3, _end_3, _high0_3, _high1_3, _low0_3, _low1_3, _t_3)
                    _end_2 = _put(_end_2, _rows54, _end_3, _count51)
                    _searching_2 = _put(_searching_2, _rows54, _searching_3, _count51)
                    _t_2 = _put(_t_2, _rows54, _t_3, _count51)
                _going56 = _where_true(_searching_2)
                if len(_going56) == _count51:
                    continue
                _done = _where_true(_logical_not(_searching_2))
                _store(_arrival_1, _of(_rows50, _done), _arrival_2, _done)
                _store(_certain_1, _of(_rows50, _done), _certain_2, _done)
                _store(_flat_1, _of(_rows50, _done), _flat_2, _done)
                _store(_tilt_1, _of(_rows50, _done), _tilt_2, _done)
                _rows50, _count51 = _of(_rows50, _going56), len(_going56)
                if not _count51:
                    break
                _arrival_2 = _take(_arrival_2, _going56)
                _ceiling_2 = _take(_ceiling_2, _going56)
                _certain_2 = _take(_certain_2, _going56)
                _end_2 = _take(_end_2, _going56)
                _flat_2 = _take(_flat_2, _going56)
                _last_2 = _take(_last_2, _going56)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going56)
                _p_board_distance_2 = _take(_p_board_distance_2, _going56)
                _p_bridge_depth_2 = _take(_p_bridge_depth_2, _going56)
                _p_bridge_half_width_2 = _take(_p_bridge_half_width_2, _going56)
                _p_gravity_2 = _take(_p_gravity_2, _going56)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going56)
                _p_wire_radius_2 = _take(_p_wire_radius_2, _going56)
                _rate_slack_2 = _take(_rate_slack_2, _going56)
                _searching_2 = _take(_searching_2, _going56)
                _share_2 = _take(_share_2, _going56)
                _t_2 = _take(_t_2, _going56)
                _tilt_2 = _take(_tilt_2, _going56)
                _vx_2 = _take(_vx_2, _going56)
                _vy_2 = _take(_vy_2, _going56)
                _vz_2 = _take(_vz_2, _going56)
                _x_2 = _take(_x_2, _going56)
                _y_2 = _take(_y_2, _going56)
                _z_2 = _take(_z_2, _going56)
            else:
                _store(_arrival_1, _rows50, _arrival_2, None)
                _store(_certain_1, _rows50, _certain_2, None)
                _store(_flat_1, _rows50, _flat_2, None)
                _store(_tilt_1, _rows50, _tilt_2, None)
        _arrives_1, _refining_1, *_ = found(_arrival_1)
        _leaving_1, *_ = nearby(_flat_1, 2.0, _last_1, _arrival_1, _tilt_1)
        _rows57, _count58 = _rows(_refining_1, _count45)
        if _count58:
            _arrival_2 = _take(_arrival_1, _rows57)
            _ceiling_2 = _take(_ceiling_1, _rows57)
            _certain_2 = _take(_certain_1, _rows57)
            _leaving_2 = _take(_leaving_1, _rows57)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows57)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows57)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows57)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows57)
            _p_gravity_2 = _take(_p_gravity_1, _rows57)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows57)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows57)
            _vx_2 = _take(_vx_1, _rows57)
            _vy_2 = _take(_vy_1, _rows57)
            _vz_2 = _take(_vz_1, _rows57)
            _x_2 = _take(_x_1, _rows57)
            _y_2 = _take(_y_1, _rows57)
            _z_2 = _take(_z_1, _rows57)
            _room_2 = room(_count58)
            _refined_2, _gap_2, _rate_2 = bridge_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
            _arrival_1 = _put(_arrival_1, _rows57, _arrival_2, _count45)
            _refining_1 = _put(_refining_1, _rows57, _refining_2, _count45)
        _rows59, _count60 = _rows(_refining_1, _count45)
        if _count60:
            _arrival_2 = _take(_arrival_1, _rows59)
            _ceiling_2 = _take(_ceiling_1, _rows59)
            _certain_2 = _take(_certain_1, _rows59)
            _leaving_2 = _take(_leaving_1, _rows59)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows59)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows59)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows59)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows59)
            _p_gravity_2 = _take(_p_gravity_1, _rows59)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows59)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows59)
            _vx_2 = _take(_vx_1, _rows59)
            _vy_2 = _take(_vy_1, _rows59)
            _vz_2 = _take(_vz_1, _rows59)
            _x_2 = _take(_x_1, _rows59)
            _y_2 = _take(_y_1, _rows59)
            _z_2 = _take(_z_1, _rows59)
            _room_2 = room(_count60)
            _refined_2, _gap_2, _rate_2 = bridge_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
            _arrival_1 = _put(_arrival_1, _rows59, _arrival_2, _count45)
            _refining_1 = _put(_refining_1, _rows59, _refining_2, _count45)
        _rows61, _count62 = _rows(_refining_1, _count45)
        if _count62:
            _arrival_2 = _take(_arrival_1, _rows61)
            _ceiling_2 = _take(_ceiling_1, _rows61)
            _certain_2 = _take(_certain_1, _rows61)
            _leaving_2 = _take(_leaving_1, _rows61)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows61)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows61)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows61)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows61)
            _p_gravity_2 = _take(_p_gravity_1, _rows61)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows61)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows61)
            _refining_2 = _take(_refining_1, _rows61)
            _vx_2 = _take(_vx_1, _rows61)
            _vy_2 = _take(_vy_1, _rows61)
            _vz_2 = _take(_vz_1, _rows61)
            _x_2 = _take(_x_1, _rows61)
            _y_2 = _take(_y_1, _rows61)
            _z_2 = _take(_z_1, _rows61)
            _arrival_1 = _copy(_arrival_1, _count45)
            for _ in range(8):
                _room_2 = room(_count62)
                _refined_2, _gap_2, _rate_2 = bridge_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _p_gravity_2, _room_2)
                _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
                _going63 = _where_true(_refining_2)
                if len(_going63) == _count62:
                    continue
                _done = _where_true(_logical_not(_refining_2))
                _store(_arrival_1, _of(_rows61, _done), _arrival_2, _done)
                _rows61, _count62 = _of(_rows61, _going63), len(_going63)
                if not _count62:
                    break
                _arrival_2 = _take(_arrival_2, _going63)
                _ceiling_2 = _take(_ceiling_2, _going63)
                _certain_2 = _take(_certain_2, _going63)
                _leaving_2 = _take(_leaving_2, _going63)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going63)
                _p_board_distance_2 = _take(_p_board_distance_2, _going63)
                _p_bridge_depth_2 = _take(_p_bridge_depth_2, _going63)
                _p_bridge_half_width_2 = _take(_p_bridge_half_width_2, _going63)
                _p_gravity_2 = _take(_p_gravity_2, _going63)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going63)
                _p_wire_radius_2 = _take(_p_wire_radius_2, _going63)
                _refining_2 = _take(_refining_2, _going63)
                _vx_2 = _take(_vx_2, _going63)
                _vy_2 = _take(_vy_2, _going63)
                _vz_2 = _take(_vz_2, _going63)
                _x_2 = _take(_x_2, _going63)
                _y_2 = _take(_y_2, _going63)
                _z_2 = _take(_z_2, _going63)
            else:
                _store(_arrival_1, _rows61, _arrival_2, None)
        _time_1, = landed(_arrival_1)
        _when_1, _which_1 = sooner(_arrives_1, 2.0, _time_1, _when_1, _which_1)
        _when_0 = _put(_when_0, _rows44, _when_1, shots)
        _which_0 = _put(_which_0, _rows44, _which_1, shots)
    _rows64, _count65 = _rows(_limited_0, shots)
    if _count65:
        _clock_1 = _take(_clock_0, _rows64)
        _time_error_1 = _take(_time_error_0, _rows64)
        _time_limit_1 = _take(_time_limit_0, _rows64)
        _when_1 = _take(_when_0, _rows64)
        _which_1 = _take(_which_0, _rows64)
        _time_1, _, _arrives_1, *_ = expiry(_clock_1, _inf, 0.0, _time_error_1, _time_limit_1, _when_1, _which_1)
        _when_1, _which_1 = sooner(_arrives_1, 4.0, _time_1, _when_1, _which_1)
        _when_0 = _put(_when_0, _rows64, _when_1, shots)
        _which_0 = _put(_which_0, _rows64, _which_1, shots)
    _rows66, _count67 = _rows(_kept_0, shots)
    if _count67:
        _circled_1 = _take(_circled_0, _rows66)
        _clock_1 = _take(_clock_0, _rows66)
        _held_1 = _take(_held_0, _rows66)
        _mode_1 = _take(_mode_0, _rows66)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows66)
        _p_board_bottom_1 = _take(_p_board_bottom_0, _rows66)
        _p_board_distance_1 = _take(_p_board_distance_0, _rows66)
        _p_board_half_width_1 = _take(_p_board_half_width_0, _rows66)
        _p_board_thickness_1 = _take(_p_board_thickness_0, _rows66)
        _p_board_top_1 = _take(_p_board_top_0, _rows66)
        _p_bridge_depth_1 = _take(_p_bridge_depth_0, _rows66)
        _p_bridge_half_width_1 = _take(_p_bridge_half_width_0, _rows66)
        _p_end_depth_1 = _take(_p_end_depth_0, _rows66)
        _p_gravity_1 = _take(_p_gravity_0, _rows66)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows66)
        _p_wire_radius_1 = _take(_p_wire_radius_0, _rows66)
        _rests_1 = _take(_rests_0, _rows66)
        _through_1 = _take(_through_0, _rows66)
        _time_limit_1 = _take(_time_limit_0, _rows66)
        _vx_1 = _take(_vx_0, _rows66)
        _vy_1 = _take(_vy_0, _rows66)
        _vz_1 = _take(_vz_0, _rows66)
        _when_1 = _take(_when_0, _rows66)
        _wx_1 = _take(_wx_0, _rows66)
        _wy_1 = _take(_wy_0, _rows66)
        _wz_1 = _take(_wz_0, _rows66)
        _x_1 = _take(_x_0, _rows66)
        _y_1 = _take(_y_0, _rows66)
        _z_1 = _take(_z_0, _rows66)
        _which_1, _, _began_1, _, _begins_1, _rolling_1, _leaves_1, _nx_1, _ny_1, _nz_1, _gap_1, _bent_x_1, _bent_y_1, _bent_z_1, _lift_1, _surge_1, _snap_1, _per_reach_1 = resumed(_clock_1, _mode_1, 0.0, 0.0)
        _rows68, _count69 = _rows(_begins_1, _count67)
        if _count69:
            _gap_2 = _take(_gap_1, _rows68)
            _held_2 = _take(_held_1, _rows68)
            _nx_2 = _take(_nx_1, _rows68)
            _ny_2 = _take(_ny_1, _rows68)
            _nz_2 = _take(_nz_1, _rows68)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows68)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows68)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows68)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows68)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows68)
            _p_board_top_2 = _take(_p_board_top_1, _rows68)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows68)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows68)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows68)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows68)
            _vx_2 = _take(_vx_1, _rows68)
            _vy_2 = _take(_vy_1, _rows68)
            _vz_2 = _take(_vz_1, _rows68)
            _wx_2 = _take(_wx_1, _rows68)
            _wy_2 = _take(_wy_1, _rows68)
            _wz_2 = _take(_wz_1, _rows68)
            _x_2 = _take(_x_1, _rows68)
            _y_2 = _take(_y_1, _rows68)
            _z_2 = _take(_z_1, _rows68)
            _room_2 = room(_count69)
            _here_2, = holding(_held_2, 0.0)
            _nx_3, _ny_3, _nz_3 = ring_normal(_x_2, _y_2, _z_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _room_2)
            _nx_2 = _choose(_here_2, _nx_3, _nx_2)
            _ny_2 = _choose(_here_2, _ny_3, _ny_2)
            _nz_2 = _choose(_here_2, _nz_3, _nz_2)
            _here_2, = holding(_held_2, 1.0)
            _nx_3, _ny_3, _nz_3 = backboard_normal(_x_2, _y_2, _z_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _room_2)
            _nx_2 = _choose(_here_2, _nx_3, _nx_2)
            _ny_2 = _choose(_here_2, _ny_3, _ny_2)
            _nz_2 = _choose(_here_2, _nz_3, _nz_2)
            _here_2, = holding(_held_2, 2.0)
            _nx_3, _ny_3, _nz_3 = bridge_normal(_x_2, _y_2, _z_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _room_2)
            _nx_2 = _choose(_here_2, _nx_3, _nx_2)
            _ny_2 = _choose(_here_2, _ny_3, _ny_2)
            _nz_2 = _choose(_here_2, _nz_3, _nz_2)
            _turn_rate_2, = roll_turn_rate(_p_ball_radius_2, _nx_2, _ny_2, _nz_2, _wx_2, _wy_2, _wz_2)
            _rolled_x_2, _rolled_y_2, _rolled_z_2, *_ = gripped(_p_ball_radius_2, _nx_2, _ny_2, _nz_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _room_2)
            _here_2, = holding(_held_2, 0.0)
            _gap_3, = ring_off(_p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _gap_2 = _choose(_here_2, _gap_3, _gap_2)
            _here_2, = holding(_held_2, 1.0)
            _gap_3, = backboard_off(_p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _x_2, _y_2, _z_2, _room_2)
            _gap_2 = _choose(_here_2, _gap_3, _gap_2)
            _here_2, = holding(_held_2, 2.0)
            _gap_3, = bridge_off(_p_ball_radius_2, _p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _p_ring_radius_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _gap_2 = _choose(_here_2, _gap_3, _gap_2)
            _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = roll_placed(_p_ball_radius_2, _gap_2, _nx_2, _ny_2, _nz_2, _turn_rate_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _x_2, _y_2, _z_2, _room_2)
            _which_2, _circled_2 = beginning_contact()
            _circled_1 = _put(_circled_1, _rows68, _circled_2, _count67)
            _nx_1 = _put(_nx_1, _rows68, _nx_2, _count67)
            _ny_1 = _put(_ny_1, _rows68, _ny_2, _count67)
            _nz_1 = _put(_nz_1, _rows68, _nz_2, _count67)
            _vx_1 = _put(_vx_1, _rows68, _vx_2, _count67)
            _vy_1 = _put(_vy_1, _rows68, _vy_2, _count67)
            _vz_1 = _put(_vz_1, _rows68, _vz_2, _count67)
            _which_1 = _put(_which_1, _rows68, _which_2, _count67)
            _wx_1 = _put(_wx_1, _rows68, _wx_2, _count67)
            _wy_1 = _put(_wy_1, _rows68, _wy_2, _count67)
            _wz_1 = _put(_wz_1, _rows68, _wz_2, _count67)
            _x_1 = _put(_x_1, _rows68, _x_2, _count67)
            _y_1 = _put(_y_1, _rows68, _y_2, _count67)
            _z_1 = _put(_z_1, _rows68, _z_2, _count67)
        _circling_1, _rolling_1 = circles(_held_1, 0.0, _rolling_1)
        _rows70, _count71 = _rows(_rolling_1, _count67)
        if _count71:
            _bent_x_2 = _take(_bent_x_1, _rows70)
            _bent_y_2 = _take(_bent_y_1, _rows70)
            _bent_z_2 = _take(_bent_z_1, _rows70)
            _clock_2 = _take(_clock_1, _rows70)
            _held_2 = _take(_held_1, _rows70)
            _nx_2 = _take(_nx_1, _rows70)
            _ny_2 = _take(_ny_1, _rows70)
            _nz_2 = _take(_nz_1, _rows70)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows70)
            _p_end_depth_2 = _take(_p_end_depth_1, _rows70)
            _p_gravity_2 = _take(_p_gravity_1, _rows70)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows70)
            _per_reach_2 = _take(_per_reach_1, _rows70)
            _rolling_2 = _take(_rolling_1, _rows70)
            _through_2 = _take(_through_1, _rows70)
            _time_limit_2 = _take(_time_limit_1, _rows70)
            _vx_2 = _take(_vx_1, _rows70)
            _vy_2 = _take(_vy_1, _rows70)
            _vz_2 = _take(_vz_1, _rows70)
            _which_2 = _take(_which_1, _rows70)
            _wx_2 = _take(_wx_1, _rows70)
            _wy_2 = _take(_wy_1, _rows70)
            _wz_2 = _take(_wz_1, _rows70)
            _x_2 = _take(_x_1, _rows70)
            _y_2 = _take(_y_1, _rows70)
            _z_2 = _take(_z_1, _rows70)
            _clock_1 = _copy(_clock_1, _count67)
            _per_reach_1 = _copy(_per_reach_1, _count67)
            _rests_1 = _copy(_rests_1, _count67)
            _rolling_1 = _copy(_rolling_1, _count67)
            _through_1 = _copy(_through_1, _count67)
            _vx_1 = _copy(_vx_1, _count67)
            _vy_1 = _copy(_vy_1, _count67)
            _vz_1 = _copy(_vz_1, _count67)
            _which_1 = _copy(_which_1, _count67)
            _wx_1 = _copy(_wx_1, _count67)
            _wy_1 = _copy(_wy_1, _count67)
            _wz_1 = _copy(_wz_1, _count67)
            _x_1 = _copy(_x_1, _count67)
            _y_1 = _copy(_y_1, _count67)
            _z_1 = _copy(_z_1, _count67)
            for _ in range(16):
                _room_2 = room(_count71)
                _here_2, = holding(_held_2, 1.0)
                _rows72, _count73 = _rows(_here_2, _count71)
                if _count73:
                    _far = _of(_rows70, _rows72)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows72)
                    _p_board_bottom_3 = _take(_p_board_bottom_1, _far)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_board_half_width_3 = _take(_p_board_half_width_1, _far)
                    _p_board_thickness_3 = _take(_p_board_thickness_1, _far)
                    _p_board_top_3 = _take(_p_board_top_1, _far)
                    _vx_3 = _take(_vx_2, _rows72)
                    _vy_3 = _take(_vy_2, _rows72)
                    _vz_3 = _take(_vz_2, _rows72)
                    _x_3 = _take(_x_2, _rows72)
                    _y_3 = _take(_y_2, _rows72)
                    _z_3 = _take(_z_2, _rows72)
                    _room_3 = room(_count73)
                    _nx_3, _ny_3, _nz_3 = backboard_normal(_x_3, _y_3, _z_3, _p_ball_radius_3, _p_board_distance_3, _p_board_half_width_3, _p_board_bottom_3, _p_board_top_3, _p_board_thickness_3, _room_3)
                    _bent_x_3, _bent_y_3, _bent_z_3, _per_reach_3 = backboard_tube(_p_ball_radius_3, _p_board_bottom_3, _p_board_distance_3, _p_board_half_width_3, _p_board_thickness_3, _p_board_top_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3, _room_3)
                    _bent_x_2 = _put(_bent_x_2, _rows72, _bent_x_3, _count71)
                    _bent_y_2 = _put(_bent_y_2, _rows72, _bent_y_3, _count71)
                    _bent_z_2 = _put(_bent_z_2, _rows72, _bent_z_3, _count71)
                    _nx_2 = _put(_nx_2, _rows72, _nx_3, _count71)
                    _ny_2 = _put(_ny_2, _rows72, _ny_3, _count71)
                    _nz_2 = _put(_nz_2, _rows72, _nz_3, _count71)
                    _per_reach_2 = _put(_per_reach_2, _rows72, _per_reach_3, _count71)
                _here_2, = holding(_held_2, 2.0)
                _rows74, _count75 = _rows(_here_2, _count71)
                if _count75:
                    _far = _of(_rows70, _rows74)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows74)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_1, _far)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_1, _far)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows74)
                    _p_wire_radius_3 = _take(_p_wire_radius_1, _far)
                    _vx_3 = _take(_vx_2, _rows74)
                    _vy_3 = _take(_vy_2, _rows74)
                    _vz_3 = _take(_vz_2, _rows74)
                    _x_3 = _take(_x_2, _rows74)
                    _y_3 = _take(_y_2, _rows74)
                    _z_3 = _take(_z_2, _rows74)
                    _room_3 = room(_count75)
                    _nx_3, _ny_3, _nz_3 = bridge_normal(_x_3, _y_3, _z_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_board_distance_3, _p_bridge_half_width_3, _p_bridge_depth_3, _room_3)
                    _bent_x_3, _bent_y_3, _bent_z_3, _per_reach_3 = bridge_tube(_p_ball_radius_3, _p_board_distance_3, _p_bridge_depth_3, _p_bridge_half_width_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                    _bent_x_2 = _put(_bent_x_2, _rows74, _bent_x_3, _count71)
                    _bent_y_2 = _put(_bent_y_2, _rows74, _bent_y_3, _count71)
                    _bent_z_2 = _put(_bent_z_2, _rows74, _bent_z_3, _count71)
                    _nx_2 = _put(_nx_2, _rows74, _nx_3, _count71)
                    _ny_2 = _put(_ny_2, _rows74, _ny_3, _count71)
                    _nz_2 = _put(_nz_2, _rows74, _nz_3, _count71)
                    _per_reach_2 = _put(_per_reach_2, _rows74, _per_reach_3, _count71)
                _vx_0_2, _vy_0_2, _vz_0_2, _nx_0_2, _ny_0_2, _nz_0_2, _turn_rate_0_2 = roll_start(_p_ball_radius_2, _nx_2, _ny_2, _nz_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2)
                _lift_0_2, _tx_0_2, _ty_0_2, _tz_0_2, _vx_1_2, _vy_1_2, _vz_1_2, _nx_1_2, _ny_1_2, _nz_1_2, _turn_rate_1_2 = roll_0(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _nx_0_2, _ny_0_2, _nz_0_2, _per_reach_2, _turn_rate_0_2, _vx_0_2, _vy_0_2, _vz_0_2, _room_2)
                _lift_1_2, _tx_1_2, _ty_1_2, _tz_1_2, _vx_2_2, _vy_2_2, _vz_2_2, _nx_2_2, _ny_2_2, _nz_2_2, _turn_rate_2_2 = roll_1(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _nx_0_2, _nx_1_2, _ny_0_2, _ny_1_2, _nz_0_2, _nz_1_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _tx_0_2, _ty_0_2, _tz_0_2, _vx_0_2, _vx_1_2, _vy_0_2, _vy_1_2, _vz_0_2, _vz_1_2, _room_2)
                _lift_2_2, _tx_2_2, _ty_2_2, _tz_2_2, _vx_3_2, _vy_3_2, _vz_3_2, _nx_3_2, _ny_3_2, _nz_3_2, _turn_rate_3_2 = roll_2(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _nx_0_2, _nx_1_2, _nx_2_2, _ny_0_2, _ny_1_2, _ny_2_2, _nz_0_2, _nz_1_2, _nz_2_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _tx_0_2, _tx_1_2, _ty_0_2, _ty_1_2, _tz_0_2, _tz_1_2, _vx_0_2, _vx_1_2, _vx_2_2, _vy_0_2, _vy_1_2, _vy_2_2, _vz_0_2, _vz_1_2, _vz_2_2, _room_2)
                _lift_3_2, _tx_3_2, _ty_3_2, _tz_3_2, _vx_4_2, _vy_4_2, _vz_4_2, _nx_4_2, _ny_4_2, _nz_4_2, _turn_rate_4_2 = roll_3(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _tx_0_2, _tx_1_2, _tx_2_2, _ty_0_2, _ty_1_2, _ty_2_2, _tz_0_2, _tz_1_2, _tz_2_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _room_2)
                _lift_4_2, _tx_4_2, _ty_4_2, _tz_4_2, _vx_5_2, _vy_5_2, _vz_5_2, _nx_5_2, _ny_5_2, _nz_5_2, _turn_rate_5_2 = roll_4(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _lift_3_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _nx_4_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _ny_4_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _nz_4_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _tx_0_2, _tx_1_2, _tx_2_2, _tx_3_2, _ty_0_2, _ty_1_2, _ty_2_2, _ty_3_2, _tz_0_2, _tz_1_2, _tz_2_2, _tz_3_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _room_2)
                _lift_5_2, _tx_5_2, _ty_5_2, _tz_5_2, _vx_6_2, _vy_6_2, _vz_6_2, _nx_6_2, _ny_6_2, _nz_6_2, _turn_rate_6_2 = roll_5(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _lift_3_2, _lift_4_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _nx_4_2, _nx_5_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _ny_4_2, _ny_5_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _nz_4_2, _nz_5_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _tx_0_2, _tx_1_2, _tx_2_2, _tx_3_2, _tx_4_2, _ty_0_2, _ty_1_2, _ty_2_2, _ty_3_2, _ty_4_2, _tz_0_2, _tz_1_2, _tz_2_2, _tz_3_2, _tz_4_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vx_5_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vy_5_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _vz_5_2, _room_2)
                _lift_6_2, _tx_6_2, _ty_6_2, _tz_6_2, _vx_7_2, _vy_7_2, _vz_7_2, _nx_7_2, _ny_7_2, _nz_7_2, _turn_rate_7_2 = roll_6(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _lift_3_2, _lift_4_2, _lift_5_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _nx_4_2, _nx_5_2, _nx_6_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _ny_4_2, _ny_5_2, _ny_6_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _nz_4_2, _nz_5_2, _nz_6_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _tx_0_2, _tx_1_2, _tx_2_2, _tx_3_2, _tx_4_2, _tx_5_2, _ty_0_2, _ty_1_2, _ty_2_2, _ty_3_2, _ty_4_2, _ty_5_2, _tz_0_2, _tz_1_2, _tz_2_2, _tz_3_2, _tz_4_2, _tz_5_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vx_5_2, _vx_6_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vy_5_2, _vy_6_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _vz_5_2, _vz_6_2, _room_2)
                _lift_7_2, _, _, _, _vx_8_2, _vy_8_2, _vz_8_2, _nx_8_2, _ny_8_2, _nz_8_2, _turn_rate_8_2 = roll_7(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _lift_3_2, _lift_4_2, _lift_5_2, _lift_6_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _nx_4_2, _nx_5_2, _nx_6_2, _nx_7_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _ny_4_2, _ny_5_2, _ny_6_2, _ny_7_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _nz_4_2, _nz_5_2, _nz_6_2, _nz_7_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _tx_0_2, _tx_1_2, _tx_2_2, _tx_3_2, _tx_4_2, _tx_5_2, _tx_6_2, _ty_0_2, _ty_1_2, _ty_2_2, _ty_3_2, _ty_4_2, _ty_5_2, _ty_6_2, _tz_0_2, _tz_1_2, _tz_2_2, _tz_3_2, _tz_4_2, _tz_5_2, _tz_6_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vx_5_2, _vx_6_2, _vx_7_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vy_5_2, _vy_6_2, _vy_7_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _vz_5_2, _vz_6_2, _vz_7_2, _room_2)
                _stride_2, _strongest_2, _fastest_2, _force_2, _force_rate_2, _force_bend_2, _brace_2 = roll_pace(_p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _lift_3_2, _lift_4_2, _lift_5_2, _lift_6_2, _lift_7_2, _nx_8_2, _ny_8_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _nz_4_2, _nz_5_2, _nz_6_2, _nz_7_2, _nz_8_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vx_5_2, _vx_6_2, _vx_7_2, _vx_8_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vy_5_2, _vy_6_2, _vy_7_2, _vy_8_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _vz_5_2, _vz_6_2, _vz_7_2, _vz_8_2, _room_2)
                _stride_2, _which_2, _rests_2, *_ = leaving_force(_p_ball_radius_2, _brace_2, _inf, _fastest_2, _force_2, _force_bend_2, _force_rate_2, _p_gravity_2, _per_reach_2, 0.0, _stride_2, 0.0, _vx_2, _vx_1_2, _vy_2, _vy_1_2, _vz_2, _vz_1_2, _which_2, _room_2)
                _beside_2, = beside(_held_2, 0.0)
                _rows76, _count77 = _rows(_beside_2, _count71)
                if _count77:
                    _far = _of(_rows70, _rows76)
                    _fastest_3 = _take(_fastest_2, _rows76)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows76)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows76)
                    _p_wire_radius_3 = _take(_p_wire_radius_1, _far)
                    _stride_3 = _take(_stride_2, _rows76)
                    _strongest_3 = _take(_strongest_2, _rows76)
                    _vx_3 = _take(_vx_2, _rows76)
                    _vy_3 = _take(_vy_2, _rows76)
                    _vz_3 = _take(_vz_2, _rows76)
                    _which_3 = _take(_which_2, _rows76)
                    _x_3 = _take(_x_2, _rows76)
                    _y_3 = _take(_y_2, _rows76)
                    _z_3 = _take(_z_2, _rows76)
                    _room_3 = room(_count77)
                    _gap_3, _nearing_3, _dent_3 = ring_beside(_p_ball_radius_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                    _stride_3, _which_3, *_ = beside_body(_p_ball_radius_3, _dent_3, _inf, _fastest_3, _gap_3, 0.0, 0.0, _nearing_3, 0.0, _stride_3, _strongest_3, _which_3, _x_3, _y_3, _z_3, _room_3)
                    _stride_2 = _put(_stride_2, _rows76, _stride_3, _count71)
                    _which_2 = _put(_which_2, _rows76, _which_3, _count71)
                _beside_2, = beside(_held_2, 1.0)
                _rows78, _count79 = _rows(_beside_2, _count71)
                if _count79:
                    _far = _of(_rows70, _rows78)
                    _fastest_3 = _take(_fastest_2, _rows78)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows78)
                    _p_board_bottom_3 = _take(_p_board_bottom_1, _far)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_board_half_width_3 = _take(_p_board_half_width_1, _far)
                    _p_board_thickness_3 = _take(_p_board_thickness_1, _far)
                    _p_board_top_3 = _take(_p_board_top_1, _far)
                    _stride_3 = _take(_stride_2, _rows78)
                    _strongest_3 = _take(_strongest_2, _rows78)
                    _vx_3 = _take(_vx_2, _rows78)
                    _vy_3 = _take(_vy_2, _rows78)
                    _vz_3 = _take(_vz_2, _rows78)
                    _which_3 = _take(_which_2, _rows78)
                    _x_3 = _take(_x_2, _rows78)
                    _y_3 = _take(_y_2, _rows78)
                    _z_3 = _take(_z_2, _rows78)
                    _room_3 = room(_count79)
                    _gap_3, _nearing_3, _dent_3 = backboard_beside(_p_ball_radius_3, _p_board_bottom_3, _p_board_distance_3, _p_board_half_width_3, _p_board_thickness_3, _p_board_top_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3, _room_3)
                    _stride_3, _which_3, *_ = beside_body(_p_ball_radius_3, _dent_3, _inf, _fastest_3, _gap_3, 1.0, 0.0, _nearing_3, 0.0, _stride_3, _strongest_3, _which_3, _x_3, _y_3, _z_3, _room_3)
                    _stride_2 = _put(_stride_2, _rows78, _stride_3, _count71)
                    _which_2 = _put(_which_2, _rows78, _which_3, _count71)
                _beside_2, = beside(_held_2, 2.0)
                _rows80, _count81 = _rows(_beside_2, _count71)
                if _count81:
                    _far = _of(_rows70, _rows80)
                    _fastest_3 = _take(_fastest_2, _rows80)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows80)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_1, _far)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_1, _far)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows80)
                    _p_wire_radius_3 = _take(_p_wire_radius_1, _far)
                    _stride_3 = _take(_stride_2, _rows80)
                    _strongest_3 = _take(_strongest_2, _rows80)
                    _vx_3 = _take(_vx_2, _rows80)
                    _vy_3 = _take(_vy_2, _rows80)
                    _vz_3 = _take(_vz_2, _rows80)
                    _which_3 = _take(_which_2, _rows80)
                    _x_3 = _take(_x_2, _rows80)
                    _y_3 = _take(_y_2, _rows80)
                    _z_3 = _take(_z_2, _rows80)
                    _room_3 = room(_count81)
                    _gap_3, _nearing_3, _dent_3 = bridge_beside(_p_ball_radius_3, _p_board_distance_3, _p_bridge_depth_3, _p_bridge_half_width_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                    _stride_3, _which_3, *_ = beside_body(_p_ball_radius_3, _dent_3, _inf, _fastest_3, _gap_3, 2.0, 0.0, _nearing_3, 0.0, _stride_3, _strongest_3, _which_3, _x_3, _y_3, _z_3, _room_3)
                    _stride_2 = _put(_stride_2, _rows80, _stride_3, _count71)
                    _which_2 = _put(_which_2, _rows80, _which_3, _count71)
                _gap_2, _nearing_2, _dent_2 = end_beside(_p_end_depth_2, _vz_2, _z_2)
                _stride_2, _which_2, *_ = beside_gate(_p_ball_radius_2, _dent_2, _inf, _fastest_2, _gap_2, 3.0, 0.0, _nearing_2, 0.0, _stride_2, _strongest_2, _which_2, _x_2, _y_2, _z_2, _room_2)
                _here_2, = holding(_held_2, 1.0)
                _rows82, _count83 = _rows(_here_2, _count71)
                if _count83:
                    _far = _of(_rows70, _rows82)
                    _fastest_3 = _take(_fastest_2, _rows82)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows82)
                    _p_board_bottom_3 = _take(_p_board_bottom_1, _far)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_board_half_width_3 = _take(_p_board_half_width_1, _far)
                    _p_board_thickness_3 = _take(_p_board_thickness_1, _far)
                    _p_board_top_3 = _take(_p_board_top_1, _far)
                    _stride_3 = _take(_stride_2, _rows82)
                    _strongest_3 = _take(_strongest_2, _rows82)
                    _vx_3 = _take(_vx_2, _rows82)
                    _vy_3 = _take(_vy_2, _rows82)
                    _vz_3 = _take(_vz_2, _rows82)
                    _x_3 = _take(_x_2, _rows82)
                    _y_3 = _take(_y_2, _rows82)
                    _z_3 = _take(_z_2, _rows82)
                    _room_3 = room(_count83)
                    _gap_3, _nearing_3, _near_3 = backboard_seam0(_p_ball_radius_3, _p_board_distance_3, _p_board_thickness_3, _vx_3, _x_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = backboard_seam1(_p_ball_radius_3, _p_board_distance_3, _p_board_thickness_3, _vx_3, _x_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = backboard_seam2(_p_ball_radius_3, _p_board_half_width_3, _vy_3, _y_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = backboard_seam3(_p_ball_radius_3, _p_board_half_width_3, _vy_3, _y_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = backboard_seam4(_p_ball_radius_3, _p_board_bottom_3, _p_board_top_3, _vz_3, _z_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = backboard_seam5(_p_ball_radius_3, _p_board_bottom_3, _p_board_top_3, _vz_3, _z_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_2 = _put(_gap_2, _rows82, _gap_3, _count71)
                    _stride_2 = _put(_stride_2, _rows82, _stride_3, _count71)
                _here_2, = holding(_held_2, 2.0)
                _rows84, _count85 = _rows(_here_2, _count71)
                if _count85:
                    _far = _of(_rows70, _rows84)
                    _fastest_3 = _take(_fastest_2, _rows84)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows84)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_1, _far)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_1, _far)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows84)
                    _p_wire_radius_3 = _take(_p_wire_radius_1, _far)
                    _stride_3 = _take(_stride_2, _rows84)
                    _strongest_3 = _take(_strongest_2, _rows84)
                    _vx_3 = _take(_vx_2, _rows84)
                    _vy_3 = _take(_vy_2, _rows84)
                    _vz_3 = _take(_vz_2, _rows84)
                    _x_3 = _take(_x_2, _rows84)
                    _y_3 = _take(_y_2, _rows84)
                    _z_3 = _take(_z_2, _rows84)
                    _room_3 = room(_count85)
                    _gap_3, _nearing_3, _near_3 = bridge_seam0(_p_ball_radius_3, _p_board_distance_3, _p_ring_radius_3, _vx_3, _x_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = bridge_seam1(_p_ball_radius_3, _p_board_distance_3, _p_ring_radius_3, _vx_3, _x_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = bridge_seam2(_p_ball_radius_3, _p_bridge_half_width_3, _vy_3, _y_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = bridge_seam3(_p_ball_radius_3, _p_bridge_half_width_3, _vy_3, _y_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = bridge_seam4(_p_ball_radius_3, _p_bridge_depth_3, _vz_3, _p_wire_radius_3, _z_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = bridge_seam5(_p_ball_radius_3, _p_bridge_depth_3, _vz_3, _p_wire_radius_3, _z_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_2 = _put(_gap_2, _rows84, _gap_3, _count71)
                    _stride_2 = _put(_stride_2, _rows84, _stride_3, _count71)
                _stride_2, _which_2 = beside_time(_clock_2, _stride_2, _time_limit_2, _which_2)
                _over_2, = passing_from(_z_2)
                _x_2, _vx_2, _y_2, _vy_2, _z_2, _vz_2, _turn_rate_2 = roll_moved(_stride_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vx_5_2, _vx_6_2, _vx_7_2, _vx_8_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vy_5_2, _vy_6_2, _vy_7_2, _vy_8_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _vz_5_2, _vz_6_2, _vz_7_2, _vz_8_2, _x_2, _y_2, _z_2, _room_2)
                _here_2, = holding(_held_2, 1.0)
                _rows86, _count87 = _rows(_here_2, _count71)
                if _count87:
                    _far = _of(_rows70, _rows86)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows86)
                    _p_board_bottom_3 = _take(_p_board_bottom_1, _far)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_board_half_width_3 = _take(_p_board_half_width_1, _far)
                    _p_board_thickness_3 = _take(_p_board_thickness_1, _far)
                    _p_board_top_3 = _take(_p_board_top_1, _far)
                    _x_3 = _take(_x_2, _rows86)
                    _y_3 = _take(_y_2, _rows86)
                    _z_3 = _take(_z_2, _rows86)
                    _room_3 = room(_count87)
                    _nx_3, _ny_3, _nz_3 = backboard_normal(_x_3, _y_3, _z_3, _p_ball_radius_3, _p_board_distance_3, _p_board_half_width_3, _p_board_bottom_3, _p_board_top_3, _p_board_thickness_3, _room_3)
                    _gap_3, = backboard_off(_p_ball_radius_3, _p_board_bottom_3, _p_board_distance_3, _p_board_half_width_3, _p_board_thickness_3, _p_board_top_3, _x_3, _y_3, _z_3, _room_3)
                    _gap_2 = _put(_gap_2, _rows86, _gap_3, _count71)
                    _nx_2 = _put(_nx_2, _rows86, _nx_3, _count71)
                    _ny_2 = _put(_ny_2, _rows86, _ny_3, _count71)
                    _nz_2 = _put(_nz_2, _rows86, _nz_3, _count71)
                _here_2, = holding(_held_2, 2.0)
                _rows88, _count89 = _rows(_here_2, _count71)
                if _count89:
                    _far = _of(_rows70, _rows88)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows88)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_1, _far)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_1, _far)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows88)
                    _p_wire_radius_3 = _take(_p_wire_radius_1, _far)
                    _x_3 = _take(_x_2, _rows88)
                    _y_3 = _take(_y_2, _rows88)
                    _z_3 = _take(_z_2, _rows88)
                    _room_3 = room(_count89)
                    _nx_3, _ny_3, _nz_3 = bridge_normal(_x_3, _y_3, _z_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_board_distance_3, _p_bridge_half_width_3, _p_bridge_depth_3, _room_3)
                    _gap_3, = bridge_off(_p_ball_radius_3, _p_board_distance_3, _p_bridge_depth_3, _p_bridge_half_width_3, _p_ring_radius_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                    _gap_2 = _put(_gap_2, _rows88, _gap_3, _count71)
                    _nx_2 = _put(_nx_2, _rows88, _nx_3, _count71)
                    _ny_2 = _put(_ny_2, _rows88, _ny_3, _count71)
                    _nz_2 = _put(_nz_2, _rows88, _nz_3, _count71)
                _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = roll_placed(_p_ball_radius_2, _gap_2, _nx_2, _ny_2, _nz_2, _turn_rate_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2, _room_2)
                _through_2, = passing_in_contact(_over_2, _p_ring_radius_2, _through_2, _x_2, _y_2, _z_2)
                _clock_2, _rolling_2 = rolled_on(_clock_2, _rests_2, _stride_2, _which_2)
                _going90 = _where_true(_rolling_2)
                if len(_going90) == _count71:
                    continue
                _done = _where_true(_logical_not(_rolling_2))
                _store(_clock_1, _of(_rows70, _done), _clock_2, _done)
                _store(_per_reach_1, _of(_rows70, _done), _per_reach_2, _done)
                _store(_rests_1, _of(_rows70, _done), _rests_2, _done)
                _store(_rolling_1, _of(_rows70, _done), _rolling_2, _done)
                _store(_through_1, _of(_rows70, _done), _through_2, _done)
                _store(_vx_1, _of(_rows70, _done), _vx_2, _done)
                _store(_vy_1, _of(_rows70, _done), _vy_2, _done)
                _store(_vz_1, _of(_rows70, _done), _vz_2, _done)
                _store(_which_1, _of(_rows70, _done), _which_2, _done)
                _store(_wx_1, _of(_rows70, _done), _wx_2, _done)
                _store(_wy_1, _of(_rows70, _done), _wy_2, _done)
                _store(_wz_1, _of(_rows70, _done), _wz_2, _done)
                _store(_x_1, _of(_rows70, _done), _x_2, _done)
                _store(_y_1, _of(_rows70, _done), _y_2, _done)
                _store(_z_1, _of(_rows70, _done), _z_2, _done)
                _rows70, _count71 = _of(_rows70, _going90), len(_going90)
                if not _count71:
                    break
                _bent_x_2 = _take(_bent_x_2, _going90)
                _bent_y_2 = _take(_bent_y_2, _going90)
                _bent_z_2 = _take(_bent_z_2, _going90)
                _clock_2 = _take(_clock_2, _going90)
                _held_2 = _take(_held_2, _going90)
                _nx_2 = _take(_nx_2, _going90)
                _ny_2 = _take(_ny_2, _going90)
                _nz_2 = _take(_nz_2, _going90)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going90)
                _p_end_depth_2 = _take(_p_end_depth_2, _going90)
                _p_gravity_2 = _take(_p_gravity_2, _going90)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going90)
                _per_reach_2 = _take(_per_reach_2, _going90)
                _rests_2 = _take(_rests_2, _going90)
                _rolling_2 = _take(_rolling_2, _going90)
                _through_2 = _take(_through_2, _going90)
                _time_limit_2 = _take(_time_limit_2, _going90)
                _vx_2 = _take(_vx_2, _going90)
                _vy_2 = _take(_vy_2, _going90)
                _vz_2 = _take(_vz_2, _going90)
                _which_2 = _take(_which_2, _going90)
                _wx_2 = _take(_wx_2, _going90)
                _wy_2 = _take(_wy_2, _going90)
                _wz_2 = _take(_wz_2, _going90)
                _x_2 = _take(_x_2, _going90)
                _y_2 = _take(_y_2, _going90)
                _z_2 = _take(_z_2, _going90)
            else:
                _store(_clock_1, _rows70, _clock_2, None)
                _store(_per_reach_1, _rows70, _per_reach_2, None)
                _store(_rests_1, _rows70, _rests_2, None)
                _store(_rolling_1, _rows70, _rolling_2, None)
                _store(_through_1, _rows70, _through_2, None)
                _store(_vx_1, _rows70, _vx_2, None)
                _store(_vy_1, _rows70, _vy_2, None)
                _store(_vz_1, _rows70, _vz_2, None)
                _store(_which_1, _rows70, _which_2, None)
                _store(_wx_1, _rows70, _wx_2, None)
                _store(_wy_1, _rows70, _wy_2, None)
                _store(_wz_1, _rows70, _wz_2, None)
                _store(_x_1, _rows70, _x_2, None)
                _store(_y_1, _rows70, _y_2, None)
                _store(_z_1, _rows70, _z_2, None)
        _rows91, _count92 = _rows(_circling_1, _count67)
        if _count92:
            _circled_2 = _take(_circled_1, _rows91)
            _circling_2 = _take(_circling_1, _rows91)
            _clock_2 = _take(_clock_1, _rows91)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows91)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows91)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows91)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows91)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows91)
            _p_board_top_2 = _take(_p_board_top_1, _rows91)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows91)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows91)
            _p_end_depth_2 = _take(_p_end_depth_1, _rows91)
            _p_gravity_2 = _take(_p_gravity_1, _rows91)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows91)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows91)
            _through_2 = _take(_through_1, _rows91)
            _time_limit_2 = _take(_time_limit_1, _rows91)
            _vx_2 = _take(_vx_1, _rows91)
            _vy_2 = _take(_vy_1, _rows91)
            _vz_2 = _take(_vz_1, _rows91)
            _which_2 = _take(_which_1, _rows91)
            _wx_2 = _take(_wx_1, _rows91)
            _wy_2 = _take(_wy_1, _rows91)
            _wz_2 = _take(_wz_1, _rows91)
            _x_2 = _take(_x_1, _rows91)
            _y_2 = _take(_y_1, _rows91)
            _z_2 = _take(_z_1, _rows91)
            _circled_1 = _copy(_circled_1, _count67)
            _circling_1 = _copy(_circling_1, _count67)
            _clock_1 = _copy(_clock_1, _count67)
            _per_reach_1 = _copy(_per_reach_1, _count67)
            _rests_1 = _copy(_rests_1, _count67)
            _through_1 = _copy(_through_1, _count67)
            _vx_1 = _copy(_vx_1, _count67)
            _vy_1 = _copy(_vy_1, _count67)
            _vz_1 = _copy(_vz_1, _count67)
            _which_1 = _copy(_which_1, _count67)
            _wx_1 = _copy(_wx_1, _count67)
            _wy_1 = _copy(_wy_1, _count67)
            _wz_1 = _copy(_wz_1, _count67)
            _x_1 = _copy(_x_1, _count67)
            _y_1 = _copy(_y_1, _count67)
            _z_1 = _copy(_z_1, _count67)
            for _ in range(16):
                _room_2 = room(_count92)
                _, _, _, _per_reach_2 = ring_tube(_p_ball_radius_2, _p_wire_radius_2)
                _cosine_0_2, _sine_0_2, _climb_0_2, _along_0_2, _turn_rate_0_2, _cos_0_2, _sin_0_2, _near_0_2 = ring_round_start(_p_ball_radius_2, _p_ring_radius_2, _vx_2, _vy_2, _vz_2, _p_wire_radius_2, _wx_2, _wy_2, _wz_2, _x_2, _y_2, _z_2, _room_2)
                _omega_0_2, _around_0_2, _tilted_0_2, _pressed_0_2, _force_0_2, _cosine_1_2, _sine_1_2, _climb_1_2, _along_1_2, _turn_rate_1_2, _cos_1_2, _sin_1_2 = ring_round_0(_along_0_2, _p_ball_radius_2, _climb_0_2, _cos_0_2, _cosine_0_2, _p_gravity_2, _near_0_2, _p_ring_radius_2, _sin_0_2, _sine_0_2, _turn_rate_0_2, _p_wire_radius_2, _room_2)
                _near_1_2, _omega_1_2, _around_1_2, _tilted_1_2, _pressed_1_2, _force_1_2, _cosine_2_2, _sine_2_2, _climb_2_2, _along_2_2, _turn_rate_2_2, _cos_2_2, _sin_2_2 = ring_round_1(_along_0_2, _along_1_2, _around_0_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _cos_0_2, _cos_1_2, _cosine_0_2, _cosine_1_2, _p_gravity_2, _near_0_2, _omega_0_2, _pressed_0_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sine_0_2, _sine_1_2, _tilted_0_2, _turn_rate_0_2, _turn_rate_1_2, _p_wire_radius_2, _room_2)
                _near_2_2, _omega_2_2, _around_2_2, _tilted_2_2, _pressed_2_2, _force_2_2, _cosine_3_2, _sine_3_2, _climb_3_2, _along_3_2, _turn_rate_3_2, _cos_3_2, _sin_3_2 = ring_round_2(_along_0_2, _along_1_2, _along_2_2, _around_0_2, _around_1_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _cos_0_2, _cos_1_2, _cos_2_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _p_gravity_2, _near_0_2, _near_1_2, _omega_0_2, _omega_1_2, _pressed_0_2, _pressed_1_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sine_0_2, _sine_1_2, _sine_2_2, _tilted_0_2, _tilted_1_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _p_wire_radius_2, _room_2)
                _near_3_2, _omega_3_2, _around_3_2, _tilted_3_2, _pressed_3_2, _force_3_2, _cosine_4_2, _sine_4_2, _climb_4_2, _along_4_2, _turn_rate_4_2, _cos_4_2, _sin_4_2 = ring_round_3(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _around_0_2, _around_1_2, _around_2_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _omega_0_2, _omega_1_2, _omega_2_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _p_wire_radius_2, _room_2)
                _near_4_2, _omega_4_2, _around_4_2, _tilted_4_2, _pressed_4_2, _force_4_2, _cosine_5_2, _sine_5_2, _climb_5_2, _along_5_2, _turn_rate_5_2, _cos_5_2, _sin_5_2 = ring_round_4(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _p_wire_radius_2, _room_2)
                _near_5_2, _omega_5_2, _around_5_2, _tilted_5_2, _pressed_5_2, _force_5_2, _cosine_6_2, _sine_6_2, _climb_6_2, _along_6_2, _turn_rate_6_2, _cos_6_2, _sin_6_2 = ring_round_5(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _p_wire_radius_2, _room_2)
                _near_6_2, _omega_6_2, _around_6_2, _tilted_6_2, _pressed_6_2, _force_6_2, _cosine_7_2, _sine_7_2, _climb_7_2, _along_7_2, _turn_rate_7_2, _cos_7_2, _sin_7_2 = ring_round_6(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _p_wire_radius_2, _room_2)
                _near_7_2, _omega_7_2, _around_7_2, _tilted_7_2, _pressed_7_2, _force_7_2, _cosine_8_2, _sine_8_2, _climb_8_2, _along_8_2, _turn_rate_8_2, _cos_8_2, _sin_8_2 = ring_round_7(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _p_wire_radius_2, _room_2)
                _near_8_2, _omega_8_2, _around_8_2, _tilted_8_2, _pressed_8_2, _force_8_2, _cosine_9_2, _sine_9_2, _climb_9_2, _along_9_2, _turn_rate_9_2, _cos_9_2, _sin_9_2 = ring_round_8(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _around_7_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _near_7_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _omega_7_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _pressed_7_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _tilted_7_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _p_wire_radius_2, _room_2)
                _near_9_2, _omega_9_2, _around_9_2, _tilted_9_2, _pressed_9_2, _force_9_2, _cosine_10_2, _sine_10_2, _climb_10_2, _along_10_2, _turn_rate_10_2, _cos_10_2, _sin_10_2 = ring_round_9(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _along_9_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _around_7_2, _around_8_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _climb_9_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cos_9_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _cosine_9_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _near_7_2, _near_8_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _omega_7_2, _omega_8_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _pressed_7_2, _pressed_8_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sin_9_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _sine_9_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _tilted_7_2, _tilted_8_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _turn_rate_9_2, _p_wire_radius_2, _room_2)
                _near_10_2, _omega_10_2, _around_10_2, _tilted_10_2, _pressed_10_2, _force_10_2, _cosine_11_2, _sine_11_2, _climb_11_2, _along_11_2, _turn_rate_11_2, _cos_11_2, _sin_11_2 = ring_round_10(_along_0_2, _along_1_2, _along_10_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _along_9_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _around_7_2, _around_8_2, _around_9_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_10_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _climb_9_2, _cos_0_2, _cos_1_2, _cos_10_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cos_9_2, _cosine_0_2, _cosine_1_2, _cosine_10_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _cosine_9_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _near_7_2, _near_8_2, _near_9_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _omega_7_2, _omega_8_2, _omega_9_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _pressed_7_2, _pressed_8_2, _pressed_9_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_10_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sin_9_2, _sine_0_2, _sine_1_2, _sine_10_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _sine_9_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _tilted_7_2, _tilted_8_2, _tilted_9_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_10_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _turn_rate_9_2, _p_wire_radius_2, _room_2)
                _, _, _, _, _, _force_11_2, _cosine_12_2, _sine_12_2, _climb_12_2, _along_12_2, _turn_rate_12_2, _cos_12_2, _sin_12_2 = ring_round_11(_along_0_2, _along_1_2, _along_10_2, _along_11_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _along_9_2, _around_0_2, _around_1_2, _around_10_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _around_7_2, _around_8_2, _around_9_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_10_2, _climb_11_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _climb_9_2, _cos_0_2, _cos_1_2, _cos_10_2, _cos_11_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cos_9_2, _cosine_0_2, _cosine_1_2, _cosine_10_2, _cosine_11_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _cosine_9_2, _p_gravity_2, _near_0_2, _near_1_2, _near_10_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _near_7_2, _near_8_2, _near_9_2, _omega_0_2, _omega_1_2, _omega_10_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _omega_7_2, _omega_8_2, _omega_9_2, _pressed_0_2, _pressed_1_2, _pressed_10_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _pressed_7_2, _pressed_8_2, _pressed_9_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_10_2, _sin_11_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sin_9_2, _sine_0_2, _sine_1_2, _sine_10_2, _sine_11_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _sine_9_2, _tilted_0_2, _tilted_1_2, _tilted_10_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _tilted_7_2, _tilted_8_2, _tilted_9_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_10_2, _turn_rate_11_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _turn_rate_9_2, _p_wire_radius_2, _room_2)
                _stride_2, _strongest_2, _fastest_2, _sway_2, _force_2, _force_rate_2, _force_bend_2, _brace_2, _vx_1_2, _vy_1_2, _vz_1_2 = ring_round_pace(_along_0_2, _along_1_2, _along_10_2, _along_11_2, _along_12_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _along_9_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_10_2, _climb_11_2, _climb_12_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _climb_9_2, _cos_0_2, _cos_12_2, _cosine_0_2, _cosine_12_2, _force_0_2, _force_1_2, _force_10_2, _force_11_2, _force_2_2, _force_3_2, _force_4_2, _force_5_2, _force_6_2, _force_7_2, _force_8_2, _force_9_2, _p_gravity_2, _omega_0_2, _p_ring_radius_2, _sin_0_2, _sin_12_2, _sine_0_2, _sine_12_2, _turn_rate_0_2, _turn_rate_11_2, _turn_rate_12_2, _p_wire_radius_2, _room_2)
                _stride_2, _which_2, _rests_2, *_ = leaving_force(_p_ball_radius_2, _brace_2, _inf, _fastest_2, _force_2, _force_bend_2, _force_rate_2, _p_gravity_2, _per_reach_2, 0.0, _stride_2, 0.0, _vx_2, _vx_1_2, _vy_2, _vy_1_2, _vz_2, _vz_1_2, _which_2, _room_2)
                _gap_2, _nearing_2, _dent_2 = backboard_beside(_p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2, _room_2)
                _stride_2, _which_2, *_ = beside_body(_p_ball_radius_2, _dent_2, _inf, _fastest_2, _gap_2, 1.0, 0.0, _nearing_2, 0.0, _stride_2, _strongest_2, _which_2, _x_2, _y_2, _z_2, _room_2)
                _gap_2, _nearing_2, _dent_2 = bridge_beside(_p_ball_radius_2, _p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _p_ring_radius_2, _vx_2, _vy_2, _vz_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
                _stride_2, _which_2, *_ = beside_body(_p_ball_radius_2, _dent_2, _inf, _fastest_2, _gap_2, 2.0, 0.0, _nearing_2, 0.0, _stride_2, _strongest_2, _which_2, _x_2, _y_2, _z_2, _room_2)
                _gap_2, _nearing_2, _dent_2 = end_beside(_p_end_depth_2, _vz_2, _z_2)
                _stride_2, _which_2, *_ = beside_gate(_p_ball_radius_2, _dent_2, _inf, _fastest_2, _gap_2, 3.0, 0.0, _nearing_2, 0.0, _stride_2, _strongest_2, _which_2, _x_2, _y_2, _z_2, _room_2)
                _stride_2, _which_2 = beside_time(_clock_2, _stride_2, _time_limit_2, _which_2)
                _over_2, = passing_from(_z_2)
                _berth_2, *_ = alone()
                _forth_2, _back_2 = leaps(_stride_2)
                _gap_2, _nearing_2 = backboard_around(_p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2, _room_2)
                _berth_2, = cleared(_berth_2, _gap_2, _forth_2, _nearing_2)
                _gap_2, _nearing_2 = bridge_around(_p_ball_radius_2, _p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _p_ring_radius_2, _vx_2, _vy_2, _vz_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
                _berth_2, = cleared(_berth_2, _gap_2, _forth_2, _nearing_2)
                _gap_2, _nearing_2 = end_around(_p_end_depth_2, _vz_2, _z_2)
                _berth_2, = cleared(_berth_2, _gap_2, _forth_2, _nearing_2)
                _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _climb_2 = ring_round_moved(_along_0_2, _along_1_2, _along_10_2, _along_11_2, _along_12_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _along_9_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_10_2, _climb_11_2, _climb_12_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _climb_9_2, _cos_0_2, _cos_1_2, _cos_10_2, _cos_11_2, _cos_12_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cos_9_2, _cosine_0_2, _cosine_1_2, _cosine_10_2, _cosine_11_2, _cosine_12_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _cosine_9_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_10_2, _sin_11_2, _sin_12_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sin_9_2, _sine_0_2, _sine_1_2, _sine_10_2, _sine_11_2, _sine_12_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _sine_9_2, _stride_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_10_2, _turn_rate_11_2, _turn_rate_12_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _turn_rate_9_2, _p_wire_radius_2, _room_2)
                _through_2, = passing_in_contact(_over_2, _p_ring_radius_2, _through_2, _x_2, _y_2, _z_2)
                _gap_2, _nearing_2 = backboard_around(_p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2, _room_2)
                _berth_2, = cleared(_berth_2, _gap_2, _back_2, _nearing_2)
                _gap_2, _nearing_2 = bridge_around(_p_ball_radius_2, _p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _p_ring_radius_2, _vx_2, _vy_2, _vz_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
                _berth_2, = cleared(_berth_2, _gap_2, _back_2, _nearing_2)
                _gap_2, _nearing_2 = end_around(_p_end_depth_2, _vz_2, _z_2)
                _berth_2, = cleared(_berth_2, _gap_2, _back_2, _nearing_2)
                _circled_2, _endless_2, *_ = ring_swung(_p_ball_radius_2, _berth_2, _circled_2, _climb_2, _climb_0_2, _inf, _fastest_2, _force_2, _force_bend_2, _force_rate_2, _p_gravity_2, 0.0, _stride_2, _sway_2, 0.0, _which_2, _p_wire_radius_2, _room_2)
                _which_2, = for_ever(_endless_2, _which_2)
                _clock_2, _circling_2 = rolled_on(_clock_2, _rests_2, _stride_2, _which_2)
                _going93 = _where_true(_circling_2)
                if len(_going93) == _count92:
                    continue
                _done = _where_true(_logical_not(_circling_2))
                _store(_circled_1, _of(_rows91, _done), _circled_2, _done)
                _store(_circling_1, _of(_rows91, _done), _circling_2, _done)
                _store(_clock_1, _of(_rows91, _done), _clock_2, _done)
                _store(_per_reach_1, _of(_rows91, _done), _per_reach_2, _done)
                _store(_rests_1, _of(_rows91, _done), _rests_2, _done)
                _store(_through_1, _of(_rows91, _done), _through_2, _done)
                _store(_vx_1, _of(_rows91, _done), _vx_2, _done)
                _store(_vy_1, _of(_rows91, _done), _vy_2, _done)
                _store(_vz_1, _of(_rows91, _done), _vz_2, _done)
                _store(_which_1, _of(_rows91, _done), _which_2, _done)
                _store(_wx_1, _of(_rows91, _done), _wx_2, _done)
                _store(_wy_1, _of(_rows91, _done), _wy_2, _done)
                _store(_wz_1, _of(_rows91, _done), _wz_2, _done)
                _store(_x_1, _of(_rows91, _done), _x_2, _done)
                _store(_y_1, _of(_rows91, _done), _y_2, _done)
                _store(_z_1, _of(_rows91, _done), _z_2, _done)
                _rows91, _count92 = _of(_rows91, _going93), len(_going93)
                if not _count92:
                    break
                _circled_2 = _take(_circled_2, _going93)
                _circling_2 = _take(_circling_2, _going93)
                _clock_2 = _take(_clock_2, _going93)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going93)
                _p_board_bottom_2 = _take(_p_board_bottom_2, _going93)
                _p_board_distance_2 = _take(_p_board_distance_2, _going93)
                _p_board_half_width_2 = _take(_p_board_half_width_2, _going93)
                _p_board_thickness_2 = _take(_p_board_thickness_2, _going93)
                _p_board_top_2 = _take(_p_board_top_2, _going93)
                _p_bridge_depth_2 = _take(_p_bridge_depth_2, _going93)
                _p_bridge_half_width_2 = _take(_p_bridge_half_width_2, _going93)
                _p_end_depth_2 = _take(_p_end_depth_2, _going93)
                _p_gravity_2 = _take(_p_gravity_2, _going93)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going93)
                _p_wire_radius_2 = _take(_p_wire_radius_2, _going93)
                _per_reach_2 = _take(_per_reach_2, _going93)
                _rests_2 = _take(_rests_2, _going93)
                _through_2 = _take(_through_2, _going93)
                _time_limit_2 = _take(_time_limit_2, _going93)
                _vx_2 = _take(_vx_2, _going93)
                _vy_2 = _take(_vy_2, _going93)
                _vz_2 = _take(_vz_2, _going93)
                _which_2 = _take(_which_2, _going93)
                _wx_2 = _take(_wx_2, _going93)
                _wy_2 = _take(_wy_2, _going93)
                _wz_2 = _take(_wz_2, _going93)
                _x_2 = _take(_x_2, _going93)
                _y_2 = _take(_y_2, _going93)
                _z_2 = _take(_z_2, _going93)
            else:
                _store(_circled_1, _rows91, _circled_2, None)
                _store(_circling_1, _rows91, _circling_2, None)
                _store(_clock_1, _rows91, _clock_2, None)
                _store(_per_reach_1, _rows91, _per_reach_2, None)
                _store(_rests_1, _rows91, _rests_2, None)
                _store(_through_1, _rows91, _through_2, None)
                _store(_vx_1, _rows91, _vx_2, None)
                _store(_vy_1, _rows91, _vy_2, None)
                _store(_vz_1, _rows91, _vz_2, None)
                _store(_which_1, _rows91, _which_2, None)
                _store(_wx_1, _rows91, _wx_2, None)
                _store(_wy_1, _rows91, _wy_2, None)
                _store(_wz_1, _rows91, _wz_2, None)
                _store(_x_1, _rows91, _x_2, None)
                _store(_y_1, _rows91, _y_2, None)
                _store(_z_1, _rows91, _z_2, None)
        _rolling_1, = rejoined(_circling_1, _rolling_1)
        _rows94, _count95 = _rows(_leaves_1, _count67)
        if _count95:
            _held_2 = _take(_held_1, _rows94)
            _lift_2 = _take(_lift_1, _rows94)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows94)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows94)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows94)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows94)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows94)
            _p_board_top_2 = _take(_p_board_top_1, _rows94)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows94)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows94)
            _p_end_depth_2 = _take(_p_end_depth_1, _rows94)
            _p_gravity_2 = _take(_p_gravity_1, _rows94)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows94)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows94)
            _per_reach_2 = _take(_per_reach_1, _rows94)
            _snap_2 = _take(_snap_1, _rows94)
            _surge_2 = _take(_surge_1, _rows94)
            _vx_2 = _take(_vx_1, _rows94)
            _vy_2 = _take(_vy_1, _rows94)
            _vz_2 = _take(_vz_1, _rows94)
            _x_2 = _take(_x_1, _rows94)
            _y_2 = _take(_y_1, _rows94)
            _z_2 = _take(_z_1, _rows94)
            _room_2 = room(_count95)
            _here_2, = holding(_held_2, 0.0)
            _rows96, _count97 = _rows(_here_2, _count95)
            if _count97:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows96)
                _p_gravity_3 = _take(_p_gravity_2, _rows96)
                _p_ring_radius_3 = _take(_p_ring_radius_2, _rows96)
                _p_wire_radius_3 = _take(_p_wire_radius_2, _rows96)
                _vx_3 = _take(_vx_2, _rows96)
                _vy_3 = _take(_vy_2, _rows96)
                _vz_3 = _take(_vz_2, _rows96)
                _x_3 = _take(_x_2, _rows96)
                _y_3 = _take(_y_2, _rows96)
                _z_3 = _take(_z_2, _rows96)
                _room_3 = room(_count97)
                _, _, _, _per_reach_3 = ring_tube(_p_ball_radius_3, _p_wire_radius_3)
                _lift_3, _surge_3, _snap_3 = ring_parting(_p_gravity_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3, _room_3)
                _lift_2 = _put(_lift_2, _rows96, _lift_3, _count95)
                _per_reach_2 = _put(_per_reach_2, _rows96, _per_reach_3, _count95)
                _snap_2 = _put(_snap_2, _rows96, _snap_3, _count95)
                _surge_2 = _put(_surge_2, _rows96, _surge_3, _count95)
            _here_2, = holding(_held_2, 1.0)
            _rows98, _count99 = _rows(_here_2, _count95)
            if _count99:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows98)
                _p_board_bottom_3 = _take(_p_board_bottom_2, _rows98)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows98)
                _p_board_half_width_3 = _take(_p_board_half_width_2, _rows98)
                _p_board_thickness_3 = _take(_p_board_thickness_2, _rows98)
                _p_board_top_3 = _take(_p_board_top_2, _rows98)
                _p_gravity_3 = _take(_p_gravity_2, _rows98)
                _vx_3 = _take(_vx_2, _rows98)
                _vy_3 = _take(_vy_2, _rows98)
                _vz_3 = _take(_vz_2, _rows98)
                _x_3 = _take(_x_2, _rows98)
                _y_3 = _take(_y_2, _rows98)
                _z_3 = _take(_z_2, _rows98)
                _room_3 = room(_count99)
                _, _, _, _per_reach_3 = backboard_tube(_p_ball_radius_3, _p_board_bottom_3, _p_board_distance_3, _p_board_half_width_3, _p_board_thickness_3, _p_board_top_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3, _room_3)
                _lift_3, _surge_3, _snap_3 = backboard_parting(_p_board_bottom_3, _p_board_distance_3, _p_board_half_width_3, _p_board_thickness_3, _p_board_top_3, _p_gravity_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3, _room_3)
                _lift_2 = _put(_lift_2, _rows98, _lift_3, _count95)
                _per_reach_2 = _put(_per_reach_2, _rows98, _per_reach_3, _count95)
                _snap_2 = _put(_snap_2, _rows98, _snap_3, _count95)
                _surge_2 = _put(_surge_2, _rows98, _surge_3, _count95)
            _here_2, = holding(_held_2, 2.0)
            _rows100, _count101 = _rows(_here_2, _count95)
            if _count101:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows100)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows100)
                _p_bridge_depth_3 = _take(_p_bridge_depth_2, _rows100)
                _p_bridge_half_width_3 = _take(_p_bridge_half_width_2, _rows100)
                _p_gravity_3 = _take(_p_gravity_2, _rows100)
                _p_ring_radius_3 = _take(_p_ring_radius_2, _rows100)
                _p_wire_radius_3 = _take(_p_wire_radius_2, _rows100)
                _vx_3 = _take(_vx_2, _rows100)
                _vy_3 = _take(_vy_2, _rows100)
                _vz_3 = _take(_vz_2, _rows100)
                _x_3 = _take(_x_2, _rows100)
                _y_3 = _take(_y_2, _rows100)
                _z_3 = _take(_z_2, _rows100)
                _room_3 = room(_count101)
                _, _, _, _per_reach_3 = bridge_tube(_p_ball_radius_3, _p_board_distance_3, _p_bridge_depth_3, _p_bridge_half_width_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                _lift_3, _surge_3, _snap_3 = bridge_parting(_p_board_distance_3, _p_bridge_depth_3, _p_bridge_half_width_3, _p_gravity_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                _lift_2 = _put(_lift_2, _rows100, _lift_3, _count95)
                _per_reach_2 = _put(_per_reach_2, _rows100, _per_reach_3, _count95)
                _snap_2 = _put(_snap_2, _rows100, _snap_3, _count95)
                _surge_2 = _put(_surge_2, _rows100, _surge_3, _count95)
            _spare_2, = unmet()
            _beside_2, = beside(_held_2, 0.0)
            _rows102, _count103 = _rows(_beside_2, _count95)
            if _count103:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows102)
                _p_gravity_3 = _take(_p_gravity_2, _rows102)
                _p_ring_radius_3 = _take(_p_ring_radius_2, _rows102)
                _p_wire_radius_3 = _take(_p_wire_radius_2, _rows102)
                _spare_3 = _take(_spare_2, _rows102)
                _vx_3 = _take(_vx_2, _rows102)
                _vy_3 = _take(_vy_2, _rows102)
                _vz_3 = _take(_vz_2, _rows102)
                _x_3 = _take(_x_2, _rows102)
                _y_3 = _take(_y_2, _rows102)
                _z_3 = _take(_z_2, _rows102)
                _room_3 = room(_count103)
                _gap_3, _nearing_3, _dent_3 = ring_beside(_p_ball_radius_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                _spare_3, = spared(_dent_3, _gap_3, _p_gravity_3, _nearing_3, _spare_3, _vx_3, _vy_3, _vz_3, _room_3)
                _spare_2 = _put(_spare_2, _rows102, _spare_3, _count95)
            _beside_2, = beside(_held_2, 1.0)
            _rows104, _count105 = _rows(_beside_2, _count95)
            if _count105:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows104)
                _p_board_bottom_3 = _take(_p_board_bottom_2, _rows104)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows104)
                _p_board_half_width_3 = _take(_p_board_half_width_2, _rows104)
                _p_board_thickness_3 = _take(_p_board_thickness_2, _rows104)
                _p_board_top_3 = _take(_p_board_top_2, _rows104)
                _p_gravity_3 = _take(_p_gravity_2, _rows104)
                _spare_3 = _take(_spare_2, _rows104)
                _vx_3 = _take(_vx_2, _rows104)
                _vy_3 = _take(_vy_2, _rows104)
                _vz_3 = _take(_vz_2, _rows104)
                _x_3 = _take(_x_2, _rows104)
                _y_3 = _take(_y_2, _rows104)
                _z_3 = _take(_z_2, _rows104)
                _room_3 = room(_count105)
                _gap_3, _nearing_3, _dent_3 = backboard_beside(_p_ball_radius_3, _p_board_bottom_3, _p_board_distance_3, _p_board_half_width_3, _p_board_thickness_3, _p_board_top_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3, _room_3)
                _spare_3, = spared(_dent_3, _gap_3, _p_gravity_3, _nearing_3, _spare_3, _vx_3, _vy_3, _vz_3, _room_3)
                _spare_2 = _put(_spare_2, _rows104, _spare_3, _count95)
            _beside_2, = beside(_held_2, 2.0)
            _rows106, _count107 = _rows(_beside_2, _count95)
            if _count107:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows106)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows106)
                _p_bridge_depth_3 = _take(_p_bridge_depth_2, _rows106)
                _p_bridge_half_width_3 = _take(_p_bridge_half_width_2, _rows106)
                _p_gravity_3 = _take(_p_gravity_2, _rows106)
                _p_ring_radius_3 = _take(_p_ring_radius_2, _rows106)
                _p_wire_radius_3 = _take(_p_wire_radius_2, _rows106)
                _spare_3 = _take(_spare_2, _rows106)
                _vx_3 = _take(_vx_2, _rows106)
                _vy_3 = _take(_vy_2, _rows106)
                _vz_3 = _take(_vz_2, _rows106)
                _x_3 = _take(_x_2, _rows106)
                _y_3 = _take(_y_2, _rows106)
                _z_3 = _take(_z_2, _rows106)
                _room_3 = room(_count107)
                _gap_3, _nearing_3, _dent_3 = bridge_beside(_p_ball_radius_3, _p_board_distance_3, _p_bridge_depth_3, _p_bridge_half_width_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                _spare_3, = spared(_dent_3, _gap_3, _p_gravity_3, _nearing_3, _spare_3, _vx_3, _vy_3, _vz_3, _room_3)
                _spare_2 = _put(_spare_2, _rows106, _spare_3, _count95)
            _beside_2, = beside(_held_2, 3.0)
            _rows108, _count109 = _rows(_beside_2, _count95)
            if _count109:
                _p_end_depth_3 = _take(_p_end_depth_2, _rows108)
                _p_gravity_3 = _take(_p_gravity_2, _rows108)
                _spare_3 = _take(_spare_2, _rows108)
                _vx_3 = _take(_vx_2, _rows108)
                _vy_3 = _take(_vy_2, _rows108)
                _vz_3 = _take(_vz_2, _rows108)
                _z_3 = _take(_z_2, _rows108)
                _room_3 = room(_count109)
                _gap_3, _nearing_3, _dent_3 = end_beside(_p_end_depth_3, _vz_3, _z_3)
                _spare_3, = spared(_dent_3, _gap_3, _p_gravity_3, _nearing_3, _spare_3, _vx_3, _vy_3, _vz_3, _room_3)
                _spare_2 = _put(_spare_2, _rows108, _spare_3, _count95)
            _here_2, = holding(_held_2, 1.0)
            _rows110, _count111 = _rows(_here_2, _count95)
            if _count111:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows110)
                _p_board_bottom_3 = _take(_p_board_bottom_2, _rows110)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows110)
                _p_board_half_width_3 = _take(_p_board_half_width_2, _rows110)
                _p_board_thickness_3 = _take(_p_board_thickness_2, _rows110)
                _p_board_top_3 = _take(_p_board_top_2, _rows110)
                _p_gravity_3 = _take(_p_gravity_2, _rows110)
                _spare_3 = _take(_spare_2, _rows110)
                _vx_3 = _take(_vx_2, _rows110)
                _vy_3 = _take(_vy_2, _rows110)
                _vz_3 = _take(_vz_2, _rows110)
                _x_3 = _take(_x_2, _rows110)
                _y_3 = _take(_y_2, _rows110)
                _z_3 = _take(_z_2, _rows110)
                _room_3 = room(_count111)
                _gap_3, _nearing_3, _near_3 = backboard_seam0(_p_ball_radius_3, _p_board_distance_3, _p_board_thickness_3, _vx_3, _x_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = backboard_seam1(_p_ball_radius_3, _p_board_distance_3, _p_board_thickness_3, _vx_3, _x_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = backboard_seam2(_p_ball_radius_3, _p_board_half_width_3, _vy_3, _y_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = backboard_seam3(_p_ball_radius_3, _p_board_half_width_3, _vy_3, _y_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = backboard_seam4(_p_ball_radius_3, _p_board_bottom_3, _p_board_top_3, _vz_3, _z_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = backboard_seam5(_p_ball_radius_3, _p_board_bottom_3, _p_board_top_3, _vz_3, _z_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _spare_2 = _put(_spare_2, _rows110, _spare_3, _count95)
            _here_2, = holding(_held_2, 2.0)
            _rows112, _count113 = _rows(_here_2, _count95)
            if _count113:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows112)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows112)
                _p_bridge_depth_3 = _take(_p_bridge_depth_2, _rows112)
                _p_bridge_half_width_3 = _take(_p_bridge_half_width_2, _rows112)
                _p_gravity_3 = _take(_p_gravity_2, _rows112)
                _p_ring_radius_3 = _take(_p_ring_radius_2, _rows112)
                _p_wire_radius_3 = _take(_p_wire_radius_2, _rows112)
                _spare_3 = _take(_spare_2, _rows112)
                _vx_3 = _take(_vx_2, _rows112)
                _vy_3 = _take(_vy_2, _rows112)
                _vz_3 = _take(_vz_2, _rows112)
                _x_3 = _take(_x_2, _rows112)
                _y_3 = _take(_y_2, _rows112)
                _z_3 = _take(_z_2, _rows112)
                _room_3 = room(_count113)
                _gap_3, _nearing_3, _near_3 = bridge_seam0(_p_ball_radius_3, _p_board_distance_3, _p_ring_radius_3, _vx_3, _x_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = bridge_seam1(_p_ball_radius_3, _p_board_distance_3, _p_ring_radius_3, _vx_3, _x_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = bridge_seam2(_p_ball_radius_3, _p_bridge_half_width_3, _vy_3, _y_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = bridge_seam3(_p_ball_radius_3, _p_bridge_half_width_3, _vy_3, _y_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = bridge_seam4(_p_ball_radius_3, _p_bridge_depth_3, _vz_3, _p_wire_radius_3, _z_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = bridge_seam5(_p_ball_radius_3, _p_bridge_depth_3, _vz_3, _p_wire_radius_3, _z_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _spare_2 = _put(_spare_2, _rows112, _spare_3, _count95)
            _when_2, *_ = parted(_inf, _p_gravity_2, _lift_2, _per_reach_2, 0.0, _snap_2, _spare_2, _surge_2, 0.0, _vx_2, _vy_2, _vz_2, _room_2)
            _which_2, = hopping()
            _when_1 = _put(_when_1, _rows94, _when_2, _count67)
            _which_1 = _put(_which_1, _rows94, _which_2, _count67)
        _began_0 = _put(_began_0, _rows66, _began_1, shots)
        _circled_0 = _put(_circled_0, _rows66, _circled_1, shots)
        _clock_0 = _put(_clock_0, _rows66, _clock_1, shots)
        _rests_0 = _put(_rests_0, _rows66, _rests_1, shots)
        _rolling_0 = _put(_rolling_0, _rows66, _rolling_1, shots)
        _through_0 = _put(_through_0, _rows66, _through_1, shots)
        _vx_0 = _put(_vx_0, _rows66, _vx_1, shots)
        _vy_0 = _put(_vy_0, _rows66, _vy_1, shots)
        _vz_0 = _put(_vz_0, _rows66, _vz_1, shots)
        _when_0 = _put(_when_0, _rows66, _when_1, shots)
        _which_0 = _put(_which_0, _rows66, _which_1, shots)
        _wx_0 = _put(_wx_0, _rows66, _wx_1, shots)
        _wy_0 = _put(_wy_0, _rows66, _wy_1, shots)
        _wz_0 = _put(_wz_0, _rows66, _wz_1, shots)
        _x_0 = _put(_x_0, _rows66, _x_1, shots)
        _y_0 = _put(_y_0, _rows66, _y_1, shots)
        _z_0 = _put(_z_0, _rows66, _z_1, shots)
    _, _moves_0, _ends_0, _touches_0, _reached_0, *_ = departed(3.0, _which_0)
    _body_0, = body_of(_which_0)
    _rows114, _count115 = _rows(_moves_0, shots)
    if _count115:
        _clock_1 = _take(_clock_0, _rows114)
        _p_gravity_1 = _take(_p_gravity_0, _rows114)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows114)
        _through_1 = _take(_through_0, _rows114)
        _vx_1 = _take(_vx_0, _rows114)
        _vy_1 = _take(_vy_0, _rows114)
        _vz_1 = _take(_vz_0, _rows114)
        _when_1 = _take(_when_0, _rows114)
        _x_1 = _take(_x_0, _rows114)
        _y_1 = _take(_y_0, _rows114)
        _z_1 = _take(_z_0, _rows114)
        _room_1 = room(_count115)
        _through_1, = passing(_through_1, _when_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ring_radius_1, _p_gravity_1, _room_1)
        _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1 = flight(_when_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_gravity_1, _room_1)
        _clock_1, = ticked(_clock_1, _when_1)
        _clock_0 = _put(_clock_0, _rows114, _clock_1, shots)
        _through_0 = _put(_through_0, _rows114, _through_1, shots)
        _vx_0 = _put(_vx_0, _rows114, _vx_1, shots)
        _vy_0 = _put(_vy_0, _rows114, _vy_1, shots)
        _vz_0 = _put(_vz_0, _rows114, _vz_1, shots)
        _x_0 = _put(_x_0, _rows114, _x_1, shots)
        _y_0 = _put(_y_0, _rows114, _y_1, shots)
        _z_0 = _put(_z_0, _rows114, _z_1, shots)
    _rows116, _count117 = _rows(_limited_0, shots)
    if _count117:
        _body_1 = _take(_body_0, _rows116)
        _clock_1 = _take(_clock_0, _rows116)
        _ends_1 = _take(_ends_0, _rows116)
        _reached_1 = _take(_reached_0, _rows116)
        _time_limit_1 = _take(_time_limit_0, _rows116)
        _which_1 = _take(_which_0, _rows116)
        _clock_1, _body_1, _reached_1, _ends_1 = expired(_body_1, _clock_1, _ends_1, 4.0, _reached_1, _time_limit_1, _which_1)
        _body_0 = _put(_body_0, _rows116, _body_1, shots)
        _clock_0 = _put(_clock_0, _rows116, _clock_1, shots)
        _ends_0 = _put(_ends_0, _rows116, _ends_1, shots)
        _reached_0 = _put(_reached_0, _rows116, _reached_1, shots)
    _rows118, _count119 = _rows(_kept_0, shots)
    if _count119:
        _began_1 = _take(_began_0, _rows118)
        _body_1 = _take(_body_0, _rows118)
        _clock_1 = _take(_clock_0, _rows118)
        _ends_1 = _take(_ends_0, _rows118)
        _held_1 = _take(_held_0, _rows118)
        _last_1 = _take(_last_0, _rows118)
        _reached_1 = _take(_reached_0, _rows118)
        _rests_1 = _take(_rests_0, _rows118)
        _rolling_1 = _take(_rolling_0, _rows118)
        _rolls_1 = _take(_rolls_0, _rows118)
        _which_1 = _take(_which_0, _rows118)
        _room_1 = room(_count119)
        _body_1, _reached_1, _, _ends_1, _, _last_1, _mode_1, _held_1, _rolls_1 = kept_on(_began_1, _body_1, _clock_1, _inf, _ends_1, _held_1, _last_1, _reached_1, _rests_1, _rolling_1, _rolls_1, _which_1, _room_1)
        _body_0 = _put(_body_0, _rows118, _body_1, shots)
        _ends_0 = _put(_ends_0, _rows118, _ends_1, shots)
        _held_0 = _put(_held_0, _rows118, _held_1, shots)
        _last_0 = _put(_last_0, _rows118, _last_1, shots)
        _mode_0 = _put(_mode_0, _rows118, _mode_1, shots)
        _reached_0 = _put(_reached_0, _rows118, _reached_1, shots)
        _rolls_0 = _put(_rolls_0, _rows118, _rolls_1, shots)
    _here_0, = here(3.0, _which_0)
    _g0_1, = end_bounds(_x_0, _y_0, _p_ring_radius_0)
    _reached_1, = end_reached(_g0_1, _through_0)
    _reached_0 = _choose(_here_0, _reached_1, _reached_0)
    _contacts_0, _outcome_0 = accounted(_contacts_0, _most_contacts_0, _reached_0, _touches_0)
    columns["body"] = _body_0
    columns["circled"] = _circled_0
    columns["clock"] = _clock_0
    columns["contacts"] = _contacts_0
    columns["ends"] = _ends_0
    columns["held"] = _held_0
    columns["last"] = _last_0
    columns["mode"] = _mode_0
    columns["outcome"] = _outcome_0
    columns["rolls"] = _rolls_0
    columns["through"] = _through_0
    columns["touches"] = _touches_0
    columns["vx"] = _vx_0
    columns["vy"] = _vy_0
    columns["vz"] = _vz_0
    columns["which"] = _which_0
    columns["wx"] = _wx_0
    columns["wy"] = _wy_0
    columns["wz"] = _wz_0
    columns["x"] = _x_0
    columns["y"] = _y_0
    columns["z"] = _z_0


def meet_plain(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage meet of the event loop, the path alone."""
    _body_0 = columns["body"]
    _count_0_0 = columns["count_0"]
    _count_1_0 = columns["count_1"]
    _count_2_0 = columns["count_2"]
    _ends_0 = columns["ends"]
    _first_0 = columns["first"]
    _held_0 = columns["held"]
    _last_0 = columns["last"]
    _mode_0 = columns["mode"]
    _outcome_0 = columns["outcome"]
    _p_backboard_friction_0 = columns["p_backboard_friction"]
    _p_backboard_restitution_0 = columns["p_backboard_restitution"]
    _p_ball_radius_0 = columns["p_ball_radius"]
    _p_board_bottom_0 = columns["p_board_bottom"]
    _p_board_distance_0 = columns["p_board_distance"]
    _p_board_half_width_0 = columns["p_board_half_width"]
    _p_board_thickness_0 = columns["p_board_thickness"]
    _p_board_top_0 = columns["p_board_top"]
    _p_bridge_depth_0 = columns["p_bridge_depth"]
    _p_bridge_friction_0 = columns["p_bridge_friction"]
    _p_bridge_half_width_0 = columns["p_bridge_half_width"]
    _p_bridge_restitution_0 = columns["p_bridge_restitution"]
    _p_end_depth_0 = columns["p_end_depth"]
    _p_gravity_0 = columns["p_gravity"]
    _p_restitution_speed_0 = columns["p_restitution_speed"]
    _p_ring_friction_0 = columns["p_ring_friction"]
    _p_ring_radius_0 = columns["p_ring_radius"]
    _p_ring_restitution_0 = columns["p_ring_restitution"]
    _p_tangential_restitution_0 = columns["p_tangential_restitution"]
    _p_wire_radius_0 = columns["p_wire_radius"]
    _slip_left_0 = columns["slip_left"]
    _touches_0 = columns["touches"]
    _vx_0 = columns["vx"]
    _vy_0 = columns["vy"]
    _vz_0 = columns["vz"]
    _which_0 = columns["which"]
    _wx_0 = columns["wx"]
    _wy_0 = columns["wy"]
    _wz_0 = columns["wz"]
    _x_0 = columns["x"]
    _y_0 = columns["y"]
    _z_0 = columns["z"]
    _meeting_0, = meeting(0.0, _ends_0, _touches_0)
    _slow_0, = unslowed()
    _rows1, _count2 = _rows(_meeting_0, shots)
    if _count2:
        _body_1 = _take(_body_0, _rows1)
        _count_0_1 = _take(_count_0_0, _rows1)
        _count_1_1 = _take(_count_1_0, _rows1)
        _count_2_1 = _take(_count_2_0, _rows1)
        _first_1 = _take(_first_0, _rows1)
        _last_1 = _take(_last_0, _rows1)
        _p_backboard_friction_1 = _take(_p_backboard_friction_0, _rows1)
        _p_backboard_restitution_1 = _take(_p_backboard_restitution_0, _rows1)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows1)
        _p_board_bottom_1 = _take(_p_board_bottom_0, _rows1)
        _p_board_distance_1 = _take(_p_board_distance_0, _rows1)
        _p_board_half_width_1 = _take(_p_board_half_width_0, _rows1)
        _p_board_thickness_1 = _take(_p_board_thickness_0, _rows1)
        _p_board_top_1 = _take(_p_board_top_0, _rows1)
        _p_bridge_depth_1 = _take(_p_bridge_depth_0, _rows1)
        _p_bridge_friction_1 = _take(_p_bridge_friction_0, _rows1)
        _p_bridge_half_width_1 = _take(_p_bridge_half_width_0, _rows1)
        _p_bridge_restitution_1 = _take(_p_bridge_restitution_0, _rows1)
        _p_gravity_1 = _take(_p_gravity_0, _rows1)
        _p_restitution_speed_1 = _take(_p_restitution_speed_0, _rows1)
        _p_ring_friction_1 = _take(_p_ring_friction_0, _rows1)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows1)
        _p_ring_restitution_1 = _take(_p_ring_restitution_0, _rows1)
        _p_tangential_restitution_1 = _take(_p_tangential_restitution_0, _rows1)
        _p_wire_radius_1 = _take(_p_wire_radius_0, _rows1)
        _slow_1 = _take(_slow_0, _rows1)
        _touches_1 = _take(_touches_0, _rows1)
        _vx_1 = _take(_vx_0, _rows1)
        _vy_1 = _take(_vy_0, _rows1)
        _vz_1 = _take(_vz_0, _rows1)
        _which_1 = _take(_which_0, _rows1)
        _wx_1 = _take(_wx_0, _rows1)
        _wy_1 = _take(_wy_0, _rows1)
        _wz_1 = _take(_wz_0, _rows1)
        _x_1 = _take(_x_0, _rows1)
        _y_1 = _take(_y_0, _rows1)
        _z_1 = _take(_z_0, _rows1)
        _room_1 = room(_count2)
        _nx_1, _ny_1, _nz_1 = end_normal()
        _here_1, = here(0.0, _which_1)
        _nx_2, _ny_2, _nz_2 = ring_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _room_1)
        _count_0_2, = counted(_count_0_1)
        _count_0_1 = _choose(_here_1, _count_0_2, _count_0_1)
        _nx_1 = _choose(_here_1, _nx_2, _nx_1)
        _ny_1 = _choose(_here_1, _ny_2, _ny_1)
        _nz_1 = _choose(_here_1, _nz_2, _nz_1)
        _here_1, = here(1.0, _which_1)
        _nx_2, _ny_2, _nz_2 = backboard_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _room_1)
        _count_1_2, = counted(_count_1_1)
        _count_1_1 = _choose(_here_1, _count_1_2, _count_1_1)
        _nx_1 = _choose(_here_1, _nx_2, _nx_1)
        _ny_1 = _choose(_here_1, _ny_2, _ny_1)
        _nz_1 = _choose(_here_1, _nz_2, _nz_1)
        _here_1, = here(2.0, _which_1)
        _nx_2, _ny_2, _nz_2 = bridge_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _room_1)
        _count_2_2, = counted(_count_2_1)
        _count_2_1 = _choose(_here_1, _count_2_2, _count_2_1)
        _nx_1 = _choose(_here_1, _nx_2, _nx_1)
        _ny_1 = _choose(_here_1, _ny_2, _ny_1)
        _nz_1 = _choose(_here_1, _nz_2, _nz_1)
        _struck_0_1, = untaken()
        _, _its_0_ring_impact_1, _its_1_ring_impact_1 = ring_impact_taken(_p_ring_restitution_1, _p_ring_friction_1)
        for _own_index_1, _own_1_1, _own_2_1, in (
            (0.0, _p_ring_friction_1, _p_ring_restitution_1,),
            (1.0, _p_backboard_friction_1, _p_backboard_restitution_1,),
            (2.0, _p_bridge_friction_1, _p_bridge_restitution_1,),
        ):
            _here_1, = here(_own_index_1, _which_1)
            _rows3, _count4 = _rows(_here_1, _count2)
            if _count4:
                _own_1_2 = _take(_own_1_1, _rows3)
                _own_2_2 = _take(_own_2_1, _rows3)
                _struck_0_2, _its_0_ring_impact_2, _its_1_ring_impact_2 = ring_impact_taken(_own_2_2, _own_1_2)
                _its_0_ring_impact_1 = _put(_its_0_ring_impact_1, _rows3, _its_0_ring_impact_2, _count2)
                _its_1_ring_impact_1 = _put(_its_1_ring_impact_1, _rows3, _its_1_ring_impact_2, _count2)
                _struck_0_1 = _put(_struck_0_1, _rows3, _struck_0_2, _count2)
        _rows5, _count6 = _rows(_struck_0_1, _count2)
        if _count6:
            _its_0_ring_impact_2 = _take(_its_0_ring_impact_1, _rows5)
            _its_1_ring_impact_2 = _take(_its_1_ring_impact_1, _rows5)
            _nx_2 = _take(_nx_1, _rows5)
            _ny_2 = _take(_ny_1, _rows5)
            _nz_2 = _take(_nz_1, _rows5)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows5)
            _p_restitution_speed_2 = _take(_p_restitution_speed_1, _rows5)
            _p_tangential_restitution_2 = _take(_p_tangential_restitution_1, _rows5)
            _vx_2 = _take(_vx_1, _rows5)
            _vy_2 = _take(_vy_1, _rows5)
            _vz_2 = _take(_vz_1, _rows5)
            _wx_2 = _take(_wx_1, _rows5)
            _wy_2 = _take(_wy_1, _rows5)
            _wz_2 = _take(_wz_1, _rows5)
            _room_2 = room(_count6)
            _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = ring_impact(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _p_ball_radius_2, _its_0_ring_impact_2, _its_1_ring_impact_2, _p_tangential_restitution_2, _p_restitution_speed_2, _room_2)
            _vx_1 = _put(_vx_1, _rows5, _vx_2, _count2)
            _vy_1 = _put(_vy_1, _rows5, _vy_2, _count2)
            _vz_1 = _put(_vz_1, _rows5, _vz_2, _count2)
            _wx_1 = _put(_wx_1, _rows5, _wx_2, _count2)
            _wy_1 = _put(_wy_1, _rows5, _wy_2, _count2)
            _wz_1 = _put(_wz_1, _rows5, _wz_2, _count2)
        _first_2, _last_2 = touched(_body_1, _first_1, _which_1)
        _slow_2, *_ = slowed(_p_ball_radius_1, _p_gravity_1, _nx_1, _ny_1, _nz_1, 0.0, _vx_1, _vy_1, _vz_1, _room_1)
        _first_1 = _choose(_touches_1, _first_2, _first_1)
        _last_1 = _choose(_touches_1, _last_2, _last_1)
        _slow_1 = _choose(_touches_1, _slow_2, _slow_1)
        _count_0_0 = _put(_count_0_0, _rows1, _count_0_1, shots)
        _count_1_0 = _put(_count_1_0, _rows1, _count_1_1, shots)
        _count_2_0 = _put(_count_2_0, _rows1, _count_2_1, shots)
        _first_0 = _put(_first_0, _rows1, _first_1, shots)
        _last_0 = _put(_last_0, _rows1, _last_1, shots)
        _slow_0 = _put(_slow_0, _rows1, _slow_1, shots)
        _vx_0 = _put(_vx_0, _rows1, _vx_1, shots)
        _vy_0 = _put(_vy_0, _rows1, _vy_1, shots)
        _vz_0 = _put(_vz_0, _rows1, _vz_1, shots)
        _wx_0 = _put(_wx_0, _rows1, _wx_1, shots)
        _wy_0 = _put(_wy_0, _rows1, _wy_1, shots)
        _wz_0 = _put(_wz_0, _rows1, _wz_1, shots)
    _rows7, _count8 = _rows(_slow_0, shots)
    if _count8:
        _held_1 = _take(_held_0, _rows7)
        _mode_1 = _take(_mode_0, _rows7)
        _outcome_1 = _take(_outcome_0, _rows7)
        _p_backboard_friction_1 = _take(_p_backboard_friction_0, _rows7)
        _p_backboard_restitution_1 = _take(_p_backboard_restitution_0, _rows7)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows7)
        _p_board_bottom_1 = _take(_p_board_bottom_0, _rows7)
        _p_board_distance_1 = _take(_p_board_distance_0, _rows7)
        _p_board_half_width_1 = _take(_p_board_half_width_0, _rows7)
        _p_board_thickness_1 = _take(_p_board_thickness_0, _rows7)
        _p_board_top_1 = _take(_p_board_top_0, _rows7)
        _p_bridge_depth_1 = _take(_p_bridge_depth_0, _rows7)
        _p_bridge_friction_1 = _take(_p_bridge_friction_0, _rows7)
        _p_bridge_half_width_1 = _take(_p_bridge_half_width_0, _rows7)
        _p_bridge_restitution_1 = _take(_p_bridge_restitution_0, _rows7)
        _p_end_depth_1 = _take(_p_end_depth_0, _rows7)
        _p_gravity_1 = _take(_p_gravity_0, _rows7)
        _p_ring_friction_1 = _take(_p_ring_friction_0, _rows7)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows7)
        _p_ring_restitution_1 = _take(_p_ring_restitution_0, _rows7)
        _p_wire_radius_1 = _take(_p_wire_radius_0, _rows7)
        _slip_left_1 = _take(_slip_left_0, _rows7)
        _vx_1 = _take(_vx_0, _rows7)
        _vy_1 = _take(_vy_0, _rows7)
        _vz_1 = _take(_vz_0, _rows7)
        _which_1 = _take(_which_0, _rows7)
        _wx_1 = _take(_wx_0, _rows7)
        _wy_1 = _take(_wy_0, _rows7)
        _wz_1 = _take(_wz_0, _rows7)
        _x_1 = _take(_x_0, _rows7)
        _y_1 = _take(_y_0, _rows7)
        _z_1 = _take(_z_0, _rows7)
        _room_1 = room(_count8)
        _nx_1, _ny_1, _nz_1 = ring_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _room_1)
        _here_1, = here(1.0, _which_1)
        _nx_2, _ny_2, _nz_2 = backboard_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _room_1)
        _nx_1 = _choose(_here_1, _nx_2, _nx_1)
        _ny_1 = _choose(_here_1, _ny_2, _ny_1)
        _nz_1 = _choose(_here_1, _nz_2, _nz_1)
        _here_1, = here(2.0, _which_1)
        _nx_2, _ny_2, _nz_2 = bridge_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _room_1)
        _nx_1 = _choose(_here_1, _nx_2, _nx_1)
        _ny_1 = _choose(_here_1, _ny_2, _ny_1)
        _nz_1 = _choose(_here_1, _nz_2, _nz_1)
        _nearly_1, = nearly(_p_ball_radius_1, _p_gravity_1, _nx_1, _ny_1, _nz_1, _vx_1, _vy_1, _vz_1, _room_1)
        _rolled_x_1, _rolled_y_1, _rolled_z_1, _slip_1, _bounce_1 = gripped(_p_ball_radius_1, _nx_1, _ny_1, _nz_1, _vx_1, _vy_1, _vz_1, _wx_1, _wy_1, _wz_1, _room_1)
        _here_1, = here(0.0, _which_1)
        _rows9, _count10 = _rows(_here_1, _count8)
        if _count10:
            _bounce_2 = _take(_bounce_1, _rows9)
            _nearly_2 = _take(_nearly_1, _rows9)
            _nx_2 = _take(_nx_1, _rows9)
            _ny_2 = _take(_ny_1, _rows9)
            _nz_2 = _take(_nz_1, _rows9)
            _outcome_2 = _take(_outcome_1, _rows9)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows9)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows9)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows9)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows9)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows9)
            _p_board_top_2 = _take(_p_board_top_1, _rows9)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows9)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows9)
            _p_end_depth_2 = _take(_p_end_depth_1, _rows9)
            _p_gravity_2 = _take(_p_gravity_1, _rows9)
            _p_ring_friction_2 = _take(_p_ring_friction_1, _rows9)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows9)
            _p_ring_restitution_2 = _take(_p_ring_restitution_1, _rows9)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows9)
            _rolled_x_2 = _take(_rolled_x_1, _rows9)
            _rolled_y_2 = _take(_rolled_y_1, _rows9)
            _rolled_z_2 = _take(_rolled_z_1, _rows9)
            _slip_2 = _take(_slip_1, _rows9)
            _vx_2 = _take(_vx_1, _rows9)
            _vy_2 = _take(_vy_1, _rows9)
            _vz_2 = _take(_vz_1, _rows9)
            _wx_2 = _take(_wx_1, _rows9)
            _wy_2 = _take(_wy_1, _rows9)
            _wz_2 = _take(_wz_1, _rows9)
            _x_2 = _take(_x_1, _rows9)
            _y_2 = _take(_y_1, _rows9)
            _z_2 = _take(_z_1, _rows9)
            _room_2 = room(_count10)
            _turning_x_2, _turning_y_2, _turning_z_2 = ring_turning(_p_ball_radius_2, _p_ring_radius_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _p_wire_radius_2, _x_2, _y_2, _room_2)
            _press_2, _weight_2, _drag_2, _thrust_x_2, _thrust_y_2, _thrust_z_2 = pressed_on(_p_ball_radius_2, _p_gravity_2, _nx_2, _ny_2, _nz_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _turning_x_2, _turning_y_2, _turning_z_2, _wx_2, _wy_2, _wz_2, _room_2)
            _nearest_2, _wedge_2 = alone()
            _gap_2, _nearing_2, _swerve_2, _facing_2 = backboard_closing(_p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _nx_2, _ny_2, _nz_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _thrust_x_2, _thrust_y_2, _thrust_z_2, _x_2, _y_2, _z_2, _room_2)
            _nearest_2, _wedge_2 = neared_body(_facing_2, _gap_2, _nearest_2, _nearing_2, _press_2, _swerve_2, _wedge_2, _room_2)
            _gap_2, _nearing_2, _swerve_2, _facing_2 = bridge_closing(_p_ball_radius_2, _p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _nx_2, _ny_2, _nz_2, _p_ring_radius_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _thrust_x_2, _thrust_y_2, _thrust_z_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _nearest_2, _wedge_2 = neared_body(_facing_2, _gap_2, _nearest_2, _nearing_2, _press_2, _swerve_2, _wedge_2, _room_2)
            _gap_2, *_ = end_beside(_p_end_depth_2, _vz_2, _z_2)
            _nearest_2, = neared(_gap_2, _nearest_2)
            _lift_2, *_ = ring_parting(_p_gravity_2, _p_ring_radius_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2, _room_2)
            _settles_2, _lodges_2, _slides_2, _parts_2, _, _unsure_2 = ring_impact_settling(_p_ball_radius_2, _bounce_2, _drag_2, _lift_2, _nearest_2, _press_2, _p_ring_friction_2, _p_ring_restitution_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _slip_2, _turning_x_2, _turning_y_2, _turning_z_2, 0.0, _wedge_2, _weight_2, _wx_2, _wy_2, _wz_2, _room_2)
            _mode_2, _held_2, _outcome_2, _slip_left_2, *_ = settled(0.0, _lodges_2, _nearly_2, _outcome_2, _parts_2, _settles_2, _slides_2, 0.0, _unsure_2)
            _held_1 = _put(_held_1, _rows9, _held_2, _count8)
            _mode_1 = _put(_mode_1, _rows9, _mode_2, _count8)
            _outcome_1 = _put(_outcome_1, _rows9, _outcome_2, _count8)
            _slip_left_1 = _put(_slip_left_1, _rows9, _slip_left_2, _count8)
        _here_1, = here(1.0, _which_1)
        _rows11, _count12 = _rows(_here_1, _count8)
        if _count12:
            _bounce_2 = _take(_bounce_1, _rows11)
            _nearly_2 = _take(_nearly_1, _rows11)
            _nx_2 = _take(_nx_1, _rows11)
            _ny_2 = _take(_ny_1, _rows11)
            _nz_2 = _take(_nz_1, _rows11)
            _outcome_2 = _take(_outcome_1, _rows11)
            _p_backboard_friction_2 = _take(_p_backboard_friction_1, _rows11)
            _p_backboard_restitution_2 = _take(_p_backboard_restitution_1, _rows11)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows11)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows11)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows11)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows11)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows11)
            _p_board_top_2 = _take(_p_board_top_1, _rows11)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows11)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows11)
            _p_end_depth_2 = _take(_p_end_depth_1, _rows11)
            _p_gravity_2 = _take(_p_gravity_1, _rows11)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows11)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows11)
            _rolled_x_2 = _take(_rolled_x_1, _rows11)
            _rolled_y_2 = _take(_rolled_y_1, _rows11)
            _rolled_z_2 = _take(_rolled_z_1, _rows11)
            _slip_2 = _take(_slip_1, _rows11)
            _vx_2 = _take(_vx_1, _rows11)
            _vy_2 = _take(_vy_1, _rows11)
            _vz_2 = _take(_vz_1, _rows11)
            _wx_2 = _take(_wx_1, _rows11)
            _wy_2 = _take(_wy_1, _rows11)
            _wz_2 = _take(_wz_1, _rows11)
            _x_2 = _take(_x_1, _rows11)
            _y_2 = _take(_y_1, _rows11)
            _z_2 = _take(_z_1, _rows11)
            _room_2 = room(_count12)
            _turning_x_2, _turning_y_2, _turning_z_2 = backboard_turning(_p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _x_2, _y_2, _z_2, _room_2)
            _press_2, _weight_2, _drag_2, _thrust_x_2, _thrust_y_2, _thrust_z_2 = pressed_on(_p_ball_radius_2, _p_gravity_2, _nx_2, _ny_2, _nz_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _turning_x_2, _turning_y_2, _turning_z_2, _wx_2, _wy_2, _wz_2, _room_2)
            _nearest_2, _wedge_2 = alone()
            _gap_2, _nearing_2, _swerve_2, _facing_2 = ring_closing(_p_ball_radius_2, _nx_2, _ny_2, _nz_2, _p_ring_radius_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _thrust_x_2, _thrust_y_2, _thrust_z_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _nearest_2, _wedge_2 = neared_body(_facing_2, _gap_2, _nearest_2, _nearing_2, _press_2, _swerve_2, _wedge_2, _room_2)
            _gap_2, _nearing_2, _swerve_2, _facing_2 = bridge_closing(_p_ball_radius_2, _p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _nx_2, _ny_2, _nz_2, _p_ring_radius_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _thrust_x_2, _thrust_y_2, _thrust_z_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _nearest_2, _wedge_2 = neared_body(_facing_2, _gap_2, _nearest_2, _nearing_2, _press_2, _swerve_2, _wedge_2, _room_2)
            _gap_2, *_ = end_beside(_p_end_depth_2, _vz_2, _z_2)
            _nearest_2, = neared(_gap_2, _nearest_2)
            _lift_2, *_ = backboard_parting(_p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _p_gravity_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2, _room_2)
            _settles_2, _lodges_2, _slides_2, _parts_2, _, _unsure_2 = ring_impact_settling(_p_ball_radius_2, _bounce_2, _drag_2, _lift_2, _nearest_2, _press_2, _p_backboard_friction_2, _p_backboard_restitution_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _slip_2, _turning_x_2, _turning_y_2, _turning_z_2, 0.0, _wedge_2, _weight_2, _wx_2, _wy_2, _wz_2, _room_2)
            _mode_2, _held_2, _outcome_2, _slip_left_2, *_ = settled(1.0, _lodges_2, _nearly_2, _outcome_2, _parts_2, _settles_2, _slides_2, 0.0, _unsure_2)
            _held_1 = _put(_held_1, _rows11, _held_2, _count8)
            _mode_1 = _put(_mode_1, _rows11, _mode_2, _count8)
            _outcome_1 = _put(_outcome_1, _rows11, _outcome_2, _count8)
            _slip_left_1 = _put(_slip_left_1, _rows11, _slip_left_2, _count8)
        _here_1, = here(2.0, _which_1)
        _rows13, _count14 = _rows(_here_1, _count8)
        if _count14:
            _bounce_2 = _take(_bounce_1, _rows13)
            _nearly_2 = _take(_nearly_1, _rows13)
            _nx_2 = _take(_nx_1, _rows13)
            _ny_2 = _take(_ny_1, _rows13)
            _nz_2 = _take(_nz_1, _rows13)
            _outcome_2 = _take(_outcome_1, _rows13)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows13)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows13)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows13)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows13)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows13)
            _p_board_top_2 = _take(_p_board_top_1, _rows13)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows13)
            _p_bridge_friction_2 = _take(_p_bridge_friction_1, _rows13)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows13)
            _p_bridge_restitution_2 = _take(_p_bridge_restitution_1, _rows13)
            _p_end_depth_2 = _take(_p_end_depth_1, _rows13)
            _p_gravity_2 = _take(_p_gravity_1, _rows13)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows13)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows13)
            _rolled_x_2 = _take(_rolled_x_1, _rows13)
            _rolled_y_2 = _take(_rolled_y_1, _rows13)
            _rolled_z_2 = _take(_rolled_z_1, _rows13)
            _slip_2 = _take(_slip_1, _rows13)
            _vx_2 = _take(_vx_1, _rows13)
            _vy_2 = _take(_vy_1, _rows13)
            _vz_2 = _take(_vz_1, _rows13)
            _wx_2 = _take(_wx_1, _rows13)
            _wy_2 = _take(_wy_1, _rows13)
            _wz_2 = _take(_wz_1, _rows13)
            _x_2 = _take(_x_1, _rows13)
            _y_2 = _take(_y_1, _rows13)
            _z_2 = _take(_z_1, _rows13)
            _room_2 = room(_count14)
            _turning_x_2, _turning_y_2, _turning_z_2 = bridge_turning(_p_ball_radius_2, _p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _p_ring_radius_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _press_2, _weight_2, _drag_2, _thrust_x_2, _thrust_y_2, _thrust_z_2 = pressed_on(_p_ball_radius_2, _p_gravity_2, _nx_2, _ny_2, _nz_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _turning_x_2, _turning_y_2, _turning_z_2, _wx_2, _wy_2, _wz_2, _room_2)
            _nearest_2, _wedge_2 = alone()
            _gap_2, _nearing_2, _swerve_2, _facing_2 = ring_closing(_p_ball_radius_2, _nx_2, _ny_2, _nz_2, _p_ring_radius_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _thrust_x_2, _thrust_y_2, _thrust_z_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _nearest_2, _wedge_2 = neared_body(_facing_2, _gap_2, _nearest_2, _nearing_2, _press_2, _swerve_2, _wedge_2, _room_2)
            _gap_2, _nearing_2, _swerve_2, _facing_2 = backboard_closing(_p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _nx_2, _ny_2, _nz_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _thrust_x_2, _thrust_y_2, _thrust_z_2, _x_2, _y_2, _z_2, _room_2)
            _nearest_2, _wedge_2 = neared_body(_facing_2, _gap_2, _nearest_2, _nearing_2, _press_2, _swerve_2, _wedge_2, _room_2)
            _gap_2, *_ = end_beside(_p_end_depth_2, _vz_2, _z_2)
            _nearest_2, = neared(_gap_2, _nearest_2)
            _lift_2, *_ = bridge_parting(_p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _p_gravity_2, _p_ring_radius_2, _vx_2, _vy_2, _vz_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _settles_2, _lodges_2, _slides_2, _parts_2, _, _unsure_2 = ring_impact_settling(_p_ball_radius_2, _bounce_2, _drag_2, _lift_2, _nearest_2, _press_2, _p_bridge_friction_2, _p_bridge_restitution_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _slip_2, _turning_x_2, _turning_y_2, _turning_z_2, 0.0, _wedge_2, _weight_2, _wx_2, _wy_2, _wz_2, _room_2)
            _mode_2, _held_2, _outcome_2, _slip_left_2, *_ = settled(2.0, _lodges_2, _nearly_2, _outcome_2, _parts_2, _settles_2, _slides_2, 0.0, _unsure_2)
            _held_1 = _put(_held_1, _rows13, _held_2, _count8)
            _mode_1 = _put(_mode_1, _rows13, _mode_2, _count8)
            _outcome_1 = _put(_outcome_1, _rows13, _outcome_2, _count8)
            _slip_left_1 = _put(_slip_left_1, _rows13, _slip_left_2, _count8)
        _held_0 = _put(_held_0, _rows7, _held_1, shots)
        _mode_0 = _put(_mode_0, _rows7, _mode_1, shots)
        _outcome_0 = _put(_outcome_0, _rows7, _outcome_1, shots)
        _slip_left_0 = _put(_slip_left_0, _rows7, _slip_left_1, shots)
    columns["count_0"] = _count_0_0
    columns["count_1"] = _count_1_0
    columns["count_2"] = _count_2_0
    columns["first"] = _first_0
    columns["held"] = _held_0
    columns["last"] = _last_0
    columns["mode"] = _mode_0
    columns["outcome"] = _outcome_0
    columns["slip_left"] = _slip_left_0
    columns["vx"] = _vx_0
    columns["vy"] = _vy_0
    columns["vz"] = _vz_0
    columns["wx"] = _wx_0
    columns["wy"] = _wy_0
    columns["wz"] = _wz_0


def permit_bounded(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage permit of the event loop, with bounds on errors."""
    _p_backboard_friction_0 = columns["p_backboard_friction"]
    _p_backboard_restitution_0 = columns["p_backboard_restitution"]
    _p_ball_radius_0 = columns["p_ball_radius"]
    _p_board_bottom_0 = columns["p_board_bottom"]
    _p_board_distance_0 = columns["p_board_distance"]
    _p_board_half_width_0 = columns["p_board_half_width"]
    _p_board_thickness_0 = columns["p_board_thickness"]
    _p_board_top_0 = columns["p_board_top"]
    _p_bridge_depth_0 = columns["p_bridge_depth"]
    _p_bridge_friction_0 = columns["p_bridge_friction"]
    _p_bridge_half_width_0 = columns["p_bridge_half_width"]
    _p_bridge_restitution_0 = columns["p_bridge_restitution"]
    _p_end_depth_0 = columns["p_end_depth"]
    _p_gravity_0 = columns["p_gravity"]
    _p_restitution_speed_0 = columns["p_restitution_speed"]
    _p_ring_friction_0 = columns["p_ring_friction"]
    _p_ring_radius_0 = columns["p_ring_radius"]
    _p_ring_restitution_0 = columns["p_ring_restitution"]
    _p_tangential_restitution_0 = columns["p_tangential_restitution"]
    _p_wire_radius_0 = columns["p_wire_radius"]
    _allowed_0, = allowed(_p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_board_thickness_0, _p_bridge_half_width_0, _p_bridge_depth_0, _p_gravity_0, _p_end_depth_0, _p_ring_restitution_0, _p_backboard_restitution_0, _p_bridge_restitution_0, _p_ring_friction_0, _p_backboard_friction_0, _p_bridge_friction_0, _p_tangential_restitution_0, _p_restitution_speed_0)
    _permitted_0, = finite_parameters(_p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_board_thickness_0, _p_bridge_half_width_0, _p_bridge_depth_0, _p_gravity_0, _p_end_depth_0, _p_ring_restitution_0, _p_backboard_restitution_0, _p_bridge_restitution_0, _p_ring_friction_0, _p_backboard_friction_0, _p_bridge_friction_0, _p_tangential_restitution_0, _p_restitution_speed_0, _allowed_0)
    columns["permitted"] = _permitted_0


def admit_bounded(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage admit of the event loop, with bounds on errors."""
    _last_0 = columns["last"]
    _p_ball_radius_0 = columns["p_ball_radius"]
    _p_board_bottom_0 = columns["p_board_bottom"]
    _p_board_distance_0 = columns["p_board_distance"]
    _p_board_half_width_0 = columns["p_board_half_width"]
    _p_board_thickness_0 = columns["p_board_thickness"]
    _p_board_top_0 = columns["p_board_top"]
    _p_bridge_depth_0 = columns["p_bridge_depth"]
    _p_bridge_half_width_0 = columns["p_bridge_half_width"]
    _p_end_depth_0 = columns["p_end_depth"]
    _p_ring_radius_0 = columns["p_ring_radius"]
    _p_wire_radius_0 = columns["p_wire_radius"]
    _permitted_0 = columns["permitted"]
    _vx_0 = columns["vx"]
    _vy_0 = columns["vy"]
    _vz_0 = columns["vz"]
    _wx_0 = columns["wx"]
    _wy_0 = columns["wy"]
    _wz_0 = columns["wz"]
    _x_0 = columns["x"]
    _y_0 = columns["y"]
    _z_0 = columns["z"]
    _room_0 = room(shots)
    _finite_0, = finite_state(_vx_0, _vy_0, _vz_0, _wx_0, _wy_0, _wz_0, _x_0, _y_0, _z_0, _room_0)
    _valid_0, _doubt_0 = valid(_last_0, _x_0, _y_0, _z_0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_board_thickness_0, _p_bridge_half_width_0, _p_bridge_depth_0, _p_end_depth_0, _room_0)
    _outcome_0, _uncertain_0 = admitted(_doubt_0, _finite_0, _permitted_0, _valid_0)
    _through_0, _uncertain_0 = passing_start(_last_0, _outcome_0, _uncertain_0, _x_0, _y_0, _z_0, _p_ring_radius_0, _p_end_depth_0, _room_0)
    columns["outcome"] = _outcome_0
    columns["through"] = _through_0
    columns["uncertain"] = _uncertain_0


def reach_bounded(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage reach of the event loop, with bounds on errors."""
    _assured_0 = columns["assured"]
    _circled_0 = columns["circled"]
    _clock_0 = columns["clock"]
    _clock_error_0 = columns["clock_error"]
    _contacts_0 = columns["contacts"]
    _dvx_0 = columns["dvx"]
    _dvy_0 = columns["dvy"]
    _dvz_0 = columns["dvz"]
    _dwx_0 = columns["dwx"]
    _dwy_0 = columns["dwy"]
    _dwz_0 = columns["dwz"]
    _dx_0 = columns["dx"]
    _dy_0 = columns["dy"]
    _dz_0 = columns["dz"]
    _grip_lost_0 = columns["grip_lost"]
    _held_0 = columns["held"]
    _last_0 = columns["last"]
    _mode_0 = columns["mode"]
    _most_contacts_0 = columns["most_contacts"]
    _p_backboard_friction_0 = columns["p_backboard_friction"]
    _p_ball_radius_0 = columns["p_ball_radius"]
    _p_board_bottom_0 = columns["p_board_bottom"]
    _p_board_distance_0 = columns["p_board_distance"]
    _p_board_half_width_0 = columns["p_board_half_width"]
    _p_board_thickness_0 = columns["p_board_thickness"]
    _p_board_top_0 = columns["p_board_top"]
    _p_bridge_depth_0 = columns["p_bridge_depth"]
    _p_bridge_friction_0 = columns["p_bridge_friction"]
    _p_bridge_half_width_0 = columns["p_bridge_half_width"]
    _p_end_depth_0 = columns["p_end_depth"]
    _p_gravity_0 = columns["p_gravity"]
    _p_ring_friction_0 = columns["p_ring_friction"]
    _p_ring_radius_0 = columns["p_ring_radius"]
    _p_wire_radius_0 = columns["p_wire_radius"]
    _rolls_0 = columns["rolls"]
    _taut_0 = columns["taut"]
    _taut_clock_0 = columns["taut_clock"]
    _taut_rate_0 = columns["taut_rate"]
    _through_0 = columns["through"]
    _time_limit_0 = columns["time_limit"]
    _uncertain_0 = columns["uncertain"]
    _vx_0 = columns["vx"]
    _vy_0 = columns["vy"]
    _vz_0 = columns["vz"]
    _wx_0 = columns["wx"]
    _wy_0 = columns["wy"]
    _wz_0 = columns["wz"]
    _x_0 = columns["x"]
    _y_0 = columns["y"]
    _z_0 = columns["z"]
    _room_0 = room(shots)
    _position_error_0, _velocity_error_0, _, _time_error_0 = error_bounds(_clock_error_0, _dx_0, _dy_0, _dz_0, _dvx_0, _dvy_0, _dvz_0, _dwx_0, _dwy_0, _dwz_0, _room_0)
    _extent_0, _speed_0, _excess_0 = scale(_x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _p_gravity_0, _room_0)
    _when_0, _which_0, _late_0, _doubt_0 = opening(_excess_0, _position_error_0, _velocity_error_0)
    _limited_0, = limited(_time_limit_0)
    _kept_0, _when_0, _rests_0, _rolling_0, _began_0 = kept(_mode_0, _when_0)
    _leaving_0, = left(3.0, _last_0)
    _time_0, _rate_0, _bend_0, _apex_0, _height_0 = end_arrival(_leaving_0, _z_0, _vz_0, _p_gravity_0, _p_end_depth_0, _room_0)
    _arrives_0, _ceiling_0 = meeting_plane(_bend_0, _rate_0, _time_0)
    _margin_0, = end_margin(_time_0, _extent_0, _speed_0, _position_error_0, _velocity_error_0, _p_gravity_0, _p_end_depth_0, _room_0)
    _clearance_0, _delay_0 = crossing(_margin_0, 0.0, _rate_0, _ceiling_0, _room_0)
    _possible_0, = timely(_arrives_0, _delay_0, _late_0, _time_0, _when_0)
    _margin_0, = end_margin(_apex_0, _extent_0, _speed_0, _position_error_0, _velocity_error_0, _p_gravity_0, _p_end_depth_0, _room_0)
    _doubt_0, = grazed(_apex_0, _doubt_0, _height_0, _margin_0)
    _doubt_1, = crossed(_arrives_0, _clearance_0, _doubt_0, _time_0)
    _doubt_1, _late_1 = tied(_arrives_0, _delay_0, _doubt_1, _late_0, _time_0, _when_0)
    _when_1, _which_1 = sooner(_arrives_0, 3.0, _time_0, _when_0, _which_0)
    _doubt_0 = _choose(_possible_0, _doubt_1, _doubt_0)
    _late_0 = _choose(_possible_0, _late_1, _late_0)
    _when_0 = _choose(_possible_0, _when_1, _when_0)
    _which_0 = _choose(_possible_0, _which_1, _which_0)
    _until_0, _pad_0 = horizon(_when_0, _speed_0, _p_gravity_0)
    _clear_0, = ring_clear(_until_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _extent_0, _speed_0, _position_error_0, _velocity_error_0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_gravity_0, _room_0)
    _open_0, = opens_in_flight(_clear_0, _kept_0)
    _rows1, _count2 = _rows(_open_0, shots)
    if _count2:
        _doubt_1 = _take(_doubt_0, _rows1)
        _extent_1 = _take(_extent_0, _rows1)
        _last_1 = _take(_last_0, _rows1)
        _late_1 = _take(_late_0, _rows1)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows1)
        _p_gravity_1 = _take(_p_gravity_0, _rows1)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows1)
        _p_wire_radius_1 = _take(_p_wire_radius_0, _rows1)
        _pad_1 = _take(_pad_0, _rows1)
        _position_error_1 = _take(_position_error_0, _rows1)
        _speed_1 = _take(_speed_0, _rows1)
        _until_1 = _take(_until_0, _rows1)
        _velocity_error_1 = _take(_velocity_error_0, _rows1)
        _vx_1 = _take(_vx_0, _rows1)
        _vy_1 = _take(_vy_0, _rows1)
        _vz_1 = _take(_vz_0, _rows1)
        _when_1 = _take(_when_0, _rows1)
        _which_1 = _take(_which_0, _rows1)
        _x_1 = _take(_x_0, _rows1)
        _y_1 = _take(_y_0, _rows1)
        _z_1 = _take(_z_0, _rows1)
        _room_1 = room(_count2)
        _share_1, _arrival_1, _certain_1 = beginning()
        _leaving_1, = left(0.0, _last_1)
        _onset_1, _wide_end_1, _searching_1, _wide_low1_1, _wide_high1_1, _wide_low2_1, _wide_high2_1, _lapsed_1, _sound_1 = ring_opened(_until_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _since_1, _latest_1 = opened(_double(_lapsed_1), _double(_onset_1))
        _rho_start_1, _parting_1, _drift_1 = ring_started(_x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ring_radius_1, _room_1)
        _near_x_1, _near_y_1, _near_z_1, _, _, _near_vz_1 = flight(_since_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_gravity_1, _room_1)
        _short_share_1, _short_t_1, _short_end_1, _short_x_1, _short_y_1, _short_z_1, _short_vx_1, _short_vy_1, _short_vz_1, _short_steady_1, _short_swing_1, _short_rho_start_1, _short_ceiling_1, _short_flat_1, _short_tilt_1, _short_jerk_1, _short_grit_1, _short_parting_1, _short_drift_1, _short_rate_margin_1, _short_low1_1, _short_high1_1, _short_low2_1, _short_high2_1, _fits_1 = ring_grain(_onset_1, _wide_end_1, _leaving_1, _lapsed_1, _near_x_1, _near_y_1, _near_z_1, _vx_1, _vy_1, _near_vz_1, _extent_1, _speed_1, _parting_1, _drift_1, _wide_low1_1, _wide_high1_1, _wide_low2_1, _wide_high2_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _leaping_1, _searching_1, _served_1, _ceiling_1, _flat_1, _tilt_1, _allowing_1 = coarse(_double(_short_ceiling_1), _fits_1, _double(_short_flat_1), _double(_short_rate_margin_1), _searching_1, _double(_short_share_1), _sound_1)
        _, _, _excess_1 = allowance(_allowing_1, _latest_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_gravity_1, _room_1)
        _lost_1, = ring_lost(_until_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _doubt_1, = beyond(_doubt_1, _excess_1, _late_1, _lost_1, _pad_1)
        _rows3, _count4 = _rows(_leaping_1, _count2)
        if _count4:
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows3)
            _p_gravity_2 = _take(_p_gravity_1, _rows3)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows3)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows3)
            _short_ceiling_2 = _take(_short_ceiling_1, _rows3)
            _short_drift_2 = _take(_short_drift_1, _rows3)
            _short_end_2 = _take(_short_end_1, _rows3)
            _short_flat_2 = _take(_short_flat_1, _rows3)
            _short_grit_2 = _take(_short_grit_1, _rows3)
            _short_high1_2 = _take(_short_high1_1, _rows3)
            _short_high2_2 = _take(_short_high2_1, _rows3)
            _short_jerk_2 = _take(_short_jerk_1, _rows3)
            _short_low1_2 = _take(_short_low1_1, _rows3)
            _short_low2_2 = _take(_short_low2_1, _rows3)
            _short_parting_2 = _take(_short_parting_1, _rows3)
            _short_rate_margin_2 = _take(_short_rate_margin_1, _rows3)
            _short_rho_start_2 = _take(_short_rho_start_1, _rows3)
            _short_steady_2 = _take(_short_steady_1, _rows3)
            _short_swing_2 = _take(_short_swing_1, _rows3)
            _short_t_2 = _take(_short_t_1, _rows3)
            _short_tilt_2 = _take(_short_tilt_1, _rows3)
            _short_vx_2 = _take(_short_vx_1, _rows3)
            _short_vy_2 = _take(_short_vy_1, _rows3)
            _short_vz_2 = _take(_short_vz_1, _rows3)
            _short_x_2 = _take(_short_x_1, _rows3)
            _short_y_2 = _take(_short_y_1, _rows3)
            _short_z_2 = _take(_short_z_1, _rows3)
            _room_2 = room(_count4)
            _short_t_2, _short_end_2, _certain_2, _leaping_2 = ring_leap(_short_t_2, _short_end_2, _short_rate_margin_2, _short_ceiling_2, _short_x_2, _short_y_2, _short_z_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_steady_2, _short_swing_2, _short_rho_start_2, _short_flat_2, _short_tilt_2, _short_grit_2, _short_jerk_2, _short_parting_2, _short_drift_2, _short_low1_2, _short_high1_2, _short_low2_2, _short_high2_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _certain_1 = _put(_certain_1, _rows3, _certain_2, _count2)
            _leaping_1 = _put(_leaping_1, _rows3, _leaping_2, _count2)
            _short_end_1 = _put(_short_end_1, _rows3, _short_end_2, _count2)
            _short_t_1 = _put(_short_t_1, _rows3, _short_t_2, _count2)
        _rows5, _count6 = _rows(_leaping_1, _count2)
        if _count6:
            _leaping_2 = _take(_leaping_1, _rows5)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows5)
            _p_gravity_2 = _take(_p_gravity_1, _rows5)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows5)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows5)
            _short_ceiling_2 = _take(_short_ceiling_1, _rows5)
            _short_drift_2 = _take(_short_drift_1, _rows5)
            _short_end_2 = _take(_short_end_1, _rows5)
            _short_flat_2 = _take(_short_flat_1, _rows5)
            _short_grit_2 = _take(_short_grit_1, _rows5)
            _short_high1_2 = _take(_short_high1_1, _rows5)
            _short_high2_2 = _take(_short_high2_1, _rows5)
            _short_jerk_2 = _take(_short_jerk_1, _rows5)
            _short_low1_2 = _take(_short_low1_1, _rows5)
            _short_low2_2 = _take(_short_low2_1, _rows5)
            _short_parting_2 = _take(_short_parting_1, _rows5)
            _short_rate_margin_2 = _take(_short_rate_margin_1, _rows5)
            _short_rho_start_2 = _take(_short_rho_start_1, _rows5)
            _short_steady_2 = _take(_short_steady_1, _rows5)
            _short_swing_2 = _take(_short_swing_1, _rows5)
            _short_t_2 = _take(_short_t_1, _rows5)
            _short_tilt_2 = _take(_short_tilt_1, _rows5)
            _short_vx_2 = _take(_short_vx_1, _rows5)
            _short_vy_2 = _take(_short_vy_1, _rows5)
            _short_vz_2 = _take(_short_vz_1, _rows5)
            _short_x_2 = _take(_short_x_1, _rows5)
            _short_y_2 = _take(_short_y_1, _rows5)
            _short_z_2 = _take(_short_z_1, _rows5)
            _certain_1 = _copy(_certain_1, _count2)
            _short_t_1 = _copy(_short_t_1, _count2)
            for _ in range(24):
                _room_2 = room(_count6)
                _short_t_2, _short_end_2, _certain_2, _leaping_2 = ring_leap(_short_t_2, _short_end_2, _short_rate_margin_2, _short_ceiling_2, _short_x_2, _short_y_2, _short_z_2, _short_vx_2, _short_vy_2, _short_vz_2, _short_steady_2, _short_swing_2, _short_rho_start_2, _short_flat_2, _short_tilt_2, _short_grit_2, _short_jerk_2, _short_parting_2, _short_drift_2, _short_low1_2, _short_high1_2, _short_low2_2, _short_high2_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
                _going7 = _where_true(_leaping_2)
                if len(_going7) == _count6:
                    continue
                _done = _where_true(_logical_not(_leaping_2))
                _store(_certain_1, _of(_rows5, _done), _certain_2, _done)
                _store(_short_t_1, _of(_rows5, _done), _short_t_2, _done)
                _rows5, _count6 = _of(_rows5, _going7), len(_going7)
                if not _count6:
                    break
                _certain_2 = _take(_certain_2, _going7)
                _leaping_2 = _take(_leaping_2, _going7)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going7)
                _p_gravity_2 = _take(_p_gravity_2, _going7)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going7)
                _p_wire_radius_2 = _take(_p_wire_radius_2, _going7)
                _short_ceiling_2 = _take(_short_ceiling_2, _going7)
                _short_drift_2 = _take(_short_drift_2, _going7)
                _short_end_2 = _take(_short_end_2, _going7)
                _short_flat_2 = _take(_short_flat_2, _going7)
                _short_grit_2 = _take(_short_grit_2, _going7)
                _short_high1_2 = _take(_short_high1_2, _going7)
                _short_high2_2 = _take(_short_high2_2, _going7)
                _short_jerk_2 = _take(_short_jerk_2, _going7)
                _short_low1_2 = _take(_short_low1_2, _going7)
                _short_low2_2 = _take(_short_low2_2, _going7)
                _short_parting_2 = _take(_short_parting_2, _going7)
                _short_rate_margin_2 = _take(_short_rate_margin_2, _going7)
                _short_rho_start_2 = _take(_short_rho_start_2, _going7)
                _short_steady_2 = _take(_short_steady_2, _going7)
                _short_swing_2 = _take(_short_swing_2, _going7)
                _short_t_2 = _take(_short_t_2, _going7)
                _short_tilt_2 = _take(_short_tilt_2, _going7)
                _short_vx_2 = _take(_short_vx_2, _going7)
                _short_vy_2 = _take(_short_vy_2, _going7)
                _short_vz_2 = _take(_short_vz_2, _going7)
                _short_x_2 = _take(_short_x_2, _going7)
                _short_y_2 = _take(_short_y_2, _going7)
                _short_z_2 = _take(_short_z_2, _going7)
            else:
                _store(_certain_1, _rows5, _certain_2, None)
                _store(_short_t_1, _rows5, _short_t_2, None)
        _arrival_1, _t_1, _searching_1 = leapt(_arrival_1, _certain_1, _double(_short_t_1), _searching_1, _served_1, _since_1)
        _rows8, _count9 = _rows(_searching_1, _count2)
        if _count9:
            _arrival_2 = _take(_arrival_1, _rows8)
            _certain_2 = _take(_certain_1, _rows8)
            _doubt_2 = _take(_doubt_1, _rows8)
            _extent_2 = _take(_extent_1, _rows8)
            _last_2 = _take(_last_1, _rows8)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows8)
            _p_gravity_2 = _take(_p_gravity_1, _rows8)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows8)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows8)
            _position_error_2 = _take(_position_error_1, _rows8)
            _share_2 = _take(_share_1, _rows8)
            _speed_2 = _take(_speed_1, _rows8)
            _t_2 = _take(_t_1, _rows8)
            _until_2 = _take(_until_1, _rows8)
            _velocity_error_2 = _take(_velocity_error_1, _rows8)
            _vx_2 = _take(_vx_1, _rows8)
            _vy_2 = _take(_vy_1, _rows8)
            _vz_2 = _take(_vz_1, _rows8)
            _x_2 = _take(_x_1, _rows8)
            _y_2 = _take(_y_1, _rows8)
            _z_2 = _take(_z_1, _rows8)
            _room_2 = room(_count9)
            _steady_2, _swing_2, _rho_start_2, _low0_2, _high0_2, _low1_2, _high1_2, _low2_2, _high2_2, _ceiling_2, _latest_2, *_ = ring_prepare(_until_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _extent_2, _speed_2, _position_error_2, _velocity_error_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _position_level_2, _velocity_level_2, *_ = allowance(_share_2, _latest_2, _extent_2, _speed_2, _position_error_2, _velocity_error_2, _p_gravity_2, _room_2)
            _flat_2, _tilt_2, _rate_slack_2 = ring_margins(_latest_2, _extent_2, _speed_2, _position_level_2, _velocity_level_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _t_2, _end_2, _searching_2 = ring_enter(_t_2, 0.0, _high0_2, _high1_2, _high2_2, _low0_2, _low1_2, _low2_2, _t_2, _room_2)
            _rows10, _count11 = _rows(_searching_2, _count9)
            if _count11:
                _arrival_3 = _take(_arrival_2, _rows10)
                _ceiling_3 = _take(_ceiling_2, _rows10)
                _certain_3 = _take(_certain_2, _rows10)
                _doubt_3 = _take(_doubt_2, _rows10)
                _end_3 = _take(_end_2, _rows10)
                _flat_3 = _take(_flat_2, _rows10)
                _last_3 = _take(_last_2, _rows10)
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows10)
                _p_gravity_3 = _take(_p_gravity_2, _rows10)
                _p_ring_radius_3 = _take(_p_ring_radius_2, _rows10)
                _p_wire_radius_3 = _take(_p_wire_radius_2, _rows10)
                _rate_slack_3 = _take(_rate_slack_2, _rows10)
                _rho_start_3 = _take(_rho_start_2, _rows10)
                _searching_3 = _take(_searching_2, _rows10)
                _share_3 = _take(_share_2, _rows10)
                _steady_3 = _take(_steady_2, _rows10)
                _swing_3 = _take(_swing_2, _rows10)
                _t_3 = _take(_t_2, _rows10)
                _tilt_3 = _take(_tilt_2, _rows10)
                _vx_3 = _take(_vx_2, _rows10)
                _vy_3 = _take(_vy_2, _rows10)
                _vz_3 = _take(_vz_2, _rows10)
                _x_3 = _take(_x_2, _rows10)
                _y_3 = _take(_y_2, _rows10)
                _z_3 = _take(_z_2, _rows10)
                _arrival_2 = _copy(_arrival_2, _count9)
                _certain_2 = _copy(_certain_2, _count9)
                _doubt_2 = _copy(_doubt_2, _count9)
                _flat_2 = _copy(_flat_2, _count9)
                _searching_2 = _copy(_searching_2, _count9)
                _t_2 = _copy(_t_2, _count9)
                _tilt_2 = _copy(_tilt_2, _count9)
                for _ in range(201):
                    _room_3 = room(_count11)
                    _leaving_3, _margin_3 = nearby(_flat_3, 0.0, _last_3, _t_3, _tilt_3)
                    _gap_3, _rate_3, _bend_3, _step_3, _next_3, _clearance_3 = ring_advance(_t_3, _end_3, _leaving_3, _margin_3, _rate_slack_3, _ceiling_3, _x_3, _y_3, _z_3, _vx_3, _vy_3, _vz_3, _steady_3, _swing_3, _rho_start_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_gravity_3, _room_3)
                    _hit_3, _sure_3, _vague_3 = struck(_bend_3, _clearance_3, _gap_3, _margin_3, _rate_3, _rate_slack_3, _share_3)
                    _rows12, _count13 = _rows(_vague_3, _count11)
                    if _count13:
                        _far = _of(_rows10, _rows12)
                        _doubt_4 = _take(_doubt_3, _rows12)
                        _extent_4 = _take(_extent_2, _far)
                        _latest_4 = _take(_latest_2, _far)
                        _p_ball_radius_4 = _take(_p_ball_radius_3, _rows12)
                        _p_gravity_4 = _take(_p_gravity_3, _rows12)
                        _p_ring_radius_4 = _take(_p_ring_radius_3, _rows12)
                        _p_wire_radius_4 = _take(_p_wire_radius_3, _rows12)
                        _position_error_4 = _take(_position_error_2, _far)
                        _share_4 = _take(_share_3, _rows12)
                        _speed_4 = _take(_speed_2, _far)
                        _t_4 = _take(_t_3, _rows12)
                        _velocity_error_4 = _take(_velocity_error_2, _far)
                        _room_4 = room(_count13)
                        _share_4, = finer(_share_4)
                        _position_level_4, _velocity_level_4, _excess_4 = allowance(_share_4, _latest_4, _extent_4, _speed_4, _position_error_4, _velocity_error_4, _p_gravity_4, _room_4)
                        _flat_4, _tilt_4, _rate_slack_4 = ring_margins(_latest_4, _extent_4, _speed_4, _position_level_4, _velocity_level_4, _p_ball_radius_4, _p_ring_radius_4, _p_wire_radius_4, _p_gravity_4, _room_4)
                        _doubt_4, = exceeded(_doubt_4, _excess_4, _t_4)
                        _doubt_3 = _put(_doubt_3, _rows12, _doubt_4, _count11)
                        _flat_3 = _put(_flat_3, _rows12, _flat_4, _count11)
                        _rate_slack_3 = _put(_rate_slack_3, _rows12, _rate_slack_4, _count11)
                        _share_3 = _put(_share_3, _rows12, _share_4, _count11)
                        _tilt_3 = _put(_tilt_3, _rows12, _tilt_4, _count11)
                    _arrival_3, _certain_3, _exhausted_3, _searching_3, _t_3 = advanced(_arrival_3, _certain_3, _end_3, _hit_3, _next_3, _step_3, _sure_3, _t_3, _vague_3)
                    _rows14, _count15 = _rows(_exhausted_3, _count11)
                    if _count15:
                        _far = _of(_rows10, _rows14)
                        _end_4 = _take(_end_3, _rows14)
                        _high0_4 = _take(_high0_2, _far)
                        _high1_4 = _take(_high1_2, _far)
                        _high2_4 = _take(_high2_2, _far)
                        _low0_4 = _take(_low0_2, _far)
                        _low1_4 = _take(_low1_2, _far)
                        _low2_4 = _take(_low2_2, _far)
                        _t_4 = _take(_t_3, _rows14)
                        _room_4 = room(_count15)
                        _t_4, _end_4, _searching_4 = ring_enter(_end_4, _end_4, _high0_4, _high1_4, _high2_4, _low0_4, _low1_4, _low2_4, _t_4, _room_4)
                        _end_3 = _put(_end_3, _rows14, _end_4, _count11)
                        _searching_3 = _put(_searching_3, _rows14, _searching_4, _count11)
                        _t_3 = _put(_t_3, _rows14, _t_4, _count11)
                    _going16 = _where_true(_searching_3)
                    if len(_going16) == _count11:
                        continue
                    _done = _where_true(_logical_not(_searching_3))
                    _store(_arrival_2, _of(_rows10, _done), _arrival_3, _done)
                    _store(_certain_2, _of(_rows10, _done), _certain_3, _done)
                    _store(_doubt_2, _of(_rows10, _done), _doubt_3, _done)
                    _store(_flat_2, _of(_rows10, _done), _flat_3, _done)
                    _store(_searching_2, _of(_rows10, _done), _searching_3, _done)
                    _store(_t_2, _of(_rows10, _done), _t_3, _done)
                    _store(_tilt_2, _of(_rows10, _done), _tilt_3, _done)
                    _rows10, _count11 = _of(_rows10, _going16), len(_going16)
                    if not _count11:
                        break
                    _arrival_3 = _take(_arrival_3, _going16)
                    _ceiling_3 = _take(_ceiling_3, _going16)
                    _certain_3 = _take(_certain_3, _going16)
                    _doubt_3 = _take(_doubt_3, _going16)
                    _end_3 = _take(_end_3, _going16)
                    _flat_3 = _take(_flat_3, _going16)
                    _last_3 = _take(_last_3, _going16)
                    _p_ball_radius_3 = _take(_p_ball_radius_3, _going16)
                    _p_gravity_3 = _take(_p_gravity_3, _going16)
                    _p_ring_radius_3 = _take(_p_ring_radius_3, _going16)
                    _p_wire_radius_3 = _take(_p_wire_radius_3, _going16)
                    _rate_slack_3 = _take(_rate_slack_3, _going16)
                    _rho_start_3 = _take(_rho_start_3, _going16)
                    _searching_3 = _take(_searching_3, _going16)
                    _share_3 = _take(_share_3, _going16)
                    _steady_3 = _take(_steady_3, _going16)
                    _swing_3 = _take(_swing_3, _going16)
                    _t_3 = _take(_t_3, _going16)
                    _tilt_3 = _take(_tilt_3, _going16)
                    _vx_3 = _take(_vx_3, _going16)
                    _vy_3 = _take(_vy_3, _going16)
                    _vz_3 = _take(_vz_3, _going16)
                    _x_3 = _take(_x_3, _going16)
                    _y_3 = _take(_y_3, _going16)
                    _z_3 = _take(_z_3, _going16)
                else:
                    _store(_arrival_2, _rows10, _arrival_3, None)
                    _store(_certain_2, _rows10, _certain_3, None)
                    _store(_doubt_2, _rows10, _doubt_3, None)
                    _store(_flat_2, _rows10, _flat_3, None)
                    _store(_searching_2, _rows10, _searching_3, None)
                    _store(_t_2, _rows10, _t_3, None)
                    _store(_tilt_2, _rows10, _tilt_3, None)
            _doubt_2, = questioned(_doubt_2, _t_2, _searching_2)
            _arrival_1 = _put(_arrival_1, _rows8, _arrival_2, _count2)
            _ceiling_1 = _put(_ceiling_1, _rows8, _ceiling_2, _count2)
            _certain_1 = _put(_certain_1, _rows8, _certain_2, _count2)
            _doubt_1 = _put(_doubt_1, _rows8, _doubt_2, _count2)
            _flat_1 = _put(_flat_1, _rows8, _flat_2, _count2)
            _latest_1 = _put(_latest_1, _rows8, _latest_2, _count2)
            _rho_start_1 = _put(_rho_start_1, _rows8, _rho_start_2, _count2)
            _tilt_1 = _put(_tilt_1, _rows8, _tilt_2, _count2)
        _arrives_1, _refining_1, _rate_1 = found(_arrival_1)
        _leaving_1, *_ = nearby(_flat_1, 0.0, _last_1, _arrival_1, _tilt_1)
        _rows17, _count18 = _rows(_refining_1, _count2)
        if _count18:
            _arrival_2 = _take(_arrival_1, _rows17)
            _ceiling_2 = _take(_ceiling_1, _rows17)
            _certain_2 = _take(_certain_1, _rows17)
            _leaving_2 = _take(_leaving_1, _rows17)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows17)
            _p_gravity_2 = _take(_p_gravity_1, _rows17)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows17)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows17)
            _rho_start_2 = _take(_rho_start_1, _rows17)
            _vx_2 = _take(_vx_1, _rows17)
            _vy_2 = _take(_vy_1, _rows17)
            _vz_2 = _take(_vz_1, _rows17)
            _x_2 = _take(_x_1, _rows17)
            _y_2 = _take(_y_1, _rows17)
            _z_2 = _take(_z_1, _rows17)
            _room_2 = room(_count18)
            _refined_2, _gap_2, _rate_2 = ring_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _rho_start_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
            _arrival_1 = _put(_arrival_1, _rows17, _arrival_2, _count2)
            _rate_1 = _put(_rate_1, _rows17, _rate_2, _count2)
            _refining_1 = _put(_refining_1, _rows17, _refining_2, _count2)
        _rows19, _count20 = _rows(_refining_1, _count2)
        if _count20:
            _arrival_2 = _take(_arrival_1, _rows19)
            _ceiling_2 = _take(_ceiling_1, _rows19)
            _certain_2 = _take(_certain_1, _rows19)
            _leaving_2 = _take(_leaving_1, _rows19)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows19)
            _p_gravity_2 = _take(_p_gravity_1, _rows19)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows19)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows19)
            _rho_start_2 = _take(_rho_start_1, _rows19)
            _vx_2 = _take(_vx_1, _rows19)
            _vy_2 = _take(_vy_1, _rows19)
            _vz_2 = _take(_vz_1, _rows19)
            _x_2 = _take(_x_1, _rows19)
            _y_2 = _take(_y_1, _rows19)
            _z_2 = _take(_z_1, _rows19)
            _room_2 = room(_count20)
            _refined_2, _gap_2, _rate_2 = ring_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _rho_start_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
            _arrival_1 = _put(_arrival_1, _rows19, _arrival_2, _count2)
            _rate_1 = _put(_rate_1, _rows19, _rate_2, _count2)
            _refining_1 = _put(_refining_1, _rows19, _refining_2, _count2)
        _rows21, _count22 = _rows(_refining_1, _count2)
        if _count22:
            _arrival_2 = _take(_arrival_1, _rows21)
            _ceiling_2 = _take(_ceiling_1, _rows21)
            _certain_2 = _take(_certain_1, _rows21)
            _leaving_2 = _take(_leaving_1, _rows21)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows21)
            _p_gravity_2 = _take(_p_gravity_1, _rows21)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows21)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows21)
            _refining_2 = _take(_refining_1, _rows21)
            _rho_start_2 = _take(_rho_start_1, _rows21)
            _vx_2 = _take(_vx_1, _rows21)
            _vy_2 = _take(_vy_1, _rows21)
            _vz_2 = _take(_vz_1, _rows21)
            _x_2 = _take(_x_1, _rows21)
            _y_2 = _take(_y_1, _rows21)
            _z_2 = _take(_z_1, _rows21)
            _arrival_1 = _copy(_arrival_1, _count2)
            _rate_1 = _copy(_rate_1, _count2)
            for _ in range(8):
                _room_2 = room(_count22)
                _refined_2, _gap_2, _rate_2 = ring_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _rho_start_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2, _room_2)
                _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
                _going23 = _where_true(_refining_2)
                if len(_going23) == _count22:
                    continue
                _done = _where_true(_logical_not(_refining_2))
                _store(_arrival_1, _of(_rows21, _done), _arrival_2, _done)
                _store(_rate_1, _of(_rows21, _done), _rate_2, _done)
                _rows21, _count22 = _of(_rows21, _going23), len(_going23)
                if not _count22:
                    break
                _arrival_2 = _take(_arrival_2, _going23)
                _ceiling_2 = _take(_ceiling_2, _going23)
                _certain_2 = _take(_certain_2, _going23)
                _leaving_2 = _take(_leaving_2, _going23)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going23)
                _p_gravity_2 = _take(_p_gravity_2, _going23)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going23)
                _p_wire_radius_2 = _take(_p_wire_radius_2, _going23)
                _rate_2 = _take(_rate_2, _going23)
                _refining_2 = _take(_refining_2, _going23)
                _rho_start_2 = _take(_rho_start_2, _going23)
                _vx_2 = _take(_vx_2, _going23)
                _vy_2 = _take(_vy_2, _going23)
                _vz_2 = _take(_vz_2, _going23)
                _x_2 = _take(_x_2, _going23)
                _y_2 = _take(_y_2, _going23)
                _z_2 = _take(_z_2, _going23)
            else:
                _store(_arrival_1, _rows21, _arrival_2, None)
                _store(_rate_1, _rows21, _rate_2, None)
        _flat_1, _tilt_1, _rate_margin_1 = ring_margins(_latest_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1, _room_1)
        _margin_1, = own_margin(_arrival_1, _flat_1, _leaving_1, _tilt_1)
        _clearance_1, _delay_1 = crossing(_margin_1, _rate_margin_1, _rate_1, _ceiling_1, _room_1)
        _time_1, = landed(_arrival_1)
        _delay_1, _doubt_1 = landed_surely(_arrives_1, _certain_1, _clearance_1, _delay_1, _doubt_1, _time_1)
        _doubt_1, _late_1 = tied(_arrives_1, _delay_1, _doubt_1, _late_1, _time_1, _when_1)
        _when_1, _which_1 = sooner(_arrives_1, 0.0, _time_1, _when_1, _which_1)
        _doubt_0 = _put(_doubt_0, _rows1, _doubt_1, shots)
        _late_0 = _put(_late_0, _rows1, _late_1, shots)
        _when_0 = _put(_when_0, _rows1, _when_1, shots)
        _which_0 = _put(_which_0, _rows1, _which_1, shots)
    _until_0, _pad_0 = horizon(_when_0, _speed_0, _p_gravity_0)
    _middle_x_0, _reach_x_0, _later_middle_x_0, _later_reach_x_0, _middle_y_0, _reach_y_0, _later_middle_y_0, _later_reach_y_0, _middle_z_0, _reach_z_0, _later_middle_z_0, _later_reach_z_0 = halved(_until_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _extent_0, _speed_0, _position_error_0, _velocity_error_0, _late_0, _pad_0, _p_gravity_0, _room_0)
    _reachable_0, = backboard_near(_middle_x_0, _middle_y_0, _middle_z_0, _reach_x_0, _reach_y_0, _reach_z_0, _later_middle_x_0, _later_middle_y_0, _later_middle_z_0, _later_reach_x_0, _later_reach_y_0, _later_reach_z_0, _p_ball_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_board_thickness_0, _room_0)
    _reachable_0, = reachable_in_flight(_kept_0, _reachable_0)
    _rows24, _count25 = _rows(_reachable_0, shots)
    if _count25:
        _doubt_1 = _take(_doubt_0, _rows24)
        _extent_1 = _take(_extent_0, _rows24)
        _last_1 = _take(_last_0, _rows24)
        _late_1 = _take(_late_0, _rows24)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows24)
        _p_board_bottom_1 = _take(_p_board_bottom_0, _rows24)
        _p_board_distance_1 = _take(_p_board_distance_0, _rows24)
        _p_board_half_width_1 = _take(_p_board_half_width_0, _rows24)
        _p_board_thickness_1 = _take(_p_board_thickness_0, _rows24)
        _p_board_top_1 = _take(_p_board_top_0, _rows24)
        _p_gravity_1 = _take(_p_gravity_0, _rows24)
        _position_error_1 = _take(_position_error_0, _rows24)
        _speed_1 = _take(_speed_0, _rows24)
        _velocity_error_1 = _take(_velocity_error_0, _rows24)
        _vx_1 = _take(_vx_0, _rows24)
        _vy_1 = _take(_vy_0, _rows24)
        _vz_1 = _take(_vz_0, _rows24)
        _when_1 = _take(_when_0, _rows24)
        _which_1 = _take(_which_0, _rows24)
        _x_1 = _take(_x_0, _rows24)
        _y_1 = _take(_y_0, _rows24)
        _z_1 = _take(_z_0, _rows24)
        _room_1 = room(_count25)
        _until_1, _pad_1 = horizon(_when_1, _speed_1, _p_gravity_1)
        _low0_1, _high0_1, _low1_1, _high1_1, _ceiling_1, _latest_1, _lost_1 = backboard_prepare(_until_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _p_gravity_1, _room_1)
        _share_1, _arrival_1, _certain_1 = beginning()
        _position_level_1, _velocity_level_1, _excess_1 = allowance(_share_1, _latest_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_gravity_1, _room_1)
        _flat_1, _tilt_1, _rate_slack_1 = backboard_margins(_latest_1, _extent_1, _speed_1, _position_level_1, _velocity_level_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _p_gravity_1, _room_1)
        _t_1, _end_1, _searching_1 = backboard_enter(0.0, 0.0, _high0_1, _high1_1, _low0_1, _low1_1, 0.0)
        _doubt_1, = beyond_windows(_doubt_1, _excess_1, _late_1, _lost_1, _pad_1, _searching_1)
        _rows26, _count27 = _rows(_searching_1, _count25)
        if _count27:
            _arrival_2 = _take(_arrival_1, _rows26)
            _ceiling_2 = _take(_ceiling_1, _rows26)
            _certain_2 = _take(_certain_1, _rows26)
            _doubt_2 = _take(_doubt_1, _rows26)
            _end_2 = _take(_end_1, _rows26)
            _extent_2 = _take(_extent_1, _rows26)
            _flat_2 = _take(_flat_1, _rows26)
            _high0_2 = _take(_high0_1, _rows26)
            _high1_2 = _take(_high1_1, _rows26)
            _last_2 = _take(_last_1, _rows26)
            _latest_2 = _take(_latest_1, _rows26)
            _low0_2 = _take(_low0_1, _rows26)
            _low1_2 = _take(_low1_1, _rows26)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows26)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows26)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows26)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows26)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows26)
            _p_board_top_2 = _take(_p_board_top_1, _rows26)
            _p_gravity_2 = _take(_p_gravity_1, _rows26)
            _position_error_2 = _take(_position_error_1, _rows26)
            _rate_slack_2 = _take(_rate_slack_1, _rows26)
            _share_2 = _take(_share_1, _rows26)
            _speed_2 = _take(_speed_1, _rows26)
            _t_2 = _take(_t_1, _rows26)
            _tilt_2 = _take(_tilt_1, _rows26)
            _velocity_error_2 = _take(_velocity_error_1, _rows26)
            _vx_2 = _take(_vx_1, _rows26)
            _vy_2 = _take(_vy_1, _rows26)
            _vz_2 = _take(_vz_1, _rows26)
            _x_2 = _take(_x_1, _rows26)
            _y_2 = _take(_y_1, _rows26)
            _z_2 = _take(_z_1, _rows26)
            _room_2 = room(_count27)
            _leaving_2, _margin_2 = nearby(_flat_2, 1.0, _last_2, _t_2, _tilt_2)
            _gap_2, _rate_2, _bend_2, _step_2, _next_2, _clearance_2 = backboard_advance(_t_2, _end_2, _leaving_2, _margin_2, _rate_slack_2, _ceiling_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _p_gravity_2, _room_2)
            _hit_2, _sure_2, _vague_2 = struck_or_still(_bend_2, _clearance_2, _end_2, _gap_2, _margin_2, _next_2, _rate_2, _rate_slack_2, _share_2, _t_2)
            _rows28, _count29 = _rows(_vague_2, _count27)
            if _count29:
                _doubt_3 = _take(_doubt_2, _rows28)
                _extent_3 = _take(_extent_2, _rows28)
                _latest_3 = _take(_latest_2, _rows28)
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows28)
                _p_board_bottom_3 = _take(_p_board_bottom_2, _rows28)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows28)
                _p_board_half_width_3 = _take(_p_board_half_width_2, _rows28)
                _p_board_thickness_3 = _take(_p_board_thickness_2, _rows28)
                _p_board_top_3 = _take(_p_board_top_2, _rows28)
                _p_gravity_3 = _take(_p_gravity_2, _rows28)
                _position_error_3 = _take(_position_error_2, _rows28)
                _share_3 = _take(_share_2, _rows28)
                _speed_3 = _take(_speed_2, _rows28)
                _t_3 = _take(_t_2, _rows28)
                _velocity_error_3 = _take(_velocity_error_2, _rows28)
                _room_3 = room(_count29)
                _share_3, = finer(_share_3)
                _position_level_3, _velocity_level_3, _excess_3 = allowance(_share_3, _latest_3, _extent_3, _speed_3, _position_error_3, _velocity_error_3, _p_gravity_3, _room_3)
                _flat_3, _tilt_3, _rate_slack_3 = backboard_margins(_latest_3, _extent_3, _speed_3, _position_level_3, _velocity_level_3, _p_ball_radius_3, _p_board_distance_3, _p_board_half_width_3, _p_board_bottom_3, _p_board_top_3, _p_board_thickness_3, _p_gravity_3, _room_3)
                _doubt_3, = exceeded(_doubt_3, _excess_3, _t_3)
                _doubt_2 = _put(_doubt_2, _rows28, _doubt_3, _count27)
                _flat_2 = _put(_flat_2, _rows28, _flat_3, _count27)
                _rate_slack_2 = _put(_rate_slack_2, _rows28, _rate_slack_3, _count27)
                _share_2 = _put(_share_2, _rows28, _share_3, _count27)
                _tilt_2 = _put(_tilt_2, _rows28, _tilt_3, _count27)
            _arrival_2, _certain_2, _exhausted_2, _searching_2, _t_2 = advanced(_arrival_2, _certain_2, _end_2, _hit_2, _next_2, _step_2, _sure_2, _t_2, _vague_2)
            _t_3, _end_3, _searching_3 = backboard_enter(_end_2, _end_2, _high0_2, _high1_2, _low0_2, _low1_2, _t_2)
            _end_2 = _choose(_exhausted_2, _end_3, _end_2)
            _searching_2 = _choose(_exhausted_2, _searching_3, _searching_2)
            _t_2 = _choose(_exhausted_2, _t_3, _t_2)
            _arrival_1 = _put(_arrival_1, _rows26, _arrival_2, _count25)
            _certain_1 = _put(_certain_1, _rows26, _certain_2, _count25)
            _doubt_1 = _put(_doubt_1, _rows26, _doubt_2, _count25)
            _end_1 = _put(_end_1, _rows26, _end_2, _count25)
            _flat_1 = _put(_flat_1, _rows26, _flat_2, _count25)
            _rate_slack_1 = _put(_rate_slack_1, _rows26, _rate_slack_2, _count25)
            _searching_1 = _put(_searching_1, _rows26, _searching_2, _count25)
            _share_1 = _put(_share_1, _rows26, _share_2, _count25)
            _t_1 = _put(_t_1, _rows26, _t_2, _count25)
            _tilt_1 = _put(_tilt_1, _rows26, _tilt_2, _count25)
        _rows30, _count31 = _rows(_searching_1, _count25)
        if _count31:
            _arrival_2 = _take(_arrival_1, _rows30)
            _ceiling_2 = _take(_ceiling_1, _rows30)
            _certain_2 = _take(_certain_1, _rows30)
            _doubt_2 = _take(_doubt_1, _rows30)
            _end_2 = _take(_end_1, _rows30)
            _flat_2 = _take(_flat_1, _rows30)
            _last_2 = _take(_last_1, _rows30)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows30)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows30)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows30)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows30)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows30)
            _p_board_top_2 = _take(_p_board_top_1, _rows30)
            _p_gravity_2 = _take(_p_gravity_1, _rows30)
            _rate_slack_2 = _take(_rate_slack_1, _rows30)
            _searching_2 = _take(_searching_1, _rows30)
            _share_2 = _take(_share_1, _rows30)
            _t_2 = _take(_t_1, _rows30)
            _tilt_2 = _take(_tilt_1, _rows30)
            _vx_2 = _take(_vx_1, _rows30)
            _vy_2 = _take(_vy_1, _rows30)
            _vz_2 = _take(_vz_1, _rows30)
            _x_2 = _take(_x_1, _rows30)
            _y_2 = _take(_y_1, _rows30)
            _z_2 = _take(_z_1, _rows30)
            _arrival_1 = _copy(_arrival_1, _count25)
            _certain_1 = _copy(_certain_1, _count25)
            _doubt_1 = _copy(_doubt_1, _count25)
            _flat_1 = _copy(_flat_1, _count25)
            _searching_1 = _copy(_searching_1, _count25)
            _t_1 = _copy(_t_1, _count25)
            _tilt_1 = _copy(_tilt_1, _count25)
            for _ in range(201):
                _room_2 = room(_count31)
                _leaving_2, _margin_2 = nearby(_flat_2, 1.0, _last_2, _t_2, _tilt_2)
                _gap_2, _rate_2, _bend_2, _step_2, _next_2, _clearance_2 = backboard_advance(_t_2, _end_2, _leaving_2, _margin_2, _rate_slack_2, _ceiling_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _p_gravity_2, _room_2)
                _hit_2, _sure_2, _vague_2 = struck_or_still(_bend_2, _clearance_2, _end_2, _gap_2, _margin_2, _next_2, _rate_2, _rate_slack_2, _share_2, _t_2)
                _rows32, _count33 = _rows(_vague_2, _count31)
                if _count33:
                    _far = _of(_rows30, _rows32)
                    _doubt_3 = _take(_doubt_2, _rows32)
                    _extent_3 = _take(_extent_1, _far)
                    _latest_3 = _take(_latest_1, _far)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows32)
                    _p_board_bottom_3 = _take(_p_board_bottom_2, _rows32)
                    _p_board_distance_3 = _take(_p_board_distance_2, _rows32)
                    _p_board_half_width_3 = _take(_p_board_half_width_2, _rows32)
                    _p_board_thickness_3 = _take(_p_board_thickness_2, _rows32)
                    _p_board_top_3 = _take(_p_board_top_2, _rows32)
                    _p_gravity_3 = _take(_p_gravity_2, _rows32)
                    _position_error_3 = _take(_position_error_1, _far)
                    _share_3 = _take(_share_2, _rows32)
                    _speed_3 = _take(_speed_1, _far)
                    _t_3 = _take(_t_2, _rows32)
                    _velocity_error_3 = _take(_velocity_error_1, _far)
                    _room_3 = room(_count33)
                    _share_3, = finer(_share_3)
                    _position_level_3, _velocity_level_3, _excess_3 = allowance(_share_3, _latest_3, _extent_3, _speed_3, _position_error_3, _velocity_error_3, _p_gravity_3, _room_3)
                    _flat_3, _tilt_3, _rate_slack_3 = backboard_margins(_latest_3, _extent_3, _speed_3, _position_level_3, _velocity_level_3, _p_ball_radius_3, _p_board_distance_3, _p_board_half_width_3, _p_board_bottom_3, _p_board_top_3, _p_board_thickness_3, _p_gravity_3, _room_3)
                    _doubt_3, = exceeded(_doubt_3, _excess_3, _t_3)
                    _doubt_2 = _put(_doubt_2, _rows32, _doubt_3, _count31)
                    _flat_2 = _put(_flat_2, _rows32, _flat_3, _count31)
                    _rate_slack_2 = _put(_rate_slack_2, _rows32, _rate_slack_3, _count31)
                    _share_2 = _put(_share_2, _rows32, _share_3, _count31)
                    _tilt_2 = _put(_tilt_2, _rows32, _tilt_3, _count31)
                _arrival_2, _certain_2, _exhausted_2, _searching_2, _t_2 = advanced(_arrival_2, _certain_2, _end_2, _hit_2, _next_2, _step_2, _sure_2, _t_2, _vague_2)
                _rows34, _count35 = _rows(_exhausted_2, _count31)
                if _count35:
                    _far = _of(_rows30, _rows34)
                    _end_3 = _take(_end_2, _rows34)
                    _high0_3 = _take(_high0_1, _far)
                    _high1_3 = _take(_high1_1, _far)
                    _low0_3 = _take(_low0_1, _far)
                    _low1_3 = _take(_low1_1, _far)
                    _t_3 = _take(_t_2, _rows34)
                    _t_3, _end_3, _searching_3 = backboard_enter(_end_3, _end_3, _high0_3, _high1_3, _low0_3, _low1_3, _t_3)
                    _end_2 = _put(_end_2, _rows34, _end_3, _count31)
                    _searching_2 = _put(_searching_2, _rows34, _searching_3, _count31)
                    _t_2 = _put(_t_2, _rows34, _t_3, _count31)
                _going36 = _where_true(_searching_2)
                if len(_going36) == _count31:
                    continue
                _done = _where_true(_logical_not(_searching_2))
                _store(_arrival_1, _of(_rows30, _done), _arrival_2, _done)
                _store(_certain_1, _of(_rows30, _done), _certain_2, _done)
                _store(_doubt_1, _of(_rows30, _done), _doubt_2, _done)
                _store(_flat_1, _of(_rows30, _done), _flat_2, _done)
                _store(_searching_1, _of(_rows30, _done), _searching_2, _done)
                _store(_t_1, _of(_rows30, _done), _t_2, _done)
                _store(_tilt_1, _of(_rows30, _done), _tilt_2, _done)
                _rows30, _count31 = _of(_rows30, _going36), len(_going36)
                if not _count31:
                    break
                _arrival_2 = _take(_arrival_2, _going36)
                _ceiling_2 = _take(_ceiling_2, _going36)
                _certain_2 = _take(_certain_2, _going36)
                _doubt_2 = _take(_doubt_2, _going36)
                _end_2 = _take(_end_2, _going36)
                _flat_2 = _take(_flat_2, _going36)
                _last_2 = _take(_last_2, _going36)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going36)
                _p_board_bottom_2 = _take(_p_board_bottom_2, _going36)
                _p_board_distance_2 = _take(_p_board_distance_2, _going36)
                _p_board_half_width_2 = _take(_p_board_half_width_2, _going36)
                _p_board_thickness_2 = _take(_p_board_thickness_2, _going36)
                _p_board_top_2 = _take(_p_board_top_2, _going36)
                _p_gravity_2 = _take(_p_gravity_2, _going36)
                _rate_slack_2 = _take(_rate_slack_2, _going36)
                _searching_2 = _take(_searching_2, _going36)
                _share_2 = _take(_share_2, _going36)
                _t_2 = _take(_t_2, _going36)
                _tilt_2 = _take(_tilt_2, _going36)
                _vx_2 = _take(_vx_2, _going36)
                _vy_2 = _take(_vy_2, _going36)
                _vz_2 = _take(_vz_2, _going36)
                _x_2 = _take(_x_2, _going36)
                _y_2 = _take(_y_2, _going36)
                _z_2 = _take(_z_2, _going36)
            else:
                _store(_arrival_1, _rows30, _arrival_2, None)
                _store(_certain_1, _rows30, _certain_2, None)
                _store(_doubt_1, _rows30, _doubt_2, None)
                _store(_flat_1, _rows30, _flat_2, None)
                _store(_searching_1, _rows30, _searching_2, None)
                _store(_t_1, _rows30, _t_2, None)
                _store(_tilt_1, _rows30, _tilt_2, None)
        _doubt_1, = questioned(_doubt_1, _t_1, _searching_1)
        _arrives_1, _refining_1, _rate_1 = found(_arrival_1)
        _leaving_1, *_ = nearby(_flat_1, 1.0, _last_1, _arrival_1, _tilt_1)
        _rows37, _count38 = _rows(_refining_1, _count25)
        if _count38:
            _arrival_2 = _take(_arrival_1, _rows37)
            _ceiling_2 = _take(_ceiling_1, _rows37)
            _certain_2 = _take(_certain_1, _rows37)
            _leaving_2 = _take(_leaving_1, _rows37)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows37)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows37)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows37)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows37)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows37)
            _p_board_top_2 = _take(_p_board_top_1, _rows37)
            _p_gravity_2 = _take(_p_gravity_1, _rows37)
            _vx_2 = _take(_vx_1, _rows37)
            _vy_2 = _take(_vy_1, _rows37)
            _vz_2 = _take(_vz_1, _rows37)
            _x_2 = _take(_x_1, _rows37)
            _y_2 = _take(_y_1, _rows37)
            _z_2 = _take(_z_1, _rows37)
            _room_2 = room(_count38)
            _refined_2, _gap_2, _rate_2 = backboard_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
            _arrival_1 = _put(_arrival_1, _rows37, _arrival_2, _count25)
            _rate_1 = _put(_rate_1, _rows37, _rate_2, _count25)
            _refining_1 = _put(_refining_1, _rows37, _refining_2, _count25)
        _rows39, _count40 = _rows(_refining_1, _count25)
        if _count40:
            _arrival_2 = _take(_arrival_1, _rows39)
            _ceiling_2 = _take(_ceiling_1, _rows39)
            _certain_2 = _take(_certain_1, _rows39)
            _leaving_2 = _take(_leaving_1, _rows39)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows39)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows39)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows39)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows39)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows39)
            _p_board_top_2 = _take(_p_board_top_1, _rows39)
            _p_gravity_2 = _take(_p_gravity_1, _rows39)
            _vx_2 = _take(_vx_1, _rows39)
            _vy_2 = _take(_vy_1, _rows39)
            _vz_2 = _take(_vz_1, _rows39)
            _x_2 = _take(_x_1, _rows39)
            _y_2 = _take(_y_1, _rows39)
            _z_2 = _take(_z_1, _rows39)
            _room_2 = room(_count40)
            _refined_2, _gap_2, _rate_2 = backboard_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
            _arrival_1 = _put(_arrival_1, _rows39, _arrival_2, _count25)
            _rate_1 = _put(_rate_1, _rows39, _rate_2, _count25)
            _refining_1 = _put(_refining_1, _rows39, _refining_2, _count25)
        _rows41, _count42 = _rows(_refining_1, _count25)
        if _count42:
            _arrival_2 = _take(_arrival_1, _rows41)
            _ceiling_2 = _take(_ceiling_1, _rows41)
            _certain_2 = _take(_certain_1, _rows41)
            _leaving_2 = _take(_leaving_1, _rows41)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows41)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows41)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows41)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows41)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows41)
            _p_board_top_2 = _take(_p_board_top_1, _rows41)
            _p_gravity_2 = _take(_p_gravity_1, _rows41)
            _refining_2 = _take(_refining_1, _rows41)
            _vx_2 = _take(_vx_1, _rows41)
            _vy_2 = _take(_vy_1, _rows41)
            _vz_2 = _take(_vz_1, _rows41)
            _x_2 = _take(_x_1, _rows41)
            _y_2 = _take(_y_1, _rows41)
            _z_2 = _take(_z_1, _rows41)
            _arrival_1 = _copy(_arrival_1, _count25)
            _rate_1 = _copy(_rate_1, _count25)
            for _ in range(8):
                _room_2 = room(_count42)
                _refined_2, _gap_2, _rate_2 = backboard_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _p_gravity_2, _room_2)
                _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
                _going43 = _where_true(_refining_2)
                if len(_going43) == _count42:
                    continue
                _done = _where_true(_logical_not(_refining_2))
                _store(_arrival_1, _of(_rows41, _done), _arrival_2, _done)
                _store(_rate_1, _of(_rows41, _done), _rate_2, _done)
                _rows41, _count42 = _of(_rows41, _going43), len(_going43)
                if not _count42:
                    break
                _arrival_2 = _take(_arrival_2, _going43)
                _ceiling_2 = _take(_ceiling_2, _going43)
                _certain_2 = _take(_certain_2, _going43)
                _leaving_2 = _take(_leaving_2, _going43)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going43)
                _p_board_bottom_2 = _take(_p_board_bottom_2, _going43)
                _p_board_distance_2 = _take(_p_board_distance_2, _going43)
                _p_board_half_width_2 = _take(_p_board_half_width_2, _going43)
                _p_board_thickness_2 = _take(_p_board_thickness_2, _going43)
                _p_board_top_2 = _take(_p_board_top_2, _going43)
                _p_gravity_2 = _take(_p_gravity_2, _going43)
                _rate_2 = _take(_rate_2, _going43)
                _refining_2 = _take(_refining_2, _going43)
                _vx_2 = _take(_vx_2, _going43)
                _vy_2 = _take(_vy_2, _going43)
                _vz_2 = _take(_vz_2, _going43)
                _x_2 = _take(_x_2, _going43)
                _y_2 = _take(_y_2, _going43)
                _z_2 = _take(_z_2, _going43)
            else:
                _store(_arrival_1, _rows41, _arrival_2, None)
                _store(_rate_1, _rows41, _rate_2, None)
        _flat_1, _tilt_1, _rate_margin_1 = backboard_margins(_latest_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _p_gravity_1, _room_1)
        _margin_1, = own_margin(_arrival_1, _flat_1, _leaving_1, _tilt_1)
        _clearance_1, _delay_1 = crossing(_margin_1, _rate_margin_1, _rate_1, _ceiling_1, _room_1)
        _time_1, = landed(_arrival_1)
        _delay_1, _doubt_1 = landed_surely(_arrives_1, _certain_1, _clearance_1, _delay_1, _doubt_1, _time_1)
        _doubt_1, _late_1 = tied(_arrives_1, _delay_1, _doubt_1, _late_1, _time_1, _when_1)
        _when_1, _which_1 = sooner(_arrives_1, 1.0, _time_1, _when_1, _which_1)
        _doubt_0 = _put(_doubt_0, _rows24, _doubt_1, shots)
        _late_0 = _put(_late_0, _rows24, _late_1, shots)
        _when_0 = _put(_when_0, _rows24, _when_1, shots)
        _which_0 = _put(_which_0, _rows24, _which_1, shots)
    _until_0, _pad_0 = horizon(_when_0, _speed_0, _p_gravity_0)
    _middle_x_0, _reach_x_0, _later_middle_x_0, _later_reach_x_0, _middle_y_0, _reach_y_0, _later_middle_y_0, _later_reach_y_0, _middle_z_0, _reach_z_0, _later_middle_z_0, _later_reach_z_0 = halved(_until_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _extent_0, _speed_0, _position_error_0, _velocity_error_0, _late_0, _pad_0, _p_gravity_0, _room_0)
    _reachable_0, = bridge_near(_middle_x_0, _middle_y_0, _middle_z_0, _reach_x_0, _reach_y_0, _reach_z_0, _later_middle_x_0, _later_middle_y_0, _later_middle_z_0, _later_reach_x_0, _later_reach_y_0, _later_reach_z_0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_bridge_half_width_0, _p_bridge_depth_0, _room_0)
    _reachable_0, = reachable_in_flight(_kept_0, _reachable_0)
    _rows44, _count45 = _rows(_reachable_0, shots)
    if _count45:
        _doubt_1 = _take(_doubt_0, _rows44)
        _extent_1 = _take(_extent_0, _rows44)
        _last_1 = _take(_last_0, _rows44)
        _late_1 = _take(_late_0, _rows44)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows44)
        _p_board_distance_1 = _take(_p_board_distance_0, _rows44)
        _p_bridge_depth_1 = _take(_p_bridge_depth_0, _rows44)
        _p_bridge_half_width_1 = _take(_p_bridge_half_width_0, _rows44)
        _p_gravity_1 = _take(_p_gravity_0, _rows44)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows44)
        _p_wire_radius_1 = _take(_p_wire_radius_0, _rows44)
        _position_error_1 = _take(_position_error_0, _rows44)
        _speed_1 = _take(_speed_0, _rows44)
        _velocity_error_1 = _take(_velocity_error_0, _rows44)
        _vx_1 = _take(_vx_0, _rows44)
        _vy_1 = _take(_vy_0, _rows44)
        _vz_1 = _take(_vz_0, _rows44)
        _when_1 = _take(_when_0, _rows44)
        _which_1 = _take(_which_0, _rows44)
        _x_1 = _take(_x_0, _rows44)
        _y_1 = _take(_y_0, _rows44)
        _z_1 = _take(_z_0, _rows44)
        _room_1 = room(_count45)
        _until_1, _pad_1 = horizon(_when_1, _speed_1, _p_gravity_1)
        _low0_1, _high0_1, _low1_1, _high1_1, _ceiling_1, _latest_1, _lost_1 = bridge_prepare(_until_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _p_gravity_1, _room_1)
        _share_1, _arrival_1, _certain_1 = beginning()
        _position_level_1, _velocity_level_1, _excess_1 = allowance(_share_1, _latest_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_gravity_1, _room_1)
        _flat_1, _tilt_1, _rate_slack_1 = bridge_margins(_latest_1, _extent_1, _speed_1, _position_level_1, _velocity_level_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _p_gravity_1, _room_1)
        _t_1, _end_1, _searching_1 = bridge_enter(0.0, 0.0, _high0_1, _high1_1, _low0_1, _low1_1, 0.0)
        _doubt_1, = beyond_windows(_doubt_1, _excess_1, _late_1, _lost_1, _pad_1, _searching_1)
        _rows46, _count47 = _rows(_searching_1, _count45)
        if _count47:
            _arrival_2 = _take(_arrival_1, _rows46)
            _ceiling_2 = _take(_ceiling_1, _rows46)
            _certain_2 = _take(_certain_1, _rows46)
            _doubt_2 = _take(_doubt_1, _rows46)
            _end_2 = _take(_end_1, _rows46)
            _extent_2 = _take(_extent_1, _rows46)
            _flat_2 = _take(_flat_1, _rows46)
            _high0_2 = _take(_high0_1, _rows46)
            _high1_2 = _take(_high1_1, _rows46)
            _last_2 = _take(_last_1, _rows46)
            _latest_2 = _take(_latest_1, _rows46)
            _low0_2 = _take(_low0_1, _rows46)
            _low1_2 = _take(_low1_1, _rows46)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows46)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows46)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows46)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows46)
            _p_gravity_2 = _take(_p_gravity_1, _rows46)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows46)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows46)
            _position_error_2 = _take(_position_error_1, _rows46)
            _rate_slack_2 = _take(_rate_slack_1, _rows46)
            _share_2 = _take(_share_1, _rows46)
            _speed_2 = _take(_speed_1, _rows46)
            _t_2 = _take(_t_1, _rows46)
            _tilt_2 = _take(_tilt_1, _rows46)
            _velocity_error_2 = _take(_velocity_error_1, _rows46)
            _vx_2 = _take(_vx_1, _rows46)
            _vy_2 = _take(_vy_1, _rows46)
            _vz_2 = _take(_vz_1, _rows46)
            _x_2 = _take(_x_1, _rows46)
            _y_2 = _take(_y_1, _rows46)
            _z_2 = _take(_z_1, _rows46)
            _room_2 = room(_count47)
            _leaving_2, _margin_2 = nearby(_flat_2, 2.0, _last_2, _t_2, _tilt_2)
            _gap_2, _rate_2, _bend_2, _step_2, _next_2, _clearance_2 = bridge_advance(_t_2, _end_2, _leaving_2, _margin_2, _rate_slack_2, _ceiling_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _p_gravity_2, _room_2)
            _hit_2, _sure_2, _vague_2 = struck_or_still(_bend_2, _clearance_2, _end_2, _gap_2, _margin_2, _next_2, _rate_2, _rate_slack_2, _share_2, _t_2)
            _rows48, _count49 = _rows(_vague_2, _count47)
            if _count49:
                _doubt_3 = _take(_doubt_2, _rows48)
                _extent_3 = _take(_extent_2, _rows48)
                _latest_3 = _take(_latest_2, _rows48)
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows48)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows48)
                _p_bridge_depth_3 = _take(_p_bridge_depth_2, _rows48)
                _p_bridge_half_width_3 = _take(_p_bridge_half_width_2, _rows48)
                _p_gravity_3 = _take(_p_gravity_2, _rows48)
                _p_ring_radius_3 = _take(_p_ring_radius_2, _rows48)
                _p_wire_radius_3 = _take(_p_wire_radius_2, _rows48)
                _position_error_3 = _take(_position_error_2, _rows48)
                _share_3 = _take(_share_2, _rows48)
                _speed_3 = _take(_speed_2, _rows48)
                _t_3 = _take(_t_2, _rows48)
                _velocity_error_3 = _take(_velocity_error_2, _rows48)
                _room_3 = room(_count49)
                _share_3, = finer(_share_3)
                _position_level_3, _velocity_level_3, _excess_3 = allowance(_share_3, _latest_3, _extent_3, _speed_3, _position_error_3, _velocity_error_3, _p_gravity_3, _room_3)
                _flat_3, _tilt_3, _rate_slack_3 = bridge_margins(_latest_3, _extent_3, _speed_3, _position_level_3, _velocity_level_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_board_distance_3, _p_bridge_half_width_3, _p_bridge_depth_3, _p_gravity_3, _room_3)
                _doubt_3, = exceeded(_doubt_3, _excess_3, _t_3)
                _doubt_2 = _put(_doubt_2, _rows48, _doubt_3, _count47)
                _flat_2 = _put(_flat_2, _rows48, _flat_3, _count47)
                _rate_slack_2 = _put(_rate_slack_2, _rows48, _rate_slack_3, _count47)
                _share_2 = _put(_share_2, _rows48, _share_3, _count47)
                _tilt_2 = _put(_tilt_2, _rows48, _tilt_3, _count47)
            _arrival_2, _certain_2, _exhausted_2, _searching_2, _t_2 = advanced(_arrival_2, _certain_2, _end_2, _hit_2, _next_2, _step_2, _sure_2, _t_2, _vague_2)
            _t_3, _end_3, _searching_3 = bridge_enter(_end_2, _end_2, _high0_2, _high1_2, _low0_2, _low1_2, _t_2)
            _end_2 = _choose(_exhausted_2, _end_3, _end_2)
            _searching_2 = _choose(_exhausted_2, _searching_3, _searching_2)
            _t_2 = _choose(_exhausted_2, _t_3, _t_2)
            _arrival_1 = _put(_arrival_1, _rows46, _arrival_2, _count45)
            _certain_1 = _put(_certain_1, _rows46, _certain_2, _count45)
            _doubt_1 = _put(_doubt_1, _rows46, _doubt_2, _count45)
            _end_1 = _put(_end_1, _rows46, _end_2, _count45)
            _flat_1 = _put(_flat_1, _rows46, _flat_2, _count45)
            _rate_slack_1 = _put(_rate_slack_1, _rows46, _rate_slack_2, _count45)
            _searching_1 = _put(_searching_1, _rows46, _searching_2, _count45)
            _share_1 = _put(_share_1, _rows46, _share_2, _count45)
            _t_1 = _put(_t_1, _rows46, _t_2, _count45)
            _tilt_1 = _put(_tilt_1, _rows46, _tilt_2, _count45)
        _rows50, _count51 = _rows(_searching_1, _count45)
        if _count51:
            _arrival_2 = _take(_arrival_1, _rows50)
            _ceiling_2 = _take(_ceiling_1, _rows50)
            _certain_2 = _take(_certain_1, _rows50)
            _doubt_2 = _take(_doubt_1, _rows50)
            _end_2 = _take(_end_1, _rows50)
            _flat_2 = _take(_flat_1, _rows50)
            _last_2 = _take(_last_1, _rows50)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows50)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows50)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows50)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows50)
            _p_gravity_2 = _take(_p_gravity_1, _rows50)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows50)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows50)
            _rate_slack_2 = _take(_rate_slack_1, _rows50)
            _searching_2 = _take(_searching_1, _rows50)
            _share_2 = _take(_share_1, _rows50)
            _t_2 = _take(_t_1, _rows50)
            _tilt_2 = _take(_tilt_1, _rows50)
            _vx_2 = _take(_vx_1, _rows50)
            _vy_2 = _take(_vy_1, _rows50)
            _vz_2 = _take(_vz_1, _rows50)
            _x_2 = _take(_x_1, _rows50)
            _y_2 = _take(_y_1, _rows50)
            _z_2 = _take(_z_1, _rows50)
            _arrival_1 = _copy(_arrival_1, _count45)
            _certain_1 = _copy(_certain_1, _count45)
            _doubt_1 = _copy(_doubt_1, _count45)
            _flat_1 = _copy(_flat_1, _count45)
            _searching_1 = _copy(_searching_1, _count45)
            _t_1 = _copy(_t_1, _count45)
            _tilt_1 = _copy(_tilt_1, _count45)
            for _ in range(201):
                _room_2 = room(_count51)
                _leaving_2, _margin_2 = nearby(_flat_2, 2.0, _last_2, _t_2, _tilt_2)
                _gap_2, _rate_2, _bend_2, _step_2, _next_2, _clearance_2 = bridge_advance(_t_2, _end_2, _leaving_2, _margin_2, _rate_slack_2, _ceiling_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _p_gravity_2, _room_2)
                _hit_2, _sure_2, _vague_2 = struck_or_still(_bend_2, _clearance_2, _end_2, _gap_2, _margin_2, _next_2, _rate_2, _rate_slack_2, _share_2, _t_2)
                _rows52, _count53 = _rows(_vague_2, _count51)
                if _count53:
                    _far = _of(_rows50, _rows52)
                    _doubt_3 = _take(_doubt_2, _rows52)
                    _extent_3 = _take(_extent_1, _far)
                    _latest_3 = _take(_latest_1, _far)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows52)
                    _p_board_distance_3 = _take(_p_board_distance_2, _rows52)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_2, _rows52)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_2, _rows52)
                    _p_gravity_3 = _take(_p_gravity_2, _rows52)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows52)
                    _p_wire_radius_3 = _take(_p_wire_radius_2, _rows52)
                    _position_error_3 = _take(_position_error_1, _far)
                    _share_3 = _take(_share_2, _rows52)
                    _speed_3 = _take(_speed_1, _far)
                    _t_3 = _take(_t_2, _rows52)
                    _velocity_error_3 = _take(_velocity_error_1, _far)
                    _room_3 = room(_count53)
                    _share_3, = finer(_share_3)
                    _position_level_3, _velocity_level_3, _excess_3 = allowance(_share_3, _latest_3, _extent_3, _speed_3, _position_error_3, _velocity_error_3, _p_gravity_3, _room_3)
                    _flat_3, _tilt_3, _rate_slack_3 = bridge_margins(_latest_3, _extent_3, _speed_3, _position_level_3, _velocity_level_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_board_distance_3, _p_bridge_half_width_3, _p_bridge_depth_3, _p_gravity_3, _room_3)
                    _doubt_3, = exceeded(_doubt_3, _excess_3, _t_3)
                    _doubt_2 = _put(_doubt_2, _rows52, _doubt_3, _count51)
                    _flat_2 = _put(_flat_2, _rows52, _flat_3, _count51)
                    _rate_slack_2 = _put(_rate_slack_2, _rows52, _rate_slack_3, _count51)
                    _share_2 = _put(_share_2, _rows52, _share_3, _count51)
                    _tilt_2 = _put(_tilt_2, _rows52, _tilt_3, _count51)
                _arrival_2, _certain_2, _exhausted_2, _searching_2, _t_2 = advanced(_arrival_2, _certain_2, _end_2, _hit_2, _next_2, _step_2, _sure_2, _t_2, _vague_2)
                _rows54, _count55 = _rows(_exhausted_2, _count51)
                if _count55:
                    _far = _of(_rows50, _rows54)
                    _end_3 = _take(_end_2, _rows54)
                    _high0_3 = _take(_high0_1, _far)
                    _high1_3 = _take(_high1_1, _far)
                    _low0_3 = _take(_low0_1, _far)
                    _low1_3 = _take(_low1_1, _far)
                    _t_3 = _take(_t_2, _rows54)
                    _t_3, _end_3, _searching_3 = bridge_enter(_end_3, _end_3, _high0_3, _high1_3, _low0_3, _low1_3, _t_3)
                    _end_2 = _put(_end_2, _rows54, _end_3, _count51)
                    _searching_2 = _put(_searching_2, _rows54, _searching_3, _count51)
                    _t_2 = _put(_t_2, _rows54, _t_3, _count51)
                _going56 = _where_true(_searching_2)
                if len(_going56) == _count51:
                    continue
                _done = _where_true(_logical_not(_searching_2))
                _store(_arrival_1, _of(_rows50, _done), _arrival_2, _done)
                _store(_certain_1, _of(_rows50, _done), _certain_2, _done)
                _store(_doubt_1, _of(_rows50, _done), _doubt_2, _done)
                _store(_flat_1, _of(_rows50, _done), _flat_2, _done)
                _store(_searching_1, _of(_rows50, _done), _searching_2, _done)
                _store(_t_1, _of(_rows50, _done), _t_2, _done)
                _store(_tilt_1, _of(_rows50, _done), _tilt_2, _done)
                _rows50, _count51 = _of(_rows50, _going56), len(_going56)
                if not _count51:
                    break
                _arrival_2 = _take(_arrival_2, _going56)
                _ceiling_2 = _take(_ceiling_2, _going56)
                _certain_2 = _take(_certain_2, _going56)
                _doubt_2 = _take(_doubt_2, _going56)
                _end_2 = _take(_end_2, _going56)
                _flat_2 = _take(_flat_2, _going56)
                _last_2 = _take(_last_2, _going56)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going56)
                _p_board_distance_2 = _take(_p_board_distance_2, _going56)
                _p_bridge_depth_2 = _take(_p_bridge_depth_2, _going56)
                _p_bridge_half_width_2 = _take(_p_bridge_half_width_2, _going56)
                _p_gravity_2 = _take(_p_gravity_2, _going56)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going56)
                _p_wire_radius_2 = _take(_p_wire_radius_2, _going56)
                _rate_slack_2 = _take(_rate_slack_2, _going56)
                _searching_2 = _take(_searching_2, _going56)
                _share_2 = _take(_share_2, _going56)
                _t_2 = _take(_t_2, _going56)
                _tilt_2 = _take(_tilt_2, _going56)
                _vx_2 = _take(_vx_2, _going56)
                _vy_2 = _take(_vy_2, _going56)
                _vz_2 = _take(_vz_2, _going56)
                _x_2 = _take(_x_2, _going56)
                _y_2 = _take(_y_2, _going56)
                _z_2 = _take(_z_2, _going56)
            else:
                _store(_arrival_1, _rows50, _arrival_2, None)
                _store(_certain_1, _rows50, _certain_2, None)
                _store(_doubt_1, _rows50, _doubt_2, None)
                _store(_flat_1, _rows50, _flat_2, None)
                _store(_searching_1, _rows50, _searching_2, None)
                _store(_t_1, _rows50, _t_2, None)
                _store(_tilt_1, _rows50, _tilt_2, None)
        _doubt_1, = questioned(_doubt_1, _t_1, _searching_1)
        _arrives_1, _refining_1, _rate_1 = found(_arrival_1)
        _leaving_1, *_ = nearby(_flat_1, 2.0, _last_1, _arrival_1, _tilt_1)
        _rows57, _count58 = _rows(_refining_1, _count45)
        if _count58:
            _arrival_2 = _take(_arrival_1, _rows57)
            _ceiling_2 = _take(_ceiling_1, _rows57)
            _certain_2 = _take(_certain_1, _rows57)
            _leaving_2 = _take(_leaving_1, _rows57)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows57)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows57)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows57)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows57)
            _p_gravity_2 = _take(_p_gravity_1, _rows57)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows57)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows57)
            _vx_2 = _take(_vx_1, _rows57)
            _vy_2 = _take(_vy_1, _rows57)
            _vz_2 = _take(_vz_1, _rows57)
            _x_2 = _take(_x_1, _rows57)
            _y_2 = _take(_y_1, _rows57)
            _z_2 = _take(_z_1, _rows57)
            _room_2 = room(_count58)
            _refined_2, _gap_2, _rate_2 = bridge_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
            _arrival_1 = _put(_arrival_1, _rows57, _arrival_2, _count45)
            _rate_1 = _put(_rate_1, _rows57, _rate_2, _count45)
            _refining_1 = _put(_refining_1, _rows57, _refining_2, _count45)
        _rows59, _count60 = _rows(_refining_1, _count45)
        if _count60:
            _arrival_2 = _take(_arrival_1, _rows59)
            _ceiling_2 = _take(_ceiling_1, _rows59)
            _certain_2 = _take(_certain_1, _rows59)
            _leaving_2 = _take(_leaving_1, _rows59)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows59)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows59)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows59)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows59)
            _p_gravity_2 = _take(_p_gravity_1, _rows59)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows59)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows59)
            _vx_2 = _take(_vx_1, _rows59)
            _vy_2 = _take(_vy_1, _rows59)
            _vz_2 = _take(_vz_1, _rows59)
            _x_2 = _take(_x_1, _rows59)
            _y_2 = _take(_y_1, _rows59)
            _z_2 = _take(_z_1, _rows59)
            _room_2 = room(_count60)
            _refined_2, _gap_2, _rate_2 = bridge_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _p_gravity_2, _room_2)
            _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
            _arrival_1 = _put(_arrival_1, _rows59, _arrival_2, _count45)
            _rate_1 = _put(_rate_1, _rows59, _rate_2, _count45)
            _refining_1 = _put(_refining_1, _rows59, _refining_2, _count45)
        _rows61, _count62 = _rows(_refining_1, _count45)
        if _count62:
            _arrival_2 = _take(_arrival_1, _rows61)
            _ceiling_2 = _take(_ceiling_1, _rows61)
            _certain_2 = _take(_certain_1, _rows61)
            _leaving_2 = _take(_leaving_1, _rows61)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows61)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows61)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows61)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows61)
            _p_gravity_2 = _take(_p_gravity_1, _rows61)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows61)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows61)
            _refining_2 = _take(_refining_1, _rows61)
            _vx_2 = _take(_vx_1, _rows61)
            _vy_2 = _take(_vy_1, _rows61)
            _vz_2 = _take(_vz_1, _rows61)
            _x_2 = _take(_x_1, _rows61)
            _y_2 = _take(_y_1, _rows61)
            _z_2 = _take(_z_1, _rows61)
            _arrival_1 = _copy(_arrival_1, _count45)
            _rate_1 = _copy(_rate_1, _count45)
            for _ in range(8):
                _room_2 = room(_count62)
                _refined_2, _gap_2, _rate_2 = bridge_refine(_arrival_2, _leaving_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _p_gravity_2, _room_2)
                _arrival_2, _refining_2 = polished(_arrival_2, _ceiling_2, _certain_2, _gap_2, _rate_2, _refined_2)
                _going63 = _where_true(_refining_2)
                if len(_going63) == _count62:
                    continue
                _done = _where_true(_logical_not(_refining_2))
                _store(_arrival_1, _of(_rows61, _done), _arrival_2, _done)
                _store(_rate_1, _of(_rows61, _done), _rate_2, _done)
                _rows61, _count62 = _of(_rows61, _going63), len(_going63)
                if not _count62:
                    break
                _arrival_2 = _take(_arrival_2, _going63)
                _ceiling_2 = _take(_ceiling_2, _going63)
                _certain_2 = _take(_certain_2, _going63)
                _leaving_2 = _take(_leaving_2, _going63)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going63)
                _p_board_distance_2 = _take(_p_board_distance_2, _going63)
                _p_bridge_depth_2 = _take(_p_bridge_depth_2, _going63)
                _p_bridge_half_width_2 = _take(_p_bridge_half_width_2, _going63)
                _p_gravity_2 = _take(_p_gravity_2, _going63)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going63)
                _p_wire_radius_2 = _take(_p_wire_radius_2, _going63)
                _rate_2 = _take(_rate_2, _going63)
                _refining_2 = _take(_refining_2, _going63)
                _vx_2 = _take(_vx_2, _going63)
                _vy_2 = _take(_vy_2, _going63)
                _vz_2 = _take(_vz_2, _going63)
                _x_2 = _take(_x_2, _going63)
                _y_2 = _take(_y_2, _going63)
                _z_2 = _take(_z_2, _going63)
            else:
                _store(_arrival_1, _rows61, _arrival_2, None)
                _store(_rate_1, _rows61, _rate_2, None)
        _flat_1, _tilt_1, _rate_margin_1 = bridge_margins(_latest_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _p_gravity_1, _room_1)
        _margin_1, = own_margin(_arrival_1, _flat_1, _leaving_1, _tilt_1)
        _clearance_1, _delay_1 = crossing(_margin_1, _rate_margin_1, _rate_1, _ceiling_1, _room_1)
        _time_1, = landed(_arrival_1)
        _delay_1, _doubt_1 = landed_surely(_arrives_1, _certain_1, _clearance_1, _delay_1, _doubt_1, _time_1)
        _doubt_1, _late_1 = tied(_arrives_1, _delay_1, _doubt_1, _late_1, _time_1, _when_1)
        _when_1, _which_1 = sooner(_arrives_1, 2.0, _time_1, _when_1, _which_1)
        _doubt_0 = _put(_doubt_0, _rows44, _doubt_1, shots)
        _late_0 = _put(_late_0, _rows44, _late_1, shots)
        _when_0 = _put(_when_0, _rows44, _when_1, shots)
        _which_0 = _put(_which_0, _rows44, _which_1, shots)
    _rows64, _count65 = _rows(_limited_0, shots)
    if _count65:
        _clock_1 = _take(_clock_0, _rows64)
        _doubt_1 = _take(_doubt_0, _rows64)
        _late_1 = _take(_late_0, _rows64)
        _time_error_1 = _take(_time_error_0, _rows64)
        _time_limit_1 = _take(_time_limit_0, _rows64)
        _when_1 = _take(_when_0, _rows64)
        _which_1 = _take(_which_0, _rows64)
        _time_1, _delay_1, _arrives_1, _doubt_1 = expiry(_clock_1, _doubt_1, _late_1, _time_error_1, _time_limit_1, _when_1, _which_1)
        _doubt_1, _late_1 = tied(_arrives_1, _delay_1, _doubt_1, _late_1, _time_1, _when_1)
        _when_1, _which_1 = sooner(_arrives_1, 4.0, _time_1, _when_1, _which_1)
        _doubt_0 = _put(_doubt_0, _rows64, _doubt_1, shots)
        _late_0 = _put(_late_0, _rows64, _late_1, shots)
        _when_0 = _put(_when_0, _rows64, _when_1, shots)
        _which_0 = _put(_which_0, _rows64, _which_1, shots)
    _rows66, _count67 = _rows(_kept_0, shots)
    if _count67:
        _circled_1 = _take(_circled_0, _rows66)
        _clock_1 = _take(_clock_0, _rows66)
        _clock_error_1 = _take(_clock_error_0, _rows66)
        _dvx_1 = _take(_dvx_0, _rows66)
        _dvy_1 = _take(_dvy_0, _rows66)
        _dvz_1 = _take(_dvz_0, _rows66)
        _dwx_1 = _take(_dwx_0, _rows66)
        _dwy_1 = _take(_dwy_0, _rows66)
        _dwz_1 = _take(_dwz_0, _rows66)
        _dx_1 = _take(_dx_0, _rows66)
        _dy_1 = _take(_dy_0, _rows66)
        _dz_1 = _take(_dz_0, _rows66)
        _grip_lost_1 = _take(_grip_lost_0, _rows66)
        _held_1 = _take(_held_0, _rows66)
        _mode_1 = _take(_mode_0, _rows66)
        _p_backboard_friction_1 = _take(_p_backboard_friction_0, _rows66)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows66)
        _p_board_bottom_1 = _take(_p_board_bottom_0, _rows66)
        _p_board_distance_1 = _take(_p_board_distance_0, _rows66)
        _p_board_half_width_1 = _take(_p_board_half_width_0, _rows66)
        _p_board_thickness_1 = _take(_p_board_thickness_0, _rows66)
        _p_board_top_1 = _take(_p_board_top_0, _rows66)
        _p_bridge_depth_1 = _take(_p_bridge_depth_0, _rows66)
        _p_bridge_friction_1 = _take(_p_bridge_friction_0, _rows66)
        _p_bridge_half_width_1 = _take(_p_bridge_half_width_0, _rows66)
        _p_end_depth_1 = _take(_p_end_depth_0, _rows66)
        _p_gravity_1 = _take(_p_gravity_0, _rows66)
        _p_ring_friction_1 = _take(_p_ring_friction_0, _rows66)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows66)
        _p_wire_radius_1 = _take(_p_wire_radius_0, _rows66)
        _position_error_1 = _take(_position_error_0, _rows66)
        _rests_1 = _take(_rests_0, _rows66)
        _taut_1 = _take(_taut_0, _rows66)
        _taut_clock_1 = _take(_taut_clock_0, _rows66)
        _taut_rate_1 = _take(_taut_rate_0, _rows66)
        _through_1 = _take(_through_0, _rows66)
        _time_limit_1 = _take(_time_limit_0, _rows66)
        _velocity_error_1 = _take(_velocity_error_0, _rows66)
        _vx_1 = _take(_vx_0, _rows66)
        _vy_1 = _take(_vy_0, _rows66)
        _vz_1 = _take(_vz_0, _rows66)
        _when_1 = _take(_when_0, _rows66)
        _wx_1 = _take(_wx_0, _rows66)
        _wy_1 = _take(_wy_0, _rows66)
        _wz_1 = _take(_wz_0, _rows66)
        _x_1 = _take(_x_0, _rows66)
        _y_1 = _take(_y_0, _rows66)
        _z_1 = _take(_z_0, _rows66)
        _which_1, _late_1, _began_1, _doubt_1, _begins_1, _rolling_1, _leaves_1, _nx_1, _ny_1, _nz_1, _gap_1, _bent_x_1, _bent_y_1, _bent_z_1, _lift_1, _surge_1, _snap_1, _per_reach_1 = resumed(_clock_1, _mode_1, _position_error_1, _velocity_error_1)
        _rows68, _count69 = _rows(_begins_1, _count67)
        if _count69:
            _dvx_2 = _take(_dvx_1, _rows68)
            _dvy_2 = _take(_dvy_1, _rows68)
            _dvz_2 = _take(_dvz_1, _rows68)
            _dwx_2 = _take(_dwx_1, _rows68)
            _dwy_2 = _take(_dwy_1, _rows68)
            _dwz_2 = _take(_dwz_1, _rows68)
            _dx_2 = _take(_dx_1, _rows68)
            _dy_2 = _take(_dy_1, _rows68)
            _dz_2 = _take(_dz_1, _rows68)
            _gap_2 = _take(_gap_1, _rows68)
            _held_2 = _take(_held_1, _rows68)
            _nx_2 = _take(_nx_1, _rows68)
            _ny_2 = _take(_ny_1, _rows68)
            _nz_2 = _take(_nz_1, _rows68)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows68)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows68)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows68)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows68)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows68)
            _p_board_top_2 = _take(_p_board_top_1, _rows68)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows68)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows68)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows68)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows68)
            _vx_2 = _take(_vx_1, _rows68)
            _vy_2 = _take(_vy_1, _rows68)
            _vz_2 = _take(_vz_1, _rows68)
            _wx_2 = _take(_wx_1, _rows68)
            _wy_2 = _take(_wy_1, _rows68)
            _wz_2 = _take(_wz_1, _rows68)
            _x_2 = _take(_x_1, _rows68)
            _y_2 = _take(_y_1, _rows68)
            _z_2 = _take(_z_1, _rows68)
            _room_2 = room(_count69)
            _here_2, = holding(_held_2, 0.0)
            _nx_3, _ny_3, _nz_3 = ring_normal(_x_2, _y_2, _z_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _room_2)
            _nx_2 = _choose(_here_2, _nx_3, _nx_2)
            _ny_2 = _choose(_here_2, _ny_3, _ny_2)
            _nz_2 = _choose(_here_2, _nz_3, _nz_2)
            _here_2, = holding(_held_2, 1.0)
            _nx_3, _ny_3, _nz_3 = backboard_normal(_x_2, _y_2, _z_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _room_2)
            _nx_2 = _choose(_here_2, _nx_3, _nx_2)
            _ny_2 = _choose(_here_2, _ny_3, _ny_2)
            _nz_2 = _choose(_here_2, _nz_3, _nz_2)
            _here_2, = holding(_held_2, 2.0)
            _nx_3, _ny_3, _nz_3 = bridge_normal(_x_2, _y_2, _z_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _room_2)
            _nx_2 = _choose(_here_2, _nx_3, _nx_2)
            _ny_2 = _choose(_here_2, _ny_3, _ny_2)
            _nz_2 = _choose(_here_2, _nz_3, _nz_2)
            _turn_rate_2, = roll_turn_rate(_p_ball_radius_2, _nx_2, _ny_2, _nz_2, _wx_2, _wy_2, _wz_2)
            _rolled_x_2, _rolled_y_2, _rolled_z_2, *_ = gripped(_p_ball_radius_2, _nx_2, _ny_2, _nz_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _room_2)
            _here_2, = holding(_held_2, 0.0)
            _gap_3, = ring_off(_p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _gap_2 = _choose(_here_2, _gap_3, _gap_2)
            _here_2, = holding(_held_2, 1.0)
            _gap_3, = backboard_off(_p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _x_2, _y_2, _z_2, _room_2)
            _gap_2 = _choose(_here_2, _gap_3, _gap_2)
            _here_2, = holding(_held_2, 2.0)
            _gap_3, = bridge_off(_p_ball_radius_2, _p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _p_ring_radius_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _gap_2 = _choose(_here_2, _gap_3, _gap_2)
            _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = roll_placed(_p_ball_radius_2, _gap_2, _nx_2, _ny_2, _nz_2, _turn_rate_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _x_2, _y_2, _z_2, _room_2)
            _dx_2, _dy_2, _dz_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2 = begun_errors(_p_ball_radius_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _dx_2, _dy_2, _dz_2, _vx_2, _vy_2, _vz_2, _room_2)
            _taut_2, = untaut()
            _which_2, _circled_2 = beginning_contact()
            _circled_1 = _put(_circled_1, _rows68, _circled_2, _count67)
            _dvx_1 = _put(_dvx_1, _rows68, _dvx_2, _count67)
            _dvy_1 = _put(_dvy_1, _rows68, _dvy_2, _count67)
            _dvz_1 = _put(_dvz_1, _rows68, _dvz_2, _count67)
            _dwx_1 = _put(_dwx_1, _rows68, _dwx_2, _count67)
            _dwy_1 = _put(_dwy_1, _rows68, _dwy_2, _count67)
            _dwz_1 = _put(_dwz_1, _rows68, _dwz_2, _count67)
            _dx_1 = _put(_dx_1, _rows68, _dx_2, _count67)
            _dy_1 = _put(_dy_1, _rows68, _dy_2, _count67)
            _dz_1 = _put(_dz_1, _rows68, _dz_2, _count67)
            _nx_1 = _put(_nx_1, _rows68, _nx_2, _count67)
            _ny_1 = _put(_ny_1, _rows68, _ny_2, _count67)
            _nz_1 = _put(_nz_1, _rows68, _nz_2, _count67)
            _taut_1 = _put(_taut_1, _rows68, _taut_2, _count67)
            _vx_1 = _put(_vx_1, _rows68, _vx_2, _count67)
            _vy_1 = _put(_vy_1, _rows68, _vy_2, _count67)
            _vz_1 = _put(_vz_1, _rows68, _vz_2, _count67)
            _which_1 = _put(_which_1, _rows68, _which_2, _count67)
            _wx_1 = _put(_wx_1, _rows68, _wx_2, _count67)
            _wy_1 = _put(_wy_1, _rows68, _wy_2, _count67)
            _wz_1 = _put(_wz_1, _rows68, _wz_2, _count67)
            _x_1 = _put(_x_1, _rows68, _x_2, _count67)
            _y_1 = _put(_y_1, _rows68, _y_2, _count67)
            _z_1 = _put(_z_1, _rows68, _z_2, _count67)
        _circling_1, _rolling_1 = circles(_held_1, 0.0, _rolling_1)
        _rows70, _count71 = _rows(_rolling_1, _count67)
        if _count71:
            _bent_x_2 = _take(_bent_x_1, _rows70)
            _bent_y_2 = _take(_bent_y_1, _rows70)
            _bent_z_2 = _take(_bent_z_1, _rows70)
            _clock_2 = _take(_clock_1, _rows70)
            _clock_error_2 = _take(_clock_error_1, _rows70)
            _doubt_2 = _take(_doubt_1, _rows70)
            _dvx_2 = _take(_dvx_1, _rows70)
            _dvy_2 = _take(_dvy_1, _rows70)
            _dvz_2 = _take(_dvz_1, _rows70)
            _dwx_2 = _take(_dwx_1, _rows70)
            _dwy_2 = _take(_dwy_1, _rows70)
            _dwz_2 = _take(_dwz_1, _rows70)
            _dx_2 = _take(_dx_1, _rows70)
            _dy_2 = _take(_dy_1, _rows70)
            _dz_2 = _take(_dz_1, _rows70)
            _grip_lost_2 = _take(_grip_lost_1, _rows70)
            _held_2 = _take(_held_1, _rows70)
            _late_2 = _take(_late_1, _rows70)
            _nx_2 = _take(_nx_1, _rows70)
            _ny_2 = _take(_ny_1, _rows70)
            _nz_2 = _take(_nz_1, _rows70)
            _p_backboard_friction_2 = _take(_p_backboard_friction_1, _rows70)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows70)
            _p_bridge_friction_2 = _take(_p_bridge_friction_1, _rows70)
            _p_end_depth_2 = _take(_p_end_depth_1, _rows70)
            _p_gravity_2 = _take(_p_gravity_1, _rows70)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows70)
            _per_reach_2 = _take(_per_reach_1, _rows70)
            _rolling_2 = _take(_rolling_1, _rows70)
            _taut_2 = _take(_taut_1, _rows70)
            _taut_clock_2 = _take(_taut_clock_1, _rows70)
            _taut_rate_2 = _take(_taut_rate_1, _rows70)
            _through_2 = _take(_through_1, _rows70)
            _time_limit_2 = _take(_time_limit_1, _rows70)
            _vx_2 = _take(_vx_1, _rows70)
            _vy_2 = _take(_vy_1, _rows70)
            _vz_2 = _take(_vz_1, _rows70)
            _which_2 = _take(_which_1, _rows70)
            _wx_2 = _take(_wx_1, _rows70)
            _wy_2 = _take(_wy_1, _rows70)
            _wz_2 = _take(_wz_1, _rows70)
            _x_2 = _take(_x_1, _rows70)
            _y_2 = _take(_y_1, _rows70)
            _z_2 = _take(_z_1, _rows70)
            _clock_1 = _copy(_clock_1, _count67)
            _doubt_1 = _copy(_doubt_1, _count67)
            _dvx_1 = _copy(_dvx_1, _count67)
            _dvy_1 = _copy(_dvy_1, _count67)
            _dvz_1 = _copy(_dvz_1, _count67)
            _dwx_1 = _copy(_dwx_1, _count67)
            _dwy_1 = _copy(_dwy_1, _count67)
            _dwz_1 = _copy(_dwz_1, _count67)
            _dx_1 = _copy(_dx_1, _count67)
            _dy_1 = _copy(_dy_1, _count67)
            _dz_1 = _copy(_dz_1, _count67)
            _grip_lost_1 = _copy(_grip_lost_1, _count67)
            _late_1 = _copy(_late_1, _count67)
            _per_reach_1 = _copy(_per_reach_1, _count67)
            _position_error_1 = _copy(_position_error_1, _count67)
            _rests_1 = _copy(_rests_1, _count67)
            _rolling_1 = _copy(_rolling_1, _count67)
            _taut_1 = _copy(_taut_1, _count67)
            _taut_clock_1 = _copy(_taut_clock_1, _count67)
            _taut_rate_1 = _copy(_taut_rate_1, _count67)
            _through_1 = _copy(_through_1, _count67)
            _velocity_error_1 = _copy(_velocity_error_1, _count67)
            _vx_1 = _copy(_vx_1, _count67)
            _vy_1 = _copy(_vy_1, _count67)
            _vz_1 = _copy(_vz_1, _count67)
            _which_1 = _copy(_which_1, _count67)
            _wx_1 = _copy(_wx_1, _count67)
            _wy_1 = _copy(_wy_1, _count67)
            _wz_1 = _copy(_wz_1, _count67)
            _x_1 = _copy(_x_1, _count67)
            _y_1 = _copy(_y_1, _count67)
            _z_1 = _copy(_z_1, _count67)
            for _ in range(16):
                _room_2 = room(_count71)
                _position_error_2, _velocity_error_2, *_ = error_bounds(_clock_error_2, _dx_2, _dy_2, _dz_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _room_2)
                _here_2, = holding(_held_2, 1.0)
                _rows72, _count73 = _rows(_here_2, _count71)
                if _count73:
                    _far = _of(_rows70, _rows72)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows72)
                    _p_board_bottom_3 = _take(_p_board_bottom_1, _far)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_board_half_width_3 = _take(_p_board_half_width_1, _far)
                    _p_board_thickness_3 = _take(_p_board_thickness_1, _far)
                    _p_board_top_3 = _take(_p_board_top_1, _far)
                    _vx_3 = _take(_vx_2, _rows72)
                    _vy_3 = _take(_vy_2, _rows72)
                    _vz_3 = _take(_vz_2, _rows72)
                    _x_3 = _take(_x_2, _rows72)
                    _y_3 = _take(_y_2, _rows72)
                    _z_3 = _take(_z_2, _rows72)
                    _room_3 = room(_count73)
                    _nx_3, _ny_3, _nz_3 = backboard_normal(_x_3, _y_3, _z_3, _p_ball_radius_3, _p_board_distance_3, _p_board_half_width_3, _p_board_bottom_3, _p_board_top_3, _p_board_thickness_3, _room_3)
                    _bent_x_3, _bent_y_3, _bent_z_3, _per_reach_3 = backboard_tube(_p_ball_radius_3, _p_board_bottom_3, _p_board_distance_3, _p_board_half_width_3, _p_board_thickness_3, _p_board_top_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3, _room_3)
                    _bent_x_2 = _put(_bent_x_2, _rows72, _bent_x_3, _count71)
                    _bent_y_2 = _put(_bent_y_2, _rows72, _bent_y_3, _count71)
                    _bent_z_2 = _put(_bent_z_2, _rows72, _bent_z_3, _count71)
                    _nx_2 = _put(_nx_2, _rows72, _nx_3, _count71)
                    _ny_2 = _put(_ny_2, _rows72, _ny_3, _count71)
                    _nz_2 = _put(_nz_2, _rows72, _nz_3, _count71)
                    _per_reach_2 = _put(_per_reach_2, _rows72, _per_reach_3, _count71)
                _here_2, = holding(_held_2, 2.0)
                _rows74, _count75 = _rows(_here_2, _count71)
                if _count75:
                    _far = _of(_rows70, _rows74)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows74)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_1, _far)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_1, _far)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows74)
                    _p_wire_radius_3 = _take(_p_wire_radius_1, _far)
                    _vx_3 = _take(_vx_2, _rows74)
                    _vy_3 = _take(_vy_2, _rows74)
                    _vz_3 = _take(_vz_2, _rows74)
                    _x_3 = _take(_x_2, _rows74)
                    _y_3 = _take(_y_2, _rows74)
                    _z_3 = _take(_z_2, _rows74)
                    _room_3 = room(_count75)
                    _nx_3, _ny_3, _nz_3 = bridge_normal(_x_3, _y_3, _z_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_board_distance_3, _p_bridge_half_width_3, _p_bridge_depth_3, _room_3)
                    _bent_x_3, _bent_y_3, _bent_z_3, _per_reach_3 = bridge_tube(_p_ball_radius_3, _p_board_distance_3, _p_bridge_depth_3, _p_bridge_half_width_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                    _bent_x_2 = _put(_bent_x_2, _rows74, _bent_x_3, _count71)
                    _bent_y_2 = _put(_bent_y_2, _rows74, _bent_y_3, _count71)
                    _bent_z_2 = _put(_bent_z_2, _rows74, _bent_z_3, _count71)
                    _nx_2 = _put(_nx_2, _rows74, _nx_3, _count71)
                    _ny_2 = _put(_ny_2, _rows74, _ny_3, _count71)
                    _nz_2 = _put(_nz_2, _rows74, _nz_3, _count71)
                    _per_reach_2 = _put(_per_reach_2, _rows74, _per_reach_3, _count71)
                _vx_0_2, _vy_0_2, _vz_0_2, _nx_0_2, _ny_0_2, _nz_0_2, _turn_rate_0_2 = roll_start(_p_ball_radius_2, _nx_2, _ny_2, _nz_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2)
                _lift_0_2, _tx_0_2, _ty_0_2, _tz_0_2, _vx_1_2, _vy_1_2, _vz_1_2, _nx_1_2, _ny_1_2, _nz_1_2, _turn_rate_1_2 = roll_0(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _nx_0_2, _ny_0_2, _nz_0_2, _per_reach_2, _turn_rate_0_2, _vx_0_2, _vy_0_2, _vz_0_2, _room_2)
                _lift_1_2, _tx_1_2, _ty_1_2, _tz_1_2, _vx_2_2, _vy_2_2, _vz_2_2, _nx_2_2, _ny_2_2, _nz_2_2, _turn_rate_2_2 = roll_1(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _nx_0_2, _nx_1_2, _ny_0_2, _ny_1_2, _nz_0_2, _nz_1_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _tx_0_2, _ty_0_2, _tz_0_2, _vx_0_2, _vx_1_2, _vy_0_2, _vy_1_2, _vz_0_2, _vz_1_2, _room_2)
                _lift_2_2, _tx_2_2, _ty_2_2, _tz_2_2, _vx_3_2, _vy_3_2, _vz_3_2, _nx_3_2, _ny_3_2, _nz_3_2, _turn_rate_3_2 = roll_2(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _nx_0_2, _nx_1_2, _nx_2_2, _ny_0_2, _ny_1_2, _ny_2_2, _nz_0_2, _nz_1_2, _nz_2_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _tx_0_2, _tx_1_2, _ty_0_2, _ty_1_2, _tz_0_2, _tz_1_2, _vx_0_2, _vx_1_2, _vx_2_2, _vy_0_2, _vy_1_2, _vy_2_2, _vz_0_2, _vz_1_2, _vz_2_2, _room_2)
                _lift_3_2, _tx_3_2, _ty_3_2, _tz_3_2, _vx_4_2, _vy_4_2, _vz_4_2, _nx_4_2, _ny_4_2, _nz_4_2, _turn_rate_4_2 = roll_3(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _tx_0_2, _tx_1_2, _tx_2_2, _ty_0_2, _ty_1_2, _ty_2_2, _tz_0_2, _tz_1_2, _tz_2_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _room_2)
                _lift_4_2, _tx_4_2, _ty_4_2, _tz_4_2, _vx_5_2, _vy_5_2, _vz_5_2, _nx_5_2, _ny_5_2, _nz_5_2, _turn_rate_5_2 = roll_4(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _lift_3_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _nx_4_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _ny_4_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _nz_4_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _tx_0_2, _tx_1_2, _tx_2_2, _tx_3_2, _ty_0_2, _ty_1_2, _ty_2_2, _ty_3_2, _tz_0_2, _tz_1_2, _tz_2_2, _tz_3_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _room_2)
                _lift_5_2, _tx_5_2, _ty_5_2, _tz_5_2, _vx_6_2, _vy_6_2, _vz_6_2, _nx_6_2, _ny_6_2, _nz_6_2, _turn_rate_6_2 = roll_5(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _lift_3_2, _lift_4_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _nx_4_2, _nx_5_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _ny_4_2, _ny_5_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _nz_4_2, _nz_5_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _tx_0_2, _tx_1_2, _tx_2_2, _tx_3_2, _tx_4_2, _ty_0_2, _ty_1_2, _ty_2_2, _ty_3_2, _ty_4_2, _tz_0_2, _tz_1_2, _tz_2_2, _tz_3_2, _tz_4_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vx_5_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vy_5_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _vz_5_2, _room_2)
                _lift_6_2, _tx_6_2, _ty_6_2, _tz_6_2, _vx_7_2, _vy_7_2, _vz_7_2, _nx_7_2, _ny_7_2, _nz_7_2, _turn_rate_7_2 = roll_6(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _lift_3_2, _lift_4_2, _lift_5_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _nx_4_2, _nx_5_2, _nx_6_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _ny_4_2, _ny_5_2, _ny_6_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _nz_4_2, _nz_5_2, _nz_6_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _tx_0_2, _tx_1_2, _tx_2_2, _tx_3_2, _tx_4_2, _tx_5_2, _ty_0_2, _ty_1_2, _ty_2_2, _ty_3_2, _ty_4_2, _ty_5_2, _tz_0_2, _tz_1_2, _tz_2_2, _tz_3_2, _tz_4_2, _tz_5_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vx_5_2, _vx_6_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vy_5_2, _vy_6_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _vz_5_2, _vz_6_2, _room_2)
                _lift_7_2, _, _, _, _vx_8_2, _vy_8_2, _vz_8_2, _nx_8_2, _ny_8_2, _nz_8_2, _turn_rate_8_2 = roll_7(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _lift_3_2, _lift_4_2, _lift_5_2, _lift_6_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _nx_4_2, _nx_5_2, _nx_6_2, _nx_7_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _ny_4_2, _ny_5_2, _ny_6_2, _ny_7_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _nz_4_2, _nz_5_2, _nz_6_2, _nz_7_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _tx_0_2, _tx_1_2, _tx_2_2, _tx_3_2, _tx_4_2, _tx_5_2, _tx_6_2, _ty_0_2, _ty_1_2, _ty_2_2, _ty_3_2, _ty_4_2, _ty_5_2, _ty_6_2, _tz_0_2, _tz_1_2, _tz_2_2, _tz_3_2, _tz_4_2, _tz_5_2, _tz_6_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vx_5_2, _vx_6_2, _vx_7_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vy_5_2, _vy_6_2, _vy_7_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _vz_5_2, _vz_6_2, _vz_7_2, _room_2)
                _stride_2, _strongest_2, _fastest_2, _force_2, _force_rate_2, _force_bend_2, _brace_2 = roll_pace(_p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _lift_3_2, _lift_4_2, _lift_5_2, _lift_6_2, _lift_7_2, _nx_8_2, _ny_8_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _nz_4_2, _nz_5_2, _nz_6_2, _nz_7_2, _nz_8_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vx_5_2, _vx_6_2, _vx_7_2, _vx_8_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vy_5_2, _vy_6_2, _vy_7_2, _vy_8_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _vz_5_2, _vz_6_2, _vz_7_2, _vz_8_2, _room_2)
                _drag_2, _drag_rate_2, _strain_2, _strain_rate_2 = pulled(_p_gravity_2, _nx_0_2, _nx_1_2, _ny_0_2, _ny_1_2, _nz_0_2, _nz_1_2, _turn_rate_0_2, _turn_rate_1_2, _tx_0_2, _tx_1_2, _ty_0_2, _ty_1_2, _tz_0_2, _tz_1_2, _room_2)
                _here_2, = holding(_held_2, 1.0)
                _strain_3, _strain_rate_3 = ring_impact_strained(_drag_2, _drag_rate_2, _force_2, _force_rate_2, _p_backboard_friction_2)
                _strain_2 = _choose(_here_2, _strain_3, _strain_2)
                _strain_rate_2 = _choose(_here_2, _strain_rate_3, _strain_rate_2)
                _here_2, = holding(_held_2, 2.0)
                _strain_3, _strain_rate_3 = ring_impact_strained(_drag_2, _drag_rate_2, _force_2, _force_rate_2, _p_bridge_friction_2)
                _strain_2 = _choose(_here_2, _strain_3, _strain_2)
                _strain_rate_2 = _choose(_here_2, _strain_rate_3, _strain_rate_2)
                _loses_2, = losing(_grip_lost_2, _strain_2)
                _rows76, _count77 = _rows(_loses_2, _count71)
                if _count77:
                    _clock_3 = _take(_clock_2, _rows76)
                    _strain_3 = _take(_strain_2, _rows76)
                    _strain_rate_3 = _take(_strain_rate_2, _rows76)
                    _taut_3 = _take(_taut_2, _rows76)
                    _taut_clock_3 = _take(_taut_clock_2, _rows76)
                    _taut_rate_3 = _take(_taut_rate_2, _rows76)
                    _room_3 = room(_count77)
                    _grip_lost_3, = lost_grip(_clock_3, _strain_3, _strain_rate_3, _taut_3, _taut_clock_3, _taut_rate_3, _room_3)
                    _grip_lost_2 = _put(_grip_lost_2, _rows76, _grip_lost_3, _count71)
                _taut_2, _taut_rate_2, _taut_clock_2 = tightened(_clock_2, _strain_2, _strain_rate_2)
                _stride_2, _which_2, _rests_2, _doubt_2 = leaving_force(_p_ball_radius_2, _brace_2, _doubt_2, _fastest_2, _force_2, _force_bend_2, _force_rate_2, _p_gravity_2, _per_reach_2, _position_error_2, _stride_2, _velocity_error_2, _vx_2, _vx_1_2, _vy_2, _vy_1_2, _vz_2, _vz_1_2, _which_2, _room_2)
                _beside_2, = beside(_held_2, 0.0)
                _rows78, _count79 = _rows(_beside_2, _count71)
                if _count79:
                    _far = _of(_rows70, _rows78)
                    _doubt_3 = _take(_doubt_2, _rows78)
                    _fastest_3 = _take(_fastest_2, _rows78)
                    _late_3 = _take(_late_2, _rows78)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows78)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows78)
                    _p_wire_radius_3 = _take(_p_wire_radius_1, _far)
                    _position_error_3 = _take(_position_error_2, _rows78)
                    _stride_3 = _take(_stride_2, _rows78)
                    _strongest_3 = _take(_strongest_2, _rows78)
                    _vx_3 = _take(_vx_2, _rows78)
                    _vy_3 = _take(_vy_2, _rows78)
                    _vz_3 = _take(_vz_2, _rows78)
                    _which_3 = _take(_which_2, _rows78)
                    _x_3 = _take(_x_2, _rows78)
                    _y_3 = _take(_y_2, _rows78)
                    _z_3 = _take(_z_2, _rows78)
                    _room_3 = room(_count79)
                    _gap_3, _nearing_3, _dent_3 = ring_beside(_p_ball_radius_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                    _stride_3, _which_3, _doubt_3, _late_3 = beside_body(_p_ball_radius_3, _dent_3, _doubt_3, _fastest_3, _gap_3, 0.0, _late_3, _nearing_3, _position_error_3, _stride_3, _strongest_3, _which_3, _x_3, _y_3, _z_3, _room_3)
                    _doubt_2 = _put(_doubt_2, _rows78, _doubt_3, _count71)
                    _late_2 = _put(_late_2, _rows78, _late_3, _count71)
                    _stride_2 = _put(_stride_2, _rows78, _stride_3, _count71)
                    _which_2 = _put(_which_2, _rows78, _which_3, _count71)
                _beside_2, = beside(_held_2, 1.0)
                _rows80, _count81 = _rows(_beside_2, _count71)
                if _count81:
                    _far = _of(_rows70, _rows80)
                    _doubt_3 = _take(_doubt_2, _rows80)
                    _fastest_3 = _take(_fastest_2, _rows80)
                    _late_3 = _take(_late_2, _rows80)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows80)
                    _p_board_bottom_3 = _take(_p_board_bottom_1, _far)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_board_half_width_3 = _take(_p_board_half_width_1, _far)
                    _p_board_thickness_3 = _take(_p_board_thickness_1, _far)
                    _p_board_top_3 = _take(_p_board_top_1, _far)
                    _position_error_3 = _take(_position_error_2, _rows80)
                    _stride_3 = _take(_stride_2, _rows80)
                    _strongest_3 = _take(_strongest_2, _rows80)
                    _vx_3 = _take(_vx_2, _rows80)
                    _vy_3 = _take(_vy_2, _rows80)
                    _vz_3 = _take(_vz_2, _rows80)
                    _which_3 = _take(_which_2, _rows80)
                    _x_3 = _take(_x_2, _rows80)
                    _y_3 = _take(_y_2, _rows80)
                    _z_3 = _take(_z_2, _rows80)
                    _room_3 = room(_count81)
                    _gap_3, _nearing_3, _dent_3 = backboard_beside(_p_ball_radius_3, _p_board_bottom_3, _p_board_distance_3, _p_board_half_width_3, _p_board_thickness_3, _p_board_top_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3, _room_3)
                    _stride_3, _which_3, _doubt_3, _late_3 = beside_body(_p_ball_radius_3, _dent_3, _doubt_3, _fastest_3, _gap_3, 1.0, _late_3, _nearing_3, _position_error_3, _stride_3, _strongest_3, _which_3, _x_3, _y_3, _z_3, _room_3)
                    _doubt_2 = _put(_doubt_2, _rows80, _doubt_3, _count71)
                    _late_2 = _put(_late_2, _rows80, _late_3, _count71)
                    _stride_2 = _put(_stride_2, _rows80, _stride_3, _count71)
                    _which_2 = _put(_which_2, _rows80, _which_3, _count71)
                _beside_2, = beside(_held_2, 2.0)
                _rows82, _count83 = _rows(_beside_2, _count71)
                if _count83:
                    _far = _of(_rows70, _rows82)
                    _doubt_3 = _take(_doubt_2, _rows82)
                    _fastest_3 = _take(_fastest_2, _rows82)
                    _late_3 = _take(_late_2, _rows82)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows82)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_1, _far)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_1, _far)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows82)
                    _p_wire_radius_3 = _take(_p_wire_radius_1, _far)
                    _position_error_3 = _take(_position_error_2, _rows82)
                    _stride_3 = _take(_stride_2, _rows82)
                    _strongest_3 = _take(_strongest_2, _rows82)
                    _vx_3 = _take(_vx_2, _rows82)
                    _vy_3 = _take(_vy_2, _rows82)
                    _vz_3 = _take(_vz_2, _rows82)
                    _which_3 = _take(_which_2, _rows82)
                    _x_3 = _take(_x_2, _rows82)
                    _y_3 = _take(_y_2, _rows82)
                    _z_3 = _take(_z_2, _rows82)
                    _room_3 = room(_count83)
                    _gap_3, _nearing_3, _dent_3 = bridge_beside(_p_ball_radius_3, _p_board_distance_3, _p_bridge_depth_3, _p_bridge_half_width_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                    _stride_3, _which_3, _doubt_3, _late_3 = beside_body(_p_ball_radius_3, _dent_3, _doubt_3, _fastest_3, _gap_3, 2.0, _late_3, _nearing_3, _position_error_3, _stride_3, _strongest_3, _which_3, _x_3, _y_3, _z_3, _room_3)
                    _doubt_2 = _put(_doubt_2, _rows82, _doubt_3, _count71)
                    _late_2 = _put(_late_2, _rows82, _late_3, _count71)
                    _stride_2 = _put(_stride_2, _rows82, _stride_3, _count71)
                    _which_2 = _put(_which_2, _rows82, _which_3, _count71)
                _gap_2, _nearing_2, _dent_2 = end_beside(_p_end_depth_2, _vz_2, _z_2)
                _stride_2, _which_2, _doubt_2, _late_2 = beside_gate(_p_ball_radius_2, _dent_2, _doubt_2, _fastest_2, _gap_2, 3.0, _late_2, _nearing_2, _position_error_2, _stride_2, _strongest_2, _which_2, _x_2, _y_2, _z_2, _room_2)
                _here_2, = holding(_held_2, 1.0)
                _rows84, _count85 = _rows(_here_2, _count71)
                if _count85:
                    _far = _of(_rows70, _rows84)
                    _fastest_3 = _take(_fastest_2, _rows84)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows84)
                    _p_board_bottom_3 = _take(_p_board_bottom_1, _far)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_board_half_width_3 = _take(_p_board_half_width_1, _far)
                    _p_board_thickness_3 = _take(_p_board_thickness_1, _far)
                    _p_board_top_3 = _take(_p_board_top_1, _far)
                    _stride_3 = _take(_stride_2, _rows84)
                    _strongest_3 = _take(_strongest_2, _rows84)
                    _vx_3 = _take(_vx_2, _rows84)
                    _vy_3 = _take(_vy_2, _rows84)
                    _vz_3 = _take(_vz_2, _rows84)
                    _x_3 = _take(_x_2, _rows84)
                    _y_3 = _take(_y_2, _rows84)
                    _z_3 = _take(_z_2, _rows84)
                    _room_3 = room(_count85)
                    _gap_3, _nearing_3, _near_3 = backboard_seam0(_p_ball_radius_3, _p_board_distance_3, _p_board_thickness_3, _vx_3, _x_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = backboard_seam1(_p_ball_radius_3, _p_board_distance_3, _p_board_thickness_3, _vx_3, _x_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = backboard_seam2(_p_ball_radius_3, _p_board_half_width_3, _vy_3, _y_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = backboard_seam3(_p_ball_radius_3, _p_board_half_width_3, _vy_3, _y_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = backboard_seam4(_p_ball_radius_3, _p_board_bottom_3, _p_board_top_3, _vz_3, _z_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = backboard_seam5(_p_ball_radius_3, _p_board_bottom_3, _p_board_top_3, _vz_3, _z_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_2 = _put(_gap_2, _rows84, _gap_3, _count71)
                    _stride_2 = _put(_stride_2, _rows84, _stride_3, _count71)
                _here_2, = holding(_held_2, 2.0)
                _rows86, _count87 = _rows(_here_2, _count71)
                if _count87:
                    _far = _of(_rows70, _rows86)
                    _fastest_3 = _take(_fastest_2, _rows86)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows86)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_1, _far)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_1, _far)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows86)
                    _p_wire_radius_3 = _take(_p_wire_radius_1, _far)
                    _stride_3 = _take(_stride_2, _rows86)
                    _strongest_3 = _take(_strongest_2, _rows86)
                    _vx_3 = _take(_vx_2, _rows86)
                    _vy_3 = _take(_vy_2, _rows86)
                    _vz_3 = _take(_vz_2, _rows86)
                    _x_3 = _take(_x_2, _rows86)
                    _y_3 = _take(_y_2, _rows86)
                    _z_3 = _take(_z_2, _rows86)
                    _room_3 = room(_count87)
                    _gap_3, _nearing_3, _near_3 = bridge_seam0(_p_ball_radius_3, _p_board_distance_3, _p_ring_radius_3, _vx_3, _x_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = bridge_seam1(_p_ball_radius_3, _p_board_distance_3, _p_ring_radius_3, _vx_3, _x_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = bridge_seam2(_p_ball_radius_3, _p_bridge_half_width_3, _vy_3, _y_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = bridge_seam3(_p_ball_radius_3, _p_bridge_half_width_3, _vy_3, _y_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = bridge_seam4(_p_ball_radius_3, _p_bridge_depth_3, _vz_3, _p_wire_radius_3, _z_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_3, _nearing_3, _near_3 = bridge_seam5(_p_ball_radius_3, _p_bridge_depth_3, _vz_3, _p_wire_radius_3, _z_3)
                    _stride_3, = beside_seam(_fastest_3, _gap_3, _near_3, _nearing_3, _stride_3, _strongest_3, _room_3)
                    _gap_2 = _put(_gap_2, _rows86, _gap_3, _count71)
                    _stride_2 = _put(_stride_2, _rows86, _stride_3, _count71)
                _stride_2, _which_2 = beside_time(_clock_2, _stride_2, _time_limit_2, _which_2)
                _apart_2, = apart(_p_ball_radius_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _dx_2, _dy_2, _dz_2, _room_2)
                _far_x_2, _far_y_2, _far_z_2, _far_vx_2, _far_vy_2, _far_vz_2, _far_wx_2, _far_wy_2, _far_wz_2, _far_nx_2, _far_ny_2, _far_nz_2, _far_gap_2 = neighbour(_apart_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _dx_2, _dy_2, _dz_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _x_2, _y_2, _z_2, _room_2)
                _over_2, = passing_from(_z_2)
                _x_2, _vx_2, _y_2, _vy_2, _z_2, _vz_2, _turn_rate_2 = roll_moved(_stride_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vx_5_2, _vx_6_2, _vx_7_2, _vx_8_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vy_5_2, _vy_6_2, _vy_7_2, _vy_8_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _vz_5_2, _vz_6_2, _vz_7_2, _vz_8_2, _x_2, _y_2, _z_2, _room_2)
                _here_2, = holding(_held_2, 1.0)
                _rows88, _count89 = _rows(_here_2, _count71)
                if _count89:
                    _far = _of(_rows70, _rows88)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows88)
                    _p_board_bottom_3 = _take(_p_board_bottom_1, _far)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_board_half_width_3 = _take(_p_board_half_width_1, _far)
                    _p_board_thickness_3 = _take(_p_board_thickness_1, _far)
                    _p_board_top_3 = _take(_p_board_top_1, _far)
                    _x_3 = _take(_x_2, _rows88)
                    _y_3 = _take(_y_2, _rows88)
                    _z_3 = _take(_z_2, _rows88)
                    _room_3 = room(_count89)
                    _nx_3, _ny_3, _nz_3 = backboard_normal(_x_3, _y_3, _z_3, _p_ball_radius_3, _p_board_distance_3, _p_board_half_width_3, _p_board_bottom_3, _p_board_top_3, _p_board_thickness_3, _room_3)
                    _gap_3, = backboard_off(_p_ball_radius_3, _p_board_bottom_3, _p_board_distance_3, _p_board_half_width_3, _p_board_thickness_3, _p_board_top_3, _x_3, _y_3, _z_3, _room_3)
                    _gap_2 = _put(_gap_2, _rows88, _gap_3, _count71)
                    _nx_2 = _put(_nx_2, _rows88, _nx_3, _count71)
                    _ny_2 = _put(_ny_2, _rows88, _ny_3, _count71)
                    _nz_2 = _put(_nz_2, _rows88, _nz_3, _count71)
                _here_2, = holding(_held_2, 2.0)
                _rows90, _count91 = _rows(_here_2, _count71)
                if _count91:
                    _far = _of(_rows70, _rows90)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows90)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_1, _far)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_1, _far)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows90)
                    _p_wire_radius_3 = _take(_p_wire_radius_1, _far)
                    _x_3 = _take(_x_2, _rows90)
                    _y_3 = _take(_y_2, _rows90)
                    _z_3 = _take(_z_2, _rows90)
                    _room_3 = room(_count91)
                    _nx_3, _ny_3, _nz_3 = bridge_normal(_x_3, _y_3, _z_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_board_distance_3, _p_bridge_half_width_3, _p_bridge_depth_3, _room_3)
                    _gap_3, = bridge_off(_p_ball_radius_3, _p_board_distance_3, _p_bridge_depth_3, _p_bridge_half_width_3, _p_ring_radius_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                    _gap_2 = _put(_gap_2, _rows90, _gap_3, _count71)
                    _nx_2 = _put(_nx_2, _rows90, _nx_3, _count71)
                    _ny_2 = _put(_ny_2, _rows90, _ny_3, _count71)
                    _nz_2 = _put(_nz_2, _rows90, _nz_3, _count71)
                _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = roll_placed(_p_ball_radius_2, _gap_2, _nx_2, _ny_2, _nz_2, _turn_rate_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2, _room_2)
                _through_2, = passing_in_contact(_over_2, _p_ring_radius_2, _through_2, _x_2, _y_2, _z_2)
                _here_2, = holding(_held_2, 1.0)
                _rows92, _count93 = _rows(_here_2, _count71)
                if _count93:
                    _far = _of(_rows70, _rows92)
                    _far_x_3 = _take(_far_x_2, _rows92)
                    _far_y_3 = _take(_far_y_2, _rows92)
                    _far_z_3 = _take(_far_z_2, _rows92)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows92)
                    _p_board_bottom_3 = _take(_p_board_bottom_1, _far)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_board_half_width_3 = _take(_p_board_half_width_1, _far)
                    _p_board_thickness_3 = _take(_p_board_thickness_1, _far)
                    _p_board_top_3 = _take(_p_board_top_1, _far)
                    _room_3 = room(_count93)
                    _far_nx_3, _far_ny_3, _far_nz_3 = backboard_normal(_far_x_3, _far_y_3, _far_z_3, _p_ball_radius_3, _p_board_distance_3, _p_board_half_width_3, _p_board_bottom_3, _p_board_top_3, _p_board_thickness_3, _room_3)
                    _far_nx_2 = _put(_far_nx_2, _rows92, _far_nx_3, _count71)
                    _far_ny_2 = _put(_far_ny_2, _rows92, _far_ny_3, _count71)
                    _far_nz_2 = _put(_far_nz_2, _rows92, _far_nz_3, _count71)
                _here_2, = holding(_held_2, 2.0)
                _rows94, _count95 = _rows(_here_2, _count71)
                if _count95:
                    _far = _of(_rows70, _rows94)
                    _far_x_3 = _take(_far_x_2, _rows94)
                    _far_y_3 = _take(_far_y_2, _rows94)
                    _far_z_3 = _take(_far_z_2, _rows94)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows94)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_1, _far)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_1, _far)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows94)
                    _p_wire_radius_3 = _take(_p_wire_radius_1, _far)
                    _room_3 = room(_count95)
                    _far_nx_3, _far_ny_3, _far_nz_3 = bridge_normal(_far_x_3, _far_y_3, _far_z_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_board_distance_3, _p_bridge_half_width_3, _p_bridge_depth_3, _room_3)
                    _far_nx_2 = _put(_far_nx_2, _rows94, _far_nx_3, _count71)
                    _far_ny_2 = _put(_far_ny_2, _rows94, _far_ny_3, _count71)
                    _far_nz_2 = _put(_far_nz_2, _rows94, _far_nz_3, _count71)
                _turn_rate_2, = roll_turn_rate(_p_ball_radius_2, _far_nx_2, _far_ny_2, _far_nz_2, _far_wx_2, _far_wy_2, _far_wz_2)
                _here_2, = holding(_held_2, 1.0)
                _rows96, _count97 = _rows(_here_2, _count71)
                if _count97:
                    _far = _of(_rows70, _rows96)
                    _far_x_3 = _take(_far_x_2, _rows96)
                    _far_y_3 = _take(_far_y_2, _rows96)
                    _far_z_3 = _take(_far_z_2, _rows96)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows96)
                    _p_board_bottom_3 = _take(_p_board_bottom_1, _far)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_board_half_width_3 = _take(_p_board_half_width_1, _far)
                    _p_board_thickness_3 = _take(_p_board_thickness_1, _far)
                    _p_board_top_3 = _take(_p_board_top_1, _far)
                    _room_3 = room(_count97)
                    _far_nx_3, _far_ny_3, _far_nz_3 = backboard_normal(_far_x_3, _far_y_3, _far_z_3, _p_ball_radius_3, _p_board_distance_3, _p_board_half_width_3, _p_board_bottom_3, _p_board_top_3, _p_board_thickness_3, _room_3)
                    _far_gap_3, = backboard_off(_p_ball_radius_3, _p_board_bottom_3, _p_board_distance_3, _p_board_half_width_3, _p_board_thickness_3, _p_board_top_3, _far_x_3, _far_y_3, _far_z_3, _room_3)
                    _far_gap_2 = _put(_far_gap_2, _rows96, _far_gap_3, _count71)
                    _far_nx_2 = _put(_far_nx_2, _rows96, _far_nx_3, _count71)
                    _far_ny_2 = _put(_far_ny_2, _rows96, _far_ny_3, _count71)
                    _far_nz_2 = _put(_far_nz_2, _rows96, _far_nz_3, _count71)
                _here_2, = holding(_held_2, 2.0)
                _rows98, _count99 = _rows(_here_2, _count71)
                if _count99:
                    _far = _of(_rows70, _rows98)
                    _far_x_3 = _take(_far_x_2, _rows98)
                    _far_y_3 = _take(_far_y_2, _rows98)
                    _far_z_3 = _take(_far_z_2, _rows98)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows98)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_1, _far)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_1, _far)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows98)
                    _p_wire_radius_3 = _take(_p_wire_radius_1, _far)
                    _room_3 = room(_count99)
                    _far_nx_3, _far_ny_3, _far_nz_3 = bridge_normal(_far_x_3, _far_y_3, _far_z_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_board_distance_3, _p_bridge_half_width_3, _p_bridge_depth_3, _room_3)
                    _far_gap_3, = bridge_off(_p_ball_radius_3, _p_board_distance_3, _p_bridge_depth_3, _p_bridge_half_width_3, _p_ring_radius_3, _p_wire_radius_3, _far_x_3, _far_y_3, _far_z_3, _room_3)
                    _far_gap_2 = _put(_far_gap_2, _rows98, _far_gap_3, _count71)
                    _far_nx_2 = _put(_far_nx_2, _rows98, _far_nx_3, _count71)
                    _far_ny_2 = _put(_far_ny_2, _rows98, _far_ny_3, _count71)
                    _far_nz_2 = _put(_far_nz_2, _rows98, _far_nz_3, _count71)
                _far_x_2, _far_y_2, _far_z_2, _far_vx_2, _far_vy_2, _far_vz_2, _far_wx_2, _far_wy_2, _far_wz_2 = roll_placed(_p_ball_radius_2, _far_gap_2, _far_nx_2, _far_ny_2, _far_nz_2, _turn_rate_2, _far_vx_2, _far_vy_2, _far_vz_2, _far_x_2, _far_y_2, _far_z_2, _room_2)
                _vx_0_2, _vy_0_2, _vz_0_2, _nx_0_2, _ny_0_2, _nz_0_2, _turn_rate_0_2 = roll_start(_p_ball_radius_2, _far_nx_2, _far_ny_2, _far_nz_2, _far_vx_2, _far_vy_2, _far_vz_2, _far_wx_2, _far_wy_2, _far_wz_2)
                _lift_0_2, _tx_0_2, _ty_0_2, _tz_0_2, _vx_1_2, _vy_1_2, _vz_1_2, _nx_1_2, _ny_1_2, _nz_1_2, _turn_rate_1_2 = roll_0(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _nx_0_2, _ny_0_2, _nz_0_2, _per_reach_2, _turn_rate_0_2, _vx_0_2, _vy_0_2, _vz_0_2, _room_2)
                _lift_1_2, _tx_1_2, _ty_1_2, _tz_1_2, _vx_2_2, _vy_2_2, _vz_2_2, _nx_2_2, _ny_2_2, _nz_2_2, _turn_rate_2_2 = roll_1(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _nx_0_2, _nx_1_2, _ny_0_2, _ny_1_2, _nz_0_2, _nz_1_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _tx_0_2, _ty_0_2, _tz_0_2, _vx_0_2, _vx_1_2, _vy_0_2, _vy_1_2, _vz_0_2, _vz_1_2, _room_2)
                _lift_2_2, _tx_2_2, _ty_2_2, _tz_2_2, _vx_3_2, _vy_3_2, _vz_3_2, _nx_3_2, _ny_3_2, _nz_3_2, _turn_rate_3_2 = roll_2(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _nx_0_2, _nx_1_2, _nx_2_2, _ny_0_2, _ny_1_2, _ny_2_2, _nz_0_2, _nz_1_2, _nz_2_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _tx_0_2, _tx_1_2, _ty_0_2, _ty_1_2, _tz_0_2, _tz_1_2, _vx_0_2, _vx_1_2, _vx_2_2, _vy_0_2, _vy_1_2, _vy_2_2, _vz_0_2, _vz_1_2, _vz_2_2, _room_2)
                _lift_3_2, _tx_3_2, _ty_3_2, _tz_3_2, _vx_4_2, _vy_4_2, _vz_4_2, _nx_4_2, _ny_4_2, _nz_4_2, _turn_rate_4_2 = roll_3(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _tx_0_2, _tx_1_2, _tx_2_2, _ty_0_2, _ty_1_2, _ty_2_2, _tz_0_2, _tz_1_2, _tz_2_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _room_2)
                _lift_4_2, _tx_4_2, _ty_4_2, _tz_4_2, _vx_5_2, _vy_5_2, _vz_5_2, _nx_5_2, _ny_5_2, _nz_5_2, _turn_rate_5_2 = roll_4(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _lift_3_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _nx_4_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _ny_4_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _nz_4_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _tx_0_2, _tx_1_2, _tx_2_2, _tx_3_2, _ty_0_2, _ty_1_2, _ty_2_2, _ty_3_2, _tz_0_2, _tz_1_2, _tz_2_2, _tz_3_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _room_2)
                _lift_5_2, _tx_5_2, _ty_5_2, _tz_5_2, _vx_6_2, _vy_6_2, _vz_6_2, _nx_6_2, _ny_6_2, _nz_6_2, _turn_rate_6_2 = roll_5(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _lift_3_2, _lift_4_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _nx_4_2, _nx_5_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _ny_4_2, _ny_5_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _nz_4_2, _nz_5_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _tx_0_2, _tx_1_2, _tx_2_2, _tx_3_2, _tx_4_2, _ty_0_2, _ty_1_2, _ty_2_2, _ty_3_2, _ty_4_2, _tz_0_2, _tz_1_2, _tz_2_2, _tz_3_2, _tz_4_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vx_5_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vy_5_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _vz_5_2, _room_2)
                _lift_6_2, _tx_6_2, _ty_6_2, _tz_6_2, _vx_7_2, _vy_7_2, _vz_7_2, _nx_7_2, _ny_7_2, _nz_7_2, _turn_rate_7_2 = roll_6(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _lift_3_2, _lift_4_2, _lift_5_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _nx_4_2, _nx_5_2, _nx_6_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _ny_4_2, _ny_5_2, _ny_6_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _nz_4_2, _nz_5_2, _nz_6_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _tx_0_2, _tx_1_2, _tx_2_2, _tx_3_2, _tx_4_2, _tx_5_2, _ty_0_2, _ty_1_2, _ty_2_2, _ty_3_2, _ty_4_2, _ty_5_2, _tz_0_2, _tz_1_2, _tz_2_2, _tz_3_2, _tz_4_2, _tz_5_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vx_5_2, _vx_6_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vy_5_2, _vy_6_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _vz_5_2, _vz_6_2, _room_2)
                _, _, _, _, _vx_8_2, _vy_8_2, _vz_8_2, _, _, _, _turn_rate_8_2 = roll_7(_bent_x_2, _bent_y_2, _bent_z_2, _p_gravity_2, _lift_0_2, _lift_1_2, _lift_2_2, _lift_3_2, _lift_4_2, _lift_5_2, _lift_6_2, _nx_0_2, _nx_1_2, _nx_2_2, _nx_3_2, _nx_4_2, _nx_5_2, _nx_6_2, _nx_7_2, _ny_0_2, _ny_1_2, _ny_2_2, _ny_3_2, _ny_4_2, _ny_5_2, _ny_6_2, _ny_7_2, _nz_0_2, _nz_1_2, _nz_2_2, _nz_3_2, _nz_4_2, _nz_5_2, _nz_6_2, _nz_7_2, _per_reach_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _tx_0_2, _tx_1_2, _tx_2_2, _tx_3_2, _tx_4_2, _tx_5_2, _tx_6_2, _ty_0_2, _ty_1_2, _ty_2_2, _ty_3_2, _ty_4_2, _ty_5_2, _ty_6_2, _tz_0_2, _tz_1_2, _tz_2_2, _tz_3_2, _tz_4_2, _tz_5_2, _tz_6_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vx_5_2, _vx_6_2, _vx_7_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vy_5_2, _vy_6_2, _vy_7_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _vz_5_2, _vz_6_2, _vz_7_2, _room_2)
                _far_x_2, _far_vx_2, _far_y_2, _far_vy_2, _far_z_2, _far_vz_2, _turn_rate_2 = roll_moved(_stride_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _vx_0_2, _vx_1_2, _vx_2_2, _vx_3_2, _vx_4_2, _vx_5_2, _vx_6_2, _vx_7_2, _vx_8_2, _vy_0_2, _vy_1_2, _vy_2_2, _vy_3_2, _vy_4_2, _vy_5_2, _vy_6_2, _vy_7_2, _vy_8_2, _vz_0_2, _vz_1_2, _vz_2_2, _vz_3_2, _vz_4_2, _vz_5_2, _vz_6_2, _vz_7_2, _vz_8_2, _far_x_2, _far_y_2, _far_z_2, _room_2)
                _here_2, = holding(_held_2, 1.0)
                _rows100, _count101 = _rows(_here_2, _count71)
                if _count101:
                    _far = _of(_rows70, _rows100)
                    _far_x_3 = _take(_far_x_2, _rows100)
                    _far_y_3 = _take(_far_y_2, _rows100)
                    _far_z_3 = _take(_far_z_2, _rows100)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows100)
                    _p_board_bottom_3 = _take(_p_board_bottom_1, _far)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_board_half_width_3 = _take(_p_board_half_width_1, _far)
                    _p_board_thickness_3 = _take(_p_board_thickness_1, _far)
                    _p_board_top_3 = _take(_p_board_top_1, _far)
                    _room_3 = room(_count101)
                    _far_nx_3, _far_ny_3, _far_nz_3 = backboard_normal(_far_x_3, _far_y_3, _far_z_3, _p_ball_radius_3, _p_board_distance_3, _p_board_half_width_3, _p_board_bottom_3, _p_board_top_3, _p_board_thickness_3, _room_3)
                    _far_gap_3, = backboard_off(_p_ball_radius_3, _p_board_bottom_3, _p_board_distance_3, _p_board_half_width_3, _p_board_thickness_3, _p_board_top_3, _far_x_3, _far_y_3, _far_z_3, _room_3)
                    _far_gap_2 = _put(_far_gap_2, _rows100, _far_gap_3, _count71)
                    _far_nx_2 = _put(_far_nx_2, _rows100, _far_nx_3, _count71)
                    _far_ny_2 = _put(_far_ny_2, _rows100, _far_ny_3, _count71)
                    _far_nz_2 = _put(_far_nz_2, _rows100, _far_nz_3, _count71)
                _here_2, = holding(_held_2, 2.0)
                _rows102, _count103 = _rows(_here_2, _count71)
                if _count103:
                    _far = _of(_rows70, _rows102)
                    _far_x_3 = _take(_far_x_2, _rows102)
                    _far_y_3 = _take(_far_y_2, _rows102)
                    _far_z_3 = _take(_far_z_2, _rows102)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows102)
                    _p_board_distance_3 = _take(_p_board_distance_1, _far)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_1, _far)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_1, _far)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows102)
                    _p_wire_radius_3 = _take(_p_wire_radius_1, _far)
                    _room_3 = room(_count103)
                    _far_nx_3, _far_ny_3, _far_nz_3 = bridge_normal(_far_x_3, _far_y_3, _far_z_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_board_distance_3, _p_bridge_half_width_3, _p_bridge_depth_3, _room_3)
                    _far_gap_3, = bridge_off(_p_ball_radius_3, _p_board_distance_3, _p_bridge_depth_3, _p_bridge_half_width_3, _p_ring_radius_3, _p_wire_radius_3, _far_x_3, _far_y_3, _far_z_3, _room_3)
                    _far_gap_2 = _put(_far_gap_2, _rows102, _far_gap_3, _count71)
                    _far_nx_2 = _put(_far_nx_2, _rows102, _far_nx_3, _count71)
                    _far_ny_2 = _put(_far_ny_2, _rows102, _far_ny_3, _count71)
                    _far_nz_2 = _put(_far_nz_2, _rows102, _far_nz_3, _count71)
                _far_x_2, _far_y_2, _far_z_2, _far_vx_2, _far_vy_2, _far_vz_2, _far_wx_2, _far_wy_2, _far_wz_2 = roll_placed(_p_ball_radius_2, _far_gap_2, _far_nx_2, _far_ny_2, _far_nz_2, _turn_rate_2, _far_vx_2, _far_vy_2, _far_vz_2, _far_x_2, _far_y_2, _far_z_2, _room_2)
                _dx_2, _dy_2, _dz_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2 = compared(_apart_2, _p_ball_radius_2, _far_vx_2, _far_vy_2, _far_vz_2, _far_wx_2, _far_wy_2, _far_wz_2, _far_x_2, _far_y_2, _far_z_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _x_2, _y_2, _z_2, _room_2)
                _clock_2, _rolling_2 = rolled_on(_clock_2, _rests_2, _stride_2, _which_2)
                _going104 = _where_true(_rolling_2)
                if len(_going104) == _count71:
                    continue
                _done = _where_true(_logical_not(_rolling_2))
                _store(_clock_1, _of(_rows70, _done), _clock_2, _done)
                _store(_doubt_1, _of(_rows70, _done), _doubt_2, _done)
                _store(_dvx_1, _of(_rows70, _done), _dvx_2, _done)
                _store(_dvy_1, _of(_rows70, _done), _dvy_2, _done)
                _store(_dvz_1, _of(_rows70, _done), _dvz_2, _done)
                _store(_dwx_1, _of(_rows70, _done), _dwx_2, _done)
                _store(_dwy_1, _of(_rows70, _done), _dwy_2, _done)
                _store(_dwz_1, _of(_rows70, _done), _dwz_2, _done)
                _store(_dx_1, _of(_rows70, _done), _dx_2, _done)
                _store(_dy_1, _of(_rows70, _done), _dy_2, _done)
                _store(_dz_1, _of(_rows70, _done), _dz_2, _done)
                _store(_grip_lost_1, _of(_rows70, _done), _grip_lost_2, _done)
                _store(_late_1, _of(_rows70, _done), _late_2, _done)
                _store(_per_reach_1, _of(_rows70, _done), _per_reach_2, _done)
                _store(_position_error_1, _of(_rows70, _done), _position_error_2, _done)
                _store(_rests_1, _of(_rows70, _done), _rests_2, _done)
                _store(_rolling_1, _of(_rows70, _done), _rolling_2, _done)
                _store(_taut_1, _of(_rows70, _done), _taut_2, _done)
                _store(_taut_clock_1, _of(_rows70, _done), _taut_clock_2, _done)
                _store(_taut_rate_1, _of(_rows70, _done), _taut_rate_2, _done)
                _store(_through_1, _of(_rows70, _done), _through_2, _done)
                _store(_velocity_error_1, _of(_rows70, _done), _velocity_error_2, _done)
                _store(_vx_1, _of(_rows70, _done), _vx_2, _done)
                _store(_vy_1, _of(_rows70, _done), _vy_2, _done)
                _store(_vz_1, _of(_rows70, _done), _vz_2, _done)
                _store(_which_1, _of(_rows70, _done), _which_2, _done)
                _store(_wx_1, _of(_rows70, _done), _wx_2, _done)
                _store(_wy_1, _of(_rows70, _done), _wy_2, _done)
                _store(_wz_1, _of(_rows70, _done), _wz_2, _done)
                _store(_x_1, _of(_rows70, _done), _x_2, _done)
                _store(_y_1, _of(_rows70, _done), _y_2, _done)
                _store(_z_1, _of(_rows70, _done), _z_2, _done)
                _rows70, _count71 = _of(_rows70, _going104), len(_going104)
                if not _count71:
                    break
                _bent_x_2 = _take(_bent_x_2, _going104)
                _bent_y_2 = _take(_bent_y_2, _going104)
                _bent_z_2 = _take(_bent_z_2, _going104)
                _clock_2 = _take(_clock_2, _going104)
                _clock_error_2 = _take(_clock_error_2, _going104)
                _doubt_2 = _take(_doubt_2, _going104)
                _dvx_2 = _take(_dvx_2, _going104)
                _dvy_2 = _take(_dvy_2, _going104)
                _dvz_2 = _take(_dvz_2, _going104)
                _dwx_2 = _take(_dwx_2, _going104)
                _dwy_2 = _take(_dwy_2, _going104)
                _dwz_2 = _take(_dwz_2, _going104)
                _dx_2 = _take(_dx_2, _going104)
                _dy_2 = _take(_dy_2, _going104)
                _dz_2 = _take(_dz_2, _going104)
                _grip_lost_2 = _take(_grip_lost_2, _going104)
                _held_2 = _take(_held_2, _going104)
                _late_2 = _take(_late_2, _going104)
                _nx_2 = _take(_nx_2, _going104)
                _ny_2 = _take(_ny_2, _going104)
                _nz_2 = _take(_nz_2, _going104)
                _p_backboard_friction_2 = _take(_p_backboard_friction_2, _going104)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going104)
                _p_bridge_friction_2 = _take(_p_bridge_friction_2, _going104)
                _p_end_depth_2 = _take(_p_end_depth_2, _going104)
                _p_gravity_2 = _take(_p_gravity_2, _going104)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going104)
                _per_reach_2 = _take(_per_reach_2, _going104)
                _position_error_2 = _take(_position_error_2, _going104)
                _rests_2 = _take(_rests_2, _going104)
                _rolling_2 = _take(_rolling_2, _going104)
                _taut_2 = _take(_taut_2, _going104)
                _taut_clock_2 = _take(_taut_clock_2, _going104)
                _taut_rate_2 = _take(_taut_rate_2, _going104)
                _through_2 = _take(_through_2, _going104)
                _time_limit_2 = _take(_time_limit_2, _going104)
                _velocity_error_2 = _take(_velocity_error_2, _going104)
                _vx_2 = _take(_vx_2, _going104)
                _vy_2 = _take(_vy_2, _going104)
                _vz_2 = _take(_vz_2, _going104)
                _which_2 = _take(_which_2, _going104)
                _wx_2 = _take(_wx_2, _going104)
                _wy_2 = _take(_wy_2, _going104)
                _wz_2 = _take(_wz_2, _going104)
                _x_2 = _take(_x_2, _going104)
                _y_2 = _take(_y_2, _going104)
                _z_2 = _take(_z_2, _going104)
            else:
                _store(_clock_1, _rows70, _clock_2, None)
                _store(_doubt_1, _rows70, _doubt_2, None)
                _store(_dvx_1, _rows70, _dvx_2, None)
                _store(_dvy_1, _rows70, _dvy_2, None)
                _store(_dvz_1, _rows70, _dvz_2, None)
                _store(_dwx_1, _rows70, _dwx_2, None)
                _store(_dwy_1, _rows70, _dwy_2, None)
                _store(_dwz_1, _rows70, _dwz_2, None)
                _store(_dx_1, _rows70, _dx_2, None)
                _store(_dy_1, _rows70, _dy_2, None)
                _store(_dz_1, _rows70, _dz_2, None)
                _store(_grip_lost_1, _rows70, _grip_lost_2, None)
                _store(_late_1, _rows70, _late_2, None)
                _store(_per_reach_1, _rows70, _per_reach_2, None)
                _store(_position_error_1, _rows70, _position_error_2, None)
                _store(_rests_1, _rows70, _rests_2, None)
                _store(_rolling_1, _rows70, _rolling_2, None)
                _store(_taut_1, _rows70, _taut_2, None)
                _store(_taut_clock_1, _rows70, _taut_clock_2, None)
                _store(_taut_rate_1, _rows70, _taut_rate_2, None)
                _store(_through_1, _rows70, _through_2, None)
                _store(_velocity_error_1, _rows70, _velocity_error_2, None)
                _store(_vx_1, _rows70, _vx_2, None)
                _store(_vy_1, _rows70, _vy_2, None)
                _store(_vz_1, _rows70, _vz_2, None)
                _store(_which_1, _rows70, _which_2, None)
                _store(_wx_1, _rows70, _wx_2, None)
                _store(_wy_1, _rows70, _wy_2, None)
                _store(_wz_1, _rows70, _wz_2, None)
                _store(_x_1, _rows70, _x_2, None)
                _store(_y_1, _rows70, _y_2, None)
                _store(_z_1, _rows70, _z_2, None)
        _rows105, _count106 = _rows(_circling_1, _count67)
        if _count106:
            _circled_2 = _take(_circled_1, _rows105)
            _circling_2 = _take(_circling_1, _rows105)
            _clock_2 = _take(_clock_1, _rows105)
            _clock_error_2 = _take(_clock_error_1, _rows105)
            _doubt_2 = _take(_doubt_1, _rows105)
            _dvx_2 = _take(_dvx_1, _rows105)
            _dvy_2 = _take(_dvy_1, _rows105)
            _dvz_2 = _take(_dvz_1, _rows105)
            _dwx_2 = _take(_dwx_1, _rows105)
            _dwy_2 = _take(_dwy_1, _rows105)
            _dwz_2 = _take(_dwz_1, _rows105)
            _dx_2 = _take(_dx_1, _rows105)
            _dy_2 = _take(_dy_1, _rows105)
            _dz_2 = _take(_dz_1, _rows105)
            _grip_lost_2 = _take(_grip_lost_1, _rows105)
            _late_2 = _take(_late_1, _rows105)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows105)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows105)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows105)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows105)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows105)
            _p_board_top_2 = _take(_p_board_top_1, _rows105)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows105)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows105)
            _p_end_depth_2 = _take(_p_end_depth_1, _rows105)
            _p_gravity_2 = _take(_p_gravity_1, _rows105)
            _p_ring_friction_2 = _take(_p_ring_friction_1, _rows105)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows105)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows105)
            _taut_2 = _take(_taut_1, _rows105)
            _taut_clock_2 = _take(_taut_clock_1, _rows105)
            _taut_rate_2 = _take(_taut_rate_1, _rows105)
            _through_2 = _take(_through_1, _rows105)
            _time_limit_2 = _take(_time_limit_1, _rows105)
            _vx_2 = _take(_vx_1, _rows105)
            _vy_2 = _take(_vy_1, _rows105)
            _vz_2 = _take(_vz_1, _rows105)
            _which_2 = _take(_which_1, _rows105)
            _wx_2 = _take(_wx_1, _rows105)
            _wy_2 = _take(_wy_1, _rows105)
            _wz_2 = _take(_wz_1, _rows105)
            _x_2 = _take(_x_1, _rows105)
            _y_2 = _take(_y_1, _rows105)
            _z_2 = _take(_z_1, _rows105)
            _circled_1 = _copy(_circled_1, _count67)
            _circling_1 = _copy(_circling_1, _count67)
            _clock_1 = _copy(_clock_1, _count67)
            _doubt_1 = _copy(_doubt_1, _count67)
            _dvx_1 = _copy(_dvx_1, _count67)
            _dvy_1 = _copy(_dvy_1, _count67)
            _dvz_1 = _copy(_dvz_1, _count67)
            _dwx_1 = _copy(_dwx_1, _count67)
            _dwy_1 = _copy(_dwy_1, _count67)
            _dwz_1 = _copy(_dwz_1, _count67)
            _dx_1 = _copy(_dx_1, _count67)
            _dy_1 = _copy(_dy_1, _count67)
            _dz_1 = _copy(_dz_1, _count67)
            _grip_lost_1 = _copy(_grip_lost_1, _count67)
            _late_1 = _copy(_late_1, _count67)
            _per_reach_1 = _copy(_per_reach_1, _count67)
            _position_error_1 = _copy(_position_error_1, _count67)
            _rests_1 = _copy(_rests_1, _count67)
            _taut_1 = _copy(_taut_1, _count67)
            _taut_clock_1 = _copy(_taut_clock_1, _count67)
            _taut_rate_1 = _copy(_taut_rate_1, _count67)
            _through_1 = _copy(_through_1, _count67)
            _velocity_error_1 = _copy(_velocity_error_1, _count67)
            _vx_1 = _copy(_vx_1, _count67)
            _vy_1 = _copy(_vy_1, _count67)
            _vz_1 = _copy(_vz_1, _count67)
            _which_1 = _copy(_which_1, _count67)
            _wx_1 = _copy(_wx_1, _count67)
            _wy_1 = _copy(_wy_1, _count67)
            _wz_1 = _copy(_wz_1, _count67)
            _x_1 = _copy(_x_1, _count67)
            _y_1 = _copy(_y_1, _count67)
            _z_1 = _copy(_z_1, _count67)
            for _ in range(16):
                _room_2 = room(_count106)
                _position_error_2, _velocity_error_2, *_ = error_bounds(_clock_error_2, _dx_2, _dy_2, _dz_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _room_2)
                _, _, _, _per_reach_2 = ring_tube(_p_ball_radius_2, _p_wire_radius_2)
                _cosine_0_2, _sine_0_2, _climb_0_2, _along_0_2, _turn_rate_0_2, _cos_0_2, _sin_0_2, _near_0_2 = ring_round_start(_p_ball_radius_2, _p_ring_radius_2, _vx_2, _vy_2, _vz_2, _p_wire_radius_2, _wx_2, _wy_2, _wz_2, _x_2, _y_2, _z_2, _room_2)
                _omega_0_2, _around_0_2, _tilted_0_2, _pressed_0_2, _force_0_2, _cosine_1_2, _sine_1_2, _climb_1_2, _along_1_2, _turn_rate_1_2, _cos_1_2, _sin_1_2 = ring_round_0(_along_0_2, _p_ball_radius_2, _climb_0_2, _cos_0_2, _cosine_0_2, _p_gravity_2, _near_0_2, _p_ring_radius_2, _sin_0_2, _sine_0_2, _turn_rate_0_2, _p_wire_radius_2, _room_2)
                _near_1_2, _omega_1_2, _around_1_2, _tilted_1_2, _pressed_1_2, _force_1_2, _cosine_2_2, _sine_2_2, _climb_2_2, _along_2_2, _turn_rate_2_2, _cos_2_2, _sin_2_2 = ring_round_1(_along_0_2, _along_1_2, _around_0_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _cos_0_2, _cos_1_2, _cosine_0_2, _cosine_1_2, _p_gravity_2, _near_0_2, _omega_0_2, _pressed_0_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sine_0_2, _sine_1_2, _tilted_0_2, _turn_rate_0_2, _turn_rate_1_2, _p_wire_radius_2, _room_2)
                _near_2_2, _omega_2_2, _around_2_2, _tilted_2_2, _pressed_2_2, _force_2_2, _cosine_3_2, _sine_3_2, _climb_3_2, _along_3_2, _turn_rate_3_2, _cos_3_2, _sin_3_2 = ring_round_2(_along_0_2, _along_1_2, _along_2_2, _around_0_2, _around_1_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _cos_0_2, _cos_1_2, _cos_2_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _p_gravity_2, _near_0_2, _near_1_2, _omega_0_2, _omega_1_2, _pressed_0_2, _pressed_1_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sine_0_2, _sine_1_2, _sine_2_2, _tilted_0_2, _tilted_1_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _p_wire_radius_2, _room_2)
                _near_3_2, _omega_3_2, _around_3_2, _tilted_3_2, _pressed_3_2, _force_3_2, _cosine_4_2, _sine_4_2, _climb_4_2, _along_4_2, _turn_rate_4_2, _cos_4_2, _sin_4_2 = ring_round_3(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _around_0_2, _around_1_2, _around_2_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _omega_0_2, _omega_1_2, _omega_2_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _p_wire_radius_2, _room_2)
                _near_4_2, _omega_4_2, _around_4_2, _tilted_4_2, _pressed_4_2, _force_4_2, _cosine_5_2, _sine_5_2, _climb_5_2, _along_5_2, _turn_rate_5_2, _cos_5_2, _sin_5_2 = ring_round_4(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _p_wire_radius_2, _room_2)
                _near_5_2, _omega_5_2, _around_5_2, _tilted_5_2, _pressed_5_2, _force_5_2, _cosine_6_2, _sine_6_2, _climb_6_2, _along_6_2, _turn_rate_6_2, _cos_6_2, _sin_6_2 = ring_round_5(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _p_wire_radius_2, _room_2)
                _near_6_2, _omega_6_2, _around_6_2, _tilted_6_2, _pressed_6_2, _force_6_2, _cosine_7_2, _sine_7_2, _climb_7_2, _along_7_2, _turn_rate_7_2, _cos_7_2, _sin_7_2 = ring_round_6(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _p_wire_radius_2, _room_2)
                _near_7_2, _omega_7_2, _around_7_2, _tilted_7_2, _pressed_7_2, _force_7_2, _cosine_8_2, _sine_8_2, _climb_8_2, _along_8_2, _turn_rate_8_2, _cos_8_2, _sin_8_2 = ring_round_7(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _p_wire_radius_2, _room_2)
                _near_8_2, _omega_8_2, _around_8_2, _tilted_8_2, _pressed_8_2, _force_8_2, _cosine_9_2, _sine_9_2, _climb_9_2, _along_9_2, _turn_rate_9_2, _cos_9_2, _sin_9_2 = ring_round_8(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _around_7_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _near_7_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _omega_7_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _pressed_7_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _tilted_7_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _p_wire_radius_2, _room_2)
                _near_9_2, _omega_9_2, _around_9_2, _tilted_9_2, _pressed_9_2, _force_9_2, _cosine_10_2, _sine_10_2, _climb_10_2, _along_10_2, _turn_rate_10_2, _cos_10_2, _sin_10_2 = ring_round_9(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _along_9_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _around_7_2, _around_8_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _climb_9_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cos_9_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _cosine_9_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _near_7_2, _near_8_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _omega_7_2, _omega_8_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _pressed_7_2, _pressed_8_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sin_9_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _sine_9_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _tilted_7_2, _tilted_8_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _turn_rate_9_2, _p_wire_radius_2, _room_2)
                _near_10_2, _omega_10_2, _around_10_2, _tilted_10_2, _pressed_10_2, _force_10_2, _cosine_11_2, _sine_11_2, _climb_11_2, _along_11_2, _turn_rate_11_2, _cos_11_2, _sin_11_2 = ring_round_10(_along_0_2, _along_1_2, _along_10_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _along_9_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _around_7_2, _around_8_2, _around_9_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_10_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _climb_9_2, _cos_0_2, _cos_1_2, _cos_10_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cos_9_2, _cosine_0_2, _cosine_1_2, _cosine_10_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _cosine_9_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _near_7_2, _near_8_2, _near_9_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _omega_7_2, _omega_8_2, _omega_9_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _pressed_7_2, _pressed_8_2, _pressed_9_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_10_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sin_9_2, _sine_0_2, _sine_1_2, _sine_10_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _sine_9_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _tilted_7_2, _tilted_8_2, _tilted_9_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_10_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _turn_rate_9_2, _p_wire_radius_2, _room_2)
                _, _, _, _, _, _force_11_2, _cosine_12_2, _sine_12_2, _climb_12_2, _along_12_2, _turn_rate_12_2, _cos_12_2, _sin_12_2 = ring_round_11(_along_0_2, _along_1_2, _along_10_2, _along_11_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _along_9_2, _around_0_2, _around_1_2, _around_10_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _around_7_2, _around_8_2, _around_9_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_10_2, _climb_11_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _climb_9_2, _cos_0_2, _cos_1_2, _cos_10_2, _cos_11_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cos_9_2, _cosine_0_2, _cosine_1_2, _cosine_10_2, _cosine_11_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _cosine_9_2, _p_gravity_2, _near_0_2, _near_1_2, _near_10_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _near_7_2, _near_8_2, _near_9_2, _omega_0_2, _omega_1_2, _omega_10_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _omega_7_2, _omega_8_2, _omega_9_2, _pressed_0_2, _pressed_1_2, _pressed_10_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _pressed_7_2, _pressed_8_2, _pressed_9_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_10_2, _sin_11_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sin_9_2, _sine_0_2, _sine_1_2, _sine_10_2, _sine_11_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _sine_9_2, _tilted_0_2, _tilted_1_2, _tilted_10_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _tilted_7_2, _tilted_8_2, _tilted_9_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_10_2, _turn_rate_11_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _turn_rate_9_2, _p_wire_radius_2, _room_2)
                _stride_2, _strongest_2, _fastest_2, _sway_2, _force_2, _force_rate_2, _force_bend_2, _brace_2, _vx_1_2, _vy_1_2, _vz_1_2 = ring_round_pace(_along_0_2, _along_1_2, _along_10_2, _along_11_2, _along_12_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _along_9_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_10_2, _climb_11_2, _climb_12_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _climb_9_2, _cos_0_2, _cos_12_2, _cosine_0_2, _cosine_12_2, _force_0_2, _force_1_2, _force_10_2, _force_11_2, _force_2_2, _force_3_2, _force_4_2, _force_5_2, _force_6_2, _force_7_2, _force_8_2, _force_9_2, _p_gravity_2, _omega_0_2, _p_ring_radius_2, _sin_0_2, _sin_12_2, _sine_0_2, _sine_12_2, _turn_rate_0_2, _turn_rate_11_2, _turn_rate_12_2, _p_wire_radius_2, _room_2)
                _drag_2, _drag_rate_2, *_ = ring_round_pulled(_climb_0_2, _climb_1_2, _cosine_0_2, _cosine_1_2, _p_gravity_2, _omega_0_2, _omega_1_2, _turn_rate_0_2, _turn_rate_1_2, _room_2)
                _strain_2, _strain_rate_2 = ring_impact_strained(_drag_2, _drag_rate_2, _force_2, _force_rate_2, _p_ring_friction_2)
                _loses_2, = losing(_grip_lost_2, _strain_2)
                _rows107, _count108 = _rows(_loses_2, _count106)
                if _count108:
                    _clock_3 = _take(_clock_2, _rows107)
                    _strain_3 = _take(_strain_2, _rows107)
                    _strain_rate_3 = _take(_strain_rate_2, _rows107)
                    _taut_3 = _take(_taut_2, _rows107)
                    _taut_clock_3 = _take(_taut_clock_2, _rows107)
                    _taut_rate_3 = _take(_taut_rate_2, _rows107)
                    _room_3 = room(_count108)
                    _grip_lost_3, = lost_grip(_clock_3, _strain_3, _strain_rate_3, _taut_3, _taut_clock_3, _taut_rate_3, _room_3)
                    _grip_lost_2 = _put(_grip_lost_2, _rows107, _grip_lost_3, _count106)
                _taut_2, _taut_rate_2, _taut_clock_2 = tightened(_clock_2, _strain_2, _strain_rate_2)
                _stride_2, _which_2, _rests_2, _doubt_2 = leaving_force(_p_ball_radius_2, _brace_2, _doubt_2, _fastest_2, _force_2, _force_bend_2, _force_rate_2, _p_gravity_2, _per_reach_2, _position_error_2, _stride_2, _velocity_error_2, _vx_2, _vx_1_2, _vy_2, _vy_1_2, _vz_2, _vz_1_2, _which_2, _room_2)
                _gap_2, _nearing_2, _dent_2 = backboard_beside(_p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2, _room_2)
                _stride_2, _which_2, _doubt_2, _late_2 = beside_body(_p_ball_radius_2, _dent_2, _doubt_2, _fastest_2, _gap_2, 1.0, _late_2, _nearing_2, _position_error_2, _stride_2, _strongest_2, _which_2, _x_2, _y_2, _z_2, _room_2)
                _gap_2, _nearing_2, _dent_2 = bridge_beside(_p_ball_radius_2, _p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _p_ring_radius_2, _vx_2, _vy_2, _vz_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
                _stride_2, _which_2, _doubt_2, _late_2 = beside_body(_p_ball_radius_2, _dent_2, _doubt_2, _fastest_2, _gap_2, 2.0, _late_2, _nearing_2, _position_error_2, _stride_2, _strongest_2, _which_2, _x_2, _y_2, _z_2, _room_2)
                _gap_2, _nearing_2, _dent_2 = end_beside(_p_end_depth_2, _vz_2, _z_2)
                _stride_2, _which_2, _doubt_2, _late_2 = beside_gate(_p_ball_radius_2, _dent_2, _doubt_2, _fastest_2, _gap_2, 3.0, _late_2, _nearing_2, _position_error_2, _stride_2, _strongest_2, _which_2, _x_2, _y_2, _z_2, _room_2)
                _stride_2, _which_2 = beside_time(_clock_2, _stride_2, _time_limit_2, _which_2)
                _apart_2, = apart(_p_ball_radius_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _dx_2, _dy_2, _dz_2, _room_2)
                _far_x_2, _far_y_2, _far_z_2, _far_vx_2, _far_vy_2, _far_vz_2, _far_wx_2, _far_wy_2, _far_wz_2, *_ = neighbour(_apart_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _dx_2, _dy_2, _dz_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _x_2, _y_2, _z_2, _room_2)
                _over_2, = passing_from(_z_2)
                _berth_2, *_ = alone()
                _forth_2, _back_2 = leaps(_stride_2)
                _gap_2, _nearing_2 = backboard_around(_p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2, _room_2)
                _berth_2, = cleared(_berth_2, _gap_2, _forth_2, _nearing_2)
                _gap_2, _nearing_2 = bridge_around(_p_ball_radius_2, _p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _p_ring_radius_2, _vx_2, _vy_2, _vz_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
                _berth_2, = cleared(_berth_2, _gap_2, _forth_2, _nearing_2)
                _gap_2, _nearing_2 = end_around(_p_end_depth_2, _vz_2, _z_2)
                _berth_2, = cleared(_berth_2, _gap_2, _forth_2, _nearing_2)
                _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _climb_2 = ring_round_moved(_along_0_2, _along_1_2, _along_10_2, _along_11_2, _along_12_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _along_9_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_10_2, _climb_11_2, _climb_12_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _climb_9_2, _cos_0_2, _cos_1_2, _cos_10_2, _cos_11_2, _cos_12_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cos_9_2, _cosine_0_2, _cosine_1_2, _cosine_10_2, _cosine_11_2, _cosine_12_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _cosine_9_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_10_2, _sin_11_2, _sin_12_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sin_9_2, _sine_0_2, _sine_1_2, _sine_10_2, _sine_11_2, _sine_12_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _sine_9_2, _stride_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_10_2, _turn_rate_11_2, _turn_rate_12_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _turn_rate_9_2, _p_wire_radius_2, _room_2)
                _through_2, = passing_in_contact(_over_2, _p_ring_radius_2, _through_2, _x_2, _y_2, _z_2)
                _gap_2, _nearing_2 = backboard_around(_p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2, _room_2)
                _berth_2, = cleared(_berth_2, _gap_2, _back_2, _nearing_2)
                _gap_2, _nearing_2 = bridge_around(_p_ball_radius_2, _p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _p_ring_radius_2, _vx_2, _vy_2, _vz_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
                _berth_2, = cleared(_berth_2, _gap_2, _back_2, _nearing_2)
                _gap_2, _nearing_2 = end_around(_p_end_depth_2, _vz_2, _z_2)
                _berth_2, = cleared(_berth_2, _gap_2, _back_2, _nearing_2)
                _circled_2, _endless_2, _doubt_2 = ring_swung(_p_ball_radius_2, _berth_2, _circled_2, _climb_2, _climb_0_2, _doubt_2, _fastest_2, _force_2, _force_bend_2, _force_rate_2, _p_gravity_2, _position_error_2, _stride_2, _sway_2, _velocity_error_2, _which_2, _p_wire_radius_2, _room_2)
                _which_2, = for_ever(_endless_2, _which_2)
                _cosine_0_2, _sine_0_2, _climb_0_2, _along_0_2, _turn_rate_0_2, _cos_0_2, _sin_0_2, _near_0_2 = ring_round_start(_p_ball_radius_2, _p_ring_radius_2, _far_vx_2, _far_vy_2, _far_vz_2, _p_wire_radius_2, _far_wx_2, _far_wy_2, _far_wz_2, _far_x_2, _far_y_2, _far_z_2, _room_2)
                _omega_0_2, _around_0_2, _tilted_0_2, _pressed_0_2, _, _cosine_1_2, _sine_1_2, _climb_1_2, _along_1_2, _turn_rate_1_2, _cos_1_2, _sin_1_2 = ring_round_0(_along_0_2, _p_ball_radius_2, _climb_0_2, _cos_0_2, _cosine_0_2, _p_gravity_2, _near_0_2, _p_ring_radius_2, _sin_0_2, _sine_0_2, _turn_rate_0_2, _p_wire_radius_2, _room_2)
                _near_1_2, _omega_1_2, _around_1_2, _tilted_1_2, _pressed_1_2, _, _cosine_2_2, _sine_2_2, _climb_2_2, _along_2_2, _turn_rate_2_2, _cos_2_2, _sin_2_2 = ring_round_1(_along_0_2, _along_1_2, _around_0_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _cos_0_2, _cos_1_2, _cosine_0_2, _cosine_1_2, _p_gravity_2, _near_0_2, _omega_0_2, _pressed_0_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sine_0_2, _sine_1_2, _tilted_0_2, _turn_rate_0_2, _turn_rate_1_2, _p_wire_radius_2, _room_2)
                _near_2_2, _omega_2_2, _around_2_2, _tilted_2_2, _pressed_2_2, _, _cosine_3_2, _sine_3_2, _climb_3_2, _along_3_2, _turn_rate_3_2, _cos_3_2, _sin_3_2 = ring_round_2(_along_0_2, _along_1_2, _along_2_2, _around_0_2, _around_1_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _cos_0_2, _cos_1_2, _cos_2_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _p_gravity_2, _near_0_2, _near_1_2, _omega_0_2, _omega_1_2, _pressed_0_2, _pressed_1_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sine_0_2, _sine_1_2, _sine_2_2, _tilted_0_2, _tilted_1_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _p_wire_radius_2, _room_2)
                _near_3_2, _omega_3_2, _around_3_2, _tilted_3_2, _pressed_3_2, _, _cosine_4_2, _sine_4_2, _climb_4_2, _along_4_2, _turn_rate_4_2, _cos_4_2, _sin_4_2 = ring_round_3(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _around_0_2, _around_1_2, _around_2_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _omega_0_2, _omega_1_2, _omega_2_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _p_wire_radius_2, _room_2)
                _near_4_2, _omega_4_2, _around_4_2, _tilted_4_2, _pressed_4_2, _, _cosine_5_2, _sine_5_2, _climb_5_2, _along_5_2, _turn_rate_5_2, _cos_5_2, _sin_5_2 = ring_round_4(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _p_wire_radius_2, _room_2)
                _near_5_2, _omega_5_2, _around_5_2, _tilted_5_2, _pressed_5_2, _, _cosine_6_2, _sine_6_2, _climb_6_2, _along_6_2, _turn_rate_6_2, _cos_6_2, _sin_6_2 = ring_round_5(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _p_wire_radius_2, _room_2)
                _near_6_2, _omega_6_2, _around_6_2, _tilted_6_2, _pressed_6_2, _, _cosine_7_2, _sine_7_2, _climb_7_2, _along_7_2, _turn_rate_7_2, _cos_7_2, _sin_7_2 = ring_round_6(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _p_wire_radius_2, _room_2)
                _near_7_2, _omega_7_2, _around_7_2, _tilted_7_2, _pressed_7_2, _, _cosine_8_2, _sine_8_2, _climb_8_2, _along_8_2, _turn_rate_8_2, _cos_8_2, _sin_8_2 = ring_round_7(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _p_wire_radius_2, _room_2)
                _near_8_2, _omega_8_2, _around_8_2, _tilted_8_2, _pressed_8_2, _, _cosine_9_2, _sine_9_2, _climb_9_2, _along_9_2, _turn_rate_9_2, _cos_9_2, _sin_9_2 = ring_round_8(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _around_7_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _near_7_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _omega_7_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _pressed_7_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _tilted_7_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _p_wire_radius_2, _room_2)
                _near_9_2, _omega_9_2, _around_9_2, _tilted_9_2, _pressed_9_2, _, _cosine_10_2, _sine_10_2, _climb_10_2, _along_10_2, _turn_rate_10_2, _cos_10_2, _sin_10_2 = ring_round_9(_along_0_2, _along_1_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _along_9_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _around_7_2, _around_8_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _climb_9_2, _cos_0_2, _cos_1_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cos_9_2, _cosine_0_2, _cosine_1_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _cosine_9_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _near_7_2, _near_8_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _omega_7_2, _omega_8_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _pressed_7_2, _pressed_8_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sin_9_2, _sine_0_2, _sine_1_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _sine_9_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _tilted_7_2, _tilted_8_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _turn_rate_9_2, _p_wire_radius_2, _room_2)
                _near_10_2, _omega_10_2, _around_10_2, _tilted_10_2, _pressed_10_2, _, _cosine_11_2, _sine_11_2, _climb_11_2, _along_11_2, _turn_rate_11_2, _cos_11_2, _sin_11_2 = ring_round_10(_along_0_2, _along_1_2, _along_10_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _along_9_2, _around_0_2, _around_1_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _around_7_2, _around_8_2, _around_9_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_10_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _climb_9_2, _cos_0_2, _cos_1_2, _cos_10_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cos_9_2, _cosine_0_2, _cosine_1_2, _cosine_10_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _cosine_9_2, _p_gravity_2, _near_0_2, _near_1_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _near_7_2, _near_8_2, _near_9_2, _omega_0_2, _omega_1_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _omega_7_2, _omega_8_2, _omega_9_2, _pressed_0_2, _pressed_1_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _pressed_7_2, _pressed_8_2, _pressed_9_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_10_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sin_9_2, _sine_0_2, _sine_1_2, _sine_10_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _sine_9_2, _tilted_0_2, _tilted_1_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _tilted_7_2, _tilted_8_2, _tilted_9_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_10_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _turn_rate_9_2, _p_wire_radius_2, _room_2)
                _, _, _, _, _, _, _cosine_12_2, _sine_12_2, _climb_12_2, _along_12_2, _turn_rate_12_2, _cos_12_2, _sin_12_2 = ring_round_11(_along_0_2, _along_1_2, _along_10_2, _along_11_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _along_9_2, _around_0_2, _around_1_2, _around_10_2, _around_2_2, _around_3_2, _around_4_2, _around_5_2, _around_6_2, _around_7_2, _around_8_2, _around_9_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_10_2, _climb_11_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _climb_9_2, _cos_0_2, _cos_1_2, _cos_10_2, _cos_11_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cos_9_2, _cosine_0_2, _cosine_1_2, _cosine_10_2, _cosine_11_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _cosine_9_2, _p_gravity_2, _near_0_2, _near_1_2, _near_10_2, _near_2_2, _near_3_2, _near_4_2, _near_5_2, _near_6_2, _near_7_2, _near_8_2, _near_9_2, _omega_0_2, _omega_1_2, _omega_10_2, _omega_2_2, _omega_3_2, _omega_4_2, _omega_5_2, _omega_6_2, _omega_7_2, _omega_8_2, _omega_9_2, _pressed_0_2, _pressed_1_2, _pressed_10_2, _pressed_2_2, _pressed_3_2, _pressed_4_2, _pressed_5_2, _pressed_6_2, _pressed_7_2, _pressed_8_2, _pressed_9_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_10_2, _sin_11_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sin_9_2, _sine_0_2, _sine_1_2, _sine_10_2, _sine_11_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _sine_9_2, _tilted_0_2, _tilted_1_2, _tilted_10_2, _tilted_2_2, _tilted_3_2, _tilted_4_2, _tilted_5_2, _tilted_6_2, _tilted_7_2, _tilted_8_2, _tilted_9_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_10_2, _turn_rate_11_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _turn_rate_9_2, _p_wire_radius_2, _room_2)
                _far_x_2, _far_y_2, _far_z_2, _far_vx_2, _far_vy_2, _far_vz_2, _far_wx_2, _far_wy_2, _far_wz_2, *_ = ring_round_moved(_along_0_2, _along_1_2, _along_10_2, _along_11_2, _along_12_2, _along_2_2, _along_3_2, _along_4_2, _along_5_2, _along_6_2, _along_7_2, _along_8_2, _along_9_2, _p_ball_radius_2, _climb_0_2, _climb_1_2, _climb_10_2, _climb_11_2, _climb_12_2, _climb_2_2, _climb_3_2, _climb_4_2, _climb_5_2, _climb_6_2, _climb_7_2, _climb_8_2, _climb_9_2, _cos_0_2, _cos_1_2, _cos_10_2, _cos_11_2, _cos_12_2, _cos_2_2, _cos_3_2, _cos_4_2, _cos_5_2, _cos_6_2, _cos_7_2, _cos_8_2, _cos_9_2, _cosine_0_2, _cosine_1_2, _cosine_10_2, _cosine_11_2, _cosine_12_2, _cosine_2_2, _cosine_3_2, _cosine_4_2, _cosine_5_2, _cosine_6_2, _cosine_7_2, _cosine_8_2, _cosine_9_2, _p_ring_radius_2, _sin_0_2, _sin_1_2, _sin_10_2, _sin_11_2, _sin_12_2, _sin_2_2, _sin_3_2, _sin_4_2, _sin_5_2, _sin_6_2, _sin_7_2, _sin_8_2, _sin_9_2, _sine_0_2, _sine_1_2, _sine_10_2, _sine_11_2, _sine_12_2, _sine_2_2, _sine_3_2, _sine_4_2, _sine_5_2, _sine_6_2, _sine_7_2, _sine_8_2, _sine_9_2, _stride_2, _turn_rate_0_2, _turn_rate_1_2, _turn_rate_10_2, _turn_rate_11_2, _turn_rate_12_2, _turn_rate_2_2, _turn_rate_3_2, _turn_rate_4_2, _turn_rate_5_2, _turn_rate_6_2, _turn_rate_7_2, _turn_rate_8_2, _turn_rate_9_2, _p_wire_radius_2, _room_2)
                _dx_2, _dy_2, _dz_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2 = compared(_apart_2, _p_ball_radius_2, _far_vx_2, _far_vy_2, _far_vz_2, _far_wx_2, _far_wy_2, _far_wz_2, _far_x_2, _far_y_2, _far_z_2, _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _x_2, _y_2, _z_2, _room_2)
                _clock_2, _circling_2 = rolled_on(_clock_2, _rests_2, _stride_2, _which_2)
                _going109 = _where_true(_circling_2)
                if len(_going109) == _count106:
                    continue
                _done = _where_true(_logical_not(_circling_2))
                _store(_circled_1, _of(_rows105, _done), _circled_2, _done)
                _store(_circling_1, _of(_rows105, _done), _circling_2, _done)
                _store(_clock_1, _of(_rows105, _done), _clock_2, _done)
                _store(_doubt_1, _of(_rows105, _done), _doubt_2, _done)
                _store(_dvx_1, _of(_rows105, _done), _dvx_2, _done)
                _store(_dvy_1, _of(_rows105, _done), _dvy_2, _done)
                _store(_dvz_1, _of(_rows105, _done), _dvz_2, _done)
                _store(_dwx_1, _of(_rows105, _done), _dwx_2, _done)
                _store(_dwy_1, _of(_rows105, _done), _dwy_2, _done)
                _store(_dwz_1, _of(_rows105, _done), _dwz_2, _done)
                _store(_dx_1, _of(_rows105, _done), _dx_2, _done)
                _store(_dy_1, _of(_rows105, _done), _dy_2, _done)
                _store(_dz_1, _of(_rows105, _done), _dz_2, _done)
                _store(_grip_lost_1, _of(_rows105, _done), _grip_lost_2, _done)
                _store(_late_1, _of(_rows105, _done), _late_2, _done)
                _store(_per_reach_1, _of(_rows105, _done), _per_reach_2, _done)
                _store(_position_error_1, _of(_rows105, _done), _position_error_2, _done)
                _store(_rests_1, _of(_rows105, _done), _rests_2, _done)
                _store(_taut_1, _of(_rows105, _done), _taut_2, _done)
                _store(_taut_clock_1, _of(_rows105, _done), _taut_clock_2, _done)
                _store(_taut_rate_1, _of(_rows105, _done), _taut_rate_2, _done)
                _store(_through_1, _of(_rows105, _done), _through_2, _done)
                _store(_velocity_error_1, _of(_rows105, _done), _velocity_error_2, _done)
                _store(_vx_1, _of(_rows105, _done), _vx_2, _done)
                _store(_vy_1, _of(_rows105, _done), _vy_2, _done)
                _store(_vz_1, _of(_rows105, _done), _vz_2, _done)
                _store(_which_1, _of(_rows105, _done), _which_2, _done)
                _store(_wx_1, _of(_rows105, _done), _wx_2, _done)
                _store(_wy_1, _of(_rows105, _done), _wy_2, _done)
                _store(_wz_1, _of(_rows105, _done), _wz_2, _done)
                _store(_x_1, _of(_rows105, _done), _x_2, _done)
                _store(_y_1, _of(_rows105, _done), _y_2, _done)
                _store(_z_1, _of(_rows105, _done), _z_2, _done)
                _rows105, _count106 = _of(_rows105, _going109), len(_going109)
                if not _count106:
                    break
                _circled_2 = _take(_circled_2, _going109)
                _circling_2 = _take(_circling_2, _going109)
                _clock_2 = _take(_clock_2, _going109)
                _clock_error_2 = _take(_clock_error_2, _going109)
                _doubt_2 = _take(_doubt_2, _going109)
                _dvx_2 = _take(_dvx_2, _going109)
                _dvy_2 = _take(_dvy_2, _going109)
                _dvz_2 = _take(_dvz_2, _going109)
                _dwx_2 = _take(_dwx_2, _going109)
                _dwy_2 = _take(_dwy_2, _going109)
                _dwz_2 = _take(_dwz_2, _going109)
                _dx_2 = _take(_dx_2, _going109)
                _dy_2 = _take(_dy_2, _going109)
                _dz_2 = _take(_dz_2, _going109)
                _grip_lost_2 = _take(_grip_lost_2, _going109)
                _late_2 = _take(_late_2, _going109)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going109)
                _p_board_bottom_2 = _take(_p_board_bottom_2, _going109)
                _p_board_distance_2 = _take(_p_board_distance_2, _going109)
                _p_board_half_width_2 = _take(_p_board_half_width_2, _going109)
                _p_board_thickness_2 = _take(_p_board_thickness_2, _going109)
                _p_board_top_2 = _take(_p_board_top_2, _going109)
                _p_bridge_depth_2 = _take(_p_bridge_depth_2, _going109)
                _p_bridge_half_width_2 = _take(_p_bridge_half_width_2, _going109)
                _p_end_depth_2 = _take(_p_end_depth_2, _going109)
                _p_gravity_2 = _take(_p_gravity_2, _going109)
                _p_ring_friction_2 = _take(_p_ring_friction_2, _going109)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going109)
                _p_wire_radius_2 = _take(_p_wire_radius_2, _going109)
                _per_reach_2 = _take(_per_reach_2, _going109)
                _position_error_2 = _take(_position_error_2, _going109)
                _rests_2 = _take(_rests_2, _going109)
                _taut_2 = _take(_taut_2, _going109)
                _taut_clock_2 = _take(_taut_clock_2, _going109)
                _taut_rate_2 = _take(_taut_rate_2, _going109)
                _through_2 = _take(_through_2, _going109)
                _time_limit_2 = _take(_time_limit_2, _going109)
                _velocity_error_2 = _take(_velocity_error_2, _going109)
                _vx_2 = _take(_vx_2, _going109)
                _vy_2 = _take(_vy_2, _going109)
                _vz_2 = _take(_vz_2, _going109)
                _which_2 = _take(_which_2, _going109)
                _wx_2 = _take(_wx_2, _going109)
                _wy_2 = _take(_wy_2, _going109)
                _wz_2 = _take(_wz_2, _going109)
                _x_2 = _take(_x_2, _going109)
                _y_2 = _take(_y_2, _going109)
                _z_2 = _take(_z_2, _going109)
            else:
                _store(_circled_1, _rows105, _circled_2, None)
                _store(_circling_1, _rows105, _circling_2, None)
                _store(_clock_1, _rows105, _clock_2, None)
                _store(_doubt_1, _rows105, _doubt_2, None)
                _store(_dvx_1, _rows105, _dvx_2, None)
                _store(_dvy_1, _rows105, _dvy_2, None)
                _store(_dvz_1, _rows105, _dvz_2, None)
                _store(_dwx_1, _rows105, _dwx_2, None)
                _store(_dwy_1, _rows105, _dwy_2, None)
                _store(_dwz_1, _rows105, _dwz_2, None)
                _store(_dx_1, _rows105, _dx_2, None)
                _store(_dy_1, _rows105, _dy_2, None)
                _store(_dz_1, _rows105, _dz_2, None)
                _store(_grip_lost_1, _rows105, _grip_lost_2, None)
                _store(_late_1, _rows105, _late_2, None)
                _store(_per_reach_1, _rows105, _per_reach_2, None)
                _store(_position_error_1, _rows105, _position_error_2, None)
                _store(_rests_1, _rows105, _rests_2, None)
                _store(_taut_1, _rows105, _taut_2, None)
                _store(_taut_clock_1, _rows105, _taut_clock_2, None)
                _store(_taut_rate_1, _rows105, _taut_rate_2, None)
                _store(_through_1, _rows105, _through_2, None)
                _store(_velocity_error_1, _rows105, _velocity_error_2, None)
                _store(_vx_1, _rows105, _vx_2, None)
                _store(_vy_1, _rows105, _vy_2, None)
                _store(_vz_1, _rows105, _vz_2, None)
                _store(_which_1, _rows105, _which_2, None)
                _store(_wx_1, _rows105, _wx_2, None)
                _store(_wy_1, _rows105, _wy_2, None)
                _store(_wz_1, _rows105, _wz_2, None)
                _store(_x_1, _rows105, _x_2, None)
                _store(_y_1, _rows105, _y_2, None)
                _store(_z_1, _rows105, _z_2, None)
        _rolling_1, = rejoined(_circling_1, _rolling_1)
        _rows110, _count111 = _rows(_leaves_1, _count67)
        if _count111:
            _clock_error_2 = _take(_clock_error_1, _rows110)
            _doubt_2 = _take(_doubt_1, _rows110)
            _dvx_2 = _take(_dvx_1, _rows110)
            _dvy_2 = _take(_dvy_1, _rows110)
            _dvz_2 = _take(_dvz_1, _rows110)
            _dwx_2 = _take(_dwx_1, _rows110)
            _dwy_2 = _take(_dwy_1, _rows110)
            _dwz_2 = _take(_dwz_1, _rows110)
            _dx_2 = _take(_dx_1, _rows110)
            _dy_2 = _take(_dy_1, _rows110)
            _dz_2 = _take(_dz_1, _rows110)
            _held_2 = _take(_held_1, _rows110)
            _lift_2 = _take(_lift_1, _rows110)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows110)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows110)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows110)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows110)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows110)
            _p_board_top_2 = _take(_p_board_top_1, _rows110)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows110)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows110)
            _p_end_depth_2 = _take(_p_end_depth_1, _rows110)
            _p_gravity_2 = _take(_p_gravity_1, _rows110)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows110)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows110)
            _per_reach_2 = _take(_per_reach_1, _rows110)
            _snap_2 = _take(_snap_1, _rows110)
            _surge_2 = _take(_surge_1, _rows110)
            _vx_2 = _take(_vx_1, _rows110)
            _vy_2 = _take(_vy_1, _rows110)
            _vz_2 = _take(_vz_1, _rows110)
            _x_2 = _take(_x_1, _rows110)
            _y_2 = _take(_y_1, _rows110)
            _z_2 = _take(_z_1, _rows110)
            _room_2 = room(_count111)
            _position_error_2, _velocity_error_2, *_ = error_bounds(_clock_error_2, _dx_2, _dy_2, _dz_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _room_2)
            _here_2, = holding(_held_2, 0.0)
            _rows112, _count113 = _rows(_here_2, _count111)
            if _count113:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows112)
                _p_gravity_3 = _take(_p_gravity_2, _rows112)
                _p_ring_radius_3 = _take(_p_ring_radius_2, _rows112)
                _p_wire_radius_3 = _take(_p_wire_radius_2, _rows112)
                _vx_3 = _take(_vx_2, _rows112)
                _vy_3 = _take(_vy_2, _rows112)
                _vz_3 = _take(_vz_2, _rows112)
                _x_3 = _take(_x_2, _rows112)
                _y_3 = _take(_y_2, _rows112)
                _z_3 = _take(_z_2, _rows112)
                _room_3 = room(_count113)
                _, _, _, _per_reach_3 = ring_tube(_p_ball_radius_3, _p_wire_radius_3)
                _lift_3, _surge_3, _snap_3 = ring_parting(_p_gravity_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3, _room_3)
                _lift_2 = _put(_lift_2, _rows112, _lift_3, _count111)
                _per_reach_2 = _put(_per_reach_2, _rows112, _per_reach_3, _count111)
                _snap_2 = _put(_snap_2, _rows112, _snap_3, _count111)
                _surge_2 = _put(_surge_2, _rows112, _surge_3, _count111)
            _here_2, = holding(_held_2, 1.0)
            _rows114, _count115 = _rows(_here_2, _count111)
            if _count115:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows114)
                _p_board_bottom_3 = _take(_p_board_bottom_2, _rows114)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows114)
                _p_board_half_width_3 = _take(_p_board_half_width_2, _rows114)
                _p_board_thickness_3 = _take(_p_board_thickness_2, _rows114)
                _p_board_top_3 = _take(_p_board_top_2, _rows114)
                _p_gravity_3 = _take(_p_gravity_2, _rows114)
                _vx_3 = _take(_vx_2, _rows114)
                _vy_3 = _take(_vy_2, _rows114)
                _vz_3 = _take(_vz_2, _rows114)
                _x_3 = _take(_x_2, _rows114)
                _y_3 = _take(_y_2, _rows114)
                _z_3 = _take(_z_2, _rows114)
                _room_3 = room(_count115)
                _, _, _, _per_reach_3 = backboard_tube(_p_ball_radius_3, _p_board_bottom_3, _p_board_distance_3, _p_board_half_width_3, _p_board_thickness_3, _p_board_top_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3, _room_3)
                _lift_3, _surge_3, _snap_3 = backboard_parting(_p_board_bottom_3, _p_board_distance_3, _p_board_half_width_3, _p_board_thickness_3, _p_board_top_3, _p_gravity_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3, _room_3)
                _lift_2 = _put(_lift_2, _rows114, _lift_3, _count111)
                _per_reach_2 = _put(_per_reach_2, _rows114, _per_reach_3, _count111)
                _snap_2 = _put(_snap_2, _rows114, _snap_3, _count111)
                _surge_2 = _put(_surge_2, _rows114, _surge_3, _count111)
            _here_2, = holding(_held_2, 2.0)
            _rows116, _count117 = _rows(_here_2, _count111)
            if _count117:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows116)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows116)
                _p_bridge_depth_3 = _take(_p_bridge_depth_2, _rows116)
                _p_bridge_half_width_3 = _take(_p_bridge_half_width_2, _rows116)
                _p_gravity_3 = _take(_p_gravity_2, _rows116)
                _p_ring_radius_3 = _take(_p_ring_radius_2, _rows116)
                _p_wire_radius_3 = _take(_p_wire_radius_2, _rows116)
                _vx_3 = _take(_vx_2, _rows116)
                _vy_3 = _take(_vy_2, _rows116)
                _vz_3 = _take(_vz_2, _rows116)
                _x_3 = _take(_x_2, _rows116)
                _y_3 = _take(_y_2, _rows116)
                _z_3 = _take(_z_2, _rows116)
                _room_3 = room(_count117)
                _, _, _, _per_reach_3 = bridge_tube(_p_ball_radius_3, _p_board_distance_3, _p_bridge_depth_3, _p_bridge_half_width_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                _lift_3, _surge_3, _snap_3 = bridge_parting(_p_board_distance_3, _p_bridge_depth_3, _p_bridge_half_width_3, _p_gravity_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                _lift_2 = _put(_lift_2, _rows116, _lift_3, _count111)
                _per_reach_2 = _put(_per_reach_2, _rows116, _per_reach_3, _count111)
                _snap_2 = _put(_snap_2, _rows116, _snap_3, _count111)
                _surge_2 = _put(_surge_2, _rows116, _surge_3, _count111)
            _spare_2, = unmet()
            _beside_2, = beside(_held_2, 0.0)
            _rows118, _count119 = _rows(_beside_2, _count111)
            if _count119:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows118)
                _p_gravity_3 = _take(_p_gravity_2, _rows118)
                _p_ring_radius_3 = _take(_p_ring_radius_2, _rows118)
                _p_wire_radius_3 = _take(_p_wire_radius_2, _rows118)
                _spare_3 = _take(_spare_2, _rows118)
                _vx_3 = _take(_vx_2, _rows118)
                _vy_3 = _take(_vy_2, _rows118)
                _vz_3 = _take(_vz_2, _rows118)
                _x_3 = _take(_x_2, _rows118)
                _y_3 = _take(_y_2, _rows118)
                _z_3 = _take(_z_2, _rows118)
                _room_3 = room(_count119)
                _gap_3, _nearing_3, _dent_3 = ring_beside(_p_ball_radius_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                _spare_3, = spared(_dent_3, _gap_3, _p_gravity_3, _nearing_3, _spare_3, _vx_3, _vy_3, _vz_3, _room_3)
                _spare_2 = _put(_spare_2, _rows118, _spare_3, _count111)
            _beside_2, = beside(_held_2, 1.0)
            _rows120, _count121 = _rows(_beside_2, _count111)
            if _count121:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows120)
                _p_board_bottom_3 = _take(_p_board_bottom_2, _rows120)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows120)
                _p_board_half_width_3 = _take(_p_board_half_width_2, _rows120)
                _p_board_thickness_3 = _take(_p_board_thickness_2, _rows120)
                _p_board_top_3 = _take(_p_board_top_2, _rows120)
                _p_gravity_3 = _take(_p_gravity_2, _rows120)
                _spare_3 = _take(_spare_2, _rows120)
                _vx_3 = _take(_vx_2, _rows120)
                _vy_3 = _take(_vy_2, _rows120)
                _vz_3 = _take(_vz_2, _rows120)
                _x_3 = _take(_x_2, _rows120)
                _y_3 = _take(_y_2, _rows120)
                _z_3 = _take(_z_2, _rows120)
                _room_3 = room(_count121)
                _gap_3, _nearing_3, _dent_3 = backboard_beside(_p_ball_radius_3, _p_board_bottom_3, _p_board_distance_3, _p_board_half_width_3, _p_board_thickness_3, _p_board_top_3, _vx_3, _vy_3, _vz_3, _x_3, _y_3, _z_3, _room_3)
                _spare_3, = spared(_dent_3, _gap_3, _p_gravity_3, _nearing_3, _spare_3, _vx_3, _vy_3, _vz_3, _room_3)
                _spare_2 = _put(_spare_2, _rows120, _spare_3, _count111)
            _beside_2, = beside(_held_2, 2.0)
            _rows122, _count123 = _rows(_beside_2, _count111)
            if _count123:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows122)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows122)
                _p_bridge_depth_3 = _take(_p_bridge_depth_2, _rows122)
                _p_bridge_half_width_3 = _take(_p_bridge_half_width_2, _rows122)
                _p_gravity_3 = _take(_p_gravity_2, _rows122)
                _p_ring_radius_3 = _take(_p_ring_radius_2, _rows122)
                _p_wire_radius_3 = _take(_p_wire_radius_2, _rows122)
                _spare_3 = _take(_spare_2, _rows122)
                _vx_3 = _take(_vx_2, _rows122)
                _vy_3 = _take(_vy_2, _rows122)
                _vz_3 = _take(_vz_2, _rows122)
                _x_3 = _take(_x_2, _rows122)
                _y_3 = _take(_y_2, _rows122)
                _z_3 = _take(_z_2, _rows122)
                _room_3 = room(_count123)
                _gap_3, _nearing_3, _dent_3 = bridge_beside(_p_ball_radius_3, _p_board_distance_3, _p_bridge_depth_3, _p_bridge_half_width_3, _p_ring_radius_3, _vx_3, _vy_3, _vz_3, _p_wire_radius_3, _x_3, _y_3, _z_3, _room_3)
                _spare_3, = spared(_dent_3, _gap_3, _p_gravity_3, _nearing_3, _spare_3, _vx_3, _vy_3, _vz_3, _room_3)
                _spare_2 = _put(_spare_2, _rows122, _spare_3, _count111)
            _beside_2, = beside(_held_2, 3.0)
            _rows124, _count125 = _rows(_beside_2, _count111)
            if _count125:
                _p_end_depth_3 = _take(_p_end_depth_2, _rows124)
                _p_gravity_3 = _take(_p_gravity_2, _rows124)
                _spare_3 = _take(_spare_2, _rows124)
                _vx_3 = _take(_vx_2, _rows124)
                _vy_3 = _take(_vy_2, _rows124)
                _vz_3 = _take(_vz_2, _rows124)
                _z_3 = _take(_z_2, _rows124)
                _room_3 = room(_count125)
                _gap_3, _nearing_3, _dent_3 = end_beside(_p_end_depth_3, _vz_3, _z_3)
                _spare_3, = spared(_dent_3, _gap_3, _p_gravity_3, _nearing_3, _spare_3, _vx_3, _vy_3, _vz_3, _room_3)
                _spare_2 = _put(_spare_2, _rows124, _spare_3, _count111)
            _here_2, = holding(_held_2, 1.0)
            _rows126, _count127 = _rows(_here_2, _count111)
            if _count127:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows126)
                _p_board_bottom_3 = _take(_p_board_bottom_2, _rows126)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows126)
                _p_board_half_width_3 = _take(_p_board_half_width_2, _rows126)
                _p_board_thickness_3 = _take(_p_board_thickness_2, _rows126)
                _p_board_top_3 = _take(_p_board_top_2, _rows126)
                _p_gravity_3 = _take(_p_gravity_2, _rows126)
                _spare_3 = _take(_spare_2, _rows126)
                _vx_3 = _take(_vx_2, _rows126)
                _vy_3 = _take(_vy_2, _rows126)
                _vz_3 = _take(_vz_2, _rows126)
                _x_3 = _take(_x_2, _rows126)
                _y_3 = _take(_y_2, _rows126)
                _z_3 = _take(_z_2, _rows126)
                _room_3 = room(_count127)
                _gap_3, _nearing_3, _near_3 = backboard_seam0(_p_ball_radius_3, _p_board_distance_3, _p_board_thickness_3, _vx_3, _x_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = backboard_seam1(_p_ball_radius_3, _p_board_distance_3, _p_board_thickness_3, _vx_3, _x_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = backboard_seam2(_p_ball_radius_3, _p_board_half_width_3, _vy_3, _y_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = backboard_seam3(_p_ball_radius_3, _p_board_half_width_3, _vy_3, _y_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = backboard_seam4(_p_ball_radius_3, _p_board_bottom_3, _p_board_top_3, _vz_3, _z_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = backboard_seam5(_p_ball_radius_3, _p_board_bottom_3, _p_board_top_3, _vz_3, _z_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _spare_2 = _put(_spare_2, _rows126, _spare_3, _count111)
            _here_2, = holding(_held_2, 2.0)
            _rows128, _count129 = _rows(_here_2, _count111)
            if _count129:
                _p_ball_radius_3 = _take(_p_ball_radius_2, _rows128)
                _p_board_distance_3 = _take(_p_board_distance_2, _rows128)
                _p_bridge_depth_3 = _take(_p_bridge_depth_2, _rows128)
                _p_bridge_half_width_3 = _take(_p_bridge_half_width_2, _rows128)
                _p_gravity_3 = _take(_p_gravity_2, _rows128)
                _p_ring_radius_3 = _take(_p_ring_radius_2, _rows128)
                _p_wire_radius_3 = _take(_p_wire_radius_2, _rows128)
                _spare_3 = _take(_spare_2, _rows128)
                _vx_3 = _take(_vx_2, _rows128)
                _vy_3 = _take(_vy_2, _rows128)
                _vz_3 = _take(_vz_2, _rows128)
                _x_3 = _take(_x_2, _rows128)
                _y_3 = _take(_y_2, _rows128)
                _z_3 = _take(_z_2, _rows128)
                _room_3 = room(_count129)
                _gap_3, _nearing_3, _near_3 = bridge_seam0(_p_ball_radius_3, _p_board_distance_3, _p_ring_radius_3, _vx_3, _x_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = bridge_seam1(_p_ball_radius_3, _p_board_distance_3, _p_ring_radius_3, _vx_3, _x_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = bridge_seam2(_p_ball_radius_3, _p_bridge_half_width_3, _vy_3, _y_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = bridge_seam3(_p_ball_radius_3, _p_bridge_half_width_3, _vy_3, _y_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = bridge_seam4(_p_ball_radius_3, _p_bridge_depth_3, _vz_3, _p_wire_radius_3, _z_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _gap_3, _nearing_3, _near_3 = bridge_seam5(_p_ball_radius_3, _p_bridge_depth_3, _vz_3, _p_wire_radius_3, _z_3)
                _spare_3, = spared_seam(_gap_3, _p_gravity_3, _near_3, _nearing_3, _spare_3, _room_3)
                _spare_2 = _put(_spare_2, _rows128, _spare_3, _count111)
            _when_2, _doubt_2 = parted(_doubt_2, _p_gravity_2, _lift_2, _per_reach_2, _position_error_2, _snap_2, _spare_2, _surge_2, _velocity_error_2, _vx_2, _vy_2, _vz_2, _room_2)
            _which_2, = hopping()
            _doubt_1 = _put(_doubt_1, _rows110, _doubt_2, _count67)
            _position_error_1 = _put(_position_error_1, _rows110, _position_error_2, _count67)
            _velocity_error_1 = _put(_velocity_error_1, _rows110, _velocity_error_2, _count67)
            _when_1 = _put(_when_1, _rows110, _when_2, _count67)
            _which_1 = _put(_which_1, _rows110, _which_2, _count67)
        _began_0 = _put(_began_0, _rows66, _began_1, shots)
        _circled_0 = _put(_circled_0, _rows66, _circled_1, shots)
        _clock_0 = _put(_clock_0, _rows66, _clock_1, shots)
        _doubt_0 = _put(_doubt_0, _rows66, _doubt_1, shots)
        _dvx_0 = _put(_dvx_0, _rows66, _dvx_1, shots)
        _dvy_0 = _put(_dvy_0, _rows66, _dvy_1, shots)
        _dvz_0 = _put(_dvz_0, _rows66, _dvz_1, shots)
        _dwx_0 = _put(_dwx_0, _rows66, _dwx_1, shots)
        _dwy_0 = _put(_dwy_0, _rows66, _dwy_1, shots)
        _dwz_0 = _put(_dwz_0, _rows66, _dwz_1, shots)
        _dx_0 = _put(_dx_0, _rows66, _dx_1, shots)
        _dy_0 = _put(_dy_0, _rows66, _dy_1, shots)
        _dz_0 = _put(_dz_0, _rows66, _dz_1, shots)
        _grip_lost_0 = _put(_grip_lost_0, _rows66, _grip_lost_1, shots)
        _late_0 = _put(_late_0, _rows66, _late_1, shots)
        _position_error_0 = _put(_position_error_0, _rows66, _position_error_1, shots)
        _rests_0 = _put(_rests_0, _rows66, _rests_1, shots)
        _rolling_0 = _put(_rolling_0, _rows66, _rolling_1, shots)
        _taut_0 = _put(_taut_0, _rows66, _taut_1, shots)
        _taut_clock_0 = _put(_taut_clock_0, _rows66, _taut_clock_1, shots)
        _taut_rate_0 = _put(_taut_rate_0, _rows66, _taut_rate_1, shots)
        _through_0 = _put(_through_0, _rows66, _through_1, shots)
        _velocity_error_0 = _put(_velocity_error_0, _rows66, _velocity_error_1, shots)
        _vx_0 = _put(_vx_0, _rows66, _vx_1, shots)
        _vy_0 = _put(_vy_0, _rows66, _vy_1, shots)
        _vz_0 = _put(_vz_0, _rows66, _vz_1, shots)
        _when_0 = _put(_when_0, _rows66, _when_1, shots)
        _which_0 = _put(_which_0, _rows66, _which_1, shots)
        _wx_0 = _put(_wx_0, _rows66, _wx_1, shots)
        _wy_0 = _put(_wy_0, _rows66, _wy_1, shots)
        _wz_0 = _put(_wz_0, _rows66, _wz_1, shots)
        _x_0 = _put(_x_0, _rows66, _x_1, shots)
        _y_0 = _put(_y_0, _rows66, _y_1, shots)
        _z_0 = _put(_z_0, _rows66, _z_1, shots)
    _, _moves_0, _ends_0, _touches_0, _reached_0, _edge_0 = departed(3.0, _which_0)
    _body_0, = body_of(_which_0)
    _rows130, _count131 = _rows(_moves_0, shots)
    if _count131:
        _clock_1 = _take(_clock_0, _rows130)
        _extent_1 = _take(_extent_0, _rows130)
        _p_gravity_1 = _take(_p_gravity_0, _rows130)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows130)
        _position_error_1 = _take(_position_error_0, _rows130)
        _speed_1 = _take(_speed_0, _rows130)
        _through_1 = _take(_through_0, _rows130)
        _uncertain_1 = _take(_uncertain_0, _rows130)
        _velocity_error_1 = _take(_velocity_error_0, _rows130)
        _vx_1 = _take(_vx_0, _rows130)
        _vy_1 = _take(_vy_0, _rows130)
        _vz_1 = _take(_vz_0, _rows130)
        _when_1 = _take(_when_0, _rows130)
        _x_1 = _take(_x_0, _rows130)
        _y_1 = _take(_y_0, _rows130)
        _z_1 = _take(_z_0, _rows130)
        _room_1 = room(_count131)
        _unsure_1, = passing_doubt(_when_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_ring_radius_1, _p_gravity_1, _room_1)
        _uncertain_1, = undecided(_uncertain_1, _unsure_1)
        _through_1, = passing(_through_1, _when_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ring_radius_1, _p_gravity_1, _room_1)
        _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1 = flight(_when_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_gravity_1, _room_1)
        _clock_1, = ticked(_clock_1, _when_1)
        _clock_0 = _put(_clock_0, _rows130, _clock_1, shots)
        _through_0 = _put(_through_0, _rows130, _through_1, shots)
        _uncertain_0 = _put(_uncertain_0, _rows130, _uncertain_1, shots)
        _vx_0 = _put(_vx_0, _rows130, _vx_1, shots)
        _vy_0 = _put(_vy_0, _rows130, _vy_1, shots)
        _vz_0 = _put(_vz_0, _rows130, _vz_1, shots)
        _x_0 = _put(_x_0, _rows130, _x_1, shots)
        _y_0 = _put(_y_0, _rows130, _y_1, shots)
        _z_0 = _put(_z_0, _rows130, _z_1, shots)
    _rows132, _count133 = _rows(_limited_0, shots)
    if _count133:
        _body_1 = _take(_body_0, _rows132)
        _clock_1 = _take(_clock_0, _rows132)
        _ends_1 = _take(_ends_0, _rows132)
        _reached_1 = _take(_reached_0, _rows132)
        _time_limit_1 = _take(_time_limit_0, _rows132)
        _which_1 = _take(_which_0, _rows132)
        _clock_1, _body_1, _reached_1, _ends_1 = expired(_body_1, _clock_1, _ends_1, 4.0, _reached_1, _time_limit_1, _which_1)
        _body_0 = _put(_body_0, _rows132, _body_1, shots)
        _clock_0 = _put(_clock_0, _rows132, _clock_1, shots)
        _ends_0 = _put(_ends_0, _rows132, _ends_1, shots)
        _reached_0 = _put(_reached_0, _rows132, _reached_1, shots)
    _hopped_0, = unhopped()
    _rows134, _count135 = _rows(_kept_0, shots)
    if _count135:
        _began_1 = _take(_began_0, _rows134)
        _body_1 = _take(_body_0, _rows134)
        _clock_1 = _take(_clock_0, _rows134)
        _doubt_1 = _take(_doubt_0, _rows134)
        _ends_1 = _take(_ends_0, _rows134)
        _held_1 = _take(_held_0, _rows134)
        _last_1 = _take(_last_0, _rows134)
        _reached_1 = _take(_reached_0, _rows134)
        _rests_1 = _take(_rests_0, _rows134)
        _rolling_1 = _take(_rolling_0, _rows134)
        _rolls_1 = _take(_rolls_0, _rows134)
        _which_1 = _take(_which_0, _rows134)
        _room_1 = room(_count135)
        _body_1, _reached_1, _doubt_1, _ends_1, _hopped_1, _last_1, _mode_1, _held_1, _rolls_1 = kept_on(_began_1, _body_1, _clock_1, _doubt_1, _ends_1, _held_1, _last_1, _reached_1, _rests_1, _rolling_1, _rolls_1, _which_1, _room_1)
        _body_0 = _put(_body_0, _rows134, _body_1, shots)
        _doubt_0 = _put(_doubt_0, _rows134, _doubt_1, shots)
        _ends_0 = _put(_ends_0, _rows134, _ends_1, shots)
        _held_0 = _put(_held_0, _rows134, _held_1, shots)
        _hopped_0 = _put(_hopped_0, _rows134, _hopped_1, shots)
        _last_0 = _put(_last_0, _rows134, _last_1, shots)
        _mode_0 = _put(_mode_0, _rows134, _mode_1, shots)
        _reached_0 = _put(_reached_0, _rows134, _reached_1, shots)
        _rolls_0 = _put(_rolls_0, _rows134, _rolls_1, shots)
    _slack_0, = displacement(_late_0, _when_0, _extent_0, _speed_0, _position_error_0, _velocity_error_0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_board_thickness_0, _p_bridge_half_width_0, _p_bridge_depth_0, _p_gravity_0, _p_end_depth_0, _room_0)
    _here_0, = here(3.0, _which_0)
    _g0_1, = end_bounds(_x_0, _y_0, _p_ring_radius_0)
    _reached_1, = end_reached(_g0_1, _through_0)
    _edge_1, = end_edge(_g0_1, _slack_0, _through_0)
    _edge_0 = _choose(_here_0, _edge_1, _edge_0)
    _reached_0 = _choose(_here_0, _reached_1, _reached_0)
    _uncertain_0, = doubted_in_contact(_assured_0, _doubt_0, _edge_0, _last_0, _late_0, _uncertain_0, _when_0, _which_0)
    _contacts_0, _outcome_0 = accounted(_contacts_0, _most_contacts_0, _reached_0, _touches_0)
    columns["body"] = _body_0
    columns["circled"] = _circled_0
    columns["clock"] = _clock_0
    columns["contacts"] = _contacts_0
    columns["dvx"] = _dvx_0
    columns["dvy"] = _dvy_0
    columns["dvz"] = _dvz_0
    columns["dwx"] = _dwx_0
    columns["dwy"] = _dwy_0
    columns["dwz"] = _dwz_0
    columns["dx"] = _dx_0
    columns["dy"] = _dy_0
    columns["dz"] = _dz_0
    columns["ends"] = _ends_0
    columns["grip_lost"] = _grip_lost_0
    columns["held"] = _held_0
    columns["hopped"] = _hopped_0
    columns["last"] = _last_0
    columns["late"] = _late_0
    columns["limited"] = _limited_0
    columns["mode"] = _mode_0
    columns["outcome"] = _outcome_0
    columns["position_error"] = _position_error_0
    columns["rolls"] = _rolls_0
    columns["taut"] = _taut_0
    columns["taut_clock"] = _taut_clock_0
    columns["taut_rate"] = _taut_rate_0
    columns["through"] = _through_0
    columns["touches"] = _touches_0
    columns["uncertain"] = _uncertain_0
    columns["velocity_error"] = _velocity_error_0
    columns["vx"] = _vx_0
    columns["vy"] = _vy_0
    columns["vz"] = _vz_0
    columns["when"] = _when_0
    columns["which"] = _which_0
    columns["wx"] = _wx_0
    columns["wy"] = _wy_0
    columns["wz"] = _wz_0
    columns["x"] = _x_0
    columns["y"] = _y_0
    columns["z"] = _z_0


def meet_bounded(columns: dict[str, Any], shots: int, room: Any) -> None:
    """Stage meet of the event loop, with bounds on errors."""
    _assured_0 = columns["assured"]
    _body_0 = columns["body"]
    _claims_0 = columns["claims"]
    _clock_0 = columns["clock"]
    _clock_error_0 = columns["clock_error"]
    _contacts_0 = columns["contacts"]
    _count_0_0 = columns["count_0"]
    _count_1_0 = columns["count_1"]
    _count_2_0 = columns["count_2"]
    _dvx_0 = columns["dvx"]
    _dvy_0 = columns["dvy"]
    _dvz_0 = columns["dvz"]
    _dwx_0 = columns["dwx"]
    _dwy_0 = columns["dwy"]
    _dwz_0 = columns["dwz"]
    _dx_0 = columns["dx"]
    _dy_0 = columns["dy"]
    _dz_0 = columns["dz"]
    _ends_0 = columns["ends"]
    _first_0 = columns["first"]
    _held_0 = columns["held"]
    _hopped_0 = columns["hopped"]
    _last_0 = columns["last"]
    _late_0 = columns["late"]
    _limited_0 = columns["limited"]
    _mode_0 = columns["mode"]
    _outcome_0 = columns["outcome"]
    _p_backboard_friction_0 = columns["p_backboard_friction"]
    _p_backboard_restitution_0 = columns["p_backboard_restitution"]
    _p_ball_radius_0 = columns["p_ball_radius"]
    _p_board_bottom_0 = columns["p_board_bottom"]
    _p_board_distance_0 = columns["p_board_distance"]
    _p_board_half_width_0 = columns["p_board_half_width"]
    _p_board_thickness_0 = columns["p_board_thickness"]
    _p_board_top_0 = columns["p_board_top"]
    _p_bridge_depth_0 = columns["p_bridge_depth"]
    _p_bridge_friction_0 = columns["p_bridge_friction"]
    _p_bridge_half_width_0 = columns["p_bridge_half_width"]
    _p_bridge_restitution_0 = columns["p_bridge_restitution"]
    _p_end_depth_0 = columns["p_end_depth"]
    _p_gravity_0 = columns["p_gravity"]
    _p_restitution_speed_0 = columns["p_restitution_speed"]
    _p_ring_friction_0 = columns["p_ring_friction"]
    _p_ring_radius_0 = columns["p_ring_radius"]
    _p_ring_restitution_0 = columns["p_ring_restitution"]
    _p_tangential_restitution_0 = columns["p_tangential_restitution"]
    _p_wire_radius_0 = columns["p_wire_radius"]
    _position_claim_0 = columns["position_claim"]
    _position_error_0 = columns["position_error"]
    _slip_left_0 = columns["slip_left"]
    _spin_claim_0 = columns["spin_claim"]
    _time_claim_0 = columns["time_claim"]
    _touches_0 = columns["touches"]
    _uncertain_0 = columns["uncertain"]
    _velocity_claim_0 = columns["velocity_claim"]
    _velocity_error_0 = columns["velocity_error"]
    _vx_0 = columns["vx"]
    _vy_0 = columns["vy"]
    _vz_0 = columns["vz"]
    _when_0 = columns["when"]
    _which_0 = columns["which"]
    _wx_0 = columns["wx"]
    _wy_0 = columns["wy"]
    _wz_0 = columns["wz"]
    _x_0 = columns["x"]
    _y_0 = columns["y"]
    _z_0 = columns["z"]
    _room_0 = room(shots)
    _meeting_0, = meeting(_claims_0, _ends_0, _touches_0)
    _slow_0, = unslowed()
    _rows1, _count2 = _rows(_meeting_0, shots)
    if _count2:
        _assured_1 = _take(_assured_0, _rows1)
        _body_1 = _take(_body_0, _rows1)
        _clock_1 = _take(_clock_0, _rows1)
        _clock_error_1 = _take(_clock_error_0, _rows1)
        _contacts_1 = _take(_contacts_0, _rows1)
        _count_0_1 = _take(_count_0_0, _rows1)
        _count_1_1 = _take(_count_1_0, _rows1)
        _count_2_1 = _take(_count_2_0, _rows1)
        _dvx_1 = _take(_dvx_0, _rows1)
        _dvy_1 = _take(_dvy_0, _rows1)
        _dvz_1 = _take(_dvz_0, _rows1)
        _dwx_1 = _take(_dwx_0, _rows1)
        _dwy_1 = _take(_dwy_0, _rows1)
        _dwz_1 = _take(_dwz_0, _rows1)
        _dx_1 = _take(_dx_0, _rows1)
        _dy_1 = _take(_dy_0, _rows1)
        _dz_1 = _take(_dz_0, _rows1)
        _ends_1 = _take(_ends_0, _rows1)
        _first_1 = _take(_first_0, _rows1)
        _last_1 = _take(_last_0, _rows1)
        _late_1 = _take(_late_0, _rows1)
        _p_backboard_friction_1 = _take(_p_backboard_friction_0, _rows1)
        _p_backboard_restitution_1 = _take(_p_backboard_restitution_0, _rows1)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows1)
        _p_board_bottom_1 = _take(_p_board_bottom_0, _rows1)
        _p_board_distance_1 = _take(_p_board_distance_0, _rows1)
        _p_board_half_width_1 = _take(_p_board_half_width_0, _rows1)
        _p_board_thickness_1 = _take(_p_board_thickness_0, _rows1)
        _p_board_top_1 = _take(_p_board_top_0, _rows1)
        _p_bridge_depth_1 = _take(_p_bridge_depth_0, _rows1)
        _p_bridge_friction_1 = _take(_p_bridge_friction_0, _rows1)
        _p_bridge_half_width_1 = _take(_p_bridge_half_width_0, _rows1)
        _p_bridge_restitution_1 = _take(_p_bridge_restitution_0, _rows1)
        _p_gravity_1 = _take(_p_gravity_0, _rows1)
        _p_restitution_speed_1 = _take(_p_restitution_speed_0, _rows1)
        _p_ring_friction_1 = _take(_p_ring_friction_0, _rows1)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows1)
        _p_ring_restitution_1 = _take(_p_ring_restitution_0, _rows1)
        _p_tangential_restitution_1 = _take(_p_tangential_restitution_0, _rows1)
        _p_wire_radius_1 = _take(_p_wire_radius_0, _rows1)
        _position_error_1 = _take(_position_error_0, _rows1)
        _slow_1 = _take(_slow_0, _rows1)
        _touches_1 = _take(_touches_0, _rows1)
        _uncertain_1 = _take(_uncertain_0, _rows1)
        _vx_1 = _take(_vx_0, _rows1)
        _vy_1 = _take(_vy_0, _rows1)
        _vz_1 = _take(_vz_0, _rows1)
        _when_1 = _take(_when_0, _rows1)
        _which_1 = _take(_which_0, _rows1)
        _wx_1 = _take(_wx_0, _rows1)
        _wy_1 = _take(_wy_0, _rows1)
        _wz_1 = _take(_wz_0, _rows1)
        _x_1 = _take(_x_0, _rows1)
        _y_1 = _take(_y_0, _rows1)
        _z_1 = _take(_z_0, _rows1)
        _room_1 = room(_count2)
        _nx_1, _ny_1, _nz_1 = end_normal()
        _here_1, = here(0.0, _which_1)
        _nx_2, _ny_2, _nz_2 = ring_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _room_1)
        _count_0_2, = counted(_count_0_1)
        _count_0_1 = _choose(_here_1, _count_0_2, _count_0_1)
        _nx_1 = _choose(_here_1, _nx_2, _nx_1)
        _ny_1 = _choose(_here_1, _ny_2, _ny_1)
        _nz_1 = _choose(_here_1, _nz_2, _nz_1)
        _here_1, = here(1.0, _which_1)
        _nx_2, _ny_2, _nz_2 = backboard_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _room_1)
        _count_1_2, = counted(_count_1_1)
        _count_1_1 = _choose(_here_1, _count_1_2, _count_1_1)
        _nx_1 = _choose(_here_1, _nx_2, _nx_1)
        _ny_1 = _choose(_here_1, _ny_2, _ny_1)
        _nz_1 = _choose(_here_1, _nz_2, _nz_1)
        _here_1, = here(2.0, _which_1)
        _nx_2, _ny_2, _nz_2 = bridge_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _room_1)
        _count_2_2, = counted(_count_2_1)
        _count_2_1 = _choose(_here_1, _count_2_2, _count_2_1)
        _nx_1 = _choose(_here_1, _nx_2, _nx_1)
        _ny_1 = _choose(_here_1, _ny_2, _ny_1)
        _nz_1 = _choose(_here_1, _nz_2, _nz_1)
        _curving_1, = elsewhere()
        _left_nx_1, _left_ny_1, _left_nz_1 = anew()
        _again_1, = again(0.0, _last_1, _which_1)
        _rows3, _count4 = _rows(_again_1, _count2)
        if _count4:
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows3)
            _p_gravity_2 = _take(_p_gravity_1, _rows3)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows3)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows3)
            _vx_2 = _take(_vx_1, _rows3)
            _vy_2 = _take(_vy_1, _rows3)
            _vz_2 = _take(_vz_1, _rows3)
            _when_2 = _take(_when_1, _rows3)
            _x_2 = _take(_x_1, _rows3)
            _y_2 = _take(_y_1, _rows3)
            _z_2 = _take(_z_1, _rows3)
            _room_2 = room(_count4)
            _curving_2, = ring_curvature(_p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2)
            _from_x_2, _from_y_2, _from_z_2 = started(_p_gravity_2, _when_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2)
            _left_nx_2, _left_ny_2, _left_nz_2 = ring_normal(_from_x_2, _from_y_2, _from_z_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _room_2)
            _curving_1 = _put(_curving_1, _rows3, _curving_2, _count2)
            _left_nx_1 = _put(_left_nx_1, _rows3, _left_nx_2, _count2)
            _left_ny_1 = _put(_left_ny_1, _rows3, _left_ny_2, _count2)
            _left_nz_1 = _put(_left_nz_1, _rows3, _left_nz_2, _count2)
        _again_1, = again(1.0, _last_1, _which_1)
        _rows5, _count6 = _rows(_again_1, _count2)
        if _count6:
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows5)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows5)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows5)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows5)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows5)
            _p_board_top_2 = _take(_p_board_top_1, _rows5)
            _p_gravity_2 = _take(_p_gravity_1, _rows5)
            _vx_2 = _take(_vx_1, _rows5)
            _vy_2 = _take(_vy_1, _rows5)
            _vz_2 = _take(_vz_1, _rows5)
            _when_2 = _take(_when_1, _rows5)
            _x_2 = _take(_x_1, _rows5)
            _y_2 = _take(_y_1, _rows5)
            _z_2 = _take(_z_1, _rows5)
            _room_2 = room(_count6)
            _curving_2, = backboard_curvature(_p_ball_radius_2)
            _from_x_2, _from_y_2, _from_z_2 = started(_p_gravity_2, _when_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2)
            _left_nx_2, _left_ny_2, _left_nz_2 = backboard_normal(_from_x_2, _from_y_2, _from_z_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _room_2)
            _curving_1 = _put(_curving_1, _rows5, _curving_2, _count2)
            _left_nx_1 = _put(_left_nx_1, _rows5, _left_nx_2, _count2)
            _left_ny_1 = _put(_left_ny_1, _rows5, _left_ny_2, _count2)
            _left_nz_1 = _put(_left_nz_1, _rows5, _left_nz_2, _count2)
        _again_1, = again(2.0, _last_1, _which_1)
        _rows7, _count8 = _rows(_again_1, _count2)
        if _count8:
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows7)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows7)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows7)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows7)
            _p_gravity_2 = _take(_p_gravity_1, _rows7)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows7)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows7)
            _vx_2 = _take(_vx_1, _rows7)
            _vy_2 = _take(_vy_1, _rows7)
            _vz_2 = _take(_vz_1, _rows7)
            _when_2 = _take(_when_1, _rows7)
            _x_2 = _take(_x_1, _rows7)
            _y_2 = _take(_y_1, _rows7)
            _z_2 = _take(_z_1, _rows7)
            _room_2 = room(_count8)
            _curving_2, = bridge_curvature(_p_ball_radius_2)
            _from_x_2, _from_y_2, _from_z_2 = started(_p_gravity_2, _when_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2)
            _left_nx_2, _left_ny_2, _left_nz_2 = bridge_normal(_from_x_2, _from_y_2, _from_z_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _room_2)
            _curving_1 = _put(_curving_1, _rows7, _curving_2, _count2)
            _left_nx_1 = _put(_left_nx_1, _rows7, _left_nx_2, _count2)
            _left_ny_1 = _put(_left_ny_1, _rows7, _left_ny_2, _count2)
            _left_nz_1 = _put(_left_nz_1, _rows7, _left_nz_2, _count2)
        _dx_1, _dy_1, _dz_1, _lifting_1, _dvx_1, _dvy_1, _dvz_1, _delay_1, _shift_1 = carry_flight(_when_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _nx_1, _ny_1, _nz_1, _clock_1, _contacts_1, _late_1, _dx_1, _dy_1, _dz_1, _dvx_1, _dvy_1, _dvz_1, _left_nx_1, _left_ny_1, _left_nz_1, _curving_1, _p_gravity_1, _room_1)
        _clock_error_1, = delayed(_clock_error_1, _delay_1)
        _dx_2, _dy_2, _dz_2 = floored(_dx_1, _dy_1, _dz_1, _shift_1)
        _dx_1 = _choose(_ends_1, _dx_2, _dx_1)
        _dy_1 = _choose(_ends_1, _dy_2, _dy_1)
        _dz_1 = _choose(_ends_1, _dz_2, _dz_1)
        _dnx_1, _dny_1, _dnz_1, _turn_1 = unturned()
        _here_1, = here(0.0, _which_1)
        _rows9, _count10 = _rows(_here_1, _count2)
        if _count10:
            _dx_2 = _take(_dx_1, _rows9)
            _dy_2 = _take(_dy_1, _rows9)
            _dz_2 = _take(_dz_1, _rows9)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows9)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows9)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows9)
            _shift_2 = _take(_shift_1, _rows9)
            _x_2 = _take(_x_1, _rows9)
            _y_2 = _take(_y_1, _rows9)
            _room_2 = room(_count10)
            _dnx_2, _dny_2, _dnz_2, _turn_2 = ring_carry_normal(_x_2, _y_2, _dx_2, _dy_2, _dz_2, _shift_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _room_2)
            _dnx_1 = _put(_dnx_1, _rows9, _dnx_2, _count2)
            _dny_1 = _put(_dny_1, _rows9, _dny_2, _count2)
            _dnz_1 = _put(_dnz_1, _rows9, _dnz_2, _count2)
            _turn_1 = _put(_turn_1, _rows9, _turn_2, _count2)
        _here_1, = here(1.0, _which_1)
        _dnx_2, _dny_2, _dnz_2, _turn_2 = backboard_carry_normal(_x_1, _y_1, _z_1, _dx_1, _dy_1, _dz_1, _shift_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _room_1)
        _dnx_1 = _choose(_here_1, _dnx_2, _dnx_1)
        _dny_1 = _choose(_here_1, _dny_2, _dny_1)
        _dnz_1 = _choose(_here_1, _dnz_2, _dnz_1)
        _turn_1 = _choose(_here_1, _turn_2, _turn_1)
        _here_1, = here(2.0, _which_1)
        _dnx_2, _dny_2, _dnz_2, _turn_2 = bridge_carry_normal(_x_1, _y_1, _z_1, _dx_1, _dy_1, _dz_1, _shift_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _room_1)
        _dnx_1 = _choose(_here_1, _dnx_2, _dnx_1)
        _dny_1 = _choose(_here_1, _dny_2, _dny_1)
        _dnz_1 = _choose(_here_1, _dnz_2, _dnz_1)
        _turn_1 = _choose(_here_1, _turn_2, _turn_1)
        _struck_0_1, = untaken()
        _, _its_0_ring_impact_1, _its_1_ring_impact_1 = ring_impact_taken(_p_ring_restitution_1, _p_ring_friction_1)
        for _own_index_1, _own_1_1, _own_2_1, in (
            (0.0, _p_ring_friction_1, _p_ring_restitution_1,),
            (1.0, _p_backboard_friction_1, _p_backboard_restitution_1,),
            (2.0, _p_bridge_friction_1, _p_bridge_restitution_1,),
        ):
            _here_1, = here(_own_index_1, _which_1)
            _rows11, _count12 = _rows(_here_1, _count2)
            if _count12:
                _own_1_2 = _take(_own_1_1, _rows11)
                _own_2_2 = _take(_own_2_1, _rows11)
                _struck_0_2, _its_0_ring_impact_2, _its_1_ring_impact_2 = ring_impact_taken(_own_2_2, _own_1_2)
                _its_0_ring_impact_1 = _put(_its_0_ring_impact_1, _rows11, _its_0_ring_impact_2, _count2)
                _its_1_ring_impact_1 = _put(_its_1_ring_impact_1, _rows11, _its_1_ring_impact_2, _count2)
                _struck_0_1 = _put(_struck_0_1, _rows11, _struck_0_2, _count2)
        _rows13, _count14 = _rows(_struck_0_1, _count2)
        if _count14:
            _dnx_2 = _take(_dnx_1, _rows13)
            _dny_2 = _take(_dny_1, _rows13)
            _dnz_2 = _take(_dnz_1, _rows13)
            _dvx_2 = _take(_dvx_1, _rows13)
            _dvy_2 = _take(_dvy_1, _rows13)
            _dvz_2 = _take(_dvz_1, _rows13)
            _dwx_2 = _take(_dwx_1, _rows13)
            _dwy_2 = _take(_dwy_1, _rows13)
            _dwz_2 = _take(_dwz_1, _rows13)
            _its_0_ring_impact_2 = _take(_its_0_ring_impact_1, _rows13)
            _its_1_ring_impact_2 = _take(_its_1_ring_impact_1, _rows13)
            _lifting_2 = _take(_lifting_1, _rows13)
            _nx_2 = _take(_nx_1, _rows13)
            _ny_2 = _take(_ny_1, _rows13)
            _nz_2 = _take(_nz_1, _rows13)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows13)
            _p_restitution_speed_2 = _take(_p_restitution_speed_1, _rows13)
            _p_tangential_restitution_2 = _take(_p_tangential_restitution_1, _rows13)
            _turn_2 = _take(_turn_1, _rows13)
            _uncertain_2 = _take(_uncertain_1, _rows13)
            _vx_2 = _take(_vx_1, _rows13)
            _vy_2 = _take(_vy_1, _rows13)
            _vz_2 = _take(_vz_1, _rows13)
            _wx_2 = _take(_wx_1, _rows13)
            _wy_2 = _take(_wy_1, _rows13)
            _wz_2 = _take(_wz_1, _rows13)
            _room_2 = room(_count14)
            _unsure_2, = ring_impact_doubt(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _turn_2, _p_ball_radius_2, _its_0_ring_impact_2, _its_1_ring_impact_2, _p_tangential_restitution_2, _p_restitution_speed_2, _room_2)
            _uncertain_2, = undecided(_uncertain_2, _unsure_2)
            _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2 = carry_ring_impact(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _dnx_2, _dny_2, _dnz_2, _turn_2, _lifting_2, _p_ball_radius_2, _its_0_ring_impact_2, _its_1_ring_impact_2, _p_tangential_restitution_2, _p_restitution_speed_2, _room_2)
            _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = ring_impact(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _p_ball_radius_2, _its_0_ring_impact_2, _its_1_ring_impact_2, _p_tangential_restitution_2, _p_restitution_speed_2, _room_2)
            _dvx_1 = _put(_dvx_1, _rows13, _dvx_2, _count2)
            _dvy_1 = _put(_dvy_1, _rows13, _dvy_2, _count2)
            _dvz_1 = _put(_dvz_1, _rows13, _dvz_2, _count2)
            _dwx_1 = _put(_dwx_1, _rows13, _dwx_2, _count2)
            _dwy_1 = _put(_dwy_1, _rows13, _dwy_2, _count2)
            _dwz_1 = _put(_dwz_1, _rows13, _dwz_2, _count2)
            _uncertain_1 = _put(_uncertain_1, _rows13, _uncertain_2, _count2)
            _vx_1 = _put(_vx_1, _rows13, _vx_2, _count2)
            _vy_1 = _put(_vy_1, _rows13, _vy_2, _count2)
            _vz_1 = _put(_vz_1, _rows13, _vz_2, _count2)
            _wx_1 = _put(_wx_1, _rows13, _wx_2, _count2)
            _wy_1 = _put(_wy_1, _rows13, _wy_2, _count2)
            _wz_1 = _put(_wz_1, _rows13, _wz_2, _count2)
        _first_2, _last_2 = touched(_body_1, _first_1, _which_1)
        _slow_2, _assured_2 = slowed(_p_ball_radius_1, _p_gravity_1, _nx_1, _ny_1, _nz_1, _position_error_1, _vx_1, _vy_1, _vz_1, _room_1)
        _assured_1 = _choose(_touches_1, _assured_2, _assured_1)
        _first_1 = _choose(_touches_1, _first_2, _first_1)
        _last_1 = _choose(_touches_1, _last_2, _last_1)
        _slow_1 = _choose(_touches_1, _slow_2, _slow_1)
        _assured_0 = _put(_assured_0, _rows1, _assured_1, shots)
        _clock_error_0 = _put(_clock_error_0, _rows1, _clock_error_1, shots)
        _count_0_0 = _put(_count_0_0, _rows1, _count_0_1, shots)
        _count_1_0 = _put(_count_1_0, _rows1, _count_1_1, shots)
        _count_2_0 = _put(_count_2_0, _rows1, _count_2_1, shots)
        _dvx_0 = _put(_dvx_0, _rows1, _dvx_1, shots)
        _dvy_0 = _put(_dvy_0, _rows1, _dvy_1, shots)
        _dvz_0 = _put(_dvz_0, _rows1, _dvz_1, shots)
        _dwx_0 = _put(_dwx_0, _rows1, _dwx_1, shots)
        _dwy_0 = _put(_dwy_0, _rows1, _dwy_1, shots)
        _dwz_0 = _put(_dwz_0, _rows1, _dwz_1, shots)
        _dx_0 = _put(_dx_0, _rows1, _dx_1, shots)
        _dy_0 = _put(_dy_0, _rows1, _dy_1, shots)
        _dz_0 = _put(_dz_0, _rows1, _dz_1, shots)
        _first_0 = _put(_first_0, _rows1, _first_1, shots)
        _last_0 = _put(_last_0, _rows1, _last_1, shots)
        _slow_0 = _put(_slow_0, _rows1, _slow_1, shots)
        _uncertain_0 = _put(_uncertain_0, _rows1, _uncertain_1, shots)
        _vx_0 = _put(_vx_0, _rows1, _vx_1, shots)
        _vy_0 = _put(_vy_0, _rows1, _vy_1, shots)
        _vz_0 = _put(_vz_0, _rows1, _vz_1, shots)
        _wx_0 = _put(_wx_0, _rows1, _wx_1, shots)
        _wy_0 = _put(_wy_0, _rows1, _wy_1, shots)
        _wz_0 = _put(_wz_0, _rows1, _wz_1, shots)
    _rows15, _count16 = _rows(_slow_0, shots)
    if _count16:
        _assured_1 = _take(_assured_0, _rows15)
        _held_1 = _take(_held_0, _rows15)
        _mode_1 = _take(_mode_0, _rows15)
        _outcome_1 = _take(_outcome_0, _rows15)
        _p_backboard_friction_1 = _take(_p_backboard_friction_0, _rows15)
        _p_backboard_restitution_1 = _take(_p_backboard_restitution_0, _rows15)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows15)
        _p_board_bottom_1 = _take(_p_board_bottom_0, _rows15)
        _p_board_distance_1 = _take(_p_board_distance_0, _rows15)
        _p_board_half_width_1 = _take(_p_board_half_width_0, _rows15)
        _p_board_thickness_1 = _take(_p_board_thickness_0, _rows15)
        _p_board_top_1 = _take(_p_board_top_0, _rows15)
        _p_bridge_depth_1 = _take(_p_bridge_depth_0, _rows15)
        _p_bridge_friction_1 = _take(_p_bridge_friction_0, _rows15)
        _p_bridge_half_width_1 = _take(_p_bridge_half_width_0, _rows15)
        _p_bridge_restitution_1 = _take(_p_bridge_restitution_0, _rows15)
        _p_end_depth_1 = _take(_p_end_depth_0, _rows15)
        _p_gravity_1 = _take(_p_gravity_0, _rows15)
        _p_ring_friction_1 = _take(_p_ring_friction_0, _rows15)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows15)
        _p_ring_restitution_1 = _take(_p_ring_restitution_0, _rows15)
        _p_wire_radius_1 = _take(_p_wire_radius_0, _rows15)
        _slip_left_1 = _take(_slip_left_0, _rows15)
        _uncertain_1 = _take(_uncertain_0, _rows15)
        _velocity_error_1 = _take(_velocity_error_0, _rows15)
        _vx_1 = _take(_vx_0, _rows15)
        _vy_1 = _take(_vy_0, _rows15)
        _vz_1 = _take(_vz_0, _rows15)
        _which_1 = _take(_which_0, _rows15)
        _wx_1 = _take(_wx_0, _rows15)
        _wy_1 = _take(_wy_0, _rows15)
        _wz_1 = _take(_wz_0, _rows15)
        _x_1 = _take(_x_0, _rows15)
        _y_1 = _take(_y_0, _rows15)
        _z_1 = _take(_z_0, _rows15)
        _room_1 = room(_count16)
        _nx_1, _ny_1, _nz_1 = ring_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _room_1)
        _here_1, = here(1.0, _which_1)
        _nx_2, _ny_2, _nz_2 = backboard_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _room_1)
        _nx_1 = _choose(_here_1, _nx_2, _nx_1)
        _ny_1 = _choose(_here_1, _ny_2, _ny_1)
        _nz_1 = _choose(_here_1, _nz_2, _nz_1)
        _here_1, = here(2.0, _which_1)
        _nx_2, _ny_2, _nz_2 = bridge_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _room_1)
        _nx_1 = _choose(_here_1, _nx_2, _nx_1)
        _ny_1 = _choose(_here_1, _ny_2, _ny_1)
        _nz_1 = _choose(_here_1, _nz_2, _nz_1)
        _nearly_1, = nearly(_p_ball_radius_1, _p_gravity_1, _nx_1, _ny_1, _nz_1, _vx_1, _vy_1, _vz_1, _room_1)
        _rolled_x_1, _rolled_y_1, _rolled_z_1, _slip_1, _bounce_1 = gripped(_p_ball_radius_1, _nx_1, _ny_1, _nz_1, _vx_1, _vy_1, _vz_1, _wx_1, _wy_1, _wz_1, _room_1)
        _here_1, = here(0.0, _which_1)
        _rows17, _count18 = _rows(_here_1, _count16)
        if _count18:
            _bounce_2 = _take(_bounce_1, _rows17)
            _nearly_2 = _take(_nearly_1, _rows17)
            _nx_2 = _take(_nx_1, _rows17)
            _ny_2 = _take(_ny_1, _rows17)
            _nz_2 = _take(_nz_1, _rows17)
            _outcome_2 = _take(_outcome_1, _rows17)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows17)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows17)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows17)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows17)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows17)
            _p_board_top_2 = _take(_p_board_top_1, _rows17)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows17)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows17)
            _p_end_depth_2 = _take(_p_end_depth_1, _rows17)
            _p_gravity_2 = _take(_p_gravity_1, _rows17)
            _p_ring_friction_2 = _take(_p_ring_friction_1, _rows17)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows17)
            _p_ring_restitution_2 = _take(_p_ring_restitution_1, _rows17)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows17)
            _rolled_x_2 = _take(_rolled_x_1, _rows17)
            _rolled_y_2 = _take(_rolled_y_1, _rows17)
            _rolled_z_2 = _take(_rolled_z_1, _rows17)
            _slip_2 = _take(_slip_1, _rows17)
            _uncertain_2 = _take(_uncertain_1, _rows17)
            _velocity_error_2 = _take(_velocity_error_1, _rows17)
            _vx_2 = _take(_vx_1, _rows17)
            _vy_2 = _take(_vy_1, _rows17)
            _vz_2 = _take(_vz_1, _rows17)
            _wx_2 = _take(_wx_1, _rows17)
            _wy_2 = _take(_wy_1, _rows17)
            _wz_2 = _take(_wz_1, _rows17)
            _x_2 = _take(_x_1, _rows17)
            _y_2 = _take(_y_1, _rows17)
            _z_2 = _take(_z_1, _rows17)
            _room_2 = room(_count18)
            _turning_x_2, _turning_y_2, _turning_z_2 = ring_turning(_p_ball_radius_2, _p_ring_radius_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _p_wire_radius_2, _x_2, _y_2, _room_2)
            _press_2, _weight_2, _drag_2, _thrust_x_2, _thrust_y_2, _thrust_z_2 = pressed_on(_p_ball_radius_2, _p_gravity_2, _nx_2, _ny_2, _nz_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _turning_x_2, _turning_y_2, _turning_z_2, _wx_2, _wy_2, _wz_2, _room_2)
            _nearest_2, _wedge_2 = alone()
            _gap_2, _nearing_2, _swerve_2, _facing_2 = backboard_closing(_p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _nx_2, _ny_2, _nz_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _thrust_x_2, _thrust_y_2, _thrust_z_2, _x_2, _y_2, _z_2, _room_2)
            _nearest_2, _wedge_2 = neared_body(_facing_2, _gap_2, _nearest_2, _nearing_2, _press_2, _swerve_2, _wedge_2, _room_2)
            _gap_2, _nearing_2, _swerve_2, _facing_2 = bridge_closing(_p_ball_radius_2, _p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _nx_2, _ny_2, _nz_2, _p_ring_radius_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _thrust_x_2, _thrust_y_2, _thrust_z_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _nearest_2, _wedge_2 = neared_body(_facing_2, _gap_2, _nearest_2, _nearing_2, _press_2, _swerve_2, _wedge_2, _room_2)
            _gap_2, *_ = end_beside(_p_end_depth_2, _vz_2, _z_2)
            _nearest_2, = neared(_gap_2, _nearest_2)
            _lift_2, *_ = ring_parting(_p_gravity_2, _p_ring_radius_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2, _room_2)
            _settles_2, _lodges_2, _slides_2, _parts_2, _assured_2, _unsure_2 = ring_impact_settling(_p_ball_radius_2, _bounce_2, _drag_2, _lift_2, _nearest_2, _press_2, _p_ring_friction_2, _p_ring_restitution_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _slip_2, _turning_x_2, _turning_y_2, _turning_z_2, _velocity_error_2, _wedge_2, _weight_2, _wx_2, _wy_2, _wz_2, _room_2)
            _mode_2, _held_2, _outcome_2, _slip_left_2, _uncertain_2 = settled(0.0, _lodges_2, _nearly_2, _outcome_2, _parts_2, _settles_2, _slides_2, _uncertain_2, _unsure_2)
            _assured_1 = _put(_assured_1, _rows17, _assured_2, _count16)
            _held_1 = _put(_held_1, _rows17, _held_2, _count16)
            _mode_1 = _put(_mode_1, _rows17, _mode_2, _count16)
            _outcome_1 = _put(_outcome_1, _rows17, _outcome_2, _count16)
            _slip_left_1 = _put(_slip_left_1, _rows17, _slip_left_2, _count16)
            _uncertain_1 = _put(_uncertain_1, _rows17, _uncertain_2, _count16)
        _here_1, = here(1.0, _which_1)
        _rows19, _count20 = _rows(_here_1, _count16)
        if _count20:
            _bounce_2 = _take(_bounce_1, _rows19)
            _nearly_2 = _take(_nearly_1, _rows19)
            _nx_2 = _take(_nx_1, _rows19)
            _ny_2 = _take(_ny_1, _rows19)
            _nz_2 = _take(_nz_1, _rows19)
            _outcome_2 = _take(_outcome_1, _rows19)
            _p_backboard_friction_2 = _take(_p_backboard_friction_1, _rows19)
            _p_backboard_restitution_2 = _take(_p_backboard_restitution_1, _rows19)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows19)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows19)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows19)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows19)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows19)
            _p_board_top_2 = _take(_p_board_top_1, _rows19)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows19)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows19)
            _p_end_depth_2 = _take(_p_end_depth_1, _rows19)
            _p_gravity_2 = _take(_p_gravity_1, _rows19)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows19)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows19)
            _rolled_x_2 = _take(_rolled_x_1, _rows19)
            _rolled_y_2 = _take(_rolled_y_1, _rows19)
            _rolled_z_2 = _take(_rolled_z_1, _rows19)
            _slip_2 = _take(_slip_1, _rows19)
            _uncertain_2 = _take(_uncertain_1, _rows19)
            _velocity_error_2 = _take(_velocity_error_1, _rows19)
            _vx_2 = _take(_vx_1, _rows19)
            _vy_2 = _take(_vy_1, _rows19)
            _vz_2 = _take(_vz_1, _rows19)
            _wx_2 = _take(_wx_1, _rows19)
            _wy_2 = _take(_wy_1, _rows19)
            _wz_2 = _take(_wz_1, _rows19)
            _x_2 = _take(_x_1, _rows19)
            _y_2 = _take(_y_1, _rows19)
            _z_2 = _take(_z_1, _rows19)
            _room_2 = room(_count20)
            _turning_x_2, _turning_y_2, _turning_z_2 = backboard_turning(_p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _x_2, _y_2, _z_2, _room_2)
            _press_2, _weight_2, _drag_2, _thrust_x_2, _thrust_y_2, _thrust_z_2 = pressed_on(_p_ball_radius_2, _p_gravity_2, _nx_2, _ny_2, _nz_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _turning_x_2, _turning_y_2, _turning_z_2, _wx_2, _wy_2, _wz_2, _room_2)
            _nearest_2, _wedge_2 = alone()
            _gap_2, _nearing_2, _swerve_2, _facing_2 = ring_closing(_p_ball_radius_2, _nx_2, _ny_2, _nz_2, _p_ring_radius_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _thrust_x_2, _thrust_y_2, _thrust_z_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _nearest_2, _wedge_2 = neared_body(_facing_2, _gap_2, _nearest_2, _nearing_2, _press_2, _swerve_2, _wedge_2, _room_2)
            _gap_2, _nearing_2, _swerve_2, _facing_2 = bridge_closing(_p_ball_radius_2, _p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _nx_2, _ny_2, _nz_2, _p_ring_radius_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _thrust_x_2, _thrust_y_2, _thrust_z_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _nearest_2, _wedge_2 = neared_body(_facing_2, _gap_2, _nearest_2, _nearing_2, _press_2, _swerve_2, _wedge_2, _room_2)
            _gap_2, *_ = end_beside(_p_end_depth_2, _vz_2, _z_2)
            _nearest_2, = neared(_gap_2, _nearest_2)
            _lift_2, *_ = backboard_parting(_p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _p_gravity_2, _vx_2, _vy_2, _vz_2, _x_2, _y_2, _z_2, _room_2)
            _settles_2, _lodges_2, _slides_2, _parts_2, _assured_2, _unsure_2 = ring_impact_settling(_p_ball_radius_2, _bounce_2, _drag_2, _lift_2, _nearest_2, _press_2, _p_backboard_friction_2, _p_backboard_restitution_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _slip_2, _turning_x_2, _turning_y_2, _turning_z_2, _velocity_error_2, _wedge_2, _weight_2, _wx_2, _wy_2, _wz_2, _room_2)
            _mode_2, _held_2, _outcome_2, _slip_left_2, _uncertain_2 = settled(1.0, _lodges_2, _nearly_2, _outcome_2, _parts_2, _settles_2, _slides_2, _uncertain_2, _unsure_2)
            _assured_1 = _put(_assured_1, _rows19, _assured_2, _count16)
            _held_1 = _put(_held_1, _rows19, _held_2, _count16)
            _mode_1 = _put(_mode_1, _rows19, _mode_2, _count16)
            _outcome_1 = _put(_outcome_1, _rows19, _outcome_2, _count16)
            _slip_left_1 = _put(_slip_left_1, _rows19, _slip_left_2, _count16)
            _uncertain_1 = _put(_uncertain_1, _rows19, _uncertain_2, _count16)
        _here_1, = here(2.0, _which_1)
        _rows21, _count22 = _rows(_here_1, _count16)
        if _count22:
            _bounce_2 = _take(_bounce_1, _rows21)
            _nearly_2 = _take(_nearly_1, _rows21)
            _nx_2 = _take(_nx_1, _rows21)
            _ny_2 = _take(_ny_1, _rows21)
            _nz_2 = _take(_nz_1, _rows21)
            _outcome_2 = _take(_outcome_1, _rows21)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows21)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows21)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows21)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows21)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows21)
            _p_board_top_2 = _take(_p_board_top_1, _rows21)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows21)
            _p_bridge_friction_2 = _take(_p_bridge_friction_1, _rows21)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows21)
            _p_bridge_restitution_2 = _take(_p_bridge_restitution_1, _rows21)
            _p_end_depth_2 = _take(_p_end_depth_1, _rows21)
            _p_gravity_2 = _take(_p_gravity_1, _rows21)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows21)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows21)
            _rolled_x_2 = _take(_rolled_x_1, _rows21)
            _rolled_y_2 = _take(_rolled_y_1, _rows21)
            _rolled_z_2 = _take(_rolled_z_1, _rows21)
            _slip_2 = _take(_slip_1, _rows21)
            _uncertain_2 = _take(_uncertain_1, _rows21)
            _velocity_error_2 = _take(_velocity_error_1, _rows21)
            _vx_2 = _take(_vx_1, _rows21)
            _vy_2 = _take(_vy_1, _rows21)
            _vz_2 = _take(_vz_1, _rows21)
            _wx_2 = _take(_wx_1, _rows21)
            _wy_2 = _take(_wy_1, _rows21)
            _wz_2 = _take(_wz_1, _rows21)
            _x_2 = _take(_x_1, _rows21)
            _y_2 = _take(_y_1, _rows21)
            _z_2 = _take(_z_1, _rows21)
            _room_2 = room(_count22)
            _turning_x_2, _turning_y_2, _turning_z_2 = bridge_turning(_p_ball_radius_2, _p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _p_ring_radius_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _press_2, _weight_2, _drag_2, _thrust_x_2, _thrust_y_2, _thrust_z_2 = pressed_on(_p_ball_radius_2, _p_gravity_2, _nx_2, _ny_2, _nz_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _turning_x_2, _turning_y_2, _turning_z_2, _wx_2, _wy_2, _wz_2, _room_2)
            _nearest_2, _wedge_2 = alone()
            _gap_2, _nearing_2, _swerve_2, _facing_2 = ring_closing(_p_ball_radius_2, _nx_2, _ny_2, _nz_2, _p_ring_radius_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _thrust_x_2, _thrust_y_2, _thrust_z_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _nearest_2, _wedge_2 = neared_body(_facing_2, _gap_2, _nearest_2, _nearing_2, _press_2, _swerve_2, _wedge_2, _room_2)
            _gap_2, _nearing_2, _swerve_2, _facing_2 = backboard_closing(_p_ball_radius_2, _p_board_bottom_2, _p_board_distance_2, _p_board_half_width_2, _p_board_thickness_2, _p_board_top_2, _nx_2, _ny_2, _nz_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _thrust_x_2, _thrust_y_2, _thrust_z_2, _x_2, _y_2, _z_2, _room_2)
            _nearest_2, _wedge_2 = neared_body(_facing_2, _gap_2, _nearest_2, _nearing_2, _press_2, _swerve_2, _wedge_2, _room_2)
            _gap_2, *_ = end_beside(_p_end_depth_2, _vz_2, _z_2)
            _nearest_2, = neared(_gap_2, _nearest_2)
            _lift_2, *_ = bridge_parting(_p_board_distance_2, _p_bridge_depth_2, _p_bridge_half_width_2, _p_gravity_2, _p_ring_radius_2, _vx_2, _vy_2, _vz_2, _p_wire_radius_2, _x_2, _y_2, _z_2, _room_2)
            _settles_2, _lodges_2, _slides_2, _parts_2, _assured_2, _unsure_2 = ring_impact_settling(_p_ball_radius_2, _bounce_2, _drag_2, _lift_2, _nearest_2, _press_2, _p_bridge_friction_2, _p_bridge_restitution_2, _rolled_x_2, _rolled_y_2, _rolled_z_2, _slip_2, _turning_x_2, _turning_y_2, _turning_z_2, _velocity_error_2, _wedge_2, _weight_2, _wx_2, _wy_2, _wz_2, _room_2)
            _mode_2, _held_2, _outcome_2, _slip_left_2, _uncertain_2 = settled(2.0, _lodges_2, _nearly_2, _outcome_2, _parts_2, _settles_2, _slides_2, _uncertain_2, _unsure_2)
            _assured_1 = _put(_assured_1, _rows21, _assured_2, _count16)
            _held_1 = _put(_held_1, _rows21, _held_2, _count16)
            _mode_1 = _put(_mode_1, _rows21, _mode_2, _count16)
            _outcome_1 = _put(_outcome_1, _rows21, _outcome_2, _count16)
            _slip_left_1 = _put(_slip_left_1, _rows21, _slip_left_2, _count16)
            _uncertain_1 = _put(_uncertain_1, _rows21, _uncertain_2, _count16)
        _assured_0 = _put(_assured_0, _rows15, _assured_1, shots)
        _held_0 = _put(_held_0, _rows15, _held_1, shots)
        _mode_0 = _put(_mode_0, _rows15, _mode_1, shots)
        _outcome_0 = _put(_outcome_0, _rows15, _outcome_1, shots)
        _slip_left_0 = _put(_slip_left_0, _rows15, _slip_left_1, shots)
        _uncertain_0 = _put(_uncertain_0, _rows15, _uncertain_1, shots)
    _rows23, _count24 = _rows(_limited_0, shots)
    if _count24:
        _claims_1 = _take(_claims_0, _rows23)
        _clock_1 = _take(_clock_0, _rows23)
        _clock_error_1 = _take(_clock_error_0, _rows23)
        _dvx_1 = _take(_dvx_0, _rows23)
        _dvy_1 = _take(_dvy_0, _rows23)
        _dvz_1 = _take(_dvz_0, _rows23)
        _dx_1 = _take(_dx_0, _rows23)
        _dy_1 = _take(_dy_0, _rows23)
        _dz_1 = _take(_dz_0, _rows23)
        _p_gravity_1 = _take(_p_gravity_0, _rows23)
        _vx_1 = _take(_vx_0, _rows23)
        _vy_1 = _take(_vy_0, _rows23)
        _vz_1 = _take(_vz_0, _rows23)
        _when_1 = _take(_when_0, _rows23)
        _which_1 = _take(_which_0, _rows23)
        _x_1 = _take(_x_0, _rows23)
        _y_1 = _take(_y_0, _rows23)
        _z_1 = _take(_z_0, _rows23)
        _timed_1, = timed(_claims_1, 4.0, _which_1)
        _rows25, _count26 = _rows(_timed_1, _count24)
        if _count26:
            _clock_2 = _take(_clock_1, _rows25)
            _clock_error_2 = _take(_clock_error_1, _rows25)
            _dvx_2 = _take(_dvx_1, _rows25)
            _dvy_2 = _take(_dvy_1, _rows25)
            _dvz_2 = _take(_dvz_1, _rows25)
            _dx_2 = _take(_dx_1, _rows25)
            _dy_2 = _take(_dy_1, _rows25)
            _dz_2 = _take(_dz_1, _rows25)
            _p_gravity_2 = _take(_p_gravity_1, _rows25)
            _vx_2 = _take(_vx_1, _rows25)
            _vy_2 = _take(_vy_1, _rows25)
            _vz_2 = _take(_vz_1, _rows25)
            _when_2 = _take(_when_1, _rows25)
            _x_2 = _take(_x_1, _rows25)
            _y_2 = _take(_y_1, _rows25)
            _z_2 = _take(_z_1, _rows25)
            _room_2 = room(_count26)
            _dx_2, _dy_2, _dz_2, _dvx_2, _dvy_2, _dvz_2, _clock_error_2 = carry_time(_when_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _clock_2, _clock_error_2, _dx_2, _dy_2, _dz_2, _dvx_2, _dvy_2, _dvz_2, _p_gravity_2, _room_2)
            _clock_error_1 = _put(_clock_error_1, _rows25, _clock_error_2, _count24)
            _dvx_1 = _put(_dvx_1, _rows25, _dvx_2, _count24)
            _dvy_1 = _put(_dvy_1, _rows25, _dvy_2, _count24)
            _dvz_1 = _put(_dvz_1, _rows25, _dvz_2, _count24)
            _dx_1 = _put(_dx_1, _rows25, _dx_2, _count24)
            _dy_1 = _put(_dy_1, _rows25, _dy_2, _count24)
            _dz_1 = _put(_dz_1, _rows25, _dz_2, _count24)
        _clock_error_0 = _put(_clock_error_0, _rows23, _clock_error_1, shots)
        _dvx_0 = _put(_dvx_0, _rows23, _dvx_1, shots)
        _dvy_0 = _put(_dvy_0, _rows23, _dvy_1, shots)
        _dvz_0 = _put(_dvz_0, _rows23, _dvz_1, shots)
        _dx_0 = _put(_dx_0, _rows23, _dx_1, shots)
        _dy_0 = _put(_dy_0, _rows23, _dy_1, shots)
        _dz_0 = _put(_dz_0, _rows23, _dz_1, shots)
    _rows27, _count28 = _rows(_hopped_0, shots)
    if _count28:
        _dvx_1 = _take(_dvx_0, _rows27)
        _dvy_1 = _take(_dvy_0, _rows27)
        _dvz_1 = _take(_dvz_0, _rows27)
        _dx_1 = _take(_dx_0, _rows27)
        _dy_1 = _take(_dy_0, _rows27)
        _dz_1 = _take(_dz_0, _rows27)
        _vx_1 = _take(_vx_0, _rows27)
        _vy_1 = _take(_vy_0, _rows27)
        _vz_1 = _take(_vz_0, _rows27)
        _when_1 = _take(_when_0, _rows27)
        _x_1 = _take(_x_0, _rows27)
        _y_1 = _take(_y_0, _rows27)
        _z_1 = _take(_z_0, _rows27)
        _room_1 = room(_count28)
        _dx_1, _dy_1, _dz_1 = carry_hop(_dvx_1, _dvy_1, _dvz_1, _dx_1, _dy_1, _dz_1, _vx_1, _vy_1, _vz_1, _when_1, _x_1, _y_1, _z_1, _room_1)
        _dx_0 = _put(_dx_0, _rows27, _dx_1, shots)
        _dy_0 = _put(_dy_0, _rows27, _dy_1, shots)
        _dz_0 = _put(_dz_0, _rows27, _dz_1, shots)
    _closed_0, = closing(_claims_0, _outcome_0)
    _position_claim_1, _velocity_claim_1, _spin_claim_1, _time_claim_1 = claimed_errors(_clock_error_0, _dx_0, _dy_0, _dz_0, _dvx_0, _dvy_0, _dvz_0, _dwx_0, _dwy_0, _dwz_0, _room_0)
    _position_claim_0 = _choose(_closed_0, _position_claim_1, _position_claim_0)
    _spin_claim_0 = _choose(_closed_0, _spin_claim_1, _spin_claim_0)
    _time_claim_0 = _choose(_closed_0, _time_claim_1, _time_claim_0)
    _velocity_claim_0 = _choose(_closed_0, _velocity_claim_1, _velocity_claim_0)
    columns["assured"] = _assured_0
    columns["clock_error"] = _clock_error_0
    columns["count_0"] = _count_0_0
    columns["count_1"] = _count_1_0
    columns["count_2"] = _count_2_0
    columns["dvx"] = _dvx_0
    columns["dvy"] = _dvy_0
    columns["dvz"] = _dvz_0
    columns["dwx"] = _dwx_0
    columns["dwy"] = _dwy_0
    columns["dwz"] = _dwz_0
    columns["dx"] = _dx_0
    columns["dy"] = _dy_0
    columns["dz"] = _dz_0
    columns["first"] = _first_0
    columns["held"] = _held_0
    columns["last"] = _last_0
    columns["mode"] = _mode_0
    columns["outcome"] = _outcome_0
    columns["position_claim"] = _position_claim_0
    columns["slip_left"] = _slip_left_0
    columns["spin_claim"] = _spin_claim_0
    columns["time_claim"] = _time_claim_0
    columns["uncertain"] = _uncertain_0
    columns["velocity_claim"] = _velocity_claim_0
    columns["vx"] = _vx_0
    columns["vy"] = _vy_0
    columns["vz"] = _vz_0
    columns["wx"] = _wx_0
    columns["wy"] = _wy_0
    columns["wz"] = _wz_0
