"""The derivation, as a reader would want it: what generated/derivation.md says."""

from __future__ import annotations

from hoopgen.derive.model import Model


def derivation_context(model: Model) -> dict[str, str]:
    """Return what the template of derivation.md shows."""
    return {"name": model.scene.name}
