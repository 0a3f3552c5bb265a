"""Vector widths of scenes of one's own: most tests have one lane, which compiles soonest."""

from __future__ import annotations

import inspect
from functools import wraps

import pytest

import hoopgen
from hoopgen.scene import compilers
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import EFFORT


@wraps(compilers.processor_width)
def one_lane() -> int:
    """Return the least width."""
    return 1


def compiled_as_for_users(scene: hoopgen.Scene) -> Engine:
    """Compile a scene for the processor's width; below effort 1 for one lane.

    Parameters
    ----------
    scene
        A scene whose C engine is compared with something else.
    """
    with pytest.MonkeyPatch.context() as patch:
        if EFFORT >= 1:
            width = inspect.unwrap(compilers.processor_width)
            patch.setattr(compilers, "processor_width", width)
        return hoopgen.compile(scene)
