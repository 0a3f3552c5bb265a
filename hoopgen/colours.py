"""The colours of the hoop, in pictures and on pages."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

# Okabe and Ito's palette: told apart by readers with any colour vision, and in grey.
COLOURS: Mapping[str, str] = MappingProxyType(
    {
        "path": "#0072B2",
        "ball": "#E69F00",
        "ring": "#D55E00",
        "backboard": "#333333",
        "bridge": "#00795C",
        "end": "#8C4A76",
        "release": "#0072B2",
        "faint": "#8A8A8A",
        "paper": "#FFFFFF",
    }
)
