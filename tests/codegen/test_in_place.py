"""A body that nearly all shots enter: in C its shots are not packed, the others are idle lanes."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp
from hoopgen.derive.ir.event_tree import Call, ForEach, If, Node, While
from hoopgen.derive.ir.kernel import decision
from hoopgen.derive.symbolic.conditionals import Less

from hoopgen.codegen.c.compaction import CompactedLoop
from hoopgen.codegen.c.formatter import C_FORMATTER
from hoopgen.codegen.c.hierarchy import GroupContext

TOTAL, OWN = sp.symbols("total own", real=True)
ADDING = Call(decision("adding", {"total": TOTAL + 1, "again": Less(TOTAL, 3)}, ""))
ASKING = Call(decision("asking", {"asked": Less(TOTAL, 2)}, ""))
BODY = (ADDING, While("again", 3, (ADDING,)), ADDING)


def printed(nodes: Sequence[Node]) -> str:
    loop = CompactedLoop(
        prefix="own",
        costs={"adding": 1, "asking": 1},
        max_inline_cost=0,
        parameters=("p_a", "p_b"),
    )
    found = loop.passes(nodes, GroupContext("", {"total": "double"}), {"total"})
    return "\n".join(C_FORMATTER.lines(found))


def test_the_shots_of_a_body_that_most_enter_are_not_packed() -> None:
    listed, in_place = (printed([ASKING, If("asked", BODY, usual=most)]) for most in (False, True))
    assert "asked_shots" in listed
    assert "asked_shots" not in in_place
    assert "again_shots" in in_place, "what repeats within it has its list"


def test_what_others_need_again_of_such_a_body_they_keep() -> None:
    text = printed([ASKING, If("asked", BODY, usual=True)])
    passes = [part for part in text.split("for (") if "_adding_1" in part and "rows" in part]
    assert len(passes) == 2
    for part in passes:
        assert "lanes_load(worklist->asked + i)" in part
        assert "if (lanes_any(rows)) {" in part
        assert "EACH(SELECT, (rows, _adding_1), total)" in part
        assert part.index("EACH(LOAD, , total)") < part.index("_adding_1")


def test_within_a_table_such_a_body_has_its_list() -> None:
    """Each of many bodies is met by few shots."""
    each = ForEach(("own",), (("p_a",), ("p_b",)), (ASKING, If("asked", BODY, usual=True)))
    assert "asked_shots" in printed([each])
