"""Event detection: the search for the next contact, with a search for each kind of surface."""

from __future__ import annotations

from .registry import root_finder_for, search_for

__all__ = ["root_finder_for", "search_for"]
