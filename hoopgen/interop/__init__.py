"""Doors to libraries of arrays: JAX."""

from __future__ import annotations

from . import jax as jax

__all__ = ["jax"]
