"""The sizes, in SI units, between which no arithmetic of a shot over- or underflows unnoticed.

A release outside them is invalid; a flight that becomes larger makes its shot uncertain. Doubles
hold numbers of 2^±1022. Single precision holds numbers of 2^±126; proved bounds are carried in it,
and estimated errors where balls do not roll. With every length, speed, spin and acceleration at
most `MAX_SIZE` S = 2^30, the ball's radius R_B and gravity g at least 1/S, and a flight's place,
speed v and v²/g at most `MAX_FLIGHT` P = 2^60:

Where gravity may be zero, or is along no axis, it has no least size, unless a ball may roll, and no
bound on v²/g is asked for: the speed is at most `MAX_SPEED` V = 2^40, and every flight ends at the
time limit T at the latest. A flight then reaches places of P + V T + S T², as small as a fall of
that time does anyway. A time limit that is infinite, or a v²/g that is, makes bounds infinite, and
such a shot uncertain; what is divided by gravity is compared with what does without
(`events/box_windows.py`).

- In single precision the largest numbers are squares of a length or of a speed. A coordinate is at
  most P, and the contact point's slip at most v + R_B |w| <= P + 3 S² < 2^62, so that the sum of
  three squares stays below 2^126. Coordinates and times without a square reach S T² = 2^110 at a
  time limit T = `MAX_TIME`. A larger number becomes infinite, and so does the bound that it is in:
  then no contact is certain. Only a divisor that becomes infinite would hide that. The divisors are
  the squares above, and the gradient of a polynomial of a scene of one's own, which is checked
  (`ImplicitSurface.curvature`).
- In double precision the highest degree is that of the squared rate of a quartic: with coefficients
  of at most `MAX_COEFFICIENT` K = 2^100 it is (K P³ P)² = 2^680. Of the ring it is R⁷ v² or less
  (`events/ring/miss_filter.py`), 2^540.
- Divisors are no smaller than 1/S, or 2^-6/S with the ball's inertia kappa of at least 2^-6
  (`contact/ball.py`), except those that may be zero and are checked: a speed, a distance from an
  axis, a discriminant, a slope.
- Components of a state and other sizes may be as small as they like. A product that underflows is
  off by at most 2^-1074, in single precision 2^-149. Every margin has a term of u = 2^-53 times the
  condition's own size, at least R_B^d K^-1 for a degree d <= 4, that is 2^-273, or squared 2^-546;
  and every rounding that is carried counts for 2^-100 at least (`errors/propagation.py`), which is
  larger than what underflows of it by more than the factor 2^6 S that a division by kappa R_B
  restores.

A shot that is scaled by powers of two between these sizes is the same to the last bit. Only the
ring's search differs: it begins in single precision at a gym's sizes (`events/ring/single.py`).
"""

from __future__ import annotations

import sympy as sp

MAX_SIZE = sp.Integer(2) ** 30
"""Largest component of a release, and largest parameter that is a length, speed or acceleration."""

MIN_SIZE = 1 / MAX_SIZE
"""Smallest ball radius, and smallest gravity that cannot be zero."""

MAX_FLIGHT = sp.Integer(2) ** 60
"""Largest sum of a flight's coordinates, largest speed v and largest v²/g, in SI units."""

MAX_SPEED = sp.Integer(2) ** 40
"""Largest sum of a velocity's components where gravity may be zero, m/s."""

MAX_COEFFICIENT = sp.Integer(2) ** 100
"""Largest value of any other parameter, such as a coefficient of a polynomial. The largest
coefficient of a polynomial is at least the inverse of this."""

MAX_TIME = sp.Integer(2) ** 40
"""Largest finite time limit, s."""
