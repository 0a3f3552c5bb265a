"""The noise of a release: uniform numbers of random bits, and sums of normal ones.

A variable's noise is its deviation times a row of the factor of the correlations times standard
normal numbers, the terms in the order of the row.
"""

from __future__ import annotations

import sympy as sp

from ..ir.kernel import Kernel, kernel

RANDOM_BITS = 52
"""Random bits of a uniform number: with the half below them it has as many as a double holds."""

bits = sp.Symbol("bits", nonnegative=True)
"""A random whole number of `RANDOM_BITS` bits."""
weight, normal, total = sp.symbols("weight normal total", real=True)
"""An entry of the factor of the correlations, a standard normal number, a sum of such products."""
deviation = sp.Symbol("deviation", nonnegative=True)
"""The standard deviation of a variable."""

_ORDER = (bits, total, weight, normal, deviation)


def kernels() -> tuple[Kernel, ...]:
    """Return the kernels of a uniform number and of the noise."""
    return (
        kernel(
            "uniform_number",
            {"uniform": (bits + sp.Rational(1, 2)) / 2**RANDOM_BITS},
            _ORDER,
            "Uniform number in the open interval (0, 1), an odd multiple of 2^-53.",
            "the middle of an interval of width 2^-52",
        ),
        kernel(
            "first_term",
            {"total": weight * normal},
            _ORDER,
            "First term of a sum of weighted normal numbers.",
            "the product of the correlations' factor with normal numbers",
        ),
        kernel(
            "next_term",
            {"total": total + weight * normal},
            _ORDER,
            "Sum of weighted normal numbers with one more term.",
            "the product of the correlations' factor with normal numbers",
        ),
        kernel(
            "deviation_of_sum",
            {"noise": deviation * total},
            _ORDER,
            "Noise of a variable.",
            "the deviation times a sum with variance 1",
        ),
    )
