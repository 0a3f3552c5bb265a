"""The windows of the ring, and its margins, as they are computed: wide enough for true flights."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hoopgen.derive.events.registry import root_finder_for
from hoopgen.derive.events.ring.double import RingRootFinder
from hoopgen.derive.events.root_finder import RootFinder
from hoopgen.derive.scenes import HOOP
from hoopgen.generated.numpy import court
from mpmath import mpf
from numpy.typing import NDArray

from tests.derive.test_evaluation import PARAMETERS, Path, digits, in_doubles
from tests.helpers.effort import occurrences, trials

FINDER: RootFinder = root_finder_for(HOOP.surfaces[0], HOOP.flight)
assert isinstance(FINDER, RingRootFinder)
STATE = ("x", "y", "z", "vx", "vy", "vz")
REACH = PARAMETERS["ball_radius"] + PARAMETERS["wire_radius"]
SLACK = mpf(1) + mpf(2) ** -10
"""The factor of a margin for the roundings of its own evaluation."""


def _called(name: str, values: dict[str, Any]) -> dict[str, Any]:
    """Return the outputs of a kernel in its own precision."""
    given = {**values, **{f"p_{n}": v for n, v in PARAMETERS.items()}}
    with np.errstate(all="ignore"):
        found = getattr(court, name)(*(np.asarray(given[n])[()] for n in court.ARGUMENTS[name]))
    return dict(zip(court.OUTPUTS[name], found, strict=True))


def flights(count: int) -> tuple[dict[str, Any], NDArray[np.float64]]:
    """Return flights that come near the ring, and for how long errors grow."""
    rng = np.random.default_rng(60)
    about, around = rng.uniform(0, 2 * np.pi, (2, count))
    away = REACH * np.sqrt(rng.uniform(0, 2, count))
    rho = PARAMETERS["ring_radius"] + away * np.cos(about)
    place = np.array([rho * np.cos(around), rho * np.sin(around), away * np.sin(about)])
    velocity = rng.normal(0, 1, (3, count)) * 10 ** rng.uniform(-3, 1, count)
    # Fast, slow and hardly any motion sideways, and along an axis.
    velocity[:2] *= 10.0 ** -rng.choice([0, 0, 3, 8], count)
    velocity[1] *= rng.random(count) < 0.9
    # From far above and below, where roundings of the heights count.
    back, g = 10 ** rng.uniform(-4, 0.8, count), PARAMETERS["gravity"]
    start = place - velocity * back
    start[2] -= g * back**2 / 2
    velocity[2] += g * back
    values: dict[str, Any] = dict(zip(STATE, (*start, *velocity), strict=True))
    values |= {"extent": np.abs(start).sum(axis=0), "speed": np.abs(velocity).sum(axis=0)}
    lasting = np.sqrt(2 * (values["extent"] + 2 * REACH) / g) + 2 * values["speed"] / g
    return values, lasting


@pytest.mark.parametrize("precision", ["single", "double"])
def test_the_windows_of_a_computed_flight_hold_the_true_one_near_the_ring(precision: str) -> None:
    """The true flight is off by as much as a search allows for."""
    count = trials(1500)
    values, lasting = flights(count)
    rng = np.random.default_rng(61)
    error = REACH * 2.0**-17 * rng.choice([-0.999, 0.999], (6, count))
    error[3:] /= lasting
    names = ("low1", "high1", "low2", "high2")
    if precision == "single":
        found = _called("ring_opened", {**values, "horizon": np.full(count, np.inf)})
        assert np.all(found["representable"])
        first = found["t"], found["end"]
    else:
        found = in_doubles(
            {
                f"{side}{k}": bound
                for k, window in enumerate(FINDER.windows)
                for side, bound in zip(("low", "high"), window, strict=True)
            },
            {**PARAMETERS, **values},
        )
        first = found["low0"], found["high0"]
    edges = [*first, *(found[name] for name in names)]
    seen = 0
    with digits(40):
        for row in range(count):
            true = {
                name: mpf(float(values[name][row])) + mpf(float(error[k, row]))
                for k, name in enumerate(STATE)
            }
            windows = [mpf(float(np.broadcast_to(e, count)[row])) for e in edges]
            pairs = list(zip(windows[::2], windows[1::2], strict=True))
            for start, end in Path({**PARAMETERS, **true}).near():
                if end > 0:
                    seen += 1
                    begin = max(start, mpf(0))
                    assert any(low <= begin and end <= high for low, high in pairs), row
    assert seen > occurrences(1000)


def test_margins_are_no_smaller_than_their_formulas() -> None:
    """Evaluated with roundings, each is at least the exact value of what it stands for."""
    count = trials(400)
    values, _ = flights(count)
    rng = np.random.default_rng(62)
    values |= {"horizon": 10 ** rng.uniform(-4, 0.3, count)}
    size = 2.0 ** -rng.choice([25, 40, 52], count)
    values |= {"position_error": size, "velocity_error": size * rng.choice([0, 1, 64], count)}
    names = ("margin", "leaving_margin", "rate_margin")
    assert isinstance(FINDER, RingRootFinder)
    margins = FINDER.margins
    found = in_doubles({name: margins[name] for name in names}, {**PARAMETERS, **values})
    zeros = dict.fromkeys(
        ("end", "leaving", "start_rate", "rho_rate", "low1", "low2"), np.zeros(count)
    )
    given = {**values, **zeros, "high1": np.zeros(count), "high2": np.zeros(count), "t": 0.0}
    short = _called("ring_resolution", given)
    with digits(40):
        for row in range(count):
            own = {n: float(v[row]) for n, v in values.items()}
            for name in names:
                ratio = mpf(float(found[name][row])) / _in_double(own)[name]
                assert 1 <= ratio <= SLACK**2, name
            for name, exact in _in_single(own).items():
                assert 1 <= mpf(float(short[name][row])) / exact <= SLACK**2, name


def _sizes(own: dict[str, float]) -> tuple[mpf, ...]:
    """Return R, the annulus's outer radius, max(1, R/I), T, and the sizes of the flight."""
    reach = mpf(PARAMETERS["ball_radius"]) + mpf(PARAMETERS["wire_radius"])
    radius, lasting = mpf(PARAMETERS["ring_radius"]), mpf(own["horizon"])
    wider = reach * (1 + mpf(2) ** -14)
    fastest = mpf(own["speed"]) + mpf(PARAMETERS["gravity"]) * lasting
    furthest = mpf(own["extent"]) + lasting * fastest
    return wider, radius + wider, max(mpf(1), wider / (radius - wider)), lasting, furthest, fastest


def _in_double(own: dict[str, float]) -> dict[str, mpf]:
    """Return the margins that `double.py` derives, without any slack."""
    reach, outer, stretch, lasting, furthest, fastest = _sizes(own)
    unit, moved = mpf(2) ** -53, mpf(own["velocity_error"])
    place = mpf(own["position_error"]) + moved * lasting + 4 * unit * furthest
    slope = 5 * (reach * (moved + 2 * unit * fastest) + stretch * fastest * place)
    steps = 4 * unit * reach * fastest
    return {
        "margin": 5 * reach * place + 12 * unit * reach * outer + steps * lasting,
        "leaving_margin": slope + 32 * unit * fastest * (stretch * furthest + outer) + steps,
        "rate_margin": slope + 32 * unit * outer * fastest,
    }


def _in_single(own: dict[str, float]) -> dict[str, mpf]:
    """Return the margins of F and F' that `single.py` derives, without any slack."""
    reach, outer, stretch, lasting, furthest, fastest = _sizes(own)
    share, unit = mpf(2) ** -25, mpf(2) ** -24
    dropped = mpf(PARAMETERS["gravity"]) * lasting**2
    place = share * furthest + 16 * unit * (outer + dropped)
    motion = (share + 4 * unit) * fastest
    reach /= 1 + mpf(2) ** -14
    return {
        "flat": 5 * reach * place,
        "rate_margin": 5 * (reach * motion + stretch * fastest * place) / (1 + mpf(2) ** -14),
    }
