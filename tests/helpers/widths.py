"""Vector widths of scenes of one's own: most tests have one lane, which compiles soonest."""

from __future__ import annotations

import inspect
from functools import wraps

import pytest

import hoopgen
from hoopgen.scene import compilers
from hoopgen.simulation.engine import Engine


@wraps(compilers.processor_width)
def one_lane() -> int:
    """Return the least width."""
    return 1


def compiled_as_for_users(scene: hoopgen.Scene) -> Engine:
    """Compile a scene for the processor's width.

    Parameters
    ----------
    scene
        A scene whose C engine is compared with something else.
    """
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(compilers, "processor_width", inspect.unwrap(compilers.processor_width))
        return hoopgen.compile(scene)
