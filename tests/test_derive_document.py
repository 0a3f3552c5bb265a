"""The document of the derivation: every kernel is in it, and its LaTeX is whole."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from hoopgen.derive.ground.choice import IfLess, hold, largest, smallest
from hoopgen.generated.numpy import hoop
from sympy import symbols

from hoopgen.codegen.derivation import explain, latex_name

TEXT = (Path(__file__).parents[1] / "generated" / "derivation.md").read_text(encoding="utf-8")
PROSE = re.sub(r"`[^`\n]*`", "", TEXT)
DISPLAYED = re.findall(r"^\$\$\n(.*?)\n\$\$$", PROSE, re.DOTALL | re.MULTILINE)
INLINE = re.findall(r"\$([^$\n]+)\$", re.sub(r"^\$\$\n.*?\n\$\$$", "", PROSE, flags=re.S | re.M))


def test_every_kernel_is_in_the_table() -> None:
    rows = re.findall(r"^\| `(\w+)` \|", TEXT, re.MULTILINE)
    assert [name for name in hoop.OUTPUTS if name not in rows] == []


def test_every_link_leads_to_a_heading() -> None:
    headings = re.findall(r"^#+ (.*)$", TEXT, re.MULTILINE)
    anchors = {re.sub(r"[^\w\- ]", "", heading).lower().replace(" ", "-") for heading in headings}
    assert [link for link in re.findall(r"\(#([^)]*)\)", TEXT) if link not in anchors] == []


def test_formulas_are_whole() -> None:
    """Braces, brackets and environments are closed in order, and no macro is one GitHub forbids."""
    assert len(DISPLAYED) > 50
    assert len(INLINE) > 50
    for formula in DISPLAYED + INLINE:
        open_: list[str] = []
        token = r"\\begin\{(\w+)\}|\\end\{(\w+)\}|\\(left|right)\b|(?<!\\)([{}])"
        for begin, end, side, brace in re.findall(token, formula):
            if begin or side == "left" or brace == "{":
                open_.append(begin or side or brace)
            else:
                assert open_.pop() == (end or {"right": "left"}.get(side, "{")), formula
        assert not open_, formula
        assert not re.search(r"\\operatorname|\bnan\b|Held|If(Less|AtMost)", formula), formula
        assert "\n\n" not in formula


def test_no_bar_of_a_formula_ends_the_cell_of_a_table() -> None:
    rows = [line for line in PROSE.splitlines() if line.startswith("|")]
    assert not [row for row in rows if any("|" in f for f in re.findall(r"\$([^$]+)\$", row))]


@pytest.mark.parametrize(
    ("name", "latex"),
    [
        ("wx", r"\omega_{x}"),
        ("n12", "n_{12}"),
        ("dvx", r"\delta_{v_{x}}"),
        ("v1_after", "v_{1}^+"),
        ("ring_radius", "R_H"),
        ("something_else", r"\text{something else}"),
    ],
)
def test_symbols_have_the_names_of_the_article(name: str, latex: str) -> None:
    assert latex_name(name) == latex


def test_what_is_held_and_used_twice_has_a_name() -> None:
    a, b = symbols("a b", real=True)
    inner = hold(a + b)
    formulas = explain({"f": inner**2 + 1 / inner, "m": smallest(largest(a, b), 3)})
    assert [line.right for line in formulas.lines] == [
        r"\frac{1}{h_{1}} + h_{1}^{2}",
        r"\min\left(\max\left(a, b\right), 3\right)",
    ]
    (where,) = formulas.where
    assert (where.left, where.right) == ("h_{1}", "a + b")


def test_a_quotient_of_choices_is_a_choice_of_quotients() -> None:
    a, b = symbols("a b", real=True)
    (line,) = explain({"t": IfLess(a, 0, 2, b) / IfLess(a, 0, b, 3)}).lines
    assert line.right == (
        r"\begin{cases} \dfrac{2}{b} & a < 0 \\ \dfrac{b}{3} & \text{else} \end{cases}"
    )
