"""NumPy kernels of the scene hoop.

Generated from templates/numpy/kernels.py.j2, scene hoop, derivation 604c640efcccdbbc,
with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
and run `make generate`.
Every function takes scalars or arrays that broadcast and is evaluated element by element; SI units.
"""

# ruff: noqa: E501

from __future__ import annotations

from typing import Any

from numpy import absolute, inf, sqrt, where

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

SURFACES: tuple[tuple[str, int, bool], ...] = (
    ("ring", 3, False),
    ("backboard", 0, True),
    ("bridge", 0, True),
    ("end", 0, False),
)
"""Surfaces in order, the end plane last: name, windows of its search (0: a plane), bounded or not."""

SHARES: tuple[float, ...] = (2.9802322387695312e-08, 9.313225746154785e-10, 2.9103830456733704e-11, 9.094947017729282e-13, 2.842170943040401e-14)
"""Errors, relative to the flight, that a search allows for, one after another."""

STEP_LIMIT = 200
"""Steps after which a search gives up and the shot is uncertain."""

OUTPUTS: dict[str, tuple[str, ...]] = {
    "flight": ("x", "y", "z", "vx", "vy", "vz",),
    "contact_frame": ("n11", "n12", "n13", "n21", "n22", "n23", "n31", "n32", "n33",),
    "impact_through_frame": ("vx", "vy", "vz", "wx", "wy", "wz",),
    "impact": ("vx", "vy", "vz", "wx", "wy", "wz",),
    "crossing": ("clearance", "delay",),
    "allowance": ("level", "velocity_level", "excess",),
    "horizon": ("horizon", "pad",),
    "scale": ("extent", "speed", "excess",),
    "displacement": ("margin",),
    "carry_flight": ("dx", "dy", "dz", "dvx", "dvy", "dvz", "delay", "shift",),
    "carry_impact": ("dvx", "dvy", "dvz", "dwx", "dwy", "dwz",),
    "error_bounds": ("position_error", "velocity_error", "spin_error", "time_error",),
    "claimed_errors": ("position_error", "velocity_error", "spin_error", "time_error",),
    "allowed": ("allowed",),
    "valid": ("valid", "doubt",),
    "target": ("target",),
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
    "backboard_coefficients": ("c0", "c1",),
    "backboard_deflated": ("c0",),
    "backboard_normal": ("nx", "ny", "nz",),
    "backboard_curvature": ("curvature",),
    "backboard_bounds": ("g0", "g1", "g2", "g3",),
    "backboard_arrival": ("time", "rate", "bend", "apex", "height",),
    "backboard_margin": ("margin",),
    "backboard_place": ("x", "y", "z",),
    "bridge_coefficients": ("c0", "c1", "c2",),
    "bridge_deflated": ("c0", "c1",),
    "bridge_normal": ("nx", "ny", "nz",),
    "bridge_curvature": ("curvature",),
    "bridge_bounds": ("g0", "g1", "g2", "g3", "g4",),
    "bridge_arrival": ("time", "rate", "bend", "apex", "height",),
    "bridge_margin": ("margin",),
    "bridge_place": ("x", "y", "z",),
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

    bounds of the event condition. 165 operations: 28 additions, 20 subtractions, 48 multiplications, 3 divisions, 5 square roots, 1 negation, 5 absolute values, 24 comparisons, 31 selections.
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
    s28 = ring_radius - s8
    s29 = 0.0001220703125 * ring_radius
    s30 = where((s28 < s29), s29, s28)
    s31 = ((s1 * (s30 * s30)) - s19) - s4
    s32 = sqrt(where((s31 < 0.0), 0.0, s31))
    s33 = where(s26, where(s25, (((s22 + s23) - s21) * s24), (-inf)), inf)
    s34 = 0.0 < where(s26, s31, 0.0)
    s35 = where(s34, (((s23 - s21) - s32) * s24), s33)
    s36 = (s0 + (s9 * (z - s8))) - s10
    s37 = sqrt(where((s36 < 0.0), 0.0, s36))
    s38 = where(s15, (s12 * ((vz + s13) + s14)), (-inf))
    s39 = 0.0 < s36
    s40 = where(s39, (s12 * ((vz + s14) - s37)), s38)
    s41 = where((s35 < s40), s35, s40)
    s42 = where(s34, (((s32 - s21) - s23) * s24), inf)
    s43 = where((s42 < s35), s35, s42)
    s44 = where((s16 < s43), s43, s16)
    s45 = where((s33 < s40), s33, s40)
    s46 = where(s39, (s12 * ((vz + s37) - s14)), inf)
    s47 = where((s46 < s40), s40, s46)
    s48 = s44 <= s45
    s49 = where(s48, s45, where((s35 < s38), s35, s38))
    s50 = where((s33 < s38), s33, s38)
    s51 = 1.0 / s30
    s52 = where((0.0 < s41), s41, 0.0)
    s53 = where((s52 < s49), s49, s52)
    s54 = where((s53 < s50), s50, s53)
    s55 = (0.000244140625 * ring_radius) - (ring_radius - s7)
    s56 = ((position_error + (horizon * velocity_error)) - (1.52587890625e-05 * ball_radius)) - (1.52587890625e-05 * wire_radius)
    return s2, s5, sqrt(s6), where((s16 < s27), s27, s16), s41, where(s48, s44, where((s47 < s27), s27, s47)), s49, where((s47 < s43), s43, s47), s50, (((6.0003662109375 * gravity) * s7) + (s5 * (s51 * (s51 * s51)))) + absolute(s2), where((s54 < horizon), s54, horizon), where((s55 < s56), s56, s55)


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
