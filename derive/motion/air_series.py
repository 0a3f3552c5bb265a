"""The symbols of the power series of a piece of a flight through air, and sums of their terms.

`air` has the recurrence of the coefficients.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import sympy as sp

from ..symbolic.conditionals import barrier
from ..symbolic.symbols import VELOCITY, velocity

ORDER = 15
"""Degree of the velocity in time. The piece's root is then of degree 16: four square roots."""

FIRST_SINGLE = 9
"""The first order of which the coefficients of σ, and the next of the velocity, are computed in
single precision."""

SKETCH_TERMS = 5
"""Number of the terms of the velocity in a sketch of the path."""

TUBE = sp.Rational(1, 2**10)
"""Largest error of the velocity for which the bound is proved, m/s."""

CARRIED_SHARE = sp.Rational(1, 4)
"""Share of a piece's errors that is carried. They are proved bounds, unlike roundings that are
carried with the sign that makes errors grow, and decisions allow for 16 times what is carried."""

drag_rate = sp.Symbol("drag_rate", nonnegative=True)
"""k_d, 1/m."""
magnus_rate = sp.Matrix(sp.symbols("magnus_rate_x magnus_rate_y magnus_rate_z", real=True))
"""Ω, 1/s."""
free_fall = sp.symbols("free_fall_x free_fall_y free_fall_z", real=True)
"""g_e, m/s²."""
piece = sp.Symbol("piece", positive=True)
"""Length of a piece, s."""
growth = sp.Symbol("growth", positive=True)
"""G, by which an error of the velocity grows at most within a piece."""
piece_place_error, piece_speed_error = sp.symbols(
    "piece_place_error piece_speed_error", nonnegative=True
)
"""Bounds on the errors of position and velocity that a piece adds, m and m/s."""
unproved = sp.Symbol("unproved", nonnegative=True)
"""Infinite if no bound is proved for a piece, else zero."""
piece_speed, piece_acceleration, piece_jerk = sp.symbols(
    "piece_speed piece_acceleration piece_jerk", nonnegative=True
)
"""Bounds within a piece: on the size of the velocity, on that of the acceleration, and on that of
the second derivative of the velocity's series."""

AIRSPEEDS = sp.symbols(f"airspeed_0:{ORDER + 1}", real=True)
"""σ_0 to σ_P."""
inverse_airspeed = sp.Symbol("inverse_airspeed", nonnegative=True)
"""1/σ_0, s/m."""
VELOCITIES = (
    velocity,
    *(
        sp.Matrix([sp.Symbol(f"{s.name}_{k}", real=True) for s in VELOCITY])
        for k in range(1, ORDER + 1)
    ),
)
"""V_0 to V_P."""

TAIL = (
    *AIRSPEEDS[FIRST_SINGLE:],
    *(v for vector in VELOCITIES[FIRST_SINGLE + 1 :] for v in vector),
)
"""The coefficients that are computed in single precision."""

SHORT: dict[sp.Symbol, sp.Symbol] = {
    symbol: sp.Symbol(f"short_{symbol.name}", real=True)
    for symbol in (
        *(v for vector in VELOCITIES[: FIRST_SINGLE + 1] for v in vector),
        *(*AIRSPEEDS[:FIRST_SINGLE], inverse_airspeed, drag_rate, *magnus_rate),
    )
}
"""By the other coefficients and the rates, the symbols of these in single precision."""


class Series(NamedTuple):
    """The symbols of the coefficients of a piece by order, and those of the rates."""

    velocities: tuple[sp.Matrix, ...]
    airspeeds: tuple[sp.Symbol, ...]
    drag_rate: sp.Symbol
    magnus_rate: sp.Matrix
    inverse: sp.Expr
    """1/σ_0."""


DOUBLE_SERIES = Series(VELOCITIES, AIRSPEEDS, drag_rate, magnus_rate, inverse_airspeed)
"""Coefficients and rates as they are computed."""

PLAIN_SERIES = DOUBLE_SERIES._replace(inverse=1 / AIRSPEEDS[0])
"""The same, and 1/σ_0 as a function of σ_0."""

SINGLE_SERIES = Series(
    tuple(vector.applyfunc(lambda s: SHORT.get(s, s)) for vector in VELOCITIES),
    tuple(SHORT.get(s, s) for s in AIRSPEEDS),
    SHORT[drag_rate],
    magnus_rate.applyfunc(lambda s: SHORT[s]),
    SHORT[inverse_airspeed],
)
"""All of them in single precision."""

tail_lost = sp.Symbol("tail_lost", nonnegative=True)
"""Infinite if a coefficient does not fit into single precision, else zero."""

piece_rest = sp.Symbol("piece_rest", nonnegative=True)
"""Bound on the size of all terms of the velocity from the order `SKETCH_TERMS` on, m/s."""

piece_extent = sp.Symbol("piece_extent", nonnegative=True)
"""Bound on the sum of the coordinates' sizes within a piece, m."""

BOUNDS = (
    *(piece, growth, piece_place_error, piece_speed_error, unproved),
    *(piece_speed, piece_acceleration, piece_jerk, piece_rest, piece_extent),
)
"""The length of a piece, and bounds within it."""

RATES = (drag_rate, *magnus_rate, *free_fall)

SERIES_KERNELS = (
    *("air_rates", *(f"air_order_{k}" for k in range(FIRST_SINGLE)), "air_short"),
    *(*(f"air_order_{k}" for k in range(FIRST_SINGLE, ORDER + 1)), "air_tail", "piece"),
)
"""The names of the kernels of a piece's series, in order."""

PIECE_KERNELS = (*SERIES_KERNELS, "piece_excess")
"""The names of the kernels that begin a piece of a shot, in order."""


def total(terms: Sequence[sp.Expr]) -> sp.Expr:
    """Return the sum of terms, which are all computed before."""
    return barrier(sp.Add(*terms))


def latest_last(known: Sequence[sp.Expr], latest: sp.Expr) -> sp.Expr:
    """Return the sum of terms of which one is known later than the others, and is added last.

    Parameters
    ----------
    known
        The others.
    latest
        The term that is known last.
    """
    return barrier(total(known) + latest) if known else latest
