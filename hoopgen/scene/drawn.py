"""A scene as the pieces that it is drawn from: those its author wrote, or those of `COURT`."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from .pieces import Body, Box, End, Parameter, Torus
from .scene import Scene

if TYPE_CHECKING:
    from hoopgen.engines import Engine

__all__ = ["drawn"]


def drawn(engine: Engine) -> Scene:
    """Return the pieces of a scene.

    Raises
    ------
    ValueError
        If it has none.
    """
    written = engine.table.written
    if isinstance(written, Scene):
        return written
    from hoopgen.court import COURT  # whose kernels are many

    if engine is COURT:
        return _court()
    raise ValueError(
        f"scene: {engine.name} is written for derivation; drawn are the hoop, and scenes "
        "of the pieces of hoopgen.scene"
    )


@cache
def _court() -> Scene:
    """Return the bodies of `COURT`, as large as it has them; its contacts are not drawn."""
    from hoopgen.generated.numpy import court

    front, bottom, top = "board_distance", "board_bottom", "board_top"
    bodies: tuple[Body, ...] = (
        Torus("ring", radius="ring_radius", wire="wire_radius"),
        Box(
            "backboard",
            size=("board_thickness", "2*board_half_width", f"{top} - {bottom}"),
            centre=(f"-{front} - board_thickness/2", 0, f"({top} + {bottom})/2"),
        ),
        Box(
            "bridge",
            size=(f"{front} - ring_radius", "2*bridge_half_width", "bridge_depth"),
            centre=(f"-({front} + ring_radius)/2", 0, "wire_radius - bridge_depth/2"),
        ),
    )
    within = "x**2 + y**2 - ring_radius**2"
    return Scene(
        court.SCENE,
        parameters=[
            Parameter(name, default, unit, summary, sign="any", infinite=default == float("inf"))
            for name, (default, unit, summary) in court.PARAMETERS.items()
        ],
        ball_radius="ball_radius",
        gravity="gravity",
        restitution="ring_restitution",
        bodies=bodies,
        ends={"made": End(at="-end_depth", within=[within]), "missed": End(at="-end_depth")},
    )
