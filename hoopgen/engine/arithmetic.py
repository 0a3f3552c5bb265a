"""Checks that this thread computes doubles as IEEE 754 says.

A library built with fast-math, once loaded, makes a thread take subnormals for zero; others leave
another rounding mode behind. Both change results of NumPy, and no error is raised. A compiled scene
sets the default environment for as long as it runs, and `CompiledScene.exact_arithmetic` does so
for NumPy.
"""

from __future__ import annotations

import sys

# Not in an expression below, which the interpreter would compute when it compiles.
_SMALLEST_NORMAL = sys.float_info.min
_TINY = sys.float_info.epsilon / 8


def is_exact() -> bool:
    """Return whether this thread rounds to nearest and keeps subnormals."""
    return (
        1.0 + _TINY == 1.0
        and 1.0 - _TINY == 1.0
        and _SMALLEST_NORMAL / 2.0 * 2.0 == _SMALLEST_NORMAL
    )


def check_arithmetic() -> None:
    """Raise an error if this thread does not compute doubles as IEEE 754 says.

    Raises
    ------
    RuntimeError
        If it does not; the message names causes and remedies.
    """
    if not is_exact():
        raise RuntimeError(
            "this thread rounds otherwise than to the nearest double, or takes subnormals for "
            "zero, which changes results, and there is no C engine that could set it right. A "
            "library of this process has set it so (one built with -ffast-math does when it is "
            "loaded); load it in a thread of its own, or call C's fesetenv(FE_DFL_ENV) in this one"
        )
