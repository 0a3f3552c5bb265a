"""A ball that starts on a body, as `derive.rolling.start` puts it there."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb

from .arrivals import holds
from .formulas import Formulas, SurfaceFormulas
from .pieces import next_piece
from .roots import Undecided, sign
from .taylor_model import Number, polynomial

DEPARTS = 3
"""The number of low coefficients of the event polynomial that vanish if the contact of a ball ends
where it starts: the third does to roundings alone, and is not divided out."""


def left_by(formulas: Formulas, state: list[Number], values: list[arb], leaving: int) -> int:
    """Return the surface that the ball leaves: of the parts of a body, the nearest in its bounds.

    Parameters
    ----------
    formulas
        The formulas of the scene.
    state
        The state, nine balls.
    values
        The kernels' inputs.
    leaving
        The body that the ball leaves, or -1.
    """
    own = [k for k, surface in enumerate(formulas.surfaces) if surface.body == leaving]
    within = [
        k
        for k in own
        if any(holds(p, state, values) is not False for p in formulas.surfaces[k].patches)
    ]

    def away(k: int) -> float:
        return abs(float(formulas.surfaces[k].distance(state, values)[0].mid()))

    return min(within or own, key=away, default=-1)


def put_on(
    formulas: Formulas, surface: SurfaceFormulas, state: list[Number], values: list[arb]
) -> tuple[list[Number], int]:
    """Return the state of a ball that starts on a surface, and how it moves off the surface.

    Parameters
    ----------
    formulas
        The formulas of the scene.
    surface
        The surface, which a ball may roll on.
    state
        The release, nine balls.
    values
        The kernels' inputs.

    Returns
    -------
    tuple
        The state, on the surface, with a velocity along it if it is so to roundings; and the number
        of low coefficients of the event polynomial that vanish, or `DEPARTS`.

    Raises
    ------
    Undecided
        If it is undecided whether the speed or the force along the normal is one of roundings.
    """
    assert formulas.start is not None
    normal = surface.normal(state, values)
    off = surface.distance(state, values)[0] / sum((n * n for n in normal), arb(0)).sqrt()
    place = [p - off * n for p, n in zip(state[:3], normal, strict=True)]
    if surface.axis >= 0:
        place[surface.axis] = surface.offset(values)[0]
    there = place + state[3:]
    speed_limit, force_limit = formulas.start(there, values)
    normal = surface.normal(there, values)
    outward = sum((v * n for v, n in zip(state[3:6], normal, strict=True)), arb(0))
    if not _is_small(outward, speed_limit, f"whether the ball moves along the {surface.name}"):
        return there, 1
    along = [v - outward * n for v, n in zip(state[3:6], normal, strict=True)]
    if surface.axis >= 0:
        along[surface.axis] = arb(0)
    there = place + along + state[6:]
    if surface.flat and formulas.air is None:
        return there, 2
    scale = _along(surface, [polynomial(pair) for pair in zip(place, normal, strict=True)], values)
    path = next_piece(formulas, there, values).path
    force, rate = (
        k * c / scale[1] for k, c in zip((2, 6), _along(surface, path, values)[2:], strict=True)
    )
    question = f"whether anything presses the ball onto the {surface.name}"
    if not _is_small(force, force_limit, question):
        return there, 2
    opens = sign(rate)
    if opens is None:
        raise Undecided(question)
    return there, DEPARTS if opens > 0 else 2


def _along(surface: SurfaceFormulas, path: Sequence[Number], values: list[arb]) -> list[Number]:
    """Return the first four coefficients of the event polynomial along a path."""
    found = surface.condition(path, values)[0].coeffs()
    return [*found, *[arb(0)] * 4][:4]


def _is_small(number: Number, limit: Number, question: str) -> bool:
    """Return whether a number is at most as large as a limit; `question` says what that decides."""
    if abs(number) <= limit:
        return True
    if abs(number) > limit:
        return False
    raise Undecided(question)
