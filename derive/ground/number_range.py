"""The sizes, in SI units, between which no arithmetic of a shot over- or underflows unnoticed.

A release outside them is invalid; a flight that becomes larger makes its shot uncertain. Doubles
hold numbers of 2^±1022, single precision, in which errors are carried where balls do not roll, of
2^±126. With every length, speed, spin and acceleration at most `MAX_SIZE` S = 2^30, the ball's
radius R_B and gravity g at least 1/S, and a flight's place, speed v and v²/g at most `MAX_FLIGHT`
P = 2^60:

- In single precision the largest numbers are squares of a length or of a speed. A coordinate is at
  most P, and the contact point's slip at most v + R_B |w| <= P + 3 S² < 2^62, so that the sum of
  three squares stays below 2^126. Coordinates and times without a square reach S T² = 2^110 at a
  time limit T = `MAX_TIME`. A larger number becomes infinite, and so does the bound that it is in:
  then no contact is certain. Only a divisor that becomes infinite would hide that. The divisors are
  the squares above, and the gradient of a polynomial of a scene of one's own, which is asked
  (`Free.curvature`).
- In double precision the highest degree is that of the squared rate of a quartic: with coefficients
  of at most `MAX_COEFFICIENT` K = 2^100 it is (K P³ P)² = 2^680. Of the ring it is R⁷ v² or less
  (`search/clear.py`), 2^540.
- Divisors are no smaller than 1/S, but for what may be zero as well and is asked: a speed, a
  distance from an axis, a discriminant, a slope.
- Components of a state and other sizes may be as small as they like. A product that underflows is
  off by at most 2^-1074, in single precision 2^-149. Every margin has a term of u = 2^-53 times the
  condition's own size, at least R_B^d K^-1 for a degree d <= 4, that is 2^-273, or squared 2^-546;
  and every rounding that is carried counts for 2^-100 at least (`errors/tangent.py`), which is
  larger than what underflows of it by more than the factor S that a division by R_B restores.

Scaled by powers of two between these sizes, a shot is the same to the last bit, but for the ring's
search, which begins in single precision where the sizes are those of a gym (`search/coarse.py`).
"""

from __future__ import annotations

import sympy as sp

MAX_SIZE = sp.Integer(2) ** 30
"""Of a component of a release, and of a parameter that is a length, a speed or an acceleration."""

MIN_SIZE = 1 / MAX_SIZE
"""Of the ball's radius and of gravity."""

MAX_FLIGHT = sp.Integer(2) ** 60
"""Of the sum of a flight's coordinates, of its speed v, and of v²/g: SI units."""

MAX_COEFFICIENT = sp.Integer(2) ** 100
"""Of any other parameter, a coefficient of a polynomial for one; and, inverted, the least that the
largest coefficient of a polynomial may be."""

MAX_TIME = sp.Integer(2) ** 40
"""Of a finite time limit, s."""
