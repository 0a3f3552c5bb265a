"""Scenes turned on their side, free fall with them: other axes, the same motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import sympy as sp
from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.scene import Scene, parameter
from hoopgen.derive.surfaces import Plane, Ring, Sphere, Surface, body
from hoopgen.derive.symbolic.symbols import POSITION
from numpy.typing import NDArray

Turn = tuple[tuple[int, int, int], tuple[int, int, int], tuple[int, int, int]]
"""Rows of a rotation that takes axes to axes."""

DOWN_Y: Turn = ((0, 1, 0), (0, 0, 1), (1, 0, 0))
"""A turn that takes a fall along -z to one along -y."""

ALONG_X: Turn = ((0, 0, -1), (0, 1, 0), (1, 0, 0))
"""A turn that takes a fall along -z to one along +x."""


def turned(scene: Scene, name: str, turn: Turn) -> Scene:
    """Return a scene of planes and spheres with everything turned, under a name of its own."""
    back = dict(zip(POSITION, sp.Matrix(turn).T * sp.Matrix(POSITION), strict=True))

    def there(vector: Sequence[sp.Expr | int]) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        x, y, z = sp.Matrix(turn) * sp.Matrix(list(vector))
        return x, y, z

    def moved(face: Surface) -> Surface:
        assert isinstance(face, Plane | Sphere)
        limits = tuple(g.xreplace(back) for g in face.limits)
        if isinstance(face, Sphere):
            return replace(face, centre=there(face.centre), limits=limits)
        x, y, z = map(int, there(face.direction))
        return replace(face, direction=(x, y, z), limits=limits)

    def crossed(end: End) -> End:
        plane = moved(end.plane)
        assert isinstance(plane, Plane)
        return replace(end, plane=plane)

    x, y, z = map(int, there(scene.gravity_axis))
    return replace(
        scene,
        name=name,
        bodies=tuple(replace(b, faces=tuple(map(moved, b.faces))) for b in scene.bodies),
        ends=tuple(map(crossed, scene.ends)),
        gravity_axis=(x, y, z),
    )


def turned_states(states: NDArray[np.float64], turn: Turn) -> NDArray[np.float64]:
    """Return positions, velocities and spins turned; every number stays the same but for a sign."""
    vectors = states.reshape(-1, 3, 3)
    return np.einsum("ij,nkj->nki", np.array(turn, float), vectors).reshape(-1, 9)


_WHEEL = (
    parameter("ball", "m", "radius of the ball", 0.1),
    parameter("radius", "m", "of the wheel's rim", 0.4),
    parameter("rim", "m", "radius of the rim's wire", 0.05),
    parameter("bounce", "1", "restitution", 0.8, "nonnegative", 1),
    parameter("gravity", "m/s²", "g", 9.81),
    parameter("drop", "m", "from the axle to where a shot ends", 1.5),
)


def _wheel() -> Scene:
    ball, radius, rim, bounce, gravity, drop = (p.symbol for p in _WHEEL)
    _, y, z = POSITION
    ground = Plane("ground", (-1, 0, 0), -drop, sp.Integer(0))
    inside = sp.sqrt(y**2 + z**2) - radius
    return Scene(
        name="wheel",
        parameters=_WHEEL,
        bodies=(body(Ring("wheel", radius, ball + rim), NoSlip("impact", bounce)),),
        ends=(End("made", replace(ground, limits=(inside,))), End("missed", ground)),
        ball_radius=ball,
        gravity=gravity,
        requirements=(radius - ball - rim,),
        gravity_axis=(1, 0, 0),
    )


WHEEL = _wheel()
"""A ring that stands upright: its axis lies across free fall, which is along +x."""
