"""One of each body that stands in any direction: planes, discs, cylinders and cones."""

from __future__ import annotations

from hoopgen.scene import Cone, Cylinder, Disc, End, Parameter, Plane, Scene

LEANING = Scene(
    "leaning",
    parameters=[
        Parameter("ball", 0.05),
        Parameter("lean", 0.4, "1", sign="any"),
        Parameter("e", 0.8, "1"),
    ],
    ball_radius="ball",
    gravity=9.81,
    restitution="e",
    bodies=[
        Plane("ramp", normal=(0.3, "-lean", 2), point=(0, 0, -1)),
        Plane("leaf", normal={"tilt": "70deg", "towards": "25deg"}, at=-0.7, within=["z - lean"]),
        Cylinder("rod", radius=0.1, axis=("lean", 1, 0.3), centre=(0.1, 0.5, 0), span=(-0.4, 0.6)),
        Cylinder(
            "gutter",
            radius=0.3,
            axis=(1, "lean", 0.2),
            centre=(-0.1, -0.5, 0.2),
            span=(-0.6, 0.5),
            inside=True,
            within=["z + x/4 - lean/2"],
        ),
        Cone("spike", half_angle="25deg", axis=("lean", 0.1, -2), apex=(0.6, 0.5, 0.4)),
        Cone(
            "funnel",
            slope="1 + lean",
            axis=(0.2, 0.1, 1),
            apex=(0.6, -0.5, -0.4),
            span=(0.15, 0.4),
            inside=True,
        ),
        Disc("plate", radius=0.3, axis=("lean", -0.3, 1), centre=(-0.4, 0.4, -0.2)),
    ],
    ends={"low": End(at=-3)},
)
