"""The derivation page, generated/derivation.md.

Formulas are printed from the objects of derive/ that the kernels are lowered from, and keep these
objects, so that a test can evaluate the printed formulas. A held quantity in a formula has the name
that derive/ gives it, or one of its own if it is long or used more than once.
"""

from __future__ import annotations

from hoopgen.derive.symbolic.notation import latex_name

from .explain import Formulas, Line, explain
from .page import PageData, derivation_context
from .page_entries import REFERENCE_FILE, anchor

__all__ = [
    "REFERENCE_FILE",
    "PageData",
    "Formulas",
    "Line",
    "anchor",
    "derivation_context",
    "explain",
    "latex_name",
]
