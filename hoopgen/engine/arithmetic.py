"""Whether this thread computes doubles as IEEE 754 says, which it may be made not to.

A library built with fast-math, once loaded, makes a thread take subnormals for zero; others leave
another rounding mode behind. Both change results of NumPy and of C, and no error is raised.
"""

from __future__ import annotations

import sys

__all__ = ["check_arithmetic", "exact"]

# Not in an expression below, which the interpreter would compute when it compiles.
_LEAST = sys.float_info.min
_TINY = sys.float_info.epsilon / 8


def exact() -> bool:
    """Return whether sums are rounded to the nearest double, and subnormals are kept."""
    return 1.0 + _TINY == 1.0 and 1.0 - _TINY == 1.0 and _LEAST / 2.0 * 2.0 == _LEAST


def check_arithmetic() -> None:
    """Do nothing, if this thread computes as it should.

    Raises
    ------
    RuntimeError
        If it does not; the message says how that comes about, and what helps.
    """
    if not exact():
        raise RuntimeError(
            "this thread rounds otherwise than to the nearest double, or takes subnormals for "
            "zero, which changes results. Another library of this process has set it so (one "
            "built with -ffast-math does when it is loaded); load it in a thread of its own, or "
            "call C's fesetenv(FE_DFL_ENV) in this one"
        )
