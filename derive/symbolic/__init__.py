"""Symbols, conditions, polynomials and rounding bounds, in which the rest of derive/ is written."""
