"""The pieces from which a scene is drawn: its author's, or those of a hoop of hoopgen."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING

from .pieces import Body, Box, End, Parameter, Plane, Torus
from .scene import Scene

if TYPE_CHECKING:
    from hoopgen.engine.compiled_scene import CompiledScene


def scene_pieces(engine: CompiledScene) -> Scene:
    """Return the pieces of a scene.

    Raises
    ------
    ValueError
        If it has none.
    """
    written = engine.table.written
    if isinstance(written, Scene):
        return written
    from hoopgen.generated.numpy import court  # which has many kernels

    if engine.kernels is court or (engine.name == "court_air" and engine.has_hoop):
        return _court(engine)
    if engine.name == "air" and engine.has_hoop:
        return _hoop(engine.name, engine.kernels.PARAMETERS)
    raise ValueError(
        f"scene: {engine.name} is written for derivation; drawn are the hoop, and scenes "
        "of the pieces of hoopgen.scene"
    )


_WITHIN_RING = "x**2 + y**2 - ring_radius**2"


def _drawn(
    name: str, parameters: Mapping[str, tuple[float, str, str]], bodies: Sequence[Body]
) -> Scene:
    """Return a scene of a hoop, without laws of contact, which are not drawn."""
    return Scene(
        name,
        parameters=[
            Parameter(name, default, unit, summary, sign="any", infinite=default == float("inf"))
            for name, (default, unit, summary) in parameters.items()
        ],
        ball_radius="ball_radius",
        gravity="gravity",
        restitution="1",
        bodies=bodies,
        ends={"made": End(at="-end_depth", within=[_WITHIN_RING]), "missed": End(at="-end_depth")},
    )


def _hoop(name: str, parameters: Mapping[str, tuple[float, str, str]]) -> Scene:
    """Return the bodies of the article's hoop, of which only the upper sides are touched."""
    board = ["-y - board_half_width", "y - board_half_width", "board_bottom - z", "z - board_top"]
    bridge = ["-y - bridge_half_width", "y - bridge_half_width", "x + ring_radius"]
    bodies: tuple[Body, ...] = (
        Torus("ring", radius="ring_radius", wire="wire_radius"),
        Plane("backboard", axis="x", at="-board_distance", within=board),
        Plane("bridge", at="wire_radius", within=[*bridge, "-board_distance - x"]),
    )
    return _drawn(name, parameters, bodies)


@cache
def _court(engine: CompiledScene) -> Scene:
    """Return the bodies of a gym's hoop, without laws of contact, which are not drawn."""
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
    return _drawn(engine.name, engine.kernels.PARAMETERS, bodies)
