"""Elementary functions against 60 digits: within the units in the last place that they promise."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import pytest
from hoopgen.derive.elementary.angles import MAX_ANGLE
from mpmath import mp, mpf
from numpy.typing import NDArray

from hoopgen.engine import elementary
from tests.helpers.effort import trials

Floats = NDArray[np.float64]

COUNT = trials(20_000, at_least=2_000)


def units(computed: Floats, exact: Callable[..., mpf], *arguments: Floats) -> float:
    """Return the largest error in units in the last place of the exact value."""
    worst = mpf(0)
    with mp.workdps(60):
        for found, *given in zip(computed.tolist(), *(a.tolist() for a in arguments), strict=True):
            value = exact(*map(mpf, given))
            unit = mpf(2) ** (mp.frexp(value)[1] - 53)
            worst = max(worst, abs(mpf(found) - value) / unit if value else abs(mpf(found)))
    return float(worst)


def angles(seed: int) -> Floats:
    """Angles of all sizes, and doubles next to the multiples of an eighth of a turn."""
    random = np.random.default_rng(seed)
    eighths = random.integers(-(2**22), 2**22, COUNT // 4) * (np.pi / 4)
    near = np.concatenate([np.arange(-64, 65) * (np.pi / 4), eighths])
    near = near[np.abs(near) < float(MAX_ANGLE)]
    return np.concatenate(
        [
            random.uniform(-7.0, 7.0, COUNT),
            random.uniform(-float(MAX_ANGLE), float(MAX_ANGLE), COUNT // 4),
            10.0 ** random.uniform(-300.0, 0.0, COUNT // 8),
            near,
            np.nextafter(near, np.inf),
            np.nextafter(near, -np.inf),
        ]
    )


@pytest.mark.slow
def test_sine_and_cosine_are_within_one_unit() -> None:
    x = angles(1)
    sine, cosine = elementary.sine_cosine(x)
    assert units(sine, mp.sin, x) < 1.0
    assert units(cosine, mp.cos, x) < 1.0


def test_the_double_that_is_hardest_to_reduce_keeps_its_digits() -> None:
    """The doubles next to a multiple of π/2 are among the convergents of its continued fraction."""
    with mp.workdps(60):
        fraction, convergents, before, last = mp.pi / 2, [], (0, 1), (1, 0)
        for _ in range(40):
            whole = int(mp.floor(fraction))
            fraction = 1 / (fraction - whole)
            before, last = last, (whole * last[0] + before[0], whole * last[1] + before[1])
            convergents.append(last)
    x = np.array([float(p) * 2.0**-k for p, q in convergents for k in range(60) if p])
    x = x[(np.abs(x) < float(MAX_ANGLE)) & (x > 1e-3)]
    assert units(elementary.sine_cosine(x)[0], mp.sin, x) < 1.0


def test_the_tangent_is_within_four_units() -> None:
    x = angles(2)
    assert units(elementary.tangent(x), mp.tan, x) < 4.0


def points(seed: int) -> tuple[Floats, Floats]:
    """Points in all directions, some near the axes and where the series changes."""
    random = np.random.default_rng(seed)
    ordinate, abscissa = random.normal(size=(2, COUNT))
    ordinate[: COUNT // 4] *= 10.0 ** random.uniform(-30.0, 30.0, COUNT // 4)
    edges = random.choice([0.25, 0.75, 1.0, 4.0, 4.0 / 3.0], COUNT // 4)
    ordinate[-len(edges) :] = abscissa[-len(edges) :] * edges
    ordinate[-len(edges) :] = np.nextafter(ordinate[-len(edges) :], random.normal(size=len(edges)))
    return ordinate, abscissa


def test_the_arc_tangent_is_within_two_units() -> None:
    ordinate, abscissa = points(3)
    assert units(elementary.arc_tangent(ordinate, abscissa), mp.atan2, ordinate, abscissa) < 2.0


def test_the_arc_tangent_has_the_angles_of_the_axes() -> None:
    found = elementary.arc_tangent([0.0, 1.0, 0.0, -1.0, 0.0], [1.0, 0.0, -1.0, 0.0, 0.0])
    assert found.tolist() == [0.0, np.pi / 2, np.pi, -np.pi / 2, 0.0]


def test_the_hypotenuse_is_within_one_unit() -> None:
    ordinate, abscissa = points(4)
    assert units(elementary.hypotenuse(ordinate, abscissa), mp.hypot, ordinate, abscissa) < 1.0


def quantile(probability: mpf) -> mpf:
    """Return the normal quantile to many digits."""
    return mp.sqrt(2) * mp.erfinv(2 * probability - 1)


def probabilities(count: int, seed: int) -> Floats:
    """Odd multiples of 2^-53, as random numbers are: from everywhere and from both tails."""
    random = np.random.default_rng(seed)
    tails = 2.0 ** -random.uniform(0.0, 52.0, count // 4)
    values = np.concatenate([random.random(count), tails, 1.0 - tails])
    words = np.clip(np.floor(values * 2.0**52), 0.0, 2.0**52 - 1.0)
    return np.concatenate([(words + 0.5) * 2.0**-52, [2.0**-53, 1.0 - 2.0**-53, 0.5]])


def test_the_normal_quantile_is_within_six_units() -> None:
    given = probabilities(COUNT // 20, 5)
    assert units(elementary.normal_quantile(given), quantile, given) < 6.0


def test_the_normal_quantile_is_odd_about_one_half() -> None:
    given = probabilities(COUNT, 6)
    assert (elementary.normal_quantile(1.0 - given) == -elementary.normal_quantile(given)).all()


@pytest.mark.parametrize(
    ("function", "arguments"),
    [
        (elementary.sine_cosine, [np.nan]),
        (elementary.tangent, [np.nan]),
        (elementary.arc_tangent, [np.nan, 1.0]),
        (elementary.arc_tangent, [1.0, np.nan]),
        (elementary.hypotenuse, [np.nan, 1.0]),
        (elementary.hypotenuse, [1.0, np.nan]),
        (elementary.normal_quantile, [np.nan]),
    ],
)
def test_of_what_is_no_number_there_is_none(
    function: Callable[..., Floats], arguments: Sequence[float]
) -> None:
    assert np.isnan(function(*arguments)).all()


def test_an_angle_that_is_too_large_is_infinite() -> None:
    largest = float(MAX_ANGLE)
    assert np.isfinite(elementary.sine_cosine([largest, -largest])).all()
    assert np.isinf(
        elementary.sine_cosine(np.nextafter([largest, -largest], [np.inf, -np.inf]))
    ).all()
