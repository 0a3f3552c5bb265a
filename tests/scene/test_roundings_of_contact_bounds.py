"""Bounds of points of contact as computed, against 50 digits: random bodies, balls that touch."""

from __future__ import annotations

import operator
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.ir.kernel import Kernel, kernel
from hoopgen.derive.surfaces import Surface, at_contact
from hoopgen.derive.symbolic.symbols import POSITION
from numpy.typing import NDArray

from hoopgen.codegen.identifiers import identifier
from hoopgen.codegen.program import lower
from tests.helpers.derived import evaluation
from tests.scene.test_contact_bounds import SCENES

Floats = NDArray[np.float64]

ROWS = 300
UNIT = 2.0**-53
CLAIM = 4 * UNIT
"""The share of the sum of all lengths by which a decision allows a bound to be off."""

WAY, MIDDLE = sp.symbols("nx ny nz", real=True), sp.symbols("mx my mz", real=True)
FLAT, ROUND = sp.symbols("flat round", real=True)
GIVEN = (
    sp.Add(*(n * place for n, place in zip(WAY, POSITION, strict=True))) - FLAT,
    sp.Add(*((place - m) ** 2 for place, m in zip(POSITION, MIDDLE, strict=True))) - ROUND,
)
"""A half-space and a ball about any point."""

EXACT: dict[str, Callable[..., Any]] = {
    "add": operator.add,
    "sub": operator.sub,
    "mul": operator.mul,
    "div": operator.truediv,
    "neg": operator.neg,
    "sqrt": mpmath.sqrt,
    "abs": abs,
    "max": max,
    "min": min,
    "less": operator.lt,
    "at_most": operator.le,
    "select": lambda holds, then, other: then if holds else other,
}
FACES = {
    **{name: (name, 0) for name in ("ring", "hoop", "cup", "hat", "crate", "paddle")},
    "disc": ("funnel", 0),
    "wall": ("funnel", 2),
    "edge": ("funnel", 5),
}
"""The scene and the number of a face of each kind."""


def face_of(which: str) -> tuple[Surface, sp.Symbol, dict[str, str]]:
    """Return a face, the ball's radius, and the units of its scene's parameters."""
    name, number = FACES[which]
    body = replace(SCENES[name].bodies[0], within=["x"])
    derived = replace(SCENES[name], bodies=[body]).derive()
    units = {p.name: p.unit for p in derived.parameters}
    return derived.bodies[0].faces[number], derived.ball_radius, units


def random_sizes(names: list[str], units: dict[str, str], seed: int) -> dict[str, Floats]:
    """Return sizes of about one scale, or of many, and any directions."""
    chance = np.random.default_rng(seed)
    scales = chance.choice([0.1, 1.0], ROWS)

    def size() -> Floats:
        return np.asarray(10 ** (scales * chance.uniform(-2.5, 0.5, ROWS)))

    values = {
        name: size() if units[name] == "m" or name.endswith("slope") else chance.normal(0, 1, ROWS)
        for name in names
    }
    for name in names:
        if name.endswith(("_x", "_y", "_z")) and units[name] == "m" and "half" not in name:
            values[name] *= chance.choice([-1, 1], ROWS)
    for name in names:
        if "_to_" in name:
            values[name] = values[name.replace("_to_", "_from_")] + size()
    for what in ("direction", "orientation"):
        parts = [name for name in names if f"_{what}_" in name]
        length = np.sqrt(sum((values[name] ** 2 for name in parts), np.zeros(ROWS)))
        values |= {name: values[name] / length for name in parts}
    return values


@dataclass(frozen=True)
class Formulas:
    """Formulas of a face as they are computed: in doubles, and operation by operation to 50 digits.

    Attributes
    ----------
    outputs
        The formulas by name.
    """

    outputs: dict[str, sp.Expr]

    @cached_property
    def _kernel(self) -> Kernel:
        symbols = set().union(*(sp.sympify(e).free_symbols for e in self.outputs.values()))
        return kernel("sample", self.outputs, sorted(symbols, key=str), "A sample.", "Table 2")

    def rounded(self, values: dict[str, Floats]) -> Floats:
        """Return the outputs in doubles, (k, n)."""
        run = evaluation(self._kernel, self._kernel.arguments)
        found = run(*(values[str(symbol)] for symbol in self._kernel.arguments))
        return np.array([np.broadcast_to(out, ROWS) for out in found])

    def errors(self, values: dict[str, Floats]) -> Floats:
        """Return by how much the first output is off in doubles, (n,)."""
        arguments = self._kernel.arguments
        program = lower(self._kernel, arguments)
        own = {identifier(symbol): values[str(symbol)] for symbol in arguments}
        rounded, off = self.rounded(values)[0], np.empty(ROWS)
        with mpmath.workdps(50):
            for row in range(ROWS):
                done: list[Any] = []
                for operation in program.operations:
                    if operation.name == "argument":
                        done.append(mpmath.mpf(float(own[operation.symbol][row])))
                    elif operation.name == "constant":
                        done.append(mpmath.mpf(float(operation.value)))
                    else:
                        operands = (done[operand] for operand in operation.operands)
                        done.append(EXACT[operation.name](*operands))
                off[row] = abs(done[program.outputs[0]] - mpmath.mpf(float(rounded[row])))
        return off


@pytest.mark.sampled(1)
@pytest.mark.parametrize("which", FACES)
def test_a_bound_of_contacts_is_off_by_no_more_than_a_decision_allows(which: str) -> None:
    """Nor is that two thousand times too much: the roundings are counted as if none cancelled."""
    face, ball, units = face_of(which)
    touching = {"distance": face.distance}
    touching |= {f"n{k}": part for k, part in enumerate(face.normal)}
    symbols = set().union(*(sp.sympify(e).free_symbols for e in touching.values()))
    names = sorted(str(symbol) for symbol in {*symbols, ball} - set(POSITION))
    values = random_sizes(names, units, 1)
    chance = np.random.default_rng(2)
    # Newton's method takes random places near the body to where the ball touches it.
    size = 10 ** chance.uniform(-2, 0.5, (3, ROWS))
    centre = Formulas(dict(zip("abc", map(sp.sympify, face.reference_point), strict=True)))
    place = centre.rounded(values) + size * chance.normal(0, 1, (3, ROWS))
    touch = Formulas(touching)
    for _ in range(4):
        away, *normal = touch.rounded(values | dict(zip("xyz", place, strict=True)))
        place = place - away * np.array(normal) / (1e-300 + np.linalg.norm(normal, axis=0))
    values |= dict(zip("xyz", place, strict=True))
    away, *normal = touch.rounded(values)
    scale = np.abs(place).sum(axis=0) + sum(np.abs(values[n]) for n in names if units[n] == "m")
    found = np.abs(away) < 1e-9 * scale
    point = place - values["ball_radius"] * np.array(normal)
    way = chance.normal(0, 1, (3, ROWS))
    way /= 1.001 * np.linalg.norm(way, axis=0)
    middle = point + 10 ** chance.uniform(-2, 1, ROWS) * chance.normal(0, 1, (3, ROWS))
    values |= dict(zip(map(str, WAY), way, strict=True))
    values |= dict(zip(map(str, MIDDLE), middle, strict=True))
    values["flat"] = np.sum(way * point, axis=0)
    values["round"] = np.sum((point - middle) ** 2, axis=0)
    sizes = {"flat": np.abs(values["flat"]), "round": np.abs(middle).sum(axis=0)}
    most = 0.0
    for given, own in zip(GIVEN, sizes, strict=True):
        (bound,) = at_contact([given], face, ball)
        share = Formulas({"g": bound}).errors(values) / (CLAIM * (scale + sizes[own]))
        most = max(most, float(share[found].max()))
    assert 0.0005 < most <= 1.0
    assert found.sum() > ROWS / 2
