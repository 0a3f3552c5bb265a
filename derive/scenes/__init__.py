"""The scenes that kernels are generated for."""

from __future__ import annotations

from .court import COURT
from .hoop import HOOP

SCENES = (HOOP, COURT)

__all__ = ["COURT", "HOOP", "SCENES"]
