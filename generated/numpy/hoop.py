"""NumPy kernels of the scene hoop.

Generated from templates/numpy/kernels.py.j2, scene hoop, derivation 4e3fee7f36fc1578,
with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
and run `make generate`.
Every function takes scalars or arrays that broadcast and is evaluated element by element; SI units.
"""

# ruff: noqa: E501

from __future__ import annotations

from enum import IntEnum
from typing import Any, NamedTuple

from numpy import (
    absolute,
    arange,
    broadcast_to,
    flatnonzero,
    inf,
    logical_and,
    logical_not,
    logical_or,
    ndim,
    sqrt,
    where,
)

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

BODIES: tuple[str, ...] = ("ring", "backboard", "bridge",)
"""What can be touched, in the order of the results; the end comes after them."""

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
    """Had max_contacts contacts before it."""
    SHORT = 3
    """Can never cross it downwards."""
    INVALID = 4
    """Not finite, a parameter not allowed, or a ball that starts inside a surface."""


class Field(NamedTuple):
    """What a shot takes from event to event: its start, None if given; whether it bounds errors."""

    name: str
    start: float | None
    bounds: bool


class Result(NamedTuple):
    """A result: the fields that it is made of, whether they make a row, whether it is not a number
    where a shot is invalid, whether it bounds errors, whether it is had by name only."""

    name: str
    dtype: str
    columns: tuple[str, ...]
    row: bool
    blank: bool
    bounds: bool
    asked: bool


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
    Result("time_error", "float64", ('time_claim',), False, True, True, True),
    Result("state_error", "float64", ('position_claim', 'velocity_claim', 'spin_claim'), True, True, True, True),
    Result("uncertain", "bool", ('uncertain',), False, False, True, False),
)

OUTPUTS: dict[str, tuple[str, ...]] = {
    "flight": ("x", "y", "z", "vx", "vy", "vz",),
    "contact_frame": ("n11", "n12", "n13", "n21", "n22", "n23", "n31", "n32", "n33",),
    "impact_through_frame": ("vx", "vy", "vz", "wx", "wy", "wz",),
    "crossing": ("clearance", "delay",),
    "allowance": ("level", "velocity_level", "excess",),
    "horizon": ("horizon", "pad",),
    "scale": ("extent", "speed", "excess",),
    "displacement": ("margin",),
    "carry_flight": ("dx", "dy", "dz", "dvx", "dvy", "dvz", "delay", "shift",),
    "error_bounds": ("position_error", "velocity_error", "spin_error", "time_error",),
    "claimed_errors": ("position_error", "velocity_error", "spin_error", "time_error",),
    "allowed": ("allowed",),
    "finite_parameters": ("permitted",),
    "valid": ("valid", "doubt",),
    "target": ("target",),
    "left": ("leaving",),
    "meeting_plane": ("arrives", "ceiling",),
    "timely": ("possible",),
    "grazed": ("doubt",),
    "questioned": ("doubt",),
    "crossed": ("doubt",),
    "tied": ("doubt", "late",),
    "sooner": ("when", "which",),
    "opens": ("open",),
    "beginning": ("share", "arrival", "certain",),
    "beyond": ("doubt",),
    "nearby": ("leaving", "margin",),
    "struck": ("hit", "sure", "vague",),
    "finer": ("share",),
    "exceeded": ("doubt",),
    "advanced": ("arrival", "certain", "exhausted", "searching", "t",),
    "found": ("arrives",),
    "polished": ("arrival",),
    "own_margin": ("margin",),
    "landed": ("time",),
    "landed_surely": ("delay", "doubt",),
    "outside": ("side",),
    "admitted": ("outcome", "uncertain",),
    "finite_state": ("finite",),
    "opening": ("when", "which", "late", "doubt",),
    "departed": ("stays", "moves", "ends", "touches",),
    "ticked": ("clock",),
    "doubted": ("uncertain",),
    "accounted": ("contacts", "outcome",),
    "meeting": ("meeting",),
    "here": ("here",),
    "counted": ("count",),
    "elsewhere": ("curving",),
    "again": ("again",),
    "delayed": ("clock_error",),
    "floored": ("dx", "dy", "dz",),
    "unturned": ("dnx", "dny", "dnz", "turn",),
    "touched": ("first", "last",),
    "closing": ("closed",),
    "body_of": ("body",),
    "impact": ("vx", "vy", "vz", "wx", "wy", "wz",),
    "carry_impact": ("dvx", "dvy", "dvz", "dwx", "dwy", "dwz",),
    "ring_coefficients": ("c0", "c1", "c2", "c3", "c4", "c5", "c6", "c7", "c8",),
    "ring_deflated": ("c0", "c1", "c2", "c3", "c4", "c5", "c6", "c7",),
    "ring_normal": ("nx", "ny", "nz",),
    "ring_curvature": ("curvature",),
    "ring_carry_normal": ("dnx", "dny", "dnz", "turn",),
    "ring_clear": ("clear",),
    "ring_prepare": ("steady", "swing", "rho_start", "low0", "high0", "low1", "high1", "low2", "high2", "ceiling", "latest", "lost",),
    "ring_margins": ("margin", "leaving_margin", "rate_margin",),
    "ring_refine": ("time", "rate",),
    "ring_advance": ("gap", "rate", "bend", "step", "next", "root", "clearance",),
    "ring_enter": ("t", "end", "searching",),
    "backboard_coefficients": ("c0", "c1",),
    "backboard_deflated": ("c0",),
    "backboard_normal": ("nx", "ny", "nz",),
    "backboard_curvature": ("curvature",),
    "backboard_bounds": ("g0", "g1", "g2", "g3",),
    "backboard_arrival": ("time", "rate", "bend", "apex", "height",),
    "backboard_margin": ("margin",),
    "backboard_place": ("x", "y", "z",),
    "backboard_within": ("arrives",),
    "backboard_edges": ("unsure",),
    "bridge_coefficients": ("c0", "c1", "c2",),
    "bridge_deflated": ("c0", "c1",),
    "bridge_normal": ("nx", "ny", "nz",),
    "bridge_curvature": ("curvature",),
    "bridge_bounds": ("g0", "g1", "g2", "g3", "g4",),
    "bridge_arrival": ("time", "rate", "bend", "apex", "height",),
    "bridge_margin": ("margin",),
    "bridge_place": ("x", "y", "z",),
    "bridge_within": ("arrives",),
    "bridge_edges": ("unsure",),
    "end_coefficients": ("c0", "c1", "c2",),
    "end_deflated": ("c0", "c1",),
    "end_normal": ("nx", "ny", "nz",),
    "end_curvature": ("curvature",),
    "end_arrival": ("time", "rate", "bend", "apex", "height",),
    "end_margin": ("margin",),
    "end_place": ("x", "y", "z",),
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


def flight(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, gravity: Any) -> tuple[Any, ...]:
    """Position and velocity at time t of a flight.

    Eq. 3. 11 operations: 3 additions, 2 subtractions, 6 multiplications.
    Returns x, y, z, vx, vy, vz.
    """
    return x + (t * vx), y + (t * vy), z + (t * (vz - ((0.5 * gravity) * t))), vx, vy, vz - (gravity * t)


def contact_frame(nx: Any, ny: Any, nz: Any) -> tuple[Any, ...]:
    """The contact frame R = [n1 n2 n3] of a unit normal.

    Eqs. 7-10, Eq. 7 with the smallest component. 72 operations: 6 additions, 3 subtractions, 18 multiplications, 12 divisions, 3 square roots, 9 negations, 3 comparisons, 18 selections.
    Returns n11, n12, n13, n21, n22, n23, n31, n32, n33.
    """
    s0 = nx * nx
    s1 = ny * ny
    s2 = nz * nz
    s3 = sqrt((1.0 - s0))
    s4 = sqrt((1.0 - s1))
    s5 = nx * ny
    s6 = sqrt((1.0 - s2))
    s7 = nx * nz
    s8 = s1 <= s2
    s9 = where(s8, (-(s5 / s4)), (-(s7 / s6)))
    s10 = s0 <= s2
    s11 = s0 <= s1
    s12 = where(s8, (-((nz * s4) + ((s1 * nz) / s4))), ((ny * s6) + ((ny * s2) / s6)))
    s13 = ny * nz
    s14 = where(s8, s4, (-(s13 / s6)))
    s15 = where(s8, 0.0, (-((nx * s6) + ((nx * s2) / s6))))
    s16 = where(s8, (-(s13 / s4)), s6)
    s17 = where(s8, ((nx * s4) + ((nx * s1) / s4)), 0.0)
    s18 = where(s11, where(s10, (-((ny * s3) + ((s0 * ny) / s3))), s17), s17)
    return where(s11, where(s10, s3, s9), s9), where(s11, where(s10, 0.0, s12), s12), nx, where(s11, where(s10, (-(s5 / s3)), s14), s14), where(s11, where(s10, ((nz * s3) + ((s0 * nz) / s3)), s15), s15), ny, where(s11, where(s10, (-(s7 / s3)), s16), s16), s18, nz


def impact_through_frame(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, n11: Any, n12: Any, n13: Any, n21: Any, n22: Any, n23: Any, n31: Any, n32: Any, n33: Any, ball_radius: Any, restitution: Any) -> tuple[Any, ...]:
    """Velocity and spin after a contact, through the contact frame.

    Eqs. 11-17 by the closed-form inverse. 96 operations: 21 additions, 11 subtractions, 57 multiplications, 6 divisions, 1 negation.
    Returns vx, vy, vz, wx, wy, wz.
    """
    s0 = ((n12 * wx) + (n22 * wy)) + (n32 * wz)
    s1 = 0.4 * ball_radius
    s2 = 0.6 * n11
    s3 = 0.6 * n21
    s4 = 0.6 * n31
    s5 = (((s1 * s0) + (s2 * vx)) + (s3 * vy)) + (s4 * vz)
    s6 = 0.6 * n12
    s7 = 0.6 * n22
    s8 = 0.6 * n32
    s9 = ((n11 * wx) + (n21 * wy)) + (n31 * wz)
    s10 = (((s6 * vx) + (s7 * vy)) + (s8 * vz)) - (s1 * s9)
    s11 = ((n13 * vx) + (n23 * vy)) + (n33 * vz)
    s12 = ((n13 * wx) + (n23 * wy)) + (n33 * wz)
    s13 = 0.6666666666666666 * ball_radius
    s14 = (((n12 * vx) + (n22 * vy)) + (n32 * vz)) - (s13 * s9)
    s15 = -((((s13 * s0) + (n11 * vx)) + (n21 * vy)) + (n31 * vz))
    return ((n11 * s5) + (n12 * s10)) - ((n13 * restitution) * s11), ((n21 * s5) + (n22 * s10)) - ((n23 * restitution) * s11), ((n31 * s5) + (n32 * s10)) - ((n33 * restitution) * s11), ((n13 * s12) - ((s2 * s14) / ball_radius)) - ((s6 * s15) / ball_radius), ((n23 * s12) - ((s3 * s14) / ball_radius)) - ((s7 * s15) / ball_radius), ((n33 * s12) - ((s4 * s14) / ball_radius)) - ((s8 * s15) / ball_radius)


def crossing(margin: Any, rate_margin: Any, rate: Any, ceiling: Any) -> tuple[Any, ...]:
    """Positive clearance if a crossing is certain, and the bound on its delay.

    Taylor's theorem with the margins of the gap and its rate. 11 operations: 1 addition, 1 subtraction, 4 multiplications, 1 division, 1 negation, 1 comparison, 2 selections.
    Returns clearance, delay.
    """
    s0 = -(rate + rate_margin)
    s1 = 0.0 < s0
    return where(s1, ((s0 * s0) - ((6.0 * ceiling) * margin)), s0), where(s1, ((6.0 * margin) / s0), inf)


def allowance(share: Any, horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, gravity: Any) -> tuple[Any, ...]:
    """Errors of a state that a search allows for, and by how much the errors exceed them.

    a share of the size of the flight. 10 operations: 2 additions, 2 subtractions, 4 multiplications, 1 comparison, 1 selection.
    Returns level, velocity_level, excess.
    """
    s0 = speed + (gravity * horizon)
    s1 = share * (extent + (horizon * s0))
    s2 = share * s0
    s3 = position_error - s1
    s4 = velocity_error - s2
    return s1, s2, where((s3 < s4), s4, s3)


def horizon(t: Any, speed: Any, gravity: Any) -> tuple[Any, ...]:
    """A time after which no event is wanted, and how long that is after t.

    the earliest arrival, with room for its delay. 5 operations: 2 additions, 2 multiplications, 1 division.
    Returns horizon, pad.
    """
    s0 = 9.5367431640625e-07 * (t + (speed * (1.0 / gravity)))
    return t + s0, s0


def scale(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, gravity: Any) -> tuple[Any, ...]:
    """Sums of the sizes of the coordinates and of the velocities; excess over the largest.

    what rounding errors are measured by. 24 operations: 4 additions, 1 subtraction, 1 division, 6 absolute values, 6 comparisons, 6 selections.
    Returns extent, speed, excess.
    """
    s0 = absolute(x)
    s1 = absolute(y)
    s2 = absolute(z)
    s3 = absolute(vx)
    s4 = absolute(vy)
    s5 = absolute(vz)
    s6 = 1.0 / gravity
    s7 = where((s6 < s0), s0, s6)
    s8 = where((s7 < s1), s1, s7)
    s9 = where((s8 < s2), s2, s8)
    s10 = where((s9 < s3), s3, s9)
    s11 = where((s10 < s4), s4, s10)
    return (s0 + s1) + s2, (s3 + s4) + s5, where((s11 < s5), s5, s11) - 2.9073548971824276e+135


def displacement(delay: Any, horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, ball_radius: Any, ring_radius: Any, wire_radius: Any, board_distance: Any, board_half_width: Any, board_bottom: Any, board_top: Any, bridge_half_width: Any, gravity: Any, end_depth: Any) -> tuple[Any, ...]:
    """Bound on the error of a length at a computed arrival.

    running error analysis. 25 operations: 15 additions, 8 multiplications, 2 absolute values.
    Returns margin.
    """
    s0 = speed + (gravity * horizon)
    s1 = extent + (horizon * s0)
    s2 = (((((ball_radius + board_distance) + board_half_width) + bridge_half_width) + end_depth) + ring_radius) + wire_radius
    s3 = ((1.0009765625 * delay) * s0) + (4.445228907190568e-16 * (s1 + ((s2 + absolute(board_bottom)) + absolute(board_top))))
    return s3 + (3.0029296875 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * s1))),


def carry_flight(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, nx: Any, ny: Any, nz: Any, clock: Any, contacts: Any, late: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, curving: Any, gravity: Any) -> tuple[Any, ...]:
    """Errors of a state at the end of a flight to a surface, from those at its start.

    derivative of Eq. 3 and of the contact time, with roundings. 118 operations: 24 additions, 1 subtraction, 30 multiplications, 3 divisions, 5 negations, 17 absolute values, 19 comparisons, 19 selections.
    Returns dx, dy, dz, dvx, dvy, dvz, delay, shift.
    """
    s0 = dx + (dvx * t)
    s1 = absolute(vx)
    s2 = 2.0 * t
    s3 = 1.1102230246251565e-16 * ((s2 * s1) + absolute(x))
    s4 = s0 + where((s0 < 0.0), (-s3), s3)
    s5 = dy + (dvy * t)
    s6 = absolute(vy)
    s7 = 1.1102230246251565e-16 * ((s2 * s6) + absolute(y))
    s8 = s5 + where((s5 < 0.0), (-s7), s7)
    s9 = dz + (dvz * t)
    s10 = absolute(vz)
    s11 = 1.1102230246251565e-16 * (((gravity * (t * t)) + (s2 * s10)) + absolute(z))
    s12 = s9 + where((s9 < 0.0), (-s11), s11)
    s13 = ((nx * vx) + (ny * vy)) + (nz * vz)
    s14 = (-(((nx * s4) + (ny * s8)) + (nz * s12))) / s13
    s15 = (vx * s14) + s4
    s16 = where((s1 < s6), s6, s1)
    s17 = where((s16 < s10), s10, s16)
    s18 = absolute(dx)
    s19 = absolute(dy)
    s20 = where((s18 < s19), s19, s18)
    s21 = absolute(dz)
    s22 = where((s20 < s21), s21, s20)
    s23 = curving * (t * s17)
    s24 = absolute(dvx)
    s25 = absolute(dvy)
    s26 = where((s24 < s25), s25, s24)
    s27 = absolute(dvz)
    s28 = where((s3 < s7), s7, s3)
    s29 = (t * where((s26 < s27), s27, s26)) + where((s28 < s11), s11, s28)
    s30 = ((s17 / absolute(s13)) * ((s22 * where((s23 < 1.0), s23, 1.0)) + s29)) + (s29 + s22)
    s31 = s30 / (8.0 + (8.0 * contacts))
    s32 = -s31
    s33 = (vy * s14) + s8
    s34 = (vz * s14) + s12
    s35 = absolute(s14)
    s36 = 0.0625 * late
    return where((absolute(s15) < s31), where((s15 < 0.0), s32, s31), s15), where((absolute(s33) < s31), where((s33 < 0.0), s32, s31), s33), where((absolute(s34) < s31), where((s34 < 0.0), s32, s31), s34), dvx, dvy, dvz - (gravity * s14), (4.440892098500626e-16 * (clock + t)) + where((s35 < s36), s36, s35), s30


def error_bounds(clock_error: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any) -> tuple[Any, ...]:
    """Bounds on the errors of a state and its time that decisions allow for.

    the carried errors times a guard. 25 operations: 4 multiplications, 9 absolute values, 6 comparisons, 6 selections.
    Returns position_error, velocity_error, spin_error, time_error.
    """
    s0 = absolute(dx)
    s1 = absolute(dy)
    s2 = where((s0 < s1), s1, s0)
    s3 = absolute(dz)
    s4 = absolute(dvx)
    s5 = absolute(dvy)
    s6 = where((s4 < s5), s5, s4)
    s7 = absolute(dvz)
    s8 = absolute(dwx)
    s9 = absolute(dwy)
    s10 = where((s8 < s9), s9, s8)
    s11 = absolute(dwz)
    return 16.0 * where((s2 < s3), s3, s2), 16.0 * where((s6 < s7), s7, s6), 16.0 * where((s10 < s11), s11, s10), 16.0 * clock_error


def claimed_errors(clock_error: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any) -> tuple[Any, ...]:
    """Bounds on the errors of a state and its time that a shot claims.

    the carried errors times a larger guard. 25 operations: 4 multiplications, 9 absolute values, 6 comparisons, 6 selections.
    Returns position_error, velocity_error, spin_error, time_error.
    """
    s0 = absolute(dx)
    s1 = absolute(dy)
    s2 = where((s0 < s1), s1, s0)
    s3 = absolute(dz)
    s4 = absolute(dvx)
    s5 = absolute(dvy)
    s6 = where((s4 < s5), s5, s4)
    s7 = absolute(dvz)
    s8 = absolute(dwx)
    s9 = absolute(dwy)
    s10 = where((s8 < s9), s9, s8)
    s11 = absolute(dwz)
    return 64.0 * where((s2 < s3), s3, s2), 64.0 * where((s6 < s7), s7, s6), 64.0 * where((s10 < s11), s11, s10), 64.0 * clock_error


def allowed(ball_radius: Any, ring_radius: Any, wire_radius: Any, board_distance: Any, board_half_width: Any, bridge_half_width: Any, restitution: Any, gravity: Any, end_depth: Any) -> tuple[Any, ...]:
    """1 where finite parameters are allowed.

    the scene's requirements. 24 operations: 2 subtractions, 11 comparisons, 11 selections.
    Returns allowed.
    """
    s0 = where((0.0 < ring_radius), where((0.0 < ball_radius), where((0.0 < ((ring_radius - ball_radius) - wire_radius)), 1.0, 0.0), 0.0), 0.0)
    s1 = where((0.0 <= restitution), where((0.0 < bridge_half_width), where((0.0 < board_half_width), where((0.0 < board_distance), where((0.0 < wire_radius), s0, 0.0), 0.0), 0.0), 0.0), 0.0)
    return where((0.0 < end_depth), where((0.0 < gravity), where((restitution <= 1.0), s1, 0.0), 0.0), 0.0),


def finite_parameters(ball_radius: Any, ring_radius: Any, wire_radius: Any, board_distance: Any, board_half_width: Any, board_bottom: Any, board_top: Any, bridge_half_width: Any, restitution: Any, gravity: Any, end_depth: Any, allowed: Any) -> tuple[Any, ...]:
    """Where the parameters are finite and allowed.

    IEEE 754. 34 operations: 11 absolute values, 12 comparisons, 11 conjunctions.
    Returns permitted.
    """
    s0 = logical_and(logical_and(logical_and(logical_and((0.0 < allowed), (absolute(ball_radius) < inf)), (absolute(ring_radius) < inf)), (absolute(wire_radius) < inf)), (absolute(board_distance) < inf))
    s1 = logical_and(logical_and(logical_and(logical_and(s0, (absolute(board_half_width) < inf)), (absolute(board_bottom) < inf)), (absolute(board_top) < inf)), (absolute(bridge_half_width) < inf))
    return logical_and(logical_and(logical_and(s1, (absolute(restitution) < inf)), (absolute(gravity) < inf)), (absolute(end_depth) < inf)),


def valid(last: Any, x: Any, y: Any, z: Any, ball_radius: Any, ring_radius: Any, wire_radius: Any, board_distance: Any, board_half_width: Any, board_bottom: Any, board_top: Any, bridge_half_width: Any, end_depth: Any) -> tuple[Any, ...]:
    """1 where no surface is overlapped; 1 where that is in doubt.

    Table 2. 111 operations: 18 additions, 17 subtractions, 11 multiplications, 1 square root, 3 negations, 18 absolute values, 20 comparisons, 23 selections.
    Returns valid, doubt.
    """
    s0 = sqrt(((x * x) + (y * y)))
    s1 = s0 - ring_radius
    s2 = ball_radius + wire_radius
    s3 = ((z * z) + (s1 * s1)) - (s2 * s2)
    s4 = absolute(last) < 0.5
    s5 = where(s4, 1.0, where((0.0 <= s3), 1.0, 0.0))
    s6 = ball_radius - board_distance
    s7 = x - s6
    s8 = 2.0 * ball_radius
    s9 = (s6 - s8) - x
    s10 = where((s7 < s9), s9, s7)
    s11 = -(board_half_width + y)
    s12 = where((s10 < s11), s11, s10)
    s13 = y - board_half_width
    s14 = where((s12 < s13), s13, s12)
    s15 = board_bottom - z
    s16 = where((s14 < s15), s15, s14)
    s17 = z - board_top
    s18 = where((s16 < s17), s17, s16)
    s19 = absolute((last - 1.0)) < 0.5
    s20 = where(s19, s5, where((0.0 <= s18), s5, 0.0))
    s21 = z - s2
    s22 = ((s2 - s8) - (2.0 * wire_radius)) - z
    s23 = where((s21 < s22), s22, s21)
    s24 = -(bridge_half_width + y)
    s25 = where((s23 < s24), s24, s23)
    s26 = y - bridge_half_width
    s27 = where((s25 < s26), s26, s25)
    s28 = ring_radius - s0
    s29 = where((s27 < s28), s28, s27)
    s30 = where((s29 < x), x, s29)
    s31 = -(board_distance + x)
    s32 = where((s30 < s31), s31, s30)
    s33 = absolute((last - 2.0)) < 0.5
    s34 = ((((absolute(ball_radius) + absolute(board_bottom)) + absolute(board_distance)) + absolute(board_half_width)) + absolute(board_top)) + absolute(bridge_half_width)
    s35 = ((((s34 + absolute(end_depth)) + absolute(ring_radius)) + absolute(wire_radius)) + absolute(x)) + absolute(y)
    s36 = 1.7763568394002505e-15 * (s35 + absolute(z))
    s37 = where(s4, 0.0, where((absolute(s3) <= (((4.0 * ball_radius) + (4.0 * wire_radius)) * s36)), 1.0, 0.0))
    s38 = where(s19, s37, where((absolute(s18) <= s36), 1.0, s37))
    return where(s33, s20, where((0.0 <= s32), s20, 0.0)), where(s33, s38, where((absolute(s32) <= s36), 1.0, s38))


def target(x: Any, y: Any, ring_radius: Any) -> tuple[Any, ...]:
    """Not positive where a crossing of the end plane is made.

    Table 2, success. 5 operations: 1 addition, 1 subtraction, 2 multiplications, 1 square root.
    Returns target.
    """
    return sqrt(((x * x) + (y * y))) - ring_radius,


def left(index: Any, last: Any) -> tuple[Any, ...]:
    """1 where the ball leaves a surface.

    Table 1. 2 operations: 1 comparison, 1 selection.
    Returns leaving.
    """
    return where((last == index), 1.0, 0.0),


def meeting_plane(bend: Any, rate: Any, time: Any) -> tuple[Any, ...]:
    """Whether a plane's only arrival is one, and the size of the bend there.

    Table 1. 12 operations: 1 absolute value, 6 comparisons, 4 conjunctions, 1 disjunction.
    Returns arrives, ceiling.
    """
    s0 = logical_and(logical_and(logical_or((rate < 0.0), logical_and(logical_and((rate <= 0.0), (bend < 0.0)), (time == 0.0))), (0.0 <= time)), (time < inf))
    return s0, absolute(bend)


def timely(arrives: Any, delay: Any, late: Any, time: Any, when: Any) -> tuple[Any, ...]:
    """Whether an arrival may be the earliest, as far as their delays are bounded.

    Table 1. 5 operations: 1 addition, 1 subtraction, 1 comparison, 1 conjunction, 1 complement.
    Returns possible.
    """
    return logical_and(arrives, logical_not(((delay + late) < (time - when)))),


def grazed(apex: Any, doubt: Any, height: Any, margin: Any) -> tuple[Any, ...]:
    """A doubt where the gap's apex is zero within its error.

    Table 1. 7 operations: 1 absolute value, 3 comparisons, 2 conjunctions, 1 selection.
    Returns doubt.
    """
    return where(logical_and(logical_and((0.0 <= apex), (absolute(height) <= margin)), (apex < doubt)), apex, doubt),


def questioned(doubt: Any, time: Any, unsure: Any) -> tuple[Any, ...]:
    """A doubt about a decision at a time.

    Table 1. 3 operations: 1 comparison, 1 conjunction, 1 selection.
    Returns doubt.
    """
    return where(logical_and(unsure, (time < doubt)), time, doubt),


def crossed(arrives: Any, clearance: Any, doubt: Any, time: Any) -> tuple[Any, ...]:
    """A doubt about an arrival whose crossing is not certain.

    Table 1. 6 operations: 2 comparisons, 2 conjunctions, 1 complement, 1 selection.
    Returns doubt.
    """
    return where(logical_and(logical_and(arrives, logical_not((0.0 < clearance))), (time < doubt)), time, doubt),


def tied(arrives: Any, delay: Any, doubt: Any, late: Any, time: Any, when: Any) -> tuple[Any, ...]:
    """A doubt about two arrivals within their delays; the delay of the earlier one.

    Table 1. 12 operations: 1 addition, 1 subtraction, 1 absolute value, 3 comparisons, 3 conjunctions, 3 selections.
    Returns doubt, late.
    """
    s0 = time < when
    s1 = where(s0, time, when)
    s2 = where(logical_and(logical_and(arrives, (absolute((time - when)) <= (delay + late))), (s1 < doubt)), s1, doubt)
    return s2, where(logical_and(arrives, s0), delay, late)


def sooner(arrives: Any, index: Any, time: Any, when: Any, which: Any) -> tuple[Any, ...]:
    """The earlier of the earliest arrival so far and this one.

    Table 1. 4 operations: 1 comparison, 1 conjunction, 2 selections.
    Returns when, which.
    """
    s0 = logical_and(arrives, (time < when))
    return where(s0, time, when), where(s0, index, which)


def opens(clear: Any) -> tuple[Any, ...]:
    """Where a surface is not certainly missed.

    Table 1. 2 operations: 1 comparison, 1 complement.
    Returns open.
    """
    return logical_not((0.0 < clear)),


def beginning() -> tuple[Any, ...]:
    """How a search begins: with the errors that it allows for, and nothing found.

    Table 1. No operations.
    Returns share, arrival, certain.
    """
    return 2.9802322387695312e-08, inf, False


def beyond(doubt: Any, excess: Any, late: Any, lost: Any, pad: Any) -> tuple[Any, ...]:
    """Nothing is certain where the errors exceed what the search allows for.

    Table 1. 6 operations: 3 comparisons, 2 disjunctions, 1 selection.
    Returns doubt.
    """
    return where(logical_or(logical_or((0.0 < excess), (0.0 < lost)), (pad < late)), 0.0, doubt),


def nearby(flat: Any, index: Any, last: Any, t: Any, tilt: Any) -> tuple[Any, ...]:
    """1 near the surface that the ball left, where F/t is known better than F; the margin.

    Table 1. 6 operations: 1 multiplication, 2 comparisons, 1 conjunction, 2 selections.
    Returns leaving, margin.
    """
    s0 = t * tilt
    s1 = logical_and((last == index), (s0 < flat))
    return where(s1, 1.0, 0.0), where(s1, s0, flat)


def struck(bend: Any, clearance: Any, gap: Any, margin: Any, rate: Any, rate_margin: Any, share: Any) -> tuple[Any, ...]:
    """Whether the gap closes, surely, or is to be looked at with smaller errors allowed.

    Table 1. 17 operations: 1 subtraction, 6 comparisons, 6 conjunctions, 2 disjunctions, 2 complements.
    Returns hit, sure, vague.
    """
    s0 = logical_or((rate < 0.0), logical_and((rate <= rate_margin), (bend < 0.0)))
    s1 = 0.0 < clearance
    s2 = logical_and(s0, logical_or(((gap - margin) <= margin), s1))
    s3 = logical_and(s0, s1)
    s4 = logical_and(logical_and(s2, logical_not(s3)), (0.0 < share))
    return logical_and(s2, logical_not(s4)), s3, s4


def finer(share: Any) -> tuple[Any, ...]:
    """The next smaller errors that a search allows for.

    Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection.
    Returns share.
    """
    return where((2.842170943040401e-14 < share), (0.03125 * share), 0.0),


def exceeded(doubt: Any, excess: Any, t: Any) -> tuple[Any, ...]:
    """A doubt where the errors exceed what is allowed for.

    Table 1. 4 operations: 2 comparisons, 1 conjunction, 1 selection.
    Returns doubt.
    """
    return where(logical_and((0.0 < excess), (t < doubt)), t, doubt),


def advanced(arrival: Any, certain: Any, end: Any, hit: Any, next: Any, root: Any, step: Any, sure: Any, t: Any, vague: Any) -> tuple[Any, ...]:
    """The search after a step: what it found, whether its window is exhausted, where it is.

    Table 1. 14 operations: 1 subtraction, 1 comparison, 4 conjunctions, 2 disjunctions, 3 complements, 3 selections.
    Returns arrival, certain, exhausted, searching, t.
    """
    s0 = logical_not(hit)
    s1 = logical_and(logical_and(s0, logical_not(vague)), ((end - t) <= step))
    return where(hit, where(sure, root, t), arrival), logical_or(certain, logical_and(hit, sure)), s1, logical_and(s0, logical_not(s1)), where(logical_or(hit, vague), t, next)


def found(arrival: Any) -> tuple[Any, ...]:
    """Whether a search found an arrival.

    Table 1. 1 operation: 1 comparison.
    Returns arrives.
    """
    return arrival < inf,


def polished(arrival: Any, certain: Any, refined: Any) -> tuple[Any, ...]:
    """A root that is certain, refined.

    Table 1. 1 operation: 1 selection.
    Returns arrival.
    """
    return where(certain, refined, arrival),


def own_margin(arrival: Any, flat: Any, leaving: Any, tilt: Any) -> tuple[Any, ...]:
    """The margin of the form that an arrival was found with.

    Table 1. 3 operations: 1 multiplication, 1 comparison, 1 selection.
    Returns margin.
    """
    return where((0.0 < leaving), (arrival * tilt), flat),


def landed(arrival: Any) -> tuple[Any, ...]:
    """The time of an arrival, not before the flight.

    Table 1. 2 operations: 1 comparison, 1 selection.
    Returns time.
    """
    return where((arrival < 0.0), 0.0, arrival),


def landed_surely(arrives: Any, certain: Any, clearance: Any, delay: Any, doubt: Any, time: Any) -> tuple[Any, ...]:
    """The delay of an arrival that is certain, a doubt about another one.

    Table 1. 8 operations: 2 comparisons, 3 conjunctions, 1 complement, 2 selections.
    Returns delay, doubt.
    """
    s0 = logical_and(certain, (0.0 < clearance))
    return where(s0, delay, 0.0), where(logical_and(logical_and(arrives, logical_not(s0)), (time < doubt)), time, doubt)


def outside() -> tuple[Any, ...]:
    """A search that begins outside the surface.

    Table 1. No operations.
    Returns side.
    """
    return 1.0,


def admitted(doubt: Any, finite: Any, permitted: Any, valid: Any) -> tuple[Any, ...]:
    """Whether a shot can start, and whether that is in doubt.

    Table 1. 7 operations: 2 comparisons, 3 conjunctions, 2 selections.
    Returns outcome, uncertain.
    """
    s0 = logical_and(permitted, finite)
    return where(logical_and(s0, (0.0 < valid)), -1.0, 4.0), where(logical_and(s0, (0.0 < doubt)), 1.0, 0.0)


def finite_state(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, x: Any, y: Any, z: Any) -> tuple[Any, ...]:
    """Where every number of a state is finite.

    Table 1. 26 operations: 9 absolute values, 9 comparisons, 8 conjunctions.
    Returns finite.
    """
    s0 = logical_and(logical_and(logical_and(logical_and((absolute(x) < inf), (absolute(y) < inf)), (absolute(z) < inf)), (absolute(vx) < inf)), (absolute(vy) < inf))
    s1 = logical_and(logical_and(logical_and(logical_and(s0, (absolute(vz) < inf)), (absolute(wx) < inf)), (absolute(wy) < inf)), (absolute(wz) < inf))
    return s1,


def opening(excess: Any, position_error: Any, velocity_error: Any) -> tuple[Any, ...]:
    """No arrival yet; nothing is certain where the errors are not bounded.

    Table 1. 6 operations: 3 comparisons, 2 conjunctions, 1 selection.
    Returns when, which, late, doubt.
    """
    return inf, -1.0, 0.0, where(logical_and(logical_and((position_error < inf), (velocity_error < inf)), (excess <= 0.0)), inf, 0.0)


def departed(index: Any, which: Any) -> tuple[Any, ...]:
    """Whether there is no event, the end, or a contact.

    Table 1. 5 operations: 2 comparisons, 1 conjunction, 2 complements.
    Returns stays, moves, ends, touches.
    """
    s0 = which < 0.0
    s1 = logical_not(s0)
    s2 = which == index
    return s0, s1, s2, logical_and(s1, logical_not(s2))


def ticked(clock: Any, when: Any) -> tuple[Any, ...]:
    """The time of the event.

    Table 1. 1 operation: 1 addition.
    Returns clock.
    """
    return clock + when,


def doubted(doubt: Any, ends: Any, late: Any, miss: Any, slack: Any, uncertain: Any, when: Any) -> tuple[Any, ...]:
    """1 where a decision up to this event, or on the target, lies within its error.

    Table 1. 10 operations: 1 addition, 1 absolute value, 3 comparisons, 2 conjunctions, 1 disjunction, 1 complement, 1 selection.
    Returns uncertain.
    """
    s0 = where(logical_or(logical_and(logical_not(((late + when) < doubt)), (doubt < inf)), logical_and(ends, (absolute(miss) <= slack))), 1.0, uncertain)
    return s0,


def accounted(contacts: Any, ends: Any, miss: Any, most_contacts: Any, touches: Any) -> tuple[Any, ...]:
    """How many contacts there were, and whether the shot ends and how.

    Table 1. 8 operations: 1 addition, 2 comparisons, 5 selections.
    Returns contacts, outcome.
    """
    s0 = 1.0 + contacts
    return where(touches, s0, contacts), where(touches, where((most_contacts <= s0), 2.0, -1.0), where(ends, where((miss <= 0.0), 0.0, 1.0), 3.0))


def meeting(claims: Any, ends: Any, touches: Any) -> tuple[Any, ...]:
    """Where an event changes the ball, or its errors are asked for.

    Table 1. 3 operations: 1 comparison, 1 conjunction, 1 disjunction.
    Returns meeting.
    """
    return logical_or(touches, logical_and(ends, (0.0 < claims))),


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
    return inf,


def again(index: Any, last: Any, which: Any) -> tuple[Any, ...]:
    """Whether the ball meets the surface that it touched last.

    Table 1. 3 operations: 2 comparisons, 1 conjunction.
    Returns again.
    """
    return logical_and((which == index), (last == which)),


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
    return where((absolute(dx) < shift), shift, dx), where((absolute(dy) < shift), shift, dy), where((absolute(dz) < shift), shift, dz)


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
    return where((first < 0.0), body, first), which


def closing(claims: Any, outcome: Any) -> tuple[Any, ...]:
    """Where a shot has ended whose errors are asked for.

    Table 1. 3 operations: 2 comparisons, 1 conjunction.
    Returns closed.
    """
    return logical_and((0.0 < claims), (0.0 <= outcome)),


def body_of(which: Any) -> tuple[Any, ...]:
    """The body that the event is on.

    Table 1. No operations.
    Returns body.
    """
    return which,


def impact(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, ball_radius: Any, restitution: Any) -> tuple[Any, ...]:
    """Velocity and spin after a contact, frame-free.

    Eqs. 11-17, the frame eliminated. 63 operations: 10 additions, 12 subtractions, 40 multiplications, 1 division.
    Returns vx, vy, vz, wx, wy, wz.
    """
    s0 = 0.4 * ball_radius
    s1 = ((nx * vx) + (ny * vy)) + (nz * vz)
    s2 = (s0 * ((nz * wy) - (ny * wz))) + (0.6 * (vx - (nx * s1)))
    s3 = (s0 * ((nx * wz) - (nz * wx))) + (0.6 * (vy - (ny * s1)))
    s4 = (s0 * ((ny * wx) - (nx * wy))) + (0.6 * (vz - (nz * s1)))
    s5 = ((nx * wx) + (ny * wy)) + (nz * wz)
    s6 = 1.0 / ball_radius
    return s2 - ((nx * restitution) * s1), s3 - ((ny * restitution) * s1), s4 - ((nz * restitution) * s1), (nx * s5) + (s6 * ((ny * s4) - (nz * s3))), (ny * s5) + (s6 * ((nz * s2) - (nx * s4))), (nz * s5) + (s6 * ((nx * s3) - (ny * s2)))


def carry_impact(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, contacts: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, dnx: Any, dny: Any, dnz: Any, turn: Any, ball_radius: Any, restitution: Any) -> tuple[Any, ...]:
    """Errors of velocity and spin after a contact, from those before it.

    derivative of the frame-free Eq. 17, with roundings. 243 operations: 46 additions, 30 subtractions, 97 multiplications, 4 divisions, 4 negations, 18 absolute values, 22 comparisons, 22 selections.
    Returns dvx, dvy, dvz, dwx, dwy, dwz.
    """
    s0 = 0.4 * ball_radius
    s1 = ((nx * vx) + (ny * vy)) + (nz * vz)
    s2 = (((((dnx * vx) + (dny * vy)) + (dnz * vz)) + (dvx * nx)) + (dvy * ny)) + (dvz * nz)
    s3 = (s0 * ((((dnz * wy) + (dwy * nz)) - (dny * wz)) - (dwz * ny))) + (0.6 * ((dvx - (dnx * s1)) - (nx * s2)))
    s4 = (s3 - ((dnx * restitution) * s1)) - ((nx * restitution) * s2)
    s5 = ((ball_radius * ((absolute(wx) + absolute(wy)) + absolute(wz))) + absolute(vx)) + absolute(vy)
    s6 = s5 + absolute(vz)
    s7 = 2.220446049250313e-16 * s6
    s8 = -s7
    s9 = s4 + where((s4 < 0.0), s8, s7)
    s10 = 8.0 + (8.0 * contacts)
    s11 = absolute(dwx)
    s12 = absolute(dwy)
    s13 = where((s11 < s12), s12, s11)
    s14 = absolute(dwz)
    s15 = absolute(dvx)
    s16 = absolute(dvy)
    s17 = where((s15 < s16), s16, s15)
    s18 = absolute(dvz)
    s19 = ((ball_radius * where((s13 < s14), s14, s13)) + (turn * s6)) + where((s17 < s18), s18, s17)
    s20 = s19 / s10
    s21 = -s20
    s22 = (s0 * ((((dnx * wz) + (dwz * nx)) - (dnz * wx)) - (dwx * nz))) + (0.6 * ((dvy - (dny * s1)) - (ny * s2)))
    s23 = (s22 - ((dny * restitution) * s1)) - ((ny * restitution) * s2)
    s24 = s23 + where((s23 < 0.0), s8, s7)
    s25 = (s0 * ((((dny * wx) + (dwx * ny)) - (dnx * wy)) - (dwy * nx))) + (0.6 * ((dvz - (dnz * s1)) - (nz * s2)))
    s26 = (s25 - ((dnz * restitution) * s1)) - ((nz * restitution) * s2)
    s27 = s26 + where((s26 < 0.0), s8, s7)
    s28 = ((nx * wx) + (ny * wy)) + (nz * wz)
    s29 = (((((dnx * wx) + (dny * wy)) + (dnz * wz)) + (dwx * nx)) + (dwy * ny)) + (dwz * nz)
    s30 = 1.0 / ball_radius
    s31 = (s0 * ((ny * wx) - (nx * wy))) + (0.6 * (vz - (nz * s1)))
    s32 = (s0 * ((nx * wz) - (nz * wx))) + (0.6 * (vy - (ny * s1)))
    s33 = ((dnx * s28) + (nx * s29)) + (s30 * ((((dny * s31) + (ny * s25)) - (dnz * s32)) - (nz * s22)))
    s34 = s7 / ball_radius
    s35 = -s34
    s36 = s33 + where((s33 < 0.0), s35, s34)
    s37 = s19 / (ball_radius * s10)
    s38 = -s37
    s39 = (s0 * ((nz * wy) - (ny * wz))) + (0.6 * (vx - (nx * s1)))
    s40 = ((dny * s28) + (ny * s29)) + (s30 * ((((dnz * s39) + (nz * s3)) - (dnx * s31)) - (nx * s25)))
    s41 = s40 + where((s40 < 0.0), s35, s34)
    s42 = ((dnz * s28) + (nz * s29)) + (s30 * ((((dnx * s32) + (nx * s22)) - (dny * s39)) - (ny * s3)))
    s43 = s42 + where((s42 < 0.0), s35, s34)
    return where((absolute(s9) < s20), where((s9 < 0.0), s21, s20), s9), where((absolute(s24) < s20), where((s24 < 0.0), s21, s20), s24), where((absolute(s27) < s20), where((s27 < 0.0), s21, s20), s27), where((absolute(s36) < s37), where((s36 < 0.0), s38, s37), s36), where((absolute(s41) < s37), where((s41 < 0.0), s38, s37), s41), where((absolute(s43) < s37), where((s43 < 0.0), s38, s37), s43)


def ring_coefficients(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, ball_radius: Any, ring_radius: Any, wire_radius: Any, gravity: Any) -> tuple[Any, ...]:
    """Coefficients in time of the event polynomial, constant first.

    Eq. 3 in Table 2. 64 operations: 12 additions, 8 subtractions, 43 multiplications, 1 negation.
    Returns c0, c1, c2, c3, c4, c5, c6, c7, c8.
    """
    s0 = ring_radius * ring_radius
    s1 = x * x
    s2 = y * y
    s3 = ball_radius + wire_radius
    s4 = (((s0 + s1) + s2) + (z * z)) - (s3 * s3)
    s5 = 4.0 * s0
    s6 = ((2.0 * vx) * x) + ((2.0 * vy) * y)
    s7 = s6 + ((2.0 * vz) * z)
    s8 = 2.0 * s7
    s9 = (vx * vx) + (vy * vy)
    s10 = vz * vz
    s11 = (s9 + s10) - (gravity * z)
    s12 = (2.0 * gravity) * vz
    s13 = gravity * gravity
    s14 = 0.5 * s13
    return (s4 * s4) - (s5 * (s1 + s2)), (s8 * s4) - (s5 * s6), (((2.0 * s11) * s4) + (s7 * s7)) - (s5 * s9), (s8 * s11) - (s12 * s4), ((s14 * s4) + (s11 * s11)) - (s12 * s7), (s14 * s7) - (s12 * s11), (s13 * s10) + (s14 * s11), -((0.5 * (gravity * s13)) * vz), 0.0625 * (s13 * s13)


def ring_deflated(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, ball_radius: Any, ring_radius: Any, wire_radius: Any, gravity: Any) -> tuple[Any, ...]:
    """Coefficients of the event polynomial over t, after a contact at t = 0.

    Eq. 3 in Table 2, the exact root divided out. 60 operations: 11 additions, 7 subtractions, 41 multiplications, 1 negation.
    Returns c0, c1, c2, c3, c4, c5, c6, c7.
    """
    s0 = ((2.0 * vx) * x) + ((2.0 * vy) * y)
    s1 = s0 + ((2.0 * vz) * z)
    s2 = ring_radius * ring_radius
    s3 = ball_radius + wire_radius
    s4 = (((s2 + (x * x)) + (y * y)) + (z * z)) - (s3 * s3)
    s5 = 2.0 * s1
    s6 = 4.0 * s2
    s7 = (vx * vx) + (vy * vy)
    s8 = vz * vz
    s9 = (s7 + s8) - (gravity * z)
    s10 = (2.0 * gravity) * vz
    s11 = gravity * gravity
    s12 = 0.5 * s11
    return (s5 * s4) - (s6 * s0), (((2.0 * s9) * s4) + (s1 * s1)) - (s6 * s7), (s5 * s9) - (s10 * s4), ((s12 * s4) + (s9 * s9)) - (s10 * s1), (s12 * s1) - (s10 * s9), (s11 * s8) + (s12 * s9), -((0.5 * (gravity * s11)) * vz), 0.0625 * (s11 * s11)


def ring_normal(x: Any, y: Any, z: Any, ball_radius: Any, ring_radius: Any, wire_radius: Any) -> tuple[Any, ...]:
    """Outward unit normal n3 at a contact.

    Table 2. 13 operations: 2 additions, 1 subtraction, 7 multiplications, 2 divisions, 1 square root.
    Returns nx, ny, nz.
    """
    s0 = 1.0 / (ball_radius + wire_radius)
    s1 = sqrt(((x * x) + (y * y)))
    s2 = (s0 * (s1 - ring_radius)) * (1.0 / s1)
    return x * s2, y * s2, z * s0


def ring_curvature(ball_radius: Any, ring_radius: Any, wire_radius: Any) -> tuple[Any, ...]:
    """Bound on the rate at which the normal turns along the contact surface.

    Table 2. 6 operations: 1 addition, 2 subtractions, 1 division, 1 comparison, 1 selection.
    Returns curvature.
    """
    s0 = (ring_radius - ball_radius) - wire_radius
    s1 = ball_radius + wire_radius
    return 1.0 / where((s0 < s1), s0, s1),


def ring_carry_normal(x: Any, y: Any, dx: Any, dy: Any, dz: Any, shift: Any, ball_radius: Any, ring_radius: Any, wire_radius: Any) -> tuple[Any, ...]:
    """Error of the normal, from that of the position.

    derivative of Table 2's normal. 38 operations: 6 additions, 3 subtractions, 21 multiplications, 4 divisions, 1 square root, 1 negation, 1 comparison, 1 selection.
    Returns dnx, dny, dnz, turn.
    """
    s0 = ball_radius + wire_radius
    s1 = 1.0 / s0
    s2 = sqrt(((x * x) + (y * y)))
    s3 = s2 - ring_radius
    s4 = 1.0 / s2
    s5 = (s1 * s3) * s4
    s6 = (0.5 * (((2.0 * dx) * x) + ((2.0 * dy) * y))) / s2
    s7 = ((s6 * s1) * s4) + (((-(s6 * (s4 * s4))) * s1) * s3)
    s8 = (ring_radius - ball_radius) - wire_radius
    return (dx * s5) + (x * s7), (dy * s5) + (y * s7), dz * s1, shift * (1.0 / where((s8 < s0), s8, s0))


def ring_clear(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, ball_radius: Any, ring_radius: Any, wire_radius: Any, gravity: Any) -> tuple[Any, ...]:
    """Positive if there certainly is no contact before the horizon.

    bounds of the event condition. 146 operations: 27 additions, 19 subtractions, 67 multiplications, 1 division, 2 square roots, 15 comparisons, 15 selections.
    Returns clear.
    """
    s0 = ball_radius + wire_radius
    s1 = (0.000244140625 * ring_radius) - (ring_radius - s0)
    s2 = position_error + (horizon * velocity_error)
    s3 = (s2 - (1.52587890625e-05 * ball_radius)) - (1.52587890625e-05 * wire_radius)
    s4 = 1.00006103515625 * s0
    s5 = ring_radius + s4
    s6 = vz * vz
    s7 = s6 + ((2.0 * gravity) * (z - s4))
    s8 = 1.0 / gravity
    s9 = sqrt(s7)
    s10 = s8 * (vz - s9)
    s11 = s8 * (vz + s9)
    s12 = x + (vx * s11)
    s13 = y + (vy * s11)
    s14 = (s12 * s12) + (s13 * s13)
    s15 = sqrt(s14)
    s16 = s15 - ring_radius
    s17 = z + ((vz - ((0.5 * gravity) * s11)) * s11)
    s18 = s5 * s5
    s19 = 9.313225746154785e-10 * s18
    s20 = (((s16 * s16) + (s17 * s17)) - (s0 * s0)) - s19
    s21 = (vx * vx) + (vy * vy)
    s22 = ring_radius - s4
    s23 = 0.0001220703125 * ring_radius
    s24 = where((s22 < s23), s23, s22)
    s25 = s24 * s24
    s26 = s24 * s25
    s27 = ((((2.0 * s6) + ((4.0 * gravity) * z)) + (2.0 * s21)) - ((6.0003662109375 * gravity) * s0)) * s26
    s28 = (vy * x) - (vx * y)
    s29 = s28 * s28
    s30 = s27 - ((2.0 * ring_radius) * s29)
    s31 = (s16 * ((vx * s12) + (vy * s13))) + ((s17 * (vz - (gravity * s11))) * s15)
    s32 = x + (horizon * vx)
    s33 = y + (horizon * vy)
    s34 = where(((((s19 + (s32 * s32)) + (s33 * s33)) - s25) < 0.0), 1.0, where((((s21 * (s19 + s25)) - s29) < 0.0), 1.0, 0.0))
    s35 = where(((((4.0 * (s31 * s31)) * s26) - (((2.0 * s30) * s14) * s20)) < 0.0), s34, 0.0)
    s36 = where((horizon < (s11 - (9.313225746154785e-10 * horizon))), 1.0, where((0.0 < s20), where((0.0 < s30), s35, 0.0), 0.0))
    s37 = (vx * x) + (vy * y)
    s38 = (s10 * s21) + s37
    s39 = where((s38 < 0.0), where((s18 < ((s10 * (s37 + s38)) + ((x * x) + (y * y)))), s36, 0.0), 0.0)
    s40 = where(((extent + (horizon * (speed + (gravity * horizon)))) < (65536.0 * s5)), where((0.0 < s7), where((s10 < 0.0), s36, s39), 0.0), 0.0)
    return where((0.0 < where((s1 < s3), s3, s1)), 0.0, where((s2 < (5.820766091346741e-11 * s5)), s40, 0.0)),


def ring_prepare(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, position_error: Any, velocity_error: Any, ball_radius: Any, ring_radius: Any, wire_radius: Any, gravity: Any) -> tuple[Any, ...]:
    """Constants and windows of the search along a flight, and the errors it allows for.

    bounds of the event condition. 177 operations: 28 additions, 20 subtractions, 48 multiplications, 3 divisions, 5 square roots, 1 negation, 5 absolute values, 30 comparisons, 37 selections.
    Returns steady, swing, rho_start, low0, high0, low1, high1, low2, high2, ceiling, latest, lost.
    """
    s0 = vz * vz
    s1 = (vx * vx) + (vy * vy)
    s2 = ((2.0 * s0) + ((4.0 * gravity) * z)) + (2.0 * s1)
    s3 = (vy * x) - (vx * y)
    s4 = s3 * s3
    s5 = (2.0 * ring_radius) * s4
    s6 = (x * x) + (y * y)
    s7 = ball_radius + wire_radius
    s8 = 1.00006103515625 * s7
    s9 = 2.0 * gravity
    s10 = 8.881784197001252e-16 * (s0 + (s9 * (absolute(z) + s8)))
    s11 = (s0 + (s9 * (z + s8))) + s10
    s12 = 1.0 / gravity
    s13 = sqrt(s11)
    s14 = 1.7763568394002505e-15 * (absolute(vz) + s13)
    s15 = 0.0 <= s11
    s16 = where(s15, (s12 * ((vz - s13) - s14)), inf)
    s17 = ring_radius + s8
    s18 = s17 * s17
    s19 = (1.7763568394002505e-15 * s1) * (s18 + s6)
    s20 = ((s18 * s1) + s19) - s4
    s21 = (vx * x) + (vy * y)
    s22 = sqrt(s20)
    s23 = 1.7763568394002505e-15 * ((absolute(s21) + absolute(s3)) + s22)
    s24 = 1.0 / s1
    s25 = 0.0 <= s20
    s26 = 2.409919865102884e-181 < s1
    s27 = where(s26, where(s25, ((-((s21 + s22) + s23)) * s24), inf), (-inf))
    s28 = where((s16 < s27), s27, s16)
    s29 = ring_radius - s8
    s30 = 0.0001220703125 * ring_radius
    s31 = where((s29 < s30), s30, s29)
    s32 = ((s1 * (s31 * s31)) - s19) - s4
    s33 = sqrt(where((s32 < 0.0), 0.0, s32))
    s34 = where(s26, where(s25, (((s22 + s23) - s21) * s24), (-inf)), inf)
    s35 = 0.0 < where(s26, s32, 0.0)
    s36 = where(s35, (((s23 - s21) - s33) * s24), s34)
    s37 = (s0 + (s9 * (z - s8))) - s10
    s38 = sqrt(where((s37 < 0.0), 0.0, s37))
    s39 = where(s15, (s12 * ((vz + s13) + s14)), (-inf))
    s40 = 0.0 < s37
    s41 = where(s40, (s12 * ((vz + s14) - s38)), s39)
    s42 = where((s36 < s41), s36, s41)
    s43 = where(s35, (((s33 - s21) - s23) * s24), inf)
    s44 = where((s43 < s36), s36, s43)
    s45 = where((s16 < s44), s44, s16)
    s46 = where((s34 < s41), s34, s41)
    s47 = where(s40, (s12 * ((vz + s38) - s14)), inf)
    s48 = where((s47 < s41), s41, s47)
    s49 = s45 <= s46
    s50 = where(s49, s45, where((s48 < s27), s27, s48))
    s51 = where(s49, s46, where((s36 < s39), s36, s39))
    s52 = where((s48 < s44), s44, s48)
    s53 = where((s34 < s39), s34, s39)
    s54 = 1.0 / s31
    s55 = where((0.0 < s42), s42, 0.0)
    s56 = where((s55 < s51), s51, s55)
    s57 = where((s56 < s53), s53, s56)
    s58 = (0.000244140625 * ring_radius) - (ring_radius - s7)
    s59 = ((position_error + (horizon * velocity_error)) - (1.52587890625e-05 * ball_radius)) - (1.52587890625e-05 * wire_radius)
    return s2, s5, sqrt(s6), where((0.0 < s28), s28, 0.0), where((s42 < horizon), s42, horizon), where((0.0 < s50), s50, 0.0), where((s51 < horizon), s51, horizon), where((0.0 < s52), s52, 0.0), where((s53 < horizon), s53, horizon), (((6.0003662109375 * gravity) * s7) + (s5 * (s54 * (s54 * s54)))) + absolute(s2), where((s57 < horizon), s57, horizon), where((s58 < s59), s59, s58)


def ring_margins(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, ball_radius: Any, ring_radius: Any, wire_radius: Any, gravity: Any) -> tuple[Any, ...]:
    """Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.

    running error analysis. 47 operations: 14 additions, 1 subtraction, 27 multiplications, 1 division, 2 comparisons, 2 selections.
    Returns margin, leaving_margin, rate_margin.
    """
    s0 = ball_radius + wire_radius
    s1 = speed + (gravity * horizon)
    s2 = 1.00006103515625 * s0
    s3 = s2 * s1
    s4 = ring_radius + s2
    s5 = extent + (horizon * s1)
    s6 = (position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * s5)
    s7 = ring_radius - s2
    s8 = 0.0001220703125 * ring_radius
    s9 = s2 / where((s7 < s8), s8, s7)
    s10 = where((1.0 < s9), s9, 1.0)
    s11 = 5.0 * (((s1 * s10) * s6) + (s2 * (velocity_error + (2.220446049250313e-16 * s1))))
    s12 = 1.0009765625 * ((((3.552713678800501e-15 * s1) * ((s5 * s10) + s4)) + (4.440892098500626e-16 * s3)) + s11)
    return 1.0009765625 * ((((4.440892098500626e-16 * horizon) * s3) + ((1.3323489447131243e-15 * s0) * s4)) + ((5.00030517578125 * s0) * s6)), s12, 1.0009765625 * ((3.552713678800501e-15 * (s4 * s1)) + s11)


def ring_refine(t: Any, leaving: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, rho_start: Any, ball_radius: Any, ring_radius: Any, wire_radius: Any, gravity: Any) -> tuple[Any, ...]:
    """Newton's next value of a root near t, and the rate there.

    Newton's method. 56 operations: 15 additions, 6 subtractions, 30 multiplications, 2 divisions, 1 square root, 1 comparison, 1 selection.
    Returns time, rate.
    """
    s0 = x + (t * vx)
    s1 = y + (t * vy)
    s2 = sqrt(((s0 * s0) + (s1 * s1)))
    s3 = rho_start + s2
    s4 = 1.0 / (s3 * s2)
    s5 = s2 - ring_radius
    s6 = vz - ((0.5 * gravity) * t)
    s7 = z + (t * s6)
    s8 = 2.0 * ((((s3 * s4) * ((vx * s0) + (vy * s1))) * s5) + ((vz - (gravity * t)) * s7))
    s9 = (((t * ((vx * vx) + (vy * vy))) + (2.0 * ((vx * x) + (vy * y)))) * ((rho_start - ring_radius) + s5)) * (s2 * s4)
    s10 = ball_radius + wire_radius
    s11 = where((0.0 < leaving), (t * (s9 + ((z + s7) * s6))), (((s5 * s5) + (s7 * s7)) - (s10 * s10))) / s8
    return t - s11, s8


def ring_advance(t: Any, end: Any, leaving: Any, margin: Any, rate_margin: Any, ceiling: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, steady: Any, swing: Any, rho_start: Any, ball_radius: Any, ring_radius: Any, wire_radius: Any, gravity: Any) -> tuple[Any, ...]:
    """Gap, rate, bend, a step without a root and its end, Newton's root and its clearance.

    Newton from the left under a curvature bound. 146 operations: 28 additions, 17 subtractions, 55 multiplications, 5 divisions, 2 square roots, 2 negations, 2 absolute values, 16 comparisons, 19 selections.
    Returns gap, rate, bend, step, next, root, clearance.
    """
    s0 = x + (t * vx)
    s1 = y + (t * vy)
    s2 = sqrt(((s0 * s0) + (s1 * s1)))
    s3 = s2 - ring_radius
    s4 = rho_start + s2
    s5 = 1.0 / (s4 * s2)
    s6 = (((t * ((vx * vx) + (vy * vy))) + (2.0 * ((vx * x) + (vy * y)))) * ((rho_start - ring_radius) + s3)) * (s2 * s5)
    s7 = vz - ((0.5 * gravity) * t)
    s8 = z + (t * s7)
    s9 = ball_radius + wire_radius
    s10 = where((0.0 < leaving), (t * (s6 + ((z + s8) * s7))), (((s3 * s3) + (s8 * s8)) - (s9 * s9)))
    s11 = s4 * s5
    s12 = s11 * ((vx * s0) + (vy * s1))
    s13 = vz - (gravity * t)
    s14 = (s12 * s3) + (s13 * s8)
    s15 = 2.0 * s14
    s16 = 6.0 * gravity
    s17 = s16 * s8
    s18 = swing * (s11 * (s11 * s11))
    s19 = 1.00006103515625 * s9
    s20 = s15 - rate_margin
    s21 = s10 - margin
    s22 = where((s21 < 0.0), 0.0, s21)
    s23 = (s17 + s18) - steady
    s24 = s20 < 0.0
    s25 = 2.0 * s22
    s26 = where((0.0 < where((0.0 <= s20), s22, 0.0)), inf, (where(s24, s25, (4.0 * s20)) / where(s24, (-s20), where((0.0 < s23), s23, 0.0))))
    s27 = end - t
    s28 = where((s26 < s27), s26, s27)
    s29 = (s28 * where((s13 < 0.0), 0.0, s13)) + s8
    s30 = s16 * where((s19 < s29), s19, s29)
    s31 = ((s28 * where((0.0 < s12), 0.0, s12)) + s2) - (9.094947017729282e-13 * (ring_radius + s19))
    s32 = ring_radius - s19
    s33 = 0.0001220703125 * ring_radius
    s34 = where((s32 < s33), s33, s32)
    s35 = 1.0 / where((s31 < s34), s34, s31)
    s36 = swing * (s35 * (s35 * s35))
    s37 = ((s30 + s36) + (9.094947017729282e-13 * ((s36 + absolute(steady)) + absolute(s30)))) - steady
    s38 = ((2.0 * s37) * s22) + (s20 * s20)
    s39 = sqrt(s38)
    s40 = where((0.0 <= s38), (where(s24, s25, (s20 + s39)) / where(s24, (s39 - s20), where((0.0 < s37), s37, 0.0))), inf)
    s41 = where((s40 < s28), s40, s28)
    s42 = -(rate_margin + s15)
    return s10, s15, (steady - s17) - s18, s41, t + s41, t - ((0.5 * s10) / s14), where((0.0 < s42), ((s42 * s42) - ((8.0 * ceiling) * (margin + (32.0 * s22)))), s42)


def ring_enter(after: Any, end: Any, high0: Any, high1: Any, high2: Any, low0: Any, low1: Any, low2: Any, t: Any) -> tuple[Any, ...]:
    """The first window that begins no earlier than a time, if there is one.

    Table 1. 18 operations: 6 comparisons, 3 conjunctions, 3 disjunctions, 6 selections.
    Returns t, end, searching.
    """
    s0 = logical_and((low0 < high0), (after <= low0))
    s1 = logical_and((low1 < high1), (after <= low1))
    s2 = logical_and((low2 < high2), (after <= low2))
    return where(s0, low0, where(s1, low1, where(s2, low2, t))), where(s0, high0, where(s1, high1, where(s2, high2, end))), logical_or(logical_or(logical_or(False, s2), s1), s0)


def backboard_coefficients(x: Any, vx: Any, ball_radius: Any, board_distance: Any) -> tuple[Any, ...]:
    """Coefficients in time of the event polynomial, constant first.

    Eq. 3 in Table 2. 2 operations: 2 subtractions.
    Returns c0, c1.
    """
    return x - (ball_radius - board_distance), vx


def backboard_deflated(vx: Any) -> tuple[Any, ...]:
    """Coefficients of the event polynomial over t, after a contact at t = 0.

    Eq. 3 in Table 2, the exact root divided out. No operations.
    Returns c0.
    """
    return vx,


def backboard_normal() -> tuple[Any, ...]:
    """Outward unit normal n3 at a contact.

    Table 2. No operations.
    Returns nx, ny, nz.
    """
    return 1.0, 0.0, 0.0


def backboard_curvature() -> tuple[Any, ...]:
    """Bound on the rate at which the normal turns along the contact surface.

    Table 2. No operations.
    Returns curvature.
    """
    return 0.0,


def backboard_bounds(y: Any, z: Any, board_half_width: Any, board_bottom: Any, board_top: Any) -> tuple[Any, ...]:
    """The g of Eq. 2: a contact counts where none is positive.

    Eq. 2, Table 2. 5 operations: 1 addition, 3 subtractions, 1 negation.
    Returns g0, g1, g2, g3.
    """
    return -(board_half_width + y), y - board_half_width, board_bottom - z, z - board_top


def backboard_arrival(leaving: Any, x: Any, vx: Any, ball_radius: Any, board_distance: Any) -> tuple[Any, ...]:
    """Time of the only arrival, the gap's rate there and its bend.

    Eq. 3 in Table 2, solved. 9 operations: 2 subtractions, 1 division, 1 negation, 1 absolute value, 2 comparisons, 2 selections.
    Returns time, rate, bend, apex, height.
    """
    s0 = where((0.0 < leaving), 0.0, (x - (ball_radius - board_distance)))
    return -(s0 / vx), vx, 0.0, where((absolute(vx) <= 0.0), 0.0, -1.0), s0


def backboard_margin(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, ball_radius: Any, board_distance: Any, gravity: Any) -> tuple[Any, ...]:
    """Rounding-error bound of the gap up to the horizon.

    running error analysis. 15 operations: 7 additions, 8 multiplications.
    Returns margin.
    """
    s0 = extent + (horizon * (speed + (gravity * horizon)))
    return (((6.667843360785852e-16 * ball_radius) + (8.890457814381136e-16 * board_distance)) + (2.222614453595284e-16 * s0)) + (2.001953125 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * s0))),


def backboard_place(y: Any, z: Any, ball_radius: Any, board_distance: Any) -> tuple[Any, ...]:
    """The point of the contact plane nearest to a position.

    Table 2. 1 operation: 1 subtraction.
    Returns x, y, z.
    """
    return ball_radius - board_distance, y, z


def backboard_within(g0: Any, g1: Any, g2: Any, g3: Any) -> tuple[Any, ...]:
    """Where a contact counts (Eq. 2).

    Table 1. 7 operations: 4 comparisons, 3 conjunctions.
    Returns arrives.
    """
    return logical_and(logical_and(logical_and((g0 <= 0.0), (g1 <= 0.0)), (g2 <= 0.0)), (g3 <= 0.0)),


def backboard_edges(clearance: Any, g0: Any, g1: Any, g2: Any, g3: Any, slack: Any) -> tuple[Any, ...]:
    """Where that, or the crossing, lies within its error.

    Table 1. 19 operations: 1 negation, 9 comparisons, 8 conjunctions, 1 complement.
    Returns unsure.
    """
    s0 = -slack
    s1 = logical_not(logical_and(logical_and(logical_and(logical_and((g0 < s0), (g1 < s0)), (g2 < s0)), (g3 < s0)), (0.0 < clearance)))
    return logical_and(logical_and(logical_and(logical_and((g0 <= slack), (g1 <= slack)), (g2 <= slack)), (g3 <= slack)), s1),


def bridge_coefficients(z: Any, vz: Any, ball_radius: Any, wire_radius: Any, gravity: Any) -> tuple[Any, ...]:
    """Coefficients in time of the event polynomial, constant first.

    Eq. 3 in Table 2. 4 operations: 1 addition, 1 subtraction, 1 multiplication, 1 negation.
    Returns c0, c1, c2.
    """
    return z - (ball_radius + wire_radius), vz, -(0.5 * gravity)


def bridge_deflated(vz: Any, gravity: Any) -> tuple[Any, ...]:
    """Coefficients of the event polynomial over t, after a contact at t = 0.

    Eq. 3 in Table 2, the exact root divided out. 2 operations: 1 multiplication, 1 negation.
    Returns c0, c1.
    """
    return vz, -(0.5 * gravity)


def bridge_normal() -> tuple[Any, ...]:
    """Outward unit normal n3 at a contact.

    Table 2. No operations.
    Returns nx, ny, nz.
    """
    return 0.0, 0.0, 1.0


def bridge_curvature() -> tuple[Any, ...]:
    """Bound on the rate at which the normal turns along the contact surface.

    Table 2. No operations.
    Returns curvature.
    """
    return 0.0,


def bridge_bounds(x: Any, y: Any, ring_radius: Any, board_distance: Any, bridge_half_width: Any) -> tuple[Any, ...]:
    """The g of Eq. 2: a contact counts where none is positive.

    Eq. 2, Table 2. 10 operations: 3 additions, 2 subtractions, 2 multiplications, 1 square root, 2 negations.
    Returns g0, g1, g2, g3, g4.
    """
    return -(bridge_half_width + y), y - bridge_half_width, ring_radius - sqrt(((x * x) + (y * y))), x, -(board_distance + x)


def bridge_arrival(leaving: Any, z: Any, vz: Any, ball_radius: Any, wire_radius: Any, gravity: Any) -> tuple[Any, ...]:
    """Time of the only arrival, the gap's rate there and its bend.

    Eq. 3 in Table 2, solved. 25 operations: 3 additions, 2 subtractions, 7 multiplications, 2 divisions, 1 square root, 5 negations, 2 comparisons, 3 selections.
    Returns time, rate, bend, apex, height.
    """
    s0 = where((0.0 < leaving), 0.0, (z - (ball_radius + wire_radius)))
    s1 = (vz * vz) + ((2.0 * gravity) * s0)
    s2 = sqrt(s1)
    s3 = vz < 0.0
    s4 = -(1.0 / gravity)
    return where(s3, (2.0 * s0), (vz + s2)) / where(s3, (s2 - vz), gravity), -s2, -gravity, -(vz * s4), -((0.5 * s4) * s1)


def bridge_margin(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, ball_radius: Any, wire_radius: Any, gravity: Any) -> tuple[Any, ...]:
    """Rounding-error bound of the gap up to the horizon.

    running error analysis. 15 operations: 7 additions, 8 multiplications.
    Returns margin.
    """
    s0 = extent + (horizon * (speed + (gravity * horizon)))
    return (((6.667843360785852e-16 * ball_radius) + (6.667843360785852e-16 * wire_radius)) + (2.222614453595284e-16 * s0)) + (2.001953125 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * s0))),


def bridge_place(x: Any, y: Any, ball_radius: Any, wire_radius: Any) -> tuple[Any, ...]:
    """The point of the contact plane nearest to a position.

    Table 2. 1 operation: 1 addition.
    Returns x, y, z.
    """
    return x, y, ball_radius + wire_radius


def bridge_within(g0: Any, g1: Any, g2: Any, g3: Any, g4: Any) -> tuple[Any, ...]:
    """Where a contact counts (Eq. 2).

    Table 1. 9 operations: 5 comparisons, 4 conjunctions.
    Returns arrives.
    """
    return logical_and(logical_and(logical_and(logical_and((g0 <= 0.0), (g1 <= 0.0)), (g2 <= 0.0)), (g3 <= 0.0)), (g4 <= 0.0)),


def bridge_edges(clearance: Any, g0: Any, g1: Any, g2: Any, g3: Any, g4: Any, slack: Any) -> tuple[Any, ...]:
    """Where that, or the crossing, lies within its error.

    Table 1. 23 operations: 1 negation, 11 comparisons, 10 conjunctions, 1 complement.
    Returns unsure.
    """
    s0 = -slack
    s1 = logical_and(logical_and(logical_and(logical_and(logical_and((g0 < s0), (g1 < s0)), (g2 < s0)), (g3 < s0)), (g4 < s0)), (0.0 < clearance))
    s2 = logical_and(logical_and(logical_and(logical_and(logical_and((g0 <= slack), (g1 <= slack)), (g2 <= slack)), (g3 <= slack)), (g4 <= slack)), logical_not(s1))
    return s2,


def end_coefficients(z: Any, vz: Any, gravity: Any, end_depth: Any) -> tuple[Any, ...]:
    """Coefficients in time of the event polynomial, constant first.

    Eq. 3 in Table 2. 4 operations: 1 subtraction, 1 multiplication, 2 negations.
    Returns c0, c1, c2.
    """
    return z - (-end_depth), vz, -(0.5 * gravity)


def end_deflated(vz: Any, gravity: Any) -> tuple[Any, ...]:
    """Coefficients of the event polynomial over t, after a contact at t = 0.

    Eq. 3 in Table 2, the exact root divided out. 2 operations: 1 multiplication, 1 negation.
    Returns c0, c1.
    """
    return vz, -(0.5 * gravity)


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


def end_arrival(leaving: Any, z: Any, vz: Any, gravity: Any, end_depth: Any) -> tuple[Any, ...]:
    """Time of the only arrival, the gap's rate there and its bend.

    Eq. 3 in Table 2, solved. 25 operations: 2 additions, 2 subtractions, 7 multiplications, 2 divisions, 1 square root, 6 negations, 2 comparisons, 3 selections.
    Returns time, rate, bend, apex, height.
    """
    s0 = where((0.0 < leaving), 0.0, (z - (-end_depth)))
    s1 = (vz * vz) + ((2.0 * gravity) * s0)
    s2 = sqrt(s1)
    s3 = vz < 0.0
    s4 = -(1.0 / gravity)
    return where(s3, (2.0 * s0), (vz + s2)) / where(s3, (s2 - vz), gravity), -s2, -gravity, -(vz * s4), -((0.5 * s4) * s1)


def end_margin(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, gravity: Any, end_depth: Any) -> tuple[Any, ...]:
    """Rounding-error bound of the gap up to the horizon.

    running error analysis. 13 operations: 6 additions, 7 multiplications.
    Returns margin.
    """
    s0 = extent + (horizon * (speed + (gravity * horizon)))
    return ((6.667843360785852e-16 * end_depth) + (2.222614453595284e-16 * s0)) + (2.001953125 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * s0))),


def end_place(x: Any, y: Any, end_depth: Any) -> tuple[Any, ...]:
    """The point of the contact plane nearest to a position.

    Table 2. 1 operation: 1 negation.
    Returns x, y, z.
    """
    return x, y, -end_depth


def aimed_speed(slope: Any, reach: Any, rise: Any, gravity: Any) -> tuple[Any, ...]:
    """Speed of the flight that goes through a point with a slope of release.

    Eq. 3 without its time, solved for the speed. 9 operations: 1 addition, 1 subtraction, 5 multiplications, 1 division, 1 square root.
    Returns speed.
    """
    s0 = reach * sqrt((((0.5 * gravity) * (1.0 + (slope * slope))) / ((reach * slope) - rise)))
    return s0,


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


def least_speed(reach: Any, rise: Any, gravity: Any) -> tuple[Any, ...]:
    """Slope and speed of the slowest release through a point.

    Eq. 3 without its time, least speed: at 45° + atan(rise/reach)/2, v² = g (rise + distance). 14 operations: 2 additions, 1 subtraction, 3 multiplications, 3 divisions, 2 square roots, 1 comparison, 2 selections.
    Returns slope, speed.
    """
    s0 = reach * reach
    s1 = sqrt((s0 + (rise * rise)))
    s2 = s1 - rise
    s3 = rise + s1
    s4 = rise < 0.0
    return where(s4, (reach / s2), (s3 / reach)), sqrt((gravity * where(s4, (s0 / s2), s3)))


def slopes_of_speed(release_speed: Any, reach: Any, rise: Any, gravity: Any) -> tuple[Any, ...]:
    """The low and the high slope of release through a point at a speed.

    Eq. 3 without its time, solved for the slope. 25 operations: 5 additions, 2 subtractions, 11 multiplications, 3 divisions, 2 square roots, 1 comparison, 1 selection.
    Returns low, high.
    """
    s0 = release_speed * release_speed
    s1 = reach * reach
    s2 = sqrt((s1 + (rise * rise)))
    s3 = s2 - rise
    s4 = sqrt((((gravity * s3) + s0) * (s0 - (gravity * where((rise < 0.0), (s1 / s3), (rise + s2))))))
    s5 = s0 + s4
    s6 = gravity * reach
    return ((reach * s6) + ((2.0 * rise) * s0)) / (reach * s5), s5 / s6


def descent(z: Any, vz: Any, level: Any, gravity: Any) -> tuple[Any, ...]:
    """When the centre comes down to a height, and its upward velocity then.

    Eq. 3, solved. 14 operations: 2 additions, 2 subtractions, 4 multiplications, 1 division, 1 square root, 1 negation, 1 comparison, 2 selections.
    Returns time, vz.
    """
    s0 = z - level
    s1 = sqrt(((vz * vz) + ((2.0 * gravity) * s0)))
    s2 = vz < 0.0
    return where(s2, (2.0 * s0), (vz + s1)) / where(s2, (s1 - vz), gravity), -s1


def apex(z: Any, vz: Any, gravity: Any) -> tuple[Any, ...]:
    """When the centre is highest, and its height then.

    Eq. 3, its derivative zero. 8 operations: 1 addition, 2 multiplications, 2 divisions, 1 comparison, 2 selections.
    Returns time, height.
    """
    s0 = 0.0 < vz
    return where(s0, (vz / gravity), 0.0), where(s0, (z + ((0.5 * (vz * vz)) / gravity)), z)


def sighted(x: Any, y: Any, place_x: Any, place_y: Any) -> tuple[Any, ...]:
    """How far a point is past the ring's centre and to the left, seen from a place.

    components along and across the line of sight. 13 operations: 2 additions, 1 subtraction, 6 multiplications, 2 divisions, 1 square root, 1 negation.
    Returns past, left.
    """
    s0 = sqrt(((place_x * place_x) + (place_y * place_y)))
    return -(((place_x * x) + (place_y * y)) / s0), ((place_y * x) - (place_x * y)) / s0


def ring_nearness(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, half: Any, ball_radius: Any, ring_radius: Any, wire_radius: Any, gravity: Any) -> tuple[Any, ...]:
    """Distance of ball and wire at time t, and what bounds it within half a width of t.

    Eq. 3 in Table 2, Taylor's theorem. 153 operations: 35 additions, 15 subtractions, 58 multiplications, 4 divisions, 6 square roots, 2 negations, 7 absolute values, 13 comparisons, 13 selections.
    Returns gap, rate, lower, concavity, resolution.
    """
    s0 = x + (t * vx)
    s1 = y + (t * vy)
    s2 = sqrt(((s0 * s0) + (s1 * s1)))
    s3 = s2 - ring_radius
    s4 = 0.5 * gravity
    s5 = z + (t * (vz - (s4 * t)))
    s6 = (s3 * s3) + (s5 * s5)
    s7 = ball_radius + wire_radius
    s8 = 2.0 * (((((vx * s0) + (vy * s1)) / s2) * s3) + ((vz - (gravity * t)) * s5))
    s9 = t - half
    s10 = (vx * vx) + (vy * vy)
    s11 = -(((vx * x) + (vy * y)) / s10)
    s12 = half + t
    s13 = where((s11 < s12), s11, s12)
    s14 = where((s9 < s13), s13, s9)
    s15 = x + (vx * s14)
    s16 = y + (vy * s14)
    s17 = sqrt(((s15 * s15) + (s16 * s16)))
    s18 = s17 - ring_radius
    s19 = where((0.0 < s18), s18, 0.0)
    s20 = x + (vx * s9)
    s21 = y + (vy * s9)
    s22 = sqrt(((s20 * s20) + (s21 * s21)))
    s23 = x + (vx * s12)
    s24 = y + (vy * s12)
    s25 = sqrt(((s23 * s23) + (s24 * s24)))
    s26 = ring_radius - where((s22 < s25), s25, s22)
    s27 = where((s19 < s26), s26, s19)
    s28 = z + ((vz - (s4 * s12)) * s12)
    s29 = z + ((vz - (s4 * s9)) * s9)
    s30 = where((s28 < s29), s28, s29)
    s31 = where((0.0 < s30), s30, 0.0)
    s32 = vz / gravity
    s33 = where((s32 < s12), s32, s12)
    s34 = where((s9 < s33), s33, s9)
    s35 = z + ((vz - (s4 * s34)) * s34)
    s36 = -s35
    s37 = where((s31 < s36), s36, s31)
    s38 = (s27 * s27) + (s37 * s37)
    s39 = (s12 * ((((gravity * s12) + absolute(vx)) + absolute(vy)) + absolute(vz))) + absolute(x)
    s40 = 7.105427357601002e-15 * (ring_radius + ((s39 + absolute(y)) + absolute(z)))
    s41 = s17 - s40
    s42 = (vy * x) - (vx * y)
    s43 = (((2.0 * ring_radius) * (s42 * s42)) / (s41 * (s41 * s41))) + (((6.0 * gravity) * s35) - (2.0 * (((2.0 * gravity) * z) + ((vz * vz) + s10))))
    s44 = where((0.0 < s41), s43, inf)
    s45 = s6 - (half * (((0.5 * half) * where((0.0 < s44), s44, 0.0)) + absolute(s8)))
    return sqrt(s6) - s7, s8, sqrt(where((s38 < s45), s45, s38)) - s7, s44, s40


# The event loop, one function for each stage: it reads and writes the columns of the shots.


def _rows(truth: Any, shots: int) -> tuple[Any, int]:
    """Return the rows where a truth holds, None if that is all of them, and how many they are."""
    if ndim(truth) == 0:
        return (None, shots) if truth else (flatnonzero(()), 0)
    rows = flatnonzero(truth)
    return (None if len(rows) == shots else rows), len(rows)


def _take(values: Any, rows: Any) -> Any:
    """Return some rows of a column; what all shots share stays."""
    return values if rows is None or ndim(values) == 0 else values[rows]


def _of(rows: Any, some: Any) -> Any:
    """Return some of the rows."""
    return some if rows is None else rows[some]


def _copy(values: Any, shots: int) -> Any:
    """Return a column of one's own."""
    return broadcast_to(values, (shots,)).copy()


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


def permit_plain(columns: dict[str, Any], shots: int) -> None:
    """Stage permit of the event loop, the path alone."""
    ball_radius = columns["ball_radius"]
    board_bottom = columns["board_bottom"]
    board_distance = columns["board_distance"]
    board_half_width = columns["board_half_width"]
    board_top = columns["board_top"]
    bridge_half_width = columns["bridge_half_width"]
    end_depth = columns["end_depth"]
    gravity = columns["gravity"]
    restitution = columns["restitution"]
    ring_radius = columns["ring_radius"]
    wire_radius = columns["wire_radius"]
    allowed_0, = allowed(ball_radius, ring_radius, wire_radius, board_distance, board_half_width, bridge_half_width, restitution, gravity, end_depth)
    permitted_0, = finite_parameters(ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, restitution, gravity, end_depth, allowed_0)
    columns["permitted"] = permitted_0


def admit_plain(columns: dict[str, Any], shots: int) -> None:
    """Stage admit of the event loop, the path alone."""
    ball_radius = columns["ball_radius"]
    board_bottom = columns["board_bottom"]
    board_distance = columns["board_distance"]
    board_half_width = columns["board_half_width"]
    board_top = columns["board_top"]
    bridge_half_width = columns["bridge_half_width"]
    end_depth = columns["end_depth"]
    last = columns["last"]
    permitted = columns["permitted"]
    ring_radius = columns["ring_radius"]
    vx = columns["vx"]
    vy = columns["vy"]
    vz = columns["vz"]
    wire_radius = columns["wire_radius"]
    wx = columns["wx"]
    wy = columns["wy"]
    wz = columns["wz"]
    x = columns["x"]
    y = columns["y"]
    z = columns["z"]
    finite_0, = finite_state(vx, vy, vz, wx, wy, wz, x, y, z)
    valid_0, *_ = valid(last, x, y, z, ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, end_depth)
    outcome_0, *_ = admitted(inf, finite_0, permitted, valid_0)
    columns["outcome"] = outcome_0


def reach_plain(columns: dict[str, Any], shots: int) -> None:
    """Stage reach of the event loop, the path alone."""
    ball_radius = columns["ball_radius"]
    board_bottom = columns["board_bottom"]
    board_distance = columns["board_distance"]
    board_half_width = columns["board_half_width"]
    board_top = columns["board_top"]
    bridge_half_width = columns["bridge_half_width"]
    clock = columns["clock"]
    contacts = columns["contacts"]
    end_depth = columns["end_depth"]
    gravity = columns["gravity"]
    last = columns["last"]
    most_contacts = columns["most_contacts"]
    ring_radius = columns["ring_radius"]
    vx = columns["vx"]
    vy = columns["vy"]
    vz = columns["vz"]
    wire_radius = columns["wire_radius"]
    x = columns["x"]
    y = columns["y"]
    z = columns["z"]
    extent_0, speed_0, excess_0 = scale(x, y, z, vx, vy, vz, gravity)
    when_0, which_0, *_ = opening(excess_0, 0.0, 0.0)
    leaving_0, = left(3.0, last)
    time_0, rate_0, bend_0, *_ = end_arrival(leaving_0, z, vz, gravity, end_depth)
    arrives_0, *_ = meeting_plane(bend_0, rate_0, time_0)
    possible_0, = timely(arrives_0, 0.0, 0.0, time_0, when_0)
    when_1, which_1 = sooner(arrives_0, 3.0, time_0, when_0, which_0)
    when_0 = where(possible_0, when_1, when_0)
    which_0 = where(possible_0, which_1, which_0)
    leaving_0, = left(1.0, last)
    time_0, rate_0, bend_0, *_ = backboard_arrival(leaving_0, x, vx, ball_radius, board_distance)
    arrives_0, *_ = meeting_plane(bend_0, rate_0, time_0)
    possible_0, = timely(arrives_0, 0.0, 0.0, time_0, when_0)
    _, there_y_1, there_z_1, *_ = flight(time_0, x, y, z, vx, vy, vz, gravity)
    g0_1, g1_1, g2_1, g3_1 = backboard_bounds(there_y_1, there_z_1, board_half_width, board_bottom, board_top)
    arrives_1, = backboard_within(g0_1, g1_1, g2_1, g3_1)
    when_1, which_1 = sooner(arrives_1, 1.0, time_0, when_0, which_0)
    when_0 = where(possible_0, when_1, when_0)
    which_0 = where(possible_0, which_1, which_0)
    leaving_0, = left(2.0, last)
    time_0, rate_0, bend_0, *_ = bridge_arrival(leaving_0, z, vz, ball_radius, wire_radius, gravity)
    arrives_0, *_ = meeting_plane(bend_0, rate_0, time_0)
    possible_0, = timely(arrives_0, 0.0, 0.0, time_0, when_0)
    rows1, count2 = _rows(possible_0, shots)
    if count2:
        board_distance_1 = _take(board_distance, rows1)
        bridge_half_width_1 = _take(bridge_half_width, rows1)
        gravity_1 = _take(gravity, rows1)
        ring_radius_1 = _take(ring_radius, rows1)
        time_1 = _take(time_0, rows1)
        vx_1 = _take(vx, rows1)
        vy_1 = _take(vy, rows1)
        vz_1 = _take(vz, rows1)
        when_1 = _take(when_0, rows1)
        which_1 = _take(which_0, rows1)
        x_1 = _take(x, rows1)
        y_1 = _take(y, rows1)
        z_1 = _take(z, rows1)
        there_x_1, there_y_1, *_ = flight(time_1, x_1, y_1, z_1, vx_1, vy_1, vz_1, gravity_1)
        g0_1, g1_1, g2_1, g3_1, g4_1 = bridge_bounds(there_x_1, there_y_1, ring_radius_1, board_distance_1, bridge_half_width_1)
        arrives_1, = bridge_within(g0_1, g1_1, g2_1, g3_1, g4_1)
        when_1, which_1 = sooner(arrives_1, 2.0, time_1, when_1, which_1)
        when_0 = _put(when_0, rows1, when_1, shots)
        which_0 = _put(which_0, rows1, which_1, shots)
    until_0, *_ = horizon(when_0, speed_0, gravity)
    clear_0, = ring_clear(until_0, x, y, z, vx, vy, vz, extent_0, speed_0, 0.0, 0.0, ball_radius, ring_radius, wire_radius, gravity)
    open_0, = opens(clear_0)
    rows3, count4 = _rows(open_0, shots)
    if count4:
        ball_radius_1 = _take(ball_radius, rows3)
        extent_1 = _take(extent_0, rows3)
        gravity_1 = _take(gravity, rows3)
        last_1 = _take(last, rows3)
        ring_radius_1 = _take(ring_radius, rows3)
        speed_1 = _take(speed_0, rows3)
        until_1 = _take(until_0, rows3)
        vx_1 = _take(vx, rows3)
        vy_1 = _take(vy, rows3)
        vz_1 = _take(vz, rows3)
        when_1 = _take(when_0, rows3)
        which_1 = _take(which_0, rows3)
        wire_radius_1 = _take(wire_radius, rows3)
        x_1 = _take(x, rows3)
        y_1 = _take(y, rows3)
        z_1 = _take(z, rows3)
        steady_1, swing_1, rho_start_1, low0_1, high0_1, low1_1, high1_1, low2_1, high2_1, ceiling_1, latest_1, *_ = ring_prepare(until_1, x_1, y_1, z_1, vx_1, vy_1, vz_1, 0.0, 0.0, ball_radius_1, ring_radius_1, wire_radius_1, gravity_1)
        share_1, arrival_1, certain_1 = beginning()
        level_1, velocity_level_1, *_ = allowance(share_1, latest_1, extent_1, speed_1, 0.0, 0.0, gravity_1)
        flat_1, tilt_1, rate_slack_1 = ring_margins(latest_1, extent_1, speed_1, level_1, velocity_level_1, ball_radius_1, ring_radius_1, wire_radius_1, gravity_1)
        t_1, end_1, searching_1 = ring_enter(0.0, 0.0, high0_1, high1_1, high2_1, low0_1, low1_1, low2_1, 0.0)
        rows5, count6 = _rows(searching_1, count4)
        if count6:
            arrival_2 = _take(arrival_1, rows5)
            ball_radius_2 = _take(ball_radius_1, rows5)
            ceiling_2 = _take(ceiling_1, rows5)
            certain_2 = _take(certain_1, rows5)
            end_2 = _take(end_1, rows5)
            extent_2 = _take(extent_1, rows5)
            flat_2 = _take(flat_1, rows5)
            gravity_2 = _take(gravity_1, rows5)
            high0_2 = _take(high0_1, rows5)
            high1_2 = _take(high1_1, rows5)
            high2_2 = _take(high2_1, rows5)
            last_2 = _take(last_1, rows5)
            latest_2 = _take(latest_1, rows5)
            low0_2 = _take(low0_1, rows5)
            low1_2 = _take(low1_1, rows5)
            low2_2 = _take(low2_1, rows5)
            rate_slack_2 = _take(rate_slack_1, rows5)
            rho_start_2 = _take(rho_start_1, rows5)
            ring_radius_2 = _take(ring_radius_1, rows5)
            searching_2 = _take(searching_1, rows5)
            share_2 = _take(share_1, rows5)
            speed_2 = _take(speed_1, rows5)
            steady_2 = _take(steady_1, rows5)
            swing_2 = _take(swing_1, rows5)
            t_2 = _take(t_1, rows5)
            tilt_2 = _take(tilt_1, rows5)
            vx_2 = _take(vx_1, rows5)
            vy_2 = _take(vy_1, rows5)
            vz_2 = _take(vz_1, rows5)
            wire_radius_2 = _take(wire_radius_1, rows5)
            x_2 = _take(x_1, rows5)
            y_2 = _take(y_1, rows5)
            z_2 = _take(z_1, rows5)
            arrival_1 = _copy(arrival_1, count4)
            certain_1 = _copy(certain_1, count4)
            flat_1 = _copy(flat_1, count4)
            tilt_1 = _copy(tilt_1, count4)
            for _ in range(201):
                leaving_2, margin_2 = nearby(flat_2, 0.0, last_2, t_2, tilt_2)
                gap_2, rate_2, bend_2, step_2, next_2, root_2, clearance_2 = ring_advance(t_2, end_2, leaving_2, margin_2, rate_slack_2, ceiling_2, x_2, y_2, z_2, vx_2, vy_2, vz_2, steady_2, swing_2, rho_start_2, ball_radius_2, ring_radius_2, wire_radius_2, gravity_2)
                hit_2, sure_2, vague_2 = struck(bend_2, clearance_2, gap_2, margin_2, rate_2, rate_slack_2, share_2)
                rows7, count8 = _rows(vague_2, count6)
                if count8:
                    ball_radius_3 = _take(ball_radius_2, rows7)
                    extent_3 = _take(extent_2, rows7)
                    gravity_3 = _take(gravity_2, rows7)
                    latest_3 = _take(latest_2, rows7)
                    ring_radius_3 = _take(ring_radius_2, rows7)
                    share_3 = _take(share_2, rows7)
                    speed_3 = _take(speed_2, rows7)
                    wire_radius_3 = _take(wire_radius_2, rows7)
                    share_3, = finer(share_3)
                    level_3, velocity_level_3, *_ = allowance(share_3, latest_3, extent_3, speed_3, 0.0, 0.0, gravity_3)
                    flat_3, tilt_3, rate_slack_3 = ring_margins(latest_3, extent_3, speed_3, level_3, velocity_level_3, ball_radius_3, ring_radius_3, wire_radius_3, gravity_3)
                    flat_2 = _put(flat_2, rows7, flat_3, count6)
                    rate_slack_2 = _put(rate_slack_2, rows7, rate_slack_3, count6)
                    share_2 = _put(share_2, rows7, share_3, count6)
                    tilt_2 = _put(tilt_2, rows7, tilt_3, count6)
                arrival_2, certain_2, exhausted_2, searching_2, t_2 = advanced(arrival_2, certain_2, end_2, hit_2, next_2, root_2, step_2, sure_2, t_2, vague_2)
                t_3, end_3, searching_3 = ring_enter(end_2, end_2, high0_2, high1_2, high2_2, low0_2, low1_2, low2_2, t_2)
                end_2 = where(exhausted_2, end_3, end_2)
                searching_2 = where(exhausted_2, searching_3, searching_2)
                t_2 = where(exhausted_2, t_3, t_2)
                going9 = flatnonzero(searching_2)
                if len(going9) == count6:
                    continue
                done = flatnonzero(logical_not(searching_2))
                _store(arrival_1, _of(rows5, done), arrival_2, done)
                _store(certain_1, _of(rows5, done), certain_2, done)
                _store(flat_1, _of(rows5, done), flat_2, done)
                _store(tilt_1, _of(rows5, done), tilt_2, done)
                rows5, count6 = _of(rows5, going9), len(going9)
                if not count6:
                    break
                arrival_2 = _take(arrival_2, going9)
                ball_radius_2 = _take(ball_radius_2, going9)
                ceiling_2 = _take(ceiling_2, going9)
                certain_2 = _take(certain_2, going9)
                end_2 = _take(end_2, going9)
                extent_2 = _take(extent_2, going9)
                flat_2 = _take(flat_2, going9)
                gravity_2 = _take(gravity_2, going9)
                high0_2 = _take(high0_2, going9)
                high1_2 = _take(high1_2, going9)
                high2_2 = _take(high2_2, going9)
                last_2 = _take(last_2, going9)
                latest_2 = _take(latest_2, going9)
                low0_2 = _take(low0_2, going9)
                low1_2 = _take(low1_2, going9)
                low2_2 = _take(low2_2, going9)
                rate_slack_2 = _take(rate_slack_2, going9)
                rho_start_2 = _take(rho_start_2, going9)
                ring_radius_2 = _take(ring_radius_2, going9)
                searching_2 = _take(searching_2, going9)
                share_2 = _take(share_2, going9)
                speed_2 = _take(speed_2, going9)
                steady_2 = _take(steady_2, going9)
                swing_2 = _take(swing_2, going9)
                t_2 = _take(t_2, going9)
                tilt_2 = _take(tilt_2, going9)
                vx_2 = _take(vx_2, going9)
                vy_2 = _take(vy_2, going9)
                vz_2 = _take(vz_2, going9)
                wire_radius_2 = _take(wire_radius_2, going9)
                x_2 = _take(x_2, going9)
                y_2 = _take(y_2, going9)
                z_2 = _take(z_2, going9)
            else:
                _store(arrival_1, rows5, arrival_2, None)
                _store(certain_1, rows5, certain_2, None)
                _store(flat_1, rows5, flat_2, None)
                _store(tilt_1, rows5, tilt_2, None)
        arrives_1, = found(arrival_1)
        leaving_1, *_ = nearby(flat_1, 0.0, last_1, arrival_1, tilt_1)
        refined_1, *_ = ring_refine(arrival_1, leaving_1, x_1, y_1, z_1, vx_1, vy_1, vz_1, rho_start_1, ball_radius_1, ring_radius_1, wire_radius_1, gravity_1)
        arrival_1, = polished(arrival_1, certain_1, refined_1)
        refined_1, *_ = ring_refine(arrival_1, leaving_1, x_1, y_1, z_1, vx_1, vy_1, vz_1, rho_start_1, ball_radius_1, ring_radius_1, wire_radius_1, gravity_1)
        arrival_1, = polished(arrival_1, certain_1, refined_1)
        time_1, = landed(arrival_1)
        when_1, which_1 = sooner(arrives_1, 0.0, time_1, when_1, which_1)
        when_0 = _put(when_0, rows3, when_1, shots)
        which_0 = _put(which_0, rows3, which_1, shots)
    _, moves_0, ends_0, touches_0 = departed(3.0, which_0)
    body_0, = body_of(which_0)
    x_1, y_1, z_1, vx_1, vy_1, vz_1 = flight(when_0, x, y, z, vx, vy, vz, gravity)
    clock_1, = ticked(clock, when_0)
    clock_0 = where(moves_0, clock_1, clock)
    vx_0 = where(moves_0, vx_1, vx)
    vy_0 = where(moves_0, vy_1, vy)
    vz_0 = where(moves_0, vz_1, vz)
    x_0 = where(moves_0, x_1, x)
    y_0 = where(moves_0, y_1, y)
    z_0 = where(moves_0, z_1, z)
    miss_0, = target(x_0, y_0, ring_radius)
    contacts_0, outcome_0 = accounted(contacts, ends_0, miss_0, most_contacts, touches_0)
    columns["body"] = body_0
    columns["clock"] = clock_0
    columns["contacts"] = contacts_0
    columns["ends"] = ends_0
    columns["outcome"] = outcome_0
    columns["touches"] = touches_0
    columns["vx"] = vx_0
    columns["vy"] = vy_0
    columns["vz"] = vz_0
    columns["which"] = which_0
    columns["x"] = x_0
    columns["y"] = y_0
    columns["z"] = z_0


def meet_plain(columns: dict[str, Any], shots: int) -> None:
    """Stage meet of the event loop, the path alone."""
    ball_radius = columns["ball_radius"]
    board_distance = columns["board_distance"]
    body = columns["body"]
    count_0 = columns["count_0"]
    count_1 = columns["count_1"]
    count_2 = columns["count_2"]
    ends = columns["ends"]
    first = columns["first"]
    last = columns["last"]
    restitution = columns["restitution"]
    ring_radius = columns["ring_radius"]
    touches = columns["touches"]
    vx = columns["vx"]
    vy = columns["vy"]
    vz = columns["vz"]
    which = columns["which"]
    wire_radius = columns["wire_radius"]
    wx = columns["wx"]
    wy = columns["wy"]
    wz = columns["wz"]
    x = columns["x"]
    y = columns["y"]
    z = columns["z"]
    meeting_0, = meeting(0.0, ends, touches)
    rows1, count2 = _rows(meeting_0, shots)
    if count2:
        ball_radius_1 = _take(ball_radius, rows1)
        board_distance_1 = _take(board_distance, rows1)
        body_1 = _take(body, rows1)
        count_0_1 = _take(count_0, rows1)
        count_1_1 = _take(count_1, rows1)
        count_2_1 = _take(count_2, rows1)
        first_1 = _take(first, rows1)
        last_1 = _take(last, rows1)
        restitution_1 = _take(restitution, rows1)
        ring_radius_1 = _take(ring_radius, rows1)
        touches_1 = _take(touches, rows1)
        vx_1 = _take(vx, rows1)
        vy_1 = _take(vy, rows1)
        vz_1 = _take(vz, rows1)
        which_1 = _take(which, rows1)
        wire_radius_1 = _take(wire_radius, rows1)
        wx_1 = _take(wx, rows1)
        wy_1 = _take(wy, rows1)
        wz_1 = _take(wz, rows1)
        x_1 = _take(x, rows1)
        y_1 = _take(y, rows1)
        z_1 = _take(z, rows1)
        nx_1, ny_1, nz_1 = end_normal()
        here_1, = here(0.0, which_1)
        nx_2, ny_2, nz_2 = ring_normal(x_1, y_1, z_1, ball_radius_1, ring_radius_1, wire_radius_1)
        count_0_2, = counted(count_0_1)
        count_0_1 = where(here_1, count_0_2, count_0_1)
        nx_1 = where(here_1, nx_2, nx_1)
        ny_1 = where(here_1, ny_2, ny_1)
        nz_1 = where(here_1, nz_2, nz_1)
        here_1, = here(1.0, which_1)
        nx_2, ny_2, nz_2 = backboard_normal()
        count_1_2, = counted(count_1_1)
        count_1_1 = where(here_1, count_1_2, count_1_1)
        nx_1 = where(here_1, nx_2, nx_1)
        ny_1 = where(here_1, ny_2, ny_1)
        nz_1 = where(here_1, nz_2, nz_1)
        here_1, = here(2.0, which_1)
        nx_2, ny_2, nz_2 = bridge_normal()
        count_2_2, = counted(count_2_1)
        count_2_1 = where(here_1, count_2_2, count_2_1)
        nx_1 = where(here_1, nx_2, nx_1)
        ny_1 = where(here_1, ny_2, ny_1)
        nz_1 = where(here_1, nz_2, nz_1)
        rows3, count4 = _rows(touches_1, count2)
        if count4:
            ball_radius_2 = _take(ball_radius_1, rows3)
            nx_2 = _take(nx_1, rows3)
            ny_2 = _take(ny_1, rows3)
            nz_2 = _take(nz_1, rows3)
            restitution_2 = _take(restitution_1, rows3)
            vx_2 = _take(vx_1, rows3)
            vy_2 = _take(vy_1, rows3)
            vz_2 = _take(vz_1, rows3)
            wx_2 = _take(wx_1, rows3)
            wy_2 = _take(wy_1, rows3)
            wz_2 = _take(wz_1, rows3)
            vx_2, vy_2, vz_2, wx_2, wy_2, wz_2 = impact(vx_2, vy_2, vz_2, wx_2, wy_2, wz_2, nx_2, ny_2, nz_2, ball_radius_2, restitution_2)
            vx_1 = _put(vx_1, rows3, vx_2, count2)
            vy_1 = _put(vy_1, rows3, vy_2, count2)
            vz_1 = _put(vz_1, rows3, vz_2, count2)
            wx_1 = _put(wx_1, rows3, wx_2, count2)
            wy_1 = _put(wy_1, rows3, wy_2, count2)
            wz_1 = _put(wz_1, rows3, wz_2, count2)
        here_1, = here(1.0, which_1)
        x_2, y_2, z_2 = backboard_place(y_1, z_1, ball_radius_1, board_distance_1)
        x_1 = where(here_1, x_2, x_1)
        y_1 = where(here_1, y_2, y_1)
        z_1 = where(here_1, z_2, z_1)
        here_1, = here(2.0, which_1)
        x_2, y_2, z_2 = bridge_place(x_1, y_1, ball_radius_1, wire_radius_1)
        x_1 = where(here_1, x_2, x_1)
        y_1 = where(here_1, y_2, y_1)
        z_1 = where(here_1, z_2, z_1)
        first_2, last_2 = touched(body_1, first_1, which_1)
        first_1 = where(touches_1, first_2, first_1)
        last_1 = where(touches_1, last_2, last_1)
        count_0_0 = _put(count_0, rows1, count_0_1, shots)
        count_1_0 = _put(count_1, rows1, count_1_1, shots)
        count_2_0 = _put(count_2, rows1, count_2_1, shots)
        first_0 = _put(first, rows1, first_1, shots)
        last_0 = _put(last, rows1, last_1, shots)
        vx_0 = _put(vx, rows1, vx_1, shots)
        vy_0 = _put(vy, rows1, vy_1, shots)
        vz_0 = _put(vz, rows1, vz_1, shots)
        wx_0 = _put(wx, rows1, wx_1, shots)
        wy_0 = _put(wy, rows1, wy_1, shots)
        wz_0 = _put(wz, rows1, wz_1, shots)
        x_0 = _put(x, rows1, x_1, shots)
        y_0 = _put(y, rows1, y_1, shots)
        z_0 = _put(z, rows1, z_1, shots)
    else:
        count_0_0 = count_0
        count_1_0 = count_1
        count_2_0 = count_2
        first_0 = first
        last_0 = last
        vx_0 = vx
        vy_0 = vy
        vz_0 = vz
        wx_0 = wx
        wy_0 = wy
        wz_0 = wz
        x_0 = x
        y_0 = y
        z_0 = z
    columns["count_0"] = count_0_0
    columns["count_1"] = count_1_0
    columns["count_2"] = count_2_0
    columns["first"] = first_0
    columns["last"] = last_0
    columns["vx"] = vx_0
    columns["vy"] = vy_0
    columns["vz"] = vz_0
    columns["wx"] = wx_0
    columns["wy"] = wy_0
    columns["wz"] = wz_0
    columns["x"] = x_0
    columns["y"] = y_0
    columns["z"] = z_0


def permit_bounded(columns: dict[str, Any], shots: int) -> None:
    """Stage permit of the event loop, with bounds on errors."""
    ball_radius = columns["ball_radius"]
    board_bottom = columns["board_bottom"]
    board_distance = columns["board_distance"]
    board_half_width = columns["board_half_width"]
    board_top = columns["board_top"]
    bridge_half_width = columns["bridge_half_width"]
    end_depth = columns["end_depth"]
    gravity = columns["gravity"]
    restitution = columns["restitution"]
    ring_radius = columns["ring_radius"]
    wire_radius = columns["wire_radius"]
    allowed_0, = allowed(ball_radius, ring_radius, wire_radius, board_distance, board_half_width, bridge_half_width, restitution, gravity, end_depth)
    permitted_0, = finite_parameters(ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, restitution, gravity, end_depth, allowed_0)
    columns["permitted"] = permitted_0


def admit_bounded(columns: dict[str, Any], shots: int) -> None:
    """Stage admit of the event loop, with bounds on errors."""
    ball_radius = columns["ball_radius"]
    board_bottom = columns["board_bottom"]
    board_distance = columns["board_distance"]
    board_half_width = columns["board_half_width"]
    board_top = columns["board_top"]
    bridge_half_width = columns["bridge_half_width"]
    end_depth = columns["end_depth"]
    last = columns["last"]
    permitted = columns["permitted"]
    ring_radius = columns["ring_radius"]
    vx = columns["vx"]
    vy = columns["vy"]
    vz = columns["vz"]
    wire_radius = columns["wire_radius"]
    wx = columns["wx"]
    wy = columns["wy"]
    wz = columns["wz"]
    x = columns["x"]
    y = columns["y"]
    z = columns["z"]
    finite_0, = finite_state(vx, vy, vz, wx, wy, wz, x, y, z)
    valid_0, doubt_0 = valid(last, x, y, z, ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, end_depth)
    outcome_0, uncertain_0 = admitted(doubt_0, finite_0, permitted, valid_0)
    columns["outcome"] = outcome_0
    columns["uncertain"] = uncertain_0


def reach_bounded(columns: dict[str, Any], shots: int) -> None:
    """Stage reach of the event loop, with bounds on errors."""
    ball_radius = columns["ball_radius"]
    board_bottom = columns["board_bottom"]
    board_distance = columns["board_distance"]
    board_half_width = columns["board_half_width"]
    board_top = columns["board_top"]
    bridge_half_width = columns["bridge_half_width"]
    clock = columns["clock"]
    clock_error = columns["clock_error"]
    contacts = columns["contacts"]
    dvx = columns["dvx"]
    dvy = columns["dvy"]
    dvz = columns["dvz"]
    dwx = columns["dwx"]
    dwy = columns["dwy"]
    dwz = columns["dwz"]
    dx = columns["dx"]
    dy = columns["dy"]
    dz = columns["dz"]
    end_depth = columns["end_depth"]
    gravity = columns["gravity"]
    last = columns["last"]
    most_contacts = columns["most_contacts"]
    ring_radius = columns["ring_radius"]
    uncertain = columns["uncertain"]
    vx = columns["vx"]
    vy = columns["vy"]
    vz = columns["vz"]
    wire_radius = columns["wire_radius"]
    x = columns["x"]
    y = columns["y"]
    z = columns["z"]
    position_error_0, velocity_error_0, *_ = error_bounds(clock_error, dx, dy, dz, dvx, dvy, dvz, dwx, dwy, dwz)
    extent_0, speed_0, excess_0 = scale(x, y, z, vx, vy, vz, gravity)
    when_0, which_0, late_0, doubt_0 = opening(excess_0, position_error_0, velocity_error_0)
    leaving_0, = left(3.0, last)
    time_0, rate_0, bend_0, apex_0, height_0 = end_arrival(leaving_0, z, vz, gravity, end_depth)
    arrives_0, ceiling_0 = meeting_plane(bend_0, rate_0, time_0)
    margin_0, = end_margin(time_0, extent_0, speed_0, position_error_0, velocity_error_0, gravity, end_depth)
    clearance_0, delay_0 = crossing(margin_0, 0.0, rate_0, ceiling_0)
    possible_0, = timely(arrives_0, delay_0, late_0, time_0, when_0)
    margin_0, = end_margin(apex_0, extent_0, speed_0, position_error_0, velocity_error_0, gravity, end_depth)
    doubt_0, = grazed(apex_0, doubt_0, height_0, margin_0)
    doubt_1, = crossed(arrives_0, clearance_0, doubt_0, time_0)
    doubt_1, late_1 = tied(arrives_0, delay_0, doubt_1, late_0, time_0, when_0)
    when_1, which_1 = sooner(arrives_0, 3.0, time_0, when_0, which_0)
    doubt_0 = where(possible_0, doubt_1, doubt_0)
    late_0 = where(possible_0, late_1, late_0)
    when_0 = where(possible_0, when_1, when_0)
    which_0 = where(possible_0, which_1, which_0)
    leaving_0, = left(1.0, last)
    time_0, rate_0, bend_0, apex_0, height_0 = backboard_arrival(leaving_0, x, vx, ball_radius, board_distance)
    arrives_0, ceiling_0 = meeting_plane(bend_0, rate_0, time_0)
    margin_0, = backboard_margin(time_0, extent_0, speed_0, position_error_0, velocity_error_0, ball_radius, board_distance, gravity)
    clearance_0, delay_0 = crossing(margin_0, 0.0, rate_0, ceiling_0)
    possible_0, = timely(arrives_0, delay_0, late_0, time_0, when_0)
    margin_0, = backboard_margin(apex_0, extent_0, speed_0, position_error_0, velocity_error_0, ball_radius, board_distance, gravity)
    doubt_0, = grazed(apex_0, doubt_0, height_0, margin_0)
    rows1, count2 = _rows(possible_0, shots)
    if count2:
        ball_radius_1 = _take(ball_radius, rows1)
        board_bottom_1 = _take(board_bottom, rows1)
        board_distance_1 = _take(board_distance, rows1)
        board_half_width_1 = _take(board_half_width, rows1)
        board_top_1 = _take(board_top, rows1)
        bridge_half_width_1 = _take(bridge_half_width, rows1)
        clearance_1 = _take(clearance_0, rows1)
        delay_1 = _take(delay_0, rows1)
        doubt_1 = _take(doubt_0, rows1)
        end_depth_1 = _take(end_depth, rows1)
        extent_1 = _take(extent_0, rows1)
        gravity_1 = _take(gravity, rows1)
        late_1 = _take(late_0, rows1)
        position_error_1 = _take(position_error_0, rows1)
        ring_radius_1 = _take(ring_radius, rows1)
        speed_1 = _take(speed_0, rows1)
        time_1 = _take(time_0, rows1)
        velocity_error_1 = _take(velocity_error_0, rows1)
        vx_1 = _take(vx, rows1)
        vy_1 = _take(vy, rows1)
        vz_1 = _take(vz, rows1)
        when_1 = _take(when_0, rows1)
        which_1 = _take(which_0, rows1)
        wire_radius_1 = _take(wire_radius, rows1)
        x_1 = _take(x, rows1)
        y_1 = _take(y, rows1)
        z_1 = _take(z, rows1)
        _, there_y_1, there_z_1, *_ = flight(time_1, x_1, y_1, z_1, vx_1, vy_1, vz_1, gravity_1)
        g0_1, g1_1, g2_1, g3_1 = backboard_bounds(there_y_1, there_z_1, board_half_width_1, board_bottom_1, board_top_1)
        slack_1, = displacement(delay_1, time_1, extent_1, speed_1, position_error_1, velocity_error_1, ball_radius_1, ring_radius_1, wire_radius_1, board_distance_1, board_half_width_1, board_bottom_1, board_top_1, bridge_half_width_1, gravity_1, end_depth_1)
        unsure_1, = backboard_edges(clearance_1, g0_1, g1_1, g2_1, g3_1, slack_1)
        doubt_1, = questioned(doubt_1, time_1, unsure_1)
        arrives_1, = backboard_within(g0_1, g1_1, g2_1, g3_1)
        doubt_1, late_1 = tied(arrives_1, delay_1, doubt_1, late_1, time_1, when_1)
        when_1, which_1 = sooner(arrives_1, 1.0, time_1, when_1, which_1)
        doubt_0 = _put(doubt_0, rows1, doubt_1, shots)
        late_0 = _put(late_0, rows1, late_1, shots)
        when_0 = _put(when_0, rows1, when_1, shots)
        which_0 = _put(which_0, rows1, which_1, shots)
    leaving_0, = left(2.0, last)
    time_0, rate_0, bend_0, apex_0, height_0 = bridge_arrival(leaving_0, z, vz, ball_radius, wire_radius, gravity)
    arrives_0, ceiling_0 = meeting_plane(bend_0, rate_0, time_0)
    margin_0, = bridge_margin(time_0, extent_0, speed_0, position_error_0, velocity_error_0, ball_radius, wire_radius, gravity)
    clearance_0, delay_0 = crossing(margin_0, 0.0, rate_0, ceiling_0)
    possible_0, = timely(arrives_0, delay_0, late_0, time_0, when_0)
    margin_0, = bridge_margin(apex_0, extent_0, speed_0, position_error_0, velocity_error_0, ball_radius, wire_radius, gravity)
    doubt_0, = grazed(apex_0, doubt_0, height_0, margin_0)
    rows3, count4 = _rows(possible_0, shots)
    if count4:
        ball_radius_1 = _take(ball_radius, rows3)
        board_bottom_1 = _take(board_bottom, rows3)
        board_distance_1 = _take(board_distance, rows3)
        board_half_width_1 = _take(board_half_width, rows3)
        board_top_1 = _take(board_top, rows3)
        bridge_half_width_1 = _take(bridge_half_width, rows3)
        clearance_1 = _take(clearance_0, rows3)
        delay_1 = _take(delay_0, rows3)
        doubt_1 = _take(doubt_0, rows3)
        end_depth_1 = _take(end_depth, rows3)
        extent_1 = _take(extent_0, rows3)
        gravity_1 = _take(gravity, rows3)
        late_1 = _take(late_0, rows3)
        position_error_1 = _take(position_error_0, rows3)
        ring_radius_1 = _take(ring_radius, rows3)
        speed_1 = _take(speed_0, rows3)
        time_1 = _take(time_0, rows3)
        velocity_error_1 = _take(velocity_error_0, rows3)
        vx_1 = _take(vx, rows3)
        vy_1 = _take(vy, rows3)
        vz_1 = _take(vz, rows3)
        when_1 = _take(when_0, rows3)
        which_1 = _take(which_0, rows3)
        wire_radius_1 = _take(wire_radius, rows3)
        x_1 = _take(x, rows3)
        y_1 = _take(y, rows3)
        z_1 = _take(z, rows3)
        there_x_1, there_y_1, *_ = flight(time_1, x_1, y_1, z_1, vx_1, vy_1, vz_1, gravity_1)
        g0_1, g1_1, g2_1, g3_1, g4_1 = bridge_bounds(there_x_1, there_y_1, ring_radius_1, board_distance_1, bridge_half_width_1)
        slack_1, = displacement(delay_1, time_1, extent_1, speed_1, position_error_1, velocity_error_1, ball_radius_1, ring_radius_1, wire_radius_1, board_distance_1, board_half_width_1, board_bottom_1, board_top_1, bridge_half_width_1, gravity_1, end_depth_1)
        unsure_1, = bridge_edges(clearance_1, g0_1, g1_1, g2_1, g3_1, g4_1, slack_1)
        doubt_1, = questioned(doubt_1, time_1, unsure_1)
        arrives_1, = bridge_within(g0_1, g1_1, g2_1, g3_1, g4_1)
        doubt_1, late_1 = tied(arrives_1, delay_1, doubt_1, late_1, time_1, when_1)
        when_1, which_1 = sooner(arrives_1, 2.0, time_1, when_1, which_1)
        doubt_0 = _put(doubt_0, rows3, doubt_1, shots)
        late_0 = _put(late_0, rows3, late_1, shots)
        when_0 = _put(when_0, rows3, when_1, shots)
        which_0 = _put(which_0, rows3, which_1, shots)
    until_0, pad_0 = horizon(when_0, speed_0, gravity)
    clear_0, = ring_clear(until_0, x, y, z, vx, vy, vz, extent_0, speed_0, position_error_0, velocity_error_0, ball_radius, ring_radius, wire_radius, gravity)
    open_0, = opens(clear_0)
    rows5, count6 = _rows(open_0, shots)
    if count6:
        ball_radius_1 = _take(ball_radius, rows5)
        doubt_1 = _take(doubt_0, rows5)
        extent_1 = _take(extent_0, rows5)
        gravity_1 = _take(gravity, rows5)
        last_1 = _take(last, rows5)
        late_1 = _take(late_0, rows5)
        pad_1 = _take(pad_0, rows5)
        position_error_1 = _take(position_error_0, rows5)
        ring_radius_1 = _take(ring_radius, rows5)
        speed_1 = _take(speed_0, rows5)
        until_1 = _take(until_0, rows5)
        velocity_error_1 = _take(velocity_error_0, rows5)
        vx_1 = _take(vx, rows5)
        vy_1 = _take(vy, rows5)
        vz_1 = _take(vz, rows5)
        when_1 = _take(when_0, rows5)
        which_1 = _take(which_0, rows5)
        wire_radius_1 = _take(wire_radius, rows5)
        x_1 = _take(x, rows5)
        y_1 = _take(y, rows5)
        z_1 = _take(z, rows5)
        steady_1, swing_1, rho_start_1, low0_1, high0_1, low1_1, high1_1, low2_1, high2_1, ceiling_1, latest_1, lost_1 = ring_prepare(until_1, x_1, y_1, z_1, vx_1, vy_1, vz_1, position_error_1, velocity_error_1, ball_radius_1, ring_radius_1, wire_radius_1, gravity_1)
        share_1, arrival_1, certain_1 = beginning()
        level_1, velocity_level_1, excess_1 = allowance(share_1, latest_1, extent_1, speed_1, position_error_1, velocity_error_1, gravity_1)
        flat_1, tilt_1, rate_slack_1 = ring_margins(latest_1, extent_1, speed_1, level_1, velocity_level_1, ball_radius_1, ring_radius_1, wire_radius_1, gravity_1)
        doubt_1, = beyond(doubt_1, excess_1, late_1, lost_1, pad_1)
        t_1, end_1, searching_1 = ring_enter(0.0, 0.0, high0_1, high1_1, high2_1, low0_1, low1_1, low2_1, 0.0)
        rows7, count8 = _rows(searching_1, count6)
        if count8:
            arrival_2 = _take(arrival_1, rows7)
            ball_radius_2 = _take(ball_radius_1, rows7)
            ceiling_2 = _take(ceiling_1, rows7)
            certain_2 = _take(certain_1, rows7)
            doubt_2 = _take(doubt_1, rows7)
            end_2 = _take(end_1, rows7)
            extent_2 = _take(extent_1, rows7)
            flat_2 = _take(flat_1, rows7)
            gravity_2 = _take(gravity_1, rows7)
            high0_2 = _take(high0_1, rows7)
            high1_2 = _take(high1_1, rows7)
            high2_2 = _take(high2_1, rows7)
            last_2 = _take(last_1, rows7)
            latest_2 = _take(latest_1, rows7)
            low0_2 = _take(low0_1, rows7)
            low1_2 = _take(low1_1, rows7)
            low2_2 = _take(low2_1, rows7)
            position_error_2 = _take(position_error_1, rows7)
            rate_slack_2 = _take(rate_slack_1, rows7)
            rho_start_2 = _take(rho_start_1, rows7)
            ring_radius_2 = _take(ring_radius_1, rows7)
            searching_2 = _take(searching_1, rows7)
            share_2 = _take(share_1, rows7)
            speed_2 = _take(speed_1, rows7)
            steady_2 = _take(steady_1, rows7)
            swing_2 = _take(swing_1, rows7)
            t_2 = _take(t_1, rows7)
            tilt_2 = _take(tilt_1, rows7)
            velocity_error_2 = _take(velocity_error_1, rows7)
            vx_2 = _take(vx_1, rows7)
            vy_2 = _take(vy_1, rows7)
            vz_2 = _take(vz_1, rows7)
            wire_radius_2 = _take(wire_radius_1, rows7)
            x_2 = _take(x_1, rows7)
            y_2 = _take(y_1, rows7)
            z_2 = _take(z_1, rows7)
            arrival_1 = _copy(arrival_1, count6)
            certain_1 = _copy(certain_1, count6)
            doubt_1 = _copy(doubt_1, count6)
            flat_1 = _copy(flat_1, count6)
            searching_1 = _copy(searching_1, count6)
            t_1 = _copy(t_1, count6)
            tilt_1 = _copy(tilt_1, count6)
            for _ in range(201):
                leaving_2, margin_2 = nearby(flat_2, 0.0, last_2, t_2, tilt_2)
                gap_2, rate_2, bend_2, step_2, next_2, root_2, clearance_2 = ring_advance(t_2, end_2, leaving_2, margin_2, rate_slack_2, ceiling_2, x_2, y_2, z_2, vx_2, vy_2, vz_2, steady_2, swing_2, rho_start_2, ball_radius_2, ring_radius_2, wire_radius_2, gravity_2)
                hit_2, sure_2, vague_2 = struck(bend_2, clearance_2, gap_2, margin_2, rate_2, rate_slack_2, share_2)
                rows9, count10 = _rows(vague_2, count8)
                if count10:
                    ball_radius_3 = _take(ball_radius_2, rows9)
                    doubt_3 = _take(doubt_2, rows9)
                    extent_3 = _take(extent_2, rows9)
                    gravity_3 = _take(gravity_2, rows9)
                    latest_3 = _take(latest_2, rows9)
                    position_error_3 = _take(position_error_2, rows9)
                    ring_radius_3 = _take(ring_radius_2, rows9)
                    share_3 = _take(share_2, rows9)
                    speed_3 = _take(speed_2, rows9)
                    t_3 = _take(t_2, rows9)
                    velocity_error_3 = _take(velocity_error_2, rows9)
                    wire_radius_3 = _take(wire_radius_2, rows9)
                    share_3, = finer(share_3)
                    level_3, velocity_level_3, excess_3 = allowance(share_3, latest_3, extent_3, speed_3, position_error_3, velocity_error_3, gravity_3)
                    flat_3, tilt_3, rate_slack_3 = ring_margins(latest_3, extent_3, speed_3, level_3, velocity_level_3, ball_radius_3, ring_radius_3, wire_radius_3, gravity_3)
                    doubt_3, = exceeded(doubt_3, excess_3, t_3)
                    doubt_2 = _put(doubt_2, rows9, doubt_3, count8)
                    flat_2 = _put(flat_2, rows9, flat_3, count8)
                    rate_slack_2 = _put(rate_slack_2, rows9, rate_slack_3, count8)
                    share_2 = _put(share_2, rows9, share_3, count8)
                    tilt_2 = _put(tilt_2, rows9, tilt_3, count8)
                arrival_2, certain_2, exhausted_2, searching_2, t_2 = advanced(arrival_2, certain_2, end_2, hit_2, next_2, root_2, step_2, sure_2, t_2, vague_2)
                t_3, end_3, searching_3 = ring_enter(end_2, end_2, high0_2, high1_2, high2_2, low0_2, low1_2, low2_2, t_2)
                end_2 = where(exhausted_2, end_3, end_2)
                searching_2 = where(exhausted_2, searching_3, searching_2)
                t_2 = where(exhausted_2, t_3, t_2)
                going11 = flatnonzero(searching_2)
                if len(going11) == count8:
                    continue
                done = flatnonzero(logical_not(searching_2))
                _store(arrival_1, _of(rows7, done), arrival_2, done)
                _store(certain_1, _of(rows7, done), certain_2, done)
                _store(doubt_1, _of(rows7, done), doubt_2, done)
                _store(flat_1, _of(rows7, done), flat_2, done)
                _store(searching_1, _of(rows7, done), searching_2, done)
                _store(t_1, _of(rows7, done), t_2, done)
                _store(tilt_1, _of(rows7, done), tilt_2, done)
                rows7, count8 = _of(rows7, going11), len(going11)
                if not count8:
                    break
                arrival_2 = _take(arrival_2, going11)
                ball_radius_2 = _take(ball_radius_2, going11)
                ceiling_2 = _take(ceiling_2, going11)
                certain_2 = _take(certain_2, going11)
                doubt_2 = _take(doubt_2, going11)
                end_2 = _take(end_2, going11)
                extent_2 = _take(extent_2, going11)
                flat_2 = _take(flat_2, going11)
                gravity_2 = _take(gravity_2, going11)
                high0_2 = _take(high0_2, going11)
                high1_2 = _take(high1_2, going11)
                high2_2 = _take(high2_2, going11)
                last_2 = _take(last_2, going11)
                latest_2 = _take(latest_2, going11)
                low0_2 = _take(low0_2, going11)
                low1_2 = _take(low1_2, going11)
                low2_2 = _take(low2_2, going11)
                position_error_2 = _take(position_error_2, going11)
                rate_slack_2 = _take(rate_slack_2, going11)
                rho_start_2 = _take(rho_start_2, going11)
                ring_radius_2 = _take(ring_radius_2, going11)
                searching_2 = _take(searching_2, going11)
                share_2 = _take(share_2, going11)
                speed_2 = _take(speed_2, going11)
                steady_2 = _take(steady_2, going11)
                swing_2 = _take(swing_2, going11)
                t_2 = _take(t_2, going11)
                tilt_2 = _take(tilt_2, going11)
                velocity_error_2 = _take(velocity_error_2, going11)
                vx_2 = _take(vx_2, going11)
                vy_2 = _take(vy_2, going11)
                vz_2 = _take(vz_2, going11)
                wire_radius_2 = _take(wire_radius_2, going11)
                x_2 = _take(x_2, going11)
                y_2 = _take(y_2, going11)
                z_2 = _take(z_2, going11)
            else:
                _store(arrival_1, rows7, arrival_2, None)
                _store(certain_1, rows7, certain_2, None)
                _store(doubt_1, rows7, doubt_2, None)
                _store(flat_1, rows7, flat_2, None)
                _store(searching_1, rows7, searching_2, None)
                _store(t_1, rows7, t_2, None)
                _store(tilt_1, rows7, tilt_2, None)
        doubt_1, = questioned(doubt_1, t_1, searching_1)
        arrives_1, = found(arrival_1)
        leaving_1, *_ = nearby(flat_1, 0.0, last_1, arrival_1, tilt_1)
        refined_1, *_ = ring_refine(arrival_1, leaving_1, x_1, y_1, z_1, vx_1, vy_1, vz_1, rho_start_1, ball_radius_1, ring_radius_1, wire_radius_1, gravity_1)
        arrival_1, = polished(arrival_1, certain_1, refined_1)
        refined_1, rate_1 = ring_refine(arrival_1, leaving_1, x_1, y_1, z_1, vx_1, vy_1, vz_1, rho_start_1, ball_radius_1, ring_radius_1, wire_radius_1, gravity_1)
        arrival_1, = polished(arrival_1, certain_1, refined_1)
        flat_1, tilt_1, rate_margin_1 = ring_margins(latest_1, extent_1, speed_1, position_error_1, velocity_error_1, ball_radius_1, ring_radius_1, wire_radius_1, gravity_1)
        margin_1, = own_margin(arrival_1, flat_1, leaving_1, tilt_1)
        clearance_1, delay_1 = crossing(margin_1, rate_margin_1, rate_1, ceiling_1)
        time_1, = landed(arrival_1)
        delay_1, doubt_1 = landed_surely(arrives_1, certain_1, clearance_1, delay_1, doubt_1, time_1)
        doubt_1, late_1 = tied(arrives_1, delay_1, doubt_1, late_1, time_1, when_1)
        when_1, which_1 = sooner(arrives_1, 0.0, time_1, when_1, which_1)
        doubt_0 = _put(doubt_0, rows5, doubt_1, shots)
        late_0 = _put(late_0, rows5, late_1, shots)
        when_0 = _put(when_0, rows5, when_1, shots)
        which_0 = _put(which_0, rows5, which_1, shots)
    _, moves_0, ends_0, touches_0 = departed(3.0, which_0)
    body_0, = body_of(which_0)
    x_1, y_1, z_1, vx_1, vy_1, vz_1 = flight(when_0, x, y, z, vx, vy, vz, gravity)
    clock_1, = ticked(clock, when_0)
    clock_0 = where(moves_0, clock_1, clock)
    vx_0 = where(moves_0, vx_1, vx)
    vy_0 = where(moves_0, vy_1, vy)
    vz_0 = where(moves_0, vz_1, vz)
    x_0 = where(moves_0, x_1, x)
    y_0 = where(moves_0, y_1, y)
    z_0 = where(moves_0, z_1, z)
    slack_0, = displacement(late_0, when_0, extent_0, speed_0, position_error_0, velocity_error_0, ball_radius, ring_radius, wire_radius, board_distance, board_half_width, board_bottom, board_top, bridge_half_width, gravity, end_depth)
    miss_0, = target(x_0, y_0, ring_radius)
    uncertain_0, = doubted(doubt_0, ends_0, late_0, miss_0, slack_0, uncertain, when_0)
    contacts_0, outcome_0 = accounted(contacts, ends_0, miss_0, most_contacts, touches_0)
    columns["body"] = body_0
    columns["clock"] = clock_0
    columns["contacts"] = contacts_0
    columns["ends"] = ends_0
    columns["late"] = late_0
    columns["outcome"] = outcome_0
    columns["touches"] = touches_0
    columns["uncertain"] = uncertain_0
    columns["vx"] = vx_0
    columns["vy"] = vy_0
    columns["vz"] = vz_0
    columns["when"] = when_0
    columns["which"] = which_0
    columns["x"] = x_0
    columns["y"] = y_0
    columns["z"] = z_0


def meet_bounded(columns: dict[str, Any], shots: int) -> None:
    """Stage meet of the event loop, with bounds on errors."""
    ball_radius = columns["ball_radius"]
    board_distance = columns["board_distance"]
    body = columns["body"]
    claims = columns["claims"]
    clock = columns["clock"]
    clock_error = columns["clock_error"]
    contacts = columns["contacts"]
    count_0 = columns["count_0"]
    count_1 = columns["count_1"]
    count_2 = columns["count_2"]
    dvx = columns["dvx"]
    dvy = columns["dvy"]
    dvz = columns["dvz"]
    dwx = columns["dwx"]
    dwy = columns["dwy"]
    dwz = columns["dwz"]
    dx = columns["dx"]
    dy = columns["dy"]
    dz = columns["dz"]
    ends = columns["ends"]
    first = columns["first"]
    gravity = columns["gravity"]
    last = columns["last"]
    late = columns["late"]
    outcome = columns["outcome"]
    position_claim = columns["position_claim"]
    restitution = columns["restitution"]
    ring_radius = columns["ring_radius"]
    spin_claim = columns["spin_claim"]
    time_claim = columns["time_claim"]
    touches = columns["touches"]
    velocity_claim = columns["velocity_claim"]
    vx = columns["vx"]
    vy = columns["vy"]
    vz = columns["vz"]
    when = columns["when"]
    which = columns["which"]
    wire_radius = columns["wire_radius"]
    wx = columns["wx"]
    wy = columns["wy"]
    wz = columns["wz"]
    x = columns["x"]
    y = columns["y"]
    z = columns["z"]
    meeting_0, = meeting(claims, ends, touches)
    rows1, count2 = _rows(meeting_0, shots)
    if count2:
        ball_radius_1 = _take(ball_radius, rows1)
        board_distance_1 = _take(board_distance, rows1)
        body_1 = _take(body, rows1)
        clock_1 = _take(clock, rows1)
        clock_error_1 = _take(clock_error, rows1)
        contacts_1 = _take(contacts, rows1)
        count_0_1 = _take(count_0, rows1)
        count_1_1 = _take(count_1, rows1)
        count_2_1 = _take(count_2, rows1)
        dvx_1 = _take(dvx, rows1)
        dvy_1 = _take(dvy, rows1)
        dvz_1 = _take(dvz, rows1)
        dwx_1 = _take(dwx, rows1)
        dwy_1 = _take(dwy, rows1)
        dwz_1 = _take(dwz, rows1)
        dx_1 = _take(dx, rows1)
        dy_1 = _take(dy, rows1)
        dz_1 = _take(dz, rows1)
        ends_1 = _take(ends, rows1)
        first_1 = _take(first, rows1)
        gravity_1 = _take(gravity, rows1)
        last_1 = _take(last, rows1)
        late_1 = _take(late, rows1)
        restitution_1 = _take(restitution, rows1)
        ring_radius_1 = _take(ring_radius, rows1)
        touches_1 = _take(touches, rows1)
        vx_1 = _take(vx, rows1)
        vy_1 = _take(vy, rows1)
        vz_1 = _take(vz, rows1)
        when_1 = _take(when, rows1)
        which_1 = _take(which, rows1)
        wire_radius_1 = _take(wire_radius, rows1)
        wx_1 = _take(wx, rows1)
        wy_1 = _take(wy, rows1)
        wz_1 = _take(wz, rows1)
        x_1 = _take(x, rows1)
        y_1 = _take(y, rows1)
        z_1 = _take(z, rows1)
        nx_1, ny_1, nz_1 = end_normal()
        here_1, = here(0.0, which_1)
        nx_2, ny_2, nz_2 = ring_normal(x_1, y_1, z_1, ball_radius_1, ring_radius_1, wire_radius_1)
        count_0_2, = counted(count_0_1)
        count_0_1 = where(here_1, count_0_2, count_0_1)
        nx_1 = where(here_1, nx_2, nx_1)
        ny_1 = where(here_1, ny_2, ny_1)
        nz_1 = where(here_1, nz_2, nz_1)
        here_1, = here(1.0, which_1)
        nx_2, ny_2, nz_2 = backboard_normal()
        count_1_2, = counted(count_1_1)
        count_1_1 = where(here_1, count_1_2, count_1_1)
        nx_1 = where(here_1, nx_2, nx_1)
        ny_1 = where(here_1, ny_2, ny_1)
        nz_1 = where(here_1, nz_2, nz_1)
        here_1, = here(2.0, which_1)
        nx_2, ny_2, nz_2 = bridge_normal()
        count_2_2, = counted(count_2_1)
        count_2_1 = where(here_1, count_2_2, count_2_1)
        nx_1 = where(here_1, nx_2, nx_1)
        ny_1 = where(here_1, ny_2, ny_1)
        nz_1 = where(here_1, nz_2, nz_1)
        curving_1, = elsewhere()
        again_1, = again(0.0, last_1, which_1)
        curving_2, = ring_curvature(ball_radius_1, ring_radius_1, wire_radius_1)
        curving_1 = where(again_1, curving_2, curving_1)
        again_1, = again(1.0, last_1, which_1)
        curving_2, = backboard_curvature()
        curving_1 = where(again_1, curving_2, curving_1)
        again_1, = again(2.0, last_1, which_1)
        curving_2, = bridge_curvature()
        curving_1 = where(again_1, curving_2, curving_1)
        dx_1, dy_1, dz_1, dvx_1, dvy_1, dvz_1, delay_1, shift_1 = carry_flight(when_1, x_1, y_1, z_1, vx_1, vy_1, vz_1, nx_1, ny_1, nz_1, clock_1, contacts_1, late_1, dx_1, dy_1, dz_1, dvx_1, dvy_1, dvz_1, curving_1, gravity_1)
        clock_error_1, = delayed(clock_error_1, delay_1)
        dx_2, dy_2, dz_2 = floored(dx_1, dy_1, dz_1, shift_1)
        dx_1 = where(ends_1, dx_2, dx_1)
        dy_1 = where(ends_1, dy_2, dy_1)
        dz_1 = where(ends_1, dz_2, dz_1)
        dnx_1, dny_1, dnz_1, turn_1 = unturned()
        here_1, = here(0.0, which_1)
        rows3, count4 = _rows(here_1, count2)
        if count4:
            ball_radius_2 = _take(ball_radius_1, rows3)
            dx_2 = _take(dx_1, rows3)
            dy_2 = _take(dy_1, rows3)
            dz_2 = _take(dz_1, rows3)
            ring_radius_2 = _take(ring_radius_1, rows3)
            shift_2 = _take(shift_1, rows3)
            wire_radius_2 = _take(wire_radius_1, rows3)
            x_2 = _take(x_1, rows3)
            y_2 = _take(y_1, rows3)
            dnx_2, dny_2, dnz_2, turn_2 = ring_carry_normal(x_2, y_2, dx_2, dy_2, dz_2, shift_2, ball_radius_2, ring_radius_2, wire_radius_2)
            dnx_1 = _put(dnx_1, rows3, dnx_2, count2)
            dny_1 = _put(dny_1, rows3, dny_2, count2)
            dnz_1 = _put(dnz_1, rows3, dnz_2, count2)
            turn_1 = _put(turn_1, rows3, turn_2, count2)
        rows5, count6 = _rows(touches_1, count2)
        if count6:
            ball_radius_2 = _take(ball_radius_1, rows5)
            contacts_2 = _take(contacts_1, rows5)
            dnx_2 = _take(dnx_1, rows5)
            dny_2 = _take(dny_1, rows5)
            dnz_2 = _take(dnz_1, rows5)
            dvx_2 = _take(dvx_1, rows5)
            dvy_2 = _take(dvy_1, rows5)
            dvz_2 = _take(dvz_1, rows5)
            dwx_2 = _take(dwx_1, rows5)
            dwy_2 = _take(dwy_1, rows5)
            dwz_2 = _take(dwz_1, rows5)
            nx_2 = _take(nx_1, rows5)
            ny_2 = _take(ny_1, rows5)
            nz_2 = _take(nz_1, rows5)
            restitution_2 = _take(restitution_1, rows5)
            turn_2 = _take(turn_1, rows5)
            vx_2 = _take(vx_1, rows5)
            vy_2 = _take(vy_1, rows5)
            vz_2 = _take(vz_1, rows5)
            wx_2 = _take(wx_1, rows5)
            wy_2 = _take(wy_1, rows5)
            wz_2 = _take(wz_1, rows5)
            dvx_2, dvy_2, dvz_2, dwx_2, dwy_2, dwz_2 = carry_impact(vx_2, vy_2, vz_2, wx_2, wy_2, wz_2, nx_2, ny_2, nz_2, contacts_2, dvx_2, dvy_2, dvz_2, dwx_2, dwy_2, dwz_2, dnx_2, dny_2, dnz_2, turn_2, ball_radius_2, restitution_2)
            vx_2, vy_2, vz_2, wx_2, wy_2, wz_2 = impact(vx_2, vy_2, vz_2, wx_2, wy_2, wz_2, nx_2, ny_2, nz_2, ball_radius_2, restitution_2)
            dvx_1 = _put(dvx_1, rows5, dvx_2, count2)
            dvy_1 = _put(dvy_1, rows5, dvy_2, count2)
            dvz_1 = _put(dvz_1, rows5, dvz_2, count2)
            dwx_1 = _put(dwx_1, rows5, dwx_2, count2)
            dwy_1 = _put(dwy_1, rows5, dwy_2, count2)
            dwz_1 = _put(dwz_1, rows5, dwz_2, count2)
            vx_1 = _put(vx_1, rows5, vx_2, count2)
            vy_1 = _put(vy_1, rows5, vy_2, count2)
            vz_1 = _put(vz_1, rows5, vz_2, count2)
            wx_1 = _put(wx_1, rows5, wx_2, count2)
            wy_1 = _put(wy_1, rows5, wy_2, count2)
            wz_1 = _put(wz_1, rows5, wz_2, count2)
        here_1, = here(1.0, which_1)
        x_2, y_2, z_2 = backboard_place(y_1, z_1, ball_radius_1, board_distance_1)
        x_1 = where(here_1, x_2, x_1)
        y_1 = where(here_1, y_2, y_1)
        z_1 = where(here_1, z_2, z_1)
        here_1, = here(2.0, which_1)
        x_2, y_2, z_2 = bridge_place(x_1, y_1, ball_radius_1, wire_radius_1)
        x_1 = where(here_1, x_2, x_1)
        y_1 = where(here_1, y_2, y_1)
        z_1 = where(here_1, z_2, z_1)
        first_2, last_2 = touched(body_1, first_1, which_1)
        first_1 = where(touches_1, first_2, first_1)
        last_1 = where(touches_1, last_2, last_1)
        clock_error_0 = _put(clock_error, rows1, clock_error_1, shots)
        count_0_0 = _put(count_0, rows1, count_0_1, shots)
        count_1_0 = _put(count_1, rows1, count_1_1, shots)
        count_2_0 = _put(count_2, rows1, count_2_1, shots)
        dvx_0 = _put(dvx, rows1, dvx_1, shots)
        dvy_0 = _put(dvy, rows1, dvy_1, shots)
        dvz_0 = _put(dvz, rows1, dvz_1, shots)
        dwx_0 = _put(dwx, rows1, dwx_1, shots)
        dwy_0 = _put(dwy, rows1, dwy_1, shots)
        dwz_0 = _put(dwz, rows1, dwz_1, shots)
        dx_0 = _put(dx, rows1, dx_1, shots)
        dy_0 = _put(dy, rows1, dy_1, shots)
        dz_0 = _put(dz, rows1, dz_1, shots)
        first_0 = _put(first, rows1, first_1, shots)
        last_0 = _put(last, rows1, last_1, shots)
        vx_0 = _put(vx, rows1, vx_1, shots)
        vy_0 = _put(vy, rows1, vy_1, shots)
        vz_0 = _put(vz, rows1, vz_1, shots)
        wx_0 = _put(wx, rows1, wx_1, shots)
        wy_0 = _put(wy, rows1, wy_1, shots)
        wz_0 = _put(wz, rows1, wz_1, shots)
        x_0 = _put(x, rows1, x_1, shots)
        y_0 = _put(y, rows1, y_1, shots)
        z_0 = _put(z, rows1, z_1, shots)
    else:
        clock_error_0 = clock_error
        count_0_0 = count_0
        count_1_0 = count_1
        count_2_0 = count_2
        dvx_0 = dvx
        dvy_0 = dvy
        dvz_0 = dvz
        dwx_0 = dwx
        dwy_0 = dwy
        dwz_0 = dwz
        dx_0 = dx
        dy_0 = dy
        dz_0 = dz
        first_0 = first
        last_0 = last
        vx_0 = vx
        vy_0 = vy
        vz_0 = vz
        wx_0 = wx
        wy_0 = wy
        wz_0 = wz
        x_0 = x
        y_0 = y
        z_0 = z
    closed_0, = closing(claims, outcome)
    position_claim_1, velocity_claim_1, spin_claim_1, time_claim_1 = claimed_errors(clock_error_0, dx_0, dy_0, dz_0, dvx_0, dvy_0, dvz_0, dwx_0, dwy_0, dwz_0)
    position_claim_0 = where(closed_0, position_claim_1, position_claim)
    spin_claim_0 = where(closed_0, spin_claim_1, spin_claim)
    time_claim_0 = where(closed_0, time_claim_1, time_claim)
    velocity_claim_0 = where(closed_0, velocity_claim_1, velocity_claim)
    columns["clock_error"] = clock_error_0
    columns["count_0"] = count_0_0
    columns["count_1"] = count_1_0
    columns["count_2"] = count_2_0
    columns["dvx"] = dvx_0
    columns["dvy"] = dvy_0
    columns["dvz"] = dvz_0
    columns["dwx"] = dwx_0
    columns["dwy"] = dwy_0
    columns["dwz"] = dwz_0
    columns["dx"] = dx_0
    columns["dy"] = dy_0
    columns["dz"] = dz_0
    columns["first"] = first_0
    columns["last"] = last_0
    columns["position_claim"] = position_claim_0
    columns["spin_claim"] = spin_claim_0
    columns["time_claim"] = time_claim_0
    columns["velocity_claim"] = velocity_claim_0
    columns["vx"] = vx_0
    columns["vy"] = vy_0
    columns["vz"] = vz_0
    columns["wx"] = wx_0
    columns["wy"] = wy_0
    columns["wz"] = wz_0
    columns["x"] = x_0
    columns["y"] = y_0
    columns["z"] = z_0
