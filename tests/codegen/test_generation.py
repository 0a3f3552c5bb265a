"""Printers of expressions, and generation, which gives the same bytes every time."""

from __future__ import annotations

import ast
import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from importlib.metadata import version
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import jinja2
import jinja2.meta
import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.ir.kernel import Kernel, kernel
from hoopgen.derive.scenes.hoop import HOOP
from hoopgen.derive.symbolic.conditionals import (
    And,
    AtMost,
    Choose,
    Equal,
    IfAtMost,
    IfLess,
    Less,
    Not,
    Or,
    absolute,
    all_of,
    any_of,
    barrier,
    false,
    maximum,
    minimum,
)
from mpmath import mp, mpf

from hoopgen.codegen import committed, render
from hoopgen.codegen.backend import LoweredScene
from hoopgen.codegen.c.spelling import LANES
from hoopgen.codegen.formatter import Spelling
from hoopgen.codegen.hoisting import partial_evaluations
from hoopgen.codegen.js import JS
from hoopgen.codegen.numpy.spelling import NUMPY
from hoopgen.codegen.program import derivation_hash, lower
from hoopgen.codegen.registry import BACKENDS
from hoopgen.core.owned_folders import MARKER, marker_text
from hoopgen.engine.c_build import FLAGS
from tests.codegen.test_kernels import DIGITS, EXTREMES, Evaluator, model
from tests.helpers import ROOT
from tests.helpers.compiled import (
    WARNINGS,
    WIDTHS,
    CKernels,
    compiles,
    load_module,
    needs_compiler,
    same_bits,
)
from tests.helpers.effort import trials

# One worker: the derivation takes a few seconds.
pytestmark = pytest.mark.xdist_group("codegen")

a, b, c, d = ARGUMENTS = sp.symbols("a b c d", real=True)


# The zoo: every operation of the printers, and every shape that an expression takes


def _nest(depth: int) -> sp.Expr:
    nested: sp.Expr = a
    for k in range(depth):
        nested = sp.sqrt(1 + nested**2) if k % 3 else (b - nested) / (k + 2)
    return nested


def _tree(depth: int) -> sp.Expr:
    if not depth:
        return IfLess(a, b, c, d)
    return IfAtMost(_tree(depth - 1) * a, b, maximum(c, _tree(depth - 1)), minimum(d, a + depth))


_SHARED = barrier((a + b) * (c - d))

ZOO = {
    "sum": a + b + c + d,
    "difference": a - b - c + d,
    "all_negative": -a - b - c,
    "product": a * b * c * d,
    "negated_product": -a * b * c,
    "quotient": a / b,
    "quotients": a * b / (c * d),
    "negated_quotient": -3 * a / (7 * b),
    "quotient_of_sums": (a - b) / (c + d),
    "negated_difference": sp.Mul(-1, a - b, c, evaluate=False),
    "held": 2 * barrier(a + b) - barrier(a - barrier(b * c)),
    "negated_held": -barrier(a - b),
    "root": sp.sqrt(absolute(a)),
    "root_of_sum": sp.sqrt(a**2 + b**2),
    "one_over_root": 1 / sp.sqrt(1 + c**2),
    "size": absolute(a - b) + absolute(-c),
    "square": a**2,
    "powers": a**3 + b**4 - c**5 + d**7,
    "high_power": a**13,
    "negative_power": a**-1 + b**-2 - c**-3,
    "half_powers": absolute(a) ** sp.Rational(3, 2) + absolute(b) ** sp.Rational(5, 2),
    "negative_half_powers": absolute(a) ** sp.Rational(-1, 2) * absolute(b) ** sp.Rational(-7, 2),
    "rationals": a / 3 + sp.Rational(2, 7) * b - sp.Rational(10, 3),
    "decimals": sp.Rational(1, 10) * a + sp.Float("0.1") * b - sp.Rational(-3, 10) * c,
    "large_and_small": sp.Integer(10) ** 23 * a + sp.Rational(1, 2**600) * b,
    "halves": a / 2 - b / 4 + 3 * c / 8,
    "less": IfLess(a, b, c, d),
    "at_most": IfAtMost(a, b, c, d),
    "infinity": IfLess(a, b, sp.oo, -sp.oo),
    "below_infinity": IfLess(a, sp.oo, b, IfAtMost(-sp.oo, a, c, d)),
    "less_in_sum": 2 * IfLess(a, b, c, d) - IfAtMost(0, a, b, 3),
    "nested_choices": _tree(4),
    "largest": maximum(a, b, c, 0),
    "smallest": minimum(d, c, b, 1),
    "both": Choose(all_of(Less(a, b), Less(b, c), AtMost(c, d)), a, d),
    "either": Choose(any_of(Less(a, b), Equal(b, a), false), c, d),
    "complement": Choose(Not(And(Less(a, b), Or(AtMost(b, c), Less(c, a)))), b, c),
    "equal": IfLess(Choose(Equal(a, b), 1, 0), c, d, 2),
    "masked_root": IfLess(a, 0, b, sp.sqrt(a)),
    "shared": _SHARED**2 + _SHARED * a + sp.sqrt(absolute(_SHARED)),
    "shared_again": _SHARED / (1 + _SHARED**2),
    "deep": _nest(60),
    "argument": a,
    "constant": sp.Rational(22, 7),
    "zero": sp.Integer(0),
    "minus_one": sp.Integer(-1),
}
ZOO_KERNELS = [
    *(Kernel(name, ARGUMENTS, ((name, e),), f"The {name}.", "zoo") for name, e in ZOO.items()),
    kernel("all_at_once", ZOO, ARGUMENTS, "All of them, sharing what they share.", "zoo"),
    kernel("no_argument", {"one": 1, "third": sp.Rational(1, 3)}, ARGUMENTS, "Constants.", "zoo"),
]
OPERATIONS = set(NUMPY.operations)

TEMPLATES = render.outputs() | render.PAGES
"""The templates of every target and of the pages, and the file that each makes."""

SHARED = {file for file in render.outputs().values() if "{scene}" not in file}
"""The files that are the same for every scene."""


@cache
def contexts() -> dict[str, dict[str, Any]]:
    """Return the keys that each template is given for the hoop, by template."""
    given: dict[str, dict[str, Any]] = {}

    def note(template: jinja2.Template, context: dict[str, Any]) -> str:
        given[str(template.name)] = context
        return ""

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(jinja2.Template, "render", note)
        patch.setattr(render, "build", lambda _: model())
        render.render_scene(HOOP)
    return given


def printed(template: str, kernels: list[Kernel], **context: Any) -> str:
    """Return kernels, printed by the template of a target as if they were the hoop's."""
    given = contexts()[template] | views(template.partition("/")[0], kernels) | context
    backend = BACKENDS[template.partition("/")[0]]
    return render._environment(backend).get_template(template).render(given)


def views(target: str, kernels: list[Kernel]) -> dict[str, Any]:
    """Return what the templates of a target are given of kernels, as if the loop called them."""
    programs, called = list(map(lower, kernels)), frozenset(k.name for k in kernels)
    own = LoweredScene(model(), programs, (), called, "")
    return dict(BACKENDS[target].kernels(own))


@pytest.fixture(scope="module")
def zoo_numpy(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    source = tmp_path_factory.mktemp("numpy") / "zoo.py"
    source.write_text(printed("numpy/kernels.py.j2", ZOO_KERNELS), encoding="utf-8")
    return load_module(source)


@pytest.fixture(scope="module")
def zoo_c(tmp_path_factory: pytest.TempPathFactory) -> Callable[[int], CKernels]:
    header, folder = printed("c/kernels.h.j2", ZOO_KERNELS), tmp_path_factory.mktemp("c")
    return cache(lambda width: CKernels(header, ZOO_KERNELS, "hoop", folder, width))


def zoo_columns(rows: int) -> list[np.ndarray]:
    """Return columns of the four arguments: ordinary, small and large, equal, and extreme."""
    rng = np.random.default_rng(5)
    columns = rng.normal(0, 1, (4, rows)) * 10.0 ** rng.choice([-3, 0, 0, 0, 2], (4, rows))
    columns[1, ::7] = columns[0, ::7]
    extreme = rng.random((4, rows)) < 0.5
    extreme[:, : rows // 2] = False
    return list(np.where(extreme, rng.choice(EXTREMES, (4, rows)), columns))


def zoo_outputs(module: ModuleType, k: Kernel, columns: list[np.ndarray]) -> list[np.ndarray]:
    """Return what the printed NumPy function gives, a column for each output."""
    rows = len(columns[0])
    with np.errstate(all="ignore"):
        outputs = getattr(module, k.name)(*columns[: len(k.arguments)])
    return [np.broadcast_to(np.asarray(o, np.float64), (rows,)) for o in outputs]


def test_the_zoo_holds_every_operation_of_every_target() -> None:
    used = {o.name for k in ZOO_KERNELS for o in lower(k).operations}
    assert (
        used - {"argument", "constant"} == OPERATIONS == set(LANES.operations) == set(JS.operations)
    )


@pytest.mark.slow
@needs_compiler
@pytest.mark.parametrize("width", WIDTHS)
def test_the_zoo_has_the_same_bits_in_numpy_and_c(
    zoo_numpy: ModuleType, zoo_c: Callable[[int], CKernels], width: int
) -> None:
    """At ordinary and at extreme inputs, zeros' signs included."""
    columns = zoo_columns(2001)
    for k in ZOO_KERNELS:
        numpy = zoo_outputs(zoo_numpy, k, columns)
        c_ = zoo_c(width)(k.name, columns[: len(k.arguments)], len(columns[0]))
        for name, left, right in zip(k.output_names, numpy, c_, strict=True):
            assert same_bits(left, right).all(), name


@pytest.mark.slow
def test_the_zoo_has_the_same_bits_for_rows_and_for_one_shot(tmp_path: Path) -> None:
    """At ordinary and at extreme inputs, zeros' signs included."""
    source = tmp_path / "zoo.py"
    one = SimpleNamespace(called={k.name for k in ZOO_KERNELS}, lines=[])
    text = printed("numpy/kernels.py.j2", ZOO_KERNELS, alone=one)
    source.write_text(text, encoding="utf-8")
    module, columns = load_module(source), zoo_columns(301)
    for k in ZOO_KERNELS:
        rows, alone = zoo_outputs(module, k, columns), getattr(module, f"_{k.name}_alone")
        with np.errstate(all="ignore"):
            found = [alone(*shot[: len(k.arguments)]) for shot in zip(*columns, strict=True)]
        for name, left, right in zip(k.output_names, rows, zip(*found, strict=True), strict=True):
            assert same_bits(left, np.asarray(right, np.float64)).all(), name


def test_an_expression_has_the_same_bits_alone_and_among_others(zoo_numpy: ModuleType) -> None:
    """A shared expression is computed once, with the bits it has alone."""
    columns = zoo_columns(2001)
    together = next(k for k in ZOO_KERNELS if k.name == "all_at_once")
    outputs = zoo_outputs(zoo_numpy, together, columns)
    for name, among in zip(together.output_names, outputs, strict=True):
        alone = next(k for k in ZOO_KERNELS if k.name == name)
        assert same_bits(zoo_outputs(zoo_numpy, alone, columns)[0], among).all(), name


@pytest.mark.sampled(23)
@pytest.mark.parametrize("name", ZOO)
def test_the_zoo_has_the_values_of_its_expressions(zoo_numpy: ModuleType, name: str) -> None:
    """Within the running-error bound, which no factor widens; what is undecided is not compared."""
    rows = 100
    columns = [column[:rows] for column in zoo_columns(10 * rows)]
    k = next(k for k in ZOO_KERNELS if k.name == name)
    (found,) = zoo_outputs(zoo_numpy, k, columns)
    compared = 0
    for row in range(rows):
        with mp.workdps(DIGITS):
            values = {s.name: column[row] for s, column in zip(ARGUMENTS, columns, strict=True)}
            exact, computed = Evaluator(values)(ZOO[name]), mpf(float(found[row]))
            if exact.error == mp.inf:
                continue
            compared += 1
            if mp.isfinite(exact.value):
                assert abs(computed - exact.value) <= exact.error
            else:
                assert repr(computed) == repr(exact.value)
    assert compared >= 0.99 * rows


@pytest.mark.slow
def test_a_kernel_may_need_any_number_of_rows(tmp_path: Path) -> None:
    """Python takes no more than 255 names before the rest of what it unpacks."""
    terms = [sp.sqrt(1 + (a - k) ** 2) for k in range(300)]
    totals = {"total": sum(terms), "squares": sum(barrier(t * t) for t in terms)}
    wide = kernel("wide", totals, ARGUMENTS, "All terms are kept until the second sum.", "zoo")
    (view,) = views("numpy", [wide])["kernels"]
    rows = view.numpy.rows
    assert rows > 256
    source = tmp_path / "wide.py"
    source.write_text(printed("numpy/kernels.py.j2", [wide], rows=rows + 1), encoding="utf-8")
    module = load_module(source)
    shots = module.FEW
    given = np.linspace(-1000.0, 1000.0, shots)
    room = tuple(np.empty((rows + 1, shots)))
    own = [column.copy() for column in module.wide(given)]
    for column, in_rows in zip(own, module.wide(given, room), strict=True):
        assert same_bits(column, in_rows).all()
    total = sum(np.sqrt(1 + (given - k) ** 2) for k in range(300))
    # All terms are positive: a rounding for each sum, and a few of each term, both ways.
    np.testing.assert_allclose(own[0], total, rtol=2 * 310 * np.finfo(float).eps, atol=0)


def test_equal_parts_are_computed_once() -> None:
    product = (a + b) * (a - b)
    program = lower(kernel("shared", {"x": product + 1, "y": product - 1}, ARGUMENTS, "", ""))
    assert program.cost == {"add": 2, "sub": 2, "mul": 1}


def test_a_power_costs_its_squarings() -> None:
    cost = lower(kernel("power", {"x": a**13}, ARGUMENTS, "", "")).cost
    assert cost == {"mul": 5}  # a^13 = a^8 a^4 a: three squarings, two products
    cost = lower(kernel("power", {"x": (1 + a) ** sp.Rational(3, 2)}, ARGUMENTS, "", "")).cost
    assert cost == {"add": 1, "sqrt": 1, "mul": 1}


def test_divisors_are_multiplied_and_divided_by_once() -> None:
    cost = lower(kernel("ratio", {"x": a / (b * c * d)}, ARGUMENTS, "", "")).cost
    assert cost == {"mul": 2, "div": 1}


# Constants


@pytest.mark.parametrize("spelling", [NUMPY, LANES], ids=["numpy", "c"])
def test_a_constant_reads_back_to_the_same_bits(spelling: Spelling) -> None:
    rng = np.random.default_rng(6)
    bits = rng.integers(
        0, 0x7FF0 << 48, trials(5000), dtype=np.int64
    )  # any finite double, denormals too
    doubles = [*bits.view(np.float64), *(v for v in EXTREMES if np.isfinite(v)), 0.1, 2 / 3, 1e22]
    for value in map(float, doubles):
        for signed in (value, -value):
            text = spelling.number_text(signed).removeprefix("K(").removesuffix(")")
            assert same_bits(float(text), signed), text


def test_a_rational_becomes_the_nearest_double() -> None:
    rng = np.random.default_rng(7)
    count = trials(2000)
    numerators = rng.integers(-(2**62), 2**62, count)
    denominators = rng.integers(1, 2 ** rng.integers(1, 62, count))
    for p, q in zip(map(int, numerators), map(int, denominators), strict=True):
        (operation,) = lower(Kernel("x", (), (("x", sp.Rational(p, q)),), "", "")).operations
        assert operation.value == float(Fraction(p, q))


def test_no_constant_is_a_negative_zero() -> None:
    (operation,) = lower(Kernel("x", (), (("x", sp.Float(-0.0)),), "", "")).operations
    assert same_bits(operation.value, 0.0)


# What is refused


@pytest.mark.parametrize(
    "expression",
    [
        sp.sin(a),
        sp.exp(a),
        sp.log(a),
        sp.atan2(a, b),
        a**b,
        2**a,
        sp.cbrt(a),
        sp.sqrt(sp.sqrt(a)),
        sp.I * a,
        sp.Piecewise((a, a < b), (b, True)),
        sp.floor(a),
    ],
    ids=str,
)
def test_what_doubles_do_not_round_exactly_is_refused(expression: sp.Expr) -> None:
    """The message names the kernel, so that one finds the formula."""
    with pytest.raises(TypeError, match=r"^kernel odd: "):
        lower(kernel("odd", {"x": expression}, ARGUMENTS, "", ""))


def test_a_kernel_takes_all_that_it_uses() -> None:
    with pytest.raises(ValueError, match=r"^kernel odd: not among its arguments: b, d$"):
        Kernel("odd", (a, c), (("x", a + b), ("y", c * d)), "", "")


def test_a_kernel_takes_nothing_that_it_does_not_use() -> None:
    made = kernel("even", {"x": c - a, "y": 3}, ARGUMENTS, "", "")
    assert made.arguments == (a, c)
    assert made.expressions == (c - a, sp.Integer(3))


# The files


@pytest.fixture(scope="module")
def files() -> dict[str, str]:
    """The files as they are committed."""
    root = ROOT / "generated"
    names = [*json.loads((root / MARKER).read_bytes())["files"], MARKER]
    there = {name: root / name for name in names if "*" not in name}
    return {name: file.read_text(encoding="utf-8") for name, file in there.items()}


def file_of(template: str) -> str:
    """Return the file of the hoop that a template makes."""
    return TEMPLATES[template].format(scene="hoop")


@pytest.fixture
def checkout(tmp_path: Path, files: dict[str, str], monkeypatch: pytest.MonkeyPatch) -> Path:
    """A checkout whose generated/ is up to date; nothing is derived again."""
    monkeypatch.setattr(committed, "render_all", lambda: dict(files))
    committed.generate(tmp_path)
    for name in committed.KEPT:
        (tmp_path / "generated" / name).write_text("", encoding="utf-8")
    return tmp_path


def test_the_hoop_s_sources_are_up_to_date(files: dict[str, str]) -> None:
    """Otherwise: `make generate`; pages and other scenes take longer to render."""
    again = render.render_scene(HOOP, page=False)
    assert [name for name, text in again.items() if files[name] != text] == []


def test_what_is_generated_is_what_is_committed_and_nothing_else(files: dict[str, str]) -> None:
    own = {file_of(template) for template in TEMPLATES}
    other = {file.format(scene="court") for file in render.outputs().values()}
    sceneless = set(render.render_elementary() | render.render_studies())
    assert set(files) == own | other | sceneless | {"derivation_court.md", "hoopgen.json"}
    assert not set(files) & set(committed.KEPT)
    assert all(text.endswith("\n") and "\r" not in text for text in files.values())


_GENERATE = """
import sys
from pathlib import Path
from hoopgen import codegen
codegen.generate(Path(sys.argv[1]))
"""


@pytest.mark.slow
def test_generation_gives_the_committed_bytes_whatever_the_order_of_python_s_sets(
    tmp_path: Path, files: dict[str, str]
) -> None:
    """With Python's sets in one order; `make check` has another in each process."""
    environment = os.environ | {"PYTHONHASHSEED": "4711"}
    subprocess.run([sys.executable, "-c", _GENERATE, str(tmp_path)], env=environment, check=True)
    root = tmp_path / "generated"
    written = [path for path in root.rglob("*") if path.is_file()]
    expected = {name: text.encode() for name, text in files.items()}
    assert {p.relative_to(root).as_posix(): p.read_bytes() for p in written} == expected


_GENERATE_ANEW = """
import sys
sys.modules["hoopgen.generated.numpy"] = None  # as if it were not there
from hoopgen.cli import main
from hoopgen import codegen
codegen.generate = lambda root, _: []
main(["generate", "--root", sys.argv[1]])
"""


@pytest.mark.slow
def test_generation_needs_nothing_that_is_generated(tmp_path: Path) -> None:
    """Otherwise what generated/ lacks could not be generated."""
    for name in ("derive", "templates"):
        (tmp_path / name).mkdir()
    command = [sys.executable, "-c", _GENERATE_ANEW, str(tmp_path)]
    result = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    assert result.stdout == "nothing to write: generated/ is up to date\n", result.stderr


def test_only_what_changed_is_written(checkout: Path) -> None:
    root = checkout / "generated"
    written = sorted(path for path in root.rglob("*") if path.is_file())
    for path in written:
        os.utime(path, (0, 0))
    assert committed.generate(checkout) == []
    stale = root / "c" / "hoop.h"
    stale.write_text("/* edited */\n", encoding="utf-8")
    os.utime(stale, (0, 0))
    assert committed.generate(checkout) == [stale]
    assert [path for path in written if path.stat().st_mtime] == [stale]


def test_generation_removes_what_is_no_longer_generated(
    checkout: Path, files: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    root = checkout / "generated"
    older = {"c/hoop_old.h": "", **{name: text for name, text in files.items() if name != MARKER}}
    older[MARKER] = marker_text(committed.PURPOSE, older)
    with monkeypatch.context() as patch:
        patch.setattr(committed, "render_all", lambda: dict(older))
        assert committed.generate(checkout) == [root / MARKER, root / "c" / "hoop_old.h"]
    assert committed.generate(checkout) == [root / MARKER, root / "c" / "hoop_old.h"]
    assert not (root / "c" / "hoop_old.h").exists()
    assert (root / MARKER).read_text(encoding="utf-8") == files[MARKER]
    assert all((root / name).exists() for name in committed.KEPT)


def test_generation_leaves_files_that_it_did_not_make(checkout: Path) -> None:
    """`check` names them, and only who put them there removes them."""
    extra = checkout / "generated" / "c" / "notes.h"
    extra.write_bytes(b"mine")
    assert committed.generate(checkout) == []
    assert extra.read_bytes() == b"mine"
    assert committed.check(checkout) == ["extra file: generated/c/notes.h"]


def test_generation_leaves_a_folder_that_is_not_its_own(
    tmp_path: Path, files: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(committed, "render_all", lambda: dict(files))
    (tmp_path / "generated" / "c").mkdir(parents=True)
    theirs = tmp_path / "generated" / "c" / "hoop.c"
    theirs.write_bytes(b"theirs")
    with pytest.raises(ValueError, match=r"generated holds files that hoopgen did not make: c; "):
        committed.generate(tmp_path)
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == [theirs]
    assert theirs.read_bytes() == b"theirs"


def test_generation_takes_no_name_that_another_file_has(checkout: Path) -> None:
    """A merge may bring such a file and leave the marker behind."""
    root = checkout / "generated"
    marker = json.loads((root / MARKER).read_bytes())
    marker["files"].remove("c/hoop.c")
    (root / MARKER).write_text(json.dumps(marker), encoding="utf-8")
    same = (root / "c" / "hoop.c").read_bytes()
    (root / "c" / "hoop.c").write_bytes(b"theirs")
    with pytest.raises(FileExistsError, match="hoopgen did not make this file") as raised:
        committed.generate(checkout)
    assert raised.value.filename == str(root / "c" / "hoop.c")
    assert (root / "c" / "hoop.c").read_bytes() == b"theirs"
    (root / "c" / "hoop.c").write_bytes(same)
    assert committed.generate(checkout) == [root / MARKER]


@pytest.mark.skipif(os.name != "posix", reason="links need rights elsewhere")
def test_generation_follows_no_link(checkout: Path, tmp_path: Path) -> None:
    root = checkout / "generated"
    (root / "js").rename(tmp_path / "elsewhere")
    (root / "js").symlink_to(tmp_path / "elsewhere")
    (tmp_path / "elsewhere" / "hoop.js").write_bytes(b"theirs")
    elsewhere = {file: file.read_bytes() for file in (tmp_path / "elsewhere").iterdir()}
    linked = tmp_path / "linked.h"
    (root / "c" / "hoop.h").replace(linked)
    (root / "c" / "hoop.h").symlink_to(linked)
    linked.write_bytes(b"theirs")
    with pytest.raises(FileExistsError, match="is a link") as raised:
        committed.generate(checkout)
    assert raised.value.filename == str(root / "js")
    assert {file: file.read_bytes() for file in (tmp_path / "elsewhere").iterdir()} == elsewhere
    (root / "js").unlink()
    committed.generate(checkout)
    assert linked.read_bytes() == b"theirs"
    assert not (root / "c" / "hoop.h").is_symlink()


def test_check_is_empty_on_what_was_generated(checkout: Path) -> None:
    (checkout / "generated" / "numpy" / "__pycache__").mkdir()
    (checkout / "generated" / "numpy" / "__pycache__" / "hoop.pyc").write_bytes(b"")
    assert committed.check(checkout) == []


def test_check_shows_a_stale_a_missing_and_an_extra_file(checkout: Path) -> None:
    """A stale file as a difference that names it and shows the line, the others in one line."""
    root = checkout / "generated"
    stale = root / "c" / "hoop.h"
    text = stale.read_text(encoding="utf-8").replace("#define HOOP_STATE 9", "#define HOOP_STATE 8")
    stale.write_text(text, encoding="utf-8")
    (root / "numpy" / "hoop.py").unlink()
    (root / "c" / "hoop_old.h").write_text("", encoding="utf-8")
    extra, *others = committed.check(checkout)
    assert extra == "extra file: generated/c/hoop_old.h"
    assert "missing file: generated/numpy/hoop.py" in others
    (difference,) = (entry for entry in others if "\n" in entry)
    lines = difference.splitlines()
    assert lines[0].startswith("--- generated/c/hoop.h (as it is)")
    assert lines[1].startswith("+++ generated/c/hoop.h (as derived)")
    assert "-#define HOOP_STATE 8" in lines
    assert "+#define HOOP_STATE 9" in lines
    assert len(lines) <= 7  # one line of context on either side
    assert len(others) == 2


# The templates


def test_a_template_that_asks_for_an_unknown_key_fails() -> None:
    environment = render._environment()
    for text in ("{{ unknown }}", "{{ scene.unknown }}", "{% if unknown %}{% endif %}"):
        with pytest.raises(jinja2.UndefinedError, match="unknown"):
            environment.from_string(text).render(scene=HOOP)


def test_the_templates_ask_for_the_keys_that_are_supplied_and_no_other() -> None:
    # Names alone: pytest would print all that is supplied, which takes minutes.
    supplied = {name: set(given) for name, given in contexts().items()}
    asked = {}
    for name in supplied:
        environment = render._environment(BACKENDS.get(name.partition("/")[0]))
        assert environment.loader is not None
        source, _, _ = environment.loader.get_source(environment, name)
        asked[name] = jinja2.meta.find_undeclared_variables(environment.parse(source))
        assert asked[name] <= supplied[name]
    assert set().union(*asked.values()) == set().union(*supplied.values())


# The C


@pytest.mark.slow
@needs_compiler
@pytest.mark.parametrize(
    "how",
    [["-fsyntax-only"], pytest.param(["-c", "-DHOOP_ONLY=4"], marks=pytest.mark.slow)],
    ids=["all_widths", "optimised"],
)
def test_the_c_compiles_without_a_warning(
    tmp_path: Path, files: dict[str, str], how: list[str]
) -> None:
    """C11 of all widths, and four lanes with the optimisation that some warnings need."""
    for name, text in files.items():
        (tmp_path / Path(name).name).write_text(text, encoding="utf-8")
    compiles(*FLAGS, *WARNINGS, "-std=c11", *how, tmp_path / "hoop.c", "-o", tmp_path / "o")


@pytest.mark.skipif(shutil.which("g++") is None, reason="no C++ compiler")
def test_the_header_is_c_plus_plus_too(tmp_path: Path, files: dict[str, str]) -> None:
    (tmp_path / "hoop.h").write_text(files["c/hoop.h"], encoding="utf-8")
    (tmp_path / "user.cpp").write_text('#include "hoop.h"\n#include "hoop.h"\n', encoding="utf-8")
    command = ["g++", "-std=c++17", "-fsyntax-only", "-pedantic", *WARNINGS, tmp_path / "user.cpp"]
    result = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    assert result.returncode == 0, result.stderr


# What the files say


def test_each_file_opens_with_its_stamp(files: dict[str, str]) -> None:
    """Template, scene, hash of the derivation, versions, and that nobody edits it."""
    hashes = set()
    for template, file in TEMPLATES.items():
        opening = " ".join(files[file_of(template)].split()[:80])
        if file in SHARED:
            made = f"Generated from templates/{template}, the same for every scene, with Jinja2 "
            assert f"{made}{version('jinja2')}. Do not edit: change templates/ " in opening
            continue
        match = re.search(
            r"Generated from templates/(\S+), scene (\S+), derivation ([0-9a-f]{16}), "
            r"with SymPy (\S+) and Jinja2 (\S+)\. Do not edit: change derive/ or templates/ "
            r"and run `make generate`\.",
            opening,
        )
        assert match, template
        assert match[1] == template
        assert match[2] == "hoop"
        assert match[4] == version("sympy")
        assert match[5] == version("jinja2")
        hashes.add(match[3])
    assert len(hashes) == 1


def test_what_is_of_no_scene_says_how_it_is_made(files: dict[str, str]) -> None:
    for name in render.render_elementary() | render.render_studies():
        assert f"Generated from templates/{name}.j2, the same for every scene" in files[name][:400]


def test_the_hash_of_the_derivation_changes_with_every_expression() -> None:
    def hash_of(**changed: object) -> str:
        given = {"name": "f", "outputs": {"x": a - b}} | changed
        return derivation_hash([lower(kernel(order=ARGUMENTS, summary="", equation="", **given))])

    variants = [
        hash_of(),
        hash_of(outputs={"x": b - a}),
        hash_of(outputs={"x": a - 1}),
        hash_of(outputs={"x": a - sp.Rational(1, 3)}),
        hash_of(outputs={"y": a - b}),
        hash_of(outputs={"x": a - c}),
        hash_of(name="g"),
        hash_of(outputs={"x": a - b, "y": a}),
    ]
    assert len(set(variants)) == len(variants)
    assert hash_of() == hash_of()


def numpy_operations(function: ast.FunctionDef) -> int:
    """Count the operations of a printed NumPy function.

    The sign of a constant is none, nor is it one to round that or what a kernel is given.
    """
    rounds = ("_single", "_halves", "_float32")

    def counts(node: ast.AST) -> bool:
        if isinstance(node, ast.Call) and ast.unparse(node.func) in rounds:
            return False
        if isinstance(node, ast.UnaryOp):
            constant = isinstance(node.operand, ast.Constant) or ast.unparse(node.operand) == "_inf"
            return not constant
        return isinstance(node, ast.BinOp | ast.Compare | ast.Call)

    return sum(counts(node) for statement in function.body for node in ast.walk(statement))


def stated(comment: str) -> int:
    """Return the number of operations that a comment states, which is the sum of its parts."""
    if "No operations." in comment:
        return 0
    match = re.search(r"(\d+) operations?: ((?:\d+ [a-z ]+(?:, )?)+)\.", comment)
    assert match, comment
    parts = [int(part.split()[0]) for part in match[2].split(", ")]
    assert sum(parts) == int(match[1])
    return int(match[1])


@pytest.mark.slow
def test_each_function_states_equation_and_operations(files: dict[str, str]) -> None:
    """The count is that of the operations printed below it: C is given some ready made."""
    module = ast.parse(files["numpy/hoop.py"])
    functions = {f.name: f for f in module.body if isinstance(f, ast.FunctionDef)}
    comments = {
        name: text
        for text, name in re.findall(
            r"/\*((?:(?!\*/)[\s\S])*)\*/\ntypedef struct \{[^}]*\} LANES\(hoop_(\w+)_out\);",
            files["c/hoop_kernels.h"],
        )
    }
    shortcuts = {call.kernel.name for call in model().loop.shortcuts}
    called = model().loop.called | shortcuts
    loops = (model().loop.plain(), model().loop)
    for made in model().kernels:
        document = ast.get_docstring(functions[made.name])
        assert document is not None
        for text in (document, comments.get(made.name, document)):
            assert made.summary in text
            assert made.equation
            assert f"{made.equation}. " in text
        ready = partial_evaluations([lower(made)], loops).get(made.name)
        in_c = ready.rest.cost if ready and made.name in called else lower(made).cost
        assert made.name not in comments or stated(comments[made.name]) == in_c.total()
        assert stated(document) == numpy_operations(functions[made.name])
    assert set(comments) == called, "C has what its loop evaluates"
    assert set(functions) > {made.name for made in model().kernels}


def test_what_is_rarely_done_and_long_is_a_function_of_its_own() -> None:
    """The end of bounces is such a part: inline it would take the flights' registers."""
    text = (ROOT / "generated" / "c" / "court_loop.h").read_text(encoding="utf-8")
    parts = re.split(r"^(?:static|LANES_APART) void (?=LOOP)", text, flags=re.M)
    functions = {part.split("(", 2)[1].split(")")[0]: part for part in parts[1:]}
    assert "_settling, " in functions["slow"]
    assert "_settling, " not in functions["run"]
    assert "LOOP(slow)(" in functions["run"]
