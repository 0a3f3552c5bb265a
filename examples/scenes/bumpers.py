"""Bumpers: a ball falls between four walls and bounces off spheres and a bar.

A scene in Python is code: run only code that you trust. A scene file is data.
"""

from __future__ import annotations

from hoopgen.scene import Cylinder, End, Parameter, Plane, Scene, Sphere

SPHERES = [(0.2 * x, 0.2 * y, 0.3 * x * y - z) for z in (0, 1) for x in (-1, 1) for y in (-1, 1)]

SCENE = Scene(
    "bumpers",
    parameters=[
        Parameter("ball_radius", 0.04, summary="radius of the ball"),
        Parameter("half_width", 0.4, summary="half the width of the box"),
        Parameter("bumper", 0.17, summary="radius of each sphere"),
        Parameter("lively", 0.9, "1", "restitution of spheres and bar"),
        Parameter("dull", 0.6, "1", "restitution of the walls"),
        Parameter("gravity", 9.81, "m/s²", "acceleration of free fall"),
    ],
    ball_radius="ball_radius",
    gravity="gravity",
    restitution="lively",
    bodies=[
        *(
            Plane(f"wall_{side}", axis=axis, at="-half_width", restitution="dull")
            for side, axis in zip("abcd", ("x", "-x", "y", "-y"), strict=True)
        ),
        *(
            Sphere(f"bumper_{k}", radius="bumper", centre=centre)
            for k, centre in enumerate(SPHERES, start=1)
        ),
        Cylinder("bar", radius=0.08, centre=(0, 0, -0.5), axis="y"),
    ],
    ends={"left": End(at=-2, within=["x"]), "right": End(at=-2)},
    axes="The origin is the middle of the box, z points up.",
)
