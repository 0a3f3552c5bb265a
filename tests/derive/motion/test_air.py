"""Flight through air: the error of a piece is within its proved bound, by 40 digits and more."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from operator import add, mul, sub, truediv
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.events import air_near
from hoopgen.derive.events.event_polynomials import horizon
from hoopgen.derive.ir.kernel import kernel
from hoopgen.derive.kernels.arguments import argument_order
from hoopgen.derive.motion import air_piece
from hoopgen.derive.motion.air_series import (
    FIRST_SINGLE,
    ORDER,
    SERIES_KERNELS,
    SINGLE_SERIES,
    TAIL,
)
from hoopgen.derive.scenes.air import AIR, AIR_PARAMETERS
from hoopgen.derive.symbolic.conditionals import release
from mpmath import mp, mpf, odefun, sqrt

from hoopgen.codegen.program import Program, lower
from hoopgen.core.parameters import AIR_DEFAULTS
from tests.helpers.effort import trials

Values = dict[str, float]

NAMES = ("x", "y", "z", "vx", "vy", "vz")

DEFAULTS: Values = {p.name: p.default for p in AIR.parameters}

_OPERATIONS: dict[str, Callable[..., Any]] = {
    "add": add,
    "sub": sub,
    "mul": mul,
    "div": truediv,
    "neg": lambda a: -a,
    "sqrt": np.sqrt,
    "abs": abs,
    "max": max,
    "min": min,
    "less": lambda a, b: a < b,
    "at_most": lambda a, b: a <= b,
    "both": lambda a, b: a and b,
    "either": lambda a, b: a or b,
    "not": lambda a: not a,
    "nowhere": lambda: False,
    "select": lambda truth, a, b: a if truth else b,
}


@cache
def programs() -> dict[str, Program]:
    """Return the kernels of a piece, and of the flight in it, as programs of single operations."""
    from hoopgen.derive.model import build

    known = {kernel.name: kernel for kernel in build(AIR).kernels}
    return {name: lower(known[name], AIR.symbols) for name in (*SERIES_KERNELS, "flight")}


def evaluate(name: str, values: Values) -> Values:
    """Return the results of a kernel, each operation rounded to its precision."""
    return run(programs()[name], values)


def run(program: Program, values: Values) -> Values:
    """Return the results of a program, each operation rounded to the program's precision."""
    rounded: Any = np.float32 if program.single else np.float64
    done: list[Any] = []
    with np.errstate(all="ignore"):
        for operation in program.operations:
            if operation.name == "argument":
                done.append(rounded(values[operation.symbol.removeprefix("p_")]))
            elif operation.name == "constant":
                done.append(rounded(operation.value))
            else:
                operands = (done[k] for k in operation.operands)
                done.append(_OPERATIONS[operation.name](*operands))
    found = (float(done[k]) for k in program.outputs)
    return dict(zip(program.kernel.output_names, found, strict=True))


def begin(state: np.ndarray, **parameters: float) -> Values:
    """Return what is known of the piece of a flight that begins with a state."""
    values = dict(zip((*NAMES, "wx", "wy", "wz"), map(float, state), strict=True))
    values |= DEFAULTS | parameters
    values["extent"] = float(np.abs(state[:3]).sum())
    for name in SERIES_KERNELS:
        values |= evaluate(name, values)
    return values


def reference(state: np.ndarray, time: float) -> list[mpf]:
    """Return position and velocity by mpmath's Taylor series."""
    names = ("gravity", "ball_radius", "ball_mass", "air_density")
    g, r, m, rho = (mpf(DEFAULTS[name]) for name in names)
    drag, lift, smooth = (
        mpf(DEFAULTS[name])
        for name in ("drag_coefficient", "lift_coefficient", "drag_smoothing_speed")
    )
    w = [mpf(float(c)) for c in state[6:]]
    half = rho * mp.pi * r**2 / (2 * m)
    fall = g * (1 - rho * 4 * mp.pi * r**3 / (3 * m))

    def force(_: mpf, y: list[mpf]) -> list[mpf]:
        v = y[3:]
        size = sqrt(v[0] ** 2 + v[1] ** 2 + v[2] ** 2 + smooth**2)
        cross = [w[1] * v[2] - w[2] * v[1], w[2] * v[0] - w[0] * v[2], w[0] * v[1] - w[1] * v[0]]
        bend = [
            half * r * lift * c - half * drag * size * one for c, one in zip(cross, v, strict=True)
        ]
        return [*v, bend[0], bend[1], bend[2] - fall]

    return list(odefun(force, 0, [mpf(float(c)) for c in state[:6]])(mpf(time)))


@pytest.mark.slow
def test_the_error_of_a_piece_is_within_its_bound_and_the_bound_is_not_useless() -> None:
    random = np.random.default_rng(5)
    ratios = []
    for _ in range(trials(20, at_least=4)):
        state = random.normal(size=9) * np.repeat([2.0, 5.0, 20.0], 3)
        known = begin(state)
        assert known["unproved"] == 0.0
        assert 1e-3 < known["piece"] < 1.0
        time = known["piece"] * random.uniform(0.2, 1.0)
        found = evaluate("flight", known | {"t": time})
        with mp.workdps(40):
            exact = reference(state, time)
            off = [abs(mpf(found[n]) - e) for n, e in zip(NAMES, exact, strict=True)]
            place, speed = mp.norm(off[:3]), mp.norm(off[3:])
        assert place <= known["piece_place_error"] < 1e-13
        assert speed <= known["piece_speed_error"] < 1e-13
        ratios.append(float(known["piece_speed_error"] / speed))
    assert np.median(ratios) < 300.0


@pytest.mark.slow
def test_the_bound_holds_where_far_more_is_left_out_than_roundings(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(air_piece, "TOLERANCE", sp.Rational(1, 2**24))
    programs.cache_clear()
    random = np.random.default_rng(6)
    ratios = []
    for _ in range(trials(12, at_least=4)):
        state = random.normal(size=9) * np.repeat([2.0, 5.0, 20.0], 3)
        known = begin(state)
        found = evaluate("flight", known | {"t": known["piece"]})
        with mp.workdps(40):
            exact = reference(state, known["piece"])
            off = [abs(mpf(found[n]) - e) for n, e in zip(NAMES, exact, strict=True)]
            place, speed = mp.norm(off[:3]), mp.norm(off[3:])
        assert place <= known["piece_place_error"]
        assert speed <= known["piece_speed_error"]
        ratios.append(float(known["piece_speed_error"] / speed))
    programs.cache_clear()
    assert np.median(ratios) < 100.0


def coefficients(known: Values) -> tuple[list[list[mpf]], list[mpf]]:
    """Return the coefficients of the velocity and of the speed through the air, by order."""
    names = ([f"{axis}_{k}" if k else axis for axis in NAMES[3:]] for k in range(ORDER + 1))
    velocities = [[mpf(known[name]) for name in own] for own in names]
    return velocities, [mpf(known[f"airspeed_{k}"]) for k in range(ORDER + 1)]


def left(known: Values, k: int) -> tuple[mpf, mpf]:
    """Return what the coefficients leave of the equation of the speed and of the velocity."""
    v, s = coefficients(known)
    pairs = range(k + 1)
    square = sum(mp.fdot(v[i], v[k - i]) - s[i] * s[k - i] for i in pairs)
    if k == ORDER:
        return abs(square), mpf(0)
    drag = mpf(known["drag_rate"])
    w = [mpf(known[f"magnus_rate_{axis}"]) for axis in "xyz"]
    rest = []
    for a in range(3):
        b, c = (a + 1) % 3, (a + 2) % 3
        turned = w[b] * v[k][c] - w[c] * v[k][b]
        braked = drag * sum(s[i] * v[k - i][a] for i in pairs)
        rest.append((k + 1) * v[k + 1][a] - turned + braked)
    return abs(square), mp.norm(rest)


@pytest.mark.parametrize("density", [1.2, 60.0, 1e-35])
def test_roundings_of_single_precision_are_within_their_bounds_which_are_not_useless(
    density: float,
) -> None:
    random = np.random.default_rng(12)
    ratios = []
    for _ in range(trials(10, at_least=4)):
        state = random.normal(size=9) * np.repeat([2.0, 5.0, 20.0], 3)
        known = begin(state, air_density=density)
        h = known["piece"]
        with mp.workdps(50):
            v, s = coefficients(known)
            norms = [s[0], *(mp.norm(one, 1) for one in v[1:])]
            a = [sp.Float(float(one) * h**k) for k, one in enumerate(norms)]
            b = [sp.Float(float(abs(one)) * h**k) for k, one in enumerate(s)]
            turning = sum(abs(known[f"magnus_rate_{axis}"]) for axis in "xyz")
            drag = known["drag_rate"]
            bounds = air_piece.late_roundings(a, b, sp.Float(drag), sp.Float(turning))
            found = [left(known, k) for k in range(FIRST_SINGLE, ORDER + 1)]
            orders = [h**k for k in range(FIRST_SINGLE, ORDER + 1)]
            sums = [mp.fdot(column, orders) for column in zip(*found, strict=True)]
        for rest, bound in zip(sums, map(release, bounds), strict=True):
            # What underflows is relative to the other factors of a product, or to 1.
            assert rest <= bound + 2.0**-100
            if density > 1.0:
                ratios.append(float(bound / rest))
    assert density < 1.0 or np.median(ratios) < 300.0


def test_velocity_and_acceleration_are_within_their_bounds_all_along_a_piece() -> None:
    random = np.random.default_rng(6)
    for _ in range(trials(40, at_least=10)):
        state = random.normal(size=9) * np.repeat([2.0, 5.0, 20.0], 3)
        known = begin(state)
        times = np.linspace(0.0, known["piece"], 9)
        path = np.array([list(evaluate("flight", known | {"t": float(t)}).values()) for t in times])
        speed = np.linalg.norm(path[:, 3:], axis=1)
        pull = np.linalg.norm(np.diff(path[:, 3:], axis=0), axis=1) / np.diff(times)
        assert (speed <= known["piece_speed"]).all()
        assert (pull <= known["piece_acceleration"]).all()
        bend = np.linalg.norm(np.diff(path[:, 3:], 2, axis=0), axis=1) / np.diff(times)[1:] ** 2
        assert (bend <= known["piece_jerk"] + 1e-9).all()


@cache
def program_of(name: str) -> Program:
    """Return the box of a path up to the horizon, or a kernel of the scene, as a program."""
    from hoopgen.derive.model import build

    if name != "enclosure":
        (known,) = (one for one in build(AIR).kernels if one.name == name)
        return lower(known, AIR.symbols)
    box = AIR.flight.enclosure(horizon)
    outputs = {f"{part}{k}": pair[j] for k, pair in enumerate(box) for j, part in enumerate("cr")}
    return lower(kernel(name, outputs, argument_order(AIR), "A box.", "Taylor"), AIR.symbols)


def path_of(known: Values, latest: float, count: int = 33) -> np.ndarray:
    """Return positions at times of a piece up to the latest, (count, 3)."""
    times = np.linspace(0.0, latest, count)
    return np.array([list(evaluate("flight", known | {"t": float(t)}).values())[:3] for t in times])


def test_the_path_is_within_its_box_which_is_hardly_larger() -> None:
    random = np.random.default_rng(8)
    ratios = []
    for _ in range(trials(40, at_least=10)):
        state = random.normal(size=9) * np.repeat([2.0, 8.0, 20.0], 3)
        latest = begin(state)["piece"] * random.uniform(0.5, 1.0)
        state[5] = 0.5 * DEFAULTS["gravity"] * latest  # level again at the end: only the bow counts
        known = begin(state)
        latest = min(latest, known["piece"])
        box = run(program_of("enclosure"), known | {"horizon": latest})
        path = path_of(known, latest)
        for k in range(3):
            off = np.abs(path[:, k] - box[f"c{k}"])
            assert (off <= box[f"r{k}"] * (1 + 1e-12)).all()
            ratios.append(box[f"r{k}"] / off.max())
    assert np.median(ratios) < 1.1


@pytest.mark.slow
def test_a_piece_that_is_outside_of_a_plane_s_bounds_is_clear_of_it_and_no_other_is() -> None:
    random = np.random.default_rng(9)
    offset = DEFAULTS["ball_radius"] + DEFAULTS["wire_radius"]
    half, board = DEFAULTS["bridge_half_width"], DEFAULTS["board_distance"]
    crossing, cleared = 0, 0
    for _ in range(trials(400, at_least=120)):
        place = [random.uniform(-0.5, 0.2), random.uniform(-0.25, 0.25), offset + 0.02]
        state = np.array([*place, *random.normal(0.0, 1.0, 2), -2.0, 0.0, 10.0, 0.0])
        known = begin(state)
        clear = not run(program_of("bridge_open"), known | {"horizon": known["piece"]})["open"]
        path = path_of(known, known["piece"], 65)
        x, y, _ = path.T
        inside = (np.abs(y) <= half) & (x >= -board) & (x <= 0.0)
        crossing += bool(path[-1, 2] < offset and not inside.any())
        cleared += clear
        assert not (clear and inside.any())
    assert cleared >= 0.6 * crossing > 20


@pytest.mark.slow
def test_a_piece_that_stays_on_one_side_of_the_end_s_plane_is_clear_of_it_and_no_other_is() -> None:
    random = np.random.default_rng(10)
    beside, cleared = 0, 0
    for _ in range(trials(400, at_least=120)):
        level = -DEFAULTS["end_depth"] + random.normal(0.0, 0.05)
        climb = random.uniform(-2.0, 2.0)
        state = np.array([0.1, 0.2, level, 1.0, -0.5, climb, 0.0, 10.0, 0.0])
        known = begin(state)
        clear = not run(program_of("end_open"), known | {"horizon": known["piece"]})["open"]
        above = path_of(known, known["piece"], 65)[:, 2] > -DEFAULTS["end_depth"]
        crosses = (above[:-1] & ~above[1:]).any()  # downwards
        beside += not crosses
        cleared += clear
        assert not (clear and crosses)
    assert cleared >= 0.8 * beside > 20


@cache
def least_rate() -> Program:
    """Return the bound below the rate of the end's gap as a program."""
    (end,) = AIR.end_planes
    outputs = {"least": air_near.least_rate(end, SINGLE_SERIES)}
    made = kernel("least_rate", outputs, argument_order(AIR), "A rate.", "Taylor", single=True)
    return lower(made, AIR.symbols)


@pytest.mark.parametrize("density", [1.2, 60.0])
def test_a_plane_s_gap_opens_no_slower_than_its_bound_which_is_not_useless(density: float) -> None:
    random = np.random.default_rng(11)
    beside = []
    for _ in range(trials(60, at_least=20)):
        state = random.normal(size=9) * np.repeat([2.0, 5.0, 20.0], 3)
        known = begin(state, air_density=density)
        least = run(least_rate(), known | {"horizon": known["piece"]})["least"]
        times = np.linspace(0.0, known["piece"], 17)
        rates = [evaluate("flight", known | {"t": float(t)})["vz"] for t in times]
        assert least <= min(rates)
        beside.append(min(rates) - least)
    assert np.median(beside) < 0.1 * density**0.5


def test_sums_of_a_piece_s_sizes_are_bounded_and_the_bounds_are_near_to_them() -> None:
    random = np.random.default_rng(15)
    for first in (FIRST_SINGLE, ORDER + 1):
        for _ in range(10):
            rate = sp.Rational(1, int(random.integers(5, 12)))
            sizes = [sp.Rational(int(random.integers(1, 9))) * rate**k for k in range(ORDER + 1)]
            sums = [sp.Add(*sizes[k:]) for k in range(ORDER + 1)]
            products = sp.Add(
                *(
                    sizes[i] * sizes[j]
                    for i in range(ORDER + 1)
                    for j in range(ORDER + 1)
                    if i + j >= first
                )
            )
            half = release(air_piece.half_of_products(sizes, sums, first))
            assert products / 2 <= half < products
            for bound, weights in (
                (air_piece.counted(sums), range(ORDER + 1)),
                (air_piece.counted_twice(sums), [k * (k - 1) for k in range(ORDER + 1)]),
            ):
                exact = sp.Add(*(w * size for w, size in zip(weights, sizes, strict=True)))
                assert exact <= release(bound) < sp.Rational(5, 4) * exact


def test_a_flight_has_the_check_value_without_spin_and_smoothing() -> None:
    """The expected place is a check value of the equations of motion, given to 17 digits."""
    state = np.array([4.191, 0.0, -0.6096, -4.5, 0.0, 5.7, 0.0, 0.0, 0.0])
    left, pieces, error = 0.8, 0, 0.0
    while left > 0.0 and pieces < 30:
        known = begin(state, ball_radius=0.1213, drag_smoothing_speed=1e-9)
        time = min(left, known["piece"])
        found = evaluate("flight", known | {"t": time})
        left -= time
        error += known["piece_place_error"] + known["piece_speed_error"]
        state[:6] = [found[name] for name in NAMES]
        pieces += 1
    assert left == 0.0
    assert pieces < 15
    assert error < 1e-12
    assert abs(state[0] - 0.76222124628603537) < 1e-14
    assert abs(state[2] - 0.72679937946567789) < 1e-14


def test_nothing_is_proved_of_a_piece_that_is_longer_than_its_series() -> None:
    """At the apex of a vertical throw without smoothing the series has no radius."""
    state = np.array([0.0, 0.0, 1.0, 0.0, 0.0, 1e-6, 0.0, 0.0, 0.0])
    known = begin(state, drag_smoothing_speed=1e-6)
    assert known["piece"] == 2.0**-10
    assert known["unproved"] == math.inf
    assert known["tail_lost"] == math.inf
    assert all(known[symbol.name] == 0.0 for symbol in TAIL)
    assert begin(state)["unproved"] == 0.0
    assert begin(state)["tail_lost"] == 0.0


def test_nothing_is_proved_of_coefficients_that_do_not_fit_into_single_precision() -> None:
    """The speed's coefficients are too large, and the drag is so small that all else is proved."""
    state = np.array([0.0, 0.0, 1.0, 4e6, 0.0, 4e5, 0.0, 0.0, 0.0])
    known = begin(state, gravity=1e9, air_density=1e-12)
    assert known["tail_lost"] == known["unproved"] == math.inf


def test_the_defaults_are_the_same_where_they_are_read_without_sympy() -> None:
    assert {p.name: p.default for p in AIR_PARAMETERS} == AIR_DEFAULTS
