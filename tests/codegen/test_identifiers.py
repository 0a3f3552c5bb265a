"""Names and texts of a scene: whatever they are, generated code is the same, or one error says why.

A stranger's scene is data: nothing in it reaches C, Python, JavaScript or Markdown as code.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import cycle
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.ir.event_tree import reads, writes
from hoopgen.derive.model import Model, build
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.scenes.names import PUBLIC, RESERVED_NAMES
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.scenes.validity import without_assumptions
from hoopgen.derive.surfaces import Sphere, body
from hoopgen.derive.symbolic.symbols import POSITION, ParameterSymbol, variable
from hypothesis import example, given, settings
from hypothesis import strategies as st

from hoopgen.codegen import identifiers, render
from hoopgen.engine import native, numpy_backend
from hoopgen.engine.c_build import FLAGS
from hoopgen.engine.result_arrays import Layout, ResultArrays
from tests.helpers import ROOT
from tests.helpers.compiled import (
    WARNINGS,
    compiles,
    load_module,
    needs_compiler,
    same_bits,
    shared_library,
)
from tests.helpers.effort import trials
from tests.helpers.scenes.plank import PARAMETERS, plank
from tests.helpers.scenes.table import TABLE

pytestmark = pytest.mark.xdist_group("names")

CONTACTS = 6

# What means something to a language, a library, a printer, a driver, the loop, or a header.
_WORDS = """
    x vx wx nx t s0 s1 v m k o1 m1 p p_x x_0 x_1 x_ for double int if lambda none true def class
    where sqrt inf np numpy pool job lane out shot begun zero flying fresh from outcome claims turn
    next end step last which when index time flag delay late first body count count_0 rate level
    columns shots rows rows1 done main struct y0 j1 gamma signgam nan infinity let var function
    made missed state surfaces parameters body_x widest sources width lanes_select lanes vector mask
    flight impact top ground ring target own carry finite rate_margin annotations any field
"""
OUTCOMES = plank().outcomes
PUBLIC_NAMES = st.one_of(st.sampled_from(_WORDS.split()), st.from_regex(PUBLIC, fullmatch=True))


@dataclass(frozen=True)
class Engines:
    """Both targets of a scene, and what its results are."""

    module: ModuleType
    library: native.Library

    def run(self) -> tuple[ResultArrays, ResultArrays]:
        """Simulate the same shots on both, the parameters in their order."""
        parameters = [default for default, _, _ in self.module.PARAMETERS.values()]
        states, results = shots(), []
        layout = Layout(self.module)
        for run in (self._numpy, self._c):
            out = layout.allocate(len(states), layout.results)
            out = out.joined(layout.allocate_events(len(states), CONTACTS))
            run(states, parameters, out)
            results.append(out)
        return results[0], results[1]

    def _numpy(self, states: np.ndarray, parameters: list[Any], out: ResultArrays) -> None:
        numpy_backend.run(self.module, states, parameters, None, CONTACTS, out)

    def _c(self, states: np.ndarray, parameters: list[Any], out: ResultArrays) -> None:
        self.library.run(states, parameters, None, CONTACTS, out, np.zeros(1, np.int32))


def shots() -> np.ndarray:
    """Return balls let go over the plank, some beside it, one inside it."""
    rng = np.random.default_rng(1)
    states = np.zeros((60, 9))
    states[:, :3] = rng.uniform((-0.7, -0.2, 0.1), (0.7, 0.2, 0.9), (60, 3))
    states[:, 3:6] = rng.normal(0, 1, (60, 3))
    states[:, 6:] = rng.normal(0, 9, (60, 3))
    states[0, :3] = 0
    return states


def made(scene: Scene, folder: Path) -> Engines:
    """Render a scene, compile it for one width, and import it."""
    for name, text in render.render_scene(scene, page=False).items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    source = folder / "c" / f"{scene.name}.c"
    width = f"-D{scene.name.upper()}_WIDEST=1"
    library = shared_library(source, *WARNINGS, "-O0", width)
    module = load_module(folder / "numpy" / f"{scene.name}.py")
    return Engines(module, native.Library(library, module))


@pytest.fixture(scope="module")
def tame(tmp_path_factory: pytest.TempPathFactory) -> ResultArrays:
    """Return the results of the shots in the scene with its own names."""
    numpy, _ = made(plank(), tmp_path_factory.mktemp("tame")).run()
    assert numpy.outcome is not None
    assert {OUTCOMES[name] for name in ("made", "missed", "capped")} <= set(numpy.outcome)
    return numpy


def assert_same(left: ResultArrays, right: ResultArrays) -> None:
    """Check that results are the same bits."""
    for name in left.arrays.keys() - {"events"}:
        assert same_bits(getattr(left, name), getattr(right, name)).all(), name


# Names


@needs_compiler
@settings(max_examples=trials(2), deadline=None, derandomize=True, database=None)
@given(
    scene=PUBLIC_NAMES.filter(lambda name: len(name) < 30 and name not in RESERVED_NAMES),
    parameters=st.lists(PUBLIC_NAMES, min_size=6, max_size=6, unique=True),
    surfaces=st.lists(PUBLIC_NAMES, min_size=2, max_size=2, unique=True),
    law=st.one_of(st.just("impact"), PUBLIC_NAMES.map(lambda name: f"{name}_impact")),
)
@example("lane", ["x", "t", "s0", "vx", "for", "double"], ["made", "state"], "impact")
@example("for", ["pool", "where", "v", "k", "next", "p_x"], ["parameters", "x"], "x_impact")
@example("hoopgen", ["x", "x_0", "x_1", "x_", "p_x", "p"], ["p", "p_x"], "p_impact")
@example("rate", ["margin", "last", "outcome", "zero", "job", "event"], ["p", "q"], "p_impact")
@pytest.mark.slow
def test_whatever_the_names_the_results_are_the_same(
    tame: ResultArrays,
    tmp_path_factory: pytest.TempPathFactory,
    scene: str,
    parameters: Sequence[str],
    surfaces: Sequence[str],
    law: str,
) -> None:
    """Results are equal to the last bit, in C and in NumPy."""
    named = plank(scene, parameters, *surfaces, law)
    refusal = ""
    try:
        build(named)
    except ValueError as error:
        refusal = str(error)
    if refusal:
        assert re.fullmatch(rf"scene {scene}: kernel '\w+': 2 have this name", refusal)
        return
    for results in made(named, tmp_path_factory.mktemp("named")).run():
        assert_same(results, tame)


@pytest.mark.slow
def test_names_that_sort_the_other_way_give_the_same_bits(
    tame: ResultArrays, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """Parameters whose names are in the opposite order, and ends with the names of ours."""
    order = {name: f"s{k}" for k, name in enumerate(sorted(PARAMETERS, reverse=True))}
    identifiers = [order[name] for name in PARAMETERS]
    scene = plank("whatever", identifiers, "for", "double", "o_impact", ends=("state", "surfaces"))
    for results in made(scene, tmp_path_factory.mktemp("turned")).run():
        assert_same(results, tame)


def test_a_parameter_is_no_symbol_of_ours() -> None:
    """Even where it has the name and the assumptions of one."""
    x = ParameterSymbol("x", real=True)
    assert x != POSITION[0]
    assert x == ParameterSymbol("x", real=True)
    assert without_assumptions(ParameterSymbol("x", positive=True)) == x
    assert (x + POSITION[0]).free_symbols == {x, POSITION[0]}
    assert [variable(x), variable(POSITION[0])] == ["p_x", "x"]


@cache
def models() -> tuple[Model, ...]:
    """Return the models of scenes with all kinds of search."""
    return build(HOOP), build(TABLE)


def named_by_the_lowering() -> set[str]:
    """Return the variables that lowering to C declares beside those of the event loop."""
    kinds = {"Declare", "For", "ForLanes"}
    found: set[str] = set()
    for file in (ROOT / "hoopgen/codegen/c").glob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and ast.unparse(node.func) in kinds and node.args:
                name = node.args[0]
                if isinstance(name, ast.Constant) and isinstance(name.value, str):
                    found.add(name.value)
    return found


@pytest.mark.slow
def test_no_name_of_ours_is_one_of_a_parameter_a_printer_a_driver_or_a_language() -> None:
    """The driver in C shares its scope with the loop's variables."""
    engine, loop = (
        (ROOT / f"templates/c/{name}.h.j2").read_text(encoding="utf-8")
        for name in ("engine", "loop")
    )
    columns, _, driver = loop.partition("typedef struct {")[2].partition("} LOOP(")
    driver += engine
    ours_in_c = r"LANES\(\{\{ N \}\}_\w+\)|LANES\(column\)|LOOP\(\w+\)|\{\{ N \}\}_\w+ \*"
    kinds = rf"(?:V|M|int|unsigned|size_t|double|int32_t \*|{ours_in_c})"
    found = rf"\b{kinds} ?\*?(?:const \*?)?([a-z]\w*)\s*(?:[\[;=,]|$)"
    declared = set(re.findall(found, columns + driver, re.MULTILINE))
    declared |= named_by_the_lowering()
    declared |= {r.switch for model in models() for r in model.results if r.switch}
    shared = {"most_contacts", "time_limit", "claims", "tightening"}
    assert {"rows", "packed", "active", "row", "done", "fresh", "shots", *shared} <= declared
    for model in models():
        ours: set[str] = set()
        for kernel in model.kernels:
            ours |= {s.name for s in kernel.arguments if not isinstance(s, ParameterSymbol)}
            ours |= set(kernel.output_names)
        variables = {field.name for field in model.loop.fields}
        for nodes in model.loop.stages.values():
            variables |= set(writes(nodes)) | reads(nodes)
        ours |= variables - set(model.loop.parameters)
        assert [name for name in sorted(ours) if not identifiers.is_own(name)] == []
        assert ours & declared - shared == set()


# What is refused


def scene_with(**changed: Any) -> Scene:
    return replace(plank(), **changed)


@pytest.mark.parametrize("name", ["X", "1a", "_a", "", "a b", "a-b", "é", "a\n", "a;", 'a"', "ａ"])
def test_what_is_no_public_name_is_refused(name: str) -> None:
    """The error names the scene, the kind and the name, for every kind of name."""
    first = PARAMETERS[1:]
    for kind, build_it in {
        "scene": lambda: plank(name),
        "parameter": lambda: plank(parameters=[name, *first]),
        "surface": lambda: plank(top=name),
        "body": lambda: scene_with(bodies=(replace(plank().bodies[0], name=name),)),
        "end": lambda: plank(ends=("made", name)),
    }.items():
        with pytest.raises(ValueError, match="expected a small letter, then small") as raised:
            build_it()
        assert repr(name) in str(raised.value)
        assert kind in str(raised.value) or kind == "surface"


def test_two_things_of_one_name_are_refused() -> None:
    with pytest.raises(ValueError, match="scene plank: parameter 'a': 2 have this name"):
        plank(parameters=["a", "a", *PARAMETERS[2:]])
    with pytest.raises(ValueError, match="scene plank: surface 'top': 2 have this name"):
        plank(ground="top")
    with pytest.raises(ValueError, match="scene plank: body 'end': 2 have this name"):
        plank(top="end")


@pytest.mark.parametrize("latex", ["$x$", "x\n", "<b>", "a|b", "`", "\u202e", "x$$ <script>"])
def test_latex_that_could_end_a_formula_is_refused(latex: str) -> None:
    wild = [replace(p, latex=latex) for p in plank().parameters]
    with pytest.raises(ValueError, match=r"^scene plank: parameter 'ball': its LaTeX .* has more "):
        scene_with(parameters=tuple(wild))


def test_a_law_that_would_name_another_kernel_is_refused() -> None:
    with pytest.raises(ValueError, match="scene plank: law 'flight': expected 'impact', or a name"):
        plank(law="flight")
    face, bounce = plank().surfaces[0], plank().symbols[1]
    ball = Sphere("ball", (bounce, bounce, bounce), bounce)
    bodies = (body(face, NoSlip("impact", bounce)), body(ball, NoSlip("impact", 2 * bounce)))
    with pytest.raises(ValueError, match="scene plank: law 'impact': 2 have this name"):
        scene_with(bodies=bodies)


@pytest.mark.parametrize("name", RESERVED_NAMES)
def test_a_scene_is_not_called_what_its_files_include(name: str) -> None:
    with pytest.raises(ValueError, match=rf"^scene '{name}': not one of p, environment, exact, "):
        plank(name)


def test_a_surface_whose_kernel_would_have_the_name_of_another_is_refused() -> None:
    """A surface `own` has a margin; the loop has a decision of that name."""
    with pytest.raises(ValueError, match=r"^scene plank: kernel 'own_margin': 2 "):
        build(plank(top="own"))


# Texts

TEXTS = st.text(st.characters(), max_size=12)
ATTACKS = [
    '"""\nimport os\n"""',
    "*/ #error here /*",
    "*\\\n/ #error here",
    "*??/\n/ #error",
    "</script><script>alert(1)",
    "\\",
    '"',
    "\\N{DASH} \\x \\u12",
    "{{ 7 * 7 }} {% raw %}",
    "a | b $x$ `c` [d](e) <b> _f_ *g*",
    "\u202e\u2028\x00\ud800\x85\x0c",
    "// ??/",
    "<!-- -->",
    "%s {0} {name}",
]


@cache
def plank_model() -> Model:
    return build(plank())


def rendered(texts: Sequence[str], monkeypatch: pytest.MonkeyPatch) -> dict[str, str]:
    """Render the plank with those texts in all places, in turn; nothing is derived again."""
    model, text = plank_model(), cycle(texts)
    changed = [replace(k, summary=next(text), equation=next(text)) for k in model.kernels]
    parameters = [
        replace(p, unit=one, summary=one)
        for p, one in zip(model.scene.parameters, cycle(texts), strict=False)
    ]
    scene = replace(model.scene, parameters=tuple(parameters))

    class Texts(Model):
        kernels = property(lambda _: tuple(changed))  # type: ignore[assignment]

    given = {name: getattr(model, name) for name in model.__dataclass_fields__}
    with monkeypatch.context() as patch:
        patch.setattr(render, "build", lambda _: Texts(**given | {"scene": scene}))
        return render.render_scene(scene, page=False)


def same_but_for_texts(left: str, right: str) -> None:
    """Check that two Python modules are the same but for docstrings and strings."""

    class Blank(ast.NodeTransformer):
        def visit_Constant(self, node: ast.Constant) -> ast.Constant:
            return ast.Constant("") if isinstance(node.value, str) else node

    trees = [ast.dump(Blank().visit(ast.parse(source))) for source in (left, right)]
    assert trees[0] == trees[1]


def code(text: str) -> str:
    """Return C or JavaScript without its comments."""
    return re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)


def check_texts(texts: Sequence[str], monkeypatch: pytest.MonkeyPatch) -> dict[str, str]:
    plainly, files = rendered(["a size"], monkeypatch), rendered(texts, monkeypatch)
    same_but_for_texts(files["numpy/plank.py"], plainly["numpy/plank.py"])
    scope: dict[str, Any] = {"__name__": "plank"}
    exec(compile(files["numpy/plank.py"], "plank", "exec"), scope)
    found = [text for _, *both in scope["PARAMETERS"].values() for text in both]
    assert found == [text for text, _ in zip(cycle(texts), PARAMETERS, strict=False) for _ in "ab"]
    for name in (name for name in files if name.startswith(("c/", "js/"))):
        assert code(files[name]) == code(plainly[name]), name
        # What no regular expression sees: trigraphs, spliced lines, tags of the page around it.
        comments = re.findall(r"/\*.*?\*/", files[name], flags=re.DOTALL)
        assert not [c for c in comments if re.search(r"\\|\?\?/|/\*.*/\*|</|<!", c, re.DOTALL)]
    for source in files.values():
        source.encode()  # no half of a surrogate pair
    return files


@pytest.mark.slow
@settings(max_examples=trials(3), deadline=None, derandomize=True, database=None)
@given(texts=st.lists(TEXTS, min_size=6, max_size=40))
def test_no_text_becomes_code(texts: list[str]) -> None:
    with pytest.MonkeyPatch.context() as patch:
        check_texts(texts, patch)


@needs_compiler
@pytest.mark.slow
def test_no_attack_becomes_code(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The texts are harmless to Python, JavaScript, and a compiler that warns of odd comments."""
    files = check_texts(ATTACKS, monkeypatch)
    for name, source in files.items():
        (tmp_path / Path(name).name).write_text(source, encoding="utf-8")
    flags = ("-std=c11", "-fsyntax-only", "-DPLANK_WIDEST=1")
    compiles(*FLAGS, *WARNINGS, *flags, tmp_path / "plank.c")


@pytest.mark.slow
def test_a_page_has_texts_in_their_places(monkeypatch: pytest.MonkeyPatch) -> None:
    """One row a parameter, with as many cells as its head."""
    for text in ("\n".join(ATTACKS[:7]), "\n".join(ATTACKS[7:])):
        model = plank_model()
        parameters = tuple(replace(p, unit=text, summary=text) for p in model.scene.parameters)
        scene = replace(model.scene, parameters=parameters, axes=text, remarks=text)
        monkeypatch.setattr(render, "build", lambda own: replace(plank_model(), scene=own))
        page = render.render_scene(scene)["derivation_plank.md"]
        rows = [line for line in page.splitlines() if re.match(r"\| \$[^$]*\$ \| `p?", line)]
        own = [row for row in rows if any(f"`{p.name}`" in row for p in parameters)]
        assert len(own) == len(parameters)
        assert {len(re.findall(r"(?<!\\)\|", row)) for row in own} == {6}
        assert page.count(identifiers.markdown(text)) == 2 * len(parameters) + 2


@pytest.mark.parametrize("text", ATTACKS, ids=repr)
def test_markdown_shows_a_text_as_it_is(text: str) -> None:
    """Every mark stands behind a backslash, in one line."""
    shown = identifiers.markdown(text)
    assert "\n" not in shown
    bare = re.sub(r"\\[\\`*_{}\[\]<>#|~$&]", "", shown)
    assert not set(bare) & set("\\`*_{}[]<>#|~$&")
    assert re.sub(r"\\(.)", r"\1", shown) == identifiers.in_line(text)
