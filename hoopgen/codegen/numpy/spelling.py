"""NumPy's spelling of operations, on rows of shots and on one shot."""

from __future__ import annotations

from dataclasses import replace

from ..formatter import INFIX, Spelling

NUMPY = Spelling(
    operations=INFIX
    | {
        "sqrt": "_sqrt({0})",
        "abs": "_absolute({0})",
        "max": "_where({0} < {1}, {1}, {0})",
        "min": "_where({0} < {1}, {0}, {1})",
        "less": "({0} < {1})",
        "at_most": "({0} <= {1})",
        "equal": "({0} == {1})",
        "both": "_logical_and({0}, {1})",
        "either": "_logical_or({0}, {1})",
        "not": "_logical_not({0})",
        "nowhere": "False",
        "select": "_where({0}, {1}, {2})",
    },
    infinity="_inf",
)

NUMPY_SINGLE = replace(NUMPY, constant="_float32({0})", infinity="_float32(_inf)")
"""Before NumPy 2 one number of single precision and one of Python's make a double."""

ONE_SHOT = replace(
    NUMPY,
    operations={
        **NUMPY.operations,
        "sqrt": "_root({0})",
        "abs": "abs({0})",
        "max": "({1} if {0} < {1} else {0})",
        "min": "({0} if {0} < {1} else {1})",
        "both": "({0} and {1})",
        "either": "({0} or {1})",
        "not": "(not {0})",
        "select": "({1} if {0} else {2})",
    },
)
"""NumPy for one shot: operations of numbers."""
