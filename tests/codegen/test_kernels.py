"""Every generated kernel against its expressions at 50 digits, and NumPy against C, bit for bit."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.errors.contact_frames import LEFT_TANGENT, TANGENT
from hoopgen.derive.errors.tighter_bounds import PRODUCT
from hoopgen.derive.events.ring.single import MAX_STEPS
from hoopgen.derive.ir.kernel import Kernel
from hoopgen.derive.model import Model, build
from hoopgen.derive.scenes.hoop import HOOP
from hoopgen.derive.symbolic.conditionals import (
    And,
    AtMost,
    Barrier,
    Boolean,
    Choose,
    Condition,
    Equal,
    False_,
    IfAtMost,
    IfLess,
    Less,
    Not,
    Or,
    release,
)
from hoopgen.generated.numpy import hoop
from mpmath import mp, mpf

from hoopgen.codegen.identifiers import identifier
from tests.helpers.compiled import WIDTHS, CKernels, Floats, needs_compiler, same_bits
from tests.helpers.effort import EFFORT, trials
from tests.helpers.past_ring import begun, flights, leap

# One worker: the derivation takes a few seconds.
pytestmark = pytest.mark.xdist_group("kernels")

DIGITS = 50
UNIT_ROUNDOFF, UNIT_ROUNDOFF_OF_SINGLES = mpf(2) ** -53, mpf(2) ** -24
NAMES = tuple(hoop.OUTPUTS)
ROWS = trials(200, at_least=110)
"""Rows at which kernels are compared with 50 digits: what is put into rows is within 110."""

RARELY_MET = {
    "ring_prepare": 2,
    "ring_opened": 1,
    "ring_nearness": 1,
    "plane_start": 2,
    "ring_tangents": 1,
}
"""Choices of which random rows meet one side only: windows whose pads overlap, a flight through the
very axis, an undecided start at a plane, and a root with less left of Newton's method than
roundings."""

UNBOUNDED = ("parameters_in_range", "state_in_range", "limited", "opening", "unbounded")
"""Kernels that ask whether their arguments are finite, or of sizes within a range."""

EXTREMES = [0.0, -0.0, 5e-324, -5e-324, 2.5e-308, 1e-150, -1e-150, 1e150, -1e150]
EXTREMES += [1e-45, -1e-40, 1e-20, -3e38, 1 + 2.0**-23]  # of single precision
EXTREMES += [1.7e308, -1.7e308, np.inf, -np.inf, np.nan, 1.0, -1.0, 0.1, -3.0, 1 + 2.0**-52]


# The evaluation at 50 digits


@dataclass(frozen=True)
class Exactly:
    """A value, and how far any evaluation in doubles, or in singles, can be from it.

    The bound is the running error: each operation adds one relative rounding of at most u = 2^-53,
    of singles 2^-24, to what its operands carry, and a sum of n terms, in any order, at most
    (1 + u)^(n-1) - 1 of the sum of the terms' sizes. It holds for every program that computes the
    expression as written, without underflow; a choice that the errors of its sides could turn is
    bounded by both its branches. Infinite: nothing is known.

    `source` is the number of the expression that was computed, where a choice passed it on: equal
    expressions have equal values, whatever their errors.
    """

    value: mpf
    error: mpf = field(default_factory=lambda: mpf(0))
    source: int = field(default=-1, compare=False)

    @property
    def size(self) -> mpf:
        """The largest magnitude that the computed value can have."""
        return abs(self.value) + self.error

    @property
    def least(self) -> mpf:
        """The smallest."""
        return max(abs(self.value) - self.error, mpf(0))


class Evaluator:
    """Evaluates SymPy expressions as they stand, each shared part once.

    Parameters
    ----------
    inputs
        Value of each symbol, by name.
    single
        Whether all is rounded to single precision, the inputs first.

    Attributes
    ----------
    unit
        The unit roundoff.
    sides
        The choices that were met, and whether each one's condition held.
    """

    def __init__(self, inputs: Mapping[str, float], single: bool = False) -> None:
        self._inputs = inputs
        self._rounded: type[np.floating[Any]] = np.float32 if single else np.float64
        self.unit = UNIT_ROUNDOFF_OF_SINGLES if single else UNIT_ROUNDOFF
        self._known: dict[sp.Basic, Exactly] = {}
        self.sides: dict[sp.Basic, bool] = {}

    def __call__(self, expression: sp.Basic) -> Exactly:
        """Return value and error bound of an expression."""
        if expression not in self._known:
            found = self._evaluate(expression)
            if found.source < 0:
                found = replace(found, source=len(self._known))
            self._known[expression] = found
        return self._known[expression]

    def _evaluate(self, e: sp.Basic) -> Exactly:
        if isinstance(e, Boolean):
            return Exactly(mpf(int(bool(self._inputs[e.name]))))
        if e.is_Symbol:
            return Exactly(self._given(float(self._inputs[e.name])))
        if e.is_Number:
            return self._number(e)
        if isinstance(e, Barrier):
            return self(e.args[0])
        if isinstance(e, sp.Abs):
            inner = self(e.args[0])
            return Exactly(abs(inner.value), inner.error)
        if e.is_Pow:
            return _power(self(e.base), Fraction(int(e.exp.p), int(e.exp.q)), self.unit)
        parts = [self(argument) for argument in e.args]
        if e.is_Add:
            return _sum(parts, self.unit)
        if e.is_Mul:
            return _product(parts, self.unit)
        if isinstance(e, IfLess | IfAtMost):
            left, right, then, other = parts
            self.sides[e] = _holds(IfLess if isinstance(e, IfLess) else IfAtMost, left, right)
            return _choice(self.sides[e], _sure(left, right), then, other)
        if isinstance(e, Choose):
            condition, then, other = parts
            self.sides[e] = condition.value == 1
            return _choice(self.sides[e], condition.error == 0, then, other)
        if isinstance(e, Condition):
            return self._condition(e, parts)
        raise TypeError(type(e).__name__)

    def _given(self, value: float) -> mpf:
        """Return the number that a kernel has for a double."""
        with np.errstate(over="ignore"):
            return mpf(float(self._rounded(value)))

    def _number(self, e: sp.Number) -> Exactly:
        if not e.is_finite:
            return Exactly(mp.inf if e > 0 else -mp.inf)
        value = Fraction(str(sp.Rational(e)))
        exact = mpf(value.numerator) / value.denominator
        return Exactly(exact, abs(self._given(float(value)) - exact))

    def _condition(self, e: sp.Basic, parts: list[Exactly]) -> Exactly:
        """Return 1 where a condition holds, else 0; not sure if its error is not zero."""
        if isinstance(e, Less | AtMost | Equal):
            self.sides[e] = _holds(type(e), *parts)
            sure = _sure(*parts)
        elif isinstance(e, False_):
            return Exactly(mpf(0))
        elif isinstance(e, And | Or):
            values = [part.value == 1 for part in parts]
            decisive = isinstance(e, Or)
            self.sides[e] = any(values) if decisive else all(values)
            settled = any(
                v == decisive and p.error == 0 for v, p in zip(values, parts, strict=True)
            )
            sure = settled or all(part.error == 0 for part in parts)
        else:
            self.sides[e] = isinstance(e, Not) and parts[0].value == 0
            sure = all(part.error == 0 for part in parts)
        return Exactly(mpf(int(self.sides[e])), mpf(0) if sure else mp.inf)


def _finite(*parts: Exactly) -> bool:
    return all(mp.isfinite(part.value) for part in parts)


def _sum(parts: list[Exactly], unit: mpf) -> Exactly:
    value = mp.fsum(part.value for part in parts)
    if not _finite(*parts):
        return Exactly(value)
    parts = [part for part in parts if part.size > 0]  # to add zero is exact
    if len(parts) == 1:
        return parts[0]
    grown = (1 + unit) ** max(len(parts) - 1, 0) - 1
    return Exactly(value, sum(p.error for p in parts) + grown * sum(p.size for p in parts))


def _product(parts: list[Exactly], unit: mpf) -> Exactly:
    value = mp.fprod(part.value for part in parts)
    if not _finite(*parts):
        return Exactly(value)
    grown = (1 + unit) ** (len(parts) - 1)
    return Exactly(value, grown * mp.fprod(part.size for part in parts) - abs(value))


def _power(base: Exactly, exponent: Fraction, unit: mpf) -> Exactly:
    half = exponent.denominator == 2
    if half and base.value < 0:
        return Exactly(mp.nan, mpf(0) if base.error < -base.value else mp.inf)
    if exponent < 0 and base.value == 0:
        return Exactly(mp.inf, mpf(0) if base.error == 0 else mp.inf)
    value = base.value ** (mpf(exponent.numerator) / exponent.denominator)
    if not _finite(base):
        return Exactly(value)
    if base.error > 0 and base.least == 0 and (half or exponent < 0):
        return Exactly(value, mp.inf)
    # Products, one root, one division: the exponent's size bounds what they multiply u by.
    grown = (1 + unit) ** (abs(exponent) // 1 + half + (exponent < 0))
    power = mpf(exponent.numerator) / exponent.denominator
    ends = base.size**power, (base.least**power if base.least or power > 0 else mpf(0))
    upper, lower = max(ends) * grown, min(ends) / grown
    turned = base.error > abs(base.value) and exponent.numerator % 2 == 1
    lower = -upper if turned else lower
    return Exactly(value, max(upper - abs(value), abs(value) - lower))


def _holds(kind: type, left: Exactly, right: Exactly) -> bool:
    a, b = left.value, right.value
    if mp.isnan(a) or mp.isnan(b):
        return False
    if issubclass(kind, Equal):
        return bool(a == b)
    return bool(a < b if issubclass(kind, Less | IfLess) else a <= b)


def _sure(left: Exactly, right: Exactly) -> bool:
    """Return whether the errors of two sides leave their comparison as it is."""
    if left.source == right.source and mp.isfinite(left.error):
        return True  # a NaN of finite error is one for certain
    errors = left.error + right.error
    # Equal infinities are not apart; a NaN is, unless its operand's error could undo it.
    apart = 0 if left.value == right.value else abs(left.value - right.value)
    return bool(errors == 0 or (mp.isfinite(errors) and not apart <= errors))


def _choice(holds: bool, sure: bool, then: Exactly, other: Exactly) -> Exactly:
    chosen, left_out = (then, other) if holds else (other, then)
    if sure or chosen == left_out:
        return chosen
    if not _finite(chosen, left_out):
        return Exactly(chosen.value, mp.inf)
    reach = abs(chosen.value - left_out.value) + left_out.error
    return Exactly(chosen.value, max(chosen.error, reach))


# The kernels, and where they are evaluated


@cache
def model() -> Model:
    """Return the hoop's kernels, derived anew."""
    return build(HOOP)


def derived(name: str) -> Kernel:
    """Return a kernel by name."""
    return next(kernel for kernel in model().kernels if kernel.name == name)


def evaluate_numpy(name: str, columns: Mapping[str, Floats], rows: int) -> list[Floats]:
    """Return the outputs of a generated NumPy kernel, each of shape (rows,)."""
    function = getattr(hoop, name)
    with np.errstate(all="ignore"):
        outputs = function(*(columns[argument] for argument in arguments(function)))
    return [np.broadcast_to(np.asarray(o, np.float64), (rows,)) for o in outputs]


def arguments(function: Callable[..., Any]) -> list[str]:
    """Return the names of a kernel's arguments, of parameters the public ones."""
    public = {own: name for name, own in hoop.VARIABLES.items()}
    return [public.get(name, name) for name in hoop.ARGUMENTS[function.__name__]]


def all_arguments() -> list[str]:
    """Return the names of all kernels' arguments."""
    return list(dict.fromkeys(a for name in NAMES for a in arguments(getattr(hoop, name))))


def random_columns(seed: int, rows: int) -> dict[str, Floats]:
    """Return a column for every argument of any kernel: flights about a hoop of any make.

    What one kernel passes to another (constants of the search, margins) is what it computes. Some
    rows are of the kind that validity or the guards of a search are there for.
    """
    rng = np.random.default_rng(seed)
    columns: dict[str, Floats] = {}
    for name, (default, _, _) in hoop.PARAMETERS.items():
        columns[name] = default * rng.uniform(0.8, 1.25, rows)
    for k, name in enumerate(hoop.PARAMETERS):
        columns[name][2 + 3 * k] *= -1
    columns["restitution"][::30] += 1
    columns["gravity"][6::40] *= 2.0**-40
    columns["wire_radius"][::30] += columns["ring_radius"][::30]
    # Half of the flights start at any place near or far, half are shots that come down at the hoop.
    start = rng.choice([0.3, 3.0], (rows, 1)) * rng.normal(0, 1, (rows, 3))
    start[: rows // 2, 0] += 3.0
    way = rng.normal(0, 4, (rows, 3))
    arrival = rng.uniform(0.4, 1.2, rows)
    goal = rng.normal(0, 0.2, (rows, 3)) - start
    goal[:, 2] += columns["gravity"] * arrival**2 / 2
    way[: rows // 2] = (goal / arrival[:, None])[: rows // 2]
    way[::20, :2] = 0
    start[1::20] *= 2.0**20
    start[4::8] = _touching(columns, *rng.uniform(0, 1, (3, rows)))[4::8]
    spin = rng.normal(0, 20, (rows, 3))
    state = np.hstack([start, way, spin])
    columns |= zip(("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz"), state.T, strict=True)
    normal = rng.normal(0, 1, (3, rows))
    columns |= zip(("nx", "ny", "nz"), normal / np.linalg.norm(normal, axis=0), strict=True)
    columns |= _asked(seed, rows)
    columns["leaving"] = rng.choice([0.0, 1.0], rows)
    columns["last"] = rng.integers(-1, len(hoop.BODIES) + 1, rows).astype(float)
    columns["rate"] = rng.normal(-2, 2, rows)
    columns["rate"][::9] = 0.0
    erring = 10 ** rng.uniform(-20, -12, rows)
    for name in all_arguments():
        if re.fullmatch(r"n[123][123]|d[vwn]?[xyz]", name):
            size = erring if name[0] == "d" else 1
            columns[name] = size * rng.uniform(-1, 1, rows)
        elif name in ("shift", "turn"):
            columns[name] = erring * rng.uniform(0, 1, rows)
        elif name == "margin" or name.endswith("_error"):
            columns[name] = 1e-15 * rng.uniform(0, 1, rows)
        elif name in ("t", "horizon", "end", "delay", "clock"):
            columns[name] = arrival * rng.uniform(0, 1.2, rows)
    columns |= _passed_on(rng, rows, arrival)
    columns["position_error"][3::20] = 1.0
    columns["end"] += columns["t"]
    columns |= _rarely(seed, columns)
    for name in NAMES:
        for argument in arguments(getattr(hoop, name)):
            # Whatever it is, it may be of the size of a length or of an error.
            size = rng.choice([1.0, 1e-15], rows)
            columns.setdefault(argument, size * rng.uniform(0.1, 2, rows))
        outputs = evaluate_numpy(name, columns, rows)
        for output, column in zip(hoop.OUTPUTS[name], outputs, strict=True):
            columns.setdefault(output, np.array(column))
    return columns


def _passed_on(rng: np.random.Generator, rows: int, arrival: Floats) -> dict[str, Floats]:
    """Return what the event loop passes from decision to decision."""
    truths = {a.name for k in model().kernels for a in k.arguments if isinstance(a, Boolean)}
    columns = {name: rng.choice([0.0, 1.0], rows) for name in sorted(truths)}
    for name in ("which", "index", "first", "outcome"):
        columns[name] = rng.integers(-1, 4, rows).astype(float)
    own = np.random.default_rng(rows)  # so that the others stay as they are
    for name in ("uncertain", "contacts", "tightening", "continued"):
        columns[name] = own.integers(0, 2, rows).astype(float)
    # Factors of products of matrices, which with the size of errors would underflow in singles.
    for symbol in (*PRODUCT, *TANGENT, *LEFT_TANGENT):
        columns[symbol.name] = own.choice([-1, 1], rows) * own.uniform(0.1, 2, rows)
    for name in (
        "when",
        "time",
        "undecided_time",
        "arrival",
        "apex",
        "low0",
        "low1",
        "low2",
        "after",
    ):
        columns[name] = rng.choice([arrival, rng.normal(0, 1, rows), np.full(rows, np.inf)])
        columns[name][::5] = arrival[::5]
        columns[name][1::5] = rng.normal(0, 1, len(columns[name][1::5]))
        columns[name][2::35] = np.inf
    for name in (
        "excess",
        "budget_exceeded",
        "bend",
        "height",
        "gap",
        "clearance",
        "clear",
        "miss",
        "slack",
    ):
        columns[name] = rng.normal(0, 1, rows)
    for name in ("g0", "g1", "g2", "g3", "g4", "valid", "allowed"):
        columns[name] = rng.choice([-2.0, -0.1, 0.1], rows, p=[0.5, 0.4, 0.1])
    for name in ("claims", "share"):
        columns[name] = rng.choice([0.0, 2.0**-45, 2.0**-30, 1.0], rows)
    columns["height"][::7] = 0.0
    columns["time"][::9] = 0.0
    return columns


def _asked(seed: int, rows: int) -> dict[str, Floats]:
    """Return what studies ask of: points aimed at, some of them out of reach, heights, places."""
    rng = np.random.default_rng((seed, rows))
    return {
        "slope": rng.uniform(0.2, 3, rows),
        "entry": rng.uniform(0, 3, rows),
        "release_speed": rng.uniform(5, 12, rows),
        "reach": rng.uniform(0.5, 10, rows),
        "rise": rng.normal(0.5, 1, rows),
        "level": rng.normal(0, 1, rows),
        "half": 10 ** rng.uniform(-4, 0, rows),
        "place_x": rng.normal(0, 5, rows),
        "place_y": rng.normal(0, 5, rows),
    }


def _rarely(seed: int, columns: Mapping[str, Floats]) -> dict[str, Floats]:
    """Return what decides whether single precision serves, a few of each beyond what it bears."""
    rng = np.random.default_rng((seed, 2))
    rows = len(columns["t"])
    rarely = {name: rng.normal(0, 2, rows) for name in ("start_rate", "rho_rate")}
    for name, sizes in (("extent", "xyz"), ("speed", ("vx", "vy", "vz"))):
        rarely[name] = sum((np.abs(columns[size]) for size in sizes), np.zeros(rows))
    rarely["speed"][7::50] *= 2.0**13
    rarely["ring_radius"], rarely["gravity"] = columns["ring_radius"], columns["gravity"]
    rarely["ring_radius"][8::50] *= 2.0**15
    rarely["gravity"][9::50] *= 2.0**10
    # On its way out of the ring, which it came into from above.
    outward = {"x": rarely["ring_radius"], "vx": 3.0, "y": 0.0, "vy": 0.1, "z": 0.0, "vz": -3.0}
    for name, given in outward.items():
        rarely[name] = columns[name].copy()
        rarely[name][11::50] = np.broadcast_to(given, rows)[11::50]
    rarely["lasting"] = np.where(rng.random(rows) < 0.2, np.inf, rng.uniform(0, 1, rows))
    return rarely


def _touching(
    parameters: Mapping[str, Floats], choice: Floats, side: Floats, depth: Floats
) -> Floats:
    """Return positions (rows, 3) of balls that touch a surface of the hoop or are inside it."""
    reach = parameters["ball_radius"] + parameters["wire_radius"]
    board, ring = parameters["board_distance"], parameters["ring_radius"]
    depth = np.where(depth < 0.5, 0.0, -0.1 * depth)
    on_board = [parameters["ball_radius"] - board + depth, side, side / 2]
    on_bridge = [-board + 0.1 * side, 0.01 * side, reach + depth]
    on_ring = [ring, 0 * side, reach + depth]
    return np.transpose(np.select([choice < 0.3, choice < 0.6], [on_board, on_bridge], on_ring))


def leaping_columns(seed: int, rows: int) -> dict[str, Floats]:
    """Return columns of which the search in single precision has what it is given.

    A third of the flights have come as far as it gets; of the others half are where it begins.
    """
    rng = np.random.default_rng((seed, 3))
    columns = random_columns(seed, rows)
    ordinary = {
        name: default * rng.uniform(0.8, 1.25, rows)
        for name, (default, _, _) in hoop.PARAMETERS.items()
    }
    ordinary["wire_radius"][::30] += ordinary["ring_radius"][::30]
    columns |= ordinary | flights(seed, rows, ordinary)
    columns |= begun(hoop, columns)
    came, _ = leap(hoop, columns, MAX_STEPS)
    on_its_way = rng.choice([0.0, 1.0], rows) * rng.uniform(0, 1, rows)
    columns["t"] = on_its_way * columns["end"]
    columns["t"][::50] = columns["end"][::50]
    columns["t"][1::3] = np.where(np.isfinite(came["t"]), came["t"], 0.0)[1::3]
    return columns


def dropping_columns(seed: int, rows: int) -> dict[str, Floats]:
    """Return columns of which most are a swish's but for one number."""
    rng = np.random.default_rng((seed, 4))
    columns = random_columns(seed, rows)
    swish = {"x": 4.191, "y": 0.01, "z": -0.6096, "vx": -4.4, "vy": 0.0, "vz": 5.31}
    swish |= {"horizon": 0.9583, "extent": 4.8106, "speed": 9.71}
    swish |= {"position_error": 0.0, "velocity_error": 0.0}
    own = rng.integers(0, 2 * len(swish), rows)
    for k, (name, value) in enumerate(swish.items()):
        usual = value * (1 + 0.001 * rng.uniform(-1, 1, rows))
        usual = np.where(own == k, value * rng.uniform(0.5, 1.5, rows), usual)
        columns[name][1::2] = usual[1::2]
    for name, (default, _, _) in hoop.PARAMETERS.items():
        columns[name][1::2] = default
    columns["position_error"][5::40] = 1e-4
    columns["extent"][7::40] = 100.0
    columns["ring_radius"][9::40] = 0.1
    return columns


def extreme_columns(seed: int, rows: int) -> dict[str, Floats]:
    """Return columns of extreme values, with ordinary ones between them."""
    rng = np.random.default_rng(seed)
    columns = random_columns(seed, rows)
    for name, column in columns.items():
        extreme = rng.random(rows) < rng.choice([0.1, 0.5, 1.0], rows)
        columns[name] = np.where(extreme, rng.choice(EXTREMES, rows), column)
    return columns


@pytest.fixture(scope="module")
def c_kernels(tmp_path_factory: pytest.TempPathFactory) -> Callable[[int], CKernels]:
    from tests.codegen.test_generation import printed  # which imports this file

    header = printed("c/kernels.h.j2", list(model().kernels))
    folder = tmp_path_factory.mktemp("kernels")
    names = tuple(map(identifier, model().scene.symbols))
    return cache(lambda width: CKernels(header, model().kernels, "hoop", folder, width, names))


# The tests


def test_each_derived_kernel_is_generated_with_its_arguments_and_outputs() -> None:
    assert tuple(kernel.name for kernel in model().kernels) == NAMES
    for kernel in model().kernels:
        assert arguments(getattr(hoop, kernel.name)) == [s.name for s in kernel.arguments]
        assert hoop.OUTPUTS[kernel.name] == kernel.output_names


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    "name", ["flight", "impact", "end_bounds", "ring_coefficients", "ring_normal"]
)
def test_the_evaluator_agrees_with_sympy(name: str) -> None:
    """Its 50 digits are those of SymPy's evalf, but for the last few."""
    columns = random_columns(2, ROWS)
    for row in (50, 100, ROWS - 1):
        inputs = {argument: float(column[row]) for argument, column in columns.items()}
        with mp.workdps(DIGITS):
            evaluator = Evaluator(inputs)
            for expression in derived(name).expressions:
                numbers = {s: sp.Rational(inputs[s.name]) for s in expression.free_symbols}
                exact = release(expression).subs(numbers).evalf(DIGITS)
                exact = mpf(sp.Float(exact, DIGITS)._mpf_)  # a zero is no Float
                found = evaluator(expression)
                scale = found.error / UNIT_ROUNDOFF  # of the largest intermediate value
                assert abs(found.value - exact) <= scale * mpf(10) ** (5 - DIGITS)


def test_the_evaluator_chooses_as_ieee_754_does() -> None:
    a, b = sp.symbols("a b", real=True)
    evaluator = Evaluator({"a": 1.0, "b": 2.0})
    root = sp.sqrt(a - b)
    assert evaluator(IfLess(a, b, a, b)).value == 1
    assert evaluator(IfLess(b, a, a, b)).value == 2
    assert evaluator(IfLess(a, a + 0, b, a)).value == 1
    assert evaluator(IfAtMost(a, 2 * a - a, b, a)).value == 2
    assert evaluator(IfAtMost(root, a, a, b)).value == 2, "a comparison with NaN does not hold"
    assert evaluator(IfLess(a, sp.oo, Barrier(a + b), -sp.oo)).value == 3
    assert mp.isnan(evaluator(root).value)


@pytest.mark.sampled(6)
@pytest.mark.parametrize("name", NAMES)
def test_numpy_is_as_near_to_fifty_digits_as_its_roundings_allow(name: str) -> None:
    """Each output is within the running-error bound of its expression: no operation is wrong.

    An infinite or undefined value is the same one. The bound is rigorous, so there is no factor.
    """
    special = {"ring_step": leaping_columns, "ring_drops_through": dropping_columns}
    columns = special.get(name, random_columns)(1, ROWS)
    if name in UNBOUNDED:
        for k, argument in enumerate(arguments(getattr(hoop, name))):
            columns[argument][3 + k] = np.inf
            columns[argument][-1 - k] = 2.0**-40
    kernel, outputs = derived(name), evaluate_numpy(name, columns, ROWS)
    bounds = []
    seen: dict[sp.Basic, set[bool]] = {}
    for row in range(ROWS):
        with mp.workdps(DIGITS):
            inputs = {a: column[row] for a, column in columns.items()}
            evaluator = Evaluator(inputs, kernel.single)
            for (output, expression), column in zip(kernel.outputs, outputs, strict=True):
                exact, computed = evaluator(expression), mpf(float(column[row]))
                bounds.append(exact.error / (abs(exact.value) * evaluator.unit or 1))
                if exact.error == mp.inf:
                    continue  # rounding errors decide a choice, or the sign below a root
                if not mp.isfinite(exact.value):
                    assert repr(computed) == repr(exact.value), output
                    continue
                assert abs(computed - exact.value) <= exact.error, (
                    f"{name}: {output} = {computed} for {mp.nstr(exact.value, 20)}, off by "
                    f"{mp.nstr(abs(computed - exact.value) / exact.error, 3)} of its bound"
                )
            for choice, side in evaluator.sides.items():
                seen.setdefault(choice, set()).add(side)
    # The bound would prove little if it were wide or open, or if a branch were never taken.
    assert sum(bound < 64 for bound in bounds) > len(bounds) / 2
    if EFFORT == 1:  # other efforts draw other numbers, among which some may be missing
        assert sum(bound == mp.inf for bound in bounds) < 0.01 * len(bounds)
        one_sided = [choice for choice, sides in seen.items() if len(sides) == 1]
        assert len(one_sided) <= RARELY_MET.get(name, 0)


@pytest.mark.slow
@needs_compiler
@pytest.mark.parametrize("columns_of", [random_columns, leaping_columns, extreme_columns])
@pytest.mark.parametrize("width", WIDTHS)
def test_c_gives_the_bits_of_numpy(
    c_kernels: Callable[[int], CKernels],
    width: int,
    columns_of: Callable[[int, int], dict[str, Floats]],
) -> None:
    """Inputs are ordinary ones, zeros of both signs, denormals, 1e±150, infinities and NaN."""
    rows = trials(3001, at_least=201)
    columns = columns_of(3, rows)
    for name in NAMES:
        names = arguments(getattr(hoop, name))
        numpy = evaluate_numpy(name, columns, rows)
        c = c_kernels(width)(name, [columns[argument] for argument in names], rows)
        for output, left, right in zip(hoop.OUTPUTS[name], numpy, c, strict=True):
            differ = np.flatnonzero(~same_bits(left, right))
            assert not len(differ), (
                f"{name}: {output} is {left[differ[0]]!r} in NumPy, {right[differ[0]]!r} in C, for "
                f"{ {argument: columns[argument][differ[0]] for argument in names} }"
            )


@pytest.mark.sampled(6)
@pytest.mark.parametrize("name", NAMES)
def test_numbers_and_arrays_give_the_same_bits(name: str) -> None:
    """A parameter that all shots share is a number there; nothing else changes."""
    rows = 50
    columns = random_columns(4, rows)
    function = getattr(hoop, name)
    for row in range(rows):
        shared = {p: float(columns[p][row]) for p in hoop.PARAMETERS}
        mixed = evaluate_numpy(name, columns | shared, rows)
        full = evaluate_numpy(
            name, columns | {p: np.full(rows, v) for p, v in shared.items()}, rows
        )
        for left, right in zip(mixed, full, strict=True):
            assert same_bits(left, right).all(), function


@pytest.mark.parametrize("columns_of", [random_columns, extreme_columns])
def test_rows_to_write_into_do_not_change_a_bit(
    columns_of: Callable[[int, int], dict[str, Floats]],
) -> None:
    """Nothing is read from them that is not written before, and no result is left in them."""
    rows, met = hoop.FEW + 1, 0
    columns = columns_of(5, rows)
    for shared in ({}, {name: default for name, (default, _, _) in hoop.PARAMETERS.items()}):
        given = columns | shared
        for name in NAMES:
            function = getattr(hoop, name)
            if "_room" not in inspect.signature(function).parameters:
                continue
            met += 1
            room = np.full((hoop.ROWS, rows), np.nan)
            with np.errstate(all="ignore"):
                inside = function(*(given[a] for a in arguments(function)), tuple(room))
            room[:] = np.nan
            for output, wanted in zip(inside, evaluate_numpy(name, given, rows), strict=True):
                assert same_bits(np.broadcast_to(output, (rows,)), wanted).all(), name
    assert met > 20
