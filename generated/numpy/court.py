"""NumPy kernels of the scene court.

Generated from templates/numpy/kernels.py.j2, scene court, derivation 39c0af57d7c91c6f,
with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
and run `make generate`.
Every function takes scalars or arrays that broadcast and is evaluated element by element; SI units.
"""

# ruff: noqa: E501

from __future__ import annotations

from enum import IntEnum
from typing import Any, NamedTuple

from numpy import absolute as _absolute
from numpy import broadcast_to as _broadcast_to
from numpy import flatnonzero as _flatnonzero
from numpy import inf as _inf
from numpy import logical_and as _logical_and
from numpy import logical_not as _logical_not
from numpy import logical_or as _logical_or
from numpy import ndim as _ndim
from numpy import sqrt as _sqrt
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
    Result("time_error", "float64", ('time_claim',), False, True, True, True),
    Result("state_error", "float64", ('position_claim', 'velocity_claim', 'spin_claim'), True, True, True, True),
    Result("uncertain", "bool", ('uncertain',), False, False, True, False),
)

OUTPUTS: dict[str, tuple[str, ...]] = {
    "flight": ("x", "y", "z", "vx", "vy", "vz",),
    "contact_frame": ("n11", "n12", "n13", "n21", "n22", "n23", "n31", "n32", "n33",),
    "impact_through_frame": ("vx", "vy", "vz", "wx", "wy", "wz",),
    "crossing": ("clearance", "delay",),
    "allowance": ("position_level", "velocity_level", "excess",),
    "horizon": ("horizon", "pad",),
    "scale": ("extent", "speed", "excess",),
    "displacement": ("margin",),
    "carry_flight": ("dx", "dy", "dz", "dvx", "dvy", "dvz", "delay", "shift",),
    "carry_time": ("dx", "dy", "dz", "dvx", "dvy", "dvz", "clock_error",),
    "error_bounds": ("position_error", "velocity_error", "spin_error", "time_error",),
    "claimed_errors": ("position_error", "velocity_error", "spin_error", "time_error",),
    "allowed": ("allowed",),
    "finite_parameters": ("permitted",),
    "valid": ("valid", "doubt",),
    "passing_start": ("through", "uncertain",),
    "passing": ("through",),
    "passing_doubt": ("unsure",),
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
    "finite_state": ("finite",),
    "opening": ("when", "which", "late", "doubt",),
    "limited": ("limited",),
    "ticked": ("clock",),
    "doubted": ("uncertain",),
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
    "ring_impact_doubt": ("unsure",),
    "ring_impact": ("vx", "vy", "vz", "wx", "wy", "wz",),
    "carry_ring_impact": ("dvx", "dvy", "dvz", "dwx", "dwy", "dwz",),
    "backboard_impact_doubt": ("unsure",),
    "backboard_impact": ("vx", "vy", "vz", "wx", "wy", "wz",),
    "carry_backboard_impact": ("dvx", "dvy", "dvz", "dwx", "dwy", "dwz",),
    "bridge_impact_doubt": ("unsure",),
    "bridge_impact": ("vx", "vy", "vz", "wx", "wy", "wz",),
    "carry_bridge_impact": ("dvx", "dvy", "dvz", "dwx", "dwy", "dwz",),
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
    "backboard_normal": ("nx", "ny", "nz",),
    "backboard_curvature": ("curvature",),
    "backboard_carry_normal": ("dnx", "dny", "dnz", "turn",),
    "backboard_clear": ("clear",),
    "backboard_prepare": ("low0", "high0", "low1", "high1", "ceiling", "latest", "lost",),
    "backboard_margins": ("margin", "leaving_margin", "rate_margin",),
    "backboard_refine": ("time", "rate",),
    "backboard_advance": ("gap", "rate", "bend", "step", "next", "root", "clearance",),
    "backboard_enter": ("t", "end", "searching",),
    "bridge_normal": ("nx", "ny", "nz",),
    "bridge_curvature": ("curvature",),
    "bridge_carry_normal": ("dnx", "dny", "dnz", "turn",),
    "bridge_clear": ("clear",),
    "bridge_prepare": ("low0", "high0", "low1", "high1", "ceiling", "latest", "lost",),
    "bridge_margins": ("margin", "leaving_margin", "rate_margin",),
    "bridge_refine": ("time", "rate",),
    "bridge_advance": ("gap", "rate", "bend", "step", "next", "root", "clearance",),
    "bridge_enter": ("t", "end", "searching",),
    "end_coefficients": ("c0", "c1", "c2",),
    "end_deflated": ("c0", "c1",),
    "end_normal": ("nx", "ny", "nz",),
    "end_curvature": ("curvature",),
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
    "sighted": ("past", "left",),
    "ring_nearness": ("gap", "rate", "lower", "concavity", "resolution",),
}
"""Names of each kernel's outputs."""


def flight(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Position and velocity at time t of a flight.

    Eq. 3. 11 operations: 3 additions, 2 subtractions, 6 multiplications.
    Returns x, y, z, vx, vy, vz.
    """
    return x + (t * vx), y + (t * vy), z + (t * (vz - ((0.5 * p_gravity) * t))), vx, vy, vz - (p_gravity * t)


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


def crossing(margin: Any, rate_margin: Any, rate: Any, ceiling: Any) -> tuple[Any, ...]:
    """Positive clearance if a crossing is certain, and the bound on its delay.

    Taylor's theorem with the margins of the gap and its rate. 11 operations: 1 addition, 1 subtraction, 4 multiplications, 1 division, 1 negation, 1 comparison, 2 selections.
    Returns clearance, delay.
    """
    _s0 = -(rate + rate_margin)
    _s1 = 0.0 < _s0
    return _where(_s1, ((_s0 * _s0) - ((6.0 * ceiling) * margin)), _s0), _where(_s1, ((6.0 * margin) / _s0), _inf)


def allowance(share: Any, horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Errors of a state that a search allows for, and by how much the errors exceed them.

    a share of the size of the flight. 10 operations: 2 additions, 2 subtractions, 4 multiplications, 1 comparison, 1 selection.
    Returns position_level, velocity_level, excess.
    """
    _s0 = speed + (p_gravity * horizon)
    _s1 = share * (extent + (horizon * _s0))
    _s2 = share * _s0
    _s3 = position_error - _s1
    _s4 = velocity_error - _s2
    return _s1, _s2, _where(_s3 < _s4, _s4, _s3)


def horizon(t: Any, speed: Any, p_gravity: Any) -> tuple[Any, ...]:
    """A time after which no event is wanted, and how long that is after t.

    the earliest arrival, with room for its delay. 5 operations: 2 additions, 2 multiplications, 1 division.
    Returns horizon, pad.
    """
    _s0 = 9.5367431640625e-07 * (t + (speed * (1.0 / p_gravity)))
    return t + _s0, _s0


def scale(x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Sums of the sizes of the coordinates and of the velocities; excess over the largest.

    what rounding errors are measured by. 24 operations: 4 additions, 1 subtraction, 1 division, 6 absolute values, 6 comparisons, 6 selections.
    Returns extent, speed, excess.
    """
    _s0 = _absolute(x)
    _s1 = _absolute(y)
    _s2 = _absolute(z)
    _s3 = _absolute(vx)
    _s4 = _absolute(vy)
    _s5 = _absolute(vz)
    _s6 = 1.0 / p_gravity
    _s7 = _where(_s6 < _s0, _s0, _s6)
    _s8 = _where(_s7 < _s1, _s1, _s7)
    _s9 = _where(_s8 < _s2, _s2, _s8)
    _s10 = _where(_s9 < _s3, _s3, _s9)
    _s11 = _where(_s10 < _s4, _s4, _s10)
    return (_s0 + _s1) + _s2, (_s3 + _s4) + _s5, _where(_s11 < _s5, _s5, _s11) - 2.9073548971824276e+135


def displacement(delay: Any, horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_gravity: Any, p_end_depth: Any) -> tuple[Any, ...]:
    """Bound on the error of a length at a computed arrival.

    running error analysis. 27 operations: 17 additions, 8 multiplications, 2 absolute values.
    Returns margin.
    """
    _s0 = speed + (p_gravity * horizon)
    _s1 = extent + (horizon * _s0)
    _s2 = (((((p_ball_radius + p_board_distance) + p_board_half_width) + p_board_thickness) + p_bridge_depth) + p_bridge_half_width) + p_end_depth
    _s3 = 4.445228907190568e-16 * (_s1 + ((((_s2 + p_ring_radius) + p_wire_radius) + _absolute(p_board_bottom)) + _absolute(p_board_top)))
    return (((1.0009765625 * delay) * _s0) + _s3) + (3.0029296875 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * _s1))),


def carry_flight(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, nx: Any, ny: Any, nz: Any, clock: Any, contacts: Any, late: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, curving: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Errors of a state at the end of a flight to a surface, from those at its start.

    derivative of Eq. 3 and of the contact time, with roundings. 118 operations: 24 additions, 1 subtraction, 30 multiplications, 3 divisions, 5 negations, 17 absolute values, 19 comparisons, 19 selections.
    Returns dx, dy, dz, dvx, dvy, dvz, delay, shift.
    """
    _s0 = dx + (dvx * t)
    _s1 = _absolute(vx)
    _s2 = 2.0 * t
    _s3 = 1.1102230246251565e-16 * ((_s2 * _s1) + _absolute(x))
    _s4 = _s0 + _where((_s0 < 0.0), (-_s3), _s3)
    _s5 = dy + (dvy * t)
    _s6 = _absolute(vy)
    _s7 = 1.1102230246251565e-16 * ((_s2 * _s6) + _absolute(y))
    _s8 = _s5 + _where((_s5 < 0.0), (-_s7), _s7)
    _s9 = dz + (dvz * t)
    _s10 = _absolute(vz)
    _s11 = 1.1102230246251565e-16 * (((p_gravity * (t * t)) + (_s2 * _s10)) + _absolute(z))
    _s12 = _s9 + _where((_s9 < 0.0), (-_s11), _s11)
    _s13 = ((nx * vx) + (ny * vy)) + (nz * vz)
    _s14 = (-(((nx * _s4) + (ny * _s8)) + (nz * _s12))) / _s13
    _s15 = (vx * _s14) + _s4
    _s16 = _where(_s1 < _s6, _s6, _s1)
    _s17 = _where(_s16 < _s10, _s10, _s16)
    _s18 = _absolute(dx)
    _s19 = _absolute(dy)
    _s20 = _where(_s18 < _s19, _s19, _s18)
    _s21 = _absolute(dz)
    _s22 = _where(_s20 < _s21, _s21, _s20)
    _s23 = curving * (t * _s17)
    _s24 = _absolute(dvx)
    _s25 = _absolute(dvy)
    _s26 = _where(_s24 < _s25, _s25, _s24)
    _s27 = _absolute(dvz)
    _s28 = _where(_s3 < _s7, _s7, _s3)
    _s29 = (t * _where(_s26 < _s27, _s27, _s26)) + _where(_s28 < _s11, _s11, _s28)
    _s30 = ((_s17 / _absolute(_s13)) * ((_s22 * _where(_s23 < 1.0, _s23, 1.0)) + _s29)) + (_s29 + _s22)
    _s31 = _s30 / (8.0 + (8.0 * contacts))
    _s32 = -_s31
    _s33 = (vy * _s14) + _s8
    _s34 = (vz * _s14) + _s12
    _s35 = _absolute(_s14)
    _s36 = 0.0625 * late
    return _where((_absolute(_s15) < _s31), _where((_s15 < 0.0), _s32, _s31), _s15), _where((_absolute(_s33) < _s31), _where((_s33 < 0.0), _s32, _s31), _s33), _where((_absolute(_s34) < _s31), _where((_s34 < 0.0), _s32, _s31), _s34), dvx, dvy, dvz - (p_gravity * _s14), (4.440892098500626e-16 * (clock + t)) + _where(_s35 < _s36, _s36, _s35), _s30


def carry_time(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, clock: Any, clock_error: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Errors of a state at the time limit, from those at the start of the flight.

    derivative of Eq. 3, with roundings. 62 operations: 17 additions, 18 multiplications, 1 negation, 14 absolute values, 6 comparisons, 6 selections.
    Returns dx, dy, dz, dvx, dvy, dvz, clock_error.
    """
    _s0 = _absolute(vx)
    _s1 = clock_error + (4.440892098500626e-16 * (clock + t))
    _s2 = _absolute(dvx)
    _s3 = _absolute(dvy)
    _s4 = _where(_s2 < _s3, _s3, _s2)
    _s5 = _absolute(dvz)
    _s6 = 2.0 * t
    _s7 = 1.1102230246251565e-16 * ((_s6 * _s0) + _absolute(x))
    _s8 = _absolute(vy)
    _s9 = 1.1102230246251565e-16 * ((_s6 * _s8) + _absolute(y))
    _s10 = _where(_s7 < _s9, _s9, _s7)
    _s11 = _absolute(vz)
    _s12 = 1.1102230246251565e-16 * (((p_gravity * (t * t)) + (_s6 * _s11)) + _absolute(z))
    _s13 = _absolute(dx)
    _s14 = _absolute(dy)
    _s15 = _where(_s13 < _s14, _s14, _s13)
    _s16 = _absolute(dz)
    _s17 = ((t * _where(_s4 < _s5, _s5, _s4)) + _where(_s10 < _s12, _s12, _s10)) + _where(_s15 < _s16, _s16, _s15)
    _s18 = _absolute(0.0)
    return (_s0 * _s1) + _s17, (_s8 * _s1) + _s17, (_s11 * _s1) + _s17, (_s18 + _s2) + (2.220446049250313e-16 * _s0), (_s18 + _s3) + (2.220446049250313e-16 * _s8), (_s5 + (2.220446049250313e-16 * _s11)) + _absolute((-(p_gravity * _s1))), 0.0


def error_bounds(clock_error: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any) -> tuple[Any, ...]:
    """Bounds on the errors of a state and its time that decisions allow for.

    the carried errors times a guard. 25 operations: 4 multiplications, 9 absolute values, 6 comparisons, 6 selections.
    Returns position_error, velocity_error, spin_error, time_error.
    """
    _s0 = _absolute(dx)
    _s1 = _absolute(dy)
    _s2 = _where(_s0 < _s1, _s1, _s0)
    _s3 = _absolute(dz)
    _s4 = _absolute(dvx)
    _s5 = _absolute(dvy)
    _s6 = _where(_s4 < _s5, _s5, _s4)
    _s7 = _absolute(dvz)
    _s8 = _absolute(dwx)
    _s9 = _absolute(dwy)
    _s10 = _where(_s8 < _s9, _s9, _s8)
    _s11 = _absolute(dwz)
    return 16.0 * _where(_s2 < _s3, _s3, _s2), 16.0 * _where(_s6 < _s7, _s7, _s6), 16.0 * _where(_s10 < _s11, _s11, _s10), 16.0 * clock_error


def claimed_errors(clock_error: Any, dx: Any, dy: Any, dz: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any) -> tuple[Any, ...]:
    """Bounds on the errors of a state and its time that a shot claims.

    the carried errors times a larger guard. 25 operations: 4 multiplications, 9 absolute values, 6 comparisons, 6 selections.
    Returns position_error, velocity_error, spin_error, time_error.
    """
    _s0 = _absolute(dx)
    _s1 = _absolute(dy)
    _s2 = _where(_s0 < _s1, _s1, _s0)
    _s3 = _absolute(dz)
    _s4 = _absolute(dvx)
    _s5 = _absolute(dvy)
    _s6 = _where(_s4 < _s5, _s5, _s4)
    _s7 = _absolute(dvz)
    _s8 = _absolute(dwx)
    _s9 = _absolute(dwy)
    _s10 = _where(_s8 < _s9, _s9, _s8)
    _s11 = _absolute(dwz)
    return 64.0 * _where(_s2 < _s3, _s3, _s2), 64.0 * _where(_s6 < _s7, _s7, _s6), 64.0 * _where(_s10 < _s11, _s11, _s10), 64.0 * clock_error


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


def valid(last: Any, x: Any, y: Any, z: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_end_depth: Any) -> tuple[Any, ...]:
    """1 where no surface is overlapped; 1 where that is in doubt.

    Table 2. 133 operations: 27 additions, 19 subtractions, 15 multiplications, 3 square roots, 4 negations, 20 absolute values, 21 comparisons, 24 selections.
    Returns valid, doubt.
    """
    _s0 = _sqrt(((x * x) + (y * y))) - p_ring_radius
    _s1 = p_ball_radius + p_wire_radius
    _s2 = ((z * z) + (_s0 * _s0)) - (_s1 * _s1)
    _s3 = _absolute(last) < 0.5
    _s4 = _where(_s3, 1.0, _where((0.0 <= _s2), 1.0, 0.0))
    _s5 = z - p_board_top
    _s6 = p_board_bottom - z
    _s7 = _where(_s5 < 0.0, 0.0, _s5) - _where(_s6 < 0.0, 0.0, _s6)
    _s8 = p_board_distance + x
    _s9 = -((p_board_distance + p_board_thickness) + x)
    _s10 = _where(_s8 < 0.0, 0.0, _s8) - _where(_s9 < 0.0, 0.0, _s9)
    _s11 = y - p_board_half_width
    _s12 = -(p_board_half_width + y)
    _s13 = _where(_s11 < 0.0, 0.0, _s11) - _where(_s12 < 0.0, 0.0, _s12)
    _s14 = _sqrt((((_s7 * _s7) + (_s10 * _s10)) + (_s13 * _s13))) - p_ball_radius
    _s15 = _absolute((last - 1.0)) < 0.5
    _s16 = _where(_s15, _s4, _where((0.0 <= _s14), _s4, 0.0))
    _s17 = p_ring_radius + x
    _s18 = -_s8
    _s19 = _where(_s17 < 0.0, 0.0, _s17) - _where(_s18 < 0.0, 0.0, _s18)
    _s20 = y - p_bridge_half_width
    _s21 = -(p_bridge_half_width + y)
    _s22 = _where(_s20 < 0.0, 0.0, _s20) - _where(_s21 < 0.0, 0.0, _s21)
    _s23 = z - p_wire_radius
    _s24 = (p_wire_radius - p_bridge_depth) - z
    _s25 = _where(_s23 < 0.0, 0.0, _s23) - _where(_s24 < 0.0, 0.0, _s24)
    _s26 = _sqrt((((_s19 * _s19) + (_s22 * _s22)) + (_s25 * _s25))) - p_ball_radius
    _s27 = _absolute((last - 2.0)) < 0.5
    _s28 = ((((_absolute(p_ball_radius) + _absolute(p_board_bottom)) + _absolute(p_board_distance)) + _absolute(p_board_half_width)) + _absolute(p_board_thickness)) + _absolute(p_board_top)
    _s29 = ((((_s28 + _absolute(p_bridge_depth)) + _absolute(p_bridge_half_width)) + _absolute(p_end_depth)) + _absolute(p_ring_radius)) + _absolute(p_wire_radius)
    _s30 = 1.7763568394002505e-15 * (((_s29 + _absolute(x)) + _absolute(y)) + _absolute(z))
    _s31 = _where(_s3, 0.0, _where((_absolute(_s2) <= (((4.0 * p_ball_radius) + (4.0 * p_wire_radius)) * _s30)), 1.0, 0.0))
    _s32 = _where(_s15, _s31, _where((_absolute(_s14) <= _s30), 1.0, _s31))
    return _where(_s27, _s16, _where((0.0 <= _s26), _s16, 0.0)), _where(_s27, _s32, _where((_absolute(_s26) <= _s30), 1.0, _s32))


def passing_start(last: Any, outcome: Any, uncertain: Any, x: Any, y: Any, z: Any, p_ring_radius: Any, p_end_depth: Any) -> tuple[Any, ...]:
    """Whether a ball starts as one that has fallen through the ring.

    Table 2, success. 22 operations: 2 additions, 1 subtraction, 4 multiplications, 1 negation, 1 absolute value, 6 comparisons, 5 conjunctions, 2 selections.
    Returns through, uncertain.
    """
    _s0 = _logical_and(_logical_and((0.0 <= last), (z < 0.0)), ((-p_end_depth) <= z))
    _s1 = (x * x) + (y * y)
    _s2 = p_ring_radius * p_ring_radius
    _s3 = _where(_logical_and(_logical_and(_s0, (_absolute((_s1 - _s2)) <= (8.881784197001252e-16 * (_s2 + _s1)))), (outcome < 0.0)), 1.0, uncertain)
    return _where(_logical_and(_s0, (_s1 < _s2)), 1.0, 0.0), _s3


def passing(through: Any, t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ring_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    """1 for a ball that is down through the ring's disc, -1 for one that came up, else 0.

    Eq. 3, its roots in the ring's plane. 66 operations: 9 additions, 2 subtractions, 18 multiplications, 1 division, 1 square root, 16 comparisons, 9 conjunctions, 2 disjunctions, 8 selections.
    Returns through.
    """
    _s0 = z < 0.0
    _s1 = z + (t * (vz - ((0.5 * p_gravity) * t)))
    _s2 = _s1 < 0.0
    _s3 = (vz * vz) + ((2.0 * p_gravity) * z)
    _s4 = _logical_and(_logical_and(_logical_and(_logical_and(_s0, _s2), (0.0 < vz)), (0.0 < _s3)), (vz < (p_gravity * t)))
    _s5 = _sqrt(_where(_s3 < 0.0, 0.0, _s3))
    _s6 = 1.0 / p_gravity
    _s7 = (vz + _s5) * _s6
    _s8 = _where(0.0 < _s7, _s7, 0.0)
    _s9 = _where(_s8 < t, _s8, t)
    _s10 = x + (vx * _s9)
    _s11 = y + (vy * _s9)
    _s12 = p_ring_radius * p_ring_radius
    _s13 = (vz - _s5) * _s6
    _s14 = _where(0.0 < _s13, _s13, 0.0)
    _s15 = _where(_s14 < t, _s14, t)
    _s16 = x + (vx * _s15)
    _s17 = y + (vy * _s15)
    _s18 = _where(_logical_and(_logical_or(_s4, _logical_and(_s0, (0.0 <= _s1))), (((_s16 * _s16) + (_s17 * _s17)) < _s12)), _where((through == 1.0), 0.0, -1.0), through)
    _s19 = _where(_logical_and(_logical_and(_logical_or(_s4, _logical_and(_s2, (0.0 <= z))), (((_s10 * _s10) + (_s11 * _s11)) < _s12)), (_s18 == 0.0)), 1.0, _s18)
    return _s19,


def passing_doubt(t: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ring_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Where that lies within its error.

    running error analysis. 107 operations: 18 additions, 4 subtractions, 31 multiplications, 1 division, 4 square roots, 6 absolute values, 20 comparisons, 11 conjunctions, 6 disjunctions, 6 selections.
    Returns unsure.
    """
    _s0 = z + (t * (vz - ((0.5 * p_gravity) * t)))
    _s1 = vz * vz
    _s2 = 1.0 / p_gravity
    _s3 = p_gravity * t
    _s4 = speed + _s3
    _s5 = 1.0009765625 * ((position_error + (t * velocity_error)) + (4.440892098500626e-16 * (extent + (t * _s4))))
    _s6 = (8.881784197001252e-16 * (_s1 * _s2)) + _s5
    _s7 = z < 0.0
    _s8 = _s0 < 0.0
    _s9 = _logical_and(_logical_and(_s7, _s8), (0.0 < vz))
    _s10 = _s1 + ((2.0 * p_gravity) * z)
    _s11 = _sqrt(_where(_s10 < 0.0, 0.0, _s10))
    _s12 = (vz + _s11) * _s2
    _s13 = _where(0.0 < _s12, _s12, 0.0)
    _s14 = _where(_s13 < t, _s13, t)
    _s15 = x + (vx * _s14)
    _s16 = y + (vy * _s14)
    _s17 = _sqrt(((_s15 * _s15) + (_s16 * _s16)))
    _s18 = (vz - _s11) * _s2
    _s19 = _where(0.0 < _s18, _s18, 0.0)
    _s20 = _where(_s19 < t, _s19, t)
    _s21 = x + (vx * _s20)
    _s22 = y + (vy * _s20)
    _s23 = _sqrt(((_s21 * _s21) + (_s22 * _s22)))
    _s24 = (1.0009765625 * _s4) * (_sqrt(((8.0 * _s2) * _s6)) + (8.881784197001252e-16 * (t + (_absolute(vz) * _s2))))
    _s25 = _s24 + _s5
    _s26 = _logical_and(_logical_or(_logical_or(_logical_and((0.0 < position_error), (_absolute(z) <= position_error)), (_absolute(_s0) <= _s6)), _logical_and(_s9, (_absolute(_s10) <= ((4.0 * p_gravity) * _s6)))), (_where(_s17 < _s23, _s17, _s23) <= (p_ring_radius + _s25)))
    _s27 = _logical_and(_logical_and(_s9, (0.0 < _s10)), (vz < _s3))
    _s28 = _logical_or(_s26, _logical_or(_logical_and(_logical_or(_s27, _logical_and(_s7, (0.0 <= _s0))), (_absolute((_s23 - p_ring_radius)) <= _s25)), _logical_and(_logical_or(_s27, _logical_and(_s8, (0.0 <= z))), (_absolute((_s17 - p_ring_radius)) <= _s25))))
    return _s28,


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


def opens(clear: Any) -> tuple[Any, ...]:
    """Where a surface is not certainly missed.

    Table 1. 2 operations: 1 comparison, 1 complement.
    Returns open.
    """
    return _logical_not((0.0 < clear)),


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


def nearby(flat: Any, index: Any, last: Any, t: Any, tilt: Any) -> tuple[Any, ...]:
    """1 near the surface that the ball left, where F/t is known better than F; the margin.

    Table 1. 6 operations: 1 multiplication, 2 comparisons, 1 conjunction, 2 selections.
    Returns leaving, margin.
    """
    _s0 = t * tilt
    _s1 = _logical_and((last == index), (_s0 < flat))
    return _where(_s1, 1.0, 0.0), _where(_s1, _s0, flat)


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


def advanced(arrival: Any, certain: Any, end: Any, hit: Any, next: Any, root: Any, step: Any, sure: Any, t: Any, vague: Any) -> tuple[Any, ...]:
    """The search after a step: what it found, whether its window is exhausted, where it is.

    Table 1. 14 operations: 1 subtraction, 1 comparison, 4 conjunctions, 2 disjunctions, 3 complements, 3 selections.
    Returns arrival, certain, exhausted, searching, t.
    """
    _s0 = _logical_not(hit)
    _s1 = _logical_and(_logical_and(_s0, _logical_not(vague)), ((end - t) <= step))
    return _where(hit, _where(sure, root, t), arrival), _logical_or(certain, _logical_and(hit, sure)), _s1, _logical_and(_s0, _logical_not(_s1)), _where(_logical_or(hit, vague), t, next)


def found(arrival: Any) -> tuple[Any, ...]:
    """Whether a search found an arrival.

    Table 1. 1 operation: 1 comparison.
    Returns arrives.
    """
    return arrival < _inf,


def polished(arrival: Any, certain: Any, refined: Any) -> tuple[Any, ...]:
    """A root that is certain, refined.

    Table 1. 1 operation: 1 selection.
    Returns arrival.
    """
    return _where(certain, refined, arrival),


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


def finite_state(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, x: Any, y: Any, z: Any) -> tuple[Any, ...]:
    """Where every number of a state is finite.

    Table 1. 26 operations: 9 absolute values, 9 comparisons, 8 conjunctions.
    Returns finite.
    """
    _s0 = _logical_and(_logical_and(_logical_and(_logical_and((_absolute(x) < _inf), (_absolute(y) < _inf)), (_absolute(z) < _inf)), (_absolute(vx) < _inf)), (_absolute(vy) < _inf))
    _s1 = _logical_and(_logical_and(_logical_and(_logical_and(_s0, (_absolute(vz) < _inf)), (_absolute(wx) < _inf)), (_absolute(wy) < _inf)), (_absolute(wz) < _inf))
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


def doubted(doubt: Any, edge: Any, late: Any, uncertain: Any, when: Any) -> tuple[Any, ...]:
    """1 where a decision up to this event, or which end it is, lies within its error.

    Table 1. 7 operations: 1 addition, 2 comparisons, 1 conjunction, 1 disjunction, 1 complement, 1 selection.
    Returns uncertain.
    """
    _s0 = _where(_logical_or(_logical_and(_logical_not(((late + when) < doubt)), (doubt < _inf)), edge), 1.0, uncertain)
    return _s0,


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


def ring_impact_doubt(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, turn: Any, p_ball_radius: Any, p_ring_restitution: Any, p_ring_friction: Any, p_tangential_restitution: Any, p_restitution_speed: Any) -> tuple[Any, ...]:
    """Where a decision within a contact lies within its error.

    the law's own slack. 86 operations: 15 additions, 11 subtractions, 29 multiplications, 2 divisions, 1 square root, 1 negation, 13 absolute values, 7 comparisons, 2 conjunctions, 1 complement, 4 selections.
    Returns unsure.
    """
    _s0 = 0.4 + (0.4 * p_tangential_restitution)
    _s1 = _absolute(dwx)
    _s2 = _absolute(dwy)
    _s3 = _where(_s1 < _s2, _s2, _s1)
    _s4 = _absolute(dwz)
    _s5 = ((p_ball_radius * ((_absolute(wx) + _absolute(wy)) + _absolute(wz))) + _absolute(vx)) + _absolute(vy)
    _s6 = _s5 + _absolute(vz)
    _s7 = _absolute(dvx)
    _s8 = _absolute(dvy)
    _s9 = _where(_s7 < _s8, _s8, _s7)
    _s10 = _absolute(dvz)
    _s11 = 64.0 * ((((p_ball_radius * _where(_s3 < _s4, _s4, _s3)) + (turn * _s6)) + _where(_s9 < _s10, _s10, _s9)) + (4.440892098500626e-16 * _s6))
    _s12 = ((nx * vx) + (ny * vy)) + (nz * vz)
    _s13 = (vz - (nz * _s12)) - (p_ball_radius * ((ny * wx) - (nx * wy)))
    _s14 = (vy - (ny * _s12)) - (p_ball_radius * ((nx * wz) - (nz * wx)))
    _s15 = (vx - (nx * _s12)) - (p_ball_radius * ((nz * wy) - (ny * wz)))
    _s16 = p_ring_friction * ((1.0 + (p_ring_restitution / (1.0 - (_s12 / p_restitution_speed)))) * _s12)
    _s17 = (_s0 * _sqrt((((_s13 * _s13) + (_s14 * _s14)) + (_s15 * _s15)))) - (-_s16)
    _s18 = _logical_and(_logical_and((0.0 < p_ring_friction), (p_ring_friction < _inf)), _logical_not(((((2.0 * p_ring_friction) + _s0) * _s11) < _absolute(_s17))))
    return _s18,


def ring_impact(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, p_ball_radius: Any, p_ring_restitution: Any, p_ring_friction: Any, p_tangential_restitution: Any, p_restitution_speed: Any) -> tuple[Any, ...]:
    """Velocity and spin after a contact, frame-free.

    momentum, angular momentum and Coulomb's law of friction. 83 operations: 9 additions, 19 subtractions, 43 multiplications, 4 divisions, 1 square root, 1 negation, 3 comparisons, 3 selections.
    Returns vx, vy, vz, wx, wy, wz.
    """
    _s0 = ((nx * vx) + (ny * vy)) + (nz * vz)
    _s1 = vx - (nx * _s0)
    _s2 = _s1 - (p_ball_radius * ((nz * wy) - (ny * wz)))
    _s3 = vz - (nz * _s0)
    _s4 = _s3 - (p_ball_radius * ((ny * wx) - (nx * wy)))
    _s5 = vy - (ny * _s0)
    _s6 = _s5 - (p_ball_radius * ((nx * wz) - (nz * wx)))
    _s7 = ((_s4 * _s4) + (_s6 * _s6)) + (_s2 * _s2)
    _s8 = 0.4 + (0.4 * p_tangential_restitution)
    _s9 = p_ring_restitution / (1.0 - (_s0 / p_restitution_speed))
    _s10 = -(p_ring_friction * ((1.0 + _s9) * _s0))
    _s11 = _where((0.0 < p_ring_friction), _where((p_ring_friction < _inf), _where(((_s7 * (_s8 * _s8)) <= (_s10 * _s10)), _s8, (_s10 / _sqrt(_s7))), _s8), 0.0)
    _s12 = (1.5 * _s11) / p_ball_radius
    return (_s1 - (_s2 * _s11)) - ((nx * _s9) * _s0), (_s5 - (_s6 * _s11)) - ((ny * _s9) * _s0), (_s3 - (_s4 * _s11)) - ((nz * _s9) * _s0), wx + (_s12 * ((ny * _s4) - (nz * _s6))), wy + (_s12 * ((nz * _s2) - (nx * _s4))), wz + (_s12 * ((nx * _s6) - (ny * _s2)))


def carry_ring_impact(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, contacts: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, dnx: Any, dny: Any, dnz: Any, turn: Any, p_ball_radius: Any, p_ring_restitution: Any, p_ring_friction: Any, p_tangential_restitution: Any, p_restitution_speed: Any) -> tuple[Any, ...]:
    """Errors of velocity and spin after a contact, from those before it.

    derivative of the contact with friction, with roundings. 303 operations: 40 additions, 50 subtractions, 121 multiplications, 12 divisions, 1 square root, 8 negations, 18 absolute values, 25 comparisons, 28 selections.
    Returns dvx, dvy, dvz, dwx, dwy, dwz.
    """
    _s0 = ((nx * vx) + (ny * vy)) + (nz * vz)
    _s1 = (((((dnx * vx) + (dny * vy)) + (dnz * vz)) + (dvx * nx)) + (dvy * ny)) + (dvz * nz)
    _s2 = (dvx - (dnx * _s0)) - (nx * _s1)
    _s3 = (vx - (nx * _s0)) - (p_ball_radius * ((nz * wy) - (ny * wz)))
    _s4 = (vz - (nz * _s0)) - (p_ball_radius * ((ny * wx) - (nx * wy)))
    _s5 = (vy - (ny * _s0)) - (p_ball_radius * ((nx * wz) - (nz * wx)))
    _s6 = ((_s4 * _s4) + (_s5 * _s5)) + (_s3 * _s3)
    _s7 = 0.4 + (0.4 * p_tangential_restitution)
    _s8 = 1.0 - (_s0 / p_restitution_speed)
    _s9 = p_ring_restitution / _s8
    _s10 = 1.0 + _s9
    _s11 = -(p_ring_friction * (_s10 * _s0))
    _s12 = -((p_ring_restitution * (-(_s1 / p_restitution_speed))) / (_s8 * _s8))
    _s13 = _sqrt(_s6)
    _s14 = (dvz - (dnz * _s0)) - (nz * _s1)
    _s15 = _s14 - (p_ball_radius * ((((dny * wx) + (dwx * ny)) - (dnx * wy)) - (dwy * nx)))
    _s16 = (dvy - (dny * _s0)) - (ny * _s1)
    _s17 = _s16 - (p_ball_radius * ((((dnx * wz) + (dwz * nx)) - (dnz * wx)) - (dwx * nz)))
    _s18 = _s2 - (p_ball_radius * ((((dnz * wy) + (dwy * nz)) - (dny * wz)) - (dwz * ny)))
    _s19 = ((0.5 * _s11) * ((((2.0 * _s4) * _s15) + ((2.0 * _s5) * _s17)) + ((2.0 * _s3) * _s18))) / (_s13 * _s6)
    _s20 = ((-(p_ring_friction * ((_s10 * _s1) + (_s12 * _s0)))) / _s13) - _s19
    _s21 = (_s6 * (_s7 * _s7)) <= (_s11 * _s11)
    _s22 = p_ring_friction < _inf
    _s23 = 0.0 < p_ring_friction
    _s24 = _where(_s23, _where(_s22, _where(_s21, 0.0, _s20), 0.0), 0.0)
    _s25 = _where(_s23, _where(_s22, _where(_s21, _s7, (_s11 / _s13)), _s7), 0.0)
    _s26 = ((((_s2 - (_s3 * _s24)) - (_s18 * _s25)) - ((dnx * _s9) * _s0)) - ((nx * _s9) * _s1)) - ((nx * _s12) * _s0)
    _s27 = ((p_ball_radius * ((_absolute(wx) + _absolute(wy)) + _absolute(wz))) + _absolute(vx)) + _absolute(vy)
    _s28 = _s27 + _absolute(vz)
    _s29 = 2.220446049250313e-16 * _s28
    _s30 = -_s29
    _s31 = _s26 + _where((_s26 < 0.0), _s30, _s29)
    _s32 = 8.0 + (8.0 * contacts)
    _s33 = _absolute(dwx)
    _s34 = _absolute(dwy)
    _s35 = _where(_s33 < _s34, _s34, _s33)
    _s36 = _absolute(dwz)
    _s37 = _absolute(dvx)
    _s38 = _absolute(dvy)
    _s39 = _where(_s37 < _s38, _s38, _s37)
    _s40 = _absolute(dvz)
    _s41 = ((p_ball_radius * _where(_s35 < _s36, _s36, _s35)) + (turn * _s28)) + _where(_s39 < _s40, _s40, _s39)
    _s42 = _s41 / _s32
    _s43 = -_s42
    _s44 = ((((_s16 - (_s5 * _s24)) - (_s17 * _s25)) - ((dny * _s9) * _s0)) - ((ny * _s9) * _s1)) - ((ny * _s12) * _s0)
    _s45 = _s44 + _where((_s44 < 0.0), _s30, _s29)
    _s46 = ((((_s14 - (_s4 * _s24)) - (_s15 * _s25)) - ((dnz * _s9) * _s0)) - ((nz * _s9) * _s1)) - ((nz * _s12) * _s0)
    _s47 = _s46 + _where((_s46 < 0.0), _s30, _s29)
    _s48 = (1.5 * _s24) / p_ball_radius
    _s49 = (1.5 * _s25) / p_ball_radius
    _s50 = (dwx + (_s48 * ((ny * _s4) - (nz * _s5)))) + (_s49 * ((((dny * _s4) + (ny * _s15)) - (dnz * _s5)) - (nz * _s17)))
    _s51 = _s29 / p_ball_radius
    _s52 = -_s51
    _s53 = _s50 + _where((_s50 < 0.0), _s52, _s51)
    _s54 = _s41 / (p_ball_radius * _s32)
    _s55 = -_s54
    _s56 = (dwy + (_s48 * ((nz * _s3) - (nx * _s4)))) + (_s49 * ((((dnz * _s3) + (nz * _s18)) - (dnx * _s4)) - (nx * _s15)))
    _s57 = _s56 + _where((_s56 < 0.0), _s52, _s51)
    _s58 = (dwz + (_s48 * ((nx * _s5) - (ny * _s3)))) + (_s49 * ((((dnx * _s5) + (nx * _s17)) - (dny * _s3)) - (ny * _s18)))
    _s59 = _s58 + _where((_s58 < 0.0), _s52, _s51)
    return _where((_absolute(_s31) < _s42), _where((_s31 < 0.0), _s43, _s42), _s31), _where((_absolute(_s45) < _s42), _where((_s45 < 0.0), _s43, _s42), _s45), _where((_absolute(_s47) < _s42), _where((_s47 < 0.0), _s43, _s42), _s47), _where((_absolute(_s53) < _s54), _where((_s53 < 0.0), _s55, _s54), _s53), _where((_absolute(_s57) < _s54), _where((_s57 < 0.0), _s55, _s54), _s57), _where((_absolute(_s59) < _s54), _where((_s59 < 0.0), _s55, _s54), _s59)


def backboard_impact_doubt(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, turn: Any, p_ball_radius: Any, p_backboard_restitution: Any, p_backboard_friction: Any, p_tangential_restitution: Any, p_restitution_speed: Any) -> tuple[Any, ...]:
    """Where a decision within a contact lies within its error.

    the law's own slack. 86 operations: 15 additions, 11 subtractions, 29 multiplications, 2 divisions, 1 square root, 1 negation, 13 absolute values, 7 comparisons, 2 conjunctions, 1 complement, 4 selections.
    Returns unsure.
    """
    _s0 = 0.4 + (0.4 * p_tangential_restitution)
    _s1 = _absolute(dwx)
    _s2 = _absolute(dwy)
    _s3 = _where(_s1 < _s2, _s2, _s1)
    _s4 = _absolute(dwz)
    _s5 = ((p_ball_radius * ((_absolute(wx) + _absolute(wy)) + _absolute(wz))) + _absolute(vx)) + _absolute(vy)
    _s6 = _s5 + _absolute(vz)
    _s7 = _absolute(dvx)
    _s8 = _absolute(dvy)
    _s9 = _where(_s7 < _s8, _s8, _s7)
    _s10 = _absolute(dvz)
    _s11 = 64.0 * ((((p_ball_radius * _where(_s3 < _s4, _s4, _s3)) + (turn * _s6)) + _where(_s9 < _s10, _s10, _s9)) + (4.440892098500626e-16 * _s6))
    _s12 = ((nx * vx) + (ny * vy)) + (nz * vz)
    _s13 = (vz - (nz * _s12)) - (p_ball_radius * ((ny * wx) - (nx * wy)))
    _s14 = (vy - (ny * _s12)) - (p_ball_radius * ((nx * wz) - (nz * wx)))
    _s15 = (vx - (nx * _s12)) - (p_ball_radius * ((nz * wy) - (ny * wz)))
    _s16 = p_backboard_friction * ((1.0 + (p_backboard_restitution / (1.0 - (_s12 / p_restitution_speed)))) * _s12)
    _s17 = (_s0 * _sqrt((((_s13 * _s13) + (_s14 * _s14)) + (_s15 * _s15)))) - (-_s16)
    _s18 = _logical_and(_logical_and((0.0 < p_backboard_friction), (p_backboard_friction < _inf)), _logical_not(((((2.0 * p_backboard_friction) + _s0) * _s11) < _absolute(_s17))))
    return _s18,


def backboard_impact(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, p_ball_radius: Any, p_backboard_restitution: Any, p_backboard_friction: Any, p_tangential_restitution: Any, p_restitution_speed: Any) -> tuple[Any, ...]:
    """Velocity and spin after a contact, frame-free.

    momentum, angular momentum and Coulomb's law of friction. 83 operations: 9 additions, 19 subtractions, 43 multiplications, 4 divisions, 1 square root, 1 negation, 3 comparisons, 3 selections.
    Returns vx, vy, vz, wx, wy, wz.
    """
    _s0 = ((nx * vx) + (ny * vy)) + (nz * vz)
    _s1 = vx - (nx * _s0)
    _s2 = _s1 - (p_ball_radius * ((nz * wy) - (ny * wz)))
    _s3 = vz - (nz * _s0)
    _s4 = _s3 - (p_ball_radius * ((ny * wx) - (nx * wy)))
    _s5 = vy - (ny * _s0)
    _s6 = _s5 - (p_ball_radius * ((nx * wz) - (nz * wx)))
    _s7 = ((_s4 * _s4) + (_s6 * _s6)) + (_s2 * _s2)
    _s8 = 0.4 + (0.4 * p_tangential_restitution)
    _s9 = p_backboard_restitution / (1.0 - (_s0 / p_restitution_speed))
    _s10 = -(p_backboard_friction * ((1.0 + _s9) * _s0))
    _s11 = _where((0.0 < p_backboard_friction), _where((p_backboard_friction < _inf), _where(((_s7 * (_s8 * _s8)) <= (_s10 * _s10)), _s8, (_s10 / _sqrt(_s7))), _s8), 0.0)
    _s12 = (1.5 * _s11) / p_ball_radius
    return (_s1 - (_s2 * _s11)) - ((nx * _s9) * _s0), (_s5 - (_s6 * _s11)) - ((ny * _s9) * _s0), (_s3 - (_s4 * _s11)) - ((nz * _s9) * _s0), wx + (_s12 * ((ny * _s4) - (nz * _s6))), wy + (_s12 * ((nz * _s2) - (nx * _s4))), wz + (_s12 * ((nx * _s6) - (ny * _s2)))


def carry_backboard_impact(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, contacts: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, dnx: Any, dny: Any, dnz: Any, turn: Any, p_ball_radius: Any, p_backboard_restitution: Any, p_backboard_friction: Any, p_tangential_restitution: Any, p_restitution_speed: Any) -> tuple[Any, ...]:
    """Errors of velocity and spin after a contact, from those before it.

    derivative of the contact with friction, with roundings. 303 operations: 40 additions, 50 subtractions, 121 multiplications, 12 divisions, 1 square root, 8 negations, 18 absolute values, 25 comparisons, 28 selections.
    Returns dvx, dvy, dvz, dwx, dwy, dwz.
    """
    _s0 = ((nx * vx) + (ny * vy)) + (nz * vz)
    _s1 = (((((dnx * vx) + (dny * vy)) + (dnz * vz)) + (dvx * nx)) + (dvy * ny)) + (dvz * nz)
    _s2 = (dvx - (dnx * _s0)) - (nx * _s1)
    _s3 = (vx - (nx * _s0)) - (p_ball_radius * ((nz * wy) - (ny * wz)))
    _s4 = (vz - (nz * _s0)) - (p_ball_radius * ((ny * wx) - (nx * wy)))
    _s5 = (vy - (ny * _s0)) - (p_ball_radius * ((nx * wz) - (nz * wx)))
    _s6 = ((_s4 * _s4) + (_s5 * _s5)) + (_s3 * _s3)
    _s7 = 0.4 + (0.4 * p_tangential_restitution)
    _s8 = 1.0 - (_s0 / p_restitution_speed)
    _s9 = p_backboard_restitution / _s8
    _s10 = 1.0 + _s9
    _s11 = -(p_backboard_friction * (_s10 * _s0))
    _s12 = -((p_backboard_restitution * (-(_s1 / p_restitution_speed))) / (_s8 * _s8))
    _s13 = _sqrt(_s6)
    _s14 = (dvz - (dnz * _s0)) - (nz * _s1)
    _s15 = _s14 - (p_ball_radius * ((((dny * wx) + (dwx * ny)) - (dnx * wy)) - (dwy * nx)))
    _s16 = (dvy - (dny * _s0)) - (ny * _s1)
    _s17 = _s16 - (p_ball_radius * ((((dnx * wz) + (dwz * nx)) - (dnz * wx)) - (dwx * nz)))
    _s18 = _s2 - (p_ball_radius * ((((dnz * wy) + (dwy * nz)) - (dny * wz)) - (dwz * ny)))
    _s19 = ((0.5 * _s11) * ((((2.0 * _s4) * _s15) + ((2.0 * _s5) * _s17)) + ((2.0 * _s3) * _s18))) / (_s13 * _s6)
    _s20 = ((-(p_backboard_friction * ((_s10 * _s1) + (_s12 * _s0)))) / _s13) - _s19
    _s21 = (_s6 * (_s7 * _s7)) <= (_s11 * _s11)
    _s22 = p_backboard_friction < _inf
    _s23 = 0.0 < p_backboard_friction
    _s24 = _where(_s23, _where(_s22, _where(_s21, 0.0, _s20), 0.0), 0.0)
    _s25 = _where(_s23, _where(_s22, _where(_s21, _s7, (_s11 / _s13)), _s7), 0.0)
    _s26 = ((((_s2 - (_s3 * _s24)) - (_s18 * _s25)) - ((dnx * _s9) * _s0)) - ((nx * _s9) * _s1)) - ((nx * _s12) * _s0)
    _s27 = ((p_ball_radius * ((_absolute(wx) + _absolute(wy)) + _absolute(wz))) + _absolute(vx)) + _absolute(vy)
    _s28 = _s27 + _absolute(vz)
    _s29 = 2.220446049250313e-16 * _s28
    _s30 = -_s29
    _s31 = _s26 + _where((_s26 < 0.0), _s30, _s29)
    _s32 = 8.0 + (8.0 * contacts)
    _s33 = _absolute(dwx)
    _s34 = _absolute(dwy)
    _s35 = _where(_s33 < _s34, _s34, _s33)
    _s36 = _absolute(dwz)
    _s37 = _absolute(dvx)
    _s38 = _absolute(dvy)
    _s39 = _where(_s37 < _s38, _s38, _s37)
    _s40 = _absolute(dvz)
    _s41 = ((p_ball_radius * _where(_s35 < _s36, _s36, _s35)) + (turn * _s28)) + _where(_s39 < _s40, _s40, _s39)
    _s42 = _s41 / _s32
    _s43 = -_s42
    _s44 = ((((_s16 - (_s5 * _s24)) - (_s17 * _s25)) - ((dny * _s9) * _s0)) - ((ny * _s9) * _s1)) - ((ny * _s12) * _s0)
    _s45 = _s44 + _where((_s44 < 0.0), _s30, _s29)
    _s46 = ((((_s14 - (_s4 * _s24)) - (_s15 * _s25)) - ((dnz * _s9) * _s0)) - ((nz * _s9) * _s1)) - ((nz * _s12) * _s0)
    _s47 = _s46 + _where((_s46 < 0.0), _s30, _s29)
    _s48 = (1.5 * _s24) / p_ball_radius
    _s49 = (1.5 * _s25) / p_ball_radius
    _s50 = (dwx + (_s48 * ((ny * _s4) - (nz * _s5)))) + (_s49 * ((((dny * _s4) + (ny * _s15)) - (dnz * _s5)) - (nz * _s17)))
    _s51 = _s29 / p_ball_radius
    _s52 = -_s51
    _s53 = _s50 + _where((_s50 < 0.0), _s52, _s51)
    _s54 = _s41 / (p_ball_radius * _s32)
    _s55 = -_s54
    _s56 = (dwy + (_s48 * ((nz * _s3) - (nx * _s4)))) + (_s49 * ((((dnz * _s3) + (nz * _s18)) - (dnx * _s4)) - (nx * _s15)))
    _s57 = _s56 + _where((_s56 < 0.0), _s52, _s51)
    _s58 = (dwz + (_s48 * ((nx * _s5) - (ny * _s3)))) + (_s49 * ((((dnx * _s5) + (nx * _s17)) - (dny * _s3)) - (ny * _s18)))
    _s59 = _s58 + _where((_s58 < 0.0), _s52, _s51)
    return _where((_absolute(_s31) < _s42), _where((_s31 < 0.0), _s43, _s42), _s31), _where((_absolute(_s45) < _s42), _where((_s45 < 0.0), _s43, _s42), _s45), _where((_absolute(_s47) < _s42), _where((_s47 < 0.0), _s43, _s42), _s47), _where((_absolute(_s53) < _s54), _where((_s53 < 0.0), _s55, _s54), _s53), _where((_absolute(_s57) < _s54), _where((_s57 < 0.0), _s55, _s54), _s57), _where((_absolute(_s59) < _s54), _where((_s59 < 0.0), _s55, _s54), _s59)


def bridge_impact_doubt(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, turn: Any, p_ball_radius: Any, p_bridge_restitution: Any, p_bridge_friction: Any, p_tangential_restitution: Any, p_restitution_speed: Any) -> tuple[Any, ...]:
    """Where a decision within a contact lies within its error.

    the law's own slack. 86 operations: 15 additions, 11 subtractions, 29 multiplications, 2 divisions, 1 square root, 1 negation, 13 absolute values, 7 comparisons, 2 conjunctions, 1 complement, 4 selections.
    Returns unsure.
    """
    _s0 = 0.4 + (0.4 * p_tangential_restitution)
    _s1 = _absolute(dwx)
    _s2 = _absolute(dwy)
    _s3 = _where(_s1 < _s2, _s2, _s1)
    _s4 = _absolute(dwz)
    _s5 = ((p_ball_radius * ((_absolute(wx) + _absolute(wy)) + _absolute(wz))) + _absolute(vx)) + _absolute(vy)
    _s6 = _s5 + _absolute(vz)
    _s7 = _absolute(dvx)
    _s8 = _absolute(dvy)
    _s9 = _where(_s7 < _s8, _s8, _s7)
    _s10 = _absolute(dvz)
    _s11 = 64.0 * ((((p_ball_radius * _where(_s3 < _s4, _s4, _s3)) + (turn * _s6)) + _where(_s9 < _s10, _s10, _s9)) + (4.440892098500626e-16 * _s6))
    _s12 = ((nx * vx) + (ny * vy)) + (nz * vz)
    _s13 = (vz - (nz * _s12)) - (p_ball_radius * ((ny * wx) - (nx * wy)))
    _s14 = (vy - (ny * _s12)) - (p_ball_radius * ((nx * wz) - (nz * wx)))
    _s15 = (vx - (nx * _s12)) - (p_ball_radius * ((nz * wy) - (ny * wz)))
    _s16 = p_bridge_friction * ((1.0 + (p_bridge_restitution / (1.0 - (_s12 / p_restitution_speed)))) * _s12)
    _s17 = (_s0 * _sqrt((((_s13 * _s13) + (_s14 * _s14)) + (_s15 * _s15)))) - (-_s16)
    _s18 = _logical_and(_logical_and((0.0 < p_bridge_friction), (p_bridge_friction < _inf)), _logical_not(((((2.0 * p_bridge_friction) + _s0) * _s11) < _absolute(_s17))))
    return _s18,


def bridge_impact(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, p_ball_radius: Any, p_bridge_restitution: Any, p_bridge_friction: Any, p_tangential_restitution: Any, p_restitution_speed: Any) -> tuple[Any, ...]:
    """Velocity and spin after a contact, frame-free.

    momentum, angular momentum and Coulomb's law of friction. 83 operations: 9 additions, 19 subtractions, 43 multiplications, 4 divisions, 1 square root, 1 negation, 3 comparisons, 3 selections.
    Returns vx, vy, vz, wx, wy, wz.
    """
    _s0 = ((nx * vx) + (ny * vy)) + (nz * vz)
    _s1 = vx - (nx * _s0)
    _s2 = _s1 - (p_ball_radius * ((nz * wy) - (ny * wz)))
    _s3 = vz - (nz * _s0)
    _s4 = _s3 - (p_ball_radius * ((ny * wx) - (nx * wy)))
    _s5 = vy - (ny * _s0)
    _s6 = _s5 - (p_ball_radius * ((nx * wz) - (nz * wx)))
    _s7 = ((_s4 * _s4) + (_s6 * _s6)) + (_s2 * _s2)
    _s8 = 0.4 + (0.4 * p_tangential_restitution)
    _s9 = p_bridge_restitution / (1.0 - (_s0 / p_restitution_speed))
    _s10 = -(p_bridge_friction * ((1.0 + _s9) * _s0))
    _s11 = _where((0.0 < p_bridge_friction), _where((p_bridge_friction < _inf), _where(((_s7 * (_s8 * _s8)) <= (_s10 * _s10)), _s8, (_s10 / _sqrt(_s7))), _s8), 0.0)
    _s12 = (1.5 * _s11) / p_ball_radius
    return (_s1 - (_s2 * _s11)) - ((nx * _s9) * _s0), (_s5 - (_s6 * _s11)) - ((ny * _s9) * _s0), (_s3 - (_s4 * _s11)) - ((nz * _s9) * _s0), wx + (_s12 * ((ny * _s4) - (nz * _s6))), wy + (_s12 * ((nz * _s2) - (nx * _s4))), wz + (_s12 * ((nx * _s6) - (ny * _s2)))


def carry_bridge_impact(vx: Any, vy: Any, vz: Any, wx: Any, wy: Any, wz: Any, nx: Any, ny: Any, nz: Any, contacts: Any, dvx: Any, dvy: Any, dvz: Any, dwx: Any, dwy: Any, dwz: Any, dnx: Any, dny: Any, dnz: Any, turn: Any, p_ball_radius: Any, p_bridge_restitution: Any, p_bridge_friction: Any, p_tangential_restitution: Any, p_restitution_speed: Any) -> tuple[Any, ...]:
    """Errors of velocity and spin after a contact, from those before it.

    derivative of the contact with friction, with roundings. 303 operations: 40 additions, 50 subtractions, 121 multiplications, 12 divisions, 1 square root, 8 negations, 18 absolute values, 25 comparisons, 28 selections.
    Returns dvx, dvy, dvz, dwx, dwy, dwz.
    """
    _s0 = ((nx * vx) + (ny * vy)) + (nz * vz)
    _s1 = (((((dnx * vx) + (dny * vy)) + (dnz * vz)) + (dvx * nx)) + (dvy * ny)) + (dvz * nz)
    _s2 = (dvx - (dnx * _s0)) - (nx * _s1)
    _s3 = (vx - (nx * _s0)) - (p_ball_radius * ((nz * wy) - (ny * wz)))
    _s4 = (vz - (nz * _s0)) - (p_ball_radius * ((ny * wx) - (nx * wy)))
    _s5 = (vy - (ny * _s0)) - (p_ball_radius * ((nx * wz) - (nz * wx)))
    _s6 = ((_s4 * _s4) + (_s5 * _s5)) + (_s3 * _s3)
    _s7 = 0.4 + (0.4 * p_tangential_restitution)
    _s8 = 1.0 - (_s0 / p_restitution_speed)
    _s9 = p_bridge_restitution / _s8
    _s10 = 1.0 + _s9
    _s11 = -(p_bridge_friction * (_s10 * _s0))
    _s12 = -((p_bridge_restitution * (-(_s1 / p_restitution_speed))) / (_s8 * _s8))
    _s13 = _sqrt(_s6)
    _s14 = (dvz - (dnz * _s0)) - (nz * _s1)
    _s15 = _s14 - (p_ball_radius * ((((dny * wx) + (dwx * ny)) - (dnx * wy)) - (dwy * nx)))
    _s16 = (dvy - (dny * _s0)) - (ny * _s1)
    _s17 = _s16 - (p_ball_radius * ((((dnx * wz) + (dwz * nx)) - (dnz * wx)) - (dwx * nz)))
    _s18 = _s2 - (p_ball_radius * ((((dnz * wy) + (dwy * nz)) - (dny * wz)) - (dwz * ny)))
    _s19 = ((0.5 * _s11) * ((((2.0 * _s4) * _s15) + ((2.0 * _s5) * _s17)) + ((2.0 * _s3) * _s18))) / (_s13 * _s6)
    _s20 = ((-(p_bridge_friction * ((_s10 * _s1) + (_s12 * _s0)))) / _s13) - _s19
    _s21 = (_s6 * (_s7 * _s7)) <= (_s11 * _s11)
    _s22 = p_bridge_friction < _inf
    _s23 = 0.0 < p_bridge_friction
    _s24 = _where(_s23, _where(_s22, _where(_s21, 0.0, _s20), 0.0), 0.0)
    _s25 = _where(_s23, _where(_s22, _where(_s21, _s7, (_s11 / _s13)), _s7), 0.0)
    _s26 = ((((_s2 - (_s3 * _s24)) - (_s18 * _s25)) - ((dnx * _s9) * _s0)) - ((nx * _s9) * _s1)) - ((nx * _s12) * _s0)
    _s27 = ((p_ball_radius * ((_absolute(wx) + _absolute(wy)) + _absolute(wz))) + _absolute(vx)) + _absolute(vy)
    _s28 = _s27 + _absolute(vz)
    _s29 = 2.220446049250313e-16 * _s28
    _s30 = -_s29
    _s31 = _s26 + _where((_s26 < 0.0), _s30, _s29)
    _s32 = 8.0 + (8.0 * contacts)
    _s33 = _absolute(dwx)
    _s34 = _absolute(dwy)
    _s35 = _where(_s33 < _s34, _s34, _s33)
    _s36 = _absolute(dwz)
    _s37 = _absolute(dvx)
    _s38 = _absolute(dvy)
    _s39 = _where(_s37 < _s38, _s38, _s37)
    _s40 = _absolute(dvz)
    _s41 = ((p_ball_radius * _where(_s35 < _s36, _s36, _s35)) + (turn * _s28)) + _where(_s39 < _s40, _s40, _s39)
    _s42 = _s41 / _s32
    _s43 = -_s42
    _s44 = ((((_s16 - (_s5 * _s24)) - (_s17 * _s25)) - ((dny * _s9) * _s0)) - ((ny * _s9) * _s1)) - ((ny * _s12) * _s0)
    _s45 = _s44 + _where((_s44 < 0.0), _s30, _s29)
    _s46 = ((((_s14 - (_s4 * _s24)) - (_s15 * _s25)) - ((dnz * _s9) * _s0)) - ((nz * _s9) * _s1)) - ((nz * _s12) * _s0)
    _s47 = _s46 + _where((_s46 < 0.0), _s30, _s29)
    _s48 = (1.5 * _s24) / p_ball_radius
    _s49 = (1.5 * _s25) / p_ball_radius
    _s50 = (dwx + (_s48 * ((ny * _s4) - (nz * _s5)))) + (_s49 * ((((dny * _s4) + (ny * _s15)) - (dnz * _s5)) - (nz * _s17)))
    _s51 = _s29 / p_ball_radius
    _s52 = -_s51
    _s53 = _s50 + _where((_s50 < 0.0), _s52, _s51)
    _s54 = _s41 / (p_ball_radius * _s32)
    _s55 = -_s54
    _s56 = (dwy + (_s48 * ((nz * _s3) - (nx * _s4)))) + (_s49 * ((((dnz * _s3) + (nz * _s18)) - (dnx * _s4)) - (nx * _s15)))
    _s57 = _s56 + _where((_s56 < 0.0), _s52, _s51)
    _s58 = (dwz + (_s48 * ((nx * _s5) - (ny * _s3)))) + (_s49 * ((((dnx * _s5) + (nx * _s17)) - (dny * _s3)) - (ny * _s18)))
    _s59 = _s58 + _where((_s58 < 0.0), _s52, _s51)
    return _where((_absolute(_s31) < _s42), _where((_s31 < 0.0), _s43, _s42), _s31), _where((_absolute(_s45) < _s42), _where((_s45 < 0.0), _s43, _s42), _s45), _where((_absolute(_s47) < _s42), _where((_s47 < 0.0), _s43, _s42), _s47), _where((_absolute(_s53) < _s54), _where((_s53 < 0.0), _s55, _s54), _s53), _where((_absolute(_s57) < _s54), _where((_s57 < 0.0), _s55, _s54), _s57), _where((_absolute(_s59) < _s54), _where((_s59 < 0.0), _s55, _s54), _s59)


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


def ring_normal(x: Any, y: Any, z: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any) -> tuple[Any, ...]:
    """Outward unit normal n3 at a contact.

    Table 2. 13 operations: 2 additions, 1 subtraction, 7 multiplications, 2 divisions, 1 square root.
    Returns nx, ny, nz.
    """
    _s0 = 1.0 / (p_ball_radius + p_wire_radius)
    _s1 = _sqrt(((x * x) + (y * y)))
    _s2 = (_s0 * (_s1 - p_ring_radius)) * (1.0 / _s1)
    return x * _s2, y * _s2, z * _s0


def ring_curvature(p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any) -> tuple[Any, ...]:
    """Bound on the rate at which the normal turns along the contact surface.

    Table 2. 6 operations: 1 addition, 2 subtractions, 1 division, 1 comparison, 1 selection.
    Returns curvature.
    """
    _s0 = (p_ring_radius - p_ball_radius) - p_wire_radius
    _s1 = p_ball_radius + p_wire_radius
    return 1.0 / _where(_s0 < _s1, _s0, _s1),


def ring_carry_normal(x: Any, y: Any, dx: Any, dy: Any, dz: Any, shift: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any) -> tuple[Any, ...]:
    """Error of the normal, from that of the position.

    derivative of Table 2's normal. 38 operations: 6 additions, 3 subtractions, 21 multiplications, 4 divisions, 1 square root, 1 negation, 1 comparison, 1 selection.
    Returns dnx, dny, dnz, turn.
    """
    _s0 = p_ball_radius + p_wire_radius
    _s1 = 1.0 / _s0
    _s2 = _sqrt(((x * x) + (y * y)))
    _s3 = _s2 - p_ring_radius
    _s4 = 1.0 / _s2
    _s5 = (_s1 * _s3) * _s4
    _s6 = (0.5 * (((2.0 * dx) * x) + ((2.0 * dy) * y))) / _s2
    _s7 = ((_s6 * _s1) * _s4) + (((-(_s6 * (_s4 * _s4))) * _s1) * _s3)
    _s8 = (p_ring_radius - p_ball_radius) - p_wire_radius
    return (dx * _s5) + (x * _s7), (dy * _s5) + (y * _s7), dz * _s1, shift * (1.0 / _where(_s8 < _s0, _s8, _s0))


def ring_clear(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Positive if there certainly is no contact before the horizon.

    bounds of the event condition. 161 operations: 31 additions, 19 subtractions, 74 multiplications, 1 division, 4 square roots, 16 comparisons, 16 selections.
    Returns clear.
    """
    _s0 = p_ball_radius + p_wire_radius
    _s1 = (0.000244140625 * p_ring_radius) - (p_ring_radius - _s0)
    _s2 = 1.0 / p_gravity
    _s3 = _sqrt(2.0) * _sqrt((_s2 * (((2.0 * p_ball_radius) + extent) + (2.0 * p_wire_radius))))
    _s4 = _s3 + ((2.0 * speed) * _s2)
    _s5 = ((position_error + (velocity_error * _where(_s4 < horizon, _s4, horizon))) - (1.52587890625e-05 * p_ball_radius)) - (1.52587890625e-05 * p_wire_radius)
    _s6 = 1.00006103515625 * _s0
    _s7 = p_ring_radius + _s6
    _s8 = vz * vz
    _s9 = _s8 + ((2.0 * p_gravity) * (z - _s6))
    _s10 = _sqrt(_s9)
    _s11 = _s2 * (vz - _s10)
    _s12 = _s2 * (vz + _s10)
    _s13 = x + (vx * _s12)
    _s14 = y + (vy * _s12)
    _s15 = (_s13 * _s13) + (_s14 * _s14)
    _s16 = _sqrt(_s15)
    _s17 = _s16 - p_ring_radius
    _s18 = z + ((vz - ((0.5 * p_gravity) * _s12)) * _s12)
    _s19 = _s7 * _s7
    _s20 = 9.313225746154785e-10 * _s19
    _s21 = (((_s17 * _s17) + (_s18 * _s18)) - (_s0 * _s0)) - _s20
    _s22 = (vx * vx) + (vy * vy)
    _s23 = p_ring_radius - _s6
    _s24 = 0.0001220703125 * p_ring_radius
    _s25 = _where(_s23 < _s24, _s24, _s23)
    _s26 = _s25 * _s25
    _s27 = _s25 * _s26
    _s28 = ((((2.0 * _s8) + ((4.0 * p_gravity) * z)) + (2.0 * _s22)) - ((6.0003662109375 * p_gravity) * _s0)) * _s27
    _s29 = (vy * x) - (vx * y)
    _s30 = _s29 * _s29
    _s31 = _s28 - ((2.0 * p_ring_radius) * _s30)
    _s32 = (_s17 * ((vx * _s13) + (vy * _s14))) + ((_s18 * (vz - (p_gravity * _s12))) * _s16)
    _s33 = x + (horizon * vx)
    _s34 = y + (horizon * vy)
    _s35 = _where(((((_s20 + (_s33 * _s33)) + (_s34 * _s34)) - _s26) < 0.0), 1.0, _where((((_s22 * (_s20 + _s26)) - _s30) < 0.0), 1.0, 0.0))
    _s36 = _where(((((4.0 * (_s32 * _s32)) * _s27) - (((2.0 * _s31) * _s15) * _s21)) < 0.0), _s35, 0.0)
    _s37 = _where((horizon < (_s12 - (9.313225746154785e-10 * horizon))), 1.0, _where((0.0 < _s21), _where((0.0 < _s31), _s36, 0.0), 0.0))
    _s38 = (vx * x) + (vy * y)
    _s39 = (_s11 * _s22) + _s38
    _s40 = _where((_s39 < 0.0), _where((_s19 < ((_s11 * (_s38 + _s39)) + ((x * x) + (y * y)))), _s37, 0.0), 0.0)
    _s41 = _where(((extent + (horizon * (speed + (p_gravity * horizon)))) < (65536.0 * _s7)), _where((0.0 < _s9), _where((_s11 < 0.0), _s37, _s40), 0.0), 0.0)
    return _where((0.0 < _where(_s1 < _s5, _s5, _s1)), 0.0, _where(((position_error + (horizon * velocity_error)) < (5.820766091346741e-11 * _s7)), _s41, 0.0)),


def ring_prepare(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Constants and windows of the search along a flight, and the errors it allows for.

    bounds of the event condition. 190 operations: 31 additions, 20 subtractions, 54 multiplications, 3 divisions, 7 square roots, 1 negation, 5 absolute values, 31 comparisons, 38 selections.
    Returns steady, swing, rho_start, low0, high0, low1, high1, low2, high2, ceiling, latest, lost.
    """
    _s0 = vz * vz
    _s1 = (vx * vx) + (vy * vy)
    _s2 = ((2.0 * _s0) + ((4.0 * p_gravity) * z)) + (2.0 * _s1)
    _s3 = (vy * x) - (vx * y)
    _s4 = _s3 * _s3
    _s5 = (2.0 * p_ring_radius) * _s4
    _s6 = (x * x) + (y * y)
    _s7 = p_ball_radius + p_wire_radius
    _s8 = 1.00006103515625 * _s7
    _s9 = 2.0 * p_gravity
    _s10 = 8.881784197001252e-16 * (_s0 + (_s9 * (_absolute(z) + _s8)))
    _s11 = (_s0 + (_s9 * (z + _s8))) + _s10
    _s12 = 1.0 / p_gravity
    _s13 = _sqrt(_s11)
    _s14 = 1.7763568394002505e-15 * (_absolute(vz) + _s13)
    _s15 = 0.0 <= _s11
    _s16 = _where(_s15, (_s12 * ((vz - _s13) - _s14)), _inf)
    _s17 = p_ring_radius + _s8
    _s18 = _s17 * _s17
    _s19 = (1.7763568394002505e-15 * _s1) * (_s18 + _s6)
    _s20 = ((_s18 * _s1) + _s19) - _s4
    _s21 = (vx * x) + (vy * y)
    _s22 = _sqrt(_s20)
    _s23 = 1.7763568394002505e-15 * ((_absolute(_s21) + _absolute(_s3)) + _s22)
    _s24 = 1.0 / _s1
    _s25 = 0.0 <= _s20
    _s26 = 2.409919865102884e-181 < _s1
    _s27 = _where(_s26, _where(_s25, ((-((_s21 + _s22) + _s23)) * _s24), _inf), (-_inf))
    _s28 = _where(_s16 < _s27, _s27, _s16)
    _s29 = p_ring_radius - _s8
    _s30 = 0.0001220703125 * p_ring_radius
    _s31 = _where(_s29 < _s30, _s30, _s29)
    _s32 = ((_s1 * (_s31 * _s31)) - _s19) - _s4
    _s33 = _sqrt(_where(_s32 < 0.0, 0.0, _s32))
    _s34 = _where(_s26, _where(_s25, (((_s22 + _s23) - _s21) * _s24), (-_inf)), _inf)
    _s35 = 0.0 < _where(_s26, _s32, 0.0)
    _s36 = _where(_s35, (((_s23 - _s21) - _s33) * _s24), _s34)
    _s37 = (_s0 + (_s9 * (z - _s8))) - _s10
    _s38 = _sqrt(_where(_s37 < 0.0, 0.0, _s37))
    _s39 = _where(_s15, (_s12 * ((vz + _s13) + _s14)), (-_inf))
    _s40 = 0.0 < _s37
    _s41 = _where(_s40, (_s12 * ((vz + _s14) - _s38)), _s39)
    _s42 = _where(_s36 < _s41, _s36, _s41)
    _s43 = _where(_s35, (((_s33 - _s21) - _s23) * _s24), _inf)
    _s44 = _where(_s43 < _s36, _s36, _s43)
    _s45 = _where(_s16 < _s44, _s44, _s16)
    _s46 = _where(_s34 < _s41, _s34, _s41)
    _s47 = _where(_s40, (_s12 * ((vz + _s38) - _s14)), _inf)
    _s48 = _where(_s47 < _s41, _s41, _s47)
    _s49 = _s45 <= _s46
    _s50 = _where(_s49, _s45, _where(_s48 < _s27, _s27, _s48))
    _s51 = _where(_s49, _s46, _where(_s36 < _s39, _s36, _s39))
    _s52 = _where(_s48 < _s44, _s44, _s48)
    _s53 = _where(_s34 < _s39, _s34, _s39)
    _s54 = 1.0 / _s31
    _s55 = _where(0.0 < _s42, _s42, 0.0)
    _s56 = _where(_s55 < _s51, _s51, _s55)
    _s57 = _where(_s56 < _s53, _s53, _s56)
    _s58 = (0.000244140625 * p_ring_radius) - (p_ring_radius - _s7)
    _s59 = _sqrt(2.0) * _sqrt((_s12 * (((2.0 * p_ball_radius) + extent) + (2.0 * p_wire_radius))))
    _s60 = _s59 + ((2.0 * speed) * _s12)
    _s61 = ((position_error + (velocity_error * _where(_s60 < horizon, _s60, horizon))) - (1.52587890625e-05 * p_ball_radius)) - (1.52587890625e-05 * p_wire_radius)
    return _s2, _s5, _sqrt(_s6), _where(0.0 < _s28, _s28, 0.0), _where(_s42 < horizon, _s42, horizon), _where(0.0 < _s50, _s50, 0.0), _where(_s51 < horizon, _s51, horizon), _where(0.0 < _s52, _s52, 0.0), _where(_s53 < horizon, _s53, horizon), (((6.0003662109375 * p_gravity) * _s7) + (_s5 * (_s54 * (_s54 * _s54)))) + _absolute(_s2), _where(_s57 < horizon, _s57, horizon), _where(_s58 < _s61, _s61, _s58)


def ring_margins(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.

    running error analysis. 47 operations: 14 additions, 1 subtraction, 27 multiplications, 1 division, 2 comparisons, 2 selections.
    Returns margin, leaving_margin, rate_margin.
    """
    _s0 = p_ball_radius + p_wire_radius
    _s1 = speed + (p_gravity * horizon)
    _s2 = 1.00006103515625 * _s0
    _s3 = _s2 * _s1
    _s4 = p_ring_radius + _s2
    _s5 = extent + (horizon * _s1)
    _s6 = (position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * _s5)
    _s7 = p_ring_radius - _s2
    _s8 = 0.0001220703125 * p_ring_radius
    _s9 = _s2 / _where(_s7 < _s8, _s8, _s7)
    _s10 = _where(1.0 < _s9, _s9, 1.0)
    _s11 = 5.0 * (((_s1 * _s10) * _s6) + (_s2 * (velocity_error + (2.220446049250313e-16 * _s1))))
    _s12 = 1.0009765625 * ((((3.552713678800501e-15 * _s1) * ((_s5 * _s10) + _s4)) + (4.440892098500626e-16 * _s3)) + _s11)
    return 1.0009765625 * ((((4.440892098500626e-16 * horizon) * _s3) + ((1.3323489447131243e-15 * _s0) * _s4)) + ((5.00030517578125 * _s0) * _s6)), _s12, 1.0009765625 * ((3.552713678800501e-15 * (_s4 * _s1)) + _s11)


def ring_refine(t: Any, leaving: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, rho_start: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Newton's next value of a root near t, and the rate there.

    Newton's method. 56 operations: 15 additions, 6 subtractions, 30 multiplications, 2 divisions, 1 square root, 1 comparison, 1 selection.
    Returns time, rate.
    """
    _s0 = x + (t * vx)
    _s1 = y + (t * vy)
    _s2 = _sqrt(((_s0 * _s0) + (_s1 * _s1)))
    _s3 = rho_start + _s2
    _s4 = 1.0 / (_s3 * _s2)
    _s5 = _s2 - p_ring_radius
    _s6 = vz - ((0.5 * p_gravity) * t)
    _s7 = z + (t * _s6)
    _s8 = 2.0 * ((((_s3 * _s4) * ((vx * _s0) + (vy * _s1))) * _s5) + ((vz - (p_gravity * t)) * _s7))
    _s9 = (((t * ((vx * vx) + (vy * vy))) + (2.0 * ((vx * x) + (vy * y)))) * ((rho_start - p_ring_radius) + _s5)) * (_s2 * _s4)
    _s10 = p_ball_radius + p_wire_radius
    _s11 = _where((0.0 < leaving), (t * (_s9 + ((z + _s7) * _s6))), (((_s5 * _s5) + (_s7 * _s7)) - (_s10 * _s10))) / _s8
    return t - _s11, _s8


def ring_advance(t: Any, end: Any, leaving: Any, margin: Any, rate_margin: Any, ceiling: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, steady: Any, swing: Any, rho_start: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Gap, rate, bend, a step without a root and its end, Newton's root and its clearance.

    Newton from the left under a curvature bound. 146 operations: 28 additions, 17 subtractions, 55 multiplications, 5 divisions, 2 square roots, 2 negations, 2 absolute values, 16 comparisons, 19 selections.
    Returns gap, rate, bend, step, next, root, clearance.
    """
    _s0 = x + (t * vx)
    _s1 = y + (t * vy)
    _s2 = _sqrt(((_s0 * _s0) + (_s1 * _s1)))
    _s3 = _s2 - p_ring_radius
    _s4 = rho_start + _s2
    _s5 = 1.0 / (_s4 * _s2)
    _s6 = (((t * ((vx * vx) + (vy * vy))) + (2.0 * ((vx * x) + (vy * y)))) * ((rho_start - p_ring_radius) + _s3)) * (_s2 * _s5)
    _s7 = vz - ((0.5 * p_gravity) * t)
    _s8 = z + (t * _s7)
    _s9 = p_ball_radius + p_wire_radius
    _s10 = _where((0.0 < leaving), (t * (_s6 + ((z + _s8) * _s7))), (((_s3 * _s3) + (_s8 * _s8)) - (_s9 * _s9)))
    _s11 = _s4 * _s5
    _s12 = _s11 * ((vx * _s0) + (vy * _s1))
    _s13 = vz - (p_gravity * t)
    _s14 = (_s12 * _s3) + (_s13 * _s8)
    _s15 = 2.0 * _s14
    _s16 = 6.0 * p_gravity
    _s17 = _s16 * _s8
    _s18 = swing * (_s11 * (_s11 * _s11))
    _s19 = 1.00006103515625 * _s9
    _s20 = _s15 - rate_margin
    _s21 = _s10 - margin
    _s22 = _where(_s21 < 0.0, 0.0, _s21)
    _s23 = (_s17 + _s18) - steady
    _s24 = _s20 < 0.0
    _s25 = 2.0 * _s22
    _s26 = _where((0.0 < _where((0.0 <= _s20), _s22, 0.0)), _inf, (_where(_s24, _s25, (4.0 * _s20)) / _where(_s24, (-_s20), _where(0.0 < _s23, _s23, 0.0))))
    _s27 = end - t
    _s28 = _where(_s26 < _s27, _s26, _s27)
    _s29 = (_s28 * _where(_s13 < 0.0, 0.0, _s13)) + _s8
    _s30 = _s16 * _where(_s19 < _s29, _s19, _s29)
    _s31 = ((_s28 * _where(0.0 < _s12, 0.0, _s12)) + _s2) - (9.094947017729282e-13 * (p_ring_radius + _s19))
    _s32 = p_ring_radius - _s19
    _s33 = 0.0001220703125 * p_ring_radius
    _s34 = _where(_s32 < _s33, _s33, _s32)
    _s35 = 1.0 / _where(_s31 < _s34, _s34, _s31)
    _s36 = swing * (_s35 * (_s35 * _s35))
    _s37 = ((_s30 + _s36) + (9.094947017729282e-13 * ((_s36 + _absolute(steady)) + _absolute(_s30)))) - steady
    _s38 = ((2.0 * _s37) * _s22) + (_s20 * _s20)
    _s39 = _sqrt(_s38)
    _s40 = _where((0.0 <= _s38), (_where(_s24, _s25, (_s20 + _s39)) / _where(_s24, (_s39 - _s20), _where(0.0 < _s37, _s37, 0.0))), _inf)
    _s41 = _where(_s40 < _s28, _s40, _s28)
    _s42 = -(rate_margin + _s15)
    return _s10, _s15, (steady - _s17) - _s18, _s41, t + _s41, t - ((0.5 * _s10) / _s14), _where((0.0 < _s42), ((_s42 * _s42) - ((8.0 * ceiling) * (margin + (32.0 * _s22)))), _s42)


def ring_enter(after: Any, end: Any, high0: Any, high1: Any, high2: Any, low0: Any, low1: Any, low2: Any, t: Any) -> tuple[Any, ...]:
    """The first window that begins no earlier than a time, if there is one.

    Table 1. 18 operations: 6 comparisons, 3 conjunctions, 3 disjunctions, 6 selections.
    Returns t, end, searching.
    """
    _s0 = _logical_and((low0 < high0), (after <= low0))
    _s1 = _logical_and((low1 < high1), (after <= low1))
    _s2 = _logical_and((low2 < high2), (after <= low2))
    return _where(_s0, low0, _where(_s1, low1, _where(_s2, low2, t))), _where(_s0, high0, _where(_s1, high1, _where(_s2, high2, end))), _logical_or(_logical_or(_logical_or(False, _s2), _s1), _s0)


def backboard_normal(x: Any, y: Any, z: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any) -> tuple[Any, ...]:
    """Outward unit normal n3 at a contact.

    Table 2. 28 operations: 4 additions, 6 subtractions, 3 multiplications, 1 division, 2 negations, 6 comparisons, 6 selections.
    Returns nx, ny, nz.
    """
    _s0 = 1.0 / p_ball_radius
    _s1 = p_board_distance + x
    _s2 = -((p_board_distance + p_board_thickness) + x)
    _s3 = y - p_board_half_width
    _s4 = -(p_board_half_width + y)
    _s5 = z - p_board_top
    _s6 = p_board_bottom - z
    return _s0 * (_where(_s1 < 0.0, 0.0, _s1) - _where(_s2 < 0.0, 0.0, _s2)), _s0 * (_where(_s3 < 0.0, 0.0, _s3) - _where(_s4 < 0.0, 0.0, _s4)), _s0 * (_where(_s5 < 0.0, 0.0, _s5) - _where(_s6 < 0.0, 0.0, _s6))


def backboard_curvature(p_ball_radius: Any) -> tuple[Any, ...]:
    """Bound on the rate at which the normal turns along the contact surface.

    Table 2. 1 operation: 1 division.
    Returns curvature.
    """
    return 1.0 / p_ball_radius,


def backboard_carry_normal(x: Any, y: Any, z: Any, dx: Any, dy: Any, dz: Any, shift: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any) -> tuple[Any, ...]:
    """Error of the normal, from that of the position.

    derivative of Table 2's normal. 32 operations: 4 additions, 6 subtractions, 4 multiplications, 1 division, 5 negations, 6 comparisons, 6 selections.
    Returns dnx, dny, dnz, turn.
    """
    _s0 = 1.0 / p_ball_radius
    _s1 = _where(((p_board_distance + x) < 0.0), 0.0, dx) - _where(((-((p_board_distance + p_board_thickness) + x)) < 0.0), 0.0, (-dx))
    _s2 = _s0 * (_where(((y - p_board_half_width) < 0.0), 0.0, dy) - _where(((-(p_board_half_width + y)) < 0.0), 0.0, (-dy)))
    return _s0 * _s1, _s2, _s0 * (_where(((z - p_board_top) < 0.0), 0.0, dz) - _where(((p_board_bottom - z) < 0.0), 0.0, (-dz))), shift * _s0


def backboard_clear(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Positive if there certainly is no contact before the horizon.

    bounds of the event condition. 123 operations: 24 additions, 10 subtractions, 21 multiplications, 5 divisions, 4 square roots, 4 negations, 3 absolute values, 25 comparisons, 27 selections.
    Returns clear.
    """
    _s0 = 1.0 / p_gravity
    _s1 = 0.5 * p_board_thickness
    _s2 = p_board_distance + _s1
    _s3 = 0.5 * p_board_bottom
    _s4 = 0.5 * p_board_top
    _s5 = p_ball_radius + _s1
    _s6 = p_ball_radius + p_board_half_width
    _s7 = _where(_s5 < _s6, _s6, _s5)
    _s8 = p_ball_radius + _s4
    _s9 = _s8 - _s3
    _s10 = ((_s2 + extent) + _absolute((_s3 + _s4))) + _where(_s7 < _s9, _s9, _s7)
    _s11 = _where(_s6 < _s5, _s6, _s5)
    _s12 = _where(_s9 < _s11, _s9, _s11)
    _s13 = (_sqrt(2.0) * _sqrt((_s0 * (_s10 + _s12)))) + ((2.0 * speed) * _s0)
    _s14 = ((position_error + (velocity_error * _where(_s13 < horizon, _s13, horizon))) + (3.552713678800501e-15 * (((speed * speed) * _s0) + _s10))) - (1.52587890625e-05 * _s12)
    _s15 = _absolute(vx)
    _s16 = 6.103515625e-05 * _s12
    _s17 = _s5 + _s16
    _s18 = _s2 + x
    _s19 = _where((vx < 0.0), (-_s18), _s18)
    _s20 = (-(_s17 + _s19)) / _s15
    _s21 = _where(0.0 < _s20, _s20, 0.0)
    _s22 = _absolute(vy)
    _s23 = _s6 + _s16
    _s24 = _where((vy < 0.0), (-y), y)
    _s25 = (-(_s23 + _s24)) / _s22
    _s26 = _where(_s21 < _s25, _s25, _s21)
    _s27 = vz * vz
    _s28 = (z - _s3) - _s4
    _s29 = (_s8 + _s16) - _s3
    _s30 = 2.0 * p_gravity
    _s31 = _s27 + (_s30 * (_s28 - _s29))
    _s32 = _sqrt(_where(_s31 < 0.0, 0.0, _s31))
    _s33 = 0.0 < _s31
    _s34 = _where(_s33, (_s0 * (vz + _s32)), _inf)
    _s35 = _where(_s26 < _s34, _s34, _s26)
    _s36 = _s27 + (_s30 * (_s28 + _s29))
    _s37 = _sqrt(_s36)
    _s38 = 0.0 <= _s36
    _s39 = _where(_s38, (_s0 * (vz + _s37)), (-_inf))
    _s40 = (_s23 - _s24) / _s22
    _s41 = (_s17 - _s19) / _s15
    _s42 = _where(_s41 < _inf, _s41, _inf)
    _s43 = _where(_s40 < _s42, _s40, _s42)
    _s44 = _where(_s39 < _s43, _s39, _s43)
    _s45 = _where(_s38, (_s0 * (vz - _s37)), _inf)
    _s46 = _where(_s26 < _s45, _s45, _s26)
    _s47 = _where(_s33, (_s0 * (vz - _s32)), _s39)
    _s48 = _where(_s47 < _s43, _s47, _s43)
    return _where((_s14 <= 0.0), _where((_where(0.0 < _s35, _s35, 0.0) < _where(_s44 < horizon, _s44, horizon)), 0.0, _where((_where(0.0 < _s46, _s46, 0.0) < _where(_s48 < horizon, _s48, horizon)), 0.0, 1.0)), 0.0),


def backboard_prepare(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Constants and windows of the search along a flight, and the errors it allows for.

    bounds of the event condition. 135 operations: 27 additions, 10 subtractions, 28 multiplications, 5 divisions, 4 square roots, 5 negations, 4 absolute values, 25 comparisons, 27 selections.
    Returns low0, high0, low1, high1, ceiling, latest, lost.
    """
    _s0 = _absolute(vx)
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
    _s13 = _s12 + x
    _s14 = _where((vx < 0.0), (-_s13), _s13)
    _s15 = (-(_s11 + _s14)) / _s0
    _s16 = _where(0.0 < _s15, _s15, 0.0)
    _s17 = _absolute(vy)
    _s18 = _s7 + _s10
    _s19 = _where((vy < 0.0), (-y), y)
    _s20 = (-(_s18 + _s19)) / _s17
    _s21 = _where(_s16 < _s20, _s20, _s16)
    _s22 = vz * vz
    _s23 = (z - _s5) - _s3
    _s24 = (_s4 + _s10) - _s5
    _s25 = 2.0 * p_gravity
    _s26 = _s22 + (_s25 * (_s23 + _s24))
    _s27 = 1.0 / p_gravity
    _s28 = _sqrt(_s26)
    _s29 = 0.0 <= _s26
    _s30 = _where(_s29, (_s27 * (vz - _s28)), _inf)
    _s31 = _where(_s21 < _s30, _s30, _s21)
    _s32 = _s22 + (_s25 * (_s23 - _s24))
    _s33 = _sqrt(_where(_s32 < 0.0, 0.0, _s32))
    _s34 = _where(_s29, (_s27 * (vz + _s28)), (-_inf))
    _s35 = 0.0 < _s32
    _s36 = _where(_s35, (_s27 * (vz - _s33)), _s34)
    _s37 = (_s18 - _s19) / _s17
    _s38 = (_s11 - _s14) / _s0
    _s39 = _where(_s38 < _inf, _s38, _inf)
    _s40 = _where(_s37 < _s39, _s37, _s39)
    _s41 = _where(_s36 < _s40, _s36, _s40)
    _s42 = _where(_s35, (_s27 * (vz + _s33)), _inf)
    _s43 = _where(_s21 < _s42, _s42, _s21)
    _s44 = _where(_s34 < _s40, _s34, _s40)
    _s45 = _where(0.0 < _s41, _s41, 0.0)
    _s46 = _where(_s45 < _s44, _s44, _s45)
    _s47 = _where(_s46 < horizon, _s46, horizon)
    _s48 = speed + (p_gravity * _s47)
    _s49 = 2.0 * (((1.25 * _absolute((-p_gravity))) * (p_ball_radius + (0.0001220703125 * _s9))) + (3.0 * (_s48 * _s48)))
    _s50 = _where(_s2 < _s7, _s7, _s2)
    _s51 = ((_s12 + extent) + _absolute((_s5 + _s3))) + _where(_s50 < _s6, _s6, _s50)
    _s52 = (_sqrt(2.0) * _sqrt((_s27 * (_s51 + _s9)))) + ((2.0 * speed) * _s27)
    _s53 = ((position_error + (velocity_error * _where(_s52 < horizon, _s52, horizon))) + (3.552713678800501e-15 * (((speed * speed) * _s27) + _s51))) - (1.52587890625e-05 * _s9)
    return _where(0.0 < _s31, _s31, 0.0), _where(_s41 < horizon, _s41, horizon), _where(0.0 < _s43, _s43, 0.0), _where(_s44 < horizon, _s44, horizon), _s49, _s47, _s53


def backboard_margins(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.

    running error analysis. 83 operations: 31 additions, 1 subtraction, 45 multiplications, 2 absolute values, 2 comparisons, 2 selections.
    Returns margin, leaving_margin, rate_margin.
    """
    _s0 = (p_ball_radius + (0.5 * p_board_top)) - (0.5 * p_board_bottom)
    _s1 = p_ball_radius + p_board_half_width
    _s2 = p_ball_radius + (0.5 * p_board_thickness)
    _s3 = _where(_s1 < _s2, _s1, _s2)
    _s4 = p_ball_radius + (0.0001220703125 * _where(_s0 < _s3, _s0, _s3))
    _s5 = speed + (p_gravity * horizon)
    _s6 = extent + (horizon * _s5)
    _s7 = 2.220446049250313e-16 * _s6
    _s8 = 2.0 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * _s6))
    _s9 = ((3.3306690738754696e-16 * p_board_half_width) + _s7) + _s8
    _s10 = 2.001953125 * _s4
    _s11 = (((3.3306690738754696e-16 * p_board_distance) + (2.220446049250313e-16 * p_board_thickness)) + (3.3306690738754696e-16 * _s6)) + _s8
    _s12 = (((2.220446049250313e-16 * _absolute(p_board_bottom)) + (2.220446049250313e-16 * _absolute(p_board_top))) + _s7) + _s8
    _s13 = ((((5.55653613398821e-16 * (p_ball_radius * p_ball_radius)) + (_s10 * _s9)) + (_s10 * _s11)) + (_s10 * _s12)) + (((1.3335686721571705e-15 * horizon) * _s4) * _s5)
    _s14 = 4.00390625 * _s5
    _s15 = ((((12.01171875 * _s4) * (velocity_error + (3.3306690738754696e-16 * _s5))) + ((6.667843360785852e-15 * _s4) * _s5)) + (_s14 * _s9)) + (_s14 * _s11)
    _s16 = 2.001953125 * _s5
    _s17 = ((((6.005859375 * _s4) * (velocity_error + (2.220446049250313e-16 * _s5))) + ((2.667137344314341e-15 * _s4) * _s5)) + (_s16 * _s9)) + (_s16 * _s11)
    return _s13 + (1.3335686721571705e-15 * (_s4 * _s4)), _s15 + (_s14 * _s12), _s17 + (_s16 * _s12)


def backboard_refine(t: Any, leaving: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Newton's next value of a root near t, and the rate there.

    Newton's method. 101 operations: 19 additions, 19 subtractions, 26 multiplications, 1 division, 4 negations, 16 comparisons, 16 selections.
    Returns time, rate.
    """
    _s0 = x + (t * vx)
    _s1 = p_board_distance + _s0
    _s2 = p_board_distance + p_board_thickness
    _s3 = -(_s2 + _s0)
    _s4 = _where(_s1 < 0.0, 0.0, _s1) - _where(_s3 < 0.0, 0.0, _s3)
    _s5 = y + (t * vy)
    _s6 = _s5 - p_board_half_width
    _s7 = -(p_board_half_width + _s5)
    _s8 = _where(_s6 < 0.0, 0.0, _s6) - _where(_s7 < 0.0, 0.0, _s7)
    _s9 = vz - ((0.5 * p_gravity) * t)
    _s10 = z + (t * _s9)
    _s11 = _s10 - p_board_top
    _s12 = p_board_bottom - _s10
    _s13 = _where(_s11 < 0.0, 0.0, _s11) - _where(_s12 < 0.0, 0.0, _s12)
    _s14 = 2.0 * (((vx * _s4) + (vy * _s8)) + ((vz - (p_gravity * t)) * _s13))
    _s15 = z - p_board_top
    _s16 = p_board_bottom - z
    _s17 = _where(_s15 < 0.0, 0.0, _s15) - _where(_s16 < 0.0, 0.0, _s16)
    _s18 = _s13 * _s13
    _s19 = p_board_distance + x
    _s20 = -(_s2 + x)
    _s21 = _where(_s19 < 0.0, 0.0, _s19) - _where(_s20 < 0.0, 0.0, _s20)
    _s22 = _s4 * _s4
    _s23 = y - p_board_half_width
    _s24 = -(p_board_half_width + y)
    _s25 = _where(_s23 < 0.0, 0.0, _s23) - _where(_s24 < 0.0, 0.0, _s24)
    _s26 = _s8 * _s8
    _s27 = (_where((0.0 < (_s17 * _s13)), (t * (_s9 * (_s17 + _s13))), (_s18 - (_s17 * _s17))) + _where((0.0 < (_s21 * _s4)), (t * (vx * (_s21 + _s4))), (_s22 - (_s21 * _s21)))) + _where((0.0 < (_s25 * _s8)), (t * (vy * (_s25 + _s8))), (_s26 - (_s25 * _s25)))
    _s28 = t - (_where((0.0 < leaving), _s27, (((_s18 + _s22) + _s26) - (p_ball_radius * p_ball_radius))) / _s14)
    return _s28, _s14


def backboard_advance(t: Any, end: Any, leaving: Any, margin: Any, rate_margin: Any, ceiling: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ball_radius: Any, p_board_distance: Any, p_board_half_width: Any, p_board_bottom: Any, p_board_top: Any, p_board_thickness: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Gap, rate, bend, a step without a root and its end, Newton's root and its clearance.

    Newton from the left under a curvature bound. 194 operations: 33 additions, 26 subtractions, 51 multiplications, 3 divisions, 1 square root, 8 negations, 5 absolute values, 32 comparisons, 35 selections.
    Returns gap, rate, bend, step, next, root, clearance.
    """
    _s0 = z - p_board_top
    _s1 = p_board_bottom - z
    _s2 = _where(_s0 < 0.0, 0.0, _s0) - _where(_s1 < 0.0, 0.0, _s1)
    _s3 = vz - ((0.5 * p_gravity) * t)
    _s4 = z + (t * _s3)
    _s5 = _s4 - p_board_top
    _s6 = p_board_bottom - _s4
    _s7 = _where(_s5 < 0.0, 0.0, _s5) - _where(_s6 < 0.0, 0.0, _s6)
    _s8 = _s7 * _s7
    _s9 = p_board_distance + x
    _s10 = p_board_distance + p_board_thickness
    _s11 = -(_s10 + x)
    _s12 = _where(_s9 < 0.0, 0.0, _s9) - _where(_s11 < 0.0, 0.0, _s11)
    _s13 = x + (t * vx)
    _s14 = p_board_distance + _s13
    _s15 = -(_s10 + _s13)
    _s16 = _where(_s14 < 0.0, 0.0, _s14) - _where(_s15 < 0.0, 0.0, _s15)
    _s17 = _s16 * _s16
    _s18 = y - p_board_half_width
    _s19 = -(p_board_half_width + y)
    _s20 = _where(_s18 < 0.0, 0.0, _s18) - _where(_s19 < 0.0, 0.0, _s19)
    _s21 = y + (t * vy)
    _s22 = _s21 - p_board_half_width
    _s23 = -(p_board_half_width + _s21)
    _s24 = _where(_s22 < 0.0, 0.0, _s22) - _where(_s23 < 0.0, 0.0, _s23)
    _s25 = _s24 * _s24
    _s26 = (_where((0.0 < (_s2 * _s7)), (t * (_s3 * (_s2 + _s7))), (_s8 - (_s2 * _s2))) + _where((0.0 < (_s12 * _s16)), (t * (vx * (_s12 + _s16))), (_s17 - (_s12 * _s12)))) + _where((0.0 < (_s20 * _s24)), (t * (vy * (_s20 + _s24))), (_s25 - (_s20 * _s20)))
    _s27 = _where((0.0 < leaving), _s26, (((_s8 + _s17) + _s25) - (p_ball_radius * p_ball_radius)))
    _s28 = vz - (p_gravity * t)
    _s29 = ((vx * _s16) + (vy * _s24)) + (_s28 * _s7)
    _s30 = 2.0 * _s29
    _s31 = _absolute(_s7)
    _s32 = 2.0 * ((_where((0.0 < _s31), ((_s28 * _s28) - (p_gravity * _s7)), 0.0) + _where((0.0 < _absolute(_s16)), (vx * vx), 0.0)) + _where((0.0 < _absolute(_s24)), (vy * vy), 0.0))
    _s33 = _absolute((-p_gravity))
    _s34 = (p_ball_radius + (0.5 * p_board_top)) - (0.5 * p_board_bottom)
    _s35 = p_ball_radius + p_board_half_width
    _s36 = p_ball_radius + (0.5 * p_board_thickness)
    _s37 = _where(_s35 < _s36, _s35, _s36)
    _s38 = p_ball_radius + (0.0001220703125 * _where(_s34 < _s37, _s34, _s37))
    _s39 = _s30 - rate_margin
    _s40 = _s27 - margin
    _s41 = _where(_s40 < 0.0, 0.0, _s40)
    _s42 = -_s32
    _s43 = _s39 < 0.0
    _s44 = 2.0 * _s41
    _s45 = _where((0.0 < _where((0.0 <= _s39), _s41, 0.0)), _inf, (_where(_s43, _s44, (4.0 * _s39)) / _where(_s43, (-_s39), _where(0.0 < _s42, _s42, 0.0))))
    _s46 = end - t
    _s47 = _where(_s45 < _s46, _s45, _s46)
    _s48 = ((((0.5 * _s33) * _s47) + _absolute(_s28)) * _s47) + _s31
    _s49 = (9.094947017729282e-13 * ceiling) + (2.0 * (_s33 * _where(_s38 < _s48, _s38, _s48)))
    _s50 = ((2.0 * _s49) * _s41) + (_s39 * _s39)
    _s51 = _sqrt(_s50)
    _s52 = _where((0.0 <= _s50), (_where(_s43, _s44, (_s39 + _s51)) / _where(_s43, (_s51 - _s39), _where(0.0 < _s49, _s49, 0.0))), _inf)
    _s53 = _where(_s52 < _s47, _s52, _s47)
    _s54 = -(rate_margin + _s30)
    return _s27, _s30, _s32, _s53, t + _s53, t - ((0.5 * _s27) / _s29), _where((0.0 < _s54), ((_s54 * _s54) - ((8.0 * ceiling) * (margin + (32.0 * _s41)))), _s54)


def backboard_enter(after: Any, end: Any, high0: Any, high1: Any, low0: Any, low1: Any, t: Any) -> tuple[Any, ...]:
    """The first window that begins no earlier than a time, if there is one.

    Table 1. 12 operations: 4 comparisons, 2 conjunctions, 2 disjunctions, 4 selections.
    Returns t, end, searching.
    """
    _s0 = _logical_and((low0 < high0), (after <= low0))
    _s1 = _logical_and((low1 < high1), (after <= low1))
    return _where(_s0, low0, _where(_s1, low1, t)), _where(_s0, high0, _where(_s1, high1, end)), _logical_or(_logical_or(False, _s1), _s0)


def bridge_normal(x: Any, y: Any, z: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_bridge_depth: Any) -> tuple[Any, ...]:
    """Outward unit normal n3 at a contact.

    Table 2. 28 operations: 3 additions, 7 subtractions, 3 multiplications, 1 division, 2 negations, 6 comparisons, 6 selections.
    Returns nx, ny, nz.
    """
    _s0 = 1.0 / p_ball_radius
    _s1 = p_ring_radius + x
    _s2 = -(p_board_distance + x)
    _s3 = y - p_bridge_half_width
    _s4 = -(p_bridge_half_width + y)
    _s5 = z - p_wire_radius
    _s6 = (p_wire_radius - p_bridge_depth) - z
    return _s0 * (_where(_s1 < 0.0, 0.0, _s1) - _where(_s2 < 0.0, 0.0, _s2)), _s0 * (_where(_s3 < 0.0, 0.0, _s3) - _where(_s4 < 0.0, 0.0, _s4)), _s0 * (_where(_s5 < 0.0, 0.0, _s5) - _where(_s6 < 0.0, 0.0, _s6))


def bridge_curvature(p_ball_radius: Any) -> tuple[Any, ...]:
    """Bound on the rate at which the normal turns along the contact surface.

    Table 2. 1 operation: 1 division.
    Returns curvature.
    """
    return 1.0 / p_ball_radius,


def bridge_carry_normal(x: Any, y: Any, z: Any, dx: Any, dy: Any, dz: Any, shift: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_bridge_depth: Any) -> tuple[Any, ...]:
    """Error of the normal, from that of the position.

    derivative of Table 2's normal. 32 operations: 3 additions, 7 subtractions, 4 multiplications, 1 division, 5 negations, 6 comparisons, 6 selections.
    Returns dnx, dny, dnz, turn.
    """
    _s0 = 1.0 / p_ball_radius
    _s1 = _s0 * (_where(((p_ring_radius + x) < 0.0), 0.0, dx) - _where(((-(p_board_distance + x)) < 0.0), 0.0, (-dx)))
    _s2 = _s0 * (_where(((y - p_bridge_half_width) < 0.0), 0.0, dy) - _where(((-(p_bridge_half_width + y)) < 0.0), 0.0, (-dy)))
    _s3 = _s0 * (_where(((z - p_wire_radius) < 0.0), 0.0, dz) - _where((((p_wire_radius - p_bridge_depth) - z) < 0.0), 0.0, (-dz)))
    return _s1, _s2, _s3, shift * _s0


def bridge_clear(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Positive if there certainly is no contact before the horizon.

    bounds of the event condition. 124 operations: 25 additions, 10 subtractions, 21 multiplications, 5 divisions, 4 square roots, 4 negations, 3 absolute values, 25 comparisons, 27 selections.
    Returns clear.
    """
    _s0 = 1.0 / p_gravity
    _s1 = 0.5 * p_board_distance
    _s2 = 0.5 * p_ring_radius
    _s3 = 0.5 * p_bridge_depth
    _s4 = p_ball_radius + _s1
    _s5 = _s4 - _s2
    _s6 = p_ball_radius + p_bridge_half_width
    _s7 = _where(_s5 < _s6, _s6, _s5)
    _s8 = p_ball_radius + _s3
    _s9 = (((_s1 + extent) + _s2) + _absolute((_s3 - p_wire_radius))) + _where(_s7 < _s8, _s8, _s7)
    _s10 = _where(_s6 < _s5, _s6, _s5)
    _s11 = _where(_s8 < _s10, _s8, _s10)
    _s12 = (_sqrt(2.0) * _sqrt((_s0 * (_s9 + _s11)))) + ((2.0 * speed) * _s0)
    _s13 = ((position_error + (velocity_error * _where(_s12 < horizon, _s12, horizon))) + (3.552713678800501e-15 * (((speed * speed) * _s0) + _s9))) - (1.52587890625e-05 * _s11)
    _s14 = _absolute(vx)
    _s15 = 6.103515625e-05 * _s11
    _s16 = (_s4 + _s15) - _s2
    _s17 = (_s1 + _s2) + x
    _s18 = _where((vx < 0.0), (-_s17), _s17)
    _s19 = (-(_s16 + _s18)) / _s14
    _s20 = _where(0.0 < _s19, _s19, 0.0)
    _s21 = _absolute(vy)
    _s22 = _s6 + _s15
    _s23 = _where((vy < 0.0), (-y), y)
    _s24 = (-(_s22 + _s23)) / _s21
    _s25 = _where(_s20 < _s24, _s24, _s20)
    _s26 = vz * vz
    _s27 = (_s3 + z) - p_wire_radius
    _s28 = _s8 + _s15
    _s29 = 2.0 * p_gravity
    _s30 = _s26 + (_s29 * (_s27 - _s28))
    _s31 = _sqrt(_where(_s30 < 0.0, 0.0, _s30))
    _s32 = 0.0 < _s30
    _s33 = _where(_s32, (_s0 * (vz + _s31)), _inf)
    _s34 = _where(_s25 < _s33, _s33, _s25)
    _s35 = _s26 + (_s29 * (_s28 + _s27))
    _s36 = _sqrt(_s35)
    _s37 = 0.0 <= _s35
    _s38 = _where(_s37, (_s0 * (vz + _s36)), (-_inf))
    _s39 = (_s22 - _s23) / _s21
    _s40 = (_s16 - _s18) / _s14
    _s41 = _where(_s40 < _inf, _s40, _inf)
    _s42 = _where(_s39 < _s41, _s39, _s41)
    _s43 = _where(_s38 < _s42, _s38, _s42)
    _s44 = _where(_s37, (_s0 * (vz - _s36)), _inf)
    _s45 = _where(_s25 < _s44, _s44, _s25)
    _s46 = _where(_s32, (_s0 * (vz - _s31)), _s38)
    _s47 = _where(_s46 < _s42, _s46, _s42)
    return _where((_s13 <= 0.0), _where((_where(0.0 < _s34, _s34, 0.0) < _where(_s43 < horizon, _s43, horizon)), 0.0, _where((_where(0.0 < _s45, _s45, 0.0) < _where(_s47 < horizon, _s47, horizon)), 0.0, 1.0)), 0.0),


def bridge_prepare(horizon: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Constants and windows of the search along a flight, and the errors it allows for.

    bounds of the event condition. 136 operations: 28 additions, 10 subtractions, 28 multiplications, 5 divisions, 4 square roots, 5 negations, 4 absolute values, 25 comparisons, 27 selections.
    Returns low0, high0, low1, high1, ceiling, latest, lost.
    """
    _s0 = _absolute(vx)
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
    _s12 = (_s1 + _s6) + x
    _s13 = _where((vx < 0.0), (-_s12), _s12)
    _s14 = (-(_s11 + _s13)) / _s0
    _s15 = _where(0.0 < _s14, _s14, 0.0)
    _s16 = _absolute(vy)
    _s17 = _s5 + _s10
    _s18 = _where((vy < 0.0), (-y), y)
    _s19 = (-(_s17 + _s18)) / _s16
    _s20 = _where(_s15 < _s19, _s19, _s15)
    _s21 = vz * vz
    _s22 = _s4 + _s10
    _s23 = (_s3 + z) - p_wire_radius
    _s24 = 2.0 * p_gravity
    _s25 = _s21 + (_s24 * (_s22 + _s23))
    _s26 = 1.0 / p_gravity
    _s27 = _sqrt(_s25)
    _s28 = 0.0 <= _s25
    _s29 = _where(_s28, (_s26 * (vz - _s27)), _inf)
    _s30 = _where(_s20 < _s29, _s29, _s20)
    _s31 = _s21 + (_s24 * (_s23 - _s22))
    _s32 = _sqrt(_where(_s31 < 0.0, 0.0, _s31))
    _s33 = _where(_s28, (_s26 * (vz + _s27)), (-_inf))
    _s34 = 0.0 < _s31
    _s35 = _where(_s34, (_s26 * (vz - _s32)), _s33)
    _s36 = (_s17 - _s18) / _s16
    _s37 = (_s11 - _s13) / _s0
    _s38 = _where(_s37 < _inf, _s37, _inf)
    _s39 = _where(_s36 < _s38, _s36, _s38)
    _s40 = _where(_s35 < _s39, _s35, _s39)
    _s41 = _where(_s34, (_s26 * (vz + _s32)), _inf)
    _s42 = _where(_s20 < _s41, _s41, _s20)
    _s43 = _where(_s33 < _s39, _s33, _s39)
    _s44 = _where(0.0 < _s40, _s40, 0.0)
    _s45 = _where(_s44 < _s43, _s43, _s44)
    _s46 = _where(_s45 < horizon, _s45, horizon)
    _s47 = speed + (p_gravity * _s46)
    _s48 = 2.0 * (((1.25 * _absolute((-p_gravity))) * (p_ball_radius + (0.0001220703125 * _s9))) + (3.0 * (_s47 * _s47)))
    _s49 = _where(_s7 < _s5, _s5, _s7)
    _s50 = (((_s1 + extent) + _s6) + _absolute((_s3 - p_wire_radius))) + _where(_s49 < _s4, _s4, _s49)
    _s51 = (_sqrt(2.0) * _sqrt((_s26 * (_s50 + _s9)))) + ((2.0 * speed) * _s26)
    _s52 = ((position_error + (velocity_error * _where(_s51 < horizon, _s51, horizon))) + (3.552713678800501e-15 * (((speed * speed) * _s26) + _s50))) - (1.52587890625e-05 * _s9)
    return _where(0.0 < _s30, _s30, 0.0), _where(_s40 < horizon, _s40, horizon), _where(0.0 < _s42, _s42, 0.0), _where(_s43 < horizon, _s43, horizon), _s48, _s46, _s52


def bridge_margins(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.

    running error analysis. 81 operations: 31 additions, 1 subtraction, 45 multiplications, 2 comparisons, 2 selections.
    Returns margin, leaving_margin, rate_margin.
    """
    _s0 = p_ball_radius + (0.5 * p_bridge_depth)
    _s1 = p_ball_radius + p_bridge_half_width
    _s2 = (p_ball_radius + (0.5 * p_board_distance)) - (0.5 * p_ring_radius)
    _s3 = _where(_s1 < _s2, _s1, _s2)
    _s4 = p_ball_radius + (0.0001220703125 * _where(_s0 < _s3, _s0, _s3))
    _s5 = speed + (p_gravity * horizon)
    _s6 = extent + (horizon * _s5)
    _s7 = 2.220446049250313e-16 * _s6
    _s8 = 2.0 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * _s6))
    _s9 = ((3.3306690738754696e-16 * p_bridge_half_width) + _s7) + _s8
    _s10 = 2.001953125 * _s4
    _s11 = (((1.1102230246251565e-16 * p_board_distance) + (1.1102230246251565e-16 * p_ring_radius)) + _s7) + _s8
    _s12 = (((2.220446049250313e-16 * p_bridge_depth) + (5.551115123125783e-16 * p_wire_radius)) + (3.3306690738754696e-16 * _s6)) + _s8
    _s13 = ((((5.55653613398821e-16 * (p_ball_radius * p_ball_radius)) + (_s10 * _s9)) + (_s10 * _s11)) + (_s10 * _s12)) + (((1.3335686721571705e-15 * horizon) * _s4) * _s5)
    _s14 = 4.00390625 * _s5
    _s15 = ((((12.01171875 * _s4) * (velocity_error + (3.3306690738754696e-16 * _s5))) + ((6.667843360785852e-15 * _s4) * _s5)) + (_s14 * _s9)) + (_s14 * _s11)
    _s16 = 2.001953125 * _s5
    _s17 = ((((6.005859375 * _s4) * (velocity_error + (2.220446049250313e-16 * _s5))) + ((2.667137344314341e-15 * _s4) * _s5)) + (_s16 * _s9)) + (_s16 * _s11)
    return _s13 + (1.3335686721571705e-15 * (_s4 * _s4)), _s15 + (_s14 * _s12), _s17 + (_s16 * _s12)


def bridge_refine(t: Any, leaving: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Newton's next value of a root near t, and the rate there.

    Newton's method. 101 operations: 18 additions, 20 subtractions, 26 multiplications, 1 division, 4 negations, 16 comparisons, 16 selections.
    Returns time, rate.
    """
    _s0 = x + (t * vx)
    _s1 = p_ring_radius + _s0
    _s2 = -(p_board_distance + _s0)
    _s3 = _where(_s1 < 0.0, 0.0, _s1) - _where(_s2 < 0.0, 0.0, _s2)
    _s4 = y + (t * vy)
    _s5 = _s4 - p_bridge_half_width
    _s6 = -(p_bridge_half_width + _s4)
    _s7 = _where(_s5 < 0.0, 0.0, _s5) - _where(_s6 < 0.0, 0.0, _s6)
    _s8 = vz - ((0.5 * p_gravity) * t)
    _s9 = z + (t * _s8)
    _s10 = _s9 - p_wire_radius
    _s11 = p_wire_radius - p_bridge_depth
    _s12 = _s11 - _s9
    _s13 = _where(_s10 < 0.0, 0.0, _s10) - _where(_s12 < 0.0, 0.0, _s12)
    _s14 = 2.0 * (((vx * _s3) + (vy * _s7)) + ((vz - (p_gravity * t)) * _s13))
    _s15 = p_ring_radius + x
    _s16 = -(p_board_distance + x)
    _s17 = _where(_s15 < 0.0, 0.0, _s15) - _where(_s16 < 0.0, 0.0, _s16)
    _s18 = _s3 * _s3
    _s19 = y - p_bridge_half_width
    _s20 = -(p_bridge_half_width + y)
    _s21 = _where(_s19 < 0.0, 0.0, _s19) - _where(_s20 < 0.0, 0.0, _s20)
    _s22 = _s7 * _s7
    _s23 = z - p_wire_radius
    _s24 = _s11 - z
    _s25 = _where(_s23 < 0.0, 0.0, _s23) - _where(_s24 < 0.0, 0.0, _s24)
    _s26 = _s13 * _s13
    _s27 = (_where((0.0 < (_s17 * _s3)), (t * (vx * (_s17 + _s3))), (_s18 - (_s17 * _s17))) + _where((0.0 < (_s21 * _s7)), (t * (vy * (_s21 + _s7))), (_s22 - (_s21 * _s21)))) + _where((0.0 < (_s25 * _s13)), (t * (_s8 * (_s25 + _s13))), (_s26 - (_s25 * _s25)))
    _s28 = t - (_where((0.0 < leaving), _s27, (((_s18 + _s22) + _s26) - (p_ball_radius * p_ball_radius))) / _s14)
    return _s28, _s14


def bridge_advance(t: Any, end: Any, leaving: Any, margin: Any, rate_margin: Any, ceiling: Any, x: Any, y: Any, z: Any, vx: Any, vy: Any, vz: Any, p_ball_radius: Any, p_ring_radius: Any, p_wire_radius: Any, p_board_distance: Any, p_bridge_half_width: Any, p_bridge_depth: Any, p_gravity: Any) -> tuple[Any, ...]:
    """Gap, rate, bend, a step without a root and its end, Newton's root and its clearance.

    Newton from the left under a curvature bound. 194 operations: 32 additions, 27 subtractions, 51 multiplications, 3 divisions, 1 square root, 8 negations, 5 absolute values, 32 comparisons, 35 selections.
    Returns gap, rate, bend, step, next, root, clearance.
    """
    _s0 = p_ring_radius + x
    _s1 = -(p_board_distance + x)
    _s2 = _where(_s0 < 0.0, 0.0, _s0) - _where(_s1 < 0.0, 0.0, _s1)
    _s3 = x + (t * vx)
    _s4 = p_ring_radius + _s3
    _s5 = -(p_board_distance + _s3)
    _s6 = _where(_s4 < 0.0, 0.0, _s4) - _where(_s5 < 0.0, 0.0, _s5)
    _s7 = _s6 * _s6
    _s8 = y - p_bridge_half_width
    _s9 = -(p_bridge_half_width + y)
    _s10 = _where(_s8 < 0.0, 0.0, _s8) - _where(_s9 < 0.0, 0.0, _s9)
    _s11 = y + (t * vy)
    _s12 = _s11 - p_bridge_half_width
    _s13 = -(p_bridge_half_width + _s11)
    _s14 = _where(_s12 < 0.0, 0.0, _s12) - _where(_s13 < 0.0, 0.0, _s13)
    _s15 = _s14 * _s14
    _s16 = z - p_wire_radius
    _s17 = p_wire_radius - p_bridge_depth
    _s18 = _s17 - z
    _s19 = _where(_s16 < 0.0, 0.0, _s16) - _where(_s18 < 0.0, 0.0, _s18)
    _s20 = vz - ((0.5 * p_gravity) * t)
    _s21 = z + (t * _s20)
    _s22 = _s21 - p_wire_radius
    _s23 = _s17 - _s21
    _s24 = _where(_s22 < 0.0, 0.0, _s22) - _where(_s23 < 0.0, 0.0, _s23)
    _s25 = _s24 * _s24
    _s26 = (_where((0.0 < (_s2 * _s6)), (t * (vx * (_s2 + _s6))), (_s7 - (_s2 * _s2))) + _where((0.0 < (_s10 * _s14)), (t * (vy * (_s10 + _s14))), (_s15 - (_s10 * _s10)))) + _where((0.0 < (_s19 * _s24)), (t * (_s20 * (_s19 + _s24))), (_s25 - (_s19 * _s19)))
    _s27 = _where((0.0 < leaving), _s26, (((_s7 + _s15) + _s25) - (p_ball_radius * p_ball_radius)))
    _s28 = vz - (p_gravity * t)
    _s29 = ((vx * _s6) + (vy * _s14)) + (_s28 * _s24)
    _s30 = 2.0 * _s29
    _s31 = _absolute(_s24)
    _s32 = 2.0 * ((_where((0.0 < _absolute(_s6)), (vx * vx), 0.0) + _where((0.0 < _absolute(_s14)), (vy * vy), 0.0)) + _where((0.0 < _s31), ((_s28 * _s28) - (p_gravity * _s24)), 0.0))
    _s33 = _absolute((-p_gravity))
    _s34 = p_ball_radius + (0.5 * p_bridge_depth)
    _s35 = p_ball_radius + p_bridge_half_width
    _s36 = (p_ball_radius + (0.5 * p_board_distance)) - (0.5 * p_ring_radius)
    _s37 = _where(_s35 < _s36, _s35, _s36)
    _s38 = p_ball_radius + (0.0001220703125 * _where(_s34 < _s37, _s34, _s37))
    _s39 = _s30 - rate_margin
    _s40 = _s27 - margin
    _s41 = _where(_s40 < 0.0, 0.0, _s40)
    _s42 = -_s32
    _s43 = _s39 < 0.0
    _s44 = 2.0 * _s41
    _s45 = _where((0.0 < _where((0.0 <= _s39), _s41, 0.0)), _inf, (_where(_s43, _s44, (4.0 * _s39)) / _where(_s43, (-_s39), _where(0.0 < _s42, _s42, 0.0))))
    _s46 = end - t
    _s47 = _where(_s45 < _s46, _s45, _s46)
    _s48 = ((((0.5 * _s33) * _s47) + _absolute(_s28)) * _s47) + _s31
    _s49 = (9.094947017729282e-13 * ceiling) + (2.0 * (_s33 * _where(_s38 < _s48, _s38, _s48)))
    _s50 = ((2.0 * _s49) * _s41) + (_s39 * _s39)
    _s51 = _sqrt(_s50)
    _s52 = _where((0.0 <= _s50), (_where(_s43, _s44, (_s39 + _s51)) / _where(_s43, (_s51 - _s39), _where(0.0 < _s49, _s49, 0.0))), _inf)
    _s53 = _where(_s52 < _s47, _s52, _s47)
    _s54 = -(rate_margin + _s30)
    return _s27, _s30, _s32, _s53, t + _s53, t - ((0.5 * _s27) / _s29), _where((0.0 < _s54), ((_s54 * _s54) - ((8.0 * ceiling) * (margin + (32.0 * _s41)))), _s54)


def bridge_enter(after: Any, end: Any, high0: Any, high1: Any, low0: Any, low1: Any, t: Any) -> tuple[Any, ...]:
    """The first window that begins no earlier than a time, if there is one.

    Table 1. 12 operations: 4 comparisons, 2 conjunctions, 2 disjunctions, 4 selections.
    Returns t, end, searching.
    """
    _s0 = _logical_and((low0 < high0), (after <= low0))
    _s1 = _logical_and((low1 < high1), (after <= low1))
    return _where(_s0, low0, _where(_s1, low1, t)), _where(_s0, high0, _where(_s1, high1, end)), _logical_or(_logical_or(False, _s1), _s0)


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


def end_arrival(leaving: Any, z: Any, vz: Any, p_gravity: Any, p_end_depth: Any) -> tuple[Any, ...]:
    """Time of the only arrival, the gap's rate there and its bend.

    Eq. 3 in Table 2, solved. 25 operations: 2 additions, 2 subtractions, 7 multiplications, 2 divisions, 1 square root, 6 negations, 2 comparisons, 3 selections.
    Returns time, rate, bend, apex, height.
    """
    _s0 = _where((0.0 < leaving), 0.0, (z - (-p_end_depth)))
    _s1 = (vz * vz) + ((2.0 * p_gravity) * _s0)
    _s2 = _sqrt(_s1)
    _s3 = vz < 0.0
    _s4 = -(1.0 / p_gravity)
    return _where(_s3, (2.0 * _s0), (vz + _s2)) / _where(_s3, (_s2 - vz), p_gravity), -_s2, -p_gravity, -(vz * _s4), -((0.5 * _s4) * _s1)


def end_margin(horizon: Any, extent: Any, speed: Any, position_error: Any, velocity_error: Any, p_gravity: Any, p_end_depth: Any) -> tuple[Any, ...]:
    """Rounding-error bound of the gap up to the horizon.

    running error analysis. 13 operations: 6 additions, 7 multiplications.
    Returns margin.
    """
    _s0 = extent + (horizon * (speed + (p_gravity * horizon)))
    return ((6.667843360785852e-16 * p_end_depth) + (2.222614453595284e-16 * _s0)) + (2.001953125 * ((position_error + (horizon * velocity_error)) + (4.440892098500626e-16 * _s0))),


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


def _rows(truth: Any, shots: int) -> tuple[Any, int]:
    """Return the rows where a truth holds, None if that is all of them, and how many they are."""
    if _ndim(truth) == 0:
        return (None, shots) if truth else (_flatnonzero(()), 0)
    rows = _flatnonzero(truth)
    return (None if len(rows) == shots else rows), len(rows)


def _take(values: Any, rows: Any) -> Any:
    """Return some rows of a column; what all shots share stays."""
    return values if rows is None or _ndim(values) == 0 else values[rows]


def _of(rows: Any, some: Any) -> Any:
    """Return some of the rows."""
    return some if rows is None else rows[some]


def _copy(values: Any, shots: int) -> Any:
    """Return a column of one's own."""
    return _broadcast_to(values, (shots,)).copy()


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


def admit_plain(columns: dict[str, Any], shots: int) -> None:
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
    _finite_0, = finite_state(_vx_0, _vy_0, _vz_0, _wx_0, _wy_0, _wz_0, _x_0, _y_0, _z_0)
    _valid_0, *_ = valid(_last_0, _x_0, _y_0, _z_0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_board_thickness_0, _p_bridge_half_width_0, _p_bridge_depth_0, _p_end_depth_0)
    _outcome_0, *_ = admitted(_inf, _finite_0, _permitted_0, _valid_0)
    _through_0, *_ = passing_start(_last_0, _outcome_0, 0.0, _x_0, _y_0, _z_0, _p_ring_radius_0, _p_end_depth_0)
    columns["outcome"] = _outcome_0
    columns["through"] = _through_0


def reach_plain(columns: dict[str, Any], shots: int) -> None:
    """Stage reach of the event loop, the path alone."""
    _clock_0 = columns["clock"]
    _contacts_0 = columns["contacts"]
    _last_0 = columns["last"]
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
    _through_0 = columns["through"]
    _time_limit_0 = columns["time_limit"]
    _vx_0 = columns["vx"]
    _vy_0 = columns["vy"]
    _vz_0 = columns["vz"]
    _x_0 = columns["x"]
    _y_0 = columns["y"]
    _z_0 = columns["z"]
    _, _, _, _time_error_0 = error_bounds(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    _extent_0, _speed_0, _excess_0 = scale(_x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _p_gravity_0)
    _when_0, _which_0, *_ = opening(_excess_0, 0.0, 0.0)
    _limited_0, = limited(_time_limit_0)
    _leaving_0, = left(3.0, _last_0)
    _time_0, _rate_0, _bend_0, *_ = end_arrival(_leaving_0, _z_0, _vz_0, _p_gravity_0, _p_end_depth_0)
    _arrives_0, *_ = meeting_plane(_bend_0, _rate_0, _time_0)
    _possible_0, = timely(_arrives_0, 0.0, 0.0, _time_0, _when_0)
    _when_1, _which_1 = sooner(_arrives_0, 3.0, _time_0, _when_0, _which_0)
    _when_0 = _where(_possible_0, _when_1, _when_0)
    _which_0 = _where(_possible_0, _which_1, _which_0)
    _until_0, *_ = horizon(_when_0, _speed_0, _p_gravity_0)
    _clear_0, = ring_clear(_until_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _extent_0, _speed_0, 0.0, 0.0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_gravity_0)
    _open_0, = opens(_clear_0)
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
        _steady_1, _swing_1, _rho_start_1, _low0_1, _high0_1, _low1_1, _high1_1, _low2_1, _high2_1, _ceiling_1, _latest_1, *_ = ring_prepare(_until_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, 0.0, 0.0, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1)
        _share_1, _arrival_1, _certain_1 = beginning()
        _position_level_1, _velocity_level_1, *_ = allowance(_share_1, _latest_1, _extent_1, _speed_1, 0.0, 0.0, _p_gravity_1)
        _flat_1, _tilt_1, _rate_slack_1 = ring_margins(_latest_1, _extent_1, _speed_1, _position_level_1, _velocity_level_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1)
        _t_1, _end_1, _searching_1 = ring_enter(0.0, 0.0, _high0_1, _high1_1, _high2_1, _low0_1, _low1_1, _low2_1, 0.0)
        _rows3, _count4 = _rows(_searching_1, _count2)
        if _count4:
            _arrival_2 = _take(_arrival_1, _rows3)
            _ceiling_2 = _take(_ceiling_1, _rows3)
            _certain_2 = _take(_certain_1, _rows3)
            _end_2 = _take(_end_1, _rows3)
            _extent_2 = _take(_extent_1, _rows3)
            _flat_2 = _take(_flat_1, _rows3)
            _high0_2 = _take(_high0_1, _rows3)
            _high1_2 = _take(_high1_1, _rows3)
            _high2_2 = _take(_high2_1, _rows3)
            _last_2 = _take(_last_1, _rows3)
            _latest_2 = _take(_latest_1, _rows3)
            _low0_2 = _take(_low0_1, _rows3)
            _low1_2 = _take(_low1_1, _rows3)
            _low2_2 = _take(_low2_1, _rows3)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows3)
            _p_gravity_2 = _take(_p_gravity_1, _rows3)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows3)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows3)
            _rate_slack_2 = _take(_rate_slack_1, _rows3)
            _rho_start_2 = _take(_rho_start_1, _rows3)
            _searching_2 = _take(_searching_1, _rows3)
            _share_2 = _take(_share_1, _rows3)
            _speed_2 = _take(_speed_1, _rows3)
            _steady_2 = _take(_steady_1, _rows3)
            _swing_2 = _take(_swing_1, _rows3)
            _t_2 = _take(_t_1, _rows3)
            _tilt_2 = _take(_tilt_1, _rows3)
            _vx_2 = _take(_vx_1, _rows3)
            _vy_2 = _take(_vy_1, _rows3)
            _vz_2 = _take(_vz_1, _rows3)
            _x_2 = _take(_x_1, _rows3)
            _y_2 = _take(_y_1, _rows3)
            _z_2 = _take(_z_1, _rows3)
            _arrival_1 = _copy(_arrival_1, _count2)
            _certain_1 = _copy(_certain_1, _count2)
            _flat_1 = _copy(_flat_1, _count2)
            _tilt_1 = _copy(_tilt_1, _count2)
            for _ in range(201):
                _leaving_2, _margin_2 = nearby(_flat_2, 0.0, _last_2, _t_2, _tilt_2)
                _gap_2, _rate_2, _bend_2, _step_2, _next_2, _root_2, _clearance_2 = ring_advance(_t_2, _end_2, _leaving_2, _margin_2, _rate_slack_2, _ceiling_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _steady_2, _swing_2, _rho_start_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2)
                _hit_2, _sure_2, _vague_2 = struck(_bend_2, _clearance_2, _gap_2, _margin_2, _rate_2, _rate_slack_2, _share_2)
                _rows5, _count6 = _rows(_vague_2, _count4)
                if _count6:
                    _extent_3 = _take(_extent_2, _rows5)
                    _latest_3 = _take(_latest_2, _rows5)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows5)
                    _p_gravity_3 = _take(_p_gravity_2, _rows5)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows5)
                    _p_wire_radius_3 = _take(_p_wire_radius_2, _rows5)
                    _share_3 = _take(_share_2, _rows5)
                    _speed_3 = _take(_speed_2, _rows5)
                    _share_3, = finer(_share_3)
                    _position_level_3, _velocity_level_3, *_ = allowance(_share_3, _latest_3, _extent_3, _speed_3, 0.0, 0.0, _p_gravity_3)
                    _flat_3, _tilt_3, _rate_slack_3 = ring_margins(_latest_3, _extent_3, _speed_3, _position_level_3, _velocity_level_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_gravity_3)
                    _flat_2 = _put(_flat_2, _rows5, _flat_3, _count4)
                    _rate_slack_2 = _put(_rate_slack_2, _rows5, _rate_slack_3, _count4)
                    _share_2 = _put(_share_2, _rows5, _share_3, _count4)
                    _tilt_2 = _put(_tilt_2, _rows5, _tilt_3, _count4)
                _arrival_2, _certain_2, _exhausted_2, _searching_2, _t_2 = advanced(_arrival_2, _certain_2, _end_2, _hit_2, _next_2, _root_2, _step_2, _sure_2, _t_2, _vague_2)
                _t_3, _end_3, _searching_3 = ring_enter(_end_2, _end_2, _high0_2, _high1_2, _high2_2, _low0_2, _low1_2, _low2_2, _t_2)
                _end_2 = _where(_exhausted_2, _end_3, _end_2)
                _searching_2 = _where(_exhausted_2, _searching_3, _searching_2)
                _t_2 = _where(_exhausted_2, _t_3, _t_2)
                _going7 = _flatnonzero(_searching_2)
                if len(_going7) == _count4:
                    continue
                _done = _flatnonzero(_logical_not(_searching_2))
                _store(_arrival_1, _of(_rows3, _done), _arrival_2, _done)
                _store(_certain_1, _of(_rows3, _done), _certain_2, _done)
                _store(_flat_1, _of(_rows3, _done), _flat_2, _done)
                _store(_tilt_1, _of(_rows3, _done), _tilt_2, _done)
                _rows3, _count4 = _of(_rows3, _going7), len(_going7)
                if not _count4:
                    break
                _arrival_2 = _take(_arrival_2, _going7)
                _ceiling_2 = _take(_ceiling_2, _going7)
                _certain_2 = _take(_certain_2, _going7)
                _end_2 = _take(_end_2, _going7)
                _extent_2 = _take(_extent_2, _going7)
                _flat_2 = _take(_flat_2, _going7)
                _high0_2 = _take(_high0_2, _going7)
                _high1_2 = _take(_high1_2, _going7)
                _high2_2 = _take(_high2_2, _going7)
                _last_2 = _take(_last_2, _going7)
                _latest_2 = _take(_latest_2, _going7)
                _low0_2 = _take(_low0_2, _going7)
                _low1_2 = _take(_low1_2, _going7)
                _low2_2 = _take(_low2_2, _going7)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going7)
                _p_gravity_2 = _take(_p_gravity_2, _going7)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going7)
                _p_wire_radius_2 = _take(_p_wire_radius_2, _going7)
                _rate_slack_2 = _take(_rate_slack_2, _going7)
                _rho_start_2 = _take(_rho_start_2, _going7)
                _searching_2 = _take(_searching_2, _going7)
                _share_2 = _take(_share_2, _going7)
                _speed_2 = _take(_speed_2, _going7)
                _steady_2 = _take(_steady_2, _going7)
                _swing_2 = _take(_swing_2, _going7)
                _t_2 = _take(_t_2, _going7)
                _tilt_2 = _take(_tilt_2, _going7)
                _vx_2 = _take(_vx_2, _going7)
                _vy_2 = _take(_vy_2, _going7)
                _vz_2 = _take(_vz_2, _going7)
                _x_2 = _take(_x_2, _going7)
                _y_2 = _take(_y_2, _going7)
                _z_2 = _take(_z_2, _going7)
            else:
                _store(_arrival_1, _rows3, _arrival_2, None)
                _store(_certain_1, _rows3, _certain_2, None)
                _store(_flat_1, _rows3, _flat_2, None)
                _store(_tilt_1, _rows3, _tilt_2, None)
        _arrives_1, = found(_arrival_1)
        _leaving_1, *_ = nearby(_flat_1, 0.0, _last_1, _arrival_1, _tilt_1)
        _refined_1, *_ = ring_refine(_arrival_1, _leaving_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _rho_start_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1)
        _arrival_1, = polished(_arrival_1, _certain_1, _refined_1)
        _refined_1, *_ = ring_refine(_arrival_1, _leaving_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _rho_start_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1)
        _arrival_1, = polished(_arrival_1, _certain_1, _refined_1)
        _time_1, = landed(_arrival_1)
        _when_1, _which_1 = sooner(_arrives_1, 0.0, _time_1, _when_1, _which_1)
        _when_0 = _put(_when_0, _rows1, _when_1, shots)
        _which_0 = _put(_which_0, _rows1, _which_1, shots)
    _until_0, *_ = horizon(_when_0, _speed_0, _p_gravity_0)
    _clear_0, = backboard_clear(_until_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _extent_0, _speed_0, 0.0, 0.0, _p_ball_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_board_thickness_0, _p_gravity_0)
    _open_0, = opens(_clear_0)
    _rows8, _count9 = _rows(_open_0, shots)
    if _count9:
        _extent_1 = _take(_extent_0, _rows8)
        _last_1 = _take(_last_0, _rows8)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows8)
        _p_board_bottom_1 = _take(_p_board_bottom_0, _rows8)
        _p_board_distance_1 = _take(_p_board_distance_0, _rows8)
        _p_board_half_width_1 = _take(_p_board_half_width_0, _rows8)
        _p_board_thickness_1 = _take(_p_board_thickness_0, _rows8)
        _p_board_top_1 = _take(_p_board_top_0, _rows8)
        _p_gravity_1 = _take(_p_gravity_0, _rows8)
        _speed_1 = _take(_speed_0, _rows8)
        _until_1 = _take(_until_0, _rows8)
        _vx_1 = _take(_vx_0, _rows8)
        _vy_1 = _take(_vy_0, _rows8)
        _vz_1 = _take(_vz_0, _rows8)
        _when_1 = _take(_when_0, _rows8)
        _which_1 = _take(_which_0, _rows8)
        _x_1 = _take(_x_0, _rows8)
        _y_1 = _take(_y_0, _rows8)
        _z_1 = _take(_z_0, _rows8)
        _low0_1, _high0_1, _low1_1, _high1_1, _ceiling_1, _latest_1, *_ = backboard_prepare(_until_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, 0.0, 0.0, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _p_gravity_1)
        _share_1, _arrival_1, _certain_1 = beginning()
        _position_level_1, _velocity_level_1, *_ = allowance(_share_1, _latest_1, _extent_1, _speed_1, 0.0, 0.0, _p_gravity_1)
        _flat_1, _tilt_1, _rate_slack_1 = backboard_margins(_latest_1, _extent_1, _speed_1, _position_level_1, _velocity_level_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _p_gravity_1)
        _t_1, _end_1, _searching_1 = backboard_enter(0.0, 0.0, _high0_1, _high1_1, _low0_1, _low1_1, 0.0)
        _rows10, _count11 = _rows(_searching_1, _count9)
        if _count11:
            _arrival_2 = _take(_arrival_1, _rows10)
            _ceiling_2 = _take(_ceiling_1, _rows10)
            _certain_2 = _take(_certain_1, _rows10)
            _end_2 = _take(_end_1, _rows10)
            _extent_2 = _take(_extent_1, _rows10)
            _flat_2 = _take(_flat_1, _rows10)
            _high0_2 = _take(_high0_1, _rows10)
            _high1_2 = _take(_high1_1, _rows10)
            _last_2 = _take(_last_1, _rows10)
            _latest_2 = _take(_latest_1, _rows10)
            _low0_2 = _take(_low0_1, _rows10)
            _low1_2 = _take(_low1_1, _rows10)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows10)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows10)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows10)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows10)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows10)
            _p_board_top_2 = _take(_p_board_top_1, _rows10)
            _p_gravity_2 = _take(_p_gravity_1, _rows10)
            _rate_slack_2 = _take(_rate_slack_1, _rows10)
            _searching_2 = _take(_searching_1, _rows10)
            _share_2 = _take(_share_1, _rows10)
            _speed_2 = _take(_speed_1, _rows10)
            _t_2 = _take(_t_1, _rows10)
            _tilt_2 = _take(_tilt_1, _rows10)
            _vx_2 = _take(_vx_1, _rows10)
            _vy_2 = _take(_vy_1, _rows10)
            _vz_2 = _take(_vz_1, _rows10)
            _x_2 = _take(_x_1, _rows10)
            _y_2 = _take(_y_1, _rows10)
            _z_2 = _take(_z_1, _rows10)
            _arrival_1 = _copy(_arrival_1, _count9)
            _certain_1 = _copy(_certain_1, _count9)
            _flat_1 = _copy(_flat_1, _count9)
            _tilt_1 = _copy(_tilt_1, _count9)
            for _ in range(201):
                _leaving_2, _margin_2 = nearby(_flat_2, 1.0, _last_2, _t_2, _tilt_2)
                _gap_2, _rate_2, _bend_2, _step_2, _next_2, _root_2, _clearance_2 = backboard_advance(_t_2, _end_2, _leaving_2, _margin_2, _rate_slack_2, _ceiling_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _p_gravity_2)
                _hit_2, _sure_2, _vague_2 = struck(_bend_2, _clearance_2, _gap_2, _margin_2, _rate_2, _rate_slack_2, _share_2)
                _rows12, _count13 = _rows(_vague_2, _count11)
                if _count13:
                    _extent_3 = _take(_extent_2, _rows12)
                    _latest_3 = _take(_latest_2, _rows12)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows12)
                    _p_board_bottom_3 = _take(_p_board_bottom_2, _rows12)
                    _p_board_distance_3 = _take(_p_board_distance_2, _rows12)
                    _p_board_half_width_3 = _take(_p_board_half_width_2, _rows12)
                    _p_board_thickness_3 = _take(_p_board_thickness_2, _rows12)
                    _p_board_top_3 = _take(_p_board_top_2, _rows12)
                    _p_gravity_3 = _take(_p_gravity_2, _rows12)
                    _share_3 = _take(_share_2, _rows12)
                    _speed_3 = _take(_speed_2, _rows12)
                    _share_3, = finer(_share_3)
                    _position_level_3, _velocity_level_3, *_ = allowance(_share_3, _latest_3, _extent_3, _speed_3, 0.0, 0.0, _p_gravity_3)
                    _flat_3, _tilt_3, _rate_slack_3 = backboard_margins(_latest_3, _extent_3, _speed_3, _position_level_3, _velocity_level_3, _p_ball_radius_3, _p_board_distance_3, _p_board_half_width_3, _p_board_bottom_3, _p_board_top_3, _p_board_thickness_3, _p_gravity_3)
                    _flat_2 = _put(_flat_2, _rows12, _flat_3, _count11)
                    _rate_slack_2 = _put(_rate_slack_2, _rows12, _rate_slack_3, _count11)
                    _share_2 = _put(_share_2, _rows12, _share_3, _count11)
                    _tilt_2 = _put(_tilt_2, _rows12, _tilt_3, _count11)
                _arrival_2, _certain_2, _exhausted_2, _searching_2, _t_2 = advanced(_arrival_2, _certain_2, _end_2, _hit_2, _next_2, _root_2, _step_2, _sure_2, _t_2, _vague_2)
                _t_3, _end_3, _searching_3 = backboard_enter(_end_2, _end_2, _high0_2, _high1_2, _low0_2, _low1_2, _t_2)
                _end_2 = _where(_exhausted_2, _end_3, _end_2)
                _searching_2 = _where(_exhausted_2, _searching_3, _searching_2)
                _t_2 = _where(_exhausted_2, _t_3, _t_2)
                _going14 = _flatnonzero(_searching_2)
                if len(_going14) == _count11:
                    continue
                _done = _flatnonzero(_logical_not(_searching_2))
                _store(_arrival_1, _of(_rows10, _done), _arrival_2, _done)
                _store(_certain_1, _of(_rows10, _done), _certain_2, _done)
                _store(_flat_1, _of(_rows10, _done), _flat_2, _done)
                _store(_tilt_1, _of(_rows10, _done), _tilt_2, _done)
                _rows10, _count11 = _of(_rows10, _going14), len(_going14)
                if not _count11:
                    break
                _arrival_2 = _take(_arrival_2, _going14)
                _ceiling_2 = _take(_ceiling_2, _going14)
                _certain_2 = _take(_certain_2, _going14)
                _end_2 = _take(_end_2, _going14)
                _extent_2 = _take(_extent_2, _going14)
                _flat_2 = _take(_flat_2, _going14)
                _high0_2 = _take(_high0_2, _going14)
                _high1_2 = _take(_high1_2, _going14)
                _last_2 = _take(_last_2, _going14)
                _latest_2 = _take(_latest_2, _going14)
                _low0_2 = _take(_low0_2, _going14)
                _low1_2 = _take(_low1_2, _going14)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going14)
                _p_board_bottom_2 = _take(_p_board_bottom_2, _going14)
                _p_board_distance_2 = _take(_p_board_distance_2, _going14)
                _p_board_half_width_2 = _take(_p_board_half_width_2, _going14)
                _p_board_thickness_2 = _take(_p_board_thickness_2, _going14)
                _p_board_top_2 = _take(_p_board_top_2, _going14)
                _p_gravity_2 = _take(_p_gravity_2, _going14)
                _rate_slack_2 = _take(_rate_slack_2, _going14)
                _searching_2 = _take(_searching_2, _going14)
                _share_2 = _take(_share_2, _going14)
                _speed_2 = _take(_speed_2, _going14)
                _t_2 = _take(_t_2, _going14)
                _tilt_2 = _take(_tilt_2, _going14)
                _vx_2 = _take(_vx_2, _going14)
                _vy_2 = _take(_vy_2, _going14)
                _vz_2 = _take(_vz_2, _going14)
                _x_2 = _take(_x_2, _going14)
                _y_2 = _take(_y_2, _going14)
                _z_2 = _take(_z_2, _going14)
            else:
                _store(_arrival_1, _rows10, _arrival_2, None)
                _store(_certain_1, _rows10, _certain_2, None)
                _store(_flat_1, _rows10, _flat_2, None)
                _store(_tilt_1, _rows10, _tilt_2, None)
        _arrives_1, = found(_arrival_1)
        _leaving_1, *_ = nearby(_flat_1, 1.0, _last_1, _arrival_1, _tilt_1)
        _refined_1, *_ = backboard_refine(_arrival_1, _leaving_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _p_gravity_1)
        _arrival_1, = polished(_arrival_1, _certain_1, _refined_1)
        _refined_1, *_ = backboard_refine(_arrival_1, _leaving_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _p_gravity_1)
        _arrival_1, = polished(_arrival_1, _certain_1, _refined_1)
        _time_1, = landed(_arrival_1)
        _when_1, _which_1 = sooner(_arrives_1, 1.0, _time_1, _when_1, _which_1)
        _when_0 = _put(_when_0, _rows8, _when_1, shots)
        _which_0 = _put(_which_0, _rows8, _which_1, shots)
    _until_0, *_ = horizon(_when_0, _speed_0, _p_gravity_0)
    _clear_0, = bridge_clear(_until_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _extent_0, _speed_0, 0.0, 0.0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_bridge_half_width_0, _p_bridge_depth_0, _p_gravity_0)
    _open_0, = opens(_clear_0)
    _rows15, _count16 = _rows(_open_0, shots)
    if _count16:
        _extent_1 = _take(_extent_0, _rows15)
        _last_1 = _take(_last_0, _rows15)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows15)
        _p_board_distance_1 = _take(_p_board_distance_0, _rows15)
        _p_bridge_depth_1 = _take(_p_bridge_depth_0, _rows15)
        _p_bridge_half_width_1 = _take(_p_bridge_half_width_0, _rows15)
        _p_gravity_1 = _take(_p_gravity_0, _rows15)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows15)
        _p_wire_radius_1 = _take(_p_wire_radius_0, _rows15)
        _speed_1 = _take(_speed_0, _rows15)
        _until_1 = _take(_until_0, _rows15)
        _vx_1 = _take(_vx_0, _rows15)
        _vy_1 = _take(_vy_0, _rows15)
        _vz_1 = _take(_vz_0, _rows15)
        _when_1 = _take(_when_0, _rows15)
        _which_1 = _take(_which_0, _rows15)
        _x_1 = _take(_x_0, _rows15)
        _y_1 = _take(_y_0, _rows15)
        _z_1 = _take(_z_0, _rows15)
        _low0_1, _high0_1, _low1_1, _high1_1, _ceiling_1, _latest_1, *_ = bridge_prepare(_until_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, 0.0, 0.0, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _p_gravity_1)
        _share_1, _arrival_1, _certain_1 = beginning()
        _position_level_1, _velocity_level_1, *_ = allowance(_share_1, _latest_1, _extent_1, _speed_1, 0.0, 0.0, _p_gravity_1)
        _flat_1, _tilt_1, _rate_slack_1 = bridge_margins(_latest_1, _extent_1, _speed_1, _position_level_1, _velocity_level_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _p_gravity_1)
        _t_1, _end_1, _searching_1 = bridge_enter(0.0, 0.0, _high0_1, _high1_1, _low0_1, _low1_1, 0.0)
        _rows17, _count18 = _rows(_searching_1, _count16)
        if _count18:
            _arrival_2 = _take(_arrival_1, _rows17)
            _ceiling_2 = _take(_ceiling_1, _rows17)
            _certain_2 = _take(_certain_1, _rows17)
            _end_2 = _take(_end_1, _rows17)
            _extent_2 = _take(_extent_1, _rows17)
            _flat_2 = _take(_flat_1, _rows17)
            _high0_2 = _take(_high0_1, _rows17)
            _high1_2 = _take(_high1_1, _rows17)
            _last_2 = _take(_last_1, _rows17)
            _latest_2 = _take(_latest_1, _rows17)
            _low0_2 = _take(_low0_1, _rows17)
            _low1_2 = _take(_low1_1, _rows17)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows17)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows17)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows17)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows17)
            _p_gravity_2 = _take(_p_gravity_1, _rows17)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows17)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows17)
            _rate_slack_2 = _take(_rate_slack_1, _rows17)
            _searching_2 = _take(_searching_1, _rows17)
            _share_2 = _take(_share_1, _rows17)
            _speed_2 = _take(_speed_1, _rows17)
            _t_2 = _take(_t_1, _rows17)
            _tilt_2 = _take(_tilt_1, _rows17)
            _vx_2 = _take(_vx_1, _rows17)
            _vy_2 = _take(_vy_1, _rows17)
            _vz_2 = _take(_vz_1, _rows17)
            _x_2 = _take(_x_1, _rows17)
            _y_2 = _take(_y_1, _rows17)
            _z_2 = _take(_z_1, _rows17)
            _arrival_1 = _copy(_arrival_1, _count16)
            _certain_1 = _copy(_certain_1, _count16)
            _flat_1 = _copy(_flat_1, _count16)
            _tilt_1 = _copy(_tilt_1, _count16)
            for _ in range(201):
                _leaving_2, _margin_2 = nearby(_flat_2, 2.0, _last_2, _t_2, _tilt_2)
                _gap_2, _rate_2, _bend_2, _step_2, _next_2, _root_2, _clearance_2 = bridge_advance(_t_2, _end_2, _leaving_2, _margin_2, _rate_slack_2, _ceiling_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _p_gravity_2)
                _hit_2, _sure_2, _vague_2 = struck(_bend_2, _clearance_2, _gap_2, _margin_2, _rate_2, _rate_slack_2, _share_2)
                _rows19, _count20 = _rows(_vague_2, _count18)
                if _count20:
                    _extent_3 = _take(_extent_2, _rows19)
                    _latest_3 = _take(_latest_2, _rows19)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows19)
                    _p_board_distance_3 = _take(_p_board_distance_2, _rows19)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_2, _rows19)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_2, _rows19)
                    _p_gravity_3 = _take(_p_gravity_2, _rows19)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows19)
                    _p_wire_radius_3 = _take(_p_wire_radius_2, _rows19)
                    _share_3 = _take(_share_2, _rows19)
                    _speed_3 = _take(_speed_2, _rows19)
                    _share_3, = finer(_share_3)
                    _position_level_3, _velocity_level_3, *_ = allowance(_share_3, _latest_3, _extent_3, _speed_3, 0.0, 0.0, _p_gravity_3)
                    _flat_3, _tilt_3, _rate_slack_3 = bridge_margins(_latest_3, _extent_3, _speed_3, _position_level_3, _velocity_level_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_board_distance_3, _p_bridge_half_width_3, _p_bridge_depth_3, _p_gravity_3)
                    _flat_2 = _put(_flat_2, _rows19, _flat_3, _count18)
                    _rate_slack_2 = _put(_rate_slack_2, _rows19, _rate_slack_3, _count18)
                    _share_2 = _put(_share_2, _rows19, _share_3, _count18)
                    _tilt_2 = _put(_tilt_2, _rows19, _tilt_3, _count18)
                _arrival_2, _certain_2, _exhausted_2, _searching_2, _t_2 = advanced(_arrival_2, _certain_2, _end_2, _hit_2, _next_2, _root_2, _step_2, _sure_2, _t_2, _vague_2)
                _t_3, _end_3, _searching_3 = bridge_enter(_end_2, _end_2, _high0_2, _high1_2, _low0_2, _low1_2, _t_2)
                _end_2 = _where(_exhausted_2, _end_3, _end_2)
                _searching_2 = _where(_exhausted_2, _searching_3, _searching_2)
                _t_2 = _where(_exhausted_2, _t_3, _t_2)
                _going21 = _flatnonzero(_searching_2)
                if len(_going21) == _count18:
                    continue
                _done = _flatnonzero(_logical_not(_searching_2))
                _store(_arrival_1, _of(_rows17, _done), _arrival_2, _done)
                _store(_certain_1, _of(_rows17, _done), _certain_2, _done)
                _store(_flat_1, _of(_rows17, _done), _flat_2, _done)
                _store(_tilt_1, _of(_rows17, _done), _tilt_2, _done)
                _rows17, _count18 = _of(_rows17, _going21), len(_going21)
                if not _count18:
                    break
                _arrival_2 = _take(_arrival_2, _going21)
                _ceiling_2 = _take(_ceiling_2, _going21)
                _certain_2 = _take(_certain_2, _going21)
                _end_2 = _take(_end_2, _going21)
                _extent_2 = _take(_extent_2, _going21)
                _flat_2 = _take(_flat_2, _going21)
                _high0_2 = _take(_high0_2, _going21)
                _high1_2 = _take(_high1_2, _going21)
                _last_2 = _take(_last_2, _going21)
                _latest_2 = _take(_latest_2, _going21)
                _low0_2 = _take(_low0_2, _going21)
                _low1_2 = _take(_low1_2, _going21)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going21)
                _p_board_distance_2 = _take(_p_board_distance_2, _going21)
                _p_bridge_depth_2 = _take(_p_bridge_depth_2, _going21)
                _p_bridge_half_width_2 = _take(_p_bridge_half_width_2, _going21)
                _p_gravity_2 = _take(_p_gravity_2, _going21)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going21)
                _p_wire_radius_2 = _take(_p_wire_radius_2, _going21)
                _rate_slack_2 = _take(_rate_slack_2, _going21)
                _searching_2 = _take(_searching_2, _going21)
                _share_2 = _take(_share_2, _going21)
                _speed_2 = _take(_speed_2, _going21)
                _t_2 = _take(_t_2, _going21)
                _tilt_2 = _take(_tilt_2, _going21)
                _vx_2 = _take(_vx_2, _going21)
                _vy_2 = _take(_vy_2, _going21)
                _vz_2 = _take(_vz_2, _going21)
                _x_2 = _take(_x_2, _going21)
                _y_2 = _take(_y_2, _going21)
                _z_2 = _take(_z_2, _going21)
            else:
                _store(_arrival_1, _rows17, _arrival_2, None)
                _store(_certain_1, _rows17, _certain_2, None)
                _store(_flat_1, _rows17, _flat_2, None)
                _store(_tilt_1, _rows17, _tilt_2, None)
        _arrives_1, = found(_arrival_1)
        _leaving_1, *_ = nearby(_flat_1, 2.0, _last_1, _arrival_1, _tilt_1)
        _refined_1, *_ = bridge_refine(_arrival_1, _leaving_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _p_gravity_1)
        _arrival_1, = polished(_arrival_1, _certain_1, _refined_1)
        _refined_1, *_ = bridge_refine(_arrival_1, _leaving_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _p_gravity_1)
        _arrival_1, = polished(_arrival_1, _certain_1, _refined_1)
        _time_1, = landed(_arrival_1)
        _when_1, _which_1 = sooner(_arrives_1, 2.0, _time_1, _when_1, _which_1)
        _when_0 = _put(_when_0, _rows15, _when_1, shots)
        _which_0 = _put(_which_0, _rows15, _which_1, shots)
    _rows22, _count23 = _rows(_limited_0, shots)
    if _count23:
        _clock_1 = _take(_clock_0, _rows22)
        _time_error_1 = _take(_time_error_0, _rows22)
        _time_limit_1 = _take(_time_limit_0, _rows22)
        _when_1 = _take(_when_0, _rows22)
        _which_1 = _take(_which_0, _rows22)
        _time_1, _, _arrives_1, *_ = expiry(_clock_1, _inf, 0.0, _time_error_1, _time_limit_1, _when_1, _which_1)
        _when_1, _which_1 = sooner(_arrives_1, 4.0, _time_1, _when_1, _which_1)
        _when_0 = _put(_when_0, _rows22, _when_1, shots)
        _which_0 = _put(_which_0, _rows22, _which_1, shots)
    _, _moves_0, _ends_0, _touches_0, _reached_0, *_ = departed(3.0, _which_0)
    _body_0, = body_of(_which_0)
    _rows24, _count25 = _rows(_moves_0, shots)
    if _count25:
        _clock_1 = _take(_clock_0, _rows24)
        _p_gravity_1 = _take(_p_gravity_0, _rows24)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows24)
        _through_1 = _take(_through_0, _rows24)
        _vx_1 = _take(_vx_0, _rows24)
        _vy_1 = _take(_vy_0, _rows24)
        _vz_1 = _take(_vz_0, _rows24)
        _when_1 = _take(_when_0, _rows24)
        _x_1 = _take(_x_0, _rows24)
        _y_1 = _take(_y_0, _rows24)
        _z_1 = _take(_z_0, _rows24)
        _through_1, = passing(_through_1, _when_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ring_radius_1, _p_gravity_1)
        _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1 = flight(_when_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_gravity_1)
        _clock_1, = ticked(_clock_1, _when_1)
        _clock_0 = _put(_clock_0, _rows24, _clock_1, shots)
        _through_0 = _put(_through_0, _rows24, _through_1, shots)
        _vx_0 = _put(_vx_0, _rows24, _vx_1, shots)
        _vy_0 = _put(_vy_0, _rows24, _vy_1, shots)
        _vz_0 = _put(_vz_0, _rows24, _vz_1, shots)
        _x_0 = _put(_x_0, _rows24, _x_1, shots)
        _y_0 = _put(_y_0, _rows24, _y_1, shots)
        _z_0 = _put(_z_0, _rows24, _z_1, shots)
    _rows26, _count27 = _rows(_limited_0, shots)
    if _count27:
        _body_1 = _take(_body_0, _rows26)
        _clock_1 = _take(_clock_0, _rows26)
        _ends_1 = _take(_ends_0, _rows26)
        _reached_1 = _take(_reached_0, _rows26)
        _time_limit_1 = _take(_time_limit_0, _rows26)
        _which_1 = _take(_which_0, _rows26)
        _clock_1, _body_1, _reached_1, _ends_1 = expired(_body_1, _clock_1, _ends_1, 4.0, _reached_1, _time_limit_1, _which_1)
        _body_0 = _put(_body_0, _rows26, _body_1, shots)
        _clock_0 = _put(_clock_0, _rows26, _clock_1, shots)
        _ends_0 = _put(_ends_0, _rows26, _ends_1, shots)
        _reached_0 = _put(_reached_0, _rows26, _reached_1, shots)
    _here_0, = here(3.0, _which_0)
    _g0_1, = end_bounds(_x_0, _y_0, _p_ring_radius_0)
    _reached_1, = end_reached(_g0_1, _through_0)
    _reached_0 = _where(_here_0, _reached_1, _reached_0)
    _contacts_0, _outcome_0 = accounted(_contacts_0, _most_contacts_0, _reached_0, _touches_0)
    columns["body"] = _body_0
    columns["clock"] = _clock_0
    columns["contacts"] = _contacts_0
    columns["ends"] = _ends_0
    columns["outcome"] = _outcome_0
    columns["through"] = _through_0
    columns["touches"] = _touches_0
    columns["vx"] = _vx_0
    columns["vy"] = _vy_0
    columns["vz"] = _vz_0
    columns["which"] = _which_0
    columns["x"] = _x_0
    columns["y"] = _y_0
    columns["z"] = _z_0


def meet_plain(columns: dict[str, Any], shots: int) -> None:
    """Stage meet of the event loop, the path alone."""
    _body_0 = columns["body"]
    _count_0_0 = columns["count_0"]
    _count_1_0 = columns["count_1"]
    _count_2_0 = columns["count_2"]
    _ends_0 = columns["ends"]
    _first_0 = columns["first"]
    _last_0 = columns["last"]
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
    _p_restitution_speed_0 = columns["p_restitution_speed"]
    _p_ring_friction_0 = columns["p_ring_friction"]
    _p_ring_radius_0 = columns["p_ring_radius"]
    _p_ring_restitution_0 = columns["p_ring_restitution"]
    _p_tangential_restitution_0 = columns["p_tangential_restitution"]
    _p_wire_radius_0 = columns["p_wire_radius"]
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
        _p_restitution_speed_1 = _take(_p_restitution_speed_0, _rows1)
        _p_ring_friction_1 = _take(_p_ring_friction_0, _rows1)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows1)
        _p_ring_restitution_1 = _take(_p_ring_restitution_0, _rows1)
        _p_tangential_restitution_1 = _take(_p_tangential_restitution_0, _rows1)
        _p_wire_radius_1 = _take(_p_wire_radius_0, _rows1)
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
        _nx_1, _ny_1, _nz_1 = end_normal()
        _here_1, = here(0.0, _which_1)
        _nx_2, _ny_2, _nz_2 = ring_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1)
        _count_0_2, = counted(_count_0_1)
        _count_0_1 = _where(_here_1, _count_0_2, _count_0_1)
        _nx_1 = _where(_here_1, _nx_2, _nx_1)
        _ny_1 = _where(_here_1, _ny_2, _ny_1)
        _nz_1 = _where(_here_1, _nz_2, _nz_1)
        _here_1, = here(1.0, _which_1)
        _nx_2, _ny_2, _nz_2 = backboard_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1)
        _count_1_2, = counted(_count_1_1)
        _count_1_1 = _where(_here_1, _count_1_2, _count_1_1)
        _nx_1 = _where(_here_1, _nx_2, _nx_1)
        _ny_1 = _where(_here_1, _ny_2, _ny_1)
        _nz_1 = _where(_here_1, _nz_2, _nz_1)
        _here_1, = here(2.0, _which_1)
        _nx_2, _ny_2, _nz_2 = bridge_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1)
        _count_2_2, = counted(_count_2_1)
        _count_2_1 = _where(_here_1, _count_2_2, _count_2_1)
        _nx_1 = _where(_here_1, _nx_2, _nx_1)
        _ny_1 = _where(_here_1, _ny_2, _ny_1)
        _nz_1 = _where(_here_1, _nz_2, _nz_1)
        _here_1, = here(0.0, _which_1)
        _rows3, _count4 = _rows(_here_1, _count2)
        if _count4:
            _nx_2 = _take(_nx_1, _rows3)
            _ny_2 = _take(_ny_1, _rows3)
            _nz_2 = _take(_nz_1, _rows3)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows3)
            _p_restitution_speed_2 = _take(_p_restitution_speed_1, _rows3)
            _p_ring_friction_2 = _take(_p_ring_friction_1, _rows3)
            _p_ring_restitution_2 = _take(_p_ring_restitution_1, _rows3)
            _p_tangential_restitution_2 = _take(_p_tangential_restitution_1, _rows3)
            _vx_2 = _take(_vx_1, _rows3)
            _vy_2 = _take(_vy_1, _rows3)
            _vz_2 = _take(_vz_1, _rows3)
            _wx_2 = _take(_wx_1, _rows3)
            _wy_2 = _take(_wy_1, _rows3)
            _wz_2 = _take(_wz_1, _rows3)
            _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = ring_impact(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _p_ball_radius_2, _p_ring_restitution_2, _p_ring_friction_2, _p_tangential_restitution_2, _p_restitution_speed_2)
            _vx_1 = _put(_vx_1, _rows3, _vx_2, _count2)
            _vy_1 = _put(_vy_1, _rows3, _vy_2, _count2)
            _vz_1 = _put(_vz_1, _rows3, _vz_2, _count2)
            _wx_1 = _put(_wx_1, _rows3, _wx_2, _count2)
            _wy_1 = _put(_wy_1, _rows3, _wy_2, _count2)
            _wz_1 = _put(_wz_1, _rows3, _wz_2, _count2)
        _here_1, = here(1.0, _which_1)
        _rows5, _count6 = _rows(_here_1, _count2)
        if _count6:
            _nx_2 = _take(_nx_1, _rows5)
            _ny_2 = _take(_ny_1, _rows5)
            _nz_2 = _take(_nz_1, _rows5)
            _p_backboard_friction_2 = _take(_p_backboard_friction_1, _rows5)
            _p_backboard_restitution_2 = _take(_p_backboard_restitution_1, _rows5)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows5)
            _p_restitution_speed_2 = _take(_p_restitution_speed_1, _rows5)
            _p_tangential_restitution_2 = _take(_p_tangential_restitution_1, _rows5)
            _vx_2 = _take(_vx_1, _rows5)
            _vy_2 = _take(_vy_1, _rows5)
            _vz_2 = _take(_vz_1, _rows5)
            _wx_2 = _take(_wx_1, _rows5)
            _wy_2 = _take(_wy_1, _rows5)
            _wz_2 = _take(_wz_1, _rows5)
            _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = backboard_impact(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _p_ball_radius_2, _p_backboard_restitution_2, _p_backboard_friction_2, _p_tangential_restitution_2, _p_restitution_speed_2)
            _vx_1 = _put(_vx_1, _rows5, _vx_2, _count2)
            _vy_1 = _put(_vy_1, _rows5, _vy_2, _count2)
            _vz_1 = _put(_vz_1, _rows5, _vz_2, _count2)
            _wx_1 = _put(_wx_1, _rows5, _wx_2, _count2)
            _wy_1 = _put(_wy_1, _rows5, _wy_2, _count2)
            _wz_1 = _put(_wz_1, _rows5, _wz_2, _count2)
        _here_1, = here(2.0, _which_1)
        _rows7, _count8 = _rows(_here_1, _count2)
        if _count8:
            _nx_2 = _take(_nx_1, _rows7)
            _ny_2 = _take(_ny_1, _rows7)
            _nz_2 = _take(_nz_1, _rows7)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows7)
            _p_bridge_friction_2 = _take(_p_bridge_friction_1, _rows7)
            _p_bridge_restitution_2 = _take(_p_bridge_restitution_1, _rows7)
            _p_restitution_speed_2 = _take(_p_restitution_speed_1, _rows7)
            _p_tangential_restitution_2 = _take(_p_tangential_restitution_1, _rows7)
            _vx_2 = _take(_vx_1, _rows7)
            _vy_2 = _take(_vy_1, _rows7)
            _vz_2 = _take(_vz_1, _rows7)
            _wx_2 = _take(_wx_1, _rows7)
            _wy_2 = _take(_wy_1, _rows7)
            _wz_2 = _take(_wz_1, _rows7)
            _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = bridge_impact(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _p_ball_radius_2, _p_bridge_restitution_2, _p_bridge_friction_2, _p_tangential_restitution_2, _p_restitution_speed_2)
            _vx_1 = _put(_vx_1, _rows7, _vx_2, _count2)
            _vy_1 = _put(_vy_1, _rows7, _vy_2, _count2)
            _vz_1 = _put(_vz_1, _rows7, _vz_2, _count2)
            _wx_1 = _put(_wx_1, _rows7, _wx_2, _count2)
            _wy_1 = _put(_wy_1, _rows7, _wy_2, _count2)
            _wz_1 = _put(_wz_1, _rows7, _wz_2, _count2)
        _first_2, _last_2 = touched(_body_1, _first_1, _which_1)
        _first_1 = _where(_touches_1, _first_2, _first_1)
        _last_1 = _where(_touches_1, _last_2, _last_1)
        _count_0_0 = _put(_count_0_0, _rows1, _count_0_1, shots)
        _count_1_0 = _put(_count_1_0, _rows1, _count_1_1, shots)
        _count_2_0 = _put(_count_2_0, _rows1, _count_2_1, shots)
        _first_0 = _put(_first_0, _rows1, _first_1, shots)
        _last_0 = _put(_last_0, _rows1, _last_1, shots)
        _vx_0 = _put(_vx_0, _rows1, _vx_1, shots)
        _vy_0 = _put(_vy_0, _rows1, _vy_1, shots)
        _vz_0 = _put(_vz_0, _rows1, _vz_1, shots)
        _wx_0 = _put(_wx_0, _rows1, _wx_1, shots)
        _wy_0 = _put(_wy_0, _rows1, _wy_1, shots)
        _wz_0 = _put(_wz_0, _rows1, _wz_1, shots)
    columns["count_0"] = _count_0_0
    columns["count_1"] = _count_1_0
    columns["count_2"] = _count_2_0
    columns["first"] = _first_0
    columns["last"] = _last_0
    columns["vx"] = _vx_0
    columns["vy"] = _vy_0
    columns["vz"] = _vz_0
    columns["wx"] = _wx_0
    columns["wy"] = _wy_0
    columns["wz"] = _wz_0


def permit_bounded(columns: dict[str, Any], shots: int) -> None:
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


def admit_bounded(columns: dict[str, Any], shots: int) -> None:
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
    _finite_0, = finite_state(_vx_0, _vy_0, _vz_0, _wx_0, _wy_0, _wz_0, _x_0, _y_0, _z_0)
    _valid_0, _doubt_0 = valid(_last_0, _x_0, _y_0, _z_0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_board_thickness_0, _p_bridge_half_width_0, _p_bridge_depth_0, _p_end_depth_0)
    _outcome_0, _uncertain_0 = admitted(_doubt_0, _finite_0, _permitted_0, _valid_0)
    _through_0, _uncertain_0 = passing_start(_last_0, _outcome_0, _uncertain_0, _x_0, _y_0, _z_0, _p_ring_radius_0, _p_end_depth_0)
    columns["outcome"] = _outcome_0
    columns["through"] = _through_0
    columns["uncertain"] = _uncertain_0


def reach_bounded(columns: dict[str, Any], shots: int) -> None:
    """Stage reach of the event loop, with bounds on errors."""
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
    _last_0 = columns["last"]
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
    _through_0 = columns["through"]
    _time_limit_0 = columns["time_limit"]
    _uncertain_0 = columns["uncertain"]
    _vx_0 = columns["vx"]
    _vy_0 = columns["vy"]
    _vz_0 = columns["vz"]
    _x_0 = columns["x"]
    _y_0 = columns["y"]
    _z_0 = columns["z"]
    _position_error_0, _velocity_error_0, _, _time_error_0 = error_bounds(_clock_error_0, _dx_0, _dy_0, _dz_0, _dvx_0, _dvy_0, _dvz_0, _dwx_0, _dwy_0, _dwz_0)
    _extent_0, _speed_0, _excess_0 = scale(_x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _p_gravity_0)
    _when_0, _which_0, _late_0, _doubt_0 = opening(_excess_0, _position_error_0, _velocity_error_0)
    _limited_0, = limited(_time_limit_0)
    _leaving_0, = left(3.0, _last_0)
    _time_0, _rate_0, _bend_0, _apex_0, _height_0 = end_arrival(_leaving_0, _z_0, _vz_0, _p_gravity_0, _p_end_depth_0)
    _arrives_0, _ceiling_0 = meeting_plane(_bend_0, _rate_0, _time_0)
    _margin_0, = end_margin(_time_0, _extent_0, _speed_0, _position_error_0, _velocity_error_0, _p_gravity_0, _p_end_depth_0)
    _clearance_0, _delay_0 = crossing(_margin_0, 0.0, _rate_0, _ceiling_0)
    _possible_0, = timely(_arrives_0, _delay_0, _late_0, _time_0, _when_0)
    _margin_0, = end_margin(_apex_0, _extent_0, _speed_0, _position_error_0, _velocity_error_0, _p_gravity_0, _p_end_depth_0)
    _doubt_0, = grazed(_apex_0, _doubt_0, _height_0, _margin_0)
    _doubt_1, = crossed(_arrives_0, _clearance_0, _doubt_0, _time_0)
    _doubt_1, _late_1 = tied(_arrives_0, _delay_0, _doubt_1, _late_0, _time_0, _when_0)
    _when_1, _which_1 = sooner(_arrives_0, 3.0, _time_0, _when_0, _which_0)
    _doubt_0 = _where(_possible_0, _doubt_1, _doubt_0)
    _late_0 = _where(_possible_0, _late_1, _late_0)
    _when_0 = _where(_possible_0, _when_1, _when_0)
    _which_0 = _where(_possible_0, _which_1, _which_0)
    _until_0, _pad_0 = horizon(_when_0, _speed_0, _p_gravity_0)
    _clear_0, = ring_clear(_until_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _extent_0, _speed_0, _position_error_0, _velocity_error_0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_gravity_0)
    _open_0, = opens(_clear_0)
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
        _steady_1, _swing_1, _rho_start_1, _low0_1, _high0_1, _low1_1, _high1_1, _low2_1, _high2_1, _ceiling_1, _latest_1, _lost_1 = ring_prepare(_until_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1)
        _share_1, _arrival_1, _certain_1 = beginning()
        _position_level_1, _velocity_level_1, _excess_1 = allowance(_share_1, _latest_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_gravity_1)
        _flat_1, _tilt_1, _rate_slack_1 = ring_margins(_latest_1, _extent_1, _speed_1, _position_level_1, _velocity_level_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1)
        _doubt_1, = beyond(_doubt_1, _excess_1, _late_1, _lost_1, _pad_1)
        _t_1, _end_1, _searching_1 = ring_enter(0.0, 0.0, _high0_1, _high1_1, _high2_1, _low0_1, _low1_1, _low2_1, 0.0)
        _rows3, _count4 = _rows(_searching_1, _count2)
        if _count4:
            _arrival_2 = _take(_arrival_1, _rows3)
            _ceiling_2 = _take(_ceiling_1, _rows3)
            _certain_2 = _take(_certain_1, _rows3)
            _doubt_2 = _take(_doubt_1, _rows3)
            _end_2 = _take(_end_1, _rows3)
            _extent_2 = _take(_extent_1, _rows3)
            _flat_2 = _take(_flat_1, _rows3)
            _high0_2 = _take(_high0_1, _rows3)
            _high1_2 = _take(_high1_1, _rows3)
            _high2_2 = _take(_high2_1, _rows3)
            _last_2 = _take(_last_1, _rows3)
            _latest_2 = _take(_latest_1, _rows3)
            _low0_2 = _take(_low0_1, _rows3)
            _low1_2 = _take(_low1_1, _rows3)
            _low2_2 = _take(_low2_1, _rows3)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows3)
            _p_gravity_2 = _take(_p_gravity_1, _rows3)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows3)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows3)
            _position_error_2 = _take(_position_error_1, _rows3)
            _rate_slack_2 = _take(_rate_slack_1, _rows3)
            _rho_start_2 = _take(_rho_start_1, _rows3)
            _searching_2 = _take(_searching_1, _rows3)
            _share_2 = _take(_share_1, _rows3)
            _speed_2 = _take(_speed_1, _rows3)
            _steady_2 = _take(_steady_1, _rows3)
            _swing_2 = _take(_swing_1, _rows3)
            _t_2 = _take(_t_1, _rows3)
            _tilt_2 = _take(_tilt_1, _rows3)
            _velocity_error_2 = _take(_velocity_error_1, _rows3)
            _vx_2 = _take(_vx_1, _rows3)
            _vy_2 = _take(_vy_1, _rows3)
            _vz_2 = _take(_vz_1, _rows3)
            _x_2 = _take(_x_1, _rows3)
            _y_2 = _take(_y_1, _rows3)
            _z_2 = _take(_z_1, _rows3)
            _arrival_1 = _copy(_arrival_1, _count2)
            _certain_1 = _copy(_certain_1, _count2)
            _doubt_1 = _copy(_doubt_1, _count2)
            _flat_1 = _copy(_flat_1, _count2)
            _searching_1 = _copy(_searching_1, _count2)
            _t_1 = _copy(_t_1, _count2)
            _tilt_1 = _copy(_tilt_1, _count2)
            for _ in range(201):
                _leaving_2, _margin_2 = nearby(_flat_2, 0.0, _last_2, _t_2, _tilt_2)
                _gap_2, _rate_2, _bend_2, _step_2, _next_2, _root_2, _clearance_2 = ring_advance(_t_2, _end_2, _leaving_2, _margin_2, _rate_slack_2, _ceiling_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _steady_2, _swing_2, _rho_start_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_gravity_2)
                _hit_2, _sure_2, _vague_2 = struck(_bend_2, _clearance_2, _gap_2, _margin_2, _rate_2, _rate_slack_2, _share_2)
                _rows5, _count6 = _rows(_vague_2, _count4)
                if _count6:
                    _doubt_3 = _take(_doubt_2, _rows5)
                    _extent_3 = _take(_extent_2, _rows5)
                    _latest_3 = _take(_latest_2, _rows5)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows5)
                    _p_gravity_3 = _take(_p_gravity_2, _rows5)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows5)
                    _p_wire_radius_3 = _take(_p_wire_radius_2, _rows5)
                    _position_error_3 = _take(_position_error_2, _rows5)
                    _share_3 = _take(_share_2, _rows5)
                    _speed_3 = _take(_speed_2, _rows5)
                    _t_3 = _take(_t_2, _rows5)
                    _velocity_error_3 = _take(_velocity_error_2, _rows5)
                    _share_3, = finer(_share_3)
                    _position_level_3, _velocity_level_3, _excess_3 = allowance(_share_3, _latest_3, _extent_3, _speed_3, _position_error_3, _velocity_error_3, _p_gravity_3)
                    _flat_3, _tilt_3, _rate_slack_3 = ring_margins(_latest_3, _extent_3, _speed_3, _position_level_3, _velocity_level_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_gravity_3)
                    _doubt_3, = exceeded(_doubt_3, _excess_3, _t_3)
                    _doubt_2 = _put(_doubt_2, _rows5, _doubt_3, _count4)
                    _flat_2 = _put(_flat_2, _rows5, _flat_3, _count4)
                    _rate_slack_2 = _put(_rate_slack_2, _rows5, _rate_slack_3, _count4)
                    _share_2 = _put(_share_2, _rows5, _share_3, _count4)
                    _tilt_2 = _put(_tilt_2, _rows5, _tilt_3, _count4)
                _arrival_2, _certain_2, _exhausted_2, _searching_2, _t_2 = advanced(_arrival_2, _certain_2, _end_2, _hit_2, _next_2, _root_2, _step_2, _sure_2, _t_2, _vague_2)
                _t_3, _end_3, _searching_3 = ring_enter(_end_2, _end_2, _high0_2, _high1_2, _high2_2, _low0_2, _low1_2, _low2_2, _t_2)
                _end_2 = _where(_exhausted_2, _end_3, _end_2)
                _searching_2 = _where(_exhausted_2, _searching_3, _searching_2)
                _t_2 = _where(_exhausted_2, _t_3, _t_2)
                _going7 = _flatnonzero(_searching_2)
                if len(_going7) == _count4:
                    continue
                _done = _flatnonzero(_logical_not(_searching_2))
                _store(_arrival_1, _of(_rows3, _done), _arrival_2, _done)
                _store(_certain_1, _of(_rows3, _done), _certain_2, _done)
                _store(_doubt_1, _of(_rows3, _done), _doubt_2, _done)
                _store(_flat_1, _of(_rows3, _done), _flat_2, _done)
                _store(_searching_1, _of(_rows3, _done), _searching_2, _done)
                _store(_t_1, _of(_rows3, _done), _t_2, _done)
                _store(_tilt_1, _of(_rows3, _done), _tilt_2, _done)
                _rows3, _count4 = _of(_rows3, _going7), len(_going7)
                if not _count4:
                    break
                _arrival_2 = _take(_arrival_2, _going7)
                _ceiling_2 = _take(_ceiling_2, _going7)
                _certain_2 = _take(_certain_2, _going7)
                _doubt_2 = _take(_doubt_2, _going7)
                _end_2 = _take(_end_2, _going7)
                _extent_2 = _take(_extent_2, _going7)
                _flat_2 = _take(_flat_2, _going7)
                _high0_2 = _take(_high0_2, _going7)
                _high1_2 = _take(_high1_2, _going7)
                _high2_2 = _take(_high2_2, _going7)
                _last_2 = _take(_last_2, _going7)
                _latest_2 = _take(_latest_2, _going7)
                _low0_2 = _take(_low0_2, _going7)
                _low1_2 = _take(_low1_2, _going7)
                _low2_2 = _take(_low2_2, _going7)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going7)
                _p_gravity_2 = _take(_p_gravity_2, _going7)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going7)
                _p_wire_radius_2 = _take(_p_wire_radius_2, _going7)
                _position_error_2 = _take(_position_error_2, _going7)
                _rate_slack_2 = _take(_rate_slack_2, _going7)
                _rho_start_2 = _take(_rho_start_2, _going7)
                _searching_2 = _take(_searching_2, _going7)
                _share_2 = _take(_share_2, _going7)
                _speed_2 = _take(_speed_2, _going7)
                _steady_2 = _take(_steady_2, _going7)
                _swing_2 = _take(_swing_2, _going7)
                _t_2 = _take(_t_2, _going7)
                _tilt_2 = _take(_tilt_2, _going7)
                _velocity_error_2 = _take(_velocity_error_2, _going7)
                _vx_2 = _take(_vx_2, _going7)
                _vy_2 = _take(_vy_2, _going7)
                _vz_2 = _take(_vz_2, _going7)
                _x_2 = _take(_x_2, _going7)
                _y_2 = _take(_y_2, _going7)
                _z_2 = _take(_z_2, _going7)
            else:
                _store(_arrival_1, _rows3, _arrival_2, None)
                _store(_certain_1, _rows3, _certain_2, None)
                _store(_doubt_1, _rows3, _doubt_2, None)
                _store(_flat_1, _rows3, _flat_2, None)
                _store(_searching_1, _rows3, _searching_2, None)
                _store(_t_1, _rows3, _t_2, None)
                _store(_tilt_1, _rows3, _tilt_2, None)
        _doubt_1, = questioned(_doubt_1, _t_1, _searching_1)
        _arrives_1, = found(_arrival_1)
        _leaving_1, *_ = nearby(_flat_1, 0.0, _last_1, _arrival_1, _tilt_1)
        _refined_1, *_ = ring_refine(_arrival_1, _leaving_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _rho_start_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1)
        _arrival_1, = polished(_arrival_1, _certain_1, _refined_1)
        _refined_1, _rate_1 = ring_refine(_arrival_1, _leaving_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _rho_start_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1)
        _arrival_1, = polished(_arrival_1, _certain_1, _refined_1)
        _flat_1, _tilt_1, _rate_margin_1 = ring_margins(_latest_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_gravity_1)
        _margin_1, = own_margin(_arrival_1, _flat_1, _leaving_1, _tilt_1)
        _clearance_1, _delay_1 = crossing(_margin_1, _rate_margin_1, _rate_1, _ceiling_1)
        _time_1, = landed(_arrival_1)
        _delay_1, _doubt_1 = landed_surely(_arrives_1, _certain_1, _clearance_1, _delay_1, _doubt_1, _time_1)
        _doubt_1, _late_1 = tied(_arrives_1, _delay_1, _doubt_1, _late_1, _time_1, _when_1)
        _when_1, _which_1 = sooner(_arrives_1, 0.0, _time_1, _when_1, _which_1)
        _doubt_0 = _put(_doubt_0, _rows1, _doubt_1, shots)
        _late_0 = _put(_late_0, _rows1, _late_1, shots)
        _when_0 = _put(_when_0, _rows1, _when_1, shots)
        _which_0 = _put(_which_0, _rows1, _which_1, shots)
    _until_0, _pad_0 = horizon(_when_0, _speed_0, _p_gravity_0)
    _clear_0, = backboard_clear(_until_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _extent_0, _speed_0, _position_error_0, _velocity_error_0, _p_ball_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_board_thickness_0, _p_gravity_0)
    _open_0, = opens(_clear_0)
    _rows8, _count9 = _rows(_open_0, shots)
    if _count9:
        _doubt_1 = _take(_doubt_0, _rows8)
        _extent_1 = _take(_extent_0, _rows8)
        _last_1 = _take(_last_0, _rows8)
        _late_1 = _take(_late_0, _rows8)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows8)
        _p_board_bottom_1 = _take(_p_board_bottom_0, _rows8)
        _p_board_distance_1 = _take(_p_board_distance_0, _rows8)
        _p_board_half_width_1 = _take(_p_board_half_width_0, _rows8)
        _p_board_thickness_1 = _take(_p_board_thickness_0, _rows8)
        _p_board_top_1 = _take(_p_board_top_0, _rows8)
        _p_gravity_1 = _take(_p_gravity_0, _rows8)
        _pad_1 = _take(_pad_0, _rows8)
        _position_error_1 = _take(_position_error_0, _rows8)
        _speed_1 = _take(_speed_0, _rows8)
        _until_1 = _take(_until_0, _rows8)
        _velocity_error_1 = _take(_velocity_error_0, _rows8)
        _vx_1 = _take(_vx_0, _rows8)
        _vy_1 = _take(_vy_0, _rows8)
        _vz_1 = _take(_vz_0, _rows8)
        _when_1 = _take(_when_0, _rows8)
        _which_1 = _take(_which_0, _rows8)
        _x_1 = _take(_x_0, _rows8)
        _y_1 = _take(_y_0, _rows8)
        _z_1 = _take(_z_0, _rows8)
        _low0_1, _high0_1, _low1_1, _high1_1, _ceiling_1, _latest_1, _lost_1 = backboard_prepare(_until_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _p_gravity_1)
        _share_1, _arrival_1, _certain_1 = beginning()
        _position_level_1, _velocity_level_1, _excess_1 = allowance(_share_1, _latest_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_gravity_1)
        _flat_1, _tilt_1, _rate_slack_1 = backboard_margins(_latest_1, _extent_1, _speed_1, _position_level_1, _velocity_level_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _p_gravity_1)
        _doubt_1, = beyond(_doubt_1, _excess_1, _late_1, _lost_1, _pad_1)
        _t_1, _end_1, _searching_1 = backboard_enter(0.0, 0.0, _high0_1, _high1_1, _low0_1, _low1_1, 0.0)
        _rows10, _count11 = _rows(_searching_1, _count9)
        if _count11:
            _arrival_2 = _take(_arrival_1, _rows10)
            _ceiling_2 = _take(_ceiling_1, _rows10)
            _certain_2 = _take(_certain_1, _rows10)
            _doubt_2 = _take(_doubt_1, _rows10)
            _end_2 = _take(_end_1, _rows10)
            _extent_2 = _take(_extent_1, _rows10)
            _flat_2 = _take(_flat_1, _rows10)
            _high0_2 = _take(_high0_1, _rows10)
            _high1_2 = _take(_high1_1, _rows10)
            _last_2 = _take(_last_1, _rows10)
            _latest_2 = _take(_latest_1, _rows10)
            _low0_2 = _take(_low0_1, _rows10)
            _low1_2 = _take(_low1_1, _rows10)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows10)
            _p_board_bottom_2 = _take(_p_board_bottom_1, _rows10)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows10)
            _p_board_half_width_2 = _take(_p_board_half_width_1, _rows10)
            _p_board_thickness_2 = _take(_p_board_thickness_1, _rows10)
            _p_board_top_2 = _take(_p_board_top_1, _rows10)
            _p_gravity_2 = _take(_p_gravity_1, _rows10)
            _position_error_2 = _take(_position_error_1, _rows10)
            _rate_slack_2 = _take(_rate_slack_1, _rows10)
            _searching_2 = _take(_searching_1, _rows10)
            _share_2 = _take(_share_1, _rows10)
            _speed_2 = _take(_speed_1, _rows10)
            _t_2 = _take(_t_1, _rows10)
            _tilt_2 = _take(_tilt_1, _rows10)
            _velocity_error_2 = _take(_velocity_error_1, _rows10)
            _vx_2 = _take(_vx_1, _rows10)
            _vy_2 = _take(_vy_1, _rows10)
            _vz_2 = _take(_vz_1, _rows10)
            _x_2 = _take(_x_1, _rows10)
            _y_2 = _take(_y_1, _rows10)
            _z_2 = _take(_z_1, _rows10)
            _arrival_1 = _copy(_arrival_1, _count9)
            _certain_1 = _copy(_certain_1, _count9)
            _doubt_1 = _copy(_doubt_1, _count9)
            _flat_1 = _copy(_flat_1, _count9)
            _searching_1 = _copy(_searching_1, _count9)
            _t_1 = _copy(_t_1, _count9)
            _tilt_1 = _copy(_tilt_1, _count9)
            for _ in range(201):
                _leaving_2, _margin_2 = nearby(_flat_2, 1.0, _last_2, _t_2, _tilt_2)
                _gap_2, _rate_2, _bend_2, _step_2, _next_2, _root_2, _clearance_2 = backboard_advance(_t_2, _end_2, _leaving_2, _margin_2, _rate_slack_2, _ceiling_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_board_distance_2, _p_board_half_width_2, _p_board_bottom_2, _p_board_top_2, _p_board_thickness_2, _p_gravity_2)
                _hit_2, _sure_2, _vague_2 = struck(_bend_2, _clearance_2, _gap_2, _margin_2, _rate_2, _rate_slack_2, _share_2)
                _rows12, _count13 = _rows(_vague_2, _count11)
                if _count13:
                    _doubt_3 = _take(_doubt_2, _rows12)
                    _extent_3 = _take(_extent_2, _rows12)
                    _latest_3 = _take(_latest_2, _rows12)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows12)
                    _p_board_bottom_3 = _take(_p_board_bottom_2, _rows12)
                    _p_board_distance_3 = _take(_p_board_distance_2, _rows12)
                    _p_board_half_width_3 = _take(_p_board_half_width_2, _rows12)
                    _p_board_thickness_3 = _take(_p_board_thickness_2, _rows12)
                    _p_board_top_3 = _take(_p_board_top_2, _rows12)
                    _p_gravity_3 = _take(_p_gravity_2, _rows12)
                    _position_error_3 = _take(_position_error_2, _rows12)
                    _share_3 = _take(_share_2, _rows12)
                    _speed_3 = _take(_speed_2, _rows12)
                    _t_3 = _take(_t_2, _rows12)
                    _velocity_error_3 = _take(_velocity_error_2, _rows12)
                    _share_3, = finer(_share_3)
                    _position_level_3, _velocity_level_3, _excess_3 = allowance(_share_3, _latest_3, _extent_3, _speed_3, _position_error_3, _velocity_error_3, _p_gravity_3)
                    _flat_3, _tilt_3, _rate_slack_3 = backboard_margins(_latest_3, _extent_3, _speed_3, _position_level_3, _velocity_level_3, _p_ball_radius_3, _p_board_distance_3, _p_board_half_width_3, _p_board_bottom_3, _p_board_top_3, _p_board_thickness_3, _p_gravity_3)
                    _doubt_3, = exceeded(_doubt_3, _excess_3, _t_3)
                    _doubt_2 = _put(_doubt_2, _rows12, _doubt_3, _count11)
                    _flat_2 = _put(_flat_2, _rows12, _flat_3, _count11)
                    _rate_slack_2 = _put(_rate_slack_2, _rows12, _rate_slack_3, _count11)
                    _share_2 = _put(_share_2, _rows12, _share_3, _count11)
                    _tilt_2 = _put(_tilt_2, _rows12, _tilt_3, _count11)
                _arrival_2, _certain_2, _exhausted_2, _searching_2, _t_2 = advanced(_arrival_2, _certain_2, _end_2, _hit_2, _next_2, _root_2, _step_2, _sure_2, _t_2, _vague_2)
                _t_3, _end_3, _searching_3 = backboard_enter(_end_2, _end_2, _high0_2, _high1_2, _low0_2, _low1_2, _t_2)
                _end_2 = _where(_exhausted_2, _end_3, _end_2)
                _searching_2 = _where(_exhausted_2, _searching_3, _searching_2)
                _t_2 = _where(_exhausted_2, _t_3, _t_2)
                _going14 = _flatnonzero(_searching_2)
                if len(_going14) == _count11:
                    continue
                _done = _flatnonzero(_logical_not(_searching_2))
                _store(_arrival_1, _of(_rows10, _done), _arrival_2, _done)
                _store(_certain_1, _of(_rows10, _done), _certain_2, _done)
                _store(_doubt_1, _of(_rows10, _done), _doubt_2, _done)
                _store(_flat_1, _of(_rows10, _done), _flat_2, _done)
                _store(_searching_1, _of(_rows10, _done), _searching_2, _done)
                _store(_t_1, _of(_rows10, _done), _t_2, _done)
                _store(_tilt_1, _of(_rows10, _done), _tilt_2, _done)
                _rows10, _count11 = _of(_rows10, _going14), len(_going14)
                if not _count11:
                    break
                _arrival_2 = _take(_arrival_2, _going14)
                _ceiling_2 = _take(_ceiling_2, _going14)
                _certain_2 = _take(_certain_2, _going14)
                _doubt_2 = _take(_doubt_2, _going14)
                _end_2 = _take(_end_2, _going14)
                _extent_2 = _take(_extent_2, _going14)
                _flat_2 = _take(_flat_2, _going14)
                _high0_2 = _take(_high0_2, _going14)
                _high1_2 = _take(_high1_2, _going14)
                _last_2 = _take(_last_2, _going14)
                _latest_2 = _take(_latest_2, _going14)
                _low0_2 = _take(_low0_2, _going14)
                _low1_2 = _take(_low1_2, _going14)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going14)
                _p_board_bottom_2 = _take(_p_board_bottom_2, _going14)
                _p_board_distance_2 = _take(_p_board_distance_2, _going14)
                _p_board_half_width_2 = _take(_p_board_half_width_2, _going14)
                _p_board_thickness_2 = _take(_p_board_thickness_2, _going14)
                _p_board_top_2 = _take(_p_board_top_2, _going14)
                _p_gravity_2 = _take(_p_gravity_2, _going14)
                _position_error_2 = _take(_position_error_2, _going14)
                _rate_slack_2 = _take(_rate_slack_2, _going14)
                _searching_2 = _take(_searching_2, _going14)
                _share_2 = _take(_share_2, _going14)
                _speed_2 = _take(_speed_2, _going14)
                _t_2 = _take(_t_2, _going14)
                _tilt_2 = _take(_tilt_2, _going14)
                _velocity_error_2 = _take(_velocity_error_2, _going14)
                _vx_2 = _take(_vx_2, _going14)
                _vy_2 = _take(_vy_2, _going14)
                _vz_2 = _take(_vz_2, _going14)
                _x_2 = _take(_x_2, _going14)
                _y_2 = _take(_y_2, _going14)
                _z_2 = _take(_z_2, _going14)
            else:
                _store(_arrival_1, _rows10, _arrival_2, None)
                _store(_certain_1, _rows10, _certain_2, None)
                _store(_doubt_1, _rows10, _doubt_2, None)
                _store(_flat_1, _rows10, _flat_2, None)
                _store(_searching_1, _rows10, _searching_2, None)
                _store(_t_1, _rows10, _t_2, None)
                _store(_tilt_1, _rows10, _tilt_2, None)
        _doubt_1, = questioned(_doubt_1, _t_1, _searching_1)
        _arrives_1, = found(_arrival_1)
        _leaving_1, *_ = nearby(_flat_1, 1.0, _last_1, _arrival_1, _tilt_1)
        _refined_1, *_ = backboard_refine(_arrival_1, _leaving_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _p_gravity_1)
        _arrival_1, = polished(_arrival_1, _certain_1, _refined_1)
        _refined_1, _rate_1 = backboard_refine(_arrival_1, _leaving_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _p_gravity_1)
        _arrival_1, = polished(_arrival_1, _certain_1, _refined_1)
        _flat_1, _tilt_1, _rate_margin_1 = backboard_margins(_latest_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1, _p_gravity_1)
        _margin_1, = own_margin(_arrival_1, _flat_1, _leaving_1, _tilt_1)
        _clearance_1, _delay_1 = crossing(_margin_1, _rate_margin_1, _rate_1, _ceiling_1)
        _time_1, = landed(_arrival_1)
        _delay_1, _doubt_1 = landed_surely(_arrives_1, _certain_1, _clearance_1, _delay_1, _doubt_1, _time_1)
        _doubt_1, _late_1 = tied(_arrives_1, _delay_1, _doubt_1, _late_1, _time_1, _when_1)
        _when_1, _which_1 = sooner(_arrives_1, 1.0, _time_1, _when_1, _which_1)
        _doubt_0 = _put(_doubt_0, _rows8, _doubt_1, shots)
        _late_0 = _put(_late_0, _rows8, _late_1, shots)
        _when_0 = _put(_when_0, _rows8, _when_1, shots)
        _which_0 = _put(_which_0, _rows8, _which_1, shots)
    _until_0, _pad_0 = horizon(_when_0, _speed_0, _p_gravity_0)
    _clear_0, = bridge_clear(_until_0, _x_0, _y_0, _z_0, _vx_0, _vy_0, _vz_0, _extent_0, _speed_0, _position_error_0, _velocity_error_0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_bridge_half_width_0, _p_bridge_depth_0, _p_gravity_0)
    _open_0, = opens(_clear_0)
    _rows15, _count16 = _rows(_open_0, shots)
    if _count16:
        _doubt_1 = _take(_doubt_0, _rows15)
        _extent_1 = _take(_extent_0, _rows15)
        _last_1 = _take(_last_0, _rows15)
        _late_1 = _take(_late_0, _rows15)
        _p_ball_radius_1 = _take(_p_ball_radius_0, _rows15)
        _p_board_distance_1 = _take(_p_board_distance_0, _rows15)
        _p_bridge_depth_1 = _take(_p_bridge_depth_0, _rows15)
        _p_bridge_half_width_1 = _take(_p_bridge_half_width_0, _rows15)
        _p_gravity_1 = _take(_p_gravity_0, _rows15)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows15)
        _p_wire_radius_1 = _take(_p_wire_radius_0, _rows15)
        _pad_1 = _take(_pad_0, _rows15)
        _position_error_1 = _take(_position_error_0, _rows15)
        _speed_1 = _take(_speed_0, _rows15)
        _until_1 = _take(_until_0, _rows15)
        _velocity_error_1 = _take(_velocity_error_0, _rows15)
        _vx_1 = _take(_vx_0, _rows15)
        _vy_1 = _take(_vy_0, _rows15)
        _vz_1 = _take(_vz_0, _rows15)
        _when_1 = _take(_when_0, _rows15)
        _which_1 = _take(_which_0, _rows15)
        _x_1 = _take(_x_0, _rows15)
        _y_1 = _take(_y_0, _rows15)
        _z_1 = _take(_z_0, _rows15)
        _low0_1, _high0_1, _low1_1, _high1_1, _ceiling_1, _latest_1, _lost_1 = bridge_prepare(_until_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _p_gravity_1)
        _share_1, _arrival_1, _certain_1 = beginning()
        _position_level_1, _velocity_level_1, _excess_1 = allowance(_share_1, _latest_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_gravity_1)
        _flat_1, _tilt_1, _rate_slack_1 = bridge_margins(_latest_1, _extent_1, _speed_1, _position_level_1, _velocity_level_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _p_gravity_1)
        _doubt_1, = beyond(_doubt_1, _excess_1, _late_1, _lost_1, _pad_1)
        _t_1, _end_1, _searching_1 = bridge_enter(0.0, 0.0, _high0_1, _high1_1, _low0_1, _low1_1, 0.0)
        _rows17, _count18 = _rows(_searching_1, _count16)
        if _count18:
            _arrival_2 = _take(_arrival_1, _rows17)
            _ceiling_2 = _take(_ceiling_1, _rows17)
            _certain_2 = _take(_certain_1, _rows17)
            _doubt_2 = _take(_doubt_1, _rows17)
            _end_2 = _take(_end_1, _rows17)
            _extent_2 = _take(_extent_1, _rows17)
            _flat_2 = _take(_flat_1, _rows17)
            _high0_2 = _take(_high0_1, _rows17)
            _high1_2 = _take(_high1_1, _rows17)
            _last_2 = _take(_last_1, _rows17)
            _latest_2 = _take(_latest_1, _rows17)
            _low0_2 = _take(_low0_1, _rows17)
            _low1_2 = _take(_low1_1, _rows17)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows17)
            _p_board_distance_2 = _take(_p_board_distance_1, _rows17)
            _p_bridge_depth_2 = _take(_p_bridge_depth_1, _rows17)
            _p_bridge_half_width_2 = _take(_p_bridge_half_width_1, _rows17)
            _p_gravity_2 = _take(_p_gravity_1, _rows17)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows17)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows17)
            _position_error_2 = _take(_position_error_1, _rows17)
            _rate_slack_2 = _take(_rate_slack_1, _rows17)
            _searching_2 = _take(_searching_1, _rows17)
            _share_2 = _take(_share_1, _rows17)
            _speed_2 = _take(_speed_1, _rows17)
            _t_2 = _take(_t_1, _rows17)
            _tilt_2 = _take(_tilt_1, _rows17)
            _velocity_error_2 = _take(_velocity_error_1, _rows17)
            _vx_2 = _take(_vx_1, _rows17)
            _vy_2 = _take(_vy_1, _rows17)
            _vz_2 = _take(_vz_1, _rows17)
            _x_2 = _take(_x_1, _rows17)
            _y_2 = _take(_y_1, _rows17)
            _z_2 = _take(_z_1, _rows17)
            _arrival_1 = _copy(_arrival_1, _count16)
            _certain_1 = _copy(_certain_1, _count16)
            _doubt_1 = _copy(_doubt_1, _count16)
            _flat_1 = _copy(_flat_1, _count16)
            _searching_1 = _copy(_searching_1, _count16)
            _t_1 = _copy(_t_1, _count16)
            _tilt_1 = _copy(_tilt_1, _count16)
            for _ in range(201):
                _leaving_2, _margin_2 = nearby(_flat_2, 2.0, _last_2, _t_2, _tilt_2)
                _gap_2, _rate_2, _bend_2, _step_2, _next_2, _root_2, _clearance_2 = bridge_advance(_t_2, _end_2, _leaving_2, _margin_2, _rate_slack_2, _ceiling_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2, _p_board_distance_2, _p_bridge_half_width_2, _p_bridge_depth_2, _p_gravity_2)
                _hit_2, _sure_2, _vague_2 = struck(_bend_2, _clearance_2, _gap_2, _margin_2, _rate_2, _rate_slack_2, _share_2)
                _rows19, _count20 = _rows(_vague_2, _count18)
                if _count20:
                    _doubt_3 = _take(_doubt_2, _rows19)
                    _extent_3 = _take(_extent_2, _rows19)
                    _latest_3 = _take(_latest_2, _rows19)
                    _p_ball_radius_3 = _take(_p_ball_radius_2, _rows19)
                    _p_board_distance_3 = _take(_p_board_distance_2, _rows19)
                    _p_bridge_depth_3 = _take(_p_bridge_depth_2, _rows19)
                    _p_bridge_half_width_3 = _take(_p_bridge_half_width_2, _rows19)
                    _p_gravity_3 = _take(_p_gravity_2, _rows19)
                    _p_ring_radius_3 = _take(_p_ring_radius_2, _rows19)
                    _p_wire_radius_3 = _take(_p_wire_radius_2, _rows19)
                    _position_error_3 = _take(_position_error_2, _rows19)
                    _share_3 = _take(_share_2, _rows19)
                    _speed_3 = _take(_speed_2, _rows19)
                    _t_3 = _take(_t_2, _rows19)
                    _velocity_error_3 = _take(_velocity_error_2, _rows19)
                    _share_3, = finer(_share_3)
                    _position_level_3, _velocity_level_3, _excess_3 = allowance(_share_3, _latest_3, _extent_3, _speed_3, _position_error_3, _velocity_error_3, _p_gravity_3)
                    _flat_3, _tilt_3, _rate_slack_3 = bridge_margins(_latest_3, _extent_3, _speed_3, _position_level_3, _velocity_level_3, _p_ball_radius_3, _p_ring_radius_3, _p_wire_radius_3, _p_board_distance_3, _p_bridge_half_width_3, _p_bridge_depth_3, _p_gravity_3)
                    _doubt_3, = exceeded(_doubt_3, _excess_3, _t_3)
                    _doubt_2 = _put(_doubt_2, _rows19, _doubt_3, _count18)
                    _flat_2 = _put(_flat_2, _rows19, _flat_3, _count18)
                    _rate_slack_2 = _put(_rate_slack_2, _rows19, _rate_slack_3, _count18)
                    _share_2 = _put(_share_2, _rows19, _share_3, _count18)
                    _tilt_2 = _put(_tilt_2, _rows19, _tilt_3, _count18)
                _arrival_2, _certain_2, _exhausted_2, _searching_2, _t_2 = advanced(_arrival_2, _certain_2, _end_2, _hit_2, _next_2, _root_2, _step_2, _sure_2, _t_2, _vague_2)
                _t_3, _end_3, _searching_3 = bridge_enter(_end_2, _end_2, _high0_2, _high1_2, _low0_2, _low1_2, _t_2)
                _end_2 = _where(_exhausted_2, _end_3, _end_2)
                _searching_2 = _where(_exhausted_2, _searching_3, _searching_2)
                _t_2 = _where(_exhausted_2, _t_3, _t_2)
                _going21 = _flatnonzero(_searching_2)
                if len(_going21) == _count18:
                    continue
                _done = _flatnonzero(_logical_not(_searching_2))
                _store(_arrival_1, _of(_rows17, _done), _arrival_2, _done)
                _store(_certain_1, _of(_rows17, _done), _certain_2, _done)
                _store(_doubt_1, _of(_rows17, _done), _doubt_2, _done)
                _store(_flat_1, _of(_rows17, _done), _flat_2, _done)
                _store(_searching_1, _of(_rows17, _done), _searching_2, _done)
                _store(_t_1, _of(_rows17, _done), _t_2, _done)
                _store(_tilt_1, _of(_rows17, _done), _tilt_2, _done)
                _rows17, _count18 = _of(_rows17, _going21), len(_going21)
                if not _count18:
                    break
                _arrival_2 = _take(_arrival_2, _going21)
                _ceiling_2 = _take(_ceiling_2, _going21)
                _certain_2 = _take(_certain_2, _going21)
                _doubt_2 = _take(_doubt_2, _going21)
                _end_2 = _take(_end_2, _going21)
                _extent_2 = _take(_extent_2, _going21)
                _flat_2 = _take(_flat_2, _going21)
                _high0_2 = _take(_high0_2, _going21)
                _high1_2 = _take(_high1_2, _going21)
                _last_2 = _take(_last_2, _going21)
                _latest_2 = _take(_latest_2, _going21)
                _low0_2 = _take(_low0_2, _going21)
                _low1_2 = _take(_low1_2, _going21)
                _p_ball_radius_2 = _take(_p_ball_radius_2, _going21)
                _p_board_distance_2 = _take(_p_board_distance_2, _going21)
                _p_bridge_depth_2 = _take(_p_bridge_depth_2, _going21)
                _p_bridge_half_width_2 = _take(_p_bridge_half_width_2, _going21)
                _p_gravity_2 = _take(_p_gravity_2, _going21)
                _p_ring_radius_2 = _take(_p_ring_radius_2, _going21)
                _p_wire_radius_2 = _take(_p_wire_radius_2, _going21)
                _position_error_2 = _take(_position_error_2, _going21)
                _rate_slack_2 = _take(_rate_slack_2, _going21)
                _searching_2 = _take(_searching_2, _going21)
                _share_2 = _take(_share_2, _going21)
                _speed_2 = _take(_speed_2, _going21)
                _t_2 = _take(_t_2, _going21)
                _tilt_2 = _take(_tilt_2, _going21)
                _velocity_error_2 = _take(_velocity_error_2, _going21)
                _vx_2 = _take(_vx_2, _going21)
                _vy_2 = _take(_vy_2, _going21)
                _vz_2 = _take(_vz_2, _going21)
                _x_2 = _take(_x_2, _going21)
                _y_2 = _take(_y_2, _going21)
                _z_2 = _take(_z_2, _going21)
            else:
                _store(_arrival_1, _rows17, _arrival_2, None)
                _store(_certain_1, _rows17, _certain_2, None)
                _store(_doubt_1, _rows17, _doubt_2, None)
                _store(_flat_1, _rows17, _flat_2, None)
                _store(_searching_1, _rows17, _searching_2, None)
                _store(_t_1, _rows17, _t_2, None)
                _store(_tilt_1, _rows17, _tilt_2, None)
        _doubt_1, = questioned(_doubt_1, _t_1, _searching_1)
        _arrives_1, = found(_arrival_1)
        _leaving_1, *_ = nearby(_flat_1, 2.0, _last_1, _arrival_1, _tilt_1)
        _refined_1, *_ = bridge_refine(_arrival_1, _leaving_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _p_gravity_1)
        _arrival_1, = polished(_arrival_1, _certain_1, _refined_1)
        _refined_1, _rate_1 = bridge_refine(_arrival_1, _leaving_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _p_gravity_1)
        _arrival_1, = polished(_arrival_1, _certain_1, _refined_1)
        _flat_1, _tilt_1, _rate_margin_1 = bridge_margins(_latest_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1, _p_gravity_1)
        _margin_1, = own_margin(_arrival_1, _flat_1, _leaving_1, _tilt_1)
        _clearance_1, _delay_1 = crossing(_margin_1, _rate_margin_1, _rate_1, _ceiling_1)
        _time_1, = landed(_arrival_1)
        _delay_1, _doubt_1 = landed_surely(_arrives_1, _certain_1, _clearance_1, _delay_1, _doubt_1, _time_1)
        _doubt_1, _late_1 = tied(_arrives_1, _delay_1, _doubt_1, _late_1, _time_1, _when_1)
        _when_1, _which_1 = sooner(_arrives_1, 2.0, _time_1, _when_1, _which_1)
        _doubt_0 = _put(_doubt_0, _rows15, _doubt_1, shots)
        _late_0 = _put(_late_0, _rows15, _late_1, shots)
        _when_0 = _put(_when_0, _rows15, _when_1, shots)
        _which_0 = _put(_which_0, _rows15, _which_1, shots)
    _rows22, _count23 = _rows(_limited_0, shots)
    if _count23:
        _clock_1 = _take(_clock_0, _rows22)
        _doubt_1 = _take(_doubt_0, _rows22)
        _late_1 = _take(_late_0, _rows22)
        _time_error_1 = _take(_time_error_0, _rows22)
        _time_limit_1 = _take(_time_limit_0, _rows22)
        _when_1 = _take(_when_0, _rows22)
        _which_1 = _take(_which_0, _rows22)
        _time_1, _delay_1, _arrives_1, _doubt_1 = expiry(_clock_1, _doubt_1, _late_1, _time_error_1, _time_limit_1, _when_1, _which_1)
        _doubt_1, _late_1 = tied(_arrives_1, _delay_1, _doubt_1, _late_1, _time_1, _when_1)
        _when_1, _which_1 = sooner(_arrives_1, 4.0, _time_1, _when_1, _which_1)
        _doubt_0 = _put(_doubt_0, _rows22, _doubt_1, shots)
        _late_0 = _put(_late_0, _rows22, _late_1, shots)
        _when_0 = _put(_when_0, _rows22, _when_1, shots)
        _which_0 = _put(_which_0, _rows22, _which_1, shots)
    _, _moves_0, _ends_0, _touches_0, _reached_0, _edge_0 = departed(3.0, _which_0)
    _body_0, = body_of(_which_0)
    _rows24, _count25 = _rows(_moves_0, shots)
    if _count25:
        _clock_1 = _take(_clock_0, _rows24)
        _extent_1 = _take(_extent_0, _rows24)
        _p_gravity_1 = _take(_p_gravity_0, _rows24)
        _p_ring_radius_1 = _take(_p_ring_radius_0, _rows24)
        _position_error_1 = _take(_position_error_0, _rows24)
        _speed_1 = _take(_speed_0, _rows24)
        _through_1 = _take(_through_0, _rows24)
        _uncertain_1 = _take(_uncertain_0, _rows24)
        _velocity_error_1 = _take(_velocity_error_0, _rows24)
        _vx_1 = _take(_vx_0, _rows24)
        _vy_1 = _take(_vy_0, _rows24)
        _vz_1 = _take(_vz_0, _rows24)
        _when_1 = _take(_when_0, _rows24)
        _x_1 = _take(_x_0, _rows24)
        _y_1 = _take(_y_0, _rows24)
        _z_1 = _take(_z_0, _rows24)
        _unsure_1, = passing_doubt(_when_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _extent_1, _speed_1, _position_error_1, _velocity_error_1, _p_ring_radius_1, _p_gravity_1)
        _uncertain_1, = undecided(_uncertain_1, _unsure_1)
        _through_1, = passing(_through_1, _when_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_ring_radius_1, _p_gravity_1)
        _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1 = flight(_when_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _p_gravity_1)
        _clock_1, = ticked(_clock_1, _when_1)
        _clock_0 = _put(_clock_0, _rows24, _clock_1, shots)
        _through_0 = _put(_through_0, _rows24, _through_1, shots)
        _uncertain_0 = _put(_uncertain_0, _rows24, _uncertain_1, shots)
        _vx_0 = _put(_vx_0, _rows24, _vx_1, shots)
        _vy_0 = _put(_vy_0, _rows24, _vy_1, shots)
        _vz_0 = _put(_vz_0, _rows24, _vz_1, shots)
        _x_0 = _put(_x_0, _rows24, _x_1, shots)
        _y_0 = _put(_y_0, _rows24, _y_1, shots)
        _z_0 = _put(_z_0, _rows24, _z_1, shots)
    _rows26, _count27 = _rows(_limited_0, shots)
    if _count27:
        _body_1 = _take(_body_0, _rows26)
        _clock_1 = _take(_clock_0, _rows26)
        _ends_1 = _take(_ends_0, _rows26)
        _reached_1 = _take(_reached_0, _rows26)
        _time_limit_1 = _take(_time_limit_0, _rows26)
        _which_1 = _take(_which_0, _rows26)
        _clock_1, _body_1, _reached_1, _ends_1 = expired(_body_1, _clock_1, _ends_1, 4.0, _reached_1, _time_limit_1, _which_1)
        _body_0 = _put(_body_0, _rows26, _body_1, shots)
        _clock_0 = _put(_clock_0, _rows26, _clock_1, shots)
        _ends_0 = _put(_ends_0, _rows26, _ends_1, shots)
        _reached_0 = _put(_reached_0, _rows26, _reached_1, shots)
    _slack_0, = displacement(_late_0, _when_0, _extent_0, _speed_0, _position_error_0, _velocity_error_0, _p_ball_radius_0, _p_ring_radius_0, _p_wire_radius_0, _p_board_distance_0, _p_board_half_width_0, _p_board_bottom_0, _p_board_top_0, _p_board_thickness_0, _p_bridge_half_width_0, _p_bridge_depth_0, _p_gravity_0, _p_end_depth_0)
    _here_0, = here(3.0, _which_0)
    _g0_1, = end_bounds(_x_0, _y_0, _p_ring_radius_0)
    _reached_1, = end_reached(_g0_1, _through_0)
    _edge_1, = end_edge(_g0_1, _slack_0, _through_0)
    _edge_0 = _where(_here_0, _edge_1, _edge_0)
    _reached_0 = _where(_here_0, _reached_1, _reached_0)
    _uncertain_0, = doubted(_doubt_0, _edge_0, _late_0, _uncertain_0, _when_0)
    _contacts_0, _outcome_0 = accounted(_contacts_0, _most_contacts_0, _reached_0, _touches_0)
    columns["body"] = _body_0
    columns["clock"] = _clock_0
    columns["contacts"] = _contacts_0
    columns["ends"] = _ends_0
    columns["late"] = _late_0
    columns["limited"] = _limited_0
    columns["outcome"] = _outcome_0
    columns["through"] = _through_0
    columns["touches"] = _touches_0
    columns["uncertain"] = _uncertain_0
    columns["vx"] = _vx_0
    columns["vy"] = _vy_0
    columns["vz"] = _vz_0
    columns["when"] = _when_0
    columns["which"] = _which_0
    columns["x"] = _x_0
    columns["y"] = _y_0
    columns["z"] = _z_0


def meet_bounded(columns: dict[str, Any], shots: int) -> None:
    """Stage meet of the event loop, with bounds on errors."""
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
    _last_0 = columns["last"]
    _late_0 = columns["late"]
    _limited_0 = columns["limited"]
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
    _p_gravity_0 = columns["p_gravity"]
    _p_restitution_speed_0 = columns["p_restitution_speed"]
    _p_ring_friction_0 = columns["p_ring_friction"]
    _p_ring_radius_0 = columns["p_ring_radius"]
    _p_ring_restitution_0 = columns["p_ring_restitution"]
    _p_tangential_restitution_0 = columns["p_tangential_restitution"]
    _p_wire_radius_0 = columns["p_wire_radius"]
    _position_claim_0 = columns["position_claim"]
    _spin_claim_0 = columns["spin_claim"]
    _time_claim_0 = columns["time_claim"]
    _touches_0 = columns["touches"]
    _uncertain_0 = columns["uncertain"]
    _velocity_claim_0 = columns["velocity_claim"]
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
    _meeting_0, = meeting(_claims_0, _ends_0, _touches_0)
    _rows1, _count2 = _rows(_meeting_0, shots)
    if _count2:
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
        _nx_1, _ny_1, _nz_1 = end_normal()
        _here_1, = here(0.0, _which_1)
        _nx_2, _ny_2, _nz_2 = ring_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1)
        _count_0_2, = counted(_count_0_1)
        _count_0_1 = _where(_here_1, _count_0_2, _count_0_1)
        _nx_1 = _where(_here_1, _nx_2, _nx_1)
        _ny_1 = _where(_here_1, _ny_2, _ny_1)
        _nz_1 = _where(_here_1, _nz_2, _nz_1)
        _here_1, = here(1.0, _which_1)
        _nx_2, _ny_2, _nz_2 = backboard_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1)
        _count_1_2, = counted(_count_1_1)
        _count_1_1 = _where(_here_1, _count_1_2, _count_1_1)
        _nx_1 = _where(_here_1, _nx_2, _nx_1)
        _ny_1 = _where(_here_1, _ny_2, _ny_1)
        _nz_1 = _where(_here_1, _nz_2, _nz_1)
        _here_1, = here(2.0, _which_1)
        _nx_2, _ny_2, _nz_2 = bridge_normal(_x_1, _y_1, _z_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1)
        _count_2_2, = counted(_count_2_1)
        _count_2_1 = _where(_here_1, _count_2_2, _count_2_1)
        _nx_1 = _where(_here_1, _nx_2, _nx_1)
        _ny_1 = _where(_here_1, _ny_2, _ny_1)
        _nz_1 = _where(_here_1, _nz_2, _nz_1)
        _curving_1, = elsewhere()
        _again_1, = again(0.0, _last_1, _which_1)
        _curving_2, = ring_curvature(_p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1)
        _curving_1 = _where(_again_1, _curving_2, _curving_1)
        _again_1, = again(1.0, _last_1, _which_1)
        _curving_2, = backboard_curvature(_p_ball_radius_1)
        _curving_1 = _where(_again_1, _curving_2, _curving_1)
        _again_1, = again(2.0, _last_1, _which_1)
        _curving_2, = bridge_curvature(_p_ball_radius_1)
        _curving_1 = _where(_again_1, _curving_2, _curving_1)
        _dx_1, _dy_1, _dz_1, _dvx_1, _dvy_1, _dvz_1, _delay_1, _shift_1 = carry_flight(_when_1, _x_1, _y_1, _z_1, _vx_1, _vy_1, _vz_1, _nx_1, _ny_1, _nz_1, _clock_1, _contacts_1, _late_1, _dx_1, _dy_1, _dz_1, _dvx_1, _dvy_1, _dvz_1, _curving_1, _p_gravity_1)
        _clock_error_1, = delayed(_clock_error_1, _delay_1)
        _dx_2, _dy_2, _dz_2 = floored(_dx_1, _dy_1, _dz_1, _shift_1)
        _dx_1 = _where(_ends_1, _dx_2, _dx_1)
        _dy_1 = _where(_ends_1, _dy_2, _dy_1)
        _dz_1 = _where(_ends_1, _dz_2, _dz_1)
        _dnx_1, _dny_1, _dnz_1, _turn_1 = unturned()
        _here_1, = here(0.0, _which_1)
        _rows3, _count4 = _rows(_here_1, _count2)
        if _count4:
            _dx_2 = _take(_dx_1, _rows3)
            _dy_2 = _take(_dy_1, _rows3)
            _dz_2 = _take(_dz_1, _rows3)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows3)
            _p_ring_radius_2 = _take(_p_ring_radius_1, _rows3)
            _p_wire_radius_2 = _take(_p_wire_radius_1, _rows3)
            _shift_2 = _take(_shift_1, _rows3)
            _x_2 = _take(_x_1, _rows3)
            _y_2 = _take(_y_1, _rows3)
            _dnx_2, _dny_2, _dnz_2, _turn_2 = ring_carry_normal(_x_2, _y_2, _dx_2, _dy_2, _dz_2, _shift_2, _p_ball_radius_2, _p_ring_radius_2, _p_wire_radius_2)
            _dnx_1 = _put(_dnx_1, _rows3, _dnx_2, _count2)
            _dny_1 = _put(_dny_1, _rows3, _dny_2, _count2)
            _dnz_1 = _put(_dnz_1, _rows3, _dnz_2, _count2)
            _turn_1 = _put(_turn_1, _rows3, _turn_2, _count2)
        _here_1, = here(1.0, _which_1)
        _dnx_2, _dny_2, _dnz_2, _turn_2 = backboard_carry_normal(_x_1, _y_1, _z_1, _dx_1, _dy_1, _dz_1, _shift_1, _p_ball_radius_1, _p_board_distance_1, _p_board_half_width_1, _p_board_bottom_1, _p_board_top_1, _p_board_thickness_1)
        _dnx_1 = _where(_here_1, _dnx_2, _dnx_1)
        _dny_1 = _where(_here_1, _dny_2, _dny_1)
        _dnz_1 = _where(_here_1, _dnz_2, _dnz_1)
        _turn_1 = _where(_here_1, _turn_2, _turn_1)
        _here_1, = here(2.0, _which_1)
        _dnx_2, _dny_2, _dnz_2, _turn_2 = bridge_carry_normal(_x_1, _y_1, _z_1, _dx_1, _dy_1, _dz_1, _shift_1, _p_ball_radius_1, _p_ring_radius_1, _p_wire_radius_1, _p_board_distance_1, _p_bridge_half_width_1, _p_bridge_depth_1)
        _dnx_1 = _where(_here_1, _dnx_2, _dnx_1)
        _dny_1 = _where(_here_1, _dny_2, _dny_1)
        _dnz_1 = _where(_here_1, _dnz_2, _dnz_1)
        _turn_1 = _where(_here_1, _turn_2, _turn_1)
        _here_1, = here(0.0, _which_1)
        _rows5, _count6 = _rows(_here_1, _count2)
        if _count6:
            _contacts_2 = _take(_contacts_1, _rows5)
            _dnx_2 = _take(_dnx_1, _rows5)
            _dny_2 = _take(_dny_1, _rows5)
            _dnz_2 = _take(_dnz_1, _rows5)
            _dvx_2 = _take(_dvx_1, _rows5)
            _dvy_2 = _take(_dvy_1, _rows5)
            _dvz_2 = _take(_dvz_1, _rows5)
            _dwx_2 = _take(_dwx_1, _rows5)
            _dwy_2 = _take(_dwy_1, _rows5)
            _dwz_2 = _take(_dwz_1, _rows5)
            _nx_2 = _take(_nx_1, _rows5)
            _ny_2 = _take(_ny_1, _rows5)
            _nz_2 = _take(_nz_1, _rows5)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows5)
            _p_restitution_speed_2 = _take(_p_restitution_speed_1, _rows5)
            _p_ring_friction_2 = _take(_p_ring_friction_1, _rows5)
            _p_ring_restitution_2 = _take(_p_ring_restitution_1, _rows5)
            _p_tangential_restitution_2 = _take(_p_tangential_restitution_1, _rows5)
            _turn_2 = _take(_turn_1, _rows5)
            _uncertain_2 = _take(_uncertain_1, _rows5)
            _vx_2 = _take(_vx_1, _rows5)
            _vy_2 = _take(_vy_1, _rows5)
            _vz_2 = _take(_vz_1, _rows5)
            _wx_2 = _take(_wx_1, _rows5)
            _wy_2 = _take(_wy_1, _rows5)
            _wz_2 = _take(_wz_1, _rows5)
            _unsure_2, = ring_impact_doubt(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _turn_2, _p_ball_radius_2, _p_ring_restitution_2, _p_ring_friction_2, _p_tangential_restitution_2, _p_restitution_speed_2)
            _uncertain_2, = undecided(_uncertain_2, _unsure_2)
            _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2 = carry_ring_impact(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _contacts_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _dnx_2, _dny_2, _dnz_2, _turn_2, _p_ball_radius_2, _p_ring_restitution_2, _p_ring_friction_2, _p_tangential_restitution_2, _p_restitution_speed_2)
            _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = ring_impact(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _p_ball_radius_2, _p_ring_restitution_2, _p_ring_friction_2, _p_tangential_restitution_2, _p_restitution_speed_2)
            _dvx_1 = _put(_dvx_1, _rows5, _dvx_2, _count2)
            _dvy_1 = _put(_dvy_1, _rows5, _dvy_2, _count2)
            _dvz_1 = _put(_dvz_1, _rows5, _dvz_2, _count2)
            _dwx_1 = _put(_dwx_1, _rows5, _dwx_2, _count2)
            _dwy_1 = _put(_dwy_1, _rows5, _dwy_2, _count2)
            _dwz_1 = _put(_dwz_1, _rows5, _dwz_2, _count2)
            _uncertain_1 = _put(_uncertain_1, _rows5, _uncertain_2, _count2)
            _vx_1 = _put(_vx_1, _rows5, _vx_2, _count2)
            _vy_1 = _put(_vy_1, _rows5, _vy_2, _count2)
            _vz_1 = _put(_vz_1, _rows5, _vz_2, _count2)
            _wx_1 = _put(_wx_1, _rows5, _wx_2, _count2)
            _wy_1 = _put(_wy_1, _rows5, _wy_2, _count2)
            _wz_1 = _put(_wz_1, _rows5, _wz_2, _count2)
        _here_1, = here(1.0, _which_1)
        _rows7, _count8 = _rows(_here_1, _count2)
        if _count8:
            _contacts_2 = _take(_contacts_1, _rows7)
            _dnx_2 = _take(_dnx_1, _rows7)
            _dny_2 = _take(_dny_1, _rows7)
            _dnz_2 = _take(_dnz_1, _rows7)
            _dvx_2 = _take(_dvx_1, _rows7)
            _dvy_2 = _take(_dvy_1, _rows7)
            _dvz_2 = _take(_dvz_1, _rows7)
            _dwx_2 = _take(_dwx_1, _rows7)
            _dwy_2 = _take(_dwy_1, _rows7)
            _dwz_2 = _take(_dwz_1, _rows7)
            _nx_2 = _take(_nx_1, _rows7)
            _ny_2 = _take(_ny_1, _rows7)
            _nz_2 = _take(_nz_1, _rows7)
            _p_backboard_friction_2 = _take(_p_backboard_friction_1, _rows7)
            _p_backboard_restitution_2 = _take(_p_backboard_restitution_1, _rows7)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows7)
            _p_restitution_speed_2 = _take(_p_restitution_speed_1, _rows7)
            _p_tangential_restitution_2 = _take(_p_tangential_restitution_1, _rows7)
            _turn_2 = _take(_turn_1, _rows7)
            _uncertain_2 = _take(_uncertain_1, _rows7)
            _vx_2 = _take(_vx_1, _rows7)
            _vy_2 = _take(_vy_1, _rows7)
            _vz_2 = _take(_vz_1, _rows7)
            _wx_2 = _take(_wx_1, _rows7)
            _wy_2 = _take(_wy_1, _rows7)
            _wz_2 = _take(_wz_1, _rows7)
            _unsure_2, = backboard_impact_doubt(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _turn_2, _p_ball_radius_2, _p_backboard_restitution_2, _p_backboard_friction_2, _p_tangential_restitution_2, _p_restitution_speed_2)
            _uncertain_2, = undecided(_uncertain_2, _unsure_2)
            _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2 = carry_backboard_impact(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _contacts_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _dnx_2, _dny_2, _dnz_2, _turn_2, _p_ball_radius_2, _p_backboard_restitution_2, _p_backboard_friction_2, _p_tangential_restitution_2, _p_restitution_speed_2)
            _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = backboard_impact(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _p_ball_radius_2, _p_backboard_restitution_2, _p_backboard_friction_2, _p_tangential_restitution_2, _p_restitution_speed_2)
            _dvx_1 = _put(_dvx_1, _rows7, _dvx_2, _count2)
            _dvy_1 = _put(_dvy_1, _rows7, _dvy_2, _count2)
            _dvz_1 = _put(_dvz_1, _rows7, _dvz_2, _count2)
            _dwx_1 = _put(_dwx_1, _rows7, _dwx_2, _count2)
            _dwy_1 = _put(_dwy_1, _rows7, _dwy_2, _count2)
            _dwz_1 = _put(_dwz_1, _rows7, _dwz_2, _count2)
            _uncertain_1 = _put(_uncertain_1, _rows7, _uncertain_2, _count2)
            _vx_1 = _put(_vx_1, _rows7, _vx_2, _count2)
            _vy_1 = _put(_vy_1, _rows7, _vy_2, _count2)
            _vz_1 = _put(_vz_1, _rows7, _vz_2, _count2)
            _wx_1 = _put(_wx_1, _rows7, _wx_2, _count2)
            _wy_1 = _put(_wy_1, _rows7, _wy_2, _count2)
            _wz_1 = _put(_wz_1, _rows7, _wz_2, _count2)
        _here_1, = here(2.0, _which_1)
        _rows9, _count10 = _rows(_here_1, _count2)
        if _count10:
            _contacts_2 = _take(_contacts_1, _rows9)
            _dnx_2 = _take(_dnx_1, _rows9)
            _dny_2 = _take(_dny_1, _rows9)
            _dnz_2 = _take(_dnz_1, _rows9)
            _dvx_2 = _take(_dvx_1, _rows9)
            _dvy_2 = _take(_dvy_1, _rows9)
            _dvz_2 = _take(_dvz_1, _rows9)
            _dwx_2 = _take(_dwx_1, _rows9)
            _dwy_2 = _take(_dwy_1, _rows9)
            _dwz_2 = _take(_dwz_1, _rows9)
            _nx_2 = _take(_nx_1, _rows9)
            _ny_2 = _take(_ny_1, _rows9)
            _nz_2 = _take(_nz_1, _rows9)
            _p_ball_radius_2 = _take(_p_ball_radius_1, _rows9)
            _p_bridge_friction_2 = _take(_p_bridge_friction_1, _rows9)
            _p_bridge_restitution_2 = _take(_p_bridge_restitution_1, _rows9)
            _p_restitution_speed_2 = _take(_p_restitution_speed_1, _rows9)
            _p_tangential_restitution_2 = _take(_p_tangential_restitution_1, _rows9)
            _turn_2 = _take(_turn_1, _rows9)
            _uncertain_2 = _take(_uncertain_1, _rows9)
            _vx_2 = _take(_vx_1, _rows9)
            _vy_2 = _take(_vy_1, _rows9)
            _vz_2 = _take(_vz_1, _rows9)
            _wx_2 = _take(_wx_1, _rows9)
            _wy_2 = _take(_wy_1, _rows9)
            _wz_2 = _take(_wz_1, _rows9)
            _unsure_2, = bridge_impact_doubt(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _turn_2, _p_ball_radius_2, _p_bridge_restitution_2, _p_bridge_friction_2, _p_tangential_restitution_2, _p_restitution_speed_2)
            _uncertain_2, = undecided(_uncertain_2, _unsure_2)
            _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2 = carry_bridge_impact(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _contacts_2, _dvx_2, _dvy_2, _dvz_2, _dwx_2, _dwy_2, _dwz_2, _dnx_2, _dny_2, _dnz_2, _turn_2, _p_ball_radius_2, _p_bridge_restitution_2, _p_bridge_friction_2, _p_tangential_restitution_2, _p_restitution_speed_2)
            _vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2 = bridge_impact(_vx_2, _vy_2, _vz_2, _wx_2, _wy_2, _wz_2, _nx_2, _ny_2, _nz_2, _p_ball_radius_2, _p_bridge_restitution_2, _p_bridge_friction_2, _p_tangential_restitution_2, _p_restitution_speed_2)
            _dvx_1 = _put(_dvx_1, _rows9, _dvx_2, _count2)
            _dvy_1 = _put(_dvy_1, _rows9, _dvy_2, _count2)
            _dvz_1 = _put(_dvz_1, _rows9, _dvz_2, _count2)
            _dwx_1 = _put(_dwx_1, _rows9, _dwx_2, _count2)
            _dwy_1 = _put(_dwy_1, _rows9, _dwy_2, _count2)
            _dwz_1 = _put(_dwz_1, _rows9, _dwz_2, _count2)
            _uncertain_1 = _put(_uncertain_1, _rows9, _uncertain_2, _count2)
            _vx_1 = _put(_vx_1, _rows9, _vx_2, _count2)
            _vy_1 = _put(_vy_1, _rows9, _vy_2, _count2)
            _vz_1 = _put(_vz_1, _rows9, _vz_2, _count2)
            _wx_1 = _put(_wx_1, _rows9, _wx_2, _count2)
            _wy_1 = _put(_wy_1, _rows9, _wy_2, _count2)
            _wz_1 = _put(_wz_1, _rows9, _wz_2, _count2)
        _first_2, _last_2 = touched(_body_1, _first_1, _which_1)
        _first_1 = _where(_touches_1, _first_2, _first_1)
        _last_1 = _where(_touches_1, _last_2, _last_1)
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
        _uncertain_0 = _put(_uncertain_0, _rows1, _uncertain_1, shots)
        _vx_0 = _put(_vx_0, _rows1, _vx_1, shots)
        _vy_0 = _put(_vy_0, _rows1, _vy_1, shots)
        _vz_0 = _put(_vz_0, _rows1, _vz_1, shots)
        _wx_0 = _put(_wx_0, _rows1, _wx_1, shots)
        _wy_0 = _put(_wy_0, _rows1, _wy_1, shots)
        _wz_0 = _put(_wz_0, _rows1, _wz_1, shots)
    _rows11, _count12 = _rows(_limited_0, shots)
    if _count12:
        _claims_1 = _take(_claims_0, _rows11)
        _clock_1 = _take(_clock_0, _rows11)
        _clock_error_1 = _take(_clock_error_0, _rows11)
        _dvx_1 = _take(_dvx_0, _rows11)
        _dvy_1 = _take(_dvy_0, _rows11)
        _dvz_1 = _take(_dvz_0, _rows11)
        _dx_1 = _take(_dx_0, _rows11)
        _dy_1 = _take(_dy_0, _rows11)
        _dz_1 = _take(_dz_0, _rows11)
        _p_gravity_1 = _take(_p_gravity_0, _rows11)
        _vx_1 = _take(_vx_0, _rows11)
        _vy_1 = _take(_vy_0, _rows11)
        _vz_1 = _take(_vz_0, _rows11)
        _when_1 = _take(_when_0, _rows11)
        _which_1 = _take(_which_0, _rows11)
        _x_1 = _take(_x_0, _rows11)
        _y_1 = _take(_y_0, _rows11)
        _z_1 = _take(_z_0, _rows11)
        _timed_1, = timed(_claims_1, 4.0, _which_1)
        _rows13, _count14 = _rows(_timed_1, _count12)
        if _count14:
            _clock_2 = _take(_clock_1, _rows13)
            _clock_error_2 = _take(_clock_error_1, _rows13)
            _dvx_2 = _take(_dvx_1, _rows13)
            _dvy_2 = _take(_dvy_1, _rows13)
            _dvz_2 = _take(_dvz_1, _rows13)
            _dx_2 = _take(_dx_1, _rows13)
            _dy_2 = _take(_dy_1, _rows13)
            _dz_2 = _take(_dz_1, _rows13)
            _p_gravity_2 = _take(_p_gravity_1, _rows13)
            _vx_2 = _take(_vx_1, _rows13)
            _vy_2 = _take(_vy_1, _rows13)
            _vz_2 = _take(_vz_1, _rows13)
            _when_2 = _take(_when_1, _rows13)
            _x_2 = _take(_x_1, _rows13)
            _y_2 = _take(_y_1, _rows13)
            _z_2 = _take(_z_1, _rows13)
            _dx_2, _dy_2, _dz_2, _dvx_2, _dvy_2, _dvz_2, _clock_error_2 = carry_time(_when_2, _x_2, _y_2, _z_2, _vx_2, _vy_2, _vz_2, _clock_2, _clock_error_2, _dx_2, _dy_2, _dz_2, _dvx_2, _dvy_2, _dvz_2, _p_gravity_2)
            _clock_error_1 = _put(_clock_error_1, _rows13, _clock_error_2, _count12)
            _dvx_1 = _put(_dvx_1, _rows13, _dvx_2, _count12)
            _dvy_1 = _put(_dvy_1, _rows13, _dvy_2, _count12)
            _dvz_1 = _put(_dvz_1, _rows13, _dvz_2, _count12)
            _dx_1 = _put(_dx_1, _rows13, _dx_2, _count12)
            _dy_1 = _put(_dy_1, _rows13, _dy_2, _count12)
            _dz_1 = _put(_dz_1, _rows13, _dz_2, _count12)
        _clock_error_0 = _put(_clock_error_0, _rows11, _clock_error_1, shots)
        _dvx_0 = _put(_dvx_0, _rows11, _dvx_1, shots)
        _dvy_0 = _put(_dvy_0, _rows11, _dvy_1, shots)
        _dvz_0 = _put(_dvz_0, _rows11, _dvz_1, shots)
        _dx_0 = _put(_dx_0, _rows11, _dx_1, shots)
        _dy_0 = _put(_dy_0, _rows11, _dy_1, shots)
        _dz_0 = _put(_dz_0, _rows11, _dz_1, shots)
    _closed_0, = closing(_claims_0, _outcome_0)
    _position_claim_1, _velocity_claim_1, _spin_claim_1, _time_claim_1 = claimed_errors(_clock_error_0, _dx_0, _dy_0, _dz_0, _dvx_0, _dvy_0, _dvz_0, _dwx_0, _dwy_0, _dwz_0)
    _position_claim_0 = _where(_closed_0, _position_claim_1, _position_claim_0)
    _spin_claim_0 = _where(_closed_0, _spin_claim_1, _spin_claim_0)
    _time_claim_0 = _where(_closed_0, _time_claim_1, _time_claim_0)
    _velocity_claim_0 = _where(_closed_0, _velocity_claim_1, _velocity_claim_0)
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
    columns["last"] = _last_0
    columns["position_claim"] = _position_claim_0
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
