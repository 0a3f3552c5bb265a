"""Terms and factors: in the order of declarations, in which no name has a part."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest
import sympy as sp
from hoopgen.derive.ir.kernel import decision
from hoopgen.derive.model import build
from hoopgen.derive.scenes import SCENES
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.symbolic.conditionals import barrier
from hoopgen.derive.symbolic.ordering import declared_at, in_order, ordering
from hoopgen.derive.symbolic.symbols import (
    NORMAL,
    POSITION,
    VELOCITY,
    ChangeSymbol,
    ParameterSymbol,
    t,
)

from hoopgen.codegen.program import lower
from tests.helpers import ROOT
from tests.helpers.renamed import Digests
from tests.helpers.scenes.rings import RINGS

wide, high = (ParameterSymbol(name, positive=True) for name in ("wide", "high"))


def operations(names: str, scene: str) -> Digests:
    """Return the operations that `tests/helpers/renamed.py` prints."""
    program = (sys.executable, "-m", "tests.helpers.renamed", names, scene)
    printed = subprocess.run(program, cwd=ROOT, capture_output=True, check=True, text=True).stdout
    found: Digests = json.loads(printed)
    return found


@pytest.mark.slow
@pytest.mark.parametrize(
    "scene", ["tests.helpers.scenes.rings:RINGS", "hoopgen.derive.scenes.court:COURT"]
)
def test_no_name_decides_an_operation(scene: str) -> None:
    """Derived again with all symbols and functions renamed, every kernel does the same."""
    same, other = operations("same", scene), operations("names", scene)
    assert len(same) > 100
    assert [name for name in same | other if same.get(name) != other.get(name)] == []


@pytest.mark.slow
@pytest.mark.parametrize("scene", [*SCENES, RINGS], ids=lambda scene: scene.name)
def test_every_argument_is_declared(scene: Scene) -> None:
    """So that no kernel has an order of its own; and each has a place of its own."""
    arguments = {symbol for kernel in build(scene).kernels for symbol in kernel.arguments}
    of_scene = (ParameterSymbol, ChangeSymbol)  # which the scene orders
    ours = {s.name: s for s in arguments if not isinstance(s, of_scene)}
    assert [name for name, symbol in ours.items() if len(declared_at(symbol)) == 1] == []
    assert len({declared_at(symbol) for symbol in ours.values()}) == len(ours)


def test_arguments_are_in_the_order_of_declaration() -> None:
    x, vx, nx = POSITION[0], VELOCITY[0], NORMAL[0]
    other = sp.Symbol("a")
    assert in_order({t, vx, other, wide, x, nx, high}) == (high, wide, x, nx, vx, t, other)
    made = decision("made", {"sum": t + vx + x}, "")
    assert made.arguments == (x, vx, t)


def test_parameters_are_in_the_order_of_their_scene() -> None:
    """They come before all others, so that what is made of them alone is made once."""
    x, *_ = POSITION
    for parameters in ([wide, high], [high, wide]):
        key = ordering(parameters)
        assert sorted([t * x, high, x, wide], key=key) == [*parameters, x, t * x]
        program = lower(decision("f", {"x": wide + high + x}, ""), parameters)
        symbols = [o.symbol for o in program.operations]
        first = program.operations[program.operations[program.outputs[0]].operands[0]]
        assert [symbols[k] for k in first.operands] == [f"p_{p.name}" for p in parameters]


def test_terms_are_ordered_by_what_they_are_made_of() -> None:
    x, y, _ = POSITION
    held = barrier(x + y)
    terms = [x, 2 * y, y**2, x * y, x * y**2, held]
    assert sorted({*terms}, key=ordering()) == terms
    key = ordering()
    assert key(sp.sqrt(2)) < key(x) < key(sp.Abs(x)) < key(held)
    assert key(sp.Integer(2)) < key(sp.Integer(3)) < key(x)
