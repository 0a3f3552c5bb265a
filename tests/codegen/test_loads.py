"""Columns that a pass of C's event loop loads and moves: only those that it needs there."""

from __future__ import annotations

import re

import pytest
from hoopgen.derive.ir.event_tree import Call, If
from hoopgen.derive.ir.kernel import loop_kernel
from hoopgen.derive.symbolic.conditionals import Boolean
from sympy import symbols

from hoopgen.codegen.c.inner_columns import read_within
from tests.helpers import ROOT

a, b, c = symbols("a b c", real=True)
FIRST = If("seldom", (Call(loop_kernel("first", {"x": a + b}, "", "")),), rare=True)
SECOND = If("often", (Call(loop_kernel("second", {"y": b + c}, "", "")),))


def test_a_rare_body_loads_what_it_alone_reads() -> None:
    found = read_within((FIRST, SECOND), {"a", "b", "c"}, lambda node: False)
    assert found == {id(FIRST): ["a"]}


def test_a_body_that_is_executed_for_all_lanes_loads_nothing() -> None:
    assert read_within((FIRST, SECOND), {"a", "b", "c"}, lambda node: True) == {}


def test_a_guard_is_loaded_before_its_body() -> None:
    asks = If("seldom", (Call(loop_kernel("asks", {"x": Boolean("seldom")}, "", "")),), rare=True)
    assert read_within((asks,), {"seldom"}, lambda node: False) == {id(asks): []}


@pytest.mark.parametrize("scene", ["hoop", "court"])
def test_what_only_results_need_moves_if_these_are_requested(scene: str) -> None:
    text = (ROOT / "generated" / "c" / f"{scene}_loop.h").read_text("utf-8")
    moved = dict(re.findall(r"if \(job->results->(\w+)\) \{\s+EACH\(KEEP, , ([\w, ]+)\)", text))
    assert moved["counts"] == "count_0, count_1, count_2"
    assert moved["first"] == "first"
    # The path depends on these.
    always = re.search(r"EACH\(KEEP, , x, y, z,.*\)", text)
    assert always is not None
    assert {"clock", "last", "contacts"} <= set(re.findall(r"\w+", always[0]))
