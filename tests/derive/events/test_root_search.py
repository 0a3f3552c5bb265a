"""Promises of every search, compared with mpmath: bounds of F'', steps, roots, margins."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import mpmath
import pytest
import sympy as sp
from hoopgen.derive.events import root_finder_for
from hoopgen.derive.events.event_polynomials import ceiling
from hoopgen.derive.events.polynomial import PolynomialRootFinder
from hoopgen.derive.events.ring.polar import INFLATION_FACTOR
from hoopgen.derive.events.root_finder import RootFinder
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.surfaces import Sphere
from hoopgen.derive.symbolic.symbols import t
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from mpmath import mpf

from tests.derive.test_evaluation import (
    INFINITY,
    Path,
    along,
    digits,
    exactly,
    in_doubles,
    paths,
    resting,
)
from tests.helpers.effort import trials

RING = HOOP.surfaces[0]
WIDTH = sp.Symbol("width", nonnegative=True)
LONG = mpf(100)
"""Longer than any flight, s."""
EXACT = {"margin": 0, "rate_margin": 0, "leaving": 0}
parts_of_one = st.floats(0, 1)
signs = st.tuples(*[st.sampled_from((-1, 1))] * 6)


class Search:
    """An approach with its expressions made once."""

    def __init__(self, made: RootFinder) -> None:
        self.root_finder = made
        self.windows = made.windows
        self.gap, self.leaving_gap = made.gap, made.leaving_gap
        self.rate, self.bend = made.rate, made.bend
        self.curvature, self.ceiling = made.curvature(WIDTH), made.ceiling
        self.margins, self.advance, self.refine = made.margins, made.advance(), made.refine()

    def values(self, path: Path, end: mpf = LONG) -> dict[str, Any]:
        """Return the flight with the search's constants, no errors and no margins."""
        values = along(self.root_finder, path.values) | EXACT | {"end": end, "horizon": end}
        return values | {"ceiling": exactly(self.ceiling, values)}


OWN = Search(root_finder_for(RING, HOOP.flight))
OCTIC = Search(PolynomialRootFinder(HOOP.flight, RING))
_CENTRE = sp.symbols("cx cy cz", real=True)
BALL = Search(root_finder_for(Sphere("ball", _CENTRE, sp.Symbol("r", positive=True)), HOOP.flight))
searches = pytest.mark.parametrize("search", [OWN, OCTIC], ids=["ring", "octic"])


def sometimes(examples: int) -> settings:
    """Return settings for that many examples at effort 1, the same ones every time."""
    return settings(deadline=None, derandomize=True, max_examples=trials(examples))


def window(path: Path, part: float) -> tuple[mpf, mpf]:
    """Return a time in a window of the ring, by its part of the way, and the window's end."""
    values = along(OWN.root_finder, path.values)
    later = [
        (max(exactly(low, values), mpf(0)), exactly(high, values)) for low, high in OWN.windows
    ]
    open_ = [(low, high) for low, high in later if low < high < INFINITY]
    assume(open_)
    low, high = open_[int(part * len(open_)) if part < 1 else -1]
    return low + (high - low) * mpf(part), high


def is_near(path: Path, t: mpf) -> bool:
    """Return True within the ring's windows proper: their pads, for roundings, are left out."""
    rho, z = path.place(t)
    wider = path.reach * mpf(INFLATION_FACTOR.p) / INFLATION_FACTOR.q
    return bool(abs(z) <= wider and abs(rho - path["ring_radius"]) <= wider)


def slopes(search: Search, values: dict[str, Any], t: mpf) -> tuple[mpf, mpf, mpf]:
    """Return F, F' and F'' at a time."""
    there = values | {"t": t}
    return tuple(exactly(e, there) for e in (search.gap, search.rate, search.bend))


# -- Bounds of the second derivative


@pytest.mark.slow
@searches
@sometimes(150)
@given(paths(), parts_of_one, parts_of_one)
def test_the_curvature_bounds_how_much_the_gap_bends_down(
    search: Search, path: Path, part: float, share: float
) -> None:
    """-F''(t + s) <= M for every s up to the width, as long as the window lasts."""
    with digits(40):
        t, end = window(path, part)
        width = (end - t) * mpf(share) ** 3
        values = search.values(path, end)
        bound = exactly(search.curvature, values | {"t": t, "width": width})
        for k in range(9):
            later = t + width * k / 8
            assert -slopes(search, values, later)[2] <= bound or not is_near(path, later)


@pytest.mark.sampled(1)
@searches
@sometimes(150)
@given(paths(), parts_of_one)
def test_the_ceiling_bounds_the_bend_in_every_window(
    search: Search, path: Path, part: float
) -> None:
    with digits(40):
        t, end = window(path, part)
        assume(is_near(path, t))
        values = search.values(path, end)
        assert abs(slopes(search, values, t)[2]) <= exactly(search.ceiling, values)


# -- Steps and roots


@pytest.mark.sampled(1)
@searches
@sometimes(150)
@given(paths(), parts_of_one)
def test_a_step_passes_no_root(search: Search, path: Path, part: float) -> None:
    """A positive gap stays positive up to the step, which ends with the window at the latest."""
    with digits(40):
        t, end = window(path, part)
        values = search.values(path, end)
        gap, _, _ = slopes(search, values, t)
        assume(gap > 0 and t < end)
        step = exactly(search.advance["step"], values | {"t": t})
        assert 0 < step <= end - t
        for k in range(32):
            assert exactly(search.gap, values | {"t": t + step * k / 32}) > 0
        assert exactly(search.gap, values | {"t": t + step}) > -(mpf(10) ** -30)


@pytest.mark.slow
@sometimes(150)
@given(paths(), parts_of_one)
def test_a_step_in_doubles_passes_no_root_of_the_true_gap(path: Path, part: float) -> None:
    """The step's margins allow for the roundings of gap, rate, curvature and itself."""
    search = OWN
    with digits(40):
        t, end = (float(time) for time in window(path, part))
        assume(1e-200 < t < end and path.gap(mpf(t)) > 0)
        values = search.values(path, mpf(end)) | {"t": t}
        values |= in_doubles(search.root_finder.constants, values)
        values |= in_doubles({n: search.margins[n] for n in ("margin", "rate_margin")}, values)
        step = float(in_doubles({"step": search.advance["step"]}, values)["step"])
        assert 0 <= step <= end - t
        for k in range(33):
            assert path.gap(mpf(t) + mpf(step) * k / 32) > 0


def first_arrival(search: Search, values: dict[str, Any]) -> mpf:
    """Return where steps from the left end, infinite if they pass every window."""
    for low, high in search.windows:
        t, end = max(exactly(low, values), mpf(0)), min(exactly(high, values), LONG)
        while t < end:
            gap, rate, _ = slopes(search, values, t)
            if gap < mpf(10) ** -30 and rate < 0:
                return t
            step = exactly(search.advance["step"], values | {"t": t, "end": end})
            if step >= end - t:
                break
            t += step
    return INFINITY


@pytest.mark.slow
@pytest.mark.parametrize(("search", "general"), [(OWN, OCTIC), (BALL, BALL)], ids=["ring", "ball"])
@sometimes(60)
@given(paths())
def test_steps_from_the_left_end_at_the_first_arrival_or_prove_that_there_is_none(
    search: Search, general: Search, path: Path
) -> None:
    """Against the real roots of the event polynomial, found by another method."""
    with digits(60):
        # From outside, and nowhere near a double root or a vanishing leading coefficient.
        assume(path["vx"] ** 2 + path["vy"] ** 2 > 1e-6)
        ball = {"cx": path["ring_radius"], "cy": 0, "cz": 0, "r": path.reach}
        values = search.values(Path(path.values | ball))
        assume(exactly(search.gap, values | {"t": 0}) > mpf(10) ** -6)
        coefficients = [exactly(c, values) for c in reversed(general.root_finder._coefficients)]
        roots = mpmath.polyroots(coefficients, maxsteps=500, extraprec=400)
        real = [r.real for r in roots if abs(r.imag) < mpf(10) ** -25]
        assume(all(abs(r.imag) > mpf(10) ** -8 or r.real in real for r in roots))
        rates = {r: slopes(search, values, r)[1] for r in real if r > 0}
        assume(all(abs(rate) > mpf(10) ** -8 for rate in rates.values()))
        expected = min((r for r, rate in rates.items() if rate < 0), default=INFINITY)
        found = first_arrival(search, values)
        assert found == expected or abs(found - expected) < mpf(10) ** -18


def refined(refine: Mapping[str, sp.Expr], values: Mapping[str, Any]) -> tuple[mpf, int]:
    """Return where Newton's method ends, as the event loop ends it, and after how many steps."""
    there = dict(values)
    for step in range(1, 9):
        said = {name: exactly(e, there) for name, e in refine.items()}
        there["t"] = said["time"]
        if values["ceiling"] * abs(said["gap"]) <= mpf(2) ** -24 * said["rate"] ** 2:
            return said["time"], step
    raise AssertionError("it does not converge")


@pytest.mark.slow
@searches
@sometimes(80)
@given(paths(), parts_of_one, st.floats(0, 0.49))
def test_a_clearance_promises_one_simple_root_that_newton_s_method_reaches(
    search: Search, path: Path, part: float, margin_share: float
) -> None:
    """This is the case F > 2 m: the margin is less than half of the gap.

    Then the lemma of `root_finder.py` gives r² > 8 C (2 - 0.49) F, and with |F''| <= C the root is
    at most 1.0455 F/r away, at the root of F - r s + C s²/2.
    """
    with digits(120):
        t, end = window(path, part**8)
        values = search.values(path, end)
        # A few steps bring most flights with an arrival near enough.
        for _ in range(3):
            t += exactly(search.advance["step"], values | {"t": t}) * mpf(1 - 2**-20)
        gap, rate, _ = slopes(search, values, t)
        values["margin"] = gap * mpf(margin_share)
        clearance = exactly(search.advance["clearance"], values | {"t": t})
        assume(clearance > 0 and rate < 0 < gap)
        first = gap / -rate
        found, steps = refined(search.refine, values | {"t": t})
        root = found
        for _ in range(6):
            root = exactly(search.refine["time"], values | {"t": root})
        assert abs(exactly(search.gap, values | {"t": root})) < mpf(10) ** -90
        assert 0 < root - t < mpf(1.0455) * first
        assert abs(found - root) <= mpf(2) ** -48 * -rate / values["ceiling"]
        assert steps <= 4
        for k in range(33):
            assert slopes(search, values, t + 2 * first * k / 32)[1] < 0


@dataclass(frozen=True)
class Parabola(RootFinder):
    """F = gap - slope t + C t²/2 with |F''| = C: of all that C allows, Newton does worst on it."""

    constants: ClassVar[dict[str, sp.Expr]] = {}
    windows: ClassVar[list[Any]] = []
    margins: ClassVar[dict[str, sp.Expr]] = {}
    opening, slope = sp.symbols("opening slope", positive=True)
    gap = opening - slope * t + ceiling * t**2 / 2
    leaving_gap = gap
    rate = ceiling * t - slope
    bend = ceiling
    ceiling = ceiling

    def curvature(self, width: sp.Expr) -> sp.Expr:
        """F bends up, never down."""
        return sp.Integer(0)


@pytest.mark.parametrize("part", [0, 0.25, 0.49])
def test_a_clearance_promises_no_more_than_the_worst_gap_keeps(part: float) -> None:
    """The least slope that has a clearance, on the parabola with one root that falls slowest.

    Four steps end within 2^-48 of slope over curvature, and not by far; three do not.
    """
    worst = Parabola(HOOP.flight)
    advance, refine = worst.advance(), worst.refine()
    with digits(120):
        values = EXACT | {"opening": 1, "ceiling": 1, "end": 1, "t": 0, "margin": mpf(part)}
        low, high = mpf(1), mpf(64)
        for _ in range(64):
            middle = (low + high) / 2
            clear = exactly(advance["clearance"], values | {"slope": middle}) > 0
            low, high = (low, middle) if clear else (middle, high)
        values["slope"] = high
        found, steps = refined(refine, values)
        root = high - mpmath.sqrt(high**2 - 2)
        assert steps == 4
        assert 0 < root - found <= mpf(2) ** -48 * high


# -- Margins


# A corner of the window, |z| and |rho - R_H| both near R, where F is steepest.
CORNER = {"x": 0.2400189493131708, "y": 0.22360080349964567, "z": -0.09262333394088106, "vx": 1.0}


@pytest.mark.sampled(1)
@searches
@sometimes(150)
@given(paths(), parts_of_one, signs, st.sampled_from((0.0, 1e-12, 1e-9)))
@example(resting(**CORNER), 0.5, (-1, -1, 1, -1, -1, -1), 1e-12)
def test_margins_bound_what_gap_and_rate_are_off_by_in_every_window(
    search: Search, path: Path, part: float, directions: tuple[int, ...], error: float
) -> None:
    """Computed in doubles from a state that is off in each of its components."""
    with digits(40):
        t, end = window(path, part)
        t = mpf(float(t))
        assume(mpf(10) ** -200 < t <= end and path.place(t)[0] > 0)
        values = search.values(path, end) | {"t": t}
        values |= {"position_error": error, "velocity_error": 2 * error}
        bounds = {name: exactly(e, values) for name, e in search.margins.items()}
        computed = in_doubles(
            {"gap": search.gap, "rate": search.rate, "leaving": search.leaving_gap}, values
        )
        names = ("x", "y", "z", "vx", "vy", "vz")
        off = {
            name: mpf(path[name]) + sign * error * (2 if name in names[3:] else 1)
            for name, sign in zip(names, directions, strict=True)
        }
        true = search.values(Path(path.values | off)) | {"t": t}
        gap, rate, _ = slopes(search, true, t)
        assert abs(gap - float(computed["gap"])) <= bounds["margin"]
        assert abs(rate - float(computed["rate"])) <= bounds["rate_margin"]
        if search is OCTIC and not is_near(path, mpf(0)):
            return  # its bound is for a ball that leaves the surface
        left = exactly(search.leaving_gap, true)
        assert abs(left - float(computed["leaving"])) <= bounds["leaving_margin"] * t
