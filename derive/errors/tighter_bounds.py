"""Tighter bounds on the errors of a shot, through the product of several contacts.

The product of |T_k|, ..., |T_1| of the lemma in `contact_frames` grows faster than that of the
matrices themselves, in which much cancels.

**Lemma.** Let O be the bounds on the six coordinates q_s, ..., y_w at a departure, and M the
product of the matrices T of all contacts since then, as computed. Then these coordinates are within
|M| O + C, where C is zero at first, and a contact makes of it

    |T| (C + 2^-20 B) + |T_n| B_n + |T_z| B_z + B',

with the columns T_n and T_z of q_n and of y_z.

*Proof.* By induction let the coordinates before a contact be M o + c with |o| <= O and |c| <= C.
After it they are T M o + T c + T_n q_n + T_z y_z + r with |r| <= B'; the roundings of T itself are
in B'. An element of the computed T M is a sum of six products in single precision, off by at most
2^-20 of the same sum of absolute values, and |T| |M| O <= |T| B, since B >= |M| O. ∎
"""

from __future__ import annotations

import sympy as sp

from ..motion.parabola import Parabola
from ..symbolic.conditionals import IfAtMost, IfLess, barrier
from ..symbolic.rounding import ROUNDING_SLACK
from .contact_frames import BOUNDS, SIZE, Arrival, Impact, growth, weighted_sum

ORIGIN = sp.symbols("origin_s origin_e origin_u origin_v origin_w origin_t", nonnegative=True)
"""O: the bounds of these at the departure from an earlier contact."""
PRODUCT = sp.symbols("product_1:7(1:7)", real=True)
"""M by rows: the product of the matrices T of the contacts since then."""
RECENT = sp.symbols("recent_s recent_e recent_u recent_v recent_w recent_t", nonnegative=True)
"""C: bounds on what has come to the coordinates since then."""
continued = sp.Symbol("continued", nonnegative=True)
"""1: O, M and C go on; 0: they begin with the bounds, the identity and zero."""

TIGHTENING = (*ORIGIN, *PRODUCT, *RECENT, continued)
"""The numbers that are carried besides the bounds themselves."""

PRODUCT_ROUNDING = sp.Rational(1, 2**20)
"""Roundings of T M in single precision, of |T| times bounds that are at least |M| O."""

RENEWAL = sp.Rational(1, 4)
"""O, M and C begin anew where C is more than this share of |M| O."""

WEIGHTS = (1, 1, *[sp.Rational(1, 8)] * 3, sp.Rational(1, 64))
"""The weights of the coordinates in this: lengths in m, with 1/8 s, and y_w with 1/64 m s."""


def tighter_errors(flight: Parabola, impact: Impact) -> dict[str, sp.Expr]:
    """Return the bounds after a contact by |M| O + C, and the next O, M and C.

    Parameters
    ----------
    flight, impact
        As for `contact_frames.contact_errors`.
    """
    grows = growth(flight, impact)
    rest = impact.rest(Arrival(flight, impact.ball, grows.here, grows.gap))
    own = BOUNDS[1 : 1 + SIZE]
    origin = [IfLess(0, continued, o, bound) for o, bound in zip(ORIGIN, own, strict=True)]
    since = [IfLess(0, continued, c, 0) for c in RECENT]
    before = [
        [IfLess(0, continued, PRODUCT[SIZE * k + j], sp.Integer(k == j)) for j in range(SIZE)]
        for k in range(SIZE)
    ]
    rounded = (barrier(c + PRODUCT_ROUNDING * b) for c, b in zip(since, own, strict=True))
    come = grows.times((BOUNDS[0], *rounded, BOUNDS[-1], BOUNDS[-1]))[:SIZE]
    recent = [
        barrier(ROUNDING_SLACK * barrier(value + extra))
        for value, extra in zip(come, rest.extras, strict=True)
    ]
    made = grows.columns[1 : 1 + SIZE]
    product = [
        [barrier(sum(made[k][i] * before[k][j] for k in range(SIZE))) for j in range(SIZE)]
        for i in range(SIZE)
    ]
    main = [weighted_sum(row, origin) for row in product]
    found = [m + c for m, c in zip(main, recent, strict=True)]
    new, old = (
        barrier(sum(weight * value for weight, value in zip(WEIGHTS, values, strict=True)))
        for values in (recent, main)
    )
    kept = dict(zip((*ORIGIN, *RECENT), (*origin, *recent), strict=True))
    kept |= dict(zip(PRODUCT, (element for row in product for element in row), strict=True))
    return {
        **grows.errors_after(impact.ball, found, rest),
        **{symbol.name: value for symbol, value in kept.items()},
        continued.name: IfAtMost(new, RENEWAL * old, 1, 0),
    }
