"""The borders of meshes are those of what is drawn, however finely its parts are divided."""

from __future__ import annotations

import numpy as np
import pytest

from hoopgen.scene.mesh_lines import loops
from hoopgen.scene.meshes import flat


@pytest.mark.parametrize("middle", [0.0, 0.123])
def test_the_border_of_a_plane_with_a_hole_is_its_rectangle_and_its_circle(middle: float) -> None:
    """Cells near the hole are finer, so that their corners lie on the edges of others."""
    room = (np.array([-0.7, -0.3, -1.0]), np.array([0.9, 0.4, 1.0]))
    mesh = flat(
        2, 1, 0.0, room, 0.05, [lambda p: 0.04 - (p[..., 0] - middle) ** 2 - p[..., 1] ** 2]
    )
    lines = loops(mesh.corners[..., :3])
    lengths = [np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for line in lines]
    assert sorted(lengths) == pytest.approx([2 * np.pi * 0.2, 2 * (1.6 + 0.7)], rel=2e-3)
