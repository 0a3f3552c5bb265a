"""Examples in the help of commands: apart, since `generate` stands on nothing that is generated."""

from __future__ import annotations

__all__ = ["examples"]


def examples(*lines: str) -> str:
    """Lay out example lines for the end of a command's help."""
    return "\b\nExamples:\n" + "\n".join(f"  {line}" for line in lines)
