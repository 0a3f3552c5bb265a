"""Held quantities (`derive/symbolic/conditionals.py`)."""

import sympy as sp
from hoopgen.derive.symbolic.conditionals import IfLess, barrier
from sympy.core.cache import clear_cache

x, y = sp.symbols("x y", real=True)


def deep(levels: int) -> sp.Expr:
    """Return a quantity that holds each level before it three times."""
    found = x
    for level in range(levels):
        found = barrier(IfLess(found, y + level, found * y, found))
    return found


def test_equal_quantities_are_one_object() -> None:
    """A second derivation finds the quantities of the first, whatever SymPy remembers.

    Else a comparison of the two would take 3^40 steps.
    """
    first = deep(40)
    clear_cache()
    assert deep(40) is first


def test_a_name_is_kept_apart() -> None:
    """A quantity with a name of its own is another than the same without."""
    assert barrier(x + y, "a").name == "a"
    assert barrier(x + y).name == ""
