"""The derivation, as a reader would want it: what generated/derivation.md says.

Formulas are printed from the objects of derive/ that the kernels are lowered from, and keep them,
so that a test can evaluate what is printed. A quantity that a formula holds (`choice.Held`) has the
name that derive/ gives it, or one of its own where it is long or used more than once.
"""

from __future__ import annotations

from .explain import Formulas, Line, explain
from .notation import latex_name
from .page import Derivation, anchor, derivation_context

__all__ = [
    "Derivation",
    "Formulas",
    "Line",
    "anchor",
    "derivation_context",
    "explain",
    "latex_name",
]
