"""How the next contact is found: a search for each kind of surface."""

from __future__ import annotations

from .chosen import approach, search

__all__ = ["approach", "search"]
