"""The scenes that kernels are generated for."""

from __future__ import annotations

from .hoop import HOOP

SCENES = (HOOP,)

__all__ = ["HOOP", "SCENES"]
