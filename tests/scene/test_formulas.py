"""Formulas from strangers: read by a whitelist, never run, and right where they are read."""

from __future__ import annotations

import ast
import builtins
import keyword
import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hypothesis import example, given, settings
from hypothesis import strategies as st

from hoopgen.scene import Limits, formula_parser, formulas
from hoopgen.scene.formula_parser import parse
from hoopgen.scene.formulas import POSITION, Formula, FormulaError, constant
from hoopgen.scene.polynomials import polynomial
from tests.helpers.effort import trials

NAMES = ("a", "b", "radius", *POSITION)
VALUES = {"a": 0.3, "b": -1.7, "radius": 0.25, "x": 1.1, "y": -0.4, "z": 0.6}

# What is made of the grammar's own pieces, so that much of it is a formula.
leaves = st.sampled_from([*NAMES, "0", "1", "2", "0.5", "1e-3", ".25", "3."])
grown = st.recursive(
    leaves,
    lambda inner: st.one_of(
        st.tuples(inner, st.sampled_from("+-*/"), inner).map(lambda p: f"({p[0]} {p[1]} {p[2]})"),
        st.tuples(inner, st.integers(0, 3)).map(lambda p: f"({p[0]})**{p[1]}"),
        inner.map(lambda p: f"sqrt({p})"),
        inner.map(lambda p: f"-{p}"),
    ),
    max_leaves=8,
)

# And what is made of pieces of Python.
pieces = st.sampled_from(
    [
        *("a", "x", "sqrt", "1", "2.5", "+", "-", "*", "/", "**", "(", ")", " ", "\t", "\n", "."),
        *("__import__", "eval", "exec", "os", "system", "'", '"', "[", "]", "{", "}", ",", ":"),
        *(":=", "lambda", "if", "else", "for", "in", "not", "and", "True", "None", "1j", "0x1f"),
        *("%", "//", "@", "<<", "~", "==", "\\", "#", "\x00", "é", "ａ", "²", "∞", "1_0", "1e999"),
    ]
)


compiles = compile


def forbidden(*_: Any, **__: Any) -> Any:
    raise AssertionError("something was run")


def only_a_tree(source: Any, filename: Any, mode: Any, flags: int, *rest: Any, **more: Any) -> Any:
    """Compile to a syntax tree, as `ast.parse` does, and to nothing that runs."""
    assert flags & ast.PyCF_ONLY_AST
    return compiles(source, filename, mode, flags, *rest, **more)


def read_or_refused(text: str) -> Formula | None:
    """Return the formula; None if it is refused, in one short line, whatever else is tried."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(builtins, "compile", only_a_tree)
        for name in ("eval", "exec", "open", "__import__"):
            patch.setattr(builtins, name, forbidden)
        try:
            found = parse(text, NAMES)
            message = None
        except FormulaError as error:
            found, message = None, error.args[0]
    if message is not None:
        assert "\n" not in message
        assert len(message) < 400
    return found


@pytest.mark.slow
@settings(max_examples=trials(400), deadline=None)
@given(st.one_of(st.text(max_size=40), st.lists(pieces, max_size=12).map("".join)))
@example("__import__('os').system('true')")
@example("().__class__.__bases__[0].__subclasses__()")
@example("(" * 150 + "a" + ")" * 150)
@example("-" * 299 + "a")
@example("9" * 300)
@example("9**9**9")
@example("sqrt(x=1)")
@example("sqrt(*a)")
@example("a\x00b")
@example("1if 2else 3")
def test_any_text_is_a_formula_or_refused_and_nothing_is_run(text: str) -> None:
    """No other exception, no warning; what is read has only declared names and a small degree."""
    found = read_or_refused(text)
    if found is not None:
        assert found.names <= set(NAMES)
        assert found.degree <= Limits().formula_degree


@settings(max_examples=trials(300), deadline=None)
@given(grown)
def test_what_is_read_has_the_value_that_python_gives(text: str) -> None:
    """And so has its polynomial, where it is one."""
    found = read_or_refused(text)
    if found is None:
        return
    try:
        expected = eval(text, {"sqrt": math.sqrt, **VALUES})  # made above, of the grammar alone
    except (ValueError, ZeroDivisionError, OverflowError):
        return
    if isinstance(expected, complex) or abs(expected) > 1e6:
        return
    value = found.evaluate(VALUES)
    # Sums are taken together, and cancel otherwise than Python's.
    again = parse(str(found), NAMES).evaluate(VALUES) if len(str(found)) < 300 else value
    assert again == pytest.approx(value, rel=1e-9, abs=1e-9) or not np.isfinite(value)
    assert value == pytest.approx(expected, rel=1e-9, abs=1e-9) or not np.isfinite(value)
    try:
        terms = polynomial(found)
    except FormulaError:
        return
    put = sum(
        factor.evaluate(VALUES)
        * math.prod(VALUES[p] ** k for p, k in zip(POSITION, powers, strict=True))
        for powers, factor in terms.items()
    )
    if np.isfinite(put) and np.isfinite(value):
        assert put == pytest.approx(value, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "not a formula"),
        ("q + 1", "unknown name 'q'; there are a, b, radius, x, y, z"),
        ("a.real", "'.' is not allowed"),
        ("a // b", "FloorDiv is not allowed"),
        ("a(b)", "Call is not allowed"),
        ("sqrt(a)(b)", "Call is not allowed"),
        ("a**-1", "whole power from 0 to 8"),
        ("a**0.5", "whole power from 0 to 8"),
        ("a**b", "whole power from 0 to 8"),
        ("a**999999999", "at most 8 factors in a product, powers multiplied out, got 999,999,999"),
        ("(x**4)**4", "at most 8 factors in a product, powers multiplied out, got 16"),
        ("a" + "*a" * 8, "at most 8 factors in a product, powers multiplied out, got 9"),
        ("a+" * 200 + "a", "at most 300 characters, got 401"),
        ("-" * 40 + "a", "at most 30 operations within one another, got 31 or more"),
        ("1/0", "division by zero"),
        ("a/(b - b)", "division by zero"),
        ("sqrt(1 - 2)", "square root of a negative number"),
        ("1e300", "from 1e-100 to 1e100 in size"),
        ("1e999", "finite"),
        ("(1e99)**2", "from 1e-100 to 1e100 in size"),
    ],
)
def test_a_refusal_says_why(text: str, said: str) -> None:
    with pytest.raises(FormulaError) as refusal:
        parse(text, NAMES)
    assert said in str(refusal.value)


def test_no_power_of_a_number_grows_long() -> None:
    """Each is rounded: a power of 8 to the 12 would not fit a memory."""
    text = "1.0000000000000002"
    for _ in range(12):
        text = f"({text})**8"
    found = parse(text, ())
    assert found.number is not None
    assert found.number.denominator < 2**60


def test_a_name_may_be_a_word_of_python() -> None:
    words = sorted({*keyword.kwlist, *keyword.softkwlist, "name_a"})
    for word in words:
        own = formulas.name(word)
        assert parse(word, words) == own
        assert parse(f"2*{word} -({word})", words) == own
        assert parse(f"sqrt({word})*(\t{word}+1)", words) == own.sqrt() * (own + constant(1))
    with pytest.raises(FormulaError, match="not a formula"):
        parse("lambda in", words)
    with pytest.raises(FormulaError, match="unknown name 'lambda'"):
        parse("lambda: 1", ["a"])
    with pytest.raises(FormulaError, match="unknown name 'name_lambda'"):
        parse("name_lambda", ["lambda"])


def test_a_number_is_its_double() -> None:
    """And an array goes through a formula as a number does."""
    assert parse("0.1", ()).number == Fraction(0.1)
    got = parse("radius - 2*a", NAMES).evaluate({"a": np.array([0.1, 0.2]), "radius": 1.0})
    assert list(got) == [1.0 - 2 * 0.1, 1.0 - 2 * 0.2]


@pytest.mark.parametrize(
    "given", [True, None, [1.0], float("nan"), float("inf"), 10**400, 1j, b"1", {}]
)
def test_what_is_no_size_is_refused(given: Any) -> None:
    with pytest.raises(FormulaError, match="expected"):
        formula_parser.read(given, NAMES)


def test_an_expression_of_sympy_is_read_by_the_same_whitelist() -> None:
    a, b, x = sp.symbols("a b x")
    for expression, text in (
        (x**2 + 3 * a, "x**2 + 3*a"),
        (sp.sqrt(a) / b, "sqrt(a)/b"),
        (a ** sp.Rational(3, 2) + sp.Float("0.5"), "sqrt(a)**3 + 0.5"),
        (1 / (a * b) ** 2, "1/(a*b)**2"),
    ):
        found = formula_parser.read(expression, NAMES)
        values = VALUES | {"b": 1.7}
        assert found.evaluate(values) == pytest.approx(
            parse(text, NAMES).evaluate(values), rel=1e-15
        )
    for wrong in (sp.sin(a), sp.Symbol("q"), a**x, sp.pi, x**20, sp.oo, sp.nan, sp.I, x > 0):
        with pytest.raises(FormulaError):
            formula_parser.read(wrong, NAMES)


def test_a_polynomial_has_its_like_terms_together() -> None:
    terms = polynomial(parse("(x - a)**2 + y**2 - radius**2", NAMES))
    minus_two_a = constant(-2) * formulas.name("a")
    assert terms[2, 0, 0] == terms[0, 2, 0] == constant(1)
    assert terms[1, 0, 0] == minus_two_a
    assert set(terms) == {(2, 0, 0), (0, 2, 0), (1, 0, 0), (0, 0, 0)}
    assert polynomial(parse("x*y - y*x", NAMES)) == {}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("sqrt(x**2 + y**2) - a", "not polynomial"),
        ("a/x", "divides by x, y or z"),
        ("(x + y + z + 2)**4 * (x + y + z + 3)**4", "at most 200 terms"),
    ],
)
def test_what_is_not_polynomial_is_refused(text: str, said: str) -> None:
    with pytest.raises(FormulaError, match=said):
        polynomial(parse(text, NAMES))


@pytest.mark.parametrize(
    ("text", "metres"),
    [("30cm", True), ("2 m", True), ("-0.5 ft", True), ("1e2mm", True), ("45°", False)],
)
def test_a_number_with_a_unit_is_told_what_is_allowed(text: str, metres: bool) -> None:
    with pytest.raises(FormulaError) as error:
        parse(text, ("m", "width"))
    expected = f"expected a number without a unit{' (lengths in m)' * metres}, or a formula"
    assert str(error.value) == f"{expected}; got {text!r}"
