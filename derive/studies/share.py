"""Wilson's score interval of a share (1927).

Of k successes in n trials, with the quantile z, its ends are

    (k + z²/2 ± z sqrt(k (n - k)/n + z²/4)) / (n + z²).
"""

from __future__ import annotations

import sympy as sp

from ..ir.kernel import Kernel, kernel
from ..symbolic.conditionals import IfLess, barrier

made, shots = ARGUMENTS = sp.symbols("made shots", nonnegative=True)
"""k and n."""
quantile = sp.Symbol("quantile", positive=True)
"""z, of the normal distribution or of Student's t."""


def wilson_interval() -> Kernel:
    """Return the kernel of the interval's ends: without a success 0, without a failure 1."""
    square = barrier(quantile**2)
    spread = barrier(barrier(made * barrier(shots - made)) / shots)
    half = barrier(quantile * barrier(sp.sqrt(barrier(spread + square / 4))))
    middle, whole = barrier(made + square / 2), barrier(shots + square)
    return kernel(
        "wilson_interval",
        {
            "low": IfLess(0, made, barrier(middle - half) / whole, 0),
            "high": IfLess(made, shots, barrier(middle + half) / whole, 1),
        },
        (made, shots, quantile),
        "Ends of the score interval of a share.",
        "Wilson (1927)",
    )
