"""Hoisting: values of parameters alone that C computes before its kernels run."""

from __future__ import annotations

import re
from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.ir.event_tree import Call, walk
from hoopgen.derive.ir.kernel import Kernel
from hoopgen.derive.model import build
from hoopgen.derive.symbolic.conditionals import IfLess

from hoopgen.codegen import render
from hoopgen.codegen.hoisting import PartialEvaluation, partial_evaluation, partial_evaluations
from hoopgen.codegen.identifiers import identifier
from hoopgen.codegen.program import Operations, lower
from tests.codegen.test_kernels import model, random_columns
from tests.codegen.test_shared_kernels import pins
from tests.helpers.derived import OPERATIONS
from tests.scene.test_oblique_bodies import RINGS


def values(program: Operations, given: dict[str, Any]) -> list[Any]:
    """Return what every operation makes of what is given."""
    kind = np.float32 if program.single else np.float64
    found: list[Any] = []
    with np.errstate(all="ignore"):
        for operation in program.operations:
            if operation.name in ("argument", "truth"):
                value = np.asarray(given[operation.symbol])
                found.append(value if operation.name == "truth" else value.astype(kind))
            elif operation.name == "constant":
                found.append(kind(operation.value))
            else:
                operands = (found[k] for k in operation.operands)
                found.append(OPERATIONS[operation.name](*operands))
    return found


@cache
def split_kernels() -> dict[str, PartialEvaluation]:
    loops = (model().loop.plain(), model().loop)
    return partial_evaluations(map(lower, model().kernels), loops)


@pytest.mark.parametrize("share", [0.1, pytest.param(1, marks=pytest.mark.slow)])
def test_a_kernel_with_what_it_is_given_is_the_kernel(share: float) -> None:
    """The hoisted values, put into the rest, give the bits of the whole."""
    kernels = [own for _, own in sorted(split_kernels().items())]
    for own in kernels[:: round(1 / share)]:
        check_partial_evaluation(own)


def check_partial_evaluation(own: PartialEvaluation) -> None:
    """Check that a kernel split in two gives the bits of the whole, for random arguments."""
    columns: dict[str, Any] = dict(random_columns(5, 200))
    rng = np.random.default_rng(2)
    for symbol in own.whole.kernel.arguments:
        columns.setdefault(identifier(symbol), rng.normal(0, 1, 200))
    whole = values(own.whole, columns)
    ready = {f"_c{n}": whole[k] for n, k in enumerate(own.loop_invariant)}
    arguments = [identifier(own.whole.kernel.arguments[k]) for k in own.kept_arguments]
    rest = values(own.rest, ready | {name: columns[name] for name in arguments})
    for output, in_rest in zip(own.whole.outputs, own.rest.outputs, strict=True):
        np.testing.assert_array_equal(whole[output], rest[in_rest])


@pytest.mark.slow
def test_no_kernel_of_the_loop_makes_anything_of_parameters_alone() -> None:
    for own in split_kernels().values():
        known = [o.name == "constant" or o.symbol[:2] in ("p_", "_c") for o in own.rest.operations]
        for k, operation in enumerate(own.rest.operations):
            if not operation.is_free and not operation.is_truth:
                known[k] = all(known[o] for o in operation.operands)
                assert not known[k], (own.rest.kernel.name, operation)


def test_what_has_a_value_for_each_shot_stays() -> None:
    a, b, c = sp.symbols("a b c", real=True)
    outputs = (("found", IfLess(a, b, sp.sqrt(b + c) * a, b * c)), ("alone", b / c))
    made = Kernel("made", (a, b, c), outputs, "A sum.", "none")
    own = partial_evaluation(lower(made), {1, 2})
    assert own.kept_arguments == (0,)
    assert [o.name for o in own.rest.operations if o.name != "argument"] == [
        "mul",
        "less",
        "select",
    ]
    given = {"a": 1.5, "b": 2.0, "c": 7.0}
    found = values(own.whole, given)
    assert found[own.whole.outputs[0]] == 4.5
    assert found[own.whole.outputs[1]] == 2 / 7
    assert partial_evaluation(lower(made), ()).loop_invariant == ()


def test_a_kernel_makes_what_is_of_the_row_of_a_table_itself() -> None:
    """A row has sizes of its own: the kernels of its body are given nothing made of those."""
    built = build(pins(4).derive())
    own = partial_evaluations(map(lower, built.kernels), (built.loop,))
    met = 0
    for table in built.loop.tables:
        for node in walk(table.body):
            if not isinstance(node, Call) or not set(node.arguments) & set(table.names):
                continue
            met += 1
            ready = own.get(node.kernel.name)
            names = [identifier(symbol) for symbol in node.kernel.arguments]
            of_row = {n for n, v in zip(names, node.arguments, strict=True) if v in table.names}
            if ready:
                kept = {names[k] for k in ready.kept_arguments}
                assert of_row <= kept
    assert met


@pytest.mark.slow
def test_quantities_of_parameters_have_a_row_of_memory_each() -> None:
    """More than the rows of one lane too, 256; a scene of many parameters has them."""
    (loop,) = (
        text
        for file, text in render.render_scene(RINGS.derive(), page=False, targets=["c"]).items()
        if file.endswith("_loop.h")
    )
    for stored, memory in (("FIX", "fixed"), ("FIX_SINGLE", "fixed_single")):
        used = 1 + max((int(row) for row in re.findall(rf"\b{stored}\((\d+)", loop)), default=-1)
        (size,) = re.findall(rf" {memory}\[(\w+)\]\[LANES_WIDTH\];", loop) or ["0"]
        assert used <= (256 if size == "LANES_ROWS" else int(size))
        assert memory != "fixed" or used > 256
