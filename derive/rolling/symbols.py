"""The symbols that the kernels of the contact phase share, and the codes of its events."""

from __future__ import annotations

import sympy as sp

from ..symbolic.conditionals import Boolean

BEGINS, ROLLS, LEAVES, FALLS_OFF, STARTS = 1, 2, 3, 4, 5
"""Values of `mode`: the contact begins, goes on, or ends in the next turn, by itself or at an edge
of the surface; or the shot starts on a surface, and this turn decides whether the ball stays there.
0 is flight."""

held, mode = sp.symbols("held mode", real=True)
"""Index of the surface that the ball stays in contact with, and the state of that contact."""

nearest, near = sp.symbols("nearest near", real=True)
"""Distance to the nearest other surface; half the width of a seam, m."""

stride, strongest, fastest = sp.symbols("stride strongest fastest", nonnegative=True)
"""Length of a step, s, and bounds on acceleration and speed within it."""

missed = sp.Symbol("missed", nonnegative=True)
"""Truncation error of the velocity in one step of the series, m/s."""

force, force_rate, force_bend, friction_force_rate = sp.symbols(
    "force force_rate force_bend friction_force_rate", real=True
)
"""Normal force per unit mass N, its rate, a bound on its second derivative, and -2 F·n'."""

free_time = sp.Symbol("free_time", nonnegative=True)
"""Time for which a ball that leaves a surface certainly meets no other one, s."""

gap, nearing, gap_curvature, gap_convexity = sp.symbols(
    "gap nearing gap_curvature gap_convexity", real=True
)
"""Distance to a surface, its rate, and bounds on its downward and its upward curvature, 1/m."""

lift, gap_jerk, gap_snap = sp.symbols("lift gap_jerk gap_snap", real=True)
"""Second, third and fourth derivative of the distance along a flight."""

turning = sp.Matrix(sp.symbols("turning_x turning_y turning_z", real=True))
"""Rate of the normal, n'."""

rolled = sp.Matrix(sp.symbols("rolled_x rolled_y rolled_z", real=True))
"""Velocity after a contact that grips."""

slip, bounce = sp.symbols("slip bounce", real=True)
"""Speed of the contact point along the surface, and speed of the ball off it."""

rebound = sp.Symbol("rebound", nonnegative=True)
"""Restitution of the surface for bounces without speed."""

press, weight, rolling_friction = sp.symbols("press weight rolling_friction", real=True)
"""Normal force, free fall along the normal and friction of a rolling ball, per unit mass."""

rolling_acceleration = sp.Matrix(
    sp.symbols("rolling_acceleration_x rolling_acceleration_y rolling_acceleration_z", real=True)
)
"""Acceleration of a rolling ball."""

rolling_gap_acceleration, normal_cosine = sp.symbols(
    "rolling_gap_acceleration normal_cosine", real=True
)
"""Second derivative of the distance to another surface while the ball rolls, and its rate along the
normal of the surface under the ball: the cosine of the angle between both normals."""

outside_time, outside_distance = sp.symbols("outside_time outside_distance", real=True)
"""Time for which the ball certainly stays outside the bounds of a surface; distance from them."""

second_contact_gap = sp.Symbol("second_contact_gap", real=True)
"""Largest distance that the ball gets from a second surface that also presses on it, m."""

body, reached, outcome, uncertain, assured, time_limit, began, rolls, most_contacts = sp.symbols(
    "body reached outcome uncertain assured time_limit began rolls most_contacts", real=True
)

settles, lodges, slides, unpressed = map(Boolean, ("settles", "lodges", "slides", "unpressed"))
"""The end of bounces: in rolling, between two surfaces, with slip left, or with no force onto
the surface."""

nearly = Boolean("nearly")
"""True if a bounce is so small that it may be the last before the ball rolls."""

undecided, ends, rests, edge, goes_on = map(
    Boolean, ("undecided", "ends", "rests", "edge", "rolling")
)


class EventCodes:
    """The indices of events in contact, which follow those of the surfaces.

    Parameters
    ----------
    surfaces
        How many surfaces and end planes there are.
    bodies
        How many bodies there are.
    """

    def __init__(self, surfaces: int, bodies: int) -> None:
        self.time = surfaces
        self.begins, self.leaves, self.hops = surfaces + 1, surfaces + 2, surfaces + 3
        self.endless = surfaces + 4
        self.piece_end = surfaces + 5
        self.over_edge = surfaces + 6
        self.apex = surfaces + 7
        self.bodies = bodies

    def log_row(self, body: sp.Expr, leaves: bool) -> sp.Expr:
        """Return the code in the event log of a contact with a body that begins or ends.

        Parameters
        ----------
        body
            The index of the body.
        leaves
            True for the end of a contact, False for its beginning.
        """
        return self.bodies + 1 + 2 * body + int(leaves)
