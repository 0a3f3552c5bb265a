"""The document of the derivation: every formula in it is what its kernel computes.

What is printed is read back and evaluated, at random states, against the expressions of derive/.
"""

from __future__ import annotations

import pickle
import re
from collections.abc import Iterable, Iterator
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.events.ring.polar import INFLATION_FACTOR
from hoopgen.derive.ir.event_tree import Call, walk
from hoopgen.derive.ir.kernel import kernel
from hoopgen.derive.model import Model, build
from hoopgen.derive.scenes import COURT
from hoopgen.derive.surfaces import Box
from hoopgen.derive.symbolic.conditionals import (
    Barrier,
    Boolean,
    Choose,
    IfAtMost,
    IfLess,
    Less,
    all_of,
    barrier,
    maximum,
    minimum,
    release,
)
from hoopgen.derive.symbolic.notation import ROUNDOFF, structured
from hoopgen.derive.symbolic.symbols import UNIT_ROUNDOFF, ParameterSymbol
from hoopgen.generated.numpy import court, hoop
from mpmath import mp, mpf
from sympy import symbols

from hoopgen.codegen import render
from hoopgen.codegen.derivation import Formulas, Line, derivation_context, explain, latex_name
from hoopgen.codegen.derivation.contacts import contact_text
from hoopgen.codegen.derivation.latex import number, show
from hoopgen.codegen.derivation.page_entries import FAMILY
from hoopgen.codegen.derivation.parts import Abbreviations, search_text, surface_text
from hoopgen.codegen.derivation.scene_notation import SceneNotation
from hoopgen.codegen.program import lower
from tests.codegen.test_kernels import DIGITS, Evaluator, model
from tests.helpers import ROOT
from tests.helpers.effort import trials
from tests.helpers.latex_reader import read
from tests.helpers.scenes.caps import CAPS
from tests.helpers.scenes.table import TABLE

# One worker: the derivation takes a few seconds.
pytestmark = pytest.mark.xdist_group("kernels")

TEXT = (ROOT / "generated" / "derivation.md").read_text(encoding="utf-8")
COURT_TEXT = (ROOT / "generated" / "derivation_court.md").read_text(encoding="utf-8")
PROSE = re.sub(r"`[^`\n]*`", "", TEXT)


def test_every_kernel_is_in_the_table() -> None:
    rows = re.findall(r"^\| \[`(\w+)`\]\(#\1\) \| \[", TEXT, re.MULTILINE)
    assert rows == list(hoop.OUTPUTS)


def anchors(text: str) -> set[str]:
    """Return the targets of links to the headings of a page."""
    headings = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading).lower().replace(" ", "-") for heading in headings}


def test_every_link_leads_to_a_heading() -> None:
    own = {f"#{name}" for name in anchors(TEXT)}
    assert set(re.findall(r"\((#[^)]*)\)", TEXT)) <= own
    linked = set(re.findall(r"\(((?:derivation\.md)?#[^)]*)\)", COURT_TEXT))
    there = {f"derivation.md{name}" for name in own}
    assert linked <= {f"#{name}" for name in anchors(COURT_TEXT)} | there
    assert len(linked & there) > 80


def test_every_kernel_of_the_court_is_derived_on_its_page_or_linked_in_its_table() -> None:
    rows = re.findall(r"^\| \[?`(\w+)`(?:\]\((.*?)\))? \| \[", COURT_TEXT, re.MULTILINE)
    assert [name for name, _ in rows] == list(court.OUTPUTS)
    here, there = anchors(COURT_TEXT), anchors(TEXT)
    for name, link in rows:
        if link == f"derivation.md#{name}":
            assert name in there - here
        elif link:
            assert link == f"#{name}"
            assert name in here
        else:
            assert FAMILY.fullmatch(name), "further orders of a series"


def blocks(text: str) -> dict[str, str]:
    """Return the text below each heading of statements and kernels, without links to statements."""
    text = re.sub(r"^\[.*\]\(derivation\.md#.*\) stands on the page of .*\n", "", text, flags=re.M)
    found = re.split(r"^#{3,4} (?:Lemma \d+: |Choice \d+: )?(.*)\n", text, flags=re.M)
    return {
        heading: re.sub(r"\[(?:Lemma|Choice) \d+\]\([^)]*\)", "", body.split("\n## ")[0]).strip()
        for heading, body in zip(found[1::2], found[2::2], strict=True)
    }


@pytest.mark.slow
def test_what_the_court_links_its_whole_page_says_alike() -> None:
    """Statements with their proofs, and kernels: the two pages together are the whole page."""
    there, here, whole = blocks(TEXT), blocks(COURT_TEXT), blocks(render.explanation(COURT))
    assert here.keys() <= whole.keys() <= here.keys() | there.keys()
    assert len(whole) - len(here) > 100
    for heading, text in whole.items():
        assert text == (here if heading in here else there)[heading], heading


def assert_whole(text: str) -> None:
    """Check that formulas close what they open, in order, and use no macro that GitHub forbids."""
    prose = re.sub(r"`[^`\n]*`", "", text)
    displayed = re.findall(r"^\$\$\n(.*?)\n\$\$$", prose, re.DOTALL | re.MULTILINE)
    inline = re.findall(
        r"\$([^$\n]+)\$", re.sub(r"^\$\$\n.*?\n\$\$$", "", prose, flags=re.S | re.M)
    )
    assert len(displayed) > 50
    assert len(inline) > 50
    for formula in displayed + inline:
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


def test_formulas_are_whole() -> None:
    assert_whole(TEXT)


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
        ("high2", r"\overline t_2"),
        ("something_else", r"\text{something else}"),
    ],
)
def test_symbols_have_the_names_of_the_article(name: str, latex: str) -> None:
    assert latex_name(name) == latex


def test_what_is_held_and_used_twice_has_a_name() -> None:
    a, b = symbols("a b", real=True)
    inner = barrier(a + b)
    formulas = explain({"f": inner**2 + 1 / inner, "m": minimum(maximum(a, b), 3)})
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


# Every formula is evaluated

ROWS = trials(6, at_least=2)


@cache
def scene_model(scene: str) -> Model:
    return model() if scene == "hoop" else build({"table": TABLE, "caps": CAPS}[scene])


@cache
def page(scene: str) -> Any:
    return derivation_context(scene_model(scene))


def formulas_of(part: Any, known: dict[Any, str]) -> Iterator[Formulas]:
    """Return all formulas of a page, or of a part of it, given what its section 1 defines."""
    if isinstance(part, Line):
        yield Formulas((part,), (), known)
    elif isinstance(part, Formulas):
        yield part
    elif isinstance(part, dict):
        for inner in part.values():
            yield from formulas_of(inner, known)
    elif isinstance(part, tuple):
        for inner in part:
            yield from formulas_of(inner, known)
    elif is_dataclass(part):
        for field in fields(part):
            yield from formulas_of(getattr(part, field.name), known)


def numbers(found: set[sp.Symbol], random: np.random.Generator, row: int) -> dict[str, mpf | bool]:
    """Return a value for each symbol; some are small, some are equal."""
    values: dict[str, mpf | bool] = {}
    for symbol in sorted(found, key=lambda s: (s.name, type(s).__name__)):
        if isinstance(symbol, Boolean):
            values[symbol.name] = bool(random.integers(2))
            continue
        value = float(random.choice([random.uniform(0.05, 2), 1e-9, 1.0], p=[0.8, 0.1, 0.1]))
        if (
            not (symbol.is_nonnegative or isinstance(symbol, ParameterSymbol))
            and random.random() < 0.5
        ):
            value = -value
        if symbol.name in ("index", "which", "last", "first", "body", "leaving"):
            value = float(random.integers(-1, 3))
        values[symbol.name] = mpf(value)
    return values


def near(found: Any, exact: Any, scale: mpf) -> bool:
    """Return whether two values agree to all but the last few digits of what they were made of."""
    if isinstance(found, bool) or not mp.isfinite(exact):
        return repr(mpf(found)) == repr(mpf(exact))
    return bool(abs(found - exact) <= scale * mpf(10) ** (8 - DIGITS))


def parts_of(expressions: Iterable[sp.Basic]) -> set[sp.Basic]:
    """Return all parts of expressions; unlike SymPy's own searches, it visits each part once."""
    found: set[sp.Basic] = set()
    waiting = list(expressions)
    while waiting:
        part = waiting.pop()
        if part not in found:
            found.add(part)
            waiting.extend(part.args)
    return found


def assert_printed_as_meant(formulas: Formulas, letters: SceneNotation, seed: int) -> int:
    """Read all lines of formulas at random values; return how many there are."""
    random = np.random.default_rng(seed)
    lines = (*formulas.where, *formulas.lines)
    parts = parts_of(line.means for line in lines)
    free = {part for part in parts if part.is_Symbol}
    written = {letters(symbol) for symbol in free}
    assert len(written) == len(free), f"two symbols are written alike: {free}"
    own = [line.left for line in formulas.where]
    used = {name for e, name in formulas.given.items() if e in parts}
    assert len(set(own)) == len(own)
    assert not written & (set(own) | used), "a name and a symbol are written alike"
    compared, enough = 0, 0.9 * ROWS * len(lines)
    for row in range(3 * ROWS):
        if row >= ROWS and compared > enough:
            break  # a condition whose sides are drawn equal cannot be compared
        inputs = numbers(free, random, row)
        with mp.workdps(DIGITS):
            exactly = Evaluator(inputs)
            names: dict[str, Any] = {letters(s): inputs[s.name] for s in free}
            names[ROUNDOFF] = mpf(UNIT_ROUNDOFF.p) / UNIT_ROUNDOFF.q
            given = {e: n for e, n in formulas.given.items() if e.free_symbols <= free}
            names |= {name: exactly(e).value for e, name in given.items()}
            for line in lines:
                found, exact = read(line.right, names), exactly(line.means)
                scale = exact.error / mpf(2) ** -53 + abs(exact.value)
                if mp.isfinite(exact.error):
                    assert near(found, exact.value, scale), (line.left, line.right, row)
                    compared += 1
                if line in formulas.where:
                    names[line.left] = found
    assert compared > enough
    return len(lines)


@pytest.mark.parametrize("scene", ["hoop", "table", "caps"])
@pytest.mark.slow
def test_every_printed_formula_is_what_its_kernel_computes(scene: str) -> None:
    letters, count = SceneNotation(scene_model(scene).scene), 0
    known = {line.means: line.left for line in page(scene).brief.lines}
    for seed, formulas in enumerate(formulas_of(page(scene), known)):
        if formulas.lines:
            count += assert_printed_as_meant(formulas, letters, seed)
    assert count > 600 if scene == "hoop" else count > 400


@pytest.mark.slow
def test_printed_boxes_and_printed_friction_are_what_is_meant() -> None:
    """The court has both: their surfaces, their searches and the law, not the whole page."""
    letters = SceneNotation(COURT)
    brief, count = Abbreviations(COURT, letters), 0
    known = {line.means: line.left for line in brief.definitions}
    boxes = [surface for surface in COURT.surfaces if isinstance(surface, Box)]
    parts = (
        contact_text(COURT, letters),
        *(surface_text(surface, COURT.flight, brief) for surface in COURT.surfaces),
        *(search_text((box,), COURT.flight, letters) for box in boxes),
    )
    for seed, formulas in enumerate(formulas_of(parts, known)):
        if formulas.lines:
            count += assert_printed_as_meant(formulas, letters, seed)
    assert len(boxes) == 2
    assert count > 60


def all_lines(scene: str) -> Iterator[Line]:
    for formulas in formulas_of(page(scene), {}):
        yield from (*formulas.lines, *formulas.where)


@pytest.mark.slow
def test_the_page_says_what_is_evaluated_and_nothing_else() -> None:
    """But for the impact's vectors and matrices, whose numbers are printed too."""
    shown = set()
    for line in all_lines("hoop"):
        for sign in ("=", r"\leftarrow"):
            shown.add(f"{line.left} &{sign} " + " \\\\\n&\\quad ".join(line.rows))
    unread = 0
    for block in re.findall(r"\\begin\{aligned\}\n(.*?)\n\\end\{aligned\}", TEXT, re.DOTALL):
        for line in re.split(r" \\\\\n(?!&\\quad)", block):
            unread += line not in shown
    assert unread == 6 + 3, "six equations of an impact and three of vectors"
    for line in all_lines("hoop"):
        right = " \\\\\n&\\quad ".join(line.rows)
        assert right in TEXT, line.left


@pytest.mark.parametrize(
    ("printed", "wrong"),
    [
        ("2^{-14}", "2^{-20}"),
        (r"\overline Z_1", r"\underline A_2"),
        (r"\max", r"\min"),
        ("V^2", "L"),
        (" + ", " - "),
        (r"0 \le", "0 <"),
        ("<", r"\le"),
    ],
)
@pytest.mark.slow
def test_what_is_wrong_in_print_is_seen(printed: str, wrong: str) -> None:
    """A factor, a name, a sign, a function, a condition at equality."""
    a, b = symbols("a b", real=True)
    (search,) = page("hoop").searches
    nothing = barrier(maximum(a, b)) - barrier(maximum(b, a))
    at_zero = {"x": IfLess(0, nothing, a + b, a - b), "y": IfAtMost(0, nothing, 1, 2)}
    prepared = page("hoop").kernels["ring_prepare"].formulas
    parts = (prepared, search.named, explain(at_zero))
    letters, seen = SceneNotation(model().scene), 0
    for seed, formulas in enumerate(parts):
        for k, line in enumerate((*formulas.where, *formulas.lines)):
            if printed not in line.right:
                continue
            rows = tuple(row.replace(printed, wrong) for row in line.rows)
            lines = [*formulas.where, *formulas.lines]
            lines[k] = Line(line.left, rows, line.means)
            many = len(formulas.where)
            faulty = Formulas(tuple(lines[many:]), tuple(lines[:many]), formulas.given)
            try:
                assert_printed_as_meant(faulty, letters, seed)
            except AssertionError:
                seen += 1
    assert seen > 0


@pytest.mark.slow
def test_another_scene_has_a_page_of_its_own() -> None:
    """Neither a word nor a formula of the hoop's."""
    monkey = pytest.MonkeyPatch()
    with monkey.context() as patch:
        patch.setattr(render, "build", lambda _: scene_model("table"))
        text = render.render_scene(TABLE)["derivation_table.md"]
    assert re.findall(r"\b(?:ring|bridge|backboard|board|hoop|rim)\b", text, re.IGNORECASE) == []
    assert r"R_{\mathrm{dome}}" in text
    assert not re.search(r"R_H|a_0|\\hat R", text)
    assert "| $R_B$ | `marble` |" in text, "the ball's radius has the same letter in every scene"
    ends = re.search(
        r"^\| made \| ground \| \$.*\\le 0\$ \|\n\| missed \| ground \| every", text, re.M
    )
    assert ends is not None


PAGES = Path(render.__file__).parents[2] / "templates"
PAGE_TEMPLATES = sorted([*PAGES.glob("*.md.j2"), *PAGES.glob("derivation/*.md.j2")])


@pytest.mark.parametrize("template", PAGE_TEMPLATES, ids=lambda file: file.name)
def test_nothing_is_typed_in_the_template_that_derive_has(template: Path) -> None:
    typed = re.sub(r"\{\{.*?\}\}|\{%.*?%\}", "", template.read_text(encoding="utf-8"))
    assert not re.search(r"2\^|10\^|\^\{-\d\d", typed), "a power is a constant"
    own = {p.latex for p in model().scene.parameters if len(p.latex) > 1}
    assert [latex for latex in own if latex in typed] == []
    words = {surface.name for surface in model().scene.surfaces} - {"ring"}
    assert [word for word in words if re.search(rf"\b{word}\b", typed)] == []


@pytest.mark.slow
def test_the_outline_has_every_node_of_the_loop_once() -> None:
    loop = model().loop
    nodes = [node for stage in loop.stages.values() for node in walk(stage)]
    lines = page("hoop").outline.splitlines()
    assert len(lines) == len(nodes) + len(loop.stages)
    for name in loop.called:
        assert any(f"`{name}`" in line for line in lines)
    kernels = [node for node in nodes if isinstance(node, Call)]
    assert sum(line.lstrip().startswith(("- [`", "- `")) for line in lines) == len(kernels)


@pytest.mark.parametrize("scene", ["hoop", "table", "caps"])
@pytest.mark.slow
def test_every_argument_of_a_kernel_is_explained(scene: str) -> None:
    """Each is in a table or explained by its form, and no two of a kernel are written alike."""
    rows = {row.name for row in page(scene).arguments}
    for made in scene_model(scene).kernels:
        for argument in made.arguments:
            told = isinstance(argument, ParameterSymbol) or structured(argument.name)
            assert told or argument.name in rows, argument
            assert told or not latex_name(argument.name).startswith(r"\delta_"), argument


# Names of quantities


def test_a_name_changes_nothing_but_what_a_quantity_is_called() -> None:
    a, b = symbols("a b", real=True)
    bare, named, other = barrier(a + b), barrier(a + b, "Z"), barrier(a + b, "Y")
    assert named != bare
    assert named != other
    assert named == barrier(a + b, "Z")
    assert (bare.name, named.name, barrier(named).name, barrier(named, "Y")) == (
        "",
        "Z",
        "Z",
        other,
    )
    assert named.subs(a, 2 * b) == barrier(3 * b, "Z")
    assert isinstance(named, Barrier)
    assert release(named) == a + b
    assert barrier(a, "Z") == a
    assert pickle.loads(pickle.dumps(named)) == named
    for make in (lambda h: 2 * h - b / h + h**2, lambda h: IfLess(h, b, b - h, h * a)):
        programs = [lower(kernel("f", {"x": make(h)}, (a, b), "", "")) for h in (bare, named)]
        assert programs[0].operations == programs[1].operations
        assert programs[0].outputs == programs[1].outputs


def test_a_named_quantity_is_defined_by_its_name() -> None:
    a, b = symbols("a b", real=True)
    total = barrier(a + b, "Z")
    formulas = explain({"f": total**2, "Z": total, "g": total})
    assert [(line.left, line.right) for line in formulas.where] == [("Z", "a + b")]
    assert [line.right for line in formulas.lines] == ["Z^{2}", "a + b", "Z"]
    with pytest.raises(ValueError, match="two quantities are called Z"):
        explain({"f": total * barrier(a - b, "Z")})


@pytest.mark.parametrize(
    ("value", "latex"),
    [
        (INFLATION_FACTOR, r"\left(1 + 2^{-14}\right)"),
        (6 * INFLATION_FACTOR, r"6 \left(1 + 2^{-14}\right)"),
        (4 * UNIT_ROUNDOFF, rf"4 {ROUNDOFF}"),
        (UNIT_ROUNDOFF * (1 + sp.Rational(1, 2**10)), rf"{ROUNDOFF} \left(1 + 2^{{-10}}\right)"),
        (sp.Rational(3, 2**600), r"3 \cdot 2^{-600}"),
        (sp.Integer(2) ** 450, "2^{450}"),
        (sp.Rational(3, 8), None),
        (sp.Integer(65), None),
    ],
)
def test_a_number_is_written_by_powers_of_two(value: sp.Rational, latex: str | None) -> None:
    assert number(value) == latex
    if latex:
        with mp.workdps(300):
            names = {ROUNDOFF: mpf(UNIT_ROUNDOFF.p) / UNIT_ROUNDOFF.q}
            assert read(latex, names) == mpf(value.p) / value.q


def test_a_condition_that_is_used_twice_has_a_name() -> None:
    a, b = symbols("a b", real=True)
    both = all_of(Less(a, b), Less(b, 2 * a), Boolean("sure"))
    formulas = explain({"x": Choose(both, a, b), "y": Choose(both, b, a)})
    (where,) = formulas.where
    assert where.left == "B_{1}"
    assert where.right == r"a < b \wedge b < 2 a \wedge \text{sure}"
    assert show(both) == where.right
