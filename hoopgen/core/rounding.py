"""The rounding mode of a thread while modules are imported."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress

_ENVIRONMENT_SIZE = 256
"""Bytes for a floating-point environment of C, more than any platform's takes."""

_TO_NEAREST = 0
"""FE_TONEAREST on all platforms in use."""


@contextmanager
def rounding_to_nearest() -> Iterator[None]:
    """Have this thread round to nearest; its environment is as before at exit.

    Python reads decimal numbers of a source with the thread's arithmetic: imported in another mode
    a module would have constants that are an ulp off, also in the ``.pyc`` that Python stores.
    """
    if _is_to_nearest():
        yield
        return
    before = ctypes.create_string_buffer(_ENVIRONMENT_SIZE)
    library = None
    with suppress(OSError, AttributeError):  # where C has no such functions nothing can be set
        library = ctypes.CDLL("ucrtbase" if os.name == "nt" else None)
        library.fegetenv(before)
        library.fesetround(_TO_NEAREST)
    try:
        yield
    finally:
        if library is not None:
            library.fesetenv(before)


def _is_to_nearest() -> bool:
    one = float(1)
    half = one / 2**53  # of the distance to the next double: a tie, which goes to even
    return one + half == one == one - half / 2 and -one - half == -one
