"""Task 1 of diff_sim_grads by time steps, differentiated exactly as a program.

The release has an imaginary part of 1e-30 (the complex step), so that the derivative is that of
the program, to rounding, as a tape would give it.
"""

from __future__ import annotations

TINY = 1e-30


def height_after_steps(
    z: complex, v: complex, *, impact_time: bool, steps: int = 480, radius: float = 0.1
) -> complex:
    """Return the height after 1 s without gravity, for a ball that loses no speed at the floor.

    With `impact_time` the step of the contact is divided at the time of impact.
    """
    step = 1.0 / steps
    for _ in range(steps):
        ahead = z + step * v
        if ahead.real < radius and v.real < 0:
            before = (radius - z) / v if impact_time else 0.0
            z, v = z + before * v - (step - before) * v, -v
        else:
            z = ahead
    return z


def slopes_of_steps(impact_time: bool) -> tuple[float, float]:
    """Return the derivatives of the height by z and by v at the release of task 1."""
    by_z = height_after_steps(1 + TINY * 1j, -2.0 + 0j, impact_time=impact_time)
    by_v = height_after_steps(1 + 0j, -2.0 + TINY * 1j, impact_time=impact_time)
    return by_z.imag / TINY, by_v.imag / TINY
