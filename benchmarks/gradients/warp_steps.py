"""The step of the bouncing ball for Warp, which compiles the source of a module."""

import warp as wp


@wp.kernel
def advance(
    old: wp.array(dtype=wp.float64),
    later: wp.array(dtype=wp.float64),
    radius: wp.float64,
    restitution: wp.float64,
    gravity: wp.float64,
    step: wp.float64,
):
    """Advance height and velocity by one step of semi-implicit Euler; reflect below the floor."""
    v = old[1] - gravity * step
    z = old[0] + v * step
    if z < radius and v < wp.float64(0.0):
        later[1] = -restitution * v
        later[0] = old[0] - restitution * v * step
    else:
        later[1] = v
        later[0] = z
