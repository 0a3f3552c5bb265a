"""The quantile of the normal distribution: a standard normal number from a uniform one.

Wichura, *Algorithm AS 241: The percentage points of the normal distribution* (1988): rational
functions of p - 1/2 in the middle and of sqrt(-log p) in the tails, good to 1e-16 of the quantile.
"""

from __future__ import annotations

import sympy as sp

from ..ir.kernel import Kernel, kernel
from ..symbolic.conditionals import AtMost, Choose, IfAtMost, IfLess, absolute, barrier, minimum
from .compensated import horner, rest_of, truncated

probability = sp.Symbol("probability", positive=True)
"""p, within 0 and 1, a multiple of 2^-53, so that p - 1/2 and 1 - p are exact."""

LOGARITHM_TERMS = 12
"""Terms of the series of the logarithm: the next one is below 2^-60 of it."""

_MIDDLE = (
    ("3.3871328727963666080", "133.14166789178437745", "1971.5909503065514427")
    + ("13731.693765509461125", "45921.953931549871457", "67265.770927008700853")
    + ("33430.575583588128105", "2509.0809287301226727"),
    ("1", "42.313330701600911252", "687.18700749205790830")
    + ("5394.1960214247511077", "21213.794301586595867", "39307.895800092710610")
    + ("28729.085735721942674", "5226.4952788528545610"),
)
_NEAR_TAIL = (
    ("1.42343711074968357734", "4.63033784615654529590", "5.76949722146069140550")
    + ("3.64784832476320460504", "1.27045825245236838258", ".241780725177450611770")
    + (".0227238449892691845833", "7.74545014278341407640e-4"),
    ("1", "2.05319162663775882187", "1.67638483018380384940")
    + (".689767334985100004550", ".148103976427480074590", ".0151986665636164571966")
    + ("5.47593808499534494600e-4", "1.05075007164441684324e-9"),
)
_FAR_TAIL = (
    ("6.65790464350110377720", "5.46378491116411436990", "1.78482653991729133580")
    + (".296560571828504891230", ".0265321895265761230930", ".00124266094738807843860")
    + ("2.71155556874348757815e-5", "2.01033439929228813265e-7"),
    ("1", ".599832206555887937690", ".136929880922735805310")
    + (".0148753612908506148525", "7.86869131145613259100e-4", "1.84631831751005468180e-5")
    + ("1.42151175831644588870e-7", "2.04426310338993978564e-15"),
)
"""Coefficients of numerator and denominator, the lowest first: tables of the algorithm PPND16."""

MIDDLE = sp.Rational(17, 40)
"""Distance of p from 1/2 up to which the first rational function holds."""


def _ratio(coefficients: tuple[tuple[str, ...], tuple[str, ...]], variable: sp.Expr) -> sp.Expr:
    over, under = (horner([sp.Rational(c) for c in row], variable) for row in coefficients)
    return barrier(over / under)


def _minus_logarithm(value: sp.Expr) -> sp.Expr:
    """Return minus the logarithm of a number from 2^-63 to 1.

    The number is m 2^-e with m from sqrt(1/2) to sqrt(2), and log m = 2 (f + f³/3 + …) with
    f = (m - 1)/(m + 1).
    """
    mantissa, exponent = value, sp.Integer(0)
    for power in (32, 16, 8, 4, 2, 1):
        small = barrier(mantissa)
        bound = sp.Integer(2) ** -power
        mantissa = barrier(small * barrier(IfLess(small, bound, 2**power, 1)))
        exponent = barrier(exponent + IfLess(small, bound, power, 0))
    low = sp.Rational(181, 256)  # about sqrt(1/2)
    small = mantissa
    mantissa = barrier(small * barrier(IfLess(small, low, 2, 1)))
    exponent = barrier(exponent + IfLess(small, low, 1, 0))
    part = barrier(barrier(mantissa - 1) / barrier(mantissa + 1))
    square = barrier(part**2)
    series = [sp.Rational(2, 2 * k + 1) for k in range(1, LOGARITHM_TERMS)]
    head = truncated(sp.log(2), 32)
    tail = rest_of(sp.log(2), head)
    small_terms = barrier(barrier(part * square) * horner(series, square))
    rest = barrier(barrier(exponent * tail) - small_terms)
    return barrier(barrier(exponent * head) + barrier(rest - 2 * part))


_OFFSET = barrier(probability - sp.Rational(1, 2))

IS_MIDDLE = AtMost(absolute(_OFFSET), MIDDLE)
"""True if the first rational function holds."""


def _middle() -> sp.Expr:
    """Return the quantile of a probability in the middle."""
    return barrier(_OFFSET * _ratio(_MIDDLE, barrier(MIDDLE**2 - _OFFSET**2)))


def _tail() -> sp.Expr:
    """Return the quantile of a probability in one of the tails."""
    outside = barrier(minimum(probability, barrier(1 - probability)))
    root = barrier(sp.sqrt(_minus_logarithm(outside)))
    near = _ratio(_NEAR_TAIL, barrier(root - sp.Rational(8, 5)))
    far = _ratio(_FAR_TAIL, barrier(root - 5))
    tail = barrier(IfAtMost(root, 5, near, far))
    return IfLess(_OFFSET, 0, -tail, tail)


def normal_quantile() -> Kernel:
    """Return the kernel of the standard normal number below which is a given probability."""
    return kernel(
        "normal_quantile",
        {"quantile": Choose(IS_MIDDLE, _middle(), _tail())},
        (probability,),
        "Standard normal number below which is a probability, within six units in the last place.",
        "Algorithm AS 241",
    )


def normal_quantile_parts() -> tuple[Kernel, ...]:
    """Return the kernels of the same numbers in the middle and in the tails, and of their choice.

    Fifteen in a hundred probabilities are in the tails, which take four fifths of the operations.
    """
    return (
        kernel(
            "normal_is_middle",
            {"middle": IS_MIDDLE},
            (probability,),
            "True if a probability is in the middle.",
            "Algorithm AS 241",
        ),
        kernel(
            "normal_middle",
            {"quantile": _middle()},
            (probability,),
            "Standard normal number below which is a probability in the middle.",
            "Algorithm AS 241",
        ),
        kernel(
            "normal_tail",
            {"quantile": _tail()},
            (probability,),
            "Standard normal number below which is a probability in one of the tails.",
            "Algorithm AS 241",
        ),
    )
