"""The error budget of a search: errors up to it change no gap of the ring by more than a margin."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.events import event_polynomials, root_finder_for
from hoopgen.derive.events.predicates import KERNELS
from hoopgen.derive.events.ring.double import RingRootFinder
from hoopgen.derive.events.ring.single import SinglePrecisionRing
from hoopgen.derive.ir.kernel import Kernel
from hoopgen.derive.loop.predicates import kernels
from hoopgen.derive.scenes import HOOP
from mpmath import mp, mpf
from numpy.typing import NDArray

from tests.derive.test_evaluation import PARAMETERS, digits, in_doubles

Floats = NDArray[np.float64]

DOUBLE = root_finder_for(HOOP.surfaces[0], HOOP.flight)
assert isinstance(DOUBLE, RingRootFinder)
SINGLE = SinglePrecisionRing(DOUBLE.flight, DOUBLE.ring)
PLACE, VELOCITY = ("x", "y", "z"), ("vx", "vy", "vz")
UNIT = 2.0**-24
"""The unit roundoff of single precision."""
LEAST = {
    "double": {"margin": 0.75, "leaving_margin": 0.5, "rate_margin": 0.75},
    "single": {"margin": 0.7, "leaving_margin": 0.5, "rate_margin": 0.2},
}
"""The largest change of many is at least this much of its margin."""
SHOTS = 400


def flights(count: int) -> dict[str, Any]:
    """Return flights with a time at which the ball is near the ring, just before the horizon.

    Half of them begin on the ring. The horizon and the share of the budget have many sizes.
    """
    rng = np.random.default_rng(31)
    radius = PARAMETERS["ring_radius"]
    reach = PARAMETERS["ball_radius"] + PARAMETERS["wire_radius"]
    gravity = PARAMETERS["gravity"]
    count *= 8
    about, around = rng.uniform(0, 2 * np.pi, (2, count))
    leaving = np.arange(count) % 2 == 1
    away = reach * np.where(leaving, 1.0, rng.uniform(0.9, 1.4, count))
    rho = radius + away * np.cos(about)
    place = np.stack([rho * np.cos(around), rho * np.sin(around), away * np.sin(about)])
    axes = rng.random((3, count)) < 0.5
    velocity = rng.normal(0, 1, (3, count)) * 10 ** rng.uniform(-2, 1, count) * axes
    time = 10 ** rng.uniform(-5, 0, count)
    back = np.where(leaving, 0.0, time)
    place -= velocity * back
    place[2] -= gravity * back**2 / 2
    velocity[2] += gravity * back
    there = place + velocity * time
    there[2] -= gravity * time**2 / 2
    off = np.abs([np.hypot(*there[:2]) - radius, there[2]]).max(axis=0)
    near = np.flatnonzero(off <= reach)[: count // 8]
    place, velocity, time = place[:, near], velocity[:, near], time[near]
    values = PARAMETERS | dict(zip(PLACE + VELOCITY, (*place, *velocity), strict=True))
    values |= {"t": time, "horizon": time * rng.uniform(1, 1.05, len(near))}
    values["extent"], values["speed"] = np.abs(place).sum(axis=0), np.abs(velocity).sum(axis=0)
    values["share"] = 2.0 ** -rng.choice([25, 25, 30, 45], len(near))
    return values | {"leaving": leaving[near].astype(float)}


def at_the_limit(finder: RingRootFinder, values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the flights with errors of which the excess is hardly below zero.

    They are errors of the place alone, of the velocity alone, and of both.
    """
    count = len(values["t"])
    rng = np.random.default_rng(32)
    part = rng.choice([0.0, 1.0, -1.0], count)
    part = np.where(part < 0, rng.random(count), part)
    fastest = values["speed"] + PARAMETERS["gravity"] * values["horizon"]
    furthest = values["extent"] + values["horizon"] * fastest
    sizes = part * furthest, (1 - part) * np.maximum(fastest, furthest)
    low, high, excess = np.zeros(count), np.ones(count), {"excess": finder.excess}
    for _ in range(80):
        middle = (low + high) / 2
        errors = {"position_error": middle * sizes[0], "velocity_error": middle * sizes[1]}
        over = in_doubles(excess, {**values, **errors})["excess"] > 0
        low, high = np.where(over, low, middle), np.where(over, middle, high)
    assert np.all(low > 0)
    assert np.all(high < 1)
    return {**values, "position_error": low * sizes[0], "velocity_error": low * sizes[1]}


def changes(shot: Mapping[str, float]) -> dict[str, mpf]:
    """Return the largest changes of F, F/t and F' by errors of such sizes, each with its signs."""
    t, state = mpf(shot["t"]), [mpf(shot[name]) for name in PLACE + VELOCITY]
    sizes = [mpf(shot["position_error"])] * 3 + [mpf(shot["velocity_error"])] * 3
    quantities = {
        "margin": lambda s: _gaps(shot, s, t)[0],
        "leaving_margin": lambda s: (_gaps(shot, s, t)[0] - _gaps(shot, s, mpf(0))[0]) / t,
        "rate_margin": lambda s: _gaps(shot, s, t)[1],
    }
    found = {}
    for name, quantity in quantities.items():
        now, moved = quantity(state), list(state)
        for k, size in enumerate(sizes):
            one = list(state)
            one[k] += size
            moved[k] += size if quantity(one) > now else -size
        found[name] = abs(quantity(moved) - now)
    return found


def _gaps(shot: Mapping[str, float], state: list[mpf], t: mpf) -> tuple[mpf, mpf]:
    """Return F and F' after a flight."""
    x, y, z, vx, vy, vz = state
    gravity, radius = mpf(shot["gravity"]), mpf(shot["ring_radius"])
    px, py, pz, fall = x + vx * t, y + vy * t, z + vz * t - gravity * t**2 / 2, vz - gravity * t
    rho = mp.sqrt(px**2 + py**2)
    reach = mpf(shot["ball_radius"]) + mpf(shot["wire_radius"])
    gap = (rho - radius) ** 2 + pz**2 - reach**2
    return gap, 2 * ((rho - radius) * (px * vx + py * vy) / rho + pz * fall)


def _sizes(values: Mapping[str, Any]) -> tuple[Floats, Floats]:
    """Return the sizes of a flight and of its velocity until the horizon."""
    fastest = values["speed"] + values["gravity"] * values["horizon"]
    return values["extent"] + values["horizon"] * fastest, fastest


def _allowed_in_double(values: Mapping[str, Any]) -> dict[str, Floats]:
    """Return the margins less those of exact states: what is left for errors of the state."""
    names = ("position_error", "velocity_error")
    levels = {n: values["share"] * s for n, s in zip(names, _sizes(values), strict=True)}
    whole = in_doubles(DOUBLE.margins, {**values, **levels})
    exact = in_doubles(DOUBLE.margins, {**values, **dict.fromkeys(names, 0.0)})
    return {name: margin - exact[name] for name, margin in whole.items()}


def _allowed_in_single(values: Mapping[str, Any]) -> dict[str, Floats]:
    """Return the margins less the roundings that are counted at the head of `single.py`."""
    reach = values["ball_radius"] + values["wire_radius"]
    inner, outer = in_doubles(dict(zip("io", SINGLE.radii(), strict=True)), values).values()
    furthest, fastest = _sizes(values)
    turn = np.maximum(1, reach / inner) * fastest
    # Of the rate, what the place's own roundings leave is for its roundings, 32 v A |v|.
    place = values["share"] * furthest + 1.5 * UNIT * outer
    return {
        "margin": 5 * reach * place,
        "leaving_margin": 5 * values["share"] * (reach * fastest + turn * furthest),
        "rate_margin": 5 * (reach * values["share"] * fastest + turn * place),
    }


@pytest.mark.slow
@pytest.mark.parametrize("precision", ["double", "single"])
def test_errors_within_the_budget_change_no_gap_by_more_than_its_margin(precision: str) -> None:
    """The largest changes come near to the margins, so that a wider budget would exceed them."""
    finder = DOUBLE if precision == "double" else SINGLE
    allowed = _allowed_in_double if precision == "double" else _allowed_in_single
    values = at_the_limit(finder, flights(SHOTS))
    most = allowed(values)
    largest = dict.fromkeys(LEAST[precision], mpf(0))
    with digits(40):
        for k in range(len(values["t"])):
            shot = {n: float(v if np.ndim(v) == 0 else v[k]) for n, v in values.items()}
            for name, change in changes(shot).items():
                if name != "leaving_margin" or shot["leaving"]:
                    largest[name] = max(largest[name], change / mpf(float(most[name][k])))
    for name, least in LEAST[precision].items():
        assert least < largest[name] <= 1, (name, largest[name])


def test_the_margins_of_single_precision_contain_those_and_the_roundings() -> None:
    """The kernel's margins are those of the test above with what is counted in `single.py`."""
    values = flights(SHOTS)
    count = len(values["t"])
    values |= {"end": values["horizon"], "t": 0.0}
    values |= dict.fromkeys(("low1", "low2", "high1", "high2"), np.zeros(count))
    values |= in_doubles(SINGLE.started(), values)
    names = ("share", "flat", "tilt", "rate_margin")
    grain = in_doubles({name: SINGLE.grain()[name] for name in names}, values)
    allowed = _allowed_in_single({**values, "share": grain["share"]})
    reach = PARAMETERS["ball_radius"] + PARAMETERS["wire_radius"]
    outer = PARAMETERS["ring_radius"] + reach
    dropped = PARAMETERS["gravity"] * values["horizon"] ** 2
    counted = 5 * reach * UNIT * (14.5 * outer + 6 * dropped)
    leaving = values["leaving"] > 0
    assert np.all(grain["flat"] >= allowed["margin"] + counted)
    assert np.all(grain["tilt"][leaving] >= allowed["leaving_margin"][leaving])
    rounded = allowed["rate_margin"] + 32 * UNIT * outer * _sizes(values)[1]
    assert np.all(grain["rate_margin"] >= rounded)


def _undecided(kernel: Kernel, values: Mapping[str, Any]) -> NDArray[np.bool_]:
    """Return whether a decision makes a time undecided that was not."""
    start = {"undecided_time": np.inf, "excess": -1.0, "budget_exceeded": -1.0}
    return in_doubles(dict(kernel.outputs), {**start, **values})["undecided_time"] == 0.0


def test_an_arrival_that_may_be_later_than_the_horizon_is_undecided() -> None:
    """The latest root of the bound on a gap at a certain crossing is compared with the horizon."""
    rng = np.random.default_rng(33)
    slope, margin = 10 ** rng.uniform(-3, 1, 500), 10 ** rng.uniform(-16, -9, 500)
    ceiling = slope**2 / (6 * margin) * rng.choice([1e-9, 0.5, 0.9999], 500)
    values = {"rate": -slope, "rate_margin": 0.0, "margin": margin, "ceiling": ceiling}
    crossing = in_doubles(event_polynomials.crossing(), values)
    assert np.all(crossing["clearance"] > 0)
    root = 2 * margin / (slope + np.sqrt(slope**2 - 2 * ceiling * margin))
    values, decides = {"earliest_delay": crossing["delay"]}, KERNELS["out_of_budget"]
    # Twice the margin is left for what Newton's method leaves, and not more.
    for late in (1, 2, 2.7):
        assert np.all(_undecided(decides, {**values, "pad": late * root}))
    assert not np.any(_undecided(decides, {**values, "pad": 3.01 * root}))


def test_where_a_time_limit_ends_every_shot_all_of_a_delay_counts() -> None:
    """The time limit is no crossing, and its delay is the error of the time itself."""
    limited = kernels([0], {"capped": 2, "invalid": 4, "short": 3, "endless": 6}, 0, True, True)
    late = {"earliest_delay": np.array([1e-6, 1e-6]), "pad": np.array([0.99e-6, 1e-6])}
    assert _undecided(limited["out_of_budget"], late).tolist() == [True, False]
