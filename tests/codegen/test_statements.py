"""Statements as a tree: what visitors find in it, and how formatters write it."""

from __future__ import annotations

import itertools
import random
from types import CodeType

import pytest

from hoopgen.codegen.c.formatter import C_FORMATTER
from hoopgen.codegen.numpy.formatter import ONE_SHOT_FORMATTER, ROWS_FORMATTER
from hoopgen.codegen.statements import (
    Apply,
    Assign,
    Block,
    Break,
    Call,
    Cast,
    Choose,
    Column,
    Compact,
    Continue,
    Declare,
    Execute,
    For,
    ForEach,
    ForLanes,
    Function,
    If,
    Infix,
    Item,
    Member,
    Name,
    Number,
    Operate,
    Return,
    Scalar,
    Statement,
    Table,
    Tuple,
    While,
)
from hoopgen.codegen.visitors import (
    bodies,
    live_before,
    names_in,
    reads,
    walk,
    writes,
)

a, b, c, n = map(Name, "abcn")

LEAVES: tuple[Statement, ...] = (
    Declare("d", "V", Infix("+", a, b)),
    Table("t", "double", ((a, Scalar(1)), (b, Scalar(2)))),
    Assign(Name("w"), c),
    Assign(Item(Name("w"), a), b),
    Assign(Name("w"), c, "+="),
    Call("f", (a, Number(1.0)), ("r",)),
    Execute(Apply("g", (Column("x"), c))),
    Return(Tuple((a, b))),
    Break(),
    Continue(),
)


def test_names_are_those_of_variables_alone() -> None:
    value = Choose(
        Operate("less", (a, Number(0.0))),
        Member(Item(b, c), "part"),
        Cast("double", Infix("+", Column("x"), Apply("f", (n, Scalar(1))))),
    )
    assert names_in(value) == {"a", "b", "c", "n"}


@pytest.mark.parametrize(
    ("statement", "read", "written"),
    [
        (LEAVES[0], "ab", "d"),
        (LEAVES[1], "ab", "t"),
        (LEAVES[2], "c", "w"),
        (LEAVES[3], "wab", "w"),
        (LEAVES[4], "wc", "w"),
        (LEAVES[5], "a", "r"),
        (LEAVES[6], "c", ""),
        (LEAVES[7], "ab", ""),
        (If(a, (Assign(b, c),), (Assign(c, n),)), "acn", "bc"),
        (While(a, (Assign(a, b),)), "ab", "a"),
        (While(None, (Break(),)), "", ""),
        (For("i", n, (Assign(a, Name("i")),), first=b), "nbi", "ai"),
        (ForEach(("k",), Name("t"), (Assign(a, Name("k")),)), "tk", "ak"),
        (ForLanes("i", b, n, (Assign(a, Name("i")),)), "bni", "ai"),
        (Compact("n", b, (Execute(Apply("pack", (a,))),)), "nba", "n"),
        (Function("f", (("p", "V"),), (Return(Name("p")),)), "p", "p"),
        (Block((LEAVES[0], LEAVES[2])), "abc", "dw"),
    ],
    ids=lambda value: type(value).__name__ if not isinstance(value, str) else "",
)
def test_what_a_statement_reads_and_writes(statement: Statement, read: str, written: str) -> None:
    assert reads([statement]) == set(read)
    assert writes([statement]) == set(written)


def test_walk_yields_each_statement_before_those_in_it() -> None:
    inner = Assign(a, b)
    tree = (If(a, (Block((inner,)),), (Break(),)), inner)
    assert [type(s).__name__ for s in walk(tree)] == ["If", "Block", "Assign", "Break", "Assign"]
    assert all(bodies(s) == () for s in LEAVES)


@pytest.mark.parametrize(
    ("statements", "after", "live"),
    [
        ((Assign(a, b), Assign(b, c)), "a", "bc"),
        ((Declare("a", "V"), Assign(a, b)), "a", "b"),
        ((Assign(a, b, "+="),), "a", "ab"),
        ((Assign(Item(a, c), b),), "a", "abc"),
        ((Call("f", (b,), ("a",)), Assign(c, Member(a, "x"))), "c", "b"),
        # A value that only one branch replaces is needed before.
        ((If(c, (Assign(a, b),)),), "a", "abc"),
        ((If(c, (Assign(a, b),), (Assign(a, n),)),), "a", "bcn"),
        # What a turn leaves is needed by the next; the body may not be done at all.
        ((While(c, (Assign(a, b), Assign(b, n))),), "", "cbn"),
        ((While(c, (Assign(a, b),)),), "a", "abc"),
        ((For("i", n, (Assign(a, Name("i")),)),), "", "n"),
        ((ForLanes("i", b, n, (Declare("x", "V", a), Assign(c, Name("x")))),), "c", "abnc"),
        ((Function("f", (("p", "V"),), (Return(Infix("+", Name("p"), a)),)),), "", "a"),
        ((Compact("n", b, ()),), "n", "nb"),
        # A name that is declared within a block is no name from before it.
        ((Block((Declare("a", "V", b), Assign(c, a))),), "", "b"),
    ],
)
def test_what_is_live_before(statements: tuple[Statement, ...], after: str, live: str) -> None:
    assert live_before(statements, after) == set(live)


def test_what_is_live_is_what_some_run_needs() -> None:
    """On random trees, every path taken: without a live variable some run fails, else none."""
    choose = random.Random(3)

    def tree(depth: int) -> tuple[Statement, ...]:
        found: list[Statement] = []
        for _ in range(choose.randint(1, 3)):
            kind = choose.choice(("assign", "if", "for")) if depth else "assign"
            if kind == "assign":
                one, other = map(Name, choose.choices("abc", k=2))
                found.append(Assign(Name(choose.choice("abc")), Infix("+", one, other)))
            elif kind == "if":
                found.append(If(Apply("some"), tree(depth - 1), tree(depth - 1)))
            else:
                found.append(For("i", Apply("some"), tree(depth - 1)))
        return tuple(found)

    def fails(source: CodeType, known: set[str]) -> bool:
        try:
            exec(source, {"some": lambda: choose.randint(0, 2)} | dict.fromkeys(known, 1))
        except NameError:
            return True
        return False

    for _ in range(100):
        statements = tree(2)
        live = live_before(statements)
        text = "\n".join(ROWS_FORMATTER.lines(statements))
        source = compile(text, "a random tree", "exec")
        assert not any(fails(source, live) for _ in range(10))
        for name in sorted(live):
            assert any(fails(source, live - {name}) for _ in range(3000)), (name, text)


def test_c_is_written_as_c() -> None:
    statements = (
        Declare("x", "V", Apply("lanes_load", (Infix("+", Column("x"), Infix("&", a, b)),))),
        Declare("m", "double", room=(Name("LANES_WIDTH"),)),
        Table("t", "static const double", ((Scalar(1), Scalar(2.5)),)),
        Call("f", (Number(float("-inf")), Number(0.5, single=True)), ("o",)),
        If(Infix("==", a, Scalar(0)), (Break(),)),
        ForLanes("i", Scalar(0), n, (Execute(Apply("g")), Assign(a, Scalar(1), "+="))),
        Assign(Item(a, b), Cast("size_t", b)),
        Compact("n", c, (Execute(Apply("lanes_pack", (a, c, b))),)),
        Block((While(None, (Break(),)),), flush=True),
        Return(Choose(a, b, Operate("add", (a, b)))),
    )
    assert C_FORMATTER.lines(statements) == [
        "V x = lanes_load(worklist->x + (a & b));",
        "double m[LANES_WIDTH];",
        "static const double t[][2] = {",
        "    {1, 2.5},",
        "};",
        "CALL(f, o)(K(-INFINITY), KS(0.5));",
        "if (a == 0)",
        "    break;",
        "for (size_t i = 0; i < n; i += LANES_WIDTH) {",
        "    g();",
        "    a += 1;",
        "}",
        "a[b] = (size_t)b;",
        "if (lanes_any(c)) {",
        "    lanes_pack(a, c, b);",
        "    n += popcount(c);",
        "}",
        "{",
        "for (;;) {",
        "    break;",
        "}",
        "}",
        "return a ? b : lanes_add(a, b);",
    ]


def test_python_is_written_as_python() -> None:
    statements = (
        Assign(a, Operate("mul", (Operate("add", (b, Number(-1.0))), c))),
        Call("f", (a,), ("x",)),
        If(a, (Break(),), (If(b, (Continue(),), (Return(Tuple((a,))),)),)),
        For("k", Scalar(3), (Execute(Apply("g", (Name("k"),))),), (Execute(Apply("h")),)),
        ForEach(("p",), Tuple((Tuple((a,)), Tuple((b,)))), (Break(),)),
    )
    assert ROWS_FORMATTER.lines(statements) == [
        "a = (b + -1.0) * c",
        "x, = f(a)",
        "if a:",
        "    break",
        "elif b:",
        "    continue",
        "else:",
        "    return (a,)",
        "for k in range(3):",
        "    g(k)",
        "else:",
        "    h()",
        "for p, in (",
        "    (a,),",
        "    (b,),",
        "):",
        "    break",
    ]


def test_operands_have_the_brackets_that_they_need() -> None:
    """Python reads each printed expression as its tree again."""
    operations = ("add", "sub", "mul", "div")
    for outer, inner in itertools.product(operations, repeat=2):
        for left in (True, False):
            part = Operate(inner, (a, b))
            whole = Operate(outer, (part, c) if left else (c, part))
            values = {"a": 7.0, "b": 3.0, "c": 2.0}
            apply = {
                "add": float.__add__,
                "sub": float.__sub__,
                "mul": float.__mul__,
                "div": float.__truediv__,
            }
            within = apply[inner](7.0, 3.0)
            wanted = apply[outer](within, 2.0) if left else apply[outer](2.0, within)
            assert eval(ROWS_FORMATTER.expression(whole), values) == wanted
    text = ONE_SHOT_FORMATTER.expression(Operate("select", (Operate("less", (a, b)), a, b)))
    assert text == "a if (a < b) else b"


def test_what_a_target_does_not_write_is_refused() -> None:
    with pytest.raises(TypeError, match="CFormatter does not write Continue"):
        C_FORMATTER.lines([Continue()])
    with pytest.raises(TypeError, match="PythonFormatter does not write ForLanes"):
        ROWS_FORMATTER.lines([ForLanes("i", a, n, ())])
    with pytest.raises(TypeError, match="PythonFormatter does not write Cast"):
        ROWS_FORMATTER.expression(Cast("int", a))
