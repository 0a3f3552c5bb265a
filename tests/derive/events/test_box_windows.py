"""The windows of a box as they are computed: wide enough for true flights, by the lemma's counts.

Errors of the state are as large as are not lost, and flights come from as far.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.events.box_windows import RELATIVE_INFLATION, lost, windows
from hoopgen.derive.symbolic.symbols import POSITION, VELOCITY
from mpmath import mpf
from numpy.typing import NDArray

from tests.derive.test_evaluation import digits, in_doubles, quadratic
from tests.helpers.effort import occurrences, trials
from tests.helpers.scenes.block import BLOCK

BOX = BLOCK.surfaces[1]
FALL = BLOCK.flight.acceleration
STATE = ("x", "y", "z", "vx", "vy", "vz")
CORNERS = (("from_x", "from_y", "from_z"), ("to_x", "to_y", "to_z"))
G = 9.81
Columns = dict[str, Any]


def flights(count: int, seed: int, farthest: float) -> Columns:
    """Return random boxes with flights that come to them or near, from at most so far."""
    random = np.random.default_rng(seed)
    half = 10 ** random.uniform(-2, 0.5, (3, count))
    radius = 10 ** random.uniform(-2, -0.5, count)
    far = 10 ** random.uniform(-3, farthest, count)
    # Some boxes are far away themselves, and the flights are short.
    away = random.random(count) < 0.3
    far = np.where(away, 10 ** random.uniform(farthest - 1.5, farthest, count), far)
    centre = random.uniform(-1, 1, (3, count)) * far
    centre *= np.where(away, 1, 10 ** random.uniform(-3, 0, count))
    velocity = random.normal(0, 1, (3, count)) * 10 ** random.uniform(-2, 1.5, count)
    velocity *= random.random((3, count)) < 0.85
    time = far / 10 ** random.uniform(-2, 1.5, count)
    time = np.where(away, random.random(count), time)
    place = centre + (half + radius) * random.uniform(-1.3, 1.3, (3, count)) - velocity * time
    place[2] -= G * time**2 / 2
    velocity[2] += G * time
    corners = dict(zip(CORNERS[0] + CORNERS[1], (*(centre - half), *(centre + half)), strict=True))
    values: Columns = dict(zip(STATE, (*place, *velocity), strict=True)) | corners
    values |= {"ball_radius": radius, "gravity": np.full(count, G), "horizon": np.inf}
    values |= {"extent": np.abs(place).sum(axis=0), "speed": np.abs(velocity).sum(axis=0)}
    return values


def errors_at_the_limit(values: Columns, seed: int) -> tuple[Columns, NDArray[np.float64]]:
    """Return the flights that are not lost, with errors of the state that nearly are, (6, n)."""
    random = np.random.default_rng(seed)
    verdict = {"lost": lost(BOX.reference_point, BOX.half_sizes, FALL)}
    least, one = (
        in_doubles(verdict, values | {"position_error": 0.0, "velocity_error": e})["lost"]
        for e in (0.0, 1.0)
    )
    kept = np.flatnonzero(least < 0)
    values = {name: v[kept] if np.ndim(v) else v for name, v in values.items()}
    left, latest = -0.999 * least[kept], np.maximum(one - least, 1e-30)[kept]
    share = random.choice([0, 1, 0.5], len(kept))
    signs = random.choice([-1, 1], (6, len(kept)))
    size = np.array([left * share] * 3 + [left * (1 - share) / latest] * 3)
    return values, signs * size


def near(state: list[mpf], box: list[tuple[mpf, mpf]], g: mpf) -> list[tuple[mpf, mpf]]:
    """Return the intervals of time in which a true ball is in a box, given its faces."""
    times: list[mpf] = []
    for k, sides in enumerate(box):
        pull = -g / 2 if k == 2 else mpf(0)
        for side in sides:
            times += quadratic(pull, state[3 + k], state[k] - side)
    times = sorted(t for t in times if t > 0)
    if not times:
        return []

    def inside(t: mpf) -> bool:
        there = [state[k] + state[3 + k] * t - (g * t**2 / 2 if k == 2 else 0) for k in range(3)]
        return all(low <= p <= high for p, (low, high) in zip(there, box, strict=True))

    spans = [(mpf(0), times[0]), *pairwise(times)]
    return [span for span in spans if inside((span[0] + span[1]) / 2)]


@pytest.mark.parametrize("farthest", [1.5, 12.0])
def test_the_windows_of_a_computed_flight_hold_the_true_one_in_the_box(farthest: float) -> None:
    """No time in the box is at an edge of a window."""
    values, errors = errors_at_the_limit(flights(trials(1500), 70, farthest), 71)
    count = len(values["x"])
    axes = [
        (p - c, v, a)
        for p, c, v, a in zip(POSITION, BOX.reference_point, VELOCITY, FALL, strict=True)
    ]
    spans = [
        np.broadcast_arrays(*in_doubles({"a": a, "b": b}, values).values(), np.zeros(count))[:2]
        for a, b in windows(axes, BOX.half_sizes)
    ]
    seen = 0
    with digits(40):
        for row in range(count):
            state = [
                mpf(float(values[n][row])) + mpf(float(errors[k, row])) for k, n in enumerate(STATE)
            ]
            radius = mpf(float(values["ball_radius"][row]))
            box = [
                (mpf(float(values[a][row])) - radius, mpf(float(values[b][row])) + radius)
                for a, b in zip(*CORNERS, strict=True)
            ]
            for begin, end in near(state, box, mpf(G)):
                seen += 1
                assert any(
                    (low[row] < begin or low[row] <= begin == 0) and end < high[row]
                    for low, high in spans
                ), row
    assert seen > occurrences(400 if farthest < 2 else 150)


@pytest.mark.parametrize("axis", [0, 2], ids=["straight", "falling"])
def test_at_the_edges_of_windows_the_ball_is_where_they_are_but_for_the_counted_roundings(
    axis: int,
) -> None:
    """The counts of the lemma: 8 u v²/g + 20 u of the lengths, the share of `lost` being 32 u."""
    values = flights(trials(400), 72, 6.0)
    count = len(values["x"])
    halves = [h if k == axis else None for k, h in enumerate(BOX.half_sizes)]
    axes = [
        (p - c, v, a)
        for p, c, v, a in zip(POSITION, BOX.reference_point, VELOCITY, FALL, strict=True)
    ]
    edges = [
        in_doubles({"edge": edge}, values)["edge"]
        for span in windows(axes, halves)
        for edge in span
    ]
    wider, reached, unit = float(RELATIVE_INFLATION), 0.0, 2.0**-53
    with digits(40):
        for row in range(count):
            own = {n: mpf(float(v[row])) if np.ndim(v) else mpf(v) for n, v in values.items()}
            low, high = (own[names[axis]] for names in CORNERS)
            centre, half = (low + high) / 2, (high - low) / 2 + own["ball_radius"]
            length = sum(abs(own[n]) for n in "xyz") + abs(centre) + half
            counted = unit * 20 * length
            speed = sum(abs(own[f"v{n}"]) for n in "xyz")
            counted += unit * 8 * speed**2 / G if axis == 2 else 0
            for edge in edges:
                time = mpf(float(np.broadcast_to(edge, count)[row]))
                if not 0 < time < 1e12:
                    continue
                name = "xyz"[axis]
                there = own[name] + own[f"v{name}"] * time - (G * time**2 / 2 if axis == 2 else 0)
                off = abs(there - centre) - half * (1 + wider)
                # A window that reaches over the apex ends where the ball is at the bottom.
                reached = max(reached, abs(off) / counted)
    assert 0.015 < reached <= 1, reached
