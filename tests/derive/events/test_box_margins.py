"""The bounds of the search for a box: margins, curvature and ceiling hold, and a certain root is.

The true ball, with 40 digits, is off the computed one by as much as the search allows for.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.events import root_finder_for
from hoopgen.derive.events.box import BoxRootFinder
from hoopgen.derive.events.box_windows import RELATIVE_INFLATION
from mpmath import mpf
from numpy.typing import NDArray

from tests.derive.events.test_box_windows import BOX, CORNERS, STATE
from tests.derive.test_evaluation import digits, in_doubles
from tests.helpers.effort import occurrences, trials
from tests.helpers.scenes.block import BLOCK

FINDER = root_finder_for(BOX, BLOCK.flight)
assert isinstance(FINDER, BoxRootFinder)
G, UNIT = 9.81, 2.0**-53
NAMES = ("margin", "leaving_margin", "rate_margin")
Columns = dict[str, Any]
Floats = NDArray[np.float64]


def drawn(count: int, seed: int, leaving: bool) -> Columns:
    """Return flights that are in the box, with the ball's radius, at a time; some begin on it.

    Most of them are at edges and corners then, where F is largest.
    """
    random = np.random.default_rng(seed)
    half = 10 ** random.uniform(-2, 0.3, (3, count))
    radius = 10 ** random.uniform(-2, -0.5, count)
    centre = random.uniform(-1, 1, (3, count)) * 10 ** random.uniform(-4, 2, count)
    near = random.random(count) < 0.5  # the size of the flight is that of the ball
    centre = np.where(near, random.choice([-1, 1], (3, count)) * (half + radius), centre)
    wider = float(RELATIVE_INFLATION) * (half + radius).min(axis=0)
    side = random.choice([-1, 0, 1], (3, count), p=[0.4, 0.2, 0.4])
    beyond = random.choice([0.1, 0.7, 0.99, 1], (3, count)) * random.uniform(0.9, 1, (3, count))
    there = centre + np.where(
        side == 0, half * random.uniform(-0.9, 0.9, (3, count)), side * (half + beyond * radius)
    )
    inflated = wider * random.uniform(0, 1, (3, count)) * (random.random(count) < 0.3)
    there += side * (beyond > 0.9) * ((1 - beyond) * radius + inflated)
    time = 10 ** random.uniform(-7 if leaving else -5, 0, count)
    velocity = random.normal(0, 1, (3, count)) * 10 ** random.uniform(-2, 1, count)
    velocity *= random.random((3, count)) < 0.6
    if leaving:
        # Both ends are near the box.
        start = centre + (half + radius) * random.uniform(-1, 1, (3, count))
        start = np.where(
            random.random(count) < 0.5, start, there + random.normal(0, 1e-2, (3, count))
        )
        gone = (there - start) / time
        gone[2] += G * time / 2
        velocity = np.where(np.abs(gone).max(axis=0) < 30, gone, velocity)
    place = there - velocity * time
    place[2] += G * time**2 / 2
    if not leaving:
        velocity[2] += G * time
        place[2] -= G * time**2
    corners = dict(zip(CORNERS[0] + CORNERS[1], (*(centre - half), *(centre + half)), strict=True))
    values: Columns = dict(zip(STATE, (*place, *velocity), strict=True)) | corners
    values |= {"ball_radius": radius, "gravity": np.full(count, G), "t": time, "wider": wider}
    values |= {"extent": np.abs(place).sum(axis=0), "speed": np.abs(velocity).sum(axis=0)}
    values["horizon"] = time * random.uniform(1, 1.02, count)
    return values | {"leaving": 1.0 if leaving else 0.0}


def exactly(values: Columns, row: int) -> dict[str, mpf]:
    """Return the numbers of a row."""
    return {n: mpf(float(v[row] if np.ndim(v) else v)) for n, v in values.items()}


class Ball:
    """A true ball in mpmath.

    Parameters
    ----------
    own
        The numbers of a row.
    errors
        What its state is off, (6,).
    """

    def __init__(self, own: dict[str, mpf], errors: Any = (0,) * 6) -> None:
        self.state = [own[n] + e for n, e in zip(STATE, errors, strict=True)]
        self.faces = [(own[a], own[b]) for a, b in zip(*CORNERS, strict=True)]
        self.radius, self.g = own["ball_radius"], own["gravity"]

    def excess(self, t: mpf) -> list[mpf]:
        """Return e of each coordinate."""
        place = [self.state[k] + self.state[3 + k] * t for k in range(3)]
        place[2] -= self.g * t**2 / 2
        return [
            max(p - high, mpf(0)) - max(low - p, mpf(0))
            for p, (low, high) in zip(place, self.faces, strict=True)
        ]

    def velocity(self, t: mpf) -> list[mpf]:
        """Return the velocity."""
        return [*self.state[3:5], self.state[5] - self.g * t]

    def gap(self, t: mpf) -> mpf:
        """Return F."""
        return sum(e**2 for e in self.excess(t)) - self.radius**2

    def rate(self, t: mpf) -> mpf:
        """Return F'."""
        return 2 * sum(e * v for e, v in zip(self.excess(t), self.velocity(t), strict=True))

    def bend(self, t: mpf) -> mpf:
        """Return F'' on one side of a seam."""
        e, v = self.excess(t), self.velocity(t)
        return 2 * sum(one**2 for one, off in zip(v, e, strict=True) if off) - 2 * self.g * e[2]


def with_errors(values: Columns, seed: int) -> tuple[Columns, Floats]:
    """Return the flights with errors up to which a search allows for, and the signed errors.

    Signs are those with which F grows, or at random.
    """
    random, count = np.random.default_rng(seed), len(values["x"])
    fastest = values["speed"] + G * values["horizon"]
    furthest = values["extent"] + values["horizon"] * fastest
    share = 2.0 ** -random.choice([25, 30, 40, 45, 60], count)
    place, moving = share * furthest, share * fastest
    shift = np.minimum(1, values["wider"] / 4 / (place + moving * values["horizon"]))
    place, moving = place * shift, moving * shift * random.choice([0, 1], count)
    there = np.array([values[n] + values[f"v{n}"] * values["t"] for n in "xyz"])
    there[2] -= G * values["t"] ** 2 / 2
    centre = np.array([(values[a] + values[b]) / 2 for a, b in zip(*CORNERS, strict=True)])
    away = np.where(there < centre, -1, 1)
    signs = np.where(random.random(count) < 0.7, away, random.choice([-1, 1], away.shape))
    along = np.where(random.random(count) < 0.7, signs, random.choice([-1, 1], away.shape))
    errors = 0.9999 * np.array([*(signs * place), *(along * moving)])
    return values | {"position_error": place, "velocity_error": moving}, errors


LEAST = {"margin": 0.4, "leaving_margin": 0.15, "rate_margin": 0.3}
"""The largest error of many is at least this much of its margin."""


@pytest.mark.parametrize("leaving", [False, True])
def test_errors_of_gap_and_rate_are_within_their_margins(leaving: bool) -> None:
    """They reach a part of each: e is bounded by R_B on all axes, and its error counts twice."""
    values, errors = with_errors(drawn(trials(8000), 80, leaving), 81)
    search = {"gap": FINDER.leaving_gap if leaving else FINDER.gap, "rate": FINDER.rate}
    found = in_doubles(search | FINDER.margins, values)
    largest = dict.fromkeys(NAMES, mpf(0))
    with digits(40):
        for row in range(len(values["x"])):
            own = exactly(values, row)
            ball, t = Ball(own, [mpf(float(e)) for e in errors[:, row]]), own["t"]
            start = ball.gap(mpf(0)) if leaving else mpf(0)
            gap = abs(ball.gap(t) - start - mpf(float(found["gap"][row])))
            rate = abs(ball.rate(t) - mpf(float(found["rate"][row])))
            name, per = ("leaving_margin", t) if leaving else ("margin", mpf(1))
            for one, off in ((name, gap / per), ("rate_margin", rate)):
                largest[one] = max(largest[one], off / mpf(float(found[one][row])))
    assert max(largest.values()) <= 1, largest
    reached = {n: LEAST[n] for n in ("leaving_margin" if leaving else "margin", "rate_margin")}
    assert all(largest[n] > least for n, least in reached.items()), largest


def test_roundings_alone_reach_a_part_of_the_margins() -> None:
    """The states are exact."""
    for leaving in (False, True):
        values = drawn(trials(3000), 82, leaving)
        values |= {"position_error": 0.0, "velocity_error": 0.0}
        search = {"gap": FINDER.leaving_gap if leaving else FINDER.gap, "rate": FINDER.rate}
        found = in_doubles(search | FINDER.margins, values)
        largest = dict.fromkeys(NAMES, mpf(0))
        with digits(40):
            for row in range(len(values["x"])):
                own = exactly(values, row)
                ball, t = Ball(own), own["t"]
                start = ball.gap(mpf(0)) if leaving else mpf(0)
                gap = abs(ball.gap(t) - start - mpf(float(found["gap"][row])))
                rate = abs(ball.rate(t) - mpf(float(found["rate"][row])))
                name, per = ("leaving_margin", t) if leaving else ("margin", mpf(1))
                for one, off in ((name, gap / per), ("rate_margin", rate)):
                    largest[one] = max(largest[one], off / mpf(float(found[one][row])))
        name = "leaving_margin" if leaving else "margin"
        assert (0.003 if leaving else 0.01) < largest[name] < 0.5, (leaving, largest)
        assert 0.01 < largest["rate_margin"] < 0.5, (leaving, largest)


def test_the_gap_bends_down_no_more_than_its_bound_across_seams() -> None:
    """Within a window of any length, of which the ball may cross several seams."""
    width = sp.Symbol("width", nonnegative=True)
    values, random = drawn(trials(2500), 83, False), np.random.default_rng(84)
    count = len(values["x"])
    values["width"] = 10 ** random.uniform(-4, 0, count)
    values["horizon"] = values["t"] + values["width"]
    values |= {"position_error": 0.0, "velocity_error": 0.0}
    values["ceiling"] = in_doubles({"c": FINDER.ceiling}, values)["c"]
    bound = in_doubles({"m": FINDER.curvature(width)}, values)["m"]
    reached, crossings = mpf(0), 0
    with digits(40):
        for row in range(count):
            own = exactly(values, row)
            ball, reach = Ball(own), own["ball_radius"] + own["wider"]
            beyond = [e != 0 for e in ball.excess(own["t"])]
            for k in range(24):
                t = own["t"] + own["width"] * k / 23
                e = ball.excess(t)
                if max(map(abs, e)) > reach:
                    break
                crossings += [one != 0 for one in e] != beyond
                bend = ball.bend(t)
                assert -bend <= bound[row], row
                if bound[row] > 0:
                    reached = max(reached, -bend / mpf(float(bound[row])))
                assert abs(bend) <= values["ceiling"][row]
    assert crossings > occurrences(1000)
    assert 0.95 < reached <= 1, reached


def approaching(count: int, seed: int) -> Columns:
    """Return flights that are above the surface at a time, by at most some hundredths of R_B."""
    random, values = np.random.default_rng(seed), drawn(count, seed, False)
    side = random.choice([-1, 0, 1], (3, count), p=[0.35, 0.3, 0.35])
    side[2, ~side.any(axis=0)] = 1
    away = side * random.uniform(0.02, 1, (3, count))
    away /= np.sqrt((away**2).sum(axis=0))
    low, high = (np.array([values[n] for n in names]) for names in CORNERS)
    reach = values["ball_radius"] * (1 + 10 ** random.uniform(-6, -1.5, count))
    inner = low + (high - low) * random.uniform(0, 1, (3, count))
    there = np.select([side < 0, side > 0], [low, high], inner) + away * reach
    velocity = random.normal(0, 1, (3, count)) * 10 ** random.uniform(-3, 1, count)
    velocity -= away * 10 ** random.uniform(-3, 1, count)
    time = 10 ** random.uniform(-5, 0, count)
    place = there - velocity * time
    place[2] -= G * time**2 / 2
    velocity[2] += G * time
    values |= dict(zip(STATE, (*place, *velocity), strict=True)) | {"t": time}
    values |= {"extent": np.abs(place).sum(axis=0), "speed": np.abs(velocity).sum(axis=0)}
    return values | {"horizon": time * random.uniform(1, 1.2, count)}


def test_a_certain_root_is_one_and_the_gap_bends_no_more_than_the_ceiling_until_it() -> None:
    """From faces, edges and corners, and so slowly that free fall bends the gap most."""
    values, errors = with_errors(approaching(trials(1500), 85), 86)
    values |= {"end": values["horizon"], **in_doubles({"ceiling": FINDER.ceiling}, values)}
    values |= in_doubles({n: FINDER.margins[n] for n in ("margin", "rate_margin")}, values)
    found = in_doubles({n: FINDER.advance()[n] for n in ("gap", "rate", "clearance")}, values)
    certain = np.flatnonzero((found["clearance"] > 0) & (found["gap"] > 0))
    assert len(certain) > occurrences(150)
    bent = above = mpf(0)
    with digits(40):
        for row in certain:
            own = exactly(values, row)
            ball, t = Ball(own, [mpf(float(e)) for e in errors[:, row]]), own["t"]
            low = max(mpf(float(found["gap"][row])) - own["margin"], mpf(0))
            fall = -mpf(float(found["rate"][row])) - own["rate_margin"]
            until = 2 * (low + 2 * own["margin"]) / fall
            for k in range(33):
                then = t + until * k / 32
                if ball.gap(then) < 0:
                    break
                assert ball.rate(then) < 0
                bent = max(bent, abs(ball.bend(then)) / own["ceiling"])
                above = max(above, ball.gap(then) / ball.radius**2)
            assert ball.gap(t + until) < 0, row
    assert 0.25 < bent <= 1, bent
    assert above > 0.005, above


def test_where_newtons_method_ends_the_gap_is_within_its_margin() -> None:
    """A step from h = 2^-24 on leaves 2^-49 F'²/C, less than 4/3 of the margin."""
    values = approaching(trials(30_000), 87)
    values |= {"position_error": 0.0, "velocity_error": 0.0}
    found = in_doubles(
        {"rate": FINDER.rate, "ceiling": FINDER.ceiling, "margin": FINDER.margins["margin"]}, values
    )
    left = 2.0**-49 * found["rate"] ** 2 / found["ceiling"]
    assert 0.02 < np.max(left / found["margin"]) < 4 / 3


SLACK = 1 + 2.0**-10
"""The factor of a margin for the roundings of its own evaluation."""


def counted(values: Columns) -> Columns:
    """Return margins, ceiling and curvature bound as the lemmas count them, without any slack."""
    g, lasting, radius = values["gravity"], values["horizon"], values["ball_radius"]
    fastest = values["speed"] + g * lasting
    furthest = values["extent"] + lasting * fastest
    place, moving = values["position_error"], values["velocity_error"]
    off = 0.0
    for low, high in zip(*CORNERS, strict=True):
        sides = np.abs(values[low]) + np.abs(values[high])
        off += 2 * (place + moving * lasting + 4 * UNIT * furthest)
        off += 2 * UNIT * (furthest + sides)  # a sign counts as a product
    reach = radius + 2 * values["wider"]
    low, high = values["from_z"], values["to_z"]
    height = values["z"] + values["vz"] * values["t"] - g * values["t"] ** 2 / 2
    beyond = np.maximum(height - high, 0) + np.maximum(low - height, 0)
    fall, width = np.abs(values["vz"] - g * values["t"]), values["width"]
    drift = (fall + g * width / 2) * width
    ceiling = 2 * (3 * fastest**2 + 1.25 * reach * g)
    slope = 2 * (off * fastest + 3 * reach * moving)
    return {
        "margin": 2 * reach * off
        + UNIT * (12 * reach**2 + 5 * radius**2 + 12 * reach * fastest * lasting),
        "leaving_margin": 2 * slope + 96 * UNIT * reach * fastest,
        "rate_margin": slope + 36 * UNIT * reach * fastest,
        "ceiling": ceiling,
        "curvature": 2 * g * np.minimum(beyond + drift, reach) + 2.0**-40 * ceiling,
    }


@pytest.mark.parametrize("leaving", [False, True])
def test_bounds_are_no_smaller_than_the_counts_of_their_lemmas(leaving: bool) -> None:
    """Nor much larger; roundings are compared where errors are zero, too."""
    values, _ = with_errors(drawn(trials(2000), 89, leaving), 90)
    random, count = np.random.default_rng(91), len(values["x"])
    none = random.random(count) < 0.5
    for name in ("position_error", "velocity_error"):
        values[name] = np.where(none, 0, values[name])
    values["width"] = 10 ** random.uniform(-9, 0, count)
    width = sp.Symbol("width", nonnegative=True)
    bounds = FINDER.margins | {"ceiling": FINDER.ceiling}
    found = in_doubles(bounds, values)
    found |= in_doubles({"curvature": FINDER.curvature(width)}, values | found)
    for name, least in counted(values).items():
        most = SLACK * (1 + 2.0**-12) if name in NAMES else 1 + 2.0**-30
        # A difference of times and heights is not the same in another order.
        floor = 1e-13 if name == "curvature" else 0.0
        size = np.abs(values["extent"]) + values["speed"] if floor else 0.0
        fewest = SLACK * (1 - 2.0**-40) if name in NAMES else 1 - 2.0**-45
        assert np.all(found[name] >= least * fewest - floor * size * G), name
        assert np.all(found[name] <= least * most + floor * size * G), name
