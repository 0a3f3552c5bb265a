"""Derivatives through contacts, beside those of other programs and beside the truth."""
